"""Sentences about a control's files: their contents, and differences between two sets of files."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F011.feed": (
        "à {feed:g} {unit}/min ({of:choose|option=option max_feed|rapid=rapide, paramètre 1420}),"
        " les points de la table doivent être à {least:g} {unit} au moins l'un de l'autre. Règle"
        " de la commande : avance divisée par {rule} ({evidence})"
    ),
    "CW-S001": (
        "{file} : la dernière ligne ne se termine pas par un saut de ligne. Le fichier est"
        " peut-être tronqué : vérifier qu'il est complet"
    ),
    "CW-S002": (
        "{file} : la marque de fin {mark} manque. Le fichier est peut-être tronqué : vérifier"
        " qu'il est complet"
    ),
    "CW-S003": (
        "{label} : les fichiers donnent {quantity} plusieurs fois. La"
        " {rule:choose|first=première|last=dernière|={rule}} valeur est utilisée : {value}"
        " ({where})"
    ),
    "CW-S004.not_zero": (
        "{label} : le fichier contient {values} {values:plural|valeur|valeurs} après la fin de la"
        " table (de {first} à {last}), dont {not_zero} non nulles. La commande ne les utilise"
        " pas. Elles viennent d'une table plus ancienne et plus longue, ou la fin ou l'intervalle"
        " de cette table est faux : vérifier les deux"
    ),
    "CW-S004.zero": (
        "{label} : le fichier contient {values} {values:plural|valeur nulle|valeurs nulles} après"
        " la fin de la table. La commande ne les utilise pas"
    ),
    "CW-S005": (
        "{label} : {quantity} n'est pas dans les fichiers ; {value} est supposé. Si la commande a"
        " une autre valeur, les tables et les corrections sont fausses de la différence. Chercher"
        " la valeur à la commande, ou ajouter le fichier qui la contient"
    ),
    "CW-S006": (
        "axe {axis} : plusieurs systèmes de mesure ont une table de compensation. Seule la table"
        " du système {system} est montrée"
    ),
    "CW-S007": "{label} : la table n'a pas d'effet ({switch})",
    "CW-S008": (
        "{label} : aucun fichier ne contient de table de compensation. On suppose que la commande"
        " n'en a pas pour lui"
    ),
    "CW-S009": (
        "{label} : la commande ignore {what}, car l'axe {why:choose|table=a une table|rotary=est"
        " un axe rotatif}"
    ),
    "CW-S010": (
        "l'axe {axis} du dossier de travail est supposé être l'axe {address} de la commande. Le"
        " vérifier à la commande, et donner à l'axe son `address` dans le dossier de travail"
    ),
    "CW-S011": (
        "{label} corrige {output} selon {input}. Elle reste telle quelle : {why}. {active:if|Elle"
        " est active, de la même façon avant et après le chargement|Elle est désactivée}"
    ),
    "CW-S012.assignments": (
        "{file} n'est pas actif : la ligne active qui affecte les tables aux axes ne le nomme pas"
    ),
    "CW-S012.no_axis": "La commande ne charge pas {file} : aucun axe ne nomme ce fichier",
    "CW-S012.no_table": (
        "La commande ne charge aucune table de {files}{more:if| et de {more} autres} : aucun axe"
        " ne nomme un tel fichier, et aucun ne contient de table"
    ),
    "CW-S012.not_given": (
        "{file} est actif quand {axis} se déplace, mais ce fichier n'a pas été donné. Son effet"
        " sur d'autres axes est inconnu : ajouter le fichier"
    ),
    "CW-S012.start_up_list": (
        "La commande ne charge pas {file} : la liste de démarrage ne nomme pas ce fichier"
    ),
    "CW-S013": (
        "{file}, ligne {line} : aucun manuel ne montre une ligne de cette forme. Elle a été lue"
        " malgré tout. Vérifier qu'elle est bien lue. {lines} {lines:plural|ligne|lignes} du"
        " fichier {lines:plural|a|ont} cette forme"
    ),
    "CW-S014": (
        "les axes {addresses:and} partagent les numéros {first} à {last} des points de"
        " compensation. Un changement pour l'un changerait aussi l'autre, donc une nouvelle table"
        " reçoit ses propres numéros"
    ),
    "CW-S015": (
        "{label} : l'avance et le rapide ont des compensations de jeu différentes ({feed} et"
        " {rapid} ; {why}). Est montrée ici celle {rapid_shown:if|du rapide (1852)|de l'avance"
        " (1851)}. Une nouvelle table change les deux valeurs de la même quantité, leur"
        " différence reste"
    ),
    "CW-S016": (
        "{label} : sur un tour complet, les points de compensation {first} et {last} sont la même"
        " position. Le point {first} devrait avoir la valeur du point {last} ({value:g})"
    ),
    "CW-S017": (
        "axe {axis} : la table de {file} couvre un tour complet, mais sa dernière valeur diffère"
        " de la première"
    ),
    "CW-S018": (
        "{label} : la position de référence n'est pas le zéro machine (1240). On suppose que la"
        " commande compte les points de compensation depuis {reference:g} (option reference) ; ce"
        " n'est pas confirmé. Vérifier la correction à deux positions"
    ),
    "CW-S019": (
        "{label} : l'axe est programmé au diamètre (1006#3). Positions, intervalle et corrections"
        " sont pris comme valeurs au rayon ; ce n'est pas confirmé. La faute habituelle est un"
        " facteur 2, donc vérifier la correction à une position après le chargement"
    ),
    "CW-S030": (
        "les axes {leading} et {partner} forment un portique, mais leurs corrections diffèrent"
    ),
    "CW-S031.gantry": (
        "les axes {axis} et {other} ont la même table. S'ils forment un portique, donner à l'axe"
        " {axis} la clé `gantry: {other}` dans le dossier de travail, pour que les deux reçoivent"
        " la nouvelle table. Une nouvelle table sur un seul met le portique de travers"
    ),
    "CW-S031.single": (
        "les axes {axis} et {other} ont la même table. D'après les fichiers de la commande, l'axe"
        " {axis} n'appartient à aucun portique"
    ),
    "CW-S032": (
        "{label} : toutes les valeurs et la grille sont nulles. Cela veut dire qu'il n'y a pas de"
        " table"
    ),
    "CW-S033.ends": (
        "{label} est un axe sans fin, mais sa table ne se répète pas : la table a deux extrémités"
    ),
    "CW-S033.repeats": (
        "{label} : la table existante se répète tous les {period:g}, mais le dossier de travail ne"
        " donne pas de `modulo` pour cet axe. Une nouvelle table ne se répétera pas : elle aura"
        " deux extrémités"
    ),
    "CW-S034": "{label} est désactivé dans les fichiers ({switches}), donc il ne corrige rien",
    "CW-S035": (
        "axe {axis} : d'après le dossier de travail, cet axe se déplace seul, mais {parameter}"
        " peut le coupler à un autre axe. Laisser le couplage désactivé dans chaque essai."
        " Charger les tables des deux axes avant de réutiliser le couplage"
    ),
    "CW-S036": (
        "Comme le dit le dossier de travail, l'axe {gantry} reçoit {table:choose|same=la même"
        " table que l'axe {axis}|change=sa propre table existante plus le même changement que"
        " l'axe {axis}}. Les corrections des deux axes diffèrent ensuite de {after:.2f} {unit} au"
        " plus, avant de {before:.2f} {unit} au plus. En aucune position la différence ne change"
        " de plus de {moved:.2f} {unit}"
    ),
    "CW-S037": (
        "axe {axis} : l'axe {follows} le suit comme deuxième entraînement, sans position propre"
        " ({parameter}). La table de l'axe {axis} corrige les deux"
    ),
    "CW-S038": (
        "Les axes {axis} et {gantry} du portique s'écartent de {moved:.2f} {unit} au plus (limite"
        " {limit:.2f} {unit}), alors que l'axe {axis} gagne {gain:.2f} {unit}. La cause : les"
        " points de leurs tables sont à des positions différentes. Donner aux deux axes les mêmes"
        " points dans la commande, ou donner `table: same` dans le dossier de travail"
    ),
    "CW-S040": (
        "{label} : {bits} = 1 ({value}). Des machines réelles utilisent ce réglage, mais son sens"
        " n'est pas confirmé ; il reste tel quel. Il signifie peut-être une compensation"
        " interpolée : dans ce cas, donner l'option output: ramp"
    ),
    "CW-S041": (
        "{label} : sur un tour complet, le manuel donne à {own} le même numéro qu'à {zero}, mais"
        " dans les fichiers {own} est {first}, un de plus que {zero}. Les numéros {first} à {last}"
        " sont lus comme les sections du tour ; le numéro {reference} reste réservé à l'axe"
    ),
    "CW-S042": (
        "l'axe {axis} a des réglages inhabituels et n'est pas modifié, ses points de compensation"
        " non plus : {reasons:join|; }"
    ),
    "CW-S043": (
        "{label} : {systems}. L'unité de détection, dans laquelle les corrections sont comptées,"
        " en dépend. Vérifier 1013 sur l'affichage de la commande avant de charger"
    ),
    "CW-S044": (
        "{label} : l'axe revient à sa position de référence dans la direction {files} d'après"
        " 1006#5, mais {job} d'après le dossier de travail. Le dossier de travail est suivi. S'il"
        " est faux, seul le zéro est déplacé, du jeu, car il y a une seule table pour les deux"
        " directions. Avec deux tables, cette contradiction est refusée"
    ),
    "CW-S045": (
        "{label} : la course du dossier de travail dépasse de {outside:g} {unit} les limites de"
        " l'axe dans la commande, de {low:g} à {high:g} ({parameters}). Vérifier que course et"
        " points visés sont en coordonnées machine"
    ),
    "CW-S046": (
        "{file} : les points de la table ne sont pas équidistants (écarts de {least:.10g} à"
        " {most:.10g}), alors que la commande exige des intervalles égaux. Ils sont lus tels"
        " quels ; une nouvelle table reçoit des intervalles égaux"
    ),
    "CW-S047": (
        "{label} : la compensation de jeu progressive applique la valeur de jeu 1851 par étapes"
        " ({parameters}). Elle reste telle quelle. La dernière étape est appliquée {reach:g} {unit}"
        " au plus après une inversion (non confirmé). Avant, la compensation de jeu diffère de"
        " 1851, dans les essais comme en usinage"
    ),
    "CW-S048": "{label} : {function}",
    "CW-S049.none": (
        "{suggested}. Le dossier de travail ne donne pas de pas de vis. La recherche d'erreurs"
        " périodiques prend donc cette période pour la plus probable. Si c'est le pas de la vis,"
        " ajouter `screw_pitch: {lead:key}` à l'axe"
    ),
    "CW-S049.other": (
        "{suggested}. Le dossier de travail donne {periods:g} à la place, et il est suivi :"
        " vérifier le pas à la vis"
    ),
    "CW-S049.suggested": (
        "{label} : d'après les fichiers de la commande, un tour du moteur déplace l'axe de"
        " {lead:g} {unit} ({evidence}). Des erreurs peuvent se répéter avec cette période"
    ),
    "CW-S050.cec": (
        "{label} corrige {output} selon {input}. Elle reste telle quelle : {why}. {active:if|Elle"
        " est active, de la même façon avant et après le chargement|Elle est désactivée}"
    ),
    "CW-S050.list": "{label} est laissé tel quel, et ses corrections ne sont pas montrées : {why}",
    "CW-S050.sum": (
        "Les tables CEC {tables} corrigent l'axe {output}. Leur somme va de {low:g} à {high:g},"
        " mais MD32720 $MA_CEC_MAX_SUM limite la somme à {limit:g}. Les tables restent telles"
        " quelles : actives, de la même façon avant et après le chargement"
    ),
    "CW-S051": (
        "Les tables qui corrigent un axe selon un autre ({pairs}) restent telles quelles et ne"
        " sont pas montrées, car le signe des valeurs CEC sur cette commande est inconnu. Vérifier"
        " le signe d'après la fiche de mise en service, puis donner l'option cec_sign"
    ),
    "CW-S052": (
        "axe {axis} : le dossier de travail nomme le système de mesure {number}, mais dans les"
        " fichiers la compensation est activée pour le système {other} (MD32700). S'assurer que"
        " l'axe utilise le système {number}"
    ),
    "CW-S053": (
        "axe {axis} : en plus de sa table, cette compensation est active : {functions:join|; }."
        " Elle reste telle quelle. On suppose qu'elle agit de la même façon pendant l'essai et"
        " après le chargement"
    ),
    "CW-S054": (
        "Les tables CEC {tables} restent telles quelles. Toutes leurs valeurs sont 0, donc elles ne"
        " corrigent rien"
    ),
    "CW-S055": (
        "Les valeurs des tables CEC sont montrées comme si une valeur positive déplaçait l'axe en"
        " +. D'après le manuel de Siemens (Fonctions d'extension 03/2009, page 372), une valeur"
        " positive déplace l'axe en −, donc l'inverse. Vérifier le signe d'après la fiche de mise"
        " en service, puis donner l'option cec_sign"
    ),
    "CW-S056": (
        "axe {axis} : {period:if|la table existante se répète tous les {period:g}, mais le dossier"
        " de travail ne donne pas de `modulo` pour cet axe. Une nouvelle table ne se répétera pas :"
        " elle aura deux extrémités|l'axe tourne sans fin, mais sa table ne se répète pas : la"
        " table a deux extrémités}"
    ),
    "CW-S057": (
        "{format} : le sens des paramètres {parameters} sur cette série est inconnu ({place}) ;"
        " sur d'autres séries, ce sont des unités, des chemins ou une autre compensation. Ils"
        " restent tels quels et ne sont pas comparés au dossier de travail. Les chercher dans le"
        " manuel de la commande. Si l'un d'eux est une compensation, garder les points de la table"
        " existante : une nouvelle table avec d'autres points ne tient pas compte de cette"
        " compensation"
    ),
    "CW-S060": (
        "La table a été relue de ses fichiers, mais pas vérifiée indépendamment : seule votre"
        " propre définition de {definition} dit ce que font ces fichiers. Un signe ou une unité"
        " faux dans la définition rend faux tous les résultats ici. Vérifier la correction sur la"
        " machine, à une position et des deux côtés, avant que toute la table soit"
        " active{expectation:if|. Une définition est vérifiée avec des corrections calculées à la"
        " main. {definition} n'en a pas, donc celles de {expectation} ont été utilisées}"
    ),
    "CW-S061": (
        "{what}. La définition de {carried} contenue dans le plan est utilisée à la place. Pour une"
        " autre définition, refaire le calcul"
    ),
    "CW-S062": "le format de commande {name} signifie {definition} : {title}",
    "CW-S070": (
        "{file} : il contient des programmes qui chargent la compensation ou la commutent :"
        " {programs}. Ils n'ont pas été exécutés ici. Le résultat est celui des données de"
        " l'archive elle-même ; si un tel programme a tourné depuis, la commande en diffère"
    ),
    "CW-S071": (
        "{file} : la commande ne charge pas de fichier avec des virgules décimales, c'est donc un"
        " listage. Ses virgules sont lues comme des points décimaux. La commande contient"
        " peut-être d'autres valeurs : en comparer quelques-unes"
    ),
    "CW-S072": (
        "{file} : rien dans cette archive ne montre si une valeur a été changée après"
        " l'exportation. La fiche de mise en service du calcul liste jusqu'à trois valeurs par"
        " axe. Avant de charger, les comparer avec l'affichage de la commande"
    ),
    "CW-S073": (
        "{file} : d'après le dossier de travail, la commande n'a jamais exécuté ce fichier"
        " (active: no). Ses tables et valeurs de jeu comptent comme non chargées"
    ),
    "CW-S080": (
        "{files} : pour {axis:if|l'axe {axis}|ces fichiers}, la correction qu'applique la commande"
        " ne peut pas être calculée à partir des fichiers ({faults:join| ; }{more:if| ; et {more}"
        " autres|}). Seules les entrées des fichiers sont comparées, une à une"
    ),
    "CW-S081": (
        "{files} : compwright lit de tels fichiers de deux manières indépendantes. Une seule a pu"
        " lire ces corrections ; l'autre signale : {why}"
    ),
    "CW-S082": (
        "{files} : certains de ces fichiers ne contiennent pas de données de la commande et ne"
        " sont pas comparés : {idle}"
    ),
    "CW-S083.new": (
        "Ce qui a été relu contient {new} {new:plural|valeur|valeurs} de compensation absentes"
        " des fichiers du plan. Elles n'ont pas été comparées"
    ),
    "CW-S083.not_read": (
        "{missing} {missing:plural|valeur de compensation des fichiers du plan n'a pas été relue,"
        " donc pas comparée|valeurs de compensation des fichiers du plan n'ont pas été relues,"
        " donc pas comparées}"
    ),
    "CW-S084": (
        "{files} : omis, car ces fichiers du dossier ne contiennent aucune ligne au format {format}"
    ),
    "CW-S085": (
        "{path} a été écrit par compwright run, pas relu de la commande. Cela ne montre pas ce"
        " que contient la commande. Enregistrer les données depuis la commande, et donner ce"
        " fichier"
    ),
    "CW-S086": (
        "Aucun fichier ne dit si {number:plural|l'axe {names} est linéaire ou rotatif|les axes"
        " {names} sont linéaires ou rotatifs}. L'unité des corrections est inconnue : millièmes de"
        " mm (µm) ou de degré (3,6″). Donner --option kind=linear ou --option kind=rotary."
    ),
    "CW-S087": (
        "La table de l'axe {output} en fonction de l'axe {input} n'a pas été relue en entier : il"
        " manque {value}{more:if| et {more} autres}. On ne sait pas si cette table est chargée et"
        " active. Relire aussi ces valeurs de la commande, et donner leurs fichiers avec"
        " `--loaded`."
    ),
    "CW-S087.assumed": (
        "{fact} : compté comme {value} ({evidence}). Les fichiers du plan le donnent, les fichiers"
        " relus non : la comparaison dépend de cette hypothèse. Relire aussi cette valeur de la"
        " commande, et donner son fichier avec `--loaded`."
    ),
    "CW-S087.typed": (
        "Les fichiers relus ne contiennent aucune table de l'axe {output} en fonction de l'axe"
        " {input}. On ne sait pas si les valeurs de la feuille de saisie ont été saisies. Relire"
        " aussi cette table de la commande, et donner son fichier avec `--loaded`."
    ),
    "CW-S088.coupled": (
        "Les fichiers relus couplent l'axe {axis} avec un autre axe ({parameter}), ceux du plan"
        " non. Une table sur un seul de deux axes couplés vrille la machine. Contrôler ce paramètre"
        " sur la commande. S'il est juste, l'indiquer dans le dossier de travail (`gantry`), et"
        " relancer celui-ci avec ces fichiers."
    ),
    "CW-S088.changed": (
        "Un paramètre qui couple l'axe {axis} avec un autre axe vaut {parameter} dans les fichiers"
        " relus, et {was} dans ceux du plan. Une table sur un seul de deux axes couplés vrille la"
        " machine. Contrôler ce paramètre sur la commande. S'il est juste, indiquer le couplage"
        " dans le dossier de travail (`gantry`), et relancer celui-ci avec ces fichiers."
    ),
}
