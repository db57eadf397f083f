"""compare on controls with cross-axis tables: a table switched off, a value of a sag table, a bit
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


@pytest.fixture(scope="module")
def isg(tmp_path_factory: pytest.TempPathFactory, measured: Path) -> Path:  # noqa: F811
    """A plan with a table of X (axis 1), on lists of both axes."""
    folder = _copied(tmp_path_factory, measured)
    for axis in (1, 2):
        entries = "".join(
            f"kw.ssfk.table[{i}].{key} {value}\n"
            for i, place in enumerate(range(0, 8_000_001, 1_000_000))
            for key, value in (("setpoint", place), ("pos", 10 * i * (axis - 1)), ("neg", 0))
        )
        (folder / f"achskw{axis}.lis").write_text(
            f"kopf.achs_nr {axis}\nkw.ssfk.unit 1\nkw.ssfk.interval 0\nkw.ssfk.kw_startpos 0\n"
            f"kw.ssfk.kw_nr_max 9\nkw.ssfk.bilateral 1\nkw.ssfk.modulo 0\n{entries}"
        )
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: isg-kernel}\n"
        "states: {as_found: [achskw1.lis, achskw2.lis]}\n"
        'axes:\n  X: {travel: [0, 800], address: "1", before: [x.csv]}\n'
    )
    assert compwright(["run", str(folder / "job.yaml"), "--force"]) == 0
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


def test_a_lost_column_of_a_heidenhain(heidenhain: Path, tmp_path: Path) -> None:
    """Y is no axis of the job; its column in the table of X, which was read back, is blank."""
    files = tables(heidenhain, NCK)
    lines = files["X.COM"].splitlines()
    kept = [line[: lines[1].index("Y")].rstrip() for line in lines[2:-1]]
    files["X.COM"] = "\n".join([*lines[:2], *kept, lines[-1]]) + "\n"
    code, answer = compare(heidenhain, files, tmp_path / "loaded")
    assert code == 1
    assert "X.COM row 5 Y" in {each["quantity"] for each in answer["differences"]}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("kw.ssfk.kw_startpos 0", "kw.ssfk.kw_startpos 100000"),  # not its first setpoint
        ("kw.ssfk.unit 1", "kw.ssfk.unit 0"),  # increments of unknown size
        ("kw.ssfk.bilateral 1", "kw.ssfk.bilateral 0"),  # next to a second column
    ],
)
def test_a_list_that_a_change_makes_unreadable(
    old: str, new: str, isg: Path, tmp_path: Path
) -> None:
    code, answer = compare(isg, put(tables(isg, "isg-kernel"), old, new), tmp_path / "loaded")
    assert (code, answer["axes"]["X"]["verdict"]) == (1, "unreadable")
    assert new.split(maxsplit=1)[0].rpartition(".")[2] in answer["axes"]["X"]["message"]


def test_a_neighbour_in_a_list_of_another_name(isg: Path, tmp_path: Path) -> None:
    loaded = tables(isg, "isg-kernel")
    neighbour = (isg / "achskw2.lis").read_text()
    for text, entries in ((neighbour, 0), (neighbour.replace("pos 30", "pos 40"), 1)):
        code, answer = compare(isg, {**loaded, "AXIS2.LIS": text}, tmp_path / str(entries))
        own = [one for one in answer["differences"] if one["unit"] is None]
        assert (code, len(own)) == (entries, entries)


@pytest.mark.parametrize(
    ("gone", "verdict"),
    [
        ("kw.ssfk.kw_nr_max 9\n", "undecided"),  # how many points the neighbour has
        ("kw.ssfk.table[4].setpoint 4000000\n", "different"),  # one of its points
    ],
)
def test_a_list_of_a_neighbour_that_became_unreadable(
    isg: Path, tmp_path: Path, gone: str, verdict: str, capsys: pytest.CaptureFixture[str]
) -> None:
    neighbour = (isg / "achskw2.lis").read_text().replace(gone, "")
    loaded = {**tables(isg, "isg-kernel"), "achskw2.lis": neighbour}
    code, answer = compare(isg, loaded, tmp_path / "loaded")
    assert (code, answer["verdict"], answer["axes"]["X"]["verdict"]) == (1, verdict, "loaded")
    assert "CW-S080" in {one["code"] for one in answer["doubts"]}
    if verdict == "different":
        entry = gone.split(maxsplit=1)[0]
        assert [one["quantity"] for one in answer["differences"]] == [entry]
        assert answer["differences"][0]["loaded"] is None
    assert compwright(
        ["compare", str(isg / "job" / "plan.json"), "--loaded", str(tmp_path / "loaded")]
    )
    text = " ".join(capsys.readouterr().out.split())
    assert text.index("Check first") < text.index("axis X:")
    assert "Read its files back again, completely, and repeat compwright compare" in text


def test_a_file_that_was_cut_off(sinumerik: Path, tmp_path: Path) -> None:
    files = tables(sinumerik, SIEMENS)
    cut = {**files, "MD.INI": files["MD.INI"].split("$MA_REFP_SET_POS")[0]}
    code, answer = compare(sinumerik, cut, tmp_path / "loaded")
    assert (code, answer["verdict"]) == (1, "undecided")
    assert {one["code"] for one in answer["doubts"]} == {"CW-S002"}


@pytest.fixture(scope="module")
def linuxcnc(tmp_path_factory: pytest.TempPathFactory, measured: Path) -> Path:  # noqa: F811
    """A plan with a table of X (joint 0); the INI and the tables of both joints are the state."""
    folder = _copied(tmp_path_factory, measured)
    joints = "".join(
        f"[JOINT_{n}]\nTYPE = LINEAR\nMAX_VELOCITY = 50\nMAX_ACCELERATION = 500\nHOME_OFFSET = 0\n"
        f"COMP_FILE = joint_{n}.comp\nCOMP_FILE_TYPE = 1\n"
        for n in range(2)
    )
    (folder / "m.ini").write_text(
        f"[KINS]\nKINEMATICS = trivkins coordinates=XY\nJOINTS = 2\n[TRAJ]\nLINEAR_UNITS = mm\n"
        f"{joints}"
    )
    for n in range(2):
        rows = "".join(f"{x:.1f} 0.00{n + 1} 0.00{n + 1}\n" for x in range(-50, 851, 50))
        (folder / f"joint_{n}.comp").write_text(rows)
    states = "[m.ini, joint_0.comp, joint_1.comp]"
    assert run(folder, "linuxcnc", x="before: [x.csv]", states=states, apply="{}") in (0, 1)
    return folder


@pytest.mark.parametrize(
    ("file", "gone", "verdict"),
    [
        ("", "", "same"),
        ("joint_1.comp", "800.0 0.002 0.002\n850.0 0.002 0.002\n", "different"),
        ("m.ini", "COMP_FILE = joint_1.comp\n", "undecided"),
    ],
)
def test_a_neighbour_of_a_linuxcnc(
    linuxcnc: Path, tmp_path: Path, file: str, gone: str, verdict: str
) -> None:
    """The keys of the new table are typed into the INI, and its type may change."""
    loaded = tables(linuxcnc, "linuxcnc")
    kind = next(line for line in loaded.pop("joint_0.ini").splitlines() if "TYPE" in line)
    ini = (linuxcnc / "m.ini").read_text().replace("COMP_FILE_TYPE = 1", kind, 1)
    back = {"m.ini": ini, "joint_1.comp": (linuxcnc / "joint_1.comp").read_text(), **loaded}
    if file:
        assert gone in back[file]
        back[file] = back[file].replace(gone, "")
    code, answer = compare(linuxcnc, back, tmp_path / "loaded")
    assert (code, answer["verdict"]) == (int(verdict != "same"), verdict), answer
    assert "CW-S080" not in {one["code"] for one in answer["findings"]}
    assert {one["axis"] for one in answer["differences"]} <= {"1"}


def test_the_switch_of_a_table_between_axes_is_missed(sinumerik: Path, tmp_path: Path) -> None:
    """MD32710 of the bent axis, next to machine data that were read back (S1 p237, p245)."""
    switch = "$MA_CEC_ENABLE[AX2]=1"
    lost = put(tables(sinumerik, SIEMENS), switch, ";")
    code, answer = compare(sinumerik, lost, tmp_path / "lost")
    assert (code, answer["verdict"]) == (1, "undecided")
    assert any("MA_CEC_ENABLE" in one["message"] for one in answer["doubts"])
