"""The linear model of a circular test. Each column of its matrix is one cause of deviations.

The equations are weighted by the noise spectrum of the residuals. Each cause has a normal prior
(Tarantola, Inverse Problem Theory, 2005, chapter 3). The measured distance is linearised about the
centre and the causes of a first least-squares fit. A second fit would change it by less than a
nanometre.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.circle_centre import recentre
from compwright.estimation.circle_model import (
    AXES,
    ENDS,
    PRIORS,
    REVERSAL_MARGIN,
    UM,
    CauseColumn,
    CircleSamples,
    SpikeShape,
    TakeUp,
    changeover_columns,
    fixed_columns,
    lag_column,
    sample_spacing,
    spike_curves,
)
from compwright.estimation.circle_noise import (
    SINGLE,
    AngleGrid,
    IndexArray,
    order_groups,
    sum_and_difference,
)
from compwright.estimation.circle_products import PooledProducts, pooled_products
from compwright.estimation.circle_readings import (
    early_columns,
    mean_column,
    means,
    readings_near_reversals,
)
from compwright.records.axis import FloatArray

#: Shortest length of a reversal spike in samples and in seconds, longest as a share of the radius,
#: the lengths after which nothing is left of it, and the ratio of two lengths.
_SHORTEST: Final = 0.3
_QUICKEST: Final = 0.004
_LONGEST: Final = 0.25
_LASTING: Final = 3.0
_RATIO: Final = 1.3
#: Lost motion that is taken up while the axis stands still, um: least and most, and the ratio of
#: two lengths.
_TAKEN: Final = (0.2, 30.0)
_TAKEN_RATIO: Final = 1.35
#: A take-up shorter than this, in samples, is over before it is seen.
_SEEN: Final = 0.6
#: A shape of which no sample shows this share is no hypothesis: its size would be its prior.
_LEAST_SEEN: Final = 1e-3
#: Share of a spike that is left out when all shapes are made of fewer curves: a nanometre of the
#: size that its prior (`PRIORS`) expects.
_NEGLIGIBLE: Final = 1e-4


@dataclass(frozen=True, slots=True, kw_only=True)
class Reversal:
    """The reversal point of an axis at one end of its travel, and the model columns of its spikes.

    ``inside``: the arc contains the point. If not, only the last part of its spike is in the arc.
    ``shapes`` (m,): possible shapes; spikes first, then gradual take-ups of lost motion. ``alike``
    (m,): indices of the columns with equal sign in both directions. ``unlike`` (m,): indices of the
    columns that change sign with the direction; empty for a test in one direction. ``seen`` (m,):
    whether a sample shows the shape.
    """

    axis: str
    end: str
    inside: bool
    shapes: tuple[SpikeShape | TakeUp, ...]
    alike: IndexArray
    unlike: IndexArray
    seen: NDArray[np.bool_]

    def options(self, kind: type[SpikeShape | TakeUp]) -> IndexArray:
        """Return the indices of the shapes of this ``kind`` that a sample shows."""
        return np.flatnonzero(self.seen & [isinstance(shape, kind) for shape in self.shapes])


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleProblem:
    """The equations of a circular test: transformed sum and difference of both directions' samples.

    There are n samples, p columns that are always in the model, and r ``reversals`` with m possible
    spike shapes each. ``slopes`` (n, p): change of the distance, mm, per unit of each cause in
    ``names`` (p,). ``widths`` (k,): prior standard deviations of all columns; k = p + r * m, with
    two directions p + 2 * r * m. ``spikes`` (n, r * q): q curves per reversal, whose sums with the
    weights ``mixture`` (q, m) are the spike shapes. ``target`` (n,): linearised readings, mm.
    ``towards_x``, ``towards_y`` (n,): direction of the bar. ``rows``, ``curves`` and ``aims`` have
    one array each for the sum and the difference: ``slopes`` (size, p), ``spikes`` (size, r * q)
    and readings (size,), mm, transformed. ``products``: those of rows and curves. ``removed``: a
    vibration, mm, that is already subtracted from ``target``.
    """

    samples: CircleSamples
    grid: AngleGrid
    names: tuple[str, ...]
    slopes: FloatArray
    widths: FloatArray
    rows: tuple[FloatArray, ...]
    curves: tuple[FloatArray, ...]
    products: PooledProducts
    target: FloatArray
    aims: tuple[FloatArray, ...]
    towards_x: FloatArray
    towards_y: FloatArray
    reversals: tuple[Reversal, ...]
    spikes: FloatArray
    mixture: FloatArray
    removed: FloatArray | float

    def spiked(self, right: FloatArray) -> FloatArray:
        """Return ``right`` with one column per spike shape instead of those of common curves."""
        count, (curves, shapes) = len(self.names), self.mixture.shape
        if not shapes:
            return right
        mixed = right[..., count:].reshape(-1, curves) @ self.mixture
        return np.concatenate([right[..., :count], mixed.reshape(*right.shape[:-1], -1)], axis=-1)

    def rows_of(self, active: IndexArray) -> tuple[FloatArray, ...]:
        """Return matrices (size, a) of sum and difference of samples, only ``active`` columns."""
        fixed = np.flatnonzero(active < len(self.names))
        curves, shapes = self.mixture.shape
        spikes = np.flatnonzero(active >= len(self.names))
        blocks, places = np.divmod(active[spikes] - len(self.names), max(shapes, 1))
        found = tuple(np.empty((active.size, half.shape[0])).T for half in self.rows)
        for half, rows in enumerate(found):
            rows[:, fixed] = self.rows[half][:, active[fixed]]
            for block in np.unique(blocks).tolist():
                sign, reversal = divmod(block, len(self.reversals))
                mine, start = blocks == block, reversal * curves
                # Columns that change sign with the direction have their halves exchanged.
                every = self.curves[half - sign][:, start : start + curves]
                rows[:, spikes[mine]] = every @ self.mixture[:, places[mine]]
        return found

    def spike_curves(self, sizes: FloatArray) -> FloatArray:
        """Return the deviations, mm (s, n), by spikes of ``sizes`` (s, reversals, shapes)."""
        curves: FloatArray = (sizes @ self.mixture.T).reshape(len(sizes), -1) @ self.spikes.T
        return curves

    def seen(self, columns: Sequence[CauseColumn]) -> FloatArray:
        """Return the change of the measured distance by one unit of each cause, mm (n, columns)."""
        return np.array([c.x * self.towards_x + c.y * self.towards_y for c in columns]).T

    def with_columns(self, columns: Sequence[CauseColumn]) -> CircleProblem:
        """Return the equations with further causes (columns) that are always in the model. A new
        column replaces the column of the same name.
        """
        fresh = self.seen(columns)
        replaced = {c.name for c in columns}
        keep = [i for i, name in enumerate(self.names) if name not in replaced]
        rest = slice(len(self.names), None)
        rows = tuple(
            np.column_stack([row[:, keep], new])
            for row, new in zip(self.rows, sum_and_difference(self.grid, fresh), strict=True)
        )
        widths = np.concatenate([self.widths[keep], [c.width for c in columns], self.widths[rest]])
        shift = len(keep) + len(columns) - len(self.names)
        return replace(
            self,
            names=(*(self.names[i] for i in keep), *(c.name for c in columns)),
            slopes=np.column_stack([self.slopes[:, keep], fresh]),
            widths=widths,
            rows=rows,
            products=self.products.with_columns(keep, rows, self.curves),
            reversals=tuple(
                replace(r, alike=r.alike + shift, unlike=r.unlike + shift) for r in self.reversals
            ),
        )


def circle_problem(
    samples: CircleSamples, grid: AngleGrid, removed: FloatArray | float = 0.0
) -> CircleProblem:
    """Return the equations of a circular test, without cyclic errors and vibration. ``removed``: a
    vibration (n,), mm, to subtract from the readings.
    """
    readings, first = readings_near_reversals(samples)
    fixed = [mean_column(column, first) for column in fixed_columns(readings)]
    towards, target, known = _linear(samples, fixed)
    target = target - removed
    fixed += (*changeover_columns(samples), *early_columns(samples))
    if samples.lag_std > 0.0:
        fixed.append(lag_column(samples, fixed, known))
    slopes = np.array([c.x * towards[0] + c.y * towards[1] for c in fixed]).T
    reversals, shapes = _reversals(samples, len(fixed)), np.zeros((0, 0, samples.theta.size))
    if reversals:
        spikes = [spike_curves(readings, r.axis, r.end, r.shapes) for r in reversals]
        moved = zip(reversals, (means(each, first) for each in spikes), strict=True)
        shapes = np.array([each * towards[AXES.index(r.axis)] for r, each in moved])
        seen = np.max(np.abs(shapes), axis=2) > _LEAST_SEEN * UM
        reversals = tuple(replace(r, seen=s) for r, s in zip(reversals, seen, strict=True))
    curves, mixture = _common_curves(shapes)
    groups = order_groups(grid.size)[SINGLE:] if samples.averaged > 1 else np.arange(0)
    rows, curved = (sum_and_difference(grid, each) for each in (slopes, curves))
    widths = np.full(len(fixed) + shapes[..., 0].size * len(rows), PRIORS["_spike"])
    widths[: len(fixed)] = [c.width for c in fixed]
    return CircleProblem(
        samples=samples,
        grid=grid,
        names=tuple(c.name for c in fixed),
        slopes=slopes,
        widths=widths,
        rows=rows,
        curves=curved,
        products=pooled_products(rows, curved, groups),
        target=target,
        aims=sum_and_difference(grid, target),
        towards_x=towards[0],
        towards_y=towards[1],
        reversals=reversals,
        spikes=curves,
        mixture=mixture,
        removed=removed,
    )


def _common_curves(shapes: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return q common curves (n, r * q) and weights (q, m). The weighted sums of the curves are all
    spike ``shapes`` (r, m, n) of r reversals.

    Decays of similar lengths are nearly dependent. Half as many principal components of the shapes,
    each scaled to the same norm, make all of them up to the share `_NEGLIGIBLE` (Golub and Van
    Loan, Matrix Computations, 4th ed. 2013, section 2.4).
    """
    if not shapes.size:
        return np.zeros((shapes.shape[2], 0)), np.zeros((0, shapes.shape[1]))
    products = np.sum(shapes @ np.swapaxes(shapes, 1, 2), axis=0)
    norms = np.sqrt(np.maximum(np.diag(products), 1e-300))
    energy, vectors = np.linalg.eigh(products / np.outer(norms, norms))
    left = np.cumsum(energy * vectors**2, axis=1)
    vectors = vectors[:, np.max(left, axis=0) > _NEGLIGIBLE**2]
    curves = (vectors.T / norms) @ shapes
    return curves.reshape(-1, shapes.shape[2]).T, vectors.T * norms


