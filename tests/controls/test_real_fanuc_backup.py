"""Jobs on variations of a real FANUC backup, judged by a virtual control that shares no line with
the package.

Every run either refuses by name or leaves the axis as good as it said, and no entry of anybody else
differs. Where the real backup is not beside the project all but the judge's own tests are skipped.
"""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

from backup_deal_fanuc import ROUND, deal, make
from backup_files_fanuc import FOLDER, PARAMETERS, PITCH, Backup, Table
from backup_jobs_fanuc import AxisJob, Job, Physics, axis_job
from judge_fanuc import Outcome, Played, judge, play, quietly, run_job
from virtual_fanuc import Floats, NotKnownError, VirtualFanuc, accuracy, loaded

pytestmark = pytest.mark.short_estimate

needs_backup = pytest.mark.skipif(
    not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
)
UM = 1e-3


def good(outcome: Outcome) -> None:
    assert outcome.faults == [], str(outcome)


# --- random jobs
# --------------------------------------------------------------------------------------------------

SHARES = 3
#: Every family once, but those that a named case below, another module or a family next to it plays
#: anyway; benchmarks/bench_backups_fanuc.py plays hundreds.
NAMED = {
    "cyclic",
    "detection_unit_contradicts",
    "detection_units",
    "endless_two_turns",
    "inch",
    "inch_letter",
    "inclination",
    "inclination_points_here",
    "never_compensated",
    "odd_neighbour",
    "older_parameters_alone",
    "other_letter",
    "parameters_alone_asleep",
    "rotary_without_wrap",
    "scarce",
    "second_path",
    "state_none_without_first_point",
    "straightness",
    "straightness_further",
    "totals",
    "wraps_by_file_only",
    "wraps_by_job_only",
}
DEALT = [(name, seed) for name, seed in deal(ROUND) if seed == 0 and name not in NAMED]


@needs_backup
@pytest.mark.parametrize("share", range(SHARES))
def test_no_random_job_does_harm(share: int, tmp_path: Path) -> None:
    dealt = DEALT[share::SHARES]
    outcomes = [play(make(name, seed), tmp_path / f"{name}-{seed}") for name, seed in dealt]
    faulty = [str(outcome) for outcome in outcomes if outcome.faults]
    assert not faulty, "\n".join(faulty)


@needs_backup
def test_most_of_the_jobs_must_be_written() -> None:
    """A plain one that is not written is a fault: at least every second job has to be such a
    one.
    """
    marks = [make(name, seed).mark for name, seed in deal(ROUND)]
    assert marks.count("plain") >= 0.5 * len(marks)


# --- the named cases
# --------------------------------------------------------------------------------------------------


@needs_backup
@pytest.mark.parametrize(
    ("name", "seed"), [("parameters_alone_asleep", 100), ("older_parameters_alone", 100)]
)
def test_1_parameters_above_10000_are_no_pitch_data(name: str, seed: int, tmp_path: Path) -> None:
    good(play(make(name, seed, whole=True), tmp_path))


@needs_backup
def test_1_compare_does_not_take_parameters_for_the_plans_table(tmp_path: Path) -> None:
    """Neither the parameters of the patched backup alone nor the backup as it was hold the plan's
    table.
    """
    played = run_job(make("as_it_is", 100), tmp_path)
    assert judge(played).written
    plan, new = (
        str(played.out / "plan.json"),
        [str(played.tables / name) for name in (PARAMETERS, PITCH)],
    )
    assert quietly(["compare", plan, "--loaded", new[0], "--loaded", new[1]])[0] == 0
    assert (
        quietly(
            [
                "compare",
                plan,
                "--loaded",
                str(tmp_path / PARAMETERS),
                "--loaded",
                str(tmp_path / PITCH),
            ]
        )[0]
        == 1
    )
    assert quietly(["compare", plan, "--loaded", new[0]])[0] in (1, 3)


