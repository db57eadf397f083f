"""Job files: the contract's own example, every rule of the schema, all faults at once.

The expected values are read off the job texts by hand and off the outside contract
(`shared/contract.md`, "Job file").
"""

from __future__ import annotations

import re
import textwrap

import pytest

from compwright.foundations.errors import UsageError
from compwright.jobs.reading import read_job
from compwright.records.axis import AxisKind, Direction, Encoder, PositionMap
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.fitted_table import TableRequest
from compwright.records.job import NONE_STATE, Acceptance, Job, ReportHead
from next_steps import without_hint
from places import PROJECT, SHARED, needs_shared

SMALLEST = """
compwright: 1
controller: {format: linuxcnc}
axes:
  X: {travel: [0, 500], before: [runs/x.csv]}
"""


def job(text: str) -> Job:
    return read_job(textwrap.dedent(text).encode(), "job.yaml")


def faults_of(text: str) -> list[str]:
    with pytest.raises(UsageError) as caught:
        job(text)
    assert caught.value.exit_code == 2
    return [without_hint(str(fault)) for fault in caught.value.faults]


def axis_faults(keys: str) -> list[str]:
    """Return the faults of a job whose axis X has ``keys`` beside what is required."""
    required = {"travel": "[0, 500]", "before": "[x.csv]"}
    lines = [f"{key}: {value}" for key, value in required.items() if f"{key}:" not in keys] + [keys]
    text = (
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none, off:"
        " none}\naxes:\n  X:\n"
    )
    return faults_of(text + textwrap.indent("\n".join(lines), "    "))


def test_smallest_job_has_every_default_of_the_contract() -> None:
    read = job(SMALLEST)
    axis = read.axes["X"].axis
    assert (read.file, read.format, read.standard, read.report) == (
        "job.yaml",
        "linuxcnc",
        "iso230-2:2014",
        ReportHead(),
    )
    assert (axis.kind, axis.travel, axis.address) == (AxisKind.LINEAR, (0.0, 500.0), "X")
    assert (axis.reference, axis.reference_return, axis.encoder) == (
        0.0,
        Direction.POSITIVE,
        Encoder("incremental", 1),
    )
    assert (axis.programmed, axis.screw_pitch, axis.modulo, axis.axis_number, axis.gantry) == (
        "radius",
        (),
        None,
        None,
        None,
    )
    assert read.axes["X"].table == TableRequest(
        start=None, end=None, spacing=None, mode="auto", goal="expected"
    )
    assert read.axes["X"].table.keeps
    (test,) = read.axes["X"].before
    assert (test.files, test.name, test.measured_in) == (("runs/x.csv",), "x", "as_found")
    assert test.position_map == PositionMap(1, 0.0)
    assert (read.states, read.findings, read.thermal, read.uncertainty) == ({}, (), None, None)
    assert read.decision_rule == "simple"


def example_of_the_page() -> str:
    page = (PROJECT / "docs" / "job-file.md").read_text(encoding="utf-8")
    found = re.search(r"```yaml\n(.*?)```", page, re.DOTALL)
    assert found is not None
    return found[1]


