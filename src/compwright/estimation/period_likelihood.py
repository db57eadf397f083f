"""The likelihood of periodic errors (waves) of any period in the mean of both directions.

It averages over the unknown smooth and irregular parts of the error. The model for the mean of both
directions at a target is

    middle = free columns + smooth part (standard deviation s, length l, `SMOOTHNESS`) + wave
             + white part of variance t (noise, and local part that repeats at a target)

The free columns are the offset, the slope and the known periods, with unknown weights. The local
part is the part of the error that is independent from target to target. Each target is weighted by
its own noise. The unit is the noise of the mean of both directions at a typical target.

A local part of fixed size, or a smooth part that is short enough, absorbs the wave. Therefore t, s
and l are not fixed. The likelihood is summed over a grid of them, the same for every hypothesis
(Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, section 5.2). The free
columns are projected out (restricted likelihood: Harville, J. Am. Stat. Assoc. 72, 1977).
Amplitudes are normally distributed for a given scale and are integrated out (Bretthorst, Bayesian
Spectrum Analysis and Parameter Estimation, 1988, chapter 3).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.basis import LEAST_SMOOTHNESS, Basis, smooth_density
from compwright.records.axis import FloatArray

#: Steps of the grid, natural logarithms.
_SMOOTH_STEP: Final = 0.7
_LENGTH_STEP: Final = 0.45
_WHITE_STEP: Final = 0.4
#: Centre and width of the prior of the length's logarithm, in half ranges: weak.
LENGTH: Final = (float(np.log(0.4)), 0.8)
#: Amplitudes of a wave, in widths of their prior.
AMPLITUDES: Final = np.arange(-2.0, 2.01, 0.5)

#: Smoothness of the smooth part, and how likely each is before the data: kinks in the slope (3/2)
#: are rarer than in its change (5/2), and these than none (infinite). The shares that the prior of
#: the estimate (`model`: an excess over 3/2 of about 3, its logarithm 1.2 wide) has below 2, from 2
#: to 3.5, and above.
SMOOTHNESS: Final = ((LEAST_SMOOTHNESS, 0.07), (2.5, 0.30), (np.inf, 0.63))

#: What stands for a smoothness that exceeds the least by nothing.
_NO_EXCESS: Final = 1e-3
#: Nodes count that come so near to the best one (natural logarithm).
_MATTERS: Final = 4.0

#: Amplitude that the targets show, in its standard errors: it differs from zero by three in 95 %
#: of all tests (the 95 % point of the normal law).
SEEN: Final = 3.0 + 1.645
#: Precision, in that of a typical target's middle, below which no amplitude is seen.
_UNSEEN: Final = 1e-4

#: Numbers that are worked on at a time: about ten arrays of them stay in the cache of a processor
#: that has other work too, and are not asked of the system anew each time.
CHUNK: Final = 30_000

IntArray = np.ndarray[tuple[int], np.dtype[np.intp]]


@dataclass(frozen=True, slots=True)
class BidirectionalMeans:
    """The mean of both directions at each target, from one or more tests.

    ``targets`` (m,), ``values`` (m,): target and mean, mm or deg. ``variances`` (m,): variances of
    the noise of the means, mm² or deg². ``dof``: degrees of freedom of these variances (0: known
    from neighbouring targets only). ``reading``: standard deviation of one reading, mm or deg.
    ``free`` (m, k): columns with unknown weights (offset and slope of each test).
    """

    targets: FloatArray
    values: FloatArray
    variances: FloatArray
    dof: float
    reading: float
    free: FloatArray


@dataclass(frozen=True, slots=True)
class Nodes:
    """Grid points of the model parameters with the same ``length`` (1: half the range) and
    ``smoothness`` of the smooth error.

    The model is diagonal in r directions of the smooth part. ``turned`` (r, r): rotation into these
    directions. ``weights`` (n, r): precisions along them. ``white`` (n,): precision across them.
    ``smooth`` (n,): standard deviation of the smooth part. ``log`` (n,): logarithm of the prior
    times the likelihood without a wave.
    """

    length: float
    smoothness: float
    smooth: FloatArray
    weights: FloatArray
    white: FloatArray
    log: FloatArray
    turned: FloatArray


@dataclass(frozen=True, slots=True)
class NodeChoice:
    """A selection of grid points of the model parameters, and of wave amplitudes."""

    nodes: tuple[tuple[int, IntArray], ...]
    amplitudes: IntArray


@dataclass(frozen=True, slots=True)
class _Waves:
    """Cosine and sine columns of f waves, each split into a part along the r smooth functions and
    the part orthogonal to these functions.

    ``along`` (r, f): components of each column along the smooth functions. The parts orthogonal to
    the smooth functions and to the free columns have only products: ``across`` (f,) of two columns
    with each other, and ``dual`` (f,) of a column with the values.
    """

    along: list[FloatArray]
    across: dict[tuple[int, int], FloatArray]
    dual: list[FloatArray]


class PeriodLikelihood:
    """Calculator of the likelihood of waves in the means, with ``basis`` for the smooth error."""

    def __init__(self, bidirectional: BidirectionalMeans, basis: Basis) -> None:
        self.targets = bidirectional.targets
        self.unit = float(np.sqrt(np.median(bidirectional.variances)))
        self.root = self.unit / np.sqrt(bidirectional.variances)
        values = self.root * bidirectional.values / self.unit
        free = _independent(self.root[:, np.newaxis] * bidirectional.free)
        rows = self.root[:, np.newaxis] * basis.design(bidirectional.targets)[0][:, 2:]
        rows = rows[:, : basis.sines]
        size = float(np.linalg.norm(rows))
        rows = rows - free @ (free.T @ rows)
        if float(np.linalg.norm(rows)) < 1e-9 * size:  # the free columns take all of it
            rows = np.zeros_like(rows)
        smooth = _independent(rows)
        smooth = _independent(smooth - free @ (free.T @ smooth))
        self.free, self.smooth = free, smooth
        values = values - free @ (free.T @ values)
        self.projected = smooth.T @ values
        self.rest = values - smooth @ self.projected
        self.left = max(bidirectional.targets.size - free.shape[1] - smooth.shape[1], 0)
        roughness = float(np.sqrt(np.mean(values**2)))
        spread = bidirectional.reading / self.unit
        self.roughness = max(roughness, 1e-3)
        #: Logarithm and width of the prior of an amplitude: as of a known period.
        self.amplitude = (float(np.log(max(spread, 0.2 * self.roughness))), 1.5)
        white, white_prior = _white_nodes(bidirectional.dof, spread, roughness)
        self.white_size = white.size
        self.nodes = self._nodes(basis, smooth.T @ rows, white, white_prior)

    def _nodes(
        self, basis: Basis, rows: FloatArray, white: FloatArray, white_prior: FloatArray
    ) -> list[Nodes]:
        found = []
        steps = np.arange(-2.0 / 1.5, 1.51, _SMOOTH_STEP / 1.5)
        smooth = np.exp(2.0 * (np.log(self.roughness) + 1.5 * steps))
        smooth_prior = -0.5 * steps**2
        quiet = float(self.rest @ self.rest) if self.left else 0.0
        for length, smoothness, share, log_variances in _densities(basis.frequencies):
            scaled = rows * np.exp(0.5 * log_variances)
            values, vectors = np.linalg.eigh(scaled @ scaled.T)
            turned = vectors.T
            mine = turned @ self.projected
            variances = (
                white[np.newaxis, :, np.newaxis]
                + smooth[:, np.newaxis, np.newaxis] * np.maximum(values, 0.0)
            ).reshape(smooth.size * white.size, values.size)
            each = np.tile(white, smooth.size)
            log = -0.5 * (
                np.sum(np.log(variances), axis=1)
                + self.left * np.log(each)
                + (mine**2 / variances).sum(axis=1)
                + quiet / each
            )
            log += (smooth_prior[:, np.newaxis] + white_prior[np.newaxis, :]).ravel()
            log += np.log(share) - 0.5 * ((np.log(length) - LENGTH[0]) / LENGTH[1]) ** 2
            found.append(
                Nodes(
                    length,
                    smoothness,
                    np.repeat(np.sqrt(smooth), white.size),
                    1.0 / variances,
                    1.0 / each,
                    log,
                    turned,
                )
            )
        return found

    def log_odds(
        self, frequencies: FloatArray, choice: NodeChoice | None = None, *, harmonics: int = 2
    ) -> tuple[FloatArray, ...]:
        """Return the log likelihood ratios of a wave against no wave at each of the ``frequencies``
        (1 / mm or 1 / deg): one array (f,) for a wave with one harmonic, and a second for a wave
        with two.

        ``choice``: grid points to use, with and without a wave; None for all. ``harmonics``: 1 to
        return only the array for one harmonic.
        """
        choice = choice or self.everything()
        log = self._log(choice)
        chunk = max(1, CHUNK // (log.size * choice.amplitudes.size))
        parts = [
            [
                log_sums(log_sums(gains) + log[:, np.newaxis])
                for gains in self._gains(part, choice, harmonics)
            ]
            for part in np.split(frequencies, range(chunk, frequencies.size, chunk))
        ]
        return tuple(np.concatenate(each) - _log_sum(log) for each in zip(*parts, strict=True))

    def detectable(self, frequencies: FloatArray) -> FloatArray:
        """Return the smallest wave amplitude (f,), mm or deg, that readings at the targets would
        show at each of the ``frequencies`` (1 / mm or 1 / deg); inf if none.

        It is `SEEN` times the standard error of an amplitude, at the phase where this error is
        largest.
        """
        choice = self.coarse()
        shares = np.exp(self._log(choice) - _log_sum(self._log(choice)))
        chunk = max(1, CHUNK // shares.size)
        precisions = []
        for part in np.split(frequencies, range(chunk, frequencies.size, chunk)):
            gram = self.moments(part, choice, harmonics=1)[0]
            both, apart = gram[0, 0] + gram[1, 1], gram[0, 0] - gram[1, 1]
            precisions.append(shares @ (0.5 * (both - np.hypot(apart, 2.0 * gram[1, 0]))))
        precision = np.concatenate(precisions)
        seen = precision > _UNSEEN
        found = np.full(frequencies.size, np.inf)
        found[seen] = SEEN * self.unit / np.sqrt(precision[seen])
        return found

    def everything(self) -> NodeChoice:
        """Return the selection of all grid points and all amplitudes."""
        return NodeChoice(
            tuple((number, np.arange(node.log.size)) for number, node in enumerate(self.nodes)),
            np.arange(AMPLITUDES.size),
        )

    def telling(self, frequencies: FloatArray) -> NodeChoice:
        """Return the grid points and wave amplitudes whose probability is not negligible."""
        choice = self.everything()
        log = self._log(choice)
        kept, amplitudes = log > np.max(log) - _MATTERS, np.zeros(AMPLITUDES.size, dtype=bool)
        for gains in self._gains(frequencies, choice):
            total = gains + log[:, np.newaxis]
            near = np.any(total > np.max(total, axis=(0, 1)) - _MATTERS, axis=2)
            kept |= np.any(near, axis=0)
            amplitudes |= np.any(near, axis=1)
        ends = np.cumsum([node.log.size for node in self.nodes])
        parts = np.split(kept, ends[:-1])
        return NodeChoice(
            tuple((i, np.flatnonzero(part)) for i, part in enumerate(parts) if np.any(part)),
            np.flatnonzero(amplitudes),
        )

    def _log(self, choice: NodeChoice) -> FloatArray:
        return np.concatenate([self.nodes[number].log[kept] for number, kept in choice.nodes])

    def _gains(
        self, frequencies: FloatArray, choice: NodeChoice, harmonics: int = 2
    ) -> list[FloatArray]:
        """Return the log likelihood gains (a, n, f) of a wave, for each amplitude and grid point:
        for a wave with one harmonic, for a wave with two, and so on up to ``harmonics``.
        """
        steps = AMPLITUDES[choice.amplitudes]
        log_prior = -0.5 * steps**2
        log_prior = log_prior - _log_sum(log_prior)
        variances = np.exp(2.0 * (self.amplitude[0] + self.amplitude[1] * steps))
        gram, moment = self.moments(frequencies, choice, harmonics=harmonics)
        return [
            gain + log_prior[:, np.newaxis, np.newaxis]
            for gain in log_gains(gram, moment, variances[:, np.newaxis, np.newaxis])
        ]

    def moments(
        self, frequencies: FloatArray, choice: NodeChoice, *, harmonics: int = 2
    ) -> tuple[dict[tuple[int, int], FloatArray], list[FloatArray]]:
        """Return W' P W and W' P y at each grid point, for the wave columns W, the means y at the
        targets and the precision matrix P of these means.

        The first result has an entry for each pair of columns, the second for each column. The
        columns are the cosine and sine of the first harmonic, then half the cosine and half the
        sine of the second.
        """
        waves = self._waves(frequencies, 2 * harmonics)
        each = [self._moments(self.nodes[number], kept, waves) for number, kept in choice.nodes]
        gram = {key: np.concatenate([part[0][key] for part in each]) for key in each[0][0]}
        moment = [np.concatenate(part) for part in zip(*(part[1] for part in each), strict=True)]
        return gram, moment

    def _moments(
        self, node: Nodes, kept: IntArray, waves: _Waves
    ) -> tuple[dict[tuple[int, int], FloatArray], list[FloatArray]]:
        turned = [node.turned @ along for along in waves.along]
        mine = (node.turned @ self.projected)[:, np.newaxis]
        weights, white = node.weights[kept], node.white[kept, np.newaxis]
        gram, moment = {}, []
        for i, first in enumerate(turned):
            moment.append(weights @ (mine * first))
            for j, second in enumerate(turned[: i + 1]):
                gram[i, j] = weights @ (first * second)
            if self.left:
                moment[i] += white * waves.dual[i]
                for j in range(i + 1):
                    gram[i, j] += white * waves.across[i, j]
        return gram, moment

    def coarse(self) -> NodeChoice:
        """Return a coarse selection of grid points for a first search over many frequencies."""
        away = [round(abs(np.log(node.length) - LENGTH[0]), 6) for node in self.nodes]
        middle = np.argsort(away, kind="stable")[1:3]
        size = self.white_size
        levels = self.nodes[0].log.size // size
        kept = np.array([i * size + j for i in range(0, levels, 2) for j in range(0, size, 3)])
        return NodeChoice(
            tuple((int(n), kept) for n in np.sort(middle)), np.arange(1, AMPLITUDES.size - 1, 3)
        )

    def _waves(self, frequencies: FloatArray, count: int) -> _Waves:
        """Return the first ``count`` of the four columns of each wave: cosine and sine, then half
        the cosine and half the sine of the second harmonic, because the prior of this harmonic is
        half as wide.
        """
        angle = 2.0 * np.pi * np.outer(self.targets - self.targets[0], frequencies)
        cosine, sine = np.cos(angle), np.sin(angle)
        root = self.root[:, np.newaxis]
        both = (cosine, sine) if count == 2 else (cosine, sine, cosine**2 - 0.5, cosine * sine)
        columns = [root * wave for wave in both]
        along = [self.smooth.T @ column for column in columns]
        if not self.left:
            return _Waves(along, {}, [])
        free = [self.free.T @ column for column in columns]
        across = {
            (i, j): sum(
                sign * np.einsum("kf,kf->f", part[i], part[j])
                for sign, part in ((1.0, columns), (-1.0, along), (-1.0, free))
            )
            for i in range(count)
            for j in range(i + 1)
        }
        return _Waves(along, across, [self.rest @ column for column in columns])


def log_gains(
    gram: Mapping[tuple[int, int], FloatArray], moment: Sequence[FloatArray], variance: FloatArray
) -> list[FloatArray]:
    """Return arrays of how much a wave increases the log likelihood: with one harmonic, with two,
    and so on. ``gram`` and ``moment``: matrix and right side of its normal equations; ``variance``:
    prior variance of its amplitude.

    With G = ``gram``, b = ``moment`` and D = ``variance``, the increase is b' (G + D^-1)^-1 b / 2 -
    ln det(I + D G) / 2. It is computed by elimination without pivoting of I + D G (Golub and Van
    Loan, Matrix Computations, 4th ed. 2013, algorithm 4.1.2).
    """
    size = len(moment)
    work = {key: variance * value for key, value in gram.items() if max(key) < size}
    for i in range(size):
        work[i, i] += 1.0
    root = np.sqrt(variance)
    right = [root * part for part in moment]
    gain, determinant = right[0] ** 2 / work[0, 0], work[0, 0]
    gains = []
    for i in range(size):
        pivot = work[i, i]
        if i:
            determinant = determinant * pivot
            gain += right[i] ** 2 / pivot
        if i % 2:  # cosine and sine of a harmonic are in
            gains.append(0.5 * gain - 0.5 * np.log(determinant))
        for j in range(i + 1, size):
            factor = work[j, i] / pivot
            right[j] -= factor * right[i]
            for k in range(i + 1, j + 1):
                work[j, k] -= factor * work[k, i]
    return gains


def log_smooth(frequencies: FloatArray, length: float, smoothness: float) -> FloatArray:
    """Return the log spectral density at the ``frequencies`` of a smooth random curve of unit
    variance, with correlation ``length`` and ``smoothness`` (infinite: without any kink).

    The curve is a Matérn process. For infinite ``smoothness`` its covariance is the squared
    exponential (Rasmussen and Williams 2006, section 4.2.1).
    """
    if np.isinf(smoothness):
        level = np.log(np.sqrt(2.0 * np.pi) * length)
        return np.asarray(level - 0.5 * (length * frequencies) ** 2)
    excess = float(np.log(max(smoothness - LEAST_SMOOTHNESS, _NO_EXCESS)))
    return smooth_density(frequencies, float(np.log(length)), excess)[0]


def _densities(frequencies: FloatArray) -> Iterator[tuple[float, float, float, FloatArray]]:
    """Yield each length and smoothness of the smooth part, with its prior probability and log
    spectral density at the ``frequencies``.
    """
    for step in np.arange(-1.6, 1.61, _LENGTH_STEP / LENGTH[1]):
        length = float(np.exp(LENGTH[0] + LENGTH[1] * step))
        for smoothness, share in SMOOTHNESS:
            yield length, smoothness, share, log_smooth(frequencies, length, smoothness)


def _white_nodes(dof: float, spread: float, roughness: float) -> tuple[FloatArray, FloatArray]:
    """Return possible sums (n,) of two variances, of the noise and of that part of the error which
    is independent from target to target, and their log prior probabilities. ``dof``: degrees of
    freedom of the noise; ``spread``: standard deviation of a reading; ``roughness``: rms of the
    means.

    The unit is the noise variance of the mean at a target. The log variance of the noise is
    normally distributed with variance 2 / dof (JCGM 100:2008, eq. G.3). Without degrees of freedom,
    the standard deviation has a factor of e up or down. The logarithm of the local part is centred
    at 0.1 times ``spread``, with width 1.5.
    """
    width = float(np.sqrt(2.0 / dof)) if dof else 2.0
    steps = np.linspace(-2.5, 2.5, 21)
    # As far as the roughest axis goes: what has no node is taken for waves.
    wide = np.linspace(-5.0, 5.0, 41)
    noise = np.exp(width * steps)
    local = np.exp(2.0 * (np.log(0.1 * spread) + 1.5 * wide))
    together = np.log(noise[:, np.newaxis] + local).ravel()
    mass = np.exp(-0.5 * (steps[:, np.newaxis] ** 2 + wide**2)).ravel()
    low = float(np.log(noise[3]))
    high = max(np.log(max(roughness**2, 1.0)) + 0.5, 1.0)
    count = int(np.ceil((high - low) / _WHITE_STEP)) + 1
    grid = np.linspace(low, low + _WHITE_STEP * (count - 1), count)
    place = np.clip((together - low) / _WHITE_STEP, 0.0, count - 1.0)
    left = np.minimum(place.astype(np.int64), count - 2)
    share = place - left
    total = np.bincount(left, weights=mass * (1.0 - share), minlength=count)
    total += np.bincount(left + 1, weights=mass * share, minlength=count)
    return np.exp(grid), np.log(np.maximum(total / np.sum(total), 1e-12))


def _independent(columns: FloatArray) -> FloatArray:
    """Return an orthonormal basis (m, r) of the space that the ``columns`` (m, k) span, without
    directions that only rounding errors cause.
    """
    if not columns.shape[1]:
        return columns
    left, sizes, _ = np.linalg.svd(columns, full_matrices=False)
    kept: FloatArray = left[:, sizes > 1e-9 * max(float(sizes[0]), 1e-300)]
    return kept


def _log_sum(logs: FloatArray) -> float:
    top = float(np.max(logs))
    return top + float(np.log(np.sum(np.exp(logs - top))))


def log_sums(logs: FloatArray) -> FloatArray:
    """Return the log of the sum of exponentials over the first dimension, without overflow."""
    top = np.max(logs, axis=0)
    total: FloatArray = top + np.log(np.sum(np.exp(logs - top), axis=0))
    return total
