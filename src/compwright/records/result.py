"""The evaluation of one positioning test to one standard."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest


@dataclass(frozen=True, slots=True)
class ExpandedUncertainty:
    """Expanded uncertainty ``U`` of a parameter (mm or deg) and its coverage factor."""

    U: float
    coverage: float = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Contribution:
    """One contributor to the measurement uncertainty, in µm (rotary axes: arcsec).

    ``source``: key of the job's ``uncertainty``, followed by ``_machine`` or ``_instrument`` if it
    applies to both. The standard uncertainty ``standard`` is ``given`` (in ``unit``) divided by
    ``divisor`` and multiplied by ``sensitivity``. The divisor is 2 for an expanded uncertainty of a
    normal distribution and √12 for the range of a rectangular one. ``per``: one random draw per
    ``length`` (multiplied by the position), ``test`` or ``reading``. ``note``: how the value is
    made, or why it is not counted.
    """

    source: str
    given: float
    unit: str
    distribution: Literal["normal", "rectangular"]
    divisor: float
    sensitivity: float
    per: Literal["length", "test", "reading"]
    note: str = ""

    @property
    def standard(self) -> float:
        """The standard uncertainty, µm or arcsec."""
        return self.given / self.divisor * self.sensitivity


@dataclass(frozen=True, slots=True)
class Extreme:
    """An extreme value (mm or deg), its target, and its direction (None: mean of both)."""

    value: float
    position: float
    direction: Direction | None


@dataclass(frozen=True, slots=True, kw_only=True)
class TargetColumns:
    """The values of a positioning test at each target, as arrays (m,) in mm or deg; NaN where
    undefined.

    ``repeatability_*``: R_i. ``reversal``: B_i = mean(+) - mean(-). ``mean``: the mean of both
    directions.
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


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class PositioningResult:
    """The parameters of a positioning test by JSON name (``A``, ``E_positive``, ``B_mean``, ..., or
    those of VDI 3441), mm or deg; None if undefined.

    ``at``: the target position at which a parameter has its extreme value. ``not_applicable``: the
    reason of each None. ``coverage``: the factor k of the standard (3 or 2). ``spread``: how s was
    calculated, ``std`` or ``range``. ``extremes``: for A, E, M and R the highest and the lowest
    value, whose difference is the parameter (A, R: mean ± k s). ``budget``: the contributors behind
    ``uncertainty``.
    """

    test: PositioningTest
    standard: str
    coverage: float
    parameters: Mapping[str, float | None]
    targets: TargetColumns
    at: Mapping[str, float] = field(default_factory=dict)
    extremes: Mapping[str, tuple[Extreme, Extreme]] = field(default_factory=dict)
    uncertainty: Mapping[str, ExpandedUncertainty] | None = None
    budget: tuple[Contribution, ...] = ()
    not_applicable: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    spread: str = "std"
