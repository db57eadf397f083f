"""SINUMERIK: tables into the control's own archive. Every byte that does not have to change
stays.
"""

from __future__ import annotations

import re
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.controls.control import decode, open_control
from compwright.formats.families.shapes import control_format
from compwright.formats.text.own_files import styled
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from format_samples import SIEMENS, axis_of, table

#: An archive as a control exports it: several programs, paths, comments, block numbers, checksums,
#: CR LF, other axes.
ARCHIVE = """%_N_AX2_EEC_INI\r
;$PATH=/_N_NC_ACT_DIR\r
CHANDATA(1)\r
$AA_ENC_COMP[0,0,AX2]=0.003\r
$AA_ENC_COMP[0,1,AX2]=0.001\r
$AA_ENC_COMP_STEP[0,AX2]=50.0\r
$AA_ENC_COMP_MIN[0,AX2]=0.0\r
$AA_ENC_COMP_MAX[0,AX2]=50.0\r
$AA_ENC_COMP_IS_MODULO[0,AX2]=0\r
M17\r
%_N_AX1_EEC_INI\r
;$PATH=/_N_NC_ACT_DIR\r
CHANDATA(1)\r
$MA_ENC_COMP_ENABLE[0,ax1]=0\r
  $AA_ENC_COMP[0,0,ax1] = +0.0030 ; Z\xe4hler\r
  $AA_ENC_COMP[0,1,ax1] = +0.0010 '1a2B\r
N30  $AA_ENC_COMP[0,2,ax1] = -0.0020 ; the last one\r
$AA_ENC_COMP_STEP[0,ax1]=50.0 '0001\r
$AA_ENC_COMP_MIN[0,ax1]=-100.0 '0002\r
$AA_ENC_COMP_MAX[0,ax1]=0.0 '0003\r
$AA_ENC_COMP_IS_MODULO[0,ax1]=0 '0004\r
M17\r
%_N_COMPLETE_TEA\r
N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]="X1" '77aa\r
N32450 $MA_BACKLASH[0,AX1]=0.0005 '1111\r
N32450 $MA_BACKLASH[0,AX2]=0.0007 '2222\r
N32700 $MA_ENC_COMP_ENABLE[0,AX1]=0\r
N38000 $MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=26 '3333\r
M30\r
"""
NODES = [-100.0, -50.0, 0.0]
OLD = [-0.003, -0.001, 0.002]  # corrections, mm: the opposite of the values


def archive(text: str = ARCHIVE, name: str = "NC.ARC") -> ControlFile:
    return ControlFile(name, text.encode("latin-1"))


def written(
    compensation: AxisCompensation,
    *files: ControlFile,
    axis: Axis | None = None,
    options: dict[str, object] | None = None,
) -> tuple[ControlFile, ...]:
    axis = axis or axis_of("AX1")
    state = control_format(SIEMENS, options or {}).read(files, [axis])
    return control_format(SIEMENS, options or {}, state).write([compensation], [axis], files)


def lines(file: ControlFile) -> list[str]:
    return file.content.decode("latin-1").split("\r\n")


def changed(old: ControlFile, new: ControlFile) -> dict[str, str]:
    """Old line -> new line, where both files have as many lines."""
    pairs = list(zip(lines(old), lines(new), strict=True))
    return {before: after for before, after in pairs if before != after}


def test_values_grid_and_backlash_are_set_in_place_and_nothing_else_changes() -> None:
    new = table("AX1", [-120.0, -60.0, 0.0], [-0.003, 0.00125, -0.0005], backlash=0.0125)
    (file,) = written(new, archive())
    assert file.name == "NC.ARC"
    assert changed(archive(), file) == {
        # the first value is the same: it keeps its bytes. Checksums go where a line changes, and
        # stay elsewhere
        "  $AA_ENC_COMP[0,1,ax1] = +0.0010 '1a2B": "  $AA_ENC_COMP[0,1,ax1] = -0.00125",
        "N30  $AA_ENC_COMP[0,2,ax1] = -0.0020 ; the last one": (
            "N30  $AA_ENC_COMP[0,2,ax1] = 0.0005 ; the last one"
        ),
        "$AA_ENC_COMP_STEP[0,ax1]=50.0 '0001": "$AA_ENC_COMP_STEP[0,ax1]=60.0",
        "$AA_ENC_COMP_MIN[0,ax1]=-100.0 '0002": "$AA_ENC_COMP_MIN[0,ax1]=-120.0",
        "N32450 $MA_BACKLASH[0,AX1]=0.0005 '1111": "N32450 $MA_BACKLASH[0,AX1]=0.0125",
        # switched off at the end of the load: the last value counts, and only that
        "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=0": "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=1",
    }


