"""MACHINE.yaml -> virtual machine. The schema with an example is ``docs/simulation.md``."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, Literal, cast

import numpy as np

from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.foundations.units import TO_INSIDE
from compwright.foundations.yaml_reader import read_yaml
from compwright.records.axis import Axis, AxisKind, Direction, Encoder, FloatArray, Motion
from compwright.records.positioning import Cycle
from compwright.simulation.circles import read_circles
from compwright.simulation.curves import FLAT, Curve, PointCurve, RandomCurve
from compwright.simulation.fields import Section
from compwright.simulation.machine import (
    AxisError,
    ScrewError,
    TestPlan,
    VirtualAxis,
    VirtualMachine,
)
from compwright.simulation.scatter import Scatter, Traverses

SCHEMA: Final = 1
# One stream of random numbers for each thing that is random, so that a change of one leaves the
# others as they are.
_SMOOTH, _REVERSAL, _TARGETS = 1, 2, 3
_AXIS_NAME: Final = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,31}")
_TARGET_STEP: Final = 0.001  # mm or deg: targets as they would be programmed
_NO_TRAVEL: Final = (
    0.0,
    0.0,
)  # stands for a travel that was at fault: what depends on it is then not judged
_SHORTEST, _LONGEST = (
    0.002,
    10.0,
)  # length of a random curve in terms of the travel: its sum of waves can show no other


@dataclass(frozen=True, slots=True)
class _Units:
    """Names of the units of an axis in keys, and the factor of a deviation to the inside."""

    position: str
    deviation: str
    slope: str

    @property
    def inside(self) -> float:
        return TO_INSIDE[self.deviation][1]


_UNITS: Final = {
    AxisKind.LINEAR: _Units("mm", "um", "um_per_m"),
    AxisKind.ROTARY: _Units("deg", "arcsec", "arcsec_per_deg"),
}
_SLOPE: Final = {AxisKind.LINEAR: 1e-6, AxisKind.ROTARY: 1.0 / 3600.0}


def read_machine(content: bytes, file: str) -> VirtualMachine:
    """Return the virtual machine that a MACHINE.yaml describes.

    Raises InputError when it is not YAML, and UsageError with every fault at once (file, line, key
    path, expected, found) when it does not follow the schema.
    """
    document = read_yaml(content, file)
    faults: list[Fault] = []
    top = Section(document, file, (), document.data, faults)
    raise_all(UsageError, faults)
    if top.whole("virtual_machine", 0, least=0, most=10**9) != SCHEMA:
        top.reject(
            "virtual_machine", "is not a schema version that this compwright reads", str(SCHEMA)
        )
    name, serial = _identity(top)
    format_id, options = _control(top)
    circles = top.section("circles")
    axes = _axes(top, needed=circles is None)
    measured = (
        read_circles(circles, {name: virtual.axis for name, virtual in axes.items()})
        if circles is not None
        else {}
    )
    if not axes and circles is not None and not circles.data:
        top.reject(
            "circles", "names no circle, and there is no axis", "a mapping of names to circles"
        )
    top.close()
    raise_all(UsageError, faults)
    return VirtualMachine(
        axes=axes, circles=measured, name=name, serial=serial, format=format_id, options=options
    )


def _identity(top: Section) -> tuple[str, str]:
    machine = top.section("machine")
    if machine is None:
        return "", ""
    name, serial = machine.text("name", ""), machine.text("serial", "")
    machine.close()
    return name, serial


def _control(top: Section) -> tuple[str, Mapping[str, object]]:
    control = top.section("controller")
    if control is None:
        return "", {}
    options = control.section("options")
    format_id = control.text("format", "")
    control.close()
    return format_id, dict(options.data) if options is not None else {}


def _axes(top: Section, *, needed: bool) -> dict[str, VirtualAxis]:
    """Return the axes; ``needed`` is false where circles are to be measured, whose axes may go
    without errors of their own.
    """
    axes = top.section("axes")
    if axes is None and not needed:
        return {}
    if axes is None or not axes.data:
        top.reject("axes", "names no axis", "a mapping of axis names to axes")
        return {}
    for name in axes.data:
        if not _AXIS_NAME.fullmatch(name):  # it becomes part of file names
            axes.reject(name, "is not the name of an axis", "a letter, then letters, digits or _")
    if len({name.lower() for name in axes.data}) < len(axes.data):
        top.reject(
            "axes",
            "has names that differ in upper and lower case only",
            "names that make different file names",
        )
    return {
        name: _axis(name, section)
        for name in axes.data
        if (section := axes.section(name)) is not None
    }


def _axis(name: str, section: Section) -> VirtualAxis:
    kind = AxisKind(section.choice("kind", [kind.value for kind in AxisKind], "linear"))
    travel = section.numbers("travel", length=2)
    if travel and travel[0] >= travel[1]:
        section.reject("travel", "does not ascend", "[low, high]")
        travel = ()
    test = section.section("test")
    axis = Axis(
        name=name,
        kind=kind,
        travel=(travel[0], travel[1]) if travel else _NO_TRAVEL,
        address=section.text("address", name),
        modulo=_modulo(section, kind),
        reference=section.number("reference", 0.0),
        reference_return=Direction(section.choice("reference_return", ["+", "-"], "+")),
        encoder=_encoder(section),
        motion=_motion(test),
    )
    error = section.section("error")
    result = VirtualAxis(
        axis=axis,
        error=_error(axis, error) if error is not None else AxisError(),
        test=(
            _test(axis, test)
            if test is not None
            else TestPlan(targets=_spread_targets(axis, _least_targets(axis), 0))
        ),
    )
    section.close()
    return result


def _modulo(section: Section, kind: AxisKind) -> float | None:
    if not section.has("modulo"):
        return None
    if kind is AxisKind.LINEAR:
        section.reject("modulo", "has no meaning on a linear axis", "kind: rotary")
    return section.number("modulo", above=0.0)


def _encoder(section: Section) -> Encoder:
    """Return the measuring system by which the tables act; not said: the control's files decide."""
    given = section.section("encoder")
    if given is None:
        return Encoder(stated=False)
    encoder = Encoder(system=given.whole("system", 1, least=1, most=2))
    given.close()
    return encoder


