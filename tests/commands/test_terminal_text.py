"""Names in files reach the terminal as text that can be seen, never as commands to it; everything
that is printed goes through two doors.
"""

from __future__ import annotations

import ast
import unicodedata

import pytest
from rich.console import Group
from rich.rule import Rule
from rich.table import Table

from compwright.cli.saying import errors, print_lines, tell
from compwright.foundations.utf8 import visible, visible_lines
from compwright.reporting.safe_text import Text, print_renderables
from source_trees import nodes_below, trees

#: Clear the screen; name the window; the same with one byte (ISO 6429: C1); turn the direction of
#: writing (UAX 9); a zero-width joiner; a line of its own; half a character.
NAMES = (
    "O0001\x1b[2J",
    "\x1b]0;y\x07",
    "\x9b31mX",
    "table\u202evsc.exe",
    "a\u200db",
    "x\rerror: y",
    "x\ny",
    "\udcff",
)


def obeyed(text: str) -> list[str]:
    """What a terminal does not show, but does: control and format characters, separators."""
    return [c for c in text if unicodedata.category(c) in {"Cc", "Cf", "Cs", "Zl", "Zp"}]


@pytest.mark.parametrize("name", NAMES)
def test_every_way_to_the_terminal(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    table = Table(title=name, box=None)
    table.add_column(name, no_wrap=True)
    table.add_row(name)
    table.add_row(Text(name, style="red"))
    table.add_row(Text.assemble("a ", name, (name, "bold")))
    print_renderables([table, Rule(Text(name)), Group(Text(name), name), name, Text(name)])
    tables = capsys.readouterr().out
    print_lines([name])
    tell(f"note: {name}")
    errors([name])
    lines = capsys.readouterr()
    for said in (tables, lines.out, lines.err):
        assert obeyed(said.replace("\n", "")) == []
    shown = visible(name)
    assert tables.count(shown) == 11  # whole, in every place: nothing is cut off
    assert visible_lines(name) in lines.out


def test_what_is_seen() -> None:
    assert visible("O0001\x1b[2J") == r"O0001\x1b[2J"
    assert visible("\u202e\x9b\udcff") == r"\u202e\x9b\udcff"
    assert visible("a\tb\r\nc") == "a b  c"
    assert visible("Größe 5\u00a0µm · 測試") == "Größe 5\u00a0µm · 測試"
    assert visible_lines("a\nb\x1b") == "a\nb\\x1b"


def test_names_are_no_markup(capsys: pytest.CaptureFixture[str]) -> None:
    table = Table(title="[red]t[/red]", box=None)
    table.add_column("[/nothing]")
    table.add_row("[bold]axis[/bold] :warning:")
    print_renderables([table, "[link=x]y[/link]"])
    said = capsys.readouterr().out
    for text in ("[red]t[/red]", "[/nothing]", "[bold]axis[/bold] :warning:", "[link=x]y[/link]"):
        assert text in said


def test_nothing_is_printed_past_the_doors() -> None:
    """Only `cli.saying` writes lines and only `reporting.safe_text` draws tables; rich's own text, which
    shows what it is given, is used there alone.
    """
    ways: dict[str, set[str]] = {}
    for module, tree in trees().items():
        for node in nodes_below(tree):
            for way in _ways(node):
                ways.setdefault(way, set()).add(module)
    assert ways == {
        "click.echo": {"cli.saying"},
        "rich.console.Console": {"reporting.safe_text"},
        "rich.text": {"reporting.safe_text"},
        "sys.stdout": {"cli.saying", "cli.shell"},
        "sys.stderr": {"cli.saying", "cli.shell"},
    }


def _ways(node: ast.AST) -> list[str]:
    if isinstance(node, ast.Import):
        return [one.name for one in node.names if one.name in {"rich.text", "rich.console"}]
    if isinstance(node, ast.ImportFrom):
        names = [f"{node.module}.{one.name}" for one in node.names]
        texts = ["rich.text"] if node.module == "rich.text" or "rich.text" in names else []
        printing = {"rich.print", "rich.console.Console", "click.echo", "click.secho", "sys.stdout"}
        return [*texts, *printing.intersection(names)]
    if isinstance(node, ast.Name) and node.id == "print":
        return ["print"]
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        name = f"{node.value.id}.{node.attr}"
        known = {"click.echo", "click.secho", "sys.stdout", "sys.stderr", "sys.__stdout__"}
        return [name] if name in known else []
    return []
