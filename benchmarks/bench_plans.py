"""Random plans by the thousand: fitted, written, read by the judge; every table the same to the
last quantum. Judges nothing.

``python benchmarks/bench_plans.py [PLANS]`` (10 000 by default, shared by the formats). Prints, by
format: plans written and refused, the largest difference between the fitted table and the judge's
reading, plans a second, and every plan that differs.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from plans import ADDRESSES, random_plan, tolerance, worst_difference

PLANS = 10_000


def one_format(format_id: str, count: int) -> None:
    """Do ``count`` plans of one format and print what came of them."""
    counts: Counter[str] = Counter()
    worst = 0.0
    start = time.perf_counter()
    for seed in range(count):
        plan = random_plan(format_id, seed)
        if plan.table is None:
            counts["refused"] += 1
            continue
        difference = worst_difference(plan)
        worst = max(worst, difference)
        counts["written"] += 1
        if difference > tolerance(format_id):
            counts["different"] += 1
            print(f"{format_id}: seed {seed} differs by {difference:g}: {plan.axis}")
    speed = count / (time.perf_counter() - start)
    print(
        f"{format_id}: {counts['written']} written, {counts['refused']} refused,"
        f" {counts['different']} different; largest difference {worst:.2g} mm or deg; {speed:.0f}"
        " plans/s"
    )


def main() -> None:
    """Share the plans among the formats."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else PLANS
    for format_id in ADDRESSES:
        one_format(format_id, max(1, count // len(ADDRESSES)))


if __name__ == "__main__":
    main()
