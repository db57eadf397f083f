"""Parameters of a FANUC control that are read but never written.

A backup holds thousands of parameters. Those listed here correct an axis, refer to the point
numbers that all axes share, or decide a unit, a direction or the kind of an axis. Values belong to
an axis (A), to a path (L) or to the machine. Meaning and evidence of each:
docs/controllers/fanuc.md.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property

from compwright.formats.definition.schema import ParameterRule
from compwright.formats.families.increments.points import NUMBERED, POINTS_FROM
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.notes import CORRECT_VALUE, KEEP_ONE
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile
from compwright.words.sentences import control_text

PATH_OF_AXIS = 981
INCH, SYSTEM_OF_MACHINE, KIND, SYSTEM, NAME = 1001, 1004, 1006, 1013, 1020
#: Second and third character of an axis' name, where it has them.
NAME_MORE = range(1025, 1027)
TURN, RAPID = 1260, 1420
BACKLASH_BITS, BACKLASH_RAPID = 1800, 1852
ENCODER, MULTIPLIER, REFERENCE_COUNTER = 1815, 1820, 1821
SMOOTH_BACKLASH, SMOOTH_FIRST = range(1846, 1850), 1848
TOTALS, PITCH_BITS = 3602, 3605
STRAIGHTNESS_MOVING, STRAIGHTNESS_BENT = range(5711, 5721), range(5721, 5731)
STRAIGHTNESS_POINTS, STRAIGHTNESS_AMOUNTS = range(5731, 5761), range(5761, 5800)
#: Pairs of axes of which the points are known: four numbers each from 5731, 5741 and 5751 on. A
#: real backup (D4G3) has eight numbers in each row; the meaning of the further four is unknown.
STRAIGHTNESS_PAIRS, STRAIGHTNESS_USED, STRAIGHTNESS_ROW = 3, 4, 8
INCLINATION_POINTS, INCLINATION_AMOUNTS = range(5861, 5865), range(5871, 5875)
SPATIAL = range(10800, 10803)
STRAIGHTNESS_MORE = range(13301, 13400)
#: What couples axes: numbers of axes (`coupling`).
SYNCHRONOUS, MIRRORED = 8311, 8312
SYNCHRONISED, COMPOSITE, SUPERIMPOSED = 8180, 8183, 8186
MASTERS = (SYNCHRONOUS, SYNCHRONISED, COMPOSITE, SUPERIMPOSED)
TANDEM, SERVO_NUMBER = 1817, 1023
FLEXIBLE = range(5660, 5668)
ANGULAR, ANGULAR_AXES = 8200, (8211, 8212)
CYCLIC = CYCLIC_FIRST, CYCLIC_LAST, CYCLIC_INTERVAL, CYCLIC_FACTOR = 14985, 14986, 14987, 14988

#: Everything that may be read: the name under which a definition says what it is on its series
#: (`parameters`), its numbers, and what it is in words.
_READ: tuple[tuple[str, Sequence[int], str], ...] = (
    ("path", [PATH_OF_AXIS], "path of the axis"),
    ("inch", [INCH], "unit of lengths (#0: inch)"),
    ("increment_system_of_machine", [SYSTEM_OF_MACHINE], "increment system"),
    ("kind", [KIND], "kind of the axis (#0, #1), diameter (#3), direction of the return (#5)"),
    ("increment_system", [SYSTEM], "increment system of the axis"),
    ("name", [NAME], "letters of the axis"),
    ("name_more", NAME_MORE, "letters of the axis"),
    ("turn", [TURN], "one turn of the axis"),
    ("rapid_traverse", [RAPID], "rate of rapid traverse"),
    (
        "backlash_bits",
        [BACKLASH_BITS],
        "bits of the servo (#4: backlash of its own for rapid traverse)",
    ),
    ("backlash_rapid", [BACKLASH_RAPID], "backlash at rapid traverse"),
    ("encoder", [ENCODER], "bits of the encoder"),
    ("command_multiplier", [MULTIPLIER], "command multiplier: decides the detection unit"),
    ("reference_counter", [REFERENCE_COUNTER], "reference counter"),
    ("smooth_backlash", SMOOTH_BACKLASH, "smooth backlash compensation"),
    ("totals", [TOTALS], "bits of pitch error compensation"),
    ("pitch_bits", [PITCH_BITS], "bits of pitch error compensation (#0: two sets)"),
    ("straightness", STRAIGHTNESS_MOVING, "straightness: moving axis"),
    ("straightness", STRAIGHTNESS_BENT, "straightness: compensated axis"),
    ("straightness", STRAIGHTNESS_POINTS, "straightness: point numbers"),
    ("straightness", STRAIGHTNESS_AMOUNTS, "straightness: amounts"),
    ("straightness", STRAIGHTNESS_MORE, "straightness: further pairs"),
    ("inclination", INCLINATION_POINTS, "inclination: point numbers"),
    ("inclination", INCLINATION_AMOUNTS, "inclination: amounts"),
    ("spatial", SPATIAL, "three-dimensional compensation"),
    ("cyclic", [CYCLIC_FIRST, CYCLIC_LAST], "second, cyclic table: point numbers"),
    ("cyclic", [CYCLIC_INTERVAL], "second, cyclic table: interval of the points"),
    ("cyclic", [CYCLIC_FACTOR], "second, cyclic table: magnification"),
    ("synchronous", [SYNCHRONOUS], "synchronous control: number of the master axis"),
    ("synchronous", [MIRRORED], "synchronous control: mirror image"),
    ("paths", [SYNCHRONISED], "synchronous control of paths: number of the master axis"),
    ("paths", [COMPOSITE], "composite control: number of the other axis"),
    ("paths", [SUPERIMPOSED], "superimposed control: number of the master axis"),
    ("tandem", [TANDEM], "bits of the servo (#6: tandem control)"),
    ("tandem", [SERVO_NUMBER], "number of the servo axis"),
    ("flexible", FLEXIBLE, "flexible synchronous control: numbers of master and slave axes"),
    ("angular", [ANGULAR], "bits of angular axis control (#0: in use)"),
    ("angular", ANGULAR_AXES, "angular axis control: numbers of the axes"),
)
NAMES = {number: name for name, numbers, _ in _READ for number in numbers}
MEANINGS: Mapping[int, str] = {number: words for _, numbers, words in _READ for number in numbers}
#: Read, but without effect on compensation: neither a unit nor a kind depends on them.
SILENT = frozenset({NAME, *NAME_MORE, RAPID})
_WORD = re.compile(r"[ \t]*([A-Z])[ \t]*(-?(?:[0-9]+\.?[0-9]*|\.[0-9]+))", re.IGNORECASE)
_COMMENT = re.compile(r"\([^()]*\)")
_BITS = re.compile("[01]{8}")


@dataclass(frozen=True, slots=True)
class ParameterValue:
    """One parameter value with its owner: axis (A), path (L) or machine (empty).

    ``index``: the number of the axis or path. ``key``: the letter before the value, P, M (metric)
    or I (inch). ``start``: the byte at which the value begins in the file.
    """

    number: int
    owner: str
    index: int
    key: str
    text: str
    file: str
    line: int
    start: int

    @property
    def whose(self) -> tuple[str, int]:
        """The owner of the value: its kind (axis A, path L, machine) and its number."""
        return self.owner, self.index

    @property
    def nonzero(self) -> bool:
        """Whether the parameter's value is not zero."""
        return bool(self.text.strip("-0."))

    @property
    def place(self) -> str:
        """The parameter with its value, file and line, as text."""
        return f"{self.label} ({self.file}, line {self.line})"

    @property
    def label(self) -> str:
        """The control's name of the parameter with its value, as text."""
        whose = {"A": f" of axis {self.index}", "L": f" of path {self.index}"}.get(self.owner, "")
        return f"parameter {self.number}{whose} = {self.text}"

    @property
    def whole(self) -> int:
        """The value as a whole number, without its decimals."""
        return int(Decimal(self.text))

    @property
    def is_bits(self) -> bool:
        """Whether the value is written as eight bits."""
        return _BITS.fullmatch(self.text) is not None

    def bit(self, bit: int) -> bool:
        """Return one bit of eight, 0 the rightmost; False if the value is not eight bits."""
        return self.is_bits and self.text[7 - bit] == "1"

    def fault(self, message: str, expected: str = "", hint: str = CORRECT_VALUE) -> Fault:
        """Return a fault with the file and line of this parameter. ``hint``: the next step."""
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=self.label,
            hint=hint,
        )


