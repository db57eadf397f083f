"""German texts for the controls of `formats.families.lists`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Keep copies of the compensation value lists, of the axis parameter lists and of the"
    " start-up list.": (
        "Kopien der Kompensationswertlisten, der Achsparameterlisten und der Hochlaufliste"
        " aufheben."
    ),
    "Load the list": "Liste laden",
    "tables/ holds the list of axis {address}: {points} entries from {start} to {end},"
    " counted in {counts}, both directions (bilateral 1). Copy it over the list that the"
    " start-up list names for this axis. For a new list a start-up list that is not in"
    " tables/ needs achs_kw_log_ax_nr[i] {address} and achs_kw[i] with the name of the file,"
    " i the next free index, and zahl_kw one more; the TwinCAT configurator writes these"
    " itself.": (
        "tables/ enthält die Liste der Achse {address}: {points} Einträge von {start} bis"
        " {end}, gezählt in {counts}, beide Richtungen (bilateral 1). Sie über die Liste"
        " kopieren, die die Hochlaufliste für diese Achse nennt. Für eine neue Liste braucht"
        " eine Hochlaufliste, die nicht in tables/ ist, achs_kw_log_ax_nr[i] {address} und"
        " achs_kw[i] mit dem Namen der Datei, i der nächste freie Index, und zahl_kw um eins"
        " mehr; der TwinCAT-Konfigurator schreibt sie selbst."
    ),
    "Reversal is in the table": "Die Umkehr steht in der Tabelle",
    "The two columns hold the reversal: getriebe[0].lose of axis {address} must be 0, or"
    " lr_param.anwahl_losekomp 0. Where the axis parameter list was given, tables/ holds it"
    " so: load it too.": (
        "Die beiden Spalten enthalten die Umkehr: getriebe[0].lose der Achse {address} muss 0"
        " sein, oder lr_param.anwahl_losekomp 0. War die Achsparameterliste angegeben, ist sie"
        " so in tables/: auch sie laden."
    ),
    "Switch on": "Einschalten",
    "lr_param.ssfk 1 in the parameter list of axis {address}, kw.ssfk.manual_activation 0 or"
    " absent.": (
        "lr_param.ssfk 1 in der Parameterliste der Achse {address}, kw.ssfk.manual_activation 0"
        " oder nicht vorhanden."
    ),
    "Restart or reload": "Neu starten oder neu laden",
    "Restart the control, or reload the lists. {referencing} A value of max_points cannot"
    " change after the start (error 110638).": (
        "Die Steuerung neu starten oder die Listen neu laden. {referencing} Ein Wert von"
        " max_points kann nach dem Start nicht geändert werden (Fehler 110638)."
    ),
    "Check the sign before anything else moves": (
        "Das Vorzeichen prüfen, bevor sich etwas anderes bewegt"
    ),
    "That the values are {values}s is not proven. Reference axis {name}, keep clear of"
    " everything. Go to {check_from} {axis_unit}, then to {check_to} {axis_unit}, arriving"
    " in + both times, and measure the distance: once with the compensation off, once with"
    " it on ({name}[COMP OFF LEAD] and {name}[COMP ON LEAD] in the NC program, the axis as"
    " the program calls it). Switched on, the distance must change by {check_change}. If it"
    " changes by the opposite, restore the old list, set the option table_values to the"
    " other choice and run again.": (
        "Dass die Werte {values} bedeuten, ist nicht bewiesen. Achse {name} referenzieren, von"
        " allem freihalten. Nach {check_from} {axis_unit} fahren, dann nach {check_to}"
        " {axis_unit}, beide Male in + anfahren, und den Abstand messen: einmal mit"
        " ausgeschalteter, einmal mit eingeschalteter Kompensation ({name}[COMP OFF LEAD] und"
        " {name}[COMP ON LEAD] im NC-Programm, die Achse, wie das Programm sie nennt)."
        " Eingeschaltet muss sich der Abstand um {check_change} ändern. Ändert er sich"
        " umgekehrt, die alte Liste zurückladen, die Option table_values auf den anderen Wert"
        " setzen und noch einmal ausführen."
    ),
    "With {name}[COMP OFF LEAD] and {name}[COMP ON LEAD] compare the check positions (their"
    " table stands with the axis), arriving in + and in -. The displayed position does not"
    " show the compensation: use the instrument.": (
        "Mit {name}[COMP OFF LEAD] und {name}[COMP ON LEAD] die Prüfpositionen vergleichen"
        " (ihre Tabelle steht bei der Achse), in + und in − angefahren. Die angezeigte Position"
        " enthält die Kompensation nicht: das Messgerät benutzen."
    ),
    "Copy the compensation value lists, the axis parameter lists and the start-up list from the"
    " control again and compare them with the plan: `compwright compare JOB_FOLDER --loaded"
    " READ_BACK`.": (
        "Die Kompensationswertlisten, die Achsparameterlisten und die Hochlaufliste noch einmal"
        " von der Steuerung kopieren und mit dem Plan vergleichen: `compwright compare JOB_FOLDER"
        " --loaded READ_BACK`."
    ),
    "Load the saved lists and restart.": "Die gesicherten Listen laden und neu starten.",
    "no list of this control can be written with it": (
        "keine Liste dieser Steuerung kann damit geschrieben werden"
    ),
    "Load {files}: {error} is in the list of axis {corrected}, whose master is axis"
    " {master}. lr_param.crosscomp 1 in the parameter list of axis {corrected}; restart or"
    " reload, and reference both axes: no compensation is active before that {input} is"
    " referenced. Outside the table its end values should stay; no page says it. Work"
    " offsets of {output} shift with {input}: probe them again.": (
        "{files} laden: {error} ist in der Liste der Achse {corrected}, deren Masterachse Achse"
        " {master} ist. lr_param.crosscomp 1 in der Parameterliste der Achse {corrected}; neu"
        " starten oder neu laden und beide Achsen referenzieren: Es ist keine Kompensation"
        " aktiv, bevor {input} referenziert ist. Außerhalb der Tabelle sollten ihre Endwerte"
        " bleiben; keine Seite sagt es. Nullpunktverschiebungen von {output} wandern mit"
        " {input}: neu antasten."
    ),
    "{output} over {input}": "{output} über {input}",
    "{output} over {input}: check the sign": "{output} über {input}: Vorzeichen prüfen",
    "{output} over {input}: load": "{output} über {input}: laden",
    "No page says in which direction a value of kw.crosscomp moves axis {output};"
    " cross_values: {meaning} is what the job says. Before production, keep clear of"
    " everything, with a dial gauge on {output}: {output}[COMP OFF CROSS], go with {input}"
    " from {start} to {end}, read it; then the same with {output}[COMP ON CROSS]. What is"
    " new must move {output} by {change} {unit} on this way, in addition to the effect of"
    " the old list. If it is the opposite: restore the old list and run again with the other"
    " one.": (
        "Keine Seite sagt, in welcher Richtung ein Wert von kw.crosscomp die Achse {output}"
        " bewegt; cross_values: {meaning} sagt der Auftrag. Vor der Produktion von allem"
        " freihalten, mit einer Messuhr an {output}: {output}[COMP OFF CROSS], mit {input} von"
        " {start} nach {end} fahren, ablesen; dann dasselbe mit {output}[COMP ON CROSS]. Das"
        " Neue muss {output} auf diesem Weg um {change} {unit} bewegen, zusätzlich zur Wirkung"
        " der alten Liste. Ist es umgekehrt: die alte Liste zurückladen und mit dem anderen"
        " Wert noch einmal ausführen."
    ),
    "0.1 µm (rotary 0.0001 deg)": "0.1 µm (Drehachse 0.0001°)",
    "encoder increments (kw.ssfk.unit 0)": "Geberinkrementen (kw.ssfk.unit 0)",
    "{name}[COMP OFF LEAD] and {name}[COMP ON LEAD] in an NC program switch only this"
    " table off and on: measure a check position of the card in both states. The displayed"
    " position does not change.": (
        "{name}[COMP OFF LEAD] und {name}[COMP ON LEAD] in einem NC-Programm schalten nur"
        " diese Tabelle aus und ein: eine Prüfposition der Karte in beiden Zuständen messen. Die"
        " angezeigte Position ändert sich nicht."
    ),
    "lr_param.ssfk of axis {address} must be 1 and kw.ssfk.manual_activation 0 (with 1 only"
    " a program switches it on). A table that a program switched off stays off after the"
    " program ends.": (
        "lr_param.ssfk der Achse {address} muss 1 sein und kw.ssfk.manual_activation 0 (mit 1"
        " schaltet nur ein Programm sie ein). Eine Tabelle, die ein Programm ausgeschaltet hat,"
        " bleibt nach dem Ende des Programms aus."
    ),
    "The axis must be referenced.": "Die Achse muss referenziert sein.",
    "The start-up list must name the file: achs_kw_log_ax_nr[i] {address} and achs_kw[i], i"
    " below zahl_kw; lists are read at the start.": (
        "Die Hochlaufliste muss die Datei nennen: achs_kw_log_ax_nr[i] {address} und"
        " achs_kw[i], i kleiner als zahl_kw; Listen werden beim Start gelesen."
    ),
    "That the values are errors is not proven: compare COMP OFF LEAD with COMP ON LEAD as"
    " the card says; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Dass die Werte Fehler sind, ist nicht bewiesen: COMP OFF LEAD mit COMP ON LEAD"
        " vergleichen, wie die Karte sagt; ändert sich der Abstand falsch herum, mit dem"
        " anderen table_values noch einmal ausführen."
    ),
    "kw.ssfk.unit: 1 counts 0.1 µm (0.0001 degrees), 0 encoder increments, for positions and"
    " values.": (
        "kw.ssfk.unit: 1 zählt 0.1 µm (0.0001 Grad), 0 Geberinkremente, für Positionen und Werte."
    ),
    "kw.ssfk.kw_startpos and kw.ssfk.interval, or with interval 0 the setpoint of each entry.": (
        "kw.ssfk.kw_startpos und kw.ssfk.interval, oder bei Intervall 0 der Sollwert jedes"
        " Eintrags."
    ),
    "Entry 0 stands at kw.ssfk.kw_startpos, the others above it: were they entered from the"
    " other end?": (
        "Eintrag 0 liegt bei kw.ssfk.kw_startpos, die anderen darüber: Wurden sie vom anderen"
        " Ende an eingegeben?"
    ),
    "kopf.achs_nr in the list and achs_kw_log_ax_nr[i] in the start-up list: the logical"
    " number {address}.": (
        "kopf.achs_nr in der Liste und achs_kw_log_ax_nr[i] in der Hochlaufliste: die logische"
        " Nummer {address}."
    ),
    "kw.ssfk.bilateral: with 1 the column pos is active in + and neg in -, with 0 there is"
    " one column.": (
        "kw.ssfk.bilateral: Mit 1 wirkt die Spalte pos in + und neg in -, mit 0 gibt es eine"
        " Spalte."
    ),
    "getriebe[0].lose and lr_param.anwahl_losekomp of axis {address}: a table with two"
    " columns takes their place, so one of them must be 0.": (
        "getriebe[0].lose und lr_param.anwahl_losekomp der Achse {address}: Eine Tabelle mit"
        " zwei Spalten ersetzt sie, deshalb muss eines davon 0 sein."
    ),
    "kw.ssfk.kw_nr_max is the number of entries, 0 to n - 1; beyond the table its end values"
    " stay.": (
        "kw.ssfk.kw_nr_max ist die Anzahl der Einträge, 0 bis n - 1; jenseits der Tabelle"
        " bleiben ihre Endwerte."
    ),
    "kw.ssfk.max_points must be larger; it cannot change after the start (error 110638).": (
        "kw.ssfk.max_points muss größer sein; es kann nach dem Start nicht geändert werden"
        " (Fehler 110638)."
    ),
    "in no list that was given": "in keiner angegebenen Liste",
    "{label}: {fact}": "{label}: {fact}",
    "ISG kernel (Beckhoff TwinCAT 3 CNC), compensation value lists kw.ssfk and kw.crosscomp": (
        "ISG-Kernel (Beckhoff TwinCAT 3 CNC), Listen der Kompensationswerte kw.ssfk und"
        " kw.crosscomp"
    ),
    "B19 names them correction and does not define it": (
        "B19 nennt sie Korrektur und erklärt das nicht"
    ),
    "{label}: its table over axis {over}": ("{label}: ihre Tabelle über Achse {over}"),
    "the meaning of its values is unknown; give the option {option} after the check on the card": (
        "die Bedeutung ihrer Werte ist unbekannt; nach der Kontrolle auf der Karte die "
        "Option {option} angeben"
    ),
}
