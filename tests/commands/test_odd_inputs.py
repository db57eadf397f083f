"""Inputs that nobody expects end with words and the exit code of their cause, and they do end."""

from __future__ import annotations

import base64
import copy
import errno
import hashlib
import json
import os
import random
import shutil
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from compwright.documents.plan import plan_document, read_plan
from compwright.foundations.errors import InputError
from compwright.foundations.utf8 import visible
from loop import Machine, csv_of
from places import PROJECT

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages]

CONTROL = "siemens-840d-sl"
JOB = """\
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: AX1, before: [x.csv]}
"""
CIRCLE = (
    "# plane: XY\n# nominal_radius_mm: 100\n# feed_mm_min: 1000\n# calibrated:"
    " yes\ndirection,angle_deg,deviation_um\n"
    + "".join(
        f"{sense},{angle},{angle % 7}.5\n" for sense in ("ccw", "cw") for angle in range(0, 360, 5)
    )
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    machine = Machine()
    targets = machine.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, machine.measure(targets, 1)))
    (tmp_path / "job.yaml").write_text(JOB)
    monkeypatch.chdir(tmp_path)
    return tmp_path


#: Would clear the screen and turn the direction of writing; a file system of Windows takes the
#: second only.
SPEAKING = "x\u202e" if os.name == "nt" else "x\x1b[2J\u202e"


