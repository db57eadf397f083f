"""Decision whether a table helps an axis, what no table corrects, and what else would help."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.limiting_causes import DRIFT, NOISE, OUTLIERS, TRAVERSES, UNKNOWN
from compwright.planning.shortfalls import PERIOD, REVERSAL
from compwright.records.axis import Axis
from compwright.records.limits import LimitingCause, LimitingCauses
from compwright.words.sentences import Amount, say

#: From this share of the parameter on a cause is the reason.
_DOMINATES: Final = 0.5
#: Causes for which there is advice (sentence ``table_advice``).
_CURED_ELSEWHERE: Final = frozenset({NOISE, OUTLIERS, TRAVERSES, DRIFT, REVERSAL, PERIOD, UNKNOWN})
#: What is left to other causes, of which no single one is the largest.
_REMAINING: Final = "what no table of this control takes away"


def verdict(
    axis: Axis, limiting: LimitingCauses, *, tabled: bool, refused: bool
) -> Iterator[Finding]:
    """Yield the finding CW-P150 if a table improves an axis little, and CW-P151 if most of the
    remaining error is scatter. ``tabled``: a table is written; ``refused``: a table was made, but
    improves nothing.

    A gain is large enough if it exceeds one standard deviation of the parameter between tests.
    """
    left = limiting.then if tabled else limiting.now if refused else limiting.least
    gained = limiting.now - left
    helps = gained > limiting.spread
    scatter = limiting.least / limiting.now if limiting.now > 0.0 else 0.0
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    name, now = limiting.parameter, Amount(limiting.now * factor, unit)
    if helps and tabled:
        yield from _what_remains(axis, limiting, scatter)
    if helps:
        return
    main = _main_cause(limiting, scatter)
    if main is None:
        return
    share = main.value / limiting.then
    yield Finding.of(
        "CW-P150",
        "warning",
        axis=axis.name,
        parameter=name,
        now=now,
        with_table=Amount(limiting.then * factor, unit) if tabled else None,
        cause=say("limits.name", cause=main.cause),
        value=main.value * factor,
        unit=unit,
        share=share,
        advice=say("table_advice", cause=main.cause),
    )


def no_table_finding(axis: Axis, limiting: LimitingCauses) -> Finding:
    """Return the finding CW-P155: an axis gets no new table because a test would show no gain. The
    finding names the largest remaining cause.
    """
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    name, left = limiting.parameter, limiting.now
    main = _main_cause(limiting, 0.0)
    if main is not None and main.cause != NOISE:
        cause, value = main.cause, main.value
    elif limiting.least >= _DOMINATES * left:
        cause, value = NOISE, limiting.least
    else:
        cause, value = _REMAINING, left - limiting.least
    return Finding.of(
        "CW-P155",
        "info",
        axis=axis.name,
        cause=say("limits.name", cause=cause),
        value=value * factor,
        unit=unit,
        parameter=name,
        left=left * factor,
    )


def _what_remains(axis: Axis, limiting: LimitingCauses, scatter: float) -> Iterator[Finding]:
    """Yield a finding about the largest cause that remains after a table that helps. ``scatter``:
    share of the present parameter that remains with a perfect table.
    """
    factor, unit = outside_factor(axis.kind.unit), shown_unit(axis.kind.unit)
    main = _main_cause(limiting, 0.0)
    if main is not None and main.cause != NOISE:
        yield Finding.of(
            "CW-P151.cause",
            "info",
            axis=axis.name,
            parameter=limiting.parameter,
            now=Amount(limiting.now * factor, unit),
            taken=1.0 - limiting.then / limiting.now,
            cause=say("limits.name", cause=main.cause),
            value=main.value * factor,
            left=Amount(limiting.then * factor, unit),
            advice=say("table_advice", cause=main.cause),
        )
    elif scatter >= _DOMINATES:
        yield Finding.of(
            "CW-P151.scatter",
            "info",
            axis=axis.name,
            parameter=limiting.parameter,
            now=Amount(limiting.now * factor, unit),
            taken=1.0 - limiting.then / limiting.now,
            scatter=scatter,
        )


def _main_cause(limiting: LimitingCauses, scatter: float) -> LimitingCause | None:
    """Return the main cause why a table does not help, or None if no cause with a known remedy is
    large enough. ``scatter``: share of the present parameter that remains with a perfect table.
    """
    known = [cause for cause in limiting.causes if cause.cause in _CURED_ELSEWHERE]
    largest = max(known, key=lambda cause: cause.value, default=None)
    if largest is None or not limiting.then > 0.0:
        return None
    enough = largest.value >= _DOMINATES * limiting.then or scatter >= _DOMINATES
    return largest if enough else None
