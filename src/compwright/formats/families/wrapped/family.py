"""PMAC family of controls: repeating tables from motor zero, defined by scripts, with backlash."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from compwright.formats.definition.shape_rules import NUMBER, KeptLines, ShapeRules
from compwright.formats.families import limits
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest, alternative_answer
from compwright.formats.families.card_texts import (
    AxisCard,
    CardRequest,
    and_joined,
    named_files,
    sign_check,
)
from compwright.formats.families.family import Family, Listing, check_tables, writable_tables
from compwright.formats.families.wrapped.card_memory import MOST_MOTORS
from compwright.formats.families.wrapped.counts import (
    COUNTS,
    PARTS,
    Counts,
    counts_of,
    counts_question,
)
from compwright.formats.families.wrapped.file_values import file_values
from compwright.formats.families.wrapped.reading import WrappedStateReader
from compwright.formats.families.wrapped.tables import (
    MotorTable,
    motor_table,
    over_travel,
    stored_entries,
)
from compwright.formats.families.wrapped.writing import TAKE_UP, fresh_script, patched_scripts
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Axis, Direction
from compwright.records.capacity import Capacity
from compwright.records.correction import (
    Assumption,
    AxisCompensation,
    ControlFile,
    ControlState,
)
from compwright.records.options import UnansweredOption
from compwright.records.stored_table import StoredTable
from compwright.words.sentences import control_text


def table_words(axis: Axis, table: MotorTable, counts: Counts, rate: str) -> dict[str, str]:
    """Return the card's values of a motor's table: entries, length, spacing, backlash, and the
    range that the axis must not use (gap).
    """
    unit = axis.kind.unit
    spacing = table.length / len(table.entries) * counts.count
    gap = control_text("the length is one turn, and there is no gap")
    if table.gap is not None:
        turn = table.length * counts.count
        gap = control_text(
            "what lies beyond {low} {unit} and below {high} {unit} is the gap"
            " that must stay unused (the table repeats after {turn} {unit}): keep the"
            " software limits inside",
            low=f"{table.gap[0]:.10g}",
            high=f"{table.gap[1]:.10g}",
            turn=f"{turn:.10g}",
            unit=unit,
        )
    at_zero = table.constant / PARTS * counts.count
    return {
        "points": str(len(table.entries)),
        "length": str(table.length),
        "unit": unit,
        "spacing": f"{spacing:.10g}",
        "gap": gap,
        "constant": str(table.constant),
        "backlash": f"{at_zero:.6f}",
        "rate": (rate if table.takes_up else control_text("0 or as it is (there is no backlash)")),
        "counts": f"{counts.per_unit:.10g}",
        "tables": and_joined(["COMP", "BLCOMP"] if table.varies else ["COMP"]),
    }


RULES = ShapeRules(
    kept=KeptLines(
        (
            rf"(?:I[0-9]{{1,5}}\s*=\s*(?:\$[0-9A-F]+|{NUMBER})\s*)+",
            r"#[0-9]{1,2}\s*DEF(?:INE)?\s+(?:BL|T)?COMP\s+[0-9#D,\s]+",
            r"OPEN\s+[A-Z]*|CLOSE|CLEAR|DELETE\s+(?:BL|T)?COMP|(?:#[0-9]{1,2}\s*)?(?:K|A|J/|\$\$\$)",
        )
    ),
    words="parts of a count over a length that repeats, defined by a script",
    grid=("table_end",),
    by_axis=False,
    quantities=(TAKE_UP,),
)


class WrappedFamily(Family):
    """Controls with repeating tables, whose values are fractions of an encoder count (PMAC)."""

    listing = Listing(file_values=file_values)
    unanswered_option = UnansweredOption(
        COUNTS,
        "counts of the motor per mm or deg, such as 1000 (negative against the axis)",
        stand_in=1000.0,
        lengths=True,
    )

    def address(self, axis: Axis) -> tuple[str, Assumption | None]:
        """Return the number of the axis' motor; see `ResolvedDefinition.address`."""
        address, assumption = super().address(axis)
        if not 1 <= int(address) <= MOST_MOTORS:
            raise UsageError(
                Fault(
                    message=f"{self.definition.id} has no motor with this number, which is the "
                    f"address of axis {axis.name}",
                    expected=f"a number from 1 to {MOST_MOTORS}",
                    found=address,
                    hint="set `address` of the axis to the number of its motor",
                )
            )
        return address, assumption

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``; see `Family.read`."""
        return WrappedStateReader(
            self.definition, self.options, files, axes, address, activity
        ).read()

    def questions(self, axis: Axis, *, files: bool, given: Collection[str] = ()) -> Iterator[Fault]:
        """Yield the questions for an axis, such as its motor's counts; see `Family.questions`."""
        yield from super().questions(axis, files=files, given=given)
        counts = {**self.options, **axis.options}.get(COUNTS)
        if not counts:
            yield counts_question(axis.name, counts)

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of one axis' table; see `Family.capacity`.

        Raises UsageError if the motor's counts per mm or degree are unknown.
        """
        del one_curve
        self.address(axis)
        counts = self._counts(axis)
        there, unfit = self._existing_points(axis)
        value, backlash = (
            self.definition.measure(name).range for name in ("value_positive", "backlash")
        )
        return Capacity(
            format=self.definition.id,
            curves=2,
            spacing="equidistant",
            quantum=counts.quantum,
            position_quantum=counts.count,
            value_range=(value[0] * counts.quantum, value[1] * counts.quantum),
            backlash_range=(backlash[0] * counts.quantum, backlash[1] * counts.quantum),
            min_points=self.definition.limit_number("min_points") or 1,
            anchored=True,
            period=axis.modulo,
            there=there,
            unfit=unfit,
            zero=counts.forward,
            below=self.definition.layout.below,
            above=self.definition.layout.above,
        )

    def _existing_points(self, axis: Axis) -> tuple[tuple[float, ...], str]:
        """Return the positions of the table points in the scripts, and the reason why a new table
        cannot use them (empty: it can).

        For an axis with ends these are the points for the travel and the reference position. The
        other points of the table are in the gap after which it repeats.
        """
        ring = self.existing_grid(axis)
        if axis.modulo is not None or len(ring) < 2:
            return ring, ""
        points = over_travel(ring, axis)
        short = "" if len(points) < len(ring) else "it repeats within the travel"
        return points, short

    def _counts(self, axis: Axis) -> Counts:
        return counts_of(self.definition, self.options_of(axis), axis.name)

    def _own_limits(
        self, axis: Axis, compensation: AxisCompensation, capacity: Capacity, label: str
    ) -> Sequence[Fault]:
        """Return the faults of an endless axis' table, and of values that no entry can hold."""
        faults = limits.turn(capacity, compensation, label)
        if compensation.positions.size >= 2:
            self._entries(axis, compensation, faults)
        return faults

    def stored_table(self, axis: Axis, compensation: AxisCompensation) -> StoredTable:
        """Return a table over one period with its entries as rows; see `Family.stored_table`."""
        counts, ring = self._counts(axis), self.existing_grid(axis)
        return stored_entries(axis, compensation, counts, ring=ring)

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return one new script, or all scripts of the user in their order; see `Family.write`."""
        tables, faults = check_tables(self, compensations, axes, self._own_limits)
        raise_all(CapacityError, faults)
        motors = [self._motor_table(axis, table) for _, axis, table in writable_tables(tables)]
        rates = {
            int(table.address): int(str(self.options_of(axis)[TAKE_UP]))
            for _, axis, table in tables
        }
        if not files:
            return (fresh_script(self.definition, motors, rates),)
        written = patched_scripts(self.definition, files, motors, rates, faults)
        raise_all(CapacityError, faults)
        return written

    def _motor_table(self, axis: Axis, compensation: AxisCompensation) -> MotorTable:
        faults: list[Fault] = []
        made = self._entries(axis, compensation, faults)
        if made is None:
            raise CapacityError(*faults)
        return made

    def _entries(
        self, axis: Axis, compensation: AxisCompensation, faults: list[Fault]
    ) -> MotorTable | None:
        counts, ring = self._counts(axis), self.existing_grid(axis)
        return motor_table(axis, compensation, counts, faults, ring=ring)

    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a written table; see `Family.card`."""
        axis, table = request.axis, request.table
        if table.backlash:  # a backlash alone, without a table: Ixx86 holds it in one direction
            ahead, against = (table.at(table.positions, direction) for direction in Direction)
            table = replace(table, positive=ahead, negative=against, backlash=0.0)
        rate = str(request.facts.stated.get(TAKE_UP, self.options_of(axis)[TAKE_UP]))
        words = table_words(axis, self._motor_table(axis, table), self._counts(axis), rate)
        files = named_files(self, axis, request.files)
        return AxisCard(words | sign_check(table, request.check_at) | files)

    def between(self, request: BetweenRequest) -> Between:
        """Return what the user can do instead of a cross-axis table; see `Family.between`."""
        return alternative_answer(self.definition, request.planned)
