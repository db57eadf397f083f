"""What is noticed about a control's files, in them and between two sets of them."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-F011.feed": (
        "à {feed:g} {unit}/min ({of:choose|option=option max_feed|rapid=rapide 1420}), la commande"
        " demande au moins {least:g} : avance / {rule} ({evidence})"
    ),
    "CW-S001": (
        "{file} : la dernière ligne n'a pas de fin de ligne ; vérifier que le fichier est complet"
    ),
    "CW-S002": "{file} : pas de {mark} à la fin ; vérifier que le fichier est complet",
    "CW-S003": (
        "{label} : {quantity} est donné plusieurs fois ; la"
        " {rule:choose|first=première|last=dernière|={rule}} valeur compte : {value} ({where})"
    ),
    "CW-S004.not_zero": (
        "{label} : {values} valeurs après la fin de la table (de {first} à {last}) ne sont pas"
        " utilisées par la commande, {not_zero} d'entre elles ne sont pas nulles : une table plus"
        " ancienne et plus longue, à moins que sa fin ou son intervalle soit faux"
    ),
    "CW-S004.zero": (
        "{label} : {values} valeurs après la fin de la table sont nulles et non utilisées"
    ),
    "CW-S005": (
        "{label} : {quantity} n'est pas dans les fichiers ; compté comme {value}. Si la commande a"
        " une autre valeur, elle était active dans les essais, et ce qui est écrit ou montré est"
        " faux de la différence : la chercher à la commande, ou ajouter le fichier qui la donne"
    ),
    "CW-S006": (
        "axe {axis} : plusieurs systèmes de mesure ont une table ; le système {system} est montré"
    ),
    "CW-S007": "{label} : {switch} ; elle ne corrige rien",
    "CW-S008": "{label} : aucun fichier ne contient de table ; compté comme aucune",
    "CW-S009": (
        "{label} : {what} est ignoré par la commande : il {why:choose|table=a une table|rotary=est"
        " un axe rotatif}"
    ),
    "CW-S010": (
        "l'axe {axis} est pris comme {address} de la commande : le vérifier, ou donner son adresse"
    ),
    "CW-S011": (
        "{label} ({input} sur {output}) n'est pas touché : {why} ; {active:if|actif sur {output}"
        " selon {input}, avant comme après|désactivé}"
    ),
    "CW-S012.assignments": "{file} n'est pas nommé par la ligne d'affectation active : non actif",
    "CW-S012.no_axis": "{file} n'est nommé par aucun axe : la commande ne le charge pas",
    "CW-S012.no_table": (
        "{files}{more:if| et {more} autres} : pas de table, et nommé par aucun axe : la commande ne"
        " le charge pas comme tel"
    ),
    "CW-S012.not_given": (
        "{file}, actif pour le mouvement de {axis}, n'a pas été donné : ce qu'il fait aux autres"
        " axes n'est pas connu"
    ),
    "CW-S012.start_up_list": (
        "{file} n'est pas nommé par la liste de démarrage : la commande ne le charge pas"
    ),
    "CW-S013": (
        "{file}, ligne {line} : lue, bien qu'aucun manuel ne montre cette forme ({lines} lignes)"
    ),
    "CW-S014": (
        "les axes {addresses:and} partagent les numéros de points {first} à {last} : un changement"
        " pour l'un changerait l'autre, donc une nouvelle table reçoit ses propres numéros"
    ),
    "CW-S015": (
        "{label} : avance et rapide ont des valeurs de jeu différentes ({feed} et {rapid} ; {why})"
        " : est montrée ici {rapid_shown:if|celle du rapide, 1852|celle de l'avance, 1851} ; une"
        " nouvelle table change les deux de même, leur différence reste"
    ),
    "CW-S016": (
        "{label} : le point {first} devrait avoir la même valeur que le point {last} ({value:g})"
    ),
    "CW-S017": (
        "axe {axis} : la table de {file} finit son tour avec une autre valeur qu'elle ne l'a"
        " commencé"
    ),
    "CW-S018": (
        "{label} : la position de référence n'est pas le zéro machine (1240) ; les points sont"
        " comptés depuis la position {reference:g} (reference), ce qui n'est pas confirmé :"
        " vérifier la correction à deux positions"
    ),
    "CW-S019": (
        "{label} : programmation au diamètre (1006#3) : positions, intervalle et corrections sont"
        " pris au rayon (non confirmé) ; un facteur 2 est la faute habituelle, donc vérifier une"
        " position après chargement"
    ),
    "CW-S030": (
        "l'axe {partner} ne fait pas la même chose que {leading}, avec lequel il forme un portique"
    ),
    "CW-S031.gantry": (
        "les axes {axis} et {other} ont la même table : forment-ils un portique ? Nommer alors"
        " {other} dans le dossier de travail (gantry), pour que les deux reçoivent la nouvelle ;"
        " une table sur un seul met le pont de travers"
    ),
    "CW-S031.single": (
        "les axes {axis} et {other} ont la même table ; les fichiers de la commande disent que"
        " l'axe {axis} n'est dans aucun portique"
    ),
    "CW-S032": "{label} : valeurs et grille sont toutes nulles, ce qui veut dire aucune table",
    "CW-S033.ends": (
        "{label} est sans fin, mais sa table ne se répète pas : elle finit des deux côtés"
    ),
    "CW-S033.repeats": (
        "{label} : sa table se répète tous les {period:g}, mais le dossier de travail ne donne pas"
        " de modulo ; une nouvelle table aura des extrémités"
    ),
    "CW-S034": "{label} est désactivé dans les fichiers ({switches}) et ne corrige rien",
    "CW-S035": (
        "axe {axis} : le dossier de travail dit qu'il se déplace seul ; {parameter} peut le coupler"
        " à un autre axe. Laisser ce couplage désactivé dans chaque essai, et charger les tables"
        " des deux axes avant de le réutiliser"
    ),
    "CW-S036": (
        "L'axe {gantry} reçoit {table:choose|same=la même somme|change=le même changement de sa"
        " propre somme} que l'axe {axis}, comme le dit le dossier de travail. Les corrections des"
        " deux diffèrent ensuite de {after:.2f} {unit} au plus, {before:.2f} {unit} avant ; en"
        " aucune position de plus de {moved:.2f} {unit} autrement qu'avant"
    ),
    "CW-S037": (
        "axe {axis} : l'axe {follows} le suit comme entraînement, sans position propre"
        " ({parameter}) : la table de l'axe {axis} sert aux deux"
    ),
    "CW-S038": (
        "Les axes {axis} et {gantry} s'écartent de {moved:.2f} {unit} au plus (limite {limit:.2f}"
        " {unit}) ; l'axe {axis} gagne {gain:.2f} {unit}. Leurs grilles ne vont pas ensemble."
        " Donner aux deux axes la même grille dans la commande, ou dire table: same"
    ),
    "CW-S040": (
        "{label} : {bits} = 1 ({value}) : utilisé sur des machines réelles, sens non confirmé"
        " (peut-être compensation interpolée : donner alors l'option output: ramp) ; laissé tel"
        " quel"
    ),
    "CW-S041": (
        "{label} : {own} = {first} est {zero} + 1 sur un tour complet, là où le manuel a {own} ="
        " {zero} : les numéros {first} à {last} sont lus comme ses sections, et le numéro"
        " {reference} est gardé pour l'axe aussi"
    ),
    "CW-S042": (
        "l'axe {axis} est inhabituel et n'est pas touché, avec tous ses numéros de points :"
        " {reasons:join|; }"
    ),
    "CW-S043": "{label} : {systems} ; vérifier l'unité de détection",
    "CW-S044": (
        "{label} : la prise de référence va vers {files} d'après 1006#5, vers {job} dans le dossier"
        " de travail ; avec un jeu de données cela ne déplace que le zéro du jeu, donc le dossier"
        " de travail est suivi ; deux jeux sont refusés jusqu'à ce qu'ils s'accordent"
    ),
    "CW-S045": (
        "{label} : {outside:g} {unit} de la course sont hors de ses limites de {low:g} à {high:g}"
        " ({parameters}) : course et points visés sont-ils en coordonnées machine ?"
    ),
    "CW-S046": (
        "{file} : ses points ne sont pas équidistants (de {least:.10g} à {most:.10g}), ce que la"
        " commande demande ; lus tels quels, jamais écrits ainsi"
    ),
    "CW-S047": (
        "{label} : la compensation de jeu progressive divise 1851 en étapes ({parameters}) :"
        " laissée telle quelle, elle agit sur {reach:g} {unit} au plus après une inversion (non"
        " confirmé) ; un point visé plus proche, dans un essai ou une pièce, voit une autre valeur"
        " que 1851"
    ),
    "CW-S048": "{label} : {function}",
    "CW-S049.none": (
        "{suggested}. Le dossier de travail ne nomme pas de pas de vis, donc cette période est"
        " cherchée d'abord dans les mesures. Si elle est juste, ajouter screw_pitch: {lead:g} à"
        " l'axe"
    ),
    "CW-S049.other": (
        "{suggested} ; le dossier de travail nomme {periods:g} à la place, et il est suivi :"
        " vérifier à la vis"
    ),
    "CW-S049.suggested": (
        "{label} : les fichiers de la commande suggèrent une période de {lead:g} {unit}, un tour du"
        " moteur ({evidence})"
    ),
    "CW-S050.cec": (
        "{label} ({input} sur {output}) n'est pas touché : {why} ; {active:if|actif sur {output}"
        " selon {input}, avant comme après|désactivé}"
    ),
    "CW-S050.list": "{label} est laissé tel quel et n'est pas montré : {why}",
    "CW-S050.sum": (
        "les tables CEC {tables} sur {output} ne sont pas touchées : leur somme va de {low:g} à"
        " {high:g}, et MD32720 $MA_CEC_MAX_SUM la limite à {limit:g} ; elles sont actives, avant"
        " comme après"
    ),
    "CW-S051": (
        "les tables entre axes ({pairs}) sont laissées telles quelles et ne sont pas montrées : le"
        " signe des valeurs CEC est inconnu ; donner l'option cec_sign après la vérification de la"
        " fiche"
    ),
    "CW-S052": (
        "axe {axis} : le dossier de travail nomme le système de mesure {number}, mais les fichiers"
        " activent la compensation pour le système {other} (MD32700) : s'assurer que le système"
        " {number} est utilisé"
    ),
    "CW-S053": (
        "axe {axis} : en plus de sa table est actif : {functions:join|; }. Laissé tel quel, il"
        " compte comme actif de la même façon pendant l'essai et après"
    ),
    "CW-S054": (
        "les tables CEC {tables} ne sont pas touchées : toutes leurs valeurs sont 0, sur une grille"
        " illisible ; elles ne corrigent rien"
    ),
    "CW-S055": (
        "Les tables CEC sont montrées comme des corrections. D'après le manuel de Siemens"
        " (Fonctions d'extension 03/2009, page 372), une valeur positive déplace l'axe en −, donc"
        " l'inverse : donner l'option cec_sign après la vérification de la fiche"
    ),
    "CW-S056": (
        "axe {axis} : {period:if|sa table se répète tous les {period:g}, mais le dossier de travail"
        " ne donne pas de modulo ; une nouvelle table aura des extrémités|il est sans fin, mais sa"
        " table ne se répète pas : elle finit des deux côtés}"
    ),
    "CW-S057": (
        "{format} : aucune page ne dit ce que sont les paramètres {parameters} sur cette série"
        " ({place} ; d'autres séries y ont des unités, des chemins ou une autre compensation) : ils"
        " ne sont pas comptés, pas comparés au dossier de travail et laissés tels quels. Les"
        " chercher dans le manuel de la commande : ce qui y compense ne s'annule que tant que la"
        " grille reste"
    ),
    "CW-S060": (
        "Relu, non jugé indépendamment : seule votre propre définition de {definition} dit ce que"
        " font ses fichiers. Un signe ou une unité faux dans celle-ci est faux dans tout ceci. Le"
        " prouver sur la machine, à une position et des deux côtés, avant que toute la table soit"
        " active{expectation:if|. Les corrections calculées à la main sont celles de {expectation}"
        " : aucune n'a été calculée pour {definition}}"
    ),
    "CW-S061": (
        "{what} : {carried} est utilisé tel qu'il est dans le plan ; pour une autre définition,"
        " refaire le calcul"
    ),
    "CW-S062": "le format de commande {name} est pris pour {definition} : {title}",
    "CW-S070": (
        "{file} : des programmes y chargent ou commutent la compensation quand quelqu'un les lance"
        " : {programs} ; ils n'ont pas été exécutés ici, et ce sont les données de l'archive qui"
        " comptent"
    ),
    "CW-S071": (
        "{file} : ses virgules décimales sont lues comme des points ; la commande n'accepte pas un"
        " tel fichier : c'est un listage, et peut-être pas ce que contient la commande"
    ),
    "CW-S072": (
        "{file} : le contenu de l'archive n'est pas vérifié : rien dans son conteneur ne dit si une"
        " valeur a été changée après l'exportation. Avant de charger, comparer les trois valeurs"
        " par axe de la fiche avec la commande"
    ),
    "CW-S073": (
        "{file} : non exécuté dans la commande, d'après le dossier de travail (active: no). Aucune"
        " de ses tables et valeurs de jeu ne compte comme chargée"
    ),
    "CW-S080": (
        "{files} : ce que la commande fait de {what} est inconnu, donc seules les entrées sont"
        " comparées ({faults})"
    ),
    "CW-S081": "{files} : les corrections sont celles d'un seul lecteur ; le second dit : {why}",
    "CW-S082": "{files} : pas de données de la commande dans {idle}",
    "CW-S083.new": (
        "{new} valeurs qui compensent n'étaient dans aucun fichier du plan, et n'ont pas été"
        " regardées"
    ),
    "CW-S083.not_read": (
        "{missing} valeurs qui compensent n'ont pas été relues, et n'ont pas été regardées"
    ),
    "CW-S084": (
        "{files} : dans le dossier donné, aucune ligne n'est une instruction de {format} ; omis"
    ),
    "CW-S085": (
        "{path} est ce que run a écrit, pas ce qui a été relu : rien ici ne dit ce qui est dans la"
        " commande ; l'enregistrer depuis la commande et le donner"
    ),
    "CW-S086": (
        "Aucun fichier ne dit si {number:plural|l'axe {names} est linéaire ou rotatif|les axes"
        " {names} sont linéaires ou rotatifs}. L'unité des corrections est inconnue : millièmes de"
        " mm (µm) ou de degré (3,6″). Donner --option kind=linear ou --option kind=rotary."
    ),
}
