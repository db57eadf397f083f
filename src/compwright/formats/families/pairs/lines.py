"""Read the values of one cross-axis table, and decide whether it is active."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal

from compwright.formats.definition.schema import Choice
from compwright.formats.families.activity import Activity
from compwright.formats.families.grid.tables import value_fields
from compwright.formats.families.pairs.places import Pair, Places, is_zero, last, of_axis
from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.notes import ADD_FILE, CORRECT_VALUE, Notes
from compwright.formats.text.values import Values
from compwright.foundations.errors import Fault
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import AxisKind
from compwright.words.sentences import control_text

#: Why tables in inch are not written.
IN_INCH = control_text("its values are in inch (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC = 0)")
#: Why tables of a control that works in inch are neither read nor written.
MAYBE_INCH = control_text(
    "the control works in inch (MD10240 = 0), and no file says in which unit its cross-axis"
    " corrections are (MD32711 $MA_CEC_SCALING_SYSTEM_METRIC)"
)
SAYING_METRIC = control_text("the machine data with MD32711 = 1: metric")
_SWITCHES = "SD41300 $SN_CEC_TABLE_ENABLE, MD32710 $MA_CEC_ENABLE"


@dataclass(frozen=True, slots=True)
class Units:
    """The length units of tables and machine data.

    ``inch``: the control works in inch. ``kind``: a function that returns the kind (linear, rotary)
    of an axis, given its address.
    """

    inch: bool
    kind: Callable[[str], AxisKind]

    def basic(self, address: str) -> float:
        """Return the factor from the unit of an axis' machine data to mm or deg."""
        linear = self.kind(address) is not AxisKind.ROTARY
        return MILLIMETRES_PER_INCH if self.inch and linear else 1.0

    def may_be_inch(self, pair: Pair) -> bool:
        """Return whether it is possible that a table between the axes of ``pair`` is in inch."""
        return self.inch and any(self.kind(one) is not AxisKind.ROTARY for one in pair)


class SingleValues:
    """Reads values of one table or axis from the ``gathered`` files."""

    def __init__(self, gathered: Gathered, notes: Notes) -> None:
        self.gathered = gathered
        self.definition = gathered.definition
        self.notes = notes

    def values(self, label: str) -> Values:
        """Return a reader of single values; its messages call the table or axis ``label``."""
        return Values(self.definition, label, self.notes)

    def word(
        self, label: str, quantity: str, found: FoundValue | None, *, tell: bool = True
    ) -> str | None:
        """Return the meaning, such as "yes", of the value ``found`` of a setting with a few
        possible values. If ``found`` is None, return the default, which (``tell``) is listed as an
        assumption.

        If the value has no known meaning, a fault is added and None is returned.
        """
        if found is None:
            return self.values(label).absent(quantity, tell=tell)
        binding = self.definition.choice(quantity)
        word = self.values(label).known_word(binding, found.text)
        if word is None:
            message = f"{self.values(label).name(quantity)} has a value that is not known"
            self.notes.refuse(
                label, message, found, expected=" or ".join(binding.values), hint=CORRECT_VALUE
            )
        return word


@dataclass(frozen=True, slots=True)
class _Switch:
    """The last value in the files of a parameter that activates a table.

    ``word``: the meaning of the value, "yes" or "no"; None if no file states the parameter.
    """

    quantity: str
    owner: str
    found: FoundValue | None
    word: str | None


@dataclass(frozen=True, slots=True)
class _Leadscrew:
    """Whether the leadscrew error tables (ENC_COMP) of an axis are active, as far as the files show
    it.

    ``on``: a table is switched on by the last value in the files. ``word``: the last state of the
    tables that are not zero: ``yes``, ``no``, or ``unsaid`` (no file states it); empty if there is
    no such table.
    """

    on: bool
    word: str


