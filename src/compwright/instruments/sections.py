"""Text with sections: a line ``NAME::`` opens a section, ``EOF::`` ends the file.

A section has ``Key: value`` lines and rows of numbers. The files of laser software have this
layout. No real file of a maker was available: the layout is that of six independent programs of
third parties which read and write it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from compwright.foundations.findings import Finding
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.reading_findings import cut_finding
from compwright.instruments.spans import Spans, TextSpan, by_key, whole
from compwright.words.sentences import say

#: A line of a file: its number from 1, and its text without blanks around it.
Line = tuple[int, str]

_SECTION = re.compile(r"\s*([A-Z][A-Z0-9 _-]*?)\s*::\s*", re.IGNORECASE)
_KEY = re.compile(r"\s*(?P<key>[A-Za-z][\w .-]*?)\s*:(?!:)\s*(?P<value>.*?)\s*")
_END = "EOF"
#: The sections of these files, and whether they hold rows of numbers.
SECTIONS: Final[Mapping[str, bool]] = {
    **dict.fromkeys(("TARGET DATA", "RUNS", "DEVIATIONS"), True),
    **dict.fromkeys(("HEADER", "USER-TEXT", "EQUIPMENT", "ENVIRONMENT", "ANALYSIS"), False),
    **dict.fromkeys(("ENVIRONMENT DATA", _END), False),
}
#: The keys in them, in small letters, with what their values are.
KEYS: Final = by_key(
    {
        "keywords": ("file type", "filetype", "owner", "unit", "units"),
        "numbers": ("target-count", "targets", "flags", "run-count"),
        "quantity": (
            *("air temp", "air press", "air pressure", "air humid", "air humidity"),
            *("material temp", "mat temp", "mat temp 1", "mat temp 2", "mat temp 3"),
            *("expansion coeff", "exp coeff", "env factor", "final data", "run target data"),
        ),
        "date": ("date", "time", "date time"),
        "version": ("version no",),
        "axis in words": ("axis",),
        "machine": ("machine",),
        "serial number": ("serial no",),
        "operator": ("by",),
        "place": ("location",),
        "title": ("title",),
    }
)
#: The names of the form. Those of the air and the material are no such: a machine may be a press.
WORDS: Final = (
    *SECTIONS,
    *(key for key, meaning in KEYS.items() if meaning != "quantity"),
)
#: Keys of these files -> keys that the header of every test has.
_KNOWN = {"machine": "machine", "serial no": "serial", "date": "date", "by": "operator"}
_UNIT_KEY = re.compile(r"\bunits?\b", re.IGNORECASE)
_METRIC = frozenset(
    {"", "mm", "metric", "um", "µm", "micron", "microns", "deg", "degree", "degrees"}
)
_AXIS = re.compile(
    r"(?:(?:axis|achse|axe|ось|轴)[ :_-]*)?(?P<name>[A-Za-z]{1,2}[0-9]{0,2})[ _-]*"
    r"(?:-?(?:axis|achse|轴))?",
    re.IGNORECASE,
)


@dataclass(slots=True)
class FileSections:
    """The lines of each section in the order of the file, without blank lines.

    ``ended``: whether the line ``EOF::`` was found. ``last``: the last line that is not blank.
    """

    lines: dict[str, list[Line]] = field(default_factory=dict)
    ended: bool = False
    last: Line = (0, "")

    def value(self, section: str, key: str) -> tuple[str, str]:
        """Return the value of a key in a section, and the place of its line for messages; two empty
        texts if there is none. Upper and lower case are the same.
        """
        for number, text in self.lines.get(section, ()):
            match = _KEY.fullmatch(text)
            if match and match["key"].lower() == key.lower():
                return match["value"], f"line {number}, {key}"
        return "", ""


def spans_of(text: Sequence[str]) -> Iterator[Spans]:
    """Yield the parts of each line of a file with sections, each with its meaning."""
    rows = False
    for line in text:
        match = _SECTION.fullmatch(line)
        if match is None:
            yield spans_in(line, rows=rows)
            continue
        known = match[1].upper() in SECTIONS
        rows = SECTIONS.get(match[1].upper(), False)
        yield (TextSpan(*match.span(1), "key" if known else "section"),)


def spans_in(line: str, *, rows: bool) -> Spans:
    """Return the parts of a line with their meaning. A line without a known key is taken as a row
    of numbers if ``rows`` is true, else as a remark.
    """
    match = _KEY.fullmatch(line)
    meaning = KEYS.get(" ".join(match["key"].lower().split())) if match is not None else None
    if match is None or meaning is None:
        return whole(line, "row" if rows else "remark")
    return TextSpan(*match.span("key"), "key"), TextSpan(match.start("value"), len(line), meaning)


def opens_section(line: str) -> bool:
    """Return whether a line opens a section."""
    return _SECTION.fullmatch(line) is not None


def has_section(text: Sequence[str], names: Iterable[str]) -> bool:
    """Return whether one of the lines opens a section of one of these names."""
    wanted = set(names)
    return any(
        "::" in line
        and (match := _SECTION.fullmatch(line)) is not None
        and match[1].upper() in wanted
        for line in text
    )


def sections_of(text: Sequence[str], faults: FaultList) -> FileSections:
    """Return the sections of a file. A repeated section and text after ``EOF::`` are faults."""
    found = FileSections()
    current = found.lines.setdefault("", [])
    for number, raw in enumerate(text, start=1):
        line = raw.strip()
        if not line:
            continue
        found.last = (number, line)
        match = _SECTION.fullmatch(line)
        name = match[1].upper() if match else ""
        if found.ended:
            faults.add(
                "contains lines after the end mark EOF::",
                place=f"line {number}",
                expected="one test per file",
                found=shown(line),
                hint="remove the lines after EOF::, or give each test its own file",
            )
            break
        if not name:
            current.append((number, line))
        elif name == _END:
            found.ended = True
        else:
            if name in found.lines:
                faults.add(
                    f"section {name}:: is given twice",
                    place=f"line {number}",
                    expected="one test per file",
                    hint="give each test its own file",
                )
            current = found.lines.setdefault(name, [])
    return found


def header_of(sections: FileSections, names: Iterable[str]) -> dict[str, str]:
    """Return the keys and values of the lines ``Key: value`` in these sections; other lines are
    values of the key ``comment``.

    Known keys are renamed to their usual name.
    """
    header: dict[str, list[str]] = {}
    for name in names:
        for _, text in sections.lines.get(name, ()):
            match = _KEY.fullmatch(text)
            key = match["key"] if match else "comment"
            value = match["value"] if match else text
            if not value or (match and key.lower() == "axis"):
                continue
            header.setdefault(_KNOWN.get(key.lower(), key), []).append(value)
    return {key: "\n".join(values) for key, values in header.items()}


def axis_name(text: str) -> str:
    """Return the axis in a text such as ``X``, ``X axis`` or ``Achse X``, "" if uncertain."""
    match = _AXIS.fullmatch(text.strip())
    return match["name"].upper() if match else ""


def with_axis(header: Mapping[str, str], text: str) -> dict[str, str]:
    """Return ``header`` with the axis from the file's ``text``: as key ``axis`` if the text is an
    axis name, else as key ``axis as written``.
    """
    name = axis_name(text)
    if name:
        return {**header, "axis": name}
    return {**header, "axis as written": text} if text else dict(header)


def check_units(sections: FileSections, names: Iterable[str], faults: FaultList) -> None:
    """Add a fault for a line in the sections ``names`` that states an unexpected unit, such as
    inches.
    """
    for name in names:
        for number, text in sections.lines.get(name, ()):
            match = _KEY.fullmatch(text)
            if match and _UNIT_KEY.search(match["key"]) and match["value"].lower() not in _METRIC:
                faults.add(
                    "states a unit, but not of which numbers",
                    place=f"line {number}, {match['key']}",
                    expected="mm and um, or degrees",
                    found=shown(match["value"]),
                    hint="export the readings as plain CSV",
                )


def no_end_finding(sections: FileSections) -> Finding | None:
    """Return the finding that the last line ``EOF::`` is missing, or None if the file has it."""
    if sections.ended:
        return None
    number, text = sections.last
    return cut_finding(say("CW-R053.no_end", text=shown(text), line=number))
