"""The data of one axis while a job runs: from its evaluated tests and its estimated error to the
fitted table and the prediction.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal, Protocol

import numpy as np

from compwright.estimation.reach import longer_tests
from compwright.evaluation.standards import evaluate
from compwright.evaluation.valid_readings import valid_part
from compwright.foundations.findings import Finding
from compwright.planning.consistent_tests import select_consistent, with_active_corrections
from compwright.planning.guard_bands import guard_bands
from compwright.planning.header_statements import statement_findings
from compwright.planning.limit_decisions import (
    accepted_index,
    check_limits,
    lacking_guard,
    unguarded,
)
from compwright.planning.motions import with_backlash, with_motion
from compwright.planning.new_targets import decide_limits, further_targets_finding
from compwright.planning.predicted_gain import (
    judged_parameter,
    predict,
    why_not_better,
    why_not_seen,
)
from compwright.planning.sign_and_unit_doubts import reading_doubts, with_known_backlash
from compwright.planning.simulated_repeat_tests import FreshTests, RepeatConditions, fresh_tests
from compwright.planning.tables import new_grid_offer
from compwright.planning.temperature_slopes import fresh_slope, with_temperature_slopes
from compwright.planning.unapplied_steps import unapplied_step_findings
from compwright.planning.wanted_correction import (
    MeasuredError,
    axis_compensation,
    check_coverage,
    dense_positions,
    observed_tests,
    with_change,
)
from compwright.prediction.active_corrections import Correction, difference, no_correction
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.estimate import ErrorEstimate
from compwright.records.fitted_table import FittedTable
from compwright.records.job import AxisJob, Job
from compwright.records.plan import PlannedAxis, PlannedTest
from compwright.records.positioning import PositioningTest
from compwright.records.prediction import AxisPrediction, TestPrediction
from compwright.records.result import PositioningResult
from compwright.words.sentences import Sentence, say


class CapacityOf(Protocol):
    """A function that returns the control's limits on the table of an axis. It raises CapacityError
    if the control can hold no table.
    """

    def __call__(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the control's limits on the table of an axis. ``one_curve``: the job requires one
        table with a backlash value.
        """


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisWork:
    """The data of one axis during a run: job, tests, estimate, table, prediction.

    ``as_found``: the present correction of the control, as the virtual control decodes it.
    ``refused``: why the table of the axis is not written. ``chosen``: the table on a grid that
    compwright chose, if the existing grid stays and this may cost accuracy. ``alternative``: if the
    job's goal differs from the least expected square, the table that was not used. ``doubts``:
    about tests that contradict the first test or look unlike their description. ``at_targets``: the
    estimate at the targets of the first test.
    """

    entry: AxisJob
    results: tuple[PositioningResult, ...]
    posterior: MeasuredError
    planned: PlannedAxis
    as_found: Correction
    capacity: Capacity | None = None
    refused: Sentence | None = None
    chosen: FittedTable | None = None
    alternative: FittedTable | None = None
    doubts: tuple[Finding, ...] = ()
    at_targets: ErrorEstimate | None = None

    def estimate_at(self, positions: FloatArray) -> ErrorEstimate:
        """Return mean and standard deviation of the deviation at ``positions`` (g,), mm or deg.
        Values at targets of the first test are not computed again.
        """
        known = self.at_targets
        if known is None or not np.all(np.isin(positions, known.positions)):
            return self.posterior.summary(positions)
        return known.taken(np.searchsorted(known.positions, positions))

    @property
    def active(self) -> Correction:
        """The correction that was active during the first test, or zero where it is unknown."""
        active = self.planned.active
        return no_correction if active is None else active.at

    @property
    def stops(self) -> bool:
        """Whether the table of this axis was discarded because no test would show its gain."""
        made = self.capacity is not None
        return made and bool(self.refused) and self.planned.request.gain == "seen"

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings about this axis that do not belong to a single test."""
        fitted = self.planned.fitted
        own = (
            *self._longer_tests(),
            *self.doubts,
            *self.planned.estimate.findings,
            *self.posterior.findings,
            *(fitted.findings if fitted else ()),
        )
        if self.refused:
            own = (
                *own,
                Finding.of(
                    "CW-P001",
                    "info" if self.stops else "error",
                    axis=self.entry.axis.name,
                    why=self.refused,
                ),
            )
        return tuple(dict.fromkeys(own))

    def _longer_tests(self) -> list[Finding]:
        """Return the findings about unused tests that cover more travel than the tests in use."""
        tests = self.planned.tests
        fitted = [planned.test for planned in tests if planned.acted is not None]
        others = [planned.test for planned in tests if planned.acted is None]
        return longer_tests(fitted, others)


#: Checks of the readings that an estimate of the noise tells with its size and its odds.
_REPORTED_BY: Final = {
    "CW-E020": "CW-T012",
    "CW-E021": "CW-T012",
    "CW-E024": "CW-T014",
    "CW-E032": "CW-T014",
}


def evaluate_test(
    job: Job,
    axis: Axis,
    test: PositioningTest,
    reported: Collection[str] = (),
    other_tests: Sequence[PositioningTest] = (),
) -> PositioningResult:
    """Return the evaluation of a test of an axis with the settings of the job. ``reported``: codes
    of findings that are reported elsewhere; ``other_tests``: other tests of the axis.
    """
    return evaluate(
        test,
        job.standard,
        travel=axis.travel,
        periods=axis.screw_pitch,
        budget=job.budget(axis.kind),
        thermal=test.thermal,
        reported=reported,
        other_tests=other_tests,
    )


def start_axis(
    job: Job,
    entry: AxisJob,
    tests: tuple[PlannedTest, ...],
    states: Mapping[str, ControlState],
    as_found: Correction,
) -> AxisWork:
    """Evaluate the tests of an axis (``entry`` of the job), and estimate its error from those tests
    that agree. ``states``: the known states of the control, by name; ``as_found``: the correction
    that is active at present.

    Raises UsageError for limits that fit no test. Raises InputError if the tests in use cover less
    than half of the travel.
    """
    axis = entry.axis
    measured = [planned.test for planned in tests]
    others = [[other for other in measured if other is not test] for test in measured]
    results = tuple(
        evaluate_test(job, axis, test, other_tests=other_tests)
        for test, other_tests in zip(measured, others, strict=True)
    )
    check_limits(job, entry, results)
    active = None
    if tests[0].measured_in in states:
        active = axis_compensation(states[tests[0].measured_in], axis)
    tests = with_active_corrections(
        with_backlash(with_temperature_slopes(job, tests), axis, states), axis, states
    )
    observed = observed_tests(tests, active)
    misread = reading_doubts(tests, observed, axis, states)
    tests, posterior, contradicting = select_consistent(tests, observed, axis, active)
    results = tuple(
        with_known_backlash(
            evaluate_test(job, axis, result.test, reported, other_tests) if reported else result,
            bare,
        )
        for result, reported, other_tests, bare in zip(
            results, _reported_checks(posterior), others, observed, strict=True
        )
    )
    check_coverage(job.file, axis, [each.test for each in tests if each.acted is not None])
    planned = PlannedAxis(
        axis=axis,
        tests=tests,
        estimate=posterior.summary(
            dense_positions(axis, [each.period for each in posterior.own.periods])
        ),
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
        as_found=as_found,
        doubts=(
            *misread,
            *contradicting,
            *statement_findings(tests, axis, states, job.machine.get("serial", "")),
        ),
        at_targets=posterior.summary(results[0].test.targets),
    )


def _reported_checks(posterior: MeasuredError) -> Iterator[frozenset[str]]:
    """Yield, for each test, the codes of findings that need not be reported, because the estimate
    reports the same fact.
    """
    for noise, place in zip(posterior.noises, posterior.counted, strict=True):
        found = () if noise is None or place is None else noise.findings
        yield frozenset(_REPORTED_BY[each.code] for each in found if each.code in _REPORTED_BY)


def predict_axis(
    work: AxisWork,
    new: Correction,
    table: AxisCompensation | None,
    job: Job,
    fresh: FreshTests | None = None,
) -> AxisPrediction:
    """Return the prediction of repeated tests of an axis under the correction ``new``. ``table``:
    the written table as read back; ``fresh``: simulated repetitions of the first test at new
    targets, if they exist already.
    """
    axis, rule = work.planned.axis, job.decision_rule
    first = fresh or repeats_of_first(work, rule)
    tests = tuple(
        _predicted_test(work, place, new, job, None if place else first)
        for place in range(len(work.results))
    )
    accept, undecided = decide_limits(work.entry, work.posterior.own, rule, tests)
    guard = lacking_guard(axis, work.results[0].standard, unguarded(accept))
    return AxisPrediction(
        tests=tests,
        table=table,
        quantum=work.capacity.quantum if work.capacity is not None else None,
        accept=accept,
        findings=(
            *work.findings,
            *undecided,
            *further_targets_finding(axis, work.posterior.own),
            *guard,
            *_offered(work, tests, first, rule),
        ),
        periods=work.posterior.own.periods,
        evidence=work.posterior.own.search.evidence(),
    )


def _predicted_test(
    work: AxisWork, place: int, new: Correction, job: Job, fresh: FreshTests | None
) -> TestPrediction:
    """Return the prediction of a repetition of the test with index ``place``, under the correction
    ``new``. ``fresh``: simulated repetitions at new targets, if they exist already.

    If the job decides with guard bands, the prediction contains them.
    """
    planned, result = work.planned, work.results[place]
    test = planned.tests[place]
    change = with_motion(difference(new, work.active), planned.axis, test.backlash_more)
    like = RepeatConditions(place, fresh_slope(job.decision_rule, test))
    shown = predict(result, work.posterior, change, planned.axis, like, fresh)
    accept = work.entry.accept
    names = tuple(each.test.name for each in work.results)
    if job.decision_rule == "simple" or accept is None or accepted_index(accept, names) != place:
        return shown
    bands = guard_bands(job, planned, place, result, work.posterior, change)
    return replace(shown, uncertainty=bands)


def repeats_of_first(work: AxisWork, rule: Literal["simple", "guarded"] = "simple") -> FreshTests:
    """Return simulated repetitions of the first test of an axis, at new targets. ``rule``
    ``guarded``: without slope errors by temperature, which are part of the guard band.
    """
    like = RepeatConditions(0, fresh_slope(rule, work.planned.tests[0]))
    return fresh_tests(work.results[0], work.posterior, work.planned.axis, like)


def _offered(
    work: AxisWork,
    tests: Sequence[TestPrediction],
    fresh: FreshTests,
    rule: Literal["simple", "guarded"],
) -> Iterator[Finding]:
    """Yield the finding that freely chosen table points would give clearly better tests than the
    existing points, which are kept. ``tests``: predictions with the existing points; ``fresh``:
    simulated repetitions of the first test at new targets.
    """
    capacity, chosen = work.capacity, work.chosen
    if chosen is None or capacity is None:
        return
    change = difference(chosen.compensation.at, work.active)
    like = RepeatConditions(0, fresh_slope(rule, work.planned.tests[0]))
    offered = predict(work.results[0], work.posterior, change, work.planned.axis, like, fresh)
    finding = new_grid_offer(
        work.planned.axis,
        np.array(capacity.there),
        chosen,
        tests[0],
        offered,
        quantum=capacity.quantum,
        written=work.planned.fitted is not None,
    )
    if finding is not None:
        yield finding


def why_no_gain(work: AxisWork, new: Correction) -> Sentence | None:
    """Return the reason why the correction ``new``, read back from the written files, would not
    improve the axis enough, or None if the improvement is large enough.

    The improvement is the difference from the present correction of the control. It is compared
    with the gain that the job requires. Outlying readings and traverses that were not made are left
    out, because no table changes them.
    """
    changes = [difference(each, work.active) for each in (new, work.as_found)]
    first = work.results[0]
    test = valid_part(first.test)
    after, before = (
        evaluate(
            with_change(test, *(change(test.targets, direction) for direction in Direction)),
            first.standard,
            checked=False,
        )
        for change in changes
    )
    drawn = fresh_tests(first, work.posterior, work.planned.axis)
    fresh, old = (
        drawn.quantiles(change, cured=("tails",), only=judged_parameter(first))
        for change in changes
    )
    why = why_not_better(before, after, old, fresh)
    fitted = work.planned.fitted
    if why and fitted is not None:
        stuck = unapplied_step_findings(work.planned.axis, fitted.compensation)
        why = say("listed", items=[why, *(finding.sentence for finding in stuck)], more=0)
    if why is not None or work.planned.request.gain == "any":
        return why
    return why_not_seen(before, old, fresh)
