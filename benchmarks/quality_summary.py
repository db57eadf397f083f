"""What came out of the virtual axes of ``table_quality.py``: coverage, widths, ratios, periods."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Record = dict[str, Any]

PARAMETERS = ("A", "E", "R", "B", "M")
RIVALS = ("informed", "interpolation", "spline", "minimax")


def found(record: Record) -> tuple[list[bool], int]:
    """Return which of the true periods were named (probability above 0.5; within 2 % or
    0.3 P²/L), and how many names are wrong: near no true one, nor one that was told. Half or twice
    a true period is wrong: no virtual machine has a second harmonic above its first.
    """
    named = [
        p["period"] for p in record["periods"] if p["source"] == "found" and p["probability"] > 0.5
    ]

    def near(value: float, true: float) -> bool:
        return bool(abs(value - true) <= max(0.02 * true, 0.3 * true**2 / record["length"]))

    right = [any(near(value, true) for value in named) for true in record["truth"]]
    known = [*record["truth"], *record["told"]]
    return right, sum(not any(near(value, one) for one in known) for value in named)


def coverage(
    records: Sequence[Record], where: str, names: Sequence[str], whose: str = "bands"
) -> float:
    """Return how often a fresh parameter lies in its band, in %."""
    held: list[float] = []
    for one in records:
        for name in names:
            band, values = one[whose][where].get(name), one["fresh"][where].get(name)
            if band and values:
                held.append(float(np.mean([band[0] <= value <= band[2] for value in values])))
    return 100 * float(np.mean(held)) if held else float("nan")


def beyond(records: Sequence[Record], where: str, name: str) -> tuple[float, float]:
    """Return how often a parameter lies below and above its band, in %."""
    low, high = [], []
    for one in records:
        band, values = one["bands"][where].get(name), one["fresh"][where].get(name)
        if band and values:
            low.append(np.mean([value < band[0] for value in values]))
            high.append(np.mean([value > band[2] for value in values]))
    return (100 * float(np.mean(low)), 100 * float(np.mean(high))) if low else (np.nan, np.nan)


def against(records: Sequence[Record], name: str) -> float:
    """Return the mean ratio of A at new targets to that of the oracle of as many tables."""
    ratios = []
    for one in records:
        oracle = "oracle, one table" if one["kind"].endswith("one table") else "oracle"
        ratios.append(one["merit"]["new"][name] / one["merit"]["new"][oracle])
    return float(np.mean(ratios)) if ratios else float("nan")


def over_judge(records: Sequence[Record], judge: str) -> str:
    """Return the mean A of our table over that of a ``judge`` (ratio of the means of A over the
    oracle's), with its standard error; empty where the judge has no table.

    Error of a ratio of two means: Cochran, Sampling Techniques, 3rd ed. 1977, chapter 6.
    """
    rows = [one for one in records if judge in one["merit"]["new"]]
    if len(rows) < 2:
        return ""
    kinds = [one["kind"] for one in rows]
    oracles = ["oracle, one table" if kind.endswith("one table") else "oracle" for kind in kinds]
    merits = [one["merit"]["new"] for one in rows]
    mine, theirs = (
        np.array([one[name] / one[best] for one, best in zip(merits, oracles, strict=True)])
        for name in ("ours", judge)
    )
    ratio = mine.mean() / theirs.mean()
    error = np.std(mine - ratio * theirs, ddof=1) / theirs.mean() / np.sqrt(len(rows))
    return f"{ratio:.2f} ± {error:.2f}"


def width(records: Sequence[Record], names: Sequence[str]) -> float:
    """Return the mean width of our bands over that of who knows the noise."""
    ratios = []
    for one in records:
        for where in ("same", "new"):
            for name in names:
                band, other = one["bands"][where].get(name), one["informed"][where].get(name)
                if band and other:
                    ratios.append((band[2] - band[0]) / (other[2] - other[0]))
    return float(np.mean(ratios)) if ratios else float("nan")


HEAD = (
    "| kind | n | holds, same targets | holds, new targets | width | A: ours | informed |"
    " interpolation | spline | minimax | ours over informed | ours over period unknown | s |"
)


def summary(name: str, records: Sequence[Record]) -> Record:
    """Return the numbers of a kind: how often bands hold in % and their width, all parameters and A
    alone; A as ratio to the oracle's, ours and the rivals'; periods named of those not given.
    """
    good = [one for one in records if "failed" not in one]
    right = [hit for one in good if not one["told"] for hit in found(one)[0]]
    return {
        "kind": name,
        "axes": len(good),
        **{
            where: [_round(coverage(good, where, names), 0) for names in (PARAMETERS, ["A"])]
            for where in ("same", "new")
        },
        "width": [_round(width(good, names), 2) for names in (PARAMETERS, ["A"])],
        "A": [_round(against(good, table), 2) for table in ("ours", *RIVALS)],
        "periods": [sum(right), len(right)] if right else None,
        "wrong": sum(found(one)[1] > 0 for one in good),
    }


def _round(value: float, digits: int) -> float | None:
    return round(value, digits) if np.isfinite(value) else None


def row(name: str, records: Sequence[Record]) -> str:
    """Return the line of a kind in the printed table."""
    failed = sum("failed" in one for one in records)
    seconds = [one["seconds"] for one in records if "failed" not in one]
    found_here = summary(name, records)
    cells = [name, f"{len(seconds)}" + (f" ({failed} failed)" if failed else "")]
    cells += [pair(found_here[where], 0) for where in ("same", "new")]
    cells.append(pair(found_here["width"], 2))
    cells += ["" if value is None else f"{value:.2f}" for value in found_here["A"]]
    good = [one for one in records if "failed" not in one]
    cells += [over_judge(good, "informed"), over_judge(good, "period unknown")]
    cells.append(f"{np.median(seconds):.2f}" if seconds else "")
    return "| " + " | ".join(cells) + " |"


def pair(values: Sequence[float | None], digits: int) -> str:
    """Return a value of all parameters, with that of A alone in brackets."""
    every, alone = ("" if value is None else f"{value:.{digits}f}" for value in values)
    return f"{every} ({alone})" if alone else every


def periods_row(name: str, records: Sequence[Record]) -> str:
    """Return how many of the periods nobody told were named, and on how many axes a wrong one."""
    found_here = summary(name, records)
    right, of = found_here["periods"] or (0, 0)
    named = f"{100 * right / of:.0f} % of {of}" if of else ""
    return f"| {name} | {named} | {found_here['wrong']} of {found_here['axes']} |"


def show(records: Sequence[Record], kinds: Sequence[str], *, details: bool) -> None:
    """Print the tables; ``details``: how often each parameter lies below and above its band."""
    groups = {kind: [one for one in records if one["kind"] == kind] for kind in kinds}
    groups = {kind: some for kind, some in groups.items() if some}
    groups["all"] = [one for some in groups.values() for one in some]
    print(HEAD)
    print("|---" * HEAD.count(" | ") + "|---|")
    for kind, some in groups.items():
        print(row(kind, some))
    print("\n| kind | periods named | axes with a wrong one |\n|---|---|---|")
    for kind, some in groups.items():
        if kind == "all" or not all(one.get("told", True) for one in some):
            print(periods_row(kind, some))
    if details:
        for kind, some in groups.items():
            _misses(kind, [one for one in some if "failed" not in one])
    for one in groups["all"]:
        if "failed" in one:
            print(f"failed: {one['kind']} {one['number']}: {one['failed'][:200]}")


def _misses(kind: str, good: Sequence[Record]) -> None:
    for where in ("same", "new"):
        parts = [
            f"{name} {low:.0f}/{high:.0f}"
            for name in PARAMETERS
            for low, high in [beyond(good, where, name)]
            if np.isfinite(low)
        ]
        print(f"{kind}, {where}: below/above the band in %: {', '.join(parts)}")
    judge = [coverage(good, where, PARAMETERS, "informed") for where in ("same", "new")]
    print(f"{kind}: the judge's bands hold {judge[0]:.0f} and {judge[1]:.0f} %")
