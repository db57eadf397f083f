"""Readings of a laser reduced by a record of air and material (job key ``environment``): physics in,
the machine's own error out.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

TARGETS = np.arange(0.0, 1001.0, 100.0)
#: The machine's own error, µm, at the targets.
TRUTH = 3.0 * np.sin(TARGETS / 160.0)
#: Two moments whose refractive index is printed (NIST, check values of Ciddor's equation, 633 nm):
#: 20 °C, dry, 1013.25 hPa and 20 °C, 100 %, 1000 hPa.
DRY, HUMID = 1.000271800, 1.000267394
#: Dry air at 20 °C and 1013.25 hPa, for which the display counts.
DISPLAY = "{air_c: 20, pressure_hpa: 1013.25, humidity_percent: 0}"
RECORD = (
    "time,air_c,pressure_hpa,humidity_percent,material_c\n"
    "2026-11-24T08:00:00,20,1013.25,0,20.0\n"
    "2026-11-24T08:00:01,20,1013.25,0,20.0\n"
    "2026-11-24T09:00:00,20,1000,100,22.0\n"
    "2026-11-24T09:00:01,20,1000,100,22.0\n"
)


def readings(*, alpha: float = 0.0, time: bool = True, header: str = "", zero: float = 0.0) -> str:
    """Return what the laser shows: run 1 in dry air at 20 °C, run 2 in humid air with the scale at
    22 °C; ``alpha``: expansion of the scale, µm/(m K).
    """
    lines = ["# axis: X", *([f"# compensated_for: {header}"] if header else [])]
    lines.append("target_mm,direction,run,deviation_um" + (",time" if time else ""))
    for run, (index, clock, material) in enumerate(
        ((DRY, "2026-11-24T08:00:01", 20.0), (HUMID, "2026-11-24T09:00:00", 22.0)), start=1
    ):
        for target, error in zip(TARGETS, TRUTH, strict=True):
            length = target + 1e-3 * error + 1e-6 * alpha * (material - 20.0) * target
            shown = zero + (length - zero) * index / DRY
            for direction in "+-":
                row = f"{target:g},{direction},{run},{1000.0 * (shown - target):.6f}"
                lines.append(row + (f",{clock}" if time else ""))
    return "\n".join(lines) + "\n"


def evaluated(folder: Path, test: str, environment: str, more: str = "") -> dict[str, Any]:
    (folder / "x.csv").write_text(test, encoding="utf-8")
    (folder / "hall.csv").write_text(RECORD, encoding="utf-8")
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\n"
        f"environment: {environment}\n{more}"
        "axes: {X: {travel: [0, 1000], address: 0, before: [x.csv]}}\n",
        encoding="utf-8",
    )
    compwright(["run", str(folder / "job.yaml"), "--out", str(folder / "out")])
    found: dict[str, Any] = json.loads((folder / "out" / "evaluation.json").read_text("utf-8"))
    result: dict[str, Any] = found["results"][0]
    return result


def deviations(result: dict[str, Any]) -> np.ndarray:
    return np.array([target["deviations_positive"] for target in result["targets"]])


def codes(result: dict[str, Any]) -> set[str]:
    return {finding["code"] for finding in result["findings"]}


def test_light_is_taken_out_reading_by_reading(tmp_path: Path) -> None:
    result = evaluated(tmp_path, readings(), f"{{files: hall.csv, instrument_air: {DISPLAY}}}")
    # 4.4 µm/m between the runs; two printed indices, known to 1e-9 each, over 1 m: 2 nm
    assert np.ptp(np.diff(readings_of(readings()), axis=1)) > 4.0
    assert deviations(result) == pytest.approx(np.stack([TRUTH, TRUTH], axis=1), abs=0.0025)
    raw = np.array([target["removed_positive"] for target in result["targets"]])
    assert deviations(result) + raw == pytest.approx(readings_of(readings()), abs=1e-5)
    [light] = [one for one in result["findings"] if one["code"] == "CW-T028"]
    assert light["severity"] == "info"


def readings_of(text: str) -> np.ndarray:
    rows = [line.split(",") for line in text.splitlines() if line[0].isdigit()]
    plus = [float(row[3]) for row in rows if row[1] == "+"]
    return np.array(plus).reshape(2, -1).T


def test_expansion_at_the_moment_of_each_reading(tmp_path: Path) -> None:
    result = evaluated(
        tmp_path,
        readings(alpha=11.5),
        f"{{files: [hall.csv], instrument_air: {DISPLAY}}}",
        "thermal: {alpha_m: 11.5}\n",
    )
    assert deviations(result) == pytest.approx(np.stack([TRUTH, TRUTH], axis=1), abs=0.003)
    assert result["thermal"]["T_m"] == pytest.approx(21.0)
    [change] = [one for one in result["findings"] if one["code"] == "CW-T029"]
    # over 1 m: 23 µm of expansion, -4.4 µm of light, nothing left
    assert change["values"]["expansion"] == pytest.approx(23.0, rel=1e-3)
    assert change["values"]["light"] == pytest.approx(-4.405, abs=0.005)
    assert change["values"]["rest"] == pytest.approx(0.0, abs=0.003)


def test_a_temperature_of_the_material_that_the_job_does_not_use_is_named(tmp_path: Path) -> None:
    environment = f"{{files: hall.csv, instrument_air: {DISPLAY}}}"
    result = evaluated(tmp_path, readings(alpha=11.5), environment)
    [change] = [one for one in result["findings"] if one["code"] == "CW-T029"]
    # the expansion of 23 µm/m from 0 to 1 m is left, on average half of it
    assert change["values"]["rest"] == pytest.approx(11.5, rel=0.25)
    assert "Both were removed" not in change["message"]
    assert "add `thermal` with `alpha_m`" in change["message"]


def test_display_that_counts_in_vacuum(tmp_path: Path) -> None:
    """A display in wavelengths of vacuum is 272 µm/m too long in air."""
    moved = []
    for line in readings().splitlines():
        if not line[0].isdigit():
            moved.append(line)
            continue
        target, direction, run, value, clock = line.split(",")
        shown = (float(target) + 1e-3 * float(value)) * DRY
        deviation = 1000.0 * (shown - float(target))
        moved.append(f"{target},{direction},{run},{deviation:.6f},{clock}")
    result = evaluated(
        tmp_path, "\n".join(moved) + "\n", "{files: hall.csv, instrument_air: vacuum}"
    )
    assert deviations(result) == pytest.approx(np.stack([TRUTH, TRUTH], axis=1), abs=0.0025)


def test_an_assumed_display_is_named(tmp_path: Path) -> None:
    [light] = [
        one
        for one in evaluated(tmp_path, readings(), "hall.csv")["findings"]
        if one["code"] == "CW-T028"
    ]
    assert light["severity"] == "warning"
    assert light["values"]["assumed"] is True


def test_readings_without_times_take_the_mean(tmp_path: Path) -> None:
    result = evaluated(
        tmp_path, readings(time=False), f"{{files: hall.csv, instrument_air: {DISPLAY}}}"
    )
    assert "CW-T039" in codes(result)
    mean = deviations(result).mean(axis=1)
    assert mean == pytest.approx(TRUTH, abs=0.01)


@pytest.mark.parametrize("stated", ["air", "laser wavelength", "air temperature, pressure"])
def test_refused_where_the_instrument_did_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], stated: str
) -> None:
    code = refused(tmp_path, readings(header=stated), RECORD)
    assert code == 3
    assert "already compensated for the air" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("record", "expected"),
    [
        (
            RECORD.replace("2026-11-24T09", "2026-11-24T08:3").replace(":3:00:0", ":30:0"),
            "does not cover",
        ),
        (RECORD.replace("2026-11-24T0", "0"), "writes times differently"),
        (RECORD.replace("1013.25", "101325"), "pressure_hpa"),
        (RECORD.replace("1013.25", "101.325"), "pressure_hpa"),
        (
            RECORD.replace("material_c", "steel").replace("air_c", "a"),
            "not a record of the environm",
        ),
        (RECORD.replace("09:00:01", "09:00:00"), "given twice"),
        (RECORD.replace("22.0", "71.6"), "material_c"),
        (RECORD.replace("2026-11-24T08:00:00", "early"), "is not a time"),
        (RECORD.replace(",100,", ",0.55,"), "humidity_percent"),  # a fraction
        ("", "is empty"),
        ("# hall\n", "contains no rows"),
        (RECORD.partition("\n")[0] + "\n", "contains no rows"),
        (RECORD.replace("material_c", "materal_c"), "rename it to `material_c`"),
        (RECORD.replace("material_c", "Material temp"), "rename it to `material_c`"),
        (RECORD.replace("air_c,pressure_hpa", "air_temp,preasure"), "rename it to `pressure_hpa`"),
        (RECORD.replace("time", "Timestamp"), "rename it to `time`"),
    ],
)
def test_records_that_cannot_be_used(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], record: str, expected: str
) -> None:
    assert refused(tmp_path, readings(), record) == 3
    shown = capsys.readouterr().err
    assert expected in shown
    assert "Next:" in shown


def test_other_columns_of_a_logger_are_left_alone(tmp_path: Path) -> None:
    head, *rows = RECORD.splitlines()
    lines = [
        f"{head},dew_point_c,co2_ppm,oil_c,hall_c,material_2",
        *(f"{row},9,4,3,1,2" for row in rows),
    ]
    assert refused(tmp_path, readings(), "\n".join(lines)) == 2  # no state is given


def test_columns_like_those_of_the_air_are_left_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A record of the material alone, in a logger that has more channels."""
    names = RECORD.partition("\n")[0].split(",")
    kept = [names.index(name) for name in ("time", "material_c")]
    lines = [
        ",".join(line.split(",")[place] for place in kept) + more
        for line, more in zip(
            RECORD.splitlines(),
            (",oil_pressure,airflow_m_s,air_humidity,serial", *([",4,1,40,7"] * 99)),
            strict=False,
        )
    ]
    assert refused(tmp_path, readings(), "\n".join(lines)) == 3
    assert "only the temperature of the material" in capsys.readouterr().err  # it was read


