"""Damaged control files: refused with a sentence, or a table on which both readers agree; one that is cut short is never silent.

Each trial changes a small, sound set of files at random and reads it as the commands do (`workflow.control.decode`, which holds the
two readers against each other). Anything but a refusal or an agreed table fails. Seeded, so that a failure comes back; a million
trials are in ``benchmarks/bench_fuzz.py``.
"""

from __future__ import annotations

from collections.abc import Collection

import pytest

from compwright.foundations.errors import InputError, UsageError
from damage import SAMPLES, Sample, cut_points, damaged, read, said_incomplete, trials

#: Trials by format: those in which one array is shared by all axes have most to go wrong.
TRIALS = {"fanuc-30i": 7_000, "fanuc-0i-16i": 7_000}
TRIALS_ELSE = 3_000
#: Formats in which damage still gives two readings, or in which a cut says nothing; each entry is to go.
OPEN = {
    "heidenhain-itnc530": "a changed MP730, or a table's column that moves, is read in two ways",
    "linuxcnc": "the joint that a damaged file name or section belongs to; corrections of many mm in single precision",
    "siemens-840d-sl": "an axis name whose small letter is an accident",
}
#: A cut at a line end cannot be seen in files without an end mark, and a file of which nothing is left is not missed.
OPEN_CUTS = {"heidenhain-itnc530", "linuxcnc", "siemens-840d-sl"}


def known(format_id: str, reasons: Collection[str]) -> list[pytest.MarkDecorator]:
    return [pytest.mark.xfail(reason=f"open: {format_id}", strict=False)] if format_id in reasons else []


FORMATS = sorted({sample.format_id for sample in SAMPLES})


@pytest.mark.parametrize("format_id", [pytest.param(name, marks=known(name, OPEN)) for name in FORMATS])
def test_damaged_files_are_refused_or_both_readers_agree(format_id: str) -> None:
    count = TRIALS.get(format_id, TRIALS_ELSE)
    counts = trials([sample for sample in SAMPLES if sample.format_id == format_id], count, seed=20)
    assert counts["agreed"] > 0.02 * count, "harmless damage must stay readable, else nothing was compared"
    assert counts["refused"] > 0.2 * count, "the damage must be worth the name"
    assert counts["agreed"] + counts["refused"] == count


@pytest.mark.parametrize(
    "sample", [pytest.param(sample, marks=known(sample.format_id, OPEN_CUTS), id=str(sample)) for sample in SAMPLES]
)
def test_a_file_cut_short_is_refused_or_warned_about(sample: Sample) -> None:
    """At every byte of every file: what is left is refused, or says the same as the whole, or comes with a warning."""
    whole = read(sample, sample.files)
    silent = []
    for name, end in cut_points(sample):
        files = [file if file.name != name else type(file)(name, file.content[:end]) for file in sample.files]
        try:
            left = read(sample, files)
        except (InputError, UsageError):
            continue
        if not said_incomplete(left, whole):
            silent.append((name, end))
    assert silent == []


def test_the_damage_is_the_same_for_the_same_seed() -> None:
    sample = SAMPLES[0]
    assert damaged(sample, seed=3) == damaged(sample, seed=3)
    assert len({tuple(file.content for file in damaged(sample, seed)) for seed in range(50)}) > 40
