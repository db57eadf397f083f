"""Prediction of the next circular test: the measured path is displaced by the change of the tables,
and new noise is simulated.

The measured path contains every error of the machine at the place of the circle, so no error has to
be modelled to predict the change. The random parts of a new test are drawn: the path from the
uncertainty of the diagnosis, and the noise from the spectrum of its residuals. The measured samples
themselves are not used as the path. The largest of them contain the noise of their own test, and
with new noise in addition the predicted range would be too large.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np

from compwright.evaluation.circular import circle_parameters
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularResult, CircularRun, CircularTest, Diagnosis
from compwright.records.prediction import CirclePrediction, Quantiles
from compwright.records.rounding import rounded_number

__all__ = ["CirclePath", "commanded_path", "moved_test", "predict_circle"]

#: Samples over which the path is taken as a parabola: 2.6° of a usual ballbar's 1500, well within
#: the decay of a reversal spike.
_WINDOW: Final = 11
#: Share of independent noise that the parabola keeps in the middle of its window.
_SHARE: Final = 89.0 / 429.0
#: Median and the ends of a 90 % interval of a normal distribution, in standard deviations.
_NINETY: Final = 1.645
#: A part of the residuals that wanders may be noise or a shape of the machine that no cause has:
#: one test cannot tell. In so many draws it stays as it is.
_STAYS: Final = 0.5
#: A parameter of a fresh test differs from the same one of the last test by the errors of both.
_BOTH_TESTS: Final = 2.0


@dataclass(frozen=True, slots=True)
class CirclePath:
    """Commanded positions (n,) mm of both axes in a run, in machine coordinates, and the direction
    of motion (n,) of each axis.

    The direction changes where the command reverses. An axis that lags reverses later, by less than
    a sample.
    """

    first: FloatArray
    second: FloatArray
    moves_first: FloatArray
    moves_second: FloatArray


#: What moves the tool at a path: (n, 2) mm along the first and the second axis.
Displacement = Callable[[CirclePath], FloatArray]


def commanded_path(test: CircularTest, run: CircularRun, centre: tuple[float, float]) -> CirclePath:
    """Return the commanded positions of both axes for ``run`` of ``test`` about ``centre`` (mm,
    machine coordinates).
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
    """Return the test that would have been measured if every point of the path had been moved by
    the ``displacement`` that belongs to the point.

    The displacement at the centre of the circle, averaged over both directions of motion, is left
    out, because the instrument is set up anew there. The moved distance from the centre is exact;
    the angle of each point stays the commanded one.
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
        point = point + displacement(commanded_path(test, run, centre)) - in_centre
        runs.append(
            replace(run, deviations=np.hypot(point[:, 0], point[:, 1]) - test.nominal_radius)
        )
    return replace(test, runs=tuple(runs))


def predict_circle(
    before: CircularResult, expected: CircularResult, rng: np.random.Generator, draws: int
) -> CirclePrediction:
    """Return the prediction for a repetition of the circular test ``before``, made from ``draws``
    simulated tests. ``expected``: the result of ``before``, recalculated with the changed tables.

    Parameters come from ``draws`` tests with fresh noise. Causes are linear in the readings, so
    their prediction follows from the standard errors of both tests. A parameter that ``before``
    does not have is left out. Predicted amplitudes are never below zero. Nothing is predicted where
    the causes are unknown: the path of a new test is then unknown as well.
    """
    test, diagnosis = expected.test, expected.diagnosis
    if diagnosis is None:
        return CirclePrediction(before=before, expected=expected, predicted={}, causes={})
    rows: dict[str, list[float]] = {}
    for deviations in _fresh_tests(test, diagnosis, rng, draws):
        runs = tuple(
            replace(run, deviations=each) for run, each in zip(test.runs, deviations, strict=True)
        )
        simulated = circle_parameters(replace(test, runs=runs), expected.standard)
        for name, value in simulated.items():
            if value is not None and before.parameters.get(name) is not None:
                rows.setdefault(name, []).append(value)
    return CirclePrediction(
        before=before,
        expected=expected,
        predicted={name: _quantiles(np.array(values)) for name, values in rows.items()},
        causes=dict(_causes(diagnosis)),
    )


def _quantiles(values: FloatArray) -> Quantiles:
    # The next of n + 1 tests is below the k-th of n with the probability k / (n + 1).
    p05, median, p95 = np.quantile(values, [0.05, 0.5, 0.95], method="weibull")
    return Quantiles(
        median=rounded_number(median), p05=rounded_number(p05), p95=rounded_number(p95)
    )


def _causes(diagnosis: Diagnosis) -> Iterator[tuple[str, Quantiles]]:
    for name, effect in diagnosis.effects.items():
        if name in diagnosis.undetermined:
            continue
        reach = _NINETY * float(np.sqrt(_BOTH_TESTS)) * effect.std_error
        least = 0.0 if effect.low is not None else -np.inf
        yield name, Quantiles(effect.value, max(effect.value - reach, least), effect.value + reach)


def _smoothed(run: CircularRun) -> FloatArray:
    """Return the deviations (n,) mm of a run, smoothed by parabolas over `_WINDOW` samples.

    The windows stop at the reversal points (multiples of 90°), where the path may step.
    """
    quadrant = np.floor(run.angles / 90.0)
    edges = [0, *(np.flatnonzero(np.diff(quadrant)) + 1), run.angles.size]
    pieces = [_parabolas(run.deviations[low:high]) for low, high in pairwise(edges)]
    return np.concatenate(pieces)


def _parabolas(values: FloatArray) -> FloatArray:
    """Smooth n equally spaced values: each is replaced by the value of a parabola fitted to its
    `_WINDOW` neighbours. With fewer values nothing is changed.
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


