"""PMAC and Turbo PMAC: entries in 1/16 count over a length that repeats, worked by hand from the
manuals (PMAC-VME software reference p225 to p229, Turbo PMAC software reference p301 to p305, Turbo
PMAC user manual p185 to p191).

Quantities: 1000 counts per mm and 1/16 count make 0.0625 µm.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from card_files import card_values
from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.fitting.fit import fit_table
from compwright.formats.families.activity import Activity
from compwright.formats.families.family import Family
from compwright.formats.families.shapes import control_format
from compwright.formats.text.diff import compare_files
from compwright.foundations.errors import CapacityError, CompwrightError, InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.estimate import WantedCorrection
from compwright.records.facts import AxisFacts
from compwright.records.fitted_table import TableRequest
from format_samples import DEFINITIONS

pytestmark = pytest.mark.short_estimate

PMAC = DEFINITIONS["pmac"]
PLUS, MINUS = Direction
#: The worked example of the manuals' form.
EXAMPLE = """\
I51=0
#1 DEFINE COMP 4,#1D,400000
-32 -48 16 0
#1 DEFINE BLCOMP 4,400000
8 12 -4 0
I185=32 I186=96
I51=1
"""


def control(counts: float | None = 1000.0, **options: object) -> Family:
    return control_format(PMAC, {"counts_per_unit": counts, **options})


def script(text: str, name: str = "a.pmc") -> ControlFile:
    return ControlFile(name, text.encode("latin-1"))


def axis(
    address: str = "1",
    travel: tuple[float, float] = (-100.0, 200.0),
    *,
    reference: float = 0.0,
    returns: Direction = PLUS,
    modulo: float | None = None,
    options: Mapping[str, object] | None = None,
) -> Axis:
    return Axis(
        name="XYZ"[int(address) % 3],
        kind=AxisKind.LINEAR if modulo is None else AxisKind.ROTARY,
        travel=travel,
        address=address,
        reference=reference,
        reference_return=returns,
        modulo=modulo,
        options=options or {},
    )


def table(
    positions: list[float],
    positive: list[float],
    negative: list[float] | None = None,
    *,
    address: str = "1",
    period: float | None = None,
) -> AxisCompensation:
    """A table in µm."""
    return AxisCompensation(
        address=address,
        kind=AxisKind.LINEAR if period is None else AxisKind.ROTARY,
        positions=np.array(positions),
        positive=np.array(positive) / 1000,
        negative=np.array(positive if negative is None else negative) / 1000,
        period=period,
    )


def at(state: ControlState, address: str, position: float, direction: Direction) -> float:
    """The correction in µm."""
    return 1000 * float(state.axes[address].at(np.array([position]), direction)[0])


def refused(text: str, *axes: Axis, counts: float | None = 1000.0) -> str:
    with pytest.raises(InputError) as caught:
        control(counts).read([script(text)], axes)
    return str(caught.value)


@pytest.mark.parametrize(
    ("definition", "fits"),
    [
        ("#1->1000X", True),
        ("#1->1000.0 X+2500", True),
        ("#1->25400X", True),  # an axis in inches: "100000 cts/in"
        ("#1->500X\n#1->1000X", True),  # the last one counts
        ("#1->X", True),  # "User units = counts"
        ("#2->4000Y", True),
        ("#1->0", True),
        ("#1->10000X", False),
        ("#1->-1000X", False),
        ("&2#1->2000Z-666.667", False),
        ("#1->500X\n#ifdef METRIC\n#1->1000X\n#endif", False),  # sent or not: one is wrong
        ("#1->1000X\n#ifdef INCH\n#1->25400X\n#endif", True),
    ],
)
def test_both_readers_compare_the_counts_with_the_definition_of_the_axis(
    definition: str, fits: bool
) -> None:
    """Scale factor: motor counts per axis unit (PMAC 2 software reference p. 179 and 180)."""
    text = definition + "\n" + EXAMPLE
    if fits:
        control().read([script(text)], [axis()])
        virtual_control("pmac", [script(text)], options={"counts_per_unit": 1000.0})
        return
    with pytest.raises(InputError, match=r"(?s)line [12]: counts_per_unit"):
        control().read([script(text)], [axis()])
    with pytest.raises(InputError, match=r"(?s)line [12]: counts_per_unit"):
        virtual_control("pmac", [script(text)], options={"counts_per_unit": 1000.0})


# --- reading


@pytest.mark.parametrize(
    ("position", "positive", "negative"),
    [
        (0, 0, -6.0),
        (50, -1.0, -7.25),
        (100, -2.0, -8.5),  # 6.5 counts of backlash: (96 + 8) / 16
        (200, -3.0, -9.75),
        (-50, 0.5, -5.375),
        (-100, 1.0, -4.75),
        (300, 1.0, -4.75),  # the same place of the table
        (250, -1.0, -7.25),  # the gap: from -3 counts straight to +1
    ],
)
@pytest.mark.parametrize("job_axis", [None, axis(), axis(returns=MINUS)], ids=["", "+", "-"])
def test_the_worked_example(
    position: float, positive: float, negative: float, job_axis: Axis | None
) -> None:
    state = control().read([script(EXAMPLE)], [job_axis] if job_axis else [])
    assert at(state, "1", position, PLUS) == pytest.approx(positive, abs=1e-9)
    assert at(state, "1", position, MINUS) == pytest.approx(negative, abs=1e-9)


def test_the_table_counts_from_the_reference() -> None:
    state = control().read([script(EXAMPLE)], [axis(reference=-30.0)])
    assert at(state, "1", 70, PLUS) == pytest.approx(-2.0)


def test_words_cases_remarks_lines_and_hexadecimal() -> None:
    odd = (
        "\r\n#1\r\ndef comp 4 , #1d , 400000 ; DEFINE COMP 9,9\r\n-32 -48\r\n\r\n16\t+0 Def BlComp"
        " 4,400000 8 12 -4 0 i185=$20i186=$60 I 51 = 0 I51=1 #1->1000X &1 M162->D:$2B P1=3 SAVE"
    )
    odd = odd.replace("I 51 = 0 ", "").replace("i185=$20i186", "i185=$20 i186")
    state = control().read([script(odd)])
    assert at(state, "1", 100, MINUS) == pytest.approx(-8.5)


def test_tables_of_one_motor_add_up_wherever_they_are_kept() -> None:
    more = "#2 DEFINE COMP 2,#1D,#1,200000\n16 0\n" + EXAMPLE.replace("I51=0\n", "")
    state = control().read([script(more)])
    assert at(state, "1", 50, PLUS) == pytest.approx(-1.0 + 0.5)
    assert at(state, "1", 100, PLUS) == pytest.approx(-2.0 + 1.0)
    assert at(state, "1", 250, PLUS) == pytest.approx(-1.0 + 0.5)


def test_two_scripts_run_one_after_the_other() -> None:
    first, second = EXAMPLE.split("#1 DEFINE BLCOMP")
    files = [script(first), script("DEFINE BLCOMP" + second, "b.pmc")]
    assert at(control().read(files), "1", 100, MINUS) == pytest.approx(-8.5)


@pytest.mark.parametrize(
    ("old", "new", "positive", "negative"),
    [
        ("I51=1", "I51=0", 0, -6.0),  # tables off: the constant backlash stays
        ("I51=1\n", "I51=1 I51=0\n", 0, -6.0),
        ("I185=32", "I185=0", -2.0, -2.0),  # no take-up
        ("I186=96", "I186=0", -2.0, -2.5),
    ],
)
def test_switches(old: str, new: str, positive: float, negative: float) -> None:
    state = control().read([script(EXAMPLE.replace(old, new))])
    assert at(state, "1", 100, PLUS) == pytest.approx(positive)
    assert at(state, "1", 100, MINUS) == pytest.approx(negative)


def test_whether_tables_acted_is_asked_where_the_script_ends_with_them_off() -> None:
    files = [script(EXAMPLE.replace("I51=1", "I51=0"))]
    with pytest.raises(UsageError, match="is unknown whether the table was active"):
        control().read(files, [axis()], activity=Activity(asking=True))
    state = control().read(files, [axis()], activity=Activity(stated=True, asking=True))
    assert at(state, "1", 100, PLUS) == pytest.approx(-2.0)


def test_what_is_in_no_script_is_assumed_and_listed() -> None:
    text = EXAMPLE.replace("I51=0\n", "").replace("I51=1\n", "").split("#1 DEFINE BL")[0]
    state = control().read([script(text.replace("#1D,", ""))])
    assert at(state, "1", 100, MINUS) == pytest.approx(-2.0)
    facts = {note.fact for note in state.assumed}
    assert {"I51: tables act", "I186: backlash", "#1 COMP: looked up by the actual position"} <= (
        facts
    )


def test_counts_are_asked_for_only_where_something_acts() -> None:
    with pytest.raises(UsageError, match="counts per mm or deg of its motor"):
        control(None).read([script(EXAMPLE)])
    state = control(None).read([script("#1 DEFINE COMP 2,400000\n0 0\nI186=0\n")])
    assert at(state, "1", 70, MINUS) == 0


def test_a_table_between_motors_in_counts_of_both() -> None:
    text = "#3 DEFINE COMP 4,#1D,#2,400000\n16 32 -16 0\nI51=1\nI186=0\nI286=0\n"
    axes = [axis("1"), axis("2", options={"counts_per_unit": -2000.0})]
    (cross,) = control().read([script(text)], axes).cross
    assert (cross.input, cross.output) == ("1", "2")
    # 1 count of motor 2 at 100 mm of motor 1: -0.5 µm; -100 mm is the entry at 300 mm.
    found = 1000 * cross.at(np.array([50.0, 100.0, -100.0]), MINUS)
    np.testing.assert_allclose(found, [-0.25, -0.5, 0.5], atol=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("16 0\n", "16 1\n", "last entry is not 0"),
        ("16 0\n", "16\n", "entries are missing"),
        ("16 0\n", "16 0 0\n", "one entry too many"),
        ("16 0\n", "16.5 0\n", "not a whole number"),
        ("-32", "-8388608", "too large"),
        ("#1 DEFINE COMP", "DEFINE COMP", "the table has no motor"),
        ("#1 DEFINE COMP", "#33 DEFINE COMP", "the table has no motor"),
        ("4,#1D,400000", "4,#1D", "cannot be read"),
        ("4,#1D,400000", "1.2,#1,#2,#1,9,9", "over two motors"),
        ("I186=96", "", "which no script says"),
        ("I185=32", "", "whether the control compensates it"),
        ("I186=96", "I186=-1", "out of its range"),
        ("I186=96", "I186=P1*2", "not a whole number"),
        ("I51=1", "I51=2", "neither on nor off"),
        ("I51=1", "I51=1\n#1J/", "not a command"),
        ("I51=1", "I51=1\nOPEN PLC 3\nI51=0\nCLOSE", "a program sets I51"),
        ("I51=1", "I51=1\nOPEN PLC 3 CLEAR\nI185..187=0\nCLOSE", "a program sets I185..187"),
        ("I51=1", 'I51=1\nOPEN PLC 3\nCMD"#1DELETE COMP"\nCLOSE', "a program sets DELETE COMP"),
        ("I51=1", "I51=1\nOPEN PLC 3\nIF(P1=1) I(P2)=3\nCLOSE", r"a program sets I\(P2\)"),
        ("I51=1", "P1=3I51=0", "not a command"),
        ("I51=1", "M162->D:$2BI51=0", "not a command"),
        ("I51=1", "I51=1\nOPEN PROG 3\nX1", "the program has no end"),
        ("#1 DEFINE BL", "#2 DEFINE COMP 2,9\n0 0\n#1 DEFINE BL", "ERR003.*#1, a lower motor"),
        ("#1 DEFINE COMP", "DEFINE GATHER\n#1 DEFINE COMP", "ERR003.*GATHER"),
        ("I51=1", "I51=1 #1 DEFINE BLCOMP 1,9 0", "ERR003.*delete it first"),
        ("I185=32", "#2 DEL COMP", "whether the control compensates it"),
    ],
)
def test_refused_with_a_sentence(old: str, new: str, says: str) -> None:
    text = EXAMPLE.replace(old, new, 1)
    if "over two" in says:
        text = text.replace("-32 -48 16 0", "1 2 3 4 5")
    with pytest.raises(InputError, match=says):
        control().read([script(text)])


def test_a_turn_that_the_length_does_not_divide() -> None:
    rotary = EXAMPLE.replace("400000", "360000")
    control().read([script(rotary)], [axis(modulo=360.0, travel=(0.0, 360.0))])
    says = refused(EXAMPLE, axis(modulo=360.0, travel=(0.0, 360.0)))
    assert "the table must repeat once per turn of the endless axis" in says


def test_missing_is_not_zero() -> None:
    assert "states the compensation of motor 2" in str(refused(EXAMPLE, axis("2")))
    assert "no compensation of any motor" in refused("I130=2000\n")


@pytest.mark.parametrize(
    "before",
    ["#1->1000X", "#2->8660.25X - 5000Y", "#4->I", "#1->1000X#2->1000Y", "M162->D:$2B",
     "M1->Y:$FFC2, 8,1", "P1=3", "ENABLE PLC 1..3", "ENA PLC 1,2", "M5,10,1=0"],
)  # fmt: skip
def test_a_command_behind_another_on_its_line_acts(before: str) -> None:
    files = [script(f"{EXAMPLE}I51=0\nI186=0\n{before} I186=96 I51=1\n")]
    assert at(control().read(files), "1", 0.0, MINUS) == -6.0
    judge = virtual_control("pmac", files, options={"counts_per_unit": 1000.0})
    assert 1000 * judge.correction("1", np.zeros(1), MINUS)[0] == -6.0


# --- writing


@pytest.mark.parametrize("end", ["SAVE", "\r\n save ; all\r\n\r\n\x1a"])
def test_what_is_assigned_anew_stands_before_the_save_that_ends_the_script(end: str) -> None:
    files = [script(f"#1 DEFINE COMP 1,9\n0\nI51=1\n{end}")]
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3], [-5, -6, -8, -9])
    text = control().write([wish], [axis()], files)[0].content.decode("latin-1")
    save = text.casefold().index("save")
    assert text.index("I185=32") < save
    assert text.index("I186=96") < save


@pytest.mark.parametrize("several", ["I100..199=0", "I186,3,100=0 I185,3,100=0", "I50..290=0"])
def test_an_assignment_to_several_variables_stays_and_ours_follow(several: str) -> None:
    own = f"{several}\n{EXAMPLE.replace('I185=32 I186=96', '').replace('I51=1', '')}"
    files = [script(own.replace("I51=0\n", ""))]
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3], [-5, -6, -8, -9])
    new = control(take_up_rate=16).write([wish], [axis()], files)
    text = new[0].content.decode("latin-1")
    assert f"{several}\n" in text
    assert "I186=96" in text
    assert "I185=16" in text
    assert at(control().read(new), "1", 100.0, MINUS) == pytest.approx(-8.0)


def test_a_fresh_script_worked_by_hand() -> None:
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3], [-4.75, -6, -8.5, -9.75])
    (file,) = control().write([wish], [axis()])
    # Spacing 100 mm, travel -100 to 200: the end values are held from -400 and to 500, so ten
    # entries over 1000 mm: 100 to 500, then -400 to 0.
    assert file.content.decode().splitlines() == [
        "I51=0",
        "#1 DEFINE COMP 10,#1D,1000000",
        "-32 -48 -48 -48 -48 16 16 16",
        "16 0",
        "#1 DEFINE BLCOMP 10,1000000",
        "8 12 12 12 12 -4 -4 -4",
        "-4 0",
        "I185=32",
        "I186=96",
        "I51=1",
    ]


def test_a_motor_that_counts_against_its_axis_worked_by_hand() -> None:
    # In + of the axis the motor counts down: there the backlash is taken off. 0 in - at zero.
    wish = table([-100, 0, 100, 200], [8, 6, 4, 3], [2, 0, -2, -3])
    (file,) = control(-1000.0).write([wish], [axis()])
    lines = file.content.decode().splitlines()
    # Entry 1 is the motor's 100 mm, -100 mm of the axis: +2 µm is -2 counts, -32/16.
    assert lines[1] == "#1 DEFINE COMP 10,#1D,1000000"
    assert lines[2:4] == ["-32 -32 -32 -32 48 48 48 48", "32 0"]
    assert "I186=96" in lines
    assert not any("BLCOMP" in line for line in lines)


def test_two_motors_are_defined_from_the_highest_down_and_comp_before_blcomp() -> None:
    wishes = [
        table([0, 100], [0, 1], [-1, -1], address="1"),
        table([0, 100], [0, 1], [-1, -1], address="2"),
    ]
    axes = [axis("1", (0, 100)), axis("2", (0, 100))]
    (file,) = control().write(wishes, axes)
    defined = [line[:11] for line in file.content.decode().splitlines() if "DEF" in line]
    assert defined == ["#2 DEFINE C", "#1 DEFINE C", "#2 DEFINE B", "#1 DEFINE B"]
    assert control().write(wishes[::-1], axes[::-1]) == (file,)


def test_an_endless_axis_has_its_turn_as_length() -> None:
    wish = table([0, 90, 180, 270, 360], [0, 1, 2, 1, 0], [-3, -2, -1, -2, -3], period=360.0)
    turning = axis(modulo=360.0, travel=(0.0, 360.0))
    (file,) = control().write([wish], [turning])
    assert "DEFINE COMP 4,#1D,360000\n16 32 16 0\n" in file.content.decode()
    again = control().read([file], [turning]).axes["1"]
    np.testing.assert_allclose(again.negative, wish.negative, atol=1e-12)


@pytest.mark.parametrize(
    ("changes", "its_axis", "says"),
    [
        ({"positive": [1, 1, 1, 1]}, axis(), "at the reference, arriving in \\+, is not 0"),
        ({"negative": [0, 1, 0, 0]}, axis(), "backlash at motor zero.*outside 0 to"),
        ({"positive": [0.03, 0, 0, 0]}, axis(), "not a multiple of 6.25e-05"),
        ({"positive": [0, 0, 524289, 0]}, axis(), "8388624 .*outside -8388607 to 8388607"),
        ({"negative": [400000, 0, 0, 0], "positive": [-400000, 0, 0, 0]}, axis(), "table of back"),
        ({"positions": [-100, 0, 100, 201]}, axis(), "not equally spaced"),
        ({}, axis(reference=50.0), "whole spacings"),
        ({}, axis(reference=300.0), "whole spacings"),
        ({}, axis(options={"counts_per_unit": 10 / 3 / 7}), "not a whole number of counts"),
        ({}, axis(modulo=400.0, travel=(0, 400)), "does not repeat once per turn"),
        ({"period": 300.0}, axis(), "the axis is not endless"),
        ({"backlash": 0.001}, axis(), "no backlash value in addition to the table"),
        ({"slope": 1e-6}, axis(), "one table for each direction"),
    ],
)
def test_limits_are_refused_by_name(
    changes: Mapping[str, object], its_axis: Axis, says: str
) -> None:
    curves = {
        name: np.array(values) / (1 if name == "positions" else 1000)
        for name, values in changes.items()
        if isinstance(values, list)
    }
    wish = table([-100, 0, 100, 200], [0, 0, 0, 0], [0, 0, 0, 0])
    wish = replace(wish, **{**changes, **curves, "kind": its_axis.kind})  # type: ignore[arg-type]
    if changes.get("positive") is not None and "negative" not in changes:
        wish = replace(wish, negative=wish.positive)
    with pytest.raises(CapacityError, match=says):
        control().write([wish], [its_axis])


def test_the_gap_lies_behind_the_travel() -> None:
    """The length is at least the travel and one spacing, however short the table is."""
    wish = table([0, 10], [0, 1])
    (file,) = control().write([wish], [axis(travel=(-5, 93))])
    state = control().read([file], [axis(travel=(-5, 93))])
    assert state.axes["1"].period is not None
    assert state.axes["1"].period >= 98 + 10
    for x, right in ((10, 1.0), (93, 1.0), (123, 1.0), (-5, 0.0), (-35, 0.0)):
        assert at(state, "1", x, PLUS) == pytest.approx(right)


def test_the_card_says_between_which_places_the_gap_lies() -> None:
    """Travel -5 to 93, a point each 10 mm, the end values held for three spacings: from -40 to
    130, and 10 mm further stands -40 again.
    """
    wish, its_axis = table([0, 10], [0, 1]), axis(travel=(-5, 93))
    words = card_values(control(), its_axis, wish, AxisFacts(), np.array([0.0, 50.0]))
    assert "beyond 130 mm and below -40 mm is the gap" in words["gap"]
    assert "repeats after 180 mm" in words["gap"]


def test_a_backlash_without_a_table_is_replaced_by_a_table_and_its_constant(
    tmp_path: Path,
) -> None:
    """Lost motion of 5 um, of which Ixx86 = 16/16 count takes out 1 um (1000 counts per mm)."""
    (tmp_path / "a.pmc").write_text("I185=32\nI186=16\nI51=1\n")
    rows = [
        f"{x},{way},{run},{0.02 * x + noise - (4 if way == '+' else 0)}"
        for run, noise in enumerate((0.1, -0.2, 0.3, -0.1, 0.0), start=1)
        for way in "+-"
        for x in (13, 118, 204, 322, 411, 497, 588)
    ]
    head = "# axis: X\ntarget_mm,direction,run,deviation_um\n"
    (tmp_path / "x.csv").write_text(head + "\n".join(rows) + "\n")
    words = ["run", str(tmp_path / "x.csv"), "--format", "pmac", "--axis", "X", "--travel", "0:600"]
    words += ["--option", "address=1", "--option", "counts_per_unit=1000"]
    words += ["--state", str(tmp_path / "a.pmc"), "--out", str(tmp_path / "out")]
    assert compwright(words) == 0
    script = (tmp_path / "out" / "tables" / "pmac" / "a.pmc").read_text()
    (constant,) = (line for line in script.splitlines() if line.startswith("I186="))
    assert 72 <= int(constant.removeprefix("I186=")) <= 88  # 5 um and its noise, in 1/16 count
    card = (tmp_path / "out" / "card" / "card.md").read_text(encoding="utf-8")
    assert f"{constant.replace('=', ' = ')} (1/16 count" in card.replace("\\", "")


# --- patching

OTHERS = """\
; backup of the mill\r
#4 DEFINE COMP 3,#4D,90000\r
5 -5 0 ; rotary\r
#1 DEF COMP 4,#1D,600000 ; X\r
 1  2 -3\r
