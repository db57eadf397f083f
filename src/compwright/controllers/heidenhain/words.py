"""Elements of HEIDENHAIN files for the virtual control: numbers, places, parameters, and the
differences between the two generations.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
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
    """Meaning of a machine parameter of an axis."""

    BACKLASH = "backlash"
    LINEAR = "linear error"
    NONLINEAR = "nonlinear compensation selected"


@dataclass(frozen=True, slots=True)
class Generation:
    """One of the two generations of controls. ``parameters``: name -> quantity; ``largest``: limit
    of backlash and linear error, both signs; ``numbers``: axes by the given axis number, from 1.
    """

    name: str
    parameters: dict[str, Quantity]
    ignores_case: bool
    most_points: int | None
    largest: float | None
    numbers: Mapping[int, str] = field(default_factory=dict)

    def axis(self, number: int) -> str:
        """Return the axis of a column number, from 1: as given, else by the fixed letter order.

        The number itself where no letter is fixed, or the letter was given another number.
        """
        letter = LETTERS[number - 1] if number <= len(LETTERS) else str(number)
        free = str(number) if letter in self.numbers.values() else letter
        return self.numbers.get(number, free)

    def address(self, text: str) -> str:
        """Return an axis name in the form used for comparison."""
        return text.upper() if self.ignores_case else text

    def parameter(self, quantity: Quantity) -> str:
        """Return the control's name of a quantity; the neutral name where the control has none."""
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
    """A line of a file."""

    file: str
    line: int

    def __str__(self) -> str:
        """Return file and line in words."""
        return f"{self.file}, line {self.line}"


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter of one axis: mm or deg (backlash; ``unit`` is empty where the file names none),
    mm/m (linear error), 0 or 1.
    """

    quantity: Quantity
    address: str
    value: float
    unit: str
    place: LinePlace


def number(text: str) -> float | None:
    """Return a decimal number with a point and without exponent, None for anything else."""
    return float(text) if _NUMBER.fullmatch(text) else None


def lines_of(text: str) -> list[str]:
    """Return the lines of a text, whatever ends them, without a byte order mark."""
    return _LINE_END.split(text.removeprefix("\ufeff"))


def binary_fault(file: str, content: bytes) -> Fault | None:
    """Return the fault of a file that is no text."""
    if b"\x00" not in content:
        return None
    return Fault(
        message="is a binary file",
        file=file,
        expected="the text form (ASCII) of the table",
        hint="export the table from the control as text",
    )
