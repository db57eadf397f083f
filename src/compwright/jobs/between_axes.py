"""Check job keys on several axes: circular tests, cross measurements, corrections between axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from compwright.foundations.key_faults import KeyFault, KeyPath, shown, suggestion
from compwright.foundations.units import TO_INSIDE
from compwright.jobs.plain_data import (
    default_name,
    list_of,
    mapping_of,
    number_of,
    unknown_state,
)
from compwright.records.circular import CIRCULAR_NAMES
from compwright.records.job import other_axis


def circles(circles: Any, states: Sequence[str]) -> Iterator[KeyFault]:
    """Yield a fault for each circular test with no or unclear files, a repeated name, an unknown
    state, or limits for unknown parameters.
    """
    seen: set[str] = set()
    for index, entry in enumerate(list_of(circles)):
        circle, path = mapping_of(entry), ("circles", index)
        given = [key for key in ("file", "ccw", "cw") if key in circle]
        if isinstance(entry, dict) and (not given or ("file" in given and len(given) > 1)):
            found = ", ".join(given) or "none of them"
            yield KeyFault(path, "does not say which files", "file, or ccw and cw", found)
        first = circle.get(given[0]) if given else None
        name = circle.get("name", default_name(first) if isinstance(first, str) else None)
        if isinstance(name, str) and name in seen:
            yield KeyFault(path, "has the name of another circle", "a name of its own", shown(name))
        seen.add(str(name))
        yield from unknown_state(circle, path, states)
        for key in mapping_of(circle.get("accept")):
            if key not in CIRCULAR_NAMES:
                message = "is not a parameter of a circular test"
                yield KeyFault((*path, "accept", key), message, suggestion(key, CIRCULAR_NAMES))


def cross_measurements(cross: Any, axes: Any, states: Sequence[str]) -> Iterator[KeyFault]:
    """Yield faults of measurements of one axis over another, such as lists of unequal length."""
    seen: set[tuple[str, str]] = set()
    for index, entry in enumerate(list_of(cross)):
        section, path = mapping_of(entry), ("cross", index)
        yield from unknown_state(section, path, states)
        pair = (str(section.get("input")), str(section.get("output")))
        if section and pair in seen:
            expected = "one measurement for each pair of axes"
            yield KeyFault(
                path, "measures the same pair of axes again", expected, f"{pair[0]} on {pair[1]}"
            )
        seen.add(pair)
        yield from _cross_unit(section, path, axes)
        if section and section.get("input") == section.get("output"):
            yield KeyFault(
                (*path, "output"), "is the input axis", "another axis", shown(section.get("output"))
            )
        positions = [number_of(value) for value in list_of(section.get("positions"))]
        deviations = list_of(section.get("deviations"))
        if positions and deviations and len(positions) != len(deviations):
            expected = f"{len(positions)} deviations, one for each position"
            yield KeyFault(
                (*path, "deviations"), "do not match the positions", expected, str(len(deviations))
            )
        known = [value for value in positions if value is not None]
        if len(known) != len(set(known)):
            yield KeyFault((*path, "positions"), "hold a position twice", "each position once")


def _cross_unit(section: Mapping[str, Any], path: KeyPath, axes: Any) -> Iterator[KeyFault]:
    """Yield a fault for a unit of angle with a linear axis, or of length with a rotary axis."""
    unit, output = section.get("unit"), mapping_of(mapping_of(axes).get(str(section.get("output"))))
    if not isinstance(unit, str) or unit not in TO_INSIDE or not output:
        return
    kind = "rotary" if output.get("kind") == "rotary" else "linear"
    if (TO_INSIDE[unit][0] == "deg") != (kind == "rotary"):
        yield KeyFault(
            (*path, "unit"),
            f"does not fit the {kind} axis {section['output']}",
            "um or mm" if kind == "linear" else "arcsec or deg",
            shown(unit),
        )


def applied(section: Any) -> Iterator[KeyFault]:
    """Yield a fault for each plane in ``apply: squareness`` that is named twice or does not contain
    the axis to be corrected.
    """
    seen: set[frozenset[str]] = set()
    for plane, bent in mapping_of(mapping_of(section).get("squareness")).items():
        pair = frozenset({str(bent), other_axis(str(plane), str(bent))})
        if pair in seen:
            yield KeyFault(
                ("apply", "squareness", plane),
                "names this plane again",
                "each plane once",
                shown(bent),
            )
        seen.add(pair)
        if isinstance(bent, str) and (
            plane == bent or not (plane.startswith(bent) or plane.endswith(bent))
        ):
            yield KeyFault(
                ("apply", "squareness", plane),
                "is not an axis of this plane",
                f"the bent axis of {plane}",
                shown(bent),
            )
