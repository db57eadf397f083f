"""Estimate the position error of an axis, with its uncertainty, from its positioning tests.

Model (units mm or deg, deviation = measured minus target, d = +1 or -1 the approach direction):

    y(x, d) = f(x) + d r(x) / 2 + l(x) + datum and slope of the test + noise
    f = offset + slope x + smooth part (Matérn 5/2) + harmonics 1 and 2 of each known period
    r = constant + slope and smooth part of one common scale (the reversal, mean(+) - mean(-))

f also has a step between two targets if the means clearly show a jump (`jumps`). l is the local
part, the part of the error that f and r do not describe. It repeats at the same target and is
independent from target to target.

Offset, slope and constant reversal have flat priors. All variances and correlation lengths have
weak priors and are drawn at random from their posterior. Each draw uses one random draw of the
noise that the repeated readings show (`noise_of`). Without repeated readings, the noise is assumed
normal and estimated together with the error. The models (which periods, reversal constant or
varying) are averaged by their evidence.

Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006): regression in
weights, section 2.1.2; free offset and slope, section 2.7; sums of covariances, section 4.2.4;
choice between models, section 5.2.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.cells import (
    Cells,
    build_cells,
    estimate_findings,
    visible_periods,
)
from compwright.estimation.evidence import WeightPosterior
from compwright.estimation.hidden_periods import HiddenPeriods, hidden_periods
from compwright.estimation.model import MixturePart, Periods, Travel, model_basis
from compwright.estimation.model_average import average_models
from compwright.estimation.observed_test import ObservedTest
from compwright.estimation.period_findings import period_findings, unseen_findings
from compwright.estimation.period_means import bidirectional_means, fitted_periods, unseen_periods
from compwright.estimation.period_models import PeriodSearch
from compwright.estimation.periods import search_periods
from compwright.estimation.slope_findings import slope_findings
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.estimate import AxisPeriod, ErrorEstimate
from compwright.records.noise import NoiseDraws, normal_noise
from compwright.records.rounding import LOGARITHM, rounded, rounded_number

_DRAWS: Final = 48  # distinct hyperparameters kept for summaries and predictions


@dataclass(frozen=True, slots=True)
class Draws:
    """Random draws of the deviation of an axis at k positions (``positive``: approach in +,
    ``negative``: in −; both (count, k), mm or deg) and of the ``noise`` of the readings in a test.
    """

    positive: FloatArray
    negative: FloatArray
    noise: NoiseDraws


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class AxisPosterior:
    """Probability distribution of an axis' error after its tests; machine coordinates, mm or deg.

    - ``measured``: first and last target.
    - ``noise``: standard deviation of one reading of the first test, with ``noise_dof`` degrees of
      freedom.
    - ``reversal_log_odds``: natural logarithm of the odds of a varying reversal against a constant
      one; 0 if only one direction was measured.
    - ``cells``: the mean readings. ``parts``: the models that are averaged, with their random draws
      of the error; all draws are equally likely.
    - ``periods``: the known periods and those found by the ``search``.
    """

    kind: AxisKind
    measured: tuple[float, float]
    noise: float
    noise_dof: float
    reversal_log_odds: float
    findings: tuple[Finding, ...]
    cells: Cells
    parts: tuple[MixturePart, ...]
    periods: tuple[AxisPeriod, ...]
    search: PeriodSearch

    @property
    def hidden(self) -> HiddenPeriods:
        """Possible periods of the error that the readings cannot show; computed on first use."""
        return _hidden_in(self)

    def summary(self, positions: FloatArray) -> ErrorEstimate:
        """Return mean and standard deviation (g,) of the deviation in both directions, mm or deg.

        ``positions`` (g,): strictly ascending, mm or deg. The variance is the mean of the draws'
        variances plus the variance of their means (Gelman et al., Bayesian Data Analysis, 3rd ed.
        2013, section 1.8).

        The mean is intended for a table. So it leaves out the local part and all periods with a
        probability below one half. A wave of a wrong length would increase the error as often as
        reduce it. The standard deviation refers to this mean; it includes the local part and these
        periods.
        """
        where = np.asarray(positions, dtype=np.float64)
        scale = self.cells.data.scale
        means, variances = self._moments(where)
        held = self._held
        mean, std = [], []
        for line, mine, variance in zip(self.cells.line_at(where), means, variances, strict=True):
            own = mine[held].mean(axis=0)
            mean.append(rounded(line + scale * own))
            square = scale**2 * (variance + np.mean((mine - own) ** 2, axis=0))
            for jump in self.cells.jumps:
                square = square + jump.variance(where)
            std.append(rounded(np.sqrt(square)))
        return ErrorEstimate(
            kind=self.kind,
            positions=where,
            mean_positive=mean[0],
            mean_negative=mean[1],
            std_positive=std[0],
            std_negative=std[1],
            noise=self.noise,
            noise_dof=self.noise_dof,
            measured=self.measured,
            findings=self.findings,
            periods=self.periods,
        )

    @property
    def _held(self) -> NDArray[np.bool_]:
        """Mask (n,) over the draws of the error. True: the draw contains at most as many periods as
        the median draw and is used for the mean error.
        """
        periods = np.repeat(
            [len(part.basis.periods) for part in self.parts],
            [part.draws.size for part in self.parts],
        )
        return np.asarray(periods <= np.sort(periods)[(periods.size - 1) // 2])

    def _moments(self, where: FloatArray) -> tuple[list[FloatArray], list[FloatArray]]:
        """Return two results at the positions ``where`` (g,), each as a list for + and −: the mean
        error of each draw (draws, g), and the average variance (g,) of the error within a draw. The
        unit is the common scale of the readings.
        """
        count = sum(part.draws.size for part in self.parts)
        means: list[list[FloatArray]] = [[], []]
        variances = [np.zeros(where.size), np.zeros(where.size)]
        for part in self.parts:
            size, split, made = part.basis.size, part.basis.mean_size, part.weights
            weights = np.array([each.mean[:size] for each in made])
            covariance = np.sum([each.root[:size] @ each.root[:size].T for each in made], axis=0)
            mean, half = part.basis.halves(where)
            curve, reversal = weights[:, :split] @ mean.T, weights[:, split:] @ half.T
            # Variance of mean ± half, from what both directions share: the grid is fine.
            both = sum(each.local for each in made)
            both += np.sum((mean @ covariance[:split, :split]) * mean, axis=1)
            both += np.sum((half @ covariance[split:, split:]) * half, axis=1)
            cross = 2.0 * np.sum((mean @ covariance[:split, split:]) * half, axis=1)
            for side, sign in enumerate((1.0, -1.0)):
                means[side].append(curve + sign * reversal)
                variances[side] += (both + sign * cross) / count
        return [np.vstack(each) for each in means], variances

    def draw(
        self, positions: FloatArray, count: int, rng: np.random.Generator, test: int = 0
    ) -> Draws:
        """Return ``count`` random draws of the error in both directions, mm or deg.

        ``positions``: (k,), or (count, k) for different positions in each draw. ``test``: index of
        the test whose noise is returned. A draw is mean + root z, with standard normal z for the
        weights (Rasmussen and Williams 2006, appendix A.2). At the targets of the tests, the local
        part of the error is drawn given the readings. At other positions it is drawn from its
        prior.
        """
        where = np.asarray(positions, dtype=np.float64)
        unique, back = np.unique(where, return_inverse=True)
        places = np.broadcast_to(back.reshape(where.shape), (count, where.shape[-1]))
        positive, negative = np.empty(places.shape), np.empty(places.shape)
        line, target_index = self.cells.line_at(unique), self.cells.target_index(unique)
        noises = np.concatenate([part.noises for part in self.parts])
        # All equally often; few draws take any of them, not always the first.
        owner = np.resize(rng.permutation(noises.size), count)
        first = 0
        for part in self.parts:
            design = part.basis.design(unique)
            for weights in part.weights:
                mine = np.flatnonzero(owner == first)
                first += 1
                values = rng.standard_normal((mine.size, weights.mean.size)) @ weights.root.T
                values += weights.mean
                local = rng.standard_normal((mine.size, unique.size)) * np.sqrt(weights.local)
                at_targets = self._local(part, weights, values, rng)
                local[:, target_index >= 0] = at_targets[:, target_index[target_index >= 0]]
                own = np.take_along_axis(local, places[mine], axis=1)
                curve = values[:, : part.basis.size]
                for into, rows in zip((positive, negative), design, strict=True):
                    into[mine] = np.einsum("skj,sj->sk", rows[places[mine]], curve) + own
        scale = self.cells.data.scale
        steps = sum(jump.drawn(where, count, rng) for jump in self.cells.jumps)
        half: FloatArray | float = 0.0
        if self.cells.rough_reversal:
            rough = rng.normal(0.0, self.cells.rough_reversal, (count, unique.size))
            half = np.take_along_axis(rough, places, axis=1)
        return Draws(
            positive=line[0][places] + scale * positive + steps + half,
            negative=line[1][places] + scale * negative + steps - half,
            noise=self._noise(noises[owner], owner, test),
        )

    def _local(
        self,
        part: MixturePart,
        weights: WeightPosterior,
        values: FloatArray,
        rng: np.random.Generator,
    ) -> FloatArray:
        """Return random draws (count, m) of that part of the error at the m targets which is
        independent from target to target. ``values`` (count, j): drawn weights of the model
        ``part``.

        ``weights``: distribution of these weights. Each value is a normal mean with normal prior
        and known variance (Gelman et al. 2013, section 2.5).
        """
        data = self.cells.data
        known = data.precision[weights.draw]
        precision = np.where(data.counts > 0, data.counts / weights.noise, known)
        curve = part.evidence.rows_under(weights.draw) @ values.T
        left = precision[:, np.newaxis] * (data.values[weights.draw][:, np.newaxis] - curve)
        total = np.add.reduceat(left, data.starts, axis=0).T
        by_target = np.add.reduceat(precision, data.starts)
        by_target = by_target + 1.0 / max(weights.local, 1e-300)
        drawn: FloatArray = total / by_target + rng.standard_normal(total.shape) / np.sqrt(
            by_target
        )
        return drawn

    def _noise(self, variances: FloatArray, owner: NDArray[np.intp], test: int) -> NoiseDraws:
        """Return draws (count,) of the noise in a repetition of the test with index ``test``. If
        that test has no repeated readings, the noise follows from the ``variances`` (count,) of a
        reading, estimated together with the error. ``owner`` (count,): which draw of the error each
        draw belongs to.
        """
        draw_index = np.concatenate([part.draws for part in self.parts])[owner]
        own = self.cells.noises[test]
        if own is not None:
            return own.taken(_cycle_draws(draw_index, own.count // self.cells.data.draws))
        sigma = self.cells.data.scale * np.sqrt(variances)
        low, high = self.measured
        if self.cells.other_noise is None:
            return normal_noise(sigma, 0.5 * (low + high), 0.5 * (high - low))
        return replace(
            self.cells.other_noise.taken(draw_index), sigma=np.column_stack([sigma, sigma])
        )


@functools.lru_cache(maxsize=8)
def _hidden_in(posterior: AxisPosterior) -> HiddenPeriods:
    cells = posterior.cells
    basis = replace(posterior.parts[0].basis, periods=(), kept=(), reversal_sines=0)
    given = [each.period for each in posterior.periods if each.source == "job"]
    shown = visible_periods(cells.targets, given)
    return hidden_periods(
        bidirectional_means(cells, endless=basis.turn is not None),
        basis,
        posterior.kind,
        posterior.search,
        shown,
        [period for period in given if period not in shown],
    )


def estimate_axis(
    tests: Sequence[ObservedTest],
    *,
    travel: tuple[float, float],
    periods: Sequence[float] = (),
    suggested: Sequence[float] = (),
    points: Sequence[float] = (),
    turn: float | None = None,
) -> AxisPosterior:
    """Return the probability distribution of the error of an axis, from its tests in machine
    coordinates. Periods ``suggested`` are more probable than other periods; ``points`` are the
    points of an active compensation table; ``turn`` is the period of an endless axis.

    - ``tests``: tests of the axis. The datum of each test is unknown and estimated.
    - ``travel``: lower and upper end, mm or deg.
    - ``periods``: known periods of the error (screw pitch, scale period), mm or deg.
    - ``suggested``: periods from the control's files, mm or deg. Each is as probable as all usual
      periods together.
    - ``points``: ascending, mm or deg. At these points the line of an active table bends.
    - ``turn``: deg. The error of an endless axis repeats after a turn, so it has no slope.

    The same tests give the same result. Model and sources: module docstring. Raises InputError if
    fewer than two targets have readings. Raises UsageError for no test, a test in the instrument's
    frame, an empty travel, or a period that is not positive.
    """
    _refuse_misuse(tests, travel, periods)
    cells = build_cells(tests, turn=turn)
    shown = visible_periods(cells.targets, periods)
    over = Travel(*travel, turn)
    bidirectional = bidirectional_means(cells, endless=turn is not None)
    smooth = model_basis(cells, over, Periods(), varying=False)
    known = Periods.of(cells, fitted_periods(bidirectional, smooth, shown))
    kind, first = tests[0].test.kind, tests[0].noise
    search = search_periods(bidirectional, smooth, kind, known=known.periods, suggested=suggested)
    shown_periods = tuple(each.period for each in search.found if each.named)
    mixture = average_models(cells, over, known, search.models, _DRAWS)
    parts, odds = mixture.parts, mixture.reversal_log_odds
    log_noise = 0.5 * np.log(np.concatenate([part.noises for part in parts]))
    return AxisPosterior(
        kind=kind,
        measured=(float(cells.targets[0]), float(cells.targets[-1])),
        noise=_nine_digits(first.sigma if first else cells.data.scale * np.exp(np.mean(log_noise))),
        noise_dof=rounded_number(
            first.dof if first else cells.data.dof or _equivalent_dof(log_noise, cells.readings),
            LOGARITHM,
        ),
        reversal_log_odds=rounded_number(odds, LOGARITHM),
        findings=(
            *(jump.finding(kind) for jump in cells.jumps if jump.named),
            *estimate_findings(cells, travel if turn is None else None, periods, shown, kind),
            *period_findings(search, cells.targets, kind, shown, known.periods, points),
            *unseen_findings(
                unseen_periods(bidirectional, smooth, known.periods, shown_periods),
                shown_periods,
                kind,
            ),
            *slope_findings(tests, cells, parts),
            *(finding for each in tests if each.noise for finding in each.noise.findings),
        ),
        cells=cells,
        parts=parts,
        periods=(
            *(
                AxisPeriod(period, 1.0, "job")
                for period in periods
                if period in known.periods or period not in shown
            ),
            *search.found,
        ),
        search=search,
    )


def _cycle_draws(draw_index: NDArray[np.intp], each: int) -> NDArray[np.intp]:
    """Return one row number for each draw number in ``draw_index`` (count,). Draw number i has the
    ``each`` rows from i * each on; a draw number that occurs several times gets its rows in turn.
    """
    order = np.argsort(draw_index, kind="stable")
    ordered = draw_index[order]
    turn = np.arange(draw_index.size) - np.searchsorted(ordered, ordered)
    taken = np.empty_like(draw_index)
    taken[order] = ordered * each + turn % each
    return taken


def _nine_digits(value: float) -> float:
    """Return ``value`` rounded to nine significant digits, because it may be very small."""
    return float(f"{value:.8e}")


def _refuse_misuse(
    tests: Sequence[ObservedTest], travel: tuple[float, float], periods: Sequence[float]
) -> None:
    faults = [
        Fault(
            message="the target positions of the test are in the coordinates of the instrument",
            file=each.test.name,
            expected="machine coordinates",
            hint="give the test a `position_map` first",
        )
        for each in tests
        if each.test.frame != "machine"
    ]
    if not tests:
        faults.append(
            Fault(
                message="no test is given for the axis",
                expected="at least one test",
                hint="give at least one test",
            )
        )
    if not (np.all(np.isfinite(travel)) and travel[0] < travel[1]):
        faults.append(
            Fault(
                message="the travel of the axis is empty",
                expected="a lower end below the upper end",
                found=f"{travel[0]:g} to {travel[1]:g}",
                hint="give a travel whose first number is below its second",
            )
        )
    faults += [
        Fault(
            message="a period of the error must be positive",
            found=f"{period:g}",
            hint="give a positive period",
        )
        for period in periods
        if not (np.isfinite(period) and period > 0.0)
    ]
    if faults:
        raise UsageError(*faults)


def _equivalent_dof(log_noise: FloatArray, readings: int) -> float:
    """Return the degrees of freedom of a standard deviation s from draws of log s, at most one less
    than the number of ``readings``. The variance of log s is 1 / (2 dof) (JCGM 100:2008, eq. G.3).
    """
    return float(np.clip(0.5 / max(float(np.var(log_noise)), 1e-12), 1.0, max(1.0, readings - 1.0)))
