"""The results of all stages of a job, with their findings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from compwright import __version__
from compwright.foundations.findings import RESULTS, Finding, doubts_of
from compwright.jobs.idle_keys import unused_acknowledgements
from compwright.planning.axis_work import AxisWork
from compwright.planning.circles import undecided_circle_findings, worse_circle_findings
from compwright.planning.doubts import Doubts, ScopedFinding, find_doubts, mark_undecided
from compwright.planning.limit_decisions import lacking_circle_guard
from compwright.records.correction import Assumption
from compwright.records.plan import Plan
from compwright.words.sentences import say
from compwright.workflow.run.estimate_stage import Wanted
from compwright.workflow.run.export_stage import Written
from compwright.workflow.run.input_stage import Measured
from compwright.workflow.run.prediction_stage import Predicted
from compwright.workflow.run.table_stage import Fitted


@dataclass(frozen=True, slots=True)
class Finished:
    """The results of all stages of a run, from which its files are made."""

    measured: Measured
    wanted: Wanted
    fitted: Fitted
    written: Written
    predicted: Predicted

    @property
    def stated(self) -> bool:
        """Whether the present contents of the control are known."""
        return self.measured.as_found is not None

    @property
    def works(self) -> Mapping[str, AxisWork]:
        """The results of every axis that has positioning tests, including its new table if the axis
        gets one.
        """
        return self.written.works

    @property
    def assumed(self) -> tuple[Assumption, ...]:
        """The values that compwright assumed because no file or job states them."""
        states = self.measured.states.values()
        capacities = [work.capacity for work in self.works.values() if work.capacity is not None]
        return (
            *self.fitted.control.assumed(*states, axes=list(self.measured.axes.values())),
            *self.measured.named,
            *(entry for state in states for entry in state.assumed),
            *(entry for capacity in capacities for entry in capacity.assumed),
        )

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings about the job, the control, the tables and the predictions; those about the
        readings of a single test are not included.
        """
        return (
            *(one.finding for one in self._noticed()),
            *unused_acknowledgements(self.doubts.unused),
        )

    @property
    def doubts(self) -> Doubts:
        """The doubts that block decisions, each with the axes that the doubt concerns."""
        return find_doubts(
            [*self._noticed(), *self._of_tests(), *self._of_circles()],
            self.measured.job.acknowledged,
            self.measured.axes,
        )

    @property
    def first(self) -> tuple[Finding, ...]:
        """The findings that are shown first: unacknowledged doubts, and important results."""
        still = (one.finding for one in self.doubts.open)
        return doubts_of([*still, *(one for one in self.findings if one.code in RESULTS)])

    def decided(self) -> Finished:
        """Return the same results, but with the decision "undecided" on all limits of an axis or
        circle that has an open doubt.
        """
        doubts = self.doubts
        axes = {
            name: replace(axis, accept=mark_undecided(axis.accept)) if doubts.about(name) else axis
            for name, axis in self.predicted.axes.items()
        }
        circles = {
            name: (
                replace(circle, accept=mark_undecided(circle.accept))
                if doubts.about_circle(name, circle.before.test.axes)
                else circle
            )
            for name, circle in self.predicted.circles.items()
        }
        return replace(self, predicted=replace(self.predicted, axes=axes, circles=circles))

    def _noticed(self) -> list[ScopedFinding]:
        """Return the findings that do not belong to a single test or circle."""
        states = self.measured.states.values()
        return [
            *map(ScopedFinding, self.measured.job.findings),
            *(self._of_control(finding) for state in states for finding in state.findings),
            *(
                ScopedFinding(finding, frozenset({name}))
                for name, prediction in self.predicted.axes.items()
                for finding in prediction.findings
            ),
            *(
                ScopedFinding(finding, frozenset(finding.axes) or None)
                for finding in self.wanted.findings
            ),
            *map(ScopedFinding, self.written.findings),
            *map(self._of_control, self.predicted.findings),
            *map(ScopedFinding, worse_circle_findings(self.predicted.circles)),
            *map(ScopedFinding, undecided_circle_findings(self.predicted.circles)),
            *(
                ScopedFinding(finding, frozenset(circle.before.test.axes), name)
                for name, circle in self.predicted.circles.items()
                for finding in lacking_circle_guard(name, circle.accept)
            ),
        ]

    def _of_control(self, finding: Finding) -> ScopedFinding:
        """Return a finding about the control's files, with the axes of the job that it concerns.

        One finding is no doubt if no table is made: that no file contains an axis' own table. The
        existing compensation then stays.
        """
        own = frozenset(
            name
            for name, axis in self.measured.axes.items()
            if {axis.address, axis.gantry} & set(finding.axes)
        )
        if finding.code == "CW-S008" and own and own.isdisjoint({*self.works, *self.fitted.scales}):
            finding = replace(finding, severity="info")
        return ScopedFinding(finding, own or None)

    def _of_tests(self) -> list[ScopedFinding]:
        return [
            ScopedFinding(
                replace(
                    finding,
                    sentence=say(
                        "of_test", axis=name, test=result.test.name, finding=finding.sentence
                    ),
                ),
                frozenset({name}),
            )
            for name, work in self.works.items()
            for result in work.results
            for finding in result.findings
        ]

    def _of_circles(self) -> list[ScopedFinding]:
        """Return the findings about circular tests. Each names those axes of the circle that the
        job corrects from circular tests.
        """
        apply = self.measured.job.apply
        taking = {*apply.squareness.values(), *apply.scale}
        if apply.backlash_from == "circle":
            taking |= self.works.keys()
        return [
            ScopedFinding(
                replace(
                    finding,
                    sentence=say("of_circle", circle=work.name, finding=finding.sentence),
                ),
                frozenset(taking & set(work.result.test.axes)),
                work.name,
            )
            for work in self.wanted.circles
            for finding in work.result.findings
        ]

    def plan(self, results: Mapping[str, str]) -> Plan:
        """Return the plan. ``results``: the SHA-256 of each other file of the run, by file name."""
        job, inputs, circles = self.measured.job, self.measured.inputs, self.wanted.circles
        read = [
            *(entry.test.sources for tests in inputs.tests.values() for entry in tests),
            *(work.planned.test.sources for work in circles),
            job.sources,
        ]
        axes = {name: work.planned for name, work in self.works.items()} | self.fitted.scales
        crossing = {name for entry in self.written.cross.planned for name in entry.pair}
        return Plan(
            version=__version__,
            format=job.format,
            definition=self.measured.control.definition.carried,
            options=self.fitted.control.options,
            standard=job.standard,
            decision_rule=job.decision_rule,
            budgets=job.budgets,
            axes=axes,
            untested={name: job.axes[name].axis for name in job.axes if name in crossing - {*axes}},
            states={name: decoded.files for name, decoded in inputs.states.items()},
            active={name: job.active[name] for name in inputs.states if name in job.active},
            machine=job.machine,
            sources=tuple(source for sources in read for source in sources),
            assumed=self.assumed,
            cross=self.written.cross.planned,
            circles={work.name: work.planned for work in circles},
            results=results,
        )
