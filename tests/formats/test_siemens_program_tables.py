"""SINUMERIK: programs and what is expected of a reader, each by both readers.

From the programming manual (Job Planning): GOTOF searches its label towards the end of the program,
GOTOB towards the start, GOTO and GOTOC first towards the end and then elsewhere; GOTOC goes on with
the next block where there is none, the others stop with an alarm. ``M2=3`` is M3 of spindle 2; the
end words are M2, M17, M30 and RET. A subprogram is called by its name and comes back with M17,
M30 or RET.
"""

from __future__ import annotations

import operator
import re
from collections import Counter
from collections.abc import Mapping

import numpy as np
import pytest

from compwright.controllers.virtual_control import virtual_control
from compwright.formats.families.activity import Activity
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError, UsageError
from compwright.records.correction import ControlFile
from format_samples import SIEMENS, axis_of

pytestmark = pytest.mark.short_estimate

GRID = (
    "$AA_ENC_COMP_STEP[0,AX1]=100\n$AA_ENC_COMP_MIN[0,AX1]=0\n$AA_ENC_COMP_MAX[0,AX1]=100\n"
    "$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n$AA_ENC_COMP[0,0,AX1]=0\n"
)
ONE, TWO, NONE = (f"$AA_ENC_COMP[0,1,AX1]={value}\n" for value in ("0.004", "0.009", "-0.0"))
PLAY = "$MA_BACKLASH[0,AX1]=0.002\n"
ON, OFF = "$MA_ENC_COMP_ENABLE[0,AX1]=1\n", "$MA_ENC_COMP_ENABLE[0,AX1]=0\n"

READ = ""


def by_writer(files: list[ControlFile], active: bool | None) -> None:
    """The reader of the room that writes."""
    control = control_format(SIEMENS, {})
    if active is False:
        files = list(control.listing.executed(control.definition, files)[0])
    if files:
        activity = Activity(stated=active, asking=True, carried_out=active is True)
        control.read(files, [axis_of("AX1")], activity=activity)


def by_judge(files: list[ControlFile], active: bool | None) -> None:
    """The judge's reader."""
    virtual_control(
        "siemens-840d-sl",
        files,
        active=active,
        carried_out=active is True,
        axes_under_work=("AX1",),
    )


def answer(files: Mapping[str, str], active: bool | None, *, judge: bool) -> list[str]:
    """What is asked (?) or refused (!), with file and line; empty for what is read."""
    given = [ControlFile(name, text.encode()) for name, text in files.items()]
    try:
        (by_judge if judge else by_writer)(given, active)
    except UsageError as asked:
        return [f"? {fault.file} {fault.place}: {fault.expected}" for fault in asked.faults]
    except InputError as refused:
        return [f"! {fault.file} {fault.place}: {fault.message}" for fault in refused.faults]
    return []


def check(files: Mapping[str, str], active: bool | None, expected: str, *, judge: bool) -> None:
    found = answer(files, active, judge=judge)
    if expected == READ:
        assert not found
    else:
        assert any(one.startswith(f"{expected}:") for one in found), found


