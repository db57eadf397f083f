"""Inclination, cyclic and straightness compensation of a FANUC axis, in addition to its table.

The rules are taken from the manuals, independently of the package that writes the files. The word
practice marks a rule that no manual page confirms.

- Inclination: four point numbers (5861 to 5864) and four amounts (5871 to 5874, detection units)
  define three straight lines. The control outputs them at the pitch intervals and adds them to the
  pitch amount (35i-B, B-64523EN-1/02, 1.3.8; B-63522EN/02 p. 222). Practice: the parameter numbers.
  Practice: outside the four points the end amounts apply, and the value at the reference is 0.
  Practice: 3623 does not multiply the amounts.
- Second (cyclic) table: 14985 and 14986 are its first and last number in the common pitch data,
  14987 is its interval. The increments of a period add up to 0. The period repeats and is added to
  the main table (A-78868E p. 3, 6). Practice: the period begins at the reference. Practice: 3623
  does not multiply it; 14988 is its magnification.
- Straightness: 5711 to 5713 name the moving axis, 5721 to 5723 the axis that is corrected. Each
  pair has four point numbers of the moving axis (from 5731) and four amounts (from 5761). The
  difference of two amounts is distributed evenly over the intervals between their points
  (B-63522EN/02 p. 222). Practice: the parameter numbers. Practice: the amounts are in detection
  units of the corrected axis. A real backup has further such parameters whose meaning is unknown.
- 10800 to 10802 name the axes of three-dimensional error compensation, a field over three positions
  (A-79351E p. 3; the numbers: practice). It is never included in the correction.
- 13301 to 13399 belong to further straightness pairs (practice). They are never included.
- 1846 to 1849: smooth backlash (practice). It is never included: the correction uses the whole
  value 1851.

A function that is not included is reported. Its effect stays the same after a change of the table,
because compwright does not change it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from compwright.controllers.fanuc.machine import MACHINE, Machine, MachineEntry, Owner
from compwright.foundations.errors import Fault
from compwright.records.axis import FloatArray

_INCLINED = (5871, 5872, 5873, 5874)
_INCLINED_AT = (5861, 5862, 5863, 5864)
CYCLIC = (14985, 14986, 14987)
CYCLIC_FACTOR = 14988
_SMOOTH = (1846, 1847, 1848, 1849)
_MOVING, _BENT = 5711, 5721
_MOVED, _BENDING = range(5711, 5721), range(5721, 5731)
_PAIRS = range(3)
_STRAIGHT_AT, _STRAIGHT = 5731, 5761
#: Further pairs and further points: a real backup has them, what they mean is not known.
_MORE_STRAIGHT = (
    *_MOVED[3:],
    *_BENDING[3:],
    *(row + i for row in range(5731, 5791, 10) for i in range(4, 8)),
    *range(5791, 5800),
    *range(13301, 13400),
)
_FIELD = (10800, 10801, 10802)
_FURTHER = range(13381, 13400)
#: Amounts of inclination and straightness are words (practice).
_LARGEST = 32767


@dataclass(frozen=True, slots=True)
class InclinedLines:
    """Straight lines through compensation amounts (detection units) at ascending point numbers.

    Outside the first and the last point the end amounts apply.
    """

    points: tuple[int, ...]
    amounts: tuple[int, ...]

    def at(self, numbers: FloatArray, reference: int) -> FloatArray:
        """Return the compensation amount on the lines at the point ``numbers`` (any shape), minus
        that at the point number ``reference``; in detection units.
        """
        corners = dict(zip(self.points, self.amounts, strict=True))
        here, there = (
            np.interp(where, list(corners), list(corners.values()))
            for where in (numbers, np.asarray(float(reference)))
        )
        return np.asarray(here - there, dtype=np.float64)


@dataclass(frozen=True, slots=True)
class Cycle:
    """The second (cyclic) pitch error table, which repeats along the whole axis, towards + and
    towards −.

    ``totals`` (n + 1,): sums of the increments at the section ends, detection units; the first and
    the last are 0. ``interval``: length of a section, mm or deg.
    """

    interval: float
    totals: FloatArray

    def pulses(self, positions: FloatArray, *, ramp: bool) -> FloatArray:
        """Return the correction, detection units, at ``positions`` (mm or deg from reference):
        linear within a section with ``ramp``, else in one step at the middle of each section.
        """
        sections = np.mod(positions / self.interval, self.totals.size - 1)
        if ramp:
            return np.asarray(
                np.interp(sections, np.arange(self.totals.size), self.totals), dtype=np.float64
            )
        # A position in the very middle of a section may lie on either side of it by its last bits.
        steps = np.floor(np.round(sections, 9) + 0.5).astype(np.intp)
        return np.asarray(self.totals[steps], dtype=np.float64)


@dataclass(frozen=True, slots=True)
class Bend:
    """Straightness compensation of one pair of axes: at each position of the axis ``moving``, the
    axis ``bent`` is corrected by the amount that ``lines`` give.

    ``entry``: the parameter that names the moving axis, with its place in the file.
    """

    moving: int
    bent: int
    lines: InclinedLines
    entry: MachineEntry


def inclination(machine: Machine, axis: int, faults: list[Fault]) -> InclinedLines | None:
    """Return the lines of an axis' inclination compensation; None if all amounts are 0 or, with a
    fault, if the parameters are invalid.
    """
    at = [machine.entry(number, axis) for number in _INCLINED_AT]
    amounts = [machine.entry(number, axis) for number in _INCLINED]
    return _lines(at, amounts, f"inclination of axis {axis}", faults)


def cyclic_numbers(machine: Machine, axis: int) -> range:
    """Return the point numbers of an axis' second (cyclic) pitch error table; empty without one."""
    first, last = (machine.entry(number, axis) for number in CYCLIC[:2])
    low, high = (0 if entry is None else entry.whole or 0 for entry in (first, last))
    return range(low, high + 1) if 0 <= low < high else range(0)


