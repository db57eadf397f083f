"""The grid that is in the control stays, on every control: the same nodes, and every byte that is
no value.

A second visit: a table every 50 mm is there, the job says no spacing. The error has become another
one, which a grid of compwright's choice would hold with other nodes.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from test_every_control import (
    ADDRESS,
    DISTINCT,
    FORMS,
    MET_OTHERWISE,
    OPTIONS,
    format_of,
    loaded,
    run_arguments,
    start_of,
    tables_in,
)

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.records.correction import ControlFile
from loop import Floats, Machine, csv_of

pytestmark = pytest.mark.short_estimate

NOW, LATER = Machine(), Machine(bow=0.009)
TARGETS = NOW.targets()
#: Values by maker: what stands before them, and what a value of nothing is.
VALUES = {
    "siemens": [(r"^(\$AA_ENC_COMP\[\d+,\d+,\w+\]=|\$AN_CEC\[\d+,\d+\]=|\$MA_BACKLASH\[.*\]=).*", r"\g<1>0.0")],
    "linuxcnc": [(r"^([-.\d]+) [-.\d]+ [-.\d]+$", r"\1 \1 \1")],
    "fanuc": [(r"^(N1\d{4}.*P)-?\d+", r"\g<1>0"), (r"^(N01851.*P)-?\d+", r"\g<1>0")],
    "heidenhain-itnc530": [
        (r"^(\d+ +)[-+][.\d]+", r"\g<1>+0"),
        (r"^(\d+,[^,]+,)[^,]+", r"\g<1>0.0"),
        (r"^(MP710\D*: )\S+|^(MP710,,)[^,]+", r"\g<1>\g<2>0.0"),
    ],
    "heidenhain-nck": [
        (r"^(\d+ +[-+][.\d]+ +)[-+][.\d]+", r"\g<1>+0"),
        (r"^(\d+,[^,]+,)[^,]+", r"\g<1>0.0"),
        (r"^(backLash,,)[^,]+", r"\g<1>0.0"),
    ],
    "isg": [(r"(\.(?:pos|neg) +)-?\d+", r"\g<1>0")],
    "pmac": [(r"(?<=[ \n])-?\d+(?=[ \n])", "0"), (r"^(I186=)-?\d+", r"\g<1>0")],
}  # fmt: skip


def without_values(name: str, file: ControlFile) -> str:
    """The text of a file with nothing in the place of every value."""
    text = file.content.decode("latin-1")
    of = next(rules for maker, rules in VALUES.items() if name.startswith(maker))
    for form, nothing in of:
        text = re.sub(form, nothing, text, flags=re.MULTILINE)
    if name.startswith("fanuc"):  # the magnification belongs to the values
        text = re.sub(r"^(N03623.*P)\d+", r"\g<1>1", text, flags=re.MULTILINE)
    return text


@dataclass(frozen=True)
class Visit:
    """A control with its files, and jobs on it. ``name``: the format, met as it is."""

    name: str
    folder: Path
    files: list[ControlFile]

    def run(self, *options: str, machine: Machine = LATER, acting: bool = True) -> int:
        home = self.folder / f"at-{machine.bow}"
        home.mkdir(exist_ok=True)
        for file in self.files:
            (home / file.name).write_bytes(file.content)
        now = loaded(self.files, self.name, machine) if self.files and acting else None
        (self.folder / "x.csv").write_text(csv_of(TARGETS, machine.measure(TARGETS, 1, now)))
        states = [str(home / file.name) for file in self.files] or ["none"]
        words = run_arguments(self.folder, self.name, machine, *states)
        return compwright([*words, "--force", *(f"--option={each}" for each in options)])

    def written(self) -> list[ControlFile]:
        return tables_in(self.folder, self.name)

    def points(self, files: list[ControlFile]) -> Floats:
        options = OPTIONS.get(format_of(self.name))
        control = virtual_control(format_of(self.name), files, options=options)
        return control.points(ADDRESS[format_of(self.name)])

    def findings(self) -> dict[str, str]:
        axis = json.loads((self.folder / "out" / "prediction.json").read_text())["axes"]["X"]
        return {one["code"]: one["message"] for one in axis["findings"]}


@pytest.fixture(scope="module")
def first_tables(
    tmp_path_factory: pytest.TempPathFactory,
) -> Callable[[str, int], list[ControlFile]]:
    """What compwright wrote on the first visit, once for each control and spacing."""

    @cache
    def first(name: str, spacing: int) -> list[ControlFile]:
        folder = tmp_path_factory.mktemp("first")
        start = start_of(name, folder / "start", NOW)
        files = [
            ControlFile(Path(each).name, Path(each).read_bytes())
            for each in start
            if each != "none"
        ]
        once = Visit(name, folder, files)
        assert once.run(f"spacing={spacing}", machine=NOW) == 0
        return once.written()

    return first


@pytest.fixture
def visit(
    first_tables: Callable[[str, int], list[ControlFile]], tmp_path: Path
) -> Callable[..., Visit]:
    """A control whose table every 50 mm compwright wrote on the first visit."""

    def there(name: str, spacing: int = 50) -> Visit:
        return Visit(name, tmp_path, first_tables(name, spacing))

    return there


Start = Callable[..., Visit]


@pytest.mark.parametrize("name", DISTINCT + MET_OTHERWISE)
def test_no_node_moves_and_no_byte_but_values(name: str, visit: Start) -> None:
    there = visit(name)
    assert there.run() == 0
    new = there.written()
    assert np.array_equal(there.points(there.files), there.points(new))
    assert new != there.files
    assert [file.name for file in new] == [file.name for file in there.files]
    for old, after in zip(there.files, new, strict=True):
        assert without_values(name, after) == without_values(name, old)


@pytest.mark.parametrize("name", FORMS)
def test_a_table_of_zeros_has_a_grid_all_the_same(name: str, visit: Start) -> None:
    there = visit(name)
    zeros = [
        ControlFile(file.name, without_values(name, file).encode("latin-1")) for file in there.files
    ]
    empty = Visit(name, there.folder, zeros)
    assert empty.run() == 0
    assert np.array_equal(there.points(there.files), empty.points(empty.written()))
    for old, after in zip(there.files, empty.written(), strict=True):
        assert without_values(name, after) == without_values(name, old)


@pytest.mark.parametrize("name", ["siemens-840d-sl", "fanuc-30i", "heidenhain-itnc530"])
def test_a_table_that_is_switched_off_has_a_grid_all_the_same(name: str, visit: Start) -> None:
    there = visit(name)
    switch = {
        "siemens-840d-sl": (b"COMP_ENABLE[0,AX1]=1", b"COMP_ENABLE[0,AX1]=0"),
        "heidenhain-itnc530": (b"MP730,,1", b"MP730,,0"),
        "fanuc-30i": (b"N03623Q1A1P1", b"N03623Q1A1P0"),
    }[name]
    files = [replace(file, content=file.content.replace(*switch)) for file in there.files]
    assert files != there.files
    off = Visit(name, there.folder, files)
    assert off.run(*(["active=no"] if name.startswith("siemens") else [])) == 0
    assert np.array_equal(there.points(there.files), off.points(off.written()))


@pytest.mark.parametrize("name", ["isg-kernel", "heidenhain-nck", "siemens-840d-sl"])
def test_a_table_that_did_not_act_as_the_job_says_has_a_grid_all_the_same(
    name: str, visit: Start
) -> None:
    there = visit(name)
    says = [
        replace(file, content=file.content.replace(b"$MA_ENC_COMP_ENABLE[0,AX1]=1\n", b""))
        for file in there.files
    ]
    off = Visit(name, there.folder, says)
    assert off.run("active=no", acting=False) == 0
    assert np.array_equal(there.points(there.files), off.points(off.written()))


@pytest.mark.parametrize("name", FORMS)
def test_auto_chooses_as_if_nothing_were_there(name: str, visit: Start) -> None:
    there = visit(name)
    assert there.run("spacing=auto") == 0
    assert not np.array_equal(there.points(there.files), there.points(there.written()))
    plan = str(there.folder / "out" / "plan.json")
    assert json.loads(Path(plan).read_text())["axes"]["X"]["request"]["spacing"] == "auto"
    states = [f"--state={there.folder / 'at-0.009' / file.name}" for file in there.files]
    again = str(there.folder / "again")
    assert compwright(["export", plan, "--format", format_of(name), *states, "--out", again]) == 0
    exported = [
        ControlFile(path.name, path.read_bytes())
        for path in sorted(Path(again).rglob("*"))
        if path.name in {file.name for file in there.written()}
    ]
    assert np.array_equal(there.points(there.written()), there.points(exported))


@pytest.mark.parametrize("name", ["siemens-840d-sl", "heidenhain-nck", "linuxcnc", "pmac"])
def test_a_coarse_grid_stays_and_another_one_is_offered(name: str, visit: Start) -> None:
    there = visit(name, spacing=200)
    assert there.run() == 0
    assert np.array_equal(there.points(there.files), there.points(there.written()))
    told = there.findings()["CW-P141"]
    assert "keeps the points of the existing table (5 points from 0 to 800 mm, every 200" in told
    before, after = (float(one) for one in re.findall(r"([.\d]+) µm at the same targets", told))
    assert before > 2 * after


def test_a_pmac_table_of_another_length_keeps_its_entries_and_its_length(tmp_path: Path) -> None:
    """30 entries of 40 mm, 2500000 counts each: 1200 mm for a travel of 800."""
    numbers = " ".join(["3"] * 29 + ["0"])
    script = f"I51=1\n#1 DEFINE COMP 30,#1D,75000000\n{numbers}\nI185=32\nI186=0\n"
    there = Visit("pmac", tmp_path, [ControlFile("table.pmc", script.encode())])
    assert there.run() == 0
    (new,) = there.written()
    assert b"#1 DEFINE COMP 30,#1D,75000000\n" in new.content
    assert len(new.content.splitlines()[2].split()) == 30
    assert "CW-P140" not in there.findings()


def test_a_pmac_table_that_repeats_within_the_travel_gets_a_new_grid(tmp_path: Path) -> None:
    script = "I51=1\n#1 DEFINE COMP 4,#1D,625000\n3 0 -3 0\nI185=32\nI186=0\n"
    there = Visit("pmac", tmp_path, [ControlFile("table.pmc", script.encode())])
    assert there.run() == 0
    assert "it repeats within the travel" in there.findings()["CW-P140"]


def test_an_isg_list_keeps_uneven_positions(tmp_path: Path, visit: Start) -> None:
    there = visit("isg-kernel")
    (file,) = there.files
    moved = re.sub(rb"(table\[3\].setpoint +)1500000", rb"\g<1>1333333", file.content)
    uneven = Visit("isg-kernel", tmp_path, [replace(file, content=moved)])
    assert uneven.run() == 0
    assert uneven.points(uneven.written())[3] == pytest.approx(133.3333, abs=1e-9)
    assert np.array_equal(uneven.points(uneven.files), uneven.points(uneven.written()))


def test_linuxcnc_keeps_uneven_positions(tmp_path: Path, visit: Start) -> None:
    there = visit("linuxcnc")
    lines = [
        replace(file, content=file.content.replace(b"150.0", b"133.3")) for file in there.files
    ]
    uneven = Visit("linuxcnc", tmp_path, lines)
    assert uneven.run() == 0
    assert uneven.points(uneven.written())[3] == pytest.approx(133.3, abs=1e-9)
    assert np.array_equal(uneven.points(uneven.files), uneven.points(uneven.written()))
