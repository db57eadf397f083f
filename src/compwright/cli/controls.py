"""Commands for the files of a control."""

from __future__ import annotations

from pathlib import Path

import click

from compwright.cli.saying import deliver, print_lines, tell
from compwright.cli.words import (
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
    state_option,
)


@compwright.command(
    examples=(
        "compwright decode control --format 840d-sl",
        "compwright decode control --format 840d-sl --at -600:0:50 --json decoded.json",
    ),
    page="docs/commands.md#decode",
)
@click.argument(
    "paths",
    nargs=-1,
    required=True,
    metavar="FILE...",
    type=PATH,
    help="Files of the control, or a folder of them.",
)
@format_option
@control_options
@click.option("--axis", metavar="ADDRESS", help="Show only this axis, named as in the control.")
@click.option(
    "--at",
    metavar="LIST",
    help="Positions to show: numbers and LO:HI:STEP, with commas; default: the table points.",
)
@json_option
@force_option
@exiting
@click.pass_obj
def decode(
    invocation: Invocation,
    /,
    paths: tuple[Path, ...],
    format_id: str,
    options: tuple[str, ...],
    axis: str | None,
    at: str | None,
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Show the corrections that a control makes from these files."""
    from compwright.workflow.commands.decode import decoded_files
    from compwright.workflow.results.answers import decode_summary

    _, _, document = decoded_files(
        invocation.session, paths, format_id, pairs(options), axis=axis, at=at
    )
    deliver(invocation.session, document, json_path, lambda: decode_summary(document), force=force)
    return 0


@compwright.command(
    examples=(
        "compwright export job/plan.json --format 840d-sl --out again",
        "compwright export job/plan.json --format 828d --state none --out other",
    ),
    page="docs/commands.md#export",
)
@click.argument(
    "plan",
    metavar="PLAN.json",
    type=PATH,
    help="plan.json of a run, or the result folder that contains it.",
)
@format_option
@control_options
@state_option
@click.option(
    "--out", required=True, type=PATH, help="Folder into which the control's files are written."
)
@force_option
@exiting
@click.pass_obj
def export(
    invocation: Invocation,
    /,
    plan: Path,
    format_id: str,
    options: tuple[str, ...],
    states: tuple[str, ...],
    out: Path,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Write the tables of a plan again, for its control or another."""
    from compwright.workflow.commands.export import export_plan
    from compwright.workflow.commands.verify import plan_path

    file = plan_path(invocation.session, plan, plan)
    outcome = export_plan(
        invocation.session, file, format_id, pairs(options), states, out, force=force
    )
    for entry in outcome.assumed:
        tell(f"assumed: {entry.fact} = {entry.value} ({entry.evidence})")
    for name in outcome.missing:
        tell(f"note: axis {name} has no table in this plan")
    for finding in outcome.findings:
        tell(f"{finding.severity}: {finding.message}")
    print_lines(map(str, outcome.files))
    return 1 if any(finding.severity == "error" for finding in outcome.findings) else 0


@compwright.command(
    examples=(
        "compwright compare job --loaded read_back",
        "compwright compare job/plan.json --loaded read_back --json compared.json",
    ),
    page="docs/commands.md#compare",
)
@click.argument(
    "plan",
    metavar="PLAN.json",
    type=PATH,
    help="plan.json of a run, or the result folder that contains it.",
)
@click.option(
    "--loaded",
    multiple=True,
    required=True,
    type=PATH,
    metavar="FILE...",
    help="Files that were read back from the control, or folders of them.",
)
@json_option
@force_option
@exiting
@click.pass_obj
def compare(
    invocation: Invocation,
    /,
    plan: Path,
    loaded: tuple[Path, ...],
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Compare the control's contents with the plan."""
    from compwright.workflow.commands.compare import compare_plan
    from compwright.workflow.commands.verify import plan_path
    from compwright.workflow.results.answers import compare_summary

    outcome = compare_plan(invocation.session, plan_path(invocation.session, plan, plan), loaded)
    deliver(
        invocation.session,
        outcome.document,
        json_path,
        lambda: compare_summary(outcome.document),
        force=force,
    )
    return outcome.exit_code


@compwright.command(
    examples=(
        "compwright diff control --with read_back --format 840d-sl",
        "compwright diff control --with read_back --format 840d-sl --json diff.json",
    ),
    page="docs/commands.md#diff",
)
@click.argument(
    "old",
    nargs=-1,
    required=True,
    metavar="OLD...",
    type=PATH,
    help="The earlier backup; files or folders.",
)
@click.option(
    "--with",
    "new",
    multiple=True,
    required=True,
    type=PATH,
    metavar="NEW...",
    help="The later backup of the same machine; files or folders.",
)
@format_option
@control_options
@json_option
@force_option
@exiting
@click.pass_obj
def diff(
    invocation: Invocation,
    /,
    old: tuple[Path, ...],
    new: tuple[Path, ...],
    format_id: str,
    options: tuple[str, ...],
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """List the differences between two backups of one machine."""
    from compwright.workflow.commands.diff import diff_files
    from compwright.workflow.results.answers import diff_summary

    outcome = diff_files(invocation.session, old, new, format_id, pairs(options))
    deliver(
        invocation.session,
        outcome.document,
        json_path,
        lambda: diff_summary(outcome.document),
        force=force,
    )
    return outcome.exit_code


@compwright.group(
    examples=("compwright formats list", "compwright formats show 840d-sl"),
    page="docs/controls.md, docs/formats.md",
)
def formats() -> None:
    """List, show and check the definitions of the controls."""


@formats.command(
    "list",
    examples=("compwright formats list",),
    page="docs/controls.md",
)
@exiting
@click.pass_obj
def formats_list(invocation: Invocation, /) -> int:
    """List the controls by maker, with the names that are understood and the evidence."""
    from compwright.workflow.commands.formats import list_formats

    print_lines(list_formats(invocation.session))
    return 0


@formats.command(
    "show",
    examples=(
        "compwright formats show 840d-sl",
        "compwright formats show definitions/own.yaml",
    ),
    page="docs/controls.md",
)
@click.argument(
    "format_id",
    metavar="ID|FILE",
    shell_complete=complete_format,
    help="Id of a control, or the file of your own definition.",
)
@exiting
@click.pass_obj
def formats_show(invocation: Invocation, /, format_id: str) -> int:
    """Show what a control can hold, its options, and how well each fact is known."""
    from compwright.workflow.commands.formats import show_format

    print_lines(show_format(invocation.session, format_id))
    return 0


@formats.command(
    "check",
    examples=(
        "compwright formats check",
        "compwright formats check definitions/own.yaml",
    ),
    page="docs/formats.md",
)
@click.argument(
    "paths",
    nargs=-1,
    metavar="[PATH...]",
    type=PATH,
    help=(
        "Definition files of controls, or folders of them; default: those shipped with compwright."
    ),
)
@exiting
@click.pass_obj
def formats_check(invocation: Invocation, /, paths: tuple[Path, ...]) -> int:
    """Check definitions: those that ship with compwright, or files and folders of your own."""
    from compwright.workflow.commands.formats import check_formats

    print_lines(check_formats(invocation.session, paths))
    return 0
