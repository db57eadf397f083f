"""Texts of laser software without what is somebody's: sections with keys and rows (``.rtl``,
``.rta``, ``.pos``), the compensation text (``.ren``), and ``TGT_DATA[1]=...``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Final

from compwright.foundations.redaction import NEUTRAL, Cuts
from compwright.instruments.redaction.key_lines import Kept, redacted_comment
from compwright.instruments.redaction.words import (
    is_axis,
    is_date,
    is_keywords,
    is_numbers,
    is_quantity,
)
from compwright.instruments.sections import axis_name

_SECTION: Final = re.compile(r"\s*(?P<name>[A-Z][A-Z0-9 _-]*?)\s*::\s*", re.IGNORECASE)
_KEY: Final = re.compile(r"(?P<key>\s*[A-Za-z][\w .-]*?)(?P<mark>\s*:(?!:)\s*)(?P<value>.*?)\s*")
_SECTIONS: Final = frozenset(
    {
        *("HEADER", "TARGET DATA", "USER-TEXT", "RUNS", "DEVIATIONS", "EQUIPMENT", "ENVIRONMENT"),
        *("ENVIRONMENT DATA", "EOF", "ANALYSIS"),
    }
)
#: Sections whose rows are readings.
_ROWS: Final = frozenset({"TARGET DATA", "RUNS", "DEVIATIONS"})
_VERSION: Final = re.compile(r"V?[0-9]{1,3}(?:\.[0-9]{1,4}){0,3}", re.IGNORECASE)
_TITLE: Final = re.compile(
    r"\s*Position\s+(?:Bidirectional|Forward|Reverse|Backward)(?:\s+Directional)?"
    r"\s+Avg\.?\s+Error",
    re.IGNORECASE,
)
_KEYS: Final[Mapping[str, Kept]] = {
    **dict.fromkeys(("file type", "filetype", "owner", "unit", "units"), is_keywords),
    "version no": lambda text: _VERSION.fullmatch(text) is not None,
    **dict.fromkeys(("target-count", "targets", "flags", "run-count"), is_numbers),
    **dict.fromkeys(("air temp", "air press", "air pressure", "air humid"), is_quantity),
    **dict.fromkeys(("air humidity", "material temp", "expansion coeff", "exp coeff"), is_quantity),
    **dict.fromkeys(("mat temp", "mat temp 1", "mat temp 2", "mat temp 3"), is_quantity),
    **dict.fromkeys(("env factor", "final data", "run target data"), is_quantity),
    **dict.fromkeys(("date", "time", "date time"), is_date),
    "axis": lambda text: is_axis(text) or bool(axis_name(text) and is_keywords(text)),
}
_SOMEBODY: Final = {
    "machine": "machine",
    "serial no": "serial number",
    "by": "operator",
    "location": "place",
    "title": "title",
}


def redacted_sections(lines: Sequence[str], cuts: Cuts) -> list[str]:
    """Return the lines of a file in sections, as many, without what is somebody's."""
    section, block = "", False
    result = []
    for line in lines:
        opened = _SECTION.fullmatch(line)
        title = _TITLE.match(line)
        if opened is not None:
            section, block = opened["name"].upper(), False
            result.append(_section(line, section, cuts))
        elif title is not None:
            block = True
            result.append(title[0].rstrip() + (" " + cuts.remark(line[title.end() :])).rstrip())
        elif (block or section in _ROWS) and is_numbers(line):
            result.append(line)
        else:
            result.append(_line(line, cuts))
    return result


def _section(line: str, name: str, cuts: Cuts) -> str:
    return line if name in _SECTIONS else f"{cuts.name(name).upper()}::"


def _line(line: str, cuts: Cuts) -> str:
    match = _KEY.fullmatch(line)
    key = " ".join(match["key"].lower().split()) if match else ""
    if match is None or (key not in _KEYS and key not in _SOMEBODY):
        return cuts.remark(line)
    kept = _KEYS.get(key)
    value = match["value"]
    if not value or (kept is not None and kept(value)):
        return line
    return f"{match['key']}{match['mark']}{cuts.name(value, _SOMEBODY.get(key, 'name'))}"


_COMPENSATION: Final = re.compile(
    r"(?P<key>\s*(?:compensation (?:start|end|spacing|output|type|resolution)|reference position"
    r"|backlash error|sign convention|table type|test name)\b\s*[:=]?\s*)(?P<value>.*?)\s*",
    re.IGNORECASE,
)
_COLUMNS: Final = re.compile(
    r"\s*(?:(?:no\.?|target no\.?|point|axis position|combined|forward|reverse)(?:\s{2,}|\t|;|$)"
    r"\s*)+",
    re.IGNORECASE,
)


def redacted_compensation(lines: Sequence[str], cuts: Cuts) -> list[str]:
    """Return the lines of a compensation text, as many, without what is somebody's."""
    result = []
    rows = False
    for line in lines:
        match = _COMPENSATION.fullmatch(line)
        header = _COLUMNS.fullmatch(line) is not None
        if match is not None:
            rows = rows or match["key"].lower().strip().startswith("compensation output")
            value = match["value"]
            named = match["key"].lower().lstrip().startswith("test name")
            kept = not named and (not value or is_quantity(value))
            result.append(line if kept else match["key"] + cuts.name(value, "title"))
        elif header or (rows and _numbers(line)):
            rows = True
            result.append(line)
        else:
            result.append(cuts.remark(line))
    return result


def _numbers(line: str) -> bool:
    return all(is_numbers(cell) for cell in re.split(r"[;\t]", line) if cell.strip())


_ASSIGNMENT: Final = re.compile(
    r"\s*(?P<name>[A-Za-z_]\w*)\s*(?P<indices>\[[^\]]*\]\s*)?=(?P<value>.*)", re.ASCII
)
_INDICES: Final = re.compile(r"(?:\[[0-9, ]*\]\s*)?")
_ENTRIES: Final = frozenset({"TGT_DATA", "REF_DATA_FWD", "REF_DATA_BWD"})
_OPTIONS: Final[Mapping[str, Kept]] = {
    "UNIT": is_keywords,
    **dict.fromkeys(("CYCLES", "POSITIONS", "DEC"), is_numbers),
}
_VARIABLES: Final = frozenset({"TEST_DATA", "REF_PV", "TEST_PV", "TGT_SET_PV"})


def redacted_assignments(lines: Sequence[str], cuts: Cuts) -> list[str]:
    """Return the lines of a file of the form ``TGT_DATA[1]=...``, as many, without what is
    somebody's.
    """
    result = []
    for line in lines:
        comment = redacted_comment(line, cuts)
        match = _ASSIGNMENT.fullmatch(line)
        if comment is not None:
            result.append(comment)
        elif match is None:
            result.append(cuts.remark(line))
        else:
            result.append(_assignment(line, match, cuts))
    return result


def _assignment(line: str, match: re.Match[str], cuts: Cuts) -> str:
    name, value = match["name"], match["value"]
    indices = match["indices"] or ""
    known = _INDICES.fullmatch(indices) is not None
    if name in _ENTRIES and known and is_numbers(value):
        return line
    if name in _OPTIONS and not indices and _OPTIONS[name](value):
        return line
    if name in _VARIABLES and not indices:
        return f"{name}={cuts.name(value)}"
    return f"{cuts.name(name + indices)}={cuts.remark(value) or NEUTRAL}"
