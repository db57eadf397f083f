"""SINUMERIK: a state that is a program. Whatever may keep a value from being carried out is asked
about or refused with its line, by each reader on its own; exports of the control are not.

The statements are those of the part-program language (programming manual Job Planning: jumps,
branches, loops, calls, synchronised actions, interrupts, block skip).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.sinumerik.flow import ProgramBlock
from compwright.controllers.sinumerik.text import read_file
from compwright.controllers.virtual_control import virtual_control
from compwright.formats.families.activity import Activity
from compwright.formats.families.pairs.program_flow import scanned
from compwright.formats.families.shapes import control_format
from compwright.formats.text.container import opened
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from format_samples import SIEMENS, axis_of
from harm_sinumerik import Control
from sinumerik_archive import ARCHIVE, needs_archive

pytestmark = pytest.mark.short_estimate

ROWS = "".join(
    f"$AA_ENC_COMP[0,{index},AX1]={value}\n"
    for index, value in enumerate(("0", "0.004", "-0.006", "0.003", "0.001"))
)
GRID = (
    "$AA_ENC_COMP_STEP[0,AX1]=100\n$AA_ENC_COMP_MIN[0,AX1]=0\n$AA_ENC_COMP_MAX[0,AX1]=400\n"
    "$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n"
)
OFF, ON = "$MA_ENC_COMP_ENABLE[0,AX1]=0\n", "$MA_ENC_COMP_ENABLE[0,AX1]=1\n"
TABLE = ROWS + GRID
PLAY = "$MA_BACKLASH[0,AX1]=0.002\n"

Reader = Callable[..., object]


def by_writer(text: str, active: bool | None = None, name: str = "LOAD.MPF") -> object:
    """The reader of the room that writes."""
    file = ControlFile(name, text.encode())
    activity = Activity(stated=active, asking=True, carried_out=active is True)
    axes = [axis_of("AX1", system=2 if "[1,0,AX1]" in text else 1)]
    return control_format(SIEMENS, {}).read([file], axes, activity=activity)


def by_judge(text: str, active: bool | None = None, name: str = "LOAD.MPF") -> object:
    """The judge's reader."""
    file = ControlFile(name, text.encode())
    return virtual_control(
        "siemens-840d-sl",
        [file],
        active=active,
        carried_out=active is True,
        axes_under_work=("AX1",),
    )


def judged(file: ControlFile) -> list[ProgramBlock]:
    """What the judge finds beside the values of a file."""
    return read_file(file).blocks


READERS = [pytest.param(by_writer, id="writer"), pytest.param(by_judge, id="judge")]

