"""LinuxCNC: rows and keys as the control's source reads them, against numbers seen on a running
control.
"""

from __future__ import annotations

import numpy as np
import pytest

from compwright.formats.definition.options import resolve_options
from compwright.formats.families.shapes import control_format
from compwright.formats.text.addresses import normal_address
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import ControlFile, ControlState
from format_samples import LINUXCNC, axis_of, codes, correction, files, table

POSITIVE, NEGATIVE = Direction.POSITIVE, Direction.NEGATIVE

ACTUAL = "-200 -200.0080 -199.9960\n0 0.0000 0.0120\n200 200.0100 200.0230\n"
TRIM = "-200  0.0080 -0.0040\n   0  0.0000 -0.0120\n 200 -0.0100 -0.0230\n"
MACHINE = """[EMC]
VERSION = 1.1
[TRAJ]
LINEAR_UNITS = mm
# a comment
[JOINT_0]
TYPE = LINEAR
MAX_VELOCITY = 5000
COMP_FILE = tables/x.comp
COMP_FILE_TYPE = 0
[JOINT_1]
BACKLASH = 0.020
[AXIS_X]
BACKLASH = broken
"""


def read(**texts: str) -> ControlState:
    return control_format(LINUXCNC, {}).read(files(**texts))


def test_both_forms_of_the_same_table_mean_the_same() -> None:
    actual = read(x__comp=ACTUAL, m__ini=MACHINE).axes["0"]
    trim = read(x__comp=TRIM, m__ini=MACHINE.replace("TYPE = 0", "TYPE = 1")).axes["0"]
    for axis in (actual, trim):
        np.testing.assert_array_equal(axis.positions, [-200.0, 0.0, 200.0])
        np.testing.assert_array_equal(
            axis.positive, [0.008, 0.0, -0.010]
        )  # mm, added to the command
        np.testing.assert_array_equal(axis.negative, [-0.004, -0.012, -0.023])
        assert axis.backlash == 0.0


def test_corrections_seen_on_a_running_control() -> None:
    # HAL pin backlash-corr of LinuxCNC 2.9.0~pre1 with this table of actual positions, mm
    state = read(
        x__comp="-100 -100.010 -99.980\n0 0.004 0.010\n100 100.020 100.030\n",
        m__ini="[JOINT_0]\nCOMP_FILE=x.comp\n",
    )
    seen = [(10, POSITIVE, -0.0056), (50, POSITIVE, -0.012), (100, POSITIVE, -0.020), (150,
    POSITIVE, -0.020),
            (50, NEGATIVE, -0.020), (0, NEGATIVE, -0.010), (-50, NEGATIVE, -0.015)]  # fmt: skip
    for position, direction, value in seen:
        assert correction(state, "0", position, direction) == pytest.approx(value, abs=1e-9)


def test_backlash_without_a_table_acts_half_each_way_and_beside_one_not_at_all() -> None:
    state = read(
        x__comp=ACTUAL, m__ini=MACHINE.replace("COMP_FILE_TYPE", "BACKLASH = 0.5\nCOMP_FILE_TYPE")
    )
    assert correction(state, "1", 33.0, POSITIVE) == pytest.approx(
        0.010
    )  # seen on a running control: +-0.010 mm
    assert correction(state, "1", -33.0, NEGATIVE) == pytest.approx(-0.010)
    assert correction(state, "0", 0.0, POSITIVE) == 0.0
    assert "CW-S009" in codes(state)


