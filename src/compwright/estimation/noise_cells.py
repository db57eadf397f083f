"""What the readings of a test say of its cells, given the noise: means, precisions, and what whole
traverses leave common to them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.noise_chain import Draw
from compwright.estimation.noise_rounding import common_std, rounded_std
from compwright.estimation.noise_traverses import OFFSET
from compwright.records.axis import FloatArray

#: Cells at which what is common to the means is told apart: places along the travel.
_PLACES: Final = (0.0, 1.0, 0.5, 0.25)


@dataclass(frozen=True, slots=True)
class CellMeans:
    """Means and precisions (c,) of the cells, 0 where there is no reading; ``columns`` (c, q) of
    unit variance common to the means.
    """

    mean: FloatArray
    precision: FloatArray
    columns: FloatArray


def cell_means(draw: Draw, step: float) -> CellMeans:
    """Return what the readings say of the cells under one draw of the noise: a flat prior on the
    means, normal effects of the traverses (Searle, Casella and McCulloch, Variance Components,
    1992, section 7.4).

    ``step``: to which a coarse instrument rounds, mm or deg; 0 where that is no matter. What
    rounding does to all readings of a cell alike no repetition takes out.
    """
    data = draw.data
    there = data.weights > 0.0
    columns, rest = _columns(draw)
    single = draw.variance
    if step:
        single = rounded_std(draw.sigma, step) ** 2
        rest = rest + common_std(float(np.hypot(draw.sigma, draw.size[OFFSET])), step) ** 2
    variance = np.where(there, single / np.maximum(data.weights, 1e-300) + rest, np.inf)
    return CellMeans(
        mean=np.where(there, data.means - data.shares @ draw.effects, 0.0),
        precision=1.0 / variance,
        columns=columns,
    )


def _columns(draw: Draw) -> tuple[FloatArray, FloatArray]:
    """Return columns (c, q), and what they leave of the variances (c,) that the effects give to the
    means: partial Cholesky factor at fixed cells of each direction (Golub and Van Loan, Matrix
    Computations, 4th ed. 2013, section 4.2.8).
    """
    shares, there = draw.data.shares, draw.data.weights > 0.0
    carried = shares @ draw.covariance
    rest = np.sum(carried * shares, axis=1)
    columns = np.zeros((there.size, 2 * len(_PLACES)))
    least = 1e-9 * float(np.max(rest))
    half = there.size // 2
    rows = np.flatnonzero(there[:half]), half + np.flatnonzero(there[half:])
    chosen = [
        int(row[round(place * (row.size - 1))]) for row in rows if row.size for place in _PLACES
    ]
    for index, cell in enumerate(dict.fromkeys(chosen)):
        if rest[cell] > least:
            column = carried @ shares[cell] - columns @ columns[cell]
            columns[:, index] = column / np.sqrt(rest[cell])
            rest = rest - columns[:, index] ** 2
    return columns, np.maximum(rest, 0.0)
