"""The causes of circular deviations with the names and units of the JSON output. Each cause has a
standard error, or a reason why its value is missing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.circle_causes import (
    OTHER_RESPONSE,
    ReportedCause,
    linear_cause,
    scale_errors,
    scale_mismatch,
    shapes_cause,
    squareness,
)
from compwright.estimation.circle_centre import radial_ranges
from compwright.estimation.circle_cyclic import wave_names
from compwright.estimation.circle_findings import diagnosis_findings, taken_up_over
from compwright.estimation.circle_lag import shrink_uncertainty
from compwright.estimation.circle_model import (
    AXES,
    ENDS,
    PRIORS,
    UM,
    CircleSamples,
    prior_width,
    sample_spacing,
)
from compwright.estimation.circle_path import absent_causes, by_full_circle
from compwright.estimation.circle_reversal import HIDDEN, INWARD, SpikeDraws
from compwright.estimation.circle_solution import Solution
from compwright.estimation.circle_symptoms import (
    irregular_motion,
    lobes,
    positional_tolerance,
    raw_peak,
    stick_slip,
)
from compwright.estimation.circle_vibration import Vibration, radial_share
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularEffect, CircularTest
from compwright.words.sentences import Sentence, say

UNITS: Final = {
    "squareness": "um/m",
    "scale_error_first": "um/m",
    "scale_error_second": "um/m",
    "servo_mismatch": "ms",
}
_ONE_SIDED: Final = 1.645  # standard errors to the lower end of a one-sided 95 % interval
#: A standard error above this share of the prior's standard deviation: the prior weighs more than
#: the data.
_MOSTLY_PRIOR: Final = np.sqrt(0.5)
#: Standard errors of a spike beyond its height and this, um, from which it is not given.
_NO_SPIKE: Final = 5.0
#: How slow instrument and drive may be, s: a spike is higher than it shows by this over its decay.
_RESPONSE: Final = 0.003
#: The same in samples: instruments filter at about the rate at which they sample.
_FILTER: Final = 0.3
#: Prior probability that an inward deviation about as large as the lost motion is a spike, not
#: lost motion that is taken up gradually. A smaller one may equally be both with a spike outward.
#: It is the least chance with which either lies within two standard errors of the value.
_INSIDE: Final = 0.2
#: Share of its height that a sum of two decays cuts off a spike with an edge, which an axis makes
#: that stands still until its drive moves it (9 to 26 % by least squares).
_EDGE: Final = 0.17


def report_effects(
    test: CircularTest, solution: Solution, undetermined: Mapping[str, Sentence]
) -> tuple[dict[str, CircularEffect], FloatArray, dict[str, Sentence], tuple[Finding, ...]]:
    """Return the effect of each cause by name, the correlation of the effects, the reasons for
    missing effects (from ``undetermined``, by cause), and the findings.

    Some effects are details of another cause: each end of a lost motion or spike, scale errors,
    lobes. The sum of the causes contains none of them but an end whose axis has no value. A share
    is relative to this sum, and 0 if the effect is missing. ``low``: end of a one-sided 95 % range.
    """
    samples = solution.problem.samples
    causes = tuple(_causes(test, solution))
    reasons = absent_causes(test, {cause.name for cause in causes}) | {
        cause.name: reason
        for cause in causes
        if (
            reason := undetermined.get(cause.name)
            or cause.reason
            or _prior_reason(cause, test, samples)
        )
    }
    drawn = np.array([cause.drawn for cause in causes])
    covariance = np.atleast_2d(np.cov(drawn, bias=True))
    covariance += np.diag([cause.variance for cause in causes])
    shrink = shrink_uncertainty(samples) / samples.radius * 1e6
    scales = np.array([1.0 if cause.name.startswith("scale_error") else 0.0 for cause in causes])
    covariance += shrink**2 * np.outer(scales, scales)
    errors = np.sqrt(np.maximum(np.diag(covariance), 1e-24))
    ranges = radial_ranges(samples.theta, np.array([cause.curve for cause in causes])) / UM
    ends = {f"{name}_at_{end}" for name in reasons for end in ("positive", "negative")}
    counted = [c.name not in reasons and (c.name in ends or not c.detail) for c in causes]
    total = float(np.sum(ranges[counted]))
    effects = {
        cause.name: CircularEffect(
            value=cause.value,
            std_error=float(error),
            unit=UNITS.get(cause.name, "um"),
            effect=float(size),
            share=float(size / total) if total > 0.0 and cause.name not in reasons else 0.0,
            low=(
                max(0.0, cause.value - _ONE_SIDED * float(np.sqrt(error**2 - cause.upwards)))
                if cause.positive
                else None
            ),
            more=cause.more,
            axis=cause.axis,
        )
        for cause, error, size in zip(causes, errors, ranges, strict=True)
    }
    correlation = covariance / np.outer(errors, errors)
    np.fill_diagonal(correlation, 1.0)
    return effects, correlation, reasons, diagnosis_findings(test, solution, effects, correlation)


def _prior_reason(
    cause: ReportedCause, test: CircularTest, samples: CircleSamples
) -> Sentence | None:
    try:
        width = prior_width(cause.name, samples.radius)
    except KeyError:
        return None
    if cause.std_error <= _MOSTLY_PRIOR * width:
        return None
    unit = UNITS.get(cause.name, "um").replace("um", "µm")
    error = cause.std_error
    why = say("undetermined.prior", value=cause.value, error=error, unit=unit, width=width)
    return why if test.full_circle and samples.both_senses else by_full_circle(why)


def _causes(test: CircularTest, solution: Solution) -> Iterator[ReportedCause]:
    samples = solution.problem.samples

    def linear(name: str, parts: Mapping[str, float], *, detail: bool = False) -> ReportedCause:
        return linear_cause(solution, name, parts, detail=detail)

    yield squareness(solution)
    changed = shapes_cause(solution, "master_slave")
    # Another response in the same time.
    changed = replace(changed, variance=changed.variance + (OTHER_RESPONSE * changed.value) ** 2)
    mismatch = scale_mismatch(solution, changed.value)
    yield mismatch
    if test.calibrated:
        yield from scale_errors(solution, mismatch)
    lost = {axis: _lost_motion_parts(samples, axis) for axis in AXES}
    unsure = dict.fromkeys(AXES, 0.0)
    for axis in AXES:
        ends = list(_lost_motion_ends(solution, axis, lost[axis]))
        unsure[axis] = float(np.mean([np.sqrt(each.variance) for each in ends] or 0.0)) ** 2
        yield replace(linear(f"backlash_{axis}", lost[axis]), variance=unsure[axis])
        yield from ends
    minus = {name: -weight for name, weight in lost["second"].items()}
    mismatch = linear("backlash_mismatch", {**lost["first"], **minus}, detail=True)
    yield replace(mismatch, variance=sum(unsure.values()))
    yield linear("servo_mismatch", {"servo_mismatch": 1.0})
    for axis in AXES:
        yield from _lateral_play(solution, axis)
        yield from _spikes(solution, axis)
        yield from _cyclic(solution, axis)
        yield linear(f"straightness_{axis}", {f"straightness_{axis}": 1.0})
    if samples.both_senses:
        for name in ("radius_change", "offset_change_first", "offset_change_second"):
            yield linear(name, {name: 1.0})
    yield shapes_cause(solution, "spiral")
    yield changed
    yield from _symptoms(test, solution)


def _lost_motion_parts(samples: CircleSamples, axis: str) -> dict[str, float]:
    """Return the columns whose weighted sum is the mean lost motion of both ends of an axis."""
    end = samples.only_end(axis)
    if end is not None:
        return {f"backlash_{axis}": 1.0, f"_lost_change_{axis}": -end}
    if all(samples.reversals(axis)):
        return {f"backlash_{axis}_at_{end}": 0.5 for end in ENDS}
    return {f"backlash_{axis}": 1.0}


def _lost_motion_ends(
    solution: Solution, axis: str, parts: Mapping[str, float]
) -> Iterator[ReportedCause]:
    """Yield the lost motion at each reversal point of an axis in the arc. Its variance includes the
    uncertainty of the spike shape, times the squared slope of the drawn lost motion over the drawn
    heights (Seber and Lee, Linear Regression Analysis, 2nd ed. 2003, ch. 6).
    """
    spikes = {(s.reversal.axis, s.reversal.end): s for s in solution.draws.spikes}
    for end, inside in zip(ENDS, solution.problem.samples.reversals(axis), strict=True):
        name = f"backlash_{axis}_at_{end}"
        if not inside:
            continue
        cause = linear_cause(
            solution, name, {name if name in parts else f"backlash_{axis}": 1.0}, detail=True
        )
        if (axis, end) in spikes:
            peak, of_shape, _ = _peak(spikes[axis, end], slice(None))
            both = np.cov(cause.drawn, peak, bias=True)
            slope = float(both[0, 1] / max(both[1, 1], 1e-12))
            cause = replace(cause, variance=slope**2 * of_shape)
        yield cause


def _lateral_play(solution: Solution, axis: str) -> Iterator[ReportedCause]:
    """Yield the mean lateral play of an axis. In a test with both directions and both reversal
    points of the axis, the lateral play at each of them follows: it changes along the axis.
    """
    name, change = f"lateral_play_{axis}", f"_lateral_change_{axis}"
    mean = linear_cause(solution, name, {name: 1.0})
    if change not in solution.problem.names:
        yield mean
        return
    theta = solution.problem.samples.theta
    along = np.cos(theta) if axis == "first" else np.sin(theta)
    unseen = solution.draws.least_error[change] ** 2  # that of a change which is not found
    for end, side in zip(ENDS, (1.0, -1.0), strict=True):
        cause = linear_cause(solution, f"{name}_at_{end}", {name: 1.0, change: side}, detail=True)
        if end == ENDS[0]:  # with the change, this curve is that of the whole axis
            yield replace(mean, curve=cause.curve)
        missing = max(mean.std_error**2 + unseen - cause.std_error**2, 0.0)
        yield replace(cause, curve=cause.curve * (side * along > 0.0), variance=missing)


def _spikes(solution: Solution, axis: str) -> Iterator[ReportedCause]:
    """Yield the mean reversal spike of an axis, then the spike at each end, followed by the spike
    of each direction if the directions probably differ.
    """
    found = [
        spike
        for spike in solution.draws.spikes
        if spike.reversal.axis == axis and spike.reversal.inside
    ]
    if not found:
        return
    ends = [_spike(solution, spike) for spike in found]
    mean = ReportedCause(
        name=f"reversal_spike_{axis}",
        value=float(np.mean([end.value for end in ends])),
        drawn=np.mean([end.drawn for end in ends], axis=0),
        curve=np.sum([end.curve for end in ends], axis=0),
        positive=all(end.positive for end in ends),
        # Bandwidth and sampling do the same to both ends.
        variance=float(np.mean([np.sqrt(end.variance) for end in ends])) ** 2,
        reason=None if len(ends) > 1 else by_full_circle(say("undetermined.one_reversal")),
    )
    yield replace(mean, reason=mean.reason or _unseen_spike(mean.value, mean.std_error))
    for spike, end in zip(found, ends, strict=True):
        yield end
        if spike.unlike > 0.5:
            for index, sense in enumerate(("ccw", "cw")):
                yield _spike(solution, spike, index, f"_{sense}")


def _spike(
    solution: Solution, spike: SpikeDraws, index: int | None = None, suffix: str = ""
) -> ReportedCause:
    """Return the spike at one reversal point, positive outward. ``index`` selects a direction
    (None: mean of both); ``suffix``: end of the name of the result.

    Its variance includes six unknowns. The time from the reversal to the first sample is unknown
    (lag). The rise may be that of the spike or of the instrument's limited bandwidth. A spike may
    be too small or too short to be found: a smaller one that was found does not exclude it. A spike
    may begin at the reversal or when the lost motion is passed. An inward deviation of at most the
    lost motion is probably lost motion that is taken up gradually: the value and the variance are
    those of both possibilities. A peak of irregular motion looks like a spike.
    """
    samples = solution.problem.samples
    pick = slice(None) if index is None else slice(index, index + 1)
    deviation, of_shape, inside = _peak(spike, pick)
    deepest = np.mean(spike.depths + spike.deeper if inside else -spike.heights, axis=1)
    left = solution.draws.values[:, spike.lost] - deepest
    # The other possibility is the peak on the other side, if all else is lost motion. An axis that
    # stands still is inside by its lost motion: what is missing there is a spike outward.
    missing = np.clip(left, 0.0, HIDDEN) if inside else np.zeros_like(deviation)
    other = missing + (np.mean(spike.heights[:, pick], axis=1) if inside else 0.0)
    size = _EDGE * float(np.mean(deepest))
    doubt = 2.0 * float(np.hypot(np.std(left), np.hypot(spike.least_error, size)))
    chance, equal = 1.0, abs(float(np.mean(left))) < doubt
    if inside and taken_up_over(solution, spike) is not None:
        chance = _INSIDE if equal or float(np.mean(left)) < 0.0 else 0.5
    elif equal and not inside and -float(np.mean(deepest)) > doubt:
        chance = 0.5
    of_cause = chance * (1.0 - chance) * float(np.mean((deviation - other) ** 2))
    of_cause += (1.0 - chance) * float(np.mean(missing**2)) / 3.0  # uniform up to twice as much
    heights = chance * deviation + (1.0 - chance) * other
    value = float(np.mean(heights))
    decay = np.where(spike.decay > 0.0, spike.decay, np.inf)
    response = max(_RESPONSE * samples.speed, _FILTER * sample_spacing(samples))
    late = np.hypot(samples.lag_std * samples.radius, response) / decay
    # Of a spike that is gone before the first sample, the prior alone says how high it may be.
    before = np.minimum(np.abs(heights) * late, PRIORS["_spike"])
    axis, end = spike.reversal.axis, spike.reversal.end
    found = np.mean(np.maximum(spike.heights, spike.depths), axis=1)
    absent = max(1.0 - spike.there, float(np.mean(found < spike.least_error)))
    begins = 0.0 if inside else float(np.mean(np.mean(spike.standing[:, pick], axis=1) ** 2)) / 4.0
    variance = (
        chance**2 * (of_shape + begins)
        + of_cause
        + irregular_motion(solution, axis)
        + float(np.mean(before**2)) / 3.0
        + (1.0 - spike.there) * (spike.least_error**2 - spike.hidden**2)
        + absent * spike.hidden**2
    )
    error = float(np.sqrt(np.var(heights) + variance))
    time = 1e3 / samples.speed
    sense = None if index is None else (1.0, -1.0)[index]
    likely = spike.there > 0.5
    more = {
        "decay": time * float(np.median(spike.decay)) if likely else None,
        "rise": time * float(np.median(spike.rise)) if likely else None,
        "raw_peak": raw_peak(solution, axis, end, sense, outward=value >= 0.0),
    }
    here = [float(each is spike) for each in solution.draws.spikes]
    sizes = np.outer(here, np.mean(spike.curve[pick], axis=0))
    curve = solution.problem.spike_curves(sizes[np.newaxis])[0]
    # The part of the shape that takes up lost motion gradually is no effect of the spike.
    curve = curve * min(1.0, abs(value) * UM / max(float(np.ptp(curve)), 1e-12))
    return ReportedCause(
        name=f"reversal_spike_{axis}_at_{end}{suffix}",
        value=value,
        drawn=heights,
        curve=curve,
        detail=True,
        positive=value >= 0.0,
        variance=variance,
        more=more,
        reason=_unseen_spike(value, error),
    )


def _peak(spike: SpikeDraws, pick: slice) -> tuple[FloatArray, float, bool]:
    """Return the draws (d,) of the largest deviation after a reversal, um, positive outward; the
    variance of its shape; and whether it is clearly inward. ``pick``: directions of which it is the
    mean.
    """
    heights = np.mean(spike.heights[:, pick], axis=1)
    depths = np.mean(spike.depths[:, pick], axis=1)
    slow, unseen = np.mean(spike.extrapolated[:, pick], axis=1), spike.unseen[:, pick]
    doubt = np.hypot(np.std(depths), (1.0 - spike.there) * spike.least_error)
    inside = float(np.mean(depths)) > INWARD * max(float(np.mean(heights)), float(doubt))
    inward = np.full(heights.shape, inside) | (depths > heights)
    heights, slow = np.where(inward, -depths, heights), np.where(inward, -depths, slow)
    if inside:
        unseen = 2.0 * spike.deeper[:, pick]  # uniform from the depth on, not about it
    edge = np.where(spike.rise > 0.0, _EDGE, 0.0)  # a decay without a rise has its edge
    of_shape = (
        float(np.mean((heights * edge) ** 2)) / 3.0
        + float(np.mean((slow - heights) ** 2)) / 12.0
        + float(np.mean(unseen**2)) / 12.0
    )
    return heights, of_shape, inside


def _unseen_spike(value: float, error: float) -> Sentence | None:
    return say("undetermined.spike") if error > max(_NO_SPIKE, abs(value)) else None


def _cyclic(solution: Solution, axis: str) -> Iterator[ReportedCause]:
    """Yield the amplitude of each cyclic error of an axis. If none was found, the amplitude is 0,
    and its standard error is half of the largest amplitude that the search can miss.

    The amplitude is sqrt(a² + b² - σ²), because noise makes sqrt(a² + b²) too large (Gudbjartsson
    and Patz, Magnetic Resonance in Medicine 34, 1995).
    """
    if axis not in solution.frequencies and axis in solution.hidden:
        found = 0.0, 0.5 * solution.hidden[axis]
        yield _stated(solution, f"cyclic_{axis}", say("undetermined.pitch"), found, detail=False)
    for name, wave in zip(wave_names(f"cyclic_{axis}"), solution.cyclic_waves(axis), strict=False):
        parts = [f"_cyclic_{part}_{wave}" for part in ("cos", "sin")]
        value, drawn, curve = _amplitude(solution, parts, 1)
        frequency, phase = solution.cyclic_wave(wave)
        more = {"period": 1.0 / frequency, "phase": phase}
        yield ReportedCause(
            name=name, value=value, drawn=drawn, curve=curve, positive=True, more=more
        )


def _amplitude(
    solution: Solution, parts: list[str], runs: int
) -> tuple[float, FloatArray, FloatArray]:
    """Return an amplitude over ``runs`` runs (root sum of squares of ``parts``, noise removed),
    random draws of this amplitude, and its radial deviations.
    """
    index = np.array([solution.problem.names.index(part) for part in parts])
    mean = np.mean(solution.draws.values, axis=0)[index]
    power = float(np.sum(mean**2)) / runs
    noise = float(np.sum(np.var(solution.draws.values[:, index], axis=0))) / runs
    gradient = mean / max(np.sqrt(power), 1e-12) / runs
    drawn = (solution.draws.values[:, index] - mean) @ gradient
    value = float(np.sqrt(max(power - 0.5 * noise, 0.0)))
    return value, value + drawn, solution.problem.slopes[:, index] @ mean


def _stated(
    solution: Solution,
    name: str,
    reason: Sentence,
    found: tuple[float, float] | None = None,
    *,
    detail: bool,
) -> ReportedCause:
    """Return a cause with the value and standard error ``found`` or, if None, with a ``reason``."""
    value, error = found or (0.0, 0.0)
    return ReportedCause(
        name=name,
        value=value,
        drawn=np.zeros(solution.draws.values.shape[0]),
        curve=np.zeros_like(solution.problem.samples.theta),
        detail=detail,
        positive=True,
        variance=error**2,
        reason=None if found else reason,
    )


def _symptoms(test: CircularTest, solution: Solution) -> Iterator[ReportedCause]:
    yield _vibration(test, solution)
    for axis, name in zip(AXES, test.axes, strict=True):
        reason = (
            say("undetermined.few_near_reversals", axis=name)
            if test.full_circle
            else by_full_circle(say("undetermined.few_at_reversal", axis=name))
        )
        found = stick_slip(solution, axis)
        yield _stated(solution, f"stick_slip_{axis}", reason, found, detail=False)
    for order in (2, 3):
        found = lobes(test, solution, order) if test.full_circle else None
        reason = by_full_circle(say("undetermined.lobes"))
        yield _stated(solution, f"lobes_{order}", reason, found, detail=True)
    whole = test.full_circle and test.calibrated
    found = positional_tolerance(solution) if whole else None
    reason = (
        say("undetermined.bar") if test.full_circle else by_full_circle(say("undetermined.square"))
    )
    yield _stated(solution, "positional_tolerance", reason, found, detail=True)


def _faded(found: Vibration) -> float:
    """Return the standard error of a vibration, as a share of its amplitude, because the instrument
    may be slow. The slowest first-order filter suppresses twice as much.
    """
    slow = 2.0 * np.pi * (found.frequency or 0.0) * max(_RESPONSE, _FILTER * found.step)
    return float(0.5 * (np.hypot(1.0, slow) - 1.0))


def _vibration(test: CircularTest, solution: Solution) -> ReportedCause:
    """Return the amplitude of the vibration. If none was found, the amplitude is 0, and its
    standard error is half of the largest amplitude that the search can miss.
    """
    samples, found = solution.problem.samples, solution.vibration
    names = dict(zip(AXES, test.axes, strict=True))
    value, drawn, variance = 0.0, np.zeros(solution.draws.values.shape[0]), 0.0
    if found.frequency is None:
        variance = (0.5 * max(found.hidden.values(), default=0.0)) ** 2
    elif found.amplitude is None:
        parts = [name for name in solution.problem.names if name.startswith("_vibration")]
        value, drawn, _ = _amplitude(solution, parts, np.unique(samples.run).size)
    else:
        value, variance = found.amplitude, found.std_error**2
    span = samples.arc[1] * samples.radius / samples.speed
    faded = (_faded(found) * value) ** 2
    # Over time a vibration has every phase at every angle.
    wave = 1e-3 * value * np.cos(2.4 * np.arange(samples.theta.size))
    return ReportedCause(
        name="vibration",
        value=value,
        drawn=drawn,
        curve=wave * radial_share(samples, found.axis),
        positive=True,
        variance=variance + faded,
        upwards=faded,
        more={"frequency": found.frequency}
        | {f"hidden_{axis or 'bar'}": size for axis, size in found.hidden.items()},
        reason=None if found.hidden else say("undetermined.few_in_time", time=span),
        axis=names.get(found.axis or ""),
    )
