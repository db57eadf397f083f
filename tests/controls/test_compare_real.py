"""compare on two real backups: the whole backup read back with the plan's tables in it is the same;
a change that somebody made meanwhile to another axis is named, and nothing else is.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controls.control import open_control
from compwright.controls.control_files import read_files
from compwright.formats.text.container import opened
from compwright.foundations.session import Session
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from loop import Floats, Machine, csv_of
from places import REAL
from sinumerik_archive import ARCHIVE, needs_archive
from sinumerik_container import container

pytestmark = pytest.mark.short_estimate

FANUC = REAL / "fanuc"
SIEMENS = "siemens-840d-sl"
needs_backup = pytest.mark.skipif(
    not FANUC.is_dir(), reason="the real FANUC backup is not beside the project"
)


def planned(
    folder: Path, control: str, files: list[Path], address: str, travel: tuple[float, float]
) -> Path:
    """Run a job of one axis, measured with what the backup does to it, and return its results."""
    letter = "Y" if address == "AX2" else "X"  # MD10000 of the archive
    machine = Machine(low=travel[0], high=travel[1])
    given = open_control(Session(), control, {}).format
    shown = given.listing.for_display(given)
    axis = shown.read(read_files(Session(), files)).axes[address]

    def active(x: Floats, sign: int) -> Floats:
        side = Direction.POSITIVE if sign > 0 else Direction.NEGATIVE
        return axis.at(np.asarray(x, dtype=float), side)

    targets = machine.targets()
    measured = csv_of(targets, machine.measure(targets, 1, active), letter)
    (folder / "x.csv").write_text(measured)
    states = [word for path in files for word in ("--state", str(path))]
    command = ["run", str(folder / "x.csv"), "--format", control, "--axis", letter, *states]
    low, high = travel
    words = ["--travel", f"{low}:{high}", "--option", f"address={address}"]
    assert compwright([*command, *words, "--out", str(folder / "out")]) == 0
    return folder / "out"


def compare(out: Path, loaded: Mapping[str, bytes], place: Path) -> tuple[int, dict[str, Any]]:
    for name, content in loaded.items():
        (place / name).write_bytes(content)
    words = [word for name in loaded for word in ("--loaded", str(place / name))]
    answer = place / "answer.json"
    command = ["compare", str(out / "plan.json"), *words, "--json", str(answer), "--force"]
    code = compwright(command)
    document: dict[str, Any] = json.loads(answer.read_text())
    return code, document


def told(document: dict[str, Any]) -> set[tuple[str, str]]:
    return {
        (row["axis"], row["quantity"]) for row in document["differences"] if row["unit"] is None
    }


@needs_backup
def test_a_real_fanuc_backup(tmp_path: Path) -> None:
    files = [FANUC / "CNC-PARA.TXT", FANUC / "PITCH.TXT"]
    out = planned(tmp_path, "fanuc-30i", files, "1", (-1000, 0))
    tables = {path.name: path.read_bytes() for path in (out / "tables" / "fanuc-30i").iterdir()}
    turned = {name: content.replace(b"\n", b"\r\n") for name, content in reversed(tables.items())}
    code, answer = compare(out, turned, tmp_path)
    assert (code, answer["differences"], answer["elsewhere"]) == (0, [], [])
    pitch = re.sub(rb"(?m)^N10110Q0P-?\d+", b"N10110Q0P9", tables["PITCH.TXT"])
    code, answer = compare(out, {**tables, "PITCH.TXT": pitch}, tmp_path)
    assert (code, told(answer)) == (1, {("2", "N10110Q0")})
    old, new = b"N05861Q1A1P0A2P0A3P0", b"N05861Q1A1P0A2P0A3P7"
    assert tables["CNC-PARA.TXT"].count(old) == 1
    inclined = tables["CNC-PARA.TXT"].replace(old, new)
    code, answer = compare(out, {**tables, "CNC-PARA.TXT": inclined}, tmp_path)
    assert (code, told(answer)) == (1, {("3", "N05861Q1A3")})
    # 7 is a section of axis 3 there, and no data of X
    assert answer["axes"]["X"]["verdict"] == "loaded"


def read_back(tables: Path, changes: Mapping[str, str]) -> bytes:
    """The archive's container as the control would write it after the small files were loaded, and
    ``changes`` made.
    """
    values = dict(changes)
    for path in tables.iterdir():
        for line in path.read_text().splitlines():
            found = re.match(r"(\$\w+\[[^\]]*\])=(\S+)", line)
            if found is not None:
                values.setdefault(found[1], found[2])
    inside, _ = opened(ControlFile(ARCHIVE.name, ARCHIVE.read_bytes()))
    assert inside is not None
    members = []
    for text in inside.state:
        content = re.sub(
            r"(?m)^((?:N\d+ )?(\$\w+(?:\[[^\]\n]*\])?)=)([^\s;]+)",
            lambda row: row[1] + values.get(row[2], row[3]),
            text.content.decode("latin-1"),
        )
        name = text.name.rpartition(": ")[2]
        members.append(("\\_NC_ACT.DIR\\", name, content.encode("latin-1")))
    return container(members)


@pytest.fixture(scope="module")
def of_archive(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results of a job on the archive alone, which no test changes."""
    return planned(tmp_path_factory.mktemp("job"), SIEMENS, [ARCHIVE], "AX2", (-700, 0))


