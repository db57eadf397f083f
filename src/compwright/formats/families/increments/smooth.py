"""Smooth backlash: after a reversal a part of the backlash is output at once and the rest on the
way, between two distances.

After the second distance the whole of 1851 (1852) has been output, so that a target further away
from the reversal sees the plain backlash. Which of 1846 to 1849 is a distance and which a part is
from memory: the largest of them is taken for the distance.
"""

from __future__ import annotations

from dataclasses import dataclass

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import AxisParameters, ParameterValue
from compwright.formats.text.notes import Notes
from compwright.records.axis import AxisKind

#: A test turns further outside its first and last target than this, mm or deg: the standard's
#: cycles overrun by more, so that its targets see the whole backlash.
NEAR = 1.0


@dataclass(frozen=True, slots=True)
class SmoothBacklash:
    """The parameters that are not zero."""

    values: tuple[ParameterValue, ...]

    def note(self, label: str, kind: AxisKind, unit: float, notes: Notes) -> None:
        """Note its effect, and the fault if it may reach to targets of a test. ``unit``: the
        detection unit.
        """
        farthest = max(self.values, key=lambda value: abs(value.whole))
        reach = abs(farthest.whole) * unit
        names = [value.label for value in self.values]
        notes.find("CW-S047", "warning", label=label, parameters=names, reach=reach, unit=kind.unit)
        if reach <= NEAR:
            return
        fault = farthest.fault(
            f"{label}: smooth backlash compensation divides 1851 into stages, perhaps up to"
            f" {reach:g} {kind.unit} behind a reversal: what a target of a test saw is not known",
            f"at most {NEAR:g} {kind.unit} in detection units of {unit:g}, or 0 and a new test",
        )
        notes.faults.append(fault)


def smooth_backlash(own: AxisParameters) -> SmoothBacklash | None:
    """Return the smooth backlash of an axis; None without one."""
    values = (own.get(number) for number in known.SMOOTH_BACKLASH)
    active = tuple(value for value in values if value is not None and value.nonzero)
    return SmoothBacklash(active) if active else None


def first_stage(own: AxisParameters) -> int:
    """Return the part that is output at once (1848), detection units; 0 without."""
    value = own.get(known.SMOOTH_FIRST)
    return 0 if value is None else value.whole


def covers(backlash: int | None, stage: int) -> bool:
    """Return whether the whole backlash contains the part that is output at once: same sign, and
    not smaller.
    """
    return stage == 0 or (backlash is not None and backlash * stage >= stage * stage)
