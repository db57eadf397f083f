"""What is decided on the way from results to tables."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-P001": "Aucune table n'est écrite pour l'axe {axis} : {why}.",
    "CW-P001.measured": (
        "l'essai mesuré, évalué de nouveau avec la table, donne {parameter} {with_table}, sans elle"
        " {without}"
    ),
    "CW-P001.new_targets": (
        "à de nouveaux points visés, {parameter} devrait être {with_table} avec la table, {without}"
        " sans elle"
    ),
    "CW-P001.not_seen": (
        "à de nouveaux points visés, {parameter} devrait être {with_table} avec une autre table,"
        " {without} sans elle, et diffère de {spread} d'un essai à l'autre : le gain est dans"
        " l'incertitude"
    ),
    "CW-P001.old_table": (
        "les essais {off} et {on} contredisent ce que disent les fichiers (sûr à {percent:.1f} %) :"
        " la table de l'état {state} {did:choose|not_active=n'était pas active|inverted=était"
        " active avec le signe opposé|scaled=était active avec le facteur"
        " {factor:2sig}|shifted=était active, décalée de {shift:+d} points|mirrored=était active,"
        " en miroir sur la course|wrong_axis=n'était pas celle qui était active : c'était celle"
        " d'un autre axe|one_direction=n'était active que dans un sens|backlash=était active avec"
        " un autre jeu|partial=n'était active que sur une partie de la course|measurement=convient,"
        " mais pas les mesures entre elles : un des essais a été mal mesuré|undecided=a fait autre"
        " chose ({likely:join|, ou })}{detail:if| ({detail})} dans {on}{off_too:if|, ou elle était"
        " active aussi dans {off} : les deux montrent le même axe (était-elle désactivée pour {off}"
        " ?)}{exchanged:if|, ou les deux essais sont permutés}. Une somme de l'ancien et du nouveau"
        " serait fausse d'autant{look_at:if|. Regarder : {look_at:join|. }}"
    ),
    "CW-P101": (
        "Cercle {circle} : sa place dans la machine n'est pas donnée ; le milieu de la course est"
        " supposé ({centre}). Donner son centre : l'effet des tables en dépend."
    ),
    "CW-P101.axis": "{axis} {position:g}",
    "CW-P102": (
        "Cercle {circle} : un cercle entier autour de son centre va de {low:g} à {high:g} sur"
        " {axis}, au-delà de la course."
    ),
    "CW-P103": (
        "{input} sur {output} : des points à pas égaux manquent les points mesurés de {missed:2sig}"
        " µm au plus."
    ),
    "CW-P104": (
        "{measured}, {circle} d'après {tests} ; ils se contredisent. La mesure directe est"
        " corrigée. Vérifier son signe et répéter la mesure fausse."
    ),
    "CW-P105": "{measured}, ce que {tests} confirme ({circle}).",
    "CW-P106.no_circle": (
        "apply.squareness.{plane} n'est pas corrigé : le dossier de travail n'a pas de cercle de ce"
        " plan. En mesurer un dans les deux sens."
    ),
    "CW-P106.uncertain": "apply.squareness.{plane} n'est pas corrigé : perpendicularité {why}.",
    "CW-P106.undetermined": (
        "apply.squareness.{plane} n'est pas corrigé : sa perpendicularité n'est pas déterminée."
        " {reasons:join|; }."
    ),
    "CW-P107": "{plane} : perpendicularité {angle_words} : rien à corriger.",
    "CW-P108": (
        "{plane} : perpendicularité {squareness} d'après {tests} ; sa correction n'est pas demandée"
        " (apply)."
    ),
    "CW-P109": "{plane} : perpendicularité {squareness} d'après {tests} ; {output} suivra {input}.",
    "CW-P110": (
        "{plane} : ses cercles se contredisent sur la perpendicularité (µm/m : {values}). Répéter"
        " le cercle qui s'écarte."
    ),
    "CW-P110.circle": "{circle} {squareness:+.1f}",
    "CW-P111": (
        "{pair} : corrigé sur {travel:g} mm de {axis}, {what} fait {length:g} mm : une"
        " extrapolation."
    ),
    "CW-P112": (
        "{axis} est un axe de portique : le déplacer de quelques micromètres pendant qu'un autre"
        " axe se déplace risque le broutage ; sa perpendicularité relève d'abord du décalage de"
        " référence de l'axe synchronisé."
    ),
    "CW-P113.column": (
        "{what} est dans {where} (les valeurs sont des"
        " {values:choose|correction=corrections|error=erreurs})."
    ),
    "CW-P113.not_held": (
        "{what} n'est pas corrigé : cette commande, telle que le dossier de travail la décrit, ne"
        " peut le contenir ; {why}."
    ),
    "CW-P113.sheet": (
        "{what} n'est dans aucun fichier : ses paramètres sont dans {sheet} à côté de la fiche,"
        " tous non confirmés."
    ),
    "CW-P113.straightness": (
        "{what} est dans les fichiers comme compensation de rectitude : {values}."
    ),
    "CW-P113.typed": (
        "{what} n'est dans aucun fichier ({why}) : le saisir dans {where}, {rows} (les valeurs sont"
        " des {values:choose|correction=corrections|error=erreurs}), comme le disent la fiche et sa"
        " feuille ; le signe n'est pas confirmé."
    ),
    "CW-P114": (
        "{axis} : jeu {laser} d'après le laser, {circle} d'après {test} (en mouvement) : ils ne"
        " concordent pas ; c'est celui du {counts:choose|circle=cercle|laser=laser} qui compte."
    ),
    "CW-P115": (
        "{axis} : échelle {laser} d'après le laser, {circle} d'après {test} : elles ne concordent"
        " pas ; le laser compte."
    ),
    "CW-P116": (
        "Échelle de {pair} : {laser} d'après le laser, {circle} d'après {test} : elles ne"
        " concordent pas ; le laser compte."
    ),
    "CW-P117": "{axis} : son jeu est pris des cercles : {shift} par rapport à celui du laser.",
    "CW-P118": (
        "{axis} : son échelle est celle de son essai de positionnement ; les cercles la vérifient"
        " seulement."
    ),
    "CW-P119.impossible": "{scale} ; non corrigée : {reasons:join|; }.",
    "CW-P119.lag": (
        "le retard des axes peut réduire {circle} de {lag:.0f} µm/m à son avance (une faible"
        " avance, deux avances, ou un essai de positionnement de son autre axe en décideraient)"
    ),
    "CW-P119.low_feed": "{circle} à faible avance",
    "CW-P119.mismatch": "la différence de {circle} et le laser sur {axis}",
    "CW-P119.negligible": "{scale} ; rien à corriger.",
    "CW-P119.not_calibrated": (
        "l'instrument de {circle} n'était pas étalonné, et son autre axe n'a pas d'essai de"
        " positionnement"
    ),
    "CW-P119.not_taken": (
        "{axis} : son échelle n'est pas prise d'un cercle : {reasons:if|{reasons:join|; }|aucun"
        " cercle n'est sur lui}."
    ),
    "CW-P119.two_feeds": "{slow} et {fast} extrapolés à une avance nulle",
    "CW-P119.undetermined": (
        "{axis} : son échelle n'est pas corrigée : {why}. Elle vient de {tests:join|; }. Ou mesurer"
        " l'axe au laser, ou répéter le cercle à faible avance."
    ),
    "CW-P120": (
        "{scale} ; sa table la corrige. La température de l'instrument et de la règle pendant"
        " l'essai y est contenue : 1 K fait 11 µm/m d'acier."
    ),
    "CW-P130.no_circle": (
        "{axis} : aucun cercle n'est sur lui ; son jeu reste celui du laser, bien que le dossier de"
        " travail demande celui des cercles."
    ),
    "CW-P130.no_test": (
        "{axis} : son jeu d'après les cercles n'est pas corrigé : il n'a pas d'essai de"
        " positionnement, donc pas de table où le mettre."
    ),
    "CW-P130.none": (
        "apply.backlash_from : le jeu d'aucun axe n'est pris des cercles : aucun cercle du dossier"
        " de travail ne le montre."
    ),
    "CW-P130.unknown": (
        "{axis} : son jeu n'est pas pris des cercles, comme le dossier de travail le demande : ils"
        " ne le montrent pas, ou son essai de positionnement n'a qu'un sens."
    ),
    "CW-P131": (
        "Cercle {circle} : {parameter} devrait passer de {was:.1f} à {median:.1f} µm ({p05:.1f} à"
        " {p95:.1f}) avec ces tables. Positionnement et cercle se contredisent, ou un seul axe du"
        " plan est corrigé. Non décidé : chercher pourquoi avant de charger quoi que ce soit."
    ),
    "CW-P132": (
        "{what} : aucune incertitude U de {lacking} n'est connue, et la décision en tient compte :"
        " non décidé ; {give}."
    ),
    "CW-P133": (
        "Axe {axis} : la limite devrait être tenue aux mêmes points visés, pas à de nouveaux : 5 %"
        " des essais y montrent plus de {parameters}. Non décidé.{reasons:if| L'erreur peut se"
        " répéter {reasons:join|, ou }.|} Mesurer à {better}.{known:if|| Donner le pas de la vis"
        " s'il est connu (screw_pitch).}"
    ),
    "CW-P133.open": (
        "avec une période que ces points visés laissent ouverte ({probability:.0%} ; d'abord"
        " {periods:3sig} {unit})"
    ),
    "CW-P133.parameter": "{parameter} {value} (limite {limit:g})",
    "CW-P133.period": "tous les {period:.5g} {unit} ({probability:.0%})",
    "CW-P134": (
        "Cercle {causes}, la bande prévue est donc trop étroite pour décider de ses limites : non"
        " décidé. Mesurer un cercle entier dans les deux sens, ou décider d'après l'essai après"
        " chargement."
    ),
    "CW-P135": (
        "Cercles {circles} comme une seule machine : {machine:if|{machine}|ils ne montrent rien}."
    ),
    "CW-P135.error": (
        "{kind:choose|squareness=perpendicularité|scale=échelle|lost motion=jeu à l'inversion} de"
        " {of} {value}"
    ),
    "CW-P135.position_loop": "boucle de position de {axis} {value}",
    "CW-P136": (
        "{kind:choose|squareness=Perpendicularité|scale=Échelle|lost motion=Jeu à l'inversion|servo"
        " mismatch=Différence d'asservissement} : les cercles se contredisent : {values}. La"
        " machine a changé entre eux, ou ses erreurs dépendent du lieu, de l'avance ou de la"
        " température. Répéter le cercle qui s'écarte."
    ),
    "CW-P136.circle": "{circle} {axes} {value}",
    "CW-P140": (
        "Axe {axis} : une nouvelle grille est choisie, {grid}, à la place de l'existante,"
        " {existing} : {why}"
    ),
    "CW-P141": (
        "Axe {axis} : la grille existante {stays:if|reste|ne convient pas}, {existing}, prévu"
        " {parameter} {same} ({new} à de nouveaux points visés) ; une nouvelle, {grid}, donnerait"
        " {parameter} {better} ({better_new}) : spacing: auto dans la table de l'axe la prend ; ce"
        " qui dépend de l'ancienne suit, ou est nommé si ce n'est pas possible"
    ),
    "CW-P142.line": (
        "La pente de {slope} va dans une droite à part, car sans elle il reste {left} (valeur"
        " efficace) à ses points, avec elle {with_line}"
    ),
    "CW-P142.table": (
        "La pente de {slope} reste dans la table : sans droite à part il reste {left} (valeur"
        " efficace) à ses points, avec elle {with_line}"
    ),
    "CW-P143.none": "Pas de table à part pour {period}",
    "CW-P143.period": (
        "la période de {period:g} {unit}, trop courte pour des sections de {sections:g} : sans"
        " table à part il reste {left} (valeur efficace), avec elle {with_it}"
    ),
    "CW-P143.second": "Une seconde table pour {period}",
    "CW-P144": (
        "Axe {axis} : les points sont saisis à la main, donc peu sont pris : {few}, {mine}. L'autre"
        " choix est {many}, {other} : start: {start:.10g}, end: {end:.10g}, spacing: {spacing:.10g}"
        " dans la table de l'axe le prend"
    ),
    "CW-P150": (
        "Axe {axis} : une table n'aidera pas ici. {parameter} est {now} à de nouveaux points"
        " visés{with_table:if| ({with_table} avec elle)} ; la plus grande cause est {cause}"
        " ({value:.2f} {unit}, {share:.0%}) : {advice}"
    ),
    "CW-P151.cause": (
        "Axe {axis} : sur {parameter} {now} à de nouveaux points visés, la table enlève {taken:.0%}"
        " ; la plus grande part du reste est {cause} ({value:.2f} sur {left}) : {advice}"
    ),
    "CW-P151.scatter": (
        "Axe {axis} : sur {parameter} {now} à de nouveaux points visés, la table enlève {taken:.0%}"
        " ; {scatter:.0%} est de la dispersion, qu'aucune table n'enlève"
    ),
    "CW-P152": (
        "Axe {axis} : {tables:choose|left=la table des moindres carrés attendus est prise, pas une"
        " pour le plus petit {goal}|same=la table des moindres carrés attendus est aussi celle du"
        " plus petit {goal}|taken=faite pour le plus petit {goal}|no_gain=une table pour le plus"
        " petit {goal} n'en montre pas moins dans des essais qu'elle n'a pas vus, donc la table des"
        " moindres carrés attendus est prise} ; attendu à de nouveaux points"
        " visés{tables:choose|left=|same=|taken=, entre parenthèses avec la table des moindres"
        " carrés attendus|no_gain=, entre parenthèses avec celle pour {goal}} : {parameters} {unit}"
    ),
    "CW-P152.parameter": "{parameter} {value:.2f}{other:if| ({other:.2f})}",
    "CW-P153": (
        "Axe {axis} : la seconde table peut contenir la dérive de cet essai. La réversibilité varie"
        " de {risen} le long de la course ; la dérive trouvée, {drifted} du premier au dernier"
        " parcours, en montrerait {shown} dans chaque parcours, aller et retour, à jeu constant."
        " Mettre l'axe en température et mesurer de nouveau avant de charger deux tables, ou en"
        " prendre une (mode: single)"
    ),
    "CW-P154": (
        "Axe {axis} : la valeur de jeu peut contenir la dérive de cet essai. La réversibilité"
        " moyenne est {measured} ; la dérive trouvée, {drifted} du premier au dernier parcours, la"
        " déplace de {shown} si elle continue dans chaque parcours, aller et retour. Mettre l'axe"
        " en température et mesurer de nouveau avant de charger la valeur de jeu"
    ),
    "CW-P155": (
        "Axe {axis} : s'arrêter ici : ce qui reste est {cause} ({value:.2f} {unit} de {parameter}"
        " {left:.2f} {unit} à de nouveaux points visés). Une autre table changerait moins qu'un"
        " essai ne diffère du suivant."
    ),
    "CW-P156": (
        "Axe {axis} : la commande n'applique jamais un saut de la correction au-dessus de"
        " {least:.2f} et jusqu'à {most:.2f} {unit}, et la réversibilité de la table est"
        " {reversal:.2f}{reversal_to:if| à {reversal_to:.2f}} {unit}. Après une inversion,"
        " l'ancienne correction reste jusqu'à ce que la table elle-même change assez ; la prévision"
        " en tient compte. La commande applique ces sauts avec une limite d'accélération de l'axe"
        " inférieure à {low:3sig} fois l'actuelle, ou d'au moins {high:3sig} fois : la changer et"
        " refaire le calcul"
    ),
    "CW-P160": (
        "Les mesures de l'essai {test} ne ressemblent pas à ce que disent son fichier et son état :"
        " elles sont {ways:join|, ou }. Une table qui en serait tirée serait fausse. {checks:join|"
        " }"
    ),
    "CW-P160.check": (
        "{way:choose|off=La compensation était-elle active, et l'axe référencé, pendant la mesure ?"
        " Sinon, nommer cet état sous measured_in.|sign=Comparer une mesure avec l'instrument :"
        " trop loin en + est un écart positif.|directions=Regarder dans le fichier de l'instrument"
        " dans quel sens l'axe allait au premier parcours.|order=Comparer les mesures du premier et"
        " du dernier point visé avec le fichier de l'instrument.|against=Déplacer l'axe en + : si"
        " l'instrument décompte, l'essai a besoin de position_map: {{sense: -1, offset: ..}}.}"
    ),
    "CW-P160.way": (
        "{odds:odds} fois plus vraisemblables {way:choose|off=si la table de la commande n'y était"
        " pas active|sign=avec le signe des écarts inversé (visé moins mesuré)|directions=avec + et"
        " − permutés|order=avec les mesures dans l'ordre inverse des points visés|against=avec un"
        " instrument qui compte à l'opposé de la machine}"
    ),
    "CW-P161": (
        "La table de l'état {measured_in} est l'image en miroir de l'essai {test} ({size:.1f}"
        " {unit}) : elle a été faite de cet essai et n'y était pas active. Une autre table"
        " corrigerait deux fois la même erreur. Mesurer de nouveau avec la table active, ou nommer"
        " sous measured_in l'état dans lequel l'essai a été fait."
    ),
    "CW-P162.after": (
        "le fichier de l'essai après chargement indique la compensation {both:if|active et non"
        " active|non active}, mais le plan charge des tables pour {names:and}. Vérifier à la"
        " commande qu'elles sont actives, mesurer de nouveau, ou corriger la clé compensation du"
        " fichier."
    ),
    "CW-P162.both": (
        "les fichiers indiquent la compensation active et non active. La nouvelle somme est fausse"
        " si le dossier de travail est faux. Vérifier à la commande ce qui était actif, puis"
        " corriger la clé compensation du fichier, ou measured_in et states du dossier de travail."
    ),
    "CW-P162.state": (
        "le fichier indique la compensation {on:if|active|non active}, mais l'état {state} du"
        " dossier de travail {active:if|contient une table ou un jeu actifs|ne contient rien"
        " d'actif} pour {names:and}. La nouvelle somme est fausse si le dossier de travail est"
        " faux. Vérifier à la commande ce qui était actif, puis corriger la clé compensation du"
        " fichier, ou measured_in et states du dossier de travail."
    ),
    "CW-P163": "Axe {axis}, essai {test} : ses fichiers diffèrent en {keys:join|; }",
    "CW-P164": (
        "Axe {axis} : l'erreur peut se répéter avec une période que ces points visés ne montrent"
        " pas ({probability:.0%} ; d'abord {periods:3sig} {unit}). Mesurer aussi à {targets:.7g}"
        " {unit} dans le même essai : tous ensemble montrent une telle erreur à partir d'une"
        " amplitude de {amplitude}."
    ),
    "CW-P165": (
        "Axe {axis} : l'essai dérive de {drift}, et la prévision suppose la même dérive dans le"
        " suivant : {parameter} {low:.2f} à {high:.2f} {unit} à de nouveaux points visés. Si chaque"
        " essai a sa propre dérive de cette taille, {parameter} est de {least:.2f} à {most:.2f}"
        " {unit}. Un deuxième essai fait de la même façon décide : ajouter son fichier à before de"
        " l'axe"
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
        " commande ; ajouter states: {{as_found: none}} ou states: {{as_found: [fichiers de la"
        " commande]}}"
    ),
    "table_advice": (
        "{cause:choose|noise=l'axe ne se répète pas, ce qu'aucune table ne corrige : vérifier"
        " d'abord le montage de l'instrument (vibration, air, fixation), puis appeler un mécanicien"
        " (jeu, guidages, paliers, accouplement, règle)|single outliers=quelques mesures sont"
        " aberrantes, ce qu'aucune table ne corrige : chercher ce qui perturbe la mesure (faisceau"
        " coupé, temps d'arrêt, saleté) et mesurer de nouveau|shifts between traverses=des parcours"
        " entiers sont décalés, ce qu'aucune table ne corrige : vérifier que l'instrument, la"
        " broche et le bridage sont fermes, et chercher un jeu qui diffère d'un parcours à"
        " l'autre|drift=l'axe change pendant l'essai, ce qu'aucune table ne corrige : le mettre en"
        " température comme au travail jusqu'à ce qu'il soit stable, et mesurer de nouveau|one"
        " table for both directions=la réversibilité varie le long de la course, et une table avec"
        " une valeur de réversibilité ne peut la contenir : appeler un mécanicien (écrou, vis,"
        " guidages), ou utiliser une commande avec une table par sens|spacing too wide for the"
        " period=les points sont trop espacés pour une période si courte ; CW-F002 donne"
        " l'intervalle nécessaire. Si la commande ne peut le contenir, appeler un mécanicien (vis,"
        " paliers et accouplement, réducteur, codeur)|error that the test leaves open=l'essai ne"
        " détermine pas assez bien l'erreur : mesurer plus de points visés ou plus de parcours}"
    ),
}
