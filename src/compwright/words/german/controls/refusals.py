"""German reasons why a correction between axes is refused, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "0 in the switch, or the values before the switch or in a file of their own, as the control"
    " exports them (NC_CEC.INI)": (
        "0 im Schalter, oder die Werte vor dem Schalter oder in einer eigenen Datei, wie die"
        " Steuerung sie ausgibt (NC_CEC.INI)"
    ),
    "CEC table {index} has to be written, but the control multiplies it by table {other}"
    " ($AN_CEC_MULT_BY_TABLE)": (
        "CEC-Tabelle {index} müsste geschrieben werden, aber die Steuerung multipliziert sie mit"
        " Tabelle {other} ($AN_CEC_MULT_BY_TABLE)"
    ),
    "CEC table {index} needs more points than MD18342 reserves": (
        "CEC-Tabelle {index} braucht mehr Punkte, als MD18342 reserviert"
    ),
    "CEC table {index} needs more points than a table can have": (
        "CEC-Tabelle {index} braucht mehr Punkte, als eine Tabelle haben kann"
    ),
    "CEC table {index}: this file switches the table on (SD41300, MD32710) before it gives the"
    " values. A table that is on is protected, so the control takes none of these values": (
        "CEC-Tabelle {index}: Diese Datei schaltet die Tabelle ein (SD41300, MD32710), bevor die"
        " Werte kommen. Eine eingeschaltete Tabelle ist geschützt, die Steuerung übernimmt also"
        " keinen dieser Werte"
    ),
    "`cec: absent`, or {parameter}": "`cec: absent`, oder {parameter}",
    "`cec_tables` does not name it": "`cec_tables` nennt sie nicht",
    "a cross-axis table contains one curve, which is the same for both directions": (
        "eine Tabelle zwischen Achsen enthält eine Kurve, die für beide Richtungen dieselbe ist"
    ),
    "add the file with MD18342 to the control's files, or {step}": (
        "die Datei mit MD18342 zu den Dateien der Steuerung hinzufügen, oder {step}"
    ),
    "add the file with {name} to the control's files (`states` or `--state`)": (
        "die Datei mit {name} zu den Dateien der Steuerung hinzufügen (`states` oder `--state`)"
    ),
    "add {index} to `cec_tables`, so that it is changed in place": (
        "{index} in `cec_tables` aufnehmen, damit sie selbst geändert wird"
    ),
    "at most {value}": "höchstens {value}",
    "axis {name}: {control} needs a CEC table that is free or already belongs to this axis": (
        "Achse {name}: {control} braucht eine CEC-Tabelle, die frei ist oder schon zu dieser Achse"
        " gehört"
    ),
    "axis {name}: {control} needs {needed} CEC tables that are free or already belong to this"
    " axis": (
        "Achse {name}: {control} braucht {needed} CEC-Tabellen, die frei sind oder schon zu dieser"
        " Achse gehören"
    ),
    "axis {output}: with the correction over {inputs}, the sum of all CEC tables of this axis"
    " would exceed CEC_MAX_SUM (MD32720)": (
        "Achse {output}: Mit der Korrektur über {inputs} würde die Summe aller CEC-Tabellen dieser"
        " Achse CEC_MAX_SUM (MD32720) überschreiten"
    ),
    "correct this table in the control and export the files again": (
        "diese Tabelle in der Steuerung berichtigen und die Dateien noch einmal ausgeben"
    ),
    "end the travel of {input} in the job at a point of the table (multiples of {spacing} from"
    " {first})": (
        "den Verfahrweg von {input} im Auftrag an einem Punkt der Tabelle enden lassen (Vielfache"
        " von {spacing} ab {first})"
    ),
    "export the CEC tables into a file of their own (NC_CEC.INI), then give that file": (
        "die CEC-Tabellen in eine eigene Datei ausgeben (NC_CEC.INI), dann diese Datei angeben"
    ),
    "free indices in `cec_tables`, at least {needed}": (
        "freie Indizes in `cec_tables`, mindestens {needed}"
    ),
    "give a larger `spacing` under `table`": "einen größeren `spacing` unter `table` angeben",
    "give fewer points in this entry of `cross`": (
        "in diesem Eintrag von `cross` weniger Punkte angeben"
    ),
    "give other indices in `cec_tables`; or, if the control has this table, add the file with its"
    " MD18342 to the control's files": (
        "andere Indizes in `cec_tables` angeben; oder, wenn die Steuerung diese Tabelle hat, die"
        " Datei mit ihrem MD18342 zu den Dateien der Steuerung hinzufügen"
    ),
    "give other indices in the option `cec_tables`": (
        "andere Indizes in der Option `cec_tables` angeben"
    ),
    "give the same deviations for both directions in this entry of `cross`": (
        "in diesem Eintrag von `cross` für beide Richtungen dieselben Abweichungen angeben"
    ),
    "indices from 0 to {last}": "Indizes von 0 bis {last}",
    "it cannot be read as a curve": "sie ist nicht als Kurve lesbar",
    "it has room for {room} points": "sie hat Platz für {room} Punkte",
    "its values are in inch (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)": (
        "ihre Werte sind in Zoll (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)"
    ),
    "job (`apply` and `cross`)": "Auftrag (`apply` und `cross`)",
    "lists of the control": "Listen der Steuerung",
    "set `table: {mode: single}` for an axis whose own tables take an index: one table for both"
    " directions needs none": (
        "`table: {mode: single}` für eine Achse setzen, deren eigene Tabellen einen Index belegen:"
        " eine Tabelle für beide Richtungen braucht keinen"
    ),
    "look in the control for an unused table, and ask the machine's builder; then give its index"
    " as `cec_tables` in the options": (
        "in der Steuerung nach einer unbenutzten Tabelle sehen und den Maschinenhersteller fragen;"
        " dann ihren Index als `cec_tables` in den Optionen angeben"
    ),
    "look in the control for {needed} unused tables, and ask the machine's builder; then give"
    " their indices as `cec_tables` in the options": (
        "in der Steuerung nach {needed} unbenutzten Tabellen sehen und den Maschinenhersteller"
        " fragen; dann ihre Indizes als `cec_tables` in den Optionen angeben"
    ),
    "measure again": "noch einmal messen",
    "multiply the values of table {index} by {value}": (
        "die Werte der Tabelle {index} mit {value} multiplizieren"
    ),
    "no equal spacing has its points and those of the correction": (
        "kein gleichmäßiger Abstand enthält ihre Punkte und die der Korrektur"
    ),
    "none: the option is not given": "keine: die Option ist nicht angegeben",
    "none in `cec_tables` ({allowed}); those that this job writes for its axes are used": (
        "keine in `cec_tables` ({allowed}); die dieses Auftrags für seine Achsen sind belegt"
    ),
    "one curve": "eine Kurve",
    "one other axis": "eine andere Achse",
    "other indices in the option cec_tables": "andere Indizes in der Option cec_tables",
    "raise MD18342 of this table in the control (this clears its memory), then set `points` to"
    " {count} in the options; or give a larger spacing": (
        "MD18342 dieser Tabelle in der Steuerung erhöhen (das löscht ihren Speicher), dann in den"
        " Optionen `points` auf {count} setzen; oder einen größeren Abstand angeben"
    ),
    "reduce the correction or the other tables of this axis, or raise MD32720, then run the job"
    " again": (
        "die Korrektur oder die anderen Tabellen dieser Achse verkleinern, oder MD32720 erhöhen,"
        " dann den Auftrag noch einmal ausführen"
    ),
    "remove the corrections of axis {output} over {inputs} from the {where}": (
        "die Korrekturen der Achse {output} über {inputs} entfernen ({where})"
    ),
    "set MD18342 to {count} or more (save an archive, power on, load the archive back) and export"
    " the files again": (
        "MD18342 auf {count} oder mehr setzen (Archiv anlegen, Power On, Archiv zurückladen) und"
        " die Dateien noch einmal ausgeben"
    ),
    "set `cec: absent` in the options, so that no CEC table is written": (
        "`cec: absent` in den Optionen setzen, damit keine CEC-Tabelle geschrieben wird"
    ),
    "set `cec: available` in the options if the control has it, or remove the cross entries from"
    " the job": (
        "`cec: available` in den Optionen setzen, wenn die Steuerung sie hat, oder die Einträge"
        " `cross` aus dem Auftrag entfernen"
    ),
    "set {name} to 1 in the control, {then}, and export the files again": (
        "in der Steuerung {name} auf 1 setzen, {then} und die Dateien noch einmal ausgeben"
    ),
    "the control works in inch (MD10240 = 0), and no file says in which unit its cross-axis"
    " corrections are (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)": (
        "die Steuerung arbeitet in Zoll (MD10240 = 0), und keine Datei nennt die Einheit ihrer"
        " Korrekturen zwischen Achsen (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)"
    ),
    "the control's files have no MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) of CEC table {index}, so"
    " the control does not have this table": (
        "die Dateien der Steuerung enthalten MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) der"
        " CEC-Tabelle {index} nicht, die Steuerung hat diese Tabelle also nicht"
    ),
    "the correction differs by direction": "die Korrektur hängt von der Richtung ab",
    "the correction repeats": "die Korrektur wiederholt sich",
    "the job corrects {name} by {parameter} (method: line)": (
        "der Auftrag korrigiert {name} durch {parameter} (method: line)"
    ),
    "the machine data with MD32711 = 1: metric": "die Maschinendaten mit MD32711 = 1: metrisch",
    "the table that corrects axis {output} over the position of axis {input} has too many points": (
        "die Tabelle, die Achse {output} über der Position von Achse {input} korrigiert, hat zu"
        " viele Punkte"
    ),
    "this control can correct axis {output} over the position of only one other axis": (
        "diese Steuerung kann Achse {output} nur über der Position einer einzigen anderen Achse"
        " korrigieren"
    ),
    "two different curves": "zwei verschiedene Kurven",
    "up to {value}": "bis zu {value}",
    "{control} has cross-axis tables only if the control has the CEC option": (
        "{control} hat Tabellen zwischen Achsen nur, wenn die Steuerung die Option CEC hat"
    ),
    "{found} in `cec_tables` ({allowed})": "{found} in `cec_tables` ({allowed})",
    "{have}, needed: {count}": "{have}, nötig: {count}",
    "{label}: no CEC table can be written for this control: {why}": (
        "{label}: Für diese Steuerung ist keine CEC-Tabelle schreibbar: {why}"
    ),
    "{message}; table {index} of these axes takes no further correction: {reasons}": (
        "{message}; Tabelle {index} dieser Achsen nimmt keine weitere Korrektur auf: {reasons}"
    ),
    "{name} is in no given file, and room is known for {room} points only": (
        "{name} steht in keiner angegebenen Datei, und Platz ist nur für {room} Punkte bekannt"
    ),
    "{name} is {value}": "{name} ist {value}",
    "{name} is {value}, needed: 0": "{name} ist {value}, nötig: 0",
    "{name} is {value}: table {index} is multiplied by it": (
        "{name} ist {value}: Tabelle {index} wird mit ihr multipliziert"
    ),
    "{one}; or {other}": "{one}; oder {other}",
    "{parameter} ({name}) is in no given file, needed: 1": (
        "{parameter} ({name}) steht in keiner angegebenen Datei, nötig: 1"
    ),
    "{parameter} ({name}) is {value}, needed: 1": "{parameter} ({name}) ist {value}, nötig: 1",
    "{parameter} corrects {name} now ({slope} mm/m)": (
        "{parameter} korrigiert {name} jetzt ({slope} mm/m)"
    ),
    "{steps}, and run again": "{steps}, und noch einmal ausführen",
    "{step}, or add the file with {parameter} to the control's files (`states` or `--state`)": (
        "{step}, oder die Datei mit {parameter} zu den Dateien der Steuerung hinzufügen (`states`"
        " oder `--state`)"
    ),
    "{value}, and the first value in line {line}": "{value}, und der erste Wert in Zeile {line}",
    "{why}, and a column is active only with tables, never with {parameter}; give {name} a test"
    " and a table of its own": (
        "{why}, und eine Spalte wirkt nur mit Tabellen, nie mit {parameter}; {name} einen eigenen"
        " Test und eine eigene Tabelle geben"
    ),
    "The column is active only while the bit of {output} in {parameter} is 1. ": (
        "Die Spalte wirkt nur, solange das Bit von {output} in {parameter} 1 ist. "
    ),
    "a column of {file} is for both directions, but the correction has two curves": (
        "eine Spalte von {file} gilt für beide Richtungen, die Korrektur hat aber zwei Kurven"
    ),
    "neighbouring values of {file} would differ too much": (
        "benachbarte Werte von {file} würden sich zu sehr unterscheiden"
    ),
    "no table (.COM) that is active for {input} is among the files": (
        "unter den Dateien ist keine Tabelle (.COM), die für {input} aktiv ist"
    ),
    "the bit of {output} in {parameter} is 0: no table is active on it": (
        "das Bit von {output} in {parameter} ist 0: Keine Tabelle wirkt auf diese Achse"
    ),
    "Set the bit of {output} in {parameter} to 1. ": (
        "Das Bit von {output} in {parameter} auf 1 setzen. "
    ),
    "{active}If it is 0, and {linear} of {output} or one of its columns in any table is"
    " not 0, leave out this step: set the bit to 1 first and repeat the test. ": (
        "{active}Ist es 0 und {linear} von {output} oder eine seiner Spalten in"
        " irgendeiner Tabelle nicht 0, diesen Schritt auslassen: zuerst das Bit auf 1"
        " setzen und die Prüfung wiederholen. "
    ),
    "no line of {file} is active, and an active line activates every table that it names;"
    " mark the line, repeat the test and give the files as they are then": (
        "keine Zeile von {file} ist aktiv, und eine aktive Zeile schaltet jede Tabelle"
        " ein, die sie nennt; die Zeile markieren, die Prüfung wiederholen und die Dateien"
        " in diesem Zustand angeben"
    ),
    "the bit of {output} in {parameter}": ("das Bit von {output} in {parameter}"),
    "the active line of the .CMA": ("die aktive Zeile der .CMA"),
    "no table is active on {output} now, and {bit} would also activate values that are not"
    " active now ({tables}); empty these columns, or activate them and repeat the test,"
    " then give the files as they are then": (
        "auf {output} wirkt jetzt keine Tabelle, und {bit} würde auch Werte einschalten,"
        " die jetzt nicht wirken ({tables}); diese Spalten leeren, oder sie einschalten"
        " und die Prüfung wiederholen, dann die Dateien in diesem Zustand angeben"
    ),
    "no table is active on {output} now, and not all tables that {bit} would activate are"
    " among the files; give the .CMA and every .COM that its active line names": (
        "auf {output} wirkt jetzt keine Tabelle, und nicht alle Tabellen, die {bit}"
        " einschalten würde, sind unter den Dateien; die .CMA und jede .COM angeben, die"
        " ihre aktive Zeile nennt"
    ),
    "{file} would need {rows} rows, and the control accepts {most}": (
        "{file} bräuchte {rows} Zeilen, und die Steuerung nimmt {most}"
    ),
    "{file} has no column {column}": "{file} hat keine Spalte {column}",
    "{file} has no row at a position where the correction bends": (
        "{file} hat keine Zeile an einer Position, an der die Korrektur einen Knick hat"
    ),
    "{file} is active for the motion of several axes: {axes}": (
        "{file} ist für die Bewegung mehrerer Achsen aktiv: {axes}"
    ),
    "{file} is in inch": "{file} ist in Zoll",
    "{file} reaches from {low} to {high}, the correction from {first} to {last}": (
        "{file} reicht von {low} bis {high}, die Korrektur von {first} bis {last}"
    ),
    "{file}: line {number}": "{file}: Zeile {number}",
    "{input} is a rotary axis": "{input} ist eine Rundachse",
}
