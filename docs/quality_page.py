# ruff: noqa: E501 - a paragraph of the page is one line
"""The page of quality with its figures, made from the numbers in `quality.json`.

python docs/quality_page.py                                    page and figures anew
python docs/quality_page.py --tables T.jsonl --faults F.jsonl  the numbers too, from results
                                                               that the benchmarks have saved
"""

from __future__ import annotations

import argparse
import datetime as dt
import json
import subprocess
import sys
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS.parent / "benchmarks"))

from fault_summary import BANDS  # noqa: E402 - the line above makes it findable
from machine_kinds import KINDS  # noqa: E402
from quality_summary import pair, summary  # noqa: E402

Record = dict[str, Any]
#: A kind whose bands hold less often than this (%) is named as not held.
HELD = 80
TABLES = ("ours", "best possible", "interpolation", "spline", "least A of the test")
COLOURS = ("#1b6ca8", "#7a7a7a", "#d08a1d", "#b5523b", "#6b4c9a")


def data() -> Record:
    """Return the numbers that are kept."""
    return dict(json.loads((DOCS / "quality.json").read_text(encoding="utf-8")))


def pages() -> dict[str, str]:
    """Return page and figures by their names."""
    kept = data()
    rows = kept["tables"]["rows"]
    return {
        "quality.md": quality_page(kept),
        "quality-bands.svg": figure(
            "Fresh values inside the predicted band, %",
            [(row["kind"], [row["same"][0], row["new"][0]]) for row in rows],
            ("same targets", "new targets"),
            (40, 100, 10),
            90,
        ),
        "quality-tables.svg": figure(
            "A at new targets, relative to a table that knows the truth",
            [(row["kind"], row["A"]) for row in rows],
            TABLES,
            (0.5, 4.0, 0.5),
            1.0,
        ),
    }


def quality_page(kept: Record) -> str:
    """Return the page."""
    tables, faults = kept["tables"], kept["faults"]
    rows = tables["rows"]
    whole = rows[0]
    unheld = [row["kind"] for row in rows if min(row["same"][0], row["new"][0]) < HELD]
    named = [
        f"{row['kind']}: {row['periods'][0]} of {row['periods'][1]}"
        for row in rows[1:]
        if row["periods"]
    ]
    head = ("kind of axis", "axes", "holds, same", "holds, new", "width", *TABLES)
    body = [
        [
            row["kind"],
            str(row["axes"]),
            *(pair(row[where], 0) for where in ("same", "new")),
            pair(row["width"], 2),
            *(f"{value:.2f}" for value in row["A"]),
        ]
        for row in rows
    ]
    near, far = faults["near"], faults["far"]
    later = tables["unmeasured"]
    lost = sorted(KINDS.keys() - {row["kind"] for row in rows} - set(later))
    rest = f" Kinds added since, not measured: {'; '.join(later)}." if later else ""
    if lost:
        rest += f" Numbers of {len(rows) - 1} of {len(KINDS) - len(later)} measured kinds were kept. Those of the other {whole['axes'] - sum(row['axes'] for row in rows[1:])} axes are in *all* only: {'; '.join(lost)}."
    return f"""# How good the table is, and how honest the prediction

Made by `make quality` from `docs/quality.json`. Tables: {whole["axes"]} virtual axes, measured {tables["date"]} on commit {tables["commit"]}. Loading faults: {faults["date"]} on commit {faults["commit"]}. What later commits changed is not in these numbers.{rest}

Each virtual axis is measured and gets the tool's table and prediction; 8 fresh tests each at the same and at new targets follow with the table in the control. A kind of 30 axes is uncertain by 2 to 4 points.

## Does the predicted band hold?

A band of 5 to 95 % should hold 90 % of fresh values. All kinds: {whole["same"][0]:.0f} % at the same targets, {whole["new"][0]:.0f} % at new ones. **Below {HELD} %: {"; ".join(unheld) or "none"}.** A drift that is different in the fresh test is not in the band of a single test. Where one traverse in ten is off, a third of the first tests show none; their bands hold 60 %, also those of a judge who knows all else (`benchmarks/bench_rare_shift.py`).

![How often the band holds, by kind of axis](quality-bands.svg)

## How good is the table?

All kinds: A is {whole["A"][0]:.2f} times that of a table that knows the truth. Straight lines between the means reach {whole["A"][2]:.2f}, a smoothing spline {whole["A"][3]:.2f}, the table with the least A of the measured test {whole["A"][4]:.2f}. *Best possible* is a judge who knows the noise and saw the same readings.

![A at new targets, by kind of axis and table](quality-tables.svg)

## Numbers

*Holds*: % of A, E, R, B and M (A alone in brackets). *Width* of the bands, relative to the judge's. Then A at new targets.

| {" | ".join(head)} |
{"|---" * len(head)}|
{chr(10).join("| " + " | ".join(cells) + " |" for cells in body)}

Unknown periods that were named: {"; ".join(named)}. A wrong period was named on {whole["wrong"]} of {whole["axes"]} axes; on rough curves (random walks, jumps) on 2 to 9 % (`benchmarks/bench_periods.py`, commit 219310a7).

## Is a loading fault found?

{faults["cases"]} faults on virtual axes of seven controls: {faults["wrong"]} wrong names. Named rightly: {far[0]} of {far[1]} where the next name is 8 standard errors or more away, {near[0]} of {near[1]} below that. The others stay open, with the test that would decide.

## New numbers

    python benchmarks/table_quality.py 20 --results tables.jsonl     # hours; --seconds 3600 stops, the same command goes on
    python benchmarks/loading_faults.py --results faults.jsonl
    make quality TABLES=tables.jsonl FAULTS=faults.jsonl
"""


