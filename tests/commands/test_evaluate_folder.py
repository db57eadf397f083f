"""``evaluate`` of many files: a line each, a summary and a table; nothing that is wrong with one
file costs another one its result.
"""

from __future__ import annotations

import copy
import csv
import io
import os
import pickle
import re
import sys
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from compwright.cli.shell import run
from compwright.evaluation import standards
from compwright.foundations import parallel_work
from compwright.foundations.errors import StorageError, UsageError
from compwright.foundations.parallel_work import Each
from compwright.foundations.session import Session
from compwright.reporting.safe_text import print_renderables
from compwright.workflow.commands import evaluate as command
from compwright.workflow.commands.evaluate import (
    EvaluationRun,
    evaluate_files,
    many_renderables,
    write_evaluation,
)
from compwright.workflow.inputs import file_evaluation
from compwright.workflow.results import progress as showing
from compwright.workflow.results.answers import to_json

TARGETS = (3.0, 110.5, 190.0, 310.0, 403.0)
WHOLE = 400.0  # mm from the first target to the last
OFF = (0.3, -0.3, 0.1, -0.1, 0.0)  # µm, of five runs


def positioning_text(slope: float, axis: str = "X", seed: int = 0) -> str:
    """A slope in µm over the travel, 2 µm less in +; runs that differ by a constant each, and at
    every target by something of their own, which is 0 in the mean.
    """
    rows = [f"# axis: {axis}", "target_mm,direction,run,deviation_um"]
    for place, x in enumerate(TARGETS):
        for direction, lost in (("+", -2.0), ("-", 0.0)):
            turned = OFF[(place + seed) % 5 :] + OFF[: (place + seed) % 5]
            rows += [
                f"{x},{direction},{number},{slope * (x - 3.0) / WHOLE + lost + off:.4f}"
                for number, off in enumerate(turned, start=1)
            ]
    return "\n".join(rows) + "\n"