def test_complete_example_of_the_page_is_read_key_by_key() -> None:
    read = job(example_of_the_page())
    x, b = read.axes["X"], read.axes["B"]
    assert read.machine == {
        "name": "VMC 850",
        "serial": "1111111",
        "type": "vertical machining centre",
    }
    assert read.options == {"detection_unit": 0.001}
    assert read.states == {
        "as_found": ("control/CNC-PARA.TXT", "control/PITCH.TXT"),
        "comp_off": NONE_STATE,
    }
    assert (x.axis.address, x.axis.axis_number, x.axis.gantry, x.axis.screw_pitch) == (
        "1",
        1,
        "5",
        (10.0,),
    )
    assert x.axis.travel == (-850.0, 0.0)
    assert [test.name for test in x.before] == ["x_before", "x_off"]
    assert x.before[1].files == ("runs/x_off_1.csv", "runs/x_off_2.csv")
    assert [test.measured_in for test in x.before] == ["as_found", "comp_off"]
    assert [test.position_map for test in x.before] == [PositionMap(1, -850.0)] * 2
    assert x.table == TableRequest(
        start=-850.0, end=0.0, spacing=50.0, mode="auto", goal="expected"
    )
    assert x.accept is not None
    assert (x.accept.limits, x.accept.test) == ({"A": 8.0, "E": 6.0, "B": 3.0}, None)
    assert (b.axis.kind, b.axis.modulo, b.axis.screw_pitch, b.axis.address) == (
        AxisKind.ROTARY,
        360.0,
        (2.0, 4.0),
        "4",
    )
    assert b.accept is not None
    assert (b.accept.limits, b.accept.test) == ({"A": 12.0}, "b_before")
    assert read.uncertainty == UncertaintyBudget(
        device=0.5,
        device_per_m=0.5,
        misalignment_mm=1.0,
        U_theta=0.5,
        U_alpha=1.0,
        setup=0.0,
        E_VE=1.0,
    )
    assert read.thermal == Thermal(
        alpha_m=11.5, T_m=22.0, alpha_d=0.0, T_d=20.0, x_fix=0.0, refer_to="scale"
    )
    assert read.fixed_positions == {"tool_change": {"Z": 0.0}}
    assert read.proven == (
        {
            "control": "FANUC 31i-B",
            "machine": "VMC 850",
            "date": "2024-05-17",
            "how": "laser before and after",
        },
    )
    assert [(circle.name, circle.files, circle.centre) for circle in read.circles] == [
        ("xy-150", ("runs/xy.b5r",), (-400.0, -250.0, -300.0)),
        ("zx-100", ("runs/zx_ccw.csv", "runs/zx_cw.csv"), None),
    ]
    (cross,) = read.cross
    assert (cross.input, cross.output, cross.positions) == ("X", "Y", (-800.0, -400.0, 0.0))
    assert cross.deviations == pytest.approx((0.0015, 0.0004, 0.0))  # mm
    assert (read.apply.squareness, read.apply.scale, read.apply.backlash_from) == (
        {"XY": "Y"},
        ("X", "Y"),
        "positioning",
    )
    told = [
        finding.message.split(" has no effect")[0]
        for finding in read.findings
        if finding.code == "CW-J004"
    ]
    assert told == ["cross[0]", "apply.scale", "apply.squareness.XY"]  # Y is no axis of this job


def test_a_limit_of_the_smallest_radial_deviation_may_have_its_sign() -> None:
    """F min is mostly negative (ISO 230-4, figure 3: -0.006 mm); its size is limited."""
    text = """
        compwright: 1
        controller: {format: linuxcnc}
        axes: {X: {travel: [0, 800], before: []}}
        circles: [{file: c.csv, accept: {F_min_cw: -6, F_max_cw: 8}}]
        """
    assert job(text).circles[0].accept == Acceptance(limits={"F_min_cw": 6.0, "F_max_cw": 8.0})
    for wrong in ("F_min_cw: 0", "F_max_cw: -8"):
        (fault,) = faults_of(text.replace("F_min_cw: -6, F_max_cw: 8", wrong))
        assert "is too small; expected more than 0" in fault


def test_every_contributor_of_a_circle_has_its_unit_default_and_source() -> None:
    page = (PROJECT / "docs" / "job-keys.md").read_text(encoding="utf-8")
    for section, unit in (("rotary", "arcsec"), ("circular", "µm")):
        table = page.split(f"## `uncertainty.{section}`")[1].split("\n## ")[0]
        rows = [row.split("|")[3] for row in table.splitlines() if row.startswith("| `")]
        assert len(rows) >= 3
        assert all(f"Unit: {unit}. Default: `0`." in row for row in rows)


