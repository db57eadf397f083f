"""The next positioning test: drawn from the posterior of the error, the changed table and fresh
noise; and decided upon.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from compwright.evaluation.decision import Decision
from compwright.evaluation.statistics import parameters, vdi_parameters
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import FloatArray
from compwright.records.prediction import Quantiles

__all__ = ["Quantiles", "decide_prediction", "dithered_targets", "predict_test"]

_DITHER: Final = 0.3  # of the mean spacing, either way (outside contract, JSON of `run`)
_LARGEST_MARGIN: Final = 0.25  # of the travel: a shorter axis cannot keep more from both ends


def predict_test(
    draws_positive: FloatArray,
    draws_negative: FloatArray,
    noise: FloatArray,
    *,
    runs_positive: int | FloatArray,
    runs_negative: int | FloatArray,
    change_positive: FloatArray,
    change_negative: FloatArray,
    coverage: float,
    rng: np.random.Generator,
    vdi: bool = False,
) -> Mapping[str, Quantiles]:
    """Return the quantiles of the parameters of a fresh test at m targets after a change of the
    correction.

    ``draws_positive``, ``draws_negative`` (s, m): s joint draws of the deviation in the state that
    was measured, + and -; ``noise`` (s,): standard deviation of a single reading, drawn with them;
    ``change_*`` (m,): new minus old correction at the targets. All in one unit (mm or deg), which
    is the result's. ``runs_*``: readings per target, one number or (m,); 0: the direction is not
    measured. ``coverage`` is the k of the standard (2 or 3).

    Each draw is one test of its own: the means of n readings scatter by noise / sqrt(n), their s by
    the chi-square law with n - 1 degrees of freedom. A new datum of the instrument moves all
    readings alike and no parameter depends on it. Only the parameters that such a test has are in
    the result, by their contract names (``A``, ``E_positive``, ...; with ``vdi`` those of VDI
    3441): none that needs a direction which is not measured, none that needs s when n = 1.
    """
    mean_positive, s_positive = _fresh_readings(
        draws_positive + change_positive, noise, runs_positive, rng
    )
    mean_negative, s_negative = _fresh_readings(
        draws_negative + change_negative, noise, runs_negative, rng
    )
    if vdi:
        values = vdi_parameters(mean_positive, s_positive, mean_negative, s_negative)
    else:
        values = parameters(mean_positive, s_positive, mean_negative, s_negative, coverage)
    return {name: _quantiles(draws) for name, draws in values.items() if np.all(np.isfinite(draws))}


def _fresh_readings(
    deviation: FloatArray, noise: FloatArray, runs: int | FloatArray, rng: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    """Return mean and s (s, m) of ``runs`` readings about ``deviation`` (s, m), drawn from their
    exact laws.

    NaN where there is no mean (n = 0) or no s (n < 2). Mean and s of normal readings are
    independent, so the readings themselves need not be drawn.
    """
    n = np.broadcast_to(np.asarray(runs, dtype=np.float64), deviation.shape)
    sigma = noise[:, np.newaxis]
    measured, repeated = n > 0.0, n > 1.0
    mean = deviation + sigma * rng.standard_normal(deviation.shape) / np.sqrt(
        np.where(measured, n, 1.0)
    )
    degrees = np.where(repeated, n - 1.0, 1.0)
    s = sigma * np.sqrt(rng.chisquare(degrees) / degrees)
    return np.where(measured, mean, np.nan), np.where(repeated, s, np.nan)


def _quantiles(draws: FloatArray) -> Quantiles:
    p05, median, p95 = np.quantile(draws, [0.05, 0.5, 0.95])
    return Quantiles(median=float(median), p05=float(p05), p95=float(p95))


def dithered_targets(
    travel: tuple[float, float], count: int, rng: np.random.Generator, margin: float = 4.0
) -> FloatArray:
    """Return ``count`` new targets (count,), ascending: the i-th (from 0) at low + (i + 0.5 + u) *
    length / count, u in ±0.3.

    Targets stay ``margin`` (mm; for rotary axes give it in deg) away from the ends of the travel,
    or a quarter of the travel where that is less. Where the margin takes up a whole interval, the
    same rule is applied to the travel between the margins. Raises UsageError for a travel that does
    not ascend or fewer than one target.
    """
    low, high = travel
    if not low < high or count < 1:
        raise UsageError(
            Fault(
                message="no targets can be placed",
                expected="a travel that ascends and at least one target",
                found=f"{low:g}:{high:g}, {count} targets",
            )
        )
    length = high - low
    kept = min(max(margin, 0.0), _LARGEST_MARGIN * length)
    places = np.arange(count) + 0.5 + rng.uniform(-_DITHER, _DITHER, count)
    targets = np.clip(low + places * length / count, low + kept, high - kept)
    if count > 1 and not np.all(np.diff(targets) > 0.0):
        targets = low + kept + places * (length - 2.0 * kept) / count
    return targets


def decide_prediction(quantiles: Quantiles, limit: float, guard: float = 0.0) -> Decision:
    """Return accept if p95 + guard <= limit, reject if p05 - guard > limit, else undecided; all in
    the unit of the quantiles.

    ``guard``: the expanded uncertainty of the measurement under the decision rule ``guarded`` (ISO
    14253-1), else 0. The quantiles hold what a repeated test may show, not what its instrument may
    be off by.
    """
    if quantiles.p95 + guard <= limit:
        return "accept"
    return "reject" if quantiles.p05 - guard > limit else "undecided"
