"""The test sheet of a report: each item that a standard requires, its value, and the clause."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any, Final

from compwright.reporting.numbers import plain
from compwright.reporting.report_items import READ_EDITION, ReportItem, items_of
from compwright.words.sentences import DateText, NumberText, Sentence, say

Document = Mapping[str, Any]

#: Printed for an item that neither the file nor the job states.
NOT_STATED: Final = say("label.not_stated")

_NUMBER: Final = re.compile(r"[+-]?\d+(?:[.,]\d+)?(?:[eE][+-]?\d+)?")
_ENDS: Final = ("", "_start", "_end")
#: Keys of the header that the evaluation repeats as its own.
_IN_RESULT: Final = {"axis", "cycle", "plane", "nominal_radius_mm", "feed_mm_min", "unit"}


def sheet_rows(result: Document, stated: Mapping[str, str | Sentence]) -> list[dict[str, Any]]:
    """Return a row for each item that the standard requires in a test report: its ``key``,
    ``label``, ``value`` and ``clause``. ``stated``: what the job states, by the key of the item.

    If there are several statements on an item, its value contains all of them. If there is none,
    the value is "not stated".
    """
    header = _by_key(result.get("header") or {})
    edition = READ_EDITION.get(str(result.get("standard")), "")
    rows = []
    for item in items_of(str(result.get("kind", "positioning"))):
        texts = [
            *_from_header(item, header),
            *([stated[item.key]] if stated.get(item.key) else []),
            *([item.given(result)] if item.given is not None else []),
        ]
        found = list(dict.fromkeys(text for text in texts if text))
        value = say("given.statements", statements=found) if len(found) > 1 else None
        rows.append(
            {
                "key": item.key,
                "label": item.label,
                "value": value or next(iter(found), NOT_STATED),
                "clause": item.clauses.get(edition, ""),
            }
        )
    return rows


def further_statements(result: Document) -> list[tuple[str, str]]:
    """Return key and text of those lines in the measurement file's header that belong to no item of
    `items_of`.
    """
    used = {
        f"{key}{end}"
        for item in items_of(str(result.get("kind", "positioning")))
        for key in item.headers
        for end in _ENDS
    } | _IN_RESULT
    return [
        (str(key), plain(text))
        for key, text in (result.get("header") or {}).items()
        if _plain_key(str(key)) not in used
    ]


def _from_header(item: ReportItem, header: Mapping[str, list[str]]) -> list[str | Sentence]:
    return [
        _at_end(DateText(text) if item.key == "date" else _with_unit(text, unit), end)
        for key, unit in item.headers.items()
        for end in _ENDS
        for text in header.get(f"{key}{end}", ())
    ]


def _at_end(text: str | Sentence, end: str) -> str | Sentence:
    return say("given.at_end", text=text, end=end) if end else text


def _with_unit(text: str, unit: str | Sentence) -> str | Sentence:
    if not (unit and _NUMBER.fullmatch(text)):
        return text
    return say("label.with_unit", value=NumberText(text), unit=unit)


def _by_key(header: Mapping[str, Any]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for key, text in header.items():
        lines = [line.strip() for line in plain(text).splitlines() if line.strip()]
        found.setdefault(_plain_key(str(key)), []).extend(lines)
    return found


def _plain_key(written: str) -> str:
    return re.sub(r"[ -]+", "_", written.strip()).lower()