def test_a_record_in_the_place_of_a_test(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "hall.csv").write_text(RECORD, encoding="utf-8")
    assert compwright(["evaluate", str(tmp_path / "hall.csv")]) == 3
    assert "a record of the environment, not a positioning test" in capsys.readouterr().err


def refused(folder: Path, test: str, record: str) -> int:
    (folder / "x.csv").write_text(test, encoding="utf-8")
    (folder / "hall.csv").write_text(record, encoding="utf-8")
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nenvironment: hall.csv\n"
        "axes: {X: {travel: [0, 1000], address: 0, before: [x.csv]}}\n",
        encoding="utf-8",
    )
    return compwright(["run", str(folder / "job.yaml"), "--out", str(folder / "out")])


@pytest.mark.parametrize(
    ("thermal", "record", "code", "expected"),
    [
        ("thermal: {alpha_m: 11.5}\n", None, 2, "T_m"),
        ("thermal: {alpha_m: 11.5}\n", "time,air_c,pressure_hpa,humidity_percent\n0,20,1013,50\n",
         3, "T_m"),
        ("thermal: {alpha_m: 11.5}\n", "time,material_c\n0,20\n1,20\n", 3,
         "writes times differently"),
    ],
)  # fmt: skip
def test_temperatures_that_nothing_states(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    thermal: str,
    record: str | None,
    code: int,
    expected: str,
) -> None:
    (tmp_path / "x.csv").write_text(readings(), encoding="utf-8")
    if record is not None:
        (tmp_path / "hall.csv").write_text(record, encoding="utf-8")
    environment = "" if record is None else "environment: hall.csv\n"
    (tmp_path / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: linuxcnc}}\n{environment}{thermal}"
        "axes: {X: {travel: [0, 1000], address: 0, before: [x.csv]}}\n",
        encoding="utf-8",
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == code
    assert expected in capsys.readouterr().err


