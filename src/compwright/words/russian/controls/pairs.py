"""Russian texts for the controls of `formats.families.pairs`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Make a complete commissioning archive of the NC. Changing MD38000 or MD18342 clears the"
    " static user memory at the next start.": (
        "Сделайте полный архив ввода в эксплуатацию NC. Изменение MD38000 или MD18342 очищает"
        " статическую память пользователя при следующем запуске."
    ),
    "Access level": "Уровень доступа",
    "Log in at access level Manufacturer before you load, and before you load the way back:"
    " lines of machine data ($MA_, $SN_) without a checksum are refused at a lower one, and"
    " what they switch stays as it was.": (
        "До загрузки и до загрузки пути назад войдите на уровне доступа «Изготовитель»: строки"
        " машинных данных ($MA_, $SN_) без контрольной суммы на более низком отвергаются, и то,"
        " что они переключают, остаётся как было."
    ),
    "Compare the archive": "Сравнить архив",
    "{archive}": "{archive}",
    "Reserve the points": "Зарезервировать точки",
    "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] must be at least {points}. If it"
    " is smaller: set it, save an archive, power on, load the archive back.": (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] должно быть не меньше {points}."
        " Если меньше: задайте, сделайте архив, Power On, загрузите архив обратно."
    ),
    "{room}": "{room}",
    "Switch the old table off": "Выключить старую таблицу",
    "Set MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0 and activate it (NEW CONF or"
    " reset). With 1 the table is write protected.{emptied}{others}": (
        "Задайте MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0 и активируйте (NEW CONF или"
        " сброс). При 1 таблица защищена от записи.{emptied}{others}"
    ),
    "Set MD32710 $MA_CEC_ENABLE[{address}] = 0, SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
    " tables {table_positive} and {table_negative}, and MD32700"
    " $MA_ENC_COMP_ENABLE[{index},{address}] = 0, and activate all (NEW CONF). With MD32710"
    " = 1 the tables are write protected. MD32700 stays 0. Note what MD32710 was before: if"
    " it was 0, find out what else is inactive on axis {address} (every other table with this"
    " output axis and a value that is not 0), and switch it off (SD41300 = 0) before"
    " anything else. MD32710 would activate it.{others}": (
        "Задайте MD32710 $MA_CEC_ENABLE[{address}] = 0, SD41300 $SN_CEC_TABLE_ENABLE = 0 для"
        " таблиц {table_positive} и {table_negative} и MD32700"
        " $MA_ENC_COMP_ENABLE[{index},{address}] = 0 и активируйте всё (NEW CONF). При MD32710"
        " = 1 таблицы защищены от записи. MD32700 остаётся 0. Запишите, чему MD32710 было равно"
        " раньше: если 0, выясните, что ещё не активно на оси {address} (любая другая таблица с"
        " этой выходной осью и значением не 0), и выключите это (SD41300 = 0) прежде всего"
        " остального. MD32710 включило бы его.{others}"
    ),
    "The sign of this table is confirmed by the manual: a positive value moves the axis in"
    " the negative direction. The quick check shows it.": (
        "Знак этой таблицы подтверждён руководством: положительное значение перемещает ось в"
        " отрицательном направлении. Быстрая проверка это покажет."
    ),
    "A positive CEC value moves the axis in - (Function Manual Extended Functions 03/2009,"
    " page 372), which is cec_sign: error; these values were written for the option cec_sign"
    " of the job. Before any file of this set is loaded: stand on axis {name} with a dial"
    " gauge, write 0.1 {unit} into every point of tables {table_positive} and"
    " {table_negative} and switch them on for this check alone: MD32710, NEW CONF, SD41300,"
    " NEW CONF, NCK reset. With cec_sign: correction the axis must move by 0.1 {unit} in +,"
    " with cec_sign: error in -. If it does not: load nothing, and run again with the other"
    " one. Write 0 again and switch them off as in the step before.": (
        "Положительное значение CEC перемещает ось в − (Function Manual Extended Functions"
        " 03/2009, страница 372), то есть cec_sign: error; эти значения записаны для опции"
        " cec_sign задания. До загрузки любого файла этого набора: с индикатором на оси {name}"
        " запишите 0.1 {unit} в каждую точку таблиц {table_positive} и {table_negative} и"
        " включите их только для этой проверки: MD32710, NEW CONF, SD41300, NEW CONF, NCK"
        " reset. При cec_sign: correction ось должна переместиться на 0.1 {unit} в +, при"
        " cec_sign: error в −. Если нет: ничего не загружайте и выполните расчёт снова с другим"
        " значением. Снова запишите 0 и выключите их, как в шаге до этого."
    ),
    "Load the table": "Загрузить таблицу",
    "Load {file_1}: {points} points from {start} to {end} {unit} every {spacing} {unit}. The"
    " table holds the error, the opposite of the correction.": (
        "Загрузите {file_1}: точек {points}, от {start} до {end} {unit} через {spacing} {unit}."
        " Таблица содержит погрешность, обратную коррекции."
    ),
    "Load {file_3}: {points} points from {start} to {end} {unit} every {spacing} {unit},"
    " table {table_positive} for travel in +, table {table_negative} for travel in -. Each"
    " holds the whole correction of its direction.": (
        "Загрузите {file_3}: точек {points}, от {start} до {end} {unit} через {spacing} {unit},"
        " таблица {table_positive} для хода в +, таблица {table_negative} для хода в −. Каждая"
        " содержит всю коррекцию своего направления."
    ),
    "Set the backlash and switch the table on": "Задать люфт и включить таблицу",
    "{woken}Load {file_2} last (what was loaded with the table is not loaded again), or by"
    " hand: MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} and MD32700"
    " $MA_ENC_COMP_ENABLE[{index},{address}] = 1, which switches the table on. Then NEW"
    " CONF, and power on or reset.{others_back} {referencing}": (
        "{woken}Загрузите {file_2} последним (загруженное с таблицей снова не загружать) или"
        " вручную: MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} и"
        " MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 1, что включает таблицу. Затем NEW"
        " CONF и Power On или сброс.{others_back} {referencing}"
    ),
    "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first. Set"
    " MD32710 $MA_CEC_ENABLE[{address}] = 1, NEW CONF. Load {file_2} last (what was loaded"
    " with the table is not loaded again), or by hand: MD32450"
    " $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} and SD41300"
    " $SN_CEC_TABLE_ENABLE = 1 for the tables {table_positive} and {table_negative}, which"
    " switches them on. Then NEW CONF, NCK reset.{others_back} {referencing}": (
        "Если MD32710 раньше было 0: сначала SD41300 = 0 для того, что ещё не активно на оси"
        " {address}. Задайте MD32710 $MA_CEC_ENABLE[{address}] = 1, NEW CONF. Загрузите"
        " {file_2} последним (загруженное с таблицей снова не загружать) или вручную: MD32450"
        " $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} и SD41300"
        " $SN_CEC_TABLE_ENABLE = 1 для таблиц {table_positive} и {table_negative}, что включает"
        " их. Затем NEW CONF, NCK reset.{others_back} {referencing}"
    ),
    "Read the service display 'absolute compensation value measuring system {system}' at the"
    " check positions (their table stands with the axis). It should show the amounts that"
    " the control must add there. Whether this display counts them with the same sign is not"
    " confirmed: compare amounts here; the quick check shows the sign of the table.": (
        "Прочитайте сервисную индикацию «абсолютное значение компенсации, измерительная система"
        " {system}» в контрольных позициях (их таблица — у оси). Она должна показать величины,"
        " которые УЧПУ должно там прибавлять. Считает ли эта индикация их с тем же знаком, не"
        " подтверждено: сравнивайте здесь величины; знак таблицы покажет быстрая проверка."
    ),
    "Read the service display 'compensation, sag + temperature' at the check positions"
    " (their table stands with the axis). It should show the amounts that the control must"
    " add there. Whether this display counts them with the same sign is not confirmed:"
    " compare amounts here; the quick check shows the sign of the table.": (
        "Прочитайте сервисную индикацию «компенсация, провисание + температура» в контрольных"
        " позициях (их таблица — у оси). Она должна показать величины, которые УЧПУ должно там"
        " прибавлять. Считает ли эта индикация их с тем же знаком, не подтверждено: сравнивайте"
        " здесь величины; знак таблицы покажет быстрая проверка."
    ),
    "Export the table and the machine data again and compare them with the plan: `compwright"
    " compare JOB_FOLDER --loaded READ_BACK`.": (
        "Снова выведите таблицу и машинные данные и сравните их с планом: `compwright compare"
        " JOB_FOLDER --loaded READ_BACK`."
    ),
    "By hand: MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0, MD32450"
    " $MA_BACKLASH[{index},{address}] as in column Old, then NEW CONF and power on or reset.": (
        "Вручную: MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0, MD32450"
        " $MA_BACKLASH[{index},{address}] как в столбце «Старое», затем NEW CONF и Power On или"
        " сброс."
    ),
    "By hand: SD41300 $SN_CEC_TABLE_ENABLE = 0 for the tables {table_positive} and"
    " {table_negative}, MD32710 $MA_CEC_ENABLE[{address}] as it was, MD32450"
    " $MA_BACKLASH[{index},{address}] as in column Old, then NEW CONF and NCK reset.": (
        "Вручную: SD41300 $SN_CEC_TABLE_ENABLE = 0 для таблиц {table_positive} и"
        " {table_negative}, MD32710 $MA_CEC_ENABLE[{address}] как было, MD32450"
        " $MA_BACKLASH[{index},{address}] как в столбце «Старое», затем NEW CONF и NCK reset."
    ),
    "set the option cec: available, if the control has sag compensation, and name free"
    " indices in cec_tables": (
        "задайте опцию cec: available, если в УЧПУ есть компенсация провисания, и назовите"
        " свободные индексы в cec_tables"
    ),
    "MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit}": (
        "MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit}"
    ),
    "{room} Set {enable} = 0 and {switch} = 0 for {which}, NEW CONF. Note what MD32710 was"
    " before: if it was 0, find out what else is inactive on axis {address} (every other table"
    " with this output axis and a value that is not 0), and switch it off (SD41300 = 0)"
    " before anything else. MD32710 would activate it.": (
        "{room} Задайте {enable} = 0 и {switch} = 0 для {which}, NEW CONF. Запишите, чему"
        " MD32710 было равно раньше: если 0, выясните, что ещё не активно на оси {address} (любая"
        " другая таблица с этой выходной осью и значением не 0), и выключите это (SD41300 = 0)"
        " прежде всего остального. MD32710 включило бы его."
    ),
    "Before {files} is loaded: write {value} {unit} into every point of {which} and switch"
    " {each} on for this check: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. A dial"
    " gauge on {address} must show +{value} {unit} for cec_sign: correction, -{value} {unit} for"
    " cec_sign: error. If it does not: load nothing, and run again with the other one. Write"
    " 0 again and switch off as in the step before.": (
        "До загрузки {files}: запишите {value} {unit} в каждую точку {which} и включите {each} для"
        " этой проверки: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. Индикатор на"
        " {address} должен показать +{value} {unit} для cec_sign: correction, -{value} {unit} для"
        " cec_sign: error. Если нет: ничего не загружайте и выполните расчёт снова с другим"
        " значением. Снова запишите 0 и выключите, как в шаге до этого."
    ),
    "{check} In use: {which}. The file holds its old values plus this correction. After"
    " the check its values are {value} or 0: if you load nothing, load its old values of the folder"
    " rollback again, and set MD32710 and SD41300 as they were.": (
        "{check} Используется: {which}. В файле её прежние значения плюс эта коррекция. После"
        " проверки её значения равны {value} или 0: если ничего не загружается, снова загрузите её"
        " прежние значения из папки rollback и верните MD32710 и SD41300 прежние значения."
    ),
    "Load {files}. {error}: {output} is moved by {ends}, 0 at the reference of {input}.": (
        "Загрузите {files}. {error}: {output} перемещается на {ends}, 0 в опорной позиции {input}."
    ),
    "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first. Set"
    " {enable} = 1, NEW CONF, then {switch} = 1 for {which}, NEW CONF, NCK reset. Work"
    " offsets of {output} shift with {input}: probe them again. Compare the result with a"
    " square or a dial gauge before production.": (
        "Если MD32710 раньше было 0: сначала SD41300 = 0 для того, что ещё не активно на оси"
        " {address}. Задайте {enable} = 1, NEW CONF, затем {switch} = 1 для {which}, NEW CONF,"
        " NCK reset. Смещения нуля {output} сдвигаются вместе с {input}: измерьте их щупом"
        " заново. Сравните результат до работы с угольником или индикатором."
    ),
    "it": "её",
    "each of them": "каждую из них",
    "{output} over {input}: reserve and switch off": (
        "{output} по {input}: зарезервировать и выключить"
    ),
    "{output} over {input}: switch on": "{output} по {input}: включить",
    "{value} {unit} at {input} {position}": "{value} {unit} при {input} {position}",
    " Set {switch} = 0 (note what it was) and SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
    " {which}, NEW CONF: what the new table takes the place of is emptied, and protected"
    " while it is on.": (
        " Задайте {switch} = 0 (запишите, чему было равно) и SD41300 $SN_CEC_TABLE_ENABLE = 0"
        " для {which}, NEW CONF: то, что заменяет новая таблица, опустошается и защищено, пока"
        " включено."
    ),
    "If MD32710 was on: set {switch} = 1 again, NEW CONF. ": (
        "Если MD32710 было включено: снова задайте {switch} = 1, NEW CONF. "
    ),
    "No gantry: MD37100 = 0 in the control's files.": "Не портал: MD37100 = 0 в файлах УЧПУ.",
    " The patched files assign other tables again, which a control protects while they are"
    " on. Set {switches} = 0 too and activate it (NEW CONF).": (
        " Изменённые файлы снова присваивают другие таблицы, которые УЧПУ защищает, пока они"
        " включены. Задайте также {switches} = 0 и активируйте (NEW CONF)."
    ),
    " Then set {switches} = 1 again and activate it (NEW CONF).": (
        " Затем снова задайте {switches} = 1 и активируйте (NEW CONF)."
    ),
    "The contents of the archive are not verified. Compare on the control, before anything"
    " is changed: {archive}. If one differs, load nothing: export the archive again, and run"
    " again.": (
        "Содержимое архива не проверено. Сравните на УЧПУ до любых изменений: {archive}. Если"
        " одно отличается, ничего не загружайте: выведите архив снова и выполните расчёт снова."
    ),
    "the tables {tables}": "таблиц {tables}",
    "{file}, then your own patched {files}": "{file}, затем ваши файлы {files}, с изменениями",
    "tables {tables}": "таблиц {tables}",
    "{points} points are needed for {which}: each has room for {room}, none are reserved.": (
        "Для {which} нужно точек: {points}; в каждой есть место для {room}, резервировать не нужно."
    ),
    "table {tables}": "таблицы {tables}",
    "MD18342 $MN_MM_CEC_MAX_POINTS must be at least {points} for {which}. If it is smaller:"
    " set it, save an archive, power on, load the archive back.": (
        "MD18342 $MN_MM_CEC_MAX_POINTS для {which} должно быть не меньше {points}. Если меньше:"
        " задайте, сделайте архив, Power On, загрузите архив обратно."
    ),
    "The service display 'absolute compensation value measuring system {system}' at the"
    " check positions of the card shows table and backlash together, without any"
    " measurement.": (
        "Сервисная индикация «абсолютное значение компенсации, измерительная система {system}»"
        " в контрольных позициях карты показывает таблицу и люфт вместе, без всякого измерения."
    ),
    "The service display 'compensation, sag + temperature' at the check positions of the"
    " card shows what the tables add, without any measurement.": (
        "Сервисная индикация «компенсация, провисание + температура» в контрольных позициях"
        " карты показывает, что прибавляют таблицы, без всякого измерения."
    ),
    "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] must be 1; while it is 1 a table is"
    " write protected, so it must have been 0 when the table was loaded.": (
        "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] должно быть 1; пока оно 1, таблица"
        " защищена от записи, поэтому при загрузке таблицы оно должно было быть 0."
    ),
    "MD32710 $MA_CEC_ENABLE[{address}] of the output axis and SD41300 $SN_CEC_TABLE_ENABLE"
    " of both tables must be 1; MD32710 must have been 0 when they were loaded.": (
        "MD32710 $MA_CEC_ENABLE[{address}] выходной оси и SD41300 $SN_CEC_TABLE_ENABLE обеих"
        " таблиц должны быть 1; MD32710 при загрузке должно было быть 0."
    ),
    "The axis must be referenced, in measuring system {system}: before that no compensation"
    " is active, and a lost reference switches it off.": (
        "Ось должна быть выведена в опорную позицию, в измерительной системе {system}: до этого"
        " ничего не действует, а потеря опорной позиции это выключает."
    ),
    "Which measuring system is in use? Values, switch and backlash of index {index} act in"
    " system {system} alone.": (
        "Какая измерительная система используется? Значения, переключатель и люфт индекса"
        " {index} действуют только в системе {system}."
    ),
    "A positive value of $AA_ENC_COMP moves the axis in -: the table holds the error, as it"
    " was measured. Was it typed in, or converted, as a correction?": (
        "Положительное значение $AA_ENC_COMP перемещает ось в -: таблица содержит погрешность,"
        " как она измерена. Не введена ли она, или пересчитана, как коррекция?"
    ),
    "What a positive CEC value does is the option cec_sign: write +0.1 {unit} into a table"
    " that is free, as the card says; if the axis moves the other way, run again with the"
    " other one.": (
        "Что делает положительное значение CEC, задаёт опция cec_sign: запишите +0.1 {unit} в"
        " свободную таблицу, как говорит карта; если ось движется в другую сторону, выполните"
        " расчёт снова с другим значением."
    ),
    "MD10240 and the line METRIC or INCH of the files: inch taken for mm is 25.4.": (
        "MD10240 и строка METRIC или INCH файлов: дюймы вместо мм — это 25.4."
    ),
    "A second table on the axis: where MD32700 is 1, a CEC table of {address} over itself"
    " (MD32710, SD41300) is active in addition.": (
        "Вторая таблица на оси: таблица CEC {address} по себе самой (MD32710, SD41300) рядом с"
        " MD32700 действует дополнительно."
    ),
    "A second table on the axis: MD32700 must be 0 where a pair of CEC tables is used, and"
    " SD41310 $SN_CEC_TABLE_WEIGHT of both 1.": (
        "Вторая таблица на оси: MD32700 рядом с парой таблиц CEC должно быть 0, а SD41310"
        " $SN_CEC_TABLE_WEIGHT обеих — 1."
    ),
    "Radius and diameter: a table counts the way of the axis, a program in diameter shows"
    " twice of it.": (
        "Радиус и диаметр: таблица считает путь оси, программа в диаметре показывает вдвое больше."
    ),
    "$AA_ENC_COMP_MIN and $AA_ENC_COMP_STEP[{index},{address}]: the position of point 0, and"
    " from point to point.": (
        "$AA_ENC_COMP_MIN и $AA_ENC_COMP_STEP[{index},{address}]: позиция точки 0 и расстояние"
        " от точки к точке."
    ),
    "$AN_CEC_MIN and $AN_CEC_STEP of both tables: the position of point 0, and from point to"
    " point.": (
        "$AN_CEC_MIN и $AN_CEC_STEP обеих таблиц: позиция точки 0 и расстояние от точки к точке."
    ),
    "Positions of the table are machine positions of {address}: was the axis referenced as"
    " for the measurement?": (
        "Позиции таблицы — станочные позиции {address}: выведена ли ось в опорную позицию так"
        " же, как для измерения?"
    ),
    "Point 0 stands at $AA_ENC_COMP_MIN[{index},{address}] and the last one at MAX: were the"
    " points entered from the other end?": (
        "Точка 0 находится в $AA_ENC_COMP_MIN[{index},{address}], последняя — в MAX: не введены"
        " ли точки с другого конца?"
    ),
    "Point 0 stands at $AN_CEC_MIN and the last one at MAX in both tables, that for - too:"
    " were the points entered from the other end?": (
        "Точка 0 находится в $AN_CEC_MIN, последняя — в MAX в обеих таблицах, и в той, что для"
        " -: не введены ли точки с другого конца?"
    ),
    "The name in the brackets of $AA_ENC_COMP: {address} for axis {name}; by MD10000 a"
    " machine axis may also be called X1.": (
        "Имя в скобках $AA_ENC_COMP: {address} для оси {name}; по MD10000 станочная ось может"
        " называться и X1."
    ),
    "$AN_CEC_INPUT_AXIS and $AN_CEC_OUTPUT_AXIS of both tables must be ({address}); by"
    " MD10000 a machine axis may also be called X1.": (
        "$AN_CEC_INPUT_AXIS и $AN_CEC_OUTPUT_AXIS обеих таблиц должны быть ({address}); по"
        " MD10000 станочная ось может называться и X1."
    ),
    "This table is active in both directions. What is active in one direction only is a CEC"
    " table of the axis over itself ($AN_CEC_DIRECTION, SD41300 $SN_CEC_TABLE_ENABLE) or"
    " MD32450.": (
        "Эта таблица действует в обоих направлениях: только в одном действует таблица CEC оси"
        " по себе самой ($AN_CEC_DIRECTION, SD41300 $SN_CEC_TABLE_ENABLE) или MD32450."
    ),
    "$AN_CEC_DIRECTION of the two tables must be 1 and -1, and SD41300 $SN_CEC_TABLE_ENABLE"
    " of both 1.": (
        "$AN_CEC_DIRECTION двух таблиц должны быть 1 и -1, а SD41300 $SN_CEC_TABLE_ENABLE обеих"
        " — 1."
    ),
    "MD32450 $MA_BACKLASH[{index},{address}], times MD32452: positive where the axis loses"
    " motion. It is active after NEW CONF, and once the axis is referenced.": (
        "MD32450 $MA_BACKLASH[{index},{address}], умноженное на MD32452: плюс, где ось теряет"
        " ход. Оно действует после NEW CONF и когда ось выведена в опорную позицию."
    ),
    "MD32456 $MA_BACKLASH_DYN, which the PLC switches, is active in addition to it.": (
        "MD32456 $MA_BACKLASH_DYN, которое переключает PLC, действует дополнительно."
    ),
    "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] must be at least the number of"
    " points: with fewer the control shortens the table.": (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] должно быть не меньше числа"
        " точек: при меньшем УЧПУ укорачивает таблицу."
    ),
    "MD18342 $MN_MM_CEC_MAX_POINTS of both tables must be at least the number of points (on"
    " the 828D 200, fixed).": (
        "MD18342 $MN_MM_CEC_MAX_POINTS обеих таблиц должно быть не меньше числа точек (на 828D"
        " — 200, постоянно)."
    ),
    "$AA_ENC_COMP_MAX[{index},{address}] ends the table, and the end value stays beyond it.": (
        "$AA_ENC_COMP_MAX[{index},{address}] кончает таблицу, и крайнее значение сохраняется"
        " дальше."
    ),
    "$AN_CEC_MAX ends the tables, and the end value stays beyond it.": (
        "$AN_CEC_MAX кончает таблицы, и крайнее значение сохраняется дальше."
    ),
    "axis {name}: number of points of its CEC tables (MD18342)": (
        "ось {name}: число точек её таблиц CEC (MD18342)"
    ),
    "axis {name}: limit of the sum of its CEC tables (MD32720)": (
        "ось {name}: предел суммы её таблиц CEC (MD32720)"
    ),
    "not reached (default 1 {unit})": "не достигнут (по умолчанию 1 {unit})",
    "the control's files do not say it, or reserve none yet": (
        "файлы УЧПУ этого не говорят или ещё ничего не резервируют"
    ),
    "in no file, its default from general knowledge": (
        "ни в одном файле, значение по умолчанию по общим сведениям"
    ),
    "one manual of Siemens says error; no readings depend on it here": (
        "одно руководство Siemens говорит error; здесь отсчёты от этого не зависят"
    ),
    "SINUMERIK 828D, leadscrew error compensation (EEC) with backlash (MD32450), cross-error"
    " compensation (CEC, 8 tables of 200 points) as an option": (
        "SINUMERIK 828D, компенсация погрешности шага винта (EEC) с компенсацией люфта"
        " (MD32450), компенсация провисания (CEC, 8 таблиц по 200 точек) как опция"
    ),
    "SINUMERIK 840D powerline (840Di, 810D), leadscrew error compensation (EEC) with"
    " backlash (MD32450), cross-error compensation (CEC) as an option": (
        "SINUMERIK 840D powerline (840Di, 810D), компенсация погрешности шага винта (EEC) с"
        " компенсацией люфта (MD32450), компенсация провисания (CEC) как опция"
    ),
    "SINUMERIK 840D sl, leadscrew error compensation (EEC) with backlash (MD32450),"
    " cross-error compensation (CEC) as an option": (
        "SINUMERIK 840D sl, компенсация погрешности шага винта (EEC) с компенсацией люфта"
        " (MD32450), компенсация провисания (CEC) как опция"
    ),
    "SINUMERIK ONE, leadscrew error compensation (EEC) with backlash (MD32450), cross-error"
    " compensation (CEC) as an option": (
        "SINUMERIK ONE, компенсация погрешности шага винта (EEC) с компенсацией люфта"
        " (MD32450), компенсация провисания (CEC) как опция"
    ),
    "S1 p242 knows 0 and 1; 0 is the value of memory that was never written": (
        "S1 p242: известны 0 и 1; 0 — значение памяти, в которую не писали"
    ),
    "S1 p249 knows 0 and 1; 0 is the value of memory that was never written": (
        "S1 p249: известны 0 и 1; 0 — значение памяти, в которую не писали"
    ),
    "a table that was given counts as active; a job is asked (active)": (
        "переданная таблица считается активной; задание отвечает на вопрос (active)"
    ),
    "neither the job nor the files say so": "ни задание, ни файлы этого не указывают",
    "the sign of its values is not given (option cec_sign)": (
        "знак значений не указан (опция cec_sign)"
    ),
    "{label}: during the test": "{label}: во время измерения",
    "{switches} end as 0, while the leadscrew table of the axis is on": (
        "{switches} в конце равны 0, а таблица винта этой оси включена"
    ),
}
