"""French texts for the controls of `formats.families.lists`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Keep copies of the compensation value lists, of the axis parameter lists and of the"
    " start-up list.": (
        "Garder des copies des listes de valeurs de compensation, des listes de paramètres"
        " d'axe et de la liste de démarrage."
    ),
    "Load the list": "Charger la liste",
    "tables/ holds the list of axis {address}: {points} entries from {start} to {end},"
    " counted in {counts}, both directions (bilateral 1). Copy it over the list that the"
    " start-up list names for this axis. For a new list a start-up list that is not in"
    " tables/ needs achs_kw_log_ax_nr[i] {address} and achs_kw[i] with the name of the file,"
    " i the next free index, and zahl_kw one more; the TwinCAT configurator writes these"
    " itself.": (
        "tables/ contient la liste de l'axe {address} : {points} entrées de {start} à {end},"
        " comptées en {counts}, dans les deux sens (bilateral 1). La copier sur la liste que la"
        " liste de démarrage nomme pour cet axe. Pour une nouvelle liste, une liste de"
        " démarrage qui n'est pas dans tables/ a besoin de achs_kw_log_ax_nr[i] {address} et de"
        " achs_kw[i] avec le nom du fichier, i l'indice libre suivant, et de zahl_kw plus un ;"
        " le configurateur TwinCAT les écrit lui-même."
    ),
    "Reversal is in the table": "L'inversion est dans la table",
    "The two columns hold the reversal: getriebe[0].lose of axis {address} must be 0, or"
    " lr_param.anwahl_losekomp 0. Where the axis parameter list was given, tables/ holds it"
    " so: load it too.": (
        "Les deux colonnes contiennent l'inversion : getriebe[0].lose de l'axe {address} doit"
        " être 0, ou lr_param.anwahl_losekomp 0. Si la liste de paramètres d'axe a été donnée,"
        " tables/ la contient ainsi : la charger aussi."
    ),
    "Switch on": "Activer",
    "lr_param.ssfk 1 in the parameter list of axis {address}, kw.ssfk.manual_activation 0 or"
    " absent.": (
        "lr_param.ssfk 1 dans la liste de paramètres de l'axe {address},"
        " kw.ssfk.manual_activation 0 ou absent."
    ),
    "Restart or reload": "Redémarrer ou recharger",
    "Restart the control, or reload the lists. {referencing} A value of max_points cannot"
    " change after the start (error 110638).": (
        "Redémarrer la commande, ou recharger les listes. {referencing} Une valeur de"
        " max_points ne peut pas changer après le démarrage (erreur 110638)."
    ),
    "Check the sign before anything else moves": "Vérifier le signe avant tout autre mouvement",
    "That the values are {values}s is not proven. Reference axis {name}, keep clear of"
    " everything. Go to {check_from} {axis_unit}, then to {check_to} {axis_unit}, arriving"
    " in + both times, and measure the distance: once with the compensation off, once with"
    " it on ({name}[COMP OFF LEAD] and {name}[COMP ON LEAD] in the NC program, the axis as"
    " the program calls it). Switched on, the distance must change by {check_change}. If it"
    " changes by the opposite, restore the old list, set the option table_values to the"
    " other choice and run again.": (
        "Que les valeurs signifient {values} n'est pas prouvé. Référencer l'axe {name}, rester"
        " loin de tout. Aller à {check_from} {axis_unit}, puis à {check_to} {axis_unit}, en"
        " arrivant en + les deux fois, et mesurer la distance : une fois compensation"
        " désactivée, une fois activée ({name}[COMP OFF LEAD] et {name}[COMP ON LEAD] dans le"
        " programme CN, l'axe comme le programme l'appelle). Activée, la distance doit changer"
        " de {check_change}. Si elle change à l'inverse, remettre l'ancienne liste, mettre"
        " l'option table_values à l'autre choix et recommencer le calcul."
    ),
    "With {name}[COMP OFF LEAD] and {name}[COMP ON LEAD] compare the check positions (their"
    " table stands with the axis), arriving in + and in -. The displayed position does not"
    " show the compensation: use the instrument.": (
        "Avec {name}[COMP OFF LEAD] et {name}[COMP ON LEAD], comparer les positions de contrôle"
        " (leur tableau est avec l'axe), en arrivant en + et en −. La position affichée ne"
        " montre pas la compensation : utiliser l'instrument."
    ),
    "Copy the compensation value lists, the axis parameter lists and the start-up list from the"
    " control again and compare them with the plan: `compwright compare JOB_FOLDER --loaded"
    " READ_BACK`.": (
        "Copier de nouveau depuis la commande les listes de valeurs de compensation, les listes"
        " de paramètres d'axe et la liste de démarrage, et les comparer au plan : `compwright"
        " compare JOB_FOLDER --loaded READ_BACK`."
    ),
    "Load the saved lists and restart.": "Charger les listes sauvegardées et redémarrer.",
    "no list of this control can be written with it": (
        "aucune liste de cette commande ne peut être écrite avec elle"
    ),
    "Load {files}: {error} is in the list of axis {corrected}, whose master is axis"
    " {master}. lr_param.crosscomp 1 in the parameter list of axis {corrected}; restart or"
    " reload, and reference both axes: no compensation is active before that {input} is"
    " referenced. Outside the table its end values should stay; no page says it. Work"
    " offsets of {output} shift with {input}: probe them again.": (
        "Charger {files} : {error} est dans la liste de l'axe {corrected}, dont l'axe maître"
        " est {master}. lr_param.crosscomp 1 dans la liste de paramètres de l'axe {corrected} ;"
        " redémarrer ou recharger, et référencer les deux axes : aucune compensation n'est"
        " active avant que {input} soit référencé. Hors de la table, ses valeurs d'extrémité"
        " devraient rester ; aucune page ne le dit. Les décalages d'origine de {output} bougent"
        " avec {input} : les palper de nouveau."
    ),
    "{output} over {input}": "{output} sur {input}",
    "{output} over {input}: check the sign": "{output} sur {input} : vérifier le signe",
    "{output} over {input}: load": "{output} sur {input} : charger",
    "No page says in which direction a value of kw.crosscomp moves axis {output};"
    " cross_values: {meaning} is what the job says. Before production, keep clear of"
    " everything, with a dial gauge on {output}: {output}[COMP OFF CROSS], go with {input}"
    " from {start} to {end}, read it; then the same with {output}[COMP ON CROSS]. What is"
    " new must move {output} by {change} {unit} on this way, in addition to the effect of"
    " the old list. If it is the opposite: restore the old list and run again with the other"
    " one.": (
        "Aucune page ne dit dans quel sens une valeur de kw.crosscomp déplace l'axe {output} ;"
        " cross_values: {meaning} est ce que dit le dossier de travail. Avant la production,"
        " rester loin de tout, avec un comparateur sur {output} : {output}[COMP OFF CROSS],"
        " aller avec {input} de {start} à {end}, lire ; puis la même chose avec {output}[COMP"
        " ON CROSS]. Ce qui est nouveau doit déplacer {output} de {change} {unit} sur ce"
        " trajet, en plus de l'effet de l'ancienne liste. Si c'est l'inverse : remettre"
        " l'ancienne liste et recommencer le calcul avec l'autre."
    ),
    "0.1 µm (rotary 0.0001 deg)": "0.1 µm (axe rotatif 0.0001°)",
    "encoder increments (kw.ssfk.unit 0)": "incréments du codeur (kw.ssfk.unit 0)",
    "{name}[COMP OFF LEAD] and {name}[COMP ON LEAD] in an NC program switch only this"
    " table off and on: measure a check position of the card in both states. The displayed"
    " position does not change.": (
        "{name}[COMP OFF LEAD] et {name}[COMP ON LEAD] dans un programme CN désactivent et"
        " activent cette seule table : mesurer une position de contrôle de la fiche dans les deux"
        " états. La position affichée ne change pas."
    ),
    "lr_param.ssfk of axis {address} must be 1 and kw.ssfk.manual_activation 0 (with 1 only"
    " a program switches it on). A table that a program switched off stays off after the"
    " program ends.": (
        "lr_param.ssfk de l'axe {address} doit être 1 et kw.ssfk.manual_activation 0 (avec 1,"
        " seul un programme l'active). Une table qu'un programme a désactivée reste désactivée"
        " après la fin du programme."
    ),
    "The axis must be referenced.": "L'axe doit être référencé.",
    "The start-up list must name the file: achs_kw_log_ax_nr[i] {address} and achs_kw[i], i"
    " below zahl_kw; lists are read at the start.": (
        "La liste de démarrage doit nommer le fichier : achs_kw_log_ax_nr[i] {address} et"
        " achs_kw[i], i inférieur à zahl_kw ; les listes sont lues au démarrage."
    ),
    "That the values are errors is not proven: compare COMP OFF LEAD with COMP ON LEAD as"
    " the card says; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Que les valeurs soient des erreurs n'est pas prouvé : comparer COMP OFF LEAD avec COMP"
        " ON LEAD comme le dit la fiche ; si la distance change à l'envers, recommencer le"
        " calcul avec l'autre table_values."
    ),
    "kw.ssfk.unit: 1 counts 0.1 µm (0.0001 degrees), 0 encoder increments, for positions and"
    " values.": (
        "kw.ssfk.unit : 1 compte 0.1 µm (0.0001 degré), 0 des incréments du codeur, pour"
        " positions et valeurs."
    ),
    "kw.ssfk.kw_startpos and kw.ssfk.interval, or with interval 0 the setpoint of each entry.": (
        "kw.ssfk.kw_startpos et kw.ssfk.interval, ou avec l'intervalle 0 la consigne de chaque"
        " entrée."
    ),
    "Entry 0 stands at kw.ssfk.kw_startpos, the others above it: were they entered from the"
    " other end?": (
        "L'entrée 0 est à kw.ssfk.kw_startpos, les autres au-dessus : ont-elles été entrées à"
        " partir de l'autre bout ?"
    ),
    "kopf.achs_nr in the list and achs_kw_log_ax_nr[i] in the start-up list: the logical"
    " number {address}.": (
        "kopf.achs_nr dans la liste et achs_kw_log_ax_nr[i] dans la liste de démarrage : le"
        " numéro logique {address}."
    ),
    "kw.ssfk.bilateral: with 1 the column pos is active in + and neg in -, with 0 there is"
    " one column.": (
        "kw.ssfk.bilateral : avec 1, la colonne pos agit en + et neg en -, avec 0 il y a une"
        " colonne."
    ),
    "getriebe[0].lose and lr_param.anwahl_losekomp of axis {address}: a table with two"
    " columns takes their place, so one of them must be 0.": (
        "getriebe[0].lose et lr_param.anwahl_losekomp de l'axe {address} : une table à deux"
        " colonnes les remplace, donc l'un des deux doit être 0."
    ),
    "kw.ssfk.kw_nr_max is the number of entries, 0 to n - 1; beyond the table its end values"
    " stay.": (
        "kw.ssfk.kw_nr_max est le nombre d'entrées, 0 à n - 1 ; au-delà de la table ses valeurs"
        " d'extrémité restent."
    ),
    "kw.ssfk.max_points must be larger; it cannot change after the start (error 110638).": (
        "kw.ssfk.max_points doit être plus grand ; il ne peut pas changer après le démarrage"
        " (erreur 110638)."
    ),
    "in no list that was given": "dans aucune liste donnée",
    "{label}: {fact}": "{label} : {fact}",
    "ISG kernel (Beckhoff TwinCAT 3 CNC), compensation value lists kw.ssfk and kw.crosscomp": (
        "Noyau ISG (Beckhoff TwinCAT 3 CNC), listes des valeurs de compensation kw.ssfk et"
        " kw.crosscomp"
    ),
    "B19 names them correction and does not define it": (
        "B19 les nomme correction sans définir ce mot"
    ),
    "{label}: its table over axis {over}": ("{label} : sa table selon l'axe {over}"),
    "the meaning of its values is unknown; give the option {option} after the check on the card": (
        "la signification de ses valeurs est inconnue ; donner l'option {option} après "
        "le contrôle de la fiche"
    ),
}
