"""What ties the keys of a job together: names that must exist, ends in order, values that exclude
each other.

Works on the plain data as read, so that its faults stand beside those of the schema; whatever has
the wrong type is the schema's to report and is passed over here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PureWindowsPath
from typing import Any

from compwright.foundations.plain_names import PLAIN_NAME, is_plain_name
from compwright.foundations.units import TO_INSIDE
from compwright.foundations.yaml_reader import KeyPath
from compwright.jobs.faults import number_hint, shown, suggestion, too_large
from compwright.records.job import (
    AS_FOUND,
    LEAST_EXPANSION,
    MOST_EXPANSION,
    PLAUSIBLE_TEMPERATURES,
    other_axis,
)

NONE_WORD = "none"
ISO_PARAMETERS = (
    *("A", "A_positive", "A_negative", "E", "E_positive", "E_negative", "M"),
    *("R", "R_positive", "R_negative", "B", "B_mean"),
)
VDI_PARAMETERS = ("P", "Ps_max", "Ps_mean", "Pa", "U_max", "U_mean")
_NOT_IN_1988 = ("E", "E_positive", "E_negative", "M", "B")
_MOST_NODES = 100_000  # no control holds a tenth of that; a finer grid is a slip of the unit
_AXIS_NAME = re.compile(r"\w[\w+-]*")


@dataclass(frozen=True, slots=True)
class Contradiction:
    """A fault with its key path; the caller adds file and line."""

    path: KeyPath
    message: str
    expected: str = ""
    found: str = ""


def contradictions(data: Mapping[str, Any]) -> list[Contradiction]:
    """Return everything that does not hold together in a job as read."""
    names = [AS_FOUND, *_mapping(data.get("states"))]
    standard = data.get("standard", "iso230-2:2014")
    found = [*_values(data, ()), *_states(data.get("states")), *_addresses(data.get("axes"))]
    for name, axis in _mapping(data.get("axes")).items():
        path = ("axes", name)
        if not _AXIS_NAME.fullmatch(name):
            found.append(
                Contradiction(
                    path,
                    "is no name for an axis",
                    "letters and digits, such as X or B2",
                    shown(name),
                )
            )
        section = _mapping(axis)
        found += [
            *_geometry(section, path),
            *_tests(section, path, names),
            *_acceptance(section, path, standard),
            *_thermal(section, path, data.get("thermal")),
        ]
    found += [
        *_implausible(data.get("thermal"), ("thermal",)),
        *_untested(data),
        *_circles(data.get("circles"), names),
        *_cross(data.get("cross"), data.get("axes"), names),
    ]
    return [*found, *_apply(data.get("apply"))]


def default_name(file: str) -> str:
    """Return the default name of a test: the stem of its file, whichever way its path is
    written.
    """
    return PureWindowsPath(file).stem or file


def _mapping(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _sequence(value: Any) -> Sequence[Any]:
    return value if isinstance(value, list) else []


def _number(value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float) or too_large(value):
        return None
    return float(value)


def _values(value: Any, path: KeyPath) -> Iterator[Contradiction]:
    """Find keys without a value and numbers too large, wherever they stand."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from _values(inner, (*path, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _values(inner, (*path, index))
    elif value is None:
        yield Contradiction(path, "has no value", "a value, or the key left out")
    elif too_large(value):
        yield Contradiction(
            path, "is too large for a number", "quotes around it if it is text", shown(value)
        )


def _states(states: Any) -> Iterator[Contradiction]:
    for name, state in _mapping(states).items():
        path: KeyPath = ("states", name, "files") if isinstance(state, dict) else ("states", name)
        files = state.get("files") if isinstance(state, dict) else state
        if not name.strip():
            yield Contradiction(
                ("states", name), "is a state without a name", "as_found, or a name of your own"
            )
        elif not is_plain_name(name):
            yield Contradiction(("states", name), "is no name for a state", PLAIN_NAME, shown(name))
        if len(_sequence(files)) > 1 and NONE_WORD in _sequence(files):
            yield Contradiction(
                path, "names files and none at once", "the word none, or the control's files"
            )
        if files in (NONE_WORD, [NONE_WORD]) and "active" in _mapping(state):
            found = shown(state["active"])
            yield Contradiction(
                ("states", name, "active"),
                "is said of a state in which nothing acts",
                "no active beside none",
                found,
            )
        yield from _repeated_files(_sequence(files), path)


