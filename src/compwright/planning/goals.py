"""What a goal of the fit costs and gains, out of sample."""

from __future__ import annotations

from collections.abc import Iterator

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.axes import AxisWork
from compwright.planning.fresh import FreshTests
from compwright.prediction.acting import Correction, difference

#: What is told: of both directions, or of the one that was measured.
_TOLD = ("A", "E", "M")
_TOLD_OF_ONE = ("A_positive", "E_positive", "A_negative", "E_negative")


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
    unit = planned.axis.kind.unit
    factor, small = outside_factor(unit), shown_unit(unit)
    names = [name for name in _TOLD if name in mine] or [n for n in _TOLD_OF_ONE if n in mine]
    shown = ", ".join(
        f"{name} {mine[name].median * factor:.2f} ({usual[name].median * factor:.2f})"
        for name in names
    )
    yield Finding(
        "CW-P152",
        "info",
        f"Axis {planned.axis.name}: made for the least {planned.request.goal}; expected at new"
        f" targets, in brackets with the table of least expected square: {shown} {small}",
    )
