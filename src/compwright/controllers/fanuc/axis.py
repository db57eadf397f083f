"""The point numbers and interval of a FANUC axis' table, and checks that they are consistent.

A contradiction in the files is added to the faults of `Memory`. An unknown fact is added to its
notes or assumptions. Sources: the docstring of the module ``control``.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from compwright.controllers.fanuc.additional_functions import left_out
from compwright.controllers.fanuc.axis_checks import inclined_without_grid, not_used, stopping
from compwright.controllers.fanuc.memory import Memory, number_list
from compwright.controllers.fanuc.options import Options
from compwright.controllers.fanuc.table import IncrementGrid
from compwright.controllers.request import Request, by_address, finite_number
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind
from compwright.records.correction import Assumption

_GRID = (3620, 3621, 3622, 3623, 3624)
#: The intervals of a turn must fill it to this part of the turn, else point and turn drift apart;
#: printed numbers are exact to 1e-7.
_WHOLE_TURN = 1e-6


class AxisLoader:
    """Builds the tables of axes from the parameter memory, which also collects faults and notes."""

    def __init__(self, memory: Memory, request: Request) -> None:
        self.memory = memory
        self.request = request

    def note(self, axis: int, text: str) -> None:
        """Add a note about an axis to the notes of the control."""
        self.memory.notes.append(f"axis {axis}: {text}")

    def under_work(self, axis: int) -> bool:
        """Return whether the axis is part of the job. Faults of other axes do not stop the
        reading.
        """
        return self.request.is_under_work(str(axis))

    @contextmanager
    def stopping_nothing(self, axis: int) -> Iterator[None]:
        """Turn faults raised inside this context into notes, unless the axis is part of the job."""
        before = len(self.memory.faults)
        yield
        odd = self.memory.faults[before:]
        if odd and not self.under_work(axis):
            del self.memory.faults[before:]
            self.note(axis, f"is odd and left alone: {odd[0].message}")

    def neighbour(self, axis: int, options: Options) -> IncrementGrid | None:
        """Return point numbers and interval of an axis outside the job; None if they contain
        errors.
        """
        with self.stopping_nothing(axis):
            return self.grid(axis, options)

    def grid(self, axis: int, options: Options) -> IncrementGrid | None:
        """Return an axis' point numbers and interval; None if it has no pitch error compensation,
        or, with a fault, if they are invalid.
        """
        before = len(self.memory.faults)
        for remark in left_out(self.memory.machine, axis, options.counted):
            self.note(axis, remark)
        grid = self._grid(axis, options)
        if grid is None and "inclination" in options.counted and len(self.memory.faults) == before:
            self.memory.faults += inclined_without_grid(self.memory, axis)
        return grid

    def _grid(self, axis: int, options: Options) -> IncrementGrid | None:
        before = len(self.memory.faults)
        self.memory.faults += stopping(self.memory, axis, rotary=self.known_rotary(axis) is True)
        values = {number: self.memory.whole(number, axis) for number in _GRID[:-1]}
        absent = [number for number in _GRID if not self.memory.given(number, axis)]
        if len(absent) == len(_GRID):
            self.memory.assumed.append(
                Assumption(
                    f"pitch error compensation of {axis}",
                    "none",
                    "3620 to 3624 are not in the files",
                )
            )
            return None
        if values[3623] == 0 or len(self.memory.faults) > before:
            return None
        if absent:
            self.fault(
                axis,
                f"the pitch parameters of axis {axis} are incomplete",
                "parameters " + number_list(absent),
            )
            return None
        reference, lowest, highest, magnification = (values[number] or 0 for number in _GRID[:-1])
        rotary = self.rotary(axis)
        behind = rotary and lowest == reference + 1 and lowest < highest
        if not lowest <= reference <= highest and not behind:
            found = f"3621 {lowest}, 3620 {reference}, 3622 {highest}"
            self.fault(
                axis,
                f"the point numbers of axis {axis} are not in order",
                "3621 <= 3620 <= 3622",
                found,
            )
            return None
        if lowest == highest:
            self.note(axis, f"3621 = 3622 = {lowest}: no grid, so no pitch error compensation")
            return None
        interval = self.memory.length(3624, axis, rotary=rotary)
        if interval is None:
            return None
        if interval == 0.0:
            self.fault(axis, f"the interval 3624 of axis {axis} is not positive", "above 0", "0")
            return None
        grid = IncrementGrid(
            axis=axis,
            reference=reference,
            lowest=lowest,
            highest=highest,
            magnification=magnification,
            interval=interval,
        )
        grid = self._endless(self._bidirectional(grid), rotary=rotary)
        self._remarks(axis)
        self._check_points(grid, options)
        self.memory.faults += not_used(self.memory, axis)
        return grid if len(self.memory.faults) == before else None

    def known_rotary(self, axis: int) -> bool | None:
        """Return whether an axis is rotary by 1006#0 or by the job; None if neither 1006#0 nor the
        job states the kind.
        """
        bit = self.memory.bit(1006, 0, axis)
        requested = by_address(self.request.kinds, str(axis))
        if bit is not None or requested is not None:
            return bit if bit is not None else requested is AxisKind.ROTARY
        return True if by_address(self.request.modulo, str(axis)) is not None else None

    def rotary(self, axis: int) -> bool:
        """Return whether an axis is rotary: by 1006#0, else by the job, else because 3625 states a
        travel per turn.
        """
        bit = self.memory.bit(1006, 0, axis)
        requested = by_address(self.request.kinds, str(axis))
        if bit is not None:
            if requested is not None and bit != (requested is AxisKind.ROTARY):
                self.note(
                    axis,
                    f"1006#0 = {int(bit)} makes it a {'rotary' if bit else 'linear'} axis, not a"
                    f" {requested.value} one",
                )
            return bit
        known = self.known_rotary(axis)
        if known is not None:
            return known
        unit = self.memory.setting(3624, axis).keyword
        if unit in ("mm", "deg"):
            return unit == "deg"
        turn = self.memory.length(3625, axis, rotary=True)
        rotary = turn is not None and turn > 0.0
        why = "3625 holds a turn" if rotary else "neither 1006 nor the caller says it"
        self.memory.assumed.append(
            Assumption(f"kind of {axis}", "rotary" if rotary else "linear", why)
        )
        return rotary

    def _endless(self, grid: IncrementGrid, *, rotary: bool) -> IncrementGrid:
        """Return ``grid``, with its travel per turn if its points are those of an endless axis.

        ``rotary``: the axis is rotary. A fault is added if an endless axis has points that do not
        cover exactly one turn. An axis counts as endless by the job, or by its first point number.
        Contradictions between the files and the job are faults too. Any other axis is returned
        unchanged, as an axis with ends.
        """
        modulo = finite_number(by_address(self.request.modulo, str(grid.axis)))
        if not rotary:
            if modulo is not None:
                self.fault(
                    grid.axis,
                    f"axis {grid.axis} is linear but was given as endless",
                    "1006#0 = 1",
                    f"modulo {modulo:g}",
                )
            return grid
        turn = (
            self.memory.length(3625, grid.axis, rotary=True)
            or self.memory.machine.turn(grid.axis)
            or 360.0
        )
        covered = (grid.highest - grid.reference) * grid.interval
        behind = grid.lowest == grid.reference + 1
        fits = (behind or grid.lowest == grid.reference) and abs(
            covered - turn
        ) <= _WHOLE_TURN * turn
        if self.memory.machine.is_endless(grid.axis) is False:
            if modulo is not None:
                self.fault(
                    grid.axis,
                    f"axis {grid.axis} has ends (1006#1 = 1) but was given as endless",
                    "no modulo",
                    f"{modulo:g}",
                )
            return grid
        if modulo is not None and abs(modulo - turn) > _WHOLE_TURN * turn:
            self.fault(
                grid.axis,
                f"turn of axis {grid.axis} (3625, 0 means 360)",
                f"{modulo:g} deg",
                f"{turn:g} deg",
            )
        elif fits:
            return replace(grid, turn=turn)
        elif (
            behind
            or modulo is not None
            or (grid.lowest == grid.reference and self._is_endless(grid.axis))
        ):
            count = turn / grid.interval
            self.fault(
                grid.axis,
                f"axis {grid.axis} is endless but its point numbers do not cover one turn",
                f"3621 = 3620 and 3622 = 3620 + {count:g}, a whole number",
                f"3620 {grid.reference}, 3621 {grid.lowest}, 3622 {grid.highest}, interval"
                f" {grid.interval:g} deg",
            )
        else:
            self.note(
                grid.axis, "its numbers do not go once round: taken as a rotary axis with ends"
            )
        return grid

    def _is_endless(self, axis: int) -> bool:
        """Return whether the files define an endless axis: 3625 states its travel per turn, and
        1006#1 is not set.
        """
        return bool(self.memory.length(3625, axis, rotary=True)) and not self.memory.bit(
            1006, 1, axis
        )

    def _bidirectional(self, grid: IncrementGrid) -> IncrementGrid:
        """Return ``grid``, with a second set of points for travel towards - if 3605#0 = 1."""
        bit = self.memory.bit(3605, 0, grid.axis)
        if bit is None:
            self.memory.assumed.append(
                Assumption(
                    f"3605#0 of {grid.axis}", "0", "not in the files: one set for both directions"
                )
            )
        if not bit:
            return grid
        start, offset = self.memory.whole(3626, grid.axis), self.memory.whole(3627, grid.axis)
        absent = [number for number in (3626, 3627) if not self.memory.given(number, grid.axis)]
        if start is None or offset is None:
            if absent:
                self.fault(
                    grid.axis,
                    f"3605#0 of axis {grid.axis} is 1 without its parameters",
                    "parameters " + number_list(absent),
                )
            return grid
        last = start + grid.highest - grid.lowest
        if last > self.memory.series.highest_point:
            self.fault(
                grid.axis,
                f"points for travel towards - of axis {grid.axis}",
                f"last number up to {self.memory.series.highest_point}",
                f"{start} to {last}",
            )
        elif start <= grid.highest and last >= grid.lowest:
            self.fault(
                grid.axis,
                f"the two sets of axis {grid.axis} overlap",
                "3626 clear of 3621 to 3622",
                f"{grid.lowest} to {grid.highest} and {start} to {last}",
            )
        return replace(grid, negative_from=start, offset=offset)

    def _remarks(self, axis: int) -> None:
        """Add notes on settings of the table that compwright does not evaluate."""
        if self.memory.bit(1006, 3, axis):
            self.note(
                axis,
                "1006#3 = 1, diameter programming: positions and 3624 are taken in radius"
                " (unconfirmed)",
            )
        if self.memory.machine.bit(1001, 0, axis):
            self.note(axis, "1001#0 = 1, an inch machine: lengths marked P are inches")
        if self.memory.bit(3605, 2, axis):
            self.note(
                axis,
                "3605#2 = 1 may mean interpolated compensation (bit unsure); option output decides",
            )

    def _check_points(self, grid: IncrementGrid, options: Options) -> None:
        """Add a fault if a point of the table is missing, or its increment is beyond the series'
        limit.
        """
        needless = {
            start
            for start in grid.starts()
            if grid.turn is not None and grid.lowest == grid.reference
        }
        absent = [number for number in grid.numbers() if number not in self.memory.increments]
        if set(absent) - needless:
            what = (
                "contains no pitch data"
                if len(absent) == len(grid.numbers())
                else "lacks pitch data"
            )
            names = number_list(10000 + number for number in absent)
            self.fault(
                grid.axis,
                f"grid of axis {grid.axis} {what} (a separate file, or one cut short?)",
                f"records N{names}",
            )
        for number in grid.numbers():
            if not options.lowest <= self.memory.increments.get(number, 0) <= options.highest:
                self.memory.faults.append(
                    self.memory.points[number].fault(
                        f"the increment of point {number} of axis {grid.axis} is out of range",
                        expected=f"{options.lowest} to {options.highest}",
                    )
                )
        for start in needless:
            last = start + grid.highest - grid.lowest
            if self.memory.increments.get(start) != self.memory.increments.get(last):
                self.note(
                    grid.axis,
                    f"points {start} and {last} are the same section of the turn and should have"
                    " the same value",
                )

    def fault(self, axis: int, message: str, expected: str, found: str = "") -> None:
        """Add a fault about the table of an axis, with the file and line of one of its table
        parameters (36xx) if the files contain any.
        """
        number = next((n for n in (3621, *_GRID) if self.memory.given(n, axis)), None)
        if number is None:
            self.memory.faults.append(
                Fault(
                    message=message,
                    expected=expected,
                    found=found,
                    hint="correct it in the control and export its files again",
                )
            )
            return
        setting = self.memory.setting(number, axis)
        self.memory.faults.append(
            Fault(
                message=message,
                file=setting.file,
                place=f"line {setting.line}",
                expected=expected,
                found=found,
                hint=(
                    "correct this line in a copy of the file, or export it from the control again"
                ),
            )
        )