def test_page_and_schema_have_the_same_keys() -> None:
    from compwright.jobs import schema

    page = (PROJECT / "docs" / "job-keys.md").read_text(encoding="utf-8")
    words = set(re.findall(r"[A-Za-z_]+", " ".join(re.findall(r"`([^`\n]+)`", page))))
    sections = [
        s for s in vars(schema).values() if isinstance(s, type) and issubclass(s, schema.JobMapping)
    ]
    keys = {key for section in sections for key in section.model_fields}
    assert len(keys) > 50  # the sections were found at all
    assert keys - words == set()


@needs_shared
def test_example_of_the_contract_is_read() -> None:
    contract = (SHARED / "contract.md").read_text(encoding="utf-8")
    text = contract[
        contract.index("    compwright: 1  ") : contract.index("Required: `compwright`")
    ]
    text = textwrap.dedent(text).replace("[..]", "[0, 1]").replace("..", "x")
    read = job(text)
    # The page gives modulo for completeness; X is linear there, so it is told and left out.
    assert read.axes["X"].axis.modulo is None
    assert [finding.code for finding in read.findings].count("CW-J003") == 1
    assert read.axes["X"].axis.gantry == "AX5"
    assert read.axes["X"].before[0].position_map == PositionMap(1, -850.0)
    assert read.apply.squareness == {"XY": "Y"}
    assert [(one.code, one.axis) for one in read.acknowledged] == [("CW-T032", None)]
    assert read.circles[0].accept == Acceptance(limits={"G_bidirectional": 10.0})
    assert read.environment is not None
    assert read.environment.files == ("hall.csv",)


def test_an_axis_without_a_positioning_test_needs_a_circle() -> None:
    text = SMALLEST.replace("[runs/x.csv]", "[]")
    assert len(faults_of(text)) == 1
    assert job(text + "circles: [{file: xy.csv}]\n").axes["X"].before == ()


def test_a_language_needs_no_remark() -> None:
    read = job("""
        compwright: 1
        controller: {format: x}
        axes:
          X: {travel: [0, 1], before: x.csv, programmed: diameter, gantry: 2, axis_number: 1}
          B: {travel: [0, 360], before: b.csv, kind: rotary, modulo: 360, encoder: {type: absolute}}
        report: {language: fr}
        cross: [{input: X, output: B, positions: [0, 1], deviations: [0, 1], unit: arcsec}]
        """)
    assert read.findings == ()
    assert read.report.language == "fr"


@pytest.mark.parametrize(
    ("states", "expected"),
    [
        ("{as_found: none}", {"as_found": NONE_STATE}),
        ("{as_found: a.txt}", {"as_found": ("a.txt",)}),
        (
            "{as_found: [a.txt, b/c.txt], off: none}",
            {"as_found": ("a.txt", "b/c.txt"), "off": NONE_STATE},
        ),
    ],
)
def test_states(states: str, expected: dict[str, tuple[str, ...]]) -> None:
    assert job(SMALLEST + f"states: {states}\n").states == expected


def test_states_without_as_found_are_pointed_out() -> None:
    (finding,) = job(SMALLEST + "states: {as_foudn: none}\n").findings
    assert finding.code == "CW-J002"
    assert "as_foudn" in finding.message


@pytest.mark.parametrize(
    ("before", "names"),
    [
        ("runs/x.csv", ["x"]),
        ("[runs/x.csv, runs\\y.rtl]", ["x", "y"]),
        ("{files: a.b.csv}", ["a.b"]),
        ("[{files: [p/q.csv, r.csv]}, {files: [q.csv], name: second}]", ["q", "second"]),
        ("[{files: [q.csv], name: 7}]", ["7"]),
    ],
)
def test_names_of_tests(before: str, names: list[str]) -> None:
    read = job(SMALLEST.replace("[runs/x.csv]", before))
    assert [test.name for test in read.axes["X"].before] == names


