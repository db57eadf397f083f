"""What readings say of the mean of their cell when some of them may be far off: against integrals by
another program, and for readings without tails.
"""

from __future__ import annotations

import numpy as np
import pytest
from test_estimation_noise import UM, made, white

from compwright.estimation.noise import infer_noise
from compwright.estimation.noise_cells import cell_locations
from compwright.estimation.noise_tails import Tail
from compwright.records.axis import FloatArray


def normal(z: FloatArray, middle: float = 0.0, scale: float = 1.0) -> FloatArray:
    return np.exp(-0.5 * ((z - middle) / scale) ** 2) / scale


def density(tail: Tail, z: FloatArray) -> FloatArray:
    """The probability density of an error of size ``z``, up to a constant factor."""
    if np.isfinite(tail.dof):
        return (1.0 + z**2 / tail.dof) ** (-0.5 * (tail.dof + 1.0))
    scale = np.hypot(1.0, 0.1 * tail.size) if tail.fixed else tail.size
    far = [normal(z, side * tail.size * tail.fixed, scale) for side in (-1.0, 1.0)]
    return (1.0 - tail.share) * normal(z) + 0.5 * tail.share * sum(far)


@pytest.mark.parametrize(
    "tail",
    [
        Tail(0.1, dof=3.0),
        Tail(0.1, share=0.05, size=8.0, fixed=True),
        Tail(0.1, share=0.05, size=8.0),
    ],
    ids=["student", "fixed", "spread"],
)
@pytest.mark.parametrize(
    "readings",
    [[0.3, -0.2, 1.1, -0.9, 0.4], [0.3, -0.2, 7.9, 0.0, 0.4], [0.0, 2.5], [1.7]],
    ids=["calm", "one far off", "two", "one"],
)
def test_the_place_of_a_cell_is_that_of_an_integral_over_all_places(
    tail: Tail, readings: list[float]
) -> None:
    scale = 0.4
    values = np.array([[*readings, 99.0]]) * scale
    there = np.isfinite(values) & (values < 30.0)
    mean, square = cell_locations(tail, values, there, np.array([scale]))

    # Between the readings, and as far beside them as the place is looked for.
    places = np.linspace(min(readings) - 3.0, max(readings) + 3.0, 20_001)
    weights = np.prod([density(tail, reading - places) for reading in readings], axis=0)

    wanted = np.average(places, weights=weights)
    width = np.sqrt(np.average((places - wanted) ** 2, weights=weights))
    assert mean[0] / scale == pytest.approx(wanted, abs=0.02 * width)
    assert np.sqrt(square[0]) / scale == pytest.approx(width, rel=0.03)


def test_readings_without_tails_keep_their_plain_means() -> None:
    """One reading or the other taken for an outlier by the sampler moves no mean: else the error
    of the axis looks rough from target to target.
    """
    for seed in (1, 2, 3):
        test = made(0.4 * white(seed))
        found = infer_noise(test)
        assert found is not None
        plain = np.concatenate([test.positive, test.negative]).mean(axis=1)
        away = found.mean - plain
        away = away - away.mean(axis=1, keepdims=True)  # a datum is nobody's error
        assert np.max(np.sqrt(np.mean(away**2, axis=1))) < 0.35 * 0.4 * UM / np.sqrt(5.0)
