"""Parameters of a FANUC, stored by axis, path or machine, and what they mean: paths, units, turns.

The rules are taken from the manuals and a real backup, independently of the package that writes the
files. The word practice marks a rule that no manual page confirms.

- Detection unit = least command increment / CMR. 1820 is 2 x CMR (1 to 96) or 100 + 1 / CMR (101 to
  127) (B-63943EN-1/02 p. 109, B-63950EN/02 p. 106).
- Least command increment: IS-A 0.01, IS-B 0.001, IS-C 0.0001, IS-D 0.00001, IS-E 0.000001 mm or deg
  (p. 109). If 1001#0 = 1, it is a tenth of this number in inches. Bits 0 to 3 of 1013 select IS-A,
  C, D, E; bits 0 and 1 of 1004 select IS-A and C (practice).
- 1006#0 = 1 with 1006#1 = 0: an endless rotary axis. Both bits 1: a rotary axis with ends
  (practice; a real backup agrees).
- A value belongs to an axis (A), to a path (L) or to the whole machine. 981 states the path of an
  axis (a real backup). Without 981 an axis may belong to any path.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache

from compwright.controllers.fanuc.series import ControlSeries
from compwright.controllers.fanuc.text import KEPT_FILES, ParameterSetting
from compwright.foundations.errors import Fault
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.correction import ControlFile

PATH_OF = 981
#: Parameters that are kept in addition to the pitch parameters.
_KEPT = frozenset(
    {PATH_OF, 1001, 1004, 1006, 1013, 1260, 1800, 1820, 3602, 8135, 10800, 10801, 10802}
    | {*range(1846, 1850), *range(5711, 5800), *range(5861, 5875)}
    | {*range(13301, 13400), *range(14985, 14989)}
)
#: Systems finer than this are known from practice only.
FINEST_CONFIRMED = 1e-4
#: Increment system -> decimals of the least command increment, by the lower bits of 1013 and 1004.
_DECIMALS = {0b0000: 3, 0b0001: 2, 0b0010: 4, 0b0100: 5, 0b1000: 6}
_SYSTEM_BITS = {1013: 0b1111, 1004: 0b0011}
_COARSEST_CODE = 100  # 1820 from here on: 100 + 1 / CMR
_CODES = (range(1, 97), range(101, 128))

#: From here on a number may be that of a point.
_POINTS_FROM = 10000

_ROW = re.compile(
    rb"(?<![^\r\n])[ \t]*N[ \t]*([0-9]{3,6})(?![0-9])[ \t]*(?:Q[ \t]*([0-9]+))?([^\r\n]*)"
)
_GROUP = re.compile(r"(?:([AL])\s*([0-9]+)\s*)?([PMI])\s*(-?[0-9.]+)")
#: A row between G10 and G11: the axis, if any, and the value.
_PROGRAM_ROW = re.compile(r"\s*(?:P\s*([0-9]+)\s*)?R\s*(-?[0-9.]+)\s*")
_WHOLE = re.compile(r"-?[0-9]{1,9}")
_EIGHT_BITS = re.compile("[01]{8}")


@dataclass(frozen=True, slots=True)
class MachineEntry:
    """One parameter value and its place in a file. ``letter``: P, M or I, as in the file."""

    number: int
    letter: str
    text: str
    file: str
    line: int

    @property
    def zero(self) -> bool:
        """Return whether the value is 0 or empty."""
        return not self.text.strip("0.-")

    @property
    def is_bits(self) -> bool:
        """Return whether the value is written as eight bits."""
        return _EIGHT_BITS.fullmatch(self.text) is not None

    @property
    def whole(self) -> int | None:
        """Return the value as a whole number; None if the value is not a whole number."""
        return int(self.text) if _WHOLE.fullmatch(self.text) else None

    def bit(self, bit: int) -> bool:
        """Return one of the eight bits of the value; bit 0 is the rightmost."""
        return self.is_bits and self.text[-1 - bit] == "1"

    def fault(self, message: str, expected: str) -> Fault:
        """Return a fault with the file and line of this parameter value."""
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=f"{self.number}: {self.text}",
            hint=(
                "correct it in the control and export its parameters again, or "
                "leave this axis out of the job"
            ),
        )


#: Whose a value is: ``("A", 1)`` an axis', ``("L", 1)`` a path's, ``("", 0)`` the machine's.
Owner = tuple[str, int]
MACHINE: Owner = ("", 0)


@dataclass(slots=True)
class Machine:
    """The parameter values of a FANUC by number and owner (axis, path or machine)."""

    series: ControlSeries
    entries: dict[int, dict[Owner, MachineEntry]] = field(default_factory=lambda: defaultdict(dict))
    #: What contradicts an entry: whose value it is, and the fault.
    contradictions: list[tuple[Owner, Fault]] = field(default_factory=list)

    def take(self, owner: Owner, entry: MachineEntry) -> None:
        """Store a value; a different value for the same parameter and owner is a fault."""
        kept = self.entries[entry.number].setdefault(owner, entry)
        if _numeral(kept.text) != _numeral(entry.text) or {kept.letter, entry.letter} == {"M", "I"}:
            whose = " of {}{}".format(*owner) if owner[0] else ""
            fault = entry.fault(
                f"{entry.number}{whose} contradicts {kept.file}, line {kept.line}", kept.text
            )
            self.contradictions.append((owner, fault))

    def typed(self, settings: Iterable[ParameterSetting]) -> None:
        """Store the parameters of an entry sheet that do not belong to the pitch error table."""
        for each in settings:
            if each.number in _KEPT and each.axis is not None:
                entry = MachineEntry(each.number, each.keyword, each.text, each.file, each.line)
                self.take(("A", each.axis), entry)

    def contradicting(self, axis: int) -> Iterator[Fault]:
        """Return the fault of each parameter to which the files give different values, if it
        belongs to the axis, to a path or to the machine.
        """
        return (
            fault
            for (letter, number), fault in self.contradictions
            if letter != "A" or number == axis
        )

    def path(self, axis: int) -> int | None:
        """Return the number of an axis' path, from 1; None if parameter 981 does not state the
        path.
        """
        home = self.entries.get(PATH_OF, {}).get(("A", axis))
        return None if home is None or home.whole is None else max(home.whole, 1)

    def entry(self, number: int, axis: int) -> MachineEntry | None:
        """Return a parameter's value for the axis, else for its path, else for the machine; else
        None.

        An axis whose path is unknown is assumed to be in path 1. `either` returns a fault if
        another path would give a different value.
        """
        found = self.entries.get(number, {})
        owners: tuple[Owner, ...] = (("A", axis), ("L", self.path(axis) or 1), MACHINE)
        return next((found[owner] for owner in owners if owner in found), None)

    def either(self, number: int, axis: int, bit: int | None = None) -> Fault | None:
        """Return a fault if an axis' path is unknown and a parameter (or its ``bit``) differs
        between the paths; else None.
        """
        found = self.entries.get(number, {})
        if self.path(axis) is not None or ("A", axis) in found:
            return None
        paths = sorted((owner[1], entry) for owner, entry in found.items() if owner[0] == "L")
        if len({entry.text if bit is None else entry.bit(bit) for _, entry in paths}) < 2:
            return None
        what = f"{number}" if bit is None else f"{number}#{bit}"
        return paths[0][1].fault(
            f"the paths differ in {what}, and no file says to which axis {axis} belongs",
            f"981 of axis {axis} in the files: " + ", ".join(f"L{i} {e.text}" for i, e in paths),
        )

    def bit(self, number: int, bit: int, axis: int) -> bool | None:
        """Return a bit of a parameter for an axis; None if no file states the parameter."""
        entry = self.entry(number, axis)
        return None if entry is None else entry.bit(bit)

    def is_endless(self, axis: int) -> bool | None:
        """Return whether a rotary axis is endless; None if 1006 does not make the axis rotary."""
        kind = self.entry(1006, axis)
        if kind is None or not kind.bit(0):
            return None
        return not kind.bit(1)

    def turn(self, axis: int) -> float:
        """Return the travel per turn in parameter 1260, deg; 0 if it is missing or not a real
        number.
        """
        entry = self.entry(1260, axis)
        return float(entry.text) if entry is not None and "." in entry.text.rstrip(".") else 0.0

    def system(self, axis: int) -> MachineEntry | None:
        """Return the parameter that states the increment system of an axis."""
        found = (self.entry(number, axis) for number in self.series.systems)
        return next((entry for entry in found if entry is not None), None)

    def least_increment(self, axis: int) -> float | None:
        """Return the least increment (0.001 for IS-B); None if not stated in a known form."""
        system = self.system(axis)
        if system is None or not system.is_bits:
            return None
        place = _DECIMALS.get(int(system.text, 2) & _SYSTEM_BITS[system.number])
        return None if place is None else 10.0**-place

    def detection_unit(self, axis: int, *, rotary: bool) -> float | None:
        """Return the detection unit of an axis, mm or deg; None if the files do not state it
        clearly.
        """
        coded, kind = self.entry(1820, axis), self.entry(1006, axis)
        least = self.least_increment(axis)
        code = None if coded is None else coded.whole
        if code is None or least is None or not any(code in codes for codes in _CODES):
            return None
        if kind is not None and kind.bit(3) and not rotary:
            return None
        multiplier = code / 2.0 if code < _COARSEST_CODE else 1.0 / (code - _COARSEST_CODE)
        inch = not rotary and bool(self.bit(1001, 0, axis))
        return least * (0.1 * MILLIMETRES_PER_INCH if inch else 1.0) / multiplier

    def named(self, owner: Owner, number: int) -> tuple[int, ...]:
        """Return the axes that an axis ``number`` in a parameter of ``owner`` may mean: it counts
        either all axes of the machine, or the axes of the owner's path.

        The result is empty if ``owner`` is a path from 2 on whose axes are unknown. The number may
        then mean any axis.
        """
        homes = self.entries.get(PATH_OF, {})
        mates = sorted(
            axis for letter, axis in homes if letter == "A" and self.path(axis) == owner[1]
        )
        if owner[0] == "L" and owner[1] > 1 and not mates:
            return ()
        own = mates[number - 1 : number] if owner[0] == "L" else []
        return tuple(dict.fromkeys([number, *own]))


def read_machine(files: Iterable[ControlFile], series: ControlSeries) -> Machine:
    """Return the parameters in all files, except those in entry sheets and pitch error data."""
    machine = Machine(series)
    for file in files:
        for owner, entry in _values(file, series):
            machine.take(owner, entry)
    return machine


@lru_cache(maxsize=KEPT_FILES)
def _values(file: ControlFile, series: ControlSeries) -> tuple[tuple[Owner, MachineEntry], ...]:
    """Return the parameters in one file, in the order of the file."""
    kept = _KEPT if not series.own else {1001, *series.unknown}
    found: list[tuple[Owner, MachineEntry]] = []
    for match in _ROW.finditer(file.content):
        number = int(match[1])
        if number not in kept or match[2] not in (None, b"1"):
            continue
        line = file.content.count(b"\n", 0, match.start()) + 1
        rest = re.sub(r"\([^()]*\)", " ", match[3].decode("latin-1"))
        program = _PROGRAM_ROW.fullmatch(rest)
        groups = (
            _GROUP.findall(rest)
            if program is None
            else [("A" if program[1] else "", program[1], "P", program[2])]
        )
        for letter, index, keyword, text in groups:
            if number >= _POINTS_FROM and match[2] is None and not letter:
                continue  # without Q1 and without an owner this is a point
            entry = MachineEntry(number, keyword, text, file.name, line)
            found.append(((letter, int(index or 0)), entry))
    return tuple(found)


def _numeral(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text
