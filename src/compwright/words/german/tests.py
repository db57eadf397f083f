"""Sentences about positioning and circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-C001": (
        "Es wurden mehrere Läufe gemessen, aber jeder Kennwert gehört zu einem Lauf (Abschnitte"
        " 3.2 und 5). Angegeben sind die Kennwerte von {first:and}. Die anderen Läufe: {others}."
    ),
    "CW-C001.other": "{direction} Lauf {run}: G {G}",
    "CW-C001.run": "{direction} Lauf {run}",
    "CW-C002": (
        "Nur die Richtung {direction} wurde gemessen. Kennwerte beider Richtungen gibt es deshalb"
        " nicht, und Rechtwinkligkeit und Unterschied der Lageregelung lassen sich"
        " nicht trennen. Auch die andere Richtung messen."
    ),
    "CW-C003": (
        "Die Länge des Messgeräts war nicht kalibriert, deshalb wird die Radialabweichung F nicht"
        " angegeben. D und F um den Ausgleichsmittelpunkt verwenden die Nennlänge."
    ),
    "CW-C004": (
        "Die Messpunkte von {run} liegen {interval:3sig}° auseinander. Kurze Umkehrspitzen können"
        " zwischen zwei Messpunkten liegen, und dann fallen G, F und H zu klein aus. Mit höherer"
        " Messrate oder kleinerem Vorschub messen."
    ),
    "CW-C005.arc": "{run} überdeckt {covered:.5g}° eines Bogens von {arc:.5g}°.",
    "CW-C005.gap": (
        "Keine Messpunkte von {run} von {gaps}: Was die Bahn dort tut, wird nicht ausgewertet."
    ),
    "CW-C006.no_feed": (
        "Ein Vorschub von {feed:g} mm/min ist nicht möglich: den Vorschub in der Datei berichtigen."
    ),
    "CW-C006.time": (
        "Mit {feed:g} mm/min dauert ein Kreis von {radius:g} mm {seconds:3sig} s: die Einheit des"
        " Vorschubs prüfen."
    ),
    "CW-C007": (
        "{run} überdeckt {covered:.5g}°, mehr als den Bogen von {arc:.5g}°. Die Messpunkte"
        " scheinen Anlauf und Auslauf zu enthalten: die Einstellungen des Exports prüfen."
    ),
    "CW-C008.feed": (
        "Der Lauf ↺ hat {ccw} Messpunkte, der Lauf ↻ {cw}. Bei gleicher Abtastrate hatte eine"
        " Richtung {share:.0f} % des Vorschubs der anderen. Rechtwinkligkeit und"
        " Servofehlanpassung vermischen sich dann. Den Vorschub-Override prüfen und beide"
        " Richtungen mit gleichem Vorschub messen."
    ),
    "CW-C008.few": (
        "Der Lauf ↺ hat {ccw} Messpunkte, der Lauf ↻ {cw}. Der gemeinsame Kreis liegt deshalb"
        " näher an der Richtung mit mehr Messpunkten."
    ),
    "CW-C009": (
        "{repeated} Messpunkte von {run} haben denselben Winkel wie ein anderer. Alle Messpunkte"
        " werden verwendet."
    ),
    "CW-C010": (
        "Auf einem Bogen zählt F vom Aufbaumittelpunkt (Abschnitt 3.5 a). Es enthält deshalb den"
        " Versatz dieses Mittelpunkts, hier etwa {offset}. F um den Ausgleichsmittelpunkt ist"
        " auch angegeben."
    ),
    "CW-C011": (
        "Der Kreis liegt {offset} vom Aufbaumittelpunkt entfernt. Die Winkel wurden als Sollwinkel"
        " genommen; wurden sie vom Aufbaumittelpunkt gemessen, weichen die Radien um bis zu"
        " {effect} ab. Besser zentrieren und neu messen."
    ),
    "CW-C012": (
        "Der Radius änderte sich vom Anfang bis zum Ende von {run} um {step}. Entweder driftete die"
        " Maschine während des Laufs, oder das Messgerät bewegte sich, oder Messwerte des Anlaufs"
        " sind unter den Messpunkten. Den Lauf wiederholen."
    ),
    "CW-C013": (
        "Jeder Messpunkt von {run} ist genau null. Der Lauf wurde wahrscheinlich nicht gemessen:"
        " neu messen."
    ),
    "CW-C014.mirrored": (
        "Die Abweichungen passen besser zu den Ursachen der ISO 230-4, wenn die Winkel der Läufe"
        " in cw gespiegelt werden: Es bleiben {left} rms statt {given}. Die Winkel beider"
        " Richtungen müssen von der ersten zur zweiten Achse zunehmen. Wurden die von cw in"
        " Fahrtrichtung gezählt, jeden durch {turn:g}° minus den Winkel ersetzen."
    ),
    "CW-C014.turned": (
        "Die Abweichungen passen besser zu den Ursachen der ISO 230-4, wenn die Winkel der Läufe"
        " in cw gedreht werden: Es bleiben {left} rms statt {given}. Die Winkel beider Richtungen"
        " müssen an der ersten Achse beginnen. Beginnen die von cw an einer anderen Achse, zu jedem"
        " {turn:g}° addieren."
    ),
    "CW-C015": (
        "{first} und {second} haben genau die gleichen Messwerte. Einer ist wahrscheinlich eine"
        " Kopie des anderen: neu messen."
    ),
    "CW-C016.coarse": (
        "Die Messwerte von {run} haben Stufen von {step}. Sie verbergen Fehler dieser Größe, und"
        " die Standardfehler der Ursachen gelten nicht. Mit einer Auflösung von 0,1 µm messen oder"
        " mehr Stellen exportieren."
    ),
    "CW-C016.single": (
        "{count:plural|Ein Messwert|{count} Messwerte} von {run}"
        " {count:plural|liegt|liegen} weit neben den benachbarten, der größte um {off} bei"
        " {angle:.5g}°. Ein Stoß oder Schmutz kann die Ursache sein. Den Lauf neu messen."
    ),
    "CW-C016.still": (
        "Der Messwert von {run} ändert sich bei {parts:and} nicht, obwohl die Bahn dort es tut."
        " Das Messgerät war am Ende seines Messbereichs oder blieb stehen. Es näher an die Mitte"
        " setzen und neu messen."
    ),
    "CW-T001": (
        "Die Norm verlangt 5 Anfahrten je Zielposition und Richtung; gefunden: {counts:and}."
    ),
    "CW-T001.count": "{count} in {direction}",
    "CW-T002.linear": (
        "{targets} Zielpositionen über {length:.10g} mm sind zu wenige. Die Norm verlangt"
        " mindestens 5 je Meter und insgesamt mindestens 5: hier {needed}."
    ),
    "CW-T002.principal": (
        "ISO 230-2:1988, 4.3.4 verlangt drei Positionen zusätzlich zu 0°, 90°, 180°, 270°;"
        " vorhanden: {others}."
    ),
    "CW-T002.rotary": (
        "{targets} Zielpositionen über {length:.10g}° sind zu wenige. Für diesen Verfahrweg"
        " verlangt die Norm mindestens {needed} (Tabelle der Zielpositionen)."
    ),
    "CW-T003": (
        "Nur Anfahrten in Richtung {direction} wurden gemessen, deshalb gibt es keine Kennwerte"
        " beider Richtungen. Das Umkehrspiel ist unbekannt."
    ),
    "CW-T004": (
        "Die Norm verlangt auch diese Hauptpositionen, sie sind aber nicht unter den"
        " Zielpositionen: {positions}."
    ),
    "CW-T005.repeated_long": (
        "Diese Prüfung wiederholt ihre Anfahrten über mehr als {limit}. Die Norm verlangt hier zwei"
        " Prüfungen: eine der ganzen Länge mit einer Anfahrt je Richtung und eine mit fünf"
        " Anfahrten je Richtung über {limit} des üblichen Arbeitsbereichs. Die Prüfung wurde"
        " ausgewertet, wie sie gemessen ist."
    ),
    "CW-T005.repeated_missing": (
        "Die Achse ist länger als {limit}, und diese Prüfung hat eine Anfahrt je Richtung. Die Norm"
        " verlangt zusätzlich eine Prüfung mit fünf Anfahrten je Richtung über {limit} des üblichen"
        " Arbeitsbereichs."
    ),
    "CW-T005.whole_missing": (
        "Die Achse ist länger als {limit}. Die Norm verlangt zusätzlich eine Prüfung ihrer ganzen"
        " Länge mit einer Anfahrt je Richtung."
    ),
    "CW-T006.linear": (
        "Der mittlere Abstand der Zielpositionen ist {interval:.5g} mm. Bei einer Achse über 2"
        " 000 mm erlaubt die Norm höchstens 250 mm."
    ),
    "CW-T006.per_turn": (
        "{targets} Zielpositionen über {turns:.4g} Umdrehungen: mindestens acht je Umdrehung sind"
        " nötig."
    ),
    "CW-T006.rotary": (
        "Der größte Abstand der Zielpositionen ist {interval:.5g}°. Bei einer Achse über 360°"
        " erlaubt die Norm höchstens 45°."
    ),
    "CW-T006.turns": (
        "{length:.10g}° wurden gemessen; die Norm verlangt höchstens 1 800° (fünf Umdrehungen)."
    ),
    "CW-T007.end": "{length} am {end:choose|lower=unteren|upper=oberen} Ende",
    "CW-T007.outside": (
        "Die Zielpositionen {first} bis {last} liegen außerhalb des Verfahrwegs {travel_start}"
        " bis {travel_end} des Auftrags. Versatz und Richtung der Zielpositionen prüfen."
    ),
    "CW-T007.uncovered": (
        "Ein Teil des Verfahrwegs wurde nicht gemessen: {ends:and}. Das ist mehr als ein Abstand"
        " der Zielpositionen."
    ),
    "CW-T008.equal": (
        "Die Zielpositionen liegen gleich weit auseinander ({interval}). Eine periodische"
        " Abweichung (Spindelsteigung, Maßstabsteilung) bleibt verborgen, wenn ihre Periode in"
        " diesem Abstand aufgeht. Die Norm verlangt zufällige Versätze; {better}"
    ),
    "CW-T008.period": (
        "Alle Zielpositionen liegen in denselben Phasen der Periode von {period}. Eine"
        " periodische Abweichung dieser Periode kann verborgen bleiben. Zielpositionen mit"
        " verschiedenen Phasen wählen (Abschnitt über Zielpositionen); {better}"
    ),
    "CW-T009": (
        "Die Prüfung verwendet einen Schrittzyklus, den die Norm für eine Abnahme nur erlaubt, wenn"
        " er schriftlich vereinbart ist (Anhang von ISO 230-2). Driftet die Achse während einer"
        " solchen Prüfung um D, werden E und M um etwa 0,92 D größer, und R ändert sich kaum."
    ),
    "CW-T010": (
        "Messwerte fehlen: {where:join|; }. Jede Zielposition wird mit den Messwerten ausgewertet,"
        " die sie hat."
    ),
    "CW-T010.direction": (
        "in Richtung {direction} {fewer:plural|hat|haben} {fewer} von {targets} Zielpositionen"
        " weniger Messwerte als die anderen ({at}{more:if| ...})"
    ),
    "CW-T011.rows": (
        "In Lauf {traverses}{more:if| und {more} weiteren} sind bis zu {targets} benachbarte"
        " Zielpositionen genau null, während die anderen Messwerte streuen. Wahrscheinlich wurden"
        " sie nicht gemessen und mit Nullen aufgefüllt. Sie gehören zum Ergebnis: Wurden sie"
        " nicht gemessen, aus der Datei entfernen."
    ),
    "CW-T011.traverse": (
        "Lauf {run} in Richtung {direction} ist an allen {targets} Zielpositionen genau null,"
        " wurde also wahrscheinlich nicht gemessen. Das Ergebnis enthält ihn. Streuen die anderen"
        " Läufe, entstehen Tabelle und Vorhersage ohne ihn."
    ),
    "CW-T012": (
        "Die Messwerte driften: {how}. Ohne Drift würde der Zufall allein die Messwerte in"
        " {chance:.1f} % aller Prüfungen so ordnen. Die Achse warmlaufen lassen und neu messen,"
        " denn die Drift vergrößert R und A."
    ),
    "CW-T012.ends": (
        "in Richtung {direction} um {lower} am unteren und um {upper} am oberen Ende des"
        " Verfahrwegs"
    ),
    "CW-T012.growing": (
        "{drifts:join|; } vom ersten zum letzten Lauf (die Drift wächst entlang des Verfahrwegs"
        " wie bei Wärmeausdehnung)"
    ),
    "CW-T012.mean": "{drifts:and} vom ersten zum letzten Lauf (Mittel über die Zielpositionen)",
    "CW-T013.more": (
        "{more:plural|Ein weiterer Lauf ist ein Ausreißer|{more} weitere Läufe sind Ausreißer},"
        " um einen kleineren Betrag."
    ),
    "CW-T013.run": (
        "Lauf {run} weicht um {off:and} von den anderen Läufen ab. Deren Messwerte streuen um"
        " {scatter} (robuste Standardabweichung).{compared:if| {compared}}"
    ),
    "CW-T013.traverse": (
        "Lauf {run} in Richtung {direction} weicht um {off} von den anderen Läufen ab. Deren"
        " Messwerte streuen um {scatter} (robuste Standardabweichung).{compared:if| {compared}}"
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
        "Bei {targets} gibt es weniger als zwei Messwerte je Richtung, also keine"
        " Standardabweichung. Kennwerte, die sie brauchen, werden nicht angegeben.{others:if| Für"
        " die anderen Zielpositionen allein: {others}.}"
    ),
    "CW-T020": (
        "Die Unsicherheit U (k = 2) ist aus den Beiträgen von ISO 230-2:2006, Anhang A,"
        " berechnet, die der Auftrag angibt. Ihre Verteilungen werden fortgepflanzt (JCGM"
        " 101:2008); die Koeffizienten des Anhangs werden nicht verwendet.{misalignment:if| Ein"
        " schräger Laserstrahl misst zu kurz, nie zu lang: über diese Zielpositionen um bis zu"
        " {misalignment:.2f} µm. U enthält dafür ±{counted:.2f} µm.}"
    ),
    "CW-T021": (
        "Für VDI/DGQ 3441 wird keine Unsicherheit angegeben, denn Anhang A von ISO 230-2"
        " behandelt nur die Kennwerte von ISO 230-2."
    ),
    "CW-T022": (
        "Der Auftrag gibt U_theta an, aber nicht thermal.alpha_m, den Ausdehnungskoeffizienten"
        " der Maschine. Angenommen wurde der Wert von Stahl: {alpha_m:g} µm/(m K)."
    ),
    "CW-T023": (
        "Der Auftrag gibt U_alpha an, aber nicht thermal.T_m, die Temperatur der Maschine. Der"
        " Beitrag von U_alpha fehlt deshalb in U. thermal.T_m angeben."
    ),
    "CW-T024": (
        "Die Messwerte wurden auf 20 °C {refer_to:choose|scale=des Maßstabs|workpiece=des"
        " Werkstücks} umgerechnet: {slope:+.3f} µm/m wurden entfernt, mit dem Fixpunkt bei"
        " {x_fix:.10g} mm. Grundlage: {alpha_m:g} µm/(m K) bei {T_m:g} °C für"
        " {refer_to:choose|scale=den Maßstab|workpiece=das Werkstück}, {alpha_d:g} µm/(m K) bei"
        " {T_d:g} °C für das Messgerät."
    ),
    "CW-T025": (
        "Die Temperatur änderte sich vom Beginn zum Ende der Prüfung: {changes:and}. Über die"
        " {length:.5g} mm der Zielpositionen sind das {drift:+.2f} µm vom ersten zum letzten"
        " Lauf. Die Datei nennt die Zeit der Messwerte nicht, deshalb wurde die Ausdehnung bei"
        " der mittleren Temperatur von Beginn und Ende entfernt. Die übrige Ausdehnung ist als"
        " Drift in den Messwerten."
    ),
    "CW-T025.change": (
        "die {of:choose|scale=des Maßstabs|workpiece=des Werkstücks|instrument=des Messgeräts} um"
        " {kelvin:+2sig} K"
    ),
    "CW-T026.whole": (
        "Die Umgebungsschwankung E_VE ist {E_VE}: die Spanne der Messwerte in {file} über die ganze"
        " Aufzeichnung von {minutes:g} min. E_VE soll nur die Dauer einer Positionierprüfung"
        " abdecken. Ist Ihre Prüfung kürzer, deren Dauer im Auftrag angeben: `E_VE: {{file: {file},"
        " duration_min: ..}}`."
    ),
    "CW-T026.within": (
        "Die Umgebungsschwankung E_VE ist {E_VE}: die größte Spanne der Messwerte in {file}"
        " innerhalb von {minutes:g} min."
    ),
    "CW-T027": (
        "Die Stillstandsprüfung {file} kann die Umgebungsschwankung E_VE nicht ganz zeigen:"
        " {reasons:join|; }. Den Messwert der stehenden Achse mindestens zehnmal aufzeichnen, so"
        " lange wie eine Positionierprüfung dauert."
    ),
    "CW-T027.coarse": (
        "zwischen zwei Messwerten liegen bis zu {minutes:g} min, Änderungen dazwischen werden"
        " also verpasst"
    ),
    "CW-T027.short": (
        "sie dauert {minutes:g} min, eine Positionierprüfung {test:if|des Auftrags aber {test:g}"
        " min|aber länger}, deshalb ist die Drift einer Prüfung größer"
    ),
    "CW-T028": (
        "Der Einfluss der Luft auf die Laserwellenlänge wurde entfernt: {least:+.3f}{most:if| bis"
        " {most:+.3f}|} µm/m, gezählt ab {zero:.10g} mm, wo die Anzeige 0 ist"
        " ({equation:choose|ciddor=Ciddor|edlen=Edlén}; Luft im Mittel {air_c:.4g} °C,"
        " {pressure_hpa:.6g} hPa, {humidity_percent:.3g} % Feuchte). Die Anzeige des Messgeräts"
        " rechnet {assumed:if|vermutlich |}mit dem Brechungsindex {counted:.9f}{assumed:if| (Luft"
        " bei 20 °C, 1 013,25 hPa, 50 % Feuchte). Rechnet sie mit einem anderen, `instrument_air`"
        " unter `environment` angeben|}."
    ),
    "CW-T029": (
        "An der Zielposition mit der größten Änderung änderte die Luft die Messwerte vom ersten"
        " zum letzten um {light:+.2f} µm (Laserwellenlänge){expansion:if| und die Wärmeausdehnung"
        " um {expansion:+.2f} µm}. {expansion:if|Beides|Das} wurde entfernt. Das Mittel über die"
        " Zielpositionen änderte sich noch um {rest:+.2f}{std_error:if| ± {std_error:.2f}|} µm:"
        " {unused:if|die Dehnung des Maßstabs, die nicht entfernt wird, weil der Auftrag kein"
        " `thermal` hat, oder eine Drift von Maschine oder Aufbau. Um die Spalte material_c zu"
        " verwenden, `thermal` mit `alpha_m` ergänzen|Maschine oder Aufbau drifteten}."
    ),
    "CW-T030.certain": "Die Messwerte können nicht stimmen: {why}. Ihre Einheit prüfen.",
    "CW-T030.small": (
        "Alle Messwerte liegen innerhalb von {spread}. Wenige Maschinen sind so genau: die"
        " Einheit der Messwerte prüfen."
    ),
    "CW-T030.unit": (
        "Die Messwerte wurden als {read_as} gelesen, aber ihre Einheit ist wahrscheinlich {unit}"
        " ({odds:odds} zu 1). Sie erstrecken sich über {spread} und streuen um {scatter};"
        " Werkzeugmaschinen haben meist {factor:g}-mal {larger:if|größere|kleinere} Werte. Einen"
        " Messwert mit dem Messgerät vergleichen."
    ),
    "CW-T031.directions": "die Läufe in + und die in −",
    "CW-T031.near": (
        "Diese Läufe haben fast dieselben Messwerte: {runs:join|; }{more:if| und {more} weitere"
        " Paare}. Andere Läufe dieser Prüfung unterscheiden sich um {noise}. Vielleicht wurde ein"
        " Lauf kopiert und etwas verändert; dann sind Wiederholpräzision und Rauschen unbekannt."
        " Neu messen."
    ),
    "CW-T031.pair": "{one} und {other} ({difference})",
    "CW-T031.runs": "Läufe {runs} und {more:if|{more} weitere|{last}} in {direction}",
    "CW-T031.same": (
        "Diese Läufe haben bis zur letzten Stelle dieselben Messwerte: {runs:join|; }{more:if|"
        " und {more} weitere solche Gruppen}. Entweder wurde ein Lauf kopiert, oder die Messwerte"
        " sind zu grob gerundet. Wiederholpräzision und Rauschen lassen sich daraus nicht"
        " bestimmen. Neu messen oder mit mehr Stellen exportieren."
    ),
    "CW-T032": (
        "Die mittlere Umkehrspanne ist +{reversal}, aber Umkehrspiel macht sie negativ."
        " {likely:if|Mit {odds:odds} zu 1|Vielleicht} sind die Richtungen + und − vertauscht oder"
        " das Vorzeichen der Abweichungen gedreht, außer die Losekompensation ist zu groß. Eine"
        " Tabelle aus vertauschten Richtungen verdoppelt das Umkehrspiel. An einer Zielposition"
        " prüfen: Bei Umkehrspiel ist die Abweichung beim Anfahren in + die kleinere."
    ),
    "CW-T033": (
        "Als Zoll gelesen sind die Zielpositionen {first} bis {last} ganze Millimeter. Prüfen, ob"
        " die Datei sie in Zoll angibt."
    ),
    "CW-T034": (
        "Das ist dieselbe Messung wie {tests}{others:if| und andere}. Eine zweimal gegebene"
        " Messung beweist nicht mehr: einmal angeben."
    ),
    "CW-T035": (
        "Die Prüfung hat {targets} {targets:plural|Zielposition|Zielpositionen}, aber die Norm"
        " verlangt mindestens {fewest}. Der Fehler zwischen den Zielpositionen ist unbekannt."
        " Kennwerte und Grenzwerte gelten nur für {targets:plural|diese Zielposition|diese"
        " Zielpositionen}."
    ),
    "CW-T036": (
        "Die Prüfungen {test} und {other} widersprechen sich. Sie unterscheiden sich um"
        " {difference:.2f} {unit}, und {what:choose|error=der Fehler selbst|reversal=die mittlere"
        " Umkehrspanne selbst} ist {size:.2f} {unit}. Verwendet wird nur {test}, {other} nicht."
        " Prüfen, ob Vorzeichen, Richtungen, Einheit, Achse und Inhalt der Steuerung bei beiden"
        " gleich sind."
    ),
    "CW-T037": (
        "Die Prüfungen der Achsen {one} und {other} zeigen denselben Fehler. Mit {odds:odds} zu 1"
        " wurde für beide dieselbe Achse gemessen oder eine Datei für beide gegeben. Eine Tabelle"
        " aus der Prüfung einer anderen Achse vergrößert den Fehler. Prüfen, welche Achse sich in"
        " jeder Prüfung bewegte."
    ),
    "CW-T038": (
        "Die Aufzeichnung der Umgebung {file} hat während der Prüfung eine Lücke, {gap:2sig}-mal"
        " so lang wie der übliche Abstand ihrer Zeilen. In der Lücke wurden die Werte auf einer"
        " Geraden interpoliert."
    ),
    "CW-T039": (
        "Die Messwerte haben keine Zeit, deshalb wurde das Mittel der Aufzeichnung der Umgebung"
        " verwendet. Innerhalb der Aufzeichnung schwankt die Korrektur um {range:.2f} µm über"
        " {length:.5g} mm, und um so viel können die Messwerte falsch sein. Der Messdatei eine"
        " Spalte `time` geben oder nur den Teil der Aufzeichnung angeben, der zur Prüfung gehört."
    ),
    "CW-T040": (
        "Das Umkehrspiel in {file} ist keine Konstante: Es geht von {first} bei {first_move} bis"
        " {last} bei {last_move}. Ein einziger Wert der Losekompensation, am besten {constant},"
        " lässt bis zu ±{left} übrig. Den Wert bei"
        " {over:choose|distance=dem Weg|speed=der Geschwindigkeit} der Bearbeitung nehmen und nach"
        " Verwindung und Reibung suchen."
    ),
    "CW-T041": (
        "Das Umkehrspiel in {file} hängt nicht erkennbar {over:choose|distance=vom Weg|speed=von"
        " der Geschwindigkeit} ab: Ein fester Wert, {constant}, lässt bis zu ±{left} übrig.{few:if|"
        " So wenige Messwerte können eine Abhängigkeit nicht zeigen: bei acht oder mehr Werten"
        " messen oder jeden wiederholen.|}"
    ),
    "reason.cannot_be_formed": "lässt sich aus diesen Messwerten nicht berechnen",
    "reason.no_common_angle": "die beiden Richtungen haben keinen gemeinsamen Winkel",
    "reason.no_reading": "kein Messwert in Richtung {direction} bei {position}",
    "reason.not_calibrated": "die Länge des Messgeräts war nicht kalibriert (ISO 230-4:1996, 4.5)",
    "reason.not_measured": "die Prüfung wurde in Richtung {direction} nicht gemessen",
    "reason.one_approach": "die Prüfung hat nur eine Anfahrt je Richtung ({clause})",
    "reason.one_reading": (
        "nur ein Messwert in Richtung {direction} bei {position}, dort also keine"
        " Standardabweichung"
    ),
    "reason.undefined_1988": (
        "ISO 230-2:1988 definiert diese Kenngröße nicht, nur R, A und die mittlere Umkehrspanne (2"
        " und 6)"
    ),
    "reason.undefined_1996": (
        "ISO 230-4:1996 definiert diese Kenngröße nicht, nur H, G und F (3.3 bis 3.5)"
    ),
    "reason.undefined_2005": (
        "ISO 230-4:2005 definiert diese Kenngröße nicht; an ihrer Stelle steht die zweiseitige"
        " Kreisformabweichung"
    ),
}