#: What can keep the values from being carried out, around them or before them.
FLOW = {
    "if": "IF R50==1\n{}ENDIF\n",
    "if with words": "N10 IF (R50 == 1) AND NOT $P_SEARCH\n{}N20 ENDIF\n",
    "else": "IF R50==1\nMSG(\"A\")\nELSE\n{}ENDIF\n",
    "gotof": "GOTOF ENDE\n{}ENDE:\n",
    "conditional gotof": "IF R50<>1 GOTOF ENDE\n{}ENDE:\n",
    "goto": "GOTO ENDE\n{}ENDE:\n",
    "gotoc": "GOTOC ENDE\n{}ENDE:\n",
    "gotob": "ANFANG:\nIF R1<3 GOTOB ANFANG\n{}",
    "gotos": "IF R1==0 GOTOS\n{}",
    "gotof block number": "N10 GOTOF N99\n{}N99 STOPRE\n",
    "case": "CASE R50 OF 1 GOTOF EINS DEFAULT GOTOF ENDE\nEINS:\n{}ENDE:\n",
    "for": "FOR R1=1 TO R2\n{}ENDFOR\n",
    "while": "WHILE R1<R2\n{}R1=R1+1\nENDWHILE\n",
    "loop": "LOOP\n{}GOTOF ENDE\nENDLOOP\nENDE:\n",
    "repeat until": "REPEAT\n{}UNTIL R1==1\n",
    "repeat label": "REPEAT EINS ZWEI P=2\n{}",
    "repeatb": "REPEATB EINS\n{}",
    "call": 'CALL "/_N_CMA_DIR/_N_ANDERE_SPF"\n{}',
    "call glued": 'CALL"_N_ANDERE_SPF"\n{}',
    "call block": 'CALL BLOCK EINS TO ZWEI\n{}',
    "pcall": 'PCALL /_N_CMA_DIR/_N_ANDERE_SPF(1)\n{}',
    "isocall": 'ISOCALL "O1000"\n{}',
    "extcall": 'EXTCALL("ANDERE")\n{}',
    "modal call": "MCALL ANDERE\n{}",
    "l100": "L100\n{}",
    "l100 repeated": "N5 L100 P3\n{}",
    "by name": "LADEN_AX1\n{}",
    "by name with arguments": 'LADEN_AX1(1,"X")\n{}',
    "function in an assignment": "R1=PRUEFE(3)\n{}",
    "function in an index": "R[PRUEFE(3)]=1\n{}",
    "execstring": 'EXECSTRING("L100")\n{}',
    "exectab": "EXECTAB\n{}",
    "whenever": "WHENEVER $AC_TIMER[1]>5 DO $A_OUT[1]=1\n{}",
    "modal action": "ID=1 EVERY $A_IN[1]==1 DO L100\n{}",
    "setint": "SETINT(1) PRIO=1 ANDERE\n{}",
    "channel": 'INIT(2,"/_N_MPF_DIR/_N_X_MPF")\nSTART(2)\n{}',
    "wait": "WAITM(1,1,2)\n{}",
    "stop": "M0\n{}",
    "optional stop": "M1\n{}",
    "alarm": "SETAL(61000)\n{}",
    "end on a condition": "IF R50==0\nM17\nENDIF\n{}",
    "return on a condition": "IF R50==0\nRET\nENDIF\n{}",
    "skipped jump": "/GOTOF ENDE\n{}ENDE:\n",
    "skipped end": "/1 M30\n{}",
    "macro": "DEFINE LADE AS L100\n{}",
    "parameters": "PROC LADEN(INT NR)\n{}",
    "procedure": "PROC LADEN SAVE DISPLOF\n{}",
    "tool": "T=1\n{}",
    "m function": "M=30+R1\n{}",
    "motion": "G0 X100\n{}",
    "unknown": "ZZTOP 7\n{}",
}  # fmt: skip
#: Those of them that lead past every value, whatever the program meets.
PASSED_OVER = {"gotof", "goto", "gotoc", "gotof block number"}
#: Blocks behind the last value, and what leaves the order of the blocks alone.
HARMLESS = {
    "flow behind the values": '{}IF R50==1\nMSG("fertig")\nENDIF\nL100\nGOTOB ENDE\nM0\n',
    "a label": "ANFANG:\n{}",
    "messages and stops of look-ahead": 'MSG("Tabelle; laden"<<R1)\nSTOPRE\nNEWCONF\nG4 F1\nG4F5\n{}MSG()\n',
    "definitions": 'DEF REAL _WERT=1.5,_B[2,3]\nDEF STRING[20] _TEXT="a"\nEXTERN PRUEFE(REAL)\n{}',
    "r parameters": "R50=1\nR1=R2*(R3+SIN(30))/2\nR[7]=-1.5EX-3\n{}",
    "user data": '_WP[1,2]=-9\nS_TXT[3]=""\n$P_UIFR[1]=CTRANS(X,10):CROT(Z,45)\n{}',
    "g words": "G71 G90\nG17G40\nN10 G500\n{}",
    "a path": ";$PATH=/_N_MPF_DIR\n$PATH=/_N_MPF_DIR\n{}",
    "other machine data": "N10000 $MN_AXCONF_MACHAX_NAME_TAB[5]=\"\"\n$MN_INIT_MD='H2f'\n$TC_DP1[1,1]=120\n{}",
    "checksums": "N14510 $MN_USER_DATA_INT[0]=1 '0a1b\n{}",
}  # fmt: skip


