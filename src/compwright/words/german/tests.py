"""What is noticed about positioning and circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-C001": (
        "Jeder Kennwert gehört zu einem Lauf (Abschnitte 3.2 und 5); angegeben sind die von"
        " {first:and}. Andere: {others}."
    ),
    "CW-C001.other": "{direction} Lauf {run}: G {G}",
    "CW-C001.run": "{direction} Lauf {run}",
    "CW-C002": (
        "Nur {direction} wurde gemessen: Kennwerte beider Richtungen gibt es nicht, und"
        " Rechtwinkligkeit, Unterschied der Lageregelung und Umkehrspiel lassen sich nicht trennen."
    ),
    "CW-C003": (
        "Die Länge des Messgeräts war nicht kalibriert: F wird nicht angegeben; D und F um den"
        " Ausgleichsmittelpunkt beruhen auf der Nennlänge."
    ),
    "CW-C004": (
        "Die Messpunkte von {run} liegen {interval:3sig}° auseinander: Umkehrspitzen können fehlen,"
        " und G, F und H fallen zu klein aus."
    ),
    "CW-C005.arc": "{run} überdeckt {covered:.5g}° eines Bogens von {arc:.5g}°.",
    "CW-C005.gap": (
        "Keine Messpunkte von {run} von {gaps}: Was die Bahn dort tut, wird nicht ausgewertet."
    ),
    "CW-C006.no_feed": "{feed:g} mm/min ist kein Vorschub.",
    "CW-C006.time": (
        "Mit {feed:g} mm/min dauert ein Kreis von {radius:g} mm {seconds:3sig} s: die Einheit des"
        " Vorschubs prüfen."
    ),
    "CW-C007": (
        "{run} überdeckt {covered:.5g}°, mehr als den Bogen von {arc:.5g}°: Anlauf und Auslauf"
        " scheinen nicht abgeschnitten zu sein."
    ),
    "CW-C008": (
        "{ccw} Messpunkte ↺ und {cw} ↻: Der gemeinsame Kreis wird zu der Richtung mit mehr Punkten"
        " gezogen."
    ),
    "CW-C009": "{repeated} Messpunkte von {run} wiederholen einen Winkel; alle zählen.",
    "CW-C010": (
        "F auf einem Bogen zählt vom Aufbaumittelpunkt (3.5 a) und enthält dessen Versatz, hier"
        " etwa {offset}; F um den Ausgleichsmittelpunkt ist auch angegeben."
    ),
    "CW-C011": (
        "Der Kreis liegt {offset} vom Aufbaumittelpunkt entfernt. Die Winkel wurden als Sollwinkel"
        " genommen; wurden sie vom Aufbaumittelpunkt gemessen, weichen die Radien um bis zu"
        " {effect} ab. Besser zentrieren und neu messen."
    ),
    "CW-C012": (
        "Die Enden von {run} unterscheiden sich an derselben Stelle um {step}: Drift während des"
        " Laufs, ein verschobenes Messgerät oder Messwerte des Anlaufs unter den Messpunkten."
    ),
    "CW-C013": "{run} ist überall genau null: wahrscheinlich nicht gemessen.",
    "CW-T001": (
        "Die Norm verlangt 5 Anfahrten je Zielposition und Richtung; gefunden: {counts:and}."
    ),
    "CW-T001.count": "{count} in {direction}",
    "CW-T002.linear": (
        "{targets} Zielpositionen über {length:.10g} mm sind zu wenige: Nötig sind mindestens 5 je"
        " Meter und insgesamt 5, hier {needed}."
    ),
    "CW-T002.principal": (
        "ISO 230-2:1988, 4.3.4 verlangt drei Positionen zusätzlich zu 0°, 90°, 180°, 270°;"
        " vorhanden: {others}."
    ),
    "CW-T002.rotary": (
        "{targets} Zielpositionen über {length:.10g}° sind zu wenige: Dieser Verfahrweg braucht"
        " mindestens {needed} (Tabelle der Zielpositionen)."
    ),
    "CW-T003": (
        "Nur das Anfahren in {direction} wurde gemessen; Kennwerte beider Richtungen gibt es nicht."
    ),
    "CW-T004": "Hauptposition nicht unter den Zielpositionen: {positions}.",
    "CW-T005.repeated_long": (
        "Wiederholte Anfahrten über mehr als {limit}: Die Norm prüft die ganze Länge mit einer"
        " Anfahrt je Richtung und n = 5 über {limit} im üblichen Arbeitsbereich, als zwei"
        " Prüfungen. Ausgewertet wie gemessen."
    ),
    "CW-T005.repeated_missing": (
        "Die Achse ist länger als {limit}; zu dieser Prüfung mit einer Anfahrt je Richtung gehört"
        " eine Prüfung mit n = 5 über {limit}."
    ),
    "CW-T005.whole_missing": (
        "Die Achse ist länger als {limit}; zu ihr gehört auch eine Prüfung der ganzen Länge mit"
        " einer Anfahrt je Richtung."
    ),
    "CW-T006.linear": (
        "Der mittlere Abstand der Zielpositionen ist {interval:.5g} mm; über 2 000 mm darf er"
        " höchstens 250 mm sein."
    ),
    "CW-T006.per_turn": (
        "{targets} Zielpositionen über {turns:.4g} Umdrehungen: mindestens acht je Umdrehung sind"
        " nötig."
    ),
    "CW-T006.rotary": (
        "Der größte Abstand der Zielpositionen ist {interval:.5g}°; über 360° darf er höchstens 45°"
        " sein."
    ),
    "CW-T006.turns": (
        "{length:.10g}° wurden gemessen; die Norm verlangt höchstens 1 800° (fünf Umdrehungen)."
    ),
    "CW-T007.end": "{length} am {end:choose|lower=unteren|upper=oberen} Ende",
    "CW-T007.outside": (
        "Die Zielpositionen {first} bis {last} liegen außerhalb des Verfahrwegs {travel_start} bis"
        " {travel_end}: Versatz und Richtungssinn der Positionen prüfen."
    ),
    "CW-T007.uncovered": (
        "Ein Teil des Verfahrwegs wurde nicht gemessen: {ends:and}, mehr als ein Abstand der"
        " Zielpositionen."
    ),
    "CW-T008.equal": (
        "Die Zielpositionen liegen gleich weit auseinander ({interval}): Eine periodische"
        " Abweichung (Spindelsteigung, Maßstabsteilung), deren Periode im Abstand aufgeht, bleibt"
        " verborgen. Die Norm verlangt zufällige Versätze; {better}"
    ),
    "CW-T008.period": (
        "Die Zielpositionen treffen die Periode von {period} immer in denselben Phasen: Eine"
        " periodische Abweichung dieser Periode kann verborgen bleiben. Zielpositionen mit"
        " wechselnden Phasen wählen (Abschnitt über Zielpositionen); {better}"
    ),
    "CW-T009": (
        "Schrittzyklus: nicht für eine Abnahme, außer es ist schriftlich vereinbart (Anhang von ISO"
        " 230-2). Eine Drift D während der Prüfung bringt etwa 0,92 D in E und M und kaum etwas in"
        " R."
    ),
    "CW-T010": (
        "Messwerte fehlen: {where:join|; } haben weniger als die anderen; jede Zielposition wird"
        " mit ihrem eigenen n ausgewertet."
    ),
    "CW-T010.direction": "in {direction} {fewer} von {targets} Zielpositionen ({at}{more:if| ...})",
    "CW-T011.rows": (
        "Bis zu {targets} benachbarte Zielpositionen sind in Lauf {traverses}{more:if| und"
        " {more} weiteren} genau null, während die anderen Messwerte streuen: wahrscheinlich nicht"
        " gemessen und mit Nullen aufgefüllt. Sie gehören zum Ergebnis."
    ),
    "CW-T011.traverse": (
        "Lauf {run} in {direction} ist an allen {targets} Zielpositionen genau null:"
        " wahrscheinlich nicht gemessen. Er gehört zum Ergebnis; wo die anderen streuen, entstehen"
        " Tabelle und Vorhersage ohne ihn."
    ),
    "CW-T012": (
        "Die Messwerte driften: {how}; in Läufen ohne Drift hat eine solche Reihenfolge eine"
        " Wahrscheinlichkeit von {chance:.1f} %. Die Achse warmlaufen lassen und neu messen: Die"
        " Drift ist Teil von R und A."
    ),
    "CW-T012.ends": "{lower} und {upper} in {direction}",
    "CW-T012.growing": (
        "vom ersten zum letzten Lauf, am unteren und am oberen Ende des Verfahrwegs, {drifts:join|;"
        " } (sie wächst über den Verfahrweg, wie bei einer Ausdehnung)"
    ),
    "CW-T012.mean": "{drifts:and} vom ersten zum letzten Lauf (Mittel über die Zielpositionen)",
    "CW-T013.more": "{more} weitere Läufe sind Ausreißer, um weniger.",
    "CW-T013.run": (
        "Lauf {run} weicht um {off:and} von den anderen ab (robuste Standardabweichung ihrer"
        " Messwerte: {scatter}).{compared:if| {compared}}"
    ),
    "CW-T013.traverse": (
        "Lauf {run} in {direction} weicht um {off} von den anderen ab (robuste"
        " Standardabweichung ihrer Messwerte: {scatter}).{compared:if| {compared}}"
    ),
    "CW-T014.compared": (
        "Das Ergebnis mit {readings:plural|dem verdächtigen Messwert|den {readings} verdächtigen"
        " Messwerten} und ohne: {compared}"
    ),
    "CW-T014.listed": (
        "{readings:plural|Verdächtiger Messwert|Verdächtige Messwerte}: {where}{more:if| und {more}"
        " weitere}; robuste Standardabweichung eines Messwerts: {scatter}.{compared:if| {compared}}"
    ),
    "CW-T015": "Zielpositionen ohne Messwert sind weggelassen: {targets}.",
    "CW-T016": (
        "Weniger als zwei Messwerte je Richtung bei {targets}: dort gibt es keine"
        " Standardabweichung. Kenngrößen, die sie brauchen, werden nicht angegeben.{others:if|"
        " Über die anderen Zielpositionen: {others}.}"
    ),
    "CW-T020": (
        "Unsicherheit: U (k = 2) aus den Beiträgen von ISO 230-2:2006, Anhang A, soweit der Auftrag"
        " sie angibt; fortgepflanzt werden ihre Verteilungen (JCGM 101:2008), nicht die"
        " Koeffizienten des Anhangs.{misalignment:if| Ein schräger Strahl misst zu kurz, nie zu"
        " lang, über diese Zielpositionen um bis zu {misalignment:.2f} µm. U enthält dafür"
        " ±{counted:.2f} µm.}"
    ),
    "CW-T021": (
        "Für VDI/DGQ 3441 wird keine Unsicherheit angegeben: Anhang A von ISO 230-2 behandelt nur"
        " seine eigenen Kennwerte."
    ),
    "CW-T022": (
        "U_theta ist ohne thermal.alpha_m angegeben: Für die Maschine wurden {alpha_m} µm/(m K)"
        " (Stahl) angenommen."
    ),
    "CW-T023": (
        "U_alpha ist ohne thermal.T_m angegeben: Die Temperatur ist unbekannt, ihr Beitrag fehlt in"
        " U."
    ),
    "CW-T024": (
        "Auf 20 °C bezogen ({refer_to:choose|scale=Maßstab|workpiece=Werkstück}): {slope:+.3f} µm/m"
        " um {x_fix:.10g} mm entfernt, aus {alpha_m:g} µm/(m K) bei {T_m:g} °C für"
        " {refer_to:choose|scale=den Maßstab|workpiece=das Werkstück} und {alpha_d:g} µm/(m K) bei"
        " {T_d:g} °C für das Messgerät."
    ),
    "CW-T025": (
        "Die Temperatur änderte sich vom Beginn zum Ende der Prüfung: {changes:and}. Über die"
        " {length:.5g} mm der Zielpositionen sind das {drift:+.2f} µm vom ersten zum letzten Lauf."
        " Die Ausdehnung wurde mit dem Mittel aus Beginn und Ende entfernt, weil die Datei nicht"
        " sagt, wann jeder Messwert genommen wurde: Was davon abweicht, bleibt als Drift in den"
        " Messwerten."
    ),
    "CW-T025.change": (
        "die {of:choose|scale=des Maßstabs|workpiece=des Werkstücks|instrument=des Messgeräts} um"
        " {kelvin:+2sig} K"
    ),
    "CW-T026.whole": (
        "E_VE ist {E_VE}, die größte Spanne von {file} innerhalb ihrer ganzen {minutes:g} min. Die"
        " Aufzeichnung muss so lang sein wie eine Positionierprüfung: wo Ihre kürzer ist, deren"
        " Dauer als duration_min angeben."
    ),
    "CW-T026.within": (
        "E_VE ist {E_VE}, die größte Spanne von {file} innerhalb von {minutes:g} min."
    ),
    "CW-T027": (
        "Die Stillstandsprüfung {file} zeigt zu wenig von E_VE: {reasons:join|; }. Die Anzeige der"
        " ruhenden Achse mindestens zehnmal aufzeichnen, so lange wie eine Prüfung dauert."
    ),
    "CW-T027.coarse": (
        "zwischen zwei Messwerten liegen bis zu {minutes:g} min: Was kommt und geht, fehlt"
    ),
    "CW-T027.short": (
        "sie dauert {minutes:g} min, und {test:if|eine Positionierprüfung des Auftrags dauert"
        " {test:g} min|so kurz ist keine Positionierprüfung}: Die Drift einer Prüfung ist größer"
    ),
    "CW-T028": (
        "Die Luft veränderte das Licht: {least:+.3f}{most:if| bis {most:+.3f}|} µm/m ab {zero:.10g}"
        " mm, wo die Anzeige 0 ist, wurden entfernt ({equation:choose|ciddor=Ciddor|edlen=Edlén};"
        " Luft im Mittel {air_c:.4g} °C, {pressure_hpa:.6g} hPa, {humidity_percent:.3g} %). Die"
        " Anzeige des Messgeräts rechnet {assumed:if|vermutlich |}mit dem Brechungsindex"
        " {counted:.9f}{assumed:if|, Luft bei 20 °C, 1 013,25 hPa und 50 %: `instrument_air` unter"
        " `environment` angeben, wo sie mit einem anderen rechnet|}."
    ),
    "CW-T029": (
        "Vom ersten zum letzten Messwert änderte sich das Licht um {light:+.2f} µm und die"
        " Ausdehnung um {expansion:+.2f} µm, an der Zielposition mit der größten Änderung: beides"
        " wurde entfernt. Der Rest in den Messwerten änderte sich um {rest:+.2f}{std_error:if| ±"
        " {std_error:.2f}|} µm im Mittel über die Zielpositionen: Drift der Maschine selbst oder"
        " des Aufbaus."
    ),
    "CW-T030.certain": "Das kann nicht stimmen: {why}.",
    "CW-T030.small": (
        "Alle Messwerte liegen innerhalb von {spread}: So gut sind wenige Maschinen. Stimmt die"
        " Einheit?"
    ),
    "CW-T030.unit": (
        "Die Einheit ist wahrscheinlich {unit}, gelesen als {read_as} ({odds:odds} zu 1). Die"
        " Messwerte reichen über {spread} und streuen um {scatter}; Werkzeugmaschinen haben meist"
        " Werte, die {factor:g}-mal {larger:if|größer|kleiner} sind. Einen Messwert mit dem"
        " Messgerät vergleichen."
    ),
    "CW-T031.directions": "die Läufe in + und die in −",
    "CW-T031.near": (
        "Fast dieselben Messwerte: {runs:join|; }{more:if| und {more} weitere Paare}, während sich"
        " die Läufe dieser Prüfung um {noise} unterscheiden. Wurde ein Lauf kopiert und etwas"
        " geändert? Wiederholpräzision und Rauschen sind daraus nicht bekannt."
    ),
    "CW-T031.pair": "{one} und {other} ({difference})",
    "CW-T031.runs": "Läufe {runs} und {more:if|{more} weitere|{last}} in {direction}",
    "CW-T031.same": (
        "Dieselben Messwerte bis zur letzten Stelle: {runs:join|; }{more:if| und {more} weitere"
        " solche Gruppen}. Wurde ein Lauf kopiert, oder sind die Messwerte zu grob gerundet?"
        " Wiederholpräzision und Rauschen lassen sich daraus nicht bestimmen."
    ),
    "CW-T032": (
        "Die mittlere Umkehrspanne ist +{reversal}, während Umkehrspiel eine negative"
        " ergibt{likely:if|: {odds:odds} zu 1, dass|: vielleicht sind} die Richtungen + und −"
        " vertauscht {likely:if|sind |}oder das Vorzeichen der Abweichungen gedreht{likely:if|"
        " ist|}, außer die Losekompensation ist zu groß. Eine Tabelle aus vertauschten Richtungen"
        " verdoppelt das Umkehrspiel. An einer Zielposition prüfen: Bei Umkehrspiel ist die"
        " Abweichung beim Anfahren in + die kleinere."
    ),
    "CW-T033": (
        "Die Zielpositionen {first} bis {last} sind ganze Millimeter, wenn man sie als Zoll liest:"
        " Sind sie in Zoll?"
    ),
    "CW-T034": (
        "Dieselbe Messung wie {tests}{others:if| und andere}: Zweimal gegeben, beweist sie nichts"
        " Neues."
    ),
    "CW-T035": (
        "{targets} {targets:plural|Zielposition|Zielpositionen}, wo die Norm mindestens {fewest}"
        " verlangt: Über das, was dazwischen liegt, ist nichts bekannt. Kennwerte und Grenzwerte"
        " gelten nur für {targets:plural|diese Zielposition|diese Zielpositionen}."
    ),
    "CW-T036": (
        "Die Prüfungen {test} und {other} widersprechen sich: Sie unterscheiden sich um"
        " {difference:.2f} {unit}, {what:choose|error=der Fehler selbst|reversal=die mittlere"
        " Umkehrspanne selbst} ist {size:.2f} {unit}. Waren Vorzeichen, Richtungen, Einheit, Achse"
        " und Zustand dieselben? Es zählt nur {test}, {other} nicht."
    ),
    "CW-T037": (
        "Die Prüfungen der Achsen {one} und {other} zeigen denselben Fehler: {odds:odds} zu 1, dass"
        " eine Achse für beide gemessen oder eine Datei für die andere gegeben wurde. Eine Tabelle"
        " aus der Prüfung einer anderen Achse vergrößert deren Fehler. Welche Achse bewegte sich in"
        " jeder Prüfung?"
    ),
    "CW-T038": (
        "Die Aufzeichnung der Umgebung {file} hat während der Prüfung eine Lücke, {gap:2sig}-mal so"
        " lang wie sonst zwischen ihren Zeilen: dazwischen wurden die Werte auf einer Geraden"
        " angenommen."
    ),
    "CW-T039": (
        "Die Messwerte sagen nicht, wann sie genommen wurden: Verwendet wurde das Mittel der"
        " Aufzeichnung der Umgebung. Innerhalb der Aufzeichnung schwankt die Korrektur um"
        " {range:.2f} µm über {length:.5g} mm, und um so viel können die Messwerte falsch sein. Der"
        " Messdatei eine Spalte `time` geben, oder nur die Aufzeichnung aus der Zeit der Prüfung"
        " angeben."
    ),
    "reason.cannot_be_formed": "lässt sich aus diesen Messwerten nicht bilden",
    "reason.no_common_angle": "die beiden Richtungen haben keinen gemeinsamen Winkel",
    "reason.no_reading": "kein Messwert in Richtung {direction} bei {position}",
    "reason.not_calibrated": "die Länge des Messgeräts war nicht kalibriert (ISO 230-4:1996, 4.5)",
    "reason.not_measured": "in Richtung {direction} nicht gemessen",
    "reason.one_approach": "eine Anfahrt je Richtung ({clause})",
    "reason.one_reading": (
        "nur ein Messwert in Richtung {direction} bei {position}, dort also keine"
        " Standardabweichung"
    ),
    "reason.undefined_1988": (
        "in ISO 230-2:1988 nicht definiert (2 und 6: R, A und die mittlere Umkehrspanne)"
    ),
    "reason.undefined_1996": "in ISO 230-4:1996 nicht definiert (3.3 bis 3.5: H, G und F)",
    "reason.undefined_2005": (
        "in ISO 230-4:2005 nicht definiert; an ihrer Stelle steht die zweiseitige"
        " Kreisformabweichung"
    ),
}
