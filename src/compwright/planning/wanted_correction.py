"""The wanted correction of an axis, from its tests and the state of the control."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.axis import AxisPosterior, Draws, estimate_axis
from compwright.estimation.hidden_periods import HiddenPeriods
from compwright.estimation.noise import infer_noise
from compwright.estimation.noise_days import over_days
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.observed_test import ObservedTest
from compwright.evaluation.valid_readings import without_traverses, zero_traverses
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlState, no_compensation
from compwright.records.estimate import ErrorEstimate, WantedCorrection
from compwright.records.plan import Acted, PlannedTest
from compwright.records.positioning import PositioningTest

#: Largest ratio of the scatter of tests that were taken in the same way.
_ANOTHER_DAY: Final = 5.0
#: Points over the travel at which estimate and wanted correction are kept: at least, at most, and
#: per period.
DENSE_LEAST = 401
DENSE_MOST = 4001
DENSE_PER_PERIOD = 10
#: Share of the travel that the targets of an axis have to cover at least.
LEAST_COVERED = 0.5
#: Slope (mm/mm) by which two tests may differ where no uncertainty is declared: a machine that has
#: run, or a hall later in the day, is easily one kelvin warmer, and steel grows by 11.5 µm/m per
#: kelvin.
UNDECLARED_SLOPE = 11.5e-6


@dataclass(frozen=True, slots=True, eq=False)
class MeasuredError:
    """The error of an axis estimated from its tests, and the known correction in the first test.

    A table may have any shape. Therefore the active table is subtracted before the smooth error is
    estimated, and added again exactly.

    ``counted``: for each test of the axis its index in the estimate, or None if it is not in use.
    ``noises``: for each test the noise from its repeated readings. ``alike``: indices of the tests
    in use that were measured in the same way as the first test.
    """

    own: AxisPosterior
    active: AxisCompensation | None
    counted: tuple[int | None, ...] = (0,)
    noises: tuple[NoisePosterior | None, ...] = (None,)
    alike: tuple[int, ...] = ()

    @property
    def noise(self) -> float:
        """The standard deviation of one reading of the first test, mm or deg."""
        return self.own.noise

    @property
    def noise_dof(self) -> float:
        """The degrees of freedom of ``noise``."""
        return self.own.noise_dof

    @property
    def reversal_log_odds(self) -> float:
        """The log odds that the reversal error of the axis varies with position rather than being
        constant.
        """
        return self.own.reversal_log_odds

    @property
    def hidden(self) -> HiddenPeriods:
        """The possible periods of the error that the readings do not show."""
        return self.own.hidden

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The findings of the estimation about noise, periods and jumps of the error."""
        return self._reported(self.own.findings)

    def _reported(self, findings: tuple[Finding, ...]) -> tuple[Finding, ...]:
        return findings if len(self.alike) < 2 else tuple(map(_of_several_tests, findings))

    def summary(self, positions: FloatArray) -> ErrorEstimate:
        """Return mean and standard deviation of the deviation at ``positions`` (g,), with the
        correction of the first test active.
        """
        estimate = self.own.summary(positions)
        estimate = replace(estimate, findings=self._reported(estimate.findings))
        if self.active is None:
            return estimate
        return replace(
            estimate,
            mean_positive=estimate.mean_positive + self.active.at(positions, Direction.POSITIVE),
            mean_negative=estimate.mean_negative + self.active.at(positions, Direction.NEGATIVE),
        )

    def draw(
        self, positions: FloatArray, count: int, rng: np.random.Generator, test: int = 0
    ) -> Draws:
        """Return ``count`` random draws of the deviation at ``positions`` (k,) and of the noise of
        ``test``.

        ``test``: index among the tests of the axis. The deviation is that with the correction of
        the first test active.
        """
        place, own = self.counted[test], self.noises[test]
        draws = self.own.draw(positions, count, rng, place or 0)
        if place is None and own is not None:
            evenly = np.arange(count) * own.fresh.count // count
            draws = replace(draws, noise=own.fresh.taken(evenly))
        days = [each.fresh for each in (self.noises[k] for k in self.alike) if each is not None]
        if test in self.alike and len(days) > 1:
            noise = over_days(draws.noise, days, self.alike.index(test), rng)
            draws = replace(draws, noise=noise)
        if self.active is None:
            return draws
        return replace(
            draws,
            positive=draws.positive + self.active.at(positions, Direction.POSITIVE),
            negative=draws.negative + self.active.at(positions, Direction.NEGATIVE),
        )


def _of_several_tests(finding: Finding) -> Finding:
    """Return a finding about drift as it holds where several tests show how drift differs."""
    if "alone" not in finding.values:
        return finding
    values = {**finding.values, "alone": False}
    return replace(finding, sentence=replace(finding.sentence, values=tuple(values.items())))


