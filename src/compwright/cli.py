"""The command line: thin, and quick to start; what a command needs is imported inside it."""

from __future__ import annotations

import errno
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from io import StringIO, TextIOWrapper
from pathlib import Path
from typing import Any, NoReturn, ParamSpec

import click

from compwright import __version__
from compwright.foundations.command_inputs import start_command
from compwright.foundations.command_words import Form, spread
from compwright.foundations.errors import CompwrightError, Fault, StorageError, UsageError
from compwright.foundations.processors import use_one_thread

P = ParamSpec("P")

_STANDARDS = (
    "iso230-2:1988, iso230-2:1997, iso230-2:2006, iso230-2:2014 (default), gost27843:2006, vdi3441;"
    " circular: iso230-4:1996, iso230-4:2005 (default)"
)
#: A file of the wrong kind is wrong in every line: nobody reads more than these.
_MOST_ERRORS = 25


class _PathType(click.ParamType[Path]):
    """The name of a file or folder. Whether it can be read or written is found out, and said, where
    it is done.
    """

    name = "path"

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> Path:
        if value == "":  # an unset variable in a script; it must not mean the working directory
            self.fail("the name is empty", param, ctx)
        return Path(str(value))


class _Command(click.Command):
    """A command whose options take several values at once where their value ends in ``...``; see
    `command_words`.
    """

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        forms = {
            name: Form(
                flag=param.is_flag or param.count,
                several=param.multiple,
                more=_MORE.get(name, _another),
            )
            for param in self.get_params(ctx)
            if isinstance(param, click.Option)
            for name in param.opts
        }
        files = [param for param in self.params if isinstance(param, click.Argument)]
        many = any(param.nargs < 0 for param in files)
        return super().parse_args(
            ctx, spread(args, forms, needed=sum(param.required for param in files), many=many)
        )


class _Group(click.Group):
    command_class = _Command
    group_class = type


_STANDARD_ID = re.compile(r"(iso[0-9-]+|gost[0-9]+):[0-9]{4}|vdi[0-9]+")


# any word may be one more file, except behind `none`
def _another(value: str, word: str) -> bool:  # noqa: ARG001
    return value != "none"


#: What one more value of these options looks like; of the others any word.
_MORE: Mapping[str, Callable[[str, str], bool]] = {
    "--option": lambda _, word: "=" in word,
    "--standard": lambda _, word: _STANDARD_ID.fullmatch(word.lower()) is not None,
}
_PATH = _PathType()
_json = click.option(
    "--json",
    "json_path",
    type=_PATH,
    metavar="PATH|-",
    help="Write the answer as JSON to a file, or with - to standard output.",
)
_force = click.option("--force", is_flag=True, help="Replace files that exist already.")
_option = click.option(
    "--option",
    "options",
    multiple=True,
    metavar="K=V...",
    help="An option of the control; see compwright formats show ID.",
)
_state = click.option(
    "--state",
    "states",
    multiple=True,
    metavar="none|FILE...",
    help="What is active in the control: none, or its files.",
)


def main() -> NoReturn:
    """Run the command line and leave with the exit code of what happened."""
    use_one_thread()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(
            stream, TextIOWrapper
        ):  # a terminal that knows no µ gets a question mark, not a crash
            stream.reconfigure(errors="replace")
    sys.exit(run(sys.argv[1:]))


def run(arguments: list[str]) -> int:
    """Run a command and return its exit code. Every error becomes lines on standard error, never a
    traceback.
    """
    start_command()
    try:
        code = compwright.main(args=arguments, prog_name="compwright", standalone_mode=False)
    except click.exceptions.Exit as leaving:
        return leaving.exit_code
    except click.Abort:
        _tell("stopped")
        return 130
    except click.ClickException as error:
        return _wrong_words(error)
    except CompwrightError as error:
        _errors(str(fault) for fault in error.faults)
        return error.exit_code
    # the last line of defence: a fault of our own, said as one
    except Exception as error:  # noqa: BLE001
        if (
            isinstance(error, OSError) and error.errno == errno.ENOSPC
        ):  # files are written elsewhere: this is standard output
            sys.stdout = StringIO()
            _errors([f"standard output: cannot be written; found {error.strerror}"])
            return StorageError.exit_code
        return _own_fault(error)
    return code if isinstance(code, int) else 0


