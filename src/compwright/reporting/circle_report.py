"""The page of one circular test in a report: picture, residual, parameters, causes next to what the
instrument's software printed, what to do next, conditions. Computes nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from compwright.reporting import paper, sections
from compwright.reporting.axis_figures import residual_figure
from compwright.reporting.causes import CircleCause, full_cause_words, ranked_causes
from compwright.reporting.circle_steps import job_lines, steps_for
from compwright.reporting.circles import circle_figure
from compwright.reporting.circular_parameters import (
    parameter_rows,
    parameter_words,
    printed_parameters,
)
from compwright.reporting.numbers import number, plain
from compwright.reporting.sections import Document, TextTable

#: Standard errors within which our value and the printed one agree.
_AGREES: Final = 2.0
_COMPARISON: Final = (
    "Software of the instrument: agrees: within two standard errors of our value. Not valid, in"
    " brackets: the software itself says so. Differs: its model is not published; ours fits every"
    " cause at once, with step and spike of each reversal point of their own."
)


def circle_page(result: Document, index: int) -> dict[str, Any]:
    """Return the page of a circular result, the ``index``-th test of its report."""
    name = plain(result.get("name") or "")
    causes = ranked_causes(result)
    acting = [cause for cause in causes if cause.significant and cause.shown]
    axes = result.get("axes") or ("first", "second")
    residual = residual_figure(result, f"residual of circular test {name}")
    return {
        "figure": circle_figure(result, f"test{index}", name),
        "residual": residual,
        "residual_words": (
            f"What the causes below leave unexplained: {number(result.get('residual'))} µm rms."
        ),
        "parameters": _parameters(result),
        "causes": _causes(causes) if causes else None,
        "comparison": _COMPARISON if _any_printed(causes) else "",
        "steps": steps_for(causes, axes),
        "job": job_lines([cause.name for cause in acting], result),
        "reasons": _reasons(result),
        "sheet": paper.sheet(result, {}),
    }


def _parameters(result: Document) -> TextTable:
    """Return the parameters of both directions, with U where it is stated and what the software of
    the instrument printed.
    """
    values, printed = result.get("parameters") or {}, printed_parameters(result)
    stated = result.get("uncertainty") or {}
    rows = []
    for row in parameter_rows(result):
        cells = [
            f"{number(values.get(key))} ± {number(stated[key]['U'])}"
            if key in stated
            else number(values.get(key))
            if key
            else ""
            for key in row.keys
        ]
        software = [printed.get(row.letter, "")] if printed else []
        rows.append([row.words.strip(), row.letter, *cells, *software])
    unit = "µm, ± U, k = 2" if stated else "µm"
    return {
        "heads": sections.heads(
            "Parameter",
            "",
            *((way, unit) for way in ("ccw", "cw", "both")),
            *([("Software of the instrument", "µm")] if printed else []),
        ),
        "rows": rows,
    }


def _reasons(result: Document) -> list[tuple[str, str]]:
    """Return why values are missing: names in words, and their reason."""
    reasons: dict[str, list[str]] = {}
    for key, reason in (result.get("not_applicable") or {}).items():
        words = "Causes" if key == "diagnosis" else _words(plain(key), result)
        reasons.setdefault(plain(reason).rstrip("."), []).append(words)
    return [(", ".join(dict.fromkeys(names)), reason) for reason, names in reasons.items()]


def _words(name: str, result: Document) -> str:
    """Return a cause or a parameter in words."""
    if name in (result.get("parameters") or {}):
        return parameter_words(name)
    return full_cause_words(name, result.get("axes") or ("first", "second"))


def _causes(causes: Sequence[CircleCause]) -> TextTable:
    """Return the causes with their ends, the largest effect first; next to them what the
    instrument's software printed, in brackets where it says itself that it is not valid, and how
    the two compare.
    """
    printed = _any_printed(causes)
    rows = []
    for cause in causes:
        share = f"{100.0 * cause.share:.0f}"
        rows.append([cause.words, number(cause.effect), share, *_values(cause, printed=printed)])
        rows += [
            [f"– {part.words}", "", "", *_values(part, printed=printed)] for part in cause.parts
        ]
    software: list[tuple[str, str] | str] = (
        [("Software of the instrument", ""), "Comparison"] if printed else []
    )
    return {
        "heads": sections.heads(
            "Cause",
            ("Effect on the radius", "µm"),
            ("Share", "%"),
            ("Value ± standard error", ""),
            "Unit",
            *software,
        ),
        "rows": rows,
    }


def _any_printed(causes: Sequence[CircleCause]) -> bool:
    return any(one.printed is not None for cause in causes for one in (cause, *cause.parts))


def _values(cause: CircleCause, *, printed: bool) -> list[str]:
    theirs = cause.text(cause.printed)
    software = [f"({theirs})" if theirs and cause.doubtful else theirs, _comparison(cause)]
    return [cause.value_text, cause.unit_text, *(software if printed else [])]


def _comparison(cause: CircleCause) -> str:
    """Return how our value and the printed one compare: a word of `_COMPARISON`."""
    if cause.printed is None:
        return ""
    if cause.doubtful:
        return "not valid"
    return "agrees" if abs(cause.value - cause.printed) <= _AGREES * cause.error else "differs"
