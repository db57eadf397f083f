"""Elements of HEIDENHAIN files: numbers, lines, parameters, differences between generations.

Lines of machine parameters of an iTNC 530 look like ``MP710.0 : 0.0040`` (index = axis number from
0) or ``MP730 : %00011`` (one bit per axis).
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum

from compwright.controllers.places import OfLine
from compwright.foundations.errors import Fault

# Bounded on purpose: a length beyond 1e9 mm is no length, and nothing overflows later.
_NUMBER = re.compile(r"[+-]?(?:[0-9]{1,9}(?:\.[0-9]{0,12})?|\.[0-9]{1,12})")
_LINE_END = re.compile(r"\r\n|\n|\r")

#: Axis numbers in .COM column headers, from 1, as letters. The order is the usual one; higher
#: numbers have no fixed letter.
LETTERS = ("X", "Y", "Z", "A", "B", "C")

#: Columns of a .COM that belong to axes are numbered 1 to 18 (iTNC 530 HSCI technical manual p.
#: 680).
MOST_AXES = 18


class Quantity(Enum):
    """What a machine parameter of an axis means: backlash, linear error or table selection."""

    BACKLASH = "backlash"
    LINEAR = "linear error"
    NONLINEAR = "nonlinear compensation selected"


@dataclass(frozen=True, slots=True)
class Generation:
    """The rules of one generation of HEIDENHAIN controls, iTNC 530 or NCK.

    - ``parameters``: meaning of each machine parameter, by its name.
    - ``ignores_case``: axis names are the same in upper and lower case.
    - ``most_points``: greatest number of points in a table; None if unknown.
    - ``largest``: greatest amount of backlash (mm or deg) and linear error (mm/m); None if unknown.
    - ``numbers``: name of each axis whose number (from 1) the job states.
    """

    name: str
    parameters: dict[str, Quantity]
    ignores_case: bool
    most_points: int | None
    largest: float | None
    numbers: Mapping[int, str] = field(default_factory=dict)

    def axis(self, number: int) -> str:
        """Return the name of the axis with a number (from 1): by the job, else by the letter usual
        for that number.

        Returns the number as text if no letter is usual for it, or if the job gives this letter
        another number.
        """
        letter = LETTERS[number - 1] if number <= len(LETTERS) else str(number)
        free = str(number) if letter in self.numbers.values() else letter
        return self.numbers.get(number, free)

    def address(self, text: str) -> str:
        """Return an axis name in the spelling that is used for comparison."""
        return text.upper() if self.ignores_case else text

    def parameter(self, quantity: Quantity) -> str:
        """Return the control's name of a quantity; if the control has no such name, the general
        name of the quantity.
        """
        return next(
            (name for name, held in self.parameters.items() if held is quantity), quantity.value
        )


#: 256 points: TNC 407 technical manual p. 622; ranges: TNC 426/430 p. 366 (MP710), TNC 407 p. 151
#: (MP720).
ITNC530 = Generation(
    name="iTNC 530",
    parameters={"MP710": Quantity.BACKLASH, "MP720": Quantity.LINEAR, "MP730": Quantity.NONLINEAR},
    ignores_case=True,
    most_points=256,
    largest=1.0,
)
#: MANUALplus 620 technical manual p. 707; 256 points: p. 715; no range is known.
NCK = Generation(
    name="NCK control",
    parameters={"backLash": Quantity.BACKLASH, "linearCompValue": Quantity.LINEAR},
    ignores_case=False,
    most_points=256,
    largest=None,
)


@dataclass(frozen=True, slots=True)
class LinePlace(OfLine):
    """The file and line number of a line."""

    file: str
    line: int

    def __str__(self) -> str:
        """Return the file and line number as text."""
        return f"{self.file}, line {self.line}"


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of an axis: backlash (mm or deg), linear error (mm/m), or on/off (1 or 0).

    ``unit``: as stated in the file; empty if the file states none.
    """

    quantity: Quantity
    address: str
    value: float
    unit: str
    place: LinePlace


def number(text: str) -> float | None:
    """Return the decimal number in a text without exponent; None for anything else."""
    return float(text) if _NUMBER.fullmatch(text) else None


