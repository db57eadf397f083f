"""Periods that the drive or the scale of an axis usually puts into its error, with their reason.

Leads of ball screws in mm: ISO 3408-2 (1991), Ball screws, part 2, nominal leads of the metric
series, and steeper ones; 5, 10 and 20 are met most, then 6, 8, 12 and 16. One turn of the screw
repeats at its lead; two bumps a turn (a coupling out of line, a thread of two starts) at half of
it. Of a rotary axis: one turn of the worm moves the table by 360 deg over the teeth of its wheel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from compwright.records.axis import AxisKind

_INCH: Final = 25.4


@dataclass(frozen=True, slots=True)
class UsualPeriod:
    """``size`` in mm or deg, its ``reason`` in words, and how often it is met beside others."""

    size: float
    reason: str
    weight: float = 1.0


def _leads() -> list[UsualPeriod]:
    most, often = (5.0, 10.0, 20.0), (6.0, 8.0, 12.0, 16.0)
    metric = (2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 15.0, 16.0, 20.0, 25.0, 30.0, 32.0)
    steep = (40.0, 50.0)
    inch = (0.2, 0.25, 0.5, 1.0)
    found = [
        UsualPeriod(
            lead,
            f"a screw lead of {lead:g} mm",
            4.0 if lead in most else 3.0 if lead in often else 0.5,
        )
        for lead in (*metric, *steep)
    ]
    return found + [
        UsualPeriod(part * _INCH, f"a screw lead of {part:g} inch", 0.25) for part in inch
    ]


def _beside_leads() -> list[UsualPeriod]:
    """Scales and drives other than screws; half leads that are no lead themselves."""
    return [
        UsualPeriod(7.5, "half a screw lead of 15 mm", 0.25),
        UsualPeriod(12.5, "half a screw lead of 25 mm", 0.25),
        UsualPeriod(24.0, "a pair of magnets of a linear motor", 0.25),
        UsualPeriod(36.0, "a pair of magnets of a linear motor", 0.25),
        UsualPeriod(60.0, "a pair of magnets of a linear motor", 0.25),
        UsualPeriod(6.6667, "a tooth of a helical rack", 0.25),
        UsualPeriod(13.3333, "a tooth of a helical rack", 0.25),
    ]


#: Teeth of worm wheels and ratios of gears before the table, as divisions of its turn.
_DIVISIONS: Final = (36, 40, 45, 48, 60, 72, 80, 90, 96, 100, 108, 120, 144, 150, 180, 240, 360)

USUAL_PERIODS: Final = {
    AxisKind.LINEAR: tuple(
        sorted((*_leads(), *_beside_leads()), key=lambda usual: (usual.size, usual.reason))
    ),
    AxisKind.ROTARY: tuple(
        UsualPeriod(360.0 / parts, f"a turn of a worm or motor, 1/{parts} of the table's")
        for parts in _DIVISIONS
    ),
}


def usual_periods(kind: AxisKind, suggested: Sequence[float] = ()) -> tuple[UsualPeriod, ...]:
    """Return the usual periods of a kind of axis, and beside them the ``suggested`` ones (mm or
    deg), each as often met as all others together.
    """
    usual = USUAL_PERIODS[kind]
    total = sum(each.weight for each in usual)
    return (
        *usual,
        *(UsualPeriod(size, "what the control's own files suggest", total) for size in suggested),
    )
