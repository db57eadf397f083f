"""Infer the noise of a test from the scatter of its repeated readings.

    reading = mean of its cell + offset and tilt of its traverse + drift with the runs + error

A cell is a target approached in one direction. A traverse is one pass over the targets in one
direction. Errors are normal, follow Student's distribution, or have outliers. Their scale may
differ between the directions and along the travel. All or only some traverses may be shifted. The
shifts may be independent or common to a run, or follow a random walk or a wave in time.

Every part of the noise may be zero, and its prior probability of being zero is the largest. The
readings decide how probable each part is. The parts are drawn at random by Gibbs sampling (Geman
and Geman, IEEE Trans. Pattern Anal. 6, 1984). When the size of a normal part is drawn, all normal
parts are integrated out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.noise_cells import cell_means, means_of_all_runs
from compwright.estimation.noise_chain import WAYS, GibbsChain, NoiseState
from compwright.estimation.noise_findings import noise_findings
from compwright.estimation.noise_patterns import RATES
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.noise_readings import CellReadings, cell_readings
from compwright.estimation.noise_rounding import rounded_stds
from compwright.estimation.noise_tails import REACH, TAILS
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.noise import WALK, IndexArray, NoiseDraws
from compwright.records.positioning import PositioningTest

#: Below this many contrasts the noise is left to the estimate of the curve.
LEAST_DOF: Final = 10
#: Runs from which the noise is estimated at most.
_MOST_RUNS: Final = 20
_SEED: Final = 3
_SETTLING: Final = 24  # sweeps that are thrown away
_DRAWS: Final = 48  # kept, of twice as many sweeps


def infer_noise(test: PositioningTest) -> NoisePosterior | None:
    """Return the probability distribution of the noise of ``test``, or None where it has fewer than
    `LEAST_DOF` degrees of freedom. The same test always gives the same result. Model and sources:
    module docstring.
    """
    every = cell_readings(test)
    if every.dof < LEAST_DOF:
        return None
    chosen = _thinned(test)
    readings = every if chosen is test else cell_readings(chosen)
    chain = GibbsChain(chosen, readings, np.random.default_rng(_SEED))
    for _ in range(_SETTLING):
        chain.sweep()
    sweeps = [chain.sweep() for _ in range(2 * _DRAWS)]
    reach = [draw.sigma * REACH[draw.tail] for draw in sweeps]
    pairs = np.argsort(reach, kind="stable").reshape(_DRAWS, 2)
    # One of each neighbouring pair, in turn the lower and the upper: the range stays complete.
    kept = pairs[np.arange(_DRAWS), np.arange(_DRAWS) % 2]
    cells = [cell_means(sweeps[k], readings, chain.shapes, chain.step) for k in kept]
    if chosen is not test:
        cells = [
            means_of_all_runs(cell, sweeps[k], chain.shapes, readings, every)
            for cell, k in zip(cells, kept, strict=True)
        ]
    sigma = _as_shown(np.array([draw.sigma for draw in sweeps])[kept], chain.step)
    tail = np.array([draw.tail for draw in sweeps])[kept]
    # Fresh tests cost next to nothing: they follow both, and each of the two in several ways.
    used = [sweeps[k] for k in kept]
    both, way = np.tile(pairs, WAYS).ravel(), np.tile(np.repeat(np.arange(WAYS), 2), _DRAWS)
    again = [sweeps[k] for k in both]
    reached = _as_shown(np.array([draw.sigmas for draw in sweeps])[both, way], chain.step)
    tails = np.array([draw.tails for draw in sweeps])[both, way]
    return NoisePosterior(
        draws=_noise(readings, used, tail, sigma, np.array([draw.size[:2] for draw in used])),
        fresh=_noise(readings, again, tails, reached, _repeated(again, readings, every)),
        mean=np.array([cell.mean for cell in cells]),
        precision=np.array([cell.precision for cell in cells]),
        columns=np.array([cell.columns for cell in cells]),
        sigma=float(np.exp(np.mean(np.log(sigma)))),
        dof=float(readings.dof),
        findings=(
            *_thinning(test, readings),
            *noise_findings(chosen, readings, sweeps, chain.step),
        ),
    )


def _thinned(test: PositioningTest) -> PositioningTest:
    """Return the test with at most `_MOST_RUNS` evenly chosen runs, because computing time grows
    with the third power of the runs.
    """
    blocks = test.positive, test.negative
    if max(block.shape[1] for block in blocks) <= _MOST_RUNS:
        return test
    kept = [
        np.unique(np.linspace(0, runs - 1, min(runs, _MOST_RUNS)).round().astype(int))
        if (runs := block.shape[1])
        else np.zeros(0, dtype=int)
        for block in blocks
    ]
    numbers = [
        tuple(labels[k] for k in places if k < len(labels))
        for labels, places in zip((test.runs_positive, test.runs_negative), kept, strict=True)
    ]
    return replace(
        test,
        positive=test.positive[:, kept[0]],
        negative=test.negative[:, kept[1]],
        runs_positive=numbers[0],
        runs_negative=numbers[1],
    )


def _thinning(test: PositioningTest, readings: CellReadings) -> Iterator[Finding]:
    runs = max(test.positive.shape[1], test.negative.shape[1])
    if readings.runs < runs:
        yield Finding.of("CW-E031", "info", used=readings.runs, runs=runs)


def _as_shown(sigma: FloatArray, step: float) -> FloatArray:
    """Return the standard deviations (count,) of readings that scatter by ``sigma`` (count,) and
    are then rounded to ``step``, mm or deg.
    """
    return rounded_stds(sigma, step) if step else sigma


def _repeated(
    draws: Sequence[NoiseState], readings: CellReadings, every: CellReadings
) -> FloatArray:
    """Return the standard deviations (count, 2) of offset and tilt of the traverses if a test with
    the readings ``every`` is repeated; its ``draws`` come from the ``readings`` of some of its
    runs.

    A random walk takes a step in each run. Its size is therefore reduced if only some runs were
    used.
    """
    sizes = np.array([draw.again for draw in draws])
    sizes[[draw.pattern == WALK for draw in draws]] *= np.sqrt(readings.runs / every.runs)
    return sizes


def _noise(
    readings: CellReadings,
    draws: Sequence[NoiseState],
    members: IndexArray,
    sigma: FloatArray,
    sizes: FloatArray,
) -> NoiseDraws:
    """Return the ``draws`` of the sampler as one record `NoiseDraws`. ``members``: the error
    distribution of each draw; ``sigma``: its scale; ``sizes``: offset and tilt of the traverses.
    """
    tails = [TAILS[member] for member in members]
    spread = np.array([draw.spread for draw in draws])
    drift = np.array([draw.drift for draw in draws])
    waves = np.array([draw.wave for draw in draws])
    return NoiseDraws(
        centre=readings.centre,
        half=readings.half,
        sigma=sigma[:, np.newaxis] * np.exp(np.outer(spread[:, 0], [0.5, -0.5])),
        growth=spread[:, 1:],
        dof=np.array([tail.dof for tail in tails]),
        outlier_share=np.array([tail.share for tail in tails]),
        outlier_size=np.array([tail.size for tail in tails]),
        outlier_fixed=np.array([tail.fixed for tail in tails]),
        core=np.array([tail.core for tail in tails]),
        reach=REACH[members],
        pattern=np.array([draw.pattern for draw in draws]),
        pace=waves[:, 0],
        cycles=waves[:, 1],
        moved=np.array([draw.share for draw in draws]),
        offset=sizes[:, 0],
        tilt=sizes[:, 1],
        drift=drift[:, 0],
        drift_tilt=drift[:, 1],
        drift_rate=RATES[[draw.rate for draw in draws]],
        farthest=readings.farthest,
    )