def whole(form: str) -> str:
    return "%_N_LOAD_MPF\nCHANDATA(1)\n" + form.format(TABLE + PLAY + ON) + "M17\n"


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", FLOW)
def test_what_may_leave_values_out_is_asked_about_with_its_line(kind: str, read: Reader) -> None:
    text = whole(FLOW[kind])
    with pytest.raises(UsageError) as asked:
        read(text, None)
    fault = asked.value.faults[0]
    line = next(
        number
        for number, code in enumerate(text.splitlines(), start=1)
        if number > 2 and not re.match(r"\w+:$|MSG|R1=R1", code)
    )
    assert (fault.file, fault.place) == ("LOAD.MPF", f"line {line}")
    assert "active: yes" in fault.expected
    if kind in PASSED_OVER:
        with pytest.raises(InputError) as refused:  # no run of the program comes to a value
            read(text, True)
        assert refused.value.faults[0].place == f"line {line + 1}"
    else:
        read(text, True)  # every value statement was carried out


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", HARMLESS)
def test_what_leaves_the_values_alone_is_not_asked_about(kind: str, read: Reader) -> None:
    read(whole(HARMLESS[kind]), None)


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize(
    "end", ["M17", "N90 M30", "M2", "M02", "RET", "G4 F1 M30", 'MSG("") M17'], ids=str
)
def test_values_behind_the_end_are_refused(end: str, read: Reader) -> None:
    for answer in (None, True):
        with pytest.raises(InputError) as refused:
            read(f"{ON}{PLAY}{end}\n{TABLE}M17\n", answer)
        assert "line 4" in {fault.place for fault in refused.value.faults}


@pytest.mark.parametrize("read", READERS)
def test_a_second_program_of_one_file_begins_anew(read: Reader) -> None:
    other = TABLE.replace("AX1", "AX2")
    read(f"%_N_A_MPF\n{other}M17\n%_N_B_INI\n{TABLE}{PLAY}{ON}M17\n", None)
    text = f"%_N_A_MPF\nIF R1==1\n{other}ENDIF\nM17\n%_N_B_INI\n{TABLE}{PLAY}{ON}M17\n"
    read(text, None)  # of another axis alone
    with pytest.raises(UsageError):
        read(text.replace("AX2", "AX1").replace(TABLE + PLAY, PLAY), None)


VALUES = TABLE + PLAY + ON + "M17\n"
#: Programs that act only where another one, or somebody, calls or starts them: the name of the
#: file, the text, and the line that shows it.
CALLED = {
    "header": ("EEC.INI", f"%_N_L100_SPF\n{VALUES}", 1),
    "header behind comments": ("EEC.INI", f"; A\n%_n_komp_x_spf\nCHANDATA(1)\n{VALUES}", 2),
    "procedure": ("EEC.INI", f"; A\nN5 PROC L100 DISPLOF\n{VALUES}", 2),
    "procedure with an argument": ("EEC.INI", f"PROC KOMP(REAL _F)\n{VALUES}", 1),
    "name of the file": ("KOMP.SPF", VALUES, 1),
    "skipped call": (
        "EEC.INI",
        f"%_N_M_MPF\nIF R1==0 GOTOF E\nL100\nE:\nM30\n%_N_L100_SPF\nPROC L100\n{VALUES}",
        6,
    ),
    "never called": ("EEC.INI", f"%_N_M_MPF\nR1=0\nM30\n%_N_L100_SPF\n{VALUES}", 4),
    "second main program": ("A.MPF", f"%_N_A_MPF\nR1=0\nM30\n%_N_B_MPF\n{VALUES}", 4),
    "behind one without header": ("A.MPF", f"R1=0\nM30\n%_N_B_MPF\n{VALUES}", 3),
    "behind exported data": (
        "A.INI",
        f"$MN_USER_DATA_INT[0]=1\n%_N_B_MPF\n{VALUES}",
        2,
    ),
}


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", CALLED)
def test_a_program_that_something_has_to_call_is_asked_about(kind: str, read: Reader) -> None:
    name, text, line = CALLED[kind]
    with pytest.raises(UsageError) as asked:
        read(text, None, name)
    fault = asked.value.faults[0]
    assert (fault.file, fault.place) == (name, f"line {line}")
    assert "active: yes" in fault.expected
    read(text, True, name)


@pytest.mark.parametrize("read", READERS)
def test_exported_data_are_not_called(read: Reader) -> None:
    for header in ("AX_EEC_INI", "INITIAL_INI", "COMPLETE_TEA", "AX1_EEC"):
        read(f"%_N_O1_MPF\nG0 X0\nM30\n%_N_{header}\n;$PATH=/_N_X_SPF\n{VALUES}", None)
        read(f"%_N_{header}\nCHANDATA(1)\n{VALUES}%_N_L1_SPF\nPROC L1\nL2\nM17\n", None)