@needs_backup
@pytest.mark.parametrize(
    "name",
    [
        "inclination",
        "inclination_points_here",
        "straightness",
        "cyclic",
        "totals",
        "scarce",
        "never_compensated",
    ],
)
def test_2_what_acts_beside_the_table_is_honoured_or_refused_by_name(
    name: str, tmp_path: Path
) -> None:
    good(play(make(name, 100), tmp_path))


@needs_backup
def test_2_state_none_asks_for_the_first_number(tmp_path: Path) -> None:
    outcome = play(make("state_none_without_first_point", 100), tmp_path)
    good(outcome)
    assert outcome.code == 2


@needs_backup
def test_2_further_axes_follow_on(tmp_path: Path) -> None:
    """Two axes from one first number: both tables lie above it and apart, which the judge demands
    of every table.
    """
    rng = np.random.default_rng(5)
    job = make("state_none", 100)
    axes = (axis_job(rng, 1), axis_job(rng, 3))
    outcome = play(
        replace(job, axes=axes, options={"detection_unit": "0.0001", "first_point": "70"}), tmp_path
    )
    good(outcome)
    assert outcome.written == ["X", "Z"]


@needs_backup
def test_3_a_detection_unit_against_the_files_is_refused(tmp_path: Path) -> None:
    outcome = play(make("detection_unit_contradicts", 100), tmp_path)
    good(outcome)
    assert outcome.code == 3


@needs_backup
def test_3_the_detection_unit_is_read_from_the_files(tmp_path: Path) -> None:
    good(play(make("detection_units", 100), tmp_path))


def new_job(folder: Path, axis: AxisJob) -> str:
    """What ``new`` makes of the files in ``folder``, with one axis and its test filled in."""
    said = quietly(
        [
            "new",
            "--from",
            str(folder / PARAMETERS),
            "--from",
            str(folder / PITCH),
            "--format",
            "fanuc-30i",
            "--out",
            str(folder / "new.yaml"),
        ]
    )
    assert said[0] == 0, said
    text = yaml.safe_load((folder / "new.yaml").read_text())
    text["axes"] = {axis.name: text["axes"][axis.name] | {"before": [f"{axis.name}.csv"]}}
    return str(yaml.safe_dump(text))


@needs_backup
def test_4_new_writes_one_turn_of_the_endless_axis(tmp_path: Path) -> None:
    job = make("filled", 0)
    job = replace(job, files=Backup.real().files(), axes=(axis_job(np.random.default_rng(3), 4),))
    for name, given in (job.files or {}).items():
        (tmp_path / name).write_bytes(given)
    text = new_job(tmp_path, job.axes[0])
    assert yaml.safe_load(text)["axes"]["B"]["travel"] == [0, 360]
    good(play(job, tmp_path / "run", text=text))


@needs_backup
def test_4_a_travel_of_two_turns_measured_over_one(tmp_path: Path) -> None:
    good(play(make("endless_two_turns", 100), tmp_path))


@needs_backup
@pytest.mark.parametrize("address", [1, 4])
def test_4_a_travel_of_which_less_than_half_is_measured_is_refused(
    address: int, tmp_path: Path
) -> None:
    axis = axis_job(np.random.default_rng(4), address)
    low, high = axis.travel
    part = (low, low + 0.4 * (high - low))
    job = replace(
        make("as_it_is", 0),
        mark="refuse",
        names=("travel", "half", "cover"),
        axes=(replace(axis, true_travel=part),),
    )
    outcome = play(replace(job, files=Backup.real().files()), tmp_path)
    good(outcome)
    assert outcome.code in (2, 3)


@needs_backup
def test_5_the_backup_as_it_is_takes_tables_of_all_axes(tmp_path: Path) -> None:
    """B has 3621 = 3620 + 1; an automatic grid keeps 24000/7500 mm and leaves numbers for the
    others.
    """
    rng = np.random.default_rng(6)
    job = replace(make("as_it_is", 0), names=(), axes=tuple(axis_job(rng, n) for n in (1, 2, 3, 4)))
    outcome = play(job, tmp_path)
    assert outcome.written == ["X", "Y", "Z", "B"]
    good(outcome)


