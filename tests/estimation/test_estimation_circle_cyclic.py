"""Axes with more than one cyclic error: positions of both axes, then the distance to the ball."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from circular_samples import circular_test
from compwright.estimation.circle import diagnose
from compwright.records.circular import CircularRun, CircularTest, Diagnosis

Waves = tuple[tuple[float, float], ...]  # um, mm

RADIUS, FEED, SAMPLES = 120.0, 1000.0, 3000


def turned(first: Waves, second: Waves, *, late: float = 0.0, seed: int = 1) -> CircularTest:
    """Return the test of two screws with these errors, in noise of 0.2 µm, of axes ``late`` ms."""
    rng = np.random.default_rng(seed)

    def error(place: np.ndarray, waves: Waves) -> np.ndarray:
        return sum(
            (1e-3 * size * np.sin(2.0 * np.pi * place / pitch + pitch) for size, pitch in waves),
            np.zeros_like(place),
        )

    runs = []
    behind = FEED / 60.0 * 1e-3 * late / RADIUS
    for name, sense in (("ccw", 1.0), ("cw", -1.0)):
        angle = sense * 2.0 * np.pi * (np.arange(SAMPLES) + 0.5) / SAMPLES
        x, y = RADIUS * np.cos(angle - sense * behind), RADIUS * np.sin(angle - sense * behind)
        length = np.hypot(x + error(x, first), y + error(y, second))
        runs.append(
            CircularRun(
                sense=name,  # type: ignore[arg-type]
                angles=np.degrees(np.mod(angle, 2.0 * np.pi)),
                deviations=length - RADIUS + rng.normal(0.0, 2e-4, SAMPLES),
            )
        )
    return circular_test(runs, radius=RADIUS, feed=FEED)


def waves_of(found: Diagnosis, axis: str) -> list[tuple[float, float, float]]:
    """Return amplitude, standard error and pitch of each cyclic error found, as they are listed."""
    return [
        (effect.value, effect.std_error, effect.more["period"] or 0.0)
        for name, effect in found.effects.items()
        if name.startswith(f"cyclic_{axis}") and effect.more.get("period")
    ]


@pytest.mark.parametrize(
    ("first", "second", "late"),
    [
        pytest.param(((1.5, 10.0), (0.8, 5.0)), (), 0.0, id="pitch and half"),
        pytest.param((), ((0.9, 4.0), (0.5, 12.0)), 20.0, id="belt and screw, late"),
        pytest.param(
            ((1.5, 10.0), (0.8, 5.0), (0.4, 10.0 / 3.0)), ((1.0, 10.0),), 0.0, id="three and one"
        ),
    ],
)
def test_every_cyclic_error_is_stated_of_its_own_axis(
    first: Waves, second: Waves, late: float
) -> None:
    """One screw error hides another: with one per axis, the pitch of 10 mm was stated of the other
    axis, with 0.4 to 0.6 µm at 9 to 12.6 mm.
    """
    found = diagnose(turned(first, second, late=late))
    for axis, name, true in (("first", "X", first), ("second", "Y", second)):
        waves = waves_of(found, axis)
        assert len(waves) == len(true)
        for (value, error, pitch), (size, its_pitch) in zip(
            waves, sorted(true, reverse=True), strict=True
        ):
            assert abs(value - size) < 3.0 * error
            assert error < 0.02
            assert pitch == pytest.approx(its_pitch, rel=1e-3)
        listed = [f for f in found.findings if f.code == "CW-D006" and f"of {name} " in f.message]
        assert len(listed) == len(true)
        if not true:
            assert found.effects[f"cyclic_{axis}"].value == 0.0
            assert found.effects[f"cyclic_{axis}"].std_error < 0.05


def test_an_unclear_further_error_of_one_axis_hides_none_of_the_other() -> None:
    found = diagnose(turned(((1.5, 10.0), (0.045, 5.0)), ((0.03, 7.0),), seed=4))
    ((value, error, pitch),) = waves_of(found, "second")
    assert abs(value - 0.03) < 3.0 * error
    assert pitch == pytest.approx(7.0, rel=0.01)


def test_further_cyclic_errors_of_a_given_pitch() -> None:
    """The given pitch keeps the name of the axis, though another error is larger."""
    found = diagnose(turned(((1.5, 10.0), (0.8, 5.0)), ()), periods={"X": 5.0})
    (small, _, given), (large, _, pitch) = waves_of(found, "first")
    assert [small, large] == pytest.approx([0.8, 1.5], abs=0.03)
    assert [given, pitch] == pytest.approx([5.0, 10.0], rel=1e-3)
    assert [f.code for f in found.findings].count("CW-D006") == 1


@pytest.mark.parametrize("growth", [0.3, 0.5])
def test_a_cyclic_error_that_grows_along_the_axis_is_one(growth: float) -> None:
    """A screw worn at one end: 2 µm at 10 mm in the middle, by this share more at one end and less at
    the other. Its spectrum is broad by the inverse of the travel.
    """
    setup = Setup(radius=150.0, feed=1000.0, samples=3000, noise=0.2)
    rng = np.random.default_rng(3)
    even, grown = (
        measured(Machine(cyclic_first=size, phase_first=0.3), setup) for size in (2.0, 0.0)
    )
    runs = []
    for with_it, without in zip(even.runs, grown.runs, strict=True):
        wave = with_it.deviations - without.deviations
        values = without.deviations + wave * (1.0 + growth * np.cos(np.radians(with_it.angles)))
        values = values + rng.normal(0.0, 2e-4, values.size)
        runs.append(CircularRun(sense=with_it.sense, angles=with_it.angles, deviations=values))
    found = diagnose(replace(even, runs=tuple(runs)))
    ((value, error, pitch),) = waves_of(found, "first")
    assert abs(value - 2.0) < 2.0 * error
    assert error < 0.2
    assert pitch == pytest.approx(10.0, rel=2e-3)
    assert not waves_of(found, "second")


@pytest.mark.parametrize("seed", [2, 3, 4, 5])
def test_a_cyclic_error_of_three_periods_is_no_noise(seed: int) -> None:
    """It was taken for correlated noise: 0 ± 1 µm, and a squareness of ± 20 to ± 31 µm/m."""
    machine = Machine(squareness=-32.0, cyclic_first=1.0, pitch_first=22.5)
    setup = Setup(
        radius=50.0, feed=1000.0, samples=2200, start=250.0, extent=220.0, wander=0.3, length=3.0
    )
    effects = diagnose(measured(machine, setup, np.random.default_rng(seed))).effects
    for name, true, most in (("cyclic_first", 1.0, 0.05), ("squareness", -32.0, 5.0)):
        assert abs(effects[name].value - true) < 2.0 * effects[name].std_error < 2.0 * most


def test_correlated_noise_is_no_cyclic_error() -> None:
    setup = Setup(radius=50.0, feed=1000.0, samples=1500, wander=1.0, length=30.0)
    for seed in range(4):
        effects = diagnose(measured(Machine(), setup, np.random.default_rng(seed))).effects
        assert effects["cyclic_first"].value == effects["cyclic_second"].value == 0.0
