"""Declared temperature and set-up: the slope between two tests, in the band or in the guard; whose
temperatures count.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from compwright.evaluation.expansion import remove_differential_expansion
from compwright.evaluation.temperatures import stated_temperatures, with_temperatures
from compwright.evaluation.uncertainty import slope_between_tests
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.session import Session
from compwright.jobs.reading import read_job
from compwright.planning.axis_work import predict_axis, start_axis
from compwright.planning.temperature_slopes import fresh_slope, slope_after, with_temperature_slopes
from compwright.prediction.active_corrections import no_correction
from compwright.records.axis import AxisKind
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.correction import ControlState
from compwright.records.job import Job
from compwright.records.plan import Plan, PlannedTest
from compwright.records.prediction import AxisPrediction
from compwright.workflow.inputs.after_tests import after_tests
from compwright.workflow.inputs.job_inputs import read_test
from planning_samples import PPM, TARGETS, UM, axis_of, job_of, readings_of

STEEL = Thermal(alpha_m=11.5, T_m=24.0)
THETA = UncertaintyBudget(U_theta=0.5)
FLAT = readings_of(np.zeros((11, 5)), np.zeros((11, 5)), thermal=STEEL)


# ---------------------------------------------------------------- the slope between two tests


def test_what_a_fresh_test_has_of_its_own() -> None:
    """Over 1 m: temperature 11.5 · 0.5 µm, cosine error 0.289 · 2² µm, set-up 0.6 µm, k = 2."""
    assert slope_between_tests(FLAT, THETA, STEEL) == pytest.approx(11.5 * 0.5 / 2 * PPM)
    beam = UncertaintyBudget(misalignment_mm=2.0)
    assert slope_between_tests(FLAT, beam, STEEL) == pytest.approx(0.2887 * 4 / 2 * PPM, rel=1e-3)
    every = UncertaintyBudget(misalignment_mm=2.0, setup=0.6, U_theta=0.5)
    assert slope_between_tests(FLAT, every, STEEL) == pytest.approx(
        hypot(5.75, 1.1547, 0.6) / 2 * PPM, rel=1e-4
    )


def test_the_temperature_of_an_instrument_counts_where_it_expands() -> None:
    """Coefficient known to 1.2 µm/(m K), instrument 3 K warmer than at the first test."""
    alpha, warmer = UncertaintyBudget(U_alpha=1.2), replace(STEEL, T_d=23.0)
    air, glass = (
        slope_between_tests(replace(FLAT, thermal=replace(warmer, alpha_d=expands)), alpha, STEEL)
        for expands in (0.0, 8.0)
    )
    assert air == 0.0
    assert glass == pytest.approx(3.0 * 1.2 / 2 * PPM)


def test_what_two_tests_have_in_common_makes_no_slope_between_them() -> None:
    """The same instrument, the same coefficient: an error of it counts over 3 K of difference."""
    assert slope_between_tests(FLAT, UncertaintyBudget(device=3.0, device_per_m=2.0), STEEL) == 0.0
    assert slope_between_tests(FLAT, UncertaintyBudget(E_VE=3.0), STEEL) == 0.0
    alpha = UncertaintyBudget(U_alpha=1.2)
    assert slope_between_tests(FLAT, alpha, STEEL) == 0.0
    colder = replace(STEEL, T_m=21.0)
    assert slope_between_tests(FLAT, alpha, colder) == pytest.approx(3.0 * 1.2 / 2 * PPM)


def test_angles_and_undeclared_tests_have_no_slope_of_their_own() -> None:
    assert slope_between_tests(replace(FLAT, kind=AxisKind.ROTARY), THETA, None) == 0.0
    assert slope_between_tests(FLAT, None, STEEL) == 0.0


def test_the_declared_slope_is_in_the_band_or_in_the_guard_never_in_both() -> None:
    tests = [PlannedTest(test=FLAT, measured_in="as_found")] * 2
    own = 2.875 * PPM
    simple, guarded = (
        job_of(axis_of(), uncertainty=THETA, decision_rule=rule) for rule in ("simple", "guarded")
    )
    assert [test.slope_std for test in with_temperature_slopes(simple, tests)] == pytest.approx(
        [own, own]
    )
    # beside the first, on which the table stands, another test lies by both temperatures
    beside = own * 2**0.5
    assert [test.slope_std for test in with_temperature_slopes(guarded, tests)] == pytest.approx(
        [0.0, beside]
    )
    assert [fresh_slope("guarded", test) for test in with_temperature_slopes(guarded, tests)] == [
        0.0,
        0.0,
    ]
    # a test after loading is judged against the first one, whatever the rule
    assert slope_after(simple, tests, FLAT) == pytest.approx(beside)
    assert slope_after(guarded, tests, FLAT) == pytest.approx(beside)


def predicted(job: Job) -> AxisPrediction:
    rng = np.random.default_rng(2)
    blocks = [0.3 * UM * rng.standard_normal((11, 5)) for _ in range(2)]
    test = readings_of(*blocks, thermal=STEEL)
    planned = PlannedTest(test=test, measured_in="as_found")
    entry = next(iter(job.axes.values()))
    work = start_axis(
        job, entry, (planned,), {"as_found": ControlState(format="any", axes={})}, no_correction
    )
    return predict_axis(work, no_correction, None, job)


def test_the_band_holds_what_two_temperatures_make_of_a_flat_axis() -> None:
    """M of a straight line over 1 m is abs(slope) · 1 m, and the slope between two tests scatters
    by √2 · 2.875 µm/m: 95 % lie below 1.96 of that, half below 0.67.
    """
    axis = axis_of()
    M = predicted(job_of(axis, uncertainty=THETA)).tests[0].predicted["M"]
    between = 2**0.5 * 2.875 * UM
    assert M.p95 == pytest.approx(1.96 * between, rel=0.1)
    assert M.median == pytest.approx(0.674 * between, rel=0.15)


def test_a_guarded_prediction_has_the_band_of_a_job_that_declares_nothing() -> None:
    """What the guard holds is not in the band, to the last digit."""
    plain = predicted(job_of(axis_of()))
    guarded = predicted(job_of(axis_of(), uncertainty=THETA, decision_rule="guarded"))
    assert guarded.tests[0].predicted == plain.tests[0].predicted
    stated = guarded.tests[0].before.uncertainty
    assert stated is not None
    assert 5.2 < stated["E"].U / UM < 6.2


# ---------------------------------------------------------------- whose temperatures count

JOB = """compwright: 1
controller: {format: siemens-840d-sl}
thermal: {alpha_m: 11.5, T_m: 20.5, x_fix: 100}
axes:
  X: {travel: [0, 1000], before: [x.csv, {files: warm.csv, thermal: {T_m: [23, 25]}}]}
  Y: {travel: [0, 1000], before: y.csv, thermal: {alpha_m: 8, T_m: 21}}
  C: {kind: rotary, travel: [0, 360], before: c.csv}
