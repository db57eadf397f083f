"""A small FANUC of one's own: parameters and pitch data in the 30i form, columns that move together.

Written from the facts: point n owns the section below node n - r, its increment comes out in the
middle of that section, counted from the reference point r; 1851 acts against the return direction
(here: return in +). Detection unit 0.001 mm.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

UNIT = 0.001


@dataclass(frozen=True)
class Pitch:
    """Grid, increments and backlash of one axis number, as a service engineer has entered them."""

    reference: int
    first: int
    interval: float
    increments: Sequence[int]
    backlash: int = 0
    magnification: int = 1
    backlash_rapid: int | None = None

    @property
    def last(self) -> int:
        return self.first + len(self.increments) - 1


@dataclass
class Backup:
    """Texts of a backup: ``extra`` holds further parameters by number, one value for each axis."""

    pitches: Mapping[int, Pitch]
    axes: int = 4
    letters: Sequence[str] = ("X", "Y", "Z", "V")
    low: float = 0.0
    high: float = 600.0
    extra: Mapping[int, Sequence[str]] = field(default_factory=dict)
    settings: Sequence[str] = ()

    def parameters(self) -> str:
        rows: dict[int, list[str]] = {
            1006: ["00000000"] * self.axes,
            1013: ["00000000"] * self.axes,
            1020: [str(ord(letter)) for letter in self.letters],
            1240: ["0.0"] * self.axes,
            1320: [f"{self.high + 5:.1f}"] * self.axes,
            1321: [f"{self.low - 5:.1f}"] * self.axes,
            1800: ["00000000"] * self.axes,
            1815: ["00110000"] * self.axes,
            1820: ["2"] * self.axes,
            3605: ["00000000"] * self.axes,
            3625: ["0.0"] * self.axes,
            3626: ["0"] * self.axes,
            3627: ["0"] * self.axes,
        }
        for number, pick in _PICKS.items():
            rows[number] = [
                pick(self.pitches[axis]) if axis in self.pitches else _NONE.get(number, "0")
                for axis in range(1, self.axes + 1)
            ]
        for number, values in self.extra.items():
            rows[number] = list(values)
        lines = [
            f"N{number:05d}Q1" + "".join(f"A{i}P{value}" for i, value in enumerate(values, 1))
            for number, values in sorted(rows.items())
        ]
        lines += [f"N{row}" for row in self.settings]
        return "%\n" + "\n".join(sorted(lines)) + "\n%"

    def points(self, count: int = 400) -> str:
        values = [0] * count
        for pitch in self.pitches.values():
            for i, increment in enumerate(pitch.increments):
                values[pitch.first + i] = increment
        return "%\n" + "\n".join(f"N{10000 + i}Q0P{v}" for i, v in enumerate(values)) + "\n%"


_PICKS: dict[int, Callable[[Pitch], str]] = {
    1851: lambda pitch: str(pitch.backlash),
    1852: lambda pitch: str(
        pitch.backlash if pitch.backlash_rapid is None else pitch.backlash_rapid
    ),
    3620: lambda pitch: str(pitch.reference),
    3621: lambda pitch: str(pitch.first),
    3622: lambda pitch: str(pitch.last),
    3623: lambda pitch: str(pitch.magnification),
    3624: lambda pitch: f"{pitch.interval:.1f}",
}
_NONE = {3624: "0.0"}


@dataclass
class Fanuc:
    """Values of the control: parameters by number and axis, pitch data by number."""

    values: dict[tuple[int, int], str] = field(default_factory=dict)
    data: dict[int, int] = field(default_factory=dict)

    def load(self, text: str) -> None:
        """Read parameters (Q1, A1P..A2P..) and pitch data (Q0)."""
        for row in text.splitlines():
            head = re.match(r"N(\d+)Q(\d)(.*)", row.strip())
            if head is None:
                continue
            number, kind, rest = int(head[1]), head[2], head[3]
            if kind == "0":
                self.data[number - 10000] = int(rest[1:])
                continue
            for axis, value in re.findall(r"A(\d+)[PMI](-?[\d.]+)", rest):
                self.values[number, int(axis)] = value

    def number(self, parameter: int, axis: int) -> float:
        return float(self.values.get((parameter, axis), "0"))

    def correction(
        self, axis: int, position: float, direction: int, *, rapid: bool = False
    ) -> float:
        """Give what the control adds to the command of this axis number, mm."""
        shift = self._pitch(axis, position, direction)
        if direction < 0:
            own = rapid and self.values.get((1800, axis), "0").zfill(8)[-5] == "1"
            shift -= self.number(1852 if own else 1851, axis) * UNIT
        return shift

    def _pitch(self, axis: int, position: float, direction: int) -> float:
        interval = self.number(3624, axis)
        magnification = self.number(3623, axis)
        if interval <= 0 or magnification <= 0:
            return 0.0
        reference, first, last = (int(self.number(n, axis)) for n in (3620, 3621, 3622))
        shift, offset = 0, 0.0
        both = self.values.get((3605, axis), "0")[-1] == "1"
        if both and direction < 0:
            shift = int(self.number(3626, axis)) - first
            offset = self.number(3627, axis)
        node = math.floor(position / interval + 0.5)
        if node > 0:
            numbers, sign = range(reference + 1, min(reference + node, last) + 1), 1
        else:
            numbers, sign = range(max(reference + node + 1, first), reference + 1), -1
        total = sign * sum(self.data.get(n + shift, 0) for n in numbers)
        return (magnification * total + offset) * UNIT
