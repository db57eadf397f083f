"""The pages that are typed along: each is played in a copy of the folder that it names, and its
commands answer what it shows. Links of all pages lead somewhere, and hand-written words are few.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
from count_words import pages_at, words_of
from test_formats_page import answer, blocks
from test_tutorial import agrees

from compwright.cli import compwright as group
from places import PROJECT

DOCS = PROJECT / "docs"
PAGES = {
    page: found[1].strip()
    for page in sorted(DOCS.glob("*/*.md"))
    if (found := re.search(r"<!-- folder:(.*)-->", page.read_text(encoding="utf-8")))
}
WRITTEN = [page for page in sorted(DOCS.rglob("*.md")) if "reference" not in page.parts]


@pytest.mark.real_pages
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_page_is_what_a_reader_gets(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "machine"
    if PAGES[page]:
        shutil.copytree(PROJECT / PAGES[page], folder)
    else:
        folder.mkdir()
    monkeypatch.chdir(folder)
    monkeypatch.setenv("COLUMNS", "100")
    played = 0
    for block in blocks(page.read_text(encoding="utf-8")):
        if block.kind in ("yaml", "csv") and block.name:
            Path(block.name).write_text(block.body, encoding="utf-8")
        if block.kind != "console":
            continue
        for part in re.split(r"^(?=\$ )", block.body, flags=re.MULTILINE)[1:]:
            command, _, said = part[2:].partition("\n")
            if command.startswith("cp -r "):
                shutil.copytree(*command.split()[2:])
                continue
            found = answer(command, capsys)
            assert agrees(said, found), f"{page.name}, line {block.line}: {command}\n{found}"
            played += 1
    assert played > 0


@pytest.mark.parametrize("page", WRITTEN, ids=lambda page: page.stem)
def test_links_lead_somewhere(page: Path) -> None:
    text = re.sub(
        r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL
    )
    for target, place in re.findall(r"\]\((?![a-z]+:)([^)#]*)(?:#([^)]*))?\)", text):
        file = (page.parent / target).resolve() if target else page
        if "reference" in file.parts:  # made with the site
            continue
        assert file.exists(), f"{page.name}: {target}"
        if place and file.suffix == ".md":
            headings = re.findall(r"^#+ (.*)$", file.read_text(encoding="utf-8"), re.MULTILINE)
            assert place in map(_anchor, headings), f"{page.name}: {target}#{place}"


def _anchor(heading: str) -> str:
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def test_generated_pages_are_those_of_the_code(tmp_path: Path) -> None:
    """`make pages` renews them. In a process of its own: a command remembers the help option with
    which a test asked for its help first.
    """
    subprocess.run([sys.executable, str(DOCS / "generate.py"), str(tmp_path)], check=True)
    made = {page.name: page.read_text(encoding="utf-8") for page in tmp_path.iterdir()}
    for name, text in made.items():
        assert text == (DOCS / name).read_text(encoding="utf-8"), name
    assert made["job-keys.md"].count("\n| `") > 90


def test_hand_written_words_are_few() -> None:
    """Outside of blocks of code, without the generated pages (`benchmarks/count_words.py`)."""
    assert sum(words_of(text)[1] for _, text in pages_at("")) <= 30_000


def test_every_command_is_on_a_page_in_a_console_or_an_example() -> None:
    text = "\n".join(page.read_text(encoding="utf-8") for page in WRITTEN)
    for name in group.commands:
        assert re.search(rf"^ *(?:\$ )?compwright {name}\b", text, re.MULTILINE), name
