"""Machines over the years from their result folders: order, what changed, what is not as it was,
and what is no result at all.

The records are written here by hand, as docs/commands.md describes them.
"""

from __future__ import annotations

import csv
import hashlib
import json
import math
import os
import re
import sqlite3
from collections.abc import Callable, Iterator
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.documents.record_reading import faults_of_record
from compwright.foundations.session import Session
from compwright.workflow.commands import history as command
from compwright.workflow.history import result_folders
from compwright.workflow.history.history_entries import entries_of
from compwright.workflow.history.result_folders import ResultFolder

EMPTY: dict[str, Any] = {
    "schema": "compwright/record/1",
    "files": [],
    "inputs": [],
    "machine": {},
    "verification": None,
    "states": [],
}
TARGETS = [0.0, 100.0, 200.0, 300.0, 400.0]


def axis_test(
    *,
    B_mean: float = -2.0,
    A: float = 12.0,
    s: float = 0.5,
    date: str = "",
    taken: str = "before",
    axis: str = "X",
    key: str = "",
    **more: Any,
) -> dict[str, Any]:
    readings = key or f"{date} {taken} {axis} {A} {B_mean} {s}"
    return {
        "kind": "positioning",
        "name": axis.lower(),
        "taken": taken,
        "date": date,
        "simulated": False,
        "standard": "iso230-2:2014",
        "unit": "um",
        "sources": [hashlib.sha256(readings.encode()).hexdigest()],
        "axis": axis,
        "axis_kind": "linear",
        "targets": TARGETS,
        "n_runs": {"positive": 5, "negative": 5},
        "parameters": {"A": A, "E": A - 2.0, "M": 8.0, "R": 4.0, "B": -B_mean, "B_mean": B_mean},
        "uncertainty": {},
        "s": s,
        "std_error": {
            "A": {"value": 0.6, "dof": 40.0},
            "B": {"value": 0.3, "dof": 40.0},
            "B_mean": {"value": 0.1, "dof": 40.0},
            "s": {"value": s / math.sqrt(80.0), "dof": 40.0},
        },
        "measured_in": "as_found",
        **more,
    }


def circle(squareness: float, date: str) -> dict[str, Any]:
    return {
        "kind": "circular",
        "name": "xy",
        "taken": "before",
        "date": date,
        "simulated": False,
        "standard": "iso230-4:2005",
        "unit": "um",
        "sources": [f"{squareness} {date}"],
        "plane": "XY",
        "axes": ["X", "Y"],
        "parameters": {"G_bidirectional": 6.0},
        "squareness": {"value": squareness, "std_error": 2.0, "unit": "um/m"},
        "measured_in": "as_found",
    }


def record(folder: Path, *tests: dict[str, Any], **more: Any) -> Path:
    """A result folder with one file beside its record."""
    folder.mkdir(parents=True)
    (folder / "evaluation.json").write_text("{}", encoding="utf-8")
    content = {
        "schema": "compwright/record/1",
        "version": "0.1.0",
        "machine": {"name": "VMC", "serial": "S-1"},
        "inputs": [],
        "states": ["as_found"],
        "files": [
            {
                "file": "evaluation.json",
                "sha256": hashlib.sha256(b"{}").hexdigest(),
                "size": 2,
            }
        ],
        "tests": list(tests),
        "verification": None,
        **more,
    }
    (folder / "record.json").write_text(json.dumps(content), encoding="utf-8")
    return folder


Ask = Callable[..., dict[str, Any]]


@pytest.fixture
def ask(capsys: pytest.CaptureFixture[str]) -> Ask:
    def asked(*words: object, code: int = 0) -> dict[str, Any]:
        assert compwright(["history", *map(str, words), "--json", "-"]) == code
        document = json.loads(capsys.readouterr().out)
        assert isinstance(document, dict)
        return document

    return asked


def axis_of(document: dict[str, Any], name: str = "X") -> dict[str, Any]:
    (machine,) = document["machines"]
    one = machine["axes"][name]
    assert isinstance(one, dict)
    return one


def test_tests_stand_in_the_order_of_their_dates_the_undated_behind(
    tmp_path: Path, ask: Ask
) -> None:
    record(tmp_path / "b", axis_test(date="14.03.2024"))
    record(tmp_path / "c" / "deep", axis_test(date="20230102-101500"))
    record(tmp_path / "round-10", axis_test(A=1.0))
    record(tmp_path / "round-2", axis_test(A=2.0))
    record(tmp_path / "a", axis_test(date="03/04/2024"))  # March or April
    document = ask(tmp_path)
    tests = axis_of(document)["tests"]
    names = [Path(test["folder"]).relative_to(tmp_path).as_posix() for test in tests]
    assert names == ["c/deep", "b", "a", "round-2", "round-10"]
    assert [test["day"] for test in tests[:3]] == ["2023-01-02 10:15:00", "2024-03-14", ""]
    (note,) = document["notes"]
    assert "3 of 5 tests state no date (1 a date that can be read in two ways)" in note


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("22.11.2026 11:00 AM", "22.11.2026 1:30 PM"),
        ("2026-11-22 08:00", "2026-11-22"),  # nobody says that it was at midnight
        ("2026-11-22", "2026-11-22 08:00"),
    ],
)
def test_on_one_day_the_table_is_loaded_between_before_and_after(
    tmp_path: Path, ask: Ask, before: str, after: str
) -> None:
    """The other way round a table that took the lost motion away would look like a collision."""
    tests = (
        axis_test(date=before, B_mean=-5.0),
        axis_test(date=after, B_mean=0.0, taken="after"),
    )
    verification = {
        "verdict": "good",
        "axes": {"X": {"loading": {"verdict": "loaded"}, "read_back": "equal"}},
    }
    record(tmp_path / "a", *tests, verification=verification)
    one = axis_of(ask(tmp_path))
    assert [test["taken"] for test in one["tests"]] == ["before", "after"]
    sizes = [change["size"] for change in one["changes"] if change["parameter"] == "B_mean"]
    assert sizes == [pytest.approx(5.0)]


