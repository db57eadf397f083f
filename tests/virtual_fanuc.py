"""A virtual FANUC for the tests, written from the facts pages alone: what a control does with the
bytes that are loaded into it.

It shares no line with the package: no parser, no interpolation, no sign. Where the pages do not
tell enough it raises ``NotKnownError`` instead of guessing. Sources: the facts page on FANUC,
sections A1 (parameters), A2 (meaning of one value, turns, two sets, inclination, cyclic table), A3
(backlash), A5 (straightness), A6 (text), A8 (virtual control), and the page on real backups,
section 1, which stands above.

Where the pages tell that a function acts and not how (its sign, its unit, what multiplies it), it
can act ``hidden``: as any fixed function of the node that hangs on its own parameters and on 3620
to 3624. Whoever leaves all of these alone leaves it as it is; whoever moves one gets another axis.
Of inclination and straightness the pages tell the lines through point numbers: hidden is the factor
alone, sign and unit, which hangs on 3623 too.

Positions and corrections are mm, on a rotary axis degrees. A correction is what the control adds to
the command; ``direction`` is +1 or -1, ``home`` the direction in which the reference is approached:
there, and only there, the correction at the reference is 0.
"""

from __future__ import annotations

import math
import re
import zlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_HEAD = re.compile(r"N(\d+)(Q[01])?")
_ENTRY = re.compile(r"([ALS]\d+)?([PMI])([-+]?[0-9.]+)")
INCH = 25.4


class NotKnownError(Exception):
    """The facts pages do not say what the control does here; the message names the parameter."""


class Entry(NamedTuple):
    """One value as the file has it: its letter (P, M metric, I inch) and its text."""

    letter: str
    text: str


@dataclass
class Registers:
    """What stands in the control: parameters by number and group (A1, L1, S1, or nothing), pitch
    data by number.
    """

    parameters: dict[tuple[int, str], Entry] = field(default_factory=dict)
    pitch: dict[int, str] = field(default_factory=dict)

    def load(self, text: bytes) -> None:
        """Load a file over what is there. Q0 is pitch data, Q1 parameters; without any Q, a file of
        nothing else is pitch data.
        """
        read = _registers(text)
        self.parameters.update(read.parameters)
        self.pitch.update(read.pitch)

    def copy(self) -> Registers:
        return Registers(dict(self.parameters), dict(self.pitch))


@lru_cache(maxsize=32)
def _registers(text: bytes) -> Registers:
    records = tuple(_read(text))
    with_q = any(q for _, q, _ in records)
    whole = bool(records) and all(
        number >= 10000 and [g for g, _ in entries] == [""] for number, _, entries in records
    )
    registers = Registers()
    for number, q, entries in records:
        if q == "Q0" or (not with_q and whole):
            registers.pitch[number - 10000] = entries[0][1].text
        else:
            registers.parameters.update({(number, group): entry for group, entry in entries})
    return registers


def _read(text: bytes) -> Iterable[tuple[int, str, tuple[tuple[str, Entry], ...]]]:
    for line in re.split(r"[\r\n]+", text.decode("ascii")):
        packed = line.replace(" ", "")
        head = _HEAD.match(packed)
        if head is None:
            continue
        found = _ENTRY.finditer(packed[head.end() :])
        entries = tuple((e[1] or "", Entry(e[2], e[3])) for e in found)
        yield int(head[1]), head[2] or "", entries


def loaded(files: Iterable[bytes]) -> Registers:
    """The registers of an empty control after these files, in this order."""
    registers = Registers()
    for text in files:
        registers.load(text)
    return registers


