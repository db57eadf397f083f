"""Simulated repeat tests of one axis at new random targets.

All come from the same draws, so two answers differ only by the requested change, not by chance.
"""

from __future__ import annotations

import functools
import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from itertools import pairwise
from typing import Any, Final

import numpy as np

from compwright.estimation.axis import Draws
from compwright.estimation.hidden_periods import HiddenPeriods
from compwright.planning.wanted_correction import MeasuredError
from compwright.prediction.active_corrections import Correction
from compwright.prediction.fresh_scatter import FreshScatter, fresh_scatter
from compwright.prediction.positioning import dithered_targets, fresh_slopes, predict_test
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.noise import IndexArray, NoiseDraws, NoisePart, without
from compwright.records.prediction import Quantiles
from compwright.records.result import PositioningResult

#: Fresh tests that are drawn: fewer where a test has more than so many readings, some always.
_DRAWS: Final = 2000
_READINGS: Final = 4000
_FEWEST_DRAWS: Final = 400
#: Newly dithered targets stay this far from the ends of the travel: mm, and for rotary axes deg.
END_MARGIN: Final = {AxisKind.LINEAR: 4.0, AxisKind.ROTARY: 0.0}
#: Different sets of new targets: so many that some have a target wherever the error may
#: differ from the table, such as between two targets about a jump; and targets of all sets, at
#: most.
_SETS: Final = 40
_MOST_TARGETS: Final = 2000
#: From 5 to 95 % a normal law is so many standard deviations wide.
BAND: Final = 3.29


@dataclass(frozen=True, slots=True)
class RepeatConditions:
    """The conditions of a simulated test: the index ``place`` of the measured test whose noise it
    has, and the standard deviation of its slope from uncertain temperature (mm/mm).


    """

    place: int = 0
    slope_std: float = 0.0


#: As the first test of an axis, at a known temperature.
FIRST: Final = RepeatConditions()


@dataclass(frozen=True, slots=True, kw_only=True)
class FreshTests:
    """Random draws of the deviation of an axis at new targets, mm or deg.

    ``sets`` (k, m): k sets of m targets. ``expected`` (k, m): the expected deviation at these.
    ``chosen`` (s,): for each of s draws the index of its set, ascending. A simulated test repeats
    the test ``result``: it adds the scatter of the readings, from the random generator in
    ``state``, and ``slopes`` (s, m) from an uncertain temperature.

    ``drawn``: the scatter of all parts of the noise, and the scatter without the parts that were
    removed last. Both are large, so they are drawn only when needed. ``hidden``: returns the
    periods that the readings leave open. ``waves``: returns draws (s, m) of these periods.
    """

    result: PositioningResult
    sets: FloatArray
    expected: Mapping[Direction, FloatArray]
    chosen: IndexArray
    draws: Draws
    slopes: FloatArray
    state: Any
    hidden: Callable[[], HiddenPeriods]
    waves: list[FloatArray] = field(default_factory=list)
    drawn: dict[frozenset[NoisePart], FreshScatter] = field(default_factory=dict)

    @property
    def targets(self) -> FloatArray:
        """The targets (s, m) of each simulated test."""
        return self.sets[self.chosen]

    def quantiles(
        self,
        change: Correction,
        *,
        known: bool = True,
        unknown: bool = True,
        warm: bool = True,
        cured: Sequence[NoisePart] = (),
        only: str | None = None,
        waves: FloatArray | None = None,
    ) -> Mapping[str, Quantiles]:
        """Return quantiles of each parameter of the simulated tests after a ``change`` of the
        correction. The other arguments leave out parts of the deviation or of the noise, add
        periodic errors, or select one parameter.

        ``known``: whether to include the estimated error and the change. ``unknown``: whether to
        include the uncertainty of the estimate. ``warm``: whether to include the slopes. ``cured``:
        parts of the noise to leave out. ``only``: the one parameter to calculate. ``waves`` (s, m):
        periodic errors that are added to the deviation.
        """
        deviations = []
        for direction, drawn in (
            (Direction.POSITIVE, self.draws.positive),
            (Direction.NEGATIVE, self.draws.negative),
        ):
            mean = self.expected[direction]
            there = (mean + change(self.sets, direction))[self.chosen] if known else 0.0
            uncertain = drawn - mean[self.chosen] if unknown else np.zeros_like(drawn)
            added = 0.0 if waves is None else waves
            deviations.append(there + uncertain + (self.slopes if warm else 0.0) + added)
        still = np.zeros(self.sets.shape[1])
        found = predict_test(
            deviations[0],
            deviations[1],
            self._scatter_without(frozenset(cured)),
            change_positive=still,
            change_negative=still,
            coverage=self.result.coverage,
            vdi=self.result.standard == "vdi3441",
            only=only,
        )
        return {
            name: value
            for name, value in found.items()
            if self.result.parameters.get(name) is not None
        }

    def band(self, change: Correction, *, only: str | None = None) -> Mapping[str, Quantiles]:
        """Return quantiles of each parameter (or ``only`` one) of the simulated tests after a
        ``change`` of the correction, with all possible periods of the error included.

        Periods that the readings show are in the draws, each as often as it is probable. Periods
        that the readings leave open change only the upper end, because the axis may have none of
        them.
        """
        shown, waves = self.quantiles(change, only=only), self.open_waves()
        if waves is None:
            return shown
        more = self.quantiles(change, only=only, waves=waves)
        return {
            name: Quantiles(
                median=each.median,
                p05=min(each.p05, more[name].p05),
                p95=max(each.p95, more[name].p95),
            )
            for name, each in shown.items()
        }

    def open_waves(self) -> FloatArray | None:
        """Return random draws (s, m) of the periodic errors that the readings possibly hide, mm or
        deg, or None if there are no such errors.
        """
        if not self.waves:
            result, (count, _) = self.result, self.draws.positive.shape
            rng = generator(result.test.axis, result.test.name, "hidden periods")
            self.waves.append(self.hidden().waves(self.targets, count, rng))
        return self.waves[0] if np.any(self.waves[0]) else None

    def with_noise(self, noise: NoiseDraws) -> FreshTests:
        """Return the same simulated tests with ``noise`` instead of their own."""
        return replace(self, draws=replace(self.draws, noise=noise), drawn={})

    def has(self, parts: Sequence[NoisePart]) -> bool:
        """Return whether the simulated noise contains any of the ``parts``, such as drift."""
        noise = self.draws.noise
        bare = without(noise, *parts)
        return any(
            not np.array_equal(getattr(noise, each.name), getattr(bare, each.name))
            for each in fields(noise)
        )

    def _scatter_without(self, parts: frozenset[NoisePart]) -> FreshScatter:
        removed = parts if parts and self.has(tuple(parts)) else frozenset()
        if removed not in self.drawn:
            for other in [key for key in self.drawn if key and removed]:
                del self.drawn[other]
            rng = np.random.default_rng()
            rng.bit_generator.state = self.state
            bare = without(self.draws.noise, *removed)
            self.drawn[removed] = _scatter(self.result, bare, self.sets, self.chosen, rng)
        return self.drawn[removed]


