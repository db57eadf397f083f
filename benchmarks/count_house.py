"""What the house is made of, counted in the syntax trees of ``src/compwright``.

``python benchmarks/count_house.py TREE...``: a column for each tree, and with several the change
from the first to the last. Docstrings are no statements. What is listed below the table belongs to
the last tree.

With ``--functions`` instead: what makes the last tree larger than the first, function by function
and with the first line of its docstring, below a total for each room. A function counts as new
where no function or method of the first tree bears its name.
"""

from __future__ import annotations

import ast
import math
import statistics
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

#: Rooms that only `controls` may import.
BEHIND_THE_DOOR = ("formats", "controllers")
#: Where the name of a maker may stand.
OF_MAKERS = ("formats/families/", "controllers/")
MAKERS = ("fanuc", "siemens", "sinumerik", "heidenhain", "linuxcnc", "isg", "pmac", "twincat")


def is_text(node: ast.AST) -> bool:
    """Whether a statement is only a text, as docstrings are."""
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def statements(node: ast.AST) -> int:
    """All statements below a node but those that are only a text."""
    return sum(isinstance(one, ast.stmt) and not is_text(one) for one in ast.walk(node))


class House:
    """The modules of a tree by their names below ``compwright``, dotted."""

    def __init__(self, tree: Path) -> None:
        root = tree / "src" / "compwright"
        self.modules: dict[str, ast.Module] = {}
        for path in sorted(root.rglob("*.py")):
            parts = path.relative_to(root).with_suffix("").parts
            name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            self.modules[name] = ast.parse(path.read_bytes())

    def functions(self) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
        for tree in self.modules.values():
            for node in ast.walk(tree):
                if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                    yield node

    def classes(self) -> Counter[str]:
        return Counter(
            node.name
            for tree in self.modules.values()
            for node in ast.walk(tree)
            if isinstance(node, ast.ClassDef)
        )

    def methods_of(self, module: str, name: str) -> int:
        found = (
            node
            for node in ast.walk(self.modules.get(module, ast.Module([], [])))
            if isinstance(node, ast.ClassDef) and node.name == name
        )
        return sum(isinstance(entry, ast.FunctionDef) for one in found for entry in one.body)

    def imports(self) -> Iterator[tuple[str, str]]:
        """Importing and imported module, each pair once."""
        pairs = {
            (name, target)
            for name, tree in self.modules.items()
            for node in ast.walk(tree)
            for target in self._targets(node)
            if target != name
        }
        yield from sorted(pairs)

    def _targets(self, node: ast.AST) -> Iterator[str]:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("compwright."):
            module = (node.module or "").removeprefix("compwright.")
            for alias in node.names:
                deeper = f"{module}.{alias.name}"
                yield deeper if deeper in self.modules else module

    def behind_the_door(self) -> dict[str, list[str]]:
        """Modules outside of `controls` -> what they import of the rooms behind it."""
        found: dict[str, list[str]] = defaultdict(list)
        for by, target in self.imports():
            inside = (*BEHIND_THE_DOOR, "controls")
            if target.split(".")[0] in BEHIND_THE_DOOR and by.split(".")[0] not in inside:
                found[by].append(target)
        return found

    def arrows(self, room: str) -> set[tuple[str, str]]:
        """Which folder of a room imports which."""
        found = set()
        for by, target in self.imports():
            one, other = by.split("."), target.split(".")
            if (
                one[0] == other[0] == room
                and len(one) > 2
                and len(other) > 2
                and one[1] != other[1]
            ):
                found.add((one[1], other[1]))
        return {pair for pair in found if pair[0] != pair[1]}

    def special(self) -> int:
        """Statements that name a maker where none may be named."""
        return sum(
            isinstance(node, ast.stmt)
            and not isinstance(node, ast.FunctionDef | ast.ClassDef | ast.If | ast.For | ast.With)
            and not is_text(node)
            and any(maker in ast.unparse(node).lower() for maker in MAKERS)
            for name, tree in self.modules.items()
            if not f"{name.replace('.', '/')}/".startswith(OF_MAKERS)
            for node in ast.walk(tree)
        )


def floors(arrows: set[tuple[str, str]]) -> float:
    """The longest way along the arrows, counted in what they lead to; NaN where one leads back."""
    below: dict[str, set[str]] = defaultdict(set)
    for by, target in arrows:
        below[by].add(target)
    try:
        order = list(TopologicalSorter(below).static_order())
    except CycleError:
        return math.nan
    heights: dict[str, int] = {}
    for one in order:
        heights[one] = 1 + max((heights[other] for other in below[one]), default=0)
    return max(heights.values(), default=1)


