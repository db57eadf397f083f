"""Which tests of an axis count together, and what they tell: errors and tables that are known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.planning.consistent_tests import select_consistent, with_active_corrections
from compwright.planning.wanted_correction import MeasuredError, measured_error, observed_tests
from compwright.records.axis import Axis, Direction, Motion
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.facts import AxisFacts
from compwright.records.plan import PlannedTest
from planning_samples import MINUS, PLUS, TARGETS, UM, Floats, axis_of, readings_of

pytestmark = pytest.mark.short_estimate

NODES = np.linspace(0.0, 1000.0, 41)
SAW = AxisCompensation(
    address="X",
    kind=axis_of().kind,
    positions=NODES,
    positive=5.0 * UM * np.sin(NODES / 40.0),
    negative=5.0 * UM * np.sin(NODES / 40.0) + 2.0 * UM,
)
STATES = {
    "off": ControlState(format="any", axes={}),
    "on": ControlState(format="any", axes={"X": SAW}),
}
DITHERED = 1000.0 * (np.arange(23) + 0.5 + np.random.default_rng(17).uniform(-0.3, 0.3, 23)) / 23.0
WHERE = np.linspace(30.0, 970.0, 48)


def truth(x: Floats) -> Floats:
    return 6.0 * UM * np.sin(x / 200.0) + 1e-5 * x


def planned(
    name: str,
    state: str,
    *,
    seed: int = 0,
    sign: float = 1.0,
    targets: Floats = TARGETS,
    motion: Motion = "feed",
) -> PlannedTest:
    """Five runs of an axis with a lost motion of 4 µm, 0.3 µm of noise, and what acts in a state."""
    rng = np.random.default_rng(seed)
    table = STATES[state].axes.get("X") if state in STATES else None
    blocks = []
    for side in Direction:
        error = sign * (truth(targets) - side.sign * 2.0 * UM)
        if table is not None:
            error = error + table.at(targets, side)
        blocks.append(error[:, None] + 0.3 * UM * rng.standard_normal((targets.size, 5)))
    test = readings_of(blocks[0], blocks[1], targets, name=name)
    return PlannedTest(test=test, measured_in=state, motion=motion)


def told(
    *tests: PlannedTest, axis: Axis | None = None, states: dict[str, ControlState] | None = None
) -> tuple[list[bool], MeasuredError, list[str]]:
    """Which tests count, the error that they tell, and the doubts."""
    given = STATES if states is None else states
    axis = axis or axis_of()
    active = None
    if tests[0].measured_in in given:
        active = given[tests[0].measured_in].axes.get("X")
    acted = with_active_corrections(tests, axis, given)
    counted, error, doubts = select_consistent(acted, observed_tests(acted, active), axis, active)
    return [test.acted is not None for test in counted], error, [each.code for each in doubts]


def off_truth(error: MeasuredError, side: Direction) -> float:
    """Largest difference of the axis' own error from the truth, but for the datum."""
    left = error.own.summary(WHERE).mean(side) - truth(WHERE) + side.sign * 2.0 * UM
    both = error.own.summary(WHERE)
    datum = np.mean(0.5 * (both.mean_positive + both.mean_negative) - truth(WHERE))
    return float(np.max(np.abs(left - datum)))


@pytest.mark.full_estimate
@pytest.mark.parametrize("order", [("off", "on"), ("on", "off")])
def test_compensation_on_and_off_tell_the_same_bare_error(order: tuple[str, str]) -> None:
    tests = [planned(state, state, seed=k, targets=DITHERED) for k, state in enumerate(order)]
    counts, error, doubts = told(*tests)
    assert (counts, doubts) == ([True, True], [])
    for side in (PLUS, MINUS):
        # 20 readings of 0.3 µm at each target: 0.1 µm, and five times that at the worst of 48 places.
        assert off_truth(error, side) < 0.5 * UM
    alone = told(tests[0])[1]
    ratio = np.mean(error.own.summary(WHERE).std_positive) / np.mean(
        alone.own.summary(WHERE).std_positive
    )
    # sqrt(1/2) of the noise; what is not known of the shape of the error lessens more slowly.
    assert 0.6 < ratio < 0.95
    # What acted in the first is put back into what is said of the axis as it was measured.
    active = STATES[order[0]].axes.get("X")
    added = 0.0 if active is None else active.at(WHERE, PLUS)
    own = error.own.summary(WHERE).mean_positive
    assert error.summary(WHERE).mean_positive == pytest.approx(own + added, abs=1e-12)


def test_a_test_that_contradicts_the_first_does_not_count() -> None:
    counts, error, doubts = told(
        planned("a", "off"),
        planned("turned", "off", seed=1, sign=-1.0),
        planned("b", "off", seed=2),
    )
    assert counts == [True, False, True]
    assert doubts == ["CW-T036"]
    assert off_truth(error, PLUS) < 1.0 * UM
    assert error.counted == (0, None, 1)


