"""What a verdict about the loading says: what was seen and where, in µm or arcsec, and what would
explain it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.foundations.numerals import significant
from compwright.foundations.units import PositionUnit, outside_factor
from compwright.records.axis import FloatArray
from compwright.records.verification import Candidate, LoadingName
from compwright.verification.hypothesis import Hypothesis
from compwright.verification.likelihood import AfterMeans, ErrorBelief

_PPM: Final = 1e6
#: Expansion of steel, µm/(m K).
_STEEL: Final = 11.5
#: A slope that the job explains is told from three standard errors on, and from a tenth of a kelvin
#: of steel.
_CLEAR_SLOPE: Final = 3.0
_LEAST_TOLD: Final = 0.1 * _STEEL / _PPM
#: Effect in its own standard errors from which 95 % of the tests tell all of it from half of it at
#: odds of 100:1: D^2 / 8 - 1.645 D / 2 = ln 100.
VISIBLE: Final = 10.2
_BACK: Final = "the values that were read back from the control are the plan's (--loaded)"


@dataclass(frozen=True, slots=True)
class Shown:
    """What a test shows: its ``means`` (2, m) in + and -, NaN where there is none, at ``targets``;
    ``noise`` of a reading; the means expected with the new table and without it; ``effect``: which
    part of their difference it shows, with its standard error; ``read_back``: the values that were
    read back from the control are the plan's. mm or deg by ``unit``.
    """

    means: FloatArray
    targets: FloatArray
    unit: PositionUnit
    noise: float
    loaded: FloatArray | None
    inactive: FloatArray | None
    effect: tuple[float, float]
    read_back: bool = False

    @classmethod
    def of(
        cls,
        after: AfterMeans,
        belief: ErrorBelief,
        hypotheses: Sequence[Hypothesis],
        effect: tuple[float, float],
        *,
        read_back: bool = False,
    ) -> Shown:
        """Return what ``after`` shows beside the expectations of its first hypotheses."""
        expected = {
            name: next((belief.mean + h.change for h in hypotheses if h.name == name), None)
            for name in ("loaded", "not_active")
        }
        return cls(
            means=after.plain,
            targets=after.targets,
            unit=after.kind.unit,
            noise=after.sigma,
            loaded=expected["loaded"],
            inactive=expected["not_active"],
            effect=effect,
            read_back=read_back,
        )

    def left(self, expected: FloatArray) -> FloatArray:
        """Return what is left (2, m) beside what is ``expected``, the datum removed."""
        left = self.means - expected
        removed: FloatArray = left - np.nanmean(left)
        return removed

    def length(self, value: float) -> str:
        """Return a deviation with its unit, in µm or arcsec, two significant digits or more."""
        outside = abs(value) * outside_factor(self.unit)
        decimals = 1 if outside >= 1.0 else 2
        return f"{outside:.{decimals}f} {'µm' if self.unit == 'mm' else 'arcsec'}"

    def rms(self, values: FloatArray) -> str:
        """Return the root mean square of what is there."""
        return f"{self.length(float(np.sqrt(np.nanmean(values**2))))} rms"

    def worst(self, values: FloatArray) -> str:
        """Return the largest value and where it was measured."""
        side, target = np.unravel_index(int(np.nanargmax(np.abs(values))), values.shape)
        where = f"{self.targets[target]:g} {self.unit}"
        direction = "+" if side == 0 else "-"
        return f"{self.length(float(values[side, target]))} ({where} approached in {direction})"

    def between_directions(self, values: FloatArray) -> float:
        """Return mean(+) minus mean(-) of what is left (2, m), 0 where one direction alone was
        measured.
        """
        there = np.isfinite(values).any(axis=1)
        return float(np.nanmean(values[0]) - np.nanmean(values[1])) if there.all() else 0.0

    @property
    def effect_text(self) -> str:
        """Which part of the planned effect was measured; empty where there is none."""
        part, error = self.effect
        return f"{part:.2f} ± {error:.2f} of the planned effect" if math.isfinite(error) else ""

    @property
    def size(self) -> float:
        """Root mean square of the planned effect at the means that there are, mm or deg."""
        if self.loaded is None or self.inactive is None:
            return 0.0
        step = (self.loaded - self.inactive)[np.isfinite(self.means)]
        return float(np.std(step))


def words_of(candidate: LoadingName, detail: str = "") -> str:
    """Return a name as it is told, with its variant."""
    name = candidate.replace("_", " ")
    return f"{name}: {detail}" if detail else name


# ---------------------------------------------------------------- names that are given


def named_message(
    shown: Shown,
    name: LoadingName,
    way: Hypothesis,
    expected: FloatArray,
    factor: float,
    equivalent: Sequence[LoadingName],
) -> str:
    """Return what is said of a verdict: what was seen, by how much and where; ``expected`` (2, m):
    the test that the verdict would show.
    """
    text = f"{_sentence(shown, name, way, factor)} {_evidence(shown, name, expected)}"
    if equivalent:
        others = ", ".join(words_of(other) for other in equivalent)
        back = "the values that are read back from the control do (--loaded)"
        text += (
            f" The same test would come from: {others}. No measurement of this axis tells them"
            f" apart; {_BACK if shown.read_back else back}."
        )
    return text


def _sentence(shown: Shown, name: LoadingName, way: Hypothesis, factor: float) -> str:
    detail = f" ({way.detail})" if way.detail else ""
    effect = f": the after test shows {shown.effect_text}" if shown.effect_text else ""
    nodes = "node" if abs(way.shift_nodes) == 1 else "nodes"
    if name == "measurement":
        return _measured_wrong(way, factor)
    sentences: dict[LoadingName, str] = {
        "loaded": f"The table is active as planned{effect}.",
        "not_active": f"The table is not active{detail}{effect}.",
        "inverted": f"The table is active with the opposite sign{detail}: it adds to the error.",
        "scaled": f"The table is active with factor {significant(factor, 3)}{detail}.",
        "shifted": (
            f"The table sits {abs(way.shift_nodes)} {nodes} too far to"
            f" {'+' if way.shift_nodes > 0 else '-'}{detail}."
        ),
        "mirrored": f"The table is loaded back to front, its last value first{detail}.",
        "wrong_axis": f"The table that is active is that of axis {way.of}{detail}.",
        "one_direction": f"The table is active in one direction only: {way.detail}.",
        "backlash": f"The table is active, and its backlash is wrong: {way.detail}.",
        "partial": f"A part of the table is active: {way.detail}.",
        "increment": (
            f"Only the change to the existing table is active{detail}: load the total, which is in"
            " the written files."
        ),
        "on_top": (
            f"The new total was added to the existing table{detail}: clear the table and load the"
            " written files again."
        ),
        "state": (
            "The existing table was not active while the test before was taken, although the job"
            " says that it was. Run the job again with `active: no` for this state."
        ),
    }
    return sentences[name]


def _measured_wrong(way: Hypothesis, factor: float) -> str:
    what = {
        "sign": "the sign of its deviations is turned",
        "direction": "its directions + and − are exchanged",
        "unit": f"its readings are multiplied by {significant(1.0 / factor, 4)}",
        "wrong_axis": f"it is one of {way.detail}",
    }[way.of or "sign"]
    advice = {
        "wrong_axis": "Measure this axis, or give the file to its own axis.",
        "unit": "Export it in the unit that its file states.",
    }
    told = advice.get(
        way.of or "",
        "Check sign and directions of the instrument and export the test again.",
    )
    return f"The after test is explained when {what}, and not as it stands. {told}"


def _evidence(shown: Shown, name: LoadingName, expected: FloatArray) -> str:
    mine = shown.rms(shown.left(expected))
    if name == "loaded":
        return f"It lies within {mine} of the prediction."
    if name == "not_active":
        return f"It lies within {mine} of what the control did before."
    if shown.loaded is None:
        return ""
    off = shown.left(shown.loaded)
    measured = f" Measured: {shown.effect_text}." if shown.effect_text else ""
    return (
        f"Against the prediction the test is off by {shown.rms(off)} and at worst by"
        f" {shown.worst(off)}; with this explanation {mine} are left, and the noise of a reading is"
        f" {shown.length(shown.noise)}.{measured}"
    )


# ---------------------------------------------------------------- nothing clear


def open_message(
    shown: Shown, candidates: Sequence[Candidate], unexplained: FloatArray | None
) -> str:
    """Return what is said where no name is clear, and which correction would be seen.

    ``unexplained`` (2, m): the test that the likeliest name would show, where what the test shows
    beside it is more than noise; None where it fits.
    """
    text = (
        "Cannot tell: with and without the new table the targets differ by"
        f" {shown.length(shown.size)} rms, and the noise of a reading is"
        f" {shown.length(shown.noise)}"
    )
    error = shown.effect[1]
    if math.isfinite(error):
        needed = shown.size * VISIBLE * error
        if needed > shown.size:
            text += (
                f"; the correction is smaller than the {shown.length(needed)} rms that this test"
                " can prove"
            )
        text += f". Measured: {shown.effect_text}"
    told = ", ".join(
        f"{words_of(each.verdict, each.detail)} ({_percent(each.probability)})"
        for each in candidates
    )
    text = f"{text}. Possible: {told}."
    if unexplained is None:
        return text
    off = _off_text("But compared with the first of these", shown.left(unexplained), shown)
    return f"{text} {off} That is more than noise: something else changed, or the test is at fault."


def _percent(probability: float) -> str:
    return f"{significant(100.0 * probability, 2)} %" if probability < 0.995 else "more than 99 %"


def neither_message(shown: Shown) -> str:
    """Return by how much, and where, a test contradicts every way of loading."""
    text = (
        "The after test fits neither the loaded table nor the control as it was before, nor any"
        " known fault of loading."
    )
    parts = [text]
    if shown.loaded is not None:
        parts.append(_off_text("Against the prediction", shown.left(shown.loaded), shown))
    if shown.inactive is not None:
        parts.append(_off_text("Against no change", shown.left(shown.inactive), shown))
    offset = 0.0 if shown.loaded is None else shown.between_directions(shown.left(shown.loaded))
    if offset:
        sign = "above" if offset > 0.0 else "below"
        parts.append(
            f"Against the prediction the + approaches lie {shown.length(offset)} {sign} the -"
            " approaches on average."
        )
    if shown.effect_text:
        parts.append(f"Measured: {shown.effect_text}.")
    return " ".join(parts)


def _off_text(what: str, left: FloatArray, shown: Shown) -> str:
    return f"{what} it is off by {shown.rms(left)} and at worst by {shown.worst(left)}."


# ---------------------------------------------------------------- slopes


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


def declared_slope_text(slope: float, error: float, declared: float) -> str:
    """Return a slope (mm/mm) of a test whose table acts, where it is clear and the job declares
    some (``declared``: standard deviation between two tests); else an empty text.
    """
    if declared <= 0.0 or abs(slope) < max(_CLEAR_SLOPE * error, _LEAST_TOLD):
        return ""
    within = "within" if abs(slope) <= 2.0 * declared else "beyond"
    return (
        f"Over the travel its deviations rise by {slope * _PPM:+.2f} ± {error * _PPM:.2f} µm/m more"
        f" than expected: steel does that over {significant(slope * _PPM / _STEEL, signed=True)} K,"
        f" {within} what the job declares for two tests (± {2.0 * declared * _PPM:.1f} µm/m, k ="
        " 2). The table is not at fault, but the limits are decided with the slope in the readings."
    )


def thermal_message(shown: Shown, expected: FloatArray, text: str) -> str:
    """Return what is said of a table that acts on an axis that is longer or shorter now."""
    return (
        "The table is active: apart from a slope the after test is within"
        f" {shown.rms(shown.left(expected))} of the prediction. {text}"
    )


def straight_line_message(shown: Shown, text: str, acts_by: float) -> str:
    """Return what is said where the correction is a straight line too."""
    return (
        f"The after test is that of the loaded table and a slope. {text} The correction is a"
        f" straight line itself: a table that is active with factor {acts_by:.2f} would show the"
        " same;"
        f" {_BACK if shown.read_back else 'read the values back from the control (--loaded)'}."
    )