@pytest.mark.parametrize(
    ("before", "after"),
    [("", "2026-11-22 08:00"), ("2026-11-22 08:00", ""), ("03/04/2026", "2026")],
)
def test_a_test_without_a_date_keeps_its_side_of_the_loading(
    tmp_path: Path, ask: Ask, before: str, after: str
) -> None:
    """The table of the visit removed the lost motion; a later visit is dated in any case."""
    after = "2026-11-22" if after == "2026" else after
    tests = (
        axis_test(date=after, B_mean=0.0, taken="after"),
        axis_test(date=before, B_mean=-5.0),
    )
    verification = {"verdict": "good", "axes": {"X": {"loading": {"verdict": "loaded"}}}}
    record(tmp_path / "a", *tests, verification=verification)
    record(tmp_path / "b", axis_test(date="2027-11-22", B_mean=-0.1))
    one = axis_of(ask(tmp_path))
    assert [test["B_mean"] for test in one["tests"]] == [-5.0, 0.0, -0.1]


def test_dates_that_contradict_the_work_are_told(tmp_path: Path, ask: Ask) -> None:
    verification = {"verdict": "good", "axes": {"X": {"loading": {"verdict": "loaded"}}}}
    tests = (axis_test(date="2026-11-22"), axis_test(date="2025-11-23", taken="after"))
    record(tmp_path / "a", *tests, verification=verification)
    (note,) = ask(tmp_path)["notes"]
    assert "after loading is dated 2025-11-23, one before loading 2026-11-22" in note


def test_two_names_under_one_serial_number_are_told(tmp_path: Path, ask: Ask) -> None:
    for name, B_mean in (("VMC 400", -2.0), ("Lathe 7", -9.0)):
        named = {"name": name, "serial": "0000"}
        record(tmp_path / name, axis_test(date="2024-01-01", B_mean=B_mean), machine=named)
    (note,) = ask(tmp_path)["notes"]
    assert "0000" in note
    assert "VMC 400" in note
    assert "Lathe 7" in note


def test_rounds_without_dates_stand_in_their_order(tmp_path: Path, ask: Ask) -> None:
    """A next round names the test after loading first; those of the rounds before are older."""
    states = ["as_found", "round_2", "round_10", "round_1"]
    tests = [axis_test(B_mean=-float(i), measured_in=state) for i, state in enumerate(states)]
    record(tmp_path / "next", *tests, states=states)
    document = ask(tmp_path)
    assert [test["B_mean"] for test in axis_of(document)["tests"]] == [-3.0, -1.0, -2.0, 0.0]
    lost = [one for one in axis_of(document)["changes"] if one["parameter"] == "B_mean"]
    assert [one["size"] for one in lost] == [2.0, -1.0, 2.0]


def test_a_change_beyond_the_uncertainty_is_marked_with_its_size(tmp_path: Path, ask: Ask) -> None:
    """Standard errors 0.1 each: 7 µm are 7/√0.02 of them; 0.3 µm are two, which says nothing."""
    record(tmp_path / "1", axis_test(date="2023-01-01", B_mean=-2.0))
    record(tmp_path / "2", axis_test(date="2024-01-01", B_mean=-2.3))
    record(tmp_path / "3", axis_test(date="2025-01-01", B_mean=-9.3))
    one = axis_of(ask(tmp_path))
    found = {change["parameter"]: change for change in one["changes"]}
    assert set(found) == {"B", "B_mean"}
    change = found["B_mean"]
    assert (change["before"], change["after"]) == (1, 2)
    assert change["size"] == pytest.approx(-7.0)
    assert change["standard_errors"] == pytest.approx(-7.0 / math.hypot(0.1, 0.1), rel=1e-3)
    assert change["chance"] < 1e-6


def test_scatter_that_doubles_is_marked(tmp_path: Path, ask: Ask) -> None:
    """Four times the variance with 40 and 40 degrees of freedom: F(0.999) is 2.7 (printed tables)."""
    record(tmp_path / "1", axis_test(date="2023-01-01", s=0.5))
    record(tmp_path / "2", axis_test(date="2024-01-01", s=1.0))
    record(tmp_path / "3", axis_test(date="2025-01-01", s=1.5))  # 2.25 times
    changes = axis_of(ask(tmp_path))["changes"]
    assert [(change["parameter"], change["after"]) for change in changes] == [("s", 1)]


def test_scatter_that_differs_is_not_laid_to_the_machine_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record(tmp_path / "1", axis_test(date="2023-01-01", s=0.5))
    record(tmp_path / "2", axis_test(date="2024-01-01", s=1.5))
    assert compwright(["history", str(tmp_path)]) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "unchanged machine" not in told
    assert "The same machine, instrument and hall without drift" in told


def test_squareness_after_a_collision(tmp_path: Path, ask: Ask) -> None:
    for year, value in ((2023, 20.0), (2024, 24.0), (2025, 95.0)):
        record(tmp_path / str(year), circle(value, f"{year}-06-01"))
    (machine,) = ask(tmp_path)["machines"]
    (change,) = machine["planes"]["XY"]["changes"]
    assert (change["after"], change["size"], change["unit"]) == (2, 71.0, "um/m")
    assert change["standard_errors"] == pytest.approx(71.0 / math.hypot(2.0, 2.0), rel=1e-3)


