"""French texts for the controls of `formats.families.pairs`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Make a complete commissioning archive of the NC. Changing MD38000 or MD18342 clears the"
    " static user memory at the next start.": (
        "Faire une archive de mise en service complète de la NC. Changer MD38000 ou MD18342"
        " efface la mémoire utilisateur statique au prochain démarrage."
    ),
    "Access level": "Niveau d'accès",
    "Log in at access level Manufacturer before you load, and before you load the way back:"
    " lines of machine data ($MA_, $SN_) without a checksum are refused at a lower one, and"
    " what they switch stays as it was.": (
        "S'identifier au niveau d'accès Constructeur avant de charger, et avant de charger le"
        " retour : les lignes de données machine ($MA_, $SN_) sans somme de contrôle sont"
        " refusées à un niveau inférieur, et ce qu'elles commutent reste comme avant."
    ),
    "Compare the archive": "Comparer l'archive",
    "{archive}": "{archive}",
    "Reserve the points": "Réserver les points",
    "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] must be at least {points}. If it"
    " is smaller: set it, save an archive, power on, load the archive back.": (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] doit être au moins {points}."
        " S'il est plus petit : le régler, faire une archive, Power On, recharger l'archive."
    ),
    "{room}": "{room}",
    "Switch the old table off": "Désactiver l'ancienne table",
    "Set MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0 and activate it (NEW CONF or"
    " reset). With 1 the table is write protected.{emptied}{others}": (
        "Mettre MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0 et le rendre actif (NEW CONF"
        " ou reset). Avec 1, la table est protégée en écriture.{emptied}{others}"
    ),
    "Set MD32710 $MA_CEC_ENABLE[{address}] = 0, SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
    " tables {table_positive} and {table_negative}, and MD32700"
    " $MA_ENC_COMP_ENABLE[{index},{address}] = 0, and activate all (NEW CONF). With MD32710"
    " = 1 the tables are write protected. MD32700 stays 0. Note what MD32710 was before: if"
    " it was 0, find out what else is inactive on axis {address} (every other table with this"
    " output axis and a value that is not 0), and switch it off (SD41300 = 0) before"
    " anything else. MD32710 would activate it.{others}": (
        "Mettre MD32710 $MA_CEC_ENABLE[{address}] = 0, SD41300 $SN_CEC_TABLE_ENABLE = 0 pour"
        " les tables {table_positive} et {table_negative}, et MD32700"
        " $MA_ENC_COMP_ENABLE[{index},{address}] = 0, et rendre le tout actif (NEW CONF). Avec"
        " MD32710 = 1, les tables sont protégées en écriture. MD32700 reste à 0. Noter ce que"
        " MD32710 était avant : s'il était 0, chercher ce qui est encore inactif sur l'axe"
        " {address} (toute autre table avec cet axe de sortie et une valeur autre que 0), et le"
        " désactiver (SD41300 = 0) avant toute autre chose. MD32710 l'activerait.{others}"
    ),
    "The sign of this table is confirmed by the manual: a positive value moves the axis in"
    " the negative direction. The quick check shows it.": (
        "Le signe de cette table est confirmé par le manuel : une valeur positive déplace l'axe"
        " dans le sens négatif. La vérification rapide le montre."
    ),
    "A positive CEC value moves the axis in - (Function Manual Extended Functions 03/2009,"
    " page 372), which is cec_sign: error; these values were written for the option cec_sign"
    " of the job. Before any file of this set is loaded: stand on axis {name} with a dial"
    " gauge, write 0.1 {unit} into every point of tables {table_positive} and"
    " {table_negative} and switch them on for this check alone: MD32710, NEW CONF, SD41300,"
    " NEW CONF, NCK reset. With cec_sign: correction the axis must move by 0.1 {unit} in +,"
    " with cec_sign: error in -. If it does not: load nothing, and run again with the other"
    " one. Write 0 again and switch them off as in the step before.": (
        "Une valeur CEC positive déplace l'axe en − (Function Manual Extended Functions"
        " 03/2009, page 372), c'est-à-dire cec_sign: error ; ces valeurs ont été écrites pour"
        " l'option cec_sign du dossier de travail. Avant de charger un fichier de ce jeu : avec"
        " un comparateur sur l'axe {name}, écrire 0.1 {unit} dans chaque point des tables"
        " {table_positive} et {table_negative} et les activer pour cette seule vérification :"
        " MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. Avec cec_sign: correction, l'axe"
        " doit se déplacer de 0.1 {unit} en +, avec cec_sign: error en −. Sinon : ne rien"
        " charger, et recommencer le calcul avec l'autre. Réécrire 0 et les désactiver comme à"
        " l'étape précédente."
    ),
    "Load the table": "Charger la table",
    "Load {file_1}: {points} points from {start} to {end} {unit} every {spacing} {unit}. The"
    " table holds the error, the opposite of the correction.": (
        "Charger {file_1} : {points} points de {start} à {end} {unit} tous les {spacing}"
        " {unit}. La table contient l'erreur, l'opposé de la correction."
    ),
    "Load {file_3}: {points} points from {start} to {end} {unit} every {spacing} {unit},"
    " table {table_positive} for travel in +, table {table_negative} for travel in -. Each"
    " holds the whole correction of its direction.": (
        "Charger {file_3} : {points} points de {start} à {end} {unit} tous les {spacing}"
        " {unit}, table {table_positive} pour la course en +, table {table_negative} pour la"
        " course en −. Chacune contient toute la correction de son sens."
    ),
    "Set the backlash and switch the table on": "Régler le jeu et activer la table",
    "{woken}Load {file_2} last (what was loaded with the table is not loaded again), or by"
    " hand: MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} and MD32700"
    " $MA_ENC_COMP_ENABLE[{index},{address}] = 1, which switches the table on. Then NEW"
    " CONF, and power on or reset.{others_back} {referencing}": (
        "{woken}Charger {file_2} en dernier (ce qui a été chargé avec la table n'est pas"
        " rechargé), ou à la main : MD32450 $MA_BACKLASH[{index},{address}] = {backlash}"
        " {backlash_unit} et MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 1, qui active la"
        " table. Ensuite NEW CONF, et Power On ou reset.{others_back} {referencing}"
    ),
    "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first. Set"
    " MD32710 $MA_CEC_ENABLE[{address}] = 1, NEW CONF. Load {file_2} last (what was loaded"
    " with the table is not loaded again), or by hand: MD32450"
    " $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} and SD41300"
    " $SN_CEC_TABLE_ENABLE = 1 for the tables {table_positive} and {table_negative}, which"
    " switches them on. Then NEW CONF, NCK reset.{others_back} {referencing}": (
        "Si MD32710 était 0 avant : d'abord SD41300 = 0 pour ce qui est encore inactif sur l'axe"
        " {address}. Mettre MD32710 $MA_CEC_ENABLE[{address}] = 1, NEW CONF. Charger {file_2}"
        " en dernier (ce qui a été chargé avec la table n'est pas rechargé), ou à la main :"
        " MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit} et SD41300"
        " $SN_CEC_TABLE_ENABLE = 1 pour les tables {table_positive} et {table_negative}, qui"
        " les active. Ensuite NEW CONF, NCK reset.{others_back} {referencing}"
    ),
    "Read the service display 'absolute compensation value measuring system {system}' at the"
    " check positions (their table stands with the axis). It should show the amounts that"
    " the control must add there. Whether this display counts them with the same sign is not"
    " confirmed: compare amounts here; the quick check shows the sign of the table.": (
        "Lire l'affichage de diagnostic « valeur de compensation absolue système de mesure"
        " {system} » aux positions de contrôle (leur tableau est avec l'axe). Il devrait"
        " montrer les valeurs que la commande doit y ajouter. Il n'est pas confirmé que cet"
        " affichage les compte avec le même signe : comparer ici les valeurs absolues ; la"
        " vérification rapide montre le signe de la table."
    ),
    "Read the service display 'compensation, sag + temperature' at the check positions"
    " (their table stands with the axis). It should show the amounts that the control must"
    " add there. Whether this display counts them with the same sign is not confirmed:"
    " compare amounts here; the quick check shows the sign of the table.": (
        "Lire l'affichage de diagnostic « compensation flèche + température » aux positions de"
        " contrôle (leur tableau est avec l'axe). Il devrait montrer les valeurs que la"
        " commande doit y ajouter. Il n'est pas confirmé que cet affichage les compte avec le"
        " même signe : comparer ici les valeurs absolues ; la vérification rapide montre le"
        " signe de la table."
    ),
    "Export the table and the machine data again and compare them with the plan: `compwright"
    " compare JOB_FOLDER --loaded READ_BACK`.": (
        "Exporter encore la table et les données machine et les comparer avec le plan :"
        " `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "By hand: MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0, MD32450"
    " $MA_BACKLASH[{index},{address}] as in column Old, then NEW CONF and power on or reset.": (
        "À la main : MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] = 0, MD32450"
        " $MA_BACKLASH[{index},{address}] comme dans la colonne Ancien, puis NEW CONF et Power"
        " On ou reset."
    ),
    "By hand: SD41300 $SN_CEC_TABLE_ENABLE = 0 for the tables {table_positive} and"
    " {table_negative}, MD32710 $MA_CEC_ENABLE[{address}] as it was, MD32450"
    " $MA_BACKLASH[{index},{address}] as in column Old, then NEW CONF and NCK reset.": (
        "À la main : SD41300 $SN_CEC_TABLE_ENABLE = 0 pour les tables {table_positive} et"
        " {table_negative}, MD32710 $MA_CEC_ENABLE[{address}] comme il était, MD32450"
        " $MA_BACKLASH[{index},{address}] comme dans la colonne Ancien, puis NEW CONF et NCK"
        " reset."
    ),
    "set the option cec: available, if the control has sag compensation, and name free"
    " indices in cec_tables": (
        "mettre l'option cec: available, si la commande a la compensation de flèche, et nommer"
        " des indices libres dans cec_tables"
    ),
    "MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit}": (
        "MD32450 $MA_BACKLASH[{index},{address}] = {backlash} {backlash_unit}"
    ),
    "{room} Set {enable} = 0 and {switch} = 0 for {which}, NEW CONF. Note what MD32710 was"
    " before: if it was 0, find out what else is inactive on axis {address} (every other table"
    " with this output axis and a value that is not 0), and switch it off (SD41300 = 0)"
    " before anything else. MD32710 would activate it.": (
        "{room} Mettre {enable} = 0 et {switch} = 0 pour {which}, NEW CONF. Noter ce que"
        " MD32710 était avant : s'il était 0, chercher ce qui est encore inactif sur l'axe"
        " {address} (toute autre table avec cet axe de sortie et une valeur autre que 0), et le"
        " désactiver (SD41300 = 0) avant toute autre chose. MD32710 l'activerait."
    ),
    "Before {files} is loaded: write {value} {unit} into every point of {which} and switch"
    " {each} on for this check: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. A dial"
    " gauge on {address} must show +{value} {unit} for cec_sign: correction, -{value} {unit} for"
    " cec_sign: error. If it does not: load nothing, and run again with the other one. Write"
    " 0 again and switch off as in the step before.": (
        "Avant de charger {files} : écrire {value} {unit} dans chaque point de {which} et activer"
        " {each} pour cette vérification : MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. Un"
        " comparateur sur {address} doit montrer +{value} {unit} pour cec_sign: correction,"
        " -{value} {unit} pour cec_sign: error. Sinon : ne rien charger, et recommencer le calcul"
        " avec l'autre. Réécrire 0 et désactiver comme à l'étape précédente."
    ),
    "{check} In use: {which}. The file holds its old values plus this correction. After"
    " the check its values are {value} or 0: if you load nothing, load its old values of the folder"
    " rollback again, and set MD32710 and SD41300 as they were.": (
        "{check} En service : {which}. Le fichier contient ses anciennes valeurs plus cette"
        " correction. Après la vérification ses valeurs sont {value} ou 0 : si rien n'est chargé,"
        " recharger ses anciennes valeurs du dossier rollback, et remettre MD32710 et SD41300 à"
        " leur ancienne valeur."
    ),
    "Load {files}. {error}: {output} is moved by {ends}, 0 at the reference of {input}.": (
        "Charger {files}. {error} : {output} est déplacé de {ends}, 0 à la référence de {input}."
    ),
    "If MD32710 was 0 before: SD41300 = 0 for what else is inactive on axis {address}, first. Set"
    " {enable} = 1, NEW CONF, then {switch} = 1 for {which}, NEW CONF, NCK reset. Work"
    " offsets of {output} shift with {input}: probe them again. Compare the result with a"
    " square or a dial gauge before production.": (
        "Si MD32710 était 0 avant : d'abord SD41300 = 0 pour ce qui est encore inactif sur l'axe"
        " {address}. Mettre {enable} = 1, NEW CONF, puis {switch} = 1 pour {which}, NEW CONF,"
        " NCK reset. Les décalages d'origine de {output} bougent avec {input} : les palper de"
        " nouveau. Comparer le résultat avant la production avec une équerre ou un comparateur."
    ),
    "it": "cette table",
    "each of them": "chacune d'elles",
    "{output} over {input}: reserve and switch off": (
        "{output} sur {input} : réserver et désactiver"
    ),
    "{output} over {input}: switch on": "{output} sur {input} : activer",
    "{value} {unit} at {input} {position}": "{value} {unit} à {input} {position}",
    " Set {switch} = 0 (note what it was) and SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
    " {which}, NEW CONF: what the new table takes the place of is emptied, and protected"
    " while it is on.": (
        " Mettre {switch} = 0 (noter ce qu'il était) et SD41300 $SN_CEC_TABLE_ENABLE = 0 pour"
        " {which}, NEW CONF : ce que la nouvelle table remplace est vidé, et protégé tant qu'il"
        " est activé."
    ),
    "If MD32710 was on: set {switch} = 1 again, NEW CONF. ": (
        "Si MD32710 était activé : remettre {switch} = 1, NEW CONF. "
    ),
    "No gantry: MD37100 = 0 in the control's files.": (
        "Pas de portique : MD37100 = 0 dans les fichiers de la commande."
    ),
    " The patched files assign other tables again, which a control protects while they are"
    " on. Set {switches} = 0 too and activate it (NEW CONF).": (
        " Les fichiers modifiés affectent de nouveau d'autres tables, qu'une commande protège"
        " tant qu'elles sont activées. Mettre aussi {switches} = 0 et le rendre actif (NEW"
        " CONF)."
    ),
    " Then set {switches} = 1 again and activate it (NEW CONF).": (
        " Remettre ensuite {switches} = 1 et le rendre actif (NEW CONF)."
    ),
    "The contents of the archive are not verified. Compare on the control, before anything"
    " is changed: {archive}. If one differs, load nothing: export the archive again, and run"
    " again.": (
        "Le contenu de l'archive n'est pas vérifié. Comparer sur la commande, avant tout"
        " changement : {archive}. Si l'une diffère, ne rien charger : exporter encore"
        " l'archive, et recommencer le calcul."
    ),
    "the tables {tables}": "les tables {tables}",
    "{file}, then your own patched {files}": (
        "{file}, puis vos fichiers {files}, tels que modifiés"
    ),
    "tables {tables}": "les tables {tables}",
    "{points} points are needed for {which}: each has room for {room}, none are reserved.": (
        "{points} points sont nécessaires pour {which} : chacune a de la place pour {room},"
        " aucun n'est réservé."
    ),
    "table {tables}": "la table {tables}",
    "MD18342 $MN_MM_CEC_MAX_POINTS must be at least {points} for {which}. If it is smaller:"
    " set it, save an archive, power on, load the archive back.": (
        "MD18342 $MN_MM_CEC_MAX_POINTS doit être au moins {points} pour {which}. S'il est plus"
        " petit : le régler, faire une archive, Power On, recharger l'archive."
    ),
    "The service display 'absolute compensation value measuring system {system}' at the"
    " check positions of the card shows table and backlash together, without any"
    " measurement.": (
        "L'affichage de diagnostic « valeur de compensation absolue système de mesure {system}"
        " », aux positions de contrôle de la fiche, montre table et jeu ensemble, sans aucune"
        " mesure."
    ),
    "The service display 'compensation, sag + temperature' at the check positions of the"
    " card shows what the tables add, without any measurement.": (
        "L'affichage de diagnostic « compensation flèche + température », aux positions de"
        " contrôle de la fiche, montre ce que les tables ajoutent, sans aucune mesure."
    ),
    "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] must be 1; while it is 1 a table is"
    " write protected, so it must have been 0 when the table was loaded.": (
        "MD32700 $MA_ENC_COMP_ENABLE[{index},{address}] doit être 1 ; tant qu'il est 1, une"
        " table est protégée en écriture, il devait donc être 0 quand la table a été chargée."
    ),
    "MD32710 $MA_CEC_ENABLE[{address}] of the output axis and SD41300 $SN_CEC_TABLE_ENABLE"
    " of both tables must be 1; MD32710 must have been 0 when they were loaded.": (
        "MD32710 $MA_CEC_ENABLE[{address}] de l'axe de sortie et SD41300 $SN_CEC_TABLE_ENABLE"
        " des deux tables doivent être 1 ; MD32710 devait être 0 quand elles ont été chargées."
    ),
    "The axis must be referenced, in measuring system {system}: before that no compensation"
    " is active, and a lost reference switches it off.": (
        "L'axe doit être référencé, dans le système de mesure {system} : avant cela rien"
        " n'agit, et une référence perdue le désactive."
    ),
    "Which measuring system is in use? Values, switch and backlash of index {index} act in"
    " system {system} alone.": (
        "Quel système de mesure est utilisé ? Valeurs, commutateur et jeu de l'indice {index}"
        " n'agissent que dans le système {system}."
    ),
    "A positive value of $AA_ENC_COMP moves the axis in -: the table holds the error, as it"
    " was measured. Was it typed in, or converted, as a correction?": (
        "Une valeur positive de $AA_ENC_COMP déplace l'axe en - : la table contient l'erreur,"
        " telle que mesurée. A-t-elle été saisie, ou convertie, comme correction ?"
    ),
    "What a positive CEC value does is the option cec_sign: write +0.1 {unit} into a table"
    " that is free, as the card says; if the axis moves the other way, run again with the"
    " other one.": (
        "Ce que fait une valeur CEC positive est l'option cec_sign : écrire +0.1 {unit} dans"
        " une table libre, comme le dit la fiche ; si l'axe se déplace dans l'autre sens,"
        " recommencer le calcul avec l'autre."
    ),
    "MD10240 and the line METRIC or INCH of the files: inch taken for mm is 25.4.": (
        "MD10240 et la ligne METRIC ou INCH des fichiers : pouces pris pour mm, c'est 25.4."
    ),
    "A second table on the axis: where MD32700 is 1, a CEC table of {address} over itself"
    " (MD32710, SD41300) is active in addition.": (
        "Une deuxième table sur l'axe : une table CEC de {address} sur lui-même (MD32710,"
        " SD41300) à côté de MD32700 agit en plus."
    ),
    "A second table on the axis: MD32700 must be 0 where a pair of CEC tables is used, and"
    " SD41310 $SN_CEC_TABLE_WEIGHT of both 1.": (
        "Une deuxième table sur l'axe : MD32700 doit être 0 à côté d'une paire de tables CEC,"
        " et SD41310 $SN_CEC_TABLE_WEIGHT des deux 1."
    ),
    "Radius and diameter: a table counts the way of the axis, a program in diameter shows"
    " twice of it.": (
        "Rayon et diamètre : une table compte le trajet de l'axe, un programme au diamètre en"
        " montre le double."
    ),
    "$AA_ENC_COMP_MIN and $AA_ENC_COMP_STEP[{index},{address}]: the position of point 0, and"
    " from point to point.": (
        "$AA_ENC_COMP_MIN et $AA_ENC_COMP_STEP[{index},{address}] : la position du point 0, et"
        " de point à point."
    ),
    "$AN_CEC_MIN and $AN_CEC_STEP of both tables: the position of point 0, and from point to"
    " point.": (
        "$AN_CEC_MIN et $AN_CEC_STEP des deux tables : la position du point 0, et de point à point."
    ),
    "Positions of the table are machine positions of {address}: was the axis referenced as"
    " for the measurement?": (
        "Les positions de la table sont des positions machine de {address} : l'axe a-t-il été"
        " référencé comme pour la mesure ?"
    ),
    "Point 0 stands at $AA_ENC_COMP_MIN[{index},{address}] and the last one at MAX: were the"
    " points entered from the other end?": (
        "Le point 0 est à $AA_ENC_COMP_MIN[{index},{address}] et le dernier à MAX : les points"
        " ont-ils été entrés à partir de l'autre bout ?"
    ),
    "Point 0 stands at $AN_CEC_MIN and the last one at MAX in both tables, that for - too:"
    " were the points entered from the other end?": (
        "Le point 0 est à $AN_CEC_MIN et le dernier à MAX dans les deux tables, dans celle pour"
        " - aussi : les points ont-ils été entrés à partir de l'autre bout ?"
    ),
    "The name in the brackets of $AA_ENC_COMP: {address} for axis {name}; by MD10000 a"
    " machine axis may also be called X1.": (
        "Le nom entre les crochets de $AA_ENC_COMP : {address} pour l'axe {name} ; d'après"
        " MD10000, un axe machine peut aussi s'appeler X1."
    ),
    "$AN_CEC_INPUT_AXIS and $AN_CEC_OUTPUT_AXIS of both tables must be ({address}); by"
    " MD10000 a machine axis may also be called X1.": (
        "$AN_CEC_INPUT_AXIS et $AN_CEC_OUTPUT_AXIS des deux tables doivent être ({address}) ;"
        " d'après MD10000, un axe machine peut aussi s'appeler X1."
    ),
    "This table is active in both directions. What is active in one direction only is a CEC"
    " table of the axis over itself ($AN_CEC_DIRECTION, SD41300 $SN_CEC_TABLE_ENABLE) or"
    " MD32450.": (
        "Cette table agit dans les deux sens : ce qui n'agit que dans un est une table CEC de"
        " l'axe sur lui-même ($AN_CEC_DIRECTION, SD41300 $SN_CEC_TABLE_ENABLE) ou MD32450."
    ),
    "$AN_CEC_DIRECTION of the two tables must be 1 and -1, and SD41300 $SN_CEC_TABLE_ENABLE"
    " of both 1.": (
        "$AN_CEC_DIRECTION des deux tables doit être 1 et -1, et SD41300 $SN_CEC_TABLE_ENABLE"
        " des deux 1."
    ),
    "MD32450 $MA_BACKLASH[{index},{address}], times MD32452: positive where the axis loses"
    " motion. It is active after NEW CONF, and once the axis is referenced.": (
        "MD32450 $MA_BACKLASH[{index},{address}], fois MD32452 : positif là où l'axe perd du"
        " mouvement. Il agit après NEW CONF, et une fois l'axe référencé."
    ),
    "MD32456 $MA_BACKLASH_DYN, which the PLC switches, is active in addition to it.": (
        "MD32456 $MA_BACKLASH_DYN, que la PLC commute, agit en plus."
    ),
    "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] must be at least the number of"
    " points: with fewer the control shortens the table.": (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[{index},{address}] doit être au moins le nombre de"
        " points : avec moins, la commande raccourcit la table."
    ),
    "MD18342 $MN_MM_CEC_MAX_POINTS of both tables must be at least the number of points (on"
    " the 828D 200, fixed).": (
        "MD18342 $MN_MM_CEC_MAX_POINTS des deux tables doit être au moins le nombre de points"
        " (sur la 828D 200, fixe)."
    ),
    "$AA_ENC_COMP_MAX[{index},{address}] ends the table, and the end value stays beyond it.": (
        "$AA_ENC_COMP_MAX[{index},{address}] termine la table, et la valeur d'extrémité reste"
        " au-delà."
    ),
    "$AN_CEC_MAX ends the tables, and the end value stays beyond it.": (
        "$AN_CEC_MAX termine les tables, et la valeur d'extrémité reste au-delà."
    ),
    "axis {name}: number of points of its CEC tables (MD18342)": (
        "axe {name} : nombre de points de ses tables CEC (MD18342)"
    ),
    "axis {name}: limit of the sum of its CEC tables (MD32720)": (
        "axe {name} : limite de la somme de ses tables CEC (MD32720)"
    ),
    "not reached (default 1 {unit})": "non atteinte (par défaut 1 {unit})",
    "the control's files do not say it, or reserve none yet": (
        "les fichiers de la commande ne le disent pas, ou n'en réservent pas encore"
    ),
    "in no file, its default from general knowledge": (
        "dans aucun fichier, sa valeur par défaut de connaissance générale"
    ),
    "one manual of Siemens says error; no readings depend on it here": (
        "un manuel de Siemens dit error ; aucune lecture n'en dépend ici"
    ),
    "SINUMERIK 828D, leadscrew error compensation (EEC) with backlash (MD32450), cross-error"
    " compensation (CEC, 8 tables of 200 points) as an option": (
        "SINUMERIK 828D, compensation d'erreur de pas de vis (EEC) avec jeu à l'inversion"
        " (MD32450), compensation de flèche (CEC, 8 tables de 200 points) en option"
    ),
    "SINUMERIK 840D powerline (840Di, 810D), leadscrew error compensation (EEC) with"
    " backlash (MD32450), cross-error compensation (CEC) as an option": (
        "SINUMERIK 840D powerline (840Di, 810D), compensation d'erreur de pas de vis (EEC) avec"
        " jeu à l'inversion (MD32450), compensation de flèche (CEC) en option"
    ),
    "SINUMERIK 840D sl, leadscrew error compensation (EEC) with backlash (MD32450),"
    " cross-error compensation (CEC) as an option": (
        "SINUMERIK 840D sl, compensation d'erreur de pas de vis (EEC) avec jeu à l'inversion"
        " (MD32450), compensation de flèche (CEC) en option"
    ),
    "SINUMERIK ONE, leadscrew error compensation (EEC) with backlash (MD32450), cross-error"
    " compensation (CEC) as an option": (
        "SINUMERIK ONE, compensation d'erreur de pas de vis (EEC) avec jeu à l'inversion"
        " (MD32450), compensation de flèche (CEC) en option"
    ),
    "S1 p242 knows 0 and 1; 0 is the value of memory that was never written": (
        "S1 p242 connaît 0 et 1 ; 0 est la valeur d'une mémoire jamais écrite"
    ),
    "S1 p249 knows 0 and 1; 0 is the value of memory that was never written": (
        "S1 p249 connaît 0 et 1 ; 0 est la valeur d'une mémoire jamais écrite"
    ),
    "a table that was given counts as active; a job is asked (active)": (
        "une table fournie est considérée comme active ; la question est posée au dossier de"
        " travail (active)"
    ),
    "neither the job nor the files say so": "ni le dossier de travail ni les fichiers ne le disent",
    "the sign of its values is not given (option cec_sign)": (
        "le signe de ses valeurs n'est pas indiqué (option cec_sign)"
    ),
    "{label}: during the test": "{label} : pendant l'essai",
    "{switches} end as 0, while the leadscrew table of the axis is on": (
        "{switches} finissent à 0, alors que la table de vis de l'axe est en service"
    ),
}
