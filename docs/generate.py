"""Write the reference pages that are made from the code: options, keys, controls, the library.
`make site` makes them anew; those of `kept_pages` are in the repository, and a test compares them
with the code (`make pages` renews them).
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, get_args, get_origin

import click
import quality_page
from control_facts import facts_page, open_facts_page
from key_tables import definition_page, json_page
from pydantic import BaseModel

import compwright
from compwright.cli import compwright as group
from compwright.cli.help_text import ORDER
from compwright.controls.definitions import shipped_definitions
from compwright.controls.description import description
from compwright.foundations.session import Session
from compwright.jobs import schema


def command_page() -> str:
    """Return the help of every command, in the order of work."""
    about = "Made from the code by `make pages`. What the commands do: [commands](commands.md)."
    parts = ["# Commands: options", about]
    for heading, names in ORDER.items():
        parts.append(f"## {heading}")
        for name in names:
            for words, command in _commands(name, group.commands[name]):
                context = click.Context(
                    command, info_name=words, terminal_width=96, **group.context_settings
                )
                title = words.removeprefix("compwright ")
                parts.append(f"### {title}\n\n```text\n{command.get_help(context)}\n```")
    return "\n\n".join(parts) + "\n"


def _commands(name: str, command: click.Command) -> Iterator[tuple[str, click.Command]]:
    if isinstance(command, click.Group):
        for word, below in command.commands.items():
            yield from _commands(f"{name} {word}", below)
    else:
        yield f"compwright {name}", command


#: The sections of a job file with the model of each, in the order of the page.
JOB_SECTIONS = (
    ("Top level", "JobSection"),
    ("`machine`", "MachineSection"),
    ("`controller`", "ControllerSection"),
    ("`states.NAME`", "StateSection"),
    ("`axes.NAME`", "AxisSection"),
    ("`axes.NAME.before`", "TestSection"),
    ("`axes.NAME.table`", "TableSection"),
    ("`axes.NAME.encoder`", "EncoderSection"),
    ("`axes.NAME.position_map`", "PositionMapSection"),
    ("`axes.NAME.gantry`", "GantrySection"),
    ("`circles`", "CircleSection"),
    ("`cross`", "CrossSection"),
    ("`apply`", "ApplySection"),
    ("`uncertainty`", "UncertaintySection"),
    ("`uncertainty.device`", "DeviceSection"),
    ("`uncertainty.rotary`", "RotaryUncertaintySection"),
    ("`uncertainty.circular`", "CircularUncertaintySection"),
    ("`uncertainty.E_VE`", "DriftSection"),
    ("`thermal`", "ThermalSection"),
    ("`environment`", "EnvironmentSection"),
    ("`environment.instrument_air`", "InstrumentAirSection"),
    ("`acknowledged`", "AcknowledgementSection"),
    ("`proven`", "ProvenSection"),
    ("`report`", "ReportSection"),
)


def job_page() -> str:
    """Return the keys of a job file: types and defaults from the models, the meaning from the text
    below each key in their source.
    """
    tree = ast.parse(Path(schema.__file__).read_text(encoding="utf-8"))
    models = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    parts = [
        "# Keys of a job file",
        "Made from the code by `make pages`. How to write a job: [job-file.md](job-file.md).",
    ]
    for heading, name in JOB_SECTIONS:
        rows = ["| key | values | meaning |", "|---|---|---|"]
        for field, meaning in _fields(models, name).items():
            info = getattr(schema, name).model_fields[field]
            values = _values(info.annotation)
            rows.append(f"| `{field}` | {values} | {meaning.replace('|', chr(92) + '|')} |")
        about = " ".join((ast.get_docstring(models[name]) or "").split())
        about = about.replace("``", "`")
        parts += [f"## {heading}", about, "\n".join(rows)]
    return "\n\n".join(parts) + "\n"


def _fields(models: dict[str, ast.ClassDef], name: str) -> dict[str, str]:
    """Return the fields of a model with the text below each; those of its base too."""
    found: dict[str, str] = {}
    base = models[name].bases[0]
    if isinstance(base, ast.Name) and base.id in models and base.id != "JobMapping":
        found = _fields(models, base.id)
    last = ""
    for node in models[name].body:
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            last = node.target.id
            found.setdefault(last, "")
        elif last and isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            found[last] = " ".join(str(node.value.value).split())
    return found


def _values(annotation: object) -> str:
    """Return the words that a key takes, else its type."""
    words: list[str] = []
    kinds: list[str] = []

    def look(one: object) -> None:
        if get_origin(one) is Literal:
            words.extend(f"`{word}`" for word in get_args(one))
        elif get_origin(one) in (list, tuple):
            kinds.append("list")
        elif get_origin(one) is dict or (isinstance(one, type) and issubclass(one, BaseModel)):
            kinds.append("mapping")
        elif one in _TYPES:
            kinds.append(_TYPES[one])
        else:
            for inner in get_args(one):
                if not isinstance(inner, str):
                    look(inner)

    look(annotation)
    return ", ".join(dict.fromkeys([*words, *kinds]))


_TYPES: dict[object, str] = {str: "text", float: "number", int: "whole number", bool: "yes, no"}


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
        "library.md": library_page(),
        **{f"controls/{name}.md": text for name, text in controls.items()},
    }


def kept_pages() -> dict[str, str]:
    """Return the generated pages that are in the repository, by their names in `docs/`."""
    return {
        "options.md": command_page(),
        "job-keys.md": job_page(),
        "json-keys.md": json_page(),
        "definition-keys.md": definition_page(),
        "control-facts.md": facts_page(),
        "open-facts.md": open_facts_page(),
        **quality_page.pages(),
    }


def write_pages(folder: Path, made: dict[str, str]) -> None:
    """Write pages by their names; one that has not changed is left as it is."""
    for name, text in made.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write_pages(Path(sys.argv[1]), kept_pages())
