"""FANUC virtual control: stored pitch error compensation, backlash, and further functions.

The rules are taken from the manuals, independently of the definition that writes the files. The
word practice marks a rule that no manual page confirms.

- 3620 is the point number of the reference. 3621 is the most negative number, 3622 the most
  positive one. 3623 is the magnification, 3624 the interval. The data are increments (0i-PB
  parameter manual B-63980EN/01 p. 100; sums of increments: ``table``). Correction = pulses * 3623 *
  detection unit. A positive pulse moves the axis towards + (practice; option ``pitch_sign``).
- Endless rotary axis: 3621 = 3620 and 3622 = 3620 + turn / interval. The increments of a turn add
  up to 0 (B-63980EN/01 p. 100).
- 3605#0 = 1: the table has two sets of points. The numbers 3621 to 3622 apply to travel towards +.
  As many numbers, from 3626 on, apply to travel towards -. 3627 is the correction at the reference,
  approached against the direction of the reference return (A-77810E, section 2).
- Backlash 1851, in detection units: it adds nothing in the direction of the reference return. On
  reversal the whole value is added in the direction of motion (0i-C parameter manual B-64120EN/01
  p. 116): sgn(d) * 1851 * detection unit. It is active together with bidirectional data (practice).
- If 1800#4 = 1, 1852 replaces 1851 at rapid traverse (21i parameter manual B-63090EN/02 p. 97).
- Inclination, second (cyclic) table, straightness: ``additional_functions``. Each is included in
  the correction if the option of its name is ``available``. Else it is left unchanged and reported.
- No compensation is active before the reference return: the points begin at the reference position.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.controllers.fanuc.additional_functions import Cycle, cyclic_numbers
from compwright.controllers.fanuc.axis import AxisLoader
from compwright.controllers.fanuc.axis_functions import backlash, cycle, pitch_table
from compwright.controllers.fanuc.bending import Bending, bending_of
from compwright.controllers.fanuc.machine import FINEST_CONFIRMED, read_machine
from compwright.controllers.fanuc.memory import Memory, number_list
from compwright.controllers.fanuc.options import Options, read_options
from compwright.controllers.fanuc.series import (
    ControlSeries,
)
from compwright.controllers.fanuc.sheet import is_sheet, read_sheet
from compwright.controllers.fanuc.table import IncrementGrid, PitchTable
from compwright.controllers.fanuc.text import POINT_BASE, read_file
from compwright.controllers.request import Request, by_address, unknown_axis
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile

#: Two detection units are the same within this part.
_SAME_UNIT = 1e-4


@dataclass(frozen=True, slots=True)
class _FanucAxis:
    """One axis of the virtual FANUC.

    ``backlash``: detection units. ``unit``: mm or deg per detection unit, None if unknown.
    """

    table: PitchTable | None
    cycle: Cycle | None
    backlash: int
    unit: float | None
    ramp: bool
    reference: float
    reference_return: Direction


@dataclass(frozen=True, slots=True)
class FanucControl:
    """A FANUC with loaded files and all axes referenced; interface
    ``controllers.virtual_control.VirtualControl``.

    The axes move at cutting feed, or at rapid traverse if the option ``motion`` is ``rapid``. The
    address of an axis is its controlled axis number as text, ``"1"``.
    """

    axes: dict[str, _FanucAxis]
    bent: tuple[Bending, ...]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the controlled axes in the files, ascending."""
        return tuple(self.axes)

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of the section ends, mm or deg; empty without a table."""
        axis = self._axis(address)
        return np.empty(0) if axis.table is None else axis.table.positions() + axis.reference

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape), approached in ``direction``; mm or
        deg.

        Raises UsageError for an axis that is not in the files. Raises UsageError also if a
        compensation of the axis is active but its detection unit is unknown.
        """
        axis = self._axis(address)
        x = np.asarray(positions, dtype=np.float64)
        if axis.table is None and axis.cycle is None and axis.backlash == 0:
            return np.zeros(x.shape)
        if axis.unit is None:
            raise UsageError(_no_unit(address))
        pulses = np.zeros(x.shape)
        if axis.table is not None:
            pulses = axis.table.pulses(
                x - axis.reference, positive=direction is Direction.POSITIVE, ramp=axis.ramp
            )
        if axis.cycle is not None:
            pulses = pulses + axis.cycle.pulses(x - axis.reference, ramp=axis.ramp)
        if direction is not axis.reference_return:
            pulses = pulses + direction.sign * axis.backlash
        return np.asarray(axis.unit * pulses, dtype=np.float64)

    def cross(self) -> tuple[tuple[str, str], ...]:
        """Return (moving axis, corrected axis) of each pair with straightness compensation."""
        return tuple(dict.fromkeys((entry.moving, entry.bent) for entry in self.bent))

    def cross_correction(  # the protocol's names
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,
        direction: Direction,  # noqa: ARG002  # the same in both
    ) -> FloatArray:
        """Return the correction of ``output`` with ``input`` at ``positions`` (any shape), mm or
        deg of the output.

        The correction is the same in both directions. Raises UsageError for a pair of axes without
        straightness compensation, or if the options exclude it.
        """
        wanted = (input.strip(), output.strip())
        entries = [entry for entry in self.bent if (entry.moving, entry.bent) == wanted]
        if not entries:
            raise UsageError(
                Fault(
                    message=(
                        f"the control's files contain no active table that corrects {output} "
                        f"over the position of {input}"
                    ),
                    expected=" or ".join(f"{bent} over {moving}" for moving, bent in self.cross()),
                    found=f"a job entry for {output} over {input}",
                    hint=("correct the entry `cross` of the job, or give the file with this table"),
                )
            )
        x = np.asarray(positions, dtype=np.float64)
        return np.asarray(sum((entry.at(x) for entry in entries), np.zeros(x.shape)))

    def _axis(self, address: str) -> _FanucAxis:
        axis = by_address(self.axes, address)
        if axis is None:
            raise unknown_axis(address, self.addresses())
        return axis


