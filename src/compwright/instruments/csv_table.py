"""Read the rows below a header row, separated by comma, semicolon or tab, quoted or not."""

from __future__ import annotations

import csv
import re
from array import array
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, repeat

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.key_faults import nearest
from compwright.instruments.comments import SEPARATOR_START, comment_text
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import parse_number
from compwright.instruments.readings import IntArray

DELIMITERS = {",": "comma", ";": "semicolon", "\t": "tab"}
COLUMNS = frozenset(
    {
        "target_mm",
        "target_deg",
        "direction",
        "run",
        "deviation_um",
        "deviation_mm",
        "deviation_arcsec",
        "deviation_deg",
        "measured_mm",
        "measured_deg",
    }
)
#: Columns of circular tests: here, so that a positioning test loads nothing circular.
CIRCULAR_VALUES = ("radius_mm", "deviation_um")
CIRCULAR_COLUMNS = ("direction", "run", "angle_deg", *CIRCULAR_VALUES)
#: The parts of a name of a traverse as spreadsheets and people write it: ``+1``, ``+ 1``, ``1 -``,
#: ``-2.0``, ``+3 up``, ``run 3 (+)``, ``3↑``.
_PART_OF_TRAVERSE = re.compile(
    r"(?P<number>[0-9]{1,9})(?:[.,]0+)?(?![0-9.,])|(?P<sign>[+-])|(?P<arrow>[↑↓])|(?P<word>[a-z]+)"
    r"|[ #()_]"
)
_NO_MEANING = frozenset({"run", "traverse", "no"})
#: Words that repeat the meaning of a sign in the same header.
_WORDS_OF_SIGN = dict.fromkeys(("up", "pos", "positive", "plus"), "+") | dict.fromkeys(
    ("down", "neg", "negative", "minus"), "-"
)
_ARROWS = {"↑": "+", "↓": "-"}
#: What a column is about that may be meant as a traverse: a sign, or a word for a direction or a
#: run, next to a number.
_LIKE_TRAVERSE = re.compile(
    r"(?<![a-z0-9])[+±-] ?[0-9]|[0-9] ?[+±-](?![a-z0-9])|[↑↓→←]"
    r"|\b(?:up|down|fwd|bwd|rev|pos|neg|plus|minus|forward|backward|reverse|run|traverse)\b"
)
#: Dashes and plus signs that word processors put in the place of the plain ones.
_DASHES = "\u2010\u2011\u2012\u2013\u2014\u2212\uff0d\ufe63"
_SIGNS = str.maketrans(dict.fromkeys(_DASHES, "-") | {"\uff0b": "+", "\ufe62": "+"})
_INCH = re.compile(
    r"(?:target|deviation|measured|radius|unit)["
    r" _]?\(?(?:in|inch|inches|\"|mil|mils|thou|uin|u?inch|microinch(?:es)?)\)?"
)
_BLANK = " \t,;"  # what a line without cells consists of
#: How a line begins that may be blank or set the delimiter.
_DOUBTFUL_START = frozenset(("", *_BLANK, *SEPARATOR_START))
_AT_ONCE = 5000  # rows that are looked at or turned into columns at once
#: What to do with inches, which no form of measurement files takes.
INCHES = (
    "target_mm and deviation_um: multiply targets in inches by 25.4 to get mm, deviations in 0.001"
    " inch by 25.4 to get um"
)


@dataclass(frozen=True, slots=True)
class CsvTable:
    """The cells of a CSV table by column, with the line numbers of its rows and of its header.

    The table is stored by column, because it may have a million rows. ``lines``: the line number of
    each row. ``cells``: for each column the texts of its cells without blanks at the ends.
    """

    delimiter: str
    line: int
    columns: tuple[str, ...]
    lines: Sequence[int]
    cells: tuple[Sequence[str], ...]

    def of(self, column: str) -> Sequence[str]:
        """Return the cells of a column by its name."""
        return self.cells[self.columns.index(column)]

    def place(self, column: str) -> Callable[[int], str]:
        """Return a function that gives line and column of a row's cell as text."""
        return lambda index: f"line {self.lines[index]}, column {column}"

    def which(
        self, column: str, words: tuple[str, str], spelt: Callable[[str], str], faults: FaultList
    ) -> IntArray:
        """Return, for each cell of a column, the index (0 or 1) of that one of the two ``words``
        which is in the cell; -1 and a fault for any other cell. ``spelt``: gives a cell in the
        spelling of the words.
        """
        cells, place = self.of(column), self.place(column)
        places = {words[0]: 0, words[1]: 1}
        known = {text: places.get(spelt(text), -1) for text in set(cells)}
        if -1 in known.values():
            for index, text in enumerate(cells):
                if known[text] < 0:
                    faults.add(
                        f"{column} is neither {words[0]} nor {words[1]}",
                        place=place(index),
                        expected=f"{words[0]} or {words[1]}",
                        found=shown(text),
                        hint=f"write {words[0]} or {words[1]}",
                    )
        return np.fromiter(map(known.__getitem__, cells), np.int64, len(cells))


