"""compare: every loading fault by its name; new: a job from the control's own files that runs when
filled in; run on a backup.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from compwright.verification.read_back import judge_read_back
from fanuc_backup import parameters, pitch_data
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine(low=-200, high=200, slope=40e-6, bow=0.006, lost=0.005)
UNIT = {"detection_unit": 0.001}


def backup(folder: Path, newline: str = "\n", lines: int = 300) -> list[Path]:
    folder.mkdir()
    paths = [folder / "CNC-PARA.TXT", folder / "PITCH.TXT"]
    paths[0].write_bytes(parameters(newline, lines=lines).encode())
    paths[1].write_bytes(pitch_data(newline).encode())
    return paths


def measured(folder: Path, state: list[Path], seed: int = 1) -> Path:
    """A test of X in the state of the backup."""
    targets = MACHINE.targets()
    judge = virtual_control(
        "fanuc-30i", [ControlFile(path.name, path.read_bytes()) for path in state], options=UNIT
    )

    def active(x: Any, sign: int) -> Any:
        return judge.correction("1", x, Direction.POSITIVE if sign > 0 else Direction.NEGATIVE)

    path = folder / "x.csv"
    path.write_text(csv_of(targets, MACHINE.measure(targets, seed, active)))
    return path


def run(folder: Path, state: list[Path], *options: str) -> int:
    words = [word for path in state for word in ("--state", str(path))]
    given = ("address=1", "detection_unit=0.001", "spacing=50", *options)
    return compwright(
        [
            *(
                "run",
                str(measured(folder, state)),
                "--format",
                "fanuc-30i",
                "--axis",
                "X",
                "--travel",
                "-200:200",
                *words,
            ),
            *(word for option in given for word in ("--option", option)),
            *("--out", str(folder / "out")),
        ]
    )


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run on a backup: ``control`` holds what was in the control, ``out`` what came of it."""
    folder = tmp_path_factory.mktemp("fanuc")
    assert run(folder, backup(folder / "control")) == 0
    return folder


def tables(folder: Path) -> dict[str, str]:
    return {
        path.name: path.read_text()
        for path in sorted((folder / "out" / "tables" / "fanuc-30i").iterdir())
    }


def compare(done: Path, folder: Path, loaded: dict[str, str]) -> tuple[int, dict[str, Any]]:
    words = []
    for name, text in loaded.items():
        (folder / name).write_text(text)
        words += ["--loaded", str(folder / name)]
    answer = folder / "compare.json"
    code = compwright(["compare", str(done / "out" / "plan.json"), *words, "--json", str(answer)])
    return code, json.loads(answer.read_text())


def by_number(text: str, number: int, change: Callable[[int], int]) -> str:
    """Change the value of axis 1 in one parameter."""
    found, count = re.subn(
        rf"(N0*{number}Q1A1P)(-?\d+)", lambda match: f"{match[1]}{change(int(match[2]))}", text
    )
    assert count == 1
    return found


def points_changed(text: str, change: Callable[[int, int], int]) -> str:
    """Change the values of the points of X (37 .. 44)."""
    return re.sub(
        r"N100(3[7-9]|4[0-4])Q0P(-?\d+)",
        lambda match: f"N100{match[1]}Q0P{change(int(match[1]), int(match[2]))}",
        text,
    )


def test_the_same_files_are_the_same(done: Path, tmp_path: Path) -> None:
    code, answer = compare(done, tmp_path, tables(done))
    assert (code, answer["schema"], answer["verdict"], answer["differences"]) == (
        0,
        "compwright/compare/1",
        "same",
        [],
    )
    assert answer["axes"]["X"]["verdict"] == "loaded"


def test_what_run_wrote_is_not_what_was_read_back(done: Path, tmp_path: Path) -> None:
    """A tired hand takes the folder that lies beside the plan: nothing was read from the control."""
    answer = tmp_path / "own.json"
    plan, own = str(done / "out" / "plan.json"), str(done / "out" / "tables" / "fanuc-30i")
    assert compwright(["compare", plan, "--loaded", own, "--json", str(answer)]) == 0
    own_files = json.loads(answer.read_text())
    told = [one for one in own_files["findings"] if one["code"] == "CW-S085"]
    assert [one["severity"] for one in told] == ["warning"]
    assert "They do not show what is in the control" in own_files["axes"]["X"]["message"]
    _, read_back = compare(done, tmp_path, tables(done))
    assert read_back["axes"]["X"]["message"] == "the table in the control is the planned table"
    assert "CW-S085" not in {one["code"] for one in read_back["findings"]}


