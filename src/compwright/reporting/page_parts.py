"""Common parts of the report pages: the head, the tests, and the findings that concern no axis."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from compwright.reporting import paper, sections
from compwright.reporting.numbers import number, plain
from compwright.reporting.sections import Document
from compwright.words.sentences import Sentence, say


def common(
    view: Document, evaluations: Sequence[tuple[str | Sentence, Document | None]]
) -> dict[str, Any]:
    """Return the contents that every page has: title, machine, control, and the tests. ``view``:
    the documents and facts that the page shows.

    ``evaluations``: the evaluation documents of the tests, each with a label such as "before".
    """
    title = view.get("title") or "compwright"
    title = title if isinstance(title, Sentence) else plain(title)
    results = [
        (label, result)
        for label, evaluation in evaluations
        for result in (evaluation or {}).get("results", [])
    ]
    return {
        "page_title": title,
        "title": title,
        "machine": [
            (say("label.machine", key=key), text)
            for key, text in sections.pairs(view.get("machine"))
        ],
        "format": {
            "id": plain((view.get("format") or {}).get("id", "")),
            "title": plain((view.get("format") or {}).get("title", "")),
        },
        "tests": [
            sections.result_block(result, label)
            for label, result in results
            if result.get("kind", "positioning") == "positioning"
        ],
        "sources": sections.sources(*(evaluation for _, evaluation in evaluations)),
        "version": plain(view.get("version", "")),
    }


def paper_content(view: Document, results: Sequence[Document]) -> dict[str, Any]:
    """Return the contents of a formal report on the tests ``results``: head, text on accreditation,
    and command line. ``view``: the documents and facts that the page shows.

    The text on accreditation is that of a firm which is not accredited.
    """
    return {
        "head": paper.head(view.get("report") or {}, results),
        "accreditation": paper.ACCREDITATION,
        "command": plain(view.get("command") or ""),
    }


def conditions(blocks: Iterable[Document]) -> list[dict[str, Any]]:
    """Return the conditions of the tests of all axes, in one table for each standard."""
    return paper.sheets_together(
        (f"{block['name']}, {part['name']}" if part is not block else block["name"], sheet)
        for block in blocks
        for part in (block, *block.get("others", ()))
        for sheet in ([part["measured"]["sheet"]] if part["measured"] else [])
    )


def remaining(
    view: Document, blocks: Iterable[Document], *evaluations: Document | None
) -> list[dict[str, Any]]:
    """Return the findings in ``view`` (what the page shows) that no section (``blocks``) of the
    page contains, and a finding for each unreadable file.
    """
    shown = {(item["code"], item["message"]) for block in blocks for item in block["findings"]}
    every = sections.findings(sections.unreadable(*evaluations), view.get("findings"))
    return [item for item in every if (item["code"], item["message"]) not in shown]


def anchor(index: int) -> str:
    """Return the link target of an axis' section on the page."""
    return f"axis-{index}"


def with_unit(value: object, unit: str) -> str | Sentence:
    """Return a number with its unit, or only a dash for a missing number."""
    text = number(value)
    return say("label.with_unit", value=text, unit=unit) if value is not None else text
