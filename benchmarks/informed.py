"""Who knows the kind and the size of the noise, and the family of the error curve: the posterior of
the curve from the same readings, its table, and the narrowest honest bands.

Least squares with known variances (Gelman et al. 2013, Bayesian Data Analysis, chapter 14):
readings = shapes · weights + what traverses, drift and temperature add + noise. Tails and outliers
by reweighting (Lange, Little and Taylor 1989: Robust statistical modeling using the t
distribution).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from machines import INCH, METRIC, Machine
from numpy.random import Generator
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Informed:
    """Posterior of the weights of ``machine``'s curves: ``mean`` (k,), ``root`` (k, k) of the
    covariance.
    """

    machine: Machine
    mean: Floats
    root: Floats

    def error(self, x: Floats, rng: Generator | None = None) -> Floats:
        """Error (2, m) at ``x``: the mean, or a draw."""
        weights = self.mean
        if rng is not None:
            weights = weights + self.root @ rng.standard_normal(weights.size)
        up, less = _shapes(self.machine, x)
        k = up.shape[0]
        mean = weights[:k] @ up
        return np.stack([mean, mean - weights[k:] @ less])


def inform(machine: Machine, tests: Sequence[Floats]) -> Informed:
    """Return the posterior from the readings (2, m, n) of the ``tests``, NaN where none is: each
    multiplies the density, the prior counts once.
    """
    sizes = np.array([*machine.mean.sizes, *machine.reversal.sizes])
    precision, moment = (1 - len(tests)) * np.diag(sizes**-2.0), np.zeros(sizes.size)
    for readings in tests:
        mean, covariance = _from_one(machine, readings)
        inverse = np.linalg.inv(covariance)
        precision, moment = precision + inverse, moment + inverse @ mean
    together = np.linalg.inv(precision)
    together = 0.5 * (together + together.T)
    root = np.asarray(np.linalg.cholesky(together), dtype=np.float64)
    return Informed(machine, together @ moment, root)


def _from_one(machine: Machine, readings: Floats) -> tuple[Floats, Floats]:
    """Return mean (k,) and covariance (k, k) of the weights from the readings of one test."""
    x, noise = machine.targets, machine.noise
    u = (x - machine.low) / machine.length
    known = machine.in_time(u, *((0, 0) if noise.redrawn else (noise.drift, noise.expansion)))
    made = np.isfinite(readings)
    y = (readings - known)[made]
    y = y - y.mean()
    rows, sizes = _columns(machine, x, u)
    rows = rows[:, made].T
    scale = np.broadcast_to(machine.scales(u), made.shape)[made] * np.hypot(1, noise.states)
    step = noise.resolution**2 / 12
    weights = np.ones(y.size)
    for _ in range(12 if noise.student or noise.outlier_share else 1):
        precision = weights / (scale**2 + step)
        covariance = np.linalg.inv(rows.T @ (precision[:, None] * rows) + np.diag(sizes**-2.0))
        mean = covariance @ (rows.T @ (precision * y))
        left = ((y - rows @ mean) / scale) ** 2
        left += np.einsum("ij,jk,ik->i", rows, covariance, rows) / scale**2
        if noise.student:
            weights = (noise.student + 1) / (noise.student + left)
            weights *= (noise.student + 1) / (noise.student + 3)  # its information on the place
        elif noise.outlier_share:
            far = noise.outlier_share / 2 * np.exp(-0.5 * (np.sqrt(left) - noise.outlier_size) ** 2)
            near = (1 - noise.outlier_share) * np.exp(-0.5 * left)
            weights = near / (near + far)
    k = machine.mean.weights.size + machine.reversal.weights.size
    return mean[:k], covariance[:k, :k]


def without_period(machine: Machine, readings: Floats, x: Floats) -> Floats:
    """Return the error (2, k) at ``x`` that a judge expects who knows what `inform` knows, except
    the periods that the job does not give: the mean over all periods, weighted with their
    probability after the white ``readings`` (2, m, n).

    Before them, three cases have equal odds: no period, one as drawn by `machines.untold`, and any
    of 4 to 30 mm. Where the machine has two periods, a second one of the same odds may be there or
    not. No other estimate has a smaller expected square on a mixture of these kinds.
    """
    u, made = (machine.targets - machine.low) / machine.length, np.isfinite(readings)
    rows, sizes = _columns(machine, machine.targets, u)
    k, q = machine.mean.weights.size, machine.reversal.weights.size
    smooth = k - 4 * len(machine.periods)  # the rest are its waves
    rows, sizes = np.delete(rows, slice(smooth, k), 0)[:, made], np.delete(sizes, slice(smooth, k))
    y = readings[made] - readings[made].mean()
    variance = np.broadcast_to(machine.scales(u), made.shape)[made] ** 2
    variance = variance + machine.noise.resolution**2 / 12
    white = np.linalg.inv(np.linalg.cholesky((rows.T * sizes**2) @ rows + np.diag(variance)))
    others = 1 / np.arange(1 / 30, 1 / 4, 1 / (24 * machine.length))
    periods = np.array([*METRIC, *(25.4 * part for part in INCH), *others])
    odds = np.repeat([0.7 / len(METRIC), 0.1 / len(INCH)], [len(METRIC), len(INCH)])
    even = 0.2 * others / np.sum(others) + others**2 / np.sum(others**2)
    waves = _waves(periods, machine.targets)[:, :, np.nonzero(made)[1]]
    columns = waves @ white.T
    odds = np.concatenate([odds, even])
    weights = _mean_waves(columns, white @ y, odds, several=len(machine.periods) > 1)
    left = white @ (y - np.einsum("cw,cwr->r", weights, waves))
    curve = sizes**2 * (rows @ (white.T @ left))
    up, less = _shapes(machine, x)
    mean = curve[:smooth] @ up[:smooth]
    for one in np.flatnonzero(np.abs(weights).max(axis=1) > 1e-6):
        mean = mean + weights[one] @ _waves(periods[one : one + 1], x)[0]
    return np.stack([mean, mean - curve[smooth : smooth + q] @ less])


#: Of two periods, one at least is among so many that are most probable alone.
_FIRST = 400


def _mean_waves(columns: Floats, y: Floats, odds: Floats, *, several: bool) -> Floats:
    """Return the expected weights (c, 4) of waves with ``columns`` (c, 4, r), prior N(0, 1), from
    readings ``y`` (r,) whose noise has the variance 1. ``odds`` (c,): of each period before the
    readings, against none; with ``several``, of a second one, too.
    """
    gram, moment = columns @ columns.transpose(0, 2, 1) + np.eye(4), columns @ y
    weights, gains = _one_wave(gram, moment)
    logs = np.log(odds) + gains
    parts = [(0.0, 0.0 * weights)]  # log of a share, and the expected weights times this share
    top = float(logs.max())
    shares = np.exp(logs - top)
    parts.append((top + np.log(shares.sum()), weights * (shares / shares.sum())[:, None]))
    first = np.argsort(-logs)[: _FIRST if several else 0]
    for one in first:
        cross = columns @ columns[one].T
        carried = cross @ np.linalg.inv(gram[one])
        second, more = _one_wave(
            gram - carried @ cross.transpose(0, 2, 1), moment - carried @ moment[one]
        )
        pairs = logs[one] + np.log(odds) + more
        pairs[first] -= np.log(2.0)  # counted from either of the two
        pairs[one] = -np.inf
        top = float(pairs.max())
        shares = np.exp(pairs - top)
        total = float(shares.sum())
        found = second * (shares / total)[:, None]
        found[one] = weights[one] - np.einsum("cwv,cw->v", carried, found)
        parts.append((top + np.log(total), found))
    log = np.array([part for part, _ in parts])
    share = np.exp(log - log.max())
    share /= share.sum()
    return np.asarray(sum(part * found for part, (_, found) in zip(share, parts, strict=True)))


def _one_wave(gram: Floats, moment: Floats) -> tuple[Floats, Floats]:
    """Return expected weights (c, 4) and log odds (c,) of each wave against none."""
    weights = np.linalg.solve(gram, moment[..., None])[..., 0]
    gains = 0.5 * np.sum(moment * weights, axis=1) - 0.5 * np.linalg.slogdet(gram)[1]
    return np.asarray(weights, np.float64), np.asarray(gains, np.float64)


def _waves(periods: Floats, x: Floats) -> Floats:
    """Return sine and cosine (c, 4, k) of two harmonics of ``periods`` (c,) at ``x`` (k,), of the
    sizes in `error_curves.sines`.
    """
    angle = 2 * np.pi * x / periods[:, None]
    parts = [f(n * angle) * size for f in (np.sin, np.cos) for n, size in ((1, 1.0), (2, 0.25))]
    return np.asarray(1.5 / np.sqrt(2) * np.stack(parts, axis=1))


def _shapes(machine: Machine, x: Floats) -> tuple[Floats, Floats]:
    return machine.mean.shapes(x), machine.reversal.shapes(x)


def _columns(machine: Machine, x: Floats, u: Floats) -> tuple[Floats, Floats]:
    """Return the columns (k + q, 2, m, n) of all that is unknown, and its standard deviations."""
    noise, n, shape = machine.noise, machine.runs, (2, x.size, machine.runs)
    up, less = _shapes(machine, x)
    columns: list[Floats] = [np.broadcast_to(one[None, :, None], shape) for one in up]
    direction = np.array([0.0, -1.0])[:, None, None]
    columns += [np.broadcast_to(direction * one[None, :, None], shape) for one in less]
    sizes = [*machine.mean.sizes, *machine.reversal.sizes]

    def add(size: float, column: Floats) -> None:
        if size:
            columns.append(np.broadcast_to(column, shape))
            sizes.append(size)

    order = np.arange(2)[:, None, None] + 2 * np.arange(n)
    shift = np.hypot(noise.shift, noise.off_size * np.sqrt(noise.off_share))
    add(20.0, np.ones(shape))
    for traverse in range(2 * n):
        this = (order == traverse).astype(float)
        add(shift, this)
        add(noise.tilt, this * (u[:, None] - 0.5))
        add(noise.walk, (order >= traverse).astype(float))
    for run in range(n):
        add(noise.run_shift, (order // 2 == run).astype(float))
    angle = 2 * np.pi * noise.waves * machine.times(x.size)
    add(noise.wave, np.sin(angle))
    add(noise.wave, np.cos(angle))
    add(noise.temperature, u[:, None])
    if noise.memory:
        for step in np.eye(2 * x.size * n):
            add(1.0, machine.remembered(x.size, step))
    if noise.redrawn:
        add(noise.drift, machine.times(x.size))
        add(noise.expansion, machine.times(x.size) * u[:, None])
    return np.stack(columns), np.array(sizes)