def column_name(text: str) -> str:
    """Return a header cell in standard form: stripped, lower case, ``u`` for the micro sign, ``-``
    for minus.
    """
    return " ".join(plain_signs(text).lower().replace("µ", "u").replace("μ", "u").split())


def plain_signs(text: str) -> str:
    """Return ``text`` with every typographic minus or dash as ``-`` and the wide plus as ``+``."""
    return text.translate(_SIGNS)


def traverse_of(column: str) -> tuple[str, int] | None:
    """Return direction and run of a column named like ``+1``, ``- 2`` or ``run 3 +``, or None for
    another name.

    One sign or one arrow gives the direction. A word may repeat the direction, but ``up 3`` without
    a sign is not a traverse, and ``+3 down`` contradicts itself.
    """
    numbers: list[int] = []
    signs: list[str] = []
    words: list[str] = []
    at = 0
    while at < len(column):
        part = _PART_OF_TRAVERSE.match(column, at)
        if part is None:
            return None
        at = part.end()
        if part["number"]:
            numbers.append(int(part["number"]))
        elif part["sign"] or part["arrow"]:
            signs.append(part["sign"] or _ARROWS[part["arrow"]])
        elif part["word"] in _WORDS_OF_SIGN:
            words.append(_WORDS_OF_SIGN[part["word"]])
        elif part["word"] and part["word"] not in _NO_MEANING:
            return None
    if len(signs) != 1 or len(numbers) != 1 or numbers[0] < 1 or set(words) - set(signs):
        return None
    return signs[0], numbers[0]


def like_traverse(column: str) -> bool:
    """Return whether an unknown column name looks like that of a traverse: a number with a sign or
    direction.
    """
    return (
        any(character.isdigit() for character in column)
        and _LIKE_TRAVERSE.search(column) is not None
    )


def misspelt(columns: Sequence[str], known: Iterable[str]) -> dict[str, str]:
    """Return the columns whose names are probably misspelt, each with the ``known`` name that it
    resembles. Only known names that the file does not have are considered.

    A column resembles a known name if the whole names are similar and the first word of the column
    is similar to that of the known name, or begins with it, as in ``materal_c``, ``air temp`` or
    ``timestamp``.
    """
    missing = {name.partition("_")[0]: name for name in known if name not in columns}
    found = {}
    for column in columns:
        word = next(iter(re.findall(r"[^\W\d_]+", column)), "")
        begun = (one for one in missing if word == one or (len(one) > 3 and word.startswith(one)))
        near = next(begun, None) or nearest(word, missing, 0.75)
        if near is not None and nearest(column, [missing[near]], 0.55):
            found[column] = missing[near]
    return found


def in_inches(names: Iterable[str]) -> str:
    """Return the first of the ``names`` (of columns or units) that means inches, or "" if there is
    none.
    """
    return next((name for name in names if _INCH.fullmatch(name)), "")


@dataclass(frozen=True, slots=True)
class NumberedLines:
    """Lines of a file, ``texts``, each with its line number in ``numbers``."""

    numbers: Sequence[int]
    texts: Sequence[str]

    def __len__(self) -> int:
        """Return the number of lines."""
        return len(self.texts)

    def __iter__(self) -> Iterator[tuple[int, str]]:
        """Return the lines one by one: number and text."""
        return zip(self.numbers, self.texts, strict=True)

    def part(self, start: int, stop: int | None = None) -> NumberedLines:
        """Return the lines with the indices from ``start`` to below ``stop``."""
        return NumberedLines(self.numbers[start:stop], self.texts[start:stop])


