"""German texts for the controls of `formats.families.pairs`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Make a complete commissioning archive of the NC. Changing MD38000 or MD18342 clears the"
    " static user memory at the next start.": (
        "Ein vollständiges Inbetriebnahmearchiv der NC anlegen. Eine Änderung von MD38000 oder"
        " MD18342 löscht beim nächsten Start den statischen Anwenderspeicher."
    ),
    "Access level": "Zugriffsstufe",
    "Log in at access level Manufacturer before you load, and before you load the way back:"
    " lines of machine data ($MA_, $SN_) without a checksum are refused at a lower one, and"
    " what they switch stays as it was.": (
        "Vor dem Laden, und vor dem Laden des Rückwegs, auf Zugriffsstufe Hersteller anmelden:"
        " Zeilen von Maschinendaten ($MA_, $SN_) ohne Prüfsumme werden auf einer niedrigeren"
        " abgewiesen, und was sie schalten, bleibt wie es war."
    ),
    "Compare the archive": "Archiv vergleichen",
    "{archive}": "{archive}",
    "Reserve the points": "Punkte reservieren",
    "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] must be at least {points}. If it"
    " is smaller: set it, save an archive, power on, load the archive back.": (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] muss mindestens {points} sein."
        " Ist es kleiner: setzen, ein Archiv anlegen, Power On, das Archiv zurückladen."
    ),
    "{room}": "{room}",
    "Switch the old table off": "Alte Tabelle ausschalten",
    "Set MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0 and activate it (NEW CONF or"
    " reset). With 1 the table is write protected.{emptied}{others}": (
        "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0 setzen und wirksam machen (NEW CONF"
        " oder Reset). Mit 1 ist die Tabelle schreibgeschützt.{emptied}{others}"
    ),
    "Set MD32710 $MA_CEC_ENABLE[{address}] = 0, SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
    " tables {table_positive} and {table_negative}, and MD32700"
    " $MA_ENC_COMP_ENABLE[{index},{address}] = 0, and activate all (NEW CONF). With MD32710"
    " = 1 the tables are write protected. MD32700 stays 0. Note what MD32710 was before: if"
    " it was 0, find out what else is inactive on axis {address} (every other table with this"
    " output axis and a value that is not 0), and switch it off (SD41300 = 0) before"
    " anything else. MD32710 would activate it.{others}": (
        "MD32710 $MA_CEC_ENABLE[{address}] = 0, SD41300 $SN_CEC_TABLE_ENABLE = 0 für die"
        " Tabellen {table_positive} und {table_negative} und MD32700"
        " $MA_ENC_COMP_ENABLE[{index},{address}] = 0 setzen und alles wirksam machen (NEW"
        " CONF). Mit MD32710 = 1 sind die Tabellen schreibgeschützt. MD32700 bleibt 0."
        " Notieren, was MD32710 vorher war: War es 0, feststellen, was auf Achse {address}"
        " sonst noch inaktiv ist (jede andere Tabelle mit dieser Ausgangsachse und einem Wert, der"
        " nicht 0 ist), und es vor allem anderen ausschalten (SD41300 = 0). MD32710 würde es"
        " aktivieren.{others}"
    ),
    "The sign of this table is confirmed by the manual: a positive value moves the axis in"
    " the negative direction. The quick check shows it.": (
        "Das Vorzeichen dieser Tabelle ist durch das Handbuch bestätigt: Ein positiver Wert"
        " bewegt die Achse in negativer Richtung. Die Schnellprüfung zeigt es."
    ),
    "A positive CEC value moves the axis in - (Function Manual Extended Functions 03/2009,"
    " page 372), which is cec_sign: error; these values were written for the option cec_sign"
    " of the job. Before any file of this set is loaded: stand on axis {name} with a dial"
    " gauge, write 0.1 {unit} into every point of tables {table_positive} and"
    " {table_negative} and switch them on for this check alone: MD32710, NEW CONF, SD41300,"
    " NEW CONF, NCK reset. With cec_sign: correction the axis must move by 0.1 {unit} in +,"
    " with cec_sign: error in -. If it does not: load nothing, and run again with the other"
    " one. Write 0 again and switch them off as in the step before.": (
        "Ein positiver CEC-Wert bewegt die Achse in − (Function Manual Extended Functions"
        " 03/2009, Seite 372), das ist cec_sign: error; diese Werte sind für die Option"
        " cec_sign des Auftrags geschrieben. Bevor eine Datei dieses Satzes geladen wird: eine"
        " Messuhr an Achse {name} ansetzen, 0.1 {unit} in jeden Punkt der Tabellen"
        " {table_positive} und {table_negative} schreiben und sie nur für diese Prüfung"
        " einschalten: MD32710, NEW CONF, SD41300, NEW CONF, NCK-Reset. Mit cec_sign:"
        " correction muss sich die Achse um 0.1 {unit} in + bewegen, mit cec_sign: error in −."
        " Wenn nicht: nichts laden und mit dem anderen Wert noch einmal ausführen. Wieder 0"
        " schreiben und sie ausschalten wie im Schritt davor."
    ),
    "Load the table": "Tabelle laden",
    "Load {file_1}: {points} points from {start} to {end} {unit} every {spacing} {unit}. The"
    " table holds the error, the opposite of the correction.": (
        "{file_1} laden: {points} Punkte von {start} bis {end} {unit} alle {spacing} {unit}."
        " Die Tabelle enthält den Fehler, das Gegenteil der Korrektur."
    ),
    "Load {file_3}: {points} points from {start} to {end} {unit} every {spacing} {unit},"
    " table {table_positive} for travel in +, table {table_negative} for travel in -. Each"
    " holds the whole correction of its direction.": (
        "{file_3} laden: {points} Punkte von {start} bis {end} {unit} alle {spacing} {unit},"
        " Tabelle {table_positive} für die Fahrt in +, Tabelle {table_negative} für die Fahrt"
        " in −. Jede enthält die ganze Korrektur ihrer Richtung."
    ),
    "Set the backlash and switch the table on": "Lose setzen und Tabelle einschalten",
    "{woken}Load {file_2} last (what was loaded with the table is not loaded again), or by"
    " hand: MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} and MD32700"
    " $MA_ENC_COMP_ENABLE[{index},{address}] = 1, which switches the table on. Then NEW"
    " CONF, and power on or reset.{others_back} {referencing}": (
        "{woken}{file_2} zuletzt laden (was mit der Tabelle geladen wurde, wird nicht noch"
        " einmal geladen), oder von Hand: MD32450 $MA_BACKLASH[{index},{address}] = {backlash}"
        " {backlash_unit} und MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 1, das die"
        " Tabelle einschaltet. Dann NEW CONF und Power On oder Reset.{others_back}"
        " {referencing}"
    ),
    "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first. Set"
    " MD32710 $MA_CEC_ENABLE[{address}] = 1, NEW CONF. Load {file_2} last (what was loaded"
    " with the table is not loaded again), or by hand: MD32450"
    " $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} and SD41300"
    " $SN_CEC_TABLE_ENABLE = 1 for the tables {table_positive} and {table_negative}, which"
    " switches them on. Then NEW CONF, NCK reset.{others_back} {referencing}": (
        "War MD32710 vorher 0: zuerst SD41300 = 0 für das, was auf Achse {address} sonst noch"
        " inaktiv ist. MD32710 $MA_CEC_ENABLE[{address}] = 1 setzen, NEW CONF. {file_2} zuletzt"
        " laden (was mit der Tabelle geladen wurde, wird nicht noch einmal geladen), oder von"
        " Hand: MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} und"
        " SD41300 $SN_CEC_TABLE_ENABLE = 1 für die Tabellen {table_positive} und"
        " {table_negative}, das sie einschaltet. Dann NEW CONF, NCK-Reset.{others_back}"
        " {referencing}"
    ),
    "Read the service display 'absolute compensation value measuring system {system}' at the"
    " check positions (their table stands with the axis). It should show the amounts that"
    " the control must add there. Whether this display counts them with the same sign is not"
    " confirmed: compare amounts here; the quick check shows the sign of the table.": (
        "Die Diagnoseanzeige „absoluter Kompensationswert Messsystem {system}“ an den"
        " Prüfpositionen ablesen (ihre Tabelle steht bei der Achse). Sie soll die Beträge"
        " zeigen, die die Steuerung dort addieren muss. Ob diese Anzeige sie mit demselben"
        " Vorzeichen zählt, ist nicht bestätigt: hier Beträge vergleichen; das Vorzeichen der"
        " Tabelle zeigt die Schnellprüfung."
    ),
    "Read the service display 'compensation, sag + temperature' at the check positions"
    " (their table stands with the axis). It should show the amounts that the control must"
    " add there. Whether this display counts them with the same sign is not confirmed:"
    " compare amounts here; the quick check shows the sign of the table.": (
        "Die Diagnoseanzeige „Kompensation Durchhang + Temperatur“ an den Prüfpositionen"
        " ablesen (ihre Tabelle steht bei der Achse). Sie soll die Beträge zeigen, die die"
        " Steuerung dort addieren muss. Ob diese Anzeige sie mit demselben Vorzeichen zählt,"
        " ist nicht bestätigt: hier Beträge vergleichen; das Vorzeichen der Tabelle zeigt die"
        " Schnellprüfung."
    ),
    "Export the table and the machine data again and compare them with the plan: `compwright"
    " compare JOB_FOLDER --loaded READ_BACK`.": (
        "Tabelle und Maschinendaten noch einmal ausgeben und mit dem Plan vergleichen:"
        " `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "By hand: MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0, MD32450"
    " $MA_BACKLASH[{index},{address}] as in column Old, then NEW CONF and power on or reset.": (
        "Von Hand: MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0, MD32450"
        " $MA_BACKLASH[{index},{address}] wie in Spalte Alt, dann NEW CONF und Power On oder"
        " Reset."
    ),
    "By hand: SD41300 $SN_CEC_TABLE_ENABLE = 0 for the tables {table_positive} and"
    " {table_negative}, MD32710 $MA_CEC_ENABLE[{address}] as it was, MD32450"
    " $MA_BACKLASH[{index},{address}] as in column Old, then NEW CONF and NCK reset.": (
        "Von Hand: SD41300 $SN_CEC_TABLE_ENABLE = 0 für die Tabellen {table_positive} und"
        " {table_negative}, MD32710 $MA_CEC_ENABLE[{address}] wie es war, MD32450"
        " $MA_BACKLASH[{index},{address}] wie in Spalte Alt, dann NEW CONF und NCK-Reset."
    ),
    "set the option cec: available, if the control has sag compensation, and name free"
    " indices in cec_tables": (
        "die Option cec: available setzen, wenn die Steuerung die Durchhangkompensation hat,"
        " und freie Indizes in cec_tables nennen"
    ),
    "MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit}": (
        "MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit}"
    ),
    "{room} Set {enable} = 0 and {switch} = 0 for {which}, NEW CONF. Note what MD32710 was"
    " before: if it was 0, find out what else is inactive on axis {address} (every other table"
    " with this output axis and a value that is not 0), and switch it off (SD41300 = 0)"
    " before anything else. MD32710 would activate it.": (
        "{room} {enable} = 0 und {switch} = 0 für {which} setzen, NEW CONF. Notieren, was"
        " MD32710 vorher war: War es 0, feststellen, was auf Achse {address} sonst noch inaktiv ist"
        " (jede andere Tabelle mit dieser Ausgangsachse und einem Wert, der nicht 0 ist), und"
        " es vor allem anderen ausschalten (SD41300 = 0). MD32710 würde es aktivieren."
    ),
    "Before {files} is loaded: write {value} {unit} into every point of {which} and switch"
    " {each} on for this check: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. A dial"
    " gauge on {address} must show +{value} {unit} for cec_sign: correction, -{value} {unit} for"
    " cec_sign: error. If it does not: load nothing, and run again with the other one. Write"
    " 0 again and switch off as in the step before.": (
        "Bevor {files} geladen wird: {value} {unit} in jeden Punkt von {which} schreiben und {each}"
        " für diese Prüfung einschalten: MD32710, NEW CONF, SD41300, NEW CONF, NCK-Reset. Eine"
        " Messuhr an {address} muss +{value} {unit} zeigen für cec_sign: correction, -{value}"
        " {unit} für cec_sign: error. Wenn nicht: nichts laden und mit dem anderen Wert noch einmal"
        " ausführen. Wieder 0 schreiben und ausschalten wie im Schritt davor."
    ),
    "{check} In use: {which}. The file holds its old values plus this correction. After"
    " the check its values are {value} or 0: if you load nothing, load its old values of the folder"
    " rollback again, and set MD32710 and SD41300 as they were.": (
        "{check} In Gebrauch: {which}. Die Datei enthält ihre alten Werte plus diese Korrektur."
        " Nach der Prüfung sind ihre Werte {value} oder 0: Wird nichts geladen, ihre alten Werte"
        " aus dem Ordner rollback wieder laden und MD32710 und SD41300 setzen wie zuvor."
    ),
    "Load {files}. {error}: {output} is moved by {ends}, 0 at the reference of {input}.": (
        "{files} laden. {error}: {output} wird um {ends} bewegt, 0 an der Referenz von {input}."
    ),
    "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first. Set"
    " {enable} = 1, NEW CONF, then {switch} = 1 for {which}, NEW CONF, NCK reset. Work"
    " offsets of {output} shift with {input}: probe them again. Compare the result with a"
    " square or a dial gauge before production.": (
        "War MD32710 vorher 0: zuerst SD41300 = 0 für das, was auf Achse {address} sonst noch"
        " inaktiv ist. {enable} = 1 setzen, NEW CONF, dann {switch} = 1 für {which}, NEW CONF,"
        " NCK-Reset. Nullpunktverschiebungen von {output} wandern mit {input}: neu antasten."
        " Das Ergebnis vor der Produktion mit einem Winkel oder einer Messuhr vergleichen."
    ),
    "it": "sie",
    "each of them": "jede davon",
    "{output} over {input}: reserve and switch off": (
        "{output} über {input}: reservieren und ausschalten"
    ),
    "{output} over {input}: switch on": "{output} über {input}: einschalten",
    "{value} {unit} at {input} {position}": "{value} {unit} bei {input} {position}",
    " Set {switch} = 0 (note what it was) and SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
    " {which}, NEW CONF: what the new table takes the place of is emptied, and protected"
    " while it is on.": (
        " {switch} = 0 (notieren, was es war) und SD41300 $SN_CEC_TABLE_ENABLE = 0 für {which}"
        " setzen, NEW CONF: Was die neue Tabelle ersetzt, wird geleert und ist geschützt,"
        " solange es eingeschaltet ist."
    ),
    "If MD32710 was on: set {switch} = 1 again, NEW CONF. ": (
        "War MD32710 ein: {switch} = 1 wieder setzen, NEW CONF. "
    ),
    "No gantry: MD37100 = 0 in the control's files.": (
        "Kein Gantry: MD37100 = 0 in den Dateien der Steuerung."
    ),
    " The patched files assign other tables again, which a control protects while they are"
    " on. Set {switches} = 0 too and activate it (NEW CONF).": (
        " Die geänderten Dateien setzen andere Tabellen noch einmal, die eine Steuerung"
        " schützt, solange sie eingeschaltet sind. Auch {switches} = 0 setzen und wirksam"
        " machen (NEW CONF)."
    ),
    " Then set {switches} = 1 again and activate it (NEW CONF).": (
        " Dann {switches} = 1 wieder setzen und wirksam machen (NEW CONF)."
    ),
    "The contents of the archive are not verified. Compare on the control, before anything"
    " is changed: {archive}. If one differs, load nothing: export the archive again, and run"
    " again.": (
        "Der Inhalt des Archivs ist nicht verifiziert. An der Steuerung vergleichen, bevor"
        " etwas geändert wird: {archive}. Weicht einer ab, nichts laden: das Archiv noch einmal"
        " ausgeben und noch einmal ausführen."
    ),
    "the tables {tables}": "die Tabellen {tables}",
    "{file}, then your own patched {files}": ("{file}, dann Ihre Dateien {files}, wie geändert,"),
    "tables {tables}": "Tabellen {tables}",
    "{points} points are needed for {which}: each has room for {room}, none are reserved.": (
        "{points} Punkte werden für {which} gebraucht: Jede hat Platz für {room}, keine werden"
        " reserviert."
    ),
    "table {tables}": "Tabelle {tables}",
    "MD18342 $MN_MM_CEC_MAX_POINTS must be at least {points} for {which}. If it is smaller:"
    " set it, save an archive, power on, load the archive back.": (
        "MD18342 $MN_MM_CEC_MAX_POINTS muss für {which} mindestens {points} sein. Ist es"
        " kleiner: setzen, ein Archiv anlegen, Power On, das Archiv zurückladen."
    ),
    "The service display 'absolute compensation value measuring system {system}' at the"
    " check positions of the card shows table and backlash together, without any"
    " measurement.": (
        "Die Diagnoseanzeige „absoluter Kompensationswert Messsystem {system}“ zeigt an den"
        " Prüfpositionen der Karte Tabelle und Lose zusammen, ohne jede Messung."
    ),
    "The service display 'compensation, sag + temperature' at the check positions of the"
    " card shows what the tables add, without any measurement.": (
        "Die Diagnoseanzeige „Kompensation Durchhang + Temperatur“ zeigt an den Prüfpositionen"
        " der Karte, was die Tabellen addieren, ohne jede Messung."
    ),
    "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] must be 1; while it is 1 a table is"
    " write protected, so it must have been 0 when the table was loaded.": (
        "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] muss 1 sein; solange es 1 ist, ist eine"
        " Tabelle schreibgeschützt, es muss also beim Laden der Tabelle 0 gewesen sein."
    ),
    "MD32710 $MA_CEC_ENABLE[{address}] of the output axis and SD41300 $SN_CEC_TABLE_ENABLE"
    " of both tables must be 1; MD32710 must have been 0 when they were loaded.": (
        "MD32710 $MA_CEC_ENABLE[{address}] der Ausgangsachse und SD41300 $SN_CEC_TABLE_ENABLE"
        " beider Tabellen müssen 1 sein; MD32710 muss beim Laden 0 gewesen sein."
    ),
    "The axis must be referenced, in measuring system {system}: before that no compensation"
    " is active, and a lost reference switches it off.": (
        "Die Achse muss referenziert sein, im Messsystem {system}: Vorher wirkt nichts, und"
        " eine verlorene Referenz schaltet es aus."
    ),
    "Which measuring system is in use? Values, switch and backlash of index {index} act in"
    " system {system} alone.": (
        "Welches Messsystem ist in Gebrauch? Werte, Schalter und Lose von Index {index} wirken"
        " nur im System {system}."
    ),
    "A positive value of $AA_ENC_COMP moves the axis in -: the table holds the error, as it"
    " was measured. Was it typed in, or converted, as a correction?": (
        "Ein positiver Wert von $AA_ENC_COMP bewegt die Achse in -: Die Tabelle enthält den"
        " Fehler, wie er gemessen wurde. Wurde er als Korrektur eingetippt oder umgerechnet?"
    ),
    "What a positive CEC value does is the option cec_sign: write +0.1 {unit} into a table"
    " that is free, as the card says; if the axis moves the other way, run again with the"
    " other one.": (
        "Was ein positiver CEC-Wert tut, ist die Option cec_sign: +0.1 {unit} in eine freie"
        " Tabelle schreiben, wie die Karte sagt; bewegt sich die Achse andersherum, mit dem"
        " anderen Wert noch einmal ausführen."
    ),
    "MD10240 and the line METRIC or INCH of the files: inch taken for mm is 25.4.": (
        "MD10240 und die Zeile METRIC oder INCH der Dateien: Zoll statt mm ist 25.4."
    ),
    "A second table on the axis: where MD32700 is 1, a CEC table of {address} over itself"
    " (MD32710, SD41300) is active in addition.": (
        "Eine zweite Tabelle auf der Achse: Eine CEC-Tabelle von {address} über sich selbst"
        " (MD32710, SD41300) neben MD32700 wirkt zusätzlich."
    ),
    "A second table on the axis: MD32700 must be 0 where a pair of CEC tables is used, and"
    " SD41310 $SN_CEC_TABLE_WEIGHT of both 1.": (
        "Eine zweite Tabelle auf der Achse: MD32700 muss neben einem Paar von CEC-Tabellen 0"
        " sein, und SD41310 $SN_CEC_TABLE_WEIGHT von beiden 1."
    ),
    "Radius and diameter: a table counts the way of the axis, a program in diameter shows"
    " twice of it.": (
        "Radius und Durchmesser: Eine Tabelle zählt den Weg der Achse, ein Programm im"
        " Durchmesser zeigt das Doppelte davon."
    ),
    "$AA_ENC_COMP_MIN and $AA_ENC_COMP_STEP[{index},{address}]: the position of point 0, and"
    " from point to point.": (
        "$AA_ENC_COMP_MIN und $AA_ENC_COMP_STEP[{index},{address}]: die Position von Punkt 0,"
        " und von Punkt zu Punkt."
    ),
    "$AN_CEC_MIN and $AN_CEC_STEP of both tables: the position of point 0, and from point to"
    " point.": (
        "$AN_CEC_MIN und $AN_CEC_STEP beider Tabellen: die Position von Punkt 0, und von Punkt"
        " zu Punkt."
    ),
    "Positions of the table are machine positions of {address}: was the axis referenced as"
    " for the measurement?": (
        "Positionen der Tabelle sind Maschinenpositionen von {address}: Wurde die Achse wie für"
        " die Messung referenziert?"
    ),
    "Point 0 stands at $AA_ENC_COMP_MIN[{index},{address}] and the last one at MAX: were the"
    " points entered from the other end?": (
        "Punkt 0 liegt bei $AA_ENC_COMP_MIN[{index},{address}] und der letzte bei MAX: Wurden"
        " die Punkte vom anderen Ende an eingegeben?"
    ),
    "Point 0 stands at $AN_CEC_MIN and the last one at MAX in both tables, that for - too:"
    " were the points entered from the other end?": (
        "Punkt 0 liegt bei $AN_CEC_MIN und der letzte bei MAX in beiden Tabellen, auch in der"
        " für -: Wurden die Punkte vom anderen Ende an eingegeben?"
    ),
    "The name in the brackets of $AA_ENC_COMP: {address} for axis {name}; by MD10000 a"
    " machine axis may also be called X1.": (
        "Der Name in den Klammern von $AA_ENC_COMP: {address} für Achse {name}; nach MD10000"
        " kann eine Maschinenachse auch X1 heißen."
    ),
    "$AN_CEC_INPUT_AXIS and $AN_CEC_OUTPUT_AXIS of both tables must be ({address}); by"
    " MD10000 a machine axis may also be called X1.": (
        "$AN_CEC_INPUT_AXIS und $AN_CEC_OUTPUT_AXIS beider Tabellen müssen ({address}) sein;"
        " nach MD10000 kann eine Maschinenachse auch X1 heißen."
    ),
    "This table is active in both directions. What is active in one direction only is a CEC"
    " table of the axis over itself ($AN_CEC_DIRECTION, SD41300 $SN_CEC_TABLE_ENABLE) or"
    " MD32450.": (
        "Diese Tabelle wirkt in beiden Richtungen: Was nur in einer wirkt, ist eine CEC-Tabelle"
        " der Achse über sich selbst ($AN_CEC_DIRECTION, SD41300 $SN_CEC_TABLE_ENABLE) oder"
        " MD32450."
    ),
    "$AN_CEC_DIRECTION of the two tables must be 1 and -1, and SD41300 $SN_CEC_TABLE_ENABLE"
    " of both 1.": (
        "$AN_CEC_DIRECTION der beiden Tabellen muss 1 und -1 sein, und SD41300"
        " $SN_CEC_TABLE_ENABLE von beiden 1."
    ),
    "MD32450 $MA_BACKLASH[{index},{address}], times MD32452: positive where the axis loses"
    " motion. It is active after NEW CONF, and once the axis is referenced.": (
        "MD32450 $MA_BACKLASH[{index},{address}], mal MD32452: positiv, wo die Achse Weg"
        " verliert. Es wirkt nach NEW CONF und sobald die Achse referenziert ist."
    ),
    "MD32456 $MA_BACKLASH_DYN, which the PLC switches, is active in addition to it.": (
        "MD32456 $MA_BACKLASH_DYN, das die PLC schaltet, wirkt daneben."
    ),
    "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] must be at least the number of"
    " points: with fewer the control shortens the table.": (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] muss mindestens die Anzahl der"
        " Punkte sein: Mit weniger kürzt die Steuerung die Tabelle."
    ),
    "MD18342 $MN_MM_CEC_MAX_POINTS of both tables must be at least the number of points (on"
    " the 828D 200, fixed).": (
        "MD18342 $MN_MM_CEC_MAX_POINTS beider Tabellen muss mindestens die Anzahl der Punkte"
        " sein (bei der 828D fest 200)."
    ),
    "$AA_ENC_COMP_MAX[{index},{address}] ends the table, and the end value stays beyond it.": (
        "$AA_ENC_COMP_MAX[{index},{address}] beendet die Tabelle, und der Endwert bleibt"
        " jenseits davon."
    ),
    "$AN_CEC_MAX ends the tables, and the end value stays beyond it.": (
        "$AN_CEC_MAX beendet die Tabellen, und der Endwert bleibt jenseits davon."
    ),
    "axis {name}: number of points of its CEC tables (MD18342)": (
        "Achse {name}: Anzahl der Punkte ihrer CEC-Tabellen (MD18342)"
    ),
    "axis {name}: limit of the sum of its CEC tables (MD32720)": (
        "Achse {name}: Grenze der Summe ihrer CEC-Tabellen (MD32720)"
    ),
    "not reached (default 1 {unit})": "nicht erreicht (Vorgabe 1 {unit})",
    "the control's files do not say it, or reserve none yet": (
        "die Dateien der Steuerung sagen es nicht oder reservieren noch keine"
    ),
    "in no file, its default from general knowledge": (
        "in keiner Datei, die Vorgabe aus allgemeiner Kenntnis"
    ),
    "one manual of Siemens says error; no readings depend on it here": (
        "ein Handbuch von Siemens sagt error; hier hängen keine Messwerte davon ab"
    ),
    "SINUMERIK 828D, leadscrew error compensation (EEC) with backlash (MD32450), cross-error"
    " compensation (CEC, 8 tables of 200 points) as an option": (
        "SINUMERIK 828D, Spindelsteigungsfehlerkompensation (EEC) mit Losekompensation"
        " (MD32450), Durchhangkompensation (CEC, 8 Tabellen mit je 200 Punkten) als Option"
    ),
    "SINUMERIK 840D powerline (840Di, 810D), leadscrew error compensation (EEC) with"
    " backlash (MD32450), cross-error compensation (CEC) as an option": (
        "SINUMERIK 840D powerline (840Di, 810D), Spindelsteigungsfehlerkompensation (EEC) mit"
        " Losekompensation (MD32450), Durchhangkompensation (CEC) als Option"
    ),
    "SINUMERIK 840D sl, leadscrew error compensation (EEC) with backlash (MD32450),"
    " cross-error compensation (CEC) as an option": (
        "SINUMERIK 840D sl, Spindelsteigungsfehlerkompensation (EEC) mit Losekompensation"
        " (MD32450), Durchhangkompensation (CEC) als Option"
    ),
    "SINUMERIK ONE, leadscrew error compensation (EEC) with backlash (MD32450), cross-error"
    " compensation (CEC) as an option": (
        "SINUMERIK ONE, Spindelsteigungsfehlerkompensation (EEC) mit Losekompensation"
        " (MD32450), Durchhangkompensation (CEC) als Option"
    ),
    "S1 p242 knows 0 and 1; 0 is the value of memory that was never written": (
        "S1 p242 kennt 0 und 1; 0 ist der Wert von Speicher, der nie beschrieben wurde"
    ),
    "S1 p249 knows 0 and 1; 0 is the value of memory that was never written": (
        "S1 p249 kennt 0 und 1; 0 ist der Wert von Speicher, der nie beschrieben wurde"
    ),
    "a table that was given counts as active; a job is asked (active)": (
        "eine gegebene Tabelle gilt als aktiv; ein Auftrag wird gefragt (active)"
    ),
    "neither the job nor the files say so": "weder Auftrag noch Dateien sagen es",
    "the sign of its values is not given (option cec_sign)": (
        "das Vorzeichen ihrer Werte ist nicht angegeben (Option cec_sign)"
    ),
    "{label}: during the test": "{label}: während der Prüfung",
    "{switches} end as 0, while the leadscrew table of the axis is on": (
        "{switches} enden als 0, während die Spindeltabelle der Achse eingeschaltet ist"
    ),
}
