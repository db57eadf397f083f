"""Scale error of an axis without a positioning test, from circular tests.

The lag of the position loop also makes the radius of a circle smaller, by v²/(2 Kv² R). Therefore a
scale is taken from one of three sources: several circular tests together, which separate lag from
scale (`circle_network`), a calibrated bar at a low feed, or the mismatch with an axis that has a
positioning test. Without one of these, no scale is given.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.estimation.circle_model import SOFTEST_LOOP
from compwright.foundations.errors import CapacityError
from compwright.foundations.findings import Finding
from compwright.planning.axis_work import CapacityOf
from compwright.planning.circle_checks import CircleChecks, mismatch, scale_error
from compwright.planning.circle_network import CircleNetwork, contradiction, state_networks
from compwright.planning.circles import CircleWork, effect_of, measured_range, why_undetermined
from compwright.planning.cross import extrapolated
from compwright.planning.tables import NEW_GRID, fit_keeping_grid, fit_remaining
from compwright.planning.value_with_error import ValueWithError, weighted_mean, worse_doubts
from compwright.planning.wanted_correction import (
    axis_compensation,
    dense_positions,
    wanted_correction,
)
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections
from compwright.records.axis import Axis, Direction
from compwright.records.correction import ControlState
from compwright.records.correction_need import correction_need, shortfall
from compwright.records.estimate import ErrorEstimate
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.job import AS_FOUND, AxisJob, Job
from compwright.records.plan import PlannedAxis
from compwright.words.sentences import Sentence, control_text, say

#: A feed is low when the softest usual position loop shrinks the circle by no more than this part
#: of its radius.
LOW = 2e-6
_PPM = 1e6
#: Curves of both directions whose difference varies by less than this, mm or deg, are one curve.
_SAME = 1e-6


@dataclass(frozen=True, slots=True)
class ScaleCorrection:
    """The correction of an axis' scale error from circular tests. Without a correction, ``planned``
    is None and ``finding`` states the reason.
    """

    name: str
    planned: PlannedAxis | None
    finding: Finding
    doubts: tuple[Finding, ...] = ()

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings about the scale correction, and about new table points."""
        fitted = None if self.planned is None else self.planned.fitted
        moved = () if fitted is None else fitted.findings
        return (self.finding, *self.doubts, *(one for one in moved if one.code == NEW_GRID))


def correct_scales(
    job: Job,
    circles: Sequence[CircleWork],
    checks: CircleChecks,
    capacity: CapacityOf,
    state: ControlState,
) -> tuple[ScaleCorrection, ...]:
    """Return the scale correction of each axis listed in ``apply.scale``. A positioning test, if
    there is one, takes precedence.

    ``state``: the present contents of the control. ``capacity``: returns the limits of the control
    for an axis.
    """
    found = []
    networks = state_networks(circles)
    for name in job.apply.scale:
        entry = job.axes.get(name)
        if entry is None:
            continue  # CW-J004 says so
        if entry.before:
            found.append(ScaleCorrection(name, None, Finding.of("CW-P118", "info", axis=name)))
            continue
        found.append(_scaled(name, job, circles, networks, checks, capacity, state))
    return tuple(found)