@needs_backup
@pytest.mark.parametrize("seed", range(100, 104))
def test_5_an_odd_neighbour_stops_nothing(seed: int, tmp_path: Path) -> None:
    good(play(make("odd_neighbour", seed), tmp_path))


@needs_backup
@pytest.mark.parametrize("name", ["inch", "inch_letter", "other_letter"])
def test_5_the_letter_of_an_interval_stays(name: str, tmp_path: Path) -> None:
    good(play(make(name, 100), tmp_path))


@needs_backup
@pytest.mark.parametrize(
    ("name", "seed"),
    [
        ("wraps_by_file_only", 100),
        ("wraps_by_job_only", 100),
        ("rotary_without_wrap", 100),
        ("second_path", 100),  # 1852 of the first path alone
        ("second_path", 101),  # and of that of the axis
    ],
)
def test_6_wrap_and_rapid_backlash_are_honoured_or_refused(
    name: str, seed: int, tmp_path: Path
) -> None:
    good(play(make(name, seed), tmp_path))


# --- the judge notices
# --------------------------------------------------------------------------------------------------


def curved(mode: str) -> Job:
    """X on a grid of 20 mm with an error so curved, and so much lost motion, that a wrong sign or
    half a section shows.
    """
    physics = Physics((-1000.0, 0.0), ((60.0, 400.0, 0.3),), 0.0, 12.0, 0.3)
    words = {"table": f"{{start: -1000, end: 0, spacing: 20, mode: {mode}}}"}
    axis = AxisJob("X", 1, physics.travel, physics, 40, words=words)
    files = Backup.real().set(3621, "A4", 300).files()
    return replace(
        make("as_it_is", 0),
        names=(),
        axes=(axis,),
        files=files,
        options={"detection_unit": "0.0001"},
    )


@pytest.fixture(scope="module")
def single(tmp_path_factory: pytest.TempPathFactory) -> Played:
    return run_job(curved("single"), tmp_path_factory.mktemp("single"))


@pytest.fixture(scope="module")
def bidirectional(tmp_path_factory: pytest.TempPathFactory) -> Played:
    return run_job(curved("bidirectional"), tmp_path_factory.mktemp("bidirectional"))


@needs_backup
@pytest.mark.parametrize(
    "turned",
    [
        {"pitch_sign": -1},
        {"backlash_sign": -1},
        {"unit_factor": 2.0},
        {"unit_factor": 0.1},
        {"half_section": 0.5},
        {"half_section": -0.5},
    ],
    ids=str,
)
def test_a_judge_with_a_wrong_sign_unit_or_section_finds_harm(
    single: Played, turned: dict[str, float]
) -> None:
    good(judge(single))
    assert any(
        "HARM" in fault
        for fault in judge(
            single,
            lambda control: replace(control, **turned),  # type: ignore[arg-type]
        ).faults
    )


@needs_backup
@pytest.mark.parametrize("turned", [{"pitch_sign": -1}, {"offset_sign": -1}], ids=str)
def test_a_judge_with_a_wrong_second_set_finds_harm(
    bidirectional: Played, turned: dict[str, int]
) -> None:
    good(judge(bidirectional))
    assert any(
        "HARM" in fault
        for fault in judge(
            bidirectional,
            lambda control: replace(control, **turned),  # type: ignore[arg-type]
        ).faults
    )


def at(number: bytes, pattern: bytes, new: bytes) -> Callable[[bytes], bytes]:
    return lambda text: re.sub(
        rb"(?m)^N" + number + rb".*$", lambda line: re.sub(pattern, new, line[0], count=1), text
    )


