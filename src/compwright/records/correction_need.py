"""Decide whether a squareness or a scale error is certain enough to be corrected."""

from __future__ import annotations

from typing import Final, Literal

from compwright.words.sentences import Sentence, say

#: Two standard errors of a corrected value stay below this, µm/m, and below half of the value.
MOST_UNCERTAIN: Final = 30.0
#: A value that stays below this with two standard errors, µm/m, needs no correction.
NEGLIGIBLE: Final = 15.0
#: A well known value below this, µm/m, needs none either: over a metre it is the usual unit of a
#: table, 1 µm.
LEAST: Final = 1.0
_BOTH_SIDES: Final = 2.0  # standard errors to either end of the 95 % interval

Need = Literal["correct", "negligible", "undetermined"]


def correction_need(value: float, std_error: float) -> Need:
    """Decide whether an error (µm/m) must be corrected: ``correct``, ``negligible`` (too small), or
    ``undetermined`` (too uncertain).
    """
    uncertainty = _BOTH_SIDES * std_error
    if uncertainty < most_uncertain(value) and abs(value) >= LEAST:
        return "correct"
    return "negligible" if abs(value) + uncertainty < NEGLIGIBLE else "undetermined"


def most_uncertain(value: float) -> float:
    """Return the limit for the uncertainty (two standard errors) of an error of this ``value``
    (µm/m): the error is corrected only if its uncertainty is below this limit.
    """
    return min(0.5 * abs(value), MOST_UNCERTAIN)


def shortfall(value: float, std_error: float, *, squareness: bool) -> Sentence:
    """Return the sentence that a ``squareness``, else a scale, of ``value`` (µm/m) is too uncertain
    to be corrected.
    """
    return say(
        "undetermined.value",
        value=value,
        error=_BOTH_SIDES * std_error,
        most=MOST_UNCERTAIN,
        squareness=squareness,
    )
