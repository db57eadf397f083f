"""Sentences about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": (
        "Der Auftrag hat unter `states` die Einträge {states}, aber nicht as_found. Der Eintrag"
        " as_found gibt an, was jetzt in der Steuerung ist. Ohne ihn wird keine Tabelle"
        " geschrieben. Unter `states` `as_found: none` oder `as_found: [Dateien der Steuerung]`"
        " angeben"
    ),
    "CW-J003": (
        "axes.{axis}.modulo hat bei einer Linearachse keine Bedeutung und wird nicht verwendet"
    ),
    "CW-J004": (
        "{place} hat keine Wirkung, denn Achse {axis} ist nicht unter den Achsen des Auftrags. Die"
        " Achse mit Verfahrweg und Adresse hinzufügen (und mit `before: []`, wenn sie keine"
        " Positionierprüfung hat)"
    ),
    "CW-J020": "{key} hat bei dieser Steuerung keine Wirkung ({format})",
    "CW-J021": (
        "Der Schlüssel acknowledged.{code} des Auftrags wird nicht gebraucht, denn die Meldung"
        " {code} kommt{axis:if| an Achse {axis}} nicht vor. Den Schlüssel streichen."
    ),
}
