"""German texts for the controls of `formats.families.increments`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save all parameters and the pitch error data of the control to a card or PC; they are"
    " two files from two screens. Keep them untouched.": (
        "Alle Parameter und die Steigungsfehlerdaten der Steuerung auf Karte oder PC sichern;"
        " es sind zwei Dateien aus zwei Bildschirmen. Beide unverändert aufheben."
    ),
    "Record the old values": "Alte Werte notieren",
    "Axis {name} is controlled axis {address}. Note its old 1851 and {at_reference} to"
    " {at_spacing} before you change them.": (
        "Achse {name} ist die gesteuerte Achse {address}. Ihre alten Werte 1851 und"
        " {at_reference} bis {at_spacing} notieren, bevor sie geändert werden."
    ),
    "Load parameters and pitch data, both in one step": (
        "Parameter und Steigungsdaten laden, beides in einem Schritt"
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
        "Beides, bevor die Steuerung ausgeschaltet wird und bevor sich eine Achse bewegt: Ein"
        " neuer Wert {at_magnification} vervielfacht alte Punkte, neue Nummern geben sie"
        " anderen Abschnitten. Parameter: {at_reference} = {reference_number}, {at_first} ="
        " {first_number}, {at_last} = {last_number}, {at_magnification} = {magnification},"
        " {at_spacing} = {spacing} {unit}, 1851 = {backlash} Erfassungseinheiten von"
        " {detection_unit}, {further} (nur Achse {address}; die Gruppen der anderen Achsen"
        " nicht ändern). Steigungsdaten: Punkte {first_number} bis {last_number}: die Datei mit"
        " den Steigungsdaten aus dem Ordner tables/ laden oder das Blatt entry_{sheet}.csv"
        " eintippen. Dass eine Steuerung die Form annimmt, in der sie ihre Punkte ausgibt,"
        " wurde hier nicht erprobt: den Bildschirm mit dem Blatt vergleichen."
    ),
    "Alarm 000 (power off) is expected. Switch the control off and on: the parameters of the"
    " table are active only after that.": (
        "Alarm 000 (Strom aus) ist zu erwarten. Die Steuerung aus- und einschalten: Erst danach"
        " sind die Parameter der Tabelle aktiv."
    ),
    "Reference the axis": "Achse referenzieren",
    "{referencing}": "{referencing}",
    "No page of the maker states the sign of pitch data. Before the full test measure two"
    " positions, {check_from} and {check_to} {unit}, with {at_magnification} ="
    " {magnification} and with {at_magnification} = 0 (power cycle each time): with"
    " compensation on, the distance must be {check_change} longer (negative: shorter). If it"
    " is the opposite, set the option pitch_sign to {other_sign} and run again.": (
        "Keine Seite des Herstellers nennt das Vorzeichen der Steigungsdaten. Vor der ganzen"
        " Prüfung zwei Positionen messen, {check_from} und {check_to} {unit}, mit"
        " {at_magnification} = {magnification} und mit {at_magnification} = 0 (jedes Mal aus-"
        " und einschalten): Mit Kompensation muss der Abstand um {check_change} länger sein"
        " (negativ: kürzer). Ist es umgekehrt, die Option pitch_sign auf {other_sign} setzen"
        " und noch einmal ausführen."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive 1851 moves on in the direction of"
    " the new motion.": (
        "Eine Messuhr bei Anfahrt in {reference_return} auf null stellen, dann von der anderen"
        " Seite zurückkommen: Der Unterschied, der bleibt, muss klein sein. Ein positiver Wert"
        " 1851 führt in der Richtung der neuen Bewegung weiter."
    ),
    "Save parameters and pitch data again and compare them with the plan: `compwright"
    " compare JOB_FOLDER --loaded READ_BACK`.": (
        "Parameter und Steigungsdaten noch einmal sichern und mit dem Plan vergleichen:"
        " `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "Load the saved parameters and pitch data in one step, then power cycle and reference as"
    " above. By hand: 1851 and {at_reference} to {at_spacing} as noted; {at_magnification} ="
    " 0 switches the points of axis {address} off.": (
        "Die gesicherten Parameter und Steigungsdaten in einem Schritt laden, dann aus- und"
        " einschalten und referenzieren wie oben. Von Hand: 1851 und {at_reference} bis"
        " {at_spacing} wie notiert; {at_magnification} = 0 schaltet die Punkte der Achse"
        " {address} aus."
    ),
    "straightness compensation is an option of the control, and its parameter numbers are"
    " not confirmed here: enter the two-point line by the machine's own manual": (
        "die Geradheitskompensation ist eine Option der Steuerung, und ihre Parameternummern"
        " sind hier nicht bestätigt: die Linie mit zwei Punkten nach dem Handbuch der Maschine"
        " eingeben"
    ),
    "1851 of axis {address} = {backlash} detection units of {detection_unit}": (
        "1851 der Achse {address} = {backlash} Erfassungseinheiten von {detection_unit}"
    ),
    "1852 = {value} detection units ({active})": "1852 = {value} Erfassungseinheiten ({active})",
    "at rapid traverse; 1851 is active at cutting feed, because 1800#4 = 1": (
        "im Eilgang; im Arbeitsvorschub ist 1851 aktiv, weil 1800#4 = 1 ist"
    ),
    "is not active and stays as it is: 1851 is active at all feeds, because 1800#4 = 0": (
        "ist nicht aktiv und bleibt, wie es ist: 1851 ist bei jedem Vorschub aktiv, weil 1800#4"
        " = 0 ist"
    ),
    "is active at rapid traverse if 1800#4 = 1, which is in no file": (
        "ist im Eilgang aktiv, wenn 1800#4 = 1 ist, was in keiner Datei steht"
    ),
    "{sentence} Prove the sign with a square or a dial gauge, on and off, before production.": (
        "{sentence} Das Vorzeichen vor der Produktion mit einem Winkel oder einer Messuhr"
        " nachweisen, ein und aus."
    ),
    "{sentence} Its numbers and its sign are unconfirmed: prove them with a square or a dial"
    " gauge, on and off, before production.": (
        "{sentence} Seine Nummern und sein Vorzeichen sind unbestätigt: sie vor der Produktion"
        " mit einem Winkel oder einer Messuhr nachweisen, ein und aus."
    ),
    "{output} over {input}: straightness compensation": (
        "{output} über {input}: Geradheitskompensation"
    ),
    "every pair of straightness compensation (5711 to 5713) is in use": (
        "alle Paare der Geradheitskompensation (5711 bis 5713) sind belegt"
    ),
    "straightness compensation counts the points of the pitch table of the moving axis {input},"
    " which has none. Next: give {input} a positioning test (`before`), or the control's files with"
    " its pitch data (`states`)": (
        "die Geradheitskompensation zählt die Punkte der Steigungstabelle der bewegten Achse"
        " {input}, und diese hat keine. Als Nächstes: für {input} eine Positionsprüfung (`before`)"
        " oder die Dateien der Steuerung mit ihren Steigungsdaten (`states`) angeben"
    ),
    "straightness compensation is known for one straight line over a table only": (
        "die Geradheitskompensation ist nur für eine gerade Linie über einer Tabelle bekannt"
    ),
    "Absolute encoder: no reference return. Leave its adjustment alone (1815): machine zero"
    " would be lost.": (
        "Absoluter Geber: keine Referenzfahrt. Seine Justierung nicht ändern (1815): Der"
        " Maschinennullpunkt ginge verloren."
    ),
    "owns {low} to {high} {unit}": "gehört {low} bis {high} {unit}",
    "A point holds the change of the correction over its own section, looking from - to +,"
    " in detection units times the magnification; at the reference position ({zero} {unit})"
    " the correction is 0.": (
        "Ein Punkt enthält die Änderung der Korrektur über seinen eigenen Abschnitt, von - nach"
        " + gesehen, in Erfassungseinheiten mal Vergrößerung; an der Referenzposition ({zero}"
        " {unit}) ist die Korrektur 0."
    ),
    "it stands for the same section as point {last} and must hold the same value": (
        "sie steht für denselben Abschnitt wie Punkt {last} und muss denselben Wert enthalten"
    ),
    "{parameter} = {number} {owns}, the last.": (
        "{parameter} = {number}: Ihm {owns}, der letzte Abschnitt."
    ),
    "set too: {function}, whose points are in the sheet; its sign and where its period"
    " starts are unconfirmed, so measure one period in its sections with it and with 14985"
    " to 14987 = 0 (power cycle each time) before production": (
        "ebenfalls gesetzt: {function}, dessen Punkte im Blatt sind; sein Vorzeichen und der"
        " Beginn seiner Periode sind unbestätigt, deshalb vor der Produktion eine Periode in"
        " seinen Abschnitten damit und mit 14985 bis 14987 = 0 messen (jedes Mal aus- und"
        " einschalten)"
    ),
    "set too: {function}; its sign and unit are unconfirmed, so measure both ends of the"
    " travel with these amounts and with 0 (power cycle each time) before you switch on the"
    " whole table": (
        "ebenfalls gesetzt: {function}; Vorzeichen und Einheit sind unbestätigt, deshalb beide"
        " Enden des Verfahrwegs mit diesen Beträgen und mit 0 messen (jedes Mal aus- und"
        " einschalten), bevor die ganze Tabelle eingeschaltet wird"
    ),
    "leave unchanged what is active in addition to the table: {kept}": (
        "nicht ändern, was zusätzlich zur Tabelle aktiv ist: {kept}"
    ),
    "{value} detection units": "{value} Erfassungseinheiten",
    "{parameter} = {reference} is the number of the reference: {owns}; {next} to {last} are"
    " the sections of one turn and add up to 0.": (
        "{parameter} = {reference} ist die Nummer der Referenz: {owns}; {next} bis {last} sind"
        " die Abschnitte einer Umdrehung und ergeben zusammen 0."
    ),
    "{parameter} = {number} {owns}, the first.": (
        "{parameter} = {number}: Ihm {owns}, der erste Abschnitt."
    ),
    "For travel in - the same sections have the numbers {first} to {last} ({parameter}).": (
        "Für die Fahrt in - haben dieselben Abschnitte die Nummern {first} bis {last}"
        " ({parameter})."
    ),
    "set too, because the grid moves and these positions stay: {kept}": (
        "ebenfalls gesetzt, weil das Raster sich verschiebt und diese Positionen bleiben: {kept}"
    ),
    "{parameter} = {number} {owns}, at the reference.": (
        "{parameter} = {number}: Ihm {owns}, an der Referenz."
    ),
    "Point {number} holds {value}: its section lies beyond the travel.": (
        "Punkt {number} enthält {value}: Sein Abschnitt liegt außerhalb des Verfahrwegs."
    ),
    "it owns no section": "ihr gehört kein Abschnitt",
    "Bit 0 of 8135 (NPE) must be 0: 1 switches stored pitch error compensation off.": (
        "Bit 0 von 8135 (NPE) muss 0 sein: 1 schaltet die gespeicherte"
        " Steigungsfehlerkompensation aus."
    ),
    "3623 of axis {address}: the pitch data are multiplied by it, 0 switches the table off.": (
        "3623 der Achse {address}: Die Steigungsdaten werden damit vervielfacht, 0 schaltet die"
        " Tabelle aus."
    ),
    "Were the pitch data loaded too? They come from another screen than the parameters;"
    " compare the points with the sheet.": (
        "Wurden auch die Steigungsdaten geladen? Sie kommen aus einem anderen Bildschirm als"
        " die Parameter; die Punkte mit dem Blatt vergleichen."
    ),
    "3620 to 3627 are active only after power off and on, and then, with an incremental"
    " encoder, only after the reference return.": (
        "3620 bis 3627 sind erst nach Aus- und Einschalten aktiv, und bei einem inkrementellen"
        " Geber dann erst nach der Referenzfahrt."
    ),
    "Save parameters and pitch data again and compare them with the plan (`compwright"
    " compare JOB_FOLDER --loaded READ_BACK`): 5420 to 5425, 1851 and the points tell apart"
    " what this test cannot.": (
        "Parameter und Steigungsdaten noch einmal sichern und mit dem Plan vergleichen"
        " (`compwright compare JOB_FOLDER --loaded READ_BACK`): 5420 bis 5425, 1851 und die"
        " Punkte unterscheiden, was diese Prüfung nicht kann."
    ),
    "5423 of axis {address}: the pitch data are multiplied by it, 0 switches the table off.": (
        "5423 der Achse {address}: Die Steigungsdaten werden damit vervielfacht, 0 schaltet die"
        " Tabelle aus."
    ),
    "Were the pitch data loaded too? Compare the points with the sheet.": (
        "Wurden auch die Steigungsdaten geladen? Die Punkte mit dem Blatt vergleichen."
    ),
    "5420 to 5425 are active only after power off and on, and then, with an incremental"
    " encoder, only after the reference return.": (
        "5420 bis 5425 sind erst nach Aus- und Einschalten aktiv, und bei einem inkrementellen"
        " Geber dann erst nach der Referenzfahrt."
    ),
    "No page of the maker states the sign of pitch data: compare 5423 as set with 5423 = 0"
    " as the card says; if the distance changes the wrong way, run again with the other"
    " pitch_sign.": (
        "Keine Seite des Herstellers nennt das Vorzeichen der Steigungsdaten: 5423 wie gesetzt"
        " mit 5423 = 0 vergleichen, wie die Karte sagt; ändert sich der Abstand falsch herum,"
        " mit dem anderen pitch_sign noch einmal ausführen."
    ),
    "Were the points typed in as errors? The sheet holds corrections, as steps from point to"
    " point.": (
        "Wurden die Punkte als Fehler eingetippt? Das Blatt enthält Korrekturen, als Stufen von"
        " Punkt zu Punkt."
    ),
    "5423 of axis {address}: every point is multiplied by it.": (
        "5423 der Achse {address}: Jeder Punkt wird damit vervielfacht."
    ),
    "The detection unit of axis {address}: another one than the job's scales table and 1851"
    " alike, mostly by 10.": (
        "Die Erfassungseinheit der Achse {address}: Eine andere als die des Auftrags skaliert"
        " Tabelle und 1851 gleich, meist um 10."
    ),
    "Bit 3 of 1006 (diameter): radius and diameter differ by 2.": (
        "Bit 3 von 1006 (Durchmesser): Radius und Durchmesser unterscheiden sich um 2."
    ),
    "5420 of axis {address}, the number of the point at the reference position: one too many"
    " moves the table by one interval (5424).": (
        "5420 der Achse {address}, die Nummer des Punkts an der Referenzposition: Eins zu viel"
        " verschiebt die Tabelle um einen Punktabstand (5424)."
    ),
    "Were the points typed in from the right number on? Number n stands for the section"
    " below the point n - 5420.": (
        "Wurden die Punkte ab der richtigen Nummer eingetippt? Nummer n steht für den Abschnitt"
        " unterhalb des Punkts n - 5420."
    ),
    "Were the points typed in from the wrong end? Their numbers grow in the direction +,"
    " from 5421 to 5422, on both sides of the reference.": (
        "Wurden die Punkte vom falschen Ende an eingetippt? Ihre Nummern wachsen in Richtung +,"
        " von 5421 bis 5422, auf beiden Seiten der Referenz."
    ),
    "5420 to 5422 of all axes: they share one row of points, and the numbers of axis"
    " {address} must be its own.": (
        "5420 bis 5422 aller Achsen: Sie teilen sich eine Reihe von Punkten, und die Nummern"
        " der Achse {address} müssen ihre eigenen sein."
    ),
    "The A in the parameter file is the number of the controlled axis: {address} for {name}.": (
        "Das A in der Parameterdatei ist die Nummer der gesteuerten Achse: {address} für {name}."
    ),
    "No second table is known here: what is active in one direction only is 1851.": (
        "Eine zweite Tabelle ist hier nicht bekannt: Was nur in einer Richtung wirkt, ist 1851."
    ),
    "1851 of axis {address}, in detection units.": (
        "1851 der Achse {address}, in Erfassungseinheiten."
    ),
    "It is active from the first move against the reference return on, so approach twice from"
    " each side before a reading counts.": (
        "Es wirkt ab der ersten Bewegung gegen die Referenzfahrt, deshalb von jeder Seite"
        " zweimal anfahren, bevor ein Messwert zählt."
    ),
    "5421 and 5422 of axis {address}, the points farthest in - and in +: beyond them the"
    " table does not go on.": (
        "5421 und 5422 der Achse {address}, die äußersten Punkte in - und in +: Jenseits davon"
        " geht die Tabelle nicht weiter."
    ),
    "Are all points between them in the control? Compare the screen with the sheet, point by"
    " point.": (
        "Sind alle Punkte dazwischen in der Steuerung? Den Bildschirm mit dem Blatt"
        " vergleichen, Punkt für Punkt."
    ),
    "Save parameters and pitch data again and compare both with the plan (`compwright"
    " compare JOB_FOLDER --loaded READ_BACK`): 3620 to 3625, 1851 and the points tell apart"
    " what this test cannot.": (
        "Parameter und Steigungsdaten noch einmal sichern und beides mit dem Plan vergleichen"
        " (`compwright compare JOB_FOLDER --loaded READ_BACK`): 3620 bis 3625, 1851 und die"
        " Punkte unterscheiden, was diese Prüfung nicht kann."
    ),
    "No page of the maker states the sign of pitch data: compare 3623 as set with 3623 = 0"
    " as the card says; if the distance changes the wrong way, run again with the other"
    " pitch_sign.": (
        "Keine Seite des Herstellers nennt das Vorzeichen der Steigungsdaten: 3623 wie gesetzt"
        " mit 3623 = 0 vergleichen, wie die Karte sagt; ändert sich der Abstand falsch herum,"
        " mit dem anderen pitch_sign noch einmal ausführen."
    ),
    "3623 of axis {address}: every point is multiplied by it.": (
        "3623 der Achse {address}: Jeder Punkt wird damit vervielfacht."
    ),
    "The detection unit of axis {address} (1820 with 1013): another one than the plan's"
    " scales table and 1851 alike, mostly by 10.": (
        "Die Erfassungseinheit der Achse {address} (1820 mit 1013): Eine andere als die des"
        " Plans skaliert Tabelle und 1851 gleich, meist um 10."
    ),
    "3620 of axis {address}, the number of the point at the reference position: one too many"
    " moves the table by one interval (3624).": (
        "3620 der Achse {address}, die Nummer des Punkts an der Referenzposition: Eins zu viel"
        " verschiebt die Tabelle um einen Punktabstand (3624)."
    ),
    "Were the points typed in from the right number on? Number n stands for the section"
    " below the point n - 3620.": (
        "Wurden die Punkte ab der richtigen Nummer eingetippt? Nummer n steht für den Abschnitt"
        " unterhalb des Punkts n - 3620."
    ),
    "Were the points typed in from the wrong end? Their numbers grow in the direction +,"
    " from 3621 to 3622, on both sides of the reference.": (
        "Wurden die Punkte vom falschen Ende an eingetippt? Ihre Nummern wachsen in Richtung +,"
        " von 3621 bis 3622, auf beiden Seiten der Referenz."
    ),
    "3620 to 3622 of all axes: they share one row of points, and the numbers of axis"
    " {address} must be its own.": (
        "3620 bis 3622 aller Achsen: Sie teilen sich eine Reihe von Punkten, und die Nummern"
        " der Achse {address} müssen ihre eigenen sein."
    ),
    "Bit 0 of 3605 of axis {address}: with 1 there are two tables, and the points from 3626"
    " on act while it travels in -.": (
        "Bit 0 von 3605 der Achse {address}: Mit 1 gibt es zwei Tabellen, und die Punkte ab"
        " 3626 wirken bei der Fahrt in -."
    ),
    "3627 ties the second table at the reference position: a wrong value moves one direction"
    " as a whole.": (
        "3627 bindet die zweite Tabelle an der Referenzposition an: Ein falscher Wert"
        " verschiebt eine Richtung als Ganzes."
    ),
    "1851 of axis {address}, in detection units; where bit 4 of 1800 is 1, 1852 is active in"
    " its place at rapid traverse.": (
        "1851 der Achse {address}, in Erfassungseinheiten; wo Bit 4 von 1800 gleich 1 ist,"
        " wirkt im Eilgang 1852 an seiner Stelle."
    ),
    "With two tables (bit 0 of 3605) 1851 is active in addition to them, and must be 0 where"
    " the tables hold the reversal.": (
        "Mit zwei Tabellen (Bit 0 von 3605) wirkt 1851 zusätzlich und muss 0 sein, wo sie die"
        " Umkehr enthalten."
    ),
    "3621 and 3622 of axis {address}, the points farthest in - and in +: beyond them the"
    " table does not go on.": (
        "3621 und 3622 der Achse {address}, die äußersten Punkte in - und in +: Jenseits davon"
        " geht die Tabelle nicht weiter."
    ),
    "{label}: bidirectional compensation": "{label}: Kompensation in beiden Richtungen",
    "as 3605#0, 3626 and 3627 are understood": "wie 3605#0, 3626 und 3627 verstanden werden",
    "no manual page": "keine Handbuchseite",
    "no file says what the numbers {numbers} hold; give all of the control's pitch data, or"
    " first_point": (
        "keine Datei sagt, was die Nummern {numbers} enthalten; alle Steigungsdaten der"
        " Steuerung oder first_point angeben"
    ),
    "at most {gap} in a row": "höchstens {gap} in einer Reihe",
    "point numbers for its table": "Punktnummern für ihre Tabelle",
    "not checked: the option max_feed is not given, and no file says the rapid traverse (1420)": (
        "nicht geprüft: Die Option max_feed ist nicht angegeben, und keine Datei nennt den"
        " Eilgang (1420)"
    ),
    "smallest interval for its feed": "kleinster Punktabstand für ihren Vorschub",
    "{label}: detection unit": "{label}: Erfassungseinheit",
    "1820 = {multiplier} (CMR {cmr}) and {system} = {setting} (least command increment {least}"
    " {unit}{inch})": (
        "1820 = {multiplier} (CMR {cmr}) und {system} = {setting} (kleinstes Befehlsinkrement"
        " {least} {unit}{inch})"
    ),
    ", inch machine by 1001#0": ", Zollmaschine nach 1001#0",
    "read: {evidence}": "gelesen: {evidence}",
    "FANUC 0i-A to C, 16i/18i/21i, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-A bis C, 16i/18i/21i, gespeicherte Steigungsfehlerkompensation mit"
        " Losekompensation (1851)"
    ),
    "FANUC 0i-D, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-D, gespeicherte Steigungsfehlerkompensation mit Losekompensation (1851)"
    ),
    "FANUC 0i-F, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-F, gespeicherte Steigungsfehlerkompensation mit Losekompensation (1851)"
    ),
    "FANUC 15i, stored pitch error compensation with backlash (1851), all numbers unconfirmed": (
        "FANUC 15i, gespeicherte Steigungsfehlerkompensation mit Losekompensation (1851), alle"
        " Nummern unbestätigt"
    ),
    "FANUC 30i/31i/32i, stored pitch error compensation with backlash (1851)": (
        "FANUC 30i/31i/32i, gespeicherte Steigungsfehlerkompensation mit Losekompensation (1851)"
    ),
    "A-78868E pages 3 and 6 for a rotary worm: numbers in the array of pitch data,"
    " increments, sum 0; sign, 3623 and where the period starts: not on these pages": (
        "A-78868E Seiten 3 und 6 für eine Rundachse mit Schnecke: Nummern im Feld der"
        " Steigungsdaten, Schritte, Summe 0; Vorzeichen, 3623 und Beginn der Periode: nicht auf"
        " diesen Seiten"
    ),
    "B-63522EN/02 page 222: numbers of pitch points, amounts in detection units, added at"
    " the pitch intervals; sign of the pitch data, and that 3623 does not multiply it:"
    " general knowledge": (
        "B-63522EN/02 Seite 222: Nummern der Steigungspunkte, Beträge in Erfassungseinheiten,"
        " an den Punktabständen addiert; Vorzeichen wie bei den Steigungsdaten, und dass 3623"
        " nicht vervielfacht: aus allgemeiner Kenntnis"
    ),
    "F1, the sentence is cut": "F1, der Satz ist abgeschnitten",
    "F1: the reference position has a point number; no manual states that the sections"
    " follow 1240": (
        "F1: Die Referenzposition hat eine Punktnummer; kein Handbuch sagt, dass die Abschnitte"
        " 1240 folgen"
    ),
    "inferred from a note printed next to F16 and from F20; no sentence of the maker: prove"
    " it on the machine as the card says": (
        "geschlossen aus einer gedruckten Notiz neben F16 und aus F20; kein Satz des"
        " Herstellers: an der Maschine prüfen, wie auf der Karte beschrieben"
    ),
    "general knowledge, that of the later series": (
        "aus allgemeiner Kenntnis, Wert der späteren Baureihen"
    ),
    "general knowledge: 7 on 0i-A to C, 16i, 18i, 21i and 15i": (
        "aus allgemeiner Kenntnis: 7 bei 0i-A bis C, 16i, 18i, 21i und 15i"
    ),
    "general knowledge: 7, as on the 0i-D": "aus allgemeiner Kenntnis: 7, wie bei 0i-D",
    "general knowledge: parameters 5711, 5721, 5731 to 5734, 5761 to 5764": (
        "aus allgemeiner Kenntnis: Parameter 5711, 5721, 5731 bis 5734, 5761 bis 5764"
    ),
    "general knowledge: the interval must be at least the largest feed / 7500": (
        "aus allgemeiner Kenntnis: Der Punktabstand muss mindestens der größte Vorschub / 7500 sein"
    ),
    "{first} to {last} ({count} numbers)": "{first} bis {last} ({count} Nummern)",
    "not in the files that were given": "nicht in den gegebenen Dateien",
    "step": "Schritt (step)",
    "1800#4 is not in the files": ("1800#4 ist nicht in den Dateien"),
    "the bit that makes 1852 active is unknown": ("das Bit, das 1852 wirksam macht, ist unbekannt"),
    "1821 = {count} detection units of {size} {unit} between two marks, encoder on"
    " the motor (1815#1 = 0); inferred": (
        "1821 = {count} Erfassungseinheiten zu {size} {unit} zwischen zwei Marken, Geber am"
        " Motor (1815#1 = 0); geschlossen"
    ),
}
