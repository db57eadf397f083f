"""What an error says to do next removes it: a table of kinds, each with the command that fails, the
part of the next step that is followed, and the command that follows it.
"""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from next_steps import MARK

pytestmark = pytest.mark.short_estimate

READINGS = "# axis: X\n# cycle: standard\ntarget_mm,direction,run,deviation_um\n" + "".join(
    f"{target},{sign},{run},{target / 40 + run / 10 + (3 if sign == '-' else 0):.2f}\n"
    for run in (1, 2, 3)
    for target in (0, 97, 206, 303, 400)
    for sign in "+-"
)
JOB = """\
compwright: 1
controller: {format: linuxcnc}
states: {as_found: none}
axes:
  X:
    travel: [0, 400]
    address: 0
    before: [x.csv]
"""
FANUC = JOB.replace("linuxcnc", "fanuc-30i, options: {detection_unit: 0.001, first_point: 1}")


@dataclass(frozen=True)
class Kind:
    """``fault``: part of the error; ``step``: part of its next step; ``files``: before the command
    that fails, and as the next step says.
    """

    fault: str
    step: str
    fails: str
    follows: str = ""
    files: tuple[dict[str, str], dict[str, str]] = ({}, {})


def job(fault: str, step: str, broken: str, whole: str = JOB) -> Kind:
    """Return the kind of a wrong job. Its test is absent, so that nothing is worked out."""
    broken, whole = (text.replace("x.csv", "absent.csv") for text in (broken, whole))
    words = "run job.yaml --out r --force"
    return Kind(fault, step, words, files=({"job.yaml": broken}, {"job.yaml": whole}))


def csv(fault: str, step: str, broken: str, whole: str = READINGS) -> Kind:
    """Return the kind of a wrong measurement file."""
    return Kind(fault, step, "evaluate x.csv", files=({"x.csv": broken}, {"x.csv": whole}))


