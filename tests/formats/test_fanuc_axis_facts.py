"""What a FANUC backup says of an axis beside its table: detection unit, lead of the screw, name; and
a new job from the real backup that runs without a question.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

from backup_files_fanuc import FOLDER, PARAMETERS, PITCH, Backup
from backup_jobs_fanuc import RUNS, axis_job, csv, dithered
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import ControlFile, ControlState
from format_samples import DEFINITIONS
from judge_fanuc import FACTOR, ROOM, acting, median_accuracy, quietly, reloaded
from virtual_fanuc import VirtualFanuc, loaded

pytestmark = pytest.mark.short_estimate

LINEAR, ROTARY = AxisKind.LINEAR, AxisKind.ROTARY
TABLE = {3620: "1", 3621: "1", 3622: "2", 3623: "1", 3624: "50.0", 1851: "3"}
POINTS = b"%\nN10001Q0P0\nN10002Q0P1\n%\n"


def read(
    values: dict[int, str],
    *,
    kind: AxisKind = LINEAR,
    pitch: tuple[float, ...] = (),
    unit: object = None,
) -> ControlState:
    """One axis of these parameters, as a job on it reads them."""
    said = {1006: "0000000" + "01"[kind is ROTARY], **TABLE, **values}
    if kind is ROTARY:
        said |= {3624: "180.0", 3622: "3", 1260: "360.0"}
    rows = "".join(f"N{number:05d}Q1A1P{value}\n" for number, value in sorted(said.items()))
    points = POINTS.replace(b"N10002Q0P1", b"N10002Q0P1\nN10003Q0P-1\nN10001Q0P-1")
    files = [
        ControlFile("CNC-PARA.TXT", f"%\n{rows}%\n".encode()),
        ControlFile(
            "PITCH.TXT", points.replace(b"N10001Q0P0\n", b"") if kind is ROTARY else POINTS
        ),
    ]
    axis = Axis(
        name="X",
        kind=kind,
        travel=(0.0, 360.0 if kind is ROTARY else 50.0),
        address="1",
        modulo=360.0 if kind is ROTARY else None,
        screw_pitch=pitch,
        options={} if unit is None else {"detection_unit": unit},
    )
    return control_format(DEFINITIONS["fanuc-30i"], {}).read(files, [axis])


@pytest.mark.parametrize(
    ("setting", "system", "expected"),
    [
        # B-63950EN/02 page 106, B-63943EN-1/02 page 109: 2 x CMR, from 101 on 100 + 1/CMR.
        ("2", "00000000", 1e-3),
        ("1", "00000000", 2e-3),
        ("3", "00000000", 1e-3 / 1.5),
        ("20", "00000000", 1e-4),
        ("96", "00000000", 1e-3 / 48),
        ("101", "00000000", 1e-3),
        ("102", "00000000", 2e-3),
        ("127", "00000000", 27e-3),
        ("2", "00000001", 1e-2),
        ("2", "00000010", 1e-4),
        ("102", "00000010", 2e-4),
    ],
)
def test_the_detection_unit_is_the_least_command_increment_over_cmr(
    setting: str, system: str, expected: float
) -> None:
    facts = read({1820: setting, 1013: system}).facts["1"]
    assert facts.stated["detection_unit"] == pytest.approx(expected, rel=1e-12)
    assert f"1820 = {setting}" in facts.unit_evidence


@pytest.mark.parametrize(
    ("number", "more"), [(1001, {1001: "1"}), (1800, {1800: "16", 1852: "5"}), (1013, {1013: "2"})]
)
def test_bits_in_another_form_are_refused_where_the_table_depends_on_them(
    number: int, more: dict[int, str]
) -> None:
    """Inch or metric, backlash at rapid traverse, increment system: 1001#0, 1800#4, 1013."""
    with pytest.raises(InputError, match=f"{number}#[0-9] cannot be read"):
        read(more, unit=0.001)
    read({number: "0"}, unit=0.001)  # all bits are 0


