"""Read the cross-axis tables (SINUMERIK CEC) from the control's files as curves.

If an axis' reversal error varies with the position, such a control has two tables with this axis as
input and output, one for each direction. The corrections of active tables with the same axes are
added. A table that is multiplied by another one is not read.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from decimal import Decimal

from compwright.formats.families.activity import Activity
from compwright.formats.families.grid.table_shapes import shape_of
from compwright.formats.families.grid.tables import GridTable, TableSource
from compwright.formats.families.pairs.lines import SingleValues, TableLines, Units
from compwright.formats.families.pairs.places import (
    ADDED,
    AS_TABLE,
    DATA,
    NEEDED,
    Pair,
    Places,
    is_unused,
    is_whole,
    is_zero,
    last,
    of_axis,
    places_of,
    print_of,
)
from compwright.formats.families.pairs.tables import Cec, CecTable, OddTable
from compwright.formats.text.gathering import FoundValue, Gathered, same_value
from compwright.formats.text.notes import CORRECT_VALUE, EXPORT_AGAIN, NOT_COUNTED, Notes
from compwright.formats.text.scale import NumberScale
from compwright.records.axis import Axis, Direction
from compwright.words.sentences import control_text

_ZERO = (Decimal(0),)
#: Settings of a table other than its curve: quantity, effect, and the values without effect.
_ODD = (
    ("cross_type", "makes it a special table", _ZERO),
    ("cross_input_ncu", "takes its input from another NCU", (Decimal(1), *_ZERO)),
    ("cross_output_ncu", "sends its output to another NCU", (Decimal(1), *_ZERO)),
    ("cross_first_added", "(SD41320) is added to its point 0", _ZERO),
    ("cross_second_added", "(SD41321) is added to its point 1", _ZERO),
)
_DIRECTIONS = {"0": tuple(Direction), "1": (Direction.POSITIVE,), "-1": (Direction.NEGATIVE,)}


@dataclass(frozen=True, slots=True)
class Writable:
    """The cross-axis tables that compwright is allowed to write: table indices by the address of
    the axis that they correct.

    ``sign_known``: it is known whether table values are corrections or errors. ``drafted``: the
    indices that may be written on all other axes; None if the files are only displayed.
    """

    indices: Mapping[str, Collection[int]]
    sign_known: bool
    drafted: Collection[int] | None = None

    def stays(self, one: TableLines) -> bool:
        """Return whether table ``one``, by which an axis corrects itself, is active and will not be
        written.

        It will not be written if its index is not among those that compwright may write.
        """
        return self.not_ours(one.index, one.pair[1]) and one.known_on()

    def not_ours(self, index: int, output: str) -> bool:
        """Return whether table ``index`` on the axis ``output`` must not be written."""
        given = self.indices.get(output, self.drafted)
        return given is not None and index not in given


def _largest(places: Places) -> float:
    """Return the largest amount in a table, multiplied by its weight, in the unit of the files."""
    weight = last("cross_weight", places)
    factor = abs(float(weight.text)) if weight is not None else 1.0
    amounts = [abs(float(row.text)) for row in places.get("cross_value", ())]
    added = [abs(float(place.text)) for name in ADDED for place in places.get(name, ())[-1:]]
    return factor * (max(amounts, default=0.0) + max(added, default=0.0))


class CecReader(SingleValues):
    """Reads all cross-axis tables (CEC) in the files; faults are added to ``notes``.

    ``scale``: unit and sign of the numbers in a cross-axis table. ``wanted``: the axes of the job
    (empty: all axes). ``units``: the length units of the files.

    A table cannot be read as a curve for one of these reasons: its range is no multiple of the
    step, its output is no machine axis, a key or the unit is unknown, or the control multiplies it
    by another table.

    Such a table is reported and stays unchanged, with two exceptions, which are faults:

    - Its lines are incomplete or contradict each other.
    - It is active, may be written (``writable``) and corrects an axis of the job. Its input is the
      same axis, or the control multiplies it by another table.
    """

    def __init__(
        self,
        gathered: Gathered,
        scale: NumberScale,
        notes: Notes,
        wanted: Mapping[str, Axis | None],
        activity: Activity,
        units: Units,
        writable: Writable,
    ) -> None:
        super().__init__(gathered, notes)
        self.units = units
        self.writable = writable
        self.scale = scale
        self.wanted = wanted
        self.activity = activity
        self.places = dict(sorted(places_of(gathered).items()))
        self.occupied: dict[int, Pair] = {}
        self.odd: list[OddTable] = []
        self.quiet: list[int] = []
        self.missing: list[int] = []

    def read(self) -> Cec:
        """Return all cross-axis tables in the files, and those that cannot be used."""
        places = self.places
        tables = [self._table(index, found) for index, found in places.items()]
        self._note_empty()
        reserved = {
            index: self.values(f"CEC table {index}").one(
                "cross_max_points", found.get("cross_max_points", ())
            )
            for index, found in places.items()
        }
        return Cec(
            tables=tuple(table for table in tables if table is not None),
            odd=tuple(self.odd),
            occupied=self.occupied,
            reserved={
                index: int(found.text) for index, found in reserved.items() if found is not None
            },
            max_sum=self._max_sums(),
            metric=self._metric(),
            prints={index: print_of(found) for index, found in places.items()},
            missing={address: self.missing for address in self.wanted if self._may_be_on(address)},
        )

    def _may_be_on(self, address: str) -> bool:
        """Return whether the files leave it possible that tables correct the axis."""
        enabled = last("cross_axis_enabled", of_axis(self.gathered, address))
        return enabled is None or not same_value(enabled.text, "0")

    def _table(self, index: int, places: Places) -> CecTable | None:
        """Return one cross-axis table; None if its lines contain no table, or a table that cannot
        be used or written.
        """
        if not any(name in places for name in DATA):
            self._note_missing(index, places)
            return None
        if is_unused(places):
            return None
        one = _CrossTableReader(self.gathered, index, places, self.activity, self.units)
        stays = self.writable.stays(one)
        table = one.curve(self.scale, under_work=one.pair[1] in self.wanted, stays=stays)
        self.occupied[index] = one.pair
        if not one.notes.faults:
            self.notes.take(one.notes)
            if table is None or not (stays and table.active and table.values.any()):
                return table
            if self.writable.sign_known:
                return replace(table, stays=True)
            self._note_left_alone(
                one, control_text("the sign of its values is not given (option cec_sign)")
            )
            return None
        if is_zero(places) and "cross_value" in places and is_whole(places) and not one.damaged:
            self.quiet.append(index)
        else:
            self._leave_alone(one)
        return None

    def _note_missing(self, index: int, places: Places) -> None:
        """Record a table that is switched on and that no file contains: what it adds now is
        unknown. Refuse it if it may be written, because a new table would replace it.
        """
        on, room = last("cross_table_enabled", places), last("cross_max_points", places)
        allowed = {*(self.writable.drafted or ())}.union(*self.writable.indices.values())
        if on is None or not same_value(on.text, "1"):
            return
        if room is not None and Decimal(room.text) == 0:
            return
        if index not in allowed:
            self.missing.append(index)
            return
        name = self.values(f"CEC table {index}").name
        self.notes.refuse(
            f"CEC table {index}",
            f"it is switched on ({name('cross_table_enabled')}), but no given file contains it"
            f" ({name('cross_value')})",
            on,
            expected="the file with the table too",
            hint="export the cross-axis tables from the control (NC_CEC.INI), and add this file to"
            " the control's files; or take the index out of `cec_tables`",
        )

    def _note_empty(self) -> None:
        """Report tables of zeros that cannot be read as a curve."""
        if self.quiet:
            self.notes.find("CW-S054", "info", tables=self.quiet)

    def _leave_alone(self, one: _CrossTableReader) -> None:
        """Record that a table with faults stays unchanged; if it is incomplete or corrects an axis
        of the job, report its faults instead.
        """
        faults = one.notes.faults
        damaged = "cross_value" not in one.places or not is_whole(one.places) or one.damaged
        ours = one.on() and self._touched(one) and (one.times is not None or one.itself)
        if damaged or (ours and not self.writable.stays(one)):
            self.notes.faults.extend(fault for fault in faults if fault not in self.notes.faults)
            return
        self._note_left_alone(one, faults[0].message.removeprefix(f"{one.label}: "))

    def _touched(self, one: _CrossTableReader) -> bool:
        return not self.wanted or any(self._touches(one.pair, each) for each in self.wanted)

    def _note_left_alone(self, one: _CrossTableReader, why: str) -> None:
        """Record a table that stays unchanged, with the largest correction that it adds."""
        active, product, touched = one.on(), one.times is not None, self._touched(one)
        largest = one.to_millimetres()[1] * _largest(one.places) if active else 0.0
        if one.times is not None:
            largest *= 1.0 + _largest(self.places.get(one.times, {}))
        self.odd.append(OddTable(one.index, *one.pair, why, largest, one.times))
        base, corrected = one.pair
        self.notes.find(
            "CW-S011" if product else "CW-S050.cec",
            "warning" if active and touched else "info",
            label=one.label,
            input=base,
            output=corrected,
            why=why,
            active=active,
        )

    def _touches(self, pair: Pair, address: str) -> bool:
        """Return whether a table of this axis pair corrects the axis at ``address``.

        True also if the output name is not that of a machine axis but begins with the letter of
        this axis. It may then be another name of the axis.
        """
        if pair[1] == address:
            return True
        if pair[1] and self.gathered.names.known(pair[1]) and self.gathered.names.places:
            return False
        axis = self.wanted.get(address)
        letters = {
            name.upper().rstrip("0123456789")
            for name in (address, axis.name if axis is not None else address)
        }
        return pair[1].rstrip("0123456789") in letters - {"AX"}

    def _max_sums(self) -> dict[str, float]:
        """Return the limit of the sum of all tables on each output axis (CEC_MAX_SUM)."""
        sums: dict[str, float] = {}
        for (address, _), places in self.gathered.singles.items():
            label = control_text("axis {address}", address=str(address))
            found = self.values(label).one("cross_max_sum", places.get("cross_max_sum", ()))
            if address is not None and found is not None:
                sums[address] = float(found.text) * self.units.basic(address)
                if not sums[address] >= 0:
                    self.notes.refuse(
                        label, "a limit below 0", found, expected="0 or more", hint=CORRECT_VALUE
                    )
        return sums

    def _metric(self) -> dict[str, bool]:
        """Return, by output axis, whether its tables are in mm; axes whose unit no file states are
        left out.
        """
        stated = {
            address: self.word(f"axis {address}", "cross_metric", places["cross_metric"][-1])
            for (address, _), places in self.gathered.singles.items()
            if address is not None and places.get("cross_metric")
        }
        return {address: word == "yes" for address, word in stated.items()}


class _CrossTableReader(TableLines):
    """Reads one cross-axis table (CEC) from its assignments."""

    @property
    def damaged(self) -> bool:
        """Whether lines of the table contradict each other."""
        return any("contradicts" in fault.message for fault in self.notes.faults)

    @property
    def times(self) -> int | None:
        """The index of the table by which the control multiplies this one; None if it multiplies by
        none.
        """
        found = last("cross_multiplier", self.places)
        return None if found is None or int(found.text) == 0 else int(found.text) - 1

    def curve(self, scale: NumberScale, *, under_work: bool, stays: bool) -> CecTable | None:
        """Return the table as corrections by position; None, with reasons noted, if unusable.
        ``under_work``: the job names the axis that the table corrects; ``stays``: no new table will
        replace this one.
        """
        singles = {name: self._one(name) for name in DATA if name != "cross_value"}
        count, anything = self.definition.limit_number("cross_tables"), next(iter(self.places))
        if count is not None and self.index >= count:
            self._wrong(f"the control has {count} tables only", self.places[anything][0])
        self._unknown_keys()
        self._unsupported_settings()
        missing = [name for name in NEEDED if name not in self.places]
        unclear = bool(missing) or self.damaged
        first = next(iter(self.places.values()))[0]
        for name in missing:
            self._wrong(
                f"{self.values(self.label).name(name)} is missing", first, hint=EXPORT_AGAIN
            )
        stated = {name: found for name, found in singles.items() if found is not None}
        if unclear:
            return None
        self._check_axes(stated)
        table = self._table(scale, stated)
        directions = self._directions(stated["cross_direction"])
        if table is None or directions is None:
            return None
        active = self.is_active(under_work=under_work, stays=stays)
        if active and not self._simple(stated.get("cross_multiplier")):
            return None
        self._check_reserved(table)
        weight = self._one("cross_weight")
        values = table.positive if weight is None else float(weight.text) * table.positive + 0.0
        period = self._period(table, stated.get("cross_repeats"), quiet=not active)
        return CecTable(self.index, *self.pair, directions, table.positions, values, period, active)

    def _one(self, quantity: str) -> FoundValue | None:
        return self.values(self.label).one(quantity, self.places.get(quantity, ()))

    def _table(self, scale: NumberScale, stated: Mapping[str, FoundValue]) -> GridTable | None:
        singles = {AS_TABLE[name]: found for name, found in stated.items() if name in AS_TABLE}
        repeats = stated.get("cross_repeats")
        turns = repeats is not None and not same_value(repeats.text, "0")
        rows, strict = self.places["cross_value"], turns or is_zero(self.places)
        source = TableSource(self.label, rows, singles, scale, self.notes, strict)
        table = shape_of(self.definition).read(source)
        along, up = self.to_millimetres()
        if table is None or along == up == 1.0:
            return table
        return GridTable(along * table.positions, up * table.positive, up * table.negative)

    def _period(self, table: GridTable, repeats: FoundValue | None, *, quiet: bool) -> float | None:
        if self.word(self.label, "cross_repeats", repeats, tell=not quiet) != "yes":
            return None
        if repeats is not None and table.positive[0] != table.positive[-1]:
            self._wrong("the table repeats, but the values at its two ends differ", repeats)
        return float(table.positions[-1] - table.positions[0])

    def _wrong(
        self,
        message: str,
        place: FoundValue,
        *,
        expected: str = "",
        found: str | None = None,
        hint: str = CORRECT_VALUE,
    ) -> None:
        self.notes.refuse(self.label, message, place, expected=expected, found=found, hint=hint)

    def _check_axes(self, stated: Mapping[str, FoundValue]) -> None:
        for name in ("cross_input", "cross_output"):
            if not self.gathered.names.known(self.gathered.axis(stated[name].text)):
                message = f"{self.values(self.label).name(name)} is not a machine axis"
                self._wrong(message, stated[name], expected="a name of MD10000, or AX1 and so on")

    def _unknown_keys(self) -> None:
        for found in self.places.get("cross_other", ()):
            key = found.occurrence.tokens["key"].text
            message = f"$AN_CEC_{key} cannot be read: the key is not known, or has no such value"
            expected = "a key and a value as the control writes them (yes and no: 1 and 0)"
            self._wrong(message, found, expected=expected)

    def _unsupported_settings(self) -> None:
        """Refuse a table with settings other than its points, its weight and its activation."""
        for quantity, what, expected in _ODD:
            found = self._one(quantity)
            if found is not None and Decimal(found.text) not in expected:
                name = self.values(self.label).name(quantity)
                self._wrong(f"{name} {what}", found, expected=str(expected[0]), hint=NOT_COUNTED)

    def _directions(self, found: FoundValue) -> tuple[Direction, ...] | None:
        for text, directions in _DIRECTIONS.items():
            if same_value(text, found.text):
                return directions
        self._wrong("the direction of the table is unknown", found, expected="0 (both), 1 or -1")
        return None

    def _simple(self, multiplier: FoundValue | None) -> bool:
        """Return whether the control multiplies the table by no other table."""
        if multiplier is None or int(multiplier.text) == 0:
            return True
        message = (
            f"it is multiplied by table {int(multiplier.text) - 1} (MULT_BY_TABLE), which is not a"
            " curve over one axis"
        )
        self._wrong(message, multiplier, expected="0: not multiplied", hint=NOT_COUNTED)
        return False

    def _check_reserved(self, table: GridTable) -> None:
        fixed = self.definition.limit_number("cross_points")
        if fixed is not None and table.positions.size > fixed:
            message = f"more points than the {fixed} of such a table"
            self._wrong(message, self.places["cross_value"][fixed], found=str(table.positions.size))
        reserved = self._one("cross_max_points")
        if reserved is not None and int(reserved.text) < table.positions.size:
            message = "the control has not reserved so many points"
            self._wrong(message, reserved, found=str(table.positions.size))
