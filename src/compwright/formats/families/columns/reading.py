"""Controls whose tables stand in files of the user's own making (HEIDENHAIN): what the files say ->
compensation.

A table belongs to the axis that moves; each of its columns is what that motion does to one axis:
its own column to itself, another axis' column to that one (facts of the manuals: TNC 407 technical
manual p153, MANUALplus 620 p716 and p718). What is typed in at the control stands in entry sheets.
Parameters (backlash, linear error, which of line and table acts) stand in sheets or lines.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.formats.definition.options import (
    REFERENCE,
    REFERENCE_RETURN,
    TABLE_VALUES,
)
from compwright.formats.definition.schema import Definition
from compwright.formats.families.activity import Activity
from compwright.formats.families.columns.sources import (
    PARAMETERS,
    Given,
    Sources,
    find_sources,
    parameter_name,
)
from compwright.formats.families.columns.text import POSITION, SECOND, is_number
from compwright.formats.families.columns.values import TableValues
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.gathering import Found, same_value
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import Scale, in_range
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts, Fact


def read_user_tables(
    definition: Definition,
    files: Sequence[ControlFile],
    options: Mapping[str, object],
    axes: Sequence[Axis] = (),
    *,
    address: str | None = None,
    activity: Activity = Activity(),  # noqa: B008 - frozen
) -> ControlState:
    """Return what a control does with ``files``; arguments and errors as `Family.read`.

    ``facts`` hold, for every axis of the result: ``enabled`` (its table acts), ``own_column`` and
    ``second_column`` (its own table among the files has a column for it, and one for travel in -).
    """
    if not files:
        raise UsageError(
            "no file of the control was given; expected its own files, or the state `none`"
        )
    return _StateReader(definition, files, options, axes, address, activity).read()


class _StateReader:
    def __init__(
        self,
        definition: Definition,
        files: Sequence[ControlFile],
        options: Mapping[str, object],
        axes: Sequence[Axis],
        address: str | None,
        activity: Activity,
    ) -> None:
        self.definition = definition
        self.activity = activity
        self.options = options
        self.notes = Notes()
        self.axes = {normal_address(definition, axis)[0]: axis for axis in axes}
        self.asked = [*self.axes, *([] if address is None else [normal_text(definition, address)])]
        self.files = files
        self.sources = find_sources(definition, files, axes, self.notes.faults)
        raise_all(InputError, self.notes.faults)
        self.notes.findings.extend(self.sources.findings)
        self.values = TableValues(definition, self.sources, self.axes, options, self.notes)

    def read(self) -> ControlState:
        sources = self.sources
        mentioned = sources.mentioned()
        compensations: dict[str, AxisCompensation] = {}
        facts: dict[str, AxisFacts] = {}
        for address in self.asked or mentioned:
            if address not in mentioned and not sources.idle:
                self.notes.faults.append(_unnamed(address, mentioned, self.files))
            reader = _AxisReader(self, address)
            if reader.spoken_of:
                compensations[address] = reader.read()
            if reader.spoken_of or address in self.asked:
                facts[address] = AxisFacts(enabled=bool(reader.facts["enabled"]), said=reader.facts)
        cross = self._cross()
        if not compensations and not cross and not sources.idle and not self.notes.faults:
            names = ", ".join(file.name for file in self.files)
            self.notes.faults.append(
                Fault(message="the files say nothing about the compensation of an axis", file=names)
            )
        self.notes.ask_contradicted()
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        self._general(compensations)
        return ControlState(
            format=self.definition.id,
            axes=compensations,
            cross=cross,
            facts=facts,
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
        )

    def _cross(self) -> tuple[CrossCompensation, ...]:
        found = []
        layout = self.definition.layout
        for moving, table in self.sources.tables.items():
            own = self.sources.column_of(moving)
            for name in table.others(own, POSITION, SECOND):
                positions = self.values.positions(table, moving)
                output = self.sources.axis_of(name)
                values = (
                    None
                    if positions is None
                    else self.values.values(table, name, positions, output, moving)
                )
                if positions is None or values is None:
                    continue
                nodes, curve, period = self.values.turned(
                    moving, np.array([float(one) for one in positions]), values, table.file
                )
                if self._off(
                    output
                ):  # no table acts on this axis; the column is there all the same
                    curve = np.zeros(nodes.size)
                found.append(
                    CrossCompensation(
                        input=moving,
                        output=output,
                        input_kind=self.values.kind(moving),
                        output_kind=self.values.kind(output),
                        positions=nodes,
                        positive=curve,
                        negative=curve,
                        below=layout.below,
                        above=layout.above,
                        period=period,
                    )
                )
        return tuple(found)

    def _off(self, address: str) -> bool:
        """Whether the files, or the job where these leave it open, say that no table acts on an
        axis.
        """
        bits = self.sources.given.get((address, "enabled"), [])
        if bits:
            return bits[0].text == "0" and self.activity.said is not True
        return self.activity.said is False and not self.sources.starred

    def _general(self, compensations: Mapping[str, AxisCompensation]) -> None:
        """Note what concerns all axes: what was not given, what is not active, and what had to be
        assumed.
        """
        sources = self.sources
        for file, address in sources.assumed.items():
            self.notes.assume(
                f"{file}: moving axis",
                address,
                "inferred from its name: no table of assignments (.CMA) was given",
            )
        for table in sources.idle:
            self.notes.idle_file(
                f"{table.file} is not named by the active line of assignments: it does not act"
            )
        for address, name in sources.missing.items():
            if address not in self.asked:
                message = (
                    f"{name}, active for the motion of {address}, was not given: what it does to"
                    " other axes is not known"
                )
                self.notes.idle_file(message)
        if any(one.positions.size for one in compensations.values()):
            self.notes.assume(
                "outside the tables", "the end values hold", str(self.definition.layout.evidence)
            )
        if any(address not in self.axes for address in compensations):
            self.notes.assume(REFERENCE, f"{self.options[REFERENCE]:g}", "option or its default")
            self.notes.assume(
                REFERENCE_RETURN, str(self.options[REFERENCE_RETURN]), "option or its default"
            )


class _AxisReader:
    """Reads one axis: its sheet, its own column of its own table, its parameters."""

    def __init__(self, reader: _StateReader, address: str) -> None:
        self.values = reader.values
        self.asked = reader.asked
        self.activity = reader.activity
        self.zero = reader.options
        self.sources: Sources = reader.sources
        self.definition = reader.definition
        self.notes = reader.notes
        self.address = address
        self.axis = reader.axes.get(address)
        self.label = f"axis {address}"
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
    def spoken_of(self) -> bool:
        """Whether a file says what the control does to this axis by itself."""
        given = any((self.address, name) in self.sources.given for name in ("backlash", "slope"))
        return (
            given
            or self.address in self.sources.sheets
            or self.curves is not None
            or self._switched_on_alone()
        )

    def _switched_on_alone(self) -> bool:
        bits = self.sources.given.get((self.address, "enabled"), [])
        return self.address in self.asked and any(bit.text == "1" for bit in bits)

    def read(self) -> AxisCompensation:
        """Return what acts on the axis; what is wrong goes to the notes."""
        kind = self.values.kind(self.address)
        options = self.values.own_options(self.address)
        scale = Scale(self.definition, kind, options, {"table_form": str(options["table_values"])})
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
            name = parameter_name(self.definition, "backlash")
            self.notes.assume(
                f"{self.label}: {name}", f"nothing is added arriving in {returns}", str(evidence)
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
        """Return nodes, the curve of each direction and the period; None where the axis has no
        table, or a faulty one.
        """
        missing = self.sources.missing.get(self.address)
        if missing is not None and (self.address in self.asked or not self.asked):
            file = self.sources.assignments.file if self.sources.assignments is not None else ""
            self.notes.faults.append(
                Fault(
                    message=f"{self.label}: the table that acts was not given",
                    file=file,
                    expected=missing,
                    found="no such file",
                )
            )
        own = self._own_column() if self.table is not None and self.column is not None else None
        if own is not None and self.points:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"{self.label}: two tables, an entry sheet and a column of"
                        f" {self.table.file if self.table else ''}"
                    ),
                    file=self.sources.sheets[self.address].name,
                    expected="one of them",
                )
            )
        return own if own is not None else self._sheet_curves()

    def _sheet_curves(self) -> tuple[FloatArray, FloatArray, FloatArray, float | None] | None:
        if not self.points:
            return None
        sheet = self.sources.sheets[self.address]
        kind = self.values.kind(self.address)
        scale = Scale(
            self.definition,
            kind,
            self.values.own_options(self.address),
            {"table_form": sheet.comments["value"]},
        )
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
            place = f"line {self.points[most].line}"
            self.values.fault(
                sheet.name,
                place,
                f"{self.label}: more points than the control takes",
                f"at most {most}",
                str(len(values)),
            )
        if len(self.notes.faults) > known:
            return None
        nodes, curve, period = self.values.turned(
            self.address,
            np.array([float(point.position) for point in self.points]),
            np.array(values),
            sheet.name,
        )
        return nodes, curve, curve, period

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
        nodes, curve, period = self.values.turned(self.address, where, positive, self.table.file)
        negative = (
            curve
            if second is None
            else self.values.turned(self.address, where, second, self.table.file)[1]
        )
        return nodes, curve, negative, period

    def _second_refused(self, second: FloatArray, positive: FloatArray) -> bool:
        allowed = self.values.own_options(self.address).get("backlash_column") == "second_curve"
        return not allowed and not np.array_equal(second, positive)

    # --- parameters

    def _found(self, quantity: str) -> Given | None:
        """Return a parameter; several files have to agree."""
        given = self.sources.given.get((self.address, quantity), [])
        for other in given[1:]:
            if not same_value(other.text, given[0].text):
                message = (
                    f"{self.label}: {parameter_name(self.definition, quantity)} contradicts"
                    f" {given[0].file}, {given[0].place}"
                )
                self.values.fault(other.file, other.place, message, given[0].text, other.text)
        return given[0] if given else None

    def _enabled(self) -> bool:
        """Return whether the table acts: by the parameter or the active line, else by what the job
        says of it.
        """
        found = self._found("enabled") if "enabled" in self.definition.bindings else None
        if (
            found is not None
            and found.text == "1"
            and self.curves is None
            and not self.notes.faults
        ):
            message = f"{self.label}: {self._switch} says that a table acts, but no file holds it"
            self.values.fault(found.file, found.place, message, "the table too", "none")
        if found is not None and found.text == "0" and self.activity.said is not True:
            if self.curves is not None:
                self.notes.switched_off(self.label, f"{self._switch} switches the table off")
            return False
        if self.curves is None:
            if found is None and self._others_act():
                self._answer(None, None)
            return found is not None and found.text == "1"
        if found is None and self.points:
            return self.activity.said is not False  # a sheet is what was typed in
        if not (np.any(self.curves[1]) or np.any(self.curves[2]) or self._others_act()):
            return True  # zeros: nothing hangs on it
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

    @property
    def _switch(self) -> str:
        known = "enabled" in self.definition.bindings
        return (
            parameter_name(self.definition, "enabled") if known else "the active line of the .CMA"
        )

    def _answer(self, word: str | None, found: Given | None) -> bool:
        """Return whether tables that are not zero act: what the files say (``word``), else the job;
        listed where nobody does.
        """
        place = (
            Found(found.text, found.occurrence, 0)
            if found is not None and found.occurrence is not None
            else None
        )
        acts = self.activity.settle(self.label, self._switch, word, place, self.notes)
        if acts is None:
            evidence = f"{self._switch} is not in the files: a table that was given counts"
            self.notes.assume(f"{self.label}: its table", "acts", evidence)
        return acts is not False

    def _others_act(self) -> bool:
        """Whether the motion of another axis corrects this one: the same bit selects such a
        column.
        """
        column = self.sources.column_of(self.address)
        cells = [
            row.cells[column].text
            for moving, table in self.sources.tables.items()
            if moving != self.address
            for row in table.rows
            if column in row.cells
        ]
        return self.address in self.asked and any(
            not is_number(text) or float(text) != 0 for text in cells
        )

    def _parameter(self, quantity: str, scale: Scale) -> float:
        found = self._found(quantity)
        binding = self.definition.bindings[quantity]
        if found is None:
            absent, name = binding.when_absent, parameter_name(self.definition, quantity)
            if absent is not None and absent.say == "warning":
                self.notes.assume(f"{self.label}: {name}", absent.value, str(absent.evidence))
                self.notes.counted_as(self.label, name, absent.value)
            return 0.0
        value = scale.read(quantity, found.text)
        if not in_range(self.definition.measure(quantity), scale, value):
            low, high = self.definition.measure(quantity).range
            message = (
                f"{self.label}: {parameter_name(self.definition, quantity)} is outside what the"
                " control takes"
            )
            self.values.fault(
                found.file,
                found.place,
                message,
                f"{low:g} .. {high:g} {scale.unit(quantity)}",
                found.text,
            )
        return float(value) + 0.0

    def _slope(self, scale: Scale, kind: AxisKind, *, enabled: bool) -> float:
        slope = self._parameter(
            "slope", Scale(self.definition, AxisKind.LINEAR, scale.options, scale.choices)
        )
        why = (
            "it has a table"
            if enabled
            else "it is a rotary axis"
            if kind is AxisKind.ROTARY
            else ""
        )
        if not why and self._found("slope") is None:
            self.notes.counted_as(self.label, parameter_name(self.definition, "slope"), "0")
        if slope and why:
            name = parameter_name(self.definition, "slope")
            self.notes.ignored(self.label, name, why)
        return 0.0 if why else slope


def _unnamed(address: str, mentioned: Sequence[str], files: Sequence[ControlFile]) -> Fault:
    return Fault(
        message=f"no file says anything about axis {address}; missing is not zero",
        file=", ".join(file.name for file in files),
        expected=f"a table, a sheet or {', '.join(PARAMETERS)} of {address}, or the state `none`",
        found=f"axes {', '.join(mentioned)}" if mentioned else "no axis at all",
    )
