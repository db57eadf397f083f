"""Records from JSON, checked like a job: every fault at once, each with its key path, what was
expected and what was found.

What a record holds is said by its class alone: the types of its fields. A `Form` says where its
JSON is written otherwise.
"""

from __future__ import annotations

import base64
import binascii
import difflib
import types
from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, dataclass, field, fields, is_dataclass
from enum import Enum
from functools import cache
from typing import Any, Final, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from compwright.foundations.errors import Fault

#: No position, correction or feed of a machine tool is larger, mm, deg, mm/min.
LARGEST: Final = 1e9
#: What stands for a value that was at fault: no record is made of it.
FAULTY: Final = object()
_NUMBER: Final = f"a number, not larger than {LARGEST:g}"
_NUMBERS: Final = f"a list of numbers, none larger than {LARGEST:g}"
_PLAIN: Final[Mapping[Any, str]] = {
    str: "text",
    bool: "true or false",
    int: "a whole number",
    type(None): "null",
}
_LONGEST_SHOWN: Final = 60


@dataclass(frozen=True, slots=True, kw_only=True)
class Form:
    """How the JSON of a record is written where it is not simply field by field.

    ``keys``: the key of a field that is called otherwise. ``absent``: fields that may be missing
    (older documents lack them); they keep their default. ``constant``: fields that the JSON does
    not hold. ``inline``: the field whose own keys stand beside those of the record. ``beside``:
    keys that belong to no field; ``others``: so does every other key, and is left alone. ``read``:
    fields read by a function of their own, handed the mapping of the record.
    """

    keys: Mapping[str, str] = field(default_factory=dict)
    absent: frozenset[str] = frozenset()
    constant: Mapping[str, object] = field(default_factory=dict)
    inline: str = ""
    beside: frozenset[str] = frozenset()
    others: bool = False
    read: Mapping[str, Callable[[Reader, Mapping[str, Any], str], Any]] = field(
        default_factory=dict
    )


@cache
def _hints(cls: Any) -> Mapping[str, Any]:
    hints = get_type_hints(cls)
    return {one.name: hints[one.name] for one in fields(cls)}


@cache
def _defaults(cls: Any) -> Mapping[str, Any]:
    return {
        one.name: one.default if one.default_factory is MISSING else one.default_factory()
        for one in fields(cls)
        if one.default is not MISSING or one.default_factory is not MISSING
    }


