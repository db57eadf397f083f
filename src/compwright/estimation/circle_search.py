"""The search for the causes of a circular test that are not in every model. Reversal spikes and a
common lag are chosen with the first fit. Of a cyclic error and a vibration, the more probable one
is added first, then the residuals are searched again (orthogonal matching pursuit: Pati, Rezaiifar
and Krishnaprasad, Asilomar Conference on Signals, Systems and Computers 27, 1993). What was added
is not tested again.
"""

from __future__ import annotations

import copy
import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_cyclic import CyclicSearch, search_cyclic
from compwright.estimation.circle_equations import CircleProblem, circle_problem, scaled_inverse
from compwright.estimation.circle_fit import (
    CircleFit,
    WeightedProblem,
    fit_causes,
    fit_evidence,
    fitted_path,
    normal_equations,
    residual_spectra,
    weighted_problem,
    white_problems,
)
from compwright.estimation.circle_lag import Lag, at_actual_angles, with_undetected_lag
from compwright.estimation.circle_model import AXES, CircleSamples, cyclic_columns
from compwright.estimation.circle_noise import AngleGrid, sum_and_difference
from compwright.estimation.circle_reversal import choose_shapes, draw_shapes
from compwright.estimation.circle_shapes import SpikeShapes
from compwright.estimation.circle_solution import Solution
from compwright.estimation.circle_vibration import (
    Vibration,
    search_between_means,
    search_vibration,
    vibration_columns,
)

#: Rounds in which the frequency of a cyclic error is fitted.
_TUNING_ROUNDS: Final = 4
#: The noise is estimated again, so often at most, while its density at order zero still changes by
#: this share.
_NOISE_ROUNDS: Final = 3
_NOISE_STEADY: Final = 0.25


@dataclass(frozen=True, slots=True)
class CircleStart:
    """A fit of a circular test from which further searches start: the equations, the spike shapes
    and the solution.
    """

    problem: CircleProblem
    shapes: SpikeShapes
    fitted: CircleFit

    @property
    def evidence(self) -> float:
        """The log probability of the readings and the spike shapes under this fit."""
        return fit_evidence(self.fitted, self.shapes.precision) + self.shapes.log_prior

    def cyclic(self, axes: Sequence[str]) -> CyclicSearch:
        """Return the result of the search for cyclic errors of the ``axes``. The causes are fitted
        again first: the covariance has to belong to the last noise spectra.
        """
        active = self.fitted.active
        weighted = weighted_problem(self.problem, self.fitted.spectra, active)
        return search_cyclic(
            self.problem, fit_causes(weighted, active, self.shapes.precision), axes
        )


def start_fit(samples: CircleSamples, grid: AngleGrid, lag: Lag) -> CircleStart:
    """Return the first fit of a circular test. It includes the common ``lag`` of both axes if this
    is clear and explains the samples better.

    Next to the reversal points, lost motion that is taken up while an axis stands still looks like
    a lag. Therefore the model is fitted with and without the lag, and the evidence of the whole
    model decides.
    """
    without = _likeliest(circle_problem(with_undetected_lag(samples, lag), grid))
    if not lag.clear:
        return without
    late = _likeliest(circle_problem(at_actual_angles(samples, lag), grid))
    return late if late.evidence > without.evidence else without


def _likeliest(problem: CircleProblem, *starts: CircleStart) -> CircleStart:
    """Return the most probable fit of a circular test. Several fits are tried: from the spike
    shapes and the noise of each of the given fits ``starts``, and from assumed levels of white
    noise. With a given fit, only the highest of these levels is tried.

    Several starts are needed because spike shapes are changed one at a time, which leads to the
    nearest optimum only. Noise can be fitted as a spike, or a spike as noise.
    """
    white = itertools.islice(white_problems(problem), 1 if starts else None)
    every = [(copy.deepcopy(s.shapes), weighted_problem(problem, s.fitted.spectra)) for s in starts]
    every += [(SpikeShapes(problem), weighted) for weighted in white]
    fits = (CircleStart(problem, each, _fit_with_noise(w, each)) for each, w in every)
    return max(fits, key=lambda each: each.evidence)


def without_fast_vibration(
    start: CircleStart, every: CircleSamples
) -> tuple[CircleStart, Vibration]:
    """Return the fit of a circular test without the vibration that its samples, means of
    neighbours among ``every`` reading, cannot show; and this vibration.
    """
    problem, fitted = start.problem, start.fitted
    rest = problem.target - fitted_path(problem, fitted)
    found, wave = search_between_means(every, problem, rest)
    if found.frequency is None:
        return start, found
    target = problem.target - wave
    aims = sum_and_difference(problem.grid, target)
    return _likeliest(replace(problem, target=target, aims=aims), start), found


