"""Sentences about the estimated error of an axis, and about the causes found in circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-D001": (
        "un seul sens a été mesuré. Les causes qui dépendent du sens ne peuvent être séparées"
        " des autres. {causes:if|Des erreurs types croissent, surtout celles de"
        " {causes:join| ; }|Aucune erreur type ne croît beaucoup}"
    ),
    "CW-D001.cause": "{cause} ({factor:.0f} fois, ressemble à {other})",
    "CW-D001.more": "et de {count} {count:plural|autre cause|autres causes}",
    "CW-D002": (
        "un arc de {arc:g}° sépare moins bien les causes qu'un cercle complet."
        " {causes:if|Des erreurs types croissent, surtout celles de {causes:join| ; }|Aucune erreur"
        " type ne croît beaucoup}"
    ),
    "CW-D003": (
        "la longueur de l'instrument n'était pas étalonnée, donc l'échelle des axes seuls n'est"
        " pas donnée. Seule leur différence est donnée"
    ),
    "CW-D004": (
        "à {feed:g} mm/min, une boucle de position souple rend le cercle plus petit de {most:.1f}"
        " µm au plus. D'après ce cercle seul, l'échelle des axes est donc incertaine de"
        " {doubt:.0f} µm/m. L'évaluer avec un cercle à faible avance : les deux montrent l'échelle"
        " (CW-P135)"
    ),
    "CW-D005.none": (
        "l'axe {name} ne s'inverse pas sur cet arc. Son jeu, son jeu latéral et son pic"
        " d'inversion ne sont donc pas déterminés"
    ),
    "CW-D005.one": (
        "l'axe {name} ne s'inverse qu'une fois sur cet arc. Son jeu est celui de l'extrémité"
        " {end:choose|positive=positive|negative=négative}"
    ),
    "CW-D006": "une erreur périodique de {axis} a été trouvée au pas de {pitch:.4g} mm",
    "CW-D007": (
        "aucune erreur périodique de l'axe {name} n'a été trouvée à des pas de {least:2sig} à"
        " {most:g} mm. Une erreur de moins de {hidden:2sig} µm, ou d'un autre pas, peut encore"
        " être cachée"
    ),
    "CW-D008.gradual": (
        "le jeu à l'inversion de l'axe {name} apparaît peu à peu : après une inversion, il manque"
        " jusqu'à {inward:2sig} µm, qui s'éteignent sur environ {travel:2sig} µm de course."
        " Vérifier d'abord la torsion élastique : précharge de l'écrou, palier, accouplement ou"
        " courroie, frottement du guidage. La compensation de jeu agit d'un coup et ne peut le"
        " suivre"
    ),
    "CW-D008.inward": (
        "après les inversions de l'axe {name}, la trajectoire est jusqu'à {inward:2sig} µm à"
        " l'intérieur du cercle. La compensation de frottement de cet axe est peut-être trop forte."
        " Une compensation de jeu fait de même là où le jeu apparaît peu à peu"
    ),
    "CW-D009": (
        "les points de mesure ne montrent que des périodes de {least:3sig} à {most:g} mm, donc"
        " une erreur de période {period:g} mm le long de l'axe {axis} reste invisible"
    ),
    "CW-D010": (
        "une partie de l'écart, {rms:2sig} µm (valeur efficace), a une forme qu'aucune cause"
        " connue n'explique. Les erreurs types en tiennent compte"
    ),
    "CW-D011": (
        "les axes s'inversent {lag:.1f} ± {error:.1f} ms après leurs consignes ; les angles ont été"
        " corrigés de ce retard"
    ),
    "CW-D012": (
        "Dans le fichier, ce qui suit une inversion se trouve avant elle ({odds}). Soit les deux"
        " sens sont échangés, et le jeu et la différence d'asservissement ont le mauvais signe,"
        " soit les angles sont en avance. Vérifier quel parcours était dans le sens horaire et à"
        " quel angle se trouve le premier point. Corriger le fichier, ou acquitter CW-D012 dans le"
        " dossier de travail."
    ),
    "CW-D013": (
        "Le jeu est de {values:and}, mais un cercle avec du jeu le montre au-dessus de zéro. Si"
        " la compensation du jeu n'est pas trop grande, le signe des écarts, le sens des angles ou"
        " les deux sens de parcours sont inversés. Dans les deux premiers cas, la perpendicularité"
        " a aussi le mauvais signe. Vérifier sur la machine : avancer de 10 µm vers l'extérieur,"
        " la mesure doit augmenter. Corriger le fichier ou réduire la compensation, ou acquitter"
        " CW-D013 dans le dossier de travail."
    ),
    "CW-E001": (
        "Un seul sens a été mesuré. La même erreur est supposée dans l'autre sens, et le jeu est"
        " inconnu."
    ),
    "CW-E002": (
        "Il n'y a qu'une approche par point visé et par sens. Le bruit est donc estimé d'après la"
        " dispersion entre points visés voisins."
    ),
    "CW-E003": (
        "L'intervalle des points visés cache une erreur de période {period:g} {unit}, donc cette"
        " période ne fait pas partie de l'estimation. Un essai à d'autres points visés peut"
        " montrer plus d'erreur que prévu ; {better}"
    ),
    "CW-E004": (
        "La course dépasse de {beyond:g} {unit} au plus la zone mesurée (de {first:g} à {last:g}"
        " {unit}). Au-delà de cette zone, l'erreur est extrapolée avec la pente mesurée, et son"
        " incertitude croît"
    ),
    "CW-E010": (
        "Les points visés sont espacés de {interval:.4g} {unit}. À ces points, une erreur de"
        " période {period:g} {unit} ressemble à {wave:if|une onde de {wave:.4g} {unit}|une"
        " constante}, et les deux ne peuvent être séparées. La période ne fait donc pas partie de"
        " l'estimation, et aucune limite ne peut être déclarée respectée ; {better}"
    ),
    "CW-E011": (
        "La table est faite {number:plural|du seul essai {tests}, qui couvre|des essais"
        " {tests:and}, qui couvrent} {low:g} à {high:g} {unit}. L'essai {other} a mesuré"
        " {other_low:g} à {other_high:g} {unit}, mais il n'est pas utilisé : l'état de la commande"
        " dans cet essai n'est pas connu. Au-delà de {low:g} à {high:g} {unit}, l'erreur est"
        " seulement extrapolée et peut être fausse de plus de 100 %. Faire une de ces trois choses"
        " : nommer sous `measured_in` l'entrée de `states` qui était dans la commande pendant"
        " l'essai {other} ; donner l'essai {other} en premier sous `before` ; ou arrêter la table à"
        " la zone mesurée (`start` et `end` de `table`)"
    ),
    "CW-E012.found": (
        "L'erreur se répète tous les {period:.5g} {unit} (probabilité {probability:.0f} %,"
        " {odds}) : {meaning}.{nodes:if| Les points de la table existante sont aussi espacés de"
        " {nodes:.5g} {unit}. Une table qui n'était pas active dans l'essai laisse une telle"
        " erreur : vérifier d'abord qu'elle était active.} Estimation et prévision pondèrent la"
        " période par sa probabilité"
    ),
    "CW-E012.period": "{period:.5g} {unit} ({percent:.0f} %)",
    "CW-E012.possible": (
        "L'erreur peut se répéter tous les {periods:join| ou }, mais ces points visés ne le"
        " montrent pas clairement. Estimation et prévision pondèrent une période possible par sa"
        " probabilité. Pour trancher, mesurer à plus de points visés à décalages aléatoires"
    ),
    "CW-E013": (
        "L'erreur se répète, mais à ces points visés plusieurs périodes ont le même aspect :"
        " {periods:.4g}{more:if| et {more} autres} {unit}. Les mesures ne montrent pas laquelle est"
        " la vraie, donc la table en corrige peut-être une fausse, et un essai à d'autres points"
        " visés peut montrer toute l'erreur périodique ; {better}"
    ),
    "CW-E014.equal_spacing": (
        "Aucune période n'a été trouvée, mais des points visés équidistants ({interval:.4g} {unit})"
        " cachent toute période qui divise l'intervalle. Le message CW-T008 de cet essai propose"
        " des points visés qui montreraient ces périodes"
    ),
    "CW-E014.few_targets": (
        "{targets} points visés sont trop peu pour chercher une erreur périodique. Mesurer à huit"
        " points visés ou plus, à décalages aléatoires"
    ),
    "CW-E014.hidden": (
        "Le dossier de travail ne donne ni pas de vis ni autre période, et aucune n'est certaine :"
        " avec une probabilité de {probability:.0f} %, les mesures contiennent une erreur qui se"
        " répète"
    ),
    "CW-E014.unlikely": (
        "Le dossier de travail ne donne ni pas de vis ni autre période, et les mesures n'en"
        " montrent aucune"
    ),
    "CW-E015": (
        "Les mesures montrent {fitted} des {known} périodes connues : {periods:g} {unit}. Les"
        " autres périodes ne font pas partie de l'estimation"
    ),
    "CW-E016": (
        "Le dossier de travail donne screw_pitch {stated:and} {unit}, mais les mesures ne"
        " montrent pas d'erreur de cette période. Elles en montrent une qui se répète tous les"
        " {found:and} {unit}. Vérifier le pas : les deux périodes restent dans l'estimation, où"
        " une fausse ne nuit pas, mais les points de la table sont choisis pour le pas donné"
    ),
    "CW-E020": (
        "Les mesures dérivent de {drift} du premier au dernier parcours ({odds}){flattens:if|, et"
        " la dérive s'atténue}. {alone:if|La prévision ne connaît que cet essai. Elle suppose qu'un"
        " essai répété de la même façon, à partir d'un axe aussi froid, dérive d'autant (à environ"
        " 10 % près). Si l'essai suivant dérive autrement, ou pas du tout parce que l'axe est"
        " chaud, ses résultats peuvent sortir de la bande prévue. Avec un deuxième essai fait de la"
        " même façon, la bande prévue tient compte de telles différences|La prévision contient ce"
        " qui diffère de la dérive entre les essais}. Pour voir l'axe sans dérive, le mettre en"
        " température et mesurer de nouveau"
    ),
    "CW-E021": (
        "Les mesures dérivent le long de la course comme dans une dilatation thermique : de {lower}"
        " à l'extrémité inférieure et de {upper} à l'extrémité supérieure, du premier au dernier"
        " parcours ({odds}){flattens:if|. La dérive s'atténue}. {alone:if|La prévision vaut pour un"
        " essai répété de la même façon à partir d'un axe aussi froid, et qui dérive d'autant (à"
        " environ 10 % près). Si l'essai suivant dérive autrement, ou pas du tout parce que l'axe"
        " est chaud, ses résultats peuvent sortir de la bande prévue|La prévision contient ce qui"
        " diffère de la dérive entre les essais}. Pour voir l'axe sans dérive, le mettre en"
        " température et mesurer de nouveau"
    ),
    "CW-E022.all": (
        "{pattern:choose|traverses=Les parcours sont décalés les uns par rapport aux"
        " autres|runs=Les allers-retours sont décalés en bloc les uns par rapport aux"
        " autres|walk=Le zéro se promène d'un parcours à l'autre|wave=Les mesures montent et"
        " descendent lentement dans le temps} de {size}{pattern:choose|walk= par parcours|=}"
        " (écart-type ; {odds}){where:if|, {where:and}}. {pattern:choose|wave=Vérifier l'air autour"
        " de la machine : chauffage, refroidissement, courants d'air, soleil|=Vérifier la mise en"
        " température, le bridage, les prises de référence et la fixation de l'instrument entre les"
        " parcours}. La prévision suppose des {pattern:choose|wave=ondes|=décalages} de cette"
        " taille dans le prochain essai"
    ),
    "CW-E022.either": (
        "Les parcours sont décalés les uns par rapport aux autres ({odds}). Ces mesures ne"
        " montrent pas si l'axe dérive ou saute ; la prévision compte avec les deux. Vérifier la"
        " mise en température, le bridage, les prises de référence et la fixation de l'instrument"
        " entre les parcours"
    ),
    "CW-E022.seldom": (
        "{pattern:choose|traverses=Quelques parcours s'écartent des autres|runs=Quelques"
        " allers-retours s'écartent en bloc des autres|walk=Le zéro saute de temps en temps à une"
        " nouvelle place,} de {size} (écart-type ; {odds}){where:if|, {where:and}}. Vérifier la"
        " mise en température, le bridage, les prises de référence et la fixation de l'instrument"
        " entre les parcours. La prévision suppose des décalages de cette taille dans le prochain"
        " essai, aussi rares"
    ),
    "CW-E023": (
        "L'échelle change d'un parcours à l'autre : les écarts aux extrémités de la course se"
        " décalent de {tilt} par rapport à ceux en son milieu (écart-type ; {odds}). Vérifier"
        " comment l'instrument compense l'air et la température, et chercher des courants d'air"
    ),
    "CW-E024": (
        "{outliers} des {readings} {outliers:plural|mesures est aberrante|mesures sont"
        " aberrantes} : {where}{more:if| et {more} autres} ({odds}). Les mesures aberrantes"
        " comptent peu dans l'estimation, et la prévision en attend autant dans un essai répété."
        " Ensuite : {cause}, puis mesurer de nouveau"
    ),
    "CW-E024.reading": "chercher leur cause (faisceau, copeaux, bridage)",
    "CW-E024.traverse": "toutes sont dans {traverse}, chercher ce qui s'est passé dans ce parcours",
    "CW-E025": (
        "Quelques mesures sont plus loin de la moyenne que la dispersion normale ne l'explique"
        " ({odds}). De telles mesures comptent moins dans l'estimation, et la prévision en attend"
        " aussi dans un essai répété"
    ),
    "CW-E026": (
        "Les mesures se dispersent de {positive} en + et de {negative} en − ({odds}) : chercher ce"
        " qui bouge librement dans un seul sens"
    ),
    "CW-E027": (
        "La dispersion des mesures dépend de la position ({odds}). Elle est la plus petite,"
        " {least}, à {least_at} et la plus grande, {most}, à {most_at}. Regarder vis, guidages et"
        " protections là où elle est la plus grande"
    ),
    "CW-E028": (
        "L'essai {test} a une autre pente que l'essai {other} : la différence est de"
        " {difference:+.1f} ± {error:.1f} µm/m. L'acier se dilate d'autant quand il chauffe de"
        " {kelvin:2sig} K. Cette différence est donc prise comme un effet de la température ou du"
        " montage d'un des essais, pas comme une erreur de l'axe. Les essais ne montrent pas quelle"
        " pente est juste : donner les températures des deux essais (`thermal` du dossier de"
        " travail), ou mesurer de nouveau à température égale"
    ),
    "CW-E029": (
        "L'instrument semble avoir une résolution de {step} : {repeated:if|toutes les mesures d'un"
        " même point visé sont égales, et |}toutes les mesures sont des multiples de ce pas."
        " L'erreur vraie peut différer de chaque moyenne d'un demi-pas. Si l'instrument résout"
        " mieux, exporter ses mesures avec tous les chiffres et évaluer de nouveau"
    ),
    "CW-E030.jump": (
        "L'erreur saute de {size} ± {error} entre {low:.10g} et {high:.10g} {unit} (cote"
        " {sure:if|supérieure à 1000|de {odds:2sig}} contre 1). Y regarder la règle (dommage,"
        " saleté, joint) et sa tête de lecture, et vérifier le nombre de traits du codeur. Où"
        " exactement l'erreur saute est inconnu : mesurer entre ces points visés tous les"
        " quelques mm avant de charger une table"
    ),
    "CW-E030.jump_or_target": (
        "Soit l'erreur saute de {size} ± {error} entre {low:.10g} et {high:.10g} {unit}, soit"
        " seul le point visé à {target:.10g} {unit} s'écarte d'autant. Y regarder la règle"
        " (dommage, saleté, joint) et sa tête de lecture, et vérifier le nombre de traits du"
        " codeur. Où exactement l'erreur saute est inconnu : mesurer entre ces points visés tous"
        " les quelques mm avant de charger une table"
    ),
    "CW-E031": (
        "Pour gagner du temps, le bruit est estimé d'après {used} des {runs} parcours,"
        " régulièrement répartis dans l'essai. Les moyennes utilisent tous les parcours"
    ),
    "CW-E032": (
        "{outliers} des {readings} mesures sont aberrantes, plusieurs au même point visé : {where}"
        "{more:if| et {more} autres} ({odds}). L'erreur vraie de l'axe y est incertaine. Étape"
        " suivante : {cause}, puis mesurer de nouveau"
    ),
    "CW-E032.target": (
        "vérifier les mesures à {target:and} (unité, faisceau, copeaux) et y regarder vis, guidages"
        " et protections"
    ),
    "period.cause": (
        "{cause:choose|lead=un pas de vis de {number:g} mm|inch_lead=un pas de vis de {number:g}"
        " pouce|half_lead=un demi-pas de vis de {number:g} mm|magnets=une paire d'aimants d'un"
        " moteur linéaire|rack=une dent d'une crémaillère hélicoïdale|worm=un tour de vis sans fin"
        " ou de moteur ({number:g} pour un tour du plateau)|files=une période que suggèrent les"
        " fichiers de la commande}"
    ),
    "period.unusual_division": (
        "aucune pièce usuelle ne se répète {parts:.4g} fois par tour. Comparer cette période avec"
        " un tour de la vis sans fin, un tour du moteur par son réducteur et le pas de la règle"
    ),
    "period.unusual_lead": (
        "aucune vis usuelle n'a ce pas. Comparer cette période avec un tour du moteur par courroie"
        " ou réducteur, sa moitié, le pas de la règle ou de la crémaillère et une paire d'aimants"
    ),
    "period.usual": (
        "{once:if|chercher ce qui tourne ou se répète une fois en {period:.5g} {unit} :"
        " {once:join|, ou }|}{twice:if|{once:if| ; ou ce|chercher ce} qui tourne ou se répète une"
        " fois en {double:.5g} {unit} et cause alors deux fois l'erreur : {twice:join|, ou }|}"
    ),
}
