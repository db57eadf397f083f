"""Requirements of a verification in addition to the limits: the right plan, tests of all planned
axes, and credible tests.

The plan must belong to this job, every planned axis must be measured, and the tests must be strong
enough as evidence. Findings of the evaluation follow a rule (``docs/commands.md``, "What good
needs"):

- A warning about the readings of the test after loading makes the verdict undecided.
- A warning about how the test was planned does so if the first test did not have this warning.
- A warning that can only increase the values (drift, an outlying traverse or reading) does not
  change the verdict.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from itertools import combinations
from pathlib import Path
from typing import Any, Final, TypeVar

from compwright.evaluation.duplicate_measurements import NamedTest, same_measurement
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import share_a_file
from compwright.records.circular import CircularResult, CircularTest
from compwright.records.conditions import CircularBudget, UncertaintyBudget
from compwright.records.job import Job
from compwright.records.plan import Plan
from compwright.records.positioning import PositioningTest
from compwright.records.result import PositioningResult
from compwright.verification.measurement_faults import NamedFault, copied_scatter, origin_findings
from compwright.words.sentences import say

#: Warnings that only say that values are larger than those of a quiet machine, or that an
#: assumption was stated: they leave the verdict.
_HARMLESS: Final = frozenset({"CW-T012", "CW-T013", "CW-T014", "CW-T022"})
#: The size of the readings is compared with the first test's (`verification.measurement_faults`),
#: which decides better than the test alone.
_COMPARED_WITH_FIRST: Final = frozenset({"CW-T030"})
#: Doubts, and these warnings about the readings, count whether or not the first test had them too.
#: All others count where it had not.
_OF_READINGS: Final = frozenset({"CW-R006", "CW-T010", "CW-T015", "CW-T016"})
#: Warnings about the uncertainty count only where it decides.
_OF_UNCERTAINTY: Final = frozenset({"CW-T023"})
#: A circle repeats another one if radius and feed agree within these parts of their values, and the
#: ends of an arc within these degrees. Bars have fixed lengths, a feed is set in steps of 10 %.
SAME_RADIUS: Final = 0.01
_SAME_FEED, _SAME_ARC = 0.05, 5.0
#: Changed values outside of the plan that are named; of the others the number is given.
_MOST_NAMED: Final = 3


@dataclass(frozen=True, slots=True)
class AfterTest:
    """A test after loading: its axis, the name of the earlier test that it repeats, its files, and
    the mapping profile of the files.
    """

    axis: str
    test: PositioningTest
    repeats: str
    files: tuple[Path, ...] = ()
    profile: Path | None = None


def changed_limits(job: Job, plan: Plan) -> Iterator[Finding]:
    """Yield the finding CW-V022 if limits, standard, decision rule or declared uncertainty changed
    since the run.

    The uncertainty is compared because one that is declared after the measurement could explain any
    slope.
    """
    if job.standard != plan.standard:
        yield _changed("standard", plan.standard, job.standard)
    if plan.decision_rule and job.decision_rule != plan.decision_rule:
        yield _changed("rule", plan.decision_rule, job.decision_rule)
    yield from _changed_budgets(job, plan)
    for name, entry in plan.axes.items():
        mine = job.axes[name].accept if name in job.axes else None
        if mine != entry.accept:
            yield _changed("axis_limits", _limits(entry.accept), _limits(mine), name)
    yield from _changed_circles(job, plan)


def _changed_circles(job: Job, plan: Plan) -> Iterator[Finding]:
    limits = {request.name: request.accept for request in job.circles}
    for name, circle in plan.circles.items():
        if limits.get(name) != circle.accept:
            yield _changed("circle_limits", _limits(circle.accept), _limits(limits.get(name)), name)
    budgets = {circle.budget for circle in plan.circles.values() if circle.accept is not None}
    for was_budget in budgets - {job.uncertainty_circular}:
        was, now = (
            _budget(was_budget, job.uncertainty_circular),
            _budget(job.uncertainty_circular, was_budget),
        )
        yield _changed("circle_uncertainty", was, now)


def _changed_budgets(job: Job, plan: Plan) -> Iterator[Finding]:
    for kind in {axis.axis.kind: None for axis in plan.axes.values()}:
        if plan.budgets is None:
            return
        was, now = plan.budgets.get(kind), job.budget(kind)
        if was != now:
            yield _changed("uncertainty", _budget(was, now), _budget(now, was), kind.value)


_Budget = TypeVar("_Budget", UncertaintyBudget, CircularBudget)


def _budget(one: _Budget | None, other: _Budget | None) -> str:
    """Return, as text, the values in which the uncertainty budget ``one`` differs from the budget
    ``other``.
    """
    if one is None:
        return ""
    other_values = asdict(other or type(one)())
    parts = [
        f"{name} {value:g}" for name, value in asdict(one).items() if value != other_values[name]
    ]
    return ", ".join(parts)


def _limits(accept: Any) -> str:
    if accept is None:
        return ""
    parts = ", ".join(f"{key} {value:g}" for key, value in accept.limits.items())
    return f"{parts} (test {accept.test})" if accept.test else parts


def _changed(what: str, was: str, now: str, of: str = "") -> Finding:
    several = what in ("axis_limits", "circle_limits")
    return Finding.of("CW-V022", "warning", what=what, of=of, was=was, now=now, several=several)


# ---------------------------------------------------------------- what has to be there


def not_measured(
    job: Job,
    plan: Plan,
    axes: Mapping[str, str],
    circles: Mapping[str, CircularTest],
    scales: Collection[str],
) -> Iterator[Finding]:
    """Yield the finding CW-V023 for each planned or limited axis or circle that was not measured
    after loading.

    ``axes``: the measured axes, each with the name of the test that was repeated. ``circles``: the
    circular tests after loading, by the name of the tests before. ``scales``: axes whose scale
    these circles show.
    """
    for name, entry in plan.axes.items():
        limited = name in job.axes and job.axes[name].accept is not None
        if entry.tests and name not in axes and (entry.fitted is not None or limited):
            test = _limited_test(job, name) or entry.tests[0].test.name
            yield Finding.of("CW-V023.axis", "warning", axis=name, test=test)
        elif name in axes and limited:
            meant, was = _limited_test(job, name), axes[name]
            if meant != was:
                yield Finding.of("CW-V023.test", "warning", axis=name, meant=meant, measured=was)
    for name, circle in plan.circles.items():
        if circle.accept is not None and name not in circles:
            yield Finding.of("CW-V023.circle", "warning", circle=name)
    yield from _circles_missing(plan, circles, scales)


def _circles_missing(
    plan: Plan, circles: Mapping[str, CircularTest], scales: Collection[str]
) -> Iterator[Finding]:
    """Yield a finding for each scale error or squareness that was corrected from circles but that
    no circle after loading shows.
    """
    for name, entry in plan.axes.items():
        if not entry.tests and entry.fitted is not None and name not in scales:
            yield Finding.of("CW-V023.scale", "warning", axis=name, circles=_circles(plan, {name}))
    for cross in plan.cross:
        measured = any(cross.pair == frozenset(plan.circles[name].test.axes) for name in circles)
        if cross.delivered and cross.source == "circle" and not measured:
            yield Finding.of(
                "CW-V023.squareness",
                "warning",
                plane="".join(sorted(cross.pair)),
                circles=_circles(plan, set(cross.pair)),
            )


def _limited_test(job: Job, axis: str) -> str | None:
    """Return the name of the test to which the limits of an axis apply, or None if the axis has no
    limits.
    """
    entry = job.axes.get(axis)
    if entry is None or entry.accept is None:
        return None
    return entry.accept.test or entry.before[0].name


def _circles(plan: Plan, axes: set[str]) -> list[str]:
    return [name for name, circle in plan.circles.items() if axes <= set(circle.test.axes)]


def doubts_after(after: PositioningResult | CircularResult) -> tuple[Finding, ...]:
    """Return those findings about the readings of a test after loading that are doubts, without
    those that come from the comparison with the first test.
    """
    return tuple(
        finding
        for finding in after.findings
        if finding.is_doubt and finding.code not in _COMPARED_WITH_FIRST
    )


def doubt_warnings(
    after: PositioningResult | CircularResult,
    before: PositioningResult | CircularResult,
    acknowledged: Collection[Finding],
    *,
    guarded: bool,
) -> Iterator[Finding]:
    """Yield a warning (CW-V024) for each finding on the test ``after`` loading that makes the
    verdict undecided. Left out are ``acknowledged`` findings and, unless limits are decided with
    guard bands (``guarded``), those about uncertainty.
    """
    had = {finding.code for finding in before.findings}
    for finding in after.findings:
        code = finding.code
        if (
            finding.severity == "info"
            or finding in acknowledged
            or code in _HARMLESS | _COMPARED_WITH_FIRST
            or (code in _OF_UNCERTAINTY and not guarded)
        ):
            continue
        if finding.is_doubt or code in _OF_READINGS or code not in had:
            yield Finding.of("CW-V024", "warning", code=code, finding=finding.sentence)


# ---------------------------------------------------------------- measurements given twice


def copied_tests(tests: Iterable[AfterTest]) -> dict[str, NamedFault]:
    """Return, by axis, the fault of each test that contains one file twice, or is the same
    measurement as the test of another axis.
    """
    every = tuple(tests)
    found = {
        entry.axis: NamedFault("copied", say("CW-V026.file_twice", axis=entry.axis))
        for entry in every
        if len({source.sha256 for source in entry.test.sources}) < len(entry.test.sources)
    }
    for one, other in combinations(every, 2):
        same = same_measurement(
            *(NamedTest(entry.axis, entry.test.sources, entry.test) for entry in (one, other))
        )
        if same or copied_scatter(one.test, other.test) is not None:
            sentence = say("CW-V026.two_axes", axis=one.axis, other=other.axis)
            found |= {entry.axis: NamedFault("copied", sentence) for entry in (one, other)}
    return found


def unproven_circle(
    first: CircularTest, after: CircularTest, serial: str, name: str
) -> Iterator[Finding]:
    """Yield a finding if the test ``after`` loading of the circle ``name`` has the same file as the
    ``first`` test (CW-V025), is older (CW-V029), or is of another machine than that with the
    ``serial`` number of the job (CW-V032): nothing is decided by it.
    """
    if share_a_file(first.sources, after.sources):
        yield Finding.of("CW-V025", "warning", circle=name)
    yield from origin_findings(after, first, serial, name)


def other_circle(
    first: CircularTest, after: CircularTest, name: str, *, limited: bool
) -> Iterator[Finding]:
    """Yield the finding CW-V034 if the test ``after`` loading of the circle ``name`` has another
    radius, feed or arc than the ``first`` test: a warning if the circle is ``limited``.

    Deviations depend on all three, so that they are not compared with the prediction, and limits
    are not decided by such a test. Its squareness is an angle, and remains comparable.
    """
    what = []
    if abs(after.nominal_radius - first.nominal_radius) > SAME_RADIUS * first.nominal_radius:
        what.append(say("CW-V034.radius", now=after.nominal_radius, was=first.nominal_radius))
    if abs(after.feed - first.feed) > _SAME_FEED * first.feed:
        what.append(say("CW-V034.feed", now=after.feed, was=first.feed))
    (start, extent), (was_start, was_extent) = after.arc, first.arc
    turned = abs((start - was_start + 180.0) % 360.0 - 180.0)
    both_full = after.full_circle and first.full_circle
    if not both_full and max(turned, abs(extent - was_extent)) > _SAME_ARC:
        what.append(
            say(
                "CW-V034.arc",
                start=start,
                end=start + extent,
                was_start=was_start,
                was_end=was_start + was_extent,
            )
        )
    if what:
        yield Finding.of(
            "CW-V034", "warning" if limited else "info", circle=name, what=what, limits=limited
        )


# ---------------------------------------------------------------- what was read back


def outside_of_tables(compared: Mapping[str, Any]) -> set[str]:
    """Return the addresses with differences in the document of `compare` whose axis has no table of
    its own in the plan.
    """
    return {one["axis"] for one in compared["differences"]} - set(compared["axes"])


def read_back_findings(
    job: Job,
    compared: Mapping[str, Any],
    doubts: Iterable[Finding],
    known: Collection[Finding],
) -> Iterator[Finding]:
    """Yield what the document ``compared`` of `compare` shows beyond the axis tables of the plan:
    another axis, or a table between axes, was changed while loading (CW-V011), or the files read
    back leave ``doubts`` (CW-V033) that are not ``known`` and not those of each axis.
    """
    outside = outside_of_tables(compared)
    entries = [one for one in compared["differences"] if one["axis"] in outside]
    if entries:
        found = list(dict.fromkeys(f"{one['quantity']} ({one['axis']})" for one in entries))
        more = max(len(found) - _MOST_NAMED, 0)
        yield Finding.of("CW-V011.others", "error", entries=found[:_MOST_NAMED], more=more)
    left = [
        one.sentence
        for one in doubts
        if one not in known
        and not (one.is_doubt and not one.axes)
        and not any(job.acknowledgement(one.code, axis) for axis in one.axes)
    ]
    if left:
        yield Finding.of("CW-V033", "warning", doubts=left)
