"""The next round after loading: what it adds to, whom it leaves alone, when it stops, and the folder
that it leaves.

The machine, the virtual controls and the evaluation of A stand apart from the package. Where a test
needs it, the verdict on the loading is given, not judged: how it is judged has tests of its own.
"""

from __future__ import annotations

import html
import json
import re
import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.documents.plan import read_plan
from compwright.documents.verification import VerifiedAxis
from compwright.foundations import storage
from compwright.foundations.errors import StorageError
from compwright.foundations.findings import Finding
from compwright.foundations.session import Session
from compwright.foundations.yaml_reader import read_yaml
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from compwright.words.sentences import say
from compwright.workflow.commands import verify
from compwright.workflow.commands.compare import compare_plan
from compwright.workflow.inputs.input_copies import files_of_job, kept
from compwright.workflow.inputs.jobs import read_job_file
from compwright.workflow.verify.next_round import (
    Round,
    Verified,
    _measured,
    known_with_rounds,
    next_round,
    refuse_later_rounds,
)
from compwright.workflow.verify.verified_axis import verified_axis
from loop import Floats, Machine, accuracy, allowed, csv_of

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages]

ADDRESSES = {"linuxcnc": ("0", "1"), "siemens-840d-sl": ("AX1", "AX2")}
MACHINES = {"X": Machine(bow=0.008), "Y": Machine(slope=-30e-6, bow=0.008, lost=0.003)}
#: Too few targets for the shape of the error, yet as many as the standard asks for; and enough.
FEW, MANY = 5, 25


def correction(folder: Path, format_id: str, axis: str) -> Callable[[Floats, int], Floats]:
    """What a control with the files of ``folder`` adds to an axis."""
    files = [ControlFile(path.name, path.read_bytes()) for path in sorted(folder.iterdir())]
    addresses = ADDRESSES[format_id]
    judge = virtual_control(
        format_id, files, reference_return=dict.fromkeys(addresses, Direction.POSITIVE)
    )
    address = addresses["XY".index(axis)]
    return lambda x, sign: judge.correction(
        address, x, Direction.POSITIVE if sign > 0 else Direction.NEGATIVE
    )


def measured(
    path: Path, axis: str, count: int, seed: int, acts: Callable[[Floats, int], Floats] | None
) -> str:
    machine = MACHINES[axis]
    targets = machine.targets(count)
    path.write_text(csv_of(targets, machine.measure(targets, seed, acts), axis))
    return str(path)


def written_job(folder: Path, format_id: str, axes: str, more: str = "") -> Path:
    sections = "".join(
        f"  {axis}: {{travel: [0, 800], address: '{ADDRESSES[format_id]['XY'.index(axis)]}',"
        f" before: [{axis.lower()}.csv]{more}}}\n"
        for axis in axes
    )
    job = folder / "job.yaml"
    job.write_text(
        f"compwright: 1\ncontroller: {{format: {format_id}}}\nstates: {{as_found: none}}\n"
        f"axes:\n{sections}"
    )
    return job


def _all_loaded(judge: Callable[..., VerifiedAxis]) -> Callable[..., VerifiedAxis]:
    """As if the measurement had shown of every axis that its table acts as it should."""

    def give(*arguments: Any, **words: Any) -> VerifiedAxis:
        found = judge(*arguments, **words)
        loading = {key: value for key, value in found.loading.items() if key != "of"}
        kept = tuple(one for one in found.findings if one.severity == "error")
        return replace(found, loading={**loading, "verdict": "loaded"}, findings=kept)

    return give


def update(job: Path, after: list[str], loaded: Path, *more: str) -> tuple[int, Any]:
    """Verify and update; the exit code and the document where there is one."""
    words = [word for file in after for word in ("--after", file)]
    code = compwright(["verify", str(job), *words, "--loaded", str(loaded), "--update", *more])
    out = job.parent if (job.parent / "plan.json").is_file() else job.with_suffix("")
    path = out / "verification.json"
    return code, json.loads(path.read_text(encoding="utf-8")) if code < 2 else None


# ---------------------------------------------------------------- rounds


@dataclass
class Rounds:
    """A machine over two rounds: the folders, and the A of fresh tests at new targets with what
    each has written (µm).
    """

    format: str
    first: Path
    second: Path
    documents: list[Any]
    values: list[float]


