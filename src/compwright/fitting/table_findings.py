"""Findings about a table: where it is active and where not, and the error that each limit of the
control costs.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from compwright.fitting.problem import bends
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import Limit
from compwright.records.rounding import rounded_number
from compwright.words.sentences import Amount

#: A limit that costs less than this share of a quantum is not worth a word.
LEAST_REPORTED: Final = 0.05
#: A limit is warned of from this rms on (0.05 µm, 0.05 arcsec: no test shows less), and from this
#: share of the standard deviation of one reading: it adds a hundredth to the square of 2 s.
_SHOWN: Final = {AxisKind.LINEAR: 5e-5, AxisKind.ROTARY: 0.05 / 3600.0}
_OF_THE_NOISE: Final = 0.2
#: From this many points beyond the travel on, a finding explains that the control counts from its
#: reference.
_MANY: Final = 5


def display_unit(kind: AxisKind) -> tuple[float, str]:
    """Return the factor from mm to µm or from deg to arcsec, and the unit's name."""
    return (1e3, "µm") if kind.unit == "mm" else (3600.0, "arcsec")


def reportable_costs(costs: list[tuple[str, float]], quantum: float) -> tuple[Limit, ...]:
    """Return those ``costs`` that are larger than the rounding of table values to the resolution
    ``quantum`` (mm or deg) explains. A cost is the rms error (mm or deg) that one cause adds, such
    as a limit of the control.
    """
    rounded = [(cause, rounded_number(value)) for cause, value in costs]
    return tuple(
        Limit(cause, value) for cause, value in rounded if value > LEAST_REPORTED * quantum
    )


def added_rms(larger: float, smaller: float) -> float:
    """Return the rms that has to be added to ``smaller`` to give ``larger``, where rms values add
    as squares.
    """
    return float(np.sqrt(max(0.0, larger**2 - smaller**2)))


def edge_findings(
    table: AxisCompensation, wanted: WantedCorrection, *, kept: bool
) -> tuple[Finding, ...]:
    """Return the findings about the two ends of the table. ``kept``: the table keeps the existing
    points of the control.

    The findings report the correction where the table does not cover the travel, and table points
    beyond the travel. An endless table has no ends and no such findings.
    """
    if table.period is not None:
        return ()
    unit, points, where = wanted.kind.unit, table.positions, wanted.positions
    factor, name_small = display_unit(wanted.kind)
    hair = 1e-6 * float(where[-1] - where[0])
    ends = bends(points, table.interpolation)[[0, -1]]
    findings: list[Finding] = []
    for name, rule, uncovered, edge in (
        ("below", table.below, ends[0] - where[0], 0),
        ("above", table.above, where[-1] - ends[-1], -1),
    ):
        if uncovered > hair:
            step = max(abs(float(table.positive[edge])), abs(float(table.negative[edge])))
            findings.append(
                Finding.of(
                    "CW-F001.held" if rule == "hold" else "CW-F001.step",
                    "warning",
                    uncovered=uncovered,
                    unit=unit,
                    side=name,
                    end=points[edge],
                    step=Amount(step * factor, name_small, "3sig"),
                )
            )
    if kept:
        return tuple(findings)
    beyond = max(float(where[0] - points[0]), float(points[-1] - where[-1]))
    extra = int(np.count_nonzero((points < where[0] - hair) | (points > where[-1] + hair)))
    if (
        beyond > hair
        and not where[0] - hair <= wanted.reference <= where[-1] + hair
        and extra >= _MANY
    ):
        findings.append(
            Finding.of(
                "CW-F006.reference",
                "info",
                reference=wanted.reference,
                unit=unit,
                extra=extra,
                nodes_size=points.size,
            )
        )
    elif beyond > hair:
        findings.append(Finding.of("CW-F006.grid", "info", beyond=beyond, unit=unit))
    return tuple(findings)


def loss_findings(limits: tuple[Limit, ...], wanted: WantedCorrection) -> tuple[Finding, ...]:
    """Return a warning for each limit of the control that adds an error large enough to show in a
    test.
    """
    least = max(_SHOWN[wanted.kind], _OF_THE_NOISE * wanted.noise)
    factor, unit = display_unit(wanted.kind)
    costly = [limit for limit in limits if limit.value >= least]
    lost = ((limit.cause, Amount(limit.value * factor, unit, "2sig")) for limit in costly)
    return tuple(found for cause, left in lost for found in _loss(cause, left))


def _loss(cause: str, left: Amount) -> Iterator[Finding]:
    """Yield the finding about one limit of the control. ``left``: the error that the table leaves
    because of this limit.
    """
    if cause == "number of points":
        yield Finding.of("CW-F004", "warning", left=left)
    elif cause == "no backlash value":
        yield Finding.of("CW-F005", "warning", left=left)
    elif cause == "value range":
        yield Finding.of("CW-F007", "warning", left=left)
    elif cause == "largest increment":
        yield Finding.of("CW-F008", "warning", left=left)
