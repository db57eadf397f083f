"""A value with its standard error: whether values differ, and whether a correction could make an
error larger.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import erfc, sqrt
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.words.sentences import Sentence, say

#: An effect smaller than this many standard errors is not corrected, two values further apart than
#: this disagree (95 %).
SIGNIFICANT = 2.0
#: Standard deviations, as of a normal distribution, beyond which measurements contradict each
#: other: one consistent machine in a thousand, because nothing is decided then.
CONTRADICTORY = 3.09
#: A correction that is more often worse than no correction is a doubt: one in a thousand. A value
#: of four standard errors, the least that is corrected, is so in one of 44; one of six in one of
#: 740.
_WORSE: Final = 1e-3


@dataclass(frozen=True, slots=True)
class ValueWithError:
    """A value and its standard error: mm for lost motion, mm/mm for scale."""

    value: float
    std_error: float

    def differs(self, other: ValueWithError) -> bool:
        """Return whether the difference of two values is larger than their uncertainties allow."""
        return abs(self.value - other.value) > SIGNIFICANT * float(
            np.hypot(self.std_error, other.std_error)
        )

    def words(self, factor: float, unit: str) -> Sentence:
        """Return the value as text with its standard error, both multiplied by ``factor`` into
        ``unit``.
        """
        error, least = self.std_error * factor, 1 if unit == "µm/m" else 2
        # So many that the error does not round to zero, if three decimals are enough.
        decimals = next((each for each in range(least, 4) if round(error, each)), least)
        value = self.value * factor
        return say("value_with_error", value=value, error=error, unit=unit, decimals=decimals)


def contradictory(scatter: float, free: float) -> bool:
    """Return whether several values contradict each other, from the weighted sum of squares
    ``scatter`` with ``free`` degrees of freedom.

    The cube root of chi-square is nearly normal (Wilson and Hilferty, Proceedings of the National
    Academy of Sciences 17, 1931).
    """
    share = 2.0 / (9.0 * free)
    return bool(np.cbrt(scatter / free) - (1.0 - share) > CONTRADICTORY * np.sqrt(share))


def weighted_mean(values: Sequence[ValueWithError]) -> tuple[ValueWithError, bool]:
    """Return the weighted mean of several values of the same error, and whether they contradict
    each other, so that the mean is right for none.

    The error of values that scatter more grows with it (Birge, Physical Review 40, 1932).
    """
    each, errors = np.array([(one.value, one.std_error) for one in values]).T
    weights = errors**-2.0
    mean = float(np.average(each, weights=weights))
    scatter, free = float(np.sum(weights * (each - mean) ** 2)), len(values) - 1
    worse = np.sqrt(max(scatter / free, 1.0)) if free else 1.0
    error = float(worse / np.sqrt(np.sum(weights)))
    return ValueWithError(mean, error), bool(free) and contradictory(scatter, free)


def worse_doubts(
    value: float, std_error: float, axes: tuple[str, ...], plane: str = ""
) -> tuple[Finding, ...]:
    """Return the doubt that a correction by ``value`` (µm/m) makes the error larger; an empty tuple
    if this is improbable. The value is the squareness of a ``plane`` or, without a plane, the scale
    error of an axis.

    The error becomes larger if the true value is below half of ``value``: then the correction
    leaves a larger error of opposite sign. The errors of ``value`` are assumed to be normal, and
    nothing else is assumed about the machine.
    """
    chance = 0.5 * erfc(0.5 * abs(value) / (sqrt(2.0) * std_error))
    if chance <= _WORSE:
        return ()
    return (
        Finding.of("CW-P166", "warning", axes, axis=axes[-1], plane=plane, percent=100.0 * chance),
    )
