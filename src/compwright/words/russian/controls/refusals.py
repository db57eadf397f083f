"""Russian reasons why a correction between axes is refused, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "0 in the switch, or the values before the switch or in a file of their own, as the control"
    " exports them (NC_CEC.INI)": (
        "0 в переключателе, либо значения перед переключателем или в отдельном файле, как их"
        " выгружает УЧПУ (NC_CEC.INI)"
    ),
    "CEC table {index} has to be written, but the control multiplies it by table {other}"
    " ($AN_CEC_MULT_BY_TABLE)": (
        "таблицу CEC {index} нужно записать, но УЧПУ умножает её на таблицу {other}"
        " ($AN_CEC_MULT_BY_TABLE)"
    ),
    "CEC table {index} needs more points than MD18342 reserves": (
        "таблице CEC {index} нужно больше точек, чем резервирует MD18342"
    ),
    "CEC table {index} needs more points than a table can have": (
        "таблице CEC {index} нужно больше точек, чем может иметь таблица"
    ),
    "CEC table {index}: this file switches the table on (SD41300, MD32710) before it gives the"
    " values. A table that is on is protected, so the control takes none of these values": (
        "таблица CEC {index}: этот файл включает таблицу (SD41300, MD32710) раньше, чем задаёт"
        " значения. Включённая таблица защищена, поэтому УЧПУ не примет ни одного из этих значений"
    ),
    "`cec: absent`, or {parameter}": "`cec: absent` или {parameter}",
    "`cec_tables` does not name it": "`cec_tables` её не называет",
    "a cross-axis table contains one curve, which is the same for both directions": (
        "таблица между осями содержит одну кривую, одинаковую для обоих направлений"
    ),
    "add the file with MD18342 to the control's files, or {step}": (
        "добавьте файл с MD18342 к файлам УЧПУ или {step}"
    ),
    "add the file with {name} to the control's files (`states` or `--state`)": (
        "добавьте файл с {name} к файлам УЧПУ (`states` или `--state`)"
    ),
    "add {index} to `cec_tables`, so that it is changed in place": (
        "добавьте {index} в `cec_tables`, чтобы изменилась она сама"
    ),
    "at most {value}": "не больше {value}",
    "axis {name}: {control} needs a CEC table that is free or already belongs to this axis": (
        "ось {name}: {control} требует таблицу CEC, которая свободна или уже принадлежит этой оси"
    ),
    "axis {name}: {control} needs {needed} CEC tables that are free or already belong to this"
    " axis": (
        "ось {name}: {control} требует таблицы CEC ({needed}), которые свободны или уже"
        " принадлежат этой оси"
    ),
    "axis {output}: with the correction over {inputs}, the sum of all CEC tables of this axis"
    " would exceed CEC_MAX_SUM (MD32720)": (
        "ось {output}: с коррекцией по {inputs} сумма всех таблиц CEC этой оси превысит"
        " CEC_MAX_SUM (MD32720)"
    ),
    "correct this table in the control and export the files again": (
        "исправьте эту таблицу в УЧПУ и выгрузите файлы снова"
    ),
    "end the travel of {input} in the job at a point of the table (multiples of {spacing} from"
    " {first})": "закончите ход {input} в задании в точке таблицы (кратно {spacing} от {first})",
    "export the CEC tables into a file of their own (NC_CEC.INI), then give that file": (
        "выгрузите таблицы CEC в отдельный файл (NC_CEC.INI) и дайте этот файл"
    ),
    "free indices in `cec_tables`, at least {needed}": (
        "свободные индексы в `cec_tables`, не меньше {needed}"
    ),
    "give a larger `spacing` under `table`": "задайте больший `spacing` в `table`",
    "give fewer points in this entry of `cross`": "задайте меньше точек в этой записи `cross`",
    "give other indices in `cec_tables`; or, if the control has this table, add the file with its"
    " MD18342 to the control's files": (
        "задайте другие индексы в `cec_tables`; или, если эта таблица в УЧПУ есть, добавьте файл с"
        " её MD18342 к файлам УЧПУ"
    ),
    "give other indices in the option `cec_tables`": "задайте другие индексы в опции `cec_tables`",
    "give the same deviations for both directions in this entry of `cross`": (
        "задайте в этой записи `cross` одинаковые отклонения для обоих направлений"
    ),
    "indices from 0 to {last}": "индексы от 0 до {last}",
    "it cannot be read as a curve": "она не читается как кривая",
    "it has room for {room} points": "в ней есть место для точек: {room}",
    "its values are in inch (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)": (
        "её значения в дюймах (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)"
    ),
    "job (`apply` and `cross`)": "задание (`apply` и `cross`)",
    "lists of the control": "списки УЧПУ",
    "set `table: {mode: single}` for an axis whose own tables take an index: one table for both"
    " directions needs none": (
        "задайте `table: {mode: single}` для оси, собственные таблицы которой занимают индекс:"
        " одной таблице для обоих направлений он не нужен"
    ),
    "look in the control for an unused table, and ask the machine's builder; then give its index"
    " as `cec_tables` in the options": (
        "найдите в УЧПУ неиспользуемую таблицу и спросите изготовителя станка; затем задайте её"
        " индекс как `cec_tables` в опциях"
    ),
    "look in the control for {needed} unused tables, and ask the machine's builder; then give"
    " their indices as `cec_tables` in the options": (
        "найдите в УЧПУ неиспользуемые таблицы ({needed}) и спросите изготовителя станка; затем"
        " задайте их индексы как `cec_tables` в опциях"
    ),
    "measure again": "измерьте снова",
    "multiply the values of table {index} by {value}": (
        "умножьте значения таблицы {index} на {value}"
    ),
    "no equal spacing has its points and those of the correction": (
        "ни один постоянный шаг не содержит её точек и точек коррекции"
    ),
    "none: the option is not given": "нет: опция не задана",
    "none in `cec_tables` ({allowed}); those that this job writes for its axes are used": (
        "ни одного в `cec_tables` ({allowed}); таблицы, которые это задание пишет для своих осей,"
        " заняты"
    ),
    "one curve": "одна кривая",
    "one other axis": "одна другая ось",
    "other indices in the option cec_tables": "другие индексы в опции cec_tables",
    "raise MD18342 of this table in the control (this clears its memory), then set `points` to"
    " {count} in the options; or give a larger spacing": (
        "увеличьте MD18342 этой таблицы в УЧПУ (это очистит его память), затем задайте в опциях"
        " `points` = {count}; или задайте больший шаг"
    ),
    "reduce the correction or the other tables of this axis, or raise MD32720, then run the job"
    " again": (
        "уменьшите коррекцию или другие таблицы этой оси либо увеличьте MD32720, затем выполните"
        " задание снова"
    ),
    "remove the corrections of axis {output} over {inputs} from the {where}": (
        "удалите коррекции оси {output} по {inputs} ({where})"
    ),
    "set MD18342 to {count} or more (save an archive, power on, load the archive back) and export"
    " the files again": (
        "задайте MD18342 не меньше {count} (сделайте архив, Power On, загрузите архив обратно) и"
        " выгрузите файлы снова"
    ),
    "set `cec: absent` in the options, so that no CEC table is written": (
        "задайте `cec: absent` в опциях, чтобы таблица CEC не записывалась"
    ),
    "set `cec: available` in the options if the control has it, or remove the cross entries from"
    " the job": (
        "задайте `cec: available` в опциях, если она в УЧПУ есть, или удалите записи `cross` из"
        " задания"
    ),
    "set {name} to 1 in the control, {then}, and export the files again": (
        "задайте в УЧПУ {name} = 1, {then} и выгрузите файлы снова"
    ),
    "the control works in inch (MD10240 = 0), and no file says in which unit its cross-axis"
    " corrections are (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)": (
        "УЧПУ работает в дюймах (MD10240 = 0), и ни один файл не указывает единицу его коррекций"
        " между осями (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)"
    ),
    "the control's files have no MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) of CEC table {index}, so"
    " the control does not have this table": (
        "в файлах УЧПУ нет MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) таблицы CEC {index}, значит,"
        " этой таблицы в УЧПУ нет"
    ),
    "the correction differs by direction": "коррекция зависит от направления",
    "the correction repeats": "коррекция повторяется",
    "the job corrects {name} by {parameter} (method: line)": (
        "задание исправляет {name} параметром {parameter} (method: line)"
    ),
    "the machine data with MD32711 = 1: metric": (
        "машинные данные с MD32711 = 1: метрическая система"
    ),
    "the table that corrects axis {output} over the position of axis {input} has too many points": (
        "в таблице, которая исправляет ось {output} по положению оси {input}, слишком много точек"
    ),
    "this control can correct axis {output} over the position of only one other axis": (
        "это УЧПУ может исправлять ось {output} по положению только одной другой оси"
    ),
    "two different curves": "две разные кривые",
    "up to {value}": "до {value}",
    "{control} has cross-axis tables only if the control has the CEC option": (
        "{control} имеет таблицы между осями, только если в УЧПУ есть опция CEC"
    ),
    "{found} in `cec_tables` ({allowed})": "{found} в `cec_tables` ({allowed})",
    "{have}, needed: {count}": "{have}, нужно: {count}",
    "{label}: no CEC table can be written for this control: {why}": (
        "{label}: для этого УЧПУ нельзя записать таблицу CEC: {why}"
    ),
    "{message}; table {index} of these axes takes no further correction: {reasons}": (
        "{message}; таблица {index} этих осей не принимает ещё одну коррекцию: {reasons}"
    ),
    "{name} is in no given file, and room is known for {room} points only": (
        "{name} нет ни в одном данном файле, и известно место только для точек: {room}"
    ),
    "{name} is {value}": "{name} равно {value}",
    "{name} is {value}, needed: 0": "{name} равно {value}, нужно: 0",
    "{name} is {value}: table {index} is multiplied by it": (
        "{name} равно {value}: таблица {index} умножается на неё"
    ),
    "{one}; or {other}": "{one}; или {other}",
    "{parameter} ({name}) is in no given file, needed: 1": (
        "{parameter} ({name}) нет ни в одном данном файле, нужно: 1"
    ),
    "{parameter} ({name}) is {value}, needed: 1": "{parameter} ({name}) равно {value}, нужно: 1",
    "{parameter} corrects {name} now ({slope} mm/m)": (
        "{parameter} сейчас исправляет {name} ({slope} мм/м)"
    ),
    "{steps}, and run again": "{steps} и выполните снова",
    "{step}, or add the file with {parameter} to the control's files (`states` or `--state`)": (
        "{step}, или добавьте файл с {parameter} к файлам УЧПУ (`states` или `--state`)"
    ),
    "{value}, and the first value in line {line}": "{value}, а первое значение в строке {line}",
    "{why}, and a column is active only with tables, never with {parameter}; give {name} a test"
    " and a table of its own": (
        "{why}, а столбец действует только с таблицами, никогда с {parameter}; дайте оси {name}"
        " своё испытание и свою таблицу"
    ),
    "The column is active only while the bit of {output} in {parameter} is 1. ": (
        "Столбец действует, только пока бит {output} в {parameter} равен 1. "
    ),
    "a column of {file} is for both directions, but the correction has two curves": (
        "столбец {file} действует для обоих направлений, а у коррекции две кривые"
    ),
    "neighbouring values of {file} would differ too much": (
        "соседние значения {file} различались бы слишком сильно"
    ),
    "no table (.COM) that is active for {input} is among the files": (
        "среди файлов нет таблицы (.COM), действующей для {input}"
    ),
    "the bit of {output} in {parameter} is 0: no table is active on it": (
        "бит {output} в {parameter} равен 0: на эту ось не действует ни одна таблица"
    ),
    "Set the bit of {output} in {parameter} to 1. ": (
        "Установите бит {output} в {parameter} в 1. "
    ),
    "{active}If it is 0, and {linear} of {output} or one of its columns in any table is"
    " not 0, leave out this step: set the bit to 1 first and repeat the test. ": (
        "{active}Если он равен 0, а {linear} оси {output} или один из её столбцов в"
        " какой-либо таблице не равен 0, пропустите этот шаг: сначала установите бит в 1 и"
        " повторите измерение. "
    ),
    "no line of {file} is active, and an active line activates every table that it names;"
    " mark the line, repeat the test and give the files as they are then": (
        "ни одна строка {file} не активна, а активная строка включает каждую таблицу,"
        " которую называет; отметьте строку, повторите измерение и укажите файлы в этом"
        " состоянии"
    ),
    "the bit of {output} in {parameter}": ("бит {output} в {parameter}"),
    "the active line of the .CMA": ("активная строка .CMA"),
    "no table is active on {output} now, and {bit} would also activate values that are not"
    " active now ({tables}); empty these columns, or activate them and repeat the test,"
    " then give the files as they are then": (
        "сейчас на {output} не действует ни одна таблица, а {bit} включил бы и значения,"
        " которые сейчас не действуют ({tables}); очистите эти столбцы, либо включите их и"
        " повторите измерение, затем укажите файлы в этом состоянии"
    ),
    "no table is active on {output} now, and not all tables that {bit} would activate are"
    " among the files; give the .CMA and every .COM that its active line names": (
        "сейчас на {output} не действует ни одна таблица, и среди файлов не все таблицы,"
        " которые включил бы {bit}; укажите .CMA и каждую .COM, которую называет её"
        " активная строка"
    ),
    "{file} would need {rows} rows, and the control accepts {most}": (
        "для {file} понадобилось бы строк: {rows}, а УЧПУ принимает {most}"
    ),
    "{file} has no column {column}": "в {file} нет столбца {column}",
    "{file} has no row at a position where the correction bends": (
        "в {file} нет строки в положении, где коррекция имеет излом"
    ),
    "{file} is active for the motion of several axes: {axes}": (
        "{file} действует при движении нескольких осей: {axes}"
    ),
    "{file} is in inch": "{file} в дюймах",
    "{file} reaches from {low} to {high}, the correction from {first} to {last}": (
        "{file} охватывает от {low} до {high}, а коррекция — от {first} до {last}"
    ),
    "{file}: line {number}": "{file}: строка {number}",
    "{input} is a rotary axis": "{input} — поворотная ось",
}
