"""Prediction of the next positioning test from simulated tests, and the decision about its limits.

The simulated tests are drawn from the posterior of the error, the changed table and fresh noise.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from compwright.evaluation.decision import Decision
from compwright.evaluation.statistics import parameters, vdi_parameters
from compwright.foundations.errors import Fault, UsageError
from compwright.prediction.fresh_scatter import FreshScatter
from compwright.records.axis import FloatArray
from compwright.records.prediction import Quantiles
from compwright.records.rounding import rounded_number

__all__ = [
    "Quantiles",
    "decide_prediction",
    "dithered_targets",
    "fresh_parameters",
    "fresh_slopes",
    "predict_test",
]

_DITHER: Final = 0.3  # of the mean spacing, either way (outside contract, JSON of `run`)
_LARGEST_MARGIN: Final = 0.25  # of the travel: a shorter axis cannot keep more from both ends


def predict_test(
    draws_positive: FloatArray,
    draws_negative: FloatArray,
    scatter: FreshScatter,
    *,
    change_positive: FloatArray,
    change_negative: FloatArray,
    coverage: float,
    vdi: bool = False,
    only: str | None = None,
) -> Mapping[str, Quantiles]:
    """Return the predicted quantiles of each parameter (with ``only``: of that parameter alone) of
    a repeated test after the correction was changed by ``change_*``. With ``vdi`` the parameters
    are those of VDI 3441.

    ``draws_positive``, ``draws_negative`` (s, m): s joint draws of the deviation in the measured
    state, in + and -. ``scatter``: what the readings of a fresh test add to each draw
    (`fresh_scatter`). ``change_*`` (m,): new minus old correction at the targets. All are in one
    unit (mm or deg), which is also the unit of the result. ``coverage``: the k of the standard (2
    or 3).

    Each draw is one test of its own. A new datum of the instrument moves all readings equally, and
    no parameter depends on it. The result has only the parameters that such a test has, by their
    contract names (``A``, ``E_positive``, ...; with ``vdi`` those of VDI 3441). Parameters of a
    direction that is not measured are left out, and for n = 1 those that need s.
    """
    values = fresh_parameters(
        draws_positive + change_positive,
        draws_negative + change_negative,
        scatter,
        coverage=coverage,
        vdi=vdi,
        only=only,
    )
    return {name: _quantiles(draws) for name, draws in values.items() if only in (None, name)}


def fresh_parameters(
    positive: FloatArray,
    negative: FloatArray,
    scatter: FreshScatter,
    *,
    coverage: float,
    vdi: bool = False,
    only: str | None = None,
) -> dict[str, FloatArray]:
    """Return the values (s,) of each parameter (with ``only``: of that parameter of ISO 230-2
    alone) in s simulated tests, by the parameter's name in the JSON. With ``vdi`` the parameters
    are those of VDI 3441.

    ``positive``, ``negative`` (s, m): the deviations of the simulated axes. Parameters that such a
    test does not have are left out.
    """
    means = (positive + scatter.mean_positive, negative + scatter.mean_negative)
    if vdi:
        values = vdi_parameters(means[0], scatter.s_positive, means[1], scatter.s_negative)
    else:
        spread = scatter.s_positive, scatter.s_negative
        values = parameters(means[0], spread[0], means[1], spread[1], coverage, only)
    return {name: draws for name, draws in values.items() if np.all(np.isfinite(draws))}


def fresh_slopes(
    positions: FloatArray, count: int, slope_std: float, rng: np.random.Generator
) -> FloatArray:
    """Return the deviations (count, m), mm, of ``count`` simulated tests that come from a
    temperature different from that of the measured test: a random slope over ``positions`` in each.

    ``positions``: (m,) or (count, m), mm. ``slope_std``: standard deviation of the slope (mm/mm),
    which is the same in both directions. The position at which the deviation is zero is arbitrary,
    because no parameter depends on it.
    """
    slopes = slope_std * rng.standard_normal((count, 1))
    deviations: FloatArray = slopes * (positions - np.mean(positions, axis=-1, keepdims=True))
    return deviations


def _quantiles(draws: FloatArray) -> Quantiles:
    p05, median, p95 = np.quantile(draws, [0.05, 0.5, 0.95])
    return Quantiles(
        median=rounded_number(median), p05=rounded_number(p05), p95=rounded_number(p95)
    )


def dithered_targets(
    travel: tuple[float, float], count: int, rng: np.random.Generator, margin: float = 4.0
) -> FloatArray:
    """Return ``count`` random new targets, ascending, one in each equal part of the travel, and
    none nearer to an end of the travel than ``margin`` (at most a quarter of the travel).

    The i-th target (from 0) is at low + (i + 0.5 + u) * length / count, with a random u within
    ±0.3. ``margin`` is in mm; for a rotary axis give it in deg. If the margin is as long as an
    interval, the same rule is applied to the travel between the margins. Raises UsageError if the
    travel does not ascend, or if ``count`` is less than one.
    """
    low, high = travel
    if not low < high or count < 1:
        raise UsageError(
            Fault(
                message="no target positions can be chosen on this travel",
                expected="a travel with its lower end first, and at least one target",
                found=f"{low:g}:{high:g}, {count} targets",
                hint="correct the travel or the number of targets",
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
    """Return the decision about a limit from the 5 and 95 % quantiles p05 and p95: accept if p95 +
    guard <= limit, reject if p05 - guard > limit, else undecided. All are in one unit.

    ``guard``: the expanded uncertainty of the measurement under the decision rule ``guarded`` (ISO
    14253-1), else 0. The quantiles contain what a repeated test may show, but not the error of its
    instrument.
    """
    if quantiles.p95 + guard <= limit:
        return "accept"
    return "reject" if quantiles.p05 - guard > limit else "undecided"
