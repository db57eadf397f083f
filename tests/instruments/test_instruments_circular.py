"""Circular tests read from plain CSV: order, arcs, units, keys and every refusal; the merging of
files of one test.
"""

from __future__ import annotations

import codecs
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import InputError, UsageError
from compwright.instruments.circular_reading import merge_circular, read_circular
from compwright.instruments.other_files import is_circular
from compwright.records.circular import CircularTest
from one_test import read_positioning

HEAD = "# plane: XY\n# nominal_radius_mm: 150\n# feed_mm_min: 1000\n"


def rows(angles: list[float], sense: str = "ccw", run: int = 1) -> str:
    """Rows whose deviation is a tenth of the angle modulo 360, in um, so that every sample tells
    where it belongs.
    """
    return "".join(f"{sense},{run},{angle:g},{(angle % 360) / 10:.4f}\n" for angle in angles)


def csv(
    body: str, columns: str = "direction,run,angle_deg,deviation_um", head: str = HEAD
) -> bytes:
    return f"{head}{columns}\n{body}".encode()


def read(content: bytes) -> CircularTest:
    return read_circular(content, "dir/xy.csv")


def fault(content: bytes) -> str:
    with pytest.raises(InputError) as caught:
        read(content)
    lines = str(caught.value).splitlines()
    assert all(line.startswith("dir/xy.csv: ") for line in lines)
    return "\n".join(lines)


def codes(test: CircularTest) -> list[str]:
    return [finding.code for finding in test.findings]


def belongs(test: CircularTest) -> None:
    """Every deviation stands at its angle, and the runs go the way of their sense."""
    for run in test.runs:
        assert run.deviations * 1e4 == pytest.approx(run.angles % 360.0)
        ways = {later > earlier for earlier, later in pairwise(run.angles)}
        assert ways == {run.sense == "ccw"}


FULL = [10.0 * k for k in range(36)]


def test_both_directions_in_any_order_of_rows() -> None:
    body = rows(FULL, "ccw").splitlines(keepends=True) + rows(FULL[::-1], "cw").splitlines(
        keepends=True
    )
    shuffled = "".join(body[k] for k in np.random.default_rng(1).permutation(len(body)))
    test = read(csv(shuffled))
    assert (test.name, test.plane, test.axes, test.nominal_radius, test.feed) == (
        "xy",
        "XY",
        ("X", "Y"),
        150.0,
        1000.0,
    )
    assert [(run.sense, run.number, run.angles.size) for run in test.runs] == [
        ("ccw", 1, 36),
        ("cw", 1, 36),
    ]
    belongs(test)
    assert test.arc == (0.0, 360.0)
    assert test.full_circle
    assert not test.calibrated
    assert codes(test) == ["CW-R001"]
    assert len(test.sources[0].sha256) == 64


def test_radius_in_mm() -> None:
    body = "".join(f"cw,{angle:g},{150 + angle / 1e5:.6f}\n" for angle in FULL)
    test = read(
        csv(
            body,
            "direction,angle_deg,radius_mm",
            HEAD + "# calibrated: yes\n# centre: -400, -250.5, -300\n",
        )
    )
    assert test.of("cw")[0].deviations[::-1] == pytest.approx(
        [angle / 1e5 for angle in FULL], abs=1e-12
    )
    assert test.calibrated
    assert test.centre == (-400.0, -250.5, -300.0)
    assert test.findings == ()


def test_several_runs_of_unequal_samples_keep_their_numbers() -> None:
    body = rows(FULL, "cw", 3) + rows([5.0 * k for k in range(72)], "ccw", 2) + rows(FULL, "ccw", 7)
    test = read(csv(body))
    assert [(run.sense, run.number, run.angles.size) for run in test.runs] == [
        ("ccw", 2, 72),
        ("ccw", 7, 36),
        ("cw", 3, 36),
    ]
    belongs(test)


