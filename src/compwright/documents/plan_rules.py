"""Rules for the parts of a plan that types cannot express, such as order and matching names.

A user may have edited a plan before it is read again. A plan that violates a rule would later cause
an internal error or, worse, a wrong table.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, Final

import numpy as np

from compwright.foundations.key_faults import KeyFault, KeyPath
from compwright.foundations.plain_names import PLAIN_NAME, is_plain_name
from compwright.foundations.provenance import fingerprint
from compwright.records.axis import Axis, Encoder
from compwright.records.circular import CircularRun, CircularTest
from compwright.records.correction import AxisCompensation, ControlFile, CrossCompensation
from compwright.records.estimate import AxisPeriod, ErrorEstimate, Scenarios, WantedCorrection
from compwright.records.fitted_table import TableRequest
from compwright.records.job import AS_FOUND
from compwright.records.plan import Plan, PlannedAxis, PlannedTest
from compwright.records.positioning import PositioningTest


def contradictions(plan: Plan) -> Iterator[KeyFault]:
    """Yield a fault with its key path for each contradiction between parts of a plan."""
    yield from _names(plan)
    yield from _between(plan)
    yield from _copies(plan)


def _names(plan: Plan) -> Iterator[KeyFault]:
    """Yield a fault for each entry whose ``name`` differs from its key, and for each state whose
    name cannot be a file name.
    """
    for name, entry in plan.axes.items():
        yield from _other(("axes", name, "axis", "name"), name, entry.axis.name)
    for name, axis in plan.untested.items():
        yield from _other(("untested", name, "name"), name, axis.name)
    for name, circle in plan.circles.items():
        yield from _other(("circles", name, "test", "name"), name, circle.test.name)
    for name in plan.states:
        if not is_plain_name(name):
            yield _fault(("states", name), PLAIN_NAME, name)


def _other(path: KeyPath, name: str, own: str) -> Iterator[KeyFault]:
    if own != name:
        yield _fault(path, name, own)


def _between(plan: Plan) -> Iterator[KeyFault]:
    axes = {*plan.axes, *plan.untested}
    for index, entry in enumerate(plan.cross):
        for key, name in (("input", entry.input), ("output", entry.output)):
            if name not in axes:
                yield _fault(("cross", index, key), f"an axis of the plan: {_list(axes)}", name)
    for name in plan.active:
        if name not in plan.states:
            yield _fault(("active", name), f"a state of the plan: {_list(plan.states)}", name)
    for name, axis in plan.axes.items():
        tests = [planned.test.name for planned in axis.tests]
        if axis.accept is not None and axis.accept.test not in (None, *tests):
            expected = f"a test of the axis: {_list(tests)}"
            yield _fault(("axes", name, "accept", "test"), expected, str(axis.accept.test))


def _copies(plan: Plan) -> Iterator[KeyFault]:
    """Yield a fault for each copied control file whose SHA-256 differs from that of the file in
    ``rollback/``.
    """
    for index, file in enumerate(plan.states.get(AS_FOUND, ())):
        listed = plan.results.get(f"rollback/{plan.format}/{file.name}")
        found = fingerprint(file.content)
        if listed is not None and listed != found:
            path = ("states", AS_FOUND, index, "base64")
            yield _fault(path, f"bytes with the SHA-256 {listed} (results)", found)


def _fault(path: KeyPath, expected: str, found: str) -> KeyFault:
    return KeyFault(path, "contradicts the rest of the plan", expected, ascii(found))


def _list(names: Any) -> str:
    return ", ".join(sorted(names)) or "none"


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
        (estimate.noise > 0 and estimate.noise_dof > 0, "noise and its degrees of freedom above 0"),
    )


def _scenarios(tests: Scenarios) -> Iterator[str]:
    """Check the array sizes of simulated tests; yield, for each violated rule, a text on what is
    expected.
    """
    size = tests.positions.size
    sides = ((tests.positive, tests.half_positive), (tests.negative, tests.half_negative))
    whole = tests.count > 0 and size > 0 and size % tests.count == 0
    same = all(mean.shape == half.shape and mean.size in {0, size} for mean, half in sides)
    yield from _rules(
        (whole, "a count above 0 and as many targets in every test"),
        (same, "one number for each target in each direction that was measured, or none"),
        (any(mean.size for mean, _ in sides), "a direction that was measured"),
    )


def _circle_run(run: CircularRun) -> Iterator[str]:
    same = run.angles.ndim == 1 and run.angles.shape == run.deviations.shape and run.angles.size > 1
    finite = same and bool(np.isfinite(run.angles).all() and np.isfinite(run.deviations).all())
    return _rules((finite, "as many angles as deviations, all of them numbers"))


def _all(*promises: tuple[Callable[[Any], bool], str]) -> Callable[[Any], Iterator[str]]:
    return lambda record: (expected for holds, expected in promises if not holds(record))


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


def _active(planned: PlannedTest) -> Iterator[str]:
    """Yield a text on what is expected if a test lacks the correction that was active at one of its
    targets.
    """
    fits = planned.acted is None or all(
        side.shape == planned.test.targets.shape and bool(np.isfinite(side).all())
        for side in planned.acted
    )
    yield from _rules((fits, "the correction that was active at each target in both directions"))


def _one_kind(axis: PlannedAxis) -> Iterator[str]:
    """Yield a text on what is expected if parts of an axis disagree about its kind (linear or
    rotary).
    """
    compensations = [axis.active, None if axis.fitted is None else axis.fitted.compensation]
    kinds = {axis.axis.kind, axis.estimate.kind, *(planned.test.kind for planned in axis.tests)}
    kinds |= {entry.kind for entry in (*compensations, axis.wanted) if entry is not None}
    yield from _rules((len(kinds) == 1, "one kind of axis throughout"))


#: By class of a record.
RULES: Final[Mapping[type, Callable[[Any], Iterator[str]]]] = {
    Axis: _all(
        (
            lambda axis: axis.travel[0] < axis.travel[1],
            "a travel from a lower to a higher position",
        ),
        (lambda axis: axis.modulo is None or axis.modulo > 0, "a modulo above 0"),
        (
            lambda axis: all(
                period is None or period > 0
                for period in (*axis.screw_pitch, axis.suggested_period)
            ),
            "periods above 0",
        ),
    ),
    Encoder: _all((lambda encoder: encoder.system in {1, 2}, "measuring system 1 or 2")),
    AxisCompensation: _table,
    CrossCompensation: _table,
    WantedCorrection: _wanted,
    PlannedTest: _active,
    AxisPeriod: _all(
        (
            lambda one: one.period > 0 and 0 <= one.probability <= 1,
            "a period above 0 with its probability",
        )
    ),
    Scenarios: _scenarios,
    ErrorEstimate: _estimate,
    PositioningTest: _readings,
    TableRequest: _all(
        (
            lambda request: request.named_spacing is None or request.named_spacing > 0,
            "a spacing above 0",
        )
    ),
    PlannedAxis: _one_kind,
    ControlFile: _all(
        (
            lambda file: file.name not in {"", ".", ".."} and not set(file.name) & set("/\\\0"),
            "the name of a file, without folders",
        )
    ),
    CircularRun: _circle_run,
    CircularTest: _all(
        (lambda test: test.nominal_radius > 0 and test.feed > 0, "a radius and a feed above 0"),
        (lambda test: 0 < test.arc[1] <= 360, "an arc of more than 0 and at most 360 deg"),
        (lambda test: bool(test.runs), "at least one run"),
    ),
}
