"""The table fitted for a control, with the numbers that prove that no other table within its limits
is better.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.records.correction import AxisCompensation

Mode = Literal["auto", "single", "bidirectional"]
Goal = Literal["expected", "A", "E", "M"]
Gain = Literal["any", "seen"]


@dataclass(frozen=True, slots=True, kw_only=True)
class TableRequest:
    """What the job requires of a table, such as its spacing (mm or deg); all optional.

    ``spacing``: a number is the required spacing, and "auto" lets compwright choose one. None keeps
    the grid that is in the control, or chooses one if there is none. ``gain``: "any" writes every
    table that improves the axis. "seen" writes only a table whose gain exceeds the standard
    deviation of the parameter from test to test.
    """

    start: float | None = None
    end: float | None = None
    spacing: float | Literal["auto"] | None = None
    mode: Mode = "auto"
    goal: Goal = "expected"
    gain: Gain = "any"

    @property
    def named_spacing(self) -> float | None:
        """The spacing that the job states as a number, mm or deg; None if the job leaves the
        spacing to compwright.
        """
        return None if self.spacing == "auto" else self.spacing

    @property
    def keeps(self) -> bool:
        """Whether the grid of the existing table is kept, as the job states no spacing."""
        return self.spacing is None


@dataclass(frozen=True, slots=True)
class Limit:
    """A limit of the control that makes the table less accurate. ``value``: the rms error over the
    travel that this limit adds, mm or deg.
    """

    cause: str
    value: float


@dataclass(frozen=True, slots=True, kw_only=True)
class FittedTable:
    """The rounded table of an axis. ``certificate``: numbers by name that prove that no other table
    within the limits is better.

    ``mode``: single (one curve and one reversal value) or bidirectional (two curves).
    ``mode_reason``: the reason for this choice, in one sentence. ``keeps_grid``: whether the points
    are those of the existing table.
    """

    compensation: AxisCompensation
    mode: Literal["single", "bidirectional"]
    mode_reason: str
    certificate: Mapping[str, float]
    limits: tuple[Limit, ...] = ()
    findings: tuple[Finding, ...] = ()
    keeps_grid: bool = False
