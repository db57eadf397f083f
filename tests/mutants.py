"""A mutation per fact of a definition: each fact that decides an output is removed or turned, and
some check has to fall.

``mutants("fanuc-30i")`` yields (name, text), the text a definition merged from all that it extends,
ready for `definition_in`, or as bytes of YAML for a command (`as_yaml`). ``falls(text, checks)``
loads it and returns the name of the first check that falls; empty: nothing noticed. A check is a
function of a definition that raises.

What only people read (evidence, help, the sentences of the card) and what the checks themselves are
(sample, expect) is not turned. A missing key is refused by the reader, whatever it says: that is
tested once, in test_formats_definitions.py. So "removed" is here a whole entry: a quantity, a
statement, a limit, an option, a form that is read too, an element of a list.
"""

from __future__ import annotations

import itertools
import json
import re
from collections.abc import Callable, Iterator, Mapping
from copy import deepcopy
from dataclasses import replace
from typing import Any, get_args

from compwright.formats.definition import vocabulary
from compwright.formats.definition.inheritance import DefinitionText, found_in, merged, texts_of
from compwright.formats.definition.schema import Definition
from compwright.formats.definitions import definition_in
from compwright.foundations.errors import CompwrightError
from compwright.foundations.key_faults import KeyPath, key_path_text
from compwright.foundations.session import Session
from compwright.foundations.storage import definition_files
from compwright.records.correction import Beyond

Check = Callable[[Definition], None]

#: Sections whose facts decide what is read, written or refused.
_SECTIONS = ("addresses", "dialect", "texts", "statements", "layout", "bindings", "diameter",
             "limits", "options", "writing")  # fmt: skip
#: Sections whose entries can be left out.
_ENTRIES = ("bindings", "statements", "limits", "options", "writing")
#: What only people read.
_WORDS = {"evidence", "help", "because", "card", "title", "asked", "say"}
#: Closed lists by the key under which their words stand.
_CLOSED: Mapping[str, tuple[str, ...]] = {
    "type": get_args(vocabulary.AddressType),
    "case": get_args(vocabulary.Case),
    "where": ("anywhere", "line_start"),
    "blank_lines": ("anywhere", "at_end"),
    "are": ("ignored", "refused"),
    "blanks": ("beside_marks", "anywhere"),
    "rest": ("none", "anything"),
    "pairing": get_args(vocabulary.Pairing),
    "below": get_args(Beyond),
    "above": get_args(Beyond),
    "repeated": ("same", "last"),
    "sign": get_args(vocabulary.Sign),
    "linear": ("mm", "um", "inch", "pulse"),
    "rotary": ("deg", "mdeg", "pulse"),
    "tables": get_args(vocabulary.DiameterTables),
    "belongs_to": ("axis", "control"),
    "contradiction": ("refused", "option_wins"),
    "newline": ("lf", "crlf"),
}
#: Types of fields, each with one that reads less.
_FIELD = {"bit": "key", "decimal": "integer", "real": "integer", "key": "bit"}
_ABSENT = {"value": "0", "say": "nothing", "evidence": {"state": "inferred", "source": "turned"}}


def mutants(format_id: str, *, beside: str = "") -> Iterator[tuple[str, DefinitionText]]:
    """Yield every mutant of a definition that ships, by a name that says where and what.

    ``beside``: another definition; only facts that differ from its own are turned then.
    """
    whole = merged_definition(format_id)
    known = merged_definition(beside).data if beside else None
    for section in _SECTIONS:
        path = (section,)
        for what, turned, change in _below(path, whole.data[section], whole.data):
            if known is not None and _at(known, turned) == _at(whole.data, turned):
                continue
            data = _copied(whole.data, turned)
            change(data)
            yield f"{key_path_text(turned)}: {what}", replace(whole, data=data)


def as_yaml(text: DefinitionText, identity: str) -> bytes:
    """Return a mutant as a file for a command, under an id of its own (JSON is YAML)."""
    return json.dumps({**text.data, "id": identity}, indent=1).encode()


def falls(text: DefinitionText, checks: Mapping[str, Check]) -> str:
    """Return the name of the first check that falls, ``loading`` where it is not even read; empty
    where nothing notices.
    """
    try:
        definition = definition_in(text)
    except CompwrightError:
        return "loading"
    for name, check in checks.items():
        try:
            check(definition)
        except Exception:  # noqa: BLE001 - whatever falls has noticed
            return name
    return ""


def merged_definition(format_id: str) -> DefinitionText:
    """Return a definition that ships, merged with all that it extends."""
    files = dict(definition_files(Session()))
    name = f"{format_id}.yaml"
    return merged(texts_of(files[name], name, found_in(files)))


def _copied(data: Any, path: KeyPath) -> Any:
    """Return a copy of a definition's data that may be changed at a place, and may lose quantities."""
    copy = dict(data)
    for name in {"bindings", "layout"} - {path[0]}:
        copy[name] = dict(copy[name])
    here = copy
    for part in path[:-1]:
        here[part] = here[part].copy()
        here = here[part]
    return copy


_Turn = tuple[str, KeyPath, Callable[[Any], None]]


def _below(path: KeyPath, value: Any, root: Mapping[str, Any]) -> Iterator[_Turn]:
    """Yield what can be turned at a place and below it: words, place, and the change."""
    if path[-1] in _WORDS:
        return
    if len(path) == 2 and path[0] in _ENTRIES:
        yield "removed", path, lambda data: _drop(data, path)
    own = _OWN_TURNS.get(str(path[-1]))
    if own is not None and (value is None or isinstance(value, (list, dict))):
        yield from own(path, value)
    elif isinstance(value, dict):
        for name, below in value.items():
            yield from _below((*path, name), below, root)
    elif isinstance(value, list):
        for index, one in enumerate(value):
            if isinstance(one, dict):
                yield from _below((*path, index), one, root)
            else:
                without = [each for place, each in enumerate(value) if place != index]
                yield f"without {one}", path, _setting(path, without)
    else:
        for other in _others(path, value, root):
            yield f"{value} -> {other}", path, _setting(path, other)


