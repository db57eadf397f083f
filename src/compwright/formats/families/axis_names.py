"""The names of one machine axis in the control's files: by index (AX1), by machine (X1), by channel
(X).

If the files list the names (SINUMERIK: MD10000, MD20080 with MD20070), they all mean the same axis.
The job may name the axis by any of them. Without this list each name is an axis of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.text.addresses import AxisNames, normal_text
from compwright.formats.text.texts import ReadText
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all

_PLACE = re.compile(r"AX([0-9]{1,2})")


def axis_names(
    definition: Definition, texts: Iterable[ReadText], wanted: Sequence[str] = ()
) -> AxisNames:
    """Return the names of each machine axis in the files, such as AX1, X1 and X for one axis.
    ``wanted``: the axis addresses in a job or on the command line, which must be different axes.

    Raises InputError if the files give one name to two axes, UsageError if two addresses are the
    same axis.
    """
    if "machine_axis" not in definition.bindings:
        return AxisNames()
    found: dict[str, dict[str, list[Occurrence]]] = {}
    for text in texts:
        for occurrence in text.occurrences:
            for quantity in ("machine_axis", "channel_axis", "channel_machine_axis"):
                binding = definition.bindings.get(quantity)
                if binding is not None and occurrence.statement == binding.statement:
                    index = str(int(occurrence.tokens["table"].text))
                    found.setdefault(quantity, {}).setdefault(index, []).append(occurrence)
    faults: list[Fault] = []
    machine = _machine(definition, found.get("machine_axis", {}), faults)
    raise_all(InputError, faults)
    places = machine | {
        name: place for name, place in _channel(definition, found).items() if name not in machine
    }
    mine: dict[str, str] = {}
    for address in dict.fromkeys(wanted):
        place = places.get(address, address)
        if place in mine:
            faults.append(
                Fault(
                    message=f"the addresses {mine[place]} and {address} are the same axis of "
                    f"the control, {place}",
                    place="address",
                    expected="each axis once",
                    hint="give each axis of the job an `address` of its own",
                )
            )
        mine.setdefault(place, address)
    raise_all(UsageError, faults)
    return AxisNames(places, machine, mine, _PLACE)


def _machine(
    definition: Definition, entries: Mapping[str, Sequence[Occurrence]], faults: list[Fault]
) -> dict[str, str]:
    places: dict[str, str] = {}
    for index, occurrences in entries.items():
        place = f"AX{int(index) + 1}"
        for occurrence in occurrences:
            name = normal_text(definition, occurrence.tokens["value"].text)
            number = _PLACE.fullmatch(name)
            if places.setdefault(name, place) != place or (number is not None and name != place):
                other = places[name] if number is None else name
                faults.append(
                    Fault(
                        message=(
                            f"the name {name} is used for two machine axes (MD10000), {place} and "
                            f"{other}"
                        ),
                        file=occurrence.file,
                        place=occurrence.place,
                        expected="a name for each axis",
                        found=name,
                        hint="correct MD10000 in the control and export its files again",
                    )
                )
    return places


def _channel(
    definition: Definition, found: Mapping[str, Mapping[str, Sequence[Occurrence]]]
) -> dict[str, str]:
    """Return the machine axis (such as AX1) of each channel axis name, without names that mean
    several machine axes. ``found``: the lines that state axis names, by quantity and index.
    """
    meant: dict[str, set[str]] = {}
    for index, occurrences in found.get("channel_axis", {}).items():
        used = {
            occurrence.tokens["value"].text
            for occurrence in found.get("channel_machine_axis", {}).get(index, ())
        }
        for occurrence in occurrences:
            name = normal_text(definition, occurrence.tokens["value"].text)
            meant.setdefault(name, set()).update(
                f"AX{int(number)}" for number in used if int(number) > 0
            )
    return {name: next(iter(places)) for name, places in meant.items() if len(places) == 1}
