"""The search for periods that nobody named: its likelihood against a dense normal one, and periods
put into axes and found again, or not where the targets cannot show them.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from compwright.estimation.basis import Basis
from compwright.estimation.cells import build_cells
from compwright.estimation.evidence import EXCESS
from compwright.estimation.model import Periods, Travel, model_evidence
from compwright.estimation.observed_test import ObservedTest
from compwright.estimation.period_likelihood import (
    AMPLITUDES,
    SMOOTHNESS,
    BidirectionalMeans,
    NodeChoice,
    PeriodLikelihood,
)
from compwright.estimation.period_means import (
    FITTED,
    bidirectional_means,
    fitted_periods,
    unseen_periods,
)
from compwright.estimation.period_models import PeriodSearch
from compwright.estimation.periods import search_frequencies, search_periods
from compwright.estimation.spectral_window import SpectralWindow, wave_similarity
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.positioning import PositioningTest

Curve = Callable[[FloatArray], FloatArray]


def dithered(rng: np.random.Generator, length: float, count: int) -> FloatArray:
    """Targets as ISO 230-2:2014, 4.2 has them: equal intervals and a random part."""
    steps = np.arange(count) + 0.5 + rng.uniform(-0.3, 0.3, count)
    return np.round(steps * length / count, 3)


def made(
    targets: FloatArray, error: Curve, rng: np.random.Generator, noise: float = 0.0005
) -> BidirectionalMeans:
    """Five readings per direction with ``noise`` (mm); their means' middle."""
    variance = noise**2 / 10.0
    return BidirectionalMeans(
        targets=targets,
        values=error(targets) + rng.standard_normal(targets.size) * np.sqrt(variance),
        variances=np.full(targets.size, variance),
        dof=8.0 * targets.size,
        reading=noise,
        free=np.column_stack([np.ones(targets.size), targets]),
    )


def smooth_basis(length: float, sines: int = 60, turn: float | None = None) -> Basis:
    return Basis(
        centre=length / 2,
        half=length / 2,
        sines=sines,
        reversal_sines=12,
        periods=(),
        bidirectional=False,
        turn=turn,
    )


def test_the_least_amplitude_is_that_of_least_squares() -> None:
    """Waves at 40 scattered targets: (3 + 1.645) sigma sqrt(2 / m), sigma of a middle, where the
    error is a straight line. Every 50 mm a wave of 10 mm is a constant.
    """
    rng = np.random.default_rng(4)
    targets = dithered(rng, 800.0, 40)
    middles = made(targets, np.zeros_like, rng)
    least = PeriodLikelihood(middles, smooth_basis(800.0)).detectable(1.0 / np.array([10.0, 16.0]))
    known = 4.645 * 0.0005 / np.sqrt(10.0) * np.sqrt(2.0 / 40.0)
    assert np.all((least > 0.9 * known) & (least < 1.7 * known))
    every = made(np.arange(0.0, 801.0, 50.0), np.zeros_like, rng)
    hidden = PeriodLikelihood(every, smooth_basis(800.0)).detectable(1.0 / np.array([10.0, 9.7]))
    assert np.isinf(hidden[0])
    assert np.isfinite(hidden[1])


def bow(x: FloatArray) -> FloatArray:
    """8 µm of smooth error over some 800 mm, and a slope."""
    return np.asarray(0.004 * np.sin(x / 210.0) + 1e-5 * x)


def searched(error: Curve, count: int, seed: int, length: float = 800.0) -> PeriodSearch:
    rng = np.random.default_rng(seed)
    targets = dithered(rng, length, count)
    return search_periods(made(targets, error, rng), smooth_basis(length), AxisKind.LINEAR)


def named(search: PeriodSearch) -> list[float]:
    return [each.period for each in search.found if each.probability > 0.5]


