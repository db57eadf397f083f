"""The noise of a positioning test, which adds to the error of the axis."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import FloatArray

#: Parts of the noise that `without` takes away.
NoisePart = Literal["scatter", "tails", "growth", "traverses", "drift"]

#: How offset and tilt of the traverses hang together: each drawn on its own; both traverses of a
#: run alike (a new set-up between runs); a random walk from traverse to traverse in time; or a
#: wave in time, smooth within a traverse too (the air of the hall), which tilts it as well.
INDEPENDENT, RUNS, WALK, WAVE = range(4)

BoolArray = NDArray[np.bool_]
IndexArray = NDArray[np.intp]


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseDraws:
    """Equally probable random draws of the noise of one test, mm or deg.

    A reading at x in run j and direction d, with u = (x - ``centre``) / ``half``, differs from the
    error of the axis by

        offset_jd + tilt_jd u + (drift + drift_tilt u) (p_j - mean p) q_d(u) + s(u) e

    - ``sigma`` (count, 2): the scatter for approaches in + and -: log s(u) = log sigma + `waves`
      times ``growth`` (count, w).
    - e is standard normal, or follows Student's law with ``dof`` degrees of freedom (inf: normal).
      ``core``: its standard deviation where the axis comes to rest at few places. ``reach``: root
      mean square of e within the central 99 % of its law.
    - ``outlier_share``: the share of all readings that are outliers. An outlier has the scale
      ``outlier_size`` instead of 1. With ``outlier_fixed`` it is displaced by ``outlier_size`` to
      either side in addition; if the axis comes to rest at few places, most readings are displaced
      like this.
    - ``offset``, ``tilt``: standard deviations of offset_jd and tilt_jd, which are drawn anew for
      every test. ``pattern``: how they follow each other (`INDEPENDENT`, `RUNS`, `WALK`, `WAVE`).
      For `WALK` they are those of one step. For `WAVE` ``offset`` is that of the wave, whose
      correlation time is ``pace`` of the test, with ``cycles`` oscillations per test, and ``tilt``
      is added for each traverse. ``moved``: the share of the offsets (steps) that are not zero.
    - ``drift``, ``drift_tilt``: the drift that the test showed from its first run to its last. p is
      from `progress` with ``drift_rate``, and q from `slackening`. The drift within a run
      (`within_run`) is the same in every run and part of the error curve.
    - ``farthest``: the largest distance of a reading from the others of its target, mm or deg.
    """

    centre: float
    half: float
    sigma: FloatArray
    growth: FloatArray
    dof: FloatArray
    outlier_share: FloatArray
    outlier_size: FloatArray
    outlier_fixed: BoolArray
    core: FloatArray
    reach: FloatArray
    pattern: IndexArray
    pace: FloatArray
    cycles: FloatArray
    moved: FloatArray
    offset: FloatArray
    tilt: FloatArray
    drift: FloatArray
    drift_tilt: FloatArray
    drift_rate: FloatArray
    farthest: float = math.inf

    @property
    def count(self) -> int:
        """The number of random draws."""
        return len(self.sigma)

    def taken(self, index: IndexArray | slice) -> NoiseDraws:
        """Return the draws with the indices ``index``; a slice gives views of the arrays."""
        return replace(self, **{name: getattr(self, name)[index] for name in _ARRAYS})

    def outlier_size_at(self, scale: FloatArray, way: int) -> FloatArray:
        """Return the size of outliers (count, m) in approaches towards + (``way`` 0) or − (1), in
        multiples of ``scale`` (count, m), the scatter of the readings.

        What disturbs a reading does not grow with the scatter along the travel. Therefore an
        outlier is no larger than where the scatter is least, and no larger than the farthest
        reading of the test.
        """
        ends = np.linspace(self.centre - self.half, self.centre + self.half, _PLACES)
        least = np.min(self.scale_at(ends)[:, way], axis=1)
        largest = np.maximum(self.outlier_size * least, self.farthest)[:, np.newaxis]
        size = np.broadcast_to(self.outlier_size[:, np.newaxis], scale.shape)
        allowed = np.maximum(largest / np.maximum(scale, _TINY), np.minimum(size, 1.0))
        return np.where(size * scale > largest, allowed, size)

    def scale_at(self, positions: FloatArray) -> FloatArray:
        """Return the scale (count, 2, k) of a reading's noise at ``positions`` (k,), in + and -."""
        u = (positions - self.centre) / self.half
        logs = self.growth @ waves(u, self.growth.shape[1])
        scale: FloatArray = self.sigma[:, :, np.newaxis] * np.exp(logs)[:, np.newaxis]
        return scale


