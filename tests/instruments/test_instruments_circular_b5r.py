"""Ballbar files: the published ones against their own printed results, and one made by hand with
every way to be wrong.
"""

from __future__ import annotations

import codecs
import csv
import math
import re
import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import InputError
from compwright.instruments.circular_reading import merge_circular, read_circular
from compwright.instruments.other_files import is_circular
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun, CircularTest
from places import REAL, needs_shared

FOLDER = REAL / "ballbar"
NAMES = (
    "ballbar_demo_100mm_XY.b5r",
    "ballbar_qc20w_150mm_XY.b5r",
    "ballbar_qc20w_150mm_ZX_220deg.b5r",
)


def real(name: str) -> bytes:
    return (FOLDER / name).read_bytes()


def expected(name: str) -> dict[str, str]:
    lines = (FOLDER / "ballbar_expected.csv").read_text(encoding="utf-8").splitlines()
    return next(
        row
        for row in csv.DictReader(line for line in lines if not line.startswith("#"))
        if row["file"] == name
    )


def circle(run: CircularRun, nominal: float) -> tuple[float, float, float]:
    """Least-squares circle (cx, cy, mean radius - nominal) in um: Gauss-Newton on the distances, on
    its own.
    """
    t = np.radians(run.angles)
    points = (nominal + run.deviations) * np.array([np.cos(t), np.sin(t)])
    centre, radius = np.zeros(2), nominal
    for _ in range(20):
        away = points - centre[:, None]
        distance = np.hypot(*away)
        jacobian = np.column_stack([(away / distance).T, np.ones(distance.size)])
        step: FloatArray = np.linalg.lstsq(jacobian, distance - radius, rcond=None)[0]
        centre, radius = centre + step[:2], radius + float(step[2])
    return 1e3 * float(centre[0]), 1e3 * float(centre[1]), 1e3 * (radius - nominal)


@needs_shared
@pytest.mark.parametrize("name", NAMES)
def test_published_files_give_their_centres_and_radii(name: str) -> None:
    """Half a sample of angle is 0.1 deg: 0.01 um of these centres; the table is printed to 0.01 um,
    0.05 um is asked for.
    """
    test, row = read_circular(real(name), name), expected(name)
    assert test.plane == row["plane"]
    assert test.axes == ((row["plane"][0], row["plane"][1]))
    assert test.nominal_radius == float(row["nominal_mm"])
    extent = (float(row["end_deg"]) - float(row["start_deg"])) % 360 or 360
    assert test.arc == (float(row["start_deg"]), extent)
    for run in test.runs:
        key = run.sense
        assert run.angles.size == int(row[f"{key}_n"])
        wanted = [float(row[f"{key}_{what}"]) for what in ("cx_um", "cy_um", "mean_dev_um")]
        assert circle(run, test.nominal_radius) == pytest.approx(wanted, abs=0.05)


@needs_shared
@pytest.mark.parametrize("name", NAMES)
def test_printed_results_of_the_runs_come_out_of_the_readings(name: str) -> None:
    test = read_circular(real(name), name)
    feeds = []
    for run in test.runs:
        printed = test.vendor[run.sense]
        assert isinstance(printed, dict)
        cx, cy, mean = circle(run, test.nominal_radius)
        assert printed["AF_CENTRE_OFFSET_A"] == {
            "value": pytest.approx(cx / 1e3, abs=1e-4),
            "unit": "mm",
        }
        assert printed["AF_CENTRE_OFFSET_B"] == {
            "value": pytest.approx(cy / 1e3, abs=1e-4),
            "unit": "mm",
        }
        assert printed["AF_BEST_RADIUS"]["value"] == pytest.approx(
            test.nominal_radius + mean / 1e3, abs=1e-4
        )
        feeds.append(printed["AF_CALCULATED_FEEDRATE"]["value"])
    assert test.feed == pytest.approx(sum(feeds) / len(feeds), abs=0.1)  # mm/min, printed to 0.1


