"""One axis on its way through a run: evaluated, estimated, fitted, exported, predicted."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from compwright.estimation.reach import longer_tests
from compwright.evaluation.agreement import disagreeing_test
from compwright.evaluation.standards import evaluate
from compwright.fitting.beyond import beyond_limits
from compwright.fitting.fit import fit_table
from compwright.foundations.errors import (
    CapacityError,
    CompwrightError,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    no_compensation,
)
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted import FittedTable, TableRequest
from compwright.records.job import AxisJob, Job
from compwright.records.plan import PlannedAxis, PlannedTest
from compwright.records.prediction import AxisPrediction
from compwright.records.result import PositioningResult
from compwright.workflow.stages.changes import changed_neighbours
from compwright.workflow.stages.control import Control, DecodedState, decode, judged
from compwright.workflow.stages.inputs import JobInputs
from compwright.workflow.stages.outlook import (
    Change,
    Correction,
    accept_decisions,
    check_limits,
    lacking_guard,
    predict,
    predict_new_targets,
    why_not_better,
)
from compwright.workflow.stages.planning import (
    MeasuredError,
    check_coverage,
    dense_positions,
    measured_error,
    wanted_correction,
    with_change,
)

AS_FOUND = "as_found"


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisWork:
    """One axis of a run. ``as_found``: what the control does now, by the judge; ``refused``: why
    its table is not written.
    """

    entry: AxisJob
    results: tuple[PositioningResult, ...]
    posterior: MeasuredError
    planned: PlannedAxis
    as_found: Correction
    capacity: Capacity | None = None
    refused: str = ""
    disagreeing: tuple[Finding, ...] = ()

    @property
    def active(self) -> Correction:
        """What acted during the first test; zero where nobody said."""
        active = self.planned.active

        def correction(positions: FloatArray, direction: Direction) -> FloatArray:
            return (
                np.zeros(np.shape(positions)) if active is None else active.at(positions, direction)
            )

        return correction

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What was noticed on this axis beside the findings of its tests."""
        fitted = self.planned.fitted
        first, *others = (result.test for result in self.results)
        own = (
            *longer_tests(first, others),
            *self.disagreeing,
            *self.planned.estimate.findings,
            *self.posterior.findings,
            *(fitted.findings if fitted else ()),
        )
        if self.refused:
            own = (
                *own,
                Finding(
                    "CW-P001",
                    "error",
                    f"No table is written for axis {self.entry.axis.name}: {self.refused}.",
                ),
            )
        return tuple(dict.fromkeys(own))


def start_axis(job: Job, entry: AxisJob, inputs: JobInputs) -> AxisWork:
    """Evaluate the tests of an axis and estimate its error from the first.

    Raises UsageError for tolerances that fit no test, InputError where the tests cover less than
    half of the travel.
    """
    axis = entry.axis
    tests = inputs.tests[axis.name]
    check_coverage(job.file, axis, tests[0].test)
    results = tuple(
        evaluate(
            planned.test,
            job.standard,
            travel=axis.travel,
            periods=axis.screw_pitch,
            budget=job.budget(axis.kind),
            thermal=job.thermal,
        )
        for planned in tests
    )
    check_limits(job, entry, results)
    active = _compensation(inputs.states.get(tests[0].measured_in), axis)
    posterior = measured_error(tests[0].test, axis, active)
    planned = PlannedAxis(
        axis=axis,
        tests=tests,
        estimate=posterior.summary(dense_positions(axis)),
        active=active,
        wanted=None,
        request=entry.table,
        fitted=None,
        accept=entry.accept,
    )
    return AxisWork(
        entry=entry,
        results=results,
        posterior=posterior,
        planned=planned,
        as_found=correction_of(inputs.states.get(AS_FOUND), axis),
        disagreeing=tuple(_disagreeing(tests, inputs, axis, posterior)),
    )


