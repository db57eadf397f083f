"""The unit of a decoded table when no file says whether its axis is linear or rotary: by the plan
above the files, by the option ``kind``, else null; never a guess.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

ADDRESS = {
    "siemens-840d-sl": "AX4",
    "linuxcnc": "3",
    "fanuc-30i": "4",
    "isg-kernel": "4",
    "pmac": "4",
    "heidenhain-itnc530": "B",
}
OPTIONS = {
    "fanuc-30i": "{detection_unit: 0.001, first_point: 0}",
    "pmac": "{counts_per_unit: 10000}",
}
#: What decode needs to read the files at all.
NEEDED = {"fanuc-30i": ["detection_unit=0.001"], "pmac": ["counts_per_unit=10000"]}
#: Controls whose axis letter says that it turns (DIN 66217).
NAMED = ("heidenhain-itnc530",)


def csv() -> str:
    """Twelve targets: an error of 20 arcsec with one wave per turn, no lost motion."""
    lines = ["# axis: B", "target_deg,direction,run,deviation_arcsec"]
    for target in np.arange(0.0, 360.0, 30.0):
        for run in range(1, 4):
            for sign in "+-":
                value = 20.0 * np.sin(np.radians(target)) + 0.3 * np.cos(7.0 * run + target)
                lines.append(f"{target:g},{sign},{run},{value:.3f}")
    return "\n".join(lines) + "\n"


def decoded(files: Path, control: str, *words: str) -> Any:
    out = files.parent / "decoded.json"
    paths = [str(path) for path in sorted(files.iterdir())]
    options = [word for name in (*words, *NEEDED.get(control, ())) for word in ("--option", name)]
    code = compwright(
        ["decode", *paths, "--format", control, *options, "--json", str(out), "--force"]
    )
    assert code == 0
    return json.loads(out.read_text(encoding="utf-8"))


@pytest.fixture(scope="module", params=list(ADDRESS))
def rotary(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """A run for a rotary axis from an empty control: format, its result folder, its tables."""
    control = request.param
    folder = tmp_path_factory.mktemp(control)
    (folder / "b.csv").write_text(csv())
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {OPTIONS.get(control, '{}')}}}\n"
        "states: {as_found: none}\naxes:\n"
        f'  B: {{kind: rotary, travel: [0, 330], address: "{ADDRESS[control]}", before: [b.csv]}}\n'
    )
    assert compwright(["run", str(folder / "job.yaml")]) in (0, 1)
    return control, folder / "job"


def tables(job: Path, control: str) -> Path:
    return job / "tables" / control


def expected(job: Path) -> Any:
    return json.loads((job / "prediction.json").read_text(encoding="utf-8"))["axes"]["B"]["table"]


def agrees(found: Any, job: Path) -> bool:
    known = expected(job)
    if not known["positions"]:
        return False
    at = np.array(known["positions"])
    curve = np.interp(at, found["positions"], found["correction_positive"])
    return bool(np.max(np.abs(curve - np.array(known["correction_positive"]))) < 0.5)


def test_the_plan_above_the_files_says_the_kind(rotary: Any) -> None:
    control, job = rotary
    found = decoded(tables(job, control), control)["axes"][ADDRESS[control]]
    assert found["unit"] == "arcsec"
    assert agrees(found, job)


def test_without_the_plan_the_unit_is_null_or_the_files_say_it(rotary: Any, tmp_path: Path) -> None:
    control, job = rotary
    shutil.copytree(tables(job, control), tmp_path / "files")
    document = decoded(tmp_path / "files", control)
    found = document["axes"][ADDRESS[control]]
    codes = [finding["code"] for finding in document["findings"]]
    if control in NAMED:
        assert (found["unit"], "CW-S086" in codes) == ("arcsec", False)
        return
    assert found["unit"] is None
    assert "CW-S086" in codes
    # thousandths of a degree
    in_arcsec = {**found, "correction_positive": np.array(found["correction_positive"]) * 3.6}
    assert agrees(in_arcsec, job)


def test_the_option_says_the_kind(rotary: Any, tmp_path: Path) -> None:
    control, job = rotary
    shutil.copytree(tables(job, control), tmp_path / "files")
    document = decoded(tmp_path / "files", control, "kind=rotary")
    found = document["axes"][ADDRESS[control]]
    assert found["unit"] == "arcsec"
    assert agrees(found, job)
    assert "CW-S086" not in [finding["code"] for finding in document["findings"]]


EEC = """\
CHANDATA(1)
$AA_ENC_COMP[0,0,AX1]=0.01
$AA_ENC_COMP[0,1,AX1]=0.02
$AA_ENC_COMP_STEP[0,AX1]=100
$AA_ENC_COMP_MIN[0,AX1]=0
$AA_ENC_COMP_MAX[0,AX1]=100
$AA_ENC_COMP_IS_MODULO[0,AX1]=0
M17
"""


def test_a_kind_that_decides_the_numbers_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """On an inch machine 0.01 of a linear axis is 254 µm, of a rotary one 36 arcsec."""
    (tmp_path / "AX1_EEC.INI").write_text(EEC)
    words = ["decode", str(tmp_path / "AX1_EEC.INI"), "--format", "siemens-840d-sl"]
    assert compwright([*words, "--option", "units=inch"]) == 2
    assert "linear or rotary" in capsys.readouterr().err
    assert compwright([*words, "--option", "units=inch", "--option", "kind=linear"]) == 0
    assert compwright([*words, "--option", "units=inch", "--option", "kind=rotary"]) == 0
    assert compwright([*words, "--option", "kind=round"]) == 2


def test_a_kind_that_the_files_contradict_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "AX1_EEC.INI").write_text(EEC)
    (tmp_path / "MD.INI").write_text("CHANDATA(1)\nN30300 $MA_IS_ROT_AX[AX1]=0\nM17\n")
    words = ["decode", str(tmp_path), "--format", "siemens-840d-sl", "--json", "-"]
    assert compwright(words) == 0
    assert json.loads(capsys.readouterr().out)["axes"]["AX1"]["unit"] == "um"
    assert compwright([*words, "--option", "kind=rotary"]) == 2