def _wrong_words(error: click.ClickException) -> int:
    context = error.ctx if isinstance(error, click.UsageError) else None
    if (
        context is not None and error.format_message() == context.get_help()
    ):  # a group without a command shows its help
        _tell(error.format_message())
        return UsageError.exit_code
    _errors([error.format_message()])
    if context is not None:
        _tell(f"see: {context.command_path} --help")
    return UsageError.exit_code


def _own_fault(error: Exception) -> int:
    import traceback

    frames = traceback.extract_tb(error.__traceback__)
    where = next(
        (frame for frame in reversed(frames) if "compwright" in frame.filename), frames[-1]
    )
    _errors(
        [
            (
                f"a fault of compwright itself: {type(error).__name__}: {error}"
                f" ({Path(where.filename).name}, line {where.lineno})"
            )
        ]
    )
    _tell(
        f"Please report this line with the command, the input files and the version {__version__}."
    )
    return 70


def _exiting(command: Callable[P, int]) -> Callable[P, None]:
    """Turn the number that a command returns into its exit code."""

    @wraps(command)
    def wrapper(*args: P.args, **kwargs: P.kwargs) -> None:
        raise click.exceptions.Exit(command(*args, **kwargs))

    return wrapper


def _pairs(options: Iterable[str]) -> dict[str, object]:
    given: dict[str, object] = {}
    faults = []
    for text in options:
        key, mark, value = text.partition("=")
        if not mark or not key.strip():
            faults.append(
                Fault(message="cannot be read", place="--option", expected="K=V", found=text)
            )
        elif key.strip() in given:
            faults.append(Fault(message="option given twice", place="--option", found=key.strip()))
        given[key.strip()] = value.strip()
    if faults:
        raise UsageError(*faults)
    return given


def _print(say: Callable[[], None]) -> None:
    """Print on standard output. A reader that hangs up early (``| head``) changes neither the work
    nor its exit code.
    """
    try:
        say()
    except (BrokenPipeError, SystemExit):  # SystemExit: rich leaves the program then
        sys.stdout = StringIO()


def _print_lines(lines: Iterable[str]) -> None:
    _print(lambda: click.echo("\n".join(lines)))


def _answer(
    document: Mapping[str, Any], json_path: Path | None, renderables: Callable[[], list[Any]]
) -> None:
    """Print the answer of a command: as JSON for ``--json -``, else for people."""
    from compwright.workflow.showing.answers import document_text, show

    if _on_output(json_path):
        text = document_text(document).encode()  # always UTF-8, whatever the terminal speaks
        _print(lambda: click.echo(text, nl=False))
    else:
        _print(lambda: show(renderables()))


def _on_output(json_path: Path | None) -> bool:
    return json_path is not None and str(json_path) == "-"


def _json_file(json_path: Path | None) -> Path | None:
    """Return the file that ``--json`` asks for; None without it and for standard output."""
    return None if _on_output(json_path) else json_path


@click.group(
    cls=_Group, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110}
)
@click.version_option(__version__, prog_name="compwright")
def compwright() -> None:
    """Bring a machine axis back to accuracy: evaluate tests, fit and export compensation tables,
    predict, verify.
    """


