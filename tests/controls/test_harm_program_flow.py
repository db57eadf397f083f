"""Programs as the state of a SINUMERIK: what a program may have skipped is never counted unasked.

A program interpreter of its own (``harm_sinumerik``) carries each case out in many worlds: other R
parameters, block skip, other called programs, other contents before. Where the worlds end
differently, ``run`` has to ask (2) or to refuse (3); where they do not, what is read must be it.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from harm_command import ASKED, REFUSED, Answer, command, tables_of
from harm_measuring import Axis, measure, write_csv
from harm_program_jobs import FORMAT, better, job, read, run
from harm_programs import (
    ALL,
    AXIS,
    DOUBTFUL,
    GRID,
    LOST,
    OFF,
    OLD,
    ON,
    OTHERS,
    PLAIN,
    VALUES,
    World,
    ends,
    is_certain,
    program,
)

pytestmark = pytest.mark.short_estimate


@pytest.mark.parametrize("case", DOUBTFUL)
def test_what_may_not_have_been_carried_out_is_not_counted(case: str, tmp_path: Path) -> None:
    text = DOUBTFUL[case]
    answer, _ = run(tmp_path, text, World())
    if is_certain(text) and answer.code == 0:
        assert {read(tmp_path)} == set(ends(text))
        return
    assert answer.code in {ASKED, REFUSED}, answer.first
    assert not tables_of(tmp_path / "job")


@pytest.mark.parametrize("case", PLAIN)
def test_what_is_always_carried_out_is_read(case: str, tmp_path: Path) -> None:
    text = PLAIN[case]
    assert is_certain(text)
    (tmp_path / "P.MPF").write_text(text, encoding="utf-8")
    assert {read(tmp_path)} == set(ends(text))


@pytest.mark.parametrize(
    "case", ["the maker's form", "flow after the last value", "comments that look like flow"]
)
def test_a_plain_program_is_counted_and_the_axis_gets_better(case: str, tmp_path: Path) -> None:
    answer, control = run(tmp_path, PLAIN[case], World())
    assert answer.code == 0, answer.first
    assert better(tmp_path, control)


BRANCH = program("IF R50==1", OFF, VALUES, GRID, LOST, ON, "ENDIF")


@pytest.mark.parametrize(("active", "value"), [("yes", 1.0), ("no", 0.0)])
def test_the_answer_is_taken(active: str, value: float, tmp_path: Path) -> None:
    """R50 was 1 and the table acted; or it was 0, and what the control holds is in no file."""
    answer, control = run(tmp_path, BRANCH, World({"R50": value}), active)
    assert answer.code == 0, answer.first
    assert better(tmp_path, control)
    if active == "no":
        assert answer.names("P.MPF", "active: no")


#: Ways past values that no condition decides about, with the line of the first such value.
PASSED = {
    "gotof": (["GOTOF ENDE", ALL, "ENDE:"], 2),
    "goto": (["GOTO ENDE", ALL, "ENDE:"], 2),
    "gotoc": (["N10 GOTOC ENDE", ALL, "ENDE: R1=1"], 2),
    "gotof in the middle": ([OFF, VALUES[:3], "GOTOF ENDE", VALUES[3:], "ENDE:", GRID, ON], 7),
    "gotob": (["ANFANG:", "R1=R1+1", "IF R1>3 GOTOF ENDE", "GOTOB ANFANG", ALL, "ENDE:"], 5),
    "a loop without an end": (["LOOP", "R1=R1+1", "ENDLOOP", ALL], 4),
    "a jump in either branch": (
        ["IF R1==1", "GOTOF EE", "ELSE", "GOTOF EE", "ENDIF", ALL, "EE:"],
        6,
    ),
    "both branches of a case": (["CASE R1 OF 1 GOTOF EE DEFAULT GOTOF EE", ALL, "EE:"], 2),
    "one of two": (["IF R50==1", VALUES[:4], "ELSE", VALUES[4:], "ENDIF", GRID, ON], 7),
    "a jump behind the first half": (
        ["IF R50==1 GOTOF BB", VALUES[:4], "GOTOF CC", "BB:", VALUES[4:], "CC:", GRID, ON],
        8,
    ),
}


@pytest.mark.parametrize("case", PASSED)
def test_yes_is_refused_where_no_run_carries_out_every_value(case: str, tmp_path: Path) -> None:
    parts, line = PASSED[case]
    answer, _ = run(tmp_path, program(*parts), World({"R50": 1.0, "R1": 5.0}), "yes")
    assert answer.code == REFUSED, answer.first
    assert answer.names(f"P.MPF: line {line}")


SWITCHED = [*GRID, *LOST, *ON]


@pytest.mark.parametrize(
    "parts",
    [
        ["GOTOF LADEN", "ENDE:", "M17", "LADEN:", ALL, "GOTOB ENDE"],
        ["IF R1==0 GOTOF LADEN", "R2=1", "LADEN:", ALL],
        ["LOOP", "R1=R1+1", "IF R1>3 GOTOF WEITER", "ENDLOOP", "WEITER:", ALL],
        [
            "GOTOF BB",
            "AA:",
            VALUES[:4],
            "GOTOF CC",
            "BB:",
            VALUES[4:],
            "GOTOB AA",
            "CC:",
            *SWITCHED,
        ],
        ["ANFANG:", ALL, "R1=R1+1", "IF R1<3 GOTOB ANFANG"],
    ],
)
def test_yes_is_taken_where_a_run_carries_out_every_value(
    parts: list[str | list[str]], tmp_path: Path
) -> None:
    answer, control = run(tmp_path, program(*parts), World({"R50": 1.0, "R1": 1.0}), "yes")
    assert answer.code == 0, answer.first
    assert better(tmp_path, control)


@pytest.mark.parametrize("case", ["if around the table", "if around some points"])
def test_no_is_refused_where_a_value_is_carried_out_anyhow(case: str, tmp_path: Path) -> None:
    """Backlash, or a half of the points, stands outside of the branch."""
    text = DOUBTFUL[case]
    answer, _ = run(tmp_path, text, World({"R50": 0.0}), "no")
    assert answer.code == REFUSED, answer.first
    first = LOST[0] if case == "if around the table" else VALUES[1]
    assert answer.names(f"P.MPF: line {text.splitlines().index(first) + 1}")


#: A file with values alone, ``KOMP_X``, and the main program of another file that calls it.
CALLS = {
    "on a condition": ["IF R50==1", 'CALL "KOMP_X"', "ENDIF"],
    "by its name, on a condition": ["IF R50<>1 GOTOF ENDE", "KOMP_X", "ENDE:"],
    "with arguments": ["IF R50<>1 GOTOF ENDE", "N20 KOMP_X(1)", "ENDE:"],
    "by its path": ["IF R50==1", "PCALL /_N_SPF_DIR/_N_KOMP_X_SPF", "ENDIF"],
    "by block skip": ["/ KOMP_X"],
    "behind another call": ["L200", "KOMP_X"],
    "in a synchronised action": ["WHEN $A_IN[1]==1 DO KOMP_X"],
}


def called(folder: Path, main: str, active: str = "", name: str = "KOMP_X.INI") -> Answer:
    control = World().control()
    control.load(program(ALL))
    control.reset()
    files = f"[HAUPT.MPF, {name}]"
    state = f"{{files: {files}, active: {active}}}" if active else files
    texts = {"HAUPT.MPF": main, name: program(ALL)}
    return command("run", job(folder, control, texts, state))


@pytest.mark.parametrize("case", CALLS)
def test_a_call_from_another_file_on_a_condition_is_asked_about(case: str, tmp_path: Path) -> None:
    main = program(CALLS[case], end="M30")
    answer = called(tmp_path, main)
    assert answer.code == ASKED, answer.first
    assert answer.names("HAUPT.MPF: line 1")
    assert called(tmp_path, main, "yes").code == 0


def test_a_call_that_no_run_comes_to(tmp_path: Path) -> None:
    for main in (["GOTOF ENDE", "KOMP_X", "ENDE:"], ["M30", "KOMP_X"]):
        text = program(*main, end="M30")
        assert called(tmp_path, text).code == ASKED
        answer = called(tmp_path, text, "yes")
        assert answer.code == REFUSED
        assert answer.names("HAUPT.MPF: line 2")


def test_a_call_through_a_third_file_is_followed(tmp_path: Path) -> None:
    (tmp_path / "L300.NC").write_text(program('EXTCALL "KOMP_X"'), encoding="utf-8")
    main = program("IF R50==1", "L300", "ENDIF", end="M30")
    control = World().control()
    path = job(
        tmp_path,
        control,
        {"HAUPT.MPF": main, "KOMP_X.INI": program(ALL)},
        "[HAUPT.MPF, L300.NC, KOMP_X.INI]",
    )
    answer = command("run", path)
    assert answer.code == ASKED, answer.first
    assert answer.names("HAUPT.MPF: line 1")


@pytest.mark.parametrize(
    "main",
    [
        ["R1=1", "KOMP_X"],
        ['CALL "KOMP_X"', "IF R1==1", 'MSG("fertig")', "ENDIF"],
        ["EXTERN KOMP_X", "IF R1==1", 'MSG("KOMP_X")', "ENDIF"],
        ["IF R1==1", "R5=KOMP_X", "ENDIF"],
    ],
)
def test_a_plain_call_or_none_is_not_asked_about(main: list[str], tmp_path: Path) -> None:
    answer = called(tmp_path, program(main, end="M30"))
    assert answer.code == 0, answer.first


@pytest.mark.parametrize("active", ["", "yes", "no"])
def test_one_address_in_two_branches_is_refused(active: str, tmp_path: Path) -> None:
    text = program(OFF, "IF R50==1", VALUES, "ELSE", OTHERS, "ENDIF", GRID, LOST, ON)
    answer, _ = run(tmp_path, text, World(), active)
    assert answer.code == REFUSED
    if active == "no":
        return  # the backlash is carried out in either branch
    lines = text.splitlines()
    first, second = (
        [i for i, row in enumerate(lines, 1) if row.startswith(f"$AA_ENC_COMP[0,{k},")]
        for k in (1, 2)
    )
    assert any(answer.names(str(rows[0]), str(rows[1])) for rows in (first, second))


@pytest.mark.parametrize("suffix", ["INI", "MPF", "SPF"])
def test_a_branch_in_another_file_of_the_state_is_seen(suffix: str, tmp_path: Path) -> None:
    """A plain export, and beside it the maker's program with other values in a branch."""
    name = f"KOMP.{suffix}"
    extra = program(OFF, "IF R50==1", "$AA_ENC_COMP[0,3,AX1]=-0.012", "ENDIF", ON)
    control = World().control()
    control.load(program(ALL))
    control.reset()
    path = job(tmp_path, control, {"EEC.INI": program(ALL), name: extra}, f"[EEC.INI, {name}]")
    answer = command("run", path)
    assert answer.code in {ASKED, REFUSED}, answer.first


