"""What the fit of a table says."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F001.held": (
        "La table laisse {uncovered:g} {unit} de la course non couverts {side:choose|below=en"
        " dessous|above=au-dessus} de {end:g} {unit} : la valeur d'extrémité y est maintenue"
    ),
    "CW-F001.step": (
        "La table laisse {uncovered:g} {unit} de la course non couverts {side:choose|below=en"
        " dessous|above=au-dessus} de {end:g} {unit} : la table n'y donne rien : un saut de {step}"
    ),
    "CW-F002": (
        "{finest:if|Le plus petit intervalle {allowed:if|que cette commande permet|choisi"
        " automatiquement} ici, {spacing} ({points} points),|L'intervalle de {spacing}} ne peut"
        " contenir une erreur de période {periods:g} {unit} : {left_out:if|elle reste hors de la"
        " table, {whole} en valeur efficace|{share:if|sur {whole} en valeur efficace, il en reste"
        " {left} ({share:.0%})|il n'en reste rien}}. Un tiers de la période la contient :"
        " {needed_spacing:g} {unit}, {needed_points} points sur la course{most_points:if| ; cette"
        " commande en a {most_points}}"
    ),
    "CW-F003": (
        "La position de référence ({reference:g} {unit}) est hors de la table (de {start:g} à"
        " {end:g} {unit}) : la commande y applique {held:if|la valeur d'extrémité, qui est donc"
        " nulle|rien}, et l'erreur entre les deux n'est pas corrigée"
    ),
    "CW-F004": (
        "La commande a trop peu de points pour cette erreur : il reste {left} en valeur efficace"
        " entre eux"
    ),
    "CW-F005": (
        "La commande ne peut corriger la réversibilité avec une seule table : il reste {left} en"
        " valeur efficace"
    ),
    "CW-F006.grid": (
        "La table dépasse la course de {beyond:g} {unit} au plus : ses points sont à des positions"
        " rondes, ou là où d'autres colonnes de la même table en ont besoin"
    ),
    "CW-F006.reference": (
        "La commande compte depuis la position de référence ({reference:g} {unit}), hors de la"
        " course : {extra} des {nodes_size} points de la table sont au-delà de la course"
    ),
    "CW-F007": (
        "L'erreur dépasse la plage de valeurs de la commande : il reste {left} en valeur efficace"
    ),
    "CW-F008": (
        "L'erreur est plus raide que le plus grand pas de la commande : il reste {left} en valeur"
        " efficace"
    ),
    "CW-F009.compared": (
        "Grossissement {magnification} : avec {before}, des pas de {increments} fois {step}"
        " laisseraient au moins {at_least} en valeur efficace, avec {magnification} {left:if|{left}"
        " en valeur efficace|rien}"
    ),
    "CW-F009.smallest": (
        "Grossissement {magnification}, le plus petit : des pas de {increments} fois {step}"
        " laissent {left:if|{left} en valeur efficace|rien}"
    ),
    "CW-F010": (
        "Le dossier de travail demande le plus petit {goal}. La table des moindres carrés attendus"
        " est utilisée à la place : {why:choose|slope=cette commande a une pente et pas de"
        " table|increments=cette commande n'a que des pas entiers|no_gain=arrondie à des pas"
        " entiers, la table pour {goal} ne montre aucun gain dans les essais}"
    ),
    "CW-F011": (
        "La grille existante reste bien que ses points soient espacés de {spacing:g} {unit} :"
        " {reason} ; la commande a fonctionné avec elle. table.spacing: auto choisit un pas"
        " assez grand"
    ),
    "mode.one_asked": (
        "Une table et une valeur de réversibilité, comme le demande le dossier de travail"
    ),
    "mode.one_constant": (
        "Une table et une constante entre les sens : ce qui est souhaité ne varie pas davantage"
        " (logarithme de la cote {odds:.1f}, fort à partir de {strong:g})"
    ),
    "mode.one_drift": (
        "Une table et une valeur de réversibilité : la réversibilité varie le long de la course à"
        " peu près comme le montrerait la dérive dans chaque parcours à jeu constant"
    ),
    "mode.one_held": (
        "Une table et une valeur de réversibilité : la commande a une table pour les deux sens"
    ),
    "mode.one_unless_asked": (
        "Une table et une valeur de réversibilité : deux tables seulement si le dossier de travail"
        " les demande (mode: bidirectional)"
    ),
    "mode.slope": "Une pente et une valeur de réversibilité : la commande n'a pas de table",
    "mode.two_asked": "Deux tables, comme le demande le dossier de travail",
    "mode.two_cost": (
        "Deux tables : une constante entre les sens coûterait {cost} (valeur efficace)"
    ),
    "mode.two_vary": (
        "Deux tables : la réversibilité varie avec la position (logarithme de la cote {odds:.1f},"
        " fort à partir de {strong:g})"
    ),
}
