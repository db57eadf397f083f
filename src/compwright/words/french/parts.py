"""Sentences and parts of sentences that several findings use."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "as_written": "{text}",
    "backlash_compensation_larger": (
        "{finding} Les fichiers de la commande l'expliquent : leur compensation de jeu est plus"
        " grande que le jeu à l'inversion de l'axe."
    ),
    "better_targets": "points visés qui montreraient cette erreur : {targets:g} {unit}",
    "between.axes": "{output} sur {input}",
    "between.deviation": "l'écart mesuré de {output} sur {input} ({slope})",
    "between.fault": (
        "{where:if|{where} : |}{message}{expected:if| ; attendu : {expected}|}"
        "{found:if|, trouvé : {found}|}{hint:if|. Ensuite : {hint}|}"
    ),
    "between.faults": "{faults:join| ; }",
    "between.racked": (
        "{output} est un axe de portique, et une table sur {output} sans {partner} vrille la"
        " machine. Ensuite : {squareness:if|corriger la perpendicularité par le décalage de"
        " référence du portique{instead:if|, ou déplacer l'axe {input} à la place"
        " (`{instead}`)|}|faire aligner le guidage de {input}, et retirer cette entrée du dossier"
        " de travail : aucune autre table ne corrige une rectitude}"
    ),
    "between.squareness": "perpendicularité de {output} à {input} ({slope:+.1f} µm/m)",
    "circle.mean": "moyenne de {axes:and}",
    "circle.part": "{start:.5g}° à {end:.5g}°",
    "compared_not_removed": "{parameters:join|; }. Le résultat contient toutes les mesures.",
    "direct_squareness": (
        "{input} et {output} : perpendicularité {squareness:+.1f} µm/m d'après la"
        " {measurements:plural|mesure directe|somme des mesures directes des deux axes}"
    ),
    "doubts.acknowledged": "Confirmé dans le dossier de travail : {reason}. {message}",
    "doubts.compare": (
        "Le contenu de la commande peut différer des fichiers comparés. Relire ses fichiers en"
        " entier et répéter compwright compare"
    ),
    "doubts.first": "Constats à vérifier d'abord : le résultat en dépend",
    "doubts.step": (
        "Rien n'est décidé tant que ces constats ne sont pas réglés. Corriger l'essai ou le dossier"
        " de travail et recommencer. Si la mesure est juste telle quelle, écrire dans le dossier de"
        " travail pourquoi un constat est sans conséquence : `acknowledged: {{{codes:join|: raison,"
        " }: raison}}`"
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
    "of_axis_small": "axe {axis} : {finding}",
    "of_circle": "Cercle {circle} : {finding}",
    "of_test": "Axe {axis}, essai {test} : {finding}",
    "paragraph": "{sentences:join| }",
    "parameter": "{parameter} {value}",
    "range": "{low} à {high}",
    "read_back": (
        "Les tables de {definition} sont relues de leurs fichiers, mais pas vérifiées"
        " indépendamment : seule votre propre définition dit ce que font ces fichiers"
    ),
    "reading_off": "{traverse} à {target} (écart {off})",
    "scale_by": "{axis} : erreur d'échelle {scale} d'après {tests:join|; }",
    "table_advice": (
        "{cause:choose|noise=l'axe ne se répète pas, ce qu'aucune table ne corrige : vérifier"
        " d'abord le montage de l'instrument (vibration, air, fixation), puis appeler un mécanicien"
        " (jeu, guidages, paliers, accouplement, règle)|single outliers=quelques mesures sont"
        " aberrantes, ce qu'aucune table ne corrige : chercher ce qui perturbe la mesure (faisceau"
        " coupé, temps d'arrêt, saleté) et mesurer de nouveau|shifts between traverses=des parcours"
        " entiers sont décalés, ce qu'aucune table ne corrige : vérifier que l'instrument, la"
        " broche et le bridage sont fermes, et chercher un jeu qui diffère d'un parcours à"
        " l'autre|drift=l'axe change pendant l'essai, ce qu'aucune table ne corrige : le mettre en"
        " température comme au travail jusqu'à ce qu'il soit stable, et mesurer de nouveau|one"
        " table for both directions=la réversibilité varie le long de la course, et une table avec"
        " une valeur de réversibilité ne peut la contenir : appeler un mécanicien (écrou, vis,"
        " guidages), ou utiliser une commande avec une table par sens|spacing too wide for the"
        " period=les points sont trop espacés pour une période si courte ; CW-F002 donne"
        " l'intervalle nécessaire. Si la commande ne peut le contenir, appeler un mécanicien (vis,"
        " paliers et accouplement, réducteur, codeur)|error that the test leaves open=l'essai ne"
        " détermine pas assez bien l'erreur : mesurer plus de points visés ou plus de parcours}"
    ),
    "traverse": "parcours {run} dans le sens {direction}",
    "undetermined.bar": (
        "la longueur de la barre n'a pas été étalonnée : donner une longueur étalonnée, ou"
        " mesurer l'axe au laser"
    ),
    "undetermined.both_directions": (
        "la valeur compare les deux sens : mesurer un cercle entier dans les deux sens"
    ),
    "undetermined.causes": (
        "{circle} : ses causes ne peuvent être déterminées à partir de {samples} points de mesure"
        " sur {arc:g}° dans {directions:plural|un sens|les deux sens}"
    ),
    "undetermined.few_at_reversal": (
        "l'arc a trop peu de points de mesure là où l'axe {axis} s'inverse"
    ),
    "undetermined.few_in_time": (
        "le parcours dure {time:3sig} s et a trop peu de points de mesure pour montrer une"
        " vibration"
    ),
    "undetermined.few_near_reversals": (
        "trop peu de points de mesure près des inversions de l'axe {axis} : mesurer à plus faible"
        " avance"
    ),
    "undetermined.full_circle": "{reasons:join|; } : mesurer un cercle entier dans les deux sens",
    "undetermined.lobes": "les lobes appartiennent à un cercle fermé",
    "undetermined.no_end": "ce point d'inversion de {axis} n'est pas dans l'arc",
    "undetermined.no_reversal": "{axis} ne s'inverse pas dans l'arc",
    "undetermined.of_circle": "{circle} : {reason}",
    "undetermined.one_direction": "un seul sens ne peut séparer cette cause du retard et du jeu",
    "undetermined.one_reversal": "l'arc ne contient qu'un point d'inversion de l'axe",
    "undetermined.pitch": (
        "les points de mesure sont trop espacés pour montrer une période : échantillonner plus"
        " vite ou réduire l'avance"
    ),
    "undetermined.prior": (
        "{value:+3sig} ± {error:2sig} {unit} est trop incertain : même sans essai, des valeurs dans"
        " ±{width:g} (écart-type) sont attendues sur les machines, et les points de mesure ne"
        " resserrent guère cette plage"
    ),
    "undetermined.spike": (
        "les points de mesure après l'inversion sont trop peu pour distinguer un pic d'un jeu :"
        " échantillonner plus vite ou réduire l'avance"
    ),
    "undetermined.square": (
        "un arc ne montre pas toutes les erreurs qui comptent dans la tolérance de position"
    ),
    "undetermined.value": (
        "{value:+.1f} ± {error:.1f} µm/m n'est pas assez bien connu : l'incertitude (k = 2) doit"
        " être inférieure à la moitié de la valeur et à {most:g} µm/m{squareness:if|. Mesurer des"
        " cercles entiers dans les deux sens, et les donner tous. La perpendicularité de guidages"
        " courbes demande une équerre|}"
    ),
    "value_with_error": (
        "{decimals:choose|1={value:+.1f} ± {error:.1f}|2={value:+.2f} ± {error:.2f}"
        "|3={value:+.3f} ± {error:.3f}} {unit}"
    ),
    "with_and_without": "{parameter} {value} avec, {without} sans",
}
