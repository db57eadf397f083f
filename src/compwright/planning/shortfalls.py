"""The parts of the wanted correction that a table cannot reproduce, as one curve per cause.

The sum of these curves is everything that the table lacks. There are three causes. A single curve
cannot reproduce a reversal that varies along the travel. Straight lines between the points cannot
reproduce bends; the size of this part follows from the best curve on the same points without limits
of value. The rest comes from limits of value and from whole numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.fitting.endless_axis import over_one_period
from compwright.fitting.fit import fit_table
from compwright.fitting.grid import choose_grid
from compwright.fitting.unresolved_periods import resolved_part
from compwright.foundations.errors import CapacityError
from compwright.foundations.findings import Finding
from compwright.planning.wanted_correction import without_kept_tables
from compwright.prediction.active_corrections import Correction, difference
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest

PERIOD: Final = "spacing too wide for the period"
REVERSAL: Final = "one table for both directions"
NO_BACKLASH: Final = "no backlash value"
QUANTUM: Final = "quantum"
#: What the fit calls that which lies between the points, and what lies in the values.
_POINTS: Final = ("number of points", "spacing of the points")
_LINE: Final = "a straight line instead of a table"
_VALUES: Final = (QUANTUM, "value range", "backlash range", "largest increment", _LINE)
#: A quantum (mm or deg) that no table shows.
_FINE: Final = 1e-9


@dataclass(frozen=True, slots=True)
class Shortfall:
    """The part of the wanted correction that a table lacks for one ``cause``, mm or deg.

    ``rms``: the rms error that the fit states for this cause, or None if it states none.
    """

    cause: str
    curve: Correction
    rms: float | None


def shortfalls(
    wanted: WantedCorrection, fitted: FittedTable, capacity: Capacity
) -> tuple[Shortfall, ...]:
    """Return what the ``fitted`` table lacks of the ``wanted`` correction (totals), by cause.

    A constant is removed from each curve, because it only moves the datum. Causes without any
    effect are left out.
    """
    rms = {limit.cause: limit.value for limit in fitted.limits}
    return tuple(
        Shortfall(cause, curve, rms.get(cause))
        for cause, curve in _parts(wanted, fitted, capacity, rms)
        if cause in rms or _moves(curve, wanted.positions)
    )


def unheld_period(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest
) -> tuple[Shortfall, Finding] | None:
    """Return the part of the wanted correction with periods too short for the requested table
    points, and the finding about this part, or None if there is no such part.
    """
    if capacity.line is not None or not wanted.periods:
        return None
    own = without_kept_tables(wanted, capacity.stays)
    turn = capacity.period
    over = own if turn is None else over_one_period(own, turn)
    try:
        grid = choose_grid(over, capacity, request)
    except CapacityError:
        return None
    finding = next((one for one in grid.findings if one.code == "CW-F002"), None)
    if finding is None:
        return None
    held = resolved_part(grid.points, own, capacity)
    return Shortfall(PERIOD, difference(as_curve(held), as_curve(own)), grid.left_out), finding


def _parts(
    wanted: WantedCorrection,
    fitted: FittedTable,
    capacity: Capacity,
    rms: Mapping[str, float],
) -> Iterator[tuple[str, Correction]]:
    table, own = _alone(fitted.compensation, wanted)
    points = table.positions
    held = resolved_part(points, own, capacity) if points.size > 1 else own
    yield PERIOD, difference(as_curve(held), as_curve(own))
    rest = difference(table.at, as_curve(held))
    if table.positions.size:
        best = _best(held, table, capacity).at
        yield (
            next((name for name in _POINTS if name in rms), _POINTS[-1]),
            difference(best, as_curve(held)),
        )
        rest = difference(table.at, best)
    if fitted.mode == "single":
        whole = rest
        level = float(np.mean(_half(whole, wanted.positions)))
        varying = _odd(lambda x: _half(whole, x) - level)
        yield REVERSAL, varying
        rest = difference(rest, varying)
        if NO_BACKLASH in rms:
            constant = _odd(lambda x: np.full(np.shape(x), level))
            yield NO_BACKLASH, constant
            rest = difference(rest, constant)
    yield max(_VALUES, key=lambda name: rms.get(name, 0.0)), rest


def _alone(
    held: AxisCompensation, wanted: WantedCorrection
) -> tuple[AxisCompensation, WantedCorrection]:
    """Return the new table in ``held`` alone, and the wanted correction minus the existing tables
    in ``held`` that stay active.
    """
    if not held.others:
        return held, wanted
    return replace(held, others=()), without_kept_tables(wanted, held.others)


def _best(
    wanted: WantedCorrection, table: AxisCompensation, capacity: Capacity
) -> AxisCompensation:
    """Return the best curves for + and − at the points of ``table`` without limits on values."""
    free = replace(
        capacity,
        curves=2,
        second_curve="chosen",
        quantum=_FINE,
        value_range=(-np.inf, np.inf),
        backlash_range=(-np.inf, np.inf),
        lattice=None,
        zero=None,
        stays=(),
        points=tuple(table.positions.tolist()),
    )
    request = TableRequest(mode="bidirectional")
    plain = replace(wanted, periods=())
    return fit_table(plain, free, request, address=table.address, costs=False).compensation


def as_curve(wanted: WantedCorrection) -> Correction:
    """Return the ``wanted`` correction (totals, mm or deg) as a function of position and
    direction.
    """
    return lambda x, way: np.interp(x, wanted.positions, wanted.total(way))


def _half(curve: Correction, positions: FloatArray) -> FloatArray:
    """Return half the difference of ``curve`` between + and − at ``positions``."""
    plus, minus = (curve(positions, way) for way in Direction)
    return 0.5 * (plus - minus)


def _odd(half: Callable[[FloatArray], FloatArray]) -> Correction:
    return lambda x, way: way.sign * half(x)


def _moves(curve: Correction, positions: FloatArray) -> bool:
    return any(float(np.ptp(curve(positions, way))) > _FINE for way in Direction) or (
        abs(float(_half(curve, positions)[0])) > _FINE
    )