def test_rows_are_added_behind_the_last_one_as_it_is_written_without_number_comment_and_checksum() -> (
    None
):
    new = table("AX1", [-100.0, -50.0, 0.0, 50.0, 100.0], [*OLD, 0.004, -0.000015], backlash=0.0005)
    (file,) = written(new, archive())
    assert lines(file)[16:20] == [
        "N30  $AA_ENC_COMP[0,2,ax1] = -0.0020 ; the last one",
        "$AA_ENC_COMP[0,3,ax1] = -0.0040",
        "$AA_ENC_COMP[0,4,ax1] = 0.000015",
        "$AA_ENC_COMP_STEP[0,ax1]=50.0 '0001",
    ]
    kept = [
        line
        for line in lines(file)
        if line not in ("$AA_ENC_COMP[0,3,ax1] = -0.0040", "$AA_ENC_COMP[0,4,ax1] = 0.000015")
    ]
    old = lines(archive())
    assert [(a, b) for a, b in zip(old, kept, strict=True) if a != b] == [
        ("$AA_ENC_COMP_MAX[0,ax1]=0.0 '0003", "$AA_ENC_COMP_MAX[0,ax1]=100.0"),
        ("N32700 $MA_ENC_COMP_ENABLE[0,AX1]=0", "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=1"),
    ]


def test_rows_that_are_too_many_become_zero() -> None:
    (file,) = written(table("AX1", [-100.0, 0.0], [0.001, 0.002], backlash=0.0005), archive())
    assert lines(file)[14:18] == [
        "  $AA_ENC_COMP[0,0,ax1] = -0.0010 ; Z\xe4hler",
        "  $AA_ENC_COMP[0,1,ax1] = -0.0020",
        "N30  $AA_ENC_COMP[0,2,ax1] = 0.0000 ; the last one",
        "$AA_ENC_COMP_STEP[0,ax1]=100.0",
    ]
    again = control_format(SIEMENS, {}).read([file], [axis_of("AX1")])
    assert again.axes["AX1"].positions.tolist() == [-100.0, 0.0]
    assert any(finding.code == "CW-S004" for finding in again.findings)


def test_the_same_table_again_changes_no_byte_but_the_switch() -> None:
    same = table("AX1", NODES, OLD, backlash=0.0005)
    on = archive(ARCHIVE.replace("ENABLE[0,AX1]=0", "ENABLE[0,AX1]=1"))
    assert written(same, on) == (on,)
    assert changed(archive(), written(same, archive())[0]) == {
        "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=0": "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=1"
    }


def test_what_has_no_place_goes_into_fresh_files() -> None:
    without = archive(
        "".join(line for line in ARCHIVE.splitlines(keepends=True) if "BACKLASH[0,AX1]" not in line)
    )
    new = table("AX1", NODES, [-0.004, -0.001, 0.002], backlash=0.0125)
    patched, fresh = written(new, without)
    assert patched.name == "NC.ARC"
    assert (fresh.name, fresh.content.decode()) == (
        "AX1_MD.INI",
        "CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.012500\nM17\n",
    )
    data = ControlFile("DATA.TEA", b"CHANDATA(1)\nN32450 $MA_BACKLASH[0,AX1]=0.5 '1234\nM17\n")
    (eec,) = (file for file in written(new, data) if file.name != "DATA.TEA")
    assert eec.name == "AX1_EEC.INI"
    assert b"$AA_ENC_COMP_MAX[0,AX1]=0.000000\n" in eec.content
    assert b"BACKLASH" not in eec.content


