"""Definitions of one's own: every command takes them, results say that nobody judged them, plans
carry them, and what does not pass the gate is refused before anything is written.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_formats_page import blocks, change
from test_run_circles import CEC, Bent, write_circle

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import KNOWN
from compwright.controls import definitions
from compwright.controls.control import open_control
from compwright.controls.decoded_state import SingleReader
from compwright.documents.plan import read_plan
from compwright.formats.definition.inheritance import found_in, merged, texts_of
from compwright.foundations.session import Session
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlState, CrossCompensation
from compwright.words.sentences import say
from compwright.workflow.commands.formats import list_formats, show_format
from format_samples import CONTENT, CONTROLS, DEFINITIONS
from loop import Machine, csv_of
from next_steps import without_hint
from places import PROJECT

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()
FANUC = ', address: "1"'
UNIT = "{detection_unit: 0.001, first_point: 0}"
MACHINE_FILE = """\
virtual_machine: 1
machine: {name: m}
controller: {format: nc7.yaml}
axes:
  X: {travel: [0, 100], error: {noise_um: 0.1}, test: {targets: 5, runs: 2}}
"""
JUDGED = "not independently checked"


def tutorial(path: Path, *, expect: str = "") -> Path:
    """The definition of docs/formats.md; ``expect``: put in the place of its last section."""
    text = ""
    for block in blocks((PROJECT / "docs" / "formats.md").read_text(encoding="utf-8")):
        if block.name == "nc7.yaml" and block.kind == "yaml":
            text += block.body
    text = text.replace("    sign: error\n", "    sign: correction\n")
    head, _, own = text.partition("\nexpect:\n")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"{head}\n{expect or f'expect:{chr(10)}{own}'}", encoding="utf-8")
    return path


def copied(path: Path, name: str, new_id: str) -> Path:
    """A definition that ships, under another id."""
    path.write_text(f"extends: {name}\nid: {new_id}\n")
    return path


def job(folder: Path, form: str = "nc7.yaml", axis: str = "", options: str = "{}") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    targets = MACHINE.targets()
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {form}, options: {options}}}\n"
        f"states: {{as_found: none}}\naxes:\n  X: {{travel: [0, 800], before: [x.csv]{axis}}}\n",
        encoding="utf-8",
    )
    return folder / "job.yaml"


def ran(path: Path) -> Any:
    assert compwright(["run", str(path)]) == 0
    return json.loads((path.with_suffix("") / "prediction.json").read_text(encoding="utf-8"))


def assert_same(one: Any, other: Any, within: float) -> None:
    """``within``: µm, far below every quantum."""
    assert type(one) is type(other)
    if isinstance(one, dict):
        assert list(one) == list(other)
        one, other = list(one.values()), list(other.values())
    if isinstance(one, list):
        assert len(one) == len(other)
        for mine, theirs in zip(one, other, strict=True):
            assert_same(mine, theirs, within)
    elif isinstance(one, float):
        assert round(abs(one - other), 9) <= within
    else:
        assert one == other


def told(capsys: pytest.CaptureFixture[str]) -> list[str]:
    return capsys.readouterr().err.splitlines()


# --- a run


@pytest.mark.real_pages
def test_a_definition_of_ones_own_runs_and_everything_says_that_nobody_judged_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tutorial(tmp_path / "nc7.yaml")
    found = ran(job(tmp_path))
    assert found["format"] == "nc7"
    assert found["axes"]["X"]["judged"] == "read_back"
    assert [doubt["code"] for doubt in found["doubts"]] == ["CW-S060"]
    card = (tmp_path / "job/card/card.md").read_text(encoding="utf-8")
    assert JUDGED in card[: card.index("## Steps")]
    for page in ("job/card/card.html", "job/report.html"):
        text = (tmp_path / page).read_text(encoding="utf-8")
        first = text.index(">Check first")
        assert 0 < first < text.index(JUDGED) < text.index("<table")
    assert JUDGED in " ".join(capsys.readouterr().out.split())
    assert (tmp_path / "job/tables/nc7/NC7_X.PIT").is_file()
    # lost motion of 5 µm: the card tells it in the unit in which BACKLASH counts
    assert "backlash 5" in card


@pytest.mark.parametrize(
    ("name", "address", "options", "within"),
    [
        # The judge holds corrections as LinuxCNC does, in single precision: at 16 to 31 µm in steps
        # of 1.9 pm (IEEE 754), so that each is up to 0.93 pm off, a difference of two up to 1.9 pm.
        # What is told is a whole number of picometres.
        ("linuxcnc", "0", "{}", 2e-6),
        # Whole steps of the control: the two readers only add in another order.
        ("fanuc-30i", "1", "{detection_unit: 0.001, first_point: 0}", 1e-6),
    ],
)
def test_a_copy_under_another_id_writes_what_the_original_writes(
    name: str, address: str, options: str, within: float, tmp_path: Path
) -> None:
    copied(tmp_path / "mine.yaml", name, "mine")
    axis = f', address: "{address}", table: {{spacing: 100}}'
    mine = ran(job(tmp_path, "mine.yaml", axis, options))
    theirs = ran(job(tmp_path / "shipped", name, axis, options))
    tables = sorted((tmp_path / "job/tables/mine").iterdir())
    assert tables
    for path in tables:
        same = tmp_path / "shipped/job/tables" / name / path.name
        assert path.read_bytes() == same.read_bytes()
    assert theirs["axes"]["X"]["judged"] == "independent"
    assert theirs["doubts"] == []
    assert mine["axes"]["X"].pop("judged") == "read_back"
    del theirs["axes"]["X"]["judged"]
    assert_same(mine["axes"], theirs["axes"], within)


@pytest.mark.parametrize("name", [Path(name).stem for name in CONTROLS])
def test_the_one_reader_decodes_what_two_readers_decode(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    definition = DEFINITIONS[name]
    files = []
    for file, text in definition.expect[0].files.items():
        (tmp_path / file).write_text(text, newline="")
        files.append(str(tmp_path / file))
    given = definition.expect[0].options
    words = [word for key, value in given.items() for word in ("--option", f"{key}={value}")]
    mine = copied(tmp_path / "mine.yaml", name, "mine")
    answers = []
    for form in (name, str(mine)):
        axis = definition.expect[0].axis
        command = ["decode", *files, "--format", form, *words, "--axis", axis, "--json", "-"]
        assert compwright(command) == 0
        answers.append(json.loads(capsys.readouterr().out))
    judged, read_back = answers
    assert read_back["cross"] == judged["cross"]
    assert list(read_back["axes"]) == list(judged["axes"])
    for address, axis in judged["axes"].items():
        for key in ("positions", "correction_positive", "correction_negative"):
            np.testing.assert_allclose(read_back["axes"][address][key], axis[key], atol=1e-9)
    assert [finding["code"] for finding in read_back["findings"]][:1] == ["CW-S060"]


def test_tables_between_axes_are_read_back_by_the_one_reader(tmp_path: Path) -> None:
    copied(tmp_path / "mine.yaml", "siemens-840d-sl", "mine")
    write_circle(tmp_path / "xy.csv", Bent().circle(3, None))
    found = []
    for form, name in (("mine.yaml", "mine"), ("siemens-840d-sl", "siemens-840d-sl")):
        (tmp_path / "job.yaml").write_text(
            f"compwright: 1\ncontroller: {{format: {form}, options: {CEC}}}\n"
            "states: {as_found: none}\napply: {squareness: {XY: Y}}\naxes:\n"
            "  X: {travel: [0, 800], address: AX1, before: []}\n"
            "  Y: {travel: [-500, 0], address: AX2, before: []}\n"
            "circles: [{file: xy.csv, name: xy-150, centre: [400, -250]}]\n"
        )
        assert compwright(["run", str(tmp_path / "job.yaml"), "--out", str(tmp_path / name)]) == 0
        found.append(json.loads((tmp_path / name / "prediction.json").read_text()))
    assert found[0]["cross"] == found[1]["cross"] != []
    assert found[0]["circles"] == found[1]["circles"]


def test_what_is_read_once_adds_up_over_the_tables_of_a_pair() -> None:
    def table(value: float, output: str = "Y") -> CrossCompensation:
        return CrossCompensation(
            input="X",
            output=output,
            input_kind=AxisKind.LINEAR,
            output_kind=AxisKind.LINEAR,
            positions=np.array([0.0, 100.0]),
            positive=np.array([0.0, value]),
            negative=np.array([0.0, -value]),
            below="hold",
            above="hold",
        )

    state = ControlState(format="own", axes={}, cross=(table(1), table(2), table(9, "Z")))
    read = SingleReader(state)
    where = np.array([50.0, 100.0])
    np.testing.assert_array_equal(
        read.cross_correction("X", "Y", where, Direction.POSITIVE), [1.5, 3.0]
    )
    np.testing.assert_array_equal(
        read.cross_correction("X", "Y", where, Direction.NEGATIVE), [-1.5, -3.0]
    )
    assert not np.any(read.cross_correction("Y", "X", where, Direction.POSITIVE))


def test_paths_count_from_the_folder_of_the_job_whatever_letters_they_have(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "Prüfung 3" / "Jobs"
    tutorial(tmp_path / "Prüfung 3" / "Meine Maße" / "Nördlich #7.yaml")
    path = job(folder, '"../Meine Maße/Nördlich #7.yaml"')
    monkeypatch.chdir(tmp_path)
    assert ran(path.relative_to(tmp_path))["format"] == "nc7"


def test_new_writes_a_job_that_finds_the_definition(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    tutorial(tmp_path / "forms" / "nc 7.yaml")
    (tmp_path / "X.PIT").write_text(
        "PITCH X 0 = 0\nPITCH X 1 = 3\nPITCHSTART X = 0\nPITCHEND X = 100\nPITCHSTEP X = 100\n"
        "BACKLASH X = 4\nEND\n"
    )
    words = ["new", "--from", "X.PIT", "--format", "forms/nc 7.yaml", "--out", "jobs/job.yaml"]
    assert compwright(words) == 0
    assert JUDGED in " ".join(told(capsys))
    text = (tmp_path / "jobs/job.yaml").read_text(encoding="utf-8")
    assert "../forms/nc 7.yaml" in text
    assert compwright(["run", "jobs/job.yaml"]) == 2  # travel and tests are still open, no more
    assert not any("format" in line for line in told(capsys))


def test_the_card_says_where_a_definition_was_proven(tmp_path: Path) -> None:
    path = tutorial(tmp_path / "nc7.yaml")
    proof = '{control: NC-7 V4, machine: hall 2, date: "2025-03-14", how: verify}'
    change(path, f"-proven: []\n+proven: [{proof}]")
    ran(job(tmp_path))
    card = (tmp_path / "job/card/card.md").read_text(encoding="utf-8")
    assert "## Proven\n\nNC-7 V4, hall 2, 2025-03-14, verify\n" in card


def test_a_virtual_machine_loads_tables_by_a_definition_beside_its_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tutorial(tmp_path / "machines" / "nc7.yaml")
    (tmp_path / "tables").mkdir()
    (tmp_path / "tables" / "X.PIT").write_text(
        "PITCH X 0 = 0\nPITCH X 1 = 900\nPITCHSTART X = 0\nPITCHEND X = 100\n"
        "PITCHSTEP X = 100\nBACKLASH X = 0\nEND\n"
    )
    (tmp_path / "machines" / "m.yaml").write_text(MACHINE_FILE)
    monkeypatch.chdir(tmp_path)
    words = ["simulate", "machines/m.yaml", "--out", "out", "--with-tables", "tables"]
    assert compwright(words) == 0
    assert list((tmp_path / "out").glob("*.csv"))


# --- what is refused


@pytest.mark.parametrize("taken", ["linuxcnc", "LinuxCNC"])
def test_an_id_that_ships_cannot_be_taken(
    taken: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    copied(tmp_path / "mine.yaml", "linuxcnc", taken)
    assert compwright(["run", str(job(tmp_path, "mine.yaml"))]) == 2
    (line,) = told(capsys)
    assert "line 2, id: this is the id of a control that ships" in line
    assert "write `id: my-linuxcnc`, or use the control that ships by its name linuxcnc" in line
    assert not (tmp_path / "job").exists()


def test_the_check_refuses_what_no_command_would_take(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mine = tmp_path / "mine.yaml"
    mine.write_bytes(CONTENT["linuxcnc.yaml"] + b"# mine\n")
    assert compwright(["formats", "check", str(mine)]) == 3
    assert "id: this is the id of a control that ships" in told(capsys)[0]
    mine.write_bytes(CONTENT["linuxcnc.yaml"])  # the very one that ships
    assert compwright(["formats", "check", str(mine)]) == 0
    copied(mine, "linuxcnc", "mine")
    copied(tmp_path / "more.yaml", "linuxcnc", "MINE")  # one folder for both on some disks
    capsys.readouterr()
    assert compwright(["formats", "check", str(tmp_path)]) == 3
    assert "more.yaml: line 2, id: the id is given twice" in told(capsys)[0]


def test_a_field_in_the_title_of_a_step_is_refused_with_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tutorial(tmp_path / "nc7.yaml")
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("title: Load", "title: 'Load {file_1}'"), encoding="utf-8")
    assert compwright(["formats", "check", str(path)]) == 3
    assert any("title has no field file_1" in line for line in told(capsys))


def test_corrections_worked_by_hand_for_another_control_are_called_that(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    copied(tmp_path / "mine.yaml", "linuxcnc", "mine")
    assert compwright(["formats", "check", str(tmp_path / "mine.yaml")]) == 0
    said = capsys.readouterr().out
    assert "they are those of linuxcnc.yaml, none of its own" in said
    (doubt,) = ran(job(tmp_path, "mine.yaml", ', address: "0"'))["doubts"]
    assert doubt["values"] == {"definition": "mine", "expectation": "linuxcnc.yaml"}
    card = (tmp_path / "job/card/card.md").read_text(encoding="utf-8")
    assert doubt["message"] in card[: card.index("## Steps")]
    tutorial(tmp_path / "nc7.yaml")
    capsys.readouterr()
    assert compwright(["formats", "check", str(tmp_path / "nc7.yaml")]) == 0
    assert "none of its own" not in capsys.readouterr().out


@pytest.mark.parametrize("wrong", ["a/b", "..", "con", "LPT1", "nc 7", "größe", "x" * 65, ".nc7"])
def test_an_id_is_a_plain_name_for_a_folder(
    wrong: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text(f'extends: linuxcnc\nid: "{wrong}"\n', encoding="utf-8")
    assert compwright(["formats", "check", str(path)]) == 3
    assert "line 2, id: must be a plain name for a folder" in told(capsys)[0]


def hand_worked(*points: tuple[float, float, float]) -> str:
    rows = "".join(
        f"\n      - {{position: {at}, positive: {plus}, negative: {minus}}}"
        for at, plus, minus in points
    )
    return (
        "expect:\n  - name: mine\n    files: sample\n    options: {}\n    axis: X\n"
        f'    kind: linear\n    reference_return: "+"\n    unit: um\n    at:{rows}\n'
    )


@pytest.mark.parametrize(
    ("expect", "says"),
    [
        ("other: {}\n", "expect is missing"),
        ("expect: []\n", "line 181, expect: there is no hand-worked expectation"),
        (hand_worked((50, 1.5, -10.5), (100, 3, -9)), "has too few positions"),
        (
            hand_worked((0, 0, -12), (100, 3, -9), (200, -2, -14)),
            "only table points are worked by hand",
        ),
        (
            hand_worked((50, 1.5, 10.5), (100, 3, -9), (250, -2, -14)),
            "line 190, expect, mine: the correction at 50 arriving in - is not the one",
        ),
    ],
)
def test_a_definition_that_is_not_worked_by_hand_is_refused_and_nothing_is_written(
    expect: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tutorial(tmp_path / "nc7.yaml", expect=expect)
    assert compwright(["run", str(job(tmp_path))]) == 2
    lines = told(capsys)
    assert any(f"nc7.yaml: {says}" in line or says in line for line in lines), lines
    assert all("job.yaml: line 2, controller.format: " in line for line in lines)
    words = ["run", str(tmp_path / "x.csv"), "--format", str(tmp_path / "nc7.yaml")]
    assert compwright([*words, "--axis", "X", "--travel", "0:800", "--state", "none"]) == 2
    assert {path.name for path in tmp_path.iterdir()} == {"nc7.yaml", "job.yaml", "x.csv"}


def test_zeros_and_equal_directions_show_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    zeros = hand_worked((50, 0, 0), (100, 0, 0), (250, 0, 0))
    path = tutorial(tmp_path / "nc7.yaml", expect=zeros)
    text = path.read_text()
    for value in ("3.0", "-2.0", "12.0"):
        text = text.replace(f"= {value}\n", "= 0\n")
    path.write_text(text)
    assert compwright(["formats", "check", str(path)]) == 3
    lines = told(capsys)
    assert any("nothing but zeros is worked by hand: this shows no sign" in line for line in lines)
    assert any("at which the two directions differ" in line for line in lines)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"id: [", "is not valid YAML"),
        (b"\xff\xfe", "is not UTF-8 text"),
        (b"- a list\n", "is not a mapping; expected a mapping"),
        (b"#" * (1024 * 1024 + 1), "is too large"),
        (None, "cannot be read"),
    ],
)
def test_what_is_no_definition_is_refused(
    content: bytes | None, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "mine.yaml"
    if content is None:
        path.mkdir()
    else:
        path.write_bytes(content)
    (tmp_path / "X.PIT").write_text("END\n")
    assert compwright(["decode", str(tmp_path / "X.PIT"), "--format", str(path)]) == 2
    assert says in told(capsys)[0]
    if content is not None:
        assert compwright(["formats", "show", str(path)]) == 3
        assert says in told(capsys)[0]


def test_what_is_shown_of_a_definition_says_first_that_nobody_judges_it(tmp_path: Path) -> None:
    path = tutorial(tmp_path / "nc7.yaml")
    assert show_format(Session(), str(path))[1] == str(say("read_back", definition="nc7"))
    shipped = "\n".join(show_format(Session(), "linuxcnc"))
    assert JUDGED not in shipped


def test_a_name_that_is_no_id_says_how_a_file_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    assert compwright(["decode", "x", "--format", "nc7"]) == 2
    assert "linuxcnc" in (line := told(capsys)[0])
    assert "the path of a file *.yaml" in line
    assert compwright(["decode", "x", "--format", "fanuc.base"]) == 2


def test_two_definitions_of_one_id(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tutorial(tmp_path / "a.yaml")
    tutorial(tmp_path / "b.yaml")
    assert compwright(["formats", "check", str(tmp_path)]) == 3
    assert [without_hint(line) for line in told(capsys)] == [
        f"error: {tmp_path}/b.yaml: line 2, id: the id is given twice; found nc7 in {tmp_path}/a.yaml"
    ]


# --- the plan carries it


def test_export_compare_and_verify_work_from_the_plan(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tutorial(tmp_path / "nc7.yaml")
    ran(job(tmp_path))
    plan, tables = tmp_path / "job" / "plan.json", tmp_path / "job" / "tables" / "nc7"
    assert read_plan(plan.read_bytes(), "").definition == (("nc7.yaml", path.read_bytes()),)
    capsys.readouterr()
    path.unlink()
    for form, said in (("nc7", False), (str(path), True)):
        out = tmp_path / f"again-{said}"
        assert compwright(["export", str(plan), "--format", form, "--out", str(out)]) == 0
        assert any("nc7.yaml can no longer be read" in line for line in told(capsys)) == said
        table = (out / "NC7_X.PIT").read_bytes()
        assert table == (tables / "NC7_X.PIT").read_bytes()
    assert compwright(["compare", str(plan), "--loaded", str(tables)]) == 0
    assert "CW-S060" in capsys.readouterr().out
    after = tmp_path / "after.csv"
    targets = MACHINE.targets()
    change_by = (
        open_control(Session(), "nc7", {}, _carried(plan)).format.read(_files(tables)).axes["X"]
    )
    readings = MACHINE.measure(
        targets, 9, lambda x, sign: change_by.at(x, Direction("+" if sign > 0 else "-"))
    )
    after.write_text(csv_of(targets, readings))
    words = ["verify", str(tmp_path / "job.yaml"), "--after", str(after)]
    assert compwright([*words, "--out", str(tmp_path / "v1")]) == 0
    assert "CW-S061" in _codes(tmp_path / "v1")
    tutorial(path)  # as it was
    assert compwright([*words, "--out", str(tmp_path / "v2")]) == 0
    assert "CW-S061" not in (codes := _codes(tmp_path / "v2"))
    assert "CW-S060" in codes
    path.write_text(path.read_text().replace("sign: correction", "sign: error"))
    assert compwright([*words, "--out", str(tmp_path / "v3")]) == 0  # the plan's counts
    assert "CW-S061" in _codes(tmp_path / "v3")
    capsys.readouterr()
    changed = str(tmp_path / "changed")
    assert compwright(["export", str(plan), "--format", str(path), "--out", changed]) == 0
    assert any("nc7.yaml has changed since the run" in line for line in told(capsys))
    assert (tmp_path / "changed/NC7_X.PIT").read_bytes() == table


def _carried(plan: Path) -> Any:
    from compwright.controls.control import plan_origin

    return plan_origin(read_plan(plan.read_bytes(), str(plan)), plan)


def _files(folder: Path) -> list[Any]:
    from compwright.controls.control_files import read_files

    return list(read_files(Session(), [folder]))


def _codes(folder: Path) -> list[str]:
    document = json.loads((folder / "verification.json").read_text(encoding="utf-8"))
    return [finding["code"] for finding in document["findings"]]


def test_a_plan_carries_what_its_definition_extends(tmp_path: Path) -> None:
    tutorial(tmp_path / "nc7.yaml")
    (tmp_path / "nc6.yaml").write_text("extends: nc7.yaml\nid: nc6\ntitle: The other one\n")
    ran(job(tmp_path, "nc6.yaml"))
    plan = tmp_path / "job" / "plan.json"
    (tmp_path / "nc6.yaml").unlink()
    (tmp_path / "nc7.yaml").unlink()
    assert [name for name, _ in read_plan(plan.read_bytes(), "").definition] == [
        "nc6.yaml",
        "nc7.yaml",
    ]
    words = ["export", str(plan), "--format", "nc6", "--out", str(tmp_path / "again")]
    assert compwright(words) == 0


def test_a_plan_with_a_broken_definition_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tutorial(tmp_path / "nc7.yaml")
    ran(job(tmp_path))
    plan = tmp_path / "job" / "plan.json"
    document = json.loads(plan.read_text(encoding="utf-8"))
    text = document["definition"][0]["text"]
    capsys.readouterr()
    for broken, says in (
        (text.replace("sign: correction", "sign: error"), "is not the one worked by hand"),
        (text.replace("sign: correction", "sign: perhaps"), "sign is not an accepted value"),
        (text.replace("id: nc7", "id: linuxcnc"), "is the id of a control that ships"),
        (7, "definition[0] is not a file; expected the keys name and text, both text"),
    ):
        document["definition"][0]["text"] = broken
        plan.write_text(json.dumps(document), encoding="utf-8")
        loaded = str(tmp_path / "job/tables/nc7")
        assert compwright(["compare", str(plan), "--loaded", loaded]) == 3
        assert says in " ".join(told(capsys))


# --- extends


def test_a_changed_sign_on_top_of_a_definition_that_ships_is_noticed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "mine.yaml"
    path.write_text("extends: fanuc.base.yaml\nid: mine\ntitle: without its limits\nlimits: []\n")
    assert compwright(["formats", "check", str(path)]) == 3
    assert any("fanuc.base.yaml: line" in line for line in told(capsys))
    path.write_text("extends: fanuc-30i\nid: mine\n")
    assert compwright(["formats", "check", str(path)]) == 0
    assert JUDGED in capsys.readouterr().out
    # what turns the sign of increments
    changed = "extends: fanuc-30i\nid: mine\n"
    path.write_text(f'{changed}options:\n  pitch_sign: {{default: "-"}}\n')
    assert compwright(["run", str(job(tmp_path, "mine.yaml", FANUC, UNIT))]) == 2
    lines = told(capsys)
    assert lines
    assert all("fanuc.base.yaml: line" in line for line in lines[:-1]), lines
    # a sign that would have no effect there
    path.write_text(f"{changed}bindings:\n  value: {{sign: error}}\n")
    assert compwright(["formats", "check", str(path)]) == 3
    assert f"{path}: line 4, bindings.value.sign: error does not suit" in told(capsys)[0]
    path.write_text("extends: siemens-840d-sl\nid: mine\nbindings:\n  value: {sign: correction}\n")
    assert compwright(["run", str(job(tmp_path, "mine.yaml", ", address: AX1"))]) == 2
    assert all("siemens-840d-sl.yaml: line" in line for line in told(capsys)[:-1])


def test_faults_name_the_file_and_the_line_in_which_they_stand(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    base = tutorial(tmp_path / "nc7.yaml")
    change(base, "-  newline: crlf\n+  newline: both")
    over = tmp_path / "nc6.yaml"
    over.write_text("extends: nc7.yaml\nid: nc6\nbindings:\n  value:\n    digits: ten\n")
    assert compwright(["formats", "check", str(over)]) == 3
    first, second = told(capsys)
    assert f"{base}: line 15, dialect.newline is not an accepted value" in first
    assert f"{over}: line 5, bindings.value.digits is not a number" in second
    over.write_text("extends: nc7.yaml\nid: nc6\nbindings:\n  value:\n    digts: 1\n")
    assert compwright(["formats", "check", str(over)]) == 3
    assert any(
        f"{over}: line 5, bindings.value.digts: unknown key" in line for line in told(capsys)
    )


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("extends: nowhere.yaml\n", "line 1, extends extends a definition that is not there"),
        ("extends: [linuxcnc]\n", "line 1, extends extends a definition that is not there"),
        ("extends: mine.yaml\n", "line 1, extends extends itself"),
        ("extends: linuxcnc\nwithout: statements.row\n", "line 2, without has the wrong form"),
        (
            "extends: linuxcnc\nwithout: [card, statement.row, {a: 1}]\n",
            "line 2, without[1]: linuxcnc.yaml has no such key; expected statements.row",
        ),
    ],
)
def test_what_is_wrong_with_extends(
    text: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "mine.yaml").write_text(f"{text}id: mine\n")
    assert compwright(["formats", "check", str(tmp_path / "mine.yaml")]) == 3
    assert says in told(capsys)[0]


def test_mappings_are_merged_and_all_else_is_replaced_whole() -> None:
    base = (
        b"a:\n  kept: 1\n  said: [1, 2]\n  deep: {x: 1, y: 2}\nb: {p: 1, q: 2}\nc: 3\nd: [{e: 1}]\n"
    )
    over = (
        b"extends: base\nwithout: [b, c, a.kept]\n"
        b"a:\n  said: [3]\n  deep: {y: {z: 4}}\nb: {q: 5}\nd: []\n"
    )
    texts = texts_of(over, "over", found_in({"base.yaml": base}))
    assert texts == (("over", over), ("base.yaml", base))
    whole = merged(texts)
    assert whole.data == {
        "a": {"said": [3], "deep": {"x": 1, "y": {"z": 4}}},
        "d": [],
        "b": {"q": 5},
    }
    places = {path: file for path, (file, _) in whole.places.items()}
    assert places["a", "deep", "x"] == "base.yaml"
    assert places["a", "deep", "y", "z"] == places["b", "q"] == "over"
    gone = {("a", "kept"), ("a", "said", 1), ("b", "p"), ("c",), ("d", 0), ("d", 0, "e")}
    assert not gone & set(places)
    assert whole.places["a", "said", 0] == ("over", 4)
    assert whole.fault(("a", "deep", "x", "no"), "m").place == "line 4, a.deep.x.no"
    assert whole.fault(("f",), "m").file == "over"


# --- those that ship


def test_what_ships_is_judged_and_called_like_its_file() -> None:
    assert [Path(name).stem for name in CONTROLS] == list(DEFINITIONS) == sorted(DEFINITIONS)
    assert set(DEFINITIONS) <= set(KNOWN)
    assert all(definition.judged == "independent" for definition in DEFINITIONS.values())
    listed = re.findall(r"^  (\S+)", "\n".join(list_formats(Session())), re.MULTILINE)
    assert sorted(listed) == list(DEFINITIONS)
    assert set(CONTENT) - set(CONTROLS)  # the bases, which nobody lists


def test_a_base_is_no_control(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "fanuc.base.yaml"
    path.write_bytes(CONTENT["fanuc.base.yaml"])
    assert compwright(["formats", "check", str(path)]) == 3
    assert "extends it" in told(capsys)[0]
    assert compwright(["formats", "check", str(tmp_path)]) == 3
    assert "no definition of a control" in told(capsys)[0]
    assert definitions.is_path("a/b")
    assert not definitions.is_path("siemens-840d-sl")