def test_after_loading_the_times_decide(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A test after loading is reduced by the record of its own hours, and never by the mean."""
    (tmp_path / "x.csv").write_text(readings(), encoding="utf-8")
    (tmp_path / "hall.csv").write_text(RECORD, encoding="utf-8")
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\n"
        f"environment: {{files: hall.csv, instrument_air: {DISPLAY}}}\n"
        "axes: {X: {travel: [0, 1000], address: 0, before: [x.csv]}}\n",
        encoding="utf-8",
    )
    compwright(["run", str(tmp_path / "job.yaml")])
    capsys.readouterr()
    after = tmp_path / "after.csv"
    for text, expected in (
        (readings(time=False), "a column `time`"),
        (readings().replace("2026-11-24", "2026-11-25"), "does not cover"),
    ):
        after.write_text(text, encoding="utf-8")
        assert compwright(["verify", str(tmp_path / "job.yaml"), "--after", f"x={after}"]) == 3
        assert expected in capsys.readouterr().err
    later = RECORD.replace("2026-11-24", "2026-11-25")
    (tmp_path / "later.csv").write_text(later, encoding="utf-8")
    job = tmp_path / "job.yaml"
    job.write_text(
        job.read_text("utf-8").replace("files: hall.csv", "files: [hall.csv, later.csv]")
    )
    compwright(["verify", str(job), "--after", f"x={after}"])
    found = json.loads((tmp_path / "job" / "verification.json").read_text("utf-8"))
    axis = found["axes"]["X"]
    # the same axis at other hours: the light is taken out of both
    assert axis["after"]["B"] == pytest.approx(axis["before"]["B"], abs=0.01)
    assert axis["after"]["E"] == pytest.approx(axis["before"]["E"], abs=0.01)


@pytest.mark.parametrize("stated", ["air and material", "XC-80", "yes", "Luft", "weather station"])
def test_a_compensation_that_is_not_understood_counts_for_the_air(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], stated: str
) -> None:
    assert refused(tmp_path, readings(header=stated), RECORD) == 3
    assert "already compensated for the air" in capsys.readouterr().err


def test_material_compensation_leaves_the_air(tmp_path: Path) -> None:
    result = evaluated(
        tmp_path,
        readings(header="material expansion"),
        f"{{files: hall.csv, instrument_air: {DISPLAY}}}",
    )
    assert deviations(result) == pytest.approx(np.stack([TRUTH, TRUTH], axis=1), abs=0.0025)


@pytest.mark.parametrize(
    ("test", "record", "expected"),
    [
        (readings().replace("2026-11-24T09:00:00", "9 o'clock", 1), RECORD, "have no time"),
        (readings(), "time,material_c\n2026-11-24T08:00:00,20\n2026-11-24T09:10:00,20\n",
         "nothing would be removed"),
        (readings(), "time,material_c\n23:50:00,20\n00:10:00,20\n", "go backwards"),
    ],
)  # fmt: skip
def test_times_and_records_that_would_mislead(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], test: str, record: str, expected: str
) -> None:
    assert refused(tmp_path, test, record) == 3
    assert expected in capsys.readouterr().err
