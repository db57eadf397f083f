"""Russian texts for the controls of `formats.families.wrapped`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save the whole configuration of the card (all I-variables, the answers to LIST COMP"
    " DEF, LIST COMP, LIST BLCOMP DEF, LIST BLCOMP of every motor). Write down I51,"
    " I{address}85 and I{address}86.": (
        "Сохраните всю конфигурацию карты (все переменные I, ответы на LIST COMP DEF, LIST"
        " COMP, LIST BLCOMP DEF, LIST BLCOMP каждого двигателя). Запишите I51, I{address}85 и"
        " I{address}86."
    ),
    "Check the counts": "Проверить импульсы",
    "Everything here is worked out with {counts} counts per {unit} of axis {name} (motor"
    " #{address}). Move the axis by a known way and compare the motor's own position (the"
    " command P with #{address} addressed shows it): that many counts per {unit}, rising in"
    " + (negative: falling in +). Motor zero must be {reference} {unit}. If not, load"
    " nothing: correct counts_per_unit or reference in the job and run again.": (
        "Здесь всё рассчитано на {counts} импульсов на {unit} оси {name} (двигатель"
        " #{address}). Переместите ось на известное расстояние и сравните собственную позицию"
        " двигателя (её показывает команда P при адресованном #{address}): столько импульсов на"
        " {unit}, с ростом в + (минус: с убылью в +). Нуль двигателя должен быть в {reference}"
        " {unit}. Если нет, ничего не загружайте: исправьте counts_per_unit или reference в"
        " задании и выполните расчёт снова."
    ),
    "Room for the tables": "Место для таблиц",
    "Home all motors, then I51=0: no table is active from here on; I{address}86 still is."
    " Delete from the lowest motor number up, every motor that has one: DELETE BLCOMP and"
    " DELETE COMP with this motor addressed; and what exists of GATHER, TBUF, ROTARY,"
    " LOOKAHEAD and TCOMP. Anything left makes the card answer ERR003. Tables of other motors"
    " that the script below does not hold are gone then: define them again from the highest"
    " motor down, before the script where their number is higher.": (
        "Выведите все двигатели в опорную позицию, затем I51=0: с этого момента таблицы не"
        " действуют; I{address}86 ещё действует. Удалите, начиная с наименьшего номера"
        " двигателя, у каждого, где есть: DELETE BLCOMP и DELETE COMP при этом адресованном"
        " двигателе; и то, что есть из GATHER, TBUF, ROTARY, LOOKAHEAD и TCOMP. Если что-то"
        " осталось, карта отвечает ERR003. Таблицы других двигателей, которых нет в скрипте"
        " ниже, при этом исчезают: определите их заново, начиная с наибольшего номера"
        " двигателя, до скрипта, если их номер больше."
    ),
    "Load the script": "Загрузить скрипт",
    "Send from tables/, in this order: {file_1}. A line SAVE in them would keep what is not"
    " checked yet: leave it out until the sign was checked. Motor #{address}, {tables}:"
    " {points} entries, every {spacing} {unit}, length {length} counts. An error other than"
    " ERR003 may mean that the memory of the card is full: fewer points (a wider spacing)"
    " help.": (
        "Отправьте из tables/ в этом порядке: {file_1}. Строка SAVE в них закрепила бы ещё не"
        " проверенное: пропустите её, пока знак не проверен. Двигатель #{address}, {tables}:"
        " точек {points}, через {spacing} {unit}, длина {length} импульсов. Ошибка кроме ERR003"
        " может означать, что память карты заполнена: помогает меньше точек (больший шаг)."
    ),
    "Backlash": "Люфт",
    "I{address}86 = {constant} (1/16 count: {backlash} {unit} at motor zero). I{address}85 ="
    " {rate} (1/16 count per background cycle): with 0 no backlash is taken up. A rate that"
    " is too high jerks, one too low lags.": (
        "I{address}86 = {constant} (1/16 импульса: {backlash} {unit} в нуле двигателя)."
        " I{address}85 = {rate} (1/16 импульса за фоновый цикл): при 0 люфт не выбирается."
        " Слишком большая скорость даёт толчки, слишком малая отстаёт."
    ),
    "Keep the gap": "Оставить промежуток свободным",
    "Axis {name}: {gap}.": "Ось {name}: {gap}.",
    "Before SAVE and before production: axis {name} from {check_from} to {check_to} {unit},"
    " coming from below, once with I51=0 and once with I51=1 (send it by hand). With the"
    " tables on the way must change by {check_change}. Does it change the other way, the"
    " sign of counts_per_unit is wrong: I51=0, correct the job and run again. Then come from"
    " above with I51=1: the axis stands lower by the backlash of the card.": (
        "До SAVE и до работы: ось {name} из {check_from} в {check_to} {unit}, с подходом снизу,"
        " один раз при I51=0 и один раз при I51=1 (отправить вручную). С включёнными таблицами"
        " путь должен измениться на {check_change}. Если он меняется наоборот, знак"
        " counts_per_unit неверен: I51=0, исправьте задание и выполните расчёт снова. Затем"
        " подойдите сверху при I51=1: ось стоит ниже на люфт с карты."
    ),
    "Keep it": "Закрепить",
    "I51=1, define again what was deleted of GATHER, TBUF, ROTARY and LOOKAHEAD, then SAVE."
    " Until SAVE everything here is lost at the next reset ($$$): that is also the quick way"
    " back. A table is right only as long as homing finds the same motor zero: home after"
    " every restart before anything is measured.": (
        "I51=1, определите заново то, что было удалено из GATHER, TBUF, ROTARY и LOOKAHEAD,"
        " затем SAVE. До SAVE всё здесь теряется при следующем сбросе ($$$): это и быстрый путь"
        " назад. Таблица верна, только пока выход в опорную позицию находит тот же нуль"
        " двигателя: выходите в неё после каждого запуска до любого измерения."
    ),
    "Ask the card again (LIST COMP DEF and LIST COMP, LIST BLCOMP DEF and LIST BLCOMP with"
    " #{address} addressed, I51, I{address}85, I{address}86), write the answers as a script"
    " and compare them with the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`.": (
        "Снова опросите карту (LIST COMP DEF и LIST COMP, LIST BLCOMP DEF и LIST BLCOMP при"
        " адресованном #{address}, I51, I{address}85, I{address}86), запишите ответы как скрипт"
        " и сравните их с планом: `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "Reset ($$$) without SAVE; after SAVE delete as above, send the saved tables and set"
    " I51, I{address}85 and I{address}86 as written down.": (
        "Сброс ($$$) без SAVE; после SAVE удалите, как выше, отправьте сохранённые таблицы и"
        " задайте I51, I{address}85 и I{address}86 как записано."
    ),
    "Axis {name} is programmed in diameter: the table counts in the motor's own counts, so"
    " in radius, like the laser. Programs and displays show twice as much": (
        "Ось {name} программируется в диаметре: таблица считает в импульсах двигателя, то есть"
        " в радиусе, как лазер. Программы и индикация показывают вдвое больше"
    ),
    "define a table between the motors by hand, at a motor that has no table of its own (#k"
    " DEFINE COMP entries,#source D,#target,length; k the free motor, source the one of"
    " {input}, target the one of {output}; in 1/16 count of {output}, length in counts of"
    " {input}): a straight line that adds {squareness} rad times the way of {input}{shift}": (
        "определите вручную таблицу между двигателями, у двигателя без своей таблицы (#k DEFINE"
        " COMP entries,#source D,#target,length; k — свободный двигатель, source — двигатель"
        " {input}, target — двигатель {output}; в 1/16 импульса {output}, length в импульсах"
        " {input}): прямая, которая прибавляет {squareness} рад, умноженные на путь"
        " {input}{shift}"
    ),
    "the length is one turn, and there is no gap": "длина равна одному обороту, промежутка нет",
    "what lies beyond {low} {unit} and below {high} {unit} is the gap that must stay unused"
    " (the table repeats after {turn} {unit}): keep the software limits inside": (
        "то, что выше {low} {unit} и ниже {high} {unit}, — промежуток, который должен"
        " оставаться неиспользуемым (таблица повторяется через {turn} {unit}): держите"
        " программные ограничители внутри"
    ),
    "0 or as it is (there is no backlash)": "0 или как есть (люфта нет)",
    "Ask the card again (LIST COMP DEF, LIST COMP, LIST BLCOMP with #{address} addressed,"
    " I51, I{address}85, I{address}86) and compare the answers with the plan; the variable"
    " Mxx69 shows what the tables add.": (
        "Снова опросите карту (LIST COMP DEF, LIST COMP, LIST BLCOMP при адресованном"
        " #{address}, I51, I{address}85, I{address}86) и сравните ответы с планом; переменная"
        " Mxx69 показывает, что прибавляют таблицы."
    ),
    "I51 must be 1: it switches all tables on.": "I51 должно быть 1: оно включает все таблицы.",
    "After a reset only what SAVE has kept is there: LIST COMP DEF with #{address} addressed"
    " shows it.": (
        "После сброса есть только то, что закрепил SAVE: это показывает LIST COMP DEF при"
        " адресованном #{address}."
    ),
    "ERR003 while the script was sent means that a table was not defined.": (
        "ERR003 при отправке скрипта означает, что таблица не была определена."
    ),
    "Entries are added to the position in counts: does the motor #{address} count with the"
    " axis or against it (sign of counts_per_unit)?": (
        "Записи прибавляются к позиции в импульсах: считает ли двигатель #{address} вместе с"
        " осью или против неё (знак counts_per_unit)?"
    ),
    "Entries are 1/16 counts of motor #{address}: counts per {unit} of the motor, whatever"
    " its scale factor is (counts_per_unit).": (
        "Записи — 1/16 импульса двигателя #{address}: импульсы на {unit} двигателя, каким бы ни"
        " был его масштабный множитель (counts_per_unit)."
    ),
    "Positions count from the motor zero of the last homing: it must be {reference} {unit},"
    " as for the measurement.": (
        "Позиции считаются от нуля двигателя последнего выхода в опорную позицию: он должен"
        " быть в {reference} {unit}, как для измерения."
    ),
    "DEFINE COMP: the first entry stands one spacing behind motor zero, and the spacing is"
    " the length divided by the entries.": (
        "DEFINE COMP: первая запись находится на один шаг дальше нуля двигателя, а шаг — это"
        " длина, делённая на число записей."
    ),
    "Entries run in the direction in which the motor counts; what lies below motor zero is"
    " the upper end of the table.": (
        "Записи идут в направлении счёта двигателя; то, что ниже нуля двигателя, — верхний"
        " конец таблицы."
    ),
    "DEFINE COMP names the motors: #{address} by itself as source and as target.": (
        "DEFINE COMP называет двигатели: только #{address} как источник и как цель."
    ),
    "COMP is active in both directions; BLCOMP and I{address}86 only while the last command"
    " went in the negative counting direction.": (
        "COMP действует в обоих направлениях; BLCOMP и I{address}86 действуют, только пока"
        " последняя команда шла в отрицательном направлении счёта."
    ),
    "I{address}86, in 1/16 counts, with BLCOMP added to it; I{address}85 = 0 takes up no"
    " backlash at all.": (
        "I{address}86, в 1/16 импульса, с прибавленным BLCOMP; при I{address}85 = 0 люфт не"
        " выбирается вовсе."
    ),
    "I{address}87 is the hysteresis of the reversal.": "I{address}87 — гистерезис реверса.",
    "DEFINE COMP: number of entries and length. Outside 0 to the length the position rolls"
    " over into the table, so it must be longer than the travel.": (
        "DEFINE COMP: число записей и длина. Вне 0 … длина позиция снова попадает в таблицу,"
        " поэтому она должна быть длиннее хода."
    ),
    "Delta Tau PMAC, Turbo PMAC (UMAC, Geo Brick), leadscrew and backlash tables (DEFINE"
    " COMP, DEFINE BLCOMP)": (
        "Delta Tau PMAC, Turbo PMAC (UMAC, Geo Brick), таблицы шага винта и люфта (DEFINE COMP,"
        " DEFINE BLCOMP)"
    ),
    "P10 for the unit; how fast suits a machine no manual says: 32 is 2 counts per"
    " background cycle": (
        "P10 — единица; какая скорость подходит станку, руководства не говорят: 32 — это 2"
        " отсчёта за фоновый цикл"
    ),
    "in no script, and no table of backlash needs it": (
        "ни в одном сценарии, и ни одной таблице люфта это не нужно"
    ),
    "in no script; a card that uses tables has it on": (
        "ни в одном сценарии; плата, использующая таблицы, его включила"
    ),
}
