"""The JSON document of ``history``: deviations in µm or arcsec, squareness in µm/m."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from compwright.foundations.errors import Fault
from compwright.foundations.utf8 import encoded, visible_lines
from compwright.records.history import HistoryEntry, NotedChange, NotedTrend

SCHEMA = "compwright/history/1"
#: Columns of the values, in the order in which they are shown.
VALUES = (
    *("A", "E", "M", "R", "B", "B_mean", "s", "slope"),
    *("squareness", "G_bidirectional", "G_ccw", "G_cw"),
)
#: Largest standard normal value that is given.
_MOST = 99.0


@dataclass(frozen=True, slots=True, kw_only=True)
class TestSeries:
    """The tests of one axis or plane, ascending by date, and the changes between successive tests.

    ``key``: identifies the machine, even if it has no name. ``what``: the axis or plane.
    """

    key: str
    machine: str
    serial: str
    what: str
    entries: tuple[HistoryEntry, ...]
    changes: tuple[NotedChange, ...]
    trends: tuple[NotedTrend, ...]


def history_document(
    series: Iterable[TestSeries],
    folders: Sequence[Mapping[str, Any]],
    notes: Iterable[str],
    errors: Iterable[Fault],
) -> dict[str, Any]:
    """Return the history of machines as JSON. ``notes``: remarks on each result folder."""
    machines: dict[str, dict[str, Any]] = {}
    for one in series:
        machine = machines.setdefault(
            one.key,
            {"name": one.machine, "serial": one.serial, "axes": {}, "planes": {}},
        )
        kind = "planes" if one.entries[0].kind == "circular" else "axes"
        machine[kind][one.what] = {
            "tests": [_entry(entry) for entry in one.entries],
            "changes": [_change(change, one.entries) for change in one.changes],
            "trends": {trend.parameter: _trend(trend, one.entries) for trend in one.trends},
        }
    return {
        "schema": SCHEMA,
        "machines": list(machines.values()),
        "folders": list(folders),
        "notes": list(notes),
        "errors": [
            {"file": fault.file, "message": str(fault).removeprefix(f"{fault.file}: ")}
            for fault in errors
        ],
    }


def _entry(entry: HistoryEntry) -> dict[str, Any]:
    return {
        "folder": entry.folder,
        "test": entry.test,
        "taken": entry.taken,
        "date": entry.date,
        "day": entry.day,
        "standard": entry.standard,
        "unit": entry.unit,
        "simulated": entry.simulated,
        "table": entry.table,
        "verdict": entry.verdict,
        **{name: entry.values.get(name) for name in VALUES if name in _OF_KIND[entry.kind]},
        "std_error": {name: error for name, (error, _) in entry.errors.items()},
        "uncertainty": {
            name: {"U": U, "coverage": coverage} for name, (U, coverage) in entry.declared.items()
        },
    }


_OF_KIND = {
    "positioning": frozenset({"A", "E", "M", "R", "B", "B_mean", "s", "slope"}),
    "circular": frozenset({"squareness", "G_bidirectional", "G_ccw", "G_cw"}),
}


def _change(change: NotedChange, entries: Sequence[HistoryEntry]) -> dict[str, Any]:
    score = min(abs(change.score), _MOST)
    return {
        **{key: value for key, value in asdict(change).items() if key not in ("score", "chance")},
        "unit": _unit(change.parameter, entries[change.after]),
        "standard_errors": _rounded(change.size / change.std_error if change.std_error else None),
        "score": _rounded(math.copysign(score, change.score)),
        "chance": float(f"{change.chance:.3g}"),
    }


def _trend(trend: NotedTrend, entries: Sequence[HistoryEntry]) -> dict[str, Any]:
    first, last = (entries[trend.tests[end]] for end in (0, -1))
    return {
        "rate_per_year": round(trend.rate, 6),
        "std_error": round(trend.std_error, 6),
        "interval": [round(end, 6) for end in trend.interval],
        "unit": _unit(trend.parameter, last),
        "clear": trend.clear,
        "first": first.values[trend.parameter],
        "last": last.values[trend.parameter],
        "first_day": first.day,
        "last_day": last.day,
        "n_tests": len(trend.tests),
        "jumps": [
            {**asdict(jump), "size": _rounded(jump.size), "std_error": _rounded(jump.std_error)}
            for jump in trend.jumps
        ],
        "limit": trend.limit,
        "crosses": (
            {"day": trend.reached, "earliest": trend.earliest, "latest": trend.latest}
            if trend.earliest
            else None
        ),
    }


def _unit(parameter: str, entry: HistoryEntry) -> str:
    return "um/m" if parameter in ("squareness", "slope") else entry.unit


def _rounded(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else round(value, 3)


def history_csv(document: Mapping[str, Any]) -> bytes:
    """Return a history as CSV, a row for each test; a column names the parameters that changed up
    to that test.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(
        [
            *("machine", "serial", "axis", "date", "folder", "test", "taken", "unit", *VALUES),
            *("table", "verdict", "changed"),
        ]
    )
    for machine in document["machines"]:
        for name, one in {**machine["axes"], **machine["planes"]}.items():
            for place, test in enumerate(one["tests"]):
                changed = [
                    change["parameter"] for change in one["changes"] if change["after"] == place
                ]
                writer.writerow(
                    [
                        *(machine["name"], machine["serial"], name, test["day"] or test["date"]),
                        *(test["folder"], test["test"], test["taken"], test["unit"]),
                        *("" if test.get(key) is None else f"{test[key]:.3f}" for key in VALUES),
                        *(test["table"], test["verdict"], " ".join(changed)),
                    ]
                )
    return encoded(visible_lines(text.getvalue()))
