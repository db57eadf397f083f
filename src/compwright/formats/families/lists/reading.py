"""Read the active compensation of every axis from the compensation value lists of a control.

A missing value does not count as zero, and every assumption is listed. Faults of an axis that is
not in the job are only reported.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from compwright.formats.definition.options import axis_options, known_kind
from compwright.formats.families.activity import Activity
from compwright.formats.families.coupled_axes import (
    check_couplings,
    compare_partners,
    note_twin,
    with_couplings,
)
from compwright.formats.families.family import Family
from compwright.formats.families.lists.backlash import backlash_of, check_others
from compwright.formats.families.lists.coupling import couplings_of
from compwright.formats.families.lists.cross import left_out, read_cross
from compwright.formats.families.lists.files import ListsByAxis, read_lists
from compwright.formats.families.lists.statements import AxisStatements
from compwright.formats.families.lists.table import ListTable, TableReader
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.notes import ADD_FILE, Notes
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, partner_of
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts
from compwright.records.options import REFERENCE, REFERENCE_RETURN
from compwright.words.sentences import control_text, unconfirmed


@dataclass(frozen=True, slots=True)
class AxisList:
    """An axis' active compensation, and whether its table is active.

    ``active``: None without a table. ``idle``: the positions of the points of an inactive table, mm
    or deg.
    """

    compensation: AxisCompensation
    active: bool | None
    idle: tuple[float, ...] = ()


def read_axis(of: AxisStatements) -> AxisList:
    """Return the compensation in the lists of an axis; faults are added to the axis' notes."""
    table = TableReader(of).read()
    active = None
    if table is not None:
        zero = not (np.any(table.positive) or np.any(table.negative))
        active = of.is_active("table_switch", "manual", zero=zero, label=of.label)
    elif not of.lists.places(of.address, "count"):
        of.notes.assume(
            control_text("{label}: table", label=of.label),
            control_text("none"),
            unconfirmed(control_text("in no list that was given")),
        )
        of.notes.no_table(of.label)
    empty = np.empty(0)
    shown = ListTable(positions=empty, positive=empty, negative=empty)
    if table is not None and active:
        shown = table
    compensation = AxisCompensation(
        address=of.address,
        kind=of.kind,
        positions=shown.positions,
        positive=shown.positive,
        negative=shown.negative,
        backlash=backlash_of(of, two=shown.two),
        reference_return=of.returns,
        below=of.definition.layout.below,
        above=of.definition.layout.above,
        period=shown.period,
    )
    idle = () if table is None or active else tuple(float(point) for point in table.positions)
    return AxisList(compensation, active, idle)


