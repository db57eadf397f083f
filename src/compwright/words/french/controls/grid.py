"""French texts for the controls of `formats.families.grid`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Keep a copy of the INI file and of each compensation file that it names.": (
        "Garder une copie du fichier INI et de chaque fichier de compensation qu'il nomme."
    ),
    "Put the table in place": "Mettre la table en place",
    "Copy {file_1} into the folder of the INI file. It holds {points} rows from {start} to"
    " {end} {unit}. Do not add a comment, a header or a blank line: LinuxCNC would stop"
    " reading there without an error.": (
        "Copier {file_1} dans le dossier du fichier INI. Il contient {points} lignes de {start}"
        " à {end} {unit}. N'ajouter ni commentaire, ni en-tête, ni ligne vide : LinuxCNC y"
        " arrêterait la lecture sans erreur."
    ),
    "Set the keys": "Régler les clés",
    "Put the three lines of {file_2} into the section [JOINT_{address}] of the INI file,"
    " replacing lines of the same name. BACKLASH becomes 0: the table contains the reversal,"
    " and the control ignores it where there is a table.": (
        "Mettre les trois lignes de {file_2} dans la section [JOINT_{address}] du fichier INI,"
        " à la place des lignes de même nom. BACKLASH devient 0 : la table contient"
        " l'inversion, et la commande l'ignorerait à côté d'une table."
    ),
    "Restart LinuxCNC: a table is read once at the start. Look for the messages 'too many"
    " compensation entries' and 'compensation values must increase'.": (
        "Redémarrer LinuxCNC : une table est lue une fois au démarrage. Chercher les messages"
        " 'too many compensation entries' et 'compensation values must increase'."
    ),
    "Home the same way": "Référencer de la même façon",
    "Home the axis as it was homed for the measurement. Before the first motion after homing"
    " nothing is corrected.": (
        "Référencer l'axe comme pour la mesure. Avant le premier mouvement après la prise de"
        " référence, rien n'est corrigé."
    ),
    "Drive to the check positions (their table stands with the axis) and read the HAL pin"
    " joint.{address}.backlash-filt in machine units: it shows what the control must add"
    " there.": (
        "Aller aux positions de contrôle (leur tableau est avec l'axe) et lire la broche HAL"
        " joint.{address}.backlash-filt en unités de la machine : elle montre ce que la"
        " commande doit y ajouter."
    ),
    "Copy the INI file and the compensation files that it names from the control again and"
    " compare them with the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`.": (
        "Copier de nouveau depuis la commande le fichier INI et les fichiers de compensation"
        " qu'il nomme, et les comparer au plan : `compwright compare JOB_FOLDER --loaded"
        " READ_BACK`."
    ),
    "Put the saved INI file back, with each compensation file that it names; restart LinuxCNC and"
    " home.": (
        "Remettre le fichier INI sauvegardé, avec chaque fichier de compensation qu'il nomme ;"
        " redémarrer LinuxCNC et référencer."
    ),
    "Axis {name} is programmed in diameter: laser, table and every position on this card"
    " count in radius, as the joint moves; the control looks its table up there, whatever G7"
    " and G8 say. In G7 program twice the position": (
        "Axe {name} programmé au diamètre : laser, table et chaque position de cette fiche"
        " comptent au rayon, comme l'articulation se déplace ; la commande y consulte sa table,"
        " quoi que disent G7 et G8. En G7, programmer le double de la position"
    ),
    "with the kinematics matrixkins (LinuxCNC 2.10) add {squareness} to the value of"
    " matrixkins.C_{output}{input} that is in force{shift}; without it this control has no"
    " place for it": (
        "avec la cinématique matrixkins (LinuxCNC 2.10), ajouter {squareness} à la valeur de"
        " matrixkins.C_{output}{input} en vigueur{shift} ; sans elle, cette commande n'a pas de"
        " place pour cela"
    ),
    "BACKLASH of [JOINT_{address}] = {backlash} {backlash_unit}": (
        "BACKLASH de [JOINT_{address}] = {backlash} {backlash_unit}"
    ),
    "The HAL pin joint.{address}.backlash-filt at the check positions of the card shows what"
    " the control adds there, without any measurement.": (
        "La broche HAL joint.{address}.backlash-filt, aux positions de contrôle de la fiche,"
        " montre ce que la commande y ajoute, sans aucune mesure."
    ),
    "COMP_FILE of [JOINT_{address}] is read once, at the start, relative to the folder of"
    " the INI file: restart after every change.": (
        "COMP_FILE de [JOINT_{address}] est lu une fois, au démarrage, par rapport au dossier"
        " du fichier INI : redémarrer après chaque changement."
    ),
    "Reading stops without a message at the first line that is not three numbers (a comment,"
    " a header, a comma): then the table is empty, and BACKLASH is active in its place.": (
        "La lecture s'arrête sans message à la première ligne qui n'est pas trois nombres (un"
        " commentaire, un en-tête, une virgule) : la table est alors vide, et BACKLASH agit à"
        " sa place."
    ),
    "Before the first motion after homing nothing is added.": (
        "Avant le premier mouvement après la prise de référence, rien n'est ajouté."
    ),
    "COMP_FILE_TYPE of [JOINT_{address}]: 1 takes the columns as corrections, which are"
    " added; 0, also where the key is missing, as actual positions. Were errors written as"
    " corrections?": (
        "COMP_FILE_TYPE de [JOINT_{address}] : 1 prend les colonnes comme corrections, qui sont"
        " ajoutées ; 0, aussi quand la clé manque, comme positions réelles. Des erreurs"
        " ont-elles été écrites comme corrections ?"
    ),
    "Numbers of the table count in machine units, LINEAR_UNITS of [TRAJ]: inch taken for mm"
    " is 25.4.": (
        "Les nombres de la table comptent en unités de la machine, LINEAR_UNITS de [TRAJ] :"
        " pouces pris pour mm, c'est 25.4."
    ),
    "The first column of the table: nominal positions of the joint, ascending.": (
        "La première colonne de la table : positions nominales de l'articulation, croissantes."
    ),
    "Was the axis homed as for the measurement? Another kind of homing, or another"
    " HOME_OFFSET, moves the table.": (
        "L'axe a-t-il été référencé comme pour la mesure ? Une autre prise de référence, ou un"
        " autre HOME_OFFSET, déplace la table."
    ),
    "The signs of the first column: a table that was turned over does not ascend, and rows"
    " that do not ascend are dropped.": (
        "Les signes de la première colonne : une table retournée ne croît pas, et les lignes"
        " qui ne croissent pas sont omises."
    ),
    "The table belongs into the section [JOINT_{address}]: joints are counted from 0 in the"
    " order of the kinematics, so on a lathe with X and Z the Z is joint 1.": (
        "La table va dans la section [JOINT_{address}] : les articulations se comptent à partir"
        " de 0 dans l'ordre de la cinématique, donc sur un tour avec X et Z, Z est"
        " l'articulation 1."
    ),
    "The second column is active while the joint moves in +, the third one while it moves in -.": (
        "La deuxième colonne agit pendant le mouvement en +, la troisième pendant le mouvement"
        " en -."
    ),
    "BACKLASH of [JOINT_{address}] is ignored as soon as the table has one row; without rows,"
    " half of it is active in each direction.": (
        "BACKLASH de [JOINT_{address}] est ignoré dès que la table a une ligne ; sans lignes il"
        " agit pour moitié dans chaque sens."
    ),
    "At most 256 rows are taken; a row that does not ascend is dropped, and reading stops at"
    " the first line that is not three numbers: look for the messages at the start.": (
        "Au plus 256 lignes sont prises ; une ligne qui ne croît pas est omise, et la lecture"
        " s'arrête à la première ligne qui n'est pas trois nombres : chercher les messages au"
        " démarrage."
    ),
    "Below the first and above the last row their values stay.": (
        "Au-dessous de la première et au-dessus de la dernière ligne, leurs valeurs restent."
    ),
    "{label}: zero of the correction": "{label} : zéro de la correction",
    "{position} {unit}, approached in {direction}": "{position} {unit}, approché en {direction}",
    "the axis homes on a switch (HOME_OFFSET, HOME_LATCH_VEL): what the table holds there"
    " counts as zero": (
        "l'axe se référence sur un contact (HOME_OFFSET, HOME_LATCH_VEL) : ce que la table y"
        " contient compte comme zéro"
    ),
    "{label}: table": "{label} : table",
    "no file that was given contains one": "aucun fichier donné n'en contient",
    "where its turn begins (MD30340)": "où son tour commence (MD30340)",
    "{value} deg": "{value}°",
    "the control has reserved none yet": "la commande n'en a pas encore réservé",
    "that the control wraps it (MD30310)": "que la commande le fait tourner sans fin (MD30310)",
    "yes": "oui",
    "the control's files do not say it": "les fichiers de la commande ne le disent pas",
    "axis {name}: {fact}": "axe {name} : {fact}",
    "in no file": "dans aucun fichier",
    "axis {name}: number of points the control can store": (
        "axe {name} : nombre de points que la commande peut contenir"
    ),
    "as many as are needed; the card says how many to set": (
        "autant que nécessaire ; la fiche dit combien en régler"
    ),
    "LinuxCNC, screw compensation table (COMP_FILE) per joint": (
        "LinuxCNC, table de compensation de vis (COMP_FILE) par articulation"
    ),
    "L3: 0 is the control's own default": "L3 : 0 est la valeur par défaut de la commande",
    "L3: LINEAR is the control's own default": (
        "L3 : LINEAR est la valeur par défaut de la commande"
    ),
    "joints are numbered in the order of the kinematics; of a letter alone only that of X is"
    " taken, and only where no file says it": (
        "les articulations sont numérotées dans l'ordre de la cinématique ; d'une lettre seule,"
        " seule celle de X est retenue, et seulement si aucun fichier ne l'indique"
    ),
    "MD30200: there is one": "MD30200 : il y en a un",
    "the only one in the files": "le seul dans les fichiers",
    "the only one that is switched on (MD32700)": "le seul en service (MD32700)",
    "the only one that contains a table": "le seul qui contient une table",
    "the only one with points reserved (MD38000)": "le seul avec des points réservés (MD38000)",
    "the only one with a backlash value": "le seul avec une valeur de jeu",
    "the one that contains a table": "celui qui contient une table",
    "axis {name}: measuring system": "axe {name} : système de mesure",
}
