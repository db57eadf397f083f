"""HEIDENHAIN tables: ``.COM`` (correction values), ``.CMA`` (the active .COM table of each axis).

On an iTNC 530, a table has one row per point. Point k is at DATUM + k * spacing (TNC 407 technical
manual p. 153, iTNC 530 HSCI p. 655). On an NCK control, the column AXISPOS lists the positions
(MANUALplus 620 p. 716).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from compwright.controllers.heidenhain.elements import (
    ITNC530,
    MOST_AXES,
    Generation,
    LinePlace,
    Parameter,
    binary_fault,
    lines_of,
    number,
    read_parameters,
)
from compwright.controllers.heidenhain.grid import (
    CellGrid,
    TableBlock,
    numbers,
    read_grid,
    split_tables,
)
from compwright.foundations.errors import Fault, InputError
from compwright.records.axis import FloatArray
from compwright.records.correction import ControlFile

_AXIS_NUMBER = re.compile(r"[0-9]{1,6}")
_COLUMN = re.compile(r"([0-9]{1,2})=F\(\)", re.IGNORECASE)
#: Columns of KinematicsComp in an iTNC 530 .COM: no axis columns (HSCI manual p. 680).
_KINEMATICS = {f"C{n}" for n in range(1, 7)}


@dataclass(frozen=True, slots=True)
class Com:
    """One .COM table: values (k, columns) as written, NaN where blank.

    - ``names``: the names by which a .CMA may refer to the table, in capitals without the ending.
    - ``columns``: the corrected axes.
    - ``datum``, ``distance``: DATUM and DIST of an iTNC 530, as written.
    - ``listed`` (k,): positions in the column AXISPOS of an NCK control; None for an iTNC 530.
    - ``negative`` (k,): column BACKLASH of an NCK control; None without this column.
    """

    name: str
    names: frozenset[str]
    inch: bool
    columns: tuple[str, ...]
    values: FloatArray
    place: LinePlace
    datum: float = 0.0
    distance: float = 0.0
    listed: FloatArray | None = None
    negative: FloatArray | None = None


@dataclass(frozen=True, slots=True)
class Cma:
    """One .CMA table: its active line, which names a .COM table for each moving axis.

    ``axes``: all axis columns. ``active``: name of the .COM table (capitals, no ending) by moving
    axis; None if no line is active. ``marked``: the active line has a mark.
    """

    axes: tuple[str, ...]
    active: dict[str, str] | None
    marked: bool
    place: LinePlace


@dataclass(slots=True)
class Content:
    """The tables and parameters in one text file, and its faults."""

    coms: list[Com] = field(default_factory=list)
    cmas: list[Cma] = field(default_factory=list)
    parameters: list[Parameter] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def read_text(file: ControlFile, generation: Generation) -> Content:
    """Return the tables and parameters of one ASCII file, with its faults; nothing is raised."""
    found = Content()
    fault = binary_fault(file.name, file.content)
    if fault is not None:
        found.faults.append(fault)
        return found
    text = file.content.decode("latin-1").removeprefix("\xef\xbb\xbf")
    lines = [
        (LinePlace(file.name, line), content)
        for line, content in enumerate(lines_of(text), start=1)
    ]
    blocks, outside = split_tables(lines, found.faults)
    stem = file.name[:-4].upper() if file.name.upper().endswith(".COM") else None
    alone = [block.kind for block in blocks].count("COM") == 1
    for block in blocks:
        try:
            if block.kind == "COM":
                found.coms.append(_com(block, generation, stem if alone else None, found))
            else:
                found.cmas.append(_cma(block, generation))
        except InputError as error:
            found.faults.extend(error.faults)
    _read_outside(outside, generation, found, strict=bool(blocks))
    return found


def _read_outside(
    lines: list[tuple[LinePlace, str]], generation: Generation, found: Content, *, strict: bool
) -> None:
    """Read the machine parameters in the lines outside tables into ``found``. Any other text is a
    fault in a file with tables (``strict``) or without machine parameters, else a note.
    """
    read = read_parameters(lines, generation)
    if read.parameters and generation.name != ITNC530.name:
        read.faults.append(
            read.parameters[0].place.fault(
                "MP710, MP720, MP730 are not of this control",
                expected=", ".join(generation.parameters),
            )
        )
    found.parameters += read.parameters
    found.faults += read.faults
    if not read.stray or found.faults:
        return
    place, code = read.stray[0]
    if strict or not read.parameters:
        found.faults.append(
            place.fault(
                "the line cannot be read",
                expected="BEGIN X .COM MM ... or BEGIN NAME .CMA",
                found=repr(code[:80]),
            )
        )
    else:
        found.notes.append(
            f"{place}: not a machine parameter, not read (lines of this sort: {len(read.stray)})"
        )


def _com(block: TableBlock, generation: Generation, stem: str | None, found: Content) -> Com:
    grid = read_grid(block)
    faults: list[Fault] = []
    most = generation.most_points
    if most is not None and len(grid.rows) > most:
        faults.append(
            block.place.fault(
                "the table contains too many points",
                expected=f"at most {most}",
                found=str(len(grid.rows)),
            )
        )
    if not grid.rows:
        faults.append(block.place.fault("the table contains no rows"))
    if generation.name == ITNC530.name:
        com = _by_spacing(block, grid, generation, stem, found, faults)
    else:
        com = _by_position(block, grid, stem, faults)
    if grid.rows and not faults and bool(np.all(np.isnan(com.values))):
        faults.append(
            block.place.fault(
                "the table contains no values", expected="a value in at least one axis column"
            )
        )
    if faults:
        raise InputError(*faults)
    return com


def _names(block: TableBlock, stem: str | None) -> frozenset[str]:
    return frozenset({block.name.upper()} | ({stem} if stem else set()))


def _values(grid: CellGrid, columns: dict[str, str], faults: list[Fault]) -> FloatArray:
    """Return a table's columns as numbers (rows, columns); a column with values must not be blank
    in its first or last row.
    """
    table = np.full((len(grid.rows), len(columns)), np.nan)
    for index, name in enumerate(columns):
        cells = grid.column(name)
        table[:, index] = numbers(cells, grid.places, f"column {name}", faults)
        if any(cells):
            faults += [
                place.fault(f"column {name} is blank at an end of the table", expected="a value")
                for place in (grid.places[end] for end in (0, -1) if cells[end] is None)
            ]
    return table


def _by_spacing(
    block: TableBlock,
    grid: CellGrid,
    generation: Generation,
    stem: str | None,
    found: Content,
    faults: list[Fault],
) -> Com:
    """Return the .COM table of an iTNC 530, with DATUM and DIST in its first line. ``stem``: a
    second name of the table, from the file name; ``found``: where notes are added.
    """
    head = _head(block, faults)
    columns: dict[str, str] = {}
    for name in grid.names:
        match = _COLUMN.fullmatch(name)
        if match and 1 <= int(match.group(1)) <= MOST_AXES:
            columns[name] = generation.axis(int(match.group(1)))
        elif name.upper() in _KINEMATICS:
            if any(grid.column(name)):
                found.notes.append(
                    f"{block.place}: column {name} of {block.name}.COM (KinematicsComp) is not"
                    " judged"
                )
        else:
            faults.append(
                block.place.fault(
                    "the column heading is wrong",
                    expected="1=F(), 2=F(), ...",
                    found=repr(name[:40]),
                )
            )
    if len(set(columns.values())) < len(columns):
        faults.append(
            block.place.fault("two columns belong to the same axis", found=" ".join(columns))
        )
    return Com(
        name=block.name,
        names=_names(block, stem),
        inch=block.inch,
        columns=tuple(columns.values()),
        values=_values(grid, columns, faults),
        place=block.place,
        datum=head["DATUM"],
        distance=head["DIST"],
    )


def _head(block: TableBlock, faults: list[Fault]) -> dict[str, float]:
    """Return the first position (DATUM) and the spacing (DIST) in a table's BEGIN line."""
    head: dict[str, float] = {}
    for entry in block.rest.replace(": ", ":").split():
        key, colon, text = entry.partition(":")
        value = number(text)
        if (
            not colon
            or key.upper() not in {"DATUM", "DIST"}
            or value is None
            or key.upper() in head
        ):
            faults.append(
                block.place.fault(
                    "head of the table", expected="DATUM:number DIST:number", found=repr(entry[:40])
                )
            )
        else:
            head[key.upper()] = value
    missing = [key for key in ("DATUM", "DIST") if key not in head]
    if missing:
        faults.append(
            block.place.fault(
                f"the head of the table lacks {' and '.join(missing)}",
                expected="DATUM:number DIST:number",
            )
        )
    return {"DATUM": 0.0, "DIST": 0.0, **head}


