"""What each cause moves, as displacements of the tool over a commanded circle.

Displacements, not radial deviations, because the bar measures |R u(θ) + displacement - ball|: with
the ball 0.5 mm off the centre a displacement across the radius counts too. Each column is the
displacement (x, y) in mm per unit of its parameter, in the units and signs of the contract; to
first order at the centre they are these radial deviations (d = +1 ccw, -1 cw; v path speed), whose
shapes and signs ISO 230-4:1996, annex B draws (B.2.1 scale, B.2.2 squareness, B.2.3 cyclic, B.3.1
lost motion and spikes, B.3.2 acceleration, B.3.3 unequal lag; see also Kakino, Ihara and Shinohara,
Accuracy Inspection of NC Machine Tools by Double Ball Bar Method, 1993):

    scale_mismatch D (um)     D/4 cos2θ                     squareness β (um/m)    -(βR/2) sin2θ
    servo_mismatch τ (ms)     d (vτ/2) sin2θ                radius_change ρ (um)   d ρ
    backlash_first b (um)     d (b/2) sgn(sinθ) cosθ        backlash_second -d (b/2) sgn(cosθ) sinθ
    lateral_play_first p (um) -d (p/2) |sinθ|               lateral_play_second    d (p/2) |cosθ|
    straightness_first k (um) k cos²θ sinθ                  straightness_second    k sin²θ cosθ
    reversal_spike h (um)     h exp(-arc since the axis reversed / L)
    cyclic c (um)             c cos(2πx/P + φ) cosθ, x = R cosθ; the second axis with sinθ
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
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
#: Closer to its reversal point (rad) the direction of an axis is a matter of rounding; such a
#: sample tells nothing.
_AT_REVERSAL: Final = 1e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class Samples:
    """All samples of a test. ``theta`` (n,) rad, commanded; ``sense`` (n,) +1 ccw, -1 cw;
    ``deviations`` (n,) mm; ``run`` (n,) index of the traverse. ``radius`` mm, ``speed`` mm/s,
    ``arc`` start and extent in rad. ``lag_doubt`` rad: how far a common lag, already taken off
    ``theta``, may still be wrong; 0 when none was taken off."""

    theta: FloatArray
    sense: FloatArray
    deviations: FloatArray
    run: FloatArray
    radius: float
    speed: float
    arc: tuple[float, float]
    lag_doubt: float = 0.0

    @property
    def both_senses(self) -> bool:
        """Whether the test ran in both directions."""
        return bool(np.any(self.sense > 0) and np.any(self.sense < 0))

    def reversals(self, axis: str) -> tuple[bool, bool]:
        """Return whether the arc holds the reversal points of an axis at its positive and its
        negative end.
        """
        at = (0.0, np.pi) if axis == "first" else (0.5 * np.pi, 1.5 * np.pi)
        margin = np.radians(2.0)  # so much arc on both sides shows a step
        whole = self.arc[1] >= 2.0 * np.pi - 1e-9
        inside = [
            whole or margin <= (point - self.arc[0]) % (2.0 * np.pi) <= self.arc[1] - margin
            for point in at
        ]
        return inside[0], inside[1]


@dataclass(frozen=True, slots=True)
class CauseColumn:
    """One cause: displacement ``x``, ``y`` (n,) in mm per unit, and the ``width`` beyond which no
    machine is expected.
    """

    name: str
    x: FloatArray
    y: FloatArray
    width: float


def samples_of(test: CircularTest) -> Samples:
    """Return the samples of all runs, those without a direction (exactly at a reversal point) left
    out.
    """
    theta = np.radians(np.concatenate([run.angles for run in test.runs]))
    sense = np.concatenate(
        [np.full(run.angles.size, 1.0 if run.sense == "ccw" else -1.0) for run in test.runs]
    )
    number = np.concatenate(
        [np.full(run.angles.size, float(index)) for index, run in enumerate(test.runs)]
    )
    deviations = np.concatenate([run.deviations for run in test.runs])
    clear = np.minimum(np.abs(np.sin(theta)), np.abs(np.cos(theta))) > _AT_REVERSAL
    return Samples(
        theta=theta[clear],
        sense=sense[clear],
        deviations=deviations[clear].astype(np.float64),
        run=number[clear],
        radius=test.nominal_radius,
        speed=test.feed / 60.0,
        arc=(float(np.radians(test.arc[0])), float(np.radians(test.arc[1]))),
    )


def since_reversal(samples: Samples, axis: str) -> FloatArray:
    """Return the arc, mm (n,), travelled since an axis last reversed: the first axis at 0° and
    180°, the second at 90° and 270°.
    """
    start = 0.0 if axis == "first" else 0.5 * np.pi
    arc: FloatArray = samples.radius * np.mod(samples.sense * (samples.theta - start), np.pi)
    return arc


def fixed_columns(samples: Samples) -> tuple[CauseColumn, ...]:
    """Return every column without a free shape: nuisances first (names starting with ``_``), then
    the causes.
    """
    found = [*_nuisances(samples), *_even(samples)]
    if samples.both_senses:
        cos, sin = np.cos(samples.theta), np.sin(samples.theta)
        found.append(_limited("radius_change", UM * samples.sense * cos, UM * samples.sense * sin))
    lag = 5e-4 * samples.sense * samples.speed
    found.append(
        _limited("servo_mismatch", lag * np.sin(samples.theta), lag * np.cos(samples.theta))
    )
    for axis in AXES:
        found += [*_lost_motion(samples, axis), *_lateral_play(samples, axis)]
    return tuple(found)


def _limited(name: str, x: FloatArray, y: FloatArray, most: float = 0.1) -> CauseColumn:
    """Return a column whose value stays, as far as anyone knows, below ``most`` mm of
    displacement.
    """
    largest = float(np.max(np.hypot(x, y), initial=0.0))
    return CauseColumn(name, x, y, most / max(largest, 1e-12))


def _nuisances(samples: Samples) -> Iterator[CauseColumn]:
    one, zero = np.ones_like(samples.theta), np.zeros_like(samples.theta)
    yield CauseColumn("_centre_x", one, zero, 100.0)
    yield CauseColumn("_centre_y", zero, one, 100.0)
    yield CauseColumn("_radius", np.cos(samples.theta), np.sin(samples.theta), 100.0)
    if samples.both_senses:
        # The ball creeps by tenths of a micrometre between the runs; without these that would look
        # like lost motion.
        yield CauseColumn("_shift_x", samples.sense, zero, 0.1)
        yield CauseColumn("_shift_y", zero, samples.sense, 0.1)


def _even(samples: Samples) -> Iterator[CauseColumn]:
    cos, sin, zero = np.cos(samples.theta), np.sin(samples.theta), np.zeros_like(samples.theta)
    yield _limited("scale_mismatch", 0.25 * UM * cos, -0.25 * UM * sin)
    yield _limited("squareness", -1e-6 * samples.radius * sin, zero)
    yield _limited("straightness_first", zero, UM * cos**2)
    yield _limited("straightness_second", UM * sin**2, zero)


def _lost_motion(samples: Samples, axis: str) -> Iterator[CauseColumn]:
    """Yield one column per reversal point where the arc has both, else one column.

    Each end's value holds over its half of the travel: the change falls where the axis is fastest
    and its lost motion lies across the radius, so that the deviation stays continuous.
    """
    cos, sin, zero = np.cos(samples.theta), np.sin(samples.theta), np.zeros_like(samples.theta)
    own, lag = (
        (cos, samples.sense * np.sign(sin))
        if axis == "first"
        else (sin, -samples.sense * np.sign(cos))
    )
    parts = (
        {"_at_positive": own > 0.0, "_at_negative": own < 0.0}
        if all(samples.reversals(axis))
        else {"": own == own}
    )
    for suffix, half in parts.items():
        moved = 0.5 * UM * lag * half
        yield _limited(
            f"backlash_{axis}{suffix}", *((moved, zero) if axis == "first" else (zero, moved))
        )


def _lateral_play(samples: Samples, axis: str) -> Iterator[CauseColumn]:
    """Yield the mean play and, where both reversal points are seen, how it changes along the axis
    (a nuisance).
    """
    cos, sin, zero = np.cos(samples.theta), np.sin(samples.theta), np.zeros_like(samples.theta)
    if axis == "first":
        side, along = -0.5 * UM * samples.sense * np.sign(sin), cos
    else:
        side, along = 0.5 * UM * samples.sense * np.sign(cos), sin
    yield _limited(f"lateral_play_{axis}", *((zero, side) if axis == "first" else (side, zero)))
    if samples.both_senses and all(samples.reversals(axis)):
        changing = side * along
        yield _limited(
            f"_lateral_change_{axis}", *((zero, changing) if axis == "first" else (changing, zero))
        )


def spike_columns(
    samples: Samples, axis: str, length: float, height: float
) -> tuple[CauseColumn, CauseColumn]:
    """Return the spike of an axis (ISO 230-4:1996, B.3.1) with decay ``length`` mm, h exp(-arc /
    length) outward, and its change per unit of log length at ``height`` µm, h (arc / length)
    exp(-arc / length).
    """
    arc = since_reversal(samples, axis)
    zero = np.zeros_like(arc)
    # At a reversal the axis stands across its own motion: outward is the side of the travel on
    # which it stands.
    start = 0.0 if axis == "first" else 0.5 * np.pi
    turns = np.floor(samples.sense * (samples.theta - start) / np.pi)
    outward = np.where(np.mod(turns, 2.0) == 0.0, 1.0, -1.0)
    shape = UM * outward * np.exp(-arc / length)
    slope = height * shape * arc / length
    if axis == "first":
        return _limited("reversal_spike_first", shape, zero), CauseColumn(
            "_length_first", slope, zero, 1.0
        )
    return _limited("reversal_spike_second", zero, shape), CauseColumn(
        "_length_second", zero, slope, 1.0
    )


def lag_column(samples: Samples, known: Mapping[str, float]) -> CauseColumn:
    """Return what one ``lag_doubt`` of angle does, mm: the slope of the smooth causes as they are
    ``known``, against the motion (the derivatives by θ of the module's table; ISO 230-4:1996, annex
    B). A sagging axis counts by its third harmonic: k cos²θ sinθ = k/4 (sinθ + sin3θ), and the
    first belongs to the centre.
    """
    double, triple = 2.0 * samples.theta, 3.0 * samples.theta
    slope = (
        -0.5 * UM * known.get("scale_mismatch", 0.0) * np.sin(double)
        - 1e-6 * samples.radius * known.get("squareness", 0.0) * np.cos(double)
        + 0.75 * UM * known.get("straightness_first", 0.0) * np.cos(triple)
        + 0.75 * UM * known.get("straightness_second", 0.0) * np.sin(triple)
    )
    moved = -samples.lag_doubt * samples.sense * slope
    return CauseColumn("_lag", moved * np.cos(samples.theta), moved * np.sin(samples.theta), 1.0)


def cyclic_columns(
    samples: Samples, axis: str, frequency: float, amplitudes: tuple[float, float]
) -> tuple[CauseColumn, ...]:
    """Return cosine and sine of a cyclic error (ISO 230-4:1996, B.2.3) of ``frequency`` 1/mm along
    an axis, and the change per 1/mm of it at ``amplitudes`` (a, b) µm: a cos(2πfx) - b sin(2πfx).
    """
    zero = np.zeros_like(samples.theta)
    along = samples.radius * (np.cos(samples.theta) if axis == "first" else np.sin(samples.theta))
    phase = 2.0 * np.pi * frequency * along
    cosine, sine = UM * np.cos(phase), -UM * np.sin(phase)
    slope = 2.0 * np.pi * along * (amplitudes[0] * sine - amplitudes[1] * cosine)
    # A frequency off by the inverse of the travel would be another peak of the search.
    named = (
        (f"_cyclic_cos_{axis}", cosine, 0.1 / UM),
        (f"_cyclic_sin_{axis}", sine, 0.1 / UM),
        (f"_frequency_{axis}", slope, 0.5 / samples.radius),
    )
    return tuple(
        CauseColumn(name, *((field, zero) if axis == "first" else (zero, field)), width)
        for name, field, width in named
    )