def counted(house: House) -> dict[str, float]:
    """Every number of the table, by what it counts."""
    bodies = sorted(statements(node) - 1 for node in house.functions())
    lines = sorted((node.end_lineno or 0) - node.lineno + 1 for node in house.functions())
    door = house.behind_the_door()
    arrows = house.arrows("workflow")
    rooms = Counter[str]()
    for name, tree in house.modules.items():
        rooms[name.split(".")[0] or "(top)"] += statements(tree)
    return {
        **{f"statements of {room}": count for room, count in sorted(rooms.items())},
        "statements": rooms.total(),
        "modules": len(house.modules),
        "functions": len(bodies),
        "statements of a function, median": statistics.median(bodies),
        "statements of a function, 90 %": bodies[int(0.9 * len(bodies))],
        "statements of a function, most": bodies[-1],
        "lines of a function, 90 %": lines[int(0.9 * len(lines))],
        "lines of a function, most": lines[-1],
        "classes": len(house.classes()),
        "class names used more than once": sum(n > 1 for n in house.classes().values()),
        "methods of Family": house.methods_of("formats.families.family", "Family"),
        "methods of Bound": house.methods_of("formats.families.bound", "Bound")
        + house.methods_of("formats.families.resolved_definition", "ResolvedDefinition"),
        "imports past controls": sum(map(len, door.values())),
        "modules that import past controls": len(door),
        "rooms of workflow": len({room for pair in arrows for room in pair}),
        "floors of workflow": floors(arrows),
        "arrows of workflow": len(arrows),
        "statements that name a maker outside its rooms": house.special(),
    }


def print_functions(first: House, last: House) -> None:
    """Print the rooms with the statements of new functions, of those that have gone, and of those
    that are in both trees, then every new function, the largest first.
    """
    old, new = (by_name(house) for house in (first, last))
    came = [(name, one) for name, found in new.items() if name not in old for one in found]
    rooms: dict[str, list[int]] = defaultdict(lambda: [0, 0, 0])
    for column, found, other, sign in ((0, new, old, 1), (1, old, new, -1)):
        for name, functions in found.items():
            for module, node in functions:
                room = rooms[module.split(".")[0]]
                room[2 if name in other else column] += sign * statements(node)
    print(f"{'room':20}{'new':>8}{'gone':>8}{'in both':>8}")
    for name, numbers in sorted(rooms.items()):
        print(f"{name:20}" + "".join(f"{number:+8d}" for number in numbers))
    sums = map(sum, zip(*rooms.values(), strict=True))
    print("total".ljust(20) + "".join(f"{number:+8d}" for number in sums))
    for name, (module, node) in sorted(came, key=lambda one: -statements(one[1][1])):
        purpose = (ast.get_docstring(node) or "").split("\n")[0]
        print(f"{statements(node):5d}  {module}:{name}  {purpose}")


def by_name(house: House) -> dict[str, list[tuple[str, ast.FunctionDef | ast.AsyncFunctionDef]]]:
    """Functions that are in no other function, by their names, with their modules."""
    found: dict[str, list[tuple[str, ast.FunctionDef | ast.AsyncFunctionDef]]] = defaultdict(list)
    for module, tree in house.modules.items():
        classes = [node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)]
        bodies = [tree.body, *(one.body for one in classes)]
        for body in bodies:
            for node in body:
                if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                    found[node.name].append((module, node))
    return found


def main(trees: list[Path]) -> None:
    houses = [House(tree) for tree in trees]
    tables = [counted(house) for house in houses]
    for name in dict.fromkeys(key for table in tables for key in table):
        numbers = [table.get(name, 0) for table in tables]
        change = f"{numbers[-1] - numbers[0]:+9g}" if numbers[1:] else ""
        print(f"{name:48}" + "".join(f"{number:9g}" for number in numbers) + change)
    last = houses[-1]
    print("\nclass names used more than once")
    print(", ".join(f"{n} ({k})" for n, k in last.classes().most_common() if k > 1) or "none")
    print("\nimports past controls")
    for by, targets in last.behind_the_door().items():
        print(f"{by}: {', '.join(targets)}")


if __name__ == "__main__":
    if "--functions" in sys.argv:
        ends = [House(Path(word)) for word in sys.argv[1:] if word != "--functions"]
        print_functions(ends[0], ends[-1])
        raise SystemExit
    main([Path(word) for word in sys.argv[1:]] or [Path(__file__).resolve().parents[1]])
