"""Points of one store that all axes of a control share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from compwright.records.capacity import Capacity
from compwright.records.plan import PlannedAxis


def shared_fairly(
    capacities: Mapping[str, Capacity], planned: Mapping[str, PlannedAxis]
) -> dict[str, Capacity]:
    """Return the capacities with the points of a store that all axes share divided among those
    whose spacing compwright chooses.

    An axis whose spacing the job names gets what it needs; two tables need twice the points. What
    the job names stays as it is: where it does not fit, writing refuses it. A grid that is in the
    control and stays takes none of what is free, unless other axes use its points too.
    """
    sharing = {
        name: one
        for name, one in capacities.items()
        if one.shared_points
        and one.max_points
        and name in planned
        and not (planned[name].request.keeps and one.there and not one.there_shared)
    }
    sets = {name: 2 if planned[name].request.mode == "bidirectional" else 1 for name in sharing}
    free = {
        name: one for name, one in sharing.items() if planned[name].request.named_spacing is None
    }
    named = 0
    for name in sharing.keys() - free.keys():
        request, axis = planned[name].request, planned[name].axis
        low = min(axis.travel[0] if request.start is None else request.start, axis.reference)
        high = max(axis.travel[1] if request.end is None else request.end, axis.reference)
        named += sets[name] * (int((high - low) / (request.named_spacing or 1.0)) + 3)
    result = dict(capacities)
    for name, one in free.items():
        room = min(other.max_points or 0 for other in sharing.values())
        share = (room - named) // len(free) // sets[name] - 2
        if len(sharing) > 1 or sets[name] > 1:
            result[name] = replace(one, max_points=max(2, min(one.max_points or 2, share)))
    return result