def test_another_order_and_another_line_end_are_the_same(done: Path, tmp_path: Path) -> None:
    turned = {name: text.replace("\n", "\n\r\r") for name, text in reversed(tables(done).items())}
    assert compare(done, tmp_path, turned)[0] == 0


#: What happened at the control -> the files read back, the verdict, and the entry that must be
#: named.
FAULTS: dict[str, tuple[Callable[[str, str], tuple[str, str]], str, str | None]] = {
    "sign of all points": (
        lambda p, q: (p, points_changed(q, lambda _, value: -value)),
        "inverted",
        "N10044Q0",
    ),
    "doubled magnification": (
        lambda p, q: (by_number(p, 3623, lambda value: 2 * value), q),
        "scaled",
        "N03623Q1A1",
    ),
    "reference number one too high": (
        lambda p, q: (by_number(p, 3620, lambda value: value + 1), q),
        "shifted",
        "N03620Q1A1",
    ),
    "reference number one too low": (
        lambda p, q: (by_number(p, 3620, lambda value: value - 1), q),
        "shifted",
        "N03620Q1A1",
    ),
    "sign of 1851": (
        lambda p, q: (by_number(p, 1851, lambda value: -value), q),
        "backlash",
        "N01851Q1A1",
    ),
    "1851 forgotten": (lambda p, q: (by_number(p, 1851, lambda _: 0), q), "backlash", "N01851Q1A1"),
    "table switched off": (
        lambda p, q: (by_number(p, 3623, lambda _: 0), q),
        "not_active",
        "N03623Q1A1",
    ),
    "points cleared": (
        lambda p, q: (p, points_changed(q, lambda _, _value: 0)),
        "not_active",
        "N10044Q0",
    ),
    "one value mistyped": (
        lambda p, q: (
            p,
            points_changed(q, lambda number, value: value + 3 if number == 42 else value),
        ),
        "other",
        "N10042Q0",
    ),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_each_loading_fault_is_named(fault: str, done: Path, tmp_path: Path) -> None:
    change, verdict, entry = FAULTS[fault]
    own = tables(done)
    loaded = dict(zip(own, change(*own.values()), strict=True))
    code, answer = compare(done, tmp_path, loaded)
    assert (code, answer["verdict"]) == (1, "different")
    assert answer["axes"]["X"]["verdict"] == verdict, answer["axes"]["X"]["message"]
    assert entry in {difference["quantity"] for difference in answer["differences"]}
    assert set(answer["differences"][0]) == {"axis", "quantity", "planned", "loaded", "unit"}
    look = " ".join(answer["axes"]["X"]["look_at"])
    number = re.search(r"N0(\d{4})Q1", entry or "")  # of points: that they are to be looked at
    assert (not look) if verdict == "other" else ((number[1] if number else "points") in look)


# --- the rest of the backup


def line(text: str, old: str, new: str) -> str:
    assert text.count(old) == 1
    return text.replace(old, new)


#: What somebody changed meanwhile -> the files read back, whose it is, and the entry named.
MEANWHILE: dict[str, tuple[Callable[[str, str], tuple[str, str]], str, str]] = {
    "a neighbour's point": (
        lambda p, q: (p, line(q, "N10101Q0P3\n", "N10101Q0P2\n")),
        *("2", "N10101Q0"),
    ),
    "a point of no axis": (
        lambda p, q: (p, line(q, "N10500Q0P0\n", "N10500Q0P1\n")),
        *("", "N10500Q0"),
    ),
    "a neighbour's backlash": (
        lambda p, q: (re.sub(r"(N01851Q1A1P-?\d+A2P)2", r"\g<1>3", p), q),
        *("2", "N01851Q1A2"),
    ),
    "a neighbour's magnification": (
        lambda p, q: (re.sub(r"(N03623Q1A1P\d+A2P)2", r"\g<1>4", p), q),
        *("2", "N03623Q1A2"),
    ),
    "inclination of a neighbour": (
        lambda p, q: (p.replace("N03620Q1", "N05861Q1A1P0A2P120A3P0\nN03620Q1"), q),
        *("2", "N05861Q1A2"),
    ),
    "rapid traverse has a backlash of its own": (
        lambda p, q: (line(p, "N01800Q1P00000000", "N01800Q1P00010000"), q),
        *("", "N01800Q1"),
    ),
    "straightness over the axis": (
        lambda p, q: (p.replace("N03620Q1", "N05711Q1P1\nN03620Q1"), q),
        *("", "N05711Q1"),
    ),
}


@pytest.mark.parametrize("name", MEANWHILE)
def test_what_somebody_changed_meanwhile_is_named(name: str, done: Path, tmp_path: Path) -> None:
    change, axis, entry = MEANWHILE[name]
    loaded = tables(done)
    edited = change(loaded["CNC-PARA.TXT"], loaded["PITCH.TXT"])
    assert edited != (loaded["CNC-PARA.TXT"], loaded["PITCH.TXT"])
    code, answer = compare(done, tmp_path, dict(zip(loaded, edited, strict=True)))
    assert (code, answer["verdict"]) == (1, "different")
    assert answer["axes"]["X"]["verdict"] == "loaded"
    told = [(each["axis"], each["quantity"]) for each in answer["differences"]]
    assert (axis, entry) in told
    assert {one for one in told if not one[1].startswith("correction")} == {(axis, entry)}


def test_the_largest_change_of_a_neighbour_is_told(done: Path, tmp_path: Path) -> None:
    """One step less, magnification 2, 0.001 mm: 2 µm."""
    loaded = tables(done)
    loaded["PITCH.TXT"] = line(loaded["PITCH.TXT"], "N10101Q0P3\n", "N10101Q0P2\n")
    _, answer = compare(done, tmp_path, loaded)
    (row,) = [one for one in answer["differences"] if one["quantity"].startswith("correction")]
    assert row["axis"] == "2"
    assert abs(row["loaded"] - row["planned"]) == pytest.approx(2.0)


def test_what_compensates_nothing_is_listed_apart(done: Path, tmp_path: Path) -> None:
    loaded = tables(done)
    loaded["CNC-PARA.TXT"] = line(
        loaded["CNC-PARA.TXT"], "N00002Q1A1P0A2P-1A3P17A4P0\n", "N00002Q1A1P0A2P-1A3P17A4P5\n"
    )
    code, answer = compare(done, tmp_path, loaded)
    assert (code, answer["verdict"], answer["differences"]) == (0, "same", [])
    (group,) = answer["elsewhere"]
    assert group["changed"] == 1


def test_what_was_not_read_back_is_not_looked_at(done: Path, tmp_path: Path) -> None:
    loaded = tables(done)
    kept = [
        line
        for line in loaded["CNC-PARA.TXT"].split("\n")
        if not re.match(r"N0(1320|1321|1815|1800|1001)Q1", line)
    ]
    loaded["CNC-PARA.TXT"] = "\n".join(kept)
    code, answer = compare(done, tmp_path, loaded)
    assert code == 0
    assert answer["not_looked_at"]["values"] == 6  # 1001, 1800 and four of 1815
    assert "CW-S083" in [finding["code"] for finding in answer["findings"]]


def test_the_old_table_is_still_there(done: Path, tmp_path: Path) -> None:
    old = {path.name: path.read_text() for path in (done / "control").iterdir()}
    code, answer = compare(done, tmp_path, old)
    assert (code, answer["axes"]["X"]["verdict"]) == (1, "not_active")
    assert "before" in answer["axes"]["X"]["message"]


def test_a_difference_is_told_in_um_and_in_the_control_s_own_words(
    done: Path, tmp_path: Path
) -> None:
    own = tables(done)
    increment = int(re.search(r"N10044Q0P(-?\d+)", own["PITCH.TXT"])[1])  # type: ignore[index]
    mistyped = points_changed(
        own["PITCH.TXT"], lambda number, value: value + 10 if number == 44 else value
    )
    _, answer = compare(done, tmp_path, {**own, "PITCH.TXT": mistyped})
    rows = {row["quantity"]: row for row in answer["differences"]}
    assert (rows["N10044Q0"]["planned"], rows["N10044Q0"]["loaded"]) == (
        str(increment),
        str(increment + 10),
    )
    at_end = [row for name, row in rows.items() if name.startswith("correction at 200 mm")]
    assert len(at_end) == 2  # both directions
    for row in at_end:
        assert row["loaded"] - row["planned"] == pytest.approx(10.0, abs=1e-6)
        assert row["unit"] == "um"
    assert not any(name.startswith("correction at 150 mm") for name in rows)


def test_files_that_say_nothing_of_the_axis_are_an_error(done: Path, tmp_path: Path) -> None:
    text = "%\nN03620Q1A2P0\nN01851Q1A2P3\n%\n"
    (tmp_path / "other.txt").write_text(text)
    assert (
        compwright(
            ["compare", str(done / "out" / "plan.json"), "--loaded", str(tmp_path / "other.txt")]
        )
        == 3
    )


# What a table does, by arithmetic: no control needed
# ------------------------------------------------------------------------

NODES = np.arange(-150.0, 300.0, 50.0)
SHAPE = np.array([4.0, 1.0, 3.0, 0.0, -2.0, 5.0, 5.5, 9.0, 7.0]) * 1e-3


def correction(
    shape: Any = SHAPE, backlash: float = 0.004, factor: float = 1.0
) -> Callable[[Any, Direction], Any]:
    def at(positions: Any, direction: Direction) -> Any:
        return factor * np.interp(positions, NODES, shape) - (
            backlash if direction is Direction.NEGATIVE else 0.0
        )

    return at


@pytest.mark.parametrize(
    ("loaded", "verdict"),
    [
        (correction(), "loaded"),
        (correction(backlash=0.0), "backlash"),
        (correction(factor=-1.0), "inverted"),
        (correction(factor=2.0), "scaled"),
        (correction(shape=np.zeros(9)), "not_active"),
        (lambda x, side: correction()(np.asarray(x) - 50.0, side), "shifted"),
        (
            lambda x, side: (
                correction()(np.asarray(x) + 100.0, side) - correction()(100.0, Direction.POSITIVE)
            ),
            "shifted",
        ),
        (lambda x, side: correction()(np.asarray(x) * 1.01, side), "other"),
        (
            lambda x, side: (
                correction()(x, Direction.POSITIVE)
                if side is Direction.POSITIVE
                else 2e-6 * np.asarray(x)
            ),
            "one_direction",
        ),
    ],
)
def test_what_explains_a_difference(loaded: Any, verdict: str) -> None:
    nothing = correction(shape=np.zeros(9), backlash=0.0)
    assert judge_read_back(correction(), loaded, nothing, NODES, 50.0).verdict == verdict


@pytest.mark.parametrize("wrong", [1, 3])
def test_single_wrong_values_are_not_a_direction(wrong: int) -> None:
    """Of the values for arriving in + most are the plan's: somebody mistyped."""

    def mistyped(positions: Any, direction: Direction) -> Any:
        hit = (positions < NODES[wrong]) & (direction is Direction.POSITIVE)
        return correction()(positions, direction) + 0.003 * hit

    nothing = correction(np.zeros(9), backlash=0.0)
    answer = judge_read_back(correction(), mistyped, nothing, NODES, 50.0)
    assert answer.verdict == "other"
    assert f"at {wrong} of 18 positions" in answer.message


def test_a_table_without_shape_is_not_called_shifted_or_inverted() -> None:
    """Only a backlash was planned: another constant explains nothing but another backlash."""
    planned, loaded = correction(np.zeros(9)), correction(np.zeros(9), backlash=-0.007)
    nothing = correction(np.zeros(9), backlash=0.0)
    assert judge_read_back(planned, loaded, nothing, NODES, 50.0).verdict == "backlash"

    def both_sides(positions: Any, direction: Direction) -> Any:
        return np.full(np.shape(positions), 0.001 if direction is Direction.POSITIVE else -0.002)

    assert judge_read_back(planned, both_sides, nothing, NODES, 50.0).verdict == "other"


@pytest.mark.parametrize("nodes", [1, -1, 3, -5])
@pytest.mark.parametrize("own_zero", [0.0, 0.0125])
def test_a_shift_is_told_with_its_direction(nodes: int, own_zero: float) -> None:
    """A table that was meant at x and sits at x + 50 mm sits one node too far to +."""

    def loaded(positions: Any, direction: Direction) -> Any:
        return correction()(np.asarray(positions) - 50.0 * nodes, direction) - own_zero

    nothing = correction(np.zeros(9), backlash=0.0)
    answer = judge_read_back(correction(), loaded, nothing, np.linspace(-400, 600, 201), 50.0)
    assert answer.verdict == "shifted"
    assert (
        f"{abs(nodes)} point{'' if abs(nodes) == 1 else 's'} too far to {'+' if nodes > 0 else '-'}"
        in answer.message
    )


# run on a backup
# --------------------------------------------------------------------------------------------------


def test_rollback_card_and_changes(done: Path) -> None:
    for path in (done / "control").iterdir():
        assert (
            done / "out" / "rollback" / "fanuc-30i" / path.name
        ).read_bytes() == path.read_bytes()
    old = {path.name: path.read_text().splitlines() for path in (done / "control").iterdir()}
    new = {name: text.splitlines() for name, text in tables(done).items()}
    changed = [
        (was, now)
        for name, lines in new.items()
        for was, now in zip(old[name], lines, strict=True)
        if was != now
    ]
    rows = [
        row.split(",") for row in (done / "out" / "card" / "changes.csv").read_text().splitlines()
    ]
    assert rows[0] == ["entry", "old", "new"]
    assert len(rows) - 1 == len(changed)  # here every changed line holds one changed value
    for entry, was, now in rows[1:]:
        assert any(
            line.startswith(f"{entry}P{was}") and after.startswith(f"{entry}P{now}")
            for line, after in changed
        ), entry
    untouched = sum(map(len, old.values())) - len(changed)
    assert str(untouched) in (done / "out" / "card" / "card.md").read_text()


def test_the_sheet_beside_the_card_decodes_to_the_tables(done: Path, tmp_path: Path) -> None:
    answers = []
    for number, paths in enumerate(
        (
            sorted((done / "out" / "tables" / "fanuc-30i").iterdir()),
            [done / "out" / "card" / "entry_X.csv"],
        )
    ):
        answer = tmp_path / f"{number}.json"
        words = ["--option", "detection_unit=0.001", "--axis", "1", "--json", str(answer)]
        assert compwright(["decode", *map(str, paths), "--format", "fanuc-30i", *words]) == 0
        answers.append(json.loads(answer.read_text())["axes"]["1"])
    assert answers[0] == answers[1]


def test_a_detection_unit_that_nobody_says_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    state = backup(tmp_path / "control", lines=20)
    words = [word for path in state for word in ("--state", str(path))]
    csv = str(measured(tmp_path, state))
    assert (
        compwright(
            [
                "run",
                csv,
                "--format",
                "fanuc-30i",
                "--axis",
                "X",
                "--travel",
                "-200:200",
                *words,
                "--option",
                "address=1",
            ]
        )
        == 2
    )
    assert "detection_unit" in capsys.readouterr().err


def test_two_tables_without_the_control_s_own_bits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    state = backup(tmp_path / "control", lines=20)
    csv = str(measured(tmp_path, state))
    options = (
        "address=1",
        "detection_unit=0.001",
        "first_point=0",
        "spacing=50",
        "mode=bidirectional",
    )
    code = compwright(
        [
            *(
                "run",
                csv,
                "--format",
                "fanuc-30i",
                "--axis",
                "X",
                "--travel",
                "-200:200",
                "--state",
                "none",
            ),
            *(word for option in options for word in ("--option", option)),
        ]
    )
    assert code == 4
    assert "3605#0" in capsys.readouterr().err


def test_two_tables_into_a_backup(tmp_path: Path) -> None:
    assert run(tmp_path, backup(tmp_path / "control"), "mode=bidirectional") == 0
    text = tables(tmp_path)["CNC-PARA.TXT"]
    assert "N03605Q1A1P00000001A2P00000000A3P00000000A4P00000100\n" in text
    assert "N01851Q1A1P0A2P2A3P6A4P0\n" in text


def test_an_interval_below_what_the_feed_allows(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """400 000 mm/min / 7500 = 53.3 mm; 50 mm were asked for."""
    assert run(tmp_path, backup(tmp_path / "control", lines=20), "max_feed=400000") == 4
    assert "53.3" in capsys.readouterr().err


# new
# --------------------------------------------------------------------------------------------------


def test_a_new_job_is_filled_in_and_runs(tmp_path: Path) -> None:
    state = backup(tmp_path / "control", lines=50)
    csv = measured(tmp_path, state)
    job = tmp_path / "job.yaml"
    words = [word for path in state for word in ("--from", str(path))]
    assert compwright(["new", *words, "--format", "fanuc-30i", "--out", str(job)]) == 0
    draft = yaml.safe_load(job.read_text())
    assert draft["controller"] == {"format": "fanuc-30i", "options": {"detection_unit": None}}
    assert draft["states"]["as_found"] == ["control/CNC-PARA.TXT", "control/PITCH.TXT"]
    assert set(draft["axes"]) == {
        "X",
        "Y",
        "Z",
        "B",
    }  # 1020: 88, 89, 90, 66; Z only for its backlash
    x = draft["axes"]["X"]
    assert (x["travel"], str(x["address"]), x["kind"], x["before"]) == (
        [-210.0, 210.0],
        "1",
        "linear",
        None,
    )
    assert x["encoder"]["type"] == "absolute"
    assert (draft["axes"]["B"]["kind"], draft["axes"]["B"]["modulo"]) == ("rotary", 360.0)
    assert compwright(["run", str(job)]) == 2  # what is open is asked for

    draft["controller"]["options"]["detection_unit"] = 0.001
    draft["axes"] = {
        "X": {**x, "before": [csv.name], "options": {"max_feed": 24000}, "table": {"spacing": 70}}
    }
    job.write_text(yaml.safe_dump(draft))
    assert compwright(["run", str(job)]) == 0
    assert (tmp_path / "job" / "tables" / "fanuc-30i" / "CNC-PARA.TXT").exists()


@pytest.mark.parametrize(
    ("name", "options", "modulo"),
    [("siemens-840d-sl", [], 360.0), ("pmac", ["--option", "counts_per_unit=1000"], None)],
)
def test_a_table_that_repeats_is_an_axis_without_ends_where_a_file_says_that(
    name: str, options: list[str], modulo: float | None, tmp_path: Path
) -> None:
    """The tables of a PMAC all repeat, those of linear motors too; in both files nothing says
    whether the axis is linear or rotary.
    """
    texts = {
        "siemens-840d-sl": [
            *(f"$AA_ENC_COMP[0,{index},AX4]={value}" for index, value in enumerate((0, 0.01, 0))),
            "$AA_ENC_COMP_STEP[0,AX4]=180",
            "$AA_ENC_COMP_MIN[0,AX4]=0",
            "$AA_ENC_COMP_MAX[0,AX4]=360",
            "$AA_ENC_COMP_IS_MODULO[0,AX4]=1",
            "M17",
        ],
        "pmac": ["#1", "DEFINE COMP 4, #1, 800000", "16 32 16 0"],
    }
    (tmp_path / "own.txt").write_text("\n".join(texts[name]) + "\n")
    job = tmp_path / "job.yaml"
    words = ["--from", str(tmp_path / "own.txt"), "--format", name, *options, "--out", str(job)]
    assert compwright(["new", *words]) == 0
    (axis,) = yaml.safe_load(job.read_text())["axes"].values()
    assert (axis["kind"], axis.get("modulo")) == ("linear", modulo)


IN_INCREMENTS = """\
kopf.achs_nr 1
kw.ssfk.unit 0
kw.ssfk.modulo 0
kw.ssfk.interval 20000
kw.ssfk.kw_startpos 0
kw.ssfk.kw_nr_max 3
kw.ssfk.bilateral 0
kw.ssfk.table[0].pos 0
kw.ssfk.table[1].pos 10
kw.ssfk.table[2].pos 0
"""


@pytest.mark.parametrize(
    ("name", "text", "option", "modulo"),
    [
        ("pmac", "#1\nDEFINE COMP 4, #1, 800000\n16 32 16 0\n", "counts_per_unit", False),
        ("isg-kernel", IN_INCREMENTS, "encoder_increment", False),
        ("isg-kernel", IN_INCREMENTS.replace("modulo 0", "modulo 1"), "encoder_increment", True),
    ],
)
def test_a_number_that_no_file_says_is_left_open_in_a_new_job(
    name: str,
    text: str,
    option: str,
    modulo: bool,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (tmp_path / "own.txt").write_text(text)
    job = tmp_path / "job.yaml"
    words = ["--from", str(tmp_path / "own.txt"), "--format", name, "--out", str(job)]
    assert compwright(["new", *words]) == 0
    assert f"fill in: controller.options.{option}: " in capsys.readouterr().err
    draft = yaml.safe_load(job.read_text())
    assert draft["controller"]["options"] == {option: None}
    (axis,) = draft["axes"].values()
    assert (axis["travel"], axis.get("modulo")) == (None, None)  # no length by a number assumed
    assert ("modulo" in axis) == modulo
    assert compwright(["run", str(job)]) == 2  # what is open is asked for
    assert option in capsys.readouterr().err


def test_a_number_that_no_table_needs_is_not_left_open(tmp_path: Path) -> None:
    (tmp_path / "own.txt").write_text(IN_INCREMENTS.replace("unit 0", "unit 1"))
    job = tmp_path / "job.yaml"
    words = ["--from", str(tmp_path / "own.txt"), "--format", "isg-kernel", "--out", str(job)]
    assert compwright(["new", *words]) == 0
    assert "options" not in yaml.safe_load(job.read_text())["controller"]


def test_a_new_job_where_the_unit_was_given(tmp_path: Path) -> None:
    state = backup(tmp_path / "control", lines=50)
    words = [word for path in state for word in ("--from", str(path))]
    job = tmp_path / "job.yaml"
    assert (
        compwright(
            [
                "new",
                *words,
                "--format",
                "fanuc-30i",
                "--option",
                "detection_unit=0.0005",
                "--out",
                str(job),
            ]
        )
        == 0
    )
    assert (
        float(yaml.safe_load(job.read_text())["controller"]["options"]["detection_unit"]) == 0.0005
    )
    assert (
        compwright(["new", *words, "--format", "fanuc-30i", "--out", str(job)]) == 5
    )  # it is there already


REPEATING = """\
CHANDATA(1)
$MA_MM_ENC_COMP_MAX_POINTS[0,AX4]=3
$AA_ENC_COMP[0,0,AX4]=0
$AA_ENC_COMP[0,1,AX4]=0.002
$AA_ENC_COMP[0,2,AX4]=0
$AA_ENC_COMP_STEP[0,AX4]=180
$AA_ENC_COMP_MIN[0,AX4]=0
$AA_ENC_COMP_MAX[0,AX4]=360
$AA_ENC_COMP_IS_MODULO[0,AX4]=1
M17
"""
SCRIPT = "I51=0\n#1 DEFINE COMP 4,#1D,400000\n-32 -48 16 0\nI185=0 I186=0\nI51=1\n"


@pytest.mark.parametrize(
    ("control", "text", "option", "turn"),
    [
        # The table repeats, and no file says that the axis is rotary: the turn stays a question.
        ("siemens-840d-sl", REPEATING, "points=3", 360.0),
        # Here the length is that of the table, 400 mm, and no turn of the axis.
        ("pmac", SCRIPT, "counts_per_unit=1000", None),
    ],
)
def test_the_turn_of_a_table_that_repeats_goes_into_the_job(
    control: str, text: str, option: str, turn: float | None, tmp_path: Path
) -> None:
    own, job = tmp_path / "OWN.TXT", tmp_path / "job.yaml"
    own.write_text(text)
    words = ["--from", str(own), "--format", control, "--option", option, "--out", str(job)]
    assert compwright(["new", *words]) == 0
    (axis,) = yaml.safe_load(job.read_text(encoding="utf-8"))["axes"].values()
    assert axis.get("modulo") == turn