@needs_backup
@pytest.mark.parametrize(
    ("name", "change", "fault"),
    [
        (PARAMETERS, at(b"03623", rb"A2P10", b"A2P9"), "FOREIGN parameters"),
        (PARAMETERS, at(b"01820", rb"A1P20", b"A1P2"), "FOREIGN parameters"),
        (PARAMETERS, at(b"03605", rb"A1P0000001", b"A1P0000000"), "bits of others"),
        (PARAMETERS, at(b"03624", rb"A1P", b"A1M"), "more than values"),
        (PARAMETERS, at(b"10342", rb"P0", b"P1"), "as if it were pitch data"),
        (PARAMETERS, lambda text: text.replace(b"\n", b"\n\n", 1), "lines became"),
        (PARAMETERS, at(b"03620", rb"A1P", b"A1P1"), "3621 <= 3620 <= 3622"),
        (PITCH, at(b"10201", rb"P-1", b"P-2"), "FOREIGN pitch data"),
    ],
)
def test_a_judge_sees_what_else_was_changed(
    single: Played, name: str, change: Callable[[bytes], bytes], fault: str, tmp_path: Path
) -> None:
    shutil.copytree(single.out, tmp_path / "out")
    spoilt = replace(single, out=tmp_path / "out")
    path = spoilt.tables / name
    assert change(path.read_bytes()) != path.read_bytes()
    path.write_bytes(change(path.read_bytes()))
    assert any(fault in found for found in judge(spoilt).faults)


@needs_backup
def test_a_judge_sees_a_lost_way_back_and_a_refusal(single: Played, tmp_path: Path) -> None:
    shutil.copytree(single.out, tmp_path / "out")
    (tmp_path / "out" / "rollback" / "fanuc-30i" / PITCH).unlink()
    assert any("rollback" in fault for fault in judge(replace(single, out=tmp_path / "out")).faults)
    assert any(
        "WRONG REFUSAL" in fault
        for fault in judge(replace(single, out=tmp_path / "nothing", code=3)).faults
    )
    assert any(
        "EXIT" in fault
        for fault in judge(replace(single, out=tmp_path / "nothing", code=70)).faults
    )
    assert any("yet there are tables" in fault for fault in judge(replace(single, code=3)).faults)


# --- the virtual control against the pages
# ------------------------------------------------------------------------------------

#: The complete example of the facts page, section A6, with CMR 1 on IS-B for its detection unit of
#: 1 um.
EXAMPLE = b"""%
N01013Q1A1P00000000A2P00000000A3P00000000
N01820Q1A1P2A2P2A3P2
N01851Q1A1P4A2P0A3P6
N03605Q1A1P00000000A2P00000000A3P00000000
N03620Q1A1P40A2P0A3P0
N03621Q1A1P37A2P0A3P0
N03622Q1A1P44A2P0A3P0
N03623Q1A1P1A2P0A3P0
N03624Q1A1M50.0A2M0.0A3M0.0
N10037Q1P99
N10037Q0P1
N10038Q0P0
N10039Q0P-2
N10040Q0P1
N10041Q0P2
N10042Q0P1
N10043Q0P0
N10044Q0P-1
%
"""
NODES = np.arange(-200.0, 201.0, 50.0)
TOTALS = np.array([0, 1, 1, -1, 0, 2, 3, 3, 2]) * UM


def near(found: Floats, expected: Floats | float) -> bool:
    return bool(np.allclose(found, expected, rtol=0, atol=1e-9))


def test_the_example_of_the_page_has_its_totals() -> None:
    control = VirtualFanuc(loaded([EXAMPLE]))
    assert near(control.correction(1, NODES, 1), TOTALS)
    assert near(control.correction(1, NODES, -1), TOTALS - 4 * UM)
    assert near(control.correction(1, NODES, -1, home=-1), TOTALS)
    assert near(control.correction(1, NODES, 1, home=-1), TOTALS + 4 * UM)
    assert near(control.correction(3, NODES, -1), -6 * UM)
    assert near(control.correction(1, np.array([-900.0, 900.0]), 1), TOTALS[[0, -1]])


