"""Effects in a circular test that are read from its fit or its residuals: highest readings,
stick-slip, lobes, positional tolerance.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.circle_causes import scale_mismatch
from compwright.estimation.circle_centre import recentre, second_order
from compwright.estimation.circle_lag import shrink_uncertainty
from compwright.estimation.circle_model import AXES, ENDS, UM, CircleSamples, since_reversal
from compwright.estimation.circle_solution import Solution
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularTest

#: Arc, rad, after a reversal in which its peak lies, and about it in which an axis is slow.
_PEAK: Final = np.radians(10.0)
_SLOW: Final = np.radians(12.0)
#: Arcs, rad, before a reversal in which an axis may move irregularly, and standard errors from
#: which this is clear.
_BEFORE: Final = np.radians([1.5, 3.0, 6.0, 12.0])
_CLEAR: Final = 3.0
#: Fewest independent samples of a variance.
_FEWEST: Final = 5.0
#: Share of the irregular motion that may be a spike of a shape that no decays make.
_OWN_SHAPE: Final = 0.5
#: Prior probability that what was fitted as reversal spikes is irregular motion.
_NO_SPIKE: Final = 0.1
_MOST_DRAWS: Final = 64
#: Places along each axis at which position errors are compared: the largest straightness of third
#: order is between the middle and the ends.
_GRID: Final = 5


def raw_peak(
    solution: Solution, axis: str, end: str, sense: float | None, *, outward: bool
) -> float | None:
    """Return the extreme reading after the reversals of an axis at one end, minus the fitted path
    without spikes, um: the highest, or the lowest if the spike is not ``outward``.

    It is the mean of the runs in the direction ``sense`` (+1 ccw, -1 cw, None: both). None without
    a sample nearby.
    """
    samples = solution.problem.samples
    start = (0.0 if axis == "first" else 0.5 * np.pi) + (0.0 if end == "positive" else np.pi)
    since = np.mod(samples.sense * (samples.theta - start), 2.0 * np.pi)
    above = (solution.problem.target - solution.smooth) / UM
    extreme = np.max if outward else np.min
    peaks = [
        float(extreme(above[mine]))
        for number in np.unique(
            samples.run if sense is None else samples.run[samples.sense == sense]
        )
        if np.any(mine := (samples.run == number) & (since < _PEAK))
    ]
    return float(np.mean(peaks)) if peaks else None


def stick_slip(solution: Solution, axis: str) -> tuple[float, float] | None:
    """Return the amplitude of irregular motion of an axis near its reversals, um, and its standard
    error. None where the arc has no reversal of the axis, or too few independent samples near or
    away from the reversals.

    Near a reversal means within 12° of it. The amplitude is the root of twice a difference of
    variances: that of the residuals near the reversals minus that of the other samples. The fitted
    spikes of the axis may be irregular motion themselves: the standard error holds their readings.

    The standard errors follow from the chi-square law of a variance. The number of independent
    samples is n divided by the sum of the squared correlations of the residuals. This sum is n Σ f²
    / (Σ f)² of their spectrum f (Bartlett, J. Royal Statistical Society Suppl. 8, 1946).
    """
    problem = solution.problem
    samples, residual = problem.samples, solution.residual / UM
    if not any(samples.reversals(axis)):
        return None
    own = np.sin(samples.theta) if axis == "first" else np.cos(samples.theta)
    slow, fast = np.abs(own) < np.sin(_SLOW), _away(samples)
    counts = [float(np.sum(part)) / _correlated(solution) for part in (slow, fast)]
    if min(counts) < _FEWEST:
        return None
    variances = [float(np.mean(residual[part] ** 2)) for part in (slow, fast)]
    error = np.sqrt(sum(2.0 * v**2 / n for v, n in zip(variances, counts, strict=True)))
    excess = max(variances[0] - variances[1], 0.0)
    amplitude = float(np.sqrt(2.0 * excess))
    # Near zero the root is not straight: there the amplitude of one standard error counts.
    near = float(min(error / max(amplitude, 1e-12), np.sqrt(2.0 * error)))
    spikes = [  # of each direction
        [spike.curve[sense] * (spike.reversal.axis == axis) for spike in solution.draws.spikes]
        for sense in (0, -1)
    ]
    readings = problem.spike_curves(np.array(spikes))[:, slow] / UM
    taken = float(np.sqrt(2.0 * _NO_SPIKE * np.mean(readings**2)))
    return amplitude, math.hypot(near, _OWN_SHAPE * amplitude, taken)


def irregular_motion(solution: Solution, axis: str) -> float:
    """Return the variance, um², of irregular motion at the reversals of an axis: a peak of
    stick-slip looks like a spike.

    An axis is as slow before a reversal as after it, and no spike is fitted there. The variance is
    that of the residuals so far before the reversals minus that away from all reversals, at the
    angle at which it is largest. It is 0 where it is not clear.
    """
    samples, residual, found = solution.problem.samples, solution.residual / UM, 0.0
    until, away = np.pi - since_reversal(samples, axis) / samples.radius, _away(samples)
    usual = float(np.mean(residual[away] ** 2)) if np.any(away) else np.inf
    for angle in _BEFORE:
        near = until < angle
        count = float(np.sum(near)) / _correlated(solution)
        if count >= _FEWEST:
            local = float(np.mean(residual[near] ** 2))
            error = usual * math.sqrt(2.0 / count)
            found = max(found, local - usual) if local - usual > _CLEAR * error else found
    return found


def _away(samples: CircleSamples) -> NDArray[np.bool_]:
    """Return which samples (n,) are away from the reversals of both axes."""
    nearest = np.minimum(np.abs(np.sin(samples.theta)), np.abs(np.cos(samples.theta)))
    found: NDArray[np.bool_] = nearest >= np.sin(_SLOW)
    return found


def _correlated(solution: Solution) -> float:
    """Return the number of neighbouring residuals that count as one independent residual."""
    densities = [each.density for each in solution.fitted.spectra]
    return float(np.mean([np.mean(f**2) / np.mean(f) ** 2 for f in densities]))


def lobes(test: CircularTest, solution: Solution, order: int) -> tuple[float, float]:
    """Return the amplitude, um, of the harmonic of ``order`` in the mean of both directions, over
    the commanded angles, with its standard error.

    It is that of all readings: without the one at a reversal, a step of lost motion would be a few
    nanometres of every harmonic. The ball at the centre of each direction's least-squares circle
    has no part in it (`second_order`).

    For the harmonic a cos nθ + b sin nθ of the readings, the amplitude is sqrt(a² + b² - σ²)
    (Gudbjartsson and Patz, Magnetic Resonance in Medicine 34, 1995). σ comes from the spectrum of
    the residuals at that order. Lobes of order 2 are caused by scale and squareness, lobes of order
    3 by straightness (ISO 230-4:1996, annex B).
    """
    waves, radius = [], test.nominal_radius
    for sense in sorted({run.sense for run in test.runs}):
        runs = [run for run in test.runs if run.sense == sense]
        theta = np.radians(np.concatenate([run.angles for run in runs]))
        readings = np.concatenate([run.deviations for run in runs])
        x, y, _ = recentre(theta, readings, radius)
        turns = np.outer(theta, np.arange(1.0, 6.0))
        matrix = np.column_stack([np.ones_like(theta), np.cos(turns), np.sin(turns)])
        about = readings - second_order(theta, (x, y), radius)
        solved = np.linalg.solve(matrix.T @ matrix, matrix.T @ (about / UM))
        waves.append(complex(solved[order], solved[5 + order]))
    power = (abs(sum(waves)) / len(waves)) ** 2
    density = float(solution.fitted.spectra[0].density[2 * order]) / UM**2
    variance = 2.0 * density / sum(run.angles.size for run in test.runs)
    return float(np.sqrt(max(power - variance, 0.0))), float(np.sqrt(variance))


def positional_tolerance(solution: Solution) -> tuple[float, float]:
    """Return the positional tolerance, um, with its standard error: the largest difference between
    the position errors of two points of the square around the circle. The length of the bar must be
    known.

    It contains the errors that do not depend on the feed: both scales, squareness, straightness,
    lost motion, lateral play, cyclic errors. The position errors are those of a workpiece that is
    aligned with the first axis (x - β y). The points are on a grid and approached from both sides
    by both axes.

    A circle leaves open three things, which the standard error contains. Equal lags of both axes
    change the radius like equal scales do, by an unknown part (`shrink_uncertainty`). Straightness
    of third order may be that of either axis. A cyclic error may be hidden. This definition is of
    this project, because the formula of instrument makers is not published.
    """
    every, mismatches = solution.draws.values, scale_mismatch(solution, 0.0).drawn
    mean = np.mean(every, axis=0, keepdims=True), np.mean(mismatches, keepdims=True)
    value = float(np.mean(_spreads(solution, *mean, np.zeros(1))))
    each = slice(None, None, max(mismatches.size // _MOST_DRAWS, 1))
    drawn = every[each], mismatches[each]
    rng = np.random.default_rng(solution.problem.target.size)
    most = np.sqrt(3.0) * shrink_uncertainty(solution.problem.samples)
    shrinks = rng.permutation(np.linspace(-most, most, len(drawn[1])))
    spreads = _spreads(solution, *drawn, shrinks)
    hidden = [solution.hidden.get(axis, 0.0) for axis in AXES if axis not in solution.frequencies]
    return value, math.hypot(float(np.sqrt(np.mean((spreads - value) ** 2))), *hidden)


def _spreads(
    solution: Solution, draws: FloatArray, mismatches: FloatArray, shrinks: FloatArray
) -> FloatArray:
    """Return the positional tolerance, um (2, d), of d ``draws`` (d, p) of the causes, with the
    straightness of third order on the first or the second axis. ``mismatches`` (d,): scale
    mismatch, um. ``shrinks`` (d,): how much equal lags make the radius smaller, mm.
    """
    values = dict(zip(solution.problem.names, draws.T[..., np.newaxis], strict=True))
    radius = solution.problem.samples.radius
    grid = np.meshgrid(*(np.linspace(-1.0, 1.0, _GRID),) * 2, [-1.0, 1.0], [-1.0, 1.0])
    x, y, toward_x, toward_y = (each.ravel() for each in grid)
    mean, part = (values["_radius"] + shrinks[:, np.newaxis]) / UM, 0.25 * mismatches[:, np.newaxis]
    error_x = (
        (mean + part) * x
        - 1e-3 * values["squareness"] * radius * y
        + values["straightness_second"] * y**2
        - 0.5 * _along(values, "backlash_first", x) * toward_x
        + 0.5 * _along(values, "lateral_play_second", y) * toward_y
    )
    error_y = (
        (mean - part) * y
        + values["straightness_first"] * x**2
        - 0.5 * _along(values, "backlash_second", y) * toward_y
        + 0.5 * _along(values, "lateral_play_first", x) * toward_x
    )
    sizes = [
        sum(
            (
                np.hypot(*(values[f"_cyclic_{part}_{name}"] for part in ("cos", "sin")))
                for name in solution.cyclic_waves(axis)
            ),
            np.zeros((1, 1)),
        )
        for axis in AXES
    ]

    def largest(*errors: FloatArray) -> FloatArray:
        wide, high = (
            np.abs(error[:, :, np.newaxis] - error[:, np.newaxis]) + 2.0 * size[..., np.newaxis]
            for error, size in zip(errors, sizes, strict=True)
        )
        found: FloatArray = np.sqrt(np.max(wide**2 + high**2, axis=(1, 2)))
        return found

    turned = values["_s_shape"]
    return np.array(
        [
            largest(error_x, error_y + turned * (2.0 * x**3 - x)),
            largest(error_x - turned * (2.0 * y**3 - y), error_y),
        ]
    )


def _along(values: Mapping[str, FloatArray], name: str, place: FloatArray) -> FloatArray:
    """Return the lost motion or lateral play ``name`` at each ``place`` (-1 to 1) of its axis: it
    changes in proportion to the position.
    """
    if name in values:
        change = values.get(f"_{name.replace('play', 'change')}", np.zeros(1))
        return values[name] + change * place
    ends = [values[f"{name}_at_{end}"] for end in ENDS]
    along: FloatArray = 0.5 * (ends[0] + ends[1]) + 0.5 * (ends[0] - ends[1]) * place
    return along