def test_position_map_of_a_test_goes_over_that_of_the_axis() -> None:
    read = job("""
        compwright: 1
        controller: {format: x}
        axes:
          X:
            travel: [0, 1]
            position_map: {sense: -1, offset: 5}
            before: [a.csv, {files: [b.csv], position_map: {offset: 2}}]
        """)
    assert [test.position_map for test in read.axes["X"].before] == [
        PositionMap(-1, 5.0),
        PositionMap(1, 2.0),
    ]


def test_all_faults_stand_in_one_error_in_the_order_of_the_lines() -> None:
    faults = faults_of("""
        compwright: 1
        controller: {format: x, optoins: {}}
        axes:
          X:
            travel: [0, -850]
            before: [x.csv]
            kind: lineal
            kind: linear
            table: {spacing: 010}
        """)
    assert faults == [
        (
            "job.yaml: line 3, controller.optoins: unknown key; expected 'options', the nearest"
            " known name"
        ),
        (
            "job.yaml: line 6, axes.X.travel: ends are not in order; expected low < high, such"
            " as [-850, 0], found [0, -850]"
        ),
        (
            "job.yaml: line 8, axes.X.kind is not an accepted value; expected 'linear' or"
            " 'rotary', found 'lineal'"
        ),
        "job.yaml: line 9, axes.X.kind: key given twice (first on line 8)",
        (
            "job.yaml: line 10, axes.X.table.spacing is text, not a number (a leading zero is read"
            " as an octal number by some programs, write it without); expected a number, found"
            " '010'"
        ),
    ]


def test_everything_required_is_missed_at_once() -> None:
    assert [fault.split(";")[0] for fault in faults_of("machine: {name: a}")] == [
        "job.yaml: compwright is missing",
        "job.yaml: controller is missing",
        "job.yaml: axes is missing",
    ]
    faults = faults_of("compwright: 1\ncontroller: {}\naxes:\n  X: {}\n")
    assert [fault.split(";")[0] for fault in faults] == [
        "job.yaml: line 2, controller.format is missing",
        "job.yaml: line 4, axes.X.travel is missing",
        "job.yaml: line 4, axes.X.before is missing",
    ]


def test_newer_job_is_refused_alone() -> None:
    (fault,) = faults_of("compwright: 2\nsomething: new\naxes: later\n")
    assert "newer version" in fault
    assert fault.startswith("job.yaml: line 1, compwright")


@pytest.mark.parametrize("version", ["0", "-1", '"1"', "true", "1.0", "one"])
def test_other_versions_are_refused(version: str) -> None:
    assert any(
        re.search(r"\bcompwright[: ]", fault)
        for fault in faults_of(SMALLEST.replace("compwright: 1", f"compwright: {version}"))
    )


