"""What differs between two tests: against tests made again on machines whose change is known."""

from __future__ import annotations

import math
from dataclasses import replace
from datetime import date, timedelta

import numpy as np
import pytest

from compwright.evaluation.change_significance import (
    UncertainValue,
    difference,
    scatter_changed,
    score_of_ratio,
    score_of_t,
    two_sided_probability,
)
from compwright.evaluation.forecasts import ErrorCurve, reached
from compwright.evaluation.series_changes import noted_changes, noted_trends
from compwright.evaluation.standard_errors import standard_errors
from compwright.evaluation.trends import Trend, trend_of
from compwright.records.history import HistoryEntry, NotedTrend

TARGETS = np.linspace(0.0, 600.0, 11)
CURVE = 8.0 * np.sin(TARGETS / 130.0)
K = 2.0
#: Probability of the opposite sign below which the rate of the main parameters is clear.
CLEAR = 0.0035


def made(
    rng: np.random.Generator, s: float = 0.5, lost: float = 3.0, shift: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """Readings of five runs; ``shift``: scatter of whole traverses."""
    blocks = []
    for reversal in (0.0, lost):
        own = rng.normal(0.0, s, (TARGETS.size, 5)) + rng.normal(0.0, shift, (1, 5))
        blocks.append(CURVE[:, None] + reversal + own)
    return blocks[0], blocks[1]


def parameters(up: np.ndarray, down: np.ndarray) -> dict[str, float]:
    """A, B, mean B and s as the standard's formulas say, written out here."""
    means = np.concatenate([up.mean(axis=1), down.mean(axis=1)])
    s = np.concatenate([up.std(axis=1, ddof=1), down.std(axis=1, ddof=1)])
    reversal = up.mean(axis=1) - down.mean(axis=1)
    return {
        "A": float(np.max(means + K * s) - np.min(means - K * s)),
        "B": float(np.max(np.abs(reversal))),
        "B_mean": float(reversal.mean()),
        "s": float(np.sqrt(np.mean(s**2))),
    }


def parameter(up: np.ndarray, down: np.ndarray) -> dict[str, UncertainValue]:
    errors = standard_errors(up, down, K)
    return {
        name: UncertainValue(value, errors[name].value, errors[name].dof)
        for name, value in parameters(up, down).items()
    }


@pytest.mark.parametrize("shift", [0.0, 0.4])
def test_standard_errors_cover_what_the_same_machine_shows_again(shift: float) -> None:
    """As large as the spread of the parameter over tests made again, at most twice it."""
    rng = np.random.default_rng(1)
    tests = [made(rng, shift=shift) for _ in range(200)]
    found = [parameters(*test) for test in tests]
    stated = [standard_errors(*test, K) for test in tests]
    for name in ("A", "B", "B_mean", "s"):
        spread = float(np.std([each[name] for each in found], ddof=1))
        said = float(np.sqrt(np.mean([each[name].value ** 2 for each in stated])))
        assert 0.85 * spread < said < 2.1 * spread, (name, said / spread)


@pytest.mark.parametrize("shift", [0.0, 0.4])
def test_an_unchanged_machine_is_hardly_ever_called_changed(shift: float) -> None:
    rng = np.random.default_rng(2)
    alarms = 0
    for _ in range(100):
        one, other = (parameter(*made(rng, shift=shift)) for _ in range(2))
        alarms += sum(difference(one[name], other[name]).clear() for name in ("A", "B", "B_mean"))
        alarms += scatter_changed(one["s"], other["s"]).clear()
    assert alarms <= 4  # of 400 comparisons


def test_a_collision_shows() -> None:
    """Lost motion up by 4 µm, or twice the scatter: found in nearly every pair of tests."""
    rng = np.random.default_rng(3)
    found = {"B_mean": 0, "s": 0}
    for _ in range(50):
        before = parameter(*made(rng))
        found["B_mean"] += difference(
            before["B_mean"], parameter(*made(rng, lost=7.0))["B_mean"]
        ).clear()
        found["s"] += scatter_changed(before["s"], parameter(*made(rng, s=1.0))["s"]).clear()
    assert found["B_mean"] >= 49
    assert found["s"] >= 45


def test_what_is_declared_counts() -> None:
    one, other = UncertainValue(10.0, 0.3, 40.0), UncertainValue(14.0, 0.3, 40.0)
    assert difference(one, other).clear()
    assert not difference(one, other, between_tests=2.0).clear()
    assert not difference(UncertainValue(10.0, 0.3, 40.0, declared=2.0), other).clear()


def test_tests_without_repeats_have_no_standard_errors() -> None:
    assert standard_errors(CURVE[:, None], np.empty((11, 0)), K) == {}


def test_one_direction_has_no_reversal() -> None:
    up, _ = made(np.random.default_rng(4))
    assert set(standard_errors(up, np.empty((11, 0)), K)) == {"A", "s"}


def entry(place: int, values: dict[str, float]) -> HistoryEntry:
    """One test of a year, of an axis whose parameters are known to 0.1 µm."""
    return HistoryEntry(
        folder=f"m/{place:02}",
        number=0,
        machine="m",
        serial="1",
        what="X",
        kind="positioning",
        rotary=False,
        test="x",
        taken="before",
        date="",
        day=f"2021-01-{place + 1:02}",
        unit="um",
        standard="iso230-2:2014",
        values=values,
        errors=dict.fromkeys(values, (0.1, 60.0)),
        declared={},
        targets=tuple(TARGETS),
        means=((), ()),
        table="none",
        acting="none",
        verdict="",
        sources=(str(place),),
        simulated=False,
        instrument="",
        limits={},
    )


def test_the_threshold_counts_every_comparison_of_a_series() -> None:
    """Twenty tests of three parameters of a stable machine: on one axis in a hundred one of the 57
    differences may look like a change; at one in 1000 each it would be on one in twenty.
    """
    rng = np.random.default_rng(5)
    alarms = 0
    for _ in range(500):
        B, B_mean = 3.0 + 0.1 * rng.standard_normal((2, 20))
        s = 0.5 * np.sqrt(rng.chisquare(60.0, 20) / 60.0)
        tests = [
            entry(k, {"B": float(B[k]), "B_mean": float(B_mean[k]), "s": float(s[k])})
            for k in range(20)
        ]
        alarms += bool(noted_changes(tests, ()))
    assert alarms <= 10


# two-sided 1 in 1000 of Student's law and 1 in 100 of F, from printed tables
@pytest.mark.parametrize(("dof", "t"), [(4, 8.610), (8, 5.041), (20, 3.850), (60, 3.460)])
def test_scores_of_t(dof: float, t: float) -> None:
    assert score_of_t(t, dof) == pytest.approx(3.2905, abs=0.1)
    assert score_of_t(-t, dof) == -score_of_t(t, dof)


@pytest.mark.parametrize(("one", "other", "ratio"), [(5, 10, 5.64), (20, 20, 2.94), (60, 10, 4.08)])
def test_scores_of_a_ratio(one: float, other: float, ratio: float) -> None:
    assert score_of_ratio(ratio, one, other) == pytest.approx(2.326, abs=0.05)
    assert score_of_ratio(1.0 / ratio, other, one) == pytest.approx(-2.326, abs=0.05)
    assert two_sided_probability(3.2905) == pytest.approx(0.001, rel=1e-3)
    assert math.isinf(score_of_ratio(math.inf, 5.0, 5.0))


@pytest.mark.parametrize("stated", [1.0, 3.0, 11.5])
def test_the_scatter_of_many_tests_counts_more_than_what_is_stated_of_it(stated: float) -> None:
    """Twelve tests whose slopes scatter by 2 µm/m: the rate is as sure as the textbook's line."""
    years = np.linspace(0.0, 5.0, 12)
    textbook = 2.0 / math.sqrt(float(np.sum((years - years.mean()) ** 2)))
    ratios, held = [], 0
    for seed in range(40):
        values = 4.0 * years + np.random.default_rng(seed).normal(0.0, 2.0, years.size)
        trend = trend_of(years, values, np.full(12, 0.2), np.full(12, stated), [0.02] * 11, CLEAR)
        assert trend is not None
        ratios.append(trend.std_error / textbook)
        held += abs(trend.rate - 4.0) < 1.96 * trend.std_error
    assert 0.9 < np.median(ratios) < 1.6
    assert held >= 34


def test_three_tests_on_a_line_are_no_proof_where_the_temperature_may_have_made_it() -> None:
    years, values = np.array([0.0, 1.0, 2.0]), np.array([0.0, 8.0, 16.0])  # µm/m: 0.7 K each
    trend = trend_of(years, values, np.full(3, 0.2), np.full(3, 11.5), [0.02] * 2, CLEAR)
    assert trend is not None
    assert not trend.clear
    exact = trend_of(years, values, np.full(3, 0.2), np.zeros(3), [0.02] * 2, CLEAR)
    assert exact is not None
    assert exact.clear


def wear(count: int, multiple: float) -> Trend:
    """A rate of this multiple of its standard error, the tests scattering by 0.1 µm."""
    years = np.linspace(0.0, 4.0, count)
    off = np.random.default_rng(count).standard_normal(count)
    off -= np.polyval(np.polyfit(years, off, 1), years)
    off *= 0.1 / math.sqrt(float(off @ off) / (count - 2))

    def growing(rate: float) -> Trend:
        values, errors = rate * years + off, np.full(count, 0.05)
        trend = trend_of(years, values, errors, np.zeros(count), [1e-6] * (count - 1), CLEAR)
        assert trend is not None
        return trend

    trend = growing(0.0)
    for _ in range(7):  # the standard error changes little with the rate
        trend = growing(multiple * trend.std_error)
    return trend


def test_a_clear_rate_is_one_probability_for_few_tests_and_for_many() -> None:
    """Two-sided 0.7 % is 2.70 standard deviations of the normal law, and 5.8 of Student's with 3
    degrees of freedom: 3.6 half widths of its 95 % interval (3.18) divided by 1.96.
    """
    assert wear(40, 2.9).clear
    assert not wear(40, 2.5).clear
    assert not wear(5, 3.3).clear
    assert wear(5, 4.2).clear


def worn(seed: int, rate: float, share: float) -> NotedTrend:
    """Mean B of twelve tests over five years, known to 0.12 um. It grows by ``rate`` a year, and an
    adjustment in between takes back this ``share`` of what has grown.
    """
    rng = np.random.default_rng(seed)
    years = np.linspace(0.0, 5.0, 12)
    at = int(rng.integers(4, 9))
    grown = rate * years - share * rate * years[at] * (np.arange(12) >= at)
    lost = -2.0 + grown + 0.12 * rng.standard_normal(12)
    days = [date(2019, 1, 1) + timedelta(days=round(365.25 * year)) for year in years]
    tests = [
        replace(entry(k, {"B_mean": float(lost[k])}), day=days[k].isoformat()) for k in range(12)
    ]
    [trend] = noted_trends(tests)
    return trend


def test_growth_is_found_although_an_adjustment_set_it_back() -> None:
    """A saw tooth: without the adjustment the values look like a large scatter."""
    shares = (0.7, 0.9, 1.0, 1.1)
    found = [worn(seed, -0.35, shares[seed % 4]) for seed in range(1000, 1080)]
    assert sum(trend.clear and trend.rate < 0.0 for trend in found) >= 72
    assert sum(abs(trend.rate + 0.35) < 2.0 * trend.std_error for trend in found) >= 70


def test_scatter_is_no_saw_tooth() -> None:
    assert sum(worn(seed, 0.0, 1.0).clear for seed in range(2000, 2080)) <= 2


def test_the_rates_that_are_clear_are_not_forecast_too_large() -> None:
    """Rates from half a standard error to eight: those that scatter enlarged are clear more often;
    three years ahead as many forecasts are too high as too low.
    """
    rng = np.random.default_rng(9)
    years = np.linspace(0.0, 5.0, 14)
    error = 0.1 / math.sqrt(float(np.sum((years - years.mean()) ** 2)))
    above = []
    for _ in range(240):
        rate = error * math.exp(rng.uniform(math.log(0.5), math.log(8.0)))
        values = rate * years + 0.1 * rng.standard_normal(14)
        trend = trend_of(years, values, np.full(14, 0.1), np.zeros(14), [0.02] * 13, CLEAR)
        assert trend is not None
        if trend.clear:
            level, _ = trend.lines(np.random.default_rng(0), 3.0)
            above.append(float(np.median(level)) > 8.0 * rate)
    assert len(above) > 60
    assert abs(np.mean(above) - 0.5) < 2.0 * 0.5 / math.sqrt(len(above))


def test_the_date_of_a_straight_axis_is_held() -> None:
    """E of a straight axis is the reversal error plus the size of the tilt. Where the tilt is small
    against its error of 3 um/m, a measured one is mostly larger than the true one.
    """
    rng = np.random.default_rng(10)
    straight = ErrorCurve("E", np.linspace(-0.5, 0.5, 11), np.zeros((2, 11)))
    held = 0
    for _ in range(200):
        tilt = rng.uniform(-1.5, 1.5)
        shown = tilt + 3.0 * rng.standard_normal()
        slope = np.stack([shown + 3.0 * rng.standard_normal(1000), np.zeros(1000)])
        level = -2.0 + 0.1 * rng.standard_normal() + 0.1 * rng.standard_normal(1000)
        reversal = np.stack([level, np.full(1000, -1.0)])
        early, _, late = reached(10.0, np.zeros((2, 1000)), straight, slope, reversal)
        assert early is not None
        assert late is not None
        held += early <= 10.0 - 2.0 - abs(tilt) <= late
    assert 172 <= held <= 193  # 90 % of 200, two standard errors