#: Programs of which the job says that no value was carried out, and the first line of a fault.
NOTHING = {
    "either side of a branch": (f"IF R1==1\n{ONE}ELSE\n{TWO}ENDIF\n{GRID}", "! A.MPF line 2"),
    "either side of a jump": (
        f"IF R1==1 GOTOF BB\n{ONE}GOTOF CC\nBB:\n{TWO}CC:\n{GRID}",
        "! A.MPF line 2",
    ),
    "every way of a case": (
        f"CASE R1 OF 1 GOTOF AA DEFAULT GOTOF BB\nAA:\n{ONE}GOTOF CC\nBB:\n{PLAY}CC:\n{GRID}",
        "! A.MPF line 3",
    ),
    "nested branches": (
        f"IF R1==1\nIF R2==1\n{ONE}ELSE\n{TWO}ENDIF\nELSE\n{PLAY}ENDIF\n{GRID}",
        "! A.MPF line 3",
    ),
    "one way of a case without": (
        f"CASE R1 OF 1 GOTOF AA DEFAULT GOTOF CC\nAA:\n{ONE}CC:\n{GRID}",
        READ,
    ),
    "zero on one side": (f"IF R1==1\n{ONE}ELSE\n{NONE}ENDIF\n{GRID}", READ),
    "a loop that may be left out": (f"WHILE R1<3\n{ONE}R1=R1+1\nENDWHILE\n{GRID}", READ),
    "a loop that is carried out once": (
        f"IF R9==1\nR8=1\nENDIF\nREPEAT\n{ONE}R1=R1+1\nUNTIL R1>3\n{GRID}",
        "! A.MPF line 5",
    ),
    "a jump past the value to the second label": (
        f"IF R1==1 GOTOB EE\nGOTOF EE\n{ONE}EE:\n{GRID}",
        READ,
    ),
    "a jump back to a value": (
        f"GOTOF EE\nAA:\n{ONE}{GRID}M17\nEE:\nR1=1\nGOTOB AA\n",
        "! A.MPF line 3",
    ),
    "no label behind": (f"AA:\nIF R1==1 GOTOF AA\n{ONE}{GRID}", READ),
    "GOTOC without a label": (f"IF R1==1\nR2=1\nENDIF\nGOTOC AA\n{ONE}{GRID}", "! A.MPF line 5"),
    "a condition twice, then its other side": (
        f"IF R1==1\n{ONE}ELSE\nM8\nENDIF\nIF R1==1\nM9\nELSE\n{TWO}ENDIF\n{GRID}",
        "! A.MPF line 2",
    ),
    "a condition and its opposite": (
        f"IF R1==1\n{ONE}ENDIF\nG4 F1\nIF (R1 <> 1)\n{TWO}ENDIF\n{GRID}",
        "! A.MPF line 2",
    ),
    "a comparison and the rest": (
        f"IF R1>=5\n{ONE}ENDIF\nIF R1>2.5\nR9=1\nELSE\n{TWO}ENDIF\nIF R1<5\n{PLAY}ENDIF\n{GRID}",
        "! A.MPF line 2",
    ),
    "two jumps that belong together": (
        f"IF R1==1 GOTOF AA\n{ONE}AA:\nIF R1<>1 GOTOF BB\n{TWO}BB:\n{GRID}",
        "! A.MPF line 2",
    ),
    "a whole condition and its opposite": (
        f"IF R1==1 AND R2==1\n{ONE}ENDIF\nIF NOT (R1==1 AND R2==1)\n{TWO}ENDIF\n{GRID}",
        "! A.MPF line 2",
    ),
    "a flag": (
        f"DEF BOOL FLAG\nIF NOT FLAG\n{ONE}ENDIF\nIF FLAG==TRUE\n{TWO}ENDIF\n{GRID}",
        "! A.MPF line 3",
    ),
    "a condition twice": (f"IF R1==1\n{ONE}ENDIF\nIF R1==1\nM8\nENDIF\n{GRID}", READ),
    "conditions of two variables": (
        f"IF R1==1\n{ONE}ENDIF\nIF R2<>1\n{TWO}ENDIF\n{GRID}",
        READ,
    ),
    "a variable that is assigned between": (
        f"IF R1==1\n{ONE}ENDIF\nR1=1\nIF R1<>1\n{TWO}ENDIF\n{GRID}",
        READ,
    ),
    "a call between, which may assign it": (
        f"IF R1==1\n{ONE}ENDIF\nABCD\nIF R1<>1\n{TWO}ENDIF\n{GRID}",
        READ,
    ),
    "a loop that assigns it": (
        f"REPEAT\nIF R1==1\n{ONE}ENDIF\nR1=R1+1\nUNTIL R1<>1\n{GRID}",
        READ,
    ),
    "an input of the control": (
        f"IF $A_IN[1]==1\n{ONE}ENDIF\nIF $A_IN[1]<>1\n{TWO}ENDIF\n{GRID}",
        READ,
    ),
    "before an endless loop": (f"LOOP\nR1=R1+1\nENDLOOP\n{ONE}{GRID}", READ),
}


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
@pytest.mark.parametrize("case", NOTHING)
def test_nothing_carried_out_is_believed_where_it_can_be(case: str, *, judge: bool) -> None:
    text, expected = NOTHING[case]
    check({"A.MPF": text + "M17\n"}, False, expected, judge=judge)


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
def test_a_program_of_the_files_may_assign_a_variable(*, judge: bool) -> None:
    """A call between two conditions, of a program that comes back."""
    main = f"IF R1==1\n{ONE}ENDIF\nCHANGES\nIF R1<>1\n{TWO}ENDIF\n{GRID}M17\n"
    files = {"A.MPF": main, "CHANGES.SPF": "R1=1\nM17\n"}
    check(files, False, READ, judge=judge)


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
def test_every_line_of_a_choice_is_named(*, judge: bool) -> None:
    text = f"IF R1==1\n{ONE}ELSE\n{TWO}ENDIF\n{GRID}M17\n"
    (fault,) = answer({"A.MPF": text}, False, judge=judge)
    assert "line 2: " in fault
    assert "line 4" in fault