@pytest.mark.parametrize(
    ("setting", "system"),
    [
        ("0", "00000000"),
        ("97", "00000000"),
        ("100", "00000000"),
        ("128", "00000000"),
        ("-2", "00000000"),
        ("2", "00000100"),
        ("2", "00001000"),
        ("2", "00000011"),
    ],
)
def test_a_coding_that_no_page_explains_is_asked_for_by_its_parameter(
    setting: str, system: str
) -> None:
    named = "1820" if system == "00000000" else "1013"
    with pytest.raises(UsageError, match=f"parameter {named} of axis 1"):
        read({1820: setting, 1013: system})
    state = read({1820: setting, 1013: system}, unit=0.001)
    assert state.axes["1"].backlash == pytest.approx(0.003)


@pytest.mark.parametrize(
    ("values", "kind", "expected"),
    [
        # 1821 in detection units is the grid interval: a turn of the motor (same pages).
        ({1820: "20", 1821: "100000", 1815: "00110000"}, LINEAR, 10.0),
        ({1820: "2", 1821: "6000", 1815: "00000000"}, LINEAR, 6.0),
        ({1820: "2", 1821: "5000", 1815: "00000000", 1001: "00000001"}, LINEAR, 12.7),
        ({1820: "2", 1821: "2000", 1815: "00110000"}, ROTARY, 2.0),
        # a separate detector: the distance of the marks of a scale
        ({1820: "20", 1821: "100000", 1815: "00110010"}, LINEAR, None),
        # nobody says which
        ({1820: "20", 1821: "100000"}, LINEAR, None),
        ({1820: "20", 1821: "0", 1815: "00110000"}, LINEAR, None),
        ({1821: "100000", 1815: "00110000"}, LINEAR, None),
        # an encoder on the table itself has its mark once a turn
        ({1820: "2", 1821: "360000", 1815: "00110000"}, ROTARY, None),
    ],
)
def test_the_lead_of_the_screw_by_the_reference_counter(
    values: dict[int, str], kind: AxisKind, expected: float | None
) -> None:
    values = {1013: "00000000", **values}
    state = read(values, kind=kind, unit=None if 1820 in values else 0.001)
    assert state.facts["1"].lead == (None if expected is None else pytest.approx(expected))
    told = [finding for finding in state.findings if finding.code == "CW-S049"]
    assert [finding.severity for finding in told] == ["info"] * (expected is not None)
    for finding in told:
        assert f"screw_pitch: {expected:g}" in finding.message
        assert "inferred" in finding.message
        assert values[1821] in finding.message


@pytest.mark.parametrize(
    ("pitch", "severity"),
    [((10.0,), ""), ((2.0, 10.0), ""), ((10.005,), ""), ((5.0,), "warning"), ((10.2,), "warning")],
)
def test_a_job_that_names_another_lead_gets_a_remark(
    pitch: tuple[float, ...], severity: str
) -> None:
    values = {1013: "00000000", 1820: "20", 1821: "100000", 1815: "00110000"}
    told = [each for each in read(values, pitch=pitch).findings if each.code == "CW-S049"]
    assert [each.severity for each in told] == [severity] * bool(severity)
    if told:
        assert f"gives {', '.join(f'{one:g}' for one in pitch)} instead" in told[0].message


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({1020: "88"}, "X"),
        ({1020: "88", 1025: "0", 1026: "0"}, "X"),
        ({1020: "88", 1025: "49", 1026: "0"}, "X1"),
        ({1020: "88", 1025: "65", 1026: "50"}, "XA2"),
        ({1020: "0"}, None),
    ],
)
def test_the_name_of_an_axis_has_up_to_three_characters(
    values: dict[int, str], expected: str | None
) -> None:
    assert read(values, unit=0.001).facts["1"].name == expected


# --- the real backup
# --------------------------------------------------------------------------------------------------

needs_backup = pytest.mark.skipif(
    not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
)


def new_draft(folder: Path) -> str:
    for name, content in Backup.real().files().items():
        (folder / name).write_bytes(content)
    words = ["--from", str(folder / PARAMETERS), "--from", str(folder / PITCH)]
    job = folder / "job.yaml"
    said = quietly(["new", *words, "--format", "fanuc-30i", "--out", str(job)])
    assert said[0] == 0, said
    return job.read_text()


