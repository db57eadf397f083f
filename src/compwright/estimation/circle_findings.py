"""Findings about the causes of a circular test: detected causes, and causes that cannot be
separated.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np

from compwright.estimation.circle_cyclic import longest_pitch, shortest_pitch
from compwright.estimation.circle_model import AXES, SOFTEST_LOOP
from compwright.estimation.circle_reversal import INWARD, SpikeDraws
from compwright.estimation.circle_solution import Solution
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularEffect, CircularTest, Diagnosis
from compwright.words.sentences import Amount, Sentence, say

#: A standard error so many times that of the cause alone is worth a word when the test is not a
#: full circle both ways.
_INFLATED: Final = 2.5
_MOST_NAMED: Final = 4  # of such causes in one finding
#: A doubt about the scale below this, um/m, is not worth a second test.
_LEAST_DOUBT: Final = 1.0
#: The lost motion of an axis, um, that is clearly negative, also by so many standard errors (as
#: CW-T032 of positioning tests).
_NEGATIVE: Final = -3.0
_SURE: Final = 4.0
#: Standard errors beyond which a deviation is reported.
_CLEAR: Final = 3.0


def diagnosis_findings(
    test: CircularTest,
    solution: Solution,
    effects: Mapping[str, CircularEffect],
    correlation: FloatArray,
) -> tuple[Finding, ...]:
    """Return the findings about the ``effects`` of the causes and their ``correlation`` matrix."""
    return (
        *_separation(test, solution, effects, correlation),
        *_scale_findings(test, solution, effects),
        *_shape_findings(test, solution),
    )


def negative_findings(diagnosis: Diagnosis) -> Iterator[Finding]:
    """Yield the finding CW-D013 if the lost motion of an axis is clearly negative, and that of both
    together below zero: it is compensated too much, or a sign or direction of the file is turned.
    With the sign or the sense of the angles, squareness is turned too.
    """
    lost = [
        effect
        for name, effect in diagnosis.effects.items()
        if name in {"backlash_first", "backlash_second"} and name not in diagnosis.undetermined
    ]
    clear = any(effect.value < min(_NEGATIVE, -_SURE * effect.std_error) for effect in lost)
    if clear and sum(effect.value for effect in lost) < 0.0:
        values = [Amount(effect.value, "µm", "+.1f") for effect in lost]
        yield Finding.of("CW-D013", "warning", values=values)


def _separation(
    test: CircularTest,
    solution: Solution,
    effects: Mapping[str, CircularEffect],
    correlation: FloatArray,
) -> Iterator[Finding]:
    """Yield findings about causes that the test cannot separate, because it has one direction only,
    an arc, or no reversal point of an axis.
    """
    samples, names = solution.problem.samples, solution.problem.names
    order = list(effects)
    poor: list[tuple[float, Sentence]] = []
    alone_of = dict(zip(solution.fitted.active, solution.fitted.information, strict=True))
    causes = [
        name
        for name in order
        if name in names and "_at_" not in name and names.index(name) in alone_of
    ]
    for name in causes:
        alone = alone_of[names.index(name)]
        factor = float(effects[name].std_error * np.sqrt(alone))
        if factor > _INFLATED:
            others = [other for other in causes if other != name]
            row = np.abs(correlation[order.index(name)])
            other = max(others, key=lambda other: row[order.index(other)])
            poor.append((factor, say("CW-D001.cause", cause=name, factor=factor, other=other)))
    poorest = [words for _, words in sorted(poor, key=lambda each: -each[0])[:_MOST_NAMED]]
    if len(poor) > _MOST_NAMED:
        poorest.append(say("CW-D001.more", count=len(poor) - _MOST_NAMED))
    if not samples.both_senses:
        yield Finding.of("CW-D001", "warning", causes=poorest)
    if not test.full_circle:
        yield Finding.of("CW-D002", "warning", arc=test.arc[1], causes=poorest)
    for axis, name in zip(AXES, test.axes, strict=True):
        ends = samples.reversals(axis)
        if not any(ends):
            yield Finding.of("CW-D005.none", "warning", name=name)
        elif not all(ends):
            end = "positive" if ends[0] else "negative"
            yield Finding.of("CW-D005.one", "info", name=name, end=end)


def _scale_findings(
    test: CircularTest, solution: Solution, effects: Mapping[str, CircularEffect]
) -> Iterator[Finding]:
    if not test.calibrated:
        yield Finding.of("CW-D003", "info")
        return
    samples = solution.problem.samples
    most = samples.speed**2 / (2.0 * SOFTEST_LOOP**2 * samples.radius) * MICROMETRES_PER_MILLIMETRE
    doubt = most / np.sqrt(3.0) / samples.radius * MICROMETRES_PER_MILLIMETRE
    if doubt > max(0.5 * effects["scale_error_first"].std_error, _LEAST_DOUBT):
        yield Finding.of("CW-D004", "warning", feed=test.feed, most=most, doubt=doubt)


def _shape_findings(test: CircularTest, solution: Solution) -> Iterator[Finding]:
    for axis, name in zip(AXES, test.axes, strict=True):
        for wave in solution.cyclic_waves(axis):
            if wave not in solution.given:
                pitch = 1.0 / solution.cyclic_wave(wave)[0]
                yield Finding.of("CW-D006", "info", axis=name, pitch=pitch)
        if axis in solution.hidden and axis not in solution.frequencies:
            samples, hidden = solution.problem.samples, solution.hidden[axis]
            least, most = shortest_pitch(samples), longest_pitch(samples)
            yield Finding.of("CW-D007", "info", name=name, hidden=hidden, least=least, most=most)
        inward = [
            (depth, spike)
            for spike in solution.draws.spikes
            if spike.reversal.axis == axis
            and spike.reversal.inside
            and (depth := float(np.mean(spike.depths))) > _CLEAR * _depth_error(spike)
        ]
        if inward:
            depth, spike = max(inward, key=lambda each: each[0])
            travel = taken_up_over(solution, spike)
            if travel is None:
                yield Finding.of("CW-D008.inward", "warning", name=name, inward=depth)
            else:
                yield Finding.of(
                    "CW-D008.gradual", "warning", name=name, inward=depth, travel=travel
                )
    length = float(np.mean([spectrum.length for spectrum in solution.fitted.spectra]))
    samples = solution.problem.samples
    if length > 0.1 * samples.theta.size / np.unique(samples.run).size:
        rms = float(np.sqrt(np.mean(solution.residual**2))) * MICROMETRES_PER_MILLIMETRE
        yield Finding.of("CW-D010", "info", rms=rms)


def _depth_error(spike: SpikeDraws) -> float:
    return float(np.hypot(np.std(np.mean(spike.depths, axis=1)), spike.least_error))


def taken_up_over(solution: Solution, spike: SpikeDraws) -> float | None:
    """Return the travel, um, after which 1/e of the inward deviation of a ``spike`` remains, if it
    is lost motion that the axis takes up gradually; None if it is something else.

    While lost motion is taken up, the path lies inside by no more than this lost motion: never
    inside the path before the reversal. More than twice the lost motion is something else, however
    uncertain it is. After an arc s the axis has moved by s² / 2R.
    """
    if float(np.mean(spike.depths)) <= INWARD * float(np.mean(spike.heights)):
        return None
    lost = solution.draws.values[:, spike.lost]
    over = np.mean(spike.depths + spike.deeper, axis=1) - lost
    clear = _CLEAR * float(np.hypot(np.std(over), spike.least_error))
    if float(np.mean(over)) > min(clear, float(np.mean(lost))):
        return None
    arc = float(np.median(spike.rise + spike.decay))
    return arc**2 / (2.0 * solution.problem.samples.radius) * MICROMETRES_PER_MILLIMETRE
