"""What is noticed about a control's files, in them and between two sets of them."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F011.feed": (
        "bei {feed:g} {unit}/min ({of:choose|option=Option max_feed|rapid=Eilgang 1420}) braucht"
        " die Steuerung mindestens {least:g}: Vorschub / {rule} ({evidence})"
    ),
    "CW-S001": "{file}: Die letzte Zeile hat kein Zeilenende; prüfen, ob die Datei vollständig ist",
    "CW-S002": "{file}: kein {mark} am Ende; prüfen, ob die Datei vollständig ist",
    "CW-S003": (
        "{label}: {quantity} ist mehrfach angegeben; es zählt der"
        " {rule:choose|first=erste|last=letzte|={rule}} Wert: {value} ({where})"
    ),
    "CW-S004.not_zero": (
        "{label}: {values} Werte hinter dem Ende der Tabelle ({first} bis {last}) verwendet die"
        " Steuerung nicht, {not_zero} davon sind nicht null: eine ältere, längere Tabelle, außer"
        " Ende oder Abstand sind falsch"
    ),
    "CW-S004.zero": (
        "{label}: {values} Werte hinter dem Ende der Tabelle sind null und nicht verwendet"
    ),
    "CW-S005": (
        "{label}: {quantity} steht nicht in den Dateien; gezählt als {value}. Hat die Steuerung"
        " einen anderen Wert, war der in den Prüfungen aktiv, und was geschrieben oder gezeigt"
        " wird, ist um den Unterschied falsch: an der Steuerung nachsehen oder die Datei"
        " hinzufügen, die ihn nennt"
    ),
    "CW-S006": "Achse {axis}: Mehrere Messsysteme haben eine Tabelle; gezeigt wird System {system}",
    "CW-S007": "{label}: {switch}; sie korrigiert nichts",
    "CW-S008": "{label}: Keine Datei enthält eine Tabelle; gezählt als keine",
    "CW-S009": (
        "{label}: {what} beachtet die Steuerung nicht: sie {why:choose|table=hat eine"
        " Tabelle|rotary=ist eine Drehachse}"
    ),
    "CW-S010": (
        "Achse {axis} wird als {address} der Steuerung genommen: prüfen oder ihre Adresse angeben"
    ),
    "CW-S011": (
        "{label} ({input} auf {output}) bleibt unberührt: {why}; {active:if|aktiv auf {output} über"
        " {input}, vorher wie nachher|ausgeschaltet}"
    ),
    "CW-S012.assignments": "{file} steht nicht in der aktiven Zuordnungszeile: nicht aktiv",
    "CW-S012.no_axis": "{file} wird von keiner Achse genannt: Die Steuerung lädt sie nicht",
    "CW-S012.no_table": (
        "{files}{more:if| und {more} weitere}: keine Tabelle und von keiner Achse genannt: Die"
        " Steuerung lädt sie nicht als solche"
    ),
    "CW-S012.not_given": (
        "{file}, aktiv für die Bewegung von {axis}, wurde nicht gegeben: Was sie mit anderen Achsen"
        " tut, ist nicht bekannt"
    ),
    "CW-S012.start_up_list": "{file} steht nicht in der Anlaufliste: Die Steuerung lädt sie nicht",
    "CW-S013": (
        "{file}, Zeile {line}: gelesen, obwohl kein Handbuch diese Form zeigt ({lines} Zeilen)"
    ),
    "CW-S014": (
        "die Achsen {addresses:and} teilen sich die Punktnummern {first} bis {last}: Eine Änderung"
        " für die eine änderte die andere, deshalb bekommt eine neue Tabelle eigene Nummern"
    ),
    "CW-S015": (
        "{label}: Vorschub und Eilgang haben verschiedene Losewerte ({feed} und {rapid}; {why}):"
        " Gezeigt ist hier {rapid_shown:if|der Eilgang, 1852|der Vorschub, 1851}; eine neue Tabelle"
        " ändert beide gleich, ihr Unterschied bleibt"
    ),
    "CW-S016": "{label}: Punkt {first} sollte denselben Wert haben wie Punkt {last} ({value:g})",
    "CW-S017": (
        "Achse {axis}: Die Tabelle von {file} beendet ihre Umdrehung mit einem anderen Wert, als"
        " sie begann"
    ),
    "CW-S018": (
        "{label}: Die Referenzposition ist nicht der Maschinennullpunkt (1240); die Punkte werden"
        " von der Position {reference:g} (reference) gezählt, was unbestätigt ist: die Korrektur an"
        " zwei Positionen prüfen"
    ),
    "CW-S019": (
        "{label}: Durchmesserprogrammierung (1006#3): Positionen, Abstand und Korrekturen gelten"
        " als Radius (unbestätigt); ein Faktor 2 ist der übliche Fehler, deshalb nach dem Laden"
        " eine Position prüfen"
    ),
    "CW-S030": "Achse {partner} tut nicht dasselbe wie {leading}, mit der sie ein Gantry bildet",
    "CW-S031.gantry": (
        "die Achsen {axis} und {other} haben dieselbe Tabelle: Sind sie ein Gantry? Dann {other} im"
        " Auftrag nennen (gantry), damit beide die neue bekommen; eine Tabelle auf nur einer"
        " verspannt das Portal"
    ),
    "CW-S031.single": (
        "die Achsen {axis} und {other} haben dieselbe Tabelle; die Dateien der Steuerung sagen,"
        " dass Achse {axis} in keinem Gantry ist"
    ),
    "CW-S032": "{label}: Werte und Raster sind alle null, das heißt keine Tabelle",
    "CW-S033.ends": (
        "{label} ist endlos, aber die Tabelle wiederholt sich nicht: Sie endet an beiden Seiten"
    ),
    "CW-S033.repeats": (
        "{label}: Die Tabelle wiederholt sich alle {period:g}, aber der Auftrag nennt kein modulo;"
        " eine neue Tabelle hat Enden"
    ),
    "CW-S034": "{label} ist in den Dateien ausgeschaltet ({switches}) und korrigiert nichts",
    "CW-S035": (
        "Achse {axis}: Der Auftrag sagt, dass sie sich allein bewegt; {parameter} kann sie mit"
        " einer anderen Achse koppeln. Diese Kopplung in jeder Prüfung ausgeschaltet lassen und die"
        " Tabellen beider Achsen laden, bevor sie wieder benutzt wird"
    ),
    "CW-S036": (
        "Achse {gantry} bekommt {table:choose|same=dieselbe Summe|change=dieselbe Änderung zu ihrer"
        " eigenen Summe} wie Achse {axis}, wie der Auftrag sagt. Die Korrekturen beider"
        " unterscheiden sich nachher um bis zu {after:.2f} {unit}, vorher {before:.2f} {unit}; an"
        " keiner Position um mehr als {moved:.2f} {unit} anders als vorher"
    ),
    "CW-S037": (
        "Achse {axis}: Achse {follows} folgt ihr als Antrieb ohne eigene Position ({parameter}):"
        " Die Tabelle der Achse {axis} dient beiden"
    ),
    "CW-S038": (
        "Die Achsen {axis} und {gantry} laufen um bis zu {moved:.2f} {unit} auseinander (Grenze"
        " {limit:.2f} {unit}); Achse {axis} gewinnt {gain:.2f} {unit}. Ihre Raster passen nicht"
        " zusammen. Beiden Achsen in der Steuerung dasselbe Raster geben oder table: same sagen"
    ),
    "CW-S040": (
        "{label}: {bits} = 1 ({value}): an echten Maschinen verwendet, Bedeutung nicht bestätigt"
        " (vielleicht interpolierende Kompensation: dann die Option output: ramp angeben); es"
        " bleibt, wie es ist"
    ),
    "CW-S041": (
        "{label}: {own} = {first} ist {zero} + 1 bei einer vollen Umdrehung, wo das Handbuch {own}"
        " = {zero} hat: Die Nummern {first} bis {last} werden als ihre Abschnitte gelesen, und"
        " Nummer {reference} bleibt auch der Achse"
    ),
    "CW-S042": (
        "Achse {axis} ist ungewöhnlich und bleibt mit allen ihren Punktnummern unberührt:"
        " {reasons:join|; }"
    ),
    "CW-S043": "{label}: {systems}; die Erfassungseinheit prüfen",
    "CW-S044": (
        "{label}: Die Referenzfahrt geht nach 1006#5 in Richtung {files}, im Auftrag in Richtung"
        " {job}; mit einem Datensatz verschiebt das nur den Nullpunkt um die Lose, deshalb gilt der"
        " Auftrag; zwei Sätze werden abgelehnt, bis beide übereinstimmen"
    ),
    "CW-S045": (
        "{label}: {outside:g} {unit} des Verfahrwegs liegen außerhalb der Grenzen von {low:g} bis"
        " {high:g} ({parameters}): Sind Verfahrweg und Zielpositionen in Maschinenkoordinaten?"
    ),
    "CW-S046": (
        "{file}: Die Punkte liegen nicht gleich weit auseinander ({least:.10g} bis {most:.10g}),"
        " was die Steuerung verlangt; gelesen, wie sie sind, nie so geschrieben"
    ),
    "CW-S047": (
        "{label}: Die weiche Losekompensation teilt 1851 in Stufen ({parameters}): Sie bleibt, wie"
        " sie ist, und formt höchstens die {reach:g} {unit} nach einer Umkehr (unbestätigt); eine"
        " nähere Zielposition, in einer Prüfung oder am Werkstück, sieht einen anderen Wert als"
        " 1851"
    ),
    "CW-S048": "{label}: {function}",
    "CW-S049.none": (
        "{suggested}. Der Auftrag nennt keine Spindelsteigung, deshalb wird diese Periode zuerst in"
        " den Messwerten gesucht. Stimmt sie, der Achse screw_pitch: {lead:g} geben"
    ),
    "CW-S049.other": (
        "{suggested}; der Auftrag nennt stattdessen {periods:g}, und das gilt: an der Spindel"
        " prüfen"
    ),
    "CW-S049.suggested": (
        "{label}: Die Dateien der Steuerung legen eine Periode von {lead:g} {unit} nahe, eine"
        " Umdrehung des Motors ({evidence})"
    ),
    "CW-S050.cec": (
        "{label} ({input} auf {output}) bleibt unberührt: {why}; {active:if|aktiv auf {output} über"
        " {input}, vorher wie nachher|ausgeschaltet}"
    ),
    "CW-S050.list": "{label} bleibt, wie sie ist, und wird nicht gezeigt: {why}",
    "CW-S050.sum": (
        "die CEC-Tabellen {tables} auf {output} bleiben unberührt: Ihre Summe ist {low:g} bis"
        " {high:g}, und MD32720 $MA_CEC_MAX_SUM begrenzt sie auf {limit:g}; sie sind aktiv, vorher"
        " wie nachher"
    ),
    "CW-S051": (
        "die Tabellen zwischen Achsen ({pairs}) bleiben, wie sie sind, und werden nicht gezeigt:"
        " Das Vorzeichen der CEC-Werte ist unbekannt; nach der Prüfung auf der Karte die Option"
        " cec_sign angeben"
    ),
    "CW-S052": (
        "Achse {axis}: Der Auftrag nennt Messsystem {number}, aber die Dateien schalten die"
        " Kompensation für System {other} ein (MD32700): sicherstellen, dass System {number}"
        " benutzt wird"
    ),
    "CW-S053": (
        "Achse {axis}: Zusätzlich zur Tabelle ist aktiv: {functions:join|; }. Es bleibt, wie es"
        " ist, und zählt während der Prüfung und nachher als gleich aktiv"
    ),
    "CW-S054": (
        "die CEC-Tabellen {tables} bleiben unberührt: Alle ihre Werte sind 0, auf einem Raster, das"
        " nicht lesbar ist; sie korrigieren nichts"
    ),
    "CW-S055": (
        "CEC-Tabellen sind als Korrekturen gezeigt. Nach dem Handbuch von Siemens"
        " (Erweiterungsfunktionen 03/2009, Seite 372) bewegt ein positiver Wert die Achse in −,"
        " also umgekehrt: nach der Prüfung auf der Karte die Option cec_sign angeben"
    ),
    "CW-S056": (
        "Achse {axis}: {period:if|die Tabelle wiederholt sich alle {period:g}, aber der Auftrag"
        " nennt kein modulo; eine neue Tabelle hat Enden|sie ist endlos, aber die Tabelle"
        " wiederholt sich nicht: Sie endet an beiden Seiten}"
    ),
    "CW-S057": (
        "{format}: Keine Seite sagt, was die Parameter {parameters} bei dieser Baureihe sind"
        " ({place}; andere Baureihen haben dort Einheiten, Pfade oder weitere Kompensation): Sie"
        " werden nicht gezählt, nicht mit dem Auftrag verglichen und bleiben, wie sie sind. Im"
        " Handbuch der Steuerung nachsehen: Was davon kompensiert, hebt sich nur auf, so lange das"
        " Raster bleibt"
    ),
    "CW-S060": (
        "Zurückgelesen, nicht unabhängig beurteilt: Nur Ihre eigene Definition von {definition}"
        " sagt, was ihre Dateien tun. Ein Vorzeichen oder eine Einheit, die darin falsch ist, ist"
        " in alldem falsch. An der Maschine beweisen, an einer Position und von beiden Seiten,"
        " bevor die ganze Tabelle aktiv ist{expectation:if|. Die von Hand gerechneten Korrekturen"
        " sind die von {expectation}: für {definition} wurden keine gerechnet}"
    ),
    "CW-S061": (
        "{what}: {carried} wird verwendet, wie es im Plan steht; für eine andere Definition den"
        " Auftrag neu rechnen"
    ),
    "CW-S062": "das Steuerungsformat {name} wird als {definition} genommen: {title}",
    "CW-S070": (
        "{file}: Programme darin laden oder schalten Kompensation, wenn jemand sie startet:"
        " {programs}; hier wurden sie nicht ausgeführt, es zählen die Daten des Archivs selbst"
    ),
    "CW-S071": (
        "{file}: Die Dezimalkommas werden als Punkte gelesen; die Steuerung nimmt eine solche Datei"
        " nicht an: Es ist eine Auflistung und vielleicht nicht das, was die Steuerung enthält"
    ),
    "CW-S072": (
        "{file}: Der Inhalt des Archivs ist nicht überprüft: Nichts darin sagt, ob ein Wert nach"
        " dem Export geändert wurde. Vor dem Laden die drei Werte je Achse auf der Karte mit der"
        " Steuerung vergleichen"
    ),
    "CW-S073": (
        "{file}: nach dem Auftrag in der Steuerung nicht ausgeführt (active: no). Keine ihrer"
        " Tabellen und Losewerte zählt als geladen"
    ),
    "CW-S080": (
        "{files}: Was die Steuerung aus {what} macht, ist unbekannt, deshalb werden nur die"
        " Einträge verglichen ({faults})"
    ),
    "CW-S081": "{files}: Die Korrekturen sind die nur eines Lesers; der zweite sagt: {why}",
    "CW-S082": "{files}: keine Daten der Steuerung in {idle}",
    "CW-S083.new": (
        "{new} kompensierende Werte standen in keiner Datei des Plans und wurden nicht angesehen"
    ),
    "CW-S083.not_read": (
        "{missing} kompensierende Werte wurden nicht zurückgelesen und nicht angesehen"
    ),
    "CW-S084": (
        "{files}: In dem gegebenen Ordner ist keine Zeile eine Anweisung von {format}; weggelassen"
    ),
    "CW-S085": (
        "{path} hat run geschrieben und ist nicht zurückgelesen: Nichts sagt hier, was in der"
        " Steuerung ist; aus der Steuerung sichern und das geben"
    ),
    "CW-S086": (
        "Keine Datei sagt, ob {number:plural|Achse {names} eine Linear- oder Drehachse ist|die"
        " Achsen {names} Linear- oder Drehachsen sind}. Die Einheit der Korrekturen ist unbekannt:"
        " Tausendstel mm (µm) oder Grad (3,6″). --option kind=linear oder --option kind=rotary"
        " angeben."
    ),
}
