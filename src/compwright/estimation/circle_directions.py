"""Odds that the two directions of a circular test are exchanged in its file.

A spike, the take-up of lost motion and the delay of an axis follow its reversal. If the directions
are exchanged, time runs backwards, and they come before it. The readings are fitted twice, forward
and backward in time, with the same number of unknowns. Causes without an order in time (ISO
230-4:1996, annex B) are in both fits.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.estimation.circle_lag import averaged
from compwright.estimation.circle_model import SOFTEST_LOOP, UM, CircleSamples
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.words.sentences import say

#: Samples of a run that are fitted at most: more blur no spike that lasts 1 mm, and take longer.
_MOST: Final = 900
#: Angles at which an axis reverses, rad.
_POINTS: Final = (0.0, 0.5 * np.pi, np.pi, 1.5 * np.pi)
#: Shifts of the reversals that are tried on either side of zero, up to so many lags of the softest
#: usual position loop, and the standard deviation of their prior in such lags (as in `circle_lag`).
_SHIFTS: Final = 8
_MOST_SHIFT: Final = 1.5
_USUAL: Final = 0.75
#: Lengths of decays, rad; the shortest is one sample. Travels, um, over which lost motion is taken
#: up, and the least of their arcs in samples.
_DECAYS: Final = 3
_LONGEST: Final = 0.12
_TAKEN: Final = np.array([1.0, 4.0, 15.0])
_LEAST_TAKEN: Final = np.array([1.0, 1.7, 3.0])
#: Shapes that are fitted after all reversals.
_SHAPES: Final = len(_POINTS) * (_DECAYS + _TAKEN.size)
#: Logarithm of the odds from which an exchange is clear: five standard deviations of half the
#: difference of two sums of squares with so many degrees of freedom each, as where nothing follows
#: a reversal. With right directions the highest of 381 generated circles and arcs is 13.1.
_CLEAR: Final = 5.0 * np.sqrt(_SHAPES)
#: Most correlation of neighbours that is removed (as in `circle_lag`).
_CORRELATED: Final = 0.97
#: Deviations, mm, below which no noise is assumed, and a ridge by the mean square of a column:
#: reversals outside an arc have none.
_FLOOR: Final = 2e-5
_RIDGE: Final = 1e-6


def exchange_findings(samples: CircleSamples) -> Iterator[Finding]:
    """Yield the finding CW-D012 if the directions of the runs are clearly exchanged."""
    if exchange_odds(samples) > _CLEAR:
        yield Finding.of("CW-D012", "warning", odds=say("odds.over_1000"))


def exchange_odds(samples: CircleSamples) -> float:
    """Return the natural logarithm of the odds that the directions of the runs are exchanged,
    positive if probably; minus infinity for one direction or too few samples.

    The likelihood ratio of both fits, whitened by the correlation of neighbours, is averaged over
    the shift of the reversals (angle of the first sample, delay of the axes). Of two priors the
    smaller odds count: a shift either way, and a delay only.
    """
    group = -(-samples.theta.size // (np.unique(samples.run).size * _MOST))
    samples = averaged(samples, group) if group > 1 else samples
    spacing = samples.arc[1] * np.unique(samples.run).size / samples.theta.size
    softest = samples.speed / (SOFTEST_LOOP * samples.radius)
    shifts = np.linspace(-1.0, 1.0, 2 * _SHIFTS + 1) * max(_MOST_SHIFT * softest, 2.0 * spacing)
    timeless, values = _timeless(samples), samples.deviations
    free = values.size - timeless.shape[1] - len(_POINTS) - _SHAPES
    if not samples.both_senses or free < _SHAPES:
        return -np.inf
    ways = [
        [_after_reversals(samples, sense, shift, spacing) for shift in shifts]
        for sense in (samples.sense, -samples.sense)
    ]
    basis = np.linalg.qr(timeless)[0]
    rests = [_rest(basis, way[_SHIFTS], values) for way in ways]
    rest = min(rests, key=lambda rest: float(rest @ rest))
    correlation = float(rest[1:] @ rest[:-1]) / max(float(rest @ rest), 1e-300)
    correlation = min(max(correlation, 0.0), _CORRELATED)
    begins = np.flatnonzero(np.diff(samples.run, prepend=-1))

    def white(columns: FloatArray) -> FloatArray:
        whitened = columns.copy()
        whitened[1:] -= correlation * columns[:-1]
        whitened[begins] = columns[begins] * np.sqrt(1.0 - correlation**2)
        return whitened

    basis, values = np.linalg.qr(white(timeless))[0], white(values)
    rests = [_rest(basis, white(after), values) for way in ways for after in way]
    squares = np.array([float(rest @ rest) for rest in rests]).reshape(2, -1)
    squares = np.maximum(squares, values.size * _FLOOR**2)
    log = -0.5 * free * np.log(squares / np.min(squares))
    given, exchanged = log - 0.5 * (shifts / (_USUAL * softest)) ** 2
    late = shifts >= -spacing
    return min(
        float(np.logaddexp.reduce(exchanged[place]) - np.logaddexp.reduce(given[place]))
        for place in (slice(None), late)
    )


def _timeless(samples: CircleSamples) -> FloatArray:
    """Return the causes that are alike forward and backward in time as columns (n, k): set-up,
    scale, squareness, lag difference, lateral play, straightness, changes between the directions,
    and drift in a run.
    """
    theta, sense = samples.theta, samples.sense
    cos, sin = np.cos(theta), np.sin(theta)
    even = [np.ones_like(theta), cos, sin, np.cos(2.0 * theta), np.sin(2.0 * theta)]
    odd = [*even, np.abs(sin), np.abs(cos)]
    even += [cos**2 * sin, sin**2 * cos, np.cos(3.0 * theta), np.sin(3.0 * theta)]
    time = np.zeros_like(theta)
    for run in np.unique(samples.run):
        mine = samples.run == run
        time[mine] = np.linspace(-0.5, 0.5, int(np.sum(mine)))
    return np.column_stack([*even, *(sense * each for each in odd), time])


def _after_reversals(
    samples: CircleSamples, sense: FloatArray, shift: float, spacing: float
) -> FloatArray:
    """Return what follows the reversals as columns (n, k): the lost motion at each end, and at each
    reversal point decays and take-ups. ``sense`` (n,): 1 in ccw, -1 in cw; ``shift``, rad: angle
    from the commanded reversal to that of the axis.
    """
    return np.column_stack([*_shapes(samples, sense, shift, spacing)])


def _shapes(
    samples: CircleSamples, sense: FloatArray, shift: float, spacing: float
) -> Iterator[FloatArray]:
    theta = samples.theta
    cos, sin = np.cos(theta), np.sin(theta)
    there = theta - sense * shift
    for along, moving in ((cos, np.sin(there)), (sin, np.cos(there))):
        for end in (1.0, -1.0):
            yield sense * np.sign(moving) * along * (end * along > 0.0)
    decays = np.geomspace(spacing, max(_LONGEST, 2.0 * spacing), _DECAYS)
    taken = np.maximum(np.sqrt(2.0 * UM * _TAKEN / samples.radius), _LEAST_TAKEN * spacing)
    for point in _POINTS:
        since = np.mod(sense * (theta - point) - shift + np.pi, 2.0 * np.pi) - np.pi
        after, late = since > 0.0, np.maximum(since, 0.0)
        for length in decays:
            yield after * np.exp(-late / length)
        for length in taken:
            yield after * np.maximum(1.0 - (late / length) ** 2, 0.0)


def _rest(basis: FloatArray, after: FloatArray, values: FloatArray) -> FloatArray:
    """Return the residuals (n,) of ``values`` (n,) after a fit of the orthonormal columns ``basis``
    (n, s) and the columns ``after`` (n, k).
    """
    columns, values = (each - basis @ (basis.T @ each) for each in (after, values))
    normal = columns.T @ columns
    normal += _RIDGE * np.mean(np.diag(normal)) * np.eye(len(normal))
    rest: FloatArray = values - columns @ np.linalg.solve(normal, columns.T @ values)
    return rest
