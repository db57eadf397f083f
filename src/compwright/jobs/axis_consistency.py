"""Check the keys of one axis in a job together: travel and table, tests, limits, temperatures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from compwright.foundations.key_faults import KeyFault, KeyPath, number_hint, shown, suggestion
from compwright.jobs.plain_data import (
    default_name,
    list_of,
    mapping_of,
    number_of,
    repeated_files,
    unknown_state,
)
from compwright.records.conditions import LEAST_EXPANSION, MOST_EXPANSION, PLAUSIBLE_TEMPERATURES

ISO_PARAMETERS = (
    *("A", "A_positive", "A_negative", "E", "E_positive", "E_negative", "M"),
    *("R", "R_positive", "R_negative", "B", "B_mean"),
)
VDI_PARAMETERS = ("P", "Ps_max", "Ps_mean", "Pa", "U_max", "U_mean")
_NOT_IN_1988 = ("E", "E_positive", "E_negative", "M", "B")
_MOST_POINTS = 100_000  # no control holds a tenth of that; a finer grid is a slip of the unit


def axis_contradictions(
    section: Mapping[str, Any], path: KeyPath, states: Sequence[str], standard: Any, thermal: Any
) -> Iterator[KeyFault]:
    """Yield the contradictions between keys in the ``section`` of one axis, and between these and
    the job's keys ``states``, ``standard`` and ``thermal``.

    ``states``: the names of the control's states in which the tests can have been measured.
    """
    yield from _geometry(section, path)
    yield from _tests(section, path, states)
    yield from _acceptance(section, path, standard)
    yield from _thermal(section, path, thermal)


def _geometry(section: Mapping[str, Any], path: KeyPath) -> Iterator[KeyFault]:
    travel = [number_of(end) for end in list_of(section.get("travel"))]
    low, high = travel if len(travel) == 2 else (None, None)
    if low is not None and high is not None and low >= high:
        yield KeyFault(
            (*path, "travel"),
            "ends are not in order",
            f"low < high, such as [{high:.10g}, {low:.10g}]",
            f"[{low:.10g}, {high:.10g}]",
        )
    table = mapping_of(section.get("table"))
    start, end, spacing = (number_of(table.get(key)) for key in ("start", "end", "spacing"))
    if start is not None and end is not None and start >= end:
        yield KeyFault(
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
        and 0 < spacing * _MOST_POINTS < last - first
    ):
        yield KeyFault(
            (*path, "table", "spacing"),
            f"asks for more than {_MOST_POINTS} points",
            f"at least {(last - first) / _MOST_POINTS:g} mm or deg",
            f"{spacing:g}",
        )
    if section.get("kind") == "rotary" and section.get("programmed") == "diameter":
        yield KeyFault(
            (*path, "programmed"),
            "belongs to a linear axis",
            "radius",
            "'diameter' on a rotary axis",
            "remove this key",
        )


def _test_sections(
    section: Mapping[str, Any],
) -> Iterator[tuple[KeyPath, str | None, Mapping[str, Any]]]:
    """Yield key path, name and mapping of each test of an axis, in any form the job allows."""
    before = section.get("before")
    for index, entry in enumerate(before if isinstance(before, list) else [before]):
        path: KeyPath = ("before", index) if isinstance(before, list) else ("before",)
        test = {"files": [entry]} if isinstance(entry, str) else mapping_of(entry)
        files = test.get("files")
        first = next(iter(list_of(files)), None) if not isinstance(files, str) else files
        name = test.get("name", default_name(first) if isinstance(first, str) else None)
        yield path, str(name) if isinstance(name, str | int) else None, test


def _tests(section: Mapping[str, Any], path: KeyPath, states: Sequence[str]) -> Iterator[KeyFault]:
    seen: set[str] = set()
    for below, name, test in _test_sections(section):
        if name is not None and name in seen:
            expected = "a name of its own: {files: [..], name: ..}"
            yield KeyFault(
                (*path, *below), "has the name of another test of this axis", expected, shown(name)
            )
        seen.add(name or "")
        yield from unknown_state(test, (*path, *below), states)
        yield from repeated_files(list_of(test.get("files")), (*path, *below, "files"))


def _thermal(section: Mapping[str, Any], path: KeyPath, of_job: Any) -> Iterator[KeyFault]:
    """Yield faults in the temperatures and expansion coefficients of an axis and its tests.
    ``of_job``: the job's key ``thermal``, whose values they override.

    A rotary axis must have no expansion coefficient, because angles do not expand.
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
            yield KeyFault(here, "belongs to a linear axis", hint="remove this key")
            continue
        yield from implausible(own, here)
        known = {*mapping_of(of_job), *mapping_of(of_axis), *mapping_of(own)}
        for key in ("alpha_m", "T_m"):
            if there and isinstance(own, dict) and key not in known:
                yield KeyFault(
                    (*here, key), "is missing", "here, or under thermal of the axis or of the job"
                )


