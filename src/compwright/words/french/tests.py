"""What is noticed about positioning and circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-C001": (
        "Chaque paramètre appartient à un parcours (articles 3.2 et 5) ; sont donnés ceux de"
        " {first:and}. Autres : {others}."
    ),
    "CW-C001.other": "{direction} parcours {run} : G {G}",
    "CW-C001.run": "{direction} parcours {run}",
    "CW-C002": (
        "Seul le sens {direction} a été mesuré : les paramètres des deux sens n'existent pas, et"
        " perpendicularité, différence d'asservissement et jeu à l'inversion ne peuvent être"
        " séparés."
    ),
    "CW-C003": (
        "La longueur de l'instrument n'était pas étalonnée : F n'est pas donné ; D et F autour du"
        " centre des moindres carrés reposent sur la longueur nominale."
    ),
    "CW-C004": (
        "Les points de mesure de {run} sont espacés de {interval:3sig}° : des pics d'inversion"
        " peuvent manquer, et G, F et H sont trop petits."
    ),
    "CW-C005.arc": "{run} couvre {covered:.5g}° d'un arc de {arc:.5g}°.",
    "CW-C005.gap": (
        "Aucun point de mesure de {run} de {gaps} : ce que fait la trajectoire à cet endroit n'est"
        " pas évalué."
    ),
    "CW-C006.no_feed": "{feed:g} mm/min n'est pas une vitesse d'avance.",
    "CW-C006.time": (
        "À {feed:g} mm/min, un cercle de {radius:g} mm dure {seconds:3sig} s : vérifier l'unité de"
        " l'avance."
    ),
    "CW-C007": (
        "{run} couvre {covered:.5g}°, plus que l'arc de {arc:.5g}° : les arcs d'entrée et de sortie"
        " ne semblent pas coupés."
    ),
    "CW-C008": (
        "{ccw} points de mesure ↺ et {cw} ↻ : le cercle commun est tiré vers le sens qui en a le"
        " plus."
    ),
    "CW-C009": "{repeated} points de mesure de {run} répètent un angle ; tous comptent.",
    "CW-C010": (
        "F sur un arc compte depuis le centre de montage (3.5 a) et contient son décalage, ici"
        " environ {offset} ; F autour du centre des moindres carrés est donné aussi."
    ),
    "CW-C011": (
        "Le cercle est à {offset} du centre de montage. Les angles ont été pris comme angles"
        " commandés ; s'ils ont été mesurés depuis le centre de montage, les rayons sont faux de"
        " {effect} au plus. Mieux centrer et mesurer de nouveau."
    ),
    "CW-C012": (
        "Les extrémités de {run} diffèrent de {step} au même endroit : dérive pendant le parcours,"
        " instrument déplacé, ou mesures de l'arc d'entrée parmi les points."
    ),
    "CW-C013": "{run} est exactement nul partout : probablement non mesuré.",
    "CW-T001": (
        "La norme demande 5 approches de chaque point visé dans chaque sens ; trouvées :"
        " {counts:and}."
    ),
    "CW-T001.count": "{count} dans le sens {direction}",
    "CW-T002.linear": (
        "{targets} points visés sur {length:.10g} mm sont trop peu : il en faut au moins 5 par"
        " mètre et 5 en tout, ici {needed}."
    ),
    "CW-T002.principal": (
        "ISO 230-2:1988, 4.3.4 demande trois positions en plus de 0°, 90°, 180°, 270° ; il y en a"
        " {others}."
    ),
    "CW-T002.rotary": (
        "{targets} points visés sur {length:.10g}° sont trop peu : cette course en demande au moins"
        " {needed} (tableau des points visés)."
    ),
    "CW-T003": (
        "Seule l'approche dans le sens {direction} a été mesurée ; les paramètres des deux sens"
        " n'existent pas."
    ),
    "CW-T004": "Position principale absente des points visés : {positions}.",
    "CW-T005.repeated_long": (
        "Approches répétées sur plus de {limit} : la norme essaie toute la longueur avec une"
        " approche par sens, et n = 5 sur {limit} dans la zone de travail normale, en deux essais."
        " Évalué tel que mesuré."
    ),
    "CW-T005.repeated_missing": (
        "L'axe est plus long que {limit} ; un essai avec n = 5 sur {limit} complète cet essai avec"
        " une approche par sens."
    ),
    "CW-T005.whole_missing": (
        "L'axe est plus long que {limit} ; il lui faut aussi un essai de toute sa longueur avec une"
        " approche par sens."
    ),
    "CW-T006.linear": (
        "L'intervalle moyen des points visés est de {interval:.5g} mm ; au-delà de 2 000 mm il doit"
        " être de 250 mm au plus."
    ),
    "CW-T006.per_turn": (
        "{targets} points visés sur {turns:.4g} tours : il en faut au moins huit par tour."
    ),
    "CW-T006.rotary": (
        "Le plus grand intervalle des points visés est de {interval:.5g}° ; au-delà de 360° il doit"
        " être de 45° au plus."
    ),
    "CW-T006.turns": (
        "{length:.10g}° ont été mesurés ; la norme demande 1 800° (cinq tours) au plus."
    ),
    "CW-T007.end": "{length} à l'extrémité {end:choose|lower=inférieure|upper=supérieure}",
    "CW-T007.outside": (
        "Les points visés de {first} à {last} sont hors de la course de {travel_start} à"
        " {travel_end} : vérifier le décalage et le sens des positions."
    ),
    "CW-T007.uncovered": (
        "Une partie de la course n'a pas été mesurée : {ends:and}, plus d'un intervalle des points"
        " visés."
    ),
    "CW-T008.equal": (
        "Les points visés sont équidistants ({interval}) : une erreur périodique (pas de vis, pas"
        " de règle) dont la période divise l'intervalle reste cachée. La norme demande des"
        " décalages aléatoires ; {better}"
    ),
    "CW-T008.period": (
        "Les points visés tombent toujours aux mêmes phases de la période de {period} : une erreur"
        " périodique de cette période peut rester cachée. Choisir des points visés à des phases"
        " variées (article sur les points visés) ; {better}"
    ),
    "CW-T009": (
        "Cycle en pas : pas pour une réception, sauf accord écrit (annexe de l'ISO 230-2). Une"
        " dérive D pendant l'essai met environ 0,92 D dans E et M, et presque rien dans R."
    ),
    "CW-T010": (
        "Des mesures manquent : {where:join|; } en ont moins que les autres ; chaque point visé est"
        " évalué avec son propre n."
    ),
    "CW-T010.direction": (
        "dans le sens {direction}, {fewer} des {targets} points visés ({at}{more:if| ...})"
    ),
    "CW-T011.rows": (
        "Jusqu'à {targets} points visés voisins sont exactement nuls dans le parcours"
        " {traverses}{more:if| et {more} autres}, alors que les autres mesures se dispersent :"
        " probablement non mesurés et remplis de zéros. Ils font partie du résultat."
    ),
    "CW-T011.traverse": (
        "Le parcours {run} dans le sens {direction} est exactement nul aux {targets} points visés :"
        " probablement non mesuré. Il fait partie du résultat ; là où les autres se dispersent,"
        " table et prévision sont faites sans lui."
    ),
    "CW-T012": (
        "Les mesures dérivent : {how} ; dans des parcours sans dérive, un tel ordre a une"
        " probabilité de {chance:.1f} %. Mettre l'axe en température et mesurer de nouveau : la"
        " dérive fait partie de R et A."
    ),
    "CW-T012.ends": "{lower} et {upper} dans le sens {direction}",
    "CW-T012.growing": (
        "du premier au dernier parcours, aux extrémités inférieure et supérieure de la course,"
        " {drifts:join|; } (elle croît le long de la course, comme une dilatation)"
    ),
    "CW-T012.mean": "{drifts:and} du premier au dernier parcours (moyenne sur les points visés)",
    "CW-T013.more": "{more} autres parcours sont aberrants, dans une moindre mesure.",
    "CW-T013.run": (
        "Le parcours {run} s'écarte des autres de {off:and} (écart-type robuste de leurs mesures :"
        " {scatter}).{compared:if| {compared}}"
    ),
    "CW-T013.traverse": (
        "Le parcours {run} dans le sens {direction} s'écarte des autres de {off} (écart-type"
        " robuste de leurs mesures : {scatter}).{compared:if| {compared}}"
    ),
    "CW-T014.compared": (
        "Le résultat avec {readings:plural|la mesure suspecte|les {readings} mesures suspectes} et"
        " sans : {compared}"
    ),
    "CW-T014.listed": (
        "{readings:plural|Mesure suspecte|Mesures suspectes} : {where}{more:if| et {more} autres} ;"
        " écart-type robuste d'une mesure : {scatter}.{compared:if| {compared}}"
    ),
    "CW-T015": "Les points visés sans mesure sont omis : {targets}.",
    "CW-T016": (
        "Moins de deux mesures par sens à {targets} : pas d'écart-type à ces points, donc ce qui en"
        " dépend n'est pas donné.{others:if| Sur les autres points visés : {others}.}"
    ),
    "CW-T020": (
        "Incertitude : U (k = 2) d'après les composantes de l'ISO 230-2:2006, annexe A, dans la"
        " mesure où le dossier de travail les déclare ; leurs lois sont propagées (JCGM 101:2008),"
        " non les coefficients de l'annexe.{misalignment:if| Un faisceau mal aligné mesure trop"
        " court, jamais trop long, de {misalignment:.2f} µm au plus sur ces points visés. U"
        " contient ±{counted:.2f} µm pour cela.}"
    ),
    "CW-T021": (
        "Aucune incertitude n'est indiquée pour VDI/DGQ 3441 : l'annexe A de l'ISO 230-2 ne traite"
        " que ses propres paramètres."
    ),
    "CW-T022": (
        "U_theta est donné sans thermal.alpha_m : {alpha_m} µm/(m K) (acier) a été supposé pour la"
        " machine."
    ),
    "CW-T023": (
        "U_alpha est donné sans thermal.T_m : la température est inconnue, donc son terme manque"
        " dans U."
    ),
    "CW-T024": (
        "Ramené à 20 °C ({refer_to:choose|scale=règle|workpiece=pièce}) : {slope:+.3f} µm/m retirés"
        " autour de {x_fix:.10g} mm, d'après {alpha_m:g} µm/(m K) à {T_m:g} °C pour la"
        " {refer_to:choose|scale=règle|workpiece=pièce} et {alpha_d:g} µm/(m K) à {T_d:g} °C pour"
        " l'instrument."
    ),
    "CW-T025": (
        "La température a changé du début à la fin de l'essai : {changes:and}. Sur les {length:.5g}"
        " mm des points visés, cela fait {drift:+.2f} µm du premier au dernier parcours. La"
        " dilatation a été retirée avec la moyenne du début et de la fin, car le fichier ne dit pas"
        " quand chaque mesure a été prise : ce qui s'en écarte reste dans les mesures comme dérive."
    ),
    "CW-T025.change": (
        "celle {of:choose|scale=de la règle|workpiece=de la pièce|instrument=de l'instrument} de"
        " {kelvin:+2sig} K"
    ),
    "CW-T026.whole": (
        "E_VE est {E_VE}, la plus grande étendue de {file} sur la totalité de ses {minutes:g} min."
        " Il doit être aussi long qu'un essai de positionnement : donner la durée du vôtre en"
        " duration_min s'il est plus court."
    ),
    "CW-T026.within": "E_VE est {E_VE}, la plus grande étendue de {file} en {minutes:g} min.",
    "CW-T027": (
        "L'essai à l'arrêt {file} montre trop peu de E_VE : {reasons:join|; }. Enregistrer la"
        " lecture de l'axe au repos, au moins dix fois, aussi longtemps que dure un essai."
    ),
    "CW-T027.coarse": (
        "jusqu'à {minutes:g} min séparent deux mesures : ce qui va et vient est manqué"
    ),
    "CW-T027.short": (
        "il dure {minutes:g} min, et {test:if|un essai de positionnement du dossier de travail dure"
        " {test:g} min|aucun essai de positionnement n'est si court} : la dérive d'un essai est"
        " plus grande"
    ),
    "CW-T028": (
        "L'air a modifié la lumière : {least:+.3f}{most:if| à {most:+.3f}|} µm/m à partir de"
        " {zero:.10g} mm, où l'afficheur indique 0, ont été retirés"
        " ({equation:choose|ciddor=Ciddor|edlen=Edlén} ; air en moyenne à {air_c:.4g} °C,"
        " {pressure_hpa:.6g} hPa, {humidity_percent:.3g} %). L'afficheur de l'instrument"
        " {assumed:if|est supposé utiliser|utilise} l'indice de réfraction"
        " {counted:.9f}{assumed:if|, air à 20 °C, 1 013,25 hPa et 50 % : donner `instrument_air`"
        " sous `environment` s'il en utilise un autre|}."
    ),
    "CW-T029": (
        "De la première à la dernière mesure, la lumière a changé de {light:+.2f} µm et la"
        " dilatation de {expansion:+.2f} µm, au point visé où elles ont le plus changé : les deux"
        " ont été retirées. Le reste des mesures a changé de {rest:+.2f}{std_error:if| ±"
        " {std_error:.2f}|} µm, en moyenne sur les points visés : dérive de la machine elle-même,"
        " ou du montage."
    ),
    "CW-T030.certain": "Cela ne peut être juste : {why}.",
    "CW-T030.small": (
        "Toutes les mesures tiennent dans {spread} : peu de machines sont aussi bonnes. L'unité"
        " est-elle juste ?"
    ),
    "CW-T030.unit": (
        "L'unité est probablement {unit}, lue comme {read_as} ({odds:odds} contre 1). Les mesures"
        " s'étendent sur {spread} et se dispersent de {scatter} ; les machines-outils ont"
        " d'ordinaire des valeurs {factor:g} fois plus {larger:if|grandes|petites}. Comparer une"
        " mesure avec l'instrument."
    ),
    "CW-T031.directions": "les parcours en + et ceux en −",
    "CW-T031.near": (
        "Presque les mêmes mesures : {runs:join|; }{more:if| et {more} autres paires}, alors que"
        " les parcours de cet essai diffèrent de {noise}. Un parcours a-t-il été copié et un peu"
        " modifié ? Répétabilité et bruit en sont inconnus."
    ),
    "CW-T031.pair": "{one} et {other} ({difference})",
    "CW-T031.runs": "parcours {runs} et {more:if|{more} autres|{last}} dans le sens {direction}",
    "CW-T031.same": (
        "Les mêmes mesures jusqu'au dernier chiffre : {runs:join|; }{more:if| et {more} autres"
        " groupes}. Un parcours a-t-il été copié, ou les mesures sont-elles trop arrondies ?"
        " Répétabilité et bruit ne peuvent en être tirés."
    ),
    "CW-T032": (
        "La valeur moyenne de réversibilité est +{reversal}, alors qu'un jeu en donne une"
        " négative{likely:if| : {odds:odds} contre 1 que| : peut-être} les sens + et − sont"
        " permutés ou le signe des écarts inversé, à moins que la compensation de jeu ne soit trop"
        " grande. Une table faite avec des sens permutés double le jeu. Vérifier à un point visé :"
        " avec un jeu, l'écart de l'approche en + est le plus petit."
    ),
    "CW-T033": (
        "Les points visés, de {first} à {last}, sont des millimètres entiers si on les lit en"
        " pouces : sont-ils en pouces ?"
    ),
    "CW-T034": (
        "La même mesure que {tests}{others:if| et d'autres} : donnée deux fois, elle ne prouve rien"
        " de nouveau."
    ),
    "CW-T035": (
        "{targets} {targets:plural|point visé|points visés}, là où la norme en demande au moins"
        " {fewest} : de ce qui est entre eux, rien n'est connu. Paramètres et limites ne valent que"
        " pour {targets:plural|ce point visé|ces points visés}."
    ),
    "CW-T036": (
        "Les essais {test} et {other} se contredisent : ils diffèrent de {difference:.2f} {unit},"
        " {what:choose|error=l'erreur elle-même|reversal=la réversibilité moyenne elle-même} est de"
        " {size:.2f} {unit}. Signe, sens, unité, axe et état étaient-ils les mêmes ? Seul {test}"
        " compte, {other} non."
    ),
    "CW-T037": (
        "Les essais des axes {one} et {other} montrent la même erreur : {odds:odds} contre 1 qu'un"
        " axe a été mesuré pour les deux, ou un fichier donné pour l'autre. Une table faite avec"
        " l'essai d'un autre axe agrandit son erreur. Quel axe s'est déplacé dans chaque essai ?"
    ),
    "CW-T038": (
        "L'enregistrement de l'environnement {file} a une lacune pendant l'essai, {gap:2sig} fois"
        " l'intervalle habituel de ses lignes : entre-temps, les valeurs ont été prises sur une"
        " droite."
    ),
    "CW-T039": (
        "Les mesures ne disent pas quand elles ont été prises : la moyenne de l'enregistrement de"
        " l'environnement a été utilisée. Dans l'enregistrement, la correction varie de {range:.2f}"
        " µm sur {length:.5g} mm, et les mesures peuvent être fausses d'autant. Ajouter une colonne"
        " `time` au fichier de mesure, ou donner l'enregistrement de la seule durée de l'essai."
    ),
    "reason.cannot_be_formed": "ne peut être formé de ces mesures",
    "reason.no_common_angle": "les deux sens n'ont aucun angle en commun",
    "reason.no_reading": "aucune mesure dans le sens {direction} à {position}",
    "reason.not_calibrated": (
        "la longueur de l'instrument n'était pas étalonnée (ISO 230-4:1996, 4.5)"
    ),
    "reason.not_measured": "non mesuré dans le sens {direction}",
    "reason.one_approach": "une approche par sens ({clause})",
    "reason.one_reading": (
        "une seule mesure dans le sens {direction} à {position}, donc pas d'écart-type à ce point"
    ),
    "reason.undefined_1988": (
        "non défini par l'ISO 230-2:1988 (2 et 6 : R, A et la valeur moyenne de réversibilité)"
    ),
    "reason.undefined_1996": "non défini par l'ISO 230-4:1996 (3.3 à 3.5 : H, G et F)",
    "reason.undefined_2005": (
        "non défini par l'ISO 230-4:2005, qui a l'écart circulaire bidirectionnel à la place"
    ),
}
