"""Bad input at the command line: the exit code of the contract, a line with file, place, expected
and found, nothing written.
"""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from compwright.fitting.solve import load_solver
from loop import Machine, csv_of
from places import PROJECT

pytestmark = pytest.mark.short_estimate

JOB = """\
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: AX1, before: [x.csv]}
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a good test and a good job, the working directory of the case."""
    machine = Machine()
    targets = machine.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, machine.measure(targets, 1)))
    (tmp_path / "job.yaml").write_text(JOB)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def tree(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


class Outcome:
    """What a command said. ``lines``: its errors without the word error."""

    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err
        self.lines = [
            line.removeprefix("error: ") for line in err.splitlines() if line.startswith("error: ")
        ]

    def says(self, *parts: str) -> bool:
        return any(all(part in line for part in parts) for line in self.lines)


@pytest.fixture
def command(folder: Path, capsys: pytest.CaptureFixture[str]) -> Callable[..., Outcome]:
    """Run a command that must fail: nothing may be written, and no traceback shown."""

    def run(*words: str) -> Outcome:
        before = tree(folder)
        code = compwright(list(words))
        captured = capsys.readouterr()
        assert tree(folder) == before, "a failed command must leave the folder as it was"
        assert "Traceback" not in captured.err + captured.out
        return Outcome(code, captured.out, captured.err)

    return run


def damaged(folder: Path, change: Callable[[list[str]], list[str]]) -> str:
    lines = (folder / "x.csv").read_text().splitlines()
    (folder / "bad.csv").write_text("\n".join(change(lines)) + "\n")
    return "bad.csv"


def row(number: int, value: str) -> Callable[[list[str]], list[str]]:
    """Replace the value in line ``number`` (from 1)."""

    def change(lines: list[str]) -> list[str]:
        lines[number - 1] = lines[number - 1].rpartition(",")[0] + f",{value}"
        return lines

    return change


def moved_target(lines: list[str]) -> list[str]:
    target = lines[3].split(",")[0]
    return [
        (
            f"{float(target) + 0.01:.4f}{line[len(target) :]}"
            if line.startswith(f"{target},-")
            else line
        )
        for line in lines
    ]


#: What is wrong -> (change, what the line must name beside the file).
MEASUREMENTS: dict[str, tuple[Callable[[list[str]], list[str]], tuple[str, ...]]] = {
    "a missing column": (
        lambda lines: [line.replace("direction,", "") for line in lines],
        ("line 3", "direction"),
    ),
    "mixed decimal marks": (row(20, '"1,25"'), ("line 20", "deviation_um", "comma")),
    "an unknown unit": (
        lambda lines: [line.replace("deviation_um", "deviation_mil") for line in lines],
        ("deviation_um", "deviation_mil"),
    ),
    "differing targets": (
        moved_target,
        ("targets of the two directions differ", "expected", "found"),
    ),
    "not a number": (row(33, "nan"), ("line 33", "deviation_um", "found 'nan'")),
    "infinite": (row(33, "-inf"), ("line 33", "deviation_um", "found '-inf'")),
    "text in row 57": (
        row(57, "abc"),
        ("line 57", "deviation_um", "expected a number", "found 'abc'"),
    ),
    "header only": (lambda lines: lines[:3], ("no reading",)),
}


@pytest.mark.parametrize("name", MEASUREMENTS)
def test_a_measurement_that_cannot_be_read(
    name: str, folder: Path, command: Callable[..., Outcome]
) -> None:
    change, parts = MEASUREMENTS[name]
    file = damaged(folder, change)
    for words in (
        ["evaluate", file],
        [
            "run",
            file,
            "--format",
            "linuxcnc",
            "--axis",
            "X",
            "--travel",
            "0:800",
            "--state",
            "none",
        ],
    ):
        outcome = command(*words)
        assert outcome.code == 3
        assert outcome.says("bad.csv", *parts), outcome.err


def test_an_empty_a_binary_and_a_missing_file(
    folder: Path, command: Callable[..., Outcome]
) -> None:
    (folder / "empty.csv").write_bytes(b"")
    (folder / "binary.csv").write_bytes(bytes(range(256)) * 8)
    outcome = command("evaluate", "empty.csv", "binary.csv", "missing.csv")
    assert outcome.code == 3
    assert outcome.says("empty.csv", "is empty")
    assert outcome.says("binary.csv", "binary")
    assert outcome.says("missing.csv", "does not exist")


def test_the_rest_of_several_files_is_evaluated(
    folder: Path, command: Callable[..., Outcome]
) -> None:
    damaged(folder, row(57, "abc"))
    outcome = command("evaluate", "bad.csv", "x.csv", "--json", "-")
    assert outcome.code == 3
    answer = json.loads(outcome.out)
    assert [result["name"] for result in answer["results"]] == ["x"]
    assert [(error["file"], "line 57" in error["message"]) for error in answer["errors"]] == [
        ("bad.csv", True)
    ]


#: What is wrong with the job -> (old text, new text, exit code, parts of lines, each of which must
#: be there).
JOBS: dict[str, tuple[str, str, int, list[tuple[str, ...]]]] = {
    "three faults": (
        "  X: {travel: [0, 800], address: AX1, before: [x.csv]}",
        "  X: {travel: [800, 0], adress: AX1, before: []}",
        2,
        [("axes.X.travel", "line 5"), ("axes.X.adress", "unknown key"), ("axes.X.before",)],
    ),
    "a duplicate key": ("states:", "compwright: 1\nstates:", 2, [("line 3", "given twice")]),
    "an unknown key": ("states:", "statez: 1\nstates:", 2, [("line 3", "statez", "unknown key")]),
    "a newer schema": ("compwright: 1", "compwright: 2", 2, [("newer version", "found 2")]),
    "not YAML": ("controller: {", "controller: {{", 2, [("line",)]),
    "a format that does not exist": ("siemens-840d-sl", "heidenhein", 2, [("heidenhein",)]),
    "an option that does not exist": (
        "840d-sl}",
        "840d-sl, options: {pionts: 3}}",
        2,
        [("pionts",)],
    ),
    "a step that cannot be held exactly": (
        "before: [x.csv]",
        "before: [x.csv], table: {spacing: 33.33333333}",
        4,
        [("job.yaml", "axis X", "spacing", "expected", "found 33.33333333 mm")],
    ),
    "a step that does not divide the travel": (
        "before: [x.csv]",
        "before: [x.csv], table: {spacing: 27}",
        4,
        [("job.yaml", "axis X", "expected", "found 27 mm")],
    ),
    "more points than MD38000": (
        "840d-sl}\nstates: {as_found: none}\naxes:\n  X: {travel: [0, 800], address: AX1, ",
        (
            "840d-sl, options: {points: 21}}\nstates: {as_found: none}\naxes:\n"
            "  X: {travel: [0, 800], address: AX1, table: {spacing: 20}, "
        ),
        4,
        [
            ("too many points", "at most 21", "found 41", "larger `table: {spacing: ...}`"),
            ("set MD38000 ($MA_MM_ENC_COMP_MAX_POINTS) to 41 or more", "`points: 41`"),
        ],
    ),
    "a tolerance on what the test does not have": (
        "before: [x.csv]",
        "before: [x.csv], accept: {P: 3}",
        2,
        [("accept.P",)],
    ),
    "a rotary axis with a linear test": (
        "travel:",
        "kind: rotary, travel:",
        3,
        [("x.csv", "linear", "rotary")],
    ),
    "a test of another axis": (
        "  X:",
        "  Y:",
        3,
        [("x.csv", "a test of axis X, not of Y")],
    ),
    "a state that says nothing of the axis": ("none", "[other.INI]", 3, [("AX1", "AX7")]),
}


@pytest.mark.parametrize("name", JOBS)
def test_a_job_that_cannot_be_done(
    name: str, folder: Path, command: Callable[..., Outcome]
) -> None:
    (folder / "other.INI").write_text("CHANDATA(1)\n$MA_BACKLASH[0,AX7]=0.004\nM17\n")
    old, new, code, lines = JOBS[name]
    assert old in JOB
    (folder / "job.yaml").write_text(JOB.replace(old, new, 1))
    outcome = command("run", "job.yaml")
    assert outcome.code == code
    for parts in lines:
        assert outcome.says(*parts), outcome.err


def test_linuxcnc_holds_256_rows(folder: Path, command: Callable[..., Outcome]) -> None:
    text = (
        JOB.replace("siemens-840d-sl", "linuxcnc")
        .replace("AX1", "0")
        .replace("before: [x.csv]", "before: [x.csv], table: {spacing: 2}")
    )
    (folder / "job.yaml").write_text(text)
    outcome = command("run", "job.yaml")
    assert outcome.code == 4
    assert outcome.says("job.yaml", "too many points", "at most 256", "found 401")


def test_a_file_that_would_be_overwritten(folder: Path, command: Callable[..., Outcome]) -> None:
    (folder / "job").mkdir()
    (folder / "job" / "plan.json").write_text("mine")
    (folder / "x.json").write_text("mine")
    outcome = command("run", "job.yaml")
    assert (outcome.code, outcome.says("plan.json", "exists already", "--force")) == (5, True)
    outcome = command("evaluate", "x.csv", "--json", "x.json")
    assert (outcome.code, outcome.says("x.json", "exists already")) == (5, True)
    outcome = command("run", "job.yaml", "--force")
    assert (outcome.code, outcome.says("plan.json", "not written by an earlier run")) == (5, True)
    (folder / "job" / "plan.json").unlink()
    assert compwright(["run", "job.yaml"]) == 0
    (folder / "job" / "evaluation.json").unlink()
    assert compwright(["run", "job.yaml", "--force"]) == 0
    assert (folder / "job" / "evaluation.json").is_file()


def test_no_permission(
    folder: Path, command: Callable[..., Outcome], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the system says it to anyone but root: the folder may not be written to."""

    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    monkeypatch.setattr("pathlib.Path.mkdir", refuse)
    outcome = command("run", "job.yaml")
    assert (outcome.code, outcome.says("job", "Permission denied")) == (5, True)


@pytest.mark.parametrize("after", [0, 3, 7])
def test_a_full_disk_leaves_nothing(
    after: int, folder: Path, command: Callable[..., Outcome], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The disk is full when the n-th file is to be made durable."""
    real, made = os.fsync, []

    def full(handle: int) -> None:
        made.append(handle)
        if len(made) > after:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        real(handle)

    monkeypatch.setattr("os.fsync", full)
    outcome = command("run", "job.yaml")
    assert (outcome.code, outcome.says("No space left on device")) == (5, True)
    assert not (folder / "job").exists()


@pytest.fixture
def finished(folder: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    """A folder in which the job has run."""
    assert compwright(["run", "job.yaml"]) == 0
    capsys.readouterr()
    return folder


def test_a_control_file_that_is_cut_short(finished: Path, command: Callable[..., Outcome]) -> None:
    whole = (
        (finished / "job" / "tables" / "siemens-840d-sl" / "AX1_EEC.INI")
        .read_text()
        .splitlines(keepends=True)
    )
    for kept in (5, len(whole) - 5, len(whole) - 4, len(whole) - 3):
        (finished / "CUT.INI").write_text("".join(whole[:kept]))
        outcome = command("decode", "CUT.INI", "--format", "siemens-840d-sl")
        assert (outcome.code, outcome.says("CUT.INI")) == (3, True)
        (finished / "cut.yaml").write_text(JOB.replace("none", "[CUT.INI]"))
        assert command("run", "cut.yaml").code == 3
    (finished / "CUT.INI").write_text(
        "".join(whole[:-1])
    )  # all values, but not the end of the program
    assert (
        "CUT.INI"
        in command("decode", "CUT.INI", "--format", "siemens-840d-sl").out.partition("warning")[2]
    )
    (finished / "CUT.INI").write_text(
        "".join(whole)[: len("".join(whole[:8])) - 3]
    )  # in the middle of a number
    assert command("decode", "CUT.INI", "--format", "siemens-840d-sl").code == 3


def test_a_plan_that_is_cut_short_or_of_another_schema(
    finished: Path, command: Callable[..., Outcome]
) -> None:
    whole = (finished / "job" / "plan.json").read_text()
    (finished / "cut.json").write_text(whole[: len(whole) // 2])
    (finished / "newer.json").write_text(whole.replace("compwright/plan/1", "compwright/plan/2", 1))
    keyless = json.loads(whole)
    del keyless["axes"]["X"]["wanted"]
    (finished / "keyless.json").write_text(json.dumps(keyless))
    for file, part in (
        ("cut.json", "JSON"),
        ("newer.json", "compwright/plan/1"),
        ("keyless.json", "wanted"),
        ("none.json", "none.json"),
    ):
        for words in (
            ["export", file, "--format", "linuxcnc", "--state", "none", "--out", "e"],
            ["verify", "job.yaml", "--after", "x.csv", "--plan", file],
        ):
            outcome = command(*words)
            assert (outcome.code, outcome.says(file, part)) == (3, True), outcome.err


def test_verify_with_the_wrong_test(finished: Path, command: Callable[..., Outcome]) -> None:
    (finished / "y.csv").write_text(
        (finished / "x.csv").read_text().replace("# axis: X", "# axis: Y")
    )
    outcome = command("verify", "job.yaml", "--after", "y.csv")
    assert (outcome.code, outcome.says("y.csv", "axis Y")) == (2, True)
    outcome = command("verify", "job.yaml", "--after", "nothing.csv")
    assert (outcome.code, outcome.says("nothing.csv")) == (3, True)


def test_without_the_state_of_the_control_there_are_no_tables(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "job.yaml").write_text(JOB.replace("states: {as_found: none}\n", ""))
    assert compwright(["run", "job.yaml"]) == 2
    assert (
        "job.yaml: no table is written: the job does not say what is active in the control"
        in capsys.readouterr().err
    )
    assert sorted(path.name for path in (folder / "job").iterdir()) == [
        "evaluation.json",
        "inputs",
        "prediction.json",
        "record.json",
        "report.html",
    ]
    assert (
        json.loads((folder / "job" / "prediction.json").read_text())["axes"]["X"]["table"] is None
    )


@pytest.mark.real_pages
def test_without_the_report_extra_the_rest_is_written(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    load_solver()  # which wants one of them, too
    for module in [
        name for name in sys.modules if name.partition(".")[0] in {"matplotlib", "jinja2"}
    ]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "jinja2", None)
    assert compwright(["run", "job.yaml"]) == 0
    assert "report.html is not written" in capsys.readouterr().err
    names = {path.name for path in (folder / "job").rglob("*") if path.is_file()}
    assert {
        "plan.json",
        "prediction.json",
        "evaluation.json",
        "card.md",
        "AX1_EEC.INI",
        "AX1_MD.INI",
        "record.json",
        "job.yaml",  # the copies of job and measurement
        "x.csv",
    } == names


WORDS = {
    "evaluate": (["evaluate", "x.csv", "--standard", "iso999"], ["iso999"]),
    "spread": (["evaluate", "x.csv", "--spread", "range"], ["range"]),
    "plot": (["evaluate", "x.csv", "--plot", "x.bmp"], ["bmp", ".svg"]),
    "travel": (
        [
            "run",
            "x.csv",
            "--format",
            "linuxcnc",
            "--axis",
            "X",
            "--travel",
            "800:0",
            "--state",
            "none",
        ],
        ["--travel", "800:0"],
    ),
    "missing words": (["run", "x.csv"], ["--format", "is missing"]),
    "job and words": (["run", "job.yaml", "--axis", "X"], ["--axis", "job file"]),
    "two states": (
        [
            "run",
            "x.csv",
            "--format",
            "linuxcnc",
            "--axis",
            "X",
            "--travel",
            "0:800",
            "--state",
            "none",
            "--state",
            "a",
        ],
        ["none"],
    ),
    "option": (
        ["decode", "x.csv", "--format", "linuxcnc", "--option", "units"],
        ["--option", "KEY=VALUE", "found 'units'"],
    ),
    "format": (["formats", "show", "fanux"], ["fanux", "nearest", "fanuc-30i", "linuxcnc"]),
    "maker": (["formats", "show", "fanuc"], ["several", "fanuc-30i", "fanuc-0i-f"]),
    "command": (["frobnicate"], ["frobnicate"]),
}


@pytest.mark.parametrize("name", WORDS)
def test_wrong_words(name: str, command: Callable[..., Outcome]) -> None:
    words, parts = WORDS[name]
    outcome = command(*words)
    assert outcome.code == 2
    assert outcome.says(*parts), outcome.err


def process(folder: Path, *words: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    settings = {**os.environ, "PYTHONPATH": str(PROJECT / "src"), **environment}
    return subprocess.run(
        [sys.executable, "-m", "compwright", *words],
        cwd=folder,
        env=settings,
        capture_output=True,
        check=False,
    )


def test_a_terminal_that_knows_no_greek(folder: Path) -> None:
    ran = process(folder, "evaluate", "x.csv", LC_ALL="C", PYTHONIOENCODING="ascii", PYTHONUTF8="0")
    assert (ran.returncode, ran.stderr) == (0, b"")
    answer = process(
        folder,
        "evaluate",
        "x.csv",
        "--json",
        "-",
        LC_ALL="C",
        PYTHONIOENCODING="ascii",
        PYTHONUTF8="0",
    )
    assert json.loads(answer.stdout)["schema"] == "compwright/evaluation/1"


def test_a_reader_that_hangs_up(folder: Path) -> None:
    ran = subprocess.run(
        [
            "bash",
            "-o",
            "pipefail",
            "-c",
            f"{sys.executable} -m compwright evaluate x.csv --targets | head -1",
        ],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(PROJECT / "src")},
        capture_output=True,
        check=False,
    )
    assert b"Traceback" not in ran.stderr
    assert ran.stdout.startswith(b"x.csv")


@pytest.mark.parametrize(
    "content",
    [
        b"@@MMCIBN.002\n\xfc\x00",
        b"%\nN10000Q0P1\nN10001Q0P-1\n",
        b"%(CNCID=01234567)\nN00001Q1A1P0A2P-1\n",
        b"$AA_ENC_COMP[0,0,AX1]=0\n",
    ],
)
def test_a_file_of_the_control_is_no_measurement(
    content: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "backup").write_bytes(content)
    assert compwright(["evaluate", str(tmp_path / "backup")]) == 3
    assert "a file of a control (compwright decode)" in capsys.readouterr().err


def test_one_fault_of_every_axis_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Four axes lack their detection unit: the answer is one option."""
    backup = PROJECT / "examples" / "fanuc-backup" / "control"
    assert compwright(["decode", str(backup), "--format", "fanuc-30i"]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.endswith("without a job give `--option detection_unit=VALUE`")
