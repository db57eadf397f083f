"""What to check on a control when a table does not have the planned effect: sentences of the
definition, by verdict, filled in for one axis.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from compwright.formats.card import axis_values
from compwright.formats.definition.schema import LookRule
from compwright.formats.definition.statements import field_names, print_form
from compwright.formats.families.family import Family
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation
from compwright.records.verification import LoadingName


def look_at(
    control: Family, axis: Axis, compensation: AxisCompensation
) -> Mapping[LoadingName, tuple[str, ...]]:
    """Return, by verdict of loading, what to check on a control for an axis; empty if its
    definition does not state it.

    ``compensation``: the table that was to be loaded, which decides between texts for one and for
    two curves. A sentence that no manual confirms says so. ``loaded``: the check that the planned
    table is active, if the test would show the same with another one.
    """
    values = axis_values(control.definition, axis)
    pair = not np.array_equal(compensation.positive, compensation.negative)
    return {
        verdict: tuple(_sentences(rules, values, pair=pair))
        for verdict, rules in control.definition.look_at.items()
    }


def _sentences(
    rules: tuple[LookRule, ...], values: Mapping[str, str], *, pair: bool
) -> Iterator[str]:
    for rule in rules:
        form = rule.two_curves if pair else rule.text
        text = print_form(form, {name: values[name] for name in field_names(form)})
        state = rule.evidence.state
        yield text if state == "confirmed" else f"{text} ({state})"
