"""Write a job file as text, from values found in the control's files or from plain data.

In a job file with values from the control's files, a comment gives the source of each known value.
An unknown value is left empty, with a comment.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Prefilled:
    """A value for a new job file and its source; the value is None if the user must fill it in."""

    value: object
    source: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisDraft:
    """One axis of a new job file: its values by key, in the order of the file."""

    name: str
    values: Mapping[str, Prefilled]


def job_text(
    format_id: str,
    options: Mapping[str, Prefilled],
    files: Sequence[str],
    axes: Sequence[AxisDraft],
    *,
    active: bool | None = None,
) -> str:
    """Return the text of a new job file (schema version 1) from values found in the control's
    files. ``active``: whether compensation was active; None: unknown.

    The keys of unknown values are empty, so that `run` asks for these values.
    """
    lines = [
        "compwright: 1",
        "machine: {name: not given, serial: not given}   # for the report",
        "controller:",
        f"  format: {_plain(format_id)}",
    ]
    if options:
        lines.append("  options:")
        lines += [_line(4, name, entry) for name, entry in options.items()]
    state = _plain(list(files))
    if active is not None:
        state = f"{{files: {state}, active: {'yes' if active else 'no'}}}"
    lines += ["states:", f"  as_found: {state}   # what is in the control now", "axes:"]
    for axis in axes:
        lines.append(f"  {_plain(axis.name)}:")
        lines += [_line(4, name, entry) for name, entry in axis.values.items()]
    return "\n".join(lines) + "\n"


def _line(indent: int, name: str, entry: Prefilled) -> str:
    value = "" if entry.value is None else f" {_plain(entry.value)}"
    mark = "FILL IN: " if entry.value is None else ""
    return f"{' ' * indent}{name}:{value}   # {mark}{entry.source}"


def _plain(value: object) -> str:
    """Return a value as YAML on one line: plain words, and everything else as JSON."""
    if isinstance(value, str) and _is_word(value):
        return value
    return json.dumps(value, ensure_ascii=False)


def data_text(data: Mapping[str, Any], heading: Sequence[str]) -> str:
    """Return a whole job as YAML below the comment lines ``heading``."""
    lines = [f"# {line}" for line in heading]
    for key, value in data.items():
        if key in _SPREAD and isinstance(value, Mapping) and value:
            lines.append(f"{word(key)}:")
            for name, inner in value.items():
                lines += _spread(name, inner, 2)
        else:
            lines += _entry(key, value, 0)
    return "\n".join(lines) + "\n"


#: Keys under which every name gets lines of its own.
_SPREAD = frozenset({"axes", "states"})


def _spread(name: str, value: object, indent: int) -> list[str]:
    """Return a key with its value as YAML lines, one line per key of a mapping."""
    if not (isinstance(value, Mapping) and value):
        return _entry(name, value, indent)
    lines = [f"{' ' * indent}{word(name)}:"]
    for key, inner in value.items():
        lines += _entry(key, inner, indent + 2)
    return lines


def _entry(key: str, value: object, indent: int) -> list[str]:
    """Return a key and its value as YAML: one line, or a line each for a list of mappings."""
    start = f"{' ' * indent}{word(key)}:"
    if isinstance(value, list) and value and all(isinstance(each, Mapping) for each in value):
        return [start, *(f"{' ' * indent}  - {flow(each)}" for each in value)]
    return [f"{start} {flow(value)}"]


def flow(value: object) -> str:
    """Return a value as YAML on one line."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{word(key)}: {flow(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(flow, value)) + "]"
    return word(value) if isinstance(value, str) else json.dumps(value)


def word(text: str) -> str:
    """Return text as a plain YAML word, or in quotes with special characters escaped."""
    if _is_word(text):
        return text
    quoted = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{"".join(map(_shown, quoted))}"'


def _shown(character: str) -> str:
    return character if character.isprintable() else f"\\U{ord(character):08x}"


def _is_word(text: str) -> bool:
    known = re.fullmatch(r"[A-Za-z][A-Za-z0-9_.-]*", text) is not None
    return known and text.lower() not in _RESERVED


_RESERVED = frozenset({"true", "false", "yes", "no", "on", "off", "null", "y", "n"})