class Parameters:
    """The parameters in all files of a control, by the meaning that their numbers have on its
    series.

    ``rules``: the definition's rule for each group of parameters. ``another``: values that are not
    zero, of numbers that have another meaning on this series. ``unknown``: values that are not
    zero, of numbers whose meaning on this series is unknown. ``unread``: faults of lines that
    cannot be read completely.
    """

    def __init__(self, files: Sequence[ControlFile], rules: Mapping[str, ParameterRule]) -> None:
        self.values: dict[int, list[ParameterValue]] = {}
        self.another: list[ParameterValue] = []
        self.unknown: list[ParameterValue] = []
        self.unread: list[Fault] = []
        self._here = {number: rules[name].here for number, name in NAMES.items()}
        for file in files:
            if not is_entry_sheet(file):
                self._read(file)
        self._held = {
            number: {value.whose: value for value in values}
            for number, values in self.values.items()
        }

    @cached_property
    def second_tables(self) -> tuple[tuple[ParameterValue, range], ...]:
        """The point numbers of each second (cyclic) table, with the parameter that states the first
        one.
        """
        ends = [
            (first, AxisParameters(self, str(first.index)).get(CYCLIC_LAST))
            for first in self.of([CYCLIC_FIRST])
        ]
        return tuple(
            (first, range(first.whole, min(last.whole, first.whole + 10_000) + 1))
            for first, last in ends
            if last is not None and (first.nonzero or last.nonzero)
        )

    @cached_property
    def contradictions(self) -> tuple[tuple[ParameterValue, ParameterValue], ...]:
        """The pairs of different values that the files state for one parameter of one owner."""
        found = []
        for values in self.values.values():
            first: dict[tuple[str, int], ParameterValue] = {}
            for value in values:
                known = first.setdefault(value.whose, value)
                if known is not value and Decimal(value.text) != Decimal(known.text):
                    found.append((known, value))
        return tuple(found)

    def of(self, numbers: Iterable[int]) -> list[ParameterValue]:
        """Return all values of the parameters ``numbers``, for every axis, path and machine."""
        return [value for number in numbers for value in self.values.get(number, ())]

    def by_owner(self, number: int) -> Mapping[tuple[str, int], ParameterValue]:
        """Return the last value of a parameter for each owner (axis, path or machine)."""
        return self._held.get(number, {})

    def counts(self, number: int) -> bool:
        """Return whether a parameter number has its usual meaning on this series."""
        return self._here[number] == "read"

    def _read(self, file: ControlFile) -> None:
        place = 0
        for line, text in enumerate(file.content.decode("latin-1").split("\n"), start=1):
            start = place + len(text) - len(text.lstrip("\r"))
            place += len(text) + 1
            match = NUMBERED.match(text.strip("\r"))
            if match is None or int(match[1]) not in self._here:
                continue
            rest = _COMMENT.sub(lambda comment: " " * len(comment[0]), match[2])
            number, where = int(match[1]), (file.name, line, start + match.start(2))
            for value in _values(number, rest, where):
                self._keep(value)
            odd = _WORD.sub("", rest).strip("; \t\r\x1a")
            if odd and self.counts(number):
                self.unread.append(
                    Fault(
                        message=f"parameter {number} cannot be read",
                        file=file.name,
                        place=f"line {line}",
                        expected="letters with numbers, such as A1P0",
                        found=repr(odd[:40]),
                        hint="export the parameters from the control again, then give that file",
                    )
                )

    def _keep(self, value: ParameterValue) -> None:
        here = self._here[value.number]
        if here == "read":
            self.values.setdefault(value.number, []).append(value)
        elif value.nonzero:
            (self.unknown if here == "unknown" else self.another).append(value)


