"""The help of commands: required arguments, options, two examples, and a page to read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import click

#: The commands in the order of work, by heading.
ORDER: Mapping[str, tuple[str, ...]] = {
    "Measured files": ("evaluate", "profile"),
    "Tables": ("new", "run", "export"),
    "At the control": ("decode", "compare", "diff"),
    "After loading": ("verify", "history"),
    "Further commands": ("formats", "simulate", "demo", "selftest", "redact", "completion"),
}
_HEADINGS = {command: heading for heading, commands in ORDER.items() for command in commands}


class HelpfulCommand(click.Command):
    """A command whose help shows required arguments, examples and a page of the documentation.

    ``examples``: complete command lines. ``page``: path of the documentation page.
    """

    def __init__(
        self, name: str | None, *, examples: Sequence[str] = (), page: str = "", **words: Any
    ) -> None:
        super().__init__(name, **words)
        self.examples = tuple(examples)
        self.page = page

    def format_arguments(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write nothing: the file arguments are listed with the required options."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the required arguments first, then the options."""
        params = self.get_params(ctx)
        rows: dict[bool, list[tuple[str, str]]] = {True: [], False: []}
        for param in params:
            row = _row(param, ctx)
            if row is not None:
                rows[param.required].append(row)
        for required, heading in ((True, "Required"), (False, "Options")):
            if rows[required]:
                with formatter.section(heading):
                    formatter.write_dl(rows[required])

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the examples, and the page of the documentation."""
        del ctx
        if self.examples:
            with formatter.section("Examples"):
                formatter.write("".join(f"  {line}\n" for line in self.examples))
        if self.page:
            formatter.write_paragraph()
            formatter.write(f"Read more: {self.page}\n")


def _row(param: click.Parameter, ctx: click.Context) -> tuple[str, str] | None:
    record = param.get_help_record(ctx)  # the heading says already what is required
    return record and (record[0], record[1].removesuffix("[required]").rstrip())


class OrderedGroup(HelpfulCommand, click.Group):
    """A command group that lists its commands in the order of work with their full description."""

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the options, then the commands."""
        super().format_options(ctx, formatter)
        self.format_commands(ctx, formatter)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the commands, those without a heading last."""
        places = list(_HEADINGS)
        names = super().list_commands(ctx)
        return sorted(names, key=lambda name: places.index(name) if name in places else len(places))

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands under headings."""
        listed: dict[str, list[tuple[str, str]]] = {}
        names = self.list_commands(ctx)
        width = max(map(len, names))
        for name in names:
            command = self.commands[name]
            heading = _HEADINGS.get(name, "Commands") if ctx.parent is None else "Commands"
            listed.setdefault(heading, []).append(
                (f"{name:<{width}}", command.get_short_help_str(limit=300))
            )
        for heading, rows in listed.items():
            with formatter.section(heading):
                formatter.write_dl(rows)
