"""Russian texts for the controls of `formats.families.lists`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Keep copies of the compensation value lists, of the axis parameter lists and of the"
    " start-up list.": (
        "Сохраните копии списков значений компенсации, списков параметров осей и списка запуска."
    ),
    "Load the list": "Загрузить список",
    "tables/ holds the list of axis {address}: {points} entries from {start} to {end},"
    " counted in {counts}, both directions (bilateral 1). Copy it over the list that the"
    " start-up list names for this axis. For a new list a start-up list that is not in"
    " tables/ needs achs_kw_log_ax_nr[i] {address} and achs_kw[i] with the name of the file,"
    " i the next free index, and zahl_kw one more; the TwinCAT configurator writes these"
    " itself.": (
        "tables/ содержит список оси {address}: точек {points}, от {start} до {end}, счёт в"
        " {counts}, оба направления (bilateral 1). Скопируйте его на место списка, который"
        " список запуска называет для этой оси. Для нового списка в списке запуска, которого"
        " нет в tables/, нужны achs_kw_log_ax_nr[i] {address} и achs_kw[i] с именем файла, i —"
        " следующий свободный индекс, и zahl_kw на единицу больше; конфигуратор TwinCAT пишет"
        " их сам."
    ),
    "Reversal is in the table": "Реверс в таблице",
    "The two columns hold the reversal: getriebe[0].lose of axis {address} must be 0, or"
    " lr_param.anwahl_losekomp 0. Where the axis parameter list was given, tables/ holds it"
    " so: load it too.": (
        "Два столбца содержат реверс: getriebe[0].lose оси {address} должно быть 0, или"
        " lr_param.anwahl_losekomp 0. Если список параметров оси был дан, он такой в tables/:"
        " загрузите и его."
    ),
    "Switch on": "Включить",
    "lr_param.ssfk 1 in the parameter list of axis {address}, kw.ssfk.manual_activation 0 or"
    " absent.": (
        "lr_param.ssfk 1 в списке параметров оси {address}, kw.ssfk.manual_activation 0 или"
        " отсутствует."
    ),
    "Restart or reload": "Перезапустить или загрузить заново",
    "Restart the control, or reload the lists. {referencing} A value of max_points cannot"
    " change after the start (error 110638).": (
        "Перезапустите УЧПУ или загрузите списки заново. {referencing} Значение max_points"
        " после запуска менять нельзя (ошибка 110638)."
    ),
    "Check the sign before anything else moves": "Проверить знак до любого другого движения",
    "That the values are {values}s is not proven. Reference axis {name}, keep clear of"
    " everything. Go to {check_from} {axis_unit}, then to {check_to} {axis_unit}, arriving"
    " in + both times, and measure the distance: once with the compensation off, once with"
    " it on ({name}[COMP OFF LEAD] and {name}[COMP ON LEAD] in the NC program, the axis as"
    " the program calls it). Switched on, the distance must change by {check_change}. If it"
    " changes by the opposite, restore the old list, set the option table_values to the"
    " other choice and run again.": (
        "Что значения имеют смысл {values}, не доказано. Выведите ось {name} в опорную позицию,"
        " держитесь от всего подальше. Переместите в {check_from} {axis_unit}, затем в"
        " {check_to} {axis_unit}, оба раза с подходом в +, и измерьте расстояние: один раз с"
        " выключенной, один раз с включённой компенсацией ({name}[COMP OFF LEAD] и {name}[COMP"
        " ON LEAD] в программе ЧПУ, ось как её называет программа). При включении расстояние"
        " должно измениться на {check_change}. Если оно меняется наоборот, верните старый"
        " список, задайте другое значение опции table_values и выполните расчёт снова."
    ),
    "With {name}[COMP OFF LEAD] and {name}[COMP ON LEAD] compare the check positions (their"
    " table stands with the axis), arriving in + and in -. The displayed position does not"
    " show the compensation: use the instrument.": (
        "С {name}[COMP OFF LEAD] и {name}[COMP ON LEAD] сравните контрольные позиции (их"
        " таблица — у оси), с подходом в + и в −. Показываемая позиция не содержит компенсации:"
        " пользуйтесь прибором."
    ),
    "Copy the compensation value lists, the axis parameter lists and the start-up list from the"
    " control again and compare them with the plan: `compwright compare JOB_FOLDER --loaded"
    " READ_BACK`.": (
        "Снова скопируйте с УЧПУ списки значений компенсации, списки параметров осей и список"
        " запуска и сравните их с планом: `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "Load the saved lists and restart.": "Загрузите сохранённые списки и перезапустите.",
    "no list of this control can be written with it": (
        "с этим не может быть записан ни один список этого УЧПУ"
    ),
    "Load {files}: {error} is in the list of axis {corrected}, whose master is axis"
    " {master}. lr_param.crosscomp 1 in the parameter list of axis {corrected}; restart or"
    " reload, and reference both axes: no compensation is active before that {input} is"
    " referenced. Outside the table its end values should stay; no page says it. Work"
    " offsets of {output} shift with {input}: probe them again.": (
        "Загрузите {files}: {error} — в списке оси {corrected}, ведущая ось которого — ось"
        " {master}. lr_param.crosscomp 1 в списке параметров оси {corrected}; перезапустите или"
        " загрузите заново и выведите обе оси в опорную позицию: компенсация не действует, пока"
        " {input} не в опорной позиции. Вне таблицы должны сохраняться её крайние значения; ни"
        " одна страница этого не говорит. Смещения нуля {output} сдвигаются вместе с {input}:"
        " измерьте их щупом заново."
    ),
    "{output} over {input}": "{output} по {input}",
    "{output} over {input}: check the sign": "{output} по {input}: проверить знак",
    "{output} over {input}: load": "{output} по {input}: загрузить",
    "No page says in which direction a value of kw.crosscomp moves axis {output};"
    " cross_values: {meaning} is what the job says. Before production, keep clear of"
    " everything, with a dial gauge on {output}: {output}[COMP OFF CROSS], go with {input}"
    " from {start} to {end}, read it; then the same with {output}[COMP ON CROSS]. What is"
    " new must move {output} by {change} {unit} on this way, in addition to the effect of"
    " the old list. If it is the opposite: restore the old list and run again with the other"
    " one.": (
        "Ни одна страница не говорит, в каком направлении значение kw.crosscomp перемещает ось"
        " {output}; cross_values: {meaning} — по заданию. До работы держитесь от всего"
        " подальше, с индикатором на {output}: {output}[COMP OFF CROSS], пройдите по {input} от"
        " {start} до {end}, прочитайте; затем то же с {output}[COMP ON CROSS]. Новое должно"
        " переместить {output} на {change} {unit} на этом пути, в дополнение к действию старого"
        " списка. Если наоборот: верните старый список и выполните расчёт снова с другим"
        " значением."
    ),
    "0.1 µm (rotary 0.0001 deg)": "0.1 мкм (поворотная ось 0.0001°)",
    "encoder increments (kw.ssfk.unit 0)": "импульсах датчика (kw.ssfk.unit 0)",
    "{name}[COMP OFF LEAD] and {name}[COMP ON LEAD] in an NC program switch only this"
    " table off and on: measure a check position of the card in both states. The displayed"
    " position does not change.": (
        "{name}[COMP OFF LEAD] и {name}[COMP ON LEAD] в программе ЧПУ выключают и включают"
        " только эту таблицу: измерьте контрольную позицию карты в обоих состояниях. Показываемая"
        " позиция не меняется."
    ),
    "lr_param.ssfk of axis {address} must be 1 and kw.ssfk.manual_activation 0 (with 1 only"
    " a program switches it on). A table that a program switched off stays off after the"
    " program ends.": (
        "lr_param.ssfk оси {address} должно быть 1, а kw.ssfk.manual_activation 0 (при 1 её"
        " включает только программа). Таблица, которую выключила программа, остаётся выключенной"
        " и после конца программы."
    ),
    "The axis must be referenced.": "Ось должна быть выведена в опорную позицию.",
    "The start-up list must name the file: achs_kw_log_ax_nr[i] {address} and achs_kw[i], i"
    " below zahl_kw; lists are read at the start.": (
        "Список запуска должен называть файл: achs_kw_log_ax_nr[i] {address} и achs_kw[i], i"
        " меньше zahl_kw; списки читаются при запуске."
    ),
    "That the values are errors is not proven: compare COMP OFF LEAD with COMP ON LEAD as"
    " the card says; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Что значения — погрешности, не доказано: сравните COMP OFF LEAD с COMP ON LEAD, как"
        " говорит карта; если расстояние меняется не в ту сторону, выполните расчёт снова с"
        " другим table_values."
    ),
    "kw.ssfk.unit: 1 counts 0.1 µm (0.0001 degrees), 0 encoder increments, for positions and"
    " values.": (
        "kw.ssfk.unit: 1 — счёт в 0.1 мкм (0.0001 градуса), 0 — в импульсах датчика, для"
        " позиций и значений."
    ),
    "kw.ssfk.kw_startpos and kw.ssfk.interval, or with interval 0 the setpoint of each entry.": (
        "kw.ssfk.kw_startpos и kw.ssfk.interval, или при интервале 0 заданное значение каждой"
        " записи."
    ),
    "Entry 0 stands at kw.ssfk.kw_startpos, the others above it: were they entered from the"
    " other end?": (
        "Запись 0 находится в kw.ssfk.kw_startpos, остальные выше: не введены ли они с другого"
        " конца?"
    ),
    "kopf.achs_nr in the list and achs_kw_log_ax_nr[i] in the start-up list: the logical"
    " number {address}.": (
        "kopf.achs_nr в списке и achs_kw_log_ax_nr[i] в списке запуска: логический номер {address}."
    ),
    "kw.ssfk.bilateral: with 1 the column pos is active in + and neg in -, with 0 there is"
    " one column.": (
        "kw.ssfk.bilateral: при 1 столбец pos действует в +, а neg в -, при 0 столбец один."
    ),
    "getriebe[0].lose and lr_param.anwahl_losekomp of axis {address}: a table with two"
    " columns takes their place, so one of them must be 0.": (
        "getriebe[0].lose и lr_param.anwahl_losekomp оси {address}: таблица с двумя столбцами"
        " заменяет их, поэтому одно из них должно быть 0."
    ),
    "kw.ssfk.kw_nr_max is the number of entries, 0 to n - 1; beyond the table its end values"
    " stay.": (
        "kw.ssfk.kw_nr_max — число записей, 0 … n - 1; за таблицей сохраняются её крайние значения."
    ),
    "kw.ssfk.max_points must be larger; it cannot change after the start (error 110638).": (
        "kw.ssfk.max_points должно быть больше; после запуска его менять нельзя (ошибка 110638)."
    ),
    "in no list that was given": "ни в одном данном списке",
    "{label}: {fact}": "{label}: {fact}",
    "ISG kernel (Beckhoff TwinCAT 3 CNC), compensation value lists kw.ssfk and kw.crosscomp": (
        "Ядро ISG (Beckhoff TwinCAT 3 CNC), списки значений компенсации kw.ssfk и kw.crosscomp"
    ),
    "B19 names them correction and does not define it": (
        "в B19 они названы коррекцией без определения"
    ),
    "{label}: its table over axis {over}": ("{label}: таблица по оси {over}"),
    "the meaning of its values is unknown; give the option {option} after the check on the card": (
        "смысл значений неизвестен; укажите опцию {option} после проверки по карте"
    ),
}
