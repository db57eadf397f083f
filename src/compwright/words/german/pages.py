"""German sentences on the report pages of `run`, of `verify` and of circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "circle.about": "{centre:choose|set_up= (Aufbaumittelpunkt)|own= (eigener Mittelpunkt)}",
    "circle.agreement": (
        "{how:choose|agrees=stimmt überein|differs=weicht ab|not_valid=nicht gültig|uncertain=zu"
        " unsicher für einen Vergleich|definition=andere Definition{pitch:if| (vorwärts /"
        " rückwärts, bei einer Steigung von {pitch:g} mm)|}}"
    ),
    "circle.cause": "{cause}  {value} {unit}",
    "circle.cause_share": "{cause} ({share:.0f} % aller Wirkungen)",
    "circle.centre": (
        "{name:choose|common=gemeinsamer Mittelpunkt der"
        " Ausgleichskreise|set-up=Aufbaumittelpunkt|ccw=Mittelpunkt des Ausgleichskreises"
        " ↺|cw=Mittelpunkt des Ausgleichskreises ↻}: {first} {x}, {second} {y} µm{H:if|; H {H} µm|}"
    ),
    "circle.compared": "Vergleich",
    "circle.comparison": (
        "Vergleich mit der Software des Messgeräts, deren Modell nicht veröffentlicht ist. „Stimmt"
        " überein“: Die Werte unterscheiden sich um höchstens zwei Standardfehler unseres Werts."
        " „Weicht ab“: um mehr. Dann ist auch unser Wert ohne Umkehrspitzen angegeben, aus einer"
        " einfachen Regression derselben Messwerte (Harmonische und Stufen). „Nicht gültig“, Wert"
        " in Klammern: Diese Software selbst meldet ihren Wert als nicht gültig. „Zu unsicher für"
        " einen Vergleich“: Unser Standardfehler ist größer als beide Werte."
        " „Andere Definition“: Die der Software ist nicht veröffentlicht; unsere steht in"
        " docs/evaluation.md."
    ),
    "circle.detail": "– {part}",
    "circle.difference": (
        "weicht ab. Ohne Umkehrspitzen ist unser Wert {plain} {unit}{spikes:if|: Die Spitzen"
        " machen {share:.0f} % der Abweichung aus|: Die Spitzen sind nicht der Grund}"
    ),
    "circle.effect": "Wirkung auf den Radius",
    "circle.effects": "Wirkung, Spitze zu Spitze, in µm; Striche: 95 %",
    "circle.fit": "Ausgleich: was alle Ursachen zusammen ergeben",
    "circle.job": (
        "Diese Zeilen in einen Auftrag aufnehmen: Sie korrigieren mit Tabellen und Losekompensation"
        " die Ursachen, die sich so korrigieren lassen. Den Auftrag mit `compwright new --from"
        " FILE... --format ID --out job.yaml` aus den Dateien der Steuerung anlegen, für jede Achse"
        " eine Positionierprüfung nennen (ihre Steigung korrigiert den Maßstab), die Zeilen"
        " ergänzen{file:if| und für FILE die Datei jeder Richtung einsetzen|}. In `centre` die"
        " Maschinenkoordinaten des Mittelpunkts in mm statt der Achsen einsetzen. Dann `compwright"
        " run job.yaml`."
    ),
    "circle.least_squares": "Ausgleichskreis, {base} µm vom Sollradius",
    "circle.magnified": "{setting}\nVergrößerung {magnification} : 1, Kreise in µm",
    "circle.next": "Was jetzt zu tun ist",
    "circle.no_table": (
        "Keine Tabelle korrigiert diese Ursachen. Die Prüfung nach den Arbeiten wiederholen."
    ),
    "circle.nominal": "Sollbahn",
    "circle.open_causes": (
        "Kein Schritt wird vorgeschlagen für {causes}, denn der Standardfehler ist größer als der"
        " halbe Wert. Den Kreis wiederholen, möglichst mit kleinerem Vorschub; eine Ursache, die"
        " wiederkehrt, ist wirklich."
    ),
    "circle.parameter": (
        "{name:choose|G=Kreisformabweichung, kleinste Ringzone|G_lsc=Kreisformabweichung nach"
        " dem Ausgleichskreis|F_max=Radialabweichung, größte|F_min=Radialabweichung,"
        " kleinste|F_max_lsc=Radialabweichung, größte, um den"
        " Ausgleichsmittelpunkt|F_min_lsc=Radialabweichung, kleinste, um den"
        " Ausgleichsmittelpunkt|H=Kreisumkehrspanne|D=Mittlere Radialabweichung}"
    ),
    "circle.pictures": (
        "So sehen diese Ursachen allein aus, stark übertrieben: gegen den Uhrzeigersinn"
        " dick, im Uhrzeigersinn dünn."
    ),
    "circle.ranked": "Ursachen, die größte Wirkung zuerst",
    "circle.run": "{sense}: G {G}, F{centre} {highest} / {lowest} µm",
    "circle.scales": "{scales:and}. {step}",
    "circle.sense": "{sense:choose|ccw=↺|cw=↻|both=beide}",
    "circle.setting": (
        "R {radius} mm{feed:if|, {feed:.5g} mm/min|}{extent:if|, Bogen {extent:.4g}° ab"
        " {start:.4g}°|}"
    ),
    "circle.share": "Anteil",
    "circle.shares": (
        "Ursachen, Anteil an allen Wirkungen\n"
        "(blass: unter dem doppelten Standardfehler,\n"
        "auch an jedem Ende)"
    ),
    "circle.software": "Software des Messgeräts",
    "circle.start": "Beginn {sense}",
    "circle.step": (
        "{kind:choose|squareness=Mechanik: Ausrichtung und Fluchtung der Führungen prüfen. Tabelle:"
        " Ein Auftrag mit `apply` korrigiert sie, wo die Steuerung es"
        " kann, wenn der Standardfehler unter einem Viertel des Werts und 15 µm/m liegt."
        "|scale_mismatch=Temperatur beider Achsen prüfen. Tabelle: {first} und {second} mit"
        " dem Laser messen und einen Auftrag mit beiden Prüfungen rechnen.|servo_mismatch=Regelung:"
        " {first} und {second} dieselbe Kreisverstärkung der Lageregelung (Kv) und Vorsteuerung"
        " geben.|radius_change=Messung: beide Richtungen mit demselben Vorschub wiederholen; den"
        " Sitz des Messgeräts prüfen.|backlash=Mechanik: Mutter, Stützlager und Kupplung der"
        " Spindel {axis} prüfen. Dann die Losekompensation der Steuerung für {axis}"
        " korrigieren.|overcompensation=Zuerst das Vorzeichen der Datei prüfen. Stimmt es,"
        " die Losekompensation der Steuerung für {axis} verkleinern."
        "|lateral_play=Mechanik: Vorspannung und Leisten der Führung {axis}"
        " prüfen.|reversal_spike=Regelung: Reibungskompensation von {axis} bei der Umkehr"
        " einstellen. Mechanik: Schmierung und Abstreifer prüfen.|cyclic=Mechanik: Spindel, ihre"
        " Lagerung und den Sitz des Gebers von {axis} prüfen. Tabelle: Mindestens drei Punkte je"
        " Periode korrigieren, was bleibt.|straightness=Mechanik: Ausrichtung der Führung {axis}"
        " prüfen. Tabelle: Eine Tabelle zwischen den Achsen korrigiert sie, wo die Steuerung eine"
        " hat (cross).|offset_change=Messung: Mittelpunkthalter und Magnetpfannen prüfen; dann"
        " wiederholen.|spiral=Messung: Maschine und Messgerät auf eine gleichbleibende Temperatur"
        " kommen lassen; dann wiederholen.|vibration=Quelle nach ihrer Frequenz{frequency:if|"
        " ({frequency:3sig} Hz)|}{axis:if| an Achse {axis}|} suchen: Pumpe,"
        " Lüfter, Motor. Regelung: Verstärkung probeweise senken.|stick_slip=Mechanik: Schmierung,"
        " Abstreifer und Vorspannung der Führung {axis} prüfen.|master_slave=Regelung:"
        " Interpolationsparameter von {first} und {second} prüfen.}"
    ),
    "circle.sums": "Werte, die mehrere Ursachen zusammenfassen",
    "circle.symbol": (
        "{letter}{sense:if| {sense:choose|ccw=↺|cw=↻|bidirectional=beide}|}{centre:if|,"
        " {centre:choose|G=Ausgleichskreis|F=Ausgleichsmittelpunkt}|}"
    ),
    "circle.to_do": "{cause} ({share:.0f} % aller Wirkungen). {step}",
    "circle.unexplained": "Die Ursachen unten lassen {rms} µm (Effektivwert) unerklärt.",
    "circle.value_error": "Wert ± Standardfehler",
    "circle.zone": (
        "kleinste Ringzone{sense:choose|both= beider|ccw=, ↺|cw=, ↻}: G {G} µm{D:if|; D {D} µm|}"
    ),
    "given.approaches": "{counts}; {cycle:choose|standard=Standardzyklus|step=Schrittzyklus}",
    "given.arc": "von {start}° bis {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=zu Beginn der Prüfung|_end=am Ende der Prüfung}",
    "given.axis": "{axis}, {kind:choose|linear=Linearachse|rotary=Drehachse}",
    "given.budget": "siehe Budget der Messunsicherheit",
    "given.by_job": "{text} (Auftrag)",
    "given.centre": "Mittelpunkt {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.compensation": (
        "{how:choose|off=aus; in der Steuerung:|active=ein, wie aktiv in|stored=ein, wie"
        " gespeichert in} {files} (Auftrag, states.{state})"
    ),
    "given.compensation_loaded": (
        "ein: Die Tabellen dieses Auftrags wurden geladen; was die Prüfung davon zeigt: siehe Laden"
    ),
    "given.compensation_none": "aus: In der Steuerung war nichts aktiv (Auftrag, states.{state})",
    "given.estimator": (
        "s: {spread:choose|std=Standardabweichung, n − 1|range=aus der Spannweite der Messwerte};"
        " Grenzen bei ± {coverage} s; keine Glättung"
    ),
    "given.expansion": (
        "von compwright angewendet: Messwerte auf 20 °C umgerechnet,"
        " {what:choose|scale=Maßstab|workpiece=Werkstück} {alpha_m} µm/(m K) bei {T_m} °C,"
        " Messgerät {alpha_d} µm/(m K) bei {T_d} °C, Festpunkt {x_fix} mm"
    ),
    "given.list": "{others:if|{others} und |}{last:if|{last}|keine}",
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.programmed_feed": "mm/min programmiert",
    "given.radius": "Radius {radius} mm",
    "given.samples": "{counts} Messpunkte",
    "given.sense": "{sense:choose|ccw=Gegenuhrzeigersinn|cw=Uhrzeigersinn}",
    "given.sentences": "{sentences:join| }",
    "given.smoothing": "compwright glättet nicht: Jeder Messpunkt zählt",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count} von {first} bis {last} {unit}; Liste in Anhang A",
    "given.travel": "{low:g} bis {high:g} {unit}",
    "limits.all": "alle zusammen",
    "limits.cause": (
        "{cause:choose|noise=Messwerte streuen: Dieselbe Position kommt nicht gleich wieder"
        " (Wiederholpräzision)|single outliers=einzelne Ausreißer|shifts between traverses=ganze"
        " Läufe, die verschoben sind|drift=Drift: Die Achse ändert sich während der"
        " Messung|temperature within its uncertainty=Temperatur: eine Steigung innerhalb dessen,"
        " was der Auftrag als unsicher angibt|error that the test leaves open=Fehler, den die"
        " Prüfung nicht zeigte: zwischen den Zielpositionen und in der Streuung verborgen|periods"
        " that the test leaves open=periodische Abweichung, die diese Zielpositionen nicht zeigen"
        " können: was sie hinzufügen würde|steps that the control never applies=Stufen der"
        " Korrektur (Umkehr), die die Steuerung wegen ihrer Beschleunigung und ihres Regeltakts"
        " nie ausführt|no table is written=gemessener Fehler, den keine Tabelle wegnimmt|spacing"
        " too wide for the period=periodische Abweichung: Die Punkte liegen für sie zu weit"
        " auseinander|spacing of the points=Krümmung zwischen den Punkten der Tabelle|number of"
        " points=Krümmung zwischen den Punkten: Die Steuerung hat zu wenige|one table for both"
        " directions=Umkehrspanne, die sich über den Verfahrweg ändert: Eine Tabelle und ein Wert"
        " können sie nicht aufnehmen|no backlash value=Umkehrspanne: Die Steuerung hat keinen"
        " Wert dafür|quantum=Auflösung der Tabellenwerte|value range=größter Wert, den die"
        " Steuerung annimmt|backlash range=größter Losewert, den die Steuerung annimmt|largest"
        " increment=größter Schritt von Punkt zu Punkt, den die Steuerung annimmt|a straight line"
        " instead of a table=Krümmung: Die Steuerung hat eine Gerade, keine Tabelle|={cause}}"
    ),
    "limits.left": "Rest der Steuerung",
    "limits.name": (
        "{cause:choose|noise=Streuung der Messwerte|single outliers=einzelne Ausreißer|shifts"
        " between traverses=verschobene Läufe|drift=Drift|temperature within its"
        " uncertainty=Unsicherheit der Temperatur|error that the test leaves open=Fehler, den die"
        " Prüfung nicht zeigte (zwischen den Zielpositionen oder in der Streuung)|periods that the"
        " test leaves open=periodischer Fehler, den diese Zielpositionen nicht zeigen können|steps"
        " that the control never applies=Stufen, die die Steuerung nie ausführt|no table is"
        " written=Fehler, den keine Tabelle korrigiert|spacing too wide for the period=zu weite"
        " Punkte für die Periode|spacing of the points=Abstand der Tabellenpunkte|number of"
        " points=zu wenige Tabellenpunkte|one table for both directions=Umkehrspanne, die sich über"
        " den Verfahrweg ändert|no backlash value=Umkehrspanne, die die Steuerung nicht korrigieren"
        " kann|quantum=Auflösung der Tabellenwerte|value range=größter Tabellenwert der"
        " Steuerung|backlash range=größter Umkehrwert der Steuerung|largest increment=größter"
        " Schritt zwischen Tabellenpunkten|a straight line instead of a table=die Steuerung hat"
        " eine Gerade, keine Tabelle|what no table of this control takes away=was keine Tabelle"
        " dieser Steuerung wegnimmt|={cause}}"
    ),
    "limits.note": (
        "Jeder Balken zeigt, um wie viel {parameter} ohne diese eine Ursache kleiner wäre,"
        " berechnet an denselben simulierten Prüfungen. Die Balken ergeben nicht die Summe, denn"
        " {parameter} ist eine Spanne, größter minus kleinster Wert: Nur die Ursachen an diesen"
        " zwei Stellen zählen."
    ),
    "limits.part": "Teil von {parameter}",
    "limits.summary": (
        "{parameter} an neuen Zielpositionen: {then} {unit} erwartet, {before} {unit}"
        " mit dem, was jetzt in der Steuerung ist. Die Streuung allein, ohne jeden Fehler der"
        " Achse, ergäbe {least} {unit}: Darunter kommt keine Tabelle."
    ),
    "period.alike": "Diese Zielpositionen unterscheiden nicht: {periods} {unit}.",
    "period.caption": (
        "Für jede Periode: wie viel wahrscheinlicher die Messwerte mit einem Fehler dieser Periode"
        " sind als ohne ihn. Wie üblich die Periode an Maschinen ist, ist noch nicht enthalten."
        " Gestrichelt: Perioden, die in der Schätzung verwendet werden.{gaps:if| In den Lücken"
        " sieht ein Fehler dieser Periode an diesen Zielpositionen wie der glatte Fehler aus: Die"
        " Suche kann ihn nicht finden.}"
    ),
    "period.described": "Wahrscheinlichkeitsverhältnis jeder Periode",
    "period.least": "Kleinste Amplitude, die diese Prüfung zeigt, in {unit}",
    "period.least_caption": (
        "Für jede Periode: die kleinste Amplitude ({unit}) einer Welle, die diese Prüfung zeigt."
        " Das heißt: In 95 % solcher Prüfungen ist die geschätzte Amplitude größer als drei"
        " Standardfehler. In den Lücken zeigt die Prüfung keine Welle unter 10 {unit}. Nennt der"
        " Auftrag die Periode nicht, wird eine Welle meist ab etwa dem 1,5-Fachen dieser Amplitude"
        " gefunden{gaps:if|, aber nicht in den Lücken des Bildes darüber}. Mehr Zielpositionen mit"
        " zufälligen Versätzen zeigen kleinere Wellen."
    ),
    "period.none": "Es ist keine Periode bekannt, und es wurde keine gefunden.",
    "period.over": "Periode in {unit}",
    "period.source": (
        "{source:choose|job=im Auftrag angegeben|found=in den Messwerten gefunden|files=in den"
        " Dateien der Steuerung angegeben|={source}}"
    ),
    "report.accreditation": (
        "Dies ist ein Prüfbericht, kein Kalibrierschein eines akkreditierten Laboratoriums. Die"
        " Rückführung der Werte beruht auf den Kalibrierscheinen der genannten Messgeräte."
    ),
    "report.acknowledged": "Zur Kenntnis genommene Zweifel",
    "report.annex_a": "Anhang A: Zielpositionen und Rohmesswerte",
    "report.annex_b": "Anhang B: Herkunft der Daten",
    "report.axis": "Achse {axis:if|{axis}|ohne Namen}{name:if|, {name}}",
    "report.both": "beide",
    "report.circle": "Kreis {plane}{name:if|, {name}}",
    "report.compensation": "Kompensation von {axes:if|{axes}|{count} Achsen}",
    "report.conditions": "Prüfbedingungen, {standard}",
    "report.conform": "Die Maschine hält alle Grenzwerte der obigen Tabelle ein.",
    "report.conformity_open": (
        "Es wird keine Konformität erklärt: {undecided:if|Mindestens ein Grenzwert ist nicht"
        " entschieden|Es ist nicht bewiesen, dass die Tabellen wie geplant aktiv sind}, oder ein"
        " Befund, von dem die Entscheidung abhängt, ist noch nicht geprüft."
    ),
    "report.customer": "Kunde",
    "report.date": "Prüfdatum",
    "report.extreme": (
        "{what:choose|R=|A={end:choose|highest=größtes|lowest=kleinstes} "
        "|E={end:choose|highest=größtes|lowest=kleinstes} "
        "|M={end:choose|highest=größtes|lowest=kleinstes} }Mittel"
        "{what:choose|E=|M= ±|A= {end:choose|highest=+|lowest=−} {coverage} s"
        "|R= {end:choose|highest=+|lowest=−} {coverage} s}"
    ),
    "report.extremes": "Extremwerte, aus denen sich A, E, M und R ergeben: Ringe im Bild",
    "report.findings": "Befunde",
    "report.footer": "Bericht {number}",
    "report.in_english": (
        "Namen und Texte aus Auftrag und Dateien stehen, wie sie angegeben sind. Die Übersetzung"
        " hat noch kein Muttersprachler geprüft; es gilt der englische Bericht."
    ),
    "report.in_file": "In der Datei: {name}",
    "report.logo": "Logo",
    "report.machine": (
        "{circles}, gemeinsam ausgewertet als Kreise einer Maschine{name:if|: {name}|}"
    ),
    "report.no_limits": (
        "Es ist kein Grenzwert angegeben. Dieser Bericht nennt Werte; er erklärt keine Konformität."
    ),
    "report.no_number": "Bericht ohne Nummer",
    "report.not_conform": "Die Maschine hält nicht alle Grenzwerte der obigen Tabelle ein.",
    "report.number": "Berichtsnummer",
    "report.open_sections": "Aufgeklappte Abschnitte werden gedruckt.",
    "report.operator": "Prüfer",
    "report.other_findings": "Weitere Befunde",
    "report.page": "Seite",
    "report.page_of": "von",
    "report.parameters": "Kennwerte",
    "report.place": "Ort",
    "report.provenance": (
        "Ausgewertet mit compwright {version}.{command:if| Dieser Befehl erzeugt den Bericht"
        " erneut:}"
    ),
    "report.readings": "Einzelwerte",
    "report.readings_air": "Einzelwerte ohne den Einfluss der Luft auf die Laserwellenlänge",
    "report.readings_measured": "Einzelwerte, wie gemessen",
    "report.readings_reduced": "Einzelwerte, auf 20 °C umgerechnet",
    "report.results": "Ergebnisse",
    "report.see_tests": "siehe Seiten der Prüfungen",
    "report.sign_checked": "Geprüft von",
    "report.sign_measured": "Gemessen von",
    "report.sign_place": "Ort, Datum",
    "report.signs": (
        "Abweichung: gemessene Position minus Zielposition. Anfahrrichtung +: in positiver"
        " Maschinenrichtung. Umkehrspanne an einer Zielposition: Mittel bei + minus Mittel bei −; B"
        " ist ihr größter Betrag."
    ),
    "report.signs_circle": (
        "Kreis: Abweichung ist gemessener minus Nennradius. Umkehrspiel über null: Nach einer"
        " Umkehr bleibt die Achse hinter dem Sollwert zurück. Rechtwinkligkeit über null: Der"
        " Winkel zwischen den positiven Achsen ist größer als 90°."
    ),
    "report.statistics": (
        "Mittelwerte, Standardabweichungen und Wiederholpräzision an {count}"
        " {count:plural|Zielposition|Zielpositionen}"
    ),
    "report.test": "Prüfung {name}",
    "report.title": "Prüfbericht{tests:plural|| über {tests} Prüfungen}",
    "report.unnamed_machine": (
        "Die Dateien dieser Kreise nennen weder Maschine noch Seriennummer. Sie gelten als eine"
        " Maschine. Kreise verschiedener Maschinen einzeln auswerten oder `# machine:` in die"
        " Dateien schreiben."
    ),
    "report.unread": "Nicht ausgewertete Dateien",
    "report.verification": "Nachprüfung von {axes}",
    "run.annex_c": "Anhang C: Kompensation",
    "run.assumed": "Annahmen",
    "run.assumed_note": (
        "Diese Angaben sind in keiner der vorliegenden Dateien; die Ergebnisse gelten nur, wenn sie"
        " zutreffen."
    ),
    "run.axis_table": "Achse {axis}: Tabelle",
    "run.bends": "{input} korrigiert {output}",
    "run.bidirectional": "Eine Kurve je Anfahrrichtung",
    "run.card": "Inbetriebnahmekarte",
    "run.certificate": "Nachweis der Anpassung",
    "run.changes": "Alt und neu",
    "run.check_first": "Offen: zuerst die oben genannten Befunde prüfen",
    "run.circle_worse": (
        "Die Grenzwerte eines Kreises sind offen: Für ihn ist eine Verschlechterung vorhergesagt."
        " Vor dem Laden die Ursache finden (CW-P131)"
    ),
    "run.comparison": "Vorher und Vorhersage",
    "run.comparison_note": (
        "Die Abweichungen vorher und, im gleichen Maßstab, die Abweichungen, die eine Prüfung an"
        " den gleichen Zielpositionen voraussichtlich zeigt."
    ),
    "run.compensation": "Kompensation",
    "run.correction": "Korrektur: was die Steuerung zum Sollwert addiert.",
    "run.cross": "Tabellen zwischen Achsen",
    "run.done": (
        "{tests:plural|1 Prüfung|{tests} Prüfungen} der {count:plural|Achse|Achsen} {axes}"
        " {tests:plural|wurde|wurden} {standards:if|nach {standards:and}|ohne Norm} ausgewertet."
        " Der Fehler wurde über den Verfahrweg geschätzt{tables:if|. Die beste Tabelle, die"
        " {control:if|{control}|die Steuerung} aufnehmen kann, wurde berechnet und in der Form der"
        " Steuerung geschrieben. Aus diesen Dateien wurde die nächste Prüfung vorhergesagt. Noch"
        " ist nichts geladen: Die Tabelle Schritt für Schritt nach der Inbetriebnahmekarte im"
        " Ergebnisordner laden, erneut messen und compwright verify ausführen.|. Es wurde keine"
        " Tabelle geschrieben, die Vorhersage gilt also für eine Prüfung ohne Tabelle.}"
    ),
    "run.estimate": "Achse {axis}: geschätzter Fehler",
    "run.estimate_note": (
        "Der Fehler, den die Tabelle beseitigen soll: die Abweichung über den Verfahrweg in dem"
        " Zustand, in dem gemessen wurde, mit ihrer Unsicherheit."
    ),
    "run.files": "Dateien",
    "run.files_written": "Geschriebene Dateien",
    "run.in_english": (
        "Texte des Auftrags, der Dateien und der Definition der Steuerung sind, wie sie gegeben"
        " wurden. Die Gründe, aus denen eine Datei der Steuerung abgelehnt wird, sind auf Englisch."
        " Die Übersetzung hat noch kein Muttersprachler geprüft."
    ),
    "run.legend": (
        "Grau: vorher. Blau: 5 bis 95 % neuer Prüfungen an den gleichen Zielpositionen,"
        " senkrechter Strich: Median. Gestrichelt: Grenzwert."
    ),
    "run.limit_missed": "Nach der Vorhersage wird mindestens ein Grenzwert nicht eingehalten",
    "run.limit_open": "Bei mindestens einem Grenzwert ist offen, ob er eingehalten wird",
    "run.limits": "Achse {axis}: was ihre Genauigkeit begrenzt",
    "run.limits_met": "Nach der Vorhersage werden alle Grenzwerte eingehalten",
    "run.limits_met_if": (
        "Nach der Vorhersage werden alle Grenzwerte eingehalten, wenn sich die oben genannten"
        " Befunde als unbedenklich erweisen"
    ),
    "run.no_axis_table": "Keine Tabelle für diese Achse{reason:if|: {reason}}.",
    "run.no_limits": (
        "Vorhergesagtes Ergebnis; es sind keine Grenzwerte für eine Entscheidung angegeben"
    ),
    "run.no_statement": (
        "Konformitätserklärung: keine. Die Entscheidungen betreffen die vorhergesagte nächste"
        " Prüfung; über die Maschine entscheidet der Bericht von compwright verify."
    ),
    "run.no_table": "Es wurde keine Tabelle geschrieben",
    "run.no_table_for": "Für Achse {axes} wurde keine Tabelle geschrieben",
    "run.periods": "Achse {axis}: Perioden des Fehlers",
    "run.points": "Tabelle in Zahlen: {count:plural|{count} Punkt|{count} Punkte}",
    "run.provenance": "Herkunft der Daten",
    "run.raw_readings": "Rohmesswerte",
    "run.refusal": "Achse {axis}: {reason}.",
    "run.single": "Eine Kurve und ein Wert der Umkehrspanne",
    "run.state": "Achse {axis}: angenommener Inhalt der Steuerung",
    "run.state_files": (
        "Wie in {files}; die Tabelle ist die Summe aus dem, was vorhanden war, und dem, was"
        " hinzukommt."
    ),
    "run.state_none": "Keiner: In der Steuerung war nichts aktiv, als die Achse gemessen wurde.",
    "run.state_not_given": (
        "Nicht angegeben. Ist unbekannt, was in der Steuerung ist, wird keine Tabelle geschrieben,"
        " denn die neue Tabelle muss enthalten, was schon aktiv ist."
    ),
    "run.table": (
        "{count} Tabellenpunkte, wie aus den Dateien zurückgelesen.{wanted:if| Breite Linie: die"
        " gewünschte Korrektur vor Rundung und Begrenzung.}"
    ),
    "run.worth": "Achse {axis}: Nutzen der Tabellenpunkte",
    "verify.comparison": "Vorher, Vorhersage und nachher",
    "verify.comparison_note": (
        "Alle Kurven im gleichen Maßstab. Vorhersage: erwartete Mittelwerte an den Zielpositionen"
        " der ersten Prüfung."
    ),
    "verify.equivalent": "nicht zu unterscheiden von",
    "verify.factor": "Faktor",
    "verify.further_table": "Tabelle für die nächste Korrekturrunde",
    "verify.in_english": (
        "Texte des Auftrags, der Dateien und der Definition der Steuerung sind, wie sie gegeben"
        " wurden. Die Gründe, aus denen eine Datei der Steuerung abgelehnt wird, sind auf Englisch."
        " Die Übersetzung hat noch kein Muttersprachler geprüft."
    ),
    "verify.legend": (
        "Grau: vorher. Blau: Vorhersage 5 bis 95 %, senkrechter Strich: nach dem Laden gemessen."
        " Gestrichelt: Grenzwert."
    ),
    "verify.look_at": "Zu prüfen:",
    "verify.next_round": "{written:if|Nächste Runde|Keine nächste Runde}",
    "verify.no_further_table": "keine neue Tabelle für die nächste Korrekturrunde",
    "verify.outside": "außerhalb",
    "verify.shift": "Verschiebung in Tabellenpunkten",
    "verify.table_of": "Tabelle der Achse",
    "verify.within": "innerhalb",
    "worth.caption": (
        "Vorhergesagtes {symbol} an neuen Zielpositionen für jede Zahl von"
        " Tabellenpunkten: Median und 5 bis 95 %. Der gefüllte Punkt ist die Tabelle, die"
        " geschrieben wird{grid:if|; {grid:choose|ring=der Ring ist die vorhandene Tabelle der"
        " Steuerung|on_it=sie behält die Punkte der vorhandenen Tabelle}|}."
    ),
    "worth.described": "{quantity} über der Anzahl der Punkte",
    "worth.over": "Punkte der Tabelle",
    "worth.points": (
        "{points} Punkte, alle {spacing} {place}: {symbol} {median} {unit} ({p05} bis {p95})"
    ),
    "worth.quantity": "{symbol} in {unit}",
}