@pytest.fixture(scope="module")
def named(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """A run of a measurement whose name a terminal would obey, and what was printed."""
    folder = tmp_path_factory.mktemp("plan")
    machine = Machine()
    targets = machine.targets()
    (folder / "runs").mkdir()
    text = csv_of(targets, machine.measure(targets, 1))
    (folder / "runs" / f"{SPEAKING}.csv").write_text(
        f"# machine: VMC \x9b31m <b>\n{text}", encoding="utf-8"
    )
    (folder / "job.yaml").write_text(JOB.replace("x.csv", "runs"))
    with redirect_stdout(StringIO()) as said:
        assert compwright(["run", str(folder / "job.yaml")]) == 0
    return folder / "job", said.getvalue()


@pytest.fixture(scope="module")
def plan(named: tuple[Path, str]) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((named[0] / "plan.json").read_text(encoding="utf-8"))
    return document


# ---------------------------------------------------------------------------------------------------------- folders


@pytest.mark.parametrize("place", ["before: [empty]", "before: [x.csv, empty]"])
def test_an_empty_folder_as_a_test(
    place: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "empty").mkdir()
    (folder / "job.yaml").write_text(JOB.replace("before: [x.csv]", place))
    assert compwright(["run", "job.yaml"]) == 3
    assert "error: empty: the folder contains no files" in capsys.readouterr().err


def test_an_empty_folder_as_a_circle_and_after_loading(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "empty").mkdir()
    assert compwright(["run", "job.yaml"]) == 0
    assert compwright(["verify", "job.yaml", "--after", "x=empty"]) == 3
    (folder / "job.yaml").write_text(f"{JOB}circles: [{{file: empty}}]\n")
    assert compwright(["run", "job.yaml", "--force"]) == 3
    assert capsys.readouterr().err.count("error: empty: the folder contains no files") == 2


def test_a_folder_with_its_own_plot_answer_and_job(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "runs").mkdir()
    shutil.copy("x.csv", "runs")
    assert compwright(["evaluate", "runs", "--plot", "runs/x.svg", "--json", "runs/x.json"]) == 0
    shutil.copy("job.yaml", "runs")
    capsys.readouterr()
    assert compwright(["evaluate", "runs", "--json", "-"]) == 0
    told = capsys.readouterr()
    for name in ("job.yaml", "x.json", "x.svg"):
        assert f"note: {Path('runs', name)}: skipped, by its ending no measurement" in told.err
    assert json.loads(told.out)["skipped"] == [
        str(Path("runs", name)) for name in ("job.yaml", "x.json", "x.svg")
    ]
    assert json.loads(told.out)["errors"] == []
    (folder / "runs" / "y.csv").write_text("broken")
    assert compwright(["evaluate", "runs"]) == 3
    assert compwright(["evaluate", "runs/x.svg"]) == 3  # named by the user: what it is, is said
    shutil.rmtree("runs")
    (folder / "runs").mkdir()
    shutil.copy("job.yaml", "runs")
    capsys.readouterr()
    assert compwright(["evaluate", "runs"]) == 3
    assert "error: runs: the folder contains no measurement files" in capsys.readouterr().err


def test_a_test_in_a_folder_with_its_plot(folder: Path) -> None:
    (folder / "runs").mkdir()
    shutil.copy("x.csv", "runs")
    (folder / "runs" / "x.svg").write_text("<svg/>")
    (folder / "job.yaml").write_text(JOB.replace("[x.csv]", "[runs]"))
    assert compwright(["run", "job.yaml"]) == 0
    found = json.loads((folder / "job" / "plan.json").read_text())["axes"]["X"]["tests"][0][
        "findings"
    ]
    assert "CW-R052" in [finding["code"] for finding in found]


def test_one_test_that_the_method_does_not_fit_does_not_lose_the_others(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The range method has factors for 2 to 10 readings (ISO 230-2:1988, table 1)."""
    rows = "".join(
        f"{target},{sign},{run},{run}.5\n"
        for target in (0, 100)
        for sign in "+-"
        for run in range(1, 12)
    )
    (folder / "long.csv").write_text(f"target_mm,direction,run,deviation_um\n{rows}")
    words = ["--standard", "iso230-2:1988", "--spread", "range"]
    assert compwright(["evaluate", "long.csv", "x.csv", *words, "--json", "all.json"]) == 2
    document = json.loads((folder / "all.json").read_text())
    assert [result["name"] for result in document["results"]] == ["x"]
    assert [error["file"] for error in document["errors"]] == ["long.csv"]
    capsys.readouterr()
    assert compwright(["evaluate", "long.csv", *words]) == 2
    assert "error: long.csv" in capsys.readouterr().err


# ------------------------------------------------------------------------------------------------------------ names


@pytest.mark.skipif(os.name == "nt", reason="file names are UTF-16 there")
def test_names_that_are_no_utf8(folder: Path) -> None:
    (folder / "runs").mkdir()
    shutil.copy("x.csv", "runs/x.csv")
    try:
        shutil.copy("x.csv", b"runs/\xff\xfe.csv".decode("utf-8", "surrogateescape"))
    except OSError:
        pytest.skip("the file system takes no such name")
    assert compwright(["evaluate", "runs", "--json", "all.json", "--plot", "all.svg"]) == 0
    names = [
        result["sources"][0]["file"]
        for result in json.loads((folder / "all.json").read_bytes())["results"]
    ]
    assert names == ["runs/x.csv", "runs/\\udcff\\udcfe.csv"]
    out = "o\udcff"
    assert compwright(["run", "job.yaml", "--out", out]) == 0
    assert compwright(["run", "job.yaml", "--out", out]) == 5
    assert compwright(["run", "job.yaml", "--out", out, "--force"]) == 0


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes in the file system here")
@pytest.mark.parametrize(
    ("code", "words"),
    [
        (3, ["evaluate", "pipe"]),
        (3, ["evaluate", "folder"]),
        (3, ["evaluate", "/dev/zero"]),
        (3, ["decode", "pipe", "--format", CONTROL]),
        (3, ["new", "--from", "folder", "--format", CONTROL, "--out", "new.yaml"]),
        (
            3,
            [
                "run",
                "x.csv",
                "--format",
                CONTROL,
                "--axis",
                "X",
                "--travel",
                "0:800",
                "--state",
                "pipe",
            ],
        ),
        (3, ["run", "pipe.yaml"]),
        (5, ["run", "job.yaml", "--out", "pipe"]),
        (5, ["evaluate", "x.csv", "--json", "pipe", "--force"]),
        (5, ["evaluate", "x.csv", "--json", "/dev/null", "--force"]),
        (5, ["evaluate", "x.csv", "--json", "link", "--force"]),
        (3, ["compare", "pipe", "--loaded", "x.csv"]),
        (3, ["simulate", "pipe", "--out", "new"]),
        (3, ["formats", "check", "pipe"]),
    ],
)
def test_pipes_and_devices_are_refused_at_once(
    code: int, words: list[str], folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "folder").mkdir()
    for name in ("pipe", "pipe.yaml", "folder/x.csv"):
        os.mkfifo(name)
    (folder / "link").symlink_to("/dev/null")
    assert compwright(words) == code
    said = capsys.readouterr().err
    assert any(
        part in said
        for part in ("cannot be read; expected a", "is not an ordinary file", "is not a folder")
    )


def test_a_name_that_a_terminal_would_obey_is_shown_in_every_file(
    named: tuple[Path, str],
) -> None:
    folder, said = named
    places = [path for path in sorted(folder.rglob("*")) if path.is_file()]
    texts = {
        path.name: path.read_text(encoding="utf-8") for path in places if "inputs" not in path.parts
    }
    for name, text in {**texts, "terminal": said}.items():
        obeyed = {c for c in text if not c.isprintable() and c not in "\n\u00a0\u202f"}
        assert not obeyed, (name, obeyed)
    assert visible(SPEAKING) in texts["report.html"]
    assert visible(SPEAKING) in said
    plan = json.loads(texts["plan.json"])["axes"]["X"]["tests"][0]
    assert SPEAKING in plan["sources"][0]["file"]
    assert plan["header"]["machine"] == "VMC \x9b31m <b>"


# ---------------------------------------------------------------------------------------------------- numbers, keys


@pytest.mark.parametrize("key", ["nominal_radius_mm: 100", "feed_mm_min: 1000"])
@pytest.mark.parametrize("value", ["1e-320", "0", "-1", "1e400"])
def test_a_radius_or_feed_that_is_none(key: str, value: str, folder: Path) -> None:
    name = key.partition(":")[0]
    (folder / "xy.csv").write_text(CIRCLE)
    assert compwright(["evaluate", "xy.csv"]) == 0
    (folder / "xy.csv").write_text(CIRCLE.replace(key, f"{name}: {value}"))
    assert compwright(["evaluate", "xy.csv"]) == 3


@pytest.mark.parametrize(
    ("definition", "block", "place"),
    [
        ("heidenhain-nck", "  assignments_begin:", "statements.assignments_begin"),
        ("heidenhain-nck", "  values_begin:", "statements.values_begin"),
    ],
)
def test_a_definition_that_lacks_an_entry(
    definition: str, block: str, place: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = (
        (PROJECT / "controller_formats" / f"{definition}.yaml")
        .read_text(encoding="utf-8")
        .splitlines()
    )
    start = next(index for index, line in enumerate(lines) if line.startswith(block))
    end = next(
        index
        for index in range(start + 1, len(lines))
        if lines[index].strip() and not lines[index].startswith("   ")
    )
    (folder / "mine.yaml").write_text(
        "\n".join(lines[:start] + lines[end:]) + "\n", encoding="utf-8"
    )
    assert compwright(["formats", "check", "mine.yaml"]) == 3
    assert f"{place}: the definition lacks the entry " in capsys.readouterr().err


def test_a_definition_that_takes_an_entry_out(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "mine.yaml").write_text(
        "extends: fanuc-30i.yaml\nid: mine\nwithout: [options.increment_limit]\n"
    )
    assert compwright(["formats", "check", "mine.yaml"]) == 3
    assert (
        "options.increment_limit: the definition lacks the entry increment_limit in its section"
        in capsys.readouterr().err
    )


@pytest.mark.parametrize("digits", [30, 400, 5000])
@pytest.mark.parametrize(
    "line", ["i286 = {}", "i286 = ${}", "i285 = {}", "#{}", "I1..{} = 1", "#1 DEF COMP 1,4000\n{}"]
)
def test_numbers_of_absurd_length_in_a_control_file(
    line: str, digits: int, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "a.pmc").write_text(f"I51=0\ni285=32\n{line.format('9' * digits)}\n")
    options = ["--format", "pmac", "--option", "counts_per_unit=2000"]
    assert compwright(["decode", "a.pmc", *options]) == 3
    assert "error: a.pmc: line " in capsys.readouterr().err


@pytest.mark.parametrize("value", ["1e-320", "1e300", "-1", "0", "nan", "9" * 5000])
def test_a_detection_unit_that_is_none(
    value: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "P.TXT").write_text("%\nN01851Q1A1P4\n%\n")
    words = ["decode", "P.TXT", "--format", "fanuc-30i", "--option", f"detection_unit={value}"]
    assert compwright(words) == 2
    assert "detection_unit" in capsys.readouterr().err


def test_help_that_nobody_reads(monkeypatch: pytest.MonkeyPatch) -> None:
    class Closed(StringIO):
        def write(self, _text: str) -> int:
            raise BrokenPipeError(errno.EPIPE, "Broken pipe")

    for words in (["--help"], ["run", "--help"], ["--version"], ["formats", "list"]):
        monkeypatch.setattr(sys, "stdout", Closed())
        assert compwright(words) == 0


# ------------------------------------------------------------------------------------------------------------ plans


def paths(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    if path:
        yield path
    if isinstance(value, dict):
        for key in value:
            yield from paths(value[key], (*path, key))
    elif isinstance(value, list):
        for index in range(min(len(value), 2)):
            yield from paths(value[index], (*path, index))


GONE = object()


def edited(plan: dict[str, Any], path: tuple[str | int, ...], value: object) -> bytes:
    changed: Any = copy.deepcopy(plan)
    section = changed
    for key in path[:-1]:
        section = section[key]
    if value is GONE:
        del section[path[-1]]
    else:
        section[path[-1]] = value
    return json.dumps(changed).encode()


def key_path(path: tuple[str | int, ...]) -> str:
    """As a fault writes it: ``axes.X.tests[0]``."""
    return "".join(f"[{key}]" if isinstance(key, int) else f".{key}" for key in path).lstrip(".")


VALUES = [GONE, None, "x", -1, 1e308, 1e-320, True, [], {}, [None], [[1]], "\ud800"]


def test_an_edited_plan_is_read_or_refused(plan: dict[str, Any]) -> None:
    """What is read keeps its word: written again it is the same."""
    everywhere = [(path, value) for path in paths(plan) for value in VALUES]
    read = 0
    for path, value in random.Random(1).sample(everywhere, 60):  # noqa: S311 - not for secrets
        try:
            again = plan_document(read_plan(edited(plan, path, value), "plan.json"))
        except InputError as error:
            said = [fault.place for fault in error.faults]
            here = key_path(path)
            assert any(place.startswith(here) or here.startswith(place) for place in said), here
        else:
            assert plan_document(read_plan(json.dumps(again).encode(), "plan.json")) == again
            read += 1
    assert 0 < read < 60
    as_it_is = plan_document(read_plan(json.dumps(plan).encode(), "plan.json"))
    assert json.loads(json.dumps(as_it_is)) == plan


def test_everything_that_is_wrong_in_a_plan_is_told_at_once(plan: dict[str, Any]) -> None:
    axis = copy.deepcopy(plan["axes"]["X"])
    axis["axis"]["travel"] = [800.0, 0.0]
    del axis["wanted"]["noise"]
    axis["fitted"]["mode"] = "both"
    axis["estimate"]["periods"] = []  # their place is beside the estimate
    broken = {**plan, "axes": {"X": axis}, "states": {"as_found": [{"name": "a", "base64": "?"}]}}
    with pytest.raises(InputError) as refused:
        read_plan(json.dumps(broken).encode(), "plan.json")
    assert sorted(fault.place for fault in refused.value.faults) == [
        "axes.X.axis",
        "axes.X.estimate.periods",
        "axes.X.fitted.mode",
        "axes.X.wanted.noise",
        "states.as_found[0].base64",
    ]
    assert all(fault.file == "plan.json" for fault in refused.value.faults)
    assert all(fault.expected for fault in refused.value.faults)


def test_a_copy_in_a_plan_is_the_one_that_was_written(plan: dict[str, Any]) -> None:
    def with_copy(content: bytes) -> bytes:
        copies = [{"name": "A.TXT", "base64": base64.b64encode(content).decode()}]
        return json.dumps({**plan, "results": listed, "states": {"as_found": copies}}).encode()

    listed = {f"rollback/{CONTROL}/A.TXT": hashlib.sha256(b"as it was").hexdigest()}
    assert read_plan(with_copy(b"as it was"), "plan.json").states["as_found"]
    with pytest.raises(
        InputError, match=r"as_found\[0\]\.base64: contradicts the rest of the plan"
    ):
        read_plan(with_copy(b"changed"), "plan.json")


def test_a_key_that_stands_twice_in_a_plan(plan: dict[str, Any]) -> None:
    content = json.dumps(plan).replace('"standard":', '"standard": "vdi3441", "standard":', 1)
    with pytest.raises(InputError, match="the key 'standard' twice in one object"):
        read_plan(content.encode(), "plan.json")


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (
            ("axes", "X", "axis", "travel", 1),
            -1,
            "axes.X.axis: contradicts itself; expected a travel from a lower to a higher",
        ),
        (
            ("axes", "X", "axis", "gantry"),
            -1,
            "axes.X.axis.gantry is not text; expected text, in quotes where it looks like a number, found -1",
        ),
        (
            ("axes", "X", "fitted", "compensation", "below"),
            [[1]],
            "fitted.compensation.below is not an accepted value",
        ),
        (
            ("axes", "X", "wanted", "positive", 0),
            1e308,
            "axes.X.wanted.positive is not a list of numbers",
        ),
        (
            ("axes", "X", "wanted", "positive"),
            [],
            "axes.X.wanted: contradicts itself; expected ascending positions",
        ),
        (
            ("axes", "X", "wanted", "positions", 1),
            0.0,  # as the first one
            "axes.X.wanted: contradicts itself; expected ascending positions",
        ),
        (
            ("axes", "X", "wanted", "kind"),
            "rotary",
            "axes.X: contradicts itself; expected one kind of axis throughout",
        ),
        (
            ("axes", "X", "axis", "encoder", "system"),
            None,
            "axes.X.axis.encoder.system is not a number",
        ),
        (("axes", "X", "tests"), "x", "axes.X.tests is not a list"),
        (
            ("axes", "X", "active", "backlash"),
            GONE,
            "axes.X.active.backlash is missing; expected a number",
        ),
        (
            ("axes", "X", "tests", 0, "positive", 3),
            ["x"],
            "axes.X.tests[0].positive[3] is not a row of readings; expected 5 readings",
        ),
        (
            ("axes", "X", "axis", "backslash"),
            1,
            "axes.X.axis.backslash: unknown key",
        ),
        (
            ("axes", "X", "axis", "name"),
            "Y",
            "axes.X.axis.name: contradicts the rest of the plan; expected X, found 'Y'",
        ),
        (
            ("axes", "X", "unit"),
            "deg",
            "axes.X.unit is not the unit of this axis; expected mm, found 'deg'",
        ),
        (
            ("states",),
            {"../x": [], "C:x": [], "a\x1b[2J": []},
            "states.C:x: contradicts the rest of the plan; expected a plain name",
        ),
        (("axes", "X", "axis", "suggested_period"), 0, "axes.X.axis: contradicts itself"),
        (("axes", "X", "wanted", "periods"), [10.0, 0.0], "axes.X.wanted: contradicts itself"),
        (("active",), {"now": True}, "active.now: contradicts the rest of the plan"),
        (
            ("axes", "X", "wanted", "scenarios"),
            {
                "count": -1,
                "positions": [0.0, 1.0],
                "positive": [0.0, 0.0],
                "negative": [0.0],
                "half_positive": [0.0, float("nan")],
                "half_negative": [0.0],
            },
            "plan.json: the file is not JSON; expected plan.json of a run, found NaN in the place of a number",
        ),
    ],
)
def test_an_edited_plan_is_refused_by_its_key(
    path: tuple[str | int, ...],
    value: object,
    words: str,
    plan: dict[str, Any],
    folder: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (folder / "plan.json").write_bytes(edited(plan, path, value))
    for command in (
        ["export", "plan.json", "--format", CONTROL, "--out", "new"],
        ["compare", "plan.json", "--loaded", "x.csv"],
    ):
        assert compwright(command) == 3
        assert words in capsys.readouterr().err
    assert not (folder / "new").exists()
