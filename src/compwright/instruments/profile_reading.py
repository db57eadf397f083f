"""Read a mapping profile from YAML. All faults are reported at once."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

from pydantic_core import SchemaValidator
from pydantic_core import core_schema as cs

from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.foundations.key_faults import KeyFault, shown
from compwright.foundations.provenance import fingerprint
from compwright.foundations.record_schemas import mapping
from compwright.foundations.validation import checked, refuse, worded
from compwright.foundations.yaml_reader import read_yaml
from compwright.instruments.csv_table import traverse_of
from compwright.instruments.foreign_table import DELIMITERS
from compwright.instruments.foreign_units import ANGLES, LENGTHS
from compwright.instruments.profile import MARK, SIGNS, VERSION, Profile
from compwright.records.axis import Direction, PositionMap

#: How the approach direction of a row is known: by a column, by the order of the rows, or all
#: alike.
DIRECTION_FROM: Final = ("column", "order", "+", "-")
_CHOICES: Final[Mapping[str, tuple[str, ...]]] = {
    "layout": ("long", "wide", "own"),
    "delimiter": tuple(DELIMITERS),
    "decimal": ("point", "comma"),
    "target_unit": (*LENGTHS, *ANGLES),
    "value_is": ("deviation", "measured"),
    "unit": (*LENGTHS, *ANGLES),
    "sign": SIGNS,
    "direction_from": DIRECTION_FROM,
    "run_counts": ("runs", "traverses"),
    "cycle": ("standard", "step"),
}
#: Keys that a layout needs; further ones depend on their values.
_NEEDED: Final[Mapping[str, tuple[str, ...]]] = {
    "long": (
        *("delimiter", "decimal", "header_line", "target", "target_unit"),
        *("value", "value_is", "unit", "direction_from"),
    ),
    "wide": (
        *("delimiter", "decimal", "header_line", "target", "target_unit"),
        *("value_is", "unit", "traverses"),
    ),
    "own": (),
}
_EMPTY: Final[tuple[object, ...]] = (None, "", {})
_TRAVERSE: Final = '"+1", "-1", "+2", .. with the quotes: approach direction and run'
_DIRECTION: Final = '"+" (approached from below) or "-" (from above)'


def read_profile(content: bytes, file: str) -> Profile:
    """Return the profile in ``content``.

    Raises UsageError with every fault: a required key is empty or missing, a key is unknown, or a
    value is not one of the permitted words. Raises InputError for invalid YAML.
    """
    document = read_yaml(content, file)
    data = document.data
    if not isinstance(data, dict) or MARK not in data:
        expected = (
            f"YAML with the key {MARK}: {VERSION} (compwright profile FILE --out P.yaml writes one)"
        )
        raise UsageError(
            Fault(
                message="the file is not a mapping profile",
                file=file,
                expected=expected,
                hint="make one with `compwright profile FILE --out P.yaml`",
            )
        )
    own, faults = checked(SchemaValidator(_PROFILE), data)
    empty = list(_empty(data))
    reported = {each.path for each in empty} & {(key,) for key in _CHOICES.keys() - {"layout"}}
    faults = [each for each in faults if each.path not in reported]
    raise_all(UsageError, document.faults([*empty, *faults, *_units(data)], file))
    return Profile(file=file, sha256=fingerprint(content), **own)


def _empty(data: Mapping[str, Any]) -> Iterator[KeyFault]:
    """Yield a fault for each key that is empty although the profile's layout needs it."""
    layout = data.get("layout")
    needed = ["layout", *_NEEDED.get(layout if isinstance(layout, str) else "", ())]
    if layout in ("long", "wide") and data.get("value_is") != "measured":
        needed.append("sign")
    if layout == "long" and data.get("direction_from") == "column":
        needed += ["direction", "directions"]
    for key in needed:
        if data.get(key) in _EMPTY:
            expected = " or ".join(_CHOICES.get(key, ("the name of a column",)))
            yield KeyFault((key,), f"'{key}' is empty and must be filled in", expected)


def _units(data: Mapping[str, Any]) -> Iterator[KeyFault]:
    unit, target_unit = (
        data.get(key) if data.get(key) in _CHOICES[key] else None for key in ("unit", "target_unit")
    )
    by_layout = data.get("layout") in ("long", "wide")
    if by_layout and unit and (unit in LENGTHS) != ((target_unit or "mm") in LENGTHS):
        yield KeyFault(("unit",), "is an angle and target_unit a length, or the reverse")


