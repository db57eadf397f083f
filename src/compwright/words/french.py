"""The French catalogue: labels and fixed sentences of reports. Terms: docs/terms.md."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "Indications selon GOST 27843-2006, 8.1.",
    "basis.iso230_2_1988": (
        "Indications selon l'ISO 230-2:1997, 7.1. L'édition de 1988 n'a pas de liste ; ses"
        " paragraphes 3.2 et 4.3 demandent les indications dont le paragraphe figure ici."
    ),
    "basis.iso230_2_1997": "Indications selon l'ISO 230-2:1997, 7.1.",
    "basis.iso230_2_2006": "Indications selon l'ISO 230-2:2006, 7.1.",
    "basis.iso230_2_2014": (
        "Indications selon l'ISO 230-2:2006, 7.1. Le texte de l'ISO 230-2:2014 n'était pas"
        " disponible ; ses paragraphes ne sont pas cités."
    ),
    "basis.iso230_4_1996": (
        "Indications selon l'ISO 230-4:1996, 4.4 et 6 (lue dans la DIN ISO 230-4:1999)."
    ),
    "basis.iso230_4_2005": (
        "Indications selon l'ISO 230-4:1996, 4.4 et 6. Le texte de l'ISO 230-4:2005 n'était pas"
        " disponible ; ses paragraphes ne sont pas cités."
    ),
    "basis.vdi3441": (
        "Indications selon l'ISO 230-2:2006, 7.1. Le texte de la VDI/DGQ 3441 n'était pas"
        " disponible ; ses paragraphes ne sont pas cités."
    ),
    "budget.E_VE": "Variations de l'environnement (étendue)",
    "budget.U_alpha_instrument": "Coefficient de dilatation de l'instrument",
    "budget.U_alpha_machine": "Coefficient de dilatation de la machine",
    "budget.U_theta_instrument": "Température de l'instrument",
    "budget.U_theta_machine": "Température de la machine",
    "budget.combined": "Incertitude type composée",
    "budget.device": "Instrument de mesure (certificat)",
    "budget.distribution": (
        "{distribution:choose|normal=loi normale, k = 2|rectangular=loi rectangulaire, √12} ;"
        " {per:choose|length=sur la longueur|test=par essai|reading=par lecture}"
    ),
    "budget.expanded": "Incertitude étendue, k = {k}",
    "budget.misalignment_mm": "Défaut d'alignement de la ligne de mesure",
    "budget.note": (
        "Composantes selon l'ISO 230-2:2006, annexe A. La somme vaut pour une lecture en bout de"
        " course. Elle n'est pas égale à U de chaque paramètre (ci-dessus) : là, les mêmes lois"
        " sont propagées par la définition du paramètre (JCGM 101). Toutes les valeurs viennent du"
        " dossier de travail ; une valeur absente compte pour 0. Aucune ne vient de l'exemple de la"
        " norme."
    ),
    "budget.setup": "Montage de l'instrument",
    "budget.title": "Bilan de l'incertitude de mesure, sur {length}",
    "given.approaches": "{counts} ; {cycle:choose|standard=cycle normal|step=cycle en pas}",
    "given.arc": "de {start}° à {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=au début|_end=à la fin}",
    "given.axis": "{axis}, {kind:choose|linear=axe linéaire|rotary=axe rotatif}",
    "given.budget": "voir le bilan de l'incertitude",
    "given.centre": "centre {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.estimator": (
        "s : {spread:choose|std=écart-type, n − 1|range=étendue des lectures} ; limites à"
        " ± {coverage} s ; sans lissage"
    ),
    "given.expansion": (
        "appliquée par compwright : lectures ramenées à 20 °C,"
        " {what:choose|scale=règle|workpiece=pièce} {alpha_m} µm/(m K) à {T_m} °C, instrument"
        " {alpha_d} µm/(m K) à {T_d} °C, point fixe {x_fix} mm"
    ),
    "given.listed": "{items}",
    "given.of_tests": "{names} : {statement}",
    "given.radius": "rayon {radius} mm",
    "given.samples": "{counts} points de mesure",
    "given.sense": "{sense:choose|ccw=sens inverse des aiguilles|cw=sens des aiguilles}",
    "given.smoothing": "aucun par compwright : chaque point compte",
    "given.statements": "{statements:join| ; }",
    "given.targets": "{count} de {first} à {last} {unit} ; liste en annexe A",
    "head.approach": "Sens d'approche",
    "head.clause": "Paragraphe",
    "head.contribution": "Contribution u",
    "head.coverage_factor": "Facteur conventionnel k",
    "head.distribution": "Loi",
    "head.expanded_uncertainty": "Incertitude étendue U",
    "head.extreme": "Extremum",
    "head.file": "Fichier",
    "head.item": "Indication",
    "head.mean": "moyenne {sign}",
    "head.parameter": "Paramètre",
    "head.position": "Position",
    "head.remark": "Remarque",
    "head.sensitivity": "Sensibilité",
    "head.source": "Source",
    "head.standard": "Norme",
    "head.stated": "Contenu",
    "head.test": "Essai",
    "head.unit": "Unité",
    "head.value": "Valeur",
    "head.value_given": "Valeur indiquée",
    "item.air_pressure": "Pression de l'air, début et fin",
    "item.air_shower": "Douche d'air ou d'huile, arrosage",
    "item.air_temperature": "Température de l'air, début et fin",
    "item.approaches": "Nombre d'approches, cycle d'essai",
    "item.axis": "Axe en essai",
    "item.certificate": "Instrument de mesure : certificat d'étalonnage",
    "item.compensation": "Compensation logicielle de la commande : active ou non",
    "item.compensation_routine": "Type de compensation thermique",
    "item.contributors": "Composantes de l'incertitude de mesure",
    "item.date": "Date et heure de l'essai",
    "item.diameter": "Diamètre ou rayon de la trajectoire nominale",
    "item.dwell": "Temps d'arrêt en chaque point visé",
    "item.estimator": "Estimateur de s, lissage",
    "item.expansion": "Correction de dilatation thermique (DDN)",
    "item.feed": "Vitesse d'avance entre les points visés",
    "item.humidity": "Humidité de l'air, début et fin",
    "item.instrument": "Instrument de mesure : fabricant, type",
    "item.instrument_position": "Position de l'instrument de mesure",
    "item.instrument_serial": "Instrument de mesure : numéros de série des composants",
    "item.machine": "Machine : nom et numéro de série",
    "item.machine_type": "Machine : type",
    "item.measuring_line": (
        "Ligne de mesure : emplacement, décalages par rapport à l'outil et à la pièce"
    ),
    "item.operator": "Opérateur",
    "item.other_axes": "Positions des axes non essayés",
    "item.path_feed": "Vitesse de contournage",
    "item.place": "Lieu de l'essai",
    "item.plane": "Axes générant la trajectoire",
    "item.range": "Étendue des données, début et fin",
    "item.samples": "Nombre de points de mesure",
    "item.scale": "Type de règle de la machine",
    "item.scale_expansion": "Coefficient de dilatation de la règle",
    "item.sense": "Sens de parcours",
    "item.sensor_positions": "Emplacement des capteurs de température",
    "item.smoothing": "Lissage",
    "item.standard": "Norme et édition",
    "item.targets": "Points visés",
    "item.temperatures": "Température de la règle ou de la pièce, début et fin",
    "item.temperatures_circle": "Températures de l'environnement, de l'instrument et de la machine",
    "item.temperatures_instrument": "Température des capteurs de l'instrument, début et fin",
    "item.travel": "Course de l'axe",
    "item.warm_up": "Mise en température avant l'essai",
    "label.extreme_at": "{symbol} à {place} {unit}",
    "label.not_stated": "non indiqué",
    "label.plus_minus": "± {U}",
    "label.test_sentence": (
        "{standard}, {cycle:choose|standard=cycle normal|step=cycle en pas}, {targets}"
        " {targets:plural|point visé|points visés}, passages : {counts:if|{counts}|aucun}, limites"
        " à ± {coverage} s.{extremes:if| Extremums : {extremes:join| ; }.}"
        "{uncertainty:if|| Pas d'incertitude de mesure : aucune composante n'est indiquée.}"
    ),
    "label.test_title": "Axe {axis}, {name:if|{name}|essai}{label:if|, {label}}",
    "label.traverses": "{count} en {sign}",
    "label.with_uncertainty": "{unit} ; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "parameter.A": "Exactitude bidirectionnelle de positionnement",
    "parameter.A_negative": "Exactitude unidirectionnelle de positionnement, approche −",
    "parameter.A_positive": "Exactitude unidirectionnelle de positionnement, approche +",
    "parameter.B": "Valeur de réversibilité",
    "parameter.B_mean": "Valeur moyenne de réversibilité",
    "parameter.E": "Écart de position systématique bidirectionnel",
    "parameter.E_negative": "Écart de position systématique unidirectionnel, approche −",
    "parameter.E_positive": "Écart de position systématique unidirectionnel, approche +",
    "parameter.M": "Étendue de l'écart de position bidirectionnel moyen",
    "parameter.P": "Incertitude de position",
    "parameter.Pa": "Écart de position",
    "parameter.Ps_max": "Dispersion de position maximale",
    "parameter.Ps_mean": "Dispersion de position moyenne",
    "parameter.R": "Répétabilité de positionnement bidirectionnelle",
    "parameter.R_negative": "Répétabilité de positionnement unidirectionnelle, approche −",
    "parameter.R_positive": "Répétabilité de positionnement unidirectionnelle, approche +",
    "parameter.U_max": "Réversibilité maximale",
    "parameter.U_mean": "Réversibilité moyenne",
    "report.accreditation": (
        "Ceci est un rapport d'essai et non un certificat d'étalonnage d'un laboratoire accrédité."
        " La traçabilité des valeurs repose sur les certificats d'étalonnage des instruments de"
        " mesure cités."
    ),
    "report.acknowledged": "Doutes confirmés",
    "report.annex_a": "Annexe A : points visés et lectures brutes",
    "report.annex_b": "Annexe B : origine des données",
    "report.axis": "Axe {axis}{name:if|, {name}}",
    "report.both": "les deux",
    "report.circle": "Cercle {plane}{name:if|, {name}}",
    "report.conditions": "Conditions d'essai, {standard}",
    "report.conform": "La machine respecte toutes les limites du tableau ci-dessus.",
    "report.conformity_open": (
        "La conformité n'est pas déclarée : au moins une décision, ou sa base, est ouverte."
    ),
    "report.customer": "Client",
    "report.date": "Date de l'essai",
    "report.extreme": (
        "moyenne {end:choose|highest=max.|lowest=min.}"
        "{what:choose|A= {end:choose|highest=+|lowest=−} {coverage} s|E=|M= ±}"
    ),
    "report.extremes": "Extremums : cercles sur la figure",
    "report.findings": "Constats",
    "report.footer": "Rapport {number}",
    "report.in_english": (
        "Les constats, les textes des figures et les pages des essais de circularité sont en"
        " anglais."
    ),
    "report.in_file": "Dans le fichier : {name}",
    "report.logo": "Logo",
    "report.no_limits": (
        "Aucune limite n'est indiquée. Ce rapport donne des valeurs ; il ne déclare pas la"
        " conformité."
    ),
    "report.no_number": "Rapport sans numéro",
    "report.not_conform": "La machine ne respecte pas toutes les limites du tableau ci-dessus.",
    "report.number": "Numéro du rapport",
    "report.operator": "Opérateur",
    "report.page": "Page",
    "report.page_of": "sur",
    "report.parameters": "Paramètres",
    "report.place": "Lieu",
    "report.provenance": (
        "Évalué par compwright {version}.{command:if| Cette commande refait le rapport :}"
    ),
    "report.readings": "Lectures",
    "report.readings_measured": "Lectures telles que mesurées",
    "report.readings_reduced": "Lectures ramenées à 20 °C",
    "report.results": "Résultats",
    "report.see_tests": "voir les pages des essais",
    "report.sign_checked": "Vérifié par",
    "report.sign_measured": "Mesuré par",
    "report.sign_place": "Lieu, date",
    "report.signs": (
        "Écart : position mesurée moins point visé. Approche + : dans le sens positif de la"
        " machine. B est la moyenne à + moins la moyenne à −."
    ),
    "report.statistics": (
        "Moyennes, écarts-types et répétabilité en {count} {count:plural|point visé|points visés}"
    ),
    "report.title": "Rapport d'essai{tests:plural|| de {tests} essais}",
    "report.unread": "Fichiers non évalués",
    "severity.error": "✗ erreur",
    "severity.info": "info",
    "severity.warning": "! attention",
}
