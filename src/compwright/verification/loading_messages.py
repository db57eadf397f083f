"""Sentences of a loading verdict: what was measured and where, in µm or arcsec, and the possible
causes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.foundations.units import PositionUnit, outside_factor, shown_unit
from compwright.records.axis import FloatArray
from compwright.records.verification import Candidate, LoadingName
from compwright.verification.hypothesis import Hypothesis
from compwright.verification.likelihood import AfterMeans, ErrorBelief
from compwright.words.sentences import Amount, Sentence, say

_PPM: Final = 1e6
#: Expansion of steel, µm/(m K).
_STEEL: Final = 11.5
#: A slope that the job explains is reported from three standard errors on, and from a tenth of a
#: kelvin of steel.
_CLEAR_SLOPE: Final = 3.0
_LEAST_SLOPE: Final = 0.1 * _STEEL / _PPM
#: Effect in its own standard errors from which 95 % of the tests tell all of it from half of it at
#: odds of 100:1: D^2 / 8 - 1.645 D / 2 = ln 100.
VISIBLE: Final = 10.2


@dataclass(frozen=True, slots=True)
class ShownTest:
    """The measured mean deviations of a test and those expected with and without the new table,
    from which the sentences of a verdict are made.

    ``means`` (2, m): in + and - at ``targets``, NaN if there is none. ``noise``: standard deviation
    of a reading. ``effect``: the part of the difference between the expected means that the test
    shows, with its standard error. ``read_back``: whether the values that were read back from the
    control equal the planned values. All are in mm or deg by ``unit``.
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
    ) -> ShownTest:
        """Return the mean deviations of the test ``after``, with those expected if the table is
        loaded and those expected if the table is not active. ``effect``: the fraction of the
        planned change that the test shows, with its standard error.
        """
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
        """Return the measured minus the ``expected`` mean deviations (2, m), without the offset
        that all have in common.
        """
        left = self.means - expected
        removed: FloatArray = left - np.nanmean(left)
        return removed

    def length(self, value: float) -> Amount:
        """Return a deviation as text in µm or arcsec with two significant digits or more."""
        outside = float(abs(value) * outside_factor(self.unit))
        return Amount(outside, shown_unit(self.unit), ".1f" if outside >= 1.0 else ".2f")

    def rms(self, values: FloatArray) -> Sentence:
        """Return the root mean square of the finite ``values`` as text."""
        return say("loading.rms", rms=self.length(float(np.sqrt(np.nanmean(values**2)))))

    def worst(self, values: FloatArray) -> Sentence:
        """Return, as text, the largest of the ``values`` (2, m) by amount, with its target and
        direction.
        """
        side, target = np.unravel_index(int(np.nanargmax(np.abs(values))), values.shape)
        return say(
            "loading.worst",
            value=self.length(float(values[side, target])),
            position=Amount(float(self.targets[target]), self.unit, "g"),
            direction="+" if side == 0 else "−",
        )

    def between_directions(self, values: FloatArray) -> float:
        """Return how much larger the residuals (2, m) are in + than in − on average; 0 if only one
        direction was measured.
        """
        there = np.isfinite(values).any(axis=1)
        return float(np.nanmean(values[0]) - np.nanmean(values[1])) if there.all() else 0.0

    @property
    def effect_text(self) -> Sentence | None:
        """The fraction of the planned effect that the test shows, as text; None if no effect is
        planned.
        """
        part, error = self.effect
        return say("loading.effect", part=part, error=error) if math.isfinite(error) else None

    @property
    def size(self) -> float:
        """The standard deviation of the planned effect over all measured means (0 if unknown), mm
        or deg.
        """
        if self.loaded is None or self.inactive is None:
            return 0.0
        step = (self.loaded - self.inactive)[np.isfinite(self.means)]
        return float(np.std(step))


def candidate_text(candidate: LoadingName, detail: Sentence | None = None) -> Sentence:
    """Return the name of a possible verdict, with its most probable variant ``detail``, as printed
    for the user.
    """
    return say("loading.name", name=candidate, detail=detail)


# ---------------------------------------------------------------- names that are given


def named_message(
    shown: ShownTest,
    name: LoadingName,
    way: Hypothesis,
    expected: FloatArray,
    factor: float,
    equivalent: Sequence[LoadingName],
) -> list[Sentence]:
    """Return the sentences of a verdict that names one hypothesis (a verdict other than
    ``undecided``): what was measured, how large the differences are, and at which target they are
    largest.

    ``expected`` (2, m): the test that the verdict would show.
    """
    sentences = [
        _sentence(shown, name, way, factor, undecided=bool(equivalent) and not shown.read_back),
        *_evidence(shown, name, expected),
    ]
    if equivalent:
        sentences.append(
            say(
                "loading.equivalent",
                names=[candidate_text(other) for other in equivalent],
                read_back=shown.read_back,
            )
        )
    return sentences


