"""Which squareness of a circular test would be corrected, over random machines, arcs, directions
and noise: wrong corrections, and corrections that are missing. Judges nothing.

``python benchmarks/bench_squareness.py [MACHINES]`` (500 by default, half a minute). The truth is
that of the simulated machine. Wrong: the machine is worse after the correction, or off by more than
30 µm/m. Determinable, by the truth alone: both directions, both axes reverse inside the arc, and
the bound of Cramér and Rao for the noise of the test is below an eighth of the true value and below
7.5 µm/m (half of what a correction may be uncertain by).
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from bench_circle import bound, mixed

from circle_machine import Machine, Setup, measured, random_machine
from compwright.planning.diagnosed import diagnosed_circle
from compwright.records.correction_need import need_of

STARTS = (0.0, 30.0, 45.0, 60.0, 80.0, 90.0, 100.0, 135.0, 180.0, 270.0)
EXTENTS = (91.0, 120.0, 180.0, 220.0, 270.0, 300.0, 330.0, 360.0)


def setup_of(rng: np.random.Generator) -> Setup:
    """Return a test with an arc, directions and noise as they come."""
    extent = float(rng.choice(EXTENTS)) if rng.uniform() < 0.5 else float(rng.uniform(91.0, 360.0))
    start = float(rng.uniform(0.0, 360.0)) if rng.uniform() < 0.5 else float(rng.choice(STARTS))
    senses = ("ccw", "cw") if rng.uniform() < 0.8 else (str(rng.choice(["ccw", "cw"])),)
    return replace(
        mixed(rng),
        extent=extent,
        start=start,
        senses=senses,
        samples=max(300, int(1000.0 * extent / 360.0)),
        calibrated=bool(rng.uniform() < 0.7),
    )


def reverses(setup: Setup, points: tuple[float, float]) -> bool:
    """Whether an axis reverses inside the arc, 2° from its ends."""
    return setup.extent >= 360.0 or any(
        2.0 <= (point - setup.start) % 360.0 <= setup.extent - 2.0 for point in points
    )


def determinable(squareness: float, setup: Setup, least: float) -> bool:
    """Whether a test can give the squareness, by what it is made of."""
    return (
        len(setup.senses) == 2
        and reverses(setup, (0.0, 180.0))
        and reverses(setup, (90.0, 270.0))
        and least < min(abs(squareness) / 8.0, 7.5)
    )


def arc_bound(machine: Machine, setup: Setup) -> float:
    """Return the least standard error of the squareness, um/m; of correlated noise as if its
    slowest part were white.
    """
    sigma = float(np.hypot(setup.noise, setup.wander * np.sqrt(2.0 * setup.length)))
    return bound(machine, replace(setup, noise=sigma))["squareness"]


def main() -> None:
    """Print the counts."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    written = wrong = could = made = 0
    for index in range(count):
        rng = np.random.default_rng([5, index])
        setup = setup_of(rng)
        machine = random_machine(rng, setup.radius)
        diagnosis = diagnosed_circle(measured(machine, setup, rng), "iso230-4:2005").diagnosis
        true = float(machine.squareness)
        corrected = False
        if diagnosis is not None and "squareness" not in diagnosis.undetermined:
            effect = diagnosis.effects["squareness"]
            corrected = need_of(effect.value, effect.std_error) == "correct"
            left = abs(effect.value - true)
            wrong += corrected and (left >= abs(true) or left > 30.0)
        written += corrected
        if determinable(true, setup, arc_bound(machine, setup)):
            could += 1
            made += corrected
    print(f"{count} machines: {written} corrections written, {wrong} of them wrong")
    print(f"determinable: {could}, of them corrected: {made} ({made / max(could, 1):.1%})")


if __name__ == "__main__":
    main()
