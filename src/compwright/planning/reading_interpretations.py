"""Alternative interpretations of a test: signs, directions, units or active tables other than
stated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Final, Literal

import numpy as np

from compwright.estimation.likelihood import smooth_part
from compwright.estimation.model import Travel
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.observed_test import ObservedTest
from compwright.evaluation.statistics import count_readings
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.plan import Acted
from compwright.records.positioning import PositioningTest

Interpretation = Literal["stated", "off", "sign", "directions", "order", "against"]
ActiveAt = Callable[[FloatArray, Direction], FloatArray]
#: Targets as symmetric as this (of their interval) look the same in the opposite order.
_SYMMETRIC: Final = 1e-3
#: A table whose shape is below this share of the noise of a mean tells nothing.
_SHAPELESS: Final = 0.5


@dataclass(frozen=True, slots=True)
class InterpretedTest:
    """One interpretation of a test: the resulting ``error`` of the axis, and the known ``table`` at
    the targets, (m,) by direction, mm or deg.
    """

    way: Interpretation
    error: ObservedTest
    table: Acted | None = None
    smooth: Acted | None = None


def reading_interpretations(
    bare: ObservedTest, axis: Axis, active_at: ActiveAt | None
) -> tuple[InterpretedTest, ...]:
    """Return the interpretations of a test that its readings can distinguish, the stated one first.
    ``bare``: the test with its active correction ``active_at`` (mm or deg, None: unknown)
    subtracted.
    """
    table = None if active_at is None else _at(active_at, bare.test.targets)
    if active_at is None or table is None or not _has_shape(bare, table):
        stated = InterpretedTest("stated", bare)
        if _symmetric(bare.test.targets):
            return (stated,)
        return stated, InterpretedTest("order", _in_opposite_order(bare))
    return tuple(_with_table(bare, axis, active_at, table))


def _with_table(
    bare: ObservedTest, axis: Axis, active_at: ActiveAt, table: Acted
) -> Iterator[InterpretedTest]:
    raw, smooth = add_to_readings(bare, table), _smooth(bare.test, axis, table)
    yield InterpretedTest("stated", bare, table, smooth)
    yield InterpretedTest("off", raw, table, smooth)
    yield InterpretedTest("sign", _less(_turned(raw), table), table, smooth)
    yield InterpretedTest("directions", _less(_exchanged(raw), table), table, smooth)
    yield InterpretedTest("order", _less(_in_opposite_order(raw), table), table, smooth)
    if axis.modulo is None:
        against = _counted_against(raw, sum(axis.travel))
        there = _at(active_at, against.test.targets)
        error = _less(against, there)
        yield InterpretedTest("against", error, there, _smooth(against.test, axis, there))


def _at(active_at: ActiveAt, targets: FloatArray) -> Acted:
    return active_at(targets, Direction.POSITIVE), active_at(targets, Direction.NEGATIVE)


def _has_shape(bare: ObservedTest, table: Acted) -> bool:
    """Return whether a table clearly differs from a straight line with backlash, beyond the noise
    of the test ``bare``.
    """
    test = bare.test
    along = np.linspace(-1.0, 1.0, test.targets.size)
    left = [
        curve - np.polyval(np.polyfit(along, curve, 1), along)
        for side, curve in zip(Direction, table, strict=True)
        if test.readings(side).any()
    ]
    counts = np.concatenate([count_readings(test.deviations(side)) for side in Direction])
    noise = bare.noise.sigma / np.sqrt(np.max(counts)) if bare.noise is not None else 0.0
    return float(np.sqrt(np.mean(np.square(left)))) > max(_SHAPELESS * noise, 1e-9)


def _symmetric(targets: FloatArray) -> bool:
    interval = float(targets[-1] - targets[0]) / max(targets.size - 1, 1)
    midpoints = targets + targets[::-1]
    return float(np.ptp(midpoints)) <= _SYMMETRIC * interval


def _smooth(test: PositioningTest, axis: Axis, table: Acted) -> Acted:
    blocks = [
        curve[:, np.newaxis] if test.readings(side).any() else np.empty((curve.size, 0))
        for side, curve in zip(Direction, table, strict=True)
    ]
    alone = ObservedTest(test=replace(test, positive=blocks[0], negative=blocks[1]))
    return smooth_part(alone, Travel(*axis.travel, axis.modulo))


def add_to_readings(observed: ObservedTest, more: Acted) -> ObservedTest:
    """Return a test with the values ``more``, (m,) by direction, added to its readings."""
    test, noise = observed.test, observed.noise
    added = np.concatenate(more)
    return replace(
        observed,
        test=replace(
            test,
            positive=test.positive + more[0][:, np.newaxis],
            negative=test.negative + more[1][:, np.newaxis],
        ),
        noise=noise and replace(noise, mean=noise.mean + np.where(noise.precision > 0, added, 0.0)),
    )


def _less(observed: ObservedTest, what: Acted) -> ObservedTest:
    return add_to_readings(observed, (-what[0], -what[1]))


def _turned(observed: ObservedTest) -> ObservedTest:
    test, noise = observed.test, observed.noise
    return replace(
        observed,
        test=replace(test, positive=-test.positive, negative=-test.negative),
        noise=noise and replace(noise, mean=-noise.mean),
    )


def _exchanged(observed: ObservedTest) -> ObservedTest:
    test = observed.test
    order = np.roll(np.arange(2 * test.targets.size), test.targets.size)
    return replace(
        observed,
        test=replace(
            test,
            positive=test.negative,
            negative=test.positive,
            runs_positive=test.runs_negative,
            runs_negative=test.runs_positive,
        ),
        noise=observed.noise and _ordered(observed.noise, order),
    )


def _in_opposite_order(observed: ObservedTest) -> ObservedTest:
    test = observed.test
    m = test.targets.size
    order = np.concatenate([np.arange(m)[::-1], m + np.arange(m)[::-1]])
    return replace(
        observed,
        test=replace(test, positive=test.positive[::-1], negative=test.negative[::-1]),
        noise=observed.noise and _ordered(observed.noise, order),
    )


def _counted_against(observed: ObservedTest, ends: float) -> ObservedTest:
    """Return the test as if its instrument counted in the opposite direction. ``ends``: the sum of
    both ends of the travel.
    """
    turned = _exchanged(_turned(_in_opposite_order(observed)))
    targets = ends - observed.test.targets[::-1]
    return replace(turned, test=replace(turned.test, targets=targets))


def _ordered(
    noise: NoisePosterior, order: np.ndarray[tuple[int], np.dtype[np.intp]]
) -> NoisePosterior:
    return replace(
        noise,
        mean=noise.mean[:, order],
        precision=noise.precision[:, order],
        columns=noise.columns[:, order],
    )
