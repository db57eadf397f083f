"""That a plan which was read holds what its records promise: types, finite numbers, sizes, order.

A plan may have been edited, or cut and pasted, before it comes back; a record that breaks its word
would end as a fault of compwright's own somewhere later, or, worse, as a table.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, Encoder
from compwright.records.circular import CircularRun, CircularTest
from compwright.records.correction import AxisCompensation, ControlFile, CrossCompensation
from compwright.records.estimate import ErrorEstimate, WantedCorrection
from compwright.records.fitted import TableRequest
from compwright.records.plan import PlannedAxis, PlannedTest
from compwright.records.positioning import PositioningTest

#: No position, correction or feed of a machine tool is larger, mm, deg, mm/min.
LARGEST = 1e9
_PLAIN: Mapping[Any, str] = {
    str: "text",
    bool: "true or false",
    int: "a whole number",
    bytes: "bytes",
    type(None): "null",
}


def plan_faults(plan: Any) -> list[Fault]:
    """Return what is wrong in a plan, each with its key path; empty when all is as the records
    say.
    """
    return list(_record(plan, ""))


def _record(record: Any, place: str) -> Iterator[Fault]:
    cls: Any = type(record)
    found = [
        fault
        for name, hint in _hints(cls).items()
        for fault in _value(getattr(record, name), hint, f"{place}.{name}".lstrip("."))
    ]
    yield from found
    if not found:
        for expected in _broken_rules(record):
            yield Fault(message="contradicts itself", place=place, expected=expected)


@cache
def _hints(cls: Any) -> Mapping[str, Any]:
    hints = get_type_hints(cls)
    return {field.name: hints[field.name] for field in fields(cls)}


def _value(value: Any, hint: Any, place: str) -> Iterator[Fault]:
    origin = get_origin(hint)
    if origin is Literal:
        if not any(
            value is option or (isinstance(value, str) and value == option)
            for option in get_args(hint)
        ):
            yield _wrong(place, " or ".join(map(repr, get_args(hint))), value)
    elif origin in {Union, types.UnionType}:
        options = [
            list(_value(value, option, place))
            for option in get_args(hint)
            if value is None or option is not type(None)
        ]
        if all(options):
            yield from options[0]
    elif origin is np.ndarray:
        if not isinstance(value, np.ndarray) or value.ndim == 0 or np.any(np.abs(value) > LARGEST):
            yield _wrong(place, f"a list of numbers, none larger than {LARGEST:g}", value)
    elif origin is tuple:
        yield from _items(value, get_args(hint), place)
    elif origin is not None:  # a mapping; what is in options is checked by the control's definition
        yield from _mapping(value, get_args(hint)[1], place)
    elif isinstance(hint, type) and is_dataclass(hint):
        yield from (
            _record(value, place)
            if isinstance(value, hint)
            else [_wrong(place, "keys with values", value)]
        )
    else:
        yield from _single(value, hint, place)


def _items(value: Any, hints: tuple[Any, ...], place: str) -> Iterator[Fault]:
    if not isinstance(value, tuple) or (hints[-1] is not Ellipsis and len(value) != len(hints)):
        yield _wrong(place, "a list", value)
        return
    for index, item in enumerate(value):
        yield from _value(
            item, hints[0] if hints[-1] is Ellipsis else hints[index], f"{place}[{index}]"
        )


def _mapping(value: Any, hint: Any, place: str) -> Iterator[Fault]:
    if not isinstance(value, Mapping):
        yield _wrong(place, "keys with values", value)
        return
    for key, item in value.items():
        if hint is not object:
            yield from _value(item, hint, f"{place}.{key}")


def _single(value: Any, hint: Any, place: str) -> Iterator[Fault]:
    if hint is float:
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not number or not abs(value) <= LARGEST:
            yield _wrong(place, f"a number, not larger than {LARGEST:g}", value)
    elif isinstance(hint, type) and issubclass(hint, Enum):
        if not isinstance(value, hint):
            yield _wrong(place, " or ".join(repr(member.value) for member in hint), value)
    elif hint in _PLAIN and (
        not isinstance(value, hint) or (hint is int and isinstance(value, bool))
    ):
        yield _wrong(place, _PLAIN[hint], value)


def _wrong(place: str, expected: str, value: Any) -> Fault:
    return Fault(
        message="does not fit the schema of plans",
        place=place,
        expected=expected,
        found=repr(value),
    )


def _broken_rules(record: Any) -> Iterator[str]:
    """Yield what a record promises beyond the types of its fields and does not keep."""
    rules = _RULES_OF.get(type(record))
    return iter(()) if rules is None else rules(record)


def _axis(axis: Axis) -> Iterator[str]:
    return _rules(
        (axis.travel[0] < axis.travel[1], "a travel from a lower to a higher position"),
        (axis.modulo is None or axis.modulo > 0, "a modulo above 0"),
        (all(period > 0 for period in axis.screw_pitch), "periods above 0"),
    )


def _table(table: AxisCompensation | CrossCompensation) -> Iterator[str]:
    yield from _curves(table.positions, table.positive, table.negative)
    yield from _rules((table.period is None or table.period > 0, "a period above 0"))


def _wanted(wanted: WantedCorrection) -> Iterator[str]:
    yield from _curves(wanted.positions, wanted.positive, wanted.negative, least=2)
    yield from _rules(
        (wanted.noise >= 0, "noise of at least 0"),
        (all(p > 0 for p in wanted.periods), "periods above 0"),
    )


def _estimate(estimate: ErrorEstimate) -> Iterator[str]:
    curves = (
        estimate.mean_positive,
        estimate.mean_negative,
        estimate.std_positive,
        estimate.std_negative,
    )
    yield from _curves(estimate.positions, *curves, least=2)
    yield from _rules(
        (
            all(one.period > 0 and 0 <= one.probability <= 1 for one in estimate.periods),
            "periods above 0 with probabilities",
        ),
        (estimate.noise > 0 and estimate.noise_dof > 0, "noise and its degrees of freedom above 0"),
    )


def _file(file: ControlFile) -> Iterator[str]:
    plain = bool(file.name) and file.name not in {".", ".."} and not set(file.name) & set("/\\\0")
    return _rules((plain, "the name of a file, without folders"))


def _circle_run(run: CircularRun) -> Iterator[str]:
    same = run.angles.ndim == 1 and run.angles.shape == run.deviations.shape and run.angles.size > 1
    finite = same and bool(np.isfinite(run.angles).all() and np.isfinite(run.deviations).all())
    return _rules((finite, "as many angles as deviations, all of them numbers"))


def _circle(test: CircularTest) -> Iterator[str]:
    return _rules(
        (test.nominal_radius > 0 and test.feed > 0, "a radius and a feed above 0"),
        (0 < test.arc[1] <= 360, "an arc of more than 0 and at most 360 deg"),
        (bool(test.runs), "at least one run"),
    )


def _rules(*rules: tuple[bool, str]) -> Iterator[str]:
    return (expected for holds, expected in rules if not holds)


def _curves(
    positions: np.ndarray[Any, Any], *curves: np.ndarray[Any, Any], least: int = 0
) -> Iterator[str]:
    same = (
        positions.ndim == 1
        and positions.size >= least
        and all(curve.shape == positions.shape for curve in curves)
    )
    numbers = same and all(bool(np.isfinite(values).all()) for values in (positions, *curves))
    if not numbers or not bool(np.all(np.diff(positions) > 0)):
        yield "ascending positions and one number for each in every curve"


def _readings(test: PositioningTest) -> Iterator[str]:
    count = test.targets.size
    whole = (
        test.targets.ndim == 1
        and count > 0
        and bool(np.isfinite(test.targets).all() and np.all(np.diff(test.targets) > 0))
    )
    yield from _rules((whole, "ascending targets"))
    for block, runs in ((test.positive, test.runs_positive), (test.negative, test.runs_negative)):
        fits = block.ndim == 2 and block.shape[0] == count and len(runs) in {0, block.shape[1]}
        yield from _rules((fits, "one row of readings for each target, and a number for each run"))
    made = test.positive.ndim == test.negative.ndim == 2 and any(
        np.isfinite(side).any() for side in (test.positive, test.negative)
    )
    yield from _rules((bool(made), "readings"))


def _acted(planned: PlannedTest) -> Iterator[str]:
    """What acted is told for every target, or not at all."""
    fits = planned.acted is None or all(
        side.shape == planned.test.targets.shape and bool(np.isfinite(side).all())
        for side in planned.acted
    )
    yield from _rules((fits, "what acted at each target in both directions"))


def _one_kind(axis: PlannedAxis) -> Iterator[str]:
    """Everything of an axis is in the one unit of its kind."""
    compensations = [axis.active, None if axis.fitted is None else axis.fitted.compensation]
    kinds = {axis.axis.kind, axis.estimate.kind, *(planned.test.kind for planned in axis.tests)}
    kinds |= {entry.kind for entry in (*compensations, axis.wanted) if entry is not None}
    yield from _rules((len(kinds) == 1, "one kind of axis throughout"))


_RULES_OF: Mapping[type, Callable[[Any], Iterator[str]]] = {
    Axis: _axis,
    Encoder: lambda encoder: _rules((encoder.system in {1, 2}, "measuring system 1 or 2")),
    AxisCompensation: _table,
    CrossCompensation: _table,
    WantedCorrection: _wanted,
    PlannedTest: _acted,
    ErrorEstimate: _estimate,
    PositioningTest: _readings,
    TableRequest: lambda request: _rules(
        (
            request.named_spacing is None or request.named_spacing > 0,
            "a spacing above 0",
        )
    ),
    PlannedAxis: _one_kind,
    ControlFile: _file,
    CircularRun: _circle_run,
    CircularTest: _circle,
}
