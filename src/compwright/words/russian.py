"""The Russian catalogue: labels and fixed sentences of reports. Terms: docs/terms.md."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "Сведения по ГОСТ 27843-2006, 8.1.",
    "basis.iso230_2_1988": (
        "Сведения по ISO 230-2:1997, 7.1. В издании 1988 года перечня нет; его пункты 3.2 и 4.3"
        " требуют тех сведений, у которых здесь указан пункт."
    ),
    "basis.iso230_2_1997": "Сведения по ISO 230-2:1997, 7.1.",
    "basis.iso230_2_2006": "Сведения по ISO 230-2:2006, 7.1.",
    "basis.iso230_2_2014": (
        "Сведения по ISO 230-2:2006, 7.1. Текста ISO 230-2:2014 в распоряжении не было; его пункты"
        " не указаны."
    ),
    "basis.iso230_4_1996": ("Сведения по ISO 230-4:1996, 4.4 и 6 (по тексту DIN ISO 230-4:1999)."),
    "basis.iso230_4_2005": (
        "Сведения по ISO 230-4:1996, 4.4 и 6. Текста ISO 230-4:2005 в распоряжении не было; его"
        " пункты не указаны."
    ),
    "basis.vdi3441": (
        "Сведения по ISO 230-2:2006, 7.1. Текста VDI/DGQ 3441 в распоряжении не было; его пункты"
        " не указаны."
    ),
    "budget.E_VE": "Изменения окружающей среды (размах)",
    "budget.U_alpha_instrument": "Коэффициент расширения прибора",
    "budget.U_alpha_machine": "Коэффициент расширения станка",
    "budget.U_theta_instrument": "Температура прибора",
    "budget.U_theta_machine": "Температура станка",
    "budget.combined": "Суммарная стандартная неопределенность",
    "budget.device": "Измерительный прибор (свидетельство)",
    "budget.distribution": (
        "{distribution:choose|normal=нормальное, k = 2|rectangular=равномерное, √12};"
        " {per:choose|length=по длине|test=на проверку|reading=на отсчет}"
    ),
    "budget.expanded": "Расширенная неопределенность, k = {k}",
    "budget.misalignment_mm": "Отклонение линии измерения от направления оси",
    "budget.note": (
        "Составляющие по ISO 230-2:2006, приложение A. Сумма относится к одному отсчету в конце"
        " хода. Она не равна U параметров (см. выше): там те же распределения проведены через"
        " определение параметра (JCGM 101). Все значения взяты из задания; отсутствующие считаются"
        " равными 0. Из примера стандарта не взято ни одного значения."
    ),
    "budget.setup": "Установка прибора",
    "budget.title": "Бюджет неопределенности измерений, на длине {length}",
    "decision.accept": "✓ принято",
    "decision.no_limit": "нет допуска",
    "decision.reject": "✗ отклонено",
    "decision.undecided": "? не решено",
    "fact.address": "адрес в системе ЧПУ",
    "fact.kind": "вид",
    "fact.quantum": "дискретность таблицы",
    "fact.unit": "единица отклонений",
    "given.approaches": "{counts}; {cycle:choose|standard=стандартный цикл|step=пошаговый цикл}",
    "given.arc": "от {start}° до {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=в начале|_end=в конце}",
    "given.axis": "{axis}, {kind:choose|linear=линейная ось|rotary=ось вращения}",
    "given.budget": "см. бюджет неопределенности",
    "given.centre": "центр {places:join|; } mm",
    "given.coefficient": "{value} µm/(m K)",
    "given.estimator": (
        "s: {spread:choose|std=среднеквадратическое отклонение, n − 1|range=по размаху отсчетов};"
        " границы ± {coverage} s; без сглаживания"
    ),
    "given.expansion": (
        "введена compwright: отсчеты приведены к 20 °C, {what:choose|scale=шкала|workpiece=деталь}"
        " {alpha_m} µm/(m K) при {T_m} °C, прибор {alpha_d} µm/(m K) при {T_d} °C, неподвижная"
        " точка {x_fix} mm"
    ),
    "given.list": "{others:if|{others} и |}{last:if|{last}|нет}",
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.radius": "радиус {radius} mm",
    "given.samples": "точек измерения: {counts}",
    "given.sense": "{sense:choose|ccw=против часовой стрелки|cw=по часовой стрелке}",
    "given.sentences": "{sentences:join| }",
    "given.smoothing": "compwright не сглаживает: учтена каждая точка",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count}, от {first} до {last} {unit}; перечень в приложении A",
    "head.after": "После",
    "head.approach": "Направление подхода",
    "head.assumed_value": "Принятое значение",
    "head.axis": "Ось",
    "head.before": "До",
    "head.clause": "Пункт",
    "head.contribution": "Вклад u",
    "head.correction": "Коррекция{sign:if| {sign}}",
    "head.coverage_factor": "Фактор охвата k",
    "head.decision": "Решение",
    "head.distribution": "Распределение",
    "head.evidence": "Основание",
    "head.expanded_uncertainty": "Расширенная неопределенность U",
    "head.extreme": "Крайнее значение",
    "head.fact": "Факт",
    "head.file": "Файл",
    "head.item": "Сведения",
    "head.limit": "Допуск",
    "head.limit_on": "Допуск на",
    "head.loading": "Загрузка",
    "head.mean": "среднее {sign}",
    "head.parameter": "Параметр",
    "head.position": "Позиция",
    "head.predicted": "Прогноз",
    "head.predicted_new": "Прогноз, новые заданные позиции",
    "head.predicted_same": "Прогноз, те же заданные позиции",
    "head.quantity": "Величина",
    "head.remark": "Примечание",
    "head.residual": "Остаток",
    "head.sensitivity": "Чувствительность",
    "head.source": "Источник",
    "head.standard": "Стандарт",
    "head.stated": "Указано",
    "head.test": "Проверка",
    "head.unit": "Единица",
    "head.value": "Значение",
    "head.value_given": "Заданное значение",
    "item.air_pressure": "Давление воздуха в начале и конце",
    "item.air_shower": "Обдув или орошение, охлаждающая жидкость",
    "item.air_temperature": "Температура воздуха в начале и конце",
    "item.approaches": "Число проходов, цикл проверки",
    "item.axis": "Измеряемая ось",
    "item.certificate": "Измерительный прибор: свидетельство о калибровке",
    "item.compensation": "Программная коррекция: включена или выключена",
    "item.compensation_routine": "Вид температурной коррекции",
    "item.contributors": "Составляющие неопределенности измерений",
    "item.date": "Дата и время проверки",
    "item.diameter": "Диаметр или радиус номинальной траектории",
    "item.dwell": "Время покоя в каждой заданной позиции",
    "item.estimator": "Оценка s, сглаживание",
    "item.expansion": "Поправка на тепловое расширение (NDE)",
    "item.feed": "Скорость перемещения между заданными позициями",
    "item.humidity": "Влажность воздуха в начале и конце",
    "item.instrument": "Измерительный прибор: изготовитель, тип",
    "item.instrument_position": "Позиция измерительного прибора",
    "item.instrument_serial": "Измерительный прибор: порядковые номера компонентов",
    "item.machine": "Станок: название и заводской номер",
    "item.machine_type": "Станок: тип",
    "item.measuring_line": "Линия измерения: положение, смещение от инструмента и детали",
    "item.operator": "Оператор",
    "item.other_axes": "Положения осей, не участвующих в измерении",
    "item.path_feed": "Контурная скорость",
    "item.place": "Место проверки",
    "item.plane": "Оси, образующие траекторию",
    "item.range": "Участок измерения, начало и конец",
    "item.samples": "Число точек измерения",
    "item.scale": "Тип шкалы станка",
    "item.scale_expansion": "Коэффициент расширения шкалы",
    "item.sense": "Направление обхода",
    "item.sensor_positions": "Места датчиков температуры",
    "item.smoothing": "Сглаживание",
    "item.standard": "Стандарт и издание",
    "item.targets": "Заданные позиции",
    "item.temperatures": "Температура шкалы станка или детали в начале и конце",
    "item.temperatures_circle": "Температура окружающей среды, прибора и станка",
    "item.temperatures_instrument": "Температура датчиков прибора в начале и конце",
    "item.travel": "Ход оси",
    "item.warm_up": "Прогрев перед проверкой",
    "label.after": "после",
    "label.before": "до",
    "label.circular_test": "круговая проверка",
    "label.conformity": "Заявление о соответствии: {statement}",
    "label.control": "система ЧПУ",
    "label.decision_rule": "Правило решения: {rule}",
    "label.extreme_at": "{symbol} на {place} {unit}",
    "label.kind": "{kind:choose|linear=линейная ось|rotary=ось вращения}",
    "label.median": "медиана",
    "label.not_stated": "не указано",
    "label.of_the_prediction": "прогноза",
    "label.plus_minus": "± {U}",
    "label.range": "от {low} до {high}",
    "label.test_sentence": (
        "{standard}, {cycle:choose|standard=стандартный цикл|step=пошаговый цикл}, {targets}"
        " {targets:plural|заданная позиция|заданные позиции|заданных позиций}, проходы:"
        " {counts:if|{counts}|нет}, границы ± {coverage} s.{extremes:if| Крайние значения:"
        " {extremes:join|; }.}{uncertainty:if|| Неопределенности измерений нет: составляющие не"
        " указаны.}"
    ),
    "label.test_title": "Ось {axis}, {name:if|{name}|проверка}{label:if|, {label}}",
    "label.traverses": "{count} в {sign}",
    "label.unconfirmed": "! не подтверждено",
    "label.with_range": "{unit}; медиана, 5–95 %",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "mark.loaded": "✓ загружена",
    "mark.measurement": "? ошибка измерения",
    "parameter.A": "Точность двустороннего позиционирования",
    "parameter.A_negative": "Точность одностороннего позиционирования, подход −",
    "parameter.A_positive": "Точность одностороннего позиционирования, подход +",
    "parameter.B": "Зона нечувствительности",
    "parameter.B_mean": "Средняя зона нечувствительности",
    "parameter.E": "Двустороннее систематическое позиционное отклонение",
    "parameter.E_negative": "Одностороннее систематическое позиционное отклонение, подход −",
    "parameter.E_positive": "Одностороннее систематическое позиционное отклонение, подход +",
    "parameter.M": "Среднее двустороннее позиционное отклонение",
    "parameter.P": "Неопределенность позиции",
    "parameter.Pa": "Отклонение позиции",
    "parameter.Ps_max": "Наибольшее рассеяние позиции",
    "parameter.Ps_mean": "Среднее рассеяние позиции",
    "parameter.R": "Двусторонняя повторяемость позиционирования",
    "parameter.R_negative": "Односторонняя повторяемость позиционирования, подход −",
    "parameter.R_positive": "Односторонняя повторяемость позиционирования, подход +",
    "parameter.U_max": "Наибольшая зона нечувствительности",
    "parameter.U_mean": "Средняя зона нечувствительности",
    "report.accreditation": (
        "Это протокол испытаний, а не свидетельство о калибровке аккредитованной лаборатории."
        " Прослеживаемость значений основана на свидетельствах о калибровке названных измерительных"
        " приборов."
    ),
    "report.acknowledged": "Принятые к сведению сомнения",
    "report.annex_a": "Приложение A: заданные позиции и исходные отсчеты",
    "report.annex_b": "Приложение B: происхождение данных",
    "report.axis": "Ось {axis}{name:if|, {name}}",
    "report.both": "оба",
    "report.circle": "Окружность {plane}{name:if|, {name}}",
    "report.compensation": "Коррекция: {axes:if|{axes}|осей {count}}",
    "report.conditions": "Условия проверки, {standard}",
    "report.conform": "Станок соответствует всем допускам таблицы выше.",
    "report.conformity_open": (
        "Соответствие не заявлено: не решено хотя бы одно требование или не ясна его основа."
    ),
    "report.customer": "Заказчик",
    "report.date": "Дата проверки",
    "report.extreme": (
        "{end:choose|highest=макс.|lowest=мин.} среднее"
        "{what:choose|A= {end:choose|highest=+|lowest=−} {coverage} s|E=|M= ±}"
    ),
    "report.extremes": "Крайние значения: кольца на рисунке",
    "report.findings": "Замечания",
    "report.footer": "Протокол {number}",
    "report.in_english": (
        "Замечания, надписи на рисунках и страницы круговых проверок приведены на английском языке."
    ),
    "report.in_file": "В файле: {name}",
    "report.logo": "Логотип",
    "report.no_limits": (
        "Допуски не заданы. Протокол приводит значения и не заявляет о соответствии."
    ),
    "report.no_number": "Протокол без номера",
    "report.not_conform": "Станок соответствует не всем допускам таблицы выше.",
    "report.number": "Номер протокола",
    "report.open_sections": "Печатаются раскрытые разделы.",
    "report.operator": "Оператор",
    "report.other_findings": "Прочие замечания",
    "report.page": "Страница",
    "report.page_of": "из",
    "report.parameters": "Параметры",
    "report.place": "Место",
    "report.provenance": (
        "Обработано compwright {version}.{command:if| Команда, которая повторяет протокол:}"
    ),
    "report.readings": "Отсчеты",
    "report.readings_measured": "Отсчеты, как измерено",
    "report.readings_air": "Отсчеты без влияния воздуха на свет",
    "report.readings_reduced": "Отсчеты, приведенные к 20 °C",
    "report.results": "Результаты",
    "report.see_tests": "см. страницы проверок",
    "report.sign_checked": "Проверил",
    "report.sign_measured": "Измерил",
    "report.sign_place": "Место, дата",
    "report.signs": (
        "Отклонение: действительная позиция минус заданная. Подход +: в положительном направлении"
        " станка. Зона нечувствительности в целевой позиции: среднее при подходе +"
        " минус среднее при подходе −; B: наибольшее по модулю."
    ),
    "report.statistics": (
        "Средние, среднеквадратические отклонения и повторяемость на {count}"
        " {count:plural|заданной позиции|заданных позициях|заданных позициях}"
    ),
    "report.test": "Проверка {name}",
    "report.title": "Протокол испытаний{tests:plural||: {tests} проверки|: {tests} проверок}",
    "report.unread": "Необработанные файлы",
    "report.verification": "Проверка после загрузки: {axes}",
    "rule.band": "{symbol} {U:if|{U} {unit}|не указано}",
    "rule.guarded": (
        "Решение с защитной полосой (ISO 14253-1): принято, если значение 95 % плюс U в пределах"
        " допуска; отклонено, если значение 5 % минус U за его пределами; U (k = 2) предстоящей"
        " проверки вместе с тем, что первая внесла в таблицу: {bands}."
    ),
    "rule.guarded_after": (
        "Решение с защитной полосой (ISO 14253-1): принято, если значение плюс U в пределах"
        " допуска; отклонено, если значение минус U за его пределами; U (k = 2) проверки после"
        " загрузки: {bands}."
    ),
    "rule.simple": (
        "Принято, если значение 95 % в пределах допуска; отклонено, если значение 5 % за его"
        " пределами; неопределенность измерений не учитывается: без защитных полос (ISO 14253-1)."
    ),
    "rule.simple_after": (
        "Принято, если измеренное значение в пределах допуска; отклонено, если за его пределами;"
        " неопределенность измерений не учитывается: без защитных полос (ISO 14253-1)."
    ),
    "run.annex_c": "Приложение C: коррекция",
    "run.assumed": "Допущения",
    "run.assumed_note": "В переданных файлах этого нет; результаты верны, только если это так.",
    "run.axis_table": "Ось {axis}: таблица",
    "run.bends": "{input} корректирует {output}",
    "run.bidirectional": "По одной кривой на каждое направление подхода",
    "run.card": "Карта ввода (на английском языке)",
    "run.certificate": "Подтверждение расчета",
    "run.changes": "Старое и новое",
    "run.check_first": "Не решено: сначала проверить указанное выше",
    "run.circle_worse": "Не решено: по прогнозу одна окружность ухудшится",
    "run.comparison": "До и прогноз",
    "run.comparison_note": (
        "До коррекции и, в том же масштабе, ожидаемый результат проверки в тех же заданных"
        " позициях."
    ),
    "run.compensation": "Коррекция",
    "run.correction": "Коррекция: то, что система ЧПУ прибавляет к заданию.",
    "run.cross": "Таблицы между осями",
    "run.done": (
        "Обработано: {tests} {tests:plural|проверка|проверки|проверок}, {count:plural|ось|оси|оси}"
        " {axes}, стандарт: {standards:if|{standards:and}|нет}. Погрешность оценена по всему"
        " ходу{tables:if|. Рассчитана лучшая таблица, которую может хранить"
        " {control:if|{control}|система ЧПУ}; она записана в форме системы ЧПУ и прочитана из"
        " файлов обратно, чтобы предсказать следующую проверку. Пока ничего не загружено:"
        " загрузите таблицу по карте ввода, измерьте снова и запустите compwright verify.|."
        " Таблица не записана: прогноз относится к следующей проверке без таблицы.}"
    ),
    "run.estimate": "Ось {axis}: оценка погрешности",
    "run.estimate_note": (
        "Что должна устранить таблица: отклонение по ходу в том состоянии, в котором его измерили,"
        " с его неопределенностью."
    ),
    "run.files": "Файлы",
    "run.files_written": "Записанные файлы",
    "run.in_english": (
        "На английском языке приведены: замечания, сомнения и причины, сведения из задания и"
        " файлов, название системы ЧПУ, содержание допущений, разделы о том, что ограничивает ось,"
        " о пользе точек и о периодах, перечень измененных записей, названия в подтверждении"
        " расчета, надписи на рисунках, параметры круговых проверок и карта ввода."
    ),
    "run.legend": (
        "Серое: до. Синее: от 5 до 95 % новых проверок в тех же заданных позициях, вертикальная"
        " черта: медиана. Штрихи: допуск."
    ),
    "run.limit_missed": "По прогнозу хотя бы один допуск не будет выдержан",
    "run.limit_open": "Хотя бы для одного допуска неясно, будет ли он выдержан",
    "run.limits": "Ось {axis}: что ее ограничивает",
    "run.limits_met": "По прогнозу все допуски будут выдержаны",
    "run.limits_met_if": "По прогнозу все допуски будут выдержаны, если указанное выше верно",
    "run.no_axis_table": "Для этой оси нет таблицы{reason:if|: {reason}}.",
    "run.no_limits": "Прогноз результата; допуски для решения не заданы",
    "run.no_statement": (
        "Заявление о соответствии: нет. Решения относятся к прогнозу следующей проверки; о станке"
        " решает протокол compwright verify."
    ),
    "run.no_table": "Таблица не записана",
    "run.no_table_for": "Таблица не записана для оси {axes}",
    "run.periods": "Ось {axis}: периоды погрешности",
    "run.points": "Таблица в числах: {count} {count:plural|точка|точки|точек}",
    "run.provenance": "Происхождение данных",
    "run.raw_readings": "Исходные отсчеты",
    "run.refusal": "Ось {axis}: {reason}.",
    "run.single": "Одна кривая и одно значение зоны нечувствительности",
    "run.state": "Ось {axis}: принятое состояние системы ЧПУ",
    "run.state_files": "Как в {files}; таблица содержит сумму прежних и добавляемых значений.",
    "run.state_none": "Нет: при измерении оси в системе ЧПУ ничего не действовало.",
    "run.state_not_given": (
        "Не указано. Без этого таблица не записывается: новая сумма должна содержать то, что уже"
        " действует."
    ),
    "run.table": (
        "Узлов: {count}, как прочитано из файлов.{wanted:if| Широкая линия: желаемое до округления"
        " и ограничений.}"
    ),
    "run.worth": "Ось {axis}: польза точек таблицы",
    "severity.error": "✗ ошибка",
    "severity.info": "сведения",
    "severity.warning": "! важно",
    "verify.comparison": "До, прогноз и после",
    "verify.comparison_note": (
        "Один масштаб. Прогноз: ожидаемые средние в заданных позициях первой проверки."
    ),
    "verify.equivalent": "неотличимо от",
    "verify.factor": "множитель",
    "verify.further_table": "еще одна таблица",
    "verify.in_english": (
        "На английском языке приведены: результат в начале, сведения о загрузке и следующем цикле,"
        " замечания, сомнения и причины, сведения из задания и файлов, название системы ЧПУ,"
        " надписи на рисунках и параметры круговых проверок."
    ),
    "verify.legend": (
        "Серое: до. Синее: прогноз от 5 до 95 %, вертикальная черта: измерено после загрузки."
        " Штрихи: допуск."
    ),
    "verify.look_at": "Проверить:",
    "verify.next_round": "{written:if|Следующий цикл|Следующего цикла нет}",
    "verify.no_further_table": "больше таблиц нет",
    "verify.outside": "вне",
    "verify.shift": "сдвиг в узлах",
    "verify.table_of": "таблица оси",
    "verify.within": "в пределах",
}
