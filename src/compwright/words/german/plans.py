"""What is decided on the way from results to tables."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-P001": "Für Achse {axis} wird keine Tabelle geschrieben: {why}.",
    "CW-P001.measured": (
        "die gemessene Prüfung ergibt mit der Tabelle neu ausgewertet {parameter} {with_table},"
        " ohne sie {without}"
    ),
    "CW-P001.new_targets": (
        "an neuen Zielpositionen wird {parameter} {with_table} mit der Tabelle erwartet, {without}"
        " ohne sie"
    ),
    "CW-P001.not_seen": (
        "an neuen Zielpositionen wird {parameter} {with_table} mit einer weiteren Tabelle erwartet,"
        " {without} ohne sie; von Prüfung zu Prüfung ändert es sich um {spread}: Der Gewinn liegt"
        " innerhalb der Unsicherheit"
    ),
    "CW-P001.old_table": (
        "die Prüfungen {off} und {on} widersprechen dem, was die Dateien sagen (zu {percent:.1f} %"
        " sicher): Die Tabelle des Zustands {state} {did:choose|not_active=war nicht"
        " aktiv|inverted=war mit umgekehrtem Vorzeichen aktiv|scaled=war mit dem Faktor"
        " {factor:2sig} aktiv|shifted=war aktiv, um {shift:+d} Punkte verschoben|mirrored=war"
        " aktiv, über den Verfahrweg gespiegelt|wrong_axis=war nicht die aktive: Es war die einer"
        " anderen Achse|one_direction=war nur in einer Richtung aktiv|backlash=war mit anderer Lose"
        " aktiv|partial=war nur über einen Teil des Verfahrwegs aktiv|measurement=passt, aber die"
        " Messwerte nicht zueinander: Eine der Prüfungen wurde falsch gemessen|undecided=tat etwas"
        " anderes ({likely:join|, oder })}{detail:if| ({detail})} in {on}{off_too:if|, oder sie war"
        " auch in {off} aktiv: Beide zeigen dieselbe Achse (war sie für {off} aus?)}{exchanged:if|,"
        " oder die beiden Prüfungen sind vertauscht}. Eine Summe aus alt und neu wäre um so viel"
        " falsch{look_at:if|. Ansehen: {look_at:join|. }}"
    ),
    "CW-P101": (
        "Kreis {circle}: Sein Ort in der Maschine ist nicht angegeben; angenommen wird die Mitte"
        " des Verfahrwegs ({centre}). Seinen Mittelpunkt angeben: Die Wirkung der Tabellen hängt"
        " davon ab."
    ),
    "CW-P101.axis": "{axis} {position:g}",
    "CW-P102": (
        "Kreis {circle}: Ein ganzer Kreis um seinen Mittelpunkt reicht auf {axis} von {low:g} bis"
        " {high:g}, über den Verfahrweg hinaus."
    ),
    "CW-P103": (
        "{input} auf {output}: Stützpunkte in gleichen Schritten verfehlen die gemessenen Punkte um"
        " bis zu {missed:2sig} µm."
    ),
    "CW-P104": (
        "{measured}, {circle} nach {tests}; sie widersprechen sich. Korrigiert wird die direkte"
        " Messung. Ihr Vorzeichen prüfen und die falsche Messung wiederholen."
    ),
    "CW-P105": "{measured}, was {tests} bestätigt ({circle}).",
    "CW-P106.no_circle": (
        "apply.squareness.{plane} wird nicht korrigiert: Der Auftrag hat keinen Kreis dieser Ebene."
        " Einen in beiden Richtungen messen."
    ),
    "CW-P106.uncertain": "apply.squareness.{plane} wird nicht korrigiert: Rechtwinkligkeit {why}.",
    "CW-P106.undetermined": (
        "apply.squareness.{plane} wird nicht korrigiert: Die Rechtwinkligkeit ist nicht bestimmt."
        " {reasons:join|; }."
    ),
    "CW-P107": "{plane}: Rechtwinkligkeit {angle_words}: nichts zu korrigieren.",
    "CW-P108": (
        "{plane}: Rechtwinkligkeit {squareness} nach {tests}; ihre Korrektur ist nicht verlangt"
        " (apply)."
    ),
    "CW-P109": "{plane}: Rechtwinkligkeit {squareness} nach {tests}; {output} soll {input} folgen.",
    "CW-P110": (
        "{plane}: Die Kreise widersprechen sich in der Rechtwinkligkeit (µm/m: {values}). Den Kreis"
        " wiederholen, der abweicht."
    ),
    "CW-P110.circle": "{circle} {squareness:+.1f}",
    "CW-P111": (
        "{pair}: korrigiert über {travel:g} mm von {axis}, {what} hat {length:g} mm: eine"
        " Extrapolation."
    ),
    "CW-P112": (
        "{axis} ist eine Gantry-Achse: Sie um Mikrometer zu bewegen, während eine andere Achse"
        " fährt, kann Ruckgleiten auslösen; ihre Rechtwinkligkeit gehört zuerst in den"
        " Referenzversatz der Gleichlaufachse."
    ),
    "CW-P113.column": (
        "{what} steht in {where} (Werte sind {values:choose|correction=Korrekturen|error=Fehler})."
    ),
    "CW-P113.not_held": (
        "{what} wird nicht korrigiert: Diese Steuerung, wie der Auftrag sie beschreibt, kann das"
        " nicht aufnehmen; {why}."
    ),
    "CW-P113.sheet": (
        "{what} steht in keiner Datei: Die Parameter stehen in {sheet} neben der Karte, alle"
        " unbestätigt."
    ),
    "CW-P113.straightness": "{what} steht in den Dateien als Geradheitskompensation: {values}.",
    "CW-P113.typed": (
        "{what} steht in keiner Datei ({why}): in {where} eintippen, {rows} (Werte sind"
        " {values:choose|correction=Korrekturen|error=Fehler}), wie die Karte und ihr Blatt sagen;"
        " das Vorzeichen ist unbestätigt."
    ),
    "CW-P114": (
        "{axis}: Umkehrspiel {laser} nach dem Laser, {circle} nach {test} (in Bewegung): Sie"
        " stimmen nicht überein; es zählt {counts:choose|circle=der Kreis|laser=der Laser}."
    ),
    "CW-P115": (
        "{axis}: Maßstab {laser} nach dem Laser, {circle} nach {test}: Sie stimmen nicht überein;"
        " der Laser zählt."
    ),
    "CW-P116": (
        "Maßstab von {pair}: {laser} nach dem Laser, {circle} nach {test}: Sie stimmen nicht"
        " überein; der Laser zählt."
    ),
    "CW-P117": (
        "{axis}: Das Umkehrspiel wird aus den Kreisen genommen: {shift} gegen das des Lasers."
    ),
    "CW-P118": "{axis}: Der Maßstab ist der der Positionierprüfung; Kreise prüfen ihn nur.",
    "CW-P119.impossible": "{scale}; nicht korrigiert: {reasons:join|; }.",
    "CW-P119.lag": (
        "der Schleppabstand der Achsen verkleinert {circle} bei seinem Vorschub vielleicht um"
        " {lag:.0f} µm/m (kleiner Vorschub, zwei Vorschübe oder eine Positionierprüfung der anderen"
        " Achse entscheiden es)"
    ),
    "CW-P119.low_feed": "{circle} bei kleinem Vorschub",
    "CW-P119.mismatch": "dem Maßstabsunterschied von {circle} und dem Laser auf {axis}",
    "CW-P119.negligible": "{scale}; nichts zu korrigieren.",
    "CW-P119.not_calibrated": (
        "das Messgerät von {circle} war nicht kalibriert, und die andere Achse hat keine"
        " Positionierprüfung"
    ),
    "CW-P119.not_taken": (
        "{axis}: Der Maßstab wird nicht aus einem Kreis genommen: {reasons:if|{reasons:join|;"
        " }|kein Kreis liegt auf ihr}."
    ),
    "CW-P119.two_feeds": "{slow} und {fast}, auf Vorschub null extrapoliert",
    "CW-P119.undetermined": (
        "{axis}: Der Maßstab wird nicht korrigiert: {why}. Er kommt aus {tests:join|; }. Oder die"
        " Achse mit einem Laser messen, oder den Kreis bei kleinem Vorschub wiederholen."
    ),
    "CW-P120": (
        "{scale}; die Tabelle korrigiert ihn. Die Temperatur von Messgerät und Maßstab bei der"
        " Prüfung ist darin: 1 K sind 11 µm/m Stahl."
    ),
    "CW-P130.no_circle": (
        "{axis}: Kein Kreis liegt auf ihr; ihr Umkehrspiel bleibt das des Lasers, obwohl der"
        " Auftrag das der Kreise verlangt."
    ),
    "CW-P130.no_test": (
        "{axis}: Ihr Umkehrspiel nach den Kreisen wird nicht korrigiert: Sie hat keine"
        " Positionierprüfung und so keine Tabelle dafür."
    ),
    "CW-P130.none": (
        "apply.backlash_from: Von keiner Achse wird das Umkehrspiel aus Kreisen genommen: Kein"
        " Kreis des Auftrags zeigt es."
    ),
    "CW-P130.unknown": (
        "{axis}: Ihr Umkehrspiel wird nicht aus den Kreisen genommen, wie der Auftrag verlangt: Sie"
        " zeigen es nicht, oder die Positionierprüfung hat nur eine Richtung."
    ),
    "CW-P131": (
        "Kreis {circle}: {parameter} wächst nach der Vorhersage mit diesen Tabellen von {was:.1f}"
        " auf {median:.1f} µm ({p05:.1f} bis {p95:.1f}). Positionierung und Kreis widersprechen"
        " sich, oder nur eine Achse der Ebene wird korrigiert. Offen: vor dem Laden klären, warum."
    ),
    "CW-P132": (
        "{what}: Keine Unsicherheit U von {lacking} ist bekannt, und die Entscheidung rechnet mit"
        " ihr: offen; {give}."
    ),
    "CW-P133": (
        "Achse {axis}: Der Grenzwert wird nach der Vorhersage an denselben Zielpositionen"
        " eingehalten, nicht an neuen: 5 % der Prüfungen zeigen dort mehr als {parameters}."
        " Offen.{reasons:if| Der Fehler kann sich wiederholen: {reasons:join|, oder }.|} An"
        " {better} messen.{known:if|| Die Steigung der Spindel angeben, wo sie bekannt ist"
        " (screw_pitch).}"
    ),
    "CW-P133.open": (
        "mit einer Periode, die diese Zielpositionen offenlassen ({probability:.0%}; vor allem"
        " {periods:3sig} {unit})"
    ),
    "CW-P133.parameter": "{parameter} {value} (Grenzwert {limit:g})",
    "CW-P133.period": "alle {period:.5g} {unit} ({probability:.0%})",
    "CW-P134": (
        "Kreis {causes}, das vorhergesagte Band ist deshalb zu schmal, um über seine Grenzwerte zu"
        " entscheiden: offen. Einen vollen Kreis in beiden Richtungen messen, oder nach der Prüfung"
        " nach dem Laden entscheiden."
    ),
    "CW-P135": "Kreise {circles} als eine Maschine: {machine:if|{machine}|sie zeigen nichts}.",
    "CW-P135.error": (
        "{kind:choose|squareness=Rechtwinkligkeit|scale=Maßstab|lost motion=Umkehrspiel} von {of}"
        " {value}"
    ),
    "CW-P135.position_loop": "Lageregelung von {axis} {value}",
    "CW-P136": (
        "{kind:choose|squareness=Rechtwinkligkeit|scale=Maßstab|lost motion=Umkehrspiel|servo"
        " mismatch=Unterschied der Lageregelung}: Die Kreise widersprechen sich: {values}. Die"
        " Maschine änderte sich zwischen ihnen, oder ihre Fehler hängen von Ort, Vorschub oder"
        " Temperatur ab. Den Kreis wiederholen, der abweicht."
    ),
    "CW-P136.circle": "{circle} {axes} {value}",
    "CW-P140": (
        "Achse {axis}: Ein neues Raster wird gewählt, {grid}, anstelle des vorhandenen, {existing}:"
        " {why}"
    ),
    "CW-P141": (
        "Achse {axis}: Das vorhandene Raster {stays:if|bleibt|genügt nicht}, {existing},"
        " vorhergesagt {parameter} {same} ({new} an neuen Zielpositionen); ein neues, {grid}, gäbe"
        " {parameter} {better} ({better_new}): spacing: auto in der Tabelle der Achse nimmt es; was"
        " vom alten abhängt, zieht mit um oder wird genannt, wo es das nicht kann"
    ),
    "CW-P142.line": (
        "Die Steigung von {slope} kommt in eine getrennte Gerade. An den Tabellenpunkten bleiben"
        " ohne diese Gerade {left} (Effektivwert), mit ihr {with_line}"
    ),
    "CW-P142.table": (
        "Die Steigung von {slope} bleibt in der Tabelle: ohne getrennte Gerade bleiben an den"
        " Punkten {left} (Effektivwert), mit ihr {with_line}"
    ),
    "CW-P143.none": "Keine eigene Tabelle für {period}",
    "CW-P143.period": (
        "die Periode von {period:g} {unit}, zu kurz für Abschnitte von {sections:g}: ohne eigene"
        " Tabelle bleiben {left} (Effektivwert), mit ihr {with_it}"
    ),
    "CW-P143.second": "Eine zweite Tabelle für {period}",
    "CW-P144": (
        "Achse {axis}: Die Punkte werden von Hand eingetippt, deshalb werden wenige genommen:"
        " {few}, {mine}. Die andere Wahl ist {many}, {other}: start: {start:.10g}, end: {end:.10g},"
        " spacing: {spacing:.10g} in der Tabelle der Achse nimmt sie"
    ),
    "CW-P150": (
        "Achse {axis}: Eine Tabelle hilft hier nicht. {parameter} ist {now} an neuen"
        " Zielpositionen{with_table:if| ({with_table} mit ihr)}; die größte Ursache ist {cause}"
        " ({value:.2f} {unit}, {share:.0%}): {advice}"
    ),
    "CW-P151.cause": (
        "Achse {axis}: Von {parameter} {now} an neuen Zielpositionen nimmt die Tabelle {taken:.0%}"
        " weg; das meiste vom Rest ist {cause} ({value:.2f} von {left}): {advice}"
    ),
    "CW-P151.scatter": (
        "Achse {axis}: Von {parameter} {now} an neuen Zielpositionen nimmt die Tabelle {taken:.0%}"
        " weg; {scatter:.0%} ist Streuung, die keine Tabelle wegnimmt"
    ),
    "CW-P152": (
        "Achse {axis}: {tables:choose|left=genommen wird die Tabelle der kleinsten erwarteten"
        " Quadrate, nicht eine für das kleinste {goal}|same=die Tabelle der kleinsten erwarteten"
        " Quadrate ist auch die für das kleinste {goal}|taken=gemacht für das kleinste"
        " {goal}|no_gain=eine Tabelle für das kleinste {goal} zeigt in Prüfungen, die sie nicht"
        " kennt, nicht weniger davon, deshalb wird die Tabelle der kleinsten erwarteten Quadrate"
        " genommen}; erwartet an neuen Zielpositionen{tables:choose|left=|same=|taken=, in Klammern"
        " mit der Tabelle der kleinsten erwarteten Quadrate|no_gain=, in Klammern mit der für"
        " {goal}}: {parameters} {unit}"
    ),
    "CW-P152.parameter": "{parameter} {value:.2f}{other:if| ({other:.2f})}",
    "CW-P153": (
        "Achse {axis}: Die zweite Tabelle kann die Drift dieser Prüfung enthalten. Die Umkehrspanne"
        " ändert sich um {risen} über den Verfahrweg; die gefundene Drift, {drifted} vom ersten zum"
        " letzten Lauf, zeigte davon {shown} innerhalb jedes Laufs, hin und zurück, bei gleichem"
        " Spiel. Die Achse warmfahren und neu messen, bevor zwei Tabellen geladen werden, oder eine"
        " nehmen (mode: single)"
    ),
    "CW-P154": (
        "Achse {axis}: Der Losewert kann die Drift dieser Prüfung enthalten. Die mittlere"
        " Umkehrspanne ist {measured}; die gefundene Drift, {drifted} vom ersten zum letzten Lauf,"
        " verschiebt sie um {shown}, wenn sie in jedem Lauf weitergeht, hin und zurück. Die Achse"
        " warmfahren und neu messen, bevor der Losewert geladen wird"
    ),
    "CW-P155": (
        "Achse {axis}: Hier aufhören: Übrig ist {cause} ({value:.2f} {unit} von {parameter}"
        " {left:.2f} {unit} an neuen Zielpositionen). Eine weitere Tabelle änderte weniger, als"
        " sich eine Prüfung von der nächsten unterscheidet."
    ),
    "CW-P156": (
        "Achse {axis}: Die Steuerung führt eine Stufe der Korrektur über {least:.2f} und bis"
        " {most:.2f} {unit} nie aus, und die Umkehrspanne der Tabelle ist"
        " {reversal:.2f}{reversal_to:if| bis {reversal_to:.2f}} {unit}. Nach einer Umkehr bleibt"
        " die alte Korrektur, bis sich die Tabelle selbst genug ändert; die Vorhersage rechnet"
        " damit. Die Steuerung führt diese Stufen mit einer Beschleunigungsgrenze der Achse unter"
        " dem {low:3sig}-Fachen der jetzigen aus oder ab dem {high:3sig}-Fachen: ändern und neu"
        " rechnen"
    ),
    "CW-P160": (
        "Die Messwerte der Prüfung {test} sehen nicht aus, wie Datei und Zustand sagen: Sie sind"
        " {ways:join|, oder }. Eine Tabelle daraus wäre falsch. {checks:join| }"
    ),
    "CW-P160.check": (
        "{way:choose|off=War die Kompensation eingeschaltet und die Achse referenziert, als"
        " gemessen wurde? Wenn nicht, diesen Zustand unter measured_in nennen.|sign=Einen Messwert"
        " mit dem Messgerät vergleichen: Zu weit in + ist eine positive Abweichung.|directions=In"
        " der Datei des Messgeräts nachsehen, in welcher Richtung die Achse im ersten Lauf"
        " fuhr.|order=Die Messwerte der ersten und der letzten Zielposition mit der Datei des"
        " Messgeräts vergleichen.|against=Die Achse in + bewegen: Zählt das Messgerät abwärts,"
        " braucht die Prüfung position_map: {{sense: -1, offset: ..}}.}"
    ),
    "CW-P160.way": (
        "{odds:odds}-mal wahrscheinlicher, {way:choose|off=wenn die Tabelle der Steuerung dabei"
        " nicht aktiv war|sign=wenn das Vorzeichen der Abweichungen gedreht ist (Ziel minus"
        " gemessen)|directions=wenn + und − vertauscht sind|order=wenn die Messwerte in umgekehrter"
        " Reihenfolge der Zielpositionen stehen|against=wenn das Messgerät gegen die Maschine"
        " zählt}"
    ),
    "CW-P161": (
        "Die Tabelle im Zustand {measured_in} ist das Spiegelbild der Prüfung {test} ({size:.1f}"
        " {unit}): Sie wurde aus dieser Prüfung gemacht und war dabei nicht aktiv. Eine weitere"
        " Tabelle korrigierte denselben Fehler zweimal. Mit aktiver Tabelle neu messen, oder unter"
        " measured_in den Zustand nennen, in dem gemessen wurde"
    ),
    "CW-P162.after": (
        "die Datei der Prüfung nach dem Laden nennt die Kompensation {both:if|ein und aus|aus}, der"
        " Plan lädt aber Tabellen für {names:and}. An der Steuerung prüfen, dass sie aktiv sind,"
        " neu messen, oder den Schlüssel compensation der Datei berichtigen."
    ),
    "CW-P162.both": (
        "die Dateien nennen die Kompensation ein und aus. Die neue Summe ist falsch, wenn der"
        " Auftrag falsch ist. An der Steuerung prüfen, was aktiv war, dann den Schlüssel"
        " compensation der Datei oder measured_in und states des Auftrags berichtigen."
    ),
    "CW-P162.state": (
        "die Datei nennt die Kompensation {on:if|ein|aus}, aber der Zustand {state} des Auftrags"
        " {active:if|enthält eine aktive Tabelle oder Lose|enthält nichts Aktives} für {names:and}."
        " Die neue Summe ist falsch, wenn der Auftrag falsch ist. An der Steuerung prüfen, was"
        " aktiv war, dann den Schlüssel compensation der Datei oder measured_in und states des"
        " Auftrags berichtigen."
    ),
    "CW-P163": "Achse {axis}, Prüfung {test}: Ihre Dateien unterscheiden sich in {keys:join|; }",
    "CW-P164": (
        "Achse {axis}: Der Fehler kann sich mit einer Periode wiederholen, die diese"
        " Zielpositionen nicht zeigen ({probability:.0%}; vor allem {periods:3sig} {unit}). In"
        " derselben Prüfung auch an {targets:.7g} {unit} messen: Alle zusammen zeigen einen solchen"
        " Fehler ab einer Amplitude von {amplitude}."
    ),
    "CW-P165": (
        "Achse {axis}: Die Prüfung driftet um {drift}, und die Vorhersage nimmt dieselbe Drift in"
        " der nächsten an: {parameter} {low:.2f} bis {high:.2f} {unit} an neuen Zielpositionen. Hat"
        " jede Prüfung eine eigene Drift dieser Größe, ist {parameter} {least:.2f} bis {most:.2f}"
        " {unit}. Eine zweite Prüfung auf dieselbe Art entscheidet: ihre Datei bei der Achse unter"
        " before angeben"
    ),
    "grid.even": "{points} Punkte von {start:.10g} bis {end:.10g} {unit}, alle {step:.6g} {unit}",
    "grid.few": "{points} Punkte",
    "grid.predicted": (
        "vorhergesagt {name} {value:.2f} {unit} ({elsewhere:.2f} an neuen Zielpositionen)"
    ),
    "grid.uneven": (
        "{points} Punkte von {start:.10g} bis {end:.10g} {unit}, {least:.6g} bis {most:.6g} {unit}"
        " auseinander"
    ),
    "run.no_state": (
        "keine Tabelle geschrieben: Der Auftrag sagt nicht, was in der Steuerung aktiv ist;"
        " states: {{as_found: none}} oder states: {{as_found: [Dateien der Steuerung]}} angeben"
    ),
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
}
