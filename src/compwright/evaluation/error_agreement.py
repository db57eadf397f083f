"""Comparison of each further test of an axis with the first one. Only tests that show the same
error are used together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.positioning import PositioningTest

#: Two tests of one axis differ by their noise, by a few µm/m of temperature and by the wave of a
#: screw that one of them misses. More than half of the error itself, and three times what noise
#: explains, is none of these.
_OF_THE_ERROR: Final = 0.5
_OF_THE_NOISE: Final = 3.0
_FEWEST: Final = 3
#: Lost motion that comes and goes by this much, with load and lubrication, is no contradiction: 2
#: µm, 2 arcsec.
_REVERSAL: Final = {AxisKind.LINEAR: 2e-3, AxisKind.ROTARY: 2.0 / 3600.0}


def disagreeing_test(
    test: PositioningTest,
    expected: Mapping[Direction, FloatArray],
    std: Mapping[Direction, FloatArray],
    noise: float,
    names: tuple[str, str],
    unknown: Sequence[float] = (),
) -> Finding | None:
    """Return the finding CW-T036 if ``test`` contradicts the error ``expected`` from another test
    of the axis (standard deviation ``std``), else None. Waves of periods ``unknown`` to the other
    test do not count.

    ``expected``, ``std`` (m,) for each direction: the error at the targets of ``test``, as
    estimated from the other test, mm or deg. ``noise``: standard deviation of one reading of
    ``test``, mm or deg. ``names``: the test that is used, then the test that is not used. The zero
    of the instrument does not count. The comparison detects reversed signs or directions, another
    axis, another unit, and another state of the control.
    """
    shown, wanted, spread, where = [], [], [], []
    for direction in Direction:
        block = test.deviations(direction)
        if block.shape[1] and direction in expected:
            where.append(test.targets)
            shown.append(mean_deviation(block))
            wanted.append(expected[direction])
            spread.append(
                np.hypot(std[direction], noise / np.sqrt(np.maximum(count_readings(block), 1.0)))
            )
    if not shown:
        return None
    measured, meant, error, places = (
        np.concatenate(parts) for parts in (shown, wanted, spread, where)
    )
    known = np.isfinite(measured) & np.isfinite(meant)
    if np.count_nonzero(known) < _FEWEST:
        return None
    apart, size = (
        _rms(_without(measured[known] - meant[known], places[known], unknown)),
        max(_rms(measured[known]), _rms(meant[known])),
    )
    what = "error"
    if apart <= max(
        _OF_THE_ERROR * size, _OF_THE_NOISE * float(np.sqrt(np.mean(error[known] ** 2)))
    ):
        if len(shown) < 2:
            return None
        mine, theirs = (float(np.nanmean(parts[0] - parts[1])) for parts in (shown, wanted))
        apart, size, what = (
            abs(mine - theirs),
            max(abs(mine), abs(theirs)),
            "reversal",
        )
        if apart <= max(
            _OF_THE_ERROR * size,
            _OF_THE_NOISE * float(np.sqrt(np.mean(error[known] ** 2))),
            _REVERSAL[test.kind],
        ):
            return None
    factor, unit = outside_factor(test.kind.unit), shown_unit(test.kind.unit)
    return Finding.of(
        "CW-T036",
        "warning",
        test=names[0],
        other=names[1],
        difference=apart * factor,
        unit=unit,
        what=what,
        size=size * factor,
    )


def _without(values: FloatArray, where: FloatArray, periods: Sequence[float]) -> FloatArray:
    """Return the ``values`` at positions ``where`` after waves of the given ``periods`` are
    subtracted, with the amplitudes that fit the values best.
    """
    if not periods or values.size <= 2 * len(periods) + 1:
        return values
    turns = 2.0 * np.pi * where[:, np.newaxis] / np.asarray(periods)
    waves = np.column_stack([np.ones_like(where), np.cos(turns), np.sin(turns)])
    weights = np.linalg.lstsq(waves, values, rcond=None)[0]
    return np.asarray(values - waves @ weights, dtype=np.float64)


def _rms(values: FloatArray) -> float:
    """Return the rms of values about their mean: the zero of the instrument does not count."""
    return float(np.std(values))
