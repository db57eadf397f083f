"""Possible periods of the error that a search of the readings finds, with their probabilities.

The probabilities follow from prior and likelihood. Periods that look equal at the targets are
included (probability of frequencies: Bretthorst, Bayesian Spectrum Analysis and Parameter
Estimation, 1988, chapter 3).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.basis import ALIASED
from compwright.estimation.period_likelihood import (
    IntArray,
    NodeChoice,
    PeriodLikelihood,
    log_sums,
)
from compwright.estimation.spectral_window import SpectralWindow, wave_similarity
from compwright.estimation.usual_periods import UsualPeriod
from compwright.records.axis import FloatArray

#: How far, as a part of it, a period is off a usual one that it is meant to be (a gear or a belt
#: between, an inclined scale): standard deviation.
_NEAR: Final = 0.004
#: Frequencies this near, in units of 1 / length, are one peak.
PEAK: Final = 0.7
#: Peaks that are looked at closely, and those whose share is worth it (natural logarithm).
_PEAKS: Final = 8
_WORTH: Final = 4.0
#: Points of a close look; it gets closer while fewer of them than that count.
_POINTS: Final = 17
_FEW: Final = 5
_CLOSER: Final = 4


@dataclass(frozen=True, slots=True)
class PeriodOdds:
    """Prior probabilities in a search for a period: of no period, and of one of the usual periods;
    the rest is for any other period.

    The prior of any other period is uniform over the logarithm of the period. ``taken``:
    frequencies (1 / mm or 1 / deg) that were found before. Periods near them have no probability.
    """

    none: float
    usual: float
    taken: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class PeriodCandidate:
    """A possible period, as ``frequencies`` (k,) with ``shares`` (k,) of its probability (sum 1).
    ``log`` is its log odds against no period.

    ``usual``: the usual period (mm or deg) at these frequencies, if any. ``aliases`` (j,):
    frequencies with nearly the same values at the targets. ``alias_shares`` (j,): their shares of
    the probability.
    """

    frequencies: FloatArray
    shares: FloatArray
    log: float
    usual: float | None
    aliases: FloatArray
    alias_shares: FloatArray

    @property
    def period(self) -> float:
        """The usual period of this candidate if there is one, else its mean period, mm or deg."""
        return self.usual or float(1.0 / (self.shares @ self.frequencies))


@dataclass(frozen=True, slots=True)
class PeriodScan:
    """The result of one search for a period: candidates, the most probable first.

    ``rest``: log odds against no period of all frequencies that belong to no candidate.
    ``log_odds`` (f,): log odds of each searched frequency.
    """

    candidates: tuple[PeriodCandidate, ...]
    rest: float
    log_odds: FloatArray


@dataclass(frozen=True, slots=True)
class _Prior:
    """Prior odds of a period against no period, per frequency.

    ``other``: log odds of any period, per logarithm of the frequency. ``usual`` (u,): frequencies
    of the usual periods. ``log_usual`` (u,): their log odds. Half of these odds is for exactly this
    period, the other half for periods near it (`_NEAR`).
    """

    other: float
    usual: FloatArray
    log_usual: FloatArray

    def even(self, frequencies: FloatArray) -> FloatArray:
        """Return the log prior odds of an arbitrary (not usual) period at each of the
        ``frequencies``.
        """
        return np.asarray(self.other - np.log(frequencies))

    def at(self, frequencies: FloatArray) -> FloatArray:
        """Return the log prior odds (f,) of a period, usual or not, at each of the ``frequencies``
        (f,).
        """
        away = np.log(frequencies[..., np.newaxis] / self.usual) / _NEAR
        near = np.exp(self.log_usual - 0.5 * away**2) / (2.0 * np.sqrt(2.0 * np.pi) * _NEAR)
        density = np.log(np.exp(self.other) + np.sum(near, axis=-1)) - np.log(frequencies)
        return np.asarray(density)


def _prior(frequencies: FloatArray, expected: Sequence[UsualPeriod], before: PeriodOdds) -> _Prior:
    usual = [
        each
        for each in expected
        if frequencies[0] <= 1.0 / each.size <= frequencies[-1] * (1.0 + 1e-9)
    ]
    other = 1.0 - before.none - before.usual
    span = np.log(frequencies[-1] / frequencies[0])
    weights = np.array([each.weight for each in usual])
    return _Prior(
        float(np.log(other / before.none / span)),
        np.array([1.0 / each.size for each in usual]),
        np.log(before.usual / before.none * weights / max(float(np.sum(weights)), 1e-300)),
    )


def find_candidates(
    likelihood: PeriodLikelihood,
    frequencies: FloatArray,
    expected: Sequence[UsualPeriod],
    before: PeriodOdds,
) -> PeriodScan:
    """Return the possible periods among equally spaced ``frequencies`` (f,) and the ``expected``
    periods, given the prior probabilities ``before``.
    """
    targets = likelihood.targets
    resolution = 1.0 / float(np.ptp(targets))
    prior = _prior(frequencies, expected, before)
    everywhere = np.concatenate([frequencies, prior.usual])
    window = SpectralWindow(targets, 2.0 * float(np.max(everywhere)) + float(frequencies[0]))
    shown = _ShownLikelihood(
        likelihood, window, float(frequencies[0]), before.taken, PEAK * resolution
    )
    odds = shown.either(everywhere, likelihood.coarse())
    odds[: frequencies.size] = _cell_means(odds[: frequencies.size], frequencies, shown)
    cell = np.log(frequencies[1] - frequencies[0])
    logs = odds + np.concatenate([prior.even(frequencies) + cell, prior.log_usual])
    close = _peaks(everywhere, logs, window, resolution)
    taken = np.zeros(logs.size, dtype=bool)
    for _, members in close:
        taken[members] = True
    centres = np.array([frequency for frequency, _ in close])
    found = []
    if close:
        choice = likelihood.telling(centres)
        nearest = _close_looks(shown, choice, centres, resolution, prior)
        # What the few nodes of the first look overstate of the best they overstate of all.
        best = logs[np.abs(everywhere - centres[0]) <= PEAK * resolution]
        logs = logs + min(nearest[0].log - _log_sum(best), 0.0)
        for near, (_, members) in zip(nearest, close, strict=True):
            aliases = _aliases(1.0 / near.period, everywhere[members], targets, resolution)
            found.append(_shared(near, aliases, shown, choice, _log_sum(logs[members])))
        found.sort(key=lambda each: -round(each.log, 6))
    rest = _log_sum(np.append(logs[~taken], -np.inf))
    return PeriodScan(tuple(found), rest, odds[: frequencies.size])


def _cell_means(odds: FloatArray, frequencies: FloatArray, shown: _ShownLikelihood) -> FloatArray:
    """Return the log ``odds`` (f,) of waves at equally spaced ``frequencies`` (f,), each maximum
    that the readings support (log odds above zero) averaged over the interval about its frequency.

    A wave with two harmonics has a peak narrower than the steps. Its maximum may be halfway between
    two frequencies, where neither shows it (quarters: trapezoidal rule).
    """
    padded = np.concatenate([[-np.inf], odds, [-np.inf]])
    tops = np.flatnonzero((odds > 0.0) & (odds >= padded[:-2]) & (odds >= padded[2:]))
    half = 0.5 * (frequencies[1] - frequencies[0])
    between = [
        shown.either(frequencies[tops] + side, shown.likelihood.coarse()) for side in (-half, half)
    ]
    means = odds.copy()
    means[tops] = log_sums(np.stack([odds[tops] + np.log(2.0), *between])) - np.log(4.0)
    return means


def refine_candidate(
    likelihood: PeriodLikelihood,
    candidate: PeriodCandidate,
    frequencies: FloatArray,
    expected: Sequence[UsualPeriod],
    before: PeriodOdds,
) -> PeriodCandidate | None:
    """Return the ``candidate`` period, computed again under a ``likelihood`` that contains other
    periods; None if it is a harmonic of one of these, or one of these is its harmonic.

    The aliases of the candidate are kept. The arguments are those of `find_candidates`.
    """
    resolution = 1.0 / float(np.ptp(likelihood.targets))
    prior = _prior(frequencies, expected, before)
    highest = 2.0 * float(np.max(np.append(frequencies, prior.usual))) + float(frequencies[0])
    window = SpectralWindow(likelihood.targets, highest)
    shown = _ShownLikelihood(
        likelihood, window, float(frequencies[0]), before.taken, PEAK * resolution
    )
    centres = np.array([1.0 / candidate.period])
    choice = likelihood.telling(centres)
    if np.isinf(shown.either(np.append(centres, 2.0 * centres), choice)).any():
        return None
    near = _close_looks(shown, choice, centres, resolution, prior)[0]
    return replace(near, aliases=candidate.aliases, alias_shares=candidate.alias_shares)


@dataclass(frozen=True, slots=True)
class _ShownLikelihood:
    """The likelihood of waves, limited to those that the targets can show.

    Two kinds of waves are excluded. A wave is excluded if at the targets it looks like one below
    the frequency ``lowest``. Such long waves are not searched and may be smooth error. A wave is
    also excluded if its frequency is closer than ``near`` to one in ``taken``, the frequencies
    found before.
    """

    likelihood: PeriodLikelihood
    window: SpectralWindow
    lowest: float
    taken: tuple[float, ...]
    near: float

    def odds(self, frequencies: FloatArray, choice: NodeChoice) -> tuple[FloatArray, FloatArray]:
        """Return two arrays of log odds (f,): of a wave with one harmonic, and of a wave with two,
        averaged over the grid points in ``choice``. Excluded frequencies have -inf.
        """
        one, both = self.likelihood.log_odds(frequencies, choice)
        one = np.where(self._silent(frequencies), -np.inf, one)
        return one, np.where(self._silent(2.0 * frequencies) | np.isinf(one), one, both)

    def _silent(self, frequencies: FloatArray) -> NDArray[np.bool_]:
        silent = self.window.slow(frequencies, self.lowest)
        for taken in self.taken:
            # The second harmonic of what was found is taken with it.
            for each in (taken, 2.0 * taken):
                silent = silent | (np.abs(frequencies - each) <= self.near)
        return silent

    def either(self, frequencies: FloatArray, choice: NodeChoice) -> FloatArray:
        """Return the log odds (f,) of a wave with one or two harmonics, both cases together,
        averaged over the grid points in ``choice``.
        """
        odds: FloatArray = np.logaddexp(*self.odds(frequencies, choice)) - np.log(2.0)
        return odds


def _peaks(
    where: FloatArray, logs: FloatArray, window: SpectralWindow, resolution: float
) -> list[tuple[float, IntArray]]:
    """Return the highest peaks of the log odds ``logs`` at the frequencies ``where``, each with the
    indices of the frequencies that the targets confuse with it.
    """
    left, rounded = np.ones(where.size, dtype=bool), np.round(logs, 6)
    floor = max(0.0, float(np.max(rounded))) - _WORTH
    if float(np.max(rounded)) < floor:
        return []
    found: list[tuple[float, IntArray]] = []
    while len(found) < _PEAKS:
        index = int(np.argmax(np.where(left, rounded, -np.inf)))
        if not left[index] or rounded[index] < floor:
            break
        centre = float(where[index])
        near = np.abs(where - centre) <= PEAK * resolution
        members = np.flatnonzero(left & (near | (window.alike(where, centre) >= ALIASED)))
        left[members] = False
        found.append((centre, members))
    return found


def _aliases(
    centre: float, members: FloatArray, targets: FloatArray, resolution: float
) -> FloatArray:
    """Return the frequencies near ``members`` whose waves have nearly the same values at the
    targets as a wave of frequency ``centre``. Frequencies within a few times ``resolution`` (1 /
    measured length) of ``centre`` are left out.
    """
    far = np.sort(members[np.abs(members - centre) > 2.0 * PEAK * resolution])
    if not far.size:
        return far
    found = []
    for run in np.split(far, np.flatnonzero(np.diff(far) > PEAK * resolution) + 1):
        low, high = run[0] - PEAK * resolution, run[-1] + PEAK * resolution
        for _ in range(3):  # to a hundred-thousandth of the resolution
            fine = np.linspace(low, high, 101)
            best = float(fine[int(np.argmax(wave_similarity(targets, fine, centre)))])
            low, high = best - (high - low) / 50.0, best + (high - low) / 50.0
        found.append(best)
    return np.array(found)


def _close_looks(
    shown: _ShownLikelihood,
    choice: NodeChoice,
    centres: FloatArray,
    resolution: float,
    prior: _Prior,
) -> list[PeriodCandidate]:
    """Return each peak as a possible period, computed on a finer grid of frequencies up to a few
    times ``resolution`` from its centre. Usual periods near the peak are included.
    """
    fine, logs = _resolved(shown, choice, centres, resolution, prior)
    usual = prior.log_usual - np.log(2.0)
    if usual.size:
        usual = usual + shown.either(prior.usual, choice)
    found = []
    for here, mine, centre in zip(fine, logs, centres, strict=True):
        named = np.flatnonzero(np.abs(prior.usual - centre) <= PEAK * resolution)
        together = np.concatenate([mine, usual[named]])
        log, exact = _log_sum(together), None
        if named.size and _log_sum(usual[named]) > _log_sum(mine):
            exact = float(1.0 / prior.usual[named[int(np.argmax(usual[named]))]])
        where = np.concatenate([here, prior.usual[named]])
        nothing = np.zeros(0)
        found.append(PeriodCandidate(where, np.exp(together - log), log, exact, nothing, nothing))
    return found


def _resolved(
    shown: _ShownLikelihood,
    choice: NodeChoice,
    centres: FloatArray,
    resolution: float,
    prior: _Prior,
) -> tuple[FloatArray, FloatArray]:
    """Return a fine grid of frequencies (k, p) about each of the ``centres`` (k,), with the log
    odds (k, p) of a wave at each. ``resolution``: 1 / measured length; the grids extend to a
    multiple of it.
    """
    best, half = centres.copy(), np.full(centres.size, PEAK * resolution)
    grid = np.linspace(-1.0, 1.0, _POINTS)
    fine, logs = np.empty((2, centres.size, _POINTS))
    open_ = np.arange(centres.size)
    for _ in range(_CLOSER):
        fine[open_] = best[open_, np.newaxis] + half[open_, np.newaxis] * grid
        odds = shown.either(fine[open_].ravel(), choice).reshape(open_.size, -1)
        logs[open_] = odds + prior.at(fine[open_])
        peak = np.argmax(np.round(logs[open_], 6), axis=1)
        top = np.take_along_axis(logs[open_], peak[:, np.newaxis], 1)
        sharp = np.sum(logs[open_] > top - 4.0, axis=1) <= _FEW
        open_, peak = open_[sharp], peak[sharp]
        if not open_.size:
            break
        best[open_] = fine[open_, peak]
        half[open_] /= 4.0
    return fine, logs + np.log(fine[:, 1:2] - fine[:, :1])


def _shared(
    candidate: PeriodCandidate,
    aliases: FloatArray,
    shown: _ShownLikelihood,
    choice: NodeChoice,
    log: float,
) -> PeriodCandidate:
    """Return a possible period with its aliases, the frequencies that look the same at the targets.
    The readings alone divide the joint probability ``log`` among these frequencies.
    """
    if not aliases.size:
        return candidate
    odds = shown.either(np.append(aliases, 1.0 / candidate.period), choice)
    shares = np.exp(odds - _log_sum(odds))
    return PeriodCandidate(
        candidate.frequencies,
        candidate.shares,
        max(log, candidate.log),
        candidate.usual,
        aliases,
        shares[:-1],
    )


def _log_sum(logs: FloatArray) -> float:
    top = float(np.max(logs))
    return top + float(np.log(np.sum(np.exp(logs - top)))) if np.isfinite(top) else top
