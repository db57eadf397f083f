"""Every error ends with the next step: each fault of the source is made with one."""

from __future__ import annotations

import ast

from source_trees import nodes_below, trees


def hint_of(call: ast.Call) -> ast.expr | None:
    """Return what a call passes as ``hint``."""
    return next((word.value for word in call.keywords if word.arg == "hint"), None)


def faults(tree: ast.Module) -> list[ast.Call]:
    """Return the calls of a module that make a fault."""
    return [
        node
        for node in nodes_below(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "Fault"
    ]


def test_every_fault_has_a_next_step() -> None:
    calls = {module: faults(tree) for module, tree in trees().items()}
    assert sum(map(len, calls.values())) > 500
    without = [
        f"{module}:{call.lineno}"
        for module, found in calls.items()
        for call in found
        if hint_of(call) is None
    ]
    assert without == []


def test_next_steps_are_imperatives_without_a_full_stop() -> None:
    for module, tree in trees().items():
        for call in faults(tree):
            hint = hint_of(call)
            if isinstance(hint, ast.Constant):
                place = f"{module}:{call.lineno}"
                assert isinstance(hint.value, str), place
                assert hint.value[:1].islower() or hint.value[:1] == "`", place
                assert not hint.value.endswith("."), place
