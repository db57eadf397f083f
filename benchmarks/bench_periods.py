"""How small a wave can how few targets show? Axes whose pitch nobody tells, by kind of the curve.

    python benchmarks/bench_periods.py [N]

The search alone, on middles of five readings a direction (0.25 to 0.6 µm): how often it names the
right period (above 0.5; within 2 % or 0.3 P²/L) and a wrong one; and on curves without a wave, how
often it names any. Beside it two judges who expect the same periods as the search before the data:
one knows the size of the noise, the other also the shapes of which the curve is made, with the
sizes from which their weights are drawn. Prints and judges nothing.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
from error_curves import Curve, constant, sines, smooth, total
from machines import dithered, name_seed, untold
from numpy.random import Generator
from numpy.typing import NDArray

from compwright.estimation.basis import Basis
from compwright.estimation.period_likelihood import BidirectionalMeans
from compwright.estimation.periods import FIRST, LEAST_REPEATS, SHORTEST, search_periods
from compwright.estimation.usual_periods import usual_periods
from compwright.records.axis import AxisKind

Floats = NDArray[np.float64]
Shape = Callable[[Generator, float], Curve]
LEADS = (4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0)
SURE = 1e6  # degrees of freedom of who knows the noise


def four_waves(rng: Generator, length: float) -> Curve:
    """The curve of ``machine_kinds.py``: a slope and four waves."""
    return smooth(rng, 0, length, rng.uniform(4, 20))


def bow(rng: Generator, length: float) -> Curve:
    """A slope, a bow, and half a wave to one and a half."""
    turns, sizes = rng.uniform(0.5, 1.5), rng.uniform(2, 10) * np.array([1, 1, 0.3, 0.3])

    def shapes(x: Floats) -> Floats:
        u = x / length - 0.5
        angle = 2 * np.pi * turns * u
        return np.stack([u, 4 * u**2, np.sin(angle), np.cos(angle)])

    return Curve(shapes, sizes * rng.standard_normal(4), sizes)


def polyline(rng: Generator, length: float) -> Curve:
    """What an old table of 40 mm leaves: straight from node to node, each off by up to 2 µm."""
    nodes = np.arange(0, length + 40, 40)
    sizes = np.full(nodes.size, rng.uniform(0.3, 2))
    hats = np.eye(nodes.size)
    corners = Curve(
        lambda x: np.stack([np.interp(x, nodes, hat) for hat in hats]),
        sizes * rng.standard_normal(nodes.size),
        sizes,
    )
    return total(four_waves(rng, length), corners)


def walk(rng: Generator, length: float) -> Curve:
    """A random walk of 1 to 6 µm over the travel."""
    ends = np.linspace(0, length, 201)[:-1]
    sizes = np.full(200, rng.uniform(1, 6) / np.sqrt(200))
    steps = Curve(
        lambda x: np.clip((x - ends[:, None]) * 200 / length, 0, 1),
        sizes * rng.standard_normal(200),
        sizes,
    )
    return total(four_waves(rng, length), steps)


def basis_over(length: float, count: int) -> Basis:
    """Return the functions of the search over a travel from 0."""
    half = length / 2
    sines_ = int(np.clip(2 * count, 24, 112))
    return Basis(half, half, sines_, 0, (), bidirectional=True)


def named(x: Floats, y: Floats, sigma: float, dof: float, length: float) -> list[float]:
    """Return the periods that the search names; values in µm."""
    straight = np.column_stack([np.ones_like(x), x / length])
    variances = np.full(x.size, (1e-3 * sigma) ** 2 / 10)
    middles = BidirectionalMeans(x, 1e-3 * y, variances, dof, 1e-3 * sigma, straight)
    found = search_periods(middles, basis_over(length, x.size), AxisKind.LINEAR).found
    return [each.period for each in found if each.probability > 0.5]


def informed(x: Floats, y: Floats, sigma: float, curve: Curve, length: float) -> list[float]:
    """Return what a judge names who knows noise and shapes: normal likelihoods, dense."""
    covariance = sigma**2 / 10 * np.eye(x.size) + 400.0
    shapes = curve.shapes(x)
    covariance = covariance + (shapes.T * curve.sizes**2) @ shapes
    periods, prior = expected(x)
    angle = 2 * np.pi * x / periods[:, None]
    size = 1.5 / np.sqrt(2)  # of the weights of ``sines``
    waves = [size * np.cos(angle), size * np.sin(angle)]
    waves += [0.25 * size * np.cos(2 * angle), 0.25 * size * np.sin(2 * angle)]
    white = np.linalg.inv(np.linalg.cholesky(covariance))
    columns, values = np.stack(waves, axis=2).transpose(0, 2, 1) @ white.T, white @ y
    gram = columns @ columns.transpose(0, 2, 1) + np.eye(4)
    moment = columns @ values
    solved = np.linalg.solve(gram, moment[..., None])[..., 0]
    logs = 0.5 * np.sum(moment * solved, axis=1) - 0.5 * np.linalg.slogdet(gram)[1] + np.log(prior)
    top = max(float(logs.max()), np.log(FIRST.none))
    odds = np.exp(logs - top)
    odds /= odds.sum() + FIRST.none * np.exp(-top)
    best = float(periods[np.argmax(odds)])
    return [best] if odds[near(periods, best, length)].sum() > 0.5 else []


def expected(x: Floats) -> tuple[Floats, Floats]:
    """Return periods with their probabilities before the data, as the search has them."""
    low, high = LEAST_REPEATS / np.ptp(x), 1 / SHORTEST[AxisKind.LINEAR]
    usual = [u for u in usual_periods(AxisKind.LINEAR) if low <= 1 / u.size <= high + 1e-9]
    weights = np.array([u.weight for u in usual])
    others = np.arange(low, high, 1 / (4 * np.ptp(x)))
    even = 1 / others / np.sum(1 / others) * (1 - FIRST.none - FIRST.usual)
    periods = np.concatenate([[u.size for u in usual], 1 / others])
    return periods, np.concatenate([FIRST.usual * weights / weights.sum(), even])


def near(period: Floats, true: float, length: float) -> NDArray[np.bool_]:
    """Return whether a period counts as the true one."""
    return np.asarray(np.abs(period - true) <= max(0.02 * true, 0.3 * true**2 / length))


def trial(shape: Shape, size: float, count: int, pitch: float, seed: Generator) -> list[list[int]]:
    """Return right and wrong names of the search, of who knows the noise, and the shapes."""
    length = float(np.clip(np.round(pitch * seed.uniform(30, 100), -1), 200, 1200))
    curve = shape(seed, length)
    wave = sines((pitch,), (size,), seed) if size else constant(0.0)
    x, sigma, dof = dithered(seed, 0, length, count), seed.uniform(0.25, 0.6), 8.0 * count
    y = curve(x) + wave(x) + sigma / np.sqrt(10) * seed.standard_normal(count)
    guess = float(sigma * np.sqrt(seed.chisquare(dof) / dof))
    answers = [named(x, y, guess, dof, length), named(x, y, sigma, SURE, length)]
    answers.append(informed(x, y, sigma, curve, length))
    right = [[size > 0 and bool(near(np.array(p), pitch, length)) for p in a] for a in answers]
    return [[any(one), not all(one)] for one in right]


def main() -> None:
    """Try, then print."""
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    print("| curve | wave, targets | search: right, wrong | noise known | shapes known |")
    print("|---|---|---|---|---|")
    for shape in (four_waves, bow, polyline, walk):
        for size, count in ((1.0, 12), (1.5, 14), (2.0, 16), (0.0, 12), (0.0, 20)):
            for leads in ("usual leads", "catalogue and others") if size else ("none",):
                seeds = [name_seed(f"{shape.__name__} {size:g} {count}", k) for k in range(number)]
                usual = leads != "catalogue and others"
                pitches = [float(rng.choice(LEADS)) if usual else untold(rng) for rng in seeds]
                tried = [
                    trial(shape, size, count, pitch, rng)
                    for pitch, rng in zip(pitches, seeds, strict=True)
                ]
                rates = 100 * np.mean(np.array(tried, dtype=float), axis=0)
                cells = " | ".join(f"{right:.0f}, {wrong:.0f} %" for right, wrong in rates)
                what = f"{size:g} µm, {count}, {leads}" if size else f"none, {count}"
                print(f"| {shape.__name__.replace('_', ' ')} | {what} | {cells} |", flush=True)


if __name__ == "__main__":
    main()