@pytest.mark.parametrize(
    "text",
    [
        codecs.BOM_UTF8 + csv(rows(FULL)),
        csv(rows(FULL)).replace(b"\n", b"\r\n"),
        csv(rows(FULL)).decode().encode("utf-16"),
        csv(
            rows(FULL).replace(",", ";").replace(".", ","),
            "direction;run;angle_deg;deviation_um",
            HEAD.replace("150", "150,0"),
        ),
        csv(rows(FULL).replace(",", "\t"), "direction\trun\tangle_deg\tdeviation_µm"),
        csv(
            rows(FULL).replace("ccw", "CCW"),
            "Direction, Run, Angle_deg, Deviation_um",
            HEAD.replace("plane: XY", "Plane: x-y"),
        ),
    ],
)
def test_the_spellings_of_one_file(text: bytes) -> None:
    plain, other = read(csv(rows(FULL))), read(text)
    assert np.array_equal(plain.runs[0].deviations, other.runs[0].deviations)
    assert (plain.plane, plain.nominal_radius, plain.arc) == (
        other.plane,
        other.nominal_radius,
        other.arc,
    )
    assert is_circular(text, "x.csv")


@pytest.mark.parametrize(
    ("angles", "arc"),
    [
        ([2.0 * k for k in range(46)], (0.0, 90.0)),
        ([0.5 + k for k in range(90)], (0.5, 89.0)),  # half steps: with one sample it is 90 deg
        ([250.0 + 2 * k for k in range(111)], (250.0, 220.0)),
        ([(250.0 + 2 * k) % 360 for k in range(111)], (250.0, 220.0)),
        ([-110.0 + 2 * k for k in range(111)], (250.0, 220.0)),
        ([-180.0 + 2 * k for k in range(180)], (180.0, 360.0)),
        ([0.12 + 0.24 * k for k in range(1500)], (0.12, 360.0)),
        ([2.0 * k for k in range(181)], (0.0, 360.0)),  # the first point again at the end
        ([0.0, 90.0, 180.0, 270.0], (0.0, 360.0)),
        ([45.0 + 2 * k for k in range(180)], (45.0, 360.0)),
    ],
)
@pytest.mark.parametrize("sense", ["ccw", "cw"])
def test_the_arc_is_found_from_the_angles(
    angles: list[float], arc: tuple[float, float], sense: str
) -> None:
    test = read(csv(rows(angles, sense)))
    assert test.arc == pytest.approx(arc)
    run = test.runs[0]
    assert run.angles.size == len(angles)
    low, high = (
        (run.angles[0], run.angles[-1]) if sense == "ccw" else (run.angles[-1], run.angles[0])
    )
    assert low == pytest.approx(arc[0])
    assert high - low <= 360.0
    assert set(np.diff(run.angles) > 0) == {sense == "ccw"}


def test_a_hole_in_the_circle_is_told_and_stays_a_circle() -> None:
    angles = [0.24 * k for k in range(1500) if not 400 <= k < 415]  # 3.84 deg without samples
    test = read(csv(rows(angles)))
    assert test.full_circle
    assert "CW-R034" in codes(test)
    assert "from 95.76 deg on, over 3.84 deg" in next(
        f.message for f in test.findings if f.code == "CW-R034"
    )


@pytest.mark.parametrize("sense", ["ccw", "cw"])
@pytest.mark.parametrize("first", [0, 400, 1100])
def test_a_circle_with_a_wide_gap_is_the_same_in_whatever_order(sense: str, first: int) -> None:
    """The path passes 60.24° without samples, wherever its first sample is. An arc of the same
    angles has the same samples, and nothing is inferred from the order of rows.
    """
    circle = [0.24 * ((first + k) % 1500) for k in range(1500)]
    gap = [angle for angle in circle if not 100.0 < angle < 160.0]
    arc = [160.08 + 0.24 * k for k in range(1250)]
    turned = [angle % 360.0 for angle in arc]
    for angles in (
        gap,
        sorted(gap),
        np.random.default_rng(1).permutation(gap).tolist(),
        arc,
        turned,
    ):
        way = angles if sense == "ccw" else angles[::-1]
        test = read(csv(rows(way, sense)))
        assert test.arc == pytest.approx((160.08, 360.0 - 60.24))
        (found,) = [finding for finding in test.findings if finding.code == "CW-R034"]
        assert found.is_doubt
        assert "no samples from 99.84° to 160.08°" in found.message


