"""Help, completion and the last lines: what a person at the command line goes by.

The examples of every ``--help`` are played, in a copy of an example whose files have their names.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from compwright.cli import compwright as group
from compwright.cli import run as compwright
from compwright.cli.help_text import ORDER
from places import PROJECT

#: Of a German spreadsheet program; the numbers are of no interest here.
SHEET = (
    "Abweichungen in µm (Ist - Soll)\nSoll [mm];1. auf [µm];1. ab [µm];2. auf [µm];2. ab [µm]\n"
    + "".join(
        f"{x};{x / 100:.1f};{x / 100 + 2:.1f};{x / 100 + 0.3:.1f};{x / 100 + 2.2:.1f}\n".replace(
            ".", ","
        )
        for x in range(-590, 0, 60)
    )
)


def commands(parent: click.Group = group, name: str = "") -> Iterator[tuple[str, click.Command]]:
    for word, command in parent.commands.items():
        if isinstance(command, click.Group):
            yield from commands(command, f"{name}{word} ")
        else:
            yield f"{name}{word}", command


NAMES = [name for name, _ in commands()]


def test_the_commands_stand_in_the_order_of_work(capsys: pytest.CaptureFixture[str]) -> None:
    assert compwright(["--help"]) == 0
    shown = capsys.readouterr().out
    listed = re.findall(r"^  ([a-z]+)  ", shown, re.MULTILINE)
    assert listed == [name for names in ORDER.values() for name in names]
    assert set(listed) == set(group.commands)
    assert listed.index("evaluate") < listed.index("run") < listed.index("verify")
    assert "..." not in shown.partition("\nOptions:")[2]


def test_a_group_has_examples_and_a_page(capsys: pytest.CaptureFixture[str]) -> None:
    assert compwright(["formats", "--help"]) == 0
    commands_of, _, rest = capsys.readouterr().out.partition("\nExamples:\n")
    assert re.findall(r"^  ([a-z]+) ", commands_of, re.MULTILINE) == ["check", "list", "show"]
    assert rest.count("  compwright formats ") == 2
    assert "Read more: docs/controls.md" in rest


def test_after_a_wrong_value_the_next_step_is_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    """The message has the values that are right; an example of other options would lead away."""
    assert compwright(["evaluate", "x.csv", "--lang", "xx"]) == 2
    shown = capsys.readouterr().err
    assert "'en', 'de', 'fr', 'ru'" in shown
    assert shown.splitlines()[-1] == "Next: compwright evaluate --help"


@pytest.mark.parametrize("name", NAMES)
def test_help_has_what_is_required_examples_and_a_page(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compwright([*name.split(), "--help"]) == 0
    shown = capsys.readouterr().out
    required = [param for param in dict(commands())[name].params if param.required]
    part = shown.partition("\nRequired:\n")[2].partition("\nOptions:")[0]
    for param in required:
        option = isinstance(param, click.Option)
        assert (param.opts[0] if option else param.make_metavar(click.Context(group))) in part
    assert ("\nRequired:\n" in shown) == bool(required)
    lines = shown.partition("\nExamples:\n")[2].partition("\nRead more")[0]
    examples = re.findall(r"^  compwright .*", lines, re.MULTILINE)
    assert f"  compwright {name}" in lines
    assert len(examples) == (1 if name == "formats list" else 2)
    pages = shown.partition("\nRead more: ")[2].split()
    assert pages
    for page in pages:
        file, _, place = page.rstrip(",").partition("#")
        text = (PROJECT / file).read_text(encoding="utf-8")
        assert not place or re.search(rf"^##+ .*{place}", text, re.MULTILINE)
    assert all(len(line) <= 100 for line in shown.splitlines())


@pytest.mark.short_estimate
def test_every_example_of_the_help_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "machine"
    shutil.copytree(PROJECT / "examples" / "sinumerik-old-table", folder)
    shutil.copytree(PROJECT / "examples" / "sinumerik-old-table" / "control", folder / "read_back")
    (folder / "sheet.csv").write_text(SHEET, encoding="utf-8")
    (folder / "definitions").mkdir()
    monkeypatch.chdir(folder)
    good = {"diff": {0, 1}, "compare": {0, 1}, "verify": {0, 1}, "run": {0, 1}}
    order = [name for names in ORDER.values() for name in names]
    played = []
    # the after test has to be there before it is verified
    order.insert(order.index("verify"), order.pop(order.index("simulate")))
    # compare and diff after loading: what is read back is what was written
    order.insert(order.index("run"), order.pop(order.index("demo")))
    found = dict(commands())
    for word in order:
        for name in [name for name in found if name.split()[0] == word]:
            for line in found[name].examples:  # type: ignore[attr-defined]
                words = shlex.split(line.partition(" > ")[0])[1:]
                if word in ("demo", "selftest"):
                    continue  # long, and played by tests of their own
                if words[-1] == "definitions/own.yaml":
                    continue  # docs/formats.md plays it
                code = compwright(words)
                seen = capsys.readouterr()
                assert code in good.get(word, {0}), f"{line}\n{seen.out}{seen.err}"
                played.append(line)
        if word == "run":
            for file in (folder / "job" / "tables" / "siemens-840d-sl").iterdir():
                shutil.copy(file, folder / "read_back")
    assert len(played) > 20


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("compwright ev", {"evaluate"}),
        ("compwright run job.yaml --st", {"--state"}),
        ("compwright decode a --format fanuc-3", {"fanuc-30i"}),
        ("compwright formats sh", {"show"}),
        ("compwright evaluate a.csv --spread ", {"std", "range"}),
    ],
)
def test_words_are_completed(words: str, expected: set[str]) -> None:
    found = _asked(words)
    assert {word for kind, word in found if kind == "plain"} == expected


def test_files_are_left_to_the_shell() -> None:
    assert ("file", "be") in _asked("compwright evaluate be")
    assert ("file", "be") in _asked("compwright run be")
    assert ("file", "be") in _asked("compwright decode a --format be")


def _asked(words: str) -> list[tuple[str, str]]:
    environment = os.environ | {
        "_COMPWRIGHT_COMPLETE": "bash_complete",
        "COMP_WORDS": words,
        "COMP_CWORD": str(len(words.split(" ")) - 1),
    }
    done = subprocess.run(
        [sys.executable, "-m", "compwright"],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    return [(kind, word) for kind, _, word in (line.partition(",") for line in done.stdout.split())]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_the_script_is_one_of_its_shell(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert compwright(["completion", shell]) == 0
    script = capsys.readouterr().out
    assert "_COMPWRIGHT_COMPLETE" in script
    program = shutil.which(shell)
    if program is not None:
        subprocess.run([program, "-n"], input=script, text=True, check=True)


def test_formats_are_listed_by_maker_with_names_and_evidence(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert compwright(["formats", "list"]) == 0
    shown = capsys.readouterr().out
    makers = re.findall(r"^(\S.*)$", shown, re.MULTILINE)
    assert makers[:2] == ["FANUC", "HEIDENHAIN"]
    assert len(makers) == 6
    entries = re.findall(r"^  ([a-z0-9-]+) ", shown, re.MULTILINE)
    assert len(entries) == len(list((PROJECT / "controller_formats").glob("[!.]*.yaml"))) - 2
    assert shown.count("also: ") == shown.count("facts: ") == len(entries)
    assert all(len(line) <= 100 for line in shown.splitlines())


@pytest.mark.short_estimate
def test_nothing_is_cut_on_a_pipe(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A file name of 120 characters stands whole wherever it is shown, whatever COLUMNS says."""
    monkeypatch.setenv("COLUMNS", "100")
    example = PROJECT / "examples" / "sinumerik-old-table"
    name = "laser-of-the-hall-" * 6 + "axis-x"
    before = tmp_path / "before"
    before.mkdir()
    for number in range(12):
        shutil.copy(example / "before" / "y.csv", before / f"{name}-{number}.csv")
    monkeypatch.chdir(tmp_path)
    assert compwright(["evaluate", "before"]) == 0
    shown = capsys.readouterr().out
    assert "…" not in shown
    assert f"{name}-11.csv" in shown
    words = ["--format", "siemens-840d-sl", "--axis", "Y", "--travel", "-600:0", "--state", "none"]
    assert compwright(["run", f"before/{name}-1.csv", *words, "--out", name]) in (0, 1)
    shown = capsys.readouterr().out
    assert "…" not in shown
    assert f"  {name}/record.json\n" in shown
    assert compwright(["history", name]) == 0
    assert "…" not in capsys.readouterr().out


