"""Measurement uncertainty of the parameters of a circular test, k = 2.

ISO 230-4:2005 refers to ISO/TR 230-9 for the uncertainty. Neither text was available, so the
contributors and coefficients of these documents are unknown here. The contributors that the job
declares are combined (GUM), by the definitions of G, H, F and D:

- Instrument: its certificate, for a change in length (µm). In every parameter.
- Length of the bar: its calibration (µm). Only in F and D, which refer to the nominal radius (DIN
  ISO 230-4:1999, 3.4 note 3 and 4.5).
- Temperature and coefficient of expansion, over the radius. Only in F and D (4.1).
- Set-up: mounting the instrument again (µm). In every parameter.
- Environmental variation: range E_VE of the reading of a machine at rest over the duration of the
  test. The expanded uncertainty of a reading is E_VE / sqrt(3) (rectangular distribution: JCGM
  100:2008, 4.3.7). G and H are differences of two readings: sqrt(2) times as much.

U does not contain the repeatability of the machine, as in ISO 230-2:2006 annex A.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

from compwright.evaluation.uncertainty import COVERAGE, FROM_RANGE, thermal_contributions
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.circular import CircularTest
from compwright.records.conditions import CircularBudget, Thermal
from compwright.records.result import ExpandedUncertainty

#: Decimals of mm: below, only the rounding of sums is left.
_DIGITS: Final = 12


def circular_uncertainties(
    test: CircularTest, names: Iterable[str], budget: CircularBudget, thermal: Thermal | None
) -> dict[str, ExpandedUncertainty]:
    """Return U (mm, k = 2) of each of the parameters ``names``. ``thermal`` gives temperature and
    expansion coefficient of the machine. Without it the coefficient of steel is used, and the
    contribution of U_alpha is missing.
    """
    radius = test.nominal_radius / 1000.0  # m
    of_length = thermal_contributions(radius, budget.U_theta, budget.U_alpha, thermal)
    same, reading = (budget.U, budget.setup), FROM_RANGE * budget.E_VE
    form = (*same, math.sqrt(2.0) * reading)
    size = (*same, reading, budget.length, *(COVERAGE * one.standard for one in of_length))
    U_form, U_size = (
        round(math.hypot(*terms) / MICROMETRES_PER_MILLIMETRE, _DIGITS) for terms in (form, size)
    )
    return {
        name: ExpandedUncertainty(U_size if name[0] in "FD" else U_form, COVERAGE) for name in names
    }
