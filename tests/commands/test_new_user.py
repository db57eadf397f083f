"""A new user's first day: a spreadsheet of his own, as a German Excel saves it, from the file to the
table and the report in two commands; what was taken for granted is said on the way.

The spreadsheet is written here from numbers that the test knows, and not by compwright.
"""

from __future__ import annotations

import contextlib
import io
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from test_inputs_stay import tree

from compwright.cli import run as compwright
from compwright.instruments.header_words import stated_unit

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages]

HALL = "Prüfung Halle 3"
SHEET = f"{HALL}/X Achse – vorher.csv"
PROFILE = f"{HALL}/Profil für Süd.yaml"
OUT = f"{HALL}/Ergebnis März"
RUN = ["--format", "siemens-840d-sl", "--axis", "X", "--travel", "0:800", "--state", "none"]
RUN += ["--option", "address=AX1"]
TARGETS = [40.0 + 80.0 * i for i in range(10)]


_READING = re.compile(
    r"column '(\d)\. Messreihe (\w+)': at ([\d.]+) mm, approached from (below|above), the axis \w+"
    r" ([\d.]+) µm (too far|short)"
)


def deviation(target: float, *, up: bool, run: int) -> float:
    """µm, measured minus target: 20 µm/m too long, 4 µm of lost motion, and some scatter."""
    return 0.02 * target - (4.0 if up else 0.0) + ((run * 7 + round(target)) % 5 - 2) * 0.3


def comma(value: float, digits: int) -> str:
    return f"{value:.{digits}f}".replace(".", ",")


def sheet() -> bytes:
    """Semicolons, decimal commas, CRLF, the code page of Windows; wide, with a row of means."""
    runs = [(run, up) for run in range(1, 6) for up in (True, False)]
    names = [f"{run}. Messreihe {'aufwärts' if up else 'abwärts'}" for run, up in runs]
    rows = [["Abweichungen in µm (Ist - Soll)"], ["Prüfer: Jörg Müller"]]
    rows += [["Sollposition [mm]", *names]]
    for target in TARGETS:
        values = [deviation(target, up=up, run=run) for run, up in runs]
        rows.append([comma(target, 3), *(comma(value, 1) for value in values)])
    rows.append(["Mittelwert", *(["1,5"] * len(runs))])
    return "\r\n".join([*(";".join(row) for row in rows), ""]).encode("cp1252")


@pytest.fixture(scope="module")
def first_day(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str, str]:
    """The folder after the two commands, and what each of them said."""
    folder = tmp_path_factory.mktemp("Neu")
    (folder / HALL).mkdir()
    (folder / SHEET).write_bytes(sheet())
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        first = told(["profile", SHEET, "--out", PROFILE])
        second = told(["run", SHEET, *RUN, "--profile", PROFILE, "--out", OUT])
    return folder, first, second


def told(words: list[str]) -> str:
    """Run a command that must succeed, and return all that it says, in one line."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        assert compwright(words) == 0, err.getvalue()
    return " ".join((out.getvalue() + err.getvalue()).split())


def test_the_profile_reads_three_cells_in_words(first_day: tuple[Path, str, str]) -> None:
    _, said, _ = first_day
    assert "approached from below" in said
    assert "approached from above" in said
    assert "fill in" not in said
    assert "sign: measured minus target, the header says so" in said


def test_the_run_says_what_it_took_for_granted(first_day: tuple[Path, str, str]) -> None:
    """Sign, direction and unit in three readings, what nobody said, and what was not read."""
    folder, _, text = first_day
    assert "CW-R060" in text
    assert "(by the profile" in text
    readings = _READING.findall(text)
    assert len(readings) >= 3
    for run, way, target, side, size, how in readings:
        up = way == "aufwärts"
        value = deviation(float(target), up=up, run=int(run))
        assert (side, abs(float(size))) == ("below" if up else "above", round(abs(value), 1))
        assert how == ("too far" if (value > 0) == up else "short")
    for fact in ("axis X: kind", "axis X: reference ", "axis X: reference_return", "test: motion"):
        assert fact in text
    assert "CW-R059" in text
    assert "'Mittelwert; 1,5;" in text
    report = (folder / OUT / "report.html").read_text(encoding="utf-8")
    assert "CW-R060" in report
    assert "CW-R059" in report
    card = (folder / OUT / "card" / "card.md").read_text(encoding="utf-8")
    assert "as the file was read (CW-R060)" in card
    assert readings[0][2] + " mm, approached from" in card


def test_the_table_holds_the_error_that_was_put_in(first_day: tuple[Path, str, str]) -> None:
    """EEC values are the error itself, mm: 20 µm/m along the travel, of either sign's making."""
    folder, _, _ = first_day
    text = (folder / OUT / "tables" / "siemens-840d-sl" / "AX1_EEC.INI").read_text()
    rows = [line for line in text.splitlines() if "ENC_COMP[" in line]
    values = np.array([float(line.rpartition("=")[2]) for line in rows])
    slope = np.polyfit(np.linspace(0.0, 0.8, values.size), values * 1000.0, 1)[0]
    assert slope == pytest.approx(20.0, abs=1.0)


@pytest.mark.usefixtures("afresh")
def test_the_assumed_job_gives_the_same_bytes_with_the_profile(
    first_day: tuple[Path, str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(first_day[0], tmp_path / "again")
    monkeypatch.chdir(tmp_path / "again")
    before = tree(tmp_path / "again")
    assert compwright(["run", f"{OUT}/job.yaml", "--force"]) == 0
    assert tree(tmp_path / "again") == before


@pytest.mark.parametrize(
    ("line", "unit"),
    [
        ("Abweichungen in µm;;;", "um"),
        ("Deviation [mm];;", "mm"),
        ("Ecarts en µm", "um"),
        ("Unit of deviation: in", "in"),
        ("Units: in, mm", ""),
        ("Fehlergrenze 8 µm", ""),
        ("Error in position", ""),
    ],
)
def test_a_unit_above_a_table(line: str, unit: str) -> None:
    """A limit or a result is no title, and ``in`` before a unit is no inch."""
    assert stated_unit(line) == unit
