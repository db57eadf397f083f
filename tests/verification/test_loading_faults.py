"""Every fault of loading, put into a simulated axis by formulas of this file, is found by its name."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.records.axis import AxisKind, FloatArray
from compwright.records.correction import AxisCompensation, no_compensation
from compwright.records.noise import normal_noise
from compwright.records.positioning import PositioningTest
from compwright.records.stored_table import StoredTable
from compwright.records.verification import LoadingName, LoadingVerdict
from compwright.verification.hypothesis import Loading
from compwright.verification.likelihood import (
    Curves,
    ErrorBelief,
    after_means,
    belief_of,
    fits_of,
)
from compwright.verification.loading import judge_loading
from compwright.verification.loading_hypotheses import loading_hypotheses
from compwright.verification.loading_messages import candidate_text
from compwright.verification.measurement_cases import (
    MeasurementCase,
    measurement_cases,
    other_axis_case,
    unit_cases,
)
from compwright.words.sentences import Language, say
from compwright.workflow.verify.verified_axis import _looks
from loadings import known, means_of
from reporting_samples import english_words

UM = 1e-3  # mm
NOISE = 0.5 * UM
RUNS = 5
TARGETS = np.array([11.0, 52.0, 88.0, 131.0, 169.0, 213.0, 252.0, 289.0, 333.0, 371.0, 389.0])
NODES = np.linspace(0.0, 400.0, 17)
WAVES = 6 * UM * np.sin(NODES / 47.0) + 4 * UM * np.sin(NODES / 23.0) + 0.02 * UM * NODES
WAVES = WAVES - WAVES[0]
#: Of the negative direction: 3 µm more at one end than at the other.
BENT = WAVES - 5 * UM - 3 * UM * NODES / 400.0
OLD = 5 * UM * np.sin(NODES / 61.0 + 1.0) - 5 * UM * np.sin(1.0)
OTHER = 7 * UM * np.cos(NODES / 37.0) - 7 * UM
LOST = 4 * UM
#: Rows of steps from node to node, each for the section below its node, typed in from the last to
#: the first: the first row, which has no section, now ends the table with no step at all.
TURNED_ROWS = np.concatenate([[0.0], np.cumsum(np.append(np.diff(WAVES)[::-1][1:], 0.0))])


def compensation(
    positive: FloatArray,
    negative: FloatArray | None = None,
    backlash: float = 0.0,
    address: str = "X",
    nodes: FloatArray = NODES,
) -> AxisCompensation:
    return AxisCompensation(
        address=address,
        kind=AxisKind.LINEAR,
        positions=nodes,
        positive=positive,
        negative=positive if negative is None else negative,
        backlash=backlash,
    )


NONE = no_compensation("X", AxisKind.LINEAR)
ONE_TABLE = compensation(WAVES, backlash=LOST)
TWO_TABLES = compensation(WAVES, BENT)


def stored(table: AxisCompensation, *, steps: bool = False) -> StoredTable:
    """A table with a row for each point, or for each step, counted from the first point."""
    if not steps:
        return StoredTable.by_point(table)
    sections = np.arange(table.positions.size - 1)
    return StoredTable(compensation=table, order=sections, steps=True, zero=0)


def shown(up: FloatArray, down: FloatArray, backlash: float = 0.0) -> FloatArray:
    """What tables (k,) and a backlash do at the targets (2, m): straight lines between nodes;
    lost motion is made up for in the negative direction, by going further to -.
    """
    return np.stack([np.interp(TARGETS, NODES, up), np.interp(TARGETS, NODES, down) - backlash])


def judge(
    acting: FloatArray,
    new: AxisCompensation,
    old: AxisCompensation = NONE,
    *,
    seed: int = 1,
    turned: bool = False,
    read: float = 1.0,
    declared: float | None = 0.0,
    noise: float = NOISE,
    read_back: bool = False,
    idle: bool = False,
    steps: bool = False,
    rows: StoredTable | None = None,
) -> LoadingVerdict:
    """The axis has an error that ``new`` takes away but for 0.4 µm; ``acting`` (2, m) acts in the
    test after loading, whose readings scatter by ``noise`` and are multiplied by ``read``. ``old``
    acted in the first test, but where it was ``idle``. ``steps``: the control keeps the steps from
    point to point; ``rows``: in these rows.
    """
    rng = np.random.default_rng([seed, 12])
    left = 0.4 * UM * np.stack([np.sin(TARGETS / 30.0), np.cos(TARGETS / 41.0)])
    error = left - np.stack(
        [
            np.interp(TARGETS, new.positions, new.positive),
            np.interp(TARGETS, new.positions, new.negative) - new.backlash,
        ]
    )
    was = shown(old.positive, old.negative, old.backlash) if old.positions.size else 0.0 * error
    was = 0.0 * was if idle else was
    first = error + was + NOISE / math.sqrt(RUNS) * rng.standard_normal(error.shape)
    means = error + acting + 9 * UM
    readings = read * (means[..., None] + noise * rng.standard_normal((*means.shape, RUNS)))
    if turned:
        readings = -readings
    after = means_of((readings[0], readings[1]), NOISE, math.inf, TARGETS)
    covariance = np.eye(2 * TARGETS.size) * NOISE**2 / RUNS
    before = NONE if idle else old
    table = stored(new, steps=steps) if rows is None else rows
    view = view_of(first, covariance, table, old, before, read_back=read_back)
    views = [view, *measurement_cases(view)]
    units = unit_cases(view, after.sigma / NOISE)
    if read != 1.0:
        views += units
    return judge_loading(
        after, views, declared_slope=declared, further=lambda: units, read_back=read_back
    )


def view_of(
    first: FloatArray,
    covariance: FloatArray,
    new: StoredTable,
    old: AxisCompensation,
    before: AxisCompensation,
    *,
    read_back: bool = False,
) -> MeasurementCase:
    others = {"Y": stored(compensation(OTHER, address="Y"), steps=new.steps)}
    loading = Loading(new=new, old=old, active_before=before, others=others, read_back=read_back)
    return MeasurementCase(
        belief=known(first, covariance), hypotheses=loading_hypotheses(loading, TARGETS)
    )


def moved(values: FloatArray, by: int) -> FloatArray:
    """Values ``by`` nodes further to +, the end value held."""
    return values[np.clip(np.arange(values.size) - by, 0, values.size - 1)]


#: A table that is counted from 200 mm and begins again behind 575 mm: 23 rows 25 mm apart, with
#: three more at each end of the travel that have its end values.
AROUND = np.interp(25.0 * np.arange(-11, 12), NODES - 200.0, WAVES - WAVES[8])
ENTRIES = np.roll(AROUND, -12)
WRAPPED = StoredTable(
    compensation=replace(
        compensation(np.append(0.0, ENTRIES), nodes=np.linspace(200.0, 775.0, 24)), period=575.0
    ),
    order=np.arange(1, 24),
    zero=0,
)


def by_entries(entries: FloatArray) -> FloatArray:
    """What the control adds at the targets: entry i is 25 mm times i from 200 mm."""
    where = np.mod(TARGETS - 200.0, 575.0)
    curve = np.interp(where, 25.0 * np.arange(24), np.append(0.0, entries))
    return np.stack([curve, curve - LOST])


@pytest.mark.parametrize(
    ("entries", "name"),
    [
        (ENTRIES, "loaded"),
        (ENTRIES[::-1], "mirrored"),
        (np.append(ENTRIES[-2::-1], 0.0), "mirrored"),  # the motor counts the other way
        (np.append(ENTRIES[1:], 0.0), "shifted"),
        (np.append(0.0, ENTRIES[:-1]), "shifted"),  # the first entry taken for that at zero
        (AROUND, "shifted"),  # in the order of the positions
        (np.append(AROUND[3:], np.zeros(3)), "shifted"),  # from the end of the travel on
        (AROUND[::-1], "mirrored"),
        (np.where(np.arange(23) < 8, ENTRIES, 0.0), "partial"),
        (np.where(np.arange(23) < 17, ENTRIES, 0.0), "partial"),
        (np.where(np.arange(23) < 6, 0.0, ENTRIES), "partial"),
    ],
)
def test_faults_of_rows_that_are_counted_from_inside_the_travel(
    entries: FloatArray, name: str
) -> None:
    table = replace(WRAPPED, compensation=replace(WRAPPED.compensation, backlash=LOST))
    for seed in range(2):
        verdict = judge(by_entries(entries), ONE_TABLE, seed=seed, rows=table)
        assert verdict.verdict == name, verdict.message


def up_to(node: int, values: FloatArray, beyond: FloatArray) -> FloatArray:
    return np.where(np.arange(values.size) < node, values, beyond)


NOTHING = np.zeros(NODES.size)
CASES: dict[str, tuple[FloatArray, str]] = {
    "loaded": (shown(WAVES, WAVES, LOST), "loaded"),
    "nothing": (shown(NOTHING, NOTHING), "not_active"),
    "inverted": (shown(-WAVES, -WAVES, -LOST), "inverted"),
    "table alone inverted": (shown(-WAVES, -WAVES, LOST), "inverted"),
    "mirrored": (shown(WAVES[::-1], WAVES[::-1], LOST), "mirrored"),
    "turned steps": (
        shown(WAVES[-1] - WAVES[::-1], WAVES[-1] - WAVES[::-1], LOST),
        "mirrored",
    ),
    "turned rows": (shown(TURNED_ROWS, TURNED_ROWS, LOST), "mirrored"),
    "another axis": (shown(OTHER, OTHER, LOST), "wrong_axis"),
    "positive alone": (np.stack([shown(WAVES, WAVES)[0], 0 * TARGETS]), "one_direction"),
    "negative alone": (np.stack([0 * TARGETS, shown(WAVES, WAVES, LOST)[1]]), "one_direction"),
    "no backlash": (shown(WAVES, WAVES), "backlash"),
    "backlash twice": (shown(WAVES, WAVES, 2 * LOST), "backlash"),
    "backlash turned": (shown(WAVES, WAVES, -LOST), "backlash"),
    "a part": (shown(up_to(9, WAVES, NOTHING), up_to(9, WAVES, NOTHING), LOST), "partial"),
    "the other part": (shown(up_to(9, NOTHING, WAVES), up_to(9, NOTHING, WAVES), LOST), "partial"),
}


EXISTING = np.roll(OTHER, 3)
WITH_EXISTING: dict[str, tuple[FloatArray, bool, str, str]] = {
    "the change alone": (shown(WAVES - EXISTING, WAVES - EXISTING, LOST), False, "increment", ""),
    "on top": (shown(WAVES + EXISTING, WAVES + EXISTING, LOST), False, "on_top", "state"),
    # the plan is the belief that the existing table was active: what it lacks is the same
    "it was idle": (shown(WAVES + EXISTING, WAVES + EXISTING, LOST), True, "state", "on_top"),
    "as planned": (shown(WAVES, WAVES, LOST), False, "loaded", ""),
    "the existing table": (shown(EXISTING, EXISTING), False, "not_active", ""),
}


@pytest.mark.parametrize("case", WITH_EXISTING)
def test_faults_with_an_existing_table_are_named(case: str) -> None:
    acting, read_back, name, equivalent = WITH_EXISTING[case]
    old = compensation(EXISTING)
    for seed in range(3):
        verdict = judge(acting, ONE_TABLE, old, seed=seed, read_back=read_back)
        assert verdict.verdict == name, verdict.message
        assert set(verdict.equivalent) == {equivalent} - {""}


def test_two_variants_of_a_name_and_another_name_that_is_one_of_them() -> None:
    """The backlash of the existing table is added too, or it is not: with 0.25 µm this test hardly
    tells which. The first is the same test as an existing table that was idle before.
    """
    old = compensation(EXISTING, backlash=0.25 * UM)
    both = WAVES + EXISTING
    for added in (0.0, 0.25 * UM):
        for seed in range(4):
            verdict = judge(shown(both, both, LOST + added), ONE_TABLE, old, seed=seed)
            assert verdict.verdict == "on_top", verdict.message
            assert set(verdict.equivalent) <= {"state"}


@pytest.mark.parametrize("case", CASES)
def test_a_fault_is_found_by_its_name(case: str) -> None:
    acting, name = CASES[case]
    for seed in range(2):
        verdict = judge(acting, ONE_TABLE, seed=seed, steps=case.startswith("turned"))
        assert verdict.verdict == name, verdict.message
        assert verdict.margin > math.log(99.0)
        assert verdict.candidates[0].verdict == name
        assert ("CW-V028" in [f.code for f in verdict.findings]) == (name != "loaded")


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ("positive alone", "approaches in + only"),
        ("negative alone", "approaches in - only"),
        ("no backlash", "the backlash value is wrong: missing"),
        ("backlash twice", "the backlash value is wrong: twice"),
        ("backlash turned", "the backlash value is wrong: with the wrong sign"),
        ("a part", "up to point 9 (200), no correction elsewhere"),
        # 16 intervals of 25 mm; the table holds 1.3 µm at point 9: from point 10 on looks alike.
        ("the other part", "Only a part of the table is active: from point 9 (200) on"),
        ("nothing", "The table is not active"),
        ("another axis", "that of axis Y"),
    ],
)
def test_the_message_says_what_was_seen(case: str, words: str) -> None:
    verdict = judge(CASES[case][0], ONE_TABLE)
    assert words in verdict.message
    assert "µm rms" in verdict.message


def test_a_fine_table_may_end_at_every_target() -> None:
    """Between the last point that is loaded and the next one, a target has a part of the value."""
    nodes = np.linspace(0.0, 400.0, 378)
    values = np.interp(nodes, NODES, WAVES)
    loading = Loading(
        new=stored(compensation(values, nodes=nodes)), old=NONE, active_before=NONE, others={}
    )
    ways = [way for way in loading_hypotheses(loading, TARGETS) if way.name == "partial"]
    for target in TARGETS:
        for kept in (nodes <= target, nodes >= target):
            curve = np.interp(TARGETS, nodes, np.where(kept, values, 0.0))
            assert any(np.allclose(way.positive, curve, atol=1e-12) for way in ways)


@pytest.mark.parametrize("steps", [False, True])
def test_a_moved_table_has_the_odds_of_the_page_whatever_its_ends_hold(*, steps: bool) -> None:
    """Zero and the last value are nearly the same test: 0.2 / (1 + abs(k)) for both together."""
    table = stored(compensation(WAVES), steps=steps)
    loading = Loading(new=table, old=NONE, active_before=NONE)
    ways = [way for way in loading_hypotheses(loading, TARGETS) if way.name == "shifted"]
    for by in (-2, -1, 1, 2):
        odds = sum(way.weight for way in ways if way.shift_nodes == by)
        assert odds == pytest.approx(0.2 / (1 + abs(by)))
    # 0.2 and, one point off, 0.05: of the values, and of the steps
    turned = [way.weight for way in loading_hypotheses(loading, TARGETS) if way.name == "mirrored"]
    assert sum(turned) == pytest.approx((1 + steps) * (0.2 + 0.05))


def test_the_table_of_an_axis_of_another_kind() -> None:
    """A rotary axis given the numbers of a linear one: 0.004 mm is active as 0.004 deg."""
    other = replace(compensation(OTHER, address="C"), kind=AxisKind.ROTARY)
    loading = Loading(
        new=stored(ONE_TABLE), old=NONE, active_before=NONE, others={"C": stored(other)}
    )
    (way, *_) = (one for one in loading_hypotheses(loading, TARGETS) if one.name == "wrong_axis")
    assert way.of == "C"
    np.testing.assert_allclose(way.positive, np.interp(TARGETS, NODES, OTHER))


@pytest.mark.parametrize("language", ["de", "fr", "ru"])
def test_every_variant_is_translated(language: Language) -> None:
    """The variants of all hypotheses, with the names of their verdicts, contain no English."""
    old = compensation(OLD, backlash=1 * UM)
    for table in (ONE_TABLE, TWO_TABLES):
        view = view_of(
            np.zeros((2, TARGETS.size)), np.eye(2 * TARGETS.size), stored(table), old, NONE
        )
        cases = [view, *measurement_cases(view), other_axis_case("Y", view)]
        texts = {candidate_text(w.name, w.detail) for case in cases for w in case.hypotheses}
        assert len(texts) > 100
        for text in texts:
            assert not english_words(text.text(language).encode())


@pytest.mark.parametrize("runs", [2, 5])
def test_the_standard_error_is_that_of_the_difference_of_two_tests(runs: int) -> None:
    """Means of two tests with the same noise, taken 20 000 times."""
    rng = np.random.default_rng(8)
    one, other = NOISE * rng.standard_normal((2, 20_000, runs)).mean(axis=2)
    block = np.zeros((TARGETS.size, runs))
    after = replace(means_of((block, block), NOISE, math.inf, TARGETS), sigma=NOISE)
    assert after.std_error == pytest.approx(np.std(one - other), rel=0.03)


@pytest.mark.parametrize("factor", [2.0, 0.5, 10.0, 0.1, 25.4, 0.75, 1.3, 3.0])
@pytest.mark.parametrize("with_backlash", [True, False])
def test_a_factor_is_told(factor: float, with_backlash: bool) -> None:
    lost = factor * LOST if with_backlash else LOST
    verdict = judge(shown(factor * WAVES, factor * WAVES, lost), ONE_TABLE)
    assert verdict.verdict == "scaled", verdict.message
    assert verdict.factor == pytest.approx(factor, rel=0.05)


@pytest.mark.parametrize("by", [-5, -2, -1, 1, 2, 3])
@pytest.mark.parametrize("new", [ONE_TABLE, TWO_TABLES])
def test_a_shift_is_told(by: int, new: AxisCompensation) -> None:
    acting = shown(moved(new.positive, by), moved(new.negative, by), new.backlash)
    verdict = judge(acting, new)
    assert (verdict.verdict, verdict.shift_nodes) == ("shifted", by), verdict.message
    assert f"in direction {'+' if by > 0 else '-'}" in verdict.message


def test_the_old_table_or_nothing() -> None:
    """Of an update: what was there before still acts, or nothing does; a part of the new one beside
    the old.
    """
    old = compensation(OLD, backlash=1 * UM)
    for acting, words in (
        (shown(OLD, OLD, 1 * UM), "what was in the control before is still active"),
        (shown(NOTHING, NOTHING), "nothing at all is active"),
    ):
        verdict = judge(acting, ONE_TABLE, old)
        assert verdict.verdict == "not_active"
        assert words in verdict.message
    part = up_to(10, WAVES, OLD)
    verdict = judge(shown(part, part, LOST), ONE_TABLE, old)
    assert verdict.verdict == "partial"
    assert "up to point" in verdict.message
    assert "the old values elsewhere" in verdict.message
    assert judge(shown(WAVES, WAVES, LOST), ONE_TABLE, old).verdict == "loaded"
    lost = judge(shown(WAVES, WAVES, 1 * UM), ONE_TABLE, old)
    assert (lost.verdict, str(lost.detail)) == ("backlash", "the old value instead of the new one")


@pytest.mark.parametrize(
    ("acting", "name", "detail"),
    [
        (shown(WAVES, WAVES, LOST), "loaded", ""),
        (shown(WAVES + OLD, WAVES + OLD, LOST + UM), "on_top", ""),
        (shown(WAVES - OLD, WAVES - OLD, LOST - UM), "increment", ""),
        (shown(OLD, OLD, UM), "not_active", "what was in the control before is active"),
        (shown(NOTHING, NOTHING), "not_active", "nothing at all is active"),
    ],
)
def test_an_existing_table_that_was_idle_in_the_first_test(
    acting: FloatArray, name: str, detail: str
) -> None:
    verdict = judge(acting, ONE_TABLE, compensation(OLD, backlash=1 * UM), idle=True)
    assert (verdict.verdict, str(verdict.detail or "")) == (name, detail), verdict.message


@pytest.mark.parametrize("at", [70.0, 200.0, 330.0])
def test_a_table_that_ends_between_two_nodes(at: float) -> None:
    acting = np.where(at > TARGETS, shown(WAVES, WAVES, LOST), 0.0)
    assert judge(acting, ONE_TABLE).verdict == "partial"


def test_two_tables_of_which_one_acts() -> None:
    verdict = judge(np.stack([shown(WAVES, BENT)[0], 0 * TARGETS]), TWO_TABLES)
    assert (verdict.verdict, verdict.equivalent) == ("one_direction", ())
    assert judge(shown(WAVES, BENT), TWO_TABLES).verdict == "loaded"


def test_a_slope_is_thermal_with_its_size() -> None:
    slope = 25e-6 * (TARGETS - TARGETS.mean())
    verdict = judge(shown(WAVES, WAVES, LOST) + slope, ONE_TABLE)
    assert verdict.verdict == "thermal"
    assert verdict.slope is not None
    assert abs(verdict.slope[0] - 25e-6) < 4 * verdict.slope[1]


# ---------------------------------------------------------------- what no test can tell apart


def test_a_straight_line_shifted_is_the_same_line_and_mirrored_the_inverted_one() -> None:
    nodes = np.linspace(-150.0, 550.0, 15)  # further than the targets, so that no end is seen
    line = compensation(0.05 * UM * (nodes + 150.0), nodes=nodes)
    straight = np.stack([0.05 * UM * TARGETS] * 2)
    loaded = judge(straight, line)
    assert loaded.verdict == "loaded"
    assert "shifted" in loaded.equivalent
    assert "inverted" not in loaded.equivalent
    assert "No measurement of this axis can tell them" in loaded.message
    assert "Read the values back from the control and give them with --loaded." in loaded.message
    told = judge(straight, line, read_back=True).message
    assert "they equal the planned values (--loaded)." in told
    back = judge(-straight, line)
    assert {back.verdict, *back.equivalent} >= {"inverted", "mirrored"}
    warm = judge(1.5 * straight, line)
    assert {warm.verdict, *warm.equivalent} >= {"thermal", "scaled"}


def test_a_curve_has_no_equivalents() -> None:
    assert judge(CASES["loaded"][0], ONE_TABLE).equivalent == ()


# ---------------------------------------------------------------- no harm


def test_honest_tests_are_loaded_and_nothing_else() -> None:
    found = Counter(judge(CASES["loaded"][0], ONE_TABLE, seed=seed).verdict for seed in range(60))
    assert found["loaded"] >= 59
    assert set(found) <= {"loaded", "undecided"}


@pytest.mark.parametrize("place", [2, 5, 9])
def test_a_fault_that_is_on_no_list_is_no_name(place: int) -> None:
    """One target is off by 6 µm in both directions: nothing known does that."""
    acting = CASES["loaded"][0].copy()
    acting[:, place] += 6 * UM
    verdict = judge(acting, ONE_TABLE)
    assert verdict.verdict == "undecided"
    assert [finding.code for finding in verdict.findings] == ["CW-V001"]
    assert f"{TARGETS[place]:g} mm" in verdict.message


def test_a_test_that_is_too_noisy_names_nothing() -> None:
    """A reading scatters by three times the planned effect, so that 22 means of five put loaded and
    not active 2.5 standard errors (s √(2/n)) apart: 99 % are beyond nearly every such test.
    """
    effect = float(np.std(shown(WAVES, WAVES, LOST)))
    for acting in (CASES["loaded"][0], CASES["nothing"][0]):
        told = [judge(acting, ONE_TABLE, seed=seed, noise=3.0 * effect) for seed in range(6)]
        assert sum(each.verdict == "undecided" for each in told) >= 5
        for each in told:
            assert {"loaded", "not_active"} & {one.verdict for one in each.candidates}


def test_a_step_in_the_axis_is_no_unit() -> None:
    """A collision: 20 µm more from the middle on, with the scatter of the first test."""
    acting = CASES["loaded"][0] + np.where(TARGETS > 200.0, 20 * UM, 0.0)
    verdict = judge(acting, ONE_TABLE)
    assert verdict.verdict == "undecided", verdict.message
    assert "measurement" not in {one.verdict for one in verdict.candidates}


@pytest.mark.parametrize("slope", [-32e-6, 32e-6])
def test_a_slope_beside_a_small_table_is_no_second_fault(slope: float) -> None:
    """A table hardly above the noise on an axis that is longer: one cause is enough, though among
    all faults with a slope one may fit a little better by chance.
    """
    small = compensation(0.1 * WAVES, backlash=0.1 * LOST)
    acting = 0.1 * shown(WAVES, WAVES, LOST) + slope * (TARGETS - TARGETS.mean())
    names = Counter(judge(acting, small, seed=seed).verdict for seed in range(8))
    assert names["thermal"] >= 7


# ---------------------------------------------------------------- the measurement


def test_a_turned_test_of_a_table_that_leaves_something() -> None:
    """Beside the table 4 µm are left: turned they are wrong by 8 µm."""
    left = 4 * UM * np.sin(TARGETS / 60.0)
    rough = Loading(new=stored(ONE_TABLE), old=NONE, active_before=NONE)
    first = left - shown(WAVES, WAVES, LOST)
    view = MeasurementCase(
        belief=known(first, np.eye(2 * TARGETS.size) * NOISE**2 / RUNS),
        hypotheses=loading_hypotheses(rough, TARGETS),
    )
    readings = -np.stack([left, left])[..., None] + NOISE * np.random.default_rng(
        3
    ).standard_normal((2, TARGETS.size, RUNS))
    after = means_of((readings[0], readings[1]), NOISE, math.inf, TARGETS)
    verdict = judge_loading(after, [view, *measurement_cases(view)], declared_slope=0.0)
    assert (verdict.verdict, verdict.of) == ("measurement", "sign")


@pytest.mark.parametrize("end", [260.0, 400.0], ids=["bump", "step"])
def test_what_nothing_explains_has_no_candidates(end: float) -> None:
    """A collision, or values mistyped: the least bad of what does not fit is no lead."""
    broken = 20 * UM * ((TARGETS > 150.0) & (end > TARGETS))
    verdict = judge(CASES["loaded"][0] + broken, ONE_TABLE)
    assert verdict.verdict == "undecided"
    assert [finding.code for finding in verdict.findings] == ["CW-V001"]
    assert (verdict.candidates, verdict.margin, verdict.slope) == ((), 0.0, None)


@pytest.mark.parametrize("unit", [25.4, 1000.0])
def test_readings_in_another_unit_scatter_in_it_too(unit: float) -> None:
    verdict = judge(CASES["loaded"][0], ONE_TABLE, read=unit)
    assert (verdict.verdict, verdict.of) == ("measurement", "unit"), verdict.message


def test_the_test_of_another_axis() -> None:
    """The file is one of Y, whose own table leaves 5 µm of a wave that X does not have."""
    rng = np.random.default_rng(4)
    covariance = np.eye(2 * TARGETS.size) * NOISE**2 / RUNS
    mine = view_of(-shown(WAVES, WAVES, LOST), covariance, stored(ONE_TABLE), NONE, NONE)
    wave = 5 * UM * np.stack([np.sin(TARGETS / 19.0)] * 2)
    theirs = view_of(
        wave - shown(OTHER, OTHER), covariance, stored(compensation(OTHER)), NONE, NONE
    )
    readings = wave[..., None] + NOISE * rng.standard_normal((2, TARGETS.size, RUNS))
    after = means_of((readings[0], readings[1]), NOISE, math.inf, TARGETS)
    verdict = judge_loading(
        after, [mine], declared_slope=0.0, further=lambda: [other_axis_case("Y", theirs)]
    )
    assert (verdict.verdict, verdict.of) == ("measurement", "wrong_axis")
    assert "axis Y" in verdict.message


# ---------------------------------------------------------------- the likelihood


def test_the_likelihood_is_that_of_a_dense_normal_law() -> None:
    """Against the covariance written out: the density of all contrasts, the datum integrated."""
    rng = np.random.default_rng(7)
    m = 6
    draws = rng.standard_normal((400, 2 * m)) @ rng.standard_normal((2 * m, 2 * m)) * UM
    belief = belief_of(draws[:, :m], draws[:, m:])
    covariance = np.cov(draws, rowvar=False)
    readings = (rng.standard_normal((m, 3)) * UM, rng.standard_normal((m, 3)) * UM)
    readings[1][2] = np.nan  # a target that was not approached in -
    after = means_of(readings, UM, math.inf, np.linspace(0.0, 50.0, m))
    change = rng.standard_normal((2, m, 4)) * UM
    fits = fits_of(
        after, belief, Curves(change=change, free={}, slack=np.zeros(change.shape[2])), 3e-6
    )
    kept = np.isfinite(after.plain).ravel()
    along = np.tile(after.targets - after.targets.mean(), 2)
    expected = []
    for h in range(4):
        left = (after.plain - belief.mean - change[..., h]).ravel()[kept]
        logs = []
        for j in range(len(after.mean)):
            noise = np.diag(1.0 / np.maximum(after.precision[j].ravel(), 1e-300))
            full = covariance + noise + 9e-12 * np.outer(along, along)
            inverse = np.linalg.inv(full[np.ix_(kept, kept)])
            ones = np.ones(left.size)
            total = ones @ inverse @ ones
            chi2 = left @ inverse @ left - (ones @ inverse @ left) ** 2 / total
            logs.append(-0.5 * (chi2 - np.linalg.slogdet(inverse)[1] + math.log(total)))
        expected.append(np.log(np.mean(np.exp(np.array(logs) - max(logs)))) + max(logs))
    assert fits.log_likelihood == pytest.approx(np.array(expected), rel=1e-6)


def test_a_belief_of_many_targets_is_kept_small() -> None:
    """A thousand targets: the variance at every target is that of the draws, and both directions
    hang together.
    """
    rng = np.random.default_rng(8)
    m = 1000
    x = np.linspace(0.0, 1.0, m)
    waves = np.stack([np.sin(k * x) for k in range(1, 9)])
    both = rng.standard_normal((420, 8)) @ waves + 0.1 * rng.standard_normal((420, m))
    belief: ErrorBelief = belief_of(both, both + 0.05 * rng.standard_normal((420, m)))
    assert belief.root.shape[2] <= 60
    variance = np.sum(belief.root**2, axis=2) + belief.blocks[:, [0, 1], [0, 1]].T
    assert variance[0] == pytest.approx(np.var(both, axis=0, ddof=1), rel=1e-9)
    assert np.all(belief.blocks[:, 0, 1] > 0.0)


def test_an_inverted_table_is_no_table_of_another_factor() -> None:
    """An unknown factor of -1 is the same fault, not another one that could be told from it."""
    found = judge(shown(-WAVES, -WAVES, -LOST), ONE_TABLE)
    assert (found.verdict, found.equivalent) == ("inverted", ())


def test_what_a_test_tells_little_of_is_near() -> None:
    """A table of slow waves shifted by a node differs by less than one of fast waves."""
    slow = compensation(6 * UM * np.sin(NODES / 190.0))
    for table, near in ((slow, True), (ONE_TABLE, False)):
        acting = shown(table.positive, table.negative, table.backlash)
        off = shown(np.r_[table.positive[0], table.positive[:-1]], table.negative) - shown(
            table.positive, table.negative
        )
        off[1] = off[0]
        distance = float(np.linalg.norm(off - off.mean())) / (NOISE * math.sqrt(2 / RUNS))
        assert (distance < 8.0) is near
        found = judge(acting, table)
        assert found.verdict == "loaded"
        assert ("shifted" in found.near, "not_active" in found.near) == (near, False)


@pytest.mark.parametrize(
    ("parts", "variance"),
    [
        ({}, 1.0),
        ({"dof": 5.0}, 5.0 / 3.0),
        ({"outlier_share": 0.1, "outlier_size": 4.0}, 0.9 + 0.1 * 16.0),
        ({"outlier_share": 0.1, "outlier_size": 4.0, "outlier_fixed": True}, 1.0 + 0.1 * 16.0),
        ({"outlier_share": 1.0, "outlier_size": 2.0, "outlier_fixed": True}, 5.0),
        ({"outlier_share": 1.0, "outlier_size": 0.8, "outlier_fixed": True, "core": 0.6}, 1.0),
    ],
)
def test_single_readings_have_the_noise_of_the_first_test(
    parts: dict[str, float], variance: float
) -> None:
    """Student's law has the variance dof / (dof - 2) (Johnson, Kotz, Balakrishnan, 1995, ch. 28); a
    mixture that of its parts, weighted, and that of their places.
    """
    sigma = np.full(8, NOISE)
    arrays: dict[str, Any] = {name: np.full(8, value) for name, value in parts.items()}
    noise = replace(normal_noise(sigma, centre=200.0, half=200.0), **arrays)
    readings = np.zeros((TARGETS.size, 1))
    test = PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=TARGETS,
        positive=readings,
        negative=readings,
        runs_positive=(1,),
        runs_negative=(1,),
        frame="machine",
    )
    after = after_means(test, noise)
    assert after.precision == pytest.approx(1.0 / (NOISE**2 * variance))


def test_what_was_read_back_needs_no_second_look() -> None:
    """Values that are the plan's tell a loaded table from one whose values are at fault, not from
    one that does not act."""
    sentences: dict[LoadingName, tuple[str, ...]] = {"loaded": ("save it again",)}
    part = LoadingVerdict(
        verdict="loaded", margin=9.0, sentence=say("as_written", text=""), equivalent=("partial",)
    )
    assert _looks(part, sentences, read_back=False) == ["save it again"]
    assert _looks(part, sentences, read_back=True) == []
    off = LoadingVerdict(
        verdict="loaded",
        margin=9.0,
        sentence=say("as_written", text=""),
        equivalent=("partial", "not_active"),
    )
    assert _looks(off, sentences, read_back=True) == ["save it again"]
