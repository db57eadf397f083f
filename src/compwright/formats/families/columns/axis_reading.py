"""Read the compensation of one axis from its entry sheet, its parameters and its table column."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from typing import Literal

import numpy as np

from compwright.formats.families.activity import Activity
from compwright.formats.families.columns.table import SECOND
from compwright.formats.families.columns.values import TableValues
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import ADD_FILE, CORRECT_VALUE
from compwright.formats.text.scale import NumberScale, in_range
from compwright.formats.text.values import Values
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.facts import Fact
from compwright.records.options import REFERENCE, REFERENCE_RETURN, TABLE_VALUES
from compwright.words.sentences import control_text


class ColumnAxisReader:
    """Reads one axis: its entry sheet, its parameters, and the table column that corrects the axis
    by its own position.
    """

    def __init__(
        self, values: TableValues, address: str, wanted: Sequence[str], activity: Activity
    ) -> None:
        self.values = values
        self.wanted = wanted
        self.activity = activity
        self.zero = values.control.options
        self.sources = values.sources
        self.definition = values.definition
        self.notes = values.notes
        self.address = address
        self.axis = values.axes.get(address)
        self.label = control_text("axis {address}", address=address)
        self.parameters = Values(values.definition, self.label, values.notes)
        self.table = self.sources.tables.get(address)
        self.column = self.sources.own_column(address)
        self.points = self.sources.points.get(address, ())
        self.facts: dict[str, Fact] = {"enabled": False, "own_column": self.column is not None}
        self.facts["second_column"] = (
            self.table is not None and self.table.column(SECOND) is not None
        )
        if address in self.sources.sheets:
            self.facts[TABLE_VALUES] = self.sources.sheets[address].comments["value"]
        self.curves = self._curves()

    @property
    def is_mentioned(self) -> bool:
        """Whether the files contain a correction of the axis that depends on its own position or
        reversal, or state that no table corrects it.
        """
        given = any((self.address, name) in self.sources.given for name in ("backlash", "slope"))
        return (
            given
            or self.address in self.sources.sheets
            or self.curves is not None
            or self._switched_on_alone()
            or self._without_table()
        )

    def _switched_on_alone(self) -> bool:
        bits = self.sources.given.get((self.address, "enabled"), [])
        return self.address in self.wanted and any(bit.text == "1" for bit in bits)

    def _without_table(self) -> bool:
        assigned = self.address in self.sources.assigned and self.address in self.wanted
        return assigned and not self._column_elsewhere()

    @property
    def idle(self) -> tuple[float, ...]:
        """The positions of the points of an inactive table, mm or deg."""
        if self.curves is None or self.facts["enabled"]:
            return ()
        return tuple(float(point) for point in self.curves[0])

    def read(self) -> AxisCompensation:
        """Return the active compensation of the axis. Faults are added to the notes."""
        kind = self.values.kind(self.address)
        scale = self.values.scale(self.address)
        enabled = self._enabled()
        self.facts["enabled"] = enabled
        returns = (
            self.axis.reference_return if self.axis else Direction(str(self.zero[REFERENCE_RETURN]))
        )
        none = np.empty(0)
        positions, positive, negative, period = (
            self.curves if self.curves is not None and enabled else (none, none, none, None)
        )
        backlash = self._parameter("backlash", scale)
        if backlash:
            evidence = self.definition.bindings["backlash"].evidence
            name = self.parameters.name("backlash")
            self.notes.assume(
                control_text("{label}: {fact}", label=self.label, fact=name),
                control_text("nothing is added arriving in {direction}", direction=str(returns)),
                evidence.text,
            )
        return AxisCompensation(
            address=self.address,
            kind=kind,
            positions=positions,
            positive=positive,
            negative=negative,
            backlash=backlash,
            reference_return=returns,
            below=self.definition.layout.below,
            above=self.definition.layout.above,
            period=period,
            slope=self._slope(scale, kind, enabled=enabled),
            origin=self.axis.reference if self.axis else float(str(self.zero[REFERENCE])),
        )

    # --- the table

    def _curves(self) -> tuple[FloatArray, FloatArray, FloatArray, float | None] | None:
        """Return the positions of the axis' table, its corrections in + and in - direction, and its
        period; None if the files contain no valid table.
        """
        missing = self.sources.missing.get(self.address)
        if missing is not None and (self.address in self.wanted or not self.wanted):
            file = self.sources.assignments.file if self.sources.assignments is not None else ""
            self.notes.faults.append(
                Fault(
                    message=f"{self.label}: the active table was not given",
                    file=file,
                    expected=missing,
                    found="no such file",
                    hint=f"give {missing} with the control's other files",
                )
            )
        own = self._own_column() if self.table is not None and self.column is not None else None
        if own is not None and self.points:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"{self.label} has two tables: an entry sheet and a column of "
                        f"{self.table.file if self.table else ''}"
                    ),
                    file=self.sources.sheets[self.address].name,
                    expected="one of them",
                    hint="leave out the entry sheet or the table",
                )
            )
        return own if own is not None else self._sheet_curves()

    def _sheet_curves(self) -> tuple[FloatArray, FloatArray, FloatArray, float | None] | None:
        if not self.points:
            return None
        sheet = self.sources.sheets[self.address]
        scale = self.values.scale(self.address)  # its values mean what the sheet says
        known = len(self.notes.faults)
        values = []
        for point in self.points:
            value = scale.read("value", str(point.value))
            position = scale.read("node_position", str(point.position))
            for quantity, number in (("value", value), ("node_position", position)):
                if not in_range(self.definition.measure(quantity), scale, number):
                    message = (
                        f"{self.label}: a {'value' if quantity == 'value' else 'position'} this"
                        " large is not plausible"
                    )
                    self.values.fault(
                        sheet.name, f"line {point.line}", message, "see formats show", str(number)
                    )
            values.append(float(value) + 0.0)
        most = self.definition.limit_number("max_points")
        if most is not None and len(values) > most:
            self.values.fault(
                sheet.name,
                f"line {self.points[most].line}",
                f"{self.label}: the table has more points than the control accepts",
                f"at most {most}",
                str(len(values)),
            )
        if len(self.notes.faults) > known:
            return None
        points, curve, period = self.values.turned(
            self.address,
            np.array([float(point.position) for point in self.points]),
            np.array(values),
            sheet.name,
        )
        return points, curve, curve, period

    def _own_column(self) -> tuple[FloatArray, FloatArray, FloatArray, float | None] | None:
        if self.table is None or self.column is None:
            return None
        positions = self.values.positions(self.table, self.address)
        if positions is None:
            return None
        positive = self.values.values(
            self.table, self.column, positions, self.address, self.address
        )
        second = None
        if self.facts["second_column"]:
            second = self.values.values(self.table, SECOND, positions, self.address, self.address)
        if second is not None and (positive is None or self._second_refused(second, positive)):
            self.values.fault(
                self.table.file,
                "",
                f"{self.label}: what the column {SECOND} means is not confirmed",
                f"a column that is blank or equal to {self.column}, or the option"
                " backlash_column=second_curve",
                "other values",
            )
            return None
        if positive is None:
            return None
        where = np.array([float(position) for position in positions])
        points, curve, period = self.values.turned(self.address, where, positive, self.table.file)
        negative = (
            curve
            if second is None
            else self.values.turned(self.address, where, second, self.table.file)[1]
        )
        return points, curve, negative, period

    def _second_refused(self, second: FloatArray, positive: FloatArray) -> bool:
        allowed = self.values.own_options(self.address).get("backlash_column") == "second_curve"
        return not allowed and not np.array_equal(second, positive)

    # --- parameters

    def _found(self, quantity: str) -> FoundValue | None:
        """Return a parameter of the axis. If several files state it, they must agree."""
        given = self.sources.given.get((self.address, quantity), [])
        return self.parameters.one(quantity, given, quiet=True)

    def _enabled(self) -> bool:
        """Return whether the table is active by the control's parameter or list of tables; if the
        files state neither, by the job.
        """
        found = self._found("enabled") if "enabled" in self.definition.bindings else None
        if (
            found is not None
            and found.text == "1"
            and self.curves is None
            and not self._column_elsewhere()
            and not self.notes.faults
        ):
            message = f"{self._switch} selects a table, but it is in no file"
            self.notes.refuse(
                self.label, message, found, expected="the table too", found="none", hint=ADD_FILE
            )
        if found is not None and found.text == "0" and self.activity.stated is not True:
            if self.curves is not None:
                self.notes.switched_off(self.label, self._switch)
            return False
        if self.curves is None:
            if found is None and self._other_columns_active() and not self.sources.starred:
                self._answer(None, None)
            elif found is None and self.sources.assignments is None:
                self._assume_switch(
                    control_text("0: no table is active on it"),
                    control_text("no file contains a table of the axis"),
                )
            return found is not None and found.text == "1"
        if found is None and self.points:
            active = self.activity.stated is not False
            self._assume_switch(
                control_text("1: its table is active")
                if active
                else control_text("0: its table is not active"),
                control_text("a sheet is what was typed in"),
            )
            return active
        if not (np.any(self.curves[1]) or np.any(self.curves[2]) or self._other_columns_active()):
            return self._zeros(found)
        word = (
            "yes"
            if self.sources.starred
            else None
            if found is None
            else "yes"
            if found.text == "1"
            else "no"
        )
        return self._answer(word, found)

    def _zeros(self, found: FoundValue | None) -> bool:
        """Return whether a table that contains only zeros must be treated as active. ``found``: the
        line that activates tables; None if it is in no file.

        Such a table corrects nothing. But if it is not active, the linear error parameter is
        active.
        """
        slope = self._found("slope")
        if found is not None or self.sources.starred:
            return True
        if slope is None or Decimal(slope.text) == 0:
            self._assume_switch(
                control_text("1: its table of zeros is active"),
                control_text("zeros correct nothing"),
            )
            return True
        name = self.parameters.name("slope")
        if self.activity.stated is None and self.activity.asking:
            self.notes.ask(
                Fault(
                    message=(
                        f"{self.label}: {name} is not zero. It is active only if no table is "
                        f"selected, and no file contains the switch {self._switch}, which shows "
                        "whether a table is selected"
                    ),
                    file=slope.occurrence.file,
                    place=slope.occurrence.place,
                    expected=(
                        f"{self._switch} among the files, or the answer `active: yes` or `active: "
                        "no`"
                    ),
                    found=slope.text,
                    hint=(
                        f"give the file with {self._switch} with the control's other files, or "
                        "write `active: yes` (a table was selected) or `active: no` (no table "
                        "was selected) into this entry of `states` in the job"
                    ),
                )
            )
        self.notes.open_answers += 1
        active = self.activity.stated is not False
        self._assume_switch(
            control_text("1: {parameter} is not active", parameter=name)
            if active
            else control_text("0: {parameter} is active", parameter=name),
            "" if self.activity.stated is None else control_text("the job's answer (active)"),
        )
        return active

    def _assume_switch(self, value: str, evidence: str) -> None:
        """Record as an assumption the value of the parameter that activates the table; no file
        contains it.
        """
        source = control_text("in no file")
        self.notes.assume(
            control_text("{label}: {fact}", label=self.label, fact=self._switch),
            value,
            control_text("in no file; {evidence}", evidence=evidence) if evidence else source,
        )

    @property
    def _switch(self) -> str:
        known = "enabled" in self.definition.bindings
        if not known:
            return control_text("the active line of the .CMA")
        return self.parameters.name("enabled")

    def _answer(self, word: str | None, found: FoundValue | None) -> bool:
        """Return whether the table is active: by the value ``word`` of its activation parameter,
        else by the job. ``found``: the line of this parameter, if there is one.

        If neither the parameter nor the job states it, the table is assumed to be active.
        """
        place = found if found is not None and found.occurrence.tokens else None
        active = self.activity.was_active(self.label, self._switch, word, place, self.notes)
        if active is None:
            self.notes.assume(
                control_text("{label}: its table", label=self.label),
                control_text("active"),
                control_text(
                    "{switch} is not in the files: a table that was given counts",
                    switch=self._switch,
                ),
            )
        return active is not False

    def _column_elsewhere(self) -> bool:
        """Return whether a table that follows another axis has a column that corrects this axis."""
        column = self.sources.column_of(self.address)
        return any(
            moving != self.address and table.column(column) is not None
            for moving, table in self.sources.tables.items()
        )

    def _other_columns_active(self) -> bool:
        """Return whether the axis is one of the ``wanted`` axes and a table that follows another
        axis has values for it.
        """
        column = self.sources.column_of(self.address)
        return self.address in self.wanted and any(
            moving != self.address and table.fills(column)
            for moving, table in self.sources.tables.items()
        )

    def _parameter(self, quantity: str, scale: NumberScale) -> float:
        found = self._found(quantity)
        if found is None:
            self.parameters.absent(quantity)
            return 0.0
        value = scale.read(quantity, found.text)
        if not in_range(self.definition.measure(quantity), scale, value):
            low, high = self.definition.measure(quantity).range
            self.notes.refuse(
                self.label,
                f"{self.parameters.name(quantity)} is outside what the control takes",
                found,
                expected=f"{low:g} .. {high:g} {scale.unit(quantity)}",
                found=found.text[:60],
                hint=CORRECT_VALUE,
            )
        return float(value) + 0.0

    def _slope(self, scale: NumberScale, kind: AxisKind, *, enabled: bool) -> float:
        slope = self._parameter(
            "slope", NumberScale(self.definition, AxisKind.LINEAR, scale.options, scale.choices)
        )
        why: Literal["table", "rotary", ""] = (
            "table" if enabled else "rotary" if kind is AxisKind.ROTARY else ""
        )
        if not why and self._found("slope") is None:
            self.notes.counted_as(self.label, self.parameters.name("slope"), "0")
        if slope and why:
            self.notes.ignored(self.label, self.parameters.name("slope"), why)
        return 0.0 if why else slope