@pytest.mark.parametrize(
    ("keys", "place", "words"),
    [
        ("travel: [0]", "axes.X.travel", "at least 2"),
        ("travel: [0, 1, 2]", "axes.X.travel", "at most 2"),
        ("travel: [5, 5]", "axes.X.travel", "low < high"),
        ("travel: [0, 1:30]", "axes.X.travel[1]", "base 60"),
        ("travel: [0, .inf]", "axes.X.travel[1]", "finite"),
        ("travel: [0, 1e999]", "axes.X.travel[1]", "too large"),
        (f"travel: [0, {10**400}]", "axes.X.travel[1]", "too large"),
        ("travel: [0, 500 mm]", "axes.X.travel[1]", "unit is fixed"),
        ("travel: [0, true]", "axes.X.travel[1]", "found true"),
        ('reference: "0"', "axes.X.reference", "without quotes"),
        ("reference: 0,5", "axes.X.reference", "decimal point"),
        ("reference:", "axes.X.reference", "has no value"),
        ("reference_return: up", "axes.X.reference_return", "'+' or '-'"),
        ("kind: Linear", "axes.X.kind", "'linear' or 'rotary'"),
        ("address: 1.0", "axes.X.address", "quotes"),
        ("address: ' '", "axes.X.address", "blank"),
        ('address: "a\\0b"', "axes.X.address", "control characters"),
        ("axis_number: 0", "axes.X.axis_number", "1 or more"),
        ("axis_number: 1.5", "axes.X.axis_number", "whole number"),
        ("gantry: X", "axes.X.gantry", "the axis itself"),
        ("modulo: -360\nkind: rotary", "axes.X.modulo", "more than 0"),
        ("programmed: diameter\nkind: rotary", "axes.X.programmed", "linear"),
        ("position_map: {sense: 2}", "axes.X.position_map.sense", "1 or -1"),
        ("position_map: {sense: true}", "axes.X.position_map.sense", "found true"),
        ("encoder: {system: 3}", "axes.X.encoder.system", "1 or 2"),
        ("screw_pitch: 0", "axes.X.screw_pitch", "more than 0"),
        ("screw_pitch: [10, -5]", "axes.X.screw_pitch[1]", "more than 0"),
        ("screw_pitch: []", "axes.X.screw_pitch", "at least 1"),
        ("table: {start: 5, end: 5}", "axes.X.table", "start < end"),
        ("table: {spacing: 0}", "axes.X.table.spacing", "more than 0"),
        ("table: {spacing: automatic}", "axes.X.table.spacing", "a number"),
        ("table: {spacing: Auto}", "axes.X.table.spacing", "a number"),
        ("table: {spacing: [10]}", "axes.X.table.spacing", "a number"),
        ("table: {spacing: 0.001}", "axes.X.table.spacing", "100000 points"),  # 500 mm / 1 µm
        ("table: {mode: both}", "axes.X.table.mode", "bidirectional"),
        ("table: {goal: R}", "axes.X.table.goal", "'expected', 'A', 'E' or 'M'"),
        ("table: [1]", "axes.X.table", "a mapping"),
        ("before: []", "axes.X.before", "at least 1"),
        ("before: [{name: a}]", "axes.X.before[0].files", "missing"),
        ("before: {file: a.csv, files: b.csv}", "axes.X.before.file", "'files'"),
        ("before: [a/x.csv, b/x.csv]", "axes.X.before[1]", "name of another test"),
        ("before: [{files: [a.csv, a.csv]}]", "axes.X.before[0].files[1]", "twice"),
        ("before: [{files: [a.csv], measured_in: of}]", "axes.X.before[0].measured_in", "'off'"),
        ("accept: {AA: 8}", "axes.X.accept.AA", "'A'"),
        ("accept: {A: 0}", "axes.X.accept.A", "above 0"),
        ("accept: {A: '8'}", "axes.X.accept.A", "without quotes"),
        ("accept: {A: true}", "axes.X.accept.A", "above 0"),
        ("accept: {test: y, A: 8}", "axes.X.accept.test", "one of x"),
        ("accept: {test: x}", "axes.X.accept", "no limit"),
        ("accept: 8", "axes.X.accept", "a mapping"),
        ("traval: 1", "axes.X.traval", "'travel'"),
        ("options: {unit: .nan, big: 1e400}", "axes.X.options.big", "too large"),
    ],
)
def test_fault_of_an_axis_names_its_place(keys: str, place: str, words: str) -> None:
    (fault,) = axis_faults(keys)
    assert re.match(rf"job\.yaml: line \d+, {re.escape(place)}[: ]", fault), fault
    assert words in fault


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("machine: {serial: 1.10}", "machine.serial", "quotes"),
        ("states: {as_found: [none, a.txt]}", "states.as_found", "at once"),
        ("states: {as_found: []}", "states.as_found", "at least 1"),
        ("states: {as_found: ~}", "states.as_found", "no value"),
        ("states: {as_found: [a, a]}", "states.as_found[1]", "twice"),
        ("circles: [{name: a}]", "circles[0]", "which files"),
        ("circles: [{file: a, cw: b}]", "circles[0]", "which files"),
        ("circles: [{file: p/a.b5r}, {file: q/a.b5r}]", "circles[1]", "another circle"),
        ("circles: [{file: a, measured_in: x}]", "circles[0].measured_in", "no state"),
        ("circles: [{file: a, centre: [1]}]", "circles[0].centre", "at least 2"),
        (
            "cross: [{input: X, output: X, positions: [0, 1], deviations: [0, 1], unit: um}]",
            "cross[0].output",
            "another axis",
        ),
        (
            "cross: [{input: X, output: Y, positions: [0, 1], deviations: [0, 1, 2], unit: um}]",
            "cross[0].deviations",
            "match",
        ),
        (
            "cross: [{input: X, output: Y, positions: [0, 0], deviations: [0, 1], unit: um}]",
            "cross[0].positions",
            "twice",
        ),
        (
            "cross: [{input: X, output: Y, positions: [0, 1], deviations: [0, 1], unit: inch}]",
            "cross[0].unit",
            "'um'",
        ),
        (
            "cross: [{input: Y, output: X, positions: [0, 1], deviations: [0, 1], unit: deg}]",
            "cross[0].unit",
            "um or mm",
        ),
        (
            (
                "cross: [{input: X, output: Y, positions: [0, 1], deviations: [0, 1], unit: um,"
                " measured_in: a}]"
            ),
            "cross[0].measured_in",
            "no state",
        ),
        ("apply: {squareness: {XY: XY}}", "apply.squareness.XY", "of this plane"),
        ("apply: {squareness: {XY: Z}}", "apply.squareness.XY", "of this plane"),
        ("apply: {backlash_from: laser}", "apply.backlash_from", "positioning"),
        ("uncertainty: {device: {U: -1}}", "uncertainty.device.U", "0 or more"),
        ("thermal: {T_m: 22}", "thermal.alpha_m", "missing"),
        ("thermal: {T_m: 71, alpha_m: 11.5}", "thermal.T_m", "71 °F are 21.7 °C"),
        ("thermal: {T_m: 60.1, alpha_m: 11.5}", "thermal.T_m", "-20 to 60"),
        ("thermal: {T_m: -20.1, alpha_m: 11.5}", "thermal.T_m", "found -20.1"),
        ("thermal: {T_m: [22, 295], alpha_m: 11.5}", "thermal.T_m[1]", "295 K are 21.9 °C"),
        ("thermal: {T_m: 22, alpha_m: 11.5, T_d: 68}", "thermal.T_d", "68 °F are 20.0 °C"),
        ("thermal: {T_m: 22, alpha_m: 0.0000115}", "thermal.alpha_m", "steel has about 11.5"),
        ("thermal: {T_m: 22, alpha_m: -1}", "thermal.alpha_m", "0, or 0.01 to 40"),
        ("thermal: {T_m: 22, alpha_m: 11.5, alpha_d: 41}", "thermal.alpha_d", "0, or 0.01 to 40"),
        (
            "thermal: {T_m: 22, alpha_m: 11, refer_to: part}",
            "thermal.refer_to",
            "'scale' or 'workpiece'",
        ),
        ("decision_rule: strict", "decision_rule", "'simple' or 'guarded'"),
        ("proven: [{control: a, machine: b, date: c}]", "proven[0].how", "missing"),
        ("standard: iso230-2", "standard", "'iso230-2:2014'"),
        ("standard: iso230-4:2005", "standard", "'vdi3441'"),
        ("report: {language: it}", "report.language", "'en', 'de', 'fr' or 'ru'"),
        ("fixed_positions: {home: {Z: top}}", "fixed_positions.home.Z", "a number"),
    ],
)
def test_fault_at_the_top_names_its_place(text: str, place: str, words: str) -> None:
    (fault,) = faults_of(SMALLEST + text + "\n")
    assert re.match(rf"job\.yaml: line \d+, {re.escape(place)}[: ]", fault), fault
    assert words in fault


