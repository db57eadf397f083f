"""Nominal differential expansion (ISO 230-2:1997 and 2006, 3.1), which refers the deviations of a
linear axis to 20 °C.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind
from compwright.records.conditions import Thermal
from compwright.records.positioning import PositioningTest
from compwright.words.sentences import say

_NOTHING: Final = frozenset({"", "-", "no", "none", "nothing", "nichts", "keine", "0", "false"})
_AIR_ONLY: Final = re.compile(
    r"^(?:(?:air|wavelength|refractive|refraction|index|of|the|light|laser|pressure|humidity|environment|environmental|edlen|and|only"
    r"|temperature(?=.*\bair\b)|(?<=air )temperature)\s*)+$"
)


#: Of the material alone, and not of the air: "temperature" by itself may be either.
_MATERIAL_ONLY: Final = re.compile(
    r"^(?=.*\b(?:material|expansion|scale|workpiece)\b)"
    r"(?:(?:material|thermal|expansion|scale|workpiece|temperature|of|the|and|only|machine)\s*)+$"
)


def instrument_compensated_expansion(compensated_for: str) -> bool:
    """Return whether the file header states that the instrument removed the material expansion.

    The header is divided at commas, semicolons, ``+`` and ``/``. A part about only the air or the
    wavelength does not count. A part with unknown words does count. The test is then refused, which
    does less harm than to remove the expansion twice.
    """
    parts = [part.strip().lower() for part in re.split(r"[,;+/]", compensated_for)]
    return any(part not in _NOTHING and not _AIR_ONLY.match(part) for part in parts)


def instrument_compensated_air(compensated_for: str) -> bool:
    """Return whether the file header states that the instrument compensated for the air.

    A part of the header counts unless it is clearly about the material alone. The test is then
    refused, which does less harm than to remove the effect of the air twice.
    """
    parts = [part.strip().lower() for part in re.split(r"[,;+/]", compensated_for)]
    return any(part not in _NOTHING and not _MATERIAL_ONLY.match(part) for part in parts)


def refuse_rotary(test: PositioningTest) -> None:
    """Raise UsageError for a test of a rotary axis, because angles do not expand."""
    if test.kind is not AxisKind.LINEAR:
        raise UsageError(
            Fault(
                message="thermal expansion applies to linear axes only",
                file=test.name,
                found="a rotary axis",
                hint="remove `thermal` from this axis of the job",
            )
        )


def refuse_reduced(test: PositioningTest) -> None:
    """Raise InputError if the expansion was already removed by the instrument (header
    ``compensated_for``) or by an earlier call.
    """
    stated = test.header.get("compensated_for", "")
    if instrument_compensated_expansion(stated):
        raise InputError(
            Fault(
                message=(
                    "the instrument already compensated for thermal expansion, "
                    "so it would be removed twice"
                ),
                file=test.sources[0].file if test.sources else test.name,
                place="compensated_for",
                expected="no key `compensated_for`, or one that names only the air",
                found=stated,
                hint=("remove `thermal` from this test, or correct `compensated_for` in the file"),
            )
        )
    if test.thermal is not None:
        raise InputError(
            Fault(
                message="the thermal expansion was already removed from this test",
                file=test.name,
                hint="remove `thermal` from this test",
            )
        )


def expansion_finding(thermal: Thermal) -> Finding:
    """Return the finding CW-T024: how much expansion was removed to refer readings to 20 °C."""
    return Finding.of(
        "CW-T024",
        "info",
        refer_to=thermal.refer_to,
        slope=1000000.0 * thermal.slope,
        x_fix=thermal.x_fix,
        alpha_m=thermal.alpha_m,
        T_m=thermal.T_m,
        alpha_d=thermal.alpha_d,
        T_d=thermal.T_d,
    )


def remove_differential_expansion(test: PositioningTest, thermal: Thermal) -> PositioningTest:
    """Return ``test`` without differential thermal expansion: e20 = e - (x - x_fix)[alpha_m (T_m -
    20) - alpha_d (T_d - 20)]. The returned test has the finding CW-T024. If the temperature rose
    during the test, CW-T025 states that the mean of start and end was used.

    x is in mm, alpha in µm/(m K), T in °C, deviations in mm. ``thermal.x_fix`` is the fixed point
    of the measurement. ``thermal.refer_to`` states whose expansion alpha_m and T_m are: that of the
    machine's scale or of the workpiece. Raises UsageError for a rotary axis. Raises InputError if
    the expansion was already removed, by the instrument (header ``compensated_for``) or by an
    earlier call.
    """
    refuse_rotary(test)
    refuse_reduced(test)
    expansion = ((test.targets - thermal.x_fix) * thermal.slope)[:, np.newaxis]
    return replace(
        test,
        positive=test.positive - expansion,
        negative=test.negative - expansion,
        findings=(*test.findings, expansion_finding(thermal), *rise_findings(test, thermal)),
        thermal=thermal,
    )


def rise_findings(test: PositioningTest, thermal: Thermal) -> tuple[Finding, ...]:
    """Return the finding CW-T025: how the temperature changed between start and end of the test."""
    if thermal.rise_m == 0.0 and thermal.rise_d == 0.0:
        return ()
    length = float(test.targets[-1] - test.targets[0]) / 1000.0
    drift = length * (thermal.alpha_m * thermal.rise_m - thermal.alpha_d * thermal.rise_d)
    rose = [
        say("CW-T025.change", of=whose, kelvin=rise)
        for whose, rise in ((thermal.refer_to, thermal.rise_m), ("instrument", thermal.rise_d))
        if rise != 0.0
    ]
    return (Finding.of("CW-T025", "info", changes=rose, length=1000.0 * length, drift=drift),)