def _linear(
    samples: CircleSamples, fixed: Sequence[CauseColumn]
) -> tuple[tuple[FloatArray, FloatArray], FloatArray, dict[str, float]]:
    """Return the equations of a circular test, linearised about a first fit of ``fixed`` causes.
    The results are the direction of the bar (x and y, each (n,)), the linearised readings (n,) in
    mm, and the sizes of the causes in the first fit by name.
    """
    x, y = (np.column_stack([getattr(c, side) for c in fixed]) for side in ("x", "y"))
    cos, sin = np.cos(samples.theta), np.sin(samples.theta)
    values = np.zeros(len(fixed))
    names = [c.name for c in fixed]
    start = recentre(samples.theta, samples.deviations, samples.radius)
    for name, value in zip(("_centre_x", "_centre_y", "_radius"), start, strict=True):
        values[names.index(name)] = value
    precision = np.diag(1e-6 * np.array([c.width for c in fixed]) ** -2.0)
    for _ in range(2):
        along = samples.radius * cos + x @ values
        across = samples.radius * sin + y @ values
        distance = np.hypot(along, across)
        towards = along / distance, across / distance
        slopes = x * towards[0][:, np.newaxis] + y * towards[1][:, np.newaxis]
        target = samples.radius + samples.deviations - distance + slopes @ values
        values = scaled_inverse(slopes.T @ slopes + precision) @ (slopes.T @ target)
    return towards, target, dict(zip(names, (float(value) for value in values), strict=True))


