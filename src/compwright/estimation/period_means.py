"""Input of the search for periods: the mean of both directions at each target. Of many known
periods only the best are fitted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.basis import Basis
from compwright.estimation.cells import Cells
from compwright.estimation.period_likelihood import BidirectionalMeans, PeriodLikelihood
from compwright.estimation.periods import LEFT, wave_columns
from compwright.records.axis import FloatArray

#: So many known periods are fitted; of more, those of which the data tell most.
FITTED: Final = 6
#: A known period is there in nine cases of ten before the data: the job says so.
_KNOWN: Final = float(np.log(9.0))


def bidirectional_means(cells: Cells, *, endless: bool) -> BidirectionalMeans:
    """Return the mean of both directions at each target, mm or deg.

    The noise is that of its typical random draw (`CellData.typical`). Means of one direction are
    weighted by their precision (JCGM 100:2008, G.2.1 for sums, weighted); both directions have
    equal weight. The degrees of freedom follow from the variance 2 / dof of the log variance over
    the draws of the noise (JCGM 100:2008, eq. G.3).

    The result also has model columns with unknown weights. They are offset and slope of the axis
    (no slope on an ``endless`` axis), and offset and slope of each test. If a direction is missing
    at some targets, half the reversal is another unknown. An error common to all means of a
    traverse is also a straight line, so it needs no column of its own.
    """
    data = cells.data
    draw = data.typical()
    inferred = data.counts > 0
    precision = np.where(inferred, data.counts / cells.spread**2, data.precision[draw])
    share, variances = _averages(data.target_index, data.signs, precision, cells.targets.size)
    free = [np.ones(cells.targets.size)]
    if not endless:
        free.append((cells.targets - cells.targets[0]) / float(np.ptp(cells.targets)))
    single = share @ data.signs
    if np.ptp(single) > 0.5:
        free.append(single)
    return BidirectionalMeans(
        targets=cells.targets,
        values=cells.data.scale * (share @ data.values[draw]),
        variances=cells.data.scale**2 * variances,
        dof=data.dof if np.any(inferred) else _dof(data.precision),
        reading=cells.data.scale * cells.spread,
        free=np.column_stack([*free, share @ data.extra]),
    )


def _averages(
    target_index: np.ndarray[tuple[int], np.dtype[np.intp]],
    signs: FloatArray,
    precision: FloatArray,
    targets: int,
) -> tuple[FloatArray, FloatArray]:
    """Return the weights (m, c) of the c mean readings (``precision``: 1 / variance) in the average
    of both directions at each of m targets, and the variance (m,) of that average.
    """
    share, variance = np.zeros((targets, target_index.size)), np.zeros(targets)
    directions = np.zeros(targets)
    for sign in (1.0, -1.0):
        mine = np.flatnonzero(signs == sign)
        total = np.bincount(target_index[mine], weights=precision[mine], minlength=targets)
        share[target_index[mine], mine] = precision[mine] / total[target_index[mine]]
        variance += np.divide(1.0, total, out=np.zeros(targets), where=total > 0)
        directions += total > 0
    return share / directions[:, np.newaxis], variance / directions**2


def _dof(precision: FloatArray) -> float:
    level = -np.mean(np.log(precision), axis=1)
    return float(2.0 / max(float(np.var(level)), 1e-4))


def unseen_periods(
    bidirectional: BidirectionalMeans, basis: Basis, known: Sequence[float], found: Sequence[float]
) -> tuple[float, ...]:
    """Return the ``known`` periods (mm or deg) that the readings contradict, if another period was
    ``found``.

    Only the first harmonic of a found period is taken into account, because half of this period may
    itself be a known period.
    """
    waves = [
        wave
        for period in found
        for wave in wave_columns(bidirectional.targets, 1.0 / float(period))[:2]
    ]
    free = np.column_stack([bidirectional.free, *waves])
    if not found or not known or free.shape[1] + 4 > bidirectional.targets.size - LEFT:
        return ()
    likelihood = PeriodLikelihood(replace(bidirectional, free=free), basis)
    odds = np.logaddexp(*likelihood.log_odds(1.0 / np.array(known, dtype=np.float64)))
    against = np.round(odds - np.log(2.0), 6) < 0.0
    return tuple(float(period) for period, no in zip(known, against, strict=True) if no)


def fitted_periods(
    bidirectional: BidirectionalMeans, basis: Basis, shown: Sequence[float]
) -> tuple[float, ...]:
    """Return the known periods (mm or deg) that are fitted: all periods ``shown`` by the targets,
    or the `FITTED` periods that improve the fit most.

    If more than `FITTED` periods are shown, they are added one by one. Each time, the period that
    improves the fit most is added, as long as the data support it (forward selection: Miller,
    Subset Selection in Regression, 2nd ed. 2002, section 3.2).
    """
    if len(shown) <= FITTED:
        return tuple(shown)
    chosen: list[int] = []
    columns = bidirectional.free
    frequencies = 1.0 / np.array(shown, dtype=np.float64)
    while len(chosen) < FITTED and columns.shape[1] + 4 <= bidirectional.targets.size - LEFT:
        likelihood = PeriodLikelihood(replace(bidirectional, free=columns), basis)
        odds = np.logaddexp(*likelihood.log_odds(frequencies, likelihood.coarse())) - np.log(2.0)
        odds[chosen] = -np.inf
        best = int(np.argmax(np.round(odds, 6)))
        if odds[best] + _KNOWN < 0.0:
            break
        chosen.append(best)
        columns = np.column_stack(
            [columns, *wave_columns(bidirectional.targets, float(frequencies[best]))]
        )
    return tuple(float(shown[index]) for index in sorted(chosen))
