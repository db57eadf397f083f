"""Hypotheses that the whole table is faulty: not active, wrong sign, factor, position or axis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.verification.hypothesis import COMMON, RARE, UNKNOWN_FACTOR, Hypothesis
from compwright.verification.hypothesis_builder import Curve, HypothesisBuilder
from compwright.words.sentences import Sentence, say

#: Factors with a known cause (sentence ``loading.factor``), and the relative probability of each.
_FACTORS: Final[Mapping[float, float]] = {
    2.0: 1.0,
    0.5: 1.0,
    10.0: 1.0,
    0.1: 1.0,
    25.4: 0.5,
    1.0 / 25.4: 0.02,
    1000.0: 0.5,
    0.001: 0.02,
}
#: Most points by which a table may be shifted.
_MOST_SHIFT: Final = 5
#: Of each way in which another axis's table may act: tables of axes that are alike are no fault
#: that anybody would notice.
_OTHER: Final = 0.01


def _apart(detail: Sentence | None = None) -> Sentence:
    return say("loading.variant", detail=detail, backlash="apart")


def inactive(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table that is not active: the old correction, none, or only the new
    backlash value.
    """
    kept, nothing = ways.old - ways.active_before, ways.stay - ways.active_before
    cases: list[tuple[Curve, str]] = [(kept, "")]
    if ways.has_old:
        cases = [(kept, "still"), (nothing, "nothing")]
        if np.abs(kept).max() > np.abs(nothing).max():  # idle in the tests before: as then first
            cases = [cases[1], (kept, "before")]
    for change, kind in cases:
        detail = say("loading.instead", active=kind) if kind else None
        yield ways.made("not_active", change, COMMON, detail)
    alone = say("loading.instead", active="backlash")
    if np.any(ways.backlash != ways.old_backlash):
        other = ways.old - ways.old_backlash + ways.backlash - ways.active_before
        yield ways.made("not_active", other, RARE, alone)
    if np.any(ways.backlash) and ways.has_old:
        yield ways.made("not_active", ways.total(np.zeros_like(ways.own)), RARE, alone)


def with_existing(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses about the existing table: only the change was loaded, the total was added to
    it, or it was not active in the earlier tests.
    """
    if not ways.has_old:
        return
    existing = ways.old - ways.stay - ways.old_backlash
    jump = ways.old_backlash
    backlashes: list[tuple[Curve, Curve, Sentence | None]] = [
        (ways.backlash - jump, ways.backlash + jump, None)
    ]
    if np.any(jump):
        backlashes.append((ways.backlash, ways.backlash, _apart()))
    for less, more, detail in backlashes:
        yield ways.made("increment", ways.total(ways.own - existing, less), COMMON, detail)
        yield ways.made("on_top", ways.total(ways.own + existing, more), COMMON, detail)
    believed = ways.at(ways.loading.active_before) - ways.stay
    if np.any(np.abs(believed) > 0.0):
        # the same test as on top of it, which happens more often
        yield ways.made("state", ways.total(ways.own) + believed, RARE)


def inverted(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield the hypothesis of a table with the opposite sign, and a second one in which only the
    table, not the backlash value, has the opposite sign.
    """
    yield ways.made("inverted", ways.total(-ways.own, -ways.backlash), COMMON)
    if np.any(ways.backlash):
        yield ways.made("inverted", ways.total(-ways.own), COMMON, _apart())


def scaled(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table multiplied by a wrong factor: each typical factor (such as one
    from a wrong unit), and an unknown factor.
    """
    for factor, share in _FACTORS.items():
        words = say("loading.factor", factor=f"{factor:.4g}")
        weight = COMMON * share
        curve = factor * ways.own
        more: dict[str, Any] = {"factor": factor, "inner": factor < 0.05}
        yield ways.made("scaled", ways.total(curve, factor * ways.backlash), weight, words, **more)
        if np.any(ways.backlash):
            yield ways.made("scaled", ways.total(curve), weight, _apart(words), **more)
    free: dict[str, Any] = {"inner": True}
    along = UNKNOWN_FACTOR * (ways.own + ways.backlash)
    yield ways.made("scaled", ways.total(ways.own), RARE, free=along, **free)
    if np.any(ways.backlash):
        yield ways.made(
            "scaled", ways.total(ways.own), RARE, free=UNKNOWN_FACTOR * ways.own, **free
        )


def shifted(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table shifted by whole points towards + or −."""
    points, held = ways.table.positions.size, ways.held()
    for k in range(1, min(_MOST_SHIFT, points - 2) + 1):
        for by in (k, -k):
            for curves in ways.shifts(by, held):
                yield from ways.moved("shifted", curves, COMMON / (1 + k), shift_nodes=by)


def mirrored(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table with its values, or its increments, in reverse order."""
    if ways.table.positions.size > 2:
        held = ways.held()
        curves = {d: values[::-1] for d, values in held.items()}
        yield from ways.moved("mirrored", curves, COMMON)
        # mirrored about a centre one point further: of a table with one point outside the travel
        shifted = [other for by in (1, -1) for other in ways.shifts(by, held)]
        for each in shifted:
            turned = {d: v[::-1] for d, v in each.items()}
            yield from ways.moved("mirrored", turned, RARE / len(shifted))
        # Where a control keeps the steps from point to point, these are mirrored; one point further
        # where the first or the last of its rows holds a step that is never active.
        steps = {d: v[0] + v[-1] - v[::-1] for d, v in held.items()}
        more: dict[str, Any] = {"detail": say("loading.steps"), "inner": True}
        yield from ways.moved("mirrored", steps, COMMON, **more)
        for by in (1, -1):
            yield from ways.moved("mirrored", next(ways.shifts(by, steps)), RARE, **more)


def wrong_axis(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses that the table of another axis is active: with its values at the same
    positions, or at the same point numbers. The numbers of a table in mm count as deg and the other
    way round.
    """
    for name, other in ways.loading.others.items():
        if not other.positions.size:
            continue
        backlash = ways.jump(other)
        points = ways.table.positions.size
        by_place = ways.at(replace(other, others=(), backlash=0.0))
        curves = [(by_place, "position")]
        # a shorter table ends with nothing, or, where steps are kept, with its last value
        fills = (True, False) if points > other.positions.size else (True,)
        for held in fills if points else ():
            values = {d: _resized(other.curve(d), points, held=held) for d in Direction}
            curves.append((ways.values(values), "number"))
        for curve, kind in curves:
            more = say("loading.other_axis", by=kind)
            yield from ways.both("wrong_axis", curve, _OTHER, more, of=name)
            if np.any(backlash != ways.backlash):
                change = ways.total(curve, backlash)
                yield ways.made("wrong_axis", change, _OTHER, more, of=name)


def _resized(values: FloatArray, size: int, *, held: bool) -> FloatArray:
    """Return ``values`` with the length ``size``: cut off, or extended by the last value (``held``)
    or by zeros.
    """
    resized = np.full(size, values[-1] if held else 0.0)
    count = min(size, values.size)
    resized[:count] = values[:count]
    return resized
