"""The search for the causes of a circular test that are not in every model. Reversal spikes and a
common lag are chosen with the first fit. Of a cyclic error and a vibration, the more probable one
is added first, then the residuals are searched again (orthogonal matching pursuit: Pati, Rezaiifar
and Krishnaprasad, Asilomar Conference on Signals, Systems and Computers 27, 1993). What was added
is not tested again, but the frequencies of cyclic errors are tuned again.
"""

from __future__ import annotations

import copy
import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_cyclic import (
    CyclicSearch,
    axis_of,
    cyclic_columns,
    likeliest_delay,
    mean_position,
    search_cyclic,
    wave_names,
)
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
from compwright.estimation.circle_model import AXES, PRIORS, CauseColumn, CircleSamples
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
from compwright.records.axis import FloatArray

#: Rounds in which the frequency of a cyclic error is fitted.
_TUNING_ROUNDS: Final = 4
#: Frequencies that are tuned again, at most, after a wave was added.
_TUNINGS: Final = 3
#: Largest error of a linearised frequency at the ends of the travel, as a share of the standard
#: error of the amplitude.
_LINEAR: Final = 0.1
#: The doubt of the lag by a cyclic error, relative to that before, up to which it is used.
_SURER: Final = 0.5
#: A fit from assumed noise replaces the fit before if it is more probable by these log odds.
_OTHER: Final = 1.0
#: Log odds, a thousand to one, of a cyclic error that is not clear by the threshold of its search.
_CLEAR_ODDS: Final = np.log(1e3)
#: The noise is estimated again, so often at most, while its density at order zero still changes by
#: this share.
_NOISE_ROUNDS: Final = 3
_NOISE_STEADY: Final = 0.25


@dataclass(frozen=True, slots=True)
class _Wave:
    """Where a cyclic error is in a model: its ``frequency``, 1/mm, the delay ``late`` of the axis,
    mm, with its standard deviation ``doubt`` over all delays, and whether the frequency is
    ``known``, not searched.
    """

    frequency: float
    late: float
    doubt: float
    known: bool = False


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

    @property
    def residual(self) -> FloatArray:
        """The measured minus the fitted deviation of each sample, mm (n,)."""
        rest: FloatArray = self.problem.target - fitted_path(self.problem, self.fitted)
        return rest


def start_fit(samples: CircleSamples, grid: AngleGrid, lag: Lag) -> CircleStart:
    """Return the first fit of a circular test. It includes the common ``lag`` of both axes if this
    is clear and explains the samples better.

    Next to the reversal points, lost motion that is taken up while an axis stands still looks like
    a lag. Therefore the model is fitted with and without the lag, and the evidence of the whole
    model decides.
    """
    without_lag = _likeliest(circle_problem(with_undetected_lag(samples, lag), grid), levels=None)
    if not lag.clear:
        return without_lag
    with_lag = _likeliest(circle_problem(at_actual_angles(samples, lag), grid), levels=None)
    return with_lag if with_lag.evidence > without_lag.evidence else without_lag


def _likeliest(problem: CircleProblem, *starts: CircleStart, levels: int | None = 0) -> CircleStart:
    """Return the most probable fit of a circular test. Several fits are tried: from the spike
    shapes and the noise of each of the given fits ``starts``, and from so many assumed ``levels``
    of white noise, the highest first (None: all).

    Several starts are needed because spike shapes are changed one at a time, which leads to the
    nearest optimum only. Noise can be fitted as a spike, or a spike as noise. The values and the
    covariance of the result belong to the last noise spectra.
    """
    white = itertools.islice(white_problems(problem), levels)
    tries = [(copy.deepcopy(s.shapes), weighted_problem(problem, s.fitted.spectra)) for s in starts]
    tries += [(SpikeShapes(problem), weighted) for weighted in white]
    fits = (CircleStart(problem, shapes, _fit_with_noise(w, shapes)) for shapes, w in tries)
    best = max(fits, key=lambda fit: fit.evidence)
    active = best.fitted.active
    weighted = weighted_problem(problem, best.fitted.spectra, active)
    return replace(best, fitted=fit_causes(weighted, active, best.shapes.precision))


