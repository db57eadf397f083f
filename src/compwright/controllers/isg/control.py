"""ISG kernel (Beckhoff TwinCAT 3 CNC and others): compensation value lists, one per axis.

The rules are taken from the vendors' pages, independently of the definition that writes the files:

- ``kw.ssfk``: values by position for one or both directions, linear in between; outside, the end
  values apply. Their unit is 0.1 µm or 0.0001 deg, or encoder increments. The values are errors
  (inferred): correction = -value.
- ``getriebe[0].lose`` with ``lr_param.anwahl_losekomp``: backlash, 0.1 µm or 0.0001 deg.
- ``kw.crosscomp``: in the list of the corrected axis; the sign is not known.
- An axis is named by its logical number. Positions are axis coordinates, which are equal to machine
  coordinates.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from compwright.controllers.isg.cross import (
    CrossTable,
    read_cross,
    refuse_others,
    refuse_plane,
)
from compwright.controllers.isg.leadscrew import LeadscrewTable, read_backlash, read_table
from compwright.controllers.isg.lists import AxisLists, read_lists
from compwright.controllers.request import Request, by_address, unknown_axis
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile


@dataclass(frozen=True, slots=True)
class _ListAxis:
    """One axis of a virtual ISG kernel.

    ``backlash``: 0 or more, mm or deg. ``home``: the direction in which backlash adds nothing.
    """

    table: LeadscrewTable | None
    backlash: float
    home: Direction


@dataclass(frozen=True, slots=True)
class IsgControl:
    """An ISG kernel with loaded lists and all axes referenced; interface
    ``controllers.virtual_control.VirtualControl``.

    The address of an axis is its logical axis number as text.
    """

    axes: Mapping[str, _ListAxis]
    tables: Mapping[tuple[str, str], CrossTable]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the logical axis numbers in the lists, ascending."""
        return tuple(self.axes)

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of the table, mm or deg, active or not."""
        table = self._axis(address).table
        return np.empty(0) if table is None else table.positions

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction added to the command at ``positions`` (any shape) approached in
        ``direction``, mm or deg.
        """
        axis = self._axis(address)
        x = np.asarray(positions, dtype=np.float64)
        total = np.zeros(x.shape) if axis.table is None else axis.table.at(x, direction)
        return total + (0.0 if direction is axis.home else direction.sign * axis.backlash)

    def cross(self) -> tuple[tuple[str, str], ...]:
        """Return (master, slave) of the active cross-axis tables whose sign is known."""
        return tuple(self.tables)

    def cross_correction(
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,
        direction: Direction,  # noqa: ARG002
    ) -> FloatArray:
        """Return the correction added to ``output`` with ``input`` at ``positions`` (any shape), mm
        or deg. It is the same in both directions.
        """
        table = self.tables.get((input, output))
        if table is None:
            raise UsageError(
                Fault(
                    message=f"the lists contain no table that corrects axis {output} over the "
                    f"position of axis {input}",
                    expected=" or ".join(f"{b} over {a}" for a, b in self.tables)
                    or "an active table kw.crosscomp, and the option cross_values",
                    hint=("correct the entry `cross` of the job, or give the list with this table"),
                )
            )
        return table.at(np.asarray(positions, dtype=np.float64))

    def _axis(self, address: str) -> _ListAxis:
        axis = self.axes.get(address.strip())
        if axis is None:
            raise unknown_axis(address, self.addresses())
        return axis


def isg_control(files: Sequence[ControlFile], request: Request) -> IsgControl:
    """Return the control with ``files`` loaded. Each file is recognised by its contents.

    The files are compensation value lists, axis parameter lists and a start-up list.

    Raises InputError if lists contradict each other or themselves, or if a table lacks values.
    Raises InputError also if an active compensation of an axis of the job cannot be evaluated.
    Raises UsageError for missing or wrong options (``encoder_increment``, ``table_values``,
    ``cross_values``, ``value_type``).
    """
    lists = read_lists(files)
    raise_all(InputError, lists.faults)
    assumed: list[Assumption] = []
    notes = list(lists.notes)
    faults: list[Fault] = []
    axes: dict[str, _ListAxis] = {}
    tables: dict[tuple[str, str], CrossTable] = {}
    for address, lists_of_axis in sorted(lists.axes.items(), key=lambda entry: int(entry[0])):
        try:
            axis, cross = _loaded(lists_of_axis, request, assumed, notes)
        except UsageError as error:
            if request.is_under_work(address):
                raise
            notes.append(str(error))
            continue
        if not lists_of_axis.faults:
            axes[address] = axis
            if cross is not None:
                tables[cross.master, cross.slave] = cross
        elif request.is_under_work(address):
            faults += lists_of_axis.faults
        else:
            notes += [str(fault) for fault in lists_of_axis.faults]
    raise_all(InputError, faults)
    return IsgControl(axes=axes, tables=tables, assumed=tuple(assumed), notes=tuple(notes))


def _loaded(
    axis: AxisLists, request: Request, assumed: list[Assumption], notes: list[str]
) -> tuple[_ListAxis, CrossTable | None]:
    """Return one axis and its cross-axis table; faults are stored in the lists of the axis."""
    _check_type(axis, request)
    table = read_table(axis, request, assumed)
    backlash = read_backlash(axis, table, assumed)
    home = Direction.POSITIVE
    if backlash:
        home, why = request.returning(axis.address)
        assumed += [why] if why is not None else []
    cross = read_cross(axis, request, assumed, notes)
    refuse_plane(axis, request, assumed, notes)
    refuse_others(axis)
    return _ListAxis(table, backlash, home), cross


def _check_type(axis: AxisLists, request: Request) -> None:
    """Add a fault if the axis type is unknown or contradicts the requested kind.

    The axis type is the statement ``kenngr.achs_typ``, P-AXIS-00018: 0x0001 linear, 0x0002 rotary,
    0x0004 spindle, or the names of these types.
    """
    statement = axis.statements.get("kenngr.achs_typ")
    if statement is None:
        return
    written = statement.text.lower().removeprefix("achstyp_")
    name = {"translator": "1", "rotator": "2", "spindel": "4", "spindle": "4"}.get(written, written)
    number = name.removeprefix("0x").lstrip("0")
    kind = by_address(request.kinds, axis.address)
    if number not in ("1", "2", "4"):
        axis.fault(
            statement, f"the type of axis {axis.address} is wrong", "0x0001, 0x0002 or 0x0004"
        )
    elif kind is not None and (kind is AxisKind.LINEAR) != (number == "1"):
        axis.fault(
            statement, f"the type of axis {axis.address} is wrong", f"that of a {kind.value} axis"
        )