@pytest.mark.parametrize("read", READERS)
def test_a_switch_before_the_flow_of_a_subprogram_is_a_sequence(read: Reader) -> None:
    text = f"{PLAY}{OFF}NEWCONF\nIF R50==0 GOTOF ENDE\n{TABLE}{ON}NEWCONF\nENDE:\nM17\n"
    read(f"%_N_L100_SPF\nPROC L100\n{text}", True)


BRANCHES = {
    "if and else": "IF R50==1\n{one}ELSE\n{two}ENDIF\n",
    "two conditions": "IF R50==1\n{one}ENDIF\nIF R50==2\n{two}ENDIF\n",
    "case": "CASE R50 OF 1 GOTOF A 2 GOTOF B\nA:\n{one}GOTOF C\nB:\n{two}C:\n",
    "jumps": "IF R50==1 GOTOF B\n{one}GOTOF C\nB:\n{two}C:\n",
    "inside of branches": "IF R1==1\nIF R50==1\n{one}ELSE\n{two}ENDIF\nENDIF\n",
}


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", BRANCHES)
def test_one_entry_in_two_branches_is_refused_with_both_lines(kind: str, read: Reader) -> None:
    one, two = "$MA_BACKLASH[0,AX1]=0.01\n", "$MA_BACKLASH[0,AX1]=0.02\n"
    text = TABLE + OFF + BRANCHES[kind].format(one=one, two=two) + ON + "M17\n"
    lines = text.splitlines(keepends=True)
    with pytest.raises(InputError) as refused:
        read(text, True)
    (fault,) = refused.value.faults
    assert fault.place == f"line {lines.index(two) + 1}"
    assert f"line {lines.index(one) + 1}" in fault.message


@pytest.mark.parametrize("read", READERS)
def test_a_switch_before_the_flow_and_in_it_is_a_sequence(read: Reader) -> None:
    text = f"{PLAY}{OFF}NEWCONF\nIF R50==0 GOTOF ENDE\n{TABLE}{ON}NEWCONF\nENDE:\nM30\n"
    read(text, True)


@pytest.mark.parametrize("read", READERS)
def test_the_exponent_of_the_language_is_read(read: Reader) -> None:
    """1.5EX-2 is 1.5 * 10^-2 (programming manual Fundamentals: assignments)."""
    text = (OFF + TABLE + PLAY + ON).replace("=0.004", "=4EX-3").replace("=-0.006", "=-.6ex-2")
    text = text.replace("[0,AX1]=100\n", "[0,AX1]=1EX2\n").replace("=400", "=+4.0EX+2") + "M17\n"
    control: Any = read(text)
    nodes = np.arange(0.0, 401.0, 100.0)
    if read is by_writer:
        adds = control.axes["AX1"].at(nodes, Direction.POSITIVE)
    else:
        adds = control.correction("AX1", nodes, Direction.POSITIVE)
    assert np.allclose(adds, [0.0, -0.004, 0.006, -0.003, -0.001], atol=1e-12)


def test_many_lines_of_one_fault_are_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = TABLE + PLAY + ON + "".join(f"/$AA_ENC_COMP[0,{i},AX1]=0.001\n" for i in range(5))
    assert run_with(tmp_path, text * 3 + "M17\n") == 3
    said = capsys.readouterr().err
    (line,) = [row for row in said.splitlines() if "cannot be read" in row]
    assert "line 12" in line
    assert "14 more such lines: 13, 14, 15, ..." in line