def test_pulses_come_in_the_middle_of_a_section_or_as_a_ramp() -> None:
    x = np.array([20.0, 24.9, 25.1, 50.0])
    assert near(VirtualFanuc(loaded([EXAMPLE])).correction(1, x, 1), np.array([0, 0, 2, 2]) * UM)
    assert near(
        VirtualFanuc(loaded([EXAMPLE]), output="ramp").correction(
            1, np.array([10.0, 25.0, 50.0]), 1
        ),
        np.array([0.4, 1, 2]) * UM,
    )


def test_magnification_unit_and_letters() -> None:
    def changed(*pairs: tuple[bytes, bytes]) -> Floats:
        text = EXAMPLE
        for old, new in pairs:
            assert old in text
            text = text.replace(old, new)
        return VirtualFanuc(loaded([text])).correction(1, NODES, 1)

    assert near(changed((b"3Q1A1P1A", b"3Q1A1P5A")), 5 * TOTALS)
    assert near(changed((b"3Q1A1P1A", b"3Q1A1P0A")), 0.0)
    assert near(changed((b"0Q1A1P2A", b"0Q1A1P20A")), 0.1 * TOTALS)
    assert near(changed((b"N01013Q1A1P00000000", b"N01013Q1A1P00000010")), 0.1 * TOTALS)
    inches = changed((b"M50.0", b"I50.0"))
    assert near(inches[[3, 4, 5]], 0.0)  # sections of 1270 mm: no middle is passed within 200 mm


def test_two_sets_hang_on_3627() -> None:
    """The sample of the page: reference 23, numbers 20 to 27, second set from 30, interval 10.000,
    3627 = -4.
    """
    text = (
        EXAMPLE.replace(b"0Q1A1P40A", b"0Q1A1P23A")
        .replace(b"1Q1A1P37A", b"1Q1A1P20A")
        .replace(b"2Q1A1P44A", b"2Q1A1P27A")
    )
    text = (
        text.replace(b"N03605Q1A1P00000000", b"N03605Q1A1P00000001")
        .replace(b"M50.0", b"M10.0")
        .replace(b"1Q1A1P4A", b"1Q1A1P0A")
    )
    points = {**dict.fromkeys(range(20, 38), 0), 24: 2, 34: 5, 33: 1}
    records = b"".join(b"N%dQ0P%d\n" % (10000 + n, value) for n, value in points.items())
    control = VirtualFanuc(loaded([text, b"%\nN03626Q1A1P30\nN03627Q1A1P-4\n" + records + b"%\n"]))
    x = np.array([-10.0, 0.0, 10.0])
    assert near(control.correction(1, x, 1), np.array([0, 0, 2]) * UM)
    assert near(control.correction(1, x, -1), np.array([-5, -4, 1]) * UM)


def test_a_turn_repeats_and_must_close() -> None:
    """Reference 60, 45 degrees, last number 68 (section A2)."""
    rotary = b"%\nN01006Q1A1P00000001\nN01820Q1A1P2\nN03620Q1A1P60\nN03621Q1A1P60\nN03622Q1A1P68\nN03623Q1A1P1\nN03624Q1A1P45.0\n"
    points = [1, -2, 3, 0, 0, 1, -4, 1]
    records = (
        b"".join(b"N%dQ0P%d\n" % (10061 + n, value) for n, value in enumerate(points))
        + b"N10060Q0P1\n"
    )
    control = VirtualFanuc(loaded([rotary + records]))
    x = np.array([44.0, 89.0, 359.0, 44.0 - 360, 404.0])
    assert near(control.correction(1, x, 1), np.array([1, -1, 0, 1, 1]) * UM)
    with pytest.raises(NotKnownError, match="creeps"):
        VirtualFanuc(loaded([rotary + records + b"N10068Q0P2\n"])).correction(1, x, 1)


