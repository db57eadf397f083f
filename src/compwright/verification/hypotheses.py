"""What a control does after loading when something went wrong: each fault as a correction at the
targets of a test.

A correction is what the control adds to the command, table and backlash together. A constant common
to both directions is the instrument's datum and of no account; a difference between the directions
is not. Weights are prior odds against the loaded table (weight 1); several variants may stand under
one name, and a family that runs through many (a cut at any node) shares its weight among them.
mm or deg.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Final

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.verification import LoadingName

#: Factors with a known cause, and how likely each is beside the others.
FACTORS: Final[Mapping[float, tuple[float, str]]] = {
    2.0: (1.0, "twice: radius and diameter mixed up, or loaded on top of itself"),
    0.5: (1.0, "half: radius and diameter mixed up"),
    10.0: (1.0, "ten times: another detection unit or increment system"),
    0.1: (1.0, "a tenth: another detection unit or increment system"),
    25.4: (0.5, "25.4 times: inch taken for mm"),
    1.0 / 25.4: (0.02, "1/25.4: mm taken for inch"),
    1000.0: (0.5, "a thousand times: mm taken for µm"),
    0.001: (0.02, "a thousandth: µm taken for mm"),
}
#: Most nodes by which a table may be shifted.
MOST_SHIFT: Final = 5
#: Most places at which a table may be cut.
_CUTS: Final = 120
#: A machine that has warmed up by a fraction of a degree, or whose scale is read a little
#: otherwise, changes the effect of a table by so much of itself (standard deviation).
SLACK: Final = 0.02
#: Standard deviation of a factor that nothing is known of.
UNKNOWN_FACTOR: Final = 0.7

# Prior odds of a fault against the loaded table, of each distinct variant. With odds of 5:1 and a
# verdict from 99 %, a fault that lies two standard errors from the loaded table, where it is mixed
# up most easily, passes for it in about 2 % of the tests.
_COMMON: Final = 0.2
_RARE: Final = 0.05
_FAMILY: Final = 0.025  # of a whole family of cuts of one kind
#: Where the values that were read back from the control are those of the plan, a fault of the
#: values is this much less likely. ``inverted`` is none of these: a control whose sign is another
#: than was taken (error for correction) turns the effect of values that are those of the plan.
_READ_BACK: Final = 0.01
_OF_VALUES: Final = frozenset[LoadingName](
    ("scaled", "shifted", "mirrored", "wrong_axis", "one_direction", "backlash", "partial")
)
#: Of each way in which another axis's table may act: tables of axes that are alike are no fault
#: that anybody would notice.
_OTHER: Final = 0.01


@dataclass(frozen=True, slots=True, kw_only=True)
class Hypothesis:
    """One way in which a table may have been loaded.

    ``positive``, ``negative`` (m,): by how much the correction then differs from what acted behind
    the belief; ``free`` (2, m): by what it may differ further, times a standard normal number.
    ``weight``: prior odds against the loaded table. ``slack``: standard deviation of the factor
    by which the change may differ. ``sloped``: with a slope over the positions of any size.
    ``inner``: it has the loaded table as its limit (a cut near the end, a factor near one): no name
    of its own where it is the same. ``read``: of a fault of measurement, what the table does.
    """

    name: LoadingName
    positive: FloatArray
    negative: FloatArray
    weight: float = 1.0
    detail: str = ""
    factor: float = 1.0
    shift_nodes: int = 0
    of: str | None = None
    free: FloatArray | None = None
    slack: float = 0.0
    sloped: bool = False
    inner: bool = False
    read: LoadingName | None = None

    @property
    def change(self) -> FloatArray:
        """The change in + and - (2, m)."""
        return np.stack([self.positive, self.negative])


@dataclass(frozen=True, slots=True, kw_only=True)
class Loading:
    """What was to be loaded, and what was there.

    ``new``: planned; ``old``: in the control before; ``acted``: behind the belief of the deviation
    (in the tests before); ``others``: tables planned for other axes, by name. ``beside``: by
    direction, what acts in the test in any case (m,). ``read_back``: what was read back from the
    control is what was planned.
    """

    new: AxisCompensation
    old: AxisCompensation
    acted: AxisCompensation
    others: Mapping[str, AxisCompensation] = field(default_factory=dict)
    reference: float = 0.0
    beside: tuple[FloatArray, FloatArray] | None = None
    read_back: bool = False


def loading_hypotheses(loading: Loading, targets: FloatArray) -> tuple[Hypothesis, ...]:
    """Return every way in which the table may have been loaded, at ``targets`` (m,)."""
    ways = _Ways(loading, targets).all()
    if not loading.read_back:
        return tuple(ways)
    return tuple(
        replace(way, weight=_READ_BACK * way.weight) if way.name in _OF_VALUES else way
        for way in ways
    )


_Curve = FloatArray  # (2, m): in + and in -
_Held = dict[Direction, FloatArray]  # values at the nodes (k,)


class _Ways:
    """The ways of one loading at one set of targets."""

    def __init__(self, loading: Loading, targets: FloatArray) -> None:
        self.loading, self.targets = loading, targets
        new = loading.new
        self.acted = self.at(loading.acted)
        if loading.beside is not None:
            self.acted = self.acted - np.stack(loading.beside)
        self.stay = self.at(_only_others(new))
        self.table = replace(new, others=(), backlash=0.0)
        self.own = self.at(self.table)
        self.backlash = self.jump(new)
        self.old = self.at(loading.old)
        self.old_backlash = self.jump(loading.old)
        self.has_old = bool(np.any(np.abs(self.old - self.stay) > 0.0))

    def at(self, one: AxisCompensation) -> _Curve:
        return np.stack([one.at(self.targets, direction) for direction in Direction])

    def jump(self, one: AxisCompensation) -> _Curve:
        return np.stack(
            [np.full(self.targets.size, one.backlash_at(direction)) for direction in Direction]
        )

    def total(self, curve: _Curve, backlash: _Curve | None = None) -> _Curve:
        """Return the change where ``curve`` acts with ``backlash`` (default: the new one)."""
        return self.stay + curve + (self.backlash if backlash is None else backlash) - self.acted

    def made(
        self, name: LoadingName, change: _Curve, weight: float, detail: str = "", **more: Any
    ) -> Hypothesis:
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
        self, name: LoadingName, curve: _Curve, weight: float, detail: str = "", **more: Any
    ) -> Iterator[Hypothesis]:
        """Yield a fault of the table with the new backlash, and with that which was there."""
        yield self.made(name, self.total(curve), weight, detail, **more)
        if np.any(self.backlash != self.old_backlash):
            told = f"{detail}, with the old backlash" if detail else "with the old backlash"
            yield self.made(name, self.total(curve, self.old_backlash), 0.1 * weight, told, **more)

    def all(self) -> Iterator[Hypothesis]:
        yield self.made("loaded", self.total(self.own), 1.0)
        yield from self.inactive()
        yield from self.inverted()
        yield from self.scaled()
        yield from self.shifted()
        yield from self.mirrored()
        yield from self.wrong_axis()
        yield from self.one_direction()
        yield from self.wrong_backlash()
        yield from self.partial()
        yield from self.cut_off()

    # ------------------------------------------------------------ the whole table

    def inactive(self) -> Iterator[Hypothesis]:
        left = "what was in the control before still acts" if self.has_old else ""
        yield self.made("not_active", self.old - self.acted, _COMMON, left)
        nothing = np.zeros_like(self.own)
        if self.has_old:
            change = self.stay - self.acted
            yield self.made("not_active", change, _COMMON, "nothing acts at all")
        if np.any(self.backlash != self.old_backlash):
            kept = self.old - self.old_backlash + self.backlash - self.acted
            yield self.made("not_active", kept, _RARE, "the new backlash alone acts")
        if np.any(self.backlash) and self.has_old:
            yield self.made("not_active", self.total(nothing), _RARE, "the new backlash alone acts")

    def inverted(self) -> Iterator[Hypothesis]:
        yield self.made("inverted", self.total(-self.own, -self.backlash), _COMMON)
        if np.any(self.backlash):
            apart = "all but the backlash"
            yield self.made("inverted", self.total(-self.own), _COMMON, apart)

    def scaled(self) -> Iterator[Hypothesis]:
        for factor, (share, words) in FACTORS.items():
            weight = _COMMON * share
            curve = factor * self.own
            more: dict[str, Any] = {"factor": factor, "inner": factor < 0.05}
            yield self.made(
                "scaled", self.total(curve, factor * self.backlash), weight, words, **more
            )
            if np.any(self.backlash):
                told = f"{words}, apart from the backlash"
                yield self.made("scaled", self.total(curve), weight, told, **more)
        free: dict[str, Any] = {"inner": True}
        along = UNKNOWN_FACTOR * (self.own + self.backlash)
        yield self.made("scaled", self.total(self.own), _RARE, free=along, **free)
        if np.any(self.backlash):
            yield self.made(
                "scaled", self.total(self.own), _RARE, free=UNKNOWN_FACTOR * self.own, **free
            )

    def values(self, curves: Mapping[Direction, FloatArray]) -> _Curve:
        """Return what the table does with other values (k,) at its nodes."""
        return self.at(
            replace(
                self.table,
                positive=curves[Direction.POSITIVE],
                negative=curves[Direction.NEGATIVE],
            )
        )

    def from_zero(self, curve: _Curve, curves: Mapping[Direction, FloatArray]) -> _Curve | None:
        """Return ``curve`` where each direction counts from a zero of its own: at the reference as
        the planned table; None where that is the same.
        """
        nodes, at = self.table.positions, self.loading.reference
        off = [
            float(np.interp(at, nodes, self.table.curve(d)) - np.interp(at, nodes, curves[d]))
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
        """Yield a table with other values, counting as it stands and from its own zero."""
        curve = self.values(curves)
        yield from self.both(name, curve, weight, **more)
        counted = self.from_zero(curve, curves)
        if counted is not None:
            yield from self.both(name, counted, 0.5 * weight, **more)

    def shifted(self) -> Iterator[Hypothesis]:
        nodes, held = self.table.positions.size, self.held()
        for k in range(1, min(MOST_SHIFT, nodes - 2) + 1):
            for by in (k, -k):
                for curves in self.shifts(by, held):
                    yield from self.moved("shifted", curves, _COMMON / (1 + k), shift_nodes=by)

    def held(self) -> _Held:
        """Return the values of the planned table at its nodes."""
        return {d: self.table.curve(d) for d in Direction}

    def shifts(self, by: int, held: _Held) -> Iterator[_Held]:
        """Yield the values ``held`` by ``by`` nodes too far to +: around a turn; else with the end
        value, or nothing, at the nodes that get none.
        """
        if self.table.period is not None:
            yield {d: _around(values, by) for d, values in held.items()}
            return
        index = np.arange(self.table.positions.size) - by
        inside = (index >= 0) & (index < index.size)
        kept = np.clip(index, 0, index.size - 1)
        yield {d: values[kept] for d, values in held.items()}
        ends = [values[kept][~inside] for values in held.values()]
        if any(np.any(np.abs(end) > 0.0) for end in ends):
            yield {d: np.where(inside, values[kept], 0.0) for d, values in held.items()}

    def mirrored(self) -> Iterator[Hypothesis]:
        if self.table.positions.size > 2:
            held = self.held()
            curves = {d: values[::-1] for d, values in held.items()}
            yield from self.moved("mirrored", curves, _COMMON)
            # turned about a centre one node further: of a table with one node beside the travel
            beside = [other for by in (1, -1) for other in self.shifts(by, held)]
            for each in beside:
                turned = {d: v[::-1] for d, v in each.items()}
                yield from self.moved("mirrored", turned, _RARE / len(beside))
            # Where a control keeps the steps from node to node, they are what is turned round; one
            # node further where the first or the last of its rows holds a step that never acts.
            steps = {d: v[0] + v[-1] - v[::-1] for d, v in held.items()}
            told: dict[str, Any] = {"detail": "step by step", "inner": True}
            yield from self.moved("mirrored", steps, _COMMON, **told)
            for by in (1, -1):
                yield from self.moved("mirrored", next(self.shifts(by, steps)), _RARE, **told)

    def wrong_axis(self) -> Iterator[Hypothesis]:
        for name, other in self.loading.others.items():
            if other.kind is not self.table.kind or not other.positions.size:
                continue
            theirs = self.jump(other)
            nodes = self.table.positions.size
            by_place = self.at(replace(other, others=(), backlash=0.0))
            ways = [(by_place, "by position")]
            # a shorter table ends with nothing, or, where steps are kept, with its last value
            fills = (True, False) if nodes > other.positions.size else (True,)
            for held in fills if nodes else ():
                curves = {d: _resized(other.curve(d), nodes, held=held) for d in Direction}
                ways.append((self.values(curves), "by node number"))
            for curve, told in ways:
                yield from self.both("wrong_axis", curve, _OTHER, told, of=name)
                if np.any(theirs != self.backlash):
                    change = self.total(curve, theirs)
                    yield self.made("wrong_axis", change, _OTHER, told, of=name)

    # ------------------------------------------------------------ a part of it

    def one_direction(self) -> Iterator[Hypothesis]:
        new = self.total(self.own)
        beyond = [("the other as before", self.old - self.acted)]
        if self.has_old:
            beyond.append(("nothing in the other", self.stay - self.acted))
        if np.any(self.backlash != self.old_backlash):
            beyond.append(
                ("in the other the new backlash alone", self.total(np.zeros_like(self.own)))
            )
        for side, direction in enumerate(Direction):
            for told, other in beyond:
                change = other.copy()
                change[side] = new[side]
                detail = f"it acts in approaches in {direction.value} only, {told}"
                yield self.made("one_direction", change, 0.5 * _COMMON, detail)

    def wrong_backlash(self) -> Iterator[Hypothesis]:
        """Yield another backlash than planned: that of the control, or what two tables hold."""
        step = self.backlash
        if not np.any(step):
            step = self.reversal()
        weight = _COMMON if np.any(self.backlash) else _RARE
        ways = [(-1.0, "missing"), (1.0, "twice"), (-2.0, "with the wrong sign")]
        for times, told in ways:
            if np.any(step):
                change = self.total(self.own, self.backlash + times * step)
                yield self.made("backlash", change, weight, told)
        known = [-step, step, -2.0 * step, np.zeros_like(step)]
        for value, told in (
            (self.old_backlash, "the old value instead of the new one"),
            (self.backlash + self.old_backlash, "the old value on top of the new one"),
        ):
            if not any(np.allclose(value - self.backlash, one, atol=1e-9) for one in known):
                yield self.made("backlash", self.total(self.own, value), _COMMON, told)

    def reversal(self) -> _Curve:
        """Return the mean difference of two tables, as a backlash would do it."""
        mean = (
            float(np.mean(self.table.negative - self.table.positive))
            if self.table.positions.size
            else 0.0
        )
        away = self.table.reference_return.opposite
        step = np.zeros_like(self.own)
        if abs(mean) > 1e-9:
            step[list(Direction).index(away)] = mean if away is Direction.NEGATIVE else -mean
        return step

    def partial(self) -> Iterator[Hypothesis]:
        nodes = self.table.positions
        if nodes.size < 3:
            return
        held = self.held()
        beyond: list[tuple[str, _Held | None, bool]] = [
            ("nothing beyond", {d: np.zeros(nodes.size) for d in Direction}, False),
            ("the last value beyond", None, False),
        ]
        if self.has_old:
            before = self.old_values()
            beyond.append(("the old values beyond", before, False))
            beyond.append(("the old steps beyond", before, True))
        cuts = self.cuts()
        for told, rest, joined in beyond:
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
                    yield from self.both(
                        "partial",
                        self.values(curves),
                        _FAMILY / len(cuts),
                        f"{where}, {told}",
                        inner=not 0.25 <= share <= 0.75,
                    )

    def old_values(self) -> _Held:
        """Return what was there at the nodes, without what stays and the backlash."""
        nodes, old, stay = self.table.positions, self.loading.old, _only_others(self.loading.new)
        line = self.table.slope * (nodes - self.table.origin)
        return {
            d: old.at(nodes, d) - old.backlash_at(d) - stay.at(nodes, d) - line for d in Direction
        }

    def cut_off(self) -> Iterator[Hypothesis]:
        """Yield a table that ends between two nodes all at once, its backlash with it."""
        nodes, targets = self.table.positions, self.targets
        if nodes.size < 3 or targets.size < 3:
            return
        new = self.total(self.own)
        beyond = [("nothing beyond, no backlash either", self.stay - self.acted)]
        if self.has_old:
            beyond.append(("all as before beyond", self.old - self.acted))
        gaps = np.arange(1, targets.size)
        gaps = gaps[np.unique(np.linspace(0, gaps.size - 1, min(gaps.size, _CUTS)).astype(int))]
        for told, rest in beyond:
            for gap in gaps:
                last = int(np.clip(np.searchsorted(nodes, targets[gap - 1]), 0, nodes.size - 1))
                for first in (True, False):
                    inside = (np.arange(targets.size) < gap) == first
                    number = f"up to node {last + 1}" if first else f"from node {last + 1} on"
                    share = float(np.mean(inside))
                    yield self.made(
                        "partial",
                        np.where(inside, new, rest),
                        _FAMILY / gaps.size,
                        f"{number} ({nodes[last]:g}), {told}",
                        inner=not 0.25 <= share <= 0.75,
                    )

    def cuts(self) -> list[int]:
        """Return the numbers of nodes that may have been loaded: between the targets, at most
        `_CUTS`.
        """
        nodes = self.table.positions
        seats = np.searchsorted(self.targets, nodes)
        acting = [
            cut
            for cut in range(1, nodes.size)
            if seats[cut] > 0 and seats[cut - 1] < self.targets.size
        ]
        if len(acting) <= _CUTS:
            return acting
        return [acting[i] for i in np.unique(np.linspace(0, len(acting) - 1, _CUTS).astype(int))]


def _only_others(one: AxisCompensation) -> AxisCompensation:
    empty = np.empty(0)
    return replace(one, positions=empty, positive=empty, negative=empty, backlash=0.0, slope=0.0)


def _around(values: FloatArray, by: int) -> FloatArray:
    """Return the values of a table around a turn, whose last is its first, ``by`` nodes further."""
    turned = np.roll(values[:-1], by)
    return np.append(turned, turned[0])


def _resized(values: FloatArray, size: int, *, held: bool) -> FloatArray:
    """Return the first ``size`` values; at the nodes beyond the last of them (``held``), or
    nothing.
    """
    resized = np.full(size, values[-1] if held else 0.0)
    count = min(size, values.size)
    resized[:count] = values[:count]
    return resized
