"""The delay with which both axes reverse, from the angles at which lost motion and spikes begin.

The angles of a test are commanded angles. Axes that follow their commands with a delay T reverse at
the angle v T / R after the commanded reversal point. With a position loop of Kv = 16.7/s, at 2 000
mm/min on R = 150 mm, this is 0.8°. If steps are fitted at the wrong angle, lost motion and spikes
are wrong. Half of the remaining scale and squareness then looks like a lag difference.

To first order, a lag common to both axes changes nothing else. It is therefore found here, and the
angles are corrected by it. Lag and circle: ISO 230-4:1996, B.3.2 and B.3.3.

A late step may also be lost motion that the axis takes up while it moves on. Both are hypotheses.
For each angle of the reversal, the readings near a reversal point are compared with a family of
shapes: a sudden step, a take-up over each of several lengths, and spikes with rise and decay. The
sizes are integrated out under normal priors. The probability of an angle is the average over the
shapes (Bayesian model averaging: Hoeting, Madigan, Raftery and Volinsky, Statistical Science 14,
1999). Mean and standard deviation of this distribution are the lag and its standard uncertainty.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_model import RESPONSE, SOFTEST_LOOP, UM, CircleSamples
from compwright.estimation.circle_noise import IndexArray
from compwright.records.axis import FloatArray

#: What is looked at before and after the angles of the reversal: samples, at least, and rad after.
_NEIGHBOURS: Final = 14
_BEFORE: Final = 20
_AFTER: Final = 0.04
#: Samples that a search spans at most; finer ones are averaged first.
_MOST_SPAN: Final = 24
_MOST_WINDOW: Final = 80
#: Most lag that is looked for, and standard deviation of its prior, by that of the softest loop.
_MOST: Final = 2.0
_USUAL: Final = 0.75
#: Prior standard deviations, mm: pairs of decays and take-ups; of single decays two, equally
#: probable.
_SIZE: Final = 4.0 * UM
_SINGLE: Final = np.array([0.5, 4.0]) * UM
#: Prior probabilities of no decay, one, and two: the second, a rise, is half as probable. On 24
#: generated circles thirds instead moved the lag by at most 0.2 of its uncertainty.
_SPIKES: Final = np.log([0.4, 0.4, 0.2])
#: Number of decays, the longest by the radius, the shortest in samples.
_DECAYS: Final = 5
_LONGEST: Final = 0.1
_SHORTEST: Final = 0.5
#: Travel after the reversal, um, over which lost motion is taken up: ball guides roll freely after
#: some 100 um (Futami, Furutani and Yoshida, Nanotechnology 1, 1990). Number of lengths, and the
#: shortest in samples.
_TAKEN: Final = (0.3, 200.0)
_LENGTHS: Final = 12
_SEEN: Final = 0.6
#: Prior probability of a take-up: nothing is known for or against it. From 0.25 to 0.75 the lag
#: moves by at most 0.4 of its uncertainty.
_GRADUAL: Final = 0.5
#: Prior probability that one reversal point of an axis differs from the others, which have the same
#: guide and drive. From 0.05 to 0.2 the lag moves by at most 0.04 of its uncertainty.
_DIFFERENT: Final = 0.1
#: An axis that stands still deviates by its travel, with this relative standard deviation: its
#: elastic share is unknown. From 0.05 to 0.2 the lag moves by at most 0.01 of its uncertainty.
_STANDING: Final = 0.1
#: The share (s / length)² of a gradual slip, by that of a take-up of the same length.
_SLIPPING: Final = 1.5
#: Orders of the polynomial in every window, and the least and the most correlation of neighbours
#: that is removed. The polynomial fits what is longer than `_BEFORE` samples (0.95 = exp(-1/20)).
_SMOOTH: Final = 6
_LEAST_CORRELATED: Final = 0.05
_MOST_CORRELATED: Final = 0.95
#: Deviations, mm, below which no noise is assumed.
_FLOOR: Final = 2e-5
#: Noise levels tried, by that of a least-squares fit of all decays.
_LEVELS: Final = (0.6, 1.0, 1.7, 3.0)
#: Standard deviations of the delay of an axis, by response or part of a sample, equally probable.
_RESPONSES: Final = np.array([0.25, 0.5, 1.0])
_PART: Final = 0.3
#: Bayes factor against no lag, and standard errors, from which a lag is clear.
_ODDS: Final = 1000.0
_CLEAR: Final = 2.0


@dataclass(frozen=True, slots=True)
class Lag:
    """The common delay of both axes at reversals: ``angle``, rad, and its standard uncertainty
    ``doubt``, rad. ``clear``: the readings are improbable without a delay.
    """

    angle: float
    doubt: float
    clear: bool


def common_lag(samples: CircleSamples) -> Lag:
    """Return the common delay of both axes, from the ``samples`` near the reversal points.

    The prior of the delay is half a normal distribution. The lag of the softest usual position loop
    (`SOFTEST_LOOP`) is 1.3 standard deviations. Without reversal points the prior remains.
    """
    spacing = samples.arc[1] * np.unique(samples.run).size / samples.theta.size
    usual = _USUAL * samples.speed / (SOFTEST_LOOP * samples.radius)
    low, high = -1, int(np.ceil(most_lag(samples) / spacing)) + 1
    group = -(-high // _MOST_SPAN)
    found = None
    if group > 1:
        rough = averaged(samples, group)
        found = _distribution(rough, usual, (-1, -(-high // group)), _LEVELS[1:2])
        if found is not None:
            low = max(int((found.angle - 3.0 * found.doubt) / spacing) - 2 * group, low)
            high = min(int((found.angle + 3.0 * found.doubt) / spacing) + 2 * group, high)
    if high - low <= _MOST_SPAN + 2:
        group = -(-(high - low + _BEFORE + _after(spacing)) // _MOST_WINDOW)
        fine = averaged(samples, group) if group > 1 else samples
        found = _distribution(fine, usual, (low // group, -(-high // group)), _LEVELS)
    if found is None:
        return Lag(0.0, max(usual, 0.5 * spacing), clear=False)
    return found


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


def with_undetected_lag(samples: CircleSamples, lag: Lag) -> CircleSamples:
    """Return the samples with an uncertainty of the delay, ``lag_std``, for a ``lag`` that is not
    clear: the root mean square of its distribution about zero.
    """
    return replace(samples, lag_std=float(np.hypot(lag.angle, lag.doubt)))


def most_lag(samples: CircleSamples) -> float:
    """Return the most lag, rad, that is looked for."""
    return _MOST * samples.speed / (SOFTEST_LOOP * samples.radius)


def shrink_uncertainty(samples: CircleSamples) -> float:
    """Return the standard uncertainty, mm, of the radius from an unknown equal lag of both axes.

    The acceleration makes the circle smaller (ISO 230-4:1996, B.3.2). With the softest usual
    position loop Kv, the radius shrinks by at most a = v² / (2 Kv² R). The shrinkage is assumed to
    be uniform over the range ±a, which gives a / sqrt(3) (JCGM 100:2008, eq. 7).
    """
    most = samples.speed**2 / (2.0 * SOFTEST_LOOP**2 * samples.radius)
    return float(most / np.sqrt(3.0))


def averaged(samples: CircleSamples, group: int) -> CircleSamples:
    """Return the samples with each ``group`` of neighbours of a run averaged."""
    parts = []
    for number in np.unique(samples.run):
        mine = np.flatnonzero(samples.run == number)
        parts.append(mine[: mine.size // group * group].reshape(-1, group))
    at = np.concatenate(parts)
    return replace(
        samples,
        theta=np.mean(samples.theta[at], axis=1),
        deviations=np.mean(samples.deviations[at], axis=1),
        sense=samples.sense[at[:, 0]],
        run=samples.run[at[:, 0]],
    )


def _after(spacing: float) -> int:
    """Return the samples that are looked at after the last angle of the reversal."""
    return max(_NEIGHBOURS, int(_AFTER / spacing))


def _distribution(
    samples: CircleSamples, usual: float, span: tuple[int, int], levels: Sequence[float]
) -> Lag | None:
    """Return mean and standard deviation of the delay over the ``span`` of angles (in samples), or
    None if no window of samples contains a reversal point. ``usual``: standard deviation of the
    prior, rad. ``levels``: noise levels to try, relative to that of a least-squares fit.
    """
    spacing = samples.arc[1] * np.unique(samples.run).size / samples.theta.size
    low, high = span
    windows, axes = _windows(samples, low - _BEFORE, high + _after(spacing))
    if not len(windows):
        return None
    # With fewer angles per sample, a step between two samples is lost.
    steps = 2 if len(levels) == 1 else 6 if high - low <= 12 else 4
    angles = np.arange(steps * low, steps * high + 1, dtype=np.float64) * (spacing / steps)
    reversal = _Reversals(windows, angles, samples.radius, spacing)
    # All runs pass a reversal point alike: what no shape has is in each of them.
    runs = max(np.unique(samples.run).size, 2)
    evidence = [reversal.evidence(level) / runs for level in levels]

    def log_probability(response: float) -> FloatArray:
        parts = [_log_probability(part, axes, angles, response) for part in evidence]
        total: FloatArray = np.logaddexp.reduce(parts, axis=0)
        return total

    log = log_probability(max(RESPONSE * samples.speed / samples.radius, _PART * spacing))
    prior = -0.5 * (angles / usual) ** 2
    chance = np.exp(log + prior - np.max(log + prior))
    chance /= np.sum(chance)
    angle = float(chance @ angles)
    doubt = float(np.sqrt(chance @ (angles - angle) ** 2))
    # Exactly alike axes show best whether there is a delay at all.
    log = log_probability(1e-6 * spacing) + prior
    none = log[-steps * low] if low <= 0 else -np.inf
    odds = _log_sum(log) - _log_sum(prior) - none
    clear = angle > _CLEAR * doubt and odds > np.log(_ODDS)
    return Lag(angle, doubt, bool(clear))


def _windows(samples: CircleSamples, first: int, last: int) -> tuple[FloatArray, IndexArray]:
    """Return the samples in a window at each reversal point of each run, (w, 2, last - first): a
    row of angles from the reversal point, rad, and a row of deviations, mm. The window begins and
    ends so many samples after the reversal point. The second result (w,) is the reversing axis.
    """
    found, axes = [], []
    for number in np.unique(samples.run):
        mine = np.flatnonzero(samples.run == number)
        sense = float(samples.sense[mine[0]])
        for point in range(4):
            travelled = sense * (samples.theta[mine] - 0.5 * np.pi * point)
            travelled = np.mod(travelled + np.pi, 2.0 * np.pi) - np.pi
            order = np.argsort(travelled)
            middle = int(np.searchsorted(travelled[order], 0.0))
            near = order[max(middle + first, 0) : middle + last]
            # At the ends of a run or an arc neighbours are not neighbours in time.
            if (
                near.size == last - first
                and np.ptp(travelled[near]) < np.pi / 3.0
                and np.ptp(near) < near.size
            ):
                found.append(np.vstack([travelled[near], samples.deviations[mine[near]]]))
                axes.append(point % 2)
    return np.array(found), np.array(axes, dtype=np.intp)


def _log_probability(
    evidence: FloatArray, axes: IndexArray, angles: FloatArray, response: float
) -> FloatArray:
    """Return the log probability (a,) of the windows for each of the ``angles`` (a,), from the
    ``evidence`` (a, w, 1 + m) of a sudden step and of m take-ups in each window.

    All reversals of an axis (``axes`` (w,)) have the same take-up or its neighbour, up to a
    probability of `_DIFFERENT`. Each axis has an own delay, about as long as its ``response``.
    """
    count = evidence.shape[-1]
    prior = np.full(count, _GRADUAL / max(count - 1, 1))
    prior[0] = 1.0 - _GRADUAL if count > 1 else 1.0
    alike = 2.0 * np.eye(count) + np.eye(count, k=1) + np.eye(count, k=-1)
    alike[0, 1:] = alike[1:, 0] = 0.0
    alike = (1.0 - _DIFFERENT) * alike / np.sum(alike, axis=1, keepdims=True) + _DIFFERENT * prior
    top = np.max(evidence, axis=-1, keepdims=True)
    mixed = np.log(np.exp(evidence - top) @ alike.T) + top
    late = (angles[:, np.newaxis] - angles) / (response * _RESPONSES[:, np.newaxis, np.newaxis])
    spread = np.exp(-0.5 * late**2)
    spread /= np.sum(spread, axis=-1, keepdims=True)
    total = np.zeros((_RESPONSES.size, angles.size))
    for axis in np.unique(axes):
        log = _log_sum(np.sum(mixed[:, axes == axis], axis=1) + np.log(prior))
        total += np.log(spread @ np.exp(log - np.max(log)) + 1e-300) + np.max(log)
    return _log_sum(total.T)


def _log_sum(logs: FloatArray) -> FloatArray:
    """Return the logarithm of the sum of exponentials over the last axis."""
    top = np.max(logs, axis=-1, keepdims=True)
    total: FloatArray = np.log(np.sum(np.exp(logs - top), axis=-1)) + top[..., 0]
    return total


class _Reversals:
    """The normal equations of all shapes in ``windows`` (w, 2, n), for each of the ``angles`` (a,)
    of the reversal. ``radius`` mm, ``spacing`` of the samples rad.

    A window has a polynomial, and from the reversal on a step, a bend, decays and a take-up. Lost
    motion is taken up with the square of the arc, or as a friction that slips gradually (Dahl,
    1968).
    """

    def __init__(
        self, windows: FloatArray, angles: FloatArray, radius: float, spacing: float
    ) -> None:
        where, values = windows[:, 0], windows[:, 1]
        lengths = np.sqrt(2.0 * UM * radius * np.geomspace(*_TAKEN, _LENGTHS))
        lengths = lengths[lengths > _SEEN * spacing * radius]
        # The axis stands still: its deviation grows as s² / 2R.
        self.standing = -(lengths**2) / (2.0 * radius)
        ratio = (_TAKEN[1] / _TAKEN[0]) ** (0.5 / (_LENGTHS - 1))
        self.between = 0.5 * (1.0 - ratio) * self.standing
        decays = radius * np.geomspace(_SHORTEST * spacing, _LONGEST, _DECAYS)[:, np.newaxis]
        late = radius * (where - angles[:, np.newaxis, np.newaxis])[..., np.newaxis, :]
        after, late = late > 0.0, np.maximum(late, 0.0)
        share = (late / lengths[:, np.newaxis]) ** 2
        first = np.concatenate([np.ones_like(late), late / radius, np.exp(-late / decays)], axis=-2)
        shapes = [first, np.maximum(1.0 - share, 0.0), np.exp(-_SLIPPING * share), share < 1.0]
        columns = after * np.concatenate(shapes, axis=-2)
        middle = np.mean(where)
        powers = np.arange(_SMOOTH)[:, np.newaxis]
        smooth = ((where - middle) / np.max(np.abs(where - middle)))[:, np.newaxis] ** powers
        rho, self.variance = _noise(columns[..., : first.shape[-2], :], smooth, values)
        if rho > _LEAST_CORRELATED:
            columns, smooth, values = (_white(each, rho) for each in (columns, smooth, values))
        rows, right, values = _without(smooth, columns, values)
        left: FloatArray = np.broadcast_to(np.sum(values**2, axis=-1), right.shape[:-1])
        self.log_weight = np.zeros(left.shape)
        # A step and a bend are in every model, of any size.
        for _ in range(2):
            weight, cross = rows[..., 0, 0], rows[..., 1:, 0]
            self.log_weight = self.log_weight - 0.5 * np.log(weight)
            left = left - right[..., 0] ** 2 / weight
            part = cross / weight[..., np.newaxis]
            right = right[..., 1:] - part * right[..., :1]
            rows = rows[..., 1:, 1:] - part[..., np.newaxis] * cross[..., np.newaxis, :]
        self.left, self.freedom = left, float(values.shape[1] - _SMOOTH - 2)
        places = _DECAYS + np.arange(3 * lengths.size).reshape(3, lengths.size)
        self.parts = []
        for more in (np.zeros((0, 1), dtype=np.intp), places[[0, 2]], places[[1]]):
            always = np.broadcast_to(np.arange(_DECAYS), (more.shape[1], _DECAYS))
            at = np.column_stack([always, more.T])
            self.parts.append((rows[..., at[:, :, np.newaxis], at[:, np.newaxis]], right[..., at]))

    def evidence(self, level: float) -> FloatArray:
        """Return the log probability (a, w, 1 + m) of each window with a sudden step and with each
        of m take-ups, averaged over all decays. ``level``: noise, by that of the first fit.
        """
        noise = level**2 * self.variance
        sudden, stand, slip = self.parts
        found = [_decays(*sudden, noise)]
        if self.standing.size:
            rows, right, between = _integrated(*stand, noise, self.between, 0.0)
            width = _STANDING * np.abs(self.standing)
            logs = [
                between + _with_decays(rows, right, noise, _SIZE),
                between + _with_decays(rows, right, noise, width, self.standing),
                _with_decays(*slip, noise, _SIZE),
            ]
            found.append(_log_sum(np.stack(logs, axis=-1)) - np.log(len(logs)))
        log = np.concatenate(found, axis=-1)
        rest = self.log_weight - 0.5 * self.left / noise - 0.5 * self.freedom * np.log(noise)
        total: FloatArray = log + rest[..., np.newaxis]
        return total


def _integrated(
    rows: FloatArray,
    right: FloatArray,
    noise: float,
    width: float | FloatArray,
    mean: float | FloatArray,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return normal equations (..., k, k) and (..., k) after their last column is integrated out,
    and the log probability that this adds. The column has a normal prior with ``mean`` and standard
    deviation ``width``, mm; ``noise``: variance of the readings, mm².
    """
    own, cross = rows[..., -1, -1], rows[..., :-1, -1]
    weight = own + noise / width**2
    side = right[..., -1] - mean * own
    log = (mean * (right[..., -1] + side) + side**2 / weight) / noise
    log = 0.5 * log - 0.5 * np.log(weight * width**2 / noise)
    part = cross / weight[..., np.newaxis]
    moved = np.asarray(mean)[..., np.newaxis] * cross + part * side[..., np.newaxis]
    rows = rows[..., :-1, :-1] - part[..., np.newaxis] * cross[..., np.newaxis, :]
    return rows, right[..., :-1] - moved, log