@needs_backup
def test_new_writes_what_the_real_backup_says(tmp_path: Path) -> None:
    """Every figure by hand from the lines of the backup."""
    text = new_draft(tmp_path)
    draft = yaml.safe_load(text)
    assert draft["controller"] == {"format": "fanuc-30i"}
    shared = {"reference": 0.0, "reference_return": "+", "encoder": {"type": "absolute"}}
    linear = {
        **shared,
        "kind": "linear",
        "programmed": "radius",
        "screw_pitch": 10.0,  # 1821 = 100000 detection units of 0.0001 mm
        "options": {"detection_unit": 0.0001},
        "before": None,
    }
    assert draft["axes"] == {
        "X": {**linear, "travel": [-1000.0, 1.0], "address": "1"},
        "Y": {**linear, "travel": [-1101.0, 1.0], "address": "2"},
        "Z": {**linear, "travel": [-781.0, 30.0], "address": "3"},
        "B": {
            **shared,  # 1815 = 00110010: a separate detector, so no lead
            "kind": "rotary",
            "travel": [0.0, 360.0],
            "modulo": 360.0,
            "address": "4",
            "options": {"detection_unit": 0.0001},
            "before": None,
        },
    }
    told = [line for line in text.splitlines() if "detection_unit" in line]
    assert len(told) == 4
    assert all("read from the control's files: 1820 = 20" in line for line in told)
    offered = [line for line in text.splitlines() if "screw_pitch" in line]
    assert len(offered) == 3
    assert all("offered: 1821 = 100000" in line and "inferred" in line for line in offered)


@needs_backup
def test_a_new_job_of_the_real_backup_runs_without_a_question(tmp_path: Path) -> None:
    """Tests and limits filled in for all four axes: every table is written and keeps its promise."""
    draft = yaml.safe_load(new_draft(tmp_path))
    rng = np.random.default_rng(12)
    files = Backup.real().files()
    before = VirtualFanuc(loaded(files.values()))
    axes = {axis.name: axis for axis in (axis_job(rng, number) for number in (1, 2, 3, 4))}
    for name, axis in axes.items():
        low, high = draft["axes"][name]["travel"]
        assert low <= axis.travel[0] < axis.travel[1] <= high
        places = dithered(rng, axis.measured, axis.targets)
        readings = axis.physics.read(rng, places, acting(before, axis))
        assert all(each.shape == (places.size, RUNS) for each in readings.values())
        (tmp_path / f"{name}.csv").write_text(csv(name, axis.rotary, places, readings))
        draft["axes"][name]["before"] = [f"{name}.csv"]
        if not axis.rotary:
            draft["axes"][name]["travel"] = list(axis.travel)
    (tmp_path / "job.yaml").write_text(yaml.safe_dump(draft))
    code, said, _ = quietly(["run", str(tmp_path / "job.yaml"), "--out", str(tmp_path / "out")])
    assert code == 0, said
    facts = {
        each["fact"]: each["evidence"]
        for each in json.loads((tmp_path / "out" / "plan.json").read_text())["assumed"]
    }
    assert "option detection_unit" not in facts
    assert "1820 = 20" in facts["axis 1: detection unit"]
    after = VirtualFanuc(reloaded(files, tmp_path / "out" / "tables" / "fanuc-30i"))
    prediction = json.loads((tmp_path / "out" / "prediction.json").read_text())
    for name, axis in axes.items():
        promised = prediction["axes"][name]["predicted_new_targets"]["A"]["median"]
        old, new = (median_accuracy(axis, acting(one, axis), rng) for one in (before, after))
        assert new < old, name
        assert new <= FACTOR * promised + ROOM, name
        # Numbers and interval stay, those of B too: 301 to 312 behind the reference's 300.
        kept, now = before.grid(axis.address), after.grid(axis.address)
        assert replace(now, magnification=kept.magnification) == kept, name


