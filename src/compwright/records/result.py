"""The evaluation of one positioning test to one standard."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.positioning import PositioningTest


@dataclass(frozen=True, slots=True)
class ExpandedUncertainty:
    """Expanded uncertainty ``U`` of a parameter (mm or deg) and its coverage factor."""

    U: float
    coverage: float = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetColumns:
    """What the standard tabulates per target, arrays (m,) in mm or deg; NaN where it does not
    apply.

    ``repeatability_*`` are R_i; ``reversal`` is B_i = mean(+) - mean(-); ``mean`` is the mean of
    both directions.
    """

    mean_positive: FloatArray
    mean_negative: FloatArray
    s_positive: FloatArray
    s_negative: FloatArray
    reversal: FloatArray
    mean: FloatArray
    repeatability_positive: FloatArray
    repeatability_negative: FloatArray
    repeatability: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class PositioningResult:
    """Parameters by their contract names (``A``, ``E_positive``, ``B_mean``, ... or VDI's own), mm
    or deg, None where not defined.

    ``at`` gives the target position at which a parameter takes its extreme; ``not_applicable`` the
    reason of each None. ``coverage`` is the factor k of the standard (3 or 2); ``spread`` says how
    s was formed: ``std`` or ``range``.
    """

    test: PositioningTest
    standard: str
    coverage: float
    parameters: Mapping[str, float | None]
    targets: TargetColumns
    at: Mapping[str, float] = field(default_factory=dict)
    uncertainty: Mapping[str, ExpandedUncertainty] | None = None
    not_applicable: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    spread: str = "std"