#: Programs that assign the variable of a condition themselves: by name, the program, what `yes` and
#: what `no` gets.
ASSIGNED = {
    "switched off before": (f"R50=0\nIF R50==1\n{ONE}ENDIF\n{GRID}", "! A.MPF line 3", READ),
    "switched on before": (f"R50=1\nIF R50==1\n{ONE}ENDIF\n{GRID}", READ, "! A.MPF line 3"),
    "as a field": (f"R[50]=0\nIF R50==1\n{ONE}ENDIF\n{GRID}", "! A.MPF line 3", READ),
    "the last assignment counts": (
        f"R50=1\nR50=0\nIF R50==1\n{ONE}ENDIF\n{GRID}",
        "! A.MPF line 4",
        READ,
    ),
    "a field over the name": (
        f"R50=0\nR[50]=1\nIF R50==1\n{ONE}ENDIF\n{GRID}",
        READ,
        "! A.MPF line 4",
    ),
    "a flag": (f"DEF BOOL LOAD=FALSE\nIF LOAD\n{ONE}ENDIF\n{GRID}", "! A.MPF line 3", READ),
    "one of two variables": (
        f"DEF INT FIRST, KIND=2\nIF KIND<2 GOTOF AA\n{GRID}AA:\nIF FIRST>0\n{ONE}ENDIF\n{PLAY}",
        "! A.MPF line 10",
        "! A.MPF line 12",
    ),
    "a jump": (f"R50=0\nIF R50==0 GOTOF AA\n{ONE}AA:\n{GRID}", "! A.MPF line 3", READ),
    "in a branch of another": (
        f"R50=0\nIF R1==1\nR50=2\nENDIF\nIF R50==1\n{ONE}ENDIF\n{GRID}",
        "!",
        READ,
    ),
    "never": (f"IF 1==0\n{ONE}ENDIF\n{GRID}", "! A.MPF line 2", READ),
    "never, by a word": (f"IF FALSE\n{ONE}ENDIF\n{GRID}", "! A.MPF line 2", READ),
    "always": (f"IF NOT FALSE\n{ONE}ENDIF\n{GRID}", READ, "! A.MPF line 2"),
    "one of two": (f"R50=0\nIF (R50==1) OR (R50==2)\n{ONE}ENDIF\n{GRID}", "! A.MPF line 3", READ),
    "both": (f"R50=1\nIF (R50==1) AND (R51==2)\n{ONE}ENDIF\n{GRID}", READ, READ),
    "not both": (f"R50=0\nIF (R50==1) AND (R51==2)\n{ONE}ENDIF\n{GRID}", "! A.MPF line 3", READ),
    "without brackets": (f"R50=2\nIF R50==1 OR R50\n{ONE}ENDIF\n{GRID}", READ, READ),
    # AND before XOR, XOR before OR; two comparisons in one row: no answer
    "with XOR": (f"R50=0\nIF R50 AND R51 XOR R52\n{ONE}ENDIF\n{GRID}", READ, READ),
    "compared twice": (f"R50=0\nIF R50<2<1\n{ONE}ENDIF\n{GRID}", READ, READ),
    "perhaps in a branch": (
        f"R50=0\nIF R1==1\nR50=1\nENDIF\nIF R50==1\n{ONE}ENDIF\n{GRID}",
        READ,
        READ,
    ),
    "by another variable": (f"R50=R49\nIF R50==1\n{ONE}ENDIF\n{GRID}", READ, READ),
    "by a sum": (f"R50=0\nR50=R50+1\nIF R50==1\n{ONE}ENDIF\n{GRID}", READ, "! A.MPF line 4"),
    "in a block that may be skipped": (f"R50=1\n/R50=0\nIF R50==1\n{ONE}ENDIF\n{GRID}", READ, READ),
    "in a stop": (f"R50=0\nM0\nIF R50==1\n{ONE}ENDIF\n{GRID}", READ, READ),
    "by a program that is not given": (f"R50=0\nABCD\nIF R50==1\n{ONE}ENDIF\n{GRID}", READ, READ),
    "in a loop": (
        f"R50=0\nAA:\nIF R50==1\n{ONE}{GRID}GOTOF EE\nENDIF\nR50=1\nGOTOB AA\nEE:\nR1=1\n",
        READ,
        "! A.MPF line 4",
    ),
}


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
@pytest.mark.parametrize("active", [True, False], ids=["yes", "no"])
@pytest.mark.parametrize("case", ASSIGNED)
def test_the_program_itself_answers_its_condition(case: str, *, active: bool, judge: bool) -> None:
    text, yes, no = ASSIGNED[case]
    expected = yes if active else no
    if expected == "!":  # the writer follows one number of a variable, the judge several
        expected = "! A.MPF line 6" if judge else READ
    check({"A.MPF": text + "M17\n"}, active, expected, judge=judge)


