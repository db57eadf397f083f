"""French sentences on the report pages of `run`, of `verify` and of circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "circle.about": "{centre:choose|set_up= (centre de montage)|own= (centre propre)}",
    "circle.agreement": (
        "{how:choose|agrees=concorde|differs=diffère|not_valid=non valable|uncertain=trop incertain"
        " pour comparer|definition=autre définition{pitch:if| (aller / retour, au pas de {pitch:g}"
        " mm)|}}"
    ),
    "circle.cause": "{cause}  {value} {unit}",
    "circle.cause_share": "{cause} ({share:.0f} % de tous les effets)",
    "circle.centre": (
        "{name:choose|common=centre commun des moindres carrés|set-up=centre de montage|ccw=centre"
        " des moindres carrés ↺|cw=centre des moindres carrés ↻} : {first} {x}, {second} {y}"
        " µm{H:if| ; H {H} µm|}"
    ),
    "circle.compared": "Comparaison",
    "circle.comparison": (
        "Comparaison avec le logiciel de l'instrument, dont le modèle n'est pas publié. « Concorde"
        " » : les deux valeurs diffèrent d'au plus deux erreurs types de notre valeur. « Diffère »"
        " : de plus. Notre valeur sans pics d'inversion est alors donnée aussi, d'après une"
        " régression simple des mêmes lectures (harmoniques et sauts). « Non valable », valeur"
        " entre parenthèses : ce logiciel déclare lui-même sa valeur non valable. « Trop incertain"
        " pour comparer » : notre erreur type dépasse les deux valeurs. « Autre"
        " définition » : celle du logiciel n'est pas publiée ; la nôtre est dans"
        " docs/evaluation.md."
    ),
    "circle.detail": "– {part}",
    "circle.difference": (
        "diffère. Sans pics d'inversion notre valeur est {plain} {unit}{spikes:if| : les pics font"
        " {share:.0f} % de l'écart| : les pics n'en sont pas la raison}"
    ),
    "circle.effect": "Effet sur le rayon",
    "circle.effects": "Effet, crête à crête, en µm ; traits : 95 %",
    "circle.fit": "ajustement : effet de toutes les causes ensemble",
    "circle.job": (
        "Ajouter ces lignes à un dossier de travail : elles corrigent, par les tables et la"
        " compensation de jeu, les causes qui peuvent l'être ainsi. Créer le dossier de travail"
        " avec `compwright new --from FILE... --format ID --out job.yaml` à partir des fichiers de"
        " la commande, y nommer un essai de positionnement de chaque axe (sa pente corrige"
        " l'échelle), ajouter les lignes{file:if| avec le fichier de chaque sens pour FILE|}. Dans"
        " `centre`, remplacer les axes par les coordonnées machine du centre, en mm. Puis"
        " `compwright run job.yaml`."
    ),
    "circle.least_squares": "cercle des moindres carrés, {base} µm du rayon nominal",
    "circle.magnified": "{setting}\nGrossissement {magnification} : 1, cercles en µm",
    "circle.next": "Que faire ensuite",
    "circle.no_table": "Aucune table ne corrige ces causes. Répéter l'essai après les travaux.",
    "circle.nominal": "trajectoire nominale",
    "circle.open_causes": (
        "Aucune action n'est proposée pour {causes}, car l'erreur type dépasse la moitié de la"
        " valeur. Répéter le cercle, si possible à une avance plus faible ; une cause qui revient"
        " est réelle."
    ),
    "circle.parameter": (
        "{name:choose|G=Écart circulaire, zone minimale|G_lsc=Écart circulaire selon le cercle"
        " des moindres carrés|F_max=Écart radial, le plus grand|F_min=Écart radial, le plus"
        " petit|F_max_lsc=Écart radial, le plus grand, centre des moindres"
        " carrés|F_min_lsc=Écart radial, le plus petit, centre des moindres carrés|H=Hystérésis"
        " circulaire|D=Écart radial moyen}"
    ),
    "circle.pictures": (
        "Aspect de chaque cause seule, très exagéré : sens antihoraire en trait épais, sens"
        " horaire en trait fin."
    ),
    "circle.ranked": "Causes, le plus grand effet d'abord",
    "circle.run": "{sense} : G {G}, F{centre} {highest} / {lowest} µm",
    "circle.scales": "{scales:and}. {step}",
    "circle.sense": "{sense:choose|ccw=↺|cw=↻|both=les deux}",
    "circle.setting": (
        "R {radius} mm{feed:if|, {feed:.5g} mm/min|}{extent:if|, arc de {extent:.4g}° depuis"
        " {start:.4g}°|}"
    ),
    "circle.share": "Part",
    "circle.shares": (
        "Causes, part de tous les effets\n"
        "(pâle : moins de deux erreurs types,\n"
        "à chaque extrémité aussi)"
    ),
    "circle.software": "Logiciel de l'instrument",
    "circle.start": "départ {sense}",
    "circle.step": (
        "{kind:choose|squareness=Mécanique : vérifier le nivellement et l'alignement des guidages."
        " Table : un dossier de travail avec `apply` la corrige là où la commande le peut, si"
        " l'erreur type est inférieure au quart de la valeur et à 15 µm/m.|scale_mismatch=Vérifier"
        " la température des deux axes. Table : mesurer {first} et"
        " {second} au laser et exécuter un dossier de travail avec les deux"
        " essais.|servo_mismatch=Asservissement : donner à {first} et {second} le même gain de"
        " boucle de position (Kv) et la même anticipation.|radius_change=Mesure : répéter les deux"
        " sens à la même vitesse ; vérifier l'assise de l'instrument.|backlash=Mécanique : vérifier"
        " l'écrou, le palier et l'accouplement de la vis {axis}. Corriger ensuite la compensation"
        " de jeu de {axis} dans la commande.|overcompensation=Vérifier d'abord le signe du"
        " fichier. S'il est juste, réduire la compensation de jeu de {axis} dans la commande."
        "|lateral_play=Mécanique : vérifier la précharge et les"
        " lardons du guidage {axis}.|reversal_spike=Asservissement : régler la compensation de"
        " frottement de {axis} à l'inversion. Mécanique : vérifier la lubrification et les"
        " racleurs.|cyclic=Mécanique : vérifier la vis, son palier et la fixation du codeur de"
        " {axis}. Table : au moins trois points par période corrigent ce qui"
        " reste.|straightness=Mécanique : vérifier l'alignement du guidage {axis}. Table : une"
        " table entre les axes la corrige là où la commande en a une (cross).|offset_change=Mesure"
        " : vérifier le support du centre et les coupelles magnétiques ; puis"
        " répéter.|spiral=Mesure : laisser la machine et l'instrument atteindre une température"
        " stable ; puis répéter.|vibration=Chercher la source par sa fréquence{frequency:if|"
        " ({frequency:3sig} Hz)|}{axis:if| sur l'axe {axis}|} : pompe,"
        " ventilateur, moteur. Asservissement : baisser le gain à titre"
        " d'essai.|stick_slip=Mécanique : vérifier la lubrification, les racleurs et la précharge"
        " du guidage {axis}.|master_slave=Asservissement : vérifier les paramètres d'interpolation"
        " de {first} et {second}.}"
    ),
    "circle.sums": "Valeurs qui réunissent plusieurs causes",
    "circle.symbol": (
        "{letter}{sense:if| {sense:choose|ccw=↺|cw=↻|bidirectional=les deux}|}{centre:if|,"
        " {centre:choose|G=cercle des moindres carrés|F=centre des moindres carrés}|}"
    ),
    "circle.to_do": "{cause} ({share:.0f} % de tous les effets). {step}",
    "circle.unexplained": (
        "Les causes ci-dessous laissent {rms} µm (valeur efficace) sans explication."
    ),
    "circle.value_error": "Valeur ± erreur type",
    "circle.zone": (
        "zone minimale{sense:choose|both= des deux|ccw=, ↺|cw=, ↻} : G {G} µm{D:if| ; D {D} µm|}"
    ),
    "given.approaches": "{counts} ; {cycle:choose|standard=cycle normal|step=cycle en pas}",
    "given.arc": "de {start}° à {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=au début de l'essai|_end=à la fin de l'essai}",
    "given.axis": "{axis}, {kind:choose|linear=axe linéaire|rotary=axe rotatif}",
    "given.budget": "voir le bilan de l'incertitude",
    "given.by_job": "{text} (dossier de travail)",
    "given.centre": "centre {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.compensation": (
        "{how:choose|off=non active ; dans la commande :|active=active, comme dans|stored=active,"
        " comme enregistrée dans} {files} (dossier de travail, states.{state})"
    ),
    "given.compensation_loaded": (
        "active : les tables de ce dossier de travail ont été chargées ; ce que l'essai en montre :"
        " voir Chargement"
    ),
    "given.compensation_none": (
        "non active : rien n'était actif dans la commande (dossier de travail, states.{state})"
    ),
    "given.estimator": (
        "s : {spread:choose|std=écart-type, n − 1|range=étendue des mesures} ; limites à ±"
        " {coverage} s ; sans lissage"
    ),
    "given.expansion": (
        "appliquée par compwright : mesures ramenées à 20 °C,"
        " {what:choose|scale=règle|workpiece=pièce} {alpha_m} µm/(m K) à {T_m} °C, instrument"
        " {alpha_d} µm/(m K) à {T_d} °C, point fixe {x_fix} mm"
    ),
    "given.list": "{others:if|{others} et |}{last:if|{last}|aucun}",
    "given.listed": "{items}",
    "given.of_tests": "{names} : {statement}",
    "given.programmed_feed": "mm/min programmés",
    "given.radius": "rayon {radius} mm",
    "given.samples": "{counts} points de mesure",
    "given.sense": (
        "{sense:choose|ccw=sens inverse des aiguilles d'une montre|cw=sens des aiguilles d'une"
        " montre}"
    ),
    "given.sentences": "{sentences:join| }",
    "given.smoothing": "compwright ne lisse pas : chaque point compte",
    "given.statements": "{statements:join| ; }",
    "given.targets": "{count} de {first} à {last} {unit} ; liste en annexe A",
    "given.travel": "{low:g} à {high:g} {unit}",
    "limits.all": "toutes ensemble",
    "limits.cause": (
        "{cause:choose|noise=dispersion des mesures : la même position ne revient pas à"
        " l'identique (répétabilité)|single outliers=valeurs aberrantes isolées|shifts between"
        " traverses=parcours entiers décalés|drift=dérive : l'axe change pendant la"
        " mesure|temperature within its uncertainty=température : une pente dans les limites de"
        " ce que le dossier de travail déclare incertain|error that the test leaves open=erreur"
        " que l'essai n'a pas montrée : entre les points visés et cachée dans la"
        " dispersion|periods that the test leaves open=erreur périodique que ces points visés ne"
        " peuvent pas montrer : ce qu'elle ajouterait|steps that the control never applies=sauts"
        " de la correction (inversion) que la commande n'applique jamais, à cause de son"
        " accélération et de sa période d'asservissement|no table is written=erreur mesurée"
        " qu'aucune table n'enlève|spacing too wide for the period=erreur périodique : les points"
        " sont trop espacés pour elle|spacing of the points=courbure entre les points de la"
        " table|number of points=courbure entre les points : la commande en a trop peu|one table"
        " for both directions=réversibilité qui varie le long de la course : une table et une"
        " valeur ne peuvent la contenir|no backlash value=réversibilité : la commande n'a pas de"
        " valeur pour elle|quantum=résolution des valeurs de la table|value range=plus grande"
        " valeur que la commande accepte|backlash range=plus grande valeur de jeu que la commande"
        " accepte|largest increment=plus grand pas d'un point à l'autre que la commande accepte|a"
        " straight line instead of a table=courbure : la commande a une droite, pas de"
        " table|={cause}}"
    ),
    "limits.left": "Reste dû à la commande",
    "limits.name": (
        "{cause:choose|noise=dispersion des mesures|single outliers=valeurs aberrantes"
        " isolées|shifts between traverses=décalages entre parcours|drift=dérive|temperature within"
        " its uncertainty=incertitude de la température|error that the test leaves open=erreur que"
        " l'essai n'a pas montrée (entre les points visés ou dans la dispersion)|periods that the"
        " test leaves open=erreur périodique que ces points visés ne peuvent pas montrer|steps that"
        " the control never applies=sauts que la commande n'applique jamais|no table is"
        " written=erreur qu'aucune table ne corrige|spacing too wide for the period=points trop"
        " espacés pour la période|spacing of the points=pas des points de la table|number of"
        " points=trop peu de points de table|one table for both directions=réversibilité qui varie"
        " le long de la course|no backlash value=réversibilité que la commande ne peut pas"
        " corriger|quantum=résolution des valeurs de la table|value range=plus grande valeur de"
        " table de la commande|backlash range=plus grande valeur de jeu de la commande|largest"
        " increment=plus grand pas entre points de table|a straight line instead of a table=la"
        " commande a une droite, pas de table|what no table of this control takes away=ce qu'aucune"
        " table de cette commande n'enlève|={cause}}"
    ),
    "limits.note": (
        "Chaque barre montre de combien {parameter} serait plus petit sans cette seule cause,"
        " calculé sur les mêmes essais simulés. Les barres ne s'additionnent pas, car {parameter}"
        " est une étendue, la plus grande valeur moins la plus petite : seules comptent les causes"
        " à ces deux endroits."
    ),
    "limits.part": "Part de {parameter}",
    "limits.summary": (
        "{parameter} à de nouveaux points visés : {then} {unit} attendus, {before} {unit}"
        " avec le contenu actuel de la commande. La dispersion seule, sans aucune erreur de"
        " l'axe, donnerait {least} {unit} : aucune table ne descend plus bas."
    ),
    "period.alike": "Ces points visés ne distinguent pas : {periods} {unit}.",
    "period.caption": (
        "Pour chaque période : combien de fois les mesures sont plus vraisemblables avec une erreur"
        " de cette période que sans elle. La fréquence d'une telle période sur les machines n'est"
        " pas encore comprise. Tirets : périodes utilisées dans l'estimation.{gaps:if| Dans les"
        " lacunes, une erreur de cette période ressemble à l'erreur lisse à ces points visés : la"
        " recherche ne peut pas la trouver.}"
    ),
    "period.described": "Rapport de vraisemblance de chaque période",
    "period.least": "Plus petite amplitude que cet essai montre, en {unit}",
    "period.least_caption": (
        "Pour chaque période : la plus petite amplitude ({unit}) d'une onde que cet essai montre."
        " Cela veut dire : dans 95 % de tels essais, l'amplitude estimée dépasse trois erreurs"
        " types. Dans les lacunes, l'essai ne montre aucune onde de moins de 10 {unit}. Si le"
        " dossier de travail ne donne pas la période, une onde est le plus souvent trouvée à partir"
        " d'environ 1,5 fois cette amplitude{gaps:if|, mais pas dans les lacunes de la figure"
        " ci-dessus}. Plus de points visés, à décalages aléatoires, montrent des ondes plus"
        " petites."
    ),
    "period.none": "Aucune période n'est connue, et aucune n'a été trouvée.",
    "period.over": "Période en {unit}",
    "period.source": (
        "{source:choose|job=donnée par le dossier de travail|found=trouvée dans les"
        " mesures|files=donnée par les fichiers de la commande|={source}}"
    ),
    "report.accreditation": (
        "Ceci est un rapport d'essai et non un certificat d'étalonnage d'un laboratoire accrédité."
        " La traçabilité des valeurs repose sur les certificats d'étalonnage des instruments de"
        " mesure cités."
    ),
    "report.acknowledged": "Doutes pris en compte",
    "report.annex_a": "Annexe A : points visés et mesures brutes",
    "report.annex_b": "Annexe B : origine des données",
    "report.axis": "Axe {axis:if|{axis}|non nommé}{name:if|, {name}}",
    "report.both": "les deux",
    "report.circle": "Cercle {plane}{name:if|, {name}}",
    "report.compensation": "Compensation de {axes:if|{axes}|{count} axes}",
    "report.conditions": "Conditions d'essai, {standard}",
    "report.conform": "La machine respecte toutes les limites du tableau ci-dessus.",
    "report.conformity_open": (
        "La conformité n'est pas déclarée : {undecided:if|au moins une limite est non décidée|il"
        " n'est pas prouvé que les tables soient actives comme prévu}, ou un constat dont une"
        " décision dépend n'est pas encore vérifié."
    ),
    "report.customer": "Client",
    "report.date": "Date de l'essai",
    "report.extreme": (
        "moyenne{what:choose|R=|A= {end:choose|highest=max.|lowest=min.}"
        "|E= {end:choose|highest=max.|lowest=min.}"
        "|M= {end:choose|highest=max.|lowest=min.} ±}"
        "{what:choose|E=|M=|A= {end:choose|highest=+|lowest=−} {coverage} s"
        "|R= {end:choose|highest=+|lowest=−} {coverage} s}"
    ),
    "report.extremes": "Extremums qui donnent A, E, M et R : cercles sur la figure",
    "report.findings": "Constats",
    "report.footer": "Rapport {number}",
    "report.in_english": (
        "Les noms et textes du dossier de travail et des fichiers sont tels qu'ils ont été donnés."
        " La traduction n'a pas encore été relue par une personne de langue française ; le rapport"
        " en anglais fait foi."
    ),
    "report.in_file": "Dans le fichier : {name}",
    "report.logo": "Logo",
    "report.machine": (
        "{circles}, évalués ensemble comme cercles d'une seule machine{name:if| : {name}|}"
    ),
    "report.no_limits": (
        "Aucune limite n'est indiquée. Ce rapport donne des valeurs ; il ne déclare pas la"
        " conformité."
    ),
    "report.no_number": "Rapport sans numéro",
    "report.not_conform": "La machine ne respecte pas toutes les limites du tableau ci-dessus.",
    "report.number": "Numéro du rapport",
    "report.open_sections": "Les parties dépliées sont imprimées.",
    "report.operator": "Opérateur",
    "report.other_findings": "Autres constats",
    "report.page": "Page",
    "report.page_of": "sur",
    "report.parameters": "Paramètres",
    "report.place": "Lieu",
    "report.provenance": (
        "Évalué par compwright {version}.{command:if| Cette commande refait le rapport :}"
    ),
    "report.readings": "Mesures",
    "report.readings_air": "Mesures sans l'effet de l'air sur la longueur d'onde du laser",
    "report.readings_measured": "Mesures non corrigées",
    "report.readings_reduced": "Mesures ramenées à 20 °C",
    "report.results": "Résultats",
    "report.see_tests": "voir les pages des essais",
    "report.sign_checked": "Vérifié par",
    "report.sign_measured": "Mesuré par",
    "report.sign_place": "Lieu, date",
    "report.signs": (
        "Écart : position mesurée moins point visé. Approche + : dans le sens positif de la"
        " machine. Erreur de réversibilité à un point visé : moyenne à + moins moyenne à − ; B en"
        " est la plus grande valeur absolue."
    ),
    "report.signs_circle": (
        "Cercle : l'écart est le rayon mesuré moins le rayon nominal. Jeu positif : après une"
        " inversion, l'axe est en retard sur la consigne. Perpendicularité positive : l'angle entre"
        " les axes positifs dépasse 90°."
    ),
    "report.statistics": (
        "Moyennes, écarts-types et répétabilité en {count} {count:plural|point visé|points visés}"
    ),
    "report.test": "Essai {name}",
    "report.title": "Rapport d'essai{tests:plural|| de {tests} essais}",
    "report.unnamed_machine": (
        "Les fichiers de ces cercles n'indiquent ni machine ni numéro de série. Ils comptent pour"
        " une seule machine. Évaluer un à un les cercles de machines différentes, ou ajouter `#"
        " machine:` aux fichiers."
    ),
    "report.unread": "Fichiers non évalués",
    "report.verification": "Vérification de {axes}",
    "run.annex_c": "Annexe C : compensation",
    "run.assumed": "Faits supposés",
    "run.assumed_note": (
        "Ces faits ne sont dans aucun des fichiers fournis ; les résultats ne valent que s'ils sont"
        " vrais."
    ),
    "run.axis_table": "Axe {axis} : table",
    "run.bends": "{input} corrige {output}",
    "run.bidirectional": "Une courbe par sens d'approche",
    "run.card": "Fiche de mise en service",
    "run.certificate": "Preuve de l'ajustement",
    "run.changes": "Ancien et nouveau",
    "run.check_first": "Non décidé : vérifier d'abord les constats cités ci-dessus",
    "run.circle_worse": (
        "Les limites d'un cercle sont indécises : la prévision est qu'il se dégrade. Avant de"
        " charger, chercher pourquoi (CW-P131)"
    ),
    "run.comparison": "Avant et prévu",
    "run.comparison_note": (
        "Les écarts avant et, à la même échelle, les écarts qu'un essai aux mêmes points visés"
        " devrait montrer."
    ),
    "run.compensation": "Compensation",
    "run.correction": "Correction : ce que la commande ajoute à la consigne.",
    "run.cross": "Tables entre axes",
    "run.done": (
        "{tests:plural|1 essai|{tests} essais} {count:plural|de l'axe|des axes} {axes}"
        " {tests:plural|a été évalué|ont été évalués} {standards:if|selon {standards:and}|sans"
        " norme}. L'erreur a été estimée sur la course{tables:if|. La meilleure table que"
        " {control:if|{control}|la commande} peut contenir a été calculée et écrite dans la forme"
        " de la commande. L'essai suivant a été prévu à partir de ces fichiers. Rien n'est encore"
        " chargé : charger la table pas à pas selon la fiche de mise en service du dossier de"
        " résultats, mesurer de nouveau et lancer compwright verify.|. Aucune table n'a été écrite"
        " : la prévision vaut donc pour un essai sans table.}"
    ),
    "run.estimate": "Axe {axis} : erreur estimée",
    "run.estimate_note": (
        "L'erreur que la table doit enlever : l'écart sur la course dans l'état où il a été"
        " mesuré, avec son incertitude."
    ),
    "run.files": "Fichiers",
    "run.files_written": "Fichiers écrits",
    "run.in_english": (
        "Les textes du dossier de travail, des fichiers et de la définition de la commande sont"
        " tels qu'ils ont été donnés. Les raisons du refus d'un fichier de la commande sont en"
        " anglais. La traduction n'a pas encore été relue par une personne de langue française."
    ),
    "run.legend": (
        "Gris : avant. Bleu : 5 à 95 % de nouveaux essais aux mêmes points visés, trait vertical"
        " : médiane. Tirets : limite."
    ),
    "run.limit_missed": "D'après la prévision, au moins une limite ne sera pas respectée",
    "run.limit_open": "Pour au moins une limite, il est incertain qu'elle soit respectée",
    "run.limits": "Axe {axis} : ce qui limite sa précision",
    "run.limits_met": "D'après la prévision, toutes les limites seront respectées",
    "run.limits_met_if": (
        "D'après la prévision, toutes les limites seront respectées, si les constats cités"
        " ci-dessus s'avèrent sans conséquence"
    ),
    "run.no_axis_table": "Pas de table pour cet axe{reason:if| : {reason}}.",
    "run.no_limits": "Résultat prévu ; aucune limite n'est indiquée pour décider",
    "run.no_statement": (
        "Déclaration de conformité : aucune. Les décisions portent sur l'essai suivant tel qu'il"
        " est prévu ; le rapport de compwright verify décide de la machine."
    ),
    "run.no_table": "Aucune table n'a été écrite",
    "run.no_table_for": "Aucune table n'a été écrite pour l'axe {axes}",
    "run.periods": "Axe {axis} : périodes de l'erreur",
    "run.points": "Table en chiffres : {count:plural|{count} point|{count} points}",
    "run.provenance": "Origine des données",
    "run.raw_readings": "Mesures brutes",
    "run.refusal": "Axe {axis} : {reason}.",
    "run.single": "Une courbe et une valeur de réversibilité",
    "run.state": "Axe {axis} : état de la commande pris en compte",
    "run.state_files": (
        "Comme dans {files} ; la table est la somme de ce qui y était et de ce qui s'ajoute."
    ),
    "run.state_none": "Aucun : rien n'était actif dans la commande quand l'axe a été mesuré.",
    "run.state_not_given": (
        "Non indiqué. Si le contenu de la commande est inconnu, aucune table n'est écrite, car la"
        " nouvelle table doit contenir ce qui est déjà actif."
    ),
    "run.table": (
        "{count} points de table, tels que relus dans les fichiers.{wanted:if| Trait large : la"
        " correction voulue avant arrondi et limites.}"
    ),
    "run.worth": "Axe {axis} : utilité des points de la table",
    "verify.comparison": "Avant, prévu et après",
    "verify.comparison_note": (
        "Toutes les courbes à la même échelle. Prévu : moyennes attendues aux points visés du"
        " premier essai."
    ),
    "verify.equivalent": "impossible à distinguer de",
    "verify.factor": "facteur",
    "verify.further_table": "table pour le prochain tour de correction",
    "verify.in_english": (
        "Les textes du dossier de travail, des fichiers et de la définition de la commande sont"
        " tels qu'ils ont été donnés. Les raisons du refus d'un fichier de la commande sont en"
        " anglais. La traduction n'a pas encore été relue par une personne de langue française."
    ),
    "verify.legend": (
        "Gris : avant. Bleu : prévision de 5 à 95 %, trait vertical : mesuré après chargement."
        " Tirets : limite."
    ),
    "verify.look_at": "À vérifier :",
    "verify.next_round": "{written:if|Tour suivant|Pas de tour suivant}",
    "verify.no_further_table": "pas de nouvelle table pour le prochain tour de correction",
    "verify.outside": "hors",
    "verify.shift": "décalage en points",
    "verify.table_of": "table de l'axe",
    "verify.within": "dans",
    "worth.caption": (
        "{symbol} prévu à de nouveaux points visés pour chaque nombre de points de table :"
        " médiane et 5 à 95 %. Le point plein est la table écrite{grid:if| ;"
        " {grid:choose|ring=l'anneau est la table existante de la commande|on_it=elle garde les"
        " points de la table existante}|}."
    ),
    "worth.described": "{quantity} selon le nombre de points",
    "worth.over": "points de la table",
    "worth.points": (
        "{points} points, tous les {spacing} {place} : {symbol} {median} {unit} ({p05} à {p95})"
    ),
    "worth.quantity": "{symbol} en {unit}",
}
