"""The quick check on the card, by hand: where, what to read, and when to stop."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.planning.quick_check import check_positions, moved_by, quick_check
from compwright.prediction.active_corrections import Correction, no_correction
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import AxisCompensation
from planning_samples import MINUS, PLUS, UM, KnownAxis, axis_of, by_slope, work_of

#: 20 µm/m too long, 4 µm too high in -; readings scatter by 0.3 µm and the mean is known to 0.4 µm.
KNOWN = KnownAxis(lambda x: 20e-6 * x, lambda x: 20e-6 * x + 4.0 * UM, std=0.4 * UM, noise=0.3 * UM)


def hump(at: float) -> Correction:
    """A correction that only acts near one position."""
    return lambda x, _way: np.where(np.abs(np.asarray(x) - at) < 1.0, 8.0 * UM, 0.0)


def test_both_ends_and_where_the_correction_leaves_the_straight_line_most() -> None:
    work = work_of(KNOWN)
    assert check_positions(work, hump(300.0)).tolist() == [0.0, 300.0, 1000.0]
    assert check_positions(work, by_slope(-20e-6)).tolist() == [0.0, 500.0, 1000.0]  # all equal
    bent: Correction = lambda x, _way: -50.0 * UM * (np.asarray(x) / 1000.0) ** 8  # noqa: E731
    assert check_positions(work, bent).tolist() == [0.0, 700.0, 1000.0]


def test_only_targets_within_the_travel_are_driven_to() -> None:
    work = work_of(KNOWN, axis_of(travel=(150.0, 850.0)))
    assert check_positions(work, hump(900.0)).tolist() == [200.0, 500.0, 800.0]
    short = work_of(KNOWN, axis_of(travel=(150.0, 350.0)))
    assert check_positions(short, no_correction).tolist() == [150.0, 250.0, 350.0]


def test_up_and_down_with_the_instrument_zeroed_at_the_first_one() -> None:
    """A table of -15 µm/m and -3 µm in -: 5 µm/m remain, and 1 µm in -."""
    readings = list(quick_check(work_of(KNOWN), by_slope(-15e-6, lost=-3.0 * UM)))
    assert [entry.position for entry in readings] == [0.0, 500.0, 1000.0, 1000.0, 500.0, 0.0]
    assert [entry.direction for entry in readings] == [PLUS] * 3 + [MINUS] * 3
    assert [entry.expected / UM for entry in readings] == pytest.approx(
        [0.0, 2.5, 5.0, 6.0, 3.5, 1.0], abs=1e-9
    )
    assert [entry.adds / UM for entry in readings] == pytest.approx(
        [0.0, -7.5, -15.0, -18.0, -10.5, -3.0]
    )


def test_the_zero_is_taken_where_the_first_reading_is() -> None:
    """At 200 mm the table and the error are not zero: the display is, all the same."""
    work = work_of(KNOWN, axis_of(travel=(150.0, 850.0)))
    readings = list(quick_check(work, by_slope(-15e-6)))
    assert [entry.expected / UM for entry in readings[:3]] == pytest.approx([0.0, 1.5, 3.0])


def test_a_reading_that_no_accident_gives_stops() -> None:
    """Two readings of 0.3 µm, and the mean to 0.4 µm: 5 · sqrt(0.09 + 0.09 + 0.16) = 2.9 µm."""
    for entry in quick_check(work_of(KNOWN), no_correction):
        assert entry.stop / UM == pytest.approx(5.0 * np.sqrt(0.34))


def test_what_acted_during_the_test_is_no_change() -> None:
    table = AxisCompensation(
        address="X",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 1000.0]),
        positive=np.array([0.0, 10.0 * UM]),
        negative=np.array([0.0, 10.0 * UM]),
    )
    last = list(quick_check(work_of(KNOWN, active=table), table.at))[2]
    assert (last.expected / UM, last.adds / UM) == pytest.approx((20.0, 10.0))


@pytest.mark.parametrize(("way", "moved"), [(PLUS, -12.0), (MINUS, -13.0)])
def test_a_fixed_position_moves_by_the_new_correction_less_the_old(
    way: Direction, moved: float
) -> None:
    """Approached as at the reference: 15 µm/m back at 1000 mm, where the control drew 3 back."""
    work = work_of(KNOWN, axis_of(reference_return=way), as_found=by_slope(-3e-6))
    new = by_slope(-15e-6, lost=-1.0 * UM)
    assert moved_by(work, new, 1000.0) / UM == pytest.approx(moved)
