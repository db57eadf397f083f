"""The first tutorial, docs/tutorials/linuxcnc.md, played in a copy of its example: its commands answer what
the page shows, and the example's script does the same commands.
"""

from __future__ import annotations

import re
import runpy
import shutil
from pathlib import Path

import pytest
from test_formats_page import answer, blocks

from places import PROJECT

PAGE = PROJECT / "docs" / "tutorials" / "linuxcnc.md"
EXAMPLE = PROJECT / "examples" / "recalibration"


def shown(text: str) -> list[tuple[str, str]]:
    """Each command of the page with what it shows of the answer."""
    found = []
    for block in blocks(text):
        if block.kind == "console":
            for part in re.split(r"^(?=\$ )", block.body, flags=re.MULTILINE)[1:]:
                command, _, said = part.partition("\n")
                found.append((command[2:], said))
    return found


def agrees(said: str, found: str) -> bool:
    """Whether a page shows an answer; ``...`` stands for lines left out, at the end of a line for
    its rest.
    """
    pattern = ""
    for line in said.splitlines():
        if line == "...":
            pattern += r"(?:.*\n)*?"
        elif line.endswith(" ..."):
            pattern += re.escape(line.removesuffix("...")) + r".*\n"
        else:
            pattern += re.escape(line) + r"\n"
    return re.fullmatch(pattern, found) is not None


@pytest.mark.real_pages
def test_the_tutorial_is_what_a_reader_gets(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "recalibration"
    shutil.copytree(EXAMPLE, folder)
    monkeypatch.chdir(folder)
    monkeypatch.setenv("COLUMNS", "100")
    for command, said in shown(PAGE.read_text(encoding="utf-8")):
        if command.startswith("cp -r "):
            _, _, source, target = command.split()
            shutil.copytree(source, target)
            continue
        found = answer(command, capsys)
        assert agrees(said, found), f"{command}\n{found}"
    assert (folder / "history.svg").is_file()


def test_the_script_and_the_page_do_the_same() -> None:
    commands = runpy.run_path(str(EXAMPLE / "recalibrate.py"))["COMMANDS"].split("\n")
    page = PAGE.read_text(encoding="utf-8")
    assert [line for line in commands if line] == [command for command, _ in shown(page)]


def test_the_page_shows_the_files_of_the_example() -> None:
    files = [block for block in blocks(PAGE.read_text(encoding="utf-8")) if block.kind == "yaml"]
    assert [block.name for block in files] == ["job.yaml"]
    for block in files:
        assert block.body == (EXAMPLE / block.name).read_text(encoding="utf-8")
    machines = [
        (EXAMPLE / name).read_text(encoding="utf-8").splitlines()[1:]
        for name in ("machine.yaml", "closer.yaml")
    ]
    assert [line for line in machines[0] if line not in machines[1]] == [
        "    test: {targets: 8, runs: 5, seed: 3}"
    ]
