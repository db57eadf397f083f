"""Commands that write, run and verify a job."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from compwright.cli.saying import answer, errors, json_file, next_step_line, print_lines, tell
from compwright.cli.words import (
    FILE_WORD,
    PATH,
    Invocation,
    complete_format,
    compwright,
    control_options,
    exiting,
    force_option,
    format_option,
    json_option,
    pairs,
    profile_option,
    report_option,
    state_option,
)


@compwright.command(
    "run",
    examples=(
        "compwright run job.yaml",
        "compwright run before/y.csv --format 840d-sl --axis Y --travel -600:0 --state none",
    ),
    page="docs/commands.md#run, docs/job-file.md",
)
@click.argument(
    "inputs",
    nargs=-1,
    required=True,
    metavar="JOB.yaml|FILE...",
    type=PATH,
    help="The job file; or measurement files with --format, --axis, --travel and --state.",
)
@click.option(
    "--format",
    "format_id",
    metavar="ID",
    shell_complete=complete_format,
    help="Without a job file: the control's id (compwright formats list), or your own definition.",
)
@click.option("--axis", metavar="NAME", help="Without a job file: the axis that was measured.")
@click.option(
    "--travel",
    metavar="LO:HI",
    help="Without a job file: travel of the axis in machine coordinates, mm or deg.",
)
@state_option
@control_options
@profile_option
@click.option(
    "--out",
    type=PATH,
    help="Folder for the results; default: next to the job file, with its name.",
)
@click.option(
    "--accept-worse", is_flag=True, help="Write a table even if it would not improve the axis."
)
@report_option
@json_option
@force_option
@exiting
@click.pass_obj
def run_command(
    invocation: Invocation,
    /,
    inputs: tuple[Path, ...],
    out: Path | None,
    json_path: Path | None,
    **words: Any,
) -> int:
    """Do the whole job: evaluate, fit, write the tables, predict, report."""
    from compwright.workflow.commands.run import planned, write_planned
    from compwright.workflow.inputs.jobs import job_of
    from compwright.workflow.preloading import ready_for_axes
    from compwright.workflow.results.answers import run_summary
    from compwright.workflow.results.next_step import after_run
    from compwright.workflow.results.report_file import require_report_form

    require_report_form(words["report"], ".pdf")
    requested = job_of(
        invocation.session,
        [str(path) for path in inputs],
        format_id=words["format_id"],
        axis=words["axis"],
        travel=words["travel"],
        states=words["states"],
        options=words["options"],
        profile=None if words["profile"] is None else str(words["profile"]),
        out=out,
    )
    with invocation.crew(len(requested.job.axes), ready_for_axes) as each:
        job = planned(
            invocation.session,
            requested.job,
            requested.folder,
            requested.out,
            stated=requested.stated,
            accept_worse=words["accept_worse"],
            each=each,
        )
    outcome = write_planned(
        invocation.session,
        job,
        requested.out,
        force=words["force"],
        json_path=json_file(json_path),
        report=words["report"],
    )
    answer(outcome.prediction, json_path, lambda: run_summary(outcome))
    errors(filter(None, [outcome.no_tables]))
    errors(f"axis {name}: no table is written: {why}" for name, why in outcome.refused.items())
    for note in outcome.notes:
        tell(f"note: {note}")
    errors(
        entry["message"]
        for entry in outcome.findings
        if entry["severity"] == "error" and entry["code"] != "CW-P001"
    )
    next_step_line(
        json_path,
        lambda: after_run(
            outcome,
            requested.out / "job.yaml" if requested.stated is not None else inputs[0],
            requested.out,
            apart=out is not None and requested.stated is None,
        ),
    )
    return outcome.exit_code


@compwright.command(
    examples=(
        "compwright new --from control --format 840d-sl --out new.yaml",
        "compwright new --from 'control/*.INI' --format 840d-sl --out x.yaml",
    ),
    page="docs/commands.md#new, docs/job-file.md",
)
@click.option(
    "--from",
    "files",
    multiple=True,
    required=True,
    type=PATH,
    metavar="FILE...",
    help="Files of the control, or a folder of them.",
)
@format_option
@control_options
@click.option("--out", required=True, type=PATH, metavar="JOB.yaml", help="The job file to write.")
@force_option
@exiting
@click.pass_obj
def new(
    invocation: Invocation,
    /,
    files: tuple[Path, ...],
    format_id: str,
    options: tuple[str, ...],
    out: Path,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Write a job file, filled in from the control's own files."""
    from compwright.workflow.commands.new import new_job

    outcome = new_job(invocation.session, files, format_id, pairs(options), out, force=force)
    print_lines([str(outcome.path)])
    for line in outcome.open:
        tell(f"fill in: {line}")
    for line in outcome.left_out:
        tell(f"note: {line}")
    return 0