@needs_shared
def test_what_else_the_published_files_say() -> None:
    demo, full, arc = (read_circular(real(name), name) for name in NAMES)
    assert [test.calibrated for test in (demo, full, arc)] == [False, True, True]
    assert arc.axes == ("Z", "X")
    assert arc.header["view"] == "+B+A"
    assert [run.sense for run in arc.runs] == ["ccw", "cw"]  # the file has cw first
    assert full.header["programmed_feed_mm_min"] == "2000"
    assert full.header["expansion_um_m_k"] == "10.5"
    assert full.header["run_temperature_c"] == "22.0"
    assert full.header["comment"] == "31928"
    assert [finding.code for finding in full.findings] == ["CW-R030"]
    assert demo.findings == ()  # its coefficient is 0
    diagnostics = arc.vendor["RENISHAW_DIAGNOSTICS 2.1"]
    assert isinstance(diagnostics, dict)
    assert diagnostics["AF_SQUARENESS"] == {"value": -22.5, "unit": "um/m"}
    assert diagnostics["AF_SCALE_ERROR_A"] == {"value": -3.0, "unit": "ppm", "valid": False}
    assert diagnostics["AF_SERVO_MISMATCH"] == {"value": -0.01, "unit": "ms"}
    assert diagnostics["AF_SQUARENESS_RANK"] == {"value": 1.0, "unit": "rank"}
    iso = arc.vendor["ISO230_4 2005"]
    assert isinstance(iso, dict)
    assert iso["AF_BIDIRECTIONAL_CIRCULAR_DEVIATION"] == {"value": 6.6, "unit": "um"}


@needs_shared
def test_the_same_file_in_other_clothes() -> None:
    content = real(NAMES[1])
    plain = read_circular(content, "a.b5r")
    text = content.decode()
    for other in (
        codecs.BOM_UTF8 + content,
        content.replace(b"\n", b"\r\n"),
        text.replace('encoding="utf-8"', 'encoding="utf-16"').encode("utf-16"),
        content.replace(b"<TEST_DOCUMENT>", b"<!-- a comment -->\n<TEST_DOCUMENT>"),
    ):
        assert is_circular(other, "a")
        test = read_circular(other, "a.b5r")
        assert test.vendor == plain.vendor
        assert all(
            np.array_equal(a.deviations, b.deviations)
            for a, b in zip(test.runs, plain.runs, strict=True)
        )


@needs_shared
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("share", [0.1, 0.4, 0.6, 0.9, 0.999])
def test_published_files_cut_short(name: str, share: float) -> None:
    content = real(name)
    with pytest.raises(InputError, match=r"line \d+, column \d+: the file is cut off"):
        read_circular(content[: int(len(content) * share)], name)


#: Ten samples of overshoot, forty of the arc from 30 to 210 deg, ten of overshoot; the arc's
#: readings are 1, 2, ... um.
READINGS = " ".join(["+0.90000"] * 10 + [f"+0.{k:03d}00" for k in range(1, 41)] + ["-0.90000"] * 10)


def run_xml(
    sense: str = "CCW",
    readings: str = READINGS,
    start: str = "10",
    end: str = "49",
    rate: str = "2.122066",
) -> str:
    # 2 pi 100 mm * 180/360 / 40 samples * 2.122066/s * 60 = 1000 mm/min
    return (
        f"<BALLBAR_RUN><RUN_DIRECTION>{sense}</RUN_DIRECTION><RUN_TEMPERATURE>21.5</RUN_TEMPERATURE><START_INDEX>{start}</START_INDEX><END_INDEX>{end}</END_INDEX><SAMPLE_RATE>{rate}</SAMPLE_RATE><READINGS>{readings}</READINGS><FEATURE"
        ' NAME="AF_X" DT="UT_NEW">n/a</FEATURE></BALLBAR_RUN>\n'
    )


def document(runs: str | None = None, **changes: str) -> bytes:
    spec = {
        "NOMINAL_LENGTH": "100",
        "PROGRAMMED_FEEDRATE": "1000",
        "START_ANGLE": "30",
        "END_ANGLE": "210",
        "OVERSHOOT_ANGLE": "45",
        "TEST_RADIUS": "100",
    } | changes
    lines = "".join(f"<{tag}>{text}</{tag}>\n" for tag, text in spec.items())
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n<TEST_DOCUMENT>\n<TEST_SPEC NAME="by'
        ' hand"><INSTRUMENT MODEL="QC20-W">\n<DYNAMIC_BALLBAR'
        f' CALIBRATION_REQUIRED="true">\n{lines}<PLANE VIEW="+A+B"'
        ' TEST_PLANE="YZ"><A_AXIS_NAME>Y</A_AXIS_NAME><B_AXIS_NAME>Z</B_AXIS_NAME></PLANE><RUN_SPEC><RUN_DIRECTION>CCW</RUN_DIRECTION><RUN_DIRECTION>CW</RUN_DIRECTION></RUN_SPEC>\n<CENTRE>100;'
        f" -50</CENTRE></DYNAMIC_BALLBAR></INSTRUMENT></TEST_SPEC>\n<RUN_RESULTS>\n{run_xml('CW') + run_xml('CCW') if runs is None else runs}</RUN_RESULTS>\n<ANALYSIS"
        ' NAME="A"><SIMULATION>1 2 3</SIMULATION></ANALYSIS>\n</TEST_DOCUMENT>'
    ).encode()


