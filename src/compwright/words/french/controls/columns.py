"""French texts for the controls of `formats.families.columns`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save all machine parameters and every .COM and .CMA file of the control. Write down"
    " MP710.{bit}, MP720.{bit}, MP730 and which .CMA line is active.": (
        "Sauvegarder tous les paramètres machine et chaque fichier .COM et .CMA de la commande."
        " Noter MP710.{bit}, MP720.{bit}, MP730 et la ligne active du .CMA."
    ),
    "Enter the table": "Entrer la table",
    "Axis {address}: {table}. {load} Typed in: datum at the first point, column"
    " {number}=F(). The values are {table_values}s. Leave the columns of other axes alone."
    " Whether the first value has to be 0 is not known.": (
        "Axe {address} : {table}. {load} Saisie : origine au premier point, colonne"
        " {number}=F(). Les valeurs signifient {table_values} (option table_values). Ne pas"
        " toucher aux colonnes des autres axes. On ne sait pas si la première valeur doit être"
        " 0."
    ),
    "Reach beyond the travel": "Dépasser la course",
    "What the control does outside the table is unknown: the table should reach one spacing"
    " beyond the travel of {name} on each side, with real values at both ends (job: table"
    " start and end).": (
        "On ne sait pas ce qui agit hors de la table : elle devrait dépasser la course de"
        " {name} d'un pas de chaque côté, avec de vraies valeurs aux deux bouts (dossier de"
        " travail : début et fin de la table)."
    ),
    "Activate the line": "Activer la ligne",
    "Where a table is used: the active line of the .CMA must name the .COM file in the"
    " column of axis {address} (soft key or PLC module 9095). All axes share one active"
    " line: change only this cell.": (
        "Là où une table est utilisée : la ligne active du .CMA doit nommer le fichier .COM"
        " dans la colonne de l'axe {address} (softkey ou module PLC 9095). Tous les axes se"
        " partagent une ligne active : ne changer que cette cellule."
    ),
    "Set the parameters": "Régler les paramètres",
    "MP710.{bit} = {backlash} {backlash_unit}, MP720.{bit} = {linear} mm/m, MP730 bit {bit}"
    " = {nonlinear} (leave the other bits as they are). With the bit at 1 and no active .CMA"
    " line, old tables of the machine's builder may come alive.": (
        "MP710.{bit} = {backlash} {backlash_unit}, MP720.{bit} = {linear} mm/m, MP730 bit {bit}"
        " = {nonlinear} (laisser les autres bits tels quels). Avec le bit à 1 et sans ligne"
        " active du .CMA, d'anciennes tables du constructeur de la machine peuvent devenir"
        " actives."
    ),
    "Switch the control off and on. {referencing} Nominal values may jump slightly when a"
    " line is selected.": (
        "Éteindre et rallumer la commande. {referencing} Les valeurs de consigne peuvent sauter"
        " légèrement quand une ligne est choisie."
    ),
    "The sign of a table is not confirmed; that of MP720 is. Before the full test measure two"
    " of the check positions (listed with the axis on the card) once as the control is now,"
    " and once without compensation (table: MP730 bit {bit} and MP720.{bit} = 0; line:"
    " MP720.{bit} = 0; MP710.{bit} = 0): the compensation must add what is listed there. If a"
    " table does the opposite, set the option table_values to the other choice and run again.": (
        "Le signe d'une table n'est pas confirmé ; celui de MP720 l'est. Avant l'essai complet,"
        " mesurer deux des positions de contrôle (leur tableau est avec l'axe) telles que"
        " maintenant, et encore une fois sans compensation (table : MP730 bit {bit} et"
        " MP720.{bit} = 0 ; droite : MP720.{bit} = 0 ; MP710.{bit} = 0) : la compensation doit"
        " ajouter ce qui y est indiqué. Si une table fait le contraire, mettre l'option"
        " table_values à l'autre choix et recommencer le calcul."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive MP710 moves on in the direction of"
    " the new motion.": (
        "Mettre à zéro un comparateur en arrivant en {reference_return}, puis revenir de"
        " l'autre côté : la différence qui reste doit être petite. Une valeur MP710 positive"
        " avance dans le sens du nouveau mouvement."
    ),
    "Save the .COM and .CMA files and the list of machine parameters again and compare them with"
    " the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`. What was typed in from a"
    " sheet: write the values on the display into a copy of the sheet.": (
        "Sauvegarder de nouveau les fichiers .COM et .CMA et la liste des paramètres machine, et"
        " les comparer au plan : `compwright compare JOB_FOLDER --loaded READ_BACK`. Ce qui a été"
        " saisi d'après une feuille : écrire les valeurs de l'affichage dans une copie de la"
        " feuille."
    ),
    "Load the saved .COM and .CMA files and set MP710.{bit}, MP720.{bit} and the bit of"
    " MP730 as written down.": (
        "Charger les fichiers .COM et .CMA sauvegardés et régler MP710.{bit}, MP720.{bit} et le"
        " bit de MP730 comme notés."
    ),
    "MP710.{bit} = {backlash} {backlash_unit}": "MP710.{bit} = {backlash} {backlash_unit}",
    "Make a backup of the control with its configuration data and every .COM and .CMA file."
    " Write down backLash and linearCompValue of axis {address} and which line of config.cma"
    " is active.": (
        "Faire une sauvegarde de la commande avec ses données de configuration et chaque"
        " fichier .COM et .CMA. Noter backLash et linearCompValue de l'axe {address} et la"
        " ligne active de config.cma."
    ),
    "Axis {address}: {table}. {load} Typed in: AXISPOS and column {address}. The values are"
    " {table_values}s. Leave the columns of other axes alone.": (
        "Axe {address} : {table}. {load} Saisie : AXISPOS et colonne {address}. Les valeurs"
        " signifient {table_values} (option table_values). Ne pas toucher aux colonnes des"
        " autres axes."
    ),
    "What the control does outside the table is unknown: the table should reach one spacing"
    " beyond the travel of {name} on each side (job: table start and end).": (
        "On ne sait pas ce qui agit hors de la table : elle devrait dépasser la course de"
        " {name} d'un pas de chaque côté (dossier de travail : début et fin de la table)."
    ),
    "In config.cma exactly one line has * in ACTIVE: its column {address} must name the .COM"
    " file. All axes share this line: change only this cell.": (
        "Dans config.cma, une seule ligne a * dans ACTIVE : sa colonne {address} doit nommer le"
        " fichier .COM. Tous les axes se partagent cette ligne : ne changer que cette cellule."
    ),
    "CfgAxisComp of axis {address}: backLash (401802) = {backlash} {backlash_unit},"
    " linearCompValue = {linear} mm/m; choose the nonlinear compensation.": (
        "CfgAxisComp de l'axe {address} : backLash (401802) = {backlash} {backlash_unit},"
        " linearCompValue = {linear} mm/m ; choisir la compensation non linéaire."
    ),
    "Restart the control. {referencing} The table is active in open loop too and is taken"
    " over when the loop closes.": (
        "Redémarrer la commande. {referencing} La table agit aussi en boucle ouverte et est"
        " reprise quand la boucle se ferme."
    ),
    "The sign of the table is not confirmed. Before the full test measure two of the check"
    " positions (listed with the axis on the card) once as the control is now, and once"
    " without compensation (no * in ACTIVE, backLash 0): the compensation must add what is"
    " listed there. If it is the opposite, set the option table_values to the other choice"
    " and run again.": (
        "Le signe de la table n'est pas confirmé. Avant l'essai complet, mesurer deux des"
        " positions de contrôle (leur tableau est avec l'axe) telles que maintenant, et encore"
        " une fois sans compensation (pas de * dans ACTIVE, backLash 0) : la compensation doit"
        " ajouter ce qui y est indiqué. Si c'est l'inverse, mettre l'option table_values à"
        " l'autre choix et recommencer le calcul."
    ),
    "Zero a dial gauge arriving in {reference_return}, then come back from the other side:"
    " the remaining difference must be small. A positive backLash moves on in the direction"
    " of the new motion. The control adds it also where only the table makes the axis turn"
    " back.": (
        "Mettre à zéro un comparateur en arrivant en {reference_return}, puis revenir de"
        " l'autre côté : la différence qui reste doit être petite. Une valeur backLash positive"
        " avance dans le sens du nouveau mouvement. La commande l'ajoute aussi là où seule la"
        " table fait revenir l'axe."
    ),
    "Save the .COM and .CMA files again and compare them with the plan: `compwright compare"
    " JOB_FOLDER --loaded READ_BACK`. What was typed in from a sheet: write the values on the"
    " display into a copy of the sheet.": (
        "Sauvegarder de nouveau les fichiers .COM et .CMA, et les comparer au plan : `compwright"
        " compare JOB_FOLDER --loaded READ_BACK`. Ce qui a été saisi d'après une feuille : écrire"
        " les valeurs de l'affichage dans une copie de la feuille."
    ),
    "Load the saved .COM and .CMA files and set backLash and linearCompValue of axis"
    " {address} as written down.": (
        "Charger les fichiers .COM et .CMA sauvegardés et régler backLash et linearCompValue de"
        " l'axe {address} comme notés."
    ),
    "CfgAxisComp of axis {address}: backLash (401802) = {backlash} {backlash_unit}": (
        "CfgAxisComp de l'axe {address} : backLash (401802) = {backlash} {backlash_unit}"
    ),
    "The sign is unconfirmed: check it with a square or a dial gauge, on and off, before"
    " production.": (
        "Le signe n'est pas confirmé : le vérifier avant la production avec une équerre ou un"
        " comparateur, avec et sans."
    ),
    "{file}, column {column}": "{file}, colonne {column}",
    "{error} is in {where}, added to what was there: {values} (values are {form}s). Load"
    " that file; no other column of it changes. {selected}{check}": (
        "{error} est dans {where}, ajouté à ce qui y était : {values} (les valeurs signifient"
        " {form}). Charger ce fichier ; aucune autre colonne n'y change. {selected}{check}"
    ),
    "the table (.COM) of {input}, column of {output}": (
        "la table (.COM) de {input}, colonne de {output}"
    ),
    "the table (.COM) that the active line of the .CMA names for the motion of {input} (a"
    " new one, where it names none), column of {output}": (
        "la table (.COM) que la ligne active de la .CMA nomme pour le déplacement de"
        " {input} (une nouvelle, si elle n'en nomme pas), colonne de {output}"
    ),
    "{output} over {input}: {where}": "{output} sur {input} : {where}",
    "{value} {unit} at {position}": "{value} {unit} à {position}",
    "(see the axis list of the machine)": "(voir la liste des axes de la machine)",
    "no table": "pas de table",
    ", every {spacing} {unit}": ", tous les {spacing} {unit}",
    "{points} points from {start} to {end} {unit}{every}": (
        "{points} points de {start} à {end} {unit}{every}"
    ),
    "Type the sheet {file} into the .COM file that the active line of the .CMA names for the"
    " motion of axis {address}; where it names none, into a new one. Never into one that it"
    " names for another axis.": (
        "Saisir la feuille {file} dans le fichier .COM que la ligne active du .CMA nomme pour"
        " le mouvement de l'axe {address} ; si elle n'en nomme pas, dans un nouveau. Jamais"
        " dans un fichier qu'elle nomme pour un autre axe."
    ),
    " {file} holds the parameters that are in no file of yours.": (
        " {file} contient les paramètres qui ne sont dans aucun de vos fichiers."
    ),
    "Load your own .COM file of tables/: it holds the table.{rest}": (
        "Charger votre propre fichier .COM de tables/ : il contient la table.{rest}"
    ),
    "Read back what is in the control and compare it with the plan (`compwright compare"
    " JOB_FOLDER --loaded READ_BACK`): it shows value by value what this test cannot tell.": (
        "Relire ce qui est dans la commande et le comparer avec le plan (`compwright compare"
        " JOB_FOLDER --loaded READ_BACK`) : cela montre valeur par valeur ce que cet essai ne"
        " peut pas dire."
    ),
    "The bit of axis {address} in MP730 must be 1, and the active line of the .CMA must name"
    " its .COM: until then no table is active.": (
        "Le bit de l'axe {address} dans MP730 doit être 1, et la ligne active du .CMA doit"
        " nommer son .COM : rien n'agit avant que les deux soient ainsi."
    ),
    "With the bit at 1 and no .CMA, old tables of the machine's builder (code 105296) act in"
    " their place.": (
        "Avec le bit à 1 et sans .CMA, d'anciennes tables du constructeur de la machine (code"
        " 105296) agissent à leur place."
    ),
    "The axis must have passed its reference marks.": (
        "L'axe doit avoir passé ses marques de référence."
    ),
    "No manual states the sign of a table's values: compare two positions with the bit of"
    " MP730 at 1 and at 0; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Aucun manuel n'indique le signe des valeurs d'une table : comparer deux positions avec"
        " le bit de MP730 à 1 et à 0 ; si la distance change à l'envers, recommencer le calcul"
        " avec l'autre table_values."
    ),
    "Where the axis is corrected by MP720 alone: positive means that the table travels too far.": (
        "Là où l'axe n'est corrigé que par MP720 : positif signifie que la table de la machine"
        " va trop loin."
    ),
    "The .COM counts in mm or in inch, and MP720 in mm/m.": (
        "Le .COM compte en mm ou en pouces, et MP720 en mm/m."
    ),
    "With the bit of MP730 at 1 MP720 has no effect; a column for this axis in another axis'"
    " .COM is active in addition to its own table.": (
        "Avec le bit de MP730 à 1, MP720 est sans effet ; une colonne pour cet axe dans le .COM"
        " d'un autre axe agit en plus de la sienne."
    ),
    "DATUM and spacing of the .COM: point k stands at DATUM + k times the spacing, from the"
    " machine datum.": (
        "DATUM et pas du .COM : le point k est à DATUM + k fois le pas, à partir du zéro machine."
    ),
    "The points run in + from the DATUM: were they entered from the other end?": (
        "Les points vont en + à partir de DATUM : ont-ils été entrés à partir de l'autre bout ?"
    ),
    "The column of the .CMA names the axis that moves, the column n=F() inside the .COM the"
    " axis that is corrected: both must be {address}.": (
        "La colonne du .CMA nomme l'axe qui se déplace, la colonne n=F() dans le .COM l'axe qui"
        " est corrigé : les deux doivent être {address}."
    ),
    "A table has no direction here: what is active in one direction only is MP710 (or MP750"
    " within the position loop).": (
        "Une table n'a pas de sens ici : ce qui n'agit que dans un sens est MP710 (ou MP750"
        " dans la boucle de position)."
    ),
    "MP710 of axis {address}, fed in at every reversal: positive where the encoder runs"
    " ahead of the table.": (
        "MP710 de l'axe {address}, appliqué à chaque inversion : positif là où le codeur est en"
        " avance sur la table de la machine."
    ),
    "Are all rows filled, from one spacing below the travel to one above? What the control"
    " does outside the table is unknown.": (
        "Toutes les lignes sont-elles remplies, d'un pas au-dessous de la course à un pas"
        " au-dessus ? On ne sait pas ce qui agit hors de la table."
    ),
    "At most 256 points in one .COM: a longer one is refused when the line is selected"
    " (module 9095).": (
        "Au plus 256 points dans un .COM : un plus long est refusé quand la ligne est choisie"
        " (module 9095)."
    ),
    "config.cma: one line has * in ACTIVE, and its column {address} must name the .COM file.": (
        "config.cma : une ligne a * dans ACTIVE, et sa colonne {address} doit nommer le fichier"
        " .COM."
    ),
    "CfgAxisComp of axis {address}: the nonlinear compensation must be chosen.": (
        "CfgAxisComp de l'axe {address} : la compensation non linéaire doit être choisie."
    ),
    "The table is taken over when the position loop closes; before the reference marks it"
    " has no positions.": (
        "La table est reprise quand la boucle de position se ferme ; avant les marques de"
        " référence elle n'a pas de positions."
    ),
    "No manual states the sign of a table's values: compare two positions with and without"
    " the * in ACTIVE; if the distance changes the wrong way, run again with the other"
    " table_values.": (
        "Aucun manuel n'indique le signe des valeurs d'une table : comparer deux positions avec"
        " et sans le * dans ACTIVE ; si la distance change à l'envers, recommencer le calcul"
        " avec l'autre table_values."
    ),
    "The .COM counts in mm or in inch, as its first line says.": (
        "Le .COM compte en mm ou en pouces, comme le dit sa première ligne."
    ),
    "linearCompValue of CfgAxisComp must be 0: otherwise it may be active in addition to the"
    " table.": ("linearCompValue de CfgAxisComp à côté de la table : 0, sinon il peut agir aussi."),
    "The column AXISPOS: positions from the machine datum (MP_refPosition).": (
        "La colonne AXISPOS : positions à partir du zéro machine (MP_refPosition)."
    ),
    "AXISPOS must ascend, with the value of each position next to it: were the points entered"
    " from the other end?": (
        "AXISPOS doit croître, avec la valeur de chaque position à côté : les points ont-ils"
        " été entrés à partir de l'autre bout ?"
    ),
    "The column of config.cma names the axis that moves, the column inside the .COM the axis"
    " that is corrected: both must be {address}.": (
        "La colonne de config.cma nomme l'axe qui se déplace, la colonne dans le .COM l'axe qui"
        " est corrigé : les deux doivent être {address}."
    ),
    "The column BACKLASH holds the values for travel in -, the column {address} those for"
    " travel in +.": (
        "La colonne BACKLASH contient les valeurs pour la course en -, la colonne {address}"
        " celles pour la course en +."
    ),
    "backLash (401802) of axis {address}: positive where the encoder runs ahead, also at a"
    " reversal that only the table causes.": (
        "backLash (401802) de l'axe {address} : positif là où le codeur est en avance, aussi à"
        " une inversion que seule la table cause."
    ),
    "Where the column BACKLASH holds the reversal, backLash must not hold it again.": (
        "Là où la colonne BACKLASH contient l'inversion, backLash ne doit pas la contenir encore."
    ),
    "At most 256 points.": "Au plus 256 points.",
    "axis {address}": "axe {address}",
    "axis {address}, measuring system {system}": "axe {address}, système de mesure {system}",
    "axis {name}: curve for travel in -": "axe {name} : courbe pour la course en -",
    "none: no table of the axis with a column BACKLASH was given": (
        "aucune : pas de table de l'axe avec une colonne BACKLASH"
    ),
    "axis {name}: outside the table": "axe {name} : hors de la table",
    "the end values hold; let the table reach one spacing beyond the travel on each side": (
        "les valeurs d'extrémité restent ; faire dépasser la table d'un pas de chaque côté de"
        " la course"
    ),
    "an entry sheet has no place for it": "une feuille de saisie n'a pas de place pour cela",
    "option or its default": "option ou sa valeur par défaut",
    "HEIDENHAIN iTNC 530 (TNC 407 to 430 with .COM tables), axis error compensation with"
    " backlash (MP710, MP720, MP730)": (
        "HEIDENHAIN iTNC 530 (TNC 407 à 430 avec tableaux .COM), compensation des défauts d'axe"
        " avec jeu à l'inversion (MP710, MP720, MP730)"
    ),
    "HEIDENHAIN NCK controls (MANUALplus 620; TNC 320, 620, 640), axis error compensation"
    " with backlash (CfgAxisComp)": (
        "Commandes HEIDENHAIN NCK (MANUALplus 620 ; TNC 320, 620, 640), compensation des"
        " défauts d'axe avec jeu à l'inversion (CfgAxisComp)"
    ),
    "H2 draws the error": "H2 dessine l'erreur",
    "H6 speaks of compensation values; the older controls draw the error": (
        "H6 parle de valeurs de compensation ; les commandes plus anciennes dessinent l'erreur"
    ),
    "no manual says what the control does outside the table; straight lines between the"
    " points: H8": (
        "aucun manuel ne dit ce que fait la commande hors de la table ; droites entre les"
        " points : H8"
    ),
    "no manual says what the control does outside the table; straight lines between the"
    " points: inferred from the older controls": (
        "aucun manuel ne dit ce que fait la commande hors de la table ; droites entre les"
        " points : déduit des commandes plus anciennes"
    ),
    "free": "libre (free)",
    "table": "table (table)",
    "second_curve": "seconde courbe (second_curve)",
    "nothing is added arriving in {direction}": (
        "rien n'est ajouté à l'approche dans le sens {direction}"
    ),
    "0: no table is active on it": "0 : aucune table n'agit sur l'axe",
    "no file contains a table of the axis": "aucun fichier ne contient de table de l'axe",
    "1: its table of zeros is active": "1 : sa table de zéros agit",
    "1: its table is active": "1 : sa table agit",
    "0: its table is not active": "0 : sa table n'agit pas",
    "a sheet is what was typed in": "une feuille est ce qui a été saisi",
    "zeros correct nothing": "des zéros ne corrigent rien",
    "1: {parameter} is not active": "1 : {parameter} n'agit pas",
    "0: {parameter} is active": "0 : {parameter} agit",
    "in no file; {evidence}": "dans aucun fichier ; {evidence}",
    "{label}: its table": "{label} : sa table",
    "active": "active",
    "{switch} is not in the files: a table that was given counts": (
        "{switch} n'est pas dans les fichiers : une table fournie compte"
    ),
    "{file}: moving axis": "{file} : axe en mouvement",
    "inferred from its name: no table of assignments (.CMA) was given": (
        "déduit de son nom : aucune table d'affectation (.CMA) n'a été donnée"
    ),
    "outside the tables": "hors des tables",
    "the end values hold": "les valeurs des extrémités restent",
    "inferred from the name of the axis": "déduit du nom de l'axe",
}