#: Programs of which every value was carried out: labels that there are twice, and the answer.
LABELS = {
    "GOTOF takes the next one": (f"AA:\nGOTOF AA\nR1=1\nAA:\n{ONE}AA:\n{GRID}", READ),
    "GOTOF leads past the value": (f"AA:\nR1=1\nGOTOF AA\n{ONE}AA:\n{GRID}", "! A.MPF line 4"),
    "GOTOB goes back over two": (f"AA:\nR1=1\nAA:\n{ONE}IF R2<3 GOTOB AA\n{GRID}", READ),
    "GOTOB goes back to the nearest": (
        f"GOTOF CC\nAA:\n{ONE}AA:\nR1=1\nGOTOF EE\nCC:\nGOTOB AA\nEE:\n{GRID}",
        "! A.MPF line 3",
    ),
    "GOTOB into its own line": (f"{OFF}AA: IF R1<3 GOTOB AA\n{ONE}{GRID}", READ),
    "GOTO takes the next one first": (f"AA:\nR1=1\nGOTO AA\n{ONE}AA:\n{GRID}", "! A.MPF line 4"),
    "GOTO back to one of two": (
        f"IF R1==1 GOTOF CC\nAA:\nR1=1\nAA:\n{ONE}CC:\nIF R2==1 GOTO AA\n{GRID}",
        "! A.MPF line 7",
    ),
    "GOTOC back to one of two": (
        f"IF R1==1 GOTOF CC\nAA:\nR1=1\nAA:\n{ONE}CC:\nIF R2==1 GOTOC AA\n{GRID}",
        "! A.MPF line 7",
    ),
    "GOTOB to a block number": (f"N10 R1=1\n{ONE}N20 IF R2<3 GOTOB N10\n{GRID}", READ),
    "a block number and a label in one line": (
        f"IF R1==1 GOTOF N10\nR2=1\nN10 AA: R3=1\n{ONE}IF R1<3 GOTOB AA\n{GRID}",
        READ,
    ),
    "a repetition of one of two": (
        f"AA:\nR1=1\nBB:\nAA:\nR2=1\nBB:\nREPEAT AA BB P=2\n{ONE}{GRID}",
        "! A.MPF line 7",
    ),
    "GOTOF finds nothing behind it": (f"AA:\nR1=1\nGOTOF AA\n{ONE}{GRID}", "! A.MPF line 4"),
    "GOTOC finds nothing and goes on": (f"GOTOC AA\n{ONE}{GRID}", READ),
}


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
@pytest.mark.parametrize("case", LABELS)
def test_a_jump_leads_where_the_control_searches(case: str, *, judge: bool) -> None:
    text, expected = LABELS[case]
    check({"A.MPF": f"{text}{ON}M17\n"}, True, expected, judge=judge)


