"""Corrections between axes: squareness from circular tests, squareness and straightness from direct
measurements.

All values here are changes of the present correction. A circle shows the squareness of the machine
together with the corrections between its axes that were active during the measurement. In a state
with other tables it shows another squareness.

Signs: squareness > 0 means more than 90° between the two positive axes. The corrected axis gets +
squareness times the distance of the other axis from its reference.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.foundations.findings import Finding, Severity
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.circle_network import squareness_contradiction
from compwright.planning.circles import CircleWork, effect_of, why_undetermined
from compwright.planning.cross_doubts import (
    INCREMENT,
    SQUARE,
    both_sloped,
    has_slope,
    outside_travel,
    repeated,
    too_large,
)
from compwright.planning.value_with_error import (
    CONTRADICTORY,
    SIGNIFICANT,
    ValueWithError,
    weighted_mean,
    worse_doubts,
)
from compwright.prediction.active_corrections import ActiveCorrections
from compwright.prediction.circular import commanded_path
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.circular import CircularRun
from compwright.records.correction import CrossCompensation
from compwright.records.correction_need import correction_need, shortfall
from compwright.records.job import AS_FOUND, CrossRequest, Job, other_axis
from compwright.records.plan import PlannedCross
from compwright.words.sentences import Amount, Sentence, say

#: A correction over more than this many diameters of the circle (lengths of the measured range) is
#: an extrapolation.
FAR = 2.0
#: Values and positions of a cross-axis table are whole multiples of these, mm or deg: less than
#: any control resolves.
QUANTUM, STEP = 1e-6, 1e-3
MOST_POINTS = 100
_PPM = 1e6


@dataclass(frozen=True, slots=True)
class Squareness:
    """The squareness of a plane under the present corrections, rad, with its standard error, the
    names of the circular tests that show it, and the largest diameter of these tests, mm.
    ``contradictory``: these tests contradict each other, so that the mean is right for none.
    """

    value: float
    std_error: float
    tests: tuple[str, ...]
    diameter: float
    contradictory: bool = False

    @property
    def words(self) -> Sentence:
        """The squareness as text with unit, for messages."""
        return ValueWithError(self.value, self.std_error).words(_PPM, "µm/m")


@dataclass(frozen=True, slots=True)
class CrossPlan:
    """The planned changes of corrections between axes, with their findings."""

    planned: tuple[PlannedCross, ...] = ()
    findings: tuple[Finding, ...] = ()


def plan_cross(
    job: Job,
    circles: Sequence[CircleWork],
    states: Mapping[str, ActiveCorrections],
    now: ActiveCorrections,
) -> CrossPlan:
    """Return the corrections between axes that the job requests, from direct measurements and
    circular tests. ``states``: the active corrections in each state of the control, by name;
    ``now``: those that are active at present.
    """
    planner = _Planner(job, circles, states, now)
    planned = tuple(planner.measured()) + tuple(planner.squareness())
    return CrossPlan(planned, tuple(planner.findings))


class _Planner:
    def __init__(
        self,
        job: Job,
        circles: Sequence[CircleWork],
        states: Mapping[str, ActiveCorrections],
        now: ActiveCorrections,
    ) -> None:
        self.job = job
        self.axes: dict[str, Axis] = {name: entry.axis for name, entry in job.axes.items()}
        self.findings: list[Finding] = []
        self.now = now
        self.states = states
        self.circles = circles
        self.angles = dict(self._angles(circles))
        self.measured_pairs: dict[frozenset[str], list[PlannedCross]] = {}
        self.sloped: list[PlannedCross] = []

    def find(
        self, name: str, severity: Severity, axes: tuple[str, ...] = (), /, **values: object
    ) -> None:
        """Add a finding to the list. The arguments are those of `Finding.of`."""
        self.findings.append(Finding.of(name, severity, axes, **values))

    # --- direct measurements
    # ----------------------------------------------------------------------------------------------

    def measured(self) -> Iterator[PlannedCross]:
        """Yield the correction for every direct measurement between two axes in the job."""
        for request in self.job.cross:
            if request.input not in self.axes or request.output not in self.axes:
                continue  # CW-J004 says so
            planned = self._measured(request)
            self.measured_pairs.setdefault(planned.pair, []).append(planned)
            self._gantry(planned.output)
            yield planned
        for pair, every in self.measured_pairs.items():
            if not self._confirmed_by_circle(every):
                self.findings += both_sloped([one for one in self.sloped if one.pair == pair])

    def _measured(self, request: CrossRequest) -> PlannedCross:
        """Return the change of the correction between two axes, from a direct measurement.

        It is the correction that was active during the measurement, minus the measured deviation,
        minus the present correction.
        """
        where = np.array(request.positions)
        pair = (request.input, request.output)
        before = self.states.get(request.measured_in, self.now).between(*pair)
        now = self.now.between(*pair)
        curves = {
            direction: before(where, direction)
            - np.array(request.deviations)
            - now(where, direction)
            for direction in Direction
        }
        slope = float(np.polyfit(where, np.mean(list(curves.values()), axis=0), 1)[0])
        label = say("between.axes", output=request.output, input=request.input)
        reach = float(np.ptp(where))
        self.findings.extend(extrapolated(label, self.axes[request.input], reach))
        planned = PlannedCross(
            input=request.input,
            output=request.output,
            added=self._table(request.input, request.output, where, curves, slope),
            source="cross",
            squareness=slope,
        )
        self.findings += [*too_large(planned), *outside_travel(planned, self.axes[pair[0]], where)]
        linear = all(self.axes[name].kind is AxisKind.LINEAR for name in pair)
        if linear and has_slope(where, np.mean([*curves.values()], axis=0)):
            self.sloped.append(planned)
        if request.measured_in == AS_FOUND:
            self._check_repeated(planned, where, curves)
        return planned

    def _check_repeated(
        self, planned: PlannedCross, where: FloatArray, curves: Mapping[Direction, FloatArray]
    ) -> None:
        """Add the doubt CW-P167 if the ``curves`` (n,) of a change at the positions ``where`` equal
        the present correction, up to a constant. A correction of the other axis counts with its
        slope.
        """
        now = self.now.between(planned.input, planned.output)
        ends = np.array(self.axes[planned.output].travel)
        back = self.now.between(planned.output, planned.input)
        turned = np.mean([np.diff(back(ends, way)) for way in Direction]) / np.ptp(ends)
        off = min(
            np.ptp([curves[way] - now(where, way) - slope * where for way in Direction])
            for slope in (0.0, turned)
        )
        size = float(np.ptp([*curves.values()]))
        self.findings += repeated(planned, float(off), size, INCREMENT)

    def _table(
        self,
        given: str,
        bent: str,
        where: FloatArray,
        curves: Mapping[Direction, FloatArray],
        slope: float,
    ) -> CrossCompensation:
        """Return the correction of the axis ``bent``, measured as ``curves`` at positions ``where``
        of the axis ``given``, as a table over the travel of ``given``, zero at its reference.
        Beyond the measured range the correction continues with ``slope``.
        """
        axis = self.axes[given]
        points = _points(axis, where)
        tables, missed = [], 0.0
        for curve in (curves[direction] for direction in Direction):
            shifted = curve - float(_continued(np.array([axis.reference]), where, curve, slope)[0])
            table = np.round(_continued(points, where, shifted, slope) / QUANTUM) * QUANTUM
            missed = max(
                missed, float(np.max(np.abs(_continued(where, points, table, slope) - shifted)))
            )
            tables.append(table)
        if missed > 2.0 * QUANTUM:
            unit = self.axes[bent].kind.unit
            shown = Amount(missed * outside_factor(unit), shown_unit(unit), "2sig")
            self.find("CW-P103", "info", input=given, output=bent, missed=shown)
        return _compensation(axis, self.axes[bent], points, *tables)

    def _confirmed_by_circle(self, every: Sequence[PlannedCross]) -> bool:
        """Return whether the circles of a plane confirm the squareness that ``every`` measured
        correction between its axes removes together, and add the finding that they confirm it or
        contradict it.
        """
        circle = self.angles.get(every[0].pair)
        if circle is None:
            return False
        measured = sum(planned.squareness for planned in every)
        difference = abs(circle.value - measured)
        named = say(
            "direct_squareness",
            input=every[0].input,
            output=every[0].output,
            squareness=measured * _PPM,
            measurements=len(every),
        )
        if difference > max(CONTRADICTORY * circle.std_error, SQUARE):
            self.find(
                "CW-P104",
                "warning",
                (every[0].input, every[0].output),
                measured=named,
                measurements=len(every),
                circle=circle.words,
                tests=circle.tests,
            )
        elif (
            difference <= max(SIGNIFICANT * circle.std_error, SQUARE)
            and correction_need(circle.value * _PPM, circle.std_error * _PPM) != "undetermined"
        ):
            self.find("CW-P105", "info", measured=named, tests=circle.tests, circle=circle.words)
            return True
        return False

    # --- squareness from circles
    # ----------------------------------------------------------------------------------------------

    def squareness(self) -> Iterator[PlannedCross]:
        """Yield the correction of squareness for every plane listed in the job's ``apply``, and add
        findings about unlisted planes with a significant squareness error.
        """
        requested = {
            frozenset({bent, other_axis(plane, bent)}): (plane, bent)
            for plane, bent in self.job.apply.squareness.items()
        }
        for pair, (plane, bent) in requested.items():
            other = other_axis(plane, bent)
            if bent not in self.axes or other not in self.axes or pair in self.measured_pairs:
                continue
            angle = self.angles.get(pair)
            need = (
                None
                if angle is None
                else correction_need(angle.value * _PPM, angle.std_error * _PPM)
            )
            if angle is None or need == "undetermined":
                self._not_corrected(plane, pair, angle)
            elif need == "negligible":
                self.find("CW-P107", "info", plane=plane, angle_words=angle.words)
            elif angle.contradictory and not all(
                self.job.acknowledgement("CW-P110", axis) for axis in pair
            ):
                self.find("CW-P106.contradictory", "error", plane=plane)
            else:
                yield self._ramp(other, bent, angle)
        for pair, angle in self.angles.items():
            if (
                pair not in requested
                and pair not in self.measured_pairs
                and correction_need(angle.value * _PPM, angle.std_error * _PPM) == "correct"
            ):
                plane = "".join(sorted(pair))
                self.find("CW-P108", "info", plane=plane, squareness=angle.words, tests=angle.tests)

    def _not_corrected(self, plane: str, pair: frozenset[str], angle: Squareness | None) -> None:
        """Add the finding that states why the squareness of a ``plane`` (axes ``pair``) is not
        corrected, and what to measure. ``angle``: the squareness, None if no circular test
        determines it.
        """
        mine = (work for work in self.circles if frozenset(work.planned.test.axes) == pair)
        if angle is not None:
            why = shortfall(angle.value * _PPM, angle.std_error * _PPM, squareness=True)
            self.find("CW-P106.uncertain", "error", plane=plane, why=why)
        elif reasons := list(why_undetermined(mine, "squareness")):
            self.find("CW-P106.undetermined", "error", plane=plane, reasons=reasons)
        else:
            self.find("CW-P106.no_circle", "error", plane=plane)

    def _ramp(self, given: str, bent: str, angle: Squareness) -> PlannedCross:
        axis = self.axes[given]
        points = np.array(axis.travel)
        values = np.round(angle.value * (points - axis.reference) / QUANTUM) * QUANTUM
        plane = say("between.axes", output=bent, input=given)
        self.findings.extend(extrapolated(plane, axis, angle.diameter, diameter=True))
        self._gantry(bent)
        mine = [work for work in self.circles if work.name in angle.tests]
        self.find(
            "CW-P109",
            "info",
            plane=plane,
            squareness=angle.words,
            tests=angle.tests,
            existing=any(
                abs(angle_of(work, self.now)) > INCREMENT / angle.diameter for work in mine
            ),
            converted=any(work.planned.measured_in != AS_FOUND for work in mine),
            output=bent,
            input=given,
        )
        name = "".join(sorted((given, bent)))
        in_ppm = angle.value * _PPM, angle.std_error * _PPM
        self.findings += worse_doubts(*in_ppm, (given, bent), name)
        planned = PlannedCross(
            input=given,
            output=bent,
            added=_compensation(axis, self.axes[bent], points, values, values),
            source="circle",
            tests=angle.tests,
            squareness=angle.value,
            std_error=angle.std_error,
        )
        self.findings += too_large(planned)
        # On either axis, from any reference, over a part of the travel: the angle is what counts.
        now = [angle_of(work, self.now) for work in mine if work.planned.measured_in == AS_FOUND]
        if now:
            off = abs(float(np.mean(now)) - angle.value)
            error = max(2.0 * angle.std_error, INCREMENT / angle.diameter)
            self.findings += repeated(planned, off, abs(angle.value), error)
        return planned

    def _angles(self, circles: Sequence[CircleWork]) -> Iterator[tuple[frozenset[str], Squareness]]:
        """Yield the squareness of each pair of axes under the present corrections, as weighted mean
        of the circular tests of this pair.
        """
        by_pair: dict[frozenset[str], list[CircleWork]] = {}
        for work in circles:
            if effect_of(work.result, "squareness") is not None:
                by_pair.setdefault(frozenset(work.planned.test.axes), []).append(work)
        for pair, works in by_pair.items():
            yield pair, self._mean(works)

    def _mean(self, works: Sequence[CircleWork]) -> Squareness:
        values = [self._as_found(work) for work in works]
        mean, contradicts = weighted_mean(values)
        if contradicts:
            each = [(work.name, one.value * _PPM) for work, one in zip(works, values, strict=True)]
            self.findings.append(squareness_contradiction(works[0].planned.test.axes, each))
        diameter = max(2.0 * work.planned.test.nominal_radius for work in works)
        tests = tuple(work.name for work in works)
        return Squareness(mean.value, mean.std_error, tests, diameter, contradicts)

    def _as_found(self, work: CircleWork) -> ValueWithError:
        """Return the squareness, rad, from one circular test under the present corrections."""
        effects = work.result.diagnosis.effects if work.result.diagnosis is not None else {}
        effect = effects["squareness"]
        during = self.states.get(work.planned.measured_in, self.now)
        bent = angle_of(work, during) - angle_of(work, self.now)
        return ValueWithError(effect.value / _PPM + bent, effect.std_error / _PPM)

    # --- findings
    # ----------------------------------------------------------------------------------------------

    def _gantry(self, bent: str) -> None:
        if self.axes[bent].gantry is not None:
            self.find("CW-P112", "warning", axis=bent)


def extrapolated(
    label: str | Sentence, axis: Axis, length: float, *, diameter: bool = False
) -> Iterator[Finding]:
    """Yield the finding CW-P111 if a correction of ``label`` over the travel of an axis reaches far
    beyond the measured ``length``, mm. ``diameter``: it is the diameter of a circle.
    """
    travel = axis.travel[1] - axis.travel[0]
    if travel > FAR * length:
        yield Finding.of(
            "CW-P111",
            "warning",
            pair=label,
            travel=travel,
            axis=axis.name,
            diameter=diameter,
            length=length,
        )


def angle_of(work: CircleWork, state: ActiveCorrections) -> float:
    """Return the squareness error, rad, that the corrections between axes in ``state`` remove from
    a circular test.
    """
    test = work.planned.test
    crossing = replace(state, along={}).displacement(test.axes)
    degrees: FloatArray = np.linspace(0.25, 359.75, 720)
    theta = np.radians(degrees)
    found = []
    for run in (
        CircularRun(sense="ccw", angles=degrees, deviations=np.zeros_like(degrees)),
        CircularRun(sense="cw", angles=degrees, deviations=np.zeros_like(degrees)),
    ):
        moved = crossing(commanded_path(test, run, work.planned.centre))
        radial = moved[:, 0] * np.cos(theta) + moved[:, 1] * np.sin(theta)
        wave = np.sin(2.0 * theta)
        # Bending by s times the other axis gives s R/2 sin2θ, squareness β gives -β R/2 sin2θ.
        found.append(2.0 / test.nominal_radius * float(radial @ wave / (wave @ wave)))
    return float(np.mean(found))


def _points(axis: Axis, where: FloatArray) -> FloatArray:
    """Return equally spaced table points over the travel that match the measured points as well as
    possible. Their interval is a whole number of micrometres.
    """
    low, high = axis.travel
    if where.size == 2:
        return np.array([low, high])
    finest = float(np.min(np.diff(where)))
    count = int(np.clip(np.ceil((high - low) / finest - 1e-9), 1, MOST_POINTS))
    step = np.ceil((high - low) / count / STEP - 1e-9) * STEP
    return np.asarray(np.round(low + step * np.arange(count + 1), 6), dtype=np.float64)


def _continued(
    where: FloatArray, positions: FloatArray, values: FloatArray, slope: float
) -> FloatArray:
    """Return values at ``where``: linear between ``positions``, and continued with ``slope`` beyond
    them.
    """
    beyond = np.minimum(where - positions[0], 0.0) + np.maximum(where - positions[-1], 0.0)
    return np.asarray(np.interp(where, positions, values) + slope * beyond, dtype=np.float64)


def _compensation(
    given: Axis, bent: Axis, points: FloatArray, positive: FloatArray, negative: FloatArray
) -> CrossCompensation:
    return CrossCompensation(
        input=given.address,
        output=bent.address,
        input_kind=given.kind,
        output_kind=bent.kind,
        positions=points,
        positive=positive,
        negative=negative,
    )
