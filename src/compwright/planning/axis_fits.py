"""Fitting of the compensation tables of all axes of a job, within the limits of the control."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Final, Literal

from compwright.foundations.errors import CapacityError, CompwrightError, Fault, collect, raise_all
from compwright.foundations.findings import doubts_of
from compwright.foundations.parallel_work import Each, in_turn
from compwright.planning.axis_work import AxisWork, CapacityOf, repeats_of_first
from compwright.planning.practical_tables import Shown, practical_table
from compwright.planning.predicted_gain import predict
from compwright.planning.reversal_along_travel import (
    drift_within_run,
    explained_by_drift,
    reversal_rise,
)
from compwright.planning.scenarios import goal_improves, same_tables, scenarios_of
from compwright.planning.shared_points import share_points
from compwright.planning.simulated_repeat_tests import FreshTests, RepeatConditions
from compwright.planning.tables import fit_within, free_grid_table
from compwright.planning.temperature_slopes import fresh_slope
from compwright.planning.wanted_correction import (
    wanted_correction,
)
from compwright.prediction.active_corrections import difference
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.prediction import TestPrediction
from compwright.words.sentences import SentenceText, say

#: Why one table is taken where two would hold what may be the drift of the test.
_ONE_TABLE: Final = SentenceText(say("mode.one_drift"))


@dataclass(frozen=True, slots=True)
class _Fitted:
    wanted: WantedCorrection
    request: TableRequest
    table: FittedTable
    chosen: FittedTable | None
    alternative: FittedTable | None
    capacity: Capacity


def fit_all(
    works: Mapping[str, AxisWork],
    capacity_of: CapacityOf,
    job_file: str,
    each: Each = in_turn,
    rule: Literal["simple", "guarded"] = "simple",
) -> dict[str, AxisWork]:
    """Fit the tables of all axes within the limits of the control. ``each`` runs the fits, in turn
    or in parallel; ``rule``: the job decides with or without a guard band for uncertainty. Raises
    CapacityError with the faults of all axes.
    """
    errors: list[CompwrightError] = []
    capacities: dict[str, Capacity] = {}
    wanted = {name: work for name, work in works.items() if not work.refused}
    for name, work in wanted.items():
        try:
            one_curve = work.planned.request.mode == "single"
            capacities[name] = capacity_of(work.planned.axis, one_curve=one_curve)
        except CapacityError as error:
            errors.append(_not_held(error, name, work, job_file))
    capacities = share_points(
        capacities,
        {name: work.planned for name, work in wanted.items() if work.planned.active is not None},
    )
    tasks = {
        name: (work, capacities[name], rule)
        for name, work in wanted.items()
        if work.planned.active is not None and name in capacities
    }
    fitted = dict(works)
    for name, found in zip(tasks, each(_fit, list(tasks.values())), strict=True):
        if isinstance(found, CapacityError):
            errors.append(_not_held(found, name, works[name], job_file))
            continue
        fitted[name] = replace(
            works[name],
            capacity=found.capacity,
            planned=replace(
                works[name].planned,
                wanted=found.wanted,
                request=found.request,
                fitted=found.table,
            ),
            chosen=found.chosen,
            alternative=found.alternative,
        )
    raise_all(CapacityError, collect(errors))
    return fitted


def _fit(
    task: tuple[AxisWork, Capacity, Literal["simple", "guarded"]],
) -> _Fitted | CapacityError:
    """Return the wanted correction and the fitted tables of an axis, or the CapacityError that
    states why the control cannot hold a table. ``task``: axis, limits of the control and decision
    rule.

    If the job leaves the number of tables open, a single table is used where the second one might
    contain the drift of the test.
    """
    work, capacity, rule = task
    found = _requested_fit(work, capacity, rule)
    if isinstance(found, CapacityError) or not _holds_drift(work, found, rule):
        return found
    planned = replace(work.planned, request=replace(work.planned.request, mode="single"))
    single = _requested_fit(replace(work, planned=planned), capacity, rule)
    if isinstance(single, CapacityError):
        return single
    tables = (single.table, single.chosen, single.alternative)
    table, chosen, alternative = (one and replace(one, mode_reason=_ONE_TABLE) for one in tables)
    return replace(single, table=table or single.table, chosen=chosen, alternative=alternative)


def _holds_drift(work: AxisWork, found: _Fitted, rule: Literal["simple", "guarded"]) -> bool:
    """Return whether test drift can explain the difference of the fitted tables for + and −."""
    planned = work.planned
    if planned.request.mode != "auto" or found.table.mode != "bidirectional":
        return False
    within = drift_within_run(work.results[0].test, repeats_of_first(work, rule).draws.noise)
    return explained_by_drift(reversal_rise(planned.estimate, work.active), within)


def _requested_fit(
    work: AxisWork, capacity: Capacity, rule: Literal["simple", "guarded"]
) -> _Fitted | CapacityError:
    """Return the wanted correction and the fitted tables of an axis, or the CapacityError that
    states why the control cannot hold a table.

    If the job has a goal, its table is used only if the simulated tests of the prediction show that
    it is better than the usual table, or if both are the same.
    """
    planned = work.planned
    if planned.active is None:
        raise TypeError("the control's existing compensation is not given")
    axis, request = planned.axis, planned.request
    wanted = wanted_correction(
        planned.estimate, planned.active, axis, reversal_log_odds=work.posterior.reversal_log_odds
    )
    try:
        expected = replace(request, goal="expected")
        capacity, usual = practical_table(wanted, capacity, expected, axis, _shown(work, rule))
        alternative = None
        if request.goal != "expected":
            scenarios = scenarios_of(work.results[0], work.posterior, planned.estimate, axis)
            judged = replace(wanted, scenarios=scenarios)
            table = fit_within(judged, capacity, request, axis)
            if _pays(work, table, usual, rule):
                chosen = free_grid_table(judged, capacity, request, table, axis)
                return _Fitted(judged, request, table, chosen, usual, capacity)
            alternative = table
        chosen = free_grid_table(wanted, capacity, expected, usual, axis)
    except CapacityError as error:
        return error
    return _Fitted(wanted, expected, usual, chosen, alternative, capacity)


def _shown(work: AxisWork, rule: Literal["simple", "guarded"]) -> Shown:
    """Return a function that predicts, for a given table, a repetition of the first test."""
    drawn: list[FreshTests] = []
    like = RepeatConditions(0, fresh_slope(rule, work.planned.tests[0]))

    def shown(table: FittedTable) -> TestPrediction:
        if not drawn:
            drawn.append(repeats_of_first(work, rule))
        change = difference(table.compensation.at, work.active)
        axis = work.planned.axis
        return predict(work.results[0], work.posterior, change, axis, like, drawn[0])

    return shown


def _pays(
    work: AxisWork, table: FittedTable, usual: FittedTable, rule: Literal["simple", "guarded"]
) -> bool:
    """Return whether the ``table`` fitted for the job's goal is used instead of the ``usual``
    table: if both are equal, or if simulated tests show that it is better.
    """
    goal = work.planned.request.goal
    if goal == "expected" or same_tables(table, usual):
        return True
    with_it, without = (difference(one.compensation.at, work.active) for one in (table, usual))
    return goal_improves(goal, with_it, without, repeats_of_first(work, rule))


def _not_held(error: CapacityError, name: str, work: AxisWork, file: str) -> CapacityError:
    """Return the error that the control cannot hold the table of an axis. If there are doubts about
    the readings, the error lists them first, because readings with a wrong unit or sign are the
    usual cause.
    """
    doubted = [
        Fault(
            message=doubt.message,
            place=f"axis {name}, test {result.test.name}",
            hint="correct the measurement file or the job, or measure again",
        ).in_file(result.test.sources[0].file if result.test.sources else file)
        for result in work.results
        for doubt in doubts_of(result.findings)
    ]
    held = [fault.within(f"axis {name}").in_file(file) for fault in error.faults]
    return CapacityError(*doubted, *held)
