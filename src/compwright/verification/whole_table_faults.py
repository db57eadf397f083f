"""Hypotheses that the whole table is faulty: not active, wrong sign, factor, position or axis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.verification import LoadingName
from compwright.verification.hypothesis import COMMON, RARE, UNKNOWN_FACTOR, Hypothesis
from compwright.verification.hypothesis_builder import (
    Curve,
    Held,
    HypothesisBuilder,
    distinct,
)
from compwright.words.sentences import Sentence, say

#: Factors with a known cause (sentence ``loading.factor``), and the relative probability of each.
FACTORS: Final[Mapping[float, float]] = {
    2.0: 1.0,
    0.5: 1.0,
    10.0: 1.0,
    0.1: 1.0,
    16.0: 0.5,  # where an entry is 1/16 of a count
    1.0 / 16.0: 0.02,
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


def factor_text(factor: float) -> Sentence:
    """Return the sentence part that states one of the `FACTORS` with its cause."""
    return say("loading.factor", factor=f"{factor:.4g}")


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
    parts = list(zip(ways.parts(), ways.parts(existing=True), strict=True))
    left = [ways.total(ways.own - planned + existing) for planned, existing in parts]
    left += [ways.total(ways.own - planned) for planned, _ in parts] if ways.has_old else []
    for change in distinct(left, [kept, nothing]):
        yield ways.made("not_active", change, RARE, alone)


def with_existing(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses about the existing table: only the change was loaded, the total was added to
    it, or it was not active in the earlier tests.
    """
    if not ways.has_old:
        return
    for number, existing in enumerate(distinct(ways.parts(existing=True))):
        detail = _apart() if number else None
        yield ways.made("increment", ways.total(ways.own - existing), COMMON, detail)
        yield ways.made("on_top", ways.total(ways.own + existing), COMMON, detail)
    believed = ways.at(ways.loading.active_before) - ways.stay
    if np.any(np.abs(believed) > 0.0):
        # the same test as on top of it, which happens more often
        yield ways.made("state", ways.total(ways.own) + believed, RARE)


