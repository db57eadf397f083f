"""The products of the model columns of a circular test, summed over groups of neighbouring orders
of the cosine transform.

The fit is repeated with many noise spectra. Within one group of orders (`order_groups`) the density
of the noise hardly changes. In long tests, whose samples are means, the columns are therefore
multiplied only once. For each spectrum, the products are weighted by the mean of the inverse
density in their group (Hannan, Regression for Time Series, in Rosenblatt, Time Series Analysis,
1963; Engle, International Economic Review 15, 1974). The lowest orders, where the density may be
steep, have a weight each. So have all orders of a test whose samples are no means: there the
products cost little.

The spikes of both directions are two sets of columns: with equal sign, and with the sign of the
direction. What is in the sum of the directions for one set is in their difference for the other.
Thus three products of spikes give all.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.estimation.circle_noise import IndexArray
from compwright.records.axis import FloatArray


@dataclass(frozen=True, slots=True)
class PooledProducts:
    """The columns at the lowest orders, and the products of the columns in g groups of the others.

    There are p fixed columns and c curves of spikes: k = p + c columns in one direction, k = p + 2
    * c in two. Each attribute has one entry for the sum and one for the difference of the
    directions: the columns ``low`` (l, k), and the products ``fixed`` (g, p, k) of the fixed
    columns with all columns. ``spikes``: products (g, c, c) of the curves in the sum; with two
    directions also in the difference, and of the sum with the difference. ``first`` (g,): first
    order of each group.
    """

    first: IndexArray
    low: tuple[FloatArray, ...]
    fixed: tuple[FloatArray, ...]
    spikes: tuple[FloatArray, ...]

    def weights(self, density: FloatArray) -> FloatArray:
        """Return the weight of each order (size,), 1/mm², for noise of this ``density`` (size,)."""
        weights = 1.0 / density
        if self.first.size:
            counts = np.diff(self.first, append=density.size)
            means = np.add.reduceat(weights, self.first) / counts
            weights[self.first[0] :] = np.repeat(means, counts)
        return weights

    def gram(self, half: int, weights: FloatArray) -> FloatArray:
        """Return the normal matrix (k, k) of the sum of the directions (``half`` 0) or of their
        difference (1), with a weight of each order (size,), 1/mm².
        """
        rows = self.low[half] * np.sqrt(weights[: len(self.low[half]), np.newaxis])
        gram: FloatArray = rows.T @ rows
        groups = weights[self.first]
        count, curves = self.fixed[half].shape[1], self.spikes[half].shape[1]
        alike, unlike = slice(count, count + curves), slice(count + curves, None)
        gram[:count] += np.tensordot(groups, self.fixed[half], 1)
        gram[count:, :count] = gram[:count, count:].T
        gram[alike, alike] += np.tensordot(groups, self.spikes[half], 1)
        if len(self.low) == 2:
            across = np.tensordot(groups, self.spikes[2], 1)
            across = across.T if half else across
            gram[unlike, unlike] += np.tensordot(groups, self.spikes[1 - half], 1)
            gram[alike, unlike] += across
            gram[unlike, alike] += across.T
        return gram

    def with_columns(
        self, keep: Sequence[int], columns: tuple[FloatArray, ...], curves: tuple[FloatArray, ...]
    ) -> PooledProducts:
        """Return the products of other fixed ``columns``: those with the indices ``keep`` so far,
        then new ones. ``columns`` and ``curves`` as in `pooled_products`.
        """
        edges, kept = [*self.first.tolist(), curves[0].shape[0]], len(keep)
        low, fixed = [], []
        for half, old, spikes in zip(columns, self.fixed, turned(curves), strict=True):
            every = half, *spikes
            new = np.concatenate([_products(edges, half[:, kept:], e) for e in every], axis=2)
            found = np.empty((len(new), half.shape[1], new.shape[2]))
            found[:, :kept, :kept] = old[:, keep][:, :, keep]
            found[:, :kept, kept : half.shape[1]] = np.swapaxes(new[:, :, :kept], 1, 2)
            found[:, :kept, half.shape[1] :] = old[:, keep, old.shape[1] :]
            found[:, kept:] = new
            low.append(np.concatenate([each[: edges[0]] for each in every], axis=1))
            fixed.append(found)
        return replace(self, low=tuple(low), fixed=tuple(fixed))


def pooled_products(
    columns: tuple[FloatArray, ...], curves: tuple[FloatArray, ...], first: IndexArray
) -> PooledProducts:
    """Return the products of the fixed ``columns`` (size, p) and the spike ``curves`` (size, c),
    each for the sum and the difference of the directions. ``first`` (g,): first order of each
    group.
    """
    size = curves[0].shape[0]
    pairs: list[tuple[FloatArray, ...]] = [(half, half) for half in curves]
    spikes = [
        _products([*first.tolist(), size], *pair)
        for pair in (*pairs, curves)[: 2 * len(curves) - 1]
    ]
    none = tuple(np.zeros((first.size, 0, curves[0].shape[1] * len(curves))) for _ in curves)
    return PooledProducts(first, (), none, tuple(spikes)).with_columns([], columns, curves)


def turned(curves: tuple[FloatArray, ...]) -> list[tuple[FloatArray, ...]]:
    """Return the spike columns of the sum and the difference of the directions: those of equal sign
    and those that change sign. The latter have their halves exchanged.
    """
    return [curves, curves[::-1]][: len(curves)]


def _products(edges: Sequence[int], left: FloatArray, right: FloatArray) -> FloatArray:
    """Return the products (g, a, b) of the columns ``left`` (size, a) and ``right`` (size, b) in
    each group of orders, between neighbouring ``edges`` (g + 1,).
    """
    found = np.empty((len(edges) - 1, left.shape[1], right.shape[1]))
    for group, (start, stop) in enumerate(itertools.pairwise(edges)):
        np.matmul(left[start:stop].T, right[start:stop], out=found[group])
    return found
