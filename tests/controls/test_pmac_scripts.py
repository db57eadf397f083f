"""Scripts of a PMAC whose order counts, and what its table does beyond the travel.

Sources: PMAC manuals (on-line commands are carried out as they come; a table repeats after its
length). The form of the first script, a list of all variables of a card, is that of the start-up
script of a Clipper (github DiamondLightSource/pmac, etc/bootstrap).
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

#: All variables as the card came; the second script is sent behind it.
VARIABLES = "I51=1\nI100=1\nI185=0\nI186=0\n"
#: 1000 counts per mm, 16 in a script is a count: 10 µm at 100 mm, lost motion of 3 µm.
TABLE = "#1 DELETE COMP\n#1 DEFINE COMP 4,200000\n80\n160\n240\n0\nI185=32\nI186=48\n"
MACHINE = Machine(low=0, high=150, slope=-60e-6, bow=0.001, lost=0.004, noise=0.0002)


def old(x: Floats, sign: int) -> Floats:
    """What the two scripts do in the order in which they were sent, mm."""
    curve = np.interp(x, [0, 50, 100, 150, 200], [0, 0.005, 0.010, 0.015, 0])
    return curve - (0.003 if sign < 0 else 0.0)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("scripts")
    (folder / "card").mkdir()
    (folder / "card" / "variables.pmc").write_text(VARIABLES)
    (folder / "card" / "tables.pmc").write_text(TABLE)
    targets = MACHINE.targets(8)
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1, old, runs=2)))
    job = {
        "compwright": 1,
        "controller": {"format": "pmac", "options": {"counts_per_unit": 1000}},
        "states": {"as_found": ["card/variables.pmc", "card/tables.pmc"]},
        "axes": {"X": {"travel": [0, 150], "address": 1, "before": ["x.csv"]}},
    }
    (folder / "job.yaml").write_text(json.dumps(job))
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    return folder


def test_the_card_says_in_which_order_the_scripts_are_sent(folder: Path) -> None:
    card = (folder / "job" / "card" / "card.md").read_text()
    assert "in this order: your own patched variables.pmc, tables.pmc" in card


def test_a_folder_whose_order_decides_what_acts_is_refused(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    tables = folder / "job" / "tables" / "pmac"
    options = ["--format", "pmac", "--option", "counts_per_unit=1000"]
    assert compwright(["decode", str(tables), *options]) == 3
    said = capfd.readouterr().err
    assert "I186: tables.pmc, line 8, says" in said
    assert "one by one, in the order in which they are sent" in said
    one_by_one = [str(tables / "variables.pmc"), str(tables / "tables.pmc")]
    assert compwright(["decode", *one_by_one, *options]) == 0


def test_a_table_that_repeats_beyond_its_travel_is_the_plan_when_read_back(folder: Path) -> None:
    tables = folder / "job" / "tables" / "pmac"
    scripts = [tables / "variables.pmc", tables / "tables.pmc"]
    options = {"counts_per_unit": 1000.0}
    state = control_format(DEFINITIONS["pmac"], options).read(
        [ControlFile(path.name, path.read_bytes()) for path in scripts], address="1"
    )
    new = state.axes["1"]

    def acts(x: Floats, sign: int) -> Floats:
        return new.at(x, Direction.POSITIVE if sign > 0 else Direction.NEGATIVE)

    targets = MACHINE.targets(8)
    (folder / "after.csv").write_text(csv_of(targets, MACHINE.measure(targets, 2, acts, runs=2)))
    back = shutil.copytree(tables, folder / "back")
    loaded = [word for path in scripts for word in ("--loaded", str(back / path.name))]
    after = ["--after", str(folder / "after.csv"), "--out", str(folder / "verified")]
    assert compwright(["verify", str(folder / "job.yaml"), *after, *loaded]) == 0
    said = json.loads((folder / "verified" / "verification.json").read_text())
    codes = {finding["code"] for finding in said["axes"]["X"]["findings"]}
    assert "CW-V010" in codes
    assert "CW-V011" not in codes


@pytest.mark.parametrize(
    ("first", "second", "refused"),
    [
        ("I51=1\nI185=32\nI186=48\n", "I186=0\n", True),
        ("I51=1\nI185=32\nI186=48\n", "I186=48\n", False),
        ("#1 DELETE COMP\nI186=0\n", "#1 DEFINE COMP 1,1000\n0\n", True),
        ("#1 DELETE COMP\nI186=0\n", "#2 DEFINE COMP 1,1000\n0\n", False),
    ],
)
def test_only_what_the_order_decides_is_refused(first: str, second: str, refused: bool) -> None:
    form = control_format(DEFINITIONS["pmac"], {"counts_per_unit": 1000.0})

    def read(folder: str) -> None:
        files = [
            ControlFile("a.pmc", first.encode(), folder),
            ControlFile("b.pmc", second.encode(), folder),
        ]
        form.read(files, address="1")

    read("")
    if not refused:
        read("card")
        return
    with pytest.raises(InputError, match="a folder has no order"):
        read("card")


def test_a_script_that_takes_in_another_file_is_refused_with_what_helps() -> None:
    form = control_format(DEFINITIONS["pmac"], {"counts_per_unit": 1000.0})
    script = b'I51=1\n#include "axes.h"\n#1 DEFINE COMP 1,1000\n0\n'
    with pytest.raises(InputError) as refused:
        form.read([ControlFile("a.pmc", script)], address="1")
    told = [str(fault) for fault in refused.value.faults]
    assert len(told) == 1
    assert "line 2" in told[0]
    assert "the content of that file in the place of this line" in told[0]
