"""Numbers of the estimation that no whole fit shows clearly: each against a formula from outside,
tabulated or differentiated numerically.
"""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from circle_machine import Machine, Setup, distance, measured
from compwright.estimation.basis import hidden_share, log_density, smooth_density
from compwright.estimation.cholesky import cholesky_factor, factor_and_solve, inverse_triangle
from compwright.estimation.circle_centre import second_order
from compwright.estimation.circle_cyclic import (
    cyclic_columns,
    longest_pitch,
    search_cyclic,
    shortest_pitch,
)
from compwright.estimation.circle_equations import circle_problem
from compwright.estimation.circle_fit import fit_causes, white_problems
from compwright.estimation.circle_lag import Lag, at_actual_angles, shrink_uncertainty
from compwright.estimation.circle_model import (
    CircleSamples,
    SpikeShape,
    TakeUp,
    circle_samples,
    fixed_columns,
    lag_column,
    since_reversal,
    spike_curves,
)
from compwright.estimation.circle_noise import angle_grid
from compwright.estimation.circle_reversal import of_the_spike
from compwright.estimation.hyperparameters import _log_student, draw_hyperparameters
from compwright.estimation.posterior_peaks import find_peaks

Array = NDArray[np.float64]
R = 150.0
UM = 1e-3


def samples(sense: float = 1.0, count: int = 360) -> CircleSamples:
    theta = np.radians((np.arange(count) + 0.5) * 360.0 / count)
    return CircleSamples(
        theta=theta,
        sense=np.full(count, sense),
        deviations=np.zeros(count),
        run=np.zeros(count),
        radius=R,
        speed=2000.0 / 60.0,
        arc=(0.0, 2.0 * np.pi),
        lag_std=1e-3,
    )


def radial(of: CircleSamples, x: Array, y: Array) -> Array:
    return np.asarray(x * np.cos(of.theta) + y * np.sin(of.theta))


# ---------------------------------------------------------------- circles

#: Radial deviation, µm by rad, of one unit of each cause (handbook's table; the first
#: harmonic of a sag belongs to the centre): mismatch over the diameter, squareness in µm/m.
SHAPES: dict[str, Any] = {
    "scale_mismatch": lambda t: 0.25 * np.cos(2 * t),
    "squareness": lambda t: -0.5 * R * 1e-3 * np.sin(2 * t),
    "straightness_first": lambda t: np.cos(t) ** 2 * np.sin(t) - 0.25 * np.sin(t),
    "straightness_second": lambda t: np.sin(t) ** 2 * np.cos(t) - 0.25 * np.cos(t),
    "backlash_first": lambda t: 0.5 * np.sign(np.sin(t)) * np.cos(t),
    "backlash_second": lambda t: -0.5 * np.sign(np.cos(t)) * np.sin(t),
    "lateral_play_first": lambda t: -0.5 * np.abs(np.sin(t)),
    "lateral_play_second": lambda t: 0.5 * np.abs(np.cos(t)),
    "_centre_x": lambda t: np.cos(t) / UM,
    "_centre_y": lambda t: np.sin(t) / UM,
}


#: These change their sign with the direction: the shapes are those of ccw.
ODD = ("backlash", "lateral_play")


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("name", sorted(SHAPES))
def test_a_lag_moves_the_trace_of_a_cause_by_its_slope(name: str, sense: float) -> None:
    """What was measured at θ belongs to θ - d lag: the trace differs by -d lag times its slope."""
    of, value, h = samples(sense), 7.0, 1e-6
    ends = [f"{name}_at_{end}" for end in ("positive", "negative")]
    known = dict.fromkeys(ends if name.startswith("backlash") else [name], value)
    found = lag_column(of, fixed_columns(of), known)
    shape, sign = SHAPES[name], sense if name.startswith(ODD) else 1.0
    slope = (shape(of.theta + h) - shape(of.theta - h)) / (2.0 * h)
    expected = -sense * sign * of.lag_std * value * UM * slope
    assert radial(of, found.x, found.y) == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_a_late_machine_is_seen_where_it_is() -> None:
    """Constant feed: what is commanded at θ arrives d v T / R later."""
    of = samples(-1.0)
    assert at_actual_angles(of, Lag(2e-3, 1e-4, clear=True)).theta == pytest.approx(
        of.theta + 2e-3, abs=1e-15
    )
    assert at_actual_angles(samples(), Lag(2e-3, 1e-4, clear=True)).theta == pytest.approx(
        of.theta - 2e-3, abs=1e-15
    )
    assert at_actual_angles(of, Lag(2e-3, 1e-4, clear=True)).lag_std == 1e-4


