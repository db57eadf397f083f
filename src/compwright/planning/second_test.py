"""Findings about what one test of an axis leaves open and a second test would decide.

There is a finding for each of three properties of the noise of one test: a drift that may not
repeat, readings that may lie between two limits (two places of rest) instead of around one value,
and a scatter that differs between the runs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.noise_readings import cell_readings, without_traverse_lines
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axis_work import AxisWork
from compwright.planning.predicted_gain import judged_parameter
from compwright.planning.simulated_repeat_tests import FreshTests, generator
from compwright.prediction.active_corrections import Correction, difference
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import BoolArray, NoiseDraws
from compwright.records.positioning import PositioningTest
from compwright.words.sentences import Amount, Sentence, say

#: A property is there from this probability; its absence from the same one.
_CERTAIN: Final = 0.9
#: A change of the parameter counts from this part of it.
_MATTERS: Final = 0.1
#: Where the scatter of the runs is equal, one test in a thousand exceeds this normal quantile.
_DIFFERS: Final = 3.09
#: Steps of the estimate of the scatter of each run.
_ROUNDS: Final = 30


def second_test_findings(work: AxisWork, new: Correction, fresh: FreshTests) -> Iterator[Finding]:
    """Yield the finding CW-P165 for each property of the noise that only a second test can show,
    with the parameter of the simulated tests ``fresh`` with and without this property.
    """
    name, result = judged_parameter(work.results[0]), work.results[0].test
    if name is None or len(work.posterior.alike) != 1:
        return
    change, axis = difference(new, work.active), work.planned.axis
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    for seen, otherwise, one, other in _open_properties(result, fresh.draws.noise):
        same = fresh.with_noise(one).quantiles(change, only=name)[name]
        apart = fresh.with_noise(other).quantiles(change, only=name)[name]
        moved = max(abs(same.p05 - apart.p05), abs(same.p95 - apart.p95))
        if moved < _MATTERS * abs(same.median):
            continue
        yield Finding.of(
            "CW-P165",
            "info",
            axis=axis.name,
            seen=seen,
            parameter=name,
            low=same.p05 * factor,
            high=same.p95 * factor,
            otherwise=otherwise,
            least=apart.p05 * factor,
            most=apart.p95 * factor,
            unit=unit,
        )


def _open_properties(
    test: PositioningTest, noise: NoiseDraws
) -> Iterator[tuple[Sentence, Sentence, NoiseDraws, NoiseDraws]]:
    """Yield, for each property of the noise that one test leaves open: what the test shows, the
    other possibility, and the noise of a new test in each of these two cases.
    """
    rng = generator(test.axis, test.name, "another day")
    if np.mean(noise.drift != 0.0) >= _CERTAIN:
        share = rng.standard_normal(noise.count)
        yield (
            say("CW-P165.drift", drift=_amount(float(np.median(np.abs(noise.drift))), test.kind)),
            say("CW-P165.other_drift"),
            noise,
            replace(noise, drift=share * noise.drift, drift_tilt=share * noise.drift_tilt),
        )
    light = noise.core < 1.0
    probability = float(np.mean(light))
    if 1.0 - _CERTAIN <= probability <= _CERTAIN:
        yield (
            say("CW-P165.rest", probability=probability),
            say("CW-P165.no_rest"),
            _only(noise, light),
            _only(noise, ~light),
        )
    stds = unequal_scatter(test)
    if stds is not None:
        ratios = stds / np.sqrt(np.mean(stds**2))
        factors = rng.choice(ratios, noise.count)[:, np.newaxis]
        least, most = (_amount(float(one), test.kind) for one in (np.min(stds), np.max(stds)))
        yield (
            say("CW-P165.scatter", least=least, most=most),
            say("CW-P165.other_scatter"),
            noise,
            replace(noise, sigma=noise.sigma * factors),
        )


def _only(noise: NoiseDraws, chosen: BoolArray) -> NoiseDraws:
    """Return the ``chosen`` (count,) draws of the noise, repeated so that the number of draws is
    unchanged.
    """
    places = np.flatnonzero(chosen)
    return noise.taken(places[np.arange(noise.count) * places.size // noise.count])


def unequal_scatter(test: PositioningTest) -> FloatArray | None:
    """Return the standard deviation of a reading in each run (n,), mm or deg, or None if the runs
    do not clearly differ.

    Absolute residuals are ranked within their target (Brown and Forsythe, J. Am. Stat. Assoc. 69,
    1974), because runs with equal scatter could be exchanged there (Friedman, J. Am. Stat. Assoc.
    32, 1937). The sums over the targets then follow chi-squared with n - 1 degrees of freedom, in
    the approximation of Wilson and Hilferty (Proc. Natl. Acad. Sci. 17, 1931). An offset and a tilt
    of each traverse are removed first.
    """
    readings = cell_readings(test)
    n = readings.runs
    whole = np.all(readings.there, axis=1)
    if n < 3 or np.count_nonzero(whole) < 2 * n:
        return None
    means = np.mean(readings.values, axis=1, keepdims=True)
    residuals = without_traverse_lines(readings, readings.values - means)[whole]
    left = np.abs(residuals)
    sums = np.sum(left, axis=0)
    part = 2.0 / (9.0 * (n - 1))
    limit = (n - 1) * (1.0 - part + _DIFFERS * np.sqrt(part)) ** 3
    if float(np.sum((sums - np.mean(sums)) ** 2)) <= limit * np.sum(np.var(left, axis=1, ddof=1)):
        return None
    stds = _stds_of_runs(residuals)
    return stds if np.any(stds) else None  # equal runs differ by rounding alone


def _stds_of_runs(residuals: FloatArray) -> FloatArray:
    """Return the standard deviation (n,) of the ``residuals`` (c, n) in each run.

    The mean of each target is unknown, so it is estimated too (EM algorithm: Dempster, Laird and
    Rubin, J. R. Stat. Soc. B 39, 1977). Mean absolute values are used, because outliers change them
    less.
    """
    variances = np.full(residuals.shape[1], float(np.var(residuals)))
    for _ in range(_ROUNDS):
        total = np.sum(1.0 / variances)
        means = residuals @ (1.0 / variances) / total
        size = np.mean(np.abs(residuals - means[:, np.newaxis]), axis=0)
        variances = 0.5 * np.pi * size**2 + 1.0 / total
    found: FloatArray = np.round(np.sqrt(variances), 9)
    return found


def _amount(value: float, kind: AxisKind) -> Amount:
    return Amount(value * outside_factor(kind.unit), shown_unit(kind.unit))
