"""The terminal output of ``compare`` and ``diff``, short enough to read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

from rich.console import RenderableType
from rich.table import Table

from compwright.reporting.numbers import number, plain, unit_text
from compwright.reporting.safe_text import Text
from compwright.reporting.summaries import doubt_lines, finding_lines, plain_table
from compwright.words.sentences import say

#: Rows for one axis, and groups of others; the JSON has all of them.
_MOST_ROWS: Final = 20
#: Entries that one side alone has are listed while there are no more than these.
_FEW: Final = 8
#: Rows of compare.
_MOST_DIFFERENCES: Final = 60
_UNITS: Final = ("um", "arcsec")
_ABSENT: Final = "not there"


def compare_tables(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return the terminal output of ``compare``: doubts, a verdict per axis, and differences."""
    doubts = document["doubts"]
    again = any(doubt["code"] != "CW-S088" for doubt in doubts)  # which has a next step of its own
    shown = doubt_lines(doubts, say("doubts.compare") if again else None)
    own = any(finding["code"] == "CW-S085" for finding in document["findings"])
    for name, axis in document["axes"].items():
        same = axis["verdict"] == "loaded" and not axis["differences"] and not own
        message = str(axis["message"])
        if axis["verdict"] == "unreadable":
            message = f"the effect of the files that were read back is unknown: {message}"
        elif axis["verdict"] != "loaded":
            unit = unit_text(axis["unit"])
            place = f"{plain(axis['at'])} arriving in {axis['direction']}"
            message += (
                f"; largest difference {number(axis['largest_difference'])} {unit} at {place}"
            )
        shown.append(Text(f"axis {name}: {message}", style="green" if same else "bold red"))
        shown += [Text(f"  look at: {sentence}") for sentence in axis["look_at"]]
    rows = document["differences"]
    if rows:
        table = plain_table()
        for heading in ("axis", "quantity"):
            table.add_column(heading)
        for heading in ("planned", "in the control", ""):
            table.add_column(heading, justify="right", no_wrap=True)
        for row in rows[:_MOST_DIFFERENCES]:
            values = [
                number(row[key], 3) if isinstance(row[key], float) else plain(row[key])
                for key in ("planned", "loaded")
            ]
            table.add_row(
                row["axis"], row["quantity"], *values, unit_text(row["unit"]) if row["unit"] else ""
            )
        shown += [Text(), table]
        if len(rows) > _MOST_DIFFERENCES:
            shown.append(
                Text(f"({len(rows) - _MOST_DIFFERENCES} more rows: see --json)", style="dim")
            )
    if document["elsewhere"]:
        shown += [
            Text("changed as well, and not known to compensate; ask who changed it:"),
            *other_tables(document["elsewhere"]),
        ]
    return [*shown, *finding_lines(document["findings"])]


def diff_tables(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return the terminal output of ``diff``: the differences of each axis, then the differences
    that belong to no axis.
    """
    if document["same"]:
        shown: list[RenderableType] = [Text("same: both enter the same values", style="green")]
        return [*shown, *finding_lines(document["findings"])]
    shown = []
    aside: list[str] = []
    for address, axis in document["axes"].items():
        if (
            axis["correction"] is None
            and not _both(axis["entries"])
            and len(axis["entries"]) > _FEW
        ):
            aside.append(address)
            continue
        called = f" ({axis['name']})" if axis["name"] and axis["name"] != address else ""
        words = _correction(axis["correction"], known=axis["correction_compared"])
        shown.append(Text(f"axis {address}{called}: {words}", "bold"))
        shown += entry_tables(axis["entries"])
    if aside:
        count = sum(len(document["axes"][address]["entries"]) for address in aside)
        words = f"axes {', '.join(aside)}: {count} entries are in one of the backups only"
        shown.append(Text(words, style="bold"))
    for pair in document["cross"]:
        words = f"{pair['output']} over {pair['input']}: {_correction(pair)}"
        shown.append(Text(words, "bold"))
    if document["machine"]:
        shown.append(Text("of the machine, or of no axis that the files name", "bold"))
        shown += entry_tables(document["machine"])
    if document["other"]:
        shown += other_tables(document["other"])
    return [*shown, *finding_lines(document["findings"])]


def _both(entries: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return the entries that have both an old and a new value."""
    return [entry for entry in entries if None not in (entry["old"], entry["new"])]


def _correction(change: Mapping[str, Any] | None, *, known: bool = True) -> str:
    """Return, as text, how the correction of an axis differs between two backups. ``known``: both
    corrections could be read and compared.
    """
    if change is None:
        same, entries = "the correction is the same", "only its entries are compared"
        return same if known else entries
    unit = next(unit for unit in _UNITS if f"max_change_{unit}" in change)
    most = change[f"max_change_{unit}"]
    return (
        f"the correction changes by up to {number(most)} {unit_text(unit)}, at"
        f" {plain(change['at'])} arriving in {change['direction']}"
    )


def entry_tables(entries: Sequence[Mapping[str, Any]]) -> list[RenderableType]:
    """Return a table of the differing entries. If there are many, those in only one of the two
    backups are counted, not listed.
    """
    both = _both(entries)
    alone = [
        f"{count} only in {side}"
        for side, key in (("OLD", "new"), ("NEW", "old"))
        if (count := sum(entry[key] is None for entry in entries))
    ]
    if len(entries) <= _FEW:
        both, alone = list(entries), []
    counted = [Text(f"entries: {', '.join(alone)}", style="dim")] if alone else []
    if not both:
        return [*counted]
    table = plain_table()
    for heading in ("entry", "meaning"):
        table.add_column(heading)
    for heading in ("at (file's unit)", "old", "new"):
        table.add_column(heading, justify="right")
    for entry in both[:_MOST_ROWS]:
        table.add_row(
            entry["quantity"],
            entry["meaning"] or "",
            "" if entry["at"] is None else plain(entry["at"]),
            *(_ABSENT if entry[key] is None else entry[key] for key in ("old", "new")),
        )
    return [table, *_rest(len(both)), *counted, Text()]


def other_tables(groups: Sequence[Mapping[str, Any]]) -> list[RenderableType]:
    """Return a table of those differing parameters that are not known to be part of any
    compensation.

    If many parameters are on one side only, the table has their number instead.
    """
    both = [group for group in groups if group["changed"]]
    alone = len(groups) - len(both)
    if alone <= _FEW:
        both, alone = list(groups), 0
    counted: list[RenderableType] = [
        Text(f"elsewhere: {alone} more stand on one side only", style="dim")
    ]
    if not both:
        return counted if alone else []
    table: Table = plain_table()
    for heading in ("elsewhere", "meaning"):
        table.add_column(heading)
    for heading in ("changed", "only old", "only new"):
        table.add_column(heading, justify="right")
    table.add_column("such as")
    for group in both[:_MOST_ROWS]:
        first = group["examples"][0]
        values = " -> ".join(
            _ABSENT if first[key] is None else str(first[key])[:30] for key in ("old", "new")
        )
        table.add_row(
            group["quantity"],
            group["meaning"] or "",
            *(str(group[key] or "") for key in ("changed", "only_old", "only_new")),
            f"{first['quantity']}: {values}",
        )
    return [table, *_rest(len(both)), *(counted if alone else ()), Text()]


def _rest(count: int) -> list[RenderableType]:
    left = count - _MOST_ROWS
    return [Text(f"({left} more: see --json)", style="dim")] if left > 0 else []
