"""SINUMERIK: a text export that holds the tables of several axes, one of them under work. The card is
followed on a control that keeps protected tables, whether it skips a protected line or stops there.
"""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

AXES = ("AX1", "AX2", "AX3")
VALUES = {"AX1": "-0.0073", "AX2": "0.0069", "AX3": "0.0027"}
EEC = "$AA_ENC_COMP"


def table(axis: str, sign: str = "=") -> str:
    grid = {"STEP": 100, "MIN": 0, "MAX": 700, "IS_MODULO": 0}
    rows = "".join(
        f"{EEC}[0,{n},{axis}]{sign}{VALUES[axis] if n % 3 == 1 else 0}\n" for n in range(8)
    )
    return rows + "".join(f"{EEC}_{key}[0,{axis}]={value}\n" for key, value in grid.items())


def machine_data(axes: tuple[str, ...] = AXES) -> str:
    return "CHANDATA(1)\n" + "".join(
        f"N30200 $MA_NUM_ENCS[{axis}]=1\nN32450 $MA_BACKLASH[0,{axis}]=0.001\n"
        f"N32700 $MA_ENC_COMP_ENABLE[0,{axis}]=1\n"
        for axis in axes
    )


CEC = "".join(
    f"$AN_CEC[4,{n}]=0.00{n}\n" for n in range(3)
) + (
    "$AN_CEC_INPUT_AXIS[4]=(AX2)\n$AN_CEC_OUTPUT_AXIS[4]=(AX3)\n$AN_CEC_STEP[4]=350\n"
    "$AN_CEC_MIN[4]=0\n$AN_CEC_MAX[4]=700\n$AN_CEC_DIRECTION[4]=0\n$AN_CEC_MULT_BY_TABLE[4]=0\n"
    "$AN_CEC_IS_MODULO[4]=0\n$SN_CEC_TABLE_ENABLE[4]=1\n"
)  # fmt: skip
ONE_FILE = {"INITIAL.INI": machine_data() + "".join(map(table, AXES)) + "M17\n"}
TWO_FILES = {
    "AX_EEC.INI": "CHANDATA(1)\n" + "".join(map(table, AXES)) + "M17\n",
    "MD.INI": machine_data() + "M17\n",
}
WITH_CEC = {
    "TABLES.INI": "CHANDATA(1)\n" + table("AX1") + CEC + "M17\n",
    "MD.INI": machine_data(("AX1",)) + "$MA_CEC_ENABLE[AX3]=1\nM17\n",
}
STATES = {"one file": ONE_FILE, "two files": TWO_FILES, "a cross-axis table": WITH_CEC}


SET = r"(\$MA_(?:ENC_COMP|CEC)_ENABLE\[[^\]]*\]) = (\d)"


class Control:
    """Registers as the manual says: a table that is on is protected (MD32700, MD32710, which take
    effect with NEW CONF). A line of a protected table is skipped, or the rest of its file with it.
    """

    def __init__(self, files: dict[str, str], *, stops: bool) -> None:
        self.stops = stops
        self.registers: dict[str, str] = {}
        for text in files.values():
            self.registers.update(self.statements(text))
        self.new_conf()

    def new_conf(self) -> None:
        self.active = dict(self.registers)

    @staticmethod
    def statements(text: str) -> list[tuple[str, str]]:
        found = re.findall(r"^(?:N\d+ )?(\$\w+\[[^\]]*\]) *=? *([^\s;]+)", text, re.MULTILINE)
        return [(name, value.strip("()")) for name, value in found]

    def protected(self, register: str) -> bool:
        if (eec := re.match(r"\$AA_ENC_COMP\w*\[(\d),(?:\d+,)?(\w+)\]", register)) is not None:
            return self.active.get(f"$MA_ENC_COMP_ENABLE[{eec[1]},{eec[2]}]") == "1"
        if (cec := re.match(r"\$AN_CEC\w*\[(\d+)", register)) is not None:
            output = self.registers.get(f"$AN_CEC_OUTPUT_AXIS[{cec[1]}]", "")
            return self.active.get(f"$MA_CEC_ENABLE[{output}]") == "1"
        return False

    def load(self, text: str) -> None:
        for register, value in self.statements(text):
            if not self.protected(register):
                self.registers[register] = value
            elif self.stops:
                return


def run(folder: Path, state: dict[str, str], *more: str) -> int:
    noise = random.Random(1)  # noqa: S311 - of a measurement
    rows = [
        f"{x},{way},{run},{x * (700 - x) / 9000 + 2.3 * (way == '-') + noise.gauss(0, 0.4):.4f}"
        for x in (40, 150, 260, 365, 471, 580, 690)
        for way in "+-"
        for run in range(1, 6)
    ]
    (folder / "x.csv").write_text("target_mm,direction,run,deviation_um\n" + "\n".join(rows))
    given: list[str] = []
    for name, text in state.items():
        (folder / name).write_text(text)
        given += ["--state", str(folder / name)]
    words = ["--format", "siemens-840d-sl", "--axis", "X", "--travel", "0:700", *given, *more]
    words += ["--option", "address=AX1", "--out", str(folder / "out"), "--force"]
    return compwright(["run", str(folder / "x.csv"), *words])


