"""Lead of an axis' screw, suggested by its reference counter: offered with its evidence, never
taken without a message.
"""

from __future__ import annotations

from dataclasses import dataclass

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.detection_unit import detection_unit
from compwright.formats.families.increments.parameters import AxisParameters
from compwright.records.axis import AxisKind
from compwright.words.sentences import say

#: Lengths are the same within this part: what a job says in few digits.
_SAME_LENGTH = 1e-3


@dataclass(frozen=True, slots=True)
class Lead:
    """Travel of one turn of the motor, mm or deg, and the parameters that suggest it, in words."""

    size: float
    evidence: str


def screw_lead(own: AxisParameters, kind: AxisKind) -> Lead | None:
    """Return the travel between two marks of the encoder on the motor; None if the files do not
    state it.

    1821 counts detection units from one mark to the next: a turn of the motor, on a screw its lead
    (B-63943EN-1/02 page 109). With a separate detector (1815#1 = 1, from memory) it is the distance
    of the marks of a scale, and unrelated to a screw.
    """
    unit, counter = detection_unit(own, kind), own.get(known.REFERENCE_COUNTER)
    if unit is None or counter is None or own.bit(known.ENCODER, 1) is not False:
        return None
    size = round(counter.whole * unit.size, 9)
    if size <= 0 or (kind is AxisKind.ROTARY and size >= 360.0):
        return None
    evidence = (
        f"1821 = {counter.text} detection units of {unit.size:g} {kind.unit} between two marks,"
        " encoder on the motor (1815#1 = 0); inferred"
    )
    return Lead(size, evidence)


def tell_lead(values: IncrementAxisValues, kind: AxisKind) -> None:
    """Note the suggested lead if the job names no period, or another one."""
    lead = screw_lead(values.own, kind)
    if values.axis is None or lead is None:
        return
    named = values.axis.screw_pitch
    if any(abs(period - lead.size) <= _SAME_LENGTH * lead.size for period in named):
        return
    suggested = say(
        "CW-S049.suggested",
        label=values.label,
        lead=lead.size,
        unit=kind.unit,
        evidence=lead.evidence,
    )
    if named:
        values.notes.find("CW-S049.other", "warning", suggested=suggested, periods=named)
        return
    values.notes.find("CW-S049.none", "info", suggested=suggested, lead=lead.size)