#: Values and indices that only the running program knows.
COMPUTED = {
    "expression": "$MA_BACKLASH[0,AX1]=R50*2",
    "parameter": "$AA_ENC_COMP[0,5,AX1]=R50",
    "index of an axis variable": "DEF AXIS _ACHSE=AX1\n$AA_ENC_COMP[0,5,_ACHSE]=0.001",
    "index of an assigned variable": "_ACHSE=AX1\n$AA_ENC_COMP[0,5,_ACHSE]=0.001",
    "parameter of the subprogram": "PROC P(AXIS AX)\n$AA_ENC_COMP[0,5,AX]=0.001",
    "parameter of the subprogram, later": (
        "PROC P(REAL V, VAR AXIS ACHSE, INT N=1) SAVE\n$MA_BACKLASH[0,ACHSE]=0.01"
    ),
    "variable of the whole control": "$MA_BACKLASH[0,_AX]=0.01",
    "index": "$AA_ENC_COMP[0,R1,AX1]=0.001",
    "calculated index": "$AA_ENC_COMP[0,R1+1,AX1]=0.001",
    "axis of a table": "$AN_CEC_INPUT_AXIS[0]=(R1)",
    "kind": "$MA_IS_ROT_AX[AX1]=R1",
    "unit": "$MN_SCALING_SYSTEM_IS_METRIC=_METRISCH",
    "kind in another form": "$MA_IS_ROT_AX[AX1]='O1'",
    "unit that is none": "$MN_SCALING_SYSTEM_IS_METRIC='H2'",
    "action": "WHENEVER $AA_IM[X]>5 DO $SN_CEC_TABLE_ENABLE[0]=1",
    "skipped": "/$MA_BACKLASH[0,AX1]=0.01",
    "skipped block": "/N10 $MA_BACKLASH[0,AX1]=0.01",
    "label": "EINS: $MA_BACKLASH[0,AX1]=0.01",
    "two": "$MA_BACKLASH[0,AX1]=0.01 $MA_BACKLASH[1,AX1]=0.02",
    "condition": "IF $MA_ENC_COMP_ENABLE[0,AX1]==1",
    "text that is carried out": 'EXECSTRING("$MA_BACKLASH[0,AX1]=0.01")',
}


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", COMPUTED)
def test_what_only_the_program_knows_is_refused_with_its_line(kind: str, read: Reader) -> None:
    text = f"{TABLE}{PLAY}{COMPUTED[kind]}\n{ON}M17\n"
    line = text.splitlines().index(COMPUTED[kind].splitlines()[-1]) + 1
    for answer in (None, True):
        with pytest.raises(InputError) as refused:
            read(text, answer)
        assert f"line {line}" in {fault.place for fault in refused.value.faults}


@pytest.mark.parametrize("value", ["'H1'", "'B1'", "1.0", "1EX0", "+1"])
def test_a_gantry_in_any_form_stops_a_table_for_one_axis(value: str) -> None:
    """MD37100: the other forms of the language for 1, the leading axis of group 1."""
    with pytest.raises(InputError) as refused:
        by_writer(f"{TABLE}{ON}$MA_GANTRY_AXIS_TYPE[AX1]={value}\nM17\n")
    assert {fault.place for fault in refused.value.faults} == {"line 11"}


NAMES = "".join(
    f'$MN_AXCONF_MACHAX_NAME_TAB[{place}]="{name}"\n' for place, name in enumerate(("X1", "Y1"))
)


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("name", ["CORRAX", "Y2"])
def test_a_name_that_md10000_does_not_have_may_be_a_variable(name: str, read: Reader) -> None:
    """A variable of type AXIS from another file, such as GUD, means any axis."""
    text = f"{NAMES}{TABLE}{PLAY}$MA_BACKLASH[0,NAME]=0.01\n{ON}M17\n"
    with pytest.raises(InputError) as refused:
        read(text.replace("NAME]", f"{name}]"))
    line = text.splitlines().index("$MA_BACKLASH[0,NAME]=0.01") + 1
    assert [fault.place for fault in refused.value.faults] == [f"line {line}"]
    for known in ("Y1", "AX2", "AX7"):
        read(text.replace("NAME]", f"{known}]"))


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("word", ["G70", "G700", "N10 G90 G700", "G90G70"])
def test_a_program_in_another_unit_than_the_control_is_refused(word: str, read: Reader) -> None:
    with pytest.raises(InputError) as refused:
        read(f"METRIC\n{word}\n{TABLE}{PLAY}{ON}M17\n", True)
    assert {fault.place for fault in refused.value.faults} == {"line 2"}
    read(f"INCH\n{word}\n{TABLE}{PLAY}{ON}M17\n", None)
    with pytest.raises(InputError):
        read(f"INCH\n{word.replace('70', '71')}\n{TABLE}{PLAY}{ON}M17\n", True)


@needs_archive
def test_the_data_of_a_real_archive_are_no_program() -> None:
    container, _ = opened(ControlFile("a.arc", ARCHIVE.read_bytes()))
    assert container is not None
    assert not [member for member in container.state if scanned(SIEMENS, member).leaves_out]
    assert not [block for member in container.state for block in judged(member) if block.doubts]