def _repeated_files(files: Sequence[Any], path: KeyPath) -> Iterator[Contradiction]:
    for index, file in enumerate(files):
        if isinstance(file, str) and file in files[:index]:
            yield Contradiction((*path, index), "is given twice", "each file once", shown(file))


def _addresses(axes: Any) -> Iterator[Contradiction]:
    """Two axes under one address would be written into one table."""
    seen: dict[str, str] = {}
    for name, axis in _mapping(axes).items():
        section = _mapping(axis)
        address = section.get("address", name)
        if isinstance(address, bool) or not isinstance(address, str | int):
            continue
        path = ("axes", name, "address") if "address" in section else ("axes", name)
        if str(address) in seen:
            yield Contradiction(
                path,
                f"has the same address as axis {seen[str(address)]}",
                "another address",
                shown(address),
            )
        if str(section.get("gantry")) == str(address):
            yield Contradiction(
                ("axes", name, "gantry"),
                "is the axis itself",
                "the synchronised axis",
                shown(address),
            )
        seen.setdefault(str(address), name)


def _geometry(section: Mapping[str, Any], path: KeyPath) -> Iterator[Contradiction]:
    travel = [_number(end) for end in _sequence(section.get("travel"))]
    low, high = travel if len(travel) == 2 else (None, None)
    if low is not None and high is not None and low >= high:
        yield Contradiction(
            (*path, "travel"),
            "ends are not in order",
            "[low, high] with low < high",
            f"[{low:g}, {high:g}]",
        )
    table = _mapping(section.get("table"))
    start, end, spacing = (_number(table.get(key)) for key in ("start", "end", "spacing"))
    if start is not None and end is not None and start >= end:
        yield Contradiction(
            (*path, "table"),
            "ends are not in order",
            "start < end",
            f"start {start:g}, end {end:g}",
        )
    first, last = (low if start is None else start), (high if end is None else end)
    if (
        first is not None
        and last is not None
        and spacing is not None
        and 0 < spacing * _MOST_NODES < last - first
    ):
        expected = f"at least {(last - first) / _MOST_NODES:g} mm or deg"
        yield Contradiction(
            (*path, "table", "spacing"),
            f"asks for more than {_MOST_NODES} nodes",
            expected,
            f"{spacing:g}",
        )
    if section.get("kind") == "rotary" and section.get("programmed") == "diameter":
        yield Contradiction(
            (*path, "programmed"),
            "belongs to a linear axis",
            "radius",
            "'diameter' on a rotary axis",
        )


def _test_sections(
    section: Mapping[str, Any],
) -> Iterator[tuple[KeyPath, str | None, Mapping[str, Any]]]:
    """Yield path below the axis, name and mapping of each test, in every way in which tests may be
    written.
    """
    before = section.get("before")
    entries = before if isinstance(before, list) else [before]
    for index, entry in enumerate(entries):
        path: KeyPath = ("before", index) if isinstance(before, list) else ("before",)
        test = {"files": [entry]} if isinstance(entry, str) else _mapping(entry)
        files = test.get("files")
        first = next(iter(_sequence(files)), None) if not isinstance(files, str) else files
        name = test.get("name", default_name(first) if isinstance(first, str) else None)
        yield path, str(name) if isinstance(name, str | int) else None, test


def _tests(
    section: Mapping[str, Any], path: KeyPath, states: Sequence[str]
) -> Iterator[Contradiction]:
    seen: set[str] = set()
    for below, name, test in _test_sections(section):
        if name is not None and name in seen:
            expected = "a name of its own: {files: [..], name: ..}"
            yield Contradiction(
                (*path, *below), "has the name of another test of this axis", expected, shown(name)
            )
        seen.add(name or "")
        yield from _known_state(test, (*path, *below), states)
        yield from _repeated_files(_sequence(test.get("files")), (*path, *below, "files"))