@pytest.mark.parametrize(
    ("standard", "parameter", "words"),
    [
        ("iso230-2:1988", "E", "not defined"),
        ("iso230-2:1988", "B", "not defined"),
        ("iso230-2:1988", "E_positiv", "expected 'R_positive', the nearest"),  # not E_positive
        ("vdi3441", "A", "not a parameter of vdi3441"),
    ],
)
def test_limits_follow_the_standard(standard: str, parameter: str, words: str) -> None:
    """1988 defines neither E nor M nor B = max|B_i|; VDI 3441 has names of its own."""
    text = (
        SMALLEST.replace("before:", f"accept: {{{parameter}: 5}}, before:")
        + f"standard: '{standard}'\n"
    )
    (fault,) = faults_of(text)
    assert words in fault


def test_limits_of_vdi() -> None:
    read = job(
        SMALLEST.replace("before:", "accept: {P: 5, Pa: 3.5}, before:") + "standard: vdi3441\n"
    )
    assert read.axes["X"].accept is not None
    assert read.axes["X"].accept.limits == {"P": 5.0, "Pa": 3.5}


def test_two_axes_cannot_share_an_address() -> None:
    text = SMALLEST + "  Y: {travel: [0, 1], before: y.csv, address: X}\n"
    (fault,) = faults_of(text)
    assert "axes.Y.address has the same address as axis X" in fault
    assert list(job(text.replace("address: X", "address: 2")).axes) == ["X", "Y"]


