"""Finding about reversal steps in a table (jumps of the correction where the axis reverses) that
the control never applies.
"""

from __future__ import annotations

from collections.abc import Iterator

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.prediction.dead_zone import unapplied_range
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation


def unapplied_step_findings(axis: Axis, table: AxisCompensation) -> Iterator[Finding]:
    """Yield the finding CW-P156 if the control does not apply some reversal steps of an axis'
    table. The finding states at which axis accelerations the control would apply these steps.
    """
    found = unapplied_range(table, axis)
    if found is None or axis.unapplied_steps is None:
        return
    low, high = found
    least, most = axis.unapplied_steps
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    yield Finding.of(
        "CW-P156",
        "warning",
        axis=axis.name,
        least=least * factor,
        most=most * factor,
        unit=unit,
        reversal=low * factor,
        reversal_to=None if high - low < 5e-3 / factor else high * factor,
        low=low / most,
        high=high / least,
    )
