"""Decide whether a squareness or a scale error is certain enough to be corrected."""

from __future__ import annotations

from math import erfc, sqrt
from typing import Final, Literal

from compwright.foundations.findings import Finding
from compwright.words.sentences import Sentence, say

#: Two standard errors of a corrected value stay below this, µm/m, and below half of the value.
MOST_UNCERTAIN: Final = 30.0
#: A value that stays below this with two standard errors, µm/m, needs no correction.
NEGLIGIBLE: Final = 15.0
#: A correction that is more often worse than no correction is a doubt: one in a thousand. A value
#: of four standard errors, the least that is corrected, is so in one of 44; one of six in one of
#: 740.
_WORSE: Final = 1e-3
_BOTH_SIDES: Final = 2.0  # standard errors to either end of the 95 % interval

Need = Literal["correct", "negligible", "undetermined"]


def correction_need(value: float, std_error: float) -> Need:
    """Decide on correcting an error (µm/m): ``correct``, ``negligible`` or ``undetermined``."""
    uncertainty = _BOTH_SIDES * std_error
    if uncertainty < most_uncertain(value):
        return "correct"
    return "negligible" if abs(value) + uncertainty < NEGLIGIBLE else "undetermined"


def most_uncertain(value: float) -> float:
    """Return the limit of two standard errors below which ``value`` (µm/m) is corrected."""
    return min(0.5 * abs(value), MOST_UNCERTAIN)


def worse_doubts(
    value: float, std_error: float, axes: tuple[str, ...], plane: str = ""
) -> tuple[Finding, ...]:
    """Return the doubt that correcting ``value`` (µm/m; the squareness of ``plane``, else the scale
    of an axis) makes it worse, or nothing.

    It is worse where the true value is below half of ``value``: then the correction leaves more of
    the other sign than there was. Normal error, and no knowledge of the machine.
    """
    chance = 0.5 * erfc(0.5 * abs(value) / (sqrt(2.0) * std_error))
    if chance <= _WORSE:
        return ()
    return (
        Finding.of("CW-P166", "warning", axes, axis=axes[-1], plane=plane, percent=100.0 * chance),
    )


def shortfall(value: float, std_error: float) -> Sentence:
    """Return the sentence that a value (µm/m) is too uncertain, with what to measure."""
    error = _BOTH_SIDES * std_error
    return say("undetermined.value", value=value, error=error, most=MOST_UNCERTAIN)