def test_a_table_between_axes_in_a_branch_is_not_counted(tmp_path: Path) -> None:
    """A table of the axis over itself, in a branch: it acts as $AA_ENC_COMP does."""
    cross = [
        *(f"$AN_CEC[0,{i}]={value}" for i, value in enumerate(OLD)),
        f"$AN_CEC_INPUT_AXIS[0]=({AXIS})",
        f"$AN_CEC_OUTPUT_AXIS[0]=({AXIS})",
        "$AN_CEC_STEP[0]=100",
        "$AN_CEC_MIN[0]=0",
        "$AN_CEC_MAX[0]=600",
        "$AN_CEC_DIRECTION[0]=0",
        "$AN_CEC_MULT_BY_TABLE[0]=0",
        "$AN_CEC_IS_MODULO[0]=0",
        f"$MA_CEC_ENABLE[{AXIS}]=1",
        "$SN_CEC_TABLE_ENABLE[0]=1",
    ]
    text = program(ALL, "IF R50==1", cross, "NEWCONF", "ENDIF")
    path = job(tmp_path, World().control(), {"P.MPF": text}, "[P.MPF]")
    path.write_text(
        path.read_text().replace(
            f"{FORMAT}}}",
            f"{FORMAT}, options: {{cec: available, cec_sign: error, cec_tables: [4, 5]}}}}",
        )
    )
    answer = command("run", path)
    assert answer.code in {ASKED, REFUSED}, answer.first


