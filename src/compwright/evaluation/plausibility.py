"""Checks of the readings of a single test for a wrong unit, wrong directions, or copies.

`certain_fault` returns a fault that is certain; its caller refuses the test.
`plausibility_findings` returns possible faults, which are shown first, as doubts. The comment at
each constant gives the reason for its value. Lengths are in mm, angles in deg.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.evaluation.copied_runs import copied_run_findings
from compwright.evaluation.pooled_scatter import pooled_scatter, reading_range
from compwright.evaluation.reading_checks import position_text, text_of
from compwright.evaluation.statistics import mean_deviation
from compwright.evaluation.typical_magnitudes import turned_odds, unit_odds
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.records.axis import AxisKind
from compwright.records.positioning import PositioningTest

#: Readings that all lie within this per metre (and within a tenth of it on short axes) are no
#: machine in air: 0.01 K changes a metre of steel by 0.115 µm and of light path by 0.01 µm, and no
#: control positions to better than its own increment. mm per mm.
_NO_MACHINE: Final = 1e-7
_SHORTEST: Final = 100.0
#: The same for rotary axes, deg: 0.01 arcsec, the resolution of the best autocollimators.
_NO_TABLE: Final = 0.01 / 3600.0
#: Repeated readings that scatter by less than this (and do scatter) lie below the resolution of any
#: instrument for machine tools (1 nm) and far below the turbulence of the air in any beam: 2 nm,
#: 0.0005 arcsec. Taken as certain only where the readings altogether lie within `_NARROW`: a scale
#: error of 20 µm with hardly any noise is a simulation, not a slip of the unit.
_NO_SCATTER: Final = {AxisKind.LINEAR: 2e-6, AxisKind.ROTARY: 0.0005 / 3600.0}
_NARROW: Final = {AxisKind.LINEAR: 2e-3, AxisKind.ROTARY: 0.2 / 3600.0}
#: Readings within this are better than practically every machine tool: possible, to be asked about.
#: 0.5 µm, 0.1 arcsec.
_RARE: Final = {AxisKind.LINEAR: 5e-4, AxisKind.ROTARY: 0.1 / 3600.0}
#: Scatter below this is rounding of binary numbers, not a measurement: 1 pm, 1e-9 deg.
_ROUNDING: Final = 1e-9
#: Lost motion gives a negative mean reversal. A positive one needs a backlash value that is too
#: large (a few µm are common), or the directions or the sign are turned: 3 µm, 3 arcsec, and four
#: standard errors.
_TURNED: Final = {AxisKind.LINEAR: 3e-3, AxisKind.ROTARY: 3.0 / 3600.0}
_SURE: Final = 4.0
#: Units that are taken for each other: their factor, the finer and the coarser one; and how much
#: more usual the other one has to be.
_CONFUSED: Final = {
    AxisKind.LINEAR: (1000.0, "µm", "mm"),
    AxisKind.ROTARY: (3600.0, "arcsec", "deg"),
}
_UNUSUAL: Final = 20.0
_INCH: Final = 25.4
#: Targets in inches with four decimals are whole millimetres to within this, mm.
_WHOLE: Final = 2e-3
#: The fewest targets that any edition asks for.
FEWEST_TARGETS: Final = {AxisKind.LINEAR: 5, AxisKind.ROTARY: 3}


def certain_fault(test: PositioningTest) -> str:
    """Return why the readings cannot be deviations in the stated unit, or an empty text.

    These faults are certain:

    - All readings are the same: nothing was measured.
    - All readings lie within 0.1 µm per metre of travel (on rotary axes within 0.01 arcsec).
    - Repeated readings scatter by less than 2 nm (0.0005 arcsec), and all readings lie within 2 µm
      (0.2 arcsec). This is typical of mm read as µm, or of deg read as arcsec.
    - The deviations grow one to one with the targets: they are measured positions.

    An excellent machine shows none of them. Its repeated readings scatter at least by the effect of
    the air on the beam.
    """
    noticed = {finding.code for finding in test.findings}
    if "CW-R011" in noticed:
        unit = test.kind.unit
        return (
            f"the deviations grow by 1 {unit} per {unit} of target: these are measured positions,"
            " not deviations"
        )
    if "CW-R009" in noticed:
        return (
            f"all deviations are smaller than 0.000001 {test.kind.unit}: nothing was measured, or"
            " the unit is another one"
        )
    spread = reading_range(test)
    count = int(np.isfinite(test.positive).sum() + np.isfinite(test.negative).sum())
    if count < 3:
        return ""
    if spread <= _ROUNDING:
        return f"all {count} readings are the same: nothing was measured"
    length = float(test.targets[-1] - test.targets[0])
    least = _NO_TABLE if test.kind is AxisKind.ROTARY else _NO_MACHINE * max(length, _SHORTEST)
    if spread < least:
        return (
            f"all readings lie within {text_of(spread, test)}, which no machine can do:"
            f" {_smaller(test)}"
        )
    s, dof = pooled_scatter(test)
    if dof >= 8.0 and _ROUNDING < s < _NO_SCATTER[test.kind] and spread < _NARROW[test.kind]:
        nano = f"{significant(s * 1e6)} nm" if test.kind is AxisKind.LINEAR else text_of(s, test)
        return (
            f"repeated readings scatter by {nano} and all lie within {text_of(spread, test)}, below"
            f" what any instrument can resolve: {_smaller(test)}"
        )
    return ""


def _smaller(test: PositioningTest) -> str:
    if _positions_measured(test):
        return "the measured positions are those of the targets"
    return (
        "the values look 1000 times too small (mm read as µm)"
        if test.kind is AxisKind.LINEAR
        else "the values look too small (deg read as arcsec)"
    )


def plausibility_findings(test: PositioningTest) -> list[Finding]:
    """Return the findings CW-T030 to CW-T033 and CW-T035 about the unit, origin and direction of
    the readings.
    """
    return [*_small(test), *copied_run_findings(test), *_turned(test), *_inches(test), *_few(test)]


def _small(test: PositioningTest) -> list[Finding]:
    if any(finding.code in {"CW-R009", "CW-R011"} for finding in test.findings):
        return []
    certain = certain_fault(test)
    if certain:
        return [Finding.of("CW-T030.certain", "warning", why=certain)]
    spread = reading_range(test)
    unusual = _other_unit(test)
    if unusual is not None:
        return [unusual]
    if not 0.0 < spread < _RARE[test.kind]:
        return []
    return [Finding.of("CW-T030.small", "warning", spread=text_of(spread, test))]


def _other_unit(test: PositioningTest) -> Finding | None:
    """Return the finding CW-T030 if readings are far more typical in another unit, else None."""
    if _positions_measured(test):  # in another unit they would not be near their targets
        return None
    factor, finer, coarser = _CONFUSED[test.kind]
    small, large = unit_odds(test, factor), unit_odds(test, 1.0 / factor)
    if max(small, large) < _UNUSUAL:
        return None
    true, read = (coarser, finer) if small >= large else (finer, coarser)
    return Finding.of(
        "CW-T030.unit",
        "warning",
        spread=text_of(reading_range(test), test),
        scatter=text_of(pooled_scatter(test)[0], test),
        odds=max(small, large),
        factor=factor,
        larger=small >= large,
        unit=true,
        read_as=read,
    )


def _positions_measured(test: PositioningTest) -> bool:
    return any(finding.code == "CW-R003" for finding in test.findings)


def reversal_above_zero(test: PositioningTest) -> float:
    """Return the mean reversal error (mm or deg) if it is positive and larger than on typical
    machines, else 0.
    """
    reversal = mean_deviation(test.positive) - mean_deviation(test.negative)
    known = reversal[np.isfinite(reversal)]
    if known.size < 2:
        return 0.0
    mean, error = float(np.mean(known)), float(np.std(known, ddof=1) / np.sqrt(known.size))
    return mean if mean > max(_TURNED[test.kind], _SURE * error) else 0.0


def _turned(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T032 if the mean reversal error is above zero: directions or sign are
    possibly reversed.
    """
    mean = reversal_above_zero(test)
    if not mean:
        return []
    odds = turned_odds(mean, test.kind)
    return [
        Finding.of(
            "CW-T032",
            "warning",
            reversal=text_of(mean, test),
            odds=odds,
            likely=odds > 1.0,
        )
    ]


