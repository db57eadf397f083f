"""Model columns for two properties that differ from test to test: the zero of the instrument, and a
slope error from temperature.

They are columns of a linear model with normal priors (Rasmussen and Williams, Gaussian Processes
for Machine Learning, 2006, section 2.7).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from compwright.estimation.evidence import VAGUE
from compwright.estimation.observed_test import ObservedCells, ObservedTest
from compwright.records.axis import FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class DatumColumns:
    """Columns ``columns`` (readings, e) of the model's matrix. Each of the e columns is for the
    offset or the slope of a single test of an axis.

    ``stds`` (e,): prior standard deviations of the offsets and slopes, in units of the scale.
    ``slopes``: for each test, the index of the column of its slope, or None without one.
    """

    columns: FloatArray
    stds: FloatArray
    slopes: tuple[int | None, ...]


def datum_columns(
    tests: Sequence[ObservedTest],
    parts: Sequence[ObservedCells],
    targets: FloatArray,
    scale: float,
) -> DatumColumns:
    """Return the columns of the model's matrix for the offset of each test after the first, and for
    the slope of each test that has an uncertain slope (``slope_std`` above 0).

    The offset of the first test is that of the axis error. A column of a slope is 0 in the middle
    of all ``targets`` (m,), and -1 and 1 at their ends. ``parts``: mean readings of each test.
    ``scale``: unit of the model, mm or deg.
    """
    middle, half = 0.5 * (targets[0] + targets[-1]), 0.5 * float(np.ptp(targets))
    columns: list[FloatArray] = []
    stds: list[float] = []
    slopes: list[int | None] = []
    for index, each in enumerate(tests):
        mine = [np.full(part.counts.size, float(k == index)) for k, part in enumerate(parts)]
        own = np.concatenate(mine)
        if index:
            columns.append(own)
            stds.append(VAGUE)
        slopes.append(None)
        if each.slope_std > 0.0:
            slopes[-1] = len(columns)
            places = np.concatenate([part.positions for part in parts])
            columns.append(own * (places - middle) / half)
            stds.append(each.slope_std * half / scale)
    size = sum(part.counts.size for part in parts)
    together = np.column_stack(columns) if columns else np.zeros((size, 0))
    return DatumColumns(columns=together, stds=np.array(stds), slopes=tuple(slopes))
