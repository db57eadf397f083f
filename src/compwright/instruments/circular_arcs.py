"""The samples of circular runs: their order, their arc, and whether all runs have the same arc."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.instruments.fault_list import FaultList
from compwright.records.axis import FloatArray
from compwright.records.circular import SHORTEST_ARC, CircularRun, Sense

#: Three points always lie on a circle.
FEWEST_SAMPLES: Final = 4
#: Angles are counted from 0 or from -180, and may go on beyond one turn: never farther than this
#: from zero, deg.
LARGEST_ANGLE: Final = 720.0
#: The end of the circle lies one sample from its beginning; samples by a clock are not quite
#: equally far apart.
_ONE_SAMPLE: Final = 1.5
#: Between samples all around, a gap up to this is a hole in the circle (samples are missing); a
#: wider one is outside an arc, deg.
_HOLE: Final = 5.0
_TINY: Final = 1e-9  # deg: rounding of sums


@dataclass(frozen=True, slots=True, kw_only=True)
class Sweep:
    """The samples of a run sorted by angle: ``angles`` (n,) deg, and their indices ``order``.

    The first angle a is in 0 <= a < 360. ``step``: the median distance of neighbouring samples,
    deg. ``gap``: the widest distance of two neighbouring samples, and the angle at which it begins,
    deg.
    """

    sense: Sense
    number: int
    order: np.ndarray[tuple[int, ...], np.dtype[np.intp]]
    angles: FloatArray
    step: float
    gap: tuple[float, float]

    @property
    def extent(self) -> float:
        """The angle from the first to the last sample, deg."""
        return float(self.angles[-1] - self.angles[0])

    @property
    def full(self) -> bool:
        """Whether the samples cover a whole circle: the first and the last sample are not more than
        about one sample step apart.
        """
        return 360.0 - self.extent <= _ONE_SAMPLE * self.step + _TINY

    @property
    def name(self) -> str:
        """The name of the run in messages, such as ``ccw run 1``."""
        return f"{self.sense} run {self.number}"


def sweep_of(sense: Sense, number: int, angles: FloatArray, faults: FaultList) -> Sweep | None:
    """Return a run's samples in order of their ``angles`` (n,) deg, or None after a fault.

    Angles may be counted modulo 360, so that an arc through 0 is in two pieces. Therefore the
    widest gap on the circle counts as the part outside the arc. If the samples go all around and
    the widest gap is at most 5 deg, they count as a full circle with missing samples.
    """
    name = f"{sense} run {number}"
    if angles.size < FEWEST_SAMPLES:
        faults.add(
            "has too few samples",
            place=name,
            expected=f"at least {FEWEST_SAMPLES}",
            found=str(angles.size),
            hint="export the run with all its samples, or measure it again",
        )
        return None
    order = np.argsort(angles, kind="stable")
    ascending = angles[order]
    between = np.diff(ascending)
    step = float(np.median(between))
    widest = int(np.argmax(between))
    around = 360.0 - float(ascending[-1] - ascending[0])
    if around < -_ONE_SAMPLE * step - _TINY:
        faults.add(
            "goes round more than once",
            place=name,
            expected="one traverse of at most 360 deg, without overshoot",
            found=f"angles from {ascending[0]:.10g} to {ascending[-1]:.10g}",
            hint="cut the start and the end of the run off, or give each traverse its own `run`",
        )
        return None
    closed = around <= _ONE_SAMPLE * step + _TINY
    if between[widest] > around and not (
        closed and between[widest] <= max(_HOLE, _ONE_SAMPLE * step)
    ):
        order = np.roll(order, -(widest + 1))
        ascending = angles[order] + np.where(
            np.arange(angles.size) < angles.size - widest - 1, 0.0, 360.0
        )
        between = np.diff(ascending)
        widest = int(np.argmax(between))
    ascending = ascending - 360.0 * np.floor(ascending[0] / 360.0)
    sweep = Sweep(
        sense=sense,
        number=number,
        order=order,
        angles=ascending,
        step=step,
        gap=(float(between[widest]), float(ascending[widest])),
    )
    if sweep.extent + step < SHORTEST_ARC - _TINY:
        faults.add(
            "covers too short an arc",
            place=name,
            expected="at least 90 deg",
            found=f"{sweep.extent:.6g} deg from {ascending[0] % 360.0:.6g} deg",
            hint="measure an arc of 90 deg or more",
        )
        return None
    return sweep


def run_of(sweep: Sweep, deviations: FloatArray, start: float) -> CircularRun:
    """Return the run with its samples in the order in which the machine moved: ascending angles for
    ccw, descending for cw. Whole turns are added so that the smallest angle is as near as possible
    to ``start`` deg.

    ``deviations`` (n,): in mm, in the order of the angles that were given to `sweep_of`.
    """
    angles = sweep.angles + 360.0 * np.round((start - float(sweep.angles[0])) / 360.0)
    along = slice(None) if sweep.sense == "ccw" else slice(None, None, -1)
    return CircularRun(
        sense=sweep.sense,
        number=sweep.number,
        angles=angles[along],
        deviations=deviations[sweep.order][along],
    )


def common_arc(sweeps: Sequence[Sweep], faults: FaultList) -> tuple[float, float]:
    """Return start and extent (deg) of the arc that all runs have in common, and add a fault if
    their arcs differ.

    Runs may differ by one sample at each end without a fault.
    """
    first = sweeps[0]
    start = float(first.angles[0])
    if all(sweep.full for sweep in sweeps):
        return start, 360.0
    low, high = start, start + first.extent
    for sweep in sweeps[1:]:
        turned = float(sweep.angles[0]) + 360.0 * round((start - float(sweep.angles[0])) / 360.0)
        check_same_arc(
            (start, first.extent),
            (turned, sweep.extent),
            max(first.step, sweep.step),
            (first.name, sweep.name),
            faults,
        )
        low, high = min(low, turned), max(high, turned + sweep.extent)
    return low % 360.0, min(high - low, 360.0)


def check_same_arc(
    one: tuple[float, float],
    other: tuple[float, float],
    step: float,
    names: tuple[str, str],
    faults: FaultList,
) -> None:
    """Add a fault if two arcs (start, extent; deg) differ by more than ``step`` at either end."""
    shift = (other[0] - one[0] + 180.0) % 360.0 - 180.0
    if max(abs(shift), abs(shift + other[1] - one[1])) > step + _TINY:
        faults.add(
            "covers another arc",
            place=names[1],
            expected=f"{one[1]:.6g} deg from {one[0] % 360.0:.6g} deg as in {names[0]}",
            found=f"{other[1]:.6g} deg from {other[0] % 360.0:.6g} deg",
            hint="give runs of the same arc only",
        )
