"""Schemas of those parts of a definition that YAML states in another form than their records do."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from typing import Any, Final, get_args

from pydantic_core import SchemaValidator
from pydantic_core import core_schema as cs

from compwright.formats.definition.schema import (
    BetweenAxes,
    CardRule,
    Choice,
    Definition,
    Dialect,
    Expectation,
    Expected,
    Layout,
    LimitRule,
    LookRule,
    Measure,
    OptionRule,
    OptionValue,
    Plain,
    Statement,
    TextKind,
    WrittenFile,
)
from compwright.formats.definition.vocabulary import (
    CHOICES,
    LOOKED_AT,
    MEASURES,
    PLAIN,
    SCHEMA_VERSION,
    Sign,
    When,
)
from compwright.foundations.key_faults import KeyFault, shown, too_large
from compwright.foundations.record_schemas import RecordForm, RecordSchemas, listed, mapping
from compwright.foundations.validation import refuse

_TEXT: Final = cs.str_schema(strict=True, min_length=1)
_ANYTHING: Final = cs.any_schema()
_NEWLINES = {"lf": "\n", "crlf": "\r\n", "lfcrcr": "\n\r\r"}
_SAMPLE = "sample"
_PROVEN = ("control", "machine", "date", "how")
#: Text of a length, neither blank nor a number; numbers as large as any file of a control has them.
_PLAIN: Final[Mapping[Any, cs.CoreSchema]] = {
    str: _TEXT,
    float: cs.float_schema(strict=True, allow_inf_nan=False, gt=-1e15, lt=1e15),
    object: _ANYTHING,
}


def _word(*words: str, gives: Callable[[str], Any] = str) -> cs.CoreSchema:
    """Return the schema of a text that must be one of ``words``. ``gives``: the function that
    converts this text to the value in the record.
    """
    return cs.no_info_after_validator_function(gives, cs.literal_schema(list(words)))


def _or_mapping(other: Any, whole: Any) -> cs.CoreSchema:
    """Return a schema that checks a mapping by the schema ``whole``, and a value that is no mapping
    by the schema ``other``.
    """
    return cs.tagged_union_schema(
        {"a mapping": whole, "no mapping": other},
        lambda value: "a mapping" if isinstance(value, dict) else "no mapping",
    )


def _or_option(other: cs.CoreSchema) -> cs.CoreSchema:
    """Return a schema for a value that is either stated, in the schema ``other``, or taken from an
    option, as ``{option: NAME}``.
    """
    return _or_mapping(other, mapping({"option": _TEXT}, lambda values: OptionValue(**values)))


def _range(bounds: Any) -> tuple[float, float]:
    """Return the two bounds of a range, after checks that both are numbers and that the first is
    smaller.
    """
    if bounds is None:
        refuse(KeyFault((), "has the wrong form", "a list", shown(bounds)))
    each = bounds if isinstance(bounds, list) else []
    odd = [
        isinstance(one, bool) or not isinstance(one, int | float) or too_large(one) for one in each
    ]
    faults = [
        KeyFault((index,), "is not a number", "a finite number", shown(each[index]))
        for index, wrong in enumerate(odd)
        if wrong
    ]
    if not isinstance(bounds, list):
        faults.append(KeyFault((), "is not a list", "a list: [.., ..]", shown(bounds)))
    found = [0.0 if wrong else float(one) for one, wrong in zip(each, odd, strict=True)]
    if len(found) != 2 or found[0] >= found[1]:
        expected = "two numbers, the smaller one first"
        faults.append(KeyFault((), "is not a range", expected, shown(bounds)))
    if faults:
        refuse(*faults)
    return found[0], found[1]


def _sign() -> cs.CoreSchema:
    """Return the schema of a sign: a word, the name of an option, or one word for each possible
    value of another setting of the control (a choice).
    """
    sign = cs.literal_schema(list(get_args(Sign)))
    by_choice = cs.dict_schema(
        cs.any_schema(), cs.dict_schema(values_schema=sign, strict=True), strict=True
    )

    def one_choice(data: Any) -> Any:
        if len(data) != 1 or next(iter(data)) not in CHOICES:
            expected = f"a sign, or one of {', '.join(CHOICES)} with a sign for each of its values"
            refuse(KeyFault((), "has the wrong form", expected, shown(data)))
        return data

    return cs.tagged_union_schema(
        {
            "a word": cs.no_info_after_validator_function(lambda word: {"sign": word}, sign),
            "an option": mapping({"option": _TEXT}, lambda found: {"sign_option": found["option"]}),
            "a choice": cs.no_info_after_validator_function(
                lambda found: dict(zip(("sign_by", "signs"), *found.items(), strict=True)),
                cs.no_info_before_validator_function(one_choice, by_choice),
            ),
        },
        lambda data: (
            "a word"
            if not isinstance(data, dict)
            else "a choice"
            if data.get("option") is None
            else "an option"
        ),
    )


def _by_curves() -> cs.CoreSchema:
    """Return the schema of a text that is stated once for all tables, or twice: for axes with one
    table for both directions, and for axes with one table per direction.
    """
    both = {"one_curve": _TEXT, "two_curves": _TEXT}
    same = cs.no_info_after_validator_function(lambda text: (text, text), _TEXT)
    return _or_mapping(same, mapping(both, lambda texts: tuple(texts[name] for name in both)))


def _split_text(values: Mapping[str, Any]) -> dict[str, Any]:
    one_curve, two_curves = values["text"]
    return {**values, "text": one_curve, "two_curves": two_curves}


def _option(values: Mapping[str, Any]) -> dict[str, Any]:
    answered = values["settled_by"] or {"quantity": None, "contradiction": False}
    return {**values, "settled_by": answered["quantity"], "option_wins": answered["contradiction"]}


def _written(values: Mapping[str, Any]) -> dict[str, Any]:
    belongs = values["set"]
    when = "always" if belongs in ("complete", "optional") else belongs
    return {**values, "optional": belongs == "optional", "when": when}


def _at_least_three(points: tuple[Expected, ...]) -> tuple[Expected, ...]:
    if len(points) < 3:
        expected = "at least three, worked by hand"
        refuse(KeyFault((), "has too few positions", expected, str(len(points))))
    return points


def _with_sample(values: Mapping[str, Any]) -> dict[str, Any]:
    """Replace the word ``sample`` in hand-worked examples by the definition's sample files."""
    files = values["sample_files"]
    expect = (
        replace(one, files=files) if one.files == _SAMPLE else one for one in values["expect"]
    )
    return {**values, "expect": tuple(expect)}


