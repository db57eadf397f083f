"""Labels and fixed sentences of reports."""

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
    "basis.iso230_4_1996": "Сведения по ISO 230-4:1996, 4.4 и 6 (по тексту DIN ISO 230-4:1999).",
    "basis.iso230_4_2005": (
        "Сведения по ISO 230-4:1996, 4.4 и 6. Текста ISO 230-4:2005 в распоряжении не было; его"
        " пункты не указаны."
    ),
    "basis.vdi3441": (
        "Сведения по ISO 230-2:2006, 7.1. Текста VDI/DGQ 3441 в распоряжении не было; его пункты не"
        " указаны."
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
        "Составляющие по ISO 230-2:2006, приложение A. Сумма относится к одному отсчёту в конце"
        " хода. Она не равна U параметров (см. выше): там те же распределения проведены через"
        " определение параметра (JCGM 101). Все значения взяты из задания; отсутствующие считаются"
        " равными 0. Из примера стандарта не взято ни одного значения."
    ),
    "budget.setup": "Установка прибора",
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
        " движение {axis}|lobes_2=Две волны|lobes_3=Три волны|positional_tolerance=Позиционный"
        " допуск}"
    ),
    "cause.part": (
        "при {axis}{part:choose|at_positive=+|at_negative=−|at_positive_ccw=+ ↺|at_positive_cw=+"
        " ↻|at_negative_ccw=− ↺|at_negative_cw=− ↻}"
    ),
    "cause.whole": "{cause} {part}",
    "changes.summary": (
        "{count:plural|Изменяется {count} запись|Изменяются {count} записи|Изменяется {count}"
        " записей}; строк файлов УЧПУ без изменений: {untouched}. Значения приведены как в файлах,"
        " в единицах УЧПУ.{more:if| Остальные изменения ({more}) — в `changes.csv`.|}"
    ),
    "chart.angle": "Угол в °",
    "chart.correction": "Коррекция, которую УЧПУ прибавляет к заданию",
    "chart.described": (
        "{what:choose|deviations=отклонения оси {name}|reversal=зона нечувствительности оси"
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
    "circle.about": "{centre:choose|set_up= (центр установки)|own= (собственный центр)}",
    "circle.agreement": (
        "{how:choose|agrees=совпадает|differs=отличается|not_valid=недействительно}"
    ),
    "circle.cause": "{cause}  {value} {unit}",
    "circle.centre": (
        "{name:choose|common=общий центр наименьших квадратов|set-up=центр установки|ccw=центр"
        " наименьших квадратов ↺|cw=центр наименьших квадратов ↻}: {first} {x}, {second} {y}"
        " мкм{H:if|; H {H} мкм|}"
    ),
    "circle.compared": "Сравнение",
    "circle.comparison": (
        "Программа прибора: совпадает — в пределах двух стандартных ошибок нашего значения."
        " Недействительно, в скобках — так сообщает сама программа. Отличается — её модель не"
        " опубликована; наша подбирает все причины сразу, с собственной ступенью и выбросом в"
        " каждой точке реверса."
    ),
    "circle.detail": "– {part}",
    "circle.effect": "Влияние на радиус",
    "circle.effects": "Влияние, размах, мкм; отрезки: 95 %",
    "circle.fit": "модель: действие всех причин вместе",
    "circle.job": (
        "Эти строки задания переносят в таблицы и компенсацию люфта то, что они могут исправить."
        " Создайте задание командой `compwright new --from FILE... --format ID --out job.yaml` из"
        " файлов УЧПУ, укажите в нём проверку позиционирования каждой оси (его наклон исправляет"
        " масштаб), добавьте строки{file:if|, подставив вместо FILE файл каждого направления|},"
        " затем `compwright run job.yaml`."
    ),
    "circle.least_squares": "окружность наименьших квадратов, {base} мкм от номинала",
    "circle.magnified": "{setting}\nУвеличение {magnification} : 1, окружности в мкм",
    "circle.next": "Что делать дальше",
    "circle.no_table": "Ни одна таблица не исправляет эти причины. Повторите проверку после работ.",
    "circle.nominal": "номинальная траектория",
    "circle.parameter": (
        "{name:choose|G=Круговое отклонение, минимальная зона|G_lsc=по окружности наименьших"
        " квадратов|F_max=Радиальное отклонение, наибольшее|F_min=Радиальное отклонение,"
        " наименьшее|F_max_lsc=наибольшее, центр наименьших квадратов|F_min_lsc=наименьшее, центр"
        " наименьших квадратов|H=Круговой гистерезис|D=Среднее радиальное отклонение}"
    ),
    "circle.ranked": "Причины по убыванию влияния",
    "circle.run": "{sense}: G {G}, F{centre} {highest} / {lowest} мкм",
    "circle.sense": "{sense:choose|ccw=↺|cw=↻|both=оба}",
    "circle.setting": (
        "R {radius} мм{feed:if|, {feed:.5g} мм/мин|}{extent:if|, дуга {extent:.4g}° от"
        " {start:.4g}°|}"
    ),
    "circle.share": "Доля",
    "circle.shares": "Причины, доля от всех\nбледные: меньше двух стандартных ошибок",
    "circle.software": "Программа прибора",
    "circle.start": "начало {sense}",
    "circle.step": (
        "{kind:choose|squareness=Механика: проверить установку и выверку направляющих. Таблица:"
        " задание с `apply` исправляет её, если УЧПУ это может.|scale_mismatch=Проверить"
        " температуру обеих осей. Таблица: измерить {first} и {second} лазером и выполнить задание"
        " с обеими проверками.|servo_mismatch=Привод: задать {first} и {second} одинаковый"
        " коэффициент контура положения (Kv) и одинаковое упреждение.|radius_change=Измерение:"
        " повторить оба направления с одной подачей; проверить посадку прибора.|backlash=Механика:"
        " проверить гайку, опору и муфту винта {axis}. Затем исправить компенсацию люфта {axis} в"
        " УЧПУ.|lateral_play=Механика: проверить натяг и клинья направляющей"
        " {axis}.|reversal_spike=Привод: настроить компенсацию трения {axis} при реверсе. Механика:"
        " проверить смазку и скребки.|cyclic=Механика: проверить винт, его опору и крепление"
        " датчика {axis}. Таблица: не менее трёх точек на период исправляют"
        " остаток.|straightness=Механика: проверить выверку направляющей {axis}. Таблица: таблица"
        " между осями исправляет её, если она есть в УЧПУ (cross).|offset_change=Измерение:"
        " проверить центральную опору и магнитные чашки; затем повторить.|spiral=Измерение: выждать"
        " установившуюся температуру станка и прибора; затем повторить.|vibration=Искать источник"
        " по частоте: насос, вентилятор, двигатель. Привод: пробно снизить"
        " усиление.|stick_slip=Механика: проверить смазку, скребки и натяг направляющей"
        " {axis}.|master_slave=Привод: проверить параметры интерполяции {first} и {second}.}"
    ),
    "circle.symbol": (
        "{letter}{sense:if| {sense:choose|ccw=↺|cw=↻|bidirectional=оба}|}{centre:if|,"
        " {centre:choose|G=окружность наименьших квадратов|F=центр наименьших квадратов}|}"
    ),
    "circle.to_do": "{cause} ({share:.0f} % всех влияний). {step}",
    "circle.unexplained": "Не объяснено причинами ниже: {rms} мкм (СКЗ).",
    "circle.value_error": "Значение ± стандартная ошибка",
    "circle.zone": (
        "минимальная зона{sense:choose|both= обоих|ccw=, ↺|cw=, ↻}: G {G} мкм{D:if|; D {D} мкм|}"
    ),
    "decision.accept": "✓ принято",
    "decision.no_limit": "нет допуска",
    "decision.reject": "✗ отклонено",
    "decision.undecided": "? не решено",
    "fact.address": "адрес в УЧПУ",
    "fact.kind": "вид",
    "fact.quantum": "дискретность таблицы",
    "fact.unit": "единица отклонений",
    "given.approaches": "{counts}; {cycle:choose|standard=стандартный цикл|step=пошаговый цикл}",
    "given.arc": "от {start}° до {end}°, {extent}°",
    "given.at_end": "{text} {end:choose|_start=в начале|_end=в конце}",
    "given.axis": "{axis}, {kind:choose|linear=линейная ось|rotary=ось вращения}",
    "given.budget": "см. бюджет неопределенности",
    "given.centre": "центр {places:join|; } мм",
    "given.coefficient": "{value} мкм/(м·К)",
    "given.compensation": (
        "{how:choose|off=выключена; в УЧПУ было|active=включена, как действует в|stored=включена,"
        " как сохранено в} {files} (задание, states.{state})"
    ),
    "given.compensation_loaded": (
        "включена, как загружено после расчёта этого задания; что показывает проверка: см."
        " «Загрузка»"
    ),
    "given.compensation_none": "выключена: в УЧПУ ничего не действовало (задание, states.{state})",
    "given.estimator": (
        "s: {spread:choose|std=среднеквадратическое отклонение, n − 1|range=по размаху отсчётов};"
        " границы ± {coverage} s; без сглаживания"
    ),
    "given.expansion": (
        "введена compwright: отсчёты приведены к 20 °C, {what:choose|scale=шкала|workpiece=деталь}"
        " {alpha_m} мкм/(м·К) при {T_m} °C, прибор {alpha_d} мкм/(м·К) при {T_d} °C, неподвижная"
        " точка {x_fix} мм"
    ),
    "given.list": "{others:if|{others} и |}{last:if|{last}|нет}",
    "given.listed": "{items}",
    "given.of_tests": "{names}: {statement}",
    "given.programmed_feed": "мм/мин задано",
    "given.radius": "радиус {radius} мм",
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
    "limits.all": "все вместе",
    "limits.cause": (
        "{cause:choose|noise=разброс отсчётов: та же позиция не повторяется (повторяемость)|single"
        " outliers=отдельные выбросы|shifts between traverses=целые проходы со сдвигом|drift=дрейф:"
        " ось меняется во время измерения|temperature within its uncertainty=температура: наклон в"
        " пределах заявленной в задании неопределенности|error that the test leaves"
        " open=погрешность, которую проверка не показала: между заданными позициями и скрытая в"
        " разбросе|steps that the control never applies=ступени коррекции (реверс), которые УЧПУ не"
        " выполняет из-за ускорения и такта привода|no table is written=измеренная погрешность,"
        " которую не убирает ни одна таблица|spacing too wide for the period=периодическая"
        " погрешность: точки для неё слишком редки|spacing of the points=изгиб между точками"
        " таблицы|number of points=изгиб между точками: в УЧПУ их слишком мало|one table for both"
        " directions=зона нечувствительности, меняющаяся вдоль хода: одна таблица и одно значение"
        " её не вмещают|no backlash value=зона нечувствительности: в УЧПУ нет для неё"
        " значения|quantum=дискретность значений таблицы|value range=наибольшее значение, которое"
        " принимает УЧПУ|backlash range=наибольшее значение люфта, которое принимает УЧПУ|largest"
        " increment=наибольший шаг между точками, который принимает УЧПУ|a straight line instead of"
        " a table=изгиб: в УЧПУ прямая, а не таблица|={cause}}"
    ),
    "limits.left": "Остаток УЧПУ",
    "limits.note": (
        "Каждая полоса: насколько {parameter} был бы меньше без одной этой причины, по тем же"
        " выборкам. Части не складываются, потому что {parameter} — размах: действие двух причин в"
        " разных местах считается один раз."
    ),
    "limits.part": "Часть {parameter}",
    "limits.summary": (
        "{parameter} в новых заданных позициях: ожидается {then} {unit}, с нынешним содержимым УЧПУ"
        " {before} {unit}. Один разброс, без погрешности оси, дал бы {least} {unit}: меньше не даст"
        " никакая таблица."
    ),
    "mark.loading": (
        "{verdict:choose|loaded=✓ загружена|undecided=? не решено|measurement=? ошибка"
        " измерения|not_active=✗ не действует|inverted=✗ обратный знак|scaled=✗ с"
        " множителем|shifted=✗ сдвинута|mirrored=✗ зеркальная|wrong_axis=✗ не та ось|increment=✗"
        " только изменение|on_top=✗ сверх старой|state=✗ состояние|one_direction=✗ одно"
        " направление|backlash=✗ люфт|partial=✗ частично|thermal=✗ температура|=✗ {verdict}}"
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
    "period.alike": "Эти заданные позиции не различают: {periods} {unit}.",
    "period.caption": (
        "Во сколько раз отсчёты вероятнее с погрешностью, повторяющейся с данным периодом, чем без"
        " неё; обычность периода здесь ещё не учтена. Штрихи: учитываемые периоды."
    ),
    "period.described": "отношение правдоподобия каждого периода",
    "period.none": "Ни один не известен, и ни один не найден.",
    "period.over": "период / {unit}",
    "period.source": (
        "{source:choose|job=указан в задании|found=найден в отсчётах|files=указан в файлах"
        " УЧПУ|={source}}"
    ),
    "report.accreditation": (
        "Это протокол испытаний, а не свидетельство о калибровке аккредитованной лаборатории."
        " Прослеживаемость значений основана на свидетельствах о калибровке названных измерительных"
        " приборов."
    ),
    "report.acknowledged": "Принятые к сведению сомнения",
    "report.annex_a": "Приложение A: заданные позиции и исходные отсчёты",
    "report.annex_b": "Приложение B: происхождение данных",
    "report.axis": "Ось {axis:if|{axis}|без обозначения}{name:if|, {name}}",
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
        "{end:choose|highest=макс.|lowest=мин.} среднее{what:choose|A="
        " {end:choose|highest=+|lowest=−} {coverage} s|E=|M= ±}"
    ),
    "report.extremes": "Крайние значения: кольца на рисунке",
    "report.findings": "Замечания",
    "report.footer": "Протокол {number}",
    "report.in_english": (
        "Имена и тексты задания и файлов приведены как даны. Перевод ещё не проверен носителем"
        " языка; решающим является протокол на английском языке."
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
    "report.readings": "Отсчёты",
    "report.readings_air": "Отсчёты без влияния воздуха на свет",
    "report.readings_measured": "Отсчёты, как измерено",
    "report.readings_reduced": "Отсчёты, приведенные к 20 °C",
    "report.results": "Результаты",
    "report.see_tests": "см. страницы проверок",
    "report.sign_checked": "Проверил",
    "report.sign_measured": "Измерил",
    "report.sign_place": "Место, дата",
    "report.signs": (
        "Отклонение: действительная позиция минус заданная. Подход +: в положительном направлении"
        " станка. Зона нечувствительности в заданной позиции: среднее при подходе + минус среднее"
        " при подходе −; B: наибольшее по модулю."
    ),
    "report.statistics": (
        "Средние, среднеквадратические отклонения и повторяемость на {count} {count:plural|заданной"
        " позиции|заданных позициях|заданных позициях}"
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
    "run.certificate": "Подтверждение расчёта",
    "run.changes": "Старое и новое",
    "run.check_first": "Не решено: сначала проверить указанное выше",
    "run.circle_worse": "Не решено: по прогнозу одна окружность ухудшится",
    "run.comparison": "До и прогноз",
    "run.comparison_note": (
        "До коррекции и, в том же масштабе, ожидаемый результат проверки в тех же заданных"
        " позициях."
    ),
    "run.compensation": "Коррекция",
    "run.correction": "Коррекция: то, что УЧПУ прибавляет к заданию.",
    "run.cross": "Таблицы между осями",
    "run.done": (
        "Обработано: {tests} {tests:plural|проверка|проверки|проверок}, {count:plural|ось|оси|оси}"
        " {axes}, стандарт: {standards:if|{standards:and}|нет}. Погрешность оценена по всему"
        " ходу{tables:if|. Рассчитана лучшая таблица, которую может хранить"
        " {control:if|{control}|УЧПУ}; она записана в форме УЧПУ и прочитана из файлов обратно,"
        " чтобы предсказать следующую проверку. Пока ничего не загружено: загрузите таблицу по"
        " карте ввода, измерьте снова и запустите compwright verify.|. Таблица не записана: прогноз"
        " относится к следующей проверке без таблицы.}"
    ),
    "run.estimate": "Ось {axis}: оценка погрешности",
    "run.estimate_note": (
        "Что должна устранить таблица: отклонение по ходу в том состоянии, в котором его измерили,"
        " с его неопределенностью."
    ),
    "run.files": "Файлы",
    "run.files_written": "Записанные файлы",
    "run.in_english": (
        "Тексты задания, файлов и определения УЧПУ приведены как даны. На английском языке:"
        " принятые факты, причины, по которым ось не получает таблицы, и названия в свидетельстве"
        " расчёта. Перевод ещё не проверен носителем языка."
    ),
    "run.legend": (
        "Серое: до. Синее: от 5 до 95 % новых проверок в тех же заданных позициях, вертикальная"
        " черта: медиана. Штрихи: допуск."
    ),
    "run.limit_missed": "По прогнозу хотя бы один допуск не будет выдержан",
    "run.limit_open": "Хотя бы для одного допуска неясно, будет ли он выдержан",
    "run.limits": "Ось {axis}: что её ограничивает",
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
    "run.raw_readings": "Исходные отсчёты",
    "run.refusal": "Ось {axis}: {reason}.",
    "run.single": "Одна кривая и одно значение зоны нечувствительности",
    "run.state": "Ось {axis}: принятое состояние УЧПУ",
    "run.state_files": "Как в {files}; таблица содержит сумму прежних и добавляемых значений.",
    "run.state_none": "Нет: при измерении оси в УЧПУ ничего не действовало.",
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
    "verify.further_table": "ещё одна таблица",
    "verify.in_english": (
        "Тексты задания, файлов и определения УЧПУ приведены как даны. На английском языке: причины"
        " следующего этапа. Перевод ещё не проверен носителем языка."
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
    "worth.caption": (
        "Прогноз {symbol} в новых заданных позициях в зависимости от числа точек, медиана и 5–95 %."
        " Закрашенная точка: записываемая таблица{grid:if|, {grid:choose|ring=кольцо: сетка в"
        " УЧПУ|on_it=на сетке в УЧПУ}|}."
    ),
    "worth.described": "{quantity} в зависимости от числа точек",
    "worth.over": "точки таблицы",
    "worth.points": (
        "точек: {points}, шаг {spacing} {place}: {symbol} {median} {unit} ({p05} … {p95})"
    ),
    "worth.quantity": "{symbol}, {unit}",
}
