"""What is wanted of a control: signs and coverage by hand numbers."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.planning.wanted_correction import (
    MeasuredError,
    axis_compensation,
    check_coverage,
    dense_positions,
    measured_error,
    observed_tests,
    wanted_correction,
    with_change,
)
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlState, no_compensation
from compwright.records.plan import PlannedTest
from planning_samples import MINUS, PLUS, TARGETS, UM, KnownAxis, axis_of, estimate_of, readings_of

pytestmark = pytest.mark.short_estimate

NODES = np.array([0.0, 1000.0])
TABLE = AxisCompensation(
    address="X",
    kind=AxisKind.LINEAR,
    positions=NODES,
    positive=np.array([0.0, 10.0 * UM]),
    negative=np.array([0.0, 10.0 * UM]),
    backlash=4.0 * UM,
)
NONE = no_compensation("X", AxisKind.LINEAR)


def bare(targets: list[float]) -> object:
    readings = np.zeros((len(targets), 1))
    return readings_of(readings, readings, np.array(targets))


def test_an_axis_that_goes_too_far_is_called_back() -> None:
    """20 µm too far at 1000 mm, and nothing in the control: -20 µm there, nothing at the
    reference.
    """
    estimate = estimate_of(NODES, lambda x: 20e-6 * x, lambda x: 20e-6 * x)
    wanted = wanted_correction(estimate, NONE, axis_of(), reversal_log_odds=0.0)
    np.testing.assert_allclose(wanted.positive, [0.0, -20.0 * UM], atol=1e-15)
    np.testing.assert_allclose(wanted.negative, [0.0, -20.0 * UM], atol=1e-15)


def test_what_acted_during_the_test_stays_in_the_total() -> None:
    """The table adds 10 µm at 1000 mm and the axis still goes 3 µm too far: 7 µm are wanted there.
    In - the control adds -4 µm for lost motion, and 1 µm too little: the axis stands 1 µm too high,
    so -5 µm.
    """
    estimate = estimate_of(NODES, lambda x: 3e-6 * x, lambda x: 3e-6 * x + 1.0 * UM)
    wanted = wanted_correction(estimate, TABLE, axis_of(), reversal_log_odds=0.0)
    np.testing.assert_allclose(wanted.positive, [0.0, 7.0 * UM], atol=1e-15)
    np.testing.assert_allclose(wanted.negative, [-5.0 * UM, 2.0 * UM], atol=1e-15)


def test_the_zero_state_is_the_reference_approached_in_its_direction() -> None:
    """Referenced in -, the same lost motion is corrected in +."""
    estimate = estimate_of(NODES, np.zeros_like, lambda x: 0.0 * x + 5.0 * UM)
    returned = axis_of(reference=1000.0, reference_return=MINUS)
    wanted = wanted_correction(estimate, NONE, returned, reversal_log_odds=0.0)
    np.testing.assert_allclose(wanted.negative, [0.0, 0.0], atol=1e-15)
    np.testing.assert_allclose(wanted.positive, [5.0 * UM, 5.0 * UM], atol=1e-15)


def test_a_reference_outside_the_travel_is_stood_for_by_the_nearest_end() -> None:
    estimate = estimate_of(NODES, lambda x: 20e-6 * x, lambda x: 20e-6 * x)
    wanted = wanted_correction(estimate, NONE, axis_of(reference=1300.0), reversal_log_odds=0.0)
    np.testing.assert_allclose(wanted.positive, [20.0 * UM, 0.0], atol=1e-15)


@pytest.mark.parametrize(
    ("targets", "enough"),
    [
        ([0.0, 250.0, 500.0], True),
        ([0.0, 250.0, 499.0], False),
        ([500.0, 750.0, 1000.0], True),
        ([-400.0, 100.0, 499.0], False),  # what lies beyond the travel covers nothing
        ([501.0, 1000.0, 1800.0], False),
    ],
)
def test_half_of_the_travel_has_to_be_measured(targets: list[float], *, enough: bool) -> None:
    if enough:
        check_coverage("job.yaml", axis_of(), [bare(targets)])  # type: ignore[list-item]
        return
    with pytest.raises(InputError, match="cover less than half of the travel"):
        check_coverage("job.yaml", axis_of(), [bare(targets)])  # type: ignore[list-item]


@pytest.mark.parametrize(
    ("targets", "travel", "enough"),
    [
        ([0.0, 90.0, 180.0], (0.0, 360.0), True),  # the largest gap is half of the turn
        ([0.0, 90.0, 179.0], (0.0, 360.0), False),
        ([350.0, 400.0, 540.0], (0.0, 720.0), True),  # 350, 40, 180: the gap is 170
        ([0.0, 30.0, 60.0], (0.0, 100.0), True),  # a part of a turn counts as it is
        ([0.0, 360.0], (0.0, 360.0), False),  # one place, twice
    ],
)
def test_of_an_endless_axis_the_largest_gap_counts(
    targets: list[float], travel: tuple[float, float], *, enough: bool
) -> None:
    axis = axis_of("C", kind=AxisKind.ROTARY, travel=travel, modulo=360.0)
    if enough:
        check_coverage("job.yaml", axis, [bare(targets)])  # type: ignore[list-item]
        return
    with pytest.raises(InputError):
        check_coverage("job.yaml", axis, [bare(targets)])  # type: ignore[list-item]


def test_a_known_period_is_seen_ten_times() -> None:
    """1000 mm with a screw of 10 mm: 100 periods, 1000 intervals."""
    assert dense_positions(axis_of(), ()).size == 401
    np.testing.assert_allclose(np.diff(dense_positions(axis_of(), (10.0,))), 1.0)
    assert dense_positions(axis_of(), (10.0, 20.0)).size == 1001
    assert dense_positions(axis_of(), (0.5,)).size == 4001
    assert dense_positions(axis_of(), (500.0,)).size == 401


def test_an_endless_axis_is_kept_over_one_turn_from_its_reference() -> None:
    axis = axis_of("C", kind=AxisKind.ROTARY, travel=(0.0, 720.0), modulo=360.0, reference=30.0)
    assert dense_positions(axis, ())[[0, -1]].tolist() == [30.0, 390.0]


def test_a_correction_that_changes_moves_every_reading_with_it() -> None:
    test = readings_of(np.zeros((2, 3)), np.zeros((2, 3)), NODES)
    moved = with_change(test, np.array([0.0, 2.0]), np.array([1.0, -1.0]))
    np.testing.assert_array_equal(moved.positive, [[0.0] * 3, [2.0] * 3])
    np.testing.assert_array_equal(moved.negative, [[1.0] * 3, [-1.0] * 3])


def test_what_the_control_added_is_put_back_exactly() -> None:
    known = KnownAxis(np.zeros_like, lambda x: 0.0 * x + 6.0 * UM)
    error = MeasuredError(known, TABLE)  # type: ignore[arg-type]
    summary = error.summary(NODES)
    np.testing.assert_allclose(summary.mean_positive, [0.0, 10.0 * UM], atol=1e-15)
    np.testing.assert_allclose(summary.mean_negative, [2.0 * UM, 12.0 * UM], atol=1e-15)
    draws = error.draw(NODES, 3, np.random.default_rng(0))
    np.testing.assert_allclose(draws.positive, [[0.0, 10.0 * UM]] * 3, atol=1e-15)
    np.testing.assert_allclose(draws.negative, [[2.0 * UM, 12.0 * UM]] * 3, atol=1e-15)


def test_a_rough_table_that_acted_is_taken_out_before_the_error_is_estimated() -> None:
    """A saw of 8 µm in the table is no error of the machine, which only has 5 µm/m."""
    saw = AxisCompensation(
        address="X",
        kind=AxisKind.LINEAR,
        positions=TARGETS,
        positive=np.where(np.arange(11) % 2, 8.0, 0.0) * UM,
        negative=np.where(np.arange(11) % 2, 8.0, 0.0) * UM,
    )
    noise = np.random.default_rng(1).normal(0.0, 0.2 * UM, (11, 5))
    readings = (5e-6 * TARGETS)[:, None] + noise
    shown = with_change(
        readings_of(readings, readings), saw.at(TARGETS, PLUS), saw.at(TARGETS, MINUS)
    )
    tests = [PlannedTest(test=shown, measured_in="as_found")]
    error = measured_error(tests, observed_tests(tests, saw), axis_of(), saw)
    own = error.own.summary(TARGETS).mean_positive
    assert np.ptp(np.diff(own)) < 0.5 * UM  # a straight line; 16 µm where the saw stayed in
    np.testing.assert_allclose(
        error.summary(TARGETS).mean(Direction.POSITIVE), own + saw.at(TARGETS, PLUS), atol=1e-15
    )


@pytest.mark.full_estimate
def test_a_period_that_is_the_spacing_of_the_acting_table_is_told_as_such() -> None:
    """2 µm every 40 mm over 26 targets, and a table with nodes 40 mm apart that acted."""
    rng = np.random.default_rng(4)
    targets = np.round((np.arange(26) + 0.5 + rng.uniform(-0.3, 0.3, 26)) * 1000.0 / 26, 3)
    error = 2.0 * UM * np.sin(2.0 * np.pi * targets / 40.0)
    readings = error[:, None] + rng.normal(0.0, 0.3 * UM, (26, 5))
    nodes: FloatArray = 40.0 * np.arange(26, dtype=np.float64)
    values = 5.0 * UM * np.sin(nodes / 200.0)
    table = AxisCompensation(
        address="X", kind=AxisKind.LINEAR, positions=nodes, positive=values, negative=values
    )
    shown = with_change(
        readings_of(readings, readings, targets), table.at(targets, PLUS), table.at(targets, MINUS)
    )
    tests = [PlannedTest(test=shown, measured_in="as_found")]
    found = measured_error(tests, observed_tests(tests, table), axis_of(), table).findings
    (message,) = (each.message for each in found if each.code == "CW-E012")
    assert "every 40 mm" in message
    assert "points of the existing table are also 40 mm apart" in message


def test_an_axis_of_which_the_files_do_not_speak_has_no_compensation() -> None:
    state = ControlState(format="any", axes={"X": TABLE})
    assert axis_compensation(state, axis_of()) is TABLE
    other = axis_compensation(state, axis_of("Y", reference_return=MINUS))
    assert (other.address, other.positions.size, other.reference_return) == ("Y", 0, MINUS)