def test_accuracy_allows_for_a_kelvin_where_nothing_is_declared(tmp_path: Path, ask: Ask) -> None:
    """11.5 µm/m over 400 mm are 4.6 µm: 5 µm say nothing, 25 µm do; with U declared 5 µm do."""
    declared = {"A": {"U": 0.4, "coverage": 2}}
    for number, (axis, A, stated) in enumerate(
        [
            *(("X", A, {}) for A in (10.0, 15.0, 40.0)),
            *(("Y", A, declared) for A in (10.0, 15.0)),
        ]
    ):
        test = axis_test(axis=axis, A=A, date=f"2023-01-0{number + 1}", uncertainty=stated)
        record(tmp_path / str(number), test)
    document = ask(tmp_path)
    (change,) = axis_of(document, "X")["changes"]
    assert (change["size"], change["undeclared"]) == (25.0, True)
    assert change["std_error"] == pytest.approx(math.hypot(0.6, 0.6, 4.6), rel=1e-6)
    (change,) = axis_of(document, "Y")["changes"]
    assert change["std_error"] == pytest.approx(math.hypot(0.6, 0.6, 0.2, 0.2), rel=1e-6)


def test_other_targets_or_another_standard_are_not_held_against_each_other(
    tmp_path: Path, ask: Ask
) -> None:
    moved = [target + 7.0 for target in TARGETS]
    record(tmp_path / "1", axis_test(date="2023-01-01", A=10.0))
    record(tmp_path / "2", axis_test(date="2024-01-01", A=90.0, B_mean=-4.0, targets=moved))
    record(tmp_path / "3", axis_test(date="2025-01-01", A=10.0, standard="iso230-2:1997"))
    changes = axis_of(ask(tmp_path))["changes"]
    assert {change["parameter"] for change in changes} == {"B_mean"}


def test_whether_the_same_table_acted_is_told_as_far_as_files_tell(
    tmp_path: Path, ask: Ask
) -> None:
    table = {"file": "tables/f/x.tab", "sha256": "cd" * 32, "size": 1}
    state = {"role": "state", "of": "as_found", "file": "x.tab", "copy": None, "by": "run"}
    loaded = {"verdict": "good", "axes": {"X": {"loading": {"verdict": "loaded"}}}}
    record(
        tmp_path / "1",
        axis_test(date="2023-01-01", B_mean=-9.0),
        axis_test(date="2023-01-02", B_mean=0.0, taken="after"),
        files=[table],
        verification=loaded,
    )
    later: dict[str, Any] = {"inputs": [{**state, "sha256": "cd" * 32, "size": 1}], "files": []}
    record(tmp_path / "2", axis_test(date="2024-01-01", B_mean=5.0), **later)
    other: dict[str, Any] = {"inputs": [{**state, "sha256": "ef" * 32, "size": 1}], "files": []}
    record(tmp_path / "3", axis_test(date="2025-01-01", B_mean=-5.0), **other)
    one = axis_of(ask(tmp_path))
    assert [test["table"] for test in one["tests"]] == ["none", "loaded", "as found", "as found"]
    changes = [change for change in one["changes"] if change["parameter"] == "B_mean"]
    assert [change["table"] for change in changes] == ["changed", "same", "unknown"]


def test_machines_stand_apart_by_serial_number_else_by_name(tmp_path: Path, ask: Ask) -> None:
    record(tmp_path / "1", axis_test(key="1"), machine={"name": "VMC", "serial": "S-1"})
    record(tmp_path / "2", axis_test(key="2"), machine={"name": "VMC", "serial": "S-2"})
    record(tmp_path / "3", axis_test(key="3"), machine={"name": "VMC", "serial": "s-1 "})
    record(tmp_path / "4", axis_test(key="4"), machine={"name": "VMC", "serial": "not given"})
    for name in ("5", "6"):  # nobody says which machine
        record(tmp_path / name, axis_test(key=name), machine={})
    machines = ask(tmp_path)["machines"]
    found = [
        [Path(test["folder"]).name for test in machine["axes"]["X"]["tests"]]
        for machine in machines
    ]
    assert found == [["1", "3"], ["2"], ["4"], ["5"], ["6"]]


def test_a_test_that_a_later_job_uses_again_is_one_test(tmp_path: Path, ask: Ask) -> None:
    loaded = {"verdict": "good", "axes": {"X": {"loading": {"verdict": "loaded"}}}}
    after = axis_test(taken="after", key="the test after loading")
    first = record(tmp_path / "job", axis_test(key="1"), after, verification=loaded)
    record(first / "next", {**after, "taken": "before"}, axis_test(key="1"))
    tests = axis_of(ask(tmp_path))["tests"]
    assert [(test["taken"], Path(test["folder"]).name) for test in tests] == [
        ("before", "job"),
        ("after", "job"),
    ]


