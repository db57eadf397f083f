"""Random jobs on variations of the real FANUC backup by the hundred, judged by the virtual FANUC of
the tests.

``python benchmarks/bench_backups_fanuc.py [JOBS] [FIRST]``: 300 jobs by default, FIRST skips as
many of the deal; every fifth job has the whole backup, the others the part of it that matters. What
is written is loaded; every third time it is held against the plan (``compare``) and measured again
(``verify``); every fourth job of a plain backup is also made by ``new``. Prints every fault, then
the counts by mark, how many predictions held, and jobs a minute. Exit 1 where one is faulty, a
table made an axis worse, or 3 % or more of the plain jobs are refused.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from backup_deal_fanuc import deal, make
from backup_files_fanuc import FOLDER
from judge_fanuc import Outcome, judge, run_job
from judge_loaded_fanuc import judge_loaded, judge_new

JOBS = 300
WHOLE_EVERY = 5
NEW_EVERY = 4
LOADED_EVERY = 3
#: Families whose files say all that a job needs.
SAID_BY_FILES = {"as_it_is", "filled", "detection_units", "units_of_both_codings", "backlash"}
MOST_REFUSED = 0.03


def played(name: str, seed: int, turn: int) -> Outcome:
    with tempfile.TemporaryDirectory() as folder:
        found = run_job(make(name, seed, whole=turn % WHOLE_EVERY == 0), Path(folder))
        outcome = judge(found)
        if turn % LOADED_EVERY == 0:
            judge_loaded(outcome, found)
        said = name in SAID_BY_FILES and found.job.mark == "plain"
        if said and seed % NEW_EVERY == 0:
            judge_new(outcome, found)
    return outcome


def main(count: int, first: int) -> int:
    if not FOLDER.is_dir():
        print("skipped: the real FANUC backup is not beside the project")
        return 0
    marks: Counter[tuple[str, str]] = Counter()
    verdicts: Counter[str] = Counter()
    within: Counter[bool] = Counter()
    faulty = harm = 0
    start = time.perf_counter()
    for turn, (name, seed) in enumerate(deal(count, first)):
        outcome = played(name, seed, turn)
        whole = len(outcome.written) == len(outcome.job.axes)
        marks[outcome.job.mark, "written" if whole else "refused"] += 1
        verdicts.update(outcome.verdicts)
        within.update(outcome.within)
        if outcome.job.mark in ("plain", "answerable") and not whole:
            print(f"not written: {outcome}", flush=True)
        if outcome.faults:
            faulty += 1
            harm += any("HARM" in fault for fault in outcome.faults)
            print(f"FAULTY {outcome}", flush=True)
    speed = 60 * count / (time.perf_counter() - start)
    for (mark, what), number in sorted(marks.items()):
        print(f"{mark:>10} {what}: {number}")
    share = marks["plain", "refused"] / max(
        1, marks["plain", "refused"] + marks["plain", "written"]
    )
    print(f"plain ones refused: {100 * share:.1f} %; tables that made an axis worse: {harm}")
    print(f"A of a fresh test within the band of the prediction: {within[True]} of"
          f" {within.total()}; {dict(verdicts)}")  # fmt: skip
    print(f"{count} jobs, {faulty} faulty; {speed:.0f} jobs a minute")
    return int(faulty > 0 or share >= MOST_REFUSED)


if __name__ == "__main__":
    words = [int(word) for word in sys.argv[1:]]
    sys.exit(main(words[0] if words else JOBS, words[1] if words[1:] else 0))
