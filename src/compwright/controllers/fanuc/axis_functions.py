"""The compensation of one FANUC axis: pitch error table, backlash, second (cyclic) table.

A contradiction in the files is added to the faults of `Memory`. An unknown fact is added to its
notes or assumptions. Sources: the docstrings of the modules ``control`` and
``additional_functions``.
"""

from __future__ import annotations

import numpy as np

from compwright.controllers.fanuc.additional_functions import (
    CYCLIC,
    CYCLIC_FACTOR,
    Cycle,
    inclination,
)
from compwright.controllers.fanuc.axis import AxisLoader
from compwright.controllers.fanuc.memory import number_list
from compwright.controllers.fanuc.options import Options
from compwright.controllers.fanuc.table import IncrementGrid, PitchTable, totals
from compwright.controllers.fanuc.text import POINT_BASE
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption

#: A turn has to hold a whole number of periods to this part of one.
_WHOLE_PERIODS = 1e-6


def pitch_table(
    loader: AxisLoader, grid: IncrementGrid, options: Options, returning: Direction
) -> PitchTable | None:
    """Return an axis' pitch error table as totals (summed increments), with inclination if the
    options include inclination. ``returning``: the direction of the reference return.

    The totals for travel in the direction of the reference return are 0 at the reference. With
    bidirectional data, 3627 is added to the totals for the other direction. Returns None if
    increments of the table are missing.
    """
    # the number of the reference itself owns no section of an endless axis, and need not be among
    # its numbers
    used = grid.reference + 1 - grid.lowest if grid.turn is not None else 0
    inclined = _inclined(loader, grid, options, used)
    curves = []
    for start in grid.starts():
        numbers = range(start + used, start + grid.highest - grid.lowest + 1)
        if any(number not in loader.memory.increments for number in numbers):
            return None
        increments = [loader.memory.increments[number] for number in numbers]
        curve = totals(increments, grid.reference - grid.lowest + 1 - used)
        _check_turn(loader, grid, int(sum(increments)))
        curves.append(options.pitch_sign * (grid.magnification * curve + inclined))
    positive, negative = curves[0], curves[-1]
    if grid.negative_from is not None:
        offset = (
            options.offset_sign
            * grid.offset
            * (grid.magnification if options.offset_magnified else 1)
        )
        if returning is Direction.POSITIVE:
            negative = negative + offset
        else:
            positive = positive + offset
            loader.note(
                grid.axis,
                "3605#0 with a reference return towards -: 3627 is taken for travel towards +"
                " (unconfirmed)",
            )
    first = grid.lowest - grid.reference - 1 + used
    return PitchTable(
        first=first, interval=grid.interval, turn=grid.turn, positive=positive, negative=negative
    )


def backlash(loader: AxisLoader, axis: int, options: Options) -> int:
    """Return the backlash parameter in detection units: 1851, or 1852 at rapid traverse if 1800#4 =
    1.

    Returns 0 if the files do not contain the parameter. Returns 0 also for an invalid value of an
    axis outside the job.
    """
    memory = loader.memory
    whole = memory.whole if loader.under_work(axis) else memory.whole_if_sound
    feed = whole(1851, axis)
    if not memory.given(1851, axis):
        memory.assumed.append(Assumption(f"backlash 1851 of {axis}", "0", "not in the files"))
    if memory.series.own:
        _rapid_unknown(loader, axis, feed or 0, options)
    if not memory.machine.bit(1800, 4, axis):
        return feed or 0
    rapid = whole(1852, axis)
    if not memory.given(1852, axis):
        memory.assumed.append(
            Assumption(f"backlash 1852 of {axis}", "0", "1800#4 = 1, not in the files")
        )
    if options.rapid:
        return rapid or 0
    if (rapid or 0) != (feed or 0):
        loader.note(
            axis,
            f"1800#4 = 1: at rapid traverse 1852 = {rapid or 0} is active; judged at"
            " cutting feed with 1851",
        )
    return feed or 0


