"""Sentences and parts of sentences that several findings use."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "as_written": "{text}",
    "backlash_compensation_larger": (
        "{finding} Die Dateien der Steuerung erklären das: Ihre Losekompensation ist größer als"
        " das Umkehrspiel der Achse."
    ),
    "better_targets": "Zielpositionen, die diesen Fehler zeigen würden: {targets:g} {unit}",
    "between.axes": "{output} über {input}",
    "between.deviation": "die gemessene Abweichung von {output} über {input} ({slope})",
    "between.fault": (
        "{where:if|{where}: |}{message}{expected:if|; erwartet: {expected}|}"
        "{found:if|, gefunden: {found}|}{hint:if|. Weiter: {hint}|}"
    ),
    "between.faults": "{faults:join|; }",
    "between.racked": (
        "{output} ist eine Gantry-Achse, und eine Tabelle auf {output} ohne {partner} verspannt die"
        " Maschine. Weiter: {squareness:if|die Rechtwinkligkeit über den Referenzversatz des Gantry"
        " korrigieren{instead:if| oder stattdessen Achse {input} bewegen (`{instead}`)|}|die"
        " Führung von {input} ausrichten lassen und diesen Eintrag aus dem Auftrag entfernen: keine"
        " andere Tabelle korrigiert eine Geradheit}"
    ),
    "between.squareness": "Rechtwinkligkeit von {output} zu {input} ({slope:+.1f} µm/m)",
    "circle.mean": "Mittel von {axes:and}",
    "circle.part": "{start:.5g}° bis {end:.5g}°",
    "compared_not_removed": "{parameters:join|; }. Das Ergebnis enthält alle Messwerte.",
    "direct_squareness": (
        "{input} und {output}: Rechtwinkligkeit {squareness:+.1f} µm/m nach der"
        " {measurements:plural|direkten Messung|Summe der direkten Messungen beider Achsen}"
    ),
    "doubts.acknowledged": "Im Auftrag bestätigt: {reason}. {message}",
    "doubts.compare": (
        "Der Inhalt der Steuerung kann von den verglichenen Dateien abweichen. Ihre Dateien noch"
        " einmal vollständig auslesen und compwright compare wiederholen"
    ),
    "doubts.first": "Diese Befunde zuerst prüfen: Das Ergebnis hängt davon ab",
    "doubts.step": (
        "Es wird nichts entschieden, bis diese Befunde geklärt sind. Die Prüfung oder den Auftrag"
        " berichtigen und neu rechnen. Ist die Messung richtig, wie sie ist, im Auftrag angeben,"
        " warum ein Befund unbedenklich ist: `acknowledged: {{{codes:join|: Grund, }: Grund}}`"
    ),
    "in_direction": "{value} in {direction}",
    "increments": "{symmetric:if|±{largest}|{least} bis {largest}}",
    "listed": "{items:join|; }{more:if|; und {more} weitere}",
    "listed_places": "{items}{more:if| und {more} weitere}",
    "odds.1_to": "Chancen 1 zu {odds:2sig}",
    "odds.above_1000": "Chancen über 1000 zu 1",
    "odds.over_1000": "Chancen über 1000 zu 1",
    "odds.to_1": "Chancen {odds:2sig} zu 1",
    "of_axis": "Achse {axis}: {finding}",
    "of_axis_small": "Achse {axis}: {finding}",
    "of_circle": "Kreis {circle}: {finding}",
    "of_test": "Achse {axis}, Prüfung {test}: {finding}",
    "paragraph": "{sentences:join| }",
    "parameter": "{parameter} {value}",
    "range": "{low} bis {high}",
    "read_back": (
        "Tabellen von {definition} werden aus ihren Dateien zurückgelesen, aber nicht unabhängig"
        " geprüft: Nur Ihre eigene Definition sagt, was diese Dateien tun"
    ),
    "reading_off": "{traverse} bei {target} (Abweichung {off})",
    "scale_by": "{axis}: Maßstabsabweichung {scale} nach {tests:join|; }",
    "table_advice": (
        "{cause:choose|noise=die Achse wiederholt nicht, was keine Tabelle korrigiert: zuerst"
        " prüfen, wie das Messgerät aufgebaut ist (Schwingung, Luft, Befestigung), dann die"
        " Mechanik (Spiel, Führungen, Lager, Kupplung, Maßstab)|single outliers=einige Messwerte"
        " sind Ausreißer, was keine Tabelle korrigiert: suchen, was die Messung stört"
        " (unterbrochener Strahl, Wartezeit, Schmutz), und neu messen|shifts between"
        " traverses=ganze Läufe sind verschoben, was keine Tabelle korrigiert: prüfen, ob"
        " Messgerät, Spindel und Klemmung fest sind, und Spiel suchen, das von Lauf zu Lauf anders"
        " ist|drift=die Achse ändert sich während der Prüfung, was keine Tabelle korrigiert: wie"
        " bei der Arbeit warmfahren, bis sie stabil ist, und neu messen|one table for both"
        " directions=die Umkehrspanne ändert sich über den Verfahrweg, und eine Tabelle mit einem"
        " Umkehrwert kann das nicht aufnehmen: Mechanik prüfen (Mutter, Spindel, Führungen) oder"
        " eine Steuerung mit einer Tabelle je Richtung verwenden|spacing too wide for the"
        " period=die Punkte liegen für eine so kurze Periode zu weit auseinander; CW-F002 nennt den"
        " nötigen Abstand. Kann die Steuerung ihn nicht aufnehmen, Mechanik prüfen (Spindel, Lager"
        " und Kupplung, Getriebe, Geber)|error that the test leaves open=die Prüfung bestimmt den"
        " Fehler nicht gut genug: mehr Zielpositionen oder mehr Läufe messen}"
    ),
    "traverse": "Lauf {run} in {direction}",
    "undetermined.bar": (
        "die Länge des Kreisformmessgeräts wurde nicht kalibriert: eine kalibrierte Länge"
        " angeben, oder die Achse mit einem Laser messen"
    ),
    "undetermined.both_directions": (
        "der Wert vergleicht beide Richtungen: einen vollen Kreis in beiden Richtungen messen"
    ),
    "undetermined.causes": (
        "{circle}: Die Ursachen sind aus {samples} Messpunkten über {arc:g}° in"
        " {directions:plural|einer Richtung|beiden Richtungen} nicht bestimmbar"
    ),
    "undetermined.few_at_reversal": (
        "der Bogen hat zu wenige Messpunkte, wo die Achse {axis} umkehrt"
    ),
    "undetermined.few_in_time": (
        "der Lauf dauert {time:3sig} s und hat zu wenige Messpunkte, um eine Schwingung zu zeigen"
    ),
    "undetermined.few_near_reversals": (
        "zu wenige Messpunkte nahe der Umkehr der Achse {axis}: mit kleinerem Vorschub messen"
    ),
    "undetermined.full_circle": "{reasons:join|; }: einen vollen Kreis in beiden Richtungen messen",
    "undetermined.lobes": "Vielecke gehören zu einem geschlossenen Kreis",
    "undetermined.no_end": "dieser Umkehrpunkt von {axis} liegt nicht im Bogen",
    "undetermined.no_reversal": "{axis} kehrt im Bogen nicht um",
    "undetermined.of_circle": "{circle}: {reason}",
    "undetermined.one_direction": (
        "eine Richtung allein trennt diese Ursache nicht von Schleppabstand und Umkehrspiel"
    ),
    "undetermined.one_reversal": "der Bogen hat nur einen Umkehrpunkt der Achse",
    "undetermined.pitch": (
        "die Messpunkte liegen zu weit auseinander, um eine Periode zu zeigen: schneller"
        " abtasten oder den Vorschub senken"
    ),
    "undetermined.prior": (
        "{value:+3sig} ± {error:2sig} {unit} ist zu unsicher: Auch ohne Prüfung sind an Maschinen"
        " Werte innerhalb ±{width:g} (Standardabweichung) zu erwarten, und die Messpunkte engen"
        " diesen Bereich kaum ein"
    ),
    "undetermined.spike": (
        "die Messpunkte nach der Umkehr sind zu wenige, um eine Spitze von Umkehrspiel zu"
        " unterscheiden: schneller abtasten oder den Vorschub senken"
    ),
    "undetermined.square": "ein Bogen zeigt nicht alle Fehler, die zur Positionstoleranz gehören",
    "undetermined.value": (
        "{value:+.1f} ± {error:.1f} µm/m ist nicht genau genug bekannt: Die Unsicherheit (k = 2)"
        " muss unter der Hälfte des Wertes und unter {most:g} µm/m liegen{squareness:if|. Volle"
        " Kreise in beiden Richtungen messen und alle angeben. Die Rechtwinkligkeit krummer"
        " Führungen braucht einen Winkel|}"
    ),
    "value_with_error": (
        "{decimals:choose|1={value:+.1f} ± {error:.1f}|2={value:+.2f} ± {error:.2f}"
        "|3={value:+.3f} ± {error:.3f}} {unit}"
    ),
    "with_and_without": "{parameter} {value} mit, {without} ohne",
}
