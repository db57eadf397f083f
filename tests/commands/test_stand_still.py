"""E_VE from a stand-still test: its range, its text in the results, and its faults."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.evaluation.environmental_variation import environmental_variation
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.provenance import Source
from compwright.foundations.session import Session
from compwright.instruments.drift_csv import read_drift
from compwright.jobs.reading import read_job
from compwright.records.axis import AxisKind
from compwright.records.drift import DriftRequest, DriftTest
from compwright.workflow.inputs.jobs import read_job_file

pytestmark = pytest.mark.short_estimate

UM = 1e-3
JOB = """compwright: 1
controller: {{format: siemens-840d-sl}}
states: {{as_found: none}}
axes:
  X: {{travel: [0, 800], address: AX1, before: [x.csv], accept: {{A: 30}}}}
uncertainty: {{E_VE: {given}}}
"""


def series(minutes: object, values: object) -> DriftTest:
    """Readings in µm over minutes."""
    return DriftTest(
        kind=AxisKind.LINEAR,
        minutes=np.asarray(minutes, dtype=float),
        deviations=np.asarray(values, dtype=float) * UM,
        source=Source("drift.csv", ""),
    )


def codes(drift: DriftTest, duration: float | None) -> list[str]:
    return [finding.code for finding in environmental_variation(drift, duration)[1]]


def test_the_range_counts_over_the_time_of_a_positioning_test() -> None:
    """A ramp of 0.1 µm/min over an hour: 6 µm in all, 2 µm within 20 min."""
    minutes = np.arange(0.0, 60.5, 0.5)
    ramp = series(minutes, 0.1 * minutes)
    assert environmental_variation(ramp, None)[0] == pytest.approx(6.0)
    assert environmental_variation(ramp, 60.0)[0] == pytest.approx(6.0)
    assert environmental_variation(ramp, 20.0)[0] == pytest.approx(2.0)


def test_the_worst_window_counts_not_the_first() -> None:
    """A door that opens after 40 min: 3 µm within 10 min, nothing before."""
    minutes = np.arange(0.0, 61.0)
    door = series(minutes, np.clip(minutes - 40.0, 0.0, 10.0) * 0.3)
    assert environmental_variation(door, 10.0)[0] == pytest.approx(3.0)
    assert environmental_variation(door, 5.0)[0] == pytest.approx(1.5)


def test_what_is_said_of_a_series() -> None:
    long = series(np.arange(0.0, 31.0), np.zeros(31))
    assert codes(long, 30.0) == ["CW-T026"]
    assert codes(long, None) == ["CW-T026"]
    assert codes(long, 45.0) == ["CW-T026", "CW-T027"]
    # no positioning test is done in four minutes
    assert codes(series(np.arange(0.0, 4.1, 0.1), np.zeros(41)), None) == ["CW-T026", "CW-T027"]
    assert codes(series([0.0, 15.0, 30.0], np.zeros(3)), 30.0) == ["CW-T026", "CW-T027"]
    (told, short) = environmental_variation(long, 45.0)[1]
    assert "within any 30 min" in told.message
    assert "it lasts 30 min, but a positioning test of the job takes 45 min" in short.message


def test_a_file_in_any_order_with_decimal_commas() -> None:
    text = (
        "# axis: X\n# instrument: laser\ntime_min;deviation_um;air\n2;1,5;20\n0,5;-0,5;20\n0;0;20\n"
    )
    drift = read_drift(text.encode(), "drift.csv", AxisKind.LINEAR)
    assert drift.minutes.tolist() == [0.0, 0.5, 2.0]
    assert drift.deviations.tolist() == pytest.approx([0.0, -0.5 * UM, 1.5 * UM])
    turned = read_drift(
        ("# deviation: target minus measured\n" + text).encode(), "drift.csv", AxisKind.LINEAR
    )
    assert environmental_variation(turned, None)[0] == environmental_variation(drift, None)[0]


def test_angles_are_read_in_arcsec() -> None:
    text = "time_min,deviation_arcsec\n0,0\n5,1.8\n10,0.9\n"
    drift = read_drift(text.encode(), "drift.csv", AxisKind.ROTARY)
    assert environmental_variation(drift, None)[0] == pytest.approx(1.8)


@pytest.mark.parametrize(
    ("text", "message", "place"),
    [
        ("", "is empty", ""),
        ("# axis: X\n", "contains no readings", ""),
        (
            "target_mm,+1,-1\n0,1,2\n",
            "is not a stand-still test (axis at rest) of a linear axis",
            "line 1",
        ),
        (
            "time_min,deviation_arcsec\n0,1\n",
            "is not a stand-still test (axis at rest) of a linear",
            "line 1",
        ),
        ("time_min,deviation_um\n0,1\n1,none\n2,3\n", "is not a number", "line 3"),
        ("time_min,deviation_um\n0,1\n1,2\n1,3\n", "a time is given twice", ""),
        ("time_min,deviation_um\n0,1\n1,2\n", "has too few readings to show a drift", ""),
    ],
)
def test_faults_of_a_stand_still_test(text: str, message: str, place: str) -> None:
    with pytest.raises(InputError) as caught:
        read_drift(text.encode(), "drift.csv", AxisKind.LINEAR)
    assert any(message in f.message and place in f.place for f in caught.value.faults)
    assert {fault.file for fault in caught.value.faults} == {"drift.csv"}


# ---------------------------------------------------------------- in a job


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("drift.csv", DriftRequest(file="drift.csv")),
        ("{file: d/1.csv, duration_min: 25}", DriftRequest(file="d/1.csv", duration_min=25.0)),
    ],
)
def test_the_job_names_the_file(given: str, expected: DriftRequest) -> None:
    job = read_job(JOB.format(given=given).encode(), "job.yaml")
    assert job.drifts == {AxisKind.LINEAR: expected}


@pytest.mark.parametrize(
    ("given", "place", "words"),
    [
        ("'1,5'", "uncertainty.E_VE", "is text, not a number"),
        ("-1", "uncertainty.E_VE", "is too small"),
        ("{file: d.csv, duration: 3}", "uncertainty.E_VE.duration", "unknown key"),
        ("{duration_min: 3}", "uncertainty.E_VE.file", "is missing"),
        ("{file: d.csv, duration_min: 0}", "uncertainty.E_VE.duration_min", "is too small"),
    ],
)
def test_faults_of_the_key(given: str, place: str, words: str) -> None:
    with pytest.raises(UsageError) as caught:
        read_job(JOB.format(given=given).encode(), "job.yaml")
    assert any(place in f.place and words in f.message for f in caught.value.faults)


def test_a_job_takes_the_range_of_its_file(tmp_path: Path) -> None:
    (tmp_path / "drift.csv").write_text(
        "time_min,deviation_um\n" + "".join(f"{t},{0.1 * t:.1f}\n" for t in range(41))
    )
    path = tmp_path / "job.yaml"
    path.write_text(JOB.format(given="{file: drift.csv, duration_min: 20}"))
    job = read_job_file(Session(), path)
    assert job.uncertainty is not None
    assert round(job.uncertainty.E_VE, 9) == 2.0
    assert [finding.code for finding in job.findings] == ["CW-T026"]
    assert [Path(source.file).name for source in job.sources] == ["drift.csv"]


def test_a_missing_stand_still_test_is_input_that_cannot_be_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "job.yaml"
    path.write_text(JOB.format(given="drift.csv"))
    assert compwright(["run", str(path)]) == 3
    assert "drift.csv" in capsys.readouterr().err


def test_the_run_says_which_range_it_took_and_carries_the_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rng = np.random.default_rng(4)
    targets = np.linspace(10.0, 790.0, 9)
    rows = "".join(
        f"{x:g},{','.join(f'{0.02 * x + 0.3 * rng.standard_normal():.3f}' for _ in range(6))}\n"
        for x in targets
    )
    (tmp_path / "x.csv").write_text(f"# axis: X\n# unit: um\ntarget_mm,+1,-1,+2,-2,+3,-3\n{rows}")
    (tmp_path / "drift.csv").write_text("time_min,deviation_um\n0,0\n1,0.4\n2,1.2\n")
    (tmp_path / "job.yaml").write_text(JOB.format(given="drift.csv"))
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "E_VE is 1.20 µm: the range of the readings in drift.csv" in said
    assert "it lasts 2 min" in said
    plan, evaluation = (
        json.loads((tmp_path / "job" / f"{name}.json").read_text(encoding="utf-8"))
        for name in ("plan", "evaluation")
    )
    assert "drift.csv" in {Path(source["file"]).name for source in plan["sources"]}
    # the mean reversal is linear in the readings: U = E_VE/√3 · √(2/(n m))
    stated = evaluation["results"][0]["uncertainty"]["B_mean"]["U"]
    assert stated == pytest.approx(1.2 / 3**0.5 * (2 / (3 * 9)) ** 0.5, rel=0.05)


def test_evaluated_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A ramp of 0.05 µm/min over an hour has a range of 3 µm; a rotary axis counts in arcsec."""
    for name, column, axis in (("x", "deviation_um", "X"), ("b", "deviation_arcsec", "B")):
        rows = "".join(f"{minute},{0.05 * minute}\n" for minute in range(61))
        (tmp_path / f"{name}.csv").write_text(f"# axis: {axis}\ntime_min,{column}\n{rows}")
    files = [str(tmp_path / "x.csv"), str(tmp_path / "b.csv")]
    table = tmp_path / "t.csv"
    assert compwright(["evaluate", *files, "--json", "-", "--table", str(table)]) == 0
    results = json.loads(capsys.readouterr().out)["results"]
    assert [(one["kind"], one["axis"], one["unit"]) for one in results] == [
        ("environment", "X", "um"),
        ("environment", "B", "arcsec"),
    ]
    for one in results:
        assert one["parameters"] == {"E_VE": pytest.approx(3.0)}
        assert one["duration_min"] == 60.0
        assert one["readings"][-1] == {"time_min": 60.0, "deviation": pytest.approx(3.0)}
    assert "E_VE" in table.read_text(encoding="utf-8").splitlines()[0]
    assert compwright(["evaluate", *files]) == 0
    assert "3.00 arcsec" in capsys.readouterr().out
    for option in ("--plot", "--report"):
        made = tmp_path / ("p.svg" if option == "--plot" else "r.html")
        assert compwright(["evaluate", *files, option, str(made)]) == 2
        assert not made.exists()


def test_a_broken_stand_still_file_is_named_as_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "x.csv"
    file.write_text("time_min,deviation_um\n0,1\n0,2\n1,a\n")
    assert compwright(["evaluate", str(file)]) == 3
    shown = capsys.readouterr().err
    assert "is not a number" in shown
    assert "direction" not in shown