def lines_of(text: str) -> list[str]:
    """Return the lines of a text with any kind of line end, without a byte order mark."""
    return _LINE_END.split(text.removeprefix("\ufeff"))


def binary_fault(file: str, content: bytes) -> Fault | None:
    """Return a fault if the file is binary, which a NUL byte shows; None if it is text."""
    if b"\x00" not in content:
        return None
    return Fault(
        message="the file is a binary file",
        file=file,
        expected="the text form (ASCII) of the table",
        hint="export the table from the control as text",
    )


_PARAMETER = re.compile(
    r"MP(710|720|730)(?:\.([0-9]{1,2}))?\s{0,80}:\s{0,80}(\S{1,40})", re.IGNORECASE
)
_MINE = re.compile(r"MP\s{0,80}(?:710|720|730)(?![0-9])", re.IGNORECASE)
_OTHER = re.compile(r"MP[0-9]", re.IGNORECASE)
_BITS = re.compile(f"%[01]{{1,{MOST_AXES}}}")
_DECIMAL = re.compile("[0-9]{1,6}")


@dataclass(slots=True)
class ParameterLines:
    """The parameters read from lines in order, other lines (``stray``), and faults."""

    parameters: list[Parameter] = field(default_factory=list)
    stray: list[tuple[LinePlace, str]] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def read_parameters(
    lines: Sequence[tuple[LinePlace, str]], generation: Generation
) -> ParameterLines:
    """Read the lines with MP710, MP720 and MP730; other parameters and comments are skipped."""
    found = ParameterLines()
    for place, line in lines:
        code = line.split(";", 1)[0].strip()
        if _MINE.match(code):
            _read(code, place, found, generation)
        elif code and not code.startswith(("#", "*")) and not _OTHER.match(code):
            found.stray.append((place, code))
    return found


def _read(code: str, place: LinePlace, found: ParameterLines, generation: Generation) -> None:
    match = _PARAMETER.fullmatch(code)
    index = None if match is None or match.group(2) is None else int(match.group(2))
    if match is None or (index is None) != (match.group(1) == "730") or (index or 0) >= MOST_AXES:
        found.faults.append(
            place.fault(
                "the parameter cannot be read",
                expected="MP710.0 : 0.0040 or MP730 : %00000",
                found=repr(code[:80]),
            )
        )
        return
    text = match.group(3)
    if index is None:
        found.parameters += _mask(text, place, found, generation)
        return
    value = number(text)
    if value is None:
        found.faults.append(
            place.fault("value", expected="a number with a decimal point", found=repr(text))
        )
        return
    quantity, unit = (
        (Quantity.BACKLASH, "") if match.group(1) == "710" else (Quantity.LINEAR, "mm/m")
    )
    found.parameters.append(Parameter(quantity, generation.axis(index + 1), value, unit, place))


def _mask(
    text: str, place: LinePlace, found: ParameterLines, generation: Generation
) -> list[Parameter]:
    """Return the bit mask MP730 as one on/off parameter per axis, bit 0 for the first axis. An
    invalid mask is a fault in ``found`` and gives no parameters.

    A mask such as ``%00011`` gives one parameter per digit. A decimal number gives a parameter for
    every possible axis.
    """
    bits = text[1:][::-1] if _BITS.fullmatch(text) else ""
    if len(text.lstrip("0")) > 1 and not set(text) - {"0", "1"}:
        found.faults.append(
            place.fault(
                "MP730: bits or a decimal number",
                expected=f"%{text} or %{int(text):b}",
                found=repr(text),
            )
        )
        return []
    if _DECIMAL.fullmatch(text) and int(text) < 1 << MOST_AXES:
        bits = f"{int(text):0{MOST_AXES}b}"[::-1]
    if not bits:
        found.faults.append(
            place.fault(
                "MP730",
                expected=f"%00000 (up to {MOST_AXES} bits) or a whole number",
                found=repr(text),
            )
        )
    return [
        Parameter(Quantity.NONLINEAR, generation.axis(index + 1), float(bit), "", place)
        for index, bit in enumerate(bits)
    ]
