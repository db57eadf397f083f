"""The report of ``verify``: one self-contained HTML page made from documents.

Its view is that of `run_report`, but with the documents ``verification``, ``evaluation_before`` and
``evaluation_after`` instead of ``evaluation`` and ``prediction``.
"""

from __future__ import annotations

from typing import Any

from compwright.reporting import paper, sections
from compwright.reporting.axis_figures import before_after_figure
from compwright.reporting.chart_svg import Drawing
from compwright.reporting.circles import circle_blocks, limit_rows
from compwright.reporting.numbers import number, plain, symbol, unit_text
from compwright.reporting.page import render_page
from compwright.reporting.page_parts import anchor, common, conditions, paper_content, remaining
from compwright.reporting.sections import Document, TextTable
from compwright.words.sentences import Sentence, say

#: Of the conditions of a test after loading.
AFTER_LOADING = say("given.compensation_loaded")


def verify_report(view: Document) -> bytes:
    """Return the report of ``verify`` as HTML: first the verdict, then a section for each axis with
    its values before, predicted and after loading. ``view``: see the module.

    Raises UsageError if the extra ``report`` is not installed.
    """
    verification = view.get("verification") or {}
    axes = {str(name): axis for name, axis in (verification.get("axes") or {}).items()}
    circles = verification.get("circles") or {}
    tone = {"good": "good", "bad": "bad"}.get(str(verification.get("verdict")), "open")
    text = plain(verification.get("headline") or "")
    rows = [
        row
        for index, (name, axis) in enumerate(axes.items(), 1)
        for row in _verify_rows(index, name, axis, _verify_unit(name, view))
    ] + limit_rows(circles)
    blocks = [
        _verify_axis(index, name, axis, view) for index, (name, axis) in enumerate(axes.items(), 1)
    ]
    evaluations = (view.get("evaluation_before"), view.get("evaluation_after"))
    stated = (view.get("stated") or {}).get("circles") or {}
    circled = circle_blocks(
        circles,
        *evaluations,
        stated={name: {**of_job, "compensation": AFTER_LOADING} for name, of_job in stated.items()},
    )
    return render_page(
        "verify.html",
        {
            **common(
                view, list(zip((say("label.before"), say("label.after")), evaluations, strict=True))
            ),
            **paper_content(view, (view.get("evaluation_after") or {}).get("results") or ()),
            "statement": paper.conformity(
                [
                    str(entry.get("decision"))
                    for one in (*axes.values(), *circles.values())
                    for entry in (one.get("accept") or {}).values()
                ],
                proven=tone == "good",
            ),
            "rules": list(
                dict.fromkeys(line for block in (*blocks, *circled) for line in block["rule"])
            ),
            "doubts": sections.doubts(verification.get("doubts")),
            "acknowledged": sections.acknowledged(verification.get("acknowledged")),
            "verdict": {"tone": tone, "text": text, "rows": rows},
            "next": _next_round(verification.get("next")),
            "axes": blocks,
            "conditions": conditions(blocks),
            "circles": circled,
            "findings": remaining(view, blocks, *evaluations),
        },
        view.get("language", "en"),
    )


def _next_round(then: Document | None) -> dict[str, Any] | None:
    """Return the section on the next round, or None if no next round was requested."""
    if then is None:
        return None
    marks = {
        True: ("good", say("verify.further_table")),
        False: ("open", say("verify.no_further_table")),
    }
    return {
        "heading": say("verify.next_round", written=bool(then["written"])),
        "reason": plain(then["reason"]),
        "axes": [
            {
                "name": name,
                "mark": dict(zip(("tone", "text"), marks[axis["table"]], strict=True)),
                "reason": plain(axis["reason"]),
            }
            for name, axis in then["axes"].items()
        ],
        "between": [plain(line) for line in then["between"]],
    }


def _verify_rows(index: int, name: str, axis: Document, unit: str) -> list[dict[str, Any]]:
    before, after, quantiles = (
        axis.get("before") or {},
        axis.get("after") or {},
        axis.get("predicted") or {},
    )
    limits = axis.get("accept") or {}
    return [
        {
            "axis": name,
            "anchor": anchor(index),
            "loading": sections.loading_mark(
                (axis.get("loading") or {}).get("verdict", "undecided")
            ),
            "symbol": symbol(key),
            "before": number(before.get(key)),
            "unit": unit_text(unit),
            "median": sections.median_text(quantiles.get(key)),
            "spread": sections.spread_text(quantiles.get(key)),
            "after": number(after.get(key)),
            "limit": number((limits.get(key) or {}).get("limit")),
            "mark": sections.decision_mark((limits.get(key) or {}).get("decision")),
            "bar": sections.bar(
                before.get(key),
                quantiles.get(key),
                (limits.get(key) or {}).get("limit"),
                after.get(key),
            ),
        }
        for key in sections.main_parameters({**before, **after}, limits)
    ]