@pytest.fixture(scope="module", params=list(ADDRESSES))
def rounds(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Rounds:
    """The first test has too few targets: its table leaves something. The next round takes it away
    and the one after it stops.
    """
    format_id: str = request.param
    folder = tmp_path_factory.mktemp(f"rounds-{format_id}")
    measured(folder / "x.csv", "X", FEW, 1, None)
    job = written_job(folder, format_id, "X")
    out, documents, values = folder / "job", [], []
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(verify, "verified_axis", _all_loaded(verified_axis))
        assert compwright(["run", str(job)]) == 0
        for number in (1, 2):
            control = folder / f"control{number}"
            shutil.copytree(out / "tables" / format_id, control)
            acts = correction(control, format_id, "X")
            machine = MACHINES["X"]
            fresh = machine.targets(MANY, seed=8)
            values.append(1e3 * accuracy(machine.measure(fresh, 90 + number, acts)))
            after = measured(folder / f"after{number}.csv", "X", MANY, 10 * number, acts)
            code, document = update(job, [after], control)
            assert code == 0, document
            documents.append(document)
            job, out = out / "next" / "job.yaml", out / "next"
    return Rounds(format_id, folder / "job" / "next", out, documents, values)


def test_what_the_first_table_left_the_next_round_takes_away(rounds: Rounds) -> None:
    machine = MACHINES["X"]
    limit = 1e3 * allowed(machine, machine.targets(MANY, seed=8), 40.0)
    first, second = rounds.values
    assert first > 1.4 * limit, "the first round must leave something"
    assert second <= limit
    told = rounds.documents[0]["next"]["axes"]["X"]
    assert (told["updated"], told["table"]) == (True, True)


def test_the_round_after_it_stops_and_says_what_is_left(rounds: Rounds) -> None:
    then = rounds.documents[1]["next"]
    assert then["written"]
    assert then["axes"]["X"]["table"] is False
    assert "come from the largest cause: noise" in then["axes"]["X"]["reason"]
    assert not (rounds.second / "tables").exists()
    assert not (rounds.second / "card").exists()
    present = {path.name for path in rounds.second.iterdir() if path.is_file()}
    assert {"job.yaml", "plan.json", "prediction.json", "evaluation.json", "record.json"} <= present
    assert {"report.html"} <= present


def test_the_page_of_the_verification_shows_the_next_round(rounds: Rounds) -> None:
    for folder, document in zip((rounds.first.parent, rounds.first), rounds.documents, strict=True):
        page = (folder / "verification.html").read_text(encoding="utf-8")
        words = " ".join(html.unescape(re.sub("<[^>]+>", " ", page)).split())
        then = document["next"]
        mark = (
            "table for the next correction round"
            if then["axes"]["X"]["table"]
            else "no new table for the next correction round"
        )
        shown = then["axes"]["X"]["reason"].replace("um", "µm")
        assert f"Next round {then['reason']}. X {mark} {shown}" in words


def test_the_next_plan_starts_from_what_was_read_back(rounds: Rounds) -> None:
    """The totals are what acts now less what the tests of both rounds show."""
    plan = read_plan((rounds.first / "plan.json").read_bytes(), "plan.json")
    axis = plan.axes["X"]
    acts = correction(rounds.first / "control" / "as_found", rounds.format, "X")
    where = np.linspace(20, 780, 30)
    assert axis.active is not None
    for direction in Direction:
        sign = 1 if direction is Direction.POSITIVE else -1
        assert axis.active.at(where, direction) == pytest.approx(acts(where, sign), abs=1e-6)
    assert [(each.test.name, each.measured_in) for each in axis.tests] == [
        ("x", "as_found"),
        ("x_round_1", "round_1"),
    ]
    assert all(each.acted is not None for each in axis.tests)  # both count
    assert sorted(plan.states) == ["as_found", "round_1"]


@pytest.mark.usefixtures("afresh")
def test_the_job_of_the_round_gives_the_same_bytes_again(rounds: Rounds) -> None:
    def content() -> dict[Path, bytes]:
        return {path: path.read_bytes() for path in rounds.second.rglob("*") if path.is_file()}

    before = content()
    assert compwright(["run", str(rounds.second / "job.yaml"), "--force"]) == 0
    assert [str(path) for path, bytes_ in content().items() if bytes_ != before.get(path)] == []


def test_an_earlier_test_without_its_state_is_still_refused(
    rounds: Rounds, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The job of the round is right; the same tests, all said to be taken as found, are not."""
    above = tmp_path / "job"
    shutil.copytree(rounds.first.parent, above, ignore=shutil.ignore_patterns("next"))
    shutil.copytree(rounds.first, above / "next", ignore=shutil.ignore_patterns("next"))
    job = above / "next" / "job.yaml"
    text = job.read_text(encoding="utf-8")
    assert text.count("measured_in: round_1") == 1
    job.write_text(text.replace("measured_in: round_1", "measured_in: as_found"), encoding="utf-8")
    assert compwright(["run", str(job), "--out", str(tmp_path / "other")]) == 2
    assert "added a second time" in capsys.readouterr().err


# ---------------------------------------------------------------- who is left alone


@dataclass
class Pair:
    """Two axes whose first tests have too few targets, loaded and measured again; what ``verify``
    found, all well, and what ``compare`` answers.
    """

    folder: Path
    found: Verified
    compared: Mapping[str, Any]

    def next(self, compared: Any = None, **axes: VerifiedAxis | None) -> Round:
        """The next round with other findings for some axes (None: not measured)."""
        known = {**self.found.axes, **axes}
        kept = {name: axis for name, axis in known.items() if axis is not None}
        tests = [test for test in self.found.tests if test.axis in kept]
        found = replace(self.found, axes=kept, tests=tests)
        return next_round(Session(), found, compared or self.compared, self.folder / "job")

    def told(self, axis: str, verdict: str) -> VerifiedAxis:
        """An axis with another verdict on its loading."""
        found = self.found.axes[axis]
        return replace(found, loading={**found.loading, "verdict": verdict})


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Pair:
    folder = tmp_path_factory.mktemp("pair")
    for number, axis in enumerate(MACHINES):
        measured(folder / f"{axis.lower()}.csv", axis, FEW, 1 + number, None)
    job = written_job(folder, "linuxcnc", "XY")
    assert compwright(["run", str(job)]) == 0
    control = folder / "control"
    shutil.copytree(folder / "job" / "tables" / "linuxcnc", control)
    after = [
        measured(
            folder / f"{axis}.csv", axis, MANY, 10 + number, correction(control, "linuxcnc", axis)
        )
        for number, axis in enumerate(MACHINES)
    ]
    plan = folder / "job" / "plan.json"
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(verify, "verified_axis", _all_loaded(verified_axis))
        found, _, _ = verify._verified(
            Session(), read_job_file(Session(), job), after, plan, [control]
        )
    return Pair(folder, found, compare_plan(Session(), plan, [control]).document)


@pytest.mark.parametrize(
    "verdict",
    ["not_active", "inverted", "scaled", "shifted", "partial", "measurement", "undecided"],
)
def test_only_what_is_loaded_is_added_to(pair: Pair, verdict: str) -> None:
    """A flipped sign would be made larger, a table that does not act be added a second time."""
    then = pair.next(X=pair.told("X", verdict), Y=pair.told("Y", verdict))
    assert not then.files
    assert then.document["written"] is False
    for axis in "XY":
        assert verdict.replace("_", " ") in then.document["axes"][axis]["reason"]
        assert "keeps what is in the control" in then.document["axes"][axis]["reason"]


@pytest.mark.parametrize("code", ["CW-V020", "CW-V021", "CW-V024", "CW-E010"])
def test_a_test_in_doubt_is_not_built_upon(pair: Pair, code: str) -> None:
    doubted = {
        name: replace(
            axis, findings=(Finding(code, "warning", say("as_written", text="Look again.")),)
        )
        for name, axis in pair.found.axes.items()
    }
    then = pair.next(**doubted)
    assert not then.files
    assert all(code in axis["reason"] for axis in then.document["axes"].values())


def differing(pair: Pair, axis: str, quantity: str) -> dict[str, Any]:
    """What ``compare`` answers where one quantity of an axis differs."""
    entry = {"axis": axis, "quantity": quantity, "planned": "1", "loaded": "2", "unit": None}
    return {**pair.compared, "verdict": "different", "differences": [entry]}


def test_what_was_read_back_has_to_be_the_plan(pair: Pair) -> None:
    then = pair.next(differing(pair, "X", "BACKLASH"), Y=pair.told("Y", "undecided"))
    assert not then.files
    assert "differs from the plan" in then.document["axes"]["X"]["reason"]
    assert "BACKLASH" in then.document["axes"]["X"]["reason"]


def test_what_else_was_changed_in_the_control_is_settled_first(pair: Pair) -> None:
    then = pair.next(differing(pair, "2", "BACKLASH of joint 2"))
    assert not then.files
    assert "other values in the control were changed" in then.document["reason"]
    assert "BACKLASH of joint 2" in then.document["reason"]


def test_values_without_an_axis_are_those_of_the_table_that_is_not_the_plans(pair: Pair) -> None:
    """Rows of a table name no axis: what its axis shows says what was read back."""
    compared = differing(pair, "", "100.0000000 positive")
    said = {"verdict": "not_active", "message": "what was in the control before is still there"}
    axes = {**compared["axes"], "X": {**compared["axes"]["X"], **said}}
    then = pair.next({**compared, "axes": axes})
    assert not then.files
    reason = then.document["reason"]
    assert "axis X: what was in the control before is still there" in reason
    assert "something else" not in reason


def test_what_cannot_be_compared_is_not_built_upon(pair: Pair) -> None:
    then = pair.next("the files contain no data of axis X")
    assert not then.files
    assert "the files contain no data of axis X" in then.document["reason"]


def test_squareness_alone_is_answered_in_words(pair: Pair) -> None:
    """Circles after loading and no test of an axis: what to give, or what to run."""
    job = replace(pair.found.job, apply=replace(pair.found.job.apply, squareness={"XY": "Y"}))
    circles: Any = {"xy": SimpleNamespace(squareness=None, findings=())}
    bare = {name: replace(axis, fitted=None) for name, axis in pair.found.plan.axes.items()}
    for axes, said in (
        (pair.found.plan.axes, "measure at least one axis that has a table after loading"),
        (bare, "make a new job: give the files that were read back as as_found"),
    ):
        plan = replace(pair.found.plan, axes=axes)
        found = replace(pair.found, job=job, plan=plan, circles=circles, axes={}, tests=[])
        then = next_round(Session(), found, pair.compared, pair.folder / "job")
        assert not then.files
        assert said in then.document["reason"]


def test_a_circle_that_was_not_measured_after_loading_is_not_built_upon(pair: Pair) -> None:
    files = {name: [pair.folder / f"{name}.csv"] for name in ("xy", "yz")}
    for code in ("CW-V025", "CW-V029", "CW-V032"):
        finding = Finding(code, "warning", say("CW-V025", circle="xy"))
        found = replace(pair.found, circle_files=files, findings=(finding,))
        assert list(_measured(found)) == ["yz"]
    for code in ("CW-V021", "CW-V026", "CW-V036"):
        finding = Finding(code, "warning", say("CW-V025", circle="xy"))
        circles: Any = {"xy": SimpleNamespace(findings=(finding,))}
        assert list(_measured(replace(pair.found, circle_files=files, circles=circles))) == ["yz"]


def test_a_definition_that_lies_in_the_folder_is_not_kept_twice(pair: Pair, tmp_path: Path) -> None:
    """That of a next round lies in ``definition/``; one from elsewhere gets its copy."""
    own, elsewhere = tmp_path / "next" / "definition" / "own.yaml", tmp_path / "base.yaml"
    own.parent.mkdir(parents=True)
    for path in (own, elsewhere):
        path.write_bytes(f"# {path.name}\n".encode())
    texts = [(str(path), path.read_bytes()) for path in (own, elsewhere)]
    texts.append(("shipped.yaml", b"# as it ships"))
    given = [
        file
        for file in files_of_job(Session(), pair.found.job, pair.folder, tuple(texts))
        if file.role == "definition"
    ]
    recorded, copies = kept(given, tmp_path / "next", by="run", there={}, written=())
    assert [file.copy for file in recorded] == [
        "definition/own.yaml",
        "inputs/base.yaml",
        "inputs/shipped.yaml",
    ]
    assert sorted(copies) == ["inputs/base.yaml", "inputs/shipped.yaml"]


def test_limits_that_were_edited_after_the_run(pair: Pair) -> None:
    edited = Finding(
        "CW-V022", "warning", say("as_written", text="The job was edited after the run.")
    )
    found = replace(pair.found, findings=(edited,))
    then = next_round(Session(), found, pair.compared, pair.folder / "job")
    assert not then.files
    assert then.document["reason"] == edited.message


@pytest.mark.parametrize(
    "other", [pytest.param("inverted", id="inverted"), pytest.param(None, id="not measured")]
)
def test_an_axis_that_is_well_goes_on_alone(pair: Pair, other: str | None) -> None:
    """Its files are one set with those of the other, which keep what is in the control."""
    then = pair.next(Y=None if other is None else pair.told("Y", other))
    axes = then.document["axes"]
    assert (axes["X"]["table"], axes["Y"]["updated"], axes["Y"]["table"]) == (True, False, False)
    tables = {
        name.removeprefix("next/tables/linuxcnc/"): content
        for name, content in then.files.items()
        if name.startswith("next/tables/")
    }
    before = {path.name: path.read_bytes() for path in (pair.folder / "control").iterdir()}
    assert tables.keys() <= before.keys()
    assert {name for name in tables if tables[name] != before[name]} == {"joint_0.comp"}
    job = read_yaml(then.files["next/job.yaml"], "job.yaml").data
    assert list(job["axes"]) == ["X"]


@pytest.fixture(scope="module")
def made(pair: Pair) -> Round:
    """The next round where both axes are well."""
    return pair.next()


def test_several_tests_keep_their_names_and_states(made: Round) -> None:
    job = read_yaml(made.files["next/job.yaml"], "job.yaml").data
    assert list(job["states"]) == ["as_found", "round_1"]
    assert job["states"]["round_1"] == "none"
    assert [(test["name"], test["measured_in"]) for test in job["axes"]["Y"]["before"]] == [
        ("y", "as_found"),
        ("y_round_1", "round_1"),
    ]
    assert job["axes"]["Y"]["table"] == {"gain": "seen"}


# ---------------------------------------------------------------- its folder


def stored(out: Path, then: Round, *, force: bool = False) -> None:
    storage.write_files(
        Session(),
        out,
        then.files,
        force=force,
        whole=then.whole,
        renewed=then.renewed,
        known=known_with_rounds(Session(), out, lambda _name, _content: False),
    )


def test_it_is_replaced_only_where_nobody_changed_it(made: Round, tmp_path: Path) -> None:
    stored(tmp_path, made)
    with pytest.raises(StorageError):
        stored(tmp_path, made)
    stored(tmp_path, made, force=True)
    job = tmp_path / "next" / "job.yaml"
    job.write_bytes(job.read_bytes() + b"# mine\n")
    with pytest.raises(StorageError, match="changed since"):
        stored(tmp_path, made, force=True)
    assert job.read_bytes().endswith(b"# mine\n")


def test_what_an_earlier_round_had_more_goes(made: Round, tmp_path: Path) -> None:
    """Other files read back, no tables any more: nothing of the earlier round stays."""
    stored(tmp_path, made)
    gone = ("next/tables/", "next/card/", "next/control/as_found/")
    fewer = {name: text for name, text in made.files.items() if not name.startswith(gone)}
    stored(tmp_path, replace(made, files=fewer), force=True)
    found = {
        path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file()
    }
    assert found == set(fewer)


def test_a_round_that_has_gone_on_stays(tmp_path: Path) -> None:
    refuse_later_rounds(Session(), tmp_path)
    (tmp_path / "next").mkdir()
    (tmp_path / "next" / "verification.json").write_text("{}")
    with pytest.raises(StorageError, match="not even with --force"):
        refuse_later_rounds(Session(), tmp_path)


@pytest.fixture
def hall(pair: Pair, tmp_path: Path) -> Path:
    shutil.copytree(pair.folder, tmp_path / "hall")
    return tmp_path / "hall"


def test_it_needs_what_was_read_back(hall: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["verify", str(hall / "job.yaml"), "--after", str(hall / "X.csv"), "--update"]
    assert compwright(words) == 2
    assert "--loaded" in capsys.readouterr().err
    assert not (hall / "job" / "verification.json").exists()


def test_an_inverted_table_is_found_and_nothing_is_written(
    hall: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The verdict is that of the measurement here, and the read-back is the plan's."""
    acts = correction(hall / "control", "linuxcnc", "X")
    after = measured(hall / "X.csv", "X", MANY, 20, lambda x, sign: -acts(x, sign))
    code, document = update(hall / "job.yaml", [after], hall / "control")
    assert (code, document["next"]["written"]) == (1, False)
    assert not (hall / "job" / "next").exists()
    text = capsys.readouterr().out
    assert "No next round: no axis gets a new table" in text
    assert 'the verdict is "inverted", not "loaded"' in text
    assert "axis Y: this axis was not measured after loading" in text
