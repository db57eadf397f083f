"""The scatter of repeated tests at each target and direction: error of the mean, and standard
deviation s of the readings.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.evaluation.statistics import mean_and_deviation
from compwright.prediction.fresh_noise import fresh_noise
from compwright.records.axis import FloatArray
from compwright.records.noise import NoiseDraws

#: Readings that are drawn at once: 8 MB.
_AT_ONCE: Final = 1_000_000


@dataclass(frozen=True, slots=True, kw_only=True)
class FreshScatter:
    """The scatter of s simulated tests at m targets, one test for each draw of the noise; mm or
    deg.

    ``mean_positive``, ``mean_negative`` (s, m): mean of the readings minus the error of the axis;
    NaN without readings. ``s_positive``, ``s_negative`` (s, m): standard deviation of the readings;
    NaN for fewer than two readings.
    """

    mean_positive: FloatArray
    s_positive: FloatArray
    mean_negative: FloatArray
    s_negative: FloatArray


def fresh_scatter(
    noise: NoiseDraws,
    targets: FloatArray,
    runs_positive: int | FloatArray,
    runs_negative: int | FloatArray,
    rng: np.random.Generator,
) -> FreshScatter:
    """Return the scatter of simulated tests at ``targets`` (m,), one test for each of the s draws
    of ``noise``.

    ``runs_*``: the number of readings in + and in -, one number or (m,); 0 if the direction is not
    measured. The tests are simulated reading by reading and evaluated as in ISO 230-2:1997, 2.10
    and 2.15.
    """
    runs = [
        np.broadcast_to(np.asarray(each, dtype=np.float64), targets.shape)
        for each in (runs_positive, runs_negative)
    ]
    most = [int(np.max(each, initial=0.0)) for each in runs]
    step = max(1, _AT_ONCE // max(1, targets.size * max(most)))
    made: list[list[FloatArray]] = [[], [], [], []]
    for first in range(0, noise.count, step):
        part = noise.taken(slice(first, first + step))
        blocks = fresh_noise(part, targets, most[0], most[1], rng)
        for side, (block, wanted) in enumerate(zip(blocks, runs, strict=True)):
            taken = np.arange(block.shape[2]) < wanted[:, np.newaxis]
            readings = block if np.all(taken) else np.where(taken, block, np.nan)
            mean, s = mean_and_deviation(readings)
            made[2 * side].append(mean)
            made[2 * side + 1].append(s)
    means_positive, s_positive, means_negative, s_negative = map(np.concatenate, made)
    return FreshScatter(
        mean_positive=means_positive,
        s_positive=s_positive,
        mean_negative=means_negative,
        s_negative=s_negative,
    )
