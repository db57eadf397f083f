"""Damaged inputs by the million: every reader, jobs, plans, records, profiles, virtual machines,
definitions, and the files of every control (there both readers must agree).

``python benchmarks/bench_inputs.py [--seconds S] [--seed N] [--only WORD]... [--results FILE]``:
every sample is damaged and read for as long (``--seconds`` are shared by all). Counts by outcome:

- same, other: read; the same number of readings and no new warning, or otherwise
- refused (2, 3, ...): by the exit code of the error
- FAILED: any other error
- HUNG: longer than 5 s
- SHORTENED: fewer readings than a bystander counts in the damaged text, and no warning

``--results`` adds the counts to those of earlier slices. Ends with 1 where anything failed.
"""

from __future__ import annotations

import argparse
import json
import random
import signal
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from types import FrameType
from typing import Any

from mutated_samples import Sample, samples

from compwright.cli import run
from compwright.foundations.errors import CompwrightError

LONGEST = 5.0
EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
FOUND = ("FAILED", "HUNG", "SHORTENED")


class _Hung(BaseException):
    """Raised into a reader that does not end; no reader catches it."""


@contextmanager
def _no_longer_than(seconds: float) -> Iterator[None]:
    if not hasattr(signal, "setitimer"):  # there a hang stays one
        yield
        return
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def _stop(_number: int, _frame: FrameType | None) -> None:
    raise _Hung


def outcome(sample: Sample, damage: Any, sound: Any) -> tuple[str, str]:
    """Return what came of a damaged input and, of what should not be, why."""
    try:
        with _no_longer_than(LONGEST):
            found = sample.read(damage)
    except CompwrightError as error:
        code = type(error).exit_code
        return (f"refused ({code})", "") if code != 70 else ("FAILED", str(error))
    except _Hung:
        return "HUNG", "no end"
    except Exception as error:  # noqa: BLE001 - what else there is, is what is looked for
        return "FAILED", f"{type(error).__name__}: {error}"[:120]
    if sample.readings is None or sample.judge is None:
        return "read", ""
    read, stands = sample.readings(found), sample.judge(damage)
    new = sample.told(found) - sample.told(sound)
    if read < stands and not new:
        return "SHORTENED", f"{read} of {stands} readings"
    return ("same" if read == sample.readings(sound) and not new else "other"), ""


def documents() -> tuple[dict[str, bytes], dict[str, bytes]]:
    """Plans and records of the examples, run anew."""
    plans, records = {}, {}
    with tempfile.TemporaryDirectory() as folder, redirect_stdout(StringIO()):
        for name in ("fanuc-backup", "linuxcnc-two-axes"):
            out = Path(folder) / name
            with redirect_stderr(StringIO()):
                run(["run", str(EXAMPLES / name / "job.yaml"), "--out", str(out)])
            plans[name] = (out / "plan.json").read_bytes()
            records[name] = (out / "record.json").read_bytes()
    return plans, records


def one_sample(sample: Sample, seconds: float, seed: int) -> Counter[str]:
    """Damage and read a sample for ``seconds``; print counts and an example of each fault."""
    counts: Counter[str] = Counter()
    examples: dict[str, str] = {}
    sound = sample.read(sample.sound)
    longest, end, trial = 0.0, time.monotonic() + seconds, 0
    while time.monotonic() < end:
        trial += 1
        chance = random.Random(f"{sample.name} {seed} {trial}")  # noqa: S311 - not for secrets
        damage = sample.change(chance)
        start = time.monotonic()
        what, why = outcome(sample, damage, sound)
        longest = max(longest, time.monotonic() - start)
        counts[what] += 1
        if what in FOUND:
            examples.setdefault(f"{what}: {why}", f"trial {trial}: {damage!r}"[:6000])
    rate = sum(counts.values()) / seconds
    told = ", ".join(f"{count} {what}" for what, count in sorted(counts.items()))
    print(f"{sample.name}: {told}; {rate:.0f}/s, the longest {longest * 1000:.0f} ms", flush=True)
    for fault, example in examples.items():
        print(f"  {fault}\n    {example}")
    return counts


def main() -> None:
    """Share the time among the samples."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=900.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", default=[""], help="samples with one of these words")
    parser.add_argument("--results", type=Path, help="JSON file to which counts are added")
    words = parser.parse_args()
    warnings.simplefilter("error")
    if hasattr(signal, "SIGALRM"):
        signal.signal(signal.SIGALRM, _stop)
    every = samples(*documents())
    chosen = [one for one in every if any(word in one.name for word in words.only)]
    before = words.results.read_text() if words.results and words.results.exists() else "{}"
    total = Counter(json.loads(before))
    for sample in chosen:
        total += one_sample(sample, words.seconds / len(chosen), words.seed)
        if words.results:
            words.results.write_text(json.dumps(total, indent=1, sort_keys=True))
    told = ", ".join(f"{count} {what}" for what, count in sorted(total.items()))
    print(f"{sum(total.values())} inputs: {told}")
    sys.exit(any(total[what] for what in FOUND))


if __name__ == "__main__":
    main()
