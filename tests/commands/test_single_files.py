"""A file named for an answer and there already: with --force only what may be an earlier answer is
replaced, never what is certainly something else.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import openpyxl
import pytest

from compwright.cli import run as compwright
from compwright.foundations.errors import StorageError
from compwright.foundations.session import Session
from compwright.reporting.evaluation_table import table_bytes
from compwright.workflow.results.single_files import kind_of, refuse_other_kinds
from laser_files import laser_file

pytestmark = pytest.mark.short_estimate

CSV = b"# axis: X\ntarget_mm,direction,run,deviation_um\n0,+,1,1\n100,+,1,2\n"
FOREIGN = "Soll;Ist\r\n1,0;1,1\r\n2,0;2,1\r\n".encode("cp1252")
LASER = laser_file(["0", "100"], {(1, 1): "0.1", (1, 2): "0.2"}).encode("cp1252")
CIRCLE = b"# plane: XY\ndirection,angle_deg,deviation_um\nccw,0,1\n"
EVALUATION = b'{\n  "schema": "compwright/evaluation/1",\n  "results": []\n}\n'
PLAN = b'{"schema": "compwright/plan/1"}'
JOB = b"# mine\ncompwright: 1\ncontroller: {format: fanuc-30i}\n"
PROFILE = b"compwright_profile: 1\n"
SVG = b'<?xml version="1.0"?>\n<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN">\n<svg></svg>'
INI = b"CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.004\nM17\n"


def workbook(tmp_path: Path) -> bytes:
    path = tmp_path / "x.xlsx"
    openpyxl.Workbook().save(path)
    return path.read_bytes()


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (CSV, "a measurement"),
        (CSV.replace(b"# axis: X", "# Prüfer".encode("cp1252")), "a measurement"),
        (LASER, "a measurement"),
        (CIRCLE, "a measurement"),
        (b'<?xml version="1.0"?><TEST_DOCUMENT/>', "a measurement"),
        (FOREIGN, "a table"),
        (JOB, "a job"),
        (PROFILE, "a mapping profile"),
        (b"virtual_machine: 1\n", "a virtual machine"),
        (EVALUATION, "a JSON document (compwright/evaluation)"),
        (PLAN, "a JSON document (compwright/plan)"),
        (SVG, "a picture"),
        (b"\x89PNG\r\n", "a picture"),
        (b"mine", ""),
        (b"\x00\x01", ""),
        (INI, ""),
    ],
)
def test_what_a_file_certainly_is(content: bytes, kind: str) -> None:
    assert kind_of(content) == kind
    assert kind_of(content + b"\n" * 70_000) == kind


@pytest.mark.parametrize(
    ("name", "there", "new", "may"),
    [
        ("a.json", EVALUATION, EVALUATION.replace(b"[]", b"[1]"), True),
        ("a.json", b"mine", EVALUATION, True),
        ("a.json", b"", EVALUATION, True),
        ("a.csv", b"", EVALUATION, True),
        ("a.json", CSV, EVALUATION, False),
        ("a.json", FOREIGN, EVALUATION, False),
        ("a.json", LASER, EVALUATION, False),
        ("a.json", JOB, EVALUATION, False),
        ("a.json", PLAN, EVALUATION, False),
        ("MD.INI", INI, EVALUATION, False),
        ("x.csv", CSV, EVALUATION, False),
        ("x.svg", SVG, b"\x89PNG", True),
        ("x.svg", b"old", SVG, True),
        ("x.json", EVALUATION, SVG, False),
        ("j.yaml", JOB, JOB + b"axes: {}\n", True),
        ("j.yaml", PROFILE, JOB, False),
        ("p.yaml", JOB, PROFILE, False),
        (
            "t.csv",
            b"machine,axis,a,b\nm,X,1,2\nm,Y,2,3\n",
            b"machine,axis,a,b\nm,X,1,3\nm,Y,2,4\n",
            True,
        ),
        ("t.csv", FOREIGN, b"machine,axis,a,b\nm,X,1,3\nm,Y,2,4\n", False),
        ("t.csv", CSV, b"machine,axis,a,b\nm,X,1,3\nm,Y,2,4\n", False),
    ],
)
def test_what_may_be_replaced(
    name: str, there: bytes, new: bytes, may: bool, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(there)
    refuse_other_kinds(Session(), {tmp_path / name: new}, force=False)
    if may:
        refuse_other_kinds(Session(), {tmp_path / name: new}, force=True)
        return
    with pytest.raises(StorageError) as caught:
        refuse_other_kinds(Session(), {tmp_path / name: new}, force=True)
    assert f"{name}: the file was not written by this command" in str(caught.value)


def test_a_workbook_is_not_replaced_by_a_document(tmp_path: Path) -> None:
    (tmp_path / "a.json").write_bytes(workbook(tmp_path))
    with pytest.raises(StorageError, match="found a workbook"):
        refuse_other_kinds(Session(), {tmp_path / "a.json": EVALUATION}, force=True)


def test_a_workbook_of_the_user_is_not_replaced_by_a_table(tmp_path: Path) -> None:
    """Also one that began as a table of compwright and was saved by a spreadsheet program since."""
    path = tmp_path / "t.xlsx"
    document: dict[str, object] = {"results": [], "errors": []}
    table = table_bytes(document, ".xlsx")
    longer = table_bytes({**document, "errors": [{"file": "a", "message": "b"}]}, ".xlsx")
    path.write_bytes(table)
    refuse_other_kinds(Session(), {path: longer}, force=True)
    openpyxl.load_workbook(path).save(path)
    with pytest.raises(StorageError, match="found a workbook"):
        refuse_other_kinds(Session(), {path: longer}, force=True)
    for content in (workbook(tmp_path), b"PK\x03\x04 and no more"):
        path.write_bytes(content)
        with pytest.raises(StorageError, match="found a workbook"):
            refuse_other_kinds(Session(), {path: table}, force=True)


@pytest.mark.parametrize(
    "words",
    [
        ["evaluate", "x.csv", "--json", "other.csv"],
        ["evaluate", "x.csv", "--plot", "other.svg"],
        ["profile", "foreign.csv", "--out", "job.yaml"],
    ],
)
def test_commands_refuse_it(
    words: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    rows = b"".join(
        b"%d,%c,%d,1.%d\n" % (100 * i, d, r, i + r) for d in b"+-" for r in (1, 2) for i in range(5)
    )
    (tmp_path / "x.csv").write_bytes(CSV.partition(b"0,+")[0] + rows)
    shutil.copy(tmp_path / "x.csv", tmp_path / "other.csv")
    shutil.copy(tmp_path / "x.csv", tmp_path / "other.svg")
    (tmp_path / "foreign.csv").write_bytes(FOREIGN)
    (tmp_path / "job.yaml").write_bytes(JOB)
    monkeypatch.chdir(tmp_path)
    before = (tmp_path / words[-1]).read_bytes()
    assert compwright([*words, "--force"]) == 5
    assert "was not written by this command" in capsys.readouterr().err
    assert (tmp_path / words[-1]).read_bytes() == before