@pytest.mark.short_estimate
def test_run_and_verify_end_with_the_next_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """From run to the end of a recalibration by the last lines alone."""
    folder = tmp_path / "machine"
    shutil.copytree(PROJECT / "examples" / "recalibration", folder)
    monkeypatch.chdir(folder)

    def last(*words: str) -> list[str]:
        compwright(list(words))
        line = capsys.readouterr().out.splitlines()[-1]
        assert line.startswith("Next: ")
        return line.partition("compwright ")[2].replace("READ_BACK", "control").split()

    text = Path("job.yaml").read_text(encoding="utf-8")
    Path("job.yaml").write_text(text.replace("states:", "#"), encoding="utf-8")
    assert compwright(["simulate", "machine.yaml", "--out", "before", "--seed", "1"]) == 0
    assert last("run", "job.yaml") == ["run", "job.yaml", "--force"]  # no state, no table
    Path("job.yaml").write_text(text, encoding="utf-8")
    then = last("run", "job.yaml", "--force")
    shutil.copytree("job/tables/linuxcnc", "control")
    assert then == ["compare", "job", "--loaded", "control"]
    assert compwright(then) == 0
    words = ["--out", "after", "--seed", "2", "--with-tables", "control"]
    assert compwright(["simulate", "closer.yaml", *words]) == 0
    assert last("verify", "job.yaml", "--after", "after/x.csv") == then
    known = last("verify", "job.yaml", "--after", "after/x.csv", "--loaded", "control", "--force")
    assert known[:2] == ["verify", "job.yaml"]
    assert "--update" in known
    assert last(*known) == ["compare", "job/next", "--loaded", "control"]
    assert compwright(["verify", "job.yaml", "--after", "after/x.csv", "--json", "-", "--force"])
    assert "Next: " not in capsys.readouterr().out


def test_the_demo_prints_ten_lines(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert compwright(["demo"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 10
    for number, line in enumerate(lines[:4], 1):
        assert re.match(rf"{number}\. .* demo/\w+/ +\d+ files +\d+ kB +\d+\.\d s$", line)
    for page in re.findall(r"\S+\.html", lines[-1]):
        assert Path(page.rstrip(",")).is_file()
    shown = (PROJECT / "README.md").read_text(encoding="utf-8")
    for line in lines[4:9]:  # the README shows the same numbers
        assert line.rstrip() in shown
