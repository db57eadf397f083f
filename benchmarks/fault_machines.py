"""Virtual axes for ``loading_faults.py``: those of ``machine_kinds`` and a few more, each with a
test before loading and another one after it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from error_curves import Curve, constant, total, turning
from machine_kinds import KINDS
from machines import Floats, Machine, dithered, loud, name_seed, plain
from numpy.random import Generator


@dataclass(frozen=True)
class Axis:
    """One axis under work.

    ``before``, ``after``: the machine as each test finds it (targets, runs, noise); the error is
    the same. ``spacing``: of the table asked for. ``spread``: true standard deviation of a reading.
    """

    name: str
    kind: str
    before: Machine
    after: Machine
    spacing: float | str
    spread: float

    @property
    def unit(self) -> str:
        """Unit of the deviations."""
        return "arcsec" if self.before.rotary else "um"


def _steps(rng: Generator) -> Machine:
    """An axis with one to three steps in its error: joints of racks or scales."""
    axis = plain(rng, waves=False)
    places = axis.low + axis.length * rng.uniform(0.1, 0.9, int(rng.integers(1, 4)))
    heights = rng.choice([-1.0, 1.0], places.size) * rng.uniform(2, 8, places.size)
    joints = Curve(
        lambda x: (x[None, :] > places[:, None]).astype(float), heights, np.full(places.size, 5.0)
    )
    return replace(axis, mean=total(axis.mean, joints))


def _ten(rng: Generator) -> Machine:
    return replace(plain(rng), runs=10)


def _tilting(rng: Generator) -> Machine:
    """A table that turns to and fro, within a turn."""
    high = float(rng.choice([90.0, 120.0, 240.0]))
    phases, waves = rng.uniform(0, 2 * np.pi, 3), rng.normal(size=3) * rng.uniform(2, 10)
    axis = plain(rng, waves=False)
    targets = dithered(rng, 0, high, int(rng.integers(9, 26)))
    mean = turning(waves * np.array([1, 0.6, 0.4]) * 180 / high, phases, 6.0)
    return replace(axis, low=0.0, high=high, mean=mean, targets=targets, rotary=True, told=())


OWN = {"steps": _steps, "n = 10": _ten, "rotary, limited": _tilting}

#: Left out: what a job has to declare for all its axes at once.
LEFT_OUT = ("temperature within its uncertainty",)
FLEET = [
    *OWN,
    *(name for name in KINDS if name not in LEFT_OUT and not name.startswith("pitch un")),
]
FLEET += ["pitch unknown"]


def axis_of(kind: str, number: int, name: str, size: float | None = None) -> Axis:
    """Return an axis of a kind with both its tests, always the same one; its error has ``size`` µm
    from lowest to highest, else what its kind has, or 1 to 60.
    """
    rng = name_seed(f"{kind}, loaded", number, ord(name))
    machine = replace((OWN.get(kind) or KINDS[kind])(rng), mode="auto")
    if size or rng.uniform() < 0.5:  # half of the others are as large as their kind is
        machine = sized(machine, size or float(np.exp(rng.uniform(np.log(1.0), np.log(60.0)))))
    after = _measured_later(machine, rng)
    return Axis(name, kind, machine, after, _spacing(machine, rng), _spread(after, rng))


def sized(machine: Machine, size: float) -> Machine:
    """Return the machine with an error of ``size`` µm from lowest to highest."""
    x = np.linspace(machine.low, machine.high, 500)
    factor = size / float(np.ptp(machine.error(x)))
    return replace(
        machine, mean=_times(machine.mean, factor), reversal=_times(machine.reversal, factor)
    )


def _times(curve: Curve, factor: float) -> Curve:
    return Curve(curve.shapes, curve.weights * factor, curve.sizes)


def earlier(axis: Axis, rng: Generator) -> Machine:
    """The axis as it was years ago: its curves with other weights."""
    mean = axis.before.mean
    weights = mean.weights * rng.uniform(0.2, 1.3, mean.weights.size)
    return replace(
        axis.before,
        mean=Curve(mean.shapes, weights, mean.sizes),
        reversal=_times(axis.before.reversal, float(rng.uniform(0.3, 1.2)))
        if rng.uniform() < 0.7
        else constant(-2.0),
        signs=(1, -1),
        runs=max(axis.before.runs, 3),
        missing=0.0,
    )


def _measured_later(machine: Machine, rng: Generator) -> Machine:
    """Now and then with other targets, other runs, more noise, or in one direction."""
    after = machine
    chance = rng.uniform(size=4)
    if chance[0] < 0.35:
        count = int(np.clip(machine.targets.size * rng.uniform(0.7, 1.6), 5, 120))
        after = replace(after, targets=dithered(rng, machine.low, machine.length, count))
    if chance[1] < 0.25 and machine.runs > 1:
        after = replace(after, runs=int(rng.choice([2, 3, 5, 7, 10])))
    if chance[2] < 0.25:
        after = loud(after, sigma=machine.noise.sigma * float(rng.uniform(0.7, 1.5)))
    if chance[3] < 0.06:
        after = replace(after, signs=(1,) if rng.uniform() < 0.5 else (-1,))
    return after


def _spacing(machine: Machine, rng: Generator) -> float | str:
    """What tables have: ten to forty sections, or what the tool thinks best."""
    if rng.uniform() < 0.3:
        return "auto"
    if machine.turn:
        return float(rng.choice([10.0, 15.0, 20.0, 30.0]))
    usual = np.array([1, 2, 2.5, 5, 10, 15, 20, 25, 30, 40, 50, 60, 75, 100, 150, 200, 250])
    wanted = machine.length / rng.uniform(8, 40)
    usual = usual[machine.length % usual == 0]
    return float(usual[np.argmin(np.abs(usual - wanted))])


def _spread(machine: Machine, rng: Generator) -> float:
    """Pooled true standard deviation of a reading about its mean, with all that scatters."""
    if machine.runs == 1:
        return float(np.sqrt((machine.scales(_along(machine)) ** 2).mean()))
    blocks = [machine.scatter(machine.targets, rng) for _ in range(60)]
    return float(np.sqrt(np.mean([block.var(axis=2, ddof=1).mean() for block in blocks])))


def _along(machine: Machine) -> Floats:
    return np.asarray((machine.targets - machine.low) / machine.length)


def job_axis(axis: Axis, address: str, options: dict[str, Any]) -> dict[str, Any]:
    """Return the axis as its job says it."""
    machine = axis.before
    entry: dict[str, Any] = {
        "travel": [machine.low, machine.high],
        "address": address,
        "before": [f"{axis.name}.csv"],
        "table": {"spacing": axis.spacing, "mode": machine.mode},
    }
    if options:
        entry["options"] = options
    if machine.rotary:
        entry["kind"] = "rotary"
    if machine.turn:
        entry["modulo"] = machine.turn
    if machine.told:
        entry["screw_pitch"] = list(machine.told)
    return entry
