"""What every family of controls answers: one protocol, bound to a definition, its options and what
the control's own files say.

A family is a shape of compensation data (a grid, whole steps by section, columns in the user's own
tables), never a maker. The single controls differ by their definitions.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Self

from compwright.formats.families import limits
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_tables import AxisTable, paired
from compwright.formats.families.between import Between, BetweenRequest
from compwright.formats.families.bound import Bound
from compwright.formats.families.card_words import AxisCard, CardRequest
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.entered import Entered, Entries, by_statements
from compwright.foundations.errors import CapacityError, Fault, UsageError
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis, partner_of
from compwright.records.capacity import Capacity
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
)
from compwright.records.delivery import Delivery
from compwright.records.facts import AxisFacts
from compwright.records.options import LeftOpen


class Family(Bound, ABC):
    """One control's compensation."""

    #: What would let tables be counted with of which nobody knows what they do.
    untold_help = ""
    #: What the user gives instead of a container that cannot be opened.
    export_instead = "text as the control exports it, in ASCII or another 8-bit character set"
    #: The number without which tables cannot be read, where their control has one.
    left_open: LeftOpen | None = None

    def addresses_by_name(self, files: Sequence[ControlFile]) -> Mapping[str, tuple[str, str]]:
        """Return the address of each axis, and what says so, by the name that the control's own
        files give to it alone; none where they name no axes. Raises InputError.
        """
        del files
        return {}

    @abstractmethod
    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return what a control does with ``files``.

        ``axes`` (where a job knows them) give kind, measuring system and direction of the reference
        return, and limit the reading to these axes; otherwise every axis in the files is read, or
        only ``address``, and the options ``reference`` and ``reference_return`` are listed in
        ``assumed``. ``activity``: what a job says of whether the tables acted. The axes of the
        result stand under the address as `Family.address` gives it. Raises InputError with every
        fault that was found (file and line), UsageError for a wrong option or address, and for what
        only the user can answer.
        """

    def questions(self, axis: Axis, *, files: bool, given: Collection[str] = ()) -> Iterator[Fault]:
        """Yield what a job has to say of an axis that is to get a table; the place is the key or
        the option. ``files``: the control's own files are given, and may say it; ``given``: the
        options that the job gives to any of its axes.
        """
        del given
        if not files:
            try:
                self.address(axis)
            except UsageError as error:
                yield from (replace(fault, place="address") for fault in error.faults)

    @abstractmethod
    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of one axis' table in mm or deg.

        ``one_curve``: the job asks for one table and a backlash value, even where the control could
        hold a pair. What the control's own files answer counts. Raises UsageError for an address
        that the control cannot have, CapacityError where it can hold nothing.
        """

    @abstractmethod
    def files_of(
        self, tables: Sequence[AxisTable], files: Sequence[ControlFile], faults: list[Fault]
    ) -> tuple[ControlFile, ...]:
        """Return the files that put ``tables`` into the control; ``files``: its own, patched.

        ``faults``: the limits that the tables break. Raises CapacityError with them and with what
        the text cannot say exactly.
        """

    @abstractmethod
    def card(self, asked: CardRequest) -> AxisCard:
        """Return what the card says about a table that was written."""

    @abstractmethod
    def between(self, asked: BetweenRequest) -> Between:
        """Return what the control does with corrections between axes, by the state that is bound.

        What it cannot hold is said, and what would help; nothing of that is written. Raises
        CompwrightError where its files cannot be read.
        """

    def sheets(
        self, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
    ) -> tuple[ControlFile, ...]:
        """Return second forms of compensations that were written already: sheets to type in,
        programs that enter the same values. ``compensations`` belong to ``axes`` one by one.
        """
        del compensations, axes
        return ()

    def delivered(
        self,
        files: Sequence[ControlFile],
        own: Sequence[ControlFile],
        axes: Sequence[Axis],
    ) -> Delivery:
        """Return what the control loads, and what brings back what was in it.

        ``files``: what was written for ``axes``, the control's ``own`` ones patched among them.
        Raises UsageError for a form of files that these have not.
        """
        del own, axes
        return Delivery(tuple(files))

    def small_files(self, own: Sequence[ControlFile]) -> bool:
        """Return whether what is written into the control's ``own`` files is delivered in small
        ones.
        """
        del own
        return False

    @property
    def counts_axes(self) -> bool:
        """Whether the control's files number axes otherwise than by address."""
        return False

    def one_by_one(self, files: Sequence[ControlFile]) -> Sequence[str]:
        """Return the addresses that may be read alone where one odd axis of the control's files
        spoils the whole; empty where none may.
        """
        del files
        return ()

    def tells_idle(self, state: ControlState, address: str) -> bool:
        """Return whether what was read of other axes tells that nothing acts on this one."""
        del state, address
        return False

    def misnamed(self, axis: Axis, facts: AxisFacts, state: str) -> Iterable[Fault]:
        """Return where the control's files of a ``state`` (its name), which say ``facts``, call an
        axis otherwise than the job does, or drive it by more than the job says.
        """
        del axis, facts, state
        return ()

    def entered(self, files: Sequence[ControlFile], naming: Sequence[ControlFile] = ()) -> Entries:
        """Return everything that files enter, whether it acts or not, by what tells each value
        from all others. ``naming``: further files of the machine, which may say what its axes are
        called. Raises InputError for files that cannot be read.
        """
        del naming
        return by_statements(self.definition, files)

    def whereabouts(
        self, entry: Entered, entries: Entries, state: ControlState | None
    ) -> tuple[tuple[str, ...], float | None]:
        """Return the addresses of the axes that one of ``entries`` belongs to, and the position of
        a value of a table as the files count it; ``state``: what the files say, where that could be
        read.
        """
        del entries, state
        return ((entry.axis,) if entry.axis else ()), None

    def carried_out(
        self, files: Sequence[ControlFile]
    ) -> tuple[tuple[ControlFile, ...], tuple[Finding, ...]]:
        """Return ``files`` without the programs that were not carried out, where the job says so
        (``active: no``), and findings that name these. Raises InputError where that cannot be.
        """
        return tuple(files), ()

    def for_a_view(self) -> Self:
        """Return the control as it reads files that are only shown: what no readings hang on may
        be assumed, and is said.
        """
        return self

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return exactly the files that put ``compensations`` into the control, in the order of the
        axes.

        ``axes`` holds the axis of every compensation. ``files``: the control's own, to be patched.
        Same input, same bytes: no dates, no order by chance. Raises UsageError for a compensation
        without an axis, CapacityError with everything that the control cannot hold exactly: all
        limits are checked here again, whatever was checked before.
        """
        pairs = paired(
            self.definition, compensations, [(self.address(axis)[0], axis) for axis in axes]
        )
        bound = self.bound_to(files, [axis for _, axis, _ in pairs])
        pairs = bound.with_partners(pairs)
        faults = [
            fault for _, axis, compensation in pairs for fault in bound.limits(axis, compensation)
        ]
        return bound.files_of(pairs, files, list(dict.fromkeys(faults)))

    def bound_to(self, files: Sequence[ControlFile], axes: Sequence[Axis]) -> Self:
        """Return the control whose limits are those of ``files``; itself where they set none."""
        del files, axes
        return self

    def limits(self, axis: Axis, compensation: AxisCompensation) -> tuple[Fault, ...]:
        """Return what keeps the control from holding a compensation, apart from single values that
        are not exact.

        Names the limit, by how much it is broken and what would help.
        """
        label = f"axis {axis.name} ({compensation.address})"
        unsound = limits.unsound(compensation)
        if unsound:
            return (Fault(message=f"{label}: {unsound}"),)
        try:
            capacity = self.capacity_of(axis, compensation)
        except CapacityError as error:
            return error.faults
        return (
            *limits.size(self.definition, capacity, compensation, label),
            *limits.curves(capacity, compensation, label),
            *self.limits_of_turn(axis, compensation, capacity, label),
            *limits.spacing(capacity, compensation, label),
            *limits.kind(axis, compensation, label),
            *self.own_limits(axis, compensation, capacity),
            *limits.ends(self.definition, compensation, label),
        )

    def capacity_of(self, axis: Axis, compensation: AxisCompensation) -> Capacity:
        """Return the limits of the place where this table goes."""
        del compensation
        return self.capacity(axis)

    def limits_of_turn(
        self, axis: Axis, compensation: AxisCompensation, capacity: Capacity, label: str
    ) -> Sequence[Fault]:
        """Return what is wrong with the table of an endless axis."""
        del compensation, capacity
        no_limit = self.definition.limit("no_endless_axis") is None
        if axis.modulo is None or axis.counts_turns or no_limit:
            return ()
        why = f"{label}: the control's table does not repeat, so an endless axis cannot have one"
        found = f"modulo {axis.modulo:g}"
        return (Fault(message=why, expected="an axis with ends", found=found),)

    def own_limits(
        self, axis: Axis, compensation: AxisCompensation, capacity: Capacity
    ) -> Sequence[Fault]:
        """Return what breaks limits that only this family has."""
        del axis, compensation, capacity
        return ()

    def with_partners(self, pairs: Sequence[AxisTable]) -> list[AxisTable]:
        """Return the tables with those of gantry partners, which are the same: on one axis alone a
        table racks the bridge.
        """
        result = {address: (address, axis, compensation) for address, axis, compensation in pairs}
        for _, axis, compensation in pairs:
            if axis.gantry is not None:
                partner = normal_text(self.definition, axis.gantry)
                table = replace(compensation, address=partner)
                result.setdefault(partner, (partner, partner_of(axis, partner), table))
        return list(result.values())
