"""The tool displacement that each cause of circular deviations produces along the commanded circle.

The model contains displacements instead of radial deviations, because the bar measures |R u(θ) +
displacement - ball|. If the ball is 0.5 mm off the centre, a displacement across the radius changes
the distance too. Each column is the displacement (x, y) in mm per unit of its parameter. Units and
signs are those of the output.

To first order, with the ball at the centre, the displacements are the radial deviations of the
table. In the table, d is +1 for ccw and -1 for cw, and v is the path speed. Shapes and signs are
drawn in ISO 230-4:1996, annex B: B.2.1 scale, B.2.2 squareness, B.2.3 cyclic, B.3.1 lost motion and
spikes, B.3.2 acceleration, B.3.3 unequal lag. See also Kakino, Ihara and Shinohara, Accuracy
Inspection of NC Machine Tools by Double Ball Bar Method, 1993.

    scale_mismatch D (um)     D/4 cos2θ                     squareness β (um/m)    -(βR/2) sin2θ
    servo_mismatch τ (ms)     d (vτ/2) sin2θ                radius_change ρ (um)   d ρ
    backlash_first b (um)     d (b/2) sgn(sinθ) cosθ        backlash_second -d (b/2) sgn(cosθ) sinθ
    lateral_play_first p (um) -d (p/2) |sinθ|               lateral_play_second    d (p/2) |cosθ|
    straightness_first k (um) k cos²θ sinθ                  straightness_second    k sin²θ cosθ
    reversal_spike h (um)     h exp(-arc since the axis reversed / L)
    cyclic c (um)             c cos(2πx/P + φ) cosθ, x = R cosθ; the second axis with sinθ
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularTest

AXES: Final = ("first", "second")
UM: Final = 1.0 / MICROMETRES_PER_MILLIMETRE
#: The softest usual position loop, 1/s (1 m/min per mm).
SOFTEST_LOOP: Final = 1000.0 / 60.0
ENDS: Final = ("positive", "negative")
#: Standard deviation of the prior of a scale mismatch, um/m.
PRIOR_SCALE: Final = 100.0
#: Standard deviations of the priors: what machine tools in use have, in the unit of the cause (um,
#: um/m for squareness, ms for servo mismatch; mm for the set-up). A value that its prior
#: determines more than its data is not given (`circle_report`).
PRIORS: Final = {
    "squareness": 100.0,
    "servo_mismatch": 1.0,
    "backlash": 20.0,
    "lateral_play": 10.0,
    "straightness": 10.0,
    "_s_shape": 4.0,
    "master_slave": 3.0,
    "_changeover_after": 1.0,
    "_changeover_before": 1.0,
    "_changeover_late": 1.0,
    "spiral": 30.0,
    "offset_change": 3.0,
    "radius_change": 3.0,
    "_centre_x": 100.0,
    "_centre_y": 100.0,
    "_radius": 100.0,
    "_spiral_change": 1.0,
    "_lost_profile": 2.0,
    "_lost_change": 1.0,
    "_lateral_change": 3.0,
    "_spike": 10.0,
    "_cyclic": 10.0,
    "_smooth": 0.03,
}
#: Orders, per revolution, of smooth deviations that no cause explains (lobes, errors of the
#: instrument). Each is as large as the rounding of a usual ballbar, 0.1 um / sqrt(12). On an arc
#: this changes squareness by up to a hundred um/m.
_SMOOTH: Final = (4, 5, 6)
#: Prior probability of causes and nuisances that most machines do not have (`rare_cause`).
RARE: Final = {
    "spiral": 0.4,
    "_spiral_change": 0.1,
    "master_slave": 0.1,
    "_changeover_after": 0.1,
    "_changeover_before": 0.1,
    "_changeover_late": 0.1,
    "_s_shape": 0.3,
    "_lost_profile_first": 0.3,
    "_lost_profile_second": 0.3,
    "_lateral_change_first": 0.3,
    "_lateral_change_second": 0.3,
}
#: Widths of the prior of a spiral, equally probable, as shares of that in `PRIORS`: most machines
#: drift by a few um during a run, with a cold spindle or a loose ball by far more. The narrow one
#: alone would take the rest for lost motion where a run begins at a reversal point.
_SPIRALS: Final = (0.1, 1.0)
#: Causes that displace the tool by a constant along a quarter of the circle.
_DISPLACED: Final = ("_centre", "offset_change", "backlash", "lateral_play")
#: Least and longest time, s, that a changeover of master and slave axis may take, if it is no step,
#: and how many times are tried.
_CHANGEOVER: Final = (0.005, 0.08)
_TRIED: Final = 5
#: How slow instrument and drive may be, s.
RESPONSE: Final = 0.003
#: Closer to its reversal point (rad) the direction of an axis is a matter of rounding; such a
#: sample tells nothing.
_AT_REVERSAL: Final = 1e-6
#: Arc, rad, on both sides of a reversal point that shows a step.
REVERSAL_MARGIN: Final = np.radians(2.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleSamples:
    """All samples of a circular test, in mm and rad.

    ``theta`` (n,): commanded angle, rad. ``sense`` (n,): +1 ccw, -1 cw. ``deviations`` (n,): mm.
    ``run`` (n,): index of the traverse. ``radius``: nominal radius, mm. ``speed``: path speed,
    mm/s. ``arc``: start and extent, rad. ``lag``: common lag of the axes, rad, that is already
    subtracted from ``theta``; 0 if none was found. ``lag_std``: standard uncertainty of the lag,
    rad. ``averaged``: neighbouring readings of which each sample is the mean.
    """

    theta: FloatArray
    sense: FloatArray
    deviations: FloatArray
    run: FloatArray
    radius: float
    speed: float
    arc: tuple[float, float]
    lag: float = 0.0
    lag_std: float = 0.0
    averaged: int = 1

    @property
    def commanded(self) -> FloatArray:
        """The commanded angles (n,), rad, before the ``lag`` was subtracted."""
        angles: FloatArray = self.theta + self.sense * self.lag
        return angles

    @property
    def both_senses(self) -> bool:
        """Whether the test ran in both directions."""
        return bool(np.any(self.sense > 0) and np.any(self.sense < 0))

    @property
    def full_circle(self) -> bool:
        """Whether the runs are closed circles."""
        return self.arc[1] >= 2.0 * np.pi - 1e-9

    def reversals(self, axis: str) -> tuple[bool, bool]:
        """Return whether the arc contains the reversal points of an axis at its positive and its
        negative end.
        """
        at = (0.0, np.pi) if axis == "first" else (0.5 * np.pi, 1.5 * np.pi)
        inside = [
            self.full_circle
            or REVERSAL_MARGIN
            <= (point - self.arc[0]) % (2.0 * np.pi)
            <= self.arc[1] - REVERSAL_MARGIN
            for point in at
        ]
        return inside[0], inside[1]

    def only_end(self, axis: str) -> float | None:
        """Return the end of an axis, +1 or -1, whose reversal point the arc contains; None if it
        contains both or none.
        """
        positive, negative = self.reversals(axis)
        return None if positive == negative else float(positive) - float(negative)


@dataclass(frozen=True, slots=True)
class CauseColumn:
    """One cause of deviations: displacement ``x``, ``y`` (n,) of the tool, mm per unit of the
    cause. ``width`` is the prior standard deviation of its size.
    """

    name: str
    x: FloatArray
    y: FloatArray
    width: float


def circle_samples(test: CircularTest) -> CircleSamples:
    """Return the samples of all runs. Samples exactly at a reversal point are left out, because
    their direction of motion is undefined.
    """
    theta = np.radians(np.concatenate([run.angles for run in test.runs]))
    sizes = [run.angles.size for run in test.runs]
    sense = np.repeat([1.0 if run.sense == "ccw" else -1.0 for run in test.runs], sizes)
    number = np.repeat(np.arange(float(len(sizes))), sizes)
    deviations = np.concatenate([run.deviations for run in test.runs])
    clear = np.minimum(np.abs(np.sin(theta)), np.abs(np.cos(theta))) > _AT_REVERSAL
    return CircleSamples(
        theta=theta[clear],
        sense=sense[clear],
        deviations=deviations[clear].astype(np.float64),
        run=number[clear],
        radius=test.nominal_radius,
        speed=test.feed / 60.0,
        arc=(float(np.radians(test.arc[0])), float(np.radians(test.arc[1]))),
    )


def since_reversal(samples: CircleSamples, axis: str) -> FloatArray:
    """Return the length of arc (n,) mm travelled since an axis last reversed.

    The first axis reverses at 0° and 180°, the second at 90° and 270°.
    """
    start = 0.0 if axis == "first" else 0.5 * np.pi
    arc: FloatArray = samples.radius * np.mod(samples.sense * (samples.theta - start), np.pi)
    return arc


def fixed_columns(samples: CircleSamples) -> tuple[CauseColumn, ...]:
    """Return the columns, with prior widths, of all causes whose curve is completely known. A
    cyclic error is not one of them, because its frequency has to be searched.

    Auxiliary unknowns have names starting with ``_``.
    """
    return tuple(
        CauseColumn(name, x, y, prior_width(name, samples.radius))
        for name, x, y in (
            *_set_up(samples),
            *_even(samples),
            *_odd(samples),
            *(column for axis in AXES for column in _lost_motion(samples, axis)),
            *(column for axis in AXES for column in _lateral_play(samples, axis)),
        )
    )


def rare_cause(name: str, samples: CircleSamples) -> tuple[str | None, float]:
    """Return the cause in `RARE` of which a model column is one shape, or None if the column is in
    every model, and the prior probability of this cause.

    A spiral is always there on a full circle in one direction. From the end of a run to its start
    the radius jumps. Where the start is a reversal point, this jump has the shape of lost motion.
    Only the ramp distinguishes them, which in one direction other causes can hide. Without the
    spiral in the model, all of it is lost motion.
    """
    cause = name.partition("@")[0]
    if cause not in RARE:
        return None, 1.0
    always = cause == "spiral" and samples.full_circle and not samples.both_senses
    return cause, 1.0 if always else RARE[cause]


_Named = tuple[str, FloatArray, FloatArray]


def prior_width(name: str, radius: float) -> float:
    """Return the standard deviation (`PRIORS`) of the size of a cause on typical machines. The
    scale mismatch is 100 um/m over the diameter 2 ``radius`` (mm). "@0.1": a tenth of it.
    """
    if name == "scale_mismatch":
        return 2.0 * radius * PRIOR_SCALE * UM
    kind, _, times = name.partition("#")[0].partition("@")
    kind = kind.removesuffix("_at_positive").removesuffix("_at_negative")
    return float(times or 1) * PRIORS[kind.removesuffix("_first").removesuffix("_second")]


def _set_up(samples: CircleSamples) -> Iterator[_Named]:
    cos, sin = np.cos(samples.theta), np.sin(samples.theta)
    one, zero = np.ones_like(samples.theta), np.zeros_like(samples.theta)
    yield "_centre_x", one, zero
    yield "_centre_y", zero, one
    yield "_radius", cos, sin
    progress = UM * travelled_share(samples)
    for width in _SPIRALS:
        yield f"spiral@{width}", progress * cos, progress * sin
    if samples.both_senses:
        half = 0.5 * UM * samples.sense
        yield "offset_change_first", half, zero
        yield "offset_change_second", zero, half
        yield "radius_change", UM * samples.sense * cos, UM * samples.sense * sin
        yield "_spiral_change", samples.sense * progress * cos, samples.sense * progress * sin


def sample_spacing(samples: CircleSamples) -> float:
    """Return the length of arc between neighbouring samples of a run, mm."""
    runs = np.unique(samples.run).size
    return float(samples.radius * samples.arc[1] * runs / samples.theta.size)


def travelled_share(samples: CircleSamples) -> FloatArray:
    """Return the completed share of the run at each sample, minus a half (n,): -0.5 to 0.5."""
    share = np.empty_like(samples.theta)
    for number in np.unique(samples.run):
        mine = samples.run == number
        theta = samples.sense[mine] * samples.theta[mine]
        share[mine] = (theta - 0.5 * (theta.min() + theta.max())) / samples.arc[1]
    return share


def _even(samples: CircleSamples) -> Iterator[_Named]:
    cos, sin, zero = np.cos(samples.theta), np.sin(samples.theta), np.zeros_like(samples.theta)
    yield "scale_mismatch", 0.25 * UM * cos, -0.25 * UM * sin
    yield "squareness", -1e-6 * samples.radius * sin, zero
    yield "straightness_first", zero, UM * cos**2
    yield "straightness_second", UM * sin**2, zero
    yield "_s_shape", zero, UM * (2.0 * cos**3 - cos)
    for order in () if samples.full_circle else _SMOOTH:
        for part, wave in ("cos", np.cos), ("sin", np.sin):
            size = UM * wave(order * samples.theta)
            yield f"_smooth#{order}{part}", size * cos, size * sin
    changeover = 0.5 * UM * np.sign(np.cos(2.0 * samples.commanded))
    yield "master_slave", changeover * cos, changeover * sin


def changeover_columns(samples: CircleSamples) -> list[CauseColumn]:
    """Return model columns, um, of a change of the radius that takes a time, where the faster axis
    changes: at the commanded angle of 45° and every 90° from there.

    ``master_slave@``: a change by 1 um, as a first-order response or as a ramp from the point on,
    for each time that is tried. ``_changeover_*@``: what dies out in that time before or after the
    point, or is largest that time after it. They make other responses of it.
    """
    spacing = sample_spacing(samples) / samples.speed
    times = np.geomspace(max(_CHANGEOVER[0], 0.7 * spacing), max(_CHANGEOVER[1], spacing), _TRIED)
    turned = samples.sense * (samples.commanded - 0.25 * np.pi) + 0.25 * np.pi
    since = (np.mod(turned, 0.5 * np.pi) - 0.25 * np.pi) * samples.radius / samples.speed
    into = samples.sense * (2.0 * np.mod(np.floor(turned / (0.5 * np.pi)), 2.0) - 1.0)
    share = since / times[:, np.newaxis]
    after = np.where(share >= 0.0, np.exp(-np.maximum(share, 0.0)), 0.0)
    first_order = np.where(share >= 0.0, 0.5, -0.5) - after
    ramps = np.clip(share, 0.0, 1.0) - 0.5
    named = {
        "master_slave": np.concatenate([first_order, ramps]),
        "_changeover_before": np.where(share < 0.0, np.exp(np.minimum(share, 0.0)), 0.0),
        "_changeover_after": after,
        "_changeover_late": np.e * share * after,
    }
    cos, sin = UM * into * np.cos(samples.theta), UM * into * np.sin(samples.theta)
    return [
        CauseColumn(f"{name}@{index}", shape * cos, shape * sin, PRIORS[name])
        for name, shapes in named.items()
        for index, shape in enumerate(shapes, 1)
    ]


def _odd(samples: CircleSamples) -> Iterator[_Named]:
    lag = 5e-4 * samples.sense * samples.speed
    yield "servo_mismatch", lag * np.sin(samples.theta), lag * np.cos(samples.theta)


def _lost_motion(samples: CircleSamples, axis: str) -> Iterator[_Named]:
    """Yield a model column for the lost motion at each reversal point, or only one column if the
    arc does not contain both reversal points.

    The lost motion at each end applies to the half of the travel on its side. The deviation thus
    stays continuous where the axis is fastest. An additional unknown allows lost motion to change
    in proportion to the position. If the arc does not contain both reversal points, a further
    unknown is half the difference of the lost motion at the two ends. It changes in proportion to
    the position too.
    """
    cos, sin, zero = np.cos(samples.theta), np.sin(samples.theta), np.zeros_like(samples.theta)
    own, lag = (
        (cos, samples.sense * np.sign(sin))
        if axis == "first"
        else (sin, -samples.sense * np.sign(cos))
    )
    whole = all(samples.reversals(axis))
    parts = {"_at_positive": own > 0.0, "_at_negative": own < 0.0} if whole else {"": own == own}
    for suffix, half in parts.items():
        moved = 0.5 * UM * lag * half
        yield f"backlash_{axis}{suffix}", *((moved, zero) if axis == "first" else (zero, moved))
    changes = {}
    if not whole:
        changes["change"] = own - (samples.only_end(axis) or 0.0)
    if samples.full_circle or (samples.both_senses and any(samples.reversals(axis))):
        changes["profile"] = own - np.sign(own)
    for name, change in changes.items():
        moved = 0.5 * UM * lag * change
        yield f"_lost_{name}_{axis}", *((moved, zero) if axis == "first" else (zero, moved))


def _lateral_play(samples: CircleSamples, axis: str) -> Iterator[_Named]:
    """Yield a model column for the mean lateral play of an axis and, if the test has both
    directions and both reversal points, another column for the change of the play along the axis.
    """
    cos, sin, zero = np.cos(samples.theta), np.sin(samples.theta), np.zeros_like(samples.theta)
    if axis == "first":
        side, along = -0.5 * UM * samples.sense * np.sign(sin), cos
    else:
        side, along = 0.5 * UM * samples.sense * np.sign(cos), sin
    yield f"lateral_play_{axis}", *((zero, side) if axis == "first" else (side, zero))
    if samples.both_senses and all(samples.reversals(axis)):
        change = side * along
        yield f"_lateral_change_{axis}", *((zero, change) if axis == "first" else (change, zero))


@dataclass(frozen=True, slots=True)
class SpikeShape:
    """A reversal spike that decays over ``length`` mm of arc. It starts at its peak, or is
    ``rising`` to a peak of 1 at that length.

    With s = arc / length, the spike is exp(-s); a rising spike is s exp(1 - s).
    """

    length: float
    rising: bool

    def __call__(self, arc: FloatArray) -> FloatArray:
        """Return the deviation of the spike after ``arc`` mm (n,) from the reversal."""
        share = arc / self.length
        shape: FloatArray = share * np.exp(1.0 - share) if self.rising else np.exp(-share)
        return shape


@dataclass(frozen=True, slots=True)
class TakeUp:
    """Lost motion that an axis takes up gradually over ``length`` mm of arc after a reversal, as a
    share of the lost motion at the reversal.

    The axis stands still until its command has moved by the lost motion. After a reversal the
    command moves by arc² / 2R.
    """

    length: float

    def __call__(self, arc: FloatArray) -> FloatArray:
        """Return the share of lost motion that remains ``arc`` mm (n,) after the reversal."""
        left: FloatArray = np.maximum(1.0 - (arc / self.length) ** 2, 0.0)
        return left


def spike_curves(
    samples: CircleSamples, axis: str, end: str, shapes: Sequence[SpikeShape | TakeUp]
) -> FloatArray:
    """Return the displacement along an axis, mm (m, n), of m ``shapes``: an outward spike of 1 um
    in both directions after the reversals of this axis at one ``end`` (ISO 230-4:1996, B.3.1).
    """
    arc = since_reversal(samples, axis)
    start = 0.0 if axis == "first" else 0.5 * np.pi
    turns = np.floor(samples.sense * (samples.theta - start) / np.pi)
    side = 0.0 if end == "positive" else 1.0
    after = np.flatnonzero(np.mod(turns, 2.0) == side)
    moved = np.zeros((len(shapes), arc.size))
    moved[:, after] = UM * (1.0 - 2.0 * side) * np.array([shape(arc[after]) for shape in shapes])
    return moved


def lag_column(
    samples: CircleSamples, fixed: Iterable[CauseColumn], known: Mapping[str, float]
) -> CauseColumn:
    """Return the effect (n,), mm, that an uncertainty ``lag_std`` of the delay has on the
    deviations. ``known``: sizes of the causes with the columns ``fixed`` from a first fit, by name.

    The effect is the slope of the ``known`` causes along the motion (derivatives by θ of the table
    in the module docstring; ISO 230-4:1996, annex B). The part that shifts the centre is left out.
    Of straightness, k cos²θ sinθ = k/4 (sinθ + sin3θ), only the third harmonic counts, because the
    first harmonic is an offset of the centre. Straightness of third order has a fourth harmonic. A
    servo mismatch τ, large at a high feed, changes the scale mismatch by 4 v τ per radian. Under
    centre, lost motion and lateral play the tool is displaced by the same (x, y) along a quarter of
    the circle, so that the slope is y cosθ - x sinθ.
    """
    cos, sin = np.cos(samples.theta), np.sin(samples.theta)
    double, triple = 2.0 * samples.theta, 3.0 * samples.theta
    slope = (
        -0.5 * UM * known.get("scale_mismatch", 0.0) * np.sin(double)
        - 1e-6 * samples.radius * known.get("squareness", 0.0) * np.cos(double)
        + 0.75 * UM * known.get("straightness_first", 0.0) * np.cos(triple)
        + 0.75 * UM * known.get("straightness_second", 0.0) * np.sin(triple)
        + UM * known.get("_s_shape", 0.0) * np.cos(4.0 * samples.theta)
        + samples.sense * (UM * samples.speed * known.get("servo_mismatch", 0.0)) * np.cos(double)
    )
    for column in fixed:
        if column.name.startswith(_DISPLACED):
            slope = slope + known.get(column.name, 0.0) * (column.y * cos - column.x * sin)
    moved = -samples.lag_std * samples.sense * slope
    return CauseColumn("_lag", moved * cos, moved * sin, 1.0)
