"""Every line of a FANUC backup as single values: N03620Q1A1P40A2P140 is 40 of axis 1 and 140 of
axis 2, N10044Q0P-3 a point of the array that all axes share.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from compwright.formats.text.entered import Entered, texts_of
from compwright.records.correction import ControlFile, ControlState

_LINE = re.compile(r"[ \t]*N0*([0-9]{1,6})[ \t]*(?:Q([0-9]+))?(.*)", re.IGNORECASE)
_WORD = re.compile(r"([A-Z])[ \t]*([+-]?[0-9.]*)", re.IGNORECASE)
_OWNERS = "ALST"
_POINTS_FROM, _POINTS_TO = 10000, 19999
_POINT = "point of the pitch error compensation"
#: What acts on an axis, points to the shared numbers, or decides a unit, a kind or the zero, with
#: the sources of the definition and of docs/controllers/fanuc.md.
_MEANINGS: tuple[tuple[range, str], ...] = tuple(
    (range(first, last + 1), meaning)
    for first, last, meaning in (
        (981, 981, "path of the axis"),
        (1001, 1001, "unit of lengths (#0: inch)"),
        (1004, 1004, "increment system"),
        (
            1006,
            1006,
            "kind of the axis (#0, #1), diameter (#3), direction of the return (#5)",
        ),
        (1013, 1013, "increment system of the axis"),
        (1020, 1020, "letter of the axis"),
        (1240, 1240, "coordinate of the reference position"),
        (1260, 1260, "one turn of the axis"),
        (1320, 1321, "software limit"),
        (1800, 1800, "bits of the servo (#4: backlash of its own for rapid traverse)"),
        (1815, 1815, "bits of the encoder"),
        (1820, 1820, "command multiplier: decides the detection unit"),
        (1821, 1821, "reference counter"),
        (1846, 1849, "smooth backlash compensation"),
        (1850, 1850, "grid shift: moves the machine's zero"),
        (1851, 1851, "backlash at cutting feed"),
        (1852, 1852, "backlash at rapid traverse"),
        (3602, 3602, "bits of pitch error compensation"),
        (3605, 3605, "bits of pitch error compensation (#0: two sets)"),
        (3620, 3620, "point number of the reference"),
        (3621, 3621, "first point number"),
        (3622, 3622, "last point number"),
        (3623, 3623, "magnification"),
        (3624, 3624, "interval of the points"),
        (3625, 3625, "travel of one turn"),
        (3626, 3626, "first point number for travel in -"),
        (3627, 3627, "value at the reference from the other side"),
        (5711, 5720, "straightness: moving axis"),
        (5721, 5730, "straightness: compensated axis"),
        (5731, 5760, "straightness: point numbers"),
        (5761, 5799, "straightness: amounts"),
        (5861, 5864, "inclination: point numbers"),
        (5871, 5874, "inclination: amounts"),
        (8135, 8135, "options (#0: stored pitch error compensation off)"),
        (10800, 10802, "three-dimensional compensation"),
        (13381, 13399, "straightness, further axes"),
        (14985, 14987, "second, cyclic table"),
    )
)
#: Known and shown, but no compensation: nobody stops a machine for these.
_SILENT = frozenset({1020, 1320, 1321})


def entered(files: Sequence[ControlFile]) -> dict[str, Entered]:
    """Return every value of the files."""
    found: dict[str, Entered] = {}
    for file in texts_of(files):
        lines = re.split(r"[\r\n]+", file.content.decode("latin-1"))
        for number, line in enumerate(lines, start=1):
            match = _LINE.match(line)
            if match is not None:
                found.update(_values(match, file.name, number))
    return found


def _values(match: re.Match[str], file: str, line: int) -> Iterator[tuple[str, Entered]]:
    number, data, rest = int(match[1]), match[2], match[3].split("(")[0]
    if data == "0" or (data is None and _POINTS_FROM <= number <= _POINTS_TO):
        value = _WORD.search(rest)
        if value is not None:
            name = f"N{number:05d}" + ("" if data is None else "Q0")
            entry = Entered(name, _POINT, value[2], file, line, acts=True, meaning=_POINT)
            yield f"{number} point", entry
        return
    meaning = next((words for numbers, words in _MEANINGS if number in numbers), "")
    acts = bool(meaning) and number not in _SILENT
    owner = ""
    for word in _WORD.finditer(rest):
        letter = word[1].upper()
        if letter in _OWNERS and word[2].isdigit():
            owner = f"{letter}{int(word[2])}"
            continue
        name = f"N{number:05d}" + ("" if data is None else f"Q{data}") + owner
        axis = owner[1:] if owner.startswith("A") else ""
        yield (
            f"{number} {owner}",
            Entered(name, f"{number}", word[2], file, line, axis, acts, meaning),
        )


def whereabouts(entry: Entered, state: ControlState | None) -> tuple[tuple[str, ...], float | None]:
    """Return the axes that a value belongs to, and the position of a point, mm or deg: the node at
    the end of its section.
    """
    if entry.axis:
        return (entry.axis,), None
    if state is None or entry.group != _POINT:
        return (), None
    number = int(entry.name[1:6]) - _POINTS_FROM
    owners: list[str] = []
    at = None
    for address, facts in state.facts.items():
        for claimed in facts.increments.claimed:
            if number not in claimed:
                continue
            owners.append(address)
            nodes = state.axes[address].positions if address in state.axes else ()
            place = number - claimed.start + (1 if len(nodes) == len(claimed) + 1 else 0)
            at = float(nodes[place]) if place < len(nodes) else None
    return tuple(owners), at if len(owners) == 1 else None
