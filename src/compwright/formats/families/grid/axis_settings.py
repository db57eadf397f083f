"""Settings of an axis apart from its table: gantries, modulo ranges, limits, other functions.

A function that is the same during the test and afterwards is reported and otherwise ignored. A
function that would make a table wrong is refused, with its parameter.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal

from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.notes import CORRECT_VALUE, Notes
from compwright.formats.text.values import bit_mask
from compwright.records.axis import Axis
from compwright.records.facts import AxisFacts, Turn

#: Where the range of a modulo axis begins when no file says it, deg.
MODULO_START = 0.0
#: Its length when no file says it, deg.
_WHOLE_TURN = 360.0
#: MD37100 has two digits: the group, and from here on a synchronised axis of it.
_FOLLOWS = 10


class AxisSettingsReader:
    """Reads the settings of an axis that do not depend on a measuring system or a table."""

    def __init__(self, gathered: Gathered, address: str, notes: Notes) -> None:
        self.gathered = gathered
        self.address = address
        self.notes = notes

    def facts(self, own: AxisFacts, axis: Axis | None, partners: Mapping[str, str]) -> AxisFacts:
        """Return the facts ``own`` completed by the axis' settings; the axis' other active
        functions are reported. ``partners``: by the job, the gantry slave's address by that of its
        master.
        """
        turn = self._turn()
        limits = own.limits if turn is None else (turn.start, turn.start + turn.length)
        name = own.name or self.gathered.names.machine_name(self.address)
        other = ""
        if axis is not None:
            self.gantry(partners)
            other = self.other_functions()
        machine_name = self.gathered.names.of_machine(self.address)
        (synchronised, leading), kind = self._paired(), self._kind(self.address)
        follows = synchronised[0] if len(synchronised) == 1 else ""
        return replace(
            own,
            name=name,
            name_evidence="MD10000 $MN_AXCONF_MACHAX_NAME_TAB",
            machine_name="" if machine_name == self.address else machine_name,
            limits=limits,
            turn=turn,
            other_functions=other,
            synchronised=synchronised,
            leading=leading,
            couplings={f"MD37100 = {kind}": follows} if kind else {},
        )

    def _paired(self) -> tuple[tuple[str, ...], str | None]:
        """Return the gantry slaves that follow this axis, and the master that it follows."""
        kind = self._kind(self.address)
        if not kind:
            return (), None
        others = self._others(kind)
        following = tuple(each for each in others if (self._kind(each) or 0) >= _FOLLOWS)
        if kind < _FOLLOWS:
            return following, None
        return (), next((each for each in others if each not in following), None)

    def _others(self, kind: int) -> list[str]:
        """Return the addresses of the other axes in this axis' gantry: those whose gantry type
        (MD37100) has the same gantry number as this axis' type, ``kind``.
        """
        addresses = (address for address, _ in self.gathered.singles if address is not None)
        return [
            address
            for address in dict.fromkeys(addresses)
            if address != self.address
            and (other := self._kind(address))
            and other % _FOLLOWS == kind % _FOLLOWS
        ]

    def _turn(self) -> Turn | None:
        if self.number("modulo") != 1:
            return None
        start, length = self.number("modulo_start"), self.number("modulo_range")
        begin = MODULO_START if start is None else start
        return Turn(begin, length or _WHOLE_TURN, start is not None)

    def last(self, quantity: str, address: str | None = None) -> FoundValue | None:
        """Return the last line in the files that sets a quantity for the whole axis."""
        places = self.gathered.singles.get((address or self.address, None), {}).get(quantity, ())
        return places[-1] if places else None

    def number(self, quantity: str) -> float | None:
        """Return the number that a quantity has for the whole axis; None if no file states it."""
        found = self.last(quantity)
        return None if found is None else float(found.text)

    def gantry(self, partners: Mapping[str, str]) -> None:
        """Check that the files (gantry type, MD37100) and the job name the same gantry axes.
        ``partners``: by the job, the gantry slave's address by that of its master.
        """
        kind = self._kind(self.address)
        if kind is None or not kind:
            return
        follows, others = kind >= _FOLLOWS, self._others(kind)
        named = (
            {partners[self.address]}
            if self.address in partners
            else {k for k, v in partners.items() if v == self.address}
        )
        wrong = [address for address in others if address not in named]
        place, label = self.last("gantry_type"), f"axis {self.address}"
        if follows and self.address in partners:
            self.notes.refuse(
                label,
                "it is the synchronised axis of a gantry (MD37100), not the leading one",
                place,
                expected=f"the job's axis at {', '.join(map(str, others)) or 'the leading axis'}",
                hint=f"set `address: {', '.join(map(str, others)) or '...'}` in the job",
            )
        elif not named or wrong:
            self.notes.refuse(
                label,
                f"it belongs to a gantry (MD37100 = {kind}); a table on one of its axes alone racks"
                " the bridge",
                place,
                expected=(
                    f"gantry: {', '.join(map(str, wrong or others)) or 'the other axis'} in the job"
                ),
                found=f"gantry: {', '.join(map(str, named))}" if named else "no gantry in the job",
                hint=f"set `gantry: {', '.join(map(str, wrong or others)) or '...'}` in the job",
            )

    def _kind(self, address: str) -> int | None:
        found = self.last("gantry_type", address)
        return None if found is None else int(found.text)

    def other_functions(self) -> str:
        """Report the axis' other active functions, and return them as text for comparing two
        states.
        """
        functions = self._temperature()
        for (address, system), places in sorted(self.gathered.singles.items(), key=str):
            found = places.get("dynamic_backlash", ())
            if address == self.address and found and Decimal(found[-1].text) != 0:
                functions.append(
                    f"dynamic backlash (MD32456[{system}] = {found[-1].text}), where the PLC"
                    " switches it on"
                )
        factors = {
            Decimal(found.text)
            for found in self.gathered.singles.get((self.address, None), {}).get(
                "backlash_factor", ()
            )
        }
        if len(factors) > 1:
            functions.append(
                "a backlash factor that differs between the parameter sets (MD32452); the first set"
                " is taken"
            )
        if functions:
            self.notes.find("CW-S053", "warning", axis=self.address, functions=functions)
        return "; ".join(functions)

    def _temperature(self) -> list[str]:
        kind, slope = self.last("temperature_type"), self.number("temperature_slope")
        bits = bit_mask(kind.text) if kind is not None else 0
        if bits is None:
            self.notes.refuse(
                f"axis {self.address}",
                "its temperature compensation (MD32750) cannot be read",
                kind,
                expected="a bit mask, such as 'H1'",
                hint=CORRECT_VALUE,
            )
        if not (bits and bits & 2 and slope):
            return []
        return [f"temperature compensation with a slope (MD32750, SD43910 = {slope:g})"]
