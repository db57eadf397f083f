"""Read the blocks of FANUC text files as the control does: parameters and pitch error data.

This is a second, small reader on purpose. It shares no code with the package that writes these
files. Sources of the text form:

- 30i/31i/32i: parameter manual B-63950EN/02 p. 8, 11, 12: ``N03620Q1A1P40A2P0``. A is the
  controlled axis number, S the spindle, L the path. The value follows P, or M / I for metric / inch
  lengths. Bits are eight digits, of which the rightmost is bit 0.
- 15i and older: parameter manual B-63330EN/03 p. 21, 25: the same without Q, ``%;`` first. Old
  machines write blanks between the words (``N01825 A1 P 3000``).
- Pitch data ``N1nnnnQ0P<increment>`` (10000 + point number) and program entry (``G10L50`` or
  ``G10L52`` to ``G11``, ``N<parameter>P<axis>R<value>``) are known from practice only. No manual
  page was found.

Values are kept as text here; ``memory`` converts them to numbers.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Literal

from compwright.controllers.fanuc.series import ControlSeries
from compwright.controllers.places import OfLine
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: First number of the pitch data in a file: point 0 is N10000.
POINT_BASE = 10000

#: Parameters that decide the correction of an axis.
WATCHED = frozenset({1001, 1004, 1006, 1013, 1800, 1851, 1852, 3605, *range(3620, 3628)})

#: How a point was marked as pitch data: by Q0 or by a sheet. A record without Q is a point in a
#: file of nothing else ("alone"), and may be one in a file with parameters ("with_parameters"). Q1
#: marks a parameter, whatever its number.
Mark = Literal["Q0", "alone", "with_parameters", "sheet"]

_BREAK = re.compile(r"\n\r*|\r\n|\r")
_COMMENT = re.compile(r"\([^()]*\)")
_NUMBERED = re.compile(r"N\s*([0-9]{1,12})(?![0-9])")
_WORD = re.compile(r"\s*([A-Z])\s*(-?(?:[0-9]+\.?[0-9]*|\.[0-9]+))")
#: A record of pitch data behind its number: one small whole number.
_RECORD = re.compile(r"\s*(?:Q\s*0)?\s*P\s*-?[0-9]{1,4}\s*")
_ENTRY = re.compile(r"(?:N\s*[0-9]+\s*)?G\s*10\s*L\s*5[02]\s*")
_ENTRY_ENDS = re.compile(r"(?:N\s*[0-9]+\s*)?G\s*11\s*")
_PROGRAM_WORDS = re.compile(r"[O:]\s*[0-9]+|M\s*(?:30|0?2|99)")
# Looks like one of our blocks with damage: never passed over in silence.
_SUSPECT = re.compile(r"(?<![0-9])[0-9]{3,}\s*[QALPR]\s*[-+]?[0-9]|\AN\s*[0-9]", re.IGNORECASE)
_LONGEST_VALUE = 24
#: Files whose content is kept, as many as a job has in all its states.
KEPT_FILES = 64


@dataclass(frozen=True, slots=True)
class ParameterSetting(OfLine):
    """One value of a parameter.

    ``axis``: controlled axis number, None for a parameter of no axis. ``bit``: number of a single
    bit, None for the whole value. ``keyword``: P, M or I as in a file, or the unit in an entry
    sheet (pulse, mm, deg or nothing).
    """

    number: int
    axis: int | None
    bit: int | None
    keyword: str
    text: str
    file: str
    line: int

    @property
    def label(self) -> str:
        """The parameter number with bit and axis, as text for messages."""
        bit = "" if self.bit is None else f"#{self.bit}"
        return f"parameter {self.number}{bit}" + (
            "" if self.axis is None else f" of axis {self.axis}"
        )

    @property
    def shown(self) -> str:
        """The value as written in the file."""
        return self.text


@dataclass(frozen=True, slots=True)
class PointRecord(OfLine):
    """One record of pitch error data: point number from 0, increment as written, and kind of
    record.
    """

    number: int
    text: str
    mark: Mark
    file: str
    line: int

    @property
    def shown(self) -> str:
        """The value as written in the file."""
        return self.text


@dataclass(slots=True)
class TapeContent:
    """The contents of one file: parameters and points in order, notes, and faults."""

    settings: list[ParameterSetting] = field(default_factory=list)
    points: list[PointRecord] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


@lru_cache(maxsize=KEPT_FILES)
def read_file(file: ControlFile, series: ControlSeries) -> TapeContent:
    """Return the contents of one ASCII file.

    A line ends with LF, CR LF, LF CR CR or CR. Parameter numbers are converted to the standard
    numbers (`ControlSeries.number_here`). Errors become faults in the result; nothing is raised.
    The result is cached by content: do not change it.
    """
    if b"\x00" in file.content:
        fault = Fault(
            message="the file is a binary file",
            file=file.name,
            expected="the text that the control punches out",
            hint="punch the file out of the control as text",
        )
        return TapeContent(faults=[fault])
    reader = _TapeReader(file.name, series)
    text = file.content.decode("latin-1").removeprefix("\xef\xbb\xbf")
    for number, line in enumerate(_BREAK.split(text), start=1):
        reader.take(line, number)
    reader.finish(ends_with_break=text.endswith(("\n", "\r")))
    return reader.found


class _Unreadable(Exception):  # noqa: N818  # a signal inside this module
    """Raised for a block that cannot be read; its text states what was expected."""


class _TapeReader:
    """Reads a FANUC text file (parameters or pitch error data) line by line.

    ``marks``: the number of ``%`` lines so far. An odd one opens a tape section, an even one closes
    it.
    """

    def __init__(self, file: str, series: ControlSeries) -> None:
        self.file = file
        self.series = series
        self.found = TapeContent()
        self.marks = 0
        self.programmed = False
        self.before: list[int] = []
        self.last_block = 0
        self.last_text = 0
        self.lines = 0
        self.strange: list[int] = []
        self.parameters = False
        self.above = False

    def take(self, raw: str, number: int) -> None:
        """Read one line of a file with parameters or pitch error data."""
        self.lines = number
        line = _COMMENT.sub(" ", raw).strip()
        if line.startswith("%"):
            self.marks += 1
            if _NUMBERED.search(line[1:].strip()):
                self._wrong(number, raw, "a block behind % is not read", "% on a line of its own")
            return
        if not line:
            return
        self.last_text = number
        match = _NUMBERED.match(line)
        if match is not None:
            self.parameters |= int(match[1]) < POINT_BASE
            self.above |= int(match[1]) >= POINT_BASE and not _RECORD.fullmatch(line[match.end() :])
        if _ENTRY.fullmatch(line):
            self.programmed = True
        elif _ENTRY_ENDS.fullmatch(line):
            self.programmed = False
        elif match is None:
            self._other(line, raw, number)
        elif self.series.number_here(int(match[1])) in WATCHED or int(match[1]) >= POINT_BASE:
            self.last_block = number
            try:
                self._place(number)
                self._block(int(match[1]), line[match.end() :], number)
            except _Unreadable as error:
                self._wrong(number, raw, "the block cannot be read", str(error))

    def finish(self, *, ends_with_break: bool) -> None:
        """Check the file as a whole (``%`` at start and end), and mark the point records without Q.
        ``ends_with_break``: the file ends with a line break.

        A record without Q is marked as a point if the file contains no parameters. Else it is
        marked as doubtful, because it may be a parameter. If a block with a number from 10000 on
        has the form of a parameter, all records without Q are removed.
        """
        mark: Mark = "with_parameters" if self.parameters else "alone"
        kept = [record for record in self.found.points if record.mark == "Q0" or not self.above]
        self.found.points = [
            record if record.mark == "Q0" else replace(record, mark=mark) for record in kept
        ]
        if self.before and self.marks and (self.marks != 1 or self.last_block > self.before[-1]):
            self._wrong(
                self.before[0],
                "",
                "data before the first %, which the control does not read",
                "% as the first line",
            )
        elif self.before and self.marks:
            self.found.notes.append(f"{self.file}: no % at the start")
        elif self.marks % 2:
            if not ends_with_break and self.last_text == self.lines:
                self._wrong(
                    self.lines, "", "the file ends within a block", "a line break and % at the end"
                )
            self.found.notes.append(
                f"{self.file}: no % at the end: the file may have been cut short"
            )
        if self.strange:
            which = f"{len(self.strange)} (first at line {self.strange[0]})"
            self.found.notes.append(
                f"{self.file}: lines that are not parameter blocks were not read: {which}"
            )

    def _wrong(self, number: int, raw: str, message: str, expected: str) -> None:
        found = repr(raw.strip()[:80]) if raw else ""
        self.found.faults.append(
            Fault(
                message=message,
                file=self.file,
                place=f"line {number}",
                expected=expected,
                found=found,
                hint=(
                    "correct this line in a copy of the file, or export it from the control again"
                ),
            )
        )

    def _place(self, number: int) -> None:
        """Check that a block is between two ``%`` lines, because the control does not read other
        blocks.

        A block before the first ``%`` is kept for the check at the end of the file: a file without
        any ``%`` is valid. Raises _Unreadable for a block after the closing ``%``.
        """
        if self.marks == 0:
            self.before.append(number)
        elif self.marks % 2 == 0:
            raise _Unreadable("no data behind the closing %, where the control does not read")

    def _other(self, line: str, raw: str, number: int) -> None:
        if _SUSPECT.search(line):
            self._wrong(
                number,
                raw,
                "the block cannot be read",
                "a block such as N03620Q1A1P40 in capital letters",
            )
        elif not _PROGRAM_WORDS.fullmatch(line):
            self.strange.append(number)

    def _block(self, number: int, rest: str, line: int) -> None:
        words = _words(rest)
        if words is None:
            if number >= POINT_BASE and not re.match(r"\s*Q\s*0", rest):
                return  # some other parameter of the control
            raise _Unreadable("words such as A1P40, without plus sign, comma or semicolon")
        known = number if number >= POINT_BASE else self.series.number_here(number)
        if self.programmed:
            self._program_block(known or number, words, line)
        elif number >= POINT_BASE:
            self._point(number, words, line)
        else:
            self._parameter(known or number, words, line)

    def _parameter(self, number: int, words: list[tuple[str, str]], line: int) -> None:
        """Read a parameter block ``[Q1] (L1 | A<axis> | S<spindle>) P<value> ...``; ignore the
        values of spindles and of all paths except the first.
        """
        if words and words[0][0] == "Q":
            if words[0][1] != "1":
                raise _Unreadable("Q1, parameter data")
            words = words[1:]
        axis: int | None = None
        owner, path = "none", "1"
        for letter, text in words:
            if letter == "A":
                axis, owner = _axis_number(text), letter
            elif letter in "LST":
                owner, path = letter, text if letter == "L" else path
            elif letter not in "PMI" or owner == "done" or len(text) > _LONGEST_VALUE:
                raise _Unreadable("groups of axis and value, such as A1P40A2P0")
            else:
                if path != "1" and axis is not None:
                    raise _Unreadable("axis parameters of the first path (L1)")
                if owner not in ("S", "T") and path == "1":
                    self.found.settings.append(
                        ParameterSetting(number, axis, None, letter, text, self.file, line)
                    )
                axis, owner, path = None, "done", "1"
        if owner != "done":
            raise _Unreadable("a value P behind every axis number")

    def _point(self, number: int, words: list[tuple[str, str]], line: int) -> None:
        """Read ``N1nnnn [Q0] P<increment>``. A block with Q1, axes, paths or spindles is a
        parameter of that number.
        """
        if words[:1] == [("Q", "1")]:
            return
        marked = bool(words) and words[0][0] == "Q"
        if marked and words[0][1] != "0":
            raise _Unreadable("Q0 (pitch data) or Q1 (parameter)")
        words = words[1:] if marked else words
        if marked and words[:1] == [("L", "1")]:
            words = words[1:]
        if len(words) == 1 and words[0][0] == "P":
            mark: Mark = "Q0" if marked else "alone"
            self.found.points.append(
                PointRecord(number - POINT_BASE, words[0][1], mark, self.file, line)
            )
        elif marked or not any(letter in "ASTL" for letter, _ in words):
            raise _Unreadable("one value, such as N10040Q0P1")

    def _program_block(self, number: int, words: list[tuple[str, str]], line: int) -> None:
        """Read ``N<number> [P<axis>] [Q<bit>] R<value>`` between G10 L50 / L52 and G11."""
        by_letter = dict(words)
        if (
            len(by_letter) != len(words)
            or set(by_letter) - {"P", "Q", "R"}
            or len(by_letter.get("R", "")) not in range(1, 25)
        ):
            raise _Unreadable("N<number>P<axis>R<value> between G10 and G11")
        axis = _axis_number(by_letter["P"]) if "P" in by_letter else None
        bit = by_letter.get("Q")
        if bit is not None and bit not in set("01234567"):
            raise _Unreadable("Q0 to Q7, the number of the bit")
        value = by_letter["R"]
        if number < POINT_BASE:
            self.found.settings.append(
                ParameterSetting(
                    number, axis, None if bit is None else int(bit), "P", value, self.file, line
                )
            )
        elif axis is None and bit is None:
            self.found.points.append(PointRecord(number - POINT_BASE, value, "Q0", self.file, line))


def _words(rest: str) -> list[tuple[str, str]] | None:
    """Return the words (letter, number) of a block after its N number; None for other text."""
    words = []
    position = 0
    rest = rest.rstrip()
    while position < len(rest):
        match = _WORD.match(rest, position)
        if match is None:
            return None
        words.append((match[1], match[2]))
        position = match.end()
    return words


def _axis_number(text: str) -> int:
    """Return the controlled axis number, from 1 to 99, that a text states."""
    if not re.fullmatch("0?[1-9]|[1-9][0-9]", text):
        raise _Unreadable("a controlled axis number from 1")
    return int(text)
