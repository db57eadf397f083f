"""The statements of one axis in its lists; each contradiction is reported once."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal

from compwright.formats.definition.options import known_kind
from compwright.formats.families.activity import Activity
from compwright.formats.families.lists.files import ListsByAxis, entries
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.notes import CORRECT_VALUE, EXPORT_AGAIN, KEEP_ONE, Notes
from compwright.formats.text.values import Values
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.facts import Fact
from compwright.words.sentences import control_text, unconfirmed

_HEX = re.compile("0x[0-9a-f]{1,8}|[0-9]")
#: The type of an axis, as a number or in words (P-AXIS-00018).
_KINDS: Mapping[int | str, AxisKind] = {
    1: AxisKind.LINEAR,
    2: AxisKind.ROTARY,
    4: AxisKind.ROTARY,
    "achstyp_translator": AxisKind.LINEAR,
    "achstyp_rotator": AxisKind.ROTARY,
    "achstyp_spindel": AxisKind.ROTARY,
    "achstyp_spindle": AxisKind.ROTARY,
}


class AxisStatements:
    """The statements in the lists of one axis, with checks of their values.

    ``axis``: the axis in the job, None without a job. ``stated``: facts that the lists state, by a
    name that is the same for all controls. Faults are added to ``notes``.
    """

    def __init__(
        self,
        lists: ListsByAxis,
        address: str,
        axis: Axis | None,
        options: Mapping[str, object],
        notes: Notes,
        activity: Activity,
    ) -> None:
        self.lists = lists
        self.definition = lists.definition
        self.address = address
        self.axis = axis
        self.options = options
        self.notes = notes
        self.activity = activity
        self.label = control_text("axis {address}", address=address)
        self.returns = (
            axis.reference_return
            if axis is not None
            else Direction(str(options["reference_return"]))
        )
        self.values = Values(self.definition, self.label, notes)
        self.stated: dict[str, Fact] = {}
        self.stated_kind = self._stated_kind()
        known = axis.kind if axis is not None else known_kind(options, address)
        self.kind = known or self.stated_kind or AxisKind.LINEAR

    def _stated_kind(self) -> AxisKind | None:
        """Return the kind of the axis (linear, rotary) by its list. None if the list does not state
        it.

        An unknown kind, or one that differs from that in the job, is a fault.
        """
        place = self.one("axis_type")
        if place is None:
            return None
        word = place.text.casefold()
        kind = _KINDS.get(int(word, 16) if _HEX.fullmatch(word) else word)
        name = self.lists.name("axis_type")
        if kind is None:
            expected = "ACHSTYP_TRANSLATOR (1), ACHSTYP_ROTATOR (2) or ACHSTYP_SPINDEL (4)"
            self.notes.refuse(self.label, name, place, expected=expected, hint=CORRECT_VALUE)
        elif self.axis is not None and kind is not self.axis.kind:
            message = f"the job and the control's lists disagree about its kind ({name})"
            hint = f"set `kind: {kind.value}` for the axis in the job, if the control is right"
            self.notes.refuse(
                self.label,
                message,
                place,
                expected=self.axis.kind.value,
                found=f"{kind.value} ({place.text})",
                hint=hint,
            )
        return kind

    def one(self, statement: str) -> FoundValue | None:
        """Return the value of a statement with its line; two different values are a fault."""
        return self._agreed(statement, self.lists.places(self.address, statement))

    def _agreed(self, what: str, places: Sequence[FoundValue]) -> FoundValue | None:
        for place in places[1:]:
            if not same_value(place.text, places[0].text):
                message = f"{self.lists.name(what)} contradicts {places[0].where}"
                self.notes.refuse(
                    self.label, message, place, expected=places[0].text, hint=KEEP_ONE
                )
                return None
        return places[0] if places else None

    def needed(self, statement: str, given: FoundValue | None) -> FoundValue | None:
        """Return the value of a statement that must not be missing; if it is missing, add a fault
        at the line of ``given``.
        """
        found = self.one(statement)
        if found is None and not self.lists.places(self.address, statement):
            name = self.lists.name(statement)
            message = f"{name} is missing; missing is not zero"
            self.notes.refuse(
                self.label, message, given, expected=name, found="none", hint=EXPORT_AGAIN
            )
        return found

    def word(self, quantity: str) -> str | None:
        """Return the meaning of a setting with a few possible values; the default if the lists do
        not contain the setting.
        """
        found = self.one(self.definition.bindings[quantity].statement)
        return self.values.word(quantity, found) if found else self.values.absent(quantity)

    def is_active(self, switch: str, manual: str, *, zero: bool, label: str) -> bool:
        """Return whether a table is active: switched on by the parameter ``switch``, and not
        reserved for manual activation by the parameter ``manual``. ``zero``: the table contains
        only zeros; ``label``: its name in messages.

        A table whose switch is in no list counts as active; this assumption is listed. If the
        switch is off and measurements depend on the table, the job must state whether it was
        active.
        """
        on, by_hand = self.one(switch), self.one(manual)
        off = [
            place
            for place, means_off in ((on, "0"), (by_hand, "1"))
            if place is not None and same_value(place.text, means_off)
        ]
        for switch_place in (on, by_hand):
            if switch_place is not None and switch_place.text.strip("0") not in ("", "1"):
                message = "a switch has a value that is not known"
                self.notes.refuse(
                    self.label, message, switch_place, expected="0 or 1", hint=CORRECT_VALUE
                )
        if off and zero:
            return False
        word = "no" if off else "yes" if on is not None else None
        if word is not None or self.activity.stated is not None:
            place = off[0] if off else on
            by_switch = not off or off[0] is on
            name = self.lists.name(switch) if by_switch else f"{self.lists.name(manual)} not"
            active = self.activity.was_active(label, name, word, place, self.notes)
            if active is None:
                self.notes.switched_off(label, f"it is switched off in the lists ({name} = 0)")
            elif not active:
                self.notes.switched_off(label, "it did not act, as the job says")
            return bool(active)
        name = self.lists.name(switch)
        self.notes.assume(
            control_text("{label}: {fact}", label=label, fact=name),
            "1",
            unconfirmed(control_text("in no list that was given")),
        )
        return True

    def any_place(self) -> FoundValue | None:
        """Return any line of the axis with its file, to be named in messages."""
        statements = self.lists.statements.get(self.address, {})
        return next((found for places in statements.values() for found in places), None)

    def rows(self, column: str) -> dict[int, FoundValue]:
        """Return the entries of one column by index; two different entries with one index are a
        fault.
        """
        by_index: dict[int, list[FoundValue]] = {}
        for index, found in entries(self.lists.places(self.address, column)):
            by_index.setdefault(index, []).append(found)
        agreed = {index: self._agreed(column, found) for index, found in by_index.items()}
        return {index: found for index, found in agreed.items() if found is not None}

    def room(self, statement: str, default: int) -> int:
        """Return how many entries the control reserves; ``default`` if the lists state 0 or
        nothing.
        """
        found = self.one(statement)
        number = int(found.text) if found is not None else 0
        if number:
            self.stated[statement] = number
        return number or default

    def complete(
        self,
        rows: Mapping[int, FoundValue],
        count: int,
        column: str,
        place: FoundValue | None,
        *,
        needed: bool = True,
    ) -> None:
        """Check that a ``column`` has entries with all indices from 0 to ``count`` - 1 (unless not
        ``needed``), and no others. A missing entry is a fault at the line ``place``.
        """
        name = self.lists.name(column)
        missing = count - sum(index < count for index in rows) if needed else 0
        if missing:
            first = next(index for index in range(count) if index not in rows)
            message = f"{name.replace('..', str(first))} is missing ({missing} of {count})"
            message += "; missing is not zero"
            self.notes.refuse(
                self.label, message, place, expected=f"indices 0 to {count - 1}", hint=EXPORT_AGAIN
            )
        beyond = [index for index in sorted(rows) if index >= count]
        if beyond and count:
            message = f"{name.replace('..', str(beyond[0]))} lies beyond the last entry"
            expected = f"indices 0 to {count - 1}, or {self.lists.name('count')} as it should be"
            self.notes.refuse(
                self.label, message, rows[beyond[0]], expected=expected, hint=CORRECT_VALUE
            )

    def check_ascending(
        self, places: Sequence[Decimal], setpoints: Mapping[int, FoundValue], otherwise: FoundValue
    ) -> None:
        """Report as a fault the first position of ``places`` that is not above the one before it:
        at its line in ``setpoints`` or, for a position without a line, at the line ``otherwise``.
        """
        for index in range(1, len(places)):
            if places[index] <= places[index - 1]:
                message = f"the positions do not ascend at entry {index}"
                at, found = setpoints.get(index, otherwise), str(places[index])
                expected = f"more than {places[index - 1]}"
                self.notes.refuse(
                    self.label, message, at, expected=expected, found=found, hint=CORRECT_VALUE
                )
                return
