"""Error curves of virtual axes: sums of known shapes with drawn weights. Positions in mm (deg),
deviations in µm (arcsec).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Curve:
    """``shapes``: positions (m,) to values (k, m); ``weights`` (k,) of them; ``sizes`` (k,):
    standard deviations from which the weights come, for whoever may know the family.
    """

    shapes: Callable[[Floats], Floats]
    weights: Floats
    sizes: Floats

    def __call__(self, x: Floats) -> Floats:
        """Deviation at ``x`` (m,)."""
        return np.asarray(self.weights @ self.shapes(x))


def total(*curves: Curve) -> Curve:
    """Return the sum of curves."""
    return Curve(
        lambda x: np.concatenate([curve.shapes(x) for curve in curves]),
        np.concatenate([curve.weights for curve in curves]),
        np.concatenate([curve.sizes for curve in curves]),
    )


def smooth(rng: Generator, low: float, length: float, size: float) -> Curve:
    """A slope and four waves over the travel, ``size`` µm from lowest to highest or so."""
    k = np.arange(1, 5)
    waves = rng.normal(size=4) / k**1.3
    phases = rng.uniform(0, 2 * np.pi, 4)
    stretch = rng.uniform(0.35, 0.8)
    slope = rng.normal(0, 0.5)

    def shapes(x: Floats) -> Floats:
        u = (x - low) / length
        angles = 2 * np.pi * stretch * k[:, None] * u
        return np.concatenate([np.sin(angles), np.cos(angles), u[None]])

    weights = np.concatenate([waves * np.cos(phases), waves * np.sin(phases), [slope]])
    family = 1 / k**1.3 / np.sqrt(2)
    return Curve(shapes, size / 2 * weights, size / 2 * np.concatenate([family, family, [0.5]]))


def turning(amplitudes: Floats, phases: Floats, size: float) -> Curve:
    """One, two, three waves in a turn of 360 deg."""
    k = np.arange(1, 4)

    def shapes(x: Floats) -> Floats:
        angles = np.radians(k[:, None] * x)
        return np.concatenate([np.sin(angles), np.cos(angles)])

    weights = np.concatenate([amplitudes * np.cos(phases), amplitudes * np.sin(phases)])
    return Curve(shapes, weights, np.tile(size / k / np.sqrt(2), 2))


def sines(periods: tuple[float, ...], amplitudes: tuple[float, ...], rng: Generator) -> Curve:
    """Periodic errors, each with its phase and a second harmonic of up to 0.4 of it."""
    parts = [
        (period / k, amplitude * share, rng.uniform(0, 2 * np.pi), k)
        for period, amplitude in zip(periods, amplitudes, strict=True)
        for k, share in ((1, 1.0), (2, rng.uniform(0, 0.4)))
    ]
    lengths = np.array([part[0] for part in parts])[:, None]
    sizes = np.array([1.5 / np.sqrt(2) * (1.0 if part[3] == 1 else 0.25) for part in parts])

    def shapes(x: Floats) -> Floats:
        angles = 2 * np.pi * x / lengths
        return np.concatenate([np.sin(angles), np.cos(angles)])

    weights = [[a * np.cos(f) for _, a, f, _ in parts], [a * np.sin(f) for _, a, f, _ in parts]]
    return Curve(shapes, np.concatenate(weights), np.tile(sizes, 2))


def constant(value: float) -> Curve:
    """Return a curve that is the same everywhere."""
    return Curve(lambda x: np.ones((1, x.size)), np.array([value]), np.array([5.0]))


def bump(place: float, width: float, height: float) -> Curve:
    """Return a local excess."""
    return Curve(
        lambda x: np.exp(-0.5 * ((x - place) / width) ** 2)[None],
        np.array([height]),
        np.array([5.0]),
    )


def hinge(place: float, slope: float, size: float) -> Curve:
    """Return what a slope adds beyond ``place``."""
    return Curve(lambda x: np.maximum(x - place, 0)[None], np.array([slope]), np.array([size]))
