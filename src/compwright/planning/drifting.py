"""Drift within a run looks like a reversal that varies along the travel."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axes import AxisWork
from compwright.planning.fresh import FreshTests
from compwright.records.axis import Direction
from compwright.records.settled import settled_number

#: The reversal changes by about what the drift would give: within this factor.
_ALIKE: Final = 2.0


def drift_or_reversal(work: AxisWork, fresh: FreshTests) -> Iterator[Finding]:
    """Yield that the second table may hold the drift of the test (CW-P153), where one is written
    and the readings drift.

    A run goes up through the targets and down again: at the low end a whole run lies between the
    reading in + and the one in -, at the high end none. An axis that drifts by D from the first of
    n runs to the last shows a reversal (mean in + less mean in -) that rises by D / (n - 1) from
    the low end to the high one, however constant the play is.
    """
    planned = work.planned
    runs = min(int(np.max(work.results[0].test.readings(way), initial=0.0)) for way in Direction)
    if planned.fitted is None or planned.fitted.mode != "bidirectional" or runs < 2:
        return
    drift = settled_number(np.median(fresh.draws.noise.drift))
    within = drift / (runs - 1)
    rises = _rise(work)
    if within == 0.0 or not 1.0 / _ALIKE <= rises / within <= _ALIKE:
        return
    unit = planned.axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    risen, drifted, shown = (f"{one * factor:+.2f} {small}" for one in (rises, drift, within))
    yield Finding(
        "CW-P153",
        "warning",
        f"Axis {planned.axis.name}: the second table may hold the drift of this test. The reversal"
        f" changes by {risen} along the travel; the drift found, {drifted} from the first run to"
        f" the last, would show {shown} of that within every run, up and down again, with a"
        " constant play. Warm the axis up and measure again before two tables are loaded, or take"
        " one (mode: single)",
    )


def _rise(work: AxisWork) -> float:
    """Return by how much the reversal of the axis itself rises from end to end of the measured
    range, mm or deg: by a straight line.
    """
    estimate, active = work.planned.estimate, work.active
    low, high = estimate.measured
    where = estimate.positions
    inside = (where >= low) & (where <= high)
    reversal = (
        estimate.mean_positive
        - active(where, Direction.POSITIVE)
        - estimate.mean_negative
        + active(where, Direction.NEGATIVE)
    )
    slope = np.polyfit(where[inside] - low, reversal[inside], 1)[0]
    return settled_number(slope * (high - low))
