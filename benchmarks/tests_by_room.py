"""The map room -> tests -> seconds, from a JUnit file of a run of the tests.

    make test PYTEST_ADDOPTS=--junitxml=tests.xml
    python benchmarks/tests_by_room.py tests.xml [--slowest N]

A test file belongs to the room after which it is named, else to the one whose modules it imports
most often; "whole commands" are those that reach the package through the command line alone. Prints
the rooms, the files of each, and the slowest tests (100). Judges nothing.
"""

from __future__ import annotations

import argparse
import ast
import re
import sys
from collections import Counter, defaultdict
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

ROOT = Path(__file__).resolve().parents[1]
ROOMS = sorted(path.name for path in (ROOT / "src/compwright").iterdir() if path.is_dir())
WHOLE = "whole commands"


@dataclass(frozen=True)
class Test:
    """A test with its file below ``tests/`` and its seconds."""

    file: str
    name: str
    seconds: float


def tests_of(junit: Path) -> list[Test]:
    """Return the tests of a JUnit file."""
    return [
        Test(file_of(case.get("classname", "")), case.get("name", ""), float(case.get("time", 0)))
        for case in ET.parse(junit).iter("testcase")  # noqa: S314 - pytest wrote it
    ]


def file_of(classname: str) -> str:
    """Return the file of ``tests.room.test_x.TestClass``."""
    parts = classname.split(".")
    kept = next((n for n, part in enumerate(parts) if part.startswith("test_")), len(parts) - 1)
    return "/".join(parts[1 : kept + 1]) + ".py"


def room_of(file: str) -> str:
    """Return the room of a test file: by its folder, its name, else by what it imports."""
    words = re.split(r"[/_]", file.removesuffix(".py"))
    named = next((word for word in words if word in ROOMS), None)
    if named is not None:
        return named
    path = ROOT / "tests" / file
    if not path.is_file():
        return WHOLE
    counts = Counter(
        module.split(".")[1]
        for module in imported(ast.parse(path.read_text(encoding="utf-8")))
        if module.startswith("compwright.")
    )
    whole = counts.pop("cli", 0)
    rooms = Counter({room: count for room, count in counts.items() if room in ROOMS})
    foundations = {room: rooms.pop(room, 0) for room in ("foundations", "records")}
    if whole or not rooms + Counter(foundations):
        return WHOLE
    return (rooms or Counter(foundations)).most_common(1)[0][0]


def imported(tree: ast.Module) -> list[str]:
    """Return the modules that a file imports."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            found.append(node.module)
        elif isinstance(node, ast.Import):
            found += [each.name for each in node.names]
    return found


def main(words: list[str]) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("junit", type=Path)
    parser.add_argument("--slowest", type=int, default=100)
    asked = parser.parse_args(words)
    tests = tests_of(asked.junit)
    seconds: defaultdict[str, float] = defaultdict(float)
    counts: Counter[str] = Counter()
    for test in tests:
        seconds[test.file] += test.seconds
        counts[test.file] += 1
    rooms: dict[str, list[str]] = {}
    for file in counts:
        rooms.setdefault(room_of(file), []).append(file)
    total = {room: sum(seconds[file] for file in files) for room, files in rooms.items()}
    for room in sorted(rooms, key=lambda room: -total[room]):
        files = sorted(rooms[room], key=lambda file: -seconds[file])
        number = sum(counts[file] for file in files)
        print(f"{room:14} {len(files):4} files {number:5} tests {total[room]:8.1f} s")
        for file in files:
            print(f"    {file:44} {counts[file]:5} {seconds[file]:8.1f}")
    print(f"{'all':14} {len(counts):4} files {len(tests):5} tests {sum(total.values()):8.1f} s\n")
    for test in sorted(tests, key=lambda test: -test.seconds)[: asked.slowest]:
        print(f"{test.seconds:8.1f} {test.file} {test.name}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
