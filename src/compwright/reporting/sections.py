"""Parts of a page as rows of text: parameters, tests, findings, assumptions, verdicts.

A table of text is ``{"heads": [{"text", "unit", "numeric"}], "rows": [[str]]}``. A mark is
``{"tone", "text"}``, with one of the tones good, bad, open (undecided, or to be checked) and none.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final

from compwright.foundations.findings import DOUBTS_FIRST, next_step
from compwright.reporting.edition_terms import edition_symbol, parameter_term
from compwright.reporting.numbers import (
    DEVIATION_DECIMALS,
    MISSING,
    PARAMETERS,
    decimals_of,
    number,
    plain,
    position_unit,
    standard_text,
    symbol,
    unit_text,
)
from compwright.words.sentences import ControlText, Sentence, SentenceText, catalogue, say

Document = Mapping[str, Any]
Mark = dict[str, Any]
TextTable = dict[str, Any]

_DECISIONS: Final = {
    "accept": {"tone": "good", "text": say("decision.accept")},
    "reject": {"tone": "bad", "text": say("decision.reject")},
    "undecided": {"tone": "open", "text": say("decision.undecided")},
}
_SEVERITIES: Final = {
    "error": {"tone": "bad", "text": say("severity.error")},
    "warning": {"tone": "open", "text": say("severity.warning")},
    "info": {"tone": "none", "text": say("severity.info")},
}
#: Messages that begin with a word, not with a name that a file or a job gives.
_WORDED: Final = re.compile(r"[a-z]+ |\{label\}")
_BAR_WIDTH: Final = 200.0
_COLUMNS: Final = 10  # traverses that fit across a page
_LINE: Final = 105  # letters that fit across a page, three of them between two columns


def decision_mark(decision: object) -> Mark:
    """Return the mark for accept, reject or undecided; for any other ``decision``, the mark for "no
    limit".
    """
    return dict(_DECISIONS.get(str(decision), {"tone": "none", "text": say("decision.no_limit")}))


def loading_mark(verdict: object) -> Mark:
    """Return the mark for a loading verdict (``loaded``, ``not_active``, ...)."""
    name = str(verdict)
    tone = {"loaded": "good", "undecided": "open", "measurement": "open"}.get(name, "bad")
    return {"tone": tone, "text": say("mark.loading", verdict=name)}


def pairs(values: Document | None) -> list[tuple[str, str]]:
    """Return name and text of each entry of a mapping that is not empty."""
    return [
        (str(name), plain(value))
        for name, value in (values or {}).items()
        if value not in (None, "")
    ]


def heads(
    *columns: tuple[str | Sentence, str | Sentence] | str | Sentence,
) -> list[dict[str, Any]]:
    """Return the column headings of a table. A text heads a column of text; a pair (name, unit)
    heads a column of numbers.
    """
    return [
        (
            {"text": column, "unit": "", "numeric": False}
            if isinstance(column, str | Sentence)
            else {"text": column[0], "unit": column[1], "numeric": True}
        )
        for column in columns
    ]


def findings(*groups: Iterable[Document] | None) -> list[dict[str, Any]]:
    """Return the findings of several groups as one list. Each finding occurs once; errors come
    first, then warnings.
    """
    ranks = list(_SEVERITIES)
    seen: dict[tuple[str, str], dict[str, Any]] = {}
    for item in (item for group in groups for item in group or ()):
        severity = str(item.get("severity", "info"))
        rank = ranks.index(severity) if severity in ranks else len(ranks)
        mark = dict(_SEVERITIES.get(severity, _SEVERITIES["info"]))
        code, message = plain(item.get("code")), _sentence(plain(item.get("message")))
        seen.setdefault(
            (code, message), {"code": code, "message": message, "mark": mark, "rank": rank}
        )
    return sorted(seen.values(), key=lambda entry: int(entry["rank"]))


def _sentence(message: str) -> str:
    """Return a message that begins with a capital letter, except if its first word is a name from a
    file.
    """
    if isinstance(message, SentenceText) and _WORDED.match(catalogue("en")[message.sentence.name]):
        return SentenceText(say("card.capital", text=message))
    return message


def doubts(items: Iterable[Document] | None) -> dict[str, Any] | None:
    """Return the doubts together with their heading and the next step, or None if there are no
    doubts.
    """
    open_doubts = findings(items)
    step = next_step(item["code"] for item in open_doubts)
    return {"heading": DOUBTS_FIRST, "items": open_doubts, "step": step} if open_doubts else None


def acknowledged(items: Iterable[Document] | None) -> list[Sentence]:
    """Return the doubts that the job acknowledges, each with its reason."""
    return [
        say(
            "label.coded",
            code=plain(item["code"]),
            text=say(
                "doubts.acknowledged", reason=plain(item["reason"]), message=plain(item["message"])
            ),
        )
        for item in items or ()
    ]


def rule_lines(accept: Mapping[str, Any], unit: str, *, after: bool = False) -> list[Sentence]:
    """Return the sentence on the decision rule for the limits, with the guard bands if the rule has
    any; an empty list if there are no limits. ``after``: the limits are those of a test after
    loading.
    """
    guarded = {
        symbol(name): entry.get("U")
        for name, entry in accept.items()
        if entry.get("rule") == "guarded"
    }
    bands = [
        say("rule.band", symbol=letter, U="" if U is None else number(U), unit=unit)
        for letter, U in guarded.items()
    ]
    if bands:
        return [say("rule.guarded_after" if after else "rule.guarded", bands=bands)]
    return [say("rule.simple_after" if after else "rule.simple")] if accept else []


def assumed(facts: Iterable[Document] | None) -> list[dict[str, Any]]:
    """Return the assumptions as rows of text. Assumptions that are not confirmed are marked and
    come first.
    """
    rows: dict[tuple[str, str], list[Document]] = {}
    for fact in facts or ():
        equal = (str(plain(fact.get("value"))), str(fact.get("evidence")))
        rows.setdefault(equal, []).append(fact)
    shown = [
        {
            "fact": say("given.statements", statements=[plain(one.get("fact")) for one in group]),
            "value": plain(group[0].get("value")),
            **evidence_mark(group[0].get("evidence")),
        }
        for group in rows.values()
    ]
    return sorted(shown, key=lambda row: not row["open"])


def evidence_mark(evidence: object) -> dict[str, Any]:
    """Return an assumption's evidence as text. ``open``: the assumption is unconfirmed."""
    text = plain(evidence) if evidence else ""
    unconfirmed = "unconfirmed" in text.lower()
    if isinstance(text, ControlText) and text.startswith("unconfirmed"):
        text = plain(text.values["what"])
    elif text.lower().startswith("unconfirmed"):
        text = text[len("unconfirmed") :].lstrip(" :;,.-")
    return {"evidence": text, "open": unconfirmed}


