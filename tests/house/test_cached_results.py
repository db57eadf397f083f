"""Estimates that tests cache are those of the same readings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from cached_results import cached
from compwright.foundations.provenance import Source
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest

TEST = PositioningTest(
    name="x",
    axis="X",
    kind=AxisKind.LINEAR,
    targets=np.array([0.0, 10.0]),
    positive=np.array([[0.001, 0.002], [0.003, 0.004]]),
    negative=np.array([[0.0, 0.0], [0.001, 0.001]]),
)


def counted() -> tuple[Callable[..., object], list[float]]:
    asked: list[float] = []

    def estimate(test: PositioningTest, *, travel: float) -> object:
        asked.append(travel)
        return test.positive.sum() / travel

    return cached(estimate), asked


def test_the_same_readings_from_another_file_are_worked_out_once() -> None:
    estimate, asked = counted()
    other = replace(TEST, sources=(Source("elsewhere/x.csv", "0" * 64),), targets=TEST.targets + 0)
    first = estimate(replace(TEST, sources=(Source("x.csv", "1" * 64),)), travel=10.0)
    assert estimate(other, travel=10.0) is first
    assert len(asked) == 1


def test_one_other_reading_name_or_argument_is_worked_out_anew() -> None:
    estimate, asked = counted()
    moved = TEST.positive.copy()
    moved[1, 1] = np.nextafter(moved[1, 1], 1.0)
    for test, travel in (
        (TEST, 10.0),
        (TEST, 11.0),
        (replace(TEST, positive=moved), 10.0),
        (replace(TEST, name="y"), 10.0),
    ):
        estimate(test, travel=travel)
    assert len(asked) == 4
