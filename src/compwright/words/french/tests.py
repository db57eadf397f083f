"""Sentences about positioning and circular tests."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-C001": (
        "Plusieurs parcours ont été mesurés, mais chaque paramètre appartient à un seul (articles"
        " 3.2 et 5). Sont donnés ceux de {first:and}. Les autres parcours : {others}."
    ),
    "CW-C001.other": "{direction} parcours {run} : G {G}",
    "CW-C001.run": "{direction} parcours {run}",
    "CW-C002": (
        "Seul le sens {direction} a été mesuré. Il n'y a donc pas de paramètres des deux sens, et"
        " perpendicularité et différence d'asservissement ne peuvent être séparées."
        " Mesurer aussi l'autre sens."
    ),
    "CW-C003": (
        "La longueur de l'instrument n'était pas étalonnée, donc l'écart radial F n'est pas"
        " donné. D, et F autour du centre des moindres carrés, utilisent la longueur nominale."
    ),
    "CW-C004": (
        "Les points de mesure de {run} sont espacés de {interval:3sig}°. De courts pics"
        " d'inversion peuvent se trouver entre deux points, et alors G, F et H sont trop petits."
        " Mesurer avec une fréquence d'échantillonnage plus élevée ou une avance plus faible."
    ),
    "CW-C005.arc": "{run} couvre {covered:.5g}° d'un arc de {arc:.5g}°.",
    "CW-C005.gap": (
        "Aucun point de mesure de {run} de {gaps} : ce que fait la trajectoire à cet endroit n'est"
        " pas évalué."
    ),
    "CW-C006.no_feed": (
        "Une avance de {feed:g} mm/min n'est pas possible : corriger l'avance dans le fichier."
    ),
    "CW-C006.time": (
        "À {feed:g} mm/min, un cercle de {radius:g} mm dure {seconds:3sig} s : vérifier l'unité de"
        " l'avance."
    ),
    "CW-C007": (
        "{run} couvre {covered:.5g}°, plus que l'arc de {arc:.5g}°. Les points de mesure semblent"
        " contenir les arcs d'entrée et de sortie : vérifier les réglages de l'exportation."
    ),
    "CW-C008.feed": (
        "Le parcours ↺ a {ccw} points de mesure, le parcours ↻ {cw}. À la même fréquence"
        " d'échantillonnage, un sens avait {share:.0f} % de l'avance de l'autre. Perpendicularité"
        " et différence d'asservissement se mélangent alors. Vérifier la correction d'avance et"
        " mesurer les deux sens à la même avance."
    ),
    "CW-C008.few": (
        "Le parcours ↺ a {ccw} points de mesure, le parcours ↻ {cw}. Le cercle commun est donc"
        " plus près du sens qui en a le plus."
    ),
    "CW-C009": (
        "{repeated} points de mesure de {run} ont le même angle qu'un autre. Tous les points sont"
        " utilisés."
    ),
    "CW-C010": (
        "Sur un arc, F est mesuré depuis le centre de montage (article 3.5 a). Il contient donc"
        " le décalage de ce centre, ici environ {offset}. F autour du centre des moindres carrés"
        " est donné aussi."
    ),
    "CW-C011": (
        "Le cercle est à {offset} du centre de montage. Les angles ont été pris comme angles"
        " commandés ; s'ils ont été mesurés depuis le centre de montage, les rayons sont faux de"
        " {effect} au plus. Mieux centrer et mesurer de nouveau."
    ),
    "CW-C012": (
        "Le rayon a changé de {step} du début à la fin de {run}. Soit la machine a dérivé pendant"
        " le parcours, soit l'instrument a bougé, soit des mesures de l'arc d'entrée sont parmi les"
        " points. Répéter le parcours."
    ),
    "CW-C013": (
        "Chaque point de mesure de {run} est exactement nul. Le parcours n'a probablement pas été"
        " mesuré : le mesurer de nouveau."
    ),
    "CW-C014.mirrored": (
        "Les écarts correspondent mieux aux causes de l'ISO 230-4 si les angles des parcours en"
        " cw sont inversés : il reste {left} rms au lieu de {given}. Les angles des deux"
        " sens doivent croître du premier axe vers le second. Si ceux de cw ont été comptés dans"
        " le sens du mouvement, écrire {turn:g}° moins chacun d'eux."
    ),
    "CW-C014.turned": (
        "Les écarts correspondent mieux aux causes de l'ISO 230-4 si les angles des parcours en"
        " cw sont tournés : il reste {left} rms au lieu de {given}. Les angles des deux sens"
        " doivent commencer au premier axe. Si ceux de cw commencent à un autre axe, ajouter"
        " {turn:g}° à chacun d'eux."
    ),
    "CW-C015": (
        "{first} et {second} ont exactement les mêmes mesures. L'un est probablement une copie de"
        " l'autre : le mesurer de nouveau."
    ),
    "CW-C016.coarse": (
        "Les mesures de {run} ont des pas de {step}. Ils cachent les erreurs de cette taille, et"
        " les erreurs types des causes ne sont pas valables. Mesurer avec une résolution de 0,1 µm,"
        " ou exporter plus de décimales."
    ),
    "CW-C016.single": (
        "{count:plural|Une mesure|{count} mesures} de {run}"
        " {count:plural|est|sont} loin des mesures voisines ; la plus grande de {off} à"
        " {angle:.5g}°. Un choc ou une saleté peut en être la cause. Mesurer de nouveau ce"
        " parcours."
    ),
    "CW-C016.still": (
        "La mesure de {run} ne change pas sur {parts:and}, alors que la trajectoire y"
        " change. L'instrument était en fin de course, ou il s'est arrêté. Le placer plus près du"
        " centre et mesurer de nouveau."
    ),
    "CW-T001": (
        "La norme demande 5 approches de chaque point visé dans chaque sens ; trouvées :"
        " {counts:and}."
    ),
    "CW-T001.count": "{count} dans le sens {direction}",
    "CW-T002.linear": (
        "{targets} points visés sur {length:.10g} mm sont trop peu. La norme en demande au moins"
        " 5 par mètre et au moins 5 en tout : ici {needed}."
    ),
    "CW-T002.principal": (
        "ISO 230-2:1988, 4.3.4 demande trois positions en plus de 0°, 90°, 180°, 270° ; il y en a"
        " {others}."
    ),
    "CW-T002.rotary": (
        "{targets} points visés sur {length:.10g}° sont trop peu. Pour cette course, la norme en"
        " demande au moins {needed} (tableau des points visés)."
    ),
    "CW-T003": (
        "Seules les approches dans le sens {direction} ont été mesurées, donc il n'y a pas de"
        " paramètres des deux sens. Le jeu à l'inversion est inconnu."
    ),
    "CW-T004": (
        "La norme demande aussi ces positions principales, mais elles ne sont pas parmi les"
        " points visés : {positions}."
    ),
    "CW-T005.repeated_long": (
        "Cet essai répète ses approches sur plus de {limit}. La norme demande ici deux essais : un"
        " de toute la longueur avec une approche par sens, et un avec cinq approches par sens sur"
        " {limit} de la zone de travail normale. L'essai a été évalué tel qu'il a été mesuré."
    ),
    "CW-T005.repeated_missing": (
        "L'axe est plus long que {limit}, et cet essai a une approche par sens. La norme demande en"
        " plus un essai avec cinq approches par sens sur {limit} de la zone de travail normale."
    ),
    "CW-T005.whole_missing": (
        "L'axe est plus long que {limit}. La norme demande en plus un essai de toute sa longueur"
        " avec une approche par sens."
    ),
    "CW-T006.linear": (
        "L'intervalle moyen des points visés est de {interval:.5g} mm. Sur un axe de plus de 2"
        " 000 mm, la norme autorise au plus 250 mm."
    ),
    "CW-T006.per_turn": (
        "{targets} points visés sur {turns:.4g} tours : il en faut au moins huit par tour."
    ),
    "CW-T006.rotary": (
        "Le plus grand intervalle des points visés est de {interval:.5g}°. Sur un axe de plus de"
        " 360°, la norme autorise au plus 45°."
    ),
    "CW-T006.turns": (
        "{length:.10g}° ont été mesurés ; la norme demande 1 800° (cinq tours) au plus."
    ),
    "CW-T007.end": "{length} à l'extrémité {end:choose|lower=inférieure|upper=supérieure}",
    "CW-T007.outside": (
        "Les points visés de {first} à {last} sont hors de la course de {travel_start} à"
        " {travel_end} du dossier de travail. Vérifier le décalage et le sens des points visés."
    ),
    "CW-T007.uncovered": (
        "Une partie de la course n'a pas été mesurée : {ends:and}. C'est plus d'un intervalle"
        " entre points visés."
    ),
    "CW-T008.equal": (
        "Les points visés sont équidistants ({interval}). Une erreur périodique (pas de vis, pas"
        " de règle) reste cachée si sa période divise cet intervalle. La norme demande des"
        " décalages aléatoires ; {better}"
    ),
    "CW-T008.period": (
        "Tous les points visés sont aux mêmes phases de la période de {period}. Une erreur"
        " périodique de cette période peut rester cachée. Choisir des points visés à des phases"
        " différentes (article sur les points visés) ; {better}"
    ),
    "CW-T009": (
        "L'essai utilise un cycle en pas, que la norme n'autorise pour une réception que par accord"
        " écrit (annexe de l'ISO 230-2). Si l'axe dérive de D pendant un tel essai, E et M"
        " augmentent d'environ 0,92 D, et R ne change presque pas."
    ),
    "CW-T010": (
        "Des mesures manquent : {where:join|; }. Chaque point visé est évalué avec les mesures"
        " qu'il a."
    ),
    "CW-T010.direction": (
        "dans le sens {direction}, {fewer} des {targets} points visés {fewer:plural|a|ont} moins"
        " de mesures que les autres ({at}{more:if| ...})"
    ),
    "CW-T011.rows": (
        "Dans le parcours {traverses}{more:if| et {more} autres}, jusqu'à {targets} points visés"
        " voisins sont exactement nuls, alors que les autres mesures se dispersent. Ils n'ont"
        " probablement pas été mesurés, mais remplis de zéros. Ils font partie du résultat :"
        " s'ils n'ont pas été mesurés, les ôter du fichier."
    ),
    "CW-T011.traverse": (
        "Le parcours {run} dans le sens {direction} est exactement nul aux {targets} points"
        " visés, donc il n'a probablement pas été mesuré. Le résultat le contient. Si les autres"
        " parcours se dispersent, table et prévision sont faites sans lui."
    ),
    "CW-T012": (
        "Les mesures dérivent : {how}. Sans dérive, le seul hasard mettrait les mesures dans un"
        " tel ordre dans {chance:.1f} % des essais. Mettre l'axe en température et mesurer de"
        " nouveau, car la dérive agrandit R et A."
    ),
    "CW-T012.ends": (
        "{lower} à l'extrémité inférieure et {upper} à l'extrémité supérieure de la course dans le"
        " sens {direction}"
    ),
    "CW-T012.growing": (
        "{drifts:join|; } du premier au dernier parcours (la dérive croît le long de la course,"
        " comme une dilatation thermique)"
    ),
    "CW-T012.mean": "{drifts:and} du premier au dernier parcours (moyenne sur les points visés)",
    "CW-T013.more": (
        "{more} {more:plural|autre parcours est aberrant|autres parcours sont aberrants}, d'une"
        " quantité plus petite."
    ),
    "CW-T013.run": (
        "Le parcours {run} s'écarte des autres parcours de {off:and}. Les mesures des autres se"
        " dispersent de {scatter} (écart-type robuste).{compared:if| {compared}}"
    ),
    "CW-T013.traverse": (
        "Le parcours {run} dans le sens {direction} s'écarte des autres parcours de {off}. Les"
        " mesures des autres se dispersent de {scatter} (écart-type robuste).{compared:if|"
        " {compared}}"
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
        "À {targets}, il y a moins de deux mesures par sens, donc pas d'écart-type. Les"
        " paramètres qui en ont besoin ne sont pas donnés.{others:if| Pour les autres points"
        " visés seuls : {others}.}"
    ),
    "CW-T020": (
        "L'incertitude U (k = 2) est calculée d'après les composantes de l'ISO 230-2:2006, annexe"
        " A, que le dossier de travail déclare. Leurs lois sont propagées (JCGM 101:2008) ; les"
        " coefficients de l'annexe ne sont pas utilisés.{misalignment:if| Un faisceau laser mal"
        " aligné mesure trop court, jamais trop long : sur ces points visés de {misalignment:.2f}"
        " µm au plus. U contient ±{counted:.2f} µm pour cela.}"
    ),
    "CW-T021": (
        "Aucune incertitude n'est donnée pour VDI/DGQ 3441, car l'annexe A de l'ISO 230-2 ne"
        " traite que les paramètres de l'ISO 230-2."
    ),
    "CW-T022": (
        "Le dossier de travail donne U_theta mais pas thermal.alpha_m, le coefficient de"
        " dilatation de la machine. La valeur de l'acier a été supposée : {alpha_m:g} µm/(m K)."
    ),
    "CW-T023": (
        "Le dossier de travail donne U_alpha mais pas thermal.T_m, la température de la machine."
        " La composante U_alpha manque donc dans U. Ajouter thermal.T_m."
    ),
    "CW-T024": (
        "Les mesures ont été ramenées à 20 °C de la {refer_to:choose|scale=règle|workpiece=pièce}"
        " : {slope:+.3f} µm/m ont été retirés, avec le point fixe à {x_fix:.10g} mm. Base :"
        " {alpha_m:g} µm/(m K) à {T_m:g} °C pour la"
        " {refer_to:choose|scale=règle|workpiece=pièce}, {alpha_d:g} µm/(m K) à {T_d:g} °C pour"
        " l'instrument."
    ),
    "CW-T025": (
        "La température a changé du début à la fin de l'essai : {changes:and}. Sur les"
        " {length:.5g} mm des points visés, cela fait {drift:+.2f} µm du premier au dernier"
        " parcours. Le fichier ne donne pas l'heure de chaque mesure, donc la dilatation à la"
        " température moyenne du début et de la fin a été retirée. Le reste de la dilatation est"
        " dans les mesures comme dérive."
    ),
    "CW-T025.change": (
        "celle {of:choose|scale=de la règle|workpiece=de la pièce|instrument=de l'instrument} de"
        " {kelvin:+2sig} K"
    ),
    "CW-T026.whole": (
        "La variation de l'environnement E_VE est de {E_VE} : l'étendue des mesures de {file} sur"
        " tout l'enregistrement de {minutes:g} min. E_VE ne doit couvrir que la durée d'un essai de"
        " positionnement. Si votre essai est plus court, donner sa durée dans le dossier de travail"
        " : `E_VE: {{file: {file}, duration_min: ..}}`."
    ),
    "CW-T026.within": (
        "La variation de l'environnement E_VE est de {E_VE} : la plus grande étendue des mesures de"
        " {file} en {minutes:g} min."
    ),
    "CW-T027": (
        "L'essai à l'arrêt {file} ne peut pas montrer toute la variation de l'environnement E_VE"
        " : {reasons:join|; }. Enregistrer la mesure de l'axe au repos, au moins dix fois, aussi"
        " longtemps que dure un essai de positionnement."
    ),
    "CW-T027.coarse": (
        "jusqu'à {minutes:g} min séparent deux mesures, donc les changements entre elles échappent"
    ),
    "CW-T027.short": (
        "il dure {minutes:g} min, mais un essai de positionnement {test:if|du dossier de travail"
        " dure {test:g} min|dure plus longtemps}, donc la dérive d'un essai est plus grande"
    ),
    "CW-T028": (
        "L'effet de l'air sur la longueur d'onde du laser a été retiré : {least:+.3f}{most:if| à"
        " {most:+.3f}|} µm/m, compté depuis {zero:.10g} mm, où l'afficheur indique 0"
        " ({equation:choose|ciddor=Ciddor|edlen=Edlén} ; air en moyenne à {air_c:.4g} °C,"
        " {pressure_hpa:.6g} hPa, {humidity_percent:.3g} % d'humidité). L'afficheur de"
        " l'instrument {assumed:if|est supposé utiliser|utilise} l'indice de réfraction"
        " {counted:.9f}{assumed:if| (air à 20 °C, 1 013,25 hPa, 50 % d'humidité). S'il en utilise"
        " un autre, donner `instrument_air` sous `environment`|}."
    ),
    "CW-T029": (
        "Au point visé où le changement est le plus grand, l'air a changé les mesures de"
        " {light:+.2f} µm (longueur d'onde du laser){expansion:if| et la dilatation de"
        " {expansion:+.2f} µm}, de la première à la dernière. {expansion:if|Les deux ont été"
        " retirés|Cela a été retiré}. La moyenne sur les points visés a encore changé de"
        " {rest:+.2f}{std_error:if| ± {std_error:.2f}|} µm : {unused:if|la dilatation de la règle,"
        " non retirée parce que le dossier de travail n'a pas de `thermal`, ou une dérive de la"
        " machine ou du montage. Pour utiliser la colonne material_c, ajouter `thermal` avec"
        " `alpha_m`|la machine elle-même ou le montage a dérivé}."
    ),
    "CW-T030.certain": "Les mesures ne peuvent pas être justes : {why}. Vérifier leur unité.",
    "CW-T030.small": (
        "Toutes les mesures sont dans {spread}. Peu de machines sont aussi précises : vérifier"
        " l'unité des mesures."
    ),
    "CW-T030.unit": (
        "Les mesures ont été lues en {read_as}, mais leur unité est probablement {unit}"
        " ({odds:odds} contre 1). Elles s'étendent sur {spread} et se dispersent de {scatter} ;"
        " les machines-outils ont d'habitude des valeurs {factor:g} fois {larger:if|plus"
        " grandes|plus petites}. Comparer une mesure avec l'instrument."
    ),
    "CW-T031.directions": "les parcours en + et ceux en −",
    "CW-T031.near": (
        "Ces parcours ont presque les mêmes mesures : {runs:join|; }{more:if| et {more} autres"
        " paires}. Les autres parcours de cet essai diffèrent de {noise}. Un parcours a peut-être"
        " été copié et un peu modifié ; alors répétabilité et bruit sont inconnus. Mesurer de"
        " nouveau."
    ),
    "CW-T031.pair": "{one} et {other} ({difference})",
    "CW-T031.runs": "parcours {runs} et {more:if|{more} autres|{last}} dans le sens {direction}",
    "CW-T031.same": (
        "Ces parcours ont les mêmes mesures jusqu'au dernier chiffre : {runs:join|; }{more:if| et"
        " {more} autres groupes semblables}. Soit un parcours a été copié, soit les mesures sont"
        " arrondies trop grossièrement. Répétabilité et bruit ne peuvent en être tirés. Mesurer"
        " de nouveau, ou exporter avec plus de chiffres."
    ),
    "CW-T032": (
        "La valeur moyenne de réversibilité est +{reversal}, mais un jeu la rend négative."
        " {likely:if|À {odds:odds} contre 1|Peut-être}, les sens + et − sont permutés ou le signe"
        " des écarts est inversé, à moins que la compensation de jeu ne soit trop grande. Une"
        " table faite avec des sens permutés double le jeu. Vérifier à un point visé : avec un"
        " jeu, l'écart de l'approche en + est le plus petit."
    ),
    "CW-T033": (
        "Lus en pouces, les points visés de {first} à {last} sont des millimètres entiers."
        " Vérifier si le fichier les donne en pouces."
    ),
    "CW-T034": (
        "C'est la même mesure que {tests}{others:if| et d'autres}. Une mesure donnée deux fois ne"
        " prouve rien de plus : la donner une fois."
    ),
    "CW-T035": (
        "L'essai a {targets} {targets:plural|point visé|points visés}, mais la norme en demande"
        " au moins {fewest}. L'erreur entre les points visés est inconnue. Paramètres et limites"
        " ne valent que pour {targets:plural|ce point visé|ces points visés}."
    ),
    "CW-T036": (
        "Les essais {test} et {other} se contredisent. Ils diffèrent de {difference:.2f} {unit},"
        " et {what:choose|error=l'erreur elle-même|reversal=la réversibilité moyenne elle-même}"
        " est de {size:.2f} {unit}. Seul {test} est utilisé, {other} ne l'est pas. Vérifier que"
        " les deux ont les mêmes signe, sens, unité, axe et état de la commande."
    ),
    "CW-T037": (
        "Les essais des axes {one} et {other} montrent la même erreur. À {odds:odds} contre 1, le"
        " même axe a été mesuré pour les deux, ou un seul fichier a été donné pour les deux. Une"
        " table faite avec l'essai d'un autre axe agrandit l'erreur. Vérifier quel axe s'est"
        " déplacé dans chaque essai."
    ),
    "CW-T038": (
        "L'enregistrement de l'environnement {file} a une lacune pendant l'essai, {gap:2sig} fois"
        " plus longue que l'intervalle habituel de ses lignes. Dans la lacune, les valeurs ont"
        " été interpolées sur une droite."
    ),
    "CW-T039": (
        "Les mesures n'ont pas d'heure, donc la moyenne de l'enregistrement de l'environnement a"
        " été utilisée. Dans l'enregistrement, la correction varie de {range:.2f} µm sur"
        " {length:.5g} mm, et les mesures peuvent être fausses d'autant. Ajouter une colonne"
        " `time` au fichier de mesure, ou ne donner que la partie de l'enregistrement qui"
        " appartient à l'essai."
    ),
    "CW-T040": (
        "Le jeu à l'inversion de {file} n'est pas une constante : il va de {first} à {first_move}"
        " jusqu'à {last} à {last_move}. Une seule valeur de compensation du jeu, au mieux"
        " {constant}, laisse jusqu'à ±{left}. Prendre la valeur"
        " {over:choose|distance=au déplacement|speed=à la vitesse} d'usinage, et chercher torsion"
        " et frottement."
    ),
    "CW-T041": (
        "Le jeu à l'inversion de {file} ne dépend pas visiblement {over:choose|distance=du"
        " déplacement|speed=de la vitesse} : une valeur constante, {constant}, laisse jusqu'à"
        " ±{left}.{few:if| Si peu de lectures ne peuvent pas montrer de dépendance : mesurer à huit"
        " valeurs ou plus, ou répéter chacune.|}"
    ),
    "reason.cannot_be_formed": "ne peut être calculé à partir de ces mesures",
    "reason.no_common_angle": "les deux sens n'ont aucun angle en commun",
    "reason.no_reading": "aucune mesure dans le sens {direction} à {position}",
    "reason.not_calibrated": (
        "la longueur de l'instrument n'était pas étalonnée (ISO 230-4:1996, 4.5)"
    ),
    "reason.not_measured": "l'essai n'a pas été mesuré dans le sens {direction}",
    "reason.one_approach": "l'essai n'a qu'une approche par sens ({clause})",
    "reason.one_reading": (
        "une seule mesure dans le sens {direction} à {position}, donc pas d'écart-type à ce point"
    ),
    "reason.undefined_1988": (
        "l'ISO 230-2:1988 ne définit pas ce paramètre, seulement R, A et la valeur moyenne de"
        " réversibilité (2 et 6)"
    ),
    "reason.undefined_1996": (
        "l'ISO 230-4:1996 ne définit pas ce paramètre, seulement H, G et F (3.3 à 3.5)"
    ),
    "reason.undefined_2005": (
        "l'ISO 230-4:2005 ne définit pas ce paramètre ; elle a l'écart circulaire bidirectionnel à"
        " la place"
    ),
}
