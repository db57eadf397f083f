"""Some hundred jobs on variations of a real SINUMERIK archive, before a virtual control that shares
nothing with the package.

python benchmarks/bench_backups_sinumerik.py [COUNT]        (default 300)

Prints every harm, and how many were written and refused. Exit 1: a job did harm, a plain one was
refused, or below 60 % written.
"""

from __future__ import annotations

import contextlib
import io
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from backup_cases_sinumerik import Case
from backup_variations_sinumerik import case_of, named, nothing
from compwright.cli import run as compwright
from sinumerik_archive import ARCHIVE, member, put
from sinumerik_judge import try_case


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


def main(count: int) -> int:
    if not ARCHIVE.is_file():
        print(f"skipped: {ARCHIVE} is not there")
        return 0
    cases = [whole(), *(case_of(seed) for seed in range(count))]
    tally: Counter[tuple[str, str]] = Counter()
    harms = 0
    for case in cases:
        with tempfile.TemporaryDirectory() as folder:
            outcome = try_case(case, Path(folder), run)
        tally[outcome.case.mark, "written" if outcome.written else "refused"] += 1
        if outcome.harms:
            harms += 1
            print(outcome.line())
    written = sum(number for (_, what), number in tally.items() if what == "written")
    for (mark, what), number in sorted(tally.items()):
        print(f"{mark:12} {what:8} {number:4}")
    print(
        f"{len(cases)} jobs, {written} written ({100 * written / len(cases):.0f} %), {harms} with"
        " harm"
    )
    return int(harms > 0 or written < 0.6 * len(cases))


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 300))
