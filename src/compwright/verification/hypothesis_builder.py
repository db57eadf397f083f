"""Builder of hypotheses about loading: the correction at the targets if the table in the control
has values different from the planned ones.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any, Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.verification import LoadingName
from compwright.verification.hypothesis import SLACK, Hypothesis, Loading
from compwright.words.sentences import Sentence, say

#: Corrections as near as this are the same, mm or deg.
_SAME: Final = 1e-9

Curve = FloatArray  # (2, m): in + and in -
Held = dict[Direction, FloatArray]  # values at the points (k,), or of the rows (r,)


class HypothesisBuilder:
    """Builder of the hypotheses about one loading, for one set of targets.

    ``table``: the planned table alone, without the value that is stored apart from its rows, which
    counts as backlash. ``own`` (2, m): its correction. ``stay``: the correction of other tables,
    which stay in any case. ``old``, ``old_backlash``: the correction before loading, and its
    backlash.
    """

    def __init__(self, loading: Loading, targets: FloatArray) -> None:
        self.loading, self.targets = loading, targets
        self.stored, new = loading.new, loading.new.compensation
        self.active_before = self.at(loading.active_before)
        if loading.always is not None:
            self.active_before = self.active_before - np.stack(loading.always)
        self.stay = self.at(_only_others(new))
        positive, negative = np.stack([new.positive, new.negative]) - self.stored.apart
        self.table = replace(new, others=(), backlash=0.0, positive=positive, negative=negative)
        self.own = self.at(self.table)
        self.backlash = self.jump(new) + self.stored.apart
        self.old = self.at(loading.old)
        self.old_backlash = self.jump(loading.old)
        if self.stored.zero is not None:
            others, zero = _only_others(new), new.positions[[self.stored.zero]]
            for row, d in enumerate(Direction):
                self.old_backlash[row] = loading.old.at(zero, d) - others.at(zero, d)
        self.has_old = bool(np.any(np.abs(self.old - self.stay) > 0.0))

    def at(self, one: AxisCompensation) -> Curve:
        """Return the correction (2, m) that a compensation makes at the targets, in + and −."""
        return np.stack([one.at(self.targets, direction) for direction in Direction])

    def jump(self, one: AxisCompensation) -> Curve:
        """Return the part of a compensation's correction that comes from its backlash value."""
        return np.stack(
            [np.full(self.targets.size, one.backlash_at(direction)) for direction in Direction]
        )

    def total(self, curve: Curve, backlash: Curve | None = None) -> Curve:
        """Return by how much loading changed the correction (2, m) at the targets if the table then
        makes the correction ``curve`` (2, m) and its backlash value makes ``backlash`` (2, m;
        default: the planned one).
        """
        return (
            self.stay
            + curve
            + (self.backlash if backlash is None else backlash)
            - self.active_before
        )

    def made(
        self,
        name: LoadingName,
        change: Curve,
        weight: float,
        detail: Sentence | None = None,
        **more: Any,
    ) -> Hypothesis:
        """Return the hypothesis ``name`` with a ``change`` of the correction (2, m). ``weight``:
        its prior weight; ``detail``: the text that names the variant; ``more``: further fields of
        the `Hypothesis`.
        """
        return Hypothesis(
            name=name,
            positive=change[0],
            negative=change[1],
            weight=weight,
            detail=detail,
            slack=SLACK,
            **more,
        )

    def both(
        self,
        name: LoadingName,
        curve: Curve,
        weight: float,
        detail: Sentence | None = None,
        **more: Any,
    ) -> Iterator[Hypothesis]:
        """Yield hypotheses of a faulty table that makes the correction ``curve`` (2, m): with the
        new and with the old backlash value, and, where the control has a table of the backlash,
        with this table as planned. ``weight``: the prior weight of the first.
        """
        yield self.made(name, self.total(curve), weight, detail, **more)
        if np.any(self.lost):
            apart = say("loading.variant", detail=detail, backlash="apart")
            change = self.total(self.first_column(curve) + self.lost)
            yield self.made(name, change, 0.1 * weight, apart, **more)
        if np.any(self.backlash != self.old_backlash):
            old = say("loading.variant", detail=detail, backlash="old")
            yield self.made(name, self.total(curve, self.old_backlash), 0.1 * weight, old, **more)

    def first_column(self, curve: Curve) -> Curve:
        """Return the part (2, m) of a table's correction ``curve`` (2, m) that is in its first
        column; with one column for each direction, all of it.
        """
        ahead = self.stored.ahead
        return curve if ahead is None else curve[[list(Direction).index(ahead)] * 2]

    @property
    def lost(self) -> Curve:
        """The part (2, m) of the planned table's correction that is in the table of the backlash,
        in addition to the backlash value.
        """
        lost = self.own - self.first_column(self.own)
        return np.where(np.abs(lost) > _SAME, lost, 0.0)

    def parts(self, *, existing: bool = False) -> list[Curve]:
        """Return the parts (2, m) of the planned or ``existing`` correction that a fault may
        concern alone, the rest being right: all, the table, and the table without that of the
        backlash.
        """
        table = self.old - self.stay - self.old_backlash if existing else self.own
        backlash = self.old_backlash if existing else self.backlash
        return [table + backlash, table, self.first_column(table)]

    def held(self) -> Held:
        """Return the row values (r,) of the planned table, one array for each direction."""
        return {d: self.stored.rows(self.table.curve(d)) for d in Direction}

    def old_rows(self) -> Held:
        """Return the row values (r,) with which the new table would be the old one. The backlash
        value and tables that stay active are not included.
        """
        places, old = self._places, self.loading.old
        stay = _only_others(self.loading.new.compensation)
        line = self.table.slope * (places - self.table.origin)
        return {
            d: self.stored.rows(old.at(places, d) - old.backlash_at(d) - stay.at(places, d) - line)
            for d in Direction
        }

    @property
    def interval(self) -> float:
        """The distance of two points of the table, mm or deg."""
        return float(self.table.positions[1] - self.table.positions[0])

    def row_places(self) -> FloatArray:
        """Return the position (r,) of each row in the range of the targets, mm or deg."""
        places: FloatArray = self._places[self.stored.row_points]
        return places

    @property
    def _places(self) -> FloatArray:
        """The positions (k,) of the points in the range of the targets, mm or deg."""
        points, period = self.table.positions, self.table.period
        if period is None or points.size < 2:
            return points
        beyond = points > self.targets.max() + self.interval
        places: FloatArray = np.where(beyond, points - period, points)
        return places

    def curves(self, rows: Mapping[Direction, FloatArray]) -> Held:
        """Return the values at the points (k,) of a table with the row values ``rows`` (r,)."""
        return {d: self.stored.curve(rows[d]) for d in Direction}

    def values(self, curves: Mapping[Direction, FloatArray]) -> Curve:
        """Return the correction at the targets if the table has the values ``curves`` (k,)."""
        return self.at(
            replace(
                self.table,
                positive=curves[Direction.POSITIVE],
                negative=curves[Direction.NEGATIVE],
            )
        )

    def _from_zero(self, curve: Curve, curves: Mapping[Direction, FloatArray]) -> Curve | None:
        """Return ``curve``, which the table values ``curves`` make at the targets, shifted in each
        direction on its own so that the table has its planned value at the reference; None if both
        directions have the same shift.
        """
        points, at = self.table.positions, self.loading.reference
        off = [
            float(np.interp(at, points, self.table.curve(d)) - np.interp(at, points, curves[d]))
            for d in Direction
        ]
        return None if abs(off[0] - off[1]) < 1e-9 else curve + np.array(off)[:, np.newaxis]

    def moved(
        self,
        name: LoadingName,
        curves: Mapping[Direction, FloatArray],
        weight: float,
        **more: Any,
    ) -> Iterator[Hypothesis]:
        """Yield hypotheses of a table with the values ``curves``, and with these values shifted so
        that the reference has its planned value. ``weight``: the prior weight of the first.
        """
        curve = self.values(curves)
        yield from self.both(name, curve, weight, **more)
        counted = self._from_zero(curve, curves)
        if counted is not None:
            yield from self.both(name, counted, 0.5 * weight, **more)

    def shifts(self, by: int, rows: Held) -> Iterator[Held]:
        """Yield the values at the points of a table whose ``rows`` (r,) are shifted ``by`` rows
        towards +. Rows without a shifted value get the value of the nearest end, and in a second
        variant zero; steps are zero there.
        """
        order, steps = self.stored.order, self.stored.steps
        if self.table.period is not None and (steps or order.size == self.table.positions.size):
            yield {d: _around(values, by) for d, values in self.curves(rows).items()}
            return
        index = np.arange(order.size) - (by if order[0] <= order[-1] else -by)
        inside = (index >= 0) & (index < index.size)
        kept = np.clip(index, 0, index.size - 1)
        if not steps:
            yield self.curves({d: values[kept] for d, values in rows.items()})
        ends = [values[kept][~inside] for values in rows.values()]
        if steps or any(np.any(np.abs(end) > 0.0) for end in ends):
            filled = {d: np.where(inside, values[kept], 0.0) for d, values in rows.items()}
            yield self.curves(filled)


def distinct(curves: Iterable[Curve], known: Iterable[Curve] = ()) -> Iterator[Curve]:
    """Yield those of the ``curves`` that differ from all before and from those ``known``."""
    seen = list(known)
    for curve in curves:
        if not any(np.allclose(curve, one, rtol=0.0, atol=_SAME) for one in seen):
            seen.append(curve)
            yield curve


def _only_others(one: AxisCompensation) -> AxisCompensation:
    empty = np.empty(0)
    return replace(one, positions=empty, positive=empty, negative=empty, backlash=0.0, slope=0.0)


def _around(values: FloatArray, by: int) -> FloatArray:
    """Return the table values of an endless rotary axis shifted ``by`` points; values beyond one
    end continue at the other end, and the last value equals the first.
    """
    turned = np.roll(values[:-1], by)
    return np.append(turned, turned[0])
