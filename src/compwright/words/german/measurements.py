"""Sentences about the reading of measurement files."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-R001": (
        "Folgendes ist nicht in der Datei angegeben und wurde angenommen: {assumed:join|; }."
    ),
    "CW-R002": "Die Datei nennt ihre Achse nicht. Eine Kommentarzeile '# axis: X' hinzufügen.",
    "CW-R003": (
        "Die Datei enthält gemessene Positionen. Sie wurden in Abweichungen umgerechnet (gemessen"
        " minus Ziel)."
    ),
    "CW-R004": "Das Messgerät hat schon kompensiert: {compensated}.",
    "CW-R005": (
        "Diese Spalten wurden weggelassen: {columns}."
        "{near:if| Ist {near} die Spalte {name}, umbenennen.}"
    ),
    "CW-R006.place": "{target} in Lauf {run}",
    "CW-R006.readings": "{missing} von {readings} Messwerten fehlen: {places}.",
    "CW-R006.rows": (
        "Zeilen ohne Messwert sind weggelassen: Zielposition {targets}{more:if| und {more}"
        " weitere} {unit}. Die Ergebnisse umfassen diese Zielpositionen nicht."
    ),
    "CW-R007": (
        "Es gibt {positive} Läufe in Richtung +, aber {negative} in Richtung −. Entweder wurde ein"
        " Lauf nicht gefahren, oder die Datei ist abgeschnitten: die Datei mit dem Messgerät"
        " vergleichen."
    ),
    "CW-R008": (
        "{count} von {of} Abweichungen sind größer als 1 {unit}. Die größte ist {largest} {unit},"
        " bei der Zielposition {target} {unit}. Die Einheit prüfen{turn:if|, und ob die Messwerte"
        " nach 360° wieder bei 0 beginnen}."
    ),
    "CW-R009": (
        "Alle Abweichungen sind kleiner als 0,000001 {unit}. Die Einheit prüfen, und ob die Achse"
        " wirklich gemessen wurde."
    ),
    "CW-R010": (
        "Jede Abweichung in Lauf {runs} ist genau null, während andere es nicht sind. Manche"
        " Programme füllen einen nicht gefahrenen Lauf mit Nullen: dann den Lauf aus der Datei"
        " entfernen. Das Ergebnis enthält ihn. Streuen die anderen Läufe, entstehen Tabelle und"
        " Vorhersage ohne ihn."
    ),
    "CW-R011": (
        "Die Abweichungen wachsen um etwa 1 {unit} je {unit} Zielposition, wie gemessene"
        " Positionen. Sind es gemessene Positionen, ihre Spalte measured_{unit} nennen."
    ),
    "CW-R012": (
        "Diese Zielpositionen sind fast gleich, und kein Lauf hat Messwerte an beiden: {targets}."
        " Ist eine Zielposition gemeint, ihr in allen Zeilen dieselbe Zahl geben."
    ),
    "CW-R012.pair": "{low:.10g} und {high}",
    "CW-R013": (
        "Der Schlüssel 'deviation: {deviation}' hat keine Wirkung: Die Datei enthält Messwerte,"
        " keine Abweichungen."
    ),
    "CW-R014.forward": (
        "Die Positionen stehen nicht von klein nach groß: an der Maschine prüfen, in welche"
        " Richtung die Vorwärtsläufe fuhren."
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
        "{number} wurde mit Dezimalpunkt gelesen. Aber dieselbe Spalte enthält ganze Zahlen, der"
        " Punkt kann also Tausender trennen. Wenn ja, ihn entfernen."
    ),
    "CW-R030": (
        "Die Messwerte enthalten schon Kalibrierung und Temperaturkorrektur des Messgeräts"
        " (Ausdehnung {expansion} µm/(m K), {temperatures} °C). Beides wurde nicht noch einmal"
        " angewendet."
    ),
    "CW-R031": (
        "Der wahre Vorschub nach Messrate und Zahl der Messpunkte ist {feed:.4g} mm/min, nicht"
        " {programmed:.4g} mm/min wie programmiert. Entweder war ein Override eingestellt, oder"
        " eine Achse folgte nicht. Verwendet wird der wahre Vorschub."
    ),
    "CW-R032": (
        "Lauf {direction} {run} hat nach dem gemessenen Bogen {number} Messwerte"
        " {more:if|mehr|weniger} als davor. Ein Messwert kann doppelt oder verloren sein."
    ),
    "CW-R033": (
        "Die Datei kündigt einen Lauf {sense} an (RUN_SPEC), enthält aber keine Messwerte eines"
        " solchen Laufs."
    ),
    "CW-R034": (
        "In {run} fehlen Messpunkte ab {angle:.6g}°, über {width:.4g}° (Messpunkte liegen"
        " {step:.3g}° auseinander)."
    ),
    "CW-R034.open": (
        "{run} hat keine Messpunkte von {begin:.5g}° bis {end:.5g}°. Ausgewertet ist ein Bogen von"
        " {arc:.5g}°, kein Vollkreis. Entweder fehlen Messpunkte: alle exportieren oder neu messen."
        " Oder nur dieser Bogen wurde gefahren: CW-R034 im Auftrag bestätigen."
    ),
    "CW-R035": (
        "Die größte Abweichung vom Nennradius ist {largest:.4g} mm. Einheit, Nennradius und"
        " Aufbau prüfen."
    ),
    "CW-R036": (
        "Die Abweichungen von {runs} von einem Kreis liegen unter 0,1 µm, der Auflösung eines"
        " Kreisformmessgeräts. Einheit der Abweichungen prüfen, und ob der Lauf gemessen wurde."
    ),
    "CW-R037": (
        "Das Messgerät war für {files} nicht kalibriert. Der absolute Radius wird deshalb für"
        " keinen Lauf dieser Prüfung verwendet."
    ),
    "CW-R038": "{files:and} wurden als die beiden Richtungen einer Prüfung genommen.",
    "CW-R039": (
        "Die andere Richtung kann in {files} sein, aber welche Dateien zusammengehören, ist nicht"
        " sicher, deshalb wurden keine verbunden. Ein Paar nach dem anderen auswerten, oder den"
        " Dateien eines Paars Namen geben, die sich nur durch ccw und cw unterscheiden."
    ),
    "CW-R050": (
        "In dieser Prüfung in zwei Richtungen wurden diese Zielpositionen nur in einer Richtung"
        " angefahren und weggelassen: {targets}."
    ),
    "CW-R051": (
        "Die letzte Zeile endet nach {number} ohne Zeilenumbruch (Zeile {line}). Die Datei kann"
        " beim Kopieren abgeschnitten worden sein: Ziffern oder spätere Messwerte können fehlen."
        " Mit dem Messgerät vergleichen."
    ),
    "CW-R052": (
        "Diese Dateien des Ordners wurden übersprungen, denn ihre Endungen sind nicht die von"
        " Messdateien: {files}."
    ),
    "CW-R053.environment": (
        "Der Abschnitt ENVIRONMENT:: fehlt nach den Mittelwerten. Die Datei kann abgeschnitten"
        " sein: mit dem Messgerät vergleichen."
    ),
    "CW-R053.header": (
        "Nach ihrem Schlüssel {key} hat die Datei {promised}"
        " {what:choose|targets=Zielpositionen|runs=Läufe}, sie enthält aber {found}. Sie kann"
        " abgeschnitten sein: mit dem Messgerät vergleichen."
    ),
    "CW-R053.last_run": (
        "Die letzten Zeilen gehören zu Lauf {run}, dem {lacking} von {readings} Messwerten"
        " fehlen, während die anderen Läufe alle haben. Die Datei kann abgeschnitten sein: mit"
        " dem Messgerät vergleichen."
    ),
    "CW-R053.last_target": (
        "Die letzten Zeilen gehören zu Zielposition {target}, der {lacking} von {readings}"
        " Messwerten fehlen, während die anderen alle haben. Die Datei kann abgeschnitten sein:"
        " mit dem Messgerät vergleichen."
    ),
    "CW-R053.no_end": (
        "Die Endemarke EOF:: fehlt; die letzte Zeile ist {text} (Zeile {line}). Die Datei kann"
        " abgeschnitten sein, Ziffern oder Messwerte können fehlen. Mit dem Messgerät"
        " vergleichen."
    ),
    "CW-R053.one_direction": (
        "Die Datei enthält nur die Richtung {direction}. In diesem Dateiformat stehen alle"
        " Messwerte der einen Richtung vor denen der anderen. Die zweite kann also abgeschnitten"
        " sein: die Datei mit dem Messgerät vergleichen."
    ),
    "CW-R053.run_count": (
        "Nach ihrem Schlüssel Run-count hat die Datei {promised} Läufe, sie enthält aber {found}."
        " Entweder ist die Datei abgeschnitten, oder die Prüfung wurde abgebrochen. Mit dem"
        " Messgerät vergleichen."
    ),
    "CW-R053.share": (
        "{share:.0%} der Messwerte fehlen. Entweder ist die Datei abgeschnitten, oder Zeilen"
        " gingen verloren. Mit dem Messgerät vergleichen."
    ),
    "CW-R054": (
        "Diese Läufe wurden weggelassen, denn alle ihre Werte sind genau null: {runs}{more:if|,"
        " ..}. Manche Programme füllen den Rückweg einer Prüfung in einer Richtung mit Nullen."
    ),
    "CW-R055": (
        "Gerade Läufe gelten nur wegen ihrer geraden Nummer als Rückweg (Richtung {back}): Die"
        " Zeilen von Lauf {run} stehen in derselben Reihenfolge wie die von Lauf 1. Gingen alle"
        " Läufe der Prüfung in dieselbe Richtung, bedeuten ihre Werte für Umkehr und Lose nichts."
    ),
    "CW-R056": (
        "Die Datei nennt die Einheit ihrer Abweichungen nicht, deshalb wurde Mikroradiant"
        " angenommen. Die größte Abweichung, {largest}, ist dann {arcsec}″. Mit dem Messgerät"
        " vergleichen."
    ),
    "CW-R057": (
        "Die Datei enthält Mittelwerte mehrerer Läufe, keine einzelnen Messwerte. Sie wird als ein"
        " Lauf je Richtung gelesen, und die Wiederholpräzision ist unbekannt.{way_back:if| Die"
        " Mittelwerte des Rückwegs sind nicht in der Datei: Sie wurden aus den Mittelwerten beider"
        " Richtungen berechnet (2 × Mittel beider Richtungen − Mittel des Hinwegs).}"
    ),
    "CW-R058": (
        "Die Datei ist eine Kompensationstabelle der Lasersoftware ({sign:if|{sign}|Vorzeichen nach"
        " dem Profil}), keine Prüfung. Sie wird als ein Lauf je Richtung mit den Fehlern dieser"
        " Tabelle gelesen. Für eine Tabelle die Messdatei der Prüfung angeben."
    ),
    "CW-R059": (
        "Zeilen ohne Zahl in der Spalte {column} sind weggelassen: Zeile {lines}{more:if| und"
        " {more} weitere}."
    ),
    "CW-R060": "Gelesen{by:if| von {by}}: {readings:join|; }.",
    "CW-R061.sheets": "Weggelassene Blätter: {sheets}{more:if|, ..}.",
    "CW-R061.tests": (
        "Prüfungen derselben Datei, die ihre Achse nicht nennen, sind weggelassen: {tests}. Nur"
        " {used} wird verwendet."
    ),
    "CW-R062": (
        "Die Datei ist nicht UTF-8 und wurde als {code_page} gelesen. Zeile {line} lautet dann"
        " {text}. Nur Kommentare und Spaltennamen hängen davon ab, keine Zahl."
    ),
    "CW-R063": (
        "Einige Zeilen sehen aus wie Messwerte, stehen aber außerhalb des Abschnitts der"
        " Messwerte und wurden nicht gelesen: Zeile {lines}{more:if| und {more} weitere}. Mit dem"
        " Messgerät vergleichen."
    ),
    "CW-R064": (
        "Diese Teile der Arbeitsmappe sind ausgeblendet, wurden aber wie der Rest gelesen:"
        " {hidden:join|; }. Die Zahl der Messwerte mit dem Messgerät vergleichen. Entfernen, was"
        " nicht zur Prüfung gehört."
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
