"""Choose which measuring system of an axis is in use: by the job, else by the files, else by a
question to the user.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Choice
from compwright.formats.text.gathering import Gathered
from compwright.formats.text.notes import CORRECT_VALUE, Notes
from compwright.foundations.errors import Fault
from compwright.words.sentences import control_text


class SystemChoice:
    """Chooses the measuring system of one axis, by its number in the files (from 0)."""

    def __init__(self, gathered: Gathered, address: str, notes: Notes) -> None:
        self.gathered = gathered
        self.address = address
        self.notes = notes
        self.systems = gathered.systems(address)

    def stated(self, wanted: int, *, by_job: bool) -> str:
        """Return the number (from 0) of the measuring system ``wanted`` (from 1), and check that
        the axis has this system and an active table for it. ``by_job``: the job's axis states it,
        else an option.
        """
        chosen = str(wanted - 1)
        if (count := self._count()) is not None and wanted > count:
            self.notes.refuse(
                f"axis {self.address}",
                f"measuring system {wanted} is requested, but the number of measuring systems of "
                f"this axis is {count} (MD30200 $MA_NUM_ENCS)",
                self.gathered.singles[self.address, None]["encoders"][-1],
                expected=(
                    f"`encoder: {{system: {count}}}`, or no key `encoder`"
                    if count
                    else "MD30200 at least 1"
                ),
                hint=f"set `encoder: {{system: {count}}}` for the axis, or delete `encoder`"
                if count
                else CORRECT_VALUE,
            )
            return chosen
        self._check_tables(chosen, by_job=by_job)
        return chosen

    def _check_tables(self, chosen: str, *, by_job: bool) -> None:
        """Check that the files contain an active table of the ``chosen`` measuring system (a number
        from 0). ``by_job``: the job's axis states this system, else an option.
        """
        number = int(chosen) + 1
        tables = [system for system in self.systems if self._rows(system)]
        active = [system for system in tables if self._switch(system) is not False]
        if chosen not in self.systems or (chosen not in tables and active):
            self.notes.faults.append(
                Fault(
                    message=(
                        f"axis {self.address}: the files contain no table for measuring "
                        f"system {number}, only for another one"
                    ),
                    expected=f"measuring system {number}, as the job or the option says",
                    found=", ".join(
                        f"system {int(system) + 1}" for system in active or self.systems
                    ),
                    hint=(
                        f"set `encoder: {{system: ...}}` of the axis to the system of the "
                        "table, or "
                        f"add the file with the table of system {number}"
                    ),
                )
            )
        elif (
            by_job
            and self._switch(chosen) is False
            and (others := [s for s in self.systems if self._switch(s)])
        ):
            self.notes.find(
                "CW-S052",
                "warning",
                self.address,
                axis=self.address,
                number=number,
                other=int(others[0]) + 1,
            )

    def found(self, *, asking: bool) -> str:
        """Return the number (from 0) of the measuring system that is in use, as far as the files
        show it. ``asking``: if they do not show it, add a question to the user.
        """
        count = self._count()
        if count == 1 or len(self.systems) == 1:
            chosen, why = (
                ("0", control_text("MD30200: there is one"))
                if count == 1
                else (self.systems[0], control_text("the only one in the files"))
            )
            if len(self.systems) > 1 or chosen != "0":
                self._assume(chosen, why)
            return chosen
        reasons = (
            (self._switch, control_text("the only one that is switched on (MD32700)")),
            (self._written, control_text("the only one that contains a table")),
            (self._rows, control_text("the only one that contains a table")),
            (self._reserved, control_text("the only one with points reserved (MD38000)")),
            (self._backlash, control_text("the only one with a backlash value")),
        )
        for shows, why in reasons:
            systems = [system for system in self.systems if shows(system)]
            if len(systems) == 1:
                self._assume(systems[0], why)
                return systems[0]
            if systems:
                break
        return self._unclear(asking=asking)

    def _unclear(self, *, asking: bool) -> str:
        tables = [system for system in self.systems if self._rows(system)]
        active = [system for system in tables if self._switch(system) is not False]
        if asking:
            self.notes.ask(
                Fault(
                    message=(
                        f"axis {self.address}: the files contain data of both measuring systems "
                        "and do not show which one is in use"
                    ),
                    place="encoder.system",
                    expected=(
                        "`encoder: {system: 1}` (index 0 in the files) or `encoder: {system: "
                        "2}` (index 1)"
                    ),
                    found="no answer in the job, MD30200 and MD32700",
                    hint=(
                        "set `encoder: {system: 1}` or `encoder: {system: 2}` for this axis "
                        "(without a job: `--option encoder_system=1`)"
                    ),
                )
            )
        chosen = (
            active
            or tables
            or [system for system in self.systems if self._backlash(system)]
            or self.systems
        )[0]
        self._assume(chosen, control_text("the one that contains a table"))
        if len(active) > 1:
            self.notes.find(
                "CW-S006", "warning", self.address, axis=self.address, system=int(chosen) + 1
            )
        return chosen

    def _assume(self, chosen: str, why: str) -> None:
        self.notes.assume(
            control_text("axis {name}: measuring system", name=self.address),
            str(int(chosen) + 1),
            control_text("inferred: {what}", what=why),
        )

    def _rows(self, system: str) -> Sequence[object]:
        return self.gathered.rows.get((self.address, system), ())

    def _count(self) -> int | None:
        places = self.gathered.singles.get((self.address, None), {}).get("encoders", ())
        return int(places[-1].text) if places else None

    def _switch(self, system: str) -> bool | None:
        """Return whether the last value of the activation parameter in the files activates the
        table of a measuring system; None if no file states it.
        """
        places = self.gathered.singles.get((self.address, system), {}).get("enabled", ())
        binding = self.gathered.definition.bindings.get("enabled")
        if not places or not isinstance(binding, Choice):
            return None
        return binding.values.get(places[-1].text) != "no"

    def _written(self, system: str) -> bool:
        """Return whether a system's table contains values other than zero."""
        fields = [
            self.gathered.definition.bindings[quantity].field
            for quantity in curves(self.gathered.definition)
        ]
        rows = self.gathered.rows.get((self.address, system), ())
        return any(
            Decimal(row.occurrence.tokens[name].text) != 0 for row in rows for name in fields
        )

    def _reserved(self, system: str) -> bool:
        return any(
            Decimal(found.text) != 0
            for found in self.gathered.found("max_points", self.address, system)
        )

    def _backlash(self, system: str) -> bool:
        return any(
            Decimal(found.text) != 0
            for found in self.gathered.found("backlash", self.address, system)
        )
