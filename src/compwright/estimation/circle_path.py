"""Causes of circular deviations that a test cannot separate, because of its arc or directions."""

from __future__ import annotations

from collections.abc import Container
from typing import Final

from compwright.estimation.circle_model import AXES, ENDS, CircleSamples
from compwright.records.circular import CircularTest
from compwright.words.sentences import Sentence, say

#: A lag and a change of the radius have these shapes too, with the sign of the direction.
_TWO_DIRECTIONS: Final = (
    "squareness",
    "servo_mismatch",
    "scale_error_first",
    "scale_error_second",
)
#: Lost motion, lateral play and straightness of an axis that does not reverse have these shapes.
_BOTH_REVERSE: Final = (
    "squareness",
    "scale_mismatch",
    "scale_error_first",
    "scale_error_second",
)
_AT_REVERSAL: Final = ("backlash", "lateral_play", "reversal_spike")


def undetermined_causes(test: CircularTest, samples: CircleSamples) -> dict[str, Sentence]:
    """Return the reason for each cause that cannot be separated: only one direction was measured,
    or the arc has no reversal point of the axis.
    """
    reasons: dict[str, list[Sentence]] = {}
    if not samples.both_senses:
        for cause in _TWO_DIRECTIONS:
            reasons.setdefault(cause, []).append(say("undetermined.one_direction"))
    for axis, name in zip(AXES, test.axes, strict=True):
        if not any(samples.reversals(axis)):
            for cause in (*_BOTH_REVERSE, *(f"{kind}_{axis}" for kind in _AT_REVERSAL)):
                reasons.setdefault(cause, []).append(say("undetermined.no_reversal", axis=name))
    return {cause: by_full_circle(*why) for cause, why in reasons.items()}


def absent_causes(test: CircularTest, given: Container[str]) -> dict[str, Sentence]:
    """Return, for each cause named in the documentation that is missing in ``given``, the reason
    why it has no value.
    """
    reasons = {"radius_change": say("undetermined.both_directions")}
    for axis, name in zip(AXES, test.axes, strict=True):
        reasons[f"offset_change_{axis}"] = say("undetermined.both_directions")
        reasons[f"scale_error_{axis}"] = say("undetermined.bar")
        reasons[f"cyclic_{axis}"] = say("undetermined.pitch")
        missing = by_full_circle(say("undetermined.no_end", axis=name))
        for kind in ("backlash", "reversal_spike"):
            for part in ("", *(f"_at_{end}" for end in ENDS)):
                reasons[f"{kind}_{axis}{part}"] = missing
        if "radius_change" not in given:
            missing = say("undetermined.both_directions")
        elif any(f"backlash_{axis}_at_{end}" in given for end in ENDS):
            missing = by_full_circle(say("undetermined.one_reversal"))
        for end in ENDS:
            reasons[f"lateral_play_{axis}_at_{end}"] = missing
    return {cause: reason for cause, reason in reasons.items() if cause not in given}


def by_full_circle(*reasons: Sentence) -> Sentence:
    """Return a sentence that states why causes cannot be separated (``reasons``) and advises to
    measure a full circle.
    """
    return say("undetermined.full_circle", reasons=reasons)
