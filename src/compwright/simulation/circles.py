"""The section ``circles`` of a MACHINE.yaml -> virtual circular tests. The schema with an example
is ``docs/simulation.md``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, Literal, cast

from compwright.foundations.errors import Fault
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import Axis, AxisKind
from compwright.simulation.circular import CircleAxis, CircleErrors, CirclePlan
from compwright.simulation.fields import Section

CircleFormat = Literal["csv", "b5r"]

_NAME: Final = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,63}")
_LETTERS: Final = re.compile(r"([A-Za-z][0-9]{0,2})([A-Za-z][0-9]{0,2})")
_UM: Final = 1.0 / MICROMETRES_PER_MILLIMETRE
_PPM: Final = 1e-6  # um/m
_SMALLEST_ARC: Final = 90.0
_SAMPLES: Final = (36, 100_000)


@dataclass(frozen=True, slots=True, kw_only=True)
class VirtualCircle:
    """A circle to be measured: its plan, its own errors, and the form of its file."""

    plan: CirclePlan
    errors: CircleErrors
    format: CircleFormat = "csv"


def read_circles(section: Section, axes: Mapping[str, Axis]) -> dict[str, VirtualCircle]:
    """Return the circles by name; ``axes`` are the machine's, in whose travel a circle must lie.
    Faults go into the section.
    """
    for name in section.data:
        if not _NAME.fullmatch(name):  # it becomes the name of a file
            section.reject(
                name, "is not the name of a circle", "a letter, then letters, digits, _ or -"
            )
        elif name.lower() in {axis.lower() for axis in axes}:
            section.reject(
                name, "is the name of an axis too", "names that make different file names"
            )
    if len({name.lower() for name in section.data}) < len(section.data):
        document, file = section.document, section.file
        fault = Fault(
            message="has names that differ in upper and lower case only",
            file=file,
            place=document.place(section.path),
        )
        section.faults.append(fault)
    return {
        name: _circle(name, own, axes)
        for name in section.data
        if (own := section.section(name)) is not None
    }


def _circle(name: str, section: Section, axes: Mapping[str, Axis]) -> VirtualCircle:
    names = _plane(section)
    error = section.section("error")
    plan = _plan(name, section, names)
    _check_travel(section, plan, axes)
    circle = VirtualCircle(
        plan=plan,
        errors=_errors(error, names) if error is not None else CircleErrors(),
        format=cast("CircleFormat", section.choice("format", ["csv", "b5r"], "csv")),
    )
    section.close()
    return circle


def _plane(section: Section) -> tuple[str, str]:
    """Return first and second axis."""
    match = _LETTERS.fullmatch(section.text("plane", "XY"))
    if match is None or match[1] == match[2]:
        section.reject("plane", "names no plane", "first and second axis, such as XY, YZ or ZX")
        return "X", "Y"
    return match[1], match[2]


def _plan(name: str, section: Section, axes: tuple[str, str]) -> CirclePlan:
    centre = section.numbers("centre", length=2) if section.has("centre") else (0.0, 0.0)
    plan = CirclePlan(
        name=name,
        axes=axes,
        radius=section.number("radius_mm", 150.0, above=0.0),
        feed=section.number("feed_mm_min", 1000.0, above=0.0),
        arc=_arc(section),
        runs=section.whole("runs", 1, least=1, most=100),
        first=cast("Literal['ccw', 'cw']", section.choice("first", ["ccw", "cw"], "ccw")),
        sample_rate=(
            section.number("sample_rate_hz", above=0.0) if section.has("sample_rate_hz") else None
        ),
        overshoot=section.number("overshoot_deg", 20.0, least=0.0),
        centre=(centre[0], centre[1]) if centre else (0.0, 0.0),
        calibrated=_flag(section, "calibrated"),
    )
    if plan.overshoot > 360.0:
        section.reject("overshoot_deg", "is more than a turn", "0 to 360")
    if not _SAMPLES[0] <= plan.samples <= _SAMPLES[1]:
        key = "sample_rate_hz" if plan.sample_rate is not None else "arc"
        section.reject(
            key, f"makes {plan.samples} samples in a run", f"{_SAMPLES[0]} to {_SAMPLES[1]} samples"
        )
    return plan


def _flag(section: Section, key: str) -> bool:
    if not section.has(key):
        return True
    value = section.data[key]
    if not isinstance(value, bool):
        section.reject(key, "is neither true nor false", "true or false")
    return value is True


def _arc(section: Section) -> tuple[float, float]:
    arc = section.section("arc")
    if arc is None:
        return 0.0, 360.0
    start, extent = (
        arc.number("start_deg", 0.0, least=-360.0),
        arc.number("extent_deg", 360.0, least=_SMALLEST_ARC),
    )
    for key, value in (("start_deg", start), ("extent_deg", extent)):
        if value > 360.0:
            arc.reject(key, "is more than a turn", "at most 360")
            start, extent = 0.0, 360.0
    arc.close()
    return start, extent


def _check_travel(section: Section, plan: CirclePlan, axes: Mapping[str, Axis]) -> None:
    for name, centre in zip(plan.axes, plan.centre, strict=True):
        axis = axes.get(name)
        if axis is None:
            continue
        if axis.kind is not AxisKind.LINEAR:
            section.reject("plane", f"names {name}, which is a rotary axis", "two linear axes")
        elif axis.travel[0] < axis.travel[1] and not (
            axis.travel[0] <= centre - plan.radius <= centre + plan.radius <= axis.travel[1]
        ):
            span = (
                f"{axis.travel[0]:g} to {axis.travel[1]:g} mm of {name} around the whole circle of"
                f" {plan.radius:g} mm"
            )
            section.reject("centre", "puts the circle outside the travel", span)


def _errors(section: Section, axes: tuple[str, str]) -> CircleErrors:
    offset = section.numbers("offset_um", length=2) if section.has("offset_um") else ()
    first, second = (section.section(name) for name in axes)
    errors = CircleErrors(
        first=_axis(first) if first is not None else CircleAxis(),
        second=_axis(second) if second is not None else CircleAxis(),
        squareness=section.number("squareness_um_per_m", 0.0) * _PPM,
        offset=(offset[0] * _UM, offset[1] * _UM) if offset else (0.0, 0.0),
        radius_change=section.number("radius_change_um", 0.0) * _UM,
        bar=section.number("bar_um", 0.0) * _UM,
        noise=section.number("noise_um", 0.0, least=0.0) * _UM,
        correlated_noise=section.number("correlated_noise_um", 0.0, least=0.0) * _UM,
        correlation=section.number("correlation", 0.0, least=0.0),
    )
    if errors.correlation >= 1.0:
        section.reject(
            "correlation", "is no correlation of neighbouring samples", "at least 0, below 1"
        )
    section.close()
    return errors


def _axis(section: Section) -> CircleAxis:
    cyclic = section.section("cyclic")
    amplitude, pitch, phase = 0.0, 10.0, 0.0
    if cyclic is not None:
        amplitude = cyclic.number("amplitude_um", least=0.0) * _UM
        pitch = cyclic.number("pitch_mm", above=0.0)
        phase = math.radians(cyclic.number("phase_deg", 0.0))
        cyclic.close()
    axis = CircleAxis(
        scale=section.number("scale_um_per_m", 0.0) * _PPM,
        lost_motion=_lost_motion(section),
        lag=section.number("lag_ms", 0.0) / 1000.0,
        gain=section.number("gain_per_s", above=0.0) if section.has("gain_per_s") else None,
        lateral_play=section.number("lateral_play_um", 0.0) * _UM,
        spike=section.number("spike_um", 0.0) * _UM,
        spike_length=section.number("spike_length_mm", 5.0, above=0.0),
        cyclic=amplitude,
        pitch=pitch,
        phase=phase,
        straightness=section.number("straightness_um", 0.0) * _UM,
    )
    section.close()
    return axis


def _lost_motion(section: Section) -> tuple[float, float]:
    """Return the lost motion at the positive and the negative reversal point: one number for both,
    or a list of two.
    """
    if isinstance(section.data.get("lost_motion_um"), list):
        both = section.numbers("lost_motion_um", length=2)
        return (both[0] * _UM, both[1] * _UM) if both else (0.0, 0.0)
    same = section.number("lost_motion_um", 0.0) * _UM
    return same, same
