"""French reasons why a correction between axes is refused, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "0 in the switch, or the values before the switch or in a file of their own, as the control"
    " exports them (NC_CEC.INI)": (
        "0 dans le commutateur, ou les valeurs avant le commutateur ou dans un fichier à part,"
        " comme la commande les exporte (NC_CEC.INI)"
    ),
    "CEC table {index} has to be written, but the control multiplies it by table {other}"
    " ($AN_CEC_MULT_BY_TABLE)": (
        "la table CEC {index} devrait être écrite, mais la commande la multiplie par la table"
        " {other} ($AN_CEC_MULT_BY_TABLE)"
    ),
    "CEC table {index} needs more points than MD18342 reserves": (
        "la table CEC {index} demande plus de points que MD18342 n'en réserve"
    ),
    "CEC table {index} needs more points than a table can have": (
        "la table CEC {index} demande plus de points qu'une table ne peut en avoir"
    ),
    "CEC table {index}: this file switches the table on (SD41300, MD32710) before it gives the"
    " values. A table that is on is protected, so the control takes none of these values": (
        "table CEC {index} : ce fichier active la table (SD41300, MD32710) avant de donner les"
        " valeurs. Une table active est protégée, la commande ne prend donc aucune de ces valeurs"
    ),
    "`cec: absent`, or {parameter}": "`cec: absent`, ou {parameter}",
    "`cec_tables` does not name it": "`cec_tables` ne la nomme pas",
    "a cross-axis table contains one curve, which is the same for both directions": (
        "une table entre axes contient une seule courbe, la même pour les deux sens"
    ),
    "add the file with MD18342 to the control's files, or {step}": (
        "ajouter le fichier avec MD18342 aux fichiers de la commande, ou {step}"
    ),
    "add the file with {name} to the control's files (`states` or `--state`)": (
        "ajouter le fichier avec {name} aux fichiers de la commande (`states` ou `--state`)"
    ),
    "add {index} to `cec_tables`, so that it is changed in place": (
        "ajouter {index} à `cec_tables`, pour qu'elle soit modifiée elle-même"
    ),
    "at most {value}": "au plus {value}",
    "axis {name}: {control} needs a CEC table that is free or already belongs to this axis": (
        "axe {name} : {control} demande une table CEC qui est libre ou appartient déjà à cet axe"
    ),
    "axis {name}: {control} needs {needed} CEC tables that are free or already belong to this"
    " axis": (
        "axe {name} : {control} demande {needed} tables CEC qui sont libres ou appartiennent déjà"
        " à cet axe"
    ),
    "axis {output}: with the correction over {inputs}, the sum of all CEC tables of this axis"
    " would exceed CEC_MAX_SUM (MD32720)": (
        "axe {output} : avec la correction sur {inputs}, la somme de toutes les tables CEC de cet"
        " axe dépasserait CEC_MAX_SUM (MD32720)"
    ),
    "correct this table in the control and export the files again": (
        "corriger cette table dans la commande et exporter de nouveau les fichiers"
    ),
    "end the travel of {input} in the job at a point of the table (multiples of {spacing} from"
    " {first})": (
        "terminer la course de {input} dans le dossier de travail à un point de la table"
        " (multiples de {spacing} à partir de {first})"
    ),
    "export the CEC tables into a file of their own (NC_CEC.INI), then give that file": (
        "exporter les tables CEC dans un fichier à part (NC_CEC.INI), puis donner ce fichier"
    ),
    "free indices in `cec_tables`, at least {needed}": (
        "des indices libres dans `cec_tables`, au moins {needed}"
    ),
    "give a larger `spacing` under `table`": "donner un `spacing` plus grand sous `table`",
    "give fewer points in this entry of `cross`": (
        "donner moins de points dans cette entrée de `cross`"
    ),
    "give other indices in `cec_tables`; or, if the control has this table, add the file with its"
    " MD18342 to the control's files": (
        "donner d'autres indices dans `cec_tables` ; ou, si la commande a cette table, ajouter le"
        " fichier avec son MD18342 aux fichiers de la commande"
    ),
    "give other indices in the option `cec_tables`": (
        "donner d'autres indices dans l'option `cec_tables`"
    ),
    "give the same deviations for both directions in this entry of `cross`": (
        "donner les mêmes écarts pour les deux sens dans cette entrée de `cross`"
    ),
    "indices from 0 to {last}": "des indices de 0 à {last}",
    "it cannot be read as a curve": "elle n'est pas lisible comme courbe",
    "it has room for {room} points": "elle a de la place pour {room} points",
    "its values are in inch (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)": (
        "ses valeurs sont en pouces (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)"
    ),
    "job (`apply` and `cross`)": "dossier de travail (`apply` et `cross`)",
    "lists of the control": "listes de la commande",
    "set `table: {mode: single}` for an axis whose own tables take an index: one table for both"
    " directions needs none": (
        "mettre `table: {mode: single}` pour un axe dont les tables propres occupent un indice :"
        " une table pour les deux sens n'en demande pas"
    ),
    "look in the control for an unused table, and ask the machine's builder; then give its index"
    " as `cec_tables` in the options": (
        "chercher dans la commande une table inutilisée et demander au constructeur de la machine"
        " ; puis donner son indice comme `cec_tables` dans les options"
    ),
    "look in the control for {needed} unused tables, and ask the machine's builder; then give"
    " their indices as `cec_tables` in the options": (
        "chercher dans la commande {needed} tables inutilisées et demander au constructeur de la"
        " machine ; puis donner leurs indices comme `cec_tables` dans les options"
    ),
    "measure again": "mesurer de nouveau",
    "multiply the values of table {index} by {value}": (
        "multiplier les valeurs de la table {index} par {value}"
    ),
    "no equal spacing has its points and those of the correction": (
        "aucun pas constant ne contient ses points et ceux de la correction"
    ),
    "none: the option is not given": "aucun : l'option n'est pas donnée",
    "none in `cec_tables` ({allowed}); those that this job writes for its axes are used": (
        "aucun dans `cec_tables` ({allowed}) ; ceux que ce dossier de travail écrit pour ses axes"
        " sont utilisés"
    ),
    "one curve": "une seule courbe",
    "one other axis": "un seul autre axe",
    "other indices in the option cec_tables": "d'autres indices dans l'option cec_tables",
    "raise MD18342 of this table in the control (this clears its memory), then set `points` to"
    " {count} in the options; or give a larger spacing": (
        "augmenter MD18342 de cette table dans la commande (cela efface sa mémoire), puis mettre"
        " `points` à {count} dans les options ; ou donner un pas plus grand"
    ),
    "reduce the correction or the other tables of this axis, or raise MD32720, then run the job"
    " again": (
        "réduire la correction ou les autres tables de cet axe, ou augmenter MD32720, puis"
        " relancer le dossier de travail"
    ),
    "remove the corrections of axis {output} over {inputs} from the {where}": (
        "retirer les corrections de l'axe {output} sur {inputs} ({where})"
    ),
    "set MD18342 to {count} or more (save an archive, power on, load the archive back) and export"
    " the files again": (
        "mettre MD18342 à {count} ou plus (faire une archive, Power On, recharger l'archive) et"
        " exporter de nouveau les fichiers"
    ),
    "set `cec: absent` in the options, so that no CEC table is written": (
        "mettre `cec: absent` dans les options, pour qu'aucune table CEC ne soit écrite"
    ),
    "set `cec: available` in the options if the control has it, or remove the cross entries from"
    " the job": (
        "mettre `cec: available` dans les options si la commande l'a, ou retirer les entrées"
        " `cross` du dossier de travail"
    ),
    "set {name} to 1 in the control, {then}, and export the files again": (
        "mettre {name} à 1 dans la commande, {then} et exporter de nouveau les fichiers"
    ),
    "the control works in inch (MD10240 = 0), and no file says in which unit its cross-axis"
    " corrections are (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)": (
        "la commande travaille en pouces (MD10240 = 0), et aucun fichier ne donne l'unité de ses"
        " corrections entre axes (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)"
    ),
    "the control's files have no MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) of CEC table {index}, so"
    " the control does not have this table": (
        "les fichiers de la commande n'ont pas MD18342 ($MN_MM_CEC_MAX_POINTS[{index}]) de la"
        " table CEC {index} : la commande n'a donc pas cette table"
    ),
    "the correction differs by direction": "la correction dépend du sens",
    "the correction repeats": "la correction se répète",
    "the job corrects {name} by {parameter} (method: line)": (
        "le dossier de travail corrige {name} par {parameter} (method: line)"
    ),
    "the machine data with MD32711 = 1: metric": (
        "les paramètres machine avec MD32711 = 1 : métrique"
    ),
    "the table that corrects axis {output} over the position of axis {input} has too many points": (
        "la table qui corrige l'axe {output} selon la position de l'axe {input} a trop de points"
    ),
    "this control can correct axis {output} over the position of only one other axis": (
        "cette commande ne peut corriger l'axe {output} que selon la position d'un seul autre axe"
    ),
    "two different curves": "deux courbes différentes",
    "up to {value}": "jusqu'à {value}",
    "{control} has cross-axis tables only if the control has the CEC option": (
        "{control} n'a de tables entre axes que si la commande a l'option CEC"
    ),
    "{found} in `cec_tables` ({allowed})": "{found} dans `cec_tables` ({allowed})",
    "{have}, needed: {count}": "{have}, il en faut : {count}",
    "{label}: no CEC table can be written for this control: {why}": (
        "{label} : aucune table CEC ne peut être écrite pour cette commande : {why}"
    ),
    "{message}; table {index} of these axes takes no further correction: {reasons}": (
        "{message} ; la table {index} de ces axes ne prend pas d'autre correction : {reasons}"
    ),
    "{name} is in no given file, and room is known for {room} points only": (
        "{name} n'est dans aucun fichier donné, et il n'y a de place connue que pour {room} points"
    ),
    "{name} is {value}": "{name} est {value}",
    "{name} is {value}, needed: 0": "{name} est {value}, il faut : 0",
    "{name} is {value}: table {index} is multiplied by it": (
        "{name} est {value} : la table {index} est multipliée par elle"
    ),
    "{one}; or {other}": "{one} ; ou {other}",
    "{parameter} ({name}) is in no given file, needed: 1": (
        "{parameter} ({name}) n'est dans aucun fichier donné, il faut : 1"
    ),
    "{parameter} ({name}) is {value}, needed: 1": "{parameter} ({name}) est {value}, il faut : 1",
    "{parameter} corrects {name} now ({slope} mm/m)": (
        "{parameter} corrige {name} actuellement ({slope} mm/m)"
    ),
    "{steps}, and run again": "{steps}, et relancer",
    "{step}, or add the file with {parameter} to the control's files (`states` or `--state`)": (
        "{step}, ou ajouter le fichier avec {parameter} aux fichiers de la commande (`states` ou"
        " `--state`)"
    ),
    "{value}, and the first value in line {line}": (
        "{value}, et la première valeur à la ligne {line}"
    ),
    "{why}, and a column is active only with tables, never with {parameter}; give {name} a test"
    " and a table of its own": (
        "{why}, et une colonne n'agit qu'avec des tables, jamais avec {parameter} ; donner à"
        " {name} un test et une table à lui"
    ),
    "The column is active only while the bit of {output} in {parameter} is 1. ": (
        "La colonne n'agit que si le bit de {output} dans {parameter} est à 1. "
    ),
    "a column of {file} is for both directions, but the correction has two curves": (
        "une colonne de {file} vaut pour les deux sens, mais la correction a deux courbes"
    ),
    "neighbouring values of {file} would differ too much": (
        "des valeurs voisines de {file} différeraient trop"
    ),
    "no table (.COM) that is active for {input} is among the files": (
        "aucune table (.COM) active pour {input} n'est parmi les fichiers"
    ),
    "the bit of {output} in {parameter} is 0: no table is active on it": (
        "le bit de {output} dans {parameter} est à 0 : aucune table n'agit sur cet axe"
    ),
    "Set the bit of {output} in {parameter} to 1. ": (
        "Mettre à 1 le bit de {output} dans {parameter}. "
    ),
    "{active}If it is 0, and {linear} of {output} or one of its columns in any table is"
    " not 0, leave out this step: set the bit to 1 first and repeat the test. ": (
        "{active}S'il est à 0, et si {linear} de {output} ou l'une de ses colonnes dans"
        " une table n'est pas 0, omettre cette étape : mettre d'abord le bit à 1 et"
        " répéter l'essai. "
    ),
    "no line of {file} is active, and an active line activates every table that it names;"
    " mark the line, repeat the test and give the files as they are then": (
        "aucune ligne de {file} n'est active, et une ligne active met en service chaque"
        " table qu'elle nomme ; marquer la ligne, répéter l'essai et donner les fichiers"
        " dans cet état"
    ),
    "the bit of {output} in {parameter}": ("le bit de {output} dans {parameter}"),
    "the active line of the .CMA": ("la ligne active de la .CMA"),
    "no table is active on {output} now, and {bit} would also activate values that are not"
    " active now ({tables}); empty these columns, or activate them and repeat the test,"
    " then give the files as they are then": (
        "aucune table n'agit sur {output} maintenant, et {bit} mettrait aussi en service"
        " des valeurs inactives maintenant ({tables}) ; vider ces colonnes, ou les mettre"
        " en service et répéter l'essai, puis donner les fichiers dans cet état"
    ),
    "no table is active on {output} now, and not all tables that {bit} would activate are"
    " among the files; give the .CMA and every .COM that its active line names": (
        "aucune table n'agit sur {output} maintenant, et les tables que {bit} mettrait en"
        " service ne sont pas toutes parmi les fichiers ; donner la .CMA et chaque .COM"
        " que sa ligne active nomme"
    ),
    "{file} would need {rows} rows, and the control accepts {most}": (
        "{file} demanderait {rows} lignes, et la commande en accepte {most}"
    ),
    "{file} has no column {column}": "{file} n'a pas de colonne {column}",
    "{file} has no row at a position where the correction bends": (
        "{file} n'a pas de ligne à une position où la correction a un coude"
    ),
    "{file} is active for the motion of several axes: {axes}": (
        "{file} est active pour le mouvement de plusieurs axes : {axes}"
    ),
    "{file} is in inch": "{file} est en pouces",
    "{file} reaches from {low} to {high}, the correction from {first} to {last}": (
        "{file} va de {low} à {high}, la correction de {first} à {last}"
    ),
    "{file}: line {number}": "{file} : ligne {number}",
    "{input} is a rotary axis": "{input} est un axe rotatif",
}