def inclined(machine: Machine, axis: int) -> MachineEntry | None:
    """Return the first inclination amount of an axis that is not 0; None if all amounts are 0."""
    found = (machine.entry(number, axis) for number in _INCLINED)
    return next((entry for entry in found if entry is not None and not entry.zero), None)


def bends(machine: Machine, faults: list[Fault]) -> Iterator[Bend]:
    """Yield the straightness compensation of each axis pair that has one; a pair with invalid
    parameters is left out, with a fault.
    """
    more = _any(machine, _MORE_STRAIGHT)
    if more is not None:
        faults.append(
            more.fault(f"what {more.number} does in straightness compensation is not known", "0")
        )
    for pair in _PAIRS:
        for owner, moving in machine.entries.get(_MOVING + pair, {}).items():
            bent = machine.entries.get(_BENT + pair, {}).get(owner)
            if moving.zero or bent is None or bent.zero:
                continue
            at, amounts = (
                [_of(machine, first + 10 * pair + i, owner) for i in range(4)]
                for first in (_STRAIGHT_AT, _STRAIGHT)
            )
            lines = _lines(at, amounts, f"straightness compensation, pair {pair + 1}", faults)
            if lines is None:
                continue
            axes = [_one_axis(machine, owner, entry, faults) for entry in (moving, bent)]
            if axes[0] is None or axes[1] is None:
                continue
            if axes[0] == axes[1]:
                faults.append(bent.fault("an axis cannot bend itself", f"not {bent.text}"))
                continue
            yield Bend(axes[0], axes[1], lines, moving)


def refusing(machine: Machine, axis: int) -> Iterator[Fault]:
    """Yield a fault for each parameter of unknown meaning that may correct the axis."""
    found = (machine.entry(number, axis) for number in machine.series.unknown)
    entry = next((entry for entry in found if entry is not None and not entry.zero), None)
    if entry is not None:
        yield entry.fault(
            f"what {entry.number} does to axis {axis} is not known, so it is not judged", "0"
        )