def steps_of(folder: Path) -> list[str]:
    """The steps of the card before the check, as text."""
    text = (folder / "out" / "card" / "card.md").read_text().replace("\\", "")
    return re.split(r"\n- \[ \] \*\*", text)[1:]


def follow(folder: Path, control: Control) -> None:
    """Do what the card says, in its order: switches that it has set, files that it has loaded."""
    written = {
        file.name: file for file in (folder / "out" / "tables" / "siemens-840d-sl").iterdir()
    }
    loaded: list[str] = []
    for step in steps_of(folder):
        if step.startswith("Switch the old table off"):
            control.registers.update(re.findall(SET, step))
            control.new_conf()
        elif step.startswith(("Load the table", "Set the backlash")):
            for name in re.findall(r"[\w.]+\.INI", step.split(":")[0].split("last")[0]):
                if name not in loaded:
                    loaded.append(name)
                    control.load(written[name].read_text())
            control.registers.update(re.findall(SET, step.partition("Then set")[2]))
    assert sorted(loaded) == sorted(written)


@pytest.mark.parametrize("stops", [False, True], ids=["skips", "stops"])
@pytest.mark.parametrize("form", ["", "patched"])
@pytest.mark.parametrize("kind", STATES)
def test_only_the_axis_under_work_changes_and_all_of_it(
    kind: str, form: str, stops: bool, tmp_path: Path
) -> None:
    state = STATES[kind]
    assert run(tmp_path, state, *(["--option", f"files={form}"] if form else [])) == 0
    control, before = Control(state, stops=stops), Control(state, stops=stops).registers
    follow(tmp_path, control)
    wanted = {
        register: value
        for file in (tmp_path / "out" / "tables" / "siemens-840d-sl").iterdir()
        for register, value in Control.statements(file.read_text())
    }
    for register, value in control.registers.items():
        if "AX1" in register and not re.search(r"_(MIN|MAX|STEP)\b", register):
            assert value == wanted.get(register, before.get(register)), register
        else:
            assert value == before[register], register
    assert control.registers[f"{EEC}[0,4,AX1]"] != before[f"{EEC}[0,4,AX1]"]
    files = {file.name for file in (tmp_path / "out" / "tables" / "siemens-840d-sl").iterdir()}
    assert files == (set(state) if form else {"AX1_EEC.INI", "AX1_MD.INI"})


def test_a_file_with_one_table_is_patched(tmp_path: Path) -> None:
    state = {"X.INI": "CHANDATA(1)\n" + table("AX1") + "M17\n", "MD.INI": TWO_FILES["MD.INI"]}
    assert run(tmp_path, state) == 0
    files = {file.name for file in (tmp_path / "out" / "tables" / "siemens-840d-sl").iterdir()}
    assert files == {"X.INI", "MD.INI"}


def test_compare_takes_the_whole_export_after_loading(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, TWO_FILES) == 0
    control = Control(TWO_FILES, stops=True)
    follow(tmp_path, control)
    after = tmp_path / "after"
    after.mkdir()
    for name, text in TWO_FILES.items():
        lines = [
            f"{found[1]}{found[2]}={control.registers[found[2]]}"
            if (found := re.match(r"(N\d+ |)(\$\w+\[[^\]]*\])=", line))
            else line
            for line in text.splitlines()
        ]
        (after / name).write_text("\n".join(lines) + "\n")
    capsys.readouterr()
    plan = str(tmp_path / "out" / "plan.json")
    assert compwright(["compare", plan, "--loaded", str(after)]) == 0
    assert "CW-S080" not in capsys.readouterr().out


def test_a_blank_in_place_of_the_equals_sign_is_never_written(tmp_path: Path) -> None:
    """Read with a warning; what comes out has the written form, also what brings the old values
    back, and with as many rows as before.
    """
    state = {"X.INI": "CHANDATA(1)\n" + table("AX1", " ") + machine_data(("AX1",))[12:] + "M17\n"}
    assert run(tmp_path, state) == 0
    tables = list((tmp_path / "out" / "tables" / "siemens-840d-sl").iterdir())
    back = (tmp_path / "out" / "rollback" / "siemens-840d-sl").glob("BACK_*")
    texts = [file.read_text() for file in (*tables, *back)]
    assert sum(text.count(f"{EEC}[") for text in texts) == 16
    for text in texts:
        assert not re.search(r"^\$[^=\n]*$", text, re.MULTILINE)
    assert run(tmp_path, state, "--option", "files=patched") == 2