@pytest.mark.parametrize("harmonics", [(1,), (1, 2)])
@pytest.mark.parametrize("smoothness", [1.5, 2.5, np.inf])
def test_likelihood_is_that_of_a_normal_vector(
    harmonics: tuple[int, ...], smoothness: float
) -> None:
    """Rasmussen and Williams 2006, eq. 2.30 with eq. 4.9 and 4.17, dense, free columns projected
    out; the sines stand for the covariance to about 1 % of it, which moves the logarithm by less
    than 0.1."""
    rng = np.random.default_rng(3)
    length, frequency = 400.0, 1.0 / 23.0
    targets = dithered(rng, length, 11)
    middles = made(targets, lambda x: bow(x) + 0.001 * np.sin(x), rng)
    middles.variances[3] *= 2.0
    likelihood = PeriodLikelihood(middles, smooth_basis(length, sines=112))
    number = next(
        i
        for i, each in enumerate(likelihood.nodes)
        if each.smoothness == smoothness and each.length > 0.25
    )
    node, index, step = likelihood.nodes[number], likelihood.nodes[number].log.size // 2, 5
    choice = NodeChoice(((number, np.array([index])),), np.array([step]))
    found = likelihood.log_odds(np.array([frequency]), choice)[len(harmonics) - 1][0]

    unit = float(np.sqrt(np.median(middles.variances)))
    apart = np.abs(targets[:, None] - targets) / (length / 2) / node.length
    three, five = np.sqrt(3.0) * apart, np.sqrt(5.0) * apart
    kernel = {
        1.5: (1.0 + three) * np.exp(-three),
        2.5: (1.0 + five + five**2 / 3.0) * np.exp(-five),
        np.inf: np.exp(-(apart**2) / 2.0),
    }[smoothness]
    covariance = node.smooth[index] ** 2 * kernel
    covariance += np.diag(middles.variances / unit**2) / node.white[index]
    centre, width = likelihood.amplitude
    size = np.exp(centre + width * AMPLITUDES[step])
    wave = np.zeros_like(covariance)
    for harmonic in harmonics:
        angle = 2.0 * np.pi * harmonic * frequency * (targets[:, None] - targets)
        wave += (size / harmonic) ** 2 * np.cos(angle)
    free = middles.free / [1.0, length]
    beside = np.linalg.svd(free.T)[2][2:]

    def log_normal(total: FloatArray) -> float:
        matrix = beside @ total @ beside.T
        values = beside @ middles.values / unit
        return float(
            -0.5 * values @ np.linalg.solve(matrix, values) - 0.5 * np.linalg.slogdet(matrix)[1]
        )

    assert found == pytest.approx(log_normal(covariance + wave) - log_normal(covariance), abs=0.1)


def test_kinks_are_expected_as_seldom_as_in_the_estimate() -> None:
    """Shares of a normal logarithm of the excess over 3/2 (Abramowitz and Stegun 1964, eq. 26.2.29)
    below 2, from 2 to 3.5, and above, by the prior of the estimate itself."""
    rng = np.random.default_rng(14)
    cells = build_cells([ObservedTest(test=measured(dithered(rng, 500.0, 12), bow, rng))])
    prior = model_evidence(cells, Travel(0.0, 500.0), Periods(), varying=False).prior

    def below(smoothness: float) -> float:
        away = (math.log(smoothness - 1.5) - prior.centre[EXCESS]) / prior.width[EXCESS]
        return 0.5 * (1.0 + math.erf(away / math.sqrt(2.0)))

    expected = [below(2.0), below(3.5) - below(2.0), 1.0 - below(3.5)]
    assert [share for _, share in SMOOTHNESS] == pytest.approx(expected, abs=0.01)


def kinked(x: FloatArray) -> FloatArray:
    """A polyline: slopes of some 10 µm/m that change every 97 mm."""
    places = np.arange(9) * 97.0
    return np.asarray(np.interp(x, places, 1e-3 * np.array([0, 4, 3, 6, 2, 3, 0, 1, -2.0])))