PMAC = ["#1 DEFINE COMP 8,400000", "-16 -40 -24 -64 -80 -96 -40 0", "I51=1", "I186=16", "I185=32"]
SCRIPTS = {
    "a condition around the table": ["IF(P1=1)", *PMAC, "ENDIF"],
    "a program switches tables on": [
        *PMAC[:2],
        *PMAC[3:],
        "OPEN PLC 1 CLEAR",
        "IF(P1=1)",
        "I51=1",
        "ENDIF",
        "CLOSE",
    ],
    "a program switches tables off": [
        *PMAC,
        "OPEN PLC 1 CLEAR",
        "IF(P1=1)",
        "I51=0",
        "ENDIF",
        "CLOSE",
    ],
    "a program sets backlash": [
        *PMAC,
        "OPEN PLC 3 CLEAR",
        "WHILE(P1=1)",
        "I186=0",
        "ENDWHILE",
        "CLOSE",
    ],
    "a program deletes the table": [*PMAC, "OPEN PLC 2 CLEAR", 'CMD"#1DELETE COMP"', "CLOSE"],
    "a motion program sets backlash": [*PMAC, "OPEN PROG 10 CLEAR", "I186=800", "CLOSE"],
    "the preprocessor leaves the table out": ["#ifdef LASER", *PMAC, "#endif"],
    "the preprocessor takes one of two": [
        "#ifdef LASER",
        *PMAC,
        "#else",
        "#1 DEFINE COMP 4,400000",
        "-6 -4 -2 0",
        "#endif",
    ],
    "a remark ends at its mark": ["/* ", *PMAC, "*/"],
}
SAFE_SCRIPTS = {
    "a program that sets nothing of it": [
        *PMAC,
        "OPEN PLC 1 CLEAR",
        "IF(P1=1)",
        "P5=P5+1",
        "ENDIF",
        "CLOSE",
    ],
    "remarks that look like flow": ["; IF(P1=1)", *PMAC, "; ENDIF"],
}


