"""The next circular test: every sample of the one that was measured, moved by what the tables
change, with fresh noise.

The measured path holds every error of the machine at the place of the circle, so that nothing of it
has to be modelled to predict the change. What is random in a fresh test is drawn: the noise from
what a short smoothing of the samples leaves, the causes that a diagnosis separates from their
standard errors.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np

from compwright.evaluation.circular import evaluate_circle
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularResult, CircularRun, CircularTest, Diagnosis
from compwright.records.prediction import CirclePrediction, Quantiles
from compwright.records.settled import settled_number

__all__ = ["CirclePath", "moved_test", "path_of", "predict_circle"]

#: Samples over which the path is taken as a parabola: 2.6° of a usual ballbar's 1500, well within
#: the decay of a reversal spike.
_WINDOW: Final = 11
#: Median and the ends of a 90 % interval of a normal distribution, in standard deviations.
_NINETY: Final = 1.645
_UM: Final = 1e-3  # mm
_PPM: Final = 1e-6
#: A parameter of a fresh test differs from the same one of the last test by the errors of both.
_BOTH_TESTS: Final = 2.0


@dataclass(frozen=True, slots=True)
class CirclePath:
    """Where a run commands its two axes: machine coordinates (n,) mm, and the sign (n,) in which
    each axis moves there.

    The reversal is that of the command; an axis that lags reverses later by less than a sample.
    """

    first: FloatArray
    second: FloatArray
    moves_first: FloatArray
    moves_second: FloatArray


#: What moves the tool at a path: (n, 2) mm along the first and the second axis.
Displacement = Callable[[CirclePath], FloatArray]


def path_of(test: CircularTest, run: CircularRun, centre: tuple[float, float]) -> CirclePath:
    """Return where ``run`` of ``test`` about ``centre`` (mm, machine coordinates of both axes)
    commands the axes.
    """
    theta, d = np.radians(run.angles), 1.0 if run.sense == "ccw" else -1.0
    cos, sin = np.cos(theta), np.sin(theta)
    return CirclePath(
        first=centre[0] + test.nominal_radius * cos,
        second=centre[1] + test.nominal_radius * sin,
        moves_first=np.where(d * sin >= 0.0, -1.0, 1.0),  # exactly at a reversal: the new direction
        moves_second=np.where(d * cos >= 0.0, 1.0, -1.0),
    )


def moved_test(
    test: CircularTest, centre: tuple[float, float], displacement: Displacement
) -> CircularTest:
    """Return the test as it would have come out with every point of its path moved by
    ``displacement``.

    What the displacement is in the centre of the circle, on the mean of both directions of motion,
    is left out: there the instrument is set up anew. The distance is exact; only the place of the
    point on its ray is the commanded one.
    """
    here = np.full(2, centre[0]), np.full(2, centre[1])
    both = np.array([1.0, -1.0])
    in_centre = np.mean(displacement(CirclePath(*here, both, both)), axis=0)
    runs = []
    for run in test.runs:
        theta = np.radians(run.angles)
        point = (test.nominal_radius + run.deviations)[:, np.newaxis] * np.column_stack(
            [np.cos(theta), np.sin(theta)]
        )
        point = point + displacement(path_of(test, run, centre)) - in_centre
        runs.append(
            replace(run, deviations=np.hypot(point[:, 0], point[:, 1]) - test.nominal_radius)
        )
    return replace(test, runs=tuple(runs))


def predict_circle(
    before: CircularResult, expected: CircularResult, rng: np.random.Generator, draws: int
) -> CirclePrediction:
    """Return what a fresh test will show. ``expected``: the test ``before`` moved by what changes,
    evaluated and diagnosed.

    Parameters come from ``draws`` tests with fresh noise; causes, which are linear in the readings,
    from the standard errors of both tests. A parameter that ``before`` does not have is left out.
    Amplitudes are not below zero.
    """
    test = expected.test
    smooth = [_smoothed(run) for run in test.runs]
    rest = [run.deviations - curve for run, curve in zip(test.runs, smooth, strict=True)]
    shapes = _shapes(test, expected.diagnosis, rng, draws)
    rows: dict[str, list[float]] = {}
    for draw in range(draws):
        runs = tuple(
            replace(
                run,
                deviations=curve
                + shape[draw]
                + rng.choice([-1.0, 1.0]) * np.roll(noise, int(rng.integers(noise.size))),
            )
            for run, curve, noise, shape in zip(test.runs, smooth, rest, shapes, strict=True)
        )
        for name, value in evaluate_circle(
            replace(test, runs=runs, findings=()), expected.standard
        ).parameters.items():
            if value is not None and before.parameters.get(name) is not None:
                rows.setdefault(name, []).append(value)
    return CirclePrediction(
        before=before,
        expected=expected,
        predicted={name: _quantiles(np.array(values)) for name, values in rows.items()},
        causes={} if expected.diagnosis is None else dict(_causes(expected.diagnosis)),
    )


def _quantiles(values: FloatArray) -> Quantiles:
    p05, median, p95 = np.quantile(values, [0.05, 0.5, 0.95])
    return Quantiles(
        median=settled_number(median), p05=settled_number(p05), p95=settled_number(p95)
    )


def _causes(diagnosis: Diagnosis) -> Iterator[tuple[str, Quantiles]]:
    for name, effect in diagnosis.effects.items():
        if name in diagnosis.undetermined:
            continue
        reach = _NINETY * float(np.sqrt(_BOTH_TESTS)) * effect.std_error
        least = 0.0 if effect.low is not None else -np.inf
        yield name, Quantiles(effect.value, max(effect.value - reach, least), effect.value + reach)


def _smoothed(run: CircularRun) -> FloatArray:
    """Return the deviations (n,) mm without what changes from sample to sample: parabolas over
    `_WINDOW` samples.

    The windows stop at the reversal points (multiples of 90°), where the path may step.
    """
    quadrant = np.floor(run.angles / 90.0)
    edges = [0, *(np.flatnonzero(np.diff(quadrant)) + 1), run.angles.size]
    pieces = [_parabolas(run.deviations[low:high]) for low, high in pairwise(edges)]
    return np.concatenate(pieces)


def _parabolas(values: FloatArray) -> FloatArray:
    """Return, for each of (n,) equally spaced values, the parabola through the `_WINDOW` values
    about it (fewer points: as is).
    """
    if values.size < _WINDOW:
        return values
    half = _WINDOW // 2
    basis = np.vander(np.linspace(-1.0, 1.0, _WINDOW), 3)
    hat = basis @ np.linalg.pinv(
        basis
    )  # (window, window): row i gives the parabola at place i of the window
    windows = np.lib.stride_tricks.sliding_window_view(values, _WINDOW)
    return np.concatenate(
        [hat[:half] @ windows[0], windows @ hat[half], hat[half + 1 :] @ windows[-1]]
    )


def _shapes(
    test: CircularTest, diagnosis: Diagnosis | None, rng: np.random.Generator, draws: int
) -> list[FloatArray]:
    """Return, for each run, (draws, n) mm: what the uncertainty of the causes of both tests may
    add.
    """
    if diagnosis is None:
        return [np.zeros((draws, run.angles.size)) for run in test.runs]
    known = _columns(test, test.runs[0])
    by_end = {name.split("_at_")[0] for name in diagnosis.names if "_at_" in name}
    names = [
        name
        for name in diagnosis.names
        if name in known and name not in diagnosis.undetermined and name not in by_end
    ]
    order = [diagnosis.names.index(name) for name in names]
    errors = np.array([diagnosis.effects[name].std_error for name in names])
    covariance = (
        _BOTH_TESTS * diagnosis.correlation[np.ix_(order, order)] * np.outer(errors, errors)
    )
    values, vectors = np.linalg.eigh(covariance)
    # The symmetric root is the only one: signs and order of eigenvectors hang on the processor.
    root = (vectors * np.sqrt(np.maximum(values, 0.0))) @ vectors.T
    drawn = rng.standard_normal((draws, len(names))) @ root
    samples = sum(run.angles.size for run in test.runs)
    independent = samples / max(diagnosis.correlation_length, 1.0)
    mean = (
        diagnosis.residual * np.sqrt(_BOTH_TESTS / independent) * rng.standard_normal((draws, 1))
    )  # of the radius, mm
    shapes = []
    for run in test.runs:
        columns = _columns(test, run)
        shapes.append(
            mean
            + drawn
            @ np.array([columns[name] for name in names]).reshape(len(names), run.angles.size)
        )
    return shapes


def _columns(test: CircularTest, run: CircularRun) -> Mapping[str, FloatArray]:
    """Return the radial deviation (n,) mm of one unit of each cause, first order (the table of the
    circular test's model).
    """
    theta, d = np.radians(run.angles), 1.0 if run.sense == "ccw" else -1.0
    cos, sin = np.cos(theta), np.sin(theta)
    radius, speed = test.nominal_radius, test.feed / 60.0
    lost_first, lost_second = (
        0.5 * _UM * d * np.sign(sin) * cos,
        -0.5 * _UM * d * np.sign(cos) * sin,
    )
    return {
        "squareness": -0.5 * _PPM * radius * np.sin(2.0 * theta),
        "scale_mismatch": 0.25 * _UM * np.cos(2.0 * theta),
        "backlash_first": lost_first,
        "backlash_second": lost_second,
        "backlash_first_at_positive": np.where(cos > 0.0, lost_first, 0.0),
        "backlash_first_at_negative": np.where(cos > 0.0, 0.0, lost_first),
        "backlash_second_at_positive": np.where(sin > 0.0, lost_second, 0.0),
        "backlash_second_at_negative": np.where(sin > 0.0, 0.0, lost_second),
        "servo_mismatch": 0.5e-3 * d * speed * np.sin(2.0 * theta),
        "lateral_play_first": -0.5 * _UM * d * np.abs(sin),
        "lateral_play_second": 0.5 * _UM * d * np.abs(cos),
        "straightness_first": _UM * cos**2 * sin,
        "straightness_second": _UM * sin**2 * cos,
        "radius_change": _UM * d * np.ones_like(theta),
    }
