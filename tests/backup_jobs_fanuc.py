"""An axis with its errors, its test, and the job around it; and the list of families of such jobs.
Positions mm or degrees.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from backup_files_fanuc import PARAMETERS, PITCH, Backup, Rng
from virtual_fanuc import Floats

RUNS = 5

# --- the axis
# --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Physics:
    """Deviations of an axis without any table, in mm or degrees: waves, a slope, lost motion, noise
    per reading.
    """

    travel: tuple[float, float]
    waves: tuple[tuple[float, float, float], ...]
    slope: float
    lost: float
    noise: float
    unit: float = 1e-3

    def error(self, x: Floats, direction: int) -> Floats:
        """Lost motion: the axis stays behind in its direction of motion."""
        total = self.slope * x - direction * self.lost / 2
        for height, period, phase in self.waves:
            total = total + height * np.sin(2 * np.pi * x / period + phase)
        return np.asarray(self.unit * total)

    def read(
        self, rng: Rng, x: Floats, correction: Callable[[Floats, int], Floats]
    ) -> dict[int, Floats]:
        """Deviations measured minus target, targets by runs, for each direction; one datum for the
        whole test.
        """
        datum = rng.normal(0, 3) * self.unit
        mean = {d: self.error(x, d) + correction(x, d) + datum for d in (1, -1)}
        return {
            d: mean[d][:, None] + rng.normal(0, self.noise * self.unit, (x.size, RUNS))
            for d in (1, -1)
        }


def linear_physics(
    rng: Rng, travel: tuple[float, float], quantum_um: float = 1.0, lead: float = 10.0
) -> Physics:
    length = travel[1] - travel[0]
    scale = max(1.0, quantum_um)
    waves = (
        (scale * rng.uniform(4, 12), length * rng.uniform(0.7, 1.6), rng.uniform(0, 6)),
        (scale * rng.uniform(1, 3), length * rng.uniform(0.3, 0.5), rng.uniform(0, 6)),
        (rng.uniform(0, 0.4), lead, rng.uniform(0, 6)),
    )
    return Physics(
        travel, waves, rng.uniform(-0.02, 0.02), rng.uniform(-2, 6), rng.uniform(0.2, 0.5)
    )


def rotary_physics(rng: Rng, travel: tuple[float, float], quantum_arcsec: float = 0.36) -> Physics:
    scale = max(1.0, quantum_arcsec / 1.5)
    waves = (
        (scale * rng.uniform(6, 14), 360.0, rng.uniform(0, 6)),
        (scale * rng.uniform(1, 4), 180.0, rng.uniform(0, 6)),
    )
    return Physics(travel, waves, 0.0, rng.uniform(-2, 6), rng.uniform(0.2, 0.5), 1 / 3600)


def dithered(rng: Rng, travel: tuple[float, float], count: int) -> Floats:
    """The i-th target at (i + 0.5 + u) of its share of the travel, u within 0.3, at least 4 mm
    (degrees) from the ends.
    """
    low, high = travel
    places = low + (np.arange(count) + 0.5 + rng.uniform(-0.3, 0.3, count)) * (high - low) / count
    return np.asarray(np.round(np.clip(places, low + 4, high - 4), 3), dtype=np.float64)


def csv(axis: str, rotary: bool, x: Floats, readings: Mapping[int, Floats]) -> str:
    unit, factor = ("arcsec", 3600.0) if rotary else ("um", 1000.0)
    lines = [f"# axis: {axis}", "# deviation: measured minus target", "# cycle: standard"]
    lines.append(f"target_{'deg' if rotary else 'mm'},direction,run,deviation_{unit}")
    for run in range(RUNS):
        for d, sign in ((1, "+"), (-1, "-")):
            order = range(x.size) if d > 0 else reversed(range(x.size))
            lines.extend(
                f"{x[i]:.3f},{sign},{run + 1},{factor * readings[d][i, run]:.3f}" for i in order
            )
    return "\n".join(lines) + "\n"


# --- the jobs
# --------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class AxisJob:
    """One axis of a job: how the job words it, and what it is."""

    name: str
    address: int
    travel: tuple[float, float]
    physics: Physics
    targets: int = 25
    rotary: bool = False
    home: int = 1
    words: Mapping[str, str] = field(default_factory=dict)
    #: with which motion the test is really taken, and whether the job says so
    rapid: bool = False
    says_motion: bool = True
    #: the job names no address: the letter is in 1020
    by_name: bool = False
    #: what the fresh test runs over, where it is not the travel of the job
    true_travel: tuple[float, float] | None = None

    @property
    def measured(self) -> tuple[float, float]:
        return self.true_travel or self.travel


@dataclass(frozen=True)
class Job:
    """A job on a variation of the backup; ``files`` None: state ``none``; ``really``: what is in
    the control, if that differs.
    """

    family: str
    seed: int
    mark: str
    axes: tuple[AxisJob, ...]
    files: Mapping[str, bytes] | None
    names: tuple[str, ...] = ()
    options: Mapping[str, str] = field(default_factory=dict)
    format: str = "fanuc-30i"
    really: Mapping[str, bytes] | None = None

    @property
    def title(self) -> str:
        return f"{self.family}-{self.seed}"

    def yaml(self, today: bool = True) -> str:
        """The job file; ``today`` False words it for a version that asks for the detection unit."""
        options = dict(self.options)
        if not today:
            options.setdefault("detection_unit", "0.0001")
        text = ["compwright: 1", f"controller: {{format: {self.format}, options: {flow(options)}}}"]
        text.append(
            "states: {as_found: "
            + ("none" if self.files is None else f"[{', '.join(self.files)}]")
            + "}"
        )
        text.append("axes:")
        for axis in self.axes:
            words = {"kind": "rotary" if axis.rotary else "linear", **axis.words}
            words = {
                **({} if axis.by_name else {"address": str(axis.address)}),
                **words,
                "travel": f"[{axis.travel[0]:g}, {axis.travel[1]:g}]",
            }
            test = {"files": f"[{axis.name}.csv]", "name": f"{axis.name.lower()}_before"}
            if axis.rapid and axis.says_motion:
                test["motion"] = "rapid"
            words |= {"before": f"[{flow(test)}]"}
            if axis.home < 0:
                words["reference_return"] = '"-"'
            name = f'"{axis.name}"' if axis.name == "Y" else axis.name
            text.append(f"  {name}: {flow(words)}")
        return "\n".join(text) + "\n"


def flow(words: Mapping[str, str]) -> str:
    return "{" + ", ".join(f"{key}: {value}" for key, value in words.items()) + "}"


#: The axes of the real machine: name, travel that a test runs over, point numbers of the real
#: table.
REAL_AXES = {
    1: ("X", (-1000.0, 0.0)),
    2: ("Y", (-1050.0, 0.0)),
    3: ("Z", (-780.0, 0.0)),
    4: ("B", (0.0, 360.0)),
}


def axis_job(rng: Rng, address: int = 0, quantum: float = 1.0, **words: Any) -> AxisJob:
    """A random axis of the real machine with random errors; ``quantum``: the step in µm (arcsec)
    that these must exceed.
    """
    address = address or int(rng.integers(1, 4))
    name, travel = REAL_AXES[address]
    if address == 4:
        yaml = {"modulo": "360"}
        return replace(
            AxisJob(
                name,
                address,
                travel,
                rotary_physics(rng, travel, quantum),
                int(rng.integers(24, 40)),
                True,
                words=yaml,
            ),
            **words,
        )
    yaml = {"screw_pitch": "10"} if rng.random() < 0.5 else {}
    physics = linear_physics(rng, travel, quantum)
    return replace(
        AxisJob(name, address, travel, physics, int(rng.integers(22, 32)), words=yaml), **words
    )


def alike(backup: Backup, address: int) -> Backup:
    """One value of backlash for feed and rapid: nothing then hangs on the motion of the test."""
    return backup.set(1852, f"A{address}", backup.get(1851, f"A{address}"))


Family = Callable[[Rng, bool], Job]
FAMILIES: dict[str, Family] = {}


def family(make: Family) -> Family:
    FAMILIES[make.__name__] = make
    return make


def job_on(
    mark: str, axis: AxisJob | tuple[AxisJob, ...], backup: Backup | None, *names: str, **words: Any
) -> Job:
    axes = axis if isinstance(axis, tuple) else (axis,)
    files = None if backup is None else backup.files()
    return replace(Job("", 0, mark, axes, files, names), **words)


def both_files(backup: Backup) -> tuple[bytes, bytes]:
    return backup.files()[PARAMETERS], backup.files()[PITCH]


def reopen(job: Job) -> Backup:
    assert job.files is not None
    return Backup(job.files[PARAMETERS], job.files[PITCH])


def state_files(job: Job, folder: Path) -> None:
    for name, text in (job.files or {}).items():
        (folder / name).write_bytes(text)
