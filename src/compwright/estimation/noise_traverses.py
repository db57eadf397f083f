"""Sampling of the shifts of whole traverses: offset, tilt, and drift over the runs.

Shifts are normally distributed. Their covariance is a sum of known patterns of unknown sizes,
relative to the variance of a reading (linear mixed model: Searle, Casella and McCulloch, Variance
Components, 1992, chapter 6). Each size is drawn on a grid by its exact conditional probability,
with the shifts and the variance of a reading integrated out (griddy Gibbs sampler: Ritter and
Tanner, J. Am. Stat. Assoc. 87, 1992). Each size may be zero (Mitchell and Beauchamp, J. Am. Stat.
Assoc. 83, 1988). If it is not, its prior is half-Cauchy (Gelman, Bayesian Analysis 1, 2006), in
units of the standard deviation of a reading.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.noise_move_selection import ScoreEvidence, draw_moved, drawn_from_prior
from compwright.estimation.noise_patterns import (
    DRIFT,
    DRIFT_TILT,
    FORM_SHARES,
    OFFSET,
    PACE_SHARES,
    TILT,
    Patterns,
    Sizes,
)
from compwright.estimation.noise_readings import ReducedReadings
from compwright.records.axis import FloatArray

#: Prior probability that there is none of it, of each by itself: a judgement. Together they leave a
#: plain test three chances in five.
_NOTHING: Final = (0.85, 0.9, 0.85, 0.93)
#: Scale of the half-Cauchy prior, in standard deviations of a reading.
_USUAL: Final = (0.7, 0.7, 2.0, 2.0)
#: Sizes from 0.03 to 360 standard deviations of a reading, by the root of 2.
_GRID: Final = 0.03 * 2.0 ** (0.5 * np.arange(28))
#: Natural logarithm of the evidence from which on the sampler begins with a drift (1000 to 1).
_CLEARLY: Final = 7.0


@dataclass(frozen=True, slots=True)
class _Spectrum:
    """The covariance of one kind of traverse shift, as eigenvalues relative to the covariance of
    all other shifts and the noise.

    The eigenvalues solve a generalised eigenvalue problem for each pattern (form) of the shift.
    ``base`` (forms,): log determinant of the covariance of all others. ``stretch`` (forms, r):
    eigenvalues. ``along`` (forms, r): scores in the direction of each eigenvector.
    """

    base: FloatArray
    stretch: FloatArray
    along: FloatArray


class ReducedTraverses:
    """Sampler of the sizes of traverse shifts from readings with ``dof`` degrees of freedom. It
    draws from exact conditional distributions.
    """

    def __init__(self, patterns: Patterns, data: ReducedReadings, dof: int, floor: float) -> None:
        root = data.root
        self.patterns, self.data, self.dof = patterns, data, dof
        self.rest = data.rest + floor**2
        self.moves = patterns.moves @ root
        self.waves = root.T @ patterns.waves @ root
        self.tilt = root.T @ patterns.tilt @ root
        self.drift = patterns.drift @ root
        self.drift_tilt = patterns.drift_tilt @ root
        self.known = patterns.known
        # By kind, with no other kind present, which is the most frequent case.
        self.alone: dict[tuple[int, bytes], _Spectrum] = {}
        self.offset: tuple[bytes, FloatArray] | None = None

    def begin(self, sizes: Sizes) -> None:
        """Set the start values ``sizes`` of the sampler: a drift or tilt where the readings clearly
        show it.

        The sampler changes one size at a time. Once it has large offsets that imitate a drift, it
        seldom leaves them.
        """
        if not self.patterns.walks:
            return
        moving, drifting = Sizes(sizes.moved), Sizes(sizes.moved)
        for kind in (OFFSET, TILT):
            without = self._climb(moving, kind)
        for kind in (DRIFT, DRIFT_TILT, OFFSET, TILT, DRIFT, DRIFT_TILT):
            with_drift = self._climb(drifting, kind)
        if with_drift > without + _CLEARLY:
            sizes.size, sizes.form, sizes.rate = drifting.size, drifting.form, drifting.rate

    def draw_sizes(self, sizes: Sizes, rng: np.random.Generator) -> None:
        """Draw the size, pattern and rate of each kind of traverse shift, given the present state
        of the other kinds of shifts.
        """
        sizes.form = self._draw(sizes, OFFSET, FORM_SHARES[: self.known], rng)
        self._draw_moved(sizes, rng)
        self._draw(sizes, TILT, np.ones(1), rng)
        if not self.patterns.walks:
            return
        for kind in (DRIFT, DRIFT_TILT):
            sizes.rate = self._draw(sizes, kind, PACE_SHARES, rng)

    def draw_variance(self, sizes: Sizes, rng: np.random.Generator) -> float:
        """Draw the variance of a reading from its distribution over all possible traverse shifts, a
        scaled inverse chi-square (Gelman et al., Bayesian Data Analysis, 3rd ed. 2013, section
        3.2).
        """
        matrix = np.eye(self.data.scores.size) + self._moving(sizes) + self._drifting(sizes)
        scores = self.data.scores
        square = self.rest + float(scores @ np.linalg.solve(matrix, scores))
        return square / float(rng.chisquare(self.dof))

    def draw_drift(self, sizes: Sizes, variance: float, rng: np.random.Generator) -> FloatArray:
        """Draw the drift of the offset and the drift of the tilt (2,), from the first to the last
        run, averaged over the other offsets and tilts of traverses.
        """
        drift = np.zeros(2)
        there = np.flatnonzero(sizes.size[DRIFT:] > 0.0)
        if there.size:
            columns = np.column_stack([self.drift[sizes.rate], self.drift_tilt[sizes.rate]])
            columns = columns[:, there]
            solved = np.linalg.solve(
                np.eye(columns.shape[0]) + self._moving(sizes),
                np.column_stack([columns, self.data.scores]),
            )
            precision = columns.T @ solved[:, :-1] + np.diag(sizes.size[DRIFT:][there] ** -2.0)
            covariance = np.linalg.inv(precision)
            mean = covariance @ (columns.T @ solved[:, -1])
            root = np.linalg.cholesky(0.5 * variance * (covariance + covariance.T))
            drift[there] = mean + root @ rng.standard_normal(there.size)
        return drift

    def effects(self, sizes: Sizes, drift: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return mean (k,) and covariance (k, k) of offsets and tilts for a given ``drift`` (2,),
        relative to the variance of a reading (Searle, Casella and McCulloch 1992, section 7.4).
        """
        prior = self.patterns.covariance(sizes)
        carried = prior @ self.data.root
        scores = self.data.scores - drift @ np.stack(
            [self.drift[sizes.rate], self.drift_tilt[sizes.rate]]
        )
        gain = np.linalg.solve(np.eye(scores.size) + self.data.root.T @ carried, carried.T).T
        return gain @ scores, prior - gain @ carried.T

    def _moving(self, sizes: Sizes) -> FloatArray:
        total: FloatArray = sizes.size[TILT] ** 2 * self.tilt[sizes.form]
        if sizes.size[OFFSET] > 0.0:
            total = total + sizes.size[OFFSET] ** 2 * self._offset(sizes)[sizes.form]
        return total

    def _offset(self, sizes: Sizes) -> FloatArray:
        """Return the covariance of the scores (`ReducedReadings`) that traverse offsets of unit
        size cause, for each pattern (forms, r, r).
        """
        key = sizes.moved.tobytes()
        if self.offset is None or self.offset[0] != key:
            there = self.moves[:, sizes.moved]
            alike = np.swapaxes(there, 1, 2) @ there
            self.offset = key, np.concatenate([alike, self.waves])[: self.known]
        return self.offset[1]

    def _draw_moved(self, sizes: Sizes, rng: np.random.Generator) -> None:
        """Draw which traverse shifts exist. If the present offsets are zero or follow a wave, the
        readings tell nothing about single shifts, and the draw is from the prior.
        """
        size = sizes.size[OFFSET]
        if size == 0.0 or sizes.form >= len(self.moves):
            sizes.moved = drawn_from_prior(sizes.moved.size, rng)
            return
        of_others = np.eye(self.data.scores.size) + self._drifting(sizes)
        of_others += sizes.size[TILT] ** 2 * self.tilt[sizes.form]
        evidence = ScoreEvidence(of_others, self.data.scores, self.rest, self.dof)
        sizes.moved = draw_moved(sizes.moved, size * self.moves[sizes.form], evidence, rng)

    def _drifting(self, sizes: Sizes) -> FloatArray:
        """Return the covariance (r, r) of the scores (`ReducedReadings`) that drift and tilt drift
        cause at their present size and rate.
        """
        total: FloatArray = sizes.size[DRIFT] ** 2 * np.outer(
            self.drift[sizes.rate], self.drift[sizes.rate]
        ) + sizes.size[DRIFT_TILT] ** 2 * np.outer(
            self.drift_tilt[sizes.rate], self.drift_tilt[sizes.rate]
        )
        return total

    def _draw(
        self,
        sizes: Sizes,
        kind: int,
        forms: FloatArray,
        rng: np.random.Generator,
    ) -> int:
        """Draw size and pattern of one ``kind`` of traverse shift; return the pattern. ``forms``:
        prior probability of each pattern. A tilt has the present pattern of the offsets.

        The grid of sizes is shifted at random before each draw, so that any size is possible.
        """
        grid = _GRID * 2.0 ** rng.uniform(-0.25, 0.25)
        usual = grid / (grid**2 + _USUAL[kind] ** 2)
        prior = np.concatenate([[_NOTHING[kind]], (1.0 - _NOTHING[kind]) * usual / usual.sum()])
        logs = self._scan(self._spectrum(sizes, kind), np.concatenate([[0.0], grid]))
        chances = np.exp(logs - logs.max()) * np.outer(forms, prior)
        cumulative = chances.cumsum()
        drawn = int(cumulative.searchsorted(rng.random() * cumulative[-1]))
        form, place = divmod(min(drawn, chances.size - 1), prior.size)
        sizes.size[kind] = grid[place - 1] if place else 0.0
        sizes.absent[kind] = chances[:, 0].sum() / cumulative[-1]
        return int(form)

    def _climb(self, sizes: Sizes, kind: int) -> float:
        """Set size and pattern of one ``kind`` of traverse shift to their most probable values,
        given the other kinds of shifts, and return the log evidence of these values.
        """
        grid = np.concatenate([[0.0], _GRID])
        logs = self._scan(self._spectrum(sizes, kind), grid)
        form, place = np.unravel_index(int(np.argmax(np.round(logs, 6))), logs.shape)
        sizes.size[kind] = grid[place]
        if kind == OFFSET:
            sizes.form = int(form)
        elif kind != TILT:
            sizes.rate = int(form)
        return float(logs[form, place])

    def _spectrum(self, sizes: Sizes, kind: int) -> _Spectrum:
        """Return the eigenvalues of the covariance of ``kind`` relative to that of all other shifts
        (simultaneous diagonalisation: Golub and Van Loan, Matrix Computations, 4th ed. 2013,
        section 8.7).
        """
        alone = np.count_nonzero(sizes.size) == int(sizes.size[kind] > 0.0)
        key = kind, sizes.moved.tobytes() if kind == OFFSET else bytes([sizes.form])
        if alone and key in self.alone:
            return self.alone[key]
        of_others, mine = self._of_others(sizes, kind)
        lower = np.asarray(np.linalg.cholesky(of_others), dtype=np.float64)
        drifts = kind in (DRIFT, DRIFT_TILT)
        found = self._of_lines(lower, mine) if drifts else self._of_forms(lower, mine)
        if alone:
            self.alone[key] = found
        return found

    def _of_forms(self, lower: FloatArray, mine: FloatArray) -> _Spectrum:
        """Return the eigenvalues of the covariances ``mine`` (forms, r, r), relative to a
        covariance with Cholesky factor ``lower``.
        """
        right = np.linalg.solve(lower, mine)
        inner = np.linalg.solve(lower, np.swapaxes(right, 1, 2))
        stretch, axes = np.linalg.eigh(0.5 * (inner + np.swapaxes(inner, 1, 2)))
        white = np.linalg.solve(lower, self.data.scores[np.newaxis, :, np.newaxis])
        return _Spectrum(
            base=_log_det(lower),
            stretch=np.maximum(stretch, 0.0),
            along=np.squeeze(np.swapaxes(axes, 1, 2) @ white, -1),
        )

    def _of_lines(self, lower: FloatArray, mine: FloatArray) -> _Spectrum:
        """Return the eigenvalues of the rank-one covariances c c' of the columns ``mine`` (rates,
        r), relative to a covariance with Cholesky factor ``lower``.
        """
        both = np.stack([mine, np.broadcast_to(self.data.scores, mine.shape)], axis=2)
        column, white = np.moveaxis(np.linalg.solve(lower, both), 2, 0)
        stretch = (column**2).sum(axis=1)
        along = (column * white).sum(axis=1) / np.sqrt(np.maximum(stretch, 1e-300))
        rest = np.maximum((white**2).sum(axis=1) - along**2, 0.0)
        return _Spectrum(
            base=_log_det(lower),
            stretch=np.stack([stretch, np.zeros_like(stretch)], axis=1),
            along=np.stack([along, np.sqrt(rest)], axis=1),
        )

    def _of_others(self, sizes: Sizes, kind: int) -> tuple[FloatArray, FloatArray]:
        """Return two covariances of the scores (`ReducedReadings`) for each pattern of ``kind``
        (forms, r, r): one caused by the noise and all other shifts, one caused by a shift of
        ``kind`` of unit size. For a tilt they are those of the present pattern alone.

        For a drift, the second result is not a covariance but the column (rates, r) of the drift.
        """
        unit = np.eye(self.data.scores.size)
        if kind in (OFFSET, TILT):
            offset, tilt = self._offset(sizes), self.tilt[: self.known]
            present = slice(sizes.form, sizes.form + 1)
            mine, other = (offset, tilt) if kind == OFFSET else (tilt[present], offset[present])
            rest = sizes.size[TILT - kind] ** 2 * other
            return unit + self._drifting(sizes) + rest, mine
        column, of_others = (
            (self.drift, self.drift_tilt) if kind == DRIFT else (self.drift_tilt, self.drift)
        )
        rest = sizes.size[DRIFT + DRIFT_TILT - kind] ** 2 * _outer(of_others)
        return unit + self._moving(sizes) + rest, column

    def _scan(self, spectrum: _Spectrum, grid: FloatArray) -> FloatArray:
        """Return the log evidence (forms, sizes) of each pattern of a shift at each size in
        ``grid``.
        """
        spread = 1.0 + grid[:, np.newaxis] ** 2 * spectrum.stretch[:, np.newaxis]
        square = self.rest + (spectrum.along[:, np.newaxis] ** 2 / spread).sum(axis=2)
        log_evidence: FloatArray = -0.5 * (
            spectrum.base[:, np.newaxis] + np.log(spread).sum(axis=2) + self.dof * np.log(square)
        )
        return log_evidence


def _log_det(lower: FloatArray) -> FloatArray:
    """Return the log determinants (forms,) of covariances with Cholesky factors ``lower``."""
    logs: FloatArray = 2.0 * np.log(np.diagonal(lower, axis1=1, axis2=2)).sum(axis=1)
    return logs


def _outer(columns: FloatArray) -> FloatArray:
    products: FloatArray = columns[:, :, np.newaxis] * columns[:, np.newaxis]
    return products