#: Below every scale of a reading: where there is no scatter, nothing is divided by it.
_TINY: Final = 1e-300
#: Places along the travel at which the least scatter is looked for.
_PLACES: Final = 9
#: Times within a traverse at which a wave is looked at.
_WITHIN: Final = 4

_ARRAYS: Final = tuple(
    field.name for field in fields(NoiseDraws) if field.name not in ("centre", "half", "farthest")
)


def normal_noise(sigma: FloatArray, centre: float = 0.0, half: float = 1.0) -> NoiseDraws:
    """Return draws of normal noise: its standard deviation ``sigma`` (count,) is the same over the
    whole travel. ``centre``, ``half``: the centre and half the length of the travel.
    """
    nothing = np.zeros(sigma.shape)
    return NoiseDraws(
        centre=centre,
        half=half,
        sigma=np.column_stack([sigma, sigma]),
        growth=np.zeros((*sigma.shape, 0)),
        dof=np.full(sigma.shape, np.inf),
        outlier_share=nothing,
        outlier_size=np.ones(sigma.shape),
        outlier_fixed=np.zeros(sigma.shape, dtype=np.bool_),
        core=np.ones(sigma.shape),
        reach=np.ones(sigma.shape),
        pattern=np.zeros(sigma.shape, dtype=np.intp),
        pace=np.ones(sigma.shape),
        cycles=nothing,
        moved=np.ones(sigma.shape),
        offset=nothing,
        tilt=nothing,
        drift=nothing,
        drift_tilt=nothing,
        drift_rate=nothing,
    )


def without(draws: NoiseDraws, *parts: NoisePart) -> NoiseDraws:
    """Return the noise without the named ``parts``, such as outliers or drift.

    ``scatter``: the scatter of the readings about their traverses. ``tails``: outliers and heavy
    tails; the scale of the scatter stays. ``growth``: the change of the scatter along the travel.
    ``traverses``: the offsets and tilts of the traverses. ``drift``: the drift and its tilt.
    """
    nothing = np.zeros(draws.count)
    changes: dict[NoisePart, dict[str, Any]] = {
        "scatter": {"sigma": np.zeros_like(draws.sigma)},
        "tails": {
            "dof": np.full(draws.count, np.inf),
            "outlier_share": np.where(draws.core < 1.0, draws.outlier_share, 0.0),
        },
        "growth": {"growth": np.zeros_like(draws.growth)},
        "traverses": {"offset": nothing, "tilt": nothing},
        "drift": {"drift": nothing, "drift_tilt": nothing},
    }
    together = {name: value for part in parts for name, value in changes[part].items()}
    return replace(draws, **together)


def waves(u: FloatArray, count: int) -> FloatArray:
    """Return ``count`` cosine half waves along the travel, at ``u`` (k,) from -1 to 1.

    Wave w = 1 to ``count`` is cos(w pi (u + 1) / 2). It is constant beyond the ends.
    """
    way = 0.5 * np.pi * (np.clip(u, -1.0, 1.0) + 1.0)
    shapes: FloatArray = np.cos(np.outer(np.arange(1, count + 1), way))
    return shapes


def traverse_order(positive: int, negative: int) -> tuple[IndexArray, IndexArray]:
    """Return, for the + traverses and for the − traverses, their indices in the time order of a
    test that begins with + and alternates. ``positive``, ``negative``: their numbers.
    """
    paired = min(positive, negative)
    plus, minus = np.arange(positive), np.arange(negative)
    return (
        np.where(plus < paired, 2 * plus, plus + paired),
        np.where(minus < paired, 2 * minus + 1, minus + paired),
    )


