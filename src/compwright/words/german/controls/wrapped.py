"""German texts for the controls of `formats.families.wrapped`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save the whole configuration of the card (all I-variables, the answers to LIST COMP"
    " DEF, LIST COMP, LIST BLCOMP DEF, LIST BLCOMP of every motor). Write down I51,"
    " I{address}85 and I{address}86.": (
        "Die ganze Konfiguration der Karte sichern (alle I-Variablen, die Antworten auf LIST"
        " COMP DEF, LIST COMP, LIST BLCOMP DEF, LIST BLCOMP jedes Motors). I51, I{address}85"
        " und I{address}86 notieren."
    ),
    "Check the counts": "Inkremente prüfen",
    "Everything here is worked out with {counts} counts per {unit} of axis {name} (motor"
    " #{address}). Move the axis by a known way and compare the motor's own position (the"
    " command P with #{address} addressed shows it): that many counts per {unit}, rising in"
    " + (negative: falling in +). Motor zero must be {reference} {unit}. If not, load"
    " nothing: correct counts_per_unit or reference in the job and run again.": (
        "Hier ist alles mit {counts} Inkrementen je {unit} der Achse {name} gerechnet (Motor"
        " #{address}). Die Achse um einen bekannten Weg bewegen und die eigene Position des"
        " Motors vergleichen (der Befehl P mit adressiertem #{address} zeigt sie): so viele"
        " Inkremente je {unit}, in + steigend (negativ: in + fallend). Der Nullpunkt des Motors"
        " muss {reference} {unit} sein. Wenn nicht, nichts laden: counts_per_unit oder"
        " reference im Auftrag berichtigen und noch einmal ausführen."
    ),
    "Room for the tables": "Platz für die Tabellen",
    "Home all motors, then I51=0: no table is active from here on; I{address}86 still is."
    " Delete from the lowest motor number up, every motor that has one: DELETE BLCOMP and"
    " DELETE COMP with this motor addressed; and what exists of GATHER, TBUF, ROTARY,"
    " LOOKAHEAD and TCOMP. Anything left makes the card answer ERR003. Tables of other motors"
    " that the script below does not hold are gone then: define them again from the highest"
    " motor down, before the script where their number is higher.": (
        "Alle Motoren referenzieren, dann I51=0: Von hier an wirkt keine Tabelle; I{address}86"
        " wirkt noch. Von der niedrigsten Motornummer an aufwärts bei jedem Motor löschen, der"
        " eine hat: DELETE BLCOMP und DELETE COMP mit diesem Motor adressiert; und was von"
        " GATHER, TBUF, ROTARY, LOOKAHEAD und TCOMP vorhanden ist. Was übrig bleibt, lässt die"
        " Karte mit ERR003 antworten. Tabellen anderer Motoren, die das Skript unten nicht"
        " enthält, sind danach weg: sie von der höchsten Motornummer an abwärts neu definieren,"
        " vor dem Skript, wo ihre Nummer höher ist."
    ),
    "Load the script": "Skript laden",
    "Send from tables/, in this order: {file_1}. A line SAVE in them would keep what is not"
    " checked yet: leave it out until the sign was checked. Motor #{address}, {tables}:"
    " {points} entries, every {spacing} {unit}, length {length} counts. An error other than"
    " ERR003 may mean that the memory of the card is full: fewer points (a wider spacing)"
    " help.": (
        "Aus tables/ senden, in dieser Reihenfolge: {file_1}. Eine Zeile SAVE darin würde"
        " festhalten, was noch nicht geprüft ist: sie auslassen, bis das Vorzeichen geprüft"
        " ist. Motor #{address}, {tables}: {points} Einträge, alle {spacing} {unit}, Länge"
        " {length} Inkremente. Ein anderer Fehler als ERR003 kann bedeuten, dass der Speicher"
        " der Karte voll ist: Weniger Punkte (ein größerer Punktabstand) helfen."
    ),
    "Backlash": "Lose",
    "I{address}86 = {constant} (1/16 count: {backlash} {unit} at motor zero). I{address}85 ="
    " {rate} (1/16 count per background cycle): with 0 no backlash is taken up. A rate that"
    " is too high jerks, one too low lags.": (
        "I{address}86 = {constant} (1/16 Inkrement: {backlash} {unit} am Nullpunkt des Motors)."
        " I{address}85 = {rate} (1/16 Inkrement je Hintergrundzyklus): Mit 0 wird keine Lose"
        " ausgeglichen. Eine zu hohe Rate ruckt, eine zu niedrige hinkt nach."
    ),
    "Keep the gap": "Lücke freihalten",
    "Axis {name}: {gap}.": "Achse {name}: {gap}.",
    "Before SAVE and before production: axis {name} from {check_from} to {check_to} {unit},"
    " coming from below, once with I51=0 and once with I51=1 (send it by hand). With the"
    " tables on the way must change by {check_change}. Does it change the other way, the"
    " sign of counts_per_unit is wrong: I51=0, correct the job and run again. Then come from"
    " above with I51=1: the axis stands lower by the backlash of the card.": (
        "Vor SAVE und vor der Produktion: Achse {name} von {check_from} nach {check_to} {unit},"
        " von unten kommend, einmal mit I51=0 und einmal mit I51=1 (von Hand senden). Mit"
        " eingeschalteten Tabellen muss sich der Weg um {check_change} ändern. Ändert er sich"
        " umgekehrt, ist das Vorzeichen von counts_per_unit falsch: I51=0, den Auftrag"
        " berichtigen und noch einmal ausführen. Dann mit I51=1 von oben kommen: Die Achse"
        " steht um die Lose der Karte tiefer."
    ),
    "Keep it": "Festhalten",
    "I51=1, define again what was deleted of GATHER, TBUF, ROTARY and LOOKAHEAD, then SAVE."
    " Until SAVE everything here is lost at the next reset ($$$): that is also the quick way"
    " back. A table is right only as long as homing finds the same motor zero: home after"
    " every restart before anything is measured.": (
        "I51=1, neu definieren, was von GATHER, TBUF, ROTARY und LOOKAHEAD gelöscht wurde, dann"
        " SAVE. Bis SAVE geht beim nächsten Reset ($$$) hier alles verloren: Das ist auch der"
        " schnelle Weg zurück. Eine Tabelle ist nur richtig, solange die Referenzfahrt"
        " denselben Nullpunkt des Motors findet: nach jedem Neustart referenzieren, bevor etwas"
        " gemessen wird."
    ),
    "Ask the card again (LIST COMP DEF and LIST COMP, LIST BLCOMP DEF and LIST BLCOMP with"
    " #{address} addressed, I51, I{address}85, I{address}86), write the answers as a script"
    " and compare them with the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`.": (
        "Die Karte noch einmal abfragen (LIST COMP DEF und LIST COMP, LIST BLCOMP DEF und LIST"
        " BLCOMP mit adressiertem #{address}, I51, I{address}85, I{address}86), die Antworten"
        " als Skript schreiben und mit dem Plan vergleichen: `compwright compare JOB_FOLDER"
        " --loaded READ_BACK`."
    ),
    "Reset ($$$) without SAVE; after SAVE delete as above, send the saved tables and set"
    " I51, I{address}85 and I{address}86 as written down.": (
        "Reset ($$$) ohne SAVE; nach SAVE löschen wie oben, die gesicherten Tabellen senden und"
        " I51, I{address}85 und I{address}86 setzen wie notiert."
    ),
    "Axis {name} is programmed in diameter: the table counts in the motor's own counts, so"
    " in radius, like the laser. Programs and displays show twice as much": (
        "Achse {name} ist im Durchmesser programmiert: Die Tabelle zählt in den eigenen"
        " Inkrementen des Motors, also im Radius, wie der Laser. Programme und Anzeigen zeigen"
        " das Doppelte"
    ),
    "define a table between the motors by hand, at a motor that has no table of its own (#k"
    " DEFINE COMP entries,#source D,#target,length; k the free motor, source the one of"
    " {input}, target the one of {output}; in 1/16 count of {output}, length in counts of"
    " {input}): a straight line that adds {squareness} rad times the way of {input}{shift}": (
        "von Hand eine Tabelle zwischen den Motoren definieren, an einem Motor ohne eigene"
        " Tabelle (#k DEFINE COMP entries,#source D,#target,length; k der freie Motor, source"
        " der von {input}, target der von {output}; in 1/16 Inkrement von {output}, length in"
        " Inkrementen von {input}): eine gerade Linie, die {squareness} rad mal den Weg von"
        " {input} addiert{shift}"
    ),
    "the length is one turn, and there is no gap": (
        "Die Länge ist eine Umdrehung, und es gibt keine Lücke"
    ),
    "what lies beyond {low} {unit} and below {high} {unit} is the gap that must stay unused"
    " (the table repeats after {turn} {unit}): keep the software limits inside": (
        "Was jenseits von {low} {unit} und unterhalb von {high} {unit} liegt, ist die Lücke,"
        " die unbenutzt bleiben muss (die Tabelle wiederholt sich nach {turn} {unit}): die"
        " Softwareendschalter innerhalb halten"
    ),
    "0 or as it is (there is no backlash)": "0 oder wie es ist (es gibt keine Lose)",
    "Ask the card again (LIST COMP DEF, LIST COMP, LIST BLCOMP with #{address} addressed,"
    " I51, I{address}85, I{address}86) and compare the answers with the plan; the variable"
    " Mxx69 shows what the tables add.": (
        "Die Karte noch einmal abfragen (LIST COMP DEF, LIST COMP, LIST BLCOMP mit adressiertem"
        " #{address}, I51, I{address}85, I{address}86) und die Antworten mit dem Plan"
        " vergleichen; die Variable Mxx69 zeigt, was die Tabellen addieren."
    ),
    "I51 must be 1: it switches all tables on.": "I51 muss 1 sein: Es schaltet alle Tabellen ein.",
    "After a reset only what SAVE has kept is there: LIST COMP DEF with #{address} addressed"
    " shows it.": (
        "Nach einem Reset ist nur da, was SAVE festgehalten hat: LIST COMP DEF mit adressiertem"
        " #{address} zeigt es."
    ),
    "ERR003 while the script was sent means that a table was not defined.": (
        "ERR003 beim Senden des Skripts heißt, dass eine Tabelle nicht definiert wurde."
    ),
    "Entries are added to the position in counts: does the motor #{address} count with the"
    " axis or against it (sign of counts_per_unit)?": (
        "Einträge werden zur Position in Inkrementen addiert: Zählt der Motor #{address} mit"
        " der Achse oder gegen sie (Vorzeichen von counts_per_unit)?"
    ),
    "Entries are 1/16 counts of motor #{address}: counts per {unit} of the motor, whatever"
    " its scale factor is (counts_per_unit).": (
        "Einträge sind 1/16 Inkremente von Motor #{address}: Inkremente je {unit} des Motors,"
        " gleich welcher Skalierungsfaktor gilt (counts_per_unit)."
    ),
    "Positions count from the motor zero of the last homing: it must be {reference} {unit},"
    " as for the measurement.": (
        "Positionen zählen vom Nullpunkt des Motors der letzten Referenzfahrt: Er muss bei"
        " {reference} {unit} liegen, wie für die Messung."
    ),
    "DEFINE COMP: the first entry stands one spacing behind motor zero, and the spacing is"
    " the length divided by the entries.": (
        "DEFINE COMP: Der erste Eintrag liegt einen Punktabstand hinter dem Nullpunkt des"
        " Motors, und der Punktabstand ist die Länge durch die Einträge."
    ),
    "Entries run in the direction in which the motor counts; what lies below motor zero is"
    " the upper end of the table.": (
        "Einträge laufen in der Richtung, in der der Motor zählt; was unter dem Nullpunkt des"
        " Motors liegt, ist das obere Ende der Tabelle."
    ),
    "DEFINE COMP names the motors: #{address} by itself as source and as target.": (
        "DEFINE COMP nennt die Motoren: #{address} allein als Quelle und als Ziel."
    ),
    "COMP is active in both directions; BLCOMP and I{address}86 only while the last command"
    " went in the negative counting direction.": (
        "COMP wirkt in beiden Richtungen; BLCOMP und I{address}86 wirken nur, solange der"
        " letzte Befehl in negativer Zählrichtung ging."
    ),
    "I{address}86, in 1/16 counts, with BLCOMP added to it; I{address}85 = 0 takes up no"
    " backlash at all.": (
        "I{address}86, in 1/16 Inkrement, mit BLCOMP dazu addiert; I{address}85 = 0 gleicht gar"
        " keine Lose aus."
    ),
    "I{address}87 is the hysteresis of the reversal.": (
        "I{address}87 ist die Hysterese der Umkehr."
    ),
    "DEFINE COMP: number of entries and length. Outside 0 to the length the position rolls"
    " over into the table, so it must be longer than the travel.": (
        "DEFINE COMP: Anzahl der Einträge und Länge. Außerhalb von 0 bis zur Länge läuft die"
        " Position wieder in die Tabelle, sie muss also länger als der Verfahrweg sein."
    ),
    "Delta Tau PMAC, Turbo PMAC (UMAC, Geo Brick), leadscrew and backlash tables (DEFINE"
    " COMP, DEFINE BLCOMP)": (
        "Delta Tau PMAC, Turbo PMAC (UMAC, Geo Brick), Tabellen für Spindelsteigung und Lose"
        " (DEFINE COMP, DEFINE BLCOMP)"
    ),
    "P10 for the unit; how fast suits a machine no manual says: 32 is 2 counts per"
    " background cycle": (
        "P10 für die Einheit; welche Geschwindigkeit zu einer Maschine passt, sagt kein"
        " Handbuch: 32 sind 2 Inkremente je Hintergrundzyklus"
    ),
    "in no script, and no table of backlash needs it": (
        "in keinem Skript, und keine Losetabelle braucht es"
    ),
    "in no script; a card that uses tables has it on": (
        "in keinem Skript; eine Karte, die Tabellen benutzt, hat es eingeschaltet"
    ),
}
