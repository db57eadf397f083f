"""Circular results as terminal output of 80 columns.

This module loads rich. A module for a command that may not print tables must import it inside a
function.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from pathlib import PurePath
from typing import Any

from rich.console import Group, RenderableType
from rich.rule import Rule
from rich.table import Table

from compwright.foundations.findings import DOUBTS
from compwright.reporting.causes import (
    CircleCause,
    findings_in_words,
    full_cause_words,
    machine_title,
    ranked_causes,
    summed_causes,
)
from compwright.reporting.circle_steps import steps_for
from compwright.reporting.circular_parameters import parameter_rows, printed_parameters
from compwright.reporting.numbers import MISSING, number, plain, standard_text
from compwright.reporting.safe_text import Text
from compwright.reporting.summaries import finding_lines
from compwright.words.sentences import say


def circular_tables(results: Sequence[Mapping[str, Any]]) -> list[RenderableType]:
    """Return the terminal output of circular results: parameters, centre, ranked causes,
    findings.
    """
    return [_result(result) for result in results]


def machine_table(machine: Mapping[str, Any]) -> RenderableType:
    """Return the terminal output of the common result of several circular tests of one machine."""
    unnamed = machine["machine"] is None and machine["serial"] is None
    return Group(
        Text(str(machine_title(machine)), style="bold"),
        *finding_lines(machine["findings"]),
        *([Text(str(say("report.unnamed_machine")))] if unnamed else []),
        Text(),
    )


def _result(result: Mapping[str, Any]) -> RenderableType:
    findings = findings_in_words(result)
    doubts = [one for one in findings if one["code"] in DOUBTS and one["severity"] != "info"]
    parts: list[RenderableType] = [
        Rule(Text(_title(result), style="bold"), align="left", characters="─"),
        *([*finding_lines(doubts), Text()] if doubts else []),
        *_facts(result),
        Text(),
        _parameters(result),
        *_printed(result),
        *_not_applicable(result),
        Text(),
        *_causes(result),
    ]
    if rest := [one for one in findings if one not in doubts]:
        parts += [Text(), *finding_lines(rest)]
    return Group(*parts, Text())


def _title(result: Mapping[str, Any]) -> str:
    files = ", ".join(PurePath(source["file"]).name for source in result["sources"]) or str(
        result["name"]
    )
    return f"{files} · circle {result['plane']}"


def _facts(result: Mapping[str, Any]) -> list[Text]:
    arc = result["arc"]
    path = (
        "full circle"
        if arc["extent"] >= 360.0
        else f"arc of {_short(arc['extent'])}° from {_short(arc['start'])}°"
    )
    bar = (
        "length of the bar calibrated"
        if result["calibrated"]
        else "length of the bar not calibrated"
    )
    setting = f"R {plain(result['nominal_radius'])} mm, {_short(result['feed'])} mm/min"
    return [
        Text(f"{standard_text(result['standard'])}, {path}, {setting}"),
        Text(f"{bar}; {_centre(result)}"),
    ]


def _short(value: float | None) -> str:
    return MISSING if value is None else f"{value:.5g}"


def _centre(result: Mapping[str, Any]) -> str:
    """Return the least-squares centre as text: the common one of both directions, or that of the
    only direction measured.
    """
    given = {name: point for name, point in result["centre"].items() if point is not None}
    name = "common" if "common" in given else next(iter(given))
    places = ", ".join(
        f"{axis} {number(value)}" for axis, value in zip(result["axes"], given[name], strict=True)
    )
    return f"centre {places} µm"


def _parameters(result: Mapping[str, Any]) -> Table:
    values = result["parameters"]
    table = _table()
    table.add_column("Parameter, µm")
    table.add_column("", no_wrap=True)
    for heading in ("ccw", "cw", "both"):
        table.add_column(heading, justify="right", no_wrap=True)
    for row in parameter_rows(result):
        table.add_row(
            str(row.words) if row.letter else f"  {row.words}",
            row.letter,
            *(_deviation(values[key], signed=row.signed) if key else "" for key in row.keys),
        )
    return table


def _deviation(value: float | None, *, signed: bool) -> str:
    return f"+{number(value)}" if signed and value is not None and value >= 0.005 else number(value)


def _printed(result: Mapping[str, Any]) -> list[Text]:
    """Return a line with the values that the vendor's software printed for this edition."""
    printed = [f"{letter} {values}" for letter, values in printed_parameters(result).items()]
    return [Text(f"Printed in the file: {', '.join(printed)} µm", style="dim")] if printed else []