@compwright.command(
    examples=(
        "compwright verify job.yaml --after after/y.csv",
        "compwright verify job.yaml --after after/y.csv --loaded read_back --update --force",
    ),
    page="docs/commands.md#verify, docs/verification.md",
)
@click.argument("job_file", metavar="JOB.yaml", type=PATH, help="The job whose tables were loaded.")
@click.option(
    "--after",
    multiple=True,
    required=True,
    type=FILE_WORD,
    metavar="[TEST=]FILE...",
    help=(
        "Measurement files of the tests after loading; TEST: name of the test in the job that"
        " was repeated."
    ),
)
@click.option(
    "--plan",
    type=PATH,
    help="Result folder of compwright run, or its plan.json; default: that of the job file.",
)
@click.option(
    "--loaded",
    multiple=True,
    type=PATH,
    metavar="FILE...",
    help="Files that were read back from the control, or folders of them.",
)
@click.option(
    "--out", type=PATH, help="Folder for the results; default: the result folder of compwright run."
)
@click.option(
    "--update",
    is_flag=True,
    help="Also write the tables of the next correction round (next/ in --out); needs --loaded.",
)
@profile_option
@report_option
@json_option
@force_option
@exiting
@click.pass_obj
def verify(
    invocation: Invocation,
    /,
    job_file: Path,
    after: tuple[str, ...],
    plan: Path | None,
    loaded: tuple[Path, ...],
    out: Path | None,
    profile: Path | None,
    json_path: Path | None,
    report: Path | None,
    **words: bool,
) -> int:
    """Compare the test after loading with the plan: is the table active, is the axis good?"""
    from compwright.workflow.commands.verify import plan_path, verify_job
    from compwright.workflow.inputs.jobs import default_folder, read_job_file
    from compwright.workflow.preloading import ready_for_axes
    from compwright.workflow.results.answers import verify_summary
    from compwright.workflow.results.next_step import after_verify
    from compwright.workflow.results.report_file import require_report_form

    require_report_form(report, ".pdf")
    folder = default_folder(invocation.session, job_file)
    plan_file = plan_path(invocation.session, plan, folder)
    job = read_job_file(invocation.session, job_file, plan_file)
    with invocation.crew(len(job.axes) if words["update"] else 1, ready_for_axes) as each:
        outcome = verify_job(
            invocation.session,
            job,
            after,
            plan_file=plan_file,
            out=out or folder,
            loaded=loaded,
            force=words["force"],
            json_path=json_file(json_path),
            report=report,
            update=words["update"],
            profile=profile,
            each=each,
        )
    answer(outcome.document, json_path, lambda: verify_summary(outcome))
    for note in outcome.notes:
        tell(f"note: {note}")
    next_step_line(
        json_path,
        lambda: after_verify(
            outcome,
            job_file,
            out or folder,
            after,
            plan=plan_file if plan is not None or out is not None else folder,
            given=[
                word
                for option, path in (("--plan", plan), ("--out", out), ("--profile", profile))
                if path is not None
                for word in (option, path)
            ],
            read_back=bool(loaded),
        ),
    )
    return outcome.exit_code
