"""Findings of the diagnosis of a circular test: what it cannot tell apart, and what was found."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np

from compwright.estimation.circle_model import AXES, SOFTEST_LOOP
from compwright.estimation.circle_solution import Solution
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularEffect, CircularTest

#: A standard error so many times that of the cause alone is worth a word when the test is not a
#: full circle both ways.
_INFLATED: Final = 2.5
#: Standard errors beyond which a deviation is reported.
_CLEAR: Final = 3.0


def findings_of(
    test: CircularTest,
    solution: Solution,
    effects: Mapping[str, CircularEffect],
    correlation: FloatArray,
) -> tuple[Finding, ...]:
    """Return the findings about effects and their ``correlation`` (in the order of the effects)."""
    return (
        *_separation(test, solution, effects, correlation),
        *_scale_findings(test, solution, effects),
        *_shape_findings(test, solution),
    )


def _separation(
    test: CircularTest,
    solution: Solution,
    effects: Mapping[str, CircularEffect],
    correlation: FloatArray,
) -> Iterator[Finding]:
    """Report which causes the test cannot tell apart: one direction, an arc, a missing reversal
    point.
    """
    samples, names = solution.problem.samples, solution.problem.names
    order, poor = list(effects), []
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
            poor.append(f"{name} (x {factor:.0f}, with {other})")
    listed = ", ".join(poor) or "none"
    tail = f"standard errors that this multiplies: {listed}"
    if not samples.both_senses:
        message = (
            "one direction only: what depends on the direction cannot be separated from what"
            f" does not; {tail}"
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


def _scale_findings(
    test: CircularTest, solution: Solution, effects: Mapping[str, CircularEffect]
) -> Iterator[Finding]:
    if not test.calibrated:
        message = (
            "the length of the bar was not calibrated: the scale of single axes is not given, only"
            " their mismatch"
        )
        yield Finding("CW-D003", "info", message)
        return
    samples = solution.problem.samples
    most = samples.speed**2 / (2.0 * SOFTEST_LOOP**2 * samples.radius) * MICROMETRES_PER_MILLIMETRE
    doubt = most / np.sqrt(3.0) / samples.radius * MICROMETRES_PER_MILLIMETRE
    if doubt > 0.5 * effects["scale_error_first"].std_error:
        message = (
            f"at {test.feed:g} mm/min a soft position loop makes the circle up to {most:.1f} µm"
            f" smaller: the scale of single axes is uncertain by {doubt:.0f} µm/m for that; a"
            " second test at a low feed settles it"
        )
        yield Finding("CW-D004", "warning", message)


def _shape_findings(test: CircularTest, solution: Solution) -> Iterator[Finding]:
    for axis, name in zip(AXES, test.axes, strict=True):
        if axis in solution.frequencies and axis not in solution.given:
            pitch = 1.0 / solution.frequencies[axis]
            yield Finding(
                "CW-D006",
                "info",
                f"a cyclic error of {name} was found at a pitch of {pitch:.4g} mm",
            )
        elif axis in solution.hidden and axis not in solution.frequencies:
            message = (
                f"no cyclic error of {name} was found; one of less than"
                f" {significant(solution.hidden[axis])} µm may be hidden"
            )
            yield Finding("CW-D007", "info", message)
        inward = [
            depth
            for spike in solution.draws.spikes
            if spike.reversal.axis == axis
            and (depth := float(np.mean(spike.depths)))
            > _CLEAR * float(np.hypot(np.std(np.mean(spike.depths, axis=1)), spike.least_error))
        ]
        if inward:
            message = (
                f"{name} is up to {significant(max(inward))} µm inside after its reversals: its"
                " backlash compensation may be too strong"
            )
            yield Finding("CW-D008", "warning", message)
    length = float(np.mean([spectrum.length for spectrum in solution.fitted.spectra]))
    samples = solution.problem.samples
    if length > 0.1 * samples.theta.size / np.unique(samples.run).size:
        rms = float(np.sqrt(np.mean(solution.residual**2))) * MICROMETRES_PER_MILLIMETRE
        message = (
            f"{significant(rms)} µm of deviation has a shape that no cause explains; the standard"
            " errors allow for it"
        )
        yield Finding("CW-D010", "info", message)
