"""Some hundred jobs on variations of a real SINUMERIK archive, before a virtual control that shares
nothing with the package: half of them the older deal, half the wider one.

python benchmarks/bench_backups_sinumerik.py [COUNT [FIRST]]        (default 300 from seed 0)

Prints every harm, and how many were written and refused. Exit 1: a job did harm, a plain one was
refused, or below 60 % written.
"""

from __future__ import annotations

import contextlib
import io
import itertools
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from backup_cases_sinumerik import Case
from backup_deal_sinumerik import dealt
from backup_variations_sinumerik import case_of, named, nothing
from compwright.cli import run as compwright
from sinumerik_archive import ARCHIVE, member, put
from sinumerik_follow import follow
from sinumerik_judge import Outcome, try_case


def run(arguments: list[str]) -> tuple[int, str]:
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = compwright(arguments)
    return code, err.getvalue() + out.getvalue()


def whole() -> Case:
    """The machine data as they stand, 38 000 lines; temperature compensation is on for X, Y and Z
    (MD32750): a rotary axis.
    """
    case = named(nothing, axis="AX5")
    case.md = put(
        member("INITIAL.INI").decode("latin-1"), "$MA_MM_ENC_COMP_MAX_POINTS[1,AX5]", "61"
    )
    return case


def judged(case: Case) -> Outcome:
    with tempfile.TemporaryDirectory() as folder:
        outcome = try_case(case, Path(folder), run)
        follow(outcome, Path(folder), run)
    return outcome


def main(count: int, first: int) -> int:
    if not ARCHIVE.is_file():
        print(f"skipped: {ARCHIVE} is not there")
        return 0
    half = count // 2
    deals = itertools.chain(
        map(case_of, range(first, first + half)), map(dealt, range(first, first + count - half))
    )
    tally: Counter[tuple[str, str]] = Counter()
    jobs = harms = inside = worse = 0
    for case in itertools.chain([] if first else [whole()], deals):
        outcome = judged(case)
        jobs += 1
        tally[outcome.case.mark, "written" if outcome.written else "refused"] += 1
        worse += outcome.written and outcome.after >= outcome.before
        inside += outcome.written and outcome.band[0] <= outcome.after <= outcome.band[1]
        if outcome.harms:
            harms += 1
            print(outcome.line())
    written = sum(number for (_, what), number in tally.items() if what == "written")
    for (mark, what), number in sorted(tally.items()):
        print(f"{mark:12} {what:8} {number:4}")
    print(
        f"{jobs} jobs, {written} written ({100 * written / jobs:.0f} %), {harms} with harm,"
        f" {worse} made worse, {inside} within the prediction"
    )
    return int(harms > 0 or written < 0.6 * jobs)


if __name__ == "__main__":
    words = [int(word) for word in sys.argv[1:]]
    sys.exit(main(words[0] if words else 300, words[1] if words[1:] else 0))
