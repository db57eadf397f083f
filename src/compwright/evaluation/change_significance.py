"""Significance of a difference between two tests of one axis or plane."""

from __future__ import annotations

import math
from dataclasses import dataclass


def score_of_t(t: float, dof: float) -> float:
    """Return the standard normal value that is as improbable as the value ``t`` of a Student's
    distribution.

    ``dof``: degrees of freedom of the distribution. The result has the sign of ``t``. It is
    accurate within 0.1 for the values and degrees of freedom used here (Wallace, Ann. Math.
    Statist. 30 (1959), "Bounds on normal approximations").
    """
    size = (8.0 * dof + 1.0) / (8.0 * dof + 3.0) * math.sqrt(dof * math.log1p(t * t / dof))
    return math.copysign(size, t)


def score_of_ratio(ratio: float, dof: float, dof_below: float) -> float:
    """Return the standard normal value that is as improbable as the ``ratio`` of two variances (F
    test). Degrees of freedom: ``dof`` of the numerator, ``dof_below`` of the denominator.

    The result is negative if the numerator is smaller. The approximation is that the cube root of F
    is nearly normal (Paulson, Ann. Math. Statist. 13 (1942) 233). It is applied with the larger
    variance as numerator, where it is most accurate.
    """
    if ratio < 1.0:
        return -score_of_ratio(1.0 / ratio if ratio > 0.0 else math.inf, dof_below, dof)
    if math.isinf(ratio):
        return math.inf
    a, b = 2.0 / (9.0 * dof), 2.0 / (9.0 * dof_below)
    root = math.cbrt(ratio)
    return ((1.0 - b) * root - (1.0 - a)) / math.sqrt(b * root**2 + a)


def two_sided_probability(score: float) -> float:
    """Return the probability that a standard normal value is at least ``score`` away from zero."""
    return math.erfc(abs(score) / math.sqrt(2.0))


#: Standard normal value that chance exceeds, up or down, once in 1000 comparisons.
CLEAR = 3.29
#: How often tests of one unchanged machine may show a change at all, however many are compared
#: (Bonferroni: the chances of single comparisons add up at most).
_OF_ALL = 0.01
#: µm/m: difference of slope between two tests that is assumed where no temperature uncertainty is
#: declared: the expansion of steel for 1 K.
UNDECLARED_SLOPE = 11.5


@dataclass(frozen=True, slots=True)
class UncertainValue:
    """A parameter of a test with its standard error and the degrees of freedom of that error.

    ``declared``: standard uncertainty that the job declares. ``value``, ``std_error`` and
    ``declared`` have the same unit.
    """

    value: float
    std_error: float
    dof: float = math.inf
    declared: float = 0.0


@dataclass(frozen=True, slots=True)
class Change:
    """A difference of two values with its standard uncertainty. ``score`` is the standard normal
    value that is as improbable as this difference between tests of an unchanged machine.
    """

    size: float
    std_error: float
    score: float

    @property
    def chance(self) -> float:
        """The probability that two tests of an unchanged machine differ by at least this
        difference.
        """
        return two_sided_probability(self.score)

    def clear(self, comparisons: int = 1) -> bool:
        """Return whether the difference is significant, as one of ``comparisons`` differences that
        are tested together.
        """
        return abs(self.score) > CLEAR and self.chance * comparisons < _OF_ALL


def difference(
    before: UncertainValue,
    after: UncertainValue,
    between_tests: float = 0.0,
    scatter: tuple[float, float] = (0.0, math.inf),
) -> Change:
    """Return the difference of a parameter between two tests, with its standard uncertainty. Two
    contributions that neither test contains are added: the standard uncertainty ``between_tests``,
    and ``scatter``, an estimated variance with its degrees of freedom.

    Source: GUM (JCGM 100:2008) 5.1.2 and G.4.1.
    """
    size = after.value - before.value
    scattered = [(parameter.std_error**2, parameter.dof) for parameter in (before, after)]
    scattered.append(scatter)
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
    """Return how the standard deviation of a reading differs between two tests, with an F test of
    the variances.
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