def _by_position(block: TableBlock, grid: CellGrid, stem: str | None, faults: list[Fault]) -> Com:
    """Return the .COM table of an NCK control, with the positions in the column AXISPOS. ``stem``:
    a second name of the table, from the file name.
    """
    if block.rest:
        faults.append(
            block.place.fault(
                "head of the table", expected="nothing behind the unit", found=repr(block.rest[:40])
            )
        )
    special = {name.upper(): name for name in grid.names if name.upper() in {"AXISPOS", "BACKLASH"}}
    if "AXISPOS" not in special:
        raise InputError(
            *faults,
            block.place.fault(
                "the column headings are wrong",
                expected="NR AXISPOS and the axes",
                found=" ".join(grid.names)[:80],
            ),
        )
    positions = grid.column(special["AXISPOS"])
    listed = numbers(positions, grid.places, "column AXISPOS", faults)
    for index, (cell, place) in enumerate(zip(positions, grid.places, strict=True)):
        if cell is None:
            faults.append(place.fault("a row has no position", expected="a value in AXISPOS"))
        elif index and listed[index] <= listed[index - 1]:
            faults.append(
                place.fault(
                    "positions do not ascend",
                    expected=f"above {listed[index - 1]:g}",
                    found=f"{listed[index]:g}",
                )
            )
    columns = {name: name for name in grid.names if name not in special.values()}
    negative = None
    if "BACKLASH" in special:
        negative = numbers(grid.column(special["BACKLASH"]), grid.places, "column BACKLASH", faults)
    return Com(
        name=block.name,
        names=_names(block, stem),
        inch=block.inch,
        columns=tuple(columns),
        values=_values(grid, columns, faults),
        place=block.place,
        listed=listed,
        negative=negative,
    )