def read(content: bytes) -> CircularTest:
    return read_circular(content, "yz.b5r")


def fault(content: bytes) -> str:
    with pytest.raises(InputError) as caught:
        read(content)
    lines = str(caught.value).splitlines()
    assert all(line.startswith("yz.b5r: ") for line in lines)
    return "\n".join(lines)


def test_a_file_made_by_hand() -> None:
    test = read(document())
    assert (test.name, test.plane, test.axes, test.arc, test.calibrated) == (
        "yz",
        "YZ",
        ("Y", "Z"),
        (30.0, 180.0),
        True,
    )
    ccw, cw = test.runs
    assert ccw.angles == pytest.approx(30 + 4.5 * (np.arange(40) + 0.5))
    assert cw.angles == pytest.approx(210 - 4.5 * (np.arange(40) + 0.5))
    for run in (ccw, cw):
        assert run.deviations == pytest.approx(np.arange(1, 41) / 1e3)
    assert test.feed == pytest.approx(1000.0, rel=1e-6)
    assert test.centre == (100.0, -50.0)
    assert test.vendor["ccw"] == {"AF_X": {"value": "n/a", "unit": "UT_NEW"}}
    assert test.findings == ()
    assert not read(document().replace(b'"true"', b'"false"')).calibrated
    assert not read(document().replace(b' CALIBRATION_REQUIRED="true"', b"")).calibrated


def test_runs_of_one_direction_are_numbered() -> None:
    test = read(
        document(
            run_xml("CW") + run_xml("CCW") + run_xml("CW", READINGS.replace("+0.001", "+0.101"))
        )
    )
    assert [(run.sense, run.number) for run in test.runs] == [("ccw", 1), ("cw", 1), ("cw", 2)]
    assert [run.deviations[0] for run in test.runs] == pytest.approx([0.001, 0.001, 0.101])
    assert set(test.vendor) == {"cw", "ccw", "cw 2"}


