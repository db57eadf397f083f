"""Jobs on variations of the real FANUC backup and the real SINUMERIK archive, where these lie.

Only the generators of the old tree's tests and their virtual controls are used.
"""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np

#: One real job for so many random ones of a control.
SHARE = 4
WHOLE_EVERY = 10


def write_real_jobs(root: Path, jobs: int, first: int, chosen: list[str]) -> list[str]:
    """Write the jobs below ``root``; return their folders."""
    real = importlib.import_module("places").REAL
    names = []
    count = (jobs + SHARE - 1) // SHARE
    for deal, write, there in (
        ("real-fanuc", _fanuc, real / "fanuc"),
        ("real-sinumerik", _sinumerik, real / "siemens" / "dmu_840d_sl.arc"),
    ):
        if (chosen and deal not in chosen) or not there.exists():
            continue
        for seed in range(first, first + count):
            names.append(f"{deal}/{seed:05d}")
            write(seed, root / names[-1])
    return names


def _fanuc(seed: int, folder: Path) -> None:
    from same_jobs import later_commands, option_words, write_job
    from same_machines import MachineAxis

    deals = importlib.import_module("backup_deal_fanuc")
    jobs = importlib.import_module("backup_jobs_fanuc")
    virtual = importlib.import_module("virtual_fanuc")
    ((family, own),) = deals.deal(1, seed)
    job = deals.make(family, own, whole=seed % WHOLE_EVERY == 0)
    really = dict(job.really if job.really is not None else job.files or {})
    control = virtual.VirtualFanuc(
        virtual.loaded(really.values()), older=job.format == "fanuc-0i-16i"
    )
    rng = np.random.default_rng([job.seed, 7])
    files: dict[str, Any] = dict(job.files or {})
    axes: list[MachineAxis] = []
    for axis in job.axes:

        def acting(x: Any, d: int, axis: Any = axis) -> Any:
            try:
                return control.correction(axis.address, x, d, home=axis.home, rapid=axis.rapid)
            except virtual.NotKnownError:
                return np.zeros_like(x)

        x = jobs.dithered(rng, axis.measured, axis.targets)
        text = jobs.csv(axis.name, axis.rotary, x, axis.physics.read(rng, x, acting))
        files[f"{axis.name}.csv"] = text.encode()
        axes.append(_like(axis.name, str(axis.address), axis.address, axis.rotary, axis.travel))
    options = option_words(job.options)
    names = sorted(job.files or {})
    commands = [["run", "job.yaml"], *later_commands(rng, job.format, options, axes)]
    if names:
        commands.insert(0, ["new", "--from", *names, "--format", job.format, *options])
        commands[0] += ["--out", "new.yaml"]
        commands.insert(1, ["decode", *names, "--format", job.format, *options])
    write_job(folder, files, job.yaml(), axes, commands)


def _sinumerik(seed: int, folder: Path) -> None:
    from same_jobs import later_commands, option_words, write_job

    cases = importlib.import_module("backup_variations_sinumerik")
    judge = importlib.import_module("sinumerik_judge")
    case = cases.case_of(seed)
    rng = np.random.default_rng([230, seed])
    error = judge.error_of(case, rng)
    control = judge.control_before(case)
    targets = judge.targets_of(case, rng, int(rng.integers(13, 24)))
    folder.mkdir(parents=True)
    readings = judge.measure(control, case, error, targets, rng)
    job = judge.write_job(folder, case, readings, targets).read_text()
    axis = _like(case.letter, case.address, 1, case.rotary, case.travel)
    options = option_words(case.options)
    names = [f"control/{file}" for file in case.given()]
    new = ["new", "--from", *names, "--format", case.format, *options, "--out", "new.yaml"]
    commands = [new, ["decode", *names, "--format", case.format, *options], ["run", "job.yaml"]]
    commands += later_commands(rng, case.format, options, [axis])
    write_job(folder, {}, job, [axis], commands)


def _like(
    name: str,
    address: str,
    number: int,
    rotary: bool,  # noqa: FBT001
    travel: tuple[float, float],
) -> Any:
    """An axis of the random jobs in the place of the real one, for the test after loading."""
    from same_machines import random_axis

    axis = random_axis(np.random.default_rng(number), name, address, number)
    axis.rotary, axis.travel = rotary, travel
    return axis
