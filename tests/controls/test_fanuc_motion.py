"""Tests at rapid traverse: 1852 acted in them where 1800#4 of the axis' path is 1 (FANUC B-64120EN/01
page 116), and both backlash values are right afterwards. The virtual machine is that of
test_fanuc_backup_honoured: what the control adds is summed by hand from the numbers.
"""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from test_fanuc_backup_honoured import SMALL, UNIT, Bench, Edits, added, error, said

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

_RNG = np.random.default_rng
SEPARATE: Edits = {(981, "1"): "1", (1800, "L1"): "00011000", (1800, "L2"): "00001000"}
ALIKE: Edits = {(981, "1"): "1", (1800, "L1"): "00001000", (1800, "L2"): "00011000"}
RAPID = {"X": "before: {files: X.csv, motion: rapid}"}


def left(bench: Bench, *, rapid: bool) -> float:
    """Range over travel and directions, mm, with the written files loaded."""
    parameters, points = bench.written()
    x = np.linspace(-1000.0, 0.0, 301)
    return float(
        np.ptp([error(1, x, s) + added(parameters, points, 1, x, s, rapid=rapid) for s in (1, -1)])
    )


@pytest.mark.parametrize("mode", ["single", "bidirectional"])
def test_a_test_at_rapid_traverse_is_taken_with_1852(mode: str, tmp_path: Path) -> None:
    """1851 = 40, 1852 = 10 detection units of 0.1 µm: 3 µm apart. Right at the motion of the test,
    and at feed exactly the difference that the control had already.
    """
    bench = Bench(tmp_path, SEPARATE, rapid=True)
    assert bench.run("X", axes={"X": f"{RAPID['X']}, table: {{mode: {mode}}}"}) == 0
    parameters, _ = bench.written()
    feed, rapid = (int(said(parameters, number, 1)) for number in (1851, 1852))
    assert feed - rapid == 40 - 10
    if mode == "bidirectional":
        assert rapid == 0  # the reversal at the motion of the test is in the two tables
    else:
        # what acts alone takes the 4 µm of lost motion away (3 runs of 0.3 µm)
        assert rapid * UNIT == pytest.approx(0.004, abs=0.0006)
        assert left(bench, rapid=True) < SMALL
    card = (tmp_path / "job" / "card" / "card.md").read_text()
    assert f"1851 = {feed}" in card
    assert (
        f"1852 = {rapid} detection units (at rapid traverse; 1851 is active at cutting feed" in card
    )
    assert (
        "check positions of this card are valid at rapid traverse"
        in card[card.index("## Axis X") :]
    )


def test_where_1852_does_not_act_the_motion_makes_no_difference(tmp_path: Path) -> None:
    written = []
    for number, axes in enumerate(({}, RAPID)):
        (tmp_path / str(number)).mkdir()
        bench = Bench(tmp_path / str(number), ALIKE)
        assert bench.run("X", axes=axes) == 0
        written.append(bench.written())
        assert (1852, "A1") not in bench.changed()
        card = (bench.folder / "job" / "card" / "card.md").read_text()
        assert "1852 = 10 detection units (is not active" in card
    assert written[0] == written[1]


@pytest.mark.parametrize("line", ["1800", "1852"])
def test_what_acted_at_rapid_traverse_has_to_be_in_the_files(
    line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path, SEPARATE, rapid=True)
    bench.parameters = re.sub(rf"^N0{line}.*\n", "", bench.parameters, flags=re.MULTILINE)
    (tmp_path / "CNC-PARA.TXT").write_text(bench.parameters)
    bench.measure = lambda *_: None  # type: ignore[method-assign]
    (tmp_path / "X.csv").write_text("target_mm,direction,run,deviation_mm\n" + "".join(
        f"{x},{mark},{run},{0.001 * run}\n"
        for x in range(-1000, 1, 100) for mark in "+-" for run in (1, 2, 3)
    ))  # fmt: skip
    assert bench.run("X", axes=RAPID) == 3
    error_text = capsys.readouterr().err
    assert line in error_text
    assert "motion: rapid" in error_text


def test_tests_at_both_motions_agree_and_are_predicted_each_by_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The same axis measured at feed and at rapid traverse: reversals 3 µm apart by the control
    alone. No doubt, and both predictions hold; verify takes each after-test at its motion.
    """
    bench = Bench(tmp_path, SEPARATE)
    bench.measure("X")
    shutil.copy(tmp_path / "X.csv", tmp_path / "feed.csv")
    bench.words = {"rapid": True}
    bench.measure("X")
    shutil.copy(tmp_path / "X.csv", tmp_path / "rapid.csv")
    bench.measure = lambda *_: None  # type: ignore[method-assign]
    job = tmp_path / "job.yaml"
    bench.run("X")
    text = job.read_text().replace(
        "before: [X.csv]", "before: [feed.csv, {files: rapid.csv, motion: rapid}]"
    )
    job.write_text(text)
    assert compwright(["run", str(job), "--force"]) == 0
    prediction = json.loads((tmp_path / "job" / "prediction.json").read_text())
    tests = {test["name"]: test for test in prediction["axes"]["X"]["tests"]}
    codes = [finding["code"] for finding in prediction["axes"]["X"].get("findings", [])]
    assert "CW-T036" not in codes
    assert tests["feed"]["predicted"]["B"]["median"] < 1.0  # µm
    # at rapid traverse 1852 stays 3 µm below 1851: the lost motion that is left
    assert tests["rapid"]["predicted"]["B"]["median"] == pytest.approx(3.0, abs=0.8)
    # after loading: each test repeated at its own motion is what was expected of it
    bench.parameters, bench.points = bench.written()
    for name, rapid in (("feed", False), ("rapid", True)):
        bench.words = {"rapid": rapid}
        with monkeypatch.context() as fresh:  # other noise than in the first tests
            fresh.setattr(np.random, "default_rng", lambda seed: _RNG(seed + 77))
            Bench.measure(bench, "X")
        after = tmp_path / f"{name}_after.csv"
        shutil.copy(tmp_path / "X.csv", after)
        out = tmp_path / f"verified_{name}"
        compwright(["verify", str(job), "--after", f"{name}={after}", "--out", str(out)])
        verified = json.loads((out / "verification.json").read_text())["axes"]["X"]
        assert verified["loading"]["verdict"] == "loaded", verified["loading"]
