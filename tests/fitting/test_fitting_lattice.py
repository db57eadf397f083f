"""Whole increments, anchored and endless grids, steps and slopes against brute force: every table,
squares integrated here.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
import pytest
from numpy.typing import NDArray

from compwright.fitting import lattice_part
from compwright.fitting.certify import lattice_certificate
from compwright.fitting.chain import (
    ChainLimits,
    ChainTarget,
    LimitMultipliers,
    build_chain,
    closing_multipliers,
    priced,
    relax,
)
from compwright.fitting.endless_axis import over_one_period
from compwright.fitting.fit import fit_table
from compwright.fitting.lattice import best_totals
from compwright.fitting.lattice_part import LatticePart
from compwright.fitting.problem import hat_matrix, quadrature, rows_at
from compwright.foundations.errors import CapacityError, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.capacity import Capacity, Lattice
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.words.sentences import say

Array = NDArray[np.float64]
UM = 1e-3
POSITIVE, NEGATIVE = Direction.POSITIVE, Direction.NEGATIVE
#: Mean squares agree to this share: both sides are sums of some hundred products of doubles.
SAME = 1e-9

SEVEN = Lattice(
    unit=1 * UM,
    increments=(-7, 7),
    magnifications=tuple(range(1, 101)),
    offset_range=(-32768, 32767),
)
FANUC = Capacity(
    format="whole",
    curves=2,
    spacing="equidistant",
    quantum=1 * UM,
    position_quantum=1e-3,
    value_range=(-100.0, 100.0),
    backlash_quantum=1 * UM,
    backlash_range=(-9999 * UM, 9999 * UM),
    max_points=1024,
    lattice=SEVEN,
    interpolation="step",
    anchored=True,
    second_curve="asked",
)
PLAIN = Capacity(
    format="plain",
    curves=1,
    spacing="equidistant",
    quantum=1e-7,
    position_quantum=1e-3,
    value_range=(-10.0, 10.0),
    backlash_quantum=1e-7,
    backlash_range=(-1.0, 1.0),
)


def wish(positions: Array, positive: Array, negative: Array, **more: Any) -> WantedCorrection:
    values: dict[str, Any] = {
        "kind": AxisKind.LINEAR,
        "reference": 0.0,
        "reference_return": POSITIVE,
        "noise": 0.5 * UM,
        **more,
    }
    return WantedCorrection(positions=positions, positive=positive, negative=negative, **values)


def fit(wanted: WantedCorrection, capacity: Capacity, **request: Any) -> FittedTable:
    return fit_table(wanted, capacity, TableRequest(**request), address="1")


def codes(result: FittedTable) -> list[str]:
    return [finding.code for finding in result.findings]


def says(result: FittedTable, code: str) -> str:
    return next(finding.message for finding in result.findings if finding.code == code)


def causes(result: FittedTable) -> dict[str, float]:
    return {limit.cause: limit.value for limit in result.limits}


# --- brute force
# --------------------------------------------------------------------------------------------------


def between(nodes: Array, step: bool, where: Array) -> Array:
    """The control's table as a matrix, written out here: straight lines, or the nearest node; the
    ends are held.
    """
    if not step:
        return np.column_stack([np.interp(where, nodes, one) for one in np.eye(nodes.size)])
    nearest = np.argmin(np.abs(where[:, np.newaxis] - nodes[np.newaxis, :]), axis=1)
    chosen: Array = np.eye(nodes.size)[nearest]
    return chosen


def integral(positions: Array, nodes: Array) -> tuple[Array, Array]:
    """Three Gauss points in every piece between positions, nodes and midpoints: exact for squares of
    straight pieces.
    """
    every = np.concatenate([nodes, 0.5 * (nodes[1:] + nodes[:-1])])
    ends = np.unique(
        np.concatenate([positions, every[(every > positions[0]) & (every < positions[-1])]])
    )
    x, w = np.polynomial.legendre.leggauss(3)
    half, middle = 0.5 * np.diff(ends)[:, np.newaxis], 0.5 * (ends[1:] + ends[:-1])[:, np.newaxis]
    return (middle + half * x).ravel(), (half * w).ravel() / float(ends[-1] - ends[0])


@dataclass(frozen=True)
class Case:
    """A small fit: who returns where, the limits, and what is wanted (in units of the lattice)."""

    wanted: WantedCorrection
    capacity: Capacity
    lattice: Lattice
    points: Array
    anchor: int
    mode: Literal["single", "bidirectional"]


def random_case(rng: np.random.Generator, kind: str, step: bool) -> Case:
    endless = "endless" in kind
    largest = int(rng.integers(1, 4))
    k = int(rng.integers(2, 6 if largest < 3 else 5)) + (1 if endless else 0)
    nodes = np.arange(k) * 10.0
    anchor = 0 if endless else int(rng.integers(0, k))
    nodes = nodes - nodes[anchor] + 3.0  # the reference lies at 3
    if endless:
        positions = np.linspace(nodes[0], nodes[-1], 7)
    else:
        # The nodes cover the travel by less than one section at each end.
        low = nodes[0] + (rng.uniform(0.1, 9.0) if anchor > 0 else rng.uniform(-6.0, 6.0) * 0.0)
        high = nodes[-1] - (rng.uniform(0.1, 9.0) if anchor < k - 1 else 0.0)
        positions = np.linspace(low, max(high, low + 0.5), 6)
    size = float(rng.choice([0.3, 1.0, 3.0, 8.0])) * UM
    curves = [
        np.cumsum(rng.normal(size=positions.size)) * size + rng.normal() * UM for _ in range(2)
    ]
    if endless:
        for curve in curves:
            curve[-1] = curve[0]
    home = POSITIVE if rng.random() < 0.5 else NEGATIVE
    at_reference = float(np.interp(3.0, positions, curves[0 if home is POSITIVE else 1]))
    lattice = Lattice(
        unit=1 * UM,
        increments=(-largest, int(rng.integers(1, largest + 1))),
        magnifications=tuple(
            sorted(
                int(one)
                for one in rng.choice(np.arange(1, 7), size=int(rng.integers(1, 4)), replace=False)
            )
        ),
        offset_range=(-4, 3) if rng.random() < 0.8 else None,
        offset_magnified=bool(rng.random() < 0.5),
    )
    reach = float(rng.choice([4.0, 9.0, 1000.0])) * UM
    capacity = replace(
        FANUC,
        lattice=lattice,
        interpolation="step" if step else "linear",
        value_range=(-reach, reach),
        backlash_quantum=None if kind == "no reversal" else float(rng.choice([1.0, 0.5])) * UM,
        backlash_range=(-2 * UM, 3 * UM),
        period=float(nodes[-1] - nodes[0]) if endless else None,
    )
    if "two" not in kind:
        at_reference += beside_the_mean(positions, curves, capacity, home)
    wanted = wish(
        positions,
        curves[0] - at_reference,
        curves[1] - at_reference,
        reference=3.0,
        reference_return=home,
    )
    return Case(
        wanted, capacity, lattice, nodes, anchor, "bidirectional" if "two" in kind else "single"
    )


def beside_the_mean(
    positions: Array, curves: list[Array], capacity: Capacity, home: Direction
) -> float:
    """How far the best single curve lies beside that of the return direction at the reference:
    half of what one value within its range holds of the reversal less what is wanted there.
    """
    own, other = curves if home is POSITIVE else curves[::-1]
    backlash = home.opposite.sign * float(np.trapezoid(other - own, positions) / np.ptp(positions))
    low, high = capacity.backlash_range if capacity.backlash_quantum else (0.0, 0.0)
    held = home.opposite.sign * min(max(backlash, low), high)
    return 0.5 * (float(np.interp(3.0, positions, other - own)) - held)


def whole_tables(case: Case) -> Array:
    """Every vector of totals that the increments allow, zero at the reference, closed on an endless
    axis.
    """
    low, high = case.lattice.increments
    steps = np.array(
        list(itertools.product(range(low, high + 1), repeat=case.points.size - 1)), dtype=float
    )
    totals = np.hstack([np.zeros((steps.shape[0], 1)), np.cumsum(steps, axis=1)])
    totals -= totals[:, [case.anchor]]
    return totals[totals[:, -1] == totals[:, 0]] if case.capacity.period is not None else totals


def brute_force(case: Case) -> tuple[float, int]:
    """The least mean square over all tables, reversal values and magnifications; the smallest
    magnification that has it.
    """
    wanted, capacity, lattice = case.wanted, case.capacity, case.lattice
    points, weights = integral(wanted.positions, case.points)
    matrix = between(case.points, capacity.interpolation == "step", points)
    home = wanted.reference_return
    own, other = (
        np.interp(points, wanted.positions, wanted.total(one)) for one in (home, home.opposite)
    )
    best, chosen, tables = np.inf, 0, whole_tables(case)
    for magnification in lattice.magnifications:
        values = tables * magnification * lattice.unit
        inside = np.all(np.abs(values) <= capacity.value_range[1] + 1e-9, axis=1)
        first = ((values[inside] @ matrix.T - own) ** 2) @ weights
        if case.mode == "single":
            second = min_reversal(values[inside] @ matrix.T, other, weights, capacity, home)
            value = 0.5 * float(np.min(first + second))
        else:
            value = 0.5 * (
                float(np.min(first))
                + second_table(values, matrix, other, weights, case, magnification)
            )
        if value < best * (1 - SAME) - 1e-15:
            best, chosen = value, magnification
    return best, chosen


def min_reversal(
    held: Array, other: Array, weights: Array, capacity: Capacity, home: Direction
) -> Array:
    quantum = capacity.backlash_quantum
    low, high = capacity.backlash_range
    values = (
        np.zeros(1)
        if quantum is None
        else np.arange(round(low / quantum), round(high / quantum) + 1) * quantum
    )
    sign = home.opposite.sign
    least: Array = np.min([((held + sign * one - other) ** 2) @ weights for one in values], axis=0)
    return least


def second_table(
    values: Array, matrix: Array, other: Array, weights: Array, case: Case, magnification: int
) -> float:
    low, high = case.lattice.offset_range or (0, 0)
    best = np.inf
    for offset in range(low, high + 1):
        shifted = values + offset * case.lattice.unit * (
            magnification if case.lattice.offset_magnified else 1
        )
        inside = np.all(np.abs(shifted) <= case.capacity.value_range[1] + 1e-9, axis=1)
        if np.any(inside):
            best = min(best, float(np.min(((shifted[inside] @ matrix.T - other) ** 2) @ weights)))
    return best


def left_over(result: FittedTable, wanted: WantedCorrection) -> float:
    """The mean square that a table leaves, integrated here."""
    table = result.compensation
    points, weights = integral(wanted.positions, table.positions)
    matrix = between(table.positions, table.interpolation == "step", points)
    total = 0.0
    for direction in (POSITIVE, NEGATIVE):
        curve = table.positive if direction is POSITIVE else table.negative
        reversal = 0.0 if direction is table.reference_return else direction.sign * table.backlash
        total += 0.5 * float(
            weights
            @ (
                matrix @ curve
                + reversal
                - np.interp(points, wanted.positions, wanted.total(direction))
            )
            ** 2
        )
    return total


KINDS = ("backlash", "no reversal", "two tables", "endless", "endless, two tables")


@pytest.mark.parametrize("lanes", [16, 1])
@pytest.mark.parametrize("step", [True, False])
@pytest.mark.parametrize("kind", KINDS)
def test_whole_tables_equal_brute_force(
    kind: str, step: bool, lanes: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        lattice_part, "_LANES", lanes
    )  # how many ways are searched at once changes nothing
    rng = np.random.default_rng(KINDS.index(kind) * 4 + 2 * step + (lanes > 1))
    for _ in range(20):
        case = random_case(rng, kind, step)
        result = fit(case.wanted, case.capacity, spacing=10.0, mode=case.mode)
        assert result.compensation.positions == pytest.approx(case.points, abs=1e-9)
        best, magnification = brute_force(case)
        assert left_over(result, case.wanted) == pytest.approx(best, rel=1e-7, abs=1e-14)
        assert result.certificate["magnification"] == magnification
        assert result.certificate["objective"] == pytest.approx(np.sqrt(best), rel=1e-6, abs=1e-9)
        assert result.certificate["lower_bound"] <= result.certificate["objective"] + 1e-9
        check_limits(result, case)


def check_limits(result: FittedTable, case: Case) -> None:
    table, unit = result.compensation, case.lattice.unit
    step = unit * result.certificate["magnification"]
    low, high = case.lattice.increments
    assert abs(table.curve(table.reference_return)[case.anchor]) <= 1e-12
    for curve in (table.positive, table.negative):
        counts = np.diff(curve) / step
        assert counts == pytest.approx(np.round(counts), abs=1e-6)
        assert np.all((counts >= low - 1e-6) & (counts <= high + 1e-6))
        assert np.max(np.abs(curve)) <= case.capacity.value_range[1] + 1e-9
        if case.capacity.period is not None:
            assert curve[-1] == curve[0]
    assert table.interpolation == case.capacity.interpolation
    assert table.period == case.capacity.period


# --- the proof of the windows
# -----------------------------------------------------------------------------------------


def dictionary_search(
    diagonal: Array,
    off: Array,
    linear: Array,
    step: float,
    increments: tuple[int, int],
    anchor: int,
) -> float:
    """The least v'Hv/2 + linear'v over whole totals, zero at the anchor: every total that can be
    reached is tried, one by one.
    """

    def one_side(order: list[int]) -> float:
        costs = {0: 0.0}
        for before, node in itertools.pairwise(order):
            new: dict[int, float] = {}
            coupling = off[min(before, node)]
            for total, cost in costs.items():
                for increment in range(increments[0], increments[1] + 1):
                    here = total + increment if node > before else total - increment
                    value = step * here
                    sum_ = (
                        cost
                        + 0.5 * diagonal[node] * value**2
                        + linear[node] * value
                        + coupling * value * step * total
                    )
                    if sum_ < new.get(here, np.inf):
                        new[here] = sum_
            costs = new
        return min(costs.values())

    size = diagonal.size
    return one_side(list(range(anchor, size))) + one_side(list(range(anchor, -1, -1)))


@pytest.mark.parametrize("steepness", [0.2, 2.0, 6.0, 40.0])
@pytest.mark.parametrize("step", [True, False])
def test_nothing_better_lies_outside_the_windows(steepness: float, step: bool) -> None:
    """Curves that the increments cannot follow: jumps, saw teeth and ramps, against a search
    without any window.
    """
    rng = np.random.default_rng(int(steepness * 10) + step)
    for trial in range(6):
        k, anchor = 16, int(rng.integers(0, 16))
        nodes = np.arange(k, dtype=float)
        positions = np.linspace(0.0, k - 1.0, 46)
        shape = (
            np.sign(np.sin(positions * rng.uniform(0.2, 2.5))),
            positions % 5.0,
            rng.normal(size=46),
        )[trial % 3]
        aims_at = steepness * shape + steepness * 0.3 * positions * rng.normal()
        points, weights = integral(positions, nodes)
        matrix = between(nodes, step, points)
        aims = np.interp(points, positions, aims_at)
        H = matrix.T @ (weights[:, np.newaxis] * matrix)
        expected = dictionary_search(
            np.diag(H), np.diag(H, 1), -matrix.T @ (weights * aims), 1.0, (-2, 1), anchor
        )
        expected += 0.5 * float(weights @ aims**2)
        rows = rows_at(
            points, nodes, below="hold", above="hold", interpolation="step" if step else "linear"
        )
        chain = build_chain(
            (ChainTarget(rows=rows, weights=weights, aims=aims),),
            k,
            fixed=(anchor,),
            kept=(),
            closed=False,
        )
        found = best_totals(
            (LatticePart(chain=chain, low=-1e6, high=1e6),),
            unit=1.0,
            increments=(-2, 1),
            magnifications=(1,),
        )
        assert found is not None
        assert found.objective == pytest.approx(expected, rel=SAME)
        assert found.bound <= found.objective * (1 + SAME)


def test_any_push_gives_a_bound() -> None:
    """Weak duality, whatever the multipliers: no table within the limits lies below the bound, at
    any reversal value.
    """
    rng = np.random.default_rng(4)
    nodes, positions = np.linspace(0.0, 40.0, 5), np.linspace(-3.0, 41.0, 9)
    points, weights = quadrature(positions, nodes)
    rows = rows_at(points, nodes, below="hold", above="hold")
    one, two = (np.interp(points, positions, rng.normal(size=9) * 3) for _ in range(2))
    wishes = (
        ChainTarget(rows=rows, weights=weights, aims=one),
        ChainTarget(rows=rows, weights=weights, aims=two, constant=True),
    )
    chain = build_chain(wishes, 5, fixed=(2,), kept=(), closed=False)
    limits = ChainLimits(step=0.5, increments=(-2, 3), low=np.full(5, -1.5), high=np.full(5, 1.0))
    steps = np.array(list(itertools.product(range(-2, 4), repeat=4))) * 0.5
    values = np.hstack([np.zeros((steps.shape[0], 1)), np.cumsum(steps, axis=1)])
    values -= values[:, [2]]
    values = values[np.all((values >= -1.5) & (values <= 1.0), axis=1)]
    matrix = hat_matrix(points, nodes, below="hold", above="hold").dense()
    for _ in range(40):
        size = 10.0 ** rng.uniform(-3, 1)
        push = LimitMultipliers(
            climb=size * rng.normal(size=4), bound=size * rng.normal(size=5) * (rng.random() < 0.5)
        )
        bound = priced(relax(chain, push), push, chain, limits)
        for reversal in (-2.0, -0.3, 0.0, 1.7):
            held = values @ matrix.T
            true = 0.5 * (((held - one) ** 2) @ weights + ((held + reversal - two) ** 2) @ weights)
            below = float(bound.bound(np.array([reversal - chain.constant]))[0])
            assert below <= float(np.min(true)) + 1e-9
            # The window: no table lies further from the bound's centre than its value allows.
            centre = bound.centres(np.array([reversal - chain.constant]))[0]
            assert np.all(
                (values - centre) ** 2
                <= 2.0 * np.outer(true - below, chain.inverse) * (1 + 1e-9) + 1e-9
            )
    free = relax(chain, closing_multipliers(chain))
    assert free.base == pytest.approx(chain.least, rel=1e-12)


def test_nodes_that_the_travel_does_not_see_take_even_steps() -> None:
    """The travel lies 60 mm from the reference: the six sections between climb as evenly as whole
    numbers can.
    """
    positions = np.linspace(63.0, 100.0, 20)
    wanted = wish(positions, np.full(20, 20 * UM), np.full(20, 20 * UM))
    result = fit(wanted, FANUC, spacing=10.0)
    # A constant is free: where the reference lies outside, the nearest end of the travel stands for
    # it and nothing remains to hold.
    assert result.compensation.positive == pytest.approx(0.0, abs=1e-12)
    part = LatticePart(chain=_far_chain(), low=-1e6, high=1e6)
    found = best_totals((part,), unit=1.0, increments=(-7, 7), magnifications=(1,))
    assert found is not None
    totals = part.chain.expanded(found.parts[0].totals)
    assert totals.tolist() == [0, 3, 7, 10, 13, 17, 20, 20, 20, 20, 20]


def _far_chain() -> Any:
    nodes = np.linspace(0.0, 100.0, 11)
    points, weights = quadrature(np.array([63.0, 78.0]), nodes)
    rows = rows_at(points, nodes, below="hold", above="hold")
    return build_chain(
        (ChainTarget(rows=rows, weights=weights, aims=np.full(points.size, 20.0)),),
        11,
        fixed=(0,),
        kept=(),
        closed=False,
    )


# --- magnification, limits, findings
# ----------------------------------------------------------------------------------

X = np.linspace(0.0, 800.0, 801)


def test_nothing_wanted_takes_the_smallest_magnification() -> None:
    result = fit(wish(X, 0.0 * X, 0.0 * X), FANUC, spacing=50.0)
    assert result.certificate["magnification"] == 1
    assert result.certificate["objective"] == 0.0
    assert result.compensation.positive == pytest.approx(0.0, abs=0.0)
    assert result.limits == ()


def test_a_slope_that_two_magnifications_hold_exactly_takes_the_smaller() -> None:
    # 4 µm in every section of 50 mm, between straight lines: magnifications 1, 2 and 4 leave
    # nothing.
    result = fit(wish(X, 8e-5 * X, 8e-5 * X), replace(FANUC, interpolation="linear"), spacing=50.0)
    assert result.certificate["magnification"] == 1
    assert result.certificate["objective"] == pytest.approx(0.0, abs=1e-9)
    steep = fit(wish(X, 16e-5 * X, 16e-5 * X), replace(FANUC, interpolation="linear"), spacing=50.0)
    assert steep.certificate["magnification"] == 2  # 8 µm: more than 7, and twice 4
    assert np.diff(steep.compensation.positive) == pytest.approx(8 * UM, abs=1e-12)
    # With 1 a straight line of 7/8 of the slope remains: 16 µm at the end, zero at the reference;
    # the reversal value takes its mean out of one direction: 16 sqrt((1/3 + 1/12) / 2) = 7.3 µm
    # rms.
    assert (
        "set to 2 instead of 1, which leaves nothing of the error. With magnification 1, one"
        " increment would be 1 µm. The control stores only ±7 increments per table point, so at"
        " least 7.3 µm rms would be left" in says(steep, "CW-F009")
    )


def test_the_quantum_that_counts_is_the_magnified_one() -> None:
    rng = np.random.default_rng(5)
    steep = 16e-5 * X + 3 * UM * np.sin(X / 37.0) + rng.normal() * 0.0
    result = fit(wish(X, steep, steep), replace(FANUC, interpolation="linear"), spacing=20.0)
    wide = fit(wish(X, 5 * steep, 5 * steep), replace(FANUC, interpolation="linear"), spacing=20.0)
    assert wide.certificate["magnification"] > result.certificate["magnification"] == 1
    assert causes(wide)["quantum"] > 1.5 * causes(result)["quantum"]
    assert causes(wide)["quantum"] == pytest.approx(
        np.sqrt(wide.certificate["objective"] ** 2 - wide.certificate["lower_bound"] ** 2),
        abs=1e-9,  # mm: both are settled to a picometre
    )


def test_an_error_steeper_than_every_magnification_costs_accuracy_and_is_no_refusal() -> None:
    small = replace(FANUC, lattice=replace(SEVEN, magnifications=(1, 2)), interpolation="linear")
    wanted = wish(X, 4e-4 * X, 4e-4 * X)  # 20 µm in 50 mm; 14 can be held
    result = fit(wanted, small, spacing=50.0)
    assert result.certificate["magnification"] == 2
    assert np.diff(result.compensation.positive) == pytest.approx(14 * UM, abs=1e-12)
    # 6/20 of 320 µm at the end, zero at the reference; the reversal value takes its mean out of one
    # direction.
    assert causes(result)["largest increment"] == pytest.approx(96 * np.sqrt(5 / 24) * UM, rel=1e-3)
    assert "CW-F008" in codes(result)
    assert "value range" not in causes(result)


def test_a_value_range_that_binds_is_told_from_increments() -> None:
    tight = replace(FANUC, value_range=(-40 * UM, 40 * UM), interpolation="linear")
    result = fit(wish(X, 1e-4 * X, 1e-4 * X), tight, spacing=50.0)
    assert result.compensation.positive.max() == pytest.approx(40 * UM, abs=1e-12)
    # The upper half stays at 40 of up to 80 µm: 40^2 / 6 in one direction; the reversal value takes
    # the square of the mean, 10 µm, out of the other. A little less with the best bend.
    assert causes(result)["value range"] == pytest.approx(
        np.sqrt(40**2 / 6 - 10**2 / 2) * UM, rel=0.05
    )
    assert "largest increment" not in causes(result)
    assert "CW-F007" in codes(result)


@pytest.mark.parametrize("goal", ["A", "E", "M"])
def test_other_goals_take_the_expected_square_and_say_so(goal: Literal["A", "E", "M"]) -> None:
    wanted = wish(X, 6 * UM * np.sin(X / 90.0), 6 * UM * np.sin(X / 90.0) + 3 * UM)
    usual, other = fit(wanted, FANUC, spacing=50.0), fit(wanted, FANUC, spacing=50.0, goal=goal)
    assert np.array_equal(usual.compensation.positive, other.compensation.positive)
    (left,) = (finding for finding in other.findings if finding.code == "CW-F010")
    assert left.values == {"goal": goal, "why": "increments"}
    assert "CW-F010" not in codes(usual)


def test_two_tables_only_where_the_job_asks() -> None:
    varying = wish(X, 0.0 * X, 3e-5 * X, reversal_log_odds=9.0)
    single, double = (
        fit(varying, FANUC, spacing=50.0),
        fit(varying, FANUC, spacing=50.0, mode="bidirectional"),
    )
    assert (single.mode, double.mode) == ("single", "bidirectional")
    assert "if the job requests" in single.mode_reason
    assert np.array_equal(single.compensation.positive, single.compensation.negative)
    assert single.compensation.backlash != 0.0
    assert double.compensation.backlash == 0.0
    # Half of 24 µm end to end stays between the curves: 24 / sqrt(12) / 2 in each direction.
    assert causes(single)["one table for both directions"] == pytest.approx(
        24 / np.sqrt(12) / 2 * UM, rel=0.2
    )
    smooth = replace(PLAIN, curves=2, second_curve="asked")
    assert fit(varying, smooth, spacing=50.0).compensation.backlash != 0.0
    assert (
        fit(varying, replace(smooth, second_curve="chosen"), spacing=50.0).mode == "bidirectional"
    )


def test_the_certificate_of_a_whole_table_sees_every_fault() -> None:
    wanted = wish(X, 6 * UM * np.sin(X / 90.0), 6 * UM * np.sin(X / 90.0))
    fitted = fit(wanted, FANUC, spacing=50.0)
    table, value = fitted.compensation, fitted.certificate["objective"] ** 2

    def refused(broken: AxisCompensation, claimed: tuple[float, float] | None = None) -> None:
        # Unless a claim is given it is the true one: it is the broken limit that must be seen.
        truth = (max(left_over(replace(fitted, compensation=broken), wanted), 1e-18), 0.0)
        with pytest.raises(CapacityError, match="no certified solution"):
            lattice_certificate(broken, wanted, FANUC, 1, truth if claimed is None else claimed)

    assert lattice_certificate(table, wanted, FANUC, 1, (value, 0.0))["primal"] == pytest.approx(
        0.0, abs=1e-9
    )
    for changed in (
        table.positive + 1 * UM,
        table.positive + 0.3 * UM * (np.arange(17) == 5),
        200.0 * table.positive,
    ):
        refused(replace(table, positive=changed, negative=changed))
    apart = replace(
        table, negative=table.negative + 0.5 * UM
    )  # the second table's own value is a whole number too
    refused(apart)
    refused(replace(table, period=800.0))  # an endless table that does not close
    refused(replace(table, backlash=0.3 * UM))
    refused(replace(table, backlash=20000 * UM))
    refused(table, (1.01 * value, 0.0))
    refused(table, (value, 1.01 * value))


# --- anchored grids
# --------------------------------------------------------------------------------------------------

OFFSET = wish(X - 350.0, wavy := 5 * UM * np.sin(X / 120.0), wavy, reference=7.0)


def test_nodes_hang_on_the_reference_and_cover_the_travel() -> None:
    nodes = fit(OFFSET, FANUC, spacing=50.0).compensation.positions
    assert nodes[0] == -393.0  # the travel is -350 to 450: reaching over it by less than 50 mm
    assert nodes[-1] == 457.0
    assert 7.0 in nodes
    free = fit(OFFSET, FANUC).compensation.positions
    steps = (free - 7.0) / (free[1] - free[0])
    assert steps == pytest.approx(np.round(steps), abs=1e-9)
    assert free[0] <= -350.0
    assert free[-1] >= 450.0


@pytest.mark.parametrize(
    ("request_", "pattern"),
    [
        (
            {"start": -350.0, "spacing": 50.0},
            r"table\.start.*starts at -393 or -343 mm \(the spacing is 50 mm\), found -350",
        ),
        (
            {"end": 450.0, "spacing": 50.0},
            r"table\.end.*ends at 407 or 457 mm \(the spacing is 50 mm\), found 450",
        ),
        (
            {"start": 20.0},
            r"table\.start.*reference.*start: 7 \(mm\) or a position below it, found 20",
        ),
        ({"end": 0.0, "spacing": 50.0}, r"table\.end.*end: 7 \(mm\) or a position above it"),
        ({"spacing": 0.5}, r"too many points.*at most 1024 points, found 1601"),
        ({"spacing": 0.00125}, r"multiple of 0\.001 mm, such as 0\.001"),
    ],
)
def test_grids_that_an_anchored_control_does_not_take(
    request_: dict[str, float], pattern: str
) -> None:
    with pytest.raises(CapacityError, match=pattern):
        fit(OFFSET, FANUC, **request_)


def test_both_ends_are_told_at_once_and_what_fits_is_taken() -> None:
    with pytest.raises(CapacityError) as caught:
        fit(OFFSET, FANUC, start=-350.0, end=450.0, spacing=50.0)
    assert len(caught.value.faults) == 2
    result = fit(OFFSET, FANUC, start=-343.0, end=407.0, spacing=50.0)
    assert result.compensation.positions[[0, -1]].tolist() == [-343.0, 407.0]
    assert "CW-F001" in codes(result)  # 407 to 450 mm: the end value is held
    nodes = fit(OFFSET, FANUC, start=-343.0).compensation.positions
    assert nodes[0] == -343.0
    assert 350.0 / (nodes[1] - nodes[0]) == pytest.approx(
        round(350.0 / (nodes[1] - nodes[0])), abs=1e-9
    )
    with pytest.raises(UsageError, match="start below end"):
        fit(OFFSET, FANUC, start=400.0, end=-100.0)


def test_a_table_reaches_from_a_reference_outside_the_travel() -> None:
    far = replace(OFFSET, reference=-700.0)
    result = fit(far, FANUC, spacing=50.0)
    assert result.compensation.positions[0] == -700.0
    assert result.compensation.positions[-1] == 450.0
    assert "7 of the 24 points lie beyond the travel" in says(result, "CW-F006")
    assert result.compensation.positive[0] == 0.0
    # The datum is free: within the travel the error is corrected as well as from within.
    assert result.certificate["objective"] < 1.2 * UM


def test_the_least_spacing_and_its_reason() -> None:
    slow = replace(
        FANUC,
        min_spacing=2.0,
        min_spacing_reason=say("as_written", text="15000 mm/min need 2 mm between steps"),
    )
    with pytest.raises(CapacityError, match=r"15000 mm/min.*at least 2 mm, found 1 mm"):
        fit(OFFSET, slow, spacing=1.0)
    rough = replace(
        OFFSET,
        positive=OFFSET.positive + 9 * UM * np.sin(X / 1.1),
        negative=OFFSET.negative + 9 * UM * np.sin(X / 1.1),
    )
    nodes = fit(rough, slow).compensation.positions
    assert nodes[1] - nodes[0] >= 2.0
    plain = replace(PLAIN, min_spacing=2.0, min_spacing_reason=say("as_written", text="why"))
    with pytest.raises(CapacityError, match="why"):
        fit(OFFSET, plain, start=-350.0, end=450.0, spacing=1.0)
    nodes = fit(rough, replace(plain, max_points=1000)).compensation.positions
    assert nodes[1] - nodes[0] >= 2.0


def test_only_the_spacings_that_there_are() -> None:
    powers = tuple(0.0001 * 2**n for n in range(1, 25))
    certain = replace(PLAIN, position_quantum=1e-4, spacings=powers, max_points=256)
    result = fit(OFFSET, certain)
    nodes = result.compensation.positions
    assert any(nodes[1] - nodes[0] == pytest.approx(one, abs=1e-9) for one in powers)
    assert nodes[0] <= -350.0
    assert nodes[-1] >= 450.0
    with pytest.raises(CapacityError, match=r"26\.2144 or 52\.4288 mm, found 50 mm"):
        fit(OFFSET, certain, spacing=50.0)
    named = fit(OFFSET, certain, start=-350.0, spacing=26.2144).compensation.positions
    assert named[:2].tolist() == [-350.0, -323.7856]
    assert named[-1] >= 450.0
    anchored = fit(OFFSET, replace(certain, anchored=True), spacing=26.2144).compensation.positions
    assert (anchored - 7.0) / 26.2144 == pytest.approx(
        np.round((anchored - 7.0) / 26.2144), abs=1e-6
    )


def test_a_finer_spacing_is_taken_where_increments_need_it() -> None:
    steep = wish(X, 1e-4 * X, 1e-4 * X)  # 7 µm in 70 mm
    nodes = fit(steep, replace(FANUC, interpolation="linear")).compensation.positions
    assert nodes[1] - nodes[0] <= 70.0
    # 2.5 µm/mm needs magnification 2 from 4 mm (201 points, 10 µm) to 5 mm (12.5 µm): the coarser
    # of the two will do.
    ramp = wish(X, 2.5e-3 * X, 2.5e-3 * X)
    nodes = fit(ramp, replace(FANUC, interpolation="linear", max_points=201)).compensation.positions
    assert nodes[1] - nodes[0] == pytest.approx(5.0)
    few = replace(FANUC, interpolation="linear", max_points=6)
    result = fit(steep, few)  # 16 µm in 160 mm: magnification 3 at least
    assert result.compensation.positions.size <= 6
    assert result.certificate["magnification"] >= 3
    assert "CW-F008" not in codes(result)


# --- steps, endless axes, slopes
# --------------------------------------------------------------------------------------


def test_steps_change_in_the_middle_and_the_upper_node_has_it() -> None:
    nodes = np.array([0.0, 10.0, 30.0])
    where = np.array([-1.0, 4.999, 5.0, 19.999, 20.0, 31.0])
    matrix = hat_matrix(where, nodes, below="hold", above="hold", interpolation="step").dense()
    assert np.argmax(matrix, axis=1).tolist() == [0, 0, 1, 1, 2, 2]
    table = AxisCompensation(
        address="1",
        kind=AxisKind.LINEAR,
        positions=nodes,
        positive=np.arange(3.0),
        negative=np.arange(3.0),
        interpolation="step",
    )
    assert table.at(where, POSITIVE).tolist() == [0, 0, 1, 1, 2, 2]


def test_a_step_table_without_whole_increments_holds_the_mean_of_each_section() -> None:
    wanted = wish(X, 1e-4 * X, 1e-4 * X)
    alone = replace(
        PLAIN, interpolation="step", backlash_quantum=None
    )  # a reversal value would take the first section's mean
    result = fit(wanted, alone, spacing=100.0)
    # The node at the reference is zero; each other holds the mean over its section of +-50 mm, the
    # last over 750 to 800.
    expected = np.append(np.append(0.0, np.arange(1, 8) * 10.0), 77.5) * UM
    assert result.compensation.positive == pytest.approx(expected, abs=1e-6)
    assert result.compensation.interpolation == "step"
    spread = fit(wanted, alone, spacing=100.0, goal="E").compensation
    # Within each section the error runs over 10 µm whatever the step's height: no table leaves
    # less, and this one leaves no more.
    fine = np.linspace(0.0, 800.0, 80001)
    assert np.ptp(spread.at(fine, POSITIVE) - np.interp(fine, X, wanted.positive)) == pytest.approx(
        10 * UM, abs=0.02 * UM
    )


def test_the_least_range_of_a_step_table_counts_both_sides_of_each_step() -> None:
    """A linear program over positions just left and right of every step, and at every bend of the
    wish.
    """
    from scipy.optimize import linprog

    where = np.array([0.0, 100.0, 200.0, 300.0, 400.0])
    curve = np.array([0.0, 0.0, 20.0, 20.0, 60.0]) * UM
    alone = replace(PLAIN, interpolation="step", backlash_quantum=None)
    table = fit(wish(where, curve, curve), alone, spacing=100.0, goal="E").compensation
    midpoints = np.array([50.0, 150.0, 250.0, 350.0])
    dense = np.sort(np.concatenate([where, midpoints - 1e-7, midpoints + 1e-7]))
    matrix = between(where, step=True, where=dense)[:, 1:]
    aims, ones = np.interp(dense, where, curve), np.ones((dense.size, 1))
    program = linprog(
        [0, 0, 0, 0, 1, -1],
        A_ub=np.vstack(
            [np.hstack([matrix, -ones, 0 * ones]), np.hstack([-matrix, 0 * ones, ones])]
        ),
        b_ub=np.concatenate([aims, -aims]),
        bounds=[(None, None)] * 6,
    )
    reached = float(np.ptp(table.at(dense, POSITIVE) - aims))
    assert reached == pytest.approx(
        program.fun, abs=2e-3 * UM
    )  # 1 nm of the certificate and the quantum


TURN = np.linspace(0.0, 360.0, 361)


def rotary(shape: Array, **more: Any) -> WantedCorrection:
    return wish(TURN, shape, shape + 2 * UM, kind=AxisKind.ROTARY, **more)


@pytest.mark.parametrize("reference", [0.0, 30.0])
@pytest.mark.parametrize("mode", ["single", "bidirectional"])
def test_an_endless_table_closes(
    reference: float, mode: Literal["single", "bidirectional"]
) -> None:
    shape = 8 * UM * np.sin(np.radians(TURN)) + 2 * UM * np.cos(np.radians(3 * TURN))
    shape -= np.interp(reference, TURN, shape)
    capacity = replace(PLAIN, curves=2, period=360.0, quantum=1e-5)
    table = fit(rotary(shape, reference=reference), capacity, spacing=15.0, mode=mode).compensation
    assert table.positions[[0, -1]].tolist() == [reference, reference + 360.0]
    assert table.period == 360.0
    for curve in (table.positive, table.negative):
        assert curve[-1] == curve[0]
    assert table.positive[0] == 0.0
    # Before the reference the table is that of a turn later.
    assert table.at(TURN, POSITIVE) == pytest.approx(shape, abs=0.2 * UM)
    assert table.at(TURN, NEGATIVE) == pytest.approx(shape + 2 * UM, abs=0.2 * UM)


def test_an_endless_table_is_the_best_that_closes() -> None:
    """Least squares over points with the first and the last node as one unknown, zero at the
    reference; the reversal beside it.
    """
    shape = 8 * UM * np.sin(np.radians(TURN)) + 3 * UM * (1 - np.cos(np.radians(2 * TURN)))
    table = fit(rotary(shape), replace(PLAIN, period=360.0), spacing=45.0).compensation
    fine = np.linspace(0.0, 360.0, 72001)
    hats = between(np.linspace(0.0, 360.0, 9), step=False, where=fine)[:, 1:-1]
    none, one = np.zeros((fine.size, 1)), np.ones((fine.size, 1))
    matrix = np.vstack([np.hstack([hats, none]), np.hstack([hats, -one])])
    aims = np.concatenate([np.interp(fine, TURN, shape), np.interp(fine, TURN, shape + 2 * UM)])
    expected = np.linalg.lstsq(matrix, aims, rcond=None)[0]
    # Summing over points 0.005 deg apart instead of integrating leaves far less than a nanometre.
    assert table.positive[1:-1] == pytest.approx(expected[:-1], abs=1e-3 * UM)
    assert table.positive[[0, -1]].tolist() == [0.0, 0.0]
    assert table.backlash == pytest.approx(expected[-1], abs=1e-3 * UM)


def test_an_endless_table_spans_one_period_and_divides_it() -> None:
    capacity = replace(PLAIN, period=360.0)
    with pytest.raises(CapacityError, match=r"24 or 30 deg, found 26 deg"):
        fit(rotary(0.0 * TURN), capacity, spacing=26.0)
    with pytest.raises(CapacityError) as caught:
        fit(rotary(0.0 * TURN), capacity, start=10.0, end=300.0)
    assert len(caught.value.faults) == 2
    assert (
        fit(
            rotary(0.0 * TURN), capacity, start=0.0, end=360.0, spacing=30.0
        ).compensation.positions.size
        == 13
    )
    nodes = fit(
        rotary(5 * UM * np.sin(np.radians(2 * TURN))), replace(FANUC, period=360.0)
    ).compensation.positions
    assert 360.0 / (nodes[1] - nodes[0]) == pytest.approx(nodes.size - 1, abs=1e-9)


def test_one_period_from_another_start_and_over_several_turns() -> None:
    two_turns = np.linspace(-360.0, 360.0, 721)
    wave = np.sin(np.radians(two_turns))
    other = wave + np.where(
        two_turns < 0, 0.5, -0.5
    )  # the two turns differ by one: their mean is the wave
    wrapped = over_one_period(
        wish(two_turns, wave, other, kind=AxisKind.ROTARY, reference=90.0), 360.0
    )
    assert wrapped.positions[[0, -1]].tolist() == [90.0, 450.0]
    assert wrapped.positive == pytest.approx(np.sin(np.radians(wrapped.positions)), abs=1e-12)
    inner = np.abs((wrapped.positions - 360.0 + 180.0) % 360.0 - 180.0) > 1.0
    assert wrapped.negative[inner] == pytest.approx(
        np.sin(np.radians(wrapped.positions[inner])), abs=1e-12
    )
    part = over_one_period(
        wish(np.array([10.0, 350.0]), np.array([1.0, 3.0]), np.zeros(2), kind=AxisKind.ROTARY),
        360.0,
    )
    assert part.positive == pytest.approx(
        [2.0, 1.0, 3.0, 2.0]
    )  # bridged by a straight line from 350 to 10


def lines(rng: np.random.Generator) -> Iterator[tuple[WantedCorrection, Capacity]]:
    where = np.linspace(0.0, 800.0, 41)
    for _ in range(60):
        home = POSITIVE if rng.random() < 0.5 else NEGATIVE
        reference = float(rng.choice([0.0, 400.0, -100.0, 800.0]))
        curve = rng.normal() * 4e-5 * (where - reference) + rng.normal() * 3 * UM * np.sin(
            where / 100.0
        )
        shift = rng.normal() * 4 * UM
        sides = (curve, curve + shift) if home is POSITIVE else (curve + shift, curve)
        capacity = replace(
            PLAIN,
            line=1e-5 if rng.random() < 0.5 else 2e-7,
            value_range=(-3e-5, 5e-5),
            backlash_quantum=(
                None if rng.random() < 0.3 else 2 * UM
            ),  # its rounding moves the best slope by up to 1e-6: five of the finer
            backlash_range=(-4 * UM, 6 * UM),
        )
        yield wish(where, *sides, reference=reference, reference_return=home), capacity


def straight_means(wanted: WantedCorrection, slopes: Array, backlash: float) -> Array:
    """The mean squares (n,) that slopes and a backlash leave, integrated here; a constant is no
    error: it moves the zero.
    """
    points, weights = integral(wanted.positions, wanted.positions)
    total, mean = np.zeros(slopes.size), np.zeros(slopes.size)
    for direction in (POSITIVE, NEGATIVE):
        reversal = 0.0 if direction is wanted.reference_return else direction.sign * backlash
        held = np.outer(slopes, points - wanted.reference) + reversal
        left = held - np.interp(points, wanted.positions, wanted.total(direction))
        total += 0.5 * left**2 @ weights
        mean += 0.5 * left @ weights
    return np.asarray(total - mean**2)


def test_a_slope_equals_brute_force() -> None:
    for wanted, capacity in lines(np.random.default_rng(8)):
        result = fit(wanted, capacity)
        table = result.compensation
        assert table.positions.size == 0
        assert table.origin == wanted.reference
        backlashes = (
            [0.0]
            if capacity.backlash_quantum is None
            else [-4 * UM, -2 * UM, 0.0, 2 * UM, 4 * UM, 6 * UM]
        )
        quantum = capacity.line or 1.0
        slopes = (
            np.arange(round(-3e-5 / quantum), round(5e-5 / quantum) + 1).astype(np.float64)
            * quantum
        )
        best = min(
            float(np.min(straight_means(wanted, slopes, backlash))) for backlash in backlashes
        )
        assert straight_means(wanted, np.array([table.slope]), table.backlash)[0] <= best * (
            1 + SAME
        )
        assert table.slope / quantum == pytest.approx(round(table.slope / quantum), abs=1e-9)
        assert result.certificate["objective"] == pytest.approx(np.sqrt(best), rel=1e-7)


def test_the_backlash_beside_a_slope_is_the_mean_lost_motion() -> None:
    """Whatever curve a straight line leaves: 5 µm of lost motion are 5 µm, and the slope is that of
    the regression line.
    """
    curve = 15 * UM * np.cos(X / 200.0) - 3e-5 * X
    capacity = replace(
        PLAIN,
        line=1e-6,
        value_range=(-1e-3, 1e-3),
        backlash_quantum=0.1 * UM,
        backlash_range=(-1.0, 1.0),
    )
    table = fit(wish(X, curve, curve - 5 * UM), capacity).compensation
    assert table.backlash == pytest.approx(5 * UM, abs=0.05 * UM)  # half a quantum
    assert table.slope == pytest.approx(
        np.polyfit(X, curve, 1)[0], abs=0.6e-6
    )  # half a quantum, and 401 points for the travel


def test_what_a_slope_leaves_and_refuses() -> None:
    capacity = replace(
        PLAIN,
        line=1e-6,
        value_range=(-1e-3, 1e-3),
        backlash_quantum=None,
        backlash_range=(0.0, 0.0),
    )
    bent = wish(
        X, 1e-5 * X + 4 * UM * np.sin(X / 50.0), 1e-5 * X + 4 * UM * np.sin(X / 50.0) + 6 * UM
    )
    result = fit(bent, capacity, goal="A")
    assert {"a straight line instead of a table", "no backlash value"} <= set(causes(result))
    assert causes(result)["a straight line instead of a table"] == pytest.approx(
        4 / np.sqrt(2) * UM, rel=0.1
    )
    assert {"CW-F005", "CW-F010"} <= set(codes(result))
    steep = fit(wish(X, 2e-3 * X, 2e-3 * X), capacity)
    assert steep.compensation.slope == pytest.approx(1e-3, abs=1e-15)
    assert causes(steep)["value range"] == pytest.approx(800 * 1e-3 / np.sqrt(12), rel=1e-3)
    with pytest.raises(CapacityError) as caught:
        fit(bent, capacity, start=0.0, spacing=50.0)
    assert [fault.place for fault in caught.value.faults] == ["table.start", "table.spacing"]
