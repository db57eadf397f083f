"""Sentences and parts of sentences of several findings."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "as_written": "{text}",
    "backlash_compensation_larger": (
        "{finding} La compensation de jeu dans les fichiers de la commande est plus grande que le"
        " jeu à l'inversion."
    ),
    "better_targets": "points visés qui la montreraient : {targets:g} {unit}",
    "between.deviation": "l'écart mesuré de {output} sur {input} ({slope:+.1f} µm/m)",
    "between.squareness": "perpendicularité de {output} à {input} ({slope:+.1f} µm/m)",
    "compared_not_removed": "{parameters:join|; }. Non retirées.",
    "direct_squareness": (
        "{input} et {output} : perpendicularité {squareness:+.1f} µm/m d'après la mesure directe"
    ),
    "doubts.acknowledged": "Confirmé dans le dossier de travail : {reason}. {message}",
    "doubts.first": "À vérifier d'abord : le résultat en dépend",
    "doubts.step": (
        "Rien n'est décidé tant que ce n'est pas clair. Corriger l'essai ou le dossier de travail"
        " et recommencer, ou y donner la raison pour laquelle c'est juste : acknowledged:"
        " {{{codes:join|: raison, }: raison}}"
    ),
    "in_direction": "{value} dans le sens {direction}",
    "increments": "{symmetric:if|±{largest}|{least} à {largest}}",
    "listed": "{items:join|; }{more:if| ; et {more} autres}",
    "listed_places": "{items}{more:if| et {more} autres}",
    "odds.1_to": "cote de 1 contre {odds:2sig}",
    "odds.above_1000": "cote supérieure à 1000 contre 1",
    "odds.over_1000": "cote supérieure à 1000 contre 1",
    "odds.to_1": "cote de {odds:2sig} contre 1",
    "of_axis": "Axe {axis} : {finding}",
    "of_circle": "Cercle {circle} : {finding}",
    "of_test": "Axe {axis}, essai {test} : {finding}",
    "paragraph": "{sentences:join| }",
    "parameter": "{parameter} {value}",
    "range": "{low} à {high}",
    "read_back": (
        "Relu, non jugé indépendamment : seule votre propre définition de {definition} dit ce que"
        " font ses fichiers"
    ),
    "reading_off": "{traverse} à {target} (écart {off})",
    "scale_by": "{axis} : échelle {scale} d'après {tests:join|; }",
    "traverse": "parcours {run} dans le sens {direction}",
    "value_with_error": "{value:+.1f} ± {error:.1f} {unit}",
    "with_and_without": "{parameter} {value} avec, {without} sans",
}