@needs_archive
@pytest.mark.parametrize("read", READERS)
def test_programs_of_a_real_machine(read: Reader) -> None:
    """Its maker's loaders are sequences; one works its values out, one calls the others by what the
    machine has.
    """
    container, _ = opened(ControlFile("a.arc", ARCHIVE.read_bytes()))
    assert container is not None
    texts = {
        one.name.rpartition("\\")[2]: one.content.decode("latin-1") for one in container.programs
    }
    read(texts["G_85.MPF"], None)
    assert texts["_2AT_KOMP.SPF"].splitlines()[86].startswith("$AN_CEC [6,9]     = R809+R9")
    with pytest.raises(InputError) as refused:
        read(texts["_2AT_KOMP.SPF"], True)
    assert "line 87" in {fault.place for fault in refused.value.faults}
    loaders = texts["G_85.MPF"].replace("M17", "") + texts["KOMPTABELLEN.MPF"]
    with pytest.raises(InputError):  # its conditions read what is compensation data
        read(texts["KOMPTABELLEN.MPF"], True)
    calls = "".join(line for line in loaders.splitlines(keepends=True) if "IF" not in line)
    read(calls, None)  # behind the last value
    with pytest.raises(UsageError):
        read(calls.split("M17")[0] + "$MA_ENC_COMP_ENABLE[1,AX1]=1\nM17\n", None)


# -- conditions that the program's own numbers decide
# --------------------------------------------------------------------------------------------------

#: Programs whose own assignments let no run carry out every value, whatever the control holds.
CONTRADICTED = {
    "copy": "R50=0\nR51=R50\nIF R51==1\n{}ENDIF\n",
    "difference": "R50=1-1\nIF R50==1\n{}ENDIF\n",
    "product": "R1=3\nR2=(R1-1)*2\nIF R2==4 GOTOF ENDE\n{}ENDE:\n",
    "quotients": "R1=7 DIV 2\nR2=R1 MOD 2+4/2\nIF R2<>3\n{}ENDIF\n",
    "definition": "DEF INT _A=1\nDEF BOOL _B\n_B=_A==0\nIF _B\n{}ENDIF\n",
    "other form of the name": "R[50]=0\nR51=R050\nIF R0051\n{}ENDIF\n",
    "case": "R50=2\nCASE R50 OF 1 GOTOF LADEN 2 GOTOF ENDE DEFAULT GOTOF LADEN\nLADEN:\n{}ENDE:\n",
    "default of a case": "R50=7\nCASE(R50-1) OF 1 GOTOF L1 DEFAULT GOTOF ENDE\nL1:\n{}ENDE:\n",
    "case of a number": "CASE 3 OF 1 GOTOF L1 -2 GOTOF L1 DEFAULT GOTOF ENDE\nL1:\n{}ENDE:\n",
    "for": "FOR R1=1 TO 0\n{}ENDFOR\n",
    "for with limits": "R2=4\nR3=R2-1\nFOR R1=R2 TO R3\n{}ENDFOR\n",
    "while": "R1=2\nWHILE R1-2\n{}ENDWHILE\n",
}
#: Programs beside them that a run may carry out in whole.
POSSIBLE = {
    "copy": "R51=R50\nIF R51==1\n{}ENDIF\n",
    "changed copy": "R50=0\nR51=R50\nR51=R52\nIF R51==1\n{}ENDIF\n",
    "changed first": "R50=1\nR51=R50\nR50=0\nIF R51==1\n{}ENDIF\n",
    "negative": "R1=1\nR2=-R1\nIF R2<>-1 GOTOF ENDE\n{}ENDE:\n",
    "half": "R50=1/2\nIF R50==0\n{}ENDIF\n",
    # "a fraction >= 0.5 is rounded up" (840D programming guide Advanced 04.00, p. 1-45)
    "rounded by its type": "DEF INT _A=1.5\nIF _A==2\n{}ENDIF\n",
    "rounded copy": "R1=1.5\nDEF INT _A\n_A=R1\nIF _A==2\n{}ENDIF\n",
    "rounded case": "R1=1.5\nCASE R1 OF 2 GOTOF L1 DEFAULT GOTOF ENDE\nL1:\n{}ENDE:\n",
    "operator": "R50=0\nM0\nR51=R50\nIF R51==1\n{}ENDIF\n",
    "case": "R50=2\nCASE R50 OF 1 GOTOF ENDE DEFAULT GOTOF LADEN\nLADEN:\n{}ENDE:\n",
    "case without the number": "R50=2\nCASE R50 OF 1 GOTOF ENDE 3 GOTOF ENDE\n{}ENDE:\n",
    "for": "FOR R1=1 TO 1\n{}ENDFOR\n",
    "for with an open end": "FOR R1=1 TO R2\n{}ENDFOR\n",
    "counted": "R1=0\nREPEAT\nR1=R1+1\nUNTIL R1==3\nIF R1==3\n{}ENDIF\n",
    "calculated by the control": "R50=$AA_IM[X]\nR51=R50\nIF R51==1\n{}ENDIF\n",
}


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", CONTRADICTED)
def test_yes_is_refused_where_the_numbers_of_the_program_contradict_it(
    kind: str, read: Reader
) -> None:
    text = whole(CONTRADICTED[kind])
    with pytest.raises(UsageError):
        read(text, None)
    with pytest.raises(InputError) as refused:
        read(text, True)
    first = 1 + text.splitlines().index(ROWS.splitlines()[0])
    assert refused.value.faults[0].place == f"line {first}"


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize("kind", POSSIBLE)
def test_yes_is_taken_where_the_numbers_of_the_program_allow_it(kind: str, read: Reader) -> None:
    read(whole(POSSIBLE[kind]), True)


