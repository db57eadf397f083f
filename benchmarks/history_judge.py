"""What growth can be asked of ``history``? The best judge who has to find the step himself.

    python benchmarks/history_judge.py [N] [--seed S]

The machines are those of `bench_history`, as series of mean B and slope with their true noise. The
judge knows how these machines are made: how often each event comes, that a repair sets back 90 % of
what has grown, and how large rates, crashes and seasons are. He does not know whether and where a
step is: he averages over all events and places. One judge knows the noise, the other has to
estimate it: his variances are 1/16 to 16 times the true ones, each factor as likely as another. The
likelihood ratio of growth and no growth is the most powerful test (Neyman, Pearson, Phil. Trans. A
231 (1933) 289). Its threshold is exceeded by 1 % of the stable machines, for each parameter.

Prints the share of growth that is found with the right sign, by its size over the standard error of
one who knows the steps (as in `bench_history`), with its binomial standard error.
"""

from __future__ import annotations

import argparse
import math
from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from bench_history import RUNS, Floats, Machine, machine
from scipy.special import log_ndtr, logsumexp

PARAMETERS = {"B_mean": "reversal", "slope": "slope"}
_STEPS = 24
RATES = {
    "B_mean": -np.exp(np.linspace(math.log(0.05), math.log(1.5), _STEPS)),
    "slope": np.exp(np.linspace(math.log(1.0), math.log(20.0), _STEPS)) * np.array([[-1.0], [1.0]]),
}
#: The season's amplitude is that of a normal law, at any phase: a mixture of normal laws of sine
#: and cosine whose standard deviation is the cosine of an angle between 0 and 90 degrees.
ANGLES = (np.arange(4) + 0.5) / 4.0 * math.pi / 2.0
FACTORS = {"known": np.ones(1), "estimated": np.exp(np.linspace(-math.log(16), math.log(16), 8))}
#: Weights of the events of a machine that grows; a stable one has no repair.
EVENTS = {"": 2.0, "crash": 1.0, "instrument": 1.0, "repair": 1.0}
FALSE = 0.01


def variances(made: Machine) -> tuple[float, float]:
    """Return the variances of mean B and of slope by readings, traverses, visit and shape."""
    single, traverse, visit, shape = made.noise
    along = (made.targets - made.targets.mean()) / 1000.0
    square = float(along @ along)
    waves = np.sin(np.outer((1, 2, 3), np.pi * along / np.ptp(along))) @ along / square
    lost = 2.0 * (single**2 / along.size + traverse**2) / RUNS + visit**2
    return lost, single**2 / (2.0 * RUNS * square) + shape**2 * float(np.mean(waves**2))


def series(made: Machine, rng: np.random.Generator) -> tuple[Floats, Floats]:
    """Return mean B and slope of each test."""
    lost, slope = variances(made)
    count = made.years.size
    phase = rng.uniform(0.0, 2.0 * math.pi)
    season = made.hall * rng.normal() * np.cos(2.0 * math.pi * made.years + phase)
    scales = rng.normal(0.0, made.scale, 2)
    second = (made.event == "instrument") & (np.arange(count) >= made.at)
    sloped = made.true_slope(made.years) + season + np.where(second, scales[1], scales[0])
    return (
        made.true_reversal(made.years) + rng.normal(0.0, math.sqrt(lost), count),
        sloped + rng.normal(0.0, math.hypot(math.sqrt(slope), made.hall), count),
    )


class Likelihood:
    """The log likelihood of a series, averaged over covariances (q, n, n) and over any level."""

    def __init__(self, covariance: Floats, values: Floats, years: Floats) -> None:
        inverse = np.linalg.inv(covariance)
        row = inverse.sum(axis=2)
        total = row.sum(axis=1)
        self.precision = inverse - row[:, :, None] * row[:, None, :] / total[:, None, None]
        self.constant = -0.5 * (np.linalg.slogdet(covariance)[1] + np.log(total))[:, None]
        self.values, self.years = values, years

    def _product(self, one: Floats, other: Floats) -> Floats:
        found: Floats = (self.precision @ one @ other)[:, None]
        return found

    def _line(self, rates: Floats) -> Floats:
        values, years = self.values, self.years
        square = self._product(values, values) - 2.0 * rates * self._product(years, values)
        found: Floats = self.constant - 0.5 * (square + rates**2 * self._product(years, years))
        return found

    def at(self, rates: Floats, step: Floats | None = None, size: Floats | float = 0.0) -> Floats:
        """Return it for growth at ``rates`` (r,) with a step of ``size`` (r,)."""
        found = self._line(rates)
        if step is not None:
            off = self._product(self.values, step) - rates * self._product(self.years, step)
            found = found + size * off - 0.5 * size**2 * self._product(step, step)
        return _mean(found)

    def crash(self, rates: Floats, step: Floats, low: float, high: float) -> Floats:
        """Return it for a step whose size is equally likely between ``low`` and ``high``."""
        square = self._product(step, step)
        off = self._product(self.values, step) - rates * self._product(self.years, step)
        size, deviation = off / square, square**-0.5
        ends = np.stack([(low - size) / deviation, (high - size) / deviation])
        ends = np.where(ends[:1] > 0.0, -ends[::-1], ends)
        above, below = log_ndtr(ends[1]), log_ndtr(ends[0])
        share = above + np.log(-np.expm1(np.minimum(below - above, -1e-300)))
        wide = np.log(deviation * math.sqrt(2.0 * math.pi) / (high - low))
        return _mean(self._line(rates) + 0.5 * off**2 / square + share + wide)