@pytest.mark.parametrize("axis", ["first", "second"])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_spike_is_that_of_the_exact_machine(axis: str, sense: float) -> None:
    of = samples(sense)
    causes: dict[str, Any] = {f"reversal_spike_{axis}": 5.0, f"decay_{axis}": 6.0}
    machine = Machine(**causes)
    parts = [
        spike_curves(of, axis, end, [SpikeShape(6.0, False)])[0] for end in ("positive", "negative")
    ]
    exact = distance(machine, Setup(), of.theta, sense) - R
    moved = np.outer([axis == "first", axis == "second"], np.sum(parts, axis=0))
    spike = radial(of, *moved)
    assert 5.0 * spike == pytest.approx(exact, abs=1e-6)


def test_an_axis_that_stands_still_passes_its_lost_motion_or_overcomes_its_friction() -> None:
    """Friction holds the axis until the command has moved 3 µm, arc²/2R = 0.95 mm on R = 150; from
    there the spike decays over 1 mm: 3 exp(0.95) = 7.75 µm at the reversal, from which the take-up
    takes 7.75 off. Lost motion of 3 µm that is passed gradually takes 3 off.
    """
    taken, spike, lost = np.array([[-7.75], [-3.0], [2.0]]), np.array([[7.75], [1.0], [0.0]]), 3.0
    kept = of_the_spike(taken, spike, np.full((3, 1), lost))
    assert kept.ravel().tolist() == [-7.75, 0.0, 2.0]


def test_a_rising_spike_has_its_peak_of_one_at_its_length() -> None:
    """s exp(1 - s): 1 at s = 1, 2/e at 2, 0.5 exp(0.5) at a half."""
    shape = SpikeShape(4.0, rising=True)
    expected = [0.0, 0.5 * np.exp(0.5), 1.0, 2.0 / np.e]
    assert shape(np.array([0.0, 2.0, 4.0, 8.0])) == pytest.approx(expected)


def test_lost_motion_is_taken_up_over_the_arc_that_covers_it() -> None:
    """The command of an axis that reversed goes back R (1 - cos φ): 4 µm on 150 mm are 1.095 mm of
    arc; after half of it a quarter is taken up.
    """
    arc = 150.0 * np.arccos(1.0 - 4e-3 / 150.0)
    shape = TakeUp(float(np.sqrt(2.0 * 4e-3 * 150.0)))
    assert shape.length == pytest.approx(arc, rel=1e-5)
    travelled = 150.0 * (1.0 - np.cos(np.array([0.0, arc / 2.0, arc, 2.0 * arc]) / 150.0))
    expected = np.maximum(1.0 - travelled / 4e-3, 0.0)
    assert shape(np.array([0.0, arc / 2.0, arc, 2.0 * arc])) == pytest.approx(expected, abs=1e-4)


