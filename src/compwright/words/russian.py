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
    "given.approaches": "{counts}; {cycle:choose|standard=стандартный цикл|step=шаговый цикл}",
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
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.radius": "радиус {radius} mm",
    "given.samples": "точек измерения: {counts}",
    "given.sense": "{sense:choose|ccw=против часовой стрелки|cw=по часовой стрелке}",
    "given.smoothing": "compwright не сглаживает: учтена каждая точка",
    "given.statements": "{statements:join|; }",
    "given.targets": "{count}, от {first} до {last} {unit}; перечень в приложении A",
    "head.approach": "Направление подхода",
    "head.clause": "Пункт",
    "head.contribution": "Вклад u",
    "head.coverage_factor": "Фактор охвата k",
    "head.distribution": "Распределение",
    "head.expanded_uncertainty": "Расширенная неопределенность U",
    "head.extreme": "Крайнее значение",
    "head.file": "Файл",
    "head.item": "Сведения",
    "head.mean": "среднее {sign}",
    "head.parameter": "Параметр",
    "head.position": "Позиция",
    "head.remark": "Примечание",
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
    "label.extreme_at": "{symbol} на {place} {unit}",
    "label.not_stated": "не указано",
    "label.plus_minus": "± {U}",
    "label.test_sentence": (
        "{standard}, {cycle:choose|standard=стандартный цикл|step=шаговый цикл}, {targets}"
        " {targets:plural|заданная позиция|заданные позиции|заданных позиций}, проходы:"
        " {counts:if|{counts}|нет}, границы ± {coverage} s.{extremes:if| Крайние значения:"
        " {extremes:join|; }.}{uncertainty:if|| Неопределенности измерений нет: составляющие не"
        " указаны.}"
    ),
    "label.test_title": "Ось {axis}, {name:if|{name}|проверка}{label:if|, {label}}",
    "label.traverses": "{count} в {sign}",
    "label.with_uncertainty": "{unit}; ± U, k = {k}",
    "label.with_unit": "{value} {unit}",
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
    "report.acknowledged": "Подтвержденные сомнения",
    "report.annex_a": "Приложение A: заданные позиции и исходные отсчеты",
    "report.annex_b": "Приложение B: происхождение данных",
    "report.axis": "Ось {axis}{name:if|, {name}}",
    "report.both": "оба",
    "report.circle": "Окружность {plane}{name:if|, {name}}",
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
    "report.operator": "Оператор",
    "report.page": "Страница",
    "report.page_of": "из",
    "report.parameters": "Параметры",
    "report.place": "Место",
    "report.provenance": (
        "Обработано compwright {version}.{command:if| Команда, которая повторяет протокол:}"
    ),
    "report.readings": "Отсчеты",
    "report.readings_measured": "Отсчеты, как измерено",
    "report.readings_reduced": "Отсчеты, приведенные к 20 °C",
    "report.results": "Результаты",
    "report.see_tests": "см. страницы проверок",
    "report.sign_checked": "Проверил",
    "report.sign_measured": "Измерил",
    "report.sign_place": "Место, дата",
    "report.signs": (
        "Отклонение: действительная позиция минус заданная. Подход +: в положительном направлении"
        " станка. B: среднее при подходе + минус среднее при подходе −."
    ),
    "report.statistics": (
        "Средние, среднеквадратические отклонения и повторяемость на {count}"
        " {count:plural|заданной позиции|заданных позициях|заданных позициях}"
    ),
    "report.title": "Протокол испытаний{tests:plural||: {tests} проверки|: {tests} проверок}",
    "report.unread": "Необработанные файлы",
    "severity.error": "✗ ошибка",
    "severity.info": "сведения",
    "severity.warning": "! важно",
}