def _scaled(
    name: str,
    job: Job,
    circles: Sequence[CircleWork],
    networks: Mapping[str, CircleNetwork],
    checks: CircleChecks,
    capacity: CapacityOf,
    state: ControlState,
) -> ScaleCorrection:
    found = list(_values(name, circles, networks, checks))
    shown = [entry for entry in found if not isinstance(entry, Sentence)]
    reasons = [entry for entry in found if isinstance(entry, Sentence)]
    if not shown:
        return ScaleCorrection(
            name,
            None,
            Finding.of("CW-P119.not_taken", "error", axis=name, reasons=reasons),
        )
    scale, contradicts = weighted_mean([stated for stated, _, _ in shown])
    doubts: tuple[Finding, ...] = ()
    if contradicts:
        each = [
            (" + ".join(work.name for work in works), name, stated.words(_PPM, "µm/m"))
            for stated, works, _ in shown
        ]
        doubts = (contradiction("scale", (name,), each),)
    refused = job.acknowledgement("CW-P136", name) is None and (
        contradicts or any(network.contradicts_scale(name) for network in networks.values())
    )
    source = [how for _, _, how in shown]
    words = say("scale_by", axis=name, scale=scale.words(_PPM, "µm/m"), tests=source)
    in_ppm = scale.value * _PPM, scale.std_error * _PPM
    need = correction_need(*in_ppm)
    planned = None
    if need == "negligible":
        finding = Finding.of("CW-P119.negligible", "info", scale=words)
    elif need == "undetermined":
        why = shortfall(*in_ppm, squareness=False)
        finding = Finding.of("CW-P119.undetermined", "error", axis=name, why=why, tests=source)
    elif refused:
        finding = Finding.of("CW-P119.contradictory", "error", axis=name)
    else:
        try:
            planned = _planned(job.axes[name], scale, capacity, state)
        except CapacityError as error:
            faults = [str(fault) for fault in error.faults]
            finding = Finding.of("CW-P119.impossible", "error", scale=words, reasons=faults)
        else:
            finding = Finding.of("CW-P120", "warning", scale=words)
            works = [work for _, works, _ in shown for work in works]
            doubts += (*_reach(job.axes[name].axis, works), *worse_doubts(*in_ppm, (name,)))
    return ScaleCorrection(name, planned, finding, doubts)


#: A scale error under the present corrections, the circular tests of the axis that show it, and the
#: words for all tests that it comes from.
_Shown = tuple[ValueWithError, Sequence[CircleWork], Sentence]


def _values(
    name: str,
    circles: Sequence[CircleWork],
    networks: Mapping[str, CircleNetwork],
    checks: CircleChecks,
) -> Iterator[_Shown | Sentence]:
    """Yield each scale error that circular tests show, or the reasons why none determines it.
    ``networks``: the errors that the tests of each state of the control show together.
    """
    mine = [work for work in circles if name in work.planned.test.axes]
    together = {
        state: (network.circles, stated)
        for state, network in networks.items()
        if (stated := network.values_of("scale").get(name)) is not None
    }
    for state, (tests, stated) in together.items():
        own = [
            work
            for work in mine
            if work.planned.measured_in == state and effect_of(work.result, "scale_mismatch")
        ]
        scale = ValueWithError(stated.value / _PPM, stated.std_error / _PPM)
        how = say("CW-P119.together", circles=tests)
        yield _now(scale, own, name, checks), own, how
    slow = [
        (work, stated)
        for work in mine
        if work.planned.measured_in not in together
        and shrinking(work) <= LOW
        and (stated := scale_error(work, _index(work, name))) is not None
    ]
    for work, stated in slow:
        how = say("CW-P119.low_feed", circle=work.name)
        yield _now(stated, [work], name, checks), [work], how
    if not (together or slow):
        for work in mine:
            yield _by_mismatch(work, name, checks)


def _by_mismatch(work: CircleWork, name: str, checks: CircleChecks) -> _Shown | Sentence:
    index = _index(work, name)
    lacking = list(why_undetermined((work,), "scale_mismatch"))
    if lacking:
        return lacking[0]
    between, laser = mismatch(work), checks.laser(work, 1 - index)
    if between is None or laser is None:
        if not work.planned.test.calibrated:
            return say("CW-P119.not_calibrated", circle=work.name)
        low = 60.0 * SOFTEST_LOOP * work.planned.test.nominal_radius * float(np.sqrt(2.0 * LOW))
        low = np.floor(low + 1e-6)  # a rounded feed would be refused
        return say("CW-P119.lag", circle=work.name, lag=shrinking(work) * _PPM, feed=low)
    # The mismatch is first minus second.
    own = laser.scale.value + (between.value if index == 0 else -between.value)
    stated = ValueWithError(own, float(np.hypot(between.std_error, laser.scale.std_error)))
    return (
        _now(stated, [work], name, checks),
        [work],
        say("CW-P119.mismatch", circle=work.name, axis=work.planned.test.axes[1 - index]),
    )