def test_a_short_test_first_is_contradicted_by_what_the_long_one_expects() -> None:
    """Over 60 mm the turned error is a straight line, which alone says nothing of the rest."""
    near = np.linspace(400.0, 460.0, 7)
    counts, _, doubts = told(
        planned("near", "off", sign=-1.0, targets=near), planned("whole", "off", seed=1)
    )
    assert (counts, doubts) == ([True, False], ["CW-T036"])


@pytest.mark.parametrize(
    ("states", "first", "second", "motion", "counts"),
    [
        (("off", "on"), "off", "elsewhen", "feed", False),  # nobody says what acted in the second
        ((), "unknown", "unknown", "feed", True),  # one unknown state: the same acted in both
        ((), "unknown", "unknown", "rapid", False),  # ... but for the backlash at rapid traverse
        ((), "unknown", "other", "feed", False),
    ],
)
def test_only_known_states_count_together(
    states: tuple[str, ...], first: str, second: str, motion: Motion, *, counts: bool
) -> None:
    given = {name: STATES[name] for name in states}
    tests = planned("a", first), planned("b", second, seed=1, motion=motion)
    assert told(*tests, states=given)[0] == [True, counts]


def test_the_other_backlash_of_rapid_traverse_is_taken_out() -> None:
    """3 µm more backlash acts at rapid traverse: that test shows 3 µm less of lost motion."""
    facts = {"X": AxisFacts(rapid_more=3.0 * UM)}
    state = ControlState(format="any", axes={}, facts=facts)
    slow, fast = planned("slow", "off"), planned("fast", "off", seed=1, motion="rapid")
    shown = replace(fast.test, negative=fast.test.negative - 3.0 * UM)
    counts, error, doubts = told(slow, replace(fast, test=shown), states={"off": state})
    assert (counts, doubts) == ([True, True], [])
    own = error.own.summary(WHERE)
    # 11 targets, ten readings either way: 0.3 sqrt(2 / 110) = 0.04 µm, four times that.
    lost = float(np.mean(own.mean_positive - own.mean_negative))
    assert lost == pytest.approx(-4.0 * UM, abs=0.16 * UM)


def test_a_test_of_a_single_target_says_nothing_and_refuses_nothing() -> None:
    single = planned("one", "off", seed=1, targets=np.array([300.0]))
    assert told(planned("a", "off"), single)[0] == [True, False]


def test_every_test_is_predicted_with_its_own_noise() -> None:
    """One scatters by 0.3 µm, the other by 3 µm; a third does not count but has its own too."""
    loud = planned("loud", "off", seed=1)
    rng = np.random.default_rng(9)
    more = [3.0 * UM * rng.standard_normal((TARGETS.size, 5)) for _ in Direction]
    test = loud.test
    noisy = replace(test, positive=test.positive + more[0], negative=test.negative + more[1])
    turned = replace(noisy, positive=-noisy.positive, negative=-noisy.negative)
    tests = planned("quiet", "off"), replace(loud, test=noisy), replace(loud, test=turned)
    counts, error, _ = told(*tests)
    assert counts == [True, True, False]
    sizes = [np.median(error.draw(TARGETS, 300, rng, place).noise.sigma) for place in range(3)]
    # 88 degrees of freedom: 7.5 % of s, four times that.
    assert np.array(sizes) / UM == pytest.approx([0.3, 3.0, 3.0], rel=0.3)


def rising(slope: float, *, wave: float = 0.0, seed: int = 1) -> PlannedTest:
    """A test like "a" at targets of its own, ``slope`` mm/mm steeper, with a wave of 12 mm."""
    where = 1000.0 * (np.arange(15) + 0.5 + np.random.default_rng(3).uniform(-0.3, 0.3, 15)) / 15.0
    return with_more(planned("b", "off", seed=seed, targets=where), slope, wave)


def with_more(one: PlannedTest, slope: float, wave: float) -> PlannedTest:
    x = one.test.targets
    more = (slope * x + wave * np.sin(2.0 * np.pi * x / 12.0))[:, np.newaxis]
    test = replace(one.test, positive=one.test.positive + more, negative=one.test.negative + more)
    return replace(one, test=test)


def slope_told(error: MeasuredError) -> tuple[float, float] | None:
    """The difference of two slopes and its standard error, µm/m, by the values of the finding."""
    for finding in error.findings:
        if finding.code == "CW-E028":
            return finding.values["difference"], finding.values["error"]
    return None


