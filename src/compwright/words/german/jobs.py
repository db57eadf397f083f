"""What is noticed about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": (
        "states nennt {states}, aber nicht as_found: ohne ihn wird keine Tabelle geschrieben"
    ),
    "CW-J003": (
        "axes.{axis}.modulo hat bei einer Linearachse keine Bedeutung und wird nicht verwendet"
    ),
    "CW-J004": (
        "{place} bewirkt nichts: Achse {axis} ist nicht unter den Achsen des Auftrags, die"
        " Verfahrweg und Adresse angeben (before: [], wo sie keine Positionierprüfung hat)"
    ),
    "CW-J020": "{key} hat bei dieser Steuerung keine Wirkung ({format})",
    "CW-J021": (
        "acknowledged.{code} wird nicht gebraucht: Nichts dergleichen wurde gefunden{axis:if| an"
        " Achse {axis}}. Aus dem Auftrag streichen."
    ),
}
