"""Sentences about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": (
        "Le dossier de travail a sous `states` les entrées {states}, mais pas as_found. L'entrée"
        " as_found indique ce qui est maintenant dans la commande. Sans elle, aucune table n'est"
        " écrite. Ajouter `as_found: none` ou `as_found: [fichiers de la commande]` sous `states`"
    ),
    "CW-J003": "axes.{axis}.modulo n'a pas de sens sur un axe linéaire et n'est pas utilisé",
    "CW-J004": (
        "{place} n'a pas d'effet, car l'axe {axis} n'est pas parmi les axes du dossier de travail."
        " Ajouter l'axe avec sa course et son adresse (et avec `before: []` s'il n'a pas d'essai de"
        " positionnement)"
    ),
    "CW-J020": "{key} n'a pas d'effet sur cette commande ({format})",
    "CW-J021": (
        "La clé acknowledged.{code} du dossier de travail n'est pas nécessaire, car le message"
        " {code} n'apparaît pas{axis:if| sur l'axe {axis}}. Enlever la clé."
    ),
}
