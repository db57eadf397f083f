"""Which tests of an axis count together: those whose state of the control is known, each without
what acted in it, as far as they show the same error as the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from compwright.evaluation.agreement import disagreeing_test
from compwright.foundations.findings import Finding
from compwright.planning.motions import backlash_more, with_motion
from compwright.planning.wanted import MeasuredError, held_by
from compwright.prediction.acting import Correction, nothing
from compwright.records.axis import Axis, Direction
from compwright.records.correction import ControlState
from compwright.records.plan import Acted, PlannedTest


def with_what_acted(
    tests: Sequence[PlannedTest], axis: Axis, states: Mapping[str, ControlState]
) -> tuple[PlannedTest, ...]:
    """Return the tests with what the control did in each, by its state (``states``, by name) and
    its motion; None where nobody says by how much that differs from the first.

    Tests in one unknown state and at one motion show the same error, with whatever acted.
    """
    return tuple(replace(test, acted=_acted(test, tests[0], axis, states)) for test in tests)


def _acted(
    test: PlannedTest, first: PlannedTest, axis: Axis, states: Mapping[str, ControlState]
) -> Acted | None:
    state = states.get(test.measured_in)
    correction: Correction = nothing
    if first.measured_in in states:
        if state is None:
            return None
        more = backlash_more(axis, test.motion, state)
        correction = with_motion(held_by(state, axis).at, axis, more)
    elif (test.measured_in, test.motion) != (first.measured_in, first.motion):
        return None
    targets = test.test.targets
    return correction(targets, Direction.POSITIVE), correction(targets, Direction.NEGATIVE)


def disagreeing(
    tests: Sequence[PlannedTest], posterior: MeasuredError
) -> Iterator[tuple[int, Finding]]:
    """Yield the place and the doubt of each test that contradicts the first, from which alone the
    ``posterior`` is.
    """
    first, *others = tests
    for place, other in enumerate(others, start=1):
        if other.acted is None:
            continue
        targets = other.test.targets
        estimate = posterior.own.summary(targets)
        expected = {
            side: estimate.mean(side) + acted
            for side, acted in zip(Direction, other.acted, strict=True)
        }
        std = {Direction.POSITIVE: estimate.std_positive, Direction.NEGATIVE: estimate.std_negative}
        finding = disagreeing_test(other.test, expected, std, estimate.noise, first.test.name)
        if finding is not None:
            yield place, finding


def counted_out(
    tests: Sequence[PlannedTest], doubts: Mapping[int, Finding]
) -> tuple[PlannedTest, ...]:
    """Return the tests with those that raise ``doubts``, by their place, left out of the count."""
    return tuple(
        replace(test, acted=None) if place in doubts else test for place, test in enumerate(tests)
    )


def only_first(tests: Sequence[PlannedTest]) -> tuple[PlannedTest, ...]:
    """Return the tests with only the first left in the count."""
    return (tests[0], *(replace(test, acted=None) for test in tests[1:]))