def solve(start: CircleStart, given: dict[str, float], readings: CircleSamples) -> Solution:
    """Return the full solution of a circular test: noise, reversal spikes, cyclic errors and
    vibration. ``given``: known frequencies of cyclic errors, 1/mm, by axis. ``readings``: all
    samples, of which those of ``start`` are means in a long test.

    A vibration hides cyclic errors, and a cyclic error a vibration. Of the two, the one that
    explains the samples better is added first, and the other is searched again. On a short arc
    both have a nearly constant frequency, and what no cause explains may look like them. A
    vibration therefore has to make the model more probable than noise alone and than the likeliest
    cyclic error do.

    The noise spectra contain what is not in the model yet. A cyclic error of few periods thus hides
    itself. If none is clear, the largest by plain least squares is tried. It is added if it makes
    the model more probable by far.

    The fit of a changed model starts from the fit before. When nothing more is found, it is also
    fitted from assumed noise. If that fit is more probable, the search goes on from there.
    """
    waves, tried = dict[str, _Wave](), start.problem
    start, fast = _without_fast_vibration(start, readings)
    for axis, frequency in given.items():
        late, doubt = likeliest_delay(start.problem, start.fitted, axis, frequency)
        start, waves[axis] = _with_cyclic(start, axis, _Wave(frequency, late, doubt, known=True))
    slow, hidden, changed = Vibration(), dict[str, float](), True
    start, waves = _at_delay(start, waves, slow)
    while changed:
        changed = False
        found = search_vibration(start.problem.samples, start.residual)
        slow = replace(slow, hidden=found.hidden)
        frequencies = {name: wave.frequency for name, wave in waves.items()}
        cyclic = search_cyclic(start.problem, start.fitted, frequencies)
        hidden, odds = dict(cyclic.hidden), 0.0
        shown = found.frequency is not None and slow.frequency is None
        if shown:
            with_vibration = _with_vibration(start, found)
            odds = _odds(with_vibration, start, found.places)
        tries = [cyclic]
        if not cyclic.clear:
            tries.append(search_cyclic(start.problem, _with_white_noise(start), frequencies))
        cyclic_odds, with_cyclic, tuned = _with_likeliest(start, waves, tries)
        least = 0.0 if cyclic.clear else _CLEAR_ODDS
        if cyclic_odds > max(odds, least) or (cyclic.clear and odds <= 0.0):
            start, waves = _at_delay(with_cyclic, tuned, slow)
            changed = True
            continue
        if odds > max(cyclic_odds, 0.0):
            slow, changed = found, True
            start, waves = _tuned(with_vibration, waves)
        elif shown:
            slow = replace(slow, hidden=_hidden(with_vibration, found))
        if not changed and start.problem is not tried:
            tried = start.problem
            again = _likeliest(tried, levels=1)
            if again.evidence > start.evidence + _OTHER:
                start, changed = again, True
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
        frequencies={name: wave.frequency for name, wave in waves.items()},
        given=frozenset(given),
        hidden=hidden,
        vibration=slow.or_stronger(fast),
    )


def _with_likeliest(
    start: CircleStart, waves: dict[str, _Wave], tries: Sequence[CyclicSearch]
) -> tuple[float, CircleStart, dict[str, _Wave]]:
    """Return the log odds of the likeliest cyclic error of ``tries``, and the fit with it added."""
    likeliest = -np.inf, start, waves
    for found in tries:
        if found.axis is None:
            continue
        name = next(each for each in wave_names(found.axis) if each not in waves)
        added, wave = _with_cyclic(start, name, _Wave(found.frequency, found.late, found.doubt))
        added, tuned = _tuned(added, {**waves, name: wave})
        odds = _odds(added, start, found.places)
        if odds > likeliest[0]:
            likeliest = odds, added, tuned
    return likeliest


def _with_white_noise(start: CircleStart) -> CircleFit:
    """Return the fit of the same causes under white noise of the level at high orders."""
    *_, quiet = white_problems(start.problem)
    return fit_causes(quiet, start.fitted.active, start.shapes.precision)