@pytest.mark.parametrize("read", READERS)
@pytest.mark.parametrize(
    "form",
    [
        f"IF R1{'+1' * 1200}==3\n",
        f"IF R1=={'-' * 1200}3\n",
        f"IF {'NOT ' * 1200}R1\n",
        f"IF {' OR '.join(['(R1==2)'] * 1200)}\n",
    ],
    ids=["sum", "signs", "negations", "alternatives"],
)
def test_a_condition_of_thousands_of_words_is_not_worked_out(form: str, read: Reader) -> None:
    text = whole(f"R1=1\n{form}{{}}ENDIF\n")
    with pytest.raises(UsageError):
        read(text, None)
    read(text, True)


def test_a_superscript_is_no_number_of_a_parameter() -> None:
    text = whole("R[\u00b2]=1\nIF R1==1\n{}ENDIF\n")
    judged(ControlFile("LOAD.MPF", text.encode("latin-1")))


def _sum_of(rng: np.random.Generator, depth: int = 0) -> str:
    if depth > 1 or rng.random() < 0.4:
        return str(rng.choice(["0", "1", "2", "3", "R1", "R2", "R3"]))
    left, right = _sum_of(rng, depth + 1), _sum_of(rng, depth + 1)
    sign = rng.choice(["+", "-", "*"])
    return f"({left}{sign}{right})" if rng.random() < 0.5 else f"{left}{sign}{right}"


def _program_of(rng: np.random.Generator, *, closed: bool) -> str:
    """Return a program of assignments and forks around five values, each once; ``closed``: it sets
    every variable before it uses it.
    """
    rows = [f"R{n}={rng.integers(0, 3)}" for n in (1, 2, 3) if closed or rng.random() < 0.5]
    for number, value in enumerate(ROWS.splitlines()):
        if rng.random() < 0.5:
            rows.append(f"R{rng.integers(1, 4)}={_sum_of(rng)}")
        sign = rng.choice(["==", "<>", "<", ">="])
        condition = f"{_sum_of(rng)}{sign}{_sum_of(rng)}"
        first, last = _sum_of(rng), _sum_of(rng)
        rows += {
            0: [f"IF {condition}", value, "ENDIF"],
            1: [f"IF {condition} GOTOF PAST{number}", value, f"PAST{number}:"],
            2: [f"FOR R9={first} TO {last}", value, "ENDFOR"],
            3: [
                f"CASE {_sum_of(rng)} OF 0 GOTOF PAST{number} 1 GOTOF TO{number}",
                *([f"TO{number}:", value] if rng.random() < 0.5 else [value, f"TO{number}:"]),
                f"PAST{number}:",
            ],
        }.get(int(rng.integers(0, 9)), [value])
    return "\n".join(rows) + "\n"


def _carried_out(text: str, parameters: dict[str, float]) -> bool:
    """Whether a control with these R parameters carries out every value of a program."""
    control = Control(memory=dict(parameters))
    return control.load(text) and all(
        row.split("=")[0] in control.memory for row in ROWS.splitlines()
    )