def _with_decays(
    rows: FloatArray,
    right: FloatArray,
    noise: float,
    width: float | FloatArray,
    mean: float | FloatArray = 0.0,
) -> FloatArray:
    """Return the log probability of the last column (`_integrated`) with all decays (`_decays`)."""
    rows, right, log = _integrated(rows, right, noise, width, mean)
    return log + _decays(rows, right, noise)


def _decays(rows: FloatArray, right: FloatArray, noise: float) -> FloatArray:
    """Return the log probability of no decay, any one and any two of the decays with the normal
    equations ``rows`` (..., k, k) and ``right`` (..., k).
    """
    own = np.maximum(np.diagonal(rows, axis1=-2, axis2=-1), 0.0)
    logs = [np.full((*own.shape[:-1], 1), _SPIKES[0])]
    count = own.shape[-1]
    for width in _SINGLE:
        weight = own + noise / width**2
        log = 0.5 * right**2 / (weight * noise) - 0.5 * np.log(weight * width**2 / noise)
        logs.append(log + _SPIKES[1] - np.log(count * len(_SINGLE)))
    one, two = np.triu_indices(count, 1)
    cross, prior = rows[..., one, two], noise / _SIZE**2
    weight = own[..., one] + prior
    left = np.maximum(own[..., two] - cross**2 / weight, 0.0) + prior
    more = right[..., two] - cross / weight * right[..., one]
    log = 0.5 * (right[..., one] ** 2 / weight + more**2 / left) / noise
    log = log - 0.5 * np.log(weight * left / prior**2)
    logs.append(log + _SPIKES[2] - np.log(one.size))
    return _log_sum(np.concatenate(logs, axis=-1))


