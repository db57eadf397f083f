"""Damaged control files by the million: refused, or a table on which both readers agree. Judges
nothing, prints what is neither.

``python benchmarks/bench_fuzz.py [TRIALS] [SEED]`` (1 000 000 and 1 by default, shared by the
formats). Prints, by format: refused, agreed, and failures by their sentence with one example each,
and the longest time that one set of files took.
"""

from __future__ import annotations

import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from compwright.foundations.errors import InputError, UsageError
from damage import SAMPLES, damaged, read

TRIALS = 1_000_000


def one_format(format_id: str, count: int, seed: int) -> None:
    """Do ``count`` trials of one format and print what came of them."""
    samples = [sample for sample in SAMPLES if sample.format_id == format_id]
    counts: Counter[str] = Counter()
    examples: dict[str, str] = {}
    longest, start = 0.0, time.perf_counter()
    for trial in range(count):
        sample = samples[trial % len(samples)]
        files = damaged(sample, seed * 10_000_000 + trial)
        began = time.perf_counter()
        try:
            read(sample, files)
        except (InputError, UsageError) as error:
            counts["ambiguous" if "read in two ways" in str(error) else "refused"] += 1
        except Exception as error:  # noqa: BLE001 - what else there is, is what is looked for
            counts["failed"] += 1
            key = f"{type(error).__name__}: {error}"[:100]
            examples.setdefault(key, f"{sample}, trial {trial}: {[file.content for file in files]}")
        else:
            counts["agreed"] += 1
        longest = max(longest, time.perf_counter() - began)
    seconds = time.perf_counter() - start
    print(
        f"{format_id}: {counts['refused']} refused, {counts['ambiguous']} of two meanings,"
        f" {counts['agreed']} agreed, {counts['failed']} failed; {count / seconds:.0f} trials/s,"
        f" the longest {longest * 1000:.0f} ms"
    )
    for key, example in examples.items():
        print(f"  {key}\n    {example}")


def main() -> None:
    """Share the trials among the formats."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else TRIALS
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    formats = sorted({sample.format_id for sample in SAMPLES})
    for format_id in formats:
        one_format(format_id, max(1, count // len(formats)), seed)


if __name__ == "__main__":
    main()