@pytest.mark.parametrize("read", READERS)
def test_random_programs_against_a_control_that_carries_them_out(read: Reader) -> None:
    """The interpreter shares nothing with the readers. ``active: yes`` is never refused where a
    control with some R parameters carries out every value; where a program sets all of its
    variables itself, it is refused exactly if a control leaves a value out.
    """
    rng = np.random.default_rng(23)
    counts = {True: 0, False: 0}
    for turn in range(160):
        closed = turn % 2 == 0
        text = _program_of(rng, closed=closed)
        worlds = rng.integers(-2, 4, (1 if closed else 200, 3)).astype(float)
        try:
            read(text + GRID + PLAY + ON + "M17\n", True)
            taken = True
        except InputError:
            taken = False
        if closed or not taken:
            possible = any(
                _carried_out(text, dict(zip(("R1", "R2", "R3"), row, strict=True)))
                for row in np.unique(worlds, axis=0).tolist()
            )
            assert taken == possible, text
        counts[taken] += 1
    assert min(counts.values()) > 30


# -- through the commands
# --------------------------------------------------------------------------------------------------


def measured(path: Path) -> Path:
    """A test of five runs: a bow of 20 µm."""
    rows = [
        f"{x},{way},{run},{x * (400 - x) / 2000 + (0.3 if way == '-' else 0) + 0.1 * (run % 3)}"
        for x in (20, 100, 180, 220, 300, 380)
        for way in "+-"
        for run in range(1, 6)
    ]
    path.write_text("target_mm,direction,run,deviation_um\n" + "\n".join(rows) + "\n")
    return path


def run_with(folder: Path, text: str, *more: str) -> int:
    (folder / "LOAD.MPF").write_text(text)
    test = measured(folder / "x.csv")
    state = ["--state", str(folder / "LOAD.MPF"), "--out", str(folder / "out")]
    axis = ["--axis", "X", "--travel", "0:400", "--option", "address=AX1"]
    given = ["run", str(test), "--format", "siemens-840d-sl", *axis, *state, *more, "--force"]
    return compwright(given)


@pytest.mark.full_estimate
def test_a_program_as_state_of_a_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Asked for (2), with the line; every value carried out: a table in files of their own, because
    what is patched in the program may not be carried out.
    """
    text = whole(FLOW["if"])
    assert run_with(tmp_path, text) == 2
    assert "LOAD.MPF: line 3" in capsys.readouterr().err
    assert not (tmp_path / "out" / "tables").exists()
    assert run_with(tmp_path, text, "--option", "active=yes") in (0, 1)
    written = {file.name for file in (tmp_path / "out" / "tables" / "siemens-840d-sl").iterdir()}
    assert written == {"AX1_EEC.INI", "AX1_MD.INI"}
    capsys.readouterr()
    assert run_with(tmp_path, text, "--option", "active=yes", "--option", "files=patched") == 2
    assert "LOAD.MPF" in capsys.readouterr().err


@pytest.mark.full_estimate
def test_a_subprogram_as_state_of_a_run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Beside a main program that never calls it: asked for (2), and no table."""
    (tmp_path / "MAIN.MPF").write_text("%_N_MAIN_MPF\nR1=0\nM30\n")
    main = ["--state", str(tmp_path / "MAIN.MPF")]
    text = f"%_N_L100_SPF\nPROC L100 SAVE\n{VALUES}"
    assert run_with(tmp_path, text, *main) == 2
    assert "LOAD.MPF: line 1" in capsys.readouterr().err
    assert not (tmp_path / "out" / "tables").exists()
    assert run_with(tmp_path, text, *main, "--option", "active=yes") in (0, 1)
    written = {file.name for file in (tmp_path / "out" / "tables" / "siemens-840d-sl").iterdir()}
    assert written == {"AX1_EEC.INI", "AX1_MD.INI"}


def test_decode_and_new_ask_too(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program = tmp_path / "LOAD.MPF"
    program.write_text(whole(FLOW["case"]))
    job = tmp_path / "job.yaml"
    commands = (
        ["decode", str(program), "--format", "siemens-840d-sl"],
        ["new", "--from", str(program), "--format", "siemens-840d-sl", "--out", str(job)],
    )
    for command in commands:
        assert compwright(command) == 2
        assert "line 3" in capsys.readouterr().err
        assert compwright([*command, "--option", "active=yes"]) == 0
    assert "active: yes" in job.read_text()