#: What is an end, and what only begins like one: values stand behind it, nothing is answered.
ENDS = {
    "M2": "! A.MPF line 4",
    "M30": "! A.MPF line 4",
    "N5 M17": "! A.MPF line 4",
    "RET": "! A.MPF line 4",
    "M2=3": "? A.MPF line 3",
    "M30=4": "? A.MPF line 3",
    "N5 M17 = 3": "? A.MPF line 3",
    "M2 =R1": "? A.MPF line 3",
}


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
@pytest.mark.parametrize("end", ENDS)
def test_an_m_function_of_a_spindle_is_no_end(end: str, *, judge: bool) -> None:
    files = {"A.MPF": f"{OFF}{PLAY}{end}\n{ONE}{GRID}{ON}M17\n"}
    check(files, None, ENDS[end], judge=judge)
    if ENDS[end].startswith("?"):
        check(files, True, READ, judge=judge)


MAIN = "%_N_MAIN_MPF\n"
SUB = "%_N_KOMP_SPF\n"
#: Files, the answer of the job, and what is expected.
CALLS: dict[str, tuple[dict[str, str], bool | None, str]] = {
    "a subprogram that is given": (
        {"MAIN.MPF": f"{OFF}KOMP\n{ON}M30\n", "KOMP.SPF": f"PROC KOMP SAVE\n{ONE}{GRID}M17\n"},
        None,
        READ,
    ),
    "with its ending": (
        {"MAIN.MPF": f"{OFF}N20 KOMP.SPF\n{ON}M30\n", "KOMP.SPF": f"{ONE}{GRID}RET\n"},
        None,
        READ,
    ),
    "by its name in a text": (
        {
            "MAIN.MPF": f'{OFF}CALL "KOMP"\n{ON}M30\n',
            "KOMP.SPF": f"IF R1==1\nR2=1\nENDIF\n{ONE}{GRID}M17\n",
        },
        True,
        READ,
    ),
    "by its path": (
        {
            "MAIN.MPF": f"{OFF}PCALL /_N_SPF_DIR/_N_KOMP_SPF\n{ON}M30\n",
            "KOMP.SPF": f"{ONE}{GRID}RET\n",
        },
        None,
        READ,
    ),
    "by its number, behind a label": (
        {"MAIN.MPF": f"{OFF}AA: L100\n{ON}M30\n", "L100.SPF": f"{ONE}{GRID}M17\n"},
        None,
        READ,
    ),
    "of one file with its header": (
        {"A.TXT": f"{MAIN}{OFF}KOMP\n{ON}M30\n{SUB}{ONE}{GRID}M17\n"},
        None,
        READ,
    ),
    "through another one": (
        {
            "MAIN.MPF": f"LADEN\n{ON}M30\n",
            "LADEN.SPF": "KOMP\nM17\n",
            "KOMP.SPF": f"{ONE}{GRID}M17\n",
        },
        None,
        READ,
    ),
    "one that sets nothing": (
        {"MAIN.MPF": f"VORBEREITEN\n{ONE}{GRID}{ON}M30\n", "VORBEREITEN.SPF": "R1=1\nM17\n"},
        None,
        READ,
    ),
    "one that may not come back": (
        {
            "MAIN.MPF": f"PRUEFEN\n{ONE}{GRID}{ON}M30\n",
            "PRUEFEN.SPF": "IF R1==1\nM2\nENDIF\nM17\n",
        },
        None,
        "? MAIN.MPF line 1",
    ),
    "one that comes back either way": (
        {
            "MAIN.MPF": f"PRUEFEN\n{ONE}{GRID}{ON}M30\n",
            "PRUEFEN.SPF": "IF R1==1 GOTOF AA\nR1=2\nM17\nAA:\nIF R2==1\nR1=3\nENDIF\nRET\n",
        },
        None,
        READ,
    ),
    "one that jumps to no label": (
        {
            "MAIN.MPF": f"PRUEFEN\n{ONE}{GRID}{ON}M30\n",
            "PRUEFEN.SPF": "IF R1==1 GOTOF AA\nM17\n",
        },
        None,
        "? MAIN.MPF line 1",
    ),
    "behind one that comes back, nothing carried out": (
        {
            "MAIN.MPF": f"IF R1==1\nR2=1\nENDIF\nPRUEFEN\n{ONE}{GRID}{ON}M30\n",
            "PRUEFEN.SPF": "IF R1==1\nR2=1\nENDIF\nM17\n",
        },
        False,
        "! MAIN.MPF line 5",
    ),
    "one that ends with M30": (
        {"MAIN.MPF": f"PRUEFEN\n{ONE}{GRID}{ON}M30\n", "PRUEFEN.SPF": "R1=1\nM30\n"},
        None,
        READ,
    ),
    "one that ends with M2": (
        {"MAIN.MPF": f"PRUEFEN\n{ONE}{GRID}{ON}M30\n", "PRUEFEN.SPF": "R1=1\nM2\n"},
        None,
        "? MAIN.MPF line 1",
    ),
    "one that calls itself": (
        {"MAIN.MPF": f"PRUEFEN\n{ONE}{GRID}{ON}M30\n", "PRUEFEN.SPF": "PRUEFEN\nM17\n"},
        None,
        "? MAIN.MPF line 1",
    ),
    "two of one name": (
        {
            "MAIN.MPF": f"{OFF}KOMP\n{ON}M30\n",
            "KOMP.SPF": f"{ONE}{GRID}M17\n",
            "KOMP.MPF": "R1=1\nM17\n",
        },
        None,
        "? KOMP.SPF line 1",
    ),
    "on a condition": (
        {"MAIN.MPF": f"IF R1==1\nKOMP\nENDIF\n{ON}M30\n", "KOMP.SPF": f"{ONE}{GRID}M17\n"},
        None,
        "? KOMP.SPF line 1",
    ),
    "behind a jump past it": (
        {"MAIN.MPF": f"GOTOF EE\nKOMP\nEE:\n{ON}M30\n", "KOMP.SPF": f"{ONE}{GRID}M17\n"},
        True,
        "! MAIN.MPF line 2",
    ),
    "one of two in any case, nothing carried out": (
        {
            "MAIN.MPF": "IF R1==1\nKOMP\nELSE\nL200\nENDIF\nM30\n",
            "KOMP.INI": f"{ONE}{GRID}{ON}M17\n",
            "L200.INI": f"{PLAY}M17\n",
        },
        False,
        "! MAIN.MPF line 2",
    ),
    "one of one or none, nothing carried out": (
        {"MAIN.MPF": "IF R1==1\nKOMP\nENDIF\nM30\n", "KOMP.INI": f"{ONE}{GRID}{ON}M17\n"},
        False,
        READ,
    ),
    "switched off by the subprogram before the main program switches on": (
        {"A.TXT": f"{MAIN}{ONE}{GRID}KOMP\n{ON}M30\n{SUB}{OFF}M17\n"},
        None,
        "! A.TXT line 9",
    ),
    "inches of the subprogram": (
        {"MAIN.MPF": f"EINHEIT\n{ONE}{GRID}{ON}M30\n", "EINHEIT.SPF": "G700\nM17\n"},
        True,
        "! EINHEIT.SPF line 1",
    ),
}


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
@pytest.mark.parametrize("case", CALLS)
def test_calls_of_subprograms_are_followed(case: str, *, judge: bool) -> None:
    files, active, expected = CALLS[case]
    check(files, active, expected, judge=judge)


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
@pytest.mark.parametrize(
    "call",
    [
        "VORBEREITEN",
        "N10 VORBEREITEN.SPF",
        'AA: VORBEREITEN(1,"X")',
        'CALL "VORBEREITEN"',
        "PCALL /_N_SPF_DIR/_N_VORBEREITEN_SPF",
    ],
)
def test_a_subprogram_that_is_not_given_is_asked_for_by_name(call: str, *, judge: bool) -> None:
    files = {"MAIN.MPF": f"R1=1\n{call}\n{ONE}{GRID}{ON}M30\n", "OTHER.SPF": "R2=1\nM17\n"}
    (asked,) = answer(files, None, judge=judge)
    assert asked.startswith("? MAIN.MPF line 2:")
    assert "VORBEREITEN" in asked
    check(files, True, READ, judge=judge)