def _reversals(samples: CircleSamples, first: int) -> tuple[Reversal, ...]:
    """Return the reversal points whose spikes are in the arc, all with the same possible shapes.
    ``first``: index of the first column of a spike.
    """
    spacing = sample_spacing(samples)
    least = max(_SHORTEST * spacing, _QUICKEST * samples.speed)
    most = _LONGEST * samples.radius
    if least >= most:
        return ()
    count = int(np.ceil(np.log(most / least) / np.log(_RATIO))) + 1
    spikes = [
        SpikeShape(float(length), rising)
        for rising in (False, True)
        for length in np.geomspace(least, most, count)
        if not (rising and length < spacing)
    ]
    shapes: tuple[SpikeShape | TakeUp, ...] = (*spikes, *_take_ups(samples.radius, spacing))
    places = [
        (axis, end, inside, lasting)
        for axis in AXES
        for end, inside, lasting in zip(
            ENDS, samples.reversals(axis), _lasting(samples, axis), strict=True
        )
        if inside or lasting
    ]
    alike = first + np.arange(len(places) * len(shapes)).reshape(len(places), len(shapes))
    unlike = alike + alike.size
    return tuple(
        Reversal(
            axis=axis,
            end=end,
            inside=inside,
            shapes=shapes,
            alike=alike[index],
            unlike=(
                unlike[index]
                if samples.both_senses and (inside or lasting == 2)
                else np.empty(0, dtype=np.intp)
            ),
            seen=np.ones(len(shapes), dtype=bool),
        )
        for index, (axis, end, inside, lasting) in enumerate(places)
    )


