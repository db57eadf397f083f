"""A job: what the engineer states and requires. Paths are text as written.

The package ``workflow`` makes them paths relative to the job's folder.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source
from compwright.records.axis import Axis, AxisKind, Motion, PositionMap
from compwright.records.conditions import CircularBudget, Thermal, UncertaintyBudget
from compwright.records.drift import DriftRequest
from compwright.records.environment import Environment, EnvironmentRequest
from compwright.records.fitted_table import TableRequest
from compwright.words.sentences import Language

#: The value of a state that says "nothing is active in the control".
NONE_STATE: tuple[str, ...] = ()
#: The state that is in the control now.
AS_FOUND = "as_found"


@dataclass(frozen=True, slots=True, kw_only=True)
class TestRequest:
    """One positioning test of an axis: its files, name, state of the control and motion.

    ``thermal``: its differential expansion. The test's own keys override those of the axis, and
    these override those of the job. ``own_temperatures``: those of ``T_m`` and ``T_d`` that the
    test's own keys state; the values in its files are then ignored. ``environment``: the
    environment record that corrects each reading.
    """

    files: tuple[str, ...]
    name: str
    measured_in: str = "as_found"
    position_map: PositionMap = PositionMap()
    motion: Motion = "feed"
    thermal: Thermal | None = None
    own_temperatures: tuple[str, ...] = ()
    environment: Environment | None = None
    profile: str | None = None

    __test__ = False  # not a test class, whatever the name suggests to a collector


@dataclass(frozen=True, slots=True, kw_only=True)
class Acceptance:
    """Limits by parameter in µm or arcsec. ``test``: the test to which the limits apply (None: the
    first test).
    """

    limits: Mapping[str, float]
    test: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleRequest:
    """One circular test: its file, or a file per run, its name, and the state of the control.

    ``centre``: machine coordinates, mm, of the two axes of the plane in their order, or of X, Y and
    Z; None if not given. ``accept``: limits in µm.
    """

    files: tuple[str, ...]
    name: str
    measured_in: str = "as_found"
    centre: tuple[float, ...] | None = None
    accept: Acceptance | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossRequest:
    """Measured deviations (k,) of the axis ``output`` at positions (k,) of the axis ``input``."""

    input: str
    output: str
    positions: tuple[float, ...]
    deviations: tuple[float, ...]
    measured_in: str = "as_found"


@dataclass(frozen=True, slots=True, kw_only=True)
class ApplyRequest:
    """What the job corrects from circular tests: squareness (for each plane the axis that is
    corrected), the scale of axes, and backlash.
    """

    squareness: Mapping[str, str] = field(default_factory=dict)
    scale: tuple[str, ...] = ()
    backlash_from: Literal["positioning", "circle"] = "positioning"


def other_axis(plane: str, bent: str) -> str:
    """Return the other axis of a plane, such as X for plane ``XY`` and axis ``Y``."""
    return plane.removesuffix(bent) if plane.endswith(bent) else plane.removeprefix(bent)


@dataclass(frozen=True, slots=True, kw_only=True)
class Acknowledgement:
    """A doubt that the job acknowledges, with code, reason and axis (None: every axis)."""

    code: str
    reason: str
    axis: str | None = None


@dataclass(frozen=True, slots=True)
class Acknowledged:
    """A doubt that was found, with the job's acknowledgement."""

    finding: Finding
    by: Acknowledgement


@dataclass(frozen=True, slots=True)
class Logo:
    """The logo of a report: its media type and its bytes."""

    type: str
    content: bytes


