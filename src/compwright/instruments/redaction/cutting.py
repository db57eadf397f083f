"""Copy the lines of a measurement file without private data, by the meaning of each part of a line.

The reader of the form states the meaning of each part of a line (`spans`). A part stays if its text
agrees with this meaning, such as a number in a row of readings. Everything else is removed.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Final

from compwright.foundations.redaction import Cuts
from compwright.instruments.circular_csv import PLANE
from compwright.instruments.comments import comment_text, spans_in_comment
from compwright.instruments.redaction import words
from compwright.instruments.sections import axis_name
from compwright.instruments.spans import Meaning, Spans, SpansOf

Kept = Callable[[str], bool]


def _matches(pattern: str, flags: int = re.IGNORECASE) -> Kept:
    compiled = re.compile(pattern, flags)
    return lambda text: compiled.fullmatch(text) is not None


#: Whether a text may stay, by what it is; what is not here goes.
KEPT: Final[Mapping[Meaning, Kept]] = {
    "key": lambda _: True,
    "row": words.is_numbers,
    "cell": lambda text: words.is_one_number(text) or text.lower() in {"+", "-", "ccw", "cw"},
    "numbers": words.is_numbers,
    "quantity": words.is_quantity,
    "keywords": words.is_keywords,
    "instrument": words.is_keywords,
    "result": words.is_result,
    "feature": lambda text: words.is_numbers(text) or words.is_keywords(text),
    "date": words.is_date,
    "axis": words.is_axis,
    "axis in words": lambda text: (
        words.is_axis(text) or bool(axis_name(text) and words.is_keywords(text))
    ),
    "plane": lambda text: PLANE.fullmatch(text) is not None,
    "view": _matches(r"[+-][AB][+-][AB]", flags=0),
    "sense": _matches("C?CW"),
    "product": _matches(
        r"Renishaw|(?:Renishaw )?Ballbar(?: (?:5|20|Trace))?|QC10|QC20|QC20-W"
        r"|BALLBAR_CALIBRATOR|virtual ballbar|compwright"
    ),
    "version": _matches(r"V?[0-9]{1,3}(?:\.[0-9]{1,4}){0,3}"),
    "release": _matches(r"[0-9]{1,4}(?:\.[0-9]{1,6}){0,4}"),
    "form": _matches(r"(?:positioning|circular)\s+[0-9]{1,9}"),
}
#: What becomes a remark where it goes, with its name in the count; all else becomes a name.
_REMARKS: Final[Mapping[Meaning, str]] = {
    **dict.fromkeys(("remark", "row"), "comment"),
    **dict.fromkeys(("cell", "other cell"), "cell"),
}
#: Names that are counted as what they are.
_COUNTED: Final[frozenset[Meaning]] = frozenset(
    {"machine", "serial number", "operator", "instrument", "program", "place", "title", "column"}
)


def redacted_lines(lines: Sequence[str], spans_of: SpansOf, cuts: Cuts) -> list[str]:
    """Return the lines of a file without private data, as many as the file has. ``spans_of`` gives
    the meaning of each part of the lines; ``cuts`` records what is removed.
    """
    return [_line(line, spans, cuts) for line, spans in zip(lines, spans_of(lines), strict=True)]


def _line(line: str, spans: Spans, cuts: Cuts) -> str:
    """Return a line without private data. Text without a known meaning is replaced by a neutral
    text.
    """
    if spans and spans[0].meaning == "comment":
        return redacted_comment(line, cuts)
    made, end = [], 0
    for span in spans:
        made += [_between(line[end : span.start], cuts)]
        made += [kept_or_cut(line[span.start : span.end], span.meaning, cuts)]
        end = span.end
    return "".join([*made, _between(line[end:], cuts)])


def redacted_comment(line: str, cuts: Cuts) -> str:
    """Return a comment line without private data."""
    text = comment_text(line) or ""
    if not line.lstrip(' "').startswith("#"):
        return line  # sep=;
    parts = (kept_or_cut(text[o.start : o.end], o.meaning, cuts) for o in spans_in_comment(text))
    return f"# {': '.join(parts)}".rstrip()


def _between(text: str, cuts: Cuts) -> str:
    return cuts.remark(text) if re.search(r"\w", text) else text


def kept_or_cut(text: str, meaning: Meaning, cuts: Cuts) -> str:
    """Return a text unchanged if texts of its ``meaning`` may stay. Otherwise record it in ``cuts``
    as removed, and return a neutral replacement.
    """
    bare = _bare(text)
    if not bare or (meaning in KEPT and KEPT[meaning](bare)):
        return text if bare else ""
    if meaning in _REMARKS:
        return cuts.remark(bare, _REMARKS[meaning])
    if meaning == "section":
        return cuts.name(bare.upper()).upper()
    return cuts.name(bare, meaning if meaning in _COUNTED else "name")


def _bare(text: str) -> str:
    """Return a text without surrounding blanks; if it is a quoted cell, also without the quotes."""
    bare = text.strip()
    if not bare.startswith('"') or bare.count('"') % 2:
        return bare
    cells = next(csv.reader([bare]), [])
    return cells[0].strip() if len(cells) == 1 else bare
