"""A virtual machine: axes with known errors, and positioning tests that an instrument would record.

Everything is in mm or deg and in machine coordinates. Deviation = measured minus target, so a
correction adds to the error.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.positioning import Cycle, PositioningTest
from compwright.simulation.circles import VirtualCircle
from compwright.simulation.circular import CircleCorrection, CircleRecording, record_circle
from compwright.simulation.curves import FLAT, DeviationCurve
from compwright.simulation.scatter import SimulatedScatter

#: What a control adds to the command, by position (any shape) and approach direction: mm or deg.
Correction = Callable[[FloatArray, Direction], FloatArray]


@dataclass(frozen=True, slots=True)
class ScrewError:
    """A periodic error, amplitude * sin(2 pi x / period + phase), over the position x from machine
    zero; ``period`` and ``amplitude`` in mm or deg, ``phase`` in rad.
    """

    period: float
    amplitude: float
    phase: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisError:
    """The error of a virtual axis: slope, smooth curve, reversal, scatter and drift.

    - ``slope``: relative (mm per mm, > 0 travels too far), from the axis' reference position.
    - ``reversal``: the mean of B = mean(+) - mean(-), negative for lost motion.
      ``reversal_variation``: its variation over the travel.
    - ``scatter``: standard deviation between readings.
    - ``drift``: change of the deviation from the first reading of a test to its last.
      ``expansion``: change of the slope (relative, from the reference position) in the same time.
      Both grow in proportion to the number of readings.
    """

    slope: float = 0.0
    smooth: DeviationCurve = FLAT
    screw: tuple[ScrewError, ...] = ()
    reversal: float = 0.0
    reversal_variation: DeviationCurve = FLAT
    scatter: SimulatedScatter = field(default_factory=SimulatedScatter)
    drift: float = 0.0
    expansion: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class TestPlan:
    """The way an axis is measured: ascending ``targets`` (m,), ``runs`` per direction, zero offset
    ``datum`` and ``resolution`` of the instrument; mm or deg.
    """

    targets: FloatArray
    runs: int = 5
    cycle: Cycle = "standard"
    directions: Literal["both", "+", "-"] = "both"
    datum: float = 0.0
    resolution: float = 0.0

    __test__ = False  # not a test class, whatever the name suggests to a collector

    def runs_in(self, direction: Direction) -> int:
        """Return the number of traverses in the given direction."""
        return self.runs if self.directions in {"both", direction.value} else 0

    def seen(self, deviations: FloatArray) -> FloatArray:
        """Return the deviations as the instrument shows them, rounded to its resolution."""
        if self.resolution == 0.0:
            return deviations
        steps: FloatArray = np.round(deviations / self.resolution) * self.resolution
        return steps


@dataclass(frozen=True, slots=True, kw_only=True)
class VirtualAxis:
    """A virtual axis: its properties, its error, and how it is measured."""

    axis: Axis
    error: AxisError
    test: TestPlan


@dataclass(frozen=True, slots=True, kw_only=True)
class VirtualMachine:
    """A virtual machine: its axes and circles by name.

    ``name``, ``serial``: written into the files. ``format``, ``options``: the control of the
    machine and its options.
    """

    axes: Mapping[str, VirtualAxis]
    circles: Mapping[str, VirtualCircle] = field(default_factory=dict)
    name: str = ""
    serial: str = ""
    format: str = ""
    options: Mapping[str, object] = field(default_factory=dict)

    def error(self, axis: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the true error at ``positions`` (any shape) reached in ``direction``, mm or deg.

        Noise, drift and the instrument's datum are not included. Approached in the axis' direction
        ``reference_return``, the error is the sum of slope, smooth curve and screw error.
        Approached in the other direction, the reversal is added or subtracted, so that mean(+) -
        mean(-) is the reversal error B of the axis for both values of ``reference_return``. Raises
        UsageError for an axis that the machine does not have.
        """
        own = self._axis(axis)
        where = np.asarray(positions, dtype=np.float64)
        deviation = own.error.slope * (where - own.axis.reference) + own.error.smooth.at(where)
        for screw in own.error.screw:
            deviation = deviation + screw.amplitude * np.sin(
                2.0 * np.pi * where / screw.period + screw.phase
            )
        if direction is not own.axis.reference_return:
            deviation = deviation + direction.sign * (
                own.error.reversal + own.error.reversal_variation.at(where)
            )
        return deviation

    def measure(
        self, axis: str, *, rng: np.random.Generator, correction: Correction | None = None
    ) -> PositioningTest:
        """Return a simulated positioning test of ``axis``, rounded to the instrument's resolution.
        ``correction``: the active correction of the axis, None for no correction.

        A reading is the sum of error, correction, scatter, drift and datum. ``rng`` is used for the
        scatter alone, so the same seed gives the same scatter with any correction. Raises
        UsageError for an axis that the machine does not have.
        """
        own = self._axis(axis)
        plan = own.test
        progress = dict(zip(Direction, _progress(plan), strict=True))
        runs = {direction: plan.runs_in(direction) for direction in Direction}
        scatter = own.error.scatter.drawn(plan.targets, runs, own.axis.travel, rng)
        gone = own.error.drift + own.error.expansion * (plan.targets - own.axis.reference)[:, None]
        readings = {}
        for direction in Direction:
            mean = self.error(axis, plan.targets, direction) + plan.datum
            if correction is not None:
                mean = mean + correction(plan.targets, direction)
            drift = (gone * progress[direction])[:, : runs[direction]]
            readings[direction] = plan.seen(mean[:, None] + drift + scatter[direction])
        return PositioningTest(
            name=own.axis.name.lower(),
            axis=own.axis.name,
            kind=own.axis.kind,
            targets=plan.targets,
            positive=readings[Direction.POSITIVE],
            negative=readings[Direction.NEGATIVE],
            runs_positive=tuple(range(1, plan.runs_in(Direction.POSITIVE) + 1)),
            runs_negative=tuple(range(1, plan.runs_in(Direction.NEGATIVE) + 1)),
            cycle=plan.cycle,
            frame="machine",
            header={
                key: text for key, text in (("machine", self.name), ("serial", self.serial)) if text
            },
        )

    def record_circle(
        self, name: str, *, seed: int, corrections: Mapping[str, Correction] | None = None
    ) -> CircleRecording:
        """Return a simulated circular test that contains the errors of the circle, the errors of
        its two axes, and the active ``corrections`` of these axes.

        Raises UsageError for a circle that the machine does not have.
        """
        if name not in self.circles:
            raise UsageError(
                Fault(
                    message=f"the machine has no circle {name}",
                    expected=", ".join(self.circles),
                    found=name,
                    hint="correct the name, or add the circle to the machine file",
                )
            )
        own = self.circles[name]
        return record_circle(
            own.errors, own.plan, seed=seed, corrections=self._along(corrections or {})
        )

    def _along(self, corrections: Mapping[str, Correction]) -> CircleCorrection:
        """Return a function of axis, position and direction that gives the sum of error and
        correction; an axis that the machine does not describe has no error.
        """

        def total(axis: str, positions: FloatArray, direction: FloatArray) -> FloatArray:
            sums = np.zeros(positions.shape)
            for way in Direction:
                here = direction == way.sign
                if not here.any():
                    continue
                if axis in self.axes:
                    sums[here] += self.error(axis, positions[here], way)
                if axis in corrections:
                    sums[here] += corrections[axis](positions[here], way)
            return sums

        return total

    def _axis(self, name: str) -> VirtualAxis:
        if name not in self.axes:
            raise UsageError(
                Fault(
                    message=f"the machine has no axis {name}",
                    expected=", ".join(self.axes),
                    found=name,
                    hint="correct the name, or add the axis to the machine file",
                )
            )
        return self.axes[name]


def _progress(plan: TestPlan) -> tuple[FloatArray, FloatArray]:
    """Return the time of each reading, (m, n) for + and for −, from 0 (first reading) to 1 (last).

    In the standard cycle (ISO 230-2:1997, figure 1) each run is a traverse up through all targets,
    then one down. In the step cycle (annex A) all approaches to one target, alternating + and -,
    come before the next target. A direction that is not measured takes no time.
    """
    target, run = np.meshgrid(np.arange(plan.targets.size), np.arange(plan.runs), indexing="ij")
    m, n = target.shape
    both = plan.directions == "both"
    if plan.cycle == "standard":
        per_run = 2 * m if both else m
        up = run * per_run + target
        down = run * per_run + (m if both else 0) + (m - 1 - target)
    else:
        each = 2 if both else 1
        up = (target * n + run) * each
        down = up + (1 if both else 0)
    last = max((2 if both else 1) * m * n - 1, 1)
    return up / last, down / last