@dataclass(frozen=True, slots=True, kw_only=True)
class ReportHead:
    """The language of reports, and the job's entries for the head of a report."""

    language: Language = "en"
    number: str | None = None
    customer: str | None = None
    operator: str | None = None
    place: str | None = None
    logo: str | None = None
    image: Logo | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisJob:
    """What the job requires for one axis. ``before``: the positioning tests of the axis; empty if
    it has none.

    ``thermal``: the differential expansion of the axis; its own keys override those of the job.
    ``stated``: those of ``reference`` and ``reference_return`` that the job itself gives.
    """

    axis: Axis
    before: tuple[TestRequest, ...]
    table: TableRequest = TableRequest()
    accept: Acceptance | None = None
    thermal: Thermal | None = None
    stated: frozenset[str] = field(default=frozenset(), compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Job:
    """All that a job file states. ``states``: the control files of each state, such as as_found.

    - ``active``: for a state whose files do not show whether compensation was active, or switch it
      off, the answer of the job. A state that is not in it has no answer.
    - ``options``: the options of the controller. An axis' own options are in ``axis.options`` and
      override them.
    - ``drifts``: stand-still tests by the kind of axis, from which E_VE is calculated.
      ``environment``: a record of air and material.
    - ``sources``: the files from which the job's own values are taken.
    - ``findings``: about the job itself, such as keys without effect.
    """

    file: str
    format: str
    axes: Mapping[str, AxisJob]
    options: Mapping[str, object] = field(default_factory=dict)
    states: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    active: Mapping[str, bool] = field(default_factory=dict)
    machine: Mapping[str, str] = field(default_factory=dict)
    fixed_positions: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    uncertainty: UncertaintyBudget | None = None
    uncertainty_rotary: UncertaintyBudget | None = None
    uncertainty_circular: CircularBudget | None = None
    drifts: Mapping[AxisKind, DriftRequest] = field(default_factory=dict)
    environment: EnvironmentRequest | None = None
    sources: tuple[Source, ...] = ()
    thermal: Thermal | None = None
    decision_rule: Literal["simple", "guarded"] = "simple"
    proven: tuple[Mapping[str, str], ...] = ()
    standard: str = "iso230-2:2014"
    report: ReportHead = ReportHead()
    circles: tuple[CircleRequest, ...] = ()
    cross: tuple[CrossRequest, ...] = ()
    apply: ApplyRequest = ApplyRequest()
    acknowledged: tuple[Acknowledgement, ...] = ()
    findings: tuple[Finding, ...] = ()

    def budget(self, kind: AxisKind) -> UncertaintyBudget | None:
        """Return the uncertainty contributors for linear (µm) or for rotary axes (arcsec)."""
        return self.uncertainty_rotary if kind is AxisKind.ROTARY else self.uncertainty

    @property
    def budgets(self) -> dict[AxisKind, UncertaintyBudget]:
        """The contributors to uncertainty that the job states, by kind of axis."""
        every = {kind: self.budget(kind) for kind in AxisKind}
        return {kind: budget for kind, budget in every.items() if budget is not None}

    def acknowledgement(self, code: str, axis: str) -> Acknowledgement | None:
        """Return the job's acknowledgement of a doubt about an axis, or None."""
        given = (each for each in self.acknowledged if each.code == code)
        return next((each for each in given if each.axis in (None, axis)), None)

    def with_environment(self, record: Environment, T_m: float | None) -> Job:
        """Return the job with the environment record that corrects its tests of linear axes.
        ``T_m``: the mean material temperature (°C) in the record, for tests without a stated one.
        """

        def known(thermal: Thermal | None) -> Thermal | None:
            if thermal is None or T_m is None or not math.isnan(thermal.T_m):
                return thermal
            return replace(thermal, T_m=T_m)

        axes = {
            name: entry
            if entry.axis.kind is AxisKind.ROTARY
            else replace(
                entry,
                thermal=known(entry.thermal),
                before=tuple(
                    replace(test, thermal=known(test.thermal), environment=record)
                    for test in entry.before
                ),
            )
            for name, entry in self.axes.items()
        }
        return replace(self, axes=axes, thermal=known(self.thermal))

    def with_variation(self, kind: AxisKind, E_VE: float) -> Job:
        """Return the job with an environmental variation E_VE (µm, arcsec) of a kind of axis."""
        budget = replace(self.budget(kind) or UncertaintyBudget(), E_VE=E_VE)
        if kind is AxisKind.ROTARY:
            return replace(self, uncertainty_rotary=budget)
        return replace(self, uncertainty=budget)
