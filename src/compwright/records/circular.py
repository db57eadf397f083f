"""A circular test (ISO 230-4, clause 4) in both directions, and its evaluation."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source
from compwright.records.axis import FloatArray
from compwright.records.correction_need import correction_need, shortfall
from compwright.records.result import ExpandedUncertainty
from compwright.words.sentences import Sentence

Sense = Literal["ccw", "cw"]

#: The shortest arc of a circular test, deg. ISO 230-4:1996, 3.1 asks for at least 90°. Readings at
#: its ends can be missing, where the machine starts and stops.
SHORTEST_ARC: Final = 89.0

#: Parameters by their contract names, in its order.
CIRCULAR_NAMES: Final = (
    *("G_ccw", "G_cw", "G_bidirectional", "G_ccw_lsc", "G_cw_lsc", "G_bidirectional_lsc", "H", "D"),
    *(
        "F_max_ccw",
        "F_min_ccw",
        "F_max_cw",
        "F_min_cw",
        "F_max_ccw_lsc",
        "F_min_ccw_lsc",
        "F_max_cw_lsc",
        "F_min_cw_lsc",
    ),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class CircularRun:
    """One run over the circle or arc, without overshoot.

    ``angles`` (n,) deg: commanded polar angle, from the first axis to the second in both
    directions, in the order in which the samples were measured. It ascends for ``ccw`` (motion from
    the first axis to the second) and descends for ``cw``; it may be above 360 or below 0.
    ``deviations`` (n,) mm: measured distance from the set-up centre minus the nominal radius.
    """

    sense: Sense
    angles: FloatArray
    deviations: FloatArray
    number: int = 1


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class CircularTest:
    """A circular test in one plane. Lengths in mm, ``feed`` in mm/min along the path, angles in
    deg.

    ``axes``: first and second axis, in the order of the plane. ``arc``: the least angle of the arc
    (0 <= start < 360) and its extent (at most 360). ``calibrated``: whether the length of the bar
    was calibrated, so that radii are absolute. ``centre``: the position of the circle in the
    machine, if the file states it. ``vendor``: results printed in the file, by run and name,
    unchanged.
    """

    name: str
    plane: str
    axes: tuple[str, str]
    nominal_radius: float
    feed: float
    arc: tuple[float, float]
    calibrated: bool
    runs: tuple[CircularRun, ...]
    centre: tuple[float, ...] | None = None
    vendor: Mapping[str, object] = field(default_factory=dict)
    sources: tuple[Source, ...] = ()
    header: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()

    def __repr__(self) -> str:
        """Return the plane, radius, feed, arc, numbers of runs and the range with units."""
        values = [1000.0 * each for run in self.runs for each in (*run.deviations,)]
        span = f"{min(values):.2f} to {max(values):.2f} µm" if values else "no reading"
        return (
            f"CircularTest({self.name!r}: plane {self.plane}, radius {self.nominal_radius:g} mm, "
            f"feed {self.feed:g} mm/min, arc {self.arc[1]:g} deg, runs ccw {len(self.of('ccw'))} "
            f"cw {len(self.of('cw'))}, deviations {span})"
        )

    def of(self, sense: Sense) -> tuple[CircularRun, ...]:
        """Return the runs of one direction in the order of their numbers."""
        return tuple(run for run in self.runs if run.sense == sense)

    @property
    def full_circle(self) -> bool:
        """Whether the test covers the whole circle."""
        return self.arc[1] >= 360.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CircularEffect:
    """One cause of the deviations in a circular test, with its value and its effect in µm.

    ``share``: ``effect`` divided by the sum of all effects. ``low``: lower end of a one-sided 95 %
    interval if the value cannot be negative; else None. ``more``: further values of the cause, by
    JSON name (``frequency`` Hz of a vibration, ``period`` mm and ``phase`` deg of a cyclic error,
    ``decay`` ms, ``rise`` ms and ``raw_peak`` um of a spike). ``axis``: the axis that vibrates.
    """

    value: float
    std_error: float
    unit: str
    effect: float
    share: float
    low: float | None = None
    more: Mapping[str, float | None] = field(default_factory=dict)
    axis: str | None = None


@dataclass(frozen=True, slots=True)
class FreshRun:
    """Random draws of one run in a new circular test, mm: the path without noise, and the noise.

    ``angles`` (n,) deg. ``paths`` (d, n): readings without noise. ``noise`` (d, n). All d draws are
    equally probable.
    """

    angles: FloatArray
    paths: FloatArray
    noise: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class FittedRun:
    """One run of a circular test after the fit of a model with all causes: the fitted deviations
    and the residuals.

    ``angles`` (n,) deg as measured. ``deviations`` (n,) mm of the fit. ``residuals`` (n,) mm,
    measured minus fitted. Of a long run only samples at equal steps are kept.
    """

    sense: Sense
    number: int
    angles: FloatArray
    deviations: FloatArray
    residuals: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class Diagnosis:
    """The causes of the deviations in a circular test by JSON name, their correlations, and causes
    that the test cannot separate.

    - ``correlation``: the correlation matrix of the causes, in the order of ``names``.
    - ``plain``: the same causes by simple regression on harmonics and reversals, for comparison
      with other software.
    - ``residual``: rms of the residuals, mm. ``correlation_length``: their correlation length, in
      samples.
    - ``undetermined``: the causes that the path of the test cannot separate at all, each with the
      reason. Their numbers in ``effects`` belong to the fit and are no result.
    - ``fitted``: the runs as the causes make them.
    - ``fresh``: a function that returns simulated new tests, by run; it returns none if the
      diagnosis was not made from samples.
    """

    effects: Mapping[str, CircularEffect]
    plain: Mapping[str, float]
    names: tuple[str, ...]
    correlation: FloatArray
    residual: float
    correlation_length: float
    findings: tuple[Finding, ...] = ()
    undetermined: Mapping[str, Sentence] = field(default_factory=dict)
    fitted: tuple[FittedRun, ...] = ()
    fresh: Callable[[], tuple[FreshRun, ...]] = tuple

    @property
    def not_given(self) -> Mapping[str, Sentence]:
        """The reasons why causes have no value, such as a squareness that is too uncertain."""
        effect = self.effects.get("squareness")
        if (
            effect is None
            or "squareness" in self.undetermined
            or correction_need(effect.value, effect.std_error) != "undetermined"
        ):
            return self.undetermined
        return {
            **self.undetermined,
            "squareness": shortfall(effect.value, effect.std_error, squareness=True),
        }


@dataclass(frozen=True, slots=True, kw_only=True)
class CircularResult:
    """The parameters of a circular test, mm, by JSON name. A parameter that does not apply is None,
    with the reason in ``not_applicable``.

    ``centres``: least-squares centres (``ccw``, ``cw``, ``common``), mm. ``mean_radius_deviation``:
    radius of the least-squares circle minus nominal, by direction, mm. ``zone_centres`` and
    ``zone_radii`` (inner, outer): those of the minimum zone (``ccw``, ``cw``, ``both``), mm, for
    the plots. ``uncertainty``: that of each parameter; None if no contributor is declared.
    """

    test: CircularTest
    standard: str
    parameters: Mapping[str, float | None]
    centres: Mapping[str, tuple[float, float]]
    mean_radius_deviation: Mapping[str, float]
    zone_centres: Mapping[str, tuple[float, float]]
    zone_radii: Mapping[str, tuple[float, float]]
    diagnosis: Diagnosis | None = None
    uncertainty: Mapping[str, ExpandedUncertainty] | None = None
    not_applicable: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
