"""The tables of ``loading_faults.py``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

Record = dict[str, Any]

BANDS = ((0.0, 2.0), (2.0, 4.0), (4.0, 8.0), (8.0, float("inf")))
HEAD = "| {} | n | right | of them another value | undecided | wrong | alike | failed |"


def band_of(value: float) -> str:
    """Return the band of a distance, in words."""
    low, high = next(band for band in BANDS if band[0] <= value < band[1])
    if not low:
        return f"below {high:g}"
    return f"{low:g} to {high:g}" if high < 1e9 else f"{low:g} and more"


def row(name: str, records: Sequence[Record]) -> str:
    """Return a line: numbers, and shares in % behind them."""
    counts = Counter(one["outcome"] for one in records)
    total = len(records)

    def cell(outcome: str) -> str:
        number = counts[outcome]
        return f"{number} ({100 * number / total:.1f} %)" if number else "0"

    other = sum(one["outcome"] == "right" and not one["value_right"] for one in records)
    cells = [name, str(total), cell("right"), str(other)]
    cells += [cell(outcome) for outcome in ("undecided", "wrong", "alike", "failed")]
    return "| " + " | ".join(cells) + " |"


def table(title: str, records: Sequence[Record], key: Callable[[Record], str]) -> None:
    """Print a table by a key."""
    head = HEAD.format(title)
    print("\n" + head)
    print("|---" * (head.count("|") - 1) + "|")
    for name in sorted({key(one) for one in records}):
        print(row(name, [one for one in records if key(one) == name]))
    print(row("all", records))


def show(records: Sequence[Record], *, every: bool) -> None:
    """Print all tables; ``every``: also each case that is not right."""
    cases = [one for one in records if "fault" in one]
    for one in records:
        if "fault" not in one:
            print(f"job {one['job']}: {one['outcome']} {one['message'][:200]}")
    if not cases:
        return
    far = [one for one in cases if one["apart"] >= BANDS[-1][0]]
    near = [one for one in cases if one["apart"] < BANDS[-1][0]]
    for title, some, key in (
        ("apart", cases, lambda one: band_of(one["apart"])),
        ("apart (variants)", cases, lambda one: band_of(one["variants"])),
        ("fault", cases, lambda one: one["fault"]),
        ("fault, 8 and more apart", far, lambda one: one["fault"]),
        ("how, 8 and more apart", far, _how),
        ("kind of axis, 8 and more apart", far, lambda one: one["kind"]),
        ("control, 8 and more apart", far, lambda one: one["control"]),
        ("fault, less than 8 apart", near, lambda one: one["fault"]),
    ):
        if some:
            table(title, some, key)
    _good_by_mistake(cases)
    if every:
        print()
        for one in cases:
            if one["outcome"] != "right" or not one["value_right"]:
                print(_line(one))


def _good_by_mistake(cases: Sequence[Record]) -> None:
    """Print the tests with a fault whose whole verification is good, and not by an equivalent."""
    good = [
        one
        for one in cases
        if one.get("overall") == "good" and one["fault"] != "loaded" and one["outcome"] != "right"
    ]
    print(f"\ngood in spite of a fault: {len(good)}")
    for one in good:
        print("  " + _line(one))


def _how(one: Record) -> str:
    made = "changed files" if one["words"].startswith("files:") else "as decoded"
    return f"{made}, old table: {one['old']}"


def _line(one: Record) -> str:
    return (
        f"job {one['job']} test {one['test']} {one['axis']} ({one['kind']}, {one['control']}): "
        f"{one['fault']} {one['words']}, {one['apart']:.1f} ({one['variants']:.1f} from "
        f"{one['nearest']}) -> {one['outcome']} {one.get('verdict', '')} "
        f"{','.join(one.get('equivalent', []))}: {one['message'][:240]}"
    )
