"""The section ``circles`` of a MACHINE.yaml, read as virtual circular tests (schema and example:
``docs/simulation.md``).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Final, Literal

from pydantic_core import core_schema as cs

from compwright.foundations.key_faults import KeyFault, KeyPath, shown
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.foundations.validation import refuse
from compwright.records.axis import Axis, AxisKind
from compwright.simulation.circular import CircleAxis, CircleErrors, CirclePlan
from compwright.simulation.values import (
    TEXT,
    Keys,
    choice,
    either,
    number,
    numbers,
    record,
    same_but_for_case,
    scaled,
    usable,
    whole,
)

CircleFormat = Literal["csv", "b5r"]

_NAME: Final = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,63}")
_LETTERS: Final = re.compile(r"([A-Za-z][0-9]{0,2})([A-Za-z][0-9]{0,2})")
_UM: Final = 1.0 / MICROMETRES_PER_MILLIMETRE
_PPM: Final = 1e-6  # um/m
_SMALLEST_ARC: Final = 90.0
_SAMPLES: Final = (36, 100_000)


@dataclass(frozen=True, slots=True, kw_only=True)
class VirtualCircle:
    """A circular test to simulate: its plan (radius, feed, runs), the errors of the circle, and the
    format of its file.
    """

    plan: CirclePlan
    errors: CircleErrors
    format: CircleFormat = "csv"


def circles_schema(data: Mapping[str, Any]) -> cs.CoreSchema:
    """Return the schema of the section ``circles`` in a MACHINE.yaml, a mapping from name to
    circle.
    """
    each = {
        name: (name, _circle(name, CirclePlan(**usable(_PLAN, own)).axes))
        for name, own in data.items()
    }
    return record(dict, each, each)


def circle_contradictions(data: Mapping[str, Any], axes: Mapping[str, Axis]) -> Iterator[KeyFault]:
    """Yield the faults of circles: wrong names, contradicting values, or a circle outside the
    travel of the machine's ``axes``.
    """
    for name in data:
        path = ("circles", name)
        if not _NAME.fullmatch(name):  # it becomes the name of a file
            expected = "a letter, then letters, digits, _ or -"
            yield KeyFault(path, "is not the name of a circle", expected, shown(name))
        elif name.lower() in {axis.lower() for axis in axes}:
            expected = "names that make different file names"
            yield KeyFault(path, "is the name of an axis too", expected, shown(name))
        plan = CirclePlan(**usable(_PLAN, data[name]))
        if not _SAMPLES[0] <= plan.samples <= _SAMPLES[1]:
            key = "sample_rate_hz" if plan.sample_rate is not None else "arc"
            message = f"makes {plan.samples} samples in a run"
            yield KeyFault((*path, key), message, f"{_SAMPLES[0]} to {_SAMPLES[1]} samples")
        yield from _outside(path, plan, axes)
    yield from same_but_for_case(("circles",), data)


def _outside(path: KeyPath, plan: CirclePlan, axes: Mapping[str, Axis]) -> Iterator[KeyFault]:
    for name, centre in zip(plan.axes, plan.centre, strict=True):
        axis = axes.get(name)
        if axis is None:
            continue
        low, high = axis.travel
        if axis.kind is not AxisKind.LINEAR:
            message = f"names {name}, which is a rotary axis"
            yield KeyFault((*path, "plane"), message, "two linear axes")
        elif low < high and not low <= centre - plan.radius <= centre + plan.radius <= high:
            span = f"{low:g} to {high:g} mm of {name} around the whole circle of {plan.radius:g} mm"
            yield KeyFault((*path, "centre"), "puts the circle outside the travel", span)


def _plane(letters: str) -> tuple[str, str]:
    """Return the first and the second axis of a plane, given as two letters."""
    match = _LETTERS.fullmatch(letters)
    if match is None or match[1] == match[2]:
        expected = "XY, YZ or ZX (first and second axis)"
        refuse(KeyFault((), "names no plane", expected, shown(letters)))
    return match[1], match[2]


def _circle(name: str, axes: tuple[str, str]) -> cs.CoreSchema:
    def built(
        error: CircleErrors = CircleErrors(),  # noqa: B008  # frozen
        format: CircleFormat = "csv",  # noqa: A002  # the key
        **plan: Any,
    ) -> VirtualCircle:
        return VirtualCircle(plan=CirclePlan(name=name, **plan), errors=error, format=format)

    further = {"error": ("error", _errors(axes)), "format": ("format", choice("csv", "b5r"))}
    return record(built, {**_PLAN, **further})


def _errors(axes: tuple[str, str]) -> cs.CoreSchema:
    pair = numbers(_UM, length=2)
    keys = {
        "offset_um": ("offset", pair),
        "squareness_um_per_m": ("squareness", scaled(_PPM)),
        "radius_change_um": ("radius_change", scaled(_UM)),
        "bar_um": ("bar", scaled(_UM)),
        "noise_um": ("noise", scaled(_UM, least=0.0)),
        "correlated_noise_um": ("correlated_noise", scaled(_UM, least=0.0)),
        "correlation": ("correlation", number(least=0.0, below=1.0)),
        axes[0]: ("first", _AXIS),
        axes[1]: ("second", _AXIS),
    }
    return record(CircleErrors, keys)


def _circle_axis(cyclic: Mapping[str, Any] = MappingProxyType({}), **others: Any) -> CircleAxis:
    return CircleAxis(**cyclic, **others)


def _lost_motion(both: float) -> tuple[float, float]:
    return both * _UM, both * _UM


_ARC: Final[Keys] = {
    "start_deg": ("start", number(least=-360.0, most=360.0)),
    "extent_deg": ("extent", number(least=_SMALLEST_ARC, most=360.0)),
}
_PLAN: Final[Keys] = {
    "plane": ("axes", cs.no_info_after_validator_function(_plane, TEXT)),
    "centre": ("centre", numbers(length=2)),
    "radius_mm": ("radius", number(above=0.0)),
    "feed_mm_min": ("feed", number(above=0.0)),
    "arc": ("arc", record(lambda start=0.0, extent=360.0: (start, extent), _ARC)),
    "runs": ("runs", whole(1, 100)),
    "first": ("first", choice("ccw", "cw")),
    "sample_rate_hz": ("sample_rate", number(above=0.0)),
    "overshoot_deg": ("overshoot", number(least=0.0, most=360.0)),
    "calibrated": ("calibrated", cs.bool_schema(strict=True)),
}
_CYCLIC: Final[Keys] = {
    "amplitude_um": ("cyclic", scaled(_UM, least=0.0)),
    "pitch_mm": ("pitch", number(above=0.0)),
    "phase_deg": ("phase", number(math.radians)),
}
#: Lost motion: one number for both reversal points, or the positive and the negative one.
_AXIS: Final = record(
    _circle_axis,
    {
        "cyclic": ("cyclic", record(dict, _CYCLIC, {"amplitude_um", "pitch_mm"})),
        "scale_um_per_m": ("scale", scaled(_PPM)),
        "lost_motion_um": ("lost_motion", either(number(_lost_motion), numbers(_UM, length=2))),
        "lag_ms": ("lag", number(lambda lag: lag / 1000.0)),
        "gain_per_s": ("gain", number(above=0.0)),
        "lateral_play_um": ("lateral_play", scaled(_UM)),
        "spike_um": ("spike", scaled(_UM)),
        "spike_length_mm": ("spike_length", number(above=0.0)),
        "straightness_um": ("straightness", scaled(_UM)),
    },
)
