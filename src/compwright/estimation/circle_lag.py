"""The delay with which both axes reverse, from the angles at which lost motion and spikes begin.

The angles of a test are commanded angles. Axes that follow their commands with a delay T reverse at
the angle v T / R after the commanded reversal point. With a position loop of Kv = 16.7/s, at 2 000
mm/min on R = 150 mm, this is 0.8°. If steps are fitted at the wrong angle, lost motion and spikes
are wrong. Half of the remaining scale and squareness then looks like a lag difference.

To first order, a lag common to both axes changes nothing else. It is therefore found here, and the
angles are corrected by it. Lag and circle: ISO 230-4:1996, B.3.2 and B.3.3. The angle at which the
path has a step is the one with the least sum of squares (Seber and Wild, Nonlinear Regression,
1989, chapter 9).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_model import SOFTEST_LOOP, CircleSamples
from compwright.records.axis import FloatArray

#: Samples on either side of a reversal point that are looked at, beyond the largest lag.
_NEIGHBOURS: Final = 14
#: Decay lengths of the spikes tried, as shares of the radius; two of them imitate those between.
_DECAYS: Final = (0.012, 0.045)
_STEPS_PER_SAMPLE: Final = 5
#: Weighted squares that an angle must save against no lag at all, and within which angles count as
#: equally good.
_CLEAR: Final = 40.0
_EQUAL: Final = 9.0
#: Deviations, mm, below which the shape of a parabola is not asked for more.
_FLOOR: Final = 2e-5


@dataclass(frozen=True, slots=True)
class Lag:
    """The common delay of both axes at reversals: ``angle``, rad, and its standard uncertainty
    ``doubt``, rad.
    """

    angle: float
    doubt: float


def common_lag(samples: CircleSamples) -> Lag | None:
    """Return the common delay of both axes, rad, or None if the samples near the reversal points do
    not clearly show a delay.

    The delay is the middle of the angles that fit equally well. Angles fit equally well if their
    weighted sums of squares exceed the least one by at most 9 (three standard errors; Seber and
    Wild 1989, chapter 9).
    """
    spacing, windows, angles, none = _profile(samples)
    if not len(windows):
        return None
    squares, freedom = _squares(windows, angles)
    best = float(angles[np.argmin(squares)])
    near: FloatArray = best + np.linspace(-spacing, spacing, 2 * _STEPS_PER_SAMPLE + 1)
    found, freedom = _squares(windows, near)
    unit = max(float(np.min(found)) / freedom, _FLOOR**2)
    if (float(squares[none]) - float(np.min(found))) / unit < _CLEAR:
        return None
    equal = near[found <= np.min(found) + _EQUAL * unit]
    # Samples fall at steps: between two of them every angle is as good.
    low, high = float(equal[0]), float(equal[-1])
    half = max(0.5 * (high - low), 0.5 * spacing / _STEPS_PER_SAMPLE)
    return Lag(0.5 * (low + high), half / np.sqrt(3.0))  # JCGM 100:2008, eq. 7


def at_actual_angles(samples: CircleSamples, lag: Lag) -> CircleSamples:
    """Return the samples at the actual angles of the axes instead of the commanded angles. The
    actual angles lag the commanded ones by ``lag.angle`` in the direction of the run.
    """
    return replace(
        samples,
        theta=samples.theta - samples.sense * lag.angle,
        lag=lag.angle,
        lag_std=lag.doubt,
    )


def with_undetected_lag(samples: CircleSamples) -> CircleSamples:
    """Return the samples with an uncertainty of the delay, ``lag_std``, for a delay that is too
    small to be found.

    The delay is assumed to be uniformly distributed up to a largest angle (JCGM 100:2008, eq. 7).
    This is the largest angle that fits the samples near the reversal points as well as zero, plus
    half the angle between samples. ``lag_std`` is at least half the angle between samples, because
    a step cannot be located within it.
    """
    spacing, windows, angles, none = _profile(samples)
    if not len(windows):
        return replace(samples, lag_std=0.5 * spacing)
    squares, freedom = _squares(windows, angles)
    unit = max(float(np.min(squares)) / freedom, _FLOOR**2)
    equal = angles[squares <= squares[none] + _EQUAL * unit]
    most = max(float(equal[-1]), 0.0) + 0.5 * spacing
    # Uniform up to that: its standard deviation about zero (JCGM 100:2008, eq. 7).
    return replace(samples, lag_std=max(most / np.sqrt(3.0), 0.5 * spacing))


def shrink_uncertainty(samples: CircleSamples) -> float:
    """Return the standard uncertainty, mm, of the radius from an unknown equal lag of both axes.

    The acceleration makes the circle smaller (ISO 230-4:1996, B.3.2). With the softest usual
    position loop Kv, the radius shrinks by at most a = v² / (2 Kv² R). The shrinkage is assumed to
    be uniform over the range ±a, which gives a / sqrt(3) (JCGM 100:2008, eq. 7).
    """
    most = samples.speed**2 / (2.0 * SOFTEST_LOOP**2 * samples.radius)
    return float(most / np.sqrt(3.0))


def _profile(samples: CircleSamples) -> tuple[float, FloatArray, FloatArray, int]:
    """Return the samples near the reversal points, and the reversal angles to try, from which a
    delay of the axes is estimated.

    The four results are the angle between samples, rad; the windows of samples at the reversal
    points (`_windows`); the angles (a,) to try, rad; and the index of the angle zero.
    """
    per_run = samples.theta.size / np.unique(samples.run).size
    spacing = samples.arc[1] / per_run
    most = samples.speed / (SOFTEST_LOOP * samples.radius) * 1.3 + spacing
    count = int(np.ceil(most / spacing))
    windows = _windows(samples, _NEIGHBOURS + count)
    return spacing, windows, np.arange(-count, count + 1, dtype=np.float64) * spacing, count


def _windows(samples: CircleSamples, half: int) -> FloatArray:
    """Return the samples in a window at each reversal point of each run, (w, 2, 2 half): a row of
    angles from the reversal point, rad, and a row of deviations, mm.
    """
    found = []
    for number in np.unique(samples.run):
        mine = np.flatnonzero(samples.run == number)
        sense = float(samples.sense[mine[0]])
        for point in np.arange(4) * 0.5 * np.pi:
            travelled = np.mod(sense * (samples.theta[mine] - point) + np.pi, 2.0 * np.pi) - np.pi
            order = np.argsort(travelled)
            middle = int(np.searchsorted(travelled[order], 0.0))
            near = order[max(middle - half, 0) : middle + half]
            reach = np.ptp(travelled[near]) if near.size else np.inf
            # At the ends of a run or an arc neighbours are not neighbours in time.
            if near.size == 2 * half and reach < np.pi / 4 and np.ptp(near) < 2 * half:
                found.append(np.vstack([travelled[near], samples.deviations[mine[near]]]))
    return np.array(found)


def _squares(windows: FloatArray, angles: FloatArray) -> tuple[FloatArray, float]:
    """Return the residual sum of squares (a,) for each assumed angle of the reversal, and the
    degrees of freedom of this sum.

    The model of each window is a parabola. From the assumed reversal on, a step, a bend and two
    decays are added.
    """
    travelled, values = windows[:, 0, :], windows[:, 1, :]
    size = float(np.max(np.abs(travelled)))
    late = travelled[np.newaxis] - angles[:, np.newaxis, np.newaxis]
    after = late > 0.0
    smooth = np.broadcast_to(
        np.stack([np.ones_like(travelled), travelled / size, (travelled / size) ** 2], axis=-1),
        (*late.shape, 3),
    )
    sudden = [
        after,
        after * late / size,
        *(after * np.exp(-np.maximum(late, 0.0) / decay) for decay in _DECAYS),
    ]
    rows = np.concatenate([smooth, np.stack(sudden, axis=-1)], axis=-1)
    normal = np.swapaxes(rows, -1, -2) @ rows
    right = np.einsum("awsk,ws->awk", rows, values)
    normal = normal + 1e-9 * np.eye(rows.shape[-1])
    solved = np.linalg.solve(normal, right[..., np.newaxis])[..., 0]
    left = values[np.newaxis] - np.einsum("awsk,awk->aws", rows, solved)
    return np.sum(left**2, axis=(1, 2)), float(values.size - values.shape[0] * rows.shape[-1])
