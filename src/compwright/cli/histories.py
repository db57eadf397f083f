"""The command for the history of machines."""

from __future__ import annotations

from pathlib import Path

import click

from compwright.cli.saying import answer, errors, json_file, tell
from compwright.cli.words import PATH, Invocation, compwright, exiting, force_option, json_option


@compwright.command(
    examples=(
        "compwright history job",
        "compwright history . --page history.html --table history.csv",
    ),
    page="docs/commands.md#history",
)
@click.argument(
    "folders",
    nargs=-1,
    required=True,
    metavar="FOLDER...",
    type=PATH,
    help="Result folders, or folders above them.",
)
@click.option("--plot", type=PATH, help="Plot to a file: .svg, .png or .pdf.")
@click.option(
    "--page",
    type=PATH,
    help="Write an HTML page with a row for each axis (needs the extra `report`).",
)
@click.option(
    "--table", type=PATH, metavar="PATH.csv", help="Write every test as a row of a CSV file."
)
@click.option(
    "--index",
    type=PATH,
    metavar="FILE.sqlite",
    help="File that stores what was read, so that the next call reads changed folders only.",
)
@json_option
@force_option
@exiting
@click.pass_obj
def history(
    invocation: Invocation,
    /,
    folders: tuple[Path, ...],
    plot: Path | None,
    page: Path | None,
    table: Path | None,
    index: Path | None,
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Show machines over the years: what changed, rates per year, and when a limit is reached."""
    from compwright.workflow.commands.history import history_of
    from compwright.workflow.results.answers import history_summary

    outcome = history_of(
        invocation.session,
        folders,
        index=index,
        json_path=json_file(json_path),
        plot_path=plot,
        page_path=page,
        table_path=table,
        force=force,
    )
    answer(outcome.document, json_path, lambda: history_summary(outcome.document))
    errors(
        ": ".join(filter(None, (entry["file"], entry["message"])))
        for entry in outcome.document["errors"]
    )
    if index is not None:
        tell(f"note: {outcome.read} of {len(outcome.document['folders'])} folders were read again")
    for path in outcome.files:
        tell(f"written: {path}")
    return outcome.exit_code
