"""The error of an axis as a positioning test tells it, with its uncertainty.

Model (units mm or deg, deviation = measured minus target, d = +1 or -1 the approach direction):

    y(x, d) = f(x) + d r(x) / 2 + l(x) + noise
    f = offset + slope x + smooth part (Matérn 5/2) + harmonics 1 and 2 of each known period
    r = constant + slope and smooth part of one common scale (the reversal, mean(+) - mean(-))
    l = local part: repeats at the same target, independent from target to target (what neither of
    the others describes)

Offset, slope and constant reversal are left to the data. All variances, lengths and the noise have
weak priors and are drawn from their posterior. "Reversal constant" and "reversal varying" are two
models; draws come from both by their evidence.

Rasmussen and Williams, Gaussian Processes for Machine Learning (2006): regression in weights,
section 2.1.2; free offset and slope, section 2.7; sums of covariances, section 4.2.4; choice
between models, section 5.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.basis import Basis
from compwright.estimation.cells import (
    Cells,
    cells_of,
    findings_of,
    visible_harmonics,
    visible_periods,
)
from compwright.estimation.evidence import REVERSAL, REVERSAL_LENGTH, Evidence, Prior, Weights
from compwright.estimation.hyperparameters import draw_hyperparameters
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.estimate import ErrorEstimate
from compwright.records.positioning import PositioningTest

_DRAWS: Final = 32  # distinct hyperparameters kept for summaries and predictions
_REVERSAL_PART: Final = [REVERSAL, REVERSAL_LENGTH]
_SEED: Final = 230  # the same test gives the same posterior


@dataclass(frozen=True, slots=True)
class Draws:
    """Joint draws of the deviation: ``positive``, ``negative`` (count, k) and the noise of one
    reading (count,), mm or deg.
    """

    positive: FloatArray
    negative: FloatArray
    noise: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisPosterior:
    """What is known of an axis after one test, mm or deg, machine coordinates.

    ``noise``: standard deviation of one reading with ``noise_dof`` degrees of freedom.
    ``reversal_log_odds``: natural logarithm of the evidence for a reversal that varies with
    position over a constant one (0: one direction measured).
    """

    kind: AxisKind
    measured: tuple[float, float]
    noise: float
    noise_dof: float
    reversal_log_odds: float
    findings: tuple[Finding, ...]
    basis: Basis
    cells: Cells
    weights: tuple[Weights, ...]

    def summary(self, positions: FloatArray) -> ErrorEstimate:
        """Return mean and standard deviation of the deviation at ``positions`` (g,) strictly
        ascending, mm or deg.

        Mean and variance of the mixture over the drawn hyperparameters: mean of the variances plus
        variance of the means (Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, section 1.8).
        The mean leaves out the local part (no table can hold it); the standard deviation contains
        it.
        """
        where = np.asarray(positions, dtype=np.float64)
        scale = self.cells.data.scale
        mean, std = [], []
        for rows, line in zip(self.basis.design(where), self.cells.line_at(where), strict=True):
            means = np.array([rows @ weights.mean for weights in self.weights])
            variances = np.array(
                [
                    np.sum((rows @ weights.root) ** 2, axis=1) + weights.local
                    for weights in self.weights
                ]
            )
            mean.append(line + scale * means.mean(axis=0))
            std.append(scale * np.sqrt(variances.mean(axis=0) + means.var(axis=0)))
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
        )

    def draw(self, positions: FloatArray, count: int, rng: np.random.Generator) -> Draws:
        """Return ``count`` draws at ``positions`` (k,), joint over positions and directions, mm or
        deg: mean + root z of the weights with z standard normal (Rasmussen and Williams 2006,
        appendix A.2).

        At the targets of the test the local part is what the readings say; anywhere else it is
        drawn afresh.
        """
        where = np.asarray(positions, dtype=np.float64)
        unique, back = np.unique(where, return_inverse=True)
        positive, negative = np.empty((count, unique.size)), np.empty((count, unique.size))
        noise = np.empty(count)
        design, line = self.basis.design(unique), self.cells.line_at(unique)
        at_targets = self.basis.design(self.cells.targets)
        seats = self.cells.seats(unique)
        owner = rng.permutation(np.arange(count) % len(self.weights))
        scale = self.cells.data.scale
        for index, weights in enumerate(self.weights):
            mine = np.flatnonzero(owner == index)
            values = (
                weights.mean + rng.standard_normal((mine.size, weights.mean.size)) @ weights.root.T
            )
            local = rng.standard_normal((mine.size, unique.size)) * np.sqrt(weights.local)
            known = seats >= 0
            local[:, known] = self._local(weights, values, at_targets, rng)[:, seats[known]]
            positive[mine] = line[0] + scale * (values @ design[0].T + local)
            negative[mine] = line[1] + scale * (values @ design[1].T + local)
            noise[mine] = scale * np.sqrt(weights.noise)
        return Draws(positive=positive[:, back], negative=negative[:, back], noise=noise)

    def _local(
        self,
        weights: Weights,
        values: FloatArray,
        design: tuple[FloatArray, FloatArray],
        rng: np.random.Generator,
    ) -> FloatArray:
        """Return draws (count, m) of the local part at the targets, given the weights ``values``
        (count, j): a normal mean with normal prior and known variance (Gelman et al. 2013, section
        2.5).
        """
        data = self.cells.data
        total = np.zeros((values.shape[0], self.cells.targets.size))
        for rows, means, counts in (
            (design[0], data.positive, data.count_positive),
            (design[1], data.negative, data.count_negative),
        ):
            total += counts / weights.noise * (means - values @ rows.T)
        precision = (
            1.0 / max(weights.local, 1e-300)
            + (data.count_positive + data.count_negative) / weights.noise
        )
        drawn: FloatArray = total / precision + rng.standard_normal(total.shape) / np.sqrt(
            precision
        )
        return drawn


def estimate_axis(
    test: PositioningTest,
    *,
    travel: tuple[float, float],
    periods: Sequence[float] = (),
    turn: float | None = None,
) -> AxisPosterior:
    """Return the posterior of the error of an axis from one test in machine coordinates.

    ``turn`` (deg): an endless axis, whose error repeats with it whatever the travel says; it has no
    slope.

    ``travel`` (low, high) and the known ``periods`` of the error (screw pitch, scale period), mm or
    deg. The same test gives the same posterior. Model and sources: module docstring. Raises
    InputError for a test with readings at fewer than two targets; UsageError for a test in the
    instrument's frame, an empty travel, or a period that is not positive.
    """
    _refuse_misuse(test, travel, periods)
    cells = cells_of(test, endless=turn is not None)
    shown = visible_periods(cells.targets, periods)
    basis = _basis_for(cells, travel, shown) if turn is None else _endless_basis(cells, turn, shown)
    prior = _prior_for(cells, basis)
    rng = np.random.default_rng(_SEED)
    proposals = 96 if cells.targets.size <= 100 else 48
    varying = Evidence(basis, cells.targets, cells.data, prior)
    drawn = draw_hyperparameters(varying, prior.centre, proposals=proposals, draws=_DRAWS, rng=rng)
    chosen, odds = drawn.values, 0.0
    if basis.bidirectional:
        steady = Evidence(basis, cells.targets, cells.data, _without_varying_reversal(prior))
        start = np.median(drawn.values, axis=0)
        start[_REVERSAL_PART] = steady.prior.centre[_REVERSAL_PART]
        constant = draw_hyperparameters(steady, start, proposals=proposals, draws=_DRAWS, rng=rng)
        odds = drawn.log_evidence - constant.log_evidence
        chosen = _mixed(drawn.values, constant.values, odds)
    log_noise = 0.5 * np.log([varying.variances(values)[0] for values in chosen])
    return AxisPosterior(
        kind=test.kind,
        measured=(float(cells.targets[0]), float(cells.targets[-1])),
        noise=float(cells.data.scale * np.exp(np.mean(log_noise))),
        noise_dof=cells.data.dof or _dof_of(log_noise, cells.readings),
        reversal_log_odds=float(odds),
        findings=findings_of(cells, travel if turn is None else None, periods, shown, test.kind),
        basis=basis,
        cells=cells,
        weights=tuple(varying.weights(values) for values in chosen),
    )


def _refuse_misuse(
    test: PositioningTest, travel: tuple[float, float], periods: Sequence[float]
) -> None:
    faults = []
    if test.frame != "machine":
        faults.append(
            Fault(
                message="the test is still in the instrument's frame",
                file=test.name,
                expected="machine coordinates",
            )
        )
    if not (np.all(np.isfinite(travel)) and travel[0] < travel[1]):
        faults.append(
            Fault(
                message="the travel is empty",
                expected="low < high",
                found=f"{travel[0]:g} to {travel[1]:g}",
            )
        )
    faults += [
        Fault(message="a period of the error must be positive", found=f"{period:g}")
        for period in periods
        if not (np.isfinite(period) and period > 0.0)
    ]
    if faults:
        raise UsageError(*faults)


def _dof_of(log_noise: FloatArray, readings: int) -> float:
    """Return the degrees of freedom that a scatter of log s amounts to: var(log s) = 1 / (2 dof)
    (JCGM 100:2008, eq. G.3).
    """
    return float(np.clip(0.5 / max(float(np.var(log_noise)), 1e-12), 1.0, max(1.0, readings - 1.0)))


def _basis_for(cells: Cells, travel: tuple[float, float], periods: tuple[float, ...]) -> Basis:
    low, high = min(travel[0], float(cells.targets[0])), max(travel[1], float(cells.targets[-1]))
    m = cells.targets.size
    return Basis(
        centre=0.5 * (low + high),
        half=0.5 * (high - low),
        # Twice the targets resolves what they can show; 112 sines resolve a length of 3 % of the
        # half travel.
        sines=int(np.clip(2 * m, 24, 112)),
        reversal_sines=int(np.clip(m, 12, 32)),
        periods=periods,
        bidirectional=cells.bidirectional,
        kept=tuple(visible_harmonics(cells.targets, period) for period in periods),
    )


def _endless_basis(cells: Cells, turn: float, periods: tuple[float, ...]) -> Basis:
    """Return functions that repeat with the turn: both sets as large as on an axis with ends, and
    even (cosine and sine).
    """
    m = cells.targets.size
    return Basis(
        centre=float(cells.targets[0]),
        half=0.5 * turn,
        sines=int(np.clip(2 * m, 24, 112)),
        reversal_sines=2 * int(np.clip(m, 12, 32) // 2),
        periods=periods,
        bidirectional=cells.bidirectional,
        turn=turn,
        kept=tuple(visible_harmonics(cells.targets, period) for period in periods),
    )


def _prior_for(cells: Cells, basis: Basis) -> Prior:
    """Weak priors around what the spread of the readings suggests; a width of 1.5 is a factor 4.5
    either way.
    """
    spread, roughness = cells.spread, cells.roughness
    centre = [
        np.log(spread),
        np.log(0.3 * spread),
        np.log(roughness),
        np.log(0.4),
        np.log(spread),
        np.log(0.7),
    ]
    width = [3.0 if cells.data.dof else 1.0, 1.5, 1.5, 0.8, 1.5, 0.7]
    centre += [np.log(max(spread, 0.2 * roughness))] * len(basis.periods)
    width += [1.5] * len(basis.periods)
    free = [True] * len(centre)
    for index in _REVERSAL_PART:
        free[index] = basis.bidirectional
    return Prior(centre=np.array(centre), width=np.array(width), free=tuple(free))


def _without_varying_reversal(prior: Prior) -> Prior:
    centre = prior.centre.copy()
    centre[_REVERSAL_PART[0]] = np.log(1e-6)  # a millionth of the scale: constant for every purpose
    free = tuple(flag and index not in _REVERSAL_PART for index, flag in enumerate(prior.free))
    return replace(prior, centre=centre, free=free)


def _mixed(varying: FloatArray, constant: FloatArray, odds: float) -> FloatArray:
    """Return equally likely hyperparameters from two models of equal prior probability: the share
    of the first is odds / (1 + odds) (Kass and Raftery, J. Am. Stat. Assoc. 90, 1995).
    """
    count = varying.shape[0]
    share = round(count / (1.0 + float(np.exp(-np.clip(odds, -50.0, 50.0)))))
    pick = np.linspace(0, count - 1, max(share, 1)).round().astype(int)[:share]
    rest = np.linspace(0, count - 1, max(count - share, 1)).round().astype(int)[: count - share]
    return np.vstack([varying[pick], constant[rest]])