def spread_text(quantiles: object, decimals: int = DEVIATION_DECIMALS) -> str | Sentence:
    """Return the 5-95 % range of a predicted parameter as text, or "" if it has none."""
    if not isinstance(quantiles, Mapping) or quantiles.get("p05") is None:
        return ""
    low, high = (number(quantiles.get(key), decimals) for key in ("p05", "p95"))
    return say("label.range", low=low, high=high)


def median_text(quantiles: object) -> str:
    """Return the median of a predicted parameter as text."""
    return number(quantiles.get("median")) if isinstance(quantiles, Mapping) else MISSING


def main_parameters(parameters: Document, limits: Document | None) -> list[str]:
    """Return the names of all parameters that have a limit; if none has one, only the first of A, P
    and E that has a value.
    """
    if limits:
        return [key for key in (*PARAMETERS, *limits) if key in limits][: len(limits)]
    return [key for key in ("A", "P", "E", *PARAMETERS) if parameters.get(key) is not None][:1]


def bar(
    before: object, quantiles: object, limit: object, value: object = None
) -> dict[str, Any] | None:
    """Return the lengths in a bar figure of a parameter: its value ``before``, its predicted 5-95 %
    range, the ``value`` after loading (None: the predicted median), and its limit. None if a value
    is negative, or none is above 0.
    """
    given = quantiles if isinstance(quantiles, Mapping) else {}
    low, high = given.get("p05"), given.get("p95")
    shown = value if value is not None else given.get("median")
    numbers = [
        float(item) for item in (before, low, high, limit, shown) if isinstance(item, int | float)
    ]
    largest = max(numbers, default=0.0)
    if largest <= 0.0 or min(numbers) < 0.0:
        return None

    def place(item: object) -> float | None:
        return (
            round(float(item) / largest * (_BAR_WIDTH - 4.0), 1)
            if isinstance(item, int | float)
            else None
        )

    left, right = place(low), place(high)
    return {
        "before": place(before),
        "low": left,
        "width": None if left is None or right is None else round(max(right - left, 1.0), 1),
        "value": place(shown),
        "limit": place(limit),
        "label": say("chart.bar", before=number(before), now=number(shown), limit=number(limit)),
    }