def test_inch_machines() -> None:
    text = MACHINE.replace("LINEAR_UNITS = mm", "LINEAR_UNITS = inch")
    state = read(x__comp="0 0 0.001\n10 10.002 10.003\n", m__ini=text)
    np.testing.assert_allclose(state.axes["0"].positions, [0.0, 254.0], rtol=0, atol=1e-12)
    np.testing.assert_allclose(state.axes["0"].positive, [0.0, -0.0508], rtol=0, atol=1e-12)
    np.testing.assert_allclose(state.axes["0"].negative, [-0.0254, -0.0762], rtol=0, atol=1e-12)
    assert correction(state, "1", 0.0, POSITIVE) == pytest.approx(0.254)
    resolved = resolve_options(LINUXCNC, {}, state)
    assert resolved["units"] == "inch"
    capacity = control_format(LINUXCNC, resolve_options(LINUXCNC, {}), state).capacity(axis_of("0"))
    assert capacity.quantum == pytest.approx(2.54e-6, rel=1e-12)  # mm
    held = table("0", [0.0, 254.0], [0.0, -0.0508], [-0.0254, -0.0762])
    comp = control_format(LINUXCNC, {}, state).write([held], [axis_of("0")])[0]
    assert (
        comp.content.decode() == "0.0000000 0.0000000 0.0010000\n10.0000000 10.0020000 10.0030000\n"
    )
    assert control_format(LINUXCNC, resolved).write([held], [axis_of("0")])[0] == comp


def test_a_section_counts_by_its_exact_name() -> None:
    state = read(
        m__ini=(
            "[ TRAJ]\nLINEAR_UNITS = inch\n[JOINT_1]\nBACKLASH = 0.020\n[joint_2]\nBACKLASH = 1\n"
        )
    )
    assert list(state.axes) == ["1"]
    assert correction(state, "1", 0.0, POSITIVE) == pytest.approx(
        0.010
    )  # not inches: the control does not know [ TRAJ]


def test_a_rotary_joint_is_in_degrees_on_any_machine() -> None:
    text = MACHINE.replace("mm", "inch").replace("TYPE = LINEAR", "TYPE = ANGULAR")
    axis = read(x__comp=ACTUAL, m__ini=text).axes["0"]
    assert axis.kind is AxisKind.ROTARY
    assert axis.positive[0] == 0.008


@pytest.mark.parametrize(
    ("what", "text"),
    [
        ("tabs and blanks", ACTUAL.replace(" ", " \t")),
        ("leading blanks", "  " + ACTUAL.replace("\n", "\n\t ").rstrip("\t ")),
        ("line ends of Windows", ACTUAL.replace("\n", "\r\n")),
        ("a fourth column", ACTUAL.replace("\n", " 7\n")),
        ("text behind the row", ACTUAL.replace("\n", " # checked\n")),
        ("blank lines at the end", ACTUAL + "\n  \n"),
        ("no line end", ACTUAL.rstrip("\n")),
        (
            "exponents and plus signs",
            ACTUAL.replace("0.0120", "+1.2e-2").replace("200 200.0100", "+2e2 2.000100E2"),
        ),
    ],
)
def test_what_the_control_accepts_is_read(what: str, text: str) -> None:
    axis = read(joint_0__comp=text).axes["0"]
    np.testing.assert_allclose(axis.positive, [0.008, 0.0, -0.010], rtol=0, atol=1e-12)
    np.testing.assert_allclose(axis.negative, [-0.004, -0.012, -0.023], rtol=0, atol=1e-12)


ROW = "0 0.0000 0.0120\n"


