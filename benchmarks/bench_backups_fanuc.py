"""Random jobs on variations of the real FANUC backup by the hundred, judged by the virtual FANUC of
the tests.

``python benchmarks/bench_backups_fanuc.py [JOBS] [FIRST]``: 300 jobs by default, FIRST skips as
many of the deal; every fifth job has the whole backup, the others the part of it that matters.
Prints every fault, then how many jobs were written, refused and faulty, and jobs a minute. Exit 1
where one is faulty or less than 60 % are written.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from backup_deal_fanuc import deal, make
from backup_files_fanuc import FOLDER
from judge_fanuc import play

JOBS = 300
WHOLE_EVERY = 5


def main(count: int, first: int) -> int:
    if not FOLDER.is_dir():
        print("skipped: the real FANUC backup is not beside the project")
        return 0
    written = faulty = 0
    start = time.perf_counter()
    for turn, (name, seed) in enumerate(deal(count, first)):
        with tempfile.TemporaryDirectory() as folder:
            outcome = play(make(name, seed, whole=turn % WHOLE_EVERY == 0), Path(folder))
        written += len(outcome.written) == len(outcome.job.axes)
        if outcome.faults:
            faulty += 1
            print(outcome, flush=True)
    speed = 60 * count / (time.perf_counter() - start)
    print(
        f"{count} jobs: {written} written, {count - written} refused, {faulty} faulty; {speed:.0f}"
        " jobs a minute"
    )
    return int(faulty > 0 or written < 0.6 * count)


if __name__ == "__main__":
    words = [int(word) for word in sys.argv[1:]]
    sys.exit(main(words[0] if words else JOBS, words[1] if words[1:] else 0))