@pytest.mark.parametrize(
    "angles",
    [
        [200.0 + 0.24 * k for k in range(1126)],  # 270°
        sorted((300.0 + 0.25 * k) % 360.0 for k in range(721)),  # 180° through 0, sorted
        [250.0 + 0.25 * k for k in range(881)],  # 220°
        [0.24 * k for k in range(1498)],  # a circle without its last two samples
    ],
)
def test_usual_arcs_are_no_circles_with_a_gap(angles: list[float]) -> None:
    assert "CW-R034" not in codes(read(csv(rows(angles))))


def test_runs_may_differ_by_a_sample_but_not_by_more() -> None:
    one = rows([250.0 + k for k in range(221)], "ccw")
    near = rows([(251.0 + k) % 360 for k in range(220)], "cw")
    test = read(csv(one + near))
    assert test.arc == (250.0, 220.0)
    assert test.of("cw")[0].angles[[0, -1]] == pytest.approx([470.0, 251.0])
    far = rows([253.0 + k for k in range(220)], "cw")
    line = fault(csv(one + far))
    assert (
        "cw run 1 covers another arc; expected 220 deg from 250 deg as in ccw run 1, found 219 deg"
        " from 253 deg" in line
    )
    assert "covers another arc" in fault(csv(one + rows([float(k) for k in range(360)], "cw")))


def test_runs_that_begin_on_either_side_of_zero_lie_together() -> None:
    one, near = (
        rows([359.6 + k for k in range(181)], "ccw"),
        rows([0.2 + k for k in range(181)], "cw"),
    )
    for body, start in (
        (one + near, 359.6),
        (one.replace("ccw", "cw") + near.replace("cw", "ccw"), 0.2 - 0.6),
    ):
        test = read(csv(body))
        assert test.arc == pytest.approx(
            (start % 360, 180.6)
        )  # from the first sample of either to the last of either
        lowest = [min(run.angles) for run in test.runs]
        assert abs(lowest[0] - lowest[1]) == pytest.approx(0.6)
    ends = rows([float(k) for k in range(181)], "ccw") + rows([2.5 + k for k in range(179)], "cw")
    assert "covers another arc" in fault(csv(ends))
    starts = rows(
        [2.5 + k * 177.5 / 180 for k in range(181)], "cw"
    )  # the same end, another beginning
    assert "covers another arc" in fault(csv(rows([float(k) for k in range(181)], "ccw") + starts))
    moved = rows([2.5 + k for k in range(181)], "cw")  # the same extent, moved
    assert "covers another arc" in fault(csv(rows([float(k) for k in range(181)], "ccw") + moved))


def test_planes_keep_the_order_of_their_axes() -> None:
    for plane, axes in (("ZX", ("Z", "X")), ("xz", ("X", "Z")), ("X1/Y2", ("X1", "Y2"))):
        test = read(csv(rows(FULL), head=HEAD.replace("XY", plane)))
        assert test.axes == axes
        assert test.plane == "".join(axes)


@pytest.mark.parametrize(
    ("value", "centre"),
    [
        ("-400, -250", (-400.0, -250.0)),
        ("[1,2,3]", (1.0, 2.0, 3.0)),
        ("-400,5; 250", (-400.5, 250.0)),
        ("1.5 2.5", (1.5, 2.5)),
    ],
)
def test_the_centre(value: str, centre: tuple[float, ...]) -> None:
    assert read(csv(rows(FULL), head=f"{HEAD}# centre: {value}\n")).centre == centre


@pytest.mark.parametrize(
    ("value", "calibrated"), [("yes", True), ("TRUE", True), ("no", False), ("false", False)]
)
def test_calibrated_is_said(value: str, calibrated: bool) -> None:
    test = read(csv(rows(FULL), head=f"{HEAD}# calibrated: {value}\n"))
    assert test.calibrated is calibrated
    assert codes(test) == []


def test_the_sign_that_the_file_states() -> None:
    """Deviations as target minus measured are turned, as in a positioning test."""
    turned = read(csv(rows(FULL), head=f"{HEAD}# deviation: target minus measured\n"))
    assert turned.runs[0].deviations == pytest.approx(-read(csv(rows(FULL))).runs[0].deviations)
    same = read(csv(rows(FULL), head=f"{HEAD}# deviation: measured minus target\n"))
    belongs(same)


