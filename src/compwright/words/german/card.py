"""Labels and fixed sentences of the commissioning card."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "card.adds": "Steuerung addiert",
    "card.and": "{names:and}",
    "card.axis": "Achse {name}",
    "card.axis_title": "Achse {axis}, Adresse der Steuerung {address}",
    "card.capital": "{text:capital}",
    "card.check_positions": "Prüfpositionen",
    "card.circle": "Kreis {name}",
    "card.confirmed": "bestätigt",
    "card.date": "Datum",
    "card.decided": "{name}: {decided:join|; }.",
    "card.evidence": "Beleg: {evidence}",
    "card.expected": "Erwartete Abweichung",
    "card.fixed": "Feste Positionen, die sich verschieben",
    "card.how_to_check": (
        "Jede Prüfung dieser Karte an diesen Positionen machen. Was die Steuerung addiert, an"
        " ihrer Kompensationsanzeige ablesen, wenn sie eine hat. Nach dem Laden die"
        " Schnellprüfung mit dem Messgerät machen."
    ),
    "card.inferred": "geschlossen",
    "card.limit": (
        "{symbol} {limit} {unit}: {decision:choose|accept=angenommen|reject=abgelehnt|=offen}"
    ),
    "card.limits": "Grenzwerte, wie vorhergesagt",
    "card.lines": "{texts:join|\n}",
    "card.loaded_by": "geladen von",
    "card.look_at": "{text} ({state:choose|inferred=geschlossen|=unbestätigt})",
    "card.measured": "gemessen",
    "card.measured_by": "nach dem Laden gemessen von",
    "card.more_changes": "{more} weitere Änderungen sind in changes.csv.",
    "card.moves_by": "Verschiebung",
    "card.name": "Name",
    "card.no_title": "Inbetriebnahmekarte",
    "card.not_confirmed": "Nicht bestätigt: diese Angaben prüfen, bevor die Achse schnell fährt",
    "card.note": (
        "Zahlen in Tabellen und Schritten haben einen Dezimalpunkt, wie sie an einer Steuerung"
        " getippt werden. Namen von Parametern, Optionen und Dateien sind wie in der Steuerung und"
        " im Auftrag.{foreign:if| Schritte der eigenen Definition haben keine Übersetzung und sind"
        " englisch.} Die Übersetzung hat noch kein Muttersprachler geprüft."
    ),
    "card.parameter": "{name} = {value}",
    "card.points": "Die Steuerung muss mindestens {points} Punkte für diese Achse haben.",
    "card.proven": "Bewiesen",
    "card.quantity": "Größe",
    "card.rapid": (
        "Im Eilgang gemessen: Die Lose hier, was die Steuerung addiert und die Prüfpositionen"
        " gelten im Eilgang. Dort prüfen, nicht im Arbeitsvorschub."
    ),
    "card.read": "abgelesen",
    "card.same_holds": "Dieser Schritt gilt auch für Achse {axes}.",
    "card.sections": "Nummern der Abschnitte",
    "card.signature": (
        "Geladen von: ______________________   Datum: ______________   Nach dem Laden gemessen: [ ]"
    ),
    "card.steps": "Schritte",
    "card.stop": "Halt bei Unterschied über",
    "card.then": "{names:join|, dann }",
    "card.title": "Inbetriebnahmekarte: {axes}",
    "card.typed_column": (
        "{what:capital}. In {where} {total:if|die Werte ersetzen durch|zu den Werten addieren}:"
        " {rows} ({values:choose|correction=Korrekturen|error=Fehler}; alle Zeilen:"
        " {sheet}{total:if||, dazwischen auf geraden Linien}). {more:if|Die Tabelle bekommt mehr"
        " Zeilen, im gleichen Abstand: DATUM ist die Position der ersten Zeile. In einer neuen"
        " Zeile bekommt jede andere Spalte ihren Wert aus der nächsten alten Zeile."
        " |}{selected}{check}"
    ),
    "card.unconfirmed": "unbestätigt",
    "card.values": "Werte, die sich ändern",
    "card.way_back": "Weg zurück",
    "card.with_unit": "{text} ({unit})",
    "card.zeroed": (
        "In dieser Reihenfolge messen, das Messgerät in der ersten Zeile auf null gesetzt."
    ),
    "numbering.label": "Nummern der Abschnitte",
    "numbering.mark": "ist die Referenzposition",
    "numbering.number": "Nummer",
    "numbering.parameter": "Parameter",
    "numbering.position": "Position",
    "numbering.position_unit": "Position, {unit}",
    "numbering.reference": "Referenz",
    "numbering.travel_negative": "Fahrt in -",
}
