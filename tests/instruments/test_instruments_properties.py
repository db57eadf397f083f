"""Whatever stands in a file: a record or an InputError, and the forms agree with one another."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import InputError
from compwright.records.positioning import PositioningTest
from one_test import read_positioning

LONG = (
    b"# axis: X\n# unit:"
    b" um\ntarget_mm;direction;run;deviation_um\n0,5;+;1;-2,5\n0,5;-;1;3\n100;+;1;1,5\n100;-;1;2\n"
)
WIDE = b"# unit: um\ntarget_mm,+1,-1\n0.5,1,2\n100,,-3.25\n200,4,5\n"
DATA = b"UNIT=mm\nCYCLES=1\nTGT_DATA[1]=0.5\nTGT_DATA[2]=7\nREF_DATA_FWD[1,1]=.501\nREF_DATA_FWD[2,1]=7.002\n"
#: Pieces that have a meaning somewhere in the forms, so that random files come near to valid ones.
WORDS = (
    *(
        "target_mm",
        "target_deg",
        "direction",
        "run",
        "deviation_um",
        "measured_deg",
        "+1",
        "-2",
        "# unit: um",
        "UNIT",
        "TGT_DATA[1]",
    ),
    *(
        "REF_DATA_BWD[1,1]",
        "0",
        "1",
        "1.5",
        "1,5",
        "1e9",
        "nan",
        "°",
        "+",
        "-",
        ",",
        ";",
        "#",
        "=",
        '"',
        "\t",
        "\n",
        "\r",
        " ",
        "\ufeff",
    ),
)
PIECES = st.sampled_from(WORDS)

#: No time limit per example: a busy computer must not make these fail.
UNHURRIED = settings(deadline=None)


def check(content: bytes) -> None:
    try:
        test = read_positioning(content, "f.csv")
    except InputError as error:
        told = error.faults
    else:
        check_record(test)
        return
    assert told
    assert all(fault.file == "f.csv" and fault.message for fault in told)


def check_record(test: PositioningTest) -> None:
    assert test.targets.size
    assert np.all(np.diff(test.targets) > 0)
    for block, runs in ((test.positive, test.runs_positive), (test.negative, test.runs_negative)):
        assert block.shape == (test.targets.size, len(runs))
        assert not np.isinf(block).any()
    assert np.isfinite(test.positive).any() or np.isfinite(test.negative).any()


@UNHURRIED
@given(st.binary(max_size=300))
def test_random_bytes(content: bytes) -> None:
    check(content)


@UNHURRIED
@given(
    st.lists(PIECES, max_size=60).map("".join), st.sampled_from(["utf-8", "utf-8-sig", "utf-16"])
)
def test_random_pieces(text: str, encoding: str) -> None:
    check(text.encode(encoding))


@UNHURRIED
@given(st.sampled_from([LONG, WIDE, DATA]), st.data())
def test_mutated_files(content: bytes, data: st.DataObject) -> None:
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(content)))
        end = data.draw(st.integers(start, min(len(content), start + 12)))
        content = (
            content[:start]
            + data.draw(st.one_of(st.binary(max_size=4), PIECES.map(str.encode)))
            + content[end:]
        )
    check(content)


DEVIATIONS = st.integers(-99_999, 99_999).map(
    lambda value: value / 100
)  # um, two decimals as instruments print


@st.composite
def tables(draw: st.DrawFn) -> tuple[list[float], list[str], list[list[float | None]]]:
    """Targets, traverses and deviations with gaps, each target approached in each of the
    directions.
    """
    targets = draw(
        st.lists(
            st.integers(-50_000, 50_000).map(lambda value: value / 10),
            min_size=1,
            max_size=6,
            unique=True,
        )
    )
    traverses = [
        f"{sign}{run}"
        for sign in draw(st.sampled_from(["+", "-", "+-"]))
        for run in range(1, draw(st.integers(1, 4)) + 1)
    ]
    rows: list[list[float | None]] = []
    for _ in targets:
        row: list[float | None] = [draw(st.one_of(st.none(), DEVIATIONS)) for _ in traverses]
        for sign in "+-":  # the first reading of each direction is always made
            if f"{sign}1" in traverses:
                row[traverses.index(f"{sign}1")] = draw(DEVIATIONS)
        rows.append(row)
    return targets, traverses, rows


def same(one: PositioningTest, other: PositioningTest) -> None:
    np.testing.assert_array_equal(one.targets, other.targets)
    np.testing.assert_array_equal(one.positive, other.positive)
    np.testing.assert_array_equal(one.negative, other.negative)
    assert one.runs_positive == other.runs_positive
    assert one.runs_negative == other.runs_negative


@UNHURRIED
@given(tables(), st.sampled_from([(",", "."), (";", ","), ("\t", ","), (";", ".")]))
def test_wide_and_long_say_the_same(
    table: tuple[list[float], list[str], list[list[float | None]]], marks: tuple[str, str]
) -> None:
    targets, traverses, rows = table
    delimiter, mark = marks

    def cell(value: float | None) -> str:
        return "" if value is None else f"{value:.2f}".replace(".", mark)

    wide = ["# unit: um", delimiter.join(["target_mm", *traverses])]
    wide += [
        delimiter.join([cell(target), *map(cell, row)])
        for target, row in zip(targets, rows, strict=True)
    ]
    long = [delimiter.join(["target_mm", "direction", "run", "deviation_um"])]
    long += [
        delimiter.join([cell(target), traverse[0], traverse[1:], cell(value)])
        for target, row in zip(targets, rows, strict=True)
        for traverse, value in zip(traverses, row, strict=True)
        if value is not None
    ]
    from_wide = read_positioning("\n".join(wide).encode(), "x.csv")
    from_long = read_positioning("\r\n".join(long).encode(), "x.csv")
    columns = [
        traverse
        for index, traverse in enumerate(traverses)
        if any(row[index] is not None for row in rows)
    ]
    assert len(from_long.runs_positive) + len(from_long.runs_negative) == len(columns)
    same(from_wide, from_long)
    # Against the table itself, not only against each other: um to mm.
    order = np.argsort(targets)
    first = np.array([row[0] for row in rows], dtype=float)[order] / 1000
    block = from_wide.positive if traverses[0][0] == "+" else from_wide.negative
    np.testing.assert_allclose(block[:, 0], first, rtol=1e-12)
    np.testing.assert_array_equal(from_wide.targets, np.sort(targets))
