"""Limits of circular tests and the uncertainty that guards them: contributors by hand and by what
they do to the parameters of a test, decisions about predicted and measured values.
"""

from __future__ import annotations

import io
import json
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from compwright.cli import run as command
from compwright.evaluation.circular import evaluate_circle
from compwright.evaluation.circular_uncertainty import circular_uncertainties
from compwright.foundations.findings import Finding
from compwright.planning.circles import undecided_circle_findings, with_uncertainty
from compwright.planning.doubts import ScopedFinding, find_doubts
from compwright.planning.limit_decisions import (
    circle_decisions,
    lacking_circle_guard,
    measured_circle_decisions,
)
from compwright.records.circular import CircularResult, CircularRun, Diagnosis
from compwright.records.conditions import CircularBudget, Thermal
from compwright.records.job import Acceptance
from compwright.records.prediction import CirclePrediction, Quantiles
from compwright.words.sentences import say

pytestmark = pytest.mark.short_estimate

Rule = Literal["simple", "guarded"]
UM = 1e-3
MACHINE = Machine(squareness=30.0, backlash_first_at_positive=3.0, backlash_second_at_negative=5.0)
TEST = measured(MACHINE, Setup(noise=0.1), np.random.default_rng(1))
RESULT = evaluate_circle(TEST)
BUDGET = CircularBudget(U=0.7, length=0.5, setup=0.3, E_VE=0.6, U_theta=0.5, U_alpha=1.0)
THERMAL = Thermal(alpha_m=11.0, T_m=22.0)
FORM = 0.7**2 + 0.3**2 + 2.0 * 0.6**2 / 3  # µm²; the difference of two readings
BAR = 0.7**2 + 0.3**2 + 0.6**2 / 3 + 0.5**2  # of one reading
SIZE = BAR + (11.0 * 0.15 * 0.5) ** 2 + (2.0 * 0.15 * 1.0) ** 2


def compwright(*words: str) -> tuple[int, str]:
    with redirect_stdout(io.StringIO()) as out, redirect_stderr(io.StringIO()) as err:
        code = command(list(words))
    return code, " ".join((out.getvalue() + err.getvalue()).split())


# ---- uncertainty ----


def test_contributors_by_hand() -> None:
    """R = 150 mm at 22 °C: the length and its temperature count in F and D alone."""
    names = ("G_ccw", "G_bidirectional_lsc", "H", "D", "F_max_cw", "F_min_ccw_lsc")
    found = circular_uncertainties(TEST, names, BUDGET, THERMAL)
    for name in names:
        expected = FORM if name[0] in "GH" else SIZE
        assert pytest.approx(np.sqrt(expected), abs=1e-6) == found[name].U / UM
        assert found[name].coverage == 2.0
    steel = circular_uncertainties(TEST, ["D"], CircularBudget(U_theta=1.0, U_alpha=9.0), None)
    assert pytest.approx(11.5 * 0.15) == steel["D"].U / UM


def test_the_length_of_the_bar_moves_f_and_d_and_leaves_g() -> None:
    longer = evaluate_circle(
        replace(TEST, runs=tuple(replace(r, deviations=r.deviations + UM) for r in TEST.runs))
    )
    for name, value in RESULT.parameters.items():
        if value is not None:
            moved = (longer.parameters[name] or 0.0) - value
            assert moved == pytest.approx(UM if name[0] in "FD" else 0.0, abs=1e-6)


@pytest.mark.parametrize("seed", range(3))
def test_a_drift_moves_no_parameter_by_more_than_its_range(seed: int) -> None:
    rng = np.random.default_rng(seed)
    runs = []
    for run in TEST.runs:
        wave = np.sin(rng.uniform(1.0, 20.0) * np.linspace(0.0, 1.0, run.angles.size))
        drift = (wave - wave.min()) / np.ptp(wave)  # range 1 µm
        runs.append(replace(run, deviations=run.deviations + drift * UM))
    drifting = evaluate_circle(replace(TEST, runs=tuple(runs)))
    for name, value in RESULT.parameters.items():
        if value is not None:
            assert abs((drifting.parameters[name] or 0.0) - value) < 1.001 * UM


def test_what_the_test_does_not_have_has_no_uncertainty() -> None:
    bare = evaluate_circle(replace(TEST, calibrated=False))
    stated = with_uncertainty(bare, BUDGET, None).uncertainty
    assert stated is not None
    assert set(stated) == {name for name, value in bare.parameters.items() if value is not None}
    assert "F_max_ccw" not in stated
    assert with_uncertainty(bare, None, None).uncertainty is None


# ---- decisions ----


DIAGNOSIS = Diagnosis(
    effects={},
    plain={},
    names=(),
    correlation=np.empty((0, 0)),
    residual=0.0,
    correlation_length=1.0,
)


