"""Commands that need only measurements, or that simulate them."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

import click

from compwright.cli.saying import (
    answer,
    ask_for_report,
    errors,
    json_file,
    on_terminal,
    print_lines,
    print_safely,
    tell,
)
from compwright.cli.words import (
    PATH,
    Invocation,
    compwright,
    exiting,
    force_option,
    json_option,
    profile_option,
)
from compwright.foundations.own_faults import OWN_FAULT
from compwright.foundations.processors import keep_free_memory

#: Notes of one kind that are printed; the others are counted.
_MOST_NOTES = 10
_STANDARDS = (
    "iso230-2:1988, iso230-2:1997, iso230-2:2006, iso230-2:2014 (default), gost27843:2006, vdi3441;"
    " circular: iso230-4:1996, iso230-4:2005 (default)"
)


@compwright.command(
    examples=(
        "compwright evaluate before/y.csv",
        "compwright evaluate before --standard vdi3441 --table values.csv",
    ),
    page="docs/commands.md#evaluate, docs/measurement-files.md",
)
@click.argument(
    "paths",
    nargs=-1,
    required=True,
    metavar="FILE|FOLDER...",
    type=PATH,
    help="Measurement files, or folders of them.",
)
@click.option(
    "--standard",
    "standards",
    multiple=True,
    metavar="ID...",
    help=f"Standard of the evaluation, one for each kind of test: {_STANDARDS}.",
)
@click.option(
    "--spread",
    type=click.Choice(["std", "range"]),
    default="std",
    help="How the standard deviation s is estimated (range: only with ISO 230-2:1988 and GOST).",
)
@profile_option
@click.option("--plot", type=PATH, help="Plot to a file: .svg, .png or .pdf.")
@click.option("--targets", is_flag=True, help="Also show the values at every target.")
@click.option(
    "--table",
    type=PATH,
    metavar="PATH",
    help="Write all parameters, a row per test, to a file: .csv or .xlsx.",
)
@click.option("--report", type=PATH, metavar="PATH", help="Write the test report: .html or .pdf.")
@click.option(
    "--lang",
    type=click.Choice(["en", "de", "fr", "ru"]),
    default="en",
    help="Language of the test report.",
)
@json_option
@force_option
@exiting
@click.pass_obj
def evaluate(
    invocation: Invocation,
    /,
    paths: tuple[Path, ...],
    standards: tuple[str, ...],
    spread: str,
    profile: Path | None,
    plot: Path | None,
    targets: bool,  # noqa: FBT001 - a flag of the command line
    table: Path | None,
    report: Path | None,
    lang: Literal["en", "de", "fr", "ru"],
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Evaluate positioning and circular tests to a standard."""
    from compwright.workflow.commands.evaluate import (
        evaluate_files,
        evaluation_renderables,
        many_renderables,
        write_evaluation,
    )
    from compwright.workflow.results.progress import progress

    keep_free_memory()
    with progress(shown=json_path is None and on_terminal()) as watch:
        outcome = evaluate_files(
            invocation.session,
            paths,
            standards,
            spread,
            profile=profile,
            whole=any((json_path, plot, report)) or targets,
            crew=invocation.crew,
            watch=watch,
        )
    written = write_evaluation(
        invocation.session,
        outcome.document,
        json_path=json_file(json_path),
        plot_path=plot,
        table_path=table,
        report_path=report,
        language=lang,
        command=_repeated(paths, standards, spread, profile, report, lang),
        force=force,
    )
    answer(
        outcome.document,
        json_path,
        lambda: (
            many_renderables(outcome.document)
            if outcome.many and not targets
            else evaluation_renderables({**outcome.document, "errors": []}, targets=targets)
        ),
    )
    _tell_errors(outcome.document["errors"], one_each=outcome.many)
    _tell_notes(outcome.document.get("skipped", ()), "skipped, by its ending no measurement")
    _tell_notes(
        outcome.document.get("folders", ()),
        "a folder in a folder, not looked into; name it to read it",
    )
    for path in written:
        tell(f"written: {path}")
    if outcome.exit_code == OWN_FAULT:
        ask_for_report()
    return outcome.exit_code