@pytest.mark.parametrize(
    ("what", "text", "place"),
    [
        ("comment first", "# x\n" + ACTUAL, "line 1"),
        ("header", "nominal forward reverse\n" + ACTUAL, "line 1"),
        ("blank line first", "\n" + ACTUAL, "line 1"),
        ("byte order mark", "\xef\xbb\xbf" + ACTUAL, "line 1"),
        ("commas", ACTUAL.replace(" ", ","), "line 1"),
        ("semicolons", ACTUAL.replace(" ", ";"), "line 1"),
        ("decimal comma", ACTUAL.replace("0.0120", "0,0120"), "line 2"),
        ("two columns", ACTUAL.replace(" 0.0120", ""), "line 2"),
        ("unit", ACTUAL.replace("0.0120", "0.0120mm"), "line 2"),
        ("comment in the middle", ACTUAL.replace(ROW, "; half\n" + ROW), "line 2"),
        ("blank line in the middle", ACTUAL.replace(ROW, "\n" + ROW), "line 2"),
        ("bare carriage returns", ACTUAL.replace("\n", "\r"), "line 1"),
        ("nan", ACTUAL.replace("0.0120", "nan"), "line 2"),
        ("inf", ACTUAL.replace("0.0120", "inf"), "line 2"),
        ("hexadecimal", ACTUAL.replace("0.0120", "0x1p-6"), "line 2"),
        ("minus of typesetters", ACTUAL.replace("-", "\xe2\x88\x92"), "line 1"),
        ("a long line", ACTUAL.replace(ROW, "0 0.0000" + " " * 250 + "0.0120\n"), "line 2"),
        ("descending", "".join(reversed(ACTUAL.splitlines(keepends=True))), "line 2"),
        ("twice the same position", ACTUAL + "200 200 200\n", "line 4"),
        ("implausible: corrections read as positions", TRIM, "line 1"),
        ("too large", ACTUAL.replace("200 200.0100 200.0230", "1e9 1e9 1e9"), "line 3"),
    ],
)  # fmt: skip
def test_what_would_be_cut_silently_is_refused(what: str, text: str, place: str) -> None:
    with pytest.raises(InputError) as caught:
        read(joint_0__comp=text)
    assert caught.value.faults[0].file == "joint_0.comp"
    assert caught.value.faults[0].place == place


def test_more_rows_than_the_control_takes() -> None:
    rows = [f"{i} {i} {i}\n" for i in range(257)]
    assert read(joint_3__comp="".join(rows[:256])).axes["3"].positions.size == 256
    with pytest.raises(InputError, match="at most 256"):
        read(joint_3__comp="".join(rows))


def test_a_table_is_found_by_the_key_or_by_its_name() -> None:
    assert read(joint_2__comp=ACTUAL).axes["2"].positions.size == 3
    with pytest.raises(InputError, match=r"x\.comp"):
        read(m__ini=MACHINE)
    with pytest.raises(InputError, match="which axis"):
        read(x__comp=ACTUAL)
    named = control_format(LINUXCNC, {}).read(files(x__comp=ACTUAL), address="4")
    assert named.axes["4"].positions.size == 3
    job = control_format(LINUXCNC, {}).read(files(x__comp=ACTUAL), [axis_of("4")])
    assert job.axes["4"].positions.size == 3
    stray = read(x__comp=ACTUAL, other__comp=TRIM, m__ini=MACHINE)
    assert "CW-S012" in codes(stray)
    with pytest.raises(InputError, match="the table file contains no rows"):
        read(joint_0__comp="", joint_1__comp=ACTUAL)


def test_missing_is_not_zero() -> None:
    with pytest.raises(InputError, match="states the compensation of axis 5"):
        control_format(LINUXCNC, {}).read(files(x__comp=ACTUAL, m__ini=MACHINE), [axis_of("5")])
    bare = control_format(LINUXCNC, {}).read(
        files(m__ini="[JOINT_5]\nMAX_VELOCITY = 1\n"), [axis_of("5")]
    )
    assert (
        bare.axes["5"].positions.size == 0
    )  # the section is there and has no table: the control does nothing
    assert any("COMP_FILE_TYPE" in note.fact for note in read(joint_2__comp=ACTUAL).assumed)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("COMP_FILE_TYPE = 0", "COMP_FILE_TYPE = two"),
        ("COMP_FILE_TYPE = 0", "COMP_FILE_TYPE = 2"),
        ("BACKLASH = 0.020", "BACKLASH = 0,020"),
        ("BACKLASH = 0.020", "BACKLASH = 200"),
        ("LINEAR_UNITS = mm", "LINEAR_UNITS = furlong"),
        ("[JOINT_1]", "[JOINT_1"),
        ("[JOINT_1]", "[JOINT_0]"),
        ("TYPE = LINEAR", "TYPE = WRAPPED"),
        ("COMP_FILE = tables/x.comp", "COMP_FILE = y.comp"),
    ],
)
def test_keys_that_cannot_be_read_are_refused(old: str, new: str) -> None:
    with pytest.raises(InputError, match=r"m\.ini"):
        read(x__comp=ACTUAL, m__ini=MACHINE.replace(old, new, 1))


