"""German texts for the controls of `formats.families.columns`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save all machine parameters and every .COM and .CMA file of the control. Write down"
    " MP710.{bit}, MP720.{bit}, MP730 and which .CMA line is active.": (
        "Alle Maschinenparameter und jede .COM- und .CMA-Datei der Steuerung sichern."
        " MP710.{bit}, MP720.{bit}, MP730 und die aktive Zeile der .CMA notieren."
    ),
    "Enter the table": "Tabelle eingeben",
    "Axis {address}: {table}. {load} Typed in: datum at the first point, column"
    " {number}=F(). The values are {table_values}s. Leave the columns of other axes alone."
    " Whether the first value has to be 0 is not known.": (
        "Achse {address}: {table}. {load} Eingetippt: Bezugspunkt am ersten Punkt, Spalte"
        " {number}=F(). Die Werte bedeuten {table_values} (Option table_values). Die Spalten"
        " anderer Achsen nicht ändern. Ob der erste Wert 0 sein muss, ist nicht bekannt."
    ),
    "Reach beyond the travel": "Über den Verfahrweg hinaus",
    "What the control does outside the table is unknown: the table should reach one spacing"
    " beyond the travel of {name} on each side, with real values at both ends (job: table"
    " start and end).": (
        "Was außerhalb der Tabelle wirkt, ist nicht bekannt: Sie soll auf jeder Seite um einen"
        " Punktabstand über den Verfahrweg von {name} hinausreichen, mit echten Werten an"
        " beiden Enden (Auftrag: Anfang und Ende der Tabelle)."
    ),
    "Activate the line": "Zeile aktivieren",
    "Where a table is used: the active line of the .CMA must name the .COM file in the"
    " column of axis {address} (soft key or PLC module 9095). All axes share one active"
    " line: change only this cell.": (
        "Wo eine Tabelle benutzt wird: Die aktive Zeile der .CMA muss in der Spalte der Achse"
        " {address} die .COM-Datei nennen (Softkey oder PLC-Modul 9095). Alle Achsen teilen"
        " sich eine aktive Zeile: nur diese Zelle ändern."
    ),
    "Set the parameters": "Parameter setzen",
    "MP710.{bit} = {backlash} {backlash_unit}, MP720.{bit} = {linear} mm/m, MP730 bit {bit}"
    " = {nonlinear} (leave the other bits as they are). With the bit at 1 and no active .CMA"
    " line, old tables of the machine's builder may come alive.": (
        "MP710.{bit} = {backlash} {backlash_unit}, MP720.{bit} = {linear} mm/m, MP730 Bit {bit}"
        " = {nonlinear} (die anderen Bits nicht ändern). Mit dem Bit auf 1 und ohne aktive"
        " Zeile der .CMA können alte Tabellen des Maschinenherstellers wirksam werden."
    ),
    "Switch the control off and on. {referencing} Nominal values may jump slightly when a"
    " line is selected.": (
        "Die Steuerung aus- und einschalten. {referencing} Sollwerte können leicht springen,"
        " wenn eine Zeile gewählt wird."
    ),
    "The sign of a table is not confirmed; that of MP720 is. Before the full test measure two"
    " of the check positions (listed with the axis on the card) once as the control is now,"
    " and once without compensation (table: MP730 bit {bit} and MP720.{bit} = 0; line:"
    " MP720.{bit} = 0; MP710.{bit} = 0): the compensation must add what is listed there. If a"
    " table does the opposite, set the option table_values to the other choice and run again.": (
        "Das Vorzeichen einer Tabelle ist nicht bestätigt; das von MP720 ist es. Vor der ganzen"
        " Prüfung zwei der Prüfpositionen (ihre Tabelle steht bei der Achse) messen, wie jetzt"
        " und noch einmal ohne Kompensation (Tabelle: MP730 Bit {bit} und MP720.{bit} = 0;"
        " Linie: MP720.{bit} = 0; MP710.{bit} = 0): Die Kompensation muss addieren, was dort"
        " steht. Tut eine Tabelle das Gegenteil, die Option table_values auf den anderen Wert"
        " setzen und noch einmal ausführen."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive MP710 moves on in the direction of"
    " the new motion.": (
        "Eine Messuhr bei Anfahrt in {reference_return} auf null stellen, dann von der anderen"
        " Seite zurückkommen: Der Unterschied, der bleibt, muss klein sein. Ein positiver Wert"
        " MP710 führt in der Richtung der neuen Bewegung weiter."
    ),
    "Save the .COM and .CMA files and the list of machine parameters again and compare them with"
    " the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`. What was typed in from a"
    " sheet: write the values on the display into a copy of the sheet.": (
        "Die .COM- und .CMA-Dateien und die Liste der Maschinenparameter noch einmal sichern und"
        " mit dem Plan vergleichen: `compwright compare JOB_FOLDER --loaded READ_BACK`. Was aus"
        " einem Blatt eingegeben wurde: die Werte der Anzeige in eine Kopie des Blatts schreiben."
    ),
    "Load the saved .COM and .CMA files and set MP710.{bit}, MP720.{bit} and the bit of"
    " MP730 as written down.": (
        "Die gesicherten .COM- und .CMA-Dateien laden und MP710.{bit}, MP720.{bit} und das Bit"
        " von MP730 setzen wie notiert."
    ),
    "MP710.{bit} = {backlash} {backlash_unit}": "MP710.{bit} = {backlash} {backlash_unit}",
    "Make a backup of the control with its configuration data and every .COM and .CMA file."
    " Write down backLash and linearCompValue of axis {address} and which line of config.cma"
    " is active.": (
        "Ein Backup der Steuerung mit ihren Konfigurationsdaten und jeder .COM- und .CMA-Datei"
        " anlegen. backLash und linearCompValue der Achse {address} und die aktive Zeile von"
        " config.cma notieren."
    ),
    "Axis {address}: {table}. {load} Typed in: AXISPOS and column {address}. The values are"
    " {table_values}s. Leave the columns of other axes alone.": (
        "Achse {address}: {table}. {load} Eingetippt: AXISPOS und Spalte {address}. Die Werte"
        " bedeuten {table_values} (Option table_values). Die Spalten anderer Achsen nicht"
        " ändern."
    ),
    "What the control does outside the table is unknown: the table should reach one spacing"
    " beyond the travel of {name} on each side (job: table start and end).": (
        "Was außerhalb der Tabelle wirkt, ist nicht bekannt: Sie soll auf jeder Seite um einen"
        " Punktabstand über den Verfahrweg von {name} hinausreichen (Auftrag: Anfang und Ende"
        " der Tabelle)."
    ),
    "In config.cma exactly one line has * in ACTIVE: its column {address} must name the .COM"
    " file. All axes share this line: change only this cell.": (
        "In config.cma hat genau eine Zeile * in ACTIVE: Ihre Spalte {address} muss die"
        " .COM-Datei nennen. Alle Achsen teilen sich diese Zeile: nur diese Zelle ändern."
    ),
    "CfgAxisComp of axis {address}: backLash (401802) = {backlash} {backlash_unit},"
    " linearCompValue = {linear} mm/m; choose the nonlinear compensation.": (
        "CfgAxisComp der Achse {address}: backLash (401802) = {backlash} {backlash_unit},"
        " linearCompValue = {linear} mm/m; die nichtlineare Kompensation wählen."
    ),
    "Restart the control. {referencing} The table is active in open loop too and is taken"
    " over when the loop closes.": (
        "Die Steuerung neu starten. {referencing} Die Tabelle wirkt auch bei offenem Regelkreis"
        " und wird übernommen, wenn er schließt."
    ),
    "The sign of the table is not confirmed. Before the full test measure two of the check"
    " positions (listed with the axis on the card) once as the control is now, and once"
    " without compensation (no * in ACTIVE, backLash 0): the compensation must add what is"
    " listed there. If it is the opposite, set the option table_values to the other choice"
    " and run again.": (
        "Das Vorzeichen der Tabelle ist nicht bestätigt. Vor der ganzen Prüfung zwei der"
        " Prüfpositionen (ihre Tabelle steht bei der Achse) messen, wie jetzt und noch einmal"
        " ohne Kompensation (kein * in ACTIVE, backLash 0): Die Kompensation muss addieren, was"
        " dort steht. Ist es umgekehrt, die Option table_values auf den anderen Wert setzen und"
        " noch einmal ausführen."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive backLash moves on in the direction"
    " of the new motion. The control adds it also where only the table makes the axis turn"
    " back.": (
        "Eine Messuhr bei Anfahrt in {reference_return} auf null stellen, dann von der anderen"
        " Seite zurückkommen: Der Unterschied, der bleibt, muss klein sein. Ein positiver Wert"
        " backLash führt in der Richtung der neuen Bewegung weiter. Die Steuerung addiert ihn"
        " auch dort, wo nur die Tabelle die Achse umkehren lässt."
    ),
    "Save the .COM and .CMA files again and compare them with the plan: `compwright compare"
    " JOB_FOLDER --loaded READ_BACK`. What was typed in from a sheet: write the values on the"
    " display into a copy of the sheet.": (
        "Die .COM- und .CMA-Dateien noch einmal sichern und mit dem Plan vergleichen: `compwright"
        " compare JOB_FOLDER --loaded READ_BACK`. Was aus einem Blatt eingegeben wurde: die Werte"
        " der Anzeige in eine Kopie des Blatts schreiben."
    ),
    "Load the saved .COM and .CMA files and set backLash and linearCompValue of axis"
    " {address} as written down.": (
        "Die gesicherten .COM- und .CMA-Dateien laden und backLash und linearCompValue der"
        " Achse {address} setzen wie notiert."
    ),
    "CfgAxisComp of axis {address}: backLash (401802) = {backlash} {backlash_unit}": (
        "CfgAxisComp der Achse {address}: backLash (401802) = {backlash} {backlash_unit}"
    ),
    "The sign is unconfirmed: check it with a square or a dial gauge, on and off, before"
    " production.": (
        "Das Vorzeichen ist unbestätigt: es vor der Produktion mit einem Winkel oder einer"
        " Messuhr prüfen, ein und aus."
    ),
    "{file}, column {column}": "{file}, Spalte {column}",
    "{error} is in {where}, added to what was there: {values} (values are {form}s). Load"
    " that file; no other column of it changes. {selected}{check}": (
        "{error} ist in {where}, addiert zu dem, was dort war: {values} (die Werte bedeuten"
        " {form}). Diese Datei laden; keine andere Spalte darin ändert sich. {selected}{check}"
    ),
    "the table (.COM) of {input}, column of {output}": (
        "Tabelle (.COM) von {input}, Spalte von {output}"
    ),
    "the table (.COM) that the active line of the .CMA names for the motion of {input} (a"
    " new one, where it names none), column of {output}": (
        "Tabelle (.COM), die die aktive Zeile der .CMA für die Bewegung von {input} nennt"
        " (eine neue, wo sie keine nennt), Spalte von {output}"
    ),
    "{output} over {input}: {where}": "{output} über {input}: {where}",
    "{value} {unit} at {position}": "{value} {unit} bei {position}",
    "(see the axis list of the machine)": "(siehe Achsliste der Maschine)",
    "no table": "keine Tabelle",
    ", every {spacing} {unit}": ", alle {spacing} {unit}",
    "{points} points from {start} to {end} {unit}{every}": (
        "{points} Punkte von {start} bis {end} {unit}{every}"
    ),
    "Type the sheet {file} into the .COM file that the active line of the .CMA names for the"
    " motion of axis {address}; where it names none, into a new one. Never into one that it"
    " names for another axis.": (
        "Das Blatt {file} in die .COM-Datei eintippen, die die aktive Zeile der .CMA für die"
        " Bewegung der Achse {address} nennt; nennt sie keine, in eine neue. Nie in eine, die"
        " sie für eine andere Achse nennt."
    ),
    " {file} holds the parameters that are in no file of yours.": (
        " {file} enthält die Parameter, die in keiner Ihrer Dateien sind."
    ),
    "Load your own .COM file of tables/: it holds the table.{rest}": (
        "Ihre eigene .COM-Datei aus tables/ laden: Sie enthält die Tabelle.{rest}"
    ),
    "Read back what is in the control and compare it with the plan (`compwright compare"
    " JOB_FOLDER --loaded READ_BACK`): it shows value by value what this test cannot tell.": (
        "Zurücklesen, was in der Steuerung ist, und mit dem Plan vergleichen (`compwright"
        " compare JOB_FOLDER --loaded READ_BACK`): Das zeigt Wert für Wert, was diese Prüfung"
        " nicht sagen kann."
    ),
    "The bit of axis {address} in MP730 must be 1, and the active line of the .CMA must name"
    " its .COM: until then no table is active.": (
        "Das Bit der Achse {address} in MP730 muss 1 sein, und die aktive Zeile der .CMA muss"
        " ihre .COM nennen: Nichts wirkt, bevor beides so ist."
    ),
    "With the bit at 1 and no .CMA, old tables of the machine's builder (code 105296) act in"
    " their place.": (
        "Mit dem Bit auf 1 und ohne .CMA wirken an ihrer Stelle alte Tabellen des"
        " Maschinenherstellers (Code 105296)."
    ),
    "The axis must have passed its reference marks.": (
        "Die Achse muss ihre Referenzmarken überfahren haben."
    ),
    "No manual states the sign of a table's values: compare two positions with the bit of"
    " MP730 at 1 and at 0; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Kein Handbuch nennt das Vorzeichen der Werte einer Tabelle: zwei Positionen mit dem"
        " Bit von MP730 auf 1 und auf 0 vergleichen; ändert sich der Abstand falsch herum, mit"
        " dem anderen table_values noch einmal ausführen."
    ),
    "Where the axis is corrected by MP720 alone: positive means that the table travels too far.": (
        "Wo die Achse nur durch MP720 korrigiert wird: Positiv heißt, dass der Tisch zu weit fährt."
    ),
    "The .COM counts in mm or in inch, and MP720 in mm/m.": (
        "Die .COM zählt in mm oder in Zoll, und MP720 in mm/m."
    ),
    "With the bit of MP730 at 1 MP720 has no effect; a column for this axis in another axis'"
    " .COM is active in addition to its own table.": (
        "Mit dem Bit von MP730 auf 1 ist MP720 ohne Wirkung; eine Spalte für diese Achse in der"
        " .COM einer anderen Achse wirkt neben der eigenen."
    ),
    "DATUM and spacing of the .COM: point k stands at DATUM + k times the spacing, from the"
    " machine datum.": (
        "DATUM und Punktabstand der .COM: Punkt k liegt bei DATUM + k mal Punktabstand, vom"
        " Maschinennullpunkt."
    ),
    "The points run in + from the DATUM: were they entered from the other end?": (
        "Die Punkte laufen von DATUM an in +: Wurden sie vom anderen Ende an eingegeben?"
    ),
    "The column of the .CMA names the axis that moves, the column n=F() inside the .COM the"
    " axis that is corrected: both must be {address}.": (
        "Die Spalte der .CMA nennt die Achse, die sich bewegt, die Spalte n=F() in der .COM die"
        " Achse, die korrigiert wird: Beide müssen {address} sein."
    ),
    "A table has no direction here: what is active in one direction only is MP710 (or MP750"
    " within the position loop).": (
        "Eine Tabelle hat hier keine Richtung: Was nur in einer Richtung wirkt, ist MP710 (oder"
        " MP750 im Lageregelkreis)."
    ),
    "MP710 of axis {address}, fed in at every reversal: positive where the encoder runs"
    " ahead of the table.": (
        "MP710 der Achse {address}, bei jeder Umkehr aufgeschaltet: positiv, wo der Geber dem"
        " Tisch vorausläuft."
    ),
    "Are all rows filled, from one spacing below the travel to one above? What the control"
    " does outside the table is unknown.": (
        "Sind alle Zeilen gefüllt, von einem Punktabstand unter dem Verfahrweg bis zu einem"
        " darüber? Was außerhalb der Tabelle wirkt, ist nicht bekannt."
    ),
    "At most 256 points in one .COM: a longer one is refused when the line is selected"
    " (module 9095).": (
        "Höchstens 256 Punkte in einer .COM: Eine längere wird beim Wählen der Zeile abgewiesen"
        " (Modul 9095)."
    ),
    "config.cma: one line has * in ACTIVE, and its column {address} must name the .COM file.": (
        "config.cma: Eine Zeile hat * in ACTIVE, und ihre Spalte {address} muss die .COM-Datei"
        " nennen."
    ),
    "CfgAxisComp of axis {address}: the nonlinear compensation must be chosen.": (
        "CfgAxisComp der Achse {address}: Die nichtlineare Kompensation muss gewählt sein."
    ),
    "The table is taken over when the position loop closes; before the reference marks it"
    " has no positions.": (
        "Die Tabelle wird übernommen, wenn der Lageregelkreis schließt; vor den Referenzmarken"
        " hat sie keine Positionen."
    ),
    "No manual states the sign of a table's values: compare two positions with and without"
    " the * in ACTIVE; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Kein Handbuch nennt das Vorzeichen der Werte einer Tabelle: zwei Positionen mit und"
        " ohne den * in ACTIVE vergleichen; ändert sich der Abstand falsch herum, mit dem"
        " anderen table_values noch einmal ausführen."
    ),
    "The .COM counts in mm or in inch, as its first line says.": (
        "Die .COM zählt in mm oder in Zoll, wie ihre erste Zeile sagt."
    ),
    "linearCompValue of CfgAxisComp must be 0: otherwise it may be active in addition to the"
    " table.": ("linearCompValue von CfgAxisComp neben der Tabelle: 0, sonst kann es auch wirken."),
    "The column AXISPOS: positions from the machine datum (MP_refPosition).": (
        "Die Spalte AXISPOS: Positionen vom Maschinennullpunkt (MP_refPosition)."
    ),
    "AXISPOS must ascend, with the value of each position next to it: were the points entered"
    " from the other end?": (
        "AXISPOS muss steigen, mit dem Wert jeder Position daneben: Wurden die Punkte vom"
        " anderen Ende an eingegeben?"
    ),
    "The column of config.cma names the axis that moves, the column inside the .COM the axis"
    " that is corrected: both must be {address}.": (
        "Die Spalte von config.cma nennt die Achse, die sich bewegt, die Spalte in der .COM die"
        " Achse, die korrigiert wird: Beide müssen {address} sein."
    ),
    "The column BACKLASH holds the values for travel in -, the column {address} those for"
    " travel in +.": (
        "Die Spalte BACKLASH enthält die Werte für die Fahrt in -, die Spalte {address} die für"
        " die Fahrt in +."
    ),
    "backLash (401802) of axis {address}: positive where the encoder runs ahead, also at a"
    " reversal that only the table causes.": (
        "backLash (401802) der Achse {address}: positiv, wo der Geber vorausläuft, auch bei"
        " einer Umkehr, die nur die Tabelle verursacht."
    ),
    "Where the column BACKLASH holds the reversal, backLash must not hold it again.": (
        "Wo die Spalte BACKLASH die Umkehr enthält, darf backLash sie nicht noch einmal enthalten."
    ),
    "At most 256 points.": "Höchstens 256 Punkte.",
    "axis {address}": "Achse {address}",
    "axis {address}, measuring system {system}": "Achse {address}, Messsystem {system}",
    "axis {name}: curve for travel in -": "Achse {name}: Kurve für die Fahrt in -",
    "none: no table of the axis with a column BACKLASH was given": (
        "keine: Eine Tabelle der Achse mit einer Spalte BACKLASH war nicht angegeben"
    ),
    "axis {name}: outside the table": "Achse {name}: außerhalb der Tabelle",
    "the end values hold; let the table reach one spacing beyond the travel on each side": (
        "die Endwerte bleiben; die Tabelle auf jeder Seite um einen Punktabstand über den"
        " Verfahrweg hinausreichen lassen"
    ),
    "an entry sheet has no place for it": "ein Eingabeblatt hat keinen Platz dafür",
    "option or its default": "Option oder ihre Vorgabe",
    "HEIDENHAIN iTNC 530 (TNC 407 to 430 with .COM tables), axis error compensation with"
    " backlash (MP710, MP720, MP730)": (
        "HEIDENHAIN iTNC 530 (TNC 407 bis 430 mit .COM-Tabellen), Achsfehlerkompensation mit"
        " Losekompensation (MP710, MP720, MP730)"
    ),
    "HEIDENHAIN NCK controls (MANUALplus 620; TNC 320, 620, 640), axis error compensation"
    " with backlash (CfgAxisComp)": (
        "HEIDENHAIN NCK-Steuerungen (MANUALplus 620; TNC 320, 620, 640), Achsfehlerkompensation"
        " mit Losekompensation (CfgAxisComp)"
    ),
    "H2 draws the error": "H2 zeichnet den Fehler",
    "H6 speaks of compensation values; the older controls draw the error": (
        "H6 spricht von Kompensationswerten; bei den älteren Steuerungen ist der Fehler gezeichnet"
    ),
    "no manual says what the control does outside the table; straight lines between the"
    " points: H8": (
        "kein Handbuch sagt, was die Steuerung außerhalb der Tabelle tut; Geraden zwischen den"
        " Punkten: H8"
    ),
    "no manual says what the control does outside the table; straight lines between the"
    " points: inferred from the older controls": (
        "kein Handbuch sagt, was die Steuerung außerhalb der Tabelle tut; Geraden zwischen den"
        " Punkten: geschlossen aus den älteren Steuerungen"
    ),
    "free": "frei (free)",
    "table": "Tabelle (table)",
    "second_curve": "zweite Kurve (second_curve)",
    "nothing is added arriving in {direction}": "bei Anfahrt in {direction} wird nichts addiert",
    "0: no table is active on it": "0: auf die Achse wirkt keine Tabelle",
    "no file contains a table of the axis": "keine Datei enthält eine Tabelle der Achse",
    "1: its table of zeros is active": "1: ihre Tabelle aus Nullen wirkt",
    "1: its table is active": "1: ihre Tabelle wirkt",
    "0: its table is not active": "0: ihre Tabelle wirkt nicht",
    "a sheet is what was typed in": "ein Blatt ist das, was eingetippt wurde",
    "zeros correct nothing": "Nullen korrigieren nichts",
    "1: {parameter} is not active": "1: {parameter} wirkt nicht",
    "0: {parameter} is active": "0: {parameter} wirkt",
    "in no file; {evidence}": "in keiner Datei; {evidence}",
    "{label}: its table": "{label}: ihre Tabelle",
    "active": "aktiv",
    "{switch} is not in the files: a table that was given counts": (
        "{switch} ist nicht in den Dateien: eine angegebene Tabelle zählt"
    ),
    "{file}: moving axis": "{file}: bewegte Achse",
    "inferred from its name: no table of assignments (.CMA) was given": (
        "geschlossen aus dem Namen: keine Zuordnungstabelle (.CMA) wurde angegeben"
    ),
    "outside the tables": "außerhalb der Tabellen",
    "the end values hold": "die Endwerte gelten",
    "inferred from the name of the axis": "geschlossen aus dem Namen der Achse",
}