def solve(start: CircleStart, given: dict[str, float], fast: Vibration) -> Solution:
    """Return the full solution of a circular test: noise, reversal spikes, cyclic errors and
    vibration. ``given``: known frequencies of cyclic errors, 1/mm, by axis. ``fast``: vibration
    that the samples, means of readings, cannot show.

    A vibration hides cyclic errors, and a cyclic error a vibration. Of the two, the one that
    explains the samples better is added first, and the other is searched again.
    """
    frequencies = dict(given)
    for axis, frequency in given.items():
        problem, _ = _fit_cyclic(start, axis, frequency, known=True)
        start = replace(start, problem=problem)
    if given:
        start = _likeliest(start.problem, start)
    slow, hidden, changed = Vibration(), dict[str, float](), True
    while changed:
        periodic, changed = None, False
        shaken, found = _with_vibration(start) if slow.frequency is None else (None, slow)
        open_axes = [axis for axis in AXES if axis not in frequencies]
        if open_axes:
            cyclic = start.cyclic(open_axes)
            hidden = dict(cyclic.hidden)
            for axis, frequency in cyclic.found.items():
                problem, tuned = _fit_cyclic(start, axis, frequency)
                periodic = _likeliest(problem, start)
        if periodic is not None and (shaken is None or periodic.evidence > shaken.evidence):
            start, frequencies[axis], changed = periodic, tuned, True
            continue  # a vibration that was found is searched again
        slow = found
        if shaken is not None:
            start, changed = shaken, True
    problem, shapes, fitted = start.problem, start.shapes, start.fitted
    draws = draw_shapes(
        weighted_problem(problem, fitted.spectra),
        shapes,
        np.random.default_rng(problem.target.size),
    )
    return Solution(
        problem=problem,
        fitted=fitted,
        draws=draws,
        frequencies=frequencies,
        given=frozenset(given),
        hidden=hidden,
        vibration=slow.or_stronger(fast),
    )


def _fit_with_noise(weighted: WeightedProblem, shapes: SpikeShapes) -> CircleFit:
    """Return the fit whose weights agree with the noise spectra of its own residuals. The iteration
    starts with the noise of ``weighted``.

    The method is iterated two-stage least squares (Seber and Wild, Nonlinear Regression, 1989,
    chapter 6).
    """
    shapes.adopt(weighted.problem)
    spectra = weighted.spectra
    for number in range(_NOISE_ROUNDS):
        if number:
            weighted = weighted_problem(weighted.problem, spectra)
        choose_shapes(weighted, shapes)
        fitted = fit_causes(weighted, shapes.active(), shapes.precision)
        spectra = residual_spectra(fitted)
        changes = [
            abs(np.log(new.density[0] / old.density[0]))
            for new, old in zip(spectra, weighted.spectra, strict=True)
        ]
        if max(changes) < _NOISE_STEADY:
            break
    return replace(fitted, spectra=spectra)


def _fit_cyclic(
    start: CircleStart, axis: str, frequency: float, *, known: bool = False
) -> tuple[CircleProblem, float]:
    """Return the equations with a cyclic error of an axis added, and its frequency, 1/mm. The
    ``frequency`` is a start value unless it is ``known``.

    The cyclic error is fitted together with the delay of the axis (Gauss-Newton: Seber and Wild
    1989, chapter 2).
    """
    problem, shapes, spectra = start.problem, start.shapes, start.fitted.spectra
    samples, amplitudes, late = problem.samples, (0.0, 0.0), 0.0
    shapes.adopt(problem)
    without, active = f"_frequency_{axis}" if known else "", shapes.active()
    others = problem.rows_of(active)
    for step in range(_TUNING_ROUNDS):
        columns = cyclic_columns(samples, axis, frequency, amplitudes, late)
        fixed = [c for c in columns[: None if step else 2] if c.name != without]
        fresh = sum_and_difference(problem.grid, problem.seen(fixed))
        every = [np.column_stack(pair) for pair in zip(fresh, others, strict=True)]
        gram, right = normal_equations(problem, spectra, every)
        precision = [c.width**-2.0 for c in fixed]
        gram += np.diag(np.concatenate([precision, shapes.precision[active]]))
        values = (scaled_inverse(gram) @ right).tolist()
        value = dict(zip([c.name for c in fixed], values, strict=False))
        amplitudes = value[f"_cyclic_cos_{axis}"], value[f"_cyclic_sin_{axis}"]
        frequency += value.get(f"_frequency_{axis}", 0.0)
        late += value.get(f"_late_{axis}", 0.0)
    columns = cyclic_columns(samples, axis, frequency, amplitudes, late)
    return problem.with_columns([c for c in columns if c.name != without]), frequency


def _with_vibration(start: CircleStart) -> tuple[CircleStart | None, Vibration]:
    """Return a fit with the strongest vibration in the residuals of ``start`` added, None if none
    was found; and the vibration, or what may be hidden.
    """
    problem = start.problem
    rest = problem.target - fitted_path(problem, start.fitted)
    found = search_vibration(problem.samples, rest)
    if found.frequency is None:
        return None, found
    columns = vibration_columns(problem.samples, found)
    shaken = _likeliest(problem.with_columns(columns), start)
    places = [shaken.problem.names.index(column.name) for column in columns]
    at = np.flatnonzero(np.isin(shaken.fitted.active, places))
    value, covariance = shaken.fitted.values[at], shaken.fitted.covariance[np.ix_(at, at)]
    # In correlated noise the residuals alone promise more than the whole fit finds.
    if float(value @ np.linalg.solve(covariance, value)) >= found.least:
        return shaken, found
    most = float(np.sqrt(np.sum(value**2) / np.unique(problem.samples.run).size))
    hidden = {**found.hidden, found.axis: max(found.hidden[found.axis], most)}
    return None, Vibration(hidden=hidden)
