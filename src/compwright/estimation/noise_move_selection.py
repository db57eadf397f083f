"""Choice whether all or only some traverses, runs or time steps of a test shift the readings.

A creeping mounting shifts every traverse. A knock, a chip or an inaccurate reference run shifts
only some traverses. Existing shifts are normally distributed, the others are zero (Mitchell and
Beauchamp, J. Am. Stat. Assoc. 83, 1988). The share of existing shifts is either 1 or has Jeffreys'
prior.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from math import exp, lgamma, log, pi
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.noise import BoolArray

#: Prior probability that every one is moved: neither is more usual.
_ALL: Final = 0.5
#: Of the share that is moved where it is not all of them: Beta(1/2, 1/2) (Jeffreys, Theory of
#: Probability, 3rd ed. 1961, section 3.10).
_HALF: Final = 0.5


@dataclass(slots=True)
class ScoreEvidence:
    """The ``scores`` (r,), which are combinations of the readings that show traverse shifts
    (`ReducedReadings`). Their covariance is a known ``matrix`` (r, r) times an unknown variance.

    ``rest``: residual sum of squares of the readings. ``dof``: degrees of freedom of scores and
    rest together.
    """

    matrix: FloatArray
    scores: FloatArray
    rest: float
    dof: int


def drawn_from_prior(count: int, rng: np.random.Generator) -> BoolArray:
    """Draw which of ``count`` possible shifts of traverses exist, regardless of the readings."""
    every, share, chances = rng.random() < _ALL, rng.beta(_HALF, _HALF), rng.random(count)
    return np.ones(count, dtype=np.bool_) if every else chances < share


def draw_share(moved: BoolArray, rng: np.random.Generator) -> float:
    """Draw the share of shifted traverses, given which of the possible shifts exist (``moved``)."""
    there, count = int(np.count_nonzero(moved)), moved.size
    some = (1.0 - _ALL) * exp(_log_chance(there, count))
    every = _ALL if there == count else 0.0
    chance, share = rng.random(), rng.beta(there + _HALF, count - there + _HALF)
    return 1.0 if chance * (every + some) < every else float(share)


def draw_moved(
    moved: BoolArray, moves: FloatArray, evidence: ScoreEvidence, rng: np.random.Generator
) -> BoolArray:
    """Draw which of the possible shifts ``moves`` (q, r) exist: one shift after another, given the
    present state of all other shifts.

    A row of ``moves`` is the change of the scores by a shift of one standard deviation. ``moved``
    (q,): shifts that exist at present. The variance of a reading is integrated out (George and
    McCulloch, J. Am. Stat. Assoc. 88, 1993).
    """
    drawn = moved.copy()
    there = moves[moved]
    inverse = np.linalg.inv(evidence.matrix + there.T @ there)
    solved = inverse @ evidence.scores
    square = evidence.rest + float(evidence.scores @ solved)
    prior, chances = _log_priors(moved.size), rng.random(moved.size)
    for k, move in enumerate(moves):
        side = inverse @ move
        way = -1.0 if drawn[k] else 1.0
        stretch = max(1.0 + way * float(move @ side), 1e-12)
        other = square - way * float(move @ solved) ** 2 / stretch
        gain = -0.5 * (log(stretch) + evidence.dof * log(other / square))
        others = int(np.count_nonzero(drawn)) - int(drawn[k])
        odds = prior[others + 1] - prior[others] + way * gain
        wanted = bool(chances[k] * (1.0 + exp(-min(max(odds, -500.0), 500.0))) < 1.0)
        if wanted != drawn[k]:
            drawn[k] = wanted
            solved = solved - way * side * (float(move @ solved) / stretch)
            inverse = inverse - (way / stretch) * np.outer(side, side)
            square = other
    return drawn


@cache
def _log_priors(count: int) -> tuple[float, ...]:
    """Return for each k the log prior probability that the first k of ``count`` shifts exist, and
    no other.
    """
    some = [log(1.0 - _ALL) + _log_chance(there, count) for there in range(count)]
    return *some, log(_ALL + (1.0 - _ALL) * exp(_log_chance(count, count)))


def _log_chance(there: int, count: int) -> float:
    """Return the log prior probability (Jeffreys) that only a given set of ``there`` shifts exists.

    It is log B(k + 1/2, n - k + 1/2) - log B(1/2, 1/2), with k = ``there`` and n = ``count``.
    """
    return lgamma(there + _HALF) + lgamma(count - there + _HALF) - lgamma(count + 1.0) - log(pi)
