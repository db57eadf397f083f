"""Selection of the tests of an axis that agree with its first test and were made in a known state
of the control.

The correction that was active in each test is subtracted before the comparison.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Final

import numpy as np

from compwright.estimation.cells import visible_periods
from compwright.estimation.observed_test import ObservedTest
from compwright.evaluation.error_agreement import disagreeing_test
from compwright.foundations.findings import Finding
from compwright.planning.motions import backlash_more, with_motion
from compwright.planning.wanted_correction import MeasuredError, axis_compensation, measured_error
from compwright.prediction.active_corrections import Correction, no_correction
from compwright.records.axis import Axis, Direction
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.plan import Acted, PlannedTest
from compwright.records.positioning import PositioningTest

#: Two periods found in two tests are one where they lie so close, relative to their size.
_SAME: Final = 0.02


def with_active_corrections(
    tests: Sequence[PlannedTest], axis: Axis, states: Mapping[str, ControlState]
) -> tuple[PlannedTest, ...]:
    """Return the tests, each with the correction that was active in the test. It follows from the
    test's motion (feed or rapid) and from the state of the control (``states`` by name).

    The correction of a test is None in two cases: its difference from that of the first test is
    unknown, or the test is not the first and has readings at a single target, which do not show the
    error. Tests in the same unknown state and at the same motion show the same error, whatever
    correction was active.
    """
    return tuple(
        replace(test, acted=_active_values(test, tests[0], axis, states))
        if place == 0 or _tells_something(test.test)
        else test
        for place, test in enumerate(tests)
    )


def active_at(
    test: PlannedTest, axis: Axis, states: Mapping[str, ControlState]
) -> Correction | None:
    """Return the correction that was active in a test, as a function of position and direction, or
    None where it is unknown.
    """
    state = states.get(test.measured_in)
    if state is None:
        return None
    return with_motion(
        axis_compensation(state, axis).at, axis, backlash_more(axis, test.motion, state)
    )


def _tells_something(test: PositioningTest) -> bool:
    read = sum(test.readings(direction) for direction in Direction)
    return int(np.count_nonzero(read)) > 1


def _active_values(
    test: PlannedTest, first: PlannedTest, axis: Axis, states: Mapping[str, ControlState]
) -> Acted | None:
    if first.measured_in in states:
        correction = active_at(test, axis, states)
    elif (test.measured_in, test.motion) == (first.measured_in, first.motion):
        correction = no_correction
    else:
        correction = None
    if correction is None:
        return None
    targets = test.test.targets
    return correction(targets, Direction.POSITIVE), correction(targets, Direction.NEGATIVE)


def select_consistent(
    tests: tuple[PlannedTest, ...],
    observed: Sequence[ObservedTest],
    axis: Axis,
    active: AxisCompensation | None,
) -> tuple[tuple[PlannedTest, ...], MeasuredError, tuple[Finding, ...]]:
    """Return three results: the tests, with those marked as unused that contradict the first test;
    the error estimated from the tests in use; and the doubts about the unused tests.

    ``observed``: the same tests with the active correction subtracted. ``active``: the correction
    that was active during the first test.
    """

    @cache
    def alone(place: int) -> MeasuredError:
        others = set(range(len(tests))) - {place}
        return measured_error(_counted_out(tests, others), observed, axis, active)

    doubts = dict(_disagreeing(tests, alone))
    counted = _counted_out(tests, doubts)
    if sum(test.acted is not None for test in counted) > 1:
        error = measured_error(counted, observed, axis, active)
    else:
        error = alone(0)
    return counted, error, tuple(doubts.values())


def _disagreeing(
    tests: Sequence[PlannedTest], alone: Callable[[int], MeasuredError]
) -> Iterator[tuple[int, Finding]]:
    """Yield index and doubt of each test that contradicts the first test. ``alone`` returns the
    error estimated from a single test.

    Each of the two tests is used to predict the other, because a short test predicts only a small
    part of a long one, and a long test most of a short one.
    """
    for place, other in enumerate(tests[1:], start=1):
        if other.acted is None:
            continue
        names = tests[0].test.name, other.test.name
        first, second = (tests[0], alone(0)), (other, alone(place))
        finding = _doubt(first, second, names) or _doubt(second, first, names)
        if finding is not None:
            yield place, finding


def _doubt(
    telling: tuple[PlannedTest, MeasuredError],
    shown: tuple[PlannedTest, MeasuredError],
    names: tuple[str, str],
) -> Finding | None:
    """Return the doubt that the test ``shown`` contradicts the test ``telling``, or None if both
    tests agree.

    Only the directions of approach that both tests have are compared. Each test has its own noise.
    """
    (source, error), (test, own) = telling, shown
    targets = test.test.targets
    estimate = error.own.summary(targets)
    active = test.acted or (np.zeros_like(targets), np.zeros_like(targets))
    expected = {
        side: estimate.mean(side) + more
        for side, more in zip(Direction, active, strict=True)
        if source.test.readings(side).any()
    }
    std = {Direction.POSITIVE: estimate.std_positive, Direction.NEGATIVE: estimate.std_negative}
    return disagreeing_test(
        test.test,
        expected,
        std,
        own.own.summary(targets).noise,
        names,
        _only_there(shown, telling),
    )


def _only_there(
    shown: tuple[PlannedTest, MeasuredError], telling: tuple[PlannedTest, MeasuredError]
) -> tuple[float, ...]:
    """Return the periods found in the test ``shown`` and not in ``telling``: its targets hide these
    periods, or its readings do not show them.
    """
    one, other = (
        visible_periods(
            test.test.targets, [each.period for each in error.own.periods if each.named]
        )
        for test, error in (shown, telling)
    )
    return tuple(
        period for period in one if all(abs(period - each) > _SAME * period for each in other)
    )


def _counted_out(tests: Sequence[PlannedTest], places: Container[int]) -> tuple[PlannedTest, ...]:
    """Return the tests, with those at the indices ``places`` marked as unused."""
    return tuple(
        replace(test, acted=None) if place in places else test for place, test in enumerate(tests)
    )