BAD: list[tuple[bytes, str]] = [
    (csv(rows(FULL), head=""), "key 'plane' is missing"),
    (csv(rows(FULL), head=""), "key 'nominal_radius_mm' is missing"),
    (csv(rows(FULL), head=""), "key 'feed_mm_min' is missing"),
    (
        csv(rows(FULL), head=HEAD.replace("XY", "XX")),
        "line 1: key 'plane' names no plane; expected first and second axis",
    ),
    (
        csv(rows(FULL), head=HEAD.replace("150", "-150")),
        "line 2: key 'nominal_radius_mm' is not positive",
    ),
    (
        csv(rows(FULL), head=HEAD.replace("1000", "fast")),
        "line 3: key 'feed_mm_min' is not a number",
    ),
    (
        csv(rows(FULL), head=HEAD + "# plane: ZX\n"),
        "line 4: key 'plane' is given twice; expected 'XY', found 'ZX'",
    ),
    (
        csv(rows(FULL), head=HEAD + "# calibrated: maybe\n"),
        "line 4: key 'calibrated' has an unknown value",
    ),
    (csv(rows(FULL), head=HEAD + "# centre: here\n"), "line 4: key 'centre' is not a position"),
    (
        csv(rows(FULL), head=HEAD + "# deviation: outwards\n"),
        "line 4: key 'deviation' has an unknown value",
    ),
    (
        csv(
            "".join(f"ccw,{angle:g},{150.0 + 1e-3 * angle:g}\n" for angle in FULL),
            "direction,angle_deg,radius_mm",
            HEAD + "# deviation: target minus measured\n",
        ),
        "line 4: key 'deviation' turns the sign, but the values are radii",
    ),
    (
        csv(rows(FULL), head=HEAD + "# compwright: circular 2\n"),
        "was written for a newer version of compwright",
    ),
    (csv(rows(FULL), head=HEAD + "# compwright: positioning 1\n"), "is not a circular test"),
    (HEAD.encode(), "contains comment lines only"),
    (csv(""), "contains no samples"),
    (b"", "is empty"),
    (b"\x00\x01\x02\x00", "is a binary file"),
    (csv(rows(FULL), "direction,run,angle,deviation_um"), "line 4: column 'angle_deg' is missing"),
    (csv(rows(FULL), "sense,run,angle_deg,deviation_um"), "line 4: column 'direction' is missing"),
    (
        csv(rows(FULL), "direction,run,angle_deg,deviation_mm"),
        "the value column is missing; expected radius_mm or deviation_um",
    ),
    (
        csv("ccw,0,150,0\n", "direction,angle_deg,radius_mm,deviation_um"),
        "there is more than one value column",
    ),
    (
        csv(rows(FULL) + "up,1,5,0\n"),
        (
            "line 41, column direction: direction is neither ccw nor cw; expected ccw or cw, found"
            " 'up'"
        ),
    ),
    (
        csv(rows(FULL) + "ccw,0,5,0\n"),
        "line 41, column run: run is not a whole number of at least 1",
    ),
    (csv(rows(FULL) + "ccw,1,5,\n"), "line 41, column deviation_um is empty"),
    (csv(rows(FULL) + "ccw,1,nan,1\n"), "line 41, column angle_deg is not a finite number"),
    (csv(rows(FULL) + "ccw,1,800,1\n"), "line 41, column angle_deg is not an angle on the circle"),
    (
        csv(rows(FULL) + "ccw,1,20,1\n"),
        "line 41: a sample is given twice; expected each angle once per direction and run",
    ),
    (
        csv(rows(FULL) + "ccw,1,20\n"),
        "line 41: the row has fewer or more cells than the header row",
    ),
    (
        csv(rows([0.0, 120.0, 240.0])),
        "ccw run 1 has too few samples; expected at least 4, found 3",
    ),
    (
        csv(rows([0.0, 20.0, 40.0, 60.0])),
        "covers too short an arc; expected at least 90 deg, found 60 deg from 0 deg",
    ),
    (csv(rows([float(k) for k in range(400)])), "goes round more than once"),
    (csv(rows(FULL).replace(".", ",")), "the row has fewer or more cells"),
    (
        csv(
            rows(FULL).replace(",", ";").replace("1.0000", "1,0000"),
            "direction;run;angle_deg;deviation_um",
        ),
        "column deviation_um: decimal marks are mixed",
    ),
]


