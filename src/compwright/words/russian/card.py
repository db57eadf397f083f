"""Labels and fixed sentences of the commissioning card."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "card.adds": "УЧПУ прибавляет",
    "card.and": "{names:and}",
    "card.axis": "Ось {name}",
    "card.axis_title": "Ось {axis}, адрес в УЧПУ {address}",
    "card.capital": "{text:capital}",
    "card.check_positions": "Контрольные позиции",
    "card.circle": "Окружность {name}",
    "card.confirmed": "подтверждено",
    "card.date": "дата",
    "card.decided": "{name}: {decided:join|; }.",
    "card.evidence": "Основание: {evidence}",
    "card.expected": "Ожидаемое отклонение",
    "card.fixed": "Постоянные позиции, которые сдвигаются",
    "card.how_to_check": (
        "Выполняйте каждую проверку этой карты в этих позициях. Прочитайте, что прибавляет УЧПУ,"
        " на его индикации компенсации, если она есть. После загрузки выполните быструю проверку"
        " прибором."
    ),
    "card.inferred": "выведено",
    "card.limit": (
        "{symbol} {limit} {unit}: {decision:choose|accept=принято|reject=отклонено|=не решено}"
    ),
    "card.limits": "Допуски по прогнозу",
    "card.lines": "{texts:join|\n}",
    "card.loaded_by": "загрузил",
    "card.look_at": "{text} ({state:choose|inferred=выведено|=не подтверждено})",
    "card.measured": "измерено",
    "card.measured_by": "измерил после загрузки",
    "card.more_changes": "Ещё изменений в changes.csv: {more}.",
    "card.moves_by": "Сдвиг",
    "card.name": "Имя",
    "card.no_title": "Карта ввода в эксплуатацию",
    "card.not_confirmed": "Не подтверждено: проверьте эти сведения, прежде чем ось поедет быстро",
    "card.note": (
        "Числа в таблицах и шагах написаны с десятичной точкой, как их вводят в УЧПУ. Имена"
        " параметров, опций и файлов — как в УЧПУ и в задании.{foreign:if| Шаги вашего"
        " собственного определения не переведены и даны по-английски.} Перевод ещё не проверен"
        " носителем языка."
    ),
    "card.parameter": "{name} = {value}",
    "card.points": "УЧПУ должно вмещать не менее {points} точек для этой оси.",
    "card.proven": "Доказано",
    "card.quantity": "Величина",
    "card.rapid": (
        "Измерено на быстром ходу: люфт здесь, то, что прибавляет УЧПУ, и контрольные позиции"
        " относятся к быстрому ходу. Проверяйте на нём, а не на рабочей подаче."
    ),
    "card.read": "прочитано",
    "card.same_holds": "Этот шаг относится и к оси {axes}.",
    "card.sections": "Номера участков",
    "card.signature": (
        "Загрузил: ______________________   Дата: ______________   Измерено после загрузки: [ ]"
    ),
    "card.steps": "Шаги",
    "card.stop": "Стоп при расхождении на",
    "card.then": "{names:join|, затем }",
    "card.title": "Карта ввода в эксплуатацию: {axes}",
    "card.typed_column": (
        "{what:capital}. {total:if|Замените имеющиеся значения|Прибавьте к имеющимся значениям},"
        " {where}{total:if|, на|}: {rows} ({values:choose|correction=коррекции|error=погрешности};"
        " все строки: {sheet}{total:if||, между ними по прямой}). {more:if|В таблице станет больше"
        " строк, с тем же шагом: DATUM — позиция первой строки. В новой строке каждый другой"
        " столбец получает своё значение из ближайшей старой строки. |}{selected}{check}"
    ),
    "card.unconfirmed": "не подтверждено",
    "card.values": "Изменяемые значения",
    "card.way_back": "Путь назад",
    "card.with_unit": "{text} ({unit})",
    "card.zeroed": "Измеряйте в этом порядке, прибор установлен на ноль в первой строке.",
    "numbering.label": "номера участков",
    "numbering.mark": "— опорная позиция",
    "numbering.number": "номер",
    "numbering.parameter": "параметр",
    "numbering.position": "положение",
    "numbering.position_unit": "положение, {unit}",
    "numbering.reference": "опорная",
    "numbering.travel_negative": "ход в -",
}
