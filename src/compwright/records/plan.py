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
from compwright.records.fitted import FittedTable, TableRequest
from compwright.records.job import Acceptance
from compwright.records.positioning import PositioningTest

#: What the control did at the targets of a test in + and in -, (m,) each, mm or deg.
Acted = tuple[FloatArray, FloatArray]
#: File name and bytes of a definition of one's own, then of what it extends.
Texts = tuple[tuple[str, bytes], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedTest:
    """A positioning test in a plan, with the state of the control and the motion of the axis.

    ``backlash_more``: the backlash that was active in it minus that at the motion of the axis
    (``Axis.motion``), mm or deg; a new table leaves that difference. ``slope_std``: standard
    deviation, mm/mm, of this test's own slope relative to others of its axis, by the uncertainty
    that the job declares.
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
    rounding and limits. ``fitted``: the table for the plan's own format; None if none may be
    written (the state is not known, or it would not improve the axis).
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

    ``accept``, ``budget``: its limits and what the job declared of uncertainty.
    """

    test: CircularTest
    measured_in: str
    centre: tuple[float, float]
    accept: Acceptance | None = None
    budget: CircularBudget | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedCross:
    """A planned correction of the axis ``output`` by the position of the axis ``input``.

    ``added``: the table before the control rounds it, by the control's addresses, zero at the
    reference of the input axis. ``source``: from circular tests (``tests`` names them) or from a
    cross measurement. ``squareness``: the angle that it removes, rad, > 0 for more than 90°;
    ``std_error`` of it, rad, None if unknown. ``written``: the plan's own control holds it.
    """

    input: str
    output: str
    added: CrossCompensation
    source: Literal["circle", "cross"]
    tests: tuple[str, ...] = ()
    squareness: float = 0.0
    std_error: float | None = None
    written: bool = True

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

    ``active``: by state, the job's answer whether compensation was active. ``cross``: what is
    wanted between axes, written or not; ``circles``: the circular tests by name. ``results``: the
    other files of the run by their relative names, with the SHA-256 of each: by it the next run
    tells them from what the user has put or changed there. ``decision_rule``: how the limits were
    decided; empty where the plan of an older version does not say. ``budgets``: what the job
    declared of uncertainty by the kind of axis; None where an older version does not say.
    ``definition``: of one's own, its text and what it extends; empty for a control that ships.
    ``untested``: axes without a test of their own that ``cross`` names.
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
