"""A secret at every place of every sample, one after the other: in no copy is anything left of it.

    python benchmarks/bench_redaction.py [--cases N] [--seed N]

Each case takes one sample of `tests/redaction_samples.py` without its secrets, or the sample of a
definition, puts a secret in, before, behind or in the place of a piece of one of its lines, or into
a line of its own, and copies it. Counted are copies that are clean, files that were refused, and
leaks: copies in whose bytes the secret stands. Exit 1 where there is a leak, or an exception that
is no error of compwright's.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from redaction_cases import case, samples


def main() -> int:
    """Run the cases and print how they came out."""
    words = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    words.add_argument("--cases", type=int, default=5000)
    words.add_argument("--seed", type=int, default=0)
    given = words.parse_args()
    sets = samples()
    outcomes: Counter[str] = Counter()
    for number in range(given.seed, given.seed + given.cases):
        outcome, told = case(sets, number)
        outcomes[outcome] += 1
        if told:
            print(told)
    print(", ".join(f"{count} {outcome}" for outcome, count in sorted(outcomes.items())))
    return 1 if outcomes["leak"] or outcomes["exception"] else 0


if __name__ == "__main__":
    sys.exit(main())
