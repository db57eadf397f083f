"""A job worked through: what its stages handed on, and what is to be said of all of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from compwright import __version__
from compwright.foundations.findings import Finding, doubts_of
from compwright.planning.axes import AxisWork
from compwright.planning.circles import worse_circles
from compwright.records.correction import Assumption
from compwright.records.plan import Plan
from compwright.workflow.stages.fitted import Fitted
from compwright.workflow.stages.measured import Measured
from compwright.workflow.stages.predicted import Predicted
from compwright.workflow.stages.wanted import Wanted
from compwright.workflow.stages.written import Written


@dataclass(frozen=True, slots=True)
class Finished:
    """Everything that the files of a run are made from."""

    measured: Measured
    wanted: Wanted
    fitted: Fitted
    written: Written
    predicted: Predicted

    @property
    def stated(self) -> bool:
        """Whether somebody said what is in the control now."""
        return self.measured.as_found is not None

    @property
    def works(self) -> Mapping[str, AxisWork]:
        """Every axis that was tested, with its table where it gets one."""
        return self.written.works

    @property
    def assumed(self) -> tuple[Assumption, ...]:
        """What was in no file and had to be assumed."""
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
        """What was noticed, beside the findings of each test."""
        axes = self.predicted.axes.values()
        return (
            *self.measured.job.findings,
            *(finding for state in self.measured.states.values() for finding in state.findings),
            *(finding for prediction in axes for finding in prediction.findings),
            *self.wanted.findings,
            *self.written.findings,
            *worse_circles(self.predicted.circles),
        )

    @property
    def doubts(self) -> tuple[Finding, ...]:
        """What has to be settled before the tables are loaded; findings of tests say which test
        they are of.
        """
        tests = [
            replace(finding, message=f"Axis {name}, test {result.test.name}: {finding.message}")
            for name, work in self.works.items()
            for result in work.results
            for finding in result.findings
        ]
        return doubts_of([*self.findings, *tests])

    def plan(self, results: Mapping[str, str]) -> Plan:
        """Return the plan. ``results``: the other files of the run by name, with their
        fingerprints.
        """
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