def _thermal(section: Mapping[str, Any], path: KeyPath, of_job: Any) -> Iterator[Contradiction]:
    """Keys of an axis and of its tests go over those of the job: together they have to say
    coefficient and temperature. Angles do not expand.
    """
    of_axis = section.get("thermal")
    stated: list[tuple[KeyPath, Any, bool]] = [((), of_axis, "thermal" in section)]
    stated += [
        (below, test.get("thermal"), "thermal" in test)
        for below, _, test in _test_sections(section)
    ]
    for below, own, there in stated:
        here = (*path, *below, "thermal")
        if there and section.get("kind") == "rotary":
            yield Contradiction(here, "belongs to a linear axis", "no thermal on a rotary axis")
            continue
        yield from _implausible(own, here)
        known = {*_mapping(of_job), *_mapping(of_axis), *_mapping(own)}
        for key in ("alpha_m", "T_m"):
            if there and isinstance(own, dict) and key not in known:
                yield Contradiction(
                    (*here, key), "is missing", "here, or under thermal of the axis or of the job"
                )


def _implausible(thermal: Any, path: KeyPath) -> Iterator[Contradiction]:
    """Temperatures in another unit than °C, and expansions that no metal, glass or ceramic has."""
    for key in ("T_m", "T_d"):
        value = _mapping(thermal).get(key)
        low, high = PLAUSIBLE_TEMPERATURES
        for place, each in enumerate(value if isinstance(value, list) else [value]):
            number = _number(each)
            if number is None or low <= number <= high:
                continue
            here = (*path, key, place) if isinstance(value, list) else (*path, key)
            yield Contradiction(
                here,
                "is no temperature of a test in °C",
                f"{low:g} to {high:g}{_in_celsius(number)}",
                shown(each),
            )
    for key in ("alpha_m", "alpha_d"):
        number, most = _number(_mapping(thermal).get(key)), MOST_EXPANSION
        if number is not None and not (number == 0.0 or LEAST_EXPANSION <= number <= most):
            yield Contradiction(
                (*path, key),
                "is no coefficient of expansion in µm/(m K)",
                f"0, or {LEAST_EXPANSION:g} to {most:g}; steel has about 11.5",
                shown(_mapping(thermal)[key]),
            )


def _in_celsius(number: float) -> str:
    """Return what a temperature is in °C, where it would be that of a hall in °F or in K."""
    for unit, celsius in (("°F", (number - 32.0) / 1.8), ("K", number - 273.15)):
        if 0.0 <= celsius <= 50.0:
            return f"; {number:g} {unit} are {celsius:.1f} °C"
    return ""


def _known_state(
    section: Mapping[str, Any], path: KeyPath, states: Sequence[str]
) -> Iterator[Contradiction]:
    state = section.get("measured_in", AS_FOUND)
    if isinstance(state, str | int) and str(state) not in states:
        yield Contradiction(
            (*path, "measured_in"),
            "names no state of this job",
            suggestion(str(state), states),
            shown(state),
        )


def _acceptance(
    section: Mapping[str, Any], path: KeyPath, standard: Any
) -> Iterator[Contradiction]:
    accept = _mapping(section.get("accept"))
    known = VDI_PARAMETERS if standard == "vdi3441" else ISO_PARAMETERS
    undefined = _NOT_IN_1988 if standard == "iso230-2:1988" else ()
    for key, limit in accept.items():
        here = (*path, "accept", key)
        if key == "test":
            names = [name for _, name, _ in _test_sections(section) if name is not None]
            if not isinstance(limit, str | int) or str(limit) not in names:
                yield Contradiction(
                    here, "names no test of this axis", suggestion(str(limit), names), shown(limit)
                )
        elif key not in known:
            yield Contradiction(here, f"is no parameter of {standard}", suggestion(key, known))
        elif key in undefined:
            yield Contradiction(
                here,
                f"is not defined by {standard}",
                suggestion("", [n for n in known if n not in undefined]),
            )
        else:
            yield from _limit(limit, here)
    if "accept" in section and not set(accept) - {"test"} and isinstance(section["accept"], dict):
        yield Contradiction(
            (*path, "accept"),
            "holds no limit",
            "a parameter with its limit in µm or arcsec: {A: 8}",
        )


def _limit(limit: Any, path: KeyPath) -> Iterator[Contradiction]:
    hint = number_hint(limit) if isinstance(limit, str) else ""
    if limit is None or (
        isinstance(limit, int | float) and not isinstance(limit, bool) and limit > 0
    ):
        return
    message = f"is text, not a number ({hint})" if hint else "is no limit"
    yield Contradiction(path, message, "a number above 0, in µm or arcsec", shown(limit))


