"""Sentences about a test after loading."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-V001": "{verdict}",
    "CW-V010": (
        "Achse {axis}: Die aus der Steuerung zurückgelesene Tabelle stimmt mit der geplanten"
        " überein."
    ),
    "CW-V011": (
        "Achse {axis}: Die aus der Steuerung zurückgelesene Tabelle weicht um bis zu"
        " {difference:.2f} {unit} vom Plan ab. Wo, zeigt compwright compare."
    ),
    "CW-V011.others": (
        "Das aus der Steuerung Zurückgelesene weicht außerhalb der Achstabellen des Plans vom Plan"
        " ab: {entries}{more:if| und {more} weitere|}. Wo, zeigt compwright compare."
    ),
    "CW-V012": (
        "Achse {axis}: Diese Prüfung würde nicht zeigen, ob ihre Tabelle mit der von {others:join|"
        " oder } vertauscht ist. Um das auszuschließen, die Dateien der Steuerung zurücklesen und"
        " mit `--loaded` angeben."
    ),
    "CW-V020": (
        "Die Prüfung nach dem Laden deckt weniger ab als die erste: {gaps:join|; }. {targets}"
        " Zielpositionen von {range} messen, wie zuvor."
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
        "{circle:if|Die Messwerte des Kreises|Wiederholte Messwerte} streuen um {scatter},"
        " {beyond:if|mehr als |}{ratio:3sig}-mal {less:if|weniger|mehr} als in der ersten Prüfung"
        " ({first}). Zufällig kommt das in weniger als einer von 1000 Prüfungen vor, selbst wenn"
        " sich das Rauschen beider Prüfungen um einen Faktor bis {factor:g} unterscheidet. Einheit"
        " und Messwerte prüfen. Neu messen, mit dem Messgerät eingestellt wie bei der ersten"
        " Prüfung."
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
        "Die Maßstabsabweichung der Achse {axis} wurde nach Kreisprüfungen korrigiert, und kein"
        " Kreis nach dem Laden zeigt deutlich genug, ob das aktiv ist. Daher ist für sie nichts"
        " bewiesen. Den Kreis {circles:if|{circles:join| oder }|dieser Ebene}"
        " neu messen."
    ),
    "CW-V023.squareness": (
        "Die Rechtwinkligkeit von {plane} wurde korrigiert und nach dem Laden nicht gemessen, für"
        " sie ist nichts bewiesen. Den Kreis {circles:if|{circles:join| oder }|dieser Ebene} neu"
        " messen."
    ),
    "CW-V023.test": (
        "Die Grenzwerte der Achse {axis} gelten für die Prüfung {meant}, nach dem Laden wurde aber"
        " {measured} gemessen. Ob die Grenzwerte eingehalten sind, ist deshalb nicht bewiesen."
        " Messen wie für {meant} und als --after {meant}=FILE angeben."
    ),
    "CW-V024": (
        "Mit dieser Warnung zur Prüfung nach dem Laden kann das Urteil nicht gut sein ({code}):"
        " {finding} Ihre Ursache beseitigen, dann neu messen."
    ),
    "CW-V025": (
        "Die mit --after angegebene Datei des Kreises {circle} wurde vor dem Laden gemessen. Den"
        " Kreis neu messen."
    ),
    "CW-V026.certain": (
        "Die Messwerte können nicht stimmen: {why}. Die Prüfung in der Einheit exportieren, die"
        " ihre Datei nennt."
    ),
    "CW-V026.copied": (
        "Diese Datei enthält die Messwerte der Prüfung {test} von vor dem"
        " Laden{way:choose|same=|sign=, mit gedrehtem Vorzeichen|direction=, mit vertauschten"
        " Richtungen}. Die Achse neu messen."
    ),
    "CW-V026.file_twice": (
        "Die Prüfung der Achse {axis} enthält eine Datei zweimal. Jede Messung einmal angeben."
    ),
    "CW-V026.one_run": (
        "Alle Läufe enthalten dieselben Messwerte: Ein Lauf wurde kopiert. Die Achse neu messen."
    ),
    "CW-V026.scatter": (
        "Lauf für Lauf streuen die Messwerte genau wie in der Prüfung {test} (Korrelation"
        " {correlation:.2f}). Diese Prüfung wurde also aus jener berechnet. Die Achse neu messen."
    ),
    "CW-V026.targets": (
        "Die Zielpositionen der Prüfung sind in {unit}, nicht in mm. In mm exportieren."
    ),
    "CW-V026.thousand": (
        "Die Messwerte streuen um {scatter}, die der ersten Prüfung um {first}. Sie sind 1000-mal"
        " zu {small:if|klein (mm als µm gelesen)|groß (µm als mm gelesen)}. Die Prüfung in der"
        " Einheit exportieren, die ihre Datei nennt."
    ),
    "CW-V026.turned": (
        "Umkehrspiel oder Unterschied der Lageregelung hat das umgekehrte Vorzeichen der ersten"
        " Prüfung: {what:join|; }. In dieser Datei ist das Vorzeichen der Abweichungen gedreht,"
        " oder ccw und cw sind vertauscht. Beides prüfen und die Prüfung neu exportieren."
    ),
    "CW-V026.two_axes": (
        "Achse {axis} und Achse {other} bekamen dieselbe Messung. Jeder Achse ihre eigene geben."
    ),
    "CW-V026.zeros": (
        "Jeder Messwert der Prüfung ist derselbe, es wurde also nichts gemessen. Die Achse messen."
    ),
    "CW-V027": "{verdict}",
    "CW-V028": "{verdict}",
    "CW-V029": (
        "Die Prüfung{circle:if| des Kreises {circle}|} nach dem Laden ist vom {date}, die erste"
        " Prüfung vom {first}. Eine ältere Prüfung zeigt nicht, was geladen wurde. Datei und Datum"
        " prüfen oder neu messen."
    ),
    "CW-V030": (
        "Die Prüfungen {off} (ohne die Tabelle) und {on} (mit ihr) zeigen, dass die vorhandene"
        " Tabelle (states.{state} im Auftrag) aktiv war, wie ihre Dateien sagen (zu {percent:.1f}"
        " % sicher)."
    ),
    "CW-V031": (
        "Die Prüfungen {off} (ohne die Tabelle) und {on} (mit ihr) zeigen nicht, ob die"
        " vorhandene Tabelle (states.{state} im Auftrag) aktiv war, wie ihre Dateien sagen:"
        " {likely:if|{likely}|keine bekannte Ursache passt}. Die beiden Prüfungen werden nur"
        " verwendet, so weit sie übereinstimmen."
    ),
    "CW-V032": (
        "Die Prüfung{circle:if| des Kreises {circle}|} nach dem Laden ist von der Maschine mit der"
        " Seriennummer {found}, diese Maschine hat aber {known:join| oder }. Eine Prüfung einer"
        " anderen Maschine zeigt nicht, was geladen wurde. Die Datei dieser Maschine angeben oder"
        " die Nummer im Auftrag oder in der Datei berichtigen."
    ),
    "CW-V033": (
        "Das aus der Steuerung Zurückgelesene lässt einen Zweifel: {doubts:join|; }. Alle Dateien"
        " der Steuerung noch einmal zurücklesen und alle mit --loaded angeben."
    ),
    "CW-V034": (
        "Der Kreis {circle} nach dem Laden ist nicht der Kreis der ersten Messung: {what:join|; }."
        " Die Abweichungen hängen von Radius, Vorschub und Bogen ab und sind daher nicht mit der"
        " Vorhersage vergleichbar{limits:if|, die Grenzwerte bleiben offen|}. Die Rechtwinkligkeit"
        " wird trotzdem verglichen. Den Kreis wie beim ersten Mal messen."
    ),
    "CW-V034.arc": (
        "er geht von {start:.0f}° bis {end:.0f}° (der erste von {was_start:.0f}° bis"
        " {was_end:.0f}°)"
    ),
    "CW-V034.feed": "sein Vorschub ist {now:g} mm/min (des ersten {was:g} mm/min)",
    "CW-V034.radius": "sein Radius ist {now:g} mm (des ersten {was:g} mm)",
    "CW-V035": (
        "{axis:if|Die Maßstabsabweichung der Achse {axis}|Die Rechtwinkligkeit} nach dem Laden"
        " ist {value:.1f} µm/m. Vorhergesagt waren {expected:.1f} µm/m, ± {U:.1f} µm/m aus dem"
        " Rauschen der beiden Prüfungen (k = 2). {verdict:choose|loaded=Die Korrektur ist aktiv;"
        " ein neues Einrichten des Messgeräts oder eine Änderung der Maschine kann diesen Rest"
        " lassen.|not_active={loading} Prüfen, ob sie geladen und eingeschaltet"
        " ist.|inverted={loading} Das Vorzeichen der Tabelle prüfen und sie neu"
        " laden.|increment={loading} Die vorhandene Korrektur fehlt. {step}|read_back=Die"
        " zurückgelesene Tabelle weicht vom Plan ab (CW-V011).|uncertain=Die Prüfungen sind zu"
        " unsicher, um den Fehler zu nennen. Den vollen Kreis in beiden Richtungen neu"
        " messen.|={loading} {step}}{negligible:if| Unter {negligible:.0f} µm/m wird sie"
        " angenommen.|}"
    ),
    "CW-V035.open": (
        "Der Kreis nach dem Laden bestimmt die Rechtwinkligkeit nicht gut genug, um zu zeigen, dass"
        " ihre Korrektur aktiv ist. Den vollen Kreis in beiden Richtungen neu messen."
    ),
    "CW-V035.step": (
        "{as_planned:if|Das Zurückgelesene ist wie geplant: prüfen, ob alle Tabellen"
        " eingeschaltet sind, und den Kreis neu messen.|Das Geladene mit dem Plan vergleichen.}"
    ),
    "CW-V036": (
        "Der Kreis nach dem Laden ist nicht wie vorhergesagt: {what:join|; }. Das Geladene mit dem"
        " Plan vergleichen. Auch Vorschub, Rauschen, Aufbau des Messgeräts, eine wärmere Maschine,"
        " Reibung oder Regelparameter können die Ursache sein. Sie prüfen und neu messen wie bei"
        " der ersten Prüfung. Bleibt es so, hat sich die Maschine geändert: einen neuen Auftrag mit"
        " diesem Kreis und den jetzigen Dateien der Steuerung beginnen."
    ),
    "CW-V036.value": "{name} {value} (vorhergesagt {low} bis {high})",
    "headline.active": "{tables:plural|Tabelle|Tabellen} aktiv. Keine Grenzwerte angegeben.",
    "headline.bad": "Nicht gut: siehe die {circles:if|Kreise|Achsen} unten",
    "headline.good": (
        "Gut: Die Tabellen sind aktiv, und die Grenzwerte sind eingehalten{without:if| (keine"
        " Grenzwerte für {without} angegeben)|}"
    ),
    "headline.undecided": (
        "Offen: Die Prüfungen zeigen nicht, ob die Tabelle aktiv ist oder die Grenzwerte"
        " eingehalten sind"
    ),
    "loading.as_before": (
        "Die Prüfung weicht um {left} von dem ab, was sie zeigen würde, wenn die Steuerung noch"
        " wie vor dem Laden wäre."
    ),
    "loading.as_predicted": "Die Prüfung weicht um {left} von der Vorhersage ab.",
    "loading.backlash": (
        "{kind:choose|missing=er fehlt|twice=doppelt|sign=mit falschem Vorzeichen|old=der alte Wert"
        " statt des neuen|added=der alte Wert zum neuen addiert}"
    ),
    "loading.candidate": "{name} ({sure:if|über 99|{percent:2sig}} %)",
    "loading.circle": (
        "{candidates:if|Die Prüfung nach dem Laden zeigt {effect}. Mögliche Ursachen:"
        " {candidates}.|Kein bekannter Ladefehler erklärt das{effect:if|: Die Prüfung nach dem"
        " Laden zeigt {effect}}. Den Kreis neu messen.}"
    ),
    "loading.declared_slope": (
        "Über den Verfahrweg steigen die Abweichungen dieser Prüfung um {slope:+.2f} ± {error:.2f}"
        " µm/m mehr als erwartet. Stahl zeigt eine solche Steigung, wenn sich seine Temperatur um"
        " {kelvin:+2sig} K ändert, was {within:if|innerhalb|jenseits} dessen liegt, was der Auftrag"
        " für zwei Prüfungen angibt (± {declared:.1f} µm/m, k = 2). Die Tabelle ist nicht schuld,"
        " aber die Messwerte, die über die Grenzwerte entscheiden, enthalten diese Steigung."
    ),
    "loading.effect": "{part:.2f} ± {error:.2f} der geplanten Wirkung",
    "loading.equivalent": (
        "Diese Fehler ergäben dieselben Messwerte: {names}. Keine Messung dieser Achse kann sie"
        " unterscheiden. {read_back:if|Die aus der Steuerung zurückgelesenen Werte entscheiden"
        " das: Sie sind gleich den geplanten Werten (--loaded)|Die Werte aus der Steuerung"
        " zurücklesen und mit --loaded angeben}."
    ),
    "loading.evidence": (
        "Die gemessenen Abweichungen unterscheiden sich um {off} von den vorhergesagten, höchstens"
        " um {worst}. Von denen, die der im Ergebnis genannte Fehler ergäbe, unterscheiden sie sich"
        " um {left}; das Rauschen eines Messwerts ist {noise}.{effect:if| Gemessen: {effect}.}"
    ),
    "loading.likely": "{verdict} {percent:.0f} %",
    "loading.factor": (
        "{factor:choose|2=doppelt: Radius und Durchmesser verwechselt, auf sich selbst geladen"
        " oder doppelte Vergrößerung|0.5=halb: Radius und Durchmesser verwechselt|10=zehnfach:"
        " andere Erfassungseinheit oder anderes Inkrementsystem|0.1=ein Zehntel: andere"
        " Erfassungseinheit oder anderes Inkrementsystem|16=16-fach: zweimal mit 16"
        " multipliziert|0.0625=1/16: Inkremente statt 1/16 Inkrementen"
        " eingegeben|25.4=25,4-fach: Werte in mm als Zoll eingegeben|0.03937=1/25,4: Werte in"
        " Zoll als mm eingegeben|1000=tausendfach: Werte in µm als mm eingegeben|0.001=ein"
        " Tausendstel: Werte in mm als µm eingegeben}"
    ),
    "loading.in_order": (
        "in der Reihenfolge der Positionen eingegeben, die"
        " {end:choose|low=niedrigste|high=höchste} zuerst; die Steuerung zählt die Einträge"
        " von ihrem Nullpunkt an"
    ),
    "loading.instead": (
        "{active:choose|still=was vorher in der Steuerung war, ist noch aktiv|before=was vorher in"
        " der Steuerung war, ist aktiv|nothing=gar nichts ist aktiv|backlash=nur die neue Lose ist"
        " aktiv}"
    ),
    "loading.measurement": (
        "Die Prüfung nach dem Laden selbst scheint falsch zu sein. Sie passt zu erster Prüfung und"
        " Plan nur, wenn {fault:choose|sign=das Vorzeichen ihrer Abweichungen gedreht"
        " ist|direction=ihre Richtungen + und − vertauscht sind|unit=ihre Messwerte mit"
        " {factor:4sig} multipliziert sind|wrong_axis=sie eine Prüfung {axis} ist}."
        " {fault:choose|sign=Vorzeichen und Richtungen des Messgeräts prüfen und die Prüfung neu"
        " exportieren.|direction=Vorzeichen und Richtungen des Messgeräts prüfen und die Prüfung"
        " neu exportieren.|unit=Die Prüfung in der Einheit exportieren, die ihre Datei"
        " nennt.|wrong_axis=Diese Achse messen oder die Datei der Achse geben, zu der sie gehört.}"
    ),
    "loading.name": (
        "{name:choose|loaded=geladen|not_active=nicht aktiv|inverted=umgekehrtes"
        " Vorzeichen|scaled=falscher Faktor|shifted=entlang der Achse"
        " verschoben|mirrored=rückwärts|wrong_axis=Tabelle einer anderen Achse|one_direction=nur in"
        " einer Richtung aktiv|backlash=falscher Losewert|partial=nur ein Teil ist"
        " aktiv|increment=nur die Änderung geladen|on_top=zur vorhandenen Tabelle"
        " addiert|state=vorhandene Tabelle bei der ersten Prüfung nicht aktiv|thermal=andere"
        " Temperatur|measurement=Messung falsch|undecided=offen}{detail:if|: {detail}}"
    ),
    "loading.neither": (
        "Die Prüfung nach dem Laden passt weder zur geladenen Tabelle noch zur Steuerung, wie sie"
        " vorher war, noch zu einem bekannten Fehler beim Laden.{loaded:if| Von der Vorhersage"
        " weicht sie um {loaded} ab, höchstens um {loaded_worst}.}{inactive:if| Von dem, was sie"
        " mit der Steuerung, wie sie vorher war, zeigen würde, weicht sie um {inactive} ab,"
        " höchstens um {inactive_worst}.}{offset:if| Verglichen mit der Vorhersage liegen die"
        " Anfahrten in + im Mittel {offset} {above:if|über|unter} denen in −.}{effect:if|"
        " Gemessen: {effect}.}"
    ),
    "loading.no_table": "Der Plan enthält keine Tabelle für diese Achse: Es war nichts zu laden.",
    "loading.of_axis": "der Achse {axis}",
    "loading.one_direction": (
        "nur beim Anfahren{axis:if| von {axis}|} in {direction}; in der anderen Richtung"
        " {other:choose|before=ist die Korrektur wie vorher|nothing=ist keine Korrektur"
        " aktiv|backlash=ist nur die neue Lose aktiv}"
    ),
    "loading.open": (
        "Diese Prüfung kann nicht zeigen, was geladen wurde. Die neue Tabelle ändert die"
        " Abweichungen um {size} (Effektivwert), und das Rauschen eines Messwerts ist"
        " {noise}{needed:if|. Diese Korrektur ist kleiner als die {needed} (Effektivwert), die die"
        " Prüfung beweisen kann}{effect:if|. Gemessen: {effect}}. Mögliche Ursachen:"
        " {candidates}.{off:if| Aber die gemessenen Abweichungen unterscheiden sich um {off},"
        " höchstens um {worst}, von denen, die die erste dieser Ursachen ergäbe. Das ist mehr als"
        " Rauschen: Etwas anderes hat sich geändert, oder die Prüfung ist fehlerhaft.}"
    ),
    "loading.other_axis": (
        "die der Achse {axis}, an denselben {by:choose|position=Positionen|number=Punktnummern}"
    ),
    "loading.part": (
        "{first:if|bis|ab} Punkt {number} ({position:g}), {beyond:choose|nothing=außerhalb keine"
        " Korrektur|last=außerhalb der letzte Wert|old=außerhalb die alten"
        " Werte|old_steps=außerhalb die alten Inkremente|no_backlash=außerhalb weder Korrektur noch"
        " Lose|before=außerhalb alles wie vorher}"
    ),
    "loading.rms": "{rms} (Effektivwert)",
    "loading.slope": (
        "Über den Verfahrweg steigen die Abweichungen dieser Prüfung um {slope:+.2f} ± {error:.2f}"
        " µm/m mehr als erwartet. Stahl zeigt eine solche Steigung, wenn sich seine Temperatur um"
        " {kelvin:+2sig} K ändert{declared:if| (für zwei Prüfungen angegeben: ± {declared:.1f}"
        " µm/m, k = 2)}. Die Temperatur des Maßstabs in den Dateien beider Prüfungen (T_m) und"
        " seinen Koeffizienten im Auftrag (thermal) angeben. Oder Maschine und Messgerät zur Ruhe"
        " kommen lassen, den Temperaturfühler des Messgeräts prüfen und neu messen."
    ),
    "loading.steps": "die Inkremente in umgekehrter Folge",
    "loading.straight_line": (
        "Die Prüfung nach dem Laden zeigt die geladene Tabelle und zusätzlich eine Steigung."
        " {slope} Die Korrektur ist selbst eine Gerade, deshalb zeigte eine Tabelle, die mit dem"
        " Faktor {factor:.2f} aktiv ist, dasselbe. {read_back:if|Die aus der Steuerung"
        " zurückgelesenen Werte sind gleich den geplanten Werten (--loaded)|Zur Entscheidung die"
        " Werte aus der Steuerung zurücklesen und mit --loaded angeben}."
    ),
    "loading.table": "die Tabelle ist {active:if|aktiv|nicht aktiv}",
    "loading.thermal": (
        "Die Tabelle ist aktiv. Abgesehen von einer Steigung weicht die Prüfung nach dem Laden um"
        " {left} von der Vorhersage ab. {slope}"
    ),
    "loading.too_few": (
        "Die Prüfung nach dem Laden hat weniger als 3 gemessene Mittelwerte, zu wenige, um zu"
        " zeigen, was geladen wurde. Mehr Zielpositionen messen."
    ),
    "loading.variant": (
        "{detail:if|{detail}, }{backlash:choose|old=mit der alten Lose|apart=abgesehen von der"
        " Lose|table=nur in der Tabelle der Lose}"
    ),
    "loading.verdict": (
        "{verdict:choose|loaded=Die Tabelle ist aktiv wie geplant{effect:if|: Die Prüfung nach dem"
        " Laden zeigt {effect}}|not_active=Die Tabelle ist nicht aktiv{detail:if|"
        " ({detail})}{effect:if|: Die Prüfung nach dem Laden zeigt {effect}}|inverted=Die Tabelle"
        " ist mit umgekehrtem Vorzeichen aktiv{detail:if| ({detail})} und vergrößert den"
        " Fehler|scaled=Die Tabelle ist mit dem Faktor {factor:3sig} aktiv{detail:if|"
        " ({detail})}|shifted=Die Tabelle ist um {nodes}"
        " {nodes:plural|Tabellenpunkt|Tabellenpunkte} in Richtung {direction} verschoben{detail:if|"
        " ({detail})}|mirrored=Die Tabelle ist rückwärts geladen, ihr letzter Wert"
        " zuerst{detail:if| ({detail})}|wrong_axis=Die aktive Tabelle ist"
        " {detail}|one_direction=Die Tabelle ist nur in einer Richtung aktiv: {detail}|backlash=Die"
        " Tabelle ist aktiv, aber der Losewert ist falsch: {detail}|partial=Nur ein Teil der"
        " Tabelle ist aktiv: {detail}|increment=Nur die Änderung zur vorhandenen Tabelle ist"
        " aktiv{detail:if| ({detail})}{open:if||. Die Summe laden, die in den geschriebenen Dateien"
        " ist}|on_top=Die Steuerung hat die neue Summe zur vorhandenen Tabelle addiert{detail:if|"
        " ({detail})}{open:if||. Die Tabelle leeren und die geschriebenen Dateien neu"
        " laden}|state=Die vorhandene Tabelle war bei der ersten Prüfung nicht aktiv, obwohl der"
        " Auftrag es sagt{open:if||. Den Auftrag neu rechnen, mit `active: no` in dem Eintrag von"
        " `states`, der bei der ersten Prüfung in der Steuerung war (measured_in)}}."
    ),
    "loading.worst": "{value} ({position}, angefahren in {direction})",
    "next.between_again": (
        "die Korrektur von {output} über {input} wurde aus den Kreisen nach dem Laden neu geschätzt"
    ),
    "next.between_kept": (
        "die Korrektur von {output} über {input} bleibt, wie sie in der Steuerung ist"
    ),
    "next.cannot_be_made": (
        "die Tabellen der nächsten Korrekturrunde können nicht gemacht werden: {reason}"
    ),
    "next.circles_only": (
        "die Tabelle dieser Achse wurde nur aus Kreisformprüfungen berechnet, und eine nächste"
        " Runde korrigiert nur Achsen mit Positionierprüfung. Die Achse behält, was in der"
        " Steuerung ist"
    ),
    "next.differs": "das Zurückgelesene weicht vom Plan ab: {why}{quantity:if| ({quantity})}",
    "next.doubted": (
        "ein Befund zur Prüfung dieser Achse nach dem Laden ist nicht geklärt ({code}: {message})"
    ),
    "next.gained": (
        "eine Tabelle für die nächste Runde ist geschrieben. Sie soll {parameter} an neuen"
        " Zielpositionen von {now:.2f} auf {then:.2f} {unit} ändern"
    ),
    "next.kept": (
        "{why}. Die Achse behält, was in der Steuerung ist, und bekommt keine Tabelle für die"
        " nächste Runde"
    ),
    "next.load": (
        "eine Tabelle für die nächste Runde wurde geschrieben für {axes}{between:if|{axes:if| und"
        " für die }Rechtwinkligkeit}. Alle Dateien aus next/tables laden, neu messen und compwright"
        " verify mit next/job.yaml ausführen"
    ),
    "next.no_axis": "keine Achse bekommt eine Tabelle für die nächste Runde",
    "next.no_table": (
        "der Plan enthält keine Tabelle für diese Achse, es wurde also keine geladen. Die Achse"
        " behält, was in der Steuerung ist"
    ),
    "next.not_compared": "das Zurückgelesene kann nicht mit dem Plan verglichen werden: {why}",
    "next.not_measured": (
        "diese Achse wurde nach dem Laden nicht gemessen. Die Achse behält, was in der"
        " Steuerung ist"
    ),
    "next.read_back_differs": (
        "das Zurückgelesene weicht vom Plan ab: {axes:join|; } ({quantity}{more:if| und {more}"
        " weitere}; compwright compare listet alle). Laden, was fehlt, den Inhalt der Steuerung"
        " neu zurücklesen und neu verifizieren"
    ),
    "next.something_else": (
        "andere Werte in der Steuerung wurden seit dem Lauf von run geändert: {quantity}{axis:if|"
        " der Achse {axis}}{more:if| und {more} weitere} (compwright compare listet alle). Zuerst"
        " diese Änderungen prüfen, dann einen neuen Auftrag ausführen"
    ),
    "next.squareness_alone": (
        "keine Achse bekommt eine neue Tabelle, und deshalb wird auch die Rechtwinkligkeit nicht"
        " weiter korrigiert. {measured:if|Für eine weitere Korrektur mindestens eine Achse mit"
        " Tabelle nach dem Laden messen und ihre Prüfung zusammen mit den Kreisen mit --after"
        " angeben|Für eine weitere Korrektur einen neuen Auftrag anlegen: die zurückgelesenen"
        " Dateien als as_found und die nach dem Laden gemessenen Kreise angeben}"
    ),
    "next.squareness_not_active": (
        "keine neue Tabelle: Die Kreise zeigen nicht, dass die Korrektur der Rechtwinkligkeit von"
        " {planes} wie geplant aktiv ist, und eine weitere käme vielleicht zu einem Fehler dazu."
        " Zuerst das beheben und den Kreis neu messen"
    ),
    "next.stop": (
        "hier aufhören: Der Gewinn einer weiteren Tabelle für {axes} wäre zu klein, um sich in"
        " einer Prüfung zu zeigen"
    ),
    "next.stop_axis": "{stop:if|hier aufhören|keine Tabelle für die nächste Runde}: {why}",
    "next.stop_squareness": (
        "{stop:if|hier aufhören: Die Rechtwinkligkeit von {planes} braucht keine weitere"
        " Korrektur|keine neue Tabelle: Die Rechtwinkligkeit von {planes} nach dem Laden ist für"
        " eine weitere Korrektur zu unsicher. Den Kreis noch einmal messen}"
    ),
    "next.verdict": (
        "der Befund ist „{verdict:choose|not_active=nicht aktiv|inverted=umgekehrt|scaled=skaliert|"
        "shifted=verschoben|mirrored=gespiegelt|wrong_axis=falsche Achse|on_top=zur alten Tabelle"
        " addiert|one_direction=in einer Richtung aktiv|partial=teilweise aktiv|thermal=thermische"
        " Steigung|increment=nur Änderung geladen|state=alte Tabelle war nicht aktiv|"
        "backlash=Losewert falsch|measurement=Fehler der Messung|undecided=offen|={name}}{of:if|"
        " ({of})}“, nicht „geladen“"
    ),
    "next.written": "eine Tabelle für die nächste Runde ist geschrieben",
    "read_back.backlash": (
        "alle Werte für die Annäherung in {direction} weichen um denselben Betrag ab: Der Losewert"
        " ist nicht der geplante"
    ),
    "read_back.cause": (
        "{cause:choose|loaded=die Tabelle in der Steuerung ist die geplante|before=was vorher in"
        " der Steuerung war, ist noch da|nothing=keine Tabelle ist aktiv: Sie ist ausgeschaltet"
        " oder leer|increment=nur die Änderung zur vorhandenen Tabelle wurde geladen: die Summe"
        " laden|on_top=die neue Summe wurde zur vorhandenen Tabelle addiert: die Tabelle löschen"
        " und neu laden|inverted=jeder Wert hat das entgegengesetzte Vorzeichen}{apart:if|"
        " (abgesehen von der Lose)|}"
    ),
    "read_back.one_side": (
        "nur die Werte für die Annäherung in {direction} sind gleich den geplanten Werten"
    ),
    "read_back.other": (
        "die Werte weichen an {off} von {number} Positionen ab (jede Richtung gezählt); kein"
        " bekannter Fehler erklärt alle diese Abweichungen"
    ),
    "read_back.own": (
        "die Dateien, die compwright run geschrieben hat, enthalten die geplante Tabelle. Sie"
        " zeigen nicht, was in der Steuerung ist"
    ),
    "read_back.partly": (
        "nur {loaded:and} wurde geladen: auch {missing:and} laden, bevor die Achse fährt; {why}"
    ),
    "read_back.scaled": (
        "jeder Wert weicht vom geplanten um einen Faktor ab ({factor}){apart:if| (abgesehen von"
        " der Lose)|}"
    ),
    "read_back.shifted": (
        "die Tabelle liegt {points} {points:plural|Punkt|Punkte} zu weit in {towards}{apart:if|,"
        " und die Werte jeder Richtung weichen außerdem um eine Konstante vom Plan ab: Der"
        " Referenzpunkt hat eine andere Nummer oder Position|}"
    ),
}
