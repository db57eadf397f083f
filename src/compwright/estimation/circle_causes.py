"""Causes of a circular test as they are reported, and the straight errors of both axes: squareness
and scale.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np

from compwright.estimation.circle_model import SOFTEST_LOOP, UM
from compwright.estimation.circle_solution import Solution
from compwright.records.axis import FloatArray
from compwright.words.sentences import Sentence

#: Slope of the least-squares straight line through 2u³ - u over the travel -1 < u < 1: the line is
#: (3 * 2/5 - 1) u.
_TURN: Final = 0.2
#: Share of a changeover that another response in the same time makes of it (2 to 5 % by least
#: squares).
OTHER_RESPONSE: Final = 0.05
#: Scale mismatch with the second harmonic of a changeover of 1 um: 4 * 4/pi * 1/2.
_OF_CHANGEOVER: Final = 8.0 / np.pi
#: Servo loops, s: time constant of a velocity loop (30 Hz); least lag behind full feedforward; most
#: difference of the position loops of two axes (a tenth of 40 ms).
VELOCITY_LOOP: Final = 0.005
_LEAST_LAG: Final = 5e-4
_UNLIKE_LOOPS: Final = 0.004


@dataclass(frozen=True, slots=True, kw_only=True)
class ReportedCause:
    """One cause as reported: its value, random draws of the value, and its radial deviations.

    ``drawn`` (d,): random draws of the value from its posterior. ``curve`` (n,): its radial
    deviation, mm. ``variance``: variance of the value that the draws do not contain. ``upwards``:
    the part of it by which the value can only be too small. ``reason``: why the cause is not
    reported. ``axis``: the axis that vibrates.
    """

    name: str
    value: float
    drawn: FloatArray
    curve: FloatArray
    detail: bool = False
    positive: bool = False
    variance: float = 0.0
    upwards: float = 0.0
    more: Mapping[str, float | None] = field(default_factory=dict)
    reason: Sentence | None = None
    axis: str | None = None

    @property
    def std_error(self) -> float:
        """Standard error of the value."""
        return float(np.sqrt(np.var(self.drawn) + self.variance))


def linear_cause(
    solution: Solution, name: str, parts: Mapping[str, float], *, detail: bool = False
) -> ReportedCause:
    """Return the reported cause ``name``: a sum of fitted causes with the weights in ``parts``."""
    gradient = np.zeros(len(solution.problem.names))
    for part, weight in parts.items():
        gradient[solution.problem.names.index(part)] = weight
    mean = np.mean(solution.draws.values, axis=0)
    curve = solution.problem.slopes @ (mean * (gradient != 0.0))
    drawn = solution.draws.values @ gradient
    hidden = solution.draws.least_error.get(name, 0.0)
    return ReportedCause(
        name=name,
        value=float(gradient @ mean),
        drawn=drawn,
        curve=curve,
        detail=detail,
        variance=max(hidden**2 - float(np.var(drawn)), 0.0),
    )


def squareness(solution: Solution) -> ReportedCause:
    """Return the squareness of the two axes.

    A straightness of third order has a straight part, which depends on its reference line. A circle
    shows the line that leaves no second harmonic, u³ - u/2 with the position u = x/R. The mean line
    of ISO 230-1, by least squares over the travel, leaves u³ - 3u/5. The angle between both lines
    has either sign, because it is unknown which axis is bent. It is a standard uncertainty (two
    values of equal probability: JCGM 100:2008, 4.3.1).
    """
    cause = linear_cause(solution, "squareness", {"squareness": 1.0})
    size = solution.draws.values[:, solution.problem.names.index("_s_shape")]
    turn = _TURN * size / solution.problem.samples.radius / UM
    return replace(cause, variance=cause.variance + float(np.mean(turn**2)))


def shapes_cause(solution: Solution, name: str) -> ReportedCause:
    """Return the cause ``name`` that has several shapes in the model: the sum of all of them."""
    names = [each for each in solution.problem.names if each.partition("@")[0] == name]
    return linear_cause(solution, name, dict.fromkeys(names, 1.0))


def scale_mismatch(solution: Solution, changed: float) -> ReportedCause:
    """Return the scale mismatch after the effect of unequal servo loops is subtracted.

    ``changed``: size of the changeover, um. Its part counts in the variance, not in the draws.

    A position loop of time constant T with the share f of velocity feedforward lags by (1 - f) T,
    and reduces the radius of its axis by (1 - f²)(ωT)² / 2. A servo mismatch τ thus changes the
    mismatch by -2 v²/R (1 + f) T τ over the diameter. A dead time changes nothing. Neither f nor T
    shows in a circle at one feed. (1 + f) T lies between 0 and twice that of the softest usual
    loop, `SOFTEST_LOOP`: a rectangular distribution (JCGM 100:2008, 4.3.7). Its mean is subtracted.

    A velocity loop of time constant T' increases the radius by ω² T T', and no delay shows this.
    Behind feedforward the time constants T may be far more unlike than the lags a: by τ T / a.
    ``lag_taken_off`` is what is subtracted, ``lag_error`` the standard uncertainty of all this, um.
    Circles at several feeds can determine the effect.
    """
    samples = solution.problem.samples
    cause = linear_cause(solution, "scale_mismatch", {"scale_mismatch": 1.0})
    step = _OF_CHANGEOVER * OTHER_RESPONSE * changed
    cause = replace(cause, variance=cause.variance + step**2)
    if not samples.both_senses:
        return replace(cause, more={"lag_taken_off": 0.0, "lag_error": 0.0})
    names = solution.problem.names
    drawn = solution.draws.values[:, names.index("servo_mismatch")]
    softest, across = 1.0 / SOFTEST_LOOP, 2.0 * samples.speed**2 / samples.radius
    off = across * softest * drawn
    mismatch = 1e-3 * abs(float(np.mean(drawn)))
    lag = max(samples.lag * samples.radius / samples.speed, _LEAST_LAG)
    unlike = min(mismatch * softest / lag, _UNLIKE_LOOPS)
    parts = softest * mismatch / np.sqrt(3.0), VELOCITY_LOOP * unlike
    error = 1e3 * across * float(np.hypot(*parts))
    either = np.where(np.arange(off.size) % 2, error, -error)
    return replace(
        cause,
        value=cause.value + float(np.mean(off)),
        drawn=cause.drawn + off + either,
        more={"lag_taken_off": float(np.mean(off)), "lag_error": error},
    )


def scale_errors(solution: Solution, mismatch: ReportedCause) -> Iterator[ReportedCause]:
    """Yield the scale errors of both axes, um/m, from the radius and the scale ``mismatch``.

    They are the mean radius deviation over R, plus and minus a quarter of the mismatch over R.
    """
    samples = solution.problem.samples
    radius = linear_cause(solution, "_radius", {"_radius": 1e6 / samples.radius})
    for axis, sign, shape in (
        ("first", 1.0, np.cos(samples.theta) ** 2),
        ("second", -1.0, np.sin(samples.theta) ** 2),
    ):
        share = sign * 0.25 * UM * 1e6 / samples.radius
        value = radius.value + share * mismatch.value
        yield ReportedCause(
            name=f"scale_error_{axis}",
            value=value,
            drawn=radius.drawn + share * mismatch.drawn,
            curve=1e-6 * value * samples.radius * shape,
            detail=True,
            variance=share**2 * mismatch.variance,
            more={
                "lag_taken_off": share * (mismatch.more["lag_taken_off"] or 0.0),
                "lag_error": abs(share) * (mismatch.more["lag_error"] or 0.0),
            },
        )
