"""Statements of src/compwright by room, counted in the syntax tree; docstrings do not count.

``python benchmarks/count_statements.py TREE...``: a column for each tree, and with several the
change from the first to the last.
"""

from __future__ import annotations

import ast
import sys
from collections import Counter
from pathlib import Path


def statements(path: Path) -> int:
    """All statements of a module but the expressions that are only a text."""
    return sum(
        isinstance(node, ast.stmt)
        and not (
            isinstance(node, ast.Expr)
            and isinstance(node.value, ast.Constant)
            and isinstance(node.value.value, str)
        )
        for node in ast.walk(ast.parse(path.read_bytes()))
    )


def by_room(tree: Path) -> Counter[str]:
    """Room -> statements; modules that stand in no room are under ``(top)``."""
    root = tree / "src" / "compwright"
    rooms: Counter[str] = Counter()
    for path in root.rglob("*.py"):
        parts = path.relative_to(root).parts
        rooms[parts[0] if parts[1:] else "(top)"] += statements(path)
    return rooms


def main(trees: list[Path]) -> None:
    counted = [by_room(tree) for tree in trees]
    for room in [*sorted({room for rooms in counted for room in rooms}), "total"]:
        numbers = [rooms.total() if room == "total" else rooms[room] for rooms in counted]
        change = f"{numbers[-1] - numbers[0]:+8d}" if numbers[1:] else ""
        print(f"{room:14}" + "".join(f"{number:8d}" for number in numbers) + change)


if __name__ == "__main__":
    main([Path(word) for word in sys.argv[1:]] or [Path(__file__).resolve().parents[1]])
