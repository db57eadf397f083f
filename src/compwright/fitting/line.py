"""A control without a table: one slope about the reference, and the reversal value."""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.fitting.problem import quadrature
from compwright.fitting.remarks import added, loss_findings, worth_saying
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted import FittedTable, Limit, TableRequest

_HAIR: Final = 1e-6
#: Optimising slope and reversal in turn at least halves the distance each time.
_ROUNDS: Final = 200


def fit_line(wanted: WantedCorrection, capacity: Capacity, request: TableRequest, quantum: float, *, address: str) -> FittedTable:
    """Return the slope, a whole multiple of ``quantum`` (mm/mm, deg/deg), and the backlash of least mean square over the travel.

    Both together are the exact optimum over whole multiples within their ranges. Raises CapacityError where the job asks
    for the grid of a table.
    """
    _refuse_grid(request, capacity)
    line = _Line(wanted)
    slope, backlash = line.best(quantum, capacity)
    home = wanted.reference_return
    reversal = home.opposite.sign * backlash
    bound = line.mean_square(*line.relaxed(capacity.value_range, reversal_range(capacity, home.opposite.sign)))
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
        mode_reason="one slope and one reversal value: the control holds no table",
        certificate={"objective": float(np.sqrt(line.mean_square(slope, reversal))), "lower_bound": float(np.sqrt(bound))},
        limits=limits,
        findings=loss_findings(limits, wanted),
    )


def _refuse_grid(request: TableRequest, capacity: Capacity) -> None:
    asked = {"start": request.start, "end": request.end, "spacing": request.spacing}
    raise_all(
        CapacityError,
        [
            Fault(
                message=f"{capacity.format} holds one slope for this axis, no table",
                place=f"table.{name}",
                expected="nothing",
                found=f"{value:g}",
            )
            for name, value in asked.items()
            if value is not None
        ],
    )


class _Line:
    """The mean square of slope * (x - reference) + reversal - wanted, a quadratic of both."""

    def __init__(self, wanted: WantedCorrection) -> None:
        self.wanted = wanted
        points, self.weights = quadrature(wanted.positions, wanted.positions)
        self.x = points - wanted.reference
        home = wanted.reference_return
        self.own, self.other = (np.interp(points, wanted.positions, wanted.total(direction)) for direction in (home, home.opposite))

    def mean_square(self, slope: float, reversal: float) -> float:
        """Return the mean over the travel and both directions; ``reversal`` acts against the return direction."""
        straight = slope * self.x
        return 0.5 * float(self.weights @ ((straight - self.own) ** 2 + (straight + reversal - self.other) ** 2))

    def curve(self) -> float:
        """Return how fast the mean square grows with the slope while the reversal follows."""
        return 2.0 * float(self.weights @ self.x**2) - float(self.weights @ self.x) ** 2

    def reversal(self, slope: float) -> float:
        """Return the best reversal for a slope."""
        return float(self.weights @ (self.other - slope * self.x))

    def slope(self, reversal: float) -> float:
        """Return the best slope for a reversal."""
        return 0.5 * float(self.weights @ (self.x * (self.own + self.other - reversal))) / float(self.weights @ self.x**2)

    def relaxed(self, slopes: tuple[float, float], reversals: tuple[float, float]) -> tuple[float, float]:
        """Return the best slope and reversal between their ends, without whole numbers, by optimising each in turn."""
        slope = reversal = 0.0
        for _ in range(_ROUNDS):
            before = slope
            slope = float(np.clip(self.slope(reversal), *slopes))
            reversal = float(np.clip(self.reversal(slope), *reversals))
            if slope == before:
                break
        return slope, reversal

    def best(self, quantum: float, capacity: Capacity) -> tuple[float, float]:
        """Return the best whole slope and backlash (as the record counts it).

        For each slope the best whole reversal is the best reversal, rounded and kept in its range. With the reversal following, the
        mean square grows from its least value within the limits at least as ``curve`` (slope - best slope)^2 / 2 (partial
        minimisation keeps a quadratic's strong convexity), so that no slope outside the window can be better than the first one.
        """
        low, high = np.ceil(capacity.value_range[0] / quantum - _HAIR), np.floor(capacity.value_range[1] / quantum + _HAIR)
        sign = self.wanted.reference_return.opposite.sign

        def whole(slope: float) -> float:
            if capacity.backlash_quantum is None:
                return 0.0
            step = capacity.backlash_quantum
            ends = np.ceil(capacity.backlash_range[0] / step - _HAIR), np.floor(capacity.backlash_range[1] / step + _HAIR)
            return float(np.clip(np.round(sign * self.reversal(slope) / step), *ends)) * step

        middle, reversal = self.relaxed((low * quantum, high * quantum), reversal_range(capacity, sign))
        first = float(np.clip(np.round(middle / quantum), low, high)) * quantum
        spare = self.mean_square(first, sign * whole(first)) - self.mean_square(middle, reversal)
        reach = np.sqrt(2.0 * max(0.0, spare) / self.curve()) / quantum + 1.0
        ends = np.clip(np.array([np.floor(middle / quantum - reach), np.ceil(middle / quantum + reach)]), low, high)
        slopes = (np.arange(ends[0], ends[1] + 1.0) * quantum).tolist()
        chosen = min(slopes, key=lambda one: (self.mean_square(one, sign * whole(one)), abs(one)))
        return chosen + 0.0, whole(chosen) + 0.0


def reversal_range(capacity: Capacity, sign: int) -> tuple[float, float]:
    """Return the range of the correction against the return direction, whose ``sign`` is that of the backlash's effect."""
    if capacity.backlash_quantum is None:
        return 0.0, 0.0
    ends = (sign * capacity.backlash_range[0], sign * capacity.backlash_range[1])
    return min(ends), max(ends)


def _limits(line: _Line, capacity: Capacity, quantum: float, held: tuple[float, float]) -> tuple[Limit, ...]:
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
        ("no backlash value", added(open_, straight)),
        ("value range", added(ranged, open_)),
        ("quantum", added(reached, ranged)),
    ]
    length = float(line.wanted.positions[-1] - line.wanted.positions[0])
    return worth_saying(costs, max(quantum * length, capacity.backlash_quantum or 0.0))
