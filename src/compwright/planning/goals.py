"""What a goal of the fit costs and gains, out of sample."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from compwright.fitting.whole import GOAL_LEFT
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axes import AxisWork
from compwright.planning.fresh import FreshTests
from compwright.planning.scenarios import alike
from compwright.prediction.acting import Correction, difference
from compwright.records.fitted import FittedTable, Goal

#: What is told: of both directions, of the one that was measured, or of VDI/DGQ 3441.
_TOLD: Final = (
    ("A", "E", "M"),
    ("A_positive", "E_positive", "A_negative", "E_negative"),
    ("P", "Pa"),
)


def goal_told(work: AxisWork, new: Correction, fresh: FreshTests) -> Iterator[Finding]:
    """Yield what ``fresh`` tests at new targets show of A, E and M with ``new``, and with the table
    that was not taken, where the job has another goal than the least expected square (CW-P152).
    """
    planned, goal = work.planned, work.entry.table.goal
    if work.beside is None or planned.fitted is None:
        return
    mine, others = (
        fresh.quantiles(difference(acts, work.active))
        for acts in (new, work.beside.compensation.at)
    )
    same = alike(planned.fitted, work.beside)
    unit = planned.axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    names = next(found for told in _TOLD if (found := [name for name in told if name in mine]))
    shown = ", ".join(
        f"{name} {mine[name].median * factor:.2f}"
        + ("" if same else f" ({others[name].median * factor:.2f})")
        for name in names
    )
    made, beside = _made(goal, planned.fitted, same=same, taken=planned.request.goal == goal)
    yield Finding(
        "CW-P152",
        "info",
        f"Axis {planned.axis.name}: {made}; expected at new targets{beside}: {shown} {small}",
    )


def _made(goal: Goal, table: FittedTable, *, same: bool, taken: bool) -> tuple[str, str]:
    """Return what was made for the ``goal``, and what stands in brackets beside it."""
    if any(finding.code == GOAL_LEFT for finding in table.findings):
        return f"the table of least expected square is taken, not one for the least {goal}", ""
    if same:
        return f"the table of least expected square is the one of least {goal} too", ""
    if taken:
        return f"made for the least {goal}", ", in brackets with the table of least expected square"
    return (
        f"a table made for the least {goal} shows no less of it in tests that it has not seen, so"
        " the table of least expected square is taken"
    ), f", in brackets with the one made for {goal}"
