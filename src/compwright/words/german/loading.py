"""What a test after loading shows."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-V001": "{verdict}",
    "CW-V010": "Achse {axis}: Was aus der Steuerung zurückgelesen wurde, ist die geplante Tabelle.",
    "CW-V011": (
        "Achse {axis}: Was aus der Steuerung zurückgelesen wurde, weicht um bis zu {difference:.2f}"
        " {unit} vom Plan ab."
    ),
    "CW-V020": (
        "Die Prüfung nach dem Laden deckt nicht ab, was die erste abdeckte: {gaps:join|; }."
        " {targets} Zielpositionen von {range} messen, wie zuvor."
    ),
    "CW-V020.approaches": (
        "sie hat {runs} {runs:plural|Anfahrt|Anfahrten} in {direction} (die erste Prüfung: {first})"
    ),
    "CW-V020.fewer": "sie hat {targets} {targets:plural|Zielposition|Zielpositionen}",
    "CW-V020.fewest": (
        "sie hat {targets} {targets:plural|Zielposition|Zielpositionen}, und die Norm verlangt"
        " mindestens {fewest}"
    ),
    "CW-V020.gap": "{gap} des Verfahrwegs sind ohne Zielposition",
    "CW-V020.range": "sie umfasst {range}",
    "CW-V021": (
        "Wiederholte Messwerte streuen um {scatter}, {ratio:3sig}-mal {less:if|weniger|mehr} als"
        " in der ersten Prüfung ({first}): Wo sich das Rauschen zweier Prüfungen bis zu"
        " {factor:g}-mal unterscheidet, kommt das zufällig seltener als einmal in 1000 Prüfungen"
        " vor. Stimmen Einheit und Messwerte? Neu messen, mit dem Messgerät eingestellt wie bei"
        " der ersten Prüfung."
    ),
    "CW-V022": (
        "Der Auftrag wurde nach der Berechnung geändert: {what:choose|standard=die Norm|rule=die"
        " Entscheidungsregel|axis_limits=die Grenzwerte der Achse {of}|circle_limits=die Grenzwerte"
        " des Kreises {of}|uncertainty=die angegebene Unsicherheit der Achsen"
        " {of}|circle_uncertainty=die angegebene Unsicherheit der Kreisformprüfungen}"
        " {several:if|waren|war} {was:if|{was}|keine}, jetzt {several:if|sind sie|ist sie}"
        " {now:if|{now}|keine}. Den Auftrag neu rechnen, damit Vorhersage und Urteil dieselben"
        " Werte verwenden."
    ),
    "CW-V023.axis": (
        "Achse {axis} wurde nach dem Laden nicht gemessen, für sie ist nichts bewiesen. Messen wie"
        " für die Prüfung {test}."
    ),
    "CW-V023.circle": (
        "Kreis {circle} hat Grenzwerte und wurde nach dem Laden nicht gemessen, für ihn ist nichts"
        " bewiesen. Neu messen und als --after {circle}=FILE angeben."
    ),
    "CW-V023.scale": (
        "Der Maßstab der Achse {axis} kam aus Kreisen, und keiner wurde nach dem Laden gemessen,"
        " für sie ist nichts bewiesen. Den Kreis {circles:if|{circles:join| oder }|dieser Ebene}"
        " neu messen."
    ),
    "CW-V023.squareness": (
        "Die Rechtwinkligkeit von {plane} wurde korrigiert und nach dem Laden nicht gemessen, für"
        " sie ist nichts bewiesen. Den Kreis {circles:if|{circles:join| oder }|dieser Ebene} neu"
        " messen."
    ),
    "CW-V023.test": (
        "Die Grenzwerte der Achse {axis} gelten für die Prüfung {meant}, gemessen wurde {measured},"
        " für sie ist nichts bewiesen. Messen wie für {meant} und als --after {meant}=FILE angeben."
    ),
    "CW-V024": "Die Prüfung nach dem Laden, {code}: {finding} Das klären oder neu messen.",
    "CW-V025": (
        "Die mit --after angegebene Datei des Kreises {circle} ist eine von vor dem Laden. Den"
        " Kreis neu messen."
    ),
    "CW-V026.certain": (
        "Das kann nicht stimmen: {why}. Die Prüfung in der Einheit exportieren, die ihre Datei"
        " nennt."
    ),
    "CW-V026.copied": (
        "Die Messwerte sind die der Prüfung {test} von vor dem Laden{way:choose|same=|sign=, mit"
        " gedrehtem Vorzeichen|direction=, mit vertauschten Richtungen}. Die Achse neu messen."
    ),
    "CW-V026.file_twice": (
        "Die Prüfung der Achse {axis} enthält eine Datei zweimal. Jede Messung einmal angeben."
    ),
    "CW-V026.one_run": (
        "Alle Läufe enthalten dieselben Messwerte: Ein Lauf wurde kopiert. Die Achse neu messen."
    ),
    "CW-V026.scatter": (
        "Die Streuung der Messwerte ist Lauf für Lauf die der Prüfung {test} (Korrelation"
        " {correlation:.2f}): Die Prüfung wurde daraus gemacht. Die Achse neu messen."
    ),
    "CW-V026.targets": (
        "Die Zielpositionen der Prüfung sind in {unit}, nicht in mm. In mm exportieren."
    ),
    "CW-V026.thousand": (
        "Die Messwerte streuen um {scatter}, die der ersten Prüfung um {first}: 1000-mal zu"
        " {small:if|klein (mm als µm gelesen)|groß (µm als mm gelesen)}. Die Prüfung in der Einheit"
        " exportieren, die ihre Datei nennt."
    ),
    "CW-V026.two_axes": (
        "Achse {axis} und Achse {other} bekamen dieselbe Messung. Jeder Achse ihre eigene geben."
    ),
    "CW-V026.zeros": (
        "Jeder Messwert der Prüfung ist derselbe: Es wurde nichts gemessen. Die Achse messen."
    ),
    "CW-V027": "{verdict}",
    "CW-V028": "{verdict}",
    "CW-V030": (
        "Prüfungen {off} (ohne sie) und {on} (mit ihr): Die Tabelle des Zustands {state} war aktiv,"
        " wie ihre Dateien sagen, zu {percent:.1f} % sicher."
    ),
    "CW-V031": (
        "Die Prüfungen {off} (ohne sie) und {on} (mit ihr) zeigen nicht, ob die Tabelle des"
        " Zustands {state} aktiv war, wie ihre Dateien sagen: {likely:if|{likely}|keine bekannte"
        " Ursache passt}. Sie zählen, so weit sie übereinstimmen."
    ),
    "headline.active": "{tables:plural|Tabelle|Tabellen} aktiv. Keine Grenzwerte angegeben.",
    "headline.bad": "Nicht gut: siehe die {circles:if|Kreise|Achsen} unten",
    "headline.good": (
        "Gut: Die Tabellen sind aktiv, und die Grenzwerte sind eingehalten{without:if| (keine"
        " Grenzwerte für {without} angegeben)|}"
    ),
    "headline.undecided": "Offen: Die Prüfungen zeigen es nicht",
    "loading.as_before": "Sie liegt innerhalb von {left} dessen, was die Steuerung vorher tat.",
    "loading.as_predicted": "Sie liegt innerhalb von {left} der Vorhersage.",
    "loading.candidate": "{name} ({sure:if|über 99|{percent:2sig}} %)",
    "loading.declared_slope": (
        "Über den Verfahrweg steigen ihre Abweichungen um {slope:+.2f} ± {error:.2f} µm/m mehr als"
        " erwartet: Stahl tut das über {kelvin:+2sig} K, {within:if|innerhalb|jenseits} dessen, was"
        " der Auftrag für zwei Prüfungen angibt (± {declared:.1f} µm/m, k = 2). Die Tabelle ist"
        " nicht schuld, aber über die Grenzwerte wird mit der Steigung in den Messwerten"
        " entschieden."
    ),
    "loading.effect": "{part:.2f} ± {error:.2f} der geplanten Wirkung",
    "loading.equivalent": (
        "Dieselbe Prüfung käme von: {names}. Keine Messung dieser Achse unterscheidet sie;"
        " {read_back:if|die aus der Steuerung zurückgelesenen Werte sind die des Plans"
        " (--loaded)|die aus der Steuerung zurückgelesenen Werte tun es (--loaded)}."
    ),
    "loading.evidence": (
        "Gegen die Vorhersage weicht die Prüfung um {off} und höchstens um {worst} ab; mit dieser"
        " Erklärung bleiben {left}, und das Rauschen eines Messwerts ist {noise}.{effect:if|"
        " Gemessen: {effect}.}"
    ),
    "loading.likely": "{verdict} {percent:.0f} %",
    "loading.measurement": (
        "Die Prüfung nach dem Laden ist erklärt, wenn {fault:choose|sign=das Vorzeichen ihrer"
        " Abweichungen gedreht ist|direction=ihre Richtungen + und − vertauscht sind|unit=ihre"
        " Messwerte mit {factor:4sig} multipliziert sind|wrong_axis=sie eine von {axis} ist}. So,"
        " wie sie ist, erklärt sie nichts. {fault:choose|sign=Vorzeichen und Richtungen des"
        " Messgeräts prüfen und die Prüfung neu exportieren.|direction=Vorzeichen und Richtungen"
        " des Messgeräts prüfen und die Prüfung neu exportieren.|unit=In der Einheit exportieren,"
        " die ihre Datei nennt.|wrong_axis=Diese Achse messen oder die Datei ihrer eigenen Achse"
        " geben.}"
    ),
    "loading.name": "{name}{detail:if|: {detail}}",
    "loading.neither": (
        "Die Prüfung nach dem Laden passt weder zur geladenen Tabelle noch zur Steuerung, wie sie"
        " vorher war, noch zu einem bekannten Fehler beim Laden.{loaded:if| Gegen die Vorhersage"
        " weicht sie um {loaded} und höchstens um {loaded_worst} ab.}{inactive:if| Gegen keine"
        " Änderung weicht sie um {inactive} und höchstens um {inactive_worst} ab.}{offset:if| Gegen"
        " die Vorhersage liegen die Anfahrten in + im Mittel {offset} {above:if|über|unter} denen"
        " in −.}{effect:if| Gemessen: {effect}.}"
    ),
    "loading.no_table": "Der Plan enthält keine Tabelle für diese Achse: Es war nichts zu laden.",
    "loading.open": (
        "Nicht zu entscheiden, was geladen wurde: Die neue Tabelle ändert die Abweichungen"
        " um {size} (Effektivwert), und das Rauschen eines Messwerts ist {noise}{needed:if|; die"
        " Korrektur ist kleiner als die {needed} (Effektivwert), die diese Prüfung beweisen"
        " kann}{effect:if|. Gemessen: {effect}}. Möglich: {candidates}.{off:if| Aber gegen die"
        " erste davon weicht sie um {off} und höchstens um {worst} ab. Das ist mehr als Rauschen:"
        " Etwas anderes hat sich geändert, oder die Prüfung ist fehlerhaft.}"
    ),
    "loading.rms": "{rms} (Effektivwert)",
    "loading.slope": (
        "Über den Verfahrweg steigen ihre Abweichungen um {slope:+.2f} ± {error:.2f} µm/m mehr als"
        " erwartet: Stahl tut das über {kelvin:+2sig} K{declared:if| (für zwei Prüfungen angegeben:"
        " ± {declared:.1f} µm/m, k = 2)}. Die Temperatur des Maßstabs in den Dateien beider"
        " Prüfungen (T_m) und seinen Koeffizienten im Auftrag (thermal) angeben, oder neu messen,"
        " wenn Maschine und Messgerät zur Ruhe gekommen sind; den Temperaturfühler des Messgeräts"
        " prüfen."
    ),
    "loading.straight_line": (
        "Die Prüfung nach dem Laden ist die der geladenen Tabelle und einer Steigung. {slope} Die"
        " Korrektur ist selbst eine Gerade: Eine Tabelle, die mit dem Faktor {factor:.2f} aktiv"
        " ist, zeigte dasselbe; {read_back:if|die aus der Steuerung zurückgelesenen Werte sind die"
        " des Plans (--loaded)|die Werte aus der Steuerung zurücklesen (--loaded)}."
    ),
    "loading.thermal": (
        "Die Tabelle ist aktiv: Abgesehen von einer Steigung liegt die Prüfung nach dem Laden"
        " innerhalb von {left} der Vorhersage. {slope}"
    ),
    "loading.too_few": (
        "Nicht zu entscheiden: Die Prüfung nach dem Laden hat weniger als 3 gemessene Mittelwerte."
    ),
    "loading.verdict": (
        "{verdict:choose|loaded=Die Tabelle ist aktiv wie geplant{effect:if|: Die Prüfung nach dem"
        " Laden zeigt {effect}}|not_active=Die Tabelle ist nicht aktiv{detail:if|"
        " ({detail})}{effect:if|: Die Prüfung nach dem Laden zeigt {effect}}|inverted=Die Tabelle"
        " ist mit umgekehrtem Vorzeichen aktiv{detail:if| ({detail})}: Sie vergrößert den"
        " Fehler|scaled=Die Tabelle ist mit dem Faktor {factor:3sig} aktiv{detail:if|"
        " ({detail})}|shifted=Die Tabelle liegt {nodes} {nodes:plural|Stützpunkt|Stützpunkte} zu"
        " weit in {direction}{detail:if| ({detail})}|mirrored=Die Tabelle ist rückwärts geladen,"
        " ihr letzter Wert zuerst{detail:if| ({detail})}|wrong_axis=Aktiv ist die Tabelle der Achse"
        " {axis}{detail:if| ({detail})}|one_direction=Die Tabelle ist nur in einer Richtung aktiv:"
        " {detail}|backlash=Die Tabelle ist aktiv, und ihre Lose ist falsch: {detail}|partial=Ein"
        " Teil der Tabelle ist aktiv: {detail}|increment=Nur die Änderung zur vorhandenen Tabelle"
        " ist aktiv{detail:if| ({detail})}: die Summe laden, die in den geschriebenen Dateien"
        " steht|on_top=Die neue Summe wurde zur vorhandenen Tabelle addiert{detail:if| ({detail})}:"
        " die Tabelle leeren und die geschriebenen Dateien neu laden|state=Die vorhandene Tabelle"
        " war bei der ersten Prüfung nicht aktiv, obwohl der Auftrag es sagt. Den Auftrag mit"
        " `active: no` für diesen Zustand neu rechnen}."
    ),
    "loading.worst": "{value} ({position}, angefahren in {direction})",
    "next.between_again": "{output} über {input}: neu betrachtet, nach den Kreisen nach dem Laden",
    "next.between_kept": "{output} über {input}: behält, was in der Steuerung ist",
    "next.cannot_be_made": "die nächste Runde kann nicht gemacht werden: {reason}",
    "next.circles_only": (
        "ihre Tabelle kam aus Kreisen, die ihre Wirkung nicht zeigen: Sie behält, was in der"
        " Steuerung ist"
    ),
    "next.differs": "das Zurückgelesene weicht vom Plan ab: {why}{quantity:if| ({quantity})}",
    "next.doubted": "ihre Prüfung nach dem Laden ist zweifelhaft ({code}: {message})",
    "next.gained": (
        "eine weitere Tabelle ist geschrieben: {parameter} von {now:.2f} auf {then:.2f} {unit} an"
        " neuen Zielpositionen"
    ),
    "next.kept": "{why}: Sie behält, was in der Steuerung ist, und bekommt keine weitere Tabelle",
    "next.load": (
        "eine weitere Tabelle für {axes}{between:if|{axes:if|, }Rechtwinkligkeit}: alles aus"
        " next/tables laden, neu messen und diese Runde verifizieren"
    ),
    "next.no_axis": "keine Achse darf weiter korrigiert werden",
    "next.no_table": (
        "der Plan enthält keine Tabelle für sie, keine wurde geladen: Sie behält, was in der"
        " Steuerung ist"
    ),
    "next.not_compared": "das Zurückgelesene kann nicht mit dem Plan verglichen werden: {why}",
    "next.not_measured": (
        "sie wurde nach dem Laden nicht gemessen: Sie behält, was in der Steuerung ist"
    ),
    "next.read_back_differs": (
        "das Zurückgelesene weicht vom Plan ab: {axes:join|; } ({quantity}{more:if| und {more}"
        " weitere}; compwright compare listet alle). Zurücklesen, was jetzt in der Steuerung ist,"
        " laden, was fehlt, und neu verifizieren"
    ),
    "next.something_else": (
        "seit dem Lauf von run wurde in der Steuerung etwas anderes geändert: {quantity}{axis:if|"
        " der Achse {axis}}{more:if| und {more} weitere} (compwright compare listet alle); das"
        " zuerst prüfen, dann einen neuen Auftrag ausführen"
    ),
    "next.squareness_alone": (
        "keine Achse darf weiter korrigiert werden, und Rechtwinkligkeit allein bekommt keine"
        " nächste Runde: {measured:if|auch eine Achse mit Tabelle nach dem Laden messen und mit"
        " --after zusätzlich zu den Kreisen angeben|für den Rest einen neuen Auftrag ausführen,"
        " mit dem Zurückgelesenen als as_found und mit den Kreisen nach dem Laden}"
    ),
    "next.stop": (
        "hier aufhören: Keine weitere Tabelle für {axes} würde bringen, was eine Prüfung zeigen"
        " kann"
    ),
    "next.stop_axis": "{stop:if|hier aufhören|keine weitere Tabelle}: {why}",
    "next.verdict": (
        "der Befund ist {verdict:choose|not_active=nicht aktiv|inverted=umgekehrt|"
        "scaled=skaliert|shifted=verschoben|mirrored=gespiegelt|wrong_axis=falsche Achse|"
        "on_top=zusätzlich|one_direction=eine Richtung|partial=teilweise|thermal=Temperatur|"
        "increment=nur Änderung|state=Zustand|backlash=Lose|measurement=Fehler der Messung|"
        "undecided=offen|={name}}{of:if| ({of})}, nicht geladen"
    ),
    "next.written": "eine weitere Tabelle ist geschrieben",
}
