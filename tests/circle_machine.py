"""Circular tests of machines with known causes, from the exact path of the tool; independent of the
project's own simulator.

Positions are computed as a machine moves: the commanded point, the error of each axis at that point
and direction, then the distance to the ball. Nothing here is a radial formula, so that first-order
formulas of the product are compared with geometry.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields, replace

import numpy as np
from numpy.typing import NDArray

from compwright.records.circular import CircularRun, CircularTest

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Machine:
    """Causes in the contract's units: um, um/m, ms; pitch and decay in mm, centre in mm, phase in
    rad.

    ``s_shape_first`` um: straightness of third order, 2 u³ - 1.2 u with u = x / R, whose mean line
    over the travel is zero. ``spiral`` um: growth of the radius during each run.
    ``lag`` ms: dead time that both axes have in common.
    """

    squareness: float = 0.0
    scale_error_first: float = 0.0
    scale_error_second: float = 0.0
    backlash_first_at_positive: float = 0.0
    backlash_first_at_negative: float = 0.0
    backlash_second_at_positive: float = 0.0
    backlash_second_at_negative: float = 0.0
    servo_mismatch: float = 0.0
    lateral_play_first: float = 0.0
    lateral_play_second: float = 0.0
    reversal_spike_first: float = 0.0
    reversal_spike_second: float = 0.0
    decay_first: float = 4.0
    decay_second: float = 4.0
    cyclic_first: float = 0.0
    cyclic_second: float = 0.0
    pitch_first: float = 10.0
    pitch_second: float = 12.0
    phase_first: float = 0.3
    phase_second: float = 1.1
    straightness_first: float = 0.0
    straightness_second: float = 0.0
    s_shape_first: float = 0.0
    s_shape_second: float = 0.0
    radius_change: float = 0.0
    spiral: float = 0.0
    lag: float = 0.0
    centre: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Setup:
    """How the test is run. ``noise`` µm, white; ``wander`` µm, first-order autoregressive with
    ``length`` samples to 1/e.
    """

    radius: float = 150.0
    feed: float = 2000.0
    samples: int = 1500
    start: float = 0.0
    extent: float = 360.0
    senses: tuple[str, ...] = ("ccw", "cw")
    calibrated: bool = True
    noise: float = 0.0
    wander: float = 0.0
    length: float = 20.0
    extra: dict[str, Array] = field(default_factory=dict)


def truth(machine: Machine, setup: Setup) -> dict[str, float]:
    """Return every signed cause by its contract name."""
    values = {
        f.name: float(getattr(machine, f.name)) for f in fields(machine) if f.name != "centre"
    }
    keys = (
        "squareness",
        "scale_error",
        "backlash",
        "servo",
        "lateral",
        "straightness",
        "radius_change",
    )
    found = {name: value for name, value in values.items() if name.startswith(keys)}
    for axis in ("first", "second"):
        found[f"backlash_{axis}"] = 0.5 * (
            values[f"backlash_{axis}_at_positive"] + values[f"backlash_{axis}_at_negative"]
        )
    difference = machine.scale_error_first - machine.scale_error_second
    found["scale_mismatch"] = 2.0 * setup.radius * difference * 1e-3
    return found


def distance(machine: Machine, setup: Setup, theta: Array, sense: float) -> Array:
    """Return the bar's length (n,) mm at commanded angles ``theta`` rad, moving ccw (+1) or cw
    (-1).
    """
    R, um = setup.radius, 1e-3
    theta = theta - sense * setup.feed / 60.0 * 1e-3 * machine.lag / R
    x, y = R * np.cos(theta), R * np.sin(theta)
    moves_x, moves_y = np.sign(-sense * np.sin(theta)), np.sign(sense * np.cos(theta))
    speed = setup.feed / 60.0
    # The first axis is where it was told to be half the lag difference ago, the second where it
    # will be.
    late = sense * speed / R * 0.5e-3 * machine.servo_mismatch
    along_x, along_y = R * np.cos(theta - late), R * np.sin(theta + late)
    actual_x = along_x * (1.0 + 1e-6 * machine.scale_error_first)
    actual_y = along_y * (1.0 + 1e-6 * machine.scale_error_second)
    actual_x = actual_x - 1e-6 * machine.squareness * y
    lost_x = np.where(
        x > 0.0, machine.backlash_first_at_positive, machine.backlash_first_at_negative
    )
    lost_y = np.where(
        y > 0.0, machine.backlash_second_at_positive, machine.backlash_second_at_negative
    )
    actual_x = (
        actual_x - 0.5 * um * lost_x * moves_x + 0.5 * um * machine.lateral_play_second * moves_y
    )
    actual_y = (
        actual_y - 0.5 * um * lost_y * moves_y + 0.5 * um * machine.lateral_play_first * moves_x
    )
    actual_x = actual_x + um * machine.straightness_second * (y / R) ** 2
    actual_y = actual_y + um * machine.straightness_first * (x / R) ** 2
    u, w = x / R, y / R
    actual_x = actual_x + um * machine.s_shape_second * (2.0 * w**3 - 1.2 * w)
    actual_y = actual_y + um * machine.s_shape_first * (2.0 * u**3 - 1.2 * u)
    for axis, along, height, decay, points in (
        ("x", along_x, machine.reversal_spike_first, machine.decay_first, (0.0, np.pi)),
        (
            "y",
            along_y,
            machine.reversal_spike_second,
            machine.decay_second,
            (0.5 * np.pi, 1.5 * np.pi),
        ),
    ):
        since = np.min(
            [R * np.mod(sense * (theta - point), 2.0 * np.pi) for point in points], axis=0
        )
        last = np.argmin([np.mod(sense * (theta - point), 2.0 * np.pi) for point in points], axis=0)
        outward = np.where(last == 0, 1.0, -1.0) * um * height * np.exp(-since / decay)
        if axis == "x":
            actual_x = (
                actual_x
                + outward
                + um
                * machine.cyclic_first
                * np.cos(2.0 * np.pi * along / machine.pitch_first + machine.phase_first)
            )
        else:
            actual_y = (
                actual_y
                + outward
                + um
                * machine.cyclic_second
                * np.cos(2.0 * np.pi * along / machine.pitch_second + machine.phase_second)
            )
    length: Array = np.hypot(actual_x + machine.centre[0], actual_y + machine.centre[1])
    return length + sense * um * machine.radius_change


def measured(
    machine: Machine, setup: Setup, rng: np.random.Generator | None = None
) -> CircularTest:
    """Return the test of a machine: one run per sense, samples in the middle of equal pieces of the
    arc.
    """
    runs = []
    for name in setup.senses:
        steps = (np.arange(setup.samples) + 0.5) * setup.extent / setup.samples
        angles = setup.start + (steps if name == "ccw" else setup.extent - steps)
        sense = 1.0 if name == "ccw" else -1.0
        deviations = distance(machine, setup, np.radians(angles), sense) - setup.radius
        travelled = steps / setup.extent  # of the run, in time
        deviations = deviations + 1e-3 * machine.spiral * (travelled - 0.5)
        if rng is not None:
            deviations = deviations + 1e-3 * noise(setup, rng)
        if name in setup.extra:
            deviations = deviations + 1e-3 * setup.extra[name]
        runs.append(CircularRun(sense=name, angles=angles, deviations=deviations))  # type: ignore[arg-type]
    return CircularTest(
        name="circle",
        plane="XY",
        axes=("X", "Y"),
        nominal_radius=setup.radius,
        feed=setup.feed,
        arc=(setup.start, setup.extent),
        calibrated=setup.calibrated,
        runs=tuple(runs),
    )


def noise(setup: Setup, rng: np.random.Generator) -> Array:
    """Return white plus autoregressive noise (n,), µm, in the order of time."""
    white = setup.noise * rng.standard_normal(setup.samples)
    if setup.wander == 0.0:
        return white
    root = float(np.exp(-1.0 / setup.length))
    drive = rng.standard_normal(setup.samples) * np.sqrt(1.0 - root**2)
    wander = np.empty(setup.samples)
    state = float(rng.standard_normal())
    for index, push in enumerate(drive):
        state = root * state + push
        wander[index] = state
    return white + setup.wander * wander


def random_machine(rng: np.random.Generator, radius: float) -> Machine:
    """Return a machine with all causes at once, of the size that machines in a workshop have."""
    u = rng.uniform
    lost = {axis: u(-3.0, 12.0) for axis in ("first", "second")}
    spread = {axis: u(-2.0, 2.0) for axis in ("first", "second")}
    return Machine(
        squareness=u(-60.0, 60.0),
        scale_error_first=u(-60.0, 60.0),
        scale_error_second=u(-60.0, 60.0),
        backlash_first_at_positive=lost["first"] + spread["first"],
        backlash_first_at_negative=lost["first"] - spread["first"],
        backlash_second_at_positive=lost["second"] + spread["second"],
        backlash_second_at_negative=lost["second"] - spread["second"],
        servo_mismatch=u(-0.4, 0.4),
        lateral_play_first=u(-2.0, 4.0),
        lateral_play_second=u(-2.0, 4.0),
        reversal_spike_first=u(0.0, 8.0),
        reversal_spike_second=u(0.0, 8.0),
        decay_first=radius * u(0.012, 0.06),
        decay_second=radius * u(0.012, 0.06),
        cyclic_first=u(0.0, 2.0),
        cyclic_second=u(0.0, 2.0),
        pitch_first=u(5.0, 20.0),
        pitch_second=u(5.0, 20.0),
        phase_first=u(0.0, 2.0 * np.pi),
        phase_second=u(0.0, 2.0 * np.pi),
        straightness_first=u(-4.0, 4.0),
        straightness_second=u(-4.0, 4.0),
        radius_change=u(-1.0, 1.0),
        centre=(u(-0.5, 0.5), u(-0.5, 0.5)),
    )


def without(machine: Machine, *prefixes: str) -> Machine:
    """Return the machine with all causes of these names at zero."""
    names = [f.name for f in fields(machine) if f.name.startswith(prefixes)]
    return replace(machine, **dict.fromkeys(names, 0.0))  # type: ignore[arg-type]
