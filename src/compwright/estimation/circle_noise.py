"""The noise spectrum of a circular test, from the residuals of the fit. Weights by this spectrum
make the samples statistically independent.

Neighbouring samples are correlated. Deviations that the model does not contain return in every run
at the same angle. Thus neither the n samples nor two runs are independent. The samples are
therefore split into two halves: the part common to both directions, and the part that changes sign
with the direction. Each cause belongs to one of them.

Each half has a spectrum of its own: white noise plus first-order autoregressive noise. The cosine
transform makes such noise independent to good approximation, and needs no closed circle (Ahmed,
Natarajan and Rao, IEEE Trans. Computers C-23, 1974). The spectrum is an average over possible
spectra, weighted by their likelihood for independent ordinates (Whittle, Arkiv för Matematik 2,
1953). Its uncertainty thus widens the intervals.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.circle_model import CircleSamples
from compwright.records.axis import FloatArray

IndexArray = NDArray[np.intp]

#: Correlation lengths tried, and ratios of correlated to white density at frequency zero.
_LENGTHS: Final = 10
_RATIOS: Final = np.logspace(-1.0, 5.0, 19)
#: The sum of two correlated noises is tried for each of so many lengths and ratios.
_OF_TWO: Final = (2, 3)
#: The longest correlation tried is so small a part of a run: the orders that would show a longer
#: one are used up by the causes.
_SHORTEST_WAVE: Final = 16.0
#: Prior probabilities of white noise alone, of one correlated noise with it, and of two.
_PRIORS: Final = (0.45, 0.45, 0.1)
#: Ordinates of a spectrum are pooled above the first so many, in steps of a constant ratio.
SINGLE: Final = 32
_POOLED: Final = 36
#: A divisor of this number has no prime factor above 11: its Fourier transform is fast.
_SMOOTH: Final = (2 * 3 * 5 * 7 * 11) ** 12


@dataclass(frozen=True, slots=True)
class AngleGrid:
    """Samples at ``size`` angles common to all runs. ``index`` has the indices of these samples,
    one array (runs, size) per direction.
    """

    index: tuple[IndexArray, ...]
    size: int


@dataclass(frozen=True, slots=True)
class ResidualSpectrum:
    """The noise variance (size,), mm², at each order of the cosine transform, for the sum or the
    difference of both directions.

    ``density`` (size,): this variance. ``length``: correlation length in samples, the density at
    order zero divided by the mean density.
    """

    density: FloatArray
    length: float


def angle_grid(samples: CircleSamples) -> AngleGrid:
    """Return for every run those samples that are nearest to the points of a grid of equally spaced
    angles. The grid is the same for all runs, and has as many angles as the shortest run has
    samples. If the samples are means, up to 2 % fewer: a number whose Fourier transform is fast.
    """
    runs = [np.flatnonzero(samples.run == number) for number in np.unique(samples.run)]
    start, extent = samples.arc
    size = min(run.size for run in runs)
    if samples.averaged > 1:
        size = next(count for count in range(size, 0, -1) if _SMOOTH % count == 0)
    where = (np.arange(size) + 0.5) * extent / size
    index = []
    for sense in (1.0, -1.0):
        mine = [run for run in runs if samples.sense[run[0]] == sense]
        if mine:
            index.append(
                np.array(
                    [
                        _nearest(np.mod(samples.theta[run] - start, 2.0 * np.pi), where, run)
                        for run in mine
                    ]
                )
            )
    return AngleGrid(tuple(index), size)


def _nearest(angles: FloatArray, where: FloatArray, run: IndexArray) -> IndexArray:
    """Return the indices of the samples in ``run`` that are nearest to the angles ``where``."""
    order = np.argsort(angles, kind="stable")
    ordered = angles[order]
    right = np.clip(np.searchsorted(ordered, where), 1, ordered.size - 1)
    closer = np.where(where - ordered[right - 1] <= ordered[right] - where, right - 1, right)
    chosen: IndexArray = run[order[closer]]
    return chosen


def sum_and_difference(grid: AngleGrid, values: FloatArray) -> tuple[FloatArray, ...]:
    """Return the cosine transforms (size, ...) of two arrays: the sum and the difference of the
    ``values`` in both directions.

    ``values`` (n, ...): residuals or rows of the model, one for each sample. Runs of one direction
    are averaged, and the mean is weighted by the number of runs. A test in one direction gives only
    one array.
    """
    columns = values.T  # an array of transforms is quicker with the columns in one piece
    parts = [
        (
            columns.take(index[0], axis=-1)
            if index.shape[0] == 1
            else np.sqrt(index.shape[0]) * np.mean(columns.take(index, axis=-1), axis=-2)
        )
        for index in grid.index
    ]
    if len(parts) == 2:
        parts = [(parts[0] + parts[1]) / np.sqrt(2.0), (parts[0] - parts[1]) / np.sqrt(2.0)]
    return tuple(cosine_transform(part).T for part in parts)


def cosine_transform(values: FloatArray) -> FloatArray:
    """Return the orthonormal cosine transform (type II) of values (..., size) along the last axis.

    It is computed by one Fourier transform of the same length, with the even samples first and the
    odd ones backwards (Makhoul, IEEE Trans. Acoustics, Speech, and Signal Processing 28, 1980).
    """
    size = values.shape[-1]
    folded = np.fft.rfft(np.concatenate([values[..., ::2], values[..., 1::2][..., ::-1]], axis=-1))
    half = folded.shape[-1]
    folded *= np.exp(-0.5j * np.pi * np.arange(half) / size) * np.sqrt(2.0 / size)
    transformed = np.empty_like(values)
    transformed[..., :half] = folded.real
    # The upper half of the spectrum is the conjugate of the lower; turned on by a quarter it
    # becomes the imaginary part.
    transformed[..., half:] = -folded.imag[..., size - half : 0 : -1]
    transformed[..., 0] *= np.sqrt(0.5)
    return transformed


def inverse_cosine_transform(transformed: FloatArray) -> FloatArray:
    """Return the values (size,) whose orthonormal cosine transform is given (Makhoul 1980)."""
    size = transformed.size
    scaled = transformed * np.sqrt(0.5 * size)
    scaled[0] *= np.sqrt(2.0)
    backwards = np.concatenate([[0.0], scaled[:0:-1]])
    turn = np.exp(0.5j * np.pi * np.arange(size) / size)
    folded = np.fft.ifft(turn * (scaled - 1j * backwards)).real
    values = np.empty_like(transformed)
    half = (size + 1) // 2
    values[::2], values[1::2] = folded[:half], folded[half:][::-1]
    return values


def estimate_spectrum(residual: FloatArray, leverage: FloatArray) -> ResidualSpectrum:
    """Return the noise spectrum from the transformed residuals (size,), mm. ``leverage`` (size,):
    part of each degree of freedom that the fit uses.

    It is the average of spectra with all tried correlation lengths and noise ratios, weighted by
    their likelihood (Whittle 1953).
    """
    size = residual.size
    power, freedom = residual**2, np.clip(1.0 - leverage, 1e-9, 1.0)
    pools, inverse, logs, curves = _tried(size)
    pooled_power, pooled_freedom = np.add.reduceat(power, pools), np.add.reduceat(freedom, pools)
    ratios, log_prior = _mixtures(_LENGTHS)
    total = float(np.sum(pooled_freedom))
    scale = inverse @ pooled_power
    log = log_prior - 0.5 * logs @ pooled_freedom
    log -= 0.5 * total * np.log(np.maximum(scale, 1e-300))
    weights = np.exp(log - np.max(log))
    level = weights / np.sum(weights) * scale / max(total - 2.0, 1.0)
    density = np.sum(level) + (level @ ratios) @ curves
    # A tenth of a nanometre: data without any noise keep a finite weight.
    density = np.maximum(density, 1e-14)
    return ResidualSpectrum(density, float(density[0] / np.mean(density)))


@lru_cache(maxsize=2)
def _tried(size: int) -> tuple[IndexArray, FloatArray, FloatArray, FloatArray]:
    """Return the noise spectra to compare with residuals of ``size`` cosine-transform orders.

    Neighbouring orders are pooled. The results are the first order of each pool (p,); the inverse
    and the logarithm, each (m, p), of the m tried spectra at the middle of each pool; and the
    densities of correlated noise (2 * l, size) for l correlation lengths.
    """
    lengths = np.geomspace(1.0, max(size / _SHORTEST_WAVE, 2.0), _LENGTHS)
    pools = order_groups(size)
    middle = 0.5 * (pools + np.append(pools[1:], size) - 1.0)
    shapes = 1.0 + _mixtures(_LENGTHS)[0] @ _correlated(middle / size, lengths)
    return pools, 1.0 / shapes, np.log(shapes), _correlated(np.arange(size) / size, lengths)


@cache
def _mixtures(lengths: int) -> tuple[FloatArray, FloatArray]:
    """Return the m mixtures of white noise and correlated noises to try. There are 2 * ``lengths``
    correlated noises. For each mixture: the ratio of each correlated noise to white noise (m, 2 *
    ``lengths``), and the log prior probability (m,).

    Some mixtures have two correlated noises. A part of the path that no cause explains has a
    spectrum of its own. One correlated noise fitted to both would be too weak at the low orders,
    where the causes leave hardly any residual.
    """
    each = np.eye(2 * lengths)
    one = np.concatenate([ratio * each for ratio in _RATIOS])
    some = np.concatenate([ratio * each[:: _OF_TWO[0]] for ratio in _RATIOS[:: _OF_TWO[1]]])
    first, second = np.triu_indices(some.shape[0], 1)
    two = (some[first] + some[second])[np.sum(some[first] * some[second], axis=1) == 0.0]
    parts = np.zeros((1, 2 * lengths)), one, two
    log_priors = [
        np.full(part.shape[0], np.log(prior / part.shape[0]))
        for part, prior in zip(parts, _PRIORS, strict=True)
    ]
    return np.concatenate(parts), np.concatenate(log_priors)


def _correlated(frequency: FloatArray, lengths: FloatArray) -> FloatArray:
    """Return the spectral densities (2 * l, f) of correlated noise, relative to zero frequency.

    ``lengths`` (l,): samples in which the correlation falls to 1/e. ``frequency`` (f,): 1 is half a
    turn per sample. The first l densities are those of first-order autoregressive noise,
    proportional to 1 / (1 - 2 ρ cos w + ρ²) (Box and Jenkins, Time Series Analysis, 1970, chapter
    3). The others are the squares of these: the noise after the same filter is applied twice.
    """
    root = np.exp(-1.0 / lengths)[:, np.newaxis]
    density = (1.0 - root) ** 2 / (1.0 - 2.0 * root * np.cos(np.pi * frequency) + root**2)
    return np.vstack([density, density**2])


def order_groups(size: int) -> IndexArray:
    """Return the first order of each group of neighbouring orders of the cosine transform. Each low
    order is a group of its own; groups of higher orders are wider.
    """
    if size <= SINGLE + 1:
        return np.arange(size)
    wide = np.geomspace(SINGLE, size, _POOLED + 1)[:-1].astype(np.intp)
    return np.unique(np.concatenate([np.arange(SINGLE), wide]))
