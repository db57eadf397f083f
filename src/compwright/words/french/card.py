"""Labels and fixed sentences of the commissioning card."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "card.adds": "Ajout de la commande",
    "card.and": "{names:and}",
    "card.axis": "Axe {name}",
    "card.axis_title": "Axe {axis}, adresse dans la commande {address}",
    "card.capital": "{text:capital}",
    "card.check_positions": "Positions de contrôle",
    "card.circle": "Cercle {name}",
    "card.confirmed": "confirmé",
    "card.date": "date",
    "card.decided": "{name} : {decided:join| ; }.",
    "card.evidence": "Preuve : {evidence}",
    "card.expected": "Écart attendu",
    "card.fixed": "Positions fixes qui se déplacent",
    "card.how_to_check": (
        "Faire chaque vérification de cette fiche à ces positions. Lire ce que la commande ajoute"
        " sur son affichage de compensation, si elle en a un. Après le chargement, faire la"
        " vérification rapide avec l'instrument."
    ),
    "card.inferred": "déduit",
    "card.limit": (
        "{symbol} {limit} {unit} : {decision:choose|accept=accepté|reject=refusé|=indécis}"
    ),
    "card.limits": "Limites, telles que prévues",
    "card.lines": "{texts:join|\n}",
    "card.loaded_by": "chargé par",
    "card.look_at": "{text} ({state:choose|inferred=déduit|=non confirmé})",
    "card.measured": "mesuré",
    "card.measured_by": "mesuré après chargement, par",
    "card.more_changes": "{more} autres changements sont dans changes.csv.",
    "card.moves_by": "Déplacement",
    "card.name": "Nom",
    "card.no_title": "Fiche de mise en service",
    "card.not_confirmed": "Non confirmé : vérifier ces points avant que l'axe se déplace vite",
    "card.note": (
        "Les nombres des tableaux et des étapes ont un point décimal, comme on les saisit à une"
        " commande. Les noms des paramètres, options et fichiers sont ceux de la commande et du"
        " dossier de travail.{foreign:if| Les étapes de votre propre définition n'ont pas de"
        " traduction et sont en anglais.} La traduction n'a pas encore été relue par une personne"
        " de langue française."
    ),
    "card.parameter": "{name} = {value}",
    "card.points": "La commande doit avoir au moins {points} points pour cet axe.",
    "card.proven": "Prouvé",
    "card.quantity": "Grandeur",
    "card.rapid": (
        "Mesuré en rapide : le jeu indiqué ici, ce que la commande ajoute et les positions de"
        " contrôle valent en rapide. Vérifier en rapide, pas en avance de travail."
    ),
    "card.read": "lu",
    "card.same_holds": "Cette étape vaut aussi pour l'axe {axes}.",
    "card.sections": "Numéros des segments",
    "card.signature": (
        "Chargé par : ______________________   Date : ______________   Mesuré ensuite : [ ]"
    ),
    "card.steps": "Étapes",
    "card.stop": "Arrêter si différent de plus de",
    "card.then": "{names:join|, puis }",
    "card.title": "Fiche de mise en service : {axes}",
    "card.typed_column": (
        "{what:capital}. {total:if|Remplacer les valeurs dans {where} par|Ajouter aux valeurs dans"
        " {where}} : {rows} ({values:choose|correction=corrections|error=erreurs} ; toutes les"
        " lignes : {sheet}{total:if||, sur des droites entre elles}). {more:if|La table reçoit des"
        " lignes de plus, au même pas : DATUM est la position de la première ligne. Dans une"
        " nouvelle ligne, chaque autre colonne reçoit sa valeur de l'ancienne ligne la plus proche."
        " |}{selected}{check}"
    ),
    "card.unconfirmed": "non confirmé",
    "card.values": "Valeurs qui changent",
    "card.way_back": "Retour",
    "card.with_unit": "{text} ({unit})",
    "card.zeroed": "Mesurer dans cet ordre, l'instrument mis à zéro à la première ligne.",
    "numbering.label": "numéros des segments",
    "numbering.mark": "est la position de référence",
    "numbering.number": "numéro",
    "numbering.parameter": "paramètre",
    "numbering.position": "position",
    "numbering.position_unit": "position, {unit}",
    "numbering.reference": "référence",
    "numbering.travel_negative": "course en -",
}
