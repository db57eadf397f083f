"""How often can bands hold where a tenth of the traverses is off? A judge who knows all but one.

    python benchmarks/bench_rare_shift.py [AXES]

Axes of the kind "a traverse off now and then" of `machine_kinds`. The judge knows the error curve,
the scatter, the share and the size of the shifts. One thing is unknown: whether the axis is of
this kind. A part of all axes is (prior), the others have white noise. A shift of a whole traverse
is plain to see. A first test of ten traverses shows none with probability 0.9^10 = 0.35; the prior
then leaves prior · 0.35 / (prior · 0.35 + 1 - prior) (Bayes). For each prior: how often A, E, R, B
and M of a fresh test lie in the judge's band of 5 to 95 %, where the first test showed no shift
and on all axes of the kind; and how wide the bands of the axes with white noise become.

40 axes: with a prior of 0.05 the judge holds 59 % where nothing was seen and 79 % on all; bands of
white noise are 1.03 times as wide. 84 % needs a prior above 0.3, with bands 1.6 times as wide (of A
2.3 times) on every axis with white noise. One test cannot do better.
Prints and judges nothing.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
from machine_kinds import machine_of
from machines import Machine
from numpy.random import Generator
from numpy.typing import NDArray
from quality_summary import PARAMETERS
from rival_tables import parameters

Floats = NDArray[np.float64]
KIND = "a traverse off now and then"
PRIORS = (0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5)
DRAWS, FRESH = 400, 100
LIMITS = (0.05, 0.95)


def values(machine: Machine, count: int, rng: Generator) -> Floats:
    """Return the parameters (5, count) of tests of an axis without error."""
    tests = [parameters(machine.scatter(machine.targets, rng), (1, -1)) for _ in range(count)]
    return np.array([[test[name] for test in tests] for name in PARAMETERS])


def held(band: Floats, fresh: Floats) -> float:
    """Return the share of ``fresh`` (n,) within the ``band`` (2,)."""
    return float(np.mean((fresh >= band[0]) & (fresh <= band[1])))


def mixed(shifted: Floats, white: Floats, share: float) -> Floats:
    """Return the quantiles (2,) of a mixture of two samples of equal size."""
    both = np.concatenate([shifted, white])
    weights = np.repeat([share, 1.0 - share], shifted.size) / shifted.size
    order = np.argsort(both)
    found = np.searchsorted(np.cumsum(weights[order]), LIMITS)
    return np.asarray(both[order][np.minimum(found, both.size - 1)])


def axis(number: int) -> Floats:
    """Return for each parameter and prior (5, priors, 3): share held where the first test shows no
    shift, share held on all axes of the kind, width on axes with white noise.
    """
    machine = machine_of(KIND, number)
    plain = replace(machine, noise=replace(machine.noise, off_share=0.0))
    rng = np.random.default_rng([9, number])
    shifted, white = values(machine, DRAWS, rng), values(plain, DRAWS, rng)
    fresh = values(machine, FRESH, rng)
    none = (1.0 - machine.noise.off_share) ** (2 * machine.runs)
    rows = np.empty((len(PARAMETERS), len(PRIORS), 3))
    for one, (moved, still, seen) in enumerate(zip(shifted, white, fresh, strict=True)):
        known = held(np.quantile(moved, LIMITS), seen)
        narrow = float(np.ptp(np.quantile(still, LIMITS)))
        for k, prior in enumerate(PRIORS):
            share = prior * none / (prior * none + 1.0 - prior)
            band = mixed(moved, still, share)
            unseen = held(band, seen)
            rows[one, k] = (
                unseen,
                none * unseen + (1.0 - none) * known,
                float(np.ptp(band)) / narrow,
            )
    return rows


def main() -> None:
    """Work, then print."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    every = np.mean([axis(number) for number in range(count)], axis=0)
    print("| prior | holds, no shift seen | holds, all | width, white noise (A) |")
    print("|---|---|---|---|")
    for prior, row, of_a in zip(PRIORS, every.mean(axis=0), every[0], strict=True):
        unseen, whole = (f"{100 * value:.0f}" for value in row[:2])
        print(f"| {prior:.2f} | {unseen} | {whole} | {row[2]:.2f} ({of_a[2]:.2f}) |")


if __name__ == "__main__":
    main()
