"""What a test after loading shows."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-V001": "{verdict}",
    "CW-V010": "Axe {axis} : ce qui a été relu de la commande est la table du plan.",
    "CW-V011": (
        "Axe {axis} : ce qui a été relu de la commande diffère du plan de {difference:.2f} {unit}"
        " au plus."
    ),
    "CW-V020": (
        "L'essai après chargement ne couvre pas ce que couvrait le premier : {gaps:join|; }."
        " Mesurer {targets} points visés de {range}, comme avant."
    ),
    "CW-V020.approaches": (
        "il a {runs} {runs:plural|approche|approches} dans le sens {direction} (le premier essai :"
        " {first})"
    ),
    "CW-V020.fewer": "il a {targets} {targets:plural|point visé|points visés}",
    "CW-V020.fewest": (
        "il a {targets} {targets:plural|point visé|points visés}, et la norme en demande au moins"
        " {fewest}"
    ),
    "CW-V020.gap": "{gap} de la course sont sans point visé",
    "CW-V020.range": "il couvre {range}",
    "CW-V021": (
        "Les mesures répétées se dispersent de {scatter}, {ratio:3sig} fois {less:if|moins|plus}"
        " que dans le premier essai ({first}) : si le bruit de deux essais diffère jusqu'à"
        " {factor:g} fois, le hasard seul le fait moins d'une fois sur 1000 essais. Unité et"
        " mesures sont-elles justes ? Mesurer de nouveau, l'instrument réglé comme au premier"
        " essai."
    ),
    "CW-V022": (
        "Le dossier de travail a été modifié après le calcul : {what:choose|standard=la"
        " norme|rule=la règle de décision|axis_limits=les limites de l'axe {of}|circle_limits=les"
        " limites du cercle {of}|uncertainty=l'incertitude déclarée des axes"
        " {of}|circle_uncertainty=l'incertitude déclarée des essais circulaires}"
        " {several:if|étaient|était} {was:if|{was}|aucune}, maintenant"
        " {now:if|{now}|aucune}. Refaire le calcul, pour que prévision et verdict"
        " utilisent les mêmes valeurs."
    ),
    "CW-V023.axis": (
        "L'axe {axis} n'a pas été mesuré après chargement, donc rien n'est prouvé pour lui. Le"
        " mesurer comme pour l'essai {test}."
    ),
    "CW-V023.circle": (
        "Le cercle {circle} a des limites et n'a pas été mesuré après chargement, donc rien n'est"
        " prouvé pour lui. Le mesurer de nouveau et le donner par --after {circle}=FILE."
    ),
    "CW-V023.scale": (
        "L'échelle de l'axe {axis} vient de cercles, et aucun n'a été mesuré après chargement, donc"
        " rien n'est prouvé pour elle. Mesurer de nouveau le cercle {circles:if|{circles:join| ou"
        " }|de ce plan}."
    ),
    "CW-V023.squareness": (
        "La perpendicularité de {plane} a été corrigée et non mesurée après chargement, donc rien"
        " n'est prouvé pour elle. Mesurer de nouveau le cercle {circles:if|{circles:join| ou }|de"
        " ce plan}."
    ),
    "CW-V023.test": (
        "Les limites de l'axe {axis} valent pour l'essai {meant}, et {measured} a été mesuré, donc"
        " rien n'est prouvé pour elles. Mesurer comme pour {meant} et le donner par --after"
        " {meant}=FILE."
    ),
    "CW-V024": (
        "L'essai après chargement, {code} : {finding} Éclaircir cela, ou mesurer de nouveau."
    ),
    "CW-V025": (
        "Le fichier donné par --after pour le cercle {circle} date d'avant le chargement. Mesurer"
        " le cercle de nouveau."
    ),
    "CW-V026.certain": (
        "Cela ne peut être juste : {why}. Exporter l'essai dans l'unité que son fichier indique."
    ),
    "CW-V026.copied": (
        "Les mesures sont celles de l'essai {test} d'avant le chargement{way:choose|same=|sign=,"
        " signe inversé|direction=, sens permutés}. Mesurer l'axe de nouveau."
    ),
    "CW-V026.file_twice": (
        "L'essai de l'axe {axis} contient deux fois un fichier. Donner chaque mesure une fois."
    ),
    "CW-V026.one_run": (
        "Tous les parcours ont les mêmes mesures : un parcours a été copié. Mesurer l'axe de"
        " nouveau."
    ),
    "CW-V026.scatter": (
        "La dispersion des mesures est celle de l'essai {test}, parcours par parcours (corrélation"
        " {correlation:.2f}) : l'essai en a été tiré. Mesurer l'axe de nouveau."
    ),
    "CW-V026.targets": "Les points visés de l'essai sont en {unit}, pas en mm. L'exporter en mm.",
    "CW-V026.thousand": (
        "Les mesures se dispersent de {scatter}, celles du premier essai de {first} : 1000 fois"
        " trop {small:if|petites (mm lus comme µm)|grandes (µm lus comme mm)}. Exporter l'essai"
        " dans l'unité que son fichier indique."
    ),
    "CW-V026.two_axes": (
        "L'axe {axis} et l'axe {other} ont reçu la même mesure. Donner à chaque axe la sienne."
    ),
    "CW-V026.zeros": (
        "Toutes les mesures de l'essai sont identiques : rien n'a été mesuré. Mesurer l'axe."
    ),
    "CW-V027": "{verdict}",
    "CW-V028": "{verdict}",
    "CW-V030": (
        "Essais {off} (sans elle) et {on} (avec elle) : la table de l'état {state} était active"
        " comme le disent ses fichiers, sûr à {percent:.1f} %."
    ),
    "CW-V031": (
        "Les essais {off} (sans elle) et {on} (avec elle) ne montrent pas si la table de l'état"
        " {state} était active comme le disent ses fichiers : {likely:if|{likely}|aucune cause"
        " connue ne convient}. Ils comptent dans la mesure où ils s'accordent."
    ),
    "headline.active": "{tables:plural|Table active|Tables actives}. Aucune limite donnée.",
    "headline.bad": "Mauvais : voir les {circles:if|cercles|axes} ci-dessous",
    "headline.good": (
        "Bon : les tables sont actives et les limites respectées{without:if| (aucune limite donnée"
        " pour {without})|}"
    ),
    "headline.undecided": "Non décidé : les essais ne le montrent pas",
    "loading.as_before": "Il est à moins de {left} de ce que faisait la commande avant.",
    "loading.as_predicted": "Il est à moins de {left} de la prévision.",
    "loading.candidate": "{name} ({sure:if|plus de 99|{percent:2sig}} %)",
    "loading.declared_slope": (
        "Sur la course, ses écarts montent de {slope:+.2f} ± {error:.2f} µm/m de plus que prévu :"
        " l'acier le fait sur {kelvin:+2sig} K, {within:if|dans les limites|au-delà} de ce que le"
        " dossier de travail déclare pour deux essais (± {declared:.1f} µm/m, k = 2). La table"
        " n'est pas en cause, mais les limites sont décidées avec la pente dans les mesures."
    ),
    "loading.effect": "{part:.2f} ± {error:.2f} de l'effet prévu",
    "loading.equivalent": (
        "Le même essai viendrait de : {names}. Aucune mesure de cet axe ne les distingue ;"
        " {read_back:if|les valeurs relues de la commande sont celles du plan (--loaded)|les"
        " valeurs relues de la commande le font (--loaded)}."
    ),
    "loading.evidence": (
        "Par rapport à la prévision, l'essai s'écarte de {off} et au pire de {worst} ; avec cette"
        " explication il reste {left}, et le bruit d'une mesure est {noise}.{effect:if| Mesuré :"
        " {effect}.}"
    ),
    "loading.likely": "{verdict} {percent:.0f} %",
    "loading.measurement": (
        "L'essai après chargement s'explique si {fault:choose|sign=le signe de ses écarts est"
        " inversé|direction=ses sens + et − sont permutés|unit=ses mesures sont multipliées par"
        " {factor:4sig}|wrong_axis=c'est un essai de {axis}}. Tel quel, rien ne l'explique."
        " {fault:choose|sign=Vérifier signe et sens de l'instrument et exporter l'essai de"
        " nouveau.|direction=Vérifier signe et sens de l'instrument et exporter l'essai de"
        " nouveau.|unit=L'exporter dans l'unité que son fichier indique.|wrong_axis=Mesurer cet"
        " axe, ou donner le fichier à son propre axe.}"
    ),
    "loading.name": "{name}{detail:if| : {detail}}",
    "loading.neither": (
        "L'essai après chargement ne correspond ni à la table chargée, ni à la commande telle"
        " qu'elle était avant, ni à un défaut de chargement connu.{loaded:if| Par rapport à la"
        " prévision il s'écarte de {loaded} et au pire de {loaded_worst}.}{inactive:if| Par rapport"
        " à aucun changement il s'écarte de {inactive} et au pire de {inactive_worst}.}{offset:if|"
        " Par rapport à la prévision, les approches en + sont en moyenne de {offset}"
        " {above:if|au-dessus|en dessous} de celles en −.}{effect:if| Mesuré : {effect}.}"
    ),
    "loading.no_table": "Le plan n'a pas de table pour cet axe : il n'y avait rien à charger.",
    "loading.open": (
        "Impossible de dire ce qui a été chargé : la nouvelle table change les écarts de {size}"
        " (valeur efficace), et le bruit d'une mesure est {noise}{needed:if| ; la correction est"
        " plus petite que les {needed} (valeur efficace) que cet essai peut prouver}{effect:if|."
        " Mesuré : {effect}}. Possible : {candidates}.{off:if| Mais par rapport à la première de"
        " ces causes il s'écarte de {off} et au pire de {worst}. C'est plus que du bruit : autre"
        " chose a changé, ou l'essai est fautif.}"
    ),
    "loading.rms": "{rms} (valeur efficace)",
    "loading.slope": (
        "Sur la course, ses écarts montent de {slope:+.2f} ± {error:.2f} µm/m de plus que prévu :"
        " l'acier le fait sur {kelvin:+2sig} K{declared:if| (déclaré pour deux essais : ±"
        " {declared:.1f} µm/m, k = 2)}. Indiquer la température de la règle dans les fichiers des"
        " deux essais (T_m) et son coefficient dans le dossier de travail (thermal), ou mesurer de"
        " nouveau quand machine et instrument sont stabilisés ; regarder le capteur de température"
        " de l'instrument."
    ),
    "loading.straight_line": (
        "L'essai après chargement est celui de la table chargée et d'une pente. {slope} La"
        " correction est elle-même une droite : une table active avec le facteur {factor:.2f}"
        " montrerait la même chose ; {read_back:if|les valeurs relues de la commande sont celles du"
        " plan (--loaded)|relire les valeurs de la commande (--loaded)}."
    ),
    "loading.thermal": (
        "La table est active : à part une pente, l'essai après chargement est à moins de {left} de"
        " la prévision. {slope}"
    ),
    "loading.too_few": "Indécidable : l'essai après chargement a moins de 3 moyennes mesurées.",
    "loading.verdict": (
        "{verdict:choose|loaded=La table est active comme prévu{effect:if| : l'essai après"
        " chargement montre {effect}}|not_active=La table n'est pas active{detail:if|"
        " ({detail})}{effect:if| : l'essai après chargement montre {effect}}|inverted=La table est"
        " active avec le signe opposé{detail:if| ({detail})} : elle s'ajoute à l'erreur|scaled=La"
        " table est active avec le facteur {factor:3sig}{detail:if| ({detail})}|shifted=La table"
        " est {nodes} {nodes:plural|point|points} trop loin en {direction}{detail:if|"
        " ({detail})}|mirrored=La table est chargée à l'envers, sa dernière valeur en"
        " premier{detail:if| ({detail})}|wrong_axis=La table active est celle de l'axe"
        " {axis}{detail:if| ({detail})}|one_direction=La table n'est active que dans un sens :"
        " {detail}|backlash=La table est active, et son jeu est faux : {detail}|partial=Une partie"
        " de la table est active : {detail}|increment=Seul le changement par rapport à la table"
        " existante est actif{detail:if| ({detail})} : charger la somme, qui est dans les fichiers"
        " écrits|on_top=La nouvelle somme a été ajoutée à la table existante{detail:if| ({detail})}"
        " : vider la table et charger de nouveau les fichiers écrits|state=La table existante"
        " n'était pas active pendant le premier essai, bien que le dossier de travail le dise."
        " Refaire le calcul avec `active: no` pour cet état}."
    ),
    "loading.worst": "{value} ({position}, approche dans le sens {direction})",
    "next.between_again": (
        "{output} sur {input} : examiné de nouveau, d'après les cercles après chargement"
    ),
    "next.between_kept": "{output} sur {input} : garde ce qui est dans la commande",
    "next.cannot_be_made": "le prochain tour ne peut pas être fait : {reason}",
    "next.circles_only": (
        "sa table vient de cercles, qui ne montrent pas son effet : il garde ce qui est dans la"
        " commande"
    ),
    "next.differs": "ce qui a été relu diffère du plan : {why}{quantity:if| ({quantity})}",
    "next.doubted": "son essai après chargement est douteux ({code} : {message})",
    "next.gained": (
        "une table de plus est écrite : {parameter} de {now:.2f} à {then:.2f} {unit} à de nouveaux"
        " points visés"
    ),
    "next.kept": "{why} : il garde ce qui est dans la commande, et ne reçoit pas d'autre table",
    "next.load": (
        "une table de plus pour {axes}{between:if|{axes:if|, }perpendicularité} : charger tout"
        " next/tables, mesurer de nouveau et vérifier ce tour"
    ),
    "next.no_axis": "aucun axe ne peut être corrigé davantage",
    "next.no_table": (
        "le plan ne contient pas de table pour lui, aucune n'a été chargée : il garde ce qui est"
        " dans la commande"
    ),
    "next.not_compared": "ce qui a été relu ne peut pas être comparé avec le plan : {why}",
    "next.not_measured": (
        "il n'a pas été mesuré après chargement : il garde ce qui est dans la commande"
    ),
    "next.read_back_differs": (
        "ce qui a été relu diffère du plan : {axes:join|; } ({quantity}{more:if| et {more} autres}"
        " ; compwright compare les liste tous). Relire ce qui est maintenant dans la commande,"
        " charger ce qui manque et vérifier de nouveau"
    ),
    "next.something_else": (
        "autre chose a été changé dans la commande depuis le calcul : {quantity}{axis:if| de l'axe"
        " {axis}}{more:if| et {more} autres} (compwright compare les liste tous) ; vérifier cela"
        " d'abord, puis lancer un nouveau dossier de travail"
    ),
    "next.squareness_alone": (
        "aucun axe ne peut être corrigé davantage, et la perpendicularité seule n'a pas de"
        " prochain tour : {measured:if|mesurer aussi après chargement un axe qui a une table, et"
        " le donner avec --after en plus des cercles|pour ce qui en reste, lancer un nouveau"
        " dossier de travail, avec ce qui a été relu comme as_found et avec les cercles après"
        " chargement}"
    ),
    "next.stop": (
        "arrêter ici : aucune autre table pour {axes} n'apporterait ce qu'un essai peut montrer"
    ),
    "next.stop_axis": "{stop:if|arrêter ici|pas d'autre table} : {why}",
    "next.verdict": (
        "le verdict est {verdict:choose|not_active=non active|inverted=inversée|scaled=mise à "
        "l'échelle|shifted=décalée|mirrored=en miroir|wrong_axis=mauvais axe|on_top=en plus|"
        "one_direction=un sens|partial=partielle|thermal=température|increment=seulement le "
        "changement|state=état|backlash=jeu|measurement=défaut de mesure|undecided=non décidé|"
        "={name}}{of:if| ({of})}, pas chargée"
    ),
    "next.written": "une table de plus est écrite",
}
