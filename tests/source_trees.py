"""The syntax trees of the source, parsed once for all tests that read them."""

from __future__ import annotations

import ast
from functools import cache

from places import PROJECT

SOURCE = PROJECT / "src" / "compwright"


@cache
def trees() -> dict[str, ast.Module]:
    """Return every module of the source: dotted name below compwright -> tree."""
    found = {}
    for path in sorted(SOURCE.rglob("*.py")):
        parts = path.relative_to(SOURCE).with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" and len(parts) > 1 else parts)
        found[name] = ast.parse(path.read_text(encoding="utf-8"), str(path))
    return found


@cache
def nodes_below(node: ast.AST) -> tuple[ast.AST, ...]:
    """Return a node and all below it: many tests ask for those of the same module."""
    return tuple(ast.walk(node))
