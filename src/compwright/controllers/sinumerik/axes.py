"""The names of a SINUMERIK's machine axes: AX1 by index, X1 by MD10000, X by channel (MD20080).

A real archive uses several names for the same axis (``$MN_AXCONF_MACHAX_NAME_TAB[0]="X1"`` and
``[0,AX1]``).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment


@dataclass(frozen=True, slots=True)
class MachineAxisNames:
    """The names of the machine axes.

    ``by_name``: the name AXn by any other name in capitals. ``called``: the name in the job by the
    name AXn.
    """

    by_name: dict[str, str]
    called: dict[str, str]

    def name(self, text: str) -> str:
        """Return the name AXn of an axis given by any name; an unknown name unchanged."""
        place = self.by_name.get(text.upper())
        if place is None:
            return self.called.get(text.upper(), text)
        return self.called.get(place, place)

    def is_machine_axis(self, name: str) -> bool:
        """Return whether a name belongs to a machine axis; true for any name if the files list
        none.
        """
        upper = name.upper()
        numbered = upper.startswith("AX") and upper[2:].isdigit()
        return (
            not self.by_name
            or upper in self.by_name
            or upper in map(str.upper, self.called.values())
            or numbered
        )

    def renamed(self, entry: VariableAssignment) -> VariableAssignment:
        """Return an assignment in which axes have their names AXn."""
        axis = self.name(entry.axis) if entry.axis else ""
        names = self.name(entry.names) if entry.names else ""
        return (
            entry
            if (axis, names) == (entry.axis, entry.names)
            else replace(entry, axis=axis, names=names)
        )


def axis_names(contents: Sequence[ProgramContent], request: Request) -> MachineAxisNames:
    """Return the axis names that the files list, except a name that they give to two axes."""
    meant: dict[str, set[str]] = {}
    for content in contents:
        for place, names in content.machine_names.items():
            for name in names:
                meant.setdefault(name, set()).add(f"AX{place + 1}")
    channel: dict[str, set[str]] = {}
    for content in contents:
        for place, names in content.channel_names.items():
            used = {
                number
                for other in contents
                for number in other.channel_places.get(place, ())
                if number > 0
            }
            for name in names - set(meant):
                channel.setdefault(name, set()).update(f"AX{number}" for number in used)
    by_name = {
        name: next(iter(places))
        for name, places in {**channel, **meant}.items()
        if len(places) == 1
    }
    requested = dict.fromkeys((*request.reference_return, *request.encoder, *request.axis_options))
    called = {by_name.get(name.upper(), name.upper()): name for name in requested}
    return MachineAxisNames(by_name, called)