SHORT = "run x.csv --format linuxcnc --axis X --travel 0:400 --state none --out r --force"
KINDS = {
    "a missing key": job("is missing", "add `travel: [0, 800]` to `axes.X`", JOB.replace("travel: [0, 400]", "kind: linear")),
    "an unknown key": job("unknown key", "rename it to `travel`", JOB.replace("travel", "travle")),
    "ends turned": job("not in order", "write `travel: [0, 400]`", JOB.replace("0, 400", "400, 0")),
    "a wrong word": job("accepted value", "write `kind: linear`", JOB + "    kind: lineal\n"),
    "a newer job": job("compwright", "correct the line `compwright:`", JOB.replace(": 1\n", ": 9\n", 1)),
    "an empty job": job("is empty", "write its keys", ""),
    "broken YAML": job("not valid YAML", "correct this line", JOB.replace("[0, 400]", "[0, 400")),
    "a list": job("is not a job", "make a job file", "- 1\n"),
    "an unknown format": job("no such control format", "formats list", JOB.replace("linuxcnc", "linuxnc")),
    "an unknown option": job("has no option", "leave this option out", JOB.replace("linuxcnc", "linuxcnc, options: {unit: mm}")),
    "a wrong option": job("has a wrong value", "correct the value", JOB.replace("linuxcnc", "linuxcnc, options: {units: ell}"), JOB.replace("linuxcnc", "linuxcnc, options: {units: mm}")),
    "no detection unit": job("the detection unit of the axis", "write `detection_unit: VALUE`", FANUC.replace("detection_unit: 0.001, ", ""), FANUC),
    "no axis number": job("needs the number", "add `address: 1`", FANUC.replace("address: 0", "address: X"), FANUC.replace("address: 0", "address: 1")),
    "no free number": job("free point numbers", "`first_point: 1`", FANUC.replace(", first_point: 1", "").replace("address: 0", "address: 1"), FANUC.replace("address: 0", "address: 1")),
    "one address twice": job("the same address", "correct `axes.Y.address`", JOB + JOB.partition("axes:\n")[2].replace("X:", "Y:"), JOB + JOB.partition("axes:\n")[2].replace("X:", "Y:").replace("address: 0", "address: 1")),
    "a key twice": job("twice", "remove one of the two", JOB + "    address: 0\n"),
    "a number as text": job("not a number", "correct `axes.X.reference`", JOB + "    reference: home\n"),
    "a test without a file": Kind("does not exist", "check the path", "run job.yaml --out r --force", files=({"job.yaml": JOB.replace("x.csv", "y.csv")}, {"job.yaml": JOB})),
    "one number as travel": Kind("look like 0:800", "`--travel 0:800`", SHORT.replace("0:400", "400"), SHORT),
    "a slip in the name of an option": Kind("the nearest known name", "`--option address=0`", SHORT + " --option adress=0", SHORT + " --option address=0"),
    "a tab in YAML": job("not valid YAML", "replace each tab", JOB.replace("  X:", "\tX:"), JOB),
    "two values as travel": Kind("look like 0:800", "`--travel 0:800`", SHORT.replace("0:400", "-400 0"), SHORT),
    "an option without a value": Kind("look like KEY=VALUE", "one key and its value", SHORT + " --option units", SHORT + " --option units=mm"),
    "an option twice": Kind("is given twice", "remove one", SHORT + " --option units=mm --option units=mm", SHORT + " --option units=mm"),
    "no format": Kind("--format is missing", "add `--format ID`", SHORT.replace("--format linuxcnc", ""), SHORT),
    "no axis": Kind("--axis is missing", "add `--axis X`", SHORT.replace("--axis X", ""), SHORT),
    "an answer about no state": Kind("none are given", "--state FILE", "run x.csv --format linuxcnc --axis X --travel 0:400 --option active=yes --out r", SHORT),
    "an option of a job": Kind("together with a job", "leave --format out", "run job.yaml --format linuxcnc --out r --force", "run job.yaml --out r --force"),
    "results as a job": Kind("folder of results", "JOB.yaml that was run", "run job --out r --force", "run job.yaml --out r --force"),
    "an unknown standard": Kind("unknown standard", "--standard iso230-2:2014", "evaluate x.csv --standard ISO_230-2", "evaluate x.csv --standard iso230-2:2014"),
    "a standard of no circle": Kind("unknown standard", "one of these standards", "evaluate x.csv --standard asme-b5.54", "evaluate x.csv --standard iso230-2:2014"),
    "no range method": Kind("range method", "--spread std", "evaluate x.csv --standard iso230-2:2014 --spread range", "evaluate x.csv --standard iso230-2:2014 --spread std"),
    "an unknown table": Kind("unknown ending", "ends in .csv", "evaluate x.csv --table t.pdf", "evaluate x.csv --table t.csv --force"),
    "an unknown report": Kind("unknown ending", ".html", "evaluate x.csv --report r.doc", "evaluate x.csv --report r.html --force"),
    "one file for two": Kind("already used for", "two different files", "evaluate x.csv --json t.csv --table t.csv", "evaluate x.csv --json t.json --table t.csv --force"),
    "a file that exists": Kind("exists already", "`--force`", "evaluate x.csv --json there.json", "evaluate x.csv --json there.json --force", ({"there.json": "{}"}, {})),
    "positions without a step": Kind("look like 0:800:10", "`--at 0:800:10`", "decode job/tables/linuxcnc --format linuxcnc --at 1:2", "decode job/tables/linuxcnc --format linuxcnc --at 0:400:100"),
    "results to decode": Kind("is a folder of results", "give job/tables/linuxcnc", "decode job --format linuxcnc", "decode job/tables/linuxcnc --format linuxcnc"),
    "a job as a plan": Kind("is a job file", "plan.json in the results", "compare job.yaml --loaded job/tables/linuxcnc", "compare job/plan.json --loaded job/tables/linuxcnc"),
    "a job to evaluate": Kind("is a job file", "that the instrument wrote", "evaluate job.yaml", "evaluate x.csv"),
    "no state to export": Kind("existing compensation", "--state none", "export job/plan.json --format siemens-840d-sl --out e --force", "export job/plan.json --format siemens-840d-sl --state none --out e --force"),
    "no plan": Kind("there is no plan", "`--plan DIR`", "verify job.yaml --after x.csv --plan nowhere --out v", "verify job.yaml --after x.csv --plan job --out v --force"),
    "no such test": Kind("is not a test of the job", "before the `=`", "verify job.yaml --after z=x.csv --out v", "verify job.yaml --after x=x.csv --out v --force"),
    "a folder without results": Kind("contains no results", "that `compwright run`", "history empty", "history job"),
    "an unknown definition": Kind("no such control format", "formats list", "formats show fanuc30", "formats show fanuc-30i"),
    "a profile for nothing": Kind("needs no profile", "without `--profile`", "profile x.csv --out p.yaml", "evaluate x.csv"),
    "a folder without files": Kind("contains no files", "give the measurement files", "evaluate empty", "evaluate x.csv"),
    "text among numbers": csv("is not a number", "correct line 6, column deviation_um", READINGS.replace("97,+,1,", "97,+,1,a")),
    "no header": csv("is empty", "add a header row", ""),
    "comments alone": csv("comment lines only", "add a header row", "# axis: X\n"),
    "inches": csv("in inches", "export the file again in mm", READINGS.replace("target_mm", "target_in")),
    "an unknown direction": csv("neither + nor -", "write + or -", READINGS.replace("97,+,1,", "97,*,1,")),
    "a newer file": csv("newer version of compwright", "install the newer version", "# compwright: positioning 2\n" + READINGS),
    "no readings": csv("contains no readings", "add the readings below the header row", READINGS.partition("0,+,1")[0]),
}  # fmt: skip


def errors(words: str, capsys: pytest.CaptureFixture[str]) -> Sequence[str]:
    """Return the errors that a command prints; an underscore stands for a blank in a word."""
    capsys.readouterr()
    compwright([word.replace("_", " ") for word in words.split()])
    return [line for line in capsys.readouterr().err.splitlines() if line.startswith("error")]


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A job and its results."""
    folder = tmp_path_factory.mktemp("done")
    (folder / "x.csv").write_text(READINGS)
    (folder / "job.yaml").write_text(JOB)
    (folder / "empty").mkdir()
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    return folder


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
def test_the_next_step_removes_the_fault(
    kind: Kind,
    done: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    shutil.copytree(done, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    for name, text in kind.files[0].items():
        Path(name).write_text(text)
    found = [line for line in errors(kind.fails, capsys) if kind.fault in line]
    assert found
    for line in found:
        assert kind.step in line.partition(MARK)[2], line
    for name, text in kind.files[1].items():
        Path(name).write_text(text)
    left = errors(kind.follows or kind.fails, capsys)
    assert not [line for line in left if kind.fault in line], left


def test_the_table_is_long() -> None:
    assert len(KINDS) >= 40
