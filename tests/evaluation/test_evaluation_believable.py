"""What of a test is no measurement of the axis: told by tests in which it is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.evaluation.plausibility import certain_fault
from compwright.evaluation.valid_readings import chance_of_zero, valid_part, zero_traverses
from compwright.planning.wanted_correction import observed_tests
from compwright.records.axis import Direction, FloatArray
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from evaluation_samples import UM, axis_test

TARGETS = np.linspace(10.0, 990.0, 15)


def measured(seed: int = 1, step: float = 0.01, error: float = 8.0) -> PositioningTest:
    """Five runs with 0.6 µm of scatter about a sine of ``error`` µm, read in steps of ``step``."""
    rng = np.random.default_rng(seed)

    def block() -> FloatArray:
        values = error * np.sin(TARGETS / 180.0)[:, np.newaxis] + 0.6 * rng.standard_normal((15, 5))
        rounded: FloatArray = step * np.round(values / step) * UM
        return rounded

    return axis_test(TARGETS, block(), block())


def test_a_traverse_of_zeros_beside_others_that_scatter_was_not_made() -> None:
    test = measured()
    test.negative[:, 3] = 0.0
    assert zero_traverses(test) == [(Direction.NEGATIVE, 3)]
    assert zero_traverses(measured()) == []


def test_a_display_too_coarse_to_show_the_scatter_shows_zeros_by_itself() -> None:
    """Steps of 5 µm and an axis without error: most readings are zero, and so are whole runs."""
    test = measured(step=5.0, error=0.0)
    assert not np.any(test.positive[:, 0])
    assert zero_traverses(test) == []


@pytest.mark.parametrize(
    ("width", "table"),
    [(10.0, 2 * (0.51994 - 0.5)), (5.0, 2 * (0.53983 - 0.5)), (2.5, 2 * (0.57926 - 0.5))],
)
def test_chance_of_a_zero_is_that_of_the_table_of_the_normal_distribution(
    width: float, table: float
) -> None:
    """Readings that scatter by s round to zero within half a step either way: 2 (Φ(0.5/s) - 0.5),
    Φ as printed in tables; three readings -s, 0, s have the standard deviation s. The density at
    zero is larger by (0.5/s)²/6: less than 0.7 %.
    """
    rows = np.array([[-width, 0.0, width], [1.0 - width, 1.0, 1.0 + width]])
    test = axis_test([100.0, 500.0], rows * UM, rows * UM)
    assert chance_of_zero(test) == pytest.approx(table, rel=0.008)


@pytest.mark.parametrize(("read_as", "certain"), [(1e-3, True), (1.0, False)])
def test_a_large_error_read_as_micrometres_scatters_less_than_light_can_show(
    read_as: float, certain: bool
) -> None:
    """An error of 300 µm with a scatter of 0.6 µm, its mm taken for µm: 0.6 µm in all, more than a
    quiet axis may show, but 0.6 nm from run to run; interferometers of machine tools resolve 1 nm.
    """
    test = measured(error=300.0)
    shrunk = replace(test, positive=read_as * test.positive, negative=read_as * test.negative)
    assert ("1000 times too small" in certain_fault(shrunk)) is certain


def test_hardly_any_scatter_about_a_large_error_is_a_simulation() -> None:
    """20 µm in all: read 1000 times too small, the true error would be 20 mm."""
    test = measured(step=1e-6, error=0.0)
    wave = 10.0 * UM * np.sin(TARGETS / 180.0)[:, np.newaxis]
    quiet = replace(
        test, positive=wave + 1e-3 * test.positive, negative=wave + 1e-3 * test.negative
    )
    assert certain_fault(quiet) == ""


def test_readings_far_off_and_runs_not_made_are_left_out_of_what_is_believed() -> None:
    test = measured()
    test.negative[:, 3] = 0.0
    test.positive[7, 2] += 30.0 * UM
    found = valid_part(test)
    assert np.all(np.isnan(found.negative[:, 3]))
    assert np.isnan(found.positive[7, 2])
    assert np.count_nonzero(~np.isfinite(np.hstack([found.positive, found.negative]))) == 16


def test_a_traverse_of_zeros_does_not_count_in_the_estimate() -> None:
    """15 targets from -8 to 8 µm with zeros in one of ten traverses: neither outliers nor a shift
    of traverses is made of them.
    """
    test = measured()
    test.negative[:, 3] = 0.0
    (seen,) = observed_tests([PlannedTest(test=test, measured_in="as_found")], None)
    assert np.all(np.isnan(seen.test.negative[:, 3]))
    assert seen.noise is not None
    assert seen.noise.findings == ()
