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
            detail = say("loading.one_direction", direction=direction.value, other=kind)
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
    """Yield hypotheses of a table that is active only up to one of its points, or only from one of
    its points on. The other points have zero, old or constant values.
    """
    points = ways.table.positions
    if points.size < 3:
        return
    held = ways.held()
    beyond: list[tuple[str, Held | None, bool]] = [
        ("nothing", {d: np.zeros(points.size) for d in Direction}, False),
        ("last", None, False),
    ]
    if ways.has_old:
        before = ways.old_values()
        beyond.append(("old", before, False))
        beyond.append(("old_steps", before, True))
    cuts = _cuts(ways)
    for kind, rest, joined in beyond:
        for cut in cuts:
            for first in (True, False):
                inside = (np.arange(points.size) < cut) == first
                edge = cut - 1 if first else cut
                curves = {}
                for d in Direction:
                    last = np.full(points.size, held[d][edge])
                    other = last if rest is None else rest[d]
                    if joined and rest is not None:
                        other = last + rest[d] - rest[d][edge]
                    curves[d] = np.where(inside, held[d], other)
                share = float(np.mean(inside))
                yield from ways.both(
                    "partial",
                    ways.values(curves),
                    _FAMILY / len(cuts),
                    _part(points, edge, kind, first=first),
                    inner=not 0.25 <= share <= 0.75,
                )


def cut_off(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that ends, with its backlash value, between two targets."""
    points, targets = ways.table.positions, ways.targets
    if points.size < 3 or targets.size < 3:
        return
    new = ways.total(ways.own)
    beyond = [("no_backlash", ways.stay - ways.active_before)]
    if ways.has_old:
        beyond.append(("before", ways.old - ways.active_before))
    gaps = np.arange(1, targets.size)
    gaps = gaps[np.unique(np.linspace(0, gaps.size - 1, min(gaps.size, _CUTS)).astype(int))]
    for kind, rest in beyond:
        for gap in gaps:
            last = int(np.clip(np.searchsorted(points, targets[gap - 1]), 0, points.size - 1))
            for first in (True, False):
                inside = (np.arange(targets.size) < gap) == first
                share = float(np.mean(inside))
                yield ways.made(
                    "partial",
                    np.where(inside, new, rest),
                    _FAMILY / gaps.size,
                    _part(points, last, kind, first=first),
                    inner=not 0.25 <= share <= 0.75,
                )


def _part(points: FloatArray, edge: int, beyond: str, *, first: bool) -> Sentence:
    """Return the text about a table that is active only in part: with ``first`` at the points up to
    the index ``edge``, else from the index ``edge`` on. ``beyond``: the kind of values at the other
    points, such as ``old``.
    """
    return say("loading.part", first=first, number=edge + 1, position=points[edge], beyond=beyond)


def _cuts(ways: HypothesisBuilder) -> list[int]:
    """Return the indices of the table points at which a partial table may end: at most `_CUTS`, but
    one for each group of targets beyond it, also where the end is around a target.
    """
    points = ways.table.positions
    above = np.searchsorted(ways.targets, points)
    up_to = np.searchsorted(ways.targets, points, side="right")
    effective = [
        cut
        for cut in range(1, points.size)
        if above[cut] > 0 and above[cut - 1] < ways.targets.size
    ]
    if len(effective) <= _CUTS:
        return effective
    distinct = {(up_to[cut - 1], above[cut]): cut for cut in effective}.values()
    more = np.linspace(0, len(effective) - 1, max(_CUTS - len(distinct), 2)).astype(int)
    return sorted({*distinct, *(effective[i] for i in more)})
