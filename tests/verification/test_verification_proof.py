"""What has to be there before a verification is good: tests, circles, limits as they were."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any, Literal, cast

import numpy as np
import pytest

from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source
from compwright.records.axis import AxisKind
from compwright.records.conditions import CircularBudget
from compwright.records.correction import CrossCompensation
from compwright.records.fitted_table import FittedTable
from compwright.records.job import Acceptance, CircleRequest, Job
from compwright.records.plan import Plan, PlannedAxis, PlannedCross
from compwright.records.positioning import PositioningTest
from compwright.records.verification import LoadingName, LoadingVerdict
from compwright.verification.proof import (
    AfterTest,
    changed_limits,
    copied_tests,
    doubt_warnings,
    not_measured,
    read_back_findings,
    unproven_circle,
)
from compwright.words.sentences import say
from compwright.workflow.verify.verified_axis import _without_explained_doubt
from planning_samples import (
    TARGETS,
    UM,
    KnownAxis,
    axis_of,
    circle_of,
    job_of,
    readings_of,
    work_of,
)

WORK = work_of(KnownAxis(np.zeros_like, np.zeros_like))
TABLE = cast("FittedTable", object())
LIMITS = Acceptance(limits={"A": 8.0})


def axis(
    *, fitted: bool = True, tested: bool = True, accept: Acceptance | None = None
) -> PlannedAxis:
    planned = replace(WORK.planned, accept=accept, fitted=TABLE if fitted else None)
    return planned if tested else replace(planned, tests=())


def plan(axes: Mapping[str, PlannedAxis], **words: Any) -> Plan:
    given = {"version": "1", "format": "any", "options": {}, "standard": "iso230-2:2014", **words}
    return Plan(axes=axes, **given)


def between(source: Literal["circle", "cross"] = "circle", *, written: bool = True) -> PlannedCross:
    table = CrossCompensation(
        input="X",
        output="Y",
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=TARGETS,
        positive=TARGETS,
        negative=TARGETS,
    )
    return PlannedCross(input="X", output="Y", added=table, source=source, written=written)


def missing(
    job: Job, of: Plan, measured: dict[str, str], *circles: str, scales: Collection[str] = ()
) -> list[tuple[str, dict[str, Any]]]:
    tests = {name: of.circles[name].test for name in circles}
    findings = not_measured(job, of, measured, tests, scales)
    return [(finding.sentence.name, dict(finding.sentence.values)) for finding in findings]


def test_an_axis_with_a_table_has_to_be_measured_again() -> None:
    job, planned = job_of(axis_of()), plan({"X": axis()})
    assert missing(job, planned, {"X": "x"}) == []
    assert missing(job, planned, {}) == [("CW-V023.axis", {"axis": "X", "test": "x"})]


@pytest.mark.parametrize(("fitted", "accept", "told"), [(False, None, 0), (False, LIMITS, 1)])
def test_an_axis_without_a_table_only_where_it_has_limits(
    fitted: bool,
    accept: Acceptance | None,
    told: int,
) -> None:
    job = job_of(axis_of(), accept=accept)
    assert len(missing(job, plan({"X": axis(fitted=fitted, accept=accept)}), {})) == told


def test_limits_speak_of_one_test_and_that_has_to_be_repeated() -> None:
    accept = Acceptance(limits={"A": 8.0}, test="long")
    job, planned = job_of(axis_of(), accept=accept), plan({"X": axis(accept=accept)})
    assert missing(job, planned, {"X": "long"}) == []
    ((name, values),) = missing(job, planned, {"X": "x"})
    assert name == "CW-V023.test"
    assert values == {"axis": "X", "meant": "long", "measured": "x"}
    assert missing(job, planned, {}) == [("CW-V023.axis", {"axis": "X", "test": "long"})]
    assert missing(job_of(axis_of(), accept=LIMITS), planned, {"X": "x"}) == []  # the first test


def test_a_scale_from_circles_asks_for_a_circle() -> None:
    circles = {
        name: circle_of({}, axes).planned for name, axes in (("xy", ("X", "Y")), ("yz", ("Y", "Z")))
    }
    planned = plan({"X": axis(tested=False)}, circles=circles)
    assert missing(job_of(axis_of()), planned, {}, "xy", scales={"X"}) == []
    ((name, values),) = missing(job_of(axis_of()), planned, {}, "xy")
    assert name == "CW-V023.scale"
    assert values == {"axis": "X", "circles": ("xy",)}
    kept = plan({"X": axis(tested=False, fitted=False)}, circles=circles)
    assert missing(job_of(axis_of()), kept, {}) == []


def test_a_squareness_that_was_corrected_asks_for_a_circle_of_its_plane() -> None:
    circles = {
        "xy": circle_of({}, ("Y", "X")).planned,
        "yz": circle_of({}, ("Y", "Z")).planned,
    }
    planned = plan({}, cross=(between(),), circles=circles)
    assert missing(job_of(), planned, {}, "xy") == []
    ((name, values),) = missing(job_of(), planned, {}, "yz")
    assert name == "CW-V023.squareness"
    assert values == {"plane": "XY", "circles": ("xy",)}
    for entry in (between("cross"), between(written=False)):
        assert missing(job_of(), plan({}, cross=(entry,), circles=circles), {}) == []


@pytest.mark.parametrize(
    ("code", "severity", "first_had_it", "guarded", "told"),
    [
        ("CW-T016", "warning", False, False, True),
        ("CW-T016", "warning", True, False, True),  # about the readings: again is no excuse
        ("CW-T007", "warning", False, False, True),
        ("CW-T007", "warning", True, False, True),  # a doubt, until it is acknowledged
        ("CW-T012", "warning", False, False, False),  # only makes the values larger
        ("CW-T030", "warning", False, False, False),  # judged beside the first test
        ("CW-T023", "warning", False, False, False),
        ("CW-T023", "warning", False, True, True),  # the uncertainty, where it decides
        ("CW-T016", "info", False, False, False),
        ("CW-T016", "error", False, False, True),
    ],
)
def test_which_findings_leave_it_undecided(
    code: str, severity: Any, *, first_had_it: bool, guarded: bool, told: bool
) -> None:
    finding = Finding(code, severity, say("as_written", text="Something."))
    first = replace(WORK.results[0], findings=(finding,) if first_had_it else ())
    after = replace(WORK.results[0], findings=(finding,))
    found = list(doubt_warnings(after, first, (), guarded=guarded))
    assert list(doubt_warnings(after, first, (finding,), guarded=guarded)) == []
    assert [entry.code for entry in found] == (["CW-V024"] if told else [])
    if told:
        assert found[0].message.startswith(
            f"With this warning about the test after loading the verdict cannot be good ({code}): Something."
        )


def measured(seed: int, *sources: Source) -> PositioningTest:
    noise = np.random.default_rng(seed).normal(0.0, 1.0 * UM, (2, TARGETS.size, 5))
    return readings_of(*noise, sources=sources)


def test_two_axes_with_one_measurement_are_both_named() -> None:
    one, other = Source("x.csv", "aa"), Source("y.csv", "bb")
    own = [AfterTest("X", measured(1, one), "x"), AfterTest("Y", measured(2, other), "y")]
    assert copied_tests(own) == {}
    same_file = [own[0], AfterTest("Y", measured(2, one), "y")]
    assert set(copied_tests(same_file)) == {"X", "Y"}
    shifted = measured(1, other)
    shifted = replace(
        shifted, positive=shifted.positive + 3.0 * UM, negative=shifted.negative + 3.0 * UM
    )
    found = copied_tests([own[0], AfterTest("Y", shifted, "y")])
    assert {name: fault.of for name, fault in found.items()} == {"X": "copied", "Y": "copied"}
    assert "Axis X and axis Y were given the same measurement" in str(found["X"].sentence)


def test_one_file_twice_within_a_test_is_a_copy_too() -> None:
    twice = AfterTest("X", measured(1, Source("x.csv", "aa"), Source("x2.csv", "aa")), "x")
    assert "The test of axis X contains one file twice" in str(copied_tests([twice])["X"].sentence)


def test_the_circle_from_before_is_no_circle_after() -> None:
    was = replace(circle_of({}).planned.test, sources=(Source("xy.b5r", "aa"),))
    same = replace(was, sources=(Source("again.b5r", "aa"),))
    (finding,) = unproven_circle(was, same, "", "xy")
    assert finding.code == "CW-V025"
    other = replace(same, sources=(Source("n", "bb"),))
    assert list(unproven_circle(was, other, "", "xy")) == []
    for first, second, codes in (
        ("2026-03-02", "2026-03-01", ["CW-V029"]),
        ("2026-03-01", "2026-03-02", []),
    ):
        dated, after = replace(was, header={"Date": first}), replace(other, header={"Date": second})
        assert [finding.code for finding in unproven_circle(dated, after, "", "xy")] == codes


def test_a_circle_of_another_machine_is_none_of_this_one() -> None:
    was = replace(circle_of({}).planned.test, sources=())
    again = replace(was, sources=(Source("n", "bb"),), header={"serial_no": "SN 12"})
    assert list(unproven_circle(was, again, "sn-12", "xy")) == []
    (finding,) = unproven_circle(was, again, "13", "xy")
    assert (finding.code, finding.values["circle"]) == ("CW-V032", "xy")


def test_a_circle_with_limits_has_to_be_measured_again_by_the_limits_of_the_run() -> None:
    limits, budget = Acceptance(limits={"G_ccw": 5.0}), CircularBudget(U=0.7)
    of = plan({}, circles={"xy": replace(circle_of({}).planned, accept=limits, budget=budget)})
    request = CircleRequest(files=("xy.csv",), name="xy", accept=limits)
    job = replace(job_of(), circles=(request,), uncertainty_circular=budget)
    assert missing(job, of, {}) == [("CW-V023.circle", {"circle": "xy"})]
    assert list(changed_limits(job, of)) == []

    looser = replace(request, accept=Acceptance(limits={"G_ccw": 9.0}))
    (limit,) = changed_limits(replace(job, circles=(looser,)), of)
    assert "the limits of circle xy were G_ccw 5, now they are G_ccw 9" in limit.message
    (declared,) = changed_limits(replace(job, uncertainty_circular=CircularBudget(U=3.0)), of)
    assert "circular tests was U 0.7, now it is U 3" in declared.message
    of = plan({}, circles={"xy": replace(circle_of({}).planned, budget=budget)})
    assert missing(job, of, {}) == []


def test_changed_values_of_others_are_counted_and_doubts_are_kept() -> None:
    entries = [{"axis": "2", "quantity": f"N1010{number}"} for number in range(5)]
    compared = {"axes": {"X": {}}, "differences": [{"axis": "X", "quantity": "own"}, *entries]}
    (found,) = read_back_findings(job_of(), compared, (), ())
    assert (found.code, found.severity) == ("CW-V011", "error")
    assert "N10100 (2), N10101 (2), N10102 (2) and 2 more. Run" in found.message
    compared["differences"] = []
    lost = Finding.of("CW-S080", "warning", files="a", axis="Y", faults=["no end"], more=0)
    assert [one.code for one in read_back_findings(job_of(), compared, [lost], ())] == ["CW-V033"]
    assert list(read_back_findings(job_of(), compared, [lost], [lost])) == []


def test_what_was_edited_after_the_run_is_said() -> None:
    def told(job: Job, of: Plan) -> list[str]:
        return [finding.message.split(": ", 1)[1] for finding in changed_limits(job, of)]

    job, planned = job_of(axis_of(), accept=LIMITS), plan({"X": axis(accept=LIMITS)})
    assert told(job, planned) == []
    (standard,) = told(replace(job, standard="iso230-2:1988"), planned)
    assert standard.startswith("the standard was iso230-2:2014, now it is iso230-2:1988.")
    (rule,) = told(job, replace(planned, decision_rule="guarded"))
    assert rule.startswith("the decision rule was guarded, now it is simple.")
    assert told(job, replace(planned, decision_rule="simple")) == []
    (limits,) = told(job_of(axis_of()), planned)
    assert limits.startswith("the limits of axis X were A 8, now they are none.")
    (axis_gone,) = told(job_of(), planned)
    assert axis_gone.startswith("the limits of axis X were A 8, now they are none.")
    named = Acceptance(limits={"A": 8.0, "E": 5.0}, test="long")
    (more,) = told(job_of(axis_of(), accept=named), planned)
    assert "now they are A 8, E 5 (test long)." in more


@pytest.mark.parametrize(
    ("verdict", "factor", "explained"),
    [
        *((name, 1.0, True) for name in ("backlash", "on_top", "one_direction", "state")),
        ("wrong_axis", 1.0, True),
        ("scaled", 2.0, True),
        ("scaled", 0.5, False),
        *((name, 1.0, False) for name in ("loaded", "not_active", "inverted", "shifted")),
        *((name, 1.0, False) for name in ("mirrored", "partial", "increment", "undecided")),
    ],
)
def test_only_too_much_compensation_explains_a_reversal_above_zero(
    verdict: LoadingName, factor: float, *, explained: bool
) -> None:
    """Half of a correction, none, or one at other places leaves lost motion, which is negative."""
    doubt = Finding("CW-T032", "warning", say("as_written", text="Something."))
    first, after = WORK.results[0], replace(WORK.results[0], findings=(doubt,))
    loading = LoadingVerdict(
        verdict=verdict, margin=9.0, factor=factor, sentence=say("as_written", text="A verdict.")
    )
    assert _without_explained_doubt(first, after, loading).findings == (
        () if explained else (doubt,)
    )
    assert _without_explained_doubt(after, after, loading).findings == (doubt,)
