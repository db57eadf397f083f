"""Findings about periodic errors that the measured targets can hide and that new targets can show.

The periods are those that the estimate holds possible, and those that the readings do not exclude.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Final, Literal

from compwright.estimation.axis import AxisPosterior
from compwright.estimation.further_targets import further_targets
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.limit_decisions import accept_decisions, accepted_index, magnitude
from compwright.records.axis import Axis
from compwright.records.job import AxisJob
from compwright.records.prediction import AcceptDecision, TestPrediction
from compwright.records.targets import targets_text
from compwright.words.sentences import Amount, say

#: Periods that are named: of this probability and more.
_NAMED: Final = 0.05


def decide_limits(
    entry: AxisJob,
    posterior: AxisPosterior,
    rule: Literal["simple", "guarded"],
    tests: tuple[TestPrediction, ...],
) -> tuple[Mapping[str, AcceptDecision], tuple[Finding, ...]]:
    """Return the decisions about the limits of an axis, with findings, from the predicted
    ``tests``.
    """
    if entry.accept is None:
        return {}, ()
    place = accepted_index(entry.accept, tuple(each.name for each in tests))
    accept = accept_decisions(entry, tests, rule)
    return accept, tuple(_undecided(entry.axis, accept, tests[place], posterior))


def further_targets_finding(axis: Axis, posterior: AxisPosterior) -> Iterator[Finding]:
    """Yield the finding CW-P164 if the measured targets may hide periodic errors. The finding names
    a few further targets that would show these errors.
    """
    hidden = posterior.hidden
    found = further_targets(posterior) if hidden.probability >= _NAMED else None
    if found is None:
        return
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    yield Finding.of(
        "CW-P164",
        "info",
        axis=axis.name,
        probability=hidden.probability,
        periods=[period for period, _ in hidden.periods[:3]],
        targets=found.targets.tolist(),
        unit=axis.kind.unit,
        # Three digits: the last bits of the fit differ between processors.
        amplitude=Amount(float(significant(found.amplitude * factor, 3)), unit),
    )


def _undecided(
    axis: Axis,
    accept: Mapping[str, AcceptDecision],
    test: TestPrediction,
    posterior: AxisPosterior,
) -> Iterator[Finding]:
    """Yield the finding CW-P133, with what to measure, if a limit is met at the measured targets
    but undecided at new targets.
    """
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    new, hidden = test.predicted_new_targets, posterior.hidden
    left = [
        say(
            "CW-P133.parameter",
            parameter=name,
            value=Amount(magnitude(new[name]).p95 * factor, unit),
            limit=entry.limit,
        )
        for name, entry in accept.items()
        if entry.decision == "undecided"
        and name in new
        and magnitude(test.predicted[name]).p95 * factor + (entry.U or 0.0) <= entry.limit
        and (entry.rule == "simple" or entry.U is not None)
    ]
    if not left:
        return
    targets, periods = test.before.test.targets, posterior.periods
    reasons = [
        say(
            "CW-P133.period",
            period=each.period,
            unit=axis.kind.unit,
            probability=each.probability,
        )
        for each in periods
        if _NAMED <= each.probability < 1.0
    ]
    if hidden.probability >= _NAMED:
        reasons.append(
            say(
                "CW-P133.open",
                probability=hidden.probability,
                periods=[period for period, _ in hidden.periods[:3]],
                unit=axis.kind.unit,
            )
        )
    known = any(each.source == "job" for each in periods)
    better = targets_text(float(targets[0]), float(targets[-1]), targets.size, axis.kind.unit)
    yield Finding.of(
        "CW-P133",
        "warning",
        axis=axis.name,
        parameters=left,
        reasons=reasons,
        better=better,
        known=known,
    )