def fanuc_control(
    files: Sequence[ControlFile], request: Request, *, series: ControlSeries
) -> FanucControl:
    """Return a control of a series with its files loaded, in any order: parameters, pitch data,
    entry sheets.

    Options of the job: ``detection_unit`` (mm or deg per pulse, required if the files do not state
    it), ``output`` (step, ramp), ``motion`` (feed, rapid), ``increment_limit``, ``pitch_sign``,
    ``offset_sign``, ``offset_magnified``. ``inclination``, ``cyclic`` and ``straightness`` are each
    absent or available.

    Raises InputError for data that the control would not accept and for contradictions, each fault
    with file and line. Raises UsageError for wrong options, and if no axis has a detection unit.
    """
    memory = _memory(files, request, series)
    options = _options(request, memory, series)
    loader = AxisLoader(memory, request)
    grids = {
        axis: loader.grid(axis, options[axis]) for axis in memory.axes() if loader.under_work(axis)
    }
    grids |= {
        axis: loader.neighbour(axis, options[axis]) for axis in memory.axes() if axis not in grids
    }
    _note_shared(loader, {axis: grid for axis, grid in grids.items() if grid is not None})
    axes = {}
    for axis, grid in grids.items():
        with loader.stopping_nothing(axis):
            axes[str(axis)] = _axis(loader, axis, grid, options[axis])
    bent = tuple(bending_of(loader, grids, options))
    raise_all(
        InputError,
        [
            replace(
                fault,
                message=series.with_own_numbers(fault.message),
                expected=series.with_own_numbers(fault.expected),
                found=series.with_own_numbers(fault.found),
            )
            for fault in dict.fromkeys(memory.faults)
        ],
    )
    return FanucControl(
        axes=axes,
        bent=bent,
        assumed=tuple(
            replace(
                entry,
                fact=series.with_own_numbers(entry.fact),
                evidence=series.with_own_numbers(entry.evidence),
            )
            for entry in dict.fromkeys(memory.assumed)
        ),
        notes=tuple(series.with_own_numbers(note) for note in dict.fromkeys(memory.notes)),
    )


def _memory(files: Sequence[ControlFile], request: Request, series: ControlSeries) -> Memory:
    """Return the contents of all files; a file without compensation parameters is a fault."""

    def pitch_sign(address: str) -> str:
        return str(request.options_of(address).get("pitch_sign", "+"))

    sheets = [read_sheet(file, pitch_sign, series) for file in files if is_sheet(file)]
    texts = [file for file in files if not is_sheet(file)]
    machine = read_machine(texts, series)
    machine.typed(setting for sheet in sheets for setting in sheet.settings)
    memory = Memory([*(read_file(file, series) for file in texts), *sheets], series, machine)
    if not memory.axes() and not memory.faults:
        memory.faults.append(
            Fault(
                message="the files contain no compensation parameters",
                file=", ".join(file.name for file in files),
                expected="parameters 3620 to 3624 or 1851",
                found="pitch data only" if memory.points else "",
                hint="give the parameter file of the control, not only the pitch data",
            )
        )
    return memory


