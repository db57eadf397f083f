"""Hypotheses that part of the table is faulty: only one direction, a wrong backlash value, or only
some of the points.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.records.axis import Direction
from compwright.verification.hypothesis import COMMON, RARE, Hypothesis
from compwright.verification.hypothesis_builder import Curve, Held, HypothesisBuilder

#: Most places at which a table may be cut.
_CUTS: Final = 120
_FAMILY: Final = 0.025  # prior odds of a whole family of cuts of one kind


def one_direction(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that is active in only one direction. The other has the old
    correction, none, or the new backlash value alone.
    """
    new = ways.total(ways.own)
    beyond = [("the other as before", ways.old - ways.active_before)]
    if ways.has_old:
        beyond.append(("nothing in the other", ways.stay - ways.active_before))
    if np.any(ways.backlash != ways.old_backlash):
        beyond.append(("in the other the new backlash alone", ways.total(np.zeros_like(ways.own))))
    for side, direction in enumerate(Direction):
        for rest_detail, other in beyond:
            change = other.copy()
            change[side] = new[side]
            detail = f"it is active in approaches in {direction.value} only, {rest_detail}"
            yield ways.made("one_direction", change, 0.5 * COMMON, detail)


def wrong_backlash(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a wrong backlash value, such as none, the old one, or twice the new."""
    step = ways.backlash
    if not np.any(step):
        step = _reversal(ways)
    weight = COMMON if np.any(ways.backlash) else RARE
    for times, detail in ((-1.0, "missing"), (1.0, "twice"), (-2.0, "with the wrong sign")):
        if np.any(step):
            change = ways.total(ways.own, ways.backlash + times * step)
            yield ways.made("backlash", change, weight, detail)
    known = [-step, step, -2.0 * step, np.zeros_like(step)]
    for value, detail in (
        (ways.old_backlash, "the old value instead of the new one"),
        (ways.backlash + ways.old_backlash, "the old value on top of the new one"),
    ):
        if not any(np.allclose(value - ways.backlash, one, atol=1e-9) for one in known):
            yield ways.made("backlash", ways.total(ways.own, value), COMMON, detail)


def _reversal(ways: HypothesisBuilder) -> Curve:
    """Return the mean difference between the tables for + and −, as a backlash value."""
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
    """Yield hypotheses of a table that is active only up to a point or only from a point on. The
    other points have further values, such as zero or the old values.
    """
    nodes = ways.table.positions
    if nodes.size < 3:
        return
    held = ways.held()
    beyond: list[tuple[str, Held | None, bool]] = [
        ("nothing beyond", {d: np.zeros(nodes.size) for d in Direction}, False),
        ("the last value beyond", None, False),
    ]
    if ways.has_old:
        before = ways.old_values()
        beyond.append(("the old values beyond", before, False))
        beyond.append(("the old steps beyond", before, True))
    cuts = _cuts(ways)
    for rest_detail, rest, joined in beyond:
        for cut in cuts:
            for first in (True, False):
                inside = (np.arange(nodes.size) < cut) == first
                edge = cut - 1 if first else cut
                curves = {}
                for d in Direction:
                    last = np.full(nodes.size, held[d][edge])
                    other = last if rest is None else rest[d]
                    if joined and rest is not None:
                        other = last + rest[d] - rest[d][edge]
                    curves[d] = np.where(inside, held[d], other)
                number = f"up to node {cut}" if first else f"from node {cut + 1} on"
                where = f"{number} ({nodes[edge]:g})"
                share = float(np.mean(inside))
                yield from ways.both(
                    "partial",
                    ways.values(curves),
                    _FAMILY / len(cuts),
                    f"{where}, {rest_detail}",
                    inner=not 0.25 <= share <= 0.75,
                )


def cut_off(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that ends, with its backlash value, between two targets."""
    nodes, targets = ways.table.positions, ways.targets
    if nodes.size < 3 or targets.size < 3:
        return
    new = ways.total(ways.own)
    beyond = [("nothing beyond, no backlash either", ways.stay - ways.active_before)]
    if ways.has_old:
        beyond.append(("all as before beyond", ways.old - ways.active_before))
    gaps = np.arange(1, targets.size)
    gaps = gaps[np.unique(np.linspace(0, gaps.size - 1, min(gaps.size, _CUTS)).astype(int))]
    for rest_detail, rest in beyond:
        for gap in gaps:
            last = int(np.clip(np.searchsorted(nodes, targets[gap - 1]), 0, nodes.size - 1))
            for first in (True, False):
                inside = (np.arange(targets.size) < gap) == first
                number = f"up to node {last + 1}" if first else f"from node {last + 1} on"
                share = float(np.mean(inside))
                yield ways.made(
                    "partial",
                    np.where(inside, new, rest),
                    _FAMILY / gaps.size,
                    f"{number} ({nodes[last]:g}), {rest_detail}",
                    inner=not 0.25 <= share <= 0.75,
                )


def _cuts(ways: HypothesisBuilder) -> list[int]:
    """Return the indices of at most `_CUTS` table points at which a partial table may end."""
    nodes = ways.table.positions
    target_index = np.searchsorted(ways.targets, nodes)
    effective = [
        cut
        for cut in range(1, nodes.size)
        if target_index[cut] > 0 and target_index[cut - 1] < ways.targets.size
    ]
    if len(effective) <= _CUTS:
        return effective
    return [effective[i] for i in np.unique(np.linspace(0, len(effective) - 1, _CUTS).astype(int))]