def _cma(block: TableBlock, generation: Generation) -> Cma:
    """Return the .CMA table in a block of lines, of which only the active line is read.

    On an NCK control, the active line has an asterisk in the column ACTIVE. On an iTNC 530, it is
    the only line, or the line with ``M`` in STATUS or ACTIVE. Raises InputError for wrong column
    headings, or if it is unclear which line is active.
    """
    grid = read_grid(block)
    mark = "M" if generation.name == ITNC530.name else "*"
    states = ("STATUS", "ACTIVE") if generation.name == ITNC530.name else ("ACTIVE",)
    state = next((name for name in grid.names if name.upper() in states), None)
    marks = grid.column(state) if state else [None] * len(grid.rows)
    faults = [
        place.fault(f"column {state}", expected=f"{mark} or blank", found=repr(cell[:40]))
        for cell, place in zip(marks, grid.places, strict=True)
        if cell not in {None, mark}
    ]
    axes = tuple(name for name in grid.names if name != state)
    named = tuple(
        (
            generation.axis(int(name))
            if generation.name == ITNC530.name and _AXIS_NUMBER.fullmatch(name)
            else generation.address(name)
        )
        for name in axes
    )
    beyond = [
        name
        for name in axes
        if _AXIS_NUMBER.fullmatch(name)
        and not 1 <= int(name) <= MOST_AXES
        and generation.name == ITNC530.name
    ]
    if len(set(named)) < len(named) or not named or beyond:
        faults.append(
            block.place.fault(
                "the column headings are wrong",
                expected="each axis once, from 1",
                found=" ".join(axes)[:80],
            )
        )
    active = [index for index, cell in enumerate(marks) if cell == mark]
    single = len(grid.rows) == 1 and (generation.name == ITNC530.name or state is None)
    if len(active) > 1 or (
        not active
        and not single
        and grid.rows
        and (state is None or generation.name == ITNC530.name)
    ):
        faults.append(
            block.place.fault(
                "it is unclear which line is active",
                expected=f"exactly one line marked {mark}",
                found=f"{len(active)} of {len(grid.rows)}",
            )
        )
    if faults:
        raise InputError(*faults)
    chosen = active[0] if active else 0 if single else None
    cells = {
        axis: cell.upper().removesuffix(".COM")
        for axis, name in zip(named, axes, strict=True)
        if chosen is not None and (cell := grid.column(name)[chosen]) is not None
    }
    return Cma(
        axes=named, active=None if chosen is None else cells, marked=bool(active), place=block.place
    )
