"""Findings about tests of one axis whose slopes differ."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np

from compwright.estimation.cells import Cells
from compwright.estimation.model import MixturePart
from compwright.estimation.observed_test import ObservedTest
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind
from compwright.records.rounding import rounded_number

#: Growth of steel, µm/m for each kelvin.
_STEEL: Final = 11.5
#: A finding from three standard errors on, and from a tenth of a kelvin of steel: no sensor on a
#: machine shows less.
_CLEAR: Final = 3.0
_LEAST: Final = 0.1 * _STEEL


def slope_findings(
    tests: Sequence[ObservedTest], cells: Cells, parts: Sequence[MixturePart]
) -> Iterator[Finding]:
    """Yield a finding (CW-E028) for each test whose slope clearly differs from the first test's, in
    the averaged models ``parts``.

    Rotary axes have no such finding, because angles do not grow with temperature.
    """
    if tests[0].test.kind is AxisKind.ROTARY:
        return
    for place, each in enumerate(tests[1:], start=1):
        difference, error = (1e6 * part for part in _minus_first(place, cells, parts))
        if abs(difference) < max(_CLEAR * error, _LEAST):
            continue
        mine, other = each.test.name, tests[0].test.name
        yield Finding.of(
            "CW-E028",
            "warning",
            test=mine,
            other=other,
            difference=difference,
            error=error,
            kelvin=abs(difference) / _STEEL,
        )


def _minus_first(place: int, cells: Cells, parts: Sequence[MixturePart]) -> tuple[float, float]:
    """Return the slope of the test with index ``place`` minus that of the first test, with its
    standard error, mm/mm.

    They are the mean and the root of the variance of the mixture over all draws (Gelman et al.,
    Bayesian Data Analysis, 3rd ed. 2013, section 1.8).
    """
    means, variances = [], []
    for part in parts:
        for weights in part.weights:
            contrast = np.zeros(weights.mean.size)
            for column, sign in ((cells.slopes[place], 1.0), (cells.slopes[0], -1.0)):
                if column is not None:
                    contrast[part.basis.size + column] += sign
            means.append(float(contrast @ weights.mean))
            variances.append(float(np.sum((contrast @ weights.root) ** 2)))
    unit = cells.data.scale / (0.5 * float(np.ptp(cells.targets)))
    error = float(np.sqrt(np.mean(variances) + np.var(means)))
    return rounded_number(unit * float(np.mean(means))), rounded_number(unit * error)
