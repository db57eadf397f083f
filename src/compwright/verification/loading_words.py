"""What a verdict about the loading says: where the test after loading lies, how much of the planned
effect it shows, and what would explain it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.foundations.numerals import significant
from compwright.foundations.units import PositionUnit, outside_factor
from compwright.records.axis import FloatArray
from compwright.verification.comparison import Comparison

_PPM: Final = 1e6
#: Expansion of steel, µm/(m K).
_STEEL: Final = 11.5
#: Effect in its own standard errors from which 95 % of the tests tell all of it from half of it at
#: odds of 100:1: D^2 / 8 - 1.645 D / 2 = ln 100.
VISIBLE: Final = 10.2


@dataclass(frozen=True, slots=True)
class Words:
    """What the message needs to name a place: index (k,) of each mean in + then -, m targets, their
    positions.
    """

    index: NDArray[np.intp]
    m: int
    positions: FloatArray | None
    unit: PositionUnit

    def length(self, value: float) -> str:
        """Return a deviation with its unit, in µm or arcsec, two significant digits or more."""
        outside = abs(value) * outside_factor(self.unit)
        decimals = 1 if outside >= 1.0 else 2
        return f"{outside:.{decimals}f} {'µm' if self.unit == 'mm' else 'arcsec'}"

    def place(self, which: int) -> str:
        """Return where the ``which``-th mean was measured."""
        index = int(self.index[which])
        direction = "+" if index < self.m else "-"
        target = index % self.m
        where = (
            f"target {target + 1}"
            if self.positions is None
            else f"{self.positions[target]:g} {self.unit}"
        )
        return f"{where} approached in {direction}"

    def between_directions(self, residual: FloatArray) -> float:
        """Return mean(+) minus mean(-) of a residual (k,), 0 when one direction alone was
        measured.
        """
        positive = self.index < self.m
        if positive.all() or not positive.any():
            return 0.0
        return float(residual[positive].mean() - residual[~positive].mean())


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _effect_text(compared: Comparison) -> str:
    return f"{compared.factor:.2f} ± {1.0 / compared.effect:.2f} of the planned effect"


def loaded_message(compared: Comparison, words: Words) -> str:
    """Return what is said of a table that acts as planned."""
    return (
        f"The table acts as planned: the after test shows {_effect_text(compared)} and lies within "
        f"{words.length(_rms(compared.residual_loaded))} rms of the prediction."
    )


def inactive_message(compared: Comparison, words: Words) -> str:
    """Return what is said of a table that does not act."""
    return (
        f"The table does not act: the after test shows {_effect_text(compared)} and lies within "
        f"{words.length(_rms(compared.residual_inactive))} rms of what the control did before."
    )


def open_message(
    compared: Comparison, words: Words, *, fits_loaded: bool, fits_inactive: bool
) -> str:
    """Return what is said where more than one name fits, and which correction would be seen."""
    text = (
        "Cannot tell: with and without the new table the targets differ by"
        f" {words.length(compared.size)} rms, and the noise of a reading is"
        f" {words.length(compared.noise)}"
    )
    if compared.effect > 0.0:
        needed = compared.size * VISIBLE / compared.effect
        if needed > compared.size:
            text += (
                f"; the correction is smaller than the {words.length(needed)} rms that this test"
                " can tell for sure"
            )
        text += f". Measured: {_effect_text(compared)}"
    candidates = [
        name for name, fits in (("loaded", fits_loaded), ("not active", fits_inactive)) if fits
    ]
    return f"{text}. Possible: {', '.join([*candidates, 'acting in part'])}."


def neither_message(compared: Comparison, words: Words) -> str:
    """Return by how much, and where, a test contradicts both expectations."""
    parts = [
        "The after test fits neither the loaded table nor the control as it was before.",
        _off_text("Against the prediction", compared.residual_loaded, words),
        _off_text("Against no change", compared.residual_inactive, words),
    ]
    offset = words.between_directions(compared.residual_loaded)
    if offset:
        sign = "above" if offset > 0.0 else "below"
        parts.append(
            f"Against the prediction the + approaches lie {words.length(offset)} {sign} the -"
            " approaches on average."
        )
    if compared.effect > 0.0:
        parts.append(f"Measured: {_effect_text(compared)}.")
    return " ".join(parts)


def _off_text(against: str, residual: FloatArray, words: Words) -> str:
    worst = int(np.argmax(np.abs(residual)))
    return (
        f"{against} it is off by {words.length(_rms(residual))} rms and at worst by"
        f" {words.length(float(residual[worst]))} ({words.place(worst)})."
    )


def slope_text(slope: float, error: float, declared: float) -> str:
    """Return a slope (mm/mm) with its standard error, and what of temperature it would be."""
    text = (
        f"Over the travel its deviations rise by {slope * _PPM:+.2f} ± {error * _PPM:.2f} µm/m more"
        f" than expected: steel does that over {significant(slope * _PPM / _STEEL, signed=True)} K"
    )
    if declared > 0.0:
        text += f" (declared for two tests: ± {2.0 * declared * _PPM:.1f} µm/m, k = 2)"
    return (
        f"{text}. State the temperature of the scale in the files of both tests (T_m) and its"
        " coefficient in the job (thermal), or measure again once machine and instrument have"
        " settled; look at the instrument's temperature sensor."
    )


def thermal_message(sloped: Comparison, text: str) -> str:
    """Return what is said of a table that acts on an axis that is longer or shorter now."""
    return f"The table acts: beside a slope the after test shows {_effect_text(sloped)}. {text}"


def straight_line_message(text: str, acts_by: float) -> str:
    """Return what is said where the correction is a straight line too."""
    return (
        f"The after test is that of the loaded table and a slope. {text} The correction is a"
        f" straight line itself: a table that acts by {acts_by:.2f} of itself would show the same;"
        " read the values back from the control (--loaded)."
    )


def inactive_slope_message(sloped: Comparison) -> str:
    """Return what is said of a table that does not act, on an axis that is longer or shorter
    now.
    """
    return f"The table does not act: beside a slope the after test shows {_effect_text(sloped)}."


def open_slope_message(sloped: Comparison, text: str) -> str:
    """Return what is said where a slope explains the test, and leaves open what the table does."""
    shown = f" Measured beside it: {_effect_text(sloped)}." if sloped.effect > 0.0 else ""
    return (
        f"Cannot tell: a slope beside the expected explains the after test.{shown} {text} Possible:"
        " thermal, scaled, not active."
    )