class Reader:
    """Reads records and notes what is wrong; where something is, the value is `FAULTY`.

    ``documents``: what they are called; ``forms``: by class; ``rules``: by class, what a record
    promises beyond the types of its fields and does not keep.
    """

    def __init__(
        self,
        documents: str,
        forms: Mapping[type, Form],
        rules: Mapping[type, Callable[[Any], Iterator[str]]],
    ) -> None:
        self.faults: list[Fault] = []
        self._documents = documents
        self._forms, self._rules = forms, rules

    def record(self, data: Any, cls: type, place: str) -> Any:
        """Return a record of ``cls``; FAULTY where anything in it is wrong."""
        if not isinstance(data, dict):
            return self.wrong(place, "keys with values", data)
        form = self._forms.get(cls, Form())
        taken = set(form.beside)
        values = {
            name: self._field(data, name, hint, form, cls, place, taken)
            for name, hint in _hints(cls).items()
            if name not in form.constant and name != form.inline
        }
        if form.inline:
            rest = {key: value for key, value in data.items() if key not in taken}
            values[form.inline] = self.record(rest, _hints(cls)[form.inline], place)
        elif not form.others:
            self._unknown(data, taken, place)
        if any(value is FAULTY for value in values.values()):
            return FAULTY
        return self._kept(cls(**values, **form.constant), place)

    def _field(
        self,
        data: Mapping[str, Any],
        name: str,
        hint: Any,
        form: Form,
        cls: type,
        place: str,
        taken: set[str],
    ) -> Any:
        key = form.keys.get(name, name)
        taken.add(key)
        if key not in data:
            if name in form.absent:
                return _defaults(cls)[name]
            return self.note("a key is missing", below(place, key), "this key")
        if name in form.read:
            return form.read[name](self, data, below(place, key))
        return self.value(data[key], hint, below(place, key))

    def _unknown(self, data: Mapping[str, Any], known: set[str], place: str) -> None:
        for key in data:
            if key not in known:
                near = difflib.get_close_matches(key, sorted(known), n=1)
                expected = near[0] if near else ", ".join(sorted(known))
                self.note("unknown key", below(place, key), expected, shown(key))

    def _kept(self, record: Any, place: str) -> Any:
        rule = self._rules.get(type(record))
        broken = [] if rule is None else list(rule(record))
        for expected in broken:
            self.note("contradicts itself", place, expected)
        return FAULTY if broken else record

    def value(self, value: Any, hint: Any, place: str) -> Any:
        """Return a value of the type ``hint``; FAULTY where it is none."""
        origin = get_origin(hint)
        if origin is Literal:
            if any(type(value) is type(option) and value == option for option in get_args(hint)):
                return value
            return self.wrong(place, " or ".join(map(repr, get_args(hint))), value)
        if origin in {Union, types.UnionType}:
            return self._one_of(value, get_args(hint), place)
        if origin is np.ndarray:
            return self._array(value, place)
        if origin is tuple:
            return self._items(value, get_args(hint), place)
        if origin is not None:
            return self._mapping(value, get_args(hint), place)
        if isinstance(hint, type) and is_dataclass(hint):
            return self.record(value, hint, place)
        return self._single(value, hint, place)

    def _one_of(self, value: Any, options: tuple[Any, ...], place: str) -> Any:
        if value is None and type(None) in options:
            return None
        before = len(self.faults)
        for option in options:
            if option is not type(None):
                del self.faults[before:]
                found = self.value(value, option, place)
                if found is not FAULTY:
                    return found
        return FAULTY

    def _array(self, value: Any, place: str) -> Any:
        if not isinstance(value, list):
            return self.wrong(place, _NUMBERS, value)
        odd = next((one for one in value if not is_number(one)), None)
        if odd is not None or None in value:
            return self.wrong(place, _NUMBERS, odd)
        return np.array(value, dtype=np.float64)

    def _items(self, value: Any, hints: tuple[Any, ...], place: str) -> Any:
        endless = hints[-1] is Ellipsis
        if not isinstance(value, list) or not (endless or len(value) == len(hints)):
            return self.wrong(place, "a list" if endless else f"a list of {len(hints)}", value)
        each = [hints[0]] * len(value) if endless else hints
        items = [
            self.value(item, hint, f"{place}[{index}]")
            for index, (item, hint) in enumerate(zip(value, each, strict=True))
        ]
        return FAULTY if any(item is FAULTY for item in items) else tuple(items)

    def _mapping(self, value: Any, hints: tuple[Any, ...], place: str) -> Any:
        if not isinstance(value, dict):
            return self.wrong(place, "keys with values", value)
        found = {
            self.value(key, hints[0], below(place, key)): self.value(
                item, hints[1], below(place, key)
            )
            for key, item in value.items()
        }
        wrong = FAULTY in found or any(item is FAULTY for item in found.values())
        return FAULTY if wrong else found

    def _single(self, value: Any, hint: Any, place: str) -> Any:
        if hint is object:
            return self._anything(value, place)
        if hint is bytes:
            return self._bytes(value, place)
        if hint is float:
            return float(value) if is_number(value) else self.wrong(place, _NUMBER, value)
        if issubclass(hint, Enum):
            known = {member.value: member for member in hint}
            if isinstance(value, str) and value in known:
                return known[value]
            return self.wrong(place, " or ".join(map(repr, known)), value)
        fits = type(value) is hint and (hint is not int or is_number(value))
        return value if fits else self.wrong(place, _PLAIN[hint], value)

    def _anything(self, value: Any, place: str) -> Any:
        """Return a value whose meaning somebody else checks (an option of a control)."""
        if isinstance(value, list):
            return FAULTY if self._items(value, (object, ...), place) is FAULTY else value
        if value is None or isinstance(value, str | bool) or is_number(value):
            return value
        return self.wrong(place, f"text, true or false, null or {_NUMBER}, or a list", value)

    def _bytes(self, value: Any, place: str) -> Any:
        try:
            return base64.b64decode(value, validate=True)
        except (TypeError, ValueError, binascii.Error):
            return self.wrong(place, "bytes in base64", value)

    def wrong(self, place: str, expected: str, found: Any) -> Any:
        """Note a value that is not of its type; return FAULTY."""
        return self.note(
            f"does not fit the schema of {self._documents}", place, expected, shown(found)
        )

    def note(self, message: str, place: str, expected: str, found: str = "") -> Any:
        """Note a fault; return FAULTY."""
        self.faults.append(Fault(message=message, place=place, expected=expected, found=found))
        return FAULTY


def is_number(value: Any) -> bool:
    """Return whether a value is a finite number of a size that means something."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST


def below(place: str, key: str) -> str:
    """Return the key path of a key."""
    return f"{place}.{key}" if place else key


def shown(value: Any) -> str:
    """Return what was found, short enough for one line."""
    if isinstance(value, list | dict) and value:
        return f"a {'list' if isinstance(value, list) else 'mapping'} of {len(value)}"
    text = "null" if value is None else ascii(value)
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}..."
