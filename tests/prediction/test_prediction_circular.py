"""The moved path against exact geometry and against a second simulation, and what a prediction says
of fresh tests.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from compwright.estimation.circle import diagnose
from compwright.evaluation.circular import evaluate_circle
from compwright.prediction.circular import (
    CirclePath,
    _smoothed,
    commanded_path,
    moved_test,
    predict_circle,
)
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun, CircularTest
from compwright.simulation.circular import CircleErrors, CirclePlan, record_circle

CENTRE = (300.0, -120.0)


def plain(sense: str, angles: list[float], radius: float = 100.0) -> CircularTest:
    run = CircularRun(sense=sense, angles=np.array(angles), deviations=np.zeros(len(angles)))  # type: ignore[arg-type]
    return CircularTest(
        name="c",
        plane="XY",
        axes=("X", "Y"),
        nominal_radius=radius,
        feed=1000.0,
        arc=(0.0, 360.0),
        calibrated=True,
        runs=(run,),
    )


@pytest.mark.parametrize(("sense", "d"), [("ccw", 1), ("cw", -1)])
def test_where_a_run_commands_its_axes_and_which_way_they_move(sense: str, d: int) -> None:
    test = plain(sense, [30.0, 120.0, 210.0, 300.0])
    path = commanded_path(test, test.runs[0], CENTRE)
    half, most = 50.0, 100.0 * np.sqrt(0.75)
    np.testing.assert_allclose(
        path.first, CENTRE[0] + np.array([most, -half, -most, half]), atol=1e-9
    )
    np.testing.assert_allclose(
        path.second, CENTRE[1] + np.array([half, most, -half, -most]), atol=1e-9
    )
    # ccw: from the first axis to the second: in the first quadrant X goes back and Y forth
    np.testing.assert_array_equal(path.moves_first, d * np.array([-1, -1, 1, 1]))
    np.testing.assert_array_equal(path.moves_second, d * np.array([1, -1, -1, 1]))


def test_at_a_reversal_the_new_direction_counts() -> None:
    for sense, moves in (("ccw", -1.0), ("cw", -1.0)):  # at the positive end X can only go back
        test = plain(sense, [0.0])
        assert commanded_path(test, test.runs[0], CENTRE).moves_first[0] == moves


def test_a_point_moves_by_its_displacement_exactly() -> None:
    test = plain("ccw", [0.0, 45.0, 90.0])

    def shear(path: CirclePath) -> FloatArray:
        return np.column_stack([np.zeros(path.first.size), 1e-3 * (path.first - CENTRE[0])])

    found = moved_test(test, CENTRE, shear).runs[0].deviations
    c = 100.0 * np.sqrt(0.5)
    expected = [np.hypot(100.0, 0.1) - 100.0, np.hypot(c, c + 1e-3 * c) - 100.0, 0.0]
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_what_moves_the_centre_is_set_up_anew() -> None:
    test = plain("cw", [10.0, 100.0, 190.0])
    found = moved_test(test, CENTRE, lambda path: np.full((path.first.size, 2), 0.37))
    np.testing.assert_allclose(found.runs[0].deviations, 0.0, atol=1e-12)


def correction(axis: str, positions: FloatArray, direction: FloatArray) -> FloatArray:
    """Tables of an axis with slope, bend and reversal, other values for each axis."""
    slope, bend, lost = (40e-6, 3e-3, 4e-3) if axis == "X" else (-25e-6, -2e-3, 6e-3)
    return np.asarray(slope * positions + bend * np.sin(positions / 37.0) - 0.5 * lost * direction)


@pytest.mark.parametrize("arc", [(0.0, 360.0), (20.0, 220.0)])
def test_the_change_of_tables_is_that_of_the_exact_machine(arc: tuple[float, float]) -> None:
    """A simulated machine with the tables loaded, and the test without them moved by the tables:
    the same circle.
    """
    plan = CirclePlan(radius=100.0, centre=CENTRE, arc=arc)
    errors = CircleErrors(squareness=60e-6, offset=(0.05, -0.03))
    before, after = (
        record_circle(errors, plan).test,
        record_circle(errors, plan, corrections=correction).test,
    )

    def tables(path: CirclePath) -> FloatArray:
        return np.column_stack(
            [
                correction("X", path.first, path.moves_first),
                correction("Y", path.second, path.moves_second),
            ]
        )

    moved = moved_test(before, CENTRE, tables)
    for mine, other in zip(moved.runs, after.runs, strict=True):
        # 20 µm of correction on a point that lies 60 µm off its commanded ray, R = 100: 0.02 · 0.06
        # / 100 = 1.2e-5 mm
        assert np.max(np.abs(mine.deviations - other.deviations)) < 2e-5
        assert np.ptp(other.deviations) > 5e-3  # mm: there is something to see


def test_predicted_intervals_hold_fresh_tests() -> None:
    """Of fresh tests of one machine a prediction from one of them must hold most.

    Meant are 90 %, held were 84 % of 100 (white noise); ten fresh tests share one prediction, so 65
    % of 60 is the least likely.
    """
    machine = Machine(
        squareness=30.0,
        backlash_first_at_positive=4.0,
        backlash_first_at_negative=4.0,
        servo_mismatch=0.1,
    )
    setup = Setup(noise=0.4, samples=720)
    held: dict[str, int] = {}
    rounds = 6
    for seed in range(rounds):
        rng = np.random.default_rng(seed)
        first = measured(machine, setup, rng)
        before = replace(evaluate_circle(first), diagnosis=diagnose(first))
        prediction = predict_circle(before, before, np.random.default_rng(1), 60)
        for _ in range(10):
            fresh = evaluate_circle(measured(machine, setup, rng)).parameters
            for name in ("G_ccw", "G_cw", "G_bidirectional", "D"):
                band, value = prediction.predicted[name], fresh[name]
                assert value is not None
                held[name] = held.get(name, 0) + (band.p05 <= value <= band.p95)
    for name, count in held.items():
        assert count >= 0.65 * rounds * 10, f"{name}: {count}"


def test_causes_keep_their_value_and_widen_for_two_tests() -> None:
    test = measured(
        Machine(squareness=30.0), Setup(noise=0.3, samples=720), np.random.default_rng(2)
    )
    before = replace(evaluate_circle(test), diagnosis=diagnose(test))
    assert before.diagnosis is not None
    effect = before.diagnosis.effects["squareness"]
    band = predict_circle(before, before, np.random.default_rng(1), 10).causes["squareness"]
    assert band.median == effect.value
    assert band.p95 - band.p05 == pytest.approx(2 * 1.645 * np.sqrt(2) * effect.std_error)
    spike = predict_circle(before, before, np.random.default_rng(1), 10).causes[
        "reversal_spike_first"
    ]
    assert spike.p05 >= 0.0


def test_a_parameter_that_the_test_does_not_have_is_not_predicted() -> None:
    test = replace(
        measured(Machine(), Setup(noise=0.3, samples=360), np.random.default_rng(2)),
        calibrated=False,
    )
    bare = evaluate_circle(test)
    before = replace(bare, diagnosis=diagnose(test))
    nothing = predict_circle(bare, bare, np.random.default_rng(1), 5)
    assert (nothing.predicted, nothing.causes) == ({}, {})  # no diagnosis was made
    prediction = predict_circle(before, before, np.random.default_rng(1), 5)
    assert "F_max_ccw" not in prediction.predicted
    assert "H" not in prediction.predicted
    assert {"G_ccw", "G_cw", "G_bidirectional", "D"} <= set(prediction.predicted)


def test_the_noise_of_a_fresh_test_is_what_a_parabola_leaves() -> None:
    """A parabola is no noise; of independent noise the smoothing over 11 samples leaves in the
    residual 1 - 0.2075 of the variance in the middle (quadratic Savitzky-Golay weights: 89/429).
    """
    angles = np.asarray((np.arange(720) + 0.5) / 2.0, dtype=np.float64)
    along = np.mod(angles, 90.0) / 90.0
    smooth = 0.01 * (along - 0.3) ** 2
    assert _smoothed(CircularRun(sense="ccw", angles=angles, deviations=smooth)) == pytest.approx(
        smooth, abs=1e-14
    )
    spike = np.zeros(720)
    spike[300] = 1.0
    found = _smoothed(CircularRun(sense="ccw", angles=angles, deviations=spike))
    assert found[300] == pytest.approx(89.0 / 429.0)
    assert found[301] == pytest.approx(84.0 / 429.0)
    assert found[305] == pytest.approx(-36.0 / 429.0)
    # a reversal point parts the windows: nothing goes over it
    spike = np.zeros(720)
    spike[180] = 1.0
    assert not np.any(_smoothed(CircularRun(sense="ccw", angles=angles, deviations=spike))[:180])
