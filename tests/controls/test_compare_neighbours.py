"""compare on controls with tables between axes: a table switched off, a value of a sag table, a bit
or a column of another axis changed meanwhile is named; the plan's own files are the same.

Runs: X with a table of its own, Y bent over X by + 40 µm/m (`test_run_apply`).
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from test_heidenhain_described import CMA, com
from test_run_apply import measured, run  # noqa: F401 - a fixture
from test_run_circles import CEC, SIEMENS

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

NCK, ITNC = "heidenhain-nck", "heidenhain-itnc530"
Files = dict[str, str]


@pytest.fixture(scope="module")
def sinumerik(tmp_path_factory: pytest.TempPathFactory, measured: Path) -> Path:  # noqa: F811
    """A plan with a table of X and a CEC table of Y over X, on files of both axes."""
    folder = _copied(tmp_path_factory, measured)
    (folder / "MD.INI").write_text(
        "CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0\n$MA_BACKLASH[0,AX2]=0\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n"
        "$MA_ENC_COMP_ENABLE[0,AX2]=0\n$MA_CEC_ENABLE[AX2]=0\n$MA_CEC_MAX_SUM[AX2]=1\n"
        "$MA_REFP_SET_POS[0,AX2]=5\n$MN_MM_CEC_MAX_POINTS[0]=100\nM17\n"
    )
    state = "[MD.INI]"
    assert run(folder, SIEMENS, options=CEC, x="before: [x.csv]", states=state) == 0
    return folder


@pytest.fixture(scope="module")
def heidenhain(tmp_path_factory: pytest.TempPathFactory, measured: Path) -> Path:  # noqa: F811
    """A plan with a table of X and the column of Y in it, in the user's own table."""
    folder = _copied(tmp_path_factory, measured)
    (folder / "X.COM").write_text(com(19, 50))
    (folder / "CONFIG.CMA").write_text(CMA)
    (folder / "p.csv").write_text(
        "# axis: X\n# value: error\npoint,position,value,unit\nbackLash,,0,mm\n"
    )
    x = "before: [x.csv], table: {start: -50, end: 850, spacing: 50}"
    assert run(folder, NCK, x=x, states="[X.COM, CONFIG.CMA, p.csv]") == 0
    return folder


def _copied(factory: pytest.TempPathFactory, source: Path) -> Path:
    folder = factory.mktemp("compared")
    for file in source.iterdir():
        (folder / file.name).write_bytes(file.read_bytes())
    return folder


def tables(folder: Path, control: str) -> Files:
    loaded = folder / "job" / "tables" / control
    return {path.name: path.read_text() for path in loaded.iterdir()}


def compare(folder: Path, loaded: Files, place: Path) -> tuple[int, dict[str, Any]]:
    place.mkdir(exist_ok=True)
    for name, text in loaded.items():
        (place / name).write_text(text)
    answer = place.parent / "answer.json"
    code = compwright(
        [
            *("compare", str(folder / "job" / "plan.json"), "--loaded", str(place)),
            *("--json", str(answer), "--force"),
        ]
    )
    document: dict[str, Any] = json.loads(answer.read_text())
    return code, document


def put(files: Files, old: str, new: str) -> Files:
    found = [name for name, text in files.items() if old in text]
    assert found, old
    return {name: text.replace(old, new) for name, text in files.items()}


def test_what_was_written_is_the_same(sinumerik: Path, heidenhain: Path, tmp_path: Path) -> None:
    for folder, control in ((sinumerik, SIEMENS), (heidenhain, NCK)):
        code, answer = compare(folder, tables(folder, control), tmp_path / control)
        assert (code, answer["differences"]) == (0, []), answer["differences"]


@pytest.mark.parametrize(
    ("old", "new", "axis", "entry"),
    [
        ("$MA_CEC_ENABLE[AX2]=1", "$MA_CEC_ENABLE[AX2]=0", "AX2", "$MA_CEC_ENABLE[AX2]"),
        ("$MA_CEC_MAX_SUM[AX2]=1", "$MA_CEC_MAX_SUM[AX2]=0.5", "AX2", "$MA_CEC_MAX_SUM[AX2]"),
        ("$MA_BACKLASH[0,AX2]=0", "$MA_BACKLASH[0,AX2]=0.01", "AX2", "$MA_BACKLASH[0,AX2]"),
        ("$MA_REFP_SET_POS[0,AX2]=5", "$MA_REFP_SET_POS[0,AX2]=6", "AX2", "$MA_REFP_SET_POS"),
        ("$MA_ENC_COMP_ENABLE[0,AX2]=0", "$MA_ENC_COMP_ENABLE[0,AX2]=1", "AX2", "$MA_ENC_COMP"),
    ],
)
def test_a_neighbour_of_a_sinumerik(
    sinumerik: Path, tmp_path: Path, old: str, new: str, axis: str, entry: str
) -> None:
    loaded = put(tables(sinumerik, SIEMENS), old, new)
    code, answer = compare(sinumerik, loaded, tmp_path / "loaded")
    assert (code, answer["verdict"]) == (1, "different")
    assert answer["axes"]["X"]["verdict"] == "loaded"
    told = [each for each in answer["differences"] if each["unit"] is None]
    assert len(told) == 1
    assert told[0]["axis"] == axis
    assert told[0]["quantity"].startswith(entry)


def test_a_table_between_axes_of_a_sinumerik(sinumerik: Path, tmp_path: Path) -> None:
    """A table over the axis of the plan is told with it: the entry, and by how much it changed."""
    files = tables(sinumerik, SIEMENS)
    row = next(
        line
        for text in files.values()
        for line in text.splitlines()
        if line.startswith("$AN_CEC[") and not line.endswith("=0")
    )
    code, answer = compare(
        sinumerik, put(files, f"{row}\n", f"{row.split('=')[0]}=0.5\n"), tmp_path / "loaded"
    )
    assert code == 1
    quantities = [each["quantity"] for each in answer["differences"]]
    assert row.split("=")[0] in quantities
    assert any(one.startswith("correction of AX2 over X, largest change") for one in quantities)


@pytest.mark.parametrize(
    ("file", "column", "axis"), [("X.COM", 3, "X"), ("X.COM", 2, "X"), ("CONFIG.CMA", 1, None)]
)
def test_a_cell_of_a_heidenhain(
    heidenhain: Path, tmp_path: Path, file: str, column: int, axis: str | None
) -> None:
    """Column Y of the table of X belongs to both; no mark in ACTIVE: nothing acts any more."""
    files = tables(heidenhain, NCK)
    if file == "CONFIG.CMA":
        files[file] = files[file].replace("*", " ")
    else:
        lines = files[file].splitlines()
        cell = lines[7].split()[column]
        lines[7] = lines[7].replace(cell, f"{float(cell) + 0.02:+.4f}", 1)
        files[file] = "\n".join(lines) + "\n"
    code, answer = compare(heidenhain, files, tmp_path / "loaded")
    assert code == 1
    if axis is None:
        assert answer["axes"]["X"]["verdict"] == "not_active"
        return
    name = f"X.COM row 5 {'Y' if column == 3 else 'X'}"
    assert name in {each["quantity"] for each in answer["differences"] if each["axis"] == axis}
    assert answer["axes"]["X"]["verdict"] == ("loaded" if column == 3 else "other")