def test_full_circles_by_equal_angles() -> None:
    for start, end, low in (("45", "45", 45.0), ("0", "360", 0.0), ("-90", "270", 270.0)):
        test = read(document(START_ANGLE=start, END_ANGLE=end))
        assert test.arc == (low, 360.0)
        assert test.runs[0].angles[0] == pytest.approx(low + 4.5)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (
            document(PROGRAMMED_FEEDRATE="1200"),
            "CW-R031: Sample rate and number of samples give a true feed of 1000 mm/min",
        ),
        (document(run_xml("CW")), "CW-R033: The file announces a ccw run"),
        (
            document(run_xml("CW") + run_xml("CCW", READINGS + " 0.1 0.1")),
            "CW-R032: Run ccw 1 has 2 more readings",
        ),
        (
            document(run_xml("CW") + run_xml("CCW", READINGS.removesuffix(" -0.90000"))),
            "CW-R032: Run ccw 1 has 1 fewer readings",
        ),
        (
            document(TEMP_MATERIAL_COEFFICIENT="11.5"),
            "CW-R030: The readings already include the calibration",
        ),
        (
            document(run_xml("CW") + run_xml("CCW", READINGS.replace("+0.020", "-1.200"))),
            "CW-R035: The largest deviation",
        ),
        (
            document(run_xml("CW") + run_xml("CCW", " ".join(["0.00000"] * 60))),
            "CW-R036: The deviations of ccw 1 from a circle are below 0.1 µm",
        ),
    ],
)
def test_what_is_remarkable(content: bytes, words: str) -> None:
    (finding,) = read(content).findings
    assert words in f"{finding.code}: {finding.message}"


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (
            document(NOMINAL_LENGTH="x"),
            (
                "DYNAMIC_BALLBAR/NOMINAL_LENGTH is not a number; expected a number with a decimal"
                " point, found 'x'"
            ),
        ),
        (document(NOMINAL_LENGTH="100,0"), "is not a number"),
        (document(NOMINAL_LENGTH="0"), "NOMINAL_LENGTH is out of range"),
        (document(NOMINAL_LENGTH="1e300"), "is not a number"),
        (document(START_ANGLE=""), "line 7, DYNAMIC_BALLBAR/START_ANGLE is empty"),
        (document(PROGRAMMED_FEEDRATE="-5"), "PROGRAMMED_FEEDRATE is out of range"),
        (
            document(TEST_RADIUS="150"),
            (
                "test radius and length of the ballbar differ; expected 100 mm, as NOMINAL_LENGTH,"
                " found 150 mm"
            ),
        ),
        (
            document(END_ANGLE="110"),
            (
                "covers too short an arc; expected at least 90 deg from START_ANGLE to END_ANGLE,"
                " found 80 deg"
            ),
        ),
        (
            document().replace(b'TEST_PLANE="YZ"', b'TEST_PLANE="Q"'),
            'Next: write the plane into a copy of the file: TEST_PLANE="XY"',
        ),
        (
            document().replace(b"<B_AXIS_NAME>Z", b"<B_AXIS_NAME>y"),
            "DYNAMIC_BALLBAR/PLANE names one axis twice",
        ),
        (
            document().replace(b"<B_AXIS_NAME>Z", b"<B_AXIS_NAME>X"),
            "DYNAMIC_BALLBAR/PLANE names other axes than its plane; expected Y and Z in",
        ),
        (
            document().replace(b'TEST_PLANE="YZ"', b'TEST_PLANE="ZY"'),
            "names other axes than its plane; expected Z and Y in A_AXIS_NAME and B_AXIS_NAME",
        ),
        (document(run_xml("UP")), "BALLBAR_RUN/RUN_DIRECTION: direction is neither CCW nor CW"),
        (
            document(run_xml(readings=READINGS.replace("+0.003", "abc"))),
            "READINGS, value 13: a reading is not a number",
        ),
        (
            document(run_xml(readings=READINGS.replace("+0.003", "nan"))),
            "a reading is not a number",
        ),
        (
            document(run_xml(readings=READINGS.replace("0.00300", "0,00300"))),
            "a reading is not a number",
        ),
        (
            document(run_xml(readings=READINGS[:200])),
            "END_INDEX is outside the readings; expected at most",
        ),
        (
            document(run_xml(readings=READINGS + " 0.1" * 20)),
            "READINGS have the wrong length; expected 60 values",
        ),
        (
            document(run_xml(readings=READINGS.removesuffix(" -0.90000" * 5))),
            "READINGS have the wrong length; expected 60 values",
        ),
        (
            document(run_xml(start="0", end="60")),
            "END_INDEX is outside the readings; expected at most 59, the last, found 60",
        ),
        (
            document(run_xml(readings="x " * 1_000_001)),
            "READINGS are longer than any run; expected at most 1000000 values",
        ),
        (document(run_xml(readings="")), "READINGS is empty"),
        (
            document(run_xml(start="-1")),
            "START_INDEX is not an index; expected 0, 1, 2, ..., found '-1'",
        ),
        (
            document(run_xml(start="49")),
            "has too few samples; expected at least 4 samples from START_INDEX to END_INDEX",
        ),
        (document(run_xml(end="99999999")), "END_INDEX is outside the readings"),
        (document(run_xml(rate="fast")), "BALLBAR_RUN/SAMPLE_RATE is not a number"),
        (
            document(re.sub("<END_INDEX>.*</END_INDEX>", "", run_xml())),
            "BALLBAR_RUN/END_INDEX is missing",
        ),
        (document(run_xml().replace("READINGS", "VALUES")), "contains no readings"),
        (document(""), "contains no readings: the test was set up, or its header exported"),
        (
            document(run_xml() + run_xml("CW").replace("READINGS", "VALUES")),
            "BALLBAR_RUN/READINGS is missing",
        ),
        (
            document().replace(b"DYNAMIC_BALLBAR", b"LASER"),
            "is of another instrument; expected a dynamic ballbar test, found 'LASER'",
        ),
        (document().replace(b"INSTRUMENT", b"TOOL"), "does not state which instrument measured"),
        (
            b"<?xml version='1.0'?><a/>",
            "line 1: the file is not a ballbar file; expected the root element TEST_DOCUMENT, found 'a'",
        ),
        (b"<html><body>", "is cut off"),
        (b"<a></b>", "line 1, column 6: the file is not whole XML (mismatched tag); expected </a>"),
        (document().replace(b"utf-8", b"klingon"), "in an unknown encoding"),
        (b"<" + b"a><" * 50 + b"b", "has more elements than any measurement"),
        (b"<?xml version='1.0'?>" + b" " * 33_000_000, "is too large"),
    ],
)
def test_bad_files_are_refused_with_place_and_reason(content: bytes, words: str) -> None:
    assert words in fault(content)