def _mean(logs: Floats | Sequence[Floats]) -> Floats:
    """Return the logarithm of the mean over the first axis."""
    found: Floats = logsumexp(np.asarray(logs), axis=0) - math.log(len(logs))
    return found


def by_event(
    made: Machine, parameter: str, values: Floats, factors: Floats, rates: Floats
) -> dict[str, Floats]:
    """Return the log likelihood at the ``rates`` for each event: (1, r), or (places, r)."""
    years, count = made.years, made.years.size
    steps = [(np.arange(count) >= at).astype(np.float64) for at in range(3, count - 2)]
    lost, slope = variances(made)
    if parameter == "B_mean":
        spread = np.eye(count) * lost * factors[:, None, None]
        replaced = [spread] * len(steps)
    else:
        turn = np.cos(2.0 * math.pi * (years[:, None] - years)) * np.cos(ANGLES)[:, None, None] ** 2
        each = made.hall**2 * turn + np.eye(count) * (slope + made.hall**2)
        spread = np.concatenate([factor * each for factor in factors])
        same = [made.scale**2 * (step[:, None] == step) for step in steps]
        replaced = [spread + one for one in same]
    usual = Likelihood(spread, values, years)
    ends = (-6.0, -1.0) if parameter == "B_mean" else (-30.0, 30.0)
    backs = [-0.9 * rates * years[int(np.argmax(step))] for step in steps]
    repaired = [usual.at(rates, step, back) for step, back in zip(steps, backs, strict=True)]
    return {
        "": usual.at(rates)[None],
        "crash": np.stack([usual.crash(rates, step, *ends) for step in steps]),
        "instrument": np.stack([Likelihood(one, values, years).at(rates) for one in replaced]),
        "repair": np.stack(repaired),
    }


def growth(made: Machine, found: tuple[Floats, Floats], factors: Floats) -> dict[str, Floats]:
    """Return by parameter the log likelihood ratio of growth and no growth, for each sign of the
    rate: one of mean B, two of the slope.
    """
    none: dict[str, dict[str, Floats]] = {}
    grows: dict[str, list[dict[str, Floats]]] = {}
    for parameter, values in zip(PARAMETERS, found, strict=True):
        none[parameter] = by_event(made, parameter, values, factors, np.zeros(1))
        grows[parameter] = [
            by_event(made, parameter, values, factors, rates)
            for rates in np.atleast_2d(RATES[parameter])
        ]

    def both(one: dict[str, Floats], other: dict[str, Floats], events: Sequence[str]) -> float:
        weights = np.array([EVENTS[event] for event in events])
        logs = []
        for event in events:
            # a repair changes only what grows
            second = other["" if event == "repair" else event]
            logs.append(_mean((one[event] + second).ravel()))
        return float(logsumexp(np.array(logs), b=weights / weights.sum()))

    stable = both(none["B_mean"], none["slope"], [event for event in EVENTS if event != "repair"])
    signs = {
        parameter: np.array([both(one, none[other], list(EVENTS)) for one in grows[parameter]])
        for parameter, other in (("B_mean", "slope"), ("slope", "B_mean"))
    }
    return {
        parameter: signs[parameter]
        - np.logaddexp(stable, logsumexp(signs[other]) - math.log(signs[other].size))
        for parameter, other in (("B_mean", "slope"), ("slope", "B_mean"))
    }


def main() -> None:
    """Print what each judge finds."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", nargs="?", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    stable: defaultdict[tuple[str, str], list[float]] = defaultdict(list)
    cases: defaultdict[tuple[str, str, str], list[float]] = defaultdict(list)
    for number in range(given.count):
        made = machine(number, given.seed)
        size = {name: abs(made.rate) / made.judge(name) for name in PARAMETERS}
        grows = [name for name, kind in PARAMETERS.items() if kind == made.kind]
        if any(not 3.0 <= size[name] < 8.0 for name in grows):
            continue
        found = series(made, np.random.default_rng([given.seed, number, 9]))
        for judge, factors in FACTORS.items():
            for name, ratio in growth(made, found, factors).items():
                if made.kind == "stable":
                    stable[judge, name].append(float(ratio.max()))
                elif name in grows:
                    right = 0 if made.rate < 0.0 else 1
                    value = float(ratio[right]) if int(ratio.argmax()) == right else -math.inf
                    band = "3 to 5 errors" if size[name] < 5.0 else "5 to 8 errors"
                    for key in (band, f"{band}, {made.event or 'no event'}"):
                        cases[judge, name, key].append(value)
    limits = {key: float(np.quantile(each, 1.0 - FALSE)) for key, each in stable.items()}
    for judge in FACTORS:
        for band in sorted({key for _, _, key in cases}):
            held = [
                value > limits[judge, name]
                for name in PARAMETERS
                for value in cases.get((judge, name, band), [])
            ]
            share = (sum(held) + 0.5) / (len(held) + 1.0)
            error = 100.0 * math.sqrt(share * (1.0 - share) / len(held))
            print(
                f"noise {judge}, {band}: {sum(held)} of {len(held)} ="
                f" {100.0 * np.mean(held):.1f} ± {error:.1f} %"
            )


if __name__ == "__main__":
    main()
