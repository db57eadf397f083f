"""Read every value in a FANUC backup.

``N03620Q1A1P40A2P140`` states parameter 3620: 40 for axis 1 and 140 for axis 2. ``N10044Q0P-3``
states one point of the array that all axes share.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

from compwright.formats.definition.schema import Definition
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.parameters import MEANINGS, NAMES, SILENT
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.file_values import (
    SILENT_QUANTITIES,
    FileValue,
    by_statements,
    texts_of,
)
from compwright.records.correction import ControlFile, ControlState

_LINE = re.compile(r"[ \t]*N0*([0-9]{1,6})[ \t]*(?:Q([0-9]+))?(.*)", re.IGNORECASE)
_WORD = re.compile(r"([A-Z])[ \t]*([+-]?[0-9.]*)", re.IGNORECASE)
_OWNERS = "ALST"
_POINTS_FROM, _POINTS_TO = 10000, 19999
#: So many texts: those before, planned and read back, of two files each.
_KEPT = 6
_POINT = "point of the pitch error compensation"
#: Numbers of the parameter in a statement's form.
_NUMBER = re.compile(r"N#?0*([0-9]+)")
#: Active parameters that compwright never reads (docs/controllers/fanuc.md).
_UNREAD: Mapping[int, str] = {
    1850: "grid shift: moves the machine's zero",
    8135: "options (#0: stored pitch error compensation off)",
    **dict.fromkeys(range(10803, 10815), "three-dimensional compensation"),
}
#: Text before the words of a parameter that has another meaning on this series: it may compensate,
#: so a change is reported.
_ELSEWHERE = {
    "another": "another parameter on this series; on others: ",
    "unknown": "not known on this series; on others: ",
}
#: Quantities of a definition, where their own names would not be understood.
_WORDS = {
    "table_spacing": "interval of the points",
    "reference_number": "point number of the reference",
    "first_number": "first point number",
    "last_number": "last point number",
    "turn": "travel of one turn",
    "negative_first": "first point number for travel in -",
    "negative_offset": "value at the reference from the other side",
    "backlash": "backlash at cutting feed",
    "reference_coordinate": "coordinate of the reference position",
    "limit_low": "software limit",
    "limit_high": "software limit",
}


@dataclass(frozen=True, slots=True)
class _Known:
    """The meaning of a parameter in words, and whether a correction depends on the parameter.

    ``relevant``: the parameter corrects an axis, refers to the shared point numbers, or decides a
    unit, the kind of an axis or its zero.
    """

    words: str
    relevant: bool


def _known(definition: Definition) -> dict[int, _Known]:
    """Return every parameter with a known meaning: read by compwright, or active but not read."""
    found: dict[int, _Known] = {}
    for name, statement in definition.statements.items():
        match = _NUMBER.match(statement.form)
        bound = [quantity for quantity, one in definition.bindings.items() if one.statement == name]
        if match is not None:
            words = ", ".join(_WORDS.get(one, one.replace("_", " ")) for one in bound or [name])
            found[int(match[1])] = _Known(
                words, not bound or not SILENT_QUANTITIES.issuperset(bound)
            )
    for number, words in {**_UNREAD, **MEANINGS}.items():
        here = definition.parameters[NAMES[number]].here if number in NAMES else "read"
        meaning = words if here == "read" else f"{_ELSEWHERE[here]}{words}"
        found[number] = _Known(meaning, number not in SILENT)
    return found


def file_values(
    definition: Definition, files: Sequence[ControlFile], _: Sequence[ControlFile] = ()
) -> dict[str, FileValue]:
    """Return every value in the files, by name."""
    sheets = [file for file in files if is_entry_sheet(file)]
    found = by_statements(definition, sheets)
    for file in texts_of([file for file in files if file not in sheets]):
        found.update(_of_text(definition, file))
    return found


@lru_cache(maxsize=_KEPT)
def _of_text(definition: Definition, file: ControlFile) -> Mapping[str, FileValue]:
    """Return every value in a text. The result is cached, because comparisons ask for it
    repeatedly.
    """
    known = _known(definition)
    found: dict[str, FileValue] = {}
    for number, line in enumerate(re.split(r"[\r\n]+", file.content.decode("latin-1")), start=1):
        match = _LINE.match(line)
        if match is not None:
            found.update(_values(match, file.name, number, known))
    return found


def _values(
    match: re.Match[str], file: str, line: int, known: Mapping[int, _Known]
) -> Iterator[tuple[str, FileValue]]:
    number, data = int(match[1]), match[2]
    words = [(letter.upper(), text) for letter, text in _WORD.findall(match[3].split("(")[0])]
    # a large number that names an axis or a path is a parameter of a series without Q
    bare = data is None and not any(letter in _OWNERS for letter, _ in words)
    if data == "0" or (bare and _POINTS_FROM <= number <= _POINTS_TO):
        for _, text in words[:1]:
            name = f"N{number:05d}" + ("" if data is None else "Q0")
            entry = FileValue(name, _POINT, text, file, line, relevant=True, meaning=_POINT)
            yield f"{number} point", entry
        return
    meant = known.get(number, _Known("", relevant=False))
    parameter, group, owner = (
        f"N{number:05d}" + ("" if data is None else f"Q{data}"),
        f"{number}",
        "",
    )
    for letter, text in words:
        if letter in _OWNERS and text.isdigit():
            owner = f"{letter}{int(text)}"
            continue
        axis = owner[1:] if owner.startswith("A") else ""
        yield (
            f"{group} {owner}",
            FileValue(
                parameter + owner, group, text, file, line, axis, meant.relevant, meant.words
            ),
        )


def value_location(
    _: Definition, entry: FileValue, __: Mapping[str, FileValue], state: ControlState | None
) -> tuple[tuple[str, ...], float | None]:
    """Return the axes to which a value belongs and, for an increment at a point number, the
    position of its section's end (mm or deg).
    """
    if entry.axis:
        return (entry.axis,), None
    if state is None or entry.group != _POINT:
        return (), None
    number = int(entry.name[1:6]) - _POINTS_FROM
    owners: list[str] = []
    at = None
    for address, facts in state.facts.items():
        for claimed in increments_of(facts).claimed:
            if number not in claimed:
                continue
            owners.append(address)
            points = state.axes[address].positions if address in state.axes else ()
            place = number - claimed.start + (1 if len(points) == len(claimed) + 1 else 0)
            at = float(points[place]) if place < len(points) else None
    return tuple(owners), at if len(owners) == 1 else None