@pytest.mark.parametrize("seed", [20, 21, 22])
def test_a_wave_of_a_micrometre_is_seen_beside_a_soft_curve(seed: int) -> None:
    """1 µm at 10 mm with 13 targets beside 24 µm of bow; nothing in a polyline."""
    search = searched(
        lambda x: (
            0.012 * np.sin(x / 300.0 + seed)
            + 1e-5 * x
            + 0.001 * np.sin(2 * np.pi * x / 10.0 + seed)
        ),
        13,
        seed,
    )
    assert named(search) == [pytest.approx(10.0, abs=0.3 * 10.0**2 / 800.0)]
    assert named(searched(kinked, 13, seed)) == []


def test_a_period_of_no_catalogue_is_named() -> None:
    """2 µm at 11.37 mm over 24 targets: named within 0.3 P²/L; nothing else is."""
    search = searched(lambda x: bow(x) + 0.002 * np.sin(2 * np.pi * x / 11.37 + 1.0), 24, 1)
    assert named(search) == [pytest.approx(11.37, abs=0.3 * 11.37**2 / 800)]
    assert search.models[0].periods != ()
    assert sum(model.probability for model in search.models) == pytest.approx(1.0)


@pytest.mark.parametrize("seed", [3, 11])
def test_a_period_halfway_between_two_steps_of_the_search_is_named(seed: int) -> None:
    """2 µm and 0.8 µm twice as often, of no catalogue: the peak of both is narrower than a step."""
    rng = np.random.default_rng(seed)
    targets = dithered(rng, 1200.0, 16)
    steps = search_frequencies(targets, AxisKind.LINEAR)
    near = int(np.argmin(np.abs(steps - 1.0 / 26.3)))
    frequency = float(np.mean(steps[near : near + 2]))
    phases = rng.uniform(0.0, 2.0 * np.pi, 2)

    def error(x: FloatArray) -> FloatArray:
        angle = 2.0 * np.pi * frequency * x
        wave = 0.002 * np.sin(angle + phases[0]) + 0.0008 * np.sin(2.0 * angle + phases[1])
        return np.asarray(bow(x) + wave)

    search = search_periods(made(targets, error, rng), smooth_basis(1200.0), AxisKind.LINEAR)
    assert named(search) == pytest.approx([1.0 / frequency], rel=0.003)


def test_a_usual_lead_is_named_as_it_is() -> None:
    search = searched(lambda x: bow(x) + 0.0015 * np.sin(2 * np.pi * x / 10.0), 20, 2)
    assert named(search) == [10.0]


@pytest.mark.parametrize(("length", "seed"), [(200.0, 5), (310.0, 6)])
def test_the_shortest_lead_is_searched_and_not_taken_for_twice_of_it(
    length: float, seed: int
) -> None:
    """A lead of 2 mm, below which nothing is searched, seldom lies on a step of the search."""
    search = searched(
        lambda x: 0.5 * bow(x) + 0.002 * np.sin(np.pi * x + 0.3), 16, seed, length=length
    )
    assert named(search) == [2.0]


def test_two_periods_are_found_one_after_another() -> None:
    search = searched(
        lambda x: (
            bow(x)
            + 0.0025 * np.sin(2 * np.pi * x / 12.0)
            + 0.0015 * np.cos(2 * np.pi * x / 20.0 + 0.5)
        ),
        36,
        3,
    )
    assert sorted(named(search)) == pytest.approx([12.0, 20.0], abs=0.1)


@pytest.mark.parametrize(("count", "seed"), [(22, 2), (26, 2)])
def test_two_waves_of_one_size_are_found_together(count: int, seed: int) -> None:
    """Beside either of them alone the other is scatter, as large: none of the two is likely, both
    together are."""

    def error(x: FloatArray) -> FloatArray:
        first, second = np.sin(2 * np.pi * x / 15.0 + seed), np.cos(2 * np.pi * x / 24.0 + 2 * seed)
        return np.asarray(bow(x) + 0.002 * first + 0.002 * second)

    search = searched(error, count, seed)
    assert sorted(named(search)) == pytest.approx([15.0, 24.0], rel=1e-3)
    assert sum(model.probability for model in search.models) == pytest.approx(1.0)


