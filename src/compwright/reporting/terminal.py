"""An evaluation at the terminal, readable from 80 columns on.

This module loads rich. A module for a command that may not print tables must import it inside a
function.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import PurePath
from typing import Any, Final

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.rule import Rule
from rich.table import Table

from compwright.foundations.findings import DOUBTS
from compwright.reporting.edition_terms import has_arrows, parameter_term
from compwright.reporting.safe_text import Text

_UNITS: Final = {"um": "µm", "arcsec": "arcsec"}
_MISSING: Final = "–"
_STANDARDS: Final = {
    "iso230-2:1988": "ISO 230-2:1988",
    "iso230-2:1997": "ISO 230-2:1997",
    "iso230-2:2006": "ISO 230-2:2006",
    "iso230-2:2014": "ISO 230-2:2014",
    "gost27843:2006": "GOST 27843-2006",
    "vdi3441": "VDI/DGQ 3441",
}
#: Rows of the parameter table: words, letter, keys of both directions, + and −.
_ISO_ROWS: Final = (
    ("Accuracy", "A", ("A", "A_positive", "A_negative")),
    ("Systematic deviation", "E", ("E", "E_positive", "E_negative")),
    ("Mean deviation", "M", ("M", None, None)),
    ("Repeatability", "R", ("R", "R_positive", "R_negative")),
    ("Reversal value", "B", ("B", None, None)),
    ("Mean reversal value", "B̄", ("B_mean", None, None)),
)
_VDI_ROWS: Final = (
    ("Positional uncertainty", "P", ("P", None, None)),
    ("Positional deviation", "Pa", ("Pa", None, None)),
    ("Positional scatter, max", "Ps max", ("Ps_max", None, None)),
    ("Positional scatter, mean", "Ps mean", ("Ps_mean", None, None)),
    ("Reversal, max", "U max", ("U_max", None, None)),
    ("Reversal, mean", "U mean", ("U_mean", None, None)),
)
_STYLES: Final = {"info": "dim", "warning": "yellow", "error": "red"}


def evaluation_tables(
    document: Mapping[str, Any], *, targets: bool = False
) -> list[RenderableType]:
    """Return an evaluation for the terminal: a group of lines per result, then the errors.
    ``targets``: each positioning test has a table of its targets too.

    A finding that several standards have in common is shown once per file. Deviations are shown as
    in the document, in µm or arcsec.
    """
    shown: list[RenderableType] = []
    shown_codes: dict[str, set[str]] = {}
    for result in document["results"]:
        seen = shown_codes.setdefault(
            str([source["sha256"] for source in result["sources"]]), set()
        )
        new = [entry for entry in result["findings"] if entry["message"] not in seen]
        if result["kind"] == "environment":
            shown.append(_stand_still(result, new))
        elif result["kind"] == "lost_motion":
            shown.append(_lost_motion(result, new))
        else:
            shown.append(_result(result, new, targets=targets))
        seen.update(entry["message"] for entry in result["findings"])
    if document["errors"]:
        shown.append(_errors(document["errors"]))
    return shown


def number(value: float | None, digits: int = 2, *, signed: bool = False) -> str:
    """Return a deviation as text with a number of decimals, or a dash if it is missing."""
    if value is None:
        return _MISSING
    text = f"{value:+.{digits}f}" if signed else f"{value:.{digits}f}"
    return text.replace("-", "−")


def _result(
    result: Mapping[str, Any], findings: Sequence[Mapping[str, str]], *, targets: bool
) -> RenderableType:
    doubts = [finding for finding in findings if finding["code"] in DOUBTS]
    parts: list[RenderableType] = [
        Rule(Text(_title(result), style="bold"), align="left", characters="─"),
        *_findings(doubts),
    ]
    parts += [
        *([Text()] if doubts else []),
        *_facts(result),
        Text(),
        _parameters(result),
        *_not_applicable(result),
    ]
    if targets:
        parts += [Text(), _target_table(result)]
    parts += _findings([finding for finding in findings if finding not in doubts])
    parts.append(Text())
    return Group(*parts)


def _stand_still(
    result: Mapping[str, Any], findings: Sequence[Mapping[str, str]]
) -> RenderableType:
    value = number(result["parameters"]["E_VE"], _digits(result))
    return Group(
        Rule(Text(_title(result), style="bold"), align="left", characters="─"),
        Text(
            f"Stand-still test, {result['n_readings']} readings over"
            f" {result['duration_min']:.10g} min"
        ),
        Text(),
        Text(f"Environmental variation   E_VE   {value} {_UNITS[result['unit']]}"),
        *_findings(findings),
        Text(),
    )


def _lost_motion(
    result: Mapping[str, Any], findings: Sequence[Mapping[str, str]]
) -> RenderableType:
    constant, left = (number(result["parameters"][key]) for key in ("constant", "left"))
    return Group(
        Rule(Text(_title(result), style="bold"), align="left", characters="─"),
        Text(f"Lost motion over {result['over']}, {result['n_readings']} readings"),
        Text(),
        Text(f"Best constant   {constant} µm, leaves up to ±{left} µm"),
        *_findings(findings),
        Text(),
    )


def _title(result: Mapping[str, Any]) -> str:
    files = ", ".join(PurePath(source["file"]).name for source in result["sources"]) or str(
        result["name"]
    )
    axis = f"axis {result['axis']}" if result["axis"] else "axis not named"
    return f"{files} · {axis} ({result['axis_kind']})"


def _facts(result: Mapping[str, Any]) -> list[Text]:
    unit = result["position_unit"]
    positions = [target["position"] for target in result["targets"]]
    runs = result["n_runs"]
    spread = ", s from the range" if result.get("spread") == "range" else ""
    count = (
        f"{result['n_targets']} targets from {_position(positions[0])} to"
        f" {_position(positions[-1])} {unit}"
    )
    return [
        Text(
            f"{_STANDARDS.get(result['standard'], result['standard'])} ({result['coverage']:g}"
            f" s{spread}), {result['cycle']} cycle"
        ),
        Text(f"{count}, {_runs(runs)}"),
    ]


def _digits(result: Mapping[str, Any]) -> int:
    """Return the number of decimals for a result: 2, or up to 4 if all values are small."""
    largest = max(
        (abs(value) for value in result["parameters"].values() if value is not None), default=1.0
    )
    return 2 if largest >= 1.0 else 3 if largest >= 0.1 else 4


def _runs(runs: Mapping[str, int]) -> str:
    if runs["positive"] == runs["negative"]:
        return (
            f"{runs['positive']} runs in each direction"
            if runs["positive"] != 1
            else "1 run in each direction"
        )
    counts = [
        f"{runs[key]} in {sign}"
        for key, sign in (("positive", "+"), ("negative", "−"))
        if runs[key]
    ]
    return f"runs: {', '.join(counts)}"


def _position(value: float) -> str:
    return f"{value:.10g}".replace("-", "−")


def _parameters(result: Mapping[str, Any]) -> Table:
    values, at = result["parameters"], result["at"]
    stated = result["uncertainty"] or {}
    rows = _VDI_ROWS if "P" in values else _ISO_ROWS
    one_way = any(key for _, _, keys in rows for key in keys[1:])
    unit, digits = _UNITS.get(result["unit"], result["unit"]), _digits(result)
    arrows = has_arrows(result["standard"])
    table = Table(box=None, pad_edge=False, padding=(0, 3, 0, 0), header_style="bold")
    table.add_column("Parameter")
    table.add_column("", no_wrap=True)
    table.add_column(unit, justify="right", no_wrap=True)
    if stated:
        table.add_column("U (k = 2)", justify="right", no_wrap=True)
    if one_way:
        for head in ("↑", "↓") if arrows else ("+", "−"):
            table.add_column(head, justify="right", no_wrap=True)
    table.add_column(f"at {result['position_unit']}", justify="right", no_wrap=True)
    for words, letter, keys in rows:
        term = str(parameter_term(keys[0], result["standard"])) if arrows else words
        cells = [term, letter, number(values[keys[0]], digits, signed=keys[0] == "B_mean")]
        if stated:
            cells.append(f"± {number(stated[keys[0]]['U'], digits)}" if keys[0] in stated else "")
        if one_way:
            cells += [number(values[key], digits) if key else "" for key in keys[1:]]
        table.add_row(*cells, _position(at[keys[0]]) if keys[0] in at else "")
    return table


def _not_applicable(result: Mapping[str, Any]) -> list[RenderableType]:
    """Return one line for each reason why parameters are missing; the line names the reason and
    these parameters.
    """
    reasons: dict[str, list[str]] = {}
    for name, reason in result["not_applicable"].items():
        reasons.setdefault(reason, []).append(_letter(name))
    return [
        Text(f"{_MISSING} {', '.join(names)}: {reason}", style="dim")
        for reason, names in reasons.items()
    ]


def _letter(name: str) -> str:
    return (
        name.replace("_positive", "+")
        .replace("_negative", "−")
        .replace("B_mean", "B̄")
        .replace("_", " ")
    )


def _target_table(result: Mapping[str, Any]) -> Table:
    unit, digits = _UNITS.get(result["unit"], result["unit"]), _digits(result)
    table = Table(
        box=None,
        pad_edge=False,
        padding=(0, 2, 0, 0),
        header_style="bold",
        title=f"Targets, {unit}",
        title_justify="left",
    )
    for heading in (
        result["position_unit"],
        "mean +",
        "mean −",
        "s +",
        "s −",
        "B",
        "Ps" if "P" in result["parameters"] else "R",
    ):
        table.add_column(heading, justify="right", no_wrap=True)
    for target in result["targets"]:
        means = [
            number(target[key], digits, signed=True) for key in ("mean_positive", "mean_negative")
        ]
        spreads = [number(target[key], digits) for key in ("s_positive", "s_negative")]
        table.add_row(
            _position(target["position"]),
            *means,
            *spreads,
            number(target["reversal"], digits, signed=True),
            number(target["R"], digits),
        )
    return table


def _findings(findings: Sequence[Mapping[str, str]]) -> list[RenderableType]:
    if not findings:
        return []
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True)
    table.add_column(no_wrap=True)
    table.add_column(overflow="fold")
    order = {"error": 0, "warning": 1, "info": 2}
    for finding in sorted(findings, key=lambda entry: order.get(entry["severity"], 3)):
        style = _STYLES.get(finding["severity"], "")
        table.add_row(
            Text(finding["severity"], style=style),
            Text(finding["code"], style="dim"),
            Text(finding["message"]),
        )
    return [Text(), table]


def _errors(errors: Sequence[Mapping[str, str]]) -> RenderableType:
    lines = [
        Text(f"{error['file']}: {error['message']}" if error["file"] else error["message"])
        for error in errors
    ]
    title = Text("Not evaluated", style="bold red")
    return Group(
        Rule(title, align="left", characters="─", style="red"),
        *(Padding(line, (0, 0, 0, 2)) for line in lines),
    )
