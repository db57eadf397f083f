"""SINUMERIK 840D sl: the text forms of the manual and of real files, by hand-worked numbers."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.formats.definitions import load_definition
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.records.axis import AxisKind, Direction
from format_samples import CONTENT, SIEMENS, axis_of, codes, correction, files, siemens, table

POSITIVE, NEGATIVE = Direction.POSITIVE, Direction.NEGATIVE

# As printed in the function manual (own numbers): values are errors, so the correction is the
# opposite.
SAMPLE = """%_N_AX_EEC_INI
CHANDATA(1)
$AA_ENC_COMP[0,0,AX1]=0.003
$AA_ENC_COMP[0,1,AX1]=0.001
$AA_ENC_COMP[0,2,AX1]=0.0
$AA_ENC_COMP[0,3,AX1]=-0.002
$AA_ENC_COMP[0,4,AX1]=-0.0045
$AA_ENC_COMP_STEP[0,AX1]=50.0
$AA_ENC_COMP_MIN[0,AX1]=-100.0
$AA_ENC_COMP_MAX[0,AX1]=100.0
$AA_ENC_COMP_IS_MODULO[0,AX1]=0
M17
"""
NODES = [-100.0, -50.0, 0.0, 50.0, 100.0]
CORRECTIONS = [-0.003, -0.001, 0.0, 0.002, 0.0045]  # mm


def test_the_manuals_sample_is_the_opposite_of_its_values() -> None:
    state = siemens(SAMPLE)
    axis = state.axes["AX1"]
    np.testing.assert_array_equal(axis.positions, NODES)
    np.testing.assert_array_equal(axis.positive, CORRECTIONS)
    np.testing.assert_array_equal(axis.negative, CORRECTIONS)
    assert axis.kind is AxisKind.LINEAR
    # between two points linear, outside the end values (manual p237, p240)
    assert correction(state, "AX1", -75.0, POSITIVE) == pytest.approx(-0.002, abs=1e-12)
    assert correction(state, "AX1", -100.001, POSITIVE) == pytest.approx(-0.003, abs=1e-12)
    assert correction(state, "AX1", 999.0, NEGATIVE) == pytest.approx(0.0045, abs=1e-12)


def test_what_the_files_do_not_say_is_listed() -> None:
    state = siemens(SAMPLE)
    facts = {note.fact: note.value for note in state.assumed}
    assert any("ENC_COMP_ENABLE" in fact and value == "yes" for fact, value in facts.items())
    assert any("BACKLASH" in fact and value == "0" for fact, value in facts.items())
    assert facts["reference"] == "0"
    assert facts["reference_return"] == "+"
    assert "CW-S005" in codes(state)  # no MD32450 in the files: said as a warning


def test_backlash_acts_against_the_direction_of_the_reference_return() -> None:
    text = SAMPLE.replace("M17", "$MA_BACKLASH[0,AX1]=0.004\nM17")
    plus = siemens(text, axis_of("AX1"))
    assert correction(plus, "AX1", 0.0, POSITIVE) == 0.0
    assert correction(plus, "AX1", 0.0, NEGATIVE) == pytest.approx(-0.004)
    minus = siemens(text, axis_of("AX1", returns=NEGATIVE))
    assert correction(minus, "AX1", 0.0, POSITIVE) == pytest.approx(0.004)
    assert correction(minus, "AX1", 0.0, NEGATIVE) == 0.0
    option = siemens(text, options={"reference_return": "-"})
    assert correction(option, "AX1", 0.0, POSITIVE) == pytest.approx(0.004)


@pytest.mark.parametrize(
    ("what", "change"),
    [
        ("no header", lambda t: t.split("\n", 1)[1]),
        ("other header", lambda t: t.replace("%_N_AX_EEC_INI",
        "%_N_AX1_EEC_INI\n;$PATH=/_N_NC_ACT_DIR")),
        ("starts at CHANDATA, ends with M30", lambda t: t.split("\n", 1)[1].replace("M17", "M30")),
        ("M0 then M17", lambda t: t.replace("M17", "M0\nM17")),
        ("M02", lambda t: t.replace("M17", "M02")),
        ("blanks around =", lambda t: t.replace("=", " = ")),
        ("plus sign", lambda t: t.replace("=0.003", "=+0.003")),
        ("six decimals and -0.0", lambda t: t.replace("=0.0\n", "=-0.0\n").replace("0.003",
        "0.003000")),
        ("comments", lambda t: t.replace("\n", " ; comment with = and [0,9,AX1]\n")),
        ("line ends of Windows", lambda t: t.replace("\n", "\r\n")),
        ("block numbers", lambda t: t.replace("$AA", "N10 $AA")),
        ("line checksums", lambda t: t.replace("-0.0045\n", "-0.0045 '1A2f\n").replace("50.0\n",
        "50.0 '0000\n")),
        ("blank lines and tabs", lambda t: t.replace("\n", "\t\n\n")),
        ("lower case", str.lower),
        ("comments in another character set", lambda t: t.replace("M17", "; Zähler µm\nM17")),
        ("values after the parameters", lambda t: "\n".join(sorted(t.replace("M17\n",
        "").split("\n"), key=lambda line: "COMP[" in line)) + "\nM17\n"),
        ("a value given twice, the same", lambda t: t.replace("CHANDATA(1)",
        "CHANDATA(1)\n$AA_ENC_COMP[0,0,AX1]=0.0030")),
        ("unused memory behind the end", lambda t: t.replace("M17",
        "$AA_ENC_COMP[0,5,AX1]=0\n$AA_ENC_COMP[0,6,AX1]=0.0\nM17")),
        ("other data around",
        lambda t: "N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]=\"X1\"\n$MA_KP[0,AX1]=1,5\n" + t),
    ],
)  # fmt: skip
def test_variants_of_the_text_mean_the_same(what: str, change) -> None:  # type: ignore[no-untyped-def]
    axis = siemens(change(SAMPLE)).axes["AX1"]
    np.testing.assert_array_equal(axis.positions, NODES)
    np.testing.assert_array_equal(axis.positive, CORRECTIONS)


@pytest.mark.parametrize("kept", [3, 4])
def test_an_older_longer_table_behind_the_end_is_named_and_not_used(kept: int) -> None:
    """Points above k = (MAX - MIN) / STEP are ignored: FB2 09/2009, 6FC5397-1BP20-0BA0, p362 (EEC).
    The value of point k holds beyond it (FB2 03/2013 p240).
    """
    end = NODES[kept - 1]
    state = siemens(SAMPLE.replace("_MAX[0,AX1]=100.0", f"_MAX[0,AX1]={end}"))
    axis = state.axes["AX1"]
    np.testing.assert_array_equal(axis.positions, NODES[:kept])
    np.testing.assert_array_equal(axis.positive, CORRECTIONS[:kept])
    (told,) = [finding for finding in state.findings if finding.code == "CW-S004"]
    assert told.severity == "warning"
    assert f"({kept} to 4)" in told.message


def test_a_blank_instead_of_the_equals_sign_is_read_with_a_warning() -> None:
    state = siemens(SAMPLE.replace("=", " "))
    np.testing.assert_array_equal(state.axes["AX1"].positive, CORRECTIONS)
    assert "CW-S013" in codes(state)
    assert "CW-S013" not in codes(siemens(SAMPLE))


def test_several_axes_and_tables_in_one_file() -> None:
    text = SAMPLE.replace("M17", "") + SAMPLE.replace("AX1", "AX2").replace("0.003", "0.007")
    state = siemens(text)
    assert list(state.axes) == ["AX1", "AX2"]
    assert state.axes["AX2"].positive[0] == -0.007
    assert state.axes["AX1"].positive[0] == -0.003
    only = siemens(text, axis_of("ax2"))
    assert list(only.axes) == ["AX2"]


def test_the_measuring_system_of_the_job_counts() -> None:
    both = (
        SAMPLE.replace("M17", "")
        + SAMPLE.replace("[0,", "[1,").replace("0.003", "0.009").replace("M17\n", "")
        + "$MA_BACKLASH[1,AX1]=0.002\nM17\n"
    )
    second = siemens(both, axis_of("AX1", system=2))
    assert second.axes["AX1"].positive[0] == -0.009
    assert second.axes["AX1"].backlash == 0.002
    first = siemens(both, axis_of("AX1", system=1))
    assert first.axes["AX1"].positive[0] == -0.003
    assert first.axes["AX1"].backlash == 0.0
    shown = siemens(both)
    assert shown.axes["AX1"].positive[0] == -0.003
    assert "CW-S006" in codes(shown)  # both hold a table: said
    assert siemens(both, options={"encoder_system": "2"}).axes["AX1"].positive[0] == -0.009
    off = both.replace("M17\n", "$MA_ENC_COMP_ENABLE[0,AX1]=0\n$MA_ENC_COMP_ENABLE[1,AX1]=1\nM17\n")
    assert siemens(off).axes["AX1"].positive[0] == -0.009


def test_a_table_of_the_other_measuring_system_is_not_nothing() -> None:
    text = SAMPLE.replace("[0,", "[1,")
    with pytest.raises(InputError, match="measuring system 1") as caught:
        siemens(text, axis_of("AX1", system=1))
    assert "system 2" in str(caught.value)
    assert (
        siemens(text).axes["AX1"].positive[0] == -0.003
    )  # without a job: the one that holds a table
    named = text.replace(
        "M17", "$MA_BACKLASH[0,AX1]=0\nM17"
    )  # the first system is spoken of, and still holds no table
    with pytest.raises(InputError, match="measuring system 1"):
        siemens(named, axis_of("AX1", system=1))
    off = named.replace(
        "M17", "$MA_ENC_COMP_ENABLE[1,AX1]=0\nM17"
    )  # a table that is switched off does not stand in the way
    assert siemens(off, axis_of("AX1", system=1)).axes["AX1"].positions.size == 0


@pytest.mark.parametrize(
    ("sequence", "active"),
    [
        (["0", "1"], True),
        (["1", "0"], False),
        (["0"], False),
        (["1"], True),
        (["0", "1", "0"], False),
    ],
)
def test_a_load_sequence_counts_by_its_last_value(sequence: list[str], active: bool) -> None:
    lines = [f"$MA_ENC_COMP_ENABLE[0,AX1]={value}\nNEWCONF" for value in sequence]
    text = (
        lines[0]
        + "\n"
        + SAMPLE.replace("M17", "$MA_BACKLASH[0,AX1]=0.002\n" + "\n".join(lines[1:]) + "\nM30")
    )
    state = siemens(text)
    assert state.axes["AX1"].positions.size == (5 if active else 0)
    assert state.axes["AX1"].backlash == 0.002  # MD32700 switches the table, not the backlash
    assert ("CW-S007" in codes(state)) is not active
    assert state.facts["AX1"].enabled is active


def test_switched_on_without_the_table_is_contradictory() -> None:
    archive = "$MA_ENC_COMP_ENABLE[0,AX1]=1\n$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=26\n$MA_BACKLASH[0,AX1]=0\nM17\n"
    with pytest.raises(InputError, match="no given file"):
        siemens(archive)
    quiet = siemens(archive.replace("=26", "=0"))  # no points reserved: there cannot be a table
    assert quiet.axes["AX1"].positions.size == 0
    backlash_alone = siemens("CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.003\nM17\n")
    assert backlash_alone.axes["AX1"].backlash == 0.003
    assert "CW-S008" in codes(backlash_alone)


@pytest.mark.parametrize(
    ("what", "old", "new", "says"),
    [
        ("no spacing", "$AA_ENC_COMP_STEP[0,AX1]=50.0\n", "", "no grid"),
        ("no start", "$AA_ENC_COMP_MIN[0,AX1]=-100.0\n", "", "no grid"),
        ("no end", "$AA_ENC_COMP_MAX[0,AX1]=100.0\n", "", "no grid"),
        ("a gap", "$AA_ENC_COMP[0,2,AX1]=0.0\n", "", "values are missing"),
        ("no last value", "$AA_ENC_COMP[0,4,AX1]=-0.0045\n", "", "values are missing"),
        ("a spacing that does not divide", "=50.0", "=60.0", "does not divide"),
        ("a rounded spacing", "=50.0", "=50.1", "does not divide"),
        ("half the spacing", "=50.0", "=25.0", "values are missing"),
        ("spacing 0", "=50.0", "=0.0", "not positive"),
        ("spacing below 0", "=50.0", "=-50.0", "not"),
        ("end below start", "=100.0", "=-150.0", "not above"),
        ("contradictory value", "CHANDATA(1)", "CHANDATA(1)\n$AA_ENC_COMP[0,0,AX1]=0.004",
        "contradicts"),
        ("contradictory end", "M17", "$AA_ENC_COMP_MAX[0,AX1]=150.0\nM17", "contradicts"),
        ("decimal comma", "=0.003", "=0,003", "decimal comma"),
        ("text for a number", "=0.003", "=0.003mm", "cannot be read"),
        ("exponent", "=0.003", "=3E-3", "cannot be read"),
        ("a damaged name", "$AA_ENC_COMP[0,1,AX1]", "$AA_ENC_COMPX[0,1,AX1]", "cannot be read"),
        ("a missing bracket", "$AA_ENC_COMP[0,1,AX1]", "$AA_ENC_COMP[0,1,AX1", "cannot be read"),
        ("an implausible value", "=0.003", "=30.0", "not plausible"),
        ("unknown switch", "IS_MODULO[0,AX1]=0", "IS_MODULO[0,AX1]=2", "not known"),
        ("more points than the control has", "M17", "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=4\nM17",
        "reserved"),
        ("repeats with unequal ends", "IS_MODULO[0,AX1]=0", "IS_MODULO[0,AX1]=1",
        "two ends differ"),
        ("no values at all", SAMPLE[: SAMPLE.index("$AA_ENC_COMP_STEP")], "", "a grid without values"),
        ("backlash cannot be read", "M17", "$MA_BACKLASH[0,AX1]=x\nM17", "cannot be read"),
        ("the end of the file inside a number", "\nM17\n", "", "cut short"),
    ],
)  # fmt: skip
def test_contradictory_or_unreadable_files_are_refused(
    what: str, old: str, new: str, says: str
) -> None:
    assert old in SAMPLE
    with pytest.raises(InputError, match=says) as caught:
        siemens(SAMPLE.replace(old, new, 1))
    assert "A.INI" in str(caught.value)


def test_cut_anywhere_a_file_is_refused_or_complete() -> None:
    """A file that was cut short: an error, or (cut behind the last number) all values and a
    warning.
    """
    for length in range(len(SAMPLE)):
        try:
            state = siemens(SAMPLE[:length])
        except InputError:
            continue
        np.testing.assert_array_equal(state.axes["AX1"].positive, CORRECTIONS)
        assert "CW-S002" in codes(state) or SAMPLE[:length].rstrip().endswith("M17")


def test_a_binary_archive_is_refused_with_a_hint() -> None:
    with pytest.raises(InputError, match="binary"):
        control_format(SIEMENS, {}).read(files(X__ARC="ARC\x00\x01\x02$AA_ENC_COMP"))


def test_all_faults_of_all_files_come_at_once() -> None:
    broken = SAMPLE.replace("=0.001", "=?").replace("=-0.002", "=0,002")
    with pytest.raises(InputError) as caught:
        control_format(SIEMENS, {}).read(files(A__INI=broken, B__INI="$MA_BACKLASH[0,AX2]=\n"))
    assert [fault.place for fault in caught.value.faults] == ["line 4", "line 6", "line 1"]
    assert [fault.file for fault in caught.value.faults] == ["A.INI", "A.INI", "B.INI"]


def test_files_that_say_nothing_or_another_axis() -> None:
    with pytest.raises(InputError, match="no compensation data"):
        siemens("G1 X10\nM30\n")
    with pytest.raises(InputError, match="states the compensation of axis AX3"):
        siemens(SAMPLE, axis_of("AX3"))
    with pytest.raises(UsageError):
        siemens(SAMPLE, axis_of("1"))
    with pytest.raises(UsageError):
        control_format(SIEMENS, {}).read(())


def test_two_files_have_to_agree() -> None:
    with pytest.raises(InputError, match=r"contradicts A\.INI"):
        control_format(SIEMENS, {}).read(
            files(
                A__INI="$MA_BACKLASH[0,AX1]=0.001\nM17\n", B__INI="$MA_BACKLASH[0,AX1]=0.002\nM17\n"
            )
        )
    last = siemens("$MA_BACKLASH[0,AX1]=0.001\n$MA_BACKLASH[0,AX1]=0.002\nM17\n")
    assert last.axes["AX1"].backlash == 0.002
    assert "CW-S003" in codes(last)


def test_the_kind_of_axis_from_the_machine_data() -> None:
    text = SAMPLE.replace("M17", "N30300 $MA_IS_ROT_AX[AX1]=1\nM17")
    assert siemens(text).axes["AX1"].kind is AxisKind.ROTARY
    assert siemens(text, axis_of("AX1", kind=AxisKind.ROTARY)).axes["AX1"].kind is AxisKind.ROTARY
    with pytest.raises(InputError, match="linear in the job and rotary in the control"):
        siemens(text, axis_of("AX1"))


# Writing
# --------------------------------------------------------------------------------------------------

WRITTEN = """%_N_AX_EEC_INI
CHANDATA(1)
$AA_ENC_COMP[1,0,AX1]=0.003000
$AA_ENC_COMP[1,1,AX1]=0.001000
$AA_ENC_COMP[1,2,AX1]=0.000000
$AA_ENC_COMP[1,3,AX1]=-0.002000
$AA_ENC_COMP[1,4,AX1]=-0.004500
$AA_ENC_COMP_STEP[1,AX1]=50.000000
$AA_ENC_COMP_MIN[1,AX1]=-100.000000
$AA_ENC_COMP_MAX[1,AX1]=100.000000
$AA_ENC_COMP_IS_MODULO[1,AX1]=0
M17
"""


def test_the_written_files_are_those_of_the_manual() -> None:
    compensation = table("AX1", NODES, CORRECTIONS, backlash=0.0125)
    eec, md = control_format(SIEMENS, {}).write([compensation], [axis_of("AX1", system=2)])
    assert eec.name == "AX1_EEC.INI"
    assert eec.content.decode() == WRITTEN
    assert md.name == "AX1_MD.INI"
    assert (
        md.content.decode()
        == "CHANDATA(1)\n$MA_BACKLASH[1,AX1]=0.012500\n$MA_ENC_COMP_ENABLE[1,AX1]=1\nM17\n"
    )
    none = control_format(SIEMENS, {}).write([table("AX1", NODES, CORRECTIONS)], [axis_of("AX1")])
    assert (
        b"$MA_BACKLASH[0,AX1]=0.000000" in none[1].content
    )  # part of the complete set, also when it is 0


def test_the_capacity_is_what_the_manual_says() -> None:
    state = siemens(SAMPLE.replace("M17", "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=26\nM17"))
    capacity = control_format(SIEMENS, {}, state).capacity(axis_of("AX1"))
    assert (capacity.curves, capacity.spacing) == (1, "equidistant")
    assert (capacity.quantum, capacity.position_quantum, capacity.backlash_quantum) == (
        1e-6,
        1e-6,
        1e-6,
    )  # mm
    assert (capacity.below, capacity.above) == ("hold", "hold")
    assert (capacity.min_points, capacity.max_points) == (2, 26)
    assert (
        control_format(SIEMENS, {"points": "801"}, state).capacity(axis_of("AX1")).max_points == 801
    )  # what will be reserved
    assert control_format(SIEMENS, {"points": "9000"}).capacity(axis_of("AX1")).max_points == 5000
    unknown = control_format(SIEMENS, {}).capacity(axis_of("AX1"))
    assert unknown.max_points is None
    assert unknown.assumed
    empty = siemens("$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=0\n$MA_BACKLASH[0,AX1]=0\nM17\n")
    assert (
        control_format(SIEMENS, {}, empty).capacity(axis_of("AX1")).max_points is None
    )  # must be set anyway: the card says so


@pytest.mark.parametrize(
    ("what", "changes", "options", "says"),
    [
        ("two curves", {"negative": [0.0] * 5}, {}, "one table"),
        ("one point", {"positions": [0.0], "positive": [0.0]}, {}, "too few"),
        ("no point", {"positions": [], "positive": []}, {}, "too few"),
        ("too many points", {}, {"points": 4}, "at most 4"),
        ("more than any control has", {"positions": range(5001), "positive": [0.0] * 5001}, {},
        "at most 5000"),
        ("unequal spacing", {"positions": [-100, -50, 0.001, 50, 100]}, {}, "equally spaced"),
        ("a value between the steps", {"positive": [-0.003, -0.0010005, 0.0, 0.002, 0.0045]}, {},
        "multiple"),
        ("a node between the steps", {"positions": np.array(NODES) + 5e-7}, {}, "multiple"),
        ("a spacing between the steps", {"positions": np.linspace(0, 100.000001, 5)}, {},
        "multiple"),
        ("a value out of range", {"positive": [-0.003, -0.001, 0.0, 0.002, 10.5]}, {}, "outside"),
        ("backlash out of range", {"backlash": 11.0}, {}, "outside"),
        ("backlash between the steps", {"backlash": 0.0000015}, {}, "multiple"),
        ("another end than the control's", {"below": "zero"}, {}, "below the first point"),
        ("not finite", {"positive": [-0.003, float("nan"), 0.0, 0.002, 0.0045]}, {}, "finite"),
        ("not ascending", {"positions": [-100, -50, 0, 0, 100]}, {}, "ascend"),
        ("values missing", {"positive": [0.0] * 4}, {}, "lengths"),
    ],
)  # fmt: skip
def test_what_the_control_cannot_hold_is_refused(
    what: str, changes: dict[str, object], options: dict[str, object], says: str
) -> None:
    values: dict[str, object] = {"positions": NODES, "positive": CORRECTIONS, **changes}
    compensation = table("AX1", **values)  # type: ignore[arg-type]  # a table of changes
    with pytest.raises(CapacityError, match=says):
        control_format(SIEMENS, options).write([compensation], [axis_of("AX1")])


def test_a_table_that_does_not_close_and_wrong_addresses_are_refused() -> None:
    good = table("AX1", NODES, CORRECTIONS, kind=AxisKind.ROTARY)
    with pytest.raises(CapacityError, match="endless"):
        control_format(SIEMENS, {}).write(
            [good], [axis_of("AX1", kind=AxisKind.ROTARY, modulo=360.0)]
        )
    with pytest.raises(CapacityError, match="kind"):
        control_format(SIEMENS, {}).write([good], [axis_of("AX1")])
    with pytest.raises(UsageError, match="AX7"):
        control_format(SIEMENS, {}).write([table("AX7", NODES, CORRECTIONS)], [axis_of("AX1")])
    with pytest.raises(UsageError, match="two tables"):
        control_format(SIEMENS, {}).write([good, good], [axis_of("AX1", kind=AxisKind.ROTARY)])


def test_a_range_bounds_the_value_in_the_file() -> None:
    text = (
        CONTENT["siemens-840d-sl.yaml"]
        .decode()
        .replace("range: [-10, 10]", "range: [-0.004, 10]", 1)
    )  # errors from -0.004 mm
    definition = load_definition(text.encode(), "mine.yaml")
    assert control_format(definition, {}).capacity(axis_of("AX1")).value_range == (-10.0, 0.004)
    with pytest.raises(InputError, match="not plausible"):
        control_format(definition, {}).read(files(A__INI=SAMPLE))  # its last error is -0.0045 mm
    control_format(definition, {}).write(
        [table("AX1", [0.0, 50.0], [-0.0045, 0.0])], [axis_of("AX1")]
    )
    with pytest.raises(CapacityError, match="outside"):
        control_format(definition, {}).write(
            [table("AX1", [0.0, 50.0], [0.0045, 0.0])], [axis_of("AX1")]
        )


def test_a_first_value_of_zero_makes_the_lower_end_the_same() -> None:
    silent = table("AX1", [0.0, 50.0], [0.0, 0.002], below="zero")
    assert control_format(SIEMENS, {}).write([silent], [axis_of("AX1")])