def cycle(
    loader: AxisLoader, axis: int, grid: IncrementGrid | None, options: Options
) -> Cycle | None:
    """Return an axis' second (cyclic) table; None if it has none, if the options exclude it, or,
    with a fault, if it is invalid.

    ``grid``: point numbers and interval of the axis' main table; None if the axis has none.
    """
    memory = loader.memory
    ends = [memory.machine.entry(number, axis) for number in CYCLIC]
    nonzero = [entry for entry in ends[1:] if entry is not None and not entry.zero]
    if "cyclic" not in options.counted or not nonzero:
        return None
    factor = memory.machine.entry(CYCLIC_FACTOR, axis)
    if factor is not None and factor.whole not in (0, 1):
        memory.faults.append(
            factor.fault(f"what 14988 does to the second table of axis {axis} is not known", "1")
        )
    first, last, width = ends
    low, high = (
        0 if entry is None else entry.whole if entry.whole is not None else -1
        for entry in (first, last)
    )
    rotary = loader.known_rotary(axis) is True if grid is None else loader.rotary(axis)
    interval = None if width is None else memory.entry_length(width, axis, rotary=rotary)
    if not 0 <= low < high or last is None or width is None or interval is None or interval <= 0.0:
        memory.faults.append(
            nonzero[0].fault(
                f"the second table of axis {axis} (14985 {low}, 14986 {high})",
                "14985 below 14986, and 14987 above 0 with a decimal point",
            )
        )
        return None
    absent = [number for number in range(low + 1, high + 1) if number not in memory.increments]
    if absent:
        names = number_list(POINT_BASE + number for number in absent)
        memory.faults.append(
            last.fault(f"the second table of axis {axis} lacks pitch data", f"records N{names}")
        )
        return None
    increments = [memory.increments[number] for number in range(low + 1, high + 1)]
    if sum(increments) != 0:
        memory.faults.append(
            last.fault(
                f"the increments of the second table of axis {axis} add up to {sum(increments)}"
                " detection units each period",
                "increments that add up to 0",
            )
        )
        return None
    period = interval * len(increments)
    if grid is not None and grid.turn is not None:
        periods = grid.turn / period
        if abs(periods - round(periods)) > _WHOLE_PERIODS * periods:
            memory.faults.append(
                width.fault(
                    f"the second table of axis {axis} does not fit into the turn of {grid.turn:g}",
                    f"a whole number of its periods of {period:g}",
                )
            )
            return None
    memory.assumed.append(
        Assumption(
            f"second table of {axis}",
            f"period {period:g} from the reference, without 3623 and 14988"
            + ("" if grid is not None else ", main table off"),
            "unconfirmed",
        )
    )
    return Cycle(interval, options.pitch_sign * totals(increments, 0))


def _rapid_unknown(loader: AxisLoader, axis: int, feed: int, options: Options) -> None:
    """Add a fault if the axis moves at rapid traverse and 1852 differs from ``feed``, the value of
    1851: on this series it is unknown whether 1852 is then active.
    """
    rapid = loader.memory.whole_if_sound(1852, axis)
    if options.rapid and rapid is not None and rapid != feed:
        loader.memory.faults.append(
            loader.memory.setting(1852, axis).fault(
                f"whether 1852 is active on axis {axis} at rapid traverse is not known",
                expected=f"{feed}, as 1851, or a test at cutting feed",
            )
        )


def _inclined(loader: AxisLoader, grid: IncrementGrid, options: Options, used: int) -> FloatArray:
    """Return the correction by inclination (k + 1,), in detection units, at the ends of the table's
    sections. ``used``: how many of the first point numbers have no section.

    The correction is 0 if the options exclude inclination. The magnification 3623 does not multiply
    it.
    """
    numbers = np.arange(grid.lowest - 1 + used, grid.highest + 1, dtype=np.float64)
    if "inclination" not in options.counted:
        return np.zeros(numbers.size)
    lines = inclination(loader.memory.machine, grid.axis, loader.memory.faults)
    if lines is None:
        return np.zeros(numbers.size)
    at = lines.at(numbers, grid.reference)
    if grid.turn is not None and at[0] != at[-1]:
        loader.fault(
            grid.axis,
            f"inclination 5871 to 5874 of axis {grid.axis} adds up to {at[-1] - at[0]:g} detection"
            " units each turn",
            "the same amount at both ends of the turn",
        )
    loader.memory.assumed.append(
        Assumption(
            f"inclination of {grid.axis}",
            "with the sign of the pitch data, without 3623, 0 at the reference",
            "unconfirmed",
        )
    )
    return at


def _check_turn(loader: AxisLoader, grid: IncrementGrid, pulses: int) -> None:
    """Add a fault if the increments of one turn of an endless axis do not add up to 0."""
    if grid.turn is not None and pulses != 0:
        creep = pulses * grid.magnification
        loader.fault(
            grid.axis,
            f"the increments of axis {grid.axis} add up to {creep} detection units each turn",
            "increments that add up to 0",
        )
