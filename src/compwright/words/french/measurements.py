"""What is noticed while measurement files are read."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-R001": "Non indiqué dans le fichier, supposé : {assumed:join|; }.",
    "CW-R002": "Le fichier ne nomme pas son axe (ligne de commentaire '# axis: X').",
    "CW-R003": "Les valeurs mesurées ont été converties en écarts, mesuré moins visé.",
    "CW-R004": "L'instrument a déjà compensé : {compensated}.",
    "CW-R005": "Colonnes omises : {columns}.",
    "CW-R006.place": "{target} au parcours {run}",
    "CW-R006.readings": "{missing} des {readings} mesures manquent : {places}.",
    "CW-R006.rows": (
        "Les lignes sans mesure sont omises : point visé {targets}{more:if| et {more} autres}"
        " {unit}. Les résultats n'en parlent pas."
    ),
    "CW-R007": (
        "Il y a {positive} parcours dans le sens + et {negative} dans le sens − : un n'a pas été"
        " fait, ou le fichier a été coupé."
    ),
    "CW-R008": (
        "{count} des {of} écarts dépassent 1 {unit}, le plus grand {largest} {unit} au point visé"
        " {target} {unit} : l'unité est-elle juste{turn:if|, ou les mesures comptent-elles modulo"
        " 360°} ?"
    ),
    "CW-R009": (
        "Tous les écarts sont inférieurs à 0,000001 {unit} : l'unité est-elle juste, et a-t-on"
        " mesuré ?"
    ),
    "CW-R010": (
        "Chaque écart du parcours {runs} est exactement nul alors que d'autres ne le sont pas :"
        " certains programmes remplissent de zéros les parcours non faits. Dans ce cas, les"
        " enlever. Le résultat les contient ; là où les autres se dispersent, table et prévision"
        " sont faites sans eux."
    ),
    "CW-R011": (
        "Les écarts croissent d'environ 1 {unit} par {unit} de point visé, comme des positions"
        " mesurées : si ce sont des positions mesurées, nommer la colonne measured_{unit}."
    ),
    "CW-R012": (
        "Points visés presque identiques dont aucun parcours n'a les deux, peut-être un seul point"
        " visé : {targets}."
    ),
    "CW-R012.pair": "{low:.10g} et {high}",
    "CW-R013": (
        "La clé 'deviation: {deviation}' n'a pas d'effet : le fichier donne des valeurs mesurées,"
        " pas des écarts."
    ),
    "CW-R014.forward": (
        "Les positions ne sont pas en ordre croissant : vérifier à la machine quel sens est"
        " l'avant."
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
        "{number} a été lu avec un point décimal, mais des nombres entiers sont dans la même"
        " colonne et aucun nombre ne prouve le point : s'il sépare les milliers, l'enlever."
    ),
    "CW-R030": (
        "Les mesures contiennent déjà l'étalonnage de l'instrument et sa correction de température"
        " (dilatation {expansion} µm/(m K), {temperatures} °C) : rien n'a été appliqué de nouveau."
    ),
    "CW-R031": (
        "L'avance réelle, d'après la fréquence et le nombre des points de mesure, est {feed:.4g}"
        " mm/min et non l'avance programmée de {programmed:.4g} mm/min : correction d'avance, ou un"
        " axe qui n'a pas suivi. L'avance réelle est utilisée."
    ),
    "CW-R032": (
        "Le parcours {direction} {run} a {number} mesures de {more:if|plus|moins} après l'arc"
        " mesuré qu'avant : une mesure est peut-être doublée ou perdue."
    ),
    "CW-R033": "L'essai demande un parcours {sense}, mais le fichier n'en contient aucun.",
    "CW-R034": (
        "Des points de mesure manquent dans {run} à partir de {angle:.6g}°, sur {width:.4g}° (les"
        " points sont espacés de {step:.3g}°)."
    ),
    "CW-R035": (
        "Le plus grand écart au rayon nominal est {largest:.4g} mm : unité, rayon nominal et"
        " montage sont-ils justes ?"
    ),
    "CW-R036": (
        "Chaque écart du parcours {runs} est nul (inférieur à 0,001 µm) : a-t-il été mesuré ?"
    ),
    "CW-R037": (
        "L'instrument n'était pas étalonné pour {files} : les rayons de tout l'essai ne comptent"
        " pas."
    ),
    "CW-R038": "{files:and} ont été pris comme les deux sens d'un essai.",
    "CW-R039": (
        "L'autre sens est peut-être dans {files}, mais aucune paire n'est certaine : non réunis."
        " Évaluer une paire à la fois, ou donner aux fichiers des noms qui ne diffèrent que par ccw"
        " et cw."
    ),
    "CW-R050": (
        "Omis, car un essai dans deux sens ne les a approchés que dans un : point visé {targets}."
    ),
    "CW-R051": (
        "Le fichier finit sans fin de ligne après {number} (ligne {line}) : s'il a été coupé"
        " pendant la copie, des chiffres y manquent, ou des mesures après."
    ),
    "CW-R052": "Ignorés dans le dossier, pas des mesures d'après leur extension : {files}.",
    "CW-R053.environment": (
        "Le fichier n'a pas de section ENVIRONMENT:: après ses moyennes : il a peut-être été coupé."
    ),
    "CW-R053.header": (
        "Le fichier dit avoir {promised} {what:choose|targets=points visés|runs=parcours} (clé"
        " {key}) et en contient {found} : il a peut-être été coupé."
    ),
    "CW-R053.last_run": (
        "Les dernières lignes sont du parcours {run}, auquel manquent {lacking} des {readings}"
        " mesures alors que les autres les ont toutes : le fichier a peut-être été coupé."
    ),
    "CW-R053.last_target": (
        "Les dernières lignes sont du point visé {target}, auquel manquent {lacking} des {readings}"
        " mesures alors que les autres les ont toutes : le fichier a peut-être été coupé."
    ),
    "CW-R053.no_end": (
        "Le fichier finit sans EOF::, sa dernière ligne est {text} (ligne {line}) : il a peut-être"
        " été coupé, des chiffres ou des mesures peuvent manquer. Comparer avec l'instrument."
    ),
    "CW-R053.one_direction": (
        "Seul le sens {direction} est là. Dans cette forme, un sens vient tout entier avant"
        " l'autre, donc un fichier coupé entre les deux se lit comme un essai dans un sens :"
        " comparer avec l'instrument."
    ),
    "CW-R053.run_count": (
        "Le fichier promet {promised} parcours (Run-count) et en contient {found} : il a peut-être"
        " été coupé, ou l'essai arrêté."
    ),
    "CW-R053.share": (
        "{share:.0%} des mesures manquent : le fichier a peut-être été coupé, ou des lignes"
        " perdues."
    ),
    "CW-R054": (
        "Parcours omis : {runs}{more:if|, ..}. Ils sont exactement nuls partout, comme certains"
        " programmes remplissent le retour d'un essai dans un sens."
    ),
    "CW-R055": (
        "Les parcours pairs ont été pris comme le retour (sens {back}) d'après leur seul numéro :"
        " les lignes du parcours {run} sont dans le même ordre que celles du parcours 1. Si l'essai"
        " n'allait que dans un sens, il ne contient ni réversibilité ni jeu."
    ),
    "CW-R056": (
        "Le fichier n'indique pas l'unité de ses écarts ; le microradian a été pris : le plus"
        " grand, {largest}, est alors {arcsec}″. Le comparer avec l'instrument."
    ),
    "CW-R057": (
        "Le fichier contient des moyennes de plusieurs parcours, pas des mesures : il est lu comme"
        " un parcours par sens, et la répétabilité est inconnue.{way_back:if| Les moyennes du"
        " retour n'y sont pas : elles sont le double de celles des deux sens moins celles de"
        " l'aller.}"
    ),
    "CW-R058": (
        "Le fichier est une table de compensation du logiciel du laser ({sign}), pas un essai : il"
        " est lu comme un parcours par sens de ses erreurs. Pour faire une table, utiliser l'essai"
        " lui-même."
    ),
    "CW-R059": (
        "Les lignes sans nombre dans la colonne {column} sont omises : ligne {lines}{more:if| et"
        " {more} autres}."
    ),
    "CW-R060": "Lu{by:if| par {by}} : {readings:join|; }.",
    "CW-R061.sheets": "Feuilles omises : {sheets}{more:if|, ..}.",
    "CW-R061.tests": (
        "Les essais du même fichier sans axe sont omis : {tests}. Seul {used} est utilisé."
    ),
    "CW-R062": (
        "Le fichier n'est pas en UTF-8 et a été lu en {code_page} ; seuls les commentaires et les"
        " noms de colonnes en dépendent, aucun nombre. La ligne {line} dit {text}."
    ),
    "CW-R063": (
        "Des lignes qui ressemblent à des mesures sont hors des mesures et n'ont pas été lues :"
        " ligne {lines}{more:if| et {more} autres}. Comparer avec l'instrument."
    ),
    "CW-R064": (
        "Caché dans le classeur, et lu comme le reste : {hidden:join|; }. Comparer le nombre de"
        " mesures avec l'instrument, et enlever ce qui n'est pas de l'essai."
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
