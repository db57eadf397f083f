"""The German catalogue: labels and fixed sentences of reports. Terms: docs/terms.md."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "Angaben nach GOST 27843-2006, 8.1.",
    "basis.iso230_2_1988": (
        "Angaben nach ISO 230-2:1997, 7.1. Die Ausgabe von 1988 hat keine Liste; ihre Abschnitte"
        " 3.2 und 4.3 verlangen die Angaben, bei denen hier ein Abschnitt steht."
    ),
    "basis.iso230_2_1997": "Angaben nach ISO 230-2:1997, 7.1.",
    "basis.iso230_2_2006": "Angaben nach ISO 230-2:2006, 7.1.",
    "basis.iso230_2_2014": (
        "Angaben nach ISO 230-2:2006, 7.1. Der Text von ISO 230-2:2014 lag nicht vor; seine"
        " Abschnitte werden nicht genannt."
    ),
    "basis.iso230_4_1996": (
        "Angaben nach ISO 230-4:1996, 4.4 und 6 (gelesen als DIN ISO 230-4:1999)."
    ),
    "basis.iso230_4_2005": (
        "Angaben nach ISO 230-4:1996, 4.4 und 6. Der Text von ISO 230-4:2005 lag nicht vor; seine"
        " Abschnitte werden nicht genannt."
    ),
    "basis.vdi3441": (
        "Angaben nach ISO 230-2:2006, 7.1. Der Text von VDI/DGQ 3441 lag nicht vor; seine"
        " Abschnitte werden nicht genannt."
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
        "Beiträge nach ISO 230-2:2006, Anhang A. Die Summe gilt für einen Messwert am Ende des"
        " Verfahrwegs. Sie ist nicht gleich U der Kennwerte (oben): Dort werden dieselben"
        " Verteilungen durch die Definition des Kennwerts fortgepflanzt (JCGM 101). Alle Werte"
        " stammen aus dem Auftrag; fehlende zählen als 0. Kein Wert stammt aus dem Beispiel der"
        " Norm."
    ),
    "budget.setup": "Aufbau des Messgeräts",
    "budget.title": "Budget der Messunsicherheit, über {length}",
    "given.approaches": "{counts}; {cycle:choose|standard=Standardzyklus|step=Schrittzyklus}",
    "given.arc": "von {start}° bis {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=zu Beginn|_end=am Ende}",
    "given.axis": "{axis}, {kind:choose|linear=Linearachse|rotary=Drehachse}",
    "given.budget": "siehe Budget der Messunsicherheit",
    "given.centre": "Mittelpunkt {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.estimator": (
        "s: {spread:choose|std=Standardabweichung, n − 1|range=aus der Spannweite der Messwerte};"
        " Grenzen bei ± {coverage} s; keine Glättung"
    ),
    "given.expansion": (
        "von compwright angewendet: Messwerte auf 20 °C umgerechnet,"
        " {what:choose|scale=Maßstab|workpiece=Werkstück} {alpha_m} µm/(m K) bei {T_m} °C,"
        " Messgerät {alpha_d} µm/(m K) bei {T_d} °C, Festpunkt {x_fix} mm"
    ),
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.radius": "Radius {radius} mm",
    "given.samples": "{counts} Messpunkte",
    "given.sense": "{sense:choose|ccw=Gegenuhrzeigersinn|cw=Uhrzeigersinn}",
    "given.smoothing": "keine durch compwright: Jeder Messpunkt zählt",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count} von {first} bis {last} {unit}; Liste in Anhang A",
    "head.approach": "Anfahrrichtung",
    "head.clause": "Abschnitt",
    "head.contribution": "Beitrag u",
    "head.coverage_factor": "Erweiterungsfaktor k",
    "head.distribution": "Verteilung",
    "head.expanded_uncertainty": "Erweiterte Unsicherheit U",
    "head.extreme": "Extremwert",
    "head.file": "Datei",
    "head.item": "Angabe",
    "head.mean": "Mittel {sign}",
    "head.parameter": "Kennwert",
    "head.position": "Position",
    "head.remark": "Bemerkung",
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
    "label.extreme_at": "{symbol} bei {place} {unit}",
    "label.not_stated": "nicht angegeben",
    "label.plus_minus": "± {U}",
    "label.test_sentence": (
        "{standard}, {cycle:choose|standard=Standardzyklus|step=Schrittzyklus}, {targets}"
        " {targets:plural|Zielposition|Zielpositionen}, Messreihen: {counts:if|{counts}|keine},"
        " Grenzen bei ± {coverage} s.{extremes:if| Extremwerte: {extremes:join|; }.}"
        "{uncertainty:if|| Keine Messunsicherheit: Es sind keine Beiträge angegeben.}"
    ),
    "label.test_title": "Achse {axis}, {name:if|{name}|Prüfung}{label:if|, {label}}",
    "label.traverses": "{count} in {sign}",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
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
    "parameter.R_negative": "Wiederholpräzision der Positionierung, Anfahrrichtung −",
    "parameter.R_positive": "Wiederholpräzision der Positionierung, Anfahrrichtung +",
    "parameter.U_max": "Größte Umkehrspanne",
    "parameter.U_mean": "Mittlere Umkehrspanne",
    "report.accreditation": (
        "Dies ist ein Prüfbericht, kein Kalibrierschein eines akkreditierten Laboratoriums. Die"
        " Rückführung der Werte beruht auf den Kalibrierscheinen der genannten Messgeräte."
    ),
    "report.acknowledged": "Bestätigte Zweifel",
    "report.annex_a": "Anhang A: Zielpositionen und Rohmesswerte",
    "report.annex_b": "Anhang B: Herkunft der Daten",
    "report.axis": "Achse {axis}{name:if|, {name}}",
    "report.both": "beide",
    "report.circle": "Kreis {plane}{name:if|, {name}}",
    "report.conditions": "Prüfbedingungen, {standard}",
    "report.conform": "Die Maschine hält alle Grenzwerte der obigen Tabelle ein.",
    "report.conformity_open": (
        "Es wird keine Konformität erklärt: Mindestens eine Entscheidung oder ihre Grundlage ist"
        " offen."
    ),
    "report.customer": "Kunde",
    "report.date": "Prüfdatum",
    "report.extreme": (
        "{end:choose|highest=größtes|lowest=kleinstes} Mittel"
        "{what:choose|A= {end:choose|highest=+|lowest=−} {coverage} s|E=|M= ±}"
    ),
    "report.extremes": "Extremwerte: Ringe im Bild",
    "report.findings": "Befunde",
    "report.footer": "Bericht {number}",
    "report.in_english": (
        "Die Befunde, die Beschriftung der Bilder und die Seiten der Kreisformprüfungen sind auf"
        " Englisch."
    ),
    "report.in_file": "In der Datei: {name}",
    "report.logo": "Logo",
    "report.no_limits": (
        "Es ist kein Grenzwert angegeben. Dieser Bericht nennt Werte; er erklärt keine Konformität."
    ),
    "report.no_number": "Bericht ohne Nummer",
    "report.not_conform": "Die Maschine hält nicht alle Grenzwerte der obigen Tabelle ein.",
    "report.number": "Berichtsnummer",
    "report.operator": "Prüfer",
    "report.page": "Seite",
    "report.page_of": "von",
    "report.parameters": "Kennwerte",
    "report.place": "Ort",
    "report.provenance": (
        "Ausgewertet mit compwright {version}."
        "{command:if| Dieser Befehl erzeugt den Bericht erneut:}"
    ),
    "report.readings": "Einzelwerte",
    "report.readings_measured": "Einzelwerte, wie gemessen",
    "report.readings_reduced": "Einzelwerte, auf 20 °C umgerechnet",
    "report.results": "Ergebnisse",
    "report.see_tests": "siehe Seiten der Prüfungen",
    "report.sign_checked": "Geprüft von",
    "report.sign_measured": "Gemessen von",
    "report.sign_place": "Ort, Datum",
    "report.signs": (
        "Abweichung: gemessene Position minus Zielposition. Anfahrrichtung +: in positiver"
        " Maschinenrichtung. B ist das Mittel bei + minus das Mittel bei −."
    ),
    "report.statistics": (
        "Mittelwerte, Standardabweichungen und Wiederholpräzision an {count}"
        " {count:plural|Zielposition|Zielpositionen}"
    ),
    "report.title": "Prüfbericht{tests:plural|| über {tests} Prüfungen}",
    "report.unread": "Nicht ausgewertete Dateien",
    "severity.error": "✗ Fehler",
    "severity.info": "Hinweis",
    "severity.warning": "! Warnung",
}
