"""Check whether a test is a second record of the same measurement as another test.

The second record may have fewer digits, another zero of the instrument, or its runs in another
order. It may contain only some of the runs and targets.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.evaluation.statistics import mean_deviation, standard_deviation
from compwright.records.axis import Direction, FloatArray
from compwright.records.positioning import PositioningTest

#: Digits that a copy keeps at least: 0.1 µm (0.36 arcsec); a coarser step shows in its readings.
_FINEST: Final = 1e-4
#: Readings on a step are so to this part of it.
_WHOLE: Final = 0.02
#: Targets that two runs have in common at least: a constant between them is free.
_TARGETS: Final = 5
#: Positions in mm (deg) that are one target.
_SAME_TARGET: Final = 1e-3
#: Of the readings of a copy so many are in the original: some may have been corrected by hand.
_NEARLY_ALL: Final = 0.9


def last_digit(test: PositioningTest) -> float:
    """Return the common resolution step of all readings of a test, mm or deg, at least 0.1 µm."""
    blocks = [test.deviations(direction).ravel() for direction in Direction]
    values = np.concatenate(blocks)
    gaps = np.diff(np.unique(np.round(values[np.isfinite(values)], 9)))
    if gaps.size == 0:
        return _FINEST
    counts = gaps / np.min(gaps)
    on_step = bool(np.all(np.abs(counts - np.round(counts)) <= _WHOLE))
    return max(_FINEST, float(np.min(gaps))) if on_step else _FINEST


def is_rounded_copy(test: PositioningTest, original: PositioningTest) -> bool:
    """Return whether ``test`` is a copy of ``original`` with rounded readings.

    In a copy, nearly every reading agrees with a reading of ``original`` at the same target. The
    two may differ by the last digit and by a constant for each run. If a run agrees with no run of
    ``original``, none of its readings agree.
    """
    if test.kind is not original.kind:
        return False
    step = last_digit(test)
    place = np.searchsorted(original.targets, test.targets - _SAME_TARGET)
    place = np.minimum(place, original.targets.size - 1)
    common = np.abs(original.targets[place] - test.targets) <= _SAME_TARGET
    made = sum(int(np.sum(test.readings(direction))) for direction in Direction)
    missing = 0
    for direction in Direction:
        ours = test.deviations(direction)
        theirs = original.deviations(direction)[place[common]]
        for run in ours.T:
            copied = any(_agree(run[common], other, step) for other in theirs.T)
            missing += int(np.count_nonzero(np.isfinite(run[~common] if copied else run)))
            if missing > (1.0 - _NEARLY_ALL) * made:  # many runs: the answer is known early
                return False
    return made > 0


def is_coarse(test: PositioningTest, original: PositioningTest) -> bool:
    """Return whether readings are so coarse that ``test`` and ``original`` can agree by chance.

    This is so if the runs of ``original``, apart from a constant, scatter by less than a resolution
    step of ``test``. It is also so if no target was approached twice.
    """
    blocks = (original.deviations(direction) for direction in Direction)
    scatter = np.concatenate(
        [standard_deviation(block - mean_deviation(block.T)[np.newaxis, :]) for block in blocks]
    )
    known = scatter[np.isfinite(scatter)]
    return known.size == 0 or float(np.sqrt(np.mean(np.square(known)))) < last_digit(test)


def _agree(run: FloatArray, other: FloatArray, step: float) -> bool:
    gap = run - other
    gap = gap[np.isfinite(gap)]
    if gap.size < _TARGETS:
        return False
    alike = np.abs(gap - np.median(gap)) <= step
    return int(np.count_nonzero(alike)) >= _NEARLY_ALL * gap.size
