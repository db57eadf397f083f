"""The terminal output of ``run``, ``decode``, ``verify`` and ``demo``.

This module loads rich. A module for a command that may not print tables must import it inside a
function.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Final

from rich.console import RenderableType
from rich.rule import Rule
from rich.table import Table

from compwright.foundations.findings import DOUBTS_FIRST, next_step
from compwright.reporting.circular_parameters import squareness_limit
from compwright.reporting.limiting import limits_line
from compwright.reporting.numbers import (
    MISSING,
    decimals_of_unit,
    number,
    plain,
    symbol,
    unit_text,
)
from compwright.reporting.safe_text import Text
from compwright.reporting.sections import rule_lines, spread_text
from compwright.words.sentences import Sentence, say

_STYLES: Final = {
    "accept": "green",
    "good": "green",
    "loaded": "green",
    "reject": "red",
    "bad": "red",
    "not_active": "red",
    "measurement": "yellow",
    "undecided": "yellow",
    "error": "red",
    "warning": "yellow",
}
#: Rows of a table of corrections that a terminal shows without being asked; a longer table is cut
#: visibly.
_MOST_ROWS: Final = 60


def doubt_lines(
    doubts: Sequence[Mapping[str, str]], step: Sentence | None = None
) -> list[RenderableType]:
    """Return doubts with their heading and the next ``step`` for the terminal, or no lines if there
    are no doubts.
    """
    if not doubts:
        return []
    step = step or next_step(doubt["code"] for doubt in doubts)
    return [
        Rule(Text(str(DOUBTS_FIRST), style="bold yellow"), align="left", characters="━"),
        *finding_lines(doubts),
        *([Text(str(step))] if step else []),
        Text(),
    ]


def acknowledged_lines(acknowledged: Sequence[Mapping[str, str]]) -> list[RenderableType]:
    """Return the doubts that the job acknowledges, with their reasons, as lines; no lines if there
    are none.
    """
    if not acknowledged:
        return []
    table = finding_table()
    for entry in acknowledged:
        words = say(
            "doubts.acknowledged", reason=str(entry["reason"]), message=str(entry["message"])
        )
        table.add_row(_word(entry["severity"]), entry["code"], Text(str(words)))
    return [table, Text()]


def prediction_tables(prediction: Mapping[str, Any]) -> list[RenderableType]:
    """Return a table for each test of each axis: its measured and its predicted parameters."""
    shown: list[RenderableType] = []
    for name, axis in prediction["axes"].items():
        unit = unit_text(axis["unit"])
        first = axis["tests"][0]["name"]
        for test in axis["tests"]:
            accept = {
                key: entry
                for key, entry in axis["accept"].items()
                if entry.get("test", first) == test["name"]
            }
            shown += [
                Rule(
                    Text(f"axis {name} · test {test['name']}", style="bold"),
                    align="left",
                    characters="─",
                ),
                _prediction_table(test, accept, unit),
            ]
        shown += [Text(str(line)) for line in rule_lines(axis["accept"], unit)]
        shown.append(Text(_table_line(axis, unit)))
        limits = limits_line(axis)
        shown += [Text(limits)] if limits else []
        shown += [*finding_lines(axis["findings"]), Text()]
    return [*shown, *circle_tables(prediction["circles"])]


def _table_of_parameters(*headings: str) -> Table:
    """Return a table without rows. It has a column for parameter names, a column for each of the
    ``headings``, and a last column for a word such as the decision.
    """
    table = plain_table()
    table.add_column("", no_wrap=True)
    for heading in headings:
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("", no_wrap=True)
    return table


def _band(band: Mapping[str, Any] | None) -> tuple[str, str]:
    """Return two table cells for a predicted parameter: its median, and its 5-95 % range."""
    if not band:
        return MISSING, ""
    return number(band["median"]), f"{number(band['p05'])} to {number(band['p95'])}"


def _decision(entry: Mapping[str, Any] | None) -> tuple[str, str | Text]:
    """Return the table cells of a limit: its value and the decision on it."""
    return (plain(entry["limit"]), _word(entry["decision"])) if entry else ("", "")


def _prediction_table(test: Mapping[str, Any], accept: Mapping[str, Any], unit: str) -> Table:
    table = _table_of_parameters(
        f"before, {unit}", "predicted", "5 to 95 %", "new targets", "limit"
    )
    for name, value in test["before"].items():
        if value is None:
            continue
        table.add_row(
            symbol(name),
            number(value),
            *_band(test["predicted"].get(name)),
            _band(test["predicted_new_targets"].get(name))[0],
            *_decision(accept.get(name)),
        )
    return table


def _table_line(axis: Mapping[str, Any], unit: str) -> str:
    table = axis["table"]
    if table is None:
        return "No table is written; predicted is what happens without one."
    positions = table["positions"]
    values = [*table["correction_positive"], *table["correction_negative"]]
    if not positions:
        return "Table: none, backlash alone."
    return (
        f"Table: {len(positions)} points from {plain(positions[0])} to {plain(positions[-1])},"
        f" corrections {number(min(values))} to {number(max(values))} {unit}, as read back from the"
        " files."
    )


#: What the terminal shows of a circle, with its unit; the rest is in the report and the JSON.
_OF_CIRCLES = {
    "G_ccw": "µm",
    "G_cw": "µm",
    "G_bidirectional": "µm",
    "D": "µm",
    "squareness": "µm/m",
    "scale_mismatch": "µm",
    "backlash_first": "µm",
    "backlash_second": "µm",
    "servo_mismatch": "ms",
}


def circle_tables(circles: Mapping[str, Any]) -> list[RenderableType]:
    """Return a table for each circular test: its values before loading, the predicted values, and
    the values after loading if they were measured.
    """
    shown: list[RenderableType] = []
    for name, circle in circles.items():
        after, accept = circle.get("after"), circle.get("accept") or {}
        first, second = circle["axes"]
        names = {
            "backlash_first": f"lost motion {first}",
            "backlash_second": f"lost motion {second}",
        }
        limits = {**accept, **squareness_limit(circle)}
        table = plain_table()
        table.add_column("", no_wrap=True)
        headings = ["before", "predicted", "5 to 95 %", *(["after"] if after else []), ""]
        for heading in (*headings, *(["limit", ""] if limits else [])):
            table.add_column(heading, justify="right", no_wrap=True)
        for key, unit in {**_OF_CIRCLES, **dict.fromkeys(accept, "µm")}.items():
            value, band = circle["before"].get(key), (circle.get("predicted") or {}).get(key)
            if value is None:
                continue
            decimals = decimals_of_unit(unit)
            spread = spread_text(band, decimals)
            cells = [number(band["median"], decimals), str(spread)] if band else [MISSING, ""]
            measured = [number(after.get(key), decimals)] if after else []
            limit = _decision(limits.get(key)) if limits else ()
            table.add_row(
                names.get(key, key.replace("_", " ")),
                number(value, decimals),
                *cells,
                *measured,
                unit,
                *limit,
            )
        shown += [
            Rule(
                Text(f"circle {name} · {first}{second}", style="bold"), align="left", characters="─"
            ),
            table,
            *(Text(str(line)) for line in rule_lines(accept, "µm", after=after is not None)),
            Text(),
        ]
    return shown


def assumed_table(assumed: Sequence[Mapping[str, str]]) -> list[RenderableType]:
    """Return a table of the assumptions, or no table if nothing was assumed."""
    if not assumed:
        return []
    table = plain_table()
    table.add_column("Assumed", overflow="fold")
    table.add_column("value", overflow="fold")
    table.add_column("evidence", overflow="fold")
    for entry in assumed:
        table.add_row(entry["fact"], entry["value"], entry["evidence"])
    return [table, Text()]


def finding_lines(findings: Sequence[Mapping[str, str]]) -> list[RenderableType]:
    """Return findings as lines with their codes, the most severe first."""
    if not findings:
        return []
    order = {"error": 0, "warning": 1, "info": 2}
    table = finding_table()
    for finding in sorted(findings, key=lambda entry: order.get(entry["severity"], 3)):
        table.add_row(_word(finding["severity"]), finding["code"], Text(finding["message"]))
    return [table]


def finding_table() -> Table:
    """Return an empty table for findings: severity, code, text."""
    table = Table(box=None, show_header=False, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column(no_wrap=True)
    table.add_column(no_wrap=True, style="dim")
    table.add_column(overflow="fold")
    return table


def file_lines(title: str, files: Sequence[str]) -> list[RenderableType]:
    """Return the names of the written files as lines."""
    return [Text(title, style="bold"), *(Text(f"  {name}") for name in files)] if files else []


def decode_tables(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return the terminal output of ``decode``: corrections by axis, position and direction."""
    shown: list[RenderableType] = []
    for address, axis in document["axes"].items():
        unit = "10⁻³ mm or deg" if axis["unit"] is None else unit_text(axis["unit"])
        position = {"um": "mm", "arcsec": "deg"}.get(axis["unit"], "mm or deg")
        table = plain_table()
        for heading in (f"position, {position}", f"+ {unit}", f"− {unit}"):
            table.add_column(heading, justify="right", no_wrap=True)
        rows = list(
            zip(
                axis["positions"],
                axis["correction_positive"],
                axis["correction_negative"],
                strict=True,
            )
        )
        for where, positive, negative in rows[:_MOST_ROWS]:
            table.add_row(plain(where), number(positive, 3), number(negative, 3))
        shown += [
            Rule(
                Text(f"axis {address}: what the control adds to the command", style="bold"),
                align="left",
                characters="─",
            ),
            table,
        ]
        if len(rows) > _MOST_ROWS:
            shown.append(Text(f"({len(rows) - _MOST_ROWS} more rows: see --json)", style="dim"))
        shown.append(Text())
    return [*shown, *assumed_table(document["assumed"]), *finding_lines(document["findings"])]


