"""The two files of a real FANUC backup, changed in place by number and axis; nothing here is taken
from the package.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from places import REAL

FOLDER = REAL / "fanuc"
PARAMETERS, PITCH = "CNC-PARA.TXT", "PITCH.TXT"
#: What a random job keeps of the 9125 lines: all that the pages name, and enough N1nnnnQ1P.. to be
#: taken for pitch data by mistake.
_KEPT = (
    range(900, 2000),
    range(3400, 3700),
    range(5700, 5900),
    range(8130, 8140),
    range(10300, 10360),
    range(10800, 10830),
    range(13300, 13400),
    range(14900, 15000),
)
Rng = np.random.Generator


# --- the files
# --------------------------------------------------------------------------------------------------


@cache
def _parameters(*, whole: bool) -> bytes:
    content = (FOLDER / PARAMETERS).read_bytes()
    lines = content.split(b"\n")
    kept = (
        line for line in lines if line[:1] != b"N" or any(int(line[1:6]) in part for part in _KEPT)
    )
    return content if whole else b"\n".join(kept)


class Backup:
    """The two files of a backup as lines; every byte that is not set stays."""

    def __init__(self, parameters: bytes, pitch: bytes) -> None:
        self.parameters = parameters.split(b"\n")
        self.pitch = pitch.split(b"\n")
        self._line = {
            int(line[1:6]): n
            for n, line in enumerate(self.parameters)
            if re.match(rb"N\d{5}Q1", line)
        }
        self._point = {
            int(line[2:6]): n for n, line in enumerate(self.pitch) if re.match(rb"N1\d{4}Q0", line)
        }

    @staticmethod
    def real(whole: bool = False) -> Backup:
        return Backup(_parameters(whole=whole), (FOLDER / PITCH).read_bytes())

    def files(self, newline: bytes = b"\n") -> dict[str, bytes]:
        return {PARAMETERS: newline.join(self.parameters), PITCH: newline.join(self.pitch)}

    def set(self, number: int, group: str, value: object, letter: str = "P") -> Backup:
        """One value of one parameter, in place."""
        n = self._line[number]
        pattern = (
            rb"(?<=[Q\d])" + group.encode() + rb"[PMI][-0-9.]+" if group else rb"(?<=Q1)P[-0-9.]+"
        )
        new, count = re.subn(
            pattern, f"{group}{letter}{value}".encode(), self.parameters[n], count=1
        )
        assert count == 1, f"{number} {group}"
        self.parameters[n] = new
        return self

    def get(self, number: int, group: str) -> str:
        found = re.search(
            rb"(?<=[Q\d])" + group.encode() + rb"[PMI]([-0-9.]+)",
            self.parameters[self._line[number]],
        )
        assert found is not None
        return found[1].decode()

    def bit(self, number: int, group: str, place: int, on: bool = True) -> Backup:
        text = list(self.get(number, group))
        text[-1 - place] = "1" if on else "0"
        return self.set(number, group, "".join(text))

    def points(self, values: Mapping[int, int]) -> Backup:
        for number, value in values.items():
            line = self.pitch[self._point[number]]
            self.pitch[self._point[number]] = re.sub(rb"P-?\d+", b"P%d" % value, line)
        return self

    def drop(self, numbers: Iterable[int]) -> Backup:
        gone = {self._line[number] for number in numbers if number in self._line}
        return Backup(
            b"\n".join(line for n, line in enumerate(self.parameters) if n not in gone),
            b"\n".join(self.pitch),
        )

    def older(self) -> Backup:
        """The same machine in the older style: no Q, intervals as whole numbers of 0.001 mm, none
        above 9999, 1004 for 1013.
        """
        backup = self.drop(number for number in self._line if number >= 10000 or number == 1013)
        lines = []
        for given in backup.parameters:
            line = re.sub(rb"(?<=^N\d{5})Q1", b"", given)
            if line.startswith((b"N03624", b"N03625", b"N01240", b"N01260", b"N01320", b"N01321")):
                line = re.sub(
                    rb"(?<=P)-?[0-9.]+", lambda found: b"%d" % round(float(found[0]) * 1000), line
                )
            if line.startswith(b"N01420"):
                line = re.sub(rb"\.0", b"", line)
            lines.append(line)
        pitch = [re.sub(rb"(?<=^N1\d{4})Q0", b"", line) for line in backup.pitch]
        backup.parameters, backup.pitch = lines, pitch
        return backup


@dataclass(frozen=True)
class Table:
    """A grid of an axis, to be put into a backup."""

    axis: int
    reference: int
    first: int
    last: int
    interval: float
    magnification: int = 1

    def put(self, backup: Backup, increments: Sequence[int] | None = None) -> Backup:
        group = f"A{self.axis}"
        for number, value in zip(
            (3620, 3621, 3622, 3623),
            (self.reference, self.first, self.last, self.magnification),
            strict=True,
        ):
            backup.set(number, group, value)
        backup.set(
            3624,
            group,
            f"{self.interval:.3f}".rstrip("0").rstrip(".") + ("" if self.interval % 1 else ".0"),
        )
        if increments is not None:
            backup.points(dict(zip(range(self.first, self.last + 1), increments, strict=True)))
        return backup


def wavy(
    rng: Rng,
    count: int,
    pulse_um: float,
    closed: bool = False,
    height: float = 12.0,
    most: int = 100,
) -> list[int]:
    """Increments of a realistic old table: smooth totals of some ten micrometres, rounded as
    totals, then differenced.
    """
    at = np.linspace(0, 1, count + 1)
    totals = height * (
        rng.normal() * np.sin(2 * np.pi * at + rng.uniform(0, 6))
        + rng.normal() * np.sin(4 * np.pi * at + rng.uniform(0, 6))
    )
    if not closed:
        totals = totals + rng.normal() * height * at
    steepest = np.abs(np.diff(totals)).max() / pulse_um
    pulses = np.round((totals - totals[0]) / pulse_um / max(1.0, steepest / (most - 1)))
    return [int(step) for step in np.diff(pulses)]
