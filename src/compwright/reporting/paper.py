"""What makes pages a report on paper: its head, the statement of conformity, the conditions of each
test, the budget of the uncertainty, the annexes. Computes nothing.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Mapping, Sequence
from datetime import date
from typing import Any, Final

from compwright.foundations.utf8 import visible_lines
from compwright.reporting import sections
from compwright.reporting.axis_figures import result_figure, reversal_figure
from compwright.reporting.numbers import (
    number,
    plain,
    position_unit,
    standard_text,
    symbol,
    unit_text,
)
from compwright.reporting.report_items import BASIS
from compwright.reporting.sections import Document, TextTable
from compwright.reporting.test_sheet import NOT_STATED, further_statements, sheet_rows

#: Printed on every report: what compwright cannot know of the firm that signs.
ACCREDITATION: Final = (
    "This is a test report, not a calibration certificate of an accredited laboratory. The"
    " traceability of the values rests on the calibration certificates of the measuring instruments"
    " that are named."
)
NO_LIMITS: Final = "No limit was given. This report states values; it does not state conformity."
#: Letters of the report number that fit in a footer.
_MOST_IN_FOOTER: Final = 60
_MOST_IN_HEAD: Final = 4
_DAY: Final = re.compile(r"\b\d{4}-\d{2}-\d{2}|\b\d{8}\b")
_SOURCES: Final = {
    "device": "Measuring instrument (certificate)",
    "misalignment_mm": "Misalignment of the measuring line",
    "U_theta_machine": "Temperature of the machine",
    "U_theta_instrument": "Temperature of the instrument",
    "U_alpha_machine": "Expansion coefficient of the machine",
    "U_alpha_instrument": "Expansion coefficient of the instrument",
    "setup": "Set-up",
    "E_VE": "Environmental variation (range)",
}
_DISTRIBUTIONS: Final = {"normal": "normal, k = 2", "rectangular": "rectangular, √12"}
_PER: Final = {"length": "over the length", "test": "per test", "reading": "per reading"}


def head(report: Document, evaluations: Sequence[Document]) -> dict[str, Any]:
    """Return the head of a report: ``rows`` of name and text, the ``logo`` (or None), and the
    ``footer`` of each printed page as a CSS string, ``running`` the same as text, and the ``date``
    of the last test as ISO 8601 writes it (empty where no test states one).

    ``report``: ``number``, ``customer``, ``operator``, ``place`` and ``logo`` (``type``,
    ``base64``) as far as they are given.
    """
    rows = [("Report number", report.get("number")), ("Customer", report.get("customer"))]
    for name, key in (("Operator", "operator"), ("Place", "place"), ("Date of the test", "date")):
        rows.append((name, report.get(key) or _of_every_test(key, evaluations)))
    footer = f"Report {report['number']}" if report.get("number") else "Report without a number"
    return {
        "rows": [(name, plain(text) if text else NOT_STATED) for name, text in rows],
        "logo": report.get("logo"),
        "running": footer,
        "footer": css_string(footer),
        "date": _last_day(evaluations),
    }


def conformity(decisions: Sequence[str], *, proven: bool) -> str:
    """Return the statement of conformity of a machine by the ``decisions`` on its limits.

    ``proven``: nothing but the limits is open.
    """
    if not decisions:
        return NO_LIMITS
    if "reject" in decisions:
        return "The machine does not conform to every limit of the table above."
    if "undecided" in decisions or not proven:
        return "Conformity is not stated: at least one decision, or what it rests on, is open."
    return "The machine conforms to every limit of the table above."


def _last_day(results: Sequence[Document]) -> str:
    """Return the latest date that a test states and that the calendar has; empty without any."""
    days = []
    for result in results:
        for row in sheet_rows(result, {}):
            for day in _DAY.findall(row["value"]) if row["key"] == "date" else ():
                with contextlib.suppress(ValueError):
                    days.append(date.fromisoformat(day).isoformat())
    return max(days, default="")


def _of_every_test(key: str, results: Sequence[Document]) -> str:
    """Return what the tests state of an item; where they differ much, where it is found."""
    values = dict.fromkeys(
        row["value"] for result in results for row in sheet_rows(result, {}) if row["key"] == key
    )
    return "; ".join(values) if len(values) < _MOST_IN_HEAD else "see the pages of the tests"


def css_string(text: str) -> str:
    """Return ``text`` as a CSS string: nothing in it can end the string or the style sheet."""
    line = " ".join(visible_lines(text).split())[:_MOST_IN_FOOTER]
    return '"' + "".join(c if c.isalnum() or c in " .-" else f"\\{ord(c):x} " for c in line) + '"'


def measured_block(result: Document, stated: Mapping[str, str]) -> dict[str, Any]:
    """Return the page of one positioning result: figures, extremes, conditions and budget."""
    axis = plain(result.get("axis"))
    reversal = any(target.get("reversal") is not None for target in result.get("targets") or ())
    return {
        "figure": result_figure(result, f"deviations of axis {axis}"),
        "reversal": reversal_figure(result, f"reversal of axis {axis}") if reversal else None,
        "extremes": _extremes(result),
        "budget": _budget(result),
        "sheet": sheet(result, stated),
    }


def sheet(result: Document, stated: Mapping[str, str]) -> dict[str, Any]:
    """Return the conditions of a test: the items of its standard, and what the file says more."""
    return {
        "standard": standard_text(result.get("standard", "")),
        "rows": sheet_rows(result, stated),
        "basis": BASIS.get(str(result.get("standard")), ""),
        "further": further_statements(result),
    }


def sheets_together(sheets: Iterable[tuple[str, Document]]) -> list[dict[str, Any]]:
    """Return the `sheet`s of several tests, each with the name of its test, as one for each
    standard: what is the same for all tests once, else with the names of the tests.
    """
    of_standard: dict[str, list[tuple[str, Document]]] = {}
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


def _of_each(names: Sequence[str], values: Sequence[str]) -> str:
    """Return what all tests state, or each value with the names of its tests."""
    names_by_value: dict[str, list[str]] = {}
    for name, value in zip(names, values, strict=True):
        names_by_value.setdefault(value, []).append(name)
    if len(names_by_value) == 1:
        return values[0]
    return "; ".join(f"{', '.join(of)}: {value}" for value, of in names_by_value.items())


def _extremes(result: Document) -> TextTable | None:
    unit = unit_text(result.get("unit"))
    where = unit_text(result.get("position_unit") or position_unit(result.get("unit")))
    coverage = plain(result.get("coverage") or 2)
    words = {
        "A": (f"mean + {coverage} s", f"mean − {coverage} s"),
        "E": ("mean", "mean"),
        "M": ("mean ±", "mean ±"),
    }
    rows = [
        [
            symbol(name),
            f"{end} {words[name][place]}",
            {"+": "+", "-": "−"}.get(str(entry.get("direction")), "both"),
            plain(entry.get("position")),
            number(entry.get("value")),
        ]
        for name, ends in (result.get("extremes") or {}).items()
        for place, (end, entry) in enumerate(zip(("highest", "lowest"), ends, strict=True))
    ]
    if not rows:
        return None
    heads = sections.heads("Parameter", "Extreme", "Approach", ("Position", where), ("Value", unit))
    return {"heads": heads, "rows": rows}


def _budget(result: Document) -> dict[str, Any] | None:
    budget = result.get("budget")
    if not budget:
        return None
    unit = unit_text(result.get("unit"))
    rows = [
        [
            _SOURCES.get(str(one.get("source")), plain(one.get("source"))),
            f"{plain(one.get('given'))} {_contributor_unit(one.get('unit'))}",
            f"{_DISTRIBUTIONS.get(str(one.get('distribution')))}; {_PER.get(str(one.get('per')))}",
            number(one.get("sensitivity"), 3),
            number(one.get("standard"), 3),
            plain(one.get("note") or ""),
        ]
        for one in budget.get("contributions") or ()
    ]
    rows.append(
        ["Combined standard uncertainty", "", "", "", number(budget.get("standard"), 3), ""]
    )
    rows.append(
        [
            f"Expanded uncertainty, k = {plain(budget.get('coverage'))}",
            "", "", "", number(budget.get("U"), 3), "",
        ]
    )  # fmt: skip
    where = unit_text(result.get("position_unit"))
    return {
        "length": f"{plain(budget.get('length'))} {where}",
        "table": {
            "heads": sections.heads(
                "Source", "Value given", "Distribution", ("Sensitivity", ""),
                ("Contribution u", unit), "Remark",
            ),
            "rows": rows,
        },
    }  # fmt: skip


def _contributor_unit(unit: object) -> str:
    return unit_text(unit) if unit in ("um", "arcsec", "mm") else str(unit).replace("um", "µm")
