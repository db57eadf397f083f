"""Compare an axis' travel limits in the control's files with the travel in the job, because both
must be in machine coordinates.

A travel in other coordinates would put the table in the wrong place.
"""

from __future__ import annotations

from collections.abc import Callable

from compwright.formats.text.gathering import Gathered
from compwright.formats.text.notes import CORRECT_TRAVEL, Notes
from compwright.records.axis import Axis
from compwright.records.facts import AxisFacts
from compwright.words.sentences import control_text

#: Part of the travel that may lie outside the control's limits without a word, and that is not
#: enough inside: travels are rounded.
_OUTSIDE = 0.05


def check_travel(
    axis: Axis,
    limits: tuple[float, float],
    label: str,
    names: str,
    notes: Notes,
    refuse: Callable[[str, str, str], None],
) -> None:
    """Compare the job's travel with the axis' ``limits`` in the files (low, high; mm or deg;
    ``names``: their names on the control). A travel outside the limits goes to the function
    ``refuse``.

    The arguments of ``refuse`` are the message, the expected value and the value found. A travel
    that is only partly outside the limits is a warning. If the upper limit is not above the lower
    one, the control has no limits set, and nothing is compared.
    """
    low, high = limits
    if not low < high:
        return
    start, end = axis.travel
    if min(end, high) - max(start, low) <= _OUTSIDE * (end - start):
        refuse(
            f"the travel in the job is outside of the travel limits of the axis ({names})",
            f"{low:g} to {high:g}: travel and targets in machine coordinates",
            f"{start:g} to {end:g}",
        )
    elif (outside := max(low - start, 0.0) + max(end - high, 0.0)) > _OUTSIDE * (end - start):
        notes.find(
            "CW-S045",
            "warning",
            axis.address,
            label=label,
            outside=outside,
            unit=axis.kind.unit,
            low=low,
            high=high,
            parameters=names,
        )


def check_limits(
    gathered: Gathered, address: str, axis: Axis, facts: AxisFacts, notes: Notes
) -> None:
    """Compare the limits that the files state for an axis with the travel in the job."""
    if axis.modulo is not None or facts.turn is not None or facts.limits is None:
        return
    places = gathered.found("limit_high", address, None)
    bindings = [gathered.definition.bindings[name] for name in ("limit_low", "limit_high")]
    forms = [gathered.definition.statements[binding.statement].form for binding in bindings]
    names = ", ".join(form.split("{", 1)[0].rstrip(" =[") for form in forms)
    label = control_text("axis {address}", address=address)

    def refuse(message: str, expected: str, found: str) -> None:
        notes.refuse(
            label,
            message,
            places[-1] if places else None,
            expected=expected,
            found=found,
            hint=CORRECT_TRAVEL,
        )

    check_travel(axis, facts.limits, label, names, notes, refuse)
