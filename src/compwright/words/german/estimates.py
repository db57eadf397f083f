"""What the estimate of an error and the diagnosis of circles say."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-D001": (
        "nur eine Richtung: Was von der Richtung abhängt, lässt sich von dem anderen nicht trennen;"
        " Standardfehler, die das vervielfacht: {causes:if|{causes}|keine}"
    ),
    "CW-D001.cause": "{cause} (x {factor:.0f}, mit {other})",
    "CW-D002": (
        "ein Bogen von {arc:g}° unterscheidet die Ursachen schlechter als ein Kreis;"
        " Standardfehler, die das vervielfacht: {causes:if|{causes}|keine}"
    ),
    "CW-D003": (
        "die Länge des Messgeräts war nicht kalibriert: Der Maßstab einzelner Achsen wird nicht"
        " angegeben, nur ihr Unterschied"
    ),
    "CW-D004": (
        "bei {feed:g} mm/min macht eine weiche Lageregelung den Kreis um bis zu {most:.1f} µm"
        " kleiner: Der Maßstab einzelner Achsen ist deshalb um {doubt:.0f} µm/m unsicher; eine"
        " zweite Prüfung mit kleinem Vorschub entscheidet es"
    ),
    "CW-D005.none": (
        "der Bogen enthält keinen Umkehrpunkt von {name}: Umkehrspiel, seitliches Spiel und"
        " Umkehrspitze sind nicht bestimmt"
    ),
    "CW-D005.one": (
        "der Bogen enthält nur einen Umkehrpunkt von {name}: Das Umkehrspiel ist das am"
        " {end:choose|positive=positiven|negative=negativen} Ende"
    ),
    "CW-D006": (
        "eine periodische Abweichung von {axis} mit der Steigung {pitch:.4g} mm wurde gefunden"
    ),
    "CW-D007": (
        "keine periodische Abweichung von {name} wurde gefunden; eine unter {hidden:2sig} µm kann"
        " verborgen sein"
    ),
    "CW-D008": (
        "{name} liegt nach der Umkehr bis zu {inward:2sig} µm innen: Die Losekompensation kann zu"
        " stark sein"
    ),
    "CW-D009": (
        "eine Periode von {period:g} mm entlang {axis} ist nicht zu sehen: Die Messpunkte zeigen"
        " Perioden von {least:3sig} bis {most:g} mm"
    ),
    "CW-D010": (
        "{rms:2sig} µm der Abweichung haben eine Form, die keine Ursache erklärt; die"
        " Standardfehler berücksichtigen das"
    ),
    "CW-D011": (
        "die Achsen kehren {lag:.1f} ± {error:.1f} ms nach ihrem Sollwert um; die Winkel wurden"
        " um diesen Verzug berichtigt"
    ),
    "CW-E001": (
        "Nur in einer Richtung gemessen: Derselbe Fehler wird in beiden angenommen, das Umkehrspiel"
        " ist nicht bekannt."
    ),
    "CW-E002": (
        "Eine Anfahrt je Zielposition und Richtung: Das Rauschen wird aus der Streuung zwischen"
        " benachbarten Zielpositionen geschlossen."
    ),
    "CW-E003": (
        "Die Zielpositionen können einen Fehler der Periode {period:g} {unit} nicht zeigen (ihr"
        " Abstand verbirgt ihn): Er bleibt weg, und eine Prüfung an anderen Zielpositionen kann"
        " mehr zeigen als vorhergesagt; {better}"
    ),
    "CW-E004": (
        "Der Verfahrweg reicht bis zu {beyond:g} {unit} über den gemessenen Bereich hinaus"
        " ({first:g} bis {last:g} {unit}): Dort wird der Fehler mit der gemessenen Steigung"
        " fortgesetzt, und seine Unsicherheit wächst"
    ),
    "CW-E010": (
        "An diesen Zielpositionen, {interval:.4g} {unit} auseinander, sieht ein Fehler der Periode"
        " {period:g} {unit} aus wie {wave:if|eine Welle von {wave:.4g} {unit}|eine Konstante}:"
        " Beide lassen sich nicht trennen, die Periode wird nicht angepasst, und kein Grenzwert"
        " wird angenommen; {better}"
    ),
    "CW-E011": (
        "Die Tabelle entsteht aus {number:plural|der Prüfung {tests} allein, die|den Prüfungen"
        " {tests:and} und} {low:g} bis {high:g} {unit} abdeckt; die Prüfung {other} maß"
        " {other_low:g} bis {other_high:g} {unit} und wird nicht angepasst. Jenseits von {low:g}"
        " bis {high:g} {unit} ist der Fehler nur fortgesetzt und kann um mehr falsch sein, als er"
        " groß ist: den Zustand nennen, der bei der Messung in der Steuerung aktiv war"
        " (measured_in), die Prüfung {other} zuerst nennen, oder die Tabelle am gemessenen Bereich"
        " enden lassen (table: start, end)"
    ),
    "CW-E012.found": (
        "Der Fehler wiederholt sich alle {period:.5g} {unit} (Wahrscheinlichkeit {probability:.0f}"
        " %, {odds}): {meaning}.{nodes:if| Die Stützpunkte der Tabelle in der Steuerung liegen auch"
        " {nodes:.5g} {unit} auseinander: Eine Tabelle, die nicht aktiv war, wie ihre Dateien"
        " sagen, hinterlässt einen Fehler, der so aussieht; zuerst prüfen, dass sie es war.} Er"
        " zählt in Schätzung und Vorhersage mit dieser Wahrscheinlichkeit"
    ),
    "CW-E012.period": "{period:.5g} {unit} ({percent:.0f} %)",
    "CW-E012.possible": (
        "Der Fehler kann sich alle {periods} wiederholen: Diese Zielpositionen entscheiden es"
        " nicht, und jede Periode zählt mit ihrer Wahrscheinlichkeit. Mehr Zielpositionen mit"
        " zufälligen Versätzen würden es zeigen"
    ),
    "CW-E013": (
        "Der Fehler wiederholt sich, aber diese Zielpositionen zeigen nicht, mit welcher Periode:"
        " {periods:.4g}{more:if| und {more} andere} {unit} sehen dort gleich aus. Keine wird sicher"
        " herausgenommen, und eine Prüfung an anderen Zielpositionen kann alles davon zeigen;"
        " {better}"
    ),
    "CW-E014.equal_spacing": (
        "Keine Periode wurde gefunden, aber gleiche Abstände verbergen die, die darin aufgehen"
        " ({interval:.4g} {unit}); die Zielpositionen, die CW-T008 vorschlägt, würden sie zeigen"
    ),
    "CW-E014.few_targets": (
        "Zu wenige Zielpositionen ({targets}), um eine periodische Abweichung zu suchen: acht mit"
        " zufälligen Versätzen zeigen einige, mehr sind besser"
    ),
    "CW-E014.hidden": (
        "Keine Spindelsteigung oder andere Periode ist angegeben, und keine wurde gefunden: Mit"
        " einer Wahrscheinlichkeit von {probability:.0f} % wiederholt sich der Fehler mit einer"
        " Periode, die diese Zielpositionen kaum zeigen"
    ),
    "CW-E014.unlikely": (
        "Keine Spindelsteigung oder andere Periode ist angegeben, und keine wurde gefunden: Mit"
        " einer Wahrscheinlichkeit unter 1 % wiederholt sich der Fehler mit einer Periode, die"
        " diese Zielpositionen kaum zeigen"
    ),
    "CW-E015": (
        "Von {known} bekannten Perioden zeigen die Messwerte {fitted}: {periods:g} {unit}; die"
        " anderen werden nicht angepasst"
    ),
    "CW-E016": (
        "Die Messwerte zeigen keinen Fehler, der sich alle {stated:and} {unit} wiederholt, wie der"
        " Auftrag sagt (screw_pitch), aber einen, der sich alle {found:and} {unit} wiederholt:"
        " Stimmt die Steigung? Beide bleiben in der Schätzung; eine falsche schadet dort nicht,"
        " aber das Raster wird für sie gewählt"
    ),
    "CW-E020": (
        "Die Messwerte driften um {drift} vom ersten zum letzten Lauf ({odds}){flattens:if|, und"
        " die Drift flacht ab}. Mit einer Prüfung nimmt die Vorhersage in einer gleich"
        " wiederholten, von ebenso kalter Achse, dieselbe Drift an, auf etwa ein Zehntel: Eine"
        " andere Drift, oder keine, weil die Achse dann warm ist, liegt außerhalb des Bandes. Eine"
        " zweite Prüfung auf dieselbe Art bringt sie hinein. Die Achse warmfahren und neu messen,"
        " um sie ohne zu sehen"
    ),
    "CW-E021": (
        "Die Messwerte driften über den Verfahrweg auseinander, wie bei einer Wärmedehnung: um"
        " {lower} am unteren und {upper} am oberen Ende vom ersten zum letzten Lauf"
        " ({odds}){flattens:if|, und die Drift flacht ab}. Die Vorhersage nimmt in einer gleich"
        " wiederholten Prüfung, von ebenso kalter Achse, dieselbe Drift an, auf etwa ein Zehntel."
        " Mehr zeigt eine Prüfung nicht: Eine andere Drift, oder keine, weil die Achse dann warm"
        " ist, liegt außerhalb des Bandes. Die Achse warmfahren und neu messen, um sie ohne zu"
        " sehen"
    ),
    "CW-E022.all": (
        "{pattern:choose|traverses=Läufe sind gegeneinander verschoben|runs=Läufe sind samt"
        " Rückweg gegeneinander verschoben|walk=Der Nullpunkt wandert von Lauf zu"
        " Lauf|wave=Die Messwerte steigen und fallen langsam mit der Zeit} um"
        " {size}{pattern:choose|traverses=|runs=|wave=|walk= je Schritt} (eine Standardabweichung;"
        " {odds}){where:if|, {where:and}}: {pattern:choose|traverses=Warmlaufen, Klemmung,"
        " Referenzfahrten und Befestigung des Messgeräts zwischen den Läufen"
        " ansehen|runs=Warmlaufen, Klemmung, Referenzfahrten und Befestigung des Messgeräts"
        " zwischen den Läufen ansehen|walk=Warmlaufen, Klemmung, Referenzfahrten und"
        " Befestigung des Messgeräts zwischen den Läufen ansehen|wave=die Luft der Halle"
        " ansehen (Heizung, Kühlung, Zugluft, Sonne)}. Die Vorhersage zieht solche"
        " {pattern:choose|wave=Wellen|=Verschiebungen} neu"
    ),
    "CW-E022.either": (
        "Die Läufe bewegen sich gegeneinander ({odds}); ob sie driften oder springen, zeigen"
        " diese Messwerte nicht: Warmlaufen, Klemmung, Referenzfahrten und Befestigung des"
        " Messgeräts zwischen den Läufen ansehen. Die Vorhersage rechnet mit beidem"
    ),
    "CW-E022.seldom": (
        "{pattern:choose|traverses=Einzelne Läufe weichen von den anderen ab,|runs=Einzelne"
        " Läufe weichen samt Rückweg von den anderen ab,|walk=Der Nullpunkt springt ab und zu und"
        " bleibt dort,} um {size} (eine Standardabweichung; {odds}){where:if|, {where:and}}:"
        " Warmlaufen, Klemmung, Referenzfahrten und Befestigung des Messgeräts zwischen den"
        " Läufen ansehen. Die Vorhersage zieht solche Verschiebungen neu, ebenso selten"
    ),
    "CW-E023": (
        "Der Maßstab ändert sich von Lauf zu Lauf: Die Enden des Verfahrwegs bewegen sich"
        " um {tilt} gegen seine Mitte (eine Standardabweichung; {odds}): die Kompensation von Luft"
        " und Temperatur des Messgeräts und Zugluft ansehen"
    ),
    "CW-E024": (
        "{outliers} von {readings} Messwerten {outliers:plural|ist ein Ausreißer|sind Ausreißer}:"
        " {where}{more:if| und {more} weitere} ({odds}). Sie zählen wenig in der Schätzung, und in"
        " einer wiederholten Prüfung werden ebenso viele erwartet: {cause}, dann neu messen"
    ),
    "CW-E024.reading": "ihre Ursache suchen (Strahl, Späne, Klemmung)",
    "CW-E024.target": "alle bei {target}, dort Spindel, Führungen und Abdeckungen ansehen",
    "CW-E024.traverse": "alle in {traverse}, klären, was in diesem Lauf geschah",
    "CW-E025": (
        "Einzelne Messwerte liegen weiter außen, als übliche Streuung erklärt ({odds}): Ferne"
        " Messwerte zählen in der Schätzung weniger, und in einer wiederholten Prüfung werden"
        " solche erwartet"
    ),
    "CW-E026": (
        "Die Messwerte streuen um {positive} in + und um {negative} in − ({odds}): suchen, was sich"
        " nur in einer Richtung frei bewegt"
    ),
    "CW-E027": (
        "Die Streuung der Messwerte hängt von der Position ab: am kleinsten, {least}, bei"
        " {least_at} und am größten, {most}, bei {most_at} ({odds}): Spindel, Führungen und"
        " Abdeckungen ansehen, wo sie am größten ist"
    ),
    "CW-E028": (
        "Prüfung {test} hat eine andere Steigung als Prüfung {other}: {difference:+.1f} ±"
        " {error:.1f} µm/m, so viel wie {kelvin:2sig} K bei Stahl. Das zählt als Temperatur oder"
        " Aufbau einer der Prüfungen, nicht als Fehler der Achse; welche Steigung richtig ist,"
        " zeigen sie nicht: die Temperaturen der Prüfungen angeben (thermal) oder bei gleichmäßiger"
        " Temperatur neu messen"
    ),
    "CW-E029": (
        "Angenommene Auflösung des Messgeräts: {step} ({repeated:if|jede Zielposition wiederholt"
        " einen Messwert, und |}alle Messwerte liegen auf diesem Schritt). Der wahre Fehler kann"
        " von jedem Mittelwert um einen halben Schritt abweichen. Löst das Messgerät mehr auf, die"
        " Messwerte mit allen Stellen exportieren und neu auswerten"
    ),
    "CW-E030.jump": (
        "Der Fehler springt um {size} ± {error} zwischen {low:.10g} und {high:.10g} {unit} (Chancen"
        " {sure:if|über 1000|{odds:2sig}} zu 1): dort den Maßstab ansehen (Schaden, Schmutz, Stoß),"
        " seinen Lesekopf und die Strichzahl des Gebers. Zwischen diesen Zielpositionen ist der Ort"
        " des Sprungs unbekannt: dort an Zielpositionen in wenigen mm Abstand messen, bevor eine"
        " Tabelle geladen wird"
    ),
    "CW-E030.jump_or_target": (
        "Der Fehler springt um {size} ± {error} zwischen {low:.10g} und {high:.10g} {unit}, oder"
        " nur die Zielposition bei {target:.10g} {unit} weicht so viel ab: dort den Maßstab ansehen"
        " (Schaden, Schmutz, Stoß), seinen Lesekopf und die Strichzahl des Gebers. Zwischen diesen"
        " Zielpositionen ist der Ort des Sprungs unbekannt: dort an Zielpositionen in wenigen mm"
        " Abstand messen, bevor eine Tabelle geladen wird"
    ),
    "CW-E031": (
        "Das Rauschen wird aus {used} von {runs} Läufen geschätzt, gleichmäßig über die Prüfung"
        " verteilt; die Mittelwerte verwenden alle Läufe"
    ),
    "period.cause": (
        "{cause:choose|lead=eine Spindelsteigung von {number:g} mm|inch_lead=eine Spindelsteigung"
        " von {number:g} Zoll|half_lead=die halbe Spindelsteigung von {number:g} mm|magnets=ein"
        " Magnetpaar eines Linearmotors|rack=ein Zahn einer schrägverzahnten Zahnstange|worm=eine"
        " Umdrehung von Schnecke oder Motor, 1/{number:g} der des Tisches|files=was die Dateien der"
        " Steuerung nahelegen}"
    ),
    "period.unusual_division": (
        "keine übliche Teilung ({parts:.4g} je Umdrehung): die Umdrehung der Schnecke oder des"
        " Motors über sein Getriebe und die Teilung des Maßstabs ansehen"
    ),
    "period.unusual_lead": (
        "keine übliche Steigung: die Umdrehung des Motors über Riemen oder Getriebe, die Hälfte"
        " davon, die Teilung von Maßstab oder Zahnstange, ein Magnetpaar ansehen"
    ),
    "period.usual": (
        "{once:if|suchen, was sich in {period:.5g} {unit} einmal dreht oder wiederholt:"
        " {once:join|, oder }|}{twice:if|{once:if|; oder was es|suchen, was es} in {double:.5g}"
        " {unit} zweimal tut: {twice:join|, oder }|}"
    ),
}
