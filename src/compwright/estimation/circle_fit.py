"""The linear model of a circular test, in which each cause is one column.

Each column is weighted by the spectrum of the residuals, with a normal prior for each cause
(Tarantola, Inverse Problem Theory, 2005, chapter 3).

The distance is exact at the centre and the causes of a first least-squares fit; what a second one
would change is below a nanometre.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_centre import recentre
from compwright.estimation.circle_model import (
    AXES,
    ENDS,
    REVERSAL_MARGIN,
    UM,
    CauseColumn,
    CircleSamples,
    SpikeShape,
    TakeUp,
    fixed_columns,
    lag_column,
    spike_columns,
)
from compwright.estimation.circle_noise import (
    AngleGrid,
    IndexArray,
    ResidualSpectrum,
    estimate_spectrum,
    sum_and_difference,
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Reversal:
    """The reversal point of an axis at one end of its travel, and the columns of its spikes.

    ``inside``: the arc contains the point; else only the tail of its spike is in the arc.
    ``shapes`` (m,): what they are, spikes before take-ups; ``alike`` (m,) and ``unlike`` (m,):
    indices of the columns that have the same sign in both directions, and of those that change it
    (none with one direction).
    """

    axis: str
    end: str
    inside: bool
    shapes: tuple[SpikeShape | TakeUp, ...]
    alike: IndexArray
    unlike: IndexArray


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleProblem:
    """The equations of one circular test, transformed and split into two halves (`circle_noise`).

    ``slopes`` (n, p) mm per unit by sample of the ``names`` (p,) that are always in the model;
    ``widths`` (k,): priors of all columns, the spikes of the ``reversals`` after the first p.
    ``rows`` (size, k) by half; ``target`` (n,) and ``aims`` (size,) by half: readings, made linear,
    mm. ``towards_x``, ``towards_y`` (n,): direction of the bar.
    """

    samples: CircleSamples
    grid: AngleGrid
    names: tuple[str, ...]
    slopes: FloatArray
    widths: FloatArray
    rows: tuple[FloatArray, ...]
    target: FloatArray
    aims: tuple[FloatArray, ...]
    towards_x: FloatArray
    towards_y: FloatArray
    reversals: tuple[Reversal, ...]
    spikes: FloatArray

    def seen(self, columns: Sequence[CauseColumn]) -> FloatArray:
        """Return the change of the bar's length by one unit of each cause, mm (n, columns)."""
        return np.column_stack([c.x * self.towards_x + c.y * self.towards_y for c in columns])

    def with_columns(self, columns: Sequence[CauseColumn]) -> CircleProblem:
        """Return the equations with further columns that are always in the model. A new column
        replaces one of the same name.
        """
        fresh = self.seen(columns)
        replaced = {c.name for c in columns}
        keep = [i for i, name in enumerate(self.names) if name not in replaced]
        rest = np.arange(len(self.names), self.widths.size)
        rows = tuple(
            np.column_stack([row[:, keep], new, row[:, rest]])
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
            reversals=tuple(
                replace(r, alike=r.alike + shift, unlike=r.unlike + shift) for r in self.reversals
            ),
        )


def circle_problem(samples: CircleSamples, grid: AngleGrid) -> CircleProblem:
    """Return the equations for these samples, without cyclic errors and vibration."""
    fixed = list(fixed_columns(samples))
    towards, target, known = _linear(samples, fixed)
    if samples.lag_std > 0.0:
        fixed.append(lag_column(samples, known))
    reversals, spikes = _reversals(samples, len(fixed))
    columns = [c.x * towards[0] + c.y * towards[1] for c in fixed]
    slopes = np.column_stack(columns)
    shapes = [c.x * towards[0] + c.y * towards[1] for c in spikes]
    seen = np.column_stack([slopes, *shapes]) if shapes else slopes
    rows = list(sum_and_difference(grid, seen))
    if len(rows) == 2 and shapes:
        # A column that changes sign with the direction has its halves exchanged.
        first = slopes.shape[1]
        rows = [
            np.column_stack([rows[0], rows[1][:, first:]]),
            np.column_stack([rows[1], rows[0][:, first:]]),
        ]
    count = rows[0].shape[1] - len(fixed)
    widths = np.concatenate([[c.width for c in fixed], np.full(count, 1.0)])
    widths[len(fixed) :] = spikes[0].width if spikes else 1.0
    return CircleProblem(
        samples=samples,
        grid=grid,
        names=tuple(c.name for c in fixed),
        slopes=slopes,
        widths=widths,
        rows=tuple(rows),
        target=target,
        aims=sum_and_difference(grid, target),
        towards_x=towards[0],
        towards_y=towards[1],
        reversals=reversals,
        spikes=np.column_stack(shapes) if shapes else np.zeros((samples.theta.size, 0)),
    )


