"""Search for periods of the error that nobody named.

Before the data `FIRST` and `FURTHER` say what is expected: hardly a screw or a worm runs without an
error that repeats with its turn, at a usual period (`usual_periods`), however small; an axis that
is closed over a scale along it shows none of it, and every second one is taken for such (a
judgement, from no document); a second period is rare. One or two harmonics have equal odds. The
likelihood (`period_likelihood`) is that over all amplitudes and phases, whatever the smooth and the
local part are. Periods are found one after another, each beside those found before (Bretthorst,
Bayesian Spectrum Analysis and Parameter Estimation, 1988, chapters 3 and 6).

Waves that have all but the same values at the targets (`basis.ALIASED`) cannot be told apart. Among
them only the data decide, not what is usual: equal ones share their probability evenly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.basis import HARMONICS, Basis
from compwright.estimation.period_candidates import Candidate, Look, Odds, candidates_of
from compwright.estimation.period_likelihood import Middles, PeriodLikelihood
from compwright.estimation.usual_periods import usual_periods
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.estimate import AxisPeriod, PeriodEvidence

#: What is expected before the data: the first period, and one beside those that are known.
FIRST: Final = Odds(none=0.5, usual=0.38)
FURTHER: Final = Odds(none=0.75, usual=0.18)
#: A period repeats at least so often over the targets: fewer waves are smooth error.
LEAST_REPEATS: Final = 8.0
#: The shortest period that is searched: below the shortest usual lead and half of it, mm or deg.
SHORTEST: Final = {AxisKind.LINEAR: 2.0, AxisKind.ROTARY: 0.5}
#: Frequencies at most, three per 1 / length: what a long axis would ask beyond is not searched.
_MOST_FREQUENCIES: Final = 16000
_PER_RESOLUTION: Final = 3
#: Periods one after another at most.
_MOST_PERIODS: Final = 4
#: Probability from which on a period is told.
TOLD: Final = 0.05
#: Odds against none (natural logarithm) from which on one more is looked for beside it.
_FOLLOWED: Final = 0.0
#: Models of less probability are not kept; those of one period at most.
_LEAST_MODEL: Final = 0.01
_NEIGHBOURS: Final = 5
#: Periods are told to a picometre, or 4e-6 arcsec: what lies below hangs on the processor.
_DECIMALS: Final = 9
#: The curve that is shown: its steps, and the log odds below which it is cut off.
_LOWEST: Final = -10.0
_SHOWN: Final = 300
#: Targets that have to be left beside what is free.
LEFT: Final = 4
#: Periods that differ by less than this part are one.
_SAME: Final = 2e-3


@dataclass(frozen=True, slots=True)
class PeriodModel:
    """What may be: the ``periods`` (mm or deg) beside those known, with their ``harmonics``, and
    how probable it is."""

    periods: tuple[float, ...]
    harmonics: tuple[tuple[int, ...], ...]
    probability: float


@dataclass(frozen=True, slots=True)
class PeriodCurve:
    """Evidence over the period, for a picture: ``periods`` (f,) descending, mm or deg, and natural
    logarithm (f,) of the likelihood of a wave of that period over that of none."""

    periods: FloatArray
    log_odds: FloatArray


@dataclass(frozen=True, slots=True)
class PeriodSearch:
    """What a search found: ``models``, the most probable first, probabilities sum to 1;
    ``found``: periods with the probability that they are there; ``alike``: groups of periods that
    these targets cannot tell apart, each with the probability that it is one of them.
    """

    models: tuple[PeriodModel, ...]
    found: tuple[AxisPeriod, ...]
    alike: tuple[tuple[tuple[float, ...], float], ...]
    curve: PeriodCurve | None

    @property
    def sure(self) -> tuple[tuple[float, ...], ...]:
        """The groups of which one is there rather than not."""
        return tuple(group for group, probability in self.alike if probability > 0.5)

    def evidence(self) -> PeriodEvidence | None:
        """Return the curve for a picture: the highest value in each of `_SHOWN` steps that are even
        in the logarithm of the period; None where nothing was searched.
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
        return PeriodEvidence(self.curve.periods[best].round(_DECIMALS), odds, self.sure)


