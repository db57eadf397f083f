"""A plan: everything that export, compare and verify need without the job. mm or deg, machine coordinates."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.foundations.provenance import Source
from compwright.records.axis import Axis
from compwright.records.correction import Assumption, AxisCompensation, ControlFile
from compwright.records.estimate import ErrorEstimate, WantedCorrection
from compwright.records.fitted import FittedTable, TableRequest
from compwright.records.job import Acceptance
from compwright.records.positioning import PositioningTest


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedTest:
    """A test as it went into the plan (machine coordinates), and the name of the state that was active."""

    test: PositioningTest
    measured_in: str


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedAxis:
    """One axis of a plan.

    ``active``: what the control did while the first test was measured. ``wanted``: totals before rounding and limits. ``fitted``:
    the table for the plan's own format; None where none may be written (the state is not known, or it would not improve the axis).
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
class Plan:
    """The plan. ``states`` holds the control's own files byte by byte: None where the job did not say, empty for ``none``."""

    version: str
    format: str
    options: Mapping[str, object]
    standard: str
    axes: Mapping[str, PlannedAxis]
    states: Mapping[str, tuple[ControlFile, ...]] = field(default_factory=dict)
    machine: Mapping[str, str] = field(default_factory=dict)
    sources: tuple[Source, ...] = ()
    assumed: tuple[Assumption, ...] = ()
