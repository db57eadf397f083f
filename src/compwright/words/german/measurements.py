"""What is noticed while measurement files are read."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-R001": "Nicht in der Datei angegeben, angenommen: {assumed:join|; }.",
    "CW-R002": "Die Datei nennt ihre Achse nicht (Kommentarzeile '# axis: X').",
    "CW-R003": "Gemessene Werte wurden in Abweichungen umgerechnet, gemessen minus Ziel.",
    "CW-R004": "Das Messgerät hat schon kompensiert: {compensated}.",
    "CW-R005": "Weggelassene Spalten: {columns}.",
    "CW-R006.place": "{target} in Lauf {run}",
    "CW-R006.readings": "{missing} von {readings} Messwerten fehlen: {places}.",
    "CW-R006.rows": (
        "Zeilen ohne Messwert sind weggelassen: Zielposition {targets}{more:if| und {more} weitere}"
        " {unit}. Die Ergebnisse sprechen nicht von ihnen."
    ),
    "CW-R007": (
        "Es gibt {positive} Läufe in Richtung + und {negative} in Richtung −: Einer wurde"
        " nicht gefahren, oder die Datei ist abgeschnitten."
    ),
    "CW-R008": (
        "{count} von {of} Abweichungen sind größer als 1 {unit}, die größte {largest} {unit} bei"
        " der Zielposition {target} {unit}: Stimmt die Einheit{turn:if|, oder zählen die Messwerte"
        " modulo 360°}?"
    ),
    "CW-R009": (
        "Alle Abweichungen sind kleiner als 0,000001 {unit}: Stimmt die Einheit, und wurde"
        " gemessen?"
    ),
    "CW-R010": (
        "Jede Abweichung von Lauf {runs} ist genau null, während andere es nicht sind: Manche"
        " Programme füllen nicht gefahrene Läufe mit Nullen. Dann herausnehmen. Das Ergebnis"
        " enthält sie; wo die anderen streuen, entstehen Tabelle und Vorhersage ohne sie."
    ),
    "CW-R011": (
        "Die Abweichungen wachsen um etwa 1 {unit} je {unit} Zielposition, wie gemessene"
        " Positionen: Sind es gemessene Positionen, die Spalte measured_{unit} nennen."
    ),
    "CW-R012": (
        "Fast gleiche Zielpositionen, von denen kein Lauf beide hat, vielleicht eine Zielposition:"
        " {targets}."
    ),
    "CW-R012.pair": "{low:.10g} und {high}",
    "CW-R013": (
        "Der Schlüssel 'deviation: {deviation}' hat keine Wirkung: Die Datei enthält Messwerte,"
        " keine Abweichungen."
    ),
    "CW-R014.forward": (
        "Die Positionen stehen nicht von klein nach groß: an der Maschine prüfen, welche Richtung"
        " vorwärts ist."
    ),
    "CW-R014.labels": (
        "Die Zielpositionen stehen von groß nach klein, und FWD wurde als Anfahren in Richtung +"
        " genommen: die Bezeichnungen prüfen."
    ),
    "CW-R014.odd_runs": (
        "Die Zielpositionen stehen von groß nach klein, deshalb wurden ungerade Läufe als Anfahren"
        " in Richtung {direction} genommen: an der Maschine prüfen."
    ),
    "CW-R015": (
        "{number} wurde mit Dezimalpunkt gelesen, aber in derselben Spalte stehen ganze Zahlen, und"
        " keine Zahl beweist den Punkt: Trennt er Tausender, herausnehmen."
    ),
    "CW-R030": (
        "Die Messwerte enthalten Kalibrierung und Temperaturkorrektur des Messgeräts schon"
        " (Ausdehnung {expansion} µm/(m K), {temperatures} °C): Nichts wurde noch einmal"
        " angewendet."
    ),
    "CW-R031": (
        "Der wahre Vorschub, aus Abtastrate und Anzahl der Messpunkte, ist {feed:.4g} mm/min und"
        " nicht der programmierte von {programmed:.4g} mm/min: Override, oder eine Achse, die nicht"
        " folgte. Der wahre wird verwendet."
    ),
    "CW-R032": (
        "Lauf {direction} {run} hat nach dem gemessenen Bogen {number} {more:if|mehr|weniger}"
        " Messwerte als davor: Ein Messwert kann doppelt oder verloren sein."
    ),
    "CW-R033": "Die Prüfung verlangt einen Lauf {sense}, aber die Datei enthält keinen.",
    "CW-R034": (
        "In {run} fehlen Messpunkte ab {angle:.6g}°, über {width:.4g}° (Messpunkte liegen"
        " {step:.3g}° auseinander)."
    ),
    "CW-R035": (
        "Die größte Abweichung vom Nennradius ist {largest:.4g} mm: Stimmen Einheit, Nennradius und"
        " Aufbau?"
    ),
    "CW-R036": "Jede Abweichung von Lauf {runs} ist null (unter 0,001 µm): Wurde gemessen?",
    "CW-R037": (
        "Das Messgerät war für {files} nicht kalibriert: Die Radien der ganzen Prüfung zählen"
        " nicht."
    ),
    "CW-R038": "{files:and} wurden als die beiden Richtungen einer Prüfung genommen.",
    "CW-R039": (
        "Die andere Richtung kann in {files} sein, aber kein Paar ist sicher: nicht verbunden."
        " Jeweils ein Paar auswerten, oder den Dateien Namen geben, die sich nur in ccw und cw"
        " unterscheiden."
    ),
    "CW-R050": (
        "Weggelassen, weil eine Prüfung in zwei Richtungen sie nur in einer anfuhr: Zielposition"
        " {targets}."
    ),
    "CW-R051": (
        "Die Datei endet ohne Zeilenende nach {number} (Zeile {line}): Wurde sie beim Kopieren"
        " abgeschnitten, fehlen dort Stellen oder Messwerte danach."
    ),
    "CW-R052": "Im Ordner übersprungen, nach der Endung keine Messungen: {files}.",
    "CW-R053.environment": (
        "Die Datei hat nach ihren Mittelwerten keinen Abschnitt ENVIRONMENT::. Sie kann"
        " abgeschnitten sein."
    ),
    "CW-R053.header": (
        "Die Datei sagt, dass sie {promised} {what:choose|targets=Zielpositionen|runs=Läufe} hat"
        " (Schlüssel {key}), und enthält {found}: Sie kann abgeschnitten sein."
    ),
    "CW-R053.last_run": (
        "Die letzten Zeilen gehören zu Lauf {run}, dem {lacking} von {readings} Messwerten fehlen,"
        " während die anderen alle haben: Die Datei kann abgeschnitten sein."
    ),
    "CW-R053.last_target": (
        "Die letzten Zeilen gehören zur Zielposition {target}, der {lacking} von {readings}"
        " Messwerten fehlen, während die anderen alle haben: Die Datei kann abgeschnitten sein."
    ),
    "CW-R053.no_end": (
        "Die Datei endet ohne EOF::, ihre letzte Zeile ist {text} (Zeile {line}): Sie kann"
        " abgeschnitten sein, Stellen oder Messwerte können fehlen. Mit dem Messgerät vergleichen."
    ),
    "CW-R053.one_direction": (
        "Nur {direction} ist da. In dieser Form steht eine Richtung ganz vor der anderen, eine"
        " dazwischen abgeschnittene Datei liest sich also wie eine Prüfung in einer Richtung: mit"
        " dem Messgerät vergleichen."
    ),
    "CW-R053.run_count": (
        "Die Datei verspricht {promised} Läufe (Run-count) und enthält {found}: Sie kann"
        " abgeschnitten sein, oder die Prüfung wurde abgebrochen."
    ),
    "CW-R053.share": (
        "{share:.0%} der Messwerte fehlen: Die Datei kann abgeschnitten sein, oder Zeilen gingen"
        " verloren."
    ),
    "CW-R054": (
        "Weggelassene Läufe: {runs}{more:if|, ..}. Sie sind überall genau null, wie manche"
        " Programme den Rückweg einer Prüfung in einer Richtung füllen."
    ),
    "CW-R055": (
        "Gerade Läufe wurden nur nach ihrer Nummer als Rückweg genommen (Richtung {back}): Die"
        " Zeilen von Lauf {run} stehen in derselben Reihenfolge wie die von Lauf 1. Ging die"
        " Prüfung nur in einer Richtung, enthält sie weder Umkehrspanne noch Lose."
    ),
    "CW-R056": (
        "Die Datei nennt die Einheit ihrer Abweichungen nicht; Mikroradiant wurde angenommen: Die"
        " größte, {largest}, ist dann {arcsec}″. Mit dem Messgerät vergleichen."
    ),
    "CW-R057": (
        "Die Datei enthält Mittel mehrerer Läufe, keine Messwerte: Sie wird als ein Lauf je"
        " Richtung gelesen, und die Wiederholpräzision ist unbekannt.{way_back:if| Die Mittel des"
        " Rückwegs stehen nicht darin: Sie sind das Doppelte der Mittel beider Richtungen weniger"
        " die des Hinwegs.}"
    ),
    "CW-R058": (
        "Die Datei ist eine Kompensationstabelle der Lasersoftware ({sign}), keine Prüfung: Sie"
        " wird als ein Lauf je Richtung ihrer Fehler gelesen. Für eine Tabelle die Prüfung selbst"
        " verwenden."
    ),
    "CW-R059": (
        "Zeilen ohne Zahl in der Spalte {column} sind weggelassen: Zeile {lines}{more:if| und"
        " {more} weitere}."
    ),
    "CW-R060": "Gelesen{by:if| von {by}}: {readings:join|; }.",
    "CW-R061.sheets": "Weggelassene Blätter: {sheets}{more:if|, ..}.",
    "CW-R061.tests": (
        "Prüfungen derselben Datei ohne Achse sind weggelassen: {tests}. Nur {used} wird verwendet."
    ),
    "CW-R062": (
        "Die Datei ist nicht UTF-8 und wurde als {code_page} gelesen; nur Kommentare und"
        " Spaltennamen hängen davon ab, keine Zahl. Zeile {line} lautet {text}."
    ),
    "CW-R063": (
        "Zeilen, die wie Messwerte aussehen, stehen außerhalb der Messwerte und wurden nicht"
        " gelesen: Zeile {lines}{more:if| und {more} weitere}. Mit dem Messgerät vergleichen."
    ),
    "CW-R064": (
        "In der Arbeitsmappe verborgen und wie der Rest gelesen: {hidden:join|; }. Die Anzahl der"
        " Messwerte mit dem Messgerät vergleichen und herausnehmen, was nicht zur Prüfung gehört."
    ),
    "CW-R064.columns": "{number} {number:plural|Spalte|Spalten} ({columns})",
    "CW-R064.rows": (
        "{number} {number:plural|Zeile|Zeilen}, verborgen oder ausgefiltert (Zeile {rows}{more:if|"
        " und {more} weitere})"
    ),
    "CW-R064.sheet": "das ganze Blatt",
    "reading.deviation": "Abweichung: gemessen minus Ziel",
    "reading.forward": "forward: Anfahrt in Richtung {direction}",
    "reading.fwd": "FWD: Anfahrt in Richtung +, BWD: in Richtung -",
    "reading.unit_mm": "Einheit: mm",
}