def prediction(p05: float, p95: float, budget: CircularBudget | None) -> CirclePrediction:
    before = replace(with_uncertainty(RESULT, budget, None), diagnosis=DIAGNOSIS)
    band = Quantiles((p05 + p95) / 2 * UM, p05 * UM, p95 * UM)
    return CirclePrediction(before=before, expected=before, predicted={"D": band}, causes={})


@pytest.mark.parametrize(
    ("band", "rule", "decision"),
    [
        ((3.0, 4.9), "simple", "accept"),
        ((3.0, 5.1), "simple", "undecided"),
        ((5.1, 6.0), "simple", "reject"),
        ((-4.9, -3.0), "simple", "accept"),  # D has a sign: its size is limited
        ((-6.0, -5.1), "simple", "reject"),
        ((3.0, 3.9), "guarded", "accept"),
        ((3.0, 4.1), "guarded", "undecided"),
        ((5.9, 7.0), "guarded", "undecided"),
        ((6.1, 7.0), "guarded", "reject"),
    ],
)
def test_predicted(band: tuple[float, float], rule: Rule, decision: str) -> None:
    """A limit of 5 µm on D, U = 1 µm."""
    found = circle_decisions(
        Acceptance(limits={"D": 5.0}), prediction(*band, CircularBudget(U=1.0)), rule
    )["D"]
    assert (found.decision, found.limit) == (decision, 5.0)
    assert (pytest.approx(1.0) if rule == "guarded" else None) == found.U


def test_a_guard_of_nothing_decides_nothing() -> None:
    accept = circle_decisions(Acceptance(limits={"D": 5.0}), prediction(0.0, 1.0, None), "guarded")
    assert accept["D"].decision == "undecided"
    (finding,) = lacking_circle_guard("xy", accept)
    assert (finding.code, "uncertainty.circular" in finding.message) == ("CW-P132", True)
    assert circle_decisions(None, prediction(0.0, 1.0, None), "guarded") == {}


def test_a_circle_of_unknown_causes_is_not_decided() -> None:
    """Its band holds the noise of the samples alone, and is too narrow either way."""
    limits = Acceptance(limits={"D": 5.0})
    known = prediction(1.0, 2.0, None)
    reasons = {"diagnosis": "too short an arc"}
    unknown = replace(known, before=replace(known.before, diagnosis=None, not_applicable=reasons))
    decided = circle_decisions(limits, unknown, "simple")
    assert decided["D"].decision == "undecided"
    assert undecided_circle_findings({"xy": unknown}) == ()  # no limits: nothing is left open
    (finding,) = undecided_circle_findings({"xy": replace(unknown, accept=decided), "yz": known})
    assert finding.code == "CW-P134"
    assert "circle xy" in finding.message
    assert "3000 samples over 360°" in finding.message
    assert "Export the samples without smoothing" in finding.message
    test = unknown.before.test
    few = replace(test, runs=tuple(thinned(run, 60) for run in test.runs))
    for lacking, advice in (
        (few, "Measure with at least 24 samples per run"),
        (replace(test, runs=test.runs[:1]), "Measure a full circle in both directions"),
        (replace(test, arc=(0.0, 220.0)), "Measure a full circle in both directions"),
    ):
        asked = replace(unknown, before=replace(unknown.before, test=lacking), accept=decided)
        (finding,) = undecided_circle_findings({"xy": asked})
        assert advice in finding.message


def thinned(run: CircularRun, step: int) -> CircularRun:
    return replace(run, angles=run.angles[::step], deviations=run.deviations[::step])


def after(D: float) -> CircularResult:
    result = replace(RESULT, parameters={**RESULT.parameters, "D": D * UM})
    return with_uncertainty(result, CircularBudget(U=1.0), None)


@pytest.mark.parametrize(
    ("D", "rule", "believed", "proven", "decision"),
    [
        (4.9, "simple", True, True, "accept"),
        (-5.1, "simple", True, True, "reject"),
        (4.1, "guarded", True, True, "undecided"),
        (3.9, "guarded", True, True, "accept"),
        (6.1, "guarded", True, True, "reject"),
        (4.9, "simple", False, True, "undecided"),
        (4.9, "simple", True, False, "undecided"),
        (5.1, "simple", True, False, "reject"),
    ],
)
def test_measured(D: float, rule: Rule, believed: bool, proven: bool, decision: str) -> None:
    accept = measured_circle_decisions(
        Acceptance(limits={"D": 5.0}), after(D), rule, believed=believed, proven=proven
    )
    assert accept["D"].decision == decision
    assert accept["D"].value == pytest.approx(D)