#: Not evenly spread: their mean is not their median.
SLOPES = {f"t{place:02}.csv": 4.0 + place + 9.0 * (place == 10) for place in range(12)}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Twelve sound tests of X and Y, one of a rotary axis, a circle in two files, and files that
    cannot be read.
    """
    made = tmp_path_factory.mktemp("archive")
    for place, (name, slope) in enumerate(SLOPES.items()):
        text = positioning_text(slope, "XY"[place % 2], place)
        (made / name).write_text(text, encoding="utf-8")
    rotary = "\n".join(
        f"{target},{direction},{number},{target / 36.0 + number * 0.1:.3f}"
        for target in range(0, 331, 30)
        for direction in "+-"
        for number in range(1, 6)
    )
    (made / "c.csv").write_text(
        f"# axis: C\ntarget_deg,direction,run,deviation_arcsec\n{rotary}\n", encoding="utf-8"
    )
    for sense in ("ccw", "cw"):
        head = "# plane: XY\n# nominal_radius_mm: 150\n# feed_mm_min: 1000\n# calibrated: yes\n"
        angles = range(0, 360, 3) if sense == "ccw" else range(357, -1, -3)
        rows = "\n".join(f"{sense},{angle},{(angle * 7 % 11) * 0.1:.3f}" for angle in angles)
        (made / f"xy_{sense}.csv").write_text(
            f"{head}direction,angle_deg,deviation_um\n{rows}\n", encoding="utf-8"
        )
    (made / "empty.csv").write_bytes(b"")
    (made / "note.txt").write_text("shopping list\n", encoding="utf-8")
    (made / "broken.csv").write_text(
        "target_mm,direction,run,deviation_um\n1,+,1,abc\n", encoding="utf-8"
    )
    (made / "picture.png").write_bytes(b"\x89PNG")
    (made / "older").mkdir()
    return made


@pytest.fixture(scope="module")
def outcome(folder: Path) -> EvaluationRun:
    return evaluate_files(Session(), [folder])


def names(outcome: EvaluationRun) -> list[str]:
    return [Path(result["sources"][0]["file"]).name for result in outcome.document["results"]]


def test_one_file_never_costs_the_others(folder: Path, outcome: EvaluationRun) -> None:
    assert names(outcome) == ["c.csv", *SLOPES, "xy_ccw.csv"]
    assert outcome.many
    assert outcome.exit_code == 3
    errors = {Path(error["file"]).name for error in outcome.document["errors"]}
    assert errors == {"empty.csv", "note.txt", "broken.csv"}
    assert outcome.document["skipped"] == [str(folder / "picture.png")]
    assert outcome.document["folders"] == [str(folder / "older")]
    for result in outcome.document["results"][1:13]:  # E: the slope and the 2 µm between directions
        expected = SLOPES[Path(result["sources"][0]["file"]).name] + 2.0
        assert result["parameters"]["E"] == pytest.approx(expected, abs=1e-3)


def test_circles_in_two_files_are_joined_among_many(outcome: EvaluationRun) -> None:
    circle = outcome.document["results"][-1]
    assert [Path(source["file"]).name for source in circle["sources"]] == [
        "xy_ccw.csv",
        "xy_cw.csv",
    ]
    assert circle["kind"] == "circular"


def copied(one: Any) -> Any:
    return pickle.loads(pickle.dumps(one))  # noqa: S301 - our own


@contextmanager
def copying(items: int, ready: Callable[[], None]) -> Iterator[Each]:
    """What other processes do: work and items are copied to them, results back."""

    def there(work: Any, items: Sequence[Any]) -> list[Any]:
        return [copied(copied(work)(copied(item))) for item in items]

    ready()
    yield there


def test_other_processes_give_the_same_bytes(
    folder: Path, outcome: EvaluationRun, monkeypatch: pytest.MonkeyPatch
) -> None:
    called = []

    def crew(items: int, ready: Callable[[], None]) -> Any:
        called.append(items)
        return copying(items, ready)

    monkeypatch.setattr(parallel_work, "_WORTH", 0.0)
    side = evaluate_files(Session(), [folder], crew=crew)
    assert to_json(side.document) == to_json(outcome.document)
    assert called  # it did not work in turn
    short = evaluate_files(Session(), [folder], whole=False)
    assert all("targets" not in result for result in short.document["results"])
    assert len(to_json(short.document)) < 0.5 * len(to_json(outcome.document))


@pytest.fixture(scope="module")
def shown(outcome: EvaluationRun) -> str:
    return at_a_terminal(outcome.document)


def at_a_terminal(document: Mapping[str, Any]) -> str:
    """The list at a terminal of 80 columns."""
    from rich.console import Console

    with pytest.MonkeyPatch.context() as patched:
        patched.setenv("COLUMNS", "80")
        patched.setattr(Console, "is_terminal", property(lambda self: True))  # noqa: ARG005
        patched.setattr(sys, "stdout", stream := io.StringIO())
        print_renderables(many_renderables(document))
    return re.sub(r"\x1b\[[0-9;]*m", "", stream.getvalue())


@pytest.mark.parametrize(
    ("findings", "told"),
    [
        ([("CW-R001", "info")], ""),
        ([("CW-R001", "info"), ("CW-R053", "warning"), ("CW-R006", "warning")], "CW-R053"),
        ([("CW-R006", "warning"), ("CW-T030", "warning")], "CW-T030"),  # the unit is in doubt
        ([("CW-R053", "warning"), ("CW-T030", "warning")], "CW-R053"),  # two doubts
        ([("CW-T030", "warning"), ("CW-T099", "error")], "CW-T099"),
    ],
)
def test_a_line_tells_what_is_to_be_looked_at_first(
    findings: list[tuple[str, str]], told: str, outcome: EvaluationRun
) -> None:
    document = copy.deepcopy(dict(outcome.document))
    first = document["results"][0]
    assert first["sources"][0]["file"].endswith("c.csv")
    first["findings"] = [
        {"code": code, "severity": severity, "message": ""} for code, severity in findings
    ]
    line = next(x for x in at_a_terminal(document).splitlines() if x.startswith("c.csv "))
    assert line.partition("arcsec")[2].strip() == told


def test_a_line_each_and_a_summary_in_80_columns(shown: str) -> None:
    lines = shown.splitlines()
    assert max(map(len, lines)) <= 80
    assert lines[0].startswith("13 positioning tests · ISO 230-2:2014 · ")
    first = lines.index(next(line for line in lines if line.startswith("t00.csv")))
    cells = lines[first].split()
    assert cells[:2] == ["t00.csv", "X"]
    assert cells[3] == "6.00"  # E: 4 µm of slope, 2 µm between the directions
    assert cells[6] == "2.00"  # B
    assert [line.split()[0] for line in lines[first : first + 12]] == list(SLOPES)
    circle = next(line for line in lines if line.startswith("xy_ccw.csv +1 "))
    assert circle.split()[2] == "XY"
    summary = "\n".join(lines[lines.index(next(x for x in lines if x.startswith("Summary"))) :])
    assert "14 tests from 15 files; 3 files with errors, listed below" in summary


def test_the_summary_says_smallest_median_and_largest_by_axis(
    shown: str, outcome: EvaluationRun
) -> None:
    of_x = sorted(
        result["parameters"]["A"]
        for result in outcome.document["results"]
        if result.get("axis") == "X"
    )
    row = next(line for line in shown.splitlines() if line.startswith("axis X")).split()
    assert row[2:4] == ["A", "6"]
    middle = 0.5 * (of_x[2] + of_x[3])
    assert row[4:7] == [f"{value:.2f}" for value in (of_x[0], middle, of_x[-1])]
    assert row[7:] == ["µm", "t10.csv"]
    assert "arcsec" in next(line for line in shown.splitlines() if line.startswith("axis C"))
    assert next(line for line in shown.splitlines() if "CW-R038" in line).split()[2:] == [
        "1",
        "xy_ccw.csv",
    ]


def test_other_standards_have_columns_of_their_own(folder: Path) -> None:
    document = evaluate_files(
        Session(), [folder], ["vdi3441", "iso230-4:1996"], whole=False
    ).document
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(sys, "stdout", stream := io.StringIO())
        print_renderables(many_renderables(document))
    said = stream.getvalue()
    heads = [" ".join(line.split()) for line in said.splitlines() if line.startswith("File ")]
    assert heads[0] == "File Axis P Pa Ps max Ps mean U max Warning"
    assert heads[1] == "File Plane G ccw G cw H Largest cause Warning"
    assert "axis X     P " in said


def test_pages_of_many_tests_are_asked_for(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["evaluate", str(folder), "--targets"]) == 3
    said = capsys.readouterr().out
    assert said.count("5 runs in each direction") == 13
    assert "Summary" not in said


def test_a_file_that_vanishes_meanwhile_is_one_line(tmp_path: Path) -> None:
    for place in range(12):
        text = positioning_text(5.0 + place, "X", place)
        (tmp_path / f"{place:02}.csv").write_text(text, encoding="utf-8")

    def clean_up(what: str, done: int, count: int) -> None:
        (tmp_path / "11.csv").unlink(missing_ok=True)

    outcome = evaluate_files(Session(), [tmp_path], watch=clean_up)
    assert len(outcome.document["results"]) == 11
    assert [Path(error["file"]).name for error in outcome.document["errors"]] == ["11.csv"]
    assert outcome.exit_code == 3


def test_few_tests_have_a_page_each(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["evaluate", str(folder / "t00.csv"), str(folder / "t01.csv")]) == 0
    said = capsys.readouterr().out
    assert "Repeatability" in said
    assert "Summary" not in said


def test_hostile_names_stay_in_their_cells(tmp_path: Path) -> None:
    for place in range(11):
        (tmp_path / f"{'wide' * 40}測試{place}.csv").write_text(
            positioning_text(5.0, "X", place), "utf-8"
        )
    if os.name != "nt":
        (tmp_path / "line\nbreak\x1b[31m.csv").write_text(positioning_text(6.0), "utf-8")
        (tmp_path / os.fsdecode(b"\xff.csv")).write_text(positioning_text(7.0), "utf-8")
        (tmp_path / "circle").symlink_to("circle")
        os.mkfifo(tmp_path / "pipe")
    outcome = evaluate_files(Session(), [tmp_path])
    assert len(outcome.document["results"]) == (13 if os.name != "nt" else 11)
    stream = io.StringIO()
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(sys, "stdout", stream)
        print_renderables(many_renderables(outcome.document))
    lines = stream.getvalue().splitlines()
    assert sum(" X " in line for line in lines) >= len(outcome.document["results"])
    assert "\x1b" not in stream.getvalue()
    assert all("測試" in line for line in lines if line.startswith("wide") and " X " in line)
    write_evaluation(Session(), outcome.document, table_path=tmp_path / "t.csv")
    assert len((tmp_path / "t.csv").read_text("utf-8").splitlines()) == 1 + len(
        outcome.document["results"]
    )


def test_a_fault_of_our_own_is_named_and_the_rest_evaluated(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    evaluate = standards.evaluate

    def failing(test: Any, *words: Any, **more: Any) -> Any:
        if test.name == "t05":
            raise ZeroDivisionError("by nothing")
        return evaluate(test, *words, **more)

    monkeypatch.setattr(file_evaluation, "evaluate", failing)
    code = run(["evaluate", str(folder / "t04.csv"), str(folder / "t05.csv")])
    text = capsys.readouterr()
    assert code == 70
    assert "t04.csv" in text.out
    assert "t05.csv: an internal error of compwright: ZeroDivisionError: by nothing" in text.err
    assert "Please send this line" in text.err


@dataclass
class Rows:
    heads: list[str]
    rows: list[dict[str, Any]]


@pytest.fixture(scope="module")
def tables(outcome: EvaluationRun, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Rows]:
    """The table as other programs read it: the csv module, openpyxl."""
    place = tmp_path_factory.mktemp("tables")
    write_evaluation(Session(), outcome.document, table_path=place / "t.csv")
    write_evaluation(Session(), outcome.document, table_path=place / "t.xlsx")
    with (place / "t.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    found = {"csv": Rows(list(rows[0]), [dict(row) for row in rows])}
    book = openpyxl.load_workbook(place / "t.xlsx")
    for sheet in book:
        heads, *cells = sheet.iter_rows(values_only=True)
        names = [str(head) for head in heads]
        found[sheet.title] = Rows(names, [dict(zip(names, row, strict=True)) for row in cells])
    return found


def test_the_table_has_every_parameter_of_every_test(
    outcome: EvaluationRun, tables: dict[str, Rows]
) -> None:
    results = outcome.document["results"]
    assert [row["name"] for row in tables["csv"].rows] == [result["name"] for result in results]
    for row, result in zip(tables["csv"].rows, results, strict=True):
        unit = "um" if result["kind"] == "circular" else "um|arcsec"
        for name, value in result["parameters"].items():
            assert row[f"{name} [{unit}]"] == ("" if value is None else repr(value))
        assert row["sha256"] == "; ".join(source["sha256"] for source in result["sources"])
        assert row["findings"].split() == list(
            dict.fromkeys(finding["code"] for finding in result["findings"])
        )
    assert tables["csv"].rows[0]["unit"] == "arcsec"
    assert tables["csv"].rows[1]["unit"] == "um"
    assert float(tables["csv"].rows[1]["B at [mm|deg]"]) == results[1]["at"]["B"]
    assert [row["name"] for row in tables["positioning"].rows] == [r["name"] for r in results[:-1]]
    for sheet in ("positioning", "circular"):
        some = [result for result in results if result["kind"] == sheet]
        unit = "um" if sheet == "circular" else "um|arcsec"
        for row, result in zip(tables[sheet].rows, some, strict=True):
            for name, value in result["parameters"].items():
                assert row[f"{name} [{unit}]"] == value  # a number, not its text
    assert {Path(row["file"]).name for row in tables["not evaluated"].rows} == {
        "empty.csv",
        "note.txt",
        "broken.csv",
    }


def number(text: str) -> bool:
    try:
        return bool(float(text)) or True
    except ValueError:
        return False


def test_names_are_no_formulas(folder: Path, tmp_path: Path) -> None:
    """Spreadsheets take text that begins so for a formula (OWASP: CSV injection)."""
    sound = (folder / "t00.csv").read_bytes()
    for name in ("=cmd|' !A0.csv", "@sum(1).csv", "+1.csv", "-1.csv"):
        if os.name == "nt" and "|" in name:
            continue
        (tmp_path / name).write_bytes(sound.replace(b"# axis: X", b'# axis: =HYPERLINK("x")'))
    document = evaluate_files(Session(), [tmp_path]).document
    write_evaluation(Session(), document, table_path=tmp_path / "out" / "t.csv")
    write_evaluation(Session(), document, table_path=tmp_path / "out" / "t.xlsx")
    text = (tmp_path / "out" / "t.csv").read_text("utf-8")
    rows = list(csv.reader(io.StringIO(text)))
    assert {
        cell[:2]
        for row in rows[1:]
        for cell in row
        if cell and cell[0] in "'=+-@" and not number(cell)
    } == {
        "'=",
        "'@",
        "'+",
        "'-",
    } - ({"'="} if os.name == "nt" else set())
    with zipfile.ZipFile(tmp_path / "out" / "t.xlsx") as book:
        sheets = [book.read(name) for name in book.namelist() if "worksheets" in name]
    assert sheets
    assert all(b"<f>" not in sheet and b"<f " not in sheet for sheet in sheets)
    cells = openpyxl.load_workbook(tmp_path / "out" / "t.xlsx")["positioning"]
    assert cells["E2"].value == '=HYPERLINK("x")'
    assert cells["E2"].data_type == "s"


def test_the_same_tests_give_the_same_workbook(
    outcome: EvaluationRun, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_evaluation(Session(), outcome.document, table_path=tmp_path / "one.xlsx")
    monkeypatch.setattr("time.time", lambda: 2e9)
    write_evaluation(Session(), outcome.document, table_path=tmp_path / "other.xlsx")
    assert (tmp_path / "one.xlsx").read_bytes() == (tmp_path / "other.xlsx").read_bytes()


def test_table_and_json_are_written_together_or_not_at_all(
    outcome: EvaluationRun, tmp_path: Path
) -> None:
    (tmp_path / "there.json").write_text("{}", encoding="utf-8")
    with pytest.raises(StorageError, match="exists"):
        write_evaluation(
            Session(),
            outcome.document,
            json_path=tmp_path / "there.json",
            table_path=tmp_path / "t.csv",
        )
    assert [path.name for path in tmp_path.iterdir()] == ["there.json"]
    with pytest.raises(UsageError, match=r"--json: this file name is already used for --table"):
        write_evaluation(
            Session(), outcome.document, json_path=tmp_path / "t.csv", table_path=tmp_path / "t.csv"
        )
    with pytest.raises(UsageError, match=r"--table: .*unknown ending.*\.csv or \.xlsx"):
        write_evaluation(Session(), outcome.document, table_path=tmp_path / "t.ods")


def test_more_tests_than_a_picture_holds_are_refused(
    outcome: EvaluationRun, tmp_path: Path
) -> None:
    many = {**outcome.document, "results": [*outcome.document["results"]] * 3}
    with pytest.raises(UsageError, match=r"--plot: .*at most 40 tests, found 42"):
        write_evaluation(Session(), many, plot_path=tmp_path / "p.svg")


def test_no_input_is_overwritten_whichever_process_evaluated_it(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(parallel_work, "_WORTH", 0.0)
    target = folder / "t07.csv"
    before = target.read_bytes()
    for option in ("--table", "--json"):
        words = ["evaluate", str(folder), option, str(target), "--force"]
        assert run(words, crew=copying) == 5
    assert target.read_bytes() == before
    assert "t07.csv" in capsys.readouterr().err


def test_of_very_many_bad_files_each_has_a_line_and_the_rest_is_counted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for place in range(30):
        (tmp_path / f"{place:02}.csv").write_text(
            "target_mm,direction,run,deviation_um\n1,+,1,abc\n2,+,1,abc\n", encoding="utf-8"
        )
        (tmp_path / f"{place:02}.png").write_bytes(b"")
    assert run(["evaluate", str(tmp_path)]) == 3
    said = capsys.readouterr()
    lines = said.err.splitlines()
    assert sum(line.endswith("(and 1 more in this file)") for line in lines) == 25
    assert lines[25:27] == ["error: ... and 5 more like these", "note: --json PATH names them all"]
    assert sum("skipped" in line for line in lines) == 10
    assert "0 tests from 0 files; 30 files with errors, listed below" in said.out


def test_nothing_of_the_bar_goes_where_no_terminal_is(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(showing, "_PATIENCE", 0.0)
    assert run(["evaluate", str(folder)]) == 3
    said = capsys.readouterr().err.replace(str(folder), "")  # whose number may end with 15
    assert "15/" not in said
    assert all(line.startswith(("error: ", "note: ")) for line in said.splitlines())


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize("more", [(), ("--json", "-")])
def test_a_bar_on_a_terminal_that_is_gone_at_the_end(
    more: tuple[str, ...],
    folder: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(showing, "_PATIENCE", 0.0)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys, "stderr", terminal := Terminal())
    run(["evaluate", str(folder), *more])
    said = terminal.getvalue()
    assert ("18" in said.partition("error:")[0]) == (not more)  # 18 files, and not with --json -
    assert ("\x1b[2K" in said) == (not more)  # the line is taken away
    assert "\\x1b" not in said
    capsys.readouterr()


# ------------------------------------------------------------------------------- in order, side by side


def test_items_are_taken_when_they_are_needed_and_results_come_in_their_order(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(parallel_work, "_WORTH", 0.0)
    monkeypatch.setattr(parallel_work, "_SHORTEST", 0.1)  # ten at once
    taken: list[int] = []

    def items() -> Iterator[int]:
        for item in range(100):
            taken.append(item)
            yield item

    done = parallel_work.in_order(
        abs,
        items(),
        crew=copying,
        ready=lambda: None,
        count=100,
        weight=lambda item: 1,  # noqa: ARG005
    )
    got = [next(done) for _ in range(7)]
    assert got == list(range(7))
    assert len(taken) <= 1 + 4 + 10
    assert list(done) == list(range(7, 100))


def test_heavy_items_are_handed_on_a_few_at_a_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parallel_work, "_WORTH", 0.0)
    monkeypatch.setattr(parallel_work, "_WEIGHT", 30)
    sizes: list[int] = []

    @contextmanager
    def crew(items: int, ready: Callable[[], None]) -> Iterator[Each]:
        def each(work: Any, items: Sequence[Any]) -> list[Any]:
            sizes.append(len(items))
            return [work(item) for item in items]

        yield each

    found = parallel_work.in_order(
        abs,
        range(20),
        crew=crew,
        ready=lambda: None,
        count=20,
        weight=lambda item: 10,  # noqa: ARG005
    )
    assert list(found) == list(range(20))
    assert sizes == [3, 3, 3, 3, 3]


def test_few_quick_items_start_no_process() -> None:
    def crew(items: int, ready: Callable[[], None]) -> Any:
        raise AssertionError((items, ready))

    found = parallel_work.in_order(
        abs,
        range(50),
        crew=crew,
        ready=lambda: None,
        count=50,
        weight=lambda item: 1,  # noqa: ARG005
    )
    assert list(found) == list(range(50))


def test_the_command_knows_no_more_pages_than_ten(folder: Path) -> None:
    files = sorted(folder.glob("t*.csv"))
    assert not evaluate_files(Session(), files[: command._PAGES], whole=False).many
    assert evaluate_files(Session(), files[: command._PAGES + 1], whole=False).many


def _test_with_runs(folder: Path, name: str, runs: int) -> Path:
    """A sound test of 3 targets; of another number of runs than 5 to 10 the range method of GOST
    27843 has no factor.
    """
    rows = "\n".join(
        f"{target},{way},{number},{target / 100 + 0.3 * ((number * 7 + target) % 5):.2f}"
        for target in (10, 200, 390)
        for way in "+-"
        for number in range(1, runs + 1)
    )
    path = folder / name
    path.write_text(f"# axis: X\ntarget_mm,direction,run,deviation_um\n{rows}\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("good", 0),
        ("good unfit", 2),
        ("good broken", 3),
        ("good unfit broken", 3),
        ("broken unfit good", 3),
        ("unfit broken", 3),
    ],
)
def test_what_cannot_be_read_is_graver_than_a_method_that_does_not_fit(
    given: str, expected: int, tmp_path: Path
) -> None:
    """Exit 2: all was read, and one test does not go with the method; 3: a file was not read."""
    (tmp_path / "broken.csv").write_text("target_mm,direction,run,deviation_um\n1,+,1,abc\n")
    _test_with_runs(tmp_path, "good.csv", 5)
    _test_with_runs(tmp_path, "unfit.csv", 4)
    files = [tmp_path / f"{name}.csv" for name in given.split()]
    outcome = evaluate_files(Session(), files, ["gost27843:2006"], "range")
    assert outcome.exit_code == expected
    assert len(outcome.document["results"]) == given.count("good")
    assert len(outcome.document["errors"]) == len(files) - given.count("good")
