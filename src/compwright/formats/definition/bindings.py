"""The bindings of a definition -> records: which field of which statement holds which quantity."""

from __future__ import annotations

from collections.abc import Mapping

from compwright.formats.definition.schema import (
    Absent,
    Binding,
    Choice,
    EvidenceNote,
    Measure,
    OptionValue,
    Plain,
)
from compwright.formats.definition.vocabulary import CHOICES, MEASURES, PLAIN, Repeated, Say, Sign
from compwright.formats.definition.yaml_fields import Node
from compwright.records.correction import Evidence

_UNITS = ("mm", "um", "inch", "pulse", "mm/m")


def evidence_of(node: Node) -> EvidenceNote:
    """Return how well a fact is known; faults go to the node."""
    part = node.keys("state", "source")
    return EvidenceNote(state=part["state"].literal(Evidence), source=part["source"].text())


def binding_of(name: str, node: Node) -> Binding | None:
    """Return the binding of a quantity by ``name``; None, with a fault, where there is no such
    quantity.
    """
    if name in MEASURES:
        return _measure(name, node)
    if name in CHOICES:
        part = node.keys(
            "statement", "field", "values", "writes", "repeated", "when_absent", "evidence"
        )
        return Choice(
            quantity=name,
            statement=part["statement"].text(),
            field=part["field"].text(),
            repeated=part["repeated"].literal(Repeated),
            when_absent=_absent(part["when_absent"]),
            evidence=evidence_of(part["evidence"]),
            values={text: word.text() for text, word in part["values"].entries()},
            writes=_word_or_option(part["writes"]),
        )
    if name in PLAIN:
        part = node.keys("statement", "field", "repeated", "when_absent", "evidence")
        return Plain(
            quantity=name,
            statement=part["statement"].text(),
            field=part["field"].text(),
            repeated=part["repeated"].literal(Repeated),
            when_absent=_absent(part["when_absent"]),
            evidence=evidence_of(part["evidence"]),
        )
    node.fault(
        "is not a quantity that compwright knows",
        expected=f"one of {', '.join((*MEASURES, *CHOICES, *PLAIN))}",
    )
    return None


def _measure(name: str, node: Node) -> Measure:
    part = node.keys(
        "statement",
        "field",
        "unit",
        "sign",
        "digits",
        "range",
        "repeated",
        "when_absent",
        "evidence",
        besides=("typed",),
    )
    unit = part["unit"].keys("linear", "rotary")
    option = part["sign"].data.get("option") if isinstance(part["sign"].data, dict) else None
    sign, sign_by, signs = (None, None, {}) if option is not None else _sign(part["sign"])
    bounds = [item.number() for item in part["range"].items()]
    if part["range"].data is not None and (len(bounds) != 2 or bounds[0] >= bounds[1]):
        part["range"].fault("is not a range", expected="two numbers, the smaller one first")
    return Measure(
        quantity=name,
        statement=part["statement"].text(),
        field=part["field"].text(),
        repeated=part["repeated"].literal(Repeated),
        when_absent=_absent(part["when_absent"]),
        evidence=evidence_of(part["evidence"]),
        linear_unit=_unit(unit["linear"]),
        rotary_unit=unit["rotary"].one_of(("deg", "mdeg", "pulse")),
        sign=sign,
        sign_by=sign_by,
        signs=signs,
        digits=part["digits"].integer(0, 9),
        range=(bounds[0], bounds[-1]) if bounds else (0.0, 0.0),
        sign_option=None if option is None else part["sign"].keys("option")["option"].text(),
        typed=part["typed"].text() if "typed" in part else "",
    )


def _unit(node: Node) -> str | OptionValue:
    if isinstance(node.data, dict):
        return OptionValue(node.keys("option")["option"].text())
    return node.one_of(_UNITS)


def _word_or_option(node: Node) -> str | OptionValue:
    if isinstance(node.data, dict):
        return OptionValue(node.keys("option")["option"].text())
    return node.text()


def _sign(node: Node) -> tuple[Sign | None, str | None, Mapping[str, Sign]]:
    if not isinstance(node.data, dict):
        return node.literal(Sign), None, {}
    choices = [name for name in node.data if name in CHOICES]
    if len(node.data) != 1 or not choices:
        node.fault(
            "has the wrong form",
            expected=f"a sign, or one of {', '.join(CHOICES)} with a sign for each of its values",
        )
        return None, None, {}
    inner = node.child(choices[0], node.data[choices[0]])
    return None, choices[0], {word: sign.literal(Sign) for word, sign in inner.entries()}


def _absent(node: Node) -> Absent | None:
    if node.is_null:
        return None
    part = node.keys("value", "say", "evidence")
    return Absent(
        value=part["value"].text(),
        say=part["say"].literal(Say),
        evidence=evidence_of(part["evidence"]),
    )