def _disagreeing(
    tests: Sequence[PlannedTest], inputs: JobInputs, axis: Axis, posterior: MeasuredError
) -> Iterator[Finding]:
    """Yield the doubts of tests that contradict the first, each in the state that it was measured
    in.
    """
    first, *others = tests
    before = _compensation(inputs.states.get(first.measured_in), axis)
    for other in others:
        now = _compensation(inputs.states.get(other.measured_in), axis)
        if other.measured_in != first.measured_in and (now is None or before is None):
            continue
        targets = other.test.targets
        estimate = posterior.summary(targets)
        expected = {direction: estimate.mean(direction) for direction in Direction}
        if now is not None and before is not None and other.measured_in != first.measured_in:
            expected = {
                side: mean + now.at(targets, side) - before.at(targets, side)
                for side, mean in expected.items()
            }
        std = {Direction.POSITIVE: estimate.std_positive, Direction.NEGATIVE: estimate.std_negative}
        finding = disagreeing_test(other.test, expected, std, estimate.noise, first.test.name)
        if finding is not None:
            yield finding


def _compensation(decoded: DecodedState | None, axis: Axis) -> AxisCompensation | None:
    """Return what a state does on an axis; None where nobody said what the state is."""
    if decoded is None:
        return None
    return decoded.state.axes.get(
        axis.address, no_compensation(axis.address, axis.kind, axis.reference_return)
    )


def correction_of(decoded: DecodedState | None, axis: Axis) -> Correction:
    """Return the correction of an axis by the judge's reading of ``decoded``; zero where there are
    no files.
    """

    def correction(positions: FloatArray, direction: Direction) -> FloatArray:
        if decoded is None:
            return np.zeros(np.shape(positions))
        return judged(decoded, axis.address, positions, direction)

    return correction


def fit_all(works: Mapping[str, AxisWork], control: Control, job_file: str) -> dict[str, AxisWork]:
    """Fit every axis under the limits of the control. Raises CapacityError with the faults of all
    axes.
    """
    errors: list[CompwrightError] = []
    fitted: dict[str, AxisWork] = {}
    capacities: dict[str, Capacity] = {}
    for name, work in works.items():
        try:
            one_curve = work.planned.request.mode == "single"
            capacities[name] = control.format.capacity(work.planned.axis, one_curve=one_curve)
        except CapacityError as error:
            errors.append(
                CapacityError(
                    *(fault.within(f"axis {name}").in_file(job_file) for fault in error.faults)
                )
            )
    capacities = shared_fairly(
        capacities,
        {name: work.planned for name, work in works.items() if work.planned.active is not None},
    )
    for name, work in works.items():
        planned = work.planned
        if planned.active is None or name not in capacities:
            fitted[name] = work
            continue
        wanted = wanted_correction(
            planned.estimate,
            planned.active,
            planned.axis,
            reversal_log_odds=work.posterior.reversal_log_odds,
        )
        try:
            capacity = capacities[name]
            table = fit_within(wanted, capacity, planned.request, address=planned.axis.address)
        except CapacityError as error:
            errors.append(
                CapacityError(
                    *(fault.within(f"axis {name}").in_file(job_file) for fault in error.faults)
                )
            )
            continue
        fitted[name] = replace(
            work, capacity=capacity, planned=replace(planned, wanted=wanted, fitted=table)
        )
    raise_all(CapacityError, collect(errors))
    return fitted


def shared_fairly(
    capacities: Mapping[str, Capacity], planned: Mapping[str, PlannedAxis]
) -> dict[str, Capacity]:
    """Return the capacities with the points of a store that all axes share divided among those
    whose spacing nobody named.

    An axis whose spacing the job names gets what it needs; two tables need twice the points. What
    the job names stays as it is: where it does not fit, writing refuses it.
    """
    sharing = {
        name: one
        for name, one in capacities.items()
        if one.shared_points and one.max_points and name in planned
    }
    sets = {name: 2 if planned[name].request.mode == "bidirectional" else 1 for name in sharing}
    free = {name: one for name, one in sharing.items() if planned[name].request.spacing is None}
    named = 0
    for name in sharing.keys() - free.keys():
        request, axis = planned[name].request, planned[name].axis
        low = min(axis.travel[0] if request.start is None else request.start, axis.reference)
        high = max(axis.travel[1] if request.end is None else request.end, axis.reference)
        named += sets[name] * (int((high - low) / (request.spacing or 1.0)) + 3)
    result = dict(capacities)
    for name, one in free.items():
        room = min(other.max_points or 0 for other in sharing.values())
        share = (room - named) // len(free) // sets[name] - 2
        if len(sharing) > 1 or sets[name] > 1:
            result[name] = replace(one, max_points=max(2, min(one.max_points or 2, share)))
    return result