def _reach(axis: Axis, circles: Sequence[CircleWork]) -> Iterator[Finding]:
    """Yield the finding CW-P111 if the circular tests that show a scale cover a small part of the
    travel.
    """
    ends = [measured_range(work.planned, _index(work, axis.name)) for work in circles]
    yield from extrapolated(axis.name, axis, float(np.ptp(ends)))


def shrinking(work: CircleWork) -> float:
    """Return the relative shrinkage of a circle by servo lag, at the lowest usual position-loop
    gain.
    """
    test = work.planned.test
    return float((test.feed / 60.0) ** 2 / (2.0 * SOFTEST_LOOP**2 * test.nominal_radius**2))


def _index(work: CircleWork, name: str) -> int:
    return work.planned.test.axes.index(name)


def _now(
    stated: ValueWithError, works: Sequence[CircleWork], name: str, checks: CircleChecks
) -> ValueWithError:
    """Return the scale error ``stated`` by circular tests in one state of the control for an axis,
    converted from the corrections during the tests to the present corrections.
    """
    now, changes = checks.states.get(AS_FOUND, NO_CORRECTIONS), []
    for work in works:
        radius, middle = work.planned.test.nominal_radius, work.planned.centre[_index(work, name)]
        during = checks.states.get(work.planned.measured_in, NO_CORRECTIONS)
        changes.append(_slope(now, name, middle, radius) - _slope(during, name, middle, radius))
    return replace(stated, value=stated.value + float(np.mean(changes)))


def _slope(state: ActiveCorrections, name: str, middle: float, radius: float) -> float:
    ends, correction = np.array([middle - radius, middle + radius]), state.on(name)
    return float(np.mean([np.diff(correction(ends, direction))[0] for direction in Direction])) / (
        2.0 * radius
    )


def _planned(
    entry: AxisJob, scale: ValueWithError, capacity: CapacityOf, state: ControlState
) -> PlannedAxis:
    """Return the table that corrects a scale error and is zero at the reference of the axis."""
    axis: Axis = entry.axis
    positions = dense_positions(axis, ())
    away = np.abs(positions - axis.reference) * scale.std_error
    means = scale.value * (positions - axis.reference)
    estimate = ErrorEstimate(
        kind=axis.kind,
        positions=positions,
        mean_positive=means,
        mean_negative=means,
        std_positive=away,
        std_negative=away,
        noise=max(
            float(np.max(away)), 1e-4
        ),  # mm: a grid is not worth refining below a tenth of a micrometre
        noise_dof=1.0,
        measured=axis.travel,
    )
    active = axis_compensation(state, axis)
    wanted = wanted_correction(estimate, active, axis, reversal_log_odds=0.0)
    # A scale is the same in both directions. Only existing tables that differ need two.
    differ = float(np.ptp(wanted.positive - wanted.negative)) > _SAME
    mode = entry.table.mode
    limits = capacity(axis, one_curve=mode == "single" or (mode == "auto" and not differ))

    def fit(request: TableRequest) -> FittedTable:
        return fit_remaining(wanted, limits, request, axis)

    fitted = fit_keeping_grid(fit, limits, entry.table, axis)
    return PlannedAxis(
        axis=axis,
        tests=(),
        estimate=estimate,
        active=active,
        wanted=wanted,
        request=entry.table,
        fitted=fitted,
        accept=None,
    )


def scale_steps(scaled: Sequence[ScaleCorrection]) -> tuple[Mapping[str, str], ...]:
    """Return the steps of the operator's card for axes whose table was computed from circular
    tests.
    """
    return tuple(
        {
            "title": control_text("{name}: scale from circles", name=entry.name),
            "text": control_text(
                "{scale} Measure {name} with a laser when you can.",
                scale=entry.finding.sentence,
                name=entry.name,
            ),
            "evidence": "inferred",
        }
        for entry in scaled
        if entry.planned is not None
    )