@pytest.mark.parametrize("axis", ["first", "second"])
def test_a_cyclic_error_and_its_change_with_frequency(axis: str) -> None:
    of, a, b, f = samples(), 2.0, -1.5, 0.1
    cosine, sine, change = cyclic_columns(of, axis, f, (a, b))[:3]
    along = R * (np.cos(of.theta) if axis == "first" else np.sin(of.theta))

    def field(frequency: float) -> Array:
        phase = 2.0 * np.pi * frequency * along
        return np.asarray(UM * (a * np.cos(phase) - b * np.sin(phase)))

    moved = [column.x if axis == "first" else column.y for column in (cosine, sine, change)]
    assert a * moved[0] + b * moved[1] == pytest.approx(field(f), abs=1e-12)
    h = 1e-8
    assert moved[2] == pytest.approx((field(f + h) - field(f - h)) / (2 * h), abs=1e-4)
    other = [column.y if axis == "first" else column.x for column in (cosine, sine, change)]
    assert not np.any(other)


def test_arc_since_the_reversal() -> None:
    """A quarter of the circle is 235.62 mm; the first axis turns at 0° and 180°."""
    of = samples()
    quarter = 0.5 * np.pi * R
    at = int(np.argmin(np.abs(of.theta - np.radians(90.5))))
    half_degree = R * np.radians(0.5)
    assert since_reversal(of, "first")[at] == pytest.approx(quarter + half_degree)
    assert since_reversal(of, "second")[at] == pytest.approx(half_degree)
    back = samples(-1.0)
    assert since_reversal(back, "first")[at] == pytest.approx(quarter - half_degree)
    assert since_reversal(back, "second")[at] == pytest.approx(2.0 * quarter - half_degree)


def test_the_second_order_of_a_centre_is_exact() -> None:
    """3-4-5: at θ = 0 a centre (0, 40) on R = 30 is 50 away, 20 more than R and nothing of first
    order.
    """
    found = second_order(np.array([0.0, 0.5 * np.pi]), (0.0, 40.0), 30.0)
    assert found == pytest.approx([20.0, 0.0], abs=1e-12)


@pytest.mark.parametrize(("start", "extent"), [(0.0, 360.0), (40.0, 220.0), (300.0, 100.0)])
def test_runs_are_laid_on_one_grid_from_the_start_of_the_arc(start: float, extent: float) -> None:
    """A run whose samples lie on the grid's places is taken as it is, in order of the angle."""
    test = measured(Machine(), Setup(samples=88, start=start, extent=extent))
    of = circle_samples(test)
    grid = angle_grid(of)
    assert grid.size == 88
    for index, sense in zip(grid.index, (1.0, -1.0), strict=True):
        assert index.shape == (1, 88)
        assert np.all(of.sense[index] == sense)
        travelled = np.mod(np.degrees(of.theta[index[0]]) - start, 360.0)
        assert travelled == pytest.approx((np.arange(88) + 0.5) * extent / 88.0, abs=1e-6)


def test_means_are_laid_on_a_grid_whose_transform_is_fast() -> None:
    """2² · 17 · 23 means: a transform is slow where its size has large factors (Cooley and Tukey,
    Mathematics of Computation 19, 1965). The next number below without one: 1540 = 2² · 5 · 7 · 11.
    """
    of = circle_samples(measured(Machine(), Setup(samples=1564)))
    assert angle_grid(of).size == 1564
    assert angle_grid(replace(of, averaged=2)).size == 1540


def test_pitches_that_the_samples_can_show() -> None:
    """360 samples on R = 150: 2.618 mm from sample to sample; 0.7 half turns of phase each."""
    of = samples()
    step = 2.0 * np.pi * R / 360.0
    assert shortest_pitch(of) == pytest.approx(2.0 * step / 0.7)
    assert longest_pitch(of) == pytest.approx(75.0)  # four periods over the diameter


