"""Russian texts for the controls of `formats.families.increments`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save all parameters and the pitch error data of the control to a card or PC; they are"
    " two files from two screens. Keep them untouched.": (
        "Сохраните все параметры и данные погрешности шага УЧПУ на карту или ПК; это два файла"
        " с двух экранов. Храните их без изменений."
    ),
    "Record the old values": "Записать старые значения",
    "Axis {name} is controlled axis {address}. Note its old 1851 and {at_reference} to"
    " {at_spacing} before you change them.": (
        "Ось {name} — управляемая ось {address}. Запишите её старые значения 1851 и"
        " {at_reference} … {at_spacing}, прежде чем менять их."
    ),
    "Load parameters and pitch data, both in one step": (
        "Загрузить параметры и данные шага за один раз"
    ),
    "Both, before the control is switched off and before any axis moves: a new"
    " {at_magnification} multiplies old points, new numbers give them to other sections."
    " Parameters: {at_reference} = {reference_number}, {at_first} = {first_number},"
    " {at_last} = {last_number}, {at_magnification} = {magnification}, {at_spacing} ="
    " {spacing} {unit}, 1851 = {backlash} detection units of {detection_unit}, {further}"
    " (axis {address} only; leave the groups of the other axes alone). Pitch data: points"
    " {first_number} to {last_number}: load the pitch data file of the folder tables/, or"
    " type in the sheet entry_{sheet}.csv. That a control takes the form in which it gives"
    " its points out has not been tried here: compare the screen with the sheet.": (
        "И то и другое — до выключения УЧПУ и до движения любой оси: новое значение"
        " {at_magnification} умножает старые точки, новые номера отдают их другим участкам."
        " Параметры: {at_reference} = {reference_number}, {at_first} = {first_number},"
        " {at_last} = {last_number}, {at_magnification} = {magnification}, {at_spacing} ="
        " {spacing} {unit}, 1851 = {backlash} единиц измерения по {detection_unit}, {further}"
        " (только ось {address}; группы других осей не трогать). Данные шага: точки"
        " {first_number} … {last_number}: загрузите файл данных шага из папки tables/ или"
        " введите лист entry_{sheet}.csv. Принимает ли УЧПУ ту форму, в которой оно выдаёт свои"
        " точки, здесь не проверено: сравните экран с листом."
    ),
    "Alarm 000 (power off) is expected. Switch the control off and on: the parameters of the"
    " table are active only after that.": (
        "Ожидается сигнал 000 (отключить питание). Выключите и включите УЧПУ: параметры таблицы"
        " действуют только после этого."
    ),
    "Reference the axis": "Вывести ось в опорную позицию",
    "{referencing}": "{referencing}",
    "No page of the maker states the sign of pitch data. Before the full test measure two"
    " positions, {check_from} and {check_to} {unit}, with {at_magnification} ="
    " {magnification} and with {at_magnification} = 0 (power cycle each time): with"
    " compensation on, the distance must be {check_change} longer (negative: shorter). If it"
    " is the opposite, set the option pitch_sign to {other_sign} and run again.": (
        "Ни одна страница изготовителя не называет знак данных шага. До полной проверки"
        " измерьте две позиции, {check_from} и {check_to} {unit}, при {at_magnification} ="
        " {magnification} и при {at_magnification} = 0 (каждый раз выключить и включить): с"
        " компенсацией расстояние должно быть на {check_change} длиннее (минус: короче). Если"
        " наоборот, задайте опцию pitch_sign равной {other_sign} и выполните расчёт снова."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive 1851 moves on in the direction of"
    " the new motion.": (
        "Установите индикатор на ноль при подходе в {reference_return}, затем вернитесь с"
        " другой стороны: оставшаяся разница должна быть малой. Положительное значение 1851"
        " продолжает ход в направлении нового движения."
    ),
    "Save parameters and pitch data again and compare them with the plan: `compwright"
    " compare JOB_FOLDER --loaded READ_BACK`.": (
        "Снова сохраните параметры и данные шага и сравните их с планом: `compwright compare"
        " JOB_FOLDER --loaded READ_BACK`."
    ),
    "Load the saved parameters and pitch data in one step, then power cycle and reference as"
    " above. By hand: 1851 and {at_reference} to {at_spacing} as noted; {at_magnification} ="
    " 0 switches the points of axis {address} off.": (
        "Загрузите сохранённые параметры и данные шага за один раз, затем выключите, включите и"
        " выведите в опорную позицию, как выше. Вручную: 1851 и {at_reference} … {at_spacing}"
        " как записано; {at_magnification} = 0 выключает точки оси {address}."
    ),
    "straightness compensation is an option of the control, and its parameter numbers are"
    " not confirmed here: enter the two-point line by the machine's own manual": (
        "компенсация прямолинейности — опция УЧПУ, и номера её параметров здесь не"
        " подтверждены: введите прямую по двум точкам по руководству самого станка"
    ),
    "1851 of axis {address} = {backlash} detection units of {detection_unit}": (
        "1851 оси {address} = {backlash} единиц измерения по {detection_unit}"
    ),
    "1852 = {value} detection units ({active})": "1852 = {value} единиц измерения ({active})",
    "at rapid traverse; 1851 is active at cutting feed, because 1800#4 = 1": (
        "на быстром ходу; на рабочей подаче действует 1851, потому что 1800#4 = 1"
    ),
    "is not active and stays as it is: 1851 is active at all feeds, because 1800#4 = 0": (
        "не действует и остаётся как есть: 1851 действует на всех подачах, потому что 1800#4 = 0"
    ),
    "is active at rapid traverse if 1800#4 = 1, which is in no file": (
        "действует на быстром ходу, если 1800#4 = 1, чего нет ни в одном файле"
    ),
    "{sentence} Prove the sign with a square or a dial gauge, on and off, before production.": (
        "{sentence} Докажите знак до работы угольником или индикатором, с компенсацией и без."
    ),
    "{sentence} Its numbers and its sign are unconfirmed: prove them with a square or a dial"
    " gauge, on and off, before production.": (
        "{sentence} Его номера и знак не подтверждены: докажите их до работы угольником или"
        " индикатором, с компенсацией и без."
    ),
    "{output} over {input}: straightness compensation": (
        "{output} по {input}: компенсация прямолинейности"
    ),
    "every pair of straightness compensation (5711 to 5713) is in use": (
        "все пары компенсации прямолинейности (5711–5713) заняты"
    ),
    "straightness compensation counts the points of the pitch table of the moving axis {input},"
    " which has none. Next: give {input} a positioning test (`before`), or the control's files with"
    " its pitch data (`states`)": (
        "компенсация прямолинейности считает точки таблицы шага движущейся оси {input}, а таблицы"
        " нет. Далее: дайте для {input} проверку позиционирования (`before`) или файлы УЧПУ с"
        " данными шага (`states`)"
    ),
    "straightness compensation is known for one straight line over a table only": (
        "компенсация прямолинейности известна только для одной прямой по таблице"
    ),
    "Absolute encoder: no reference return. Leave its adjustment alone (1815): machine zero"
    " would be lost.": (
        "Абсолютный датчик: без выхода в опорную позицию. Его настройку не трогать (1815): нуль"
        " станка будет потерян."
    ),
    "owns {low} to {high} {unit}": "({low} … {high} {unit})",
    "A point holds the change of the correction over its own section, looking from - to +,"
    " in detection units times the magnification; at the reference position ({zero} {unit})"
    " the correction is 0.": (
        "Точка содержит изменение коррекции на своём участке, если смотреть от - к +, в"
        " единицах измерения, умноженных на множитель; в опорной позиции ({zero} {unit})"
        " коррекция равна 0."
    ),
    "it stands for the same section as point {last} and must hold the same value": (
        "она обозначает тот же участок, что и точка {last}, и должна содержать то же значение"
    ),
    "{parameter} = {number} {owns}, the last.": (
        "{parameter} = {number}: последний участок {owns}."
    ),
    "set too: {function}, whose points are in the sheet; its sign and where its period"
    " starts are unconfirmed, so measure one period in its sections with it and with 14985"
    " to 14987 = 0 (power cycle each time) before production": (
        "задано также: {function}, точки — в листе; знак и начало периода не подтверждены,"
        " поэтому до работы измерьте один период на его участках с ней и при 14985 … 14987 = 0"
        " (каждый раз выключить и включить)"
    ),
    "set too: {function}; its sign and unit are unconfirmed, so measure both ends of the"
    " travel with these amounts and with 0 (power cycle each time) before you switch on the"
    " whole table": (
        "задано также: {function}; знак и единица не подтверждены, поэтому измерьте оба конца"
        " хода с этими величинами и с 0 (каждый раз выключить и включить), прежде чем включать"
        " всю таблицу"
    ),
    "leave unchanged what is active in addition to the table: {kept}": (
        "оставить без изменений то, что действует в дополнение к таблице: {kept}"
    ),
    "{value} detection units": "{value} единиц измерения",
    "{parameter} = {reference} is the number of the reference: {owns}; {next} to {last} are"
    " the sections of one turn and add up to 0.": (
        "{parameter} = {reference} — номер опорной позиции: {owns}; {next} … {last} — участки"
        " одного оборота, их сумма 0."
    ),
    "{parameter} = {number} {owns}, the first.": "{parameter} = {number}: первый участок {owns}.",
    "For travel in - the same sections have the numbers {first} to {last} ({parameter}).": (
        "Для хода в - те же участки имеют номера {first} … {last} ({parameter})."
    ),
    "set too, because the grid moves and these positions stay: {kept}": (
        "задано также, потому что сетка сдвигается, а эти позиции остаются: {kept}"
    ),
    "{parameter} = {number} {owns}, at the reference.": (
        "{parameter} = {number}: участок {owns} у опорной позиции."
    ),
    "Point {number} holds {value}: its section lies beyond the travel.": (
        "Точка {number} содержит {value}: её участок за пределами хода."
    ),
    "it owns no section": "участка у него нет",
    "Bit 0 of 8135 (NPE) must be 0: 1 switches stored pitch error compensation off.": (
        "Бит 0 параметра 8135 (NPE) должен быть 0: 1 выключает сохранённую компенсацию"
        " погрешности шага."
    ),
    "3623 of axis {address}: the pitch data are multiplied by it, 0 switches the table off.": (
        "3623 оси {address}: данные шага умножаются на него, 0 выключает таблицу."
    ),
    "Were the pitch data loaded too? They come from another screen than the parameters;"
    " compare the points with the sheet.": (
        "Загружены ли и данные шага? Они идут с другого экрана, чем параметры; сравните точки с"
        " листом."
    ),
    "3620 to 3627 are active only after power off and on, and then, with an incremental"
    " encoder, only after the reference return.": (
        "3620 … 3627 действуют только после выключения и включения, а при инкрементном датчике"
        " — только после выхода в опорную позицию."
    ),
    "Save parameters and pitch data again and compare them with the plan (`compwright"
    " compare JOB_FOLDER --loaded READ_BACK`): 5420 to 5425, 1851 and the points tell apart"
    " what this test cannot.": (
        "Снова сохраните параметры и данные шага и сравните их с планом (`compwright compare"
        " JOB_FOLDER --loaded READ_BACK`): 5420 … 5425, 1851 и точки различают то, чего эта"
        " проверка не может."
    ),
    "5423 of axis {address}: the pitch data are multiplied by it, 0 switches the table off.": (
        "5423 оси {address}: данные шага умножаются на него, 0 выключает таблицу."
    ),
    "Were the pitch data loaded too? Compare the points with the sheet.": (
        "Загружены ли и данные шага? Сравните точки с листом."
    ),
    "5420 to 5425 are active only after power off and on, and then, with an incremental"
    " encoder, only after the reference return.": (
        "5420 … 5425 действуют только после выключения и включения, а при инкрементном датчике"
        " — только после выхода в опорную позицию."
    ),
    "No page of the maker states the sign of pitch data: compare 5423 as set with 5423 = 0"
    " as the card says; if the distance changes the wrong way, run again with the other"
    " pitch_sign.": (
        "Ни одна страница изготовителя не называет знак данных шага: сравните заданное 5423 с"
        " 5423 = 0, как говорит карта; если расстояние меняется не в ту сторону, выполните"
        " расчёт снова с другим pitch_sign."
    ),
    "Were the points typed in as errors? The sheet holds corrections, as steps from point to"
    " point.": (
        "Не введены ли точки как погрешности? Лист содержит коррекции, ступенями от точки к точке."
    ),
    "5423 of axis {address}: every point is multiplied by it.": (
        "5423 оси {address}: каждая точка умножается на него."
    ),
    "The detection unit of axis {address}: another one than the job's scales table and 1851"
    " alike, mostly by 10.": (
        "Единица измерения оси {address}: иная, чем в задании, одинаково масштабирует таблицу и"
        " 1851, чаще всего в 10 раз."
    ),
    "Bit 3 of 1006 (diameter): radius and diameter differ by 2.": (
        "Бит 3 параметра 1006 (диаметр): радиус и диаметр различаются в 2 раза."
    ),
    "5420 of axis {address}, the number of the point at the reference position: one too many"
    " moves the table by one interval (5424).": (
        "5420 оси {address}, номер точки в опорной позиции: на единицу больше — таблица"
        " сдвинута на один интервал (5424)."
    ),
    "Were the points typed in from the right number on? Number n stands for the section"
    " below the point n - 5420.": (
        "Введены ли точки с правильного номера? Номер n обозначает участок под точкой n - 5420."
    ),
    "Were the points typed in from the wrong end? Their numbers grow in the direction +,"
    " from 5421 to 5422, on both sides of the reference.": (
        "Не введены ли точки с другого конца? Их номера растут в направлении +, от 5421 до"
        " 5422, по обе стороны опорной позиции."
    ),
    "5420 to 5422 of all axes: they share one row of points, and the numbers of axis"
    " {address} must be its own.": (
        "5420 … 5422 всех осей: ряд точек у них общий, и номера оси {address} должны быть"
        " только её."
    ),
    "The A in the parameter file is the number of the controlled axis: {address} for {name}.": (
        "A в файле параметров — номер управляемой оси: {address} для {name}."
    ),
    "No second table is known here: what is active in one direction only is 1851.": (
        "Вторая таблица здесь неизвестна: только в одном направлении действует 1851."
    ),
    "1851 of axis {address}, in detection units.": "1851 оси {address}, в единицах измерения.",
    "It is active from the first move against the reference return on, so approach twice from"
    " each side before a reading counts.": (
        "Он действует с первого движения против выхода в опорную позицию, поэтому подойдите с"
        " каждой стороны дважды, прежде чем отсчёт считается."
    ),
    "5421 and 5422 of axis {address}, the points farthest in - and in +: beyond them the"
    " table does not go on.": (
        "5421 и 5422 оси {address}, крайние точки в - и в +: дальше таблица не продолжается."
    ),
    "Are all points between them in the control? Compare the screen with the sheet, point by"
    " point.": ("Все ли точки между ними в УЧПУ? Сравните экран с листом, точка за точкой."),
    "Save parameters and pitch data again and compare both with the plan (`compwright"
    " compare JOB_FOLDER --loaded READ_BACK`): 3620 to 3625, 1851 and the points tell apart"
    " what this test cannot.": (
        "Снова сохраните параметры и данные шага и сравните то и другое с планом (`compwright"
        " compare JOB_FOLDER --loaded READ_BACK`): 3620 … 3625, 1851 и точки различают то, чего"
        " эта проверка не может."
    ),
    "No page of the maker states the sign of pitch data: compare 3623 as set with 3623 = 0"
    " as the card says; if the distance changes the wrong way, run again with the other"
    " pitch_sign.": (
        "Ни одна страница изготовителя не называет знак данных шага: сравните заданное 3623 с"
        " 3623 = 0, как говорит карта; если расстояние меняется не в ту сторону, выполните"
        " расчёт снова с другим pitch_sign."
    ),
    "3623 of axis {address}: every point is multiplied by it.": (
        "3623 оси {address}: каждая точка умножается на него."
    ),
    "The detection unit of axis {address} (1820 with 1013): another one than the plan's"
    " scales table and 1851 alike, mostly by 10.": (
        "Единица измерения оси {address} (1820 с 1013): иная, чем в плане, одинаково"
        " масштабирует таблицу и 1851, чаще всего в 10 раз."
    ),
    "3620 of axis {address}, the number of the point at the reference position: one too many"
    " moves the table by one interval (3624).": (
        "3620 оси {address}, номер точки в опорной позиции: на единицу больше — таблица"
        " сдвинута на один интервал (3624)."
    ),
    "Were the points typed in from the right number on? Number n stands for the section"
    " below the point n - 3620.": (
        "Введены ли точки с правильного номера? Номер n обозначает участок под точкой n - 3620."
    ),
    "Were the points typed in from the wrong end? Their numbers grow in the direction +,"
    " from 3621 to 3622, on both sides of the reference.": (
        "Не введены ли точки с другого конца? Их номера растут в направлении +, от 3621 до"
        " 3622, по обе стороны опорной позиции."
    ),
    "3620 to 3622 of all axes: they share one row of points, and the numbers of axis"
    " {address} must be its own.": (
        "3620 … 3622 всех осей: ряд точек у них общий, и номера оси {address} должны быть"
        " только её."
    ),
    "Bit 0 of 3605 of axis {address}: with 1 there are two tables, and the points from 3626"
    " on act while it travels in -.": (
        "Бит 0 параметра 3605 оси {address}: при 1 таблиц две, и точки с 3626 действуют при"
        " ходе в -."
    ),
    "3627 ties the second table at the reference position: a wrong value moves one direction"
    " as a whole.": (
        "3627 привязывает вторую таблицу в опорной позиции: неверное значение сдвигает одно"
        " направление целиком."
    ),
    "1851 of axis {address}, in detection units; where bit 4 of 1800 is 1, 1852 is active in"
    " its place at rapid traverse.": (
        "1851 оси {address}, в единицах измерения; где бит 4 параметра 1800 равен 1, на быстром"
        " ходу вместо него действует 1852."
    ),
    "With two tables (bit 0 of 3605) 1851 is active in addition to them, and must be 0 where"
    " the tables hold the reversal.": (
        "С двумя таблицами (бит 0 параметра 3605) 1851 действует дополнительно и должен быть 0,"
        " где они содержат реверс."
    ),
    "3621 and 3622 of axis {address}, the points farthest in - and in +: beyond them the"
    " table does not go on.": (
        "3621 и 3622 оси {address}, крайние точки в - и в +: дальше таблица не продолжается."
    ),
    "{label}: bidirectional compensation": "{label}: компенсация в обоих направлениях",
    "as 3605#0, 3626 and 3627 are understood": "как понимаются 3605#0, 3626 и 3627",
    "no manual page": "ни одной страницы руководства",
    "no file says what the numbers {numbers} hold; give all of the control's pitch data, or"
    " first_point": (
        "ни один файл не говорит, что содержат номера {numbers}; дайте все данные шага УЧПУ или"
        " first_point"
    ),
    "at most {gap} in a row": "не более {gap} подряд",
    "point numbers for its table": "номера точек для её таблицы",
    "not checked: the option max_feed is not given, and no file says the rapid traverse (1420)": (
        "не проверено: опция max_feed не задана, и ни один файл не называет быстрый ход (1420)"
    ),
    "smallest interval for its feed": "наименьший интервал для её подачи",
    "{label}: detection unit": "{label}: единица измерения",
    "1820 = {multiplier} (CMR {cmr}) and {system} = {setting} (least command increment {least}"
    " {unit}{inch})": (
        "1820 = {multiplier} (CMR {cmr}) и {system} = {setting} (наименьшее приращение команды"
        " {least} {unit}{inch})"
    ),
    ", inch machine by 1001#0": ", дюймовый станок по 1001#0",
    "read: {evidence}": "прочитано: {evidence}",
    "FANUC 0i-A to C, 16i/18i/21i, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-A до C, 16i/18i/21i, запомненная компенсация погрешности шага с компенсацией"
        " люфта (1851)"
    ),
    "FANUC 0i-D, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-D, запомненная компенсация погрешности шага с компенсацией люфта (1851)"
    ),
    "FANUC 0i-F, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-F, запомненная компенсация погрешности шага с компенсацией люфта (1851)"
    ),
    "FANUC 15i, stored pitch error compensation with backlash (1851), all numbers unconfirmed": (
        "FANUC 15i, запомненная компенсация погрешности шага с компенсацией люфта (1851), все"
        " номера не подтверждены"
    ),
    "FANUC 30i/31i/32i, stored pitch error compensation with backlash (1851)": (
        "FANUC 30i/31i/32i, запомненная компенсация погрешности шага с компенсацией люфта (1851)"
    ),
    "A-78868E pages 3 and 6 for a rotary worm: numbers in the array of pitch data,"
    " increments, sum 0; sign, 3623 and where the period starts: not on these pages": (
        "A-78868E, с. 3 и 6, для поворотной оси с червяком: номера в массиве данных шага,"
        " приращения, сумма 0; знак, 3623 и начало периода на этих страницах не указаны"
    ),
    "B-63522EN/02 page 222: numbers of pitch points, amounts in detection units, added at"
    " the pitch intervals; sign of the pitch data, and that 3623 does not multiply it:"
    " general knowledge": (
        "B-63522EN/02, с. 222: номера точек шага, величины в единицах датчика, прибавляются на"
        " интервалах шага; знак как у данных шага и то, что 3623 их не умножает: по общим сведениям"
    ),
    "F1, the sentence is cut": "F1, фраза обрезана",
    "F1: the reference position has a point number; no manual states that the sections"
    " follow 1240": (
        "F1: референтная позиция имеет номер точки; ни одно руководство не говорит, что участки"
        " следуют за 1240"
    ),
    "inferred from a note printed next to F16 and from F20; no sentence of the maker: prove"
    " it on the machine as the card says": (
        "выведено из примечания рядом с F16 и из F20; фразы изготовителя нет: проверить на"
        " станке, как указано в карте"
    ),
    "general knowledge, that of the later series": "по общим сведениям, как у более поздних серий",
    "general knowledge: 7 on 0i-A to C, 16i, 18i, 21i and 15i": (
        "по общим сведениям: 7 у 0i-A до C, 16i, 18i, 21i и 15i"
    ),
    "general knowledge: 7, as on the 0i-D": "по общим сведениям: 7, как у 0i-D",
    "general knowledge: parameters 5711, 5721, 5731 to 5734, 5761 to 5764": (
        "по общим сведениям: параметры 5711, 5721, 5731–5734, 5761–5764"
    ),
    "general knowledge: the interval must be at least the largest feed / 7500": (
        "по общим сведениям: интервал не меньше наибольшей подачи / 7500"
    ),
    "{first} to {last} ({count} numbers)": "{first}–{last} (номеров: {count})",
    "not in the files that were given": "нет в переданных файлах",
    "step": "шаг (step)",
    "1800#4 is not in the files": ("1800#4 нет в файлах"),
    "the bit that makes 1852 active is unknown": ("бит, который включает 1852, неизвестен"),
    "1821 = {count} detection units of {size} {unit} between two marks, encoder on"
    " the motor (1815#1 = 0); inferred": (
        "1821 = {count} единиц измерения по {size} {unit} между двумя метками, датчик на двигателе"
        " (1815#1 = 0); выведено"
    ),
}