def _without_fast_vibration(
    start: CircleStart, readings: CircleSamples
) -> tuple[CircleStart, Vibration]:
    """Return the fit of a circular test without the vibration that its samples, means of
    neighbouring ``readings``, cannot show; and this vibration.
    """
    problem = start.problem
    if problem.samples.averaged == 1:
        return start, Vibration()
    found, wave = search_between_means(readings, problem, start.residual)
    if found.frequency is None:
        return start, found
    target = problem.target - wave
    aims = sum_and_difference(problem.grid, target)
    return _likeliest(replace(problem, target=target, aims=aims, removed=wave), start), found


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


def _with_cyclic(start: CircleStart, name: str, wave: _Wave) -> tuple[CircleStart, _Wave]:
    """Return a fit with the cyclic error ``name`` added, and its frequency and delay. Those of
    ``wave`` are start values. A cyclic error of this name that is already there is replaced.

    The cyclic error is fitted together with the delay of the axis, under the spike shapes and the
    noise of ``start`` (Gauss-Newton: Seber and Wild 1989, chapter 2). Then all is fitted again.
    """
    problem, spectra = start.problem, start.fitted.spectra
    samples, amplitudes = problem.samples, (0.0, 0.0)
    own = [c.name for c in _columns(samples, name, wave, amplitudes)]
    replaced = [index for index, column in enumerate(problem.names) if column in own]
    active = np.setdiff1d(start.fitted.active, replaced)
    others = problem.rows_of(active)
    for step in range(_TUNING_ROUNDS):
        fitted = _columns(samples, name, wave, amplitudes)[: None if step else 2]
        rows = sum_and_difference(problem.grid, problem.seen(fitted))
        gram, right = normal_equations(
            problem, spectra, [np.column_stack(pair) for pair in zip(rows, others, strict=True)]
        )
        precision = [c.width**-2.0 for c in fitted]
        gram += np.diag(np.concatenate([precision, start.shapes.precision[active]]))
        values = (scaled_inverse(gram) @ right).tolist()
        value = dict(zip([c.name for c in fitted], values, strict=False))
        shift = value.get(f"_frequency_{name}", 0.0)
        both = complex(value[f"_cyclic_cos_{name}"], value[f"_cyclic_sin_{name}"])
        both *= np.exp(-2j * np.pi * shift * mean_position(samples, axis_of(name)))
        amplitudes = both.real, both.imag
        late = wave.late + value.get(f"_late_{name}", 0.0)
        wave = replace(wave, frequency=wave.frequency + shift, late=late)
    problem = problem.with_columns(_columns(samples, name, wave, amplitudes))
    return _likeliest(problem, start), wave


def _at_delay(
    start: CircleStart, waves: dict[str, _Wave], vibration: Vibration
) -> tuple[CircleStart, dict[str, _Wave]]:
    """Return a fit at the actual angles of the axes, if a cyclic error shows their common lag much
    better than the reversals did, and this fit is the more probable one.

    A cyclic error shows the delay of its axis. The common lag differs from it by half of the servo
    mismatch. What a loop delays may differ by so much again: by half of the prior of the mismatch.
    """
    problem = start.problem
    samples = problem.samples
    delays = {name: _fitted(start, f"_late_{name}") for name in waves}
    doubts = {name: np.hypot(delays[name][1], waves[name].doubt) for name in waves}
    surest = min(doubts, key=lambda each: float(doubts[each]), default=None)
    unequal = 5e-4 * PRIORS["servo_mismatch"] * samples.speed
    before = samples.lag_std * samples.radius
    if surest is None or np.hypot(doubts[surest], unequal) > _SURER * before:
        return start, waves
    side = -1.0 if axis_of(surest) == AXES[0] else 1.0
    late = waves[surest].late + delays[surest][0]
    late += 5e-4 * side * _fitted(start, "servo_mismatch")[0] * samples.speed
    late = max(late, -samples.lag * samples.radius)
    doubt = float(np.hypot(doubts[surest], unequal)) / samples.radius
    lag = Lag(samples.lag + late / samples.radius, doubt, clear=True)
    samples = at_actual_angles(replace(samples, theta=samples.commanded), lag)
    moved, columns = {}, []
    for each, wave in waves.items():
        own = [_fitted(start, f"_{part}_{each}")[0] for part in ("frequency", "late")]
        sizes = [_fitted(start, f"_cyclic_{part}_{each}")[0] for part in ("cos", "sin")]
        both = complex(*sizes) * np.exp(
            -2j * np.pi * own[0] * mean_position(samples, axis_of(each))
        )
        found = replace(wave, frequency=wave.frequency + own[0], late=wave.late + own[1] - late)
        moved[each] = found
        columns += _columns(samples, each, found, (both.real, both.imag))
    if vibration.frequency is not None:
        columns += vibration_columns(samples, vibration)
    fresh = circle_problem(samples, problem.grid, problem.removed)
    there = _likeliest(fresh.with_columns(columns), start)
    return (there, moved) if there.evidence > start.evidence else (start, waves)