@pytest.mark.parametrize(("amplitude", "found"), [(0.185, False), (0.212, True)])
@pytest.mark.parametrize("axis", ["first", "second"])
def test_a_cyclic_error_is_found_from_the_false_alarm_threshold_on(
    axis: str,
    amplitude: float,
    found: bool,
) -> None:
    """An amplitude a in noise of 1 µm lowers the weighted squares of n samples by a² n / 4 (cos² of
    the angle and of the phase: a half each). Noise exceeds 2 ln(4 m / 0.001) at one of m independent
    frequencies once in a thousand searches (m = R times their range; 4: phases between them), and at 8 times as
    many with the delays of 0 to 4 mm that are tried. With n = 2 * 1504: 29.6 = a² 752, a = 0.198 µm.
    """
    cause: dict[str, Any] = {f"cyclic_{axis}": amplitude, f"pitch_{axis}": 10.0}
    of = circle_samples(measured(Machine(**cause), Setup(samples=1504)))
    problem = circle_problem(of, angle_grid(of))
    # A changeover has one of its shapes "@", never all of them at once.
    always = np.array([i for i, name in enumerate(problem.names) if "@" not in name])
    searched = search_cyclic(
        problem,
        fit_causes(next(white_problems(problem)), always, problem.widths**-2.0),
        {},
    )
    assert searched.clear is found
    if found:
        assert searched.axis == axis
        assert 1.0 / searched.frequency == pytest.approx(10.0, abs=0.05)


def test_a_soft_loop_makes_the_circle_smaller_by_its_acceleration() -> None:
    """v² / (2 Kv² R) at 2 000 mm/min, Kv = 1000/60 per s, R = 150: 13.3 µm, uniform: over sqrt(3)."""
    assert shrink_uncertainty(samples()) == pytest.approx(13.333e-3 / np.sqrt(3.0), rel=1e-4)


# ---------------------------------------------------------------- axes


@pytest.mark.parametrize(
    ("targets", "period", "share"),
    [
        (np.arange(11) * 20.0, 10.0, 1.0),  # always the same phase
        (np.arange(11) * 20.0, 20.0, 1.0),
        (np.arange(12) * 5.0, 10.0, 1.0),  # the sine is zero at every target
        (np.arange(400) * 2.5, 10.0, 0.0),  # four per period: cosine and sine alike
        (np.arange(40) * 25.0 + 7.0 * np.arange(40) % 10, 10.0, 0.0),
    ],
)
def test_what_the_targets_hide_of_a_period(targets: Array, period: float, share: float) -> None:
    # offset and slope take a little: 1 / m of a wave
    assert hidden_share(targets, period) == pytest.approx(share, abs=0.02)


def test_the_density_of_the_matern_process() -> None:
    """Its integral over all frequencies / 2 pi is the variance, 1; at zero it is 16 l / (3 sqrt 5)."""
    w = np.linspace(-400.0, 400.0, 400_001)
    for length in (0.3, 1.0):
        logs, _ = log_density(w, float(np.log(length)))
        area = float(np.sum(np.exp(logs)) * (w[1] - w[0])) / (2.0 * np.pi)
        assert area == pytest.approx(1.0, abs=1e-4)
        assert np.exp(logs[200_000]) == pytest.approx(16.0 * length / (3.0 * np.sqrt(5.0)))


@pytest.mark.parametrize("log_excess", [-1.0, 0.0, 1.5])
def test_the_density_of_a_process_of_any_smoothness(log_excess: float) -> None:
    """Its integral over all frequencies / 2 pi is the variance, 1; its slopes are its differences."""
    w, log_length = np.linspace(-4000.0, 4000.0, 400_001), np.log(0.3)
    logs, by_length, by_excess = smooth_density(w, log_length, log_excess)
    area = float(np.sum(np.exp(logs)) * (w[1] - w[0])) / (2.0 * np.pi)
    assert area == pytest.approx(1.0, abs=1e-4)
    h = 1e-5
    for slope, more in ((by_length, (h, 0.0)), (by_excess, (0.0, h))):
        up = smooth_density(w, log_length + more[0], log_excess + more[1])[0]
        down = smooth_density(w, log_length - more[0], log_excess - more[1])[0]
        assert slope[::999] == pytest.approx((up - down)[::999] / (2 * h), rel=1e-4, abs=1e-4)


