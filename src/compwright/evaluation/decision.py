"""Decision whether a value meets its limit: by the value alone, or with the uncertainty as a guard
band.
"""

from __future__ import annotations

import math
from typing import Literal

from compwright.foundations.errors import Fault, UsageError

Decision = Literal["accept", "reject", "undecided"]
Rule = Literal["simple", "guarded"]


def decide(value: float, limit: float, U: float | None, rule: Rule) -> Decision:
    """Return the decision whether ``value`` <= ``limit``, given the expanded uncertainty ``U`` (all
    three in the same unit).

    With the ``rule`` ``simple``, the value alone is compared with the limit. With ``guarded`` (ISO
    14253-1), the decision is to accept if value + U <= limit, to reject if value - U > limit, and
    else undecided. A value that is not a number is undecided. Raises UsageError for an unknown
    rule, and for ``guarded`` without an uncertainty.
    """
    if rule not in {"simple", "guarded"}:
        raise UsageError(
            Fault(
                message="the decision rule is unknown",
                place="decision_rule",
                expected="`simple` or `guarded`",
                found=str(rule),
                hint=("set `decision_rule: simple` or `decision_rule: guarded` in the job"),
            )
        )
    if rule == "guarded" and U is None:
        raise UsageError(
            Fault(
                message="the guarded decision needs the measurement uncertainty",
                place="decision_rule",
                expected="the key `uncertainty` in the job",
                found="none",
                hint="add `uncertainty` to the job, or set `decision_rule: simple`",
            )
        )
    if not math.isfinite(value):
        return "undecided"
    guard = 0.0 if rule == "simple" or U is None else abs(U)
    if value + guard <= limit:
        return "accept"
    return "reject" if value - guard > limit else "undecided"
