"""Every complaint of the schema as a fault in a service engineer's words, with line, key path,
expected and found.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Iterator
from typing import Any, get_args

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from compwright.foundations.errors import Fault
from compwright.foundations.yaml_reader import KeyPath, YamlDocument

_MISSING = {
    "compwright": "1, the version of the schema",
    "controller": "a mapping with the key format",
    "format": "the id of a controller format, as `compwright formats list` shows it",
    "axes": "at least one axis",
    "travel": "[low, high] in machine coordinates, mm or deg",
    "before": "at least one measurement file",
    "files": "the measurement files of the test",
}
_NUMBER_HINTS = (
    (
        r"[-+]?0\d+(\.\d*)?",
        "a leading zero is read as an octal number by some programs, write it without",
    ),
    (
        r"[-+]?\d+(:\d+)+(\.\d*)?",
        "a colon is read as base 60 by some programs, write one decimal number",
    ),
    (r"[-+]?\d*,\d+", "write a decimal point, not a comma"),
    (r"[-+]?\d[\d_]*_[\d_.]*", "write it without underscores"),
    (r"[-+]?(0[xXoObB][0-9a-fA-F]+)", "write it as a decimal number"),
    (r"[-+]?\.?(inf|nan|Inf|NaN|INF|NAN|NaN)", "the number must be finite"),
    (
        r"[-+]?\d+(\.\d*)?\s*(mm|deg|°|um|µm|arcsec|K|in|inch)",
        "write the number alone, the unit is fixed by the key",
    ),
    (r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", "write the number without quotes"),
)
_LONGEST_SHOWN = 60
LARGEST_NUMBER = (
    1e15  # beyond it a double no longer holds every micrometre of a kilometre in nanometres
)


def too_large(value: Any) -> bool:
    """Whether a number is infinite or beyond all use, so that it must be a slip or text without
    quotes.
    """
    return isinstance(value, int | float) and not abs(value) <= LARGEST_NUMBER


def shown(value: Any) -> str:
    """Return what was found, short enough for one line."""
    if isinstance(value, dict):
        return "a mapping" if value else "an empty mapping"
    if isinstance(value, list):
        return f"a list of {len(value)}" if value else "an empty list"
    if isinstance(value, bool):
        return "true" if value else "false"
    if value is None:
        return "nothing"
    text = repr(value)
    return text if len(text) <= _LONGEST_SHOWN else f"{text[: _LONGEST_SHOWN - 3]}..."


def suggestion(word: str, known: Iterable[str]) -> str:
    """Return the nearest known name, or where none is near the list of all."""
    words = set(known)
    if not words:
        return "nothing, none is defined"
    lowered = {name.lower(): name for name in words}
    near = difflib.get_close_matches(word.lower(), list(lowered), n=1, cutoff=0.6)
    if near:
        return f"{lowered[near[0]]!r}, the nearest known name"
    return "one of " + ", ".join(sorted(words))


def schema_faults(
    error: ValidationError, model: type[BaseModel], document: YamlDocument, file: str
) -> Iterator[Fault]:
    """Yield one fault per complaint. What is no value at all is left to
    `compwright.jobs.consistency`, known key or not.
    """
    for complaint in error.errors(include_url=False):
        kind = complaint["type"]
        path = _path_in(document.data, complaint["loc"], missing=kind == "missing")
        if kind != "missing" and (complaint["input"] is None or too_large(complaint["input"])):
            continue
        message, expected = _words(complaint, model, path)
        yield Fault(
            message=message,
            file=file,
            place=document.place(path),
            expected=expected,
            found="" if kind in ("missing", "extra_forbidden") else shown(complaint["input"]),
        )


def _path_in(data: Any, location: KeyPath, *, missing: bool) -> KeyPath:
    """Return the part of a complaint's location that was really written: shorthand forms have fewer
    levels than the schema.
    """
    path: list[str | int] = []
    here = data
    for part in location:
        in_mapping = isinstance(here, dict) and part in here
        if in_mapping or (isinstance(here, list) and isinstance(part, int) and part < len(here)):
            here = here[part]
            path.append(part)
    if missing and isinstance(here, dict):
        path.append(location[-1])
    return tuple(path)


def _words(complaint: ErrorDetails, model: type[BaseModel], path: KeyPath) -> tuple[str, str]:
    """Return message and expectation of one complaint."""
    kind, found, context = complaint["type"], complaint["input"], complaint.get("ctx", {})
    if kind == "missing":
        return "is missing", _MISSING.get(str(path[-1]), "a value")
    if kind == "extra_forbidden":
        return "unknown key", suggestion(
            str(complaint["loc"][-1]), _known_keys(model, complaint["loc"][:-1])
        )
    if kind in ("float_type", "int_type", "int_from_float"):
        number = "a number" if kind == "float_type" else "a whole number"
        hint = number_hint(found) if isinstance(found, str) else ""
        return (f"is text, not a number ({hint})" if hint else "is not a number"), number
    fixed = {
        "literal_error": ("is not an accepted value", str(context.get("expected", ""))),
        "greater_than": ("is too small", f"more than {context.get('gt', 0):g}"),
        "greater_than_equal": ("is too small", f"{context.get('ge', 0):g} or more"),
        "too_short": ("is too short", f"at least {context.get('min_length')} in the list"),
        "too_long": ("is too long", f"at most {context.get('max_length')} in the list"),
        "list_type": ("is not a list", "a list: [.., ..]"),
        "dict_type": ("is not a mapping", "a mapping: {key: value}"),
        "model_type": ("is not a mapping", "a mapping: {key: value}"),
        "text_in_quotes": ("is not text", "a word, or text in quotes"),
        "one_line": ("is blank or holds control characters", "text on one line"),
        "truth_value": ("is a truth value", "a number"),
    }
    return fixed.get(kind, (complaint["msg"].lower(), ""))


def number_hint(text: str) -> str:
    """Return why ``text`` was not read as a number, empty when it does not look like one."""
    for pattern, hint in _NUMBER_HINTS:
        if re.fullmatch(pattern, text.strip()):
            return hint
    return ""


def _known_keys(model: type[BaseModel], location: KeyPath) -> list[str]:
    """Return the keys of the section at ``location``; keys of free mappings and indices of lists
    are passed over.
    """
    section = model
    for part in location:
        entry = section.model_fields.get(part) if isinstance(part, str) else None
        if entry is not None:
            section = next(_sections_in(entry.annotation), section)
    return list(section.model_fields)


def _sections_in(annotation: Any) -> Iterator[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in get_args(annotation):
        yield from _sections_in(inner)