def _noise(columns: FloatArray, smooth: FloatArray, values: FloatArray) -> tuple[float, float]:
    """Return the correlation of neighbouring samples and the variance, mm², of the residuals of a
    least-squares fit of ``columns`` (a, w, k, n) and ``smooth`` (w, s, n), at the best angle.
    """
    rows, right, values = _without(smooth, columns, values)
    unit = np.mean(np.einsum("awkk->awk", rows), axis=-1)[..., np.newaxis, np.newaxis]
    ridged = rows + 1e-6 * unit * np.eye(rows.shape[-1])
    sizes = np.linalg.solve(ridged, right[..., np.newaxis])
    best = int(np.argmax(np.sum(sizes[..., 0] * right, axis=(1, 2))))
    rest = values - np.einsum("wk,wkn->wn", sizes[best, ..., 0], columns[best])
    rest = _without(smooth, columns[:1, :, :1], rest)[2]
    # Unknowns that a ridge regression determines: the trace of its hat matrix (Hastie, Tibshirani
    # and Friedman, The Elements of Statistical Learning, 2nd ed. 2009, eq. 3.50).
    hat = np.linalg.solve(ridged[best], rows[best])
    used = smooth.shape[-2] + float(np.mean(np.trace(hat, axis1=-2, axis2=-1)))
    correlation = float(np.sum(rest[:, 1:] * rest[:, :-1]) / max(np.sum(rest**2), 1e-300))
    correlation += 0.5 * used / rest.shape[1]
    correlation = min(max(correlation, 0.0), _MOST_CORRELATED)
    white = _white(rest, correlation)
    variance = float(np.sum(white**2)) / (rest.shape[0] * (rest.shape[1] - used))
    return correlation, max(variance, _FLOOR**2)


def _white(values: FloatArray, correlation: float) -> FloatArray:
    """Return values (..., n) with the correlation of neighbours removed (first-order
    autoregression).
    """
    white = values.copy()
    white[..., 1:] -= correlation * values[..., :-1]
    white[..., 1:] /= np.sqrt(1.0 - correlation**2)
    return white


def _without(
    smooth: FloatArray, columns: FloatArray, values: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the normal equations (a, w, k, k) and (a, w, k) of ``columns`` (a, w, k, n) after the
    ``smooth`` functions (w, s, n) are fitted, and the ``values`` (w, n) without them.
    """
    basis = np.linalg.qr(np.swapaxes(smooth, -1, -2))[0]
    values = values - np.einsum("wns,ws->wn", basis, np.einsum("wns,wn->ws", basis, values))
    shared = columns @ basis
    rows = columns @ np.swapaxes(columns, -1, -2) - shared @ np.swapaxes(shared, -1, -2)
    return rows, (columns @ values[..., np.newaxis])[..., 0], values