def observed_tests(
    tests: Sequence[PlannedTest], active: AxisCompensation | None
) -> tuple[ObservedTest, ...]:
    """Return the tests as input of the estimation: each with its active correction subtracted
    (``active``: of the first test), and with noise inferred from repeated readings.

    Traverses that were not made (runs of exact zeros) are left out.
    """
    observed = []
    for place, planned in enumerate(tests):
        active_then = planned.acted
        test = without_traverses(planned.test, zero_traverses(planned.test))
        if place == 0 and active is not None:
            active_then = _at(active, test)
        bare = test if active_then is None else with_change(test, -active_then[0], -active_then[1])
        observed.append(
            ObservedTest(test=bare, noise=infer_noise(bare), slope_std=planned.slope_std)
        )
    return tuple(observed)


def measured_error(
    tests: Sequence[PlannedTest],
    observed: Sequence[ObservedTest],
    axis: Axis,
    active: AxisCompensation | None,
) -> MeasuredError:
    """Return the error of ``axis``, estimated from the tests that are in use. ``observed``: the
    same tests as input of the estimation; ``active``: the correction that was active in the first
    test, None where it is unknown.

    Tests in use are those whose active correction is known, or the first test alone if it is known
    of none. The same tests always give the same result.
    """
    counting = [test.acted is not None for test in tests]
    counting[0] = counting[0] or not any(counting)
    places = np.cumsum(counting) - 1
    own = estimate_axis(
        _with_own_slopes([each for each, counts in zip(observed, counting, strict=True) if counts]),
        travel=axis.travel,
        periods=axis.screw_pitch,
        suggested=() if axis.suggested_period is None else (axis.suggested_period,),
        points=() if active is None else _points_of(active),
        turn=axis.modulo,
    )
    return MeasuredError(
        own,
        active,
        tuple(int(p) if counts else None for p, counts in zip(places, counting, strict=True)),
        tuple(each.noise for each in observed),
        _taken_alike(tests, observed),
    )


def _taken_alike(tests: Sequence[PlannedTest], observed: Sequence[ObservedTest]) -> tuple[int, ...]:
    """Return the indices of those tests in use that were measured in the same way as the first
    test, and whose noise is known.

    These tests have the same motion and the same numbers of targets and readings, so that they
    lasted equally long. A test whose scatter differs by more than `_ANOTHER_DAY` was measured in
    another way.
    """
    first = observed[0].noise
    if first is None:
        return ()

    def way(place: int) -> tuple[object, ...]:
        test = observed[place].test
        return tests[place].motion, test.cycle, test.positive.shape, test.negative.shape

    return tuple(
        place
        for place, each in enumerate(observed)
        if each.noise is not None
        and tests[place].acted is not None
        and way(place) == way(0)
        and 1.0 / _ANOTHER_DAY < each.noise.sigma / max(first.sigma, 1e-12) < _ANOTHER_DAY
    )


def _points_of(active: AxisCompensation) -> tuple[float, ...]:
    """Return the points of the active compensation tables."""
    tables = [
        each
        for each in (active, *active.others)
        if np.any(each.positive != 0.0) or np.any(each.negative != 0.0)
    ]
    together = [table.positions for table in tables]
    return tuple(np.unique(np.concatenate(together)).tolist()) if together else ()


def _with_own_slopes(tests: Sequence[ObservedTest]) -> list[ObservedTest]:
    """Return the tests, each with the standard deviation of its own slope error, such as from
    temperature.

    It is the declared standard deviation if there is one. Otherwise it is `UNDECLARED_SLOPE`,
    relative to the first test that covers more than half of the measured range, because a short
    test does not determine a slope. A rotary axis has none: angles do not grow with temperature.
    """
    ranges = np.array([(each.test.targets[0], each.test.targets[-1]) for each in tests])
    lengths = np.round(np.ptp(ranges, axis=1) / max(float(np.ptp(ranges)), 1e-12), 6)
    level = int(np.argmax(np.minimum(lengths, 0.5)))
    return [
        each
        if place == level or each.slope_std > 0.0 or each.test.kind is AxisKind.ROTARY
        else replace(each, slope_std=UNDECLARED_SLOPE)
        for place, each in enumerate(tests)
    ]


def _at(active: AxisCompensation, test: PositioningTest) -> Acted:
    return (
        active.at(test.targets, Direction.POSITIVE),
        active.at(test.targets, Direction.NEGATIVE),
    )


