"""Russian texts for the controls of `formats.families.grid`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Keep a copy of the INI file and of each compensation file that it names.": (
        "Сохраните копию файла INI и каждого файла компенсации, который в нём назван."
    ),
    "Put the table in place": "Положить таблицу на место",
    "Copy {file_1} into the folder of the INI file. It holds {points} rows from {start} to"
    " {end} {unit}. Do not add a comment, a header or a blank line: LinuxCNC would stop"
    " reading there without an error.": (
        "Скопируйте {file_1} в папку файла INI. В файле строк: {points}, от {start} до {end}"
        " {unit}. Не добавляйте ни комментария, ни заголовка, ни пустой строки: LinuxCNC"
        " прекратит там чтение без сообщения об ошибке."
    ),
    "Set the keys": "Задать ключи",
    "Put the three lines of {file_2} into the section [JOINT_{address}] of the INI file,"
    " replacing lines of the same name. BACKLASH becomes 0: the table contains the reversal,"
    " and the control ignores it where there is a table.": (
        "Внесите три строки {file_2} в раздел [JOINT_{address}] файла INI на место строк с теми"
        " же именами. BACKLASH становится 0: таблица содержит реверс, а рядом с таблицей УЧПУ"
        " его не учитывает."
    ),
    "Restart LinuxCNC: a table is read once at the start. Look for the messages 'too many"
    " compensation entries' and 'compensation values must increase'.": (
        "Перезапустите LinuxCNC: таблица читается один раз при запуске. Следите за сообщениями"
        " 'too many compensation entries' и 'compensation values must increase'."
    ),
    "Home the same way": "Так же выйти в опорную позицию",
    "Home the axis as it was homed for the measurement. Before the first motion after homing"
    " nothing is corrected.": (
        "Выведите ось в опорную позицию так же, как для измерения. До первого движения после"
        " этого ничего не корректируется."
    ),
    "Drive to the check positions (their table stands with the axis) and read the HAL pin"
    " joint.{address}.backlash-filt in machine units: it shows what the control must add"
    " there.": (
        "Переместите в контрольные позиции (их таблица — у оси) и прочитайте вывод HAL"
        " joint.{address}.backlash-filt в единицах станка: он показывает, что УЧПУ должно там"
        " прибавлять."
    ),
    "Copy the INI file and the compensation files that it names from the control again and"
    " compare them with the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`.": (
        "Снова скопируйте с УЧПУ файл INI и файлы компенсации, которые он называет, и сравните их"
        " с планом: `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "Put the saved INI file back, with each compensation file that it names; restart LinuxCNC and"
    " home.": (
        "Верните сохранённый файл INI и каждый файл компенсации, который в нём назван;"
        " перезапустите LinuxCNC и выведите в опорную позицию."
    ),
    "Axis {name} is programmed in diameter: laser, table and every position on this card"
    " count in radius, as the joint moves; the control looks its table up there, whatever G7"
    " and G8 say. In G7 program twice the position": (
        "Ось {name} программируется в диаметре: лазер, таблица и каждая позиция на этой карте"
        " считают в радиусе, как движется узел; УЧПУ ищет в таблице там же, что бы ни говорили"
        " G7 и G8. В G7 программируйте удвоенную позицию"
    ),
    "with the kinematics matrixkins (LinuxCNC 2.10) add {squareness} to the value of"
    " matrixkins.C_{output}{input} that is in force{shift}; without it this control has no"
    " place for it": (
        "с кинематикой matrixkins (LinuxCNC 2.10) прибавьте {squareness} к действующему"
        " значению matrixkins.C_{output}{input}{shift}; без неё у этого УЧПУ нет для этого"
        " места"
    ),
    "BACKLASH of [JOINT_{address}] = {backlash} {backlash_unit}": (
        "BACKLASH из [JOINT_{address}] = {backlash} {backlash_unit}"
    ),
    "The HAL pin joint.{address}.backlash-filt at the check positions of the card shows what"
    " the control adds there, without any measurement.": (
        "Вывод HAL joint.{address}.backlash-filt в контрольных позициях карты показывает, что"
        " УЧПУ там прибавляет, без всякого измерения."
    ),
    "COMP_FILE of [JOINT_{address}] is read once, at the start, relative to the folder of"
    " the INI file: restart after every change.": (
        "COMP_FILE из [JOINT_{address}] читается один раз, при запуске, относительно папки"
        " файла INI: перезапускайте после каждого изменения."
    ),
    "Reading stops without a message at the first line that is not three numbers (a comment,"
    " a header, a comma): then the table is empty, and BACKLASH is active in its place.": (
        "Чтение кончается без сообщения на первой строке, где не три числа (комментарий,"
        " заголовок, запятая): тогда таблица пуста, и вместо неё действует BACKLASH."
    ),
    "Before the first motion after homing nothing is added.": (
        "До первого движения после выхода в опорную позицию ничего не прибавляется."
    ),
    "COMP_FILE_TYPE of [JOINT_{address}]: 1 takes the columns as corrections, which are"
    " added; 0, also where the key is missing, as actual positions. Were errors written as"
    " corrections?": (
        "COMP_FILE_TYPE из [JOINT_{address}]: 1 принимает столбцы как коррекции, которые"
        " прибавляются; 0, также без ключа, как действительные позиции. Не записаны ли"
        " погрешности как коррекции?"
    ),
    "Numbers of the table count in machine units, LINEAR_UNITS of [TRAJ]: inch taken for mm"
    " is 25.4.": (
        "Числа таблицы считаются в единицах станка, LINEAR_UNITS из [TRAJ]: дюймы вместо мм —"
        " это 25.4."
    ),
    "The first column of the table: nominal positions of the joint, ascending.": (
        "Первый столбец таблицы: номинальные позиции узла, по возрастанию."
    ),
    "Was the axis homed as for the measurement? Another kind of homing, or another"
    " HOME_OFFSET, moves the table.": (
        "Выведена ли ось в опорную позицию так же, как для измерения? Иной способ или иной"
        " HOME_OFFSET сдвигает таблицу."
    ),
    "The signs of the first column: a table that was turned over does not ascend, and rows"
    " that do not ascend are dropped.": (
        "Знаки первого столбца: перевёрнутая таблица не возрастает, а строки, которые не"
        " возрастают, отбрасываются."
    ),
    "The table belongs into the section [JOINT_{address}]: joints are counted from 0 in the"
    " order of the kinematics, so on a lathe with X and Z the Z is joint 1.": (
        "Таблица относится к разделу [JOINT_{address}]: узлы считаются от 0 в порядке"
        " кинематики, поэтому на токарном станке с X и Z ось Z — узел 1."
    ),
    "The second column is active while the joint moves in +, the third one while it moves in -.": (
        "Второй столбец действует при движении в +, третий — при движении в -."
    ),
    "BACKLASH of [JOINT_{address}] is ignored as soon as the table has one row; without rows,"
    " half of it is active in each direction.": (
        "BACKLASH из [JOINT_{address}] не учитывается, как только в таблице есть строка; без"
        " строк он действует наполовину в каждом направлении."
    ),
    "At most 256 rows are taken; a row that does not ascend is dropped, and reading stops at"
    " the first line that is not three numbers: look for the messages at the start.": (
        "Принимается не более 256 строк; строка, которая не возрастает, отбрасывается, и чтение"
        " кончается на первой строке, где не три числа: следите за сообщениями при запуске."
    ),
    "Below the first and above the last row their values stay.": (
        "Ниже первой и выше последней строки сохраняются их значения."
    ),
    "{label}: zero of the correction": "{label}: нуль коррекции",
    "{position} {unit}, approached in {direction}": "{position} {unit}, подход в {direction}",
    "the axis homes on a switch (HOME_OFFSET, HOME_LATCH_VEL): what the table holds there"
    " counts as zero": (
        "ось выходит в опорную позицию по выключателю (HOME_OFFSET, HOME_LATCH_VEL): то, что"
        " таблица там содержит, считается нулём"
    ),
    "{label}: table": "{label}: таблица",
    "no file that was given contains one": "ни один данный файл её не содержит",
    "where its turn begins (MD30340)": "где начинается её оборот (MD30340)",
    "{value} deg": "{value}°",
    "the control has reserved none yet": "УЧПУ ещё ничего не зарезервировало",
    "that the control wraps it (MD30310)": "что УЧПУ ведёт её бесконечно (MD30310)",
    "yes": "да",
    "the control's files do not say it": "файлы УЧПУ этого не говорят",
    "axis {name}: {fact}": "ось {name}: {fact}",
    "in no file": "ни в одном файле",
    "axis {name}: number of points the control can store": (
        "ось {name}: число точек, которое вмещает УЧПУ"
    ),
    "as many as are needed; the card says how many to set": (
        "сколько нужно; карта говорит, сколько задать"
    ),
    "LinuxCNC, screw compensation table (COMP_FILE) per joint": (
        "LinuxCNC, таблица компенсации винта (COMP_FILE) для каждого сустава"
    ),
    "L3: 0 is the control's own default": "L3: 0 — собственное значение УЧПУ по умолчанию",
    "L3: LINEAR is the control's own default": (
        "L3: LINEAR — собственное значение УЧПУ по умолчанию"
    ),
    "joints are numbered in the order of the kinematics; of a letter alone only that of X is"
    " taken, and only where no file says it": (
        "суставы нумеруются в порядке кинематики; по одной букве принимается только сустав X, и"
        " только если ни один файл этого не указывает"
    ),
    "MD30200: there is one": "MD30200: она одна",
    "the only one in the files": "единственная в файлах",
    "the only one that is switched on (MD32700)": "единственная включённая (MD32700)",
    "the only one that contains a table": "единственная, в которой есть таблица",
    "the only one with points reserved (MD38000)": (
        "единственная с зарезервированными точками (MD38000)"
    ),
    "the only one with a backlash value": "единственная со значением люфта",
    "the one that contains a table": "та, в которой есть таблица",
    "axis {name}: measuring system": "ось {name}: измерительная система",
}
