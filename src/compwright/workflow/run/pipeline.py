"""Run all stages of a job one after the other."""

from __future__ import annotations

from pathlib import Path

from compwright.foundations.session import Session
from compwright.foundations.side_by_side import Each, in_turn
from compwright.records.job import Job
from compwright.workflow.run.finished import Finished
from compwright.workflow.run.fitted import fitted
from compwright.workflow.run.measured import measured
from compwright.workflow.run.predicted import predicted
from compwright.workflow.run.wanted import wanted
from compwright.workflow.run.written import written


def run_stages(
    session: Session,
    job: Job,
    folder: Path,
    out: Path,
    *,
    accept_worse: bool = False,
    each: Each = in_turn,
) -> Finished:
    """Return the results of a job after all five stages of a run. ``accept_worse``: also write
    tables that would not improve their axis.

    ``folder``: the folder of the job's relative paths. ``out``: the folder of its results.
    ``each``: applies a function to all axes. Raises UsageError, InputError and CapacityError.
    """
    start = measured(session, job, folder, out)
    wish = wanted(start, each)
    table = fitted(start, wish, each)
    files = written(start, wish, table, accept_worse=accept_worse, each=each)
    then = predicted(start, wish, table, files, each)
    return Finished(start, wish, table, files, then).decided()
