"""Comment lines ``# key: value`` that describe a test. Unknown keys and free text are kept as
text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final

from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.spans import Spans, TextSpan, by_key, whole
from compwright.records.positioning import Cycle

#: Keys that decide how a file is understood: they may not contradict themselves.
DECISIVE_KEYS = frozenset({"axis", "cycle", "deviation", "compensated_for", "unit", "compwright"})
#: All keys with a fixed spelling in the header; a file may write them in any case, with blanks or
#: hyphens for the underscore.
KNOWN_KEYS = DECISIVE_KEYS | {"machine", "serial", "date", "instrument", "operator"}
#: Keys that say something in files of any program, in the spelling of `plain_key`, with what their
#: values are. All others are free text.
KEYS: Final = by_key(
    {
        "axis": ("axis",),
        "date": (
            *("date", "date_started", "date_completed", "time"),
            *("datum", "messdatum", "uhrzeit", "datum/uhrzeit"),
        ),
        "quantity": (
            *("temperature", "temperatur", "air_temperature"),
            *("t_m", "t_m_start", "t_m_end", "t_d", "t_d_start", "t_d_end"),
        ),
        "keywords": (
            *("unit", "units", "cycle", "deviation", "compensated_for"),
            *("calibrated", "direction"),
        ),
        "numbers": ("nominal_radius_mm", "feed_mm_min", "centre", "targets", "runs"),
        "form": ("compwright",),
        "plane": ("plane",),
        "machine": ("machine",),
        "serial number": ("serial", "serial_no"),
        "operator": ("operator", "by"),
        "instrument": ("instrument",),
        "remark": ("simulated",),
    }
)
#: Under this key of the header stand the comment lines that are not ``key: value``.
FREE_TEXT = "comment"

_KEY_VALUE = re.compile(r"(?P<key>[^\W\d_][\w .()/-]*?)\s*:(?!//)\s*(?P<value>.*)")
SEPARATOR_START = ("s", "S", '"')
_SEPARATOR_LINE = re.compile(r'"?sep=.?"?', re.IGNORECASE)
_SIGNS = {"measured minus target": 1.0, "target minus measured": -1.0}


@dataclass(frozen=True, slots=True)
class Comments:
    """The keys and texts in the comment lines. ``places``: lines of keys that affect the result."""

    header: dict[str, str] = field(default_factory=dict)
    places: dict[str, str] = field(default_factory=dict)

    def get(self, key: str) -> str:
        """Return the value of a key, or an empty text if the file does not have the key."""
        return self.header.get(key, "")


def comment_text(line: str) -> str | None:
    """Return the text of a comment line, or None for any other line.

    If a spreadsheet saves a comment as one cell of a row, it adds quotes and delimiters at the end;
    both are removed here. A line ``sep=;``, which sets the delimiter for a spreadsheet, is a
    comment too.
    """
    if line[:1] in SEPARATOR_START and _SEPARATOR_LINE.fullmatch(line.strip()):
        return ""
    if "#" not in line:  # nearly every line of a file
        return None
    stripped = line.strip().rstrip(",;\t ")
    if (
        stripped.startswith('"')
        and stripped.endswith('"')
        and stripped[1:].lstrip().startswith("#")
    ):
        stripped = stripped[1:-1].replace('""', '"').strip()
    return stripped.lstrip("#").strip() if stripped.startswith("#") else None


def plain_key(written: str) -> str:
    """Return a key in standard form: lower case, with ``_`` for blanks and hyphens."""
    return re.sub(r"[ -]+", "_", written).lower()


def spans_in_comment(text: str) -> Spans:
    """Return the parts of a comment line's text, each with its meaning, such as ``key``."""
    match = _KEY_VALUE.fullmatch(text)
    meaning = KEYS.get(plain_key(match["key"])) if match is not None else None
    if match is None or meaning is None:
        return whole(text, "remark")
    return TextSpan(*match.span("key"), "key"), TextSpan(match.start("value"), len(text), meaning)


def read_comments(
    lines: Iterable[tuple[int, str]],
    faults: FaultList,
    *,
    any_key: bool = True,
    decisive: frozenset[str] = DECISIVE_KEYS,
) -> Comments:
    """Return the keys and free texts of comment lines. ``any_key``: unknown keys are keys too, not
    free text; ``decisive``: the keys that change the result of the evaluation.

    ``lines``: the number of each line and its text without ``#``. If ``any_key`` is False, only
    known keys are keys, and all other text is free text. The key ``unit`` is then free text too,
    because files of the form `target_data` explain their own key UNIT in such a line.

    A decisive key that is given twice with different values is a fault. Any other key that is given
    several times keeps all its values, one per line.
    """
    comments = Comments()
    for number, text in lines:
        match = _KEY_VALUE.fullmatch(text)
        written, value = (match["key"], match["value"].strip()) if match else (FREE_TEXT, text)
        known = plain_key(written)
        if match and known in (KNOWN_KEYS | decisive) and (any_key or known != "unit"):
            written = known
            if known in decisive:
                _take_decisive(comments, known, value, f"line {number}", faults)
                continue
        elif not any_key or not match:
            written, value = FREE_TEXT, text
        if value or match:
            before = comments.header.get(written)
            comments.header[written] = value if before is None else f"{before}\n{value}"
    return comments


def _take_decisive(comments: Comments, key: str, value: str, place: str, faults: FaultList) -> None:
    before = comments.header.get(key)
    if before is not None and before != value:
        faults.add(
            f"key '{key}' is given twice",
            place=place,
            expected=shown(before),
            found=shown(value),
            hint="keep one of the two lines",
        )
        return
    comments.header[key] = value
    comments.places.setdefault(key, place)


def cycle_of(comments: Comments, faults: FaultList) -> Cycle | None:
    """Return the test cycle of ISO 230-2 in the file (standard or step cycle), or None if not
    stated.
    """
    value = comments.get("cycle").lower()
    if value == "standard":
        return "standard"
    if value == "step":
        return "step"
    if value:
        faults.add(
            "key 'cycle' has an unknown value",
            place=comments.places["cycle"],
            expected="standard or step",
            found=shown(value),
            hint="write `# cycle: standard` or `# cycle: step`",
        )
    return None


def sign_of(comments: Comments, faults: FaultList) -> float | None:
    """Return the factor (1, -1) from the file's deviations to measured minus target, None if the
    file does not state their sign.
    """
    value = " ".join(comments.get("deviation").lower().split())
    if value and value not in _SIGNS:
        faults.add(
            "key 'deviation' has an unknown value",
            place=comments.places["deviation"],
            expected="'measured minus target' or 'target minus measured'",
            found=shown(value),
            hint=(
                "write `# deviation: measured minus target`, or `# deviation: target minus"
                " measured`"
            ),
        )
    return _SIGNS.get(value)
