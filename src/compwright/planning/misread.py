"""Is a test what its file and its state say? Its readings as stated are held against the same
readings taken otherwise: with the sign turned, + and - exchanged, in the opposite order of the
targets, counted against the machine, or measured while the table of the control did not act.

Each way of reading leaves an error of the axis, and is as likely as that error is. Axes err
smoothly, so what jumps from target to target has to come from the table that acted, where it jumps,
and targets with random parts (ISO 230-2:1988, 4.3.2) have to lie where the error says. And a table
was made for its axis: the error is the opposite of its smooth part times a factor, 1 give or take a
quarter in four cases of five, anything about 0 in the fifth. Without a table sign and directions
leave an error as smooth as before, and nothing is said of them here (`evaluation.plausibility`
looks at the reversal).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from compwright.estimation.likelihood import Shape, log_likelihood
from compwright.estimation.model import Travel
from compwright.estimation.observed import ObservedTest
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.planning.together import acted_at
from compwright.planning.ways_of_reading import (
    ActedAt,
    Reading,
    WayOfReading,
    plus,
    ways_of_reading,
)
from compwright.records.axis import Axis
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.settled import LOGARITHM, settled_number

#: How much less usual than a test as stated each other way of reading is: a weak prior.
_PRIOR: Final[Mapping[WayOfReading, float]] = {
    "stated": 0.88,
    "off": 0.05,
    "sign": 0.02,
    "directions": 0.02,
    "order": 0.015,
    "against": 0.015,
}
#: A test is doubted where it is as stated with less than this probability.
_DOUBTED: Final = 0.2
#: Other ways of reading that are named.
_NAMED: Final = 0.1
#: Standard deviation of the factor of a table's smooth part, and share of the cases: about 1 where
#: the table was made for this error, about 0 where it was not.
_MADE_FOR_IT: Final = (0.25, 0.8)
_ANYTHING: Final = (1.0, 0.2)
#: With fewer targets nothing is said.
_FEWEST: Final = 6
#: Ratios are told up to here: beyond, what the model leaves out decides.
_MOST: Final = 1e6

_WORDS: Final[Mapping[WayOfReading, tuple[str, str]]] = {
    "off": (
        "if the table of the control did not act in it",
        (
            "Was compensation switched on, and the axis referenced, while it was measured? If not,"
            " name that state under measured_in."
        ),
    ),
    "sign": (
        "with the sign of the deviations turned (target minus measured)",
        "Compare one reading with the instrument: too far in + is a positive deviation.",
    ),
    "directions": (
        "with + and - exchanged",
        "Look into the instrument's file which way the axis went in the first run.",
    ),
    "order": (
        "with the readings in the opposite order of the targets",
        "Compare the readings at the first and the last target with the instrument's file.",
    ),
    "against": (
        "with an instrument that counts against the machine",
        (
            "Move the axis in +: if the instrument counts down, the test needs position_map:"
            " {sense: -1, offset: ..}."
        ),
    ),
}


def misread_tests(
    tests: Sequence[PlannedTest],
    observed: Sequence[ObservedTest],
    axis: Axis,
    states: Mapping[str, ControlState],
) -> tuple[Finding, ...]:
    """Return the doubts (CW-P160) of the tests of an axis; ``observed``: the same without what
    acted in them, as far as ``states`` (by name) say it.
    """
    known = states if tests[0].measured_in in states else {}
    return tuple(
        finding
        for planned, bare in zip(tests, observed, strict=True)
        for finding in misread_findings(bare, axis, acted_at(planned, axis, known))
    )


def misread_findings(bare: ObservedTest, axis: Axis, acted: ActedAt | None) -> tuple[Finding, ...]:
    """Return the doubt (CW-P160) of a test whose readings are far more likely taken otherwise than
    as stated, with how much more.

    ``bare``: the test without what acted in it; ``acted``: what that was by position and direction,
    mm or deg, None where nobody knows.
    """
    if bare.test.targets.size < _FEWEST:
        return ()
    ways = ways_of_reading(bare, axis, acted)
    if len(ways) < 2:
        return ()
    logs = {
        reading.way: settled_number(_log_likelihood(reading, axis), LOGARITHM) for reading in ways
    }
    return _doubt(logs, bare.test.name)


def _log_likelihood(reading: Reading, axis: Axis) -> float:
    travel, periods = Travel(*axis.travel, axis.modulo), axis.screw_pitch
    if reading.smooth is None:
        return log_likelihood(reading.error, travel, periods)
    positive, negative = reading.smooth
    parts = []
    for (std, share), made_for_it in ((_MADE_FOR_IT, True), (_ANYTHING, False)):
        error = plus(reading.error, reading.smooth) if made_for_it else reading.error
        shape = Shape(positive, negative, std)
        parts.append(math.log(share) + log_likelihood(error, travel, periods, shape))
    return float(np.logaddexp(parts[0], parts[1]))


def _doubt(logs: Mapping[WayOfReading, float], name: str) -> tuple[Finding, ...]:
    priors = {way: math.log(_PRIOR[way]) + value for way, value in logs.items()}
    whole = float(np.logaddexp.reduce(np.array(list(priors.values()))))
    probability = {way: math.exp(value - whole) for way, value in priors.items()}
    if probability["stated"] > _DOUBTED:
        return ()
    others = sorted(
        (way for way in probability if way != "stated" and probability[way] >= _NAMED),
        key=lambda way: -probability[way],
    )
    said = [
        f"{_times(logs[way] - logs['stated'])} times more likely {_WORDS[way][0]}" for way in others
    ]
    checks = " ".join(_WORDS[way][1] for way in others)
    return (
        Finding(
            "CW-P160",
            "warning",
            f"The readings of test {name} do not look like what its file and state say: they are"
            f" {', or '.join(said)}. A table made from them would be wrong. {checks}",
        ),
    )


def _times(log_ratio: float) -> str:
    ratio = math.exp(min(log_ratio, math.log(_MOST)))
    return f"more than {_MOST:.0f}" if ratio >= 0.999 * _MOST else significant(ratio, 1)