def test_a_file_that_says_nothing_of_the_axis_is_not_returned() -> None:
    other = ControlFile("AX2.INI", b"CHANDATA(1)\n$MA_BACKLASH[0,AX3]=0.5\nM17\n")
    new = table("AX1", NODES, [-0.004, -0.001, 0.002], backlash=0.0125)
    assert [file.name for file in written(new, archive(), other)] == ["NC.ARC"]


def test_a_grid_and_a_missing_switch_without_rows_are_filled() -> None:
    """Memory that was reserved and never written: everything zero, one row; and no IS_MODULO
    line.
    """
    blank = "CHANDATA(1)\n$AA_ENC_COMP[0,0,X1]=0\n" + "".join(
        f"$AA_ENC_COMP_{k}[0,X1]=0\n" for k in ("STEP", "MIN", "MAX")
    )
    file = ControlFile("B.INI", (blank + "$MA_BACKLASH[0,X1]=0\nM17\n").encode())
    (new,) = written(table("X1", [0.0, 400.0], [0.0, 0.0015]), file, axis=axis_of("X1"))
    assert (
        new.content.decode()
        == "CHANDATA(1)\n$AA_ENC_COMP[0,0,X1]=0\n$AA_ENC_COMP[0,1,X1]=-0.0015\n$AA_ENC_COMP_IS_MODULO[0,X1]=0\n"
        "$AA_ENC_COMP_STEP[0,X1]=400\n$AA_ENC_COMP_MIN[0,X1]=0\n$AA_ENC_COMP_MAX[0,X1]=400\n$MA_BACKLASH[0,X1]=0\nM17\n"
    )


def test_a_grid_without_any_row_gets_its_rows_behind_it() -> None:
    text = "CHANDATA(1)\n" + "".join(
        f"$AA_ENC_COMP_{k}[0,x1]=0.0\n" for k in ("STEP", "MIN", "MAX")
    )
    file = ControlFile("B.INI", (text + "$MA_BACKLASH[0,X1]=0\nM17").encode())
    (new,) = written(table("X1", [0.0, 400.0], [0.0, 0.0015]), file, axis=axis_of("X1"))
    assert new.content.decode().splitlines()[3:7] == [
        "$AA_ENC_COMP_MAX[0,x1]=400.0",
        "$AA_ENC_COMP[0,0,x1]=0.000000",
        "$AA_ENC_COMP[0,1,x1]=-0.001500",
        "$AA_ENC_COMP_IS_MODULO[0,x1]=0",
    ]
    assert new.content.endswith(b"M17")


def test_the_measuring_system_of_the_axis_is_patched_and_no_other() -> None:
    two = ARCHIVE.replace(
        "%_N_COMPLETE_TEA",
        ARCHIVE.split("M17\r\n")[1].replace("[0,", "[1,") + "M17\r\n%_N_COMPLETE_TEA",
    )
    two = two.replace("M30", "N32450 $MA_BACKLASH[1,AX1]=0.002\r\nM30")
    axis = axis_of("AX1", system=2)
    (file,) = written(
        table("AX1", NODES, [0.005, -0.001, 0.002], backlash=0.002), archive(two), axis=axis
    )
    on = b"$AA_ENC_COMP_IS_MODULO[1,ax1]=0 '0004\r\n", b"$MA_ENC_COMP_ENABLE[1,ax1]=1\r\n"
    assert (
        file.content.count(on[0] + on[1]) == 1
    )  # off before the values (they are protected else), on behind them
    assert changed(archive(two), ControlFile(file.name, file.content.replace(on[1], b""))) == {
        "  $AA_ENC_COMP[1,0,ax1] = +0.0030 ; Z\xe4hler": (
            "  $AA_ENC_COMP[1,0,ax1] = -0.0050 ; Z\xe4hler"
        ),
    }


def test_a_load_sequence_that_ends_switched_on_keeps_both_values() -> None:
    sequence = ARCHIVE.replace(
        "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=0", "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=1 '5555"
    )
    (file,) = written(
        table("AX1", NODES, [0.005, -0.001, 0.002], backlash=0.0005), archive(sequence)
    )
    assert lines(file)[13] == "$MA_ENC_COMP_ENABLE[0,ax1]=0"
    assert "N32700 $MA_ENC_COMP_ENABLE[0,AX1]=1 '5555" in lines(file)


