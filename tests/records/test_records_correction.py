"""What a control does between, outside and beyond its nodes, worked by hand."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import AxisCompensation, CrossCompensation

PLUS, MINUS = Direction.POSITIVE, Direction.NEGATIVE


def compensation(**changes: object) -> AxisCompensation:
    base: dict[str, object] = {
        "address": "X",
        "kind": AxisKind.LINEAR,
        "positions": np.array([0.0, 10.0, 20.0]),
        "positive": np.array([0.0, 4.0, -2.0]),
        "negative": np.array([1.0, 5.0, -1.0]),
    }
    return AxisCompensation(**{**base, **changes})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("position", "value"),
    [(4.9, 0.0), (5.0, 4.0), (14.9, 4.0), (15.0, -2.0), (99.0, -2.0), (-99.0, 0.0)],
)
def test_steps_lie_in_the_middle_of_the_sections(position: float, value: float) -> None:
    assert compensation(interpolation="step").at(np.array([position]), PLUS) == value


@pytest.mark.parametrize(
    ("position", "value"), [(5.0, 2.0), (25.0, 2.0), (-15.0, 2.0), (20.0, 0.0), (-5.0, 1.0)]
)
def test_an_endless_table_repeats(position: float, value: float) -> None:
    endless = compensation(
        period=20.0, positive=np.array([0.0, 4.0, 0.0]), negative=np.array([0.0, 2.0, 0.0])
    )
    assert endless.at(np.array([position]), PLUS if position != -5.0 else MINUS) == value


def test_slope_backlash_and_further_tables_add_up() -> None:
    other = compensation(positive=np.array([7.0, 7.0, 7.0]), negative=np.array([9.0, 9.0, 9.0]))
    all_of_it = compensation(slope=0.5, origin=10.0, backlash=3.0, others=(other,))
    # table 4 and 5, slope 0.5 * (12 - 10) = 1 at x = 12 where the tables give 2.8 and 3.8; backlash
    # acts arriving in -: -3
    assert all_of_it.at(np.array([12.0]), PLUS)[0] == pytest.approx(2.8 + 1 + 7, abs=1e-12)
    assert all_of_it.at(np.array([12.0]), MINUS)[0] == pytest.approx(3.8 + 1 - 3 + 9, abs=1e-12)


def test_a_cross_table_is_read_by_the_position_of_its_input() -> None:
    cross = CrossCompensation(
        input="X",
        output="Y",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=np.array([0.0, 100.0]),
        positive=np.array([0.0, 0.004]),
        negative=np.array([0.0, 0.006]),
    )
    assert cross.at(np.array([50.0, 200.0]), PLUS).tolist() == [0.002, 0.004]
    assert cross.at(np.array([50.0]), MINUS).tolist() == [0.003]
