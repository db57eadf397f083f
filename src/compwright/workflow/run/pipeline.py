"""Run all stages of a job one after the other."""

from __future__ import annotations

from pathlib import Path

from compwright.foundations.parallel_work import Each, in_turn
from compwright.foundations.session import Session
from compwright.records.job import Job
from compwright.workflow.run.estimate_stage import wanted
from compwright.workflow.run.export_stage import written
from compwright.workflow.run.input_stage import measured
from compwright.workflow.run.prediction_stage import predicted
from compwright.workflow.run.run_results import Finished
from compwright.workflow.run.table_stage import fitted


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
