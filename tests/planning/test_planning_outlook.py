"""What a fresh test will show, of axes whose error is known; and whether a table is worth it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.evaluation.standards import evaluate
from compwright.planning import simulated_repeat_tests
from compwright.planning.axis_work import AxisWork, why_no_gain
from compwright.planning.predicted_gain import (
    parameter_spread,
    predict,
    why_not_better,
    why_not_seen,
)
from compwright.prediction.active_corrections import difference, no_correction
from compwright.records.axis import AxisKind
from compwright.records.correction import AxisCompensation
from compwright.records.prediction import Quantiles
from compwright.records.result import PositioningResult
from planning_samples import UM, KnownAxis, axis_of, by_slope, work_of

SLOPED = KnownAxis(lambda x: 30e-6 * x, lambda x: 30e-6 * x)
ROTARY_FACTOR = 3600.0


def shown(work: AxisWork, new: object, name: str = "E") -> float:
    change = difference(new, work.active)  # type: ignore[arg-type]
    prediction = predict(work.results[0], work.posterior, change, work.planned.axis)
    return prediction.predicted[name].median / UM


def test_a_table_of_minus_the_error_leaves_nothing() -> None:
    """30 µm/m over a metre: 30 µm now, nothing with the table, 60 with its sign turned."""
    work = work_of(SLOPED)
    assert shown(work, no_correction) == pytest.approx(30.0)
    assert shown(work, by_slope(-30e-6)) == pytest.approx(0.0, abs=1e-9)
    assert shown(work, by_slope(30e-6)) == pytest.approx(60.0)


def test_what_acted_during_the_test_is_no_change_where_it_stays() -> None:
    table = AxisCompensation(
        address="X",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 1000.0]),
        positive=np.array([0.0, 10.0 * UM]),
        negative=np.array([0.0, 10.0 * UM]),
    )
    work = work_of(SLOPED, active=table)
    assert shown(work, table.at) == pytest.approx(30.0)
    assert shown(work, no_correction) == pytest.approx(20.0)


def test_lost_motion_changes_the_reversal_value() -> None:
    """The axis stands 5 µm too high in -: B is -5 µm; the control draws it back by 5 in -."""
    lags = KnownAxis(np.zeros_like, lambda x: 0.0 * x + 5.0 * UM)
    work = work_of(lags)
    assert shown(work, no_correction, "B_mean") == pytest.approx(-5.0)
    assert shown(work, by_slope(0.0, lost=-5.0 * UM), "B_mean") == pytest.approx(0.0, abs=1e-9)


def test_new_targets_stay_away_from_the_ends_and_see_what_lies_between(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    seen: list[np.ndarray] = []

    class Watching(KnownAxis):
        def draw(self, positions, count, rng, test=0):  # type: ignore[no-untyped-def]
            seen.append(positions)
            return super().draw(positions, count, rng, test)

    work = work_of(Watching(np.zeros_like, np.zeros_like))
    monkeypatch.setattr(simulated_repeat_tests, "draws_like", lambda _: 5)
    found = simulated_repeat_tests.fresh_tests(
        work.results[0], work.posterior, work.planned.axis
    ).quantiles(no_correction)
    assert set(found) >= {"A", "E", "R"}
    assert seen[0].shape == (5, work.results[0].test.targets.size)
    assert (seen[0] >= 4.0).all()
    assert (seen[0] <= 996.0).all()
    assert np.abs(seen[0] - work.results[0].test.targets).max() > 1.0
    assert len(np.unique(seen[0])) == seen[0].size  # no two tests at the same targets


def test_the_same_job_predicts_the_same_and_another_axis_something_else() -> None:
    noisy = KnownAxis(np.zeros_like, np.zeros_like, noise=1.0 * UM)
    one, again, other = (
        predict(work.results[0], work.posterior, no_correction, work.planned.axis).predicted["A"]
        for work in (work_of(noisy), work_of(noisy), work_of(noisy, axis_of("Y")))
    )
    assert one == again
    assert one != other


def test_a_direction_that_was_not_measured_is_not_predicted() -> None:
    work = work_of(SLOPED, one_way=True)
    found = predict(work.results[0], work.posterior, no_correction, work.planned.axis).predicted
    assert "E_positive" in found
    assert not {"B_mean", "E_negative", "M"} & set(found)


def result_of(**parameters: float | None) -> PositioningResult:
    values = {key: None if value is None else value * UM for key, value in parameters.items()}
    return replace(work_of(SLOPED).results[0], parameters=values)


def of(name: str, median: float) -> dict[str, Quantiles]:
    return {name: Quantiles(median * UM, 0.0, 0.0)}


@pytest.mark.parametrize(
    ("was", "becomes", "fresh_was", "fresh", "words"),
    [
        (10.0, 5.0, 10.0, 5.0, ""),
        (
            10.0,
            10.0,
            10.0,
            5.0,
            "A is 10.00 µm with the table and 10.00 µm without it",
        ),
        (
            10.0,
            12.0,
            10.0,
            5.0,
            "A is 12.00 µm with the table and 10.00 µm without it",
        ),
        (
            10.0,
            5.0,
            10.0,
            10.0,
            "A is expected to be 10.00 µm with the table and 10.00 µm without it",
        ),
        (10.0, 5.0, 10.0, 11.0, "at new targets, A is expected to be 11.00 µm"),
    ],
)
def test_a_table_has_to_improve_the_test_and_what_lies_between_its_targets(
    was: float, becomes: float, fresh_was: float, fresh: float, words: str
) -> None:
    why = why_not_better(result_of(A=was), result_of(A=becomes), of("A", fresh_was), of("A", fresh))
    assert (words in str(why)) if words else why is None


def test_the_size_counts_where_a_value_has_a_sign() -> None:
    better = why_not_better(
        result_of(B_mean=-5.0), result_of(B_mean=1.0), of("B_mean", -5.0), of("B_mean", 1.0)
    )
    assert better is None
    worse = why_not_better(
        result_of(B_mean=1.0), result_of(B_mean=-5.0), of("B_mean", 1.0), of("B_mean", -5.0)
    )
    assert "B_mean is -5.00 µm with the table" in str(worse)


def test_the_first_parameter_that_the_test_has_judges() -> None:
    """A is not defined here, E gets worse, R gets better."""
    before, after = result_of(A=None, E=5.0, R=9.0), result_of(A=None, E=6.0, R=1.0)
    assert "E is 6.00 µm with the table" in str(why_not_better(before, after, {}, {}))
    assert why_not_better(result_of(A=None), result_of(A=None), {}, {}) is None


def test_the_spread_from_test_to_test_is_that_of_a_normal_law() -> None:
    """5 % of a normal law lie 1.645 standard deviations below its middle; a long upper end does not
    count.
    """
    assert parameter_spread(
        Quantiles(median=10.0, p05=10.0 - 1.645 * 2.0, p95=40.0)
    ) == pytest.approx(2.0)


@pytest.mark.parametrize(("gain", "seen"), [(1.5, False), (2.5, True)])
def test_a_gain_is_seen_from_one_standard_deviation_on(gain: float, seen: bool) -> None:
    was = {"A": Quantiles(median=20.0 * UM, p05=15.0 * UM, p95=25.0 * UM)}
    middle = (20.0 - gain) * UM
    becomes = {"A": Quantiles(median=middle, p05=middle - 1.645 * 2.0 * UM, p95=middle + 4.0 * UM)}
    assert (why_not_seen(work_of(SLOPED).results[0], was, becomes) is None) is seen


def test_a_table_that_does_not_help_is_refused() -> None:
    work = work_of(SLOPED)
    assert why_no_gain(work, by_slope(-28e-6)) is None
    assert "and 30.00 µm without it" in str(why_no_gain(work, by_slope(30e-6)))
    assert "and 30.00 µm without it" in str(why_no_gain(work, no_correction))


def test_what_acts_now_is_what_a_table_has_to_beat() -> None:
    """Nothing acted during the test, but the control draws back 25 µm/m now: 5 µm remain; a table
    of 20 µm/m leaves 10.
    """
    work = work_of(SLOPED, as_found=by_slope(-25e-6))
    assert "A is 10.00 µm with the table and 5.00 µm without it" in str(
        why_no_gain(work, by_slope(-20e-6))
    )
    assert why_no_gain(work, by_slope(-29e-6)) is None


@pytest.mark.parametrize("off", [100.0, 130.0, 170.0, 210.0, 260.0])
def test_one_reading_far_off_does_not_stop_a_table(
    off: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One reading ``off`` makes A with the table and without it, alike but for rounding: 4 s of its
    cell, which no table moves. The others show that 30 µm/m become 2.
    """
    monkeypatch.setattr(simulated_repeat_tests, "draws_like", lambda _: 5)
    work = work_of(SLOPED)
    result = work.results[0]
    rng = np.random.default_rng(4)
    plus, minus = (
        block[:, :1] + 0.3 * UM * rng.standard_normal((block.shape[0], 5))
        for block in (result.test.positive, result.test.negative)
    )
    plus[5, 2] += off * UM
    runs = (1, 2, 3, 4, 5)
    test = replace(
        result.test, positive=plus, negative=minus, runs_positive=runs, runs_negative=runs
    )
    work = replace(work, results=(evaluate(test, result.standard),))
    assert why_no_gain(work, by_slope(-28e-6)) is None
    assert " with the table and 3" in str(why_no_gain(work, by_slope(30e-6)))
