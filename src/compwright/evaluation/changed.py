"""What differs between two tests of one axis or plane, and whether it is more than their
uncertainty.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from compwright.evaluation.scores import chance, score_of_ratio, score_of_t

#: Standard normal value that chance exceeds, up or down, once in 1000 comparisons.
CLEAR = 3.29
#: µm/m: slope that one of two tests has beside the other where nobody declares anything of
#: temperature, as much as 1 K makes of steel.
UNDECLARED_SLOPE = 11.5


@dataclass(frozen=True, slots=True)
class Told:
    """A parameter of a test: its value, standard error with degrees of freedom, and the standard
    uncertainty that is declared beside it; all in one unit.
    """

    value: float
    std_error: float
    dof: float = math.inf
    declared: float = 0.0


@dataclass(frozen=True, slots=True)
class Change:
    """A difference and its standard uncertainty; ``score``: the standard normal value as
    improbable, ``chance``: how often tests of an unchanged machine differ as much.
    """

    size: float
    std_error: float
    score: float

    @property
    def chance(self) -> float:
        """How often two tests of an unchanged machine differ by as much or more."""
        return chance(self.score)

    @property
    def clear(self) -> bool:
        """Whether it is beyond the uncertainty."""
        return abs(self.score) > CLEAR


def difference(before: Told, after: Told, beside: float = 0.0) -> Change:
    """Return by how much a parameter differs; ``beside``: a standard uncertainty between the two
    tests that neither tells of. GUM (JCGM 100:2008) 5.1.2 and G.4.1.
    """
    size = after.value - before.value
    scattered = [(told.std_error**2, told.dof) for told in (before, after)]
    known = before.declared**2 + after.declared**2 + beside**2
    total = known + sum(variance for variance, _ in scattered)
    if total <= 0.0:
        return Change(size, 0.0, math.copysign(math.inf, size) if size else 0.0)
    below = sum(variance**2 / dof for variance, dof in scattered if variance)
    dof = total**2 / below if below else math.inf
    t = size / math.sqrt(total)
    score = t if math.isinf(dof) else score_of_t(t, dof)
    return Change(size, math.sqrt(total), score)


def scatter_changed(before: Told, after: Told) -> Change:
    """Return by how much the standard deviation of a reading differs, judged by the ratio of the
    variances (F law).
    """
    size = after.value - before.value
    if before.value <= 0.0 or after.value <= 0.0:
        return Change(size, 0.0, 0.0)
    ratio = (after.value / before.value) ** 2
    return Change(
        size,
        math.hypot(before.std_error, after.std_error),
        score_of_ratio(ratio, after.dof, before.dof),
    )