class TableLines(SingleValues):
    """The lines of one cross-axis table.

    ``pair``: the table's input axis and output axis.
    """

    def __init__(
        self, gathered: Gathered, index: int, places: Places, activity: Activity, units: Units
    ) -> None:
        super().__init__(gathered, Notes())
        self.index = index
        self.places = places
        self.activity = activity
        self.units = units
        self.label = f"CEC table {index}"
        both = [last(name, places) for name in ("cross_input", "cross_output")]
        base, corrected = (gathered.axis(found.text) if found is not None else "" for found in both)
        self.pair = base, corrected

    @property
    def itself(self) -> bool:
        """Whether the table corrects an axis by that axis' own position."""
        return self.pair[0] == self.pair[1]

    def on(self) -> bool:
        """Return whether the last values in the files activate the table. Unlike the other checks,
        this adds no message.
        """
        ends = (
            ("cross_table_enabled", self.places),
            ("cross_axis_enabled", of_axis(self.gathered, self.pair[1])),
        )
        return all(self._ends_on(quantity, last(quantity, places)) for quantity, places in ends)

    def known_on(self) -> bool:
        """Return whether the table is active without doubt: the files state it, else the job.

        An activation parameter that is in no file counts as on, provided that the job need not
        state whether the table was active.
        """
        ends = (
            last("cross_table_enabled", self.places),
            last("cross_axis_enabled", of_axis(self.gathered, self.pair[1])),
        )
        stated = all(ends) or self.activity.stated is True or not self.activity.asking
        return stated and self.on()

    def _ends_on(self, quantity: str, found: FoundValue | None) -> bool:
        values, binding = self.values(self.label), self.definition.choice(quantity)
        if found is None:
            return values.absent(quantity, tell=False) == "yes"
        return values.known_word(binding, found.text) == "yes"

    def is_active(self, *, under_work: bool, stays: bool) -> bool:
        """Return whether the table is active, by its two activation parameters or by the job.
        ``under_work``: the job names the axis that the table corrects; ``stays``: no new table will
        replace this one.

        If the unit of the values is unknown, a fault is added. If the table stays and both
        parameters are on, the job is not asked whether it was active: the result does not depend on
        it.
        """
        owner = f"axis {self.pair[1]}"
        on_axis = of_axis(self.gathered, self.pair[1])
        ends = [
            self._switch("cross_table_enabled", self.places, self.label),
            self._switch("cross_axis_enabled", on_axis, owner),
        ]
        active = None
        alike = stays and all(end.word == "yes" for end in ends)
        if self.itself and under_work and not alike and not is_zero(self.places):
            active = self._was_active(ends)
        if active is None:
            off = next((end for end in ends if end.word == "no"), None)
            if off is not None:
                self._note_switched_off(
                    self.label, self.values(self.label).name(off.quantity), "info"
                )
                return False
            for end in ends:
                if end.word is None:
                    self.word(end.owner, end.quantity, None)
        if active is not False:
            self._check_unit(owner, on_axis)
        return active is not False

    def to_millimetres(self) -> tuple[float, float]:
        """Return the factors from a table's positions and values to mm or deg.

        If MD32711 of the output axis is 0, positions and values of linear axes are in inch.
        """
        metric = last("cross_metric", of_axis(self.gathered, self.pair[1]))
        if metric is None or self._ends_on("cross_metric", metric):
            return 1.0, 1.0
        base, corrected = (
            1.0 if self.units.kind(one) is AxisKind.ROTARY else MILLIMETRES_PER_INCH
            for one in self.pair
        )
        return base, corrected

    def _check_unit(self, owner: str, on_axis: Places) -> None:
        """Refuse a table whose values are possibly in inch. ``owner``: the corrected axis in
        messages; ``on_axis``: the settings for all tables that correct this axis.
        """
        metric = self.values(owner).one("cross_metric", on_axis.get("cross_metric", ()))
        if metric is not None:
            self.word(owner, "cross_metric", metric)
        elif self.units.may_be_inch(self.pair):
            self.notes.refuse(
                owner,
                f"{self.label}: {MAYBE_INCH}",
                last("cross_input", self.places),
                expected=SAYING_METRIC,
                hint=ADD_FILE,
            )

    def _switch(self, quantity: str, places: Places, owner: str) -> _Switch:
        found = self.values(owner).one(quantity, places.get(quantity, ()))
        word = None if found is None else self.word(owner, quantity, found)
        return _Switch(quantity, owner, found, word)

    def _note_switched_off(self, label: str, switches: str, severity: str) -> None:
        self.notes.find("CW-S034", severity, self.pair[1], label=label, switches=switches)

    def _was_active(self, ends: list[_Switch]) -> bool | None:
        """Return whether a table by which an axis corrects itself was active during the test, by
        the last values ``ends`` of its two activation parameters, else by the job; None if unknown.
        """
        words = [end.word for end in ends]
        word = "no" if "no" in words else None if None in words else "yes"
        found = (end.found for end in ends if end.word == word and end.found is not None)
        place, owner = next(found, None), f"{self.label} of axis {self.pair[1]}"
        if self._was_inactive(owner, word, place):
            self._note_switched_off(owner, _SWITCHES, "warning")
            return False
        return self.activity.was_active(owner, _SWITCHES, word, place, self.notes)

    def _was_inactive(self, owner: str, word: str | None, place: FoundValue | None) -> bool:
        """Return True if the table must be treated as inactive during the test: it is off while the
        leadscrew table of its axis is on, or the user is asked which of the two was active.
        ``word``: its last activation value, in the line ``place``.

        An activation parameter in another file than the values was not set by a program that loads
        these values. So it shows the state that the control was in.
        """
        screw, stated = self._leadscrew(), self.activity.stated
        dumped = place is not None and place.number not in {
            row.number for row in self.places["cross_value"]
        }
        slept = word == "no" and (screw.word == "yes" or (screw.on and not screw.word and dumped))
        certain = slept and dumped and screw.word == "yes"
        unclear = screw.word in ("no", "unsaid") and "no" in (word, screw.word) and word != "yes"
        if stated is True and (unclear or (slept and not certain)):
            self._ask_which(owner, word, place, screw)
            return True
        if slept:
            self.notes.assume(
                control_text("{label}: during the test", label=owner),
                control_text("off"),
                control_text(
                    "{switches} end as 0, while the leadscrew table of the axis is on",
                    switches=_SWITCHES,
                ),
            )
        return slept

    def _ask_which(
        self, owner: str, word: str | None, place: FoundValue | None, screw: _Leadscrew
    ) -> None:
        off, unsaid = "switched off", "not known to be on"
        leadscrew = "on" if screw.on else "off" if screw.word == "no" else unsaid
        self.notes.ask(
            Fault(
                message=(
                    f"{owner}: `active: yes` does not show which of two tables was active "
                    f"during the test. The CEC table is {off if word == 'no' else unsaid} "
                    f"({_SWITCHES}), the leadscrew table of the same axis is {leadscrew} (MD32700 "
                    "$MA_ENC_COMP_ENABLE)"
                ),
                file=place.occurrence.file if place is not None else "",
                place=place.occurrence.place if place is not None else "",
                expected="a file that states 1 for the switch of the active table",
                found="active: yes",
                hint=(
                    "delete `active: yes`, and add the file in which the switch of the table that "
                    "was active is 1"
                ),
            )
        )

    def _leadscrew(self) -> _Leadscrew:
        """Return whether the leadscrew error tables of the output axis are active by the files."""
        address, fields = self.pair[1], value_fields(self.definition)
        tables = {
            system: rows
            for (owner, system), rows in self.gathered.rows.items()
            if owner == address and system
        }
        on = {system: self._switch_of(address, system) for system in tables}
        written = {
            on[system]
            for system, rows in tables.items()
            if any(
                Decimal(row.occurrence.tokens[name].text) != 0 for row in rows for name in fields
            )
        }
        word = next((word for word in ("yes", "unsaid", "no") if word in written), "")
        return _Leadscrew("yes" in on.values(), word)

    def _switch_of(self, address: str, system: str) -> str:
        found = last("enabled", self.gathered.singles.get((address, system), {}))
        binding = self.definition.bindings.get("enabled")
        if found is None or not isinstance(binding, Choice):
            return "unsaid"
        return "no" if binding.values.get(found.text) == "no" else "yes"
