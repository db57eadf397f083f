"""Tables of whole increments: time per solve at 1 000 nodes, and what is left against two ways of
rounding. Prints, judges nothing.

Three ways to the same table: the exact optimum over whole increments and reversal values; the best
real values with their totals rounded; the same with each increment rounded by itself, which drifts.
"rms" and "E" are those of the systematic error that is left over the travel, both directions, no
noise; E at 2 001 positions. Rounded tables that leave the increments' limits are clipped. The
optimum is that of the mean square: E, which one position decides, may come out a little smaller
after plain rounding of totals.
"""

from __future__ import annotations

import statistics
import time
from dataclasses import replace

import numpy as np
from measure import spread, two_processors
from numpy.typing import NDArray

from compwright.fitting.fit import fit_table
from compwright.records.axis import AxisKind, Direction
from compwright.records.capacity import Capacity, Lattice
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest

Array = NDArray[np.float64]
UM = 1e-3
RUNS = 5
AXES = 20
TRAVEL = 1000.0


def control(largest: int, *, step: bool) -> Capacity:
    """Return a control of whole increments of 1 µm."""
    return Capacity(
        format="whole",
        curves=1,
        spacing="equidistant",
        quantum=1 * UM,
        position_quantum=1e-3,
        value_range=(-32.0, 32.0),
        backlash_quantum=1 * UM,
        backlash_range=(-9999 * UM, 9999 * UM),
        lattice=Lattice(
            unit=1 * UM, increments=(-largest, largest), magnifications=tuple(range(1, 101))
        ),
        interpolation="step" if step else "linear",
        anchored=True,
    )


def axis(seed: int, slope: float) -> WantedCorrection:
    """Return a smooth error with ``slope`` (µm/m), a few waves and 4.3 µm of lost motion."""
    rng = np.random.default_rng(seed)
    where = np.linspace(0.0, TRAVEL, 2001)
    order = np.arange(1, 9)
    waves = np.sin(np.outer(where, order) * np.pi / TRAVEL + rng.uniform(0, 6, 8)) @ (
        rng.standard_normal(8) / order
    )
    curve = 6 * UM * (waves - waves[0]) + slope * rng.choice([-1.0, 1.0]) * UM * where / 1000.0
    return WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=where,
        positive=curve,
        negative=curve - 4.3 * UM,
        reference=0.0,
        reference_return=Direction.POSITIVE,
        noise=0.5 * UM,
    )


def left(table: AxisCompensation, wanted: WantedCorrection) -> tuple[float, float]:
    """Return rms and E of what a table leaves, µm."""
    rest = [
        table.at(wanted.positions, direction) - wanted.total(direction) for direction in Direction
    ]
    return float(np.sqrt(np.mean(np.square(rest)))) / UM, float(np.max(rest) - np.min(rest)) / UM


def rounded(
    free: AxisCompensation, step: float, largest: int, *, increments: bool
) -> AxisCompensation:
    """Return the table of real values rounded, totals or increments, each increment within its
    limits.
    """
    values = free.positive / step
    steps = np.round(np.diff(values)) if increments else np.diff(np.round(values))
    totals: Array = np.append(0.0, np.cumsum(np.clip(steps, -largest, largest))) * step
    return replace(free, positive=totals, negative=totals, backlash=round(free.backlash / UM) * UM)


def quality(largest: int, spacing: float, slope: float, *, step: bool) -> None:
    """Print rms and E of the three ways over many axes."""
    capacity = control(largest, step=step)
    free = replace(capacity, lattice=None, quantum=1e-7, backlash_quantum=1e-7)
    request = TableRequest(spacing=spacing)
    rows: dict[str, list[tuple[float, float]]] = {"exact": [], "totals": [], "increments": []}
    chosen = set()
    for seed in range(AXES):
        wanted = axis(seed, slope)
        fitted = fit_table(wanted, capacity, request, address="1")
        magnification = int(fitted.certificate["magnification"])
        chosen.add(magnification)
        real = fit_table(wanted, free, request, address="1").compensation
        rows["exact"].append(left(fitted.compensation, wanted))
        for name in ("totals", "increments"):
            rows[name].append(
                left(
                    rounded(real, magnification * UM, largest, increments=name == "increments"),
                    wanted,
                )
            )
    shape = "steps" if step else "lines"
    medians = {
        name: [statistics.median(column) for column in zip(*row, strict=True)]
        for name, row in rows.items()
    }
    says = ", ".join(f"{name} {rms:.2f} / {e:.2f}" for name, (rms, e) in medians.items())
    case = (
        f"±{largest:<3} every {spacing:g} mm, {slope:g} µm/m, {shape}, magnification {min(chosen)}"
        f" to {max(chosen)}"
    )
    print(f"{case}: rms / E {says} µm")


def speed(largest: int, slope: float, *, step: bool) -> None:
    """Print the seconds of a whole fit with 1 001 nodes and 100 magnifications."""
    capacity, seconds, magnification = control(largest, step=step), [], 0.0
    for run in range(RUNS + 1):
        wanted = axis(run, slope)
        start = time.perf_counter()
        magnification = fit_table(
            wanted, capacity, TableRequest(spacing=1.0), address="1"
        ).certificate["magnification"]
        seconds.append(time.perf_counter() - start)
    shape = "steps" if step else "lines"
    print(
        f"1 001 nodes, ±{largest}, {slope:g} µm/m, {shape}: {spread(seconds[1:], 3)} s,"
        f" magnification {magnification:g}"
    )


def main() -> None:
    """Print times, then what is left."""
    print(f"whole fits on {two_processors()}, {RUNS} axes, min / median / max")
    for largest in (7, 127):
        for step in (True, False):
            speed(largest, 100.0, step=step)
    speed(7, 9000.0, step=False)
    print(f"median over {AXES} axes of 1 m")
    for step in (True, False):
        quality(7, 10.0, 20.0, step=step)
        quality(7, 50.0, 20.0, step=step)
        quality(7, 50.0, 200.0, step=step)
        quality(127, 50.0, 200.0, step=step)


if __name__ == "__main__":
    main()
