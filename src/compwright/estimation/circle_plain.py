"""Simple formulas for a circular test, beside the full model: the plain regression of other
software, and four points.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from compwright.estimation.circle_centre import recentre, second_order
from compwright.estimation.circle_model import AXES, Samples, samples_of
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularTest

#: The formulas read the trace so far beside the reversal points (rad), where spikes have died away.
_BESIDE: Final = np.radians(5.0)


def plain_regression(samples: Samples) -> dict[str, float]:
    """Return the causes, in the contract's units, by harmonics and reversal terms, unweighted,
    after recentring.

    On a full circle in both directions: squareness, scale mismatch, servo mismatch, radius change,
    and for each axis lost motion (mean and both ends), lateral play and straightness. On an arc
    lateral play, straightness and the two ends are left out, with one direction everything that
    needs two.
    """
    names, rows = _plain_rows(samples)
    x, y, _ = recentre(samples.theta, samples.deviations, samples.radius)
    values = samples.deviations - second_order(samples.theta, (x, y), samples.radius)
    solved, *_ = np.linalg.lstsq(
        rows.T @ rows, rows.T @ values * MICROMETRES_PER_MILLIMETRE, rcond=None
    )
    found = {
        name: float(value)
        for name, value in zip(names, solved, strict=True)
        if not name.startswith("_")
    }
    for axis in AXES:
        ends = [
            found[key]
            for key in (f"backlash_{axis}_at_positive", f"backlash_{axis}_at_negative")
            if key in found
        ]
        if ends:
            found[f"backlash_{axis}"] = sum(ends) / len(ends)
    return found


def _plain_rows(samples: Samples) -> tuple[list[str], FloatArray]:
    cos, sin, d = np.cos(samples.theta), np.sin(samples.theta), samples.sense
    rows = {
        "_radius": np.ones_like(cos),
        "_centre_x": cos,
        "_centre_y": sin,
        "scale_mismatch": 0.25 * np.cos(2.0 * samples.theta),
        "squareness": -0.5e-3 * samples.radius * np.sin(2.0 * samples.theta),
    }
    if samples.both_senses:
        rows["servo_mismatch"] = 0.5 * samples.speed * d * np.sin(2.0 * samples.theta)
        rows["radius_change"] = d
        whole = all(all(samples.reversals(axis)) for axis in AXES)
        first, second = 0.5 * d * np.sign(sin) * cos, -0.5 * d * np.sign(cos) * sin
        for axis, lost, along, play in (
            ("first", first, cos, -0.5 * d * np.abs(sin)),
            ("second", second, sin, 0.5 * d * np.abs(cos)),
        ):
            if whole:
                rows[f"backlash_{axis}_at_positive"], rows[f"backlash_{axis}_at_negative"] = (
                    lost * (along > 0),
                    lost * (along < 0),
                )
                rows[f"lateral_play_{axis}"], rows[f"_lateral_change_{axis}"] = play, play * along
                rows[f"straightness_{axis}"] = along**2 * (sin if axis == "first" else cos)
            elif any(samples.reversals(axis)):
                rows[f"backlash_{axis}"] = lost
    return list(rows), np.column_stack(list(rows.values()))


def shop_formulas(test: CircularTest) -> Mapping[str, float]:
    """Return squareness (um/m) and scale mismatch (um) of a full circle by four points, mean of the
    runs, as shops do.

    squareness = -(r45 + r225 - r135 - r315) / 2R; mismatch = (r0 + r180) - (r90 + r270), each read
    5° beside the reversal point, on the side before it is reached (MTS and similar). In one
    direction alone unequal lost motion of the axes goes into the squareness: shown for comparison,
    not used. Raises UsageError for an arc.
    """
    if not test.full_circle:
        raise UsageError(
            Fault(
                message="the four-point formulas need a full circle",
                file=test.name,
                found=f"{test.arc[1]:g} deg",
            )
        )
    samples = samples_of(test)
    found: dict[str, list[float]] = {"squareness": [], "scale_mismatch": []}
    for number in np.unique(samples.run):
        mine = samples.run == number
        theta, deviations = samples.theta[mine], samples.deviations[mine]
        x, y, _ = recentre(theta, deviations, samples.radius)
        centred = (
            deviations
            - second_order(theta, (x, y), samples.radius)
            - x * np.cos(theta)
            - y * np.sin(theta)
        )
        before = -_BESIDE * samples.sense[mine][0]
        diagonal = _read(theta, centred, np.radians([45.0, 225.0, 135.0, 315.0]))
        axial = _read(theta, centred, np.radians([0.0, 180.0, 90.0, 270.0]) + before)
        signs = np.array([1.0, 1.0, -1.0, -1.0])
        found["squareness"].append(float(-1e6 * (signs @ diagonal) / (2.0 * samples.radius)))
        found["scale_mismatch"].append(float(MICROMETRES_PER_MILLIMETRE * (signs @ axial)))
    return {name: float(np.mean(values)) for name, values in found.items()}


def _read(theta: FloatArray, values: FloatArray, where: FloatArray) -> FloatArray:
    """Return the trace at angles ``where``, between samples by a straight line around the
    circle.
    """
    turn = 2.0 * np.pi
    order = np.argsort(np.mod(theta, turn))
    return np.interp(np.mod(where, turn), np.mod(theta, turn)[order], values[order], period=turn)
