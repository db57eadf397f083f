"""What the record of a positioning test says of its readings."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.records.axis import AxisKind
from compwright.records.positioning import SAME_READING, PositioningTest


def made(positive: list[list[float]], negative: list[list[float]]) -> PositioningTest:
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=np.arange(len(positive), dtype=float),
        positive=np.array(positive),
        negative=np.array(negative),
    )


def test_the_step_is_the_smallest_between_any_two_readings_of_both_directions() -> None:
    test = made([[0.010, 0.0], [-0.004, np.nan]], [[0.0105, 0.002], [0.010, 0.0]])
    assert test.step == pytest.approx(0.0005)


def test_what_a_decimal_number_lost_on_the_way_is_no_step() -> None:
    test = made([[0.001, 0.001 + 0.3 * SAME_READING]], [[0.003, 0.003]])
    assert test.step == pytest.approx(0.002)


def test_readings_that_are_all_the_same_have_no_step() -> None:
    assert made([[0.001, 0.001]], [[0.001, np.nan]]).step == 0.0