def wave_effects(
    order: FloatArray, signs: FloatArray, count: int, pace: float, cycles: float = 0.0
) -> FloatArray:
    """Return the covariance of the offsets and tilts that a slow disturbance causes in k of the
    ``count`` traverses of a test: in those at the places ``order`` (k,) of time, with the
    directions ``signs`` (k,).

    Places count from 0; directions are 1 or -1. The disturbance is a wave of unit standard
    deviation. Its correlation time ``pace`` is a part of the duration of the test, in which it has
    ``cycles`` oscillations. The result has the shape (2, k, 2, k), offsets before tilts.

    The covariance of the wave is (1 + a) exp(-a) cos(2 π cycles t), a = √3 t / pace (Rasmussen and
    Williams, Gaussian Processes for Machine Learning, 2006, equation 4.17). Without ``cycles`` it
    is that of a body with a time constant in air whose temperature is a first-order process with
    the same time constant. With them, amplitude and phase of an oscillation change slowly (Wilson
    and Adams, Gaussian process kernels for pattern discovery and extrapolation, 2013). Offset and
    tilt are the first two Legendre coefficients of the wave over the time of a traverse.
    """
    places, weights = np.polynomial.legendre.leggauss(_WITHIN)
    half = 0.5 / count
    times = ((order + 0.5) / count)[:, np.newaxis] + half * np.outer(signs, places)
    between = np.abs(np.subtract.outer(times, times))
    apart = np.sqrt(3.0) / pace * between
    shapes = np.stack([0.5 * weights, 1.5 * weights * places])
    covariance = (1.0 + apart) * np.exp(-apart) * np.cos(2.0 * np.pi * cycles * between)
    found: FloatArray = np.einsum("ap,ipjq,bq->aibj", shapes, covariance, shapes)
    return found


def progress(runs: int, rate: FloatArray) -> FloatArray:
    """Return the fraction (0 to 1) of the whole drift that has happened when each of the ``runs``
    runs starts. ``rate``: how much the drift slows down (0: not at all).

    p_j = (1 - exp(-rate j / (runs - 1))) / (1 - exp(-rate)), and for ``rate`` 0 p_j = j / (runs -
    1). Above 0 this is a first-order approach to a steady state, as a body warms up (Newton's law
    of cooling).
    """
    way = np.linspace(0.0, 1.0, runs) if runs > 1 else np.zeros(runs)
    steep = np.maximum(rate, 1e-9)[..., np.newaxis]
    curve: FloatArray = np.expm1(-steep * way) / np.expm1(-steep)
    return curve


def slackening(
    runs: int, rate: FloatArray, u: FloatArray, *, returns: bool
) -> tuple[FloatArray, FloatArray]:
    """Return, for + and −, the factor of the drift between successive runs at the position ``u``,
    relative to that at the start of the runs. ``rate``: as in `progress`; ``returns``: both
    directions are measured.

    ``u`` (k,) is -1 to 1. A run goes up through the targets and, if it ``returns``, down again in
    the second half of its time. The factor is exp(-rate t), where t is the time of the reading at
    ``u`` since the start of its run, in parts of the test.
    """
    per_run = rate[:, np.newaxis] / max(runs - 1, 1)
    up, down = _parts_of_run(u, returns=returns)
    return np.exp(-per_run * up), np.exp(-per_run * down)


def within_run(
    runs: int, rate: FloatArray, u: FloatArray, *, returns: bool
) -> tuple[FloatArray, FloatArray]:
    """Return, for + and −, the fraction of the whole drift that happens between a run's first
    reading and its reading at ``u`` (k,). ``rate``: as in `progress`; ``returns``: both directions
    are measured.

    ``u`` is -1 to 1. The fraction is the mean over the runs of p(t + h) - p(t), p as in `progress`
    and h as in `slackening`. For a test of one run it is 0, because such a test does not show it.
    """
    if runs < 2:
        nothing = np.zeros((rate.size, u.size))
        return nothing, nothing
    steep = np.maximum(rate, 1e-9)[:, np.newaxis]
    begun = np.mean(np.exp(-steep * np.linspace(0.0, 1.0, runs)), axis=1, keepdims=True)
    up, down = (
        begun * np.expm1(-steep * part / (runs - 1)) / np.expm1(-steep)
        for part in _parts_of_run(u, returns=returns)
    )
    return up, down


def _parts_of_run(u: FloatArray, *, returns: bool) -> tuple[FloatArray, FloatArray]:
    """Return, for + and −, the fraction of a run's time after which the axis is at the positions
    ``u`` (k,). ``returns``: both directions are measured, − in the second half of the time.
    """
    half = 0.5 if returns else 1.0
    return half * 0.5 * (u + 1.0), half * 0.5 * (1.0 - u) + (0.5 if returns else 0.0)