def _not_applicable(result: Mapping[str, Any]) -> list[Text]:
    """Return one line for each reason why parameters are missing; the line names the reason and
    these parameters.
    """
    reasons: dict[str, list[str]] = {}
    for name, reason in result["not_applicable"].items():
        if name != "diagnosis":
            reasons.setdefault(reason, []).append(name)
    return [
        Text(f"{MISSING} {_listed(names, result)}: {reason}", style="dim")
        for reason, names in reasons.items()
    ]


def _listed(names: Sequence[str], result: Mapping[str, Any]) -> str:
    """Return the names of causes and the letters of parameters as one text. Each occurs once; long
    names are shortened.
    """
    causes = result["diagnosis"] or {}
    return ", ".join(dict.fromkeys(_shortened(name, causes, result["axes"]) for name in names))


def _shortened(name: str, causes: Container[str], axes: Sequence[str]) -> str:
    if name in causes:
        return str(full_cause_words(name, axes))
    return "G (both)" if "_bi" in name else name.partition("_")[0] + _way(name)


def _way(name: str) -> str:
    ways = [way for way in ("ccw", "cw") if f"_{way}" in name]
    return f" {ways[0]}" if ways else ""


def _causes(result: Mapping[str, Any]) -> list[RenderableType]:
    causes = ranked_causes(result)
    if not causes:
        return [Text(f"No causes: {result['not_applicable'].get('diagnosis', 'not diagnosed')}")]
    printed = any(item.printed for cause in causes for item in (cause, *cause.parts))
    table = _table()
    table.add_column("Cause, effect in µm")
    for heading in (
        "value ± std.",
        "",
        "effect",
        "share",
        "plain",
        *(("printed",) if printed else ()),
    ):
        table.add_column(heading, justify="left" if not heading else "right", no_wrap=True)
    shown = [cause for cause in causes if cause.shown]
    for cause in shown:
        table.add_row(
            *_row(cause, str(cause.noted_words), printed=printed),
            style="" if cause.significant else "dim",
        )
        for part in cause.parts:
            table.add_row(
                *_row(part, f"  {part.noted_words}", printed=printed, whole=False), style="dim"
            )
    sums = summed_causes(result)
    if sums:
        table.add_row(str(say("circle.sums")))
    for cause in sums:
        table.add_row(*_row(cause, f"  {cause.words}", printed=printed, whole=False), style="dim")
    small = ", ".join(str(cause.words) for cause in causes if not cause.shown)
    lines: list[RenderableType] = [table] if shown else []
    if small:
        lines.append(Text(f"Below 1 % or 0.005 µm each: {small}", style="dim"))
    items = [item for cause in shown for item in (cause, *cause.parts)] + sums
    notes = {
        "(…) the instrument's software itself calls it not valid": any(
            item.doubtful for item in items
        ),
        "The software defines spikes, cyclic errors, centre changes and the positional tolerance in"
        " its own way": any(item.printed and not item.comparable for item in items),
    }
    lines += [Text(note, style="dim") for note, applies in notes.items() if applies]
    steps = steps_for(causes, result["axes"])
    if steps:
        lines += [Text(), Text("Check first", style="bold"), *(Text(str(step)) for step in steps)]
    return lines


def _row(cause: CircleCause, words: str, *, printed: bool, whole: bool = True) -> list[str]:
    cells = [words, str(cause.value_text), cause.unit_text]
    cells += [number(cause.effect), f"{100.0 * cause.share:.0f} %"] if whole else ["", ""]
    cells.append(cause.text(cause.plain))
    if printed:
        cells.append(cause.printed_text(plain))
    return cells


def _table() -> Table:
    return Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold")