def test_all_faults_are_told_at_once() -> None:
    text = fault(document(run_xml(start="x") + run_xml("UP"), NOMINAL_LENGTH="x", END_ANGLE="40"))
    for words in ("NOMINAL_LENGTH", "too short an arc", "START_INDEX", "neither CCW nor CW"):
        assert words in text


LAUGHS = "".join(f'<!ENTITY a{k + 1} "{f"&a{k};" * 10}">' for k in range(12))


@pytest.mark.parametrize(
    "head",
    [
        f'<!DOCTYPE x [<!ENTITY a0 "ha">{LAUGHS}]>',
        '<!DOCTYPE x SYSTEM "file:///etc/passwd">',
        '<!DOCTYPE x [<!ENTITY a12 SYSTEM "file:///etc/passwd">]>',
    ],
)
def test_entities_are_refused_before_they_grow(head: str) -> None:
    content = document(NOMINAL_LENGTH="&a12;").replace(
        b"<TEST_DOCUMENT>", head.encode() + b"\n<TEST_DOCUMENT>", 1
    )
    begin = time.process_time()
    assert "line 2: the XML of the file is refused: it declares a document type (DOCTYPE)" in fault(
        content
    )
    assert (
        time.process_time() - begin < 1.0
    )  # s of the processor; growing it would take 10^12 characters


def test_directions_in_two_files_are_merged() -> None:
    one, other = read(document(run_xml("CW"))), read_circular(document(run_xml("CCW")), "b.b5r")
    merged = merge_circular([one, other], "yz")
    assert [run.sense for run in merged.runs] == ["ccw", "cw"]
    assert set(merged.vendor) == {"yz.b5r", "b.b5r"}
    assert merged.feed == pytest.approx(1000.0, rel=1e-6)


def read_or_faults(content: bytes) -> CircularTest | InputError:
    try:
        return read(content)
    except InputError as error:
        return error


TREE = document()


@settings(max_examples=100, deadline=None)
@given(st.data())
def test_any_change_of_a_file_is_read_or_refused(data: st.DataObject) -> None:
    content = bytearray(TREE)
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(content) - 1))
        match data.draw(st.sampled_from(["set", "cut", "insert", "number"])):
            case "set":
                content[at] = data.draw(st.integers(0, 255))
            case "cut":
                del content[at : at + data.draw(st.integers(1, 60))]
            case "insert":
                content[at:at] = data.draw(
                    st.sampled_from(
                        [
                            b"<",
                            b">",
                            b"&amp;",
                            b"&x;",
                            b"-",
                            b"9",
                            b"e5",
                            b"<a/>",
                            b"<!---->",
                            b"\x00",
                        ]
                    )
                )
            case _:
                numbers = list(re.finditer(rb">[0-9.]+<", content))
                if numbers:
                    found = numbers[at % len(numbers)]
                    new = data.draw(
                        st.sampled_from(
                            [
                                b"0",
                                b"-1",
                                b"1e9",
                                b"1e400",
                                b"nan",
                                b"",
                                b"99999999999",
                                b"0.5",
                                b"90",
                            ]
                        )
                    )
                    content[found.start() + 1 : found.end() - 1] = new
        if not content:
            break
    test = read_or_faults(bytes(content))
    if isinstance(test, InputError):
        assert all(fault.file == "yz.b5r" for fault in test.faults)
    else:
        assert all(
            np.isfinite(run.deviations).all() and np.isfinite(run.angles).all() for run in test.runs
        )
        assert math.isfinite(test.feed)
        assert test.feed > 0
        assert 90 - 1e-6 <= test.arc[1] <= 360


def test_a_run_that_stands_elsewhere_is_told() -> None:
    moved = document().replace(b"<NOMINAL_LENGTH>", run_xml().encode() + b"<NOMINAL_LENGTH>")
    (finding,) = [one for one in read(moved).findings if one.code == "CW-R063"]
    assert finding.severity == "warning"
    assert "line 5 'BALLBAR_RUN'" in finding.message
    assert "CW-R063" not in {one.code for one in read(document()).findings}