@dataclass(frozen=True)
class AxisParameters:
    """The parameters that apply to one axis."""

    all: Parameters
    address: str

    @property
    def label(self) -> str:
        """The name of the axis in messages."""
        return control_text("axis {address}", address=self.address)

    @property
    def index(self) -> int:
        """The number of the axis; 0 if its address is not a number."""
        return int(self.address) if self.address.isdecimal() else 0

    @property
    def path(self) -> int | None:
        """The path to which the axis belongs (parameter 981); None if the files do not state it."""
        path = self.all.by_owner(PATH_OF_AXIS).get(("A", self.index))
        return None if path is None else path.whole or None

    @property
    def system(self) -> ParameterValue | None:
        """The parameter value that states the axis' increment system: of 1013, or on older series
        of 1004, which applies to the whole machine.
        """
        return self.get(SYSTEM) or self.get(SYSTEM_OF_MACHINE)

    def get(self, number: int) -> ParameterValue | None:
        """Return a parameter's value for the axis, else for its path, else for the machine; else
        None.

        If parameter 981 is in no file, the axis is assumed to be in the first path, as on a control
        with one path. If the paths then differ in a parameter on which an axis' table depends,
        `rivals` reports it and the axis is refused.
        """
        values = self.all.by_owner(number)
        return next((values[whose] for whose in self._owners if whose in values), None)

    def another(self, number: int) -> ParameterValue | None:
        """Return the axis' value under a parameter number that does not have its usual meaning on
        this control.
        """
        values = {value.whose: value for value in self.all.another if value.number == number}
        return next((values[whose] for whose in self._owners if whose in values), None)

    def bit(self, number: int, bit: int) -> bool | None:
        """Return one bit of a parameter for the axis; None if no file states it."""
        value = self.get(number)
        return None if value is None else value.bit(bit)

    def contradictions(self) -> Iterator[Fault]:
        """Yield a fault for each parameter of the axis with different values in the files."""
        for known, value in self.all.contradictions:
            if value.whose in self._owners:
                yield value.fault(
                    f"contradicts {known.file}, line {known.line}", known.label, KEEP_ONE
                )

    def rivals(self, number: int, bits: Sequence[int]) -> list[ParameterValue]:
        """Return a parameter's values of all paths, if the axis' path is unknown and the paths
        differ in one of the ``bits``; else an empty list.
        """
        values = self.all.of([number])
        if self.path is not None or any(value.whose == ("A", self.index) for value in values):
            return []
        paths = {value.index: value for value in values if value.owner == "L"}
        differ = len({tuple(map(value.bit, bits)) for value in paths.values()}) > 1
        return [paths[index] for index in sorted(paths)] if differ else []

    def named_by(self, value: ParameterValue) -> bool:
        """Return whether the axis number that is the value of a parameter means this axis, counted
        over the machine or within a path.

        Only parameter 981 states which axes belong to a path. Without it, a number in a parameter
        of a path above 1 may mean any axis, and True is returned.
        """
        paths = self.all.of([PATH_OF_AXIS])
        further = value.owner == "L" and value.index > 1 and not paths
        if value.whole == self.index or further:
            return True
        mates = sorted(
            one.index
            for one in paths
            if one.owner == "A" and value.owner == "L" and one.whole == value.index
        )
        return value.whole > 0 and mates[value.whole - 1 : value.whole] == [self.index]

    @cached_property
    def _owners(self) -> list[tuple[str, int]]:
        return [("A", self.index), ("L", self.path or 1), ("", 0)]


def _values(number: int, rest: str, where: tuple[str, int, int]) -> list[ParameterValue]:
    """Return the values of parameter ``number`` in one line, one for each axis, path or machine.
    ``rest``: the line after the number; ``where``: file, line, and the byte at which ``rest``
    begins.

    Two kinds of values are left out: pitch data (marked Q0, or a large number with neither Q1 nor
    an owner), and values of spindles.
    """
    file, line, begin = where
    owner, index = "", 0
    plain = number >= POINTS_FROM
    values = []
    for word in _WORD.finditer(rest):
        key, text = word[1].upper(), word[2]
        if key == "Q":
            if text != "1":
                return []
            plain = False
        elif key in "ALST":
            owner, index = key, int(Decimal(text))
        elif key in "PMI":
            if owner in ("A", "L") or (owner == "" and not plain):
                start = begin + word.start(2)
                values.append(ParameterValue(number, owner, index, key, text, file, line, start))
            owner, index = "", 0
    return values
