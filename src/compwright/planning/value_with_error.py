"""A value with its standard error, and the test whether two values disagree."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.words.sentences import Sentence, say

#: An effect smaller than this many standard errors is not corrected, two values further apart than
#: this disagree (95 %).
SIGNIFICANT = 2.0
#: Standard deviations, as of a normal distribution, beyond which measurements contradict each
#: other: one consistent machine in a thousand, because nothing is decided then.
CONTRADICTORY = 3.09


@dataclass(frozen=True, slots=True)
class ValueWithError:
    """A value and its standard error: mm for lost motion, mm/mm for scale."""

    value: float
    std_error: float

    def differs(self, other: ValueWithError) -> bool:
        """Return whether two values differ by more than both of their uncertainties allow."""
        return abs(self.value - other.value) > SIGNIFICANT * float(
            np.hypot(self.std_error, other.std_error)
        )

    def words(self, factor: float, unit: str) -> Sentence:
        """Return the value as text with its 95 % uncertainty."""
        error = SIGNIFICANT * self.std_error * factor
        return say("value_with_error", value=self.value * factor, error=error, unit=unit)


def contradictory(scatter: float, free: float) -> bool:
    """Return whether several values contradict each other, from the weighted sum of squares
    ``scatter`` with ``free`` degrees of freedom.

    The cube root of chi-square is nearly normal (Wilson and Hilferty, Proceedings of the National
    Academy of Sciences 17, 1931).
    """
    share = 2.0 / (9.0 * free)
    return bool(np.cbrt(scatter / free) - (1.0 - share) > CONTRADICTORY * np.sqrt(share))
