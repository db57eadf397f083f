"""Labels and fixed sentences of reports, translated."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": (
        "Ce rapport contient les indications demandées par GOST 27843-2006, 8.1."
    ),
    "basis.iso230_2_1988": (
        "Ce rapport contient les indications demandées par l'ISO 230-2:1997, 7.1. L'édition de 1988"
        " n'a pas de telle liste. Là où le rapport cite un paragraphe, les paragraphes 3.2 et 4.3"
        " de l'édition de 1988 demandent aussi l'indication."
    ),
    "basis.iso230_2_1997": (
        "Ce rapport contient les indications demandées par l'ISO 230-2:1997, 7.1."
    ),
    "basis.iso230_2_2006": (
        "Ce rapport contient les indications demandées par l'ISO 230-2:2006, 7.1."
    ),
    "basis.iso230_2_2014": (
        "Ce rapport contient les indications demandées par l'ISO 230-2:2006, 7.1. Le texte de l'ISO"
        " 230-2:2014 n'était pas disponible ; ses paragraphes ne sont pas cités."
    ),
    "basis.iso230_4_1996": (
        "Ce rapport contient les indications demandées par l'ISO 230-4:1996, 4.4 et 6. L'édition"
        " allemande DIN ISO 230-4:1999 a été utilisée."
    ),
    "basis.iso230_4_2005": (
        "Ce rapport contient les indications demandées par l'ISO 230-4:1996, 4.4 et 6. Le texte de"
        " l'ISO 230-4:2005 n'était pas disponible ; ses paragraphes ne sont pas cités."
    ),
    "basis.vdi3441": (
        "Ce rapport contient les indications demandées par l'ISO 230-2:2006, 7.1. Le texte de la"
        " VDI/DGQ 3441 n'était pas disponible ; ses paragraphes ne sont pas cités."
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
        " {per:choose|length=sur la longueur|test=par essai|reading=par mesure}"
    ),
    "budget.expanded": "Incertitude étendue, k = {k}",
    "budget.misalignment_mm": "Défaut d'alignement de la ligne de mesure",
    "budget.note": (
        "Composantes selon l'ISO 230-2:2006, annexe A. La somme ci-dessus est l'incertitude d'une"
        " mesure en bout de course. Elle n'est pas égale à U d'un paramètre, car U est calculée à"
        " partir des mêmes lois par la définition du paramètre (JCGM 101). Toutes les valeurs"
        " viennent du dossier de travail. Une composante absente du dossier compte pour 0. Aucune"
        " ne vient de l'exemple de la norme."
    ),
    "budget.setup": "Montage de l'instrument",
    "budget.steel": "{alpha:g} µm/(m K), acier, est supposé",
    "budget.sum": "{fixed:g} µm + {per_m:g} µm/m × {length:g} m",
    "budget.temperature_unknown": "la température est inconnue : non comptée",
    "budget.title": "Bilan de l'incertitude de mesure, sur {length}",
    "cause.kind": (
        "{kind:choose|squareness=Perpendicularité {first}{second}|scale_mismatch=Différence"
        " d'échelle {first} − {second}|servo_mismatch=Différence d'asservissement {first} −"
        " {second}|radius_change=Variation du rayon ↺ − ↻|backlash=Jeu à l'inversion"
        " {axis}|lateral_play=Jeu latéral {axis}|reversal_spike=Pic d'inversion"
        " {axis}|cyclic=Erreur périodique {axis}|straightness=Rectitude {axis}|scale_error=Erreur"
        " d'échelle {axis}|backlash_mismatch=Jeu à l'inversion {first} −"
        " {second}|offset_change=Déplacement du centre {axis}, ↺ − ↻|spiral=Spirale (dérive pendant"
        " un tour)|master_slave=Changement d'axe maître|vibration=Vibration|stick_slip=Broutage"
        " {axis}|lobes_2=Deux lobes|lobes_3=Trois lobes|position_loop=Retard de la boucle de"
        " position {axis}|positional_tolerance=Tolérance de position}"
    ),
    "cause.note": (
        "{kind:choose|reversal_spike=pic des lectures {peak} µm"
        "|cyclic=période {period:.4g} mm{phase:if|, phase {phase}°|}"
        "|vibration={frequency:.4g} Hz}"
    ),
    "cause.noted": "{cause} ({note})",
    "cause.part": (
        "en {axis}{part:choose|at_positive=+|at_negative=−|at_positive_ccw=+ ↺|at_positive_cw=+"
        " ↻|at_negative_ccw=− ↺|at_negative_cw=− ↻}"
    ),
    "cause.whole": "{cause} {part}",
    "certificate.name": (
        ""
        "{key:choose|primal=primal|stationarity=stationnarité|dual=dual|complementarity=complémentarité|rounding=arrondi|objective=objectif|lower_bound=borne"
        " inférieure|recomputed=recalculé|magnification=facteur|={name}}"
    ),
    "changes.summary": (
        "{count:plural|{count} entrée change|{count} entrées changent} ; {untouched} lignes des"
        " fichiers de la commande restent telles quelles. Les valeurs sont celles des fichiers,"
        " dans les unités de la commande.{more:if| {more} autres changements sont dans"
        " `changes.csv`.|}"
    ),
    "chart.angle": "Angle en °",
    "chart.bar": "Barre : avant {before}, maintenant {now}, limite {limit}",
    "chart.correction": "Correction que la commande ajoute à la consigne",
    "chart.described": (
        "{what:choose|deviations=écarts de l'axe {name}"
        "|marked=écarts de l'axe {name}, cercles aux extremums des paramètres"
        "|reversal=réversibilité de l'axe"
        " {name}|residual=résidu de l'essai circulaire {name}|correction=correction de l'axe"
        " {name}|comparison=axe {name}, écarts côte à côte|estimate=erreur estimée de l'axe"
        " {name}|circle=essai circulaire {name}}"
    ),
    "chart.estimate": "estimation ({sign})",
    "chart.estimated": "Écart estimé avec ± 2 écarts-types",
    "chart.expected": "moyenne attendue ({sign})",
    "chart.legend": "(+) et (−) : approche dans le sens positif et dans le sens négatif",
    "chart.line": "{parts:join|   }{unit:if| {unit}|}",
    "chart.mean": "moyenne ({sign})",
    "chart.measured": "moyenne mesurée ({sign})",
    "chart.position": "Position en {unit}",
    "chart.quantiles": "{symbol} {median} ({p05} à {p95})",
    "chart.quantity": (
        "{quantity:choose|deviation=Écart|reversal=Réversibilité B|correction=Correction} en {unit}"
    ),
    "chart.radius": "Rayon en µm",
    "chart.readings": "mesures ({sign})",
    "chart.residual": "Mesuré moins ajusté, {sense}",
    "chart.spread": "moyenne ± {coverage:g} s ({sign})",
    "chart.table": "table ({sign})",
    "chart.table_both": "table (+ et −)",
    "chart.wanted": "souhaitée ({sign})",
    "decision.accept": "✓ accepté",
    "decision.no_limit": "sans limite",
    "decision.reject": "✗ refusé",
    "decision.undecided": "? indécis",
    "fact.address": "adresse dans la commande",
    "fact.kind": "type",
    "fact.quantum": "résolution de la table",
    "fact.unit": "unité des écarts",
    "head.after": "Après",
    "head.approach": "Sens d'approche",
    "head.assumed_value": "Valeur supposée",
    "head.axis": "Axe",
    "head.before": "Avant",
    "head.cause": "Cause",
    "head.causes": "Causes",
    "head.clause": "Paragraphe",
    "head.contribution": "Contribution u",
    "head.correction": "Correction{sign:if| {sign}}",
    "head.coverage_factor": "Facteur conventionnel k",
    "head.decision": "Décision",
    "head.distribution": "Loi",
    "head.entry": "Entrée",
    "head.evidence": "Preuve",
    "head.expanded_uncertainty": "Incertitude étendue U",
    "head.extreme": "Extremum",
    "head.fact": "Fait",
    "head.file": "Fichier",
    "head.item": "Indication",
    "head.limit": "Limite",
    "head.limit_on": "Limite sur",
    "head.loading": "Chargement",
    "head.mean": "moyenne {sign}",
    "head.new": "Nouveau",
    "head.old": "Ancien",
    "head.parameter": "Paramètre",
    "head.period": "Période",
    "head.position": "Position",
    "head.predicted": "Prévu",
    "head.predicted_new": "Prévu, nouveaux points visés",
    "head.predicted_same": "Prévu, mêmes points visés",
    "head.probability": "Probabilité",
    "head.quantity": "Grandeur",
    "head.remark": "Remarque",
    "head.residual": "Résidu",
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
    "item.travel": "Longueur d'axe (course)",
    "item.warm_up": "Mise en température avant l'essai",
    "label.after": "après",
    "label.before": "avant",
    "label.circular_test": "essai de circularité",
    "label.coded": "{code} : {text}",
    "label.conformity": "Déclaration de conformité : {statement}",
    "label.control": "commande",
    "label.decision_rule": "Règle de décision : {rule}",
    "label.extreme_at": "{symbol} à {place} {unit}",
    "label.kind": "{kind:choose|linear=axe linéaire|rotary=axe rotatif}",
    "label.machine": "{key:choose|name=machine|serial=numéro de série|type=type|={key}}",
    "label.median": "médiane",
    "label.not_stated": "non indiqué",
    "label.of_the_prediction": "de la prévision",
    "label.plus_minus": "± {U}",
    "label.range": "{low} à {high}",
    "label.test_sentence": (
        "{standard}, {cycle:choose|standard=cycle normal|step=cycle en pas}, {targets}"
        " {targets:plural|point visé|points visés}, parcours : {counts:if|{counts}|aucun}, limites"
        " à ± {coverage} s.{extremes:if| Extremums : {extremes:join| ; }.}{uncertainty:if|| Pas"
        " d'incertitude de mesure : aucune composante n'est indiquée.}"
    ),
    "label.test_title": (
        "Axe {axis:if|{axis}|non nommé}, {name:if|{name}|essai}{label:if|, {label}}"
    ),
    "label.traverses": "{count} en {sign}",
    "label.unconfirmed": "! non confirmé",
    "label.value_error": "{value} ± {error}",
    "label.with_range": "{unit} ; médiane, 5–95 %",
    "label.with_uncertainty": "{unit} ; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "mark.loading": (
        "{verdict:choose|loaded=✓ chargée|undecided=? non décidé|measurement=? défaut de"
        " mesure|not_active=✗ non active|inverted=✗ inversée|scaled=✗ mise à l'échelle|shifted=✗"
        " décalée|mirrored=✗ en miroir|wrong_axis=✗ mauvais axe|increment=✗ changement seul"
        " chargé|on_top=✗ ajoutée à l'ancienne table|state=✗ ancienne table non"
        " active|one_direction=✗ active dans un sens|backlash=✗ valeur de jeu fausse|partial=✗"
        " active en partie|thermal=✗ pente thermique|read_back=✗ diffère du plan|=✗ {verdict}}"
    ),
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
    "rule.band": "{symbol} {U:if|{U} {unit}|non indiqué}",
    "rule.guarded": (
        "Décision avec bande de garde (ISO 14253-1) : accepté si le 95e centile des essais prévus"
        " plus U est dans la limite, refusé si leur 5e centile moins U est au-delà ; U (k = 2) de"
        " l'essai suivant, y compris l'incertitude que le premier essai a apportée à la table :"
        " {bands}."
    ),
    "rule.guarded_after": (
        "Décision avec bande de garde (ISO 14253-1) : accepté si la valeur plus U est dans la"
        " limite, refusé si la valeur moins U est au-delà ; U (k = 2) de l'essai après chargement :"
        " {bands}."
    ),
    "rule.simple": (
        "Accepté si le 95e centile des essais prévus est dans la limite, refusé si leur 5e centile"
        " est au-delà ; l'incertitude de mesure ne compte pas : pas de bandes de garde (ISO"
        " 14253-1)."
    ),
    "rule.simple_after": (
        "Accepté si la valeur mesurée est dans la limite, refusé si elle est au-delà ;"
        " l'incertitude de mesure ne compte pas : pas de bandes de garde (ISO 14253-1)."
    ),
    "severity.error": "✗ erreur",
    "severity.info": "info",
    "severity.warning": "! attention",
}