def search_periods(
    middles: Middles,
    basis: Basis,
    kind: AxisKind,
    *,
    known: Sequence[float] = (),
    suggested: Sequence[float] = (),
) -> PeriodSearch:
    """Return the periods beside ``known`` (mm or deg) that the middles tell of, with probabilities.

    ``basis`` holds the smooth functions (its periods are not looked at). Each of the ``suggested``
    periods (the control's own files: mm or deg) is as likely as all usual ones together. Too few
    targets for a search: the model without a period alone. Prior and sources: module docstring.
    """
    frequencies = searched(middles.targets, kind)
    if not frequencies.size:
        return PeriodSearch((PeriodModel((), (), 1.0),), (), (), None)
    looks: list[Look] = []
    taken: list[float] = []
    usual = usual_periods(kind, suggested)
    beside = [wave for period in known for wave in wave_columns(middles.targets, 1.0 / period)]
    while len(looks) < _MOST_PERIODS:
        columns = np.column_stack([middles.free, *beside])
        if columns.shape[1] > middles.targets.size - LEFT:
            break
        likelihood = PeriodLikelihood(replace(middles, free=columns), basis)
        before = replace(FURTHER if beside else FIRST, taken=tuple(taken))
        looks.append(candidates_of(likelihood, frequencies, usual, before))
        best = next(iter(looks[-1].candidates), None)
        if best is None or best.log < _FOLLOWED or best.aliases.size:
            break
        beside += wave_columns(middles.targets, 1.0 / best.period)
        taken.append(1.0 / best.period)
    if not looks:
        return PeriodSearch((PeriodModel((), (), 1.0),), (), (), None)
    curve = PeriodCurve(1.0 / frequencies, looks[0].log_odds)
    return _gathered(looks, curve, suggested)


def searched(targets: FloatArray, kind: AxisKind) -> FloatArray:
    """Return the frequencies (f,) that are searched, equally spaced, ascending, 1 / mm or 1 / deg:
    from `LEAST_REPEATS` over the ``targets`` to the `SHORTEST` period; none for fewer than eight
    targets, with which no wave can be told from scatter.
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


def _gathered(looks: list[Look], curve: PeriodCurve, suggested: Sequence[float]) -> PeriodSearch:
    """Return the probabilities of what the looks found, each beside the best of those before."""
    models: list[tuple[tuple[Candidate, ...], float]] = [((), 0.0)]
    place = 0
    for look in looks:
        members, log = models[place]
        # What is no candidate counts with the model beside which it was looked for.
        models[place] = (members, log + float(np.logaddexp(0.0, look.rest)))
        place = len(models)
        models += [((*members, each), log + each.log) for each in look.candidates]
    total = _log_sum(np.array([each for _, each in models]))
    likely = [
        (members, probability)
        for members, probability in ((each, float(np.exp(log - total))) for each, log in models)
        if probability >= _LEAST_MODEL
    ]
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
    likely: list[tuple[tuple[Candidate, ...], float]],
) -> tuple[tuple[tuple[float, ...], float], ...]:
    groups: dict[tuple[float, ...], float] = {}
    for members, probability in likely:
        for member in members:
            if member.aliases.size:
                group = (member.period, *(1.0 / member.aliases).tolist())
                groups[group] = min(groups.get(group, 0.0) + probability, 1.0)
    return tuple(groups.items())


def _found(
    likely: list[tuple[tuple[Candidate, ...], float]], suggested: Sequence[float]
) -> tuple[AxisPeriod, ...]:
    """Return each period with the probability of all that it is part of."""
    found: dict[float, float] = {}
    for members, probability in likely:
        for member in members:
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
        if probability >= TOLD
    )


def _neighbours(members: tuple[Candidate, ...], probability: float) -> list[PeriodModel]:
    """Return the models of one set of periods: several where the last one is not sharply known."""
    if not members:
        return [PeriodModel((), (), probability)]
    last = members[-1]
    if last.aliases.size:
        picked = np.append(last.aliases[:: max(1, last.aliases.size // 7)], 1.0 / last.period)
        shares = np.full(picked.size, 1.0 / picked.size)
    else:
        order = np.argsort(last.frequencies)
        cumulative = np.cumsum(last.shares[order])
        ladder = (np.arange(_NEIGHBOURS) + 0.5) / _NEIGHBOURS * cumulative[-1]
        picked, counts = np.unique(
            last.frequencies[order][np.searchsorted(cumulative, ladder)], return_counts=True
        )
        shares = counts / _NEIGHBOURS
    rest = tuple(round(member.period, _DECIMALS) for member in members[:-1])
    harmonics = tuple(HARMONICS for _ in members)
    return [
        PeriodModel(
            (*rest, round(float(1.0 / frequency), _DECIMALS)), harmonics, probability * float(share)
        )
        for frequency, share in zip(picked, shares, strict=True)
    ]


def _log_sum(logs: FloatArray) -> float:
    top = float(np.max(logs))
    return top + float(np.log(np.sum(np.exp(logs - top))))
