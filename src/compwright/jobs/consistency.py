"""Check the keys of a job together, for example that the axes and states that the keys name exist.

The checks read the job's data before they are converted, so that their faults are listed together
with those of the schema. The schema reports values of the wrong type.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from compwright.foundations.findings import DOUBTS, REMARKS, RESULTS
from compwright.foundations.key_faults import KeyFault, KeyPath, shown, suggestion, too_large
from compwright.foundations.plain_names import PLAIN_NAME, is_plain_name
from compwright.jobs.axis_consistency import axis_contradictions, implausible
from compwright.jobs.between_axes import applied, circles, cross_measurements
from compwright.jobs.plain_data import list_of, mapping_of, repeated_files
from compwright.records.job import AS_FOUND

NONE_WORD = "none"
_AXIS_NAME = re.compile(r"\w[\w+-]*")


def contradictions(data: Mapping[str, Any]) -> list[KeyFault]:
    """Return a fault for each contradiction between the keys of a job."""
    names = [AS_FOUND, *mapping_of(data.get("states"))]
    standard = data.get("standard", "iso230-2:2014")
    found = [*_states(data.get("states")), *_addresses(data.get("axes"))]
    thermal = mapping_of(data.get("thermal"))
    if "environment" in data:
        thermal = {"T_m": None, **thermal}  # may come from its column material_c
    elif thermal and "T_m" not in thermal:
        found.append(KeyFault(("thermal", "T_m"), "is missing", "a temperature in °C"))
    for name, axis in mapping_of(data.get("axes")).items():
        path = ("axes", name)
        if not _AXIS_NAME.fullmatch(name):
            found.append(
                KeyFault(
                    path,
                    "is not a valid name for an axis",
                    "letters and digits (X, B2)",
                    shown(name),
                )
            )
        section = mapping_of(axis)
        found += axis_contradictions(section, path, names, standard, thermal)
    found += [
        *implausible(data.get("thermal"), ("thermal",)),
        *_untested(data),
        *circles(data.get("circles"), names),
        *cross_measurements(data.get("cross"), data.get("axes"), names),
        *_acknowledged(data.get("acknowledged"), list(mapping_of(data.get("axes")))),
    ]
    return [*found, *applied(data.get("apply"))]


def unusable(value: Any, path: KeyPath = ()) -> Iterator[KeyFault]:
    """Yield faults of empty keys and too large numbers at any depth of the job."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from unusable(inner, (*path, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from unusable(inner, (*path, index))
    elif value is None:
        expected = "a value, or the key left out"
        if len(path) == 3 and path[-1] == "before":
            unmeasured = f"was {path[1]} not measured, delete the axis from the job"
            expected = f"the file of the test; {unmeasured}"
        yield KeyFault(path, "has no value", expected)
    elif too_large(value):
        yield KeyFault(
            path, "is too large for a number", "quotes around it if it is text", shown(value)
        )


def _states(states: Any) -> Iterator[KeyFault]:
    for name, state in mapping_of(states).items():
        path: KeyPath = ("states", name, "files") if isinstance(state, dict) else ("states", name)
        files = state.get("files") if isinstance(state, dict) else state
        if not name.strip():
            yield KeyFault(
                ("states", name),
                "is an entry of `states` without a name",
                "as_found, or a name of your own",
            )
        elif not is_plain_name(name):
            yield KeyFault(
                ("states", name),
                "is not a valid name for an entry of `states`",
                PLAIN_NAME,
                shown(name),
            )
        if len(list_of(files)) > 1 and NONE_WORD in list_of(files):
            yield KeyFault(
                path, "names files and none at once", "the word none, or the control's files"
            )
        if files in (NONE_WORD, [NONE_WORD]) and "active" in mapping_of(state):
            yield KeyFault(
                ("states", name, "active"),
                "has no meaning here, because this state is `none` (no compensation is active)",
                found=shown(state["active"]),
                hint="remove this key",
            )
        yield from repeated_files(list_of(files), path)


def _addresses(axes: Any) -> Iterator[KeyFault]:
    """Yield a fault if two axes have the same address (they would get the same table), if an axis
    is its own gantry slave, or if a gantry slave is named by the name of its axis in the job.
    """
    seen: dict[str, str] = {}
    addresses = {
        str(name): str(mapping_of(axis).get("address", name))
        for name, axis in mapping_of(axes).items()
    }
    for name, axis in mapping_of(axes).items():
        section = mapping_of(axis)
        address = section.get("address", name)
        if isinstance(address, bool) or not isinstance(address, str | int):
            continue
        path = ("axes", name, "address") if "address" in section else ("axes", name)
        if str(address) in seen:
            yield KeyFault(
                path,
                f"has the same address as axis {seen[str(address)]}",
                "another address",
                shown(address),
            )
        gantry = section.get("gantry")
        slave = str(mapping_of(gantry).get("axis", gantry))
        if slave not in addresses.values() and addresses.get(slave, slave) != slave:
            yield KeyFault(
                ("axes", name, "gantry"),
                "is the name of an axis of the job, which has another address on the control",
                "the address of the synchronised axis",
                shown(slave),
                hint=f"write `gantry: {addresses[slave]}`",
            )
        if slave == str(address):
            yield KeyFault(
                ("axes", name, "gantry"),
                "is the axis itself",
                "the synchronised axis",
                shown(address),
            )
        seen.setdefault(str(address), name)


def _untested(data: Mapping[str, Any]) -> Iterator[KeyFault]:
    """Yield a fault for an axis without any test, if there are no circular tests or cross
    measurements.
    """
    if list_of(data.get("circles")) or list_of(data.get("cross")):
        return
    for name, axis in mapping_of(data.get("axes")).items():
        if mapping_of(axis).get("before") == []:
            yield KeyFault(
                ("axes", name, "before"),
                "is too short",
                "at least 1 in the list, or a test under circles or cross",
                "an empty list",
            )


def _acknowledged(section: Any, axes: Sequence[str]) -> Iterator[KeyFault]:
    """Yield a fault for each acknowledgement with a code that is not that of a doubt, or with an
    axis that is not in the job.
    """
    for code, value in mapping_of(section).items():
        path: KeyPath = ("acknowledged", code)
        if code in RESULTS:
            yield KeyFault(
                path,
                "is a result that keeps the verdict open and cannot be acknowledged",
                hint="remove this line, and do what the finding says",
            )
        elif code in REMARKS:
            yield KeyFault(
                path,
                "is not a doubt: it keeps no decision open, and needs no acknowledgement",
                hint="remove this line; docs/findings.md lists the doubts",
            )
        elif code not in DOUBTS:
            yield KeyFault(path, "is not the code of a finding", suggestion(code, DOUBTS))
        for index, entry in enumerate(value if isinstance(value, list) else [value]):
            axis = mapping_of(entry).get("axis")
            if isinstance(axis, str | int) and str(axis) not in axes:
                within = (*path, index) if isinstance(value, list) else path
                yield KeyFault(
                    (*within, "axis"),
                    "names no axis of this job",
                    suggestion(str(axis), axes),
                    shown(axis),
                )
