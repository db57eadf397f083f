"""French texts for the card and for controls of several `formats.families`, keyed by the English
texts.
"""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save first": "Sauvegarder d'abord",
    "Power cycle": "Éteindre et rallumer",
    "Check the sign": "Vérifier le signe",
    "Check the backlash": "Vérifier le jeu",
    "Read back": "Relire",
    "The old table": "L'ancienne table",
    "Axis {name} is programmed in diameter: the laser and this table count in radius."
    " Programs and displays show twice as much; if the quick check is off by a factor of"
    " two, the control counts its table in diameter": (
        "Axe {name} programmé au diamètre : le laser et cette table comptent au rayon."
        " Programmes et affichages montrent le double ; si la vérification rapide diffère d'un"
        " facteur deux, la commande compte sa table au diamètre"
    ),
    "Restart": "Redémarrer",
    "Gantry": "Portique",
    "{gantry}": "{gantry}",
    "Check what is active": "Vérifier ce qui est actif",
    "{low} to {high} {unit}": "{low} à {high} {unit}",
    "points of the table": "points de la table",
    "range of the table": "étendue de la table",
    "corrections from, to": "corrections de, à",
    "backlash in addition to the table": "jeu en plus de la table",
    "The files in tables/: {files}.": "Les fichiers de tables/ : {files}.",
    "The job says that nothing was active.": "D'après le dossier de travail, rien n'était actif.",
    "To go back: switch the compensation of these axes off as in the steps above (an empty"
    " table), set the backlash by the parameter in column Old of each axis, restart and"
    " reference.": (
        "Pour revenir : désactiver la compensation de ces axes comme aux étapes ci-dessus (une"
        " table vide), régler le jeu par le paramètre de la colonne Ancien de chaque axe,"
        " redémarrer et référencer."
    ),
    "Cross-axis tables: switch off what the steps above switch on, or set each of their values"
    " to 0.": (
        "Tables entre axes : désactiver ce que les étapes ci-dessus activent, ou mettre chacune de"
        " leurs valeurs à 0."
    ),
    "The untouched copies of the old files are in {folder} ({names}).": (
        "Les copies intactes des anciens fichiers sont dans {folder} ({names})."
    ),
    "Load the untouched copies in {folder} ({names}) the same way, restart and reference.": (
        "Charger les copies intactes de {folder} ({names}) de la même façon, redémarrer et"
        " référencer."
    ),
    "To undo: switch off as in the steps above, load {files} from {folder} (the old values"
    " of these axes and their switches; what was set by hand goes back by hand), activate,"
    " restart and reference.": (
        "Pour annuler : désactiver comme aux étapes ci-dessus, charger {files} de {folder} (les"
        " anciennes valeurs de ces axes et leurs commutateurs ; ce qui a été réglé à la main"
        " revient à la main), rendre actif, redémarrer et référencer."
    ),
    "If more than these axes has to go back: switch off the compensation of every axis in"
    " them (what is on is protected), load the untouched copies in {folder} ({names}) the"
    " same way, restart and reference.": (
        "Si plus que ces axes doit revenir : désactiver la compensation de chaque axe qui s'y"
        " trouve (ce qui est activé est protégé), charger les copies intactes de {folder}"
        " ({names}) de la même façon, redémarrer et référencer."
    ),
    "none": "aucun",
    "{name} and {gantry} together": "{name} et {gantry} ensemble",
    "axis {axis} has {name} {becomes} {unit} (now {was} {unit})": (
        "l'axe {axis} a {name} {becomes} {unit} (maintenant {was} {unit})"
    ),
    "With {file} alone {effects}.": "Avec {file} seul, {effects}.",
    "Axis {name} leads a gantry: do every step for the synchronised axis {gantry} too,"
    " before anything moves.{own} A table on the leading axis alone racks the bridge.": (
        "Axe {name} : il mène un portique : faire chaque étape aussi pour l'axe synchronisé"
        " {gantry}, avant tout mouvement.{own} Une table sur le seul axe maître met le portique"
        " de travers."
    ),
    "The job says that {name} is not a gantry master axis. If it is one, stop: a table on"
    " the master axis alone racks the bridge. Name its synchronised axis in the job"
    " (gantry), so that it gets the same table.": (
        "D'après le dossier de travail, {name} n'est pas l'axe maître d'un portique. S'il"
        " l'est, arrêter : une table sur le seul axe maître met le portique de travers. Nommer"
        " son axe synchronisé dans le dossier de travail (gantry), pour qu'il reçoive la même"
        " table."
    ),
    " It has values of its own.": " Il a ses propres valeurs.",
    "{output} over {input}: type in": "{output} sur {input} : saisie",
    "{name}: scale from circles": "{name} : échelle d'après les cercles",
    "{scale} Measure {name} with a laser when you can.": (
        "{scale} Mesurer {name} au laser dès que possible."
    ),
    "Not corrected: {error}": "Non corrigé : {error}",
    ", which also moves {output} as a whole by {constant} µm": (
        ", ce qui déplace aussi {output} dans son ensemble de {constant} µm"
    ),
    "{why}.": "{why}.",
    "(not known)": "(inconnu)",
    "Incremental encoder: reference the axis after the power cycle; no compensation is"
    " active before that.": (
        "Codeur incrémental : référencer l'axe après la remise sous tension ; aucune"
        " compensation n'est active avant."
    ),
    "Absolute encoder: no reference return. Leave its adjustment alone: machine zero would"
    " be lost.": (
        "Codeur absolu : pas de prise de référence. Ne pas toucher à son réglage : le zéro"
        " machine serait perdu."
    ),
    "Distance-coded scale: move the axis over two marks after the power cycle; no"
    " compensation is active before that.": (
        "Règle à marques codées : faire passer l'axe sur deux marques après la remise sous"
        " tension ; aucune compensation n'est active avant."
    ),
    "your own patched {files}": "vos fichiers {files}, tels que modifiés",
    "Nothing yet on a machine: not the form of the files, not sign, size, places and order"
    " of the values, not the backlash. The first good verification on this one with what was"
    " read back (compwright verify --loaded) proves what it can, and writes it down in"
    " proven/.": (
        "Encore rien sur une machine : ni la forme des fichiers, ni signe, taille, places et"
        " ordre des valeurs, ni le jeu. La première bonne vérification sur celle-ci avec ce qui"
        " a été relu (compwright verify --loaded) prouve ce qu'elle peut, et le note dans"
        " proven/."
    ),
    "The files of this card belong together: go through all steps in one go. Move no axis"
    " before all files are loaded and active.": (
        "Les fichiers de cette fiche vont ensemble : faire toutes les étapes d'un seul trait."
        " Ne déplacer aucun axe avant que tous les fichiers soient chargés et actifs."
    ),
    "axis {axis}, test {test}": "axe {axis}, essai {test}",
    "as the file was read ({code})": "comme le fichier a été lu ({code})",
    "All files or none": "Tous les fichiers ou aucun",
    "not given": "non indiqué",
    "default of the definition; {evidence}": "valeur par défaut de la définition ; {evidence}",
    "default of the definition": "valeur par défaut de la définition",
    "option {name}": "option {name}",
    "its tests cover less than half of its travel, which is more than a turn": (
        "ses essais couvrent moins de la moitié de sa course, qui dépasse un tour"
    ),
    "axis {name}: its error repeats every": "axe {name} : son erreur se répète tous les",
    "address of axis {name}": "adresse de l'axe {name}",
    "confirmed: {what}": "confirmé : {what}",
    "unconfirmed: {what}": "non confirmé : {what}",
    "inferred: {what}": "déduit : {what}",
    "{label}: compensation during the test": "{label} : compensation pendant l'essai",
    "the job's answer (active)": "la réponse du dossier de travail (active)",
    "on": "activée",
    "the files end with it switched on (active: no is of the others)": (
        "les fichiers finissent avec elle activée (active: no vaut pour les autres)"
    ),
    "off": "désactivée",
    "axis {name}: kind": "axe {name} : type",
    "{plan} above the files": "{plan} au-dessus des fichiers",
    "general knowledge": "de connaissance générale",
    "a table that was given counts as active": "une table fournie est considérée comme active",
    "absent": "inexistant (absent)",
    "auto": "automatique (auto)",
    "error": "erreur (error)",
    "no": "non (no)",
}