def _motion(test: Section | None) -> Motion:
    if test is None:
        return "feed"
    return cast("Motion", test.choice("motion", ["feed", "rapid"], "feed"))


def _error(axis: Axis, section: Section) -> AxisError:
    units = _UNITS[axis.kind]
    smooth = section.section("smooth")
    reversal = section.section("reversal")
    mean, variation = _reversal(axis, reversal) if reversal is not None else (0.0, FLAT)
    error = AxisError(
        slope=section.number(f"slope_{units.slope}", 0.0) * _SLOPE[axis.kind],
        smooth=_smooth(axis, smooth) if smooth is not None else FLAT,
        screw=tuple(_screw(axis, entry) for entry in section.sections("screw")),
        reversal=mean,
        reversal_variation=variation,
        scatter=_scatter(axis, section),
        drift=section.number(f"drift_{units.deviation}", 0.0) * units.inside,
        expansion=section.number(f"expansion_{units.slope}", 0.0) * _SLOPE[axis.kind],
    )
    section.close()
    return error


def _scatter(axis: Axis, section: Section) -> Scatter:
    units = _UNITS[axis.kind]
    noise, other = f"noise_{units.deviation}", f"noise_negative_{units.deviation}"
    outliers, traverses = section.section("outliers"), section.section("traverses")
    share, size = _outliers(axis, outliers) if outliers is not None else (0.0, 0.0)
    return Scatter(
        noise=section.number(noise, 0.0, least=0.0) * units.inside,
        noise_negative=(
            section.number(other, least=0.0) * units.inside if section.has(other) else None
        ),
        growth=section.number("growth_of_noise", 1.0, least=0.0),
        tails=section.number("tails_dof", above=0.0) if section.has("tails_dof") else None,
        outlier_share=share,
        outlier_size=size,
        traverses=_traverses(axis, traverses) if traverses is not None else Traverses(),
    )


def _outliers(axis: Axis, section: Section) -> tuple[float, float]:
    units = _UNITS[axis.kind]
    percent = section.number("share_percent", above=0.0)
    if percent > 100.0:
        section.reject("share_percent", "is more than all readings", "at most 100")
    size = section.number(f"size_{units.deviation}", above=0.0) * units.inside
    section.close()
    return percent / 100.0, size


def _traverses(axis: Axis, section: Section) -> Traverses:
    units = _UNITS[axis.kind]
    traverses = Traverses(
        offset=section.number(f"offset_{units.deviation}", 0.0, least=0.0) * units.inside,
        slope=section.number(f"slope_{units.slope}", 0.0, least=0.0) * _SLOPE[axis.kind],
        walk=section.number(f"walk_{units.deviation}", 0.0, least=0.0) * units.inside,
    )
    section.close()
    return traverses


def _smooth(axis: Axis, section: Section) -> Curve:
    units = _UNITS[axis.kind]
    positions, values = f"positions_{units.position}", f"deviations_{units.deviation}"
    curve: Curve
    if section.has(positions) or section.has(values):
        where = section.numbers(positions)
        what = section.numbers(values)
        if where and what and len(where) != len(what):
            section.reject(values, "has not one value for each position", f"{len(where)} numbers")
        if any(later <= earlier for earlier, later in pairwise(where)):
            section.reject(positions, "do not ascend", "positions in ascending order, each once")
        curve = PointCurve(where, tuple(value * units.inside for value in what))
    else:
        curve = _random_curve(axis, section, f"amplitude_{units.deviation}", _SMOOTH)
    section.close()
    return curve


