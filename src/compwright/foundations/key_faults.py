"""Faults of keys in a user's file, with their key path, and texts for expected and found."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from compwright.foundations.errors import Fault

KeyPath = tuple[str | int, ...]

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
_NEAREST = ", the nearest known name"
LARGEST_NUMBER = (
    1e15  # beyond it a double no longer holds every micrometre of a kilometre in nanometres
)


def key_path_text(path: KeyPath) -> str:
    """Return a key path as ``axes.X.before[0]``."""
    text = ""
    for part in path:
        text += f"[{part}]" if isinstance(part, int) else (f".{part}" if text else part)
    return text


@dataclass(frozen=True, slots=True)
class KeyFault:
    """A fault of a key in a mapping, before its file and line are known."""

    path: KeyPath
    message: str
    expected: str = ""
    found: str = ""
    hint: str = ""

    def in_file(self, file: str, place: Callable[[KeyPath], str] = key_path_text) -> Fault:
        """Return the fault with its file. ``place``: a function that writes a key path as text."""
        return Fault(
            message=self.message,
            file=file,
            place=place(self.path),
            expected=self.expected,
            found=self.found,
            hint=self.hint or usual_hint(self.path, self.message, self.expected, self.found),
        )


def usual_hint(path: KeyPath, message: str, expected: str = "", found: str = "") -> str:
    """Return the usual next step for a faulty key, such as to write one of the accepted values or
    to correct the name.

    If ``expected`` contains an example ("such as ..."), the step shows the key with this example.
    """
    if not path:
        return "correct the file; the docs of compwright describe its keys"
    *parents, key = path
    example = re.search(r"such as (.+)", expected)
    names = re.findall(r"'([^']+)'", expected)
    if message == "is missing":
        above = f"`{key_path_text(tuple(parents))}`" if parents else "the file"
        return f"add `{key}: {example[1] if example else '...'}` to {above}"
    if expected.endswith(_NEAREST) and not message.startswith("names no"):
        return f"rename it to `{names[0]}`, or remove it"
    if message == "unknown key":
        return "remove this key"
    if isinstance(key, str) and example:
        return f"write `{key}: {example[1]}`"
    if isinstance(key, str) and (message == "is not an accepted value" or _NEAREST in expected):
        near = nearest(found.strip("'"), names)
        return " or ".join(f"`{key}: {name}`" for name in ([near] if near else names)).join(
            ("write ", "")
        )
    return f"correct `{key_path_text(path)}`"


def too_large(value: Any) -> bool:
    """Return whether a number is infinite or implausibly large, so that it must be a mistake."""
    return isinstance(value, int | float) and not abs(value) <= LARGEST_NUMBER


def shown(value: Any) -> str:
    """Return a found value as text, short enough for one line."""
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


def nearest(word: str, known: Iterable[str], similarity: float = 0.6) -> str | None:
    """Return the known name most similar to a word, or None if none reaches ``similarity``."""
    lowered = {name.lower(): name for name in known}
    near = difflib.get_close_matches(word.lower(), list(lowered), 1, similarity)
    return lowered[near[0]] if near else None


def suggestion(word: str, known: Iterable[str]) -> str:
    """Return the most similar known name, or the list of all names if none is similar."""
    words = set(known)
    if not words:
        return "nothing, none is defined"
    near = nearest(word, words)
    return f"{near!r}{_NEAREST}" if near else "one of " + ", ".join(sorted(words))


def number_hint(text: str) -> str:
    """Return why ``text`` was not read as a number, or "" if it does not look like a number."""
    for pattern, hint in _NUMBER_HINTS:
        if re.fullmatch(pattern, text.strip()):
            return hint
    return ""
