"""Add the cross-axis tables (CEC) of each pair of axes to one curve, up to the control's limit."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.families.pairs.tables import Cec, CecTable
from compwright.formats.text.notes import Notes
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, CrossCompensation


def without_cut_sums(
    cec: Cec,
    notes: Notes,
    may_stay: Callable[[CecTable], bool],
    wanted: Iterable[str] = (),
) -> Cec:
    """Return the cross-axis tables. If the sum of the tables on one output axis exceeds the
    control's limit, leave all of these out, provided that they ``may_stay`` unchanged; else add a
    fault. ``wanted``: the axes to check (none: all).

    The control limits such a sum, so the correction is not the sum of the curves. If all of these
    tables stay, the correction is the same before and after loading.
    """
    under_work = tuple(wanted)
    for output, limit in cec.max_sum.items():
        mine = [table for table in cec.tables if table.output == output and table.active]
        low, high = _reach(cec, mine)
        if (under_work and output not in under_work) or max(high, -low) <= limit * (1 + 1e-9):
            continue
        reach = f"{low:g} to {high:g}"
        if all(map(may_stay, mine)):
            why = f"their sum is {reach}, and MD32720 $MA_CEC_MAX_SUM limits it to {limit:g}"
            cec = cec.left_alone(mine, why)
            notes.find(
                "CW-S050.sum",
                "warning",
                tables=[table.index for table in mine],
                output=output,
                low=low,
                high=high,
                limit=limit,
            )
        else:
            notes.faults.append(
                Fault(
                    message=(
                        f"axis {output}: the sum of its CEC tables exceeds CEC_MAX_SUM, "
                        "where the control cuts it off"
                    ),
                    expected=f"at most {limit:g}",
                    found=reach,
                    hint="reduce the tables in the control, measure and export its files again",
                )
            )
    return cec


def _reach(cec: Cec, tables: Sequence[CecTable]) -> tuple[float, float]:
    """Return the smallest and largest sum of ``tables`` that can occur on an output axis."""
    low = high = 0.0
    for pair in dict.fromkeys(table.pair for table in tables):
        curves = [curve for _, _, *both in _merged(cec.active(pair)) for curve in both]
        low += min(float(np.min(curve)) for curve in curves)
        high += max(float(np.max(curve)) for curve in curves)
    return low, high


def _merged(
    tables: Sequence[CecTable],
) -> list[tuple[float | None, FloatArray, FloatArray, FloatArray]]:
    """Return the sums of cross-axis tables: the tables with the same period and start position
    become one curve, with its period, its positions, and its corrections for + and for -.

    Each table is straight between its points, so their sum is straight between the points of all of
    them.
    """
    groups: dict[tuple[float | None, float | None], list[CecTable]] = {}
    for table in tables:
        start = None if table.period is None else float(table.positions[0])
        groups.setdefault((table.period, start), []).append(table)
    merged = []
    for (period, _), members in groups.items():
        points: FloatArray = np.unique(np.concatenate([table.positions for table in members]))
        curves = []
        for direction in Direction:
            active = [
                np.interp(points, table.positions, table.values)
                for table in members
                if direction in table.directions
            ]
            curves.append(np.sum(active, axis=0) if active else np.zeros(points.size))
        merged.append((period, points, curves[0], curves[1]))
    return merged


def with_own_tables(cec: Cec, compensation: AxisCompensation) -> AxisCompensation:
    """Return an axis' compensation, including cross-axis tables that correct it by its own
    position.
    """
    mine = cec.active((compensation.address, compensation.address))
    own = _as_tables(compensation, [table for table in mine if not table.stays])
    stay = staying(cec, compensation)
    if not own or compensation.positions.size:
        return replace(compensation, others=(*own, *stay))
    return replace(own[0], backlash=compensation.backlash, others=(*own[1:], *stay))


def staying(cec: Cec, compensation: AxisCompensation) -> tuple[AxisCompensation, ...]:
    """Return the tables that correct an axis by its own position and stay unchanged."""
    mine = cec.active((compensation.address, compensation.address))
    return _as_tables(compensation, [table for table in mine if table.stays])


def _as_tables(
    compensation: AxisCompensation, tables: Sequence[CecTable]
) -> tuple[AxisCompensation, ...]:
    """Return the sums of cross-axis tables by which an axis corrects itself, as tables of that
    axis.
    """
    return tuple(
        replace(
            compensation,
            positions=points,
            positive=positive,
            negative=negative,
            backlash=0.0,
            period=period,
            below="hold",
            above="hold",
            others=(),
        )
        for period, points, positive, negative in _merged(tables)
    )


def cross_tables(cec: Cec, kind: Callable[[str], AxisKind]) -> tuple[CrossCompensation, ...]:
    """Return the corrections between axes: the sum of the tables for each axis pair and period.

    A table that cannot be read as a curve is not included. It stays unchanged, so its effect is the
    same before and after loading.
    """
    pairs = dict.fromkeys(table.pair for table in cec.tables if table.input != table.output)
    return tuple(
        CrossCompensation(
            input=pair[0],
            output=pair[1],
            input_kind=kind(pair[0]),
            output_kind=kind(pair[1]),
            positions=points,
            positive=positive,
            negative=negative,
            period=period,
        )
        for pair in pairs
        for period, points, positive, negative in _merged(cec.active(pair))
    )
