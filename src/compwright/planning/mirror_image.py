"""Detection of tests whose deviations are the mirror image of the table that is stated as active.
That table was probably not active in the test.

The mirror image arises if the table was made from this very test. The table was then not active in
the test, and a further table would remove the same error twice.

The means of both directions are compared without their straight line. Temperature changes the line,
and a wrongly copied backlash value changes the distance between the directions; neither changes the
rest. A test that was taken with an active table shows what the table leaves: little of the table's
own shape, plus or minus a quarter (`planning.sign_and_unit_doubts`), and hardly ever all of it with
the opposite sign.

Two smooth curves may also look alike by chance, and more easily if they have few bends. The doubt
states the probability of this, and there is no doubt if it is large.

If the table changes an older table, it is the mirror image of the test only where the older one is
small relative to the change. Where it is not, the shapes cannot decide, but the plan of that run
can (`workflow.inputs.own_output`). The scatter that test and table share cannot decide either: in
simulations with 11 targets, 1 to 4 % of such tests are recognised, and 1 % of new tests are doubted
although only their error has grown.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final

import numpy as np

from compwright.estimation.observed_test import ObservedTest
from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.wanted_correction import axis_compensation
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest

#: The code of the doubt: no table is written without its acknowledgement.
MIRRORED: Final = "CW-P161"
#: With fewer targets a shape says nothing.
_FEWEST: Final = 6
#: Both shapes are so many times the noise of a mean.
_SEEN: Final = 4.0
#: What the table has not of the test's shape: this part of the smaller one at most, and twice the
#: noise. Steps of the control, short waves between its points, and the shape of an older table that
#: was in the control before stay in the sum of both. Less than 1 % of sound tests that show as much
#: as their table has come below.
_LEFT: Final = 0.45
_NOISE: Final = 2.0
#: Largest probability of so much likeness by chance. Simulated, 1 000 tests each: of tests given
#: with their own table 64 % instead of 66 % are doubted, of worn axes 3.0 % instead of 3.7 %, of
#: axes with a table made for another error 1.9 % instead of 3.0 %, of other sound tests
#: below 0.1 %.
_CHANCE: Final = 0.1


def mirror_image_doubts(
    tests: Sequence[PlannedTest],
    observed: Sequence[ObservedTest],
    axis: Axis,
    states: Mapping[str, ControlState],
) -> Iterator[tuple[int, Finding]]:
    """Yield index and doubt (CW-P161) of each test whose deviations mirror the active table.
    ``observed``: the same tests, each with its active correction subtracted.

    The table is that of the test's state. If another state has a table too, the difference of both
    tables is tried as well.
    """
    for place, (planned, bare) in enumerate(zip(tests, observed, strict=True)):
        if planned.measured_in not in states or planned.test.targets.size < _FEWEST:
            continue
        test = planned.test
        there = _middle_of_table(states[planned.measured_in], axis, test)
        before = [
            _middle_of_table(state, axis, test)
            for name, state in states.items()
            if name != planned.measured_in
        ]
        noise = _noise(bare)
        shown = mean_of_directions(test)
        changes = (there, *(there - other for other in before))
        if shown is None:
            continue
        chances = [chance_of_mirror(change, shown, test.targets, noise) for change in changes]
        if min(chances) <= _CHANCE:
            yield place, _doubt(planned, axis, shown, min(chances))


def chance_of_mirror(
    table: FloatArray, shown: FloatArray, targets: FloatArray, noise: float
) -> float:
    """Return the probability that ``table`` (m,) mirrors the deviations ``shown`` (m,) by chance.
    It is 1 if ``table`` does not mirror them.

    Both are at ``targets`` (m,), mm or deg. ``noise``: standard deviation of a mean. A curve by
    chance has as many bends, a random direction in the space of such curves (the cap of a sphere),
    and a random size within a decade.
    """
    along = np.linspace(-1.0, 1.0, targets.size) if targets.size < 2 else targets - targets.mean()
    bent, seen = (
        curve - np.polyval(np.polyfit(along, curve, 1), along) for curve in (table, shown)
    )
    sizes = [float(np.sqrt(np.mean(np.square(curve)))) for curve in (bent, seen)]
    if min(sizes) <= max(_SEEN * noise, 1e-9):
        return 1.0
    left = float(np.sqrt(np.mean(np.square(seen + bent))))
    if left > float(np.hypot(_LEFT * min(sizes), _NOISE * noise)):
        return 1.0
    apart = min(1.0, float(np.sqrt(max(left**2 - noise**2, 0.0))) / sizes[0])
    others = _number_of_bends(bent / sizes[0], seen / sizes[1]) - 2.0
    angles = np.linspace(0.0, np.pi, 4002)[1:-1]
    density = np.sin(angles) ** others  # of the angle between two directions of that space
    direction = float(np.sum(density[angles < np.arcsin(apart)]) / np.sum(density))
    return direction * min(1.0, 2.0 * apart / float(np.log(10.0)))


def _number_of_bends(*curves: FloatArray) -> float:
    """Return the effective number of cosine waves in the curves (m,), weighted by their power."""
    m = curves[0].size
    waves = np.cos(np.pi * np.outer(np.arange(2, m), (np.arange(m) + 0.5) / m))
    power = sum(np.square(waves @ curve) for curve in curves)
    return max(1.2, float(np.sum(power) ** 2 / np.sum(np.square(power))))


def mean_of_directions(test: PositioningTest) -> FloatArray | None:
    """Return the mean (m,) of the measured directions at each target, or None if a target has no
    reading.
    """
    means = [
        mean_deviation(test.deviations(direction))
        for direction in Direction
        if test.readings(direction).any()
    ]
    middle: FloatArray = np.mean(means, axis=0)
    return middle if np.all(np.isfinite(middle)) else None


def _middle_of_table(state: ControlState, axis: Axis, test: PositioningTest) -> FloatArray:
    table = axis_compensation(state, axis)
    curves = [
        table.at(test.targets, direction)
        for direction in Direction
        if test.readings(direction).any()
    ]
    middle: FloatArray = np.mean(curves, axis=0)
    return middle


def _noise(bare: ObservedTest) -> float:
    """Return the standard deviation of the mean of all readings at one target, both directions
    together.
    """
    counts = sum(count_readings(bare.test.deviations(direction)) for direction in Direction)
    return 0.0 if bare.noise is None else float(bare.noise.sigma / np.sqrt(np.max(counts)))


def _doubt(planned: PlannedTest, axis: Axis, shown: FloatArray, chance: float) -> Finding:
    unit = shown_unit(axis.kind.unit)
    size = float(np.ptp(shown)) * outside_factor(axis.kind.unit)
    return Finding.of(
        "CW-P161",
        "warning",
        measured_in=planned.measured_in,
        test=planned.test.name,
        size=size,
        unit=unit,
        chance=100.0 * max(chance, 0.001),
        less=chance < 0.001,
    )