def pmac(folder: Path, lines: list[str]) -> Answer:
    (folder / "comp.pmc").write_text("\n".join(lines) + "\n", encoding="utf-8")
    write_csv(folder / "x.csv", "X", measure(Axis(high=300)))
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: pmac, options: {counts_per_unit: 1000}}\n"
        "states: {as_found: [comp.pmc]}\n"
        "axes:\n  X: {travel: [0, 300], address: 1, before: [x.csv]}\n",
        encoding="utf-8",
    )
    return command("run", folder / "job.yaml")


@pytest.mark.parametrize("case", SCRIPTS)
def test_scripts_with_flow_are_asked_about_or_refused(case: str, tmp_path: Path) -> None:
    answer = pmac(tmp_path, SCRIPTS[case])
    assert answer.code in {ASKED, REFUSED}, answer.first


@pytest.mark.parametrize("case", SAFE_SCRIPTS)
def test_scripts_without_flow_around_values_are_taken(case: str, tmp_path: Path) -> None:
    assert pmac(tmp_path, SAFE_SCRIPTS[case]).code == 0


INI = """[EMC]
VERSION = 1.1
[KINS]
KINEMATICS = trivkins coordinates=XYZ
JOINTS = 3
[TRAJ]
COORDINATES = XYZ
LINEAR_UNITS = mm
[HAL]
HALFILE = comp.hal
[EMCMOT]
SERVO_PERIOD = 1000000
[JOINT_0]
TYPE = LINEAR
MIN_LIMIT = -1
MAX_LIMIT = 601
MAX_VELOCITY = 500
MAX_ACCELERATION = 2000
{more}
"""
HAL = {
    "backlash by the pin": ("BACKLASH = 0.002", "setp ini.0.backlash 0.012"),
    "backlash by the pin, none in the file": ("", "setp ini.0.backlash 0.012"),
    "backlash by a net": ("BACKLASH = 0.002", "net play spindle.0.on => ini.0.backlash"),
}


@pytest.mark.parametrize("case", HAL)
def test_backlash_that_hal_sets_is_not_overlooked(case: str, tmp_path: Path) -> None:
    """The pin ini.N.backlash holds while the control runs; the file says something else."""
    more, line = HAL[case]
    (tmp_path / "mill.ini").write_text(INI.format(more=more), encoding="utf-8")
    (tmp_path / "comp.hal").write_text("loadrt [KINS]KINEMATICS\n" + line + "\n", encoding="utf-8")
    write_csv(tmp_path / "x.csv", "X", measure(Axis()))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: [mill.ini, comp.hal]}\n"
        "axes:\n  X: {travel: [0, 600], address: 0, before: [x.csv]}\n",
        encoding="utf-8",
    )
    answer = command("run", tmp_path / "job.yaml")
    assert answer.code in {ASKED, REFUSED}, answer.first


@pytest.mark.parametrize(
    ("line", "declined"),
    [
        ("setp axis.x.eoffset-enable 1", True),
        ("net torch:offset => axis.x.eoffset-counts", True),
        ("net torch:on axis.x.eoffset-enable", True),
        ("setp axis.x.eoffset-enable 0", False),
        ("# setp axis.x.eoffset-enable 1", False),
        ("setp axis.z.eoffset-enable 1", False),
    ],
)
def test_an_external_offset_of_the_axis_is_not_overlooked(
    line: str, *, declined: bool, tmp_path: Path
) -> None:
    """eoffset-counts times eoffset-scale is added to the position while enabled (motion(9))."""
    (tmp_path / "mill.ini").write_text(INI.format(more=""), encoding="utf-8")
    (tmp_path / "comp.hal").write_text("loadrt [KINS]KINEMATICS\n" + line + "\n", encoding="utf-8")
    write_csv(tmp_path / "x.csv", "X", measure(Axis()))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: [mill.ini, comp.hal]}\n"
        "axes:\n  X: {travel: [0, 600], address: 0, before: [x.csv]}\n",
        encoding="utf-8",
    )
    answer = command("run", tmp_path / "job.yaml")
    assert (answer.code == REFUSED) == declined, answer.first
    assert not declined or answer.names("comp.hal: line 2", "eoffset-enable")


def test_verify_without_a_plan_names_the_option(tmp_path: Path) -> None:
    path = job(tmp_path, World().control(), {"P.MPF": program(ALL)}, "[P.MPF]")
    answer = command("verify", path, "--after", tmp_path / "x.csv")
    assert answer.code == REFUSED
    assert answer.names("--plan")
