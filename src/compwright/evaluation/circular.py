"""Evaluation of a circular test to ISO 230-4: parameters G, F, H, and those of the 2005 edition.

The text of the 1996 edition (DIN ISO 230-4:1999) was available; that of 2005 was not. The 2005
edition has the bidirectional circular deviation and the mean bidirectional radial deviation, and no
H. The sources for this are its published scope, and instrument software that prints both editions
for the same readings. For both editions, G and F are those of 1996.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Final, get_args

import numpy as np

from compwright.evaluation.circular_checks import run_findings, test_findings
from compwright.evaluation.circular_fit import Point, least_squares_circle
from compwright.evaluation.circular_points import ActualPath, hysteresis, paths
from compwright.evaluation.minimum_zone import minimum_zone
from compwright.evaluation.standards import by_id
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.circular import (
    CIRCULAR_NAMES,
    SHORTEST_ARC,
    CircularResult,
    CircularRun,
    CircularTest,
    Sense,
)
from compwright.words.sentences import Amount, SentenceText, say

DEFAULT_CIRCULAR_STANDARD: Final = "iso230-4:2005"

_SENSES: Final[tuple[Sense, ...]] = get_args(Sense)


@dataclass(frozen=True, slots=True, kw_only=True)
class CircularStandard:
    """One edition of the standard for circular tests. ``undefined`` gives the reason for each
    parameter that it does not define.
    """

    id: str
    title: str
    undefined: Mapping[str, str] = field(default_factory=dict)


#: The circular standards by the ids of the command line.
CIRCULAR_STANDARDS: Final[Mapping[str, CircularStandard]] = {
    standard.id: standard
    for standard in (
        CircularStandard(
            id="iso230-4:1996",
            title="ISO 230-4:1996",
            undefined=dict.fromkeys(
                ("G_bidirectional", "G_bidirectional_lsc", "D"),
                SentenceText(say("reason.undefined_1996")),
            ),
        ),
        CircularStandard(
            id=DEFAULT_CIRCULAR_STANDARD,
            title="ISO 230-4:2005",
            undefined={"H": SentenceText(say("reason.undefined_2005"))},
        ),
    )
}


def circular_standard_by_id(name: str) -> CircularStandard:
    """Return the circular standard with the id ``name``. Raises UsageError for an unknown id."""
    return by_id(name, CIRCULAR_STANDARDS, "circular standard")


def evaluate_circle(
    test: CircularTest, standard: str = DEFAULT_CIRCULAR_STANDARD
) -> CircularResult:
    """Evaluate ``test`` to ``standard``, with all lengths in mm and without a diagnosis of causes.

    - G: width of the minimum zone (3.4). ``G_*_lsc``: range of the distances from the least-squares
      centre of the same run; ``G_bidirectional_lsc`` uses the common least-squares centre of both
      directions.
    - F: largest and smallest value, with sign, of distance minus nominal radius (3.5). Distances
      are from the set-up centre on an arc, and from the run's least-squares centre on a full
      circle. ``F_*_lsc`` always uses the run's least-squares centre.
    - H: largest difference, at one angle, between the distances of the two directions from the
      common least-squares centre (3.3).
    - D: radius of the common least-squares circle minus nominal radius.

    Every sample is used and nothing is smoothed (clause 5).

    G and F are parameters of "the actual path", which is one traverse (3.2). H needs one traverse
    in each direction, measured in succession (clause 5). If a direction has several runs, the one
    with the lowest number is evaluated, and a finding gives G of the others. If the runs were
    joined, repeatability would be counted as an error of form.

    A parameter is None if the standard does not define it, if its direction was not measured, or if
    the bar was not calibrated (F; 3.4 note 3 and 4.5). ``not_applicable`` gives the reason.

    Raises UsageError for an unknown standard. Raises InputError for an arc below 90° (3.1), for
    readings that do not fit together, and for points that are not near a circle.
    """
    found = _Measures.of(test, circular_standard_by_id(standard))
    one_way, common = found.one_way, found.common
    zones = {str(sense): each.zone for sense, each in one_way.items()} | (
        {"both": common.zone} if common else {}
    )
    centres = {str(sense): each.centre for sense, each in one_way.items()} | (
        {"common": common.centre} if common else {}
    )
    reasons = found.reasons
    findings = [
        *test.findings,
        *_further_runs(found.ordered),
        *test_findings(
            test, centres, F_given="F_max_ccw" not in reasons or "F_max_cw" not in reasons
        ),
        *(
            finding
            for each in one_way.values()
            for finding in run_findings(test, each.path, each.centre)
        ),
    ]
    return CircularResult(
        test=test,
        standard=standard,
        parameters=found.parameters,
        centres=centres,
        mean_radius_deviation={
            str(sense): each.radius - test.nominal_radius for sense, each in one_way.items()
        },
        zone_centres={name: zone[0] for name, zone in zones.items()},
        zone_radii={name: (zone[1], zone[2]) for name, zone in zones.items()},
        not_applicable=reasons,
        findings=tuple(findings),
    )


def circle_parameters(
    test: CircularTest, standard: str = DEFAULT_CIRCULAR_STANDARD
) -> dict[str, float | None]:
    """Return the parameters of `evaluate_circle`, mm, without its checks of the readings. Those
    take most of its time, and simulated readings need none. Errors as `evaluate_circle`.
    """
    return _Measures.of(test, circular_standard_by_id(standard)).parameters


_Zone = tuple[Point, float, float]


@dataclass(frozen=True, slots=True)
class _OneWay:
    """The least-squares circle and the minimum zone (centre, inner and outer radius) of one path,
    mm.
    """

    path: ActualPath
    centre: Point
    radius: float
    zone: _Zone

    @classmethod
    def of(cls, path: ActualPath) -> _OneWay:
        centre, radius = least_squares_circle(path.points)
        return cls(path, centre, radius, minimum_zone(path.points, (centre, radius)))


@dataclass(frozen=True, slots=True)
class _Common:
    values: dict[str, float]
    centre: Point
    zone: _Zone


@dataclass(frozen=True, slots=True)
class _Measures:
    """All runs of each direction, circle and zone of the evaluated ones, and of both together; the
    parameters, and the reason for each one that is missing.
    """

    ordered: dict[Sense, list[ActualPath]]
    one_way: dict[Sense, _OneWay]
    common: _Common | None
    parameters: dict[str, float | None]
    reasons: dict[str, str]

    @classmethod
    def of(cls, test: CircularTest, standard: CircularStandard) -> _Measures:
        _require_sound(test)
        placed = paths(test.runs, test.nominal_radius)
        ordered = {sense: _of(placed, sense) for sense in _SENSES}
        evaluated = {sense: runs[0] for sense, runs in ordered.items() if runs}
        one_way = {sense: _OneWay.of(path) for sense, path in evaluated.items()}
        values: dict[str, float] = {}
        for sense, found in one_way.items():
            values |= _one_way_values(test, sense, found)
        common = _common_values(test, evaluated) if len(evaluated) == len(_SENSES) else None
        if common is not None:
            values |= common.values
        reasons = _reasons(test, standard, values)
        parameters = {name: None if name in reasons else values[name] for name in CIRCULAR_NAMES}
        return cls(ordered, one_way, common, parameters, reasons)


def _of(placed: tuple[ActualPath, ...], sense: Sense) -> list[ActualPath]:
    return sorted(
        (path for path in placed if path.run.sense == sense), key=lambda path: path.run.number
    )


def _one_way_values(test: CircularTest, sense: Sense, found: _OneWay) -> dict[str, float]:
    distances = found.path.distances(found.centre)
    radial = distances - test.nominal_radius
    by_standard = radial if test.full_circle else found.path.run.deviations
    return {
        f"G_{sense}": found.zone[2] - found.zone[1],
        f"G_{sense}_lsc": float(np.ptp(distances)),
        f"F_max_{sense}": float(by_standard.max()),
        f"F_min_{sense}": float(by_standard.min()),
        f"F_max_{sense}_lsc": float(radial.max()),
        f"F_min_{sense}_lsc": float(radial.min()),
    }


def _common_values(test: CircularTest, evaluated: Mapping[Sense, ActualPath]) -> _Common:
    points = np.vstack([path.points for path in evaluated.values()])
    centre, radius = least_squares_circle(points)
    zone = minimum_zone(points, (centre, radius))
    distances = np.concatenate([path.distances(centre) for path in evaluated.values()])
    values = {
        "G_bidirectional": zone[2] - zone[1],
        "G_bidirectional_lsc": float(np.ptp(distances)),
        "H": hysteresis(evaluated["ccw"], evaluated["cw"], centre, test.arc),
        "D": radius - test.nominal_radius,
    }
    return _Common(values, centre, zone)


def _reasons(
    test: CircularTest, standard: CircularStandard, values: Mapping[str, float]
) -> dict[str, str]:
    """Return the reason for each missing parameter, by name: not defined by the edition, direction
    not measured, length of the bar not calibrated, or no angle common to both directions.
    """
    reasons = {}
    for name in CIRCULAR_NAMES:
        missing = [
            sense
            for sense in _SENSES
            if not test.of(sense) and (f"_{sense}" in name or name[0] in "HD" or "_bi" in name)
        ]
        if name in standard.undefined:
            reasons[name] = standard.undefined[name]
        elif missing:
            reasons[name] = SentenceText(say("reason.not_measured", direction=missing[0]))
        elif name.startswith("F_") and not name.endswith("_lsc") and not test.calibrated:
            reasons[name] = SentenceText(say("reason.not_calibrated"))
        elif not np.isfinite(values[name]):
            reasons[name] = SentenceText(say("reason.no_common_angle"))
    return reasons


def _further_runs(ordered: Mapping[Sense, list[ActualPath]]) -> list[Finding]:
    """Return the finding CW-C001 if a direction has several runs. Only the first run of a direction
    is evaluated; the finding states G of each further run.
    """
    others = []
    for sense, runs in ordered.items():
        for path in runs[1:]:
            _, inner, outer = minimum_zone(path.points)
            G = Amount((outer - inner) * MICROMETRES_PER_MILLIMETRE, "µm")
            others.append(say("CW-C001.other", direction=sense, run=path.run.number, G=G))
    if not others:
        return []
    first = [
        say("CW-C001.run", direction=sense, run=runs[0].run.number)
        for sense, runs in ordered.items()
        if runs
    ]
    return [Finding.of("CW-C001", "info", first=first, others=others)]


def _require_sound(test: CircularTest) -> None:
    faults = []
    if not (np.isfinite(test.nominal_radius) and test.nominal_radius > 0.0):
        faults.append(
            Fault(
                message="the nominal radius must be positive",
                expected="more than 0 mm",
                found=f"{test.nominal_radius:g}",
                hint="correct the nominal radius in the file",
            )
        )
    if not 0.0 < test.arc[1] <= 360.0:
        faults.append(
            Fault(
                message="the arc is longer than a full circle",
                expected="at most 360°",
                found=f"{test.arc[1]:.6g}°",
                hint="correct `arc` in the file",
            )
        )
    if not test.runs:
        faults.append(
            Fault(
                message="the test contains no run",
                hint="give a file with samples of at least one run",
            )
        )
    for run in test.runs:
        faults += [
            fault.within(f"{run.sense} run {run.number}")
            for fault in _run_faults(run, test.nominal_radius)
        ]
    file = test.sources[0].file if test.sources else test.name
    raise_all(InputError, [fault.in_file(file) for fault in faults])


def _run_faults(run: CircularRun, nominal_radius: float) -> list[Fault]:
    if run.angles.ndim != 1 or run.angles.shape != run.deviations.shape:
        found = f"{run.angles.shape} and {run.deviations.shape}"
        return [
            Fault(
                message="a run has different numbers of angles and deviations",
                expected="one deviation per angle",
                found=found,
                hint="give one deviation per angle",
            )
        ]
    if run.angles.size < 4:
        return [
            Fault(
                message="a run has too few samples",
                expected="at least 4",
                found=str(run.angles.size),
                hint="measure again with more samples",
            )
        ]
    if not (np.all(np.isfinite(run.angles)) and np.all(np.isfinite(run.deviations))):
        return [
            Fault(
                message="a run contains angles or deviations that are not finite numbers",
                expected="finite numbers",
                hint="remove these samples, or measure again",
            )
        ]
    if np.any(run.deviations <= -nominal_radius):
        return [
            Fault(
                message="a deviation is so negative that the path would pass through the centre",
                expected="more than minus the nominal radius",
                found=f"{run.deviations.min():g} mm",
                hint="correct the unit of the deviations, or the nominal radius",
            )
        ]
    covered = (
        float(np.ptp(run.angles)) * run.angles.size / (run.angles.size - 1)
    )  # each sample stands for one interval
    if covered < SHORTEST_ARC * (1.0 - 1e-6):
        return [
            Fault(
                message="the samples of the test cover too short an arc",
                expected="at least 90° (ISO 230-4:1996, 3.1)",
                found=f"{covered:.6g}°",
                hint="measure an arc of 90° or more",
            )
        ]
    return []


def without_noise(result: CircularResult, parameter: str) -> float | None:
    """Return a ``parameter`` of the circular test without noise: computed from the fitted causes
    alone. None without a diagnosis.
    """
    fitted = () if result.diagnosis is None else result.diagnosis.fitted
    runs = tuple(
        CircularRun(
            sense=each.sense, angles=each.angles, deviations=each.deviations, number=each.number
        )
        for each in fitted
    )
    if not runs:
        return None
    return circle_parameters(replace(result.test, runs=runs))[parameter]
