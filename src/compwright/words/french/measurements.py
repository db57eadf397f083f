"""Sentences about the reading of measurement files."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-R001": "Le fichier n'indique pas ce qui suit, qui a été supposé : {assumed:join|; }.",
    "CW-R002": "Le fichier ne nomme pas son axe. Ajouter une ligne de commentaire '# axis: X'.",
    "CW-R003": (
        "Le fichier contient des positions mesurées. Elles ont été converties en écarts (mesuré"
        " moins visé)."
    ),
    "CW-R004": "L'instrument a déjà compensé : {compensated}.",
    "CW-R005": (
        "Ces colonnes ont été omises : {columns}."
        "{near:if| Si {near} est la colonne {name}, renommez-la.}"
    ),
    "CW-R006.place": "{target} au parcours {run}",
    "CW-R006.readings": "{missing} des {readings} mesures manquent : {places}.",
    "CW-R006.rows": (
        "Les lignes sans mesure sont omises : point visé {targets}{more:if| et {more} autres}"
        " {unit}. Les résultats ne couvrent pas ces points visés."
    ),
    "CW-R007": (
        "Il y a {positive} parcours dans le sens + mais {negative} dans le sens −. Soit un parcours"
        " n'a pas été fait, soit le fichier a été coupé : comparer le fichier avec l'instrument."
    ),
    "CW-R008": (
        "{count} des {of} écarts dépassent 1 {unit}. Le plus grand est de {largest} {unit}, au"
        " point visé {target} {unit}. Vérifier l'unité{turn:if|, et si les mesures recommencent à"
        " 0 après 360°}."
    ),
    "CW-R009": (
        "Tous les écarts sont inférieurs à 0,000001 {unit}. Vérifier l'unité, et si l'axe a"
        " vraiment été mesuré."
    ),
    "CW-R010": (
        "Chaque écart du parcours {runs} est exactement nul, alors que d'autres ne le sont pas."
        " Certains programmes remplissent de zéros un parcours non fait : dans ce cas, ôter le"
        " parcours du fichier. Le résultat le contient. Si les autres parcours se dispersent,"
        " table et prévision sont faites sans lui."
    ),
    "CW-R011": (
        "Les écarts croissent d'environ 1 {unit} par {unit} de point visé, comme des positions"
        " mesurées. Si ce sont des positions mesurées, nommer leur colonne measured_{unit}."
    ),
    "CW-R012": (
        "Ces points visés sont presque les mêmes, et aucun parcours n'a de mesures aux deux :"
        " {targets}. S'il s'agit d'un seul point visé, lui donner le même nombre dans toutes les"
        " lignes."
    ),
    "CW-R012.pair": "{low:.10g} et {high}",
    "CW-R013": (
        "La clé 'deviation: {deviation}' n'a pas d'effet : le fichier donne des valeurs mesurées,"
        " pas des écarts."
    ),
    "CW-R014.forward": (
        "Les positions ne sont pas en ordre croissant : vérifier à la machine dans quel sens"
        " allaient les parcours avant."
    ),
    "CW-R014.labels": (
        "Les points visés sont en ordre décroissant, et FWD a été pris comme approche dans le sens"
        " + : vérifier les désignations."
    ),
    "CW-R014.odd_runs": (
        "Les points visés sont en ordre décroissant, donc les parcours impairs ont été pris comme"
        " approches dans le sens {direction} : le vérifier à la machine."
    ),
    "CW-R015": (
        "{number} a été lu avec un point décimal. Mais la même colonne contient des nombres"
        " entiers, donc le point peut séparer les milliers. Si c'est le cas, l'ôter."
    ),
    "CW-R030": (
        "Les mesures contiennent déjà l'étalonnage et la correction de température de"
        " l'instrument (dilatation {expansion} µm/(m K), {temperatures} °C). Rien n'a été"
        " appliqué de nouveau."
    ),
    "CW-R031": (
        "L'avance vraie d'après la fréquence et le nombre de points est de {feed:.4g} mm/min, pas"
        " de {programmed:.4g} mm/min comme programmé. Soit un override était réglé, soit un axe"
        " n'a pas suivi. L'avance vraie est utilisée."
    ),
    "CW-R032": (
        "Le parcours {direction} {run} a {number} mesures de {more:if|plus|moins} après l'arc"
        " mesuré qu'avant. Une mesure peut être doublée ou perdue."
    ),
    "CW-R033": (
        "Le fichier annonce un parcours {sense} (RUN_SPEC), mais ne contient aucune mesure d'un tel"
        " parcours."
    ),
    "CW-R034": (
        "Des points de mesure manquent dans {run} à partir de {angle:.6g}°, sur {width:.4g}° (les"
        " points sont espacés de {step:.3g}°)."
    ),
    "CW-R034.open": (
        "{run} n'a pas de point de mesure de {begin:.5g}° à {end:.5g}°. Il est évalué comme un arc"
        " de {arc:.5g}°, non comme un cercle complet. Soit des points manquent : les exporter tous,"
        " ou mesurer de nouveau. Soit seul cet arc a été parcouru : acquitter CW-R034 dans le"
        " dossier de travail."
    ),
    "CW-R035": (
        "Le plus grand écart au rayon nominal est de {largest:.4g} mm. Vérifier unité, rayon"
        " nominal et montage."
    ),
    "CW-R036": (
        "Les écarts de {runs} par rapport à un cercle sont inférieurs à 0,1 µm, la résolution d'un"
        " ballbar."
        " Vérifier l'unité des écarts, et si le parcours a été mesuré."
    ),
    "CW-R037": (
        "L'instrument n'était pas étalonné pour {files}. Le rayon absolu n'est donc utilisé pour"
        " aucun parcours de cet essai."
    ),
    "CW-R038": "{files:and} ont été pris comme les deux sens d'un essai.",
    "CW-R039": (
        "L'autre sens est peut-être dans {files}, mais on ne sait pas quels fichiers vont"
        " ensemble, donc aucun n'a été joint. Évaluer une paire à la fois, ou donner aux fichiers"
        " d'une paire des noms qui ne diffèrent que par ccw et cw."
    ),
    "CW-R050": (
        "Dans cet essai dans les deux sens, ces points visés n'ont été approchés que dans un sens"
        " et ont été omis : {targets}."
    ),
    "CW-R051": (
        "La dernière ligne se termine après {number} sans saut de ligne (ligne {line}). Le"
        " fichier a peut-être été coupé pendant la copie : des chiffres ou des mesures suivantes"
        " peuvent manquer. Comparer avec l'instrument."
    ),
    "CW-R052": (
        "Ces fichiers du dossier ont été ignorés, car leurs extensions ne sont pas celles de"
        " fichiers de mesure : {files}."
    ),
    "CW-R053.environment": (
        "La section ENVIRONMENT:: manque après les moyennes. Le fichier a peut-être été coupé :"
        " comparer avec l'instrument."
    ),
    "CW-R053.header": (
        "D'après sa clé {key}, le fichier a {promised} {what:choose|targets=points"
        " visés|runs=parcours}, mais il en contient {found}. Il a peut-être été coupé : comparer"
        " avec l'instrument."
    ),
    "CW-R053.last_run": (
        "Les dernières lignes appartiennent au parcours {run}, auquel manquent {lacking} des"
        " {readings} mesures, alors que les autres les ont toutes. Le fichier a peut-être été"
        " coupé : comparer avec l'instrument."
    ),
    "CW-R053.last_target": (
        "Les dernières lignes appartiennent au point visé {target}, auquel manquent {lacking} des"
        " {readings} mesures, alors que les autres les ont toutes. Le fichier a peut-être été"
        " coupé : comparer avec l'instrument."
    ),
    "CW-R053.no_end": (
        "La marque de fin EOF:: manque ; la dernière ligne est {text} (ligne {line}). Le fichier"
        " a peut-être été coupé, des chiffres ou des mesures peuvent manquer. Comparer avec"
        " l'instrument."
    ),
    "CW-R053.one_direction": (
        "Le fichier ne contient que le sens {direction}. Dans ce format de fichier, toutes les"
        " mesures d'un sens précèdent celles de l'autre. Le second sens a donc peut-être été coupé"
        " : comparer le fichier avec l'instrument."
    ),
    "CW-R053.run_count": (
        "D'après sa clé Run-count, le fichier a {promised} parcours, mais il en contient {found}."
        " Soit le fichier a été coupé, soit l'essai a été arrêté. Comparer avec l'instrument."
    ),
    "CW-R053.share": (
        "{share:.0%} des mesures manquent. Soit le fichier a été coupé, soit des lignes ont été"
        " perdues. Comparer avec l'instrument."
    ),
    "CW-R054": (
        "Ces parcours ont été omis, car toutes leurs valeurs sont exactement nulles :"
        " {runs}{more:if|, ..}. Certains programmes remplissent de zéros le retour d'un essai"
        " dans un seul sens."
    ),
    "CW-R055": (
        "Les parcours pairs ont été pris comme retours (sens {back}) seulement parce que leur"
        " numéro est pair : les lignes du parcours {run} sont dans le même ordre que celles du"
        " parcours 1. Si tous les parcours de l'essai allaient dans le même sens, ses valeurs de"
        " réversibilité et de jeu ne veulent rien dire."
    ),
    "CW-R056": (
        "Le fichier n'indique pas l'unité de ses écarts, donc le microradian a été supposé. Le"
        " plus grand écart, {largest}, vaut alors {arcsec}″. Le comparer avec l'instrument."
    ),
    "CW-R057": (
        "Le fichier contient des moyennes de plusieurs parcours, pas des mesures isolées. Il est lu"
        " comme un parcours par sens, et la répétabilité est inconnue.{way_back:if| Les moyennes du"
        " retour ne sont pas dans le fichier : elles ont été calculées à partir des moyennes des"
        " deux sens (2 × moyenne des deux sens − moyenne de l'aller).}"
    ),
    "CW-R058": (
        "Le fichier est une table de compensation faite par le logiciel du laser"
        " ({sign:if|{sign}|signe selon le profil}), pas un essai. Il est lu comme un parcours par"
        " sens avec les erreurs de cette table. Pour faire une table, donner le fichier de mesure"
        " de l'essai."
    ),
    "CW-R059": (
        "Les lignes sans nombre dans la colonne {column} sont omises : ligne {lines}{more:if| et"
        " {more} autres}."
    ),
    "CW-R060": "Lu{by:if| par {by}} : {readings:join|; }.",
    "CW-R061.sheets": "Feuilles omises : {sheets}{more:if|, ..}.",
    "CW-R061.tests": (
        "Les essais du même fichier qui n'indiquent pas leur axe sont omis : {tests}. Seul {used}"
        " est utilisé."
    ),
    "CW-R062": (
        "Le fichier n'est pas en UTF-8 et a été lu comme {code_page}. La ligne {line} se lit"
        " alors {text}. Seuls les commentaires et les noms de colonnes en dépendent, aucun"
        " nombre."
    ),
    "CW-R063": (
        "Certaines lignes ressemblent à des mesures mais sont hors de la section des mesures,"
        " donc elles n'ont pas été lues : ligne {lines}{more:if| et {more} autres}. Comparer avec"
        " l'instrument."
    ),
    "CW-R064": (
        "Ces parties du classeur sont masquées, mais ont été lues comme le reste : {hidden:join|;"
        " }. Comparer le nombre de mesures avec l'instrument. Ôter ce qui n'appartient pas à"
        " l'essai."
    ),
    "CW-R064.columns": "{number} {number:plural|colonne|colonnes} ({columns})",
    "CW-R064.rows": (
        "{number} {number:plural|ligne|lignes}, cachées ou filtrées (ligne {rows}{more:if| et"
        " {more} autres})"
    ),
    "CW-R064.sheet": "la feuille entière",
    "reading.deviation": "écart : mesuré moins visé",
    "reading.forward": "forward : approche dans le sens {direction}",
    "reading.fwd": "FWD : approche dans le sens +, BWD : dans le sens -",
    "reading.unit_mm": "unité : mm",
}
