"""Russian texts for the card and for controls of several `formats.families`, keyed by the English
texts.
"""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save first": "Сначала сохранить",
    "Power cycle": "Выключить и включить",
    "Check the sign": "Проверить знак",
    "Check the backlash": "Проверить люфт",
    "Read back": "Считать обратно",
    "The old table": "Старая таблица",
    "Axis {name} is programmed in diameter: the laser and this table count in radius."
    " Programs and displays show twice as much; if the quick check is off by a factor of"
    " two, the control counts its table in diameter": (
        "Ось {name} программируется в диаметре: лазер и эта таблица считают в радиусе."
        " Программы и индикация показывают вдвое больше; если быстрая проверка расходится"
        " вдвое, УЧПУ считает таблицу в диаметре"
    ),
    "Restart": "Перезапустить",
    "Gantry": "Портал",
    "{gantry}": "{gantry}",
    "Check what is active": "Проверить, что действует",
    "{low} to {high} {unit}": "{low} … {high} {unit}",
    "points of the table": "точки таблицы",
    "range of the table": "диапазон таблицы",
    "corrections from, to": "коррекции от, до",
    "backlash in addition to the table": "люфт в дополнение к таблице",
    "The files in tables/: {files}.": "Файлы в tables/: {files}.",
    "The job says that nothing was active.": "По заданию ничего не действовало.",
    "To go back: switch the compensation of these axes off as in the steps above (an empty"
    " table), set the backlash by the parameter in column Old of each axis, restart and"
    " reference.": (
        "Назад: выключите компенсацию этих осей, как в шагах выше (пустая таблица), задайте"
        " люфт параметром из столбца «Старое» каждой оси, перезапустите и выведите в опорную"
        " позицию."
    ),
    "Cross-axis tables: switch off what the steps above switch on, or set each of their values"
    " to 0.": (
        "Таблицы между осями: выключите то, что включают шаги выше, или задайте каждому их значению"
        " 0."
    ),
    "The untouched copies of the old files are in {folder} ({names}).": (
        "Неизменённые копии старых файлов — в {folder} ({names})."
    ),
    "Load the untouched copies in {folder} ({names}) the same way, restart and reference.": (
        "Загрузите неизменённые копии из {folder} ({names}) тем же способом, перезапустите и"
        " выведите в опорную позицию."
    ),
    "To undo: switch off as in the steps above, load {files} from {folder} (the old values"
    " of these axes and their switches; what was set by hand goes back by hand), activate,"
    " restart and reference.": (
        "Отменить: выключите, как в шагах выше, загрузите {files} из {folder} (старые значения"
        " этих осей и их переключатели; заданное вручную возвращается вручную), активируйте,"
        " перезапустите и выведите в опорную позицию."
    ),
    "If more than these axes has to go back: switch off the compensation of every axis in"
    " them (what is on is protected), load the untouched copies in {folder} ({names}) the"
    " same way, restart and reference.": (
        "Если вернуть нужно больше, чем эти оси: выключите компенсацию каждой оси в них"
        " (включённое защищено), загрузите неизменённые копии из {folder} ({names}) тем же"
        " способом, перезапустите и выведите в опорную позицию."
    ),
    "none": "нет",
    "{name} and {gantry} together": "{name} и {gantry} вместе",
    "axis {axis} has {name} {becomes} {unit} (now {was} {unit})": (
        "у оси {axis} {name} {becomes} {unit} (сейчас {was} {unit})"
    ),
    "With {file} alone {effects}.": "С одним файлом {file} {effects}.",
    "Axis {name} leads a gantry: do every step for the synchronised axis {gantry} too,"
    " before anything moves.{own} A table on the leading axis alone racks the bridge.": (
        "Ось {name} — ведущая портала: выполните каждый шаг и для синхронной оси {gantry},"
        " прежде чем что-либо движется.{own} Таблица только на ведущей оси перекашивает портал."
    ),
    "The job says that {name} is not a gantry master axis. If it is one, stop: a table on"
    " the master axis alone racks the bridge. Name its synchronised axis in the job"
    " (gantry), so that it gets the same table.": (
        "По заданию {name} — не ведущая ось портала. Если ведущая, остановитесь: таблица только"
        " на ведущей оси перекашивает портал. Назовите её синхронную ось в задании (gantry),"
        " чтобы она получила ту же таблицу."
    ),
    " It has values of its own.": " У неё свои значения.",
    "{output} over {input}: type in": "{output} по {input}: ввести",
    "{name}: scale from circles": "{name}: масштаб по окружностям",
    "{scale} Measure {name} with a laser when you can.": (
        "{scale} Измерьте {name} лазером, когда будет возможность."
    ),
    "Not corrected: {error}": "Не скорректировано: {error}",
    ", which also moves {output} as a whole by {constant} µm": (
        ", что также сдвигает {output} целиком на {constant} мкм"
    ),
    "{why}.": "{why}.",
    "(not known)": "(неизвестно)",
    "Incremental encoder: reference the axis after the power cycle; no compensation is"
    " active before that.": (
        "Инкрементный датчик: выведите ось в опорную позицию после включения; до этого"
        " компенсация не действует."
    ),
    "Absolute encoder: no reference return. Leave its adjustment alone: machine zero would"
    " be lost.": (
        "Абсолютный датчик: без выхода в опорную позицию. Его настройку не трогать: нуль станка"
        " будет потерян."
    ),
    "Distance-coded scale: move the axis over two marks after the power cycle; no"
    " compensation is active before that.": (
        "Линейка с кодированными метками: проведите ось через две метки после включения; до"
        " этого компенсация не действует."
    ),
    "your own patched {files}": "ваши файлы {files}, с изменениями",
    "Nothing yet on a machine: not the form of the files, not sign, size, places and order"
    " of the values, not the backlash. The first good verification on this one with what was"
    " read back (compwright verify --loaded) proves what it can, and writes it down in"
    " proven/.": (
        "На станке пока ничего: ни форма файлов, ни знак, величина, места и порядок значений,"
        " ни люфт. Первая успешная проверка на нём с тем, что считано обратно (compwright"
        " verify --loaded), доказывает, что может, и записывает это в proven/."
    ),
    "The files of this card belong together: go through all steps in one go. Move no axis"
    " before all files are loaded and active.": (
        "Файлы этой карты составляют одно целое: выполните все шаги подряд. Не двигайте ни"
        " одной оси, пока все файлы не загружены и не действуют."
    ),
    "axis {axis}, test {test}": "ось {axis}, проверка {test}",
    "as the file was read ({code})": "как прочитан файл ({code})",
    "All files or none": "Все файлы или ни одного",
    "not given": "не задано",
    "default of the definition; {evidence}": "по умолчанию в определении; {evidence}",
    "default of the definition": "по умолчанию в определении",
    "option {name}": "опция {name}",
    "its tests cover less than half of its travel, which is more than a turn": (
        "её проверки охватывают меньше половины хода, который больше оборота"
    ),
    "axis {name}: its error repeats every": "ось {name}: погрешность повторяется каждые",
    "address of axis {name}": "адрес оси {name}",
    "confirmed: {what}": "подтверждено: {what}",
    "unconfirmed: {what}": "не подтверждено: {what}",
    "inferred: {what}": "выведено: {what}",
    "{label}: compensation during the test": "{label}: компенсация во время проверки",
    "the job's answer (active)": "ответ задания (active)",
    "on": "включена",
    "the files end with it switched on (active: no is of the others)": (
        "файлы кончаются с включённой (active: no относится к другим)"
    ),
    "off": "выключена",
    "axis {name}: kind": "ось {name}: вид",
    "{plan} above the files": "{plan} выше файлов",
    "general knowledge": "по общим сведениям",
    "a table that was given counts as active": "переданная таблица считается активной",
    "absent": "отсутствует (absent)",
    "auto": "автоматически (auto)",
    "error": "погрешность (error)",
    "no": "нет (no)",
}
