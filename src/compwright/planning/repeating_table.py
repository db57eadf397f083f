"""A second table, repeated over the axis, for a period too short for the points of the main table.

The second table has whole increments whose sum over a period is zero. Its values approximate the
error that the main table leaves, averaged over all periods.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.fitting.period_removal import without_periods
from compwright.foundations.errors import CapacityError
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.separate_line import WORTH, Fit
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity, Wave
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.words.sentences import Amount, say

#: A grid holds a period that is at least so many spacings long.
HELD: Final = 2.5
#: Sections of one period, the first that fits the control's lengths: ten as in the maker's example.
_SECTIONS: Final = (10, 12, 9, 8, 16, 15, 20)


def with_repeating_table(
    fit: Fit,
    wanted: WantedCorrection,
    capacity: Capacity,
    request: TableRequest,
    plain: FittedTable,
) -> FittedTable:
    """Return the table ``plain``, supplemented by a second table that repeats with a known short
    period. ``fit`` fits the main table again.

    The second table is used only if it clearly reduces the remaining error. Otherwise the result is
    ``plain`` alone. A finding states the errors with and without the second table.
    """
    if capacity.wave is None or plain.compensation.positions.size < 2:
        return plain
    spacing = float(np.min(np.diff(plain.compensation.positions)))
    turn = capacity.period or 0.0
    whole = [
        period
        for period in wanted.periods
        if period < HELD * spacing and abs(turn / period - round(turn / period)) < 1e-9
    ]
    rest = _left(wanted, plain.compensation, whole)
    wave = next(
        (found for p in whole if (found := _wave(wanted, rest, plain, p, capacity.wave))), None
    )
    if wave is None:
        return plain
    with_waves = replace(capacity, stays=(*plain.compensation.others, wave), slope=None, wave=None)
    points = plain.compensation.positions
    kept = replace(request, start=float(points[0]), end=float(points[-1]), spacing=spacing)
    try:
        waved = fit(with_waves, request if plain.keeps_grid else kept)
    except CapacityError:
        return plain
    left, with_it = (float(np.std(_left(wanted, each.compensation, ()))) for each in (plain, waved))
    factor, unit = outside_factor(wanted.kind.unit), shown_unit(wanted.kind.unit)
    period_text = say(
        "CW-P143.period",
        period=wave.period,
        unit=wanted.kind.unit,
        sections=spacing,
        left=Amount(left * factor, unit, ".3f"),
        with_it=Amount(with_it * factor, unit, ".3f"),
    )
    if left - with_it <= WORTH * left:
        note = Finding.of("CW-P143.none", "info", period=period_text)
        return replace(plain, findings=(*plain.findings, note))
    note = Finding.of("CW-P143.second", "info", period=period_text)
    return replace(waved, findings=(*waved.findings, note))


def _left(
    wanted: WantedCorrection, table: AxisCompensation, periods: Sequence[float]
) -> FloatArray:
    """Return the mean error (g,) of both directions that ``table`` leaves, at the positions of
    ``wanted``.

    The main table is taken as straight between its points, so that its steps do not look like a
    wave. The ``periods`` (mm or deg) that the main table reproduces are added to the remaining
    error, because the repeating table takes them over completely.
    """
    straight = replace(table, interpolation="linear", backlash=0.0)
    plus, minus = (straight.at(wanted.positions, side) for side in Direction)
    held = replace(wanted, positive=plus, negative=minus)
    if periods:
        held, _ = without_periods(held, periods)
    both = [wanted.total(side) - held.total(side) for side in Direction]
    return np.asarray(np.mean(both, axis=0))


def _wave(
    wanted: WantedCorrection, rest: FloatArray, plain: FittedTable, period: float, limits: Wave
) -> AxisCompensation | None:
    """Return the second table over one ``period``, starting at the reference, fitted to the error
    ``rest`` that the table ``plain`` leaves. None if the control cannot hold this table, or if all
    its values are zero.
    """
    sections = next((n for n in _SECTIONS if limits.holds(period / n)), None)
    if sections is None or sections + 1 > limits.room:
        return None
    interval = period / sections
    phase = np.mod((wanted.positions - wanted.reference) / interval + 0.5, sections)
    place = np.minimum(phase.astype(np.int64), sections - 1)
    counts = np.bincount(place, minlength=sections)
    if not np.all(counts):
        return None
    means = np.bincount(place, weights=rest, minlength=sections) / counts
    totals = np.round((means - means[0]) / limits.unit)
    totals = np.append(totals, totals[0])
    if not np.any(totals) or np.max(np.abs(np.diff(totals))) > limits.increment:
        return None
    curve = totals * limits.unit
    steps = np.arange(sections + 1, dtype=np.float64)
    points: FloatArray = wanted.reference + interval * steps
    return replace(
        plain.compensation,
        positions=points,
        positive=curve,
        negative=curve,
        backlash=0.0,
        period=period,
        others=(),
    )
