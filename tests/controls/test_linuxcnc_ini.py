"""What a whole INI of LinuxCNC says of its joints: letters, gantries, limits, units, kinematics;
taken, or refused by name.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest
import yaml

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.controls.control import decode, open_control
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine(low=0.0, high=200.0)
INI = """[KINS]
KINEMATICS = trivkins coordinates=XYYZA
[TRAJ]
LINEAR_UNITS = inch
ANGULAR_UNITS = degree
[JOINT_0]
TYPE = LINEAR
MIN_LIMIT = -1.0
MAX_LIMIT = 20
BACKLASH = 0.001
[JOINT_1]
TYPE = LINEAR
BACKLASH = 0.002
[JOINT_2]
TYPE = LINEAR
BACKLASH = 0.002
[JOINT_3]
TYPE = LINEAR
[JOINT_4]
TYPE = ANGULAR
MIN_LIMIT = -90
MAX_LIMIT = 90
BACKLASH = 0.01
"""


def run(folder: Path, axis: str, ini: str = INI, unit: str = "mm") -> int:
    targets = MACHINE.targets()
    name = axis.split(":", maxsplit=1)[0]
    readings = MACHINE.measure(targets, 1)
    (folder / "x.csv").write_text(csv_of(targets, readings, axis=name, unit=unit))
    (folder / "machine.ini").write_text(ini)
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: [machine.ini]}\n"
        f"axes:\n  {axis}travel: [0, 200], before: [x.csv]}}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


def test_a_new_job_takes_kind_limits_and_letters_and_names_what_it_leaves_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "machine.ini").write_text(INI)
    assert (
        compwright(
            [
                "new",
                "--from",
                str(tmp_path / "machine.ini"),
                "--format",
                "linuxcnc",
                "--out",
                str(tmp_path / "j.yaml"),
            ]
        )
        == 0
    )
    text = (tmp_path / "j.yaml").read_text()
    assert "travel: [-25.4, 508.0]" in text  # -1 in and 20 in
    assert "travel: [-90.0, 90.0]" in text
    assert text.count("kind: rotary   # from the control's files") == 1
    assert 'gantry: "2"' in text
    named = [
        line.strip(' :"')
        for line in text.splitlines()
        if line.endswith(":") and line.startswith("  ")
    ]
    assert [name for name in named if len(name) == 1] == ["X", "Y", "A"]
    assert (
        "left out, because nothing in the files is active on them: 3 (Z)" in capsys.readouterr().err
    )


@pytest.mark.parametrize(
    ("axis", "ini", "word"),
    [
        (
            'Z: {address: "2", ',
            INI,
            "joint 2 is Y",
        ),  # the place of Z among XYZ, but the second joint of Y here
        ('Y: {address: "1", ', INI, 'gantry: "2"'),
        (
            'X: {address: "0", ',
            INI.replace("trivkins coordinates=XYYZA", "corexykins"),
            "KINEMATICS",
        ),
        ('A: {address: "4", kind: rotary, ', INI.replace("= degree", "= rad"), "ANGULAR_UNITS"),
    ],
)
def test_what_would_put_a_table_on_the_wrong_joint_or_in_the_wrong_unit_is_refused(
    tmp_path: Path, axis: str, ini: str, word: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, axis, ini) == 3
    assert word in capsys.readouterr().err


def test_the_joints_of_a_gantry_get_one_table_each(tmp_path: Path) -> None:
    assert run(tmp_path, 'Y: {address: "1", gantry: "2", ') == 0
    names = sorted(path.name for path in (tmp_path / "job" / "tables" / "linuxcnc").iterdir())
    assert names == ["joint_1.comp", "joint_1.ini", "joint_2.comp", "joint_2.ini"]
    assert "BACKLASH becomes 0" in (tmp_path / "job" / "card" / "card.md").read_text(
        encoding="utf-8"
    )


# --- what decides a unit, and whether a table can act at all (LinuxCNC documentation, ini-config:
# LINEAR_UNITS, WRAPPED_ROTARY)


def write_job(folder: Path, axis: str, *, states: str, options: str = "{}") -> int:
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: linuxcnc, options: {options}}}\nstates: {{as_found:"
        f" {states}}}\naxes:\n  {axis}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


def measured(folder: Path, seed: int = 1) -> None:
    targets = MACHINE.targets()
    (folder / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, seed)))


X = 'X: {address: "0", travel: [0, 200], before: [x.csv]}'


def test_a_table_in_inches_is_not_read_as_mm_because_nobody_repeats_the_unit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    measured(tmp_path)
    assert write_job(tmp_path, X, states="none", options="{units: inch}") == 0
    loaded = tmp_path / "loaded"
    loaded.mkdir()
    for file in (tmp_path / "job" / "tables" / "linuxcnc").iterdir():
        (loaded / file.name).write_bytes(file.read_bytes())
    measured(tmp_path, 2)
    capsys.readouterr()
    assert write_job(tmp_path, X, states="[loaded]") == 2
    said = capsys.readouterr().err
    assert "controller.options.units" in said
    assert "the unit of the machine is not given" in said
    assert "mm or inch, or the whole INI file with LINEAR_UNITS among the files" in said
    assert write_job(tmp_path, X, states="[loaded]", options="{units: inch}") == 1
    found = json.loads((tmp_path / "job" / "prediction.json").read_text(encoding="utf-8"))
    assert [one["code"] for one in found["doubts"]] == ["CW-P161"]


def test_a_unit_that_the_ini_contradicts_is_refused_even_where_it_is_the_default(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    measured(tmp_path)
    (tmp_path / "machine.ini").write_text(INI)  # inch
    assert write_job(tmp_path, X, states="[machine.ini]", options="{units: mm}") == 2
    assert "controller.options.units" in capsys.readouterr().err


def rotary(folder: Path, ini: str, more: str = "") -> int:
    turn = Machine(low=0.0, high=360.0, slope=0.0, bow=0.003, lost=0.002)  # deg
    targets = turn.targets()
    rows = [
        f"{x},{'+' if sign > 0 else '-'},{run},{3600 * value:.4f}\n"
        for sign, block in turn.measure(targets, 1).items()
        for x, readings in zip(targets, block, strict=True)
        for run, value in enumerate(readings, start=1)
    ]
    (folder / "a.csv").write_text("target_deg,direction,run,deviation_arcsec\n" + "".join(rows))
    (folder / "machine.ini").write_text(ini)
    axis = f'A: {{kind: rotary, address: "1", travel: [0, 360], before: [a.csv]{more}}}'
    return write_job(folder, axis, states="[machine.ini]")


@pytest.mark.parametrize(
    ("word", "code"), [("WRAPPED_ROTARY = 1", 3), ("WRAPPED_ROTARY = 0", 0), ("", 0)]
)
def test_a_wrapped_rotary_axis_gets_no_table(
    tmp_path: Path, word: str, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """The joint counts on past 360; a table holds its end value there (seen in runs of LinuxCNC
    2.9).
    """
    ini = (
        "[KINS]\nKINEMATICS = trivkins coordinates=XA\n[TRAJ]\nLINEAR_UNITS = mm\nANGULAR_UNITS ="
        f" degree\n[AXIS_A]\n{word}\n[AXIS_X]\nWRAPPED_ROTARY = 0\n[JOINT_0]\nBACKLASH ="
        " 0\n[JOINT_1]\nTYPE = ANGULAR\nBACKLASH = 0\n"
    )
    assert rotary(tmp_path, ini) == code
    assert ("[AXIS_A] WRAPPED_ROTARY" in capsys.readouterr().err) == (code == 3)


def test_a_table_that_no_joint_names_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    measured(tmp_path)
    (tmp_path / "machine.ini").write_text(
        "[TRAJ]\nLINEAR_UNITS = mm\n[JOINT_0]\nBACKLASH = 0.001\n[JOINT_1]\nCOMP_FILE ="
        " comp/y.comp\n"
    )
    rows = "0 0 0\n200 200.005 200.006\n"
    (tmp_path / "old.comp").write_text(rows)
    (tmp_path / "y.comp").write_text(rows)
    assert write_job(tmp_path, X, states="[machine.ini, old.comp, y.comp]") == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "does not load old.comp" in said
    assert "does not load y.comp" not in said


def joint(limits: str, tmp_path: Path) -> int:
    return run(
        tmp_path, "X: {address: 0, ", INI.replace("MIN_LIMIT = -1.0\nMAX_LIMIT = 20\n", limits)
    )


def test_a_travel_outside_the_limits_of_the_joint_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Travel 0 to 200 mm; 1 in = 25.4 mm: -20 to 0 in is the other side of machine zero, 0 to 7 in
    ends at 177.8 mm.
    """
    assert joint("MIN_LIMIT = -20\nMAX_LIMIT = 0\n", tmp_path) == 3
    assert "(MIN_LIMIT, MAX_LIMIT)" in capsys.readouterr().err
    assert joint("MIN_LIMIT = 0\nMAX_LIMIT = 7\n", tmp_path) == 1  # a doubt
    assert "CW-S045  axis 0: the travel of the job goes 22.2 mm beyond" in capsys.readouterr().out
    assert joint("MIN_LIMIT = 0\nMAX_LIMIT = 8\n", tmp_path) == 0
    assert "CW-S045" not in capsys.readouterr().out