_SIGN: Final = _sign()
_CURVES: Final = _by_curves()
_NEWLINE: Final = _word(*_NEWLINES, gives=_NEWLINES.__getitem__)
_BOUND: Final[Mapping[str, Any]] = {
    "linear_unit": _or_option(_word("mm", "um", "inch", "pulse", "mm/m")),
    "rotary_unit": _word("deg", "mdeg", "pulse"),
    "sign": _SIGN,
    "range": cs.no_info_plain_validator_function(_range),
    "digits": cs.int_schema(strict=True, ge=0, le=9),
}
_NUMBER: Final = _PLAIN[float]
_POINT: Final = mapping(
    {"position": _NUMBER, "positive": _NUMBER, "negative": _NUMBER},
    lambda values: Expected(**values),
)
_ANSWERED: Final = mapping(
    {
        "quantity": _TEXT,
        "contradiction": _word("refused", "option_wins", gives="option_wins".__eq__),
    },
    dict,
)
_FORMS: Final[Mapping[type, RecordForm]] = {
    Definition: RecordForm(
        nested={"sample": {"options": "sample_options", "files": "sample_files"}},
        absent=frozenset({"maker", "aliases", "parameters", "restore", "look_at"}),
        constant={"file": "", "text": None, "own": (), "maker": "", "aliases": (), "parameters": {}}
        | {"restore": (), "look_at": {}},
        types={
            "proven": listed(mapping(dict.fromkeys(_PROVEN, _TEXT), dict)),
        },
        more={
            "compwright_format": cs.int_schema(strict=True, ge=SCHEMA_VERSION, le=SCHEMA_VERSION)
        },
        build=_with_sample,
    ),
    Dialect: RecordForm(
        keys={"blanks_anywhere": "blanks"},
        types={
            "newline": _NEWLINE,
            "newlines_read": listed(_NEWLINE),
            "blanks_anywhere": _word("beside_marks", "anywhere", gives="anywhere".__eq__),
        },
        more={"encoding": _word("ascii")},
    ),
    TextKind: RecordForm(
        named="name",
        keys={"blank_lines_anywhere": "blank_lines"},
        nested={
            "comments": {"marks": "comment_marks", "where": "comments_anywhere"},
            "claims": {"at_start": "claims_at_start", "anywhere": "claims_anywhere"},
            "other_lines": {"are": "other_lines_refused", "because": "because"},
        },
        types={
            "comments_anywhere": _word("anywhere", "line_start", gives="anywhere".__eq__),
            "blank_lines_anywhere": _word("anywhere", "at_end", gives="anywhere".__eq__),
            "other_lines_refused": _word("ignored", "refused", gives="refused".__eq__),
        },
    ),
    Statement: RecordForm(named="name"),
    Layout: RecordForm(nested={"ends": {"below": "below", "above": "above"}}),
    Measure: RecordForm(
        named="quantity",
        nested={"unit": {"linear": "linear_unit", "rotary": "rotary_unit"}},
        absent=frozenset({"typed"}),
        constant={"sign_by": None, "signs": {}, "sign_option": None},
        types=_BOUND,
        build=lambda values: {**values, "sign": None, **values["sign"]},
    ),
    Choice: RecordForm(named="quantity", types={"writes": _or_option(_TEXT)}),
    Plain: RecordForm(named="quantity"),
    LimitRule: RecordForm(
        types={"number": cs.nullable_schema(cs.int_schema(strict=True, ge=1, le=10**6))}
    ),
    BetweenAxes: RecordForm(
        types={
            "instead": cs.no_info_after_validator_function(
                lambda text: text or "", cs.nullable_schema(_TEXT)
            )
        }
    ),
    OptionRule: RecordForm(
        named="name",
        keys={"whole_control": "belongs_to"},
        constant={"option_wins": False},
        types={
            "default": cs.no_info_after_validator_function(
                lambda value: tuple(value) if isinstance(value, list) else value, _ANYTHING
            ),
            "choices": cs.no_info_after_validator_function(
                lambda words: words or (), cs.nullable_schema(listed(_TEXT))
            ),
            "settled_by": cs.nullable_schema(_ANSWERED),
            "whole_control": _word("axis", "control", gives="control".__eq__),
        },
        build=_option,
    ),
    WrittenFile: RecordForm(
        constant={"optional": False, "when": "always"},
        more={"set": _word("complete", "optional", *(w for w in get_args(When) if w != "always"))},
        build=_written,
    ),
    CardRule: RecordForm(constant={"two_curves": ""}, types={"text": _CURVES}, build=_split_text),
    LookRule: RecordForm(constant={"two_curves": ""}, types={"text": _CURVES}, build=_split_text),
    Expectation: RecordForm(
        types={
            "files": cs.tagged_union_schema(
                {
                    "the sample": cs.literal_schema([_SAMPLE]),
                    "its own": cs.dict_schema(values_schema=_TEXT, strict=True),
                },
                lambda value: "the sample" if value == _SAMPLE else "its own",
            ),
            "unit": _word("um", "mm", "arcsec", "deg"),
            "at": cs.no_info_after_validator_function(_at_least_three, listed(_POINT)),
        },
    ),
}


@cache
def definition_validator(quantities: tuple[str, ...]) -> SchemaValidator:
    """Return the validator that builds a definition from its YAML data. ``quantities``: names of
    the quantities that only controls with one shape of tables have.
    """
    forms = dict(_FORMS)
    schemas = RecordSchemas(forms, {}, _PLAIN)
    looks = {str(name): schemas.of(tuple[LookRule, ...]) for name in LOOKED_AT}
    further = {"bindings": _bindings(schemas, quantities), "look_at": mapping(looks, dict)}
    whole = forms[Definition]
    forms[Definition] = replace(whole, types={**whole.types, **further})
    return schemas.validator(Definition)


def _bindings(schemas: RecordSchemas, quantities: tuple[str, ...]) -> cs.CoreSchema:
    kinds = {Measure: MEASURES, Choice: CHOICES, Plain: (*PLAIN, *quantities)}
    schema = {name: schemas.of(kind) for kind, names in kinds.items() for name in names}
    found = mapping(schema, dict, optional=schema)

    def as_written(data: Any, read: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
        made = read(data)
        return {name: made[name] for name in data}

    return schemas.named(Plain, cs.no_info_wrap_validator_function(as_written, found))