@compwright.command()
@click.argument("paths", nargs=-1, required=True, metavar="FILE|FOLDER...", type=_PATH)
@click.option(
    "--standard",
    "standards",
    multiple=True,
    metavar="ID...",
    help=f"One per kind of test: {_STANDARDS}.",
)
@click.option(
    "--spread",
    type=click.Choice(["std", "range"]),
    default="std",
    help="How s is estimated (range: 1988 and GOST only).",
)
@click.option("--plot", type=_PATH, help="Plot to a file: .svg, .png or .pdf.")
@click.option("--targets", is_flag=True, help="Show the values of every target too.")
@_json
@_force
@_exiting
def evaluate(
    paths: tuple[Path, ...],
    standards: tuple[str, ...],
    spread: str,
    plot: Path | None,
    targets: bool,  # noqa: FBT001 - a flag of the command line
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Evaluate positioning and circular tests to a standard."""
    from compwright.workflow.commands.evaluate import (
        evaluate_files,
        evaluation_renderables,
        write_evaluation,
    )

    outcome = evaluate_files(paths, standards, spread)
    written = write_evaluation(
        outcome.document, json_path=_json_file(json_path), plot_path=plot, force=force
    )
    _answer(
        outcome.document,
        json_path,
        lambda: evaluation_renderables({**outcome.document, "errors": []}, targets=targets),
    )
    _errors(
        ": ".join(filter(None, (entry["file"], entry["message"])))
        for entry in outcome.document["errors"]
    )
    for name in outcome.document.get("skipped", ()):
        _tell(f"note: {name}: skipped, by its ending no measurement")
    for path in written:
        _tell(f"written: {path}")
    return outcome.exit_code


@compwright.command("run")
@click.argument("inputs", nargs=-1, required=True, metavar="JOB.yaml|FILE...", type=_PATH)
@click.option(
    "--format",
    "format_id",
    metavar="ID",
    help="Without a job file: the control's id (compwright formats list), or your own definition.",
)
@click.option("--axis", metavar="NAME", help="Without a job file: the axis that was measured.")
@click.option(
    "--travel",
    metavar="LO:HI",
    help="Without a job file: its travel in machine coordinates, mm or deg.",
)
@_state
@_option
@click.option(
    "--out",
    type=_PATH,
    help="Folder for the results; default: the name of the job file, beside it.",
)
@click.option(
    "--accept-worse", is_flag=True, help="Write a table even if it would not improve the axis."
)
@_json
@_force
@_exiting
def run_command(
    inputs: tuple[Path, ...], out: Path | None, json_path: Path | None, **words: Any
) -> int:
    """Evaluate, fit, export, predict and report: the whole job."""
    from compwright.workflow.commands.run import run_job
    from compwright.workflow.showing.answers import run_summary
    from compwright.workflow.stages.jobs import job_of

    job, folder, default_out = job_of(
        [str(path) for path in inputs],
        format_id=words["format_id"],
        axis=words["axis"],
        travel=words["travel"],
        states=words["states"],
        options=words["options"],
    )
    outcome = run_job(
        job,
        folder,
        out or default_out,
        force=words["force"],
        accept_worse=words["accept_worse"],
        json_path=_json_file(json_path),
    )
    _answer(outcome.prediction, json_path, lambda: run_summary(outcome))
    _errors(filter(None, [outcome.no_tables]))
    _errors(f"axis {name}: no table is written: {why}" for name, why in outcome.refused.items())
    for note in outcome.notes:
        _tell(f"note: {note}")
    _errors(
        entry["message"]
        for entry in outcome.findings
        if entry["severity"] == "error" and entry["code"] != "CW-P001"
    )
    return outcome.exit_code


@compwright.command()
@click.argument("plan", metavar="PLAN.json", type=_PATH)
@click.option(
    "--format",
    "format_id",
    required=True,
    metavar="ID",
    help="The control: its id, see compwright formats list, or your own definition (*.yaml).",
)
@_option
@_state
@click.option("--out", required=True, type=_PATH, help="Folder for the control's files.")
@_force
@_exiting
def export(
    plan: Path,
    format_id: str,
    options: tuple[str, ...],
    states: tuple[str, ...],
    out: Path,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Write the tables of a plan again, for its control or another."""
    from compwright.workflow.commands.export import export_plan

    outcome = export_plan(plan, format_id, _pairs(options), states, out, force=force)
    for entry in outcome.assumed:
        _tell(f"assumed: {entry.fact} = {entry.value} ({entry.evidence})")
    for name in outcome.missing:
        _tell(f"note: axis {name} has no table in this plan")
    for finding in outcome.findings:
        _tell(f"{finding.severity}: {finding.message}")
    _print_lines(map(str, outcome.files))
    return 1 if any(finding.severity == "error" for finding in outcome.findings) else 0


@compwright.command()
@click.argument("paths", nargs=-1, required=True, metavar="FILE...", type=_PATH)
@click.option(
    "--format",
    "format_id",
    required=True,
    metavar="ID",
    help="The control: its id, see compwright formats list, or your own definition (*.yaml).",
)
@_option
@click.option("--axis", metavar="ADDRESS", help="Only this axis, by the control's own name.")
@click.option(
    "--at",
    metavar="LIST",
    help="Positions: numbers and LO:HI:STEP, separated by commas; default: the nodes.",
)
@_json
@_force
@_exiting
def decode(
    paths: tuple[Path, ...],
    format_id: str,
    options: tuple[str, ...],
    axis: str | None,
    at: str | None,
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Say what a control would do with these files."""
    from compwright.workflow.commands.decode import decode_files
    from compwright.workflow.showing.answers import decode_summary, write_document

    document = decode_files(paths, format_id, _pairs(options), axis=axis, at=at)
    to_file = _json_file(json_path)
    if to_file is not None:
        write_document(document, to_file, force=force)
    _answer(document, json_path, lambda: decode_summary(document))
    return 0


@compwright.command()
@click.argument("plan", metavar="PLAN.json", type=_PATH)
@click.option(
    "--loaded",
    multiple=True,
    required=True,
    type=_PATH,
    metavar="FILE...",
    help="What was read back from the control; files or folders.",
)
@_json
@_force
@_exiting
def compare(
    plan: Path,
    loaded: tuple[Path, ...],
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Hold what is really in the control against the plan."""
    from compwright.workflow.commands.compare import compare_plan
    from compwright.workflow.commands.verify import plan_path
    from compwright.workflow.showing.answers import compare_summary, write_document

    outcome = compare_plan(plan_path(plan, plan), loaded)
    to_file = _json_file(json_path)
    if to_file is not None:
        write_document(outcome.document, to_file, force=force)
    _answer(outcome.document, json_path, lambda: compare_summary(outcome.document))
    return outcome.exit_code


@compwright.command()
@click.option(
    "--from",
    "files",
    multiple=True,
    required=True,
    type=_PATH,
    metavar="FILE...",
    help="Files of the control, or a folder of them.",
)
@click.option(
    "--format",
    "format_id",
    required=True,
    metavar="ID",
    help="The control: its id, see compwright formats list, or your own definition (*.yaml).",
)
@_option
@click.option("--out", required=True, type=_PATH, metavar="JOB.yaml", help="The job file to write.")
@_force
@_exiting
def new(
    files: tuple[Path, ...],
    format_id: str,
    options: tuple[str, ...],
    out: Path,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Write a job prefilled from the control's own files."""
    from compwright.workflow.commands.new import new_job

    outcome = new_job(files, format_id, _pairs(options), out, force=force)
    _print_lines([str(outcome.path)])
    for line in outcome.open:
        _tell(f"fill in: {line}")
    for line in outcome.left_out:
        _tell(f"note: {line}")
    return 0


@compwright.command()
@click.argument("job_file", metavar="JOB.yaml", type=_PATH)
@click.option(
    "--after",
    multiple=True,
    required=True,
    metavar="[TEST=]FILE...",
    help="Tests made after loading.",
)
@click.option(
    "--plan", type=_PATH, help="Folder of the run, or its plan.json; default: where run puts it."
)
@click.option(
    "--loaded",
    multiple=True,
    type=_PATH,
    metavar="FILE...",
    help="What was read back from the control.",
)
@click.option("--out", type=_PATH, help="Folder for the results; default: that of the run.")
@_json
@_force
@_exiting
def verify(
    job_file: Path,
    after: tuple[str, ...],
    plan: Path | None,
    loaded: tuple[Path, ...],
    out: Path | None,
    json_path: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Judge the test after loading against the plan."""
    from compwright.workflow.commands.verify import plan_path, verify_job
    from compwright.workflow.showing.answers import verify_summary
    from compwright.workflow.stages.jobs import default_folder, read_job_file

    folder = default_folder(job_file)
    plan_file = plan_path(plan, folder)
    job = read_job_file(job_file, plan_file)
    outcome = verify_job(
        job,
        after,
        plan_file=plan_file,
        out=out or folder,
        loaded=loaded,
        force=force,
        json_path=_json_file(json_path),
    )
    _answer(outcome.document, json_path, lambda: verify_summary(outcome))
    for note in outcome.notes:
        _tell(f"note: {note}")
    return outcome.exit_code


@compwright.command()
@click.argument("machine", metavar="MACHINE.yaml", type=_PATH)
@click.option("--out", required=True, type=_PATH, help="Folder for the measurement files.")
@click.option(
    "--seed", type=click.IntRange(min=0), default=0, show_default=True, help="Seed of the noise."
)
@click.option(
    "--with-tables", "tables", type=_PATH, help="Folder with the control's files that are loaded."
)
@_force
@_exiting
def simulate(
    machine: Path,
    out: Path,
    seed: int,
    tables: Path | None,
    force: bool,  # noqa: FBT001 - a flag of the command line
) -> int:
    """Measure a virtual machine; see docs/simulation.md."""
    from compwright.workflow.commands.simulate import load_machine, simulate_files

    written = simulate_files(
        load_machine(machine), out, seed=seed, tables=tables, force=force, file=str(machine)
    )
    _print_lines(map(str, written))
    return 0


@compwright.command()
@click.option(
    "--out", type=_PATH, default=Path("demo"), show_default=True, help="Folder for the demo."
)
@_force
@_exiting
def demo(out: Path, force: bool) -> int:  # noqa: FBT001 - a flag of the command line
    """Play the whole loop on a virtual machine."""
    from compwright.workflow.commands.demo import run_demo
    from compwright.workflow.showing.answers import demo_summary, show

    outcome = run_demo(out, force=force)
    _print(lambda: show(demo_summary(outcome)))
    for note in (*outcome.run.notes, *outcome.verification.notes):
        _tell(f"note: {note}")
    return max(outcome.run.exit_code, outcome.verification.exit_code)


@compwright.group()
def formats() -> None:
    """List, show and check the definitions of the controls."""


@formats.command("list")
@_exiting
def formats_list() -> int:
    """List the controls that compwright can write for."""
    from compwright.workflow.commands.formats import list_formats

    _print_lines(list_formats())
    return 0


@formats.command("show")
@click.argument("format_id", metavar="ID|FILE")
@_exiting
def formats_show(format_id: str) -> int:
    """Show what a control can hold, its options, and how well each fact is known."""
    from compwright.workflow.commands.formats import show_format

    _print_lines(show_format(format_id))
    return 0


@formats.command("check")
@click.argument("paths", nargs=-1, metavar="[PATH...]", type=_PATH)
@_exiting
def formats_check(paths: tuple[Path, ...]) -> int:
    """Check definitions: those that ship with compwright, or files and folders of your own."""
    from compwright.workflow.commands.formats import check_formats

    _print_lines(check_formats(paths))
    return 0


def _errors(lines: Iterable[str]) -> None:
    """Print each error on a line of its own; of very many the first, and how many more there
    are.
    """
    told = list(lines)
    for line in told[:_MOST_ERRORS]:
        _tell(f"error: {''.join(map(_visible, line))}")
    if len(told) > _MOST_ERRORS:
        _tell(f"error: ... and {len(told) - _MOST_ERRORS} more like these")


def _visible(character: str) -> str:
    """Return what may stand in a line of a terminal: a file's name may hold line breaks and control
    codes.
    """
    if character.isprintable():
        return character
    return " " if character.isspace() else "?"


def _tell(line: str) -> None:
    """Print a line on standard error; where that is closed or full nobody listens, and the exit
    code says it.
    """
    try:
        click.echo(line, err=True)
    except OSError:
        sys.stderr = StringIO()
