"""The walk of a job through `run`, as `docs/architecture.md` has it: its files and functions exist,
and no room comes a second time.
"""

from __future__ import annotations

import ast
import itertools
import re

from places import PROJECT

SOURCE = PROJECT / "src" / "compwright"
PAGE = (PROJECT / "docs" / "architecture.md").read_text(encoding="utf-8")
STEP = re.compile(r"^[0-9]+\. (.*)$", re.MULTILINE)
PLACE = re.compile(r"`([\w/]+\.py)` `([\w.]+)`")


def steps() -> list[list[tuple[str, str]]]:
    """The places that each step names, as (file, function): its own first, then those it asks."""
    _, _, rest = PAGE.partition("## The walk of a job through `run`")
    walk, _, _ = rest.partition("\n## ")
    return [PLACE.findall(line) for line in STEP.findall(walk)]


def tree_of(file: str) -> ast.Module:
    return ast.parse((SOURCE / file).read_text(encoding="utf-8"))


def defined_in(file: str) -> set[str]:
    """The functions of a module, the methods of its classes as Class.method, and what a package
    hands on.
    """
    found = set()
    for node in tree_of(file).body:
        if isinstance(node, ast.FunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.ClassDef):
            found |= {f"{node.name}.{n.name}" for n in node.body if isinstance(n, ast.FunctionDef)}
        elif isinstance(node, ast.ImportFrom) and file.endswith("__init__.py"):
            found |= {alias.name for alias in node.names}
    return found


def imported_by(file: str) -> set[str]:
    """The names that a module imports, at load or inside of functions."""
    nodes = (node for node in ast.walk(tree_of(file)) if isinstance(node, ast.ImportFrom))
    return {alias.name for node in nodes for alias in node.names}


def room_of(file: str) -> str:
    """The room of a file; those of `workflow` are rooms of their own."""
    parts = file.split("/")
    return "/".join(parts[:2]) if parts[0] == "workflow" else parts[0]


def test_each_place_of_the_walk_exists() -> None:
    places = [place for step in steps() for place in step]
    assert len(steps()) == 12
    assert len(places) > 2 * len(steps())
    assert [place for place in places if place[1] not in defined_in(place[0])] == []


def test_no_room_of_the_walk_comes_twice() -> None:
    rooms = [room for room, _ in itertools.groupby(room_of(step[0][0]) for step in steps())]
    assert len(set(rooms)) == len(rooms) == 5


def test_each_step_is_called_from_one_before() -> None:
    before, *others = [step[0] for step in steps()]
    reachable = imported_by(before[0])
    for file, name in others:
        assert name in reachable, file
        reachable |= imported_by(file)
