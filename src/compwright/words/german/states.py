"""Sentences about a control's files: their contents, and differences between two sets of files."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F011.feed": (
        "bei {feed:g} {unit}/min ({of:choose|option=Option max_feed|rapid=Eilgang, Parameter"
        " 1420}) müssen die Tabellenpunkte mindestens {least:g} {unit} auseinanderliegen. Regel"
        " der Steuerung: Vorschub geteilt durch {rule} ({evidence})"
    ),
    "CW-S001": (
        "{file}: Die letzte Zeile endet nicht mit einem Zeilenumbruch. Die Datei kann"
        " abgeschnitten sein: prüfen, ob sie vollständig ist"
    ),
    "CW-S002": (
        "{file}: Die Endemarke {mark} fehlt. Die Datei kann abgeschnitten sein: prüfen, ob sie"
        " vollständig ist"
    ),
    "CW-S003": (
        "{label}: Die Dateien geben {quantity} mehrfach an. Verwendet wird der"
        " {rule:choose|first=erste|last=letzte|={rule}} Wert: {value} ({where})"
    ),
    "CW-S004.not_zero": (
        "{label}: Hinter dem Ende der Tabelle {values:plural|steht noch {values} Wert|stehen noch"
        " {values} Werte} ({first} bis {last}), davon {not_zero} nicht null. Die Steuerung"
        " verwendet sie nicht. Sie gehören zu einer älteren, längeren Tabelle, oder Ende oder"
        " Abstand dieser Tabelle sind falsch: beides prüfen"
    ),
    "CW-S004.zero": (
        "{label}: Hinter dem Ende der Tabelle {values:plural|steht noch {values} Wert, er ist"
        " null. Die Steuerung verwendet ihn nicht|stehen noch {values} Werte, alle null. Die"
        " Steuerung verwendet sie nicht}"
    ),
    "CW-S005": (
        "{label}: {quantity} ist nicht in den Dateien; angenommen wird {value}. Hat die Steuerung"
        " einen anderen Wert, sind Tabellen und Korrekturen um den Unterschied falsch. Den Wert"
        " an der Steuerung nachsehen oder die Datei hinzufügen, die ihn enthält"
    ),
    "CW-S006": (
        "Achse {axis}: Mehrere Messsysteme haben eine Kompensationstabelle. Gezeigt wird nur die"
        " Tabelle von System {system}"
    ),
    "CW-S007": "{label}: Die Tabelle ist ohne Wirkung ({switch})",
    "CW-S008": (
        "{label}: Keine Datei enthält eine Kompensationstabelle. Es wird angenommen, dass die"
        " Steuerung dafür keine hat"
    ),
    "CW-S009": (
        "{label}: Die Steuerung beachtet {what} nicht, denn die Achse {why:choose|table=hat eine"
        " Tabelle|rotary=ist eine Drehachse}"
    ),
    "CW-S010": (
        "Achse {axis} des Auftrags gilt als Achse {address} der Steuerung. Das an der Steuerung"
        " prüfen und der Achse im Auftrag ihre `address` geben"
    ),
    "CW-S011": (
        "{label} korrigiert {output} über {input}. Sie bleibt, wie sie ist: {why}. {active:if|Sie"
        " ist aktiv, vor und nach dem Laden gleich|Sie ist ausgeschaltet}"
    ),
    "CW-S012.assignments": (
        "{file} ist nicht aktiv: Die aktive Zeile, die den Achsen Tabellen zuordnet, nennt die"
        " Datei nicht"
    ),
    "CW-S012.no_axis": "Die Steuerung lädt {file} nicht: Keine Achse nennt diese Datei",
    "CW-S012.no_table": (
        "Die Steuerung lädt keine Tabelle aus {files}{more:if| und {more} weiteren}: Keine Achse"
        " nennt eine solche Datei, und keine davon enthält eine Tabelle"
    ),
    "CW-S012.not_given": (
        "{file} ist aktiv, wenn {axis} sich bewegt, aber diese Datei wurde nicht gegeben. Ihre"
        " Wirkung auf andere Achsen ist unbekannt: die Datei hinzufügen"
    ),
    "CW-S012.start_up_list": (
        "Die Steuerung lädt {file} nicht: Die Anlaufliste nennt diese Datei nicht"
    ),
    "CW-S013": (
        "{file}, Zeile {line}: Kein Handbuch zeigt eine Zeile dieser Form. Sie wurde trotzdem"
        " gelesen. Prüfen, ob sie richtig gelesen ist. {lines} {lines:plural|Zeile|Zeilen} der"
        " Datei {lines:plural|hat|haben} diese Form"
    ),
    "CW-S014": (
        "die Achsen {addresses:and} teilen sich die Nummern {first} bis {last} der"
        " Kompensationspunkte. Eine Änderung für die eine Achse würde auch die andere ändern,"
        " deshalb bekommt eine neue Tabelle eigene Nummern"
    ),
    "CW-S015": (
        "{label}: Vorschub und Eilgang haben verschiedene Losekompensation ({feed} und {rapid};"
        " {why}). Gezeigt wird hier die {rapid_shown:if|des Eilgangs (1852)|des Vorschubs"
        " (1851)}. Eine neue Tabelle ändert beide Werte um denselben Betrag, ihr Unterschied"
        " bleibt"
    ),
    "CW-S016": (
        "{label}: Auf einer vollen Umdrehung sind die Kompensationspunkte {first} und {last}"
        " dieselbe Position. Punkt {first} sollte den Wert von Punkt {last} haben ({value:g})"
    ),
    "CW-S017": (
        "Achse {axis}: Die Tabelle in {file} umfasst eine volle Umdrehung, aber ihr letzter Wert"
        " ist anders als ihr erster"
    ),
    "CW-S018": (
        "{label}: Die Referenzposition ist nicht der Maschinennullpunkt (1240). Es wird"
        " angenommen, dass die Steuerung die Kompensationspunkte von {reference:g} an zählt"
        " (Option reference); das ist unbestätigt. Die Korrektur an zwei Positionen prüfen"
    ),
    "CW-S019": (
        "{label}: Die Achse wird im Durchmesser programmiert (1006#3). Positionen, Abstand und"
        " Korrekturen gelten als Radiuswerte; das ist unbestätigt. Der übliche Fehler ist ein"
        " Faktor 2, deshalb nach dem Laden die Korrektur an einer Position prüfen"
    ),
    "CW-S030": (
        "die Achsen {leading} und {partner} bilden ein Gantry, aber ihre Korrekturen sind"
        " verschieden"
    ),
    "CW-S031.gantry": (
        "die Achsen {axis} und {other} haben dieselbe Tabelle. Bilden sie ein Gantry, der Achse"
        " {axis} im Auftrag `gantry: {other}` geben, damit beide die neue Tabelle bekommen. Eine"
        " neue Tabelle auf nur einer verspannt das Gantry"
    ),
    "CW-S031.single": (
        "die Achsen {axis} und {other} haben dieselbe Tabelle. Nach den Dateien der Steuerung"
        " gehört Achse {axis} zu keinem Gantry"
    ),
    "CW-S032": "{label}: Alle Werte und das Raster sind null. Das heißt, es gibt keine Tabelle",
    "CW-S033.ends": (
        "{label} ist eine endlos drehende Achse, aber ihre Tabelle wiederholt sich nicht: Die"
        " Tabelle hat zwei Enden"
    ),
    "CW-S033.repeats": (
        "{label}: Die vorhandene Tabelle wiederholt sich alle {period:g}, aber der Auftrag nennt"
        " für diese Achse kein `modulo`. Eine neue Tabelle wiederholt sich nicht: Sie hat zwei"
        " Enden"
    ),
    "CW-S034": (
        "{label} ist in den Dateien ausgeschaltet ({switches}) und korrigiert deshalb nichts"
    ),
    "CW-S035": (
        "Achse {axis}: Nach dem Auftrag bewegt sich diese Achse allein, aber {parameter} kann sie"
        " mit einer anderen koppeln. Die Kopplung in jeder Prüfung ausgeschaltet lassen. Die"
        " Tabellen beider Achsen laden, bevor die Kopplung wieder benutzt wird"
    ),
    "CW-S036": (
        "Wie der Auftrag sagt, bekommt Achse {gantry} {table:choose|same=dieselbe Tabelle wie"
        " Achse {axis}|change=ihre eigene vorhandene Tabelle und dazu dieselbe Änderung wie Achse"
        " {axis}}. Nachher unterscheiden sich die Korrekturen beider Achsen um bis zu {after:.2f}"
        " {unit}, vorher um bis zu {before:.2f} {unit}. An keiner Position ändert sich der"
        " Unterschied um mehr als {moved:.2f} {unit}"
    ),
    "CW-S037": (
        "Achse {axis}: Achse {follows} folgt ihr als zweiter Antrieb ohne eigene Position"
        " ({parameter}). Die Tabelle der Achse {axis} korrigiert beide"
    ),
    "CW-S038": (
        "Die Achsen {axis} und {gantry} des Gantrys laufen um bis zu {moved:.2f} {unit} auseinander"
        " (Grenze {limit:.2f} {unit}), während Achse {axis} um {gain:.2f} {unit} besser wird. Die"
        " Ursache: Die Punkte ihrer Tabellen liegen an verschiedenen Positionen. Beiden Achsen in"
        " der Steuerung dieselben Punkte geben oder im Auftrag `table: same` angeben"
    ),
    "CW-S040": (
        "{label}: {bits} = 1 ({value}). Echte Maschinen verwenden diese Einstellung, aber ihre"
        " Bedeutung ist nicht bestätigt; sie bleibt, wie sie ist. Sie kann interpolierende"
        " Kompensation bedeuten: dann die Option output: ramp angeben"
    ),
    "CW-S041": (
        "{label}: Bei einer vollen Umdrehung hat im Handbuch {own} die gleiche Nummer wie {zero},"
        " in den Dateien aber ist {own} = {first}, eins mehr als {zero}. Die Nummern {first} bis"
        " {last} werden als Abschnitte der Umdrehung gelesen; Nummer {reference} bleibt für die"
        " Achse reserviert"
    ),
    "CW-S042": (
        "Achse {axis} hat ungewöhnliche Einstellungen und bleibt mit allen ihren"
        " Kompensationspunkten unverändert: {reasons:join|; }"
    ),
    "CW-S043": (
        "{label}: {systems}. Davon hängt die Erfassungseinheit ab, in der die Korrekturen gezählt"
        " sind. Vor dem Laden 1013 an der Anzeige der Steuerung prüfen"
    ),
    "CW-S044": (
        "{label}: Die Achse fährt nach 1006#5 in Richtung {files} zur Referenzposition, nach dem"
        " Auftrag aber in Richtung {job}. Es gilt der Auftrag. Ist er falsch, ist nur der"
        " Nullpunkt um die Lose verschoben, denn es gibt eine Tabelle für beide Richtungen. Mit"
        " zwei Tabellen wird dieser Widerspruch abgelehnt"
    ),
    "CW-S045": (
        "{label}: Der Verfahrweg des Auftrags reicht {outside:g} {unit} über die Grenzen der"
        " Achse in der Steuerung hinaus, {low:g} bis {high:g} ({parameters}). Prüfen, ob"
        " Verfahrweg und Zielpositionen Maschinenkoordinaten sind"
    ),
    "CW-S046": (
        "{file}: Die Tabellenpunkte liegen nicht gleich weit auseinander ({least:.10g} bis"
        " {most:.10g}), obwohl die Steuerung gleiche Abstände verlangt. Sie werden gelesen, wie"
        " sie sind; eine neue Tabelle bekommt gleiche Abstände"
    ),
    "CW-S047": (
        "{label}: Die weiche Losekompensation gibt den Losewert 1851 in Stufen aus"
        " ({parameters}). Sie bleibt, wie sie ist. Die letzte Stufe wirkt spätestens {reach:g}"
        " {unit} nach einer Umkehr (unbestätigt). Davor weicht die Losekompensation von 1851 ab,"
        " in Prüfungen und bei der Bearbeitung"
    ),
    "CW-S048": "{label}: {function}",
    "CW-S049.none": (
        "{suggested}. Der Auftrag nennt keine Spindelsteigung. Die Suche nach periodischen Fehlern"
        " nimmt deshalb diese Periode als die wahrscheinlichste an. Ist sie die Spindelsteigung,"
        " der Achse `screw_pitch: {lead:key}` geben"
    ),
    "CW-S049.other": (
        "{suggested}. Der Auftrag nennt stattdessen {periods:g}, und der Auftrag gilt: die"
        " Steigung an der Spindel prüfen"
    ),
    "CW-S049.suggested": (
        "{label}: Nach den Dateien der Steuerung bewegt eine Umdrehung des Motors die Achse um"
        " {lead:g} {unit} ({evidence}). Fehler können sich mit dieser Periode wiederholen"
    ),
    "CW-S050.cec": (
        "{label} korrigiert {output} über {input}. Sie bleibt, wie sie ist: {why}. {active:if|Sie"
        " ist aktiv, vor und nach dem Laden gleich|Sie ist ausgeschaltet}"
    ),
    "CW-S050.list": "{label} bleibt, wie sie ist, und ihre Korrekturen werden nicht gezeigt: {why}",
    "CW-S050.sum": (
        "Die CEC-Tabellen {tables} korrigieren Achse {output}. Ihre Summe reicht von {low:g} bis"
        " {high:g}, aber MD32720 $MA_CEC_MAX_SUM begrenzt die Summe auf {limit:g}. Die Tabellen"
        " bleiben, wie sie sind: aktiv, vor und nach dem Laden gleich"
    ),
    "CW-S051": (
        "Die Tabellen, die eine Achse über eine andere korrigieren ({pairs}), bleiben, wie sie"
        " sind, und werden nicht gezeigt, denn das Vorzeichen der CEC-Werte an dieser Steuerung"
        " ist unbekannt. Das Vorzeichen nach der Inbetriebnahmekarte prüfen, dann die Option"
        " cec_sign angeben"
    ),
    "CW-S052": (
        "Achse {axis}: Der Auftrag nennt Messsystem {number}, aber in den Dateien ist die"
        " Kompensation für System {other} eingeschaltet (MD32700). Sicherstellen, dass die Achse"
        " System {number} benutzt"
    ),
    "CW-S053": (
        "Achse {axis}: Außer der Tabelle ist diese Kompensation aktiv: {functions:join|; }. Sie"
        " bleibt, wie sie ist. Es wird angenommen, dass sie während der Prüfung und nach dem"
        " Laden gleich wirkt"
    ),
    "CW-S054": (
        "Die CEC-Tabellen {tables} bleiben, wie sie sind. Alle ihre Werte sind 0, sie korrigieren"
        " also nichts"
    ),
    "CW-S055": (
        "Die Werte der CEC-Tabellen sind so gezeigt, als bewege ein positiver Wert die Achse in +."
        " Nach dem Handbuch von Siemens (Erweiterungsfunktionen 03/2009, Seite 372) bewegt ein"
        " positiver Wert die Achse in −, also umgekehrt. Das Vorzeichen nach der"
        " Inbetriebnahmekarte prüfen, dann die Option cec_sign angeben"
    ),
    "CW-S056": (
        "Achse {axis}: {period:if|Die vorhandene Tabelle wiederholt sich alle {period:g}, aber der"
        " Auftrag nennt für diese Achse kein `modulo`. Eine neue Tabelle wiederholt sich nicht: Sie"
        " hat zwei Enden|Die Achse dreht endlos, aber ihre Tabelle wiederholt sich nicht: Die"
        " Tabelle hat zwei Enden}"
    ),
    "CW-S057": (
        "{format}: Die Bedeutung der Parameter {parameters} bei dieser Baureihe ist unbekannt"
        " ({place}); bei anderen Baureihen sind es Einheiten, Pfade oder weitere Kompensation. Sie"
        " bleiben, wie sie sind, und werden nicht mit dem Auftrag verglichen. Im Handbuch der"
        " Steuerung nachsehen. Ist einer davon eine Kompensation, die Punkte der vorhandenen"
        " Tabelle behalten: Eine neue Tabelle mit anderen Punkten berücksichtigt diese"
        " Kompensation nicht"
    ),
    "CW-S060": (
        "Die Tabelle wurde aus ihren Dateien zurückgelesen, aber nicht unabhängig geprüft: Nur"
        " Ihre eigene Definition von {definition} sagt, was diese Dateien tun. Ein falsches"
        " Vorzeichen oder eine falsche Einheit in der Definition macht jedes Ergebnis hier falsch."
        " Die Korrektur an der Maschine prüfen, an einer Position und von beiden Seiten, bevor die"
        " ganze Tabelle aktiv ist{expectation:if|. Eine Definition wird mit von Hand gerechneten"
        " Korrekturen geprüft. {definition} hat keine eigenen, deshalb wurden die von"
        " {expectation} verwendet}"
    ),
    "CW-S061": (
        "{what}. Stattdessen wird die Definition von {carried} im Plan verwendet. Für eine andere"
        " Definition den Auftrag neu rechnen"
    ),
    "CW-S062": "das Steuerungsformat {name} bedeutet {definition}: {title}",
    "CW-S070": (
        "{file}: Darin sind Programme, die Kompensation laden oder ein- und ausschalten:"
        " {programs}. Sie wurden hier nicht ausgeführt. Das Ergebnis ist das der Daten des"
        " Archivs selbst; lief ein solches Programm danach, weicht die Steuerung davon ab"
    ),
    "CW-S071": (
        "{file}: Die Steuerung lädt keine Datei mit Dezimalkommas, dies ist also eine Auflistung."
        " Die Kommas werden als Dezimalpunkte gelesen. Die Steuerung kann andere Werte enthalten:"
        " einige vergleichen"
    ),
    "CW-S072": (
        "{file}: Nichts in diesem Archiv zeigt, ob ein Wert nach dem Export geändert wurde. Die"
        " Inbetriebnahmekarte des Laufs nennt bis zu drei Werte je Achse. Vor dem Laden diese mit"
        " der Anzeige der Steuerung vergleichen"
    ),
    "CW-S073": (
        "{file}: Nach dem Auftrag hat die Steuerung diese Datei nie ausgeführt (active: no). Ihre"
        " Tabellen und Losewerte gelten als nicht geladen"
    ),
    "CW-S080": (
        "{files}: Für {axis:if|Achse {axis}|diese Dateien} lässt sich die Korrektur, die die"
        " Steuerung ausführt, aus den Dateien nicht berechnen ({faults:join|; }{more:if|; und"
        " {more} weitere|}). Verglichen werden nur die einzelnen Einträge der Dateien"
    ),
    "CW-S081": (
        "{files}: compwright liest solche Dateien auf zwei unabhängige Arten. Nur eine davon"
        " konnte diese Korrekturen lesen; die andere meldet: {why}"
    ),
    "CW-S082": (
        "{files}: Einige dieser Dateien enthalten keine Daten der Steuerung und werden nicht"
        " verglichen: {idle}"
    ),
    "CW-S083.new": (
        "{new:plural|{new} Kompensationswert, der zurückgelesen wurde, ist|{new}"
        " Kompensationswerte, die zurückgelesen wurden, sind} in keiner Datei des Plans und"
        " {new:plural|wurde|wurden} nicht verglichen"
    ),
    "CW-S083.not_read": (
        "{missing} {missing:plural|Kompensationswert|Kompensationswerte} der Dateien des Plans"
        " {missing:plural|wurde|wurden} nicht zurückgelesen und deshalb nicht verglichen"
    ),
    "CW-S084": (
        "{files}: weggelassen, denn diese Dateien des Ordners enthalten keine Zeile im Format"
        " {format}"
    ),
    "CW-S085": (
        "{path} wurde von compwright run geschrieben, nicht aus der Steuerung zurückgelesen. Das"
        " zeigt nicht, was in der Steuerung ist. Die Daten aus der Steuerung sichern und diese"
        " Datei angeben"
    ),
    "CW-S086": (
        "Keine Datei sagt, ob {number:plural|Achse {names} eine Linear- oder Drehachse ist|die"
        " Achsen {names} Linear- oder Drehachsen sind}. Die Einheit der Korrekturen ist unbekannt:"
        " Tausendstel mm (µm) oder Grad (3,6″). --option kind=linear oder --option kind=rotary"
        " angeben."
    ),
    "CW-S087": (
        "Die Tabelle der Achse {output} über Achse {input} wurde nicht vollständig ausgelesen: Es"
        " fehlt {value}{more:if| und {more} weitere}. Ob diese Tabelle geladen und aktiv ist, ist"
        " nicht bekannt. Auch diese Werte aus der Steuerung auslesen und ihre Dateien mit"
        " `--loaded` angeben."
    ),
    "CW-S087.assumed": (
        "{fact}: als {value} gezählt ({evidence}). In den Dateien des Plans ist es angegeben, in"
        " den ausgelesenen nicht; der Vergleich hängt von dieser Annahme ab. Auch diesen Wert"
        " aus der Steuerung auslesen und seine Datei mit `--loaded` angeben."
    ),
    "CW-S087.typed": (
        "Die ausgelesenen Dateien enthalten keine Tabelle der Achse {output} über Achse {input}. Ob"
        " die Werte des Eingabeblatts eingetippt wurden, ist nicht bekannt. Auch diese Tabelle aus"
        " der Steuerung auslesen und ihre Datei mit `--loaded` angeben."
    ),
    "CW-S088.coupled": (
        "Die ausgelesenen Dateien koppeln Achse {axis} mit einer anderen Achse ({parameter}), die"
        " des Plans nicht. Eine Tabelle auf nur einer von zwei gekoppelten Achsen verspannt die"
        " Maschine. Diesen Parameter an der Steuerung prüfen. Ist er richtig, ihn im Auftrag"
        " angeben (`gantry`) und den Auftrag mit diesen Dateien erneut ausführen."
    ),
    "CW-S088.changed": (
        "Ein Parameter, der Achse {axis} mit einer anderen Achse koppelt, ist {parameter} in den"
        " ausgelesenen Dateien und {was} in denen des Plans. Eine Tabelle auf nur einer von zwei"
        " gekoppelten Achsen verspannt die Maschine. Diesen Parameter an der Steuerung prüfen. Ist"
        " er richtig, die Kopplung im Auftrag angeben (`gantry`) und den Auftrag mit diesen Dateien"
        " erneut ausführen."
    ),
}
