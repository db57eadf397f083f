"""The readings of which the samples of a circular test are means, near its reversals.

A long run is averaged before it is fitted. A mean of readings before and after a reversal has part
of the step and of the spike only (the response of a moving average to a step: Smith, The Scientist
and Engineer's Guide to Digital Signal Processing, 1997, chapter 15). The model has the same means
there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.estimation.circle_model import (
    PRIORS,
    UM,
    CauseColumn,
    CircleSamples,
    sample_spacing,
)
from compwright.estimation.circle_noise import IndexArray
from compwright.records.axis import FloatArray

#: Samples, from one before a reversal on, that are resolved into readings.
_RESOLVED: Final = 6.0
#: Standard uncertainties of the lag before a reversal within which a run begins at the reversal.
_AT_START: Final = 3.0


def readings_near_reversals(samples: CircleSamples) -> tuple[CircleSamples, IndexArray]:
    """Return the samples with those near a reversal replaced by the readings of which they are
    means, and the index of the first reading of each sample (n,).
    """
    spacing = sample_spacing(samples) / samples.radius
    since = np.mod(samples.sense * samples.theta + spacing, 0.5 * np.pi) / spacing
    counts = np.where(since < _RESOLVED, samples.averaged, 1)
    first = np.concatenate([[0], np.cumsum(counts)[:-1]])
    own = np.arange(np.sum(counts)) - np.repeat(first, counts)
    share = (own + 0.5) / np.repeat(counts, counts) - 0.5
    theta, sense, run, deviations = (
        np.repeat(values, counts)
        for values in (samples.theta, samples.sense, samples.run, samples.deviations)
    )
    theta = theta + spacing * share
    return replace(samples, theta=theta, sense=sense, run=run, deviations=deviations), first


def mean_column(column: CauseColumn, first: IndexArray) -> CauseColumn:
    """Return a column of readings as one of samples, means of the readings from ``first`` (n,)."""
    return replace(column, x=means(column.x, first), y=means(column.y, first))


def means(values: FloatArray, first: IndexArray) -> FloatArray:
    """Return the means (..., n) of the readings ``values`` (..., m) from ``first`` (n,) on. A
    sample is one reading or the mean of so many as each other mean.
    """
    counts = np.diff(first, append=values.shape[-1])
    (several,) = np.nonzero(counts > 1)
    found: FloatArray = values.take(first, axis=-1)
    if several.size:
        at = first[several][:, np.newaxis] + np.arange(counts[several[0]])
        found[..., several] = np.mean(values[..., at], axis=-1)
    return found


def early_columns(samples: CircleSamples) -> Iterator[CauseColumn]:
    """Yield model columns of what readings just before a reversal may show of lost motion and
    spike: 1 um at the reversal, for each direction whose run begins at a reversal point.

    The model reverses at the angle of the common lag, if one was found. The axes may reverse
    sooner, by ``lag_std`` (standard deviation). Where a run begins, few readings are before the
    reversal. One of them may in fact be after it, and would decide about spiral and lost motion
    without these columns.
    """
    if samples.lag == 0.0 or samples.lag_std == 0.0:
        return
    zero = np.zeros_like(samples.theta)
    for sense in np.unique(samples.sense):
        start = samples.arc[0] if sense > 0.0 else sum(samples.arc)
        point = round(start / (0.5 * np.pi))
        ahead = sense * (0.5 * np.pi * point - start)
        if not -samples.lag <= ahead <= _AT_START * samples.lag_std:
            continue
        since = samples.sense * (samples.theta - 0.5 * np.pi * point)
        since = np.mod(since + np.pi, 2.0 * np.pi) - np.pi
        near = np.where(since < 0.0, np.exp(-0.5 * (since / samples.lag_std) ** 2), 0.0)
        moved = UM * np.where(samples.sense == sense, near, 0.0)
        x, y = (zero, moved) if point % 2 else (moved, zero)
        yield CauseColumn(f"_early_{sense:+.0f}", x, y, PRIORS["_spike"])
