"""A plan: all that ``export``, ``compare`` and ``verify`` need of a job, in machine coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from compwright.foundations.provenance import Source
from compwright.records.axis import Axis, AxisKind, FloatArray, Motion
from compwright.records.circular import CircularTest
from compwright.records.conditions import CircularBudget, UncertaintyBudget
from compwright.records.correction import (
    Assumption,
    AxisCompensation,
    ControlFile,
    CrossCompensation,
)
from compwright.records.estimate import ErrorEstimate, WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.job import Acceptance
from compwright.records.positioning import PositioningTest

#: What the control did at the targets of a test in + and in -, (m,) each, mm or deg.
Acted = tuple[FloatArray, FloatArray]
#: File name and bytes of a definition of one's own, then of what it extends.
Texts = tuple[tuple[str, bytes], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedTest:
    """A positioning test in a plan, with the state of the control and the motion of the axis.

    ``backlash_more``: the backlash that was active in this test minus that at the motion of the
    axis (``Axis.motion``), mm or deg. A new table does not change that difference. ``slope_std``:
    standard deviation, mm/mm, of this test's own slope relative to the other tests of its axis,
    from the uncertainty that the job declares.
    """

    test: PositioningTest
    measured_in: str
    motion: Motion = "feed"
    backlash_more: float = 0.0
    slope_std: float = 0.0
    acted: Acted | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedAxis:
    """One axis in a plan: tests, estimated error, wanted correction and fitted table.

    ``active``: the correction that was active during the first test. ``wanted``: totals before
    rounding and limits. ``fitted``: the table for the plan's own format. It is None if no table may
    be written, because the state is unknown or the table would not improve the axis.
    """

    axis: Axis
    tests: tuple[PlannedTest, ...]
    estimate: ErrorEstimate
    active: AxisCompensation | None
    wanted: WantedCorrection | None
    request: TableRequest
    fitted: FittedTable | None
    accept: Acceptance | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedCircle:
    """A circular test in a plan, with the state of the control and the centre (mm).

    ``accept``: its limits. ``budget``: the uncertainty that the job declares.
    """

    test: CircularTest
    measured_in: str
    centre: tuple[float, float]
    accept: Acceptance | None = None
    budget: CircularBudget | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedCross:
    """A planned correction of the axis ``output`` by the position of the axis ``input``.

    - ``added``: the table before the control rounds it, with the control's addresses; it is zero at
      the reference of the input axis.
    - ``source``: from circular tests (named in ``tests``) or from a cross measurement.
    - ``squareness``: the angle that the correction removes, rad, > 0 for more than 90°.
      ``std_error``: its standard error, rad, None if unknown.
    - ``written``: whether the files of the plan's own control contain the correction.
      ``typed``: whether an entry sheet contains it instead, to be typed in.
    """

    input: str
    output: str
    added: CrossCompensation
    source: Literal["circle", "cross"]
    tests: tuple[str, ...] = ()
    squareness: float = 0.0
    std_error: float | None = None
    written: bool = True
    typed: bool = False

    @property
    def delivered(self) -> bool:
        """Whether the correction is active after the steps of the card."""
        return self.written or self.typed

    @property
    def addresses(self) -> tuple[str, str]:
        """The addresses of input and output axis on the control."""
        return self.added.input, self.added.output

    @property
    def pair(self) -> frozenset[str]:
        """The two axes as a set without order, so that it does not matter which of them is
        corrected.
        """
        return frozenset({self.input, self.output})


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """The plan of a run. ``states``: the control's files by state; empty for the state ``none``.

    - ``active``: by state, the job's answer whether compensation was active.
    - ``cross``: the wanted corrections between axes, written or not. ``circles``: the circular
      tests by name. ``untested``: axes in ``cross`` that have no test of their own.
    - ``results``: the other files of the run by their relative names, with the SHA-256 of each.
      From these the next run recognises files that the user has added or changed.
    - ``decision_rule``: the rule by which the limits were decided; empty if a plan of an older
      version does not state it.
    - ``budgets``: by the kind of axis, the uncertainty that the job declared; None if an older
      version does not state it.
    - ``definition``: the text of a user's own definition and of those that it extends; empty for a
      control that is part of compwright.
    """

    version: str
    format: str
    options: Mapping[str, object]
    standard: str
    axes: Mapping[str, PlannedAxis]
    states: Mapping[str, tuple[ControlFile, ...]] = field(default_factory=dict)
    active: Mapping[str, bool] = field(default_factory=dict)
    machine: Mapping[str, str] = field(default_factory=dict)
    sources: tuple[Source, ...] = ()
    assumed: tuple[Assumption, ...] = ()
    cross: tuple[PlannedCross, ...] = ()
    circles: Mapping[str, PlannedCircle] = field(default_factory=dict)
    results: Mapping[str, str] = field(default_factory=dict)
    decision_rule: str = ""
    budgets: Mapping[AxisKind, UncertaintyBudget] | None = None
    definition: Texts = ()
    untested: Mapping[str, Axis] = field(default_factory=dict)

    @property
    def every_axis(self) -> dict[str, Axis]:
        """The axes with tests and those of corrections between axes, by name."""
        return {name: entry.axis for name, entry in self.axes.items()} | dict(self.untested)