def _repeated(
    paths: Sequence[Path],
    standards: Sequence[str],
    spread: str,
    profile: Path | None,
    report: Path | None,
    lang: Literal["en", "de", "fr", "ru"],
) -> str:
    """Return the command line that makes the same report again."""
    words = ["compwright", "evaluate", *map(str, paths)]
    words += [word for standard in standards for word in ("--standard", standard)]
    words += ["--spread", spread] if spread != "std" else []
    words += ["--profile", str(profile)] if profile is not None else []
    words += ["--report", str(report)]
    return shlex.join([*words, "--lang", lang] if lang != "en" else words)


def _tell_notes(names: Sequence[str], what: str) -> None:
    for name in names[:_MOST_NOTES]:
        tell(f"note: {name}: {what}")
    if len(names) > _MOST_NOTES:
        tell(f"note: ... and {len(names) - _MOST_NOTES} more like these")


def _tell_errors(entries: Sequence[Mapping[str, str]], *, one_each: bool) -> None:
    """Print the errors of measurement files. ``one_each``: only the first error of each file."""
    lines: dict[str, list[str]] = {}
    for place, entry in enumerate(entries):
        line = ": ".join(filter(None, (entry["file"], entry["message"])))
        lines.setdefault(entry["file"] if one_each else str(place), []).append(line)
    untold = errors(
        f"{first} (and {len(more)} more in this file)" if more else first
        for first, *more in lines.values()
    )
    if untold:
        tell("note: --json PATH names them all")


@compwright.command(
    examples=(
        "compwright profile sheet.csv --out sheet.yaml",
        "compwright evaluate sheet.csv --profile sheet.yaml",
    ),
    page="docs/commands.md#profile, docs/measurement-files.md",
)
@click.argument(
    "file",
    metavar="FILE",
    type=PATH,
    help=("Measurement table of another program: a mapping profile for it is proposed."),
)
@click.option("--out", required=True, type=PATH, metavar="P.yaml", help="The profile to write.")
@force_option
@exiting
@click.pass_obj
def profile(
    invocation: Invocation,
    /,
    file: Path,
    out: Path,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Propose a mapping profile for a table made by another program."""
    from compwright.workflow.commands.profile import propose_profile

    outcome = propose_profile(invocation.session, file, out, force=force)
    print_lines([str(outcome.path), *outcome.worked])
    for line in outcome.notes:
        tell(f"note: {line}")
    for line in outcome.open:
        tell(f"fill in: {line}")
    return 0


@compwright.command(
    examples=(
        "compwright simulate machine.yaml --out first",
        "compwright simulate machine.yaml --out after --seed 2 --with-tables read_back",
    ),
    page="docs/simulation.md",
)
@click.argument("machine", metavar="MACHINE.yaml", type=PATH, help="The virtual machine.")
@click.option(
    "--out", required=True, type=PATH, help="Folder into which the measurement files are written."
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    metavar="N",
    default=0,
    help="Seed of the noise; default: 0.",
)
@click.option(
    "--with-tables",
    "tables",
    type=PATH,
    help="Folder of control files that the virtual machine has loaded.",
)
@force_option
@exiting
@click.pass_obj
def simulate(
    invocation: Invocation,
    /,
    machine: Path,
    out: Path,
    seed: int,
    tables: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Measure the axes and circles of a virtual machine, and write the measurement files."""
    from compwright.workflow.commands.simulate import load_machine, simulate_files

    written = simulate_files(
        invocation.session,
        load_machine(invocation.session, machine),
        out,
        seed=seed,
        tables=tables,
        force=force,
        file=str(machine),
    )
    print_lines(map(str, written))
    return 0


@compwright.command(
    examples=(
        "compwright demo",
        "compwright demo --out demo --force",
    ),
    page="docs/README.md",
)
@click.option(
    "--out", type=PATH, default=Path("demo"), show_default=True, help="Folder for the demo."
)
@force_option
@exiting
@click.pass_obj
def demo(invocation: Invocation, /, out: Path, force: bool) -> int:  # noqa: FBT001 - a flag of the command line
    """Play the whole loop on a virtual machine."""
    from compwright.workflow.commands.demo import run_demo
    from compwright.workflow.results.answers import demo_summary, show

    outcome = run_demo(invocation.session, out, force=force, crew=invocation.crew)
    print_safely(lambda: show(demo_summary(outcome)))
    for note in (*outcome.run.notes, *outcome.verification.notes):
        tell(f"note: {note}")
    return max(outcome.run.exit_code, outcome.verification.exit_code)
