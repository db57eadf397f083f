"""Weighted least squares of all causes over both runs, at the exact distance: Gauss-Newton on |R u
+ displacements| (Seber and Wild, Nonlinear Regression, 1989, chapter 2). A width of a cause is a
normal prior, which adds its precision to the normal matrix (Tarantola, Inverse Problem Theory,
2005, chapter 3).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.circle_centre import recentre
from compwright.estimation.circle_model import (
    AXES,
    CauseColumn,
    Samples,
    cyclic_columns,
    fixed_columns,
    lag_column,
    spike_columns,
)
from compwright.estimation.circle_noise import AngleGrid, Spectrum, halves, spectrum_of
from compwright.records.axis import FloatArray

_SETTLED: Final = 0.02  # change in standard errors that no interval shows
#: Decay of a spike: the likeliest length as a share of the radius, and the spread of its logarithm.
SPIKE_SHARE: Final = 0.03
_SPIKE_SPREAD: Final = 0.8
_SPIKE_STEP: Final = 0.7  # largest change of log length in one round
_SPIKE_LIMITS: Final = (
    0.15,
    6.0,
)  # times the likeliest length: shorter is a single sample, longer is not a spike


@dataclass(frozen=True, slots=True)
class Shapes:
    """What is not linear: decay lengths of the spikes (mm, by axis) and the frequencies of cyclic
    errors (1/mm, by axis).

    ``given``: axes whose frequency was given and is not fitted.
    """

    lengths: dict[str, float]
    frequencies: dict[str, float]
    given: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True, kw_only=True)
class Fit:
    """The solution: ``values`` (k,) by ``names``, with ``covariance`` (k, k); ``residual`` (n,) mm
    by sample.

    ``x``, ``y`` (n, k): displacements per unit, mm. ``rows`` and ``rest``: transformed rows (size,
    k) and residuals (size,) of each half, mm, with ``spectra``, the density that the covariance
    rests on. ``information`` (k,): what each column would weigh on its own.
    """

    names: tuple[str, ...]
    values: FloatArray
    covariance: FloatArray
    information: FloatArray
    residual: FloatArray
    x: FloatArray
    y: FloatArray
    rows: tuple[FloatArray, ...]
    rest: tuple[FloatArray, ...]
    spectra: tuple[Spectrum, ...]
    shapes: Shapes

    def value(self, name: str) -> float:
        """Return one value by its name."""
        return float(self.values[self.names.index(name)])

    @property
    def known(self) -> dict[str, float]:
        """Return the values by name."""
        return dict(zip(self.names, (float(value) for value in self.values), strict=True))


@dataclass(frozen=True, slots=True, kw_only=True)
class Problem:
    """What all fits of one test share: the columns without a free shape, ``x``, ``y`` (n, k) mm,
    and the way to the ball.

    ``towards_x``, ``towards_y`` (n,): direction of the bar, from the centre by least squares;
    causes turn it by less than a thousandth, which slows no round of Gauss-Newton. ``slopes`` (n,
    k) and ``rows`` (size, k) by half: the columns seen by the bar and their transforms. ``start``:
    that centre, by name.
    """

    samples: Samples
    grid: AngleGrid
    fixed: tuple[CauseColumn, ...]
    x: FloatArray
    y: FloatArray
    towards_x: FloatArray
    towards_y: FloatArray
    slopes: FloatArray
    rows: tuple[FloatArray, ...]
    start: dict[str, float]


def problem_of(samples: Samples, grid: AngleGrid) -> Problem:
    """Return what the fits of these samples share."""
    fixed = fixed_columns(samples)
    x = np.ascontiguousarray(np.array([column.x for column in fixed]).T)
    y = np.ascontiguousarray(np.array([column.y for column in fixed]).T)
    centre_x, centre_y, mean = recentre(samples.theta, samples.deviations, samples.radius)
    along, across = (
        samples.radius * np.cos(samples.theta) + centre_x,
        samples.radius * np.sin(samples.theta) + centre_y,
    )
    distance = np.hypot(along, across)
    slopes = x * (along / distance)[:, np.newaxis] + y * (across / distance)[:, np.newaxis]
    return Problem(
        samples=samples,
        grid=grid,
        fixed=fixed,
        x=x,
        y=y,
        towards_x=along / distance,
        towards_y=across / distance,
        slopes=slopes,
        rows=halves(grid, slopes),
        start={"_centre_x": centre_x, "_centre_y": centre_y, "_radius": mean},
    )


def first_fit(problem: Problem, shapes: Shapes) -> Fit:
    """Return a fit with ``shapes`` as they are and all samples independent and alike (1 µm each),
    to see the residuals.
    """
    white = tuple(Spectrum(np.full(problem.grid.size, 1e-6), 1.0) for _ in problem.grid.index)
    return fit(problem, shapes, white, problem.start, rounds=2, hold=True)


def spectra_of(found: Fit) -> tuple[Spectrum, ...]:
    """Return the spectra of the residuals of a fit; the leverage of an ordinate is its diagonal of
    the hat matrix (Belsley, Kuh and Welsch, Regression Diagnostics, 1980, chapter 2).
    """
    spectra = []
    for rows, rest, spectrum in zip(found.rows, found.rest, found.spectra, strict=True):
        leverage = np.sum((rows @ found.covariance) * rows, axis=1) / spectrum.density
        spectra.append(spectrum_of(rest, leverage))
    return tuple(spectra)


def fit(
    problem: Problem,
    shapes: Shapes,
    spectra: tuple[Spectrum, ...],
    known: dict[str, float],
    *,
    rounds: int = 10,
    hold: bool = False,
) -> Fit:
    """Return the least-squares fit weighted by ``spectra``, from ``shapes`` and the values
    ``known`` by name as its start (Gauss-Newton: Seber and Wild 1989, chapter 2).

    ``hold``: the shapes stay; else lengths and frequencies are fitted along. Distances are exact in
    every round.
    """
    steps = _Steps(problem, spectra)
    for _ in range(rounds):
        free = tuple(_free_columns(problem.samples, shapes, known, hold=hold))
        values = np.array(
            [0.0 if _is_shape(c.name) else known.get(c.name, 0.0) for c in (*problem.fixed, *free)]
        )
        solved = steps.solved(
            free, values, _prior((*problem.fixed, *free), problem.samples, shapes)
        )
        known = {
            c.name: float(value)
            for c, value in zip((*problem.fixed, *free), values + solved.step, strict=True)
        }
        if not hold:
            shapes = _moved(shapes, known, problem.samples.radius)
        if np.max(np.abs(solved.step) * np.sqrt(solved.information)) < _SETTLED:
            break
    slopes = np.column_stack([problem.slopes, solved.own[:, :-1]])
    rows = tuple(
        np.column_stack([fixed, part[:, :-1]])
        for fixed, part in zip(problem.rows, solved.parts, strict=True)
    )
    return Fit(
        names=tuple(column.name for column in (*problem.fixed, *free)),
        values=values + solved.step,
        covariance=inverse_of(solved.normal),
        information=solved.information,
        residual=solved.residual - slopes @ solved.step,
        x=np.column_stack([problem.x, *(column.x for column in free)]),
        y=np.column_stack([problem.y, *(column.y for column in free)]),
        rows=rows,
        rest=tuple(
            part[:, -1] - half @ solved.step for part, half in zip(solved.parts, rows, strict=True)
        ),
        spectra=spectra,
        shapes=shapes,
    )


@dataclass(frozen=True, slots=True)
class _Step:
    """One round of Gauss-Newton: its step (k,), and what it was solved from.

    ``own``: slopes of the free columns and, last, the residual (n, f + 1), mm; ``parts``: their
    transforms by half.
    """

    step: FloatArray
    normal: FloatArray
    information: FloatArray
    residual: FloatArray
    own: FloatArray
    parts: tuple[FloatArray, ...]


class _Steps:
    """Rounds of one fit; products of the fixed columns are made once."""

    def __init__(self, problem: Problem, spectra: tuple[Spectrum, ...]) -> None:
        self.problem, self.spectra = problem, spectra
        self.cos, self.sin = np.cos(problem.samples.theta), np.sin(problem.samples.theta)
        self.weighted = [
            rows / spectrum.density[:, np.newaxis]
            for rows, spectrum in zip(problem.rows, spectra, strict=True)
        ]
        size = len(problem.fixed)
        self.block = sum(
            (rows.T @ part for rows, part in zip(problem.rows, self.weighted, strict=True)),
            np.zeros((size, size)),
        )

    def solved(
        self,
        free: tuple[CauseColumn, ...],
        values: FloatArray,
        prior: tuple[FloatArray, FloatArray],
    ) -> _Step:
        """Return the step from ``values`` (k,); ``prior``: precision (k,) and where it draws each
        step to (k,).
        """
        problem, samples, size = self.problem, self.problem.samples, len(self.problem.fixed)
        along = samples.radius * self.cos + problem.x @ values[:size]
        across = samples.radius * self.sin + problem.y @ values[:size]
        own = np.empty((samples.theta.size, len(free) + 1))
        for index, (column, value) in enumerate(zip(free, values[size:], strict=True)):
            along += value * column.x
            across += value * column.y
            own[:, index] = column.x * problem.towards_x + column.y * problem.towards_y
        residual = samples.radius + samples.deviations - np.hypot(along, across)
        own[:, -1] = residual
        count = size + len(free)
        normal, right = np.zeros((count, count)), np.zeros(count)
        normal[:size, :size] = self.block
        parts = halves(problem.grid, own)
        for part, weighted, spectrum in zip(parts, self.weighted, self.spectra, strict=True):
            shared = weighted.T @ part
            within = part[:, :-1].T @ (part / spectrum.density[:, np.newaxis])
            normal[:size, size:] += shared[:, :-1]
            normal[size:, size:] += within[:, :-1]
            right += np.concatenate([shared[:, -1], within[:, -1]])
        normal[size:, :size] = normal[:size, size:].T
        information = np.diag(normal).copy()
        precision, aim = prior
        normal.flat[:: count + 1] += precision
        return _Step(
            step=_solved(normal, right + precision * (aim - values)),
            normal=normal,
            information=information,
            residual=residual,
            own=own,
            parts=parts,
        )


def _is_shape(name: str) -> bool:
    return name.startswith(("_length_", "_frequency_"))


def _free_columns(
    samples: Samples, shapes: Shapes, known: dict[str, float], *, hold: bool
) -> list[CauseColumn]:
    columns: list[CauseColumn] = []
    for axis, length in shapes.lengths.items():
        spike = spike_columns(samples, axis, length, known.get(f"reversal_spike_{axis}", 0.0))
        columns += spike[:1] if hold else spike
    for axis, frequency in shapes.frequencies.items():
        amplitudes = known.get(f"_cyclic_cos_{axis}", 0.0), known.get(f"_cyclic_sin_{axis}", 0.0)
        wanted = cyclic_columns(samples, axis, frequency, amplitudes)
        columns += wanted[:2] if hold or axis in shapes.given else wanted
    if samples.lag_doubt > 0.0:
        columns.append(lag_column(samples, known))
    return columns


def _prior(
    columns: tuple[CauseColumn, ...], samples: Samples, shapes: Shapes
) -> tuple[FloatArray, FloatArray]:
    """Return the precision of each column's prior and where it draws to. Only the lengths of spikes
    are drawn anywhere.
    """
    precision = np.array([column.width for column in columns]) ** -2.0
    aim = np.zeros(len(columns))
    for index, column in enumerate(columns):
        if column.name.startswith("_length_"):
            length = shapes.lengths[column.name.removeprefix("_length_")]
            precision[index] = _SPIKE_SPREAD**-2.0
            aim[index] = np.log(SPIKE_SHARE * samples.radius / length)
    return precision, aim


def _solved(normal: FloatArray, right: FloatArray) -> FloatArray:
    unit = 1.0 / np.sqrt(np.diag(normal))
    answer: FloatArray = unit * np.linalg.solve(normal * np.outer(unit, unit), unit * right)
    return answer


def inverse_of(normal: FloatArray) -> FloatArray:
    """Return the inverse of a normal matrix (k, k), scaled to a unit diagonal on the way, which is
    nearly the best scaling (van der Sluis, Numerische Mathematik 14, 1969).
    """
    unit = 1.0 / np.sqrt(np.diag(normal))
    scale = np.outer(unit, unit)
    inverse: FloatArray = scale * np.linalg.inv(normal * scale)
    return 0.5 * (inverse + inverse.T)


def _moved(shapes: Shapes, known: dict[str, float], radius: float) -> Shapes:
    """Return the shapes after one round, no step longer than its straight line is good for."""
    least, most = (factor * SPIKE_SHARE * radius for factor in _SPIKE_LIMITS)
    lengths = {
        axis: float(
            np.clip(
                length * np.exp(np.clip(known[f"_length_{axis}"], -_SPIKE_STEP, _SPIKE_STEP)),
                least,
                most,
            )
        )
        for axis, length in shapes.lengths.items()
    }
    frequencies = {
        axis: frequency + known.get(f"_frequency_{axis}", 0.0)
        for axis, frequency in shapes.frequencies.items()
    }
    return Shapes(lengths, frequencies, shapes.given)


def default_shapes(samples: Samples) -> Shapes:
    """Return the shapes before anything was searched: spikes of the likeliest length where an axis
    reverses.
    """
    return Shapes(
        {axis: SPIKE_SHARE * samples.radius for axis in AXES if any(samples.reversals(axis))}, {}
    )
