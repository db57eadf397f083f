"""Hypotheses that the test after loading is faulty: wrong sign, exchanged directions, another unit,
or another axis.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from compwright.verification.hypothesis import Hypothesis
from compwright.verification.likelihood import ErrorBelief
from compwright.words.sentences import say

#: Prior odds of a fault of measurement against a loaded table well measured.
_MEASURED_WRONG: Final = 0.02
_OTHER_AXIS: Final = 0.01
#: Prior odds of two faults at once, of measurement and of loading, over one.
_BOTH: Final = 0.1
#: Standard deviation of the logarithm of the ratio of two honest noises of one axis.
_OTHER_NOISE: Final = 0.7
_NEVER: Final = 1e-300
#: Ratio of the noise of the test to that before, from which the units are always in doubt.
UNLIKE: Final = 5.0
#: Units that are mixed up, as factors on the readings.
_UNITS: Final = (1000.0, 0.001, 25.4, 1.0 / 25.4)


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasurementCase:
    """An expected deviation ``belief`` without any change of the correction, and the hypotheses
    that start from it.
    """

    belief: ErrorBelief
    hypotheses: tuple[Hypothesis, ...]


def measurement_cases(view: MeasurementCase, *, both: bool = True) -> tuple[MeasurementCase, ...]:
    """Return the cases that the test was recorded with the wrong sign or, if ``both`` directions
    were measured, with exchanged directions, while the table was loaded or the old correction was
    active.
    """
    stood = [each for each in view.hypotheses if each.name == "loaded"]
    stood += [each for each in view.hypotheses if each.name == "not_active"][:1]
    views = [_read(view.belief.scaled(-1.0), stood, -1.0, "sign")]
    if both:
        turned = [replace(each, positive=each.negative, negative=each.positive) for each in stood]
        views.append(_read(view.belief.turned(), turned, 1.0, "direction"))
    return tuple(views)


def unit_cases(view: MeasurementCase, louder: float) -> tuple[MeasurementCase, ...]:
    """Return the cases that the table is loaded and the test was recorded in a wrong unit.
    ``louder``: the noise of the test divided by that of the tests before loading.

    A wrong unit multiplies the scatter by the same factor as the readings. In tests with the right
    unit, the noise differs by a factor of about two (normal distribution of its logarithm).
    """
    stood = [each for each in view.hypotheses if each.name == "loaded"]
    views = []
    for unit in _UNITS:
        # a scatter nearer to that of the tests before is none of another unit
        if abs(math.log(louder / unit)) >= abs(math.log(louder)):
            continue
        read = _read(view.belief.scaled(unit), stood, unit, "unit")
        odds = math.exp(_honest(louder / unit) - _honest(louder))
        ways = (replace(each, weight=max(odds * each.weight, _NEVER)) for each in read.hypotheses)
        views.append(MeasurementCase(belief=read.belief, hypotheses=tuple(ways)))
    return tuple(views)


def _honest(ratio: float) -> float:
    """Return the logarithm of the probability density of the ``ratio`` of the noise in two tests
    that have the same unit, up to a constant.
    """
    return -0.5 * (math.log(ratio) / _OTHER_NOISE) ** 2


def other_axis_case(name: str, view: MeasurementCase) -> MeasurementCase:
    """Return the case that the test was made on the axis ``name``, with hypotheses ``view``."""
    stood = [each for each in view.hypotheses if each.name in ("loaded", "not_active")][:2]
    read = _read(view.belief, stood, 1.0, "wrong_axis").hypotheses
    share = _OTHER_AXIS / _MEASURED_WRONG
    named = (
        replace(each, weight=share * each.weight, detail=say("loading.of_axis", axis=name))
        for each in read
    )
    return MeasurementCase(belief=view.belief, hypotheses=tuple(named))


def _read(
    belief: ErrorBelief, stood: Sequence[Hypothesis], factor: float, of: str
) -> MeasurementCase:
    return MeasurementCase(
        belief=belief,
        hypotheses=tuple(
            replace(
                each,
                name="measurement",
                positive=factor * each.positive,
                negative=factor * each.negative,
                weight=_MEASURED_WRONG * (1.0 if each.name == "loaded" else _BOTH) * each.weight,
                of=of,
                detail=say("loading.table", active=each.name == "loaded"),
                factor=factor,
                free=None,
                read=each.name,
            )
            for each in stood
        ),
    )