+0\r
#4 DEFINE BLCOMP 3,90000\r
1 2 0\r
I130=2000 I185=16 I186=0 I485=8 I486=32\r
I51=1\r
DEFINE GATHER\r
"""


def patched(text: str, *wishes: AxisCompensation, axes: list[Axis] | None = None) -> str:
    given = axes or [axis(wish.address) for wish in wishes]
    (file,) = control().write(list(wishes), given, [script(text)])
    return file.content.decode("latin-1")


def test_only_the_numbers_of_our_motor_change() -> None:
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3], [-5, -6, -8, -9])
    new = patched(OTHERS, wish).splitlines(keepends=True)
    old = OTHERS.splitlines(keepends=True)
    assert [line for line in new if line not in old] == [
        "#1 DEF COMP 10,#1D,1000000 ; X\r\n",
        " -32  -48 -48\r\n",
        "-48 -48 16 16 16 16 0\r\n",
        "I130=2000 I185=16 I186=96 I485=8 I486=32\r\n",
    ]


def test_the_card_keeps_a_save_of_the_scripts_back_until_the_sign_was_checked() -> None:
    steps = [(step.title, step.text) for step in PMAC.card]
    titles = [title for title, _ in steps]
    load = titles.index("Load the script")
    assert "A line SAVE in them" in steps[load][1]
    assert load < titles.index("Check the sign") < titles.index("Keep it")


def test_new_tables_stand_where_the_card_takes_them() -> None:
    wish = table([0, 100], [0, 1], [-1, -1], address="2")
    new = patched(OTHERS, wish, axes=[axis("2", (0, 100))])
    order = [line[:11] for line in new.splitlines() if "DEF" in line and line[0] == "#"]
    assert order == [
        "#4 DEFINE C", "#2 DEFINE C", "#1 DEF COMP", "#4 DEFINE B", "#2 DEFINE B",
    ]  # fmt: skip
    for line in OTHERS.splitlines():
        assert line in new.splitlines()
    assert new.index("I286=16") < len(new)


def test_a_table_of_another_motor_over_ours_is_emptied_into_our_own() -> None:
    text = "#2 DEFINE COMP 2,#1D,#1,200000\n16 0\n" + EXAMPLE
    new = patched(text, table([-100, 0, 100, 200], [1, 0, -2, -3]))
    assert new.startswith("#2 DEFINE COMP 2,#1D,#1,200000\n0 0\n")


def test_a_motor_whose_table_corrects_another_one() -> None:
    text = "#1 DEFINE COMP 2,#1D,#2,200000\n16 0\nI186=0\n"
    with pytest.raises(CapacityError, match="#1 COMP corrects #2 by #1"):
        patched(text, table([-100, 0, 100, 200], [1, 0, -2, -3]))


def test_switching_on_wakes_nobody_else() -> None:
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3])
    asleep = OTHERS.replace("I51=1", "I51=0")
    with pytest.raises(
        CapacityError, match="would switch on those of other motors: #4 COMP, #4 BLCOMP"
    ):
        patched(asleep, wish)
    assert "I51=1" in patched(EXAMPLE.replace("I51=1", "I51=0"), wish).splitlines()


def test_a_rate_of_0_becomes_one_that_takes_up() -> None:
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3], [0, -1, -3, -4])
    assert "I185=32 I186=16" in patched(EXAMPLE.replace("I185=32", "I185=0"), wish)


def test_every_changed_number_is_listed() -> None:
    old, new = EXAMPLE, EXAMPLE.replace("-48", "-47").replace("I186=96", "I186=97")
    changes = compare_files(PMAC, [script(old)], [script(new)]).changes
    assert [(one.old, one.new) for one in changes] == [("-48", "-47"), ("96", "97")]


# --- the fit and the judge


def test_an_axis_without_lost_motion_keeps_no_backlash_below_zero() -> None:
    """Readings of a scale: a reversal of -0.3 µm is noise, and this control cannot hold it."""
    where = np.linspace(0.0, 300.0, 31)
    curve = 0.004 * np.sin(where / 60)
    wanted = WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=where,
        positive=curve,
        negative=curve + 0.0003,
        reference=0.0,
        reference_return=MINUS,
        noise=0.0005,
        reversal_log_odds=0.0,
    )
    short = axis(travel=(0.0, 300.0), returns=MINUS)
    capacity = control().capacity(short)
    for mode in ("single", "bidirectional"):
        fitted = fit_table(wanted, capacity, TableRequest(mode=mode), address="1")
        assert fitted.compensation.positive[0] == 0.0
        assert fitted.compensation.negative[0] == 0.0
        assert "backlash range" in {limit.cause for limit in fitted.limits}
        control().write([fitted.compensation], [short])


@pytest.mark.parametrize(("counts", "zero"), [(1000.0, PLUS), (-1000.0, MINUS)])
@pytest.mark.parametrize("returns", list(Direction))
def test_zero_is_where_the_motor_counts_up_however_it_is_homed(
    counts: float, zero: Direction, returns: Direction
) -> None:
    where = np.linspace(0.0, 300.0, 31)
    curve = 0.004 * np.sin(where / 60)
    high, low = (curve, curve - 0.005) if returns is PLUS else (curve + 0.005, curve)
    wanted = WantedCorrection(
        kind=AxisKind.LINEAR,
        positions=where,
        positive=high,
        negative=low,
        reference=0.0,
        reference_return=returns,
        noise=0.0005,
        reversal_log_odds=0.0,
    )
    its_axis = axis(travel=(0.0, 300.0), returns=returns)
    capacity = control(counts).capacity(its_axis)
    found = fit_table(wanted, capacity, TableRequest(), address="1").compensation
    assert found.total(zero)[0] == 0.0
    assert found.positive[0] - found.negative[0] == pytest.approx(0.005, abs=1e-12)
    control(counts).write([found], [its_axis])


def test_tables_of_two_lengths_and_one_constant() -> None:
    text = EXAMPLE.replace("BLCOMP 4,400000\n8 12 -4 0", "BLCOMP 2,300000\n16 0")
    state = control().read([script(text)])
    assert at(state, "1", 100, PLUS) == pytest.approx(-2.0)
    # 16/16 count at 150 mm, two thirds of it at 100 mm; 6 counts of constant backlash.
    assert at(state, "1", 100, MINUS) == pytest.approx(-2.0 - 6.0 - 2 / 3)
    assert at(state, "1", 450, MINUS) == pytest.approx(-1.0 - 6.0 - 1.0)


def test_a_new_job_has_no_turn_for_a_linear_axis(tmp_path: Path) -> None:
    (tmp_path / "a.pmc").write_text(EXAMPLE)
    job = tmp_path / "job.yaml"
    words = ["new", "--from", str(tmp_path / "a.pmc"), "--format", "pmac", "--out", str(job)]
    assert compwright([*words, "--option", "counts_per_unit=1000"]) in (0, 2)
    assert "modulo" not in job.read_text()


@st.composite
def cases(draw: st.DrawFn) -> tuple[AxisCompensation, Axis, float]:
    counts = draw(st.sampled_from([1000.0, -1000.0, 8192.0, -10 / 3]))
    step = draw(st.integers(1, 50_000)) / abs(counts)
    below, above = draw(st.integers(0, 6)), draw(st.integers(1, 6))
    reference = draw(st.sampled_from([0.0, -37.5, 1000.0]))
    size = below + above + 1
    quantum = 1 / (16 * abs(counts))
    numbers = st.lists(st.integers(-400, 400), min_size=size, max_size=size)
    ahead, back = (np.array(draw(numbers), dtype=float) for _ in range(2))
    ahead[below], back[below] = 0.0, -np.sign(counts) * draw(st.integers(0, 300))
    positive, negative = (ahead, back) if counts > 0 else (back, ahead)
    nodes = reference + np.arange(-below, above + 1, dtype=np.float64) * step
    travel = (float(nodes[0]), float(nodes[-1]))
    wish = AxisCompensation(
        address="3",
        kind=AxisKind.LINEAR,
        positions=nodes,
        positive=positive * quantum,
        negative=negative * quantum,
    )
    return wish, axis("3", travel, reference=reference), counts


@given(case=cases())
@settings(deadline=None, max_examples=60)
def test_written_and_read_back_the_same_by_both_readers(
    case: tuple[AxisCompensation, Axis, float],
) -> None:
    wish, its_axis, counts = case
    files = control(counts).write([wish], [its_axis])
    state = control(counts).read(files, [its_axis])
    judge = virtual_control(
        "pmac",
        files,
        options={"counts_per_unit": counts},
        reference={"3": its_axis.reference},
    )
    step = wish.positions[1] - wish.positions[0]
    where = np.concatenate(
        [wish.positions, wish.positions + 0.37 * step, wish.positions[:1] - 2.9 * step]
    )
    for direction in Direction:
        right = wish.at(where, direction)
        np.testing.assert_allclose(state.axes["3"].at(where, direction), right, atol=1e-9)
        np.testing.assert_allclose(judge.correction("3", where, direction), right, atol=1e-9)
    assert control(counts).write([wish], [its_axis], files) == files


PIECES = st.sampled_from(
    [
        "#1 ", "#2 ", "#33", "DEFINE COMP ", "DEF BLCOMP ", "DEFINE TCOMP ", "DELETE COMP ", "DEL BLCOMP\n",
        "4,#1D,400000\n", "2,#1,#2,9\n", "2,90\n", "1.1,#1,#2,#1,9,9\n", "-32 ", "16 0\n", "0 0 ", "8 ", "I51=1 ",
        "I51=0\n", "I185=32 ", "I186=$60 ", "I185..187=0 ", "I186=", "OPEN PLC 1\n", "CLOSE\n", "; x\n", "\r\n", "SAVE ",
        "#1->1000X\n", "DEFINE GATHER\n", "DEL GAT ", "M1->*\n", "\xe9", ",", "$",
    ]
)  # fmt: skip


@given(pieces=st.lists(PIECES, max_size=25), active=st.sampled_from([None, True, False]))
@settings(deadline=None, max_examples=100)
def test_any_script_is_refused_or_both_readers_agree(
    pieces: list[str], active: bool | None
) -> None:
    files = [script("".join(pieces))]
    try:
        state = control().read(files, activity=Activity(stated=active))
        judge = virtual_control("pmac", files, options={"counts_per_unit": 1000.0}, active=active)
    except (InputError, UsageError):
        return
    where = np.linspace(-250.0, 250.0, 41)
    for address, found in state.axes.items():
        for direction in Direction:
            np.testing.assert_allclose(
                found.at(where, direction), judge.correction(address, where, direction), atol=1e-9
            )


def test_a_patched_script_is_refused_or_holds_what_was_asked_for() -> None:
    """Scripts cut and mixed at random: whatever comes out holds our table and that of others."""
    wish = table([-100, 0, 100, 200], [1, 0, -2, -3], [-5, -6, -8, -9])
    rng = np.random.default_rng(4)
    blocks = [
        "#4 DEFINE COMP 3,#4D,90000\n5 -5 0 ; rotary", "#1 DEF COMP 2,#1D,600000 ; X\n 1\n+0",
        "#4 DEFINE BLCOMP 3,90000\n1 2 0", "#1 DEFINE BLCOMP 2,600000\n1 0", "#2 DEFINE COMP 2,9 3 0",
        "#4 DELETE COMP", "I51=0", "I51=1", "DEFINE GATHER", "#3 DEFINE TCOMP 1,9\n0", "I286=7 I285=1",
    ]  # fmt: skip
    written = 0
    for _ in range(300):
        some = [str(block) for block in rng.permutation(blocks) if rng.random() < 0.5]
        some = ["I186=0 I185=1 I486=32 I485=8", *some]
        files = [script("\n".join(some) + "\n")]
        try:
            before = control().read(files)
            new = control().write([wish], [axis()], files)
            after = control().read(new)
        except CompwrightError:
            continue
        written += 1
        where = np.linspace(-100.0, 200.0, 31)
        for direction in Direction:
            np.testing.assert_allclose(
                after.axes["1"].at(where, direction), wish.at(where, direction), atol=1e-9
            )
            for other in set(before.axes) - {"1"}:
                np.testing.assert_allclose(
                    after.axes[other].at(where, direction),
                    before.axes[other].at(where, direction),
                )
    assert written > 50