def test_a_period_is_measured_beside_those_found_later() -> None:
    """Found first, with the second wave in the way, 24 mm looks like 23.96 mm."""
    search = searched(
        lambda x: (
            bow(x) + 0.002 * np.sin(2 * np.pi * x / 15.0) + 0.002 * np.cos(2 * np.pi * x / 24.0)
        ),
        22,
        0,
    )
    assert sorted(named(search)) == [15.0, 24.0]


def test_a_quick_look_does_not_overrule_a_close_one() -> None:
    """A lead of 20 mm under scatter, which a wave of 2 mm leaves at targets 55 mm apart: few nodes
    of the likelihood make ten times too much of all waves, 40 mm among them."""

    def error(x: FloatArray) -> FloatArray:
        waves = 0.002 * np.sin(2 * np.pi * x / 20.0 + 8) + 0.0015 * np.sin(np.pi * x + 16)
        return np.asarray(0.008 * np.sin(x / 120.0) + 0.004 * np.cos(x / 70.0) + waves)

    rng = np.random.default_rng(8)
    targets = dithered(rng, 1200.0, 22)
    middles = made(targets, error, rng, noise=0.0003)
    search = search_periods(middles, smooth_basis(1200.0), AxisKind.LINEAR)
    assert sorted(named(search)) == [2.0, 20.0]
    assert search.models[0].probability > 0.95  # 1.5 and 2 µm at 22 targets, noise of 0.3 µm


def test_of_two_periods_neither_is_taken_for_exactly_known() -> None:
    search = searched(
        lambda x: (
            bow(x) + 0.004 * np.sin(2 * np.pi * x / 13.7) + 0.002 * np.cos(2 * np.pi * x / 21.9)
        ),
        26,
        4,
    )
    both = [sorted(model.periods) for model in search.models if len(model.periods) == 2]
    for place, true in enumerate((13.7, 21.9)):
        different = [periods[place] for periods in both]
        assert len(set(different)) >= 3
        assert different == pytest.approx([true] * len(both), rel=5e-3)


def test_a_known_period_is_not_found_again_and_another_beside_it_is() -> None:
    rng = np.random.default_rng(4)
    targets = dithered(rng, 800.0, 30)
    middles = made(
        targets,
        lambda x: (
            bow(x) + 0.003 * np.sin(2 * np.pi * x / 10.0) + 0.002 * np.sin(2 * np.pi * x / 16.0)
        ),
        rng,
    )
    search = search_periods(middles, smooth_basis(800.0), AxisKind.LINEAR, known=(10.0,))
    assert named(search) == [16.0]


@pytest.mark.parametrize(
    ("waves", "known", "unseen"),
    [
        (((0.0015, 12.0),), 10.0, (10.0,)),  # told 10 mm, and the screw has 12
        (((0.0015, 12.0), (0.001, 10.0)), 10.0, ()),  # a gear beside the screw
        (((0.0015, 20.0), (0.001, 10.0)), 10.0, ()),  # two waves in a lead of 20 mm
        (((0.001, 10.0),), 10.0, ()),
        ((), 10.0, ()),  # a good screw
    ],
)
def test_a_told_period_of_which_another_takes_the_place_is_doubted(
    waves: tuple[tuple[float, float], ...], known: float, unseen: tuple[float, ...]
) -> None:
    rng = np.random.default_rng(4)
    targets = dithered(rng, 800.0, 24)

    def error(x: FloatArray) -> FloatArray:
        parts = [size * np.sin(2.0 * np.pi * x / period + 0.7) for size, period in waves]
        return np.asarray(bow(x) + sum(parts))

    middles, basis = made(targets, error, rng), smooth_basis(800.0)
    search = search_periods(middles, basis, AxisKind.LINEAR, known=(known,))
    assert unseen_periods(middles, basis, (known,), named(search)) == unseen


