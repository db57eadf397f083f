"""A simple regression of a circular test, as other software does it, for comparison with the full
model.

It fits harmonics and reversal terms of ISO 230-4:1996, annex B, with the ball at the centre, by
ordinary least squares.
"""

from __future__ import annotations

import numpy as np

from compwright.estimation.circle_centre import recentre, second_order
from compwright.estimation.circle_model import AXES, CircleSamples
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray


def harmonic_regression(samples: CircleSamples) -> dict[str, float]:
    """Return the causes of circular deviations, in units of the JSON output, from a simple
    regression of harmonics and reversal terms.

    A full circle in both directions gives squareness, scale mismatch, servo mismatch and radius
    change. For each axis it gives lost motion and lateral play (mean, both ends) and straightness.
    On an arc, lateral play, straightness and the lost motion at each end are left out. With one
    direction, all causes that need two directions are left out. The formulas are in the table of
    ``circle_model`` (ISO 230-4:1996, annex B).
    """
    names, rows = _plain_rows(samples)
    x, y, _ = recentre(samples.theta, samples.deviations, samples.radius)
    values = samples.deviations - second_order(samples.theta, (x, y), samples.radius)
    solved, *_ = np.linalg.lstsq(
        rows.T @ rows, rows.T @ values * MICROMETRES_PER_MILLIMETRE, rcond=None
    )
    solution = {name: float(value) for name, value in zip(names, solved, strict=True)}
    found = {name: value for name, value in solution.items() if not name.startswith("_")}
    for axis in AXES:
        ends = [
            found[key]
            for key in (f"backlash_{axis}_at_positive", f"backlash_{axis}_at_negative")
            if key in found
        ]
        if ends:
            found[f"backlash_{axis}"] = sum(ends) / len(ends)
        play, change = f"lateral_play_{axis}", f"_lateral_change_{axis}"
        if change in solution:
            found[f"{play}_at_positive"] = found[play] + solution[change]
            found[f"{play}_at_negative"] = found[play] - solution[change]
    return found


def _plain_rows(samples: CircleSamples) -> tuple[list[str], FloatArray]:
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
