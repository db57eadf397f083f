"""Fit for a control without a table: a slope about the reference, and a backlash value.

A weighted straight line is fitted to the mean of both directions (Draper and Smith, Applied
Regression Analysis, 3rd ed. 1998, chapter 1). Positions are counted from their mean, so that slope
and constant do not depend on each other.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.fitting.certify import rounded_proof
from compwright.fitting.problem import quadrature
from compwright.fitting.table_findings import added_rms, loss_findings, reportable_costs
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, Limit, TableRequest
from compwright.words.sentences import SentenceText, say

_HAIR: Final = 1e-6


def fit_line(
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    quantum: float,
    *,
    address: str,
) -> FittedTable:
    """Return the slope and the backlash value that leave the smallest mean square over the travel.

    The slope is a whole multiple of ``quantum`` (mm/mm, deg/deg) (Draper and Smith 1998, chapter
    1). Slope and backlash value together are the exact optimum over whole multiples within their
    ranges. Raises CapacityError if the job asks for the points of a table.
    """
    _refuse_grid(request, capacity)
    line = _FittedLine(wanted)
    slope, backlash = line.best(quantum, capacity)
    home = wanted.reference_return
    reversal = home.opposite.sign * backlash
    bound = line.mean_square(
        *line.relaxed(capacity.value_range, reversal_range(capacity, home.opposite.sign))
    )
    empty = np.empty(0)
    table = AxisCompensation(
        address=address,
        kind=wanted.kind,
        positions=empty,
        positive=empty,
        negative=empty,
        backlash=backlash,
        reference_return=home,
        slope=slope,
        origin=wanted.reference,
        interpolation=capacity.interpolation,
    )
    limits = _limits(line, capacity, quantum, (slope, reversal))
    return FittedTable(
        compensation=table,
        mode="single",
        mode_reason=SentenceText(say("mode.slope")),
        certificate=rounded_proof(
            {
                "objective": float(np.sqrt(line.mean_square(slope, reversal))),
                "lower_bound": float(np.sqrt(bound)),
            }
        ),
        limits=limits,
        findings=loss_findings(limits, wanted),
    )


def _refuse_grid(request: TableRequest, capacity: Capacity) -> None:
    requested = {"start": request.start, "end": request.end, "spacing": request.named_spacing}
    raise_all(
        CapacityError,
        [
            Fault(
                message=f"{capacity.format} has one slope for this axis, not a table",
                place=f"table.{name}",
                expected=f"`table` without `{name}`",
                found=f"{value:g}",
                hint=f"leave `{name}` out of `table`",
            )
            for name, value in requested.items()
            if value is not None
        ],
    )


class _FittedLine:
    """The mean square error that a straight line leaves: of constant + slope * x + reversal -
    wanted.

    The constant (the datum) may have any value, because it only moves the zero of the axis. It does
    not change the errors of the axis.
    """

    def __init__(self, wanted: WantedCorrection) -> None:
        self.wanted = wanted
        points, self.weights = quadrature(wanted.positions, wanted.positions)
        self.x = points - float(self.weights @ points)
        home = wanted.reference_return
        self.own, self.other = (
            np.interp(points, wanted.positions, wanted.total(direction))
            for direction in (home, home.opposite)
        )

    def mean_square(self, slope: float, reversal: float) -> float:
        """Return the mean square error that the line leaves over travel and both directions.
        ``reversal`` is added in the direction opposite to the reference return.
        """
        straight = slope * self.x
        left = straight - self.own, straight + reversal - self.other
        datum = 0.5 * float(sum(self.weights @ one for one in left))
        return 0.5 * float(sum(self.weights @ (one - datum) ** 2 for one in left))

    def relaxed(
        self, slopes: tuple[float, float], reversals: tuple[float, float]
    ) -> tuple[float, float]:
        """Return the best slope within the range ``slopes`` and the best reversal value within the
        range ``reversals``, not yet rounded.

        Neither depends on the other, because the datum may have any value.
        """
        slope = (
            0.5
            * float(self.weights @ (self.x * (self.own + self.other)))
            / float(self.weights @ self.x**2)
        )
        reversal = float(self.weights @ (self.other - self.own))
        return float(np.clip(slope, *slopes)), float(np.clip(reversal, *reversals))

    def best(self, quantum: float, capacity: Capacity) -> tuple[float, float]:
        """Return the best slope and backlash value as whole multiples of their resolutions.

        Each is the multiple nearest to its optimum within its range. This is exact. As the datum
        may have any value, the mean square is a parabola of the slope plus a parabola of the
        reversal value.
        """
        low, high = (
            np.ceil(capacity.value_range[0] / quantum - _HAIR),
            np.floor(capacity.value_range[1] / quantum + _HAIR),
        )
        sign = self.wanted.reference_return.opposite.sign
        slope, reversal = self.relaxed(
            (low * quantum, high * quantum), reversal_range(capacity, sign)
        )
        whole = float(np.clip(np.round(slope / quantum), low, high)) * quantum
        if capacity.backlash_quantum is None:
            return whole + 0.0, 0.0
        step = capacity.backlash_quantum
        ends = (
            np.ceil(capacity.backlash_range[0] / step - _HAIR),
            np.floor(capacity.backlash_range[1] / step + _HAIR),
        )
        return whole + 0.0, float(np.clip(np.round(sign * reversal / step), *ends)) * step + 0.0


def reversal_range(capacity: Capacity, sign: int) -> tuple[float, float]:
    """Return the range of the reversal value, mm or deg, from the control's range of the backlash
    value. ``sign``: the sign with which the control adds the backlash value in the direction
    opposite to the reference return.
    """
    if capacity.backlash_quantum is None:
        return 0.0, 0.0
    ends = (sign * capacity.backlash_range[0], sign * capacity.backlash_range[1])
    return min(ends), max(ends)


def _limits(
    line: _FittedLine, capacity: Capacity, quantum: float, held: tuple[float, float]
) -> tuple[Limit, ...]:
    anything = (-np.inf, np.inf)
    own = reversal_range(capacity, line.wanted.reference_return.opposite.sign)
    straight, open_, ranged, reached = (
        float(np.sqrt(line.mean_square(*one)))
        for one in (
            line.relaxed(anything, anything),
            line.relaxed(anything, (0.0, 0.0) if capacity.backlash_quantum is None else anything),
            line.relaxed(capacity.value_range, own),
            held,
        )
    )
    costs = [
        ("a straight line instead of a table", straight),
        ("no backlash value", added_rms(open_, straight)),
        ("value range", added_rms(ranged, open_)),
        ("quantum", added_rms(reached, ranged)),
    ]
    length = float(line.wanted.positions[-1] - line.wanted.positions[0])
    return reportable_costs(costs, max(quantum * length, capacity.backlash_quantum or 0.0))
