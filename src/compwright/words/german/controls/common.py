"""German texts for the card and for controls of several `formats.families`, keyed by the English
texts.
"""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save first": "Zuerst sichern",
    "Power cycle": "Aus- und einschalten",
    "Check the sign": "Vorzeichen prüfen",
    "Check the backlash": "Lose prüfen",
    "Read back": "Zurücklesen",
    "The old table": "Die alte Tabelle",
    "Axis {name} is programmed in diameter: the laser and this table count in radius."
    " Programs and displays show twice as much; if the quick check is off by a factor of"
    " two, the control counts its table in diameter": (
        "Achse {name} ist im Durchmesser programmiert: Laser und diese Tabelle zählen im"
        " Radius. Programme und Anzeigen zeigen das Doppelte; weicht die Schnellprüfung um den"
        " Faktor zwei ab, zählt die Steuerung ihre Tabelle im Durchmesser"
    ),
    "Restart": "Neu starten",
    "Gantry": "Gantry",
    "{gantry}": "{gantry}",
    "Check what is active": "Prüfen, was aktiv ist",
    "{low} to {high} {unit}": "{low} bis {high} {unit}",
    "points of the table": "Punkte der Tabelle",
    "range of the table": "Bereich der Tabelle",
    "corrections from, to": "Korrekturen von, bis",
    "backlash in addition to the table": "Lose zusätzlich zur Tabelle",
    "The files in tables/: {files}.": "Die Dateien in tables/: {files}.",
    "The job says that nothing was active.": "Laut Auftrag war nichts aktiv.",
    "To go back: switch the compensation of these axes off as in the steps above (an empty"
    " table), set the backlash by the parameter in column Old of each axis, restart and"
    " reference.": (
        "Zurück: die Kompensation dieser Achsen ausschalten wie in den Schritten oben (eine"
        " leere Tabelle), die Lose durch den Parameter in Spalte Alt jeder Achse setzen, neu"
        " starten und referenzieren."
    ),
    "Cross-axis tables: switch off what the steps above switch on, or set each of their values"
    " to 0.": (
        "Tabellen zwischen Achsen: ausschalten, was die Schritte oben einschalten, oder jeden ihrer"
        " Werte auf 0 setzen."
    ),
    "The untouched copies of the old files are in {folder} ({names}).": (
        "Die unveränderten Kopien der alten Dateien sind in {folder} ({names})."
    ),
    "Load the untouched copies in {folder} ({names}) the same way, restart and reference.": (
        "Die unveränderten Kopien in {folder} ({names}) ebenso laden, neu starten und"
        " referenzieren."
    ),
    "To undo: switch off as in the steps above, load {files} from {folder} (the old values"
    " of these axes and their switches; what was set by hand goes back by hand), activate,"
    " restart and reference.": (
        "Rückgängig machen: ausschalten wie in den Schritten oben, {files} aus {folder} laden"
        " (die alten Werte dieser Achsen und ihre Schalter; was von Hand gesetzt wurde, geht"
        " von Hand zurück), wirksam machen, neu starten und referenzieren."
    ),
    "If more than these axes has to go back: switch off the compensation of every axis in"
    " them (what is on is protected), load the untouched copies in {folder} ({names}) the"
    " same way, restart and reference.": (
        "Wenn mehr als diese Achsen zurück muss: die Kompensation jeder Achse darin ausschalten"
        " (was eingeschaltet ist, ist geschützt), die unveränderten Kopien in {folder}"
        " ({names}) ebenso laden, neu starten und referenzieren."
    ),
    "none": "keine",
    "{name} and {gantry} together": "{name} und {gantry} zusammen",
    "axis {axis} has {name} {becomes} {unit} (now {was} {unit})": (
        "hat Achse {axis} {name} {becomes} {unit} (jetzt {was} {unit})"
    ),
    "With {file} alone {effects}.": "Mit {file} allein {effects}.",
    "Axis {name} leads a gantry: do every step for the synchronised axis {gantry} too,"
    " before anything moves.{own} A table on the leading axis alone racks the bridge.": (
        "Achse {name} führt ein Gantry: jeden Schritt auch für die Gleichlaufachse {gantry}"
        " ausführen, bevor sich etwas bewegt.{own} Eine Tabelle nur auf der Führungsachse"
        " verspannt die Brücke."
    ),
    "The job says that {name} is not a gantry master axis. If it is one, stop: a table on"
    " the master axis alone racks the bridge. Name its synchronised axis in the job"
    " (gantry), so that it gets the same table.": (
        "Laut Auftrag ist {name} keine Führungsachse eines Gantry. Ist sie eine, halt: Eine"
        " Tabelle nur auf der Führungsachse verspannt die Brücke. Ihre Gleichlaufachse im"
        " Auftrag nennen (gantry), damit sie dieselbe Tabelle bekommt."
    ),
    " It has values of its own.": " Sie hat eigene Werte.",
    "{output} over {input}: type in": "{output} über {input}: eintippen",
    "{name}: scale from circles": "{name}: Maßstab aus Kreisen",
    "{scale} Measure {name} with a laser when you can.": (
        "{scale} {name} mit einem Laser messen, sobald es möglich ist."
    ),
    "Not corrected: {error}": "Nicht korrigiert: {error}",
    ", which also moves {output} as a whole by {constant} µm": (
        ", was auch {output} als Ganzes um {constant} µm verschiebt"
    ),
    "{why}.": "{why}.",
    "(not known)": "(nicht bekannt)",
    "Incremental encoder: reference the axis after the power cycle; no compensation is"
    " active before that.": (
        "Inkrementeller Geber: die Achse nach dem Einschalten referenzieren; vorher ist keine"
        " Kompensation aktiv."
    ),
    "Absolute encoder: no reference return. Leave its adjustment alone: machine zero would"
    " be lost.": (
        "Absoluter Geber: keine Referenzfahrt. Seine Justierung nicht ändern: Der"
        " Maschinennullpunkt ginge verloren."
    ),
    "Distance-coded scale: move the axis over two marks after the power cycle; no"
    " compensation is active before that.": (
        "Abstandscodierter Maßstab: die Achse nach dem Einschalten über zwei Marken fahren;"
        " vorher ist keine Kompensation aktiv."
    ),
    "your own patched {files}": "Ihre Dateien {files}, wie geändert,",
    "Nothing yet on a machine: not the form of the files, not sign, size, places and order"
    " of the values, not the backlash. The first good verification on this one with what was"
    " read back (compwright verify --loaded) proves what it can, and writes it down in"
    " proven/.": (
        "Noch nichts an einer Maschine: nicht die Form der Dateien, nicht Vorzeichen, Größe,"
        " Plätze und Reihenfolge der Werte, nicht die Lose. Die erste gute Verifizierung an"
        " dieser mit dem, was zurückgelesen wurde (compwright verify --loaded), beweist, was"
        " sie kann, und hält es in proven/ fest."
    ),
    "The files of this card belong together: go through all steps in one go. Move no axis"
    " before all files are loaded and active.": (
        "Die Dateien dieser Karte gehören zusammen: alle Schritte in einem Zug ausführen. Keine"
        " Achse bewegen, bevor alle Dateien geladen und aktiv sind."
    ),
    "axis {axis}, test {test}": "Achse {axis}, Prüfung {test}",
    "as the file was read ({code})": "wie die Datei gelesen wurde ({code})",
    "All files or none": "Alle Dateien oder keine",
    "not given": "nicht angegeben",
    "default of the definition; {evidence}": "Vorgabe der Definition; {evidence}",
    "default of the definition": "Vorgabe der Definition",
    "option {name}": "Option {name}",
    "its tests cover less than half of its travel, which is more than a turn": (
        "ihre Prüfungen decken weniger als die Hälfte ihres Verfahrwegs, der mehr als eine"
        " Umdrehung ist"
    ),
    "axis {name}: its error repeats every": "Achse {name}: ihr Fehler wiederholt sich alle",
    "address of axis {name}": "Adresse der Achse {name}",
    "confirmed: {what}": "bestätigt: {what}",
    "unconfirmed: {what}": "unbestätigt: {what}",
    "inferred: {what}": "geschlossen: {what}",
    "{label}: compensation during the test": "{label}: Kompensation während der Prüfung",
    "the job's answer (active)": "die Antwort des Auftrags (active)",
    "on": "ein",
    "the files end with it switched on (active: no is of the others)": (
        "die Dateien enden mit eingeschalteter (active: no gilt für die anderen)"
    ),
    "off": "aus",
    "axis {name}: kind": "Achse {name}: Art",
    "{plan} above the files": "{plan} über den Dateien",
    "general knowledge": "aus allgemeiner Kenntnis",
    "a table that was given counts as active": "eine gegebene Tabelle gilt als aktiv",
    "absent": "nicht vorhanden (absent)",
    "auto": "selbsttätig (auto)",
    "error": "Fehler (error)",
    "no": "nein (no)",
}