"""


def of_job(text: str) -> Job:
    return read_job(text.encode(), "job.yaml")


def test_a_test_goes_over_its_axis_and_its_axis_over_the_job() -> None:
    axes = of_job(JOB).axes
    job = Thermal(alpha_m=11.5, T_m=20.5, x_fix=100.0)
    assert axes["X"].thermal == axes["X"].before[0].thermal == job
    assert axes["X"].before[1].thermal == replace(job, T_m=24.0, rise_m=2.0)
    assert axes["Y"].before[0].thermal == replace(job, alpha_m=8.0, T_m=21.0)
    assert (axes["C"].thermal, axes["C"].before[0].thermal) == (None, None)


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        ("X: {travel: [0, 9], before: x.csv, thermal: {T_m: 21}}", "thermal.alpha_m", "is missing"),
        ("X: {travel: [0, 9], before: {files: x.csv, thermal: {alpha_m: 8}}}", "T_m", "is missing"),
        (
            "X: {travel: [0, 9], before: x.csv, thermal: {alpha_m: 8, T_m: [1, 2, 3]}}",
            "T_m",
            "long",
        ),
        ("X: {travel: [0, 9], before: x.csv, thermal: {alpha_m: 8, T_m: warm}}", "T_m", "number"),
        (
            "X: {kind: rotary, travel: [0, 9], before: x.csv, thermal: {alpha_m: 8, T_m: 21}}",
            "axes.X.thermal",
            "belongs to a linear axis",
        ),
    ],
)
def test_faults_of_thermal_keys(text: str, place: str, message: str) -> None:
    with pytest.raises(UsageError) as caught:
        of_job(f"compwright: 1\ncontroller: {{format: siemens-840d-sl}}\naxes:\n  {text}\n")
    assert any(place in f.place and message in f.message for f in caught.value.faults)


def csv(folder: Path, name: str, head: str = "", slope: float = 0.0) -> None:
    rng = np.random.default_rng(len(name))
    rows = "".join(
        f"{x:g},{','.join(f'{slope * (x - 100.0) + 0.1 * rng.standard_normal():.4f}' for _ in range(4))}\n"
        for x in TARGETS
    )
    (folder / name).write_text(f"# axis: X\n# unit: um\n{head}target_mm,+1,-1,+2,-2\n{rows}")


def test_the_files_own_temperature_is_taken_out(tmp_path: Path) -> None:
    """A steel axis at 24 °C reads 46 µm/m about its fixed point at 100 mm."""
    csv(tmp_path, "x.csv", "# t_m start: 23,5\n# T-M_END: 24.5 °C\n", slope=0.046)
    entry = of_job(JOB).axes["X"]
    test = read_test(Session(), entry, entry.before[0], tmp_path)
    assert np.ptp(test.positive.mean(axis=1)) < 0.5 * UM
    assert test.thermal == replace(STEEL, x_fix=100.0, rise_m=1.0)
    found = {finding.code: finding.message for finding in test.findings}
    # 1 K over 1 m of steel
    assert "+11.50 µm" in found["CW-T025"]


def test_the_keys_of_a_test_go_over_those_of_its_file(tmp_path: Path) -> None:
    csv(tmp_path, "warm.csv", "# T_m: 30\n")
    entry = of_job(JOB).axes["X"]
    thermal = read_test(Session(), entry, entry.before[1], tmp_path).thermal
    assert thermal is not None
    assert (thermal.T_m, thermal.rise_m) == (24.0, 2.0)


@pytest.mark.parametrize(
    ("header", "place", "found"),
    [
        ({"T_m": "warm"}, "key T_m", "warm"),
        ({"T_m": "71.6"}, "key T_m", "71.6"),
        ({"T_d": "293.2"}, "key T_d", "293.2"),
        ({"T_m_start": "20.4"}, "key T_m", "T_m_start"),
        ({"T_m": "20", "T_m_start": "20", "T_m_end": "21"}, "key T_m", "T_m, T_m_start, T_m_end"),
    ],
)
def test_a_temperature_that_is_none_is_a_fault(
    header: dict[str, str], place: str, found: str
) -> None:
    with pytest.raises(InputError) as caught:
        stated_temperatures(header, "x.csv")
    (fault,) = caught.value.faults
    assert (fault.file, fault.place, fault.found) == ("x.csv", place, found)


def test_temperatures_of_the_header() -> None:
    header = {"T m": "22,4", "T_d_start": "20", "T_d_end": "20.8", "instrument": "laser"}
    stated = stated_temperatures(header, "x.csv")
    assert stated == {"T_m": (22.4, 22.4), "T_d": (20.0, 20.8)}
    thermal = with_temperatures(Thermal(alpha_m=8.0, T_m=20.0), stated)
    assert (thermal.T_m, thermal.rise_m) == (22.4, 0.0)
    assert [thermal.T_d, thermal.rise_d] == pytest.approx([20.4, 0.8])


def test_the_instruments_drift_counts_against_that_of_the_machine() -> None:
    """2 K of both over 1 m: 2 · (11.5 - 8) µm."""
    both = replace(STEEL, alpha_d=8.0, rise_m=2.0, rise_d=2.0)
    told = remove_differential_expansion(replace(FLAT, thermal=None), both).findings[-1]
    assert told.code == "CW-T025"
    assert "+7.00 µm" in told.message


# ---------------------------------------------------------------- after loading


def planned(folder: Path, job: Job) -> Plan:
    """A plan of the axis X of ``job``, as far as the tests after loading ask it."""
    entry = job.axes["X"]
    tests = [
        PlannedTest(test=read_test(Session(), entry, request, folder), measured_in="as_found")
        for request in entry.before
    ]
    return cast("Plan", SimpleNamespace(axes={"X": SimpleNamespace(tests=tests)}))


def test_the_test_after_loading_states_its_own_temperature(tmp_path: Path) -> None:
    for name, head in (("x.csv", "# T_m: 22\n"), ("warm.csv", ""), ("after.csv", "# T_m: 19\n")):
        csv(tmp_path, name, head)
    job = of_job(JOB)
    (after,) = after_tests(Session(), job, planned(tmp_path, job), [f"x={tmp_path / 'after.csv'}"])
    assert after.test.thermal is not None
    assert after.test.thermal.T_m == 19.0
    (after,) = after_tests(
        Session(), job, planned(tmp_path, job), [f"warm={tmp_path / 'after.csv'}"]
    )
    assert after.test.thermal is not None
    assert (after.test.thermal.T_m, after.test.thermal.rise_m) == (19.0, 0.0)


@pytest.mark.parametrize("name", ["x", "warm"])
def test_a_test_after_loading_without_the_temperature_of_the_first_is_refused(
    tmp_path: Path, name: str
) -> None:
    """The first was taken at a temperature of its own: the job's would be a guess of 11.5 µm/m for
    each kelvin.
    """
    for file, head in (("x.csv", "# T_m: 22\n"), ("warm.csv", ""), ("after.csv", "")):
        csv(tmp_path, file, head)
    job = of_job(JOB)
    with pytest.raises(InputError, match="states no temperature"):
        after_tests(Session(), job, planned(tmp_path, job), [f"{name}={tmp_path / 'after.csv'}"])


def test_the_instruments_own_temperature_is_asked_for_where_it_expands(tmp_path: Path) -> None:
    for file, head in (("x.csv", ""), ("warm.csv", ""), ("after.csv", "# T_m: 24\n")):
        csv(tmp_path, file, head)
    text = JOB.replace("T_m: [23, 25]", "T_m: [23, 25], T_d: 22")
    job = of_job(text)
    (after,) = after_tests(
        Session(), job, planned(tmp_path, job), [f"warm={tmp_path / 'after.csv'}"]
    )
    assert after.test.thermal is not None
    assert after.test.thermal.T_m == 24.0
    job = of_job(text.replace("T_d: 22", "T_d: 22, alpha_d: 8"))
    with pytest.raises(InputError, match="key T_d"):
        after_tests(Session(), job, planned(tmp_path, job), [f"warm={tmp_path / 'after.csv'}"])


def test_one_temperature_of_the_axis_for_all_tests_needs_no_header(tmp_path: Path) -> None:
    for file in ("x.csv", "warm.csv", "after.csv"):
        csv(tmp_path, file)
    job = of_job(JOB)
    (after,) = after_tests(Session(), job, planned(tmp_path, job), [f"x={tmp_path / 'after.csv'}"])
    assert after.test.thermal == job.axes["X"].thermal
