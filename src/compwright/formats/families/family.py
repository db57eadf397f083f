"""The common interface of all families of controls.

A family is a shape of compensation data: a grid, whole increments by section, or columns in the
user's own tables. It is never a maker. Controls of one family differ by their definitions. A family
object contains a definition, its options and the contents of the control's own files.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from typing import ClassVar, TypeVar

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.families import limits
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest
from compwright.formats.families.card_texts import AxisCard, CardRequest
from compwright.formats.families.resolved_definition import ResolvedDefinition
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.file_values import FileValue, FileValues, by_statements
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis, partner_of
from compwright.records.capacity import Capacity
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
)
from compwright.records.delivery import Delivery
from compwright.records.options import UnansweredOption
from compwright.records.stored_table import StoredTable

#: Address, axis and table: what is written for one axis.
AxisTable = tuple[str, Axis, AxisCompensation]


def tables_with_axes(
    definition: Definition,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[tuple[str, Axis]],
) -> list[AxisTable]:
    """Return (address in the files, axis of the job, table) for each table, in given order.

    Raises UsageError for every table without an axis, and if an axis has two tables.
    """
    by_address = dict(axes)
    faults = []
    pairs: dict[str, AxisTable] = {}
    for compensation in compensations:
        named = compensation.address
        address = next(
            (address for address, axis in axes if axis.address == named),
            None,
        ) or normal_text(definition, named)
        if address not in by_address:
            faults.append(
                Fault(
                    message=f"no axis has the address {named}",
                    expected=", ".join(by_address),
                    hint="use one of these addresses, or add the axis to the job",
                )
            )
        elif address in pairs:
            faults.append(
                Fault(
                    message=f"axis {address} has two tables",
                    hint=f"give only one table for axis {address}",
                )
            )
        else:
            pairs[address] = (address, by_address[address], compensation)
    raise_all(UsageError, faults)
    return list(pairs.values())


def with_partners(definition: Definition, pairs: Sequence[AxisTable]) -> list[AxisTable]:
    """Return the given tables and, for each gantry, a copy of the master's table for the slave
    axis.
    """
    result = {address: (address, axis, compensation) for address, axis, compensation in pairs}
    for _, axis, compensation in pairs:
        if axis.gantry is not None:
            partner = normal_text(definition, axis.gantry)
            table = replace(compensation, address=partner)
            result.setdefault(partner, (partner, partner_of(axis, partner), table))
    return list(result.values())


def writable_tables(tables: Sequence[AxisTable]) -> list[AxisTable]:
    """Return the tables that are valid: at least two points, all finite, positions ascending."""
    return [
        each
        for each in tables
        if each[2].positions.size >= 2 and not limits.invalid_values(each[2])
    ]


def _own_axis(
    _: Definition, entry: FileValue, __: FileValues, ___: ControlState | None
) -> tuple[tuple[str, ...], float | None]:
    return ((entry.axis,) if entry.axis else ()), None


F = TypeVar("F", bound="Family")
AddressesByName = Mapping[str, tuple[str, str]]
OwnLimits = Callable[[Axis, AxisCompensation, Capacity, str], Sequence[Fault]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Listing:
    """Functions of one family that list the values, axis names and programs in a control's files
    without reading the whole state of the control.

    - ``file_values``: every value in the files, active or not, by a unique key. Its arguments are
      the files and further files of the machine that may name its axes. Raises InputError.
    - ``value_location``: the addresses of the axes to which a value belongs, and the position of a
      table value in the files' coordinates. Its arguments are the value, all values, and the state
      if it could be read.
    - ``names``: for each axis name, the axis' address and its evidence. Raises InputError.
    - ``readable_alone``: the addresses that can be read alone if one faulty axis prevents reading
      all.
    - ``is_idle``: whether the readings of other axes show that nothing is active on an axis.
    - ``executed``: the files without programs that were not executed by the job's answer (``active:
      no``), and findings that name these programs. Raises InputError if that is impossible.
    - ``for_display``: the control for files that are only displayed. It may assume, and reports,
      values on which no measurement depends.
    - ``for_draft``: the control for the draft of a job. Doubts that cannot affect a measurement
      exclude no axis. None: as ``for_display``.
    """

    file_values: Callable[
        [Definition, Sequence[ControlFile], Sequence[ControlFile]], FileValues
    ] = lambda definition, files, _: by_statements(definition, files)
    value_location: Callable[
        [Definition, FileValue, FileValues, ControlState | None],
        tuple[tuple[str, ...], float | None],
    ] = _own_axis
    names: Callable[[Family, Sequence[ControlFile]], AddressesByName] = lambda _, __: {}
    readable_alone: Callable[[Family, Sequence[ControlFile]], Sequence[str]] = lambda _, __: ()
    is_idle: Callable[[ControlState, str], bool] = lambda _, __: False
    executed: Callable[
        [Definition, Sequence[ControlFile]],
        tuple[tuple[ControlFile, ...], tuple[Finding, ...]],
    ] = lambda _, files: (tuple(files), ())
    for_display: Callable[[Family], Family] = lambda control: control
    for_draft: Callable[[Family], Family] | None = None


class Family(ResolvedDefinition, ABC):
    """Interface of all families of controls: read, check and write tables, and fill the card."""

    listing: ClassVar[Listing] = Listing()
    #: The number without which tables cannot be read, where their control has one.
    unanswered_option: UnansweredOption | None = None
    #: A job is drafted from the files: as in a job, what no option lists stays as it is.
    drafting = False

    @abstractmethod
    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``, for the ``axes`` of a job, for the axis
        at ``address``, or for every axis. ``activity``: the job's answer whether the tables were
        active.

        ``axes`` state kind, measuring system and direction of the reference return. Only these axes
        are read. Without ``axes``, every axis in the files is read, or only ``address``. The
        options ``reference`` and ``reference_return`` are then listed in ``assumed``. The axes of
        the result have the addresses of `Family.address`. Raises InputError with every fault (file
        and line). Raises UsageError for a wrong option or address, and for questions that only the
        user can answer.
        """

    def questions(self, axis: Axis, *, files: bool, given: Collection[str] = ()) -> Iterator[Fault]:
        """Yield a fault for each answer that the job must give before an axis can get a table.
        ``files``: the control's own files are given, so they can contain the answer; ``given``:
        names of the options that the job states for any of its axes.
        """
        del given
        if not files:
            try:
                self.address(axis)
            except UsageError as error:
                yield from (replace(fault, place="address") for fault in error.faults)

    @abstractmethod
    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of an axis' table, such as point count and spacing, in mm or deg.
        ``one_curve``: the limits of one table with a backlash value, even if the control can store
        one table per direction.

        Option values that the control's own files state are included. Raises UsageError for an
        address that the control cannot have, CapacityError if the control can hold no table.
        """

    def stored_table(self, axis: Axis, compensation: AxisCompensation) -> StoredTable:
        """Return the table of an axis with the rows in which the control stores it.

        Without a rule of the family, each point has one row, in the order of the positions.
        """
        del axis
        return StoredTable.by_point(compensation)

    @abstractmethod
    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return the files that put ``compensations`` into the control, in the order of the axes.

        ``axes``: the axis of every compensation. ``files``: the control's own files, to be patched.
        The same input gives the same bytes: no dates, no random order. All limits are checked here
        again (`check_tables`), even if they were checked before. Raises UsageError for a
        compensation without an axis, CapacityError with everything that the control cannot hold
        exactly.
        """

    @abstractmethod
    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a table that was written."""

    @abstractmethod
    def between(self, request: BetweenRequest) -> Between:
        """Return the control's answer to a request for corrections between axes.

        A correction that the control cannot hold is not written. The answer reports it, with what
        would help. Raises CompwrightError if the control's files cannot be read.
        """

    def sheets(
        self, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
    ) -> tuple[ControlFile, ...]:
        """Return written compensations in other forms: entry sheets, or programs that enter the
        values.

        Each of ``compensations`` belongs to the axis at the same index of ``axes``.
        """
        del compensations, axes
        return ()

    def delivered(
        self,
        files: Sequence[ControlFile],
        own: Sequence[ControlFile],
        axes: Sequence[Axis],
    ) -> Delivery:
        """Return the files to load into the control, and the files that restore its previous
        contents. ``own``: the control's files before; ``files``: the files written from them for
        ``axes``.

        Raises UsageError if the required form of files is not available.
        """
        del own, axes
        return Delivery(tuple(files))


def in_patched_files(
    control: F,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[Axis],
    files: Sequence[ControlFile],
) -> F:
    """Return a copy of ``control`` with the state of the axes of ``compensations``, read from the
    ``files`` that are to be changed; without files ``control`` itself.

    Raises UsageError for a table without an axis, InputError for files that cannot be read.
    """
    if not files:
        return control
    bound = copy(control)
    bound.state = control.read(
        files, [axis for _, axis, _ in _paired(control, compensations, axes)]
    )
    return bound


def _paired(
    control: Family, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
) -> list[AxisTable]:
    named = [(control.address(axis)[0], axis) for axis in axes]
    return tables_with_axes(control.definition, compensations, named)


def no_limits(_: Axis, __: AxisCompensation, ___: Capacity, ____: str) -> Sequence[Fault]:
    """Return no faults, for a family of controls without limits of its own."""
    return ()


def require_files(files: Sequence[ControlFile]) -> None:
    """Raise UsageError if no file of the control is given."""
    if not files:
        raise UsageError(
            Fault(
                message="no file of the control was given",
                expected="its own files, or `none` instead of files",
                hint=(
                    "give the control's files under `states: {as_found: [...]}`, or"
                    " `as_found: none` if it has no compensation (without a job: `--state FILE`"
                    " or `--state none`)"
                ),
            )
        )


def check_tables(
    control: Family,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[Axis],
    own_limits: OwnLimits = no_limits,
) -> tuple[list[AxisTable], list[Fault]]:
    """Return all tables, those of gantry slaves included, and a fault for each limit that they
    break. ``own_limits``: a function that returns the faults by limits that only this family has.

    The limits of endless axes are checked too. Raises UsageError for a table without an axis.
    """
    tables = with_partners(control.definition, _paired(control, compensations, axes))
    faults = [
        fault for _, axis, table in tables for fault in _broken(control, axis, table, own_limits)
    ]
    return tables, list(dict.fromkeys(faults))


def _broken(
    control: Family, axis: Axis, compensation: AxisCompensation, own_limits: OwnLimits
) -> tuple[Fault, ...]:
    """Return a fault for each limit of the control that the table of an axis breaks.
    ``own_limits``: a function that returns the faults by limits that only this family has.

    Each fault names the limit, the excess and what would help.
    """
    label = f"axis {axis.name} ({compensation.address})"
    unsound = limits.invalid_values(compensation)
    if unsound:
        return (
            Fault(message=f"{label}: the table is not valid: {unsound}", hint="run the job again"),
        )
    try:
        one_curve = np.array_equal(compensation.positive, compensation.negative)
        capacity = control.capacity(axis, one_curve=one_curve)
    except CapacityError as error:
        return error.faults
    return (
        *limits.size(control.definition, capacity, compensation, label),
        *limits.curves(capacity, compensation, label),
        *limits.endless(control.definition, axis, label),
        *own_limits(axis, compensation, capacity, label),
        *limits.spacing(capacity, compensation, label),
        *limits.kind(axis, compensation, label),
        *limits.ends(control.definition, compensation, label),
    )