@pytest.mark.parametrize(
    ("name", "codes", "said"),
    [
        ("X", "A1P88A2P89", "1"),  # 88, 89: the codes of X and Y
        ("Y", "A1P88A2P89", "2"),
        ("Z", "A1P88A2P89", None),
        ("X", "A1P88A2P88", None),  # two axes of one letter tell nothing
    ],
)
def test_an_axis_is_found_by_the_letter_that_the_files_give_it(
    name: str, codes: str, said: str | None, tmp_path: Path
) -> None:
    rows = "".join(
        f"N{number:05d}Q1A1P{value}A2P{value if number == 1851 else 0}\n"
        for number, value in sorted(TABLE.items())
    )
    (tmp_path / "P.TXT").write_text(
        f"%\nN01020Q1{codes}\n{rows}%\n", encoding="ascii", newline="\n"
    )
    (tmp_path / "PITCH.TXT").write_bytes(POINTS)
    targets = np.linspace(2.0, 48.0, 6)
    error = {d: np.tile(0.004 * targets / 50.0, (3, 1)) for d in (1, -1)}
    noise = np.random.default_rng(1)
    rows_of_test = "".join(
        f"{x:g},{'+-'[d < 0]},{run + 1},{1e3 * e[run, i] + 0.2 * noise.standard_normal():.3f}\n"
        for d, e in error.items()
        for run in range(3)
        for i, x in enumerate(targets)
    )
    (tmp_path / "t.csv").write_text(
        f"target_mm,direction,run,deviation_um\n{rows_of_test}", encoding="ascii"
    )
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: fanuc-30i, options: {detection_unit: 0.001, first_point: 9}}\n"
        "states: {as_found: [P.TXT, PITCH.TXT]}\n"
        f"axes: {{{name!r}: {{travel: [0, 50], before: [t.csv]}}}}\n",
        encoding="ascii",
    )
    code, words, shown = quietly(["run", str(tmp_path / "job.yaml")])
    if said is None:
        assert code == 2
        assert "--option address" in words
    else:
        assert code in (0, 1), words  # axis 2 has no table of its own, and may get one
        assert f"address of axis {name}" in shown
        assert f"1020 of axis {said}" in shown


#: A rotary axis as a real backup has it: reference 300, first 301, last 312.
OF_REAL_BACKUP = {3620: "300", 3621: "301", 3622: "312", 3624: "30.0"}


@pytest.mark.parametrize(
    ("kind", "modulo", "unit", "step"),
    [
        (LINEAR, None, None, "set `kind: rotary` for the axis in the job"),
        (ROTARY, None, None, "set `modulo: 360` for the axis in the job"),
        (ROTARY, 180.0, None, "set `modulo: 360` for the axis in the job"),
        (ROTARY, 360.0, 0.01, "delete the option `detection_unit`"),
    ],
)
def test_a_job_that_the_control_contradicts_is_corrected_and_not_the_control(
    kind: AxisKind, modulo: float | None, unit: float | None, step: str
) -> None:
    """Each of these sent the reader to change a parameter that is right."""
    said = {**TABLE, **OF_REAL_BACKUP, 1006: "00000001", 1013: "00000000", 1820: "2"}
    rows = "".join(f"N{number:05d}Q1A1P{value}\n" for number, value in sorted(said.items()))
    points = "".join(f"N{10000 + number}Q0P0\n" for number in range(300, 313))
    files = [
        ControlFile("CNC-PARA.TXT", f"%\n{rows}N01260Q1A1P360.0\n%\n".encode()),
        ControlFile("PITCH.TXT", f"%\n{points}%\n".encode()),
    ]
    axis = Axis(
        name="B",
        kind=kind,
        travel=(0.0, modulo or 360.0),
        address="1",
        modulo=modulo,
        options={} if unit is None else {"detection_unit": unit},
    )
    with pytest.raises(InputError) as refused:
        control_format(DEFINITIONS["fanuc-30i"], {}).read(files, [axis])
    assert step in str(refused.value)
    assert "in the control, measure" not in str(refused.value)


def test_a_control_of_totals_is_left_as_it_is() -> None:
    with pytest.raises(InputError, match="Next: leave the axis out of the job; never change 3602"):
        read({3602: "00000001"}, unit=0.001)
