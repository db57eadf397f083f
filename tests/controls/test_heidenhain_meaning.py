"""HEIDENHAIN: a control takes the values of a table as errors or as corrections, never both (no
manual says which).

What was typed in stands in entry sheets that say it (`# value`): the next round goes on in that
meaning, whether or not the job repeats the option, and a job that says the other is refused.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from loop import Floats, Machine, accuracy, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()
CONTROLS = ["heidenhain-itnc530", "heidenhain-nck"]


def run(folder: Path, control: str, state: str, options: str = "{}", own: str = "{}") -> int:
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {options}}}\nstates: {{as_found:"
        f" {state}}}\naxes:\n  X: {{travel: [0, 800], before: [x.csv], options: {own}}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force", "--out", str(folder / "out")])


def measure(folder: Path, sheet: Path | None, sign: int, seed: int, wear: float = 0.0) -> float:
    """Measure with ``sheet`` typed into a control that adds ``sign`` times its values; return A,
    µm. ``wear``: new slope, mm/mm.
    """
    targets = MACHINE.targets()
    nodes, values, backlash = np.zeros(1), np.zeros(1), 0.0
    if sheet is not None:
        rows = [line.split(",") for line in sheet.read_text().splitlines() if line[:1].isdigit()]
        nodes, values = (np.array([float(row[index]) for row in rows]) for index in (1, 2))
        said = [
            line.split(",")
            for line in sheet.read_text().splitlines()
            if line.startswith(("MP710", "backLash"))
        ]
        backlash = float(said[0][2])

    def acting(x: Floats, direction: int) -> Floats:
        return sign * np.interp(x, nodes, values) - (backlash if direction < 0 else 0.0) + wear * x

    readings = MACHINE.measure(targets, seed, acting)
    (folder / "x.csv").write_text(csv_of(targets, readings))
    return 1000 * accuracy(readings)


def first_round(folder: Path, control: str, options: str) -> Path:
    """Measure and write from zero; return the folder of what was typed in."""
    measure(folder, None, 1, 1)
    assert run(folder, control, "none", options) == 0
    (folder / "typed").mkdir()
    sheet = folder / "typed" / "entry_X.csv"
    sheet.write_bytes((folder / "out" / "tables" / control / "entry_X.csv").read_bytes())
    return sheet


@pytest.mark.parametrize("control", CONTROLS)
def test_the_next_round_goes_on_in_the_meaning_of_what_was_typed_in(
    tmp_path: Path, control: str
) -> None:
    sheet = first_round(tmp_path, control, "{table_values: correction}")
    worn = measure(tmp_path, sheet, 1, 2, wear=2e-5)
    assert worn > 12  # µm: 20 µm/m over 0.76 m of targets and what the first table left
    assert run(tmp_path, control, "[typed]") == 0  # the option is not repeated
    new = tmp_path / "out" / "tables" / control / "entry_X.csv"
    assert "# value: correction" in new.read_text()
    assert measure(tmp_path, new, 1, 3, wear=2e-5) < 4  # µm: noise of 0.4 µm alone gives 2 to 3


@pytest.mark.parametrize("control", CONTROLS)
def test_a_job_that_says_the_other_meaning_is_refused(
    tmp_path: Path, control: str, capsys: pytest.CaptureFixture[str]
) -> None:
    sheet = first_round(tmp_path, control, "{}")
    assert (
        measure(tmp_path, sheet, 1, 2) > 40
    )  # µm: the control takes corrections, the error doubles
    for words in ({"options": "{table_values: correction}"}, {"own": "{table_values: correction}"}):
        capsys.readouterr()
        assert run(tmp_path, control, "[typed]", **words) == 2
        assert "contradicts the entry sheet" in capsys.readouterr().err
    sheet.write_text(
        sheet.read_text().replace("# value: error", "# value: correction")
    )  # what the check showed
    assert run(tmp_path, control, "[typed]", "{table_values: correction}") == 0
    assert measure(tmp_path, tmp_path / "out" / "tables" / control / "entry_X.csv", 1, 3) < 4  # µm
