"""Search the readings of an axis for unknown periods of its error.

Prior (`FIRST` and `FURTHER`): almost every screw or worm has an error, however small, that repeats
with its turn, at a usual period (`usual_periods`). An axis whose position loop is closed by a scale
along it does not show this error. Every second axis is assumed to have such a scale (a judgement,
from no document). A second period is rare. One or two harmonics have equal odds. The likelihood
(`period_likelihood`) covers all amplitudes and phases, for any smooth and local part.

Periods are found one after another, each given those found before (Bretthorst, Bayesian Spectrum
Analysis and Parameter Estimation, 1988, chapters 3 and 6). Two waves of equal size hide each other.
Therefore several sets of periods are extended, not only the best set (beam search: Reddy, Speech
Understanding Systems, Carnegie-Mellon University, 1977). Before a set is weighted, each of its
periods is searched again, given the others.

Waves with nearly the same values at the targets (`basis.ALIASED`) cannot be distinguished. Their
joint probability is divided among them by the data alone, not by the prior. Waves that fit equally
well get equal shares.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.basis import HARMONICS, Basis
from compwright.estimation.period_candidates import (
    PEAK,
    PeriodCandidate,
    PeriodOdds,
    PeriodScan,
    find_candidates,
    refine_candidate,
)
from compwright.estimation.period_likelihood import BidirectionalMeans, PeriodLikelihood
from compwright.estimation.period_models import (
    NO_SEARCH,
    PeriodCurve,
    PeriodSearch,
    PeriodSet,
    probable_sets,
    search_result,
)
from compwright.estimation.usual_periods import UsualPeriod, usual_periods
from compwright.records.axis import AxisKind, FloatArray

#: Prior odds of the first period, and of one in addition to known ones.
FIRST: Final = PeriodOdds(none=0.5, usual=0.38)
FURTHER: Final = PeriodOdds(none=0.75, usual=0.18)
#: A period repeats at least so often over the targets: fewer waves are smooth error.
LEAST_REPEATS: Final = 8.0
#: The shortest period that is searched: below the shortest usual lead and half of it, mm or deg.
SHORTEST: Final = {AxisKind.LINEAR: 2.0, AxisKind.ROTARY: 0.5}
#: Frequencies at most, three per 1 / length: what a long axis would ask beyond is not searched.
_MOST_FREQUENCIES: Final = 16000
_PER_RESOLUTION: Final = 3
#: Periods one after another at most.
_MOST_PERIODS: Final = 4
#: One more period is searched given each of so many sets, and given those that are not more than
#: `_FOLLOWED` (natural logarithm) below the best: two waves of one size hide each other.
_BEAM: Final = 3
_FOLLOWED: Final = 4.0
#: Least number of targets above the number of free columns.
LEFT: Final = 4


def search_periods(
    bidirectional: BidirectionalMeans,
    basis: Basis,
    kind: AxisKind,
    *,
    known: Sequence[float] = (),
    suggested: Sequence[float] = (),
) -> PeriodSearch:
    """Return the periods, mm or deg, that the mean readings show in addition to the ``known``
    periods, each with its probability.

    ``basis``: functions of the smooth part (its periods are not used). ``suggested``: periods from
    the control's files, mm or deg. Each of them is as probable as all usual periods together. If
    there are too few targets for a search, the result has only the model without a period. Prior
    and sources: module docstring.
    """
    frequencies = search_frequencies(bidirectional.targets, kind)
    if not frequencies.size:
        return NO_SEARCH
    search = _PeriodSearch(
        bidirectional, basis, frequencies, usual_periods(kind, suggested), tuple(known)
    )
    done: list[PeriodSet] = []
    level = [PeriodSet((), 0.0)]
    curve: PeriodCurve | None = None
    for depth in range(_MOST_PERIODS + 1):
        best = max(each.log for each in (*done, *level))
        deeper: list[PeriodSet] = []
        for place, each in enumerate(level):
            worth = place < _BEAM and each.log >= best - _FOLLOWED and depth < _MOST_PERIODS
            look = search.candidates_with(each) if worth else None
            done.append(each if look is None else each.less_certain(look.rest))
            if look is not None:
                deeper += [each.extended(one) for one in look.candidates]
                curve = curve or PeriodCurve(
                    1.0 / frequencies, look.log_odds, search.detectable(each)
                )
        level = search.different(deeper)
        if not level:
            break
    if curve is None:
        return NO_SEARCH
    return search_result(probable_sets(done), curve, suggested)


def _descending(sets: Iterable[PeriodSet]) -> list[PeriodSet]:
    return sorted(sets, key=lambda one: -round(one.log, 6))


def search_frequencies(targets: FloatArray, kind: AxisKind) -> FloatArray:
    """Return the frequencies (f,) to search, equally spaced, ascending, 1 / mm or 1 / deg.

    The lowest frequency has `LEAST_REPEATS` periods over the ``targets``. The highest is that of
    the `SHORTEST` period. At most `_MOST_FREQUENCIES` are searched. With fewer than eight targets
    the result is empty, because a wave cannot be distinguished from scatter.
    """
    length = float(np.ptp(targets))
    if targets.size < 8:
        return np.zeros(0)
    step = 1.0 / (_PER_RESOLUTION * length)
    first = round(LEAST_REPEATS * _PER_RESOLUTION)
    # The shortest lies within, seldom on a step.
    last = min(int(np.ceil(1.0 / (SHORTEST[kind] * step))), first + _MOST_FREQUENCIES - 1)
    found: FloatArray = step * np.arange(first, last + 1, dtype=np.float64)
    return found


def wave_columns(targets: FloatArray, frequency: float) -> list[FloatArray]:
    """Return cosine and sine (m,) of the harmonics of a ``frequency`` (1 / mm or 1 / deg) at the
    ``targets`` (m,).
    """
    angle = 2.0 * np.pi * frequency * (targets - targets[0])
    return [
        part
        for harmonic in HARMONICS
        for part in (np.cos(harmonic * angle), np.sin(harmonic * angle))
    ]


@dataclass(frozen=True, slots=True)
class _PeriodSearch:
    """Input of a search for periods: the means, the ``frequencies`` (f,) to search, and the
    ``usual`` and ``known`` periods (mm or deg).
    """

    bidirectional: BidirectionalMeans
    basis: Basis
    frequencies: FloatArray
    usual: tuple[UsualPeriod, ...]
    known: tuple[float, ...]

    def candidates_with(self, periods: PeriodSet) -> PeriodScan | None:
        """Return the candidates for one more period if the ``periods`` of a set exist.

        None if there are too few targets, or if the last period of the set has aliases.
        """
        members = periods.members
        if members and members[-1].aliases.size:
            return None
        likelihood = self._likelihood(members)
        if likelihood is None:
            return None
        return find_candidates(likelihood, self.frequencies, self.usual, self._before(members))

    def detectable(self, periods: PeriodSet) -> FloatArray:
        """Return the smallest wave amplitudes (f,), mm or deg, that the targets show if the
        ``periods`` of a set exist.
        """
        likelihood = self._likelihood(periods.members)
        if likelihood is None:
            return np.full(self.frequencies.size, np.inf)
        return likelihood.detectable(self.frequencies)

    def refined(self, periods: PeriodSet) -> PeriodSet:
        """Return a set of two or more periods after each period is searched again, given the other
        periods of the set.

        The probability of the set is then the product of the likelihoods of its waves, one after
        another, at their new frequencies. Each likelihood is multiplied by a factor for the prior
        of the period and the width of its peak, with all other periods present.
        """
        members, log = list(periods.members), 0.0
        for place in range(len(members)):
            others = members[:place] + members[place + 1 :]
            likelihood = self._likelihood(others)
            if likelihood is None or not others:
                return periods
            before = replace(self._before(members[:place]), taken=_frequencies(others))
            found = refine_candidate(
                likelihood, members[place], self.frequencies, self.usual, before
            )
            if found is None:
                return periods
            members[place] = found
            log += found.log - _there(likelihood, found)
        for place, member in enumerate(members):
            given = self._likelihood(members[:place])
            log += 0.0 if given is None else _there(given, member)
        return PeriodSet(tuple(members), log)

    def different(self, sets: Sequence[PeriodSet]) -> list[PeriodSet]:
        """Return the sets of periods without repetitions (equal periods in another order), the most
        probable first. The best `_BEAM` sets are refined.

        Of two equal sets the less probable one is dropped. Its later periods were searched while an
        earlier period had a wrong value.
        """
        near = PEAK / float(np.ptp(self.bidirectional.targets))
        kept: list[PeriodSet] = []
        for each in _descending(sets):
            if not any(each.same(other, near) for other in kept):
                kept.append(each)
        return _descending([*map(self.refined, kept[:_BEAM]), *kept[_BEAM:]])

    def _likelihood(self, members: Sequence[PeriodCandidate]) -> PeriodLikelihood | None:
        targets = self.bidirectional.targets
        periods = [*self.known, *(member.period for member in members)]
        waves = [wave for period in periods for wave in wave_columns(targets, 1.0 / period)]
        columns = np.column_stack([self.bidirectional.free, *waves])
        if columns.shape[1] > targets.size - LEFT:
            return None
        return PeriodLikelihood(replace(self.bidirectional, free=columns), self.basis)

    def _before(self, members: Sequence[PeriodCandidate]) -> PeriodOdds:
        return replace(FURTHER if self.known or members else FIRST, taken=_frequencies(members))


def _frequencies(members: Sequence[PeriodCandidate]) -> tuple[float, ...]:
    return tuple(1.0 / member.period for member in members)


def _there(likelihood: PeriodLikelihood, member: PeriodCandidate) -> float:
    """Return the log odds of a wave of exactly the frequency of ``member`` against no wave."""
    frequency = np.array(_frequencies([member]))
    odds = likelihood.log_odds(frequency, likelihood.telling(frequency))
    return float(np.logaddexp(*odds)[0] - np.log(2.0))