def inverted(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield the hypothesis of a table with the opposite sign, and those in which only the table,
    not the backlash, has the opposite sign.
    """
    for number, part in enumerate(distinct(ways.parts())):
        change = ways.total(ways.own - 2.0 * part)
        yield ways.made("inverted", change, COMMON, _apart() if number else None)


def scaled(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table multiplied by a wrong factor: each typical factor (such as one
    from a wrong unit), and an unknown factor.
    """
    parts = list(distinct(ways.parts()))
    for factor, share in FACTORS.items():
        words = factor_text(factor)
        weight = COMMON * share
        more: dict[str, Any] = {"factor": factor, "inner": factor < 0.05}
        for number, part in enumerate(parts):
            change = ways.total(ways.own + (factor - 1.0) * part)
            yield ways.made("scaled", change, weight, _apart(words) if number else words, **more)
    free: dict[str, Any] = {"inner": True}
    for part in parts:
        yield ways.made("scaled", ways.total(ways.own), RARE, free=UNKNOWN_FACTOR * part, **free)


def shifted(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table shifted by whole points towards + or −."""
    rows = ways.held()
    for k in range(1, min(_MOST_SHIFT, ways.stored.order.size - 2) + 1):
        for by in (k, -k):
            ends = list(ways.shifts(by, rows))  # nearly the same test: they share the weight
            for curves in ends:
                weight = COMMON / (1 + k) / len(ends)
                yield from ways.moved("shifted", curves, weight, shift_nodes=by)


def in_order_of_positions(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a repeating table whose rows were entered in the order of the positions,
    from one end of the travel on, although the control counts them from a point inside it.

    The first row is that at the end of the targets, or one of the rows beyond it, which the travel
    hardly needs. Behind the other end, the rows go round, or are zero. If the rows are counted the
    other way, the table is mirrored.
    """
    rows, stored = ways.held(), ways.stored
    # of two rows of one section, the last one
    numbers = stored.order.size - 1 - np.unique(stored.order[::-1], return_index=True)[1]
    numbers = np.sort(numbers)
    places = ways.row_places()[numbers]
    ring = np.argsort(places, kind="stable")
    if ways.table.period is None or ring.size < 3 or np.all(np.diff(ring) == 1):
        return
    upwards = bool(stored.order[0] <= stored.order[-1])
    found: dict[LoadingName, list[tuple[Held, int, str]]] = {"shifted": [], "mirrored": []}
    for end, along in (("low", ring), ("high", ring[::-1])):
        name: LoadingName = "shifted" if (end == "low") is upwards else "mirrored"
        lowest, highest = ways.targets.min(), ways.targets.max()
        within = np.flatnonzero((places[along] >= lowest) & (places[along] <= highest))
        for more in range(min(_MOST_SHIFT, ring.size - within.size) + 1 if within.size else 0):
            entered = np.roll(along, more - int(within[0]))
            by = round(float(places[0] - places[entered[0]]) / ways.interval)
            for count in (ring.size, more + within.size + 1):
                listed = {d: np.zeros(stored.order.size) for d in Direction}
                for d, values in listed.items():
                    values[numbers[:count]] = rows[d][numbers][entered[:count]]
                found[name].append((ways.curves(listed), by, end))
    for name, each in found.items():
        for curves, by, end in each:
            extra: dict[str, Any] = {"shift_nodes": by} if name == "shifted" else {}
            detail = say("loading.in_order", end=end)
            yield from ways.moved(name, curves, RARE / len(each), detail=detail, **extra)


def mirrored(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses of a table with its rows, or its values at the points, in reverse order."""
    rows = ways.held()
    if ways.stored.order.size < 3:
        return
    kinds: list[tuple[Held, dict[str, Any]]] = [({d: v[::-1] for d, v in rows.items()}, {})]
    if ways.stored.steps:
        turned = {d: ways.stored.rows(ways.table.curve(d)[::-1]) for d in Direction}
        kinds = [(turned, {}), (kinds[0][0], {"detail": say("loading.steps"), "inner": True})]
    for turned, more in kinds:
        yield from ways.moved("mirrored", ways.curves(turned), COMMON, **more)
        off = [each for by in (1, -1) for each in ways.shifts(by, turned)]
        for each in off:  # with one row too many, or one too few
            yield from ways.moved("mirrored", each, RARE / len(off), **more)


def wrong_axis(ways: HypothesisBuilder) -> Iterator[Hypothesis]:
    """Yield hypotheses that the table of another axis is active: with its values at the same
    positions, or at the same point numbers. The numbers of a table in mm count as deg and the other
    way round, unless the rows have a unit of their own on each axis.
    """
    stored = ways.stored
    for name, their in ways.loading.others.items():
        other, ratio = their.compensation, stored.unit / their.unit
        if not other.positions.size:
            continue
        columns = dict(zip(stored.columns, their.columns, strict=True))
        sides = [list(Direction).index(columns[d]) for d in Direction]
        backlash = ways.jump(other) + ratio * their.apart[sides]
        by_place = ways.at(replace(other, others=(), backlash=0.0)) - their.apart
        curves = [(by_place, "position")]
        theirs = {d: ratio * their.rows(other.curve(columns[d])) for d in Direction}
        # a shorter table ends with nothing, or with its last value; rows that are counted from a
        # point inside the table begin with the first one, or have this point at the same place
        before = {0, (their.zero or 0) - (stored.zero or 0)} if stored.steps else {0}
        size = stored.order.size
        short = size > their.order.size and not stored.steps
        for skipped in sorted(before) if size else ():
            for held in (True, False) if short else (False,):
                rows = {d: _resized(v, size, skipped, held=held) for d, v in theirs.items()}
                curves.append((ways.values(ways.curves(rows)), "number"))
        if stored.zero is not None and their.zero is not None and stored.ahead is not None:
            # with its length, which has the unit of the rows
            table = replace(other, others=(), backlash=0.0)
            along = other.positions[their.zero] + (ways.targets - ways.loading.reference) / ratio
            values = np.stack([table.at(along, columns[d]) for d in Direction])
            curves.append((ratio * (values - their.apart[sides]), "number"))
        for curve, kind in curves:
            more = say("loading.other_axis", axis=name, by=kind)
            alone = ways.first_column(curve)
            for each in distinct([curve, alone]):
                yield from ways.both("wrong_axis", each, _OTHER, more, of=name)
            others = [ways.total(each, backlash) for each in (curve, alone, alone + ways.lost)]
            for change in distinct(others, [ways.total(curve), ways.total(alone)]):
                yield ways.made("wrong_axis", change, _OTHER, more, of=name)


def _resized(values: FloatArray, size: int, skipped: int, *, held: bool) -> FloatArray:
    """Return ``size`` of the row ``values``, without the first ones that are ``skipped`` (< 0: with
    zeros before them). Missing rows are zero; at the end they have the last value if ``held``.
    """
    index = np.arange(size) + skipped
    known = values[np.clip(index, 0, values.size - 1)]
    return np.where((index >= 0) & ((index < values.size) | held), known, 0.0)
