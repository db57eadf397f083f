"""Simulation of a circular test: exact path of two axes with known errors, and ballbar readings.

Lengths are in mm. Angles are in rad inside the module, and in deg in arguments and results. Signs
are those of the contract: deviation = measured minus commanded, lost motion > 0 lags the direction
of motion, squareness > 0 for more than 90 deg between the positive axes, lag > 0 is late. No
first-order formula is used: the two axis positions are calculated, and from them the distance from
the set-up point.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun, CircularTest, Sense

#: What is added to a commanded position: axis name, positions (n,) in machine mm, directions (n,)
#: of +1 and -1 -> (n,) mm.
CircleCorrection = Callable[[str, FloatArray, FloatArray], FloatArray]

_SAMPLES_PER_TURN: Final = 1500  # as a ballbar's software chooses its sample rate
_FEWEST, _MOST = 4, 1_000_000  # samples of a run


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleAxis:
    """The errors of one of the two axes of a circle, as functions of its commanded position
    relative to the centre.

    - ``scale``: relative, > 0 travels too far.
    - ``lost_motion`` (mm; at u > 0, at u < 0): the axis stays behind by half of it.
    - ``lag`` (s): dead time. ``gain`` (1/s): Kv of a first-order servo, None for an ideal one.
    - ``lateral_play`` (mm): the other axis is displaced by half of it, toward + while this axis
      moves toward +, and toward - while it moves toward -.
    - ``spike`` (mm): outward displacement at a reversal, which decays over ``spike_length`` (mm
      along the path).
    - ``cyclic`` (mm), ``pitch`` (mm), ``phase`` (rad): cyclic * cos(2 pi u / pitch + phase).
    - ``straightness`` k (mm): this axis displaces the other one by k (u/R)^2.
    """

    scale: float = 0.0
    lost_motion: tuple[float, float] = (0.0, 0.0)
    lag: float = 0.0
    gain: float | None = None
    lateral_play: float = 0.0
    spike: float = 0.0
    spike_length: float = 5.0
    cyclic: float = 0.0
    pitch: float = 10.0
    phase: float = 0.0
    straightness: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleErrors:
    """Errors of a simulated circle that belong to the pair of axes, the set-up or the instrument.

    - ``squareness`` beta (rad): actual first = first - beta * second.
    - ``offset`` (mm, both axes): centre of the circle relative to the set-up point.
    - ``radius_change`` (mm): added to the readings in ccw, subtracted in cw.
    - ``bar`` (mm): error of the length of the bar, added in both directions.
    - ``noise`` (mm): standard deviation of one sample, independent of the others.
    - ``correlated_noise`` (mm): standard deviation of noise of which each sample keeps the share
      ``correlation`` (0 <= rho < 1) of the sample before.
    """

    first: CircleAxis = field(default_factory=CircleAxis)
    second: CircleAxis = field(default_factory=CircleAxis)
    squareness: float = 0.0
    offset: tuple[float, float] = (0.0, 0.0)
    radius_change: float = 0.0
    bar: float = 0.0
    noise: float = 0.0
    correlated_noise: float = 0.0
    correlation: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CirclePlan:
    """The way a circle is measured: radius, feed, arc, runs.

    - ``radius`` mm, ``feed`` mm/min along the path, ``arc`` (start, extent) deg.
    - ``runs``: number of runs in each direction. ``first``: the direction of the first run.
    - ``sample_rate`` Hz; None for 1500 samples per turn.
    - ``overshoot`` deg before and after the arc.
    - ``centre`` mm, machine coordinates of both axes.
    """

    name: str = "circle"
    axes: tuple[str, str] = ("X", "Y")
    radius: float = 150.0
    feed: float = 1000.0
    arc: tuple[float, float] = (0.0, 360.0)
    runs: int = 1
    first: Sense = "ccw"
    sample_rate: float | None = None
    overshoot: float = 20.0
    centre: tuple[float, float] = (0.0, 0.0)
    calibrated: bool = True

    @property
    def samples(self) -> int:
        """The number of samples in one run on the arc, without overshoot."""
        per_turn = _SAMPLES_PER_TURN if self.sample_rate is None else self.sample_rate * self._turn
        return round(per_turn * self.arc[1] / 360.0)

    @property
    def rate(self) -> float:
        """The sample rate (1/s), chosen so that the arc has a whole number of samples."""
        return self.samples / (self._turn * self.arc[1] / 360.0)

    @property
    def _turn(self) -> float:
        """The time that one full circle takes, s."""
        return 2.0 * math.pi * self.radius / (self.feed / 60.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Traverse:
    """One run of a circle as recorded. Of the ``readings`` (n,) mm, which include the overshoot,
    those with the indices ``start`` to ``end`` belong to the arc.
    """

    run: CircularRun
    readings: FloatArray
    start: int
    end: int


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleRecording:
    """A simulated circular test with its recorded runs in the order of time, overshoot included."""

    plan: CirclePlan
    test: CircularTest
    traverses: tuple[Traverse, ...]


def record_circle(
    errors: CircleErrors,
    plan: CirclePlan,
    *,
    seed: int = 0,
    corrections: CircleCorrection | None = None,
) -> CircleRecording:
    """Return a simulated circular test with its recorded runs, alternating between ccw and cw.
    ``corrections``: what the control's tables, or errors along the axes, add to the commanded
    positions.

    Sample k of N is at the commanded angle start + (k + 1/2) extent/N in ccw, and mirrored in cw.
    The mean of the corrections at the centre over both directions is subtracted, because the set-up
    point is determined there. The noise depends on ``seed`` alone, so it is the same with any
    errors and corrections. Raises UsageError for an arc beyond 360 deg, and for a run of fewer than
    4 or more than a million samples.
    """
    _check(plan)
    senses: tuple[Sense, Sense] = ("ccw", "cw") if plan.first == "ccw" else ("cw", "ccw")
    traverses = [
        _traverse(
            errors,
            plan,
            sense,
            number,
            np.random.default_rng([seed, number, sense == "cw"]),
            corrections,
        )
        for number in range(1, plan.runs + 1)
        for sense in senses
    ]
    runs = sorted((traverse.run for traverse in traverses), key=lambda run: (run.sense, run.number))
    test = CircularTest(
        name=plan.name,
        plane="".join(plan.axes),
        axes=plan.axes,
        nominal_radius=plan.radius,
        feed=plan.feed,
        arc=(plan.arc[0] % 360.0, plan.arc[1]),
        calibrated=plan.calibrated,
        runs=tuple(runs),
        centre=plan.centre,
    )
    return CircleRecording(plan=plan, test=test, traverses=tuple(traverses))


def _check(plan: CirclePlan) -> None:
    if not (
        plan.radius > 0.0
        and plan.feed > 0.0
        and 0.0 < plan.arc[1] <= 360.0
        and _FEWEST <= plan.samples <= _MOST
    ):
        raise UsageError(
            Fault(
                message=f"the circle {plan.name} cannot be measured",
                place=plan.name,
                expected=(
                    f"radius and feed above 0, an arc up to 360 deg, {_FEWEST} to {_MOST} samples"
                    " in a run"
                ),
                found=(
                    f"radius {plan.radius:g} mm, feed {plan.feed:g} mm/min, arc {plan.arc[1]:g} deg"
                ),
                hint="correct the circle in the machine file",
            )
        )


def _traverse(
    errors: CircleErrors,
    plan: CirclePlan,
    sense: Sense,
    number: int,
    rng: np.random.Generator,
    corrections: CircleCorrection | None,
) -> Traverse:
    count, (start, extent) = plan.samples, (plan.arc[0] % 360.0, plan.arc[1])
    overshoot = round(plan.overshoot * count / extent)
    along = (np.arange(-overshoot, count + overshoot) + 0.5) * extent / count
    angles = start + along if sense == "ccw" else start + extent - along
    travelled = np.radians(along - along[0])
    exact = _radii(errors, plan, angles, sense, travelled, corrections) - plan.radius
    readings = exact + _noise(errors, exact.size, rng)
    arc = slice(overshoot, overshoot + count)
    run = CircularRun(sense=sense, angles=angles[arc], deviations=readings[arc], number=number)
    return Traverse(run=run, readings=readings, start=overshoot, end=overshoot + count - 1)


def _radii(
    errors: CircleErrors,
    plan: CirclePlan,
    angles: FloatArray,
    sense: Sense,
    travelled: FloatArray,
    corrections: CircleCorrection | None,
) -> FloatArray:
    """Return the distances (n,) mm that the ballbar shows at commanded ``angles`` (n,) deg in a run
    of direction ``sense`` (ccw or cw). ``travelled`` (n,) rad: the angle from the start of the run
    to each point.
    """
    d = 1.0 if sense == "ccw" else -1.0
    theta = np.radians(angles)
    x, x_aside = _axis(errors.first, plan, 0, _Motion(theta, d, travelled), corrections)
    y, y_aside = _axis(
        errors.second, plan, 1, _Motion(theta - 0.5 * math.pi, d, travelled), corrections
    )
    x, y = x + y_aside, y + x_aside
    x = x - errors.squareness * y
    radii: FloatArray = (
        np.hypot(x + errors.offset[0], y + errors.offset[1]) + errors.bar + d * errors.radius_change
    )
    return radii


@dataclass(frozen=True, slots=True)
class _Motion:
    """The motion R cos(``angle``) of one axis: its ``angle`` (n,) rad, its direction ``d`` (+1,
    -1), and the angle ``travelled`` (n,) rad since the start of the run.
    """

    angle: FloatArray
    d: float
    travelled: FloatArray


def _axis(
    axis: CircleAxis,
    plan: CirclePlan,
    index: int,
    motion: _Motion,
    corrections: CircleCorrection | None,
) -> tuple[FloatArray, FloatArray]:
    """Return the actual position of an axis relative to the centre, and the displacement of the
    other axis that this axis causes (such as by its straightness error), both (n,) mm.
    """
    w = plan.feed / 60.0 / plan.radius  # rad/s
    behind, shrunk = w * axis.lag, 1.0
    if (
        axis.gain is not None
    ):  # steady state of a first-order lag: 1/sqrt(1 + (w/Kv)^2), late by atan(w/Kv)
        behind, shrunk = behind + math.atan(w / axis.gain), 1.0 / math.hypot(1.0, w / axis.gain)
    angle = motion.angle - motion.d * behind
    u = plan.radius * np.cos(angle)
    direction = np.where(
        motion.d * np.sin(angle) >= 0.0, -1.0, 1.0
    )  # exactly at a reversal: the new direction
    moved = shrunk * u
    if corrections is not None:
        moved = moved + _corrected(corrections, plan.axes[index], plan.centre[index], u, direction)
    lost = np.where(u > 0.0, *axis.lost_motion)
    position = (
        moved * (1.0 + axis.scale)
        - 0.5 * lost * direction
        + _spike(axis, plan.radius, angle, motion)
    )
    position = position + axis.cyclic * np.cos(2.0 * math.pi * moved / axis.pitch + axis.phase)
    aside = 0.5 * axis.lateral_play * direction + axis.straightness * (u / plan.radius) ** 2
    return position, aside


def _spike(axis: CircleAxis, radius: float, angle: FloatArray, motion: _Motion) -> FloatArray:
    """Return the deviation (n,) mm, positive outward, of the reversal spike that decays after the
    last reversal of an axis; 0 before its first reversal. ``angle`` (n,) rad: the axis is at radius
    * cos(angle).
    """
    since = np.mod(motion.d * angle, math.pi)
    outward = np.where(np.cos(angle - motion.d * since) > 0.0, 1.0, -1.0)
    size: FloatArray = np.where(
        since <= motion.travelled, axis.spike * np.exp(-radius * since / axis.spike_length), 0.0
    )
    return outward * size


def _corrected(
    corrections: CircleCorrection,
    axis: str,
    centre: float,
    positions: FloatArray,
    direction: FloatArray,
) -> FloatArray:
    at_centre = corrections(axis, np.array([centre, centre]), np.array([1.0, -1.0]))
    corrected: FloatArray = corrections(axis, centre + positions, direction) - float(
        np.mean(at_centre)
    )
    return corrected


def _noise(errors: CircleErrors, count: int, rng: np.random.Generator) -> FloatArray:
    """Return simulated noise (count,) mm: independent noise, plus noise correlated between samples.

    The correlated noise is a first-order autoregressive process, stationary from the first sample
    on.
    """
    white, fresh = rng.standard_normal((2, count))
    rho = errors.correlation
    keep = math.sqrt(1.0 - rho * rho)
    state = float(fresh[0])
    correlated = np.empty(count)
    for index, value in enumerate(fresh):
        state = rho * state + keep * float(value) if index else state
        correlated[index] = state
    noise: FloatArray = errors.noise * white + errors.correlated_noise * correlated
    return noise
