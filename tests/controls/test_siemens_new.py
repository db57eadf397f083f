"""A job prefilled from an archive of which one axis cannot be read: the others are prefilled all
the same, and the odd one is named.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from sinumerik_archive import cec_lines

pytestmark = pytest.mark.short_estimate

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


CEC = "$MA_CEC_ENABLE[AX1]=1\n$SN_CEC_TABLE_ENABLE[3]=1\n$SN_CEC_TABLE_ENABLE[4]=1\n"
OWN = cec_lines(3, "AX1", "AX1", 0, 200, [0.01, -0.02, 0.03])
FACTOR = cec_lines(4, "AX1", "AX1", 0, 200, [0.5, 1.0, -0.7])
#: What no reading of a test can follow, and no job changes: it is the same before and after.
STAYS = {
    "a product": OWN.replace("MULT_BY_TABLE[3]=0", "MULT_BY_TABLE[3]=5") + FACTOR,
    "a product over another axis": (OWN + FACTOR)
    .replace("INPUT_AXIS[3]=(AX1)", "INPUT_AXIS[3]=(AX2)")
    .replace("MULT_BY_TABLE[3]=0", "MULT_BY_TABLE[3]=5"),
    "a step that does not divide": OWN.replace("_STEP[3]=200", "_STEP[3]=150"),
    "a value added to a point": OWN + "$SN_CEC_0[3]=0.004\n",
    "a sum that is cut off": OWN + "$MA_CEC_MAX_SUM[AX1]=0.005\n",
    "inches": OWN + "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=0\n",
}


@pytest.mark.parametrize("beside", ["a table of its own", "nothing else"])
@pytest.mark.parametrize("what", STAYS)
def test_an_axis_is_drafted_beside_tables_that_stay(
    what: str, beside: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`run` works on such an axis, so `new` holds it."""
    own = GOOD if beside == "a table of its own" else ""
    code, job = job_of(own + CEC + STAYS[what], tmp_path)
    told = capsys.readouterr()
    assert code == 0, told.err
    assert "address: AX1" in job.read_text()
    assert "left out" not in told.out + told.err


def test_an_axis_is_drafted_beside_tables_that_stay_and_an_odd_neighbour(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The neighbour cannot be read, so that each axis is read by itself."""
    odd = table("AX2", "150", ["0", "0.001", "0.002", "0.003"])
    code, job = job_of(GOOD + odd + CEC + STAYS["a product"], tmp_path)
    assert code == 0
    assert "address: AX1" in job.read_text()
    assert "AX2" not in job.read_text()
    assert "axis AX2 is left out" in capsys.readouterr().err


@pytest.mark.parametrize("what", [name for name in STAYS if name != "inches"])
def test_an_axis_whose_tables_would_be_written_is_left_out(
    what: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A job with these ``cec_tables`` is refused."""
    (tmp_path / "AX_EEC.INI").write_text(f"{NAMES}{GOOD}{CEC}{STAYS[what]}M17\n")
    arguments = ["new", "--from", str(tmp_path / "AX_EEC.INI"), "--format", "siemens-840d-sl"]
    options = ["--option", "cec_tables=3,4", "--option", "cec=available"]
    code = compwright([*arguments, *options, "--out", str(tmp_path / "job.yaml")])
    assert code == 3
    assert "CEC" in capsys.readouterr().err