def test_files_without_q() -> None:
    """A file of pitch records alone is pitch data; among parameters N1nnnn is a parameter (the page
    on real backups).
    """
    registers = loaded([b"%\nN3620A1P40A2P0\nN10342P7\n%", b"%\nN10037P1\nN10038 P -2\n%"])
    assert registers.pitch == {37: "1", 38: "-2"}
    assert registers.parameters[10342, ""].text == "7"


def test_rapid_backlash_is_asked_of_the_axis_own_path() -> None:
    text = b"%\nN00981Q1A1P1A2P2\nN01820Q1A1P2A2P2\nN01800Q1L1P00000000L2P00010000\nN01851Q1A1P4A2P4\nN01852Q1A1P9A2P9\n%"
    control = VirtualFanuc(loaded([text]))
    zero = np.zeros(1)
    assert near(control.correction(1, zero, -1, rapid=True), -4 * UM)
    assert near(control.correction(2, zero, -1, rapid=True), -9 * UM)
    assert near(control.correction(2, zero, -1), -4 * UM)


def test_inclination_straightness_and_the_cyclic_table() -> None:
    lines = b"%\nN05861Q1A1P37\nN05862Q1A1P40\nN05863Q1A1P42\nN05864Q1A1P44\nN05871Q1A1P-3\nN05872Q1A1P0\nN05873Q1A1P0\nN05874Q1A1P8\n%"
    control = VirtualFanuc(loaded([EXAMPLE, lines]))
    assert near(
        control.correction(1, NODES, 1) - TOTALS, np.array([-3, -3, -2, -1, 0, 0, 0, 4, 8]) * UM
    )
    straight = (
        lines.replace(b"N0586", b"N0573").replace(b"N0587", b"N0576").replace(b"A1", b"L1")
        + b"\nN05711Q1L1P1\nN05721Q1L1P2\n"
    )
    control = VirtualFanuc(loaded([EXAMPLE, straight]))
    assert near(control.straightness(1, NODES)[2], np.array([-3, -3, -2, -1, 0, 0, 0, 4, 8]) * UM)
    cyclic = (
        b"%\nN14985Q1A1P100\nN14986Q1A1P102\nN14987Q1A1P4.0\nN10100Q0P0\nN10101Q0P2\nN10102Q0P-2\n%"
    )
    control = VirtualFanuc(loaded([EXAMPLE, cyclic]))
    assert near(
        control.correction(1, np.array([0.0, 4.0, 8.0, 12.0, -4.0]), 1),
        np.array([0, 2, 0, 2, 2]) * UM,
    )


@pytest.mark.parametrize(
    ("line", "what"),
    [
        (b"N03602Q1P00000001", "3602"),
        (b"N01240Q1A1P5.0", "1240"),
        (b"N01820Q1A1P0", "1820"),
        (b"N03622Q1A1P45", "missing"),
    ],
)
def test_what_the_pages_do_not_tell_is_not_answered(line: bytes, what: str) -> None:
    with pytest.raises(NotKnownError, match=what):
        VirtualFanuc(loaded([EXAMPLE, line])).correction(1, NODES, 1)


def test_accuracy_by_hand() -> None:
    """Means 1 and 5, s = 1 and 2: from 1 - 2 to 5 + 4."""
    assert accuracy(
        {1: np.array([[0.0, 1.0, 2.0]]), -1: np.array([[3.0, 5.0, 7.0]])}
    ) == pytest.approx(10.0)


def test_tables_are_put_where_they_belong() -> None:
    """The generator itself: a grid with one wrong digit would prove nothing."""
    if not FOLDER.is_dir():
        pytest.skip("the real FANUC backup is not beside the project")
    backup = Table(2, 140, 139, 141, 12.5, 3).put(Backup.real(), [4, 5, -6])
    control = VirtualFanuc(loaded(backup.files().values()))
    assert near(
        control.correction(2, np.array([-12.5, 0.0, 12.5]), 1), np.array([-5, 0, -6]) * 3 * 0.1 * UM
    )
