"""``demo``: the whole sequence on a virtual machine: measure, compensate, load, measure again,
verify.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

from compwright.foundations import storage
from compwright.foundations.input_sizes import JOB
from compwright.foundations.parallel_work import Crew, alone
from compwright.foundations.session import Session
from compwright.jobs.reading import read_job
from compwright.workflow.commands.run import RunOutcome, planned, write_planned
from compwright.workflow.commands.simulate import load_machine, simulate_files
from compwright.workflow.commands.verify import VerifyOutcome, verify_job
from compwright.workflow.preloading import ready_for_axes
from compwright.workflow.results.own_files import write_listed


@dataclass(frozen=True, slots=True)
class DemoStep:
    """A step of the demo: its name, its folder, how many files it wrote, their total size (bytes),
    and its duration (s).
    """

    what: str
    folder: Path
    files: int
    size: int
    seconds: float


@dataclass(frozen=True, slots=True)
class DemoOutcome:
    """The steps of the demo, and the results of its ``run`` and its ``verify``."""

    steps: tuple[DemoStep, ...]
    run: RunOutcome
    verification: VerifyOutcome
    folder: Path


def run_demo(
    session: Session, out: Path, *, force: bool = False, crew: Crew = alone
) -> DemoOutcome:
    """Run the whole demo in the folder ``out``: measure, compensate, measure again, verify.

    ``crew``: the processes that work on the axes. Raises StorageError if a file exists (unless
    ``force``) or cannot be written.
    """
    clock = _Clock()
    shipped = storage.demo_files(session)
    files = {name: shipped[name] for name in ("machine.yaml", "job.yaml")}
    machine_file, job_file = write_listed(
        session, out, files, command="demo", force=force, as_set=True
    )
    machine = load_machine(session, machine_file)
    before = simulate_files(session, machine, out / "before", seed=1, force=force)
    measured = clock.step(
        f"measure a virtual machine of {len(before)} axes", out / "before", before
    )
    job = read_job(storage.read_bytes(session, job_file, JOB), str(job_file))
    result = out / "job"
    with crew(len(job.axes), ready_for_axes) as each:
        worked = planned(session, job, out, result, each=each)
    run = write_planned(session, worked, result, force=force)
    written = clock.step("run: tables, prediction, report, card", result, run.files)
    tables = result / "tables" / job.format
    after = simulate_files(session, machine, out / "after", seed=2, tables=tables, force=force)
    again = clock.step("load the tables, measure again", out / "after", after)
    verification = verify_job(
        session,
        job,
        [str(path) for path in after],
        plan_file=result / "plan.json",
        out=result,
        force=force,
    )
    judged = clock.step("verify: are the tables active?", result, verification.files)
    steps = (measured, written, again, judged)
    return DemoOutcome(steps=steps, run=run, verification=verification, folder=out)


class _Clock:
    """Measures how long each step takes."""

    def __init__(self) -> None:
        self._began = perf_counter()

    def step(self, what: str, folder: Path, files: Sequence[Path]) -> DemoStep:
        """Return a finished step of the demo, with the time (s) since the previous step ended."""
        now = perf_counter()
        seconds, self._began = now - self._began, now
        return DemoStep(what, folder, len(files), storage.size_of(files), seconds)