def test_files_that_are_not_as_they_were_written_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record(tmp_path / "a", axis_test(key="1"))
    record(tmp_path / "b", axis_test(key="2"))
    (tmp_path / "a" / "evaluation.json").write_text("{ }", encoding="utf-8")
    (tmp_path / "b" / "evaluation.json").unlink()
    assert compwright(["history", str(tmp_path)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "evaluation.json: is not as it was written (its hash differs)" in said
    assert "evaluation.json: is not there any more" in said


def test_only_folders_that_changed_are_read_again(
    tmp_path: Path, ask: Ask, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("a", "b", "c"):
        record(tmp_path / "all" / name, axis_test(key=name, date="2024-01-01"))
    read: list[str] = []

    def reading(session: Session, path: Path) -> result_folders.ResultFolder:
        read.append(path.name)
        return result_folders.read_folder(session, path)

    monkeypatch.setattr(command, "read_folder", reading)
    index = ("--index", tmp_path / "i.sqlite")
    fresh = ask(tmp_path / "all", *index)
    assert read == ["a", "b", "c"]
    assert ask(tmp_path / "all", *index) == fresh
    assert read == ["a", "b", "c"]
    (tmp_path / "all" / "b" / "evaluation.json").write_text("{  }", encoding="utf-8")
    assert ask(tmp_path / "all", *index) != fresh
    assert read == ["a", "b", "c", "b"]
    (tmp_path / "all" / "c" / "record.json").unlink()
    assert len(axis_of(ask(tmp_path / "all", *index))["tests"]) == 2
    assert ask(tmp_path / "all", *index) == ask(tmp_path / "all")


def test_what_the_index_knows_is_not_overwritten_either(tmp_path: Path, ask: Ask) -> None:
    folder = record(tmp_path / "a", axis_test(date="2024-01-01"))
    index = ("--index", tmp_path / "i.sqlite")
    ask(folder, *index)
    before = (folder / "evaluation.json").read_bytes()
    words = ["history", folder, *index, "--table", folder / "evaluation.json", "--force"]
    assert compwright([str(word) for word in words]) == 5
    assert (folder / "evaluation.json").read_bytes() == before


def test_the_index_answers_other_programs(tmp_path: Path, ask: Ask) -> None:
    record(tmp_path / "a", axis_test(date="2024-01-01", A=12.5))
    ask(tmp_path / "a", "--index", tmp_path / "i.sqlite")
    with sqlite3.connect(tmp_path / "i.sqlite") as database:
        rows = database.execute("SELECT serial, axis, day, A, unit FROM test").fetchall()
    database.close()
    assert rows == [("S-1", "X", "2024-01-01", 12.5, "um")]


def other_database(path: Path) -> None:
    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE guests (name TEXT)")
    database.close()


def newer_index(path: Path) -> None:
    with sqlite3.connect(path) as database:
        database.execute(f"PRAGMA application_id = {0x63776869}")
        database.execute("PRAGMA user_version = 99")
        database.execute("CREATE TABLE folder (path TEXT)")
    database.close()


def cut_index(path: Path) -> None:
    record(path.parent / "x" / "y", axis_test(key="x"))
    assert compwright(["history", str(path.parent / "x"), "--index", str(path)]) == 0
    path.write_bytes(path.read_bytes()[:-4096])


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda path: path.write_text("A diary"), "is not an index of a history"),
        (lambda path: path.write_bytes(b""), "is not an index of a history"),
        (other_database, "another program's database"),
        (newer_index, "is an index of another version"),
        (cut_index, "is a damaged index"),
        (lambda path: path.mkdir(), "is not an index of a history"),
    ],
)
def test_what_is_no_index_is_refused_and_stays(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    make: Callable[[Path], object],
    words: str,
) -> None:
    index = tmp_path / "i.sqlite"
    make(index)
    before = index.read_bytes() if index.is_file() else None
    record(tmp_path / "a", axis_test())
    capsys.readouterr()
    assert compwright(["history", str(tmp_path / "a"), "--index", str(index), "--force"]) == 3
    assert words in capsys.readouterr().err
    assert (index.read_bytes() if index.is_file() else None) == before


@pytest.mark.parametrize(
    "content",
    [
        "{",
        "[]",
        '{"schema": "compwright/record/2"}',
        '{"schema": "compwright/record/1"}',
        '{"schema": "compwright/record/1", "files": 3, "inputs": []}',
        json.dumps({**EMPTY, "tests": [{"kind": "positioning"}]}),
        json.dumps({**EMPTY, "machine": [1], "tests": [1]}),
        json.dumps({**EMPTY, "tests": [axis_test(A=float("nan"))]}),
        json.dumps({**EMPTY, "tests": [axis_test(parameters={"A": 10**400})]}),
        json.dumps({**EMPTY, "tests": [axis_test(std_error={"s": {"value": 0.1, "dof": -5}})]}),
        json.dumps({**EMPTY, "tests": [axis_test(std_error={"A": {"value": 1e308, "dof": 4}})]}),
    ],
)
def test_a_damaged_record_is_named_and_the_rest_is_shown(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], content: str
) -> None:
    record(tmp_path / "good", axis_test())
    record(tmp_path / "bad")
    (tmp_path / "bad" / "record.json").write_text(content, encoding="utf-8")
    assert compwright(["history", str(tmp_path)]) == 3
    told = capsys.readouterr()
    assert "bad" in told.err
    assert "internal error of compwright" not in told.err
    assert "axis X" in told.out
    assert compwright(["history", str(tmp_path / "bad")]) == 3


def test_an_edited_record_is_refused_with_every_key_that_does_not_fit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edited = axis_test(unit=7, std_error={"A": {"value": -1.0, "dof": 4}}, sources="x")
    del edited["date"]
    folder = record(tmp_path / "a", axis_test(), edited, states={}, machine={"name": {"a": 1}})
    assert compwright(["history", str(folder)]) == 3
    told = capsys.readouterr().err
    places = [re.split("[ :]", line.partition("record.json: ")[2])[0] for line in told.splitlines()]
    assert sorted(places) == [
        "machine.name",
        "states",
        "tests[1].date",
        "tests[1].sources",
        "tests[1].std_error.A",
        "tests[1].unit",
    ]
    assert "Error" not in told