@pytest.mark.parametrize(("content", "words"), BAD)
def test_bad_files_are_refused_with_place_and_reason(content: bytes, words: str) -> None:
    assert words in fault(content)


@pytest.mark.parametrize(
    ("cell", "reason"),
    [
        ("", "is empty"),
        ("-", "is not a number"),
        ("1-", "is not a number"),
        ("--1", "is not a number"),
        ("1.2.3", "is not a number"),
        ("1 2", "is not a number"),
        ("\u0663.5", "is not a number"),
        ("1_0", "is not a number"),
        ("0x1", "is not a number"),
        ("nan", "is not a finite number"),
        ("12345678901.5", "is too large to be a reading"),
    ],
)
def test_one_damaged_cell_among_many_is_named_by_its_line(cell: str, reason: str) -> None:
    lines = rows([k / 32 for k in range(360 * 32)]).splitlines()
    lines[7000] = f"ccw,1,{7000 / 32},{cell}"
    # 3 comment lines and the header row come first.
    assert f"line 7005, column deviation_um {reason}" in fault(csv("\n".join(lines)))


def test_lines_are_counted_through_comments_and_blank_lines() -> None:
    lines = rows([k / 32 for k in range(360 * 32)]).splitlines()
    lines[6000:6002] = "# a remark", ""
    lines[7000] = "ccw,1,7"
    lines[11000] = "ccw,one,7,7"
    found = fault(csv("\n".join(lines)))
    assert "line 7005: the row has fewer or more cells than the header row" in found
    assert "line 11005, column run: run is not a whole number" in found


@pytest.mark.parametrize("places", [*range(16)])
def test_each_number_is_the_nearest_that_the_computer_has(places: int) -> None:
    """Python's own conversion of each cell alone is the reference."""
    numbers = [(-1) ** k * (k * 0.6180339887498949 % 1.0) * 10 ** (k % 4) for k in range(360)]
    cells = [f"{number:+.{places}f}" for number in numbers]
    body = "".join(f"ccw,1,{k},{cell}\n" for k, cell in enumerate(cells))
    (run,) = read(csv(body)).runs
    np.testing.assert_array_equal(run.deviations, np.array([float(cell) for cell in cells]) / 1e3)


def test_all_faults_are_told_at_once() -> None:
    text = fault(csv(rows(FULL) + "up,1,5,0\nccw,1,x,0\n", head="# plane: X\n"))
    for words in (
        "names no plane",
        "nominal_radius_mm",
        "feed_mm_min",
        "neither ccw nor cw",
        "is not a number",
    ):
        assert words in text


@pytest.mark.parametrize(
    ("factor", "hint"),
    [
        (1 / 25.4, "as it would be in inch"),
        (1000.0, "as it would be in um"),
        (1e-3, "as it would be in m"),
        (0.0, "as deviations are"),
    ],
)
def test_radii_in_another_unit_are_refused(factor: float, hint: str) -> None:
    body = "".join(f"ccw,{angle:g},{150.01 * factor:.6f}\n" for angle in FULL)
    text = fault(csv(body, "direction,angle_deg,radius_mm"))
    assert (
        "ccw run 1, column radius_mm: radius_mm is far from the nominal radius; expected about"
        " 150 mm" in text
    )
    assert hint in text
    assert (
        "far from the nominal radius"
        in fault(csv(body.replace(",150", ",100"), "direction,angle_deg,radius_mm"))
        or factor != 1.0
    )


def test_repeated_angles_without_run_ask_for_the_column() -> None:
    body = "".join(f"ccw,{angle:g},1\n" for angle in FULL * 2)
    assert "a column 'run' if a direction has several" in fault(
        csv(body, "direction,angle_deg,deviation_um")
    )


