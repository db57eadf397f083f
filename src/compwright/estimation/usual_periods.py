"""Periods of the error that drives and scales of machine axes usually cause.

The leads of ball screws in mm are the nominal leads of the metric series (ISO 3408-2 (1991), Ball
screws, part 2) and others that are sold. The error of a screw repeats with each turn, and thus at
its lead. Two errors per turn (a coupling out of line, a thread of two starts) repeat at half the
lead. On a rotary axis, one turn of the worm moves the table by 360 deg divided by the teeth of its
wheel.

The frequency of each period is a judgement, from no document. Leads from 4 to 40 mm that drive axes
of machine tools are equally frequent. Finer and steeper leads, leads in inches, magnets and racks
are a quarter as frequent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal

from compwright.records.axis import AxisKind

Cause = Literal["lead", "inch_lead", "half_lead", "magnets", "rack", "worm", "files"]

_INCH: Final = 25.4
#: Weight of rarer periods, relative to a common lead.
_SELDOM: Final = 0.25


@dataclass(frozen=True, slots=True)
class UsualPeriod:
    """A period that machines usually have: its ``size`` in mm or deg and its ``cause``.

    ``number``: a lead in mm or inch, or the ratio of a gear. ``weight``: how frequent the period is
    relative to a common screw lead.
    """

    size: float
    cause: Cause
    number: float
    weight: float = 1.0


def _leads() -> list[UsualPeriod]:
    common = (4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0)
    seldom = (2.0, 2.5, 3.0, 15.0, 30.0, 50.0)
    inch = (0.2, 0.25, 0.5, 1.0)
    return [
        *(UsualPeriod(lead, "lead", lead) for lead in common),
        *(UsualPeriod(lead, "lead", lead, _SELDOM) for lead in seldom),
        *(UsualPeriod(part * _INCH, "inch_lead", part, _SELDOM) for part in inch),
    ]


def _other_causes() -> list[UsualPeriod]:
    """Return the rarer usual periods of linear axes: half a screw lead, the magnet pitch of a
    motor, the pitch of racks.
    """
    return [
        UsualPeriod(7.5, "half_lead", 15.0, _SELDOM),
        UsualPeriod(12.5, "half_lead", 25.0, _SELDOM),
        UsualPeriod(24.0, "magnets", 24.0, _SELDOM),
        UsualPeriod(36.0, "magnets", 36.0, _SELDOM),
        UsualPeriod(60.0, "magnets", 60.0, _SELDOM),
        UsualPeriod(6.6667, "rack", 6.6667, _SELDOM),
        UsualPeriod(13.3333, "rack", 13.3333, _SELDOM),
    ]


#: Teeth of worm wheels and ratios of gears before the table, as divisions of its turn.
_DIVISIONS: Final = (36, 40, 45, 48, 60, 72, 80, 90, 96, 100, 108, 120, 144, 150, 180, 240, 360)

USUAL_PERIODS: Final = {
    AxisKind.LINEAR: tuple(
        sorted((*_leads(), *_other_causes()), key=lambda usual: (usual.size, usual.cause))
    ),
    AxisKind.ROTARY: tuple(UsualPeriod(360.0 / parts, "worm", parts) for parts in _DIVISIONS),
}


def usual_periods(kind: AxisKind, suggested: Sequence[float] = ()) -> tuple[UsualPeriod, ...]:
    """Return the usual periods of a kind of axis, and the ``suggested`` periods (mm or deg). Each
    suggested period is as probable as all usual periods together.
    """
    usual = USUAL_PERIODS[kind]
    total = sum(each.weight for each in usual)
    return (
        *usual,
        *(UsualPeriod(size, "files", size, total) for size in suggested),
    )
