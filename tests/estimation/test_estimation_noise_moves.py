"""How traverses are moved and which of them: against tables, sums and a count of all sets."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from compwright.estimation.noise import infer_noise
from compwright.estimation.noise_move_selection import (
    ScoreEvidence,
    draw_moved,
    draw_share,
    drawn_from_prior,
)
from compwright.estimation.noise_patterns import Patterns, build_patterns
from compwright.estimation.noise_readings import cell_readings
from compwright.prediction.fresh_noise import fresh_noise
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import WALK, wave_effects, without
from compwright.records.positioning import PositioningTest

MOVES = 4


def jeffreys(there: int, count: int) -> float:
    """Chance that just these ``there`` of ``count`` happen, by numerical integration over the
    share: its prior is even in arcsin(sqrt(share)).
    """
    angles = (np.arange(2000) + 0.5) / 2000 * np.pi / 2
    share = np.sin(angles) ** 2
    return float(np.mean(share**there * (1.0 - share) ** (count - there)))


def chance_of(
    moved: tuple[int, ...], moves: FloatArray, scores: FloatArray, rest: float, dof: int
) -> float:
    """Posterior, up to a factor, of a set of moves: its prior times the density of the scores, the
    variance integrated out (Student's, by the determinant and the quadratic form as they stand).
    """
    there = moves[np.array(moved, dtype=bool)]
    matrix = np.eye(scores.size) + there.T @ there
    square = rest + scores @ np.linalg.inv(matrix) @ scores
    prior = 0.5 * jeffreys(sum(moved), MOVES) + 0.5 * (sum(moved) == MOVES)
    return float(prior * np.linalg.det(matrix) ** -0.5 * square ** (-0.5 * dof))


def test_each_set_of_moves_is_drawn_as_often_as_it_is_probable() -> None:
    """16 sets, 4000 sweeps that depend on each other little: three standard errors of 2000."""
    rng = np.random.default_rng(5)
    moves = 1.2 * rng.standard_normal((MOVES, 3))
    scores, rest, dof = np.array([1.5, -0.5, 2.0]), 20.0, 24
    known = {
        each: chance_of(each, moves, scores, rest, dof) for each in product((0, 1), repeat=MOVES)
    }
    total = sum(known.values())
    evidence = ScoreEvidence(np.eye(3), scores, rest, dof)
    state = np.ones(MOVES, dtype=np.bool_)
    counts = dict.fromkeys(known, 0)
    for _ in range(4000):
        state = draw_moved(state, moves, evidence, rng)
        counts[tuple(state.astype(int).tolist())] += 1
    for each, weight in known.items():
        chance = weight / total
        assert counts[each] / 4000 == pytest.approx(
            chance, abs=3.0 * np.sqrt(chance * (1.0 - chance) / 2000) + 1e-3
        )


@pytest.fixture(scope="module")
def patterns() -> Patterns:
    """Of five targets, three runs up and down in turn."""
    targets, readings = np.linspace(0.0, 400.0, 5), np.zeros((5, 3))
    test = PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=readings,
        negative=readings,
        runs_positive=(1, 2, 3),
        runs_negative=(1, 2, 3),
        frame="machine",
    )
    return build_patterns(cell_readings(test), "standard", (3, 3))


def test_steps_of_the_zero_point_make_a_random_walk_from_the_middle(patterns: Patterns) -> None:
    """Brownian motion either way: the covariance is the smaller of the two times, or nothing.
    Traverses + at -3, -1, 1 from the middle of the test, - at -2, 0, 2; no step tilts anything.
    """
    steps = patterns.moves[WALK].reshape(6, 2, 2, 3)
    assert not np.any(steps[:, :, 1])
    found = np.einsum("sij,skl->ijkl", steps[:, :, 0], steps[:, :, 0]).reshape(6, 6)
    times = np.array([-3.0, -1.0, 1.0, -2.0, 0.0, 2.0])
    alike = np.multiply.outer(times, times) > 0.0
    assert found == pytest.approx(alike * np.minimum.outer(np.abs(times), np.abs(times)))


def test_a_wave_that_rises_on_the_way_up_rises_on_the_way_down(patterns: Patterns) -> None:
    """Its tilt along the travel turns with the direction; what rises in + lies higher in -."""
    waves = patterns.waves[2].reshape(2, 2, 3, 2, 2, 3)  # the slowest one without a period
    up, down = (0, 1, 1), (1, 1, 1)
    assert waves[(*up, *down)] < 0.0
    assert waves[(*up, 1, 0, 1)] - waves[(*up, 0, 0, 1)] > 0.0
    assert waves[(*down, 1, 0, 1)] - waves[(*down, 0, 0, 1)] < 0.0


def test_share_that_is_moved_before_and_after_a_test() -> None:
    """Before: all in half of the cases and, of the others, in C(20, 10) / 4^10 = 0.176 for ten
    (arcsine law: Feller, An Introduction to Probability Theory, volume 1, 3rd ed. 1968, chapter
    III.4). After all ten were: all of them in 0.5 / 0.588. After one: Beta(1.5, 9.5), mean 3/22.
    """
    rng = np.random.default_rng(6)
    every = np.mean([np.all(drawn_from_prior(10, rng)) for _ in range(4000)])
    assert every == pytest.approx(0.588, abs=0.031)
    ones = np.ones(10, dtype=np.bool_)
    assert np.mean([draw_share(ones, rng) == 1.0 for _ in range(4000)]) == pytest.approx(
        0.85, abs=0.023
    )
    shares = [draw_share(np.arange(10) == 3, rng) for _ in range(4000)]
    assert np.mean(shares) == pytest.approx(3.0 / 22.0, abs=0.0063)


@pytest.mark.parametrize(("pace", "cycles"), [(0.1, 0.0), (0.4, 0.0), (2.0, 1.55)])
def test_a_wave_moves_a_traverse_as_the_sum_over_its_readings_says(
    pace: float, cycles: float
) -> None:
    """Straight lines fitted by least squares to 200 readings of each traverse of such a process:
    its covariance multiplied out.
    """
    m, order, signs = 200, np.array([0.0, 3.0]), np.array([1.0, -1.0])
    u = (np.arange(m) + 0.5) / m * 2.0 - 1.0
    times = ((order + 0.5) / 4.0)[:, np.newaxis] + 0.125 * np.outer(signs, u)
    between = np.abs(np.subtract.outer(times.ravel(), times.ravel()))
    apart = np.sqrt(3.0) * between / pace
    swings = np.cos(2.0 * np.pi * cycles * between)
    covariance = ((1.0 + apart) * np.exp(-apart) * swings).reshape(2, m, 2, m)
    lines = np.linalg.pinv(np.column_stack([np.ones(m), u]))
    expected = np.einsum("ap,ipjq,bq->aibj", lines, covariance, lines)
    assert wave_effects(order, signs, 4, pace, cycles) == pytest.approx(expected, abs=0.01)


@pytest.mark.parametrize(("cycles", "phase"), [(1.7, 2.0), (2.6, 4.0), (3.4, 1.0)])
def test_a_wave_with_a_period_may_be_half_as_large_in_the_next_test(
    cycles: float, phase: float
) -> None:
    """Sine and cosine of a wave of unknown size w are normal numbers, so an amplitude has two
    degrees of freedom. With a prior of w between 1/w and 1/w^2 the squared amplitude of the next
    test is below a quarter of the first with a probability of 0.2 (F(2, 2)) to 0.28 (1 -
    1.25^-1.5). A wave without a period, with a size never below the observed one, leaves 0.06.
    """
    m, n, size = 21, 5, 3e-3
    run, place = np.arange(n), np.arange(m)[:, np.newaxis] / m
    time = np.stack([run + 0.5 * place, run + 1.0 - 0.5 * place]) / n
    wave = size * np.sin(2.0 * np.pi * cycles * time + phase)
    readings = wave + 1e-3 * np.random.default_rng(5).standard_normal(wave.shape)
    test = PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=np.linspace(0.0, 1000.0, m),
        positive=readings[0],
        negative=readings[1],
        frame="machine",
    )
    found = infer_noise(test)
    assert found is not None
    waves = without(found.fresh, "scatter", "drift")
    fresh = np.stack(fresh_noise(waves, test.targets, n, n, np.random.default_rng(6)), axis=1)
    half = 0.5 * size / np.sqrt(2.0)
    assert 0.1 < np.mean(np.std(fresh, axis=(1, 2, 3)) < half) < 0.45
