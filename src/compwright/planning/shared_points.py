"""Division of a control's table points among its axes, if all axes share one store of points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.records.capacity import Capacity
from compwright.records.plan import PlannedAxis

#: So many points more may a table take from the store than it has points.
_TO_SPARE: Final = 2


def share_points(
    capacities: Mapping[str, Capacity], planned: Mapping[str, PlannedAxis]
) -> dict[str, Capacity]:
    """Return the limits of each axis after the shared points are divided.

    An axis whose spacing the job states gets as many points as this spacing needs, and twice as
    many for two tables. If these are too many, the spacing is not changed: the files are refused
    later.

    Two grids take no shared points: an existing grid that stays, unless other axes use its points
    too, and a grid that fits into the points that its axis already has. No axis gets fewer points
    than it already has.
    """
    sharing = {
        name: one
        for name, one in capacities.items()
        if one.shared_points is not None
        and one.max_points
        and name in planned
        and not (planned[name].request.keeps and one.there and not one.there_shared)
    }
    sets = {name: 2 if planned[name].request.mode == "bidirectional" else 1 for name in sharing}
    free = [name for name in sharing if planned[name].request.named_spacing is None]
    room = min((one.shared_points or 0 for one in sharing.values()), default=0)
    for name in sharing.keys() - set(free):
        needed = sets[name] * _named_points(planned[name])
        if needed > sharing[name].own_points:
            room -= needed + sets[name] * _TO_SPARE
    result = dict(capacities)
    for name in free:
        one = sharing[name]
        share = max(one.own_points // sets[name], room // len(free) // sets[name] - _TO_SPARE)
        if len(sharing) > 1 or sets[name] > 1:
            result[name] = replace(one, max_points=max(2, min(one.max_points or 2, share)))
    return result


def _named_points(planned: PlannedAxis) -> int:
    """Return the number of points that an axis' table has at the spacing stated in the job."""
    request, axis = planned.request, planned.axis
    spacing = request.named_spacing or 1.0
    low = min(axis.travel[0] if request.start is None else request.start, axis.reference)
    high = max(axis.travel[1] if request.end is None else request.end, axis.reference)
    below = int(np.ceil((axis.reference - low) / spacing - 1e-6))
    return below + int(np.ceil((high - axis.reference) / spacing - 1e-6)) + 1