def figure(
    title: str,
    rows: Sequence[tuple[str, Sequence[float]]],
    series: Sequence[str],
    scale: tuple[float, float, float],
    wanted: float,
) -> str:
    """Return a figure of points: a line for each row, a colour for each of the series."""
    low, high, step = scale
    left, right, top, line = 250, 740, 58, 17
    bottom = top + line * len(rows)

    def across(value: float) -> float:
        return left + (right - left) * (min(max(value, low), high) - low) / (high - low)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 765 {bottom + 26}" font-family="sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="white"/>',
        f'<text x="10" y="20" font-size="14">{escape(title)}</text>',
    ]
    for i, (name, colour) in enumerate(zip(series, COLOURS, strict=False)):
        parts.append(f'<circle cx="{left + 110 * i - 80}" cy="38" r="4" fill="{colour}"/>')
        parts.append(f'<text x="{left + 110 * i - 72}" y="42">{escape(name)}</text>')
    for number in range(round((high - low) / step) + 1):
        x = across(low + number * step)
        parts.append(
            f'<path d="M{x:.1f} {top - 6}V{bottom}" stroke="#ddd"/>'
            f'<text x="{x:.1f}" y="{bottom + 16}" text-anchor="middle">{low + number * step:g}</text>'
        )
    parts.append(f'<path d="M{across(wanted):.1f} {top - 6}V{bottom}" stroke="#333"/>')
    for i, (name, values) in enumerate(rows):
        y = top + line * i + 6
        parts.append(f'<text x="{left - 12}" y="{y + 4}" text-anchor="end">{escape(name)}</text>')
        for value, colour in reversed(list(zip(values, COLOURS, strict=False))):
            parts.append(
                f'<circle cx="{across(value):.1f}" cy="{y}" r="4" fill="{colour}" opacity="0.8"/>'
            )
    return "\n".join([*parts, "</svg>"]) + "\n"


def tables_of(records: Sequence[Record]) -> list[Record]:
    """Return the numbers of all axes and of each kind."""
    kinds = dict.fromkeys(one["kind"] for one in records)
    groups = {kind: [one for one in records if one["kind"] == kind] for kind in kinds}
    return [summary("all", records), *(summary(kind, some) for kind, some in groups.items())]


def faults_of(records: Sequence[Record]) -> Record:
    """Return the counts of loading faults, near and far from the next name."""
    cases = [one for one in records if "fault" in one]
    far = [one["outcome"] == "right" for one in cases if one["apart"] >= BANDS[-1][0]]
    near = [one["outcome"] == "right" for one in cases if one["apart"] < BANDS[-1][0]]
    return {
        "cases": len(cases),
        "wrong": sum(one["outcome"] == "wrong" for one in cases),
        "far": [sum(far), len(far)],
        "near": [sum(near), len(near)],
    }


def main() -> None:
    """Renew what was asked for, then write page and figures."""
    reader = argparse.ArgumentParser(description="Page and figures of quality.")
    reader.add_argument("--tables", type=Path, help="results of table_quality.py")
    reader.add_argument("--faults", type=Path, help="results of loading_faults.py")
    words = reader.parse_args()
    kept = data()
    git = ["git", "-C", str(DOCS), "rev-parse", "--short", "HEAD"]
    for name, file in (("tables", words.tables), ("faults", words.faults)):
        if file:
            lines = file.read_text(encoding="utf-8").splitlines()
            records = [json.loads(line) for line in lines]
            measured = {one["kind"] for one in records}
            found = (
                {"unmeasured": sorted(KINDS.keys() - measured), "rows": tables_of(records)}
                if name == "tables"
                else faults_of(records)
            )
            asked = subprocess.run(git, check=True, capture_output=True, text=True)  # noqa: S603 - fixed words
            commit = asked.stdout.strip()
            kept[name] = {"date": f"{dt.datetime.now(dt.UTC).date()}", "commit": commit, **found}
    if words.tables or words.faults:
        (DOCS / "quality.json").write_text(written(kept), encoding="utf-8")
    for name, text in pages().items():
        (DOCS / name).write_text(text, encoding="utf-8")


def written(kept: Record) -> str:
    """Return the numbers as JSON, a line for each kind."""
    parts = [json.dumps(row, ensure_ascii=False) for row in kept["tables"]["rows"]]
    head = json.dumps({**kept["tables"], "rows": []})[:-2]
    return (
        f'{{"tables": {head}\n'
        + ",\n".join(parts)
        + f']}},\n"faults": {json.dumps(kept["faults"])}}}\n'
    )


if __name__ == "__main__":
    main()
