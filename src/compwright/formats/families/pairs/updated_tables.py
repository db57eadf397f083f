"""Add a correction between two axes to the control's own CEC table of this pair, in place.

The sum is exact: each point of the old curve and each corner of the correction is a point of the
table.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import gcd

import numpy as np

from compwright.formats.families.family import Family
from compwright.formats.families.pairs.options import allowed_tables
from compwright.formats.text.values import name_of
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlState, CrossCompensation
from compwright.words.sentences import control_text

#: Positions closer than this are one, mm or deg.
_SAME = 1e-6
#: A curve is straight that nowhere deviates by more than this from its line, mm or deg.
_STRAIGHT = 1e-9
#: A new grid has an interval of whole multiples of this, mm or deg, and values of this.
_STEP, _QUANTUM = 1e-3, 1e-6


def own_tables(control: Family, pair: tuple[str, str]) -> list[int]:
    """Return the indices of the control's tables of a pair of axes, input and output axis."""
    return [index for index, axes in control.state.tables.used.items() if axes == pair]


def updated_table(control: Family, entry: CrossCompensation) -> tuple[int, FloatArray] | None:
    """Return the index of the table of the same axes that takes ``entry``, and its new positions;
    None if no table that may be written takes it exactly.

    ``entry`` as `over_own_points` returns it.
    """
    for index in own_tables(control, (entry.input, entry.output)):
        positions, why = _positions(control, index, entry)
        if not why:
            return index, positions
    return None


def obstacles(control: Family, index: int, entry: CrossCompensation) -> list[tuple[str, str]]:
    """Return each reason why the control's table ``index`` of the same axes does not take
    ``entry``, with its next step (empty: only another table helps).
    """
    return _positions(control, index, entry)[1]


def _positions(
    control: Family, index: int, entry: CrossCompensation
) -> tuple[FloatArray, list[tuple[str, str]]]:
    """Return the positions of the points of table ``index`` with ``entry`` added; each reason why
    it does not take ``entry``, as `obstacles` returns them.
    """
    tables = control.state.tables
    why = [*tables.obstacles.get(index, ())]
    if index not in allowed_tables(control.definition, control.options):
        step = control_text(
            "add {index} to `cec_tables`, so that it is changed in place", index=str(index)
        )
        why.append((control_text("`cec_tables` does not name it"), step))
    if entry.period is not None:
        why.append((control_text("the correction repeats"), ""))
    if not np.array_equal(entry.positive, entry.negative):
        why.append((control_text("the correction differs by direction"), ""))
    old = np.array(tables.curves.get(index, ((), ()))[0])
    if not old.size:
        return old, why or [(control_text("it cannot be read as a curve"), "")]
    if all(float(np.min(np.abs(old - one))) <= _SAME for one in entry.positions):
        return old, why
    every = np.unique(np.concatenate([old, entry.positions]))
    steps = (every - every[0]) / _STEP
    whole = np.round(steps).astype(int)
    interval = gcd(*whole.tolist())
    spacing = float(old[-1] - old[0]) / max(old.size - 1, 1)
    move = control_text(
        "end the travel of {input} in the job at a point of the table (multiples of {spacing} from"
        " {first})",
        input=entry.input,
        spacing=f"{spacing:g}",
        first=f"{old[0]:g}",
    )
    if float(np.max(np.abs(steps - whole))) > _SAME / _STEP or interval == 0:
        reason = control_text("no equal spacing has its points and those of the correction")
        return old, [*why, (reason, move)]
    count = int(whole[-1]) // interval + 1
    little = _too_little_room(control, index, old.size, count)
    if not little:
        return every[0] + interval * _STEP * np.arange(count), why
    have, more_room = little
    coarser = move if interval * _STEP < spacing - _SAME else ""
    reason = control_text("{have}, needed: {count}", have=have, count=str(count))
    return old, [*why, (reason, either_step(more_room, coarser))]


