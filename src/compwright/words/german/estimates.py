"""Sentences about the estimated error of an axis, and about the causes found in circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-D001": (
        "nur eine Richtung wurde gemessen. Ursachen, die von der Richtung abhängen, lassen sich"
        " nicht von den anderen trennen. {causes:if|Standardfehler wachsen, am meisten bei"
        " {causes:join|; }|Kein Standardfehler wächst viel}"
    ),
    "CW-D001.cause": "{cause} ({factor:.0f}-fach, ähnelt {other})",
    "CW-D001.more": "und bei {count} weiteren {count:plural|Ursache|Ursachen}",
    "CW-D002": (
        "ein Bogen von {arc:g}° trennt die Ursachen schlechter als ein Vollkreis."
        " {causes:if|Standardfehler wachsen, am meisten bei {causes:join|; }|Kein Standardfehler"
        " wächst viel}"
    ),
    "CW-D003": (
        "die Länge des Messgeräts war nicht kalibriert, deshalb wird der Maßstab einzelner Achsen"
        " nicht angegeben. Angegeben ist nur ihr Unterschied"
    ),
    "CW-D004": (
        "bei {feed:g} mm/min macht eine weiche Lageregelung den Kreis um bis zu {most:.1f} µm"
        " kleiner. Aus diesem Kreis allein ist der Maßstab einzelner Achsen deshalb um"
        " {doubt:.0f} µm/m unsicher. Werten Sie ihn zusammen mit einem Kreis bei kleinem Vorschub"
        " aus: Beide zeigen den Maßstab (CW-P135)"
    ),
    "CW-D005.none": (
        "Achse {name} kehrt auf diesem Bogen nicht um. Ihr Umkehrspiel, seitliches Spiel und ihre"
        " Umkehrspitze sind deshalb nicht bestimmt"
    ),
    "CW-D005.one": (
        "Achse {name} kehrt auf diesem Bogen nur einmal um. Ihr Umkehrspiel ist das am"
        " {end:choose|positive=positiven|negative=negativen} Ende"
    ),
    "CW-D006": (
        "eine periodische Abweichung von {axis} mit der Steigung {pitch:.4g} mm wurde gefunden"
    ),
    "CW-D007": (
        "keine periodische Abweichung der Achse {name} wurde bei Steigungen von {least:2sig} bis"
        " {most:g} mm gefunden. Eine unter {hidden:2sig} µm oder mit anderer Steigung kann noch"
        " verborgen sein"
    ),
    "CW-D008.gradual": (
        "das Umkehrspiel der Achse {name} entsteht allmählich: Nach einer Umkehr fehlen bis zu"
        " {inward:2sig} µm und klingen über etwa {travel:2sig} µm Weg ab. Zuerst die elastische"
        " Verwindung prüfen: Vorspannung der Mutter, Stützlager, Kupplung oder Riemen, Reibung der"
        " Führung. Losekompensation wirkt sofort und kann ihm nicht folgen"
    ),
    "CW-D008.inward": (
        "nach den Umkehrungen der Achse {name} liegt die Bahn bis zu {inward:2sig} µm innerhalb"
        " des Kreises. Ihre Reibungskompensation kann zu stark sein. Losekompensation zeigt"
        " dasselbe, wo das Umkehrspiel allmählich entsteht"
    ),
    "CW-D009": (
        "die Messpunkte zeigen nur Perioden von {least:3sig} bis {most:g} mm, ein Fehler der"
        " Periode {period:g} mm entlang der Achse {axis} bleibt also ungesehen"
    ),
    "CW-D010": (
        "ein Teil der Abweichung, {rms:2sig} µm (quadratisches Mittel), hat eine Form, die keine"
        " bekannte Ursache erklärt. Die Standardfehler berücksichtigen das"
    ),
    "CW-D011": (
        "die Achsen kehren {lag:.1f} ± {error:.1f} ms nach ihrem Sollwert um; die Winkel wurden"
        " um diesen Verzug berichtigt"
    ),
    "CW-D012": (
        "Was auf eine Umkehr folgt, liegt in der Datei vor ihr ({odds}). Entweder sind die beiden"
        " Drehrichtungen vertauscht, und Umkehrspiel und Unterschied der Lageregelung haben das"
        " falsche Vorzeichen, oder die Winkel eilen vor. Prüfen Sie, welcher Lauf im Uhrzeigersinn"
        " war und bei welchem Winkel der erste Messpunkt liegt. Berichtigen Sie die Datei, oder"
        " bestätigen Sie CW-D012 im Auftrag."
    ),
    "CW-D013": (
        "Das Umkehrspiel ist {values:and}, ein Kreis mit Umkehrspiel zeigt es aber über null. Ist"
        " die Losekompensation nicht zu groß, dann sind das Vorzeichen der Abweichungen, der Sinn"
        " der Winkel oder die beiden Drehrichtungen vertauscht. Bei den ersten beiden hat auch die"
        " Rechtwinkligkeit das falsche Vorzeichen. An der Maschine prüfen: 10 µm nach außen"
        " fahren, die Anzeige muss steigen. Die Datei berichtigen oder die Kompensation"
        " verkleinern, oder CW-D013 im Auftrag bestätigen."
    ),
    "CW-E001": (
        "Nur eine Richtung wurde gemessen. In der anderen wird derselbe Fehler angenommen, das"
        " Umkehrspiel ist unbekannt."
    ),
    "CW-E002": (
        "Es gibt nur eine Anfahrt je Zielposition und Richtung. Das Rauschen wird deshalb aus der"
        " Streuung zwischen benachbarten Zielpositionen geschätzt."
    ),
    "CW-E003": (
        "Der Abstand der Zielpositionen verbirgt einen Fehler der Periode {period:g} {unit},"
        " deshalb ist diese Periode nicht Teil der Schätzung. Eine Prüfung an anderen"
        " Zielpositionen kann mehr Fehler zeigen als vorhergesagt; {better}"
    ),
    "CW-E004": (
        "Der Verfahrweg reicht bis zu {beyond:g} {unit} über den gemessenen Bereich hinaus"
        " ({first:g} bis {last:g} {unit}). Jenseits davon wird der Fehler mit der gemessenen"
        " Steigung extrapoliert, und seine Unsicherheit wächst"
    ),
    "CW-E010": (
        "Die Zielpositionen liegen {interval:.4g} {unit} auseinander. Dort sieht ein Fehler der"
        " Periode {period:g} {unit} aus wie {wave:if|eine Welle von {wave:.4g} {unit}|eine"
        " Konstante}, und beide lassen sich nicht trennen. Die Periode ist deshalb nicht Teil der"
        " Schätzung, und kein Grenzwert kann als eingehalten gelten; {better}"
    ),
    "CW-E011": (
        "Die Tabelle entsteht aus {number:plural|Prüfung {tests} allein, die|den Prüfungen"
        " {tests:and}, die} {low:g} bis {high:g} {unit} {number:plural|abdeckt|abdecken}. Prüfung"
        " {other} maß {other_low:g} bis {other_high:g} {unit}, wird aber nicht verwendet: Der"
        " Zustand der Steuerung in dieser Prüfung ist nicht bekannt. Jenseits von {low:g} bis"
        " {high:g} {unit} ist der Fehler nur extrapoliert und kann um mehr als 100 % falsch sein."
        " Eines von drei Dingen tun: unter `measured_in` den Eintrag von `states` nennen, der bei"
        " Prüfung {other} in der Steuerung war; Prüfung {other} unter `before` zuerst nennen; oder"
        " die Tabelle am gemessenen Bereich enden lassen (`start` und `end` von `table`)"
    ),
    "CW-E012.found": (
        "Der Fehler wiederholt sich alle {period:.5g} {unit} (Wahrscheinlichkeit"
        " {probability:.0f} %, {odds}): {meaning}.{nodes:if| Die Punkte der vorhandenen Tabelle"
        " liegen auch {nodes:.5g} {unit} auseinander. Eine Tabelle, die in der Prüfung nicht"
        " aktiv war, hinterlässt einen solchen Fehler: zuerst prüfen, dass sie aktiv war.}"
        " Schätzung und Vorhersage gewichten die Periode mit ihrer Wahrscheinlichkeit"
    ),
    "CW-E012.period": "{period:.5g} {unit} ({percent:.0f} %)",
    "CW-E012.possible": (
        "Der Fehler kann sich alle {periods:join| oder } wiederholen, aber diese Zielpositionen"
        " zeigen es nicht klar. Schätzung und Vorhersage gewichten eine mögliche Periode mit ihrer"
        " Wahrscheinlichkeit. Zur Entscheidung an mehr Zielpositionen mit zufälligen Versätzen"
        " messen"
    ),
    "CW-E013": (
        "Der Fehler wiederholt sich, aber an diesen Zielpositionen sehen mehrere Perioden gleich"
        " aus: {periods:.4g}{more:if| und {more} andere} {unit}. Welche davon die wahre ist, zeigen"
        " die Messwerte nicht, deshalb korrigiert die Tabelle vielleicht eine falsche, und eine"
        " Prüfung an anderen Zielpositionen kann den ganzen periodischen Fehler zeigen; {better}"
    ),
    "CW-E014.equal_spacing": (
        "Keine Periode wurde gefunden, aber Zielpositionen mit gleichem Abstand ({interval:.4g}"
        " {unit}) verbergen jede Periode, die darin aufgeht. Die Meldung CW-T008 dieser Prüfung"
        " schlägt Zielpositionen vor, die diese Perioden zeigen würden"
    ),
    "CW-E014.few_targets": (
        "{targets} Zielpositionen sind zu wenige, um eine periodische Abweichung zu suchen. An"
        " acht oder mehr Zielpositionen mit zufälligen Versätzen messen"
    ),
    "CW-E014.hidden": (
        "Der Auftrag nennt keine Spindelsteigung oder andere Periode, und keine ist sicher: Mit"
        " einer Wahrscheinlichkeit von {probability:.0f} % enthalten die Messwerte einen Fehler,"
        " der sich wiederholt"
    ),
    "CW-E014.unlikely": (
        "Der Auftrag nennt keine Spindelsteigung oder andere Periode, und die Messwerte zeigen"
        " keine"
    ),
    "CW-E015": (
        "Die Messwerte zeigen {fitted} der {known} bekannten Perioden: {periods:g} {unit}. Die"
        " anderen Perioden sind nicht Teil der Schätzung"
    ),
    "CW-E016": (
        "Der Auftrag nennt screw_pitch {stated:and} {unit}, aber die Messwerte zeigen keinen"
        " Fehler mit dieser Periode. Sie zeigen einen, der sich alle {found:and} {unit}"
        " wiederholt. Die Steigung prüfen: Beide Perioden bleiben in der Schätzung, wo eine"
        " falsche nicht schadet, aber die Tabellenpunkte werden für die angegebene gewählt"
    ),
    "CW-E020": (
        "Die Messwerte driften um {drift} vom ersten zum letzten Lauf ({odds}){flattens:if|, und"
        " die Drift flacht ab}. {alone:if|Die Vorhersage kennt nur diese eine Prüfung. Sie nimmt"
        " an, dass eine gleich wiederholte Prüfung bei ebenso kalter Achse um denselben Betrag"
        " driftet (auf etwa 10 % genau). Driftet die nächste Prüfung anders, oder bei warmer Achse"
        " gar nicht, können ihre Werte außerhalb des vorhergesagten Bandes liegen. Mit einer"
        " zweiten, auf dieselbe Art gemessenen Prüfung berücksichtigt das vorhergesagte Band solche"
        " Unterschiede|Die Vorhersage enthält, wie die Drift sich zwischen den Prüfungen"
        " unterscheidet}. Um die Achse ohne Drift zu sehen, sie warmfahren und neu messen"
    ),
    "CW-E021": (
        "Die Messwerte driften über den Verfahrweg wie bei einer Wärmedehnung: um {lower} am"
        " unteren und {upper} am oberen Ende, vom ersten zum letzten Lauf ({odds}){flattens:if|."
        " Die Drift flacht ab}. {alone:if|Die Vorhersage gilt für eine Prüfung, die bei ebenso"
        " kalter Achse gleich wiederholt wird und um denselben Betrag driftet (auf etwa 10 %"
        " genau). Driftet die nächste Prüfung anders, oder bei warmer Achse gar nicht, können ihre"
        " Werte außerhalb des vorhergesagten Bandes liegen|Die Vorhersage enthält, wie die Drift"
        " sich zwischen den Prüfungen unterscheidet}. Um die Achse ohne Drift zu sehen, sie"
        " warmfahren und neu messen"
    ),
    "CW-E022.all": (
        "{pattern:choose|traverses=Einzelne Läufe sind gegeneinander verschoben|runs=Läufe sind"
        " samt Rückweg gegeneinander verschoben|walk=Der Nullpunkt wandert von Lauf zu"
        " Lauf|wave=Die Messwerte steigen und fallen langsam mit der Zeit} um"
        " {size}{pattern:choose|walk= je Lauf|=} (Standardabweichung; {odds}){where:if|,"
        " {where:and}}. {pattern:choose|wave=Die Luft um die Maschine prüfen: Heizung, Kühlung,"
        " Zugluft, Sonne|=Warmlaufen, Klemmung, Referenzfahrten und Befestigung des Messgeräts"
        " zwischen den Läufen prüfen}. Die Vorhersage nimmt"
        " {pattern:choose|wave=Wellen|=Verschiebungen} dieser Größe in der nächsten Prüfung an"
    ),
    "CW-E022.either": (
        "Die Läufe sind gegeneinander verschoben ({odds}). Ob die Achse driftet oder springt,"
        " zeigen diese Messwerte nicht; die Vorhersage rechnet mit beidem. Warmlaufen, Klemmung,"
        " Referenzfahrten und Befestigung des Messgeräts zwischen den Läufen prüfen"
    ),
    "CW-E022.seldom": (
        "{pattern:choose|traverses=Einzelne Läufe weichen von den anderen ab,|runs=Einzelne Läufe"
        " weichen samt Rückweg von den anderen ab,|walk=Der Nullpunkt springt ab und zu an eine"
        " neue Stelle,} um {size} (Standardabweichung; {odds}){where:if|, {where:and}}."
        " Warmlaufen, Klemmung, Referenzfahrten und Befestigung des Messgeräts zwischen den Läufen"
        " prüfen. Die Vorhersage nimmt Verschiebungen dieser Größe in der nächsten Prüfung an,"
        " ebenso selten"
    ),
    "CW-E023": (
        "Der Maßstab ändert sich von Lauf zu Lauf: Die Abweichungen an den Enden des Verfahrwegs"
        " verschieben sich um {tilt} gegenüber denen in seiner Mitte (Standardabweichung; {odds})."
        " Prüfen, wie das Messgerät Luft und Temperatur kompensiert, und nach Zugluft suchen"
    ),
    "CW-E024": (
        "{outliers} von {readings} Messwerten {outliers:plural|ist ein Ausreißer|sind Ausreißer}:"
        " {where}{more:if| und {more} weitere} ({odds}). Ausreißer zählen wenig in der Schätzung,"
        " und die Vorhersage erwartet ebenso viele in einer wiederholten Prüfung. Nächster"
        " Schritt: {cause}, dann neu messen"
    ),
    "CW-E024.reading": "ihre Ursache suchen (Strahl, Späne, Klemmung)",
    "CW-E024.traverse": "alle liegen in {traverse}, klären, was in diesem Lauf geschah",
    "CW-E025": (
        "Einige Messwerte liegen weiter vom Mittel, als normale Streuung erklärt ({odds}). Solche"
        " Messwerte zählen in der Schätzung weniger, und die Vorhersage erwartet sie auch in"
        " einer wiederholten Prüfung"
    ),
    "CW-E026": (
        "Die Messwerte streuen um {positive} in + und um {negative} in − ({odds}): suchen, was sich"
        " nur in einer Richtung frei bewegt"
    ),
    "CW-E027": (
        "Die Streuung der Messwerte hängt von der Position ab ({odds}). Am kleinsten, {least},"
        " ist sie bei {least_at}, am größten, {most}, bei {most_at}. Spindel, Führungen und"
        " Abdeckungen dort ansehen, wo sie am größten ist"
    ),
    "CW-E028": (
        "Prüfung {test} hat eine andere Steigung als Prüfung {other}: Der Unterschied ist"
        " {difference:+.1f} ± {error:.1f} µm/m. So viel dehnt sich Stahl aus, wenn er {kelvin:2sig}"
        " K wärmer wird. Der Unterschied gilt deshalb als Wirkung von Temperatur oder Aufbau einer"
        " der Prüfungen, nicht als Fehler der Achse. Welche Steigung richtig ist, zeigen die"
        " Prüfungen nicht: die Temperaturen beider Prüfungen angeben (`thermal` des Auftrags) oder"
        " bei gleichmäßiger Temperatur neu messen"
    ),
    "CW-E029": (
        "Das Messgerät löst anscheinend {step} auf: {repeated:if|Alle Messwerte einer Zielposition"
        " sind gleich, und |}alle Messwerte sind Vielfache dieses Schritts. Der wahre Fehler kann"
        " von jedem Mittelwert um einen halben Schritt abweichen. Löst das Messgerät mehr auf, die"
        " Messwerte mit allen Stellen exportieren und neu auswerten"
    ),
    "CW-E030.jump": (
        "Der Fehler springt um {size} ± {error} zwischen {low:.10g} und {high:.10g} {unit}"
        " (Chancen {sure:if|über 1000|{odds:2sig}} zu 1). Dort den Maßstab (Schaden, Schmutz,"
        " Stoß) und seinen Lesekopf ansehen und die Strichzahl des Gebers prüfen. Wo genau der"
        " Fehler springt, ist unbekannt: zwischen diesen Zielpositionen alle paar mm messen,"
        " bevor eine Tabelle geladen wird"
    ),
    "CW-E030.jump_or_target": (
        "Entweder springt der Fehler um {size} ± {error} zwischen {low:.10g} und {high:.10g}"
        " {unit}, oder nur die Zielposition bei {target:.10g} {unit} weicht so viel ab. Dort den"
        " Maßstab (Schaden, Schmutz, Stoß) und seinen Lesekopf ansehen und die Strichzahl des"
        " Gebers prüfen. Wo genau der Fehler springt, ist unbekannt: zwischen diesen"
        " Zielpositionen alle paar mm messen, bevor eine Tabelle geladen wird"
    ),
    "CW-E031": (
        "Um Zeit zu sparen, wird das Rauschen aus {used} von {runs} Läufen geschätzt, gleichmäßig"
        " über die Prüfung verteilt. Die Mittelwerte verwenden alle Läufe"
    ),
    "CW-E032": (
        "{outliers} von {readings} Messwerten sind Ausreißer, mehrere an derselben Zielposition:"
        " {where}{more:if| und {more} weitere} ({odds}). Der wahre Fehler der Achse dort ist"
        " unsicher. Nächster Schritt: {cause}, dann neu messen"
    ),
    "CW-E032.target": (
        "die Messwerte bei {target:and} prüfen (Einheit, Strahl, Späne) und dort Spindel, Führungen"
        " und Abdeckungen ansehen"
    ),
    "period.cause": (
        "{cause:choose|lead=eine Spindelsteigung von {number:g} mm|inch_lead=eine Spindelsteigung"
        " von {number:g} Zoll|half_lead=die halbe Spindelsteigung von {number:g} mm|magnets=ein"
        " Magnetpaar eines Linearmotors|rack=ein Zahn einer schrägverzahnten Zahnstange|worm=eine"
        " Umdrehung von Schnecke oder Motor ({number:g} auf eine Umdrehung des Tisches)|files=eine"
        " Periode, die die Dateien der Steuerung nahelegen}"
    ),
    "period.unusual_division": (
        "kein übliches Teil wiederholt sich {parts:.4g}-mal je Umdrehung. Diese Periode mit einer"
        " Umdrehung der Schnecke, einer des Motors über sein Getriebe und der Teilung des Maßstabs"
        " vergleichen"
    ),
    "period.unusual_lead": (
        "keine übliche Spindel hat diese Steigung. Diese Periode mit einer Umdrehung des Motors"
        " über Riemen oder Getriebe, der Hälfte davon, der Teilung von Maßstab oder Zahnstange und"
        " einem Magnetpaar vergleichen"
    ),
    "period.usual": (
        "{once:if|suchen, was sich in {period:.5g} {unit} einmal dreht oder wiederholt:"
        " {once:join|, oder }|}{twice:if|{once:if|; oder was sich|suchen, was sich} in {double:.5g}"
        " {unit} einmal dreht oder wiederholt und dabei den Fehler zweimal macht: {twice:join|,"
        " oder }|}"
    ),
}
