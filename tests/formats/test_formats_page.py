"""The tutorial of docs/formats.md, played from an empty folder: its files, its commands, and what
they answer.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from places import PROJECT

PAGE = PROJECT / "docs" / "formats.md"
#: ```kind name, lines, ```
_BLOCK = re.compile(
    r"^```(?P<kind>\w+)(?: (?P<name>\S+))?\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL
)
#: What stands for any number of lines of an answer.
SKIPPED = "..."


@dataclass(frozen=True)
class Block:
    kind: str
    name: str
    body: str
    line: int


def blocks(text: str) -> Iterator[Block]:
    for found in _BLOCK.finditer(text):
        line = text.count("\n", 0, found.start()) + 1
        yield Block(found["kind"], found["name"] or "", found["body"], line)


def answer(command: str, capsys: pytest.CaptureFixture[str]) -> str:
    """What the user sees: answer, messages, and the exit code where it is not 0."""
    program, *words = command.split()
    assert program == "compwright"
    code = compwright(words)
    seen = capsys.readouterr()
    lines = [line.rstrip() for line in (seen.out + seen.err).splitlines()]
    return "\n".join([*lines, *([f"(exit {code})"] if code else []), ""])


def matches(shown: str, found: str) -> bool:
    """Whether a page shows an answer, apart from what it skips."""
    parts = [
        re.escape(part) for part in re.split(rf"^{re.escape(SKIPPED)}\n", shown, flags=re.MULTILINE)
    ]
    return re.fullmatch(r"(?:.*\n)*".join(parts), found) is not None


def change(path: Path, diff: str) -> None:
    old = "".join(f"{line[1:]}\n" for line in diff.splitlines() if line.startswith("-"))
    new = "".join(f"{line[1:]}\n" for line in diff.splitlines() if line.startswith("+"))
    text = path.read_text()
    assert text.count(old) == 1, old
    path.write_text(text.replace(old, new))


def test_the_tutorial_is_what_a_reader_gets(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")
    played = 0
    for block in blocks(PAGE.read_text(encoding="utf-8")):
        path = Path(block.name)
        if block.kind in ("yaml", "csv"):  # a file, or more of it
            path.write_text((path.read_text() if path.exists() else "") + block.body)
        elif block.kind == "diff":
            change(path, block.body)
        elif block.kind == "text":
            assert matches(block.body, path.read_text()), path.read_text()
        else:
            for part in re.split(r"^(?=\$ )", block.body, flags=re.MULTILINE)[1:]:
                command, _, shown = part.partition("\n")
                found = answer(command[2:], capsys)
                assert matches(shown, found), f"{PAGE.name}, line {block.line}:\n{found}"
                played += 1
    assert played >= 12
    assert (tmp_path / "again" / "NC7_X.PIT").is_file()
