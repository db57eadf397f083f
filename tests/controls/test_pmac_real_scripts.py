"""Scripts as machines have them: a definition without a comma behind its entries, entries set off by
commas, remarks with ``//``, macros, expressions, conditional blocks.

Form and numbers of the tables are those of an undulator's script (github
dhidas/IDCommon_ivu23_2.8m, comp_table_2.8.pmc; macros and expressions: I_var_2.8.pmc beside it).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.controls.control import decode, open_control
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile, ControlState
from format_samples import DEFINITIONS
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
ROW = "1664000,755200,473600,217600,73600,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0"
BACK = (
    ROW.replace("1664000", "-1664000")
    .replace(",7", ",-7")
    .replace(",4", ",-4")
    .replace(",2", ",-2")
)
#: 24 entries over 60 000 000 counts, 1000 counts per µm: 2.5 mm and 0.104 mm at the first one.
TABLES = f"""; ------------------
; \x83s\x83b\x83`
; ------------------
; #1 DEFINE COMP 12 #1,#1,60000000
; 800000,224000,0,0,0,0,0,0,0,0,0,0
#4 DEFINE COMP 24 #20,#20,60000000
{BACK}
#3 DEFINE COMP 24 #3,#3,60000000
{BACK}
#2 DEFINE COMP 24 #17,#17,60000000
{ROW}
#1 DEFINE COMP 24 #1,#1,60000000
{ROW}

"""
VARIABLES = """#define\t\tSPD_MIDL\t\t\t64\t\t; velocity
#define BACK_RUSH_VAL  4*SIXTEEN // backlash
#define SIXTEEN 16
I0122 = SPD_MIDL*2\t\t; Jog Speed
I0130 = -(2*81458)
I1816 = SPD_MIDL * 2
P6400 = P6400 + 1\t\t// for Debug
I185=$20 I0186 = BACK_RUSH_VAL
I286=BACK_RUSH_VAL
I51=1
"""
COUNTS = 10_000_000.0  # counts per mm: 6 mm of length


def files(*texts: str) -> list[ControlFile]:
    return [
        ControlFile(f"s{number}.pmc", text.encode("latin-1")) for number, text in enumerate(texts)
    ]


def read(*texts: str, active: bool | None = None, address: str | None = "1") -> ControlState:
    control = open_control(Session(), "pmac", {"counts_per_unit": COUNTS})
    return decode(control, files(*texts), address=address, active=active).state


def test_a_real_script_is_read_as_it_is_by_both_readers() -> None:
    state = read(TABLES, address=None)
    assert set(state.axes) == {"1", "3", "17", "20"}
    one, twenty = state.axes["1"], state.axes["20"]
    assert one.period == pytest.approx(6.0)
    # the first entry: 1664000 / 16 counts at 2 500 000 counts
    assert one.at(np.array([0.25, 0.0]), UP) == pytest.approx([104000 / COUNTS, 0.0])
    assert twenty.at(np.array([0.5]), DOWN) == pytest.approx([-47200 / COUNTS])


def test_macros_and_expressions_are_worked_out() -> None:
    state = read(VARIABLES, TABLES)
    assert state.axes["1"].at(np.array([0.0]), DOWN) == pytest.approx([-4.0 / COUNTS])


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("4*16", 64),
        ("(2+2)*$10", 64),
        ("128/2", 64),
        ("70 - 6", 64),
        ("+64.0", 64),
        ("65/2", None),
        ("I286", None),
        ("P1*4", None),
        ("4**16", None),
        ("NOBODY", None),
        ("(4", None),
    ],
)
def test_what_an_expression_gives(value: str, said: int | None) -> None:
    text = f"I51=1\nI185=32\nI186={value}\n#1 DEFINE COMP 2 #1,60000000\n16,0\n"
    if said is None:
        with pytest.raises(InputError, match="line 3"):
            read(text)
        with pytest.raises(InputError):
            virtual_control("pmac", files(text), options={"counts_per_unit": COUNTS})
        return
    assert read(text).axes["1"].at(np.array([0.0]), DOWN) == pytest.approx([-said / 16 / COUNTS])


def test_only_the_axis_under_work_is_patched_and_all_else_stays(tmp_path: Path) -> None:
    machine = Machine(low=0.0, high=5.0, slope=2e-6, bow=0.0004, lost=0.0, noise=0.00001)
    (tmp_path / "a.pmc").write_bytes(
        VARIABLES.replace("I185=$20 I0186 = BACK_RUSH_VAL", "").encode()
    )
    (tmp_path / "b.pmc").write_bytes(TABLES.encode("latin-1").replace(b"\n", b"\r\n"))
    targets = machine.targets(12)
    old = read(TABLES).axes["1"]
    readings = machine.measure(targets, 1, lambda x, s: old.at(x, UP if s > 0 else DOWN))
    (tmp_path / "x.csv").write_text(csv_of(targets, readings))
    (tmp_path / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: pmac, options: {{counts_per_unit: {COUNTS}}}}}\n"
        "states: {as_found: [a.pmc, b.pmc]}\n"
        "axes:\n  X: {travel: [0, 5], address: 1, before: [x.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    written = tmp_path / "job" / "tables" / "pmac"
    was = (tmp_path / "b.pmc").read_bytes().split(b"\r\n")
    now = (written / "b.pmc").read_bytes().split(b"\r\n")
    # the backlash of motor 1, which no script said, is new
    now = [line for line in now if not line.startswith((b"I185=", b"I186="))]
    changed = [line for line, (one, other) in enumerate(zip(was, now, strict=True)) if one != other]
    assert changed == [was.index(b"#1 DEFINE COMP 24 #1,#1,60000000") + 1]
    assert now[changed[0]].count(b",") == 23
    first = (tmp_path / "a.pmc").read_bytes()
    assert (written / "a.pmc").read_bytes().startswith(first[: first.index(b"I286")])


def test_more_and_fewer_entries_keep_the_commas(tmp_path: Path) -> None:
    form = control_format(DEFINITIONS["pmac"], {"counts_per_unit": 1000.0})
    del form, tmp_path  # grids change in test_formats_pmac.py; here the form of the list alone
    from compwright.formats.families.wrapped.script import read_script
    from compwright.formats.families.wrapped.tables import MotorTable
    from compwright.formats.families.wrapped.writing import patched_scripts

    given = files("#1 DEFINE COMP 4 #1,#1,4000\n16, 32,\n48 ,0 // end\n")
    for entries in ((1, 0), (1, 2, 3, 4, 5, 0)):
        wish = MotorTable(1, 1000 * len(entries), entries, (), 0, None)
        faults: list[object] = []
        done = patched_scripts(DEFINITIONS["pmac"], given, [wish], {1: 32}, faults)  # type: ignore[arg-type]
        assert faults == []
        assert b"// end" in done[0].content
        again = read_script(DEFINITIONS["pmac"], done)
        assert again.tables["COMP", 1].numbers == entries


# --- what can keep values from being carried out


TABLE = "#1 DEFINE COMP 2,60000000\n16 0\n"
GUARD = "#ifndef HARDWARE_H\n#define HARDWARE_H\n#define PLAY 64\n#endif\n"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (f"#define GOOD\n#ifdef GOOD\n{TABLE}#endif\nI51=1\n", 2),
        (f"#ifndef GOOD\nI51=0\n#endif\n{TABLE}", 2),
        (f"#ifdef OLD\n#1 DELETE COMP\n#endif\n{TABLE}I51=1\n", 2),
        (f"#ifdef A\n{TABLE}#else\n{TABLE.replace('16', '32')}#endif\nI51=1\n", 3),
        (f"{TABLE}#ifdef A\nI51=0\n#else\nI51=1\n#endif\n", 3),
        (f"{TABLE}I51=1\n#ifdef A\nI5111=3\n#endif\n", 0),  # nothing of ours is in it
        (f"#ifdef A\nP1=3\n#endif\n{TABLE}I51=1\n", 0),
        (f"{TABLE}I51=1\nOPEN PLC 3 CLEAR\nIF (P1=1)\nI51=0\nENDIF\nDISABLE PLC 3\nCLOSE\n", 3),
        (
            f"#define OFF I51=0\n{TABLE}I51=1\nOPEN PLC 3 CLEAR\nWHILE (P1<1)\nOFF\nENDWHILE\nCLOSE\n",
            3,
        ),
        (f'{TABLE}I51=1\nOPEN PLC 3\nCMD"#1DELETE COMP"\nCLOSE\n', 3),
        (f"{TABLE}I51=1\nOPEN PLC 3\nI(P5)=0\nCLOSE\n", 3),
        (f"{TABLE}I51=1\nOPEN PLC 3\nIF(P1=1) I(P5)=0\nCLOSE\n", 3),
        (f"{TABLE}I51=1\nOPEN PLC 3\nIF(I(P5)=0) P5=1\nCLOSE\n", 0),
        (f"{TABLE}I51=1\nOPEN PLC 3 CLEAR\nIF (I51=0)\nP1=1\nENDIF\nCLOSE\nENABLE PLC 3\n", 0),
        (f"{TABLE}I51=1\nIF (P1=1)\n", 3),
        (f"{TABLE}I51=1\n#else\n", 3),
        # which number was sent is as open as the block
        (
            f"#ifdef A\n#define PLAY 64\n#else\n#define PLAY 16\n#endif\n{TABLE}I185=32\nI186=PLAY\nI51=1\n",
            3,
        ),
        (
            f"#define PLAY 16\n#ifdef A\n#undef PLAY\n#define PLAY 64\n#endif\n{TABLE}I185=32\nI186=4*PLAY\nI51=1\n",
            3,
        ),
        (f"#ifdef A\n#define ONE 1\n#endif\n#define SWITCH ONE\n{TABLE}I51=SWITCH\n", 3),
        (f"{TABLE}I51=1\n#ifdef A\n#define DO I51=0\n#else\n#define DO P1=1\n#endif\nDO\n", 3),
        (
            f"#ifdef A\n#define PLAY 64\n#endif\n#define PLAY 16\n{TABLE}I185=32\nI186=PLAY\nI51=1\n",
            0,
        ),
        (f"#ifdef A\n#define PLAY 64\n#endif\n{TABLE}P1=PLAY\nI51=1\n", 0),
        # an include guard: its script may have been sent before, with the same macros
        (f"{GUARD}{TABLE}I185=32\nI186=PLAY\nI51=1\n", 2),
        (f"{GUARD}{GUARD}{TABLE}I185=32\nI186=2*PLAY\nI51=1\n", 2),
        (f"{GUARD}{TABLE}P1=PLAY\nI51=1\n", 0),
        (f"{GUARD}#undef PLAY\n#define PLAY 8\n{TABLE}I185=32\nI186=PLAY\nI51=1\n", 0),
        # no guards: another value may have been sent before, or in the other branch
        (f"#ifndef PLAY\n#define PLAY 64\n#endif\n{TABLE}I185=32\nI186=PLAY\nI51=1\n", 3),
        (f"#define HARDWARE_H\n{GUARD}{TABLE}I185=32\nI186=PLAY\nI51=1\n", 3),
        (f"{GUARD}{GUARD.replace('64', '16')}{TABLE}I185=32\nI186=PLAY\nI51=1\n", 3),
        (
            f"#ifdef HARDWARE_H\n#define HARDWARE_H\n#define PLAY 64\n#endif\n{TABLE}I185=32\nI186=PLAY\nI51=1\n",
            3,
        ),
        (
            f"{GUARD.replace('#endif', '#else')}#define PLAY 16\n#endif\n{TABLE}I185=32\nI186=PLAY\nI51=1\n",
            3,
        ),
        (
            f"#ifndef FAST\n#define PLAY 64\n#define FAST\n#endif\n{TABLE}I185=32\nI186=PLAY\nI51=1\n",
            3,
        ),
        (
            (
                "#ifndef HARDWARE_H\n#define HARDWARE_H\n#ifdef A\n#define PLAY 16\n#endif\n#endif\n"
                f"{TABLE}I185=32\nI186=PLAY\nI51=1\n"
            ),
            3,
        ),
    ],
)
def test_what_may_not_have_been_sent_is_asked_for_or_refused(text: str, code: int) -> None:
    if code == 0:
        assert read(text).axes["1"].positions.size
        return
    kind = UsageError if code == 2 else InputError
    with pytest.raises(kind) as stopped:
        read(text)
    fault = stopped.value.faults[0]
    assert fault.file == "s0.pmc"
    assert fault.place.startswith("line ")
    given = files(text)
    options = {"counts_per_unit": COUNTS}
    with pytest.raises(InputError):
        virtual_control("pmac", given, options=options)
    if code == 2:
        # the answer counts everything as sent, in the order of the lines
        assert "1" in read(text, active=True).axes
        virtual_control("pmac", given, options=options, carried_out=True, active=True)
    else:
        with pytest.raises(InputError):
            read(text, active=True)


def test_the_macro_of_an_include_guard_counts_where_all_was_sent() -> None:
    state = read(GUARD, f"{TABLE}I185=32\nI186=PLAY\nI51=1\n", active=True)
    up, down = (state.axes["1"].at(np.array([0.0]), side)[0] for side in (UP, DOWN))
    assert abs(up - down) == pytest.approx(64 / 16 / COUNTS)
    block = "#ifdef A\n#define PLAY 16\n#endif\n"  # begins in the line in which the guard does
    with pytest.raises(InputError):
        read(GUARD, f"{block}{TABLE}I185=32\nI186=PLAY\nI51=1\n", active=True)


def test_both_lines_of_two_branches_are_named() -> None:
    text = f"#ifdef A\n{TABLE}#else\n{TABLE}#endif\nI51=1\n"
    with pytest.raises(InputError) as refused:
        read(text)
    assert refused.value.faults[0].place == "line 5"
    assert "line 2" in refused.value.faults[0].message


def test_all_sent_is_refused_where_one_branch_excludes_the_other() -> None:
    """Another entry in the other branch: the table or the backlash was sent, not both."""
    text = f"#ifdef A\n{TABLE}#else\nI186=16\n#endif\nI51=1\nI185=32\n"
    with pytest.raises(InputError) as refused:
        read(text, active=True)
    assert refused.value.faults[0].place == "line 5"
    assert "line 2" in refused.value.faults[0].message
    options = {"counts_per_unit": COUNTS}
    with pytest.raises(InputError, match=r"line 5: .* than line 2"):
        virtual_control("pmac", files(text), options=options, carried_out=True, active=True)


APART = {
    "a name and its absence": f"#ifdef A\n{TABLE}#endif\n#ifndef A\nI186=16\n#endif\n",
    "a name twice, the other side": f"#ifdef A\n{TABLE}#endif\n#ifdef A\nP1=3\n#else\nI186=16\n#endif\n",
    "one inside of another": f"#ifdef A\n{TABLE}#endif\n#ifdef B\n#ifndef A\nI186=16\n#endif\n#endif\n",
    "a value twice": f"#if X > 2\n{TABLE}#endif\n#if X>2\nP1=3\n#else\nI186=16\n#endif\n",
}
TOGETHER = {
    "a name twice": f"#ifdef A\n{TABLE}#endif\n#ifdef A\nI186=16\n#endif\n",
    "two names": f"#ifdef A\n{TABLE}#endif\n#ifndef B\nI186=16\n#endif\n",
    "defined between": f"#ifndef A\n{TABLE}#endif\n#define A 1\n#ifdef A\nI186=16\n#endif\n",
    "removed between": f"#ifdef A\n{TABLE}#endif\n#undef A\n#ifndef A\nI186=16\n#endif\n",
    "another value between": f"#if X>2\n{TABLE}#endif\n#define X 1\n#if X>2\n#else\nI186=16\n#endif\n",
}


@pytest.mark.parametrize("name", [*APART, *TOGETHER])
def test_blocks_with_one_question_are_sent_by_one_answer(name: str) -> None:
    text = {**APART, **TOGETHER}[name] + "I51=1\nI185=32\n"
    options = {"counts_per_unit": COUNTS}
    if name in TOGETHER:
        assert read(text, active=True).axes["1"].positions.size
        virtual_control("pmac", files(text), options=options, carried_out=True, active=True)
        return
    with pytest.raises(InputError, match="branch of a conditional block than line 2") as refused:
        read(text, active=True)
    assert "I186" in text.splitlines()[int(refused.value.faults[0].place.split()[1]) - 1]
    with pytest.raises(InputError, match=r"line \d+: .* than line 2"):
        virtual_control("pmac", files(text), options=options, carried_out=True, active=True)


def test_blocks_of_other_motors_stop_nothing() -> None:
    text = f"#ifdef A\n#2 DEFINE COMP 2,60000000\n16 0\n#endif\n{TABLE}I51=1\n"
    assert read(text).axes["1"].positions.size


def test_macros_that_name_variables_of_no_concern_are_read_over() -> None:
    """A pointer and an assignment as in IVU_2.8_PLC.pmc; CLOSE in a name ends no program."""
    text = (
        f"#define M_Type M5000\n#define OFF I51\n{TABLE}I51=1\nM_Type->X:$004FA0,0,24\nM_Type = 3*2\n"
        "OPEN PLC 3 CLEAR\nGAP_CLOSE_REG = 1\nIF( CLOSE_REG = 0 )\nENDIF\nCLOSE\n"
    )
    assert read(text).axes["1"].positions.size
    with pytest.raises(InputError, match="line 13"):
        read(f"{text}OFF=0\n")


@pytest.mark.parametrize(
    ("old", "new", "step"),
    [
        ("DEFINE COMP 4,200000", "DEFINE COMP 4,LEN", "DEFINE COMP 4,200000"),
        ("DEFINE COMP 4,200000", "DEFINE COMP 4,(2*LEN/2)", "DEFINE COMP 4,200000"),
        ("I186=48", "I(100+86)=48", "I186=48"),
        ("I186=48", "I(MOTOR+86)=48", "I186=48"),
        ("\n80\n", "\nFIRST\n", "80"),
    ],
)
def test_what_is_not_read_is_written_out_for_the_user(old: str, new: str, step: str) -> None:
    """The step, followed, makes the script that the macros and expressions mean."""
    head = "#define LEN 200000\n#define MOTOR 100\n#define FIRST 80\n"
    plain = head + "#1 DEFINE COMP 4,200000\n80\n160\n240\n0\nI51=1\nI185=32\nI186=48\n"
    control = open_control(Session(), "pmac", {"counts_per_unit": 1000})

    def read(text: str) -> ControlState:
        return decode(control, [ControlFile("a.pmc", text.encode())], address="1").state

    with pytest.raises(InputError) as refused:
        read(plain.replace(old, new))
    hints = [fault.hint for fault in refused.value.faults]
    assert hints[:1] == [
        f"write `{step}` in this line of a copy of the script, if it was sent like this"
    ]
    sent = plain.removeprefix(head)
    mended = head + sent.replace(old, new).replace(new.strip(), step)
    assert np.array_equal(
        read(mended).axes["1"].at(np.array([50.0]), UP),
        read(plain).axes["1"].at(np.array([50.0]), UP),
    )


def test_numbers_next_to_each_other_are_no_expression() -> None:
    script = "#1 DEFINE COMP 4,200000\nE1 -80 -160 0\n#define E1 5\n"
    with pytest.raises(InputError) as refused:
        decode(
            open_control(Session(), "pmac", {"counts_per_unit": 1000}),
            [ControlFile("a.pmc", ("#define E1 5\n" + script).encode())],
            address="1",
        )
    assert "`5 -80 -160 0`" in str(refused.value.faults[0].hint)
