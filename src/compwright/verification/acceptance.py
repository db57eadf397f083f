"""Overall verdict of a verification, from the decisions about limits and the verdicts on how the
tables were loaded.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from compwright.evaluation.decision import Decision
from compwright.records.verification import LoadingName

OverallVerdict = Literal["good", "bad", "undecided"]


def overall_verdict(
    decisions: Iterable[Decision], loadings: Iterable[LoadingName], *, still_open: bool = False
) -> OverallVerdict:
    """Return the overall verdict (``good``, ``bad`` or ``undecided``) from the decisions about
    limits and from the verdicts on how each axis's table was loaded. With ``still_open``, a proof
    is missing, and the verdict cannot be ``good``.

    ``good``: every limit is met, every table is loaded and no proof is missing. ``bad``: a limit is
    exceeded, or a table is known to be active in another way than planned (not active, inverted,
    ...). Everything else is ``undecided``. This includes a verification without a loading verdict,
    one with a fault of measurement (its values do not describe the machine), and an axis whose
    table is active at another temperature (``thermal``).
    """
    decided, loaded = set(decisions), set(loadings)
    if "measurement" in loaded:
        return "undecided"
    if "reject" in decided or loaded - {"loaded", "undecided", "thermal"}:
        return "bad"
    if not still_open and decided <= {"accept"} and loaded == {"loaded"}:
        return "good"
    return "undecided"
