"""Russian texts for the controls of `formats.families.columns`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save all machine parameters and every .COM and .CMA file of the control. Write down"
    " MP710.{bit}, MP720.{bit}, MP730 and which .CMA line is active.": (
        "Сохраните все машинные параметры и каждый файл .COM и .CMA УЧПУ. Запишите MP710.{bit},"
        " MP720.{bit}, MP730 и активную строку .CMA."
    ),
    "Enter the table": "Ввести таблицу",
    "Axis {address}: {table}. {load} Typed in: datum at the first point, column"
    " {number}=F(). The values are {table_values}s. Leave the columns of other axes alone."
    " Whether the first value has to be 0 is not known.": (
        "Ось {address}: {table}. {load} При вводе: начало отсчёта в первой точке, столбец"
        " {number}=F(). Значения имеют смысл {table_values} (опция table_values). Столбцы"
        " других осей не трогать. Должно ли первое значение быть 0, неизвестно."
    ),
    "Reach beyond the travel": "Выйти за пределы хода",
    "What the control does outside the table is unknown: the table should reach one spacing"
    " beyond the travel of {name} on each side, with real values at both ends (job: table"
    " start and end).": (
        "Что действует вне таблицы, неизвестно: она должна выходить за ход {name} на один шаг"
        " точек с каждой стороны, с настоящими значениями на обоих концах (задание: начало и"
        " конец таблицы)."
    ),
    "Activate the line": "Активировать строку",
    "Where a table is used: the active line of the .CMA must name the .COM file in the"
    " column of axis {address} (soft key or PLC module 9095). All axes share one active"
    " line: change only this cell.": (
        "Где таблица используется: активная строка .CMA должна называть файл .COM в столбце оси"
        " {address} (softkey или модуль PLC 9095). У всех осей одна активная строка: меняйте"
        " только эту ячейку."
    ),
    "Set the parameters": "Задать параметры",
    "MP710.{bit} = {backlash} {backlash_unit}, MP720.{bit} = {linear} mm/m, MP730 bit {bit}"
    " = {nonlinear} (leave the other bits as they are). With the bit at 1 and no active .CMA"
    " line, old tables of the machine's builder may come alive.": (
        "MP710.{bit} = {backlash} {backlash_unit}, MP720.{bit} = {linear} мм/м, MP730 бит {bit}"
        " = {nonlinear} (другие биты оставить как есть). При бите 1 и без активной строки .CMA"
        " могут ожить старые таблицы изготовителя станка."
    ),
    "Switch the control off and on. {referencing} Nominal values may jump slightly when a"
    " line is selected.": (
        "Выключите и включите УЧПУ. {referencing} Заданные значения могут немного скакнуть при"
        " выборе строки."
    ),
    "The sign of a table is not confirmed; that of MP720 is. Before the full test measure two"
    " of the check positions (listed with the axis on the card) once as the control is now,"
    " and once without compensation (table: MP730 bit {bit} and MP720.{bit} = 0; line:"
    " MP720.{bit} = 0; MP710.{bit} = 0): the compensation must add what is listed there. If a"
    " table does the opposite, set the option table_values to the other choice and run again.": (
        "Знак таблицы не подтверждён; знак MP720 подтверждён. До полной проверки измерьте две"
        " из контрольных позиций (их таблица — у оси) как сейчас и ещё раз без компенсации"
        " (таблица: MP730 бит {bit} и MP720.{bit} = 0; прямая: MP720.{bit} = 0; MP710.{bit} ="
        " 0): компенсация должна прибавлять то, что там указано. Если таблица делает обратное,"
        " задайте другое значение опции table_values и выполните расчёт снова."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive MP710 moves on in the direction of"
    " the new motion.": (
        "Установите индикатор на ноль при подходе в {reference_return}, затем вернитесь с"
        " другой стороны: оставшаяся разница должна быть малой. Положительное значение MP710"
        " продолжает ход в направлении нового движения."
    ),
    "Save the .COM and .CMA files and the list of machine parameters again and compare them with"
    " the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`. What was typed in from a"
    " sheet: write the values on the display into a copy of the sheet.": (
        "Снова сохраните файлы .COM и .CMA и список машинных параметров и сравните их с планом:"
        " `compwright compare JOB_FOLDER --loaded READ_BACK`. Что было введено по листу: запишите"
        " значения с экрана в копию листа."
    ),
    "Load the saved .COM and .CMA files and set MP710.{bit}, MP720.{bit} and the bit of"
    " MP730 as written down.": (
        "Загрузите сохранённые файлы .COM и .CMA и задайте MP710.{bit}, MP720.{bit} и бит MP730"
        " как записано."
    ),
    "MP710.{bit} = {backlash} {backlash_unit}": "MP710.{bit} = {backlash} {backlash_unit}",
    "Make a backup of the control with its configuration data and every .COM and .CMA file."
    " Write down backLash and linearCompValue of axis {address} and which line of config.cma"
    " is active.": (
        "Сделайте резервную копию УЧПУ с данными конфигурации и каждым файлом .COM и .CMA."
        " Запишите backLash и linearCompValue оси {address} и активную строку config.cma."
    ),
    "Axis {address}: {table}. {load} Typed in: AXISPOS and column {address}. The values are"
    " {table_values}s. Leave the columns of other axes alone.": (
        "Ось {address}: {table}. {load} При вводе: AXISPOS и столбец {address}. Значения имеют"
        " смысл {table_values} (опция table_values). Столбцы других осей не трогать."
    ),
    "What the control does outside the table is unknown: the table should reach one spacing"
    " beyond the travel of {name} on each side (job: table start and end).": (
        "Что действует вне таблицы, неизвестно: она должна выходить за ход {name} на один шаг"
        " точек с каждой стороны (задание: начало и конец таблицы)."
    ),
    "In config.cma exactly one line has * in ACTIVE: its column {address} must name the .COM"
    " file. All axes share this line: change only this cell.": (
        "В config.cma ровно одна строка имеет * в ACTIVE: её столбец {address} должен называть"
        " файл .COM. У всех осей эта строка общая: меняйте только эту ячейку."
    ),
    "CfgAxisComp of axis {address}: backLash (401802) = {backlash} {backlash_unit},"
    " linearCompValue = {linear} mm/m; choose the nonlinear compensation.": (
        "CfgAxisComp оси {address}: backLash (401802) = {backlash} {backlash_unit},"
        " linearCompValue = {linear} мм/м; выберите нелинейную компенсацию."
    ),
    "Restart the control. {referencing} The table is active in open loop too and is taken"
    " over when the loop closes.": (
        "Перезапустите УЧПУ. {referencing} Таблица действует и при разомкнутом контуре и"
        " принимается, когда контур замыкается."
    ),
    "The sign of the table is not confirmed. Before the full test measure two of the check"
    " positions (listed with the axis on the card) once as the control is now, and once"
    " without compensation (no * in ACTIVE, backLash 0): the compensation must add what is"
    " listed there. If it is the opposite, set the option table_values to the other choice"
    " and run again.": (
        "Знак таблицы не подтверждён. До полной проверки измерьте две из контрольных позиций"
        " (их таблица — у оси) как сейчас и ещё раз без компенсации (нет * в ACTIVE, backLash"
        " 0): компенсация должна прибавлять то, что там указано. Если наоборот, задайте другое"
        " значение опции table_values и выполните расчёт снова."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive backLash moves on in the direction"
    " of the new motion. The control adds it also where only the table makes the axis turn"
    " back.": (
        "Установите индикатор на ноль при подходе в {reference_return}, затем вернитесь с"
        " другой стороны: оставшаяся разница должна быть малой. Положительное значение backLash"
        " продолжает ход в направлении нового движения. УЧПУ прибавляет его и там, где ось"
        " поворачивает назад только из-за таблицы."
    ),
    "Save the .COM and .CMA files again and compare them with the plan: `compwright compare"
    " JOB_FOLDER --loaded READ_BACK`. What was typed in from a sheet: write the values on the"
    " display into a copy of the sheet.": (
        "Снова сохраните файлы .COM и .CMA и сравните их с планом: `compwright compare JOB_FOLDER"
        " --loaded READ_BACK`. Что было введено по листу: запишите значения с экрана в копию"
        " листа."
    ),
    "Load the saved .COM and .CMA files and set backLash and linearCompValue of axis"
    " {address} as written down.": (
        "Загрузите сохранённые файлы .COM и .CMA и задайте backLash и linearCompValue оси"
        " {address} как записано."
    ),
    "CfgAxisComp of axis {address}: backLash (401802) = {backlash} {backlash_unit}": (
        "CfgAxisComp оси {address}: backLash (401802) = {backlash} {backlash_unit}"
    ),
    "The sign is unconfirmed: check it with a square or a dial gauge, on and off, before"
    " production.": (
        "Знак не подтверждён: проверьте его до работы угольником или индикатором, с"
        " компенсацией и без."
    ),
    "{file}, column {column}": "{file}, столбец {column}",
    "{error} is in {where}, added to what was there: {values} (values are {form}s). Load"
    " that file; no other column of it changes. {selected}{check}": (
        "{error} — в {where}, прибавлено к тому, что там было: {values} (значения имеют смысл"
        " {form}). Загрузите этот файл; другие столбцы в нём не меняются. {selected}{check}"
    ),
    "the table (.COM) of {input}, column of {output}": "таблица (.COM) {input}, столбец {output}",
    "the table (.COM) that the active line of the .CMA names for the motion of {input} (a"
    " new one, where it names none), column of {output}": (
        "таблица (.COM), которую активная строка .CMA называет для движения {input}"
        " (новая, если она не называет никакой), столбец {output}"
    ),
    "{output} over {input}: {where}": "{output} по {input}: {where}",
    "{value} {unit} at {position}": "{value} {unit} в {position}",
    "(see the axis list of the machine)": "(см. список осей станка)",
    "no table": "таблицы нет",
    ", every {spacing} {unit}": ", через {spacing} {unit}",
    "{points} points from {start} to {end} {unit}{every}": (
        "точек {points}, от {start} до {end} {unit}{every}"
    ),
    "Type the sheet {file} into the .COM file that the active line of the .CMA names for the"
    " motion of axis {address}; where it names none, into a new one. Never into one that it"
    " names for another axis.": (
        "Введите лист {file} в файл .COM, который активная строка .CMA называет для движения"
        " оси {address}; если она не называет никакого, в новый. Никогда не в тот, который она"
        " называет для другой оси."
    ),
    " {file} holds the parameters that are in no file of yours.": (
        " {file} содержит параметры, которых нет ни в одном вашем файле."
    ),
    "Load your own .COM file of tables/: it holds the table.{rest}": (
        "Загрузите свой файл .COM из tables/: он содержит таблицу.{rest}"
    ),
    "Read back what is in the control and compare it with the plan (`compwright compare"
    " JOB_FOLDER --loaded READ_BACK`): it shows value by value what this test cannot tell.": (
        "Считайте обратно то, что в УЧПУ, и сравните с планом (`compwright compare JOB_FOLDER"
        " --loaded READ_BACK`): это показывает значение за значением то, чего эта проверка"
        " сказать не может."
    ),
    "The bit of axis {address} in MP730 must be 1, and the active line of the .CMA must name"
    " its .COM: until then no table is active.": (
        "Бит оси {address} в MP730 должен быть 1, и активная строка .CMA должна называть её"
        " .COM: до этого ничего не действует."
    ),
    "With the bit at 1 and no .CMA, old tables of the machine's builder (code 105296) act in"
    " their place.": (
        "При бите 1 и без .CMA вместо них действуют старые таблицы изготовителя станка (код"
        " 105296)."
    ),
    "The axis must have passed its reference marks.": "Ось должна пройти свои опорные метки.",
    "No manual states the sign of a table's values: compare two positions with the bit of"
    " MP730 at 1 and at 0; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Ни одно руководство не называет знак значений таблицы: сравните две позиции с битом"
        " MP730 равным 1 и 0; если расстояние меняется не в ту сторону, выполните расчёт снова"
        " с другим table_values."
    ),
    "Where the axis is corrected by MP720 alone: positive means that the table travels too far.": (
        "Где ось корректируется только через MP720: плюс означает, что стол проходит слишком"
        " далеко."
    ),
    "The .COM counts in mm or in inch, and MP720 in mm/m.": (
        ".COM считает в мм или в дюймах, а MP720 в мм/м."
    ),
    "With the bit of MP730 at 1 MP720 has no effect; a column for this axis in another axis'"
    " .COM is active in addition to its own table.": (
        "При бите MP730, равном 1, MP720 не действует; столбец для этой оси в .COM другой оси"
        " действует в дополнение к её собственному."
    ),
    "DATUM and spacing of the .COM: point k stands at DATUM + k times the spacing, from the"
    " machine datum.": ("DATUM и шаг .COM: точка k находится в DATUM + k шагов, от нуля станка."),
    "The points run in + from the DATUM: were they entered from the other end?": (
        "Точки идут от DATUM в +: не введены ли они с другого конца?"
    ),
    "The column of the .CMA names the axis that moves, the column n=F() inside the .COM the"
    " axis that is corrected: both must be {address}.": (
        "Столбец .CMA называет ось, которая движется, столбец n=F() в .COM — ось, которая"
        " корректируется: обе должны быть {address}."
    ),
    "A table has no direction here: what is active in one direction only is MP710 (or MP750"
    " within the position loop).": (
        "Таблица здесь не имеет направления: только в одном направлении действует MP710 (или"
        " MP750 в контуре положения)."
    ),
    "MP710 of axis {address}, fed in at every reversal: positive where the encoder runs"
    " ahead of the table.": (
        "MP710 оси {address}, подаётся при каждом реверсе: плюс, где датчик опережает стол."
    ),
    "Are all rows filled, from one spacing below the travel to one above? What the control"
    " does outside the table is unknown.": (
        "Заполнены ли все строки, от одного шага ниже хода до одного выше? Что действует вне"
        " таблицы, неизвестно."
    ),
    "At most 256 points in one .COM: a longer one is refused when the line is selected"
    " (module 9095).": (
        "Не более 256 точек в одном .COM: более длинный отвергается при выборе строки (модуль"
        " 9095)."
    ),
    "config.cma: one line has * in ACTIVE, and its column {address} must name the .COM file.": (
        "config.cma: одна строка имеет * в ACTIVE, и её столбец {address} должен называть файл"
        " .COM."
    ),
    "CfgAxisComp of axis {address}: the nonlinear compensation must be chosen.": (
        "CfgAxisComp оси {address}: должна быть выбрана нелинейная компенсация."
    ),
    "The table is taken over when the position loop closes; before the reference marks it"
    " has no positions.": (
        "Таблица принимается, когда контур положения замыкается; до опорных меток у неё нет"
        " позиций."
    ),
    "No manual states the sign of a table's values: compare two positions with and without"
    " the * in ACTIVE; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Ни одно руководство не называет знак значений таблицы: сравните две позиции с * в"
        " ACTIVE и без; если расстояние меняется не в ту сторону, выполните расчёт снова с"
        " другим table_values."
    ),
    "The .COM counts in mm or in inch, as its first line says.": (
        ".COM считает в мм или в дюймах, как говорит его первая строка."
    ),
    "linearCompValue of CfgAxisComp must be 0: otherwise it may be active in addition to the"
    " table.": ("linearCompValue в CfgAxisComp рядом с таблицей: 0, иначе может действовать тоже."),
    "The column AXISPOS: positions from the machine datum (MP_refPosition).": (
        "Столбец AXISPOS: позиции от нуля станка (MP_refPosition)."
    ),
    "AXISPOS must ascend, with the value of each position next to it: were the points entered"
    " from the other end?": (
        "AXISPOS должен возрастать, со значением каждой позиции рядом: не введены ли точки с"
        " другого конца?"
    ),
    "The column of config.cma names the axis that moves, the column inside the .COM the axis"
    " that is corrected: both must be {address}.": (
        "Столбец config.cma называет ось, которая движется, столбец в .COM — ось, которая"
        " корректируется: обе должны быть {address}."
    ),
    "The column BACKLASH holds the values for travel in -, the column {address} those for"
    " travel in +.": (
        "Столбец BACKLASH содержит значения для хода в -, столбец {address} — для хода в +."
    ),
    "backLash (401802) of axis {address}: positive where the encoder runs ahead, also at a"
    " reversal that only the table causes.": (
        "backLash (401802) оси {address}: плюс, где датчик опережает, также при реверсе,"
        " который вызывает только таблица."
    ),
    "Where the column BACKLASH holds the reversal, backLash must not hold it again.": (
        "Где столбец BACKLASH содержит реверс, backLash не должен содержать его ещё раз."
    ),
    "At most 256 points.": "Не более 256 точек.",
    "axis {address}": "ось {address}",
    "axis {address}, measuring system {system}": "ось {address}, измерительная система {system}",
    "axis {name}: curve for travel in -": "ось {name}: кривая для хода в -",
    "none: no table of the axis with a column BACKLASH was given": (
        "нет: таблица оси со столбцом BACKLASH не дана"
    ),
    "axis {name}: outside the table": "ось {name}: вне таблицы",
    "the end values hold; let the table reach one spacing beyond the travel on each side": (
        "сохраняются крайние значения; пусть таблица выходит за ход на один шаг точек с каждой"
        " стороны"
    ),
    "an entry sheet has no place for it": "в листе ввода для этого нет места",
    "option or its default": "опция или её значение по умолчанию",
    "HEIDENHAIN iTNC 530 (TNC 407 to 430 with .COM tables), axis error compensation with"
    " backlash (MP710, MP720, MP730)": (
        "HEIDENHAIN iTNC 530 (TNC 407–430 с таблицами .COM), компенсация погрешностей оси с"
        " компенсацией люфта (MP710, MP720, MP730)"
    ),
    "HEIDENHAIN NCK controls (MANUALplus 620; TNC 320, 620, 640), axis error compensation"
    " with backlash (CfgAxisComp)": (
        "УЧПУ HEIDENHAIN NCK (MANUALplus 620; TNC 320, 620, 640), компенсация погрешностей оси"
        " с компенсацией люфта (CfgAxisComp)"
    ),
    "H2 draws the error": "в H2 изображена погрешность",
    "H6 speaks of compensation values; the older controls draw the error": (
        "в H6 речь о значениях компенсации; у старых УЧПУ изображена погрешность"
    ),
    "no manual says what the control does outside the table; straight lines between the"
    " points: H8": (
        "ни одно руководство не говорит, что делает УЧПУ вне таблицы; прямые между точками: H8"
    ),
    "no manual says what the control does outside the table; straight lines between the"
    " points: inferred from the older controls": (
        "ни одно руководство не говорит, что делает УЧПУ вне таблицы; прямые между точками:"
        " выведено по старым УЧПУ"
    ),
    "free": "свободно (free)",
    "table": "таблица (table)",
    "second_curve": "вторая кривая (second_curve)",
    "nothing is added arriving in {direction}": "при подходе в {direction} ничего не прибавляется",
    "0: no table is active on it": "0: на ось не действует ни одна таблица",
    "no file contains a table of the axis": "ни в одном файле нет таблицы этой оси",
    "1: its table of zeros is active": "1: её таблица нулей действует",
    "1: its table is active": "1: её таблица действует",
    "0: its table is not active": "0: её таблица не действует",
    "a sheet is what was typed in": "лист — это то, что было введено",
    "zeros correct nothing": "нули ничего не исправляют",
    "1: {parameter} is not active": "1: {parameter} не действует",
    "0: {parameter} is active": "0: {parameter} действует",
    "in no file; {evidence}": "ни в одном файле; {evidence}",
    "{label}: its table": "{label}: её таблица",
    "active": "действует",
    "{switch} is not in the files: a table that was given counts": (
        "{switch} нет в файлах: переданная таблица учитывается"
    ),
    "{file}: moving axis": "{file}: движущаяся ось",
    "inferred from its name: no table of assignments (.CMA) was given": (
        "выведено из имени: таблица назначений (.CMA) не передана"
    ),
    "outside the tables": "вне таблиц",
    "the end values hold": "остаются концевые значения",
    "inferred from the name of the axis": "выведено из имени оси",
}