@pytest.mark.parametrize("offset", [0.0, 0.3])
def test_millimetres_in_a_column_of_micrometres_are_a_doubt(offset: float) -> None:
    """A circle of G = 20 µm, well centred or 0.3 mm off, whose deviations are in mm."""
    theta = np.radians(FULL)
    deviations = 0.01 * np.cos(2.0 * theta) + offset * np.sin(theta)
    body = "".join(
        f"{way},{angle:g},{deviation:.5f}\n"
        for way in ("ccw", "cw")
        for angle, deviation in zip(FULL, deviations, strict=True)
    )
    assert "CW-R036" in codes(read(csv(body, "direction,angle_deg,deviation_um")))


def test_what_is_remarkable() -> None:
    body = "".join(f"ccw,{angle:g},0,a\ncw,{angle:g},1500.5,b\n" for angle in FULL)
    test = read(csv(body, "direction,angle_deg,deviation_um,note"))
    assert codes(test) == ["CW-R001", "CW-R005", "CW-R035", "CW-R036"]
    assert (
        "The deviations of ccw 1, cw 1 from a circle are below 0.1 µm" in test.findings[-1].message
    )


def test_what_is_circular() -> None:
    assert is_circular(csv(rows(FULL)), "a.txt")
    assert is_circular(b"# compwright: circular 1\nx;y\n", "a.txt")
    assert is_circular(b"<?xml version='1.0'?><a/>", "a.xml")
    assert is_circular(b"\xef\xbb\xbf<TEST_DOCUMENT/>", "a")
    assert is_circular(b"", "run.B5R")
    assert not is_circular(b"", "run.csv")
    assert not is_circular(b"target_mm,direction,run,deviation_um\n0,+,1,2\n", "run.b5r")
    assert not is_circular(
        b"target_deg,angle_deg,direction,run,deviation_arcsec\n0,0,+,1,2\n", "c.csv"
    )
    assert not is_circular(b"TGT_DATA[1]=0\n", "a.dat")
    assert not is_circular(b"\x00\xff\xfe<", "a.dat")
    with pytest.raises(InputError, match="contains a circular test, not a positioning test"):
        read_positioning(csv(rows(FULL)), "a.csv")


def one(
    sense: str, angles: list[float] | None = None, head: str = HEAD, run: int = 1
) -> CircularTest:
    return read_circular(csv(rows(angles or FULL, sense, run), head=head), f"{sense}{run}.csv")


def test_files_of_one_test_are_merged_and_runs_counted_on() -> None:
    head = HEAD + "# calibrated: yes\n# machine: A\n"
    tests = [
        one("cw", head=head),
        one("ccw", head=head),
        one("ccw", head=head.replace("A", "B"), run=2),
    ]
    merged = merge_circular(tests, "xy-150")
    assert merged.name == "xy-150"
    assert [(run.sense, run.number) for run in merged.runs] == [("ccw", 1), ("ccw", 2), ("cw", 1)]
    assert np.array_equal(merged.of("ccw")[1].deviations, tests[2].runs[0].deviations)
    assert [source.file for source in merged.sources] == ["cw1.csv", "ccw1.csv", "ccw2.csv"]
    assert merged.header["machine"] == "A\nB"
    assert merged.calibrated
    belongs(merged)


def test_one_uncalibrated_file_makes_the_test_uncalibrated() -> None:
    merged = merge_circular(
        [
            one("cw", head=HEAD + "# calibrated: yes\n"),
            one("ccw", head=HEAD + "# calibrated: no\n"),
        ],
        "t",
    )
    assert not merged.calibrated
    assert codes(merged) == ["CW-R037"]
    assert "for ccw1.csv" in merged.findings[0].message


ARC = [float(k) for k in range(181)]