def fit_within(
    wanted: WantedCorrection, capacity: Capacity, request: TableRequest, *, address: str
) -> FittedTable:
    """Return the fitted table. Raises CapacityError where the control cannot hold it by more than
    the noise of a reading.
    """
    table = fit_table(wanted, capacity, request, address=address)
    raise_all(CapacityError, list(beyond_limits(table, wanted, capacity)))
    return table


def write_fitted(
    control: Control, fitted: list[tuple[Axis, FittedTable]], as_found: DecodedState
) -> tuple[tuple[ControlFile, ...], DecodedState | None]:
    """Write fitted tables as the control's files and read them back with both readers; (), None
    where there are none.

    What is in the control (``as_found``) is patched. Raises CapacityError where something cannot be
    held, and CompwrightError (a fault of our own) when a table of an axis that was not asked for
    reads otherwise than before.
    """
    if not fitted:
        return (), None
    axes = [axis for axis, _ in fitted]
    compensations = [table.compensation for _, table in fitted]
    try:
        files = control.format.write(compensations, axes, as_found.files)
    except UsageError as error:  # an option that the control's files do not answer
        named = all(fault.place in control.definition.options for fault in error.faults)
        raise (control.origin.named(error) if named else error) from error
    raise_all(CompwrightError, changed_neighbours(control, as_found.files, files, axes))
    return files, decode(control, files, axes, written=True)


def export(
    works: Mapping[str, AxisWork], control: Control, as_found: DecodedState, *, accept_worse: bool
) -> tuple[dict[str, AxisWork], tuple[ControlFile, ...], DecodedState | None]:
    """Write the tables, read them back through the judge, and leave out those that would not
    improve their axis.
    """
    files, loaded = write_fitted(control, _fitted(works), as_found)
    if accept_worse or loaded is None:
        return dict(works), files, loaded
    kept: dict[str, AxisWork] = {}
    for name, work in works.items():
        why = _no_gain(work, loaded)
        fitted = None if why else work.planned.fitted
        kept[name] = replace(work, refused=why, planned=replace(work.planned, fitted=fitted))
    if any(work.refused for work in kept.values()):
        files, loaded = write_fitted(control, _fitted(kept), as_found)
    return kept, files, loaded


def predict_axis(
    work: AxisWork, loaded: DecodedState | None, rule: Literal["simple", "guarded"] = "simple"
) -> AxisPrediction:
    """Return what fresh tests of an axis will show: with the table as read back, or with what is in
    the control now.
    """
    axis = work.planned.axis
    fitted = work.planned.fitted
    new = work.as_found if fitted is None else correction_of(loaded, axis)
    tests = tuple(
        predict(result, work.posterior, Change(new, work.active), axis) for result in work.results
    )
    folded = any(finding.code == "CW-E010" for finding in work.posterior.findings)
    accept = accept_decisions(work.entry, tests, rule, folded=folded)
    lacking = [
        name for name, entry in accept.items() if entry.rule == "guarded" and entry.U is None
    ]
    return AxisPrediction(
        tests=tests,
        table=(
            loaded.state.axes[axis.address] if fitted is not None and loaded is not None else None
        ),
        quantum=work.capacity.quantum if work.capacity is not None else None,
        limits=fitted.limits if fitted is not None else (),
        accept=accept,
        findings=(*work.findings, *lacking_guard(axis, work.results[0].standard, lacking)),
    )


def _fitted(works: Mapping[str, AxisWork]) -> list[tuple[Axis, FittedTable]]:
    planned = [work.planned for work in works.values()]
    return [(entry.axis, entry.fitted) for entry in planned if entry.fitted is not None]


def _no_gain(work: AxisWork, loaded: DecodedState) -> str:
    """Return why the table as read back would not improve the axis over what the control does now;
    empty when it does.
    """
    axis = work.planned.axis
    if work.planned.fitted is None:
        return ""
    changed = Change(correction_of(loaded, axis), work.active)
    unchanged = Change(work.as_found, work.active)
    first = work.results[0]
    after, before = (
        evaluate(
            with_change(
                first.test, *(change.at(first.test.targets, direction) for direction in Direction)
            ),
            first.standard,
        )
        for change in (changed, unchanged)
    )
    new, old = (
        predict_new_targets(first, work.posterior, change, axis) for change in (changed, unchanged)
    )
    return why_not_better(before, after, old, new)
