"""The formulas of ISO 230-2 clause 2 on plain arrays: means, standard deviations, parameters.

In means and s, the last dimension of the array is the target. In deviations, it is the reading. Any
further dimensions may come before. Results have the unit of the input (mm or deg inside
compwright). A missing reading is NaN, and so is every parameter that needs it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import FloatArray

#: ISO 230-2:1988 table 1: s = W / k, here as the factor 1 / k by the number n of readings.
RANGE_FACTORS_1988: Final[Mapping[int, float]] = {
    n: 1.0 / k
    for n, k in {
        2: 1.128,
        3: 1.693,
        4: 2.059,
        5: 2.326,
        6: 2.534,
        7: 2.704,
        8: 2.847,
        9: 2.97,
        10: 3.078,
    }.items()
}

#: GOST 27843-2006 table 1: s = W * a_n. Its printed a_10 = 0.3429 is a misprint for 0.3249 (= 1 /
#: 3.078).
RANGE_FACTORS_GOST: Final[Mapping[int, float]] = {
    5: 0.4299,
    6: 0.3946,
    7: 0.3698,
    8: 0.3512,
    9: 0.3367,
    10: 0.3249,
}

#: Names that `parameters` returns, in the order of the contract.
ISO_NAMES: Final = (
    "A",
    "A_positive",
    "A_negative",
    "E",
    "E_positive",
    "E_negative",
    "M",
    "R",
    "R_positive",
    "R_negative",
    "B",
    "B_mean",
)
#: From so many values on numpy adds them up in several sums at once.
_MANY: Final = 8
#: Names that `vdi_parameters` returns.
VDI_NAMES: Final = ("P", "Ps_max", "Ps_mean", "Pa", "U_max", "U_mean")


def count_readings(deviations: FloatArray) -> FloatArray:
    """Return the number of readings (..., m) of deviations (..., m, n)."""
    counted: FloatArray = np.isfinite(deviations).sum(axis=-1).astype(np.float64)
    return counted


def mean_deviation(deviations: FloatArray) -> FloatArray:
    """Return the mean deviation (..., m) of deviations (..., m, n); NaN where there is no reading
    (ISO 230-2:1997, 2.10).
    """
    finite = np.isfinite(deviations)
    return _mean(np.where(finite, deviations, 0.0), finite.sum(axis=-1))


def standard_deviation(deviations: FloatArray) -> FloatArray:
    """Return s (..., m) with n - 1, n the number of readings of each target; NaN where n < 2 (ISO
    230-2:1997, 2.15).
    """
    return mean_and_deviation(deviations)[1]


def mean_and_deviation(deviations: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return `mean_deviation` and `standard_deviation` together, in one pass over the readings."""
    finite = np.isfinite(deviations)
    missing = not np.all(finite)
    # Adding up what is there takes as long as all the rest.
    number = finite.sum(axis=-1) if missing else np.full(finite.shape[:-1], finite.shape[-1])
    there = np.where(finite, deviations, 0.0) if missing else deviations
    mean = _mean(there, number)
    residual = there - mean[..., np.newaxis]
    if missing:
        residual[~finite] = 0.0
    residual *= residual
    squares = _total(residual)
    s: FloatArray = np.sqrt(
        np.divide(squares, number - 1, out=np.full(number.shape, np.nan), where=number > 1)
    )
    return mean, s


def _mean(values: FloatArray, number: NDArray[np.intp]) -> FloatArray:
    """Return the mean over ``number`` readings of values (..., n), which are 0 for a missing
    reading.
    """
    mean: FloatArray = np.divide(
        _total(values), number, out=np.full(number.shape, np.nan), where=number > 0
    )
    return mean


def _total(values: FloatArray) -> FloatArray:
    """Return the sum of values (..., n) over n. For small n a loop is faster than numpy, with the
    same bits.
    """
    if not 0 < values.shape[-1] < _MANY:
        return np.asarray(values.sum(axis=-1))
    total: FloatArray = values[..., 0].copy()
    for place in range(1, values.shape[-1]):
        total += values[..., place]
    return total


def standard_deviation_from_range(
    deviations: FloatArray, factors: Mapping[int, float]
) -> FloatArray:
    """Return s = W * factor(n) (..., m), W the range of the readings (ISO 230-2:1988, 2.9 b; GOST
    27843-2006, 3.15).

    ``factors``: the factor by number of readings n. The result is NaN where n < 2. Raises
    UsageError if ``factors`` lacks any other n that occurs.
    """
    finite = np.isfinite(deviations)
    number = finite.sum(axis=-1)
    unknown = sorted({int(n) for n in np.unique(number) if n > 1 and int(n) not in factors})
    if unknown:
        raise UsageError(
            Fault(
                message="the range method has no factor for this number of readings at a target",
                expected=f"{min(factors)} to {max(factors)} readings, or --spread std",
                found=", ".join(str(n) for n in unknown),
                hint="give `--spread std`",
            )
        )
    largest = np.where(finite, deviations, -np.inf).max(axis=-1, initial=-np.inf)
    smallest = np.where(finite, deviations, np.inf).min(axis=-1, initial=np.inf)
    s = np.full(number.shape, np.nan)
    for n, factor in factors.items():
        s = np.where(number == n, (largest - smallest) * factor, s)
    return s


