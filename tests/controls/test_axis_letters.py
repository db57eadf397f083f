"""The axis that an address of the job names has another letter in the control's own files: never
taken in silence, on any control whose files name its axes.

ISG: `kopf.log_achs_name`, in any letters. FANUC: 1020 holds the ASCII code of the letter (real backup, `facts/real-backups.md`), U, V and W are
axes parallel to X, Y and Z. SINUMERIK: MD10000. PMAC: the definition `#1->1000X`.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()
FANUC = (
    "%\nN01001Q1P00000000\nN01006Q1A1P00000000A2P00000000\nN01013Q1A1P00000000A2P00000000\n"
    "N01020Q1A1P{}A2P89\nN01820Q1A1P2A2P2\nN01851Q1A1P0A2P0\nN03620Q1A1P10A2P110\n"
    "N03621Q1A1P10A2P110\nN03622Q1A1P26A2P126\nN03623Q1A1P0A2P0\nN03624Q1A1P50.0A2P50.0\n%\n"
)
SINUMERIK = (
    '$MN_AXCONF_MACHAX_NAME_TAB[0]="{}"\n$MN_AXCONF_MACHAX_NAME_TAB[1]="Y1"\n'
    "$MA_BACKLASH[0,AX1]=0\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n"
    "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=100\nM17\n"
)
PMAC = "#1->1000{}\n#1 DEFINE COMP 20,1000000\n" + "0 " * 20 + "\nI51=1\nI185=0\nI186=0\n"
ISG = (
    "kopf.achs_nr 1\nkopf.log_achs_name {}\nlr_param.ssfk 1\nkw.ssfk.unit 1\nkw.ssfk.interval 0\n"
    "kw.ssfk.kw_nr_max 2\nkw.ssfk.bilateral 1\nkw.ssfk.modulo 0\n"
    + "".join(
        f"kw.ssfk.table[{i}].setpoint {8000000 * i}\nkw.ssfk.table[{i}].pos 0\n"
        f"kw.ssfk.table[{i}].neg 0\n"
        for i in range(2)
    )
)
CONTROLS = {
    "fanuc-30i": (FANUC, "1", "{first_point: 10}", "85", "88", "U (1020 of 1)"),
    "siemens-840d-sl": (SINUMERIK, "AX1", "{}", "U1", "X1", "MD10000"),
    "isg-kernel": (ISG, "1", "{}", "u_rail", "x_ACHSE", "kopf.log_achs_name of 1"),
    "pmac": (PMAC, "1", "{counts_per_unit: 1000}", "U", "X", "#1->1000U"),
}


def run(folder: Path, control: str, letter: str, axis: str = "X") -> int:
    text, address, options, *_ = CONTROLS[control]
    targets = MACHINE.targets()
    readings = csv_of(targets, MACHINE.measure(targets, 1))
    (folder / "x.csv").write_text(readings.replace(": X", f": {axis}"))
    (folder / "state.txt").write_text(text.format(letter))
    state = "{files: [state.txt], active: no}" if control != "fanuc-30i" else "[state.txt]"
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {options}}}\n"
        f"states: {{as_found: {state}}}\n"
        f"axes:\n  {axis}: {{travel: [0, 800], address: {address}, before: [x.csv]}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


@pytest.mark.parametrize("control", CONTROLS)
def test_another_letter_is_refused_and_both_ways_on_work(
    tmp_path: Path, control: str, capsys: pytest.CaptureFixture[str]
) -> None:
    *_, other, own, named = CONTROLS[control]
    assert run(tmp_path, control, other) == 3
    text = " ".join(capsys.readouterr().err.split())
    assert "axes.X.address" in text
    assert named in text
    assert "name the axis U" in text  # isg-kernel: U_RAIL
    assert run(tmp_path, control, other, "U") == 0
    assert run(tmp_path, control, own) == 0


def test_a_job_with_a_name_of_its_own_asks_nothing(tmp_path: Path) -> None:
    assert run(tmp_path, "fanuc-30i", "88", "crossbeam") == 0