def implausible(thermal: Any, path: KeyPath) -> Iterator[KeyFault]:
    """Yield faults of temperatures probably not in °C, and of implausible coefficients."""
    for key in ("T_m", "T_d"):
        value = mapping_of(thermal).get(key)
        low, high = PLAUSIBLE_TEMPERATURES
        for place, each in enumerate(value if isinstance(value, list) else [value]):
            number = number_of(each)
            if number is None or low <= number <= high:
                continue
            yield KeyFault(
                (*path, key, place) if isinstance(value, list) else (*path, key),
                "is not a plausible temperature of a test in °C",
                f"{low:g} to {high:g}{_in_celsius(number)}",
                shown(each),
            )
    for key in ("alpha_m", "alpha_d"):
        number, most = number_of(mapping_of(thermal).get(key)), MOST_EXPANSION
        if number is not None and not (number == 0.0 or LEAST_EXPANSION <= number <= most):
            yield KeyFault(
                (*path, key),
                "is not a coefficient of expansion in µm/(m K)",
                f"0, or {LEAST_EXPANSION:g} to {most:g}; steel has about 11.5",
                shown(mapping_of(thermal)[key]),
            )


def _in_celsius(number: float) -> str:
    """Return a number as text in °C if it is plausible only as a value in °F or K, else ""."""
    for unit, celsius in (("°F", (number - 32.0) / 1.8), ("K", number - 273.15)):
        if 0.0 <= celsius <= 50.0:
            return f"; {number:g} {unit} are {celsius:.1f} °C"
    return ""


def _acceptance(section: Mapping[str, Any], path: KeyPath, standard: Any) -> Iterator[KeyFault]:
    accept = mapping_of(section.get("accept"))
    known = VDI_PARAMETERS if standard == "vdi3441" else ISO_PARAMETERS
    undefined = _NOT_IN_1988 if standard == "iso230-2:1988" else ()
    defined = [name for name in known if name not in undefined]
    for key, limit in accept.items():
        here = (*path, "accept", key)
        if key == "test":
            names = [name for _, name, _ in _test_sections(section) if name is not None]
            if not isinstance(limit, str | int) or str(limit) not in names:
                yield KeyFault(
                    here, "names no test of this axis", suggestion(str(limit), names), shown(limit)
                )
        elif key not in known:
            yield KeyFault(here, f"is not a parameter of {standard}", suggestion(key, defined))
        elif key in undefined:
            yield KeyFault(here, f"is not defined by {standard}", suggestion("", defined))
        else:
            yield from _limit(limit, here)
    if "accept" in section and not set(accept) - {"test"} and isinstance(section["accept"], dict):
        yield KeyFault(
            (*path, "accept"),
            "contains no limit",
            "a parameter with its limit in µm or arcsec, such as {A: 8}",
        )


def _limit(limit: Any, path: KeyPath) -> Iterator[KeyFault]:
    hint = number_hint(limit) if isinstance(limit, str) else ""
    if limit is None or (
        isinstance(limit, int | float) and not isinstance(limit, bool) and limit > 0
    ):
        return
    message = f"is text, not a number ({hint})" if hint else "is not a limit"
    yield KeyFault(path, message, "a number above 0, in µm or arcsec", shown(limit))
