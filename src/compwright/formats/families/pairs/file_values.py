"""Read every assignment in a SINUMERIK's files, by variable, index and axis.

These are machine and setting data, tables, and in an archive all other assignments. X1 and AX1
count as one axis if MD10000 states it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

from compwright.formats.definition.schema import Definition
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.file_values import FileValue, by_statements, same_text, texts_of
from compwright.formats.text.texts import BY_HAND
from compwright.records.correction import ControlFile, ControlState

_LINE = re.compile(
    r"[ \t]*(?:N[0-9]+[ \t]+)?(?P<name>\$?[A-Z_][A-Z0-9_]*)[ \t]*(?:\[(?P<index>[^\]]*)\])?"
    r"[ \t]*=[ \t]*(?P<text>[^;]*?)(?:[ \t]+'[0-9A-F]{4})?[ \t]*(?:;.*)?",
    re.IGNORECASE,
)
_CHANNEL = re.compile(r"[ \t]*CHANDATA\(([0-9]+)\)[ \t]*", re.IGNORECASE)
_SYSTEM = re.compile(r"[ \t]*(METRIC|INCH)[ \t]*", re.IGNORECASE)
_PLACE = re.compile(r"AX([0-9]{1,2})")
_BASIC = "basic system"
_NAMES = "$MN_AXCONF_MACHAX_NAME_TAB"
_OF_CHANNEL = ("$MC_", "$P_", "$SC_", "_")
#: Beginnings of the variables that act on an axis or decide its units, kind or zero, with what they
#: are (SINUMERIK lists of machine and setting data; docs/controllers/siemens-840d-sl.md).
_MEANINGS = {
    "$AA_ENC_COMP_STEP": "EEC: spacing",
    "$AA_ENC_COMP_MIN": "EEC: first position",
    "$AA_ENC_COMP_MAX": "EEC: last position",
    "$AA_ENC_COMP_IS_MODULO": "EEC: repeats each turn",
    "$AA_ENC_COMP_": "EEC",
    "$AA_ENC_COMP": "EEC: value",
    "$AA_QEC": "quadrant error compensation",
    "$AN_CEC_INPUT": "CEC: moving axis",
    "$AN_CEC_OUTPUT": "CEC: compensated axis",
    "$AN_CEC_STEP": "CEC: spacing",
    "$AN_CEC_MIN": "CEC: first position",
    "$AN_CEC_MAX": "CEC: last position",
    "$AN_CEC_DIRECTION": "CEC: direction",
    "$AN_CEC_MULT_BY_TABLE": "CEC: multiplied by the table of index number - 1",
    "$AN_CEC_IS_MODULO": "CEC: repeats each turn",
    "$AN_CEC_TYPE": "CEC: kind of the table (1: cylinder)",
    "$AN_CEC_": "CEC",
    "$AN_CEC": "CEC: value",
    "$SN_CEC_TABLE_ENABLE": "SD41300: CEC table on",
    "$SN_CEC_TABLE_WEIGHT": "SD41310: weight of a CEC table",
    "$SN_CEC_0": "SD41320: added to a CEC table",
    "$SN_CEC_1": "SD41321: added to a CEC table",
    "$SN_CEC": "CEC",
    "$MA_ENC_COMP_ENABLE": "MD32700: EEC on",
    "$MA_CEC_ENABLE": "MD32710: CEC on",
    "$MA_CEC_MAX_SUM": "MD32720: limit of the sum of CEC tables",
    "$MA_CEC": "MD32711, MD32730: CEC",
    "$MA_BACKLASH": "MD32450: backlash",
    "$MA_FRICT": "friction compensation",
    "$MA_TEMP_COMP": "temperature compensation",
    "$SA_TEMP_COMP": "temperature compensation",
    "$MA_MM_ENC_COMP_MAX_POINTS": "MD38000: points of EEC",
    "$MN_MM_CEC_MAX_POINTS": "MD18342: points of CEC",
    "$MN_SCALING": "unit of lengths",
    "$MN_CONVERT_SCALING": "unit of lengths",
    _NAMES: "MD10000: name of a machine axis",
    "$MA_IS_ROT_AX": "MD30300: rotary axis",
    "$MA_ROT_IS_MODULO": "MD30310: endless axis",
    "$MA_MODULO_RANGE": "one turn of the axis",
    "$MA_NUM_ENCS": "MD30200: number of encoders",
    "$MA_GANTRY_AXIS_TYPE": "MD37100: gantry",
    "$MA_MS_": "MD37250 and on: master and slave drive",
    "$MA_CC_MASTER_AXIS": "MD63000: coupled with another axis",
    "$MC_TRAFO_RESET_VALUE": "MD20140: transformation after reset",
    "$MA_ENC_IS_LINEAR": "MD31000: linear scale",
    "$MA_ENC_GRID_POINT_DIST": "MD31010: period of the scale",
    "$MA_LEADSCREW_PITCH": "MD31030: lead of the screw",
    "$MA_REFP": "reference point: moves the machine's zero",
    "$MA_ENC_REFP": "state and zero of an absolute encoder",
    "$MA_POS_LIMIT": "software limit",
}
_SILENT = ("$MA_POS_LIMIT",)


def file_values(
    definition: Definition, files: Sequence[ControlFile], naming: Sequence[ControlFile] = ()
) -> dict[str, FileValue]:
    """Return every assignment in the files by name; the last value of a variable applies.
    ``naming``: other files of the same control that may list the names of the axes.
    """
    sheets = [file for file in files if is_entry_sheet(file)]
    texts = texts_of([file for file in files if file not in sheets])
    named = dict(entry for text in (*texts_of(naming), *texts) for entry in _named(text))
    read, channel = [], "1"
    for text in texts:
        read.append(_read(text, channel, tuple(named.items())))
        channel = read[-1].channel
    found = by_statements(definition, sheets)
    found |= {entry.name: entry for entry in _units([one for text in read for one in text.units])}
    for entry in (entry for text in read for entry in text.assigned):
        known = found.get(entry.name)
        if known is not None and known.file != entry.file and not same_text(known.text, entry.text):
            # an archive says many values twice: what one member alone says is no value less
            beaten = replace(known, name=f"{known.name} in {known.file}", relevant=False)
            found[beaten.name] = beaten
        found[entry.name] = entry
    return found


class _TextValues(NamedTuple):
    """The assignments of one text in their order, the length units that it states (file, line,
    unit), and the ``channel`` to which a text after it belongs.
    """

    assigned: tuple[FileValue, ...]
    units: tuple[tuple[str, int, str], ...]
    channel: str


@lru_cache(maxsize=64)  # the members of an archive, as found and read back
def _read(file: ControlFile, channel: str, named: tuple[tuple[str, str], ...]) -> _TextValues:
    """Return the contents of a text that begins in ``channel``. ``named``: the place of each
    machine axis by its name.
    """
    names, assigned, units = dict(named), [], []
    for number, line in enumerate(_lines(file), start=1):
        match = _LINE.fullmatch(line.replace(f";{BY_HAND}", "", 1)) if "=" in line else None
        if match is not None:
            assigned.append(_entry(match, file.name, number, channel, names))
        elif scope := _CHANNEL.fullmatch(line):
            channel = scope[1]
        elif unit := _SYSTEM.fullmatch(line):
            units.append((file.name, number, unit[1].upper()))
    return _TextValues(tuple(assigned), tuple(units), channel)


def _lines(file: ControlFile) -> list[str]:
    return re.split(r"\r\n|\r|\n", file.content.decode("latin-1"))


def _units(stated: Sequence[tuple[str, int, str]]) -> Iterator[FileValue]:
    """Yield the length unit that most files state, once, and each file that states a different
    unit. ``stated``: file, line and unit.
    """
    units = sorted({unit for _, _, unit in stated}, reverse=True)  # METRIC where as many say either
    most = max(units, key=[unit for _, _, unit in stated].count, default="")
    for file, number, unit in stated:
        name, whose = (_BASIC, "the files") if unit == most else (f"{file}: {_BASIC}", "this file")
        meaning = f"unit of lengths of {whose}"
        yield FileValue(name, _BASIC, unit, file, number, relevant=True, meaning=meaning)


def _named(file: ControlFile) -> Iterator[tuple[str, str]]:
    """Yield the name of each machine axis (MD10000) with its place."""
    for line in _lines(file) if _NAMES.encode() in file.content.upper() else ():
        if _NAMES not in line.upper():
            continue
        match = _LINE.fullmatch(line)
        name = match["text"].strip('" ').upper() if match is not None else ""
        index = (match["index"] or "").split(",")[0].strip() if match is not None else ""
        if name and index.isdigit():
            yield name, f"AX{int(index) + 1}"


def _entry(
    match: re.Match[str], file: str, line: int, channel: str, names: Mapping[str, str]
) -> FileValue:
    group = match["name"].upper()
    index = [part.strip().upper() for part in (match["index"] or "").split(",")]
    index = [names.get(part, part) for part in index]
    axis = index[-1] if _PLACE.fullmatch(index[-1]) else ""
    if group == _NAMES:  # the place stands first, a kind of axis may follow
        index = index[:1]
    scope = f"CHANDATA({channel}) " if channel != "1" and group.startswith(_OF_CHANNEL) else ""
    name = f"{scope}{group}[{','.join(index)}]" if match["index"] is not None else scope + group
    meaning = _meaning(group)
    relevant = bool(meaning) and not group.startswith(_SILENT)
    return FileValue(name, group, match["text"], file, line, axis, relevant, meaning)


@lru_cache(maxsize=4096)  # an archive has a thousand values of each of a thousand variables
def _meaning(group: str) -> str:
    return next((words for start, words in _MEANINGS.items() if group.startswith(start)), "")


def value_location(
    _: Definition, entry: FileValue, entries: Mapping[str, FileValue], __: ControlState | None
) -> tuple[tuple[str, ...], float | None]:
    """Return the axes to which a value belongs, and a table value's position in its file's unit."""
    index = entry.name.partition("[")[2].rstrip("]").split(",")
    if entry.group == "$AA_ENC_COMP" and len(index) == 3:
        return (entry.axis,), _position(entries, entry.group, f"{index[0]},{index[2]}", index[1])
    if not entry.group.startswith(("$AN_CEC", "$SN_CEC")):
        return ((entry.axis,) if entry.axis else ()), None
    pair = tuple(
        entries[key].text.strip("() ").upper()
        for key in (f"$AN_CEC_OUTPUT_AXIS[{index[0]}]", f"$AN_CEC_INPUT_AXIS[{index[0]}]")
        if key in entries
    )
    named = tuple(dict.fromkeys(axis for axis in pair if _PLACE.fullmatch(axis)))
    at = _position(entries, "$AN_CEC", index[0], index[1]) if entry.group == "$AN_CEC" else None
    return named, at


def _position(
    entries: Mapping[str, FileValue], group: str, table: str, number: str
) -> float | None:
    keys = (f"{group}_MIN[{table}]", f"{group}_STEP[{table}]")
    try:
        start, step = (float(entries[key].text) for key in keys)
        return start + int(number) * step
    except (KeyError, ValueError):
        return None
