"""Damaged control files: refused with a sentence, or a table on which both readers agree; one that
is cut short is never silent.

Each trial changes a small, sound set of files at random and reads it as the commands do
(`workflow.control.decode`, which holds the two readers against each other). Anything but a refusal
or an agreed table fails. Seeded, so that a failure comes back; a million trials are in
``benchmarks/bench_inputs.py``.
"""

from __future__ import annotations

import pytest

from compwright.foundations.errors import InputError, UsageError
from damage import (
    READ_DIFFERENTLY,
    SAMPLES,
    Sample,
    cut_points,
    damaged,
    read,
    said_incomplete,
    trials,
)

#: Trials by format: those in which one array is shared by all axes have most to go wrong.
TRIALS = {"fanuc-30i": 600, "fanuc-0i-16i": 600}
TRIALS_ELSE = 300
#: Files without an end mark: a cut behind a whole line cannot be seen. An archive may hold one
#: program or several, and of an empty file nothing is missed where another one speaks of the axis.
NO_END_MARK = ("linuxcnc", "heidenhain-itnc530", "pmac", "isg-kernel")


FORMATS = sorted({sample.format_id for sample in SAMPLES})


@pytest.mark.parametrize("format_id", FORMATS)
def test_damaged_files_are_refused_or_both_readers_agree(format_id: str) -> None:
    count = TRIALS.get(format_id, TRIALS_ELSE)
    counts = trials([sample for sample in SAMPLES if sample.format_id == format_id], count, seed=20)
    assert counts["agreed"] > 0.02 * count, (
        "harmless damage must stay readable, else nothing was compared"
    )
    assert counts["refused"] > 0.2 * count, "the damage must be worth the name"
    assert counts["agreed"] + counts["refused"] + counts["ambiguous"] == count
    # Refused too, but by the two readers together: a file that one alone would have taken. Few, or
    # a reader is wrong.
    assert counts["ambiguous"] < 0.02 * count


@pytest.mark.parametrize("sample", READ_DIFFERENTLY, ids=str)
def test_a_file_cut_short_is_refused_or_warned_about(sample: Sample) -> None:
    """At every byte of every file: what is left is refused, or says the same as the whole, or comes
    with a warning.
    """
    whole = read(sample, sample.files)
    silent = []
    for name, end in cut_points(sample):
        files = [
            file if file.name != name else type(file)(name, file.content[:end])
            for file in sample.files
        ]
        try:
            left = read(sample, files)
        except (InputError, UsageError):
            continue
        if not said_incomplete(left, whole) and not looks_whole(sample, name, end):
            silent.append((name, end))
    assert silent == []


def looks_whole(sample: Sample, name: str, end: int) -> bool:
    """Whether a cut leaves what could be a whole file: nothing, whole lines without an end mark, or
    whole programs.
    """
    left = next(file.content for file in sample.files if file.name == name)[:end]
    if sample.format_id in NO_END_MARK and not name.upper().endswith((".COM", ".CMA")):
        return left.rstrip(b" ").endswith(b"\n")
    return sample.format_id.startswith("siemens-") and b"$" not in left.rpartition(b"M17")[2]


def test_the_damage_is_the_same_for_the_same_seed() -> None:
    sample = SAMPLES[0]
    assert damaged(sample, seed=3) == damaged(sample, seed=3)
    assert len({tuple(file.content for file in damaged(sample, seed)) for seed in range(50)}) > 40
