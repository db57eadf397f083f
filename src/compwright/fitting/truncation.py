"""Detection of wanted corrections that are far too large for the control.

A correction is far too large if the control's value range or increments cut off more of it than the
noise of a reading.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault
from compwright.foundations.numerals import significant
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Direction
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable

#: What is cut off, in quanta or noises of a reading (rms), from which on nothing is fitted.
_FAR: Final = 2.0
_HELP = {
    "value range": "correct the axis mechanically, or in its gear and scale parameters, "
    "then measure again",
    "largest increment": "give a smaller `table: {spacing: ...}`",
}


def truncation_faults(
    fitted: FittedTable, wanted: WantedCorrection, capacity: Capacity
) -> Iterator[Fault]:
    """Yield a fault for each limit that cuts off a significant part of the wanted correction.

    The part is significant if its rms over the travel exceeds both a resolution step and the noise
    of one reading. If less is cut off, the table is used, as the best one under that limit.
    """
    factor, unit = outside_factor(wanted.kind.unit), shown_unit(wanted.kind.unit)
    least = max(capacity.quantum if capacity.line is None else 0.0, wanted.noise)
    for limit in fitted.limits:
        if limit.cause in _HELP and limit.value > least:
            yield Fault(
                message=(
                    "the correction is larger than the control can store "
                    f"({limit.cause}): with the best table, an error of "
                    f"{significant(limit.value * factor, 3)} {unit} rms remains"
                ),
                place="table",
                expected=_held(limit.cause, capacity, factor, unit),
                found=f"a correction that spans {_span(wanted) * factor:.4g} {unit}",
                hint=_HELP[limit.cause],
            )


def range_faults(wanted: WantedCorrection, capacity: Capacity) -> Iterator[Fault]:
    """Yield a fault if ``wanted`` exceeds the control's value range by far, so that a fit would be
    useless.
    """
    if capacity.line is not None:
        return
    factor, unit = outside_factor(wanted.kind.unit), shown_unit(wanted.kind.unit)
    home = wanted.total(wanted.reference_return)
    zero = float(np.interp(wanted.reference, wanted.positions, home))
    cut_off = home - zero - np.clip(home - zero, *capacity.value_range)
    if float(np.sqrt(np.mean(cut_off**2))) > _FAR * max(capacity.quantum, wanted.noise):
        yield Fault(
            message=("the correction is much larger than the control can store (value range)"),
            place="table",
            expected=_held("value range", capacity, factor, unit),
            found=f"a correction that spans {_span(wanted) * factor:.4g} {unit}",
            hint=_HELP["value range"],
        )


def _held(cause: str, capacity: Capacity, factor: float, unit: str) -> str:
    if cause == "largest increment" and capacity.lattice is not None:
        largest = capacity.lattice.increments[1] * capacity.lattice.magnifications[-1]
        return (
            f"steps of at most {largest * capacity.quantum * factor:.4g} {unit} from point to point"
        )
    low, high = capacity.value_range
    if capacity.line is not None:
        return (
            f"a slope from {low * 1000:g} to {high * 1000:g}"
            f" {'mm/m' if unit == 'µm' else 'deg per 1000 deg'}"
        )
    return f"values from {low * factor:g} to {high * factor:g} {unit}"


def _span(wanted: WantedCorrection) -> float:
    totals = np.concatenate([wanted.total(direction) for direction in Direction])
    return float(np.max(totals) - np.min(totals))