def _untested(data: Mapping[str, Any]) -> Iterator[Contradiction]:
    """An axis without any test has no work to do, unless a circle or a cross measurement speaks of
    it.
    """
    if _sequence(data.get("circles")) or _sequence(data.get("cross")):
        return
    for name, axis in _mapping(data.get("axes")).items():
        if _mapping(axis).get("before") == []:
            path = ("axes", name, "before")
            yield Contradiction(
                path,
                "is too short",
                "at least 1 in the list, or a test under circles or cross",
                "an empty list",
            )


def _circles(circles: Any, states: Sequence[str]) -> Iterator[Contradiction]:
    seen: set[str] = set()
    for index, entry in enumerate(_sequence(circles)):
        circle, path = _mapping(entry), ("circles", index)
        given = [key for key in ("file", "ccw", "cw") if key in circle]
        if isinstance(entry, dict) and (not given or ("file" in given and len(given) > 1)):
            found = ", ".join(given) or "none of them"
            yield Contradiction(path, "does not say which files", "file, or ccw and cw", found)
        first = circle.get(given[0]) if given else None
        name = circle.get("name", default_name(first) if isinstance(first, str) else None)
        if isinstance(name, str) and name in seen:
            yield Contradiction(
                path, "has the name of another circle", "a name of its own", shown(name)
            )
        seen.add(str(name))
        yield from _known_state(circle, path, states)


def _cross(cross: Any, axes: Any, states: Sequence[str]) -> Iterator[Contradiction]:
    seen: set[tuple[str, str]] = set()
    for index, entry in enumerate(_sequence(cross)):
        section, path = _mapping(entry), ("cross", index)
        yield from _known_state(section, path, states)
        pair = (str(section.get("input")), str(section.get("output")))
        if section and pair in seen:
            expected = "one measurement for each pair of axes"
            yield Contradiction(
                path, "measures the same pair of axes again", expected, f"{pair[0]} on {pair[1]}"
            )
        seen.add(pair)
        yield from _cross_unit(section, path, axes)
        if section and section.get("input") == section.get("output"):
            yield Contradiction(
                (*path, "output"), "is the input axis", "another axis", shown(section.get("output"))
            )
        positions = [_number(value) for value in _sequence(section.get("positions"))]
        deviations = _sequence(section.get("deviations"))
        if positions and deviations and len(positions) != len(deviations):
            expected = f"{len(positions)} deviations, one for each position"
            yield Contradiction(
                (*path, "deviations"), "do not match the positions", expected, str(len(deviations))
            )
        known = [value for value in positions if value is not None]
        if len(known) != len(set(known)):
            yield Contradiction((*path, "positions"), "hold a position twice", "each position once")


def _cross_unit(section: Mapping[str, Any], path: KeyPath, axes: Any) -> Iterator[Contradiction]:
    """Deviations are lengths of a linear output axis and angles of a rotary one."""
    unit, output = section.get("unit"), _mapping(_mapping(axes).get(str(section.get("output"))))
    if not isinstance(unit, str) or unit not in TO_INSIDE or not output:
        return
    kind = "rotary" if output.get("kind") == "rotary" else "linear"
    if (TO_INSIDE[unit][0] == "deg") != (kind == "rotary"):
        expected = "um or mm" if kind == "linear" else "arcsec or deg"
        yield Contradiction(
            (*path, "unit"),
            f"does not fit the {kind} axis {section['output']}",
            expected,
            shown(unit),
        )


def _apply(section: Any) -> Iterator[Contradiction]:
    seen: set[frozenset[str]] = set()
    for plane, bent in _mapping(_mapping(section).get("squareness")).items():
        pair = frozenset({str(bent), other_axis(str(plane), str(bent))})
        if pair in seen:
            yield Contradiction(
                ("apply", "squareness", plane),
                "names this plane again",
                "each plane once",
                shown(bent),
            )
        seen.add(pair)
        if isinstance(bent, str) and (
            plane == bent or not (plane.startswith(bent) or plane.endswith(bent))
        ):
            found = shown(bent)
            yield Contradiction(
                ("apply", "squareness", plane),
                "is no axis of this plane",
                f"the bent axis of {plane}",
                found,
            )
