"""The possible patterns of shifts of the traverses of a test: offset, tilt, and drift over the
runs.

The shifts of the traverses are normally distributed. Their covariance is a sum of known patterns
with unknown sizes (linear mixed model: Searle, Casella and McCulloch, Variance Components, 1992,
chapter 6).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

import numpy as np

from compwright.estimation.noise_readings import CellReadings
from compwright.records.axis import FloatArray
from compwright.records.noise import (
    WALK,
    WAVE,
    BoolArray,
    progress,
    slackening,
    traverse_order,
    wave_effects,
)
from compwright.records.positioning import Cycle

OFFSET, TILT, DRIFT, DRIFT_TILT = range(4)
#: Waves: correlation time in parts of the test, and oscillations per test. The first have no
#: period: with a correlation time shorter than a traverse they are scatter, with one as long as the
#: test a drift. The others have one, as from a heating control: fewer than half an oscillation is a
#: drift, one in each of five runs looks like the error. Their spectra are so wide that they fill
#: the steps between them. A test shows one amplitude of such a wave, with two degrees of freedom.
_OSCILLATIONS: Final = np.arange(0.5, 5.0, 0.35)
WAVES: Final = np.array([(0.1, 0.0), (0.2, 0.0), (0.4, 0.0), *((2.0, k) for k in _OSCILLATIONS)])
#: Prior of the forms of offsets: the patterns `INDEPENDENT`, `RUNS`, `WALK`, and `WAVES`, half
#: of them with a period. A judgement, no count: what clamps, sticks or reverses differently moves
#: each traverse on its own, the plainest form, nearly as often as all others together.
FORM_SHARES: Final = np.concatenate(
    [[0.45, 0.15, 0.2], np.full(3, 0.1 / 3), np.full(_OSCILLATIONS.size, 0.1 / _OSCILLATIONS.size)]
)
#: Time constants of warming up, in parts of the test: none (even drift), a half, a fifth.
RATES: Final = np.array([0.0, 2.0, 5.0])
#: Prior of these: even drift, the plainest, in more than half of the cases; a judgement.
PACE_SHARES: Final = np.array([0.6, 0.2, 0.2])


@dataclass(slots=True)
class Sizes:
    """Standard deviations and patterns of the shifts of traverses, in the present state of the
    sampler.

    ``size`` (4,): standard deviations of offset, tilt, drift and drift of the tilt, as multiples of
    the standard deviation of a reading. ``form``: pattern, as index in `FORM_SHARES`. ``rate``:
    rate at which the drift fades, as index in `RATES`. ``moved`` (q,): which shifts of
    `Patterns.moves` exist. ``absent`` (4,): probability at the last draw that each size is zero.
    """

    moved: BoolArray
    form: int = 0
    rate: int = 0
    size: FloatArray = field(default_factory=lambda: np.zeros(4))
    absent: FloatArray = field(default_factory=lambda: np.ones(4))

    @property
    def pattern(self) -> int:
        """The pattern of the traverse offsets by its number in `NoiseDraws`."""
        return min(self.form, WAVE)

    @property
    def wave(self) -> tuple[float, float]:
        """The correlation time of offsets that follow a wave, as a share of the test, and its
        oscillations per test; 1 and 0 for other patterns.
        """
        pace, cycles = WAVES[self.form - WAVE] if self.form >= WAVE else (1.0, 0.0)
        return float(pace), float(cycles)


@dataclass(frozen=True, slots=True, kw_only=True)
class Patterns:
    """The possible patterns of the k offsets and tilts of the traverses of a test, each of unit
    size.

    ``moves`` (3, q, k): effect of each possible shift; the three patterns are a shift of one
    traverse, a shift of one run, and a step that shifts all later traverses. ``waves`` (waves, k,
    k), ``tilt`` (forms, k, k): covariances of waves and of tilts. ``drift``, ``drift_tilt`` (rates,
    k): effects of a drift of offset and of tilt, one row for each rate. ``walks``: whether time
    passes between the runs, so that drift is possible.
    """

    moves: FloatArray
    waves: FloatArray
    tilt: FloatArray
    drift: FloatArray
    drift_tilt: FloatArray
    walks: bool

    @property
    def known(self) -> int:
        """The number of possible patterns of traverse offsets in this test."""
        return len(FORM_SHARES) if self.walks else WALK

    def covariance(self, sizes: Sizes) -> FloatArray:
        """Return the covariance (k, k) of traverse offsets and tilts, relative to the variance of a
        reading.
        """
        offset = self.offset_of(sizes.form, sizes.moved)
        total: FloatArray = (
            sizes.size[OFFSET] ** 2 * offset + sizes.size[TILT] ** 2 * self.tilt[sizes.form]
        )
        return total

    def offset_of(self, form: int, moved: BoolArray) -> FloatArray:
        """Return the covariance (k, k) of traverse offsets of unit size in the pattern with index
        ``form``. Only the shifts marked in ``moved`` (q,) exist, unless the offsets follow a wave.
        """
        if form >= WAVE:
            return np.asarray(self.waves[form - WAVE])
        there = self.moves[form, moved]
        return np.asarray(there.T @ there)

    def at_least(
        self, sizes: Sizes, effects: FloatArray, variance: float, share: float, made: BoolArray
    ) -> FloatArray:
        """Return the standard deviations (2,) of traverse offset and tilt, mm or deg: the drawn
        standard deviations or, if that is larger, the rms of the offsets and tilts ``effects`` (k,)
        of the measured traverses (marked in ``made``).

        A drawn standard deviation is that in ``sizes`` times the standard deviation of a reading,
        the root of ``variance``. The rms is about the mean of each direction. ``share``: share of
        the traverses with an offset. ``made`` (2, n): which traverses exist, by direction and run.
        A standard deviation of 0 remains 0. That of a wave remains as drawn: a test shows one
        amplitude, and the next test may show a smaller one.
        """
        found: FloatArray = sizes.size[:DRIFT] * np.sqrt(variance)
        forms = self.offset_of(sizes.form, np.ones_like(sizes.moved)), self.tilt[sizes.form]
        parts = effects.reshape(2, 2, -1)
        for kind, (unit, part) in enumerate(zip(forms, (share, 1.0), strict=True)):
            if found[kind] == 0.0 or (kind == OFFSET and sizes.form >= WAVE):
                continue
            shown = expected = 0.0
            for way, there in enumerate(made):
                if np.any(there):
                    own = parts[way, kind, there]
                    place = (2 * way + kind) * there.size + np.flatnonzero(there)
                    block = unit[np.ix_(place, place)]
                    shown += float(np.sum((own - np.mean(own)) ** 2))
                    expected += float(np.trace(block) - np.mean(block) * own.size)
            if shown > found[kind] ** 2 * part * expected > 0.0:
                found[kind] = np.sqrt(shown / (part * expected))
        return found

    def columns(self, rate: int) -> FloatArray:
        """Return the effect (k, 2) of a drift and of a tilt drift on the traverses, for the rate
        with index ``rate`` at which the drift fades.
        """
        return np.column_stack([self.drift[rate], self.drift_tilt[rate]])


def build_patterns(readings: CellReadings, cycle: Cycle, runs: tuple[int, int]) -> Patterns:
    """Return the possible patterns of traverse shifts in a test with ``runs`` runs per direction
    and the order of approaches ``cycle``.

    In a step cycle all approaches to a target follow each other directly. Such a test has no drift
    from run to run, no random walk and no wave.
    """
    n = readings.runs
    order = np.full((2, n), 2 * n)  # a traverse that was not made stands last
    for row, place in zip(order, traverse_order(*runs), strict=True):
        row[: place.size] = place
    moves = _moves(order, sum(runs) // 2)
    flat = moves.reshape(len(moves), 2 * n, 2, n)
    offset, tilt = np.zeros((2, len(moves), 2 * n, 2, 2, n))
    offset[:, :, :, 0] = flat
    tilt[:, :, :, 1] = flat
    signs = np.repeat([1.0, -1.0], n)
    waves = [wave_effects(order.ravel().astype(float), signs, sum(runs), *wave) for wave in WAVES]
    # By direction, offset before tilt, run.
    parts = np.stack(waves).reshape(-1, 2, 2, n, 2, 2, n).transpose(0, 2, 1, 3, 5, 4, 6)
    rows = tilt.reshape(len(moves), 2 * n, 4 * n)
    turned = np.swapaxes(rows, 1, 2) @ rows
    drift, drift_tilt = _drifts(n, returns=min(runs) > 0)
    return Patterns(
        moves=offset.reshape(rows.shape),
        waves=parts.reshape(-1, 4 * n, 4 * n),
        tilt=np.concatenate([turned, np.repeat(turned[:1], len(WAVES), axis=0)]),
        drift=drift,
        drift_tilt=drift_tilt,
        walks=cycle == "standard" and n > 1,
    )


def _moves(order: FloatArray, middle: int) -> FloatArray:
    """Return the effect of each unit shift on each traverse for three patterns, (3, 2n, 2n): shifts
    of single traverses, shifts of whole runs, and steps of a random walk over the traverses in the
    time ``order`` (2, n), which is zero at ``middle``.
    """
    n = order.shape[1]
    runs = np.zeros((2 * n, 2 * n))
    runs[:n] = np.tile(np.eye(n), 2)
    time = order.ravel() - middle
    step = np.arange(2 * n)[:, np.newaxis] - middle + 0.5  # halfway to the next traverse
    walk = np.where(step > 0.0, time > step, -1.0 * (time < step))
    return np.stack([np.eye(2 * n), runs, walk])


def _drifts(runs: int, *, returns: bool) -> tuple[FloatArray, FloatArray]:
    """Return the effects of a unit drift and a unit tilt drift on the traverses: two arrays (rates,
    4 * ``runs``), with a row for each rate at which the drift fades. ``returns``: each run measures
    both directions.
    """
    way = progress(runs, RATES)
    way = way - way.mean(axis=1, keepdims=True)
    ends = slackening(runs, RATES, np.array([-1.0, 1.0]), returns=returns)
    drift, drift_tilt = np.zeros((2, len(RATES), 2, 2, runs))
    for direction, end in enumerate(ends):
        # A straight line between the ends of the travel: the tilt that slackening adds.
        even, uneven = end.mean(axis=1), 0.5 * (end[:, 1] - end[:, 0])
        drift[:, direction, 0] = even[:, np.newaxis] * way
        drift[:, direction, 1] = uneven[:, np.newaxis] * way
        drift_tilt[:, direction, 1] = even[:, np.newaxis] * way
    return drift.reshape(-1, 4 * runs), drift_tilt.reshape(-1, 4 * runs)