def _linear(
    samples: CircleSamples, fixed: Sequence[CauseColumn]
) -> tuple[tuple[FloatArray, FloatArray], FloatArray, dict[str, float]]:
    """Return the linear equations of the readings about a first fit. Direction of the bar, readings
    (n,) mm, and values of that fit.
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
        values = _solved(slopes.T @ slopes + precision, slopes.T @ target)
    return towards, target, dict(zip(names, (float(value) for value in values), strict=True))


def _solved(normal: FloatArray, right: FloatArray) -> FloatArray:
    unit = 1.0 / np.sqrt(np.diag(normal))
    answer: FloatArray = unit * np.linalg.solve(normal * np.outer(unit, unit), unit * right)
    return answer


def _reversals(
    samples: CircleSamples, first: int
) -> tuple[tuple[Reversal, ...], list[CauseColumn]]:
    spacing = sample_spacing(samples)
    least = max(_SHORTEST * spacing, _QUICKEST * samples.speed)
    most = _LONGEST * samples.radius
    if least >= most:
        return (), []
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
    columns = [c for axis, end, *_ in places for c in spike_columns(samples, axis, end, shapes)]
    alike = first + np.arange(len(columns)).reshape(len(places), len(shapes))
    unlike = alike + len(columns)
    found = tuple(
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
        )
        for index, (axis, end, inside, lasting) in enumerate(places)
    )
    return found, columns


def _lasting(samples: CircleSamples, axis: str) -> list[int]:
    """Return for each reversal point of an axis, positive and negative, how many directions enter
    the arc so soon after it that its spike may last into the arc: the path begins before the arc.
    """
    if samples.arc[1] >= 2.0 * np.pi - 1e-9:
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


def sample_spacing(samples: CircleSamples) -> float:
    """Return the length of arc between neighbouring samples of a run, mm."""
    runs = np.unique(samples.run).size
    return float(samples.radius * samples.arc[1] * runs / samples.theta.size)


@dataclass(frozen=True, slots=True)
class WeightedProblem:
    """The normal equations of a circular test weighted by the spectra of the noise; mm and the
    columns' units.

    ``gram`` (k, k) without priors, ``right`` (k,).
    """

    problem: CircleProblem
    spectra: tuple[ResidualSpectrum, ...]
    gram: FloatArray
    right: FloatArray

    def without(self, always: IndexArray) -> MarginalEquations:
        """Return the normal equations without the columns ``always``, which are integrated under
        their priors (Schur complement).
        """
        prior = self.problem.widths[always] ** -2.0
        normal = self.gram[np.ix_(always, always)] + np.diag(prior)
        shared = scaled_inverse(normal) @ np.column_stack([self.gram[always], self.right[always]])
        return MarginalEquations(
            self.gram - self.gram[:, always] @ shared[:, :-1],
            self.right - self.gram[:, always] @ shared[:, -1],
        )

    def posterior(self, active: IndexArray, precision: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return mean (a,) and covariance (a, a) of the sizes of the ``active`` causes; all others
        are 0. ``precision`` (k,): of the priors of all columns.
        """
        normal = self.gram[np.ix_(active, active)] + np.diag(precision[active])
        covariance = scaled_inverse(normal)
        return covariance @ self.right[active], covariance


@dataclass(frozen=True, slots=True)
class MarginalEquations:
    """Normal equations ``gram`` (k, k) without priors and ``right`` (k,)."""

    gram: FloatArray
    right: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleFit:
    """The solution of a circular test for one choice of spike shapes: values, covariance,
    residuals.

    ``values`` (k,) of the ``active`` columns with ``covariance`` (k, k), and what is left: ``rows``
    (size, k) and ``rest`` (size,) by half, mm, with the ``spectra`` of the weights. ``information``
    (k,): what each column weighs on its own.
    """

    active: IndexArray
    values: FloatArray
    covariance: FloatArray
    information: FloatArray
    rows: tuple[FloatArray, ...]
    rest: tuple[FloatArray, ...]
    spectra: tuple[ResidualSpectrum, ...]


def fit_causes(weighted: WeightedProblem, active: IndexArray, precision: FloatArray) -> CircleFit:
    """Return the least-squares solution for the ``active`` columns. ``precision`` (k,): of the
    priors of all columns.
    """
    values, covariance = weighted.posterior(active, precision)
    problem = weighted.problem
    rows = tuple(half[:, active] for half in problem.rows)
    return CircleFit(
        active=active,
        values=values,
        covariance=covariance,
        information=np.diag(weighted.gram)[active],
        rows=rows,
        rest=tuple(aim - half @ values for aim, half in zip(problem.aims, rows, strict=True)),
        spectra=weighted.spectra,
    )


