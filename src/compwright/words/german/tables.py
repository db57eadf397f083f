"""What the fit of a table says."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F001.held": (
        "Die Tabelle lässt {uncovered:g} {unit} des Verfahrwegs"
        " {side:choose|below=unterhalb|above=oberhalb} von {end:g} {unit} offen: dort gilt der"
        " Endwert"
    ),
    "CW-F001.step": (
        "Die Tabelle lässt {uncovered:g} {unit} des Verfahrwegs"
        " {side:choose|below=unterhalb|above=oberhalb} von {end:g} {unit} offen: dort gibt sie"
        " nichts aus: eine Stufe von {step}"
    ),
    "CW-F002": (
        "{finest:if|Der kleinste Abstand, {allowed:if|den diese Steuerung hier erlaubt|der hier von"
        " selbst gewählt wird}, {spacing} ({points} Punkte),|Der Abstand von {spacing}} kann einen"
        " Fehler der Periode {periods:g} {unit} nicht aufnehmen: {left_out:if|er bleibt aus der"
        " Tabelle, {whole} Effektivwert|{share:if|von {whole} Effektivwert bleiben {left}"
        " ({share:.0%})|davon bleibt nichts}}. Ein Drittel der Periode nimmt ihn auf:"
        " {needed_spacing:g} {unit}, {needed_points} Punkte über den Verfahrweg{most_points:if|;"
        " diese Steuerung hat {most_points}}"
    ),
    "CW-F003": (
        "Die Referenzposition ({reference:g} {unit}) liegt außerhalb der Tabelle ({start:g} bis"
        " {end:g} {unit}): Dort {held:if|gilt der Endwert der Tabelle, der deshalb null ist|gibt"
        " die Steuerung nichts aus}, und der Fehler dazwischen wird nicht korrigiert"
    ),
    "CW-F004": (
        "Die Steuerung hat zu wenige Punkte für diesen Fehler: zwischen ihnen bleiben {left}"
        " Effektivwert"
    ),
    "CW-F005": (
        "Die Steuerung kann die Umkehrspanne mit einer Tabelle nicht korrigieren: {left}"
        " Effektivwert bleiben"
    ),
    "CW-F006.grid": (
        "Die Tabelle reicht bis zu {beyond:g} {unit} über den Verfahrweg hinaus: Ihre Punkte liegen"
        " an runden Positionen oder dort, wo andere Spalten derselben Tabelle sie brauchen"
    ),
    "CW-F006.reference": (
        "Die Steuerung zählt von der Referenzposition ({reference:g} {unit}), die außerhalb des"
        " Verfahrwegs liegt: {extra} der {nodes_size} Punkte der Tabelle liegen jenseits des"
        " Verfahrwegs"
    ),
    "CW-F007": "Der Fehler übersteigt den Wertebereich der Steuerung: {left} Effektivwert bleiben",
    "CW-F008": (
        "Der Fehler ist steiler als der größte Schritt der Steuerung: {left} Effektivwert bleiben"
    ),
    "CW-F009.compared": (
        "Vergrößerung {magnification}: Mit {before} blieben bei Schritten von {increments} mal"
        " {step} mindestens {at_least} Effektivwert, mit {magnification} {left:if|{left}"
        " Effektivwert|nichts}"
    ),
    "CW-F009.smallest": (
        "Vergrößerung {magnification}, die kleinste: Schritte von {increments} mal {step} lassen"
        " {left:if|{left} Effektivwert|nichts}"
    ),
    "CW-F010": (
        "Der Auftrag verlangt das kleinste {goal}. Verwendet wird stattdessen die Tabelle der"
        " kleinsten erwarteten Quadrate: {why:choose|slope=Diese Steuerung hat eine Steigung und"
        " keine Tabelle|increments=Diese Steuerung hat nur ganze Schritte|no_gain=Auf ganze"
        " Schritte gerundet, zeigt die Tabelle für {goal} in Prüfungen keinen Gewinn}"
    ),
    "CW-F011": (
        "Das vorhandene Raster bleibt, obwohl seine Punkte {spacing:g} {unit} auseinanderliegen:"
        " {reason}; die Steuerung lief damit. table.spacing: auto wählt einen Abstand, der groß"
        " genug ist"
    ),
    "mode.one_asked": "Eine Tabelle und ein Umkehrwert, wie der Auftrag verlangt",
    "mode.one_constant": (
        "Eine Tabelle und eine Konstante zwischen den Richtungen: Der gewünschte Verlauf ändert"
        " sich nicht mehr (logarithmische Chancen {odds:.1f}, stark ab {strong:g})"
    ),
    "mode.one_drift": (
        "Eine Tabelle und ein Umkehrwert: Die Umkehrspanne ändert sich über den Verfahrweg etwa so,"
        " wie es die Drift innerhalb jedes Laufs bei gleichem Spiel zeigte"
    ),
    "mode.one_held": (
        "Eine Tabelle und ein Umkehrwert: Die Steuerung hat eine Tabelle für beide Richtungen"
    ),
    "mode.one_unless_asked": (
        "Eine Tabelle und ein Umkehrwert: zwei Tabellen nur, wo der Auftrag sie verlangt (mode:"
        " bidirectional)"
    ),
    "mode.slope": "Eine Steigung und ein Umkehrwert: Die Steuerung hat keine Tabelle",
    "mode.two_asked": "Zwei Tabellen, wie der Auftrag verlangt",
    "mode.two_cost": (
        "Zwei Tabellen: Eine Konstante zwischen den Richtungen kostete {cost} (Effektivwert)"
    ),
    "mode.two_vary": (
        "Zwei Tabellen: Die Umkehrspanne ändert sich mit der Position (logarithmische Chancen"
        " {odds:.1f}, stark ab {strong:g})"
    ),
}