def _random_curve(
    axis: Axis, section: Section, amplitude: str, stream: int, default: float | None = None
) -> Curve:
    units = _UNITS[axis.kind]
    span = axis.travel[1] - axis.travel[0]
    key = f"length_{units.position}"
    length = section.number(key, 0.25 * span, above=0.0)
    if span and section.has(key) and not _SHORTEST * span <= length <= _LONGEST * span:
        section.reject(
            key,
            "does not fit the travel",
            f"{_SHORTEST * span:g} to {_LONGEST * span:g} {units.position}",
        )
    return RandomCurve(
        amplitude=section.number(amplitude, default, least=0.0) * units.inside,
        length=length,
        seed=_seed(axis, section, stream),
        travel=axis.travel,
    )


def _seed(axis: Axis, section: Section, stream: int) -> tuple[int, ...]:
    # The axis' name is part of it, so that two axes of one description do not get the same curve.
    return (
        section.whole("seed", 0, least=0, most=2**31 - 1),
        stream,
        *axis.name.encode("utf-8", "replace"),
    )


def _screw(axis: Axis, section: Section) -> ScrewError:
    units = _UNITS[axis.kind]
    screw = ScrewError(
        period=section.number(f"period_{units.position}", above=0.0),
        amplitude=section.number(f"amplitude_{units.deviation}") * units.inside,
        phase=math.radians(section.number("phase_deg", 0.0)),
    )
    section.close()
    return screw


def _reversal(axis: Axis, section: Section) -> tuple[float, Curve]:
    units = _UNITS[axis.kind]
    mean = section.number(f"mean_{units.deviation}", 0.0) * units.inside
    curve = _random_curve(axis, section, f"varies_{units.deviation}", _REVERSAL, 0.0)
    section.close()
    return mean, curve


def _test(axis: Axis, section: Section) -> TestPlan:
    units = _UNITS[axis.kind]
    seed = section.whole("seed", 0, least=0, most=2**31 - 1)
    plan = TestPlan(
        targets=_targets(axis, section, seed),
        runs=section.whole("runs", 5, least=1, most=1000),
        cycle=cast("Cycle", section.choice("cycle", ["standard", "step"], "standard")),
        directions=cast(
            "Literal['both', '+', '-']", section.choice("directions", ["both", "+", "-"], "both")
        ),
        datum=section.number(f"datum_{units.deviation}", 0.0) * units.inside,
        resolution=section.number(f"resolution_{units.deviation}", 0.0, least=0.0) * units.inside,
    )
    section.close()
    return plan


def _targets(axis: Axis, section: Section, seed: int) -> FloatArray:
    if isinstance(section.data.get("targets"), list):
        given = section.numbers("targets", at_least=2)
        if any(later <= earlier for earlier, later in pairwise(given)):
            section.reject("targets", "do not ascend", "positions in ascending order, each once")
        if (
            given
            and axis.travel != _NO_TRAVEL
            and not axis.travel[0] <= min(given) <= max(given) <= axis.travel[1]
        ):
            section.reject(
                "targets",
                "leave the travel",
                f"{axis.travel[0]:g} to {axis.travel[1]:g} {axis.kind.unit}",
            )
        return np.array(given)
    count = section.whole("targets", _least_targets(axis), least=2, most=10_000)
    return _spread_targets(axis, count, seed)


def _least_targets(axis: Axis) -> int:
    """Return the smallest number of targets of ISO 230-2:1997: 4.3.2, 4.3.3 (linear axes), table 1
    and 4.3.5 (rotary axes).
    """
    span = axis.travel[1] - axis.travel[0]
    if axis.kind is AxisKind.LINEAR:
        return max(5, math.ceil(span / (200.0 if span <= 2000.0 else 250.0)))
    if span <= 360.0:
        return 3 if span <= 90.0 else 5 if span <= 180.0 else 8
    return math.ceil(span / 45.0) + 1


def _spread_targets(axis: Axis, count: int, seed: int) -> FloatArray:
    """Return ``count`` targets P_i = (i - 1) p + r (ISO 230-2 clause 4.2), r random within ±0.3 p,
    to 0.001 mm or deg.

    They keep a margin of 1 % of the travel from its ends, room to come from either side. The outer
    targets are moved inward only.
    """
    low, high = axis.travel
    margin = 0.01 * (high - low)
    step = (high - low - 2.0 * margin) / (count - 1)
    r = (
        np.random.default_rng((seed, _TARGETS, *axis.name.encode("utf-8", "replace"))).uniform(
            -0.3, 0.3, count
        )
        * step
    )
    r[0], r[-1] = abs(r[0]), -abs(r[-1])
    exact = low + margin + np.arange(count) * step + r
    programmed = np.round(exact / _TARGET_STEP) * _TARGET_STEP
    # On a travel of a few hundredths the rounding could make two targets one.
    targets: FloatArray = programmed if np.all(np.diff(programmed) > 0.0) else exact
    return targets
