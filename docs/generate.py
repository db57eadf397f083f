"""Write the reference pages that are made from the code: commands, keys of a job, controls, the
library. They are no part of the repository: `make site` makes them anew.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import click

import compwright
from compwright.cli import compwright as group
from compwright.cli.help_text import ORDER
from compwright.controls.definitions import shipped_definitions
from compwright.controls.description import description
from compwright.foundations.session import Session


def command_page() -> str:
    """Return the help of every command, in the order of work."""
    about = "What `--help` prints. What the commands do: [commands](../commands.md)."
    parts = ["# Commands: options", about]
    for heading, names in ORDER.items():
        parts.append(f"## {heading}")
        for name in names:
            for words, command in _commands(name, group.commands[name]):
                context = click.Context(command, info_name=words, terminal_width=96)
                title = words.removeprefix("compwright ")
                parts.append(f"### {title}\n\n```text\n{command.get_help(context)}\n```")
    return "\n\n".join(parts) + "\n"


def _commands(name: str, command: click.Command) -> Iterator[tuple[str, click.Command]]:
    if isinstance(command, click.Group):
        for word, below in command.commands.items():
            yield from _commands(f"{name} {word}", below)
    else:
        yield f"compwright {name}", command


def control_pages() -> dict[str, str]:
    """Return a page for each control: what its definition says, with the evidence of each fact."""
    pages = {}
    for name, definition in shipped_definitions(Session()).items():
        lines = "\n".join(description(definition))
        pages[name] = f"# {name}\n\n{definition.title}\n\n```text\n{lines.strip()}\n```\n"
    return pages


def library_page() -> str:
    """Return the page of the library's public names; autodoc fills it in from the docstrings."""
    functions = [name for name in compwright.__all__ if name[0].islower()]
    tests = ["PositioningTest", "CircularTest"]
    results = [
        "Evaluation",
        "EstimatedError",
        "LoadedJob",
        "JobPlan",
        "Comparison",
        "DecodedFiles",
        "Verification",
    ]
    errors = [name for name in compwright.__all__ if name.endswith("Error")]
    room = "compwright.library.results"
    blocks = [
        *(("Functions", f".. autofunction:: compwright.{name}") for name in functions),
        *(
            (
                "Results",
                f".. autoclass:: {room}.{name}\n   :members:\n   :inherited-members:",
            )
            for name in results
        ),
        *(("Tests", f".. autoclass:: compwright.{name}\n   :members:") for name in tests),
        *(("Errors", f".. autoexception:: compwright.{name}") for name in errors),
    ]
    parts, last = (
        ["# The library: every name", "With examples: [the library](../tutorials/library.md)."],
        "",
    )
    for heading, block in blocks:
        if heading != last:
            parts.append(f"## {heading}")
            last = heading
        parts.append(f"```{{eval-rst}}\n{block}\n```")
    return "\n\n".join(parts) + "\n"


def pages() -> dict[str, str]:
    """Return every generated page by its name below `reference/`."""
    controls = control_pages()
    return {
        "commands.md": command_page(),
        "library.md": library_page(),
        **{f"controls/{name}.md": text for name, text in controls.items()},
    }


def write_pages(folder: Path) -> None:
    """Write the pages; one that has not changed is left as it is."""
    for name, text in pages().items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write_pages(Path(sys.argv[1]))