def _verify_unit(name: str, view: Document) -> str:
    extra = (view.get("axes") or {}).get(name) or {}
    result = (
        sections.result_of(view.get("evaluation_after"), name)
        or sections.result_of(view.get("evaluation_before"), name)
        or {}
    )
    return str(extra.get("unit") or result.get("unit", "um"))


def _verify_axis(index: int, name: str, axis: Document, view: Document) -> dict[str, Any]:
    extra = (view.get("axes") or {}).get(name) or {}
    before = sections.result_of(view.get("evaluation_before"), name)
    after = sections.result_of(view.get("evaluation_after"), name)
    unit = _verify_unit(name, view)
    measured = after or before or {}
    columns = [
        {
            "title": say("head.before"),
            "values": axis.get("before"),
            "uncertainty": (before or {}).get("uncertainty"),
        },
        {"title": say("head.predicted"), "quantiles": axis.get("predicted")},
        {
            "title": say("head.after"),
            "values": axis.get("after"),
            "uncertainty": (after or {}).get("uncertainty"),
        },
    ]
    within = {True: say("verify.within"), False: say("verify.outside")}
    notes = {
        key: within.get(value, "") for key, value in (axis.get("within_prediction") or {}).items()
    }
    if any(notes.values()):
        widened = " ± U" if axis.get("predicted_U") else ""
        columns.append({"title": f"5–95 %{widened}", "notes": notes})
    return {
        "name": name,
        "anchor": anchor(index),
        "loading": _loading(axis.get("loading") or {}),
        "both": _after_figure(name, before, after, extra, axis),
        "measured": paper.measured_block(measured, _stated(name, measured, view))
        if measured
        else None,
        "parameters": sections.parameter_block(
            unit, measured.get("standard", ""), measured.get("not_applicable"), columns
        ),
        "accept": _acceptance(axis.get("accept") or {}, unit),
        "rule": sections.rule_lines(axis.get("accept") or {}, unit_text(unit), after=True),
        "findings": sections.findings(
            extra.get("findings"), axis.get("findings"), (after or {}).get("findings")
        ),
    }


def _stated(name: str, after: Document, view: Document) -> Document:
    """Return what the job states about the conditions of a test after loading, by item."""
    of_axis = ((view.get("stated") or {}).get("axes") or {}).get(name) or {}
    first: Document = of_axis.get(str(after.get("name"))) or next(iter(of_axis.values()), {})
    return {**first, "compensation": AFTER_LOADING} if first else {}


def _after_figure(
    name: str,
    before: Document | None,
    after: Document | None,
    extra: Document,
    axis: Document,
) -> Drawing | None:
    if before is None:
        return None
    expected = extra.get("predicted_targets")
    with_numbers = {**expected, "parameters": axis.get("predicted")} if expected else None
    return before_after_figure(before, with_numbers, name, after)


def _loading(loading: Document) -> dict[str, Any]:
    verdict = loading.get("verdict", "undecided")
    facts: list[tuple[Sentence, str | Sentence]] = [
        (say("verify.equivalent"), say("loading.name", name=name, detail=None))
        for name in loading.get("equivalent", ())
    ]
    for name, key, words in (
        ("scaled", "factor", say("verify.factor")),
        ("shifted", "shift_nodes", say("verify.shift")),
        ("wrong_axis", "of", say("verify.table_of")),
    ):
        if verdict == name and loading.get(key) not in (None, ""):
            facts.append((words, plain(loading[key])))
    return {
        "mark": sections.loading_mark(verdict),
        "message": plain(loading.get("message") or ""),
        "look_at": [plain(sentence) for sentence in loading.get("look_at") or ()],
        "facts": facts,
    }


def _acceptance(limits: Document, unit: object) -> TextTable | None:
    if all(entry.get("U") is None for entry in limits.values()):
        return None  # the verdict above says it all
    word = unit_text(unit)
    rows = [
        [
            symbol(key),
            *(number(entry.get(part)) for part in ("value", "U", "limit")),
            sections.decision_mark(entry.get("decision"))["text"],
        ]
        for key, entry in limits.items()
    ]
    return {
        "heads": sections.heads(
            say("head.limit_on"),
            (say("head.after"), word),
            ("U", word),
            (say("head.limit"), word),
            say("head.decision"),
        ),
        "rows": rows,
    }
