"""Sentences about the corrections that a run plans or refuses, with the reasons."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-P001": "Für Achse {axis} wird keine Tabelle geschrieben: {why}.",
    "CW-P001.measured": (
        "aus den Messwerten der ersten Prüfung berechnet, ist {parameter} mit der Tabelle"
        " {with_table} und ohne sie {without}"
    ),
    "CW-P001.new_targets": (
        "in einer Prüfung an neuen Zielpositionen wird {parameter} {with_table} mit"
        " der Tabelle erwartet, {without} ohne sie"
    ),
    "CW-P001.not_seen": (
        "in einer Prüfung an neuen Zielpositionen wird {parameter} {with_table} mit"
        " einer weiteren Tabelle erwartet, {without} ohne sie. Von Prüfung zu Prüfung ändert sich"
        " {parameter} um {spread}, der Gewinn liegt also innerhalb der Unsicherheit"
    ),
    "CW-P001.old_table": (
        "die Prüfungen {off} und {on} widersprechen den Dateien der Steuerung (zu {percent:.1f} %"
        " sicher). In {on} {did:choose|not_active=war die vorhandene Tabelle (states.{state} im"
        " Auftrag) nicht aktiv|inverted=war die vorhandene Tabelle (states.{state} im Auftrag) mit"
        " umgekehrtem Vorzeichen aktiv|scaled=war die vorhandene Tabelle (states.{state} im"
        " Auftrag) mit dem Faktor {factor:2sig} aktiv|shifted=war die vorhandene Tabelle"
        " (states.{state} im Auftrag) aktiv, um {shift:+d} Punkte verschoben|mirrored=war die"
        " vorhandene Tabelle (states.{state} im Auftrag) aktiv, über den Verfahrweg gespiegelt|"
        "wrong_axis=war die vorhandene Tabelle (states.{state} im Auftrag) nicht aktiv, sondern die"
        " einer anderen Achse|one_direction=war die vorhandene Tabelle (states.{state} im Auftrag)"
        " nur in einer Richtung aktiv|backlash=war die vorhandene Tabelle (states.{state} im"
        " Auftrag) mit anderer Lose aktiv|partial=war die vorhandene Tabelle (states.{state} im"
        " Auftrag) nur über einen Teil des Verfahrwegs aktiv|measurement=passt die vorhandene"
        " Tabelle (states.{state} im Auftrag) nicht zu den Messwerten: Eine der Prüfungen wurde"
        " falsch gemessen|undecided=verhielt sich die vorhandene Tabelle (states.{state} im"
        " Auftrag) anders ({likely:join|, oder })}{detail:if| ({detail})}.{off_too:if| Oder sie war"
        " auch in {off} aktiv, denn beide Prüfungen zeigen denselben Fehler. Prüfen, ob sie für"
        " {off} ausgeschaltet war.}{exchanged:if| Oder die beiden Prüfungen sind vertauscht.} Eine"
        " Tabelle aus diesen Prüfungen wäre aus demselben Grund falsch{look_at:if|. Ansehen:"
        " {look_at:join|. }}"
    ),
    "CW-P101": (
        "Kreis {circle}: Der Auftrag gibt seinen Mittelpunkt in der Maschine nicht an, deshalb"
        " wird die Mitte des Verfahrwegs angenommen ({centre}). Den Mittelpunkt angeben, denn die"
        " Wirkung der Tabellen hängt davon ab."
    ),
    "CW-P101.axis": "{axis} {position:g}",
    "CW-P102": (
        "Kreis {circle}: Um seinen Mittelpunkt reicht er auf Achse {axis} von {low:.6g} bis"
        " {high:.6g}, über den Verfahrweg hinaus. Mittelpunkt, Radius und Verfahrweg prüfen."
    ),
    "CW-P102.rotary": (
        "Kreis {circle}: Achse {axis} ist im Auftrag eine Rundachse, ein Kreisformtest bewegt aber"
        " zwei Linearachsen. `kind` der Achse {axis} und die Achsen des Kreises prüfen."
    ),
    "CW-P103": (
        "Die Tabelle, die {output} über {input} korrigiert, hat Punkte in gleichem Abstand. An den"
        " gemessenen Positionen weicht sie deshalb um bis zu {missed} von der gewünschten"
        " Korrektur ab."
    ),
    "CW-P104": (
        "{measured}, aber {circle} nach {tests}. Die beiden widersprechen sich. Die"
        " {measurements:plural|Tabelle wird aus der direkten Messung berechnet. Ihr"
        " Vorzeichen|Tabellen werden aus den direkten Messungen berechnet. Ihre Vorzeichen} prüfen"
        " und die falsche Messung wiederholen."
    ),
    "CW-P105": "{measured}. {tests} bestätigt es ({circle}).",
    "CW-P106.contradictory": (
        "Die Rechtwinkligkeit der Ebene {plane} wird nicht korrigiert, denn ihre Kreise"
        " widersprechen sich (CW-P110). Den Kreis wiederholen, der abweicht, oder CW-P110 im"
        " Auftrag bestätigen."
    ),
    "CW-P106.no_circle": (
        "Die Rechtwinkligkeit der Ebene {plane} wird nicht korrigiert: Der Auftrag hat keinen"
        " Kreis dieser Ebene. Einen in beiden Richtungen messen."
    ),
    "CW-P106.uncertain": "Die Rechtwinkligkeit der Ebene {plane} wird nicht korrigiert: {why}.",
    "CW-P106.undetermined": (
        "Die Rechtwinkligkeit der Ebene {plane} wird nicht korrigiert, denn die Kreise bestimmen"
        " sie nicht. {reasons:join|; }."
    ),
    "CW-P107": (
        "Ebene {plane}: Die Rechtwinkligkeit ist {angle_words}. Es gibt nichts zu korrigieren."
    ),
    "CW-P108": (
        "Ebene {plane}: Die Rechtwinkligkeit ist {squareness} nach {tests}. Sie wird nicht"
        " korrigiert, denn der Auftrag verlangt es nicht: `apply: {{squareness: {{{plane}:"
        " ACHSE}}}}` mit der zu korrigierenden Achse als ACHSE angeben."
    ),
    "CW-P109": (
        "{plane}: Die Rechtwinkligkeit{existing:if| mit der vorhandenen Tabelle der Steuerung|}"
        " ist {squareness} nach {tests}{converted:if|, gemessen in einem anderen Zustand|}. Eine"
        " Korrektur bewegt Achse {output} abhängig von Achse {input}."
    ),
    "CW-P110": (
        "Ebene {plane}: Die Kreise widersprechen sich in der Rechtwinkligkeit (µm/m: {values})."
        " Den Kreis wiederholen, der abweicht."
    ),
    "CW-P110.circle": "{circle} {squareness:+.1f}",
    "CW-P111": (
        "{pair}: Die Korrektur reicht über {travel:g} mm der Achse {axis}, die Messung"
        " ({diameter:if|Durchmesser|Messbereich}) nur über {length:g} mm. Außerhalb davon ist sie"
        " extrapoliert: dort prüfen."
    ),
    "CW-P112": (
        "{axis} ist eine Gantry-Achse. Sie um Mikrometer zu bewegen, während eine andere Achse"
        " fährt, kann Ruckgleiten auslösen. Ihre Rechtwinkligkeit zuerst über den Referenzversatz"
        " der Gleichlaufachse korrigieren."
    ),
    "CW-P113.column": (
        "{what} wird in {where} korrigiert (die Werte dort sind"
        " {values:choose|correction=Korrekturen|error=Fehler})."
    ),
    "CW-P113.not_held": "{what} {several:if|werden|wird} nicht korrigiert: {why}.",
    "CW-P113.own_table": (
        "{what} wird in Tabelle {table} der Steuerung korrigiert, die jetzt aktiv ist: Ihre Werte"
        " enthalten dann die alte und die neue Korrektur. Damit sie bleibt, wie sie ist, nur freie"
        " Tabellen erlauben: `{option}: [{free}]`."
    ),
    "CW-P113.sheet": (
        "{what} wird durch Parameter korrigiert, die dieser Lauf nicht in die Dateien der Steuerung"
        " schreibt. Aus dem Eingabeblatt {sheet} im Ordner der Inbetriebnahmekarte eintippen. Alle"
        " sind unbestätigt. Die Vorhersage rechnet mit den eingetippten Werten."
    ),
    "CW-P113.straightness": (
        "{what} wird in den Dateien durch Geradheitskompensation korrigiert: {values}."
    ),
    "CW-P113.switches": (
        "{what} wird nicht korrigiert. Der Auftrag sagt (`active`), dass die Tabelle zwischen"
        " {input} und {output} bei der Messung {active:if|aktiv|nicht aktiv} war. Die Dateien"
        " der Steuerung sagen das nicht. Weiter: die Dateien mit allen Schaltern wie bei der"
        " Messung angeben, ohne die Tabellen, die aus waren, und `active` weglassen."
    ),
    "CW-P113.typed": (
        "Die Werte, die {what} korrigieren, sind in keiner Datei für die Steuerung ({why})."
        " In {where} {total:if|die Werte ersetzen durch|zu den Werten addieren}: {rows}. Die"
        " Inbetriebnahmekarte und das Eingabeblatt in ihrem Ordner beschreiben es. Die Werte sind"
        " {values:choose|correction=Korrekturen|error=Fehler}; ihr Vorzeichen ist unbestätigt: vor"
        " der Fertigung durch eine Messung prüfen. Die Vorhersage rechnet mit den eingetippten"
        " Werten."
    ),
    "CW-P114": (
        "{axis}: Laser und Kreis stimmen beim Umkehrspiel nicht überein. Es ist {laser} nach dem"
        " Laser und {circle} nach {test}, in Bewegung gemessen. Verwendet wird der Wert"
        " {counts:choose|circle=des Kreises|laser=des Lasers}."
    ),
    "CW-P115": (
        "{axis}: Laser und Kreis stimmen beim Maßstab von {low:.6g} bis {high:.6g} mm, wo der Kreis"
        " liegt, nicht überein. Er ist {laser} nach dem Laser und {circle} nach {test}. Verwendet"
        " wird der Wert des Lasers."
    ),
    "CW-P116": (
        "Maßstab von {pair}: Laser und Kreis stimmen nicht überein. Er ist {laser} nach dem Laser"
        " und {circle} nach {test}. Verwendet wird der Wert des Lasers."
    ),
    "CW-P117": "{axis}: Das Umkehrspiel kommt aus den Kreisen, {shift} neben dem Laser.",
    "CW-P118": (
        "{axis}: Der Maßstab kommt aus der Positionierprüfung dieser Achse. Die Kreise prüfen ihn"
        " nur."
    ),
    "CW-P119.contradictory": (
        "{axis}: Der Maßstab wird nicht korrigiert, denn die Kreise widersprechen sich (CW-P136)."
        " Den Kreis wiederholen, der abweicht, oder CW-P136 im Auftrag bestätigen."
    ),
    "CW-P119.impossible": "{scale}. Er wird nicht korrigiert: {reasons:join|; }.",
    "CW-P119.lag": (
        "der Schleppabstand kann den Kreis {circle} um {lag:.0f} µm/m verkleinern (einen Kreis mit"
        " höchstens {feed:.0f} mm/min oder die andere Achse mit dem Laser messen)"
    ),
    "CW-P119.low_feed": "{circle} bei kleinem Vorschub",
    "CW-P119.mismatch": "dem Maßstabsunterschied von {circle} und dem Laser auf {axis}",
    "CW-P119.negligible": "{scale}. Es gibt nichts zu korrigieren.",
    "CW-P119.not_calibrated": (
        "das Messgerät von Kreis {circle} war nicht kalibriert, und die andere Achse dieses Kreises"
        " hat keine Positionierprüfung"
    ),
    "CW-P119.not_taken": (
        "{axis}: Kein Kreis ergibt den Maßstab dieser Achse: {reasons:if|{reasons:join|; }|keiner"
        " wurde mit ihr gemessen}."
    ),
    "CW-P119.together": "den Kreisen {circles:join|, } zusammen",
    "CW-P119.undetermined": (
        "{axis}: Der Maßstab aus {tests:join|; } wird nicht korrigiert: {why}. Die Achse mit einem"
        " Laser messen oder einen Kreis bei kleinem Vorschub."
    ),
    "CW-P120": (
        "{scale}. Die Tabelle korrigiert ihn. Er enthält die Wirkung der Temperaturen von"
        " Messgerät und Maßstab bei der Prüfung: 1 K ändert Stahl um 11 µm/m."
    ),
    "CW-P130.no_circle": (
        "{axis}: Der Auftrag verlangt das Umkehrspiel aus Kreisen, aber mit dieser Achse wurde"
        " kein Kreis gemessen. Verwendet wird der Wert des Lasers."
    ),
    "CW-P130.no_test": (
        "{axis}: Das Umkehrspiel, das die Kreise zeigen, wird nicht korrigiert. Die Achse hat keine"
        " Positionierprüfung, deshalb entsteht für sie keine Tabelle."
    ),
    "CW-P130.none": (
        "apply.backlash_from hat keine Wirkung: Kein Kreis des Auftrags zeigt das Umkehrspiel"
        " einer Achse."
    ),
    "CW-P130.unknown": (
        "{axis}: Der Auftrag verlangt das Umkehrspiel aus Kreisen, es wird aber nicht verwendet."
        " Entweder zeigen die Kreise es nicht, oder die Positionierprüfung hat nur eine Richtung."
    ),
    "CW-P131": (
        "Kreis {circle}: Mit diesen Tabellen wächst {parameter} nach der Vorhersage von {was:.1f}"
        " auf {median:.1f} µm ({p05:.1f} bis {p95:.1f}). Entweder widersprechen sich"
        " Positionierprüfung und Kreis, oder nur eine Achse der Ebene wird korrigiert. Die"
        " Grenzwerte des Kreises bleiben offen: vor dem Laden klären, warum."
    ),
    "CW-P132": (
        "{test:choose|circular=Kreis|=Achse} {name}: Die Entscheidung mit Sicherheitsabstand"
        " braucht die Unsicherheit U von {lacking}, die unbekannt ist. Sie bleibt offen."
        " {test:choose|vdi3441=Eine andere Norm (VDI/DGQ 3441 gibt keine an)|linear=Im Auftrag"
        " `uncertainty` (device.U in µm und was sonst bekannt ist)|rotary=Im Auftrag"
        " `uncertainty.rotary` (U in ″, setup, E_VE)|circular=Im Auftrag `uncertainty.circular` (U"
        " in µm, length, setup, E_VE)} oder `decision_rule: simple` angeben."
    ),
    "CW-P133": (
        "Achse {axis}: Der Grenzwert wird nach der Vorhersage an denselben Zielpositionen"
        " eingehalten, aber nicht an neuen dazwischen. Dort zeigen 5 % der Prüfungen mehr als"
        " {parameters}, der Grenzwert bleibt deshalb offen.{reasons:if| Der Fehler kann sich"
        " wiederholen: {reasons:join|, oder }.|} Eine neue Prüfung an {better} messen.{known:if||"
        " Die Steigung der Spindel angeben, wenn sie bekannt ist (screw_pitch).}"
    ),
    "CW-P133.open": (
        "mit einer Periode, die diese Zielpositionen offenlassen ({probability:.0%}; vor allem"
        " {periods:3sig} {unit})"
    ),
    "CW-P133.parameter": "{parameter} {value} (Grenzwert {limit:g})",
    "CW-P133.period": "alle {period:.5g} {unit} ({probability:.0%})",
    "CW-P134": (
        "Die Ursachen der Abweichung eines Kreises sind unbekannt (Kreis {causes}). Deshalb wird"
        " für diesen Kreis nichts vorhergesagt, und seine Grenzwerte bleiben offen."
        " {lacking:choose|samples=Mit mindestens {least:d} Messpunkten je Lauf abseits der"
        " Umkehrpunkte messen|circle=Einen vollen Kreis in beiden Richtungen messen|noise=Die"
        " Messpunkte ohne Glättung exportieren}, oder nach der Prüfung nach dem Laden entscheiden."
    ),
    "CW-P135": (
        "Kreise {circles} gemeinsam. {machine:if|{machine:join| }|Sie zeigen keinen Fehler der"
        " Maschine.}"
    ),
    "CW-P135.error": (
        "{kind:choose|squareness=Rechtwinkligkeit|scale=Maßstab|lost"
        " motion=Umkehrspiel|position loop=Zeitkonstante der Lageregelung}: {values}."
    ),
    "CW-P135.value": "{of} {value}",
    "CW-P136": (
        "{kind:choose|squareness=Rechtwinkligkeit|scale=Maßstab|lost motion=Umkehrspiel|servo"
        " mismatch=Unterschied der Lageregelung}: Die Kreise widersprechen sich ({values:join|; })."
        " Entweder änderte sich die Maschine zwischen den Prüfungen, oder ihre Fehler hängen von"
        " Ort, Vorschub oder Temperatur ab. Den Kreis wiederholen, der abweicht."
    ),
    "CW-P136.circle": "{circle}: {axes} {value}",
    "CW-P136.growth": (
        "Achse {axis}: Der Radius der Kreise wächst mit dem Vorschub, stärker als eine Lageregelung"
        " bewirken kann. Vorschub, Radius, Länge des Messgeräts oder Temperatur ist nicht wie"
        " angegeben. Sie für {circles:join|, } prüfen, oder den Kreis wiederholen, der abweicht."
    ),
    "CW-P136.lag": (
        "Achse {axis}: Der Radius der Kreise schrumpft mit dem Vorschub wie bei einer Zeitkonstante"
        " der Lageregelung von {lag} (üblich bis {most}). Vorschub, Radius, Temperatur von"
        " {circles:join|, } prüfen."
    ),
    "CW-P140": (
        "Achse {axis}: Die neue Tabelle bekommt neue Punkte, {grid}. Die Punkte der vorhandenen"
        " Tabelle, {existing}, können nicht bleiben: {why}"
    ),
    "CW-P141": (
        "Achse {axis}: {stays:if|Die neue Tabelle behält die Punkte der vorhandenen Tabelle|Keine"
        " Tabelle mit den Punkten der vorhandenen Tabelle verbessert die Achse} ({existing})."
        " Vorhergesagtes {parameter}{stays:if|| ohne Tabelle}: {same} an denselben Zielpositionen,"
        " {new} an neuen. Vorhergesagtes {parameter} mit neuen Punkten ({grid}): {better} an"
        " denselben Zielpositionen, {better_new} an neuen. Für die neuen Punkte `spacing: auto` in"
        " der Tabelle der Achse setzen. Einstellungen, die von den alten Punkten abhängen, werden"
        " mit angepasst; wo das nicht geht, werden sie aufgeführt"
    ),
    "CW-P142.line": (
        "Die Steigung von {slope} kommt in die getrennte Gerade der Steuerung. An den"
        " Tabellenpunkten bliebe ohne sie ein Fehler von {left} (Effektivwert), mit ihr {with_line}"
    ),
    "CW-P142.table": (
        "Die Steigung von {slope} bleibt in der Tabelle. An den Tabellenpunkten bleibt ohne"
        " getrennte Gerade ein Fehler von {left} (Effektivwert), mit ihr blieben {with_line}"
    ),
    "CW-P143.none": (
        "Keine zyklische Tabelle (zweite Tabelle, die sich mit jeder Periode wiederholt) wird"
        " geschrieben. {period}"
    ),
    "CW-P143.period": (
        "Der Fehler hat eine Periode von {period:g} {unit}, die für Tabellenpunkte im Abstand von"
        " {sections:g} {unit} zu kurz ist. Ohne zyklische Tabelle bleibt ein Fehler von {left}"
        " (Effektivwert), mit ihr {with_it}"
    ),
    "CW-P143.second": (
        "Auch eine zyklische Tabelle (zweite Tabelle, die sich mit jeder Periode wiederholt) wird"
        " geschrieben. {period}"
    ),
    "CW-P144": (
        "Achse {axis}: Die Punkte müssen von Hand eingetippt werden, deshalb hat die Tabelle"
        " wenige: {few}, {mine}. Die andere Wahl ist {many}, {other}. Dafür `start: {start:key},"
        " end: {end:key}, spacing: {spacing:key}` in der Tabelle der Achse setzen"
    ),
    "CW-P150": (
        "Achse {axis}: Eine Tabelle hilft hier nicht. {parameter} an neuen Zielpositionen, zwischen"
        " den gemessenen, ist {now}{with_table:if| ohne Tabelle und {with_table} mit einer}. Die"
        " größte Ursache: {cause} ({value:.2f} {unit}, {share:.0%}): {advice}"
    ),
    "CW-P151.cause": (
        "Achse {axis}: {parameter} an neuen Zielpositionen, zwischen den gemessenen, ist jetzt"
        " {now}, und die Tabelle verringert es um {taken:.0%}. Das meiste vom Rest: {cause}"
        " ({value:.2f} von {left}): {advice}"
    ),
    "CW-P151.scatter": (
        "Achse {axis}: {parameter} an neuen Zielpositionen, zwischen den gemessenen, ist jetzt"
        " {now}, und die Tabelle verringert es um {taken:.0%}. {scatter:.0%} des jetzigen Wertes"
        " ist Streuung der Messwerte, die keine Tabelle verringert"
    ),
    "CW-P152": (
        "Achse {axis}: {tables:choose|left=verwendet wird die Tabelle mit dem kleinsten erwarteten"
        " Fehlerquadrat; sie ist nicht für das kleinste {goal} gemacht|same=die Tabelle mit dem"
        " kleinsten erwarteten Fehlerquadrat ergibt auch das kleinste {goal}|taken=die Tabelle"
        " wurde für das kleinste {goal} gemacht|no_gain=eine Tabelle für das kleinste {goal} zeigt"
        " in neuen simulierten Prüfungen kein kleineres {goal}, deshalb wird die Tabelle mit dem"
        " kleinsten erwarteten Fehlerquadrat verwendet}. Erwartete Werte an neuen"
        " Zielpositionen{tables:choose|left=|same=|taken= (in Klammern: mit der Tabelle des"
        " kleinsten erwarteten Fehlerquadrats)|no_gain= (in Klammern: mit der Tabelle für das"
        " kleinste {goal})}: {parameters} {unit}"
    ),
    "CW-P152.parameter": "{parameter} {value:.2f}{other:if| ({other:.2f})}",
    "CW-P153": (
        "Achse {axis}: Der Unterschied der beiden Tabellen (eine je Richtung) kann die Drift dieser"
        " Prüfung enthalten. Die Umkehrspanne ändert sich um {risen} über den Verfahrweg. Die"
        " Messwerte driften um {drifted} vom ersten zum letzten Lauf. Geht diese Drift in jedem"
        " Lauf weiter, hin und zurück, ändert sie allein die Umkehrspanne um {shown}, auch wenn das"
        " Spiel überall gleich ist. Die Achse warmfahren und neu messen, bevor zwei Tabellen"
        " geladen werden, oder eine Tabelle verwenden (`mode: single` in der Tabelle der Achse)"
    ),
    "CW-P154": (
        "Achse {axis}: Der Losewert kann die Drift dieser Prüfung enthalten. Die mittlere"
        " Umkehrspanne ist {measured}. Die Messwerte driften um {drifted} vom ersten zum letzten"
        " Lauf. Geht diese Drift in jedem Lauf weiter, hin und zurück, ändert sie die mittlere"
        " Umkehrspanne um {shown}. Die Achse warmfahren und neu messen, bevor der Losewert"
        " geladen wird"
    ),
    "CW-P155": (
        "Achse {axis}: Hier aufhören. Von {parameter} = {left:.2f} {unit} an neuen Zielpositionen"
        " kommen {value:.2f} {unit} aus der größten Ursache: {cause}. Eine weitere Runde änderte"
        " weniger, als sich eine Prüfung von der nächsten unterscheidet."
    ),
    "CW-P156": (
        "Achse {axis}: Die Steuerung führt eine Stufe der Korrektur nie aus, deren Größe zwischen"
        " {least:.2f} {unit} und {most:.2f} {unit} liegt. Die Umkehrspanne der Tabelle ist eine"
        " solche Stufe: {reversal:.2f}{reversal_to:if| bis {reversal_to:.2f}} {unit}. Nach einer"
        " Umkehr bleibt deshalb die alte Korrektur, bis sich die Tabelle selbst genug ändert; die"
        " Vorhersage berücksichtigt das. Damit die Steuerung diese Stufen ausführt, die"
        " Beschleunigungsgrenze der Achse unter das {low:3sig}-Fache der jetzigen setzen oder auf"
        " mindestens das {high:3sig}-Fache und neu rechnen"
    ),
    "CW-P160": (
        "Die Messwerte der Prüfung {test} widersprechen den Angaben in ihrer Datei oder im"
        " Auftrag. Sie sind {ways:join|, oder }. Eine Tabelle aus solchen Messwerten wäre falsch."
        " {checks:join| }"
    ),
    "CW-P160.check": (
        "{way:choose|off=War in dieser Prüfung die Kompensation aktiv und die Achse referenziert?"
        " Wenn nicht, für diese Prüfung einen Eintrag unter `states` anlegen und diesen unter"
        " `measured_in` nennen.|sign=Einen Messwert mit dem Messgerät vergleichen: Zu weit in + ist"
        " eine positive Abweichung.|directions=In der Datei des Messgeräts nachsehen, in welcher"
        " Richtung die Achse im ersten Lauf fuhr.|order=Die Messwerte der ersten und der letzten"
        " Zielposition mit der Datei des Messgeräts vergleichen.|against=Die Achse in + bewegen:"
        " Zählt das Messgerät abwärts, braucht die Prüfung `position_map: {{sense: -1, offset:"
        " ..}}`.}"
    ),
    "CW-P160.way": (
        "{odds:odds}-mal wahrscheinlicher, {way:choose|off=wenn die Tabelle der Steuerung in"
        " dieser Prüfung nicht aktiv war|sign=wenn das Vorzeichen der Abweichungen gedreht ist"
        " (Ziel minus gemessen)|directions=wenn + und − vertauscht sind|order=wenn die Messwerte"
        " in umgekehrter Reihenfolge der Zielpositionen stehen|against=wenn das Messgerät gegen"
        " die Maschine zählt}"
    ),
    "CW-P161": (
        "Die Tabelle in states.{measured_in} des Auftrags sieht aus wie das Spiegelbild der Prüfung"
        " {test} ({size:.1f} {unit}). Zufällig sind so glatte Kurven einander in {less:if|weniger"
        " als }{chance:2sig} % der Fälle so ähnlich. Wurde die Tabelle aus dieser Prüfung gemacht,"
        " war sie dabei nicht aktiv, und eine neue Tabelle korrigierte denselben Fehler zweimal."
        " Mit aktiver Tabelle neu messen, oder unter measured_in den Eintrag von `states` nennen,"
        " der bei der Prüfung in der Steuerung war. War die Tabelle in dieser Prüfung aktiv, im"
        " Auftrag angeben, woher das bekannt ist: `acknowledged: {{CW-P161: Grund}}`"
    ),
    "CW-P162.after": (
        "die Datei der Prüfung nach dem Laden nennt die Kompensation {both:if|ein und aus|aus}, der"
        " Plan lädt aber Tabellen für {names:and}. An der Steuerung prüfen, dass sie aktiv sind,"
        " und neu messen, oder den Schlüssel `compensation` der Datei berichtigen."
    ),
    "CW-P162.both": (
        "die Dateien nennen die Kompensation ein und aus. Gibt der Auftrag die falsche an, ist auch"
        " die neue Tabelle falsch. An der Steuerung prüfen, was aktiv war. Dann den Schlüssel"
        " `compensation` der Datei oder `measured_in` und `states` des Auftrags berichtigen."
    ),
    "CW-P162.state": (
        "die Datei nennt die Kompensation {on:if|ein|aus}, aber states.{state} des Auftrags"
        " {active:if|hat eine aktive Tabelle oder Lose|hat nichts Aktives} für {names:and}. Gibt"
        " der Auftrag die falsche Kompensation an, ist auch die neue Tabelle falsch. An der"
        " Steuerung prüfen, was aktiv war. Dann den Schlüssel `compensation` der Datei oder"
        " `measured_in` und `states` des Auftrags berichtigen."
    ),
    "CW-P163": (
        "Achse {axis}, Prüfung {test}: Die Dateien dieser Prüfung geben verschiedene Werte an:"
        " {keys:join|; }. Prüfen, ob alle zu dieser Prüfung gehören"
    ),
    "CW-P164": (
        "Achse {axis}: Der Fehler kann sich mit einer Periode wiederholen, die diese Zielpositionen"
        " nicht zeigen (vor allem {periods:3sig} {unit}). Für eine Prüfung, die ihn zeigt,"
        " {targets:.7g} {unit} zu diesen Zielpositionen hinzufügen: Alle zusammen zeigen einen"
        " solchen Fehler ab einer Amplitude von {amplitude}."
    ),
    "CW-P165": (
        "Achse {axis}: {seen}: {parameter} {low:.2f} bis {high:.2f} {unit} an neuen"
        " Zielpositionen. {otherwise}, ist {parameter} {least:.2f} bis {most:.2f} {unit}. Um das zu"
        " klären, eine zweite Prüfung auf dieselbe Art messen und ihre Datei bei der Achse unter"
        " `before` angeben"
    ),
    "CW-P165.drift": (
        "Die Prüfung driftet um {drift}, und die Vorhersage nimmt dieselbe Drift in der nächsten"
        " Prüfung an"
    ),
    "CW-P165.no_rest": "Streuen die Messwerte um einen Wert",
    "CW-P165.other_drift": "Hat jede Prüfung eine eigene Drift dieser Größe",
    "CW-P165.other_scatter": "Streuen alle Läufe einer Prüfung wie einer dieser Läufe",
    "CW-P165.rest": (
        "Die Messwerte einer Zielposition liegen vielleicht zwischen zwei Grenzen, als hielte die"
        " Achse an einer von zwei Stellen ({probability:.0%})"
    ),
    "CW-P165.scatter": (
        "Die Streuung eines Messwerts ist je nach Lauf {least} bis {most}, und die Vorhersage"
        " nimmt an, dass in der nächsten Prüfung der Anteil der Läufe mit kleiner und mit großer"
        " Streuung gleich bleibt"
    ),
    "CW-P166": (
        "{plane:if|Die Rechtwinkligkeit der Ebene {plane}|Der Maßstab der Achse {axis}} wird"
        " korrigiert, ist aber nicht genau bekannt: Die Korrektur macht den Fehler mit einer"
        " Wahrscheinlichkeit von {percent:2sig} % größer. Weitere volle Kreise in beiden Richtungen"
        " messen und alle angeben"
    ),
    "CW-P167": (
        "Was zu {output} über {input} hinzukäme (bis {largest}), ist gleich dem, was die Steuerung"
        " zwischen diesen beiden Achsen schon addiert. Wurde jene Tabelle aus dieser Messung"
        " gemacht, würde derselbe Fehler zweimal korrigiert. Mit aktiver Tabelle neu messen, oder"
        " unter measured_in den Eintrag von `states` nennen, der während der Messung in der"
        " Steuerung war. War die Tabelle aktiv, im Auftrag angeben, woher das bekannt ist:"
        " `acknowledged: {{CW-P167: Grund}}`"
    ),
    "CW-P168": (
        "Die Korrektur von {output} über {input} erreicht {largest}, mehr als 1 {unit}."
        " {source:choose|cross=`unit` und `positions` dieser Messung unter `cross`|circle=Einheit"
        " und Radius des Kreises und `travel` von {input}} prüfen. Ist der Fehler wirklich so groß,"
        " im Auftrag angeben, woher das bekannt ist: `acknowledged: {{CW-P168: Grund}}`"
    ),
    "CW-P169": (
        "Zwei Messungen unter `cross` korrigieren die Rechtwinkligkeit der Ebene {plane}:"
        " {slopes:and}. Zusammen beseitigen sie {total:+.1f} µm/m. Zeigt jede die ganze"
        " Rechtwinkligkeit, wird sie zweimal korrigiert: dann die Gerade von den Abweichungen einer"
        " der beiden abziehen. Wurden beide gegen einen Winkel gemessen, das im Auftrag angeben:"
        " `acknowledged: {{CW-P169: Grund}}`. Auch ein Kreis dieser Ebene zeigt, was stimmt"
    ),
    "CW-P169.slope": "{slope:+.1f} µm/m in {output} über {input}",
    "CW-P170": (
        "{output} über {input}: Die Positionen {first} bis {last} liegen außerhalb des Verfahrwegs"
        " {travel_start} bis {travel_end} des Auftrags. Versatz und Richtung der Positionen und den"
        " Verfahrweg prüfen."
    ),
    "CW-P171": (
        "eine Datei ist von der Maschine mit der Seriennummer {found:join| oder }, diese hat aber"
        " {known}. Eine Tabelle aus der Prüfung einer anderen Maschine wäre falsch. Die Datei"
        " dieser Maschine angeben oder die Nummer im Auftrag oder in der Datei berichtigen."
    ),
    "CW-P172": (
        "{pair}: Der Maßstabsunterschied hat verschiedene Vorzeichen: {laser} nach dem Laser,"
        " {circle} nach {test}. Die Winkel zählen von der falschen Achse, die Achsen der Ebene"
        " sind vertauscht oder ein Vorzeichen ist falsch, vielleicht auch das der"
        " Rechtwinkligkeit. An der Maschine prüfen, bei welchem Winkel jede Achse liegt. Die Datei"
        " berichtigen oder CW-P172 im Auftrag bestätigen."
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
        " `states: {{as_found: none}}` oder `states: {{as_found: [Dateien der Steuerung]}}` angeben"
    ),
}