def parameter_block(
    unit: object, standard: object, not_applicable: Document | None, columns: Sequence[Document]
) -> dict[str, Any]:
    """Return a table of parameters, with a column for each source, such as before and predicted.

    Each of ``columns`` has ``title`` and either ``values`` (parameter -> number) or ``quantiles``
    (parameter -> median, p05, p95). It may also have ``uncertainty`` (parameter -> U) and ``notes``
    (parameter -> word).
    """
    named = {
        key for column in columns for key in column.get("values") or column.get("quantiles") or {}
    }
    keys = [key for key in (*PARAMETERS, *sorted(named - set(PARAMETERS))) if key in named]
    shown = [
        key
        for key in keys
        if any(_value(column, key) != MISSING for column in columns if "notes" not in column)
    ]
    reasons: dict[str, list[str]] = {}
    for key, reason in (not_applicable or {}).items():
        reasons.setdefault(plain(reason), []).append(edition_symbol(key, standard))
    return {
        "standard": standard_text(standard),
        "columns": [
            {
                "title": column["title"],
                "spread": _has_spread(column),
                "note": _column_note(column, unit_text(unit)),
            }
            for column in columns
        ],
        "rows": [
            {
                "symbol": edition_symbol(key, standard),
                "words": parameter_term(key, standard),
                "cells": [
                    {"value": _value(column, key), "spread": _spread(column, key)}
                    for column in columns
                ],
            }
            for key in shown
        ],
        "reasons": [(reason, ", ".join(symbols)) for reason, symbols in reasons.items()],
    }


def _has_spread(column: Document) -> bool:
    return "quantiles" in column or bool(column.get("uncertainty"))


def _column_note(column: Document, unit: str) -> str | Sentence:
    if "notes" in column:
        return say("label.of_the_prediction")
    if "quantiles" in column:
        return say("label.with_range", unit=unit)
    if column.get("uncertainty"):
        factor = next(iter(column["uncertainty"].values())).get("coverage", 2)
        return say("label.with_uncertainty", unit=unit, k=plain(factor))
    return unit


def _value(column: Document, key: str) -> str | Sentence:
    if "notes" in column:
        note: str | Sentence = column["notes"].get(key, "")
        return note
    if "quantiles" in column:
        return median_text((column["quantiles"] or {}).get(key))
    return number((column.get("values") or {}).get(key))


def _spread(column: Document, key: str) -> str | Sentence | None:
    if "quantiles" in column:
        return spread_text((column["quantiles"] or {}).get(key))
    if not column.get("uncertainty"):
        return None
    entry = column["uncertainty"].get(key)
    return say("label.plus_minus", U=number(entry["U"])) if entry else ""


def result_block(result: Document, label: str | Sentence = "") -> dict[str, Any]:
    """Return the section of a positioning test: a sentence on its conditions, the uncertainty,
    statistics, and readings. ``label``: a word for its title, such as "before".
    """
    unit = unit_text(result.get("unit"))
    where = unit_text(result.get("position_unit") or position_unit(result.get("unit")))
    runs = result.get("n_runs") or {}
    counts = [
        say("label.traverses", count=runs[key], sign=sign)
        for key, sign in (("positive", "+"), ("negative", "−"))
        if runs.get(key)
    ]
    extremes = [
        say("label.extreme_at", symbol=symbol(key), place=plain(value), unit=where)
        for key, value in (result.get("at") or {}).items()
        if value is not None
    ]
    sentence = say(
        "label.test_sentence",
        standard=standard_text(result.get("standard", "")),
        cycle=plain(result.get("cycle", "standard")),
        targets=len(result.get("targets", [])),
        counts=counts,
        coverage=plain(result.get("coverage") or 2),
        extremes=extremes,
        uncertainty=bool(result.get("uncertainty")),
    )
    return {
        "title": say(
            "label.test_title",
            axis=plain(result.get("axis")),
            name=plain(result.get("name") or ""),
            label=label,
        ),
        "sentence": sentence,
        "count": len(result.get("targets", [])),
        "uncertainty": _uncertainty(result, unit),
        "statistics": _statistics(result, unit, where),
        "readings": _readings(result, unit, where),
        "reduced": _readings(result, unit, where, reduced=True),
        "at_20": bool(result.get("thermal")),
    }


