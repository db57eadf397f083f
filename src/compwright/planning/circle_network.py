"""Combination of several circular tests of one machine (planes, radii, feeds) in one system of
equations.

Every circle gives a squareness, two scales, two lost motions and a servo mismatch. The machine has
one squareness per plane, and one scale, one lost motion, one lag and one shrinking per axis.

The shrinking separates the lag of the position loop from the scale. A first-order lag T makes the
travel of its axis smaller by (v T / R)² / 2, so circles at two feeds or two radii show both (ISO
230-4:1996, B.3.2). The solution is that of linear least squares with priors of machine-tool size
(Tarantola, Inverse Problem Theory, 2005, chapter 3).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.circle_causes import VELOCITY_LOOP
from compwright.estimation.circle_model import PRIOR_SCALE, PRIORS, SOFTEST_LOOP
from compwright.foundations.findings import Finding
from compwright.planning.circles import CircleWork, as_shown_at_feed, effect_of
from compwright.planning.value_with_error import SIGNIFICANT, ValueWithError, contradictory
from compwright.records.circular import CircularResult
from compwright.records.correction_need import NEGLIGIBLE
from compwright.words.sentences import Amount, Sentence, say

_PPM: Final = 1e6
#: What the softest usual position loop shrinks, um/m for one rad/s squared: T² / 2.
_MOST_SHRINKING: Final = _PPM / (2.0 * SOFTEST_LOOP**2)
#: What the velocity loop behind it can make a circle grow under full feedforward, in the same unit:
#: T T'. Feedforward f that is too large, (f² - 1) T² / 2, reaches this at f = 1.08.
_MOST_GROWTH: Final = _PPM * VELOCITY_LOOP / SOFTEST_LOOP
#: Least error of a scale by the fit, um/m.
_LEAST: Final = 0.05
#: Least error of an observation, as a share of what its unknowns may do to it.
_ROUNDING: Final = 1e-5
#: Mean and standard deviation of the prior of each unknown (um/m, um, ms); the shrinking is uniform
#: up to the softest loop.
_PRIOR: Final[Mapping[str, tuple[float, float]]] = {
    "squareness": (0.0, PRIORS["squareness"]),
    "scale": (0.0, PRIOR_SCALE),
    "shrinking": (0.5 * _MOST_SHRINKING, _MOST_SHRINKING / np.sqrt(12.0)),
    "lost motion": (0.0, PRIORS["backlash"]),
    "lag": (0.0, 50.0 * PRIORS["servo_mismatch"]),
}
#: A standard error above this share of the prior's: the circles do not tell the value.
_TELLS: Final = 0.5
#: Kinds of observations, in the order of the message, with the unit of their values.
_UNITS: Final = {"scale": "µm/m", "lost motion": "µm", "servo mismatch": "ms"}

#: An unknown: its kind, and its axis or plane.
Unknown = tuple[str, str]


@dataclass(frozen=True, slots=True)
class Observation:
    """An equation from one circular test: the measured value ``found`` is the sum of unknown
    machine errors times their coefficients.
    """

    kind: str
    parts: Mapping[Unknown, float]
    found: ValueWithError
    circle: str

    @property
    def group(self) -> tuple[str, str]:
        """The kind of the measured value and, where it has a single unknown (squareness, lost
        motion), its plane or axis. Observations of one group are compared with each other.
        """
        return self.kind, next(iter(self.parts))[1] if len(self.parts) == 1 else ""

    @property
    def axes(self) -> str | Sentence:
        """The axes of this value as text: ``X - Y`` for a difference, ``mean of X and Y``."""
        shares = {axis: share for (kind, axis), share in self.parts.items() if kind != "shrinking"}
        mean = len(shares) > 1 and min(shares.values()) > 0.0
        return say("circle.mean", axes=shares) if mean else " - ".join(shares)


@dataclass(frozen=True, slots=True)
class CircleNetwork:
    """The machine errors that fit all circular tests ``circles`` best, and the measured values in
    which these tests contradict each other.

    ``values``: the machine errors, by the name of the unknown. ``contradictions``: the measured
    values that contradict each other, by kind and, for squareness and lost motion, by plane or
    axis. ``planes``: the name of a plane in the tests, by its axes in alphabetical order.
    """

    circles: tuple[str, ...]
    planes: Mapping[str, str]
    values: Mapping[Unknown, ValueWithError]
    contradictions: Mapping[tuple[str, str], tuple[Observation, ...]]

    def values_of(self, kind: str) -> dict[str, ValueWithError]:
        """Return the machine errors of a ``kind`` that the circular tests determine, by axis or
        plane. A scale is one of them if the shrinking of its axis is known, or hardly matters: else
        it would be mostly the mean of the prior of the shrinking.
        """
        most = _TELLS * _PRIOR[kind][1]
        found = {
            name: value
            for (own, name), value in self.values.items()
            if own == kind and value.std_error < most
        }
        if kind != "scale":
            return found
        known = self.values_of("shrinking")
        return {
            name: value
            for name, value in found.items()
            if name in known or SIGNIFICANT * value.std_error < NEGLIGIBLE
        }

    def contradicts_scale(self, axis: str) -> bool:
        """Return whether the scales that tests of this axis and its neighbours show contradict each
        other.
        """
        contradicted = ("scale", "") in self.contradictions and ("scale", axis) in self.values
        return contradicted or axis in self.strange_loops()

    def strange_loops(self) -> dict[str, ValueWithError]:
        """Return the shrinking (1e-6 s²) of each axis that clearly shrinks with the feed by more
        than the softest usual position loop, or grows (below 0) by more than feedforward explains.
        """
        return {
            name: value
            for name, value in self.values_of("shrinking").items()
            if value.value > _MOST_SHRINKING + SIGNIFICANT * value.std_error
            or value.value < -_MOST_GROWTH - SIGNIFICANT * value.std_error
        }

    def position_loops(self) -> dict[str, ValueWithError]:
        """Return the servo lag (time constant of the position loop, ms) of each axis for which the
        circular tests determine it.
        """
        loops = {}
        for name, value in self.values_of("shrinking").items():
            if value.value > SIGNIFICANT * value.std_error:
                lag = 1e3 * float(np.sqrt(2.0 * value.value / _PPM))
                loops[name] = ValueWithError(lag, 0.5 * lag * value.std_error / value.value)
        return loops


def solve_network(circles: Sequence[CircularResult]) -> CircleNetwork:
    """Return the machine errors from circular tests that were made in one state of the control."""
    seen = [each for result in circles for each in _observations(result)]
    unknowns = sorted({unknown for each in seen for unknown in each.parts})
    matrix = np.array([[each.parts.get(name, 0.0) for name in unknowns] for each in seen])
    matrix = matrix.reshape(len(seen), len(unknowns))
    target = np.array([each.found.value for each in seen])
    centre, width = np.array([_PRIOR[kind] for kind, _ in unknowns]).reshape(-1, 2).T
    scaled = matrix * width  # unknowns in standard deviations of their priors
    error = np.maximum(
        [each.found.std_error for each in seen], _ROUNDING * np.linalg.norm(scaled, axis=1)
    )
    weighted = scaled / error[:, np.newaxis]
    covariance = np.linalg.inv(weighted.T @ weighted + np.eye(len(unknowns)))
    off = (target - matrix @ centre) / error
    solution = covariance @ (weighted.T @ off)
    rest = off - weighted @ solution
    # Each observation takes its share of the unknowns: the rest are degrees of freedom.
    leverage = np.einsum("ij,jk,ik->i", weighted, covariance, weighted)
    contradictions, worse = {}, np.ones(len(unknowns))
    for group in dict.fromkeys(each.group for each in seen):
        mine = np.array([each.group == group for each in seen])
        free = float(np.sum(1.0 - leverage[mine]))
        scatter = float(np.sum(rest[mine] ** 2))
        if free < 0.5 or scatter <= free:
            continue
        # The errors of values that scatter more grow with it (Birge, Physical Review 40, 1932).
        touched = np.any(matrix[mine] != 0.0, axis=0)
        worse[touched] = np.maximum(worse[touched], np.sqrt(scatter / free))
        if contradictory(scatter, free):
            contradictions[group] = tuple(each for each in seen if each.group == group)
    errors = worse * width * np.sqrt(np.diag(covariance))
    values = {
        name: ValueWithError(float(value), float(each))
        for name, value, each in zip(unknowns, centre + width * solution, errors, strict=True)
    }
    planes = {"".join(sorted(each.test.axes)): "".join(each.test.axes) for each in circles}
    names = tuple(each.test.name for each in circles)
    return CircleNetwork(names, planes, values, contradictions)


def _observations(result: CircularResult) -> Iterator[Observation]:
    test, name = result.test, result.test.name
    first, second = test.axes
    turning = (test.feed / 60.0 / test.nominal_radius) ** 2  # (rad/s)²
    angle = effect_of(result, "squareness")
    if angle is not None:
        pair = "".join(sorted(test.axes))
        found = ValueWithError(angle.value, angle.std_error)
        yield Observation("squareness", {("squareness", pair): 1.0}, found, name)
    mismatch = effect_of(result, "scale_mismatch")
    across = 2e-3 * test.nominal_radius  # um of the mismatch for 1 um/m
    if mismatch is not None:
        # The shrinking is an unknown here: nothing of it may be taken off before.
        difference = as_shown_at_feed(mismatch)
        parts = {
            ("scale", first): 1.0,
            ("scale", second): -1.0,
            ("shrinking", first): -turning,
            ("shrinking", second): turning,
        }
        found = ValueWithError(difference.value / across, difference.std_error / across)
        yield Observation("scale", parts, found, name)
        yield from _mean_scale(result, turning)
    late = effect_of(result, "servo_mismatch")
    if late is not None:
        parts = {("lag", first): 1.0, ("lag", second): -1.0}
        yield Observation("servo mismatch", parts, ValueWithError(late.value, late.std_error), name)
    for axis, side in ((first, "first"), (second, "second")):
        lost = effect_of(result, f"backlash_{side}")
        if lost is not None:
            found = ValueWithError(lost.value, lost.std_error)
            yield Observation("lost motion", {("lost motion", axis): 1.0}, found, name)


def _mean_scale(result: CircularResult, turning: float) -> Iterator[Observation]:
    """Yield an equation for the mean scale error of both axes of a circular test. A second unknown
    in the equation is the shrinkage of the radius by the servo loops, so the standard error of the
    mean leaves it out. ``turning``: squared angular speed, (rad/s)².

    On an arc, the errors of both scales are strongly correlated.
    """
    found = [effect_of(result, f"scale_error_{side}") for side in ("first", "second")]
    scales = [each for each in found if each is not None]
    if result.diagnosis is None or len(scales) < 2:
        return
    # What is taken off for unequal lags has opposite signs and is not in the mean.
    value = 0.5 * sum(as_shown_at_feed(each).value for each in scales)
    errors = np.array([each.std_error for each in scales])
    names = result.diagnosis.names
    rows = [names.index(f"scale_error_{side}") for side in ("first", "second")]
    together = float(errors @ result.diagnosis.correlation[np.ix_(rows, rows)] @ errors)
    doubt = turning * _MOST_SHRINKING / np.sqrt(3.0)
    variance = 0.25 * together - doubt**2
    parts = {
        unknown: 0.5 * share
        for axis in result.test.axes
        for unknown, share in ((("scale", axis), 1.0), (("shrinking", axis), -turning))
    }
    stated = ValueWithError(value, float(np.sqrt(max(variance, _LEAST**2))))
    yield Observation("scale", parts, stated, result.test.name)


def state_networks(circles: Iterable[CircleWork]) -> dict[str, CircleNetwork]:
    """Return the machine errors in each state of the control with several diagnosed circular tests,
    by the name of the state.
    """
    states: dict[str, list[CircularResult]] = {}
    for work in circles:
        if work.result.diagnosis is not None:
            states.setdefault(work.planned.measured_in, []).append(work.result)
    return {name: solve_network(results) for name, results in states.items() if len(results) > 1}


def network_findings(circles: Iterable[CircleWork]) -> Iterator[Finding]:
    """Yield the findings about the machine errors from circular tests in the same state of the
    control.

    Findings about a correction of squareness are made in `planning.cross`.
    """
    for network in state_networks(circles).values():
        yield from machine_findings(network)


def machine_findings(network: CircleNetwork) -> Iterator[Finding]:
    """Yield a finding with the machine errors from all circular tests, and a finding for each
    contradiction between these tests, except about squareness (`squareness_findings`).
    """
    circles, machine = list(network.circles), list(_machine(network))
    yield Finding.of("CW-P135", "info", circles=circles, machine=machine)
    for (kind, _), seen in network.contradictions.items():
        if kind == "squareness":
            continue
        yield contradiction(
            kind,
            tuple(
                dict.fromkeys(axis for one in seen for of, axis in one.parts if of != "shrinking")
            ),
            [(one.circle, one.axes, one.found.words(1.0, _UNITS[kind])) for one in seen],
        )
    for axis, shrinking in network.strange_loops().items():
        if shrinking.value < 0.0:
            yield Finding.of("CW-P136.growth", "warning", (axis,), axis=axis, circles=circles)
            continue
        lag = 1e3 * float(np.sqrt(2.0 * shrinking.value / _PPM))
        yield Finding.of(
            "CW-P136.lag",
            "warning",
            (axis,),
            axis=axis,
            circles=circles,
            lag=Amount(lag, "ms", ".0f"),
            most=Amount(1e3 / SOFTEST_LOOP, "ms", ".0f"),
        )


def contradiction(
    kind: str, axes: tuple[str, ...], values: Iterable[tuple[str, str | Sentence, Sentence]]
) -> Finding:
    """Return the finding that circular tests contradict each other about a ``kind`` of values of
    these axes. ``values``: the circle, its axes and its value in words.
    """
    each = [
        say("CW-P136.circle", circle=circle, axes=own, value=value) for circle, own, value in values
    ]
    return Finding.of("CW-P136", "warning", axes, kind=kind, values=each)


def squareness_findings(network: CircleNetwork) -> Iterator[Finding]:
    """Yield a finding for each plane whose squareness differs between circular tests that were made
    in the same state of the control.
    """
    for (kind, plane), seen in network.contradictions.items():
        if kind == "squareness":
            yield squareness_contradiction(
                (plane[0], plane[1]), [(one.circle, one.found.value) for one in seen]
            )


def squareness_contradiction(axes: tuple[str, str], values: Iterable[tuple[str, float]]) -> Finding:
    """Return the finding that circular tests contradict each other about the squareness of a plane.
    ``values``: squareness in um/m, by name of the test.
    """
    each = [say("CW-P110.circle", circle=circle, squareness=value) for circle, value in values]
    return Finding.of("CW-P110", "warning", axes, plane="".join(axes), values=each)


def _machine(network: CircleNetwork) -> Iterator[Sentence]:
    kinds = (("squareness", "µm/m"), ("scale", "µm/m"), ("lost motion", "µm"))
    found = [(kind, unit, network.values_of(kind)) for kind, unit in kinds]
    for kind, unit, values in (*found, ("position loop", "ms", network.position_loops())):
        each = [
            say("CW-P135.value", of=network.planes.get(of, of), value=value.words(1.0, unit))
            for of, value in values.items()
        ]
        if each:
            yield say("CW-P135.error", kind=kind, values=each)
