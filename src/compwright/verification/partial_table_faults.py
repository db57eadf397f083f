"""Hypotheses that part of the table is faulty: only one direction, a wrong backlash value, or only
some of the points.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.verification.hypothesis import COMMON, RARE, Hypothesis
from compwright.verification.hypothesis_builder import Curve, Held, HypothesisBuilder
from compwright.words.sentences import Sentence, say

#: Most places at which a table may be cut.
_CUTS: Final = 120
_FAMILY: Final = 0.025  # prior odds of a whole family of cuts of one kind


def one_direction(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that is active in only one direction. The other direction has the
    old correction, no correction, or only the new backlash value.
    """
    new = ways.total(ways.own)
    beyond = [("before", ways.old - ways.active_before)]
    if ways.has_old:
        beyond.append(("nothing", ways.stay - ways.active_before))
    if np.any(ways.backlash != ways.old_backlash):
        beyond.append(("backlash", ways.total(np.zeros_like(ways.own))))
    for side, direction in enumerate(Direction):
        for kind, other in beyond:
            change = other.copy()
            change[side] = new[side]
            axis = ways.loading.axis
            detail = say("loading.one_direction", axis=axis, direction=direction.value, other=kind)
            yield ways.made("one_direction", change, 0.5 * COMMON, detail)


def wrong_backlash(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a wrong backlash value, such as zero, the old value, or twice the new
    value.
    """
    step = ways.backlash
    if not np.any(step):
        step = _reversal(ways)
    weight = COMMON if np.any(ways.backlash) else RARE
    for times, kind in ((-1.0, "missing"), (1.0, "twice"), (-2.0, "sign")):
        if np.any(step):
            change = ways.total(ways.own, ways.backlash + times * step)
            yield ways.made("backlash", change, weight, say("loading.backlash", kind=kind))
    away = list(Direction).index(ways.table.reference_return.opposite)
    if np.ptp(ways.own[away] - ways.own[1 - away]) > 1e-9:  # the whole reversal, not a constant
        both = ways.own.copy()
        both[away] = both[1 - away]
        change = ways.total(both, np.zeros_like(both))
        yield ways.made("backlash", change, RARE, say("loading.backlash", kind="missing"))
    for times, kind in ((-1.0, "missing"), (1.0, "twice"), (-2.0, "sign")):
        if np.any(ways.lost):
            wrong = say("loading.backlash", kind=kind)
            change = ways.total(ways.own + times * ways.lost)
            detail = say("loading.variant", detail=wrong, backlash="table")
            yield ways.made("backlash", change, RARE, detail)
    known = [-step, step, -2.0 * step, np.zeros_like(step)]
    for value, kind in (
        (ways.old_backlash, "old"),
        (ways.backlash + ways.old_backlash, "added"),
    ):
        if not any(np.allclose(value - ways.backlash, one, atol=1e-9) for one in known):
            detail = say("loading.backlash", kind=kind)
            yield ways.made("backlash", ways.total(ways.own, value), COMMON, detail)


def _reversal(ways: HypothesisBuilder) -> Curve:
    """Return the mean difference between the table's values for + and −, as the correction (2, m)
    that a backlash value of this size would make.
    """
    mean = (
        float(np.mean(ways.table.negative - ways.table.positive))
        if ways.table.positions.size
        else 0.0
    )
    away = ways.table.reference_return.opposite
    step = np.zeros_like(ways.own)
    if abs(mean) > 1e-9:
        step[list(Direction).index(away)] = mean if away is Direction.NEGATIVE else -mean
    return step


def partial(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that is active only up to one of its rows, or only from one of
    its rows on. The other rows have zero, old or constant values; steps have no constant ones.
    """
    stored, held = ways.stored, ways.held()
    count = stored.order.size
    if count < 3:
        return
    zeros = dict.fromkeys(Direction, np.zeros(count))
    beyond: list[tuple[str, Held | None]] = [("last" if stored.steps else "nothing", zeros)]
    if not stored.steps:
        beyond.append(("last", None))
    if ways.has_old:
        beyond.append(("old_steps" if stored.steps else "old", ways.old_rows()))
    places, cuts = ways.row_places(), _cuts(ways)
    for kind, rest in beyond:
        for cut, share in cuts.items():
            for first in (True, False):
                inside = (np.arange(count) < cut) == first
                edge = cut - 1 if first else cut
                rows = {
                    d: np.where(inside, held[d], held[d][edge] if rest is None else rest[d])
                    for d in Direction
                }
                yield from ways.both(
                    "partial",
                    ways.values(ways.curves(rows)),
                    _FAMILY / len(cuts),
                    _part(places, edge, kind, first=first),
                    inner=not 0.25 <= share <= 0.75,
                )


def cut_off(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that ends, with its backlash value, between two targets."""
    places, targets = ways.row_places(), ways.targets
    if places.size < 3 or targets.size < 3:
        return
    new = ways.total(ways.own)
    beyond = [("no_backlash", ways.stay - ways.active_before)]
    if ways.has_old:
        beyond.append(("before", ways.old - ways.active_before))
    gaps = np.arange(1, targets.size)
    gaps = gaps[np.unique(np.linspace(0, gaps.size - 1, min(gaps.size, _CUTS)).astype(int))]
    for kind, rest in beyond:
        for gap in gaps:
            last = int(np.argmin(np.where(places < targets[gap - 1], np.inf, places)))
            for first in (True, False):
                inside = (np.arange(targets.size) < gap) == first
                share = float(np.mean(inside))
                yield ways.made(
                    "partial",
                    np.where(inside, new, rest),
                    _FAMILY / gaps.size,
                    _part(places, last, kind, first=first),
                    inner=not 0.25 <= share <= 0.75,
                )


def _part(places: FloatArray, edge: int, beyond: str, *, first: bool) -> Sentence:
    """Return the text about a table that is active only in part: with ``first`` in the rows up to
    the index ``edge``, else from the index ``edge`` on. ``places``: the positions of the rows;
    ``beyond``: the kind of values in the other rows, such as ``old``.
    """
    return say("loading.part", first=first, number=edge + 1, position=places[edge], beyond=beyond)


def _cuts(ways: HypothesisBuilder) -> dict[int, float]:
    """Return the numbers of rows after which a partial table may end, each with the share of the
    targets that need none of the further rows. At most `_CUTS` of them, but one for each group of
    targets beyond it, also where the end is around a target.
    """
    points, where = ways.table.positions, ways.targets
    if ways.table.period is not None:
        where = points[0] + np.mod(where - points[0], ways.table.period)
    row_of = np.zeros(points.size, dtype=int)
    row_of[ways.stored.row_points] = np.arange(ways.stored.order.size)
    above, below = np.searchsorted(points, where), np.searchsorted(points, where, side="right") - 1
    sides = [row_of[np.clip(index, 0, points.size - 1)] for index in (above, below)]
    lowest, highest = np.minimum(*sides), np.maximum(*sides)
    cuts = np.arange(1, ways.stored.order.size)
    cuts = cuts[(cuts > lowest.min()) & (cuts <= highest.max())]
    complete = {int(cut): int(np.sum(highest < cut)) for cut in cuts}
    if cuts.size > _CUTS:
        distinct = {(complete[int(cut)], int(np.sum(lowest < cut))): int(cut) for cut in cuts}
        more = np.linspace(0, cuts.size - 1, max(_CUTS - len(distinct), 2)).astype(int)
        chosen = {*distinct.values(), *(int(cut) for cut in cuts[more])}
        complete = {cut: complete[cut] for cut in sorted(chosen)}
    return {cut: part / where.size for cut, part in complete.items()}