def verification_tables(document: Mapping[str, Any]) -> list[RenderableType]:
    """Return the terminal output of ``verify``: for each axis the parameters before, predicted and
    after loading, and then the verdicts.
    """
    first = [doubt["message"] for doubt in document["doubts"]]

    def is_first(message: str) -> bool:
        return any(text.endswith(message) for text in first)

    shown: list[RenderableType] = []
    for name, axis in document["axes"].items():
        unit = unit_text(axis["unit"])
        within = "within ± U" if "predicted_U" in axis else "within"
        table = _table_of_parameters(
            f"before, {unit}", "predicted", "5 to 95 %", "after", within, "limit"
        )
        for parameter, value in axis["after"].items():
            if value is None:
                continue
            inside = axis["within_prediction"].get(parameter)
            table.add_row(
                symbol(parameter),
                number(axis["before"].get(parameter)),
                *_band(axis["predicted"].get(parameter)),
                number(value),
                "" if inside is None else "yes" if inside else "no",
                *_decision(axis["accept"].get(parameter)),
            )
        loading = axis["loading"]
        verdict = str(say("loading.name", name=loading["verdict"], detail=None))
        message = "" if is_first(loading["message"]) else f" {loading['message']}"
        shown += [
            Rule(
                Text(f"axis {name} · test {axis['test']}", style="bold"),
                align="left",
                characters="─",
            ),
            table,
            *(Text(str(line)) for line in rule_lines(axis["accept"], unit, after=True)),
            Text.assemble("Loading: ", _word(loading["verdict"], verdict), f".{message}"),
            *(Text(f"  look at: {sentence}") for sentence in loading.get("look_at", ())),
            *finding_lines([one for one in axis["findings"] if not is_first(one["message"])]),
            Text(),
        ]
    return [
        *shown,
        *circle_tables(document["circles"]),
        *finding_lines(
            [
                one
                if one["code"] == "CW-V034"
                else {**one, "message": f"Circle {name}: {one['message']}"}
                for name, circle in document["circles"].items()
                for one in circle["findings"]
                if one["code"] in ("CW-V034", "CW-V035") and not is_first(one["message"])
            ]
        ),
        *finding_lines([one for one in document["findings"] if one["severity"] == "error"]),
        _verdict(document["verdict"], document["headline"]),
    ]