def leaves(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield path
    inside = dict(enumerate(value)) if isinstance(value, list) else value
    for key, below in inside.items() if isinstance(inside, dict) else ():
        yield from leaves(below, (*path, key))


def with_edit(whole: Any, path: tuple[Any, ...], put: Any) -> Any:
    edited = json.loads(json.dumps(whole))
    inner = edited
    for key in path[:-1]:
        inner = inner[key]
    if put is leaves:  # anything that no document holds
        del inner[path[-1]]
    else:
        inner[path[-1]] = put
    return edited


@pytest.mark.parametrize("put", [None, True, -1, "x", [], {}, [None], {"a": 1}, leaves])
def test_no_edit_of_a_record_ends_as_a_fault_of_our_own(put: Any) -> None:
    """Whatever passes the check can be shown, key by key of a whole record."""
    whole = {
        **EMPTY,
        "machine": {"name": "VMC", "serial": "S"},
        "states": ["as_found"],
        "inputs": [
            {"role": "state", "of": "as_found", "file": "f", "sha256": "0", "copy": None, "by": ""}
        ],
        "files": [{"file": "tables/f", "sha256": "1", "size": 2}],
        "tests": [
            axis_test(taken="after", uncertainty={"A": {"U": 1.0, "coverage": 2}}, targets=[0.0]),
            circle(20.0, "2024-01-01"),
        ],
        "verification": {
            "verdict": "good",
            "axes": {"X": {"loading": {"verdict": "loaded"}, "read_back": "equal"}},
        },
        "decisions": {
            "axes": {"X": {"accept": {"A": {"limit": 8.0}}}},
            "circles": {"xy": {"accept": {"G_ccw": {"limit": 8.0}}}},
        },
    }
    assert faults_of_record(whole) == []
    refused = 0
    for path in [path for path in leaves(whole) if path]:
        edited = with_edit(whole, path, put)
        faults = faults_of_record(edited)
        refused += bool(faults)
        if not faults:
            entries_of(ResultFolder(Path("a"), edited, (), (), ()))
    assert refused > 20


YEAR = 365.25


def over_years(
    top: Path,
    values: list[float],
    *,
    days: int = 91,
    acted: list[str] | None = None,
    limit: float | None = None,
) -> Path:
    """Result folders of one axis, a test every ``days`` days, with these mean reversal values;
    ``acted``: the state file of each.
    """
    for place, value in enumerate(values):
        day = date(2021, 1, 10) + timedelta(days=days * place)
        state = [] if acted is None else [{**STATE, "sha256": acted[place]}]
        accept = {} if limit is None else {"B": {"limit": limit}}
        record(
            top / f"visit-{place}",
            axis_test(
                B_mean=value,
                date=day.isoformat(),
                std_error={
                    "B": {"value": 0.1, "dof": 40.0},
                    "B_mean": {"value": 0.1, "dof": 40.0},
                },
            ),
            inputs=state,
            decisions={"axes": {"X": {"accept": accept}}},
        )
    return top


STATE = {"role": "state", "of": "as_found", "file": "f", "copy": None, "by": "run"}


def scattered(count: int, seed: int) -> list[float]:
    return [0.1 * value for value in np.random.default_rng(seed).standard_normal(count)]


def trend(document: dict[str, Any], parameter: str = "B_mean") -> dict[str, Any]:
    found = axis_of(document)["trends"][parameter]
    assert isinstance(found, dict)
    return found


def test_a_reversal_error_that_grows_by_small_steps_is_reported_with_its_rate(
    tmp_path: Path, ask: Ask, capsys: pytest.CaptureFixture[str]
) -> None:
    """No step alone is beyond the uncertainty: -2.98 to -4.77 um in 13 tests over three years."""
    grown = [-2.98 - 0.6 * 91 * place / YEAR + e for place, e in enumerate(scattered(13, 1))]
    over_years(tmp_path, grown)
    document = ask(tmp_path)
    assert axis_of(document)["changes"] == []
    found = trend(document)
    assert found["clear"]
    assert abs(found["rate_per_year"] + 0.6) < 3.0 * found["std_error"] < 0.25
    assert (found["unit"], found["n_tests"], found["first"]) == ("um", 13, grown[0])
    assert compwright(["history", str(tmp_path)]) == 0
    assert "µm per year (13 tests, 2021-01 to 2024-01)" in capsys.readouterr().out


def test_scatter_and_a_season_are_no_growth(tmp_path: Path, ask: Ask) -> None:
    for seed in range(4):
        season = [0.6 * math.sin(2.0 * math.pi * 91 * place / YEAR) for place in range(17)]
        values = [-3.0 + s + e for s, e in zip(season, scattered(17, seed), strict=True)]
        found = trend(ask(over_years(tmp_path / str(seed), values)))
        assert not found["clear"]
        assert found["jumps"] == []


def test_a_reversal_error_that_differs_from_day_to_day_is_no_change(
    tmp_path: Path, ask: Ask
) -> None:
    """Each test knows its own value to 0.1 um, the tests differ by 0.35 um; a step of 4 um stays
    one.
    """
    wrong = 0
    for seed in range(10):
        daily = 0.35 * np.random.default_rng(seed).standard_normal(14)
        values = [float(-3.0 - 4.0 * (place >= 6) + each) for place, each in enumerate(daily)]
        changes = axis_of(ask(over_years(tmp_path / str(seed), values)))["changes"]
        places = [one["after"] for one in changes if one["parameter"] == "B_mean"]
        assert 6 in places
        wrong += len(places) - 1
    assert wrong <= 2  # of 120


def test_a_repair_is_a_jump_and_no_rate(tmp_path: Path, ask: Ask) -> None:
    values = [-6.0 + 3.0 * (place >= 7) + e for place, e in enumerate(scattered(13, 2))]
    found = trend(ask(over_years(tmp_path, values)))
    assert not found["clear"]
    (jump,) = found["jumps"]
    assert (jump["before"], jump["after"]) == (6, 7)
    assert abs(jump["size"] - 3.0) < 3.0 * jump["std_error"] < 0.6


def test_a_collision_that_the_reversal_shows_is_no_growth_of_accuracy(
    tmp_path: Path, ask: Ask
) -> None:
    """A steps by 12 um among errors of temperature of 4 um: it alone could be growth."""
    for seed in range(8):
        hall, lost = np.random.default_rng(seed).standard_normal((2, 14))
        for place in range(14):
            hit = place >= 7
            day = date(2021, 1, 10) + timedelta(days=120 * place)
            test = axis_test(
                A=float(20.0 + 12.0 * hit + 4.0 * hall[place]),
                B_mean=float(-3.0 - 4.0 * hit + 0.1 * lost[place]),
                date=day.isoformat(),
                uncertainty={name: {"U": 8.0, "coverage": 2.0} for name in "AEM"},
            )
            record(tmp_path / str(seed) / f"visit-{place:02}", test)
        document = ask(tmp_path / str(seed))
        assert [jump["after"] for jump in trend(document)["jumps"]] == [7]
        assert not trend(document, "A")["clear"]


def test_the_rate_is_that_of_the_machine_where_tables_were_loaded(tmp_path: Path, ask: Ask) -> None:
    """Each yearly visit sets a reversal error back to zero that grows by 1.2 um a year."""
    scatter = iter(scattered(12, 3))
    errors = {"B_mean": {"value": 0.1, "dof": 40.0}}
    for visit in range(5):
        grown = 1.2 if visit else 3.0
        record(
            tmp_path / f"visit-{visit}",
            axis_test(B_mean=grown + next(scatter), date=f"{2020 + visit}-05-04", std_error=errors),
            axis_test(
                B_mean=next(scatter), date=f"{2020 + visit}-05-05", taken="after", std_error=errors
            ),
            inputs=[{**STATE, "sha256": f"state {visit}"}],
            files=[{"file": "tables/t", "sha256": f"table {visit}", "size": 1}],
            verification={
                "verdict": "good",
                "axes": {"X": {"loading": {"verdict": "loaded"}, "read_back": "equal"}},
            },
        )
    found = trend(ask(tmp_path))
    assert found["clear"]
    assert abs(found["rate_per_year"] - 1.2) < 3.0 * found["std_error"]


def test_the_day_on_which_a_limit_is_reached(tmp_path: Path, ask: Ask) -> None:
    """B is 3 um at first and grows by 1 um a year: its limit of 8 um is 5 years after the first."""
    values = [-3.0 - 1.0 * 91 * place / YEAR + e for place, e in enumerate(scattered(13, 4))]
    found = trend(ask(over_years(tmp_path, values, limit=8.0)), "B")
    crosses = found["crosses"]
    assert found["limit"] == 8.0
    assert crosses["earliest"] < crosses["day"] < crosses["latest"]
    assert crosses["earliest"] < "2026-01-09" < crosses["latest"]
    assert crosses["latest"] < "2027-06-01"
    assert (
        trend(ask(over_years(tmp_path / "falls", values[::-1], limit=8.0)), "B")["crosses"] is None
    )


def tilting(folder: Path, read: float = 0.0, **declared: dict[str, float]) -> None:
    """An arc of 6 um tilts by 6 um/m a year over 1 m: while the arc has its top between the ends,
    M grows by less than the tilt, then by all of it: M = 30 um, E = 32, A = 34 after 5 years.

    ``read``: what the instrument adds in every test, um/m.
    """
    along = np.linspace(0.0, 1.0, 11)
    random = np.random.default_rng(6)
    for place in range(13):
        day = date(2021, 1, 10) + timedelta(days=91 * place)
        slope = 6.0 * 91 * place / YEAR + read + 0.2 * random.standard_normal()
        mean = 6.0 * np.sin(np.pi * along) + slope * along + 0.03 * random.standard_normal((2, 11))
        both = mean + np.array([[-1.0], [1.0]])
        E, M = float(np.ptp(both)), float(np.ptp(both.mean(axis=0)))
        fitted = float(np.polyfit(along, both.mean(axis=0), 1)[0])
        values = {"A": E + 2.0, "E": E, "M": M, "B": 2.0, "B_mean": -2.0, "slope": fitted}
        test = axis_test(
            date=day.isoformat(),
            targets=list(1000.0 * along),
            mean_positive=list(both[0]),
            mean_negative=list(both[1]),
            parameters=values,
            uncertainty={**{name: {"U": 0.6, "coverage": 2.0} for name in "AEM"}, **declared},
        )
        limits = {name: {"limit": limit} for name, limit in (("A", 34), ("E", 32), ("M", 30))}
        decided = {"axes": {"X": {"accept": limits}}}
        record(folder / f"visit-{place:02}", test, decisions=decided)


@pytest.mark.parametrize("parameter", ["A", "E", "M"])
def test_a_growing_slope_passes_a_limit_when_the_formula_says_so(
    tmp_path: Path, ask: Ask, parameter: str
) -> None:
    tilting(tmp_path)
    crosses = trend(ask(tmp_path), parameter)["crosses"]
    assert crosses["earliest"] < "2026-01-09" < crosses["latest"]
    assert crosses["earliest"] > "2025-07-01"
    assert crosses["latest"] < "2026-07-01"


@pytest.mark.parametrize("read", [-4.0, 4.0])
def test_the_date_is_that_of_the_machine_not_of_its_instrument(
    tmp_path: Path, ask: Ask, read: float
) -> None:
    """A laser that reads 4 um/m too much in every test shows the limit 4/6 of a year early; its
    certificate states 6 um/m (k = 2), half a year at one standard uncertainty.
    """
    tilting(tmp_path / "stated", read, slope={"U": 6.0, "coverage": 2.0})
    tilting(tmp_path / "unknown", read)
    stated, unknown = (
        trend(ask(tmp_path / name), "E")["crosses"] for name in ("stated", "unknown")
    )
    assert stated["earliest"] < "2026-01-09" < stated["latest"]
    assert not unknown["earliest"] < "2026-01-09" < unknown["latest"]
    years = [date.fromisoformat(stated[end]).toordinal() / YEAR for end in ("earliest", "latest")]
    assert years[1] - years[0] == pytest.approx(2 * 1.645 * 3.0 / 6.0, rel=0.25)


def test_two_tests_have_no_rate(tmp_path: Path, ask: Ask) -> None:
    assert axis_of(ask(over_years(tmp_path, [-3.0, -5.0])))["trends"] == {}


def test_the_limit_of_a_mean_reversal_value_is_one_of_its_size(tmp_path: Path, ask: Ask) -> None:
    values = [-2.98 - 0.6 * 91 * place / YEAR + e for place, e in enumerate(scattered(13, 1))]
    over_years(tmp_path, values)
    for file in tmp_path.rglob("record.json"):
        content = json.loads(file.read_text(encoding="utf-8"))
        content["decisions"] = {"axes": {"X": {"accept": {"B_mean": {"limit": 5.0}}}}}
        file.write_text(json.dumps(content), encoding="utf-8")
    crosses = trend(ask(tmp_path))["crosses"]
    # 2.98 + 0.6 t = 5 after 3.37 years
    assert crosses["earliest"] < "2024-05-24" < crosses["latest"]


def test_a_change_between_two_tests_is_on_the_page(tmp_path: Path) -> None:
    over_years(tmp_path / "years", [-5.0, -45.0])
    page = tmp_path / "page.html"
    assert compwright(["history", str(tmp_path / "years"), "--page", str(page)]) == 0
    text = page.read_text(encoding="utf-8")
    assert "1 of 1 axes and planes changed beyond the uncertainty; 1 have too few tests" in text
    assert "mean B changed from −5.00 to −45.00 µm" in text
    assert "verdict good" not in text


def test_the_page_calls_no_axis_unchanged_that_nobody_can_judge(tmp_path: Path) -> None:
    over_years(tmp_path / "years", [-5.0, -5.0])
    page = tmp_path / "page.html"
    assert compwright(["history", str(tmp_path / "years"), "--page", str(page)]) == 0
    text = page.read_text(encoding="utf-8")
    assert "None of 1 axes and planes has enough tests for a rate" in text
    assert "beyond the uncertainty" not in text


def test_the_page_shows_each_axis_with_its_course(tmp_path: Path) -> None:
    values = [-3.0 - 0.25 * place + e for place, e in enumerate(scattered(9, 5))]
    over_years(tmp_path / "years", values, limit=9.0)
    page = tmp_path / "page.html"
    assert compwright(["history", str(tmp_path / "years"), "--page", str(page)]) == 0
    text = page.read_text(encoding="utf-8")
    assert text.count("<circle") == 9
    assert "µm per year (9 tests" in text
    assert "B reaches its limit 9.00 µm about" in text


def test_growth_that_is_not_clear_does_not_read_as_none(
    tmp_path: Path, ask: Ask, capsys: pytest.CaptureFixture[str]
) -> None:
    """Six tests, scattered by 0.1 um, of a reversal error that grows by 0.08 um a year."""
    values = [-3.0 - 0.08 * 91 * place / YEAR + e for place, e in enumerate(scattered(6, 8))]
    over_years(tmp_path / "years", values)
    page = tmp_path / "page.html"
    assert compwright(["history", str(tmp_path / "years"), "--page", str(page)]) == 0
    rates = r"mean B: growth is not clear, (\S+) to (\S+) µm per year is possible \(95 %\)"
    for text in (capsys.readouterr().out, page.read_text(encoding="utf-8")):
        [ends] = re.findall(rates, text)
        low, high = (float(end.replace("−", "-")) for end in ends)
        assert low < -0.08 < high
        assert trend(ask(tmp_path))["interval"] == pytest.approx([low, high], abs=0.005)
    assert not re.findall(r'class="(?:badge|verdict) good"', text)


def test_what_is_no_folder_with_results(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("x", encoding="utf-8")
    (tmp_path / "empty").mkdir()
    words = [str(tmp_path / name) for name in ("file", "empty", "nothing")]
    assert compwright(["history", *words]) == 3
    lines = [line for line in capsys.readouterr().err.splitlines() if line.startswith("error")]
    assert len(lines) == 3
    assert "found a file" in lines[0]


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="needs a folder without rights")
def test_a_folder_that_cannot_be_read_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    record(tmp_path / "good", axis_test())
    closed = record(tmp_path / "closed", axis_test(key="2"))
    closed.chmod(0)
    try:
        assert compwright(["history", str(tmp_path)]) == 3
    finally:
        closed.chmod(0o700)
    assert "closed" in capsys.readouterr().err


def test_control_characters_in_names_do_not_reach_the_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    test = axis_test(date="\x1b[2Jtoday", key="1", name="x\x1b]0;y\x07")
    machine = {"name": "VMC\x1b[31m", "serial": "S\r1"}
    record(tmp_path / "a\x1b[1m", test, machine=machine)
    table = tmp_path / "t.csv"
    assert compwright(["history", str(tmp_path), "--table", str(table)]) == 0
    told = capsys.readouterr()
    row = table.read_text(encoding="utf-8")
    assert not {"\x1b", "\x07", "\r"} & set(told.out + told.err + row)
    assert r"VMC\x1b[31m" in row


def test_half_a_character_in_an_edited_record(tmp_path: Path, ask: Ask) -> None:
    record(tmp_path / "a", axis_test(), machine={"name": "VMC \ud800"})
    (machine,) = ask(tmp_path, "--index", tmp_path / "i.sqlite")["machines"]
    assert machine["name"].startswith("VMC ")


def test_table_and_plot(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    record(tmp_path / "1", axis_test(date="2023-01-01"), circle(20.0, "2023-01-02"))
    record(tmp_path / "2", axis_test(date="2024-01-01", B_mean=-9.0), circle(80.0, "2024-01-01"))
    record(tmp_path / "3", axis_test(key="undated"), machine={"name": "other"})
    table, plot = tmp_path / "t.csv", tmp_path / "p.svg"
    words = ["history", str(tmp_path), "--table", str(table), "--plot", str(plot)]
    assert compwright(words) == 0
    with table.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [(row["axis"], row["date"], row["changed"]) for row in rows] == [
        ("X", "2023-01-01", ""),
        ("X", "2024-01-01", "B B_mean"),
        ("XY", "2023-01-02", ""),
        ("XY", "2024-01-01", "squareness"),
        ("X", "", ""),
    ]
    assert (rows[1]["B_mean"], rows[3]["squareness"]) == ("-9.000", "80.000")
    drawn = plot.read_bytes()
    assert drawn.startswith(b"<?xml")
    assert compwright(words) == 5
    assert compwright([*words, "--force"]) == 0
    assert plot.read_bytes() == drawn
    capsys.readouterr()
    assert compwright(["history", str(tmp_path), "--plot", str(tmp_path / "p.doc")]) == 2
    assert compwright(["history", str(tmp_path), "--plot", str(table), "--table", str(table)]) == 2


def test_a_folder_of_an_older_version_is_read_as_far_as_it_goes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], ask: Ask
) -> None:
    """Evaluation, plan and verification as they were written before there were records."""
    target = {
        "position": 100.0,
        **{f"n_{way}": 3 for way in ("positive", "negative")},
        **{f"s_{way}": 1.0 for way in ("positive", "negative")},
        "deviations_positive": [1.0, 2.0, 3.0],
        "deviations_negative": [4.0, 5.0, 6.0],
    }
    parameters = {"A": 9.0, "E": 3.0, "M": 1.0, "R": 7.0, "B": 3.0, "B_mean": -3.0}
    result = {
        "kind": "positioning",
        "name": "x",
        "axis": "X",
        "axis_kind": "linear",
        "standard": "iso230-2:2014",
        "coverage": 2.0,
        "unit": "um",
        "uncertainty": None,
        "sources": [{"file": "x.csv", "sha256": "ab"}],
        "header": {"Date": "2021-05-04"},
        "n_runs": {"positive": 3, "negative": 3},
        "parameters": parameters,
        "targets": [target, {**target, "position": 200.0}],
    }
    old = tmp_path / "old"
    old.mkdir()
    (old / "evaluation.json").write_text(json.dumps({"results": [result]}), encoding="utf-8")
    plan = {
        "version": "0.0.9",
        "machine": {"name": "VMC"},
        "states": {"as_found": []},
        "axes": {"X": {"tests": [{"name": "x", "measured_in": "as_found"}]}},
    }
    (old / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    after = {
        "unit": "um",
        "test": "x",
        "after": {**parameters, "A": 4.0},
        "expected": {"positions": [100.0, 200.0]},
        "loading": {"verdict": "loaded"},
    }
    verification = {"verdict": "good", "axes": {"X": after}}
    (old / "verification.json").write_text(json.dumps(verification), encoding="utf-8")
    tests = axis_of(ask(tmp_path))["tests"]
    assert [(test["taken"], test["A"], test["day"]) for test in tests] == [
        ("before", 9.0, "2021-05-04"),
        ("after", 4.0, ""),
    ]
    assert (tests[0]["s"], tests[0]["table"], tests[1]["verdict"]) == (1.0, "none", "good")
    assert compwright(["history", str(tmp_path)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "has no record (an older version): the files in it are not checked" in said
    (old / "evaluation.json").write_text('{"results": [{"kind": 1}]}', encoding="utf-8")
    assert compwright(["history", str(tmp_path)]) == 3


@pytest.mark.parametrize("name", ["../../secret.txt", "/etc/passwd", "C:\\secret.txt", "a\\..\\.."])
def test_a_record_names_no_file_outside_of_its_folder(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    entry = {"role": "test", "of": "X x", "file": "x.csv", "sha256": "0", "copy": name}
    record(tmp_path / "1", axis_test(date="2024-01-01"), inputs=[entry])
    assert compwright(["history", str(tmp_path)]) == 3
    said = " ".join(capsys.readouterr().err.split())
    assert "expected a name inside the result folder" in said
    assert "Next: give the file as compwright wrote it" in said


@pytest.mark.parametrize(("added", "copies"), [(0.0, 1), (3.25, 1), (0.001, 0)])
def test_readings_that_were_saved_again_with_another_date_are_told(
    tmp_path: Path, ask: Ask, added: float, copies: int
) -> None:
    """A copy, also from another zero of the instrument; one mean that differs is no copy."""
    forward = [0.12, 1.37, 2.05, 2.96, 4.21]
    backward = [2.03, 3.95, 4.08, 4.11, 6.4]
    for year in (2024, 2025):
        shift = added * (year - 2024)
        means = [value + shift for value in forward], [value + shift for value in backward]
        test = axis_test(date=f"{year}-01-01", mean_positive=means[0], mean_negative=means[1])
        record(tmp_path / str(year), test)
        if not copies:
            backward[2] += 0.02
    notes = [note for note in ask(tmp_path)["notes"] if "has the readings of" in note]
    assert len(notes) == copies
    assert all("2025: x has the readings of x in" in note for note in notes)
