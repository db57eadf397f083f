"""The report of ``run``: one self-contained HTML page made from documents.

Its view has these keys:

- ``title``, ``machine`` (name -> text), ``format`` (``id``, ``title``), ``version``, ``files``
  (relative names).
- ``evaluation`` and ``prediction``: the documents.
- ``assumed``, ``findings``. ``no_tables``: the reason why there are no tables, or None.
- ``stated``: what the job states about its tests: ``axes`` by name and test, ``circles`` by name.
- ``axes`` by name, each with ``address``, ``kind``, ``unit``, ``estimate``, ``wanted``, ``mode``,
  ``mode_reason``, ``certificate``, ``state``, ``predicted_targets`` and ``findings``.
- the keys of `page_parts.paper_content`.

Deviations are in µm or arcsec as ``unit`` states, positions in mm or deg.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from compwright.foundations.findings import DOUBTS
from compwright.foundations.parallel_work import Each, in_turn
from compwright.reporting import paper, sections
from compwright.reporting.axis_report import axis_block
from compwright.reporting.card import changes_content
from compwright.reporting.circles import circle_blocks, limit_rows, rules
from compwright.reporting.numbers import (
    number,
    plain,
    position_unit,
    standard_text,
    symbol,
    unit_text,
)
from compwright.reporting.page import render_page
from compwright.reporting.page_parts import (
    anchor,
    common,
    conditions,
    paper_content,
    remaining,
    with_unit,
)
from compwright.reporting.sections import Document, TextTable
from compwright.words.sentences import Sentence, say


def run_report(view: Document, each: Each = in_turn) -> bytes:
    """Return the report of ``run`` as HTML: first the verdict, then a section for each axis, the
    assumptions, the findings, the raw readings, and the files. ``view``: see the module.

    ``each``: applies a function to all axes, possibly in parallel. Raises UsageError if the extra
    ``report`` is not installed.
    """
    prediction = view.get("prediction") or {}
    axes = {str(name): axis for name, axis in (view.get("axes") or {}).items()}
    predicted = {str(name): axis for name, axis in (prediction.get("axes") or {}).items()}
    tasks = [
        (index, name, axis, predicted.get(name) or {}, _of_axis(name, view))
        for index, (name, axis) in enumerate(axes.items(), 1)
    ]
    blocks = each(axis_block, tasks)
    return render_page(
        "run.html",
        {
            **common(view, [("", view.get("evaluation"))]),
            **paper_content(view, (view.get("evaluation") or {}).get("results") or ()),
            "doubts": sections.doubts(prediction.get("doubts")),
            "acknowledged": sections.acknowledged(prediction.get("acknowledged")),
            "done": _what_was_done(view, axes),
            "verdict": _run_verdict(view, axes, predicted, prediction.get("circles") or {}),
            "axes": blocks,
            "conditions": conditions(blocks),
            "findings": remaining(view, blocks, view.get("evaluation")),
            "circles": circle_blocks(
                prediction.get("circles") or {},
                view.get("evaluation"),
                stated=(view.get("stated") or {}).get("circles"),
            ),
            "cross": [_cross(entry) for entry in prediction.get("cross") or []],
            "changes": changes_content(view.get("changes")),
            "assumed": sections.assumed(view.get("assumed")),
            "files": [str(file) for file in view.get("files") or []],
            "card": next(
                (
                    str(file)
                    for file in view.get("files") or []
                    if "card" in str(file) and str(file).endswith(".html")
                ),
                None,
            ),
        },
        view.get("language", "en"),
    )


def _what_was_done(view: Document, axes: Document) -> Sentence:
    results = (view.get("evaluation") or {}).get("results", [])
    names = list(axes) or sorted({axis for result in results for axis in result.get("axes") or ()})
    return say(
        "run.done",
        tests=len(results),
        count=len(names),
        axes=_listed(names),
        standards=sorted({standard_text(result.get("standard", "")) for result in results}),
        control=plain((view.get("format") or {}).get("title", "")),
        tables=not view.get("no_tables"),
    )


def _listed(names: Iterable[object]) -> Sentence:
    *others, last = tuple(map(str, names)) or ("",)
    return say("given.list", others=others, last=last)


def _run_verdict(
    view: Document, axes: Document, predicted: Document, circles: Document
) -> dict[str, Any]:
    rows = [
        row
        for index, name in enumerate(axes, 1)
        for row in _run_rows(index, name, axes[name], predicted.get(name) or {}, view)
    ] + limit_rows(circles)
    decisions = [
        entry.get("decision")
        for one in (*(predicted.get(name) or {} for name in axes), *circles.values())
        for entry in (one.get("accept") or {}).values()
    ]
    refused = {name: plain(axis["refused"]) for name, axis in axes.items() if axis.get("refused")}
    first = {doubt["code"] for doubt in (view.get("prediction") or {}).get("doubts") or ()}
    why: str | Sentence = ""
    if view.get("no_tables"):
        tone, text, why = "bad", say("run.no_table"), plain(view["no_tables"])
    elif refused:
        tone, text = "bad", say("run.no_table_for", axes=_listed(refused))
        reasons = [
            say("run.refusal", axis=name, reason=reason.rstrip("."))
            for name, reason in refused.items()
        ]
        why = say("given.sentences", sentences=reasons)
    elif first & DOUBTS:
        tone, text = "open", say("run.check_first")
    elif "reject" in decisions:
        tone, text = "bad", say("run.limit_missed")
    elif "undecided" in decisions:
        tone, text = "open", say("run.limit_open")
    elif "CW-P131" in first:
        tone, text = "open", say("run.circle_worse")
    elif decisions and first:
        tone, text = "open", say("run.limits_met_if")
    elif decisions:
        tone, text = "good", say("run.limits_met")
    else:
        tone, text = "open", say("run.no_limits")
    return {
        "tone": tone,
        "text": text,
        "why": why,
        "rows": rows,
        "rule": _rule(predicted, circles),
    }


def _rule(predicted: Document, circles: Document) -> Sentence:
    """Return the decision rule with guard bands for all limits, or the sentence "no limits"."""
    limits = {name: axis.get("accept") or {} for name, axis in predicted.items()}
    lines = [
        line
        for name, accept in limits.items()
        for line in sections.rule_lines(accept, unit_text(predicted[name].get("unit", "um")))
    ]
    lines += [line for circle in circles.values() for line in rules(circle)]
    return (
        say("given.sentences", sentences=list(dict.fromkeys(lines))) if lines else paper.NO_LIMITS
    )


def _run_rows(
    index: int, name: str, axis: Document, predicted: Document, view: Document
) -> list[dict[str, Any]]:
    limits = predicted.get("accept") or {}
    before, quantiles = _decided_test(name, predicted, view)
    unit = unit_text(axis.get("unit"))
    return [
        {
            "axis": name,
            "anchor": anchor(index),
            "symbol": symbol(key),
            "before": with_unit(before.get(key), unit),
            "median": with_unit((quantiles.get(key) or {}).get("median"), unit),
            "spread": sections.spread_text(quantiles.get(key)),
            "limit": with_unit((limits.get(key) or {}).get("limit"), unit),
            "mark": sections.decision_mark((limits.get(key) or {}).get("decision")),
            "bar": sections.bar(
                before.get(key), quantiles.get(key), (limits.get(key) or {}).get("limit")
            ),
        }
        for key in sections.main_parameters({**quantiles, **before}, limits)
    ]


def _decided_test(name: str, predicted: Document, view: Document) -> tuple[Document, Document]:
    """Return the measured and the predicted parameters of the test to which the limits apply.

    The key ``test`` of a limit names the test.
    """
    about = next(
        (limit["test"] for limit in (predicted.get("accept") or {}).values() if limit.get("test")),
        None,
    )
    test = next(
        (
            test
            for test in predicted.get("tests") or []
            if about is not None and test.get("name") == about
        ),
        predicted,
    )
    result = sections.result_of(view.get("evaluation"), name, about) or {}
    return test.get("before") or result.get("parameters") or {}, test.get("predicted") or {}


def _of_axis(name: str, view: Document) -> Document:
    """Return the report's data for one axis: its evaluated tests, and what the job states about
    them.
    """
    results = (view.get("evaluation") or {}).get("results", [])
    stated = ((view.get("stated") or {}).get("axes") or {}).get(name) or {}
    return {
        "evaluation": {"results": [one for one in results if str(one.get("axis")) == name]},
        "stated": stated,
    }


def _cross(entry: Document) -> TextTable:
    unit = entry.get("unit", "um")
    rows = [
        [plain(where), number(value)]
        for where, value in zip(entry["positions"], entry["correction"], strict=True)
    ]
    heads = sections.heads(
        (say("head.position"), position_unit(unit)),
        (say("head.correction", sign=""), unit_text(unit)),
    )
    return {
        "title": say(
            "run.bends", input=plain(entry.get("input")), output=plain(entry.get("output"))
        ),
        "heads": heads,
        "rows": rows,
    }
