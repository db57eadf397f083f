"""The page of one circular test in a report: picture, parameters, causes and conditions. Computes
nothing.
"""

from __future__ import annotations

from typing import Any, Final

from compwright.reporting import paper, sections
from compwright.reporting.causes import CircleCause, full_cause_words, ranked_causes
from compwright.reporting.circle_steps import next_step
from compwright.reporting.circles import circle_figure
from compwright.reporting.numbers import number, plain
from compwright.reporting.sections import Document, TextTable

#: The largest causes, for which the page says what to do.
_STEPS: Final = 3


def circle_page(result: Document, index: int) -> dict[str, Any]:
    """Return the page of a circular result, the ``index``-th test of its report."""
    name = plain(result.get("name") or "")
    return {
        "figure": circle_figure(result, f"test{index}", name),
        "parameters": {
            "heads": sections.heads("Parameter", ("Value", "µm")),
            "rows": [
                [key.replace("_", " "), number(value)]
                for key, value in (result.get("parameters") or {}).items()
                if value is not None
            ],
        },
        "causes": _causes(result),
        "reasons": [
            (_words(plain(key), result), plain(reason))
            for key, reason in (result.get("not_applicable") or {}).items()
        ],
        "sheet": paper.sheet(result, {}),
    }


def _words(name: str, result: Document) -> str:
    """Return a cause in words; a parameter by its name."""
    if name in (result.get("parameters") or {}):
        return name.replace("_", " ")
    return full_cause_words(name, result.get("axes") or ("first", "second"))


def _causes(result: Document) -> TextTable:
    """Return the causes with their ends, the largest effect first; what the instrument's software
    printed, in brackets where it says itself that it is not valid; what to do about the largest, as
    far as they are significant.
    """
    causes = ranked_causes(result)
    printed = any(one.printed is not None for cause in causes for one in (cause, *cause.parts))
    rows = []
    for rank, cause in enumerate(causes):
        step = ""
        if rank < _STEPS and cause.significant and cause.shown:
            step = next_step(cause.name, result.get("axes") or ("first", "second"))
        share = f"{100.0 * cause.share:.0f}"
        rows.append([*_values(cause, printed=printed), number(cause.effect), share, step])
        rows += [[*_values(part, printed=printed), "", "", ""] for part in cause.parts]
    return {
        "heads": sections.heads(
            "Cause",
            ("Value ± standard error", ""),
            *([("Software of the instrument", "")] if printed else []),
            "Unit",
            ("Effect on the radius", "µm"),
            ("Share", "%"),
            "Next step",
        ),
        "rows": rows,
    }


def _values(cause: CircleCause, *, printed: bool) -> list[str]:
    theirs = cause.text(cause.printed)
    software = [f"({theirs})" if theirs and cause.doubtful else theirs] if printed else []
    return [cause.words, cause.value_text, *software, cause.unit_text]