def _lasting(samples: CircleSamples, axis: str) -> list[int]:
    """Return, for both reversal points of an axis, in how many directions the arc begins so shortly
    after this point that a reversal spike can continue inside the arc.
    """
    if samples.full_circle:
        return [0, 0]
    start = 0.0 if axis == "first" else 0.5 * np.pi
    counts = []
    for point in (start, start + np.pi):
        since = [
            sense * (samples.arc[0] + (0.0 if sense > 0.0 else samples.arc[1]) - point)
            for sense in np.unique(samples.sense)
        ]
        after = np.mod(np.add(since, REVERSAL_MARGIN), 2.0 * np.pi) - REVERSAL_MARGIN
        counts.append(int(np.sum(after < _LASTING * _LONGEST)))
    return counts


def _take_ups(radius: float, spacing: float) -> list[TakeUp]:
    least, most = (float(np.sqrt(2.0 * UM * lost * radius)) for lost in _TAKEN)
    least = max(least, _SEEN * spacing)
    if least >= most:
        return []
    count = int(np.ceil(np.log(most / least) / np.log(_TAKEN_RATIO))) + 1
    return [TakeUp(float(length)) for length in np.geomspace(least, most, count)]


def scaled_inverse(normal: FloatArray) -> FloatArray:
    """Return the inverse of a normal matrix (k, k), scaled to a unit diagonal for accuracy. This
    scaling is nearly the best (van der Sluis, Numerische Mathematik 14, 1969).
    """
    unit = 1.0 / np.sqrt(np.diag(normal))
    scale = np.outer(unit, unit)
    inverse: FloatArray = scale * np.linalg.inv(normal * scale)
    return 0.5 * (inverse + inverse.T)