# Conditions that belong together, against a machine that carries programs out
# --------------------------------------------------------------------------------------------------

_RELATIONS = {
    "==": operator.eq,
    "<>": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}


def random_program(rng: np.random.Generator) -> list[str]:
    """Values, branches in branches and jumps, on two variables that nothing assigns."""
    lines: list[str] = []
    numbers, labels = iter(range(1, 40)), iter(f"LAB{n}" for n in range(40))

    def condition() -> str:
        return f"{rng.choice(['R1', 'R2'])}{rng.choice(list(_RELATIONS))}{rng.integers(1, 3)}"

    def value() -> str:
        return f"$AA_ENC_COMP[0,{next(numbers)},AX1]=0.004"

    def block(depth: int) -> None:
        for _ in range(int(rng.integers(1, 4))):
            kind = rng.random()
            if kind < 0.35 or depth == 0:
                lines.append(value() if rng.random() < 0.6 else "M8")
            elif kind < 0.75:
                lines.append(f"IF {condition()}")
                block(depth - 1)
                if rng.random() < 0.5:
                    lines.append("ELSE")
                    block(depth - 1)
                lines.append("ENDIF")
            else:
                label = next(labels)
                lines.append(f"IF {condition()} GOTOF {label}")
                lines.append(value())
                lines.append(f"{label}:")

    block(2)
    block(1)
    return [*lines, "M17"]


