"""Arguments, options and the command group that all commands use."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import Any, ParamSpec

import click
from click.shell_completion import CompletionItem

from compwright import __version__
from compwright.cli.help_text import HelpfulCommand, OrderedGroup
from compwright.foundations.command_words import OptionForm, Own, key_values, spread
from compwright.foundations.errors import UsageError, raise_all
from compwright.foundations.parallel_work import Crew
from compwright.foundations.session import Session

P = ParamSpec("P")


_STANDARD_ID = re.compile(r"(iso[0-9-]+|gost[0-9]+):[0-9]{4}|vdi[0-9]+")


@dataclass(frozen=True, slots=True)
class Invocation:
    """One call of the command line: its session and the parallel workers (``crew``)."""

    session: Session
    crew: Crew


class _PathType(click.ParamType[Path]):
    """The type of a file or folder argument, which is not checked before it is read."""

    name = "path"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        del ctx, param
        return [CompletionItem(incomplete, type="file")]

    def convert(
        self, value: object, param: click.Parameter | None, ctx: click.Context | None
    ) -> Path:
        if value == "":  # an unset variable in a script; it must not mean the working directory
            self.fail("the name is empty", param, ctx)
        return Path(str(value))


class _FileWord(click.ParamType[str]):
    """The type of an argument that is a file, the word ``none``, or ``TEST=FILE``."""

    name = "file"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        del ctx, param
        return [CompletionItem(incomplete, type="file")]


def _matched(
    session: Session, kind: click.ParamType[Any], values: Iterable[object]
) -> Iterator[Any]:
    """Yield the values, with patterns (``*``, ``?``) replaced by the matching files, converted to
    the option's type ``kind``: the shell of Windows does not replace patterns.
    """
    for value in values:
        text = str(value)
        if not {"*", "?"} & set(text):
            yield value
            continue
        from compwright.workflow.inputs.matching import files_matching

        yield from (kind.convert(name, None, None) for name in files_matching(session, text))


class _Command(HelpfulCommand):
    """A command whose options shown with ``...`` take several values after one option name."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        forms = {
            name: OptionForm(
                flag=param.is_flag or param.count,
                several=param.multiple,
                more=_MORE.get(name, _another),
                files=name not in _MORE,
            )
            for param in self.get_params(ctx)
            if isinstance(param, click.Option)
            for name in param.opts
        }
        files = [param for param in self.params if isinstance(param, click.Argument)]
        own = Own(
            needed=sum(param.required for param in files),
            many=any(param.nargs < 0 for param in files),
            endings=_ENDINGS.get(files[0].metavar or "", ()) if files else (),
        )
        left = super().parse_args(ctx, spread(args, forms, own))
        for param in self.get_params(ctx):
            values = ctx.params.get(param.name or "")
            if isinstance(values, tuple) and isinstance(param.type, _PathType | _FileWord):
                ctx.params[param.name or ""] = tuple(_matched(ctx.obj.session, param.type, values))
        return left


class _Group(OrderedGroup):
    command_class = _Command
    group_class = type


# any word may be one more file, except behind `none`
def _another(value: str, word: str) -> bool:  # noqa: ARG001
    return value != "none"


#: What one more value of these options looks like; of the others any word.
_MORE: Mapping[str, Callable[[str, str], bool]] = {
    "--option": lambda _, word: "=" in word,
    "--standard": lambda _, word: _STANDARD_ID.fullmatch(word.lower()) is not None,
}


#: How the file of a command ends that is called so.
_ENDINGS: Mapping[str, tuple[str, ...]] = {"JOB.yaml": (".yaml", ".yml"), "PLAN.json": (".json",)}


PATH = _PathType()
FILE_WORD = _FileWord()


json_option = click.option(
    "--json",
    "json_path",
    type=PATH,
    metavar="PATH|-",
    help="Write the answer as JSON to a file, or with - to standard output.",
)


force_option = click.option("--force", is_flag=True, help="Replace files that exist already.")


def complete_format(
    ctx: click.Context, param: click.Parameter, incomplete: str
) -> list[CompletionItem]:
    """Return the control ids and definition files that begin with the typed text."""
    del param
    from compwright.workflow.commands.formats import shipped_ids

    fitting = [name for name in shipped_ids(ctx.obj.session) if name.startswith(incomplete)]
    return [*map(CompletionItem, fitting), CompletionItem(incomplete, type="file")]


format_option = click.option(
    "--format",
    "format_id",
    required=True,
    metavar="ID",
    shell_complete=complete_format,
    help="The control: its id, see compwright formats list, or your own definition (*.yaml).",
)


control_options = click.option(
    "--option",
    "options",
    multiple=True,
    metavar="K=V...",
    help="An option of the control; `compwright formats show ID` lists them.",
)


state_option = click.option(
    "--state",
    "states",
    multiple=True,
    type=FILE_WORD,
    metavar="none|FILE...",
    help="What the control holds now: the word none, or the control's own files.",
)


profile_option = click.option(
    "--profile",
    type=PATH,
    metavar="P.yaml",
    help="Mapping profile for tables of other programs; compwright profile proposes one.",
)


report_option = click.option(
    "--report",
    type=PATH,
    metavar="PATH.pdf",
    help="Also write the report as PDF (needs the extra `pdf`).",
)


def exiting(command: Callable[P, int]) -> Callable[P, None]:
    """Return a command that ends with the exit code that ``command`` returns."""

    @wraps(command)
    def wrapper(*args: P.args, **kwargs: P.kwargs) -> None:
        raise click.exceptions.Exit(command(*args, **kwargs))

    return wrapper


def pairs(options: Iterable[str]) -> dict[str, object]:
    """Return the options ``K=V`` as a mapping. Raises UsageError for invalid ones."""
    given, faults = key_values(options)
    raise_all(UsageError, faults)
    return dict(given)


@click.group(
    cls=_Group, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100}
)
@click.version_option(__version__, prog_name="compwright")
def compwright() -> None:
    """Bring a machine axis back to accuracy: evaluate tests, write compensation tables for the
    control, predict the next test, verify what was loaded.

    First steps: compwright demo; then docs/tutorials/.
    """
