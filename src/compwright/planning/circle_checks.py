"""Comparison of circular and positioning tests: lost motion and scale of an axis from both, each
with its uncertainty.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.foundations.findings import Finding
from compwright.planning.axis_work import AxisWork
from compwright.planning.circles import CircleWork, effect_of, measured_range
from compwright.planning.cross_doubts import SQUARE
from compwright.planning.value_with_error import CONTRADICTORY, ValueWithError
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections, difference
from compwright.records.axis import Axis, Direction
from compwright.records.job import Job

ENDS = ("first", "second")
_DRAWS = 500
_UM, _PPM = 1e3, 1e6


@dataclass(frozen=True, slots=True)
class LaserValues:
    """The lost motion and scale error that an axis has over the diameter of a circle, computed from
    the positioning test of the axis.
    """

    lost_motion: ValueWithError
    scale: ValueWithError


def laser_values(
    work: CircleWork, axis: AxisWork, index: int, during: ActiveCorrections
) -> LaserValues:
    """Return the lost motion of an axis (mm, positive for lag) and its scale error over the
    diameter of a circle, from its positioning test, converted to the corrections ``during`` the
    circular test.

    ``index``: 0 if the axis is the circle's first one, 1 if it is the second. If the job gives the
    laser's own uncertainty per metre, it is included.
    """
    radius, middle = work.planned.test.nominal_radius, work.planned.centre[index]
    ends = np.array([middle - radius, middle + radius])
    draws = axis.posterior.draw(ends, _DRAWS, np.random.default_rng(0))
    change = difference(during.on(axis.planned.axis.name), axis.active)
    positive = draws.positive + change(ends, Direction.POSITIVE)
    negative = draws.negative + change(ends, Direction.NEGATIVE)
    lost = np.mean(negative - positive, axis=1)
    scale = np.mean([curve[:, 1] - curve[:, 0] for curve in (positive, negative)], axis=0) / (
        2.0 * radius
    )
    return LaserValues(
        lost_motion=ValueWithError(float(np.mean(lost)), float(np.std(lost))),
        scale=ValueWithError(float(np.mean(scale)), float(np.std(scale))),
    )


def lost_motion(work: CircleWork, index: int) -> ValueWithError | None:
    """Return the lost motion, mm, of the first (``index`` 0) or second axis of a circular test, or
    None if the diagnosis does not determine it.
    """
    found = effect_of(work.result, f"backlash_{ENDS[index]}")
    return None if found is None else ValueWithError(found.value / _UM, found.std_error / _UM)


def scale_error(work: CircleWork, index: int) -> ValueWithError | None:
    """Return the scale error (mm/mm) of the first (``index`` 0) or second axis of a circular test,
    or None without a calibrated bar.
    """
    found = effect_of(work.result, f"scale_error_{ENDS[index]}")
    return None if found is None else ValueWithError(found.value / _PPM, found.std_error / _PPM)


def mismatch(work: CircleWork) -> ValueWithError | None:
    """Return the scale error of the first axis of a circular test minus that of its second axis,
    mm/mm.
    """
    found = effect_of(work.result, "scale_mismatch")
    across = 2.0 * work.planned.test.nominal_radius * _UM
    return None if found is None else ValueWithError(found.value / across, found.std_error / across)


class CircleChecks:
    """Comparison of every circular test of a job with the positioning tests of its axes."""

    def __init__(
        self, job: Job, works: Mapping[str, AxisWork], states: Mapping[str, ActiveCorrections]
    ) -> None:
        self.job = job
        self.works = works
        self.states = states

    def laser(self, work: CircleWork, index: int) -> LaserValues | None:
        """Return the lost motion and scale error of the first (``index`` 0) or second axis of a
        circular test, computed from the axis' positioning test. None without a positioning test in
        both directions.
        """
        axis = self.works.get(work.planned.test.axes[index])
        if axis is None or not axis.results[0].test.bidirectional:
            return None
        found = laser_values(
            work, axis, index, self.states.get(work.planned.measured_in, NO_CORRECTIONS)
        )
        budget = self.job.uncertainty
        own = budget.device_per_m / 2.0 / _PPM if budget is not None else 0.0
        return replace(
            found, scale=replace(found.scale, std_error=float(np.hypot(found.scale.std_error, own)))
        )

    def findings(self, circles: Sequence[CircleWork]) -> Iterator[Finding]:
        """Yield a finding for each value from a circular test that differs from the value of a
        positioning test by more than both uncertainties allow.
        """
        for work in circles:
            both = [self.laser(work, index) for index in (0, 1)]
            for index, laser in enumerate(both):
                if laser is not None:
                    yield from self._lost(work, index, laser)
                    yield from self._scale(work, index, laser)
            if both[0] is not None and both[1] is not None:
                yield from self._mismatch(work, both[0], both[1])

    def _lost(self, work: CircleWork, index: int, laser: LaserValues) -> Iterator[Finding]:
        circle = lost_motion(work, index)
        if circle is None or not circle.differs(laser.lost_motion):
            return
        counts = "circle" if self.job.apply.backlash_from == "circle" else "laser"
        yield Finding.of(
            "CW-P114",
            "warning",
            axis=work.planned.test.axes[index],
            laser=laser.lost_motion.words(_UM, "µm"),
            circle=circle.words(_UM, "µm"),
            test=work.name,
            counts=counts,
        )

    def _scale(self, work: CircleWork, index: int, laser: LaserValues) -> Iterator[Finding]:
        circle = scale_error(work, index)
        if circle is None or not circle.differs(laser.scale):
            return
        low, high = measured_range(work.planned, index)
        yield Finding.of(
            "CW-P115",
            "warning",
            axis=work.planned.test.axes[index],
            laser=laser.scale.words(_PPM, "µm/m"),
            circle=circle.words(_PPM, "µm/m"),
            test=work.name,
            low=float(low),
            high=float(high),
        )

    def _mismatch(
        self, work: CircleWork, first: LaserValues, second: LaserValues
    ) -> Iterator[Finding]:
        circle = mismatch(work)
        error = float(np.hypot(first.scale.std_error, second.scale.std_error))
        laser = ValueWithError(first.scale.value - second.scale.value, error)
        if circle is None or not circle.differs(laser):
            return
        axes = work.planned.test.axes
        pair, test = " minus ".join(axes), work.name
        by_laser, by_circle = (each.words(_PPM, "µm/m") for each in (laser, circle))
        clear = all(
            abs(each.value) > max(CONTRADICTORY * each.std_error, SQUARE)
            for each in (circle, laser)
        )
        if clear and circle.value * laser.value < 0.0:
            yield Finding.of(
                "CW-P172", "warning", axes, pair=pair, laser=by_laser, circle=by_circle, test=test
            )
        else:
            yield Finding.of(
                "CW-P116", "warning", pair=pair, laser=by_laser, circle=by_circle, test=test
            )

    def with_circle_backlash(
        self, circles: Sequence[CircleWork]
    ) -> tuple[dict[str, AxisWork], tuple[Finding, ...]]:
        """Return the axes by name, with the findings about them. If the job requires it, an axis
        has the lost motion from its circular tests instead of its positioning tests.
        """
        works = dict(self.works)
        findings: list[Finding] = []
        if self.job.apply.backlash_from != "circle":
            return works, ()
        untested = [
            self._no_test(name)
            for name, entry in self.job.axes.items()
            if not entry.before and _on(circles, name)
        ]
        findings += untested
        for name, axis in self.works.items():
            shift = self._shift(name, circles)
            if shift is None:
                findings.append(self._not_taken(name, circles))
                continue
            works[name] = _shifted(axis, shift.value)
            findings.append(Finding.of("CW-P117", "info", axis=name, shift=shift.words(_UM, "µm")))
        if not untested and not any(finding.code == "CW-P117" for finding in findings):
            findings.append(Finding.of("CW-P130.none", "error"))
        return works, tuple(findings)

    def _no_test(self, name: str) -> Finding:
        return Finding.of("CW-P130.no_test", "error", axis=name)

    def _not_taken(self, name: str, circles: Sequence[CircleWork]) -> Finding:
        """Return the finding that an axis keeps the lost motion of its positioning test: a warning
        if no circular test moves the axis, else an error.
        """
        if not _on(circles, name):
            return Finding.of("CW-P130.no_circle", "warning", axis=name)
        return Finding.of("CW-P130.unknown", "error", axis=name)

    def _shift(self, name: str, circles: Sequence[CircleWork]) -> ValueWithError | None:
        """Return by how much the lost motion (mm) of an axis is larger in its circular tests
        (weighted mean) than in its positioning test. None if no circular test can be compared.
        """
        values, weights = [], []
        for work in circles:
            if name not in work.planned.test.axes:
                continue
            index = work.planned.test.axes.index(name)
            circle, laser = lost_motion(work, index), self.laser(work, index)
            if circle is not None and laser is not None:
                values.append(circle.value - laser.lost_motion.value)
                weights.append(circle.std_error**-2)
        if not values:
            return None
        return ValueWithError(
            float(np.average(values, weights=weights)), float(np.sum(weights) ** -0.5)
        )


def _on(circles: Sequence[CircleWork], name: str) -> bool:
    """Return whether any of the circular tests ``circles`` moves the axis ``name``."""
    return any(name in work.planned.test.axes for work in circles)


def _shifted(work: AxisWork, more: float) -> AxisWork:
    """Return the axis with its estimated lost motion increased by ``more`` (mm). Only the direction
    opposite to the reference return changes.
    """
    axis: Axis = work.planned.axis
    estimate = work.planned.estimate
    if axis.reference_return is Direction.POSITIVE:
        estimate = replace(estimate, mean_negative=estimate.mean_negative + more)
    else:
        estimate = replace(estimate, mean_positive=estimate.mean_positive - more)
    return replace(work, planned=replace(work.planned, estimate=estimate))
