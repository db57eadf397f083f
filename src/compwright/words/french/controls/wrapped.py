"""French texts for the controls of `formats.families.wrapped`, keyed by the English texts."""

from __future__ import annotations

from typing import Final

TEXTS: Final[dict[str, str]] = {
    "Save the whole configuration of the card (all I-variables, the answers to LIST COMP"
    " DEF, LIST COMP, LIST BLCOMP DEF, LIST BLCOMP of every motor). Write down I51,"
    " I{address}85 and I{address}86.": (
        "Sauvegarder toute la configuration de la carte (toutes les variables I, les réponses à"
        " LIST COMP DEF, LIST COMP, LIST BLCOMP DEF, LIST BLCOMP de chaque moteur). Noter I51,"
        " I{address}85 et I{address}86."
    ),
    "Check the counts": "Vérifier les incréments",
    "Everything here is worked out with {counts} counts per {unit} of axis {name} (motor"
    " #{address}). Move the axis by a known way and compare the motor's own position (the"
    " command P with #{address} addressed shows it): that many counts per {unit}, rising in"
    " + (negative: falling in +). Motor zero must be {reference} {unit}. If not, load"
    " nothing: correct counts_per_unit or reference in the job and run again.": (
        "Tout est calculé ici avec {counts} incréments par {unit} de l'axe {name} (moteur"
        " #{address}). Déplacer l'axe d'une distance connue et comparer la position propre du"
        " moteur (la commande P avec #{address} adressé la montre) : autant d'incréments par"
        " {unit}, croissants en + (négatif : décroissants en +). Le zéro du moteur doit être à"
        " {reference} {unit}. Sinon, ne rien charger : corriger counts_per_unit ou reference"
        " dans le dossier de travail et recommencer le calcul."
    ),
    "Room for the tables": "De la place pour les tables",
    "Home all motors, then I51=0: no table is active from here on; I{address}86 still is."
    " Delete from the lowest motor number up, every motor that has one: DELETE BLCOMP and"
    " DELETE COMP with this motor addressed; and what exists of GATHER, TBUF, ROTARY,"
    " LOOKAHEAD and TCOMP. Anything left makes the card answer ERR003. Tables of other motors"
    " that the script below does not hold are gone then: define them again from the highest"
    " motor down, before the script where their number is higher.": (
        "Référencer tous les moteurs, puis I51=0 : à partir d'ici aucune table n'agit ;"
        " I{address}86 agit encore. Effacer à partir du plus petit numéro de moteur, pour"
        " chaque moteur qui en a : DELETE BLCOMP et DELETE COMP avec ce moteur adressé ; et ce"
        " qui existe de GATHER, TBUF, ROTARY, LOOKAHEAD et TCOMP. Ce qui reste fait répondre"
        " ERR003 à la carte. Les tables d'autres moteurs que le script ci-dessous ne contient"
        " pas sont alors perdues : les définir de nouveau à partir du plus grand numéro de"
        " moteur, avant le script si leur numéro est plus grand."
    ),
    "Load the script": "Charger le script",
    "Send from tables/, in this order: {file_1}. A line SAVE in them would keep what is not"
    " checked yet: leave it out until the sign was checked. Motor #{address}, {tables}:"
    " {points} entries, every {spacing} {unit}, length {length} counts. An error other than"
    " ERR003 may mean that the memory of the card is full: fewer points (a wider spacing)"
    " help.": (
        "Envoyer depuis tables/, dans cet ordre : {file_1}. Une ligne SAVE y garderait ce qui"
        " n'est pas encore vérifié : l'omettre jusqu'à ce que le signe soit vérifié. Moteur"
        " #{address}, {tables} : {points} entrées, tous les {spacing} {unit}, longueur {length}"
        " incréments. Une autre erreur que ERR003 peut signifier que la mémoire de la carte est"
        " pleine : moins de points (un pas plus grand) aident."
    ),
    "Backlash": "Jeu",
    "I{address}86 = {constant} (1/16 count: {backlash} {unit} at motor zero). I{address}85 ="
    " {rate} (1/16 count per background cycle): with 0 no backlash is taken up. A rate that"
    " is too high jerks, one too low lags.": (
        "I{address}86 = {constant} (1/16 incrément : {backlash} {unit} au zéro du moteur)."
        " I{address}85 = {rate} (1/16 incrément par cycle d'arrière-plan) : avec 0, aucun jeu"
        " n'est rattrapé. Une vitesse trop grande donne des à-coups, une trop petite prend du"
        " retard."
    ),
    "Keep the gap": "Garder l'intervalle libre",
    "Axis {name}: {gap}.": "Axe {name} : {gap}.",
    "Before SAVE and before production: axis {name} from {check_from} to {check_to} {unit},"
    " coming from below, once with I51=0 and once with I51=1 (send it by hand). With the"
    " tables on the way must change by {check_change}. Does it change the other way, the"
    " sign of counts_per_unit is wrong: I51=0, correct the job and run again. Then come from"
    " above with I51=1: the axis stands lower by the backlash of the card.": (
        "Avant SAVE et avant la production : axe {name} de {check_from} à {check_to} {unit}, en"
        " venant d'en bas, une fois avec I51=0 et une fois avec I51=1 (à envoyer à la main)."
        " Tables activées, le trajet doit changer de {check_change}. S'il change à l'inverse,"
        " le signe de counts_per_unit est faux : I51=0, corriger le dossier de travail et"
        " recommencer le calcul. Venir ensuite d'en haut avec I51=1 : l'axe est plus bas du jeu"
        " indiqué sur la fiche."
    ),
    "Keep it": "Conserver",
    "I51=1, define again what was deleted of GATHER, TBUF, ROTARY and LOOKAHEAD, then SAVE."
    " Until SAVE everything here is lost at the next reset ($$$): that is also the quick way"
    " back. A table is right only as long as homing finds the same motor zero: home after"
    " every restart before anything is measured.": (
        "I51=1, définir de nouveau ce qui a été effacé de GATHER, TBUF, ROTARY et LOOKAHEAD,"
        " puis SAVE. Jusqu'à SAVE, tout est perdu ici au prochain reset ($$$) : c'est aussi le"
        " retour rapide. Une table n'est juste que tant que la prise de référence trouve le"
        " même zéro du moteur : référencer après chaque redémarrage avant toute mesure."
    ),
    "Ask the card again (LIST COMP DEF and LIST COMP, LIST BLCOMP DEF and LIST BLCOMP with"
    " #{address} addressed, I51, I{address}85, I{address}86), write the answers as a script"
    " and compare them with the plan: `compwright compare JOB_FOLDER --loaded READ_BACK`.": (
        "Interroger de nouveau la carte (LIST COMP DEF et LIST COMP, LIST BLCOMP DEF et LIST"
        " BLCOMP avec #{address} adressé, I51, I{address}85, I{address}86), écrire les réponses"
        " comme un script et les comparer avec le plan : `compwright compare JOB_FOLDER"
        " --loaded READ_BACK`."
    ),
    "Reset ($$$) without SAVE; after SAVE delete as above, send the saved tables and set"
    " I51, I{address}85 and I{address}86 as written down.": (
        "Reset ($$$) sans SAVE ; après SAVE, effacer comme ci-dessus, envoyer les tables"
        " sauvegardées et régler I51, I{address}85 et I{address}86 comme notés."
    ),
    "Axis {name} is programmed in diameter: the table counts in the motor's own counts, so"
    " in radius, like the laser. Programs and displays show twice as much": (
        "Axe {name} programmé au diamètre : la table compte dans les incréments du moteur, donc"
        " au rayon, comme le laser. Programmes et affichages montrent le double"
    ),
    "define a table between the motors by hand, at a motor that has no table of its own (#k"
    " DEFINE COMP entries,#source D,#target,length; k the free motor, source the one of"
    " {input}, target the one of {output}; in 1/16 count of {output}, length in counts of"
    " {input}): a straight line that adds {squareness} rad times the way of {input}{shift}": (
        "définir à la main une table entre les moteurs, sur un moteur sans table à lui (#k"
        " DEFINE COMP entries,#source D,#target,length ; k le moteur libre, source celui de"
        " {input}, target celui de {output} ; en 1/16 incrément de {output}, length en"
        " incréments de {input}) : une droite qui ajoute {squareness} rad fois le trajet de"
        " {input}{shift}"
    ),
    "the length is one turn, and there is no gap": (
        "la longueur est d'un tour, et il n'y a pas d'intervalle libre"
    ),
    "what lies beyond {low} {unit} and below {high} {unit} is the gap that must stay unused"
    " (the table repeats after {turn} {unit}): keep the software limits inside": (
        "ce qui est au-delà de {low} {unit} et au-dessous de {high} {unit} est l'intervalle qui"
        " doit rester inutilisé (la table se répète après {turn} {unit}) : garder les limites"
        " logicielles à l'intérieur"
    ),
    "0 or as it is (there is no backlash)": "0 ou tel quel (il n'y a pas de jeu)",
    "Ask the card again (LIST COMP DEF, LIST COMP, LIST BLCOMP with #{address} addressed,"
    " I51, I{address}85, I{address}86) and compare the answers with the plan; the variable"
    " Mxx69 shows what the tables add.": (
        "Interroger de nouveau la carte (LIST COMP DEF, LIST COMP, LIST BLCOMP avec #{address}"
        " adressé, I51, I{address}85, I{address}86) et comparer les réponses avec le plan ; la"
        " variable Mxx69 montre ce que les tables ajoutent."
    ),
    "I51 must be 1: it switches all tables on.": "I51 doit être 1 : il active toutes les tables.",
    "After a reset only what SAVE has kept is there: LIST COMP DEF with #{address} addressed"
    " shows it.": (
        "Après un reset, seul ce que SAVE a gardé est là : LIST COMP DEF avec #{address}"
        " adressé le montre."
    ),
    "ERR003 while the script was sent means that a table was not defined.": (
        "ERR003 pendant l'envoi du script signifie qu'une table n'a pas été définie."
    ),
    "Entries are added to the position in counts: does the motor #{address} count with the"
    " axis or against it (sign of counts_per_unit)?": (
        "Les entrées sont ajoutées à la position en incréments : le moteur #{address}"
        " compte-t-il avec l'axe ou contre lui (signe de counts_per_unit) ?"
    ),
    "Entries are 1/16 counts of motor #{address}: counts per {unit} of the motor, whatever"
    " its scale factor is (counts_per_unit).": (
        "Les entrées sont des 1/16 d'incrément du moteur #{address} : incréments par {unit} du"
        " moteur, quel que soit son facteur d'échelle (counts_per_unit)."
    ),
    "Positions count from the motor zero of the last homing: it must be {reference} {unit},"
    " as for the measurement.": (
        "Les positions comptent à partir du zéro du moteur de la dernière prise de référence :"
        " il doit être à {reference} {unit}, comme pour la mesure."
    ),
    "DEFINE COMP: the first entry stands one spacing behind motor zero, and the spacing is"
    " the length divided by the entries.": (
        "DEFINE COMP : la première entrée est un pas après le zéro du moteur, et le pas est la"
        " longueur divisée par les entrées."
    ),
    "Entries run in the direction in which the motor counts; what lies below motor zero is"
    " the upper end of the table.": (
        "Les entrées vont dans le sens où le moteur compte ; ce qui est au-dessous du zéro du"
        " moteur est le bout supérieur de la table."
    ),
    "DEFINE COMP names the motors: #{address} by itself as source and as target.": (
        "DEFINE COMP nomme les moteurs : #{address} seul comme source et comme cible."
    ),
    "COMP is active in both directions; BLCOMP and I{address}86 only while the last command"
    " went in the negative counting direction.": (
        "COMP agit dans les deux sens ; BLCOMP et I{address}86 n'agissent que tant que la"
        " dernière commande allait dans le sens de comptage négatif."
    ),
    "I{address}86, in 1/16 counts, with BLCOMP added to it; I{address}85 = 0 takes up no"
    " backlash at all.": (
        "I{address}86, en 1/16 d'incrément, avec BLCOMP ajouté ; I{address}85 = 0 ne rattrape"
        " aucun jeu."
    ),
    "I{address}87 is the hysteresis of the reversal.": (
        "I{address}87 est l'hystérésis de l'inversion."
    ),
    "DEFINE COMP: number of entries and length. Outside 0 to the length the position rolls"
    " over into the table, so it must be longer than the travel.": (
        "DEFINE COMP : nombre d'entrées et longueur. Hors de 0 à la longueur, la position"
        " revient dans la table, elle doit donc être plus longue que la course."
    ),
    "Delta Tau PMAC, Turbo PMAC (UMAC, Geo Brick), leadscrew and backlash tables (DEFINE"
    " COMP, DEFINE BLCOMP)": (
        "Delta Tau PMAC, Turbo PMAC (UMAC, Geo Brick), tables du pas de vis et du jeu à"
        " l'inversion (DEFINE COMP, DEFINE BLCOMP)"
    ),
    "P10 for the unit; how fast suits a machine no manual says: 32 is 2 counts per"
    " background cycle": (
        "P10 pour l'unité ; quelle vitesse convient à une machine, aucun manuel ne le dit : 32"
        " donne 2 incréments par cycle de fond"
    ),
    "in no script, and no table of backlash needs it": (
        "dans aucun script, et aucune table de jeu n'en a besoin"
    ),
    "in no script; a card that uses tables has it on": (
        "dans aucun script ; une carte qui utilise des tables l'a activé"
    ),
}
