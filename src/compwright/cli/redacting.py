"""The command that makes copies without private data."""

from __future__ import annotations

from pathlib import Path

import click

from compwright.cli.saying import answer_lines, errors, json_file, tell
from compwright.cli.words import (
    PATH,
    Invocation,
    complete_format,
    compwright,
    exiting,
    force_option,
    json_option,
    profile_option,
)


@compwright.command(
    examples=(
        "compwright redact before/y.csv --out sample",
        "compwright redact control --out sample-control --format 840d-sl --show",
    ),
    page="docs/commands.md#redact",
)
@click.argument(
    "paths",
    nargs=-1,
    required=True,
    metavar="FILE|FOLDER...",
    type=PATH,
    help="Measurement files, files of a control, or folders of them.",
)
@click.option("--out", required=True, type=PATH, metavar="DIR", help="Folder for the copies.")
@profile_option
@click.option(
    "--format",
    "format_id",
    metavar="ID",
    shell_complete=complete_format,
    help="The control that all the files belong to; default: found from their content.",
)
@click.option("--show", is_flag=True, help="Also print the texts that were removed.")
@json_option
@force_option
@exiting
@click.pass_obj
def redact(
    invocation: Invocation,
    /,
    paths: tuple[Path, ...],
    out: Path,
    profile: Path | None,
    format_id: str | None,
    show: bool,  # noqa: FBT001 - a flag of the command line
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Copy measurement and control files without names, serial numbers and remarks."""
    from compwright.workflow.commands.redact import redact_files, redaction_lines

    outcome = redact_files(
        invocation.session,
        paths,
        out,
        profile=profile,
        format_id=format_id,
        json_path=json_file(json_path),
        force=force,
    )
    errors(map(str, outcome.faults))
    if outcome.files or json_path is not None:
        answer_lines(outcome.document, json_path, lambda: redaction_lines(outcome, show=show))
    for folder in outcome.folders:
        tell(
            f"note: {folder}: a folder in a folder, not looked into; name it to copy what is in it"
        )
    return outcome.exit_code