def test_a_doubt_about_a_circle_or_its_axes_leaves_its_limits_open() -> None:
    of_circle = ScopedFinding(
        Finding("CW-C013", "warning", say("as_written", text="zeros")), frozenset(), "xy"
    )
    of_axis = ScopedFinding(
        Finding("CW-C013", "warning", say("as_written", text="zeros")), frozenset({"Y"})
    )
    axes = ("X", "Y", "Z")
    assert find_doubts([of_circle], (), axes).about_circle("xy", ("X", "Y"))
    assert not find_doubts([of_circle], (), axes).about_circle("zx", ("Z", "X"))
    assert not find_doubts([of_circle], (), axes).about("X")
    assert find_doubts([of_axis], (), axes).about_circle("xy", ("X", "Y"))
    assert not find_doubts([of_axis], (), axes).about_circle("zx", ("Z", "X"))


# ---- the job ----

JOB = """\
compwright: 1
controller: {format: linuxcnc}
states: {as_found: none}
axes:
  X: {travel: [0, 800], address: 0, before: []}
  Y: {travel: [0, 800], address: 1, before: []}
circles: [{file: xy.csv, name: xy, centre: [400, 400], accept: %s}]
"""


def run(folder: Path, accept: str, more: str = "") -> tuple[int, str, Any]:
    lines = [
        f"{run.sense},{angle:.4f},{deviation / UM:.3f}"
        for run in TEST.runs
        for angle, deviation in zip(run.angles, run.deviations, strict=True)
    ]
    keys = "# plane: XY\n# nominal_radius_mm: 150\n# feed_mm_min: 2000\n# calibrated: yes\n"
    (folder / "xy.csv").write_text(
        keys + "\n".join(["direction,angle_deg,deviation_um", *lines]) + "\n", encoding="utf-8"
    )
    path = folder / "job.yaml"
    path.write_text(JOB % accept + more, encoding="utf-8")
    code, told = compwright("run", str(path), "--force")
    answer = folder / "job" / "prediction.json"
    return code, told, json.loads(answer.read_text(encoding="utf-8")) if answer.exists() else None


@pytest.mark.real_pages
def test_limits_decide_the_exit_code_and_the_page(tmp_path: Path) -> None:
    G = (RESULT.parameters["G_bidirectional"] or 0.0) / UM
    code, told, answer = run(tmp_path, f"{{G_bidirectional: {2 * G:.3f}, D: 100}}")
    circle = answer["circles"]["xy"]
    assert (code, circle["accept"]["G_bidirectional"]["decision"]) == (0, "accept")
    assert "accept" in told
    page = (tmp_path / "job" / "report.html").read_text(encoding="utf-8")
    assert "All limits are predicted to be met" in page
    code, _, answer = run(tmp_path, f"{{G_bidirectional: {G / 2:.3f}, D: 100}}")
    accept = answer["circles"]["xy"]["accept"]
    assert code == 1
    assert {name: entry["decision"] for name, entry in accept.items()} == {
        "G_bidirectional": "reject",
        "D": "accept",
    }


def test_a_guarded_decision_takes_the_contributors_of_circles(tmp_path: Path) -> None:
    guarded = "decision_rule: guarded\n"
    code, told, answer = run(tmp_path, "{D: 100}", guarded + "uncertainty: {device: {U: 9}}\n")
    assert (code, answer["circles"]["xy"]["accept"]["D"]["decision"]) == (1, "undecided")
    assert "CW-P132" in told
    budget = "uncertainty: {U_theta: 0.5, circular: {U: 0.7, length: 0.5, setup: 0.3, E_VE: 0.6}}\n"
    code, _, answer = run(tmp_path, "{D: 100}", guarded + budget)
    D = answer["circles"]["xy"]["accept"]["D"]
    U = np.sqrt(BAR + (11.5 * 0.15 * 0.5) ** 2)
    assert (code, D["decision"], D["rule"]) == (0, "accept", "guarded")
    assert pytest.approx(U, abs=1e-6) == D["U"]
    evaluation = json.loads((tmp_path / "job" / "evaluation.json").read_text(encoding="utf-8"))
    stated = evaluation["results"][0]["uncertainty"]
    assert stated["D"] == {"U": pytest.approx(U, abs=1e-6), "coverage": 2}
    assert stated["G_ccw"]["U"] == pytest.approx(np.sqrt(FORM), abs=1e-6)


@pytest.mark.parametrize(
    ("accept", "more", "words"),
    [
        ("{G_cww: 5}", "", "circles[0].accept.G_cww is not a parameter of a circular test"),
        ("{H: 5}", "", "circles[0].accept.H: iso230-4:2005 gives no value of H for the test xy"),
        ("{D: -5}", "", "circles[0].accept.D"),
        ("{D: 5}", "decision_rule: guarded\n", "needs the measurement uncertainty"),
    ],
)
def test_faults_of_the_job(tmp_path: Path, accept: str, more: str, words: str) -> None:
    code, told, answer = run(tmp_path, accept, more)
    assert (code, answer) == (2, None)
    assert words in told
