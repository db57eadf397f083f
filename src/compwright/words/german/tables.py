"""Sentences about the fit of a table."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F001.held": (
        "Die Tabelle umfasst {uncovered:g} {unit} des Verfahrwegs"
        " {side:choose|below=unterhalb|above=oberhalb} von {end:g} {unit} nicht. Die Steuerung"
        " hält dort den Endwert"
    ),
    "CW-F001.step": (
        "Die Tabelle umfasst {uncovered:g} {unit} des Verfahrwegs"
        " {side:choose|below=unterhalb|above=oberhalb} von {end:g} {unit} nicht. Die Steuerung"
        " korrigiert dort nichts, deshalb springt die Achse an diesem Ende um {step}"
    ),
    "CW-F002": (
        "{finest:if|{allowed:if|Der kleinste Abstand, den diese Steuerung hier erlaubt|Der"
        " kleinste Abstand, der hier von selbst gewählt wird}, {spacing} ({points} Punkte),|Der"
        " Abstand von {spacing}} ist zu groß für einen Fehler der Periode {periods:g} {unit}."
        " {left_out:if|Dieser Fehler ({whole} Effektivwert) ist nicht in der"
        " Tabelle|{share:if|Von diesem Fehler, {whole} Effektivwert, lässt die Tabelle {left}"
        " ({share:.0%})|Die Tabelle lässt nichts von diesem Fehler}}. Die Tabelle braucht ein"
        " Drittel der Periode als Abstand: {needed_spacing:g} {unit}, das sind {needed_points}"
        " Punkte über den Verfahrweg{most_points:if|. Diese Steuerung hat {most_points} Punkte}"
    ),
    "CW-F003": (
        "Die Referenzposition ({reference:g} {unit}) liegt außerhalb der Tabelle ({start:g} bis"
        " {end:g} {unit}). Dort {held:if|gilt der Endwert der Tabelle. Die Korrektur muss an der"
        " Referenzposition null sein, deshalb ist dieser Endwert null|korrigiert die Steuerung"
        " nicht}. Der Fehler zwischen Referenzposition und Tabelle wird nicht korrigiert"
    ),
    "CW-F004": (
        "Die Steuerung hat zu wenige Tabellenpunkte für diesen Fehler: Zwischen den Punkten"
        " bleiben {left} Effektivwert davon"
    ),
    "CW-F005": (
        "Die Steuerung hat eine Tabelle für beide Richtungen, die diese Umkehrspanne nicht"
        " korrigieren kann: {left} Effektivwert davon bleiben"
    ),
    "CW-F006.grid": (
        "Die Tabelle reicht bis zu {beyond:g} {unit} über den Verfahrweg hinaus, denn ihre Punkte"
        " liegen an runden Positionen oder dort, wo andere Spalten derselben Tabelle sie brauchen"
    ),
    "CW-F006.reference": (
        "Die Steuerung zählt die Tabellenpunkte von der Referenzposition ({reference:g} {unit}),"
        " die außerhalb des Verfahrwegs liegt. Deshalb liegen {extra} der {nodes_size} Punkte"
        " jenseits des Verfahrwegs"
    ),
    "CW-F007": (
        "Die Korrektur wäre größer als der größte Wert, den die Steuerung annimmt: {left}"
        " Effektivwert des Fehlers bleiben"
    ),
    "CW-F008": (
        "Der Fehler ist steiler als der größte Schritt zwischen zwei Tabellenpunkten, den die"
        " Steuerung annimmt: {left} Effektivwert davon bleiben"
    ),
    "CW-F009.compared": (
        "Die Vergrößerung wird auf {magnification} statt {before} gesetzt, vom Fehler {left:if|"
        "bleiben {left} Effektivwert|bleibt nichts}. Mit Vergrößerung {before} wäre ein Schritt"
        " {step}. Die Steuerung speichert nur {increments} Schritte je Tabellenpunkt, also blieben"
        " mindestens {at_least} Effektivwert"
    ),
    "CW-F009.smallest": (
        "Die kleinste Vergrößerung, {magnification}, genügt. Ein Schritt ist damit {step}. Die"
        " Steuerung speichert {increments} Schritte je Tabellenpunkt: Vom Fehler {left:if|bleiben"
        " {left} Effektivwert|bleibt nichts}"
    ),
    "CW-F010": (
        "Der Auftrag verlangt eine Tabelle mit dem kleinsten {goal}. Verwendet wird stattdessen"
        " die mit dem kleinsten erwarteten Fehlerquadrat: {why:choose|slope=Diese Steuerung hat"
        " eine Steigung und keine Tabelle|increments=Diese Steuerung hat nur ganze"
        " Schritte|no_gain=Auf ganze Schritte gerundet, zeigt die Tabelle für {goal} in"
        " simulierten Prüfungen keinen Gewinn}"
    ),
    "CW-F011": (
        "Die neue Tabelle behält die Punkte der vorhandenen, obwohl sie nur {spacing:g} {unit}"
        " auseinanderliegen: {reason}. Die Steuerung arbeitete bisher mit diesen Punkten. Für einen"
        " Abstand, der groß genug ist, `spacing: auto` in der Tabelle der Achse setzen"
    ),
    "mode.one_asked": "Eine Tabelle und ein Umkehrwert, wie der Auftrag verlangt",
    "mode.one_constant": (
        "Eine Tabelle und ein konstanter Unterschied zwischen den Richtungen: Die Messwerte zeigen"
        " nicht deutlich, dass sich dieser Unterschied über den Verfahrweg ändert (logarithmische"
        " Chancen {odds:.1f}; ab {strong:g} wären sie stark)"
    ),
    "mode.one_drift": (
        "Eine Tabelle und ein Umkehrwert: Die Umkehrspanne ändert sich über den Verfahrweg, aber"
        " die Drift innerhalb jedes Laufs kann diese Änderung allein verursachen, bei gleichem"
        " Spiel"
    ),
    "mode.one_held": (
        "Eine Tabelle und ein Umkehrwert: Die Steuerung hat eine Tabelle für beide Richtungen"
    ),
    "mode.one_unless_asked": (
        "Eine Tabelle und ein Umkehrwert: Zwei Tabellen entstehen nur, wenn der Auftrag sie"
        " verlangt (`mode: bidirectional`)"
    ),
    "mode.slope": "Eine Steigung und ein Umkehrwert: Die Steuerung hat keine Tabelle",
    "mode.two_asked": "Zwei Tabellen, wie der Auftrag verlangt",
    "mode.two_cost": (
        "Zwei Tabellen: Ein konstanter Unterschied zwischen den Richtungen ließe {cost}"
        " (Effektivwert) mehr"
    ),
    "mode.two_vary": (
        "Zwei Tabellen, weil sich die Umkehrspanne mit der Position ändert (logarithmische Chancen"
        " {odds:.1f}; ab {strong:g} ist der Beleg stark)"
    ),
}
