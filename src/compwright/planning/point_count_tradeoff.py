"""The predicted parameter of an axis as a function of the number of table points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.fitting.grid import possible_grids
from compwright.foundations.errors import CapacityError
from compwright.planning.axis_work import AxisWork
from compwright.planning.simulated_repeat_tests import FreshTests
from compwright.planning.tables import fit_remaining
from compwright.prediction.active_corrections import Correction, difference
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity
from compwright.records.fitted_table import TableRequest
from compwright.records.limits import PointCountOption

#: Number of sizes that are shown in addition to the written and the existing one.
_SIZES: Final = 7
#: Most points that are considered: with more, points lie closer than targets are dithered.
_MOST: Final = 400


def point_count_tradeoff(
    work: AxisWork, new: Correction, fresh: FreshTests, name: str
) -> tuple[PointCountOption, ...]:
    """Return the parameter ``name`` of the simulated tests ``fresh`` for the written table ``new``
    and for tables with other numbers of points; an empty tuple if there is no choice.

    Every table is fitted to the wanted correction under the control's own limits, on equally spaced
    points that the control can hold.
    """
    wanted, fitted, capacity = work.planned.wanted, work.planned.fitted, work.capacity
    if wanted is None or fitted is None or capacity is None or capacity.line is not None:
        return ()
    written = fitted.compensation.positions
    if capacity.points is not None or written.size < 2:
        return ()
    request = TableRequest(mode=fitted.mode)
    grids = possible_grids(wanted, capacity, request, _MOST)
    there = np.array(capacity.there)
    others = [grid for grid in _spread(grids) if grid.size not in (written.size, there.size)]
    if there.size > 1 and not np.array_equal(there, written):
        others.append(there)
    found = [_worth(fresh, new, written, work.active, name, written=True)]
    for points in others:
        table = _table_on(points, work, capacity, request)
        if table is not None:
            found.append(_worth(fresh, table, points, work.active, name, there=points is there))
    if len(found) < 3:
        return ()
    if np.array_equal(there, written):
        found[0] = replace(found[0], there=True)
    return tuple(sorted(found, key=lambda one: one.points))


def _spread(grids: Sequence[FloatArray]) -> list[FloatArray]:
    """Return a few of the ``grids``, with numbers of points that grow by nearly equal factors. The
    first and the last grid are included.
    """
    if not grids:
        return []
    sizes = np.array([grid.size for grid in grids])
    steps = np.geomspace(sizes[0], sizes[-1], _SIZES)
    chosen = sorted({int(np.argmin(np.abs(np.log(sizes / step)))) for step in steps})
    return [grids[index] for index in chosen]


def _table_on(
    points: FloatArray, work: AxisWork, capacity: Capacity, request: TableRequest
) -> Correction | None:
    """Return the correction by a table with points at ``points``, or None if the control cannot
    hold such a table.
    """
    wanted = work.planned.wanted
    if wanted is None:
        return None
    given = replace(capacity, points=tuple(points.tolist()), there=())
    try:
        return fit_remaining(
            replace(wanted, scenarios=None), given, request, work.planned.axis, costs=False
        ).compensation.at
    except CapacityError:
        return None


def _worth(
    fresh: FreshTests,
    new: Correction,
    points: FloatArray,
    active: Correction,
    name: str,
    *,
    written: bool = False,
    there: bool = False,
) -> PointCountOption:
    shown = fresh.band(difference(new, active), only=name)[name]
    return PointCountOption(
        points=points.size,
        spacing=float(np.max(np.diff(points))),
        median=shown.median,
        p05=shown.p05,
        p95=shown.p95,
        written=written,
        there=there,
    )
