"""Sentences about the corrections that a run plans or refuses, with the reasons."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-P001": "Aucune table n'est écrite pour l'axe {axis} : {why}.",
    "CW-P001.measured": (
        "par calcul à partir des mesures du premier essai, {parameter} est {with_table} avec la"
        " table et {without} sans elle"
    ),
    "CW-P001.new_targets": (
        "dans un essai à de nouveaux points visés, {parameter} devrait être {with_table}"
        " avec la table et {without} sans elle"
    ),
    "CW-P001.not_seen": (
        "dans un essai à de nouveaux points visés, {parameter} devrait être {with_table}"
        " avec une autre table et {without} sans elle. D'un essai à l'autre {parameter} diffère"
        " de {spread}, donc le gain est dans l'incertitude"
    ),
    "CW-P001.old_table": (
        "les essais {off} et {on} contredisent les fichiers de la commande (sûr à {percent:.1f} %)."
        " Dans {on}, la table existante (states.{state} dans le dossier de travail) {did:choose|"
        "not_active=n'était pas active|inverted=était active avec le signe opposé|scaled=était"
        " active avec le facteur {factor:2sig}|shifted=était active, décalée de {shift:+d} points|"
        "mirrored=était active, en miroir sur la course|wrong_axis=n'était pas active ; celle d'un"
        " autre axe l'était|one_direction=n'était active que dans un sens|backlash=était active"
        " avec un autre jeu|partial=n'était active que sur une partie de la course|measurement=ne"
        " va pas avec les mesures : un des essais a été mal mesuré|undecided=s'est comportée"
        " autrement ({likely:join|, ou })}{detail:if| ({detail})}.{off_too:if| Ou elle était active"
        " aussi dans {off}, car les deux essais montrent la même erreur. Vérifier si elle était"
        " désactivée pour {off}.}{exchanged:if| Ou les deux essais sont permutés.} Une table faite"
        " de ces essais serait fausse pour la même raison{look_at:if|. Regarder : {look_at:join|."
        " }}"
    ),
    "CW-P101": (
        "Cercle {circle} : le dossier de travail ne donne pas son centre dans la machine, donc le"
        " milieu de la course est supposé ({centre}). Donner le centre, car l'effet des tables en"
        " dépend."
    ),
    "CW-P101.axis": "{axis} {position:g}",
    "CW-P102": (
        "Cercle {circle} : autour de son centre, il va de {low:.6g} à {high:.6g} sur l'axe {axis},"
        " au-delà de la course. Vérifier centre, rayon et course."
    ),
    "CW-P102.rotary": (
        "Cercle {circle} : l'axe {axis} est un axe rotatif dans le travail, mais un essai"
        " circulaire déplace deux axes linéaires. Vérifier `kind` de l'axe {axis} et les axes du"
        " cercle."
    ),
    "CW-P103": (
        "La table qui corrige {output} selon {input} a des points à pas égaux. Aux positions"
        " mesurées, elle s'écarte donc de la correction souhaitée de {missed} au plus."
    ),
    "CW-P104": (
        "{measured}, mais {circle} d'après {tests}. Les deux se contredisent."
        " {measurements:plural|La table est calculée d'après la mesure directe. Vérifier son"
        " signe|Les tables sont calculées d'après les mesures directes. Vérifier leurs signes}, et"
        " répéter la mesure fausse."
    ),
    "CW-P105": "{measured}. {tests} le confirme ({circle}).",
    "CW-P106.contradictory": (
        "La perpendicularité du plan {plane} n'est pas corrigée, car ses cercles se contredisent"
        " (CW-P110). Répéter le cercle qui s'écarte, ou acquitter CW-P110 dans le dossier de"
        " travail."
    ),
    "CW-P106.no_circle": (
        "La perpendicularité du plan {plane} n'est pas corrigée : le dossier de travail n'a pas de"
        " cercle de ce plan. En mesurer un dans les deux sens."
    ),
    "CW-P106.uncertain": "La perpendicularité du plan {plane} n'est pas corrigée : {why}.",
    "CW-P106.undetermined": (
        "La perpendicularité du plan {plane} n'est pas corrigée, car les cercles ne la déterminent"
        " pas. {reasons:join|; }."
    ),
    "CW-P107": "Plan {plane} : la perpendicularité est de {angle_words}. Il n'y a rien à corriger.",
    "CW-P108": (
        "Plan {plane} : la perpendicularité est de {squareness} d'après {tests}. Elle n'est pas"
        " corrigée, car le dossier de travail ne le demande pas : ajouter `apply: {{squareness:"
        " {{{plane}: AXE}}}}` avec l'axe à corriger comme AXE."
    ),
    "CW-P109": (
        "{plane} : la perpendicularité{existing:if| avec la table existante de la commande|} est"
        " de {squareness} d'après {tests}{converted:if|, mesuré dans un autre état|}. Une"
        " correction déplace l'axe {output} en fonction de l'axe {input}."
    ),
    "CW-P110": (
        "Plan {plane} : les cercles se contredisent sur la perpendicularité (µm/m : {values})."
        " Répéter le cercle qui s'écarte."
    ),
    "CW-P110.circle": "{circle} {squareness:+.1f}",
    "CW-P111": (
        "{pair} : la correction s'étend sur {travel:g} mm de l'axe {axis}, mais la mesure"
        " ({diameter:if|diamètre|plage mesurée}) ne fait que {length:g} mm. Au-delà de la partie"
        " mesurée, elle est extrapolée : l'y vérifier."
    ),
    "CW-P112": (
        "{axis} est un axe de portique. Le déplacer de quelques micromètres pendant qu'un autre"
        " axe se déplace peut provoquer le broutage. Corriger d'abord sa perpendicularité par le"
        " décalage de référence de l'axe synchronisé."
    ),
    "CW-P113.column": (
        "{what} : corrigé dans {where} (les valeurs y sont des"
        " {values:choose|correction=corrections|error=erreurs})."
    ),
    "CW-P113.not_held": "{what} {several:if|ne sont pas corrigés|n'est pas corrigé} : {why}.",
    "CW-P113.own_table": (
        "{what} : corrigé dans la table {table} de la commande, qui est active maintenant : ses"
        " valeurs contiendront l'ancienne et la nouvelle correction. Pour la laisser telle quelle,"
        " n'autoriser que des tables libres : `{option}: [{free}]`."
    ),
    "CW-P113.sheet": (
        "{what} : corrigé par des paramètres que ce calcul n'écrit pas dans les fichiers de la"
        " commande. Les saisir d'après la feuille de saisie {sheet}, dans le dossier de la fiche de"
        " mise en service. Aucun n'est confirmé. La prévision les suppose saisis."
    ),
    "CW-P113.straightness": (
        "{what} : corrigé dans les fichiers par compensation de rectitude : {values}."
    ),
    "CW-P113.switches": (
        "{what} n'est pas corrigé. Le dossier de travail dit (`active`) que la table entre {input}"
        " et {output} {active:if|était active|n'était pas active} pendant la mesure. Les fichiers"
        " de la commande ne le disent pas. Ensuite : donner les fichiers avec tous les"
        " commutateurs comme pendant la mesure, sans les tables qui étaient désactivées, et omettre"
        " `active`."
    ),
    "CW-P113.typed": (
        "{what} : les valeurs de correction ne sont dans aucun fichier pour la commande ({why})."
        " {total:if|Remplacer les valeurs dans {where} par|Ajouter aux valeurs dans {where}} :"
        " {rows}. La fiche de mise en service et la feuille de saisie du même dossier le décrivent."
        " Les valeurs sont des {values:choose|correction=corrections|error=erreurs} ; leur signe"
        " n'est pas confirmé : le vérifier par une mesure avant la production. La prévision les"
        " suppose saisies."
    ),
    "CW-P114": (
        "{axis} : laser et cercle ne concordent pas sur le jeu. Il est de {laser} d'après le"
        " laser, et de {circle} d'après {test}, mesuré en mouvement. La valeur du"
        " {counts:choose|circle=cercle|laser=laser} est utilisée."
    ),
    "CW-P115": (
        "{axis} : laser et cercle ne concordent pas sur l'échelle de {low:.6g} à {high:.6g} mm, où"
        " se trouve le cercle. Elle est de {laser} d'après le laser et de {circle} d'après {test}."
        " La valeur du laser est utilisée."
    ),
    "CW-P116": (
        "Échelle de {pair} : laser et cercle ne concordent pas. Elle est de {laser} d'après le"
        " laser et de {circle} d'après {test}. La valeur du laser est utilisée."
    ),
    "CW-P117": "{axis} : le jeu est pris des cercles. Il diffère de la valeur du laser de {shift}.",
    "CW-P118": (
        "{axis} : l'échelle vient de l'essai de positionnement de cet axe. Les cercles la"
        " vérifient seulement."
    ),
    "CW-P119.contradictory": (
        "{axis} : l'échelle n'est pas corrigée, car les cercles de cet axe se contredisent"
        " (CW-P136). Répéter le cercle qui s'écarte, ou acquitter CW-P136 dans le"
        " dossier de travail."
    ),
    "CW-P119.impossible": "{scale}. Elle n'est pas corrigée : {reasons:join|; }.",
    "CW-P119.lag": (
        "le retard d'asservissement peut réduire le cercle {circle} de {lag:.0f} µm/m (mesurer un"
        " cercle à {feed:.0f} mm/min au plus, ou l'autre axe au laser)"
    ),
    "CW-P119.low_feed": "{circle} à faible avance",
    "CW-P119.mismatch": "la différence d'échelle de {circle} et le laser sur {axis}",
    "CW-P119.negligible": "{scale}. Il n'y a rien à corriger.",
    "CW-P119.not_calibrated": (
        "l'instrument du cercle {circle} n'était pas étalonné, et l'autre axe de ce cercle n'a pas"
        " d'essai de positionnement"
    ),
    "CW-P119.not_taken": (
        "{axis} : aucun cercle ne donne l'échelle de cet axe : {reasons:if|{reasons:join|;"
        " }|aucun n'a été mesuré avec lui}."
    ),
    "CW-P119.together": "{circles:join|, } ensemble",
    "CW-P119.undetermined": (
        "{axis} : l'échelle prise de {tests:join|; } n'est pas corrigée : {why}. Mesurer l'axe au"
        " laser, ou un cercle à faible avance."
    ),
    "CW-P120": (
        "{scale}. La table la corrige. Elle comprend l'effet des températures de l'instrument et"
        " de la règle pendant l'essai : 1 K change l'acier de 11 µm/m."
    ),
    "CW-P130.no_circle": (
        "{axis} : le dossier de travail demande le jeu d'après les cercles, mais aucun cercle n'a"
        " été mesuré avec cet axe. La valeur du laser est utilisée."
    ),
    "CW-P130.no_test": (
        "{axis} : le jeu que montrent les cercles n'est pas corrigé. L'axe n'a pas d'essai de"
        " positionnement, donc aucune table n'est faite pour lui."
    ),
    "CW-P130.none": (
        "apply.backlash_from n'a pas d'effet : aucun cercle du dossier de travail ne montre le"
        " jeu d'un axe."
    ),
    "CW-P130.unknown": (
        "{axis} : le dossier de travail demande le jeu d'après les cercles, mais il n'est pas"
        " utilisé. Soit les cercles ne le montrent pas, soit l'essai de positionnement n'a qu'un"
        " sens."
    ),
    "CW-P131": (
        "Cercle {circle} : avec ces tables, {parameter} devrait passer de {was:.1f} à"
        " {median:.1f} µm ({p05:.1f} à {p95:.1f}). Soit l'essai de positionnement et le cercle se"
        " contredisent, soit un seul axe du plan est corrigé. Les limites du cercle restent non"
        " décidées : chercher pourquoi avant de charger quoi que ce soit."
    ),
    "CW-P132": (
        "{test:choose|circular=Cercle|=Axe} {name} : une décision avec bande de garde demande"
        " l'incertitude U de {lacking}, qui est inconnue. Elle reste non décidée."
        " {test:choose|vdi3441=VDI/DGQ 3441 n'indique pas d'incertitude : donner une autre"
        " norme|linear=Donner `uncertainty` dans le dossier de travail (device.U en µm et ce qui"
        " est connu de plus)|rotary=Donner `uncertainty.rotary` dans le dossier de travail (U de"
        " l'instrument en ″, setup, E_VE)|circular=Donner `uncertainty.circular` dans le dossier de"
        " travail (U de l'instrument en µm, length, setup, E_VE)}, ou `decision_rule: simple`."
    ),
    "CW-P133": (
        "Axe {axis} : la limite devrait être tenue aux mêmes points visés, mais pas à de nouveaux"
        " entre eux. Là, 5 % des essais montrent plus de {parameters}, donc la limite reste non"
        " décidée.{reasons:if| L'erreur peut se répéter {reasons:join|, ou }.|} Mesurer un nouvel"
        " essai à {better}.{known:if|| Donner le pas de la vis s'il est connu (screw_pitch).}"
    ),
    "CW-P133.open": (
        "avec une période que ces points visés laissent ouverte ({probability:.0%} ; d'abord"
        " {periods:3sig} {unit})"
    ),
    "CW-P133.parameter": "{parameter} {value} (limite {limit:g})",
    "CW-P133.period": "tous les {period:.5g} {unit} ({probability:.0%})",
    "CW-P134": (
        "Les causes de l'écart d'un cercle sont inconnues (cercle {causes}). Rien n'est donc"
        " prévu pour ce cercle, et ses limites restent non décidées."
        " {lacking:choose|samples=Mesurer avec au moins {least:d} points par parcours hors des"
        " points d'inversion|circle=Mesurer un cercle entier dans les deux sens|noise=Exporter les"
        " points sans lissage}, ou décider d'après l'essai après chargement."
    ),
    "CW-P135": (
        "Cercles {circles} ensemble. {machine:if|{machine:join| }|Ils ne montrent aucune erreur"
        " de la machine.}"
    ),
    "CW-P135.error": (
        "{kind:choose|squareness=Perpendicularité|scale=Échelle|lost motion=Jeu à"
        " l'inversion|position loop=Constante de temps de la boucle de position} : {values}."
    ),
    "CW-P135.value": "{of} {value}",
    "CW-P136": (
        "{kind:choose|squareness=Perpendicularité|scale=Échelle|lost motion=Jeu à l'inversion|servo"
        " mismatch=Différence d'asservissement} : les cercles se contredisent ({values:join| ; })."
        " Soit la machine a changé entre les essais, soit ses erreurs dépendent du lieu, de"
        " l'avance ou de la température. Répéter le cercle qui s'écarte."
    ),
    "CW-P136.circle": "{circle} : {axes} {value}",
    "CW-P136.growth": (
        "Axe {axis} : le rayon des cercles augmente avec l'avance, plus qu'une boucle de position"
        " ne peut le causer. Une avance, un rayon, une longueur de barre ou une température n'est"
        " pas comme indiqué. Les vérifier pour {circles:join|, }, ou répéter le cercle qui"
        " s'écarte."
    ),
    "CW-P136.lag": (
        "Axe {axis} : le rayon des cercles diminue avec l'avance comme si la boucle de position"
        " avait une constante de temps de {lag} (usuel : jusqu'à {most}). Vérifier l'avance, le"
        " rayon et la température de {circles:join|, } : l'échelle en dépend."
    ),
    "CW-P140": (
        "Axe {axis} : la nouvelle table reçoit de nouveaux points, {grid}. Les points de la table"
        " existante, {existing}, ne peuvent être gardés : {why}"
    ),
    "CW-P141": (
        "Axe {axis} : {stays:if|la nouvelle table garde les points de la table existante|aucune"
        " table avec les points de la table existante n'améliore l'axe} ({existing}). {parameter}"
        " prévu{stays:if|| sans table} : {same} aux mêmes points visés, {new} à de nouveaux points"
        " visés. {parameter} prévu avec de nouveaux points ({grid}) : {better} aux mêmes points"
        " visés, {better_new} à de nouveaux points visés. Pour les nouveaux points, mettre"
        " `spacing: auto` dans la table de l'axe. Les réglages qui dépendent des anciens points"
        " sont adaptés aussi ; ceux qui ne peuvent pas l'être sont listés"
    ),
    "CW-P142.line": (
        "La pente de {slope} va dans la droite à part de la commande. Aux points de la table, il"
        " resterait sans cette droite une erreur de {left} (valeur efficace), et avec elle"
        " {with_line}"
    ),
    "CW-P142.table": (
        "La pente de {slope} reste dans la table. Aux points de la table, il reste sans droite à"
        " part une erreur de {left} (valeur efficace), et avec elle il resterait {with_line}"
    ),
    "CW-P143.none": (
        "Aucune table cyclique (seconde table, qui se répète à chaque période) n'est écrite."
        " {period}"
    ),
    "CW-P143.period": (
        "L'erreur a une période de {period:g} {unit}, trop courte pour des points de table espacés"
        " de {sections:g} {unit}. Sans table cyclique il reste une erreur de {left} (valeur"
        " efficace), avec elle {with_it}"
    ),
    "CW-P143.second": (
        "Une table cyclique (seconde table, qui se répète à chaque période) est écrite aussi."
        " {period}"
    ),
    "CW-P144": (
        "Axe {axis} : les points doivent être saisis à la main, donc la table en a peu : {few},"
        " {mine}. L'autre choix est {many}, {other}. Pour l'utiliser, mettre `start: {start:key},"
        " end: {end:key}, spacing: {spacing:key}` dans la table de l'axe"
    ),
    "CW-P150": (
        "Axe {axis} : une table n'aidera pas ici. {parameter} à de nouveaux points visés, entre les"
        " points mesurés, est {now}{with_table:if| sans table et {with_table} avec une table}. La"
        " plus grande cause : {cause} ({value:.2f} {unit}, {share:.0%}) : {advice}"
    ),
    "CW-P151.cause": (
        "Axe {axis} : {parameter} à de nouveaux points visés, entre les points mesurés, est de"
        " {now} à présent, et la table le réduit de {taken:.0%}. La plus grande part du reste :"
        " {cause} ({value:.2f} sur {left}) : {advice}"
    ),
    "CW-P151.scatter": (
        "Axe {axis} : {parameter} à de nouveaux points visés, entre les points mesurés, est de"
        " {now} à présent, et la table le réduit de {taken:.0%}. {scatter:.0%} de la valeur"
        " actuelle est de la dispersion des mesures, qu'aucune table ne réduit"
    ),
    "CW-P152": (
        "Axe {axis} : {tables:choose|left=la table à plus petite erreur quadratique attendue est"
        " utilisée ; elle n'est pas faite pour le plus petit {goal}|same=la table à plus petite"
        " erreur quadratique attendue donne aussi le plus petit {goal}|taken=la table a été faite"
        " pour le plus petit {goal}|no_gain=une table faite pour le plus petit {goal} ne montre pas"
        " de {goal} plus petit dans de nouveaux essais simulés, donc la table à plus petite erreur"
        " quadratique attendue est utilisée}. Valeurs attendues à de nouveaux points"
        " visés{tables:choose|left=|same=|taken= (entre parenthèses : avec la table à plus petite"
        " erreur quadratique attendue)|no_gain= (entre parenthèses : avec la table faite pour le"
        " plus petit {goal})} : {parameters} {unit}"
    ),
    "CW-P152.parameter": "{parameter} {value:.2f}{other:if| ({other:.2f})}",
    "CW-P153": (
        "Axe {axis} : la différence entre les deux tables (une par sens) peut contenir la dérive de"
        " cet essai. La réversibilité varie de {risen} le long de la course. Les mesures dérivent"
        " de {drifted} du premier au dernier parcours. Si cette dérive continue dans chaque"
        " parcours, aller et retour, elle seule change la réversibilité de {shown}, même à jeu"
        " constant. Mettre l'axe en température et mesurer de nouveau avant de charger deux tables,"
        " ou utiliser une seule table (`mode: single` dans la table de l'axe)"
    ),
    "CW-P154": (
        "Axe {axis} : la valeur de jeu peut contenir la dérive de cet essai. La réversibilité"
        " moyenne est de {measured}. Les mesures dérivent de {drifted} du premier au dernier"
        " parcours. Si cette dérive continue dans chaque parcours, aller et retour, elle change"
        " la réversibilité moyenne de {shown}. Mettre l'axe en température et mesurer de nouveau"
        " avant de charger la valeur de jeu"
    ),
    "CW-P155": (
        "Axe {axis} : s'arrêter ici. De {parameter} = {left:.2f} {unit} à de nouveaux points visés,"
        " {value:.2f} {unit} viennent de la plus grande cause : {cause}. Une autre table changerait"
        " moins qu'un essai ne diffère du suivant."
    ),
    "CW-P156": (
        "Axe {axis} : la commande n'applique jamais un saut de la correction dont la grandeur est"
        " entre {least:.2f} {unit} et {most:.2f} {unit}. La réversibilité de la table est un tel"
        " saut : {reversal:.2f}{reversal_to:if| à {reversal_to:.2f}} {unit}. Après une inversion,"
        " l'ancienne correction reste donc jusqu'à ce que la table elle-même change assez ; la"
        " prévision en tient compte. Pour que ces sauts soient appliqués, mettre la limite"
        " d'accélération de l'axe en dessous de {low:3sig} fois l'actuelle, ou à {high:3sig} fois"
        " au moins, et refaire le calcul"
    ),
    "CW-P160": (
        "Les mesures de l'essai {test} contredisent les indications de son fichier ou du dossier"
        " de travail. Elles sont {ways:join|, ou }. Une table tirée de telles mesures serait"
        " fausse. {checks:join| }"
    ),
    "CW-P160.check": (
        "{way:choose|off=La compensation était-elle active, et l'axe référencé, pendant cet essai ?"
        " Sinon, ajouter une entrée pour cet essai sous `states` et la nommer sous `measured_in`.|"
        "sign=Comparer une mesure avec l'instrument : trop loin en + est un écart positif.|"
        "directions=Regarder dans le fichier de l'instrument dans quel sens l'axe allait au premier"
        " parcours.|order=Comparer les mesures du premier et du dernier point visé avec le fichier"
        " de l'instrument.|against=Déplacer l'axe en + : si l'instrument décompte, l'essai a besoin"
        " de `position_map: {{sense: -1, offset: ..}}`.}"
    ),
    "CW-P160.way": (
        "{odds:odds} fois plus vraisemblables {way:choose|off=si la table de la commande n'était"
        " pas active dans cet essai|sign=si le signe des écarts est inversé (visé moins"
        " mesuré)|directions=si + et − sont permutés|order=si les mesures sont dans l'ordre"
        " inverse des points visés|against=si l'instrument compte à l'opposé de la machine}"
    ),
    "CW-P161": (
        "La table de states.{measured_in} (dossier de travail) ressemble à l'image en miroir de"
        " l'essai {test} ({size:.1f} {unit}). Par hasard, des courbes aussi lisses se ressemblent"
        " autant dans {less:if|moins de }{chance:2sig} % des cas. Si la table a été faite de cet"
        " essai, elle n'y était pas active, et une autre table corrigerait deux fois la même"
        " erreur. Mesurer de nouveau avec la table active, ou nommer sous measured_in l'entrée de"
        " `states` dans laquelle l'essai a été fait. Si la table était active dans cet essai,"
        " écrire dans le dossier de travail d'où on le sait : `acknowledged: {{CW-P161: raison}}`"
    ),
    "CW-P162.after": (
        "le fichier de l'essai après chargement indique la compensation {both:if|active et non"
        " active|non active}, mais le plan charge des tables pour {names:and}. Vérifier à la"
        " commande qu'elles sont actives et mesurer de nouveau, ou corriger la clé `compensation`"
        " du fichier."
    ),
    "CW-P162.both": (
        "les fichiers indiquent la compensation active et non active. Si le dossier de travail"
        " indique une compensation fausse, la nouvelle table est fausse aussi. Vérifier à la"
        " commande ce qui était actif. Puis corriger la clé `compensation` du fichier, ou"
        " `measured_in` et `states` du dossier de travail."
    ),
    "CW-P162.state": (
        "le fichier indique la compensation {on:if|active|non active}, mais states.{state} du"
        " dossier de travail {active:if|a une table ou un jeu actifs|n'a rien d'actif} pour"
        " {names:and}. Si le dossier de travail indique une compensation fausse, la nouvelle table"
        " est fausse aussi. Vérifier à la commande ce qui était actif. Puis corriger la clé"
        " `compensation` du fichier, ou `measured_in` et `states` du dossier de travail."
    ),
    "CW-P163": (
        "Axe {axis}, essai {test} : les fichiers de cet essai donnent des valeurs différentes :"
        " {keys:join|; }. Vérifier que tous appartiennent à cet essai"
    ),
    "CW-P164": (
        "Axe {axis} : l'erreur peut se répéter avec une période que ces points visés ne montrent"
        " pas (d'abord {periods:3sig} {unit}). Pour un essai qui la montre, ajouter {targets:.7g}"
        " {unit} à ces points visés : tous ensemble montrent une telle erreur à partir d'une"
        " amplitude de {amplitude}."
    ),
    "CW-P165": (
        "Axe {axis} : {seen} : {parameter} {low:.2f} à {high:.2f} {unit} à de nouveaux points"
        " visés. {otherwise}, {parameter} est de {least:.2f} à {most:.2f} {unit}. Pour le savoir,"
        " mesurer un deuxième essai de la même façon, et ajouter son fichier à `before` de l'axe"
    ),
    "CW-P165.drift": (
        "l'essai dérive de {drift}, et la prévision suppose la même dérive dans le prochain essai"
    ),
    "CW-P165.no_rest": "Si les mesures se dispersent autour d'une seule valeur",
    "CW-P165.other_drift": "Si chaque essai a sa propre dérive de cette taille",
    "CW-P165.other_scatter": (
        "Si tous les parcours d'un essai ont la dispersion d'un de ces parcours"
    ),
    "CW-P165.rest": (
        "les mesures d'un point visé se trouvent peut-être entre deux limites, comme si l'axe"
        " s'arrêtait à l'une de deux positions ({probability:.0%})"
    ),
    "CW-P165.scatter": (
        "la dispersion d'une mesure est de {least} à {most} selon le parcours, et la prévision"
        " suppose que le prochain essai a la même proportion de parcours à petite et à grande"
        " dispersion"
    ),
    "CW-P166": (
        "{plane:if|La perpendicularité du plan {plane}|L'échelle de l'axe {axis}} est corrigée,"
        " mais mal connue : la correction l'aggrave avec une probabilité de {percent:2sig} %."
        " Mesurer d'autres cercles entiers dans les deux sens, et les donner tous"
    ),
    "CW-P167": (
        "Ce qui serait ajouté à {output} sur {input} (jusqu'à {largest}) est égal à ce que la"
        " commande ajoute déjà entre ces deux axes. Si cette table a été faite à partir de cette"
        " mesure, la même erreur serait corrigée deux fois. Mesurer de nouveau avec la table"
        " active, ou nommer sous measured_in l'entrée de `states` qui était dans la commande"
        " pendant la mesure. Si la table était active, écrire dans le dossier de travail comment"
        " on le sait : `acknowledged: {{CW-P167: raison}}`"
    ),
    "CW-P168": (
        "La correction de {output} sur {input} atteint {largest}, plus de 1 {unit}. Vérifier"
        " {source:choose|cross=`unit` et `positions` de cette mesure sous `cross`|circle=l'unité et"
        " le rayon du cercle et `travel` de {input}}. Si l'erreur est vraiment aussi grande, écrire"
        " dans le dossier de travail comment on le sait : `acknowledged: {{CW-P168: raison}}`"
    ),
    "CW-P169": (
        "Deux mesures sous `cross` corrigent la perpendicularité du plan {plane} : {slopes:and}."
        " Ensemble, elles éliminent {total:+.1f} µm/m. Si chacune montre toute la"
        " perpendicularité, celle-ci est corrigée deux fois : retirer alors la droite des écarts"
        " de l'une des deux. Si les deux ont été mesurées par rapport à une même équerre, l'écrire"
        " dans le dossier de travail : `acknowledged: {{CW-P169: raison}}`. Un cercle de ce plan"
        " dans le dossier montre aussi ce qui est juste"
    ),
    "CW-P169.slope": "{slope:+.1f} µm/m en {output} sur {input}",
    "CW-P170": (
        "{output} sur {input} : les positions de {first} à {last} sont hors de la course de"
        " {travel_start} à {travel_end} du dossier de travail. Vérifier le décalage et le sens des"
        " positions, et la course."
    ),
    "CW-P171": (
        "un fichier est de la machine au numéro de série {found:join| ou }, mais cette machine a"
        " {known}. Une table tirée de l'essai d'une autre machine serait fausse. Donner le"
        " fichier de cette machine, ou corriger le numéro dans le dossier de travail ou dans le"
        " fichier."
    ),
    "CW-P172": (
        "{pair} : la différence d'échelle a des signes opposés : {laser} d'après le laser et"
        " {circle} d'après {test}. Les angles comptent à partir du mauvais axe, les axes du plan"
        " sont échangés, ou un signe est inversé. La perpendicularité peut aussi avoir le mauvais"
        " signe. Vérifier sur la machine à quel angle se trouve chaque axe. Corriger le fichier,"
        " ou acquitter CW-P172 dans le dossier de travail."
    ),
    "grid.even": "{points} points de {start:.10g} à {end:.10g} {unit}, tous les {step:.6g} {unit}",
    "grid.few": "{points} points",
    "grid.predicted": (
        "{name} prévu {value:.2f} {unit} ({elsewhere:.2f} à de nouveaux points visés)"
    ),
    "grid.uneven": (
        "{points} points de {start:.10g} à {end:.10g} {unit}, espacés de {least:.6g} à {most:.6g}"
        " {unit}"
    ),
    "run.no_state": (
        "aucune table n'est écrite : le dossier de travail ne dit pas ce qui est actif dans la"
        " commande ; ajouter `states: {{as_found: none}}` ou `states: {{as_found: [fichiers de la"
        " commande]}}`"
    ),
}