def fit_evidence(found: CircleFit, precision: FloatArray) -> float:
    """Return the log probability of the readings under a fit, averaged over the possible sizes of
    the causes.

    The values are integrated under their priors of ``precision`` (k,), the noise is as it is
    (Whittle 1953; MacKay, Neural Computation 4, 1992).
    """
    prior = precision[found.active]
    unit = np.sqrt(prior)
    volume = np.linalg.slogdet(found.covariance * np.outer(unit, unit))[1]
    noise = sum(
        float(np.sum(np.log(spectrum.density) + rest**2 / spectrum.density))
        for rest, spectrum in zip(found.rest, found.spectra, strict=True)
    )
    return float(0.5 * volume - 0.5 * np.sum(prior * found.values**2) - 0.5 * noise)


def weighted_problem(
    problem: CircleProblem, spectra: tuple[ResidualSpectrum, ...], only: IndexArray | None = None
) -> WeightedProblem:
    """Return the weighted normal equations; ``only``: all other columns are 0."""
    size = problem.widths.size
    chosen = slice(None) if only is None else only
    gram, right = np.zeros((size, size)), np.zeros(size)
    block = gram if only is None else np.zeros((only.size, only.size))
    for rows, aim, spectrum in zip(problem.rows, problem.aims, spectra, strict=True):
        root = 1.0 / np.sqrt(spectrum.density)
        scaled = rows[:, chosen] * root[:, np.newaxis]
        block += scaled.T @ scaled
        right[chosen] += scaled.T @ (aim * root)
    if only is not None:
        gram[np.ix_(only, only)] = block
    return WeightedProblem(problem, spectra, gram, right)


def white_problems(problem: CircleProblem) -> Iterator[WeightedProblem]:
    """Yield start equations: the noise of all samples is independent and equal. 1 µm each, as quiet
    as the upper half of the orders, and the geometric mean of both.
    """
    loud = np.full(len(problem.aims), 1e-6)
    upper = [aim[aim.size // 2 :] ** 2 for aim in problem.aims]
    # The median of a chi-square of one degree of freedom is 0.455.
    quiet = np.clip([np.median(power) / 0.455 for power in upper], 1e-14, 1e-6)
    halves = [
        (rows.T @ rows, rows.T @ aim) for rows, aim in zip(problem.rows, problem.aims, strict=True)
    ]
    for level in (loud, np.sqrt(loud * quiet), quiet):
        gram, right = (
            np.sum([part / each for part, each in zip(parts, level, strict=True)], axis=0)
            for parts in zip(*halves, strict=True)
        )
        spectra = tuple(ResidualSpectrum(np.full(problem.grid.size, v), 1.0) for v in level)
        yield WeightedProblem(problem, spectra, gram, right)


def residual_spectra(found: CircleFit) -> tuple[ResidualSpectrum, ...]:
    """Return the noise spectra from the residuals of a fit.

    The leverage of an ordinate is its diagonal of the hat matrix (Belsley, Kuh and Welsch,
    Regression Diagnostics, 1980, chapter 2).
    """
    spectra = []
    for rows, rest, spectrum in zip(found.rows, found.rest, found.spectra, strict=True):
        leverage = np.sum((rows @ found.covariance) * rows, axis=1) / spectrum.density
        spectra.append(estimate_spectrum(rest, leverage))
    return tuple(spectra)


def fitted_path(problem: CircleProblem, active: IndexArray, values: FloatArray) -> FloatArray:
    """Return the deviations of the samples by the sizes ``values`` (a,) of the ``active`` causes,
    mm (n,).
    """
    every = np.zeros(problem.widths.size)
    every[active] = values
    count, half = len(problem.names), problem.spikes.shape[1]
    plain, alike, unlike = np.split(every, [count, count + half])
    spikes = problem.spikes @ alike
    if unlike.size:
        spikes = spikes + problem.samples.sense * (problem.spikes @ unlike)
    path: FloatArray = problem.slopes @ plain + spikes
    return path


def scaled_inverse(normal: FloatArray) -> FloatArray:
    """Return the inverse of a normal matrix (k, k), scaled to a unit diagonal for accuracy.

    Nearly the best scaling (van der Sluis, Numerische Mathematik 14, 1969).
    """
    unit = 1.0 / np.sqrt(np.diag(normal))
    scale = np.outer(unit, unit)
    inverse: FloatArray = scale * np.linalg.inv(normal * scale)
    return 0.5 * (inverse + inverse.T)