def test_a_worm_of_a_rotary_axis_is_named() -> None:
    """Worm wheel of 72 teeth, 5 deg a turn, 2 arcsec; the smooth error repeats with the turn."""
    rng = np.random.default_rng(5)
    targets = dithered(rng, 360.0, 24)
    arcsec = 1.0 / 3600.0
    middles = made(
        targets,
        lambda x: arcsec * (4 * np.sin(np.radians(x)) + 2 * np.sin(2 * np.pi * x / 5.0 + 0.4)),
        rng,
        noise=0.5 * arcsec,
    )
    middles = BidirectionalMeans(
        middles.targets,
        middles.values,
        middles.variances,
        middles.dof,
        middles.reading,
        np.ones((24, 1)),
    )
    search = search_periods(middles, smooth_basis(360.0, turn=360.0), AxisKind.ROTARY)
    assert named(search) == [5.0]


def kink(x: FloatArray) -> FloatArray:
    return np.asarray(2e-5 * np.abs(x - 300.0))


def worn(x: FloatArray) -> FloatArray:
    return np.asarray(bow(x) - 0.006 * np.exp(-0.5 * ((x - 500.0) / 40.0) ** 2))


def scattered(x: FloatArray) -> FloatArray:
    return np.asarray(bow(x) + 0.0015 * np.random.default_rng(int(x.size)).standard_normal(x.size))


@pytest.mark.parametrize("error", [bow, kink, worn, scattered])
@pytest.mark.parametrize("count", [12, 21])
def test_no_period_is_named_where_there_is_none(error: Curve, count: int) -> None:
    assert named(searched(error, count, 8)) == []


def test_at_equal_spacing_periods_that_look_alike_are_not_told_apart() -> None:
    """Targets 30 mm apart: 11.3 mm looks as 18.1, 8.2, ... mm do (frequencies k / 30 -+ 1 / 11.3);
    all of them are named together, none above one half."""
    rng = np.random.default_rng(7)
    targets: FloatArray = 30.0 * np.arange(27, dtype=np.float64) + 5.0
    search = search_periods(
        made(targets, lambda x: bow(x) + 0.003 * np.sin(2 * np.pi * x / 11.3), rng),
        smooth_basis(800.0),
        AxisKind.LINEAR,
    )
    assert named(search) == []
    (group,) = search.sure
    for k in (0, 1, 2, 3):
        alias = 1.0 / abs(k / 30.0 + 1.0 / 11.3)
        assert min(abs(each - alias) for each in group) < 0.02 * alias
    spread = {round(model.periods[0], 2) for model in search.models if model.periods}
    assert len(spread) >= 5, "the models must differ, so that other targets are told widely"


def test_a_period_that_the_spacing_hides_is_not_claimed() -> None:
    rng = np.random.default_rng(8)
    targets: FloatArray = 30.0 * np.arange(27, dtype=np.float64)
    search = search_periods(
        made(targets, lambda x: bow(x) + 0.003 * np.sin(2 * np.pi * x / 10.0 + 1), rng),
        smooth_basis(800.0),
        AxisKind.LINEAR,
    )
    assert named(search) == []


def test_few_targets_are_not_searched() -> None:
    search = searched(lambda x: bow(x) + 0.003 * np.sin(2 * np.pi * x / 10.0), 6, 9)
    assert search.found == ()
    assert [model.periods for model in search.models] == [()]


def test_alikeness_is_one_for_the_same_values_and_small_for_others() -> None:
    targets: FloatArray = 30.0 * np.arange(20, dtype=np.float64)
    others = np.array([1 / 30 + 0.02, 1 / 30 - 0.02, 0.03])
    for alike in (
        wave_similarity(targets, others, 0.02),
        SpectralWindow(targets, 0.2).alike(others, 0.02),
    ):
        assert alike[:2] == pytest.approx([1.0, 1.0], abs=0.01)
        assert alike[2] < 0.5


