"""A job file as text, prefilled: what is known stands in it with its source, what is not is left
open and said.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Prefilled:
    """A value with where it comes from; ``value`` None: the user has to fill it in, ``source`` says
    what is expected.
    """

    value: object
    source: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisDraft:
    """One axis of a draft: values by key of the job file, in the order in which they are
    written.
    """

    name: str
    values: Mapping[str, Prefilled]


def job_text(
    format_id: str,
    options: Mapping[str, Prefilled],
    files: Sequence[str],
    axes: Sequence[AxisDraft],
) -> str:
    """Return a job file (schema version 1). Open values stand as empty keys, so that `run` asks for
    them.
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
    lines += [
        "states:",
        f"  as_found: {_plain(list(files))}   # what is in the control now",
        "axes:",
    ]
    for axis in axes:
        lines.append(f"  {_plain(axis.name)}:")
        lines += [_line(4, name, entry) for name, entry in axis.values.items()]
    return "\n".join(lines) + "\n"


def _line(indent: int, name: str, entry: Prefilled) -> str:
    value = "" if entry.value is None else f" {_plain(entry.value)}"
    mark = "FILL IN: " if entry.value is None else ""
    return f"{' ' * indent}{name}:{value}   # {mark}{entry.source}"


def _plain(value: object) -> str:
    """Return a value as YAML on one line: words as they are, everything else as JSON, which YAML
    reads too.
    """
    if (
        isinstance(value, str)
        and re.fullmatch(r"[A-Za-z][A-Za-z0-9_.-]*", value)
        and value.lower() not in _RESERVED
    ):
        return value
    return json.dumps(value, ensure_ascii=False)


_RESERVED = frozenset({"true", "false", "yes", "no", "on", "off", "null", "y", "n"})