def test_the_first_of_repeated_keys_counts() -> None:
    state = read(m__ini="[JOINT_0]\nBACKLASH = 0.02\nBACKLASH = 0.04\n")
    assert correction(state, "0", 0.0, POSITIVE) == pytest.approx(0.01)
    assert "CW-S003" in codes(state)


# Writing
# --------------------------------------------------------------------------------------------------


def test_the_written_files_by_hand() -> None:
    compensation = table("1", [-10.0, 0.0, 12.5], [0.001, 0.0, -0.0005], [0.004, 0.003, 0.0025])
    comp, ini = control_format(LINUXCNC, {}).write([compensation], [axis_of("1")])
    assert comp == ControlFile(
        "joint_1.comp",
        b"-10.0000000 -10.0010000 -10.0040000\n0.0000000 0.0000000 -0.0030000\n12.5000000"
        b" 12.5005000 12.4975000\n",
    )
    assert ini == ControlFile(
        "joint_1.ini", b"[JOINT_1]\nCOMP_FILE = joint_1.comp\nCOMP_FILE_TYPE = 0\nBACKLASH = 0\n"
    )
    comp, ini = control_format(LINUXCNC, {"comp_file_type": "1"}).write(
        [compensation], [axis_of("1")]
    )
    assert comp.content.startswith(b"-10.0000000 0.0010000 0.0040000\n")
    assert b"COMP_FILE_TYPE = 1\n" in ini.content


def test_axis_letters_are_taken_as_joints_and_that_is_said() -> None:
    address, assumption = normal_address(LINUXCNC, axis_of("Z"))
    assert address == "2"
    assert assumption is not None
    assert assumption.value == "2"
    assert normal_address(LINUXCNC, axis_of("07")) == ("7", None)
    state = control_format(LINUXCNC, {}).read(files(joint_2__comp=ACTUAL), [axis_of("Z")])
    assert list(state.axes) == ["2"]
    assert "CW-S010" in codes(state)
    assert assumption in state.assumed
    files_of_z = control_format(LINUXCNC, {}).write(
        [table("Z", [0.0, 1.0], [0.0, 0.0])], [axis_of("Z")]
    )
    assert files_of_z[0].name == "joint_2.comp"
    with pytest.raises(UsageError, match="address"):
        normal_address(LINUXCNC, axis_of("spindle"))


def test_the_capacity_is_that_of_the_control() -> None:
    capacity = control_format(LINUXCNC, {}).capacity(axis_of("0"))
    assert (capacity.curves, capacity.spacing, capacity.max_points) == (2, "free", 256)
    assert (capacity.below, capacity.above) == ("hold", "hold")
    assert capacity.quantum == capacity.position_quantum == 1e-7  # mm
    assert capacity.backlash_quantum is None


@pytest.mark.parametrize(
    ("what", "changes", "says"),
    [
        ("one row", {"positions": [0.0], "positive": [0.0]}, "too few"),
        ("too many rows", {"positions": range(257), "positive": [0.0] * 257}, "at most 256"),
        ("backlash in addition to the table", {"backlash": 0.001}, "backlash"),
        ("another end than the control's", {"below": "zero"}, "below the first point"),
        ("a value between the steps", {"positive": [0.00000005, 0.0]}, "multiple"),
        ("a node between the steps", {"positions": [0.0, 1.00000005]}, "multiple"),
        ("a value out of range", {"positive": [0.0, 10.1]}, "outside"),
        ("a position out of range", {"positions": [0.0, 100001.0]}, "outside"),
    ],
)
def test_what_the_control_cannot_hold_is_refused(
    what: str, changes: dict[str, object], says: str
) -> None:
    values: dict[str, object] = {"positions": [0.0, 1.0], "positive": [0.001, 0.002], **changes}
    with pytest.raises(CapacityError, match=says):
        # # a table of changes
        control_format(LINUXCNC, {}).write([table("0", **values)], [axis_of("0")])  # type: ignore[arg-type]