def _uncertainty(result: Document, unit: str) -> TextTable | None:
    entries = result.get("uncertainty")
    if not entries:
        return None
    values = result.get("parameters") or {}
    return {
        "heads": heads(
            say("head.parameter"),
            (say("head.value"), unit),
            (say("head.expanded_uncertainty"), unit),
            (say("head.coverage_factor"), ""),
        ),
        "rows": [
            [
                symbol(key),
                number(values.get(key)),
                number(entry.get("U")),
                plain(entry.get("coverage", 2)),
            ]
            for key, entry in entries.items()
        ],
    }


def _statistics(result: Document, unit: str, where: str) -> TextTable:
    columns: list[tuple[str, str | Sentence]] = [
        ("mean_positive", say("head.mean", sign="+")),
        ("mean_negative", say("head.mean", sign="−")), ("s_positive", "s +"),
        ("s_negative", "s −"), ("reversal", "B"),
        ("mean", say("head.mean", sign="±")),
        ("R_positive", "R +"), ("R_negative", "R −"), ("R", "R"),
    ]  # fmt: skip
    targets = result.get("targets", [])
    digits = decimals_of(target.get("position") for target in targets)
    return {
        "heads": heads((say("head.position"), where), *((title, unit) for _, title in columns)),
        "rows": [
            [
                number(target.get("position"), digits),
                *(number(target.get(key)) for key, _ in columns),
            ]
            for target in targets
        ],
    }


def _readings(result: Document, unit: str, where: str, *, reduced: bool = False) -> list[TextTable]:
    """Return tables of a test's readings with all digits: as measured, or with ``reduced`` after
    removal of the thermal expansion to 20 °C.
    """
    targets = result.get("targets", [])
    if reduced and not any(
        {"expansion_removed", "removed_positive"} & set(target) for target in targets
    ):
        return []
    columns: list[tuple[str, list[float | None]]] = []
    for key, sign in (("positive", "+"), ("negative", "−")):
        width = max((len(target.get(f"deviations_{key}") or []) for target in targets), default=0)
        columns += [
            (
                f"{sign}{run + 1}",
                [_reading(target, key, run, reduced=reduced) for target in targets],
            )
            for run in range(width)
        ]
    most = decimals_of((value for _, column in columns for value in column), most=9)
    runs = [(name, [number(value, most) for value in column]) for name, column in columns]
    digits = decimals_of(target.get("position") for target in targets)
    positions = [number(target.get("position"), digits) for target in targets]
    widest = max((len(value) for _, column in runs for value in column), default=0)
    count = -(-len(runs) // min(_COLUMNS, _LINE // (widest + 3)))
    each = -(-len(runs) // count) if count else 1
    return [
        {
            "heads": heads(
                (say("head.position"), where),
                *((name, unit) for name, _ in runs[first : first + each]),
            ),
            "rows": [
                [position, *(column[row] for _, column in runs[first : first + each])]
                for row, position in enumerate(positions)
            ],
        }
        for first in range(0, len(runs), each)
    ]


def _reading(target: Document, key: str, run: int, *, reduced: bool) -> float | None:
    readings = target.get(f"deviations_{key}") or []
    value = readings[run] if run < len(readings) else None
    if value is None or reduced:
        return value
    each = target.get(f"removed_{key}")
    removed = each[run] if each else target.get("expansion_removed")
    return round(float(value) + float(removed or 0.0), 9)


def sources(*evaluations: Document | None) -> list[dict[str, str]]:
    """Return the files that were read, each once, with their SHA-256."""
    seen: dict[tuple[str, str], dict[str, str]] = {}
    for evaluation in evaluations:
        for result in (evaluation or {}).get("results", []):
            for source in result.get("sources") or []:
                entry = {"file": plain(source.get("file")), "sha256": plain(source.get("sha256"))}
                seen.setdefault((entry["file"], entry["sha256"]), entry)
    return list(seen.values())


def unreadable(*evaluations: Document | None) -> list[dict[str, str]]:
    """Return the unreadable files of evaluations as findings with severity error."""
    return [
        {
            "code": "not read",
            "severity": "error",
            "message": f"{plain(error.get('file'))}: {plain(error.get('message'))}",
        }
        for evaluation in evaluations
        for error in (evaluation or {}).get("errors") or []
    ]


def result_of(evaluation: Document | None, axis: str, name: str | None = None) -> Document | None:
    """Return the result of a positioning test of an axis: that of the test ``name`` if there is
    one, else of another test.
    """
    found = [
        result
        for result in (evaluation or {}).get("results", [])
        if result.get("kind", "positioning") == "positioning" and str(result.get("axis")) == axis
    ]
    named = [result for result in found if name is not None and result.get("name") == name]
    return next(iter(named or found), None)
