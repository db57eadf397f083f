"""The catalogue of sentences against the source: each sentence that is asked for is there with all
its values, and each that is there is asked for.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from test_house import trees

from compwright.words.sentences import catalogue, placeholders
from places import PROJECT

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from findings_page import page

PAGE = PROJECT / "docs" / "findings.md"

#: Methods that hand the name of a sentence on.
HANDED_ON = {"foundations.findings", "formats.text.notes", "planning.cross"}


@cache
def asked() -> tuple[tuple[str, str, frozenset[str]], ...]:
    """Return place, name and given values of each sentence that the source asks for."""
    return tuple(
        (f"{module}:{node.lineno}", name, frozenset(word.arg or "**" for word in node.keywords))
        for module, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and _says(node)
        for name in _names(node.args[0])
    )


def _says(call: ast.Call) -> bool:
    called = ast.unparse(call.func)
    if not call.args or called in ("say", "Finding.of"):
        return bool(call.args)
    return called.endswith(".find") and any(name.startswith("CW-") for name in _names(call.args[0]))


def _names(node: ast.expr) -> Iterator[str]:
    """Yield the names that an argument may be; one that is computed has none."""
    if isinstance(node, ast.IfExp):
        yield from _names(node.body)
        yield from _names(node.orelse)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.Name) and node.id.isupper():
        yield f"constant {node.id}"


def test_each_sentence_that_is_asked_for_is_in_the_catalogue() -> None:
    missing = {(place, name) for place, name, _ in asked() if name not in catalogue("en")}
    assert missing == set()


def test_each_sentence_of_the_catalogue_is_asked_for() -> None:
    assert set(catalogue("en")) - {name for _, name, _ in asked()} == set()


def test_each_value_of_a_sentence_is_given() -> None:
    lacking = {
        (place, name): wanted
        for place, name, given in asked()
        if (wanted := placeholders(catalogue("en").get(name, "")) - given)
    }
    assert lacking == {}


def test_each_name_of_a_sentence_is_written_out_where_it_is_asked_for() -> None:
    computed = {
        module
        for module, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and _says(node) and not list(_names(node.args[0]))
    }
    assert computed == HANDED_ON


def test_the_page_of_findings_is_that_of_the_catalogue() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert page(text) == text
    assert not re.search(r"^\| `CW-[A-Z]+\d+` \| \?", text, re.MULTILINE), "a severity is missing"
