"""A job prefilled from an archive of which one axis cannot be read: the others are prefilled all
the same, and the odd one is named.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.brief

NAMES = '$MN_AXCONF_MACHAX_NAME_TAB[0]="X1"\n$MN_AXCONF_MACHAX_NAME_TAB[1]="Y1"\n'


def table(axis: str, step: str, values: list[str], *, modulo: int = 0) -> str:
    rows = "".join(f"$AA_ENC_COMP[0,{n},{axis}]={value}\n" for n, value in enumerate(values))
    return (
        f"{rows}$AA_ENC_COMP_STEP[0,{axis}]={step}\n$AA_ENC_COMP_MIN[0,{axis}]=0\n"
        f"$AA_ENC_COMP_MAX[0,{axis}]=400\n$AA_ENC_COMP_IS_MODULO[0,{axis}]={modulo}\n"
        f"$MA_ENC_COMP_ENABLE[0,{axis}]=1\n$MA_POS_LIMIT_MINUS[{axis}]=0\n"
        f"$MA_POS_LIMIT_PLUS[{axis}]=400\n"
    )


def job_of(texts: str, folder: Path) -> tuple[int, Path]:
    (folder / "AX_EEC.INI").write_text(f"{NAMES}{texts}M17\n")
    job = folder / "job.yaml"
    arguments = ["new", "--from", str(folder / "AX_EEC.INI"), "--format", "siemens-840d-sl"]
    return compwright([*arguments, "--out", str(job)]), job


GOOD = table("AX1", "100", ["0", "0.001", "0.002", "0.003", "0.004"])


@pytest.mark.parametrize("first", [True, False], ids=["the odd one first", "the odd one last"])
@pytest.mark.parametrize("step", ["150", "-100"], ids=["does not divide", "below zero"])
def test_an_odd_neighbour_stops_no_other_axis(
    step: str, first: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    odd = table("AX2", step, ["0", "0.001", "0.002", "0.003"])
    code, job = job_of(odd + GOOD if first else GOOD + odd, tmp_path)
    said = capsys.readouterr().err
    assert code == 0, said
    assert "address: AX1" in job.read_text()
    assert "travel: [0.0, 400.0]" in job.read_text()
    assert "AX2" not in job.read_text()
    assert "axis AX2 is left out" in said
    assert "AX_EEC.INI: line" in said


def test_files_of_odd_axes_alone_are_refused_by_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, job = job_of(table("AX2", "150", ["0", "0.001", "0.002", "0.003"]), tmp_path)
    assert code == 3
    assert not job.exists()
    assert "AX2" in capsys.readouterr().err


@pytest.mark.parametrize("on", ["0", "1"])
def test_the_turn_of_an_endless_axis_is_told_by_its_machine_data(on: str, tmp_path: Path) -> None:
    """MD30310 = 1: modulo, MD30330 its range; whether its table acts is another matter."""
    values = ["0", "0.001", "0.002", "0.001", "0"]
    texts = table("AX2", "100", values, modulo=1).replace("=400\n", "=360\n").replace("=100", "=90")
    texts = texts.replace("$MA_ENC_COMP_ENABLE[0,AX2]=1", f"$MA_ENC_COMP_ENABLE[0,AX2]={on}")
    data = "$MA_IS_ROT_AX[AX2]=1\n$MA_ROT_IS_MODULO[AX2]=1\n$MA_MODULO_RANGE[AX2]=360\n"
    code, job = job_of(texts + data, tmp_path)
    assert code == 0
    axis = job.read_text()
    assert "kind: rotary" in axis
    assert "travel: [0.0, 360.0]" in axis
    assert "modulo: 360.0" in axis