def test_the_density_between_a_kink_and_the_squared_exponential() -> None:
    """Excess 1 is Matérn 5/2; a large one exp(-r²/2l²), whose density is sqrt(2 pi) l exp(-w²l²/2)."""
    w = np.linspace(0.0, 10.0, 21)
    assert smooth_density(w, -0.5, 0.0)[0] == pytest.approx(log_density(w, -0.5)[0], abs=1e-12)
    length = np.exp(-0.5)
    normal = np.log(np.sqrt(2.0 * np.pi) * length) - 0.5 * (w * length) ** 2
    assert smooth_density(w, -0.5, np.log(1e7))[0] == pytest.approx(normal, abs=1e-4)


def test_the_density_of_students_law() -> None:
    """Five degrees of freedom: 0.3796067 at zero, 0.2196798 at one (tabulated); in two dimensions
    1 / (2 pi) at zero.
    """
    found = np.exp(_log_student(np.array([[0.0], [1.0]])))
    assert found == pytest.approx([0.3796067, 0.2196798], abs=1e-7)
    assert np.exp(_log_student(np.zeros((1, 2)))) == pytest.approx([0.5 / np.pi])


class Normal:
    """A posterior that is known: ``mass`` times a normal density about ``centre``; one of three
    numbers is fixed.
    """

    def __init__(self, mass: float) -> None:
        self.mass = mass
        self.centre = np.array([1.0, -2.0, 0.5])
        self.root = np.array([[0.5, 0.0], [0.3, 0.2]])
        self.precision = np.linalg.inv(self.root @ self.root.T)
        self.prior = SimpleNamespace(free=(True, False, True), width=np.full(3, 5.0))
        self.data = SimpleNamespace(draws=1)

    def log_posterior(self, h: Array, _draw: int = 0) -> float:
        off = (h - self.centre)[[0, 2]]
        log = -0.5 * off @ self.precision @ off - np.log(2.0 * np.pi)
        return float(np.log(self.mass) + log + 0.5 * np.linalg.slogdet(self.precision)[1])

    def with_gradient(self, h: Array) -> tuple[float, Array]:
        gradient = np.zeros(3)
        gradient[[0, 2]] = -self.precision @ (h - self.centre)[[0, 2]]
        return self.log_posterior(h), gradient


@pytest.mark.parametrize("mass", [1.0, 1e-30])
def test_evidence_is_the_mass_of_the_posterior_and_draws_follow_it(mass: float) -> None:
    known: Any = Normal(mass)
    drawn = draw_hyperparameters(
        known,
        [np.array([[0.0, -2.0, 0.0]])],
        proposals=4000,
        draws=2000,
        rng=np.random.default_rng(1),
    )
    # 4000 points whose weights scatter by about a half: 0.01; four of these
    assert drawn.log_evidence == pytest.approx(np.log(mass), abs=0.04)
    assert np.all(drawn.values[:, 1] == -2.0)
    # mean and covariance of 2000 draws: 1 / sqrt(2000) = 0.022 of each spread, about four times
    assert np.mean(drawn.values, axis=0) == pytest.approx(known.centre, abs=0.05)
    spread = np.cov(drawn.values[:, [0, 2]].T)
    assert spread == pytest.approx(known.root @ known.root.T, abs=0.03)


class Peaks(Normal):
    """A mixture of normal densities that is known: (mass, centre of the first number), the others
    as `Normal` has them.
    """

    def __init__(self, *peaks: tuple[float, float]) -> None:
        super().__init__(1.0)
        self.parts = [Normal(mass) for mass, _ in peaks]
        for part, (_, place) in zip(self.parts, peaks, strict=True):
            part.centre = np.array([place, -2.0, 0.5])

    def log_posterior(self, h: Array, _draw: int = 0) -> float:
        return float(np.logaddexp.reduce([part.log_posterior(h) for part in self.parts]))

    def with_gradient(self, h: Array) -> tuple[float, Array]:
        level = self.log_posterior(h)
        slopes = [np.exp(p.log_posterior(h) - level) * p.with_gradient(h)[1] for p in self.parts]
        return level, np.asarray(np.sum(slopes, axis=0))