def draws_like(result: PositioningResult) -> int:
    """Return the number of repetitions of the test ``result`` to simulate, fewer if it has many
    readings.

    Time and memory for the repetitions grow no faster than the number of readings. Fewer
    repetitions are enough for a test with many readings, because its parameters scatter less.
    """
    readings = result.test.positive.size + result.test.negative.size
    return min(_DRAWS, max(_FEWEST_DRAWS, _DRAWS * _READINGS // max(readings, 1)))


def fresh_tests(
    result: PositioningResult, posterior: MeasuredError, axis: Axis, like: RepeatConditions = FIRST
) -> FreshTests:
    """Return simulated repetitions of the test ``result`` of ``axis`` at new random targets, under
    the conditions ``like``. Equal names of axis and test give equal draws.
    """
    return _fresh_tests(result, posterior, axis.name, axis.kind, axis.travel, like)


@functools.lru_cache(maxsize=1)  # several stages need those of one axis, one after the other
def _fresh_tests(
    result: PositioningResult,
    posterior: MeasuredError,
    axis: str,
    kind: AxisKind,
    travel: tuple[float, float],
    like: RepeatConditions,
) -> FreshTests:
    name, m = result.test.name, result.test.targets.size
    count = draws_like(result)
    rng = generator(axis, name, "targets")
    several = min(_SETS, count, max(1, _MOST_TARGETS // m))
    sets = np.array([dithered_targets(travel, m, rng, END_MARGIN[kind]) for _ in range(several)])
    unique, back = np.unique(sets, return_inverse=True)
    estimate = posterior.summary(unique)
    rng = generator(axis, name, "draws")
    chosen = np.arange(count) * several // count
    draws = posterior.draw(sets[chosen], count, rng, like.place)
    state = rng.bit_generator.state
    drawn: dict[frozenset[NoisePart], FreshScatter] = {}
    if like.slope_std > 0.0:  # the slopes come after the scatter
        drawn[frozenset()] = _scatter(result, draws.noise, sets, chosen, rng)
    return FreshTests(
        result=result,
        sets=sets,
        expected={way: estimate.mean(way)[back.reshape(sets.shape)] for way in Direction},
        chosen=chosen,
        draws=draws,
        slopes=fresh_slopes(sets[chosen], count, like.slope_std, rng),
        state=state,
        hidden=lambda: posterior.hidden,
        drawn=drawn,
    )


def _scatter(
    result: PositioningResult,
    noise: NoiseDraws,
    sets: FloatArray,
    chosen: IndexArray,
    rng: np.random.Generator,
) -> FreshScatter:
    plus, minus = (
        int(np.max(result.test.readings(direction), initial=0.0)) for direction in Direction
    )
    ends = np.searchsorted(chosen, np.arange(len(sets) + 1)).tolist()
    parts = [
        fresh_scatter(noise.taken(slice(*own)), targets, plus, minus, rng)
        for own, targets in zip(pairwise(ends), sets, strict=True)
    ]
    return FreshScatter(
        **{
            each.name: np.vstack([getattr(one, each.name) for one in parts])
            for each in fields(FreshScatter)
        }
    )


def generator(*names: str) -> np.random.Generator:
    """Return a random generator that depends only on the given names, so that a job always predicts
    the same numbers.
    """
    digest = hashlib.sha256("\x1f".join(names).encode("utf-8", "surrogatepass")).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "big"))
