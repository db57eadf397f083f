"""The functions of position in which the error of an axis is expanded.

A Gaussian process with a stationary covariance is written as a sum of sines with independent normal
weights. The variances of the weights are the spectral density of the covariance (Solin and Särkkä,
"Hilbert space methods for reduced-rank Gaussian process regression", Statistics and Computing 30,
2020, eq. 5 and 21). The design matrix is therefore the same for all hyperparameters. A random draw
of the whole curve is a random draw of the weights.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from math import lgamma

import numpy as np

from compwright.records.axis import FloatArray

#: The sines vanish at this multiple of the half range, far enough outside for the travel not to
#: notice.
BOUNDARY = 1.5
#: Harmonics of a known period: the screw's own turn and its half (misalignment, universal joint).
HARMONICS = (1, 2)


@dataclass(frozen=True, slots=True)
class Basis:
    """The functions of position whose weighted sum is the error of an axis.

    The first functions describe the mean error of both directions: offset, slope, sines, then
    cosine and sine of each harmonic of each period. The others describe the reversal error
    (positive minus negative): offset, slope, sines. Half of the reversal is added in + and
    subtracted in -. ``centre`` and ``half`` (mm or deg) give the normalised position u = (x -
    centre) / half.

    ``turn``: travel per turn of an endless axis, after which every function repeats. Its slope
    function is zero. Cosine and sine of the harmonics of the turn replace the sines, and their
    variances follow the same spectral density.
    """

    centre: float
    half: float
    sines: int
    reversal_sines: int
    periods: tuple[float, ...]
    bidirectional: bool
    turn: float | None = None
    kept: tuple[tuple[int, ...], ...] = ()

    @property
    def harmonics(self) -> tuple[tuple[int, ...], ...]:
        """The orders of the harmonics of each period: those in ``kept``, or all harmonics by
        default.
        """
        return self.kept or tuple(HARMONICS for _ in self.periods)

    @property
    def mean_size(self) -> int:
        """The number of functions that describe the mean of both directions."""
        return 2 + self.sines + 2 * sum(map(len, self.harmonics))

    @property
    def size(self) -> int:
        """The total number of functions of position in the model."""
        return self.mean_size + (2 + self.reversal_sines if self.bidirectional else 0)

    @property
    def frequencies(self) -> FloatArray:
        """Angular frequencies (sines,) of the sine functions, per unit of the normalised position
        u.
        """
        return self._frequencies(self.sines)

    @property
    def reversal_frequencies(self) -> FloatArray:
        """Angular frequencies (reversal_sines,) of the sine functions of the reversal error, per
        unit of the normalised position u.
        """
        return self._frequencies(self.reversal_sines)

    def design(self, positions: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the values of all functions (k, size) at ``positions`` (k,), mm or deg, one matrix
        per direction. The error in direction d = ±1 is f + d r / 2, with reversal error r = mean(+)
        - mean(-) (ISO 230-2:1997, 2.12).
        """
        mean, half_reversal = self.halves(positions)
        if not self.bidirectional:
            return mean, mean
        return np.hstack([mean, half_reversal]), np.hstack([mean, -half_reversal])

    def halves(self, positions: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return two matrices with the values of the functions at ``positions``: for the mean
        error, and for half the reversal error.

        ``positions`` (k,), mm or deg. The first matrix (k, mean_size) applies to both directions.
        The second matrix (k, size - mean_size) is added in + and subtracted in -.
        """
        u = (positions - self.centre) / self.half
        slope = u if self.turn is None else np.zeros_like(u)
        columns = [np.ones_like(u), slope, *self._waves(u, self.sines)]
        for period, harmonics in zip(self.periods, self.harmonics, strict=True):
            for harmonic in harmonics:
                angle = 2.0 * np.pi * harmonic * (positions - self.centre) / period
                columns += [np.cos(angle), np.sin(angle)]
        mean = np.column_stack(columns)
        if not self.bidirectional:
            return mean, np.empty((u.size, 0))
        return mean, 0.5 * np.column_stack(
            [np.ones_like(u), slope, *self._waves(u, self.reversal_sines)]
        )

    def _frequencies(self, count: int) -> FloatArray:
        if self.turn is None:
            return _frequencies(count)
        harmonics: FloatArray = np.repeat(np.arange(1, count // 2 + 1, dtype=np.float64), 2)
        return harmonics * (2.0 * np.pi * self.half / self.turn)

    def _waves(self, u: FloatArray, count: int) -> FloatArray:
        """Return the smooth functions (count, k) at normalised positions ``u`` (k,): sines over the
        range or, for an endless axis, the harmonics of a turn.
        """
        if self.turn is None:
            return _sines(u, count)
        angles = np.outer(self._frequencies(count)[::2], u)
        # A density S spread over lines 2 pi half / turn apart: each line carries S half / turn,
        # cosine and sine twice that.
        scale = np.sqrt(2.0 * self.half / self.turn)
        waves: FloatArray = scale * np.stack([np.cos(angles), np.sin(angles)], axis=1).reshape(
            count, u.size
        )
        return waves


def _frequencies(count: int) -> FloatArray:
    frequencies: FloatArray = np.arange(1, count + 1, dtype=np.float64) * (np.pi / (2.0 * BOUNDARY))
    return frequencies


def _sines(u: FloatArray, count: int) -> FloatArray:
    """Return sine functions (count, k) that vanish at both ends of the range and outside it.

    ``u`` (k,): normalised positions. The functions are the eigenfunctions of the Laplacian on
    [-BOUNDARY, BOUNDARY], sin(w (u + BOUNDARY)) / sqrt(BOUNDARY) (Solin and Särkkä 2020).
    """
    inside = np.clip(u, -BOUNDARY, BOUNDARY)
    waves: FloatArray = np.sin(np.outer(_frequencies(count), inside + BOUNDARY)) / np.sqrt(BOUNDARY)
    return waves


def log_density(frequencies: FloatArray, log_length: float) -> tuple[FloatArray, FloatArray]:
    """Return the log spectral density of a random curve (Matérn 5/2 process) of unit variance, and
    its derivative by ``log_length``, the logarithm of the correlation length of the curve.

    ``frequencies``: angular frequencies w. The density is S(w) = (16/3) a^5 / (a^2 + w^2)^3 with a
    = sqrt(5) / length (Rasmussen and Williams, Gaussian Processes for Machine Learning, eq. 4.15,
    one dimension, nu = 5/2).
    """
    a = np.sqrt(5.0) * np.exp(-log_length)
    together = a**2 + frequencies**2
    density = np.log(16.0 / 3.0) + 5.0 * np.log(a) - 3.0 * np.log(together)
    return density, -(5.0 - 6.0 * a**2 / together)


#: The roughest smooth part: once differentiable, a kink all but allowed.
LEAST_SMOOTHNESS = 1.5


def smooth_density(
    frequencies: FloatArray, log_length: float, log_excess: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the log spectral density of a random curve of unit variance, and its derivatives by
    ``log_length`` (logarithm of the correlation length) and by ``log_excess`` (parameter of the
    smoothness).

    The curve is a Matérn process of smoothness nu = `LEAST_SMOOTHNESS` + exp(``log_excess``). With
    correlation length l and angular frequency w (``frequencies``), its spectral density is

    S(w) = 2 sqrt(pi) gamma(nu + 1/2) / gamma(nu) l / sqrt(2 nu) (1 + l² w² / (2 nu))^-(nu + 1/2)

    (Rasmussen and Williams, Gaussian Processes for Machine Learning, eq. 4.15, one dimension). For
    large nu it approaches that of the squared exponential covariance.
    """
    excess = float(np.exp(log_excess))
    nu = LEAST_SMOOTHNESS + excess
    share = (np.exp(log_length) * frequencies) ** 2 / (2.0 * nu)
    logs = np.log1p(share)
    level = np.log(2.0 * np.sqrt(np.pi)) + lgamma(nu + 0.5) - lgamma(nu) - 0.5 * np.log(2.0 * nu)
    left = share / (1.0 + share)
    step = 1e-4 * nu
    up, down = (lgamma(nu + 0.5 + d) - lgamma(nu + d) for d in (step, -step))
    by_level = (up - down) / (2.0 * step)
    by_nu = by_level - 0.5 / nu - logs + (nu + 0.5) / nu * left
    return (
        level + log_length - (nu + 0.5) * logs,
        1.0 - (2.0 * nu + 1.0) * left,
        excess * by_nu,
    )


#: Two waves whose values at the targets agree to this (1: everywhere the same) cannot be
#: distinguished: less than 44 % of the amplitude of one is independent of the other.
ALIASED = 0.9
#: Waves at targets that are worked out at once: 8 MB.
_WINDOW = 200_000


def alias_wavelength(targets: FloatArray, wavelength: float) -> float | None:
    """Return the wavelength, mm or deg, of a longer wave that has the same values at the targets as
    a wave of this ``wavelength``; None if there is none.

    The result is inf if the values at the ``targets`` (m,), mm or deg, are constant. With a mean
    interval d between targets, waves longer than 2 d have no such alias. For a shorter wave, the
    absolute mean of exp(2 pi i (1 / wavelength - g) x) over the targets is computed for frequencies
    g within 1 / (2 d). It is the spectral window of the targets (Deeming, Astrophysics and Space
    Science 36, 1975). If it exceeds `ALIASED` for some g, the wave with the frequency g is the
    alias. This is always so with equal intervals, and hardly ever with the random part of ISO
    230-2.
    """
    return _alias_wavelength(targets.tobytes(), wavelength)


@functools.lru_cache(maxsize=64)
def _alias_wavelength(places: bytes, wavelength: float) -> float | None:
    """Return `alias_wavelength` for target positions as bytes, so that results can be cached."""
    targets = np.frombuffer(places)
    length = float(np.ptp(targets))
    widest = (targets.size - 1) / (2.0 * max(length, 1e-300))
    if 1.0 / wavelength <= widest or targets.size < 2:
        return None
    frequencies = np.linspace(-widest, widest, 16 * targets.size + 1)
    at_once = max(1, _WINDOW // targets.size)
    sizes = np.concatenate(
        [
            _window(1.0 / wavelength - frequencies[first : first + at_once], targets)
            for first in range(0, frequencies.size, at_once)
        ]
    )
    best = int(np.argmax(sizes))
    if sizes[best] < ALIASED:
        return None
    slow = abs(float(frequencies[best]))
    return 1.0 / slow if slow * length > 0.25 else float("inf")


def _window(frequencies: FloatArray, targets: FloatArray) -> FloatArray:
    """Return the spectral window (f,) of the ``targets`` (m,) at each of the ``frequencies`` (f,).
    It is 1 where a wave has the same value at every target (Deeming 1975).
    """
    turns = np.outer(frequencies, targets - targets[0])
    sizes: FloatArray = np.abs(np.mean(np.exp(2j * np.pi * turns), axis=1))
    return sizes


def hidden_share(targets: FloatArray, period: float) -> float:
    """Return the share (0 to 1) of a wave of this ``period`` that readings at targets cannot show.

    At 0 the readings show the whole wave, at 1 nothing of it. ``targets`` (m,) and ``period``: mm
    or deg. Offset and slope are removed from the cosine and the sine at the targets (orthogonal
    projection; Björck, Numerical Methods for Least Squares Problems, 1996, chapter 1). The visible
    share is the norm of the remainder at the worst phase, divided by sqrt(m / 2), the norm for
    evenly distributed targets.
    """
    middle = targets - np.mean(targets)
    span = max(float(np.ptp(targets)), 1e-300)
    straight, _ = np.linalg.qr(np.column_stack([np.ones_like(middle), middle / span]))
    angle = 2.0 * np.pi * middle / period
    waves = np.column_stack([np.cos(angle), np.sin(angle)])
    left = waves - straight @ (straight.T @ waves)
    smallest = np.linalg.svd(left, compute_uv=False)[-1] if targets.size > 1 else 0.0
    return float(1.0 - min(1.0, smallest / np.sqrt(targets.size / 2.0)))
