"""Read one axis' active compensation from the files, with every assumption and doubt."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.definition.options import known_kind
from compwright.formats.definition.schema import Choice, Measure
from compwright.formats.families.activity import Activity
from compwright.formats.families.family import Family
from compwright.formats.families.grid.axis_values import SAYING, GridAxisValues
from compwright.formats.families.grid.joints import homing_of, joint_letters, unapplied_steps
from compwright.formats.families.grid.modulo_range import check_modulo, period_of
from compwright.formats.families.grid.systems import SystemChoice
from compwright.formats.families.grid.table_shapes import shape_of
from compwright.formats.families.grid.tables import GridTable, TableSource, value_fields
from compwright.formats.text.gathering import FoundValue, Gathered, first_set
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import NumberScale, in_range
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation
from compwright.records.facts import AxisFacts, Fact
from compwright.records.options import ENCODER_SYSTEM, REFERENCE, REFERENCE_RETURN
from compwright.words.sentences import control_text, unconfirmed

#: Software limits further away than this are none, in the unit of the files.
_NO_LIMIT = 99999.0
#: Limits converted to mm are shown to a nanometre.
_DECIMALS = 6


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisSource:
    """One axis in the control's files, with the matching axis of the job (``axis``), if any.

    ``rows``: its table rows, if the rows themselves do not name their axis; None if they do.
    ``elsewhere``: tables of another kind correct the axis, so that it needs no table of this kind.
    """

    address: str
    axis: Axis | None
    rows: Sequence[FoundValue] | None
    elsewhere: bool


@dataclass(frozen=True, slots=True)
class AxisReading:
    """The compensation of one axis as read from the files, and further facts about the axis."""

    compensation: AxisCompensation
    facts: AxisFacts


class GridAxisReader:
    """Reads the compensation of one axis from the values of the files, ``gathered`` by axis."""

    def __init__(
        self,
        control: Family,
        gathered: Gathered,
        source: AxisSource,
        activity: Activity,
        notes: Notes,
    ) -> None:
        self.definition = control.definition
        self.gathered = gathered
        self.address = source.address
        self.axis = source.axis
        self.elsewhere = source.elsewhere
        self.activity = activity
        self.notes = notes
        options = control.options_of(source.axis)
        system = self._measuring_system(options)
        self.system = None if system is None else int(system) + 1
        self.label = (
            control_text("axis {address}", address=self.address)
            if system is None
            else control_text(
                "axis {address}, measuring system {system}",
                address=self.address,
                system=str(self.system),
            )
        )
        self.rows = (
            gathered.rows.get((self.address, system), []) if source.rows is None else source.rows
        )
        self.values = GridAxisValues(
            self.definition, self.label, notes, gathered, self.address, system
        )
        self.options = self._resolved(options)

    def read(self) -> AxisReading:
        """Return the active compensation of the axis. Faults are added to the notes."""
        kind = self._kind()
        stated, max_points = self._stated_values(), self.values.single("max_points")
        has_table = bool(self.rows) or any(
            self.values.single(name) for name in shape_of(self.definition).rules.grid
        )
        enabled = self._enabled(has_table=has_table, max_points=max_points)
        facts = self._facts(kind, stated, enabled=enabled)
        repeats = has_table and enabled and self.values.choice("repeats") == "yes"
        check_modulo(self.values, self.axis)
        table: GridTable | None = None
        scale = self._scale(kind, has_table=has_table)
        if has_table and enabled and scale is not None:
            table = self._table(scale, max_points, repeats=repeats)
        backlash, constant = (
            self._backlash(scale, has_table=table is not None) if scale is not None else (0.0, 0.0)
        )
        period = None
        if repeats and table is not None:
            period = period_of(self.values, self.axis, self.rows, table)
        if has_table and table is None and scale is not None:
            facts = replace(facts, grid=self._idle_points(scale))
        if constant:
            facts = replace(facts, stated={**facts.stated, "backlash_in_curves": 2.0 * constant})
        if table is None:
            table = self._constant(constant)
        compensation = AxisCompensation(
            address=self.address,
            kind=kind,
            positions=table.positions,
            positive=table.positive,
            negative=table.negative,
            backlash=backlash,
            reference_return=self._returns(),
            below=self.definition.layout.below,
            above=self.definition.layout.above,
            period=period,
        )
        return AxisReading(compensation, facts)

    def _returns(self) -> Direction:
        if self.axis is None:
            return Direction(str(self.options[REFERENCE_RETURN]))
        return self.axis.reference_return

    def _stated_values(self) -> dict[str, Fact]:
        """Return the values in the files that have priority over options, and values to be printed
        on the card.
        """
        unit = self._unit()
        stated: dict[str, Fact] = {} if unit is None else {"length_unit": unit}
        for quantity in ("max_points", "gantry_type"):
            number = self.values.single(quantity)
            if number is not None:
                stated[quantity] = int(number.text)
        backlash = self.definition.bindings.get("backlash")
        if isinstance(backlash, Measure) and backlash.sign == "half_each_way":
            found = self.values.single("backlash")
            stated |= {} if found is None else {"typed_backlash": found.text}
        return stated

    def _facts(self, kind: AxisKind, stated: Mapping[str, Fact], *, enabled: bool) -> AxisFacts:
        """Return the facts of the axis in the files: kind, letter, software limits (mm or deg).

        On a rotary axis, an angle unit other than degrees is a fault, because its table would be
        written in degrees.
        """
        word = self.values.stated_word("rotary")
        names, order, joints = (
            found.text if (found := self.values.single(quantity)) is not None else ""
            for quantity in ("axis_letters", "axis_order", "joint_count")
        )
        letters = joint_letters(names, order, joints)
        listed = self.address.isdecimal() and int(self.address) < len(letters)
        if kind is AxisKind.ROTARY:
            self.values.stated_word("angle_unit")
        homing, zero = homing_of(self.values, self._factor(kind))
        if zero is not None:
            self.notes.assume(
                control_text("{label}: zero of the correction", label=self.label),
                control_text(
                    "{position} {unit}, approached in {direction}",
                    position=f"{zero[0]:g}",
                    unit=kind.unit,
                    direction=zero[1].value,
                ),
                control_text(
                    "the axis homes on a switch (HOME_OFFSET, HOME_LATCH_VEL): what the table holds"
                    " there counts as zero"
                ),
            )
        return AxisFacts(
            name=letters[int(self.address)] if listed else None,
            letters=letters if listed else "",
            kind=None if word is None else AxisKind(word),
            limits=self._limits(kind),
            encoder_system=self.system,
            enabled=enabled,
            reference=None if zero is None else zero[0],
            reference_return=None if zero is None else zero[1],
            homing=homing,
            unapplied_steps=unapplied_steps(self.values, self._factor(kind)),
            stated=stated,
        )

    def _factor(self, kind: AxisKind) -> float:
        """Return the factor from the files' length unit to mm; 1 on a rotary axis."""
        inch = kind is AxisKind.LINEAR and self.options.get("units") == "inch"
        return MILLIMETRES_PER_INCH if inch else 1.0

    def _limits(self, kind: AxisKind) -> tuple[float, float] | None:
        low, high = (self.values.single(name) for name in ("limit_low", "limit_high"))
        factor = self._factor(kind)
        if low is None or high is None:
            return None
        limits = float(low.text), float(high.text)
        if not all(abs(limit) < _NO_LIMIT for limit in limits):
            return None
        if factor == 1.0:
            return limits
        return round(limits[0] * factor, _DECIMALS), round(limits[1] * factor, _DECIMALS)

    def _unit(self) -> str | None:
        """Return the length unit of the files, mm or inch; None if they do not state it."""
        return next(
            (word for word in map(self.values.stated_word, SAYING) if word is not None), None
        )

    def _measuring_system(self, options: Mapping[str, object]) -> str | None:
        if not self.gathered.systems(self.address):
            return None
        choice = SystemChoice(self.gathered, self.address, self.notes)
        if self.axis is not None and self.axis.encoder.stated:
            return choice.stated(self.axis.encoder.system, by_job=True)
        if self.axis is None and options.get(ENCODER_SYSTEM, "auto") != "auto":
            return choice.stated(int(str(options[ENCODER_SYSTEM])), by_job=False)
        return choice.found(asking=self.axis is not None)

    def _resolved(self, options: Mapping[str, object]) -> Mapping[str, object]:
        """Return the options with the values that the control's files state for them."""
        resolved = dict(options)
        for name, rule in self.definition.options.items():
            if rule.settled_by is not None and isinstance(
                self.definition.bindings[rule.settled_by], Choice
            ):
                unit = rule.settled_by == "length_unit"
                word = self._unit() if unit else self.values.stated_word(rule.settled_by)
                if word is not None:
                    resolved[name] = word
                elif self.axis is None:
                    why = "not in the files that were given"
                    self.notes.assume(f"option {name}", str(options[name]), why)
        return resolved

    def _kind(self) -> AxisKind:
        if self.axis is None:
            known = known_kind(self.options, self.address)
            if known is None or self.values.stated_word("rotary") is not None:
                return AxisKind(self.values.choice("rotary") or "linear")
            return known
        word = self.values.stated_word("rotary")
        if word is not None and word != self.axis.kind:
            fault = Fault(
                message=f"{self.label} is {self.axis.kind} in the job and {word} in the control's "
                "files",
                expected=self.axis.kind,
                found=word,
                hint=(
                    f"set `kind: {word}` for this axis in the job, or give the files of this "
                    "machine"
                ),
            )
            self.notes.faults.append(fault)
        return self.axis.kind

    def _scale(self, kind: AxisKind, *, has_table: bool) -> NumberScale | None:
        """Return unit, sign and resolution of the axis' numbers; None if the sign cannot be found
        out.
        """
        choices: dict[str, str] = {}
        if has_table and "table_form" in self.definition.bindings:
            word = self.values.choice("table_form")
            if word is None:
                return None
            choices["table_form"] = word
        return NumberScale(self.definition, kind, self.options, choices)

    def _enabled(self, *, has_table: bool, max_points: FoundValue | None) -> bool:
        if "enabled" not in self.definition.bindings:
            return True
        if has_table:
            return self._table_enabled()
        found = self.values.single("enabled")
        if (
            found is not None
            and self.values.stated_word("enabled") == "yes"
            and not (max_points is not None and int(max_points.text) == 0)
        ):
            self.notes.faults.append(
                Fault(
                    message=f"{self.label}: the table is switched on ("
                    f"{name_of(self.definition, 'enabled')} = {found.text}), but no given file"
                    f" contains it ({name_of(self.definition, 'value')})",
                    file=found.occurrence.file,
                    place=found.occurrence.place,
                    expected="the file with the table too",
                    hint="give the file with the table with the control's other files",
                )
            )
        if found is None and not self.elsewhere:
            self.notes.assume(
                control_text("{label}: table", label=self.label),
                control_text("none"),
                unconfirmed(control_text("no file that was given contains one")),
            )
            reserved = max_points is None or int(max_points.text) > 0
            off = not reserved or self.values.stated_word("enabled") == "no"
            self.notes.no_table(self.label, off=off)
        return self.values.stated_word("enabled") != "no"

    def _table_enabled(self) -> bool:
        """Return whether a table is active by the files; if they do not state it, by the job."""
        found = self.values.single("enabled")
        if any(
            Decimal(row.occurrence.tokens[name].text) != 0
            for row in self.rows
            for name in value_fields(self.definition)
        ):
            stated = self.values.stated_word("enabled") if found is not None else None
            switch = self.values.name("enabled")
            active = self.activity.was_active(self.label, switch, stated, found, self.notes)
            if active is not None:
                if not active:
                    self.notes.switched_off(self.label, "the table did not act, as the job says")
                return active
        word = self.values.choice("enabled")
        if word == "no":
            self.notes.switched_off(self.label, "the table is switched off in the files")
        return word != "no"

    def _table(
        self, scale: NumberScale, max_points: FoundValue | None, *, repeats: bool
    ) -> GridTable | None:
        singles = {
            name: found
            for name in shape_of(self.definition).rules.grid
            if (found := self.values.single(name, quiet=False)) is not None
            and name != "node_position"
        }
        source = TableSource(self.label, self.rows, singles, scale, self.notes, repeats)
        table = shape_of(self.definition).read(source)
        if table is None:
            return None
        limit, size = self.definition.limit_number("max_points"), table.positions.size
        if limit is not None and size > limit:
            message, first = "more rows than the control takes", self.rows[limit]
            hint = f"use a table of at most {limit} rows, with a larger distance between them"
            source.fault(message, first, expected=f"at most {limit}", what=str(size), hint=hint)
        reserved = int(max_points.text) if max_points is not None else 0
        if 0 < reserved < size:
            message = "the control has not reserved so many points"
            source.fault(message, max_points, expected=f"{reserved}", what=str(size))
        return table

    def _idle_points(self, scale: NumberScale) -> tuple[float, ...]:
        """Return the positions of an inactive table's points, mm or deg; empty if invalid."""
        quiet = replace(self.values, notes=Notes())
        singles = {
            name: found
            for name in shape_of(self.definition).rules.grid
            if name != "node_position" and (found := quiet.single(name)) is not None
        }
        source = TableSource(self.label, self.rows, singles, scale, quiet.notes)
        table = shape_of(self.definition).read(source)
        return () if table is None else tuple(float(point) for point in table.positions)

    def _backlash(self, scale: NumberScale, *, has_table: bool) -> tuple[float, float]:
        """Return two values in mm or deg: the backlash, and half the backlash as a constant
        correction of each direction.

        If the control adds the whole backlash, the second value is 0. If it adds half in each
        direction, the first value is 0. In this case both are 0 for an axis with a table, because
        the control ignores the backlash next to a table.
        """
        if "backlash" not in self.definition.bindings:
            return 0.0, 0.0
        found = self.values.single("backlash", quiet=False)
        text = (
            found.text if found is not None else self.values.absent("backlash", "backlash") or "0"
        )
        value = scale.read("backlash", text)
        if found is not None and not in_range(self.definition.measure("backlash"), scale, value):
            low, high = scale.range("backlash")
            self.notes.faults.append(
                Fault(
                    message=f"{self.label}: a backlash this large is not plausible",
                    file=found.occurrence.file,
                    place=found.occurrence.place,
                    expected=f"{low:g} .. {high:g} {scale.kind.unit}",
                    found=text,
                    hint=(
                        "correct the value in the control, measure again, and export its files "
                        "again"
                    ),
                )
            )
        if scale.sign("backlash") == "lost_motion":
            return float(value * self._backlash_factor()) + 0.0, 0.0
        if has_table and value != 0:
            self.notes.ignored(self.label, f"{self.values.name('backlash')} = {text}", "table")
        return 0.0, 0.0 if has_table else float(value) / 2.0

    def _backlash_factor(self) -> Decimal:
        """Return the factor by which the control multiplies the backlash in the first parameter
        set; 1 if no file states a factor.
        """
        found = self.values.one("backlash_factor", first_set(self.values.places("backlash_factor")))
        return Decimal(1) if found is None else Decimal(found.text)

    def _constant(self, half: float) -> GridTable:
        """Return a constant correction (``half`` for +, its negative for -) as a table with one
        point; as a table without points if ``half`` is 0.
        """
        if half == 0.0:
            return GridTable(np.empty(0), np.empty(0), np.empty(0))
        reference = self.axis.reference if self.axis else float(str(self.options[REFERENCE]))
        return GridTable(np.array([reference]), np.array([half]), np.array([-half]))