def _sentence(
    shown: ShownTest, name: LoadingName, way: Hypothesis, factor: float, *, undecided: bool
) -> Sentence:
    """Return the first sentence of a verdict. ``undecided``: another fault would give the same
    test; then it names no step that is right for one of them only.
    """
    if name == "measurement":
        return say(
            "loading.measurement",
            fault=way.of or "sign",
            factor=1.0 / factor,
            axis=way.detail,
        )
    return say(
        "loading.verdict",
        verdict=name,
        detail=way.detail,
        effect=shown.effect_text,
        factor=factor,
        nodes=abs(way.shift_nodes),
        direction="+" if way.shift_nodes > 0 else "-",
        open=undecided,
    )


def _evidence(shown: ShownTest, name: LoadingName, expected: FloatArray) -> Iterator[Sentence]:
    mine = shown.rms(shown.left(expected))
    if name == "loaded":
        yield say("loading.as_predicted", left=mine)
    elif name == "not_active":
        yield say("loading.as_before", left=mine)
    elif shown.loaded is not None:
        off = shown.left(shown.loaded)
        yield say(
            "loading.evidence",
            off=shown.rms(off),
            worst=shown.worst(off),
            left=mine,
            noise=shown.length(shown.noise),
            effect=shown.effect_text,
        )


# ---------------------------------------------------------------- nothing clear


def open_message(
    shown: ShownTest, candidates: Sequence[Candidate], unexplained: FloatArray | None
) -> Sentence:
    """Return the sentence of an undecided verdict, with the smallest change of the correction that
    such a test could detect.

    ``unexplained`` (2, m): the test that the most probable verdict predicts, if the remaining
    difference is more than noise; None if the test fits that verdict.
    """
    error = shown.effect[1]
    needed = shown.size * VISIBLE * error if math.isfinite(error) else 0.0
    off = None if unexplained is None else shown.left(unexplained)
    return say(
        "loading.open",
        size=shown.length(shown.size),
        noise=shown.length(shown.noise),
        needed=shown.length(needed) if needed > shown.size else None,
        effect=shown.effect_text,
        candidates=[
            say(
                "loading.candidate",
                name=candidate_text(each.verdict, each.detail),
                percent=100.0 * each.probability,
                sure=each.probability >= 0.995,
            )
            for each in candidates
        ],
        off=None if off is None else shown.rms(off),
        worst=None if off is None else shown.worst(off),
    )


def neither_message(shown: ShownTest) -> Sentence:
    """Return the sentence that a test contradicts every hypothesis. It states how large the
    differences are, and where.
    """
    loaded, inactive = (
        None if expected is None else shown.left(expected)
        for expected in (shown.loaded, shown.inactive)
    )
    offset = 0.0 if loaded is None else shown.between_directions(loaded)
    return say(
        "loading.neither",
        loaded=None if loaded is None else shown.rms(loaded),
        loaded_worst=None if loaded is None else shown.worst(loaded),
        inactive=None if inactive is None else shown.rms(inactive),
        inactive_worst=None if inactive is None else shown.worst(inactive),
        offset=shown.length(offset) if offset else None,
        above=offset > 0.0,
        effect=shown.effect_text,
    )


# ---------------------------------------------------------------- slopes


def slope_text(slope: float, error: float, declared: float) -> Sentence:
    """Return a slope (mm/mm) with standard error as text, with the temperature difference that
    would cause it, and with the ``declared`` uncertainty of the slope (0 if none is declared).
    """
    return say(
        "loading.slope",
        slope=slope * _PPM,
        error=error * _PPM,
        kelvin=slope * _PPM / _STEEL,
        declared=2.0 * declared * _PPM if declared > 0.0 else None,
    )


def declared_slope_text(slope: float, error: float, declared: float) -> Sentence | None:
    """Return the sentence about the slope (mm/mm) of a test with an active table. ``declared``: the
    uncertainty of the slope that the job declares. Return None if the slope is insignificant or no
    uncertainty is declared.
    """
    if declared <= 0.0 or abs(slope) < max(_CLEAR_SLOPE * error, _LEAST_SLOPE):
        return None
    return say(
        "loading.declared_slope",
        slope=slope * _PPM,
        error=error * _PPM,
        kelvin=slope * _PPM / _STEEL,
        within=abs(slope) <= 2.0 * declared,
        declared=2.0 * declared * _PPM,
    )


def thermal_message(shown: ShownTest, expected: FloatArray, slope: Sentence) -> Sentence:
    """Return the sentence that the table is active, but the axis is now longer or shorter."""
    return say("loading.thermal", left=shown.rms(shown.left(expected)), slope=slope)


def straight_line_message(shown: ShownTest, slope: Sentence, active_part: float) -> Sentence:
    """Return the sentence that the test cannot distinguish an additional slope from the wrong
    factor ``active_part`` on the table, because the planned correction is a straight line.
    """
    return say(
        "loading.straight_line",
        slope=slope,
        factor=active_part,
        read_back=shown.read_back,
    )
