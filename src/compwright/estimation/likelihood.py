"""The probability of the mean readings of one test, averaged over all possible errors of the axis.

It is used to compare the readings as stated with the same readings under another assumption: the
sign is reversed, the directions are exchanged, or another table is active. It is the marginal
likelihood of the means under the model of `estimation.axis`, with a constant reversal and only the
known periods (Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, section 5.2).
Offset, slope and mean reversal are free and do not count, as in restricted likelihood (Patterson
and Thompson, Biometrika 58, 1971).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.estimation.cells import Cells, build_cells, visible_periods
from compwright.estimation.model import FittedModel, Periods, Travel, fit_model
from compwright.estimation.observed_test import ObservedTest
from compwright.records.axis import FloatArray

_DRAWS: Final = 12  # of the hyperparameters: the evidence is then good to a few tenths
_FREE_LINES: Final = 3  # offset, slope, mean reversal


@dataclass(frozen=True, slots=True)
class ScaledCurve:
    """A possible part of the error: a curve times an unknown factor.

    ``positive``, ``negative`` (m,): the curve in each direction at the targets of a test, mm or
    deg. ``std``: standard deviation of the factor, whose mean is 0.
    """

    positive: FloatArray
    negative: FloatArray
    std: float


def log_likelihood(
    observed: ObservedTest,
    travel: Travel,
    periods: Sequence[float],
    shape: ScaledCurve | None = None,
) -> float:
    """Return the log likelihood of the mean readings of a test (mm or deg), up to a constant.
    ``shape``: a curve that the error contains, times an unknown factor. Raises InputError for
    readings at fewer than two targets.

    The constant depends only on the targets and the number of readings at each.
    """
    # Jumps stay in: a table that is taken the wrong way tears an error where there is no jump.
    cells = build_cells([observed], turn=travel.turn, stepped=False)
    if shape is not None:
        cells = _with(cells, observed, shape)
    drawn = _fitted(cells, travel, periods).drawn
    free = cells.data.signs.size - (_FREE_LINES if cells.bidirectional else _FREE_LINES - 1)
    return drawn.log_evidence - free * float(np.log(cells.data.scale))


def smooth_part(observed: ObservedTest, travel: Travel) -> tuple[FloatArray, FloatArray]:
    """Return the smooth part of the mean readings of a test at its targets (m,), in + and in -.
    Noise and irregular parts are removed.
    """
    cells = build_cells([observed], turn=travel.turn)
    part = _fitted(cells, travel, ()).part(np.array([cells.data.typical()]))
    weights = part.weights[0].mean[: part.basis.size]
    where = observed.test.targets
    first, second = (
        line + cells.data.scale * rows @ weights
        for line, rows in zip(cells.line_at(where), part.basis.design(where), strict=True)
    )
    return first, second


def _fitted(cells: Cells, travel: Travel, periods: Sequence[float]) -> FittedModel:
    known = Periods.of(cells, visible_periods(cells.targets, periods))
    return fit_model(cells, travel, known, varying=False, draws=_DRAWS)


def _with(cells: Cells, observed: ObservedTest, shape: ScaledCurve) -> Cells:
    data = cells.data
    target_index = np.searchsorted(observed.test.targets, cells.targets[data.target_index] - 1e-9)
    curve = (
        np.where(data.signs > 0, shape.positive[target_index], shape.negative[target_index])
        / data.scale
    )
    return replace(
        cells,
        data=replace(
            data,
            extra=np.hstack([data.extra, curve[:, np.newaxis]]),
            extra_std=np.append(data.extra_std, shape.std),
        ),
    )
