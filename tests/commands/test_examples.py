"""The examples run, and their pages show what they show. What a page quotes is held against the run
to its printed digits.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner

from card_files import wrong_files
from compwright.cli import compwright as group
from compwright.cli import run as compwright
from compwright.jobs.reading import read_job
from places import PROJECT

pytestmark = pytest.mark.real_pages

EXAMPLES = PROJECT / "examples"
#: Folder -> exit code of run, format, after files of the loop (empty where the machine is not
#: simulated).
CASES = {
    "sinumerik-standard": (0, "siemens-840d-sl", []),
    "linuxcnc-standard": (1, "linuxcnc", []),
    "sinumerik-old-table": (0, "siemens-840d-sl", ["y"]),
    "linuxcnc-two-axes": (0, "linuxcnc", ["x", "a"]),
    "fanuc-backup": (0, "fanuc-30i", ["x"]),
}
#: What the files of a control do not say, for reading them without a job.
OPTIONS = {"fanuc-30i": ["--option", "detection_unit=0.001"]}
#: A row of a table in a page: the parameter and its numbers; and what is said of the table.
ROW = re.compile(r"^    ([A-Z][+−]? +−?[0-9].*|Table: .*)$", re.MULTILINE)


def quoted_rows(page: str) -> list[str]:
    """Rows of numbers that a page quotes, with single blanks."""
    return [" ".join(match[0].split()) for match in ROW.finditer(page)]


def printed(capsys: pytest.CaptureFixture[str]) -> list[str]:
    return [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()]


@pytest.mark.parametrize("name", CASES)
def test_an_example_shows_what_its_page_says(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, format_id, axes = CASES[name]
    folder = tmp_path / name
    shutil.copytree(EXAMPLES / name, folder)
    page = (folder / "README.md").read_text(encoding="utf-8")
    assert f"(exit {code}" in page
    assert compwright(["run", str(folder / "job.yaml")]) == code
    lines = printed(capsys)
    tables = folder / "job" / "tables" / format_id
    assert wrong_files(folder / "job") == []
    assert (
        compwright(
            [
                "decode",
                str(tables),
                "--format",
                format_id,
                *OPTIONS.get(format_id, []),
                "--json",
                "-",
            ]
        )
        == 0
    )
    capsys.readouterr()
    if axes:
        machine = str(folder / "machine.yaml")
        assert (
            compwright(
                [
                    "simulate",
                    machine,
                    "--out",
                    str(folder / "after"),
                    "--seed",
                    "2",
                    "--with-tables",
                    str(tables),
                ]
            )
            == 0
        )
        after = [
            word for axis in axes for word in ("--after", str(folder / "after" / f"{axis}.csv"))
        ]
        assert compwright(["verify", str(folder / "job.yaml"), *after]) == 0
        lines += printed(capsys)
        assert "Verdict: good" in lines
    rows = quoted_rows(page)
    assert rows
    for row in rows:
        assert row in lines


def test_the_measured_files_of_the_simulated_examples_are_what_their_pages_say(
    tmp_path: Path,
) -> None:
    for name, tables in (
        (
            "sinumerik-old-table",
            ["--with-tables", str(EXAMPLES / "sinumerik-old-table" / "control")],
        ),
        ("linuxcnc-two-axes", []),
        ("fanuc-backup", ["--with-tables", str(EXAMPLES / "fanuc-backup" / "control")]),
    ):
        out = tmp_path / name
        assert (
            compwright(
                [
                    "simulate",
                    str(EXAMPLES / name / "machine.yaml"),
                    "--out",
                    str(out),
                    "--seed",
                    "1",
                    *tables,
                ]
            )
            == 0
        )
        for path in out.glob("[!.]*"):  # all but the hidden list of them
            assert path.read_bytes() == (EXAMPLES / name / "before" / path.name).read_bytes()


def test_the_readme_names_every_command_and_its_job_is_read() -> None:
    readme = (PROJECT / "README.md").read_text(encoding="utf-8")
    commands = (PROJECT / "docs" / "commands.md").read_text(encoding="utf-8")
    listed = CliRunner().invoke(group, ["--help"]).output.partition("Commands:")[2]
    for command in re.findall(r"^  ([a-z]+) ", listed, re.MULTILINE):
        assert f"compwright {command}" in commands
    found = re.search(r"```yaml\n(.*?)```", readme, re.DOTALL)
    assert found is not None
    assert read_job(found[1].encode(), "README.md").axes["X"].axis.address == "AX1"


def test_help_names_no_command_of_later_work() -> None:
    output = CliRunner().invoke(group, ["--help"]).output
    assert not re.search(r"^  program ", output, re.MULTILINE)
