"""Labels and fixed sentences of reports, translated."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": (
        "Dieser Bericht enthält die Angaben, die GOST 27843-2006, 8.1 verlangt."
    ),
    "basis.iso230_2_1988": (
        "Dieser Bericht enthält die Angaben, die ISO 230-2:1997, 7.1 verlangt. Die Ausgabe von 1988"
        " hat keine solche Liste. Wo der Bericht einen Abschnitt nennt, verlangen auch die"
        " Abschnitte 3.2 und 4.3 der Ausgabe von 1988 die Angabe."
    ),
    "basis.iso230_2_1997": "Dieser Bericht enthält die Angaben, die ISO 230-2:1997, 7.1 verlangt.",
    "basis.iso230_2_2006": "Dieser Bericht enthält die Angaben, die ISO 230-2:2006, 7.1 verlangt.",
    "basis.iso230_2_2014": (
        "Dieser Bericht enthält die Angaben, die ISO 230-2:2006, 7.1 verlangt. Der Text von ISO"
        " 230-2:2014 lag nicht vor; seine Abschnitte werden nicht genannt."
    ),
    "basis.iso230_4_1996": (
        "Dieser Bericht enthält die Angaben, die ISO 230-4:1996, 4.4 und 6 verlangt. Verwendet"
        " wurde die deutsche Ausgabe DIN ISO 230-4:1999."
    ),
    "basis.iso230_4_2005": (
        "Dieser Bericht enthält die Angaben, die ISO 230-4:1996, 4.4 und 6 verlangt. Der Text von"
        " ISO 230-4:2005 lag nicht vor; seine Abschnitte werden nicht genannt."
    ),
    "basis.vdi3441": (
        "Dieser Bericht enthält die Angaben, die ISO 230-2:2006, 7.1 verlangt. Der Text von"
        " VDI/DGQ 3441 lag nicht vor; seine Abschnitte werden nicht genannt."
    ),
    "budget.E_VE": "Schwankung der Umgebung (Spanne)",
    "budget.U_alpha_instrument": "Ausdehnungskoeffizient des Messgeräts",
    "budget.U_alpha_machine": "Ausdehnungskoeffizient der Maschine",
    "budget.U_theta_instrument": "Temperatur des Messgeräts",
    "budget.U_theta_machine": "Temperatur der Maschine",
    "budget.combined": "Kombinierte Standardunsicherheit",
    "budget.device": "Messgerät (Kalibrierschein)",
    "budget.distribution": (
        "{distribution:choose|normal=Normalverteilung, k = 2|rectangular=Rechteckverteilung, √12};"
        " {per:choose|length=über die Länge|test=je Prüfung|reading=je Messwert}"
    ),
    "budget.expanded": "Erweiterte Unsicherheit, k = {k}",
    "budget.misalignment_mm": "Ausrichtung der Messlinie",
    "budget.note": (
        "Beiträge nach ISO 230-2:2006, Anhang A. Die Summe oben ist die Unsicherheit eines"
        " Messwerts am Ende des Verfahrwegs. Sie ist nicht gleich U eines Kennwerts, denn U wird"
        " aus denselben Verteilungen über die Definition des Kennwerts berechnet (JCGM 101). Alle"
        " Werte stammen aus dem Auftrag. Ein Beitrag, den der Auftrag nicht angibt, zählt als 0."
        " Kein Wert stammt aus dem Beispiel der Norm."
    ),
    "budget.setup": "Aufbau des Messgeräts",
    "budget.steel": "{alpha:g} µm/(m K), Stahl, ist angenommen",
    "budget.sum": "{fixed:g} µm + {per_m:g} µm/m × {length:g} m",
    "budget.temperature_unknown": "die Temperatur ist unbekannt: nicht gezählt",
    "budget.title": "Budget der Messunsicherheit, über {length}",
    "cause.kind": (
        "{kind:choose|squareness=Rechtwinkligkeit"
        " {first}{second}|scale_mismatch=Maßstabsunterschied {first} −"
        " {second}|servo_mismatch=Unterschied der Lageregelung {first} −"
        " {second}|radius_change=Radiusänderung ↺ − ↻|backlash=Umkehrspiel"
        " {axis}|lateral_play=Seitliches Spiel {axis}|reversal_spike=Umkehrspitze"
        " {axis}|cyclic=Periodische Abweichung {axis}|straightness=Geradheit"
        " {axis}|scale_error=Maßstabsabweichung {axis}|backlash_mismatch=Umkehrspiel {first} −"
        " {second}|offset_change=Mittelpunktverschiebung {axis}, ↺ − ↻|spiral=Spirale (Drift"
        " während einer Runde)|master_slave=Wechsel der"
        " Führungsachse|vibration=Schwingung|stick_slip=Ruckgleiten {axis}|lobes_2=Zwei"
        " Wellen|lobes_3=Drei Wellen|position_loop=Nachlauf der Lageregelung"
        " {axis}|positional_tolerance=Positionstoleranz}"
    ),
    "cause.note": (
        "{kind:choose|reversal_spike=Spitze der Messwerte {peak} µm"
        "|cyclic=Periode {period:.4g} mm{phase:if|, Phase {phase}°|}"
        "|vibration={frequency:.4g} Hz}"
    ),
    "cause.noted": "{cause} ({note})",
    "cause.part": (
        "bei {axis}{part:choose|at_positive=+|at_negative=−|at_positive_ccw=+ ↺|at_positive_cw=+"
        " ↻|at_negative_ccw=− ↺|at_negative_cw=− ↻}"
    ),
    "cause.whole": "{cause} {part}",
    "certificate.name": (
        ""
        "{key:choose|primal=primal|stationarity=Stationarität|dual=dual|complementarity=Komplementarität|rounding=Rundung|objective=Zielwert|lower_bound=untere"
        " Schranke|recomputed=nachgerechnet|magnification=Vergrößerung|={name}}"
    ),
    "changes.summary": (
        "{count:plural|{count} Eintrag ändert sich|{count} Einträge ändern sich}; {untouched}"
        " Zeilen der Dateien der Steuerung bleiben, wie sie sind. Die Werte sind die der Dateien,"
        " in den Einheiten der Steuerung.{more:if| {more} weitere Änderungen stehen in"
        " `changes.csv`.|}"
    ),
    "chart.angle": "Winkel in °",
    "chart.bar": "Balken: vorher {before}, jetzt {now}, Grenze {limit}",
    "chart.correction": "Korrektur, die die Steuerung zum Sollwert addiert",
    "chart.described": (
        "{what:choose|deviations=Abweichungen der Achse {name}"
        "|marked=Abweichungen der Achse {name}, Ringe an den Extremwerten der Kenngrößen"
        "|reversal=Umkehrspanne der Achse"
        " {name}|residual=Rest der Kreisformprüfung {name}|correction=Korrektur der Achse"
        " {name}|comparison=Achse {name}, Abweichungen nebeneinander|estimate=geschätzter Fehler"
        " der Achse {name}|circle=Kreisformprüfung {name}}"
    ),
    "chart.estimate": "Schätzung ({sign})",
    "chart.estimated": "Geschätzte Abweichung mit ± 2 Standardabweichungen",
    "chart.expected": "erwarteter Mittelwert ({sign})",
    "chart.legend": "(+) und (−): Anfahren in positiver und in negativer Richtung",
    "chart.line": "{parts:join|   }{unit:if| {unit}|}",
    "chart.mean": "Mittelwert ({sign})",
    "chart.measured": "gemessener Mittelwert ({sign})",
    "chart.position": "Position in {unit}",
    "chart.quantiles": "{symbol} {median} ({p05} bis {p95})",
    "chart.quantity": (
        "{quantity:choose|deviation=Abweichung|reversal=Umkehrspanne B|correction=Korrektur} in"
        " {unit}"
    ),
    "chart.radius": "Radius in µm",
    "chart.readings": "Messwerte ({sign})",
    "chart.residual": "Gemessen minus Ausgleich, {sense}",
    "chart.spread": "Mittelwert ± {coverage:g} s ({sign})",
    "chart.table": "Tabelle ({sign})",
    "chart.table_both": "Tabelle (+ und −)",
    "chart.wanted": "gewünscht ({sign})",
    "decision.accept": "✓ angenommen",
    "decision.no_limit": "kein Grenzwert",
    "decision.reject": "✗ abgelehnt",
    "decision.undecided": "? offen",
    "fact.address": "Adresse in der Steuerung",
    "fact.kind": "Art",
    "fact.quantum": "Auflösung der Tabelle",
    "fact.unit": "Einheit der Abweichungen",
    "head.after": "Nachher",
    "head.approach": "Anfahrrichtung",
    "head.assumed_value": "Angenommener Wert",
    "head.axis": "Achse",
    "head.before": "Vorher",
    "head.cause": "Ursache",
    "head.causes": "Ursachen",
    "head.clause": "Abschnitt",
    "head.contribution": "Beitrag u",
    "head.correction": "Korrektur{sign:if| {sign}}",
    "head.coverage_factor": "Erweiterungsfaktor k",
    "head.decision": "Entscheidung",
    "head.distribution": "Verteilung",
    "head.entry": "Eintrag",
    "head.evidence": "Nachweis",
    "head.expanded_uncertainty": "Erweiterte Unsicherheit U",
    "head.extreme": "Extremwert",
    "head.fact": "Tatsache",
    "head.file": "Datei",
    "head.item": "Angabe",
    "head.limit": "Grenzwert",
    "head.limit_on": "Grenzwert für",
    "head.loading": "Laden",
    "head.mean": "Mittel {sign}",
    "head.new": "Neu",
    "head.old": "Alt",
    "head.parameter": "Kennwert",
    "head.period": "Periode",
    "head.position": "Position",
    "head.predicted": "Vorhersage",
    "head.predicted_new": "Vorhersage, neue Zielpositionen",
    "head.predicted_same": "Vorhersage, gleiche Zielpositionen",
    "head.probability": "Wahrscheinlichkeit",
    "head.quantity": "Größe",
    "head.remark": "Bemerkung",
    "head.residual": "Restfehler",
    "head.sensitivity": "Empfindlichkeit",
    "head.source": "Quelle",
    "head.standard": "Norm",
    "head.stated": "Inhalt",
    "head.test": "Prüfung",
    "head.unit": "Einheit",
    "head.value": "Wert",
    "head.value_given": "Angegebener Wert",
    "item.air_pressure": "Luftdruck, Beginn und Ende",
    "item.air_shower": "Luft- oder Öldusche, Kühlschmierstoff",
    "item.air_temperature": "Lufttemperatur, Beginn und Ende",
    "item.approaches": "Anzahl der Anfahrten, Prüfzyklus",
    "item.axis": "Geprüfte Achse",
    "item.certificate": "Messgerät: Kalibrierschein",
    "item.compensation": "Kompensation der Steuerung: ein oder aus",
    "item.compensation_routine": "Art der Temperaturkompensation",
    "item.contributors": "Beiträge zur Messunsicherheit",
    "item.date": "Datum und Uhrzeit der Prüfung",
    "item.diameter": "Durchmesser oder Radius der Sollbahn",
    "item.dwell": "Verweilzeit an jeder Zielposition",
    "item.estimator": "Schätzung von s, Glättung",
    "item.expansion": "Korrektur der Wärmeausdehnung (NDE)",
    "item.feed": "Vorschub zwischen den Zielpositionen",
    "item.humidity": "Luftfeuchte, Beginn und Ende",
    "item.instrument": "Messgerät: Hersteller, Typ",
    "item.instrument_position": "Lage des Messgeräts",
    "item.instrument_serial": "Messgerät: Seriennummern der Komponenten",
    "item.machine": "Maschinenbezeichnung und Seriennummer",
    "item.machine_type": "Maschinentyp",
    "item.measuring_line": "Messlinie: Lage, Versatz zu Werkzeug- und Werkstückbezug",
    "item.operator": "Prüfer",
    "item.other_axes": "Positionen der nicht geprüften Achsen",
    "item.path_feed": "Bahngeschwindigkeit",
    "item.place": "Ort der Prüfung",
    "item.plane": "Achsen, die die Istbahn erzeugen",
    "item.range": "Bereich der Messdatenerfassung, Start- und Endpunkt",
    "item.samples": "Anzahl der Messpunkte",
    "item.scale": "Art des Maschinenmaßstabs",
    "item.scale_expansion": "Ausdehnungskoeffizient des Maßstabs",
    "item.sense": "Umlaufsinn",
    "item.sensor_positions": "Orte der Temperaturfühler",
    "item.smoothing": "Glättung",
    "item.standard": "Norm und Ausgabe",
    "item.targets": "Zielpositionen",
    "item.temperatures": "Temperatur von Maßstab oder Werkstück, Beginn und Ende",
    "item.temperatures_circle": "Temperaturen von Umgebung, Messgerät und Maschine",
    "item.temperatures_instrument": "Temperatur der Fühler des Messgeräts, Beginn und Ende",
    "item.travel": "Verfahrweg der Achse",
    "item.warm_up": "Warmlaufen vor der Prüfung",
    "label.after": "nachher",
    "label.before": "vorher",
    "label.circular_test": "Kreisformprüfung",
    "label.coded": "{code}: {text}",
    "label.conformity": "Konformitätserklärung: {statement}",
    "label.control": "Steuerung",
    "label.decision_rule": "Entscheidungsregel: {rule}",
    "label.extreme_at": "{symbol} bei {place} {unit}",
    "label.kind": "{kind:choose|linear=Linearachse|rotary=Drehachse}",
    "label.machine": "{key:choose|name=Maschine|serial=Seriennummer|type=Typ|={key}}",
    "label.median": "Median",
    "label.not_stated": "nicht angegeben",
    "label.of_the_prediction": "der Vorhersage",
    "label.plus_minus": "± {U}",
    "label.range": "{low} bis {high}",
    "label.test_sentence": (
        "{standard}, {cycle:choose|standard=Standardzyklus|step=Schrittzyklus}, {targets}"
        " {targets:plural|Zielposition|Zielpositionen}, Läufe: {counts:if|{counts}|keine},"
        " Grenzen bei ± {coverage} s.{extremes:if| Extremwerte: {extremes:join|;"
        " }.}{uncertainty:if|| Keine Messunsicherheit: Es sind keine Beiträge angegeben.}"
    ),
    "label.test_title": (
        "Achse {axis:if|{axis}|ohne Namen}, {name:if|{name}|Prüfung}{label:if|, {label}}"
    ),
    "label.traverses": "{count} in {sign}",
    "label.unconfirmed": "! unbestätigt",
    "label.value_error": "{value} ± {error}",
    "label.with_range": "{unit}; Median, 5–95 %",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "mark.loading": (
        "{verdict:choose|loaded=✓ geladen|undecided=? offen|measurement=? Fehler der"
        " Messung|not_active=✗ nicht aktiv|inverted=✗ umgekehrt|scaled=✗ skaliert|shifted=✗"
        " verschoben|mirrored=✗ gespiegelt|wrong_axis=✗ falsche Achse|increment=✗ nur Änderung"
        " geladen|on_top=✗ zur alten Tabelle addiert|state=✗ alte Tabelle war nicht"
        " aktiv|one_direction=✗ in einer Richtung aktiv|backlash=✗ Losewert falsch|partial=✗"
        " teilweise aktiv|thermal=✗ thermische Steigung|read_back=✗ weicht vom Plan ab|=✗"
        " {verdict}}"
    ),
    "parameter.A": "Genauigkeit der Positionierung, zweiseitig",
    "parameter.A_negative": "Genauigkeit der Positionierung, Anfahrrichtung −",
    "parameter.A_positive": "Genauigkeit der Positionierung, Anfahrrichtung +",
    "parameter.B": "Umkehrspanne",
    "parameter.B_mean": "Mittlere Umkehrspanne",
    "parameter.E": "Systematische Positionsabweichung, zweiseitig",
    "parameter.E_negative": "Systematische Positionsabweichung, Anfahrrichtung −",
    "parameter.E_positive": "Systematische Positionsabweichung, Anfahrrichtung +",
    "parameter.M": "Spanne der mittleren zweiseitigen Positionsabweichung",
    "parameter.P": "Positionsunsicherheit",
    "parameter.Pa": "Positionsabweichung",
    "parameter.Ps_max": "Größte Positionsstreubreite",
    "parameter.Ps_mean": "Mittlere Positionsstreubreite",
    "parameter.R": "Wiederholpräzision der Positionierung, zweiseitig",
    "parameter.R_negative": "Wiederholpräzision der Positionierung, einseitig, Anfahrrichtung −",
    "parameter.R_positive": "Wiederholpräzision der Positionierung, einseitig, Anfahrrichtung +",
    "parameter.U_max": "Größte Umkehrspanne",
    "parameter.U_mean": "Mittlere Umkehrspanne",
    "rule.band": "{symbol} {U:if|{U} {unit}|nicht angegeben}",
    "rule.guarded": (
        "Entscheidung mit Schutzabstand (ISO 14253-1): angenommen, wenn das 95-%-Quantil der"
        " vorhergesagten Prüfungen plus U innerhalb des Grenzwerts liegt; abgelehnt, wenn ihr"
        " 5-%-Quantil minus U darüber liegt; U (k = 2) der nächsten Prüfung, einschließlich der"
        " Unsicherheit, die die erste Prüfung in die Tabelle gebracht hat: {bands}."
    ),
    "rule.guarded_after": (
        "Entscheidung mit Schutzabstand (ISO 14253-1): angenommen, wenn der Wert plus U innerhalb"
        " des Grenzwerts liegt; abgelehnt, wenn der Wert minus U darüber liegt; U (k = 2) der"
        " Prüfung nach dem Laden: {bands}."
    ),
    "rule.simple": (
        "Angenommen, wenn das 95-%-Quantil der vorhergesagten Prüfungen innerhalb des Grenzwerts"
        " liegt; abgelehnt, wenn ihr 5-%-Quantil darüber liegt; die Messunsicherheit zählt nicht:"
        " keine Schutzabstände (ISO 14253-1)."
    ),
    "rule.simple_after": (
        "Angenommen, wenn der Messwert innerhalb des Grenzwerts liegt; abgelehnt, wenn er darüber"
        " liegt; die Messunsicherheit zählt nicht: keine Schutzabstände (ISO 14253-1)."
    ),
    "severity.error": "✗ Fehler",
    "severity.info": "Hinweis",
    "severity.warning": "! Warnung",
}
