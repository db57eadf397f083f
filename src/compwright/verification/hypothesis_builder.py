"""Builder of hypotheses about loading: the correction at the targets if the table in the control
has values different from the planned ones.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.verification import LoadingName
from compwright.verification.hypothesis import SLACK, Hypothesis, Loading
from compwright.words.sentences import Sentence, say

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
        """Yield two hypotheses of a faulty table that makes the correction ``curve`` (2, m): one
        with the new and one with the old backlash value. ``weight``: the prior weight of the first.
        """
        yield self.made(name, self.total(curve), weight, detail, **more)
        if np.any(self.backlash != self.old_backlash):
            old = say("loading.variant", detail=detail, backlash="old")
            yield self.made(name, self.total(curve, self.old_backlash), 0.1 * weight, old, **more)

    def held(self) -> Held:
        """Return the row values (r,) of the planned table, one array for each direction."""
        return {d: self.stored.rows(self.table.curve(d)) for d in Direction}

    def old_rows(self) -> Held:
        """Return the row values (r,) with which the new table would be the old one. The backlash
        value and tables that stay active are not included.
        """
        points, old = self.table.positions, self.loading.old
        stay = _only_others(self.loading.new.compensation)
        line = self.table.slope * (points - self.table.origin)
        return {
            d: self.stored.rows(old.at(points, d) - old.backlash_at(d) - stay.at(points, d) - line)
            for d in Direction
        }

    @property
    def interval(self) -> float:
        """The distance of two points of the table, mm or deg."""
        return float(self.table.positions[1] - self.table.positions[0])

    def row_places(self) -> FloatArray:
        """Return the position (r,) of each row in the range of the targets, mm or deg."""
        points = self.table.positions
        places: FloatArray = points[self.stored.row_points]
        if self.table.period is not None:
            beyond = places > self.targets.max() + self.interval
            places = np.where(beyond, places - self.table.period, places)
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


def _only_others(one: AxisCompensation) -> AxisCompensation:
    empty = np.empty(0)
    return replace(one, positions=empty, positive=empty, negative=empty, backlash=0.0, slope=0.0)


def _around(values: FloatArray, by: int) -> FloatArray:
    """Return the table values of an endless rotary axis shifted ``by`` points; values beyond one
    end continue at the other end, and the last value equals the first.
    """
    turned = np.roll(values[:-1], by)
    return np.append(turned, turned[0])
