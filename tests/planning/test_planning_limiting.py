"""What limits an axis, of axes whose error, scatter and table are known by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.estimation.axis import Draws
from compwright.planning.axis_fits import fit_all
from compwright.planning.axis_work import AxisWork
from compwright.planning.drift_doubts import drift_or_reversal
from compwright.planning.limiting_causes import (
    DRIFT,
    NO_TABLE,
    NOISE,
    OUTLIERS,
    TRAVERSES,
    UNKNOWN,
    what_limits,
)
from compwright.planning.point_count_tradeoff import point_count_tradeoff
from compwright.planning.shortfalls import PERIOD, QUANTUM, REVERSAL, shortfalls
from compwright.planning.simulated_repeat_tests import RepeatConditions, fresh_tests
from compwright.planning.table_verdict import verdict
from compwright.prediction.active_corrections import no_correction
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, no_compensation
from compwright.records.estimate import AxisPeriod
from compwright.records.fitted_table import Mode, TableRequest
from compwright.records.limits import LimitingCauses, PointCountOption
from compwright.words.sentences import say
from planning_samples import (
    MINUS,
    PLUS,
    TARGETS,
    UM,
    Curve,
    Floats,
    KnownAxis,
    axis_of,
    capacity_of,
    work_of,
)

pytestmark = pytest.mark.short_estimate

BENT = 4.0 * UM
ONE_CURVE: dict[str, Any] = {"curves": 1, "backlash_quantum": 1e-7, "backlash_range": (-1.0, 1.0)}


def fitted(
    known: KnownAxis,
    *,
    spacing: float = 50.0,
    axis: Axis | None = None,
    active: AxisCompensation | None = None,
    mode: Mode = "auto",
    **limits: Any,
) -> AxisWork:
    """An axis whose table is fitted to its known error, on nodes every ``spacing`` mm."""
    axis = axis or axis_of()
    bare = no_compensation(axis.address, axis.kind)
    work = work_of(known, axis, active=active or bare)
    dense = np.linspace(*axis.travel, 4001)
    request = TableRequest(start=0.0, end=1000.0, spacing=spacing, mode=mode)
    periods = tuple(AxisPeriod(one, 1.0, "job") for one in axis.screw_pitch)
    estimate = replace(known.summary(dense), periods=periods)
    planned = replace(work.planned, request=request, estimate=estimate)

    def capacity(axis: Axis, *, one_curve: bool = False) -> Capacity:
        return replace(capacity_of(axis, one_curve=one_curve), **{"quantum": 1e-7, **limits})

    return fit_all({"X": replace(work, planned=planned)}, capacity, "job.yaml")["X"]


def limits_of(work: AxisWork) -> LimitingCauses:
    table = work.planned.fitted
    fresh = fresh_tests(work.results[0], work.posterior, work.planned.axis, RepeatConditions())
    found = what_limits(work, no_correction if table is None else table.compensation.at, fresh)
    assert found is not None
    return found


def causes_of(work: AxisWork) -> dict[str, float]:
    """What each cause makes of A, µm."""
    return {cause.cause: cause.value / UM for cause in limits_of(work).causes}


def both(curve: Curve, **words: float) -> KnownAxis:
    return KnownAxis(curve, curve, **words)


def test_without_scatter_nothing_limits_a_table_that_holds_all() -> None:
    found = limits_of(fitted(both(lambda x: 30e-6 * x)))
    assert found.parameter == "A"
    # the slope over the new targets, which leave up to 8 % of the travel out at its ends
    assert 27.0 < found.now / UM < 30.0
    assert found.then / UM == pytest.approx(0.0, abs=1e-3)
    assert all(abs(cause.value) < 1e-6 for cause in found.causes)


def test_scatter_is_all_that_is_left_where_the_table_holds_all() -> None:
    """Without scatter nothing is left, so that all of A is noise, and no table goes lower."""
    found = limits_of(fitted(both(lambda x: 30e-6 * x, noise=1.0 * UM)))
    assert found.least == pytest.approx(found.then, abs=1e-3 * UM)
    noise = next(cause for cause in found.causes if cause.cause == NOISE)
    assert noise.value == pytest.approx(found.then, abs=1e-3 * UM)
    # the same test by hand: 11 targets in 2 directions, two readings of 1 µm each, k = 2
    readings = np.random.default_rng(1).standard_normal((4000, 22, 2))
    mean, s = readings.mean(axis=2), readings.std(axis=2, ddof=1)
    by_hand = np.median((mean + 2 * s).max(axis=1) - (mean - 2 * s).min(axis=1))
    assert found.then / UM == pytest.approx(by_hand, rel=0.04)  # both of some thousand draws


def test_a_period_that_the_nodes_cannot_hold() -> None:
    """A wave of ±3 µm over 10 mm, nodes every 50 mm: 6 µm at most, and as near to it as eleven
    targets come, arcsine law; without that cause nothing.
    """
    wave = both(lambda x: 3.0 * UM * np.sin(2 * np.pi * x / 10.0))
    work = fitted(wave, axis=axis_of(screw_pitch=(10.0,)))
    found = causes_of(work)
    assert found[PERIOD] == pytest.approx(limits_of(work).then / UM, abs=0.05)
    assert 4.5 < found[PERIOD] <= 6.0 + 1e-6
    assert set(found) - {PERIOD} <= {NOISE, UNKNOWN, "spacing of the points", QUANTUM}


def test_a_reversal_that_one_value_cannot_hold() -> None:
    """The reversal goes from -8 to +8 µm over the travel: one curve and one value leave ±4 µm in
    each direction at the ends, two curves nothing.
    """
    known = KnownAxis(lambda x: BENT * (x / 500.0 - 1.0), lambda x: -BENT * (x / 500.0 - 1.0))
    single = fitted(known, axis=axis_of(reference=500.0), **ONE_CURVE)
    found = causes_of(single)
    assert found[REVERSAL] == pytest.approx(limits_of(single).then / UM, abs=1e-3)
    assert 7.0 < found[REVERSAL] < 8.0
    twice = fitted(known, curves=2)
    assert limits_of(twice).then / UM == pytest.approx(0.0, abs=1e-3)


def test_what_whole_quanta_leave() -> None:
    """Quanta of 4 µm, ramps between the nodes: no more than half a quantum either way."""
    work = fitted(both(lambda x: 30e-6 * x + 5 * UM * np.sin(x / 90.0)), quantum=4.0 * UM)
    found = causes_of(work)
    assert 1.0 < found[QUANTUM] <= 4.0


def test_without_a_table_the_known_error_is_the_limit() -> None:
    work = work_of(both(lambda x: 30e-6 * x, noise=1.0 * UM))
    found = causes_of(work)
    assert found[NO_TABLE] > 20.0
    assert max(found, key=lambda cause: found[cause]) == NO_TABLE


def test_a_period_that_no_table_of_the_control_holds_is_the_cause() -> None:
    """Where none is written because of it, the period is what limits the axis, no missing table."""
    wave = both(lambda x: 3.0 * UM * np.sin(2 * np.pi * x / 5.0), noise=0.3 * UM)
    work = fitted(wave, axis=axis_of(screw_pitch=(5.0,)), max_points=256)
    bare = replace(
        work,
        refused=say("as_written", text="it gains nothing"),
        planned=replace(work.planned, fitted=None),
    )
    found = limits_of(bare)
    values = {cause.cause: cause.value / UM for cause in found.causes}
    assert values[PERIOD] > 4.0
    assert abs(values.get(NO_TABLE, 0.0)) < 0.1
    (told,) = verdict(work.planned.axis, found, tabled=False, refused=True)
    assert told.code == "CW-P150"
    assert PERIOD in told.message
    assert "CW-F002" in told.message
    inclined = both(lambda x: 30e-6 * x + wave.plus(x), noise=0.3 * UM)
    work = fitted(inclined, axis=axis_of(screw_pitch=(5.0,)), max_points=256)
    bare = replace(
        work, refused=say("as_written", text="as asked"), planned=replace(work.planned, fitted=None)
    )
    assert causes_of(bare)[NO_TABLE] > 20.0


@pytest.mark.parametrize(
    "limits",
    [
        {},
        {"spacing": 8.0, "max_points": 200},  # two to three points per period: in part
        {"quantum": 2.0 * UM},
        {"curves": 1, "backlash_quantum": UM, "backlash_range": (0.0, 3 * UM)},
        {"curves": 1},
        {"value_range": (-9.0 * UM, 9.0 * UM)},
        {"interpolation": "step"},
    ],
)
def test_the_shortfalls_are_all_that_is_not_held(limits: dict[str, Any]) -> None:
    """Their sum is what acts less what is wanted, everywhere, in both directions."""
    known = KnownAxis(
        lambda x: 10e-6 * x + 5 * UM * np.sin(x / 60.0) + 2 * UM * np.sin(2 * np.pi * x / 20.0),
        lambda x: 12e-6 * x + 5 * UM * np.cos(x / 70.0) + 2 * UM * np.sin(2 * np.pi * x / 20.0),
        noise=8.0 * UM,  # below it a table out of range is not refused
    )
    work = fitted(known, axis=axis_of(screw_pitch=(20.0,)), **limits)
    wanted, table, capacity = work.planned.wanted, work.planned.fitted, work.capacity
    assert wanted is not None
    assert table is not None
    assert capacity is not None
    where = np.linspace(0.0, 1000.0, 733)
    parts = shortfalls(wanted, table, capacity)
    left = [
        table.compensation.at(where, way)
        - np.interp(where, wanted.positions, wanted.total(way))
        - sum(part.curve(where, way) for part in parts)
        for way in Direction
    ]
    assert np.ptp(np.concatenate(left)) < 1e-12


def said(known: KnownAxis, **words: Any) -> list[tuple[str, str]]:
    """Codes and messages of the verdict."""
    work = fitted(known, **words)
    found = limits_of(work)
    told = verdict(work.planned.axis, found, tabled=True, refused=False)
    return [(finding.code, finding.message) for finding in told]


def test_a_table_that_cures_the_axis_gets_no_verdict() -> None:
    assert said(both(lambda x: 60e-6 * x, noise=1.0 * UM)) == []


def test_where_scatter_dominates_a_table_does_not_help() -> None:
    """1 µm of slope under a scatter of 10 µm: a mechanic, not a table."""
    ((code, message),) = said(both(lambda x: 1e-6 * x, noise=10.0 * UM))
    assert code == "CW-P150"
    assert "will not help" in message
    assert "mechanic" in message


def test_where_a_table_helps_some_the_rest_is_told() -> None:
    """60 µm of slope over a scatter that alone gives about as much: what each makes is said."""
    known = both(lambda x: 60e-6 * x, noise=10.0 * UM)
    ((code, message),) = said(known)
    assert code == "CW-P151"
    found = limits_of(fitted(known))
    assert f"{100 * (1 - found.then / found.now):.0f} %" in message
    assert f"{100 * found.least / found.now:.0f} % of the present value is scatter" in message


class Restless(KnownAxis):
    """A known axis whose noise has more parts: numbers of `NoiseDraws` by name, mm."""

    def __init__(self, parts: dict[str, float]) -> None:
        super().__init__(lambda x: 1e-6 * x, lambda x: 1e-6 * x, noise=0.3 * UM)
        self.parts = parts

    def draw(self, positions: Floats, count: int, rng: np.random.Generator, test: int = 0) -> Draws:
        draws = super().draw(positions, count, rng, test)
        more: dict[str, Any] = {name: np.full(count, one) for name, one in self.parts.items()}
        return replace(draws, noise=replace(draws.noise, **more))


@pytest.mark.parametrize(
    ("parts", "cause", "advice"),
    [
        ({"drift": 10.0 * UM}, DRIFT, "warm it up"),
        ({"offset": 3.0 * UM}, TRAVERSES, "firm"),
        ({"outlier_share": 0.1, "outlier_size": 30.0}, OUTLIERS, "disturbs"),
    ],
)
def test_what_no_table_takes_out_is_named(parts: dict[str, float], cause: str, advice: str) -> None:
    """Under a small error and small noise one part of the noise makes nearly all of A."""
    known = Restless(parts)
    found = limits_of(fitted(known))
    first = found.causes[0]
    assert first.cause == cause
    assert 0.6 * found.then < first.value < found.then
    ((code, message),) = said(known)
    assert code == "CW-P150"
    assert cause in message
    assert advice in message


def test_a_reversal_that_moves_along_the_travel_is_named() -> None:
    known = KnownAxis(lambda x: BENT * (x / 500.0 - 1.0), lambda x: -BENT * (x / 500.0 - 1.0))
    ((code, message),) = said(known, axis=axis_of(reference=500.0), **ONE_CURVE)
    assert code == "CW-P150"
    assert "reversal changes along the travel" in message


def test_what_is_left_after_a_table_that_helps_is_named() -> None:
    """30 µm of slope, which the one table takes away, and a reversal that it cannot hold."""
    known = KnownAxis(
        lambda x: 30e-6 * x + BENT * (x / 500.0 - 1.0),
        lambda x: 30e-6 * x - BENT * (x / 500.0 - 1.0),
        noise=0.1 * UM,
    )
    ((code, message),) = said(known, axis=axis_of(reference=500.0), **ONE_CURVE)
    assert code == "CW-P151"
    assert "Most of the rest is reversal that changes along the travel" in message


def test_a_cause_has_its_name_in_the_language_of_the_page() -> None:
    work = fitted(Restless({"drift": 10.0 * UM}))
    (finding,) = verdict(work.planned.axis, limits_of(work), tabled=True, refused=False)
    assert "größte Ursache: Drift (" in finding.sentence.text("de")
    assert "plus grande cause : dérive (" in finding.sentence.text("fr")
    assert "причина — дрейф (" in finding.sentence.text("ru")


def test_directions_are_those_of_the_machine() -> None:
    """One curve, the reversal varies: what is left has opposite signs in the two directions."""
    known = KnownAxis(lambda x: BENT * (x / 500.0 - 1.0), lambda x: -BENT * (x / 500.0 - 1.0))
    work = fitted(known, axis=axis_of(reference=500.0), **ONE_CURVE)
    wanted, table, capacity = work.planned.wanted, work.planned.fitted, work.capacity
    assert wanted is not None
    assert table is not None
    assert capacity is not None
    parts = {part.cause: part.curve for part in shortfalls(wanted, table, capacity)}
    end = np.array([1000.0])
    # the axis is 4 µm too far at the end in +, where the one curve does nothing: the shortfall is
    # what acts less what is wanted, 0 - (-4)
    assert parts[REVERSAL](end, PLUS)[0] / UM == pytest.approx(4.0, abs=0.01)
    assert parts[REVERSAL](end, MINUS)[0] / UM == pytest.approx(-4.0, abs=0.01)


def worth_of(work: AxisWork) -> list[PointCountOption]:
    table = work.planned.fitted
    assert table is not None
    fresh = fresh_tests(work.results[0], work.posterior, work.planned.axis, RepeatConditions())
    return list(point_count_tradeoff(work, table.compensation.at, fresh, "A"))


@pytest.mark.full_estimate
def test_a_point_is_worth_what_it_takes_away() -> None:
    """A parabola of 40 µm under straight lines between nodes h apart: what is left is in
    proportion to h^2, and not more than of one line from its zero on, 0.75 x - x^2: 0.39.
    """
    known = both(lambda x: 40 * UM * (x / 1000.0) ** 2)
    found = worth_of(fitted(known, spacing=50.0, max_points=200))
    assert [one.points for one in found] == sorted(one.points for one in found)
    assert [one.points for one in found if one.written] == [21]
    assert found[0].points == 2
    assert 100 < found[-1].points <= 200
    for one in found:
        assert one.median / UM <= 40.0 * 0.391 * (one.spacing / 1000.0) ** 2 + 1e-6
        assert one.p05 <= one.median <= one.p95
    assert found[0].median / UM > 9.0  # targets come near the ends, and near the middle


@pytest.mark.full_estimate
def test_what_acted_during_the_test_is_taken_off_every_size() -> None:
    """20 µm of slope that the old table made, in an axis without error of its own: two points take
    it away as well as twenty-one.
    """
    line = np.array([0.0, 20.0 * UM])
    old = AxisCompensation(
        address="X",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 1000.0]),
        positive=line,
        negative=line,
    )
    known = both(lambda x: 20e-6 * x)
    work = fitted(known, spacing=50.0, active=old)
    assert [one.median / UM for one in worth_of(work)] == pytest.approx([0.0] * 8, abs=0.01)


@pytest.mark.full_estimate
def test_nothing_is_shown_where_there_is_nothing_to_choose() -> None:
    known = both(lambda x: 40 * UM * (x / 1000.0) ** 2)
    work = fitted(known, spacing=50.0)
    assert work.capacity is not None
    only = replace(work, capacity=replace(work.capacity, points=tuple(np.linspace(0, 1000, 21))))
    assert worth_of(only) == []


@pytest.mark.full_estimate
def test_the_grid_that_is_there_is_marked() -> None:
    known = both(lambda x: 40 * UM * (x / 1000.0) ** 2)
    work = fitted(known, spacing=50.0, there=(0.0, 250.0, 500.0, 750.0, 1000.0))
    found = worth_of(work)
    assert [one.points for one in found if one.there] == [5]
    assert [one.points for one in found if one.written] == [21]
    assert work.capacity is not None
    stays = replace(work, capacity=replace(work.capacity, there=tuple(np.linspace(0, 1000, 21))))
    (mark,) = [one for one in worth_of(stays) if one.there]
    assert mark.written


class Warming(KnownAxis):
    """A constant play of 4 µm on an axis that moves by 6 µm while it is measured, reading by
    reading: two runs of 11 targets up and down again, the means of which are the known error.
    """

    def __init__(self, sign: float, drift: float) -> None:
        order = np.arange(TARGETS.size)
        up = np.mean([22 * run + order for run in range(2)], axis=0)
        down = np.mean([22 * run + 21 - order for run in range(2)], axis=0)
        a_reading = sign * 6.0 * UM / 22.0  # 22 readings from one run to the next
        super().__init__(
            lambda x: np.interp(x, TARGETS, a_reading * up) - 2.0 * UM,
            lambda x: np.interp(x, TARGETS, a_reading * down) + 2.0 * UM,
            noise=0.3 * UM,
            odds=9.0,
        )
        self.drift = drift

    def draw(self, positions: Floats, count: int, rng: np.random.Generator, test: int = 0) -> Draws:
        draws = super().draw(positions, count, rng, test)
        return replace(draws, noise=replace(draws.noise, drift=np.full(count, self.drift)))


def drift_told(known: KnownAxis, **limits: Any) -> list[str]:
    work = fitted(known, **limits)
    fresh = fresh_tests(work.results[0], work.posterior, work.planned.axis, RepeatConditions())
    return [finding.message for finding in drift_or_reversal(work, fresh)]


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_two_tables_that_may_hold_a_drift_are_doubted(sign: float) -> None:
    (message,) = drift_told(Warming(sign, sign * 6.0 * UM), mode="bidirectional")
    rise = sign * 6.0 * 20 / 22  # the low end waits 21 readings for its second direction, the
    assert f"changes by {rise:+.2f} µm" in message  # high end one
    assert f"{sign * 6.0:+.2f} µm from the first run to the last" in message


@pytest.mark.parametrize(("drift", "mode"), [(6.0, "single"), (0.0, "bidirectional")])
def test_one_table_is_taken_where_two_may_hold_a_drift(drift: float, mode: str) -> None:
    known = Warming(1.0, drift * UM)
    table = fitted(known).planned.fitted
    assert table is not None
    assert table.mode == mode
    assert ("drift" in table.mode_reason) == (mode == "single")


def test_a_reversal_that_no_drift_explains_is_not_doubted() -> None:
    assert drift_told(Warming(1.0, 0.0)) == []  # no drift from run to run
    assert drift_told(Warming(1.0, -6.0 * UM)) == []  # it would have changed the other way
    assert drift_told(Warming(1.0, 20.0 * UM)) == []  # or by much more


class Cold(Warming):
    """The same with ``play`` µm of lost motion instead of 4."""

    def __init__(self, sign: float, drift: float, play: float) -> None:
        super().__init__(sign, drift)
        plus, minus, less = self.plus, self.minus, 0.5 * (play - 4.0) * UM
        self.plus = lambda x: plus(x) - less
        self.minus = lambda x: minus(x) + less


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("play", [0.0, 4.0, -3.0])
def test_a_backlash_value_that_may_hold_a_drift_is_doubted(sign: float, play: float) -> None:
    """Between its two directions a target waits 11 readings on the average, half a run: from one
    run to the next the axis drifts by 6 µm, so 3 µm of the mean reversal are drift.
    """
    centre = axis_of(reference=500.0)
    work = fitted(Cold(sign, sign * 6.0 * UM, play), axis=centre, **ONE_CURVE)
    table = work.planned.fitted
    assert table is not None
    assert table.mode == "single"
    assert table.compensation.backlash == pytest.approx((play + sign * 3.0) * UM, abs=0.1 * UM)
    (message,) = drift_told(Cold(sign, sign * 6.0 * UM, play), axis=centre, **ONE_CURVE)
    assert f"mean reversal is {-play - sign * 3.0 + 0.0:+.2f} µm" in message
    assert f"{sign * 6.0:+.2f} µm from the first run to the last" in message
    assert f"changes the mean reversal by {-sign * 3.0:+.2f} µm" in message


class Even(KnownAxis):
    """A reversal of 7 µm everywhere, on an axis that drifts by 6 µm from run to run."""

    def __init__(self) -> None:
        super().__init__(
            lambda x: np.full_like(x, -3.5 * UM), lambda x: np.full_like(x, 3.5 * UM), odds=-9.0
        )

    def draw(self, positions: Floats, count: int, rng: np.random.Generator, test: int = 0) -> Draws:
        draws = super().draw(positions, count, rng, test)
        return replace(draws, noise=replace(draws.noise, drift=np.full(count, 6.0 * UM)))


def test_a_constant_between_two_curves_is_doubted_like_a_backlash_value() -> None:
    """A control of two curves without a backlash value holds the same constant in them."""
    work = fitted(Even())
    assert work.planned.fitted is not None
    assert work.planned.fitted.mode == "single"
    (message,) = drift_told(Even())
    assert "mean reversal is -7.00 µm" in message
    assert "changes the mean reversal by -3.00 µm" in message


def test_a_backlash_value_that_no_drift_explains_is_not_doubted() -> None:
    centre = axis_of(reference=500.0)
    assert drift_told(Warming(1.0, 0.0), axis=centre, **ONE_CURVE) == []
    # 0.1 of 7 µm, less than half of the noise of a reading.
    assert drift_told(Warming(1.0, 0.2 * UM), axis=centre, **ONE_CURVE) == []
    # 1 of 33 µm
    assert drift_told(Cold(1.0, 2.0 * UM, 30.0), axis=centre, **ONE_CURVE) == []