def _fresh_tests(
    test: CircularTest, diagnosis: Diagnosis, rng: np.random.Generator, draws: int
) -> Iterator[list[FloatArray]]:
    """Yield the deviations (n,) mm of every run for each of ``draws`` simulated tests. The
    simulated path is the path fitted by the ``diagnosis``; if that has none it is the smoothed
    measured path.
    """
    fresh = diagnosis.fresh()
    paths = [
        _along(run, each.angles, each.paths)
        for run, each in zip(test.runs, fresh, strict=bool(fresh))
    ] or [_smoothed(run)[np.newaxis] for run in test.runs]
    rest = [
        replace(run, deviations=run.deviations - np.mean(path, axis=0))
        for run, path in zip(test.runs, paths, strict=True)
    ]
    slow = [_smoothed(run) for run in rest]
    # A smoothing over m samples takes its own share of the noise out of the residuals.
    quick = [
        (run.deviations - curve) / np.sqrt(1.0 - _SHARE)
        for run, curve in zip(rest, slow, strict=True)
    ]
    noise = [
        _along(run, each.angles, each.noise)
        for run, each in zip(test.runs, fresh, strict=bool(fresh))
    ]
    for draw in range(draws):
        stays = not fresh or rng.random() < _STAYS
        place = int(rng.integers(len(paths[0])))
        found = []
        for number, path in enumerate(paths):
            deviations = path[draw % len(path)] + (slow[number] if stays else noise[number][place])
            # Samples that were thinned for the fit have quick noise that its spectra do not hold.
            if stays or fresh[number].angles.size < deviations.size:
                again = np.roll(quick[number], int(rng.integers(deviations.size)))
                deviations = deviations + rng.choice([-1.0, 1.0]) * again
            found.append(deviations)
        yield found


def _along(run: CircularRun, angles: FloatArray, rows: FloatArray) -> FloatArray:
    """Interpolate each of the curves ``rows`` (d, m), given at ``angles`` (m,), at the angles of
    ``run``.
    """
    if run.angles.size == angles.size:
        return rows
    order = np.argsort(angles)
    return np.array([np.interp(run.angles, angles[order], row[order]) for row in rows])
