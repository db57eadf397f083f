"""Decide whether existing tables were active, from tests of an axis in two states."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.parallel_work import Each
from compwright.planning.axis_work import AxisWork
from compwright.planning.motions import with_backlash
from compwright.planning.wanted_correction import (
    UNDECLARED_SLOPE,
    axis_compensation,
    measured_error,
    observed_tests,
)
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.plan import PlannedTest
from compwright.records.stored_table import StoredTable
from compwright.verification.existing_table import ExistingTableVerdict
from compwright.verification.hypothesis import Loading
from compwright.verification.likelihood import after_means, belief_of, draws_for
from compwright.verification.loading import judge_loading
from compwright.verification.loading_hypotheses import loading_hypotheses
from compwright.verification.measurement_cases import MeasurementCase, measurement_cases
from compwright.words.sentences import say
from compwright.workflow.run.input_stage import Measured

#: Two corrections are the same below this many mm or deg.
_SAME = 1e-6
_Task = tuple[Axis, PlannedTest, PlannedTest, Mapping[str, ControlState], Mapping[str, StoredTable]]


def with_old_tables(
    measured: Measured, works: Mapping[str, AxisWork], each: Each
) -> tuple[dict[str, AxisWork], tuple[Finding, ...]]:
    """Return the axes by name, and the findings on whether the existing table was active.

    An axis gets no new table if its tests show that the active correction differs from the
    control's files, because the total of old and new would be wrong.
    """
    tasks = [(name, task) for name, work in works.items() for task in _tasks(work, measured)]
    judged = each(_judged, [task for _, task in tasks])
    found: dict[str, AxisWork] = dict(works)
    findings: list[Finding] = []
    for (name, task), old in zip(tasks, judged, strict=True):
        finding = old.finding()
        if finding is not None:
            sentence = say("of_axis", axis=name, finding=finding.sentence)
            findings.append(replace(finding, sentence=sentence))
            continue
        table = axis_compensation(measured.states[task[2].measured_in], task[0])
        sentences = measured.control.look_at(task[0], table)
        names = dict.fromkeys((old.verdict.verdict, *(one.verdict for one in old.likely)))
        look = [sentence for name in names for sentence in sentences.get(name, ())]
        found[name] = replace(found[name], refused=old.refusal(look))
    return found, tuple(findings)


def _tasks(work: AxisWork, measured: Measured) -> list[_Task]:
    """Return the pairs of tests of an axis to be compared: the test with the least active
    correction, with a test in each other state.
    """
    axis, states = work.planned.axis, measured.states
    first: dict[str, PlannedTest] = {}
    for planned in work.planned.tests:
        if planned.measured_in in states:
            first.setdefault(planned.measured_in, planned)
    if len(first) < 2:
        return []
    off = min(
        first.values(), key=lambda one: _size(axis_compensation(states[one.measured_in], axis), one)
    )
    least = axis_compensation(states[off.measured_in], axis)
    return [
        (axis, off, on, states, _stored_tables(axis, measured, states[on.measured_in]))
        for on in first.values()
        if on is not off
        and _apart(least, axis_compensation(states[on.measured_in], axis), on) > _SAME
    ]


def _size(table: AxisCompensation, planned: PlannedTest) -> float:
    curves = [table.at(planned.test.targets, direction) for direction in Direction]
    return float(np.std(curves))


def _apart(one: AxisCompensation, other: AxisCompensation, planned: PlannedTest) -> float:
    targets = planned.test.targets
    gaps = [one.at(targets, direction) - other.at(targets, direction) for direction in Direction]
    return float(np.ptp(gaps))


def _judged(task: _Task) -> ExistingTableVerdict:
    return judged_old_table(*task)


def judged_old_table(
    axis: Axis,
    off: PlannedTest,
    on: PlannedTest,
    states: Mapping[str, ControlState],
    tables: Mapping[str, StoredTable],
) -> ExistingTableVerdict:
    """Decide whether the existing table was active in the test ``on``, by comparison with the test
    ``off``, which has the least correction. ``states``: the control's contents by the name of the
    state; ``tables``: those of the test ``on``, by axis.

    It is also tested whether the table of another axis was active instead of this one.
    """
    least = axis_compensation(states[off.measured_in], axis)
    tests = with_backlash((replace(off, acted=None),), axis, states)
    error = measured_error(tests, observed_tests(tests, least), axis, least)
    test = on.test
    draws = error.draw(test.targets, draws_for(test.targets.size), np.random.default_rng(0))
    loading = Loading(
        new=tables[axis.name],
        old=least,
        active_before=least,
        others={name: table for name, table in tables.items() if name != axis.name},
        reference=axis.reference,
    )
    view = MeasurementCase(
        belief=belief_of(draws.positive, draws.negative),
        hypotheses=loading_hypotheses(loading, test.targets),
    )
    verdict = judge_loading(
        after_means(test, draws.noise),
        [view, *measurement_cases(view, both=test.bidirectional)],
        declared_slope=_slope(off, on) if test.kind is AxisKind.LINEAR else None,
    )
    return ExistingTableVerdict(on.test.name, off.test.name, on.measured_in, verdict)


def _stored_tables(axis: Axis, measured: Measured, state: ControlState) -> dict[str, StoredTable]:
    """Return the tables in a state of the control: that of an axis, and of those of its kind."""
    control = measured.control.in_state(state).format
    others = {
        other.name: control.stored_table(other, state.axes[other.address])
        for other in measured.axes.values()
        if other.name != axis.name
        and other.kind is axis.kind
        and other.address in state.axes
        and other.address != axis.gantry
    }
    return {axis.name: control.stored_table(axis, axis_compensation(state, axis)), **others}


def _slope(off: PlannedTest, on: PlannedTest) -> float:
    """Return the standard uncertainty of the difference between two tests' slopes, mm/mm.

    It is the declared one. If none is declared, it is that of a usual change of temperature
    (`planning.wanted_correction`).
    """
    return max(math.hypot(off.slope_std, on.slope_std), UNDECLARED_SLOPE)