def _columns(
    samples: CircleSamples, name: str, wave: _Wave, amplitudes: tuple[float, float]
) -> list[CauseColumn]:
    """Return the model columns of a cyclic error; a known frequency has none."""
    columns = cyclic_columns(samples, name, wave.frequency, amplitudes, wave.late)
    return [c for c in columns if not (wave.known and c.name == f"_frequency_{name}")]


def _tuned(start: CircleStart, waves: dict[str, _Wave]) -> tuple[CircleStart, dict[str, _Wave]]:
    """Return a fit with tuned frequencies of the cyclic errors ``waves``, by name.

    A wave that is not in the model yet counts as noise, and disturbs the tuning of the others. The
    fit of all causes changes a frequency by its linear column. A frequency is tuned again while
    this leaves more than a part of the standard error of the amplitude.
    """
    found, radius = dict(waves), start.problem.samples.radius

    def left(name: str) -> float:
        turned = 2.0 * np.pi * radius * _fitted(start, f"_frequency_{name}")[0]
        both = np.array([_fitted(start, f"_cyclic_{part}_{name}") for part in ("cos", "sin")])
        size, error = np.hypot(*both)
        return float(0.5 * turned**2 * size / error)

    for _ in range(_TUNINGS):
        name = max(found, key=left, default=None)
        if name is None or left(name) <= _LINEAR:
            break
        wave = replace(
            found[name],
            frequency=found[name].frequency + _fitted(start, f"_frequency_{name}")[0],
            late=found[name].late + _fitted(start, f"_late_{name}")[0],
        )
        start, found[name] = _with_cyclic(start, name, wave)
    return start, found


def _fitted(start: CircleStart, name: str) -> tuple[float, float]:
    """Return the size of a cause in a fit and its standard error: 0 and infinite if it is not
    there.
    """
    fitted = start.fitted
    if name not in start.problem.names:
        return 0.0, np.inf
    (at,) = np.flatnonzero(fitted.active == start.problem.names.index(name))
    return float(fitted.values[at]), float(np.sqrt(fitted.covariance[at, at]))


def _odds(new: CircleStart, old: CircleStart, places: float) -> float:
    """Return the logarithm of the odds of a fit with a wave against one without. The wave may be at
    any of so many ``places`` with equal probability: independent frequencies of all its kinds.
    """
    return new.evidence - old.evidence - float(np.log(max(places, 1.0)))


def _with_vibration(start: CircleStart, found: Vibration) -> CircleStart:
    """Return a fit with the vibration ``found`` added."""
    columns = vibration_columns(start.problem.samples, found)
    return _likeliest(start.problem.with_columns(columns), start)


def _hidden(start: CircleStart, found: Vibration) -> dict[str | None, float]:
    """Return the amplitudes, um, that may be undetected, by axis: what the search can miss, and the
    amplitude in the fit ``start`` of a vibration that is not probable enough.
    """
    problem, fitted = start.problem, start.fitted
    places = [i for i, name in enumerate(problem.names) if name.startswith("_vibration")]
    value = fitted.values[np.isin(fitted.active, places)]
    most = float(np.sqrt(np.sum(value**2) / np.unique(problem.samples.run).size))
    return {**found.hidden, found.axis: max(found.hidden[found.axis], most)}