def split_lines(lines: Sequence[str]) -> tuple[list[tuple[int, str]], NumberedLines]:
    """Return comment lines (without ``#``) and other non-blank lines, with line numbers from 1."""
    comments: list[tuple[int, str]] = []
    numbers, texts = array("q"), list[str]()
    for start in range(0, len(lines), _AT_ONCE):
        block = lines[start : start + _AT_ONCE]
        # A file may have a million lines: no look at each of those that are clearly rows.
        if "#" not in "".join(block) and _DOUBTFUL_START.isdisjoint([line[:1] for line in block]):
            numbers.extend(range(start + 1, start + 1 + len(block)))
            texts += block
            continue
        for number, line in enumerate(block, start=start + 1):
            may_be = "#" in line or line[:1] in SEPARATOR_START
            text = comment_text(line) if may_be else None
            if text is not None:
                comments.append((number, text))
            elif line[:1] not in _BLANK or line.strip(_BLANK):
                numbers.append(number)
                texts.append(line)
    return comments, NumberedLines(numbers, texts)


def rows_as_comments(
    lines: Sequence[str], header_line: int, cells_of: Callable[[str], list[str] | None], width: int
) -> list[tuple[int, str]]:
    """Return line number and text of each comment line below the header row that looks like a row
    of data: ``cells_of`` finds ``width`` cells in the line, and one after the first is a number.

    Such lines are rows that the user commented out, and rows whose target a spreadsheet shows as
    ``#####`` or ``#REF!``.
    """
    found = []
    for number, line in enumerate(lines[header_line:], start=header_line + 1):
        if comment_text(line) is not None:
            cells = cells_of(line)
            if cells is not None and len(cells) == width and any(map(is_number, cells[1:])):
                found.append((number, line))
    return found


def first_row(lines: Sequence[str]) -> tuple[int, str] | None:
    """Return number and text of the first line that is neither blank nor a comment, or None if
    there is no such line.
    """
    return next(
        (
            (number, line)
            for number, line in enumerate(lines, start=1)
            if line.strip(_BLANK) and comment_text(line) is None
        ),
        None,
    )


def header_names(header: str) -> tuple[str, list[str], int]:
    """Return the delimiter of a header row, its column names, and how many of these names are known
    from positioning files.

    The delimiter is the one that gives most known names; of several, the one that gives most cells.
    """
    best: tuple[str, list[str], int] = (",", [], 0)
    for delimiter in DELIMITERS:
        names = [column_name(cell) for cell in row_cells(header, delimiter) or ()]
        known = sum(name in COLUMNS or traverse_of(name) is not None for name in names)
        if (known, len(names)) > (best[2], len(best[1])):
            best = (delimiter, names, known)
    return best


def read_table(lines: NumberedLines, faults: FaultList) -> CsvTable:
    """Return the table in ``lines``, from which comments and blank lines have been removed. Each
    line has its number.

    These are added to ``faults``: a row with fewer or more cells than the header, a quote that is
    not closed, values in a column without a name, and a column name that is given twice. Raises
    InputError if the header row itself cannot be read.
    """
    number, header = next(iter(lines))
    delimiter, names, _ = header_names(header)
    if not names:
        raise InputError(
            Fault(
                message="the header row has a quotation mark that is not closed",
                file=faults.file,
                place=f"line {number}",
                hint="close the quotation mark in this row",
            )
        )
    columns = tuple(names)
    for name, count in Counter(name for name in columns if name).items():
        if count > 1:
            faults.add(
                "a column is given twice",
                place=f"line {number}",
                expected="each column once",
                found=shown(name),
                hint="rename or remove one of the two columns",
            )
    at, cells = _rows(lines.part(1), delimiter, columns, faults)
    return _without_unnamed(CsvTable(delimiter, number, columns, at, cells), faults)


