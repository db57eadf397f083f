"""The result of a search for periods as models with probabilities (Bayesian model averaging:
Hoeting et al., Statistical Science 14, 1999).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.basis import HARMONICS
from compwright.estimation.period_candidates import PeriodCandidate
from compwright.records.axis import FloatArray
from compwright.records.estimate import AxisPeriod, PeriodEvidence

#: Least probability of a period that is reported.
REPORTED: Final = 0.05
#: Models of less probability are not kept; those of one set of periods at most.
LEAST_MODEL: Final = 0.01
_NEIGHBOURS: Final = 5
#: Periods are rounded to a picometre, or 4e-6 arcsec: smaller digits depend on the processor.
_DECIMALS: Final = 9
#: The curve that is shown: its steps, and the log odds below which it is cut off.
_LOWEST: Final = -10.0
_SHOWN: Final = 300
#: Periods that differ by less than this part are one.
_SAME: Final = 2e-3


@dataclass(frozen=True, slots=True)
class PeriodModel:
    """One possible set of additional ``periods`` (mm or deg) of the error, with their ``harmonics``
    and the probability of the set.
    """

    periods: tuple[float, ...]
    harmonics: tuple[tuple[int, ...], ...]
    probability: float


@dataclass(frozen=True, slots=True)
class PeriodCurve:
    """The evidence for a wave as a function of its period, for a figure.

    ``periods`` (f,): descending, mm or deg. ``log_odds`` (f,): natural logarithm of the likelihood
    of a wave of this period over that of no wave. ``detectable`` (f,): smallest amplitude that the
    targets show, mm or deg.
    """

    periods: FloatArray
    log_odds: FloatArray
    detectable: FloatArray


@dataclass(frozen=True, slots=True)
class PeriodSearch:
    """The result of a search for periods: possible models, and each found period with its
    probability.

    ``models``: the most probable first; their probabilities sum to 1. ``alike``: groups of periods
    that these targets cannot distinguish. Each group has the probability that one of its periods
    exists.
    """

    models: tuple[PeriodModel, ...]
    found: tuple[AxisPeriod, ...]
    alike: tuple[tuple[tuple[float, ...], float], ...]
    curve: PeriodCurve | None

    @property
    def sure(self) -> tuple[tuple[float, ...], ...]:
        """The groups of indistinguishable periods that are real with a probability above 1/2."""
        return tuple(group for group, probability in self.alike if probability > 0.5)

    def evidence(self) -> PeriodEvidence | None:
        """Return the evidence for a wave as a curve over its period, None without a search.

        The periods are divided into `_SHOWN` steps, equal in the logarithm of the period. Each step
        has its highest evidence and its largest detectable amplitude.
        """
        if self.curve is None:
            return None
        logs = np.log(self.curve.periods)
        edges = np.linspace(logs[-1], logs[0], _SHOWN + 1)
        step = np.clip(np.searchsorted(edges, logs, side="right") - 1, 0, _SHOWN - 1)
        order = np.lexsort((-np.round(self.curve.log_odds, 6), step))
        _, first = np.unique(step[order], return_index=True)
        best = order[first]
        odds: FloatArray = np.maximum(self.curve.log_odds[best], _LOWEST).round(6)
        largest = np.zeros(_SHOWN)
        np.maximum.at(largest, step, self.curve.detectable)
        return PeriodEvidence(
            self.curve.periods[best].round(_DECIMALS),
            odds,
            largest[np.unique(step)].round(_DECIMALS),
            self.sure,
        )


#: A search that found nothing, for want of targets.
NO_SEARCH: Final = PeriodSearch((PeriodModel((), (), 1.0),), (), (), None)


@dataclass(frozen=True, slots=True, eq=False)
class PeriodSet:
    """A set of periods that possibly exist together, in the order of discovery. ``log``: the log
    odds of the set against no period.
    """

    members: tuple[PeriodCandidate, ...]
    log: float

    def extended(self, member: PeriodCandidate) -> PeriodSet:
        """Return the set with one more period, which was found on the assumption that the periods
        of the set exist.
        """
        return PeriodSet((*self.members, member), self.log + member.log)

    def less_certain(self, rest: float) -> PeriodSet:
        """Return the set with a probability that also covers further periods which are no
        candidates. ``rest``: log odds that such a period exists in addition to the set.
        """
        return PeriodSet(self.members, self.log + float(np.logaddexp(0.0, rest)))

    def same(self, other: PeriodSet, near: float) -> bool:
        """Return whether two sets have the same periods in any order, with frequencies that differ
        by at most ``near`` (1 / mm or 1 / deg).
        """
        mine, theirs = (np.sort([1.0 / m.period for m in s.members]) for s in (self, other))
        return mine.size == theirs.size and bool(np.all(np.abs(mine - theirs) <= near))


def probable_sets(sets: Sequence[PeriodSet]) -> list[tuple[PeriodSet, float]]:
    """Return the most probable ``sets`` with their probabilities, without very improbable sets."""
    total = log_sum(np.array([each.log for each in sets]))
    weighed = ((each, float(np.exp(each.log - total))) for each in sets)
    return [(each, probability) for each, probability in weighed if probability >= LEAST_MODEL]


def search_result(
    likely: Sequence[tuple[PeriodSet, float]], curve: PeriodCurve, suggested: Sequence[float]
) -> PeriodSearch:
    """Return the result of a search from ``likely`` sets of periods and their probabilities.
    ``curve``: the evidence for a wave over its period; ``suggested``: periods from the files.
    """
    kept = [model for each in likely for model in _neighbours(*each)]
    scale = sum(model.probability for model in kept)
    return PeriodSearch(
        tuple(
            PeriodModel(model.periods, model.harmonics, model.probability / scale)
            for model in sorted(kept, key=lambda model: -round(model.probability, 9))
        ),
        _found(likely, suggested),
        _alike(likely),
        curve,
    )


def _alike(
    likely: Sequence[tuple[PeriodSet, float]],
) -> tuple[tuple[tuple[float, ...], float], ...]:
    groups: dict[tuple[float, ...], float] = {}
    for each, probability in likely:
        for member in each.members:
            if member.aliases.size:
                group = (member.period, *(1.0 / member.aliases).tolist())
                groups[group] = min(groups.get(group, 0.0) + probability, 1.0)
    return tuple(groups.items())


def _found(
    likely: Sequence[tuple[PeriodSet, float]], suggested: Sequence[float]
) -> tuple[AxisPeriod, ...]:
    """Return each period with its total probability over all sets in ``likely`` that contain it,
    and whether it was ``suggested`` by the files.
    """
    found: dict[float, float] = {}
    for each, probability in likely:
        for member in each.members:
            own = 1.0 - float(np.sum(member.alias_shares))
            parts = [(member.period, own)]
            parts += list(zip(1.0 / member.aliases, member.alias_shares, strict=True))
            for period, part in parts:
                same = next((p for p in found if abs(p - period) < _SAME * p), float(period))
                found[same] = min(found.get(same, 0.0) + float(part) * probability, 1.0)
    return tuple(
        AxisPeriod(
            round(period, _DECIMALS),
            round(probability, 6),
            "files" if any(abs(one - period) < _SAME * one for one in suggested) else "found",
        )
        for period, probability in sorted(found.items(), key=lambda pair: -round(pair[1], 9))
        if probability >= REPORTED
    )


def _neighbours(periods: PeriodSet, probability: float) -> list[PeriodModel]:
    """Return several models with slightly different periods for a set of uncertain periods; they
    share the ``probability`` of the set.

    The values of each period are quantiles of its own distribution, combined with those of other
    periods in a different order (Latin hypercube: McKay, Beckman and Conover, Technometrics 21,
    1979).
    """
    if not periods.members:
        return [PeriodModel((), (), probability)]
    # A period with aliases comes last: no further one is searched given it.
    last = periods.members[-1]
    count = _picked(last).size if last.aliases.size else _NEIGHBOURS
    harmonics = tuple(HARMONICS for _ in periods.members)
    ladders = [
        _ladder(member, count)[np.arange(count) * (1 + place) % count]
        for place, member in enumerate(reversed(periods.members))
    ]
    rows = [
        tuple(round(float(period), _DECIMALS) for period in reversed(row))
        for row in zip(*ladders, strict=True)
    ]
    return [
        PeriodModel(row, harmonics, probability * rows.count(row) / count)
        for row in dict.fromkeys(rows)
    ]


def _ladder(member: PeriodCandidate, count: int) -> FloatArray:
    """Return ``count`` equally likely values (count,) of an imprecisely known period, mm or deg."""
    if member.aliases.size:
        return np.asarray(1.0 / _picked(member))
    order = np.argsort(member.frequencies)
    cumulative = np.cumsum(member.shares[order])
    quantiles = (np.arange(count) + 0.5) / count * cumulative[-1]
    return np.asarray(1.0 / member.frequencies[order][np.searchsorted(cumulative, quantiles)])


def _picked(member: PeriodCandidate) -> FloatArray:
    """Return frequencies that represent a period with aliases: its own, and about seven aliases at
    equal steps in the list of all aliases.
    """
    return np.append(member.aliases[:: max(1, member.aliases.size // 7)], 1.0 / member.period)


def log_sum(logs: FloatArray) -> float:
    """Return the logarithm of the sum of exponentials of ``logs`` (n,)."""
    top = float(np.max(logs))
    return top + float(np.log(np.sum(np.exp(logs - top))))