def _inches(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T033 if targets are whole numbers in inches and not in millimetres."""
    if test.kind is not AxisKind.LINEAR or test.targets.size < 5:
        return []
    as_inches = test.targets * _INCH
    whole = np.max(np.abs(as_inches - np.round(as_inches))) < _WHOLE
    round_already = np.max(np.abs(test.targets * 100.0 - np.round(test.targets * 100.0))) < 1e-6
    if not whole or round_already:
        return []
    first, last = (
        position_text(float(test.targets[0]), test),
        position_text(float(test.targets[-1]), test),
    )
    return [Finding.of("CW-T033", "warning", first=first, last=last)]


def _few(test: PositioningTest) -> list[Finding]:
    """Return the finding CW-T035 if there are fewer targets than any edition requires (4.3.2,
    4.3.4).
    """
    count, fewest = test.targets.size, FEWEST_TARGETS[test.kind]
    if count >= fewest:
        return []
    return [Finding.of("CW-T035", "warning", targets=count, fewest=fewest)]


#: Factors between the unit of the targets and mm, by name of the unit that was taken for mm.
_TARGET_UNITS: Final = ((_INCH, "inches"), (1000.0, "metres"))
#: Targets in another unit cover the travel when multiplied: at least half of it, and not more than
#: all of it but for a few hundredths.
_COVERS: Final = (0.5, 1.05)


def wrong_target_unit(test: PositioningTest, travel: tuple[float, float]) -> str:
    """Return the unit in which the targets fit the ``travel`` (mm), or an empty text if mm fits.

    The unit is certain, because nothing else has this effect. In inches or metres the targets span
    far less than the travel, in micrometres far more. Converted to mm, they span at least half of
    the travel and at most 1.05 times the travel. Only the spans are compared, because an offset may
    have been added in mm.
    """
    if test.kind is not AxisKind.LINEAR or test.targets.size < 3:
        return ""
    span, length = float(test.targets[-1] - test.targets[0]), travel[1] - travel[0]
    for factor, unit in _TARGET_UNITS:
        if _COVERS[0] <= span * factor / length <= _COVERS[1]:
            return unit
    if _COVERS[0] <= span / 1000.0 / length <= _COVERS[1]:
        return "micrometres"
    return ""
