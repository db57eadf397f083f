"""Read numbers with a decimal point or a decimal comma; a file must not mix the two."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.readings import IntArray
from compwright.records.axis import FloatArray

#: Typographic minus (U+2212), which word processors put in the place of the hyphen.
TYPOGRAPHIC_MINUS = "\u2212"
#: No position or deviation of a machine tool is larger, in whatever unit (1000 km in mm).
LARGEST = 1e9

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?")
#: What could as well be a whole number with thousands marks: 1,234 or 12.345.678 but not 0,500 or
#: 1,5.
_COULD_BE_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2}(?:[.,][0-9]{3})+")
_THOUSANDS = re.compile(r"[+-]?[0-9]{1,3}(?:[.,'’ \u00a0\u202f][0-9]{3})+(?:[.,][0-9]*)?")
_NOT_FINITE = re.compile(r"[+-]?(?:nan|inf|infinity|1\.?#\w+|#num!?|∞)", re.IGNORECASE)
#: How the names of columns with positions begin, which may all be 1000 or more.
_POSITIONS = ("target", "position")
_INTEGER = re.compile(r"[0-9]{1,9}")
#: Most digits before and after the decimal mark of a number that needs no second look, and most in
#: all of a whole number that is exact in floating point.
_MOST_DIGITS = 9, 12
_EXACT = 15


def parse_number(text: str) -> float:
    """Return the finite number in ``text`` with a decimal point or a decimal comma; blanks around
    are allowed.

    ``.0266`` and numbers with an exponent are accepted. Marks of thousands, units, nan and inf are
    refused. Raises ValueError; its text is the reason, in the form "is ...".
    """
    stripped = text.strip().replace(TYPOGRAPHIC_MINUS, "-")
    if not stripped:
        raise ValueError("is empty")
    if _NOT_FINITE.fullmatch(stripped):
        raise ValueError("is not a finite number")
    if not _NUMBER.fullmatch(stripped):
        raise ValueError(
            "has thousands marks" if _THOUSANDS.fullmatch(stripped) else "is not a number"
        )
    value = float(stripped.replace(",", "."))
    if abs(value) > LARGEST:
        raise ValueError("is too large to be a reading")
    return value


def parse_count(text: str) -> int:
    """Return the whole number of at least 1 in ``text``. Raises ValueError with the reason."""
    stripped = text.strip()
    if not _INTEGER.fullmatch(stripped) or int(stripped) < 1:
        raise ValueError("is not a whole number of at least 1")
    return int(stripped)


def plain_numbers(cells: Sequence[str], mark: str) -> FloatArray | None:
    """Return the numbers (n,) in the cells if each is a plain number with no decimal mark other
    than ``mark``, else None. A plain number has at most 9 digits before the mark and 12 after it.

    Up to `_EXACT` digits are read as a whole number and divided by a power of ten. Both are exact,
    so the quotient is rounded once, as `float` does.
    """
    joined = "\n".join([*cells, ""])
    text = np.frombuffer(joined.encode("ascii", "replace"), np.uint8)
    ends, marks = (np.flatnonzero(text == ord(sought)) for sought in ("\n", mark))
    if ends.size != len(cells):
        return None
    starts = np.append(0, ends + 1)[:-1]
    signed = (text[starts] == ord("+")) | (text[starts] == ord("-"))
    digits = np.count_nonzero((text >= ord("0")) & (text <= ord("9")))
    marked = np.searchsorted(ends, marks)
    decimals = np.zeros(ends.size, dtype=np.intp)
    decimals[marked] = ends[marked] - marks - 1
    whole = ends - starts - signed - decimals
    whole[marked] -= 1
    if (
        digits + np.count_nonzero(signed) + marks.size + ends.size != text.size
        or np.any(np.diff(marked) == 0)
        or np.any((whole < 1) | (whole > _MOST_DIGITS[0]) | (decimals > _MOST_DIGITS[1]))
        or np.any(decimals[marked] < 1)
    ):
        return None
    if np.any(whole + decimals > _EXACT):
        return np.fromiter(map(float, joined.replace(mark, ".").split()), np.float64, len(cells))
    powers = np.array([10.0**places for places in range(_EXACT)])
    mantissas = np.fromstring(joined.replace(mark, ""), np.int64, sep="\n")
    numbers: FloatArray = mantissas / powers[decimals]
    return numbers


def counts_of(
    cells: Sequence[str], place: Callable[[int], str], what: str, faults: FaultList
) -> IntArray:
    """Return the whole numbers of at least 1 in a column. Each other cell is a fault, whose message
    begins with ``what``, and becomes 0.
    """
    known: dict[str, int] = {}
    reasons: dict[str, str] = {}
    for text in set(cells):
        try:
            known[text] = parse_count(text)
        except ValueError as reason:
            known[text], reasons[text] = 0, str(reason)
    if reasons:
        for index, text in enumerate(cells):
            if text in reasons:
                faults.add(
                    f"{what} {reasons[text]}",
                    place=place(index),
                    expected="1, 2, 3, ...",
                    found=shown(text),
                )
    return np.fromiter(map(known.__getitem__, cells), np.int64, len(cells))


@dataclass(slots=True)
class _Marked:
    """The numbers of a file that have the same decimal mark: how many, where the first one is, and
    the first one of each column.
    """

    count: int = 0
    #: Line (0 where it is not counted) and place of the first.
    line: int = 0
    place: str = ""
    text: str = ""
    #: Whether one of them can only be a decimal fraction.
    proven: bool = False
    columns: dict[str, str] = field(default_factory=dict)


class DecimalMarks:
    """Checks the decimal mark of all numbers in one file. Pass every number to `parse`, then call
    `check`.
    """

    def __init__(self, faults: FaultList) -> None:
        self._faults = faults
        self._marked = {".": _Marked(), ",": _Marked()}
        self._unmarked_columns: set[str] = set()

    def parse(
        self, text: str, *, place: str, column: str, expected: str = "a number"
    ) -> float | None:
        """Return the number in a cell. If the cell contains none, add a fault, which states what
        was ``expected``, and return None.
        """
        try:
            value = parse_number(text)
        except ValueError as reason:
            self._faults.add(
                str(reason),
                place=place,
                expected=expected,
                found=shown(text) if text.strip() else "an empty cell",
            )
            return None
        mark = "," if "," in text else "." if "." in text else ""
        if not mark:
            self._unmarked_columns.add(column)
            return value
        seen = self._marked[mark]
        if not seen.count:
            seen.place, seen.text = place, text
        seen.count += 1
        seen.proven = seen.proven or not _COULD_BE_THOUSANDS.fullmatch(
            text.strip().replace(TYPOGRAPHIC_MINUS, "-")
        )
        seen.columns.setdefault(column, text)
        return value

    def parse_all(
        self,
        cells: Sequence[str],
        lines: Sequence[int] | IntArray,
        place: Callable[[int], str],
        column: str,
        expected: str = "a number",
    ) -> FloatArray:
        """Return the numbers (n,) in a column, NaN for an invalid cell. Each invalid cell is a
        fault, which states what was ``expected``.
        """
        for mark in self._marked:
            plain = plain_numbers(cells, mark)
            if plain is not None:
                self._see(mark, cells, lines, place, column)
                return plain
        found = (
            self.parse(text, place=place(index), column=column, expected=expected)
            for index, text in enumerate(cells)
        )
        numbers = (np.nan if value is None else value for value in found)
        return np.fromiter(numbers, np.float64, len(cells))

    def _see(
        self,
        mark: str,
        cells: Sequence[str],
        lines: Sequence[int] | IntArray,
        place: Callable[[int], str],
        column: str,
    ) -> None:
        """Count the numbers of a column that contain the decimal mark ``mark``."""
        marks = "".join(cells).count(mark)  # at most one in each of them
        every = range(len(cells))
        at = every if marks == len(cells) else [i for i in every if mark in cells[i]]
        if len(at) < len(cells):
            self._unmarked_columns.add(column)
        if not at:
            return
        seen = self._marked[mark]
        if not seen.count or lines[at[0]] < seen.line:
            seen.line, seen.place, seen.text = lines[at[0]], place(at[0]), cells[at[0]]
        seen.count += len(at)
        seen.proven = seen.proven or not all(
            _COULD_BE_THOUSANDS.fullmatch(cells[index]) for index in at
        )
        seen.columns.setdefault(column, cells[at[0]])

    def check(self, *, comma_is_delimiter: bool = False) -> None:
        """Add a fault for mixed decimal marks, or a decimal comma that is also the delimiter."""
        point, comma = self._marked["."], self._marked[","]
        if comma.count and comma_is_delimiter:
            self._faults.add(
                "the comma is the delimiter and the decimal mark at once",
                place=comma.place,
                expected="a decimal point, or semicolon or tab as delimiter",
                found=shown(comma.text),
                hint="save the file with a decimal point, or with the semicolon as delimiter",
            )
        elif point.count and comma.count:
            rare, other = sorted((point, comma), key=lambda marked: marked.count)
            self._faults.add(
                "decimal marks are mixed",
                place=rare.place,
                expected="decimal points or decimal commas throughout the file",
                found=(
                    f"{shown(rare.text)} here and {shown(other.text)} in {other.place}"
                    f" ({point.count} with a point, {comma.count} with a comma)"
                ),
                hint="write all numbers with the same decimal mark",
            )
        # A comma is the usual thousands mark of English text: it is refused until one number of the
        # file proves it decimal.
        elif comma.count and not comma.proven:
            self._faults.add(
                "may be a decimal fraction, or a number with thousands marks",
                place=comma.place,
                expected="numbers of which at least one shows the decimal mark",
                found=shown(comma.text),
                hint="write the number without thousands mark, or with decimals (1000.0)",
            )

    def doubtful_point(self) -> str:
        """Return a number such as ``1.250`` that was read as a decimal fraction but may mean 1250;
        "" if there is none.

        The decimal mark of this form is the point. A point is doubtful if no number of the file
        proves that it is the decimal mark and the same column has whole numbers (500, 750, 1.000).
        A column with 100.000 and 200.000 throughout is not doubtful, because instruments print
        numbers like this. Such a column of readings is a proof: with thousands marks, none of them
        would be below 1000.
        """
        point = self._marked["."]
        mixed = [text for name, text in point.columns.items() if name in self._unmarked_columns]
        readings = any(
            not name.startswith(_POSITIONS) and name not in self._unmarked_columns
            for name in point.columns
        )
        return mixed[0] if mixed and not point.proven and not readings else ""