@dataclass(frozen=True)
class Grid:
    """3620 to 3627 of one axis, interval and turn in mm or degrees; ``turn`` is 0 where the axis
    does not wrap.
    """

    reference: int
    first: int
    last: int
    magnification: int
    interval: float
    turn: float
    two_sets: bool
    negative_first: int
    offset: float

    @property
    def acts(self) -> bool:
        return (
            self.magnification != 0
            and self.interval > 0
            and self.last >= self.first
            and self.last > 0
        )

    def numbers(self) -> set[int]:
        """Every number of the common array that belongs to this grid."""
        if self.last < self.first or self.last <= 0:
            return set()
        own = set(range(self.first, self.last + 1)) | ({self.reference} if self.turn else set())
        if self.two_sets:
            own |= set(range(self.negative_first, self.negative_first + self.last - self.first + 1))
        return own


@dataclass(frozen=True)
class VirtualFanuc:
    """A control with ``registers``. ``output`` is step (the pulses of a section at once in its
    middle) or ramp (A2, A8).

    The four signs are +1; the mutation tests turn them. ``half_section`` moves the place of the
    step by that share of a section.
    """

    registers: Registers
    output: str = "step"
    older: bool = False
    offset_magnified: bool = False
    pitch_sign: int = 1
    backlash_sign: int = 1
    offset_sign: int = 1
    unit_factor: float = 1.0
    half_section: float = 0.0
    #: not 0: functions act hidden, except those of ``told`` (inclination, cyclic, straightness)
    hidden: int = 0
    told: frozenset[str] = frozenset()
    #: 0i-D, 0i-F: 8135#0 = 1 switches stored pitch error compensation off
    has_npe: bool = False

    # --- what stands where
    # ----------------------------------------------------------------------------------------------

    def entry(self, number: int, axis: int) -> Entry | None:
        """The value for an axis: its A group, or that of its path (L), or the one for all."""
        for group in (f"A{axis}", f"L{self.path(axis)}", ""):
            if (found := self.registers.parameters.get((number, group))) is not None:
                return found
        return None

    def value(self, number: int, axis: int) -> float:
        found = self.entry(number, axis)
        return 0.0 if found is None else float(found.text)

    def bit(self, number: int, axis: int, place: int) -> bool:
        """Bit ``place``, counted from the right (A6)."""
        found = self.entry(number, axis)
        return found is not None and found.text[::-1][place : place + 1] == "1"

    def path(self, axis: int) -> int:
        """The path of an axis (0981); each path speaks for its own axes."""
        found = self.registers.parameters.get((981, f"A{axis}"))
        return 1 if found is None else int(found.text)

    def axes(self) -> list[int]:
        return sorted(
            {int(group[1:]) for _, group in self.registers.parameters if group.startswith("A")}
        )

    def rotary(self, axis: int) -> bool:
        return self.bit(1006, axis, 0)

    def wraps(self, axis: int) -> bool:
        """1006#0 = 1 with 1006#1 = 0: the rotary axis whose coordinate begins again after a
        turn.
        """
        return self.rotary(axis) and not self.bit(1006, axis, 1)

    def length(self, number: int, axis: int) -> float:
        """A length parameter in mm or degrees: by its letter, with P in the machine's own unit;
        older series count in 0.001.
        """
        found = self.entry(number, axis)
        if found is None:
            return 0.0
        value = float(found.text) * (0.001 if self.older and "." not in found.text else 1.0)
        if self.rotary(axis):
            return value
        inch = found.letter == "I" or (found.letter == "P" and self.bit(1001, axis, 0))
        return value * INCH if inch else value

    def least_increment(self, axis: int) -> float:
        """IS-A to IS-E by 1013 (older series: 1004 of the path), 1001#0 inch: mm or degrees."""
        increments = self.entry(1004 if self.older else 1013, axis)
        bits = (increments.text if increments is not None else "0").lstrip("0")
        if self.older:
            bits = bits[-2:].lstrip("0")
        sizes = {"": 1e-3, "1": 1e-2, "10": 1e-4, "100": 1e-5, "1000": 1e-6}
        if bits not in sizes:
            raise NotKnownError(f"1013 = {bits}: no increment system")
        inch = self.bit(1001, axis, 0) and not self.rotary(axis)
        return sizes[bits] * (0.1 * INCH if inch else 1.0)  # 0.0001 inch on IS-B

    def detection_unit(self, axis: int) -> float:
        """Least command increment over CMR (1820: 2 CMR, or 100 + 1/CMR): mm or degrees."""
        setting = int(self.value(1820, axis))
        if 1 <= setting <= 96:
            return self.unit_factor * self.least_increment(axis) / (setting / 2)
        if 101 <= setting <= 127:
            return self.unit_factor * self.least_increment(axis) * (setting - 100)
        raise NotKnownError(f"1820 = {setting}: no command multiplier")

    def grid(self, axis: int) -> Grid:
        turn = (self.length(3625, axis) or 360.0) if self.wraps(axis) else 0.0
        return Grid(
            reference=int(self.value(3620, axis)),
            first=int(self.value(3621, axis)),
            last=int(self.value(3622, axis)),
            magnification=int(self.value(3623, axis)),
            interval=self.length(3624, axis),
            turn=turn,
            two_sets=self.bit(3605, axis, 0),
            negative_first=int(self.value(3626, axis)),
            offset=self.value(3627, axis),
        )

    # --- what acts
    # ----------------------------------------------------------------------------------------------

    def correction(
        self, axis: int, x: Floats, direction: int, *, home: int = 1, rapid: bool = False
    ) -> Floats:
        """What the control adds at ``x``: pitch data, inclination, cyclic table, backlash; other
        axes at their references.
        """
        if self.bit(3602, axis, 0):
            raise NotKnownError("3602#0 = 1: totals; what a number then means is not told")
        if self.length(1240, axis):
            raise NotKnownError(
                "1240: whether the grid hangs on machine zero or on the reference position is not"
                " told"
            )
        grid = self.grid(axis)
        total = np.zeros_like(x)
        if grid.acts and not (self.has_npe and self.bit(8135, axis, 0)):
            total = total + self._pitch(axis, grid, x, direction, home)
            if self._is_told("inclination"):
                total = total + self._inclination(axis, grid, x)
        if self._is_told("cyclic"):
            total = total + self._cyclic(axis, x)
        if self.hidden:
            total = total + self._hidden(axis, x, direction, home)
        return total + self._backlash(axis, direction, home, rapid)

    # --- what acts in a way that the pages do not tell
    # ----------------------------------------------------------------------------------------------

    def _is_told(self, function: str) -> bool:
        return not self.hidden or function in self.told

    def _hidden(self, axis: int, x: Floats, direction: int, home: int) -> Floats:
        total = np.zeros_like(x)
        if not self._is_told("inclination") and self.grid(axis).acts:
            total = total + self._gain(axis, "inclination") * self._inclination(
                axis, self.grid(axis), x
            )
        if not self._is_told("cyclic") and self.cyclic_numbers(axis):
            own = ",".join(self.registers.pitch.get(n, "") for n in self.cyclic_numbers(axis))
            total = total + self._shape(axis, x, range(14985, 14989), own)
        for rows in (range(10800, 10815), range(13381, 13400)):
            if self.speaks(axis, rows):
                total = total + self._shape(axis, x, rows)
        smooth = range(1846, 1850)
        if direction != home and self.speaks(axis, smooth):
            total = total + self._draw(axis, smooth, "").normal(0, 2e-3)
        return total

    def speaks(self, axis: int, numbers: Iterable[int]) -> bool:
        return any(self.value(number, axis) for number in numbers)

    def _draw(self, axis: int, numbers: Iterable[int], more: str) -> np.random.Generator:
        """The same figures for the same parameters of the function and of the grid."""
        found = [self.entry(number, axis) for number in numbers]
        texts = [entry.text if entry is not None else "" for entry in found]
        return np.random.default_rng([self.hidden, zlib.crc32(repr((axis, texts, more)).encode())])

    def _gain(self, axis: int, function: str) -> float:
        """What the lines of a function are multiplied with: of either sign."""
        rng = self._draw(axis, [3623], function)
        return float(rng.uniform(0.3, 2.0) * rng.choice([-1, 1]))

    def _shape(self, axis: int, x: Floats, numbers: Iterable[int], more: str = "") -> Floats:
        """Some micrometres (thousandths of a degree) at the node next to x, by its point number."""
        grid = self.grid(axis)
        if grid.interval <= 0:
            return np.zeros_like(x)
        rng = self._draw(axis, [*numbers, *range(3620, 3625)], more)
        node = np.floor((np.mod(x, grid.turn) if grid.turn else x) / grid.interval + 0.5)
        number = np.clip(node + grid.reference, grid.first - 1, grid.last)
        waves = [(rng.normal(0, 3e-3), rng.uniform(12, 60), rng.uniform(0, 6)) for _ in range(2)]
        return np.asarray(
            sum(height * np.sin(2 * np.pi * number / many + at) for height, many, at in waves)
        )

    def _points(self, numbers: Iterable[int]) -> Floats:
        missing = [number for number in numbers if number not in self.registers.pitch]
        if missing:
            raise NotKnownError(
                f"pitch data {missing[:3]} of a table that acts are nowhere: missing is not zero"
            )
        return np.array([float(self.registers.pitch[number]) for number in numbers])

    def _pitch(self, axis: int, grid: Grid, x: Floats, direction: int, home: int) -> Floats:
        unit = self.pitch_sign * self.detection_unit(axis)
        shift = 0
        offset = 0.0
        if grid.two_sets:
            shift = grid.negative_first - grid.first if direction < 0 else 0
            if direction != home:
                offset = (
                    self.offset_sign
                    * grid.offset
                    * (grid.magnification if self.offset_magnified else 1)
                )
        first = grid.reference + 1 if grid.turn else grid.first
        numbers = list(range(first, grid.last + 1))
        points = self._points([number + shift for number in numbers])
        if grid.turn:
            if points.sum() != 0:
                raise NotKnownError(
                    f"axis {axis}: the numbers of a turn add up to {points.sum():g}, not 0: it"
                    " creeps with each turn"
                )
            if abs(len(numbers) * grid.interval - grid.turn) > 1e-6:
                raise NotKnownError(
                    f"axis {axis}: {len(numbers)} sections of {grid.interval} are no turn of"
                    f" {grid.turn}"
                )
            x = np.mod(x, grid.turn)
        share = self._share(
            x[:, None],
            (np.array(numbers) - grid.reference - 1)[None, :] * grid.interval,
            grid.interval,
        )
        signed = np.where(
            np.array(numbers) > grid.reference, share, share - 1.0
        )  # below the reference what is not passed yet counts
        return np.asarray(unit * (grid.magnification * (signed @ points) + offset))

    def _share(self, x: Floats, start: NDArray[Any], interval: float) -> Floats:
        """How much of a section's pulses is out at x: none before it, all behind it."""
        inside = (x - start) / interval
        if self.output == "ramp":
            return np.asarray(np.clip(inside, 0.0, 1.0))
        return np.asarray(np.where(inside >= 0.5 + self.half_section - 1e-9, 1.0, 0.0))

    def _inclination(self, axis: int, grid: Grid, x: Floats) -> Floats:
        line = self.bent_line(axis, (5861, 5862, 5863, 5864), (5871, 5872, 5873, 5874))
        if line is None:
            return np.zeros_like(x)
        return np.asarray(
            self.detection_unit(axis) * _along(line, grid, np.mod(x, grid.turn) if grid.turn else x)
        )

    def bent_line(
        self, axis: int, numbers: tuple[int, ...], amounts: tuple[int, ...]
    ) -> tuple[Floats, Floats] | None:
        """Four point numbers and their amounts, or None where every amount is zero."""
        at = np.array([self.value(number, axis) for number in numbers])
        amount = np.array([self.value(number, axis) for number in amounts])
        return (at, amount) if amount.any() else None

    def straightness(self, moving: int, x: Floats) -> dict[int, Floats]:
        """What moves on other axes while ``moving`` stands at x, by axis: up to three pairs
        (A5).
        """
        shifts: dict[int, Floats] = {}
        grid = self.grid(moving)
        for pair in range(3):
            if int(self.value(5711 + pair, moving)) != moving:
                continue
            bent = int(self.value(5721 + pair, moving))
            first, amounts = 5731 + 10 * pair, 5761 + 10 * pair
            line = self.bent_line(
                moving, tuple(range(first, first + 4)), tuple(range(amounts, amounts + 4))
            )
            if bent and line is not None and not self._is_told("straightness"):
                factor = self._gain(moving, "straightness")
            else:
                factor = 1.0
            if bent and line is not None and grid.interval > 0:
                place = np.mod(x, grid.turn) if grid.turn else x
                shifts[bent] = shifts.get(bent, np.zeros_like(x)) + (
                    factor * self.detection_unit(bent) * _along(line, grid, place)
                )
        return shifts

    def cyclic_numbers(self, axis: int) -> range:
        first, last = int(self.value(14985, axis)), int(self.value(14986, axis))
        return range(first, last + 1) if last > first else range(0)

    def _cyclic(self, axis: int, x: Floats) -> Floats:
        """Second table (14985 to 14987): first+1 to last own the sections of one period, repeated
        (A2: 10, 20, 2.0: period 20).
        """
        numbers = self.cyclic_numbers(axis)
        interval = self.length(14987, axis)
        if not numbers or interval <= 0:
            return np.zeros_like(x)
        points = self._points(list(numbers)[1:])
        period = interval * len(points)
        share = self._share(
            np.mod(x, period)[:, None], np.arange(len(points))[None, :] * interval, interval
        )
        return np.asarray(
            self.detection_unit(axis) * (self.value(14988, axis) or 1.0) * (share @ points)
        )

    def _backlash(self, axis: int, direction: int, home: int, rapid: bool) -> float:
        """1851, in rapid traverse 1852 where 1800#4 of the axis's path asks for it; in the
        direction of the new motion (A3).
        """
        if direction == home:
            return 0.0
        number = 1852 if rapid and self.bit(1800, axis, 4) else 1851
        pulses = self.value(number, axis)
        return (
            self.backlash_sign * direction * pulses * self.detection_unit(axis) if pulses else 0.0
        )