def _options(request: Request, memory: Memory, series: ControlSeries) -> dict[int, Options]:
    """Return the options of each axis; detection units that are not given come from the files.

    If a given detection unit of an axis in the job contradicts the files, a fault is added to
    ``memory``. Raises UsageError for wrong options, and if no axis has a detection unit.
    """
    faults: list[Fault] = []
    options: dict[int, Options] = {}
    for axis in memory.axes():
        own = read_options(request.options_of(str(axis)), series, str(axis), faults)
        rotary = by_address(request.kinds, str(axis)) is AxisKind.ROTARY
        known = memory.machine.detection_unit(axis, rotary=rotary)
        if known is not None and own.detection_unit is None:
            memory.assumed.append(
                Assumption(f"detection unit of {axis}", f"{known:g}", _unit_by(memory, axis))
            )
            own = replace(own, detection_unit=known)
        elif known is not None and request.is_under_work(str(axis)) and memory.moves(axis):
            given, entry = own.detection_unit or known, memory.machine.entry(1820, axis)
            if entry is not None and abs(given - known) > _SAME_UNIT * known:
                memory.faults.append(
                    entry.fault(f"detection_unit {given:g} of axis {axis}", f"{known:g} by 1820")
                )
        options[axis] = own
    if options and not faults and all(entry.detection_unit is None for entry in options.values()):
        faults.append(_no_unit(", ".join(map(str, options))))
    raise_all(UsageError, faults)
    return options


def _unit_by(memory: Memory, axis: int) -> str:
    """Return the names of the parameters from which an axis' detection unit follows, as text."""
    system, least = memory.machine.system(axis), memory.machine.least_increment(axis)
    fine = least is not None and least < 0.9 * FINEST_CONFIRMED
    how = " (the bits of IS-D and IS-E: unconfirmed)" if fine else ""
    return f"1820 with {'' if system is None else system.number}{how}"


def _no_unit(address: str) -> Fault:
    return Fault(
        message=f"the option detection_unit of axis {address} is missing",
        expected="mm or deg per pulse",
        found="nothing",
        hint=("give `--option detection_unit=0.001` with the value of this control"),
    )


def _axis(
    loader: AxisLoader, axis: int, grid: IncrementGrid | None, options: Options
) -> _FanucAxis:
    """Return one axis with its table and backlash; its assumptions are added to the loader."""
    address = str(axis)
    returning, assumption = loader.request.returning(address)
    loader.memory.assumed += [assumption] if assumption is not None else []
    reference, assumption = loader.request.referenced(address)
    if grid is not None:
        loader.memory.assumed += [assumption] if assumption is not None else []
        if reference != 0.0:
            loader.note(
                axis,
                f"the grid is assumed to start at the reference position {reference:g}, "
                "not on machine"
                " zero (unconfirmed)",
            )
    return _FanucAxis(
        table=None if grid is None else pitch_table(loader, grid, options, returning),
        cycle=cycle(loader, axis, grid, options),
        backlash=backlash(loader, axis, options),
        unit=options.detection_unit,
        ramp=options.ramp,
        reference=reference,
        reference_return=returning,
    )


def _note_shared(loader: AxisLoader, grids: dict[int, IncrementGrid]) -> None:
    """Add a note on the points that two axes use in the array that all axes share.

    An axis without an active table is noted if its range of points overlaps the points of another
    axis. Points with values that no axis uses are noted too.
    """
    owners: dict[int, list[int]] = {}
    for axis, grid in grids.items():
        for number in grid.numbers():
            owners.setdefault(number, []).append(axis)
    meetings: dict[tuple[int, int], list[int]] = {}
    for number, sharing in owners.items():
        for other in sharing[1:]:
            meetings.setdefault((sharing[0], other), []).append(number)
    for (first, second), numbers in meetings.items():
        _sharing(loader, grids[first], grids[second], numbers)
    for axis in set(loader.memory.axes()) - set(grids):
        low, high = (loader.memory.whole_if_sound(number, axis) for number in (3621, 3622))
        if (
            low is not None
            and high is not None
            and low < high
            and any(low <= number <= high for number in owners)
        ):
            loader.note(axis, f"its points {low} to {high}, not in use, meet those of another axis")
    used = {n for axis in loader.memory.axes() for n in cyclic_numbers(loader.memory.machine, axis)}
    used |= set(owners)
    idle = [n for n, value in loader.memory.increments.items() if value != 0 and n not in used]
    if idle:
        loader.memory.notes.append(
            f"points {number_list(POINT_BASE + n for n in idle)} contain values, but no axis"
            " uses them"
        )


def _sharing(
    loader: AxisLoader, first: IncrementGrid, second: IncrementGrid, numbers: Sequence[int]
) -> None:
    """Add a note that two axes use the points ``numbers``, and whether they use them in the same
    way.
    """
    shared = number_list(numbers)
    how = (
        "in the same way"
        if first.same_use(second)
        else "in another way: whoever changes them changes both axes"
    )
    loader.note(second.axis, f"uses the same points {shared} as axis {first.axis}, {how}")
