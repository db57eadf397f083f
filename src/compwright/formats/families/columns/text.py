"""The text of a table that a control exports: one header of columns, rows of cells in fixed widths,
every cell with its place.

    BEGIN X .COM MM DATUM:-400 DIST:16
    NR   1=F()     2=F()
    0    +0        +0
    END X .COM

No manual shows such a file as text: nothing here is taken for certain that the file itself does not
show. Cells may be blank, so that a cell belongs to the column over or under which it stands; what
could stand in either of two columns is refused.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from typing import Literal

from compwright.formats.definition.schema import Definition
from compwright.formats.text.patching import Change
from compwright.formats.text.scale import NotHeld
from compwright.formats.text.texts import TextReader, text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: The statements of a definition that open a table of values and a table of assignments.
VALUES, ASSIGNMENTS = "values_begin", "assignments_begin"
ROW_NUMBER, POSITION, SECOND, ACTIVE = "NR", "AXISPOS", "BACKLASH", ("ACTIVE", "STATUS")
#: Columns that belong to no axis.
RESERVED = (ROW_NUMBER, POSITION, SECOND, *ACTIVE)
_NUMBER = re.compile(r"[+-]?(?:[0-9]{1,9}(?:\.[0-9]{0,9})?|\.[0-9]{1,9})")
_BINARY = re.compile(rb"[\x00-\x08\x0b\x0e-\x19\x1b-\x1f]")
KEPT_TABLES = 128  #: Each table is parsed once in a run.
_ENDS = ("END", "[END]")

Kind = Literal["values", "assignments"]


@dataclass(frozen=True, slots=True)
class Cell:
    """A word of a table: its text and its place in bytes, ``end`` behind it."""

    text: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Row:
    """One row. ``line`` counts from 1; ``start`` and ``end`` are the bytes of its text, ``next``
    those of the following line.
    """

    line: int
    start: int
    end: int
    next: int
    cells: Mapping[str, Cell]

    @property
    def place(self) -> str:
        """The line, for messages."""
        return f"line {self.line}"


@dataclass(frozen=True, slots=True)
class Column:
    """A column. Cells stand from ``low`` up to ``high`` (characters of the line; None: to its end),
    flush with one of them.

    ``edge``: the character at which cells begin (``flush`` left) or behind which they end (right);
    ``flush`` "free": blanks alone separate the cells.
    """

    name: str
    low: int
    high: int | None
    flush: Literal["left", "right", "free"]
    edge: int


@dataclass(frozen=True, slots=True)
class UserTable:
    """A table as it stands in a file. ``head``: the fields of its first line, with ``name`` and
    ``unit``.
    """

    file: str
    kind: Kind
    head: Mapping[str, Cell]
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]

    @property
    def name(self) -> str:
        """The table's name in its first line, without the ending."""
        return self.head["name"].text

    def column(self, name: str) -> Column | None:
        """Return a column by name, None where the table has none."""
        return next((column for column in self.columns if column.name == name), None)

    def others(self, *names: str) -> tuple[str, ...]:
        """Return the names of the columns that hold something other than zero, apart from ``names``
        and the row numbers.
        """
        return tuple(
            column.name
            for column in self.columns
            if column.name not in (ROW_NUMBER, *names)
            and any(self._filled(row, column.name) for row in self.rows)
        )

    def _filled(self, row: Row, name: str) -> bool:
        cell = row.cells.get(name)
        return cell is not None and not (is_number(cell.text) and Decimal(cell.text) == 0)


def is_number(text: str) -> bool:
    """Return whether a cell holds a decimal number."""
    return _NUMBER.fullmatch(text) is not None


def is_user_table(file: ControlFile) -> bool:
    """Return whether a file is such a table: its first line that is not blank begins with BEGIN."""
    lines = file.content[:10_000].decode("latin-1").splitlines()
    first = next((line for line in lines if line.strip()), "")
    return first.split()[:1] != [] and first.split()[0].upper() == "BEGIN"


