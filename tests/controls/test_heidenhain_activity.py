"""HEIDENHAIN: whether the table in the control acted while the axis was measured is read, or asked
for; never taken for granted.

A table acts where the bit of its axis in MP730 is 1 (TNC 407 technical manual p151), on NCK
controls where `*` marks the line of the .CMA that names it (MANUALplus 620 p718). A table alone
says neither.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()
NODES = np.arange(-50.0, 851.0, 50.0)
OLD = -2e-5 * NODES  # mm, errors that the old table holds
ITNC, NCK = "heidenhain-itnc530", "heidenhain-nck"
STAR = "BEGIN CONFIG.CMA MM\nNR  ACTIVE  X\n0   *       X.COM\n[END]\n"
LINE = "BEGIN CONFIG .CMA MM\nNR   1         2\n0    X\nEND   CONFIG .CMA\n"


PLAY = "# axis: X\n# value: error\npoint,position,value,unit\n{},,0.0000,mm\n"
PLAY_AND_SLOPE = {
    ITNC: PLAY.format("MP710") + "MP720,,0.0,mm/m\n",
    NCK: PLAY.format("backLash") + "linearCompValue,,0.0,mm/m\n",
}


def table(control: str, values: Floats) -> str:
    if control == NCK:
        rows = "".join(
            f"{k:<4d}{x:<+11.4f}{value:+.4f}\n"
            for k, (x, value) in enumerate(zip(NODES, values, strict=True))
        )
        return f"BEGIN X.COM MM\nNR  AXISPOS    X\n{rows}[END]\n"
    rows = "".join(f"{k:<5d}{value:+.4f}\n" for k, value in enumerate(values))
    return (
        f"BEGIN X      .COM MM DATUM:-50 DIST:50\nNR   1=F()     2=F()\n{rows}END   X      .COM\n"
    )


def run_without_backlash(
    folder: Path,
    control: str,
    answer: str = "",
    values: Floats = OLD,
    files: dict[str, str] | None = None,
) -> int:
    targets = MACHINE.targets()
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    (folder / "X.COM").write_text(table(control, values))
    names = {"cma": "CONFIG.CMA", "mp": "MP.TXT"}
    files = files or {}
    for key, text in files.items():
        (folder / names.get(key, key)).write_text(text)
    given = ", ".join(["X.COM", *(names.get(key, key) for key in files)])
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}}}\nstates: {{as_found: {{files:"
        f" [{given}]{answer}}}}}\naxes:\n  X: {{travel: [0, 800], before: [x.csv], table: {{start:"
        " -50, end: 850, spacing: 50}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


def run(
    folder: Path,
    control: str,
    answer: str = "",
    values: Floats = OLD,
    files: dict[str, str] | None = None,
) -> int:
    """The same with a backlash and a slope of 0 in the files, where no other backlash is."""
    files = dict(files or {})
    if "MP710" not in files.get("mp", ""):
        files["play.csv"] = PLAY_AND_SLOPE[control]
    return run_without_backlash(folder, control, answer, values, files)


def errors(folder: Path, control: str) -> Floats:
    """The new column of the axis, mm."""
    lines = (folder / "job" / "tables" / control / "X.COM").read_text().splitlines()[2:-1]
    return np.array([float(line.split()[-1]) for line in lines])


def without_answer(control: str) -> list[dict[str, str]]:
    """Files that leave it open."""
    return [{}] if control == NCK else [{}, {"cma": LINE}, {"mp": "MP710.0 : 0.0\n"}]


@pytest.mark.parametrize("control", [ITNC, NCK])
def test_files_that_leave_it_open_are_asked_about(
    tmp_path: Path, control: str, capsys: pytest.CaptureFixture[str]
) -> None:
    for files in without_answer(control):
        assert run(tmp_path, control, files=files) == 2
        said = capsys.readouterr().err
        assert "its table is not zero" in said
        assert "active: yes" in said
        assert not (tmp_path / "job" / "tables").exists()


@pytest.mark.parametrize("control", [ITNC, NCK])
def test_the_answer_decides_what_the_new_table_holds(tmp_path: Path, control: str) -> None:
    """With one measurement, the total of a table that acted is larger by just that table (its zero
    at the reference, 0 mm).
    """
    assert run(tmp_path, control, ", active: no") == 0
    slept = errors(tmp_path, control)
    assert run(tmp_path, control, ", active: yes") == 0
    acted = errors(tmp_path, control)
    inside = (NODES >= 0) & (NODES <= 800)
    np.testing.assert_allclose(
        (acted - slept)[inside], OLD[inside], atol=2.01e-4
    )  # mm: two roundings to 0.0001


@pytest.mark.parametrize(
    ("control", "files"),
    [(ITNC, {"mp": "MP710.0 : 0.0\nMP730 : %00001\n"}), (NCK, {"cma": STAR})],
    ids=["bit", "star"],
)
def test_files_that_say_it_need_no_answer_and_bear_no_other(
    tmp_path: Path, control: str, files: dict[str, str]
) -> None:
    assert run(tmp_path, control, files=files) == 0
    assert run(tmp_path, control, ", active: no", files=files) == 2


def test_a_switch_that_was_not_read_back_is_a_doubt(tmp_path: Path) -> None:
    """MP730 is one line for all axes; with bit 0 of X the table of the plan would not act."""
    assert run(tmp_path, ITNC, files={"mp": "MP710.0 : 0.0\nMP730 : %00001\n"}) == 0
    back = tmp_path / "job" / "tables" / ITNC
    answer = tmp_path / "answer.json"
    words = ["compare", str(tmp_path / "job"), "--loaded", str(back), "--json", str(answer)]
    assert compwright(words) == 0
    parameters = (back / "MP.TXT").read_text()
    (back / "MP.TXT").write_text(parameters.replace("MP730 : %00001\n", ""))
    assert compwright([*words, "--force"]) == 1
    document = json.loads(answer.read_text())
    assert document["verdict"] == "undecided"
    assert any("MP730" in one["message"] for one in document["doubts"])


def test_a_bit_of_0_is_an_answer(tmp_path: Path) -> None:
    assert run(tmp_path, ITNC, files={"mp": "MP710.0 : 0.0\nMP720.0 : 0.0\nMP730 : %00000\n"}) == 0
    slept = errors(tmp_path, ITNC)
    assert run(tmp_path, ITNC, ", active: no") == 0
    np.testing.assert_allclose(slept, errors(tmp_path, ITNC), atol=1e-9)


@pytest.mark.parametrize("control", [ITNC, NCK])
def test_a_table_of_zeros_asks_nothing(tmp_path: Path, control: str) -> None:
    assert run(tmp_path, control, values=0 * OLD) == 0


def test_a_slope_that_no_file_says_is_named_where_it_would_act(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It counts as 0, which is a doubt: nothing is decided."""
    assert run(tmp_path, ITNC, files={"mp": "MP710.0 : 0.0\nMP730 : %00000\n"}) == 1
    assert "MP720 is not in the files" in capsys.readouterr().out


@pytest.mark.parametrize(("control", "name"), [(ITNC, "MP710"), (NCK, "backLash")])
def test_a_backlash_that_is_written_over_is_asked_for(
    tmp_path: Path, control: str, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """A value that stands in the control is part of what was measured with; written over unseen, it
    is lost from the total.
    """
    files = {"cma": STAR} if control == NCK else {"mp": "MP730 : %00001\n"}
    assert run_without_backlash(tmp_path, control, files=files) == 2
    assert f"axis X (X): {name} is in none of the control's files" in capsys.readouterr().err
    assert not (tmp_path / "job" / "tables").exists()
    assert (
        run_without_backlash(tmp_path, control, files={**files, "play.csv": PLAY.format(name)}) == 0
    )
