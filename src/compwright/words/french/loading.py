"""Sentences about a test after loading."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-V001": "{verdict}",
    "CW-V010": "Axe {axis} : la table relue de la commande concorde avec celle du plan.",
    "CW-V011": (
        "Axe {axis} : la table relue de la commande diffère du plan de {difference:.2f} {unit} au"
        " plus. compwright compare montre où."
    ),
    "CW-V011.others": (
        "Ce qui a été relu de la commande diffère du plan en dehors de ses tables d'axe :"
        " {entries}{more:if| et {more} de plus|}. compwright compare montre où."
    ),
    "CW-V012": (
        "Axe {axis} : cet essai ne montrerait pas si sa table a été échangée avec celle de"
        " {others:join| ou }. Pour l'exclure, relire les fichiers de la commande et les donner avec"
        " `--loaded`."
    ),
    "CW-V020": (
        "L'essai après chargement couvre moins que le premier : {gaps:join|; }. Mesurer {targets}"
        " points visés de {range}, comme avant."
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
        "{circle:if|Les mesures du cercle|Les mesures répétées} se dispersent de {scatter},"
        " {beyond:if|plus de |}{ratio:3sig} fois {less:if|moins|plus} que dans le premier essai"
        " ({first}). Par hasard, cela arrive dans moins d'un essai sur 1000, même si le bruit des"
        " deux essais diffère d'un facteur allant jusqu'à {factor:g}. Vérifier unité et mesures."
        " Mesurer de nouveau, l'instrument réglé comme au premier essai."
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
        "L'erreur d'échelle de l'axe {axis} a été corrigée d'après des essais circulaires, et aucun"
        " cercle après chargement ne montre assez nettement si cela est actif,"
        " donc rien n'est prouvé pour elle. Mesurer de nouveau le cercle"
        " {circles:if|{circles:join| ou }|de ce plan}."
    ),
    "CW-V023.squareness": (
        "La perpendicularité de {plane} a été corrigée et non mesurée après chargement, donc rien"
        " n'est prouvé pour elle. Mesurer de nouveau le cercle {circles:if|{circles:join| ou }|de"
        " ce plan}."
    ),
    "CW-V023.test": (
        "Les limites de l'axe {axis} valent pour l'essai {meant}, mais {measured} a été mesuré"
        " après chargement. Le respect des limites n'est donc pas prouvé. Mesurer comme pour"
        " {meant} et le donner par --after {meant}=FILE."
    ),
    "CW-V024": (
        "Avec cet avertissement sur l'essai après chargement, le verdict ne peut pas être bon"
        " ({code}) : {finding} Éliminer sa cause, puis mesurer de nouveau."
    ),
    "CW-V025": (
        "Le fichier donné par --after pour le cercle {circle} a été mesuré avant le chargement."
        " Mesurer le cercle de nouveau."
    ),
    "CW-V026.certain": (
        "Les mesures ne peuvent pas être justes : {why}. Exporter l'essai dans l'unité que son"
        " fichier indique."
    ),
    "CW-V026.copied": (
        "Ce fichier contient les mesures de l'essai {test} d'avant le"
        " chargement{way:choose|same=|sign=, signe inversé|direction=, sens permutés}. Mesurer"
        " l'axe de nouveau."
    ),
    "CW-V026.file_twice": (
        "L'essai de l'axe {axis} contient deux fois un fichier. Donner chaque mesure une fois."
    ),
    "CW-V026.one_run": (
        "Tous les parcours ont les mêmes mesures : un parcours a été copié. Mesurer l'axe de"
        " nouveau."
    ),
    "CW-V026.scatter": (
        "Parcours par parcours, les mesures se dispersent exactement comme dans l'essai {test}"
        " (corrélation {correlation:.2f}). Cet essai a donc été calculé à partir de celui-là."
        " Mesurer l'axe de nouveau."
    ),
    "CW-V026.targets": "Les points visés de l'essai sont en {unit}, pas en mm. L'exporter en mm.",
    "CW-V026.thousand": (
        "Les mesures se dispersent de {scatter}, celles du premier essai de {first}. Elles sont"
        " 1000 fois trop {small:if|petites (mm lus comme µm)|grandes (µm lus comme mm)}. Exporter"
        " l'essai dans l'unité que son fichier indique."
    ),
    "CW-V026.turned": (
        "Le jeu à l'inversion ou la différence d'asservissement a le signe opposé à celui du"
        " premier essai : {what:join| ; }. Le signe des écarts est inversé dans ce fichier, ou ccw"
        " et cw sont permutés. Vérifier les deux et exporter l'essai de nouveau."
    ),
    "CW-V026.two_axes": (
        "L'axe {axis} et l'axe {other} ont reçu la même mesure. Donner à chaque axe la sienne."
    ),
    "CW-V026.zeros": (
        "Toutes les mesures de l'essai sont identiques, donc rien n'a été mesuré. Mesurer l'axe."
    ),
    "CW-V027": "{verdict}",
    "CW-V028": "{verdict}",
    "CW-V029": (
        "L'essai{circle:if| du cercle {circle}|} après chargement est daté du {date}, le premier"
        " essai du {first}. Un essai plus ancien ne montre pas ce qui a été chargé. Vérifier le"
        " fichier et sa date, ou mesurer de nouveau."
    ),
    "CW-V030": (
        "Les essais {off} (sans la table) et {on} (avec elle) montrent que la table existante"
        " (states.{state} dans le dossier de travail) était active comme le disent ses fichiers"
        " (sûr à {percent:.1f} %)."
    ),
    "CW-V031": (
        "Les essais {off} (sans la table) et {on} (avec elle) ne montrent pas si la table"
        " existante (states.{state} dans le dossier de travail) était active comme le disent ses"
        " fichiers : {likely:if|{likely}|aucune cause connue ne convient}. Les deux essais ne"
        " sont utilisés que dans la mesure où ils s'accordent."
    ),
    "CW-V032": (
        "L'essai{circle:if| du cercle {circle}|} après chargement est de la machine au numéro de"
        " série {found}, mais cette machine a {known:join| ou }. L'essai d'une autre machine ne"
        " montre pas ce qui a été chargé. Donner le fichier de cette machine, ou corriger le numéro"
        " dans le dossier de travail ou dans le fichier."
    ),
    "CW-V033": (
        "Ce qui a été relu de la commande laisse un doute : {doubts:join| ; }. Relire tous les"
        " fichiers de la commande, et les donner tous avec --loaded."
    ),
    "CW-V034": (
        "Le cercle {circle} après chargement n'est pas celui du premier essai : {what:join| ; }."
        " Les écarts dépendent du rayon, de l'avance et de l'arc ; ils ne sont donc pas comparables"
        " à la prédiction{limits:if|, et les limites restent indécises|}. La perpendicularité est"
        " comparée malgré tout. Mesurer le cercle comme la première fois."
    ),
    "CW-V034.arc": (
        "il va de {start:.0f}° à {end:.0f}° (le premier de {was_start:.0f}° à {was_end:.0f}°)"
    ),
    "CW-V034.feed": "son avance est de {now:g} mm/min (celle du premier {was:g} mm/min)",
    "CW-V034.radius": "son rayon est de {now:g} mm (celui du premier {was:g} mm)",
    "CW-V035": (
        "{axis:if|L'erreur d'échelle de l'axe {axis}|La perpendicularité} après chargement est de"
        " {value:.1f} µm/m. La prévision était de {expected:.1f} µm/m, ± {U:.1f} µm/m dus au"
        " bruit des deux essais (k = 2). {verdict:choose|loaded=La correction est active ; un"
        " nouveau montage de l'instrument ou un changement de la machine peut laisser ce"
        " reste.|not_active={loading} Vérifier qu'elle est chargée et activée.|inverted={loading}"
        " Vérifier le signe de la table et la charger de nouveau.|increment={loading} La"
        " correction existante manque. {step}|read_back=La table relue diffère du plan"
        " (CW-V011).|uncertain=Les essais sont trop incertains pour nommer le défaut. Mesurer de"
        " nouveau le cercle entier dans les deux sens.|={loading} {step}}{negligible:if|"
        " Au-dessous de {negligible:.0f} µm/m elle est acceptée.|}"
    ),
    "CW-V035.open": (
        "Le cercle après chargement ne détermine pas assez bien la perpendicularité pour montrer"
        " que sa correction est active. Mesurer de nouveau le cercle entier dans les deux sens."
    ),
    "CW-V035.step": (
        "{as_planned:if|Ce qui a été relu est comme prévu : vérifier que toutes les tables sont"
        " activées et mesurer de nouveau le cercle.|Comparer ce qui est chargé avec le plan.}"
    ),
    "CW-V036": (
        "Le cercle après chargement n'est pas comme prévu : {what:join| ; }. Comparer ce qui est"
        " chargé avec le plan. L'avance, le bruit, le montage de l'instrument, une machine plus"
        " chaude, le frottement ou l'asservissement peuvent aussi en être la cause. Les vérifier et"
        " mesurer de nouveau comme au premier essai. Si cela reste, la machine a changé :"
        " commencer un nouveau dossier de travail avec ce cercle et les fichiers actuels de la"
        " commande."
    ),
    "CW-V036.value": "{name} {value} (prévu {low} à {high})",
    "headline.active": "{tables:plural|Table active|Tables actives}. Aucune limite donnée.",
    "headline.bad": "Mauvais : voir les {circles:if|cercles|axes} ci-dessous",
    "headline.good": (
        "Bon : les tables sont actives et les limites respectées{without:if| (aucune limite donnée"
        " pour {without})|}"
    ),
    "headline.undecided": (
        "Non décidé : les essais ne montrent pas si la table est active ou les limites respectées"
    ),
    "loading.as_before": (
        "L'essai diffère de {left} de ce qu'il montrerait si la commande était encore comme avant"
        " le chargement."
    ),
    "loading.as_predicted": "L'essai diffère de {left} de la prévision.",
    "loading.backlash": (
        "{kind:choose|missing=elle manque|twice=double|sign=avec le mauvais signe|old=l'ancienne"
        " valeur au lieu de la nouvelle|added=l'ancienne valeur ajoutée à la nouvelle}"
    ),
    "loading.candidate": "{name} ({sure:if|plus de 99|{percent:2sig}} %)",
    "loading.circle": (
        "{candidates:if|L'essai après chargement montre {effect}. Causes possibles :"
        " {candidates}.|Aucun défaut de chargement connu ne l'explique{effect:if| : l'essai après"
        " chargement montre {effect}}. Mesurer de nouveau le cercle.}"
    ),
    "loading.declared_slope": (
        "Sur la course, les écarts de cet essai montent de {slope:+.2f} ± {error:.2f} µm/m de plus"
        " que prévu. L'acier montre une telle pente quand sa température change de {kelvin:+2sig}"
        " K, ce qui est {within:if|dans les limites|au-delà} de ce que le dossier de travail"
        " déclare pour deux essais (± {declared:.1f} µm/m, k = 2). La table n'est pas en cause,"
        " mais les mesures qui décident si les limites sont respectées contiennent cette pente."
    ),
    "loading.effect": "{part:.2f} ± {error:.2f} de l'effet prévu",
    "loading.equivalent": (
        "Ces défauts donneraient les mêmes mesures : {names}. Aucune mesure de cet axe ne peut les"
        " distinguer. {read_back:if|Les valeurs relues de la commande en décident : elles sont"
        " égales aux valeurs prévues (--loaded)|Relire les valeurs de la commande et les donner"
        " par --loaded}."
    ),
    "loading.evidence": (
        "Les écarts mesurés diffèrent des écarts prévus de {off}, au pire de {worst}. Ils diffèrent"
        " de {left} de ceux que donnerait le défaut nommé dans le résultat ; le bruit d'une mesure"
        " est {noise}.{effect:if| Mesuré : {effect}.}"
    ),
    "loading.likely": "{verdict} {percent:.0f} %",
    "loading.factor": (
        "{factor:choose|2=double : rayon et diamètre confondus, chargée sur elle-même, ou double"
        " grossissement|0.5=moitié : rayon et diamètre confondus|10=dix fois : autre unité de"
        " détection ou autre système d'incréments|0.1=un dixième : autre unité de détection ou"
        " autre système d'incréments|16=16 fois : multipliées deux fois par 16|0.0625=1/16 :"
        " impulsions saisies au lieu de 1/16 d'impulsion|25.4=25,4 fois : valeurs en mm saisies"
        " comme pouces|0.03937=1/25,4 : valeurs en pouces saisies comme mm|1000=mille fois :"
        " valeurs en µm saisies comme mm|0.001=un millième : valeurs en mm saisies comme µm}"
    ),
    "loading.in_order": (
        "saisies dans l'ordre des positions, la plus {end:choose|low=basse|high=haute}"
        " d'abord ; la commande compte les entrées à partir de son point zéro"
    ),
    "loading.instead": (
        "{active:choose|still=ce qui était dans la commande avant est encore actif|before=ce qui"
        " était dans la commande avant est actif|nothing=rien du tout n'est actif|backlash=seul le"
        " nouveau jeu est actif}"
    ),
    "loading.measurement": (
        "L'essai après chargement lui-même semble faux. Il ne concorde avec le premier essai et le"
        " plan que si {fault:choose|sign=le signe de ses écarts est inversé|direction=ses sens + et"
        " − sont permutés|unit=ses mesures sont multipliées par {factor:4sig}|wrong_axis=c'est un"
        " essai {axis}}. {fault:choose|sign=Vérifier signe et sens de l'instrument et"
        " exporter l'essai de nouveau.|direction=Vérifier signe et sens de l'instrument et exporter"
        " l'essai de nouveau.|unit=Exporter l'essai dans l'unité que son fichier"
        " indique.|wrong_axis=Mesurer cet axe, ou donner le fichier à l'axe auquel il appartient.}"
    ),
    "loading.name": (
        "{name:choose|loaded=chargée|not_active=non active|inverted=signe opposé|scaled=mauvais"
        " facteur|shifted=décalée le long de l'axe|mirrored=à l'envers|wrong_axis=table d'un autre"
        " axe|one_direction=active dans un seul sens|backlash=mauvaise valeur de jeu|partial=seule"
        " une partie est active|increment=changement seul chargé|on_top=ajoutée à la table"
        " existante|state=table existante non active au premier essai|thermal=autre"
        " température|measurement=mesure fausse|undecided=non décidé}{detail:if| : {detail}}"
    ),
    "loading.neither": (
        "L'essai après chargement ne correspond ni à la table chargée, ni à la commande telle"
        " qu'elle était avant, ni à un défaut de chargement connu.{loaded:if| Il diffère de la"
        " prévision de {loaded}, au pire de {loaded_worst}.}{inactive:if| Il diffère de"
        " {inactive}, au pire de {inactive_worst}, de ce qu'il montrerait avec la commande telle"
        " qu'elle était avant.}{offset:if| Par rapport à la prévision, les approches en + sont en"
        " moyenne de {offset} {above:if|au-dessus|en dessous} de celles en −.}{effect:if| Mesuré :"
        " {effect}.}"
    ),
    "loading.no_table": "Le plan n'a pas de table pour cet axe : il n'y avait rien à charger.",
    "loading.of_axis": "de l'axe {axis}",
    "loading.one_direction": (
        "approches{axis:if| de {axis}|} dans le sens {direction} seulement ; dans l'autre sens"
        " {other:choose|before=la correction est comme avant|nothing=aucune correction n'est"
        " active|backlash=seul le nouveau jeu est actif}"
    ),
    "loading.open": (
        "Cet essai ne peut pas montrer ce qui a été chargé. La nouvelle table change les écarts de"
        " {size} (valeur efficace), et le bruit d'une mesure est {noise}{needed:if|. Cette"
        " correction est plus petite que les {needed} (valeur efficace) que l'essai peut"
        " prouver}{effect:if|. Mesuré : {effect}}. Causes possibles : {candidates}.{off:if| Mais"
        " les écarts mesurés diffèrent de {off}, au pire de {worst}, de ceux que donnerait la"
        " première de ces causes. C'est plus que du bruit : autre chose a changé, ou l'essai est"
        " fautif.}"
    ),
    "loading.other_axis": (
        "celle de l'axe {axis}, aux mêmes {by:choose|position=positions|number=numéros de point}"
    ),
    "loading.part": (
        "{first:if|jusqu'au|à partir du} point {number} ({position:g}),"
        " {beyond:choose|nothing=ailleurs aucune correction|last=ailleurs la dernière"
        " valeur|old=ailleurs les anciennes valeurs|old_steps=ailleurs les anciens"
        " incréments|no_backlash=ailleurs ni correction ni jeu|before=ailleurs tout est comme"
        " avant}"
    ),
    "loading.rms": "{rms} (valeur efficace)",
    "loading.slope": (
        "Sur la course, les écarts de cet essai montent de {slope:+.2f} ± {error:.2f} µm/m de plus"
        " que prévu. L'acier montre une telle pente quand sa température change de {kelvin:+2sig}"
        " K{declared:if| (déclaré pour deux essais : ± {declared:.1f} µm/m, k = 2)}. Indiquer la"
        " température de la règle dans les fichiers des deux essais (T_m) et son coefficient dans"
        " le dossier de travail (thermal). Ou laisser machine et instrument se stabiliser, vérifier"
        " le capteur de température de l'instrument et mesurer de nouveau."
    ),
    "loading.steps": "incréments dans l'ordre inverse",
    "loading.straight_line": (
        "L'essai après chargement montre la table chargée et une pente en plus. {slope} La"
        " correction est elle-même une droite, donc une table active avec le facteur {factor:.2f}"
        " montrerait la même chose. {read_back:if|Les valeurs relues de la commande sont égales"
        " aux valeurs prévues (--loaded)|Pour trancher, relire les valeurs de la commande et les"
        " donner par --loaded}."
    ),
    "loading.table": "la table {active:if|est active|n'est pas active}",
    "loading.thermal": (
        "La table est active. À part une pente, l'essai après chargement diffère de {left} de la"
        " prévision. {slope}"
    ),
    "loading.too_few": (
        "L'essai après chargement a moins de 3 moyennes mesurées, ce qui est trop peu pour"
        " montrer ce qui a été chargé. Mesurer plus de points visés."
    ),
    "loading.variant": (
        "{detail:if|{detail}, }{backlash:choose|old=avec l'ancien jeu|apart=jeu excepté"
        "|table=seulement dans la table du jeu}"
    ),
    "loading.verdict": (
        "{verdict:choose|loaded=La table est active comme prévu{effect:if| : l'essai après"
        " chargement montre {effect}}|not_active=La table n'est pas active{detail:if|"
        " ({detail})}{effect:if| : l'essai après chargement montre {effect}}|inverted=La table est"
        " active avec le signe opposé{detail:if| ({detail})} et agrandit l'erreur|scaled=La table"
        " est active avec le facteur {factor:3sig}{detail:if| ({detail})}|shifted=La table est"
        " décalée de {nodes} {nodes:plural|point|points} de table dans le sens"
        " {direction}{detail:if| ({detail})}|mirrored=La table est chargée à l'envers, sa dernière"
        " valeur en premier{detail:if| ({detail})}|wrong_axis=La table active est"
        " {detail}|one_direction=La table n'est active que dans un sens : {detail}|backlash=La"
        " table est active, mais la valeur de jeu est fausse : {detail}|partial=Seule une partie de"
        " la table est active : {detail}|increment=Seul le changement par rapport à la table"
        " existante est actif{detail:if| ({detail})}{open:if||. Charger la somme, qui est dans les"
        " fichiers écrits}|on_top=La commande a ajouté la nouvelle somme à la table"
        " existante{detail:if| ({detail})}{open:if||. Vider la table et charger de nouveau les"
        " fichiers écrits}|state=La table existante n'était pas active pendant le premier essai,"
        " bien que le dossier de travail le dise{open:if||. Refaire le calcul avec `active: no`"
        " dans l'entrée de `states` qui était dans la commande pendant le premier essai"
        " (measured_in)}}."
    ),
    "loading.worst": "{value} ({position}, approche dans le sens {direction})",
    "next.between_again": (
        "la correction de {output} selon {input} a été estimée de nouveau d'après les cercles"
        " après chargement"
    ),
    "next.between_kept": (
        "la correction de {output} selon {input} reste telle qu'elle est dans la commande"
    ),
    "next.cannot_be_made": (
        "les tables du prochain tour de correction ne peuvent pas être faites : {reason}"
    ),
    "next.circles_only": (
        "la table de cet axe a été calculée seulement à partir d'essais circulaires, et un tour"
        " suivant ne corrige que les axes qui ont un essai de positionnement. L'axe garde ce qui"
        " est dans la commande"
    ),
    "next.differs": "ce qui a été relu diffère du plan : {why}{quantity:if| ({quantity})}",
    "next.doubted": (
        "un constat sur l'essai de cet axe après chargement n'est pas éclairci ({code} : {message})"
    ),
    "next.gained": (
        "une table de plus est écrite. Elle devrait changer {parameter} à de nouveaux points visés"
        " de {now:.2f} à {then:.2f} {unit}"
    ),
    "next.kept": (
        "{why}. L'axe garde ce qui est dans la commande, et ne reçoit pas de table pour"
        " le prochain tour"
    ),
    "next.load": (
        "une table de plus a été écrite pour {axes}{between:if|{axes:if| et pour la"
        " }perpendicularité}. Charger tous les fichiers de next/tables, mesurer de nouveau et"
        " lancer compwright verify avec next/job.yaml"
    ),
    "next.no_axis": "aucun axe ne reçoit de table pour le prochain tour",
    "next.no_table": (
        "le plan ne contient pas de table pour cet axe, donc aucune n'a été chargée. L'axe garde"
        " ce qui est dans la commande"
    ),
    "next.not_compared": "ce qui a été relu ne peut pas être comparé avec le plan : {why}",
    "next.not_measured": (
        "cet axe n'a pas été mesuré après chargement. L'axe garde ce qui est dans la commande"
    ),
    "next.read_back_differs": (
        "ce qui a été relu diffère du plan : {axes:join|; } ({quantity}{more:if| et {more}"
        " autres} ; compwright compare les liste tous). Charger ce qui manque, relire le contenu"
        " de la commande et vérifier de nouveau"
    ),
    "next.something_else": (
        "d'autres valeurs de la commande ont été changées depuis le calcul : {quantity}{axis:if|"
        " de l'axe {axis}}{more:if| et {more} autres} (compwright compare les liste tous)."
        " Vérifier d'abord ces changements, puis lancer un nouveau dossier de travail"
    ),
    "next.squareness_alone": (
        "aucun axe ne reçoit de nouvelle table, donc la perpendicularité n'est pas corrigée"
        " davantage non plus. {measured:if|Pour la corriger davantage, mesurer après chargement au"
        " moins un axe qui a une table, et donner son essai par --after avec les cercles|Pour la"
        " corriger davantage, créer un nouveau dossier de travail : donner les fichiers relus"
        " comme as_found, et les cercles mesurés après chargement}"
    ),
    "next.squareness_not_active": (
        "pas de nouvelle table : les cercles ne montrent pas que la correction de la"
        " perpendicularité de {planes} est active comme prévu, et une autre pourrait s'ajouter à un"
        " défaut. Corriger d'abord cela, puis mesurer de nouveau le cercle"
    ),
    "next.stop": (
        "arrêter ici : le gain d'une autre table pour {axes} serait trop petit pour se voir dans"
        " un essai"
    ),
    "next.stop_axis": "{stop:if|arrêter ici|pas de table pour le prochain tour} : {why}",
    "next.stop_squareness": (
        "{stop:if|arrêter ici : la perpendicularité de {planes} ne demande plus de correction|pas"
        " de nouvelle table : la perpendicularité de {planes} après chargement est trop incertaine"
        " pour une autre correction. Mesurer à nouveau le cercle}"
    ),
    "next.verdict": (
        "le verdict est « {verdict:choose|not_active=non active|inverted=inversée|scaled=mise à"
        " l'échelle|shifted=décalée|mirrored=en miroir|wrong_axis=mauvais axe|on_top=ajoutée à"
        " l'ancienne table|one_direction=active dans un sens|partial=active en partie|thermal=pente"
        " thermique|increment=changement seul chargé|state=ancienne table non"
        " active|backlash=valeur de jeu fausse|measurement=défaut de mesure|undecided=non"
        " décidé|={name}}{of:if| ({of})} », pas « chargée »"
    ),
    "next.written": "une table de plus est écrite",
    "read_back.backlash": (
        "toutes les valeurs pour l'arrivée en {direction} diffèrent de la même quantité : la valeur"
        " de jeu n'est pas celle prévue"
    ),
    "read_back.cause": (
        "{cause:choose|loaded=la table dans la commande est la table prévue|before=ce qui était"
        " avant dans la commande y est encore|nothing=aucune table n'est active : elle est"
        " désactivée ou vide|increment=seule la modification de la table existante a été chargée"
        " : charger le total|on_top=le nouveau total a été ajouté à la table existante : effacer"
        " la table et la charger de nouveau|inverted=chaque valeur a le signe opposé}{apart:if|"
        " (jeu mis à part)|}"
    ),
    "read_back.one_side": (
        "seules les valeurs pour l'arrivée en {direction} sont égales aux valeurs prévues"
    ),
    "read_back.other": (
        "les valeurs diffèrent à {off} positions sur {number} (chaque sens compté) ; aucune erreur"
        " connue n'explique toutes ces différences"
    ),
    "read_back.own": (
        "les fichiers écrits par compwright run contiennent la table prévue. Ils ne montrent pas ce"
        " que contient la commande"
    ),
    "read_back.partly": (
        "seul {loaded:and} a été chargé : charger aussi {missing:and}, avant que l'axe ne se"
        " déplace ; {why}"
    ),
    "read_back.scaled": (
        "chaque valeur diffère de celle prévue par un facteur ({factor}){apart:if| (jeu mis à"
        " part)|}"
    ),
    "read_back.shifted": (
        "la table est décalée de {points} {points:plural|point|points} vers {towards}{apart:if|,"
        " et les valeurs de chaque sens diffèrent en plus du plan d'une constante : le point de"
        " référence a un autre numéro ou une autre position|}"
    ),
}