def read_table_text(
    definition: Definition, file: ControlFile, faults: list[Fault]
) -> UserTable | None:
    """Return the table in a file; None when something is wrong with it, which goes to ``faults``
    with its line.
    """
    table, found = _read(text_reader(definition), file)
    faults.extend(found)
    return table


@lru_cache(maxsize=KEPT_TABLES)
def _read(reader: TextReader, file: ControlFile) -> tuple[UserTable | None, tuple[Fault, ...]]:
    faults: list[Fault] = []
    return parse_table(reader, file, faults), tuple(faults)


def parse_table(reader: TextReader, file: ControlFile, faults: list[Fault]) -> UserTable | None:
    """Return a table that was not read before; as `read_table_text`."""
    return _TableReader(reader, file, faults).read()


@dataclass(frozen=True, slots=True)
class _Line:
    number: int
    text: str
    start: int
    next: int

    @property
    def words(self) -> list[Cell]:
        return [
            Cell(match[0], match.start(), match.end())
            for match in re.finditer(r"[^ \t]+", self.text)
        ]


class _TableReader:
    def __init__(self, reader: TextReader, file: ControlFile, faults: list[Fault]) -> None:
        self.reader = reader
        self.definition = reader.definition
        self.file = file
        self.faults = faults
        self.known = len(faults)

    def read(self) -> UserTable | None:
        if _BINARY.search(self.file.content):
            self._fault("is not a text file", None, expected="a table as the control exports it")
            return None
        lines = [line for line in self._lines() if line.text.strip()]
        opened = self._opened(lines[0])
        if opened is None:
            return None
        kind, head = opened
        end = next(
            (
                place
                for place, line in enumerate(lines)
                if place and line.words[0].text.upper() in _ENDS
            ),
            None,
        )
        if end is None:
            self._fault(
                "the table has no end; it may have been cut short",
                lines[-1],
                expected="a last line END or [END]",
            )
            return None
        self._closed(lines[end], head["name"].text, "COM" if kind == "values" else "CMA")
        for line in lines[end + 1 :]:
            self._fault(
                "more text follows the end of the table",
                line,
                expected="one table in a file",
                found=line.text.strip(),
            )
        names = self._names(lines[1]) if end > 1 else []
        if end <= 2 and len(self.faults) == self.known:
            self._fault(
                "the table holds no rows: this is contradictory, not an empty table",
                lines[min(end, 1)],
                expected="NR, then rows",
            )
        if len(self.faults) > self.known:
            return None
        return self._table(kind, head, lines[1], names, lines[2:end])

    def _lines(self) -> list[_Line]:
        text = self.file.content.decode("latin-1")
        lines: list[_Line] = []
        start = 0
        for piece in text.split("\n"):
            shown = piece.removesuffix("\r").removesuffix("\x1a")
            lines.append(
                _Line(len(lines) + 1, shown, start, min(start + len(piece) + 1, len(text)))
            )
            start += len(piece) + 1
        return lines

    def _opened(self, line: _Line) -> tuple[Kind, dict[str, Cell]] | None:
        kinds: tuple[tuple[Kind, str], ...] = (("values", VALUES), ("assignments", ASSIGNMENTS))
        for kind, name in kinds:
            statement = self.definition.statements[name]
            for form in self.reader.matchers[name].forms:
                match = form.fullmatch(line.text)
                if match is not None and match["unit"].upper() in ("MM", "INCH"):
                    fields = {key: match.span(key) for key in statement.fields}
                    return kind, {
                        key: Cell(line.text[a:b], line.start + a, line.start + b)
                        for key, (a, b) in fields.items()
                    }
        forms = [
            self.definition.statements[name].form.replace("{", "<").replace("}", ">")
            for _, name in kinds
        ]
        self._fault(
            "the first line cannot be read",
            line,
            expected=" or ".join(forms),
            found=line.text.strip(),
        )
        return None

    def _closed(self, line: _Line, name: str, ending: str) -> None:
        """The last line may name its table; another name is the end of another table."""
        said = "".join(word.text for word in line.words[1:])
        if said and said.upper() != f"{name}.{ending}".upper():
            self._fault(
                "this is the end of another table",
                line,
                expected=f"END {name} .{ending}",
                found=line.text.strip(),
            )

    def _names(self, line: _Line) -> list[str]:
        names = [self._spelling(word.text) for word in line.words]
        if names[0].upper() != ROW_NUMBER or len(names) < 2:
            self._fault(
                "the names of the columns are missing",
                line,
                expected="NR, then the columns",
                found=line.text.strip(),
            )
        for name in dict.fromkeys(names):
            if names.count(name) > 1:
                self._fault(f"the column {name} stands twice", line)
        return [ROW_NUMBER, *names[1:]]

    def _spelling(self, name: str) -> str:
        upper = name.upper()
        return upper if upper in RESERVED or self.definition.addresses.case == "ignored" else name

    def _table(
        self,
        kind: Kind,
        head: Mapping[str, Cell],
        header: _Line,
        names: list[str],
        lines: Sequence[_Line],
    ) -> UserTable | None:
        titles = header.words
        spans, which = self._assigned(titles, lines)
        if spans is None:
            return None
        rows = []
        for number, (line, places) in enumerate(zip(lines, spans, strict=True)):
            cells = {
                names[place]: Cell(word.text, line.start + word.start, line.start + word.end)
                for place, word in zip(places, line.words, strict=True)
            }
            found = cells.get(ROW_NUMBER)
            if (
                found is None
                or not re.fullmatch("[0-9]{1,6}", found.text)
                or int(found.text) != number
            ):
                shown = found.text if found else "nothing"
                self._fault(
                    "the rows are not numbered one by one from 0",
                    line,
                    expected=str(number),
                    found=shown,
                )
            rows.append(Row(line.number, line.start, line.start + len(line.text), line.next, cells))
        if len(self.faults) > self.known:
            return None
        columns = _columns(names, titles, rows, which)
        return UserTable(self.file.name, kind, head, columns, tuple(rows))

    def _assigned(
        self, titles: Sequence[Cell], lines: Sequence[_Line]
    ) -> tuple[list[list[int]] | None, str]:
        """Return, for every row, the column of each word; None where that is not sure. And how
        cells stand: left, right, free.
        """
        words = [line.words for line in lines]
        tabs = any("\t" in line.text for line in lines)
        left = None if tabs else [_places(row, _left_slots(titles)) for row in words]
        right = None if tabs else [_places(row, _right_slots(titles)) for row in words]
        full = [list(range(len(titles))) for _ in words]
        if all(len(row) == len(titles) for row in words):
            return full, "left" if left == full else "right" if right == full else "free"
        sides = [
            (side, name)
            for side, name in ((left, "left"), (right, "right"))
            if side is not None and None not in side
        ]
        if len(sides) == 2 and left != right:
            place = next(index for index in range(len(lines)) if left[index] != right[index])  # type: ignore[index]
            self._fault(
                "a cell stands between two columns, and other cells are blank: it is not sure whose"
                " it is",
                lines[place],
            )
            return None, ""
        if sides:
            return [places or [] for places in sides[0][0]], sides[0][1]
        bad = next(line for line, row in zip(lines, words, strict=True) if len(row) != len(titles))
        self._fault(
            "the cells of this row do not stand under the names of the columns",
            bad,
            expected=f"{len(titles)} cells, or blank cells in fixed widths",
            found=bad.text.strip(),
        )
        return None, ""

    def _fault(self, message: str, line: _Line | None, expected: str = "", found: str = "") -> None:
        place = "" if line is None else f"line {line.number}"
        self.faults.append(
            Fault(
                message=message,
                file=self.file.name,
                place=place,
                expected=expected,
                found=found[:60],
            )
        )


