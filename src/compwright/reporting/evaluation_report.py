"""The report of ``evaluate``: one self-contained HTML page on tests that belong to no job.

The function takes a view with these keys: ``evaluation`` (the document), ``report`` (see
`paper.head`), ``command`` (the command line that makes the report again), ``version`` and
``language`` (default: English).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any, Final

from compwright.foundations.findings import DOUBTS
from compwright.reporting import paper, sections
from compwright.reporting.causes import findings_in_words
from compwright.reporting.circle_report import circle_page, machine_block
from compwright.reporting.circular_parameters import parameter_words
from compwright.reporting.numbers import number, plain, standard_text, symbol, unit_text
from compwright.reporting.page import render_page
from compwright.reporting.page_parts import anchor, conditions, paper_content
from compwright.reporting.sections import Document
from compwright.words.sentences import Sentence, say

_POSITIONING: Final = (("A", "E", "M", "R", "B"), ("P", "Pa", "Ps_max", "U_max"))
_CIRCULAR: Final = ("G_ccw", "G_cw", "G_bidirectional", "H", "D")


def evaluation_report(view: Document) -> bytes:
    """Return the report as HTML: first the results and the statement of conformity, then a page for
    each test, the raw readings, and the source files. ``view``: see the module.

    Raises UsageError if the extra ``report`` is not installed.
    """
    evaluation = view["evaluation"]
    results = _names_apart(evaluation.get("results") or ())
    title = say("report.title", tests=len(results))
    positioning = [one for one in results if one.get("kind", "positioning") == "positioning"]
    machines = [
        (own, machine_block(machine, own))
        for machine in evaluation.get("machines") or ()
        if (own := [one for one in results if _of_machine(one, machine)])
    ]
    pages = []
    for index, one in enumerate(results, 1):
        job = next((block["job"] for own, block in machines if one in own), None)
        pages.append(_page(one, index, job))
    return render_page(
        "evaluation.html",
        {
            "page_title": title,
            "title": title,
            **paper_content(view, results),
            "doubts": sections.doubts(
                item
                for result in (*results, *(evaluation.get("machines") or ()))
                for item in result.get("findings") or ()
                if item.get("code") in DOUBTS and item.get("severity") != "info"
            ),
            "unread": sections.findings(sections.unreadable(evaluation)),
            "summaries": [_summary(one, index) for index, one in enumerate(results, 1)],
            "machines": [block for _, block in machines],
            "statement": paper.NO_LIMITS,
            "pages": pages,
            "conditions": conditions(pages),
            "readings": [sections.result_block(one) for one in positioning],
            "sources": sections.sources(evaluation),
            "version": plain(view.get("version", "")),
        },
        view.get("language", "en"),
    )


def _names_apart(results: Sequence[Document]) -> list[Document]:
    """Return the tests with names that all differ: a test whose name occurs twice is named by its
    file, and if necessary with a number.
    """
    files = [", ".join(plain(one["file"]) for one in each.get("sources") or ()) for each in results]
    numbered = [f"{file} ({number})" for number, file in enumerate(files, 1)]
    named = list(results)
    for names in (files, numbered):
        count = Counter(map(_name, named))
        named = [
            {**one, "name": name} if count[_name(one)] > 1 else one
            for one, name in zip(named, names, strict=True)
        ]
    return named


def _name(result: Document) -> Sentence:
    name = plain(result.get("name") or "")
    if result.get("kind") == "circular":
        return say("report.circle", plane=plain(result.get("plane")), name=name)
    return say("report.axis", axis=plain(result.get("axis")), name=name)


def _summary(result: Document, index: int) -> dict[str, Any]:
    values, uncertainty = result.get("parameters") or {}, result.get("uncertainty") or {}
    groups = (_CIRCULAR,) if result.get("kind") == "circular" else _POSITIONING
    keys = next((keys for keys in groups if any(key in values for key in keys)), groups[0])
    return {
        "name": _name(result),
        "anchor": anchor(index),
        "standard": standard_text(result.get("standard", "")),
        "unit": unit_text(result.get("unit")),
        "values": [
            {
                "symbol": symbol(key) if groups is _POSITIONING else parameter_words(key),
                "value": number(values[key]),
                "U": (
                    say("label.plus_minus", U=number(uncertainty[key]["U"]))
                    if key in uncertainty
                    else ""
                ),
            }
            for key in keys
            if values.get(key) is not None
        ],
    }


def _of_machine(result: Document, machine: Document) -> bool:
    stated = result.get("header") or {}
    return (
        result.get("kind") == "circular"
        and result.get("diagnosis") is not None
        and all(stated.get(key) == machine[key] for key in ("machine", "serial"))
    )


def _page(result: Document, index: int, job: list[str] | None) -> dict[str, Any]:
    shared = {
        "name": _name(result),
        "anchor": anchor(index),
        "findings": sections.findings(findings_in_words(result)),
    }
    if result.get("kind") == "circular":
        return {**shared, "circle": circle_page(result, index, job), "measured": None}
    return {
        **shared,
        "circle": None,
        "measured": paper.measured_block(result, {}),
        "parameters": parameters_alone(result),
    }


def parameters_alone(result: Document) -> dict[str, Any]:
    """Return the table of one test's parameters, with the uncertainty U where it is stated."""
    column = {
        "title": say("head.value"),
        "values": result.get("parameters"),
        "uncertainty": result.get("uncertainty"),
    }
    return sections.parameter_block(
        result.get("unit"), result.get("standard", ""), result.get("not_applicable"), [column]
    )
