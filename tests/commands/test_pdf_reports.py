"""``--report PATH.pdf`` of ``run`` and ``verify``: the report of the folder once more, on paper."""

from __future__ import annotations

import io
import re
import shlex
import sys
from pathlib import Path

import pypdf
import pytest

from compwright.cli import run as compwright
from compwright.reporting.pdf import pdf_of_page
from loop import Machine, csv_of

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages]

JOB = """\
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: AX1, before: [x.csv]}
report: {number: "2026-117"}
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a good test and a good job, the working directory of the case."""
    machine = Machine()
    targets = machine.targets()
    for number, name in enumerate(("x.csv", "after.csv"), 1):
        (tmp_path / name).write_text(csv_of(targets, machine.measure(targets, number)))
    (tmp_path / "job.yaml").write_text(JOB)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_run_and_verify_write_their_pages_as_pdf(folder: Path) -> None:
    assert compwright(["run", "job.yaml", "--report", "run.pdf"]) < 2
    verified = ["verify", "job.yaml", "--after", "after.csv", "--report", "verify.pdf"]
    assert compwright(verified) < 2
    for name, page in (("run.pdf", "report.html"), ("verify.pdf", "verification.html")):
        written = (folder / name).read_bytes()
        assert written == pdf_of_page((folder / "job" / page).read_bytes())
        text = pypdf.PdfReader(io.BytesIO(written)).pages[0].extract_text()
        assert "Report 2026-117" in text


def test_the_printed_command_repeats_the_verification(folder: Path) -> None:
    """What was read back belongs to it: without, a table that was not loaded looks the same."""
    assert compwright(["run", "job.yaml"]) < 2
    read_back = "job/tables/siemens-840d-sl"
    words = ["verify", "job.yaml", "--after", "after.csv", "--loaded", read_back]
    assert compwright(words) < 2
    page = folder / "job" / "verification.html"
    before = page.read_bytes()
    (command,) = re.findall(r"<code>compwright ([^<]*)</code>", before.decode())
    assert shlex.split(command) == words
    assert compwright([*shlex.split(command), "--force"]) < 2
    assert page.read_bytes() == before


def test_the_card_is_next_to_the_report(folder: Path) -> None:
    """At most a page for the control and one for each axis; the same bytes as its own page."""
    assert compwright(["run", "job.yaml", "--report", "run.pdf"]) < 2
    written = (folder / "run-card.pdf").read_bytes()
    assert written == pdf_of_page((folder / "job" / "card" / "card.html").read_bytes())
    pages = pypdf.PdfReader(io.BytesIO(written)).pages
    assert len(pages) <= 2
    text = " ".join(page.extract_text() for page in pages)
    assert "Commissioning card" in text
    assert "`" not in text


def test_wrong_names_are_refused_before_the_work(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for words in (["run", "job.yaml"], ["verify", "job.yaml", "--after", "after.csv"]):
        assert compwright([*words, "--report", "out.html"]) == 2
        assert "expected a name that ends in .pdf, found .html" in capsys.readouterr().err
    assert not (folder / "job").exists()


def test_one_file_for_two_answers_is_refused(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compwright(["run", "job.yaml", "--report", "a.pdf", "--json", "a.pdf"]) == 2
    assert "already used for --json" in capsys.readouterr().err
    assert not (folder / "job").exists()


def test_a_report_that_is_there_stays(folder: Path) -> None:
    (folder / "out.pdf").write_bytes(b"mine")
    assert compwright(["run", "job.yaml", "--report", "out.pdf"]) == 5
    assert (folder / "out.pdf").read_bytes() == b"mine"
    assert not (folder / "job").exists()


def test_without_the_pdf_extra_nothing_is_worked_out(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "typst", None)
    assert compwright(["run", "job.yaml", "--report", "out.pdf"]) == 2
    assert "-m pip install jinja2 matplotlib typst~=0.15.2" in capsys.readouterr().err
    assert not (folder / "job").exists()
