"""The array functions: batches, missing readings, estimators that are unbiased for normal
readings.
"""

from __future__ import annotations

import numpy as np
import pytest

from compwright.evaluation.statistics import (
    ISO_NAMES,
    VDI_NAMES,
    mean_deviation,
    parameters,
    standard_deviation,
    standard_deviation_from_range,
    vdi_parameters,
)


def test_batches_equal_single_evaluations() -> None:
    rng = np.random.default_rng(3)
    means = rng.normal(size=(2, 6, 4, 9))
    s = rng.uniform(0.1, 1.0, size=(2, 6, 4, 9))
    batch = parameters(means[0], s[0], means[1], s[1], 2.0)
    vdi = vdi_parameters(means[0], s[0], means[1], s[1])
    assert tuple(batch) == ISO_NAMES
    assert tuple(vdi) == VDI_NAMES
    for at in np.ndindex(6, 4):
        single = parameters(means[0][at], s[0][at], means[1][at], s[1][at], 2.0)
        single |= vdi_parameters(means[0][at], s[0][at], means[1][at], s[1][at])
        for name, number in single.items():
            assert (batch | vdi)[name][at] == number


def test_what_is_missing_takes_away_only_what_needs_it() -> None:
    mean, s = np.array([1.0, 2.0]), np.array([0.1, 0.2])
    nothing = np.full(2, np.nan)
    known = {
        name
        for name, number in parameters(mean, s, nothing, nothing, 2.0).items()
        if np.isfinite(number)
    }
    assert known == {"A_positive", "E_positive", "R_positive"}
    without_s = {
        name
        for name, number in parameters(mean, nothing, mean, nothing, 2.0).items()
        if np.isfinite(number)
    }
    assert without_s == {"E", "E_positive", "E_negative", "M", "B", "B_mean"}


def test_means_and_s_ignore_missing_readings() -> None:
    deviations = np.array([[1.0, np.nan, 3.0], [np.nan, 5.0, np.nan], [np.nan, np.nan, np.nan]])
    np.testing.assert_array_equal(mean_deviation(deviations), [2.0, 5.0, np.nan])
    np.testing.assert_allclose(standard_deviation(deviations), [np.sqrt(2.0), np.nan, np.nan])
    np.testing.assert_allclose(
        standard_deviation_from_range(deviations, {2: 0.5}), [1.0, np.nan, np.nan]
    )
    assert mean_deviation(np.empty((3, 0))).shape == (3,)
    assert np.all(np.isnan(standard_deviation(np.empty((3, 0)))))


def test_s_does_not_depend_on_a_large_common_offset() -> None:
    rng = np.random.default_rng(5)
    deviations = rng.normal(size=(7, 5))
    np.testing.assert_allclose(
        standard_deviation(deviations + 1e3), standard_deviation(deviations), atol=1e-9
    )


@pytest.mark.parametrize("n", [2, 5, 10])
def test_both_estimators_measure_the_same_scatter(n: int) -> None:
    """For normal readings the range factors are made to give sigma on average, and so does s
    squared.
    """
    from compwright.evaluation.statistics import RANGE_FACTORS_1988, RANGE_FACTORS_GOST

    deviations = np.random.default_rng(n).normal(size=(200_000, n))
    assert np.mean(standard_deviation(deviations) ** 2) == pytest.approx(
        1.0, abs=0.02
    )  # four standard errors at n = 2
    for factors in (RANGE_FACTORS_1988, RANGE_FACTORS_GOST):
        if n in factors:
            assert np.mean(standard_deviation_from_range(deviations, factors)) == pytest.approx(
                1.0, abs=0.01
            )