@needs_archive
def test_a_real_archive_in_its_container(of_archive: Path, tmp_path: Path) -> None:
    out = of_archive
    tables = out / "tables" / SIEMENS
    for changes, named, elsewhere in (
        ({}, set(), []),
        (
            {"$MN_MMC_CMD_TIMEOUT": "77", "$SN_CEC_TABLE_ENABLE[3]": "0"},
            {("AX3", "$SN_CEC_TABLE_ENABLE[3]")},
            ["$MN_MMC_CMD_TIMEOUT"],
        ),
    ):
        code, answer = compare(out, {"back.arc": read_back(tables, changes)}, tmp_path)
        assert (code, told(answer)) == (1 if named else 0, named)
        assert [group["quantity"] for group in answer["elsewhere"]] == elsewhere
        assert answer["not_looked_at"]["values"] == 0
    small = {path.name: path.read_bytes() for path in tables.iterdir()}
    code, answer = compare(out, small, tmp_path)
    assert code == 0
    assert answer["not_looked_at"]["values"] > 1000


@needs_archive
def test_a_second_visit_with_small_files_over_the_archive(of_archive: Path, tmp_path: Path) -> None:
    """What the small files repeat of the archive as a comment is said by the archive, and no
    difference; a neighbour that was changed meanwhile is one.
    """
    first = shutil.copytree(of_archive / "tables" / SIEMENS, tmp_path / "first")
    (tmp_path / "second").mkdir()
    for path in first.glob("*_EEC.INI"):  # three quarters of what the machine needs: a gain is left
        path.write_text(
            re.sub(
                r"(COMP\[\d,\d+,\w+\]=)(\S+)",
                lambda row: f"{row[1]}{0.75 * float(row[2]):.6f}",
                path.read_text(),
            )
        )
    state = [ARCHIVE, *sorted(first.iterdir())]
    out = planned(tmp_path / "second", SIEMENS, state, "AX2", (-700, 0))
    small = {path.name: path.read_bytes() for path in (out / "tables" / SIEMENS).iterdir()}
    back = {ARCHIVE.name: ARCHIVE.read_bytes(), **small}
    code, answer = compare(out, back, tmp_path)
    assert (code, answer["differences"], answer["axes"]["Y"]["verdict"]) == (0, [], "loaded")
    assert "CW-S080" not in [finding["code"] for finding in answer["findings"]]
    old = b"$MA_BACKLASH[0,AX3]="
    line = next(row for row in back[ARCHIVE.name].split(b"\n") if old in row)
    turned = line[:-1] + (b"1" if line[-1:] == b"0" else b"0")
    edited = back[ARCHIVE.name].replace(line + b"\n", turned + b"\n")
    code, answer = compare(out, {**back, ARCHIVE.name: edited}, tmp_path)
    assert (code, told(answer)) == (1, {("AX3", "$MA_BACKLASH[0,AX3]")})