def test_every_peak_of_the_posterior_is_drawn_from_as_far_as_its_mass_goes() -> None:
    known: Any = Peaks((0.7, 1.0), (0.3, 9.0))
    starts = [np.array([[place, -2.0, 0.0]]) for place in (0.0, 8.0, 1.5)]
    drawn = draw_hyperparameters(
        known, starts, proposals=4000, draws=2000, rng=np.random.default_rng(1)
    )
    # As for one peak: 6000 points, 0.01; a share of 0.3 among 2000 draws: 0.01; four of these
    assert drawn.log_evidence == pytest.approx(0.0, abs=0.04)
    assert np.mean(drawn.values[:, 0] > 5.0) == pytest.approx(0.3, abs=0.04)


def test_peaks_are_told_apart_and_those_without_mass_left_out() -> None:
    known: Any = Peaks((0.7, 1.0), (0.3, 9.0), (1e-9, -9.0))
    starts = [np.array([[x, -2.0, 0.0] for x in some]) for some in ((0.0,), (1.5,), (-8.0, 8.0))]
    # Of a kind the best start alone is climbed from: 8, not -8.
    assert [peak.place[0] for peak in find_peaks(known, starts)] == pytest.approx([1.0, 9.0])
    assert [
        peak.place[0] for peak in find_peaks(known, [*starts, np.array([[-8.0, -2.0, 0.0]])])
    ] == pytest.approx([1.0, 9.0])


@pytest.mark.parametrize("size", [1, 2, 48, 49, 97, 150])
def test_the_inverse_of_a_triangle_undoes_it(size: int) -> None:
    rng = np.random.default_rng(size)
    rows = rng.standard_normal((size, 2 * size)) * np.exp(rng.standard_normal((size, 1)))
    matrix, factor = cholesky_factor(rows @ rows.T)
    inverse = inverse_triangle(factor)
    np.testing.assert_allclose(inverse @ factor, np.eye(size), atol=1e-10)
    np.testing.assert_allclose(np.triu(inverse, 1), 0.0, atol=1e-12)
    np.testing.assert_allclose(inverse @ matrix @ inverse.T, np.eye(size), atol=1e-9)


def test_a_matrix_that_rounding_left_indefinite_gets_a_factor() -> None:
    ones = np.ones((60, 60))
    matrix, factor = cholesky_factor(ones - 1e-13 * np.eye(60))
    np.testing.assert_allclose(factor @ factor.T, matrix, atol=1e-12)
    np.testing.assert_allclose(matrix, ones, atol=1e-9)


@pytest.mark.parametrize("size", [1, 7, 82])
def test_values_beside_a_matrix_are_solved_with_its_factor(size: int) -> None:
    rng = np.random.default_rng(size)
    noise = np.exp(rng.standard_normal(size))
    rows = rng.standard_normal((size, 2 * size))
    matrix, values = rows @ rows.T + np.diag(noise), 1e3 * rng.standard_normal(size)
    factor, solved = factor_and_solve(matrix, values, float(np.sum(values**2 / noise)))
    np.testing.assert_allclose(factor @ factor.T, matrix, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(factor @ solved, values, rtol=1e-9, atol=1e-9)
    # whatever the border, the density is that of the matrix alone
    assert solved @ solved == pytest.approx(values @ np.linalg.solve(matrix, values), rel=1e-9)


def test_values_beside_a_matrix_without_a_factor_get_that_of_the_nearest() -> None:
    ones, values = np.ones((60, 60)), np.ones(60)
    factor, solved = factor_and_solve(ones - 1e-13 * np.eye(60), values, 10.0)
    np.testing.assert_allclose(factor @ factor.T, ones, atol=1e-9)
    np.testing.assert_allclose(factor @ solved, values, atol=1e-6)
