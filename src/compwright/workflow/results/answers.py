"""The output of the commands as documents, terminal text and tables."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from compwright.documents.json_text import to_json
from compwright.foundations import storage
from compwright.foundations.session import Session

__all__ = ["show", "to_json", "write_document"]


def write_document(
    session: Session, document: Mapping[str, Any], path: Path, *, force: bool
) -> None:
    """Write a document to a file. Raises StorageError."""
    content = to_json(document).encode()
    from compwright.workflow.results.single_files import (
        refuse_other_kinds,
    )  # only now: `evaluate` of a positioning test loads no reader of circles

    refuse_other_kinds(session, {path: content}, force=force)
    storage.write_file(session, path, content, force=force)


def show(renderables: list[Any]) -> None:
    """Print texts and tables of the ``rich`` library on standard output."""
    from compwright.reporting.safe_text import print_renderables

    print_renderables(renderables)


def run_summary(outcome: Any) -> list[Any]:
    """Return the terminal output of ``run``: assumptions, then each axis, then the files."""
    from compwright.reporting import summaries

    doubts = outcome.prediction["doubts"]
    listed = [
        *doubts,
        *outcome.prediction["acknowledged"],
        *(finding for axis in outcome.prediction["axes"].values() for finding in axis["findings"]),
    ]
    listed_before = {(finding["code"], finding["message"]) for finding in listed}
    tests = [
        {**finding, "message": f"{_words(result)}: {finding['message']}"}
        for result in outcome.evaluation["results"]
        for finding in result["findings"]
    ]
    rest = [
        finding
        for finding in (*outcome.findings, *tests)
        if (finding["code"], finding["message"]) not in listed_before
    ]
    return [
        *summaries.doubt_lines(doubts),
        *summaries.acknowledged_lines(outcome.prediction["acknowledged"]),
        *summaries.assumed_table(outcome.assumed),
        *summaries.prediction_tables(outcome.prediction),
        *summaries.finding_lines(rest),
        *summaries.file_lines("Written", [str(path) for path in outcome.files]),
    ]


def _words(result: Mapping[str, Any]) -> str:
    """Return the heading of an evaluated test in the terminal, such as "Axis X, test before"."""
    return (
        f"Axis {result['axis']}, test {result['name']}"
        if result["kind"] == "positioning"
        else f"Circle {result['name']}"
    )


def decode_summary(document: Mapping[str, Any]) -> list[Any]:
    """Return the terminal output of ``decode``."""
    from compwright.reporting import summaries

    return summaries.decode_tables(document)


def compare_summary(document: Mapping[str, Any]) -> list[Any]:
    """Return the terminal output of ``compare``."""
    from compwright.reporting import difference_output

    return difference_output.compare_tables(document)


def diff_summary(document: Mapping[str, Any]) -> list[Any]:
    """Return the terminal output of ``diff``."""
    from compwright.reporting import difference_output

    return difference_output.diff_tables(document)


def verify_summary(outcome: Any) -> list[Any]:
    """Return the terminal output of ``verify``."""
    from compwright.reporting import summaries

    return [
        *summaries.doubt_lines(outcome.document["doubts"]),
        *summaries.acknowledged_lines(outcome.document["acknowledged"]),
        *summaries.verification_tables(outcome.document),
        *summaries.next_lines(outcome.document.get("next")),
        *summaries.file_lines("Written", [str(path) for path in outcome.files]),
    ]


def history_summary(document: Mapping[str, Any]) -> list[Any]:
    """Return the terminal output of ``history``."""
    from compwright.reporting.history import history_tables

    return history_tables(document)


def demo_summary(outcome: Any) -> list[Any]:
    """Return the terminal output of ``demo`` in ten lines: its steps, each axis, the verdict, and
    the pages.
    """
    from compwright.reporting import summaries

    pages = [
        str(path)
        for path in (*outcome.run.files, *outcome.verification.files)
        if path.suffix == ".html"
    ]
    return summaries.demo_tables(outcome.steps, outcome.verification.document, pages)
