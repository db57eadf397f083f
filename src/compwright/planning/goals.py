"""What a goal of the fit costs and gains, out of sample."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axes import AxisWork
from compwright.planning.fresh import FreshTests
from compwright.prediction.acting import Correction, difference
from compwright.records.fitted import FittedTable

#: What is told: of both directions, of the one that was measured, or of VDI/DGQ 3441.
_TOLD: Final = (
    ("A", "E", "M"),
    ("A_positive", "E_positive", "A_negative", "E_negative"),
    ("P", "Pa"),
)


def goal_told(work: AxisWork, new: Correction, fresh: FreshTests) -> Iterator[Finding]:
    """Yield what ``fresh`` tests at new targets show of A, E and M with ``new``, made for another
    goal than the least expected square, beside what that one would show (CW-P152).
    """
    planned = work.planned
    if work.usual is None or planned.fitted is None:
        return
    mine, usual = (
        fresh.quantiles(difference(acts, work.active)) for acts in (new, work.usual.compensation.at)
    )
    goal, same = planned.request.goal, _alike(planned.fitted, work.usual)
    unit = planned.axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    names = next(found for told in _TOLD if (found := [name for name in told if name in mine]))
    shown = ", ".join(
        f"{name} {mine[name].median * factor:.2f}"
        + ("" if same else f" ({usual[name].median * factor:.2f})")
        for name in names
    )
    made = (
        f"the table of least expected square is the one of least {goal} too"
        if same
        else f"made for the least {goal}"
    )
    beside = "" if same else ", in brackets with the table of least expected square"
    yield Finding(
        "CW-P152",
        "info",
        f"Axis {planned.axis.name}: {made}; expected at new targets{beside}: {shown} {small}",
    )


def _alike(one: FittedTable, other: FittedTable) -> bool:
    mine, usual = one.compensation, other.compensation
    return (
        np.array_equal(mine.positive, usual.positive)
        and np.array_equal(mine.negative, usual.negative)
        and mine.backlash == usual.backlash
    )