def _absent(path: KeyPath, value: Any) -> Iterator[_Turn]:
    yield "missing is zero", path, _setting(path, None if value else _ABSENT)


def _exchanged(path: KeyPath, value: Any) -> Iterator[_Turn]:
    words = list(value.values())
    swapped = dict(zip(value, (*words[1:], words[0]), strict=True))
    yield "words exchanged", path, _setting(path, swapped)


def _bounds(path: KeyPath, value: list[float]) -> Iterator[_Turn]:
    for index, bound in enumerate(value):
        for factor in (0.5, 2):
            turned = list(value)
            turned[index] = bound * factor if bound else (factor - 1) * 10
            yield f"bound {bound} -> {turned[index]}", path, _setting(path, turned)


_OWN_TURNS: Mapping[str, Callable[[KeyPath, Any], Iterator[_Turn]]] = {
    "range": _bounds,
    "when_absent": _absent,
    "values": _exchanged,
}


def _others(path: KeyPath, value: Any, root: Mapping[str, Any]) -> Iterator[Any]:
    """Yield what could stand in the place of a single value."""
    key, parent = path[-1], _at(root, path[:-1])
    if path[0] == "options":
        yield from _options(key, value, parent)
    elif len(path) > 2 and path[-2] == "fields":
        if key in _bound(root, path[1]):
            yield _FIELD.get(value, "bit")
    elif isinstance(value, bool):
        yield not value
    elif isinstance(value, (int, float)):
        yield from (value - 1, value + 1)
    elif key in ("form", "recognised_by", "sections", "block_number", "line_checksum"):
        bound = _bound(root, path[1]) if path[0] == "statements" else set()
        yield from _forms(value or "", parent, bound)
    else:
        yield from _words(str(key), value, parent, root)


def _words(key: str, value: Any, parent: Any, root: Mapping[str, Any]) -> Iterator[Any]:
    """Yield other words of a closed list, other names of statements and fields."""
    if key in _CLOSED:
        yield from (word for word in _CLOSED[key] if word != value)
    elif key in ("statement", "rows", "within"):
        yield next(name for name in root["statements"] if name != value)
    elif key == "field":
        fields = root["statements"][parent["statement"]]["fields"]
        yield from (name for name in fields if name != value)
    elif key == "writes":
        yield from (text for text in parent["values"] if text != value)
    elif key == "set":
        yield "optional" if value == "complete" else "complete"
    elif key == "value" and isinstance(value, str):
        yield "1" if value == "0" else "0"


def _options(key: object, value: Any, rule: Mapping[str, Any]) -> Iterator[Any]:
    """Yield other values of a key of an option; its type decides what fits."""
    if key == "default":
        if rule["choices"]:
            yield from (one for one in rule["choices"] if one != value)
        elif rule["type"] in ("number", "integer"):
            yield 1_000_000 if value is None else value + 1
    elif key == "type" and value != "choice":
        yield "integer" if value == "number" else "number"
    elif key in _CLOSED and key != "type":
        yield from (word for word in _CLOSED[str(key)] if word != value)


def _bound(root: Mapping[str, Any], statement: object) -> set[str]:
    """Return the fields of a statement that say something: those of quantities, and whose it is."""
    return {"axis", "number", "key", "position"} | {
        bound["field"] for bound in root["bindings"].values() if bound["statement"] == statement
    }


def _forms(form: str, parent: Any, bound: set[str]) -> Iterator[str]:
    """Yield a form with one word of it changed, or two fields of one kind exchanged, one of them
    ``bound``.
    """
    for found in re.finditer(r"\{[^}]*\}|([A-Za-z0-9_$]+)", form):
        if found[1]:
            last = found[1][-1]
            other = str((int(last) + 1) % 10) if last.isdigit() else ("X" if last != "X" else "Y")
            yield f"{form[: found.end() - 1]}{other}{form[found.end() :]}"
    fields = parent.get("fields", {})
    named = re.findall(r"\{(\w+)\}", form)
    for one, two in itertools.pairwise(named):
        if fields.get(one) == fields.get(two) and not bound.isdisjoint((one, two)):
            first, second = "{" + one + "}", "{" + two + "}"
            parts = (part.replace(second, first) for part in form.split(first))
            yield second.join(parts)


def _at(data: Any, path: KeyPath) -> Any:
    for part in path:
        try:
            data = data[part]
        except (KeyError, IndexError, TypeError):
            return None
    return data


def _setting(path: KeyPath, value: Any) -> Callable[[Any], None]:
    def change(data: Any) -> None:
        _at(data, path[:-1])[path[-1]] = deepcopy(value)

    return change


def _drop(data: Any, path: KeyPath) -> None:
    """Take an entry out; of a quantity also its name among those that stand alone, of a statement
    the quantities that it holds.
    """
    del _at(data, path[:-1])[path[-1]]
    gone = [path[-1]] if path[0] == "bindings" else []
    if path[0] == "statements":
        gone = [name for name, bound in data["bindings"].items() if bound["statement"] == path[-1]]
        for name in gone:
            del data["bindings"][name]
    data["layout"]["singles"] = [name for name in data["layout"]["singles"] if name not in gone]
