"""Sentences about the fit of a table."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F001.held": (
        "La table ne couvre pas {uncovered:g} {unit} de la course {side:choose|below=en"
        " dessous|above=au-dessus} de {end:g} {unit}. La commande y maintient la valeur"
        " d'extrémité"
    ),
    "CW-F001.step": (
        "La table ne couvre pas {uncovered:g} {unit} de la course {side:choose|below=en"
        " dessous|above=au-dessus} de {end:g} {unit}. La commande n'y corrige rien, donc l'axe"
        " fait un saut de {step} à cette extrémité"
    ),
    "CW-F002": (
        "{finest:if|{allowed:if|Le plus petit intervalle que cette commande permet ici|Le plus"
        " petit intervalle choisi automatiquement ici}, {spacing} ({points} points),|L'intervalle"
        " de {spacing}} est trop grand pour une erreur de période {periods:g} {unit}."
        " {left_out:if|Cette erreur ({whole} en valeur efficace) n'est pas dans la"
        " table|{share:if|De cette erreur, {whole} en valeur efficace, la table laisse {left}"
        " ({share:.0%})|La table ne laisse rien de cette erreur}}. La table a besoin d'un"
        " intervalle d'un tiers de la période : {needed_spacing:g} {unit}, soit {needed_points}"
        " points sur la course{most_points:if|. Cette commande a {most_points} points}"
    ),
    "CW-F003": (
        "La position de référence ({reference:g} {unit}) est hors de la table (de {start:g} à"
        " {end:g} {unit}). La commande y applique {held:if|la valeur d'extrémité de la table. La"
        " correction doit être nulle à la position de référence, donc cette valeur est nulle|aucune"
        " correction}. L'erreur entre la position de référence et la table n'est pas corrigée"
    ),
    "CW-F004": (
        "La commande a trop peu de points de table pour cette erreur : il en reste {left} en"
        " valeur efficace entre les points"
    ),
    "CW-F005": (
        "La commande a une table pour les deux sens, qui ne peut corriger cette réversibilité :"
        " il en reste {left} en valeur efficace"
    ),
    "CW-F006.grid": (
        "La table dépasse la course de {beyond:g} {unit} au plus, car ses points sont à des"
        " positions rondes, ou là où d'autres colonnes de la même table en ont besoin"
    ),
    "CW-F006.reference": (
        "La commande compte les points de la table depuis la position de référence ({reference:g}"
        " {unit}), qui est hors de la course. Donc {extra} des {nodes_size} points sont au-delà"
        " de la course"
    ),
    "CW-F007": (
        "La correction dépasserait la plus grande valeur que la commande accepte : il reste"
        " {left} de l'erreur en valeur efficace"
    ),
    "CW-F008": (
        "L'erreur est plus raide que le plus grand pas entre deux points de table que la commande"
        " accepte : il en reste {left} en valeur efficace"
    ),
    "CW-F009.compared": (
        "Le grossissement est mis à {magnification} au lieu de {before}, ce qui laisse {left:if|"
        "{left} en valeur efficace|rien} de l'erreur. Avec le grossissement {before}, un pas serait"
        " de {step}. La commande n'enregistre que {increments} pas par point de table : il"
        " resterait donc au moins {at_least} en valeur efficace"
    ),
    "CW-F009.smallest": (
        "Le plus petit grossissement, {magnification}, suffit. Un pas est alors de {step}. La"
        " commande enregistre {increments} pas par point de table : il {left:if|reste {left} en"
        " valeur efficace|ne reste rien} de l'erreur"
    ),
    "CW-F010": (
        "Le dossier de travail demande une table au plus petit {goal}. La table à plus petite"
        " erreur quadratique attendue est utilisée à la place : {why:choose|slope=cette commande"
        " a une pente et pas de table|increments=cette commande n'a que des pas"
        " entiers|no_gain=arrondie à des pas entiers, la table pour {goal} ne montre aucun gain"
        " dans des essais simulés}"
    ),
    "CW-F011": (
        "La nouvelle table garde les points de l'existante, bien qu'ils ne soient espacés que de"
        " {spacing:g} {unit} : {reason}. La commande a fonctionné jusqu'ici avec ces points. Pour"
        " un intervalle assez grand, mettre `spacing: auto` dans la table de l'axe"
    ),
    "mode.one_asked": (
        "Une table et une valeur de réversibilité, comme le demande le dossier de travail"
    ),
    "mode.one_constant": (
        "Une table et une différence constante entre les sens : les mesures ne montrent pas"
        " clairement que cette différence varie le long de la course (logarithme de la cote"
        " {odds:.1f} ; il serait fort à partir de {strong:g})"
    ),
    "mode.one_drift": (
        "Une table et une valeur de réversibilité : la réversibilité varie le long de la course,"
        " mais la dérive dans chaque parcours peut causer seule cette variation, à jeu constant"
    ),
    "mode.one_held": (
        "Une table et une valeur de réversibilité : la commande a une table pour les deux sens"
    ),
    "mode.one_unless_asked": (
        "Une table et une valeur de réversibilité : deux tables ne sont faites que si le dossier de"
        " travail les demande (`mode: bidirectional`)"
    ),
    "mode.slope": "Une pente et une valeur de réversibilité : la commande n'a pas de table",
    "mode.two_asked": "Deux tables, comme le demande le dossier de travail",
    "mode.two_cost": (
        "Deux tables : une différence constante entre les sens laisserait {cost} (valeur"
        " efficace) de plus"
    ),
    "mode.two_vary": (
        "Deux tables, car la réversibilité varie avec la position (logarithme de la cote"
        " {odds:.1f} ; à partir de {strong:g}, la preuve est forte)"
    ),
}
