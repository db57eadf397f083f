"""The checks of a circular test: each speaks where it should and is silent on a sound test."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from circular_samples import (
    SENSES,
    UM,
    ballbar_file,
    circular_test,
    measured,
    perfect,
    plain_run,
    radial,
    run_of,
)
from compwright.evaluation.circular import evaluate_circle
from compwright.evaluation.circular_checks import run_findings
from compwright.evaluation.circular_points import paths
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularTest
from compwright.words.sentences import say
from places import REAL, needs_shared

Spoil = Callable[[FloatArray], FloatArray]


def found(test: CircularTest, code: str) -> list[str]:
    return [finding.message for finding in evaluate_circle(test).findings if finding.code == code]


def all_codes(test: CircularTest) -> list[str]:
    return [finding.code for finding in evaluate_circle(test).findings]


@pytest.mark.parametrize("arc", [(45.0, 360.0), (0.0, 360.0), (300.0, 90.0)])
def test_a_sound_test_has_no_warnings(arc: tuple[float, float]) -> None:
    rng = np.random.default_rng(4)
    machine = radial(
        lambda angle, sense: (
            rng.normal(0.0, 0.3 * UM, angle.size)
            + (3 if sense == "ccw" else -3) * UM * np.cos(2 * angle)
        )
    )
    test = measured(machine, n=1500, arc=arc, offset=(0.03, -0.02))
    assert all_codes(test) == ([] if arc[1] == 360.0 else ["CW-C010"])


@needs_shared
@pytest.mark.parametrize("file", ["ballbar_demo_100mm_XY.b5r", "ballbar_qc20w_150mm_XY.b5r"])
def test_real_circles_have_no_findings(file: str) -> None:
    assert all_codes(ballbar_file(REAL / "ballbar" / file)[0]) == []


def test_findings_of_the_reader_come_first() -> None:
    told = Finding("CW-R001", "info", say("as_written", text="taken as the message says"))
    result = evaluate_circle(replace(circular_test([run_of(perfect, "ccw")]), findings=(told,)))
    assert [finding.code for finding in result.findings] == ["CW-R001", "CW-C002"]


@pytest.mark.parametrize(("n", "told"), [(350, True), (370, False)])
def test_coarse_sampling(n: int, told: bool) -> None:
    """360° over 350 intervals is more than 1°, over 370 less."""
    messages = found(measured(perfect, n=n), "CW-C004")
    assert len(messages) == (2 if told else 0)
    if told:
        assert "ccw run 1 are 1.03° apart" in messages[0]


def test_a_hole_in_the_samples() -> None:
    run = run_of(perfect, "ccw")
    keep = (run.angles < 100.0) | (run.angles > 103.0)
    test = circular_test(
        [
            replace(run, angles=run.angles[keep], deviations=run.deviations[keep]),
            run_of(perfect, "cw"),
        ]
    )
    assert found(test, "CW-C005") == [
        "No samples of ccw run 1 from 99.75° to 103.25°: what the path does there is not evaluated."
    ]
    (gap,) = [one for one in evaluate_circle(test).findings if one.code == "CW-C005"]
    assert "von 99,75° bis 103,25°" in gap.sentence.text("de")


def test_a_circle_that_stopped_early() -> None:
    run = run_of(perfect, "cw")  # from 359.75° down
    test = circular_test(
        [
            replace(run, angles=run.angles[:-20], deviations=run.deviations[:-20]),
            run_of(perfect, "ccw"),
        ]
    )
    assert found(test, "CW-C005") == [
        "No samples of cw run 1 from 359.75° to 370.25°: what the path does there is not evaluated."
    ]


def test_an_arc_that_stopped_early() -> None:
    run = run_of(perfect, "ccw", arc=(10.0, 220.0))
    short = replace(run, angles=run.angles[:-50], deviations=run.deviations[:-50])
    test = circular_test([short, run_of(perfect, "cw", arc=(10.0, 220.0))], arc=(10.0, 220.0))
    assert found(test, "CW-C005") == [
        "ccw run 1 covers 204.42° of an arc of 220°."
    ]  # 669 of 720 steps of 220°


@pytest.mark.parametrize(
    ("feed", "told"),
    [
        (1000.0, False),
        (2000.0, False),
        (100.0, False),
        (30000.0, False),
        (1.0, True),  # m/min
        (16.7, True),  # mm/s: a circle of 100 mm in 38 min
        (1e6, True),
        (0.0, True),
        (-1000.0, True),
        (float("nan"), True),
    ],
)
def test_feed(feed: float, told: bool) -> None:
    messages = found(replace(measured(perfect), feed=feed), "CW-C006")
    assert bool(messages) == told
    if feed == 16.7:
        assert messages[0].startswith(
            "At 16.7 mm/min a circle of 100 mm takes 2260 s"
        )  # 2 pi 100/16.7 min


def test_overshoot_that_was_not_cut() -> None:
    test = circular_test([run_of(perfect, sense, arc=(0.0, 380.0)) for sense in SENSES])
    messages = found(test, "CW-C007")
    assert len(messages) == 2
    assert "covers 379.47°, more than the arc of 360°" in messages[0]  # 719 steps of 380/720
    assert found(measured(perfect, arc=(30.0, 180.0)), "CW-C007") == []


def test_unequal_numbers() -> None:
    runs = [run_of(perfect, "ccw", n=720), run_of(perfect, "cw", n=740)]
    assert found(circular_test(runs), "CW-C008") == [str(say("CW-C008.few", ccw=720, cw=740))]
    assert found(circular_test([runs[0], run_of(perfect, "cw", n=725)]), "CW-C008") == []
    slower = circular_test([runs[0], run_of(perfect, "cw", n=1440)])
    (doubt,) = (one for one in evaluate_circle(slower).findings if one.code == "CW-C008")
    assert doubt.is_doubt
    assert "one direction had 50 % of the feed" in doubt.message
    few = circular_test([run_of(perfect, "ccw", n=24), run_of(perfect, "cw", n=25)])
    assert found(few, "CW-C008") == []


def test_repeated_angles() -> None:
    run = run_of(perfect, "ccw")
    angles = run.angles.copy()
    angles[[5, 400]] = angles[[4, 399]]
    test = circular_test([replace(run, angles=angles), run_of(perfect, "cw")])
    assert found(test, "CW-C009") == [
        "2 samples of ccw run 1 have the same angle as another sample. All samples are used."
    ]
    both_ends = plain_run("ccw", np.arange(0.0, 361.0, 0.5)[:721], np.zeros(721) + 1.0)
    assert found(circular_test([both_ends]), "CW-C009") == []


def test_offset_on_an_arc() -> None:
    messages = found(measured(perfect, arc=(0.0, 180.0), offset=(0.03, 0.04)), "CW-C010")
    assert len(messages) == 1
    assert "here about 50.00 µm" in messages[0]


@pytest.mark.parametrize(("offset", "told"), [(0.099, False), (0.101, True)])
def test_large_offset(offset: float, told: bool) -> None:
    """e²/R = 0.1 µm at R = 100 mm: e = 0.1 mm."""
    messages = found(measured(perfect, offset=(0.0, -offset)), "CW-C011")
    assert bool(messages) == told
    if told:
        assert "lies 101.00 µm from" in messages[0]
        assert "up to 0.10 µm" in messages[0]


def test_what_the_message_of_a_large_offset_says_is_true() -> None:
    """Distances of a perfect circle that stand at angles measured from the set-up centre, read as
    commanded: G is up to e²/R.
    """
    run = run_of(perfect, "ccw", radius=50.0, n=1440)
    angle = np.radians(run.angles)
    polar = 0.5 * np.cos(angle) + np.sqrt(50.0**2 - (0.5 * np.sin(angle)) ** 2) - 50.0
    result = evaluate_circle(circular_test([replace(run, deviations=polar)], radius=50.0))
    width = result.parameters["G_ccw"]
    assert width is not None
    assert 0.5 * 0.5**2 / 50.0 < width <= 0.5**2 / 50.0 + 1e-6
    assert "up to 5.00 µm" in next(
        finding.message for finding in result.findings if finding.code == "CW-C011"
    )


def test_ends_that_do_not_meet() -> None:
    """A drift of 6 µm over the turn, started at 45°; at an axis the same step may be lost motion
    and is not judged.
    """
    rng = np.random.default_rng(8)

    def drifting(start: float) -> CircularTest:
        angles = start + np.arange(720) * 0.5 + 0.25
        return circular_test(
            [plain_run("ccw", angles, np.linspace(0.0, 6.0, 720) + rng.normal(0.0, 0.2, 720))],
            arc=(start, 360.0),
        )

    messages = found(drifting(45.0), "CW-C012")
    assert len(messages) == 1
    step = float(messages[0].split("changed by ")[1].split(" µm")[0])
    assert step == pytest.approx(
        6.0, abs=0.8
    )  # medians of three samples of 0.2 µm, less what the centre takes: 2 nm per µm
    assert found(drifting(90.0), "CW-C012") == []
    for _ in range(20):
        steady = circular_test(
            [plain_run("ccw", 45.25 + np.arange(720) * 0.5, rng.normal(0.0, 3.0, 720))],
            arc=(45.0, 360.0),
        )
        assert found(steady, "CW-C012") == []


def test_samples_on_both_sides_of_an_axis_may_step() -> None:
    """36 samples from 5° on: between the last and the first one X reverses, with 4 µm lost
    motion.
    """
    step = np.where(np.sin(np.radians(np.arange(5.0, 365.0, 10.0))) > 0.0, 2.0, -2.0)
    run = plain_run("ccw", np.arange(5.0, 365.0, 10.0), step)
    assert found(circular_test([run], arc=(5.0, 360.0)), "CW-C012") == []


def flicker(values: FloatArray, size: float) -> FloatArray:
    return values + np.round(np.random.default_rng(8).normal(0.0, size, values.size), 1)


@pytest.mark.parametrize(
    ("spoiled", "name"),
    [
        (lambda values: np.clip(values, -4.0, 4.0), "still"),
        (lambda values: np.r_[values[:300], np.full(200, values[299]), values[500:]], "still"),
        (lambda values: np.r_[values[:1200], np.full(300, values[1199])], "still"),
        (lambda values: np.r_[np.full(500, values[500]), values[500:]], "still"),
        (lambda values: values + 30.0 * (np.arange(1500) == 100), "single"),
        (lambda values: values + 30.0 * np.isin(np.arange(1500), [100, 101, 102]), "single"),
        (np.round, "coarse"),
        (lambda values: np.round(2.54 * np.round(values / 2.54), 1), "coarse"),
        (lambda values: 5.0 * np.round(values / 5.0) + 1.3 * (np.arange(1500) == 700), "coarse"),
    ],
)
def test_readings_that_an_instrument_cannot_have_measured(spoiled: Spoil, name: str) -> None:
    """The end of the range; a reading that stops within or at an end of the run;
    a knock of one or three samples; steps of 1 µm, 0.0001 inch and 5 µm. The same readings with the
    0.1 µm of a ballbar, with and without noise, are sound.
    """
    rng = np.random.default_rng(5)
    angles = 45.0 + np.arange(1500) * 0.24
    theta = np.radians(angles)
    path = 10.0 * np.cos(2.0 * theta) + 3.0 * np.sin(theta)
    path += 1.5 * np.sign(np.sin(theta)) * np.cos(theta)
    for noise in (0.0, 0.1, 0.4):
        readings = np.round(path + rng.normal(0.0, noise, 1500), 1)
        test = circular_test([plain_run("ccw", angles, readings)], arc=(45.0, 360.0))
        assert found(test, "CW-C016") == []
        wrong = circular_test([plain_run("ccw", angles, spoiled(readings))], arc=(45.0, 360.0))
        (doubt,) = (one for one in evaluate_circle(wrong).findings if one.code == "CW-C016")
        assert doubt.is_doubt
        assert doubt.sentence.name == f"CW-C016.{name}"


def test_the_end_of_the_range_flickers_less_than_a_moving_machine() -> None:
    """The electronics have a noise of 0.2 µm in all readings; the machine adds its own."""
    rng = np.random.default_rng(5)
    angles = 45.0 + np.arange(1500) * 0.24
    theta = np.radians(angles)
    for noise in (0.5, 0.8):
        path = 10.0 * np.cos(2.0 * theta) + 3.0 * np.sin(theta) + rng.normal(0.0, noise, 1500)
        readings = flicker(np.clip(path, -5.0, 5.0), 0.2)
        test = circular_test([plain_run("ccw", angles, readings)], arc=(45.0, 360.0))
        assert len(found(test, "CW-C016")) == 1
        test = circular_test([plain_run("ccw", angles, flicker(path, 0.2))], arc=(45.0, 360.0))
        assert found(test, "CW-C016") == []


@pytest.mark.parametrize("noise", [0.1, 0.2, 0.5])
def test_a_level_path_of_a_table_with_steps_is_sound(noise: float) -> None:
    """Stored pitch errors are added as a step at each point: steps of 1 µm every 20 to 40 mm, with
    squareness and lost motion, on 60 machines. The path is level over 20° on about every tenth.
    """
    angles = 0.12 + np.arange(1500) * 0.24
    cos, sin = np.cos(np.radians(angles)), np.sin(np.radians(angles))
    for seed in range(60):
        rng = np.random.default_rng(seed)
        squareness, lost = rng.uniform(-9.0, 9.0), rng.uniform(0.0, 8.0, 2)
        error = [0.5 * lost[0] * np.sign(sin), -0.5 * lost[1] * np.sign(cos) - squareness * cos]
        for along, position in enumerate((150.0 * cos, 150.0 * sin)):
            interval = rng.uniform(20.0, 40.0)
            point = np.round((position + rng.uniform(0.0, interval)) / interval).astype(int)
            error[along] = error[along] + np.cumsum(rng.integers(-2, 3, 40))[point + 20]
        readings = np.round(error[0] * cos + error[1] * sin + rng.normal(0.0, noise, 1500), 1)
        test = circular_test([plain_run("ccw", angles, readings)], arc=(0.0, 360.0))
        (path,) = paths(test.runs, test.nominal_radius)
        codes = {one.code for one in run_findings(test, path, (0.0, 0.0))}
        assert "CW-C016" not in codes, seed


@pytest.mark.parametrize("late", [0.0, 8.0])
@pytest.mark.parametrize("step", [0.1, 0.5])
def test_a_level_path_between_steps_of_lost_motion_is_sound(late: float, step: float) -> None:
    """Squareness and lost motion make a path nearly level before a reversal, which an axis that
    lags passes some degrees later.
    """
    rng = np.random.default_rng(7)
    angles = 45.0 + np.arange(3000) * 0.12
    theta, there = np.radians(angles), np.radians(angles - late)
    for lost in (2.0, 5.0, 8.0):
        path = 2.0 * np.sin(2.0 * theta)
        path += 0.5 * lost * np.sign(np.sin(there)) * np.cos(theta)
        path -= 0.4 * lost * np.sign(np.cos(there)) * np.sin(theta)
        for noise in (0.0, 0.05, 0.2):
            readings = step * np.round((path + rng.normal(0.0, noise, 3000)) / step)
            test = circular_test([plain_run("ccw", angles, readings)], arc=(45.0, 360.0))
            assert found(test, "CW-C016") == []


def test_a_run_of_zeros() -> None:
    bumpy = run_of(radial(lambda angle, _: UM * np.cos(3 * angle)), "ccw")
    zero = replace(run_of(perfect, "cw"), deviations=np.zeros(720))
    assert found(circular_test([bumpy, zero]), "CW-C013") == [str(say("CW-C013", run="cw run 1"))]


def test_the_readings_of_one_run_twice() -> None:
    """In the order of the angles, or in that of time, which is the other way round in cw."""
    rng = np.random.default_rng(8)
    ccw = plain_run("ccw", np.arange(720) * 0.5, rng.normal(0.0, 3.0, 720))
    for values in (ccw.deviations, ccw.deviations[::-1]):
        copied = circular_test([ccw, replace(ccw, sense="cw", deviations=values)], arc=(0.0, 360.0))
        (message,) = found(copied, "CW-C015")
        assert message.startswith("ccw run 1 and cw run 1 have exactly the same readings")
    other = replace(ccw, sense="cw", deviations=ccw.deviations + 1e-6)
    assert found(circular_test([ccw, other], arc=(0.0, 360.0)), "CW-C015") == []