def _version(value: Any) -> None:
    if value != VERSION:
        refuse(KeyFault((), "is of a version that is not known", str(VERSION), shown(value)))


def _choice(key: str, convert: Callable[[str], Any] = str) -> cs.CoreSchema:
    """Return the schema of a key that has one of a fixed list of words, which ``convert`` turns
    into the result; an empty text becomes None.
    """
    word = cs.no_info_after_validator_function(convert, cs.literal_schema([*_CHOICES[key]]))
    return cs.no_info_before_validator_function(
        lambda value: None if value == "" else value, cs.nullable_schema(word)
    )


def _text(value: Any) -> str | None:
    if isinstance(value, dict | list):
        refuse(KeyFault((), "is not text", "text", shown(value)))
    return None if value is None else " ".join(str(value).split())


def _direction(value: Any) -> Direction:
    if value not in ("+", "-"):
        empty = value in (None, "")
        message = "is empty and must be filled in" if empty else "is neither + nor -"
        refuse(KeyFault((), message, _DIRECTION, "" if empty else shown(value)))
    return Direction(value)


def _traverses(data: Mapping[str, Any]) -> dict[str, tuple[Direction, int]]:
    found: dict[str, tuple[Direction, int]] = {}
    faults = []
    for column, value in data.items():
        traverse = None if value is None else traverse_of(str(value))
        one = traverse and (Direction(traverse[0]), traverse[1])
        if one is None:
            message = (
                "is empty and must be filled in"
                if value is None
                else ("is not the name of a traverse")
            )
            faults.append(KeyFault((column,), message, _TRAVERSE, shown(value)))
        elif one in found.values():
            faults.append(KeyFault((column,), "is given twice", "", shown(value)))
        else:
            found[column] = one
    if faults:
        refuse(*faults)
    return found


def _sense(value: Any) -> int:
    if value not in (1, -1) or isinstance(value, bool):
        refuse(KeyFault((), "is neither 1 nor -1", "1 or -1", shown(value)))
    return int(value)


def _position_map(values: Mapping[str, Any]) -> PositionMap | None:
    found = PositionMap(**values)
    return None if found == PositionMap() else found


def _left_out(names: list[Any]) -> frozenset[str]:
    return frozenset(" ".join(str(one).split()) for one in names)


def _own(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of a `Profile` whose layout is ``own``; empty keys are left out."""
    names = {key: key for key in values if key != MARK} | {"value_is": "measured"}
    return {name: values[key] for key, name in names.items() if values.get(key) is not None}


_WORDS: Final = cs.dict_schema(strict=True)
_POSITION_MAP: Final = mapping(
    {
        "sense": cs.no_info_plain_validator_function(_sense),
        "offset": cs.float_schema(strict=True),
    },
    _position_map,
    optional=("sense", "offset"),
)
_KEYS: Final[Mapping[str, cs.CoreSchema]] = {
    MARK: cs.no_info_plain_validator_function(_version),
    **{key: _choice(key) for key in _CHOICES},
    "delimiter": _choice("delimiter", DELIMITERS.__getitem__),
    "decimal": _choice("decimal", {"point": ".", "comma": ","}.__getitem__),
    "value_is": _choice("value_is", "measured".__eq__),
    **dict.fromkeys(
        ("axis", "axis_column", "target", "value", "direction", "run"),
        cs.no_info_plain_validator_function(_text),
    ),
    "encoding": cs.no_info_plain_validator_function(lambda value: _text(value) or None),
    "header_line": worded(
        cs.nullable_schema(cs.int_schema(strict=True, ge=0)),
        "is not a line number",
        "1, 2, .., or 0 where there is no header row",
    ),
    "directions": cs.nullable_schema(
        cs.no_info_after_validator_function(
            lambda words: {word.casefold(): way for word, way in words.items()},
            cs.dict_schema(
                values_schema=cs.no_info_plain_validator_function(_direction), strict=True
            ),
        )
    ),
    "traverses": cs.nullable_schema(cs.no_info_after_validator_function(_traverses, _WORDS)),
    "position_map": cs.no_info_before_validator_function(
        lambda value: value or None, cs.nullable_schema(_POSITION_MAP)
    ),
    "leave_out": cs.nullable_schema(
        cs.no_info_after_validator_function(_left_out, cs.list_schema(strict=True))
    ),
}
_PROFILE: Final = mapping(_KEYS, _own, optional=_KEYS)