def repeatability(
    reversal: FloatArray, s_positive: FloatArray, s_negative: FloatArray, coverage: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return R_i+, R_i- and R_i (..., m) for coverage k: R_i = max(k s+ + k s- + abs(B_i); 2k s+;
    2k s-).

    Source: ISO 230-2:2006, 2.16 and 2.17. The available copy of the 1997 edition prints R_i without
    abs(B_i), but its own table 2 includes it.
    """
    positive = 2.0 * coverage * s_positive
    negative = 2.0 * coverage * s_negative
    both = np.maximum(
        0.5 * (positive + negative) + np.abs(reversal), np.maximum(positive, negative)
    )
    return positive, negative, both


def parameters(
    mean_positive: FloatArray,
    s_positive: FloatArray,
    mean_negative: FloatArray,
    s_negative: FloatArray,
    coverage: float,
    only: str | None = None,
) -> dict[str, FloatArray]:
    """Return the axis parameters of ISO 230-2:2006, 2.13 to 2.24, each (...), from means and s
    (..., m). ``coverage``: the factor k, 2 or 3. ``only``: the single parameter to return; None:
    all.

    B_i = mean+ - mean-, so lost motion gives a negative ``B_mean``. ``R`` is the largest R_i, not
    the larger of R+ and R-. The unit is that of the input. NaN in means or s makes only those
    parameters NaN that depend on it. The available copy of the 1997 edition prints A+ with max(x +
    2s) - min(x + 2s). Corrigendum 1:1999 and the edition of 2006 have min(x - 2s).
    """
    plus = _DirectionStatistics(mean_positive, s_positive, coverage)
    minus = _DirectionStatistics(mean_negative, s_negative, coverage)
    reversal = mean_positive - mean_negative

    def r() -> FloatArray:
        return repeatability(reversal, s_positive, s_negative, coverage)[2]

    formulas: dict[str, Callable[[], FloatArray]] = {
        "A": lambda: np.maximum(plus.upper, minus.upper) - np.minimum(plus.lower, minus.lower),
        "A_positive": lambda: plus.upper - plus.lower,
        "A_negative": lambda: minus.upper - minus.lower,
        "E": lambda: (
            np.maximum(plus.highest, minus.highest) - np.minimum(plus.lowest, minus.lowest)
        ),
        "E_positive": lambda: plus.highest - plus.lowest,
        "E_negative": lambda: minus.highest - minus.lowest,
        "M": lambda: _range(0.5 * (mean_positive + mean_negative)),
        "R": lambda: r().max(axis=-1),
        "R_positive": lambda: (2.0 * coverage * s_positive).max(axis=-1),
        "R_negative": lambda: (2.0 * coverage * s_negative).max(axis=-1),
        "B": lambda: np.abs(reversal).max(axis=-1),
        "B_mean": lambda: reversal.mean(axis=-1),
    }
    return {name: made() for name, made in formulas.items() if only in (None, name)}


class _DirectionStatistics:
    """Means and s (..., m) of one direction, with their extremes (...) over the targets."""

    def __init__(self, mean: FloatArray, s: FloatArray, coverage: float) -> None:
        self.mean, self.s, self.coverage = mean, s, coverage

    @cached_property
    def upper(self) -> FloatArray:
        """The largest value of mean + k s."""
        return np.asarray((self.mean + self.coverage * self.s).max(axis=-1))

    @cached_property
    def lower(self) -> FloatArray:
        """The smallest value of mean - k s."""
        return np.asarray((self.mean - self.coverage * self.s).min(axis=-1))

    @cached_property
    def highest(self) -> FloatArray:
        """The largest mean."""
        return np.asarray(self.mean.max(axis=-1))

    @cached_property
    def lowest(self) -> FloatArray:
        """The smallest mean."""
        return np.asarray(self.mean.min(axis=-1))


def _range(values: FloatArray) -> FloatArray:
    return np.asarray(values.max(axis=-1) - values.min(axis=-1))


def vdi_positional_scatter(s_positive: FloatArray, s_negative: FloatArray) -> FloatArray:
    """Return Ps_i = 6 (s+ + s-) / 2 (..., m) of VDI/DGQ 3441."""
    scatter: FloatArray = 3.0 * (s_positive + s_negative)
    return scatter


def vdi_parameters(
    mean_positive: FloatArray,
    s_positive: FloatArray,
    mean_negative: FloatArray,
    s_negative: FloatArray,
) -> dict[str, FloatArray]:
    """Return the parameters of VDI/DGQ 3441, each (...), from means and s (..., m), in the unit of
    the input.

        U_i = abs(B_i)
        Ps_i = 6 (s+ + s-)/2
        Pa = range of mean_i, the means of both directions
        P = max[mean_i + (U_i + Ps_i)/2] - min[mean_i - (U_i + Ps_i)/2]

    The text of VDI/DGQ 3441 was not available. The formulas are those in common use by laser
    software.
    """
    play = np.abs(mean_positive - mean_negative)
    scatter = vdi_positional_scatter(s_positive, s_negative)
    middle = 0.5 * (mean_positive + mean_negative)
    half = 0.5 * (play + scatter)
    return {
        "P": (middle + half).max(axis=-1) - (middle - half).min(axis=-1),
        "Ps_max": scatter.max(axis=-1),
        "Ps_mean": scatter.mean(axis=-1),
        "Pa": middle.max(axis=-1) - middle.min(axis=-1),
        "U_max": play.max(axis=-1),
        "U_mean": play.mean(axis=-1),
    }
