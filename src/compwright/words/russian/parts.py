"""Sentences and parts of sentences that several findings use."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "as_written": "{text}",
    "backlash_compensation_larger": (
        "{finding} Это объясняют файлы УЧПУ: компенсация люфта в них больше мёртвого хода оси."
    ),
    "better_targets": "заданные позиции, которые показали бы эту погрешность: {targets:g} {unit}",
    "between.deviation": "измеренное отклонение {output} по {input} ({slope})",
    "between.fault": (
        "{where:if|{where}: |}{message}{expected:if|; ожидалось: {expected}|}"
        "{found:if|, найдено: {found}|}{hint:if|. Далее: {hint}|}"
    ),
    "between.faults": "{faults:join|; }",
    "between.racked": (
        "{output} — ось портала, и таблица на {output} без {partner} перекашивает станок. Далее:"
        " {squareness:if|исправьте перпендикулярность смещением опорной позиции"
        " портала{instead:if| или двигайте вместо неё ось {input} (`{instead}`)|}|выверьте"
        " направляющую оси {input} и уберите эту запись из задания: другая таблица прямолинейность"
        " не исправит}"
    ),
    "between.squareness": "перпендикулярность {output} к {input} ({slope:+.1f} мкм/м)",
    "between.switches": (
        "ключ `active` задания указывает, действовала ли при измерении имеющаяся таблица {output}"
        " по {input}, а файлы ЧПУ включают её иначе. Далее: дайте файлы, в которых все"
        " переключатели такие, как при измерении, и уберите `active`"
    ),
    "circle.part": "{start:.5g}°–{end:.5g}°",
    "compared_not_removed": "{parameters:join|; }. Результат содержит все отсчёты.",
    "direct_squareness": (
        "{input} и {output}: перпендикулярность {squareness:+.1f} мкм/м по"
        " {measurements:plural|прямому измерению|сумме прямых измерений обеих осей|сумме прямых"
        " измерений обеих осей}"
    ),
    "doubts.acknowledged": "Подтверждено в задании: {reason}. {message}",
    "doubts.compare": (
        "Содержимое УЧПУ может отличаться от сравнённых файлов. Считайте его файлы ещё раз целиком"
        " и повторите compwright compare"
    ),
    "doubts.first": "Сначала проверьте эти пункты: от них зависит результат",
    "doubts.step": (
        "Ничего не решается, пока эти пункты не прояснены. Исправьте проверку или задание и"
        " повторите расчёт. Если измерение верно, укажите в задании, почему замечание"
        " несущественно: `acknowledged: {{{codes:join|: причина, }: причина}}`"
    ),
    "in_direction": "{value} в направлении {direction}",
    "increments": "{symmetric:if|±{largest}|{least} … {largest}}",
    "listed": "{items:join|; }{more:if|; и ещё {more}}",
    "listed_places": "{items}{more:if| и ещё {more}}",
    "odds.1_to": "шансы 1 к {odds:2sig}",
    "odds.above_1000": "шансы более 1000 к 1",
    "odds.over_1000": "шансы более 1000 к 1",
    "odds.to_1": "шансы {odds:2sig} к 1",
    "of_axis": "Ось {axis}: {finding}",
    "of_axis_small": "ось {axis}: {finding}",
    "of_circle": "Окружность {circle}: {finding}",
    "of_test": "Ось {axis}, проверка {test}: {finding}",
    "paragraph": "{sentences:join| }",
    "parameter": "{parameter} {value}",
    "range": "{low} … {high}",
    "read_back": (
        "Таблицы {definition} читаются обратно из своих файлов, но независимо не проверяются: что"
        " делают эти файлы, сказано только в вашем собственном определении"
    ),
    "reading_off": "{traverse} в {target} (отклонение {off})",
    "scale_by": "{axis}: ошибка масштаба {scale} по {tests:join|; }",
    "traverse": "проход {run} в направлении {direction}",
    "undetermined.bar": (
        "длина прибора не калибрована: задайте калиброванную длину или измерьте ось лазером"
    ),
    "undetermined.both_directions": (
        "значение сравнивает оба направления: измерьте полную окружность в обоих направлениях"
    ),
    "undetermined.causes": (
        "{circle}: причины нельзя определить по {samples} точкам измерения на {arc:g}° в"
        " {directions:plural|одном направлении|обоих направлениях|обоих направлениях}"
    ),
    "undetermined.few_at_reversal": (
        "на дуге слишком мало точек измерения там, где реверсирует ось {axis}"
    ),
    "undetermined.few_in_time": (
        "проход длится {time:3sig} с, и в нём слишком мало точек измерения, чтобы показать вибрацию"
    ),
    "undetermined.few_near_reversals": (
        "слишком мало точек измерения вблизи реверса оси {axis}: измерьте с меньшей подачей"
    ),
    "undetermined.full_circle": (
        "{reasons:join|; }: измерьте полную окружность в обоих направлениях"
    ),
    "undetermined.lobes": "волны относятся к замкнутой окружности",
    "undetermined.no_end": "этой точки реверса оси {axis} нет на дуге",
    "undetermined.no_reversal": "{axis} не реверсирует на дуге",
    "undetermined.of_circle": "{circle}: {reason}",
    "undetermined.one_direction": (
        "одно направление не отделяет эту причину от отставания и мёртвого хода"
    ),
    "undetermined.one_reversal": "на дуге только одна точка реверса оси",
    "undetermined.pitch": (
        "точки измерения слишком редки, чтобы показать период: снимайте чаще или уменьшите подачу"
    ),
    "undetermined.prior": (
        "{value:+3sig} ± {error:2sig} {unit} слишком неопределённо: и без проверки для станков"
        " ожидаются значения в пределах ±{width:g} (стандартное отклонение), и точки измерения"
        " почти не сужают этот диапазон"
    ),
    "undetermined.spike": (
        "точек измерения после реверса слишком мало, чтобы отличить выброс от мёртвого хода:"
        " снимайте чаще или уменьшите подачу"
    ),
    "undetermined.square": "дуга показывает не все погрешности, входящие в позиционный допуск",
    "undetermined.value": (
        "{value:+.1f} ± {error:.1f} мкм/м известно недостаточно: неопределенность (k = 2) должна"
        " быть меньше половины значения и меньше {most:g} мкм/м. Измерьте полные окружности в обоих"
        " направлениях и дайте их все. Для перпендикулярности изогнутых направляющих нужен угольник"
    ),
    "value_with_error": (
        "{unit:choose|µm/m={value:+.1f} ± {error:.1f}|={value:+.2f} ± {error:.2f}} {unit}"
    ),
    "with_and_without": "{parameter} {value} с ними, {without} без них",
}
