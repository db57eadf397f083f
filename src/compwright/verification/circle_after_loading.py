"""Check whether a circular test after loading is credible beside the first test and the prediction.

The causes of its deviations are compared by their effect on the circle. A change counts if it is
clear of the errors of both fits, and larger than what another day and set-up change (`_believed`).
Noise is compared by itself, as of an axis; the circular deviations are compared without it. Smaller
deviations than predicted are no fault.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.evaluation.circular import without_noise
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.circular import CircularEffect, CircularResult
from compwright.records.correction_need import NEGLIGIBLE
from compwright.records.prediction import CirclePrediction, Quantiles
from compwright.verification.circle_loading import ShownValue
from compwright.verification.measurement_faults import BELIEVED, IMPROBABLE, scatter_findings
from compwright.words.sentences import Amount, Sentence, say

#: A circular deviation of both runs, else that of one run.
DEVIATIONS: Final = ("G_bidirectional", "G_ccw", "G_cw")
#: Causes that change their sign with the direction of motion.
_ODD: Final = ("backlash_first", "backlash_second", "servo_mismatch")
#: Causes that a repetition shows again. The others depend on which shapes the fit finds.
_LASTING: Final = ("squareness", "scale_mismatch", *_ODD)
#: The scale of one axis. The temperature changes it from day to day (`_other_temperature`).
_SCALES: Final = ("scale_error_first", "scale_error_second")
#: What a scale error changes in addition.
OF_SCALES: Final = (*_SCALES, "scale_mismatch", *DEVIATIONS)
#: Coverage factor of what two tests leave uncertain.
_COVERAGE: Final = 2.0
#: From the median to the upper end of a 90 % interval, in standard deviations.
_NINETY: Final = 1.645
_UNITS: Final = {"um": ("µm", ".2f"), "um/m": ("µm/m", ".1f"), "ms": ("ms", ".3f")}


@dataclass(frozen=True, slots=True)
class _UnexpectedCause:
    """A cause after loading (``now``) that is clearly not as ``predicted``; ``size``: µm of the
    circle.
    """

    name: str
    now: float
    predicted: Quantiles
    unit: str
    size: float


def noise_findings(before: CircularResult, after: CircularResult) -> Iterable[Finding]:
    """Return the finding CW-V021 if the scatter of the test ``after`` loading about its fitted path
    is implausibly small or large compared with that of the test ``before``, as of an axis.
    """
    scatters = _scatter(after), _scatter(before)
    return scatter_findings(*scatters, _step(before), _micrometres, before.test.name)


def _micrometres(length: float) -> Amount:
    return Amount(length * MICROMETRES_PER_MILLIMETRE, "µm")


def _scatter(result: CircularResult) -> tuple[float, float]:
    """Return the rms distance (mm) of the readings of a circular test from the fitted path, and its
    degrees of freedom.
    """
    diagnosis = result.diagnosis
    if diagnosis is None or not diagnosis.fitted:
        return 0.0, 0.0
    runs = {(run.sense, run.number): run for run in result.test.runs}
    distances = []
    for fit in diagnosis.fitted:
        run, order = runs[fit.sense, fit.number], np.argsort(fit.angles)
        path = np.interp(run.angles, fit.angles[order], fit.deviations[order])
        distances.append(run.deviations - path)
    # Of a long run only a part of the readings is fitted, and only these are counted.
    count = sum(fit.residuals.size for fit in diagnosis.fitted)
    rms = float(np.sqrt(np.mean(np.concatenate(distances) ** 2)))
    return rms, count / max(diagnosis.correlation_length, 1.0)


def _step(result: CircularResult) -> float:
    """Return the smallest difference (mm) between two readings of a circular test."""
    readings = np.unique(np.concatenate([run.deviations for run in result.test.runs]).round(9))
    return float(np.min(np.diff(readings), initial=np.inf)) if readings.size > 1 else 0.0


def turned_findings(
    prediction: CirclePrediction, after: CircularResult, part: float
) -> Iterator[Finding]:
    """Yield the finding CW-V026 if every clear lost motion and servo mismatch has the opposite sign
    ``after`` loading, lost motion of one axis at least. No table does this, a turned file does; a
    servo mismatch alone may be the tuning of the loops. ``part``: see `unexpected_findings`.
    """
    changes = {change.name: change for change in _changes(prediction, after, part)}
    clear = {
        name: effect.value
        for name, effect in _effects(prediction.expected).items()
        if name in _ODD and abs(effect.value) > IMPROBABLE * effect.std_error
        if effect.effect > _believed(prediction, after, part)
    }
    turned = [changes[name] for name in clear if name in changes]
    lost_motion = any(each.name != "servo_mismatch" for each in turned)
    if (
        len(turned) == len(clear)
        and lost_motion
        and all(abs(each.now + clear[each.name]) < abs(clear[each.name]) for each in turned)
    ):
        yield Finding.of("CW-V026.turned", "warning", what=_sentences(turned, after))


def unexpected_findings(
    prediction: CirclePrediction, after: CircularResult, part: float, judged: Collection[str]
) -> Iterator[Finding]:
    """Yield the finding CW-V036 if the circular deviation ``after`` loading is larger than the
    prediction allows, or if a cause is not as predicted.

    A value counts if its distance from the median occurs in less than one of 1000 repetitions, and
    if the circle without noise grows by more than another day and set-up explain, the ``part`` of
    the predicted circular deviation at least. Left out are values that are ``judged`` elsewhere.
    """
    what = []
    name = _deviation(prediction)
    value = after.parameters.get(name)
    if value is not None and name not in judged:
        band = prediction.predicted[name]
        reach = IMPROBABLE / _NINETY * (band.p95 - band.median)
        was, now = (without_noise(each, name) for each in (prediction.expected, after))
        grown = value - band.median if was is None or now is None else now - was
        least = _believed(prediction, after, part) / MICROMETRES_PER_MILLIMETRE
        if value - band.median > reach and grown > least:
            what.append(_parameter(name, value, band))
    changes = [each for each in _changes(prediction, after, part) if each.name not in judged]
    if what or changes:
        what += _radial(prediction, after, _believed(prediction, after, part))
        yield Finding.of("CW-V036", "warning", what=[*what, *_sentences(changes, after)])


def _parameter(name: str, value: float, band: Quantiles) -> Sentence:
    shown, low, high = map(_micrometres, (value, band.p05, band.p95))
    of = say("as_written", text=name.replace("_", " "))
    return say("CW-V036.value", name=of, value=shown, low=low, high=high)


def _radial(
    prediction: CirclePrediction, after: CircularResult, least: float
) -> Iterator[Sentence]:
    """Yield the radial deviations (F) that are larger than predicted and the mean one (D) if it is
    another one, by the rule of `unexpected_findings`. ``least``: the change (µm) that is believed.
    """
    for name, band in prediction.predicted.items():
        value, own = after.parameters.get(name), name.removesuffix("_lsc")
        # About the standard's centre, else about that of least squares.
        if name[0] not in "FD" or value is None or (own != name and own in prediction.predicted):
            continue
        off = value - band.median
        end = band.p95 if off > 0.0 else band.p05
        reach = max(
            IMPROBABLE / _NINETY * abs(end - band.median), least / MICROMETRES_PER_MILLIMETRE
        )
        better = ("max" in name and off < 0.0) or ("min" in name and off > 0.0)
        if abs(off) > reach and not better:
            yield _parameter(name, value, band)


def _effects(result: CircularResult) -> dict[str, CircularEffect]:
    diagnosis = result.diagnosis
    if diagnosis is None:
        return {}
    return {
        name: effect
        for name, effect in diagnosis.effects.items()
        if name in (*_LASTING, *_SCALES) and name not in diagnosis.undetermined
    }


def _deviation(prediction: CirclePrediction) -> str:
    """Return the name of the predicted circular deviation; an empty text if there is none."""
    return next((each for each in DEVIATIONS if each in prediction.predicted), "")


def _believed(prediction: CirclePrediction, after: CircularResult, part: float) -> float:
    """Return the change of the circle (µm) that is believed of another day and set-up; infinite
    without a predicted circular deviation.

    It is the largest of three: the ``part`` of this deviation; `BELIEVED` times the scatter of
    both tests, as between the files of an axis; the declared uncertainty (instrument, set-up and
    environment).
    """
    name = _deviation(prediction)
    if not name:
        return float(np.inf)
    first = prediction.before
    declared = first.uncertainty[name].U if first.uncertainty else 0.0
    least = part * prediction.predicted[name].median
    (s, dof), (s_first, dof_first) = _scatter(after), _scatter(first)
    pooled = np.sqrt((dof * s**2 + dof_first * s_first**2) / max(dof + dof_first, 1.0))
    return float(max(least, BELIEVED * pooled, declared)) * MICROMETRES_PER_MILLIMETRE


def _changes(
    prediction: CirclePrediction, after: CircularResult, part: float
) -> list[_UnexpectedCause]:
    """Return the causes that are clearly not as predicted, the largest change first."""
    least, found = _believed(prediction, after, part), []
    first, now = _effects(prediction.before), _effects(after)
    for name, was in _effects(prediction.expected).items():
        each = now.get(name, was)
        if name in _ODD and each.value * was.value >= 0.0 and abs(each.value) <= abs(was.value):
            continue  # better than predicted
        off = abs(each.value - was.value)
        error = float(np.hypot(was.std_error, each.std_error))
        planned = first.get(name, was).value - was.value
        if name in _SCALES and _other_temperature(off + _COVERAGE * error, planned):
            continue
        size = _size(max(was, each, key=lambda one: abs(one.value)), off)
        if off > IMPROBABLE * error and size > least:
            found.append(
                _UnexpectedCause(name, each.value, prediction.causes[name], each.unit, size)
            )
    return sorted(found, key=lambda change: -change.size)


def _size(effect: CircularEffect, off: float) -> float:
    """Return by how much the circle changes, µm, if this cause changes by ``off``."""
    return off * effect.effect / abs(effect.value) if effect.value else 0.0


def shown_scales(
    prediction: CirclePrediction, after: CircularResult, part: float
) -> Iterator[tuple[str, ShownValue, bool]]:
    """Yield the axes of which a circular test ``after`` loading would show it if half of the
    planned change of scale were missing, each with its scale error, and whether this is as
    predicted. ``part``, and the rule for the latter: see `unexpected_findings`.
    """
    least = _believed(prediction, after, part)
    changed = {each.name for each in _changes(prediction, after, part)}
    first, now = _effects(prediction.before), _effects(after)
    for axis, name in zip(after.test.axes, _SCALES, strict=True):
        was = _effects(prediction.expected).get(name)
        if was is None or name not in first or name not in now:
            continue
        planned = first[name].value - was.value
        off = 0.5 * abs(planned)
        error = float(np.hypot(was.std_error, now[name].std_error))
        clear = off > IMPROBABLE * error and _size(first[name], off) > least
        shown = clear and abs(planned) >= NEGLIGIBLE
        if shown or name in changed:
            value = ShownValue(now[name].value, was.value, first[name].value, error)
            yield axis, value, name not in changed


def _other_temperature(off: float, planned: float) -> bool:
    """Return whether a scale error that is ``off`` by so many µm/m may be left to another
    temperature: less than half of the ``planned`` change, and it would not be corrected; or the
    change itself would not.
    """
    return abs(planned) < NEGLIGIBLE or off < min(NEGLIGIBLE, 0.5 * abs(planned))


def _sentences(changes: list[_UnexpectedCause], after: CircularResult) -> list[Sentence]:
    first, second = after.test.axes
    sentences = []
    for change in changes:
        unit, form = _UNITS[change.unit]
        kind = change.name.removesuffix("_first").removesuffix("_second")
        axis = second if change.name.endswith("_second") else first
        value, low, high = (
            Amount(each, unit, form)
            for each in (change.now, change.predicted.p05, change.predicted.p95)
        )
        name = say("cause.kind", kind=kind, first=first, second=second, axis=axis)
        sentences.append(say("CW-V036.value", name=name, value=value, low=low, high=high))
    return sentences
