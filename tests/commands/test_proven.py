"""What a good verification proves of a control: only on a real machine, only what its tests can
tell, and never written into job or definition.
"""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest
import yaml

from compwright.cli import run as compwright
from compwright.verification.proven_facts import SURE, proven_axis, sign_odds
from places import PROJECT

EXAMPLE = PROJECT / "examples" / "fanuc-backup"

pytestmark = pytest.mark.short_estimate


def real(file: Path, date: str) -> None:
    """Make a simulated file one of a real machine, taken on ``date``."""
    lines = file.read_text(encoding="utf-8").splitlines()
    kept = [line for line in lines if not line.startswith("# simulated")]
    file.write_text("\n".join([f"# date: {date}", *kept]) + "\n", encoding="utf-8")


@pytest.fixture(scope="module")
def machine(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a job that was run, the test after loading (simulated), and what was read
    back.
    """
    folder = tmp_path_factory.mktemp("machine") / "job"
    shutil.copytree(EXAMPLE, folder)
    real(folder / "before" / "x.csv", "2026-03-01")
    assert compwright(["run", str(folder / "job.yaml")]) == 0
    tables = folder / "job" / "tables" / "fanuc-30i"
    words = ["simulate", str(folder / "machine.yaml"), "--seed", "2"]
    assert compwright([*words, "--out", str(folder / "after"), "--with-tables", str(tables)]) == 0
    shutil.copytree(tables, folder / "read back")
    return folder


def verify(folder: Path, *words: str, loaded: str = "read back") -> int:
    return compwright(
        [
            *("verify", str(folder / "job.yaml"), "--after", str(folder / "after" / "x.csv")),
            *("--loaded", str(folder / loaded), *words),
        ]
    )


def test_simulated_files_say_so(machine: Path) -> None:
    head = (machine / "after" / "x.csv").read_text(encoding="utf-8")
    assert "# simulated: by compwright, not measured on a machine" in head


def test_a_simulated_test_proves_nothing(
    machine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(machine, folder)
    assert verify(folder) == 0
    assert "a simulated test is not a test of a machine" in capsys.readouterr().err
    assert not (folder / "job" / "proven").exists()


def test_what_was_not_read_back_proves_nothing(
    machine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(machine, folder)
    real(folder / "after" / "x.csv", "2026-03-02")
    for out in (folder / "job", tmp_path / "elsewhere"):
        assert verify(folder, "--out", str(out), loaded="job/tables/fanuc-30i") == 0
        assert "not what was read back" in capsys.readouterr().err
        assert not (out / "proven").exists()


def test_a_real_machine_leaves_a_piece_for_the_job_and_one_for_the_definition(
    machine: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "job"
    shutil.copytree(machine, folder)
    real(folder / "after" / "x.csv", "2026-03-02")
    job = (folder / "job.yaml").read_bytes()
    assert verify(folder) == 0
    assert (folder / "job.yaml").read_bytes() == job
    piece = folder / "job" / "proven" / "for_the_job.yaml"
    own, shared = (
        yaml.safe_load(path.read_text(encoding="utf-8"))["proven"][0]
        for path in (piece, piece.with_name("for_the_definition_fanuc-30i.yaml"))
    )
    assert set(own) == set(shared) == {"control", "machine", "date", "how"}
    assert own["date"] == shared["date"] == "2026-03-02"
    assert "SIM-3" in own["machine"]
    assert "SIM-3" not in str(shared)  # a serial number is nobody else's business
    assert "software version: fill in" in own["control"]
    proven, _, rest = own["how"].partition("not proven: ")
    for fact in ("read back as written", "sign of the values", "sign and size of the backlash"):
        assert fact in proven
    # the table has one curve; the sign of its pitch data was an option that no manual states
    assert rest.startswith("two curves, one for each direction")
    assert "pitch_sign +" in rest
    # added to the job it is read, and the card of the next run shows it
    with (folder / "job.yaml").open("a", encoding="utf-8") as stream:
        stream.write(piece.read_text(encoding="utf-8"))
    assert compwright(["run", str(folder / "job.yaml"), "--out", str(tmp_path / "next")]) == 0
    card = (tmp_path / "next" / "card" / "card.md").read_text(encoding="utf-8")
    assert "2026-03-02" in card
    assert "not proven: two curves" in card


def test_before_anything_is_proven_the_card_names_what_is_not(machine: Path) -> None:
    card = (machine / "job" / "card" / "card.md").read_text(encoding="utf-8")
    assert "Nothing yet on a machine: not the form of the files, not sign" in card


LOADED = {
    "verdict": "loaded",
    "equivalent": [],
    "near": [],
    "candidates": [{"verdict": "loaded"}],
}
BOTH = {"others": True, "backlash": True, "two_curves": True}


def test_what_a_candidate_leaves_open_is_not_proven() -> None:
    sure = proven_axis("X", LOADED, 20.0, **BOTH)
    assert sure.unproven == ()
    open_one = {**LOADED, "equivalent": ["shifted"], "candidates": [{"verdict": "backlash"}]}
    found = proven_axis("X", open_one, 20.0, **BOTH)
    assert found.unproven == ("their places", "sign and size of the backlash value")
    assert "sign of the values" in proven_axis("X", LOADED, SURE - 0.1, **BOTH).unproven
    near = {**LOADED, "near": ["scaled"]}  # the test lies too close to tell, likely or not
    assert proven_axis("X", near, 20.0, **BOTH).unproven == ("size and unit of the values",)
    inverted = {**LOADED, "candidates": [{"verdict": "inverted"}]}
    assert "sign of the values" in proven_axis("X", inverted, 20.0, **BOTH).unproven


def test_odds_of_the_sign() -> None:
    """A table of 10 µm is told from a turned one by readings of 0.5 µm, one of 0.3 µm is not; a
    datum of the instrument says nothing.
    """
    rng = np.random.default_rng(1)
    where = np.linspace(0.0, 1.0, 15)
    scatter = np.full(15, 0.5 / np.sqrt(5))
    for size, least, most in ((10.0, SURE, 1e9), (0.3, -1e9, SURE), (-10.0, SURE, 1e9)):
        table = size * np.sin(5.0 * where)
        before = -table + rng.normal(0.0, scatter)
        found = rng.normal(0.0, scatter) + 40.0
        curves = [(np.zeros(15), before, found)]
        assert least <= sign_odds(curves, scatter) < most
    turned = [(np.zeros(15), -table, -2.0 * table + 40.0)]
    assert sign_odds(turned, scatter) < -SURE
    assert sign_odds([], scatter) == 0.0


def test_a_neighbour_that_was_changed_while_loading_is_no_good_verification(
    machine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Point 102 belongs to the second axis, which is not in the job: 4 increments of 2 µm more."""
    folder = tmp_path / "job"
    shutil.copytree(machine, folder)
    file = folder / "read back" / "PITCH.TXT"
    lines = file.read_text(encoding="ascii").splitlines(keepends=True)
    (place,) = [number for number, line in enumerate(lines) if line.startswith("N10102Q0P")]
    lines[place] = f"N10102Q0P{int(lines[place].strip()[9:]) + 4}\n"
    file.write_text("".join(lines), encoding="ascii")
    assert verify(folder) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "differs from the plan outside of its axis tables: N10102Q0 (2)" in said
    assert "Verdict: bad" in said


def test_a_neighbour_that_cannot_be_read_any_more_is_no_good_verification(
    machine: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Parameter 3624 of the second axis, which is not in the job, was not read back: `compare` is
    undecided.
    """
    folder = tmp_path / "job"
    shutil.copytree(machine, folder)
    real(folder / "after" / "x.csv", "2026-03-02")
    file = folder / "read back" / "CNC-PARA.TXT"
    text = file.read_text(encoding="ascii")
    assert "A2M100.0" in text
    file.write_text(text.replace("A2M100.0", ""), encoding="ascii")
    assert verify(folder) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "CW-V033" in said
    assert "Verdict: undecided" in said
    assert not (folder / "job" / "proven").exists()