def check_coverage(file: str, axis: Axis, tests: Sequence[PositioningTest]) -> None:
    """Raise InputError if the targets of all tests together cover less than half of the travel.

    Outside the targets the table is extrapolated, and with less than half of the travel covered it
    would be a guess. A gap between two tests is not covered. For an endless axis, the covered part
    is the turn minus the largest gap between neighbouring targets; it is compared with the travel
    within one turn.
    """
    low, high = axis.travel
    targets = np.unique(np.concatenate([test.targets for test in tests]))
    if axis.modulo is not None:
        travel = min(high - low, axis.modulo)
        around = np.unique(np.mod(targets, axis.modulo))
        measured = axis.modulo - float(np.max(np.diff(np.append(around, around[0] + axis.modulo))))
    else:
        travel = high - low
        measured = covered_travel(tests, low, high)
    if measured >= LEAST_COVERED * travel - 1e-9 * travel:
        return
    unit = axis.kind.unit
    names = " and ".join(test.name for test in tests)
    which = f"test {names}" if len(tests) == 1 else f"tests {names}"
    raise InputError(
        Fault(
            message=(
                f"the table of axis {axis.name} is made from {which}, whose targets cover less "
                "than half of the travel; the rest would have to be guessed"
            ),
            file=file,
            place=f"axes.{axis.name}.travel",
            expected=(
                f"targets over at least half of {travel:g} {unit}, or a `travel` of which at least "
                "half was measured"
            ),
            found=(
                f"targets from {targets[0]:g} to {targets[-1]:g} {unit}, travel {low:g} to {high:g}"
                f" {unit}"
            ),
            hint=("measure over the whole travel, or set `travel` to the measured part"),
        )
    )


def covered_travel(tests: Sequence[PositioningTest], low: float, high: float) -> float:
    """Return the share of the travel between the first and the last target of any test."""
    ranges = sorted(
        (max(float(test.targets[0]), low), min(float(test.targets[-1]), high)) for test in tests
    )
    length, reached = 0.0, -np.inf
    for start, end in ranges:
        length += max(0.0, end - max(start, reached))
        reached = max(reached, end)
    return length


def axis_compensation(state: ControlState, axis: Axis) -> AxisCompensation:
    """Return the compensation of an axis in a ``state`` of the control: zero where the state lacks
    the axis.
    """
    none = no_compensation(axis.address, axis.kind, axis.reference_return)
    return applied_compensation(state.axes.get(axis.address, none), axis)


def dense_positions(axis: Axis, periods: Sequence[float]) -> FloatArray:
    """Return closely and equally spaced positions over the travel, or over one turn from the
    reference for an endless axis.

    They are close enough to reproduce the shortest of the ``periods`` (mm or deg).
    """
    low, high = (
        axis.travel if axis.modulo is None else (axis.reference, axis.reference + axis.modulo)
    )
    wanted = DENSE_LEAST
    if periods:
        wanted = int(np.ceil((high - low) / min(periods) * DENSE_PER_PERIOD)) + 1
    return np.linspace(low, high, int(np.clip(wanted, DENSE_LEAST, DENSE_MOST)))


def wanted_correction(
    estimate: ErrorEstimate, active: AxisCompensation, axis: Axis, *, reversal_log_odds: float
) -> WantedCorrection:
    """Return the total correction that removes the estimated error: the correction ``active``
    during the test minus the error. ``reversal_log_odds``: log odds that the reversal error varies
    with position.

    wanted(x, d) = active(x, d) - error(x, d), shifted by one constant. The shift makes it zero at
    the reference, approached in the reference-return direction. If the reference lies outside the
    travel, the nearest end of the travel is used instead. Periods are included if they are more
    probable than not.
    """
    positive = active.at(estimate.positions, Direction.POSITIVE) - estimate.mean_positive
    negative = active.at(estimate.positions, Direction.NEGATIVE) - estimate.mean_negative
    at_reference = positive if axis.reference_return is Direction.POSITIVE else negative
    shift = float(np.interp(axis.reference, estimate.positions, at_reference))
    return WantedCorrection(
        kind=axis.kind,
        positions=estimate.positions,
        positive=positive - shift,
        negative=negative - shift,
        reference=axis.reference,
        reference_return=axis.reference_return,
        noise=estimate.noise,
        reversal_log_odds=reversal_log_odds,
        periods=tuple(each.period for each in estimate.periods if each.named),
    )


def without_kept_tables(
    wanted: WantedCorrection, stays: Sequence[AxisCompensation]
) -> WantedCorrection:
    """Return the wanted correction minus the existing tables that stay active, zero at the
    reference.
    """
    if not stays:
        return wanted
    curves = {}
    for direction in Direction:
        theirs = np.sum([one.at(wanted.positions, direction) for one in stays], axis=0)
        curves[direction] = wanted.total(direction) - theirs
    at_reference = curves[wanted.reference_return]
    shift = float(np.interp(wanted.reference, wanted.positions, at_reference))
    positive, negative = (curves[direction] - shift for direction in Direction)
    return replace(wanted, positive=positive, negative=negative)


def with_change(
    test: PositioningTest, positive: FloatArray, negative: FloatArray
) -> PositioningTest:
    """Return the test as measured if the correction were changed by ``positive`` and ``negative``
    (m,).
    """
    return replace(
        test,
        positive=test.positive + positive[:, np.newaxis],
        negative=test.negative + negative[:, np.newaxis],
    )
