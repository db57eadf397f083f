"""What to say where a control never applies a step of the correction."""

from __future__ import annotations

from collections.abc import Iterator

from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.foundations.units import outside_factor, shown_unit
from compwright.prediction.dead_zone import unapplied_range
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation


def never_applied(axis: Axis, table: AxisCompensation) -> Iterator[Finding]:
    """Yield CW-P156 where reversals of a table lie in the zone of steps that are never applied,
    with the accelerations of the axis that would help.
    """
    found = unapplied_range(table, axis)
    if found is None or axis.unapplied_steps is None:
        return
    low, high = found
    least, most = axis.unapplied_steps
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    size = f"{low * factor:.2f}"
    size += "" if high - low < 5e-3 / factor else f" to {high * factor:.2f}"
    yield Finding(
        "CW-P156",
        "warning",
        f"Axis {axis.name}: the control never applies a step of the correction above"
        f" {least * factor:.2f} and up to {most * factor:.2f} {unit}, and the reversal of the table"
        f" is {size} {unit}. After a reversal the old correction stays until the table itself"
        " changes enough; the prediction counts with it. The control applies these steps with an"
        f" acceleration limit of the axis below {significant(low / most, 3)} times the present"
        f" one, or of at least {significant(high / least, 3)} times: change it, and run again",
    )
