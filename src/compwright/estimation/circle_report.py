"""From the fit of a circular test to causes in the contract's names and units, and what is to be
said about them. Standard errors follow the law of propagation, gradient' covariance gradient (JCGM
100:2008, eq. 13).
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.circle_cyclic import Search
from compwright.estimation.circle_fit import Fit
from compwright.estimation.circle_model import AXES, SOFTEST_LOOP, UM, Samples
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularEffect, CircularTest

UNITS: Final = {
    "squareness": "um/m",
    "scale_error_first": "um/m",
    "scale_error_second": "um/m",
    "servo_mismatch": "ms",
}
_ONE_SIDED: Final = 1.645  # standard errors to the lower end of a one-sided 95 % interval
#: A standard error so many times that of the cause alone is worth a word when the test is not a
#: full circle both ways.
_INFLATED: Final = 2.5


@dataclass(frozen=True, slots=True)
class _ReportedCause:
    """One reported value: ``gradient`` (k,) by the fit's columns, ``curve`` (n,) its radial
    deviation, mm.
    """

    name: str
    value: float
    gradient: FloatArray
    curve: FloatArray
    detail: bool = False
    positive: bool = False
    variance: float = 0.0  # beyond what the fit says


def effects_of(
    test: CircularTest, samples: Samples, fitted: Fit, found: Search, undetermined: Container[str]
) -> tuple[dict[str, CircularEffect], FloatArray, tuple[Finding, ...]]:
    """Return effects by name, their correlation in that order, and findings.

    The effects of details (each end of a lost motion, scale errors beside the mismatch) are parts
    of causes that count already: shares are over the sum of the causes, each counted once; causes
    that are ``undetermined`` have no share. Standard
    errors and correlation by JCGM 100:2008, eq. 13 and 14; ``low`` is the lower end of a one-sided
    95 % interval.
    """
    causes = tuple(_causes(test, samples, fitted, found))
    gradients = np.array([cause.gradient for cause in causes])
    covariance = gradients @ fitted.covariance @ gradients.T + np.diag(
        [cause.variance for cause in causes]
    )
    shrink = shrink_doubt(samples) / samples.radius * 1e6
    scales = np.array([1.0 if cause.name.startswith("scale_error") else 0.0 for cause in causes])
    covariance += shrink**2 * np.outer(scales, scales)
    errors = np.sqrt(np.diag(covariance))
    ranges = (
        _ranges(samples, np.array([cause.curve for cause in causes])) * MICROMETRES_PER_MILLIMETRE
    )
    counted = [not cause.detail and cause.name not in undetermined for cause in causes]
    total = float(np.sum(ranges[counted]))
    effects = {
        cause.name: CircularEffect(
            value=cause.value,
            std_error=float(error),
            unit=UNITS.get(cause.name, "um"),
            effect=float(size),
            share=float(size / total) if total > 0.0 and cause.name not in undetermined else 0.0,
            low=max(0.0, cause.value - _ONE_SIDED * float(error)) if cause.positive else None,
        )
        for cause, error, size in zip(causes, errors, ranges, strict=True)
    }
    correlation = covariance / np.outer(errors, errors)
    findings = (
        *_separation(test, samples, fitted, causes, correlation),
        *_scale_findings(test, samples, effects),
        *_shape_findings(test, samples, fitted, found, effects),
    )
    return effects, correlation, findings


def shrink_doubt(samples: Samples) -> float:
    """Return the standard uncertainty, mm, of the radius by an equal lag of both axes: uniform up
    to the softest loop's v² / (2 Kv² R) (the circle shrinks with the acceleration: ISO 230-4:1996,
    B.3.2), taken as a of the range ±a: a / sqrt(3) (JCGM 100:2008, eq. 7).
    """
    most = samples.speed**2 / (2.0 * SOFTEST_LOOP**2 * samples.radius)
    return float(most / np.sqrt(3.0))


def _ranges(samples: Samples, curves: FloatArray) -> FloatArray:
    """Return the peak-to-peak values of radial deviations (c, n) over both runs with their
    least-squares circles removed.
    """
    rows = np.column_stack(
        [np.cos(samples.theta), np.sin(samples.theta), np.ones_like(samples.theta)]
    )
    solved = np.linalg.solve(rows.T @ rows, rows.T @ curves.T)
    spread: FloatArray = np.ptp(curves - (rows @ solved).T, axis=1)
    return spread


def _causes(
    test: CircularTest, samples: Samples, fitted: Fit, found: Search
) -> Iterator[_ReportedCause]:
    cos, sin = np.cos(samples.theta), np.sin(samples.theta)
    radial = fitted.x * cos[:, np.newaxis] + fitted.y * sin[:, np.newaxis]

    def combined(name: str, parts: dict[str, float], *, detail: bool = False) -> _ReportedCause:
        """Return the weighted sum of columns; its curve is what those columns do together."""
        gradient = np.zeros(len(fitted.names))
        curve = np.zeros_like(samples.theta)
        for part, weight in parts.items():
            index = fitted.names.index(part)
            gradient[index] = weight
            curve += radial[:, index] * fitted.values[index]
        return _ReportedCause(name, float(gradient @ fitted.values), gradient, curve, detail=detail)

    yield combined("squareness", {"squareness": 1.0})
    yield combined("scale_mismatch", {"scale_mismatch": 1.0})
    if test.calibrated:
        yield from _scale_errors(samples, fitted)
    for axis in AXES:
        ends = [f"backlash_{axis}_at_positive", f"backlash_{axis}_at_negative"]
        if ends[0] in fitted.names:
            yield combined(f"backlash_{axis}", dict.fromkeys(ends, 0.5))
            for end in ends:
                yield combined(end, {end: 1.0}, detail=True)
        else:
            yield combined(f"backlash_{axis}", {f"backlash_{axis}": 1.0})
    yield combined("servo_mismatch", {"servo_mismatch": 1.0})
    for axis in AXES:
        yield combined(f"lateral_play_{axis}", {f"lateral_play_{axis}": 1.0})
        if axis in fitted.shapes.lengths:
            yield _spike(combined(f"reversal_spike_{axis}", {f"reversal_spike_{axis}": 1.0}))
        yield from _cyclic(samples, fitted, found, axis, radial)
        yield combined(f"straightness_{axis}", {f"straightness_{axis}": 1.0})
    if samples.both_senses:
        yield combined("radius_change", {"radius_change": 1.0})


def _scale_errors(samples: Samples, fitted: Fit) -> Iterator[_ReportedCause]:
    """Yield e_x and e_y, um/m: the mean radius deviation over R plus and minus a quarter of the
    mismatch over R.
    """
    for axis, sign, shape in (
        ("first", 1.0, np.cos(samples.theta) ** 2),
        ("second", -1.0, np.sin(samples.theta) ** 2),
    ):
        gradient = np.zeros(len(fitted.names))
        gradient[fitted.names.index("_radius")] = 1e6 / samples.radius
        gradient[fitted.names.index("scale_mismatch")] = sign * 0.25 * UM * 1e6 / samples.radius
        value = float(gradient @ fitted.values)
        yield _ReportedCause(
            f"scale_error_{axis}",
            value,
            gradient,
            1e-6 * value * samples.radius * shape,
            detail=True,
        )


def _spike(cause: _ReportedCause) -> _ReportedCause:
    """Return a spike with its height not below zero."""
    inward = cause.value < 0.0
    curve = np.zeros_like(cause.curve) if inward else cause.curve
    return _ReportedCause(cause.name, max(cause.value, 0.0), cause.gradient, curve, positive=True)


def _cyclic(
    samples: Samples, fitted: Fit, found: Search, axis: str, radial: FloatArray
) -> Iterator[_ReportedCause]:
    """Yield the amplitude of a cyclic error, sqrt(a² + b² - σ²), because the root of two squares is
    too large by the noise in them (Gudbjartsson and Patz, Magnetic Resonance in Medicine 34, 1995);
    where none was found 0 ± half of what may be hidden.
    """
    gradient = np.zeros(len(fitted.names))
    if axis not in fitted.shapes.frequencies:
        if axis in found.hidden:
            hidden = 0.5 * found.hidden[axis]
            yield _ReportedCause(
                f"cyclic_{axis}",
                0.0,
                gradient,
                np.zeros_like(samples.theta),
                positive=True,
                variance=hidden**2,
            )
        return
    pair = [fitted.names.index(f"_cyclic_{part}_{axis}") for part in ("cos", "sin")]
    values = fitted.values[pair]
    amplitude = float(np.hypot(*values))
    gradient[pair] = values / max(amplitude, 1e-12)
    variance = np.diag(fitted.covariance)[pair]
    fair = float(np.sqrt(max(amplitude**2 - float(np.mean(variance)), 0.0)))
    yield _ReportedCause(f"cyclic_{axis}", fair, gradient, radial[:, pair] @ values, positive=True)


def _separation(
    test: CircularTest,
    samples: Samples,
    fitted: Fit,
    causes: tuple[_ReportedCause, ...],
    correlation: FloatArray,
) -> Iterator[Finding]:
    """Say which causes the test cannot tell apart: one direction, an arc, a missing reversal
    point.
    """
    condition = _condition(fitted)
    poor = []
    for index, cause in enumerate(causes):
        own = np.flatnonzero(cause.gradient)
        if cause.detail or own.size != 1:
            continue
        factor = float(np.sqrt(fitted.covariance[own[0], own[0]] * fitted.information[own[0]]))
        if factor > _INFLATED:
            others = np.abs(correlation[index]) * np.array(
                [not other.detail and other is not cause for other in causes]
            )
            poor.append(
                f"{cause.name} (x {factor:.0f}, with {causes[int(np.argmax(others))].name})"
            )
    listed = ", ".join(poor) or "none"
    tail = f"standard errors that this multiplies: {listed}; condition {condition:.0f}"
    if not samples.both_senses:
        message = (
            "one direction only: what depends on the direction cannot be separated from what"
            " does not;"
            f" {tail}"
        )
        yield Finding("CW-D001", "warning", message)
    if not test.full_circle:
        yield Finding(
            "CW-D002",
            "warning",
            f"an arc of {test.arc[1]:g}° tells the causes apart less well than a circle; {tail}",
        )
    for axis, name in zip(AXES, test.axes, strict=True):
        ends = samples.reversals(axis)
        if not any(ends):
            message = (
                f"the arc holds no reversal point of {name}: its lost motion, lateral play and"
                " reversal spike are not determined"
            )
            yield Finding("CW-D005", "warning", message)
        elif not all(ends):
            end = "positive" if ends[0] else "negative"
            message = (
                f"the arc holds one reversal point of {name} only: its lost motion is that at the"
                f" {end} end"
            )
            yield Finding("CW-D005", "info", message)


def _condition(fitted: Fit) -> float:
    """Return the condition of the fit: of the correlation matrix of its linear columns, as a ratio
    of lengths (Belsley, Kuh and Welsch, Regression Diagnostics, 1980, chapter 3).
    """
    linear = [
        index
        for index, name in enumerate(fitted.names)
        if not name.startswith(("_length_", "_frequency_"))
    ]
    errors = np.sqrt(np.diag(fitted.covariance)[linear])
    values = np.linalg.eigvalsh(
        fitted.covariance[np.ix_(linear, linear)] / np.outer(errors, errors)
    )
    return float(np.sqrt(values[-1] / max(values[0], 1e-16)))


def _scale_findings(
    test: CircularTest, samples: Samples, effects: dict[str, CircularEffect]
) -> Iterator[Finding]:
    if not test.calibrated:
        message = (
            "the length of the bar was not calibrated: the scale of single axes is not given, only"
            " their mismatch"
        )
        yield Finding("CW-D003", "info", message)
        return
    doubt = shrink_doubt(samples) / samples.radius * 1e6
    if doubt > 0.5 * effects["scale_error_first"].std_error:
        most = (
            samples.speed**2 / (2.0 * SOFTEST_LOOP**2 * samples.radius) * MICROMETRES_PER_MILLIMETRE
        )
        message = (
            f"at {test.feed:g} mm/min a soft position loop makes the circle up to {most:.1f} µm"
            f" smaller: the scale of single axes is uncertain by {doubt:.0f} µm/m for that; a"
            " second test at a low feed settles it"
        )
        yield Finding("CW-D004", "warning", message)


def _shape_findings(
    test: CircularTest,
    samples: Samples,
    fitted: Fit,
    found: Search,
    effects: dict[str, CircularEffect],
) -> Iterator[Finding]:
    for axis, name in zip(AXES, test.axes, strict=True):
        if axis in fitted.shapes.frequencies and axis not in fitted.shapes.given:
            pitch = 1.0 / fitted.shapes.frequencies[axis]
            yield Finding(
                "CW-D006",
                "info",
                f"a cyclic error of {name} was found at a pitch of {pitch:.4g} mm",
            )
        elif axis in found.hidden and axis not in fitted.shapes.frequencies:
            message = (
                f"no cyclic error of {name} was found; one of less than"
                f" {significant(found.hidden[axis])} µm may be hidden"
            )
            yield Finding("CW-D007", "info", message)
        key = f"reversal_spike_{axis}"
        if key in effects:
            height, error = fitted.value(key), effects[key].std_error
            if height < -3.0 * error:
                message = (
                    f"{name} is {significant(-height)} µm inside after its reversals: its backlash"
                    " compensation may be too strong"
                )
                yield Finding("CW-D008", "warning", message)
    length = float(np.mean([spectrum.length for spectrum in fitted.spectra]))
    if length > 0.1 * samples.theta.size / np.unique(samples.run).size:
        rms = float(np.sqrt(np.mean(fitted.residual**2))) * MICROMETRES_PER_MILLIMETRE
        message = (
            f"{significant(rms)} µm of deviation has a shape that no cause explains; the standard"
            " errors allow for it"
        )
        yield Finding("CW-D010", "info", message)
