"""Loading verdicts on arrays: readings against expectations that a test makes up."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from compwright.records.axis import AxisKind, FloatArray
from compwright.records.verification import LoadingVerdict
from compwright.verification.hypothesis import Hypothesis
from compwright.verification.likelihood import AfterMeans, ErrorBelief
from compwright.verification.loading import judge_loading
from compwright.verification.measurement_cases import MeasurementCase, measurement_cases

#: Equally likely noises of a test.
DRAWS = 3


def means_of(
    readings: tuple[FloatArray, FloatArray],
    noise: float,
    noise_dof: float,
    positions: FloatArray,
    kind: AxisKind = AxisKind.LINEAR,
) -> AfterMeans:
    """Means of readings (m, n) in + and -, with a noise of their own from five degrees of freedom
    on, else ``noise``: 3 equally likely values of it by the chi-square law, one where it is known.
    """
    counts = np.stack([np.isfinite(block).sum(axis=1) for block in readings]).astype(float)
    held = [np.where(np.isfinite(block), block, 0.0).sum(axis=1) for block in readings]
    mean = np.stack(held) / np.maximum(counts, 1.0)
    squares = sum(
        float(np.nansum((block - one[:, None]) ** 2))
        for block, one in zip(readings, mean, strict=True)
    )
    dof = float(np.sum(np.maximum(counts - 1.0, 0.0)))
    sigma = max(math.sqrt(squares / dof), 1e-5) if dof >= 5.0 else max(noise, 1e-5)
    dof = dof if dof >= 5.0 else noise_dof
    drawn = np.full(1, sigma)
    if math.isfinite(dof):
        drawn = sigma * np.sqrt(dof / np.random.default_rng(9).chisquare(dof, DRAWS))
    return AfterMeans(
        targets=positions,
        kind=kind,
        plain=np.where(counts > 0, mean, np.nan),
        mean=np.broadcast_to(mean, (drawn.size, *mean.shape)),
        precision=counts / drawn[:, None, None] ** 2,
        columns=np.zeros((drawn.size, *mean.shape, 0)),
        sigma=sigma,
        readings=float(counts[counts > 0].mean()) if np.any(counts > 0) else 1.0,
    )


def known(mean: FloatArray, covariance: FloatArray | None = None) -> ErrorBelief:
    """A belief of ``mean`` (2, m) with ``covariance`` (2m, 2m), + then -; by target where it is
    diagonal.
    """
    m = mean.shape[1]
    root, blocks = np.zeros((2, m, 0)), np.zeros((m, 2, 2))
    if covariance is not None and not np.any(covariance - np.diag(np.diag(covariance))):
        blocks[:, 0, 0], blocks[:, 1, 1] = np.diag(covariance).reshape(2, m)
    elif covariance is not None:
        values, vectors = np.linalg.eigh(covariance)
        root = (vectors * np.sqrt(np.maximum(values, 0.0))).reshape(2, m, 2 * m)
    return ErrorBelief(mean=mean, root=root, blocks=blocks)


def ways_of(
    change: FloatArray, factors: Iterable[float] = (0.5,), *, slack: float = 0.0, free: bool = False
) -> tuple[Hypothesis, ...]:
    """A table (2, m) that is loaded, not active, or acts by a factor, with equal doubt; ``free``: or
    by a factor that nobody knows.
    """
    ways = [
        Hypothesis(
            name={0.0: "not_active", 1.0: "loaded", -1.0: "inverted"}.get(factor, "scaled"),  # type: ignore[arg-type]
            positive=factor * change[0],
            negative=factor * change[1],
            factor=factor,
            slack=slack,
        )
        for factor in (1.0, 0.0, *factors)
    ]
    if free:
        ways.append(
            Hypothesis(
                name="scaled",
                positive=change[0],
                negative=change[1],
                free=0.7 * change,
                weight=0.05,
                inner=True,
            )
        )
    return tuple(ways)


def judged(
    readings: tuple[FloatArray, FloatArray],
    loaded: FloatArray,
    inactive: FloatArray,
    covariance: FloatArray | None,
    noise: float,
    *,
    noise_dof: float = math.inf,
    positions: FloatArray | None = None,
    kind: AxisKind = AxisKind.LINEAR,
    declared: float | None = None,
    ways: tuple[Hypothesis, ...] | None = None,
    turned: bool = False,
) -> LoadingVerdict:
    """The verdict about ``readings`` whose means are expected to be ``loaded`` or ``inactive``
    (2, m); ``ways``: those of loading, default loaded, not active and half.
    """
    where = np.arange(float(loaded.shape[1])) if positions is None else positions
    after = means_of(readings, noise, noise_dof, where, kind)
    belief = known(inactive, covariance)
    view = MeasurementCase(belief=belief, hypotheses=ways or ways_of(loaded - inactive))
    views = [view, *(measurement_cases(view) if turned else ())]
    return judge_loading(after, views, declared_slope=declared)
