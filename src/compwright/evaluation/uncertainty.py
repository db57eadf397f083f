"""Measurement uncertainty of the parameters: GUM combination of the contributors of ISO 230-2:2006
annex A, k = 2.

The coefficients are derived here from the definitions, not quoted from the standard. Only the
measurement enters: the repeatability of the axis is part of R and A, not of U.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.job import Thermal, UncertaintyBudget
from compwright.records.positioning import PositioningTest
from compwright.records.result import ExpandedUncertainty, TargetColumns

COVERAGE: Final = 2.0
#: Expanded uncertainty (k = 2) of a contributor known by its range a: 2 a / sqrt(12).
FROM_RANGE: Final = 1.0 / math.sqrt(3.0)
#: Expansion coefficient of the machine where none is given, µm/(m K): steel.
_STEEL: Final = 11.5


def length_uncertainty(
    test: PositioningTest, budget: UncertaintyBudget, thermal: Thermal | None
) -> float:
    """Return the expanded uncertainty (µm) over the measured length of all that is one draw per
    test times position.

    L is the distance of the extreme targets in m: instrument U + per_m L, misalignment R²/(2L) as a
    range (0.289 R²/L expanded), temperature alpha L U(theta) and coefficient abs(T - 20) L
    U(alpha), for the machine and, where it expands, the instrument. Rotary axes have no length
    terms: only the instrument's U (arcsec).
    """
    if test.kind is AxisKind.ROTARY:
        return budget.device
    length = float(test.targets[-1] - test.targets[0]) / 1000.0
    alpha = thermal.alpha_m if thermal else _STEEL
    terms = [budget.device + budget.device_per_m * length, alpha * length * budget.U_theta]
    if length > 0.0:
        terms.append(FROM_RANGE * budget.misalignment_mm**2 / (2.0 * length))
    if thermal:
        terms.append(abs(thermal.T_m - 20.0) * length * budget.U_alpha)
        if thermal.alpha_d != 0.0:
            terms.append(thermal.alpha_d * length * budget.U_theta)
            terms.append(abs(thermal.T_d - 20.0) * length * budget.U_alpha)
    return math.hypot(*terms)


def temperature_between(
    test: PositioningTest, budget: UncertaintyBudget | None, thermal: Thermal | None
) -> FloatArray:
    """Return the covariance (2m, 2m, + then -, mm²) that the declared uncertainty of temperature
    puts between two tests.

    Each test has an unknown temperature of its own: its slope over the positions is uncertain,
    twice (U_theta and U_alpha, k = 2). Zero without a budget, and for angles, which do not expand.
    """
    along = np.tile(test.targets, 2)
    length = float(test.targets[-1] - test.targets[0])
    if budget is None or test.kind is AxisKind.ROTARY or length <= 0.0:
        return np.zeros((along.size, along.size))
    of_temperature = replace(budget, device=0.0, device_per_m=0.0, misalignment_mm=0.0)
    slope = (
        math.sqrt(2.0)
        * length_uncertainty(test, of_temperature, thermal)
        / COVERAGE
        / 1000.0
        / length
    )
    return np.asarray(slope**2 * np.outer(along, along))


def expanded_uncertainties(
    test: PositioningTest,
    given: Mapping[str, float | None],
    columns: TargetColumns,
    coverage: float,
    budget: UncertaintyBudget,
    thermal: Thermal | None = None,
) -> tuple[dict[str, ExpandedUncertainty] | None, list[Finding]]:
    """Return U (mm or deg, k = 2) of each parameter that ``given`` has, and what had to be assumed.

    ``coverage`` is the factor k of the standard on s. With v the expanded uncertainty of one
    reading from the environmental variation (its range E_VE, one draw per reading) and n the
    smallest number of readings: B: v sqrt(2/n); E: v sqrt(2/n) (difference of two means); M: v
    sqrt(1/n); B_mean: v sqrt(2/(n m)); R+, R-: k v; R by the term that decides at its target. E and
    M add the length terms and the set-up, A is E with k v for the band of s at its ends. None for
    VDI 3441, whose parameters annex A does not treat.
    """
    if "P" in given:
        return None, [
            Finding(
                "CW-T021",
                "info",
                "No uncertainty is stated for VDI/DGQ 3441: annex A of ISO 230-2 treats its own"
                " parameters only.",
            )
        ]
    v = FROM_RANGE * budget.E_VE
    directions = [d for d in Direction if np.any(np.isfinite(test.deviations(d)))]
    n = min(float(number[number > 0].min()) for number in map(test.readings, directions))
    length = math.hypot(length_uncertainty(test, budget, thermal), budget.setup)
    reversal = v * math.sqrt(2.0 / n)
    systematic = math.hypot(length, reversal)
    accuracy = math.hypot(systematic, coverage * v)
    stated = {
        "A": accuracy,
        "A_positive": accuracy,
        "A_negative": accuracy,
        "E": systematic,
        "E_positive": systematic,
        "E_negative": systematic,
        "M": math.hypot(length, v * math.sqrt(1.0 / n)),
        "R": _bidirectional_repeatability(columns, coverage, v, reversal),
        "R_positive": coverage * v,
        "R_negative": coverage * v,
        "B": reversal,
        "B_mean": v * math.sqrt(2.0 / (n * test.targets.size)),
    }
    factor = outside_factor(test.kind.unit)
    result = {
        name: ExpandedUncertainty(stated[name] / factor, COVERAGE)
        for name, value in given.items()
        if value is not None
    }
    return result, _assumptions(test, budget, thermal)


def _bidirectional_repeatability(
    columns: TargetColumns, coverage: float, v: float, reversal: float
) -> float:
    """Return U(R) by its deciding term: 2k s of one direction, or k s+ + k s- + abs(B_i) (each k s
    carries k v / 2).
    """
    both = columns.repeatability
    if not np.any(np.isfinite(both)):
        return math.nan
    i = int(np.nanargmax(both))
    if both[i] <= max(columns.repeatability_positive[i], columns.repeatability_negative[i]):
        return coverage * v
    return math.hypot(reversal, 0.5 * coverage * v, 0.5 * coverage * v)


def _assumptions(
    test: PositioningTest, budget: UncertaintyBudget, thermal: Thermal | None
) -> list[Finding]:
    findings = [
        Finding(
            "CW-T020",
            "info",
            "Uncertainty: GUM combination of the annex A contributors of ISO 230-2:2006, k = 2,"
            " coefficients derived.",
        )
    ]
    if test.kind is AxisKind.LINEAR and thermal is None and budget.U_theta > 0.0:
        findings.append(
            Finding(
                "CW-T022",
                "warning",
                f"U_theta is given without thermal.alpha_m: {_STEEL} µm/(m K) (steel) was assumed"
                " for the machine.",
            )
        )
    if test.kind is AxisKind.LINEAR and thermal is None and budget.U_alpha > 0.0:
        findings.append(
            Finding(
                "CW-T023",
                "warning",
                "U_alpha is given without thermal.T_m: the temperature is unknown, so its term is"
                " missing from U.",
            )
        )
    return findings
