"""``demo``: the whole loop on a virtual machine: measure, compensate, load, measure again,
verify.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from compwright.foundations import storage
from compwright.foundations.input_sizes import JOB
from compwright.foundations.session import Session
from compwright.foundations.side_by_side import Crew, alone
from compwright.jobs.reading import read_job
from compwright.workflow.commands.run import RunOutcome, planned, write_planned
from compwright.workflow.commands.simulate import load_machine, simulate_files
from compwright.workflow.commands.verify import VerifyOutcome, verify_job
from compwright.workflow.ready import ready_for_axes
from compwright.workflow.results.own_files import write_listed


@dataclass(frozen=True, slots=True)
class DemoOutcome:
    """The two halves of the demo and where their pages are."""

    run: RunOutcome
    verification: VerifyOutcome
    folder: Path


def run_demo(
    session: Session, out: Path, *, force: bool = False, crew: Crew = alone
) -> DemoOutcome:
    """Play the whole loop below ``out``: machine, measurement, job, tables, measurement with the
    tables loaded, verification.

    ``crew``: who works on the axes. Raises StorageError when a file exists (unless ``force``) or
    cannot be written.
    """
    shipped = storage.demo_files(session)
    files = {name: shipped[name] for name in ("machine.yaml", "job.yaml")}
    machine_file, job_file = write_listed(
        session, out, files, command="demo", force=force, as_set=True
    )
    machine = load_machine(session, machine_file)
    simulate_files(session, machine, out / "before", seed=1, force=force)
    job = read_job(storage.read_bytes(session, job_file, JOB), str(job_file))
    result = out / "job"
    with crew(len(job.axes), ready_for_axes) as each:
        worked = planned(session, job, out, result, each=each)
    run = write_planned(session, worked, result, force=force)
    tables = result / "tables" / job.format
    after = simulate_files(session, machine, out / "after", seed=2, tables=tables, force=force)
    verification = verify_job(
        session,
        job,
        [str(path) for path in after],
        plan_file=result / "plan.json",
        out=result,
        force=force,
    )
    return DemoOutcome(run=run, verification=verification, folder=out)
