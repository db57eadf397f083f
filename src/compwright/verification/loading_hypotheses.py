"""The correction at the targets of a test for each hypothesis about how the table was loaded."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from compwright.records.axis import FloatArray
from compwright.records.verification import LoadingName
from compwright.verification import partial_table_faults, whole_table_faults
from compwright.verification.hypothesis import Hypothesis, Loading
from compwright.verification.hypothesis_builder import HypothesisBuilder

#: Where the values that were read back from the control are those of the plan, a fault of the
#: values is this much less likely. ``inverted`` is none of these: a control whose sign is another
#: than was taken (error for correction) turns the effect of values that are those of the plan.
_READ_BACK: Final = 0.01
OF_VALUES: Final = frozenset[LoadingName](
    (
        *("scaled", "shifted", "mirrored", "wrong_axis", "one_direction", "backlash", "partial"),
        *("increment", "on_top"),
    )
)
_FAULTS: Final = (
    whole_table_faults.inactive,
    whole_table_faults.with_existing,
    whole_table_faults.inverted,
    whole_table_faults.scaled,
    whole_table_faults.shifted,
    whole_table_faults.in_order_of_positions,
    whole_table_faults.mirrored,
    whole_table_faults.wrong_axis,
    partial_table_faults.one_direction,
    partial_table_faults.wrong_backlash,
    partial_table_faults.partial,
    partial_table_faults.cut_off,
)


def loading_hypotheses(loading: Loading, targets: FloatArray) -> tuple[Hypothesis, ...]:
    """Return every hypothesis about loading the table, with its correction at ``targets`` (m,)."""
    ways = HypothesisBuilder(loading, targets)
    found = [ways.made("loaded", ways.total(ways.own), 1.0)]
    found += [way for fault in _FAULTS for way in fault(ways)]
    if not loading.read_back:
        return tuple(found)
    return tuple(
        replace(way, weight=_READ_BACK * way.weight) if way.name in OF_VALUES else way
        for way in found
    )