def carried_out(lines: list[str], given: Mapping[str, float]) -> set[str]:
    """The values that a run carries out with the variables as ``given``."""
    done: set[str] = set()
    place = 0
    while lines[place] != "M17":
        line = lines[place]
        asked = re.match(r"IF (R\d)(==|<>|<=|>=|<|>)(\d)(?: GOTOF (\w+))?", line)
        if asked is not None:
            true = _RELATIONS[asked[2]](given[asked[1]], float(asked[3]))
            if asked[4] is not None:
                place = lines.index(f"{asked[4]}:") if true else place
            elif not true:
                place = other_side(lines, place, {"ELSE", "ENDIF"})
        elif line == "ELSE":
            place = other_side(lines, place, {"ENDIF"})
        elif line.startswith("$"):
            done.add(line)
        place += 1
    return done


def other_side(lines: list[str], place: int, ends: set[str]) -> int:
    depth = 0
    while True:
        place += 1
        if lines[place] in ends and depth == 0:
            return place
        depth += lines[place].startswith("IF") and "GOTOF" not in lines[place]
        depth -= lines[place] == "ENDIF"


@pytest.mark.parametrize("judge", [False, True], ids=["writer", "judge"])
def test_answers_are_believed_where_some_run_fits_them(*, judge: bool) -> None:
    """`active: no` where a run carries nothing out, `active: yes` where one carries all out."""
    rng = np.random.default_rng(61)
    grid = (
        "$AA_ENC_COMP_STEP[0,AX1]=10\n$AA_ENC_COMP_MIN[0,AX1]=0\n$AA_ENC_COMP_MAX[0,AX1]=400\n"
        "$AA_ENC_COMP_IS_MODULO[0,AX1]=0\n$AA_ENC_COMP[0,0,AX1]=0\n"
    )
    counts: Counter[tuple[bool, bool]] = Counter()
    for _ in range(120):
        lines = random_program(rng)
        values = {line for line in lines if line.startswith("$")}
        if not values or not any(line.startswith("IF") for line in lines):
            continue
        runs = [
            carried_out(lines, {"R1": one, "R2": other})
            for one in (0.5, 1.0, 1.5, 2.0, 2.5)
            for other in (0.5, 1.0, 1.5, 2.0, 2.5)
        ]
        text = "\n".join(lines[:-1])
        rows = "".join(
            f"$AA_ENC_COMP[0,{n},AX1]=0\n" for n in range(1, 41) if f"[0,{n},AX1]=0.004" not in text
        )
        files = {"A.MPF": f"{grid}{rows}{text}\nM17\n"}
        for active, fits in ((False, set() in runs), (True, values in runs)):
            refused = [one for one in answer(files, active, judge=judge) if one.startswith("!")]
            counts[active, fits] += 1
            assert bool(refused) is not fits, (active, text, refused)
    assert min(counts.values()) >= 10, counts
