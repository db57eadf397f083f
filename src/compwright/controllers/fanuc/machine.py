"""What a FANUC's files say of the machine around the pitch data: other functions that act, paths,
unit systems, turns.

Stated from the manuals and from a real backup, apart from the room that writes the files:

- Detection unit = least command increment / CMR, 1820 = 2 x CMR for CMR >= 1 (B-63943EN-1/02 p.
  109). Least command increment by 1013 (1004 on older series): IS-B 0.001, IS-A 0.01, IS-C 0.0001
  mm or deg; a tenth of that in inches where 1001#0 = 1.
- 1006#0 = 1, 1006#1 = 0: a rotary axis that goes round; both 1: a rotary axis of the linear type
  (practice; a real backup agrees).
- Beside the pitch data act: inclination 5861 to 5874 and the second cyclic table 14985 to 14987
  (A-78868E), straightness 5711 and so on, three-dimensional compensation 10800 to 10802, smooth
  backlash 1846 to 1849 (practice). None of them is judged: an axis on which one acts is refused.
  3602 may say that the data are totals (practice).
- Values stand by axis (A), by path (L) or once for the machine; 981 says which path an axis belongs
  to (a real backup).
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field

from compwright.foundations.errors import Fault
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.correction import ControlFile

#: Functions that would add to the correction -> their parameters by axis; none of them is zero by
#: chance while it acts.
_BY_AXIS = {
    "inclination compensation": (5871, 5872, 5873, 5874),
    "the second (cyclic) pitch error table": (14985, 14986, 14987),
    "smooth backlash": (1846, 1847, 1848, 1849),
}
#: Functions that name the axes they act on -> the parameters that hold axis numbers.
_BY_NAME = {
    "straightness compensation": tuple(range(5711, 5731)),
    "three-dimensional error compensation": (10800, 10801, 10802),
}
_TOTALS = 3602
_FURTHER = tuple(range(13381, 13400))
_MACHINE = (981, 1001, 1004, 1006, 1013, 1260, 1800, 1820, _TOTALS, *_FURTHER)
_KEPT = {
    *_MACHINE,
    *(number for numbers in (*_BY_AXIS.values(), *_BY_NAME.values()) for number in numbers),
}

#: From here on a number may be that of a point.
_POINTS_FROM = 10000

_ROW = re.compile(
    rb"(?<![^\r\n])[ \t]*N[ \t]*([0-9]{3,6})(?![0-9])[ \t]*(?:Q[ \t]*([0-9]+))?([^\r\n]*)"
)
_GROUP = re.compile(r"(?:([AL])\s*([0-9]+)\s*)?([PMI])\s*(-?[0-9.]+)")


@dataclass(frozen=True, slots=True)
class Entry:
    """One value and where it stands."""

    number: int
    text: str
    file: str
    line: int

    @property
    def zero(self) -> bool:
        """Whether it says nothing."""
        return not self.text.strip("0.-")

    def bit(self, bit: int) -> bool:
        """Return one of eight bits, 0 the rightmost."""
        return len(self.text) == 8 and self.text[-1 - bit] == "1"

    def fault(self, message: str, expected: str) -> Fault:
        """Return a fault at this value."""
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=f"{self.number}: {self.text}",
        )


@dataclass(slots=True)
class Machine:
    """Values by parameter and owner: ``("A", 1)`` an axis, ``("L", 1)`` a path, ``("", 0)`` the
    machine.
    """

    entries: dict[int, dict[tuple[str, int], Entry]] = field(
        default_factory=lambda: defaultdict(dict)
    )

    def said(self, number: int, axis: int) -> Entry | None:
        """Return what holds for an axis: its own value, its path's, the machine's."""
        found = self.entries.get(number, {})
        home = self.entries.get(981, {}).get(("A", axis))
        path = 1 if home is None or home.zero else int(float(home.text))
        return next(
            (found[owner] for owner in (("A", axis), ("L", path), ("", 0)) if owner in found), None
        )

    def bit(self, number: int, bit: int, axis: int) -> bool | None:
        """Return a bit that holds for an axis, None where no file says it."""
        entry = self.said(number, axis)
        return None if entry is None else entry.bit(bit)

    def goes_round(self, axis: int) -> bool | None:
        """Whether a rotary axis has no ends; None where 1006 does not say that it is one."""
        kind = self.said(1006, axis)
        if kind is None or not kind.bit(0):
            return None
        return not kind.bit(1)

    def turn(self, axis: int) -> float:
        """Return 1260, deg per turn, 0 where it is not there or not a real number."""
        entry = self.said(1260, axis)
        return float(entry.text) if entry is not None and "." in entry.text.rstrip(".") else 0.0

    def detection_unit(self, axis: int, *, rotary: bool) -> float | None:
        """Return mm or deg per pulse, None where the files do not say it in a coding that is
        known.
        """
        coded = self.said(1820, axis)
        system = self.said(1013, axis) or self.said(1004, axis)
        kind = self.said(1006, axis)
        if coded is None or system is None or not re.fullmatch("[0-9]{1,3}", coded.text):
            return None
        if not 2 <= int(coded.text) <= 96 or (kind is not None and kind.bit(3) and not rotary):
            return None
        decimals = {0b0000: 3, 0b0001: 2, 0b0010: 4}
        mask = 0b1111 if system.number == 1013 else 0b0011
        place = (
            decimals.get(int(system.text, 2) & mask)
            if re.fullmatch("[01]{8}", system.text)
            else None
        )
        if place is None:
            return None
        inch = not rotary and bool(self.bit(1001, 0, axis))
        return 10.0**-place * (0.1 * MILLIMETRES_PER_INCH if inch else 1.0) * 2.0 / int(coded.text)

    def also_acts(self, axis: int) -> Iterable[Fault]:
        """Yield a fault for each function that acts on an axis beside its table and 1851."""
        totals = self.said(_TOTALS, axis)
        if totals is not None and not totals.zero:
            yield totals.fault(
                f"the pitch data of axis {axis} may be totals", "3602 = 0: increments"
            )
        for name, numbers in _BY_AXIS.items():
            values = [
                entry
                for number in numbers
                if (entry := self.said(number, axis)) is not None and not entry.zero
            ]
            if values:
                yield values[0].fault(f"{name} acts on axis {axis} and is not judged", "0")
        for name, numbers in _BY_NAME.items():
            named = [
                entry
                for number in numbers
                for owner, entry in self.entries.get(number, {}).items()
                if self._is(axis, owner, entry)
            ]
            if named:
                yield named[0].fault(f"{name} names axis {axis} and is not judged", "0")
        further = [
            entry
            for number in _FURTHER
            for entry in self.entries.get(number, {}).values()
            if not entry.zero
        ]
        if further:
            yield further[0].fault(
                f"further straightness pairs may act on axis {axis} and are not judged", "0"
            )

    def _is(self, axis: int, owner: tuple[str, int], entry: Entry) -> bool:
        """Whether an axis number means this axis: as counted over the machine, or as the n-th of
        the path it stands for.
        """
        if entry.zero:
            return False
        number = int(float(entry.text))
        homes = self.entries.get(981, {})
        mates = sorted(
            one
            for (letter, one), home in homes.items()
            if letter == "A" and home.text.strip() == str(owner[1])
        )
        return number == axis or (owner[0] == "L" and mates[number - 1 : number] == [axis])


def read_machine(files: Iterable[ControlFile]) -> Machine:
    """Return what all files say; sheets and pitch data say nothing here."""
    machine = Machine()
    for file in files:
        for match in _ROW.finditer(file.content):
            number = int(match[1])
            if number not in _KEPT or match[2] not in (None, b"1"):
                continue
            line = file.content.count(b"\n", 0, match.start()) + 1
            rest = re.sub(r"\([^()]*\)", " ", match[3].decode("latin-1"))
            for letter, index, _, text in _GROUP.findall(rest):
                if number >= _POINTS_FROM and match[2] is None and not letter:
                    continue  # without Q1 and without an owner this is a point
                machine.entries[number][(letter, int(index or 0))] = Entry(
                    number, text, file.name, line
                )
    return machine
