"""What is noticed about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": "states nomme {states} mais pas as_found : sans lui, aucune table n'est écrite",
    "CW-J003": "axes.{axis}.modulo n'a pas de sens sur un axe linéaire et n'est pas utilisé",
    "CW-J004": (
        "{place} ne fait rien : l'axe {axis} n'est pas parmi les axes du dossier de travail, qui"
        " donnent sa course et son adresse (before: [] s'il n'a pas d'essai de positionnement)"
    ),
    "CW-J020": "{key} n'a pas d'effet sur cette commande ({format})",
    "CW-J021": (
        "acknowledged.{code} n'est pas nécessaire : rien de tel n'a été trouvé{axis:if| sur l'axe"
        " {axis}}. L'enlever du dossier de travail."
    ),
}