#: Five axes as LinuxCNC's own configuration xyzbc-trt.ini has them; its source xyzbc-trt-kins.c:
#: required_coordinates "xyzbc", a joint for each.
TABLE_OF_TWO = """[KINS]
KINEMATICS = xyzbc-trt-kins sparm=identityfirst
JOINTS = 5
[TRAJ]
COORDINATES = XYZBC
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
""" + "".join(f"[JOINT_{n}]\nTYPE = {'LINEAR' if n < 3 else 'ANGULAR'}\n" for n in range(5))


def test_joints_of_a_kinematics_with_letters_of_its_own_are_named_by_the_axes(
    tmp_path: Path,
) -> None:
    (tmp_path / "machine.ini").write_text(TABLE_OF_TWO)
    made = ["--format", "linuxcnc", "--out", str(tmp_path / "job.yaml")]
    assert compwright(["new", "--from", str(tmp_path / "machine.ini"), *made]) == 0
    axes = yaml.safe_load((tmp_path / "job.yaml").read_text())["axes"]
    found = {name: axis["address"] for name, axis in axes.items()}
    assert found == {"X": "0", "Y": "1", "Z": "2", "B": "3", "C": "4"}


def test_an_axis_is_not_the_joint_of_another_axis(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """B has the place of joint 4 in the row of all letters, and is joint 3 here."""
    assert run(tmp_path, "B: {kind: rotary, ", TABLE_OF_TWO, "deg") == 0
    assert (tmp_path / "job" / "tables" / "linuxcnc" / "joint_3.comp").exists()
    shutil.rmtree(tmp_path / "job")
    assert run(tmp_path, 'B: {address: "4", kind: rotary, ', TABLE_OF_TWO, "deg") == 3
    text = capsys.readouterr().err
    assert "address 4 belongs to a different axis in the control's files" in text
    assert "XYZBC: joint 4 is C" in text
    assert not (tmp_path / "job").exists()


@pytest.mark.parametrize(
    "ini",
    [
        TABLE_OF_TWO.replace("xyzbc-trt-kins sparm=identityfirst", "trivkins"),
        TABLE_OF_TWO.replace("JOINTS = 5", "JOINTS = 6"),
    ],
)
def test_axes_that_are_not_those_of_the_joints_name_none(tmp_path: Path, ini: str) -> None:
    """Without coordinates= trivkins has all letters; with more joints than axes nobody knows."""
    state = control_format(DEFINITIONS["linuxcnc"], {}).read(
        [ControlFile("machine.ini", ini.encode())]
    )
    assert {facts.letters for facts in state.facts.values()} == {""}


#: What lies in the folder of every machine: github rene-dev/linuxcnc-configs, haas (a HAL file, the
#: variables of the interpreter, a tool table), and its table, COMP_FILE_TYPE = 1.
BESIDE = {
    "haas.hal": "# Core HAL Loads\n\nloadrt [KINS]KINEMATICS\nnet x-pos joint.0.motor-pos-cmd\n",
    "haas.var": "5161\t0.000000\n5162\t0.000000\n",
    "tool.tbl": "T1 P1 D6.000000 Z-102.340000 ;end mill\n",
    "picture.png": "\x89PNG\x00\x01",
}
HAAS = (
    "[TRAJ]\nLINEAR_UNITS = mm\n[KINS]\nKINEMATICS = trivkins coordinates=xyzc\n"
    "[JOINT_0]\nTYPE = LINEAR\nBACKLASH = 0.000\nCOMP_FILE = xaxis.comp\nCOMP_FILE_TYPE = 1\n"
)


def machine(**texts: str) -> list[ControlFile]:
    given = {"haas.ini": HAAS, "xaxis.comp": "0 0 0\n250.000 0.012 0.014\n500.000 0.026 0.026\n"}
    files = {**given, **BESIDE, **texts}
    return [ControlFile(name, text.encode("latin-1")) for name, text in files.items()]


def test_the_folder_of_a_machine_is_read_whatever_lies_beside_its_table() -> None:
    state = decode(open_control(Session(), "linuxcnc", {}), machine(), address="0").state
    assert state.axes["0"].positive.tolist() == [0, 0.012, 0.026]
    assert state.axes["0"].negative.tolist() == [0, 0.014, 0.026]
    told = [finding.message for finding in state.findings if finding.code == "CW-S012"]
    assert len(told) == 1
    assert "haas.hal, haas.var, tool.tbl and 1 more" in told[0]


def test_a_table_that_the_machine_names_is_refused_where_it_is_damaged() -> None:
    """And where the file that it names is not there, whatever else is."""
    control = open_control(Session(), "linuxcnc", {})
    with pytest.raises(InputError, match=r"xaxis\.comp: line 1 cannot be read as a row"):
        decode(control, machine(**{"xaxis.comp": "# position + -\n0 0 0\n"}), address="0")
    with pytest.raises(
        InputError, match="the table file that its configuration names was not given"
    ):
        decode(
            control,
            machine(**{"haas.ini": HAAS.replace("xaxis.comp", "haas.hal_old")}),
            address="0",
        )


def test_a_hal_file_that_changes_backlash_while_the_control_runs_is_refused() -> None:
    """Pin ini.N.backlash (milltask(1)); a remark and other pins of the same joint do nothing."""
    control, remark = (
        open_control(Session(), "linuxcnc", {}),
        "# setp ini.0.backlash 0.02\nsetp ini.0.ferror 1\n",
    )
    assert "0" in decode(control, machine(**{"post.hal": remark}), address="0").state.axes
    with pytest.raises(
        InputError, match=r"post\.hal: line 3: .* found setp ini\.0\.backlash 0\.02"
    ):
        decode(control, machine(**{"post.hal": remark + "setp ini.0.backlash 0.02"}), address="0")


@pytest.mark.parametrize("damaged", [HAAS + "\x00", "\ufeff" + HAAS])
def test_a_damaged_ini_is_not_left_out_beside_another_one(damaged: str) -> None:
    content = damaged.encode("latin-1" if damaged.startswith("[") else "utf-16")
    other = "[TRAJ]\nLINEAR_UNITS = mm\n[JOINT_0]\nTYPE = LINEAR\nBACKLASH = 0.0\n"
    files = [ControlFile("haas.ini", content), ControlFile("other.ini", other.encode())]
    with pytest.raises(InputError, match=r"haas\.ini: the file is not a text file"):
        decode(open_control(Session(), "linuxcnc", {}), files, address="0")


@pytest.mark.parametrize("format_id", ["linuxcnc", "fanuc-30i", "siemens-840d-sl"])
@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be"])
def test_a_text_of_two_bytes_a_character_is_told_with_what_helps(
    format_id: str, encoding: str
) -> None:
    options = {"detection_unit": 0.001} if format_id.startswith("fanuc") else {}
    file = ControlFile("unicode.txt", INI.encode(encoding))
    with pytest.raises(InputError, match=r"saved as UTF-16 .* save it as ANSI"):
        open_control(Session(), format_id, options).format.read([file])
    binary = ControlFile("binary.txt", b"\x00" * 600 + b"\x01\x02" * 9)
    with pytest.raises(InputError, match="binary archive"):
        open_control(Session(), format_id, options).format.read([binary])


# --- letters come from the line of the kinematics (trivkins.c, kins_util.c), units from what the
# control takes (emcIniFile.cc, inifile.cc)


LATHE = "[KINS]\nKINEMATICS = {kins}\nJOINTS = {joints}\n[TRAJ]\nCOORDINATES = {axes}\n{unit}\n"
TWO = "[JOINT_0]\nTYPE = Linear\nBACKLASH = 0.001\n[JOINT_1]\nTYPE = 1\nBACKLASH = 0.002\n"


@pytest.mark.parametrize(
    ("kins", "joints", "axes", "joint"),
    [
        ("trivkins coordinates=XZ", 2, "X Z", 1),
        ("trivkins coordinates=XYYZ", 4, "XYZ", 3),
        ("trivkins coordinates=xz kinstype=BOTH", 2, "xz", 1),
        ("trivkins coordinates=zx", 2, "X Z", 0),
        ("TRIVKINS COORDINATES=XZ", 2, "XZ", None),  # the module's parameter is coordinates
        ("trivkins", 3, "X Z", 2),
        ("trivkins", 2, "X Z", None),  # the third joint that Z would have is not there
        ("xyzbc-trt-kins", 2, "X Z", 1),
    ],
)
def test_the_letter_of_a_lathe_names_the_joint_of_its_kinematics(
    tmp_path: Path, kins: str, joints: int, axes: str, joint: int | None
) -> None:
    lathe = LATHE.format(kins=kins, joints=joints, axes=axes, unit="LINEAR_UNITS = mm")
    more = "".join(f"[JOINT_{number}]\nBACKLASH = 0\n" for number in range(2, joints))
    code = run(tmp_path, "Z: {", lathe + TWO + more)
    assert code == (2 if joint is None else 0)
    if joint is not None:
        written = tmp_path / "job" / "tables" / "linuxcnc"
        assert [path.name for path in sorted(written.iterdir())] == [
            f"joint_{joint}.comp",
            f"joint_{joint}.ini",
        ]


@pytest.mark.parametrize(("axis", "code"), [("X: {", 0), ("Z: {", 2), ("A: {", 2)])
def test_a_letter_alone_says_the_joint_of_the_first_axis_only(
    tmp_path: Path, axis: str, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    run(tmp_path, 'X: {address: "0", ')
    name = axis[0]
    (tmp_path / "x.csv").write_text(
        (tmp_path / "x.csv").read_text().replace("# axis: X", f"# axis: {name}")
    )
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\n"
        f"axes:\n  {axis}travel: [0, 200], before: [x.csv]}}\n"
    )
    capsys.readouterr()
    assert compwright(["run", str(tmp_path / "job.yaml"), "--force"]) == code
    assert (f"axes.{name}.address" in capsys.readouterr().err) == (code == 2)


@pytest.mark.parametrize(
    ("unit", "size"),
    [
        ("Inch", 25.4),
        ("IMPERIAL", 25.4),
        ("0.03937007874015748", 25.4),
        ("0.0393701", 25.4),
        ("1.0", 1.0),
        ("1", 1.0),
        ("Metric", 1.0),
        ("0.1", None),  # centimetres
        ("inches", None),  # the control does not start
    ],
)
def test_units_that_the_control_takes_are_taken(unit: str, size: float | None) -> None:
    text = f"[TRAJ]\nLINEAR_UNITS = {unit}\n[JOINT_0]\nBACKLASH = 0.02\n"
    files = [ControlFile("machine.ini", text.encode())]
    control = open_control(Session(), "linuxcnc", {})
    if size is None:
        with pytest.raises(InputError, match="LINEAR_UNITS"):
            decode(control, files)
        return
    state = decode(control, files).state.axes["0"]
    assert state.positive[0] == pytest.approx(0.01 * size, rel=1e-5)


@pytest.mark.parametrize(("unit", "known"), [("Degree", True), ("1.0", True), ("rad", False)])
def test_angles_in_degrees_are_taken_in_any_form(unit: str, known: bool) -> None:
    text = f"[TRAJ]\nANGULAR_UNITS = {unit}\n[JOINT_0]\nTYPE = angular\nBACKLASH = 0.02\n"
    files, control = (
        [ControlFile("machine.ini", text.encode())],
        open_control(Session(), "linuxcnc", {}),
    )
    if known:
        assert decode(control, files).state.axes["0"].positive[0] == pytest.approx(0.01)
    else:
        with pytest.raises(InputError, match="ANGULAR_UNITS"):
            decode(control, files)


@pytest.mark.parametrize(
    ("name", "text", "refused"),
    [
        ("a.hal", "setp ini.0.backlash 0.02\n", True),
        ("a.hal", "net play <= mux.out => ini.0.backlash\n", True),
        ("a.tcl", "if {$::X} {\n  setp ini.$j.backlash 0.02\n}\n", True),
        ("a.hal", "setp [HAL]PLAY 0.02\n", True),
        ("a.tcl", "setp $pin 0.02\n", True),
        ("a.hal", "net play mux.out => [HAL](PLAY)\n", True),
        ("a.tcl", 'set p "ini.0"\nhal setp "${p}.backlash" 0.02\n', True),
        ("a.tcl", "hal setp $pin.backlash 0.02\n", True),
        ("a.hal", "setp [HAL]PLAY_OF.backlash 0.02\n", True),
        ("a.tcl", 'hal setp "$a$b" 0.02\n', True),
        ("a.tcl", "foreach p $pins { hal setp $p 0.02 }\n", True),
        ("a.tcl", "hal setp $card.0.stepgen.00.dirsetup $ns\n", False),
        ("a.hal", "# setp ini.0.backlash 0.02\n", False),
        # as in configurations of Mesa cards, which come with LinuxCNC
        ("a.hal", "setp hm2_[HOSTMOT2](BOARD).0.stepgen.00.dirsetup [JOINT_0]DIRSETUP\n", False),
        (
            "a.hal",
            "setp [HMOT](CARD0).watchdog.timeout_ns 5000000\nloadusr -W hal_manualtoolchange\n",
            False,
        ),
        ("a.hal", "net x-pos joint.0.motor-pos-cmd\nsource b.hal\n", False),
    ],
)
def test_what_may_change_backlash_at_run_time_is_refused_by_file_and_line(
    name: str, text: str, refused: bool
) -> None:
    files = [
        ControlFile("machine.ini", b"[HAL]\nHALFILE = a.hal\n[JOINT_0]\nBACKLASH = 0.02\n"),
        ControlFile(name, b"loadrt trivkins\n" + text.encode()),
    ]
    if not refused:
        assert (
            decode(open_control(Session(), "linuxcnc", {}), files).state.axes["0"].positions.size
            == 1
        )
        return
    with pytest.raises(InputError) as stopped:
        decode(open_control(Session(), "linuxcnc", {}), files)
    fault = stopped.value.faults[0]
    commands = ("setp ", "net ")
    line = next(
        at for at, one in enumerate(text.splitlines()) if any(word in one for word in commands)
    )
    assert (fault.file, fault.place) == (name, f"line {line + 2}")


def test_backlash_by_a_command_of_the_ini_is_refused() -> None:
    text = b"[HAL]\nHALCMD = setp ini.0.backlash 0.05\n[JOINT_0]\nBACKLASH = 0.02\n"
    with pytest.raises(InputError, match="line 2"):
        decode(open_control(Session(), "linuxcnc", {}), [ControlFile("machine.ini", text)])


def test_an_ini_of_an_older_release_is_named_with_what_helps() -> None:
    """Before 2.8 joints stood in [AXIS_0] (github shulter/cnc-configs, hector-7i92.ini)."""
    text = b"[TRAJ]\nLINEAR_UNITS = mm\n[AXIS_0]\nTYPE = LINEAR\nBACKLASH = 0.020\n"
    with pytest.raises(InputError, match="update_ini"):
        decode(open_control(Session(), "linuxcnc", {}), [ControlFile("hector.ini", text)])


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("setp axis.x.eoffset-enable 1", "eoffset-enable"),
        ("setp axis.x.eoffset-enable=TRUE", "eoffset-enable"),
        ("net torch:offset => axis.x.eoffset-counts", "eoffset-counts"),
        ("net on axis.x.eoffset-enable motion.on", "eoffset-enable"),
        ("linksp torch axis.x.eoffset-counts", "eoffset-counts"),
        ("setp ini.0.backlash 0.012", "ini.0.backlash"),
        ("setp axis.x.eoffset-enable 0", ""),
        ("# setp axis.x.eoffset-enable 1", ""),
        ("setp axis.z.eoffset-enable 1", ""),
        ("setp ini.1.backlash 0.012", ""),
    ],
)
def test_the_judge_reads_what_hal_adds_to_an_axis(line: str, says: str) -> None:
    """motion(9): the offset is added to the position of the axis while it is enabled."""
    ini = "[KINS]\nKINEMATICS = trivkins coordinates=XYZ\n[JOINT_0]\nBACKLASH = 0.002\n"
    for files in (
        [ControlFile("m.ini", ini.encode()), ControlFile("a.hal", f"\n{line}\n".encode())],
        [ControlFile("m.ini", f"{ini}[HAL]\nHALCMD = {line}\n".encode())],
    ):
        if not says or line.startswith("#"):
            virtual_control("linuxcnc", files, axes_under_work=("0",))
            continue
        with pytest.raises(InputError, match=says):
            virtual_control("linuxcnc", files, axes_under_work=("0",))


def test_a_superscript_is_no_number_of_a_joint() -> None:
    """Found in a text of Latin-1; the sections and the count are left out."""
    ini = "[KINS]\nJOINTS = ²\nKINEMATICS = trivkins\n[TRAJ]\nCOORDINATES = X Y Z\n"
    ini += "[JOINT_0]\nBACKLASH = 0.002\n[JOINT_²]\nHOME_SEQUENCE = -1\n"
    found = decode(
        open_control(Session(), "linuxcnc", {}), [ControlFile("m.ini", ini.encode("latin-1"))]
    )
    assert list(found.state.axes) == ["0"]
