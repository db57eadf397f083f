"""Schemas of values in a MACHINE.yaml: numbers, lists of numbers, texts, mappings."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from itertools import pairwise
from typing import Any, Final

from pydantic_core import SchemaValidator
from pydantic_core import core_schema as cs

from compwright.foundations.key_faults import KeyFault, KeyPath, shown
from compwright.foundations.record_schemas import mapping
from compwright.foundations.validation import checked, refuse

# mm or deg, µm or arcsec: nothing on a machine is larger, or smaller and not 0
_SMALLEST, _LARGEST = 1e-9, 1e9

#: By key: the name of what a record takes, and the schema of the value.
Keys = Mapping[str, tuple[str, cs.CoreSchema]]


def number(
    convert: Callable[[float], Any] = float,
    *,
    least: float = -_LARGEST,
    above: float | None = None,
    most: float = _LARGEST,
    below: float | None = None,
) -> cs.CoreSchema:
    """Return the schema of a number, which ``convert`` turns into the result. ``least`` and
    ``most`` are themselves allowed, ``above`` and ``below`` are not.
    """

    def converted(value: float) -> Any:
        if 0.0 < abs(value) < _SMALLEST:
            refuse(KeyFault((), "is too small", f"0, or {_SMALLEST:g} or more", shown(value)))
        return convert(value)

    plain = cs.float_schema(strict=True, allow_inf_nan=False, ge=least, gt=above, le=most, lt=below)
    return cs.no_info_after_validator_function(converted, plain)


def scaled(factor: float, *, least: float = -_LARGEST, above: float | None = None) -> cs.CoreSchema:
    """Return the schema of a number that is multiplied by ``factor`` after reading. Before that it
    must be at least ``least``, and more than ``above`` if this is given.
    """
    return number(lambda value: value * factor, least=least, above=above)


def whole(least: int, most: int) -> cs.CoreSchema:
    """Return the schema of a whole number."""
    return cs.int_schema(strict=True, ge=least, le=most)


def numbers(
    factor: float = 1.0, *, length: int | None = None, at_least: int = 1, ascending: bool = False
) -> cs.CoreSchema:
    """Return the schema of a list of exactly ``length`` numbers, or else of ``at_least`` numbers or
    more, which are multiplied by ``factor`` after reading. A fault names the whole list, not the
    single number.
    """
    one = SchemaValidator(number())
    wanted = f"a list of {f'at least {at_least}' if length is None else length} numbers"

    def listed(value: Any) -> tuple[float, ...]:
        size = len(value) if isinstance(value, list) else -1
        fits = size >= at_least if length is None else size == length
        if not fits or any(checked(one, entry)[1] for entry in value):
            refuse(KeyFault((), "is not such a list", wanted, shown(value)))
        if ascending and any(later <= earlier for earlier, later in pairwise(value)):
            refuse(KeyFault((), "does not ascend", "numbers in ascending order, each once"))
        return tuple(entry * factor for entry in value)

    return cs.no_info_plain_validator_function(listed)


def _text(value: Any) -> str:
    """Return a value as text without blanks at its ends. A number keeps its written form."""
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        refuse(KeyFault((), "is not a text", "a text", shown(value)))
    text = " ".join(str(value).split())
    if not text or not text.isprintable():
        refuse(KeyFault((), "is not a text", "a text that can be printed", shown(value)))
    return text


TEXT: Final = cs.no_info_plain_validator_function(_text)


def choice(*words: str) -> cs.CoreSchema:
    """Return the schema of a text that must be one of ``words``."""
    return cs.no_info_before_validator_function(_text, cs.literal_schema(list(words)))


def either(one: cs.CoreSchema, several: cs.CoreSchema) -> cs.CoreSchema:
    """Return the schema of a single value (``one``) or a list of values (``several``)."""
    return cs.tagged_union_schema(
        {"one": one, "several": several},
        lambda value: "several" if isinstance(value, list) else "one",
    )


def record(build: Callable[..., Any], keys: Keys, needed: Collection[str] = ()) -> cs.CoreSchema:
    """Return the schema of a mapping, in which the keys ``needed`` must not be missing. Its values
    become keyword arguments of ``build``, which makes the record.
    """
    return mapping(
        {key: schema for key, (_, schema) in keys.items()},
        lambda values: build(**{keys[key][0]: value for key, value in values.items()}),
        optional=keys.keys() - set(needed),
    )


def usable(keys: Keys, data: Any) -> dict[str, Any]:
    """Return only the valid values of a mapping, by name; invalid values are left out, because
    their faults are reported elsewhere.
    """
    given = data if isinstance(data, dict) else {}
    found = {
        name: checked(SchemaValidator(schema), given[key])
        for key, (name, schema) in keys.items()
        if key in given
    }
    return {name: value for name, (value, faults) in found.items() if not faults}


def part(data: Any, *keys: str) -> Mapping[str, Any]:
    """Return the mapping found by following the nested ``keys`` one after the other, or an empty
    mapping if there is none.
    """
    for key in keys:
        data = data.get(key) if isinstance(data, dict) else None
    return data if isinstance(data, dict) else {}


def same_but_for_case(path: KeyPath, names: Collection[str]) -> Iterator[KeyFault]:
    """Yield a fault of the key ``path`` if names differ only in case, so that their files would
    have the same name.
    """
    if len({name.lower() for name in names}) < len(names):
        expected = "names that make different file names"
        yield KeyFault(path, "has names that differ in upper and lower case only", expected)
