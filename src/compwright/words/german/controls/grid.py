"""German texts for the controls of `formats.families.grid`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Keep a copy of the INI file and of each compensation file that it names.": (
        "Eine Kopie der INI-Datei und jeder Kompensationsdatei aufheben, die sie nennt."
    ),
    "Put the table in place": "Tabelle ablegen",
    "Copy {file_1} into the folder of the INI file. It holds {points} rows from {start} to"
    " {end} {unit}. Do not add a comment, a header or a blank line: LinuxCNC would stop"
    " reading there without an error.": (
        "{file_1} in den Ordner der INI-Datei kopieren. Die Datei enthält {points} Zeilen von"
        " {start} bis {end} {unit}. Keinen Kommentar, keine Kopfzeile und keine Leerzeile"
        " hinzufügen: LinuxCNC würde dort ohne Fehlermeldung aufhören zu lesen."
    ),
    "Set the keys": "Schlüssel setzen",
    "Put the three lines of {file_2} into the section [JOINT_{address}] of the INI file,"
    " replacing lines of the same name. BACKLASH becomes 0: the table contains the reversal,"
    " and the control ignores it where there is a table.": (
        "Die drei Zeilen von {file_2} in den Abschnitt [JOINT_{address}] der INI-Datei setzen,"
        " an die Stelle von Zeilen gleichen Namens. BACKLASH wird 0: Die Tabelle enthält die"
        " Umkehr, und neben einer Tabelle beachtet die Steuerung ihn nicht."
    ),
    "Restart LinuxCNC: a table is read once at the start. Look for the messages 'too many"
    " compensation entries' and 'compensation values must increase'.": (
        "LinuxCNC neu starten: Eine Tabelle wird einmal beim Start gelesen. Auf die Meldungen"
        " 'too many compensation entries' und 'compensation values must increase' achten."
    ),
    "Home the same way": "Ebenso referenzieren",
    "Home the axis as it was homed for the measurement. Before the first motion after homing"
    " nothing is corrected.": (
        "Die Achse referenzieren wie vor der Messung. Vor der ersten Bewegung nach dem"
        " Referenzieren wird nichts korrigiert."
    ),
    "Drive to the check positions (their table stands with the axis) and read the HAL pin"
    " joint.{address}.backlash-filt in machine units: it shows what the control must add"
    " there.": (
        "Die Prüfpositionen anfahren (ihre Tabelle steht bei der Achse) und den HAL-Pin"
        " joint.{address}.backlash-filt in Maschineneinheiten ablesen: Er zeigt, was die"
        " Steuerung dort addieren muss."
    ),
    "Copy the INI file and the compensation files that it names from the control again and"
    " compare them with the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`.": (
        "Die INI-Datei und die Kompensationsdateien, die sie nennt, noch einmal von der Steuerung"
        " kopieren und mit dem Plan vergleichen: `compwright compare JOB_FOLDER --loaded"
        " READ_BACK`."
    ),
    "Put the saved INI file back, with each compensation file that it names; restart LinuxCNC and"
    " home.": (
        "Die gesicherte INI-Datei zurücklegen, mit jeder Kompensationsdatei, die sie nennt;"
        " LinuxCNC neu starten und referenzieren."
    ),
    "Axis {name} is programmed in diameter: laser, table and every position on this card"
    " count in radius, as the joint moves; the control looks its table up there, whatever G7"
    " and G8 say. In G7 program twice the position": (
        "Achse {name} ist im Durchmesser programmiert: Laser, Tabelle und jede Position auf"
        " dieser Karte zählen im Radius, wie sich das Gelenk bewegt; die Steuerung schlägt ihre"
        " Tabelle dort nach, gleich ob G7 oder G8 gilt. In G7 das Doppelte der Position"
        " programmieren"
    ),
    "with the kinematics matrixkins (LinuxCNC 2.10) add {squareness} to the value of"
    " matrixkins.C_{output}{input} that is in force{shift}; without it this control has no"
    " place for it": (
        "mit der Kinematik matrixkins (LinuxCNC 2.10) {squareness} zu dem Wert von"
        " matrixkins.C_{output}{input} addieren, der gilt{shift}; ohne sie hat diese Steuerung"
        " keinen Platz dafür"
    ),
    "BACKLASH of [JOINT_{address}] = {backlash} {backlash_unit}": (
        "BACKLASH von [JOINT_{address}] = {backlash} {backlash_unit}"
    ),
    "The HAL pin joint.{address}.backlash-filt at the check positions of the card shows what"
    " the control adds there, without any measurement.": (
        "Der HAL-Pin joint.{address}.backlash-filt zeigt an den Prüfpositionen der Karte, was"
        " die Steuerung dort addiert, ohne jede Messung."
    ),
    "COMP_FILE of [JOINT_{address}] is read once, at the start, relative to the folder of"
    " the INI file: restart after every change.": (
        "COMP_FILE von [JOINT_{address}] wird einmal beim Start gelesen, relativ zum Ordner der"
        " INI-Datei: nach jeder Änderung neu starten."
    ),
    "Reading stops without a message at the first line that is not three numbers (a comment,"
    " a header, a comma): then the table is empty, and BACKLASH is active in its place.": (
        "Das Lesen endet ohne Meldung an der ersten Zeile, die nicht aus drei Zahlen besteht"
        " (Kommentar, Kopfzeile, Komma): Dann ist die Tabelle leer, und BACKLASH wirkt an ihrer"
        " Stelle."
    ),
    "Before the first motion after homing nothing is added.": (
        "Vor der ersten Bewegung nach dem Referenzieren wird nichts addiert."
    ),
    "COMP_FILE_TYPE of [JOINT_{address}]: 1 takes the columns as corrections, which are"
    " added; 0, also where the key is missing, as actual positions. Were errors written as"
    " corrections?": (
        "COMP_FILE_TYPE von [JOINT_{address}]: 1 nimmt die Spalten als Korrekturen, die addiert"
        " werden; 0, auch ohne den Schlüssel, als Istpositionen. Wurden Fehler als Korrekturen"
        " geschrieben?"
    ),
    "Numbers of the table count in machine units, LINEAR_UNITS of [TRAJ]: inch taken for mm"
    " is 25.4.": (
        "Zahlen der Tabelle zählen in Maschineneinheiten, LINEAR_UNITS von [TRAJ]: Zoll statt"
        " mm ist 25.4."
    ),
    "The first column of the table: nominal positions of the joint, ascending.": (
        "Die erste Spalte der Tabelle: Sollpositionen des Gelenks, steigend."
    ),
    "Was the axis homed as for the measurement? Another kind of homing, or another"
    " HOME_OFFSET, moves the table.": (
        "Wurde die Achse wie für die Messung referenziert? Eine andere Art der Referenzfahrt"
        " oder ein anderer HOME_OFFSET verschiebt die Tabelle."
    ),
    "The signs of the first column: a table that was turned over does not ascend, and rows"
    " that do not ascend are dropped.": (
        "Die Vorzeichen der ersten Spalte: Eine umgedrehte Tabelle steigt nicht, und Zeilen,"
        " die nicht steigen, fallen weg."
    ),
    "The table belongs into the section [JOINT_{address}]: joints are counted from 0 in the"
    " order of the kinematics, so on a lathe with X and Z the Z is joint 1.": (
        "Die Tabelle gehört in den Abschnitt [JOINT_{address}]: Gelenke werden ab 0 in der"
        " Reihenfolge der Kinematik gezählt, an einer Drehmaschine mit X und Z ist Z also"
        " Gelenk 1."
    ),
    "The second column is active while the joint moves in +, the third one while it moves in -.": (
        "Die zweite Spalte wirkt bei der Bewegung in +, die dritte bei der Bewegung in -."
    ),
    "BACKLASH of [JOINT_{address}] is ignored as soon as the table has one row; without rows,"
    " half of it is active in each direction.": (
        "BACKLASH von [JOINT_{address}] wird nicht beachtet, sobald die Tabelle eine Zeile hat;"
        " ohne Zeilen wirkt es zur Hälfte in jeder Richtung."
    ),
    "At most 256 rows are taken; a row that does not ascend is dropped, and reading stops at"
    " the first line that is not three numbers: look for the messages at the start.": (
        "Höchstens 256 Zeilen werden genommen; eine Zeile, die nicht steigt, fällt weg, und das"
        " Lesen endet an der ersten Zeile, die nicht aus drei Zahlen besteht: auf die Meldungen"
        " beim Start achten."
    ),
    "Below the first and above the last row their values stay.": (
        "Unter der ersten und über der letzten Zeile bleiben deren Werte."
    ),
    "{label}: zero of the correction": "{label}: Null der Korrektur",
    "{position} {unit}, approached in {direction}": "{position} {unit}, in {direction} angefahren",
    "the axis homes on a switch (HOME_OFFSET, HOME_LATCH_VEL): what the table holds there"
    " counts as zero": (
        "die Achse referenziert auf einen Schalter (HOME_OFFSET, HOME_LATCH_VEL): Was die"
        " Tabelle dort enthält, zählt als null"
    ),
    "{label}: table": "{label}: Tabelle",
    "no file that was given contains one": "keine angegebene Datei enthält eine",
    "where its turn begins (MD30340)": "wo ihre Umdrehung beginnt (MD30340)",
    "{value} deg": "{value}°",
    "the control has reserved none yet": "die Steuerung hat noch keine reserviert",
    "that the control wraps it (MD30310)": "dass die Steuerung sie umlaufen lässt (MD30310)",
    "yes": "ja",
    "the control's files do not say it": "die Dateien der Steuerung sagen es nicht",
    "axis {name}: {fact}": "Achse {name}: {fact}",
    "in no file": "in keiner Datei",
    "axis {name}: number of points the control can store": (
        "Achse {name}: Anzahl der Punkte, die die Steuerung aufnimmt"
    ),
    "as many as are needed; the card says how many to set": (
        "so viele wie nötig; die Karte sagt, wie viele zu setzen sind"
    ),
    "LinuxCNC, screw compensation table (COMP_FILE) per joint": (
        "LinuxCNC, Kompensationstabelle der Spindel (COMP_FILE) je Gelenk"
    ),
    "L3: 0 is the control's own default": "L3: 0 ist die eigene Vorgabe der Steuerung",
    "L3: LINEAR is the control's own default": "L3: LINEAR ist die eigene Vorgabe der Steuerung",
    "joints are numbered in the order of the kinematics; of a letter alone only that of X is"
    " taken, and only where no file says it": (
        "Gelenke sind in der Reihenfolge der Kinematik nummeriert; aus einem Buchstaben allein"
        " wird nur der von X genommen, und nur, wenn keine Datei es sagt"
    ),
    "MD30200: there is one": "MD30200: es gibt eines",
    "the only one in the files": "das einzige in den Dateien",
    "the only one that is switched on (MD32700)": "das einzige, das eingeschaltet ist (MD32700)",
    "the only one that contains a table": "das einzige, das eine Tabelle enthält",
    "the only one with points reserved (MD38000)": (
        "das einzige mit reservierten Punkten (MD38000)"
    ),
    "the only one with a backlash value": "das einzige mit einem Losewert",
    "the one that contains a table": "das, das eine Tabelle enthält",
    "axis {name}: measuring system": "Achse {name}: Messsystem",
}
