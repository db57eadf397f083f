"""Parts of a printed report: head, conformity, conditions, uncertainty budget."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Mapping, Sequence
from datetime import date
from typing import Any, Final

from compwright.reporting import sections
from compwright.reporting.axis_figures import result_figure, reversal_figure
from compwright.reporting.numbers import (
    number,
    plain,
    position_unit,
    standard_text,
    symbol,
    unit_text,
    with_unit,
)
from compwright.reporting.report_items import BASIS
from compwright.reporting.sections import Document, TextTable
from compwright.reporting.test_sheet import NOT_STATED, further_statements, sheet_rows
from compwright.words.sentences import Sentence, say

#: Printed on every report: what compwright cannot know of the firm that signs.
ACCREDITATION: Final = say("report.accreditation")
NO_LIMITS: Final = say("report.no_limits")
_MOST_IN_HEAD: Final = 4
_DAY: Final = re.compile(r"\b\d{4}-\d{2}-\d{2}|\b\d{8}\b")
_SOURCES: Final = {
    "device": say("budget.device"),
    "misalignment_mm": say("budget.misalignment_mm"),
    "U_theta_machine": say("budget.U_theta_machine"),
    "U_theta_instrument": say("budget.U_theta_instrument"),
    "U_alpha_machine": say("budget.U_alpha_machine"),
    "U_alpha_instrument": say("budget.U_alpha_instrument"),
    "setup": say("budget.setup"),
    "E_VE": say("budget.E_VE"),
}


def head(report: Document, evaluations: Sequence[Document]) -> dict[str, Any]:
    """Return the head of a report: rows of name and text, logo, footer, date of the last test.

    The keys are ``rows``, ``logo`` (or None), ``running`` (the footer of each printed page) and
    ``date`` (ISO 8601, empty if no test states one). ``report``: those of ``number``, ``customer``,
    ``operator``, ``place`` and ``logo`` (``type``, ``base64``) that are given.
    """
    rows = [
        (say("report.number"), report.get("number")),
        (say("report.customer"), report.get("customer")),
    ]
    for name, key in (
        (say("report.operator"), "operator"),
        (say("report.place"), "place"),
        (say("report.date"), "date"),
    ):
        rows.append((name, report.get(key) or _of_every_test(key, evaluations)))
    number = report.get("number")
    footer = say("report.footer", number=plain(number)) if number else say("report.no_number")
    return {
        "rows": [(name, _shown(text) if text else NOT_STATED) for name, text in rows],
        "logo": report.get("logo"),
        "running": footer,
        "date": _last_day(evaluations),
    }


def conformity(decisions: Sequence[str], *, proven: bool) -> Sentence:
    """Return the statement of conformity of a machine, from the ``decisions`` on its limits.
    ``proven``: nothing except the limits is undecided, such as whether the loaded table is active.
    """
    if not decisions:
        return NO_LIMITS
    if "reject" in decisions:
        return say("report.not_conform")
    if "undecided" in decisions or not proven:
        return say("report.conformity_open", undecided="undecided" in decisions)
    return say("report.conform")


def _shown(text: object) -> str | Sentence:
    return text if isinstance(text, Sentence) else plain(text)


def _last_day(results: Sequence[Document]) -> str:
    """Return the latest valid date that a test states, or "" if none states a date."""
    days = []
    for result in results:
        for row in sheet_rows(result, {}):
            for day in _DAY.findall(str(row["value"])) if row["key"] == "date" else ():
                with contextlib.suppress(ValueError):
                    days.append(date.fromisoformat(day).isoformat())
    return max(days, default="")


def _of_every_test(key: str, results: Sequence[Document]) -> str | Sentence:
    """Return what the tests state about one item of the report. If there are too many different
    statements, return "see tests".
    """
    values = dict.fromkeys(
        row["value"] for result in results for row in sheet_rows(result, {}) if row["key"] == key
    )
    if len(values) < _MOST_IN_HEAD:
        return say("given.statements", statements=list(values)) if values else ""
    return say("report.see_tests")


def measured_block(result: Document, stated: Mapping[str, str | Sentence]) -> dict[str, Any]:
    """Return the page of one positioning test: figures, extremes, conditions and budget.
    ``stated``: what the job states about its conditions, by item.
    """
    axis = plain(result.get("axis"))
    reversal = any(target.get("reversal") is not None for target in result.get("targets") or ())
    return {
        "figure": result_figure(result, axis),
        "reversal": reversal_figure(result, axis) if reversal else None,
        "extremes": _extremes(result),
        "budget": _budget(result),
        "sheet": sheet(result, stated),
    }


def sheet(result: Document, stated: Mapping[str, str | Sentence]) -> dict[str, Any]:
    """Return the conditions of a test: the items that its standard requires, and further statements
    in the measurement file. ``stated``: what the job states, by item.
    """
    return {
        "standard": standard_text(result.get("standard", "")),
        "rows": sheet_rows(result, stated),
        "basis": BASIS.get(str(result.get("standard")), ""),
        "further": further_statements(result),
    }


def sheets_together(
    sheets: Iterable[tuple[str | Sentence, Document]],
) -> list[dict[str, Any]]:
    """Return the conditions of several tests as one table for each standard. A statement that is
    equal for several tests occurs once.
    """
    of_standard: dict[str, list[tuple[str | Sentence, Document]]] = {}
    for name, one in sheets:
        of_standard.setdefault(one["standard"], []).append((name, one))
    return [
        {
            **group[0][1],
            "rows": [
                {**rows[0], "value": _of_each([name for name, _ in group], values)}
                for rows in zip(*(one["rows"] for _, one in group), strict=True)
                for values in [[row["value"] for row in rows]]
            ],
            "further": [
                (key, _of_each([name for name, _ in group], values))
                for key in dict.fromkeys(key for _, one in group for key, _ in one["further"])
                for values in [[dict(one["further"]).get(key, NOT_STATED) for _, one in group]]
            ],
        }
        for group in of_standard.values()
    ]


def _of_each(names: Sequence[str | Sentence], values: Sequence[str | Sentence]) -> str | Sentence:
    """Return the statement on one item, such as the instrument, if it is the same for all tests
    ``names``; else each different statement in ``values`` with the names of its tests.
    """
    names_by_value: dict[str | Sentence, list[str | Sentence]] = {}
    for name, value in zip(names, values, strict=True):
        names_by_value.setdefault(value, []).append(name)
    if len(names_by_value) == 1:
        return values[0]
    each = [
        say("given.of_tests", names=of, statement=value) for value, of in names_by_value.items()
    ]
    return say("given.statements", statements=each)


def _extremes(result: Document) -> TextTable | None:
    unit = unit_text(result.get("unit"))
    where = unit_text(result.get("position_unit") or position_unit(result.get("unit")))
    coverage = plain(result.get("coverage") or 2)
    rows = [
        [
            symbol(name),
            say("report.extreme", end=end, what=name[0], coverage=coverage),
            {"+": "+", "-": "−"}.get(str(entry.get("direction")), say("report.both")),
            plain(entry.get("position")),
            number(entry.get("value")),
        ]
        for name, ends in (result.get("extremes") or {}).items()
        for end, entry in zip(("highest", "lowest"), ends, strict=True)
    ]
    if not rows:
        return None
    heads = sections.heads(
        say("head.parameter"),
        say("head.extreme"),
        say("head.approach"),
        (say("head.position"), where),
        (say("head.value"), unit),
    )
    return {"heads": heads, "rows": rows}


def _budget(result: Document) -> dict[str, Any] | None:
    budget = result.get("budget")
    if not budget:
        return None
    unit = unit_text(result.get("unit"))
    rows = [
        [
            _SOURCES.get(str(one.get("source")), plain(one.get("source"))),
            with_unit(one.get("given"), _contributor_unit(one.get("unit"))),
            say(
                "budget.distribution",
                distribution=str(one.get("distribution")),
                per=str(one.get("per")),
            ),
            number(one.get("sensitivity"), 3),
            number(one.get("standard"), 3),
            plain(one.get("note") or ""),
        ]
        for one in budget.get("contributions") or ()
    ]
    rows.append([say("budget.combined"), "", "", "", number(budget.get("standard"), 3), ""])
    rows.append(
        [
            say("budget.expanded", k=plain(budget.get("coverage"))),
            "", "", "", number(budget.get("U"), 3), "",
        ]
    )  # fmt: skip
    where = unit_text(result.get("position_unit"))
    return {
        "length": with_unit(budget.get("length"), where),
        "table": {
            "heads": sections.heads(
                say("head.source"), say("head.value_given"), say("head.distribution"),
                (say("head.sensitivity"), ""), (say("head.contribution"), unit),
                say("head.remark"),
            ),
            "rows": rows,
        },
    }  # fmt: skip


def _contributor_unit(unit: object) -> str:
    return unit_text(unit) if unit in ("um", "arcsec", "mm") else str(unit).replace("um", "µm")
