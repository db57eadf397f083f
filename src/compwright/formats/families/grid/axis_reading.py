"""What the files say about one axis -> its compensation, with every assumption and doubt on the
way.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from compwright.formats.definition.consistency import curves, grid
from compwright.formats.definition.options import ENCODER_SYSTEM, REFERENCE, REFERENCE_RETURN
from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.families.activity import Activity
from compwright.formats.families.grid.systems import SystemChoice
from compwright.formats.families.grid.tables import Table, TableSource, read_table
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.text.gathering import Found, Gathered, first_set
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import Scale, in_range
from compwright.formats.text.values import Values
from compwright.foundations.errors import Fault
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, Fact


@dataclass(frozen=True, slots=True)
class AxisReading:
    """The compensation of one axis by its own table and backlash, and further facts about it."""

    compensation: AxisCompensation
    facts: Mapping[str, Fact]


class AxisReader:
    """Reads one axis. ``rows``: the rows of its table where they are not named by axis; None where
    the text names them itself.

    ``elsewhere``: other tables of the control act on the axis, so that it needs none of its own.
    """

    def __init__(
        self,
        gathered: Gathered,
        address: str,
        axis: Axis | None,
        options: Mapping[str, object],
        notes: Notes,
        rows: Sequence[Found] | None,
        *,
        elsewhere: bool = False,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> None:
        self.elsewhere = elsewhere
        self.activity = activity
        self.definition: Definition = gathered.definition
        self.gathered = gathered
        self.address = address
        self.axis = axis
        self.notes = notes
        self.label = f"axis {address}"
        self.system = self._measuring_system(options)
        if self.system is not None:
            self.label += f", measuring system {int(self.system) + 1}"
        self.values = Values(self.definition, self.label, notes)
        self.rows = gathered.rows.get((address, self.system), []) if rows is None else rows
        self.options = self._settled(options)

    def read(self) -> AxisReading:
        """Return what acts on the axis; what is wrong goes to the notes."""
        kind = self._kind()
        returns = (
            self.axis.reference_return
            if self.axis
            else Direction(str(self.options[REFERENCE_RETURN]))
        )
        facts: dict[str, Fact] = (
            {} if self.system is None else {ENCODER_SYSTEM: int(self.system) + 1}
        )
        facts.update(
            {name: word for name in ("length_unit",) if (word := self._word(name)) is not None}
        )
        max_points = self._single("max_points")
        if max_points is not None:
            facts["max_points"] = int(max_points.text)
        has_table = bool(self.rows) or any(
            self._single(name) for name in grid(self.definition) if name in self._names()
        )
        enabled = self._enabled(has_table=has_table, max_points=max_points)
        facts["enabled"] = enabled
        facts.update(self._said(kind))
        repeats = has_table and enabled and self._choice("repeats") == "yes"
        self._check_modulo()
        table: Table | None = None
        scale = self._scale(kind, has_table=has_table)
        if has_table and enabled and scale is not None:
            table = self._table(scale, max_points)
        backlash, constant = (
            self._backlash(scale, has_table=table is not None) if scale is not None else (0.0, 0.0)
        )
        period = self._period(table) if repeats and table is not None else None
        if table is None:
            table = self._constant(constant)
        compensation = AxisCompensation(
            address=self.address,
            kind=kind,
            positions=table.positions,
            positive=table.positive,
            negative=table.negative,
            backlash=backlash,
            reference_return=returns,
            below=self.definition.layout.below,
            above=self.definition.layout.above,
            period=period,
        )
        return AxisReading(compensation, facts)

    def _said(self, kind: AxisKind) -> dict[str, Fact]:
        """Return what the files say of the axis itself: its kind, its letter, its software limits
        (mm or deg).

        Angles in another unit than degrees are a fault on a rotary axis: its table would be written
        in degrees.
        """
        said: dict[str, Fact] = {}
        if (word := self._word("rotary")) is not None:
            said["rotary"] = word == "rotary"
        letters = self._single("axis_letters")
        found = re.search(r"coordinates=([A-Za-z]+)", letters.text) if letters is not None else None
        if found is not None and self.address.isdigit() and int(self.address) < len(found[1]):
            said["axis_name"] = found[1][int(self.address)].upper()
            said["axis_letters"] = found[1].upper()
        if kind is AxisKind.ROTARY:
            self._word("angle_unit")
        if "units" not in self.definition.options:
            return said
        inch = kind is AxisKind.LINEAR and self.options.get("units") == "inch"
        for name in ("limit_low", "limit_high"):
            if (limit := self._single(name)) is not None:
                said[name] = float(limit.text) * (MILLIMETRES_PER_INCH if inch else 1.0)
        return said

    def _names(self) -> set[str]:
        return set(self.definition.bindings)

    def _single(self, quantity: str, *, quiet: bool = True) -> Found | None:
        """Return the value that counts. Unless ``quiet``, contradictions and repetitions are noted
        (once, where it is used).
        """
        places = self.gathered.found(quantity, self.address, self.system)
        return self.values.one(quantity, places, quiet=quiet)

    def _word(self, quantity: str) -> str | None:
        """Return the neutral word of a choice that is in the files, else None."""
        return self.values.word(quantity, self._single(quantity))

    def _choice(self, quantity: str) -> str | None:
        """Return the neutral word of a choice, with what counts when it is absent; None where the
        control has no such thing.
        """
        if quantity not in self.definition.bindings:
            return None
        if self._single(quantity, quiet=False) is not None:
            return self._word(quantity)
        return self.values.absent(quantity, quantity.replace("_", " "))

    def _measuring_system(self, options: Mapping[str, object]) -> str | None:
        systems = self.gathered.systems(self.address)
        if not systems:
            return None
        choice = SystemChoice(self.gathered, self.address, self.notes)
        if self.axis is not None and self.axis.encoder.stated:
            return choice.stated(self.axis.encoder.system, by_job=True)
        if self.axis is None and options.get(ENCODER_SYSTEM, "auto") != "auto":
            return choice.stated(int(str(options[ENCODER_SYSTEM])), by_job=False)
        return choice.found(asking=self.axis is not None)

    def _settled(self, options: Mapping[str, object]) -> Mapping[str, object]:
        """Return the options with what the files themselves answer."""
        settled = dict(options)
        for name, rule in self.definition.options.items():
            if rule.settled_by is not None and isinstance(
                self.definition.bindings[rule.settled_by], Choice
            ):
                word = self._word(rule.settled_by)
                if word is not None:
                    settled[name] = word
                elif self.axis is None:
                    self.notes.assume(
                        f"option {name}", str(options[name]), "not in the files that were given"
                    )
        return settled

    def _kind(self) -> AxisKind:
        if self.axis is None:
            return AxisKind(self._choice("rotary") or "linear")
        word = self._word("rotary")
        if word is not None and word != self.axis.kind:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"{self.label}: the job and the control's files disagree about its kind"
                    ),
                    expected=self.axis.kind,
                    found=word,
                )
            )
        return self.axis.kind

    def _scale(self, kind: AxisKind, *, has_table: bool) -> Scale | None:
        """Return how numbers are read; None when a sign depends on a choice that cannot be read."""
        choices: dict[str, str] = {}
        if has_table and "table_form" in self._names():
            word = self._choice("table_form")
            if word is None:
                return None
            choices["table_form"] = word
        return Scale(self.definition, kind, self.options, choices)

    def _enabled(self, *, has_table: bool, max_points: Found | None) -> bool:
        if "enabled" not in self._names():
            return True
        if has_table:
            found = self._single("enabled")
            if any(
                Decimal(row.occurrence.tokens[name].text) != 0
                for row in self.rows
                for name in self._value_fields()
            ):
                said = self._word("enabled") if found is not None else None
                acts = self.activity.settle(
                    self.label, self.values.name("enabled"), said, found, self.notes
                )
                if acts is not None:
                    if not acts:
                        self.notes.switched_off(
                            self.label, "the table did not act, as the job says"
                        )
                    return acts
            word = self._choice("enabled")
            if word == "no":
                self.notes.switched_off(self.label, "the table is switched off in the files")
            return word != "no"
        found = self._single("enabled")
        if (
            found is not None
            and self._word("enabled") == "yes"
            and not (max_points is not None and int(max_points.text) == 0)
        ):
            self.notes.faults.append(
                Fault(
                    message=f"{self.label}: the table is switched on, but no file holds it",
                    file=found.occurrence.file,
                    place=found.occurrence.place,
                    expected="the file with the table too",
                )
            )
        if found is None and not self.elsewhere:
            self.notes.assume(
                f"{self.label}: table", "none", "unconfirmed: no file that was given holds one"
            )
            self.notes.no_table(self.label)
        return self._word("enabled") != "no"

    def _value_fields(self) -> list[str]:
        return [self.definition.bindings[quantity].field for quantity in curves(self.definition)]

    def _check_modulo(self) -> None:
        """Job and control must mean the same: an axis with ends, or one that turns endlessly by the
        same range.
        """
        found = self._single("modulo", quiet=False)
        if (
            found is not None
            and self._word("modulo") == "yes"
            and self.axis is not None
            and self.axis.kind is AxisKind.ROTARY
        ):
            self._check_range(found)
        if (
            found is not None
            and self._word("modulo") == "no"
            and self.axis is not None
            and self.axis.modulo is not None
        ):
            self.notes.faults.append(
                Fault(
                    message=(
                        f"{self.label}: the job says that the axis is endless, the control's files"
                        " that it is not"
                    ),
                    file=found.occurrence.file,
                    place=found.occurrence.place,
                    expected=f"modulo {self.axis.modulo:g}",
                    found=found.text,
                )
            )

    def _check_range(self, found: Found) -> None:
        """The turn of an endless axis is that of the control; a job that gives it ends would leave
        the rest of the turn behind.
        """
        length = self._single("modulo_range")
        turn = float(length.text) if length is not None else None
        modulo = self.axis.modulo if self.axis is not None else None
        if modulo is None:
            self.notes.refuse(
                self.label,
                "the control's files say that the axis is endless (MD30310), the job that it has"
                " ends",
                found,
                expected=f"modulo: {turn or 360.0:g} in the job",
                found="no modulo",
            )
        elif turn is not None and abs(turn - modulo) > SAME_TURN:
            message = "the modulo of the job is not the modulo range of the control (MD30330)"
            self.notes.refuse(
                self.label, message, length, expected=f"modulo: {turn:g}", found=f"{modulo:g}"
            )

    def _period(self, table: Table) -> float:
        """Return the period of a table that repeats: it follows itself without a step only if both
        ends are equal.
        """
        if table.positive[0] != table.positive[-1] or table.negative[0] != table.negative[-1]:
            first, last = self.rows[0].occurrence, self.rows[-1].occurrence
            self.notes.faults.append(
                Fault(
                    message=(
                        f"{self.label}: the table repeats, but its two ends differ: the axis would"
                        " jump once a turn"
                    ),
                    file=first.file,
                    place=f"{first.place} to {last.line}",
                    expected="the same value at both ends",
                    found=f"{table.positive[0]:g} and {table.positive[-1]:g} (corrections)",
                )
            )
        self._check_beginning(table)
        return float(table.positions[-1] - table.positions[0])

    def _check_beginning(self, table: Table) -> None:
        """A repeating table that does not begin where the control's range begins: whether it is
        found there is not known.
        """
        if self.axis is None or "modulo_start" not in self._names():
            return
        found = self._single("modulo_start")
        start = float(found.text) if found is not None else 0.0
        if abs(float(table.positions[0]) - start) > SAME_TURN:
            self.notes.refuse(
                self.label,
                "its table repeats and does not begin where the modulo range of the control begins"
                " (MD30340): whether the control reads the part before it is not known",
                self._single("table_start"),
                expected=(
                    f"MIN = {start:g}"
                    if found is not None
                    else "MIN = 0, or the file that holds MD30340"
                ),
            )

    def _table(self, scale: Scale, max_points: Found | None) -> Table | None:
        singles = {
            name: found
            for name in grid(self.definition)
            if (found := self._single(name, quiet=False)) is not None and name != "node_position"
        }
        source = TableSource(self.label, self.rows, singles, self.notes.faults, self.notes.findings)
        table = read_table(self.definition, source, scale)
        if table is None:
            return None
        limit = self.definition.limit_number("max_points")
        if limit is not None and table.positions.size > limit:
            source.fault(
                "more rows than the control takes",
                self.rows[limit],
                expected=f"at most {limit}",
                what=str(table.positions.size),
            )
        reserved = int(max_points.text) if max_points is not None else 0
        if 0 < reserved < table.positions.size:
            source.fault(
                "the control has not reserved so many points",
                max_points,
                expected=f"{reserved}",
                what=str(table.positions.size),
            )
        return table

    def _backlash(self, scale: Scale, *, has_table: bool) -> tuple[float, float]:
        """Return the backlash value beside the table, and the constant correction that takes its
        place where there is no table.
        """
        if "backlash" not in self.definition.bindings:
            return 0.0, 0.0
        found = self._single("backlash", quiet=False)
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
                )
            )
        if scale.sign("backlash") == "lost_motion":
            return float(value * self._backlash_factor()) + 0.0, 0.0
        if has_table and value != 0:
            self.notes.ignored(
                self.label, f"{self.values.name('backlash')} = {text}", "it has a table"
            )
        return 0.0, 0.0 if has_table else float(value) / 2.0

    def _backlash_factor(self) -> Decimal:
        """Return the factor on the backlash of the first parameter set; 1 where the files hold
        none.
        """
        places = first_set(self.gathered.found("backlash_factor", self.address, self.system))
        found = self.values.one("backlash_factor", places)
        return Decimal(1) if found is None else Decimal(found.text)

    def _constant(self, half: float) -> Table:
        """Return no table, or one node (the reference) whose value holds everywhere."""
        if half == 0.0:
            return Table(np.empty(0), np.empty(0), np.empty(0))
        reference = self.axis.reference if self.axis else float(str(self.options[REFERENCE]))
        return Table(np.array([reference]), np.array([half]), np.array([-half]))