def test_of_a_value_that_is_given_twice_the_last_one_changes() -> None:
    twice = ARCHIVE.replace(
        "N32450 $MA_BACKLASH[0,AX1]", "$MA_BACKLASH[0,AX1]=0.9\r\nN32450 $MA_BACKLASH[0,AX1]"
    )
    (file,) = written(table("AX1", NODES, OLD, backlash=0.002), archive(twice))
    assert "$MA_BACKLASH[0,AX1]=0.9" in lines(file)
    assert "N32450 $MA_BACKLASH[0,AX1]=0.0020" in lines(file)


def test_the_points_that_are_promised_are_written_where_the_files_reserve_fewer() -> None:
    small = ARCHIVE.replace("=26 '3333", "=3 '3333")
    new = table("AX1", [-100.0, -50.0, 0.0, 50.0], [*OLD, 0.0], backlash=0.0005)
    with pytest.raises(CapacityError, match="at most 3"):
        written(new, archive(small))
    (file,) = written(new, archive(small), options={"points": 40})
    assert "N38000 $MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=40" in lines(file)
    (enough,) = written(new, archive(), options={"points": 40})
    assert "N38000 $MA_MM_ENC_COMP_MAX_POINTS[0,AX1]=26 '3333" in lines(enough)


def test_a_factor_on_the_backlash_is_read_and_set_to_one() -> None:
    text = ARCHIVE.replace(
        "N32700",
        "N32452 $MA_BACKLASH_FACTOR[0,AX1]=0.5\r\nN32452 $MA_BACKLASH_FACTOR[1,AX1]=0.25\r\nN32700",
    )
    state = control_format(SIEMENS, {}).read([archive(text)], [axis_of("AX1")])
    assert state.axes["AX1"].backlash == pytest.approx(0.00025)
    (file,) = written(table("AX1", NODES, OLD, backlash=0.0125), archive(text))
    assert "N32452 $MA_BACKLASH_FACTOR[0,AX1]=1.0" in lines(file)
    assert "N32452 $MA_BACKLASH_FACTOR[1,AX1]=0.25" in lines(file)
    assert control_format(SIEMENS, {}).read([file], [axis_of("AX1")]).axes["AX1"].backlash == 0.0125


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ("0.003", "0.002500", "0.0025"),
        ("0.003000", "0.002500", "0.002500"),
        ("+0.0030", "0.002500", "+0.0025"),
        ("+0.0030", "-0.002500", "-0.0025"),
        ("-0.003", "0.000000", "0.000"),
        ("50", "60.000000", "60"),
        ("50.0", "60.000000", "60.0"),
        ("50.", "60.250000", "60.25"),
        (".5", "0.750000", "0.75"),
        ("0", "100.000000", "100"),
        ("AX1", "AX2", "AX2"),
    ],
)
def test_the_style_of_a_number(old: str, new: str, text: str) -> None:
    assert styled(old, new) == text


def test_a_state_that_both_readers_know_comes_back_as_written() -> None:
    control = open_control(Session(), "siemens-840d-sl", {})
    axis = replace(axis_of("AX1"), travel=(-150.0, 50.0))
    new = table(
        "AX1",
        [-150.0, -100.0, -50.0, 0.0, 50.0],
        [0.001, -0.002, 0.003, 0.0, 0.0005],
        backlash=0.002,
    )
    files = written(new, archive(), axis=axis)
    loaded = decode(control, files, [axis])  # raises where the two readers do not agree
    for direction in Direction:
        got = loaded.state.axes["AX1"].at(new.positions, direction)
        np.testing.assert_allclose(
            got, new.at(new.positions, direction), rtol=0, atol=1e-12
        )  # mm; rounding of doubles


# Properties
# --------------------------------------------------------------------------------------------------

_TOUCHED = re.compile(r"\$(AA_ENC_COMP|MA_BACKLASH\[0|MA_ENC_COMP_ENABLE).*ax1", re.IGNORECASE)


