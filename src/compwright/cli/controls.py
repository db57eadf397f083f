"""Commands about the files of a control."""

from __future__ import annotations

from pathlib import Path

import click

from compwright.cli.saying import deliver, print_lines, tell
from compwright.cli.words import (
    PATH,
    Invocation,
    compwright,
    control_options,
    exiting,
    force_option,
    format_option,
    json_option,
    pairs,
    state_option,
)


@compwright.command()
@click.argument("paths", nargs=-1, required=True, metavar="FILE...", type=PATH)
@format_option
@control_options
@click.option("--axis", metavar="ADDRESS", help="Only this axis, by the control's own name.")
@click.option(
    "--at",
    metavar="LIST",
    help="Positions: numbers and LO:HI:STEP, separated by commas; default: the nodes.",
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
    """Say what a control would do with these files."""
    from compwright.workflow.commands.decode import decoded_files
    from compwright.workflow.results.answers import decode_summary

    _, _, document = decoded_files(
        invocation.session, paths, format_id, pairs(options), axis=axis, at=at
    )
    deliver(invocation.session, document, json_path, lambda: decode_summary(document), force=force)
    return 0


@compwright.command()
@click.argument("plan", metavar="PLAN.json", type=PATH)
@format_option
@control_options
@state_option
@click.option("--out", required=True, type=PATH, help="Folder for the control's files.")
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

    outcome = export_plan(
        invocation.session, plan, format_id, pairs(options), states, out, force=force
    )
    for entry in outcome.assumed:
        tell(f"assumed: {entry.fact} = {entry.value} ({entry.evidence})")
    for name in outcome.missing:
        tell(f"note: axis {name} has no table in this plan")
    for finding in outcome.findings:
        tell(f"{finding.severity}: {finding.message}")
    print_lines(map(str, outcome.files))
    return 1 if any(finding.severity == "error" for finding in outcome.findings) else 0


@compwright.command()
@click.argument("plan", metavar="PLAN.json", type=PATH)
@click.option(
    "--loaded",
    multiple=True,
    required=True,
    type=PATH,
    metavar="FILE...",
    help="What was read back from the control; files or folders.",
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
    """Hold what is really in the control against the plan."""
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


@compwright.command()
@click.argument("old", nargs=-1, required=True, metavar="OLD...", type=PATH)
@click.option(
    "--with",
    "new",
    multiple=True,
    required=True,
    type=PATH,
    metavar="NEW...",
    help="The other backup of the same machine; files or folders.",
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
    """Say what differs between two backups of one machine."""
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


@compwright.group()
def formats() -> None:
    """List, show and check the definitions of the controls."""


@formats.command("list")
@exiting
@click.pass_obj
def formats_list(invocation: Invocation, /) -> int:
    """List the controls that compwright can write for."""
    from compwright.workflow.commands.formats import list_formats

    print_lines(list_formats(invocation.session))
    return 0


@formats.command("show")
@click.argument("format_id", metavar="ID|FILE")
@exiting
@click.pass_obj
def formats_show(invocation: Invocation, /, format_id: str) -> int:
    """Show what a control can hold, its options, and how well each fact is known."""
    from compwright.workflow.commands.formats import show_format

    print_lines(show_format(invocation.session, format_id))
    return 0


@formats.command("check")
@click.argument("paths", nargs=-1, metavar="[PATH...]", type=PATH)
@exiting
@click.pass_obj
def formats_check(invocation: Invocation, /, paths: tuple[Path, ...]) -> int:
    """Check definitions: those that ship with compwright, or files and folders of your own."""
    from compwright.workflow.commands.formats import check_formats

    print_lines(check_formats(invocation.session, paths))
    return 0
