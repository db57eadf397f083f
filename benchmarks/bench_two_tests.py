"""Two tests of a known error curve: does the noise of both hold that of a third?

    python benchmarks/bench_two_tests.py [N] [--seed S] [--kind KIND]...

Virtual axes of ``machine_kinds.py``. From each of two tests the noise is inferred, from both that
of a third (`over_days`). The error of the axis is taken as known, so that nothing but the noise is
judged: how often A, E, R, B and M of fresh tests at the same targets lie between p05 and p95, and
how wide the band of A is. For comparison the same with the noise of the first test alone.

Exits with 1 where two tests hold less than 86 % or more than 94 %, by more than two standard errors
(from axis to axis).
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from machine_kinds import KINDS
from machines import Floats, Machine, name_seed
from rival_tables import parameters
from table_quality import measured

from compwright.estimation.noise import infer_noise
from compwright.estimation.noise_days import over_days
from compwright.prediction.fresh_scatter import fresh_scatter
from compwright.prediction.positioning import predict_test
from compwright.records.axis import AxisKind
from compwright.records.noise import NoiseDraws
from compwright.records.positioning import PositioningTest

#: Short names, and the kinds of axes; each is measured twice.
ASKED = {
    "normal": "pitch known",
    "two states of rest": "two states of rest",
    "even scatter": "evenly spread scatter",
    "scatter by day": "scatter, another each test",
    "drift by day": "drift, another each test",
}
NAMES = ("A", "E", "R", "B", "M")
FRESH = 16
DRAWS = 1000
UM = 1e-3


def test_of(machine: Machine, readings: Floats) -> PositioningTest:
    """Return a test with ``readings`` (2, m, n) in µm."""
    runs = tuple(range(1, machine.runs + 1))
    return PositioningTest(
        name="x",
        axis="X",
        kind=AxisKind.LINEAR,
        targets=machine.targets,
        positive=readings[0] * UM,
        negative=readings[1] * UM,
        runs_positive=runs,
        runs_negative=runs,
        frame="machine",
    )


def held(machine: Machine, noise: NoiseDraws, fresh: Sequence[Floats]) -> tuple[float, float]:
    """Return which share of the parameters of ``fresh`` tests lies in the bands, and the width of
    that of A, µm.
    """
    positive, negative = np.repeat(
        machine.error(machine.targets)[:, np.newaxis] * UM, DRAWS, axis=1
    )
    scatter = fresh_scatter(
        noise, machine.targets, machine.runs, machine.runs, np.random.default_rng(1)
    )
    still = np.zeros(machine.targets.size)
    bands = predict_test(
        positive, negative, scatter, change_positive=still, change_negative=still, coverage=2.0
    )
    found = [parameters(readings, (1, -1)) for readings in fresh]
    inside = [bands[n].p05 <= one[n] * UM <= bands[n].p95 for one in found for n in NAMES]
    return float(np.mean(inside)), (bands["A"].p95 - bands["A"].p05) / UM


def experiment(kind: str, seed: int, number: int) -> tuple[float, float, float, float]:
    """Return share and width with the noise of one test, and of two."""
    rng = name_seed(kind, seed, number)
    machine = replace(KINDS[ASKED[kind]](rng), tests=2)
    days = []
    for _ in range(2):
        posterior = infer_noise(test_of(machine, measured(machine, rng, 0.0)))
        if posterior is None:
            raise ValueError(kind)
        days.append(posterior.fresh)
    fresh = [machine.measure(machine.targets, rng) for _ in range(FRESH)]
    one = days[0].taken(np.arange(DRAWS) * days[0].count // DRAWS)
    two = over_days(one, days, 0, np.random.default_rng(2))
    return *held(machine, one, fresh), *held(machine, two, fresh)


def main() -> None:
    """Print the shares by kind; exit with 1 where one is not as asked."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", nargs="?", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", action="append", choices=list(ASKED))
    given = parser.parse_args()
    failed = []
    for kind in given.kind or ASKED:
        found = np.array([experiment(kind, given.seed, number) for number in range(given.count)])
        one, narrow, two, wide = np.mean(found, axis=0)
        error = float(np.std(found[:, 2], ddof=1)) / given.count**0.5
        print(
            f"{kind}: two tests hold {100 * two:.1f} ± {100 * error:.1f} %, A {wide:.2f} µm wide;"
            f" one test {100 * one:.1f} %, {narrow:.2f} µm",
            flush=True,
        )
        if not 0.86 - 2.0 * error <= two <= 0.94 + 2.0 * error:
            failed.append(kind)
    if failed:
        sys.exit(f"not as asked: {', '.join(failed)}")


if __name__ == "__main__":
    main()