@pytest.mark.parametrize(
    ("other", "words"),
    [
        (
            one("cw", head=HEAD.replace("XY", "ZX")),
            "cw1.csv: the plane differs between the files of one test; expected XY",
        ),
        (one("cw", head=HEAD.replace("150", "100")), "the nominal radius differs"),
        (one("cw", head=HEAD.replace("1000", "2000")), "the feed differs"),
        (one("cw", head=HEAD + "# centre: 0, 5\n"), "the centre differs"),
        (
            one("cw", ARC),
            (
                "covers another arc; expected 360 deg from 0 deg as in ccw1.csv, found 180 deg from"
                " 0 deg"
            ),
        ),
        (one("ccw", head=HEAD + "# centre: 0, 0\n"), "the same measurement is given twice"),
    ],
)
def test_files_that_do_not_belong_together(other: CircularTest, words: str) -> None:
    with pytest.raises(InputError) as caught:
        merge_circular([one("ccw", head=HEAD + "# centre: 0, 0\n"), other], "t")
    assert words in str(caught.value)


def test_arcs_in_two_files_may_differ_by_a_sample() -> None:
    merged = merge_circular([one("ccw", ARC), one("cw", ARC[1:])], "t")
    assert merged.arc == (0.0, 180.0)
    around = [one("ccw", [359.6 + k for k in range(181)]), one("cw", [0.2 + k for k in range(181)])]
    assert len(merge_circular(around, "t").runs) == 2  # 0.6 deg apart, on either side of zero
    with pytest.raises(InputError, match="covers another arc"):
        merge_circular([one("ccw", ARC), one("cw", [angle + 3 for angle in ARC])], "t")
    with pytest.raises(UsageError):
        merge_circular([], "t")


def read_or_faults(content: bytes) -> CircularTest | InputError:
    try:
        return read_circular(content, "x.csv")
    except InputError as error:
        return error


SOUND = csv(rows(FULL) + rows(FULL, "cw"), head=HEAD + "# calibrated: yes\n# centre: 1, 2\n")


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_any_change_of_a_file_is_read_or_refused(data: st.DataObject) -> None:
    content = bytearray(SOUND)
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(content) - 1))
        match data.draw(st.sampled_from(["set", "cut", "insert", "repeat"])):
            case "set":
                content[at] = data.draw(st.integers(0, 255))
            case "cut":
                del content[at : at + data.draw(st.integers(1, 40))]
            case "insert":
                content[at:at] = data.draw(
                    st.sampled_from(
                        [b"\n", b",", b"-", b"e9", b"nan", b"0", b"\x00", b'"', b"9999"]
                    )
                )
            case _:
                content[at:at] = content[at : at + 30]
        if not content:
            break
    test = read_or_faults(bytes(content))
    if isinstance(test, InputError):
        assert test.faults
        assert all(fault.file == "x.csv" for fault in test.faults)
    else:
        for run in test.runs:
            assert np.isfinite(run.deviations).all()
            assert (np.diff(run.angles) * (1 if run.sense == "ccw" else -1) >= 0).all()
        assert 0 <= test.arc[0] < 360
        assert 0 < test.arc[1] <= 360


@settings(max_examples=60, deadline=None)
@given(st.binary(max_size=300))
@example(b"\xff\xfe")
@example(b"<")
@example(b"#")
@example(b'"')
def test_any_bytes_are_read_or_refused(content: bytes) -> None:
    assert is_circular(content, "x.csv") in {True, False}
    with pytest.raises(InputError):
        read_circular(content, "x.csv")


@settings(max_examples=100, deadline=None)
@given(
    start=st.integers(0, 359),
    count=st.integers(20, 400),
    extent=st.integers(95, 350),
    order=st.randoms(use_true_random=False),
)
def test_an_arc_is_found_whatever_the_order_and_the_counting(
    start: int, count: int, extent: int, order: object
) -> None:
    angles = [round((start + extent * k / (count - 1)) % 360, 4) for k in range(count)]
    if 360 - extent <= 2 * extent / (count - 1):
        return  # the gap is hardly wider than a sample: it may as well be a circle
    shuffled = list(angles)
    order.shuffle(shuffled)  # type: ignore[attr-defined]  # hypothesis gives a random.Random
    body = "".join(f"cw,{angle:.4f},{angle / 10:.6f}\n" for angle in shuffled)
    test = read(csv(body, "direction,angle_deg,deviation_um"))
    assert (test.arc[0] - start + 180) % 360 - 180 == pytest.approx(0, abs=1e-3)
    assert test.arc[1] == pytest.approx(extent, abs=1e-3)
    belongs(test)
