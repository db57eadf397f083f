"""From the decisions about the limits and the verdicts about the loading to the one verdict of a verification."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from compwright.evaluation.decision import Decision
from compwright.records.verification import LoadingName

OverallVerdict = Literal["good", "bad", "undecided"]


def overall_verdict(decisions: Iterable[Decision], loadings: Iterable[LoadingName]) -> OverallVerdict:
    """Return the verdict of a verification from the decisions of all limits and the loading verdict of every axis.

    ``good``: every limit is kept and every table is loaded. ``bad``: a limit is broken, or a table is known to act otherwise than
    planned (not active, inverted, ...). Everything else is ``undecided``, and so is a verification without a loading verdict.
    """
    decided, loaded = set(decisions), set(loadings)
    if "reject" in decided or loaded - {"loaded", "undecided"}:
        return "bad"
    if decided <= {"accept"} and loaded == {"loaded"}:
        return "good"
    return "undecided"
