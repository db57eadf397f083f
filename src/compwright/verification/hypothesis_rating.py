"""The probability of each hypothesis about how the table was loaded, given a test after loading.

All unknowns are integrated and none is fitted (Kass and Raftery, J. Am. Stat. Assoc. 90, 1995).
Therefore a hypothesis with more adjustable values has no advantage.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.verification import LoadingName
from compwright.verification.hypothesis import Hypothesis
from compwright.verification.likelihood import AfterMeans, Curves, Fits, fits_of
from compwright.verification.measurement_cases import MeasurementCase

#: Standard deviation of a slope of any size, mm/mm: 3 K of steel.
ANY_SLOPE: Final = 35e-6
#: Prior odds of all faults of loading on an axis that is longer or shorter now, two faults at once,
#: against a loaded table, and of a loaded table on one. Shared among them: a slope takes away what
#: a curve has of its own, and among hundreds of curves one always fits by chance.
_SLOPED: Final = 0.002
THERMAL: Final = 0.2
#: Distance from the loaded table and the old control, in standard errors, from which a fault counts
#: in full.
_SEEN: Final = 3.0


@dataclass(frozen=True, slots=True)
class RatedHypothesis:
    """A hypothesis with its probability, given a test after loading.

    ``expected`` (2, m): the best-fitting test without noise; ``bare`` (2, m): without the fitted
    slope and amount. ``score``: the size of the residual as a standard normal value. ``slope`` and
    ``amount``: the fitted slope and amount, each with its standard error.
    """

    hypothesis: Hypothesis
    name: LoadingName
    expected: FloatArray
    probability: float
    log: float
    score: float
    slope: tuple[float, float]
    amount: tuple[float, float]
    bare: FloatArray


def rate_hypotheses(
    after: AfterMeans, views: Sequence[MeasurementCase], slope: float | None
) -> tuple[list[RatedHypothesis], tuple[float, float]]:
    """Return the hypotheses of all ``views`` with their probabilities, and the fraction of the
    planned change of the correction that the test shows. ``slope``: the standard deviation (mm/mm)
    of a slope by temperature, None if there cannot be one.

    The fraction is 1 for a loaded table and 0 for one that is not active. It comes with its
    standard error (inf if the test cannot show it).
    """
    found: list[RatedHypothesis] = []
    effect = (0.0, math.inf)
    for view in views:
        ways = view.hypotheses
        part = _effect(view.hypotheses)
        measured = ways if part is None else [*ways, part]
        sloped = slope is not None and all(each.name != "measurement" for each in ways)
        more = (0.0, ANY_SLOPE) if sloped else (0.0,)
        fits = fits_of(after, view.belief, _curves_of(measured), slope or 0.0, more)
        if part is not None and fits.amount[len(ways), 1] > 0.0:
            effect = (float(fits.amount[len(ways), 0]), float(fits.amount[len(ways), 1]))
        rows = [(index, way) for index, way in enumerate(ways)]
        if sloped:
            share = _SLOPED / max(1.0, sum(each.weight for each in ways if each.name != "loaded"))
            rows += [
                (len(measured) + index, _on_slope(way, share)) for index, way in enumerate(ways)
            ]
        found += [_rated_by(after, view, fits, index, way) for index, way in rows]
    found = _relevant(after, found)
    logs = np.array([each.log for each in found])
    shares = np.exp(logs - logs.max())
    shares = shares / shares.sum()
    return [
        replace(each, probability=float(share)) for each, share in zip(found, shares, strict=True)
    ], effect


def _rated_by(
    after: AfterMeans, view: MeasurementCase, fits: Fits, index: int, way: Hypothesis
) -> RatedHypothesis:
    """Return the hypothesis ``way`` together with its likelihood and with the test that the
    hypothesis predicts. ``index``: the row of the hypothesis in ``fits``.

    The probability in the result is 0; it is set when all hypotheses are rated.
    """
    expected = bare = view.belief.mean + way.change
    amount = float(fits.amount[index, 0]) if way.free is not None else 0.0
    if way.free is not None:
        expected = expected + amount * way.free
    if way.sloped:
        along = after.targets - after.targets.mean()
        expected = expected + fits.slope[index, 0] * along
    return RatedHypothesis(
        hypothesis=way,
        name="thermal" if way.sloped and way.name == "loaded" else way.name,
        expected=expected,
        probability=0.0,
        log=math.log(way.weight) + float(fits.log_likelihood[index]),
        score=float(fits.score[index]),
        slope=(float(fits.slope[index, 0]), float(fits.slope[index, 1])),
        amount=(amount, float(fits.amount[index, 1])),
        bare=bare,
    )


def _relevant(after: AfterMeans, rated: Sequence[RatedHypothesis]) -> list[RatedHypothesis]:
    """Return the hypotheses with their weights; those that this test cannot distinguish from
    ``loaded`` or ``not_active`` get a smaller weight.

    The weight is reduced by the square of the distance, up to `_SEEN` standard errors. Such
    hypotheses would not change what the test shows.
    """
    ends = [
        next((each for each in rated if each.name == name), None)
        for name in ("loaded", "not_active")
    ]
    off = np.full(len(rated), math.inf)
    for end in ends:
        if end is not None:
            off = np.minimum(off, distances(after, end, rated))
    counts = np.log(np.clip((off / _SEEN) ** 2, 1e-6, 1.0))
    return [
        each
        if each.name in ("loaded", "thermal", "not_active") or each.hypothesis.free is not None
        else replace(each, log=each.log + float(less))
        for each, less in zip(rated, counts, strict=True)
    ]


def _effect(ways: Sequence[Hypothesis]) -> Hypothesis | None:
    """Return the hypothesis that an unknown fraction of the planned change is active; None if
    ``loaded`` or ``not_active`` is not among the hypotheses.
    """
    loaded = next((each for each in ways if each.name == "loaded"), None)
    inactive = next((each for each in ways if each.name == "not_active"), None)
    if loaded is None or inactive is None:
        return None
    return replace(inactive, free=loaded.change - inactive.change, slack=0.0)


def _on_slope(way: Hypothesis, share: float) -> Hypothesis:
    """Return the hypothesis ``way`` together with a changed length of the axis, which adds a slope.
    ``share``: how probable a fault with the slope is beforehand, relative to the fault without it.
    """
    odds = THERMAL if way.name == "loaded" else share
    return replace(way, sloped=True, weight=odds * way.weight)


def _curves_of(ways: Sequence[Hypothesis]) -> Curves:
    """Return the changes of the correction under the hypotheses, as the input of `fits_of`."""
    return Curves(
        change=np.stack([each.change for each in ways], axis=2),
        free={number: each.free for number, each in enumerate(ways) if each.free is not None},
        slack=np.array([each.slack for each in ways]),
    )


def distances(
    after: AfterMeans, best: RatedHypothesis, rated: Sequence[RatedHypothesis]
) -> FloatArray:
    """Return, for each of the H ``rated`` hypotheses, how far (in standard errors) the test that
    the hypothesis predicts is from the test that the ``best`` hypothesis predicts.
    """
    used = np.isfinite(after.plain)
    along = np.broadcast_to(after.targets - after.targets.mean(), after.plain.shape)

    def flat(values: FloatArray) -> FloatArray:
        kept = np.ascontiguousarray(values[..., used])
        centred: FloatArray = kept - kept.mean(axis=-1, keepdims=True) if after.datum else kept
        return centred

    goal, slope = flat(best.expected), flat(along)
    bare = np.array([each.bare for each in rated]).reshape(len(rated), *along.shape)
    off = []
    for each, curve in zip(rated, flat(bare), strict=True):
        way, left = each.hypothesis, goal - curve
        if way.free is not None:
            columns = [flat(way.free), *([slope] if way.sloped else [])]
            matrix = np.column_stack(columns)
            left = left - matrix @ np.linalg.lstsq(matrix, left, rcond=None)[0]
        elif way.sloped:
            left = left - slope * (float(slope @ left) / float(slope @ slope))
        off.append(float(np.linalg.norm(left)))
    return np.array(off) / after.std_error