@pytest.mark.parametrize("name", ["../X", "X/Y", '"X\\nY"', "''", '" X"', "."])
def test_axis_name_cannot_lead_out_of_the_folder(name: str) -> None:
    assert any(
        "not a valid name for an axis" in fault
        for fault in faults_of(SMALLEST.replace("X:", f"{name}:"))
    )


@pytest.mark.parametrize(
    "content",
    [b"", b"\xff\xfe", b"a: [", b"- 1\n", b"text", b"a: &x 1\nb: *x", b"!!python/name:os.system x"],
)
def test_what_is_no_job_at_all_is_a_fault_of_the_job(content: bytes) -> None:
    with pytest.raises(UsageError) as caught:
        read_job(content, "job.yaml")
    assert all(fault.file == "job.yaml" for fault in caught.value.faults)


def test_defaults_of_thermal_and_uncertainty() -> None:
    """The contract: device without expansion (alpha_d 0), 20 °C, fixed point at 0, referred to the
    scale; U contributors 0.
    """
    read = job(SMALLEST + "thermal: {alpha_m: 11.5, T_m: 22}\nuncertainty: {E_VE: 2}\n")
    assert read.thermal == Thermal(
        alpha_m=11.5, T_m=22.0, alpha_d=0.0, T_d=20.0, x_fix=0.0, refer_to="scale"
    )
    assert read.uncertainty == UncertaintyBudget(
        device=0.0,
        device_per_m=0.0,
        misalignment_mm=0.0,
        U_theta=0.0,
        U_alpha=0.0,
        setup=0.0,
        E_VE=2.0,
    )


@pytest.mark.parametrize(
    "keys", ["thermal: {T_m: 71}", "before: [{files: x.csv, thermal: {T_m: 71}}]"]
)
def test_an_axis_and_a_test_are_not_measured_at_71_degrees_either(keys: str) -> None:
    faults = axis_faults(keys)
    assert any(
        re.search(r"line \d+, axes\.X\..*thermal\.T_m[: ]", fault) and "71 °F are 21.7 °C" in fault
        for fault in faults
    ), faults


def test_temperatures_and_expansions_at_the_ends_of_what_is_plausible_are_read() -> None:
    read = job(SMALLEST + "thermal: {alpha_m: 40, T_m: [-20, 60], alpha_d: 0.01}\n")
    assert read.thermal is not None
    assert (read.thermal.alpha_m, read.thermal.rise_m) == (40.0, 80.0)
