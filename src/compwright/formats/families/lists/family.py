"""ISG kernel controls: one value list for each axis, which can contain a cross-axis table."""

from __future__ import annotations

from collections.abc import Sequence

from compwright.formats.definition.shape_rules import NUMBER, KeptLines, ShapeRules
from compwright.formats.families import limits
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest
from compwright.formats.families.card_texts import (
    AxisCard,
    CardRequest,
    named_files,
    sign_check,
    typed_number,
)
from compwright.formats.families.family import (
    Family,
    Listing,
    check_tables,
    in_patched_files,
    writable_tables,
)
from compwright.formats.families.lists.axis_pairs import lists_between
from compwright.formats.families.lists.file_values import file_values
from compwright.formats.families.lists.reading import ListStateReader
from compwright.formats.families.lists.table import COUNTS, TENTH, VALUE_TYPES, counted
from compwright.formats.families.lists.writing import ListsWriter
from compwright.formats.text.scale import NumberScale
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.options import UnansweredOption

RULES = ShapeRules(
    kept=KeptLines((rf"zahl_(?:kw|mp)\s+{NUMBER}",)),
    words="entries by index, at equal or at any spacing, in one list per axis",
    grid=("node_position",),
    row=None,
)


def _own_limits(
    axis: Axis, compensation: AxisCompensation, capacity: Capacity, label: str
) -> Sequence[Fault]:
    """Return the faults of an endless axis' table, and a fault if a value is too large for the
    number type of the list.
    """
    faults = limits.turn(capacity, compensation, label)
    low, high = capacity.value_range
    values = (*compensation.positive, *compensation.negative)
    if all(low <= value <= high for value in values):
        return faults
    return [
        *faults,
        Fault(
            message=f"axis {axis.name}: a value of the table does not fit the value type of the "
            "control's list",
            expected=f"{low:g} to {high:g}",
            found=f"{max(values, key=abs):g}",
            hint="set the option `value_type` to the type of the values in the control, or correct "
            "the axis mechanically and measure again",
        ),
    ]


class ListsFamily(Family):
    """Controls whose tables are entries by index, in one value list for each axis."""

    listing = Listing(file_values=file_values)
    unanswered_option = UnansweredOption(
        "encoder_increment",
        "mm or deg per encoder increment, such as 0.0001",
        stand_in=0.0001,
        lengths=True,
    )

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``; see `Family.read`."""
        return ListStateReader(self, axes, address, activity).read(files)

    def unit_of(self, axis: Axis) -> str:
        """Return the word for the unit of the numbers in an axis' list; for a new list "tenths"
        (0.1 µm or 0.0001 deg).
        """
        address, _ = self.address(axis)
        return str(self.state.facts_of(address).stated.get("table_form", "tenths"))

    def scale_of(self, axis: Axis) -> NumberScale:
        """Return unit, sign and resolution of an axis' numbers. Raises UsageError for increments of
        unknown size.
        """
        options = self.options_of(axis)
        increment: object = TENTH
        if self.unit_of(axis) == "increments":
            increment = options.get("encoder_increment")
        if not isinstance(increment, (int, float)) or increment <= 0:
            raise UsageError(
                Fault(
                    message=f"axis {axis.name}: the list counts in encoder increments, whose "
                    "length is unknown",
                    place="encoder_increment",
                    expected="the length of an encoder increment in mm or deg",
                    hint=(
                        "give `encoder_increment` in the options of the axis (without a job: "
                        "`--option encoder_increment=0.001`)"
                    ),
                )
            )
        return counted(NumberScale(self.definition, axis.kind, options, {}), options, increment)

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of an axis' table; see `Family.capacity`.

        The table has one column for each direction, and both together contain the reversal error.
        The control's backlash compensation is not used, because it is not known in which direction
        it is added.
        """
        del one_curve
        scale = self.scale_of(axis)
        address, _ = self.address(axis)
        absent = self.definition.bindings["max_points"].when_absent
        reserved = self.state.facts_of(address).stated.get("max_points")
        room = int(reserved or (absent.value if absent is not None else 0))
        low, high = scale.range("value_positive")
        most = VALUE_TYPES.get(str(self.options_of(axis).get("value_type")))
        quantum = scale.quantum("value_positive")
        if most is not None:
            low, high = max(low, -most * quantum), min(high, most * quantum)
        return Capacity(
            format=self.definition.id,
            curves=2,
            spacing="free",
            quantum=quantum,
            position_quantum=scale.quantum("node_position"),
            value_range=(low, high),
            backlash_quantum=None,
            min_points=self.definition.limit_number("min_points") or 1,
            max_points=room - 1,
            below=self.definition.layout.below,
            above=self.definition.layout.above,
            period=axis.modulo if axis.kind is AxisKind.ROTARY else None,
            there=self.existing_grid(axis),
        )

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return the files that load ``compensations`` into the control; see `Family.write`."""
        bound = in_patched_files(self, compensations, axes, files)
        tables, faults = check_tables(bound, compensations, axes, _own_limits)
        whole = writable_tables(tables)
        writer = ListsWriter(self.definition, files)
        for address, axis, compensation in whole:
            writer.put_table(address, compensation, bound.scale_of(axis), faults)
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return writer.files_of([address for address, _, _ in whole])

    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a written table; see `Family.card`."""
        axis, positions = request.axis, request.table.positions
        counts = str(request.facts.stated.get("table_form", "tenths"))
        count = float(self.scale_of(axis).factor("node_position"))
        values = {
            "points": str(positions.size),
            "counts": COUNTS.get(counts, counts),
            "values": str(self.options_of(axis)["table_values"]),
            "axis_unit": axis.kind.unit,
            **sign_check(request.table, request.check_at),
        }
        if positions.size:
            values["start"] = typed_number(round(float(positions[0]) / count))
            values["end"] = typed_number(round(float(positions[-1]) / count))
        return AxisCard(values | named_files(self, axis, request.files))

    def between(self, request: BetweenRequest) -> Between:
        """Return the corrected axis' list with the added correction; see `Family.between`."""
        return lists_between(self, request)
