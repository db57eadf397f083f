"""The prediction of the next test."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.records.circular import CircularResult
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import AxisPeriod, PeriodEvidence
from compwright.records.limits import LimitingCauses, PointCountOption
from compwright.records.result import ExpandedUncertainty, PositioningResult

Decision = Literal["accept", "reject", "undecided"]


@dataclass(frozen=True, slots=True)
class Quantiles:
    """Median and 5 and 95 % quantiles of a predicted parameter, mm or deg."""

    median: float
    p05: float
    p95: float


@dataclass(frozen=True, slots=True, kw_only=True)
class TestPrediction:
    """A positioning test of an axis, and two predictions of a new test: at the same targets, and at
    new targets.

    ``uncertainty``: that of the parameters of the new test at the same targets, if it is needed as
    guard band of a decision.
    """

    name: str
    before: PositioningResult
    predicted: Mapping[str, Quantiles]
    predicted_new_targets: Mapping[str, Quantiles]
    uncertainty: Mapping[str, ExpandedUncertainty] | None = None

    __test__ = False  # not a test class, whatever the name suggests to a collector


@dataclass(frozen=True, slots=True, kw_only=True)
class AcceptDecision:
    """The decision about a limit of the job. ``limit``, ``value`` and ``U`` in µm or arcsec.

    ``rule``: the decision rule. ``test``: the name of the test to which the limit applies, if the
    job names one; else the limit applies to the first test of the axis.
    """

    limit: float
    decision: Decision
    value: float | None = None
    U: float | None = None
    test: str | None = None
    rule: Literal["simple", "guarded"] = "simple"


@dataclass(frozen=True, slots=True, kw_only=True)
class CirclePrediction:
    """A circular test, its result recalculated with the new tables, and the prediction of a new
    test.

    ``predicted``: parameters by their JSON names, mm. ``causes``: by their JSON names, in the units
    of the JSON.
    """

    before: CircularResult
    expected: CircularResult
    predicted: Mapping[str, Quantiles]
    causes: Mapping[str, Quantiles]
    accept: Mapping[str, AcceptDecision] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisPrediction:
    """The prediction of one axis. ``table``: its new table as read from the written files, None if
    the axis gets no table.

    ``limits``: the causes that limit the axis with the new table. ``worth``: the parameter that
    ``limits`` names, by number of table points. ``periods``: the periods of the axis' error, known
    and found. ``evidence``: the evidence from the search for periods; None if there was no search.
    """

    tests: tuple[TestPrediction, ...]
    table: AxisCompensation | None
    quantum: float | None
    limits: LimitingCauses | None = None
    worth: tuple[PointCountOption, ...] = ()
    accept: Mapping[str, AcceptDecision] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    periods: tuple[AxisPeriod, ...] = ()
    evidence: PeriodEvidence | None = None
