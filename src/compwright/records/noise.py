"""What a positioning test adds to the error of the axis: numbers of the noise, and the order in
which a cycle takes its readings.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import FloatArray
from compwright.records.positioning import Cycle

#: Parts of the noise that `without` takes away.
NoisePart = Literal["scatter", "tails", "growth", "traverses", "drift"]

BoolArray = NDArray[np.bool_]
IndexArray = NDArray[np.intp]


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseDraws:
    """Equally likely draws of the noise of one test, mm or deg; each (count,) where nothing else is
    said.

    A reading at x in traverse v, taken at the time tau (-1/2 the first, 1/2 the last:
    `cycle_times`), with u = (x - ``centre``) / ``half``, differs from the error of the axis by

        offset_v + tilt_v u + (drift + drift_tilt u) tau + sigma exp(growth u) e

    ``sigma`` (count, 2), for approaches in + and -: the scale of e, which follows Student's law
    with ``dof`` degrees of freedom (inf: normal); of a share ``outlier_share`` of all readings the
    scale is ``outlier_size`` times as large. ``offset`` and ``tilt``: standard deviations of
    offset_v and tilt_v, drawn afresh for every traverse; where ``walk``, those of the step from
    one traverse to the next. ``drift`` and ``drift_tilt``: what a test of this protocol shows
    again, from the first reading to the last.
    """

    centre: float
    half: float
    sigma: FloatArray
    growth: FloatArray
    dof: FloatArray
    outlier_share: FloatArray
    outlier_size: FloatArray
    offset: FloatArray
    tilt: FloatArray
    walk: BoolArray
    drift: FloatArray
    drift_tilt: FloatArray

    @property
    def count(self) -> int:
        """Number of draws."""
        return len(self.sigma)

    def taken(self, index: IndexArray) -> NoiseDraws:
        """Return the draws at ``index`` (n,)."""
        return replace(
            self,
            **{name: getattr(self, name)[index] for name in _ARRAYS},
        )


_ARRAYS: Final = (
    "sigma",
    "growth",
    "dof",
    "outlier_share",
    "outlier_size",
    "offset",
    "tilt",
    "walk",
    "drift",
    "drift_tilt",
)


def normal_noise(sigma: FloatArray, centre: float = 0.0, half: float = 1.0) -> NoiseDraws:
    """Return independent normal noise of standard deviation ``sigma`` (count,), mm or deg, the same
    in both directions and everywhere.
    """
    nothing = np.zeros(sigma.shape)
    return NoiseDraws(
        centre=centre,
        half=half,
        sigma=np.column_stack([sigma, sigma]),
        growth=nothing,
        dof=np.full(sigma.shape, np.inf),
        outlier_share=nothing,
        outlier_size=np.ones(sigma.shape),
        offset=nothing,
        tilt=nothing,
        walk=np.zeros(sigma.shape, dtype=np.bool_),
        drift=nothing,
        drift_tilt=nothing,
    )


def without(draws: NoiseDraws, *parts: NoisePart) -> NoiseDraws:
    """Return the noise without some of its parts: what the axis would show if these were cured.

    ``scatter``: the readings about their traverses; ``tails``: outliers, and the heavy tails, at
    the same scale; ``growth``: of the scatter along the travel; ``traverses``: their offsets and
    tilts; ``drift``: both of its parts.
    """
    nothing = np.zeros(draws.count)
    changes: dict[NoisePart, dict[str, Any]] = {
        "scatter": {"sigma": np.zeros_like(draws.sigma)},
        "tails": {"dof": np.full(draws.count, np.inf), "outlier_share": nothing},
        "growth": {"growth": nothing},
        "traverses": {"offset": nothing, "tilt": nothing},
        "drift": {"drift": nothing, "drift_tilt": nothing},
    }
    together = {name: value for part in parts for name, value in changes[part].items()}
    return replace(draws, **together)


def traverse_order(positive: int, negative: int) -> tuple[IndexArray, IndexArray]:
    """Return the place in time (from 0) of each traverse: ``positive`` and ``negative`` of them, in
    turn, beginning with + (ISO 230-2, standard test cycle).
    """
    paired = min(positive, negative)
    plus, minus = np.arange(positive), np.arange(negative)
    return (
        np.where(plus < paired, 2 * plus, plus + paired),
        np.where(minus < paired, 2 * minus + 1, minus + paired),
    )


def cycle_times(
    targets: int, positive: int, negative: int, cycle: Cycle
) -> tuple[FloatArray, FloatArray]:
    """Return the times of the readings (targets, positive) and (targets, negative), from -1/2 for
    the first to 1/2 for the last, taken one by one at an even pace.

    Standard cycle: traverse by traverse, the targets upwards in +, downwards in -. Step cycle: all
    approaches to one target, + and - in turn, before the next
    (ISO 230-2:1997, figure 1 and annex A).
    """
    plus, minus = traverse_order(positive, negative)
    place = np.arange(targets)[:, np.newaxis]
    if cycle == "step":
        steps = [place * (positive + negative) + order for order in (plus, minus)]
    else:
        steps = [plus * targets + place, minus * targets + (targets - 1 - place)]
    last = max(targets * (positive + negative) - 1, 1)
    first, second = (step / last - 0.5 for step in steps)
    return first, second
