"""Find the causes of the deviations of a circular test, each with its standard error.

Squareness and scale do not depend on the direction. Lost motion and lag change sign with the
direction. Lost motion contains the same harmonics as squareness. Therefore all causes are fitted at
once, with the exact distance that the bar measures. The standard errors take the correlation of the
residuals into account (``circle_noise``). Signs and units are those of ``circle_model``. The effect
of each cause on a circle is described in ISO 230-4:1996, annex B.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Final

import numpy as np

from compwright.estimation.circle_cyclic import (
    longest_pitch,
    shortest_pitch,
)
from compwright.estimation.circle_fit import (
    fitted_paths,
)
from compwright.estimation.circle_lag import common_lag
from compwright.estimation.circle_model import CircleSamples, circle_samples
from compwright.estimation.circle_noise import (
    angle_grid,
    inverse_cosine_transform,
)
from compwright.estimation.circle_path import undetermined_causes
from compwright.estimation.circle_plain import harmonic_regression
from compwright.estimation.circle_report import report_effects
from compwright.estimation.circle_search import solve, start_fit
from compwright.estimation.circle_solution import Solution
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.circular import (
    SHORTEST_ARC,
    CircularRun,
    CircularTest,
    Diagnosis,
    FittedRun,
    FreshRun,
)

#: Samples of one run below which the causes cannot be distinguished from the noise.
LEAST_SAMPLES: Final = 24
#: Standard errors from which a finding names a lag.
_CLEAR_LAG: Final = 2.0
#: Samples of one run that are fitted: several times those of the finest ballbar; more would take
#: time and memory, and tell no more.
MOST_SAMPLES: Final = 3_000
#: Samples of one run that a fitted run holds at most: for pictures.
_MOST_FITTED: Final = 1_000


def diagnose(test: CircularTest, *, periods: Mapping[str, float] | None = None) -> Diagnosis:
    """Return the causes of the deviations of a circular test (ISO 230-4:1996, annex B), with
    standard errors. Findings name the causes that cannot be separated.

    ``periods``: known pitch of a cyclic error, mm, by axis name. Axes without a known pitch are
    searched for one. If a run has more than `MOST_SAMPLES` samples, neighbouring samples are
    averaged first. The same test always gives the same result.

    Raises InputError for an arc that is too short or a run with too few samples, and UsageError for
    a wrong period.
    """
    _refuse(test, periods or {})
    every = circle_samples(test)
    averaged = -(-max(run.angles.size for run in test.runs) // MOST_SAMPLES)
    test = replace(test, runs=tuple(_average_neighbours(run, averaged) for run in test.runs))
    samples = replace(circle_samples(test), averaged=averaged)
    _refuse_few(test, samples)
    frequencies, findings = _visible_periods(test, samples, periods or {})
    measured, plain, grid = samples, harmonic_regression(samples), angle_grid(samples)
    solution = solve(start_fit(samples, grid, common_lag(every)), frequencies, every)
    samples = solution.problem.samples
    if samples.lag > _CLEAR_LAG * samples.lag_std:
        findings.append(_lag_finding(samples))
    reasons = undetermined_causes(test, samples)
    effects, correlation, undetermined, noticed = report_effects(test, solution, reasons)
    return Diagnosis(
        effects=effects,
        plain={name: plain[name] for name in effects if name in plain},
        names=tuple(effects),
        correlation=correlation,
        residual=float(np.sqrt(np.mean(solution.residual**2))),
        correlation_length=float(np.mean([s.length for s in solution.fitted.spectra])),
        findings=(*findings, *noticed),
        undetermined=undetermined,
        fitted=tuple(_fitted_runs(test, measured, solution.residual)),
        fresh=partial(_fresh_runs, test, solution),
    )


def _fresh_runs(test: CircularTest, solution: Solution) -> tuple[FreshRun, ...]:
    """Return a prediction for each run of a repeated circular test.

    The model contains no samples exactly at a reversal point. Their deviations are interpolated
    between neighbouring samples. The noise is drawn with the spectra of the residuals. For a test
    in both directions, the sum and the difference of the directions are drawn separately.
    """
    problem = solution.problem
    readings = fitted_paths(problem, solution.draws.sizes)
    readings += problem.samples.deviations - problem.target
    theta = problem.samples.commanded
    rng = np.random.default_rng(problem.target.size)
    where = (np.arange(problem.grid.size) + 0.5) * test.arc[1] / problem.grid.size
    drawn_halves = {
        number: [
            [
                inverse_cosine_transform(
                    np.sqrt(spectrum.density) * rng.standard_normal(problem.grid.size)
                )
                for spectrum in solution.fitted.spectra
            ]
            for _ in readings
        ]
        for number in dict.fromkeys(run.number for run in test.runs)
    }
    runs = []
    for index, run in enumerate(test.runs):
        mine = np.flatnonzero(problem.samples.run == index)
        at = mine[np.argsort(theta[mine])]
        paths = [np.interp(run.angles, np.degrees(theta[at]), each[at]) for each in readings]
        sign = 1.0 if run.sense == "ccw" else -1.0
        place = np.mod(run.angles - test.arc[0], 360.0)
        noise = [
            np.interp(
                place,
                where,
                halves[0] if len(halves) == 1 else (halves[0] + sign * halves[1]) / np.sqrt(2.0),
            )
            for halves in drawn_halves[run.number]
        ]
        runs.append(FreshRun(run.angles, np.array(paths), np.array(noise)))
    return tuple(runs)


def _fitted_runs(
    test: CircularTest, measured: CircleSamples, residual: FloatArray
) -> Iterator[FittedRun]:
    """Yield the fitted deviations and the residuals of each run, at the angles of the samples
    ``measured``.
    """
    for index, run in enumerate(test.runs):
        (mine,) = np.nonzero(measured.run == index)
        mine = mine[:: -(-mine.size // _MOST_FITTED)]
        yield FittedRun(
            sense=run.sense,
            number=run.number,
            angles=np.degrees(measured.theta[mine]),
            deviations=measured.deviations[mine] - residual[mine],
            residuals=residual[mine],
        )


def _average_neighbours(run: CircularRun, count: int) -> CircularRun:
    """Return a run whose samples are means of ``count`` neighbouring samples each. What is left at
    the end of the run is left out: a mean of fewer would show more of a vibration.
    """
    size = run.angles.size - run.angles.size % count
    angles, deviations = (
        np.mean(values[:size].reshape(-1, count), axis=1) for values in (run.angles, run.deviations)
    )
    return replace(run, angles=angles, deviations=deviations)


def _refuse(test: CircularTest, periods: Mapping[str, float]) -> None:
    faults = [
        Fault(
            message=f"a period of the error of axis {axis} must be positive",
            place=axis,
            found=f"{period:g}",
            expected="a length in mm",
            hint="give a positive period",
        )
        for axis, period in periods.items()
        if not (np.isfinite(period) and period > 0.0)
    ]
    faults += [
        Fault(
            message="a period is given for an axis that the test does not have",
            found=axis,
            expected=" or ".join(test.axes),
            hint="remove the period, or correct its axis",
        )
        for axis in periods
        if axis not in test.axes
    ]
    raise_all(UsageError, faults)
    wrong = []
    # Samples between which 90° lie span one of their distances less.
    count = max((run.angles.size for run in test.runs), default=0)
    if not test.arc[1] * (1.0 + 1.0 / max(count - 1, 1)) >= SHORTEST_ARC - 1e-6:
        wrong.append(
            Fault(
                message="the arc of the circular test is too short",
                file=test.name,
                expected="90 deg or more",
                found=f"{test.arc[1]:g} deg",
                hint="measure an arc of 90 deg or more",
            )
        )
    for name, value in (("nominal radius", test.nominal_radius), ("feed", test.feed)):
        if not (np.isfinite(value) and value > 0.0):
            wrong.append(
                Fault(
                    message=f"the {name} of the circular test must be positive",
                    file=test.name,
                    found=f"{value:g}",
                    hint=f"correct the {name} in the test",
                )
            )
    if not test.runs:
        wrong.append(
            Fault(
                message="the circular test contains no run",
                file=test.name,
                hint="give a test with at least one run",
            )
        )
    raise_all(InputError, wrong)
    if not all(
        np.all(np.isfinite(run.angles)) and np.all(np.isfinite(run.deviations)) for run in test.runs
    ):
        raise InputError(
            Fault(
                message="a run of the circular test has readings that are not numbers",
                file=test.name,
                hint="remove these samples, or measure again",
            )
        )


def _refuse_few(test: CircularTest, samples: CircleSamples) -> None:
    counts = [int(np.sum(samples.run == number)) for number in range(len(test.runs))]
    raise_all(
        InputError,
        [
            Fault(
                message="the run has too few samples away from the points where an axis reverses",
                file=test.name,
                place=f"{run.sense} run {run.number}",
                expected=f"{LEAST_SAMPLES} or more",
                found=str(count),
                hint="measure with more samples per run, or a larger arc",
            )
            for run, count in zip(test.runs, counts, strict=True)
            if count < LEAST_SAMPLES
        ],
    )


def _visible_periods(
    test: CircularTest, samples: CircleSamples, periods: Mapping[str, float]
) -> tuple[dict[str, float], list[Finding]]:
    """Return the given frequencies of cyclic errors, 1/mm, that the test can show, for the
    ``first`` and the ``second`` axis.
    """
    frequencies, findings = {}, []
    least, most = shortest_pitch(samples), longest_pitch(samples)
    for axis, period in periods.items():
        if least <= period <= most:
            frequencies["first" if axis == test.axes[0] else "second"] = 1.0 / period
        else:
            findings.append(
                Finding.of("CW-D009", "warning", period=period, axis=axis, least=least, most=most)
            )
    return frequencies, findings


def _lag_finding(samples: CircleSamples) -> Finding:
    time = 1e3 * samples.radius / samples.speed
    return Finding.of("CW-D011", "info", lag=time * samples.lag, error=time * samples.lag_std)