@st.composite
def archives(draw: st.DrawFn) -> str:
    """The archive with other line ends, blanks, programs around it, more rows, and noise between
    its lines.
    """
    rows = draw(st.integers(0, 4))
    more = "".join(f"$AA_ENC_COMP[0,{3 + i},ax1] = 0.0\r\n" for i in range(rows))
    text = ARCHIVE.replace("$AA_ENC_COMP_STEP[0,ax1]", f"{more}$AA_ENC_COMP_STEP[0,ax1]")
    noise = st.sampled_from(
        [
            "",
            "; comment\r\n",
            "N5 $MA_KP[0,AX1]=1.5 'abcd\r\n",
            "\r\n",
            "$AC_TIMER[1]=2\r\n",
            "\t;\xb5\r\n",
        ]
    )
    parts = [line + draw(noise) for line in text.splitlines(keepends=True)]
    return "".join(parts).replace("\r\n", draw(st.sampled_from(["\r\n", "\n"])))


@st.composite
def tables(draw: st.DrawFn) -> AxisCompensation:
    count = draw(st.integers(2, 8))
    step = draw(st.integers(1, 10**6))
    start = draw(st.integers(-(10**6), 10**6))
    values = draw(st.lists(st.integers(-9999, 9999), min_size=count, max_size=count))
    positions = [(start + i * step) / 1000 for i in range(count)]
    return table(
        "AX1",
        positions,
        [value / 1e6 for value in values],
        backlash=draw(st.integers(-9999, 9999)) / 1e6,
    )


@given(text=archives(), compensation=tables())
@settings(deadline=None, max_examples=60)
def test_every_other_line_keeps_its_bytes_and_the_table_comes_back(
    text: str, compensation: AxisCompensation
) -> None:
    old = ControlFile("NC.ARC", text.encode("latin-1"))
    (new,) = written(compensation, old)
    keep_old = [
        line
        for line in old.content.decode("latin-1").splitlines(keepends=True)
        if not _TOUCHED.search(line)
    ]
    keep_new = [
        line
        for line in new.content.decode("latin-1").splitlines(keepends=True)
        if not _TOUCHED.search(line)
    ]
    assert keep_old == keep_new
    again = control_format(SIEMENS, {}).read([new], [axis_of("AX1")]).axes["AX1"]
    np.testing.assert_allclose(
        again.positions, compensation.positions, rtol=0, atol=1e-9
    )  # mm: the last place written is 1e-6
    np.testing.assert_allclose(again.positive, compensation.positive, rtol=0, atol=1e-12)
    assert again.backlash == pytest.approx(compensation.backlash, abs=1e-12)
    assert written(compensation, new) == (new,)  # a second time nothing changes


@given(data=st.data(), compensation=tables())
@settings(deadline=None, max_examples=60)
def test_a_damaged_archive_is_refused_or_patched_never_worse(
    data: st.DataObject, compensation: AxisCompensation
) -> None:
    content = ARCHIVE.encode("latin-1")
    for _ in range(data.draw(st.integers(1, 3))):
        place = data.draw(st.integers(0, len(content)))
        piece = data.draw(
            st.one_of(
                st.binary(max_size=4),
                st.sampled_from([b"\n", b"'", b"=", b"[", b"$AA_ENC_COMP", b"9" * 16]),
            )
        )
        content = content[:place] + piece + content[place + data.draw(st.integers(0, 10)) :]
    try:
        files = written(compensation, ControlFile("NC.ARC", content))
        again = control_format(SIEMENS, {}).read(files, [axis_of("AX1")]).axes["AX1"]
    except (InputError, UsageError, CapacityError):
        return
    np.testing.assert_allclose(again.positive, compensation.positive, rtol=0, atol=1e-12)


@given(
    old=st.from_regex(r"[+-]?[0-9]{1,6}(\.[0-9]{0,7})?", fullmatch=True),
    value=st.integers(-(10**9), 10**9),
)
def test_a_styled_number_is_the_same_number(old: str, value: int) -> None:
    new = f"{Decimal(value).scaleb(-6):f}"
    assert Decimal(styled(old, new)) == Decimal(new)
