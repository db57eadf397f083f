"""The FANUC family of controls: whole increments between points, in one shared array."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from compwright.formats.definition.shape_rules import NUMBER, KeptLines, ShapeRules
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest
from compwright.formats.families.card_texts import (
    AxisCard,
    CardRequest,
    named_files,
    sign_check,
)
from compwright.formats.families.family import Family, Listing, check_tables, writable_tables
from compwright.formats.families.increments.axis_pairs import straightness_between
from compwright.formats.families.increments.capacity import IncrementLimits
from compwright.formats.families.increments.card import increment_values, numbered_sections
from compwright.formats.families.increments.entries import free_numbers_question
from compwright.formats.families.increments.file_values import file_values, value_location
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.job_checks import points_question
from compwright.formats.families.increments.parameters import NAMES
from compwright.formats.families.increments.reading import StateReader
from compwright.formats.families.increments.sections import stored_sections
from compwright.formats.families.increments.writing import increment_sheets, write_increments
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.options import DETECTION_UNIT, UnansweredOption
from compwright.records.stored_table import StoredTable

#: No control numbers more axes than this.
_MOST_AXES = 40


RULES = ShapeRules(
    kept=KeptLines(
        (
            "%",
            rf"N[0-9]{{4,5}}(?:Q[0-9])?(?:(?:[ALSTKDG][0-9]{{1,3}})?[PMIR]{NUMBER})+",
            r"(?:N[0-9]{1,5})?G1[01](?:L5[0-2])?;?",
        )
    ),
    words="whole increments by section, numbered in one array for all axes",
    grid=("table_spacing",),
    parameters=frozenset(NAMES.values()),
    typed=frozenset({"detection_unit"}),
    # that of increments is turned by the options pitch_sign and offset_sign
    signs={"value": frozenset({"correction"}), "backlash": frozenset({"lost_motion"})},
)


def _names(control: Family, files: Sequence[ControlFile]) -> Mapping[str, tuple[str, str]]:
    """Return the axis letters in parameter 1020, by the axis number."""
    names = StateReader(control, files, (), None).names() if files else {}
    return {
        name: (address, f"1020 of axis {address} in the control's files")
        for address, name in names.items()
        if list(names.values()).count(name) == 1
    }


def _idle(state: ControlState, address: str) -> bool:
    """Return whether no table and no backlash is active on an axis."""
    facts = state.facts_of(address)
    return not (facts.enabled or increments_of(facts).backlash)


def _shown(control: Family) -> Family:
    """Return a copy of ``control`` for displaying files: inclination compensation and cyclic table
    are read too.
    """
    both = {"inclination", "cyclic"} & control.definition.options.keys()
    options = {**control.options, **dict.fromkeys(both, "available")}
    return type(control)(control.definition, options)


class IncrementsFamily(Family):
    """Controls whose tables are whole increments between points (FANUC)."""

    listing = Listing(
        file_values=file_values,
        value_location=value_location,
        names=_names,
        # axes have numbers, and each its own part of the points
        readable_alone=lambda _, __: [str(number) for number in range(1, _MOST_AXES + 1)],
        is_idle=_idle,
        for_display=_shown,
    )
    unanswered_option = UnansweredOption(
        DETECTION_UNIT, "mm or deg per pulse, such as 0.001", stand_in=0.001, lengths=False
    )

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``; see `Family.read`.

        The argument ``activity`` is not used, because no file of these controls switches a table
        off.
        """
        del activity
        return StateReader(self, files, axes, address).read()

    def questions(self, axis: Axis, *, files: bool, given: Collection[str] = ()) -> Iterator[Fault]:
        """Yield questions about an axis that no file answers; see `Family.questions`.

        Two questions are added: the first free point number, if no file shows it, and the position
        from which points are counted. The answer of one axis about the first free number is enough
        for all axes.
        """
        yield from super().questions(axis, files=files, given=given)
        if not files and self.options.get("first_point") is None and "first_point" not in given:
            yield free_numbers_question(self.definition)
        yield from points_question(axis, {**self.options, **axis.options}.get("points_from"))

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of one axis' table in mm or deg; see `Family.capacity`."""
        del one_curve
        return IncrementLimits(self, axis).capacity()

    def stored_table(self, axis: Axis, compensation: AxisCompensation) -> StoredTable:
        """Return a table with its increments as rows; see `Family.stored_table`."""
        address, _ = self.address(axis)
        return stored_sections(axis, compensation, increments_of(self.state.facts_of(address)))

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return the files that load ``compensations`` into the control; see `Family.write`."""
        tables, faults = check_tables(self, compensations, axes)
        raise_all(CapacityError, faults)
        return write_increments(self, writable_tables(tables), files)

    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a written table; see `Family.card`."""
        axis, table, facts = request.axis, request.table, request.facts
        values = increment_values(self, axis, table, facts) | sign_check(table, request.check_at)
        files = named_files(self, axis, request.files)
        return AxisCard(values | files, numbered_sections(self, axis, facts, table))

    def between(self, request: BetweenRequest) -> Between:
        """Return a straight line as straightness compensation, to type in; see `Family.between`."""
        return straightness_between(self, request)

    def sheets(
        self, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
    ) -> tuple[ControlFile, ...]:
        """Return entry sheets, or G10 programs that enter the values; see `Family.sheets`.

        Raises UsageError if an option requires a program and the machine is in inches, because a
        program cannot state its unit.
        """
        own = [
            (self.address(axis)[0], axis, table)
            for axis, table in zip(axes, compensations, strict=True)
        ]
        return increment_sheets(self, own)
