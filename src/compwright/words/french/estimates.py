"""What the estimate of an error and the diagnosis of circles say."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-D001": (
        "un seul sens : ce qui dépend du sens ne peut être séparé du reste ; erreurs types que cela"
        " multiplie : {causes:if|{causes}|aucune}"
    ),
    "CW-D001.cause": "{cause} (x {factor:.0f}, avec {other})",
    "CW-D002": (
        "un arc de {arc:g}° sépare moins bien les causes qu'un cercle ; erreurs types que cela"
        " multiplie : {causes:if|{causes}|aucune}"
    ),
    "CW-D003": (
        "la longueur de l'instrument n'était pas étalonnée : l'échelle des axes seuls n'est pas"
        " donnée, seulement leur différence"
    ),
    "CW-D004": (
        "à {feed:g} mm/min, une boucle de position souple rend le cercle plus petit de {most:.1f}"
        " µm au plus : de ce fait, l'échelle des axes seuls est incertaine de {doubt:.0f} µm/m ; un"
        " second essai à faible avance tranche"
    ),
    "CW-D005.none": (
        "l'arc ne contient aucun point d'inversion de {name} : son jeu, son jeu latéral et son pic"
        " d'inversion ne sont pas déterminés"
    ),
    "CW-D005.one": (
        "l'arc ne contient qu'un point d'inversion de {name} : son jeu est celui de l'extrémité"
        " {end:choose|positive=positive|negative=négative}"
    ),
    "CW-D006": "une erreur périodique de {axis} a été trouvée au pas de {pitch:.4g} mm",
    "CW-D007": (
        "aucune erreur périodique de {name} n'a été trouvée ; une de moins de {hidden:2sig} µm peut"
        " être cachée"
    ),
    "CW-D008": (
        "{name} est jusqu'à {inward:2sig} µm à l'intérieur après ses inversions : sa compensation"
        " de jeu est peut-être trop forte"
    ),
    "CW-D009": (
        "une période de {period:g} mm le long de {axis} ne peut être vue : les points de mesure"
        " montrent des périodes de {least:3sig} à {most:g} mm"
    ),
    "CW-D010": (
        "{rms:2sig} µm d'écart ont une forme qu'aucune cause n'explique ; les erreurs types en"
        " tiennent compte"
    ),
    "CW-D011": (
        "les axes s'inversent {lag:.1f} ± {error:.1f} ms après leurs consignes ; les angles ont été"
        " corrigés de ce retard"
    ),
    "CW-E001": (
        "Mesuré dans un seul sens : la même erreur est supposée dans les deux, le jeu n'est pas"
        " connu."
    ),
    "CW-E002": (
        "Une approche par point visé et par sens : le bruit est déduit de la dispersion entre"
        " points visés voisins."
    ),
    "CW-E003": (
        "Les points visés ne peuvent montrer une erreur de période {period:g} {unit} (leur"
        " intervalle la cache) : elle est laissée de côté, et un essai à d'autres points visés peut"
        " montrer plus que prévu ; {better}"
    ),
    "CW-E004": (
        "La course dépasse de {beyond:g} {unit} au plus la zone mesurée (de {first:g} à {last:g}"
        " {unit}) : l'erreur y est prolongée avec la pente mesurée, et son incertitude croît"
    ),
    "CW-E010": (
        "À ces points visés, espacés de {interval:.4g} {unit}, une erreur de période {period:g}"
        " {unit} ressemble à {wave:if|une onde de {wave:.4g} {unit}|une constante} : les deux ne"
        " peuvent être séparées, la période n'est pas ajustée, et aucune limite n'est acceptée ;"
        " {better}"
    ),
    "CW-E011": (
        "La table est faite {number:plural|du seul essai {tests}, qui couvre|des essais"
        " {tests:and}, sur} {low:g} à {high:g} {unit} ; l'essai {other} a mesuré {other_low:g} à"
        " {other_high:g} {unit} et n'est pas ajusté. Au-delà de {low:g} à {high:g} {unit}, l'erreur"
        " est seulement prolongée et peut être fausse de plus que sa valeur : nommer l'état actif"
        " dans la commande pendant la mesure (measured_in), donner l'essai {other} en premier, ou"
        " arrêter la table à la zone mesurée (table: start, end)"
    ),
    "CW-E012.found": (
        "L'erreur se répète tous les {period:.5g} {unit} (probabilité {probability:.0f} %, {odds})"
        " : {meaning}.{nodes:if| Les points de la table dans la commande sont aussi espacés de"
        " {nodes:.5g} {unit} : une table qui n'était pas active comme le disent ses fichiers laisse"
        " une erreur qui ressemble à celle-ci ; vérifier d'abord qu'elle l'était.} Elle compte dans"
        " l'estimation et la prévision avec cette probabilité"
    ),
    "CW-E012.period": "{period:.5g} {unit} ({percent:.0f} %)",
    "CW-E012.possible": (
        "L'erreur peut se répéter tous les {periods} : ces points visés n'en décident pas, et"
        " chacune compte avec sa probabilité. Plus de points visés à décalages aléatoires le"
        " montreraient"
    ),
    "CW-E013": (
        "L'erreur se répète, mais ces points visés ne montrent pas avec quelle période :"
        " {periods:.4g}{more:if| et {more} autres} {unit} y ont le même aspect. Aucune n'est"
        " retirée avec certitude, et un essai à d'autres points visés peut tout en montrer ;"
        " {better}"
    ),
    "CW-E014.equal_spacing": (
        "Aucune période n'a été trouvée, mais des intervalles égaux cachent celles qui les divisent"
        " ({interval:.4g} {unit}) ; les points visés que propose CW-T008 les montreraient"
    ),
    "CW-E014.few_targets": (
        "Trop peu de points visés ({targets}) pour chercher une erreur périodique : huit à"
        " décalages aléatoires en montrent certaines, plus sont mieux"
    ),
    "CW-E014.hidden": (
        "Aucun pas de vis ni autre période n'est donné, et aucun n'a été trouvé : il y a"
        " {probability:.0f} % de chances que l'erreur se répète avec une période que ces points"
        " visés ne montrent guère"
    ),
    "CW-E014.unlikely": (
        "Aucun pas de vis ni autre période n'est donné, et aucun n'a été trouvé : il y a moins de 1"
        " % de chances que l'erreur se répète avec une période que ces points visés ne montrent"
        " guère"
    ),
    "CW-E015": (
        "Sur {known} périodes connues, les mesures en montrent {fitted} : {periods:g} {unit} ; les"
        " autres ne sont pas ajustées"
    ),
    "CW-E016": (
        "Les mesures ne montrent pas d'erreur qui se répète tous les {stated:and} {unit}, comme le"
        " dit le dossier de travail (screw_pitch), mais une qui se répète tous les {found:and}"
        " {unit} : le pas est-il juste ? Les deux restent dans l'estimation ; un pas faux n'y nuit"
        " pas, mais la grille est choisie pour lui"
    ),
    "CW-E020": (
        "Les mesures dérivent de {drift} du premier au dernier parcours ({odds}){flattens:if|, et"
        " la dérive s'atténue}. Avec un seul essai, la prévision suppose la même dérive dans un"
        " essai répété de la même façon, à partir d'un axe aussi froid, à un dixième près : une"
        " autre dérive, ou aucune parce que l'axe est alors chaud, est hors de la bande. Un"
        " deuxième essai fait de la même façon l'y met. Mettre l'axe en température et mesurer de"
        " nouveau pour le voir sans elle"
    ),
    "CW-E021": (
        "Les mesures s'écartent le long de la course, comme dans une dilatation thermique : de"
        " {lower} à l'extrémité inférieure et de {upper} à l'extrémité supérieure du premier au"
        " dernier parcours ({odds}){flattens:if|, et la dérive s'atténue}. La prévision suppose la"
        " même dérive dans un essai répété de la même façon, à partir d'un axe aussi froid, à un"
        " dixième près. Un essai n'en dit pas plus : une autre dérive, ou aucune parce que l'axe"
        " est alors chaud, est hors de la bande. Mettre l'axe en température et mesurer de nouveau"
        " pour le voir sans elle"
    ),
    "CW-E022.all": (
        "{pattern:choose|traverses=Les parcours sont décalés les uns par rapport aux"
        " autres|runs=Les allers-retours sont décalés en bloc les uns par rapport aux"
        " autres|walk=Le zéro se promène d'un parcours à l'autre|wave=Les mesures montent et"
        " descendent lentement dans le temps} de {size}{pattern:choose|walk= par pas|=} (un"
        " écart-type ; {odds}){where:if|, {where:and}} : {pattern:choose|wave=regarder l'air du"
        " hall (chauffage, refroidissement, courants d'air, soleil)|=regarder la mise en"
        " température, le bridage, les prises de référence et la fixation de l'instrument entre les"
        " parcours}. La prévision tire de nouveau de {pattern:choose|wave=telles ondes|=tels"
        " décalages}"
    ),
    "CW-E022.either": (
        "Les parcours bougent les uns par rapport aux autres ({odds}) ; ces mesures ne montrent pas"
        " s'ils dérivent ou sautent : regarder la mise en température, le bridage, les prises de"
        " référence et la fixation de l'instrument entre les parcours. La prévision compte avec les"
        " deux"
    ),
    "CW-E022.seldom": (
        "{pattern:choose|traverses=Quelques parcours s'écartent des autres|runs=Quelques"
        " allers-retours s'écartent en bloc des autres|walk=Le zéro saute de temps en temps et"
        " reste là,} de {size} (un écart-type ; {odds}){where:if|, {where:and}} : regarder la mise"
        " en température, le bridage, les prises de référence et la fixation de l'instrument entre"
        " les parcours. La prévision tire de nouveau de tels décalages, aussi rarement"
    ),
    "CW-E023": (
        "L'échelle change d'un parcours à l'autre : les extrémités de la course bougent de {tilt}"
        " par rapport à son milieu (un écart-type ; {odds}) : regarder la compensation d'air et de"
        " température de l'instrument et les courants d'air"
    ),
    "CW-E024": (
        "{outliers} des {readings} {outliers:plural|mesures est aberrante|mesures sont aberrantes}"
        " : {where}{more:if| et {more} autres} ({odds}). Elles comptent peu dans l'estimation, et"
        " un essai répété devrait en avoir autant : {cause}, puis mesurer de nouveau"
    ),
    "CW-E024.reading": "chercher leur cause (faisceau, copeaux, bridage)",
    "CW-E024.target": "toutes à {target}, y regarder vis, guidages et protections",
    "CW-E024.traverse": "toutes dans {traverse}, chercher ce qui s'est passé dans ce parcours",
    "CW-E025": (
        "Quelques mesures sont plus loin que la dispersion normale ne l'explique ({odds}) : les"
        " mesures lointaines comptent moins dans l'estimation, et un essai répété devrait en avoir"
    ),
    "CW-E026": (
        "Les mesures se dispersent de {positive} en + et de {negative} en − ({odds}) : chercher ce"
        " qui bouge librement dans un seul sens"
    ),
    "CW-E027": (
        "La dispersion des mesures dépend de la position : la plus petite, {least}, à {least_at} et"
        " la plus grande, {most}, à {most_at} ({odds}) : regarder vis, guidages et protections là"
        " où elle est la plus grande"
    ),
    "CW-E028": (
        "L'essai {test} a une autre pente que l'essai {other} : {difference:+.1f} ± {error:.1f}"
        " µm/m, autant que {kelvin:2sig} K d'acier. Elle compte comme température ou montage d'un"
        " des essais, pas comme erreur de l'axe ; ils ne montrent pas laquelle est juste : donner"
        " les températures des essais (thermal), ou mesurer de nouveau à température égale"
    ),
    "CW-E029": (
        "Résolution supposée de l'instrument : {step} ({repeated:if|chaque point visé répète une"
        " mesure, et |}toutes les mesures tombent sur ce pas). L'erreur vraie peut différer de"
        " chaque moyenne d'un demi-pas. Si l'instrument résout mieux, exporter ses mesures avec"
        " tous les chiffres et évaluer de nouveau"
    ),
    "CW-E030.jump": (
        "L'erreur saute de {size} ± {error} entre {low:.10g} et {high:.10g} {unit} (cote"
        " {sure:if|supérieure à 1000|de {odds:2sig}} contre 1) : y regarder la règle (dommage,"
        " saleté, joint), sa tête de lecture et le nombre de traits du codeur. Entre ces points"
        " visés, la place du saut est inconnue : y mesurer à des points visés espacés de quelques"
        " mm avant de charger une table"
    ),
    "CW-E030.jump_or_target": (
        "L'erreur saute de {size} ± {error} entre {low:.10g} et {high:.10g} {unit}, ou seul le"
        " point visé à {target:.10g} {unit} s'écarte d'autant : y regarder la règle (dommage,"
        " saleté, joint), sa tête de lecture et le nombre de traits du codeur. Entre ces points"
        " visés, la place du saut est inconnue : y mesurer à des points visés espacés de quelques"
        " mm avant de charger une table"
    ),
    "CW-E031": (
        "Le bruit est estimé d'après {used} des {runs} parcours, régulièrement répartis dans"
        " l'essai ; les moyennes utilisent tous les parcours"
    ),
    "period.cause": (
        "{cause:choose|lead=un pas de vis de {number:g} mm|inch_lead=un pas de vis de {number:g}"
        " pouce|half_lead=un demi-pas de vis de {number:g} mm|magnets=une paire d'aimants d'un"
        " moteur linéaire|rack=une dent d'une crémaillère hélicoïdale|worm=un tour de vis sans fin"
        " ou de moteur, 1/{number:g} de celui de la table|files=ce que suggèrent les fichiers de la"
        " commande}"
    ),
    "period.unusual_division": (
        "division inhabituelle ({parts:.4g} par tour) : regarder le tour de la vis sans fin ou du"
        " moteur par son réducteur, et le pas de la règle"
    ),
    "period.unusual_lead": (
        "pas inhabituel : regarder le tour du moteur par courroie ou réducteur, sa moitié, le pas"
        " de la règle ou de la crémaillère, une paire d'aimants"
    ),
    "period.usual": (
        "{once:if|chercher ce qui tourne ou se répète une fois en {period:.5g} {unit} :"
        " {once:join|, ou }|}{twice:if|{once:if| ; ou ce|chercher ce} qui le fait deux fois en"
        " {double:.5g} {unit} : {twice:join|, ou }|}"
    ),
}