def test_waves_that_look_too_long_are_smooth_error() -> None:
    """Targets 30 mm apart: 28.6 mm looks like 612 mm, which is smooth; 11.3 mm like 86.8 mm."""
    window = SpectralWindow(30.0 * np.arange(26, dtype=np.float64), 0.5)
    assert window.slow(np.array([1 / 28.6, 1 / 15.0, 1 / 11.3]), 8 / 750).tolist() == [
        True,
        True,
        False,
    ]
    rng = np.random.default_rng(13)
    targets: FloatArray = 30.0 * np.arange(26, dtype=np.float64)
    sine = made(targets, lambda x: 0.006 * np.sin(2 * np.pi * x / 300.0 + 0.4), rng)
    search = search_periods(sine, smooth_basis(800.0), AxisKind.LINEAR)
    assert search.sure == ()
    assert named(search) == []


def measured(
    targets: FloatArray, error: Curve, rng: np.random.Generator, runs: int = 5
) -> PositioningTest:
    """A test of both directions, 0.5 µm of noise, 3 µm of lost motion."""
    shape = (targets.size, runs)
    blocks = [
        (error(targets) + half)[:, np.newaxis] + 0.0005 * rng.standard_normal(shape)
        for half in (-0.0015, 0.0015)
    ]
    return PositioningTest(
        name="t",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=targets,
        positive=blocks[0],
        negative=blocks[1],
        frame="machine",
    )


def test_middles_are_means_of_both_directions_and_keep_single_ones_apart() -> None:
    rng = np.random.default_rng(10)
    test = measured(dithered(rng, 500.0, 12), bow, rng)
    test.negative[4] = np.nan
    cells = build_cells([ObservedTest(test=test)])
    middles = bidirectional_means(cells, endless=False)
    both = np.arange(12) != 4
    mean = 0.5 * (np.mean(test.positive[both], axis=1) + np.mean(test.negative[both], axis=1))
    assert np.diff(middles.values[both], 2) == pytest.approx(
        np.diff(mean - cells.slope * test.targets[both], 2), abs=1e-12
    )
    # One direction of five readings against two of five: twice the variance.
    assert middles.variances[4] == pytest.approx(2.0 * middles.variances[0])
    assert middles.free.shape == (12, 3), "offset, slope, and the reversal where one is missing"


def test_of_a_hundred_known_periods_those_that_are_there_are_fitted() -> None:
    rng = np.random.default_rng(11)
    test = measured(
        dithered(rng, 800.0, 41),
        lambda x: (
            bow(x)
            + 0.002 * np.sin(2 * np.pi * x / 10.0)
            + 0.003 * np.sin(2 * np.pi * x / 17.0 + 1.0)
        ),
        rng,
    )
    middles = bidirectional_means(build_cells([ObservedTest(test=test)]), endless=False)
    many = tuple(3.0 + 0.5 * k for k in range(100))
    chosen = fitted_periods(middles, smooth_basis(800.0), many)
    assert {10.0, 17.0} <= set(chosen)
    assert len(chosen) <= FITTED
    assert fitted_periods(middles, smooth_basis(800.0), many[:3]) == many[:3]


def test_what_the_files_suggest_is_believed_sooner_and_named_as_theirs() -> None:
    """At 14 targets and 0.7 µm nothing is sure; a lead that the files suggest gains."""
    rng = np.random.default_rng(12)
    targets = dithered(rng, 800.0, 14)
    middles = made(targets, lambda x: bow(x) + 0.0007 * np.sin(2 * np.pi * x / 14.0 + 2.0), rng)
    plain, told = (
        search_periods(middles, smooth_basis(800.0), AxisKind.LINEAR, suggested=suggested)
        for suggested in ((), (14.0,))
    )
    before = next((each.probability for each in plain.found if abs(each.period - 14) < 0.1), 0.0)
    after = next(each for each in told.found if each.period == 14.0)
    assert after.source == "files"
    assert after.probability > before + 0.1