def left_out(machine: Machine, axis: int, counted: frozenset[str]) -> Iterator[str]:
    """Yield a note for each compensation function that is active on an axis but not evaluated (not
    in ``counted``).
    """
    by_axis = {
        "inclination": ("inclination compensation", _INCLINED),
        "cyclic": ("the second (cyclic) pitch error table", CYCLIC[1:]),
        "": ("smooth backlash", _SMOOTH),
    }
    for option, (name, numbers) in by_axis.items():
        nonzero = [
            entry
            for number in numbers
            if (entry := machine.entry(number, axis)) is not None and not entry.zero
        ]
        if nonzero and option not in counted:
            yield f"{name} is active ({_where(nonzero[0])}) and is not counted"
    straight = () if "straightness" in counted else (*_MOVED, *_BENDING)
    for name, axes in (
        ("straightness compensation", straight),
        ("three-dimensional error compensation", _FIELD),
    ):
        entry = next(_naming(machine, axes, axis), None)
        if entry is not None:
            yield f"{name} names it ({_where(entry)}) and is not counted"
    further = _any(machine, _FURTHER)
    if further is not None:
        yield f"further straightness pairs may act ({_where(further)}) and are not counted"


def _lines(
    at: list[MachineEntry | None],
    amounts: list[MachineEntry | None],
    what: str,
    faults: list[Fault],
) -> InclinedLines | None:
    """Return the lines through the ``amounts`` at the four point numbers ``at``; None if all
    amounts are 0 or, with a fault, if a number is invalid. ``what``: the name of the compensation
    in the fault.
    """
    nonzero = [entry for entry in amounts if entry is not None and not entry.zero]
    if not nonzero:
        return None
    points = [0 if entry is None else entry.whole for entry in at]
    values = [0 if entry is None else entry.whole for entry in amounts]
    if any(value is None for value in points):
        bad = next(entry for entry in at if entry is not None and entry.whole is None)
        faults.append(bad.fault(f"a point number of the {what} is wrong", "a whole number"))
        return None
    if any(value is None or abs(value) > _LARGEST for value in values):
        bad = next(e for e in nonzero if e.whole is None or abs(e.whole) > _LARGEST)
        faults.append(
            bad.fault(f"an amount of the {what} is out of range", f"-{_LARGEST} to {_LARGEST}")
        )
        return None
    pairs = [(p or 0, v or 0) for p, v in zip(points, values, strict=True)]
    if any(a[0] > b[0] or (a[0] == b[0] and a[1] != b[1]) for a, b in pairwise(pairs)):
        found = ", ".join(f"{point}: {value}" for point, value in pairs)
        faults.append(
            nonzero[0].fault(
                f"the points of the {what} are wrong ({found})", "ascending, one amount at each"
            )
        )
        return None
    return InclinedLines(tuple(p for p, _ in pairs), tuple(v for _, v in pairs))


def _of(machine: Machine, number: int, owner: Owner) -> MachineEntry | None:
    """Return the value of a parameter for ``owner``; if the files give none, the value for the
    whole machine.
    """
    found = machine.entries.get(number, {})
    return found.get(owner, found.get(MACHINE))


def _one_axis(
    machine: Machine, owner: Owner, entry: MachineEntry, faults: list[Fault]
) -> int | None:
    """Return the axis whose number is the value of the parameter ``entry``, which belongs to
    ``owner`` (axis, path or machine); None, with a fault, if it is not clear which axis is meant.
    """
    axes = () if entry.whole is None else machine.named(owner, entry.whole)
    if len(axes) == 1:
        return axes[0]
    faults.append(
        entry.fault(
            f"the axis that {entry.number} names is unknown",
            "a number that means one axis, or 981 of the axes in the files",
        )
    )
    return None


def _naming(machine: Machine, numbers: Iterable[int], axis: int) -> Iterator[MachineEntry]:
    """Yield those of the parameters ``numbers`` whose value is an axis number that may mean this
    axis.
    """
    for number in numbers:
        for owner, entry in machine.entries.get(number, {}).items():
            if entry.zero:
                continue
            axes = () if entry.whole is None else machine.named(owner, entry.whole)
            if not axes or axis in axes:
                yield entry


def _any(machine: Machine, numbers: Iterable[int]) -> MachineEntry | None:
    """Return the first value except 0 of the parameters ``numbers``; None if all are 0."""
    found = (entry for number in numbers for entry in machine.entries.get(number, {}).values())
    return next((entry for entry in found if not entry.zero), None)


def _where(entry: MachineEntry) -> str:
    return f"{entry.number}: {entry.text}, {entry.file}, line {entry.line}"
