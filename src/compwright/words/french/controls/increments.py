"""French texts for the controls of `formats.families.increments`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save all parameters and the pitch error data of the control to a card or PC; they are"
    " two files from two screens. Keep them untouched.": (
        "Sauvegarder tous les paramètres et les données d'erreur de pas de la commande sur une"
        " carte ou un PC ; ce sont deux fichiers de deux écrans. Les garder intacts."
    ),
    "Record the old values": "Noter les anciennes valeurs",
    "Axis {name} is controlled axis {address}. Note its old 1851 and {at_reference} to"
    " {at_spacing} before you change them.": (
        "Axe {name} : c'est l'axe commandé {address}. Noter ses anciennes valeurs 1851 et"
        " {at_reference} à {at_spacing} avant de les changer."
    ),
    "Load parameters and pitch data, both in one step": (
        "Charger les paramètres et les données de pas, les deux en une étape"
    ),
    "Both, before the control is switched off and before any axis moves: a new"
    " {at_magnification} multiplies old points, new numbers give them to other sections."
    " Parameters: {at_reference} = {reference_number}, {at_first} = {first_number},"
    " {at_last} = {last_number}, {at_magnification} = {magnification}, {at_spacing} ="
    " {spacing} {unit}, 1851 = {backlash} detection units of {detection_unit}, {further}"
    " (axis {address} only; leave the groups of the other axes alone). Pitch data: points"
    " {first_number} to {last_number}: load the pitch data file of the folder tables/, or"
    " type in the sheet entry_{sheet}.csv. That a control takes the form in which it gives"
    " its points out has not been tried here: compare the screen with the sheet.": (
        "Les deux, avant d'éteindre la commande et avant tout mouvement d'un axe : une nouvelle"
        " valeur {at_magnification} multiplie les anciens points, de nouveaux numéros les"
        " donnent à d'autres segments. Paramètres : {at_reference} = {reference_number},"
        " {at_first} = {first_number}, {at_last} = {last_number}, {at_magnification} ="
        " {magnification}, {at_spacing} = {spacing} {unit}, 1851 = {backlash} unités de"
        " détection de {detection_unit}, {further} (axe {address} seulement ; ne pas toucher"
        " aux groupes des autres axes). Données de pas : points {first_number} à {last_number}"
        " : charger le fichier des données de pas du dossier tables/, ou saisir la feuille"
        " entry_{sheet}.csv. Qu'une commande accepte la forme sous laquelle elle donne ses"
        " points n'a pas été essayé ici : comparer l'écran avec la feuille."
    ),
    "Alarm 000 (power off) is expected. Switch the control off and on: the parameters of the"
    " table are active only after that.": (
        "L'alarme 000 (couper l'alimentation) est attendue. Éteindre et rallumer la commande :"
        " les paramètres de la table ne sont actifs qu'après cela."
    ),
    "Reference the axis": "Référencer l'axe",
    "{referencing}": "{referencing}",
    "No page of the maker states the sign of pitch data. Before the full test measure two"
    " positions, {check_from} and {check_to} {unit}, with {at_magnification} ="
    " {magnification} and with {at_magnification} = 0 (power cycle each time): with"
    " compensation on, the distance must be {check_change} longer (negative: shorter). If it"
    " is the opposite, set the option pitch_sign to {other_sign} and run again.": (
        "Aucune page du fabricant n'indique le signe des données de pas. Avant l'essai complet,"
        " mesurer deux positions, {check_from} et {check_to} {unit}, avec {at_magnification} ="
        " {magnification} et avec {at_magnification} = 0 (éteindre et rallumer chaque fois) :"
        " avec la compensation, la distance doit être plus longue de {check_change} (négatif :"
        " plus courte). Si c'est l'inverse, mettre l'option pitch_sign à {other_sign} et"
        " recommencer le calcul."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive 1851 moves on in the direction of"
    " the new motion.": (
        "Mettre à zéro un comparateur en arrivant en {reference_return}, puis revenir de"
        " l'autre côté : la différence qui reste doit être petite. Une valeur 1851 positive"
        " avance dans le sens du nouveau mouvement."
    ),
    "Save parameters and pitch data again and compare them with the plan: `compwright"
    " compare JOB_FOLDER --loaded READ_BACK`.": (
        "Sauvegarder encore les paramètres et les données de pas et les comparer avec le plan :"
        " `compwright compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "Load the saved parameters and pitch data in one step, then power cycle and reference as"
    " above. By hand: 1851 and {at_reference} to {at_spacing} as noted; {at_magnification} ="
    " 0 switches the points of axis {address} off.": (
        "Charger les paramètres et les données de pas sauvegardés en une étape, puis éteindre,"
        " rallumer et référencer comme ci-dessus. À la main : 1851 et {at_reference} à"
        " {at_spacing} comme notés ; {at_magnification} = 0 désactive les points de l'axe"
        " {address}."
    ),
    "straightness compensation is an option of the control, and its parameter numbers are"
    " not confirmed here: enter the two-point line by the machine's own manual": (
        "la compensation de rectitude est une option de la commande, et ses numéros de"
        " paramètres ne sont pas confirmés ici : entrer la droite à deux points d'après le"
        " manuel de la machine"
    ),
    "1851 of axis {address} = {backlash} detection units of {detection_unit}": (
        "1851 de l'axe {address} = {backlash} unités de détection de {detection_unit}"
    ),
    "1852 = {value} detection units ({active})": "1852 = {value} unités de détection ({active})",
    "at rapid traverse; 1851 is active at cutting feed, because 1800#4 = 1": (
        "en rapide ; 1851 est actif en avance de travail, parce que 1800#4 = 1"
    ),
    "is not active and stays as it is: 1851 is active at all feeds, because 1800#4 = 0": (
        "n'est pas actif et reste tel quel : 1851 est actif à toute avance, parce que 1800#4 = 0"
    ),
    "is active at rapid traverse if 1800#4 = 1, which is in no file": (
        "est actif en rapide si 1800#4 = 1, ce qui n'est dans aucun fichier"
    ),
    "{sentence} Prove the sign with a square or a dial gauge, on and off, before production.": (
        "{sentence} Prouver le signe avant la production avec une équerre ou un comparateur,"
        " avec et sans."
    ),
    "{sentence} Its numbers and its sign are unconfirmed: prove them with a square or a dial"
    " gauge, on and off, before production.": (
        "{sentence} Ses numéros et son signe ne sont pas confirmés : les prouver avant la"
        " production avec une équerre ou un comparateur, avec et sans."
    ),
    "{output} over {input}: straightness compensation": (
        "{output} sur {input} : compensation de rectitude"
    ),
    "every pair of straightness compensation (5711 to 5713) is in use": (
        "toutes les paires de la compensation de rectitude (5711 à 5713) sont utilisées"
    ),
    "straightness compensation counts the points of the pitch table of the moving axis {input},"
    " which has none. Next: give {input} a positioning test (`before`), or the control's files with"
    " its pitch data (`states`)": (
        "la compensation de rectitude compte les points de la table de pas de l'axe mobile"
        " {input}, qui n'en a pas. Ensuite : donner à {input} un essai de positionnement"
        " (`before`), ou les fichiers de la commande avec ses données de pas (`states`)"
    ),
    "straightness compensation is known for one straight line over a table only": (
        "la compensation de rectitude n'est connue que pour une droite sur une table"
    ),
    "Absolute encoder: no reference return. Leave its adjustment alone (1815): machine zero"
    " would be lost.": (
        "Codeur absolu : pas de prise de référence. Ne pas toucher à son réglage (1815) : le"
        " zéro machine serait perdu."
    ),
    "owns {low} to {high} {unit}": "possède {low} à {high} {unit}",
    "A point holds the change of the correction over its own section, looking from - to +,"
    " in detection units times the magnification; at the reference position ({zero} {unit})"
    " the correction is 0.": (
        "Un point contient le changement de la correction sur son propre segment, vu de - vers"
        " +, en unités de détection fois le facteur ; à la position de référence ({zero}"
        " {unit}), la correction est 0."
    ),
    "it stands for the same section as point {last} and must hold the same value": (
        "il représente le même segment que le point {last} et doit contenir la même valeur"
    ),
    "{parameter} = {number} {owns}, the last.": "{parameter} = {number} {owns}, le dernier.",
    "set too: {function}, whose points are in the sheet; its sign and where its period"
    " starts are unconfirmed, so measure one period in its sections with it and with 14985"
    " to 14987 = 0 (power cycle each time) before production": (
        "réglé aussi : {function}, dont les points sont dans la feuille ; son signe et le début"
        " de sa période ne sont pas confirmés, mesurer donc une période dans ses segments avec"
        " elle et avec 14985 à 14987 = 0 (éteindre et rallumer chaque fois) avant la production"
    ),
    "set too: {function}; its sign and unit are unconfirmed, so measure both ends of the"
    " travel with these amounts and with 0 (power cycle each time) before you switch on the"
    " whole table": (
        "réglé aussi : {function} ; signe et unité ne sont pas confirmés, mesurer donc les deux"
        " bouts de la course avec ces valeurs et avec 0 (éteindre et rallumer chaque fois)"
        " avant d'activer toute la table"
    ),
    "leave unchanged what is active in addition to the table: {kept}": (
        "laisser tel quel ce qui est actif en plus de la table : {kept}"
    ),
    "{value} detection units": "{value} unités de détection",
    "{parameter} = {reference} is the number of the reference: {owns}; {next} to {last} are"
    " the sections of one turn and add up to 0.": (
        "{parameter} = {reference} est le numéro de la référence : {owns} ; {next} à {last}"
        " sont les segments d'un tour et leur somme est 0."
    ),
    "{parameter} = {number} {owns}, the first.": "{parameter} = {number} {owns}, le premier.",
    "For travel in - the same sections have the numbers {first} to {last} ({parameter}).": (
        "Pour la course en -, les mêmes segments ont les numéros {first} à {last} ({parameter})."
    ),
    "set too, because the grid moves and these positions stay: {kept}": (
        "réglé aussi, parce que la grille se déplace et que ces positions restent : {kept}"
    ),
    "{parameter} = {number} {owns}, at the reference.": (
        "{parameter} = {number} {owns}, à la référence."
    ),
    "Point {number} holds {value}: its section lies beyond the travel.": (
        "Le point {number} contient {value} : son segment est au-delà de la course."
    ),
    "it owns no section": "il ne possède aucun segment",
    "Bit 0 of 8135 (NPE) must be 0: 1 switches stored pitch error compensation off.": (
        "Le bit 0 de 8135 (NPE) doit être 0 : 1 désactive la compensation mémorisée des erreurs"
        " de pas."
    ),
    "3623 of axis {address}: the pitch data are multiplied by it, 0 switches the table off.": (
        "3623 de l'axe {address} : les données de pas sont multipliées par lui, 0 désactive la"
        " table."
    ),
    "Were the pitch data loaded too? They come from another screen than the parameters;"
    " compare the points with the sheet.": (
        "Les données de pas ont-elles été chargées aussi ? Elles viennent d'un autre écran que"
        " les paramètres ; comparer les points avec la feuille."
    ),
    "3620 to 3627 are active only after power off and on, and then, with an incremental"
    " encoder, only after the reference return.": (
        "3620 à 3627 ne sont actifs qu'après extinction et remise sous tension, et alors, avec"
        " un codeur incrémental, qu'après la prise de référence."
    ),
    "Save parameters and pitch data again and compare them with the plan (`compwright"
    " compare JOB_FOLDER --loaded READ_BACK`): 5420 to 5425, 1851 and the points tell apart"
    " what this test cannot.": (
        "Sauvegarder encore les paramètres et les données de pas et les comparer avec le plan"
        " (`compwright compare JOB_FOLDER --loaded READ_BACK`) : 5420 à 5425, 1851 et les"
        " points distinguent ce que cet essai ne peut pas."
    ),
    "5423 of axis {address}: the pitch data are multiplied by it, 0 switches the table off.": (
        "5423 de l'axe {address} : les données de pas sont multipliées par lui, 0 désactive la"
        " table."
    ),
    "Were the pitch data loaded too? Compare the points with the sheet.": (
        "Les données de pas ont-elles été chargées aussi ? Comparer les points avec la feuille."
    ),
    "5420 to 5425 are active only after power off and on, and then, with an incremental"
    " encoder, only after the reference return.": (
        "5420 à 5425 ne sont actifs qu'après extinction et remise sous tension, et alors, avec"
        " un codeur incrémental, qu'après la prise de référence."
    ),
    "No page of the maker states the sign of pitch data: compare 5423 as set with 5423 = 0"
    " as the card says; if the distance changes the wrong way, run again with the other"
    " pitch_sign.": (
        "Aucune page du fabricant n'indique le signe des données de pas : comparer 5423 tel que"
        " réglé avec 5423 = 0 comme le dit la fiche ; si la distance change à l'envers,"
        " recommencer le calcul avec l'autre pitch_sign."
    ),
    "Were the points typed in as errors? The sheet holds corrections, as steps from point to"
    " point.": (
        "Les points ont-ils été saisis comme erreurs ? La feuille contient des corrections, en"
        " pas de point à point."
    ),
    "5423 of axis {address}: every point is multiplied by it.": (
        "5423 de l'axe {address} : chaque point est multiplié par lui."
    ),
    "The detection unit of axis {address}: another one than the job's scales table and 1851"
    " alike, mostly by 10.": (
        "L'unité de détection de l'axe {address} : une autre que celle du dossier de travail"
        " change d'échelle la table et 1851 de même, le plus souvent de 10."
    ),
    "Bit 3 of 1006 (diameter): radius and diameter differ by 2.": (
        "Bit 3 de 1006 (diamètre) : rayon et diamètre diffèrent d'un facteur 2."
    ),
    "5420 of axis {address}, the number of the point at the reference position: one too many"
    " moves the table by one interval (5424).": (
        "5420 de l'axe {address}, le numéro du point à la position de référence : un de trop"
        " déplace la table d'un intervalle (5424)."
    ),
    "Were the points typed in from the right number on? Number n stands for the section"
    " below the point n - 5420.": (
        "Les points ont-ils été saisis à partir du bon numéro ? Le numéro n représente le"
        " segment au-dessous du point n - 5420."
    ),
    "Were the points typed in from the wrong end? Their numbers grow in the direction +,"
    " from 5421 to 5422, on both sides of the reference.": (
        "Les points ont-ils été saisis à partir du mauvais bout ? Leurs numéros croissent dans"
        " le sens +, de 5421 à 5422, des deux côtés de la référence."
    ),
    "5420 to 5422 of all axes: they share one row of points, and the numbers of axis"
    " {address} must be its own.": (
        "5420 à 5422 de tous les axes : ils se partagent une rangée de points, et les numéros"
        " de l'axe {address} doivent être à lui."
    ),
    "The A in the parameter file is the number of the controlled axis: {address} for {name}.": (
        "Le A du fichier de paramètres est le numéro de l'axe commandé : {address} pour {name}."
    ),
    "No second table is known here: what is active in one direction only is 1851.": (
        "Aucune deuxième table n'est connue ici : ce qui n'agit que dans un sens est 1851."
    ),
    "1851 of axis {address}, in detection units.": (
        "1851 de l'axe {address}, en unités de détection."
    ),
    "It is active from the first move against the reference return on, so approach twice from"
    " each side before a reading counts.": (
        "Il agit à partir du premier mouvement opposé à la prise de référence, donc approcher"
        " deux fois de chaque côté avant qu'une lecture compte."
    ),
    "5421 and 5422 of axis {address}, the points farthest in - and in +: beyond them the"
    " table does not go on.": (
        "5421 et 5422 de l'axe {address}, les points extrêmes en - et en + : au-delà la table"
        " ne continue pas."
    ),
    "Are all points between them in the control? Compare the screen with the sheet, point by"
    " point.": (
        "Tous les points entre eux sont-ils dans la commande ? Comparer l'écran avec la"
        " feuille, point par point."
    ),
    "Save parameters and pitch data again and compare both with the plan (`compwright"
    " compare JOB_FOLDER --loaded READ_BACK`): 3620 to 3625, 1851 and the points tell apart"
    " what this test cannot.": (
        "Sauvegarder encore les paramètres et les données de pas et comparer les deux avec le"
        " plan (`compwright compare JOB_FOLDER --loaded READ_BACK`) : 3620 à 3625, 1851 et les"
        " points distinguent ce que cet essai ne peut pas."
    ),
    "No page of the maker states the sign of pitch data: compare 3623 as set with 3623 = 0"
    " as the card says; if the distance changes the wrong way, run again with the other"
    " pitch_sign.": (
        "Aucune page du fabricant n'indique le signe des données de pas : comparer 3623 tel que"
        " réglé avec 3623 = 0 comme le dit la fiche ; si la distance change à l'envers,"
        " recommencer le calcul avec l'autre pitch_sign."
    ),
    "3623 of axis {address}: every point is multiplied by it.": (
        "3623 de l'axe {address} : chaque point est multiplié par lui."
    ),
    "The detection unit of axis {address} (1820 with 1013): another one than the plan's"
    " scales table and 1851 alike, mostly by 10.": (
        "L'unité de détection de l'axe {address} (1820 avec 1013) : une autre que celle du plan"
        " change d'échelle la table et 1851 de même, le plus souvent de 10."
    ),
    "3620 of axis {address}, the number of the point at the reference position: one too many"
    " moves the table by one interval (3624).": (
        "3620 de l'axe {address}, le numéro du point à la position de référence : un de trop"
        " déplace la table d'un intervalle (3624)."
    ),
    "Were the points typed in from the right number on? Number n stands for the section"
    " below the point n - 3620.": (
        "Les points ont-ils été saisis à partir du bon numéro ? Le numéro n représente le"
        " segment au-dessous du point n - 3620."
    ),
    "Were the points typed in from the wrong end? Their numbers grow in the direction +,"
    " from 3621 to 3622, on both sides of the reference.": (
        "Les points ont-ils été saisis à partir du mauvais bout ? Leurs numéros croissent dans"
        " le sens +, de 3621 à 3622, des deux côtés de la référence."
    ),
    "3620 to 3622 of all axes: they share one row of points, and the numbers of axis"
    " {address} must be its own.": (
        "3620 à 3622 de tous les axes : ils se partagent une rangée de points, et les numéros"
        " de l'axe {address} doivent être à lui."
    ),
    "Bit 0 of 3605 of axis {address}: with 1 there are two tables, and the points from 3626"
    " on act while it travels in -.": (
        "Bit 0 de 3605 de l'axe {address} : avec 1 il y a deux tables, et les points à partir"
        " de 3626 agissent pendant la course en -."
    ),
    "3627 ties the second table at the reference position: a wrong value moves one direction"
    " as a whole.": (
        "3627 rattache la deuxième table à la position de référence : une valeur fausse déplace"
        " tout un sens."
    ),
    "1851 of axis {address}, in detection units; where bit 4 of 1800 is 1, 1852 is active in"
    " its place at rapid traverse.": (
        "1851 de l'axe {address}, en unités de détection ; là où le bit 4 de 1800 est 1, 1852"
        " agit à sa place en rapide."
    ),
    "With two tables (bit 0 of 3605) 1851 is active in addition to them, and must be 0 where"
    " the tables hold the reversal.": (
        "Avec deux tables (bit 0 de 3605), 1851 agit en plus et doit être 0 là où elles"
        " contiennent l'inversion."
    ),
    "3621 and 3622 of axis {address}, the points farthest in - and in +: beyond them the"
    " table does not go on.": (
        "3621 et 3622 de l'axe {address}, les points extrêmes en - et en + : au-delà la table"
        " ne continue pas."
    ),
    "{label}: bidirectional compensation": "{label} : compensation dans les deux sens",
    "as 3605#0, 3626 and 3627 are understood": "comme 3605#0, 3626 et 3627 sont compris",
    "no manual page": "aucune page de manuel",
    "no file says what the numbers {numbers} hold; give all of the control's pitch data, or"
    " first_point": (
        "aucun fichier ne dit ce que contiennent les numéros {numbers} ; donner toutes les"
        " données de pas de la commande, ou first_point"
    ),
    "at most {gap} in a row": "au plus {gap} à la suite",
    "point numbers for its table": "numéros de points pour sa table",
    "not checked: the option max_feed is not given, and no file says the rapid traverse (1420)": (
        "non vérifié : l'option max_feed n'est pas donnée, et aucun fichier n'indique le rapide"
        " (1420)"
    ),
    "smallest interval for its feed": "plus petit intervalle pour son avance",
    "{label}: detection unit": "{label} : unité de détection",
    "1820 = {multiplier} (CMR {cmr}) and {system} = {setting} (least command increment {least}"
    " {unit}{inch})": (
        "1820 = {multiplier} (CMR {cmr}) et {system} = {setting} (plus petit incrément de commande"
        " {least} {unit}{inch})"
    ),
    ", inch machine by 1001#0": ", machine en pouces selon 1001#0",
    "read: {evidence}": "lu : {evidence}",
    "FANUC 0i-A to C, 16i/18i/21i, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-A à C, 16i/18i/21i, compensation enregistrée du pas avec jeu à l'inversion (1851)"
    ),
    "FANUC 0i-D, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-D, compensation enregistrée du pas avec jeu à l'inversion (1851)"
    ),
    "FANUC 0i-F, stored pitch error compensation with backlash (1851)": (
        "FANUC 0i-F, compensation enregistrée du pas avec jeu à l'inversion (1851)"
    ),
    "FANUC 15i, stored pitch error compensation with backlash (1851), all numbers unconfirmed": (
        "FANUC 15i, compensation enregistrée du pas avec jeu à l'inversion (1851), tous les"
        " numéros non confirmés"
    ),
    "FANUC 30i/31i/32i, stored pitch error compensation with backlash (1851)": (
        "FANUC 30i/31i/32i, compensation enregistrée du pas avec jeu à l'inversion (1851)"
    ),
    "A-78868E pages 3 and 6 for a rotary worm: numbers in the array of pitch data,"
    " increments, sum 0; sign, 3623 and where the period starts: not on these pages": (
        "A-78868E pages 3 et 6 pour un axe rotatif à vis sans fin : numéros dans le champ des"
        " données de pas, incréments, somme 0 ; signe, 3623 et début de la période : pas dans"
        " ces pages"
    ),
    "B-63522EN/02 page 222: numbers of pitch points, amounts in detection units, added at"
    " the pitch intervals; sign of the pitch data, and that 3623 does not multiply it:"
    " general knowledge": (
        "B-63522EN/02 page 222 : numéros des points de pas, valeurs en unités de détection,"
        " ajoutées aux intervalles du pas ; signe comme celui des données de pas, et que 3623"
        " ne multiplie pas : de connaissance générale"
    ),
    "F1, the sentence is cut": "F1, la phrase est coupée",
    "F1: the reference position has a point number; no manual states that the sections"
    " follow 1240": (
        "F1 : la position de référence a un numéro de point ; aucun manuel ne dit que les"
        " sections suivent 1240"
    ),
    "inferred from a note printed next to F16 and from F20; no sentence of the maker: prove"
    " it on the machine as the card says": (
        "déduit d'une note imprimée près de F16 et de F20 ; aucune phrase du fabricant : le"
        " vérifier sur la machine comme l'indique la fiche"
    ),
    "general knowledge, that of the later series": (
        "de connaissance générale, valeur des séries ultérieures"
    ),
    "general knowledge: 7 on 0i-A to C, 16i, 18i, 21i and 15i": (
        "de connaissance générale : 7 sur 0i-A à C, 16i, 18i, 21i et 15i"
    ),
    "general knowledge: 7, as on the 0i-D": "de connaissance générale : 7, comme sur 0i-D",
    "general knowledge: parameters 5711, 5721, 5731 to 5734, 5761 to 5764": (
        "de connaissance générale : paramètres 5711, 5721, 5731 à 5734, 5761 à 5764"
    ),
    "general knowledge: the interval must be at least the largest feed / 7500": (
        "de connaissance générale : l'intervalle doit être au moins égal à la plus grande"
        " avance / 7500"
    ),
    "{first} to {last} ({count} numbers)": "{first} à {last} ({count} numéros)",
    "not in the files that were given": "absent des fichiers fournis",
    "step": "incrément (step)",
    "1800#4 is not in the files": ("1800#4 n'est pas dans les fichiers"),
    "the bit that makes 1852 active is unknown": ("le bit qui rend 1852 actif est inconnu"),
    "1821 = {count} detection units of {size} {unit} between two marks, encoder on"
    " the motor (1815#1 = 0); inferred": (
        "1821 = {count} unités de détection de {size} {unit} entre deux marques, codeur sur"
        " le moteur (1815#1 = 0) ; déduit"
    ),
}
