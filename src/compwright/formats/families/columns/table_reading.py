"""Read the text of a table that a control exports: one header of columns, then rows of cells of
fixed width.

    BEGIN X .COM MM DATUM:-400 DIST:16
    NR   1=F()     2=F()
    0    +0        +0
    END X .COM

Newer controls describe the columns before their names (`columns.description`). No manual shows such
a file as text. Therefore only what the file itself shows is taken as certain. Cells may be blank,
so the column of a cell follows from its place below the column names. A cell that fits two columns
is refused.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Token, readable
from compwright.formats.families.columns.description import (
    EDITION,
    TableDescription,
    read_description,
)
from compwright.formats.families.columns.table import (
    ASSIGNMENTS,
    RESERVED,
    ROW_NUMBER,
    VALUES,
    Kind,
    Row,
    TableColumn,
    UserTable,
)
from compwright.formats.text.texts import BINARY, TextLine, TextReader, no_text, text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Each table is parsed once in a run.
KEPT_TABLES = 128
_ENDS = ("END", "[END]")
_KIND = re.compile(r"[ \t]*BEGIN[ \t]+[^. \t]+[ \t]*\.[ \t]*([A-Za-z0-9]+)", re.IGNORECASE)
_KINDS = ("COM", "CMA", "CMO")


def is_user_table(file: ControlFile) -> bool:
    """Return whether a file is an exported table: its first non-blank line begins with BEGIN."""
    lines = file.content[:10_000].decode("latin-1").splitlines()
    first = next((line for line in lines if line.strip()), "")
    return first.split()[:1] != [] and first.split()[0].upper() == "BEGIN"


def is_other_table(file: ControlFile) -> bool:
    """Return whether an exported table is not for compensation but for tools, pallets or datums."""
    first = next((line for line in file.content[:10_000].splitlines() if line.strip()), b"")
    match = _KIND.match(first.decode("latin-1"))
    return match is not None and match[1].upper() not in _KINDS


def read_table_text(
    definition: Definition, file: ControlFile, faults: list[Fault]
) -> UserTable | None:
    """Return the table in a file; None if it contains faults, which are added to ``faults`` with
    their lines.
    """
    table, found = _read(text_reader(definition), file)
    faults.extend(found)
    return table


@lru_cache(maxsize=KEPT_TABLES)
def _read(reader: TextReader, file: ControlFile) -> tuple[UserTable | None, tuple[Fault, ...]]:
    faults: list[Fault] = []
    return parse_table(reader, file, faults), tuple(faults)


def parse_table(reader: TextReader, file: ControlFile, faults: list[Fault]) -> UserTable | None:
    """Return the table in a file, without the cache of `read_table_text`."""
    return _ColumnTableReader(reader, file, faults).read()


def _words(line: TextLine) -> list[Token]:
    return [
        Token(match[0], match.start(), match.end()) for match in re.finditer(r"[^ \t]+", line.text)
    ]


class _ColumnTableReader:
    def __init__(self, reader: TextReader, file: ControlFile, faults: list[Fault]) -> None:
        self.reader = reader
        self.definition = reader.definition
        self.file = file
        self.faults = faults
        self.known = len(faults)
        self.description = TableDescription()

    def read(self) -> UserTable | None:
        if BINARY.search(self.file.content):
            message = no_text(self.file.content)
            self._fault(message, None, expected="a table as the control exports it")
            return None
        text = self.file.content.decode("latin-1")
        lines = [line for line in self.reader.lines(text) if line.text.strip()]
        opened = self._opened(lines[0])
        if opened is None:
            return None
        kind, head = opened
        self.description = read_description([line.text for line in lines[1:]])
        if self.description.lines is None:
            message = "the description of the columns has no end; the table may have been cut short"
            self._fault(message, lines[1], expected="#STRUCTEND, or the last )")
            return None
        del lines[1 : 1 + self.description.lines]
        firsts = [_words(line)[0].text.upper() for line in lines]
        end = next((place for place, word in enumerate(firsts) if place and word in _ENDS), None)
        if end is None:
            message = "the table has no end; it may have been cut short"
            self._fault(message, lines[-1], expected="a last line END or [END]")
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
                "the table contains no rows, so it is cut short rather than empty",
                lines[min(end, 1)],
                expected="NR, then rows",
            )
        if len(self.faults) > self.known:
            return None
        return self._table(kind, head, lines[1], names, lines[2:end])

    def _opened(self, line: TextLine) -> tuple[Kind, dict[str, Token]] | None:
        kinds: tuple[tuple[Kind, str], ...] = (("values", VALUES), ("assignments", ASSIGNMENTS))
        for kind, name in kinds:
            statement = self.definition.statements[name]
            for form in self.reader.matchers[name].forms:
                match = form.fullmatch(EDITION.sub("", line.text))
                if match is not None and match["unit"].upper() in ("MM", "INCH"):
                    fields = {key: match.span(key) for key in statement.fields}
                    return kind, {
                        key: Token(line.text[a:b], line.start + a, line.start + b)
                        for key, (a, b) in fields.items()
                    }
        forms = [readable(self.definition.statements[name].form) for _, name in kinds]
        self._fault(
            "the first line cannot be read",
            line,
            expected=" or ".join(forms),
            found=line.text.strip(),
        )
        return None

    def _closed(self, line: TextLine, name: str, ending: str) -> None:
        """Check that the file's last line ends the table; if that line names a table, it must be
        the name of this table.
        """
        named = "".join(word.text for word in _words(line)[1:])
        if named and named.upper() != f"{name}.{ending}".upper():
            self._fault(
                "this is the end of another table",
                line,
                expected=f"END {name} .{ending}",
                found=line.text.strip(),
            )

    def _names(self, line: TextLine) -> list[str]:
        names = [self._spelling(word.text) for word in _words(line)]
        key = self.description.key or ROW_NUMBER
        if names[0].upper() not in (ROW_NUMBER, key) or len(names) < 2:
            self._fault(
                "the names of the columns are missing",
                line,
                expected=f"{key}, then the columns",
                found=line.text.strip(),
            )
        for name in names:
            described = self.description.of(name)
            if described is not None and described.inch:
                self._fault(
                    f"the column {name} is described in inch: whether its values are is not known",
                    line,
                    expected="a table in mm",
                    found="unitIsInch:=TRUE",
                )
        for name in dict.fromkeys(names):
            if names.count(name) > 1:
                self._fault(f"the column {name} is in the table twice", line)
        return [ROW_NUMBER, *names[1:]]

    def _spelling(self, name: str) -> str:
        upper = name.upper()
        return upper if upper in RESERVED or self.definition.addresses.case == "ignored" else name

    def _table(
        self,
        kind: Kind,
        head: Mapping[str, Token],
        header: TextLine,
        names: list[str],
        lines: Sequence[TextLine],
    ) -> UserTable | None:
        titles = _words(header)
        spans, which = self._assigned(titles, lines)
        if spans is None:
            return None
        rows = []
        for number, (line, places) in enumerate(zip(lines, spans, strict=True)):
            cells = {
                names[place]: Token(word.text, line.start + word.start, line.start + word.end)
                for place, word in zip(places, _words(line), strict=True)
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
            rows.append(Row(line.number, line.start, line.start + len(line.text), cells))
        if len(self.faults) > self.known:
            return None
        columns = tuple(
            replace(column, described=self.description.of(column.name))
            for column in _columns(names, titles, rows, which)
        )
        return UserTable(self.file.name, kind, head, columns, tuple(rows))

    def _assigned(
        self, titles: Sequence[Token], lines: Sequence[TextLine]
    ) -> tuple[list[list[int]] | None, str]:
        """Return, for each row, the index of the column to which each of its words belongs, and the
        alignment of all cells (left, right, free).

        Instead of the indices, None is returned if the columns are ambiguous.
        """
        words = [_words(line) for line in lines]
        tabs = any("\t" in line.text for line in lines)
        described = self.description.fits([(title.text, title.start) for title in titles])
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
        if described and left is not None and None not in left:
            return [places or [] for places in left], "left"
        if len(sides) == 2 and left != right:
            place = next(index for index in range(len(lines)) if left[index] != right[index])  # type: ignore[index]
            self._fault(
                "a cell is between two columns, and other cells are blank: it is uncertain to which"
                " column it belongs",
                lines[place],
            )
            return None, ""
        if sides:
            return [places or [] for places in sides[0][0]], sides[0][1]
        bad = next(line for line, row in zip(lines, words, strict=True) if len(row) != len(titles))
        self._fault(
            "the cells of this row are not below the names of the columns",
            bad,
            expected=f"{len(titles)} cells, or blank cells in fixed widths",
            found=bad.text.strip(),
        )
        return None, ""

    def _fault(
        self, message: str, line: TextLine | None, expected: str = "", found: str = ""
    ) -> None:
        place = "" if line is None else f"line {line.number}"
        self.faults.append(
            Fault(
                message=message,
                file=self.file.name,
                place=place,
                expected=expected,
                found=found[:60],
                hint="correct the table in a copy of the file, or export it from the control again",
            )
        )


_Slot = tuple[int, int | None]


def _left_slots(titles: Sequence[Token]) -> list[_Slot]:
    starts = [0, *(title.start for title in titles[1:])]
    return list(zip(starts, [*starts[1:], None], strict=True))


def _right_slots(titles: Sequence[Token]) -> list[_Slot]:
    ends: list[int] = [title.end for title in titles]
    return list(zip([0, *ends[:-1]], ends, strict=True))


def _places(words: Sequence[Token], slots: Sequence[_Slot]) -> list[int] | None:
    """Return the index of the column to which each word belongs; None if a word fits no column, or
    if words are not in the order of the columns. ``slots``: the range of characters of each column.
    """
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
    names: Sequence[str], titles: Sequence[Token], rows: Sequence[Row], which: str
) -> tuple[TableColumn, ...]:
    if which == "free":
        return tuple(TableColumn(name, 0, None, "free", 0) for name in names)
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
            columns.append(TableColumn(name, low, high, "right", title.end))
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
            columns.append(TableColumn(name, low, high, "right", ends.pop()))
        else:
            columns.append(
                TableColumn(
                    name, low, high, "left", starts.pop() if len(starts) == 1 else max(low, origin)
                )
            )
    return tuple(columns)
