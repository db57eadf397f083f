"""A MACHINE.yaml, read as a virtual machine (schema and example: ``docs/simulation.md``)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from types import MappingProxyType
from typing import Any, Final, cast

import numpy as np
from pydantic_core import SchemaValidator
from pydantic_core import core_schema as cs

from compwright.foundations.errors import UsageError, raise_all
from compwright.foundations.key_faults import KeyFault, KeyPath, shown
from compwright.foundations.units import TO_INSIDE
from compwright.foundations.validation import checked
from compwright.foundations.yaml_reader import read_yaml
from compwright.records.axis import Axis, AxisKind, Direction, Encoder, FloatArray, Motion
from compwright.simulation.circles import VirtualCircle, circle_contradictions, circles_schema
from compwright.simulation.curves import FLAT, DeviationCurve, PointCurve, RandomCurve
from compwright.simulation.machine import (
    AxisError,
    ScrewError,
    TestPlan,
    VirtualAxis,
    VirtualMachine,
)
from compwright.simulation.scatter import SimulatedScatter, TraverseShifts
from compwright.simulation.values import (
    TEXT,
    Keys,
    choice,
    either,
    number,
    numbers,
    part,
    record,
    same_but_for_case,
    scaled,
    usable,
    whole,
)

SCHEMA: Final = 1
# One stream of random numbers for each thing that is random, so that a change of one leaves the
# others as they are.
_SMOOTH, _REVERSAL, _TARGETS = 1, 2, 3
_AXIS_NAME: Final = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,31}")
_TARGET_STEP: Final = 0.001  # mm or deg: targets as they would be programmed
#: Travel of an axis whose own is at fault: what depends on it is then not judged.
_NO_TRAVEL: Final = (0.0, 0.0)
_UNKNOWN: Final = {"kind": AxisKind.LINEAR, "travel": _NO_TRAVEL}
_SHORTEST, _LONGEST = (
    0.002,
    10.0,
)  # length of a random curve in terms of the travel: its sum of waves can show no other


@dataclass(frozen=True, slots=True)
class _Units:
    """The names of the units in the keys of an axis (such as mm and um), and the factor from a
    deviation in the file to mm or deg.
    """

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
_SEED: Final = whole(0, 2**31 - 1)
_DIRECTION: Final = cs.no_info_after_validator_function(Direction, choice("+", "-"))
_VERSION: Final[Keys] = {"virtual_machine": ("version", whole(0, 10**9))}
#: What everything else of an axis depends on.
_AXIS: Final[Keys] = {
    "kind": (
        "kind",
        cs.no_info_after_validator_function(AxisKind, choice(*(kind.value for kind in AxisKind))),
    ),
    "travel": ("travel", numbers(length=2, ascending=True)),
}


def read_machine(content: bytes, file: str) -> VirtualMachine:
    """Return the virtual machine that a MACHINE.yaml describes.

    Raises InputError if the file is not YAML. Raises UsageError with every fault at once (file,
    line, key path, expected, found) if it does not follow the schema.
    """
    document = read_yaml(content, file)
    data = document.data
    axes = {
        name: Axis(name=name, address=name, **{**_UNKNOWN, **usable(_AXIS, each)})
        for name, each in part(data, "axes").items()
    }
    machine, faults = checked(SchemaValidator(_machine(data, axes)), data)
    if isinstance(data, dict):
        faults += _contradictions(data, axes)
    raise_all(UsageError, document.faults(faults, file))
    return cast("VirtualMachine", machine)


def _machine(data: Any, axes: Mapping[str, Axis]) -> cs.CoreSchema:
    """Return the schema of a MACHINE.yaml. ``axes``: the axes of the file, each with those
    properties that were read in advance.
    """
    names = {"name": ("name", TEXT), "serial": ("serial", TEXT)}
    control = {"format": ("format", TEXT), "options": ("options", cs.dict_schema(strict=True))}
    each = {name: (name, _axis(axis)) for name, axis in axes.items()}

    def built(
        axes: Mapping[str, VirtualAxis] | None = None,
        circles: Mapping[str, VirtualCircle] | None = None,
        machine: Mapping[str, Any] | None = None,
        controller: Mapping[str, Any] | None = None,
        **_version: int,
    ) -> VirtualMachine:
        return VirtualMachine(
            axes=axes or {}, circles=circles or {}, **(machine or {}), **(controller or {})
        )

    return record(
        built,
        {
            **_VERSION,
            "machine": ("machine", record(dict, names)),
            "controller": ("controller", record(dict, control)),
            "axes": ("axes", record(dict, each, each)),
            "circles": ("circles", circles_schema(part(data, "circles"))),
        },
    )


def _contradictions(data: Mapping[str, Any], axes: Mapping[str, Axis]) -> Iterator[KeyFault]:
    """Yield the faults of an unknown schema version, of invalid names, and of values that
    contradict each other within a section.
    """
    if usable(_VERSION, data).get("version") != SCHEMA:
        expected, found = str(SCHEMA), shown(data.get("virtual_machine"))
        message = "is not a schema version that this compwright reads"
        yield KeyFault(("virtual_machine",), message, expected, found)
    if not axes and ("axes" in data or "circles" not in data):
        yield KeyFault(("axes",), "names no axis", "a mapping of axis names to axes")
    if not axes and "circles" in data and not part(data, "circles"):
        expected = "a mapping of names to circles"
        yield KeyFault(("circles",), "names no circle, and there is no axis", expected)
    for name in axes:
        if not _AXIS_NAME.fullmatch(name):  # it becomes part of file names
            expected = "a letter, then letters, digits or _"
            yield KeyFault(("axes", name), "is not the name of an axis", expected, shown(name))
    yield from same_but_for_case(("axes",), axes)
    for name, axis in axes.items():
        own = part(data, "axes", name)
        if "modulo" in own and axis.kind is AxisKind.LINEAR:
            message = "has no meaning on a linear axis"
            yield KeyFault(("axes", name, "modulo"), message, "kind: rotary", shown(own["modulo"]))
        yield from _targets_within(("axes", name, "test", "targets"), axis, own)
        smooth, reversal = (part(own, "error", name) for name in ("smooth", "reversal"))
        path = ("axes", name, "error")
        if smooth.keys() & _points(axis).keys():
            yield from _odd_points((*path, "smooth"), axis, smooth)
        else:
            yield from _odd_length((*path, "smooth"), axis, smooth)
        yield from _odd_length((*path, "reversal"), axis, reversal)
    yield from circle_contradictions(part(data, "circles"), axes)


def _targets_within(path: KeyPath, axis: Axis, own: Mapping[str, Any]) -> Iterator[KeyFault]:
    targets = usable({"targets": ("targets", numbers(at_least=2))}, part(own, "test"))
    given: tuple[float, ...] = targets.get("targets", ())
    yield from _unordered(path, given)
    low, high = axis.travel
    if given and axis.travel != _NO_TRAVEL and not low <= min(given) <= max(given) <= high:
        expected = f"{low:g} to {high:g} {axis.kind.unit}"
        yield KeyFault(path, "leave the travel", expected)


def _odd_points(path: KeyPath, axis: Axis, data: Mapping[str, Any]) -> Iterator[KeyFault]:
    keys = _points(axis)
    given = usable(keys, data)
    where, what = given.get("positions", ()), given.get("values", ())
    positions, values = keys
    if where and what and len(where) != len(what):
        message, expected = "has not one value for each position", f"{len(where)} numbers"
        yield KeyFault((*path, values), message, expected, shown(data[values]))
    yield from _unordered((*path, positions), where)


def _odd_length(path: KeyPath, axis: Axis, data: Mapping[str, Any]) -> Iterator[KeyFault]:
    units, span = _UNITS[axis.kind], axis.travel[1] - axis.travel[0]
    key = f"length_{units.position}"
    length = usable({key: ("length", number(above=0.0))}, data).get("length", span)
    low, high = _SHORTEST * span, _LONGEST * span
    if span and not low <= length <= high:
        expected = f"{low:g} to {high:g} {units.position}"
        yield KeyFault((*path, key), "does not fit the travel", expected, shown(length))


def _unordered(path: KeyPath, given: Sequence[float]) -> Iterator[KeyFault]:
    if any(later <= earlier for earlier, later in pairwise(given)):
        yield KeyFault(path, "do not ascend", "positions in ascending order, each once")


def _axis(axis: Axis) -> cs.CoreSchema:
    def built(
        error: AxisError | None = None,
        test: tuple[TestPlan, Motion] | None = None,
        encoder: Encoder | None = None,
        **own: Any,
    ) -> VirtualAxis:
        """Return the virtual axis. Without ``encoder`` its measuring system is marked as not
        stated, and the control's files decide.
        """
        plan, motion = test or (
            TestPlan(targets=_spread_targets(axis, _least_targets(axis), 0)),
            "feed",
        )
        own["encoder"] = encoder or Encoder(stated=False)
        return VirtualAxis(
            axis=replace(axis, motion=motion, **own), error=error or AxisError(), test=plan
        )

    keys = {
        **_AXIS,
        "address": ("address", TEXT),
        "modulo": ("modulo", number(above=0.0)),
        "reference": ("reference", number()),
        "reference_return": ("reference_return", _DIRECTION),
        "encoder": ("encoder", record(Encoder, {"system": ("system", whole(1, 2))})),
        "error": ("error", _error(axis)),
        "test": ("test", _test(axis)),
    }
    return record(built, keys, {"travel"})


def _error(axis: Axis) -> cs.CoreSchema:
    units, slope = _UNITS[axis.kind], _SLOPE[axis.kind]
    outliers = {
        "share_percent": ("share", number(lambda percent: percent / 100.0, above=0.0, most=100.0)),
        f"size_{units.deviation}": ("size", scaled(units.inside, above=0.0)),
    }
    traverses = {
        f"offset_{units.deviation}": ("offset", scaled(units.inside, least=0.0)),
        f"slope_{units.slope}": ("slope", scaled(slope, least=0.0)),
        f"walk_{units.deviation}": ("walk", scaled(units.inside, least=0.0)),
    }
    screw = {
        f"period_{units.position}": ("period", number(above=0.0)),
        f"amplitude_{units.deviation}": ("amplitude", scaled(units.inside)),
        "phase_deg": ("phase", number(math.radians)),
    }
    screws = cs.list_schema(record(ScrewError, screw, [*screw][:2]), strict=True)
    keys = {
        f"slope_{units.slope}": ("slope", scaled(slope)),
        "smooth": ("smooth", _smooth(axis)),
        "screw": ("screw", screws),
        "reversal": ("reversal", _reversal(axis)),
        f"drift_{units.deviation}": ("drift", scaled(units.inside)),
        f"expansion_{units.slope}": ("expansion", scaled(slope)),
        f"noise_{units.deviation}": ("noise", scaled(units.inside, least=0.0)),
        f"noise_negative_{units.deviation}": ("noise_negative", scaled(units.inside, least=0.0)),
        "growth_of_noise": ("growth", number(least=0.0)),
        "tails_dof": ("tails", number(above=0.0)),
        "outliers": ("outliers", record(dict, outliers, outliers)),
        "traverses": ("traverses", record(TraverseShifts, traverses)),
    }
    return record(_axis_error, keys)


def _axis_error(
    slope: float = 0.0,
    smooth: DeviationCurve = FLAT,
    screw: Sequence[ScrewError] = (),
    reversal: tuple[float, DeviationCurve] = (0.0, FLAT),
    drift: float = 0.0,
    expansion: float = 0.0,
    outliers: Mapping[str, float] = MappingProxyType({"share": 0.0, "size": 0.0}),
    **scatter: Any,
) -> AxisError:
    return AxisError(
        slope=slope,
        smooth=smooth,
        screw=tuple(screw),
        reversal=reversal[0],
        reversal_variation=reversal[1],
        scatter=SimulatedScatter(
            outlier_share=outliers["share"], outlier_size=outliers["size"], **scatter
        ),
        drift=drift,
        expansion=expansion,
    )


def _points(axis: Axis) -> Keys:
    """Return the schema keys of an error curve through given points: the positions of the points,
    and the deviation at each.
    """
    units = _UNITS[axis.kind]
    return {
        f"positions_{units.position}": ("positions", numbers()),
        f"deviations_{units.deviation}": ("values", numbers(units.inside)),
    }


def _smooth(axis: Axis) -> cs.CoreSchema:
    points = _points(axis)
    amplitude = f"amplitude_{_UNITS[axis.kind].deviation}"
    curve = partial(_random_curve, axis, _SMOOTH)
    return cs.tagged_union_schema(
        {
            "points": record(PointCurve, points, points),
            "random": record(curve, _random(axis, amplitude), {amplitude}),
        },
        lambda data: "points" if part(data).keys() & points.keys() else "random",
    )


def _random(axis: Axis, amplitude: str) -> Keys:
    units = _UNITS[axis.kind]
    return {
        amplitude: ("amplitude", scaled(units.inside, least=0.0)),
        f"length_{units.position}": ("length", number(above=0.0)),
        "seed": ("seed", _SEED),
    }


def _random_curve(
    axis: Axis, stream: int, amplitude: float = 0.0, length: float | None = None, seed: int = 0
) -> RandomCurve:
    """Return the random error curve of an axis. Its seed contains the axis name and the number
    ``stream`` of the kind of curve, so that no two curves are equal.
    """
    return RandomCurve(
        amplitude=amplitude,
        length=0.25 * (axis.travel[1] - axis.travel[0]) if length is None else length,
        seed=(seed, stream, *axis.name.encode("utf-8", "replace")),
        travel=axis.travel,
    )


def _reversal(axis: Axis) -> cs.CoreSchema:
    units = _UNITS[axis.kind]

    def built(mean: float = 0.0, **curve: Any) -> tuple[float, DeviationCurve]:
        return mean, _random_curve(axis, _REVERSAL, **curve)

    mean = {f"mean_{units.deviation}": ("mean", scaled(units.inside))}
    return record(built, mean | dict(_random(axis, f"varies_{units.deviation}")))


def _test(axis: Axis) -> cs.CoreSchema:
    units = _UNITS[axis.kind]

    def built(
        targets: int | tuple[float, ...] = _least_targets(axis),
        seed: int = 0,
        motion: Motion = "feed",
        **plan: Any,
    ) -> tuple[TestPlan, Motion]:
        where = (
            _spread_targets(axis, targets, seed) if isinstance(targets, int) else np.array(targets)
        )
        return TestPlan(targets=where, **plan), motion

    keys = {
        "targets": ("targets", either(whole(2, 10_000), numbers(at_least=2))),
        "seed": ("seed", _SEED),
        "motion": ("motion", choice("feed", "rapid")),
        "runs": ("runs", whole(1, 1000)),
        "cycle": ("cycle", choice("standard", "step")),
        "directions": ("directions", choice("both", "+", "-")),
        f"datum_{units.deviation}": ("datum", scaled(units.inside)),
        f"resolution_{units.deviation}": ("resolution", scaled(units.inside, least=0.0)),
    }
    return record(built, keys)


def _least_targets(axis: Axis) -> int:
    """Return the smallest number of targets that ISO 230-2:1997 requires: by 4.3.2 and 4.3.3 for
    linear axes, by table 1 and 4.3.5 for rotary axes.
    """
    span = axis.travel[1] - axis.travel[0]
    if axis.kind is AxisKind.LINEAR:
        return max(5, math.ceil(span / (200.0 if span <= 2000.0 else 250.0)))
    if span <= 360.0:
        return 3 if span <= 90.0 else 5 if span <= 180.0 else 8
    return math.ceil(span / 45.0) + 1


def _spread_targets(axis: Axis, count: int, seed: int) -> FloatArray:
    """Return ``count`` targets at a regular interval p, each shifted by a random amount within ±0.3
    p (ISO 230-2, 4.2) and rounded to 0.001 mm or deg.

    They keep a distance of 1 % of the travel from its ends, so that they can be approached from
    both sides. The first and the last target are shifted inward only.
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