class ListStateReader:
    """Reads the state of a control from its value lists; see `Family.read` for the arguments."""

    def __init__(
        self, family: Family, axes: Sequence[Axis], address: str | None, activity: Activity
    ) -> None:
        self.family = family
        self.definition = family.definition
        self.activity = activity
        self.notes = Notes()
        self.wanted: dict[str, Axis | None] = {}
        self.partners: dict[str, str] = {}
        if address is not None:
            self.wanted[normal_text(self.definition, address)] = None
        self.leading: dict[str, Axis] = {}
        for axis in axes:
            name, _ = normal_address(self.definition, axis)
            self.wanted[name] = self.leading[name] = axis
            if axis.gantry is not None:
                partner = self.partners[name] = normal_text(self.definition, axis.gantry)
                self.wanted.setdefault(partner, partner_of(axis, partner))
        self.compensations: dict[str, AxisCompensation] = {}
        self.facts: dict[str, AxisFacts] = {}
        self.cross: list[CrossCompensation] = []

    def read(self, files: Sequence[ControlFile]) -> ControlState:
        """Return the state of a control from its ``files``."""
        lists = read_lists(self.definition, files, self.notes)
        raise_all(InputError, self.notes.faults)
        wanted = self.wanted or dict.fromkeys(lists.statements)
        masters = {
            str(int(place.text))
            for address in lists.statements
            for place in lists.places(address, "cross_master")
        }
        if not wanted:
            raise InputError(
                Fault(
                    message="the files contain no list of an axis",
                    file=", ".join(f.name for f in files),
                    hint="give the axis lists of this control, or correct `format`",
                )
            )
        for address, axis in wanted.items():
            if address in lists.missing:
                self._missing(lists, address)
            elif address in lists.statements:
                self._axis(lists, address, axis)
            elif address not in masters:
                expected = f"a list of axis {address}"
                self.notes.no_data(f"axis {address}", files, lists.statements, expected)
        for address in lists.statements:
            if address not in wanted:
                self._unasked(lists, address)
        self._couplings(lists, files)
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        compare_partners(self.partners, self.compensations, self.notes)
        if any(axis is None for axis in wanted.values()):
            options = self.family.options
            self.notes.assume(
                REFERENCE, f"{options[REFERENCE]:g}", control_text("option or its default")
            )
            self.notes.assume(
                REFERENCE_RETURN,
                str(options[REFERENCE_RETURN]),
                control_text("option or its default"),
            )
        return ControlState(
            format=self.definition.id,
            axes=self.compensations,
            cross=tuple(self.cross),
            facts=self.facts,
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
        )

    def _couplings(self, lists: ListsByAxis, files: Sequence[ControlFile]) -> None:
        """Compare the axis couplings in the files with the gantries of the job."""
        owners = {
            files[number].name: int(address)
            for address, numbers in lists.files.items()
            for number in numbers
        }
        couplings = couplings_of(files, owners, list(self.leading))
        check_couplings(couplings, self.leading, self.notes)
        for address, facts in self.facts.items():
            self.facts[address] = with_couplings(facts, couplings, address)

    def _missing(self, lists: ListsByAxis, address: str) -> None:
        place = lists.missing[address]
        message = "the list that the start-up list names in this line was not given"
        self.notes.refuse(
            f"axis {address}", message, place, expected="this file too", hint=ADD_FILE
        )

    def _axis(self, lists: ListsByAxis, address: str, axis: Axis | None) -> None:
        """Read and store the compensation and the facts of one axis."""
        reader = self._reader(lists, address, axis, self.notes, self.activity)
        own = read_axis(reader)
        self.compensations[address] = own.compensation
        check_others(reader)
        between = read_cross(reader, self._kind)
        self.cross.extend([between] if between is not None else [])
        name = reader.one("axis_name")
        self.facts[address] = AxisFacts(
            name=None if name is None else name.text,
            name_evidence=reader.lists.name("axis_name"),
            kind=reader.stated_kind,
            enabled=own.active,
            grid=own.idle,
            stated=reader.stated,
        )
        if axis is not None:
            self._check_turn(axis, self.compensations[address])

    def _unasked(self, lists: ListsByAxis, address: str) -> None:
        """Read the cross-axis table of an axis that the job does not name; a table with faults is
        reported and left out.
        """
        own, notes = Notes(), Notes()
        activity = Activity(stated=self.activity.stated)
        reader = self._reader(lists, address, None, own, activity)
        self._twins(address, read_axis(reader).compensation)
        check_others(reader)
        between = read_cross(self._reader(lists, address, None, notes, activity), self._kind)
        odd = [*own.faults, *notes.faults, *own.questions, *notes.questions]
        if odd:
            left_out(self.notes, f"axis {address}: its list", str(odd[0]))
            return
        self.notes.take(notes)
        self.cross.extend([between] if between is not None else [])

    def _twins(self, other: str, table: AxisCompensation) -> None:
        """Report an axis outside the job that has the same table as an axis of the job."""
        if not np.any(table.positive) and not np.any(table.negative):
            return
        for address, mine in self.compensations.items():
            pairs = (
                (table.positions, mine.positions),
                (table.positive, mine.positive),
                (table.negative, mine.negative),
            )
            if address not in (*self.partners, *self.partners.values()) and all(
                np.array_equal(one, same) for one, same in pairs
            ):
                note_twin(address, other, self.notes)

    def _reader(
        self, lists: ListsByAxis, address: str, axis: Axis | None, notes: Notes, activity: Activity
    ) -> AxisStatements:
        options = axis_options(self.definition, self.family.options, axis)
        return AxisStatements(lists, address, axis, options, notes, activity)

    def _kind(self, address: str) -> AxisKind:
        axis = self.wanted.get(address)
        known = known_kind(self.family.options, address) if axis is None else axis.kind
        return known or AxisKind.LINEAR

    def _check_turn(self, axis: Axis, table: AxisCompensation) -> None:
        """Report a table that does not repeat on an endless axis, or a table that repeats on an
        axis with ends.
        """
        if table.positions.size == 0 or (axis.modulo is None) == (table.period is None):
            return
        self.notes.find("CW-S056", "warning", axis.address, axis=axis.address, period=table.period)
