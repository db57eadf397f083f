"""Corrections between axes, family by family: values, signs and units of what is typed in, what is
stated where nothing holds them, and that what is written comes back.

Y follows X by 40 µm/m: the angle is larger than 90°, and Y is moved by + 40e-6 times the distance
of X from its reference.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.controls.control import Control, decode
from compwright.controls.cross_tables import CrossOutcome, write_planned
from compwright.formats.families.axis_pairs import Between, BetweenRequest
from compwright.formats.families.family import Family
from compwright.formats.families.increments.increment_facts import IncrementFacts
from compwright.formats.families.pairs.family import PairsFamily
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CompwrightError, UsageError
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts
from compwright.records.plan import PlannedCross
from format_samples import DEFINITIONS

SIEMENS = "siemens-840d-sl"
NCK, ITNC = "heidenhain-nck", "heidenhain-itnc530"
CEC: dict[str, Any] = {"cec": "available", "cec_sign": "correction", "cec_tables": "4,5"}


def family(format_id: str, state: ControlState | None = None, **options: object) -> Family:
    return control_format(DEFINITIONS[format_id], options, state)


def axis(name: str, address: str, **options: object) -> Axis:
    return Axis(
        name=name, kind=AxisKind.LINEAR, travel=(0.0, 800.0), address=address, options=options
    )


def follows(
    positions: Sequence[float] = (0.0, 800.0),
    *,
    reference: float = 0.0,
    addresses: tuple[str, str] = ("X", "Y"),
) -> PlannedCross:
    """Y after X by 40 µm/m of the distance from the reference, as two circles found it."""
    where = np.array(positions)
    values = 40e-6 * (where - reference)
    added = CrossCompensation(
        input=addresses[0],
        output=addresses[1],
        input_kind=AxisKind.LINEAR,
        output_kind=AxisKind.LINEAR,
        positions=where,
        positive=values,
        negative=values,
    )
    return PlannedCross(input="X", output="Y", added=added, source="circle", squareness=40e-6)


def ask(
    control: Family,
    *planned: PlannedCross,
    axes: Sequence[Axis] = (),
    tabled: Sequence[str] = (),
    tables: ControlState | None = None,
) -> Between:
    """``tables``: what the tables of this run say; without it nothing may be read."""
    base = () if tables is None else (ControlFile("table", b"of this run"),)

    def read(files: tuple[ControlFile, ...], *, written: bool = False) -> ControlState:
        assert tables is not None
        assert (files, written) == (base, False)
        return tables

    return control.between(
        BetweenRequest(
            found=(),
            planned=planned or (follows(),),
            axes={each.name: each for each in axes},
            tabled=tabled,
            tables=base,
            base=base,
            read=read,
        )
    )


def remarks(answer: Between) -> list[tuple[str, str]]:
    """Return severity and text of each remark."""
    return [(severity, str(printed)) for severity, printed in answer.remarks]


def rows(sheet: ControlFile, start: int) -> list[list[str]]:
    return [line.split(",") for line in sheet.content.decode().splitlines()[start:]]


# --- columns to type in


@pytest.mark.parametrize(
    ("whole", "moving", "sign"),
    [("error", "error", -1), ("error", "correction", 1), ("correction", "error", -1)],
)
def test_a_column_has_the_sign_of_the_moving_axis_table(whole: str, moving: str, sign: int) -> None:
    bent = axis("Y", "Y", table_values="error" if moving == "correction" else "correction")
    answer = ask(family(NCK, table_values=whole), axes=[axis("X", "X", table_values=moving), bent])
    (sheet,) = answer.sheets
    assert sheet.name == "cross_X_Y.csv"
    assert rows(sheet, 1) == [
        [f"# value: {moving}"],
        ["position_X", "Y", "unit"],
        ["0.0000", "0.0000", "mm"],
        ["800.0000", f"{sign * 0.032:.4f}", "mm"],
    ]
    ((severity, message),) = remarks(answer)
    assert severity == "warning"
    assert f"+0.0000 mm at 0, {sign * 0.032:+.4f} mm at 800. The commissioning card" in message
    assert f"The values are {moving}s" in message
    assert message[:1].islower()
    assert answer.files is None
    assert [step["evidence"] for step in answer.steps] == ["unconfirmed"]


def test_a_long_column_is_shown_by_its_ends_and_its_largest_value() -> None:
    long, short = follows(np.linspace(0.0, 800.0, 9).tolist()), follows([0.0, 400.0, 800.0])
    shown, whole = (ask(family(NCK, table_values="correction"), entry) for entry in (long, short))
    assert ": +0.0000 mm at 0, …, +0.0320 mm at 800 (" in shown.steps[0]["text"]
    assert "+0.0000 mm at 0, +0.0160 mm at 400, +0.0320 mm at 800" in whole.steps[0]["text"]
    assert len(rows(shown.sheets[0], 3)) == 9
    bent = np.array([0.0, 3.0, 5.0, 8.0, 2.0, -9.0, -4.0, -1.0, 0.0]) * 1e-3
    wave = replace(long, source="cross", added=replace(long.added, positive=bent, negative=bent))
    (step,) = ask(family(NCK, table_values="correction"), wave).steps
    values = ": +0.0000 mm at 0, …, -0.0090 mm at 500, …, +0.0000 mm at 800 ("
    assert values in step["text"]


@pytest.mark.parametrize(
    ("slope", "options", "tabled", "why"),
    [
        (-20e-6, {}, [], "MP720 corrects Y now (+0.020 mm/m)"),
        (-20e-6, {}, ["Y"], ""),  # the table of this run takes its place
        (0.0, {}, [], ""),
        (0.0, {"method": "line"}, ["Y"], "the job corrects Y by MP720 (method: line)"),
    ],
)
def test_no_column_beside_a_linear_error(
    slope: float, options: Mapping[str, Any], tabled: Sequence[str], why: str
) -> None:
    none = np.empty(0)
    now = AxisCompensation(
        address="Y",
        kind=AxisKind.LINEAR,
        positions=none,
        positive=none,
        negative=none,
        slope=slope,
    )
    state = ControlState(format=ITNC, axes={"Y": now})
    axes = [axis("X", "X"), axis("Y", "Y", **options)]
    answer = ask(family(ITNC, state), axes=axes, tabled=tabled)
    ((severity, message),) = remarks(answer)
    assert (severity, bool(answer.sheets)) == (("error", False) if why else ("warning", True))
    assert why in message


# --- straightness compensation


def line_of(address: str = "1") -> ControlState:
    """A table of the moving axis: numbers 10 to 26, each of 50 mm."""
    nodes = np.linspace(0.0, 800.0, 17)
    zero = np.zeros(17)
    table = AxisCompensation(
        address=address, kind=AxisKind.LINEAR, positions=nodes, positive=zero, negative=zero
    )
    facts = {address: AxisFacts(of_family=IncrementFacts(first_number=10, last_number=26))}
    return ControlState(format="fanuc-30i", axes={address: table}, facts=facts)


FANUC: dict[str, Any] = {"straightness": "available", "first_point": 10}
LINE_ONLY = "one straight line over a table only"
NO_PITCH_TABLE = "Next: give X a positioning test (`before`)"


def test_a_straight_line_is_typed_in_pulses_of_the_axis_that_is_bent() -> None:
    axes = [axis("X", "1", detection_unit=0.001), axis("Y", "2", detection_unit=0.0005)]
    answer = ask(
        family("fanuc-30i", **FANUC),
        follows(addresses=("1", "2")),
        axes=axes,
        tables=line_of(),
    )
    (sheet,) = answer.sheets
    # 40 µm/m · 50 mm = 2 µm at the end of the first section, 32 µm at the last; pulses of 0.5 µm
    assert [(row[0], row[1]) for row in rows(sheet, 2)] == [
        *(("5711", "1"), ("5721", "2")),
        *(("5731", "10"), ("5732", "10"), ("5733", "26"), ("5734", "26")),
        *(("5761", "4"), ("5762", "4"), ("5763", "64"), ("5764", "64")),
    ]
    assert sheet.name in remarks(answer)[0][1]


@pytest.mark.parametrize(
    ("planned", "tables", "why"),
    [
        ([follows([0.0, 400.0, 800.0], addresses=("1", "2"))], line_of(), LINE_ONLY),  # a curve
        ([follows(addresses=("1", "2"))] * 2, line_of(), LINE_ONLY),  # a second pair
        ([follows(addresses=("1", "2"))], line_of("3"), NO_PITCH_TABLE),
        ([follows(addresses=("1", "2"))], None, NO_PITCH_TABLE),
    ],
)
def test_more_than_one_straight_line_over_a_table_is_not_held(
    planned: Sequence[PlannedCross], tables: ControlState | None, why: str
) -> None:
    axes = [axis("X", "1"), axis("Y", "2")]
    control = family("fanuc-30i", detection_unit=0.001, **FANUC)
    answer = ask(control, *planned, axes=axes, tables=tables)
    ((severity, text),) = remarks(answer)
    assert severity == "error"
    assert why in text
    assert answer.sheets == ()


def test_one_message_names_all_corrections_that_two_tables_do_not_hold() -> None:
    """Three planes need three tables: the message about the third pair came three times."""
    pairs = (("AX1", "AX2"), ("AX2", "AX3"), ("AX3", "AX1"))
    planned = [
        replace(follows(addresses=pair), input=one, output=other)
        for pair, one, other in zip(pairs, "XYZ", "YZX", strict=True)
    ]
    axes = [axis(name, f"AX{number}") for number, name in enumerate("XYZ", 1)]
    answer = ask(
        family(SIEMENS, **CEC), *planned, axes=axes, tables=ControlState(format=SIEMENS, axes={})
    )
    ((severity, text),) = remarks(answer)
    assert severity == "error"
    for pair in ("Y over X", "Z over Y", "X over Z"):
        assert f"squareness of {pair} (+40.0 µm/m)" in text
    assert "squareness of X over Z (+40.0 µm/m) are not corrected: " in text
    assert text.count("AX1 over AX3") == 1
    assert len(answer.steps) == 1


# --- what helps instead


def test_a_kinematic_matrix_takes_the_angle_and_says_what_it_moves() -> None:
    """The line of the matrix runs through machine zero: with the reference at 100 mm everything
    moves by 40e-6 · 100 mm = 4 µm.
    """
    ((_, plain),) = remarks(ask(family("linuxcnc"), follows()))
    assert "add +0.000040000 to the value of matrixkins.C_yx that is in force; without" in plain
    ((_, moved),) = remarks(ask(family("linuxcnc"), follows([-100.0, 700.0], reference=100.0)))
    assert "in force, which also moves Y as a whole by +4.00 µm; without it" in moved


@pytest.mark.parametrize("format_id", DEFINITIONS)
def test_every_control_answers(format_id: str) -> None:
    """Without any option a control types a column in, says what would help, or asks for the sign
    of the values that it would write.
    """
    if format_id == "isg-kernel":
        with pytest.raises(UsageError, match="is not documented"):
            ask(family(format_id))
        return
    ((severity, printed),) = remarks(ask(family(format_id)))
    assert "squareness of Y over X (+40.0 µm/m)" in printed
    assert severity == ("error" if "is not corrected" in printed else "warning")


def test_every_correction_is_said() -> None:
    bent = replace(follows(), input="Z", source="cross", squareness=-12.5e-6)
    answer = ask(family(SIEMENS), follows(), bent)
    assert [printed.split(": ")[0] for _, printed in remarks(answer)] == [
        "squareness of Y over X (+40.0 µm/m) is not corrected",
        "the measured deviation of Y over Z (+12.5 µm/m) is not corrected",
    ]
    assert [step["title"] for step in answer.steps] == [
        "Not corrected: squareness of Y over X (+40.0 µm/m)",
        "Not corrected: the measured deviation of Y over Z (+12.5 µm/m)",
    ]


# --- tables of their own


def write(entry: PlannedCross, **options: Any) -> CrossOutcome:
    control = Control(family(SIEMENS, **{**CEC, **options}))
    axes = {"X": axis("X", "AX1"), "Y": axis("Y", "AX2")}
    return write_planned(control, [entry], (), decode(control, ()), axes)


@pytest.mark.parametrize("sign", ["correction", "error"])
def test_what_is_written_comes_back_with_its_sign(sign: str) -> None:
    outcome = write(follows(addresses=("AX1", "AX2")), cec_sign=sign)
    assert outcome.written
    (total,) = outcome.totals
    assert (total.input, total.output) == ("X", "Y")
    assert total.positive[[0, -1]] == pytest.approx([0.0, 0.032], abs=1e-6)
    assert [step["title"] for step in outcome.steps] == [
        f"Y over X: {step}"
        for step in ("reserve and switch off", "check the sign", "load", "switch on")
    ]
    assert "+0.00 µm at X 0, +32.00 µm at X 800" in outcome.steps[2]["text"]
    assert "must be at least 2 for table 4. If" in outcome.steps[0]["text"]


#: A table over X that bends Y, on: 0 and 10 µm at 0 and 800 mm. Table 4 is off.
BENT_BEFORE = """\
$AN_CEC[3,0]=0
$AN_CEC[3,1]=0.01
$AN_CEC_INPUT_AXIS[3]=(AX1)
$AN_CEC_OUTPUT_AXIS[3]=(AX2)
$AN_CEC_STEP[3]=800
$AN_CEC_MIN[3]=0
$AN_CEC_MAX[3]=800
$AN_CEC_DIRECTION[3]=0
$AN_CEC_MULT_BY_TABLE[3]=0
$AN_CEC_IS_MODULO[3]=0
N32710 $MA_CEC_ENABLE[AX2]=1
$SN_CEC_TABLE_ENABLE[3]=1
$SN_CEC_TABLE_ENABLE[4]=0
M17
"""


def test_own_files_keep_their_names_and_tables_that_were_there_are_none_of_ours() -> None:
    own = ControlFile("CEC.MPF", BENT_BEFORE.encode())
    axes = {"X": axis("X", "AX1"), "Y": axis("Y", "AX2")}
    control = Control(family(SIEMENS, **CEC))
    found = decode(control, (own,), list(axes.values()))
    planned = [follows(addresses=("AX1", "AX2"))]
    outcome = write_planned(control.in_state(found.state), planned, (), found, axes)
    assert [file.name for file in outcome.files] == ["CEC.MPF", "AX2_CROSS.INI"]
    (total,) = outcome.totals
    assert total.positive[[0, -1]] == pytest.approx([0.0, 0.042], abs=1e-6)
    steps = " ".join(step["text"] for step in outcome.steps)
    assert "for table 4" in steps
    assert "tables 3" not in steps


@pytest.mark.parametrize("factor", [-1.0, 0.0, 1.001])
def test_something_else_in_the_files_is_a_fault_of_our_own(
    factor: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    honest = PairsFamily.between

    def wrong(control: PairsFamily, asked: BetweenRequest) -> Between:
        bent = [
            replace(
                entry,
                added=replace(
                    entry.added,
                    positive=factor * entry.added.positive,
                    negative=factor * entry.added.negative,
                ),
            )
            for entry in asked.planned
        ]
        answer = honest(control, replace(asked, planned=tuple(bent)))
        return answer if factor else replace(answer, files=())

    monkeypatch.setattr(PairsFamily, "between", wrong)
    with pytest.raises(CompwrightError, match="differs from the planned table"):
        write(follows(addresses=("AX1", "AX2")))


# --- refusals in each language

#: What stays in every language: parameters, options, formats, standard words in backquotes.
NAME = re.compile(r"`[^`]*`|[$]?[A-Z]+\w*(?:\[[^]]*\])?|siemens-\w+-\w+|method: line|lr_param\S*")


#: Tables of an iTNC 530 in which X and Y have values for Y, and the line that makes them active.
SAG = """BEGIN X .COM MM DATUM:0 DIST:400
NR   1=F()     2=F()
0    +0.0000   +0.0000
1    +0.0000   +0.0040
2    +0.0000   +0.0080
END X .COM
"""
LINE = "BEGIN CONFIG .CMA MM\nNR   1         2\n0    X         Y\nEND CONFIG .CMA\n"


def refused(case: str) -> Between:
    """An answer that the correction of Y over X is not made."""
    if case == "linear parameter":
        axes = [axis("X", "X"), axis("Y", "Y", method="line")]
        return ask(family(ITNC), axes=axes, tabled=["Y"])
    if case in ("straightness", "no pitch table"):
        control = family("fanuc-30i", detection_unit=0.001, **FANUC)
        pair = [follows(addresses=("1", "2"))] * (2 if case == "straightness" else 1)
        tables = line_of("1" if case == "straightness" else "3")
        return ask(control, *pair, axes=[axis("X", "1"), axis("Y", "2")], tables=tables)
    if case == "one input":
        other = replace(follows(), input="Z", added=replace(follows().added, input="Z"))
        planned, axes = [follows(), other], [axis("Y", "Y", cross_values="error")]
        control = family("isg-kernel", cross_values="error")
        return ask(control, *planned, axes=axes, tables=ControlState(format="isg-kernel", axes={}))
    own_options: dict[str, dict[str, Any]] = {
        "no option": {"cec": "absent"},
        "no table": {"cec_tables": ()},
    }
    options = own_options.get(case, {})
    text = BENT_BEFORE
    if case == "table beyond":
        options = {"cec_tables": (62,)}
        text = (
            "".join(f"$MN_MM_CEC_MAX_POINTS[{one}]={2 * (one == 3)}\n" for one in range(62)) + text
        )
    elif case == "own table":
        options, text = {"cec_tables": (3,)}, text.replace("ENABLE[3]=1", "ENABLE[3]=0")
    own: tuple[ControlFile, ...] = (ControlFile("CEC.INI", text.encode()),)
    control, names = family(SIEMENS, **{**CEC, **options}), ("AX1", "AX2")
    if case == "columns not active":
        texts = {"CONFIG.CMA": LINE, "MP.TXT": "MP730 : %00001\n", "X.COM": SAG}
        texts["Y.COM"] = SAG.replace("X", "Y")
        own = tuple(ControlFile(name, text.encode()) for name, text in texts.items())
        control, names = family(ITNC), ("X", "Y")
    found = decode(Control(control), own, [axis("X", names[0]), axis("Y", names[1])])

    def read(files: tuple[ControlFile, ...], *, written: bool = False) -> ControlState:
        assert (files, written) == (own, False)
        return found.state

    return control.between(
        BetweenRequest(
            found=own,
            planned=(follows(addresses=names),),
            axes={},
            tabled=(),
            tables=(),
            base=own,
            read=read,
        )
    )


@pytest.mark.parametrize(
    "case",
    [
        *("linear parameter", "straightness", "no pitch table", "one input", "no option"),
        *("no table", "own table", "columns not active"),
    ],
)
def test_the_reason_of_a_refusal_is_in_the_language_of_the_page(case: str) -> None:
    """No two English words in a row are in the Russian text, which has other letters."""
    ((_, printed), *_) = refused(case).remarks
    assert " not corrected: " in str(printed)
    if case == "columns not active":
        assert "(X.COM, столбец 2=F(), Y.COM, столбец 2=F())" in printed.text("ru")
    russian = NAME.sub("", printed.text("ru"))
    assert re.search(r"[a-z]+ [a-z]+", russian) is None, russian
    for language in ("de", "fr"):
        assert not {"the", "is", "and"} & set(printed.text(language).split())


def test_a_table_that_the_files_of_the_control_do_not_list_is_not_written() -> None:
    """A real 840D sl lists MD18342 for its tables 0 to 61: a table 62 is taken by no control."""
    answer = refused("table beyond")
    ((severity, printed),) = answer.remarks
    assert (severity, answer.files) == ("error", None)
    assert "$MN_MM_CEC_MAX_POINTS[62]" in str(printed)
    assert "indices from 0 to 61" in str(printed)