@pytest.mark.full_estimate
@pytest.mark.parametrize("slope", [4.0, -6.0])
def test_another_slope_of_a_second_test_is_told_and_is_no_period(slope: float) -> None:
    """A third and half of a kelvin of steel, 11.5 µm/m each. The slope of the axis stays that
    of the first test.
    """
    first = planned("a", "off", targets=DITHERED)
    counts, error, doubts = told(first, rising(1e-6 * slope))
    assert (counts, doubts) == ([True, True], [])
    assert [each for each in error.own.periods if each.probability > 0.2] == []
    found = slope_told(error)
    assert found is not None
    # Slopes of ten readings of 0.3 µm at 23 and 15 targets over 1 m: sqrt(12 / 380) 0.3 µm/m and
    # more, 0.1 µm/m; what is unknown of the curve adds to that.
    assert found[0] == pytest.approx(slope, abs=1.0)
    assert 0.05 <= found[1] <= 0.6
    alone = told(first)[1].own.summary(WHERE)
    both = error.own.summary(WHERE)
    rise = np.polyfit(WHERE, both.mean_positive - alone.mean_positive, 1)[0]
    assert abs(rise) < 0.5e-6


def test_equal_slopes_are_not_told() -> None:
    assert slope_told(told(planned("a", "off", targets=DITHERED), rising(0.0))[1]) is None


@pytest.mark.full_estimate
def test_a_wave_that_both_tests_show_is_found_beside_another_slope() -> None:
    first = with_more(planned("a", "off", targets=DITHERED), 0.0, 2.0 * UM)
    error = told(first, rising(4e-6, wave=2.0 * UM))[1]
    (period,) = [each.period for each in error.own.periods if each.named]
    assert period == pytest.approx(12.0, rel=0.01)


def test_a_short_test_before_the_whole_one_leaves_the_slope_to_that() -> None:
    """A third of the travel tells little of the slope: that of the whole test counts, and its band
    over the travel is that of the whole test alone (11.5 µm/m would add some 5 µm at the ends).
    """
    near, whole = planned("near", "off", targets=DITHERED[8:15]), rising(0.0)
    spans = []
    for tests in ((near, whole), (whole,)):
        acted = with_active_corrections(tests, axis_of(), STATES)
        error = measured_error(acted, observed_tests(acted, None), axis_of(), None)
        spans.append(np.mean(error.own.summary(WHERE).std_positive))
    assert spans[0] < spans[1] + 0.3 * UM


def one_way(one: PlannedTest, side: Direction) -> PlannedTest:
    """The same test, approached in one direction only."""
    none = np.empty((one.test.targets.size, 0))
    if side is PLUS:
        return replace(one, test=replace(one.test, negative=none))
    return replace(one, test=replace(one.test, positive=none))


@pytest.mark.parametrize("side", [PLUS, MINUS])
@pytest.mark.parametrize("first", [True, False])
def test_a_test_in_one_direction_says_nothing_of_the_other(side: Direction, *, first: bool) -> None:
    """4 µm of lost motion, which the one test shows and the other cannot, are no contradiction."""
    both, single = planned("both", "off"), one_way(planned("one", "off", seed=1), side)
    tests = (single, both) if first else (both, single)
    counts, error, doubts = told(*tests)
    assert (counts, doubts) == ([True, True], [])
    own = error.own.summary(WHERE)
    lost = float(np.mean(own.mean_positive - own.mean_negative))
    # Five readings of 0.3 µm either way at 11 targets: 0.06 µm, four times that.
    assert lost == pytest.approx(-4.0 * UM, abs=0.23 * UM)


def test_tests_in_opposite_directions_do_not_contradict_each_other() -> None:
    up = one_way(planned("up", "off", seed=1), PLUS)
    down = one_way(planned("down", "off", seed=2), MINUS)
    assert told(up, down)[0] == [True, True]


def test_a_test_is_not_contradicted_by_its_own_noise() -> None:
    """6 µm beside 0.3 µm: the means of five readings scatter by 2.7 µm, as much as half the error."""
    for seed in range(4):
        loud = planned("loud", "off", seed=seed + 1, targets=DITHERED)
        rng = np.random.default_rng(seed)
        more = [6.0 * UM * rng.standard_normal((DITHERED.size, 5)) for _ in Direction]
        test = loud.test
        noisy = replace(test, positive=test.positive + more[0], negative=test.negative + more[1])
        assert told(planned("quiet", "off"), replace(loud, test=noisy))[2] == []


@pytest.mark.full_estimate
@pytest.mark.parametrize("first", [True, False])
def test_a_wave_that_equal_spacing_hides_is_no_contradiction(*, first: bool) -> None:
    """3 µm over 10 mm: at targets 40 mm apart a constant, at others a wave."""
    even = planned("even", "off", targets=np.arange(40.0, 980.0, 40.0))
    other = planned("other", "off", seed=1, targets=np.round(DITHERED, 3))
    tests = []
    for each in (even, other):
        wave = 3.0 * UM * np.sin(2.0 * np.pi * each.test.targets / 10.0 + 1.0)[:, np.newaxis]
        test = each.test
        shown = replace(test, positive=test.positive + wave, negative=test.negative + wave)
        tests.append(replace(each, test=shown))
    counts, error, doubts = told(*(tests if first else tests[::-1]))
    assert (counts, doubts) == ([True, True], [])
    (period,) = [each.period for each in error.own.periods if each.named]
    assert period == pytest.approx(10.0, rel=0.002)
