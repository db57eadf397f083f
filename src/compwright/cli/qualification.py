"""The command that tests the installation."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from compwright.cli.saying import answer_lines, json_file, tell
from compwright.cli.words import PATH, Invocation, compwright, exiting, force_option, json_option


@compwright.command(
    examples=(
        "compwright selftest",
        "compwright selftest --out selftest",
    ),
    page="docs/commands.md#selftest",
)
@click.option(
    "--out",
    type=PATH,
    metavar="DIR",
    help="Folder into which selftest.html and selftest.json are written.",
)
@click.option(
    "--report",
    type=PATH,
    metavar="PATH.html",
    help="Write the results as a page that can be signed.",
)
@json_option
@force_option
@exiting
@click.pass_obj
def selftest(
    invocation: Invocation,
    /,
    out: Path | None,
    report: Path | None,
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Test this installation with the reference data that ship with compwright."""
    from compwright.workflow.commands.selftest import selftest as tested
    from compwright.workflow.commands.selftest import write_selftest

    document = tested(invocation.session)
    pages = [path for path in (report, out and out / "selftest.html") if path]
    answers = [path for path in (json_file(json_path), out and out / "selftest.json") if path]
    for path in write_selftest(invocation.session, document, pages, answers, force=force):
        tell(f"written: {path}")
    answer_lines(document, json_path, lambda: _lines(document))
    return 0 if document["good"] else 1


def _lines(document: Mapping[str, Any]) -> list[str]:
    checks = document["checks"]
    wrong = [check for check in checks if not check["good"]]
    versions = ", ".join(f"{name} {text}" for name, text in document["packages"].items())
    return [
        *(
            f"outside its limit: {check['group']}, {check['subject']}: {check['quantity']}:"
            f" expected {check['expected']:.9g}, obtained {check['obtained']}, limit"
            f" {check['limit']:g} {check['unit']} {check['note']}".rstrip()
            for check in wrong
        ),
        f"{len(checks) - len(wrong)} of {len(checks)} values are within their limits",
        f"compwright {document['version']}, Python {document['python']}, {document['platform']}",
        versions,
    ]