def _too_little_room(
    control: Family, index: int, points: int, count: int
) -> tuple[str, str] | None:
    """Return how many points table ``index``, which has ``points``, has room for, and the next
    step; None if there is room for ``count``.
    """
    definition, promised = control.definition, control.options.get("points")
    fixed, stated = definition.limit_number("cross_points"), control.state.tables.reserved
    room = int(fixed or (promised if isinstance(promised, int) else 0))
    room = max(stated.get(index, 0), room, points)
    if count <= room:
        return None
    if fixed:
        return control_text("it has room for {room} points", room=str(room)), ""
    name = f"MD18342 ({name_of(definition, 'cross_max_points')}[{index}])"
    step = control_text(
        "set MD18342 to {count} or more (save an archive, power on, load the archive back) and"
        " export the files again",
        count=str(count),
    )
    if index in stated:
        return control_text("{name} is {value}", name=name, value=str(stated[index])), step
    return (
        control_text(
            "{name} is in no given file, and room is known for {room} points only",
            name=name,
            room=str(room),
        ),
        control_text("add the file with MD18342 to the control's files, or {step}", step=step),
    )


def either_step(one: str, other: str) -> str:
    """Return two alternative next steps, of which either may be empty, as one."""
    return (
        control_text("{one}; or {other}", one=one, other=other) if one and other else one or other
    )


def added_up(
    control: Family, index: int, entry: CrossCompensation, where: FloatArray
) -> FloatArray:
    """Return the correction of a table plus that of ``entry`` at the positions ``where``."""
    old = np.interp(where, *control.state.tables.curves[index])
    return np.round((old + entry.at(where, Direction.POSITIVE)) / _QUANTUM) * _QUANTUM


def over_own_points(control: Family, entry: CrossCompensation) -> CrossCompensation:
    """Return a straight correction that ends at points of the control's own table of these axes,
    the nearest ones outside the travel; others as they are.
    """
    tables, ends = control.state.tables, entry.positions[[0, -1]]
    values = entry.positive[[0, -1]]
    line = np.interp(entry.positions, ends, values)
    straight = entry.period is None and all(
        float(np.max(np.abs(curve - line))) <= _STRAIGHT
        for curve in (entry.positive, entry.negative)
    )
    for index in own_tables(control, (entry.input, entry.output)) if straight else ():
        old = np.array(tables.curves.get(index, ((), ()))[0])
        below, above = old[old <= ends[0] + _SAME], old[old >= ends[1] - _SAME]
        points = np.array([*below[-1:], *above[:1]])
        slope = (values[1] - values[0]) / (ends[1] - ends[0])
        if points.size == len(ends):
            curve = np.round((values[0] + slope * (points - ends[0])) / _QUANTUM) * _QUANTUM
            wider = replace(entry, positions=points, positive=curve, negative=curve)
            if updated_table(control, wider) is not None:
                return wider
    return entry


def largest_sum(state: ControlState, output: str, new: Sequence[CrossCompensation] = ()) -> float:
    """Return the largest amount, mm or deg, that the sum of all active tables of the axis
    ``output`` can reach, together with the corrections ``new``.
    """
    facts, own = state.facts_of(output).pairs, state.axes.get(output)
    active = [entry for entry in (*state.cross, *new) if entry.output == output]
    low, high = -facts.odd_sum, facts.odd_sum
    for base in dict.fromkeys(entry.input for entry in active):
        mine = [entry for entry in active if entry.input == base]
        where = np.unique(np.concatenate([entry.positions for entry in mine]))
        sums = [np.sum([one.at(where, way) for one in mine], axis=0) for way in Direction]
        low, high = low + float(np.min(sums)), high + float(np.max(sums))
    for one in () if own is None else (*own.others, *((own,) if facts.own else ())):
        low += float(np.min([one.positive, one.negative]))
        high += float(np.max([one.positive, one.negative]))
    return max(high, -low)