_Slot = tuple[int, int | None]


def _left_slots(titles: Sequence[Cell]) -> list[_Slot]:
    starts = [0, *(title.start for title in titles[1:])]
    return list(zip(starts, [*starts[1:], None], strict=True))


def _right_slots(titles: Sequence[Cell]) -> list[_Slot]:
    ends: list[int] = [title.end for title in titles]
    return list(zip([0, *ends[:-1]], ends, strict=True))


def _places(words: Sequence[Cell], slots: Sequence[_Slot]) -> list[int] | None:
    """Return the slot of each word; None when a word crosses a boundary or two share a slot."""
    places: list[int] = []
    for word in words:
        fitting = (
            place
            for place, (low, high) in enumerate(slots)
            if low <= word.start and (high is None or word.end <= high)
        )
        place = next(fitting, -1)
        if place < 0 or (places and place <= places[-1]):
            return None
        places.append(place)
    return places


def _columns(
    names: Sequence[str], titles: Sequence[Cell], rows: Sequence[Row], which: str
) -> tuple[Column, ...]:
    if which == "free":
        return tuple(Column(name, 0, None, "free", 0) for name in names)
    slots = _left_slots(titles) if which == "left" else _right_slots(titles)
    found = {
        name: [
            (row.cells[name].start - row.start, row.cells[name].end - row.start)
            for row in rows
            if name in row.cells
        ]
        for name in names
    }
    columns = []
    for name, title, (low, high) in zip(names, titles, slots, strict=True):
        if which == "right":
            columns.append(Column(name, low, high, "right", title.end))
            continue
        spans, origin = found[name], title.start
        if not spans:  # a blank column: as its neighbours
            spans = [
                (a - other.start + origin, b - other.start + origin)
                for key, other in zip(names[1:], titles[1:], strict=True)
                for a, b in found[key]
            ]
        starts, ends = {a for a, _ in spans}, {b for _, b in spans}
        if len(starts) > 1 and len(ends) == 1:
            columns.append(Column(name, low, high, "right", ends.pop()))
        else:
            columns.append(
                Column(
                    name, low, high, "left", starts.pop() if len(starts) == 1 else max(low, origin)
                )
            )
    return tuple(columns)


