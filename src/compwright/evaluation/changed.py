"""What differs between two tests of one axis or plane, and whether it is more than their
uncertainty.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from compwright.evaluation.scores import chance, score_of_ratio, score_of_t

#: Standard normal value that chance exceeds, up or down, once in 1000 comparisons.
CLEAR = 3.29
#: µm/m: difference of slope between two tests that is assumed where no temperature uncertainty is
#: declared: the expansion of steel for 1 K.
UNDECLARED_SLOPE = 11.5


@dataclass(frozen=True, slots=True)
class UncertainValue:
    """A parameter of a test: value, standard error with its degrees of freedom, and ``declared``,
    the standard uncertainty that the job declares; all in one unit.
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


def difference(before: UncertainValue, after: UncertainValue, between_tests: float = 0.0) -> Change:
    """Return the difference of a parameter between two tests, with its standard uncertainty.

    ``between_tests``: a standard uncertainty of the difference that neither test contains. GUM
    (JCGM 100:2008) 5.1.2 and G.4.1.
    """
    size = after.value - before.value
    scattered = [(parameter.std_error**2, parameter.dof) for parameter in (before, after)]
    known = before.declared**2 + after.declared**2 + between_tests**2
    total = known + sum(variance for variance, _ in scattered)
    if total <= 0.0:
        return Change(size, 0.0, math.copysign(math.inf, size) if size else 0.0)
    below = sum(variance**2 / dof for variance, dof in scattered if variance)
    dof = total**2 / below if below else math.inf
    t = size / math.sqrt(total)
    score = t if math.isinf(dof) else score_of_t(t, dof)
    return Change(size, math.sqrt(total), score)


def scatter_changed(before: UncertainValue, after: UncertainValue) -> Change:
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
