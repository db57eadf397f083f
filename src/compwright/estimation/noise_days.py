"""The noise of a new test, from several tests that were taken in the same way on different days.

One test shows its own drift and scatter, but not whether they repeat. Several tests show how drift
and scatter differ from day to day. There are two hypotheses for each:

    drift: the same in every test, or drawn for each test, normal with mean zero
    scatter: the same in every test, or its logarithm drawn for each test, normal about a mean

The prior probability of a repeating drift is one half. The same motion brings the same heat, but
the hall, the oil and the set-up differ (a judgement, from no document).

The prior probability of a repeating scatter is 0.7. Three axes in public logs were measured again
in the same way (github.com/anderssandstrom: vacuum tank after five weeks, target x the next day, a
slit six times). Their scatter changed by ratios of 1.24, 1.10 and up to 1.3. Chance alone exceeds
1.17, 1.19 and 1.27 in one case of three. With a flat prior on the share of axes with repeating
scatter, these axes give 0.72. If the target at another motor current is included, which halved its
scatter, they give 0.46.

The size of a drift is unknown and averaged over, with a flat prior on its logarithm. The size of a
change of the scatter has a flat prior itself, as is required for few groups (Gelman, Prior
distributions for variance parameters, Bayesian Analysis 1, 2006). With two tests, a drift that is
drawn for each test follows about Student's distribution with two degrees of freedom.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.noise import NoiseDraws

#: Part of a drift that counts as none of another day (`fresh_noise` draws it for every test).
_ALIKE: Final = 0.07
#: Sizes of a drift that is drawn, in the rms of those that were seen.
_SIZES: Final = np.geomspace(0.3, 12.0, 24)
#: Prior probability that the scatter is the same every day.
_SAME: Final = 0.7
#: Standard deviations of the logarithm of the scatter between days: a factor 1.2 to 2.7.
_CHANGES: Final = np.linspace(0.2, 1.0, 12)
_TINY: Final = 1e-12


def over_days(
    noise: NoiseDraws, tests: Sequence[NoiseDraws], own: int, rng: np.random.Generator
) -> NoiseDraws:
    """Return ``noise`` for a new test that is made like the test at index ``own``, with the
    variation of drift and scatter from day to day that the ``tests`` show.
    """
    drifts = np.array([(np.mean(each.drift), np.mean(each.drift_tilt)) for each in tests]).T
    stds = np.array([(np.std(each.drift), np.std(each.drift_tilt)) for each in tests]).T
    if np.any(drifts != 0.0):
        parts = [_drawn_sizes(drift, std) for drift, std in zip(drifts, stds, strict=True)]
        odds = sum(part[0] for part in parts)
        drawn = rng.random(noise.count) < 1.0 / (1.0 + np.exp(-np.clip(odds, -50.0, 50.0)))
        fresh = [
            rng.choice(sizes, noise.count, p=shares) * rng.standard_normal(noise.count)
            for _, sizes, shares in parts
        ]
        noise = replace(
            noise,
            drift=np.where(drawn, fresh[0], noise.drift),
            drift_tilt=np.where(drawn, fresh[1], noise.drift_tilt),
        )
    factor = np.exp(_log_change(tests, own, noise.count, rng))[:, np.newaxis]
    return replace(noise, sigma=noise.sigma * factor)


def _drawn_sizes(drifts: FloatArray, stds: FloatArray) -> tuple[float, FloatArray, FloatArray]:
    """Return the log odds that the drift differs from test to test, against a drift common to all
    tests, and possible standard deviations (s,) of the drift between tests with their
    probabilities. ``drifts`` (k,): drift in each test, with standard errors ``stds`` (k,).
    """
    size = float(np.sqrt(np.mean(drifts**2)))
    if size == 0.0:
        return 0.0, np.zeros(1), np.ones(1)
    noise = np.diag(np.maximum(stds, _ALIKE * size) ** 2)
    sizes = size * _SIZES
    same, each = np.ones((drifts.size, drifts.size)), np.eye(drifts.size)
    together, apart = (
        np.array([_log_normal(drifts, noise + one**2 * shape) for one in sizes])
        for shape in (same, each)
    )
    shares = np.round(np.exp(apart - np.max(apart)), 6)
    odds = np.logaddexp.reduce(apart) - np.logaddexp.reduce(together)
    return round(float(odds), 6), sizes, shares / np.sum(shares)


def _log_normal(values: FloatArray, covariance: FloatArray) -> float:
    root = np.linalg.cholesky(covariance)
    left = np.linalg.solve(root, values)
    return float(-0.5 * left @ left - np.sum(np.log(np.diag(root))))


def _log_change(
    tests: Sequence[NoiseDraws], own: int, count: int, rng: np.random.Generator
) -> FloatArray:
    """Return random draws (count,) of the log ratio of the scatter in a new test to that in test
    ``own``.

    The scatter is the rms of the central errors, because the scales of different distributions
    cannot be compared.
    """
    logs = [
        np.mean(np.log(np.maximum(each.sigma, _TINY)), axis=1) + np.log(each.reach)
        for each in tests
    ]
    means = np.array([np.mean(each) for each in logs])
    variances = np.array([max(float(np.var(each)), 1e-6) for each in logs])
    changes = np.append(0.0, _CHANGES)
    prior = np.append(_SAME, np.full(_CHANGES.size, (1.0 - _SAME) / _CHANGES.size))
    weights = 1.0 / (variances + changes[:, np.newaxis] ** 2)
    middle = weights @ means / np.sum(weights, axis=1)
    squares = np.sum(weights * (means - middle[:, np.newaxis]) ** 2, axis=1)
    # Restricted likelihood: the mean is not known.
    log = 0.5 * (np.sum(np.log(weights), axis=1) - np.log(np.sum(weights, axis=1)) - squares)
    shares = np.round(prior * np.exp(log - np.max(log)), 6)
    chosen = rng.choice(changes.size, count, p=shares / np.sum(shares))
    spread = changes[chosen] * np.sqrt(1.0 + 1.0 / len(tests))
    found: FloatArray = middle[chosen] - means[own] + spread * rng.standard_normal(count)
    return found
