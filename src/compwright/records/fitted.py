"""The table that a control will hold, with the proof that it is the best under the control's
limits.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.records.correction import AxisCompensation

Mode = Literal["auto", "single", "bidirectional"]
Goal = Literal["expected", "A", "E", "M"]


@dataclass(frozen=True, slots=True, kw_only=True)
class TableRequest:
    """What the job asks of the grid, mm or deg: all optional. ``spacing`` None is automatic."""

    start: float | None = None
    end: float | None = None
    spacing: float | None = None
    mode: Mode = "auto"
    goal: Goal = "expected"


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit of the control that costs accuracy, and how much: ``value`` in mm or deg."""

    cause: str
    value: float


@dataclass(frozen=True, slots=True, kw_only=True)
class FittedTable:
    """``compensation``: the rounded table as the control will hold it. ``certificate``: numbers
    that prove the fit, by name.

    ``mode`` is the choice made (single: one curve and one reversal value; bidirectional),
    ``mode_reason`` why in one sentence.
    """

    compensation: AxisCompensation
    mode: Literal["single", "bidirectional"]
    mode_reason: str
    certificate: Mapping[str, float]
    limits: tuple[Limit, ...] = ()
    findings: tuple[Finding, ...] = ()
