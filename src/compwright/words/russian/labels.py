"""Labels and fixed sentences of reports, translated."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "basis.gost27843_2006": "Отчёт содержит сведения, которых требует ГОСТ 27843-2006, 8.1.",
    "basis.iso230_2_1988": (
        "Отчёт содержит сведения, которых требует ISO 230-2:1997, 7.1. В издании 1988 года такого"
        " перечня нет. Там, где в отчёте указан пункт, этих сведений требуют и пункты 3.2 и 4.3"
        " издания 1988 года."
    ),
    "basis.iso230_2_1997": "Отчёт содержит сведения, которых требует ISO 230-2:1997, 7.1.",
    "basis.iso230_2_2006": "Отчёт содержит сведения, которых требует ISO 230-2:2006, 7.1.",
    "basis.iso230_2_2014": (
        "Отчёт содержит сведения, которых требует ISO 230-2:2006, 7.1. Текста ISO 230-2:2014 в"
        " распоряжении не было; его пункты не указаны."
    ),
    "basis.iso230_4_1996": (
        "Отчёт содержит сведения, которых требует ISO 230-4:1996, 4.4 и 6. Использовано немецкое"
        " издание DIN ISO 230-4:1999."
    ),
    "basis.iso230_4_2005": (
        "Отчёт содержит сведения, которых требует ISO 230-4:1996, 4.4 и 6. Текста ISO 230-4:2005 в"
        " распоряжении не было; его пункты не указаны."
    ),
    "basis.vdi3441": (
        "Отчёт содержит сведения, которых требует ISO 230-2:2006, 7.1. Текста VDI/DGQ 3441 в"
        " распоряжении не было; его пункты не указаны."
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
        " {per:choose|length=по длине|test=на проверку|reading=на отсчёт}"
    ),
    "budget.expanded": "Расширенная неопределенность, k = {k}",
    "budget.misalignment_mm": "Отклонение линии измерения от направления оси",
    "budget.note": (
        "Составляющие по ISO 230-2:2006, приложение A. Сумма выше — неопределённость одного отсчёта"
        " в конце хода. Она не равна U параметра, так как U вычислена по тем же распределениям"
        " через определение параметра (JCGM 101). Все значения взяты из задания. Составляющая,"
        " которой в задании нет, считается равной 0. Из примера стандарта не взято ни одного"
        " значения."
    ),
    "budget.setup": "Установка прибора",
    "budget.steel": "принято {alpha:g} мкм/(м·К), сталь",
    "budget.sum": "{fixed:g} мкм + {per_m:g} мкм/м × {length:g} м",
    "budget.temperature_unknown": "температура неизвестна: не учтено",
    "budget.title": "Бюджет неопределенности измерений, на длине {length}",
    "cause.kind": (
        "{kind:choose|squareness=Перпендикулярность {first}{second}|scale_mismatch=Различие"
        " масштабов {first} − {second}|servo_mismatch=Рассогласование приводов {first} −"
        " {second}|radius_change=Изменение радиуса ↺ − ↻|backlash=Мёртвый ход"
        " {axis}|lateral_play=Боковой зазор {axis}|reversal_spike=Выброс при реверсе"
        " {axis}|cyclic=Периодическая погрешность {axis}|straightness=Прямолинейность"
        " {axis}|scale_error=Погрешность масштаба {axis}|backlash_mismatch=Мёртвый ход {first} −"
        " {second}|offset_change=Смещение центра {axis}, ↺ − ↻|spiral=Спираль (дрейф за"
        " проход)|master_slave=Смена ведущей оси|vibration=Вибрация|stick_slip=Скачкообразное"
        " движение {axis}|lobes_2=Две волны|lobes_3=Три волны|position_loop=Запаздывание контура"
        " положения {axis}|positional_tolerance=Позиционный"
        " допуск}"
    ),
    "cause.note": (
        "{kind:choose|reversal_spike=пик отсчётов {peak} мкм"
        "|cyclic=период {period:.4g} мм{phase:if|, фаза {phase}°|}"
        "|vibration={frequency:.4g} Гц}"
    ),
    "cause.noted": "{cause} ({note})",
    "cause.part": (
        "при {axis}{part:choose|at_positive=+|at_negative=−|at_positive_ccw=+ ↺|at_positive_cw=+"
        " ↻|at_negative_ccw=− ↺|at_negative_cw=− ↻}"
    ),
    "cause.whole": "{cause} {part}",
    "certificate.name": (
        ""
        "{key:choose|primal=прямая|stationarity=стационарность|dual=двойственная|complementarity=дополняющая"
        " нежёсткость|rounding=округление|objective=целевая функция|lower_bound=нижняя"
        " граница|recomputed=пересчитано|magnification=множитель|={name}}"
    ),
    "changes.summary": (
        "{count:plural|Изменяется {count} запись|Изменяются {count} записи|Изменяется {count}"
        " записей}; строк файлов УЧПУ без изменений: {untouched}. Значения приведены как в файлах,"
        " в единицах УЧПУ.{more:if| Остальные изменения ({more}) — в `changes.csv`.|}"
    ),
    "chart.angle": "Угол в °",
    "chart.bar": "Полоса: до {before}, сейчас {now}, предел {limit}",
    "chart.correction": "Коррекция, которую УЧПУ прибавляет к заданию",
    "chart.described": (
        "{what:choose|deviations=отклонения оси {name}"
        "|marked=отклонения оси {name}, кольца у крайних значений параметров"
        "|reversal=зона нечувствительности оси"
        " {name}|residual=остаток круговой проверки {name}|correction=коррекция оси"
        " {name}|comparison=ось {name}, отклонения рядом|estimate=оценка погрешности оси"
        " {name}|circle=круговая проверка {name}}"
    ),
    "chart.estimate": "оценка ({sign})",
    "chart.estimated": "Оценка отклонения с ± 2 стандартными отклонениями",
    "chart.expected": "ожидаемое среднее ({sign})",
    "chart.legend": "(+) и (−): подход в положительном и в отрицательном направлении",
    "chart.line": "{parts:join|   }{unit:if| {unit}|}",
    "chart.mean": "среднее ({sign})",
    "chart.measured": "измеренное среднее ({sign})",
    "chart.position": "Позиция, {unit}",
    "chart.quantiles": "{symbol} {median} ({p05} … {p95})",
    "chart.quantity": (
        "{quantity:choose|deviation=Отклонение|reversal=Зона нечувств. B|correction=Коррекция},"
        " {unit}"
    ),
    "chart.radius": "Радиус, мкм",
    "chart.readings": "отсчёты ({sign})",
    "chart.residual": "Измеренное минус модель, {sense}",
    "chart.spread": "среднее ± {coverage:g} s ({sign})",
    "chart.table": "таблица ({sign})",
    "chart.table_both": "таблица (+ и −)",
    "chart.wanted": "требуемая ({sign})",
    "decision.accept": "✓ принято",
    "decision.no_limit": "нет допуска",
    "decision.reject": "✗ отклонено",
    "decision.undecided": "? не решено",
    "fact.address": "адрес в УЧПУ",
    "fact.kind": "вид",
    "fact.quantum": "дискретность таблицы",
    "fact.unit": "единица отклонений",
    "head.after": "После",
    "head.approach": "Направление подхода",
    "head.assumed_value": "Принятое значение",
    "head.axis": "Ось",
    "head.before": "До",
    "head.cause": "Причина",
    "head.causes": "Причины",
    "head.clause": "Пункт",
    "head.contribution": "Вклад u",
    "head.correction": "Коррекция{sign:if| {sign}}",
    "head.coverage_factor": "Фактор охвата k",
    "head.decision": "Решение",
    "head.distribution": "Распределение",
    "head.entry": "Запись",
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
    "head.new": "Новое",
    "head.old": "Старое",
    "head.parameter": "Параметр",
    "head.period": "Период",
    "head.position": "Позиция",
    "head.predicted": "Прогноз",
    "head.predicted_new": "Прогноз, новые заданные позиции",
    "head.predicted_same": "Прогноз, те же заданные позиции",
    "head.probability": "Вероятность",
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
    "label.coded": "{code}: {text}",
    "label.conformity": "Заявление о соответствии: {statement}",
    "label.control": "УЧПУ",
    "label.decision_rule": "Правило решения: {rule}",
    "label.extreme_at": "{symbol} на {place} {unit}",
    "label.kind": "{kind:choose|linear=линейная ось|rotary=ось вращения}",
    "label.machine": "{key:choose|name=станок|serial=заводской номер|type=тип|={key}}",
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
    "label.test_title": (
        "Ось {axis:if|{axis}|без обозначения}, {name:if|{name}|проверка}{label:if|, {label}}"
    ),
    "label.traverses": "{count} в {sign}",
    "label.unconfirmed": "! не подтверждено",
    "label.value_error": "{value} ± {error}",
    "label.with_range": "{unit}; медиана, 5–95 %",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
    "mark.loading": (
        "{verdict:choose|loaded=✓ загружена|undecided=? не решено|measurement=? ошибка"
        " измерения|not_active=✗ не действует|inverted=✗ обратный знак|scaled=✗ с"
        " множителем|shifted=✗ сдвинута|mirrored=✗ зеркальная|wrong_axis=✗ не та ось|increment=✗"
        " загружено только изменение|on_top=✗ прибавлена к старой|state=✗ старая таблица не"
        " действовала|one_direction=✗ в одном направлении|backlash=✗ неверное значение"
        " люфта|partial=✗ действует частично|thermal=✗ тепловой наклон|read_back=✗ отличается от"
        " плана|=✗ {verdict}}"
    ),
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
    "rule.band": "{symbol} {U:if|{U} {unit}|не указано}",
    "rule.guarded": (
        "Решение с защитной полосой (ISO 14253-1): принято, если 95-й процентиль прогнозируемых"
        " проверок плюс U в пределах допуска; отклонено, если их 5-й процентиль минус U за его"
        " пределами; U (k = 2) следующей проверки, включая неопределённость, которую первая"
        " проверка внесла в таблицу: {bands}."
    ),
    "rule.guarded_after": (
        "Решение с защитной полосой (ISO 14253-1): принято, если значение плюс U в пределах"
        " допуска; отклонено, если значение минус U за его пределами; U (k = 2) проверки после"
        " загрузки: {bands}."
    ),
    "rule.simple": (
        "Принято, если 95-й процентиль прогнозируемых проверок в пределах допуска; отклонено, если"
        " их 5-й процентиль за его пределами; неопределенность измерений не учитывается: без"
        " защитных полос (ISO 14253-1)."
    ),
    "rule.simple_after": (
        "Принято, если измеренное значение в пределах допуска; отклонено, если за его пределами;"
        " неопределенность измерений не учитывается: без защитных полос (ISO 14253-1)."
    ),
    "severity.error": "✗ ошибка",
    "severity.info": "сведения",
    "severity.warning": "! важно",
}
