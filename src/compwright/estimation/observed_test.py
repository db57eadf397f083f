"""One test as input of the estimation: mean readings, and draws of the noise of each mean (ISO
230-2:1997, 2.10).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.noise_posterior import NoisePosterior
from compwright.records.axis import FloatArray
from compwright.records.noise import INDEPENDENT, RUNS, NoiseDraws
from compwright.records.positioning import PositioningTest


@dataclass(frozen=True, slots=True, kw_only=True)
class ObservedTest:
    """A test in machine coordinates, minus the correction that was active during it.

    ``slope_std``: standard deviation (mm/mm) of a slope of this test alone, from its temperature.
    ``noise``: noise inferred from the repeated readings. If these are too few, it is None, and the
    noise is estimated together with the error.
    """

    test: PositioningTest
    noise: NoisePosterior | None = None
    slope_std: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class ObservedCells:
    """The c mean readings of one test, one for each target and direction, mm or deg.

    ``positions``, ``signs`` (c,): target and direction (+1, -1) of each mean. ``counts`` (c,):
    number of readings. ``means`` (c,): plain means. ``squares``: sum of squares of the readings
    about these means, with ``dof`` degrees of freedom. ``by_draw`` (n, c), ``precision`` (n, c),
    ``columns`` (n, c, q): mean, inverse variance and common errors for each draw of the noise
    (`NoisePosterior`). ``inferred``: the test has no draws of its own noise. Then ``by_draw``
    contains the plain means, and ``precision`` is 0.
    """

    positions: FloatArray
    signs: FloatArray
    counts: FloatArray
    means: FloatArray
    squares: float
    dof: float
    by_draw: FloatArray
    precision: FloatArray
    columns: FloatArray
    inferred: bool


def cell_means(
    observed: ObservedTest, order: NDArray[np.intp], other_noise: NoiseDraws | None
) -> ObservedCells:
    """Return the mean readings of a test and their noise, under the n noise draws with the indices
    ``order`` (n,). ``other_noise``: n draws of the noise of another test, used if this test does
    not show the shifts of its traverses.
    """
    test = observed.test
    deviations = (test.positive, test.negative)
    there = [np.isfinite(block) for block in deviations]
    counts = np.concatenate([known.sum(axis=1) for known in there]).astype(np.float64)
    held = [np.where(known, block, 0.0) for known, block in zip(there, deviations, strict=True)]
    means = np.concatenate([block.sum(axis=1) for block in held]) / np.maximum(counts, 1.0)
    m = test.targets.size
    squares = sum(
        float(np.sum(np.where(known, block - mean[:, np.newaxis], 0.0) ** 2))
        for known, block, mean in zip(there, deviations, (means[:m], means[m:]), strict=True)
    )
    kept = counts > 0
    positions, signs = np.tile(test.targets, 2)[kept], np.repeat([1.0, -1.0], m)[kept]
    own = observed.noise
    if own is None:
        size = int(np.count_nonzero(kept))
        by_draw = np.broadcast_to(means[kept], (order.size, size))
        precision = np.zeros((order.size, size))
        columns = (
            np.zeros((order.size, size, 0))
            if other_noise is None
            else traverse_columns(other_noise, positions, signs)
        )
    else:
        by_draw = own.mean[order][:, kept]
        precision = own.precision[order][:, kept]
        columns = own.columns[order][:, kept]
    return ObservedCells(
        positions=positions,
        signs=signs,
        counts=counts[kept],
        means=means[kept],
        squares=squares,
        dof=float(np.sum(np.maximum(counts - 1.0, 0.0))),
        by_draw=by_draw,
        precision=precision,
        columns=columns,
        inferred=own is None,
    )


def traverse_columns(
    other_noise: NoiseDraws, positions: FloatArray, signs: FloatArray
) -> FloatArray:
    """Return model columns (n, c, 4) for an unknown offset and an unknown tilt of each direction
    (``signs`` +1, -1) in a test. Their size is that in ``other_noise``, n draws of the noise of
    another test; the weights have unit variance.

    If only some traverses are shifted, the root mean square of the shifts is used. A shift common
    to both directions is the offset of the test, or its slope.
    """
    u = (positions - other_noise.centre) / other_noise.half
    up, down = signs > 0, signs < 0
    together = other_noise.pattern != INDEPENDENT
    first = np.where(together[:, np.newaxis], 1.0, up)
    second = np.where((other_noise.pattern == RUNS)[:, np.newaxis], 0.0, down)
    columns = [
        size[:, np.newaxis] * side * along
        for size, along in (
            (other_noise.offset * np.sqrt(other_noise.moved), np.ones_like(u)),
            (other_noise.tilt, u),
        )
        for side in (first, second)
    ]
    return np.stack(columns, axis=2)