def set_cell(table: UserTable, line: str, name: str, text: str) -> str:
    """Return a line of the table with ``text`` in a column: every other column keeps its place and
    its characters.

    Raises NotHeld when the text does not fit the width of the column.
    """
    column = table.column(name)
    if column is None:
        raise NotHeld(f"{table.file} has no column {name}")
    if column.flush == "free":
        raise NotHeld(f"{table.file}: the cells of the column {name} do not stand in fixed widths")
    start = column.edge if column.flush == "left" else column.edge - len(text)
    end = start + len(text)
    # One blank stays between neighbours: behind cells that begin flush, before cells that end flush
    # with the column.
    low = column.low + (
        1 if column.flush == "right" and column.high == column.edge and column.low else 0
    )
    high = None if column.high is None else column.high - (1 if column.flush == "left" else 0)
    if start < low or (high is not None and end > high):
        width = column.edge - low if column.flush == "right" else (high or 0) - column.edge
        raise NotHeld(
            f"{text} does not fit the column {name} of {table.file}, which is {width} characters"
            " wide"
        )
    stop = len(line) if column.high is None else min(len(line), column.high)
    region = " " * (start - column.low) + text
    return (
        line[: column.low].ljust(column.low) + region.ljust(max(0, stop - column.low)) + line[stop:]
    )


def cell_changes(table: UserTable, row: Row, line: str, cells: Mapping[str, str]) -> list[Change]:
    """Return the changes that put texts into cells of a row, by column name; ``line`` is the row's
    text as it stands.

    Raises NotHeld when a text does not fit its column.
    """
    free = [
        name
        for name in cells
        if (column := table.column(name)) is not None and column.flush == "free"
    ]
    if free:
        return [
            Change(row.cells[name].start, row.cells[name].end, cells[name].encode("ascii"))
            for name in cells
        ]
    changed = line
    for name, text in cells.items():
        changed = set_cell(table, changed, name, text)
    return [Change(row.start, row.end, changed.encode("latin-1"))] if changed != line else []