def _along(line: tuple[Floats, Floats], grid: Grid, x: Floats) -> Floats:
    """Three straight lines through four point numbers, at the node next to x, less their value at
    the reference; held outside.
    """
    node = np.clip(
        np.floor(x / grid.interval + 0.5),
        grid.first - 1 - grid.reference,
        grid.last - grid.reference,
    )
    at, amount = line
    keep = np.concatenate([[True], np.diff(at) > 0])
    bent = np.interp(node + grid.reference, at[keep], amount[keep]) - np.interp(
        grid.reference, at[keep], amount[keep]
    )
    return np.asarray(bent)


def owners(control: VirtualFanuc) -> dict[int, set[int]]:
    """The numbers that each axis's main table uses, acting or not."""
    return {axis: control.grid(axis).numbers() for axis in control.axes()}


def differing(before: Registers, after: Registers) -> tuple[set[tuple[int, str]], set[int]]:
    """Parameters (number, group) and pitch numbers whose text differs, or that are only in one of
    both.
    """
    parameters = {
        key
        for key in before.parameters | after.parameters
        if before.parameters.get(key) != after.parameters.get(key)
    }
    return parameters, {
        n for n in before.pitch | after.pitch if before.pitch.get(n) != after.pitch.get(n)
    }


def accuracy(readings: Mapping[int, Floats]) -> float:
    """A of ISO 230-2 (coverage 2): readings by direction, targets by runs, in any unit."""
    tops, bottoms = [], []
    for values in readings.values():
        mean, s = values.mean(axis=1), values.std(axis=1, ddof=1)
        tops.append(float((mean + 2 * s).max()))
        bottoms.append(float((mean - 2 * s).min()))
    return max(tops) - min(bottoms) if all(map(math.isfinite, tops + bottoms)) else math.nan