def _rows(
    lines: NumberedLines, delimiter: str, columns: Sequence[str], faults: FaultList
) -> tuple[Sequence[int], tuple[Sequence[str], ...]]:
    """Return the line number of each row, and the cells of each column."""
    found = GatheredRows(len(columns))
    blocks = (lines.part(start, start + _AT_ONCE) for start in range(0, len(lines), _AT_ONCE))
    for number, line in chain.from_iterable(
        block for block in blocks if not found.add_plain(block, delimiter)
    ):
        cells = row_cells(line, delimiter)
        if cells is None:
            faults.add(
                "a quote is not closed on its line",
                place=f"line {number}",
                found=shown(line),
                hint="close the quote, or remove it",
            )
        elif len(cells) == len(columns):
            found.add(number, cells)
        elif any(cells):
            comma = _decimal_comma_hint(cells, delimiter, len(columns))
            faults.add(
                "the row has fewer or more cells than the header row",
                place=f"line {number}",
                expected=f"{len(columns)} cells with the {DELIMITERS[delimiter]} as delimiter",
                found=f"{len(cells)}{comma}",
                hint="put semicolons between the cells of all rows"
                if comma
                else "give this row as many cells as the header row",
            )
    return found.lines, found.columns()


class GatheredRows:
    """Collects rows and stores them as columns, in blocks of some thousand rows."""

    def __init__(self, width: int) -> None:
        self.lines = array("q")
        self._columns: tuple[list[str], ...] = tuple([] for _ in range(width))
        self._rows: list[Sequence[str]] = []

    def add(self, line: int, cells: Sequence[str]) -> None:
        """Add the cells of a row, one for each column."""
        self.lines.append(line)
        self._rows.append(cells)
        if len(self._rows) >= _AT_ONCE:
            self._turn()

    def add_plain(self, rows: NumberedLines, delimiter: str) -> bool:
        """Add several rows of text at once, and return True. Return False and add none if a row
        contains a quote or has too few or too many cells.
        """
        others = len(self._columns) - 1
        joined = delimiter.join(rows.texts)
        if '"' in joined or set(map(str.count, rows.texts, repeat(delimiter))) != {others}:
            return False
        self._turn()
        self.lines.extend(rows.numbers)
        cells = joined.split(delimiter)
        if joined.split(maxsplit=1) != [joined]:  # blanks anywhere
            cells = list(map(str.strip, cells))
        for index, column in enumerate(self._columns):
            column.extend(cells[index :: others + 1])
        return True

    def columns(self) -> tuple[Sequence[str], ...]:
        """Return the cells of each column."""
        self._turn()
        return self._columns

    def _turn(self) -> None:
        for column, cells in zip(self._columns, zip(*self._rows, strict=True), strict=False):
            column.extend(cells)
        self._rows.clear()


def _decimal_comma_hint(cells: Sequence[str], delimiter: str, wanted: int) -> str:
    if (
        delimiter != ","
        or len(cells) <= wanted
        or not all((cell in {"", "+", "-"} or is_number(cell)) for cell in cells)
    ):
        return ""
    return " (a decimal comma cannot be used where the comma is the delimiter)"


def is_number(text: str) -> bool:
    """Return whether ``text`` is only a number."""
    try:
        parse_number(text)
    except ValueError:
        return False
    return True


def _without_unnamed(table: CsvTable, faults: FaultList) -> CsvTable:
    """Remove the columns without a name that spreadsheets add at the end of a table. A value in
    such a column is a fault.
    """
    for index, name in enumerate(table.columns):
        if not name and any(table.cells[index]):
            for line, cell in zip(table.lines, table.cells[index], strict=True):
                if cell:
                    faults.add(
                        "a value is in a column without a name",
                        place=f"line {line}, column {index + 1}",
                        expected="a name in the header row or an empty cell",
                        found=shown(cell),
                        hint="name this column in the header row, or empty the cell",
                    )
    kept = [index for index, name in enumerate(table.columns) if name]
    return replace(
        table,
        columns=tuple(table.columns[index] for index in kept),
        cells=tuple(table.cells[index] for index in kept),
    )


def row_cells(line: str, delimiter: str) -> list[str] | None:
    """Return the cells of a line without surrounding blanks; None if a quote is not closed or a
    quoted cell is too large to be read.
    """
    if '"' not in line:
        return [cell.strip() for cell in line.split(delimiter)] if line else []
    if line.count('"') % 2:
        return None
    try:
        cells = next(csv.reader([line], delimiter=delimiter, skipinitialspace=True), [])
    except csv.Error:
        return None
    return [cell.strip() for cell in cells]
