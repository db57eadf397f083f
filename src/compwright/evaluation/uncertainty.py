"""Measurement uncertainty (k = 2) of the parameters: contributors of ISO 230-2:2006 annex A,
propagated as distributions (JCGM 101:2008).

Readings are drawn with random values of the contributors and evaluated by the definitions of the
parameters. No coefficient is taken from the standard. U contains only the measurement: the
repeatability of the axis is part of R and A, not of U.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Final, Literal

import numpy as np

from compwright.evaluation.scatter_without_environment import without_environment
from compwright.evaluation.statistics import mean_deviation, parameters, standard_deviation
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.positioning import SAME_READING, PositioningTest
from compwright.records.result import Contribution, ExpandedUncertainty
from compwright.words.sentences import SentenceText, say

COVERAGE: Final = 2.0
#: Expanded uncertainty (k = 2) of a contributor known by its range a: 2 a / sqrt(12).
FROM_RANGE: Final = 1.0 / math.sqrt(3.0)
#: Standard uncertainty of a contributor known by its range, in that range.
_SIGMA: Final = 1.0 / math.sqrt(12.0)
#: Readings that are drawn for an uncertainty, within these numbers of tests, and at once.
_READINGS: Final = 500_000
DRAWS: Final = (1000, 4000)
_AT_ONCE: Final = 500_000
#: Decimals of mm or deg that are reported: below, only the rounding of sums is left.
_DIGITS: Final = 12
#: Expansion coefficient of the machine where none is given, µm/(m K): steel.
_STEEL: Final = 11.5


def contributions(
    test: PositioningTest, budget: UncertaintyBudget, thermal: Thermal | None
) -> tuple[Contribution, ...]:
    """Return the contributors to the uncertainty of a test, µm (rotary axes: arcsec).

    A linear axis has the following contributors. L is the distance of the extreme targets in m.

    - Instrument: U + per_m L.
    - Misalignment R of the beam: R²/(2L) as a range, 0.289 R²/L expanded. As any range it counts to
      either side, though the beam only ever reads too short. Where nothing else counts, 58 % of the
      range lie within U.
    - Temperature: alpha L U(theta), and expansion coefficient: abs(T - 20) L U(alpha). Each is for
      the machine and, if it expands, for the instrument.
    - Set-up and environmental variation.

    Rotary axes have no length terms: instrument, set-up and environmental variation in arcsec.
    """
    unit = outside_unit(test.kind.unit)
    ends = (_normal("setup", budget.setup, unit, 1.0, "test"), _variation(budget.E_VE, unit))
    if test.kind is AxisKind.ROTARY:
        return (_normal("device", budget.device, unit, 1.0), *ends)
    length = float(test.targets[-1] - test.targets[0]) / 1000.0
    sum_of = say("budget.sum", fixed=budget.device, per_m=budget.device_per_m, length=length)
    device = _normal(
        "device",
        budget.device + budget.device_per_m * length,
        unit,
        1.0,
        note=SentenceText(sum_of),
    )
    return (
        device,
        *([_misalignment(budget.misalignment_mm, length)] if length > 0.0 else []),
        *thermal_contributions(length, budget.U_theta, budget.U_alpha, thermal),
        *ends,
    )


def thermal_contributions(
    length: float, U_theta: float, U_alpha: float, thermal: Thermal | None
) -> tuple[Contribution, ...]:
    """Return the contributors to the uncertainty of a ``length`` (m) at 20 °C that come from
    temperature and expansion coefficients.

    ``U_theta`` (K): expanded uncertainty of the temperature. ``U_alpha`` (µm/(m K)): expanded
    uncertainty of the expansion coefficient. Both apply to the machine, and to the instrument if it
    expands.
    """
    expands = [
        ("machine", thermal.alpha_m if thermal else _STEEL, thermal.T_m if thermal else 20.0)
    ]
    if thermal and thermal.alpha_d != 0.0:
        expands.append(("instrument", thermal.alpha_d, thermal.T_d))
    steel = "" if thermal else SentenceText(say("budget.steel", alpha=_STEEL))
    unknown = "" if thermal else SentenceText(say("budget.temperature_unknown"))
    return (
        *(
            _normal(f"U_theta_{part}", U_theta, "K", alpha * length, note=steel)
            for part, alpha, _ in expands
        ),
        *(
            _normal(f"U_alpha_{part}", U_alpha, "um/(m K)", abs(T - 20.0) * length, note=unknown)
            for part, _, T in expands
        ),
    )


def _normal(
    source: str,
    given: float,
    unit: str,
    sensitivity: float,
    per: Literal["length", "test"] = "length",
    note: str = "",
) -> Contribution:
    return Contribution(
        source=source, given=given, unit=unit, distribution="normal", divisor=COVERAGE,
        sensitivity=sensitivity, per=per, note=note,
    )  # fmt: skip


def _misalignment(offset: float, length: float) -> Contribution:
    """Return the effect of a beam that is misaligned by ``offset`` (mm) over ``length`` (m): the
    range R²/(2L) in µm.
    """
    return Contribution(
        source="misalignment_mm", given=offset, unit="mm", distribution="rectangular",
        divisor=1.0 / _SIGMA, sensitivity=offset / (2.0 * length), per="length",
    )  # fmt: skip


def _variation(given: float, unit: str) -> Contribution:
    return Contribution(
        source="E_VE", given=given, unit=unit, distribution="rectangular", divisor=1.0 / _SIGMA,
        sensitivity=1.0, per="reading",
    )  # fmt: skip


def length_uncertainty(
    test: PositioningTest, budget: UncertaintyBudget, thermal: Thermal | None
) -> float:
    """Return the expanded uncertainty over the measured length from all contributors proportional
    to position (µm; rotary axes: arcsec).
    """
    every = contributions(test, budget, thermal)
    return COVERAGE * math.hypot(*(one.standard for one in every if one.per == "length"))


def slope_between_tests(
    test: PositioningTest, budget: UncertaintyBudget | None, first: Thermal | None
) -> float:
    """Return the standard deviation (mm/mm) of slope differences between this test and other tests
    of its axis. ``first``: temperature and expansion coefficient in the first test.

    Three contributors differ between tests: the temperature U_theta (sensors are placed and read
    again, and the hall changes), the misalignment of the beam, and the set-up. Two are common to
    all tests and cause no difference: the instrument, assumed to be the same one, and the expansion
    coefficient, a property of the scale. An error U_alpha of the coefficient counts only over the
    temperature difference between this test and the ``first``. The environmental variation is
    already in the scatter of the readings. The result is zero without a budget, and for angles,
    which do not expand.
    """
    length = float(test.targets[-1] - test.targets[0])
    if budget is None or test.kind is AxisKind.ROTARY or length <= 0.0:
        return 0.0
    own = replace(budget, device=0.0, device_per_m=0.0, U_alpha=0.0)
    terms = [length_uncertainty(test, own, test.thermal), budget.setup]
    if test.thermal is not None and first is not None:
        for change, expands in (
            (test.thermal.T_m - first.T_m, True),
            (test.thermal.T_d - first.T_d, test.thermal.alpha_d != 0.0),
        ):
            terms.append(abs(change) * length / 1000.0 * budget.U_alpha * expands)
    return math.hypot(*terms) / COVERAGE / outside_factor(test.kind.unit) / length


def expanded_uncertainties(
    test: PositioningTest,
    given: Mapping[str, float | None],
    coverage: float,
    budget: UncertaintyBudget,
    thermal: Thermal | None = None,
    spread: Callable[[FloatArray], FloatArray] = standard_deviation,
    *,
    table_slope: float = 0.0,
) -> tuple[dict[str, ExpandedUncertainty] | None, list[Finding]]:
    """Return U (mm or deg, k = 2) of each parameter in ``given``, and findings about the
    assumptions made. U is None for VDI 3441, whose parameters annex A does not treat.

    ``coverage``: the factor k of the standard on s. ``spread``: a function that gives s (..., m) of
    deviations (..., m, n). ``table_slope``: for a test still to be made with a new table, the
    standard deviation (mm/mm) of the slope error in the table. It comes from the uncertainty of the
    earlier test from which the table was made, and is one more draw.

    U is half the width of an interval about the stated value. In 95.45 of 100 cases (k = 2 of the
    normal law) it contains the value that the same test would have without instrument and
    environment. The distributions are propagated (JCGM 101:2008, 5 to 7) from readings without the
    environment (`without_environment`). Each simulated test has one draw of the length terms, times
    position. Each reading has one draw of the environmental variation (its range E_VE). So each
    simulated test has its own targets that decide a maximum. Set-up, and the part of the instrument
    that does not grow with distance, do not depend on position. They are one draw per test in the
    differences A, E and M.
    """
    if "P" in given:
        return None, [Finding.of("CW-T021", "info")]
    names = [name for name, value in given.items() if value is not None]
    there = _measured(test)
    added = _added(there, budget, thermal, table_slope)
    differences = _propagated(there, names, coverage, added, spread)
    result = {
        name: ExpandedUncertainty(_expanded(off), COVERAGE) for name, off in differences.items()
    }
    return result, _assumptions(test, budget, thermal)


def _expanded(off: FloatArray) -> float:
    """Return the half width that contains 95.45 % of the draws ``off`` (changes of a parameter)."""
    scores = np.sort(np.abs(_normal_scores(off.size)))
    held = np.interp(COVERAGE, scores, np.arange(off.size)) / (off.size - 1)
    return round(float(np.quantile(np.abs(off), held)), _DIGITS)


def _measured(test: PositioningTest) -> PositioningTest:
    """Return the test without those targets that have no reading."""
    there = np.any([test.readings(direction) > 0 for direction in Direction], axis=0)
    return replace(
        test,
        targets=test.targets[there],
        positive=test.positive[there],
        negative=test.negative[there],
    )


@dataclass(frozen=True, slots=True)
class _Added:
    """The uncertainty that instrument and environment add to the readings, mm or deg.

    ``slope``: standard deviation of the slope over the positions (mm/mm). The difference of two
    targets has two further parts. ``with_slope`` follows the draw of the slope; ``without_slope``
    is independent of it. ``variation``: range of the environmental variation of a reading.
    """

    slope: float
    with_slope: float
    without_slope: float
    variation: float


def _added(
    test: PositioningTest, budget: UncertaintyBudget, thermal: Thermal | None, table_slope: float
) -> _Added:
    """Return the uncertainty that the contributors add to the readings. ``table_slope``: standard
    deviation (mm/mm) of a slope error in the table.

    The certificate of an instrument states the distance of any two positions: U + per_m times the
    distance, with one sign. One draw therefore determines the slope of the instrument and a part of
    U.
    """
    factor = outside_factor(test.kind.unit)
    unit = COVERAGE * factor
    length = max(float(test.targets[-1] - test.targets[0]), SAME_READING)
    rest = length_uncertainty(test, replace(budget, device=0.0, device_per_m=0.0), thermal) / length
    per_mm = budget.device_per_m / 1000.0 if test.kind is AxisKind.LINEAR else 0.0
    slope = math.hypot(per_mm, rest, table_slope * unit)
    with_slope = budget.device * per_mm / slope if slope > 0.0 else 0.0
    alone = math.sqrt(max(budget.device**2 - with_slope**2, 0.0))
    return _Added(
        slope / unit,
        with_slope / unit,
        math.hypot(alone, budget.setup) / unit,
        budget.E_VE / factor,
    )


def _propagated(
    test: PositioningTest,
    names: Sequence[str],
    coverage: float,
    added: _Added,
    spread: Callable[[FloatArray], FloatArray],
) -> dict[str, FloatArray]:
    """Return random draws of the change of each parameter that instrument and environment cause by
    the uncertainty ``added`` to the readings.
    """
    rng = np.random.default_rng(0)  # the same test has the same uncertainty
    readings = max(test.positive.size + test.negative.size, 1)
    count = int(np.clip(_READINGS // readings, *DRAWS))
    slopes, rests = (rng.permutation(_normal_scores(count)) for _ in range(2))
    along = added.slope * (test.targets - test.targets[0])[:, np.newaxis]
    found: dict[str, list[FloatArray]] = {name: [] for name in names}
    for part in np.array_split(np.arange(count), max(1, count * readings // _AT_ONCE)):
        truth = without_environment(test, _SIGMA * added.variation, part.size, rng)
        sloped = slopes[part, np.newaxis, np.newaxis] * along
        seen = [
            block + sloped + (rng.random(block.shape) - 0.5) * added.variation for block in truth
        ]
        one, other = (_parameters(blocks, coverage, spread) for blocks in (seen, truth))
        with_slope = added.with_slope * np.abs(slopes[part])
        moved = other
        if added.with_slope > 0.0:
            moved = _parameters([block + sloped for block in truth], coverage, spread)
        for name, draws in found.items():
            off = one[name] - other[name]
            if name[0] in "AEM":  # what goes with the slope adds to what that does, more or less
                sense = np.where(moved[name] >= other[name], 1.0, -1.0)
                off = off + sense * with_slope + added.without_slope * rests[part]
            draws.append(off)
    return {name: np.concatenate(draws) for name, draws in found.items()}


def _parameters(
    blocks: Sequence[FloatArray], coverage: float, spread: Callable[[FloatArray], FloatArray]
) -> Mapping[str, FloatArray]:
    positive, negative = blocks
    return parameters(
        mean_deviation(positive),
        spread(positive),
        mean_deviation(negative),
        spread(negative),
        coverage,
    )


@cache
def _normal_scores(count: int) -> FloatArray:
    """Return ``count`` equally probable values of the standard normal distribution.

    Source: McKay, Beckman and Conover, Technometrics 21 (1979) 239.
    """
    from statistics import NormalDist  # slow to import, and most tests come without a budget

    law = NormalDist()
    return np.array([law.inv_cdf((i + 0.5) / count) for i in range(count)])


def _propagation(test: PositioningTest, budget: UncertaintyBudget) -> Finding:
    """Return the finding CW-T020: how U was computed, and which effect of a misaligned beam U
    lacks.
    """
    length = float(test.targets[-1] - test.targets[0]) / 1000.0
    if test.kind is AxisKind.ROTARY or budget.misalignment_mm == 0.0 or length <= 0.0:
        return Finding.of("CW-T020", "info", misalignment=None, counted=0.0)
    most = budget.misalignment_mm**2 / (2.0 * length)
    return Finding.of("CW-T020", "info", misalignment=most, counted=FROM_RANGE * most)


def _assumptions(
    test: PositioningTest, budget: UncertaintyBudget, thermal: Thermal | None
) -> list[Finding]:
    findings = [
        _propagation(test, budget),
    ]
    if test.kind is AxisKind.LINEAR and thermal is None and budget.U_theta > 0.0:
        findings.append(Finding.of("CW-T022", "warning", alpha_m=_STEEL))
    if test.kind is AxisKind.LINEAR and thermal is None and budget.U_alpha > 0.0:
        findings.append(Finding.of("CW-T023", "warning"))
    return findings