def demo_tables(
    steps: Sequence[Any], document: Mapping[str, Any], pages: Sequence[str]
) -> list[RenderableType]:
    """Return the terminal output of ``demo``: steps with time and size, A of each axis, verdict,
    and the names of the ``pages`` to open.
    """
    done = plain_table()
    for right in (False, False, True, True, True):
        done.add_column(justify="right" if right else "left", no_wrap=True)
    done.show_header = False
    for number_of, step in enumerate(steps, 1):
        done.add_row(
            f"{number_of}. {step.what}",
            f"{step.folder}/",
            f"{step.files} files",
            f"{step.size / 1000:.0f} kB",
            f"{step.seconds:.1f} s",
        )
    values = _table_of_parameters("A before", "predicted", "5 to 95 %", "after", "limit")
    for name, axis in document["axes"].items():
        values.add_row(
            f"axis {name}, {unit_text(axis['unit'])}",
            number(axis["before"]["A"]),
            *_band(axis["predicted"]["A"]),
            number(axis["after"]["A"]),
            *_decision(axis["accept"]["A"]),
        )
    last = _verdict(document["verdict"], document["headline"], f". Open {', '.join(pages)}")
    return [done, values, last]


def _verdict(verdict: str, headline: str, last: str = "") -> RenderableType:
    """Return the line with the verdict and then ``last``. The ``headline`` is between them, unless
    it begins with the verdict itself.
    """
    more = "" if headline.lower().startswith(verdict) else f". {headline}"
    return Text.assemble("Verdict: ", _word(verdict), f"{more}{last}")


def next_lines(then: Mapping[str, Any] | None) -> list[RenderableType]:
    """Return lines on the next round for the terminal, or nothing if none was requested."""
    if then is None:
        return []
    heading = "Next round: " if then["written"] else "No next round: "
    return [
        Text.assemble((heading, "bold"), f"{then['reason']}."),
        *(Text(f"  axis {name}: {axis['reason']}") for name, axis in then["axes"].items()),
        *(Text(f"  {line}") for line in then["between"]),
    ]


def plain_table() -> Table:
    """Return an empty table without frames, for the terminal."""
    return Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold")


def _word(word: str, shown: str = "") -> Text:
    return Text(shown or word.replace("_", " "), style=_STYLES.get(word, ""))
