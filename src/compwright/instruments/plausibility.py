"""Findings about implausible readings in a positioning file. No reading is changed or dropped.

Codes of this room:

- ``CW-R001`` info: what the file does not say and what was taken instead (cycle, sign, unit)
- ``CW-R002`` info: the file does not name its axis
- ``CW-R003`` info: measured values were turned into deviations
- ``CW-R004`` info: the instrument already compensated for something
- ``CW-R005`` warning: columns that are not part of the form were left out
- ``CW-R006`` warning: readings are missing
- ``CW-R007`` warning: the directions have different numbers of traverses
- ``CW-R008`` warning: a deviation larger than 1 mm or 1 deg
- ``CW-R009`` warning: all deviations smaller than 0.000001 mm or deg
- ``CW-R010`` warning: a traverse of exact zeros
- ``CW-R011`` warning: the deviations grow with the targets one to one, as measured positions do
- ``CW-R012`` warning: two targets almost the same that no traverse has both
- ``CW-R013`` warning: the key ``deviation`` has no effect on measured values
- ``CW-R014`` warning: forward targets listed from high to low
- ``CW-R015`` warning: a point that may mark thousands was read as a decimal point
- ``CW-R050`` warning: targets approached in one direction only were left out
- ``CW-R051`` warning: the file may have been cut off inside its last number
- ``CW-R052`` info: other files in a folder of measurements were skipped
- ``CW-R053`` warning: the file holds less than it promises, or does not end as its form does, or a
  fifth of its readings is missing
- ``CW-R054`` warning: runs of exact zeros were left out as a way back that was not made
- ``CW-R055`` warning: the way back was recognised only by the number of its runs
- ``CW-R056`` warning: angles without a unit were taken as microradian
- ``CW-R057`` warning: means instead of readings
- ``CW-R058`` warning: a compensation table instead of a test
- ``CW-R059`` warning: rows of a table without a number in the target column were left out
- ``CW-R061`` warning: sheets of a workbook that were left out
- ``CW-R062`` info: plain CSV in the code page of an older Windows
- ``CW-R060`` info: how a laser's file or a table was read, three readings in words
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import ReadingGrid, as_text
from compwright.instruments.reading_findings import cut_finding, missing_finding
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.positioning import LARGEST_PLAUSIBLE
from compwright.words.sentences import Amount, Sentence, say

#: Plausible deviations are larger than this and smaller than `LARGEST_PLAUSIBLE`, mm or deg:
#: outside, the unit is probably not the one stated.
SMALLEST_PLAUSIBLE = 1e-6
#: Slope of the deviations over the targets that looks like a column of measured positions, and its
#: tolerance (no unit).
_SLOPE_TOLERANCE = 0.05
#: Two targets nearer than this share of the median gap are suspected to be one target written in
#: two ways.
_NEAR_SHARE = 0.1
#: A run of nothing but zeros is no surprise where one test in twenty or more shows one by chance.
_CHANCE = 0.05
#: From this share of missing readings on, rows were lost: a beam that is cut takes single readings.
_CUT_SHARE = 0.2
_LISTED = 5


def findings_of(grid: ReadingGrid, kind: AxisKind) -> tuple[Finding, ...]:
    """Return the findings about the readings of one test, the most general ones first."""
    return tuple(
        finding
        for finding in (
            *_missing(grid, kind),
            _one_sided(grid),
            _unequal_traverses(grid),
            _as_measured(grid, kind) or _too_large(grid, kind),
            _too_small(grid, kind),
            _zero_traverses(grid),
            _near_targets(grid, kind),
        )
        if finding is not None
    )


def _all_deviations(grid: ReadingGrid) -> FloatArray:
    return np.hstack([grid.deviations[direction] for direction in Direction])


def _missing(grid: ReadingGrid, kind: AxisKind) -> list[Finding]:
    gaps = [
        say(
            "CW-R006.place",
            target=Amount(grid.targets[row], kind.unit, ".10g"),
            run=f"{direction}{grid.runs[direction][column]}",
        )
        for direction in Direction
        for row, column in np.argwhere(np.isnan(grid.deviations[direction]))
    ]
    if not gaps:
        return []
    total = _all_deviations(grid).size
    found = [
        missing_finding(
            say("CW-R006.readings", missing=len(gaps), readings=total, places=_list(gaps))
        )
    ]
    if len(gaps) >= _CUT_SHARE * total:
        found.append(cut_finding(say("CW-R053.share", share=len(gaps) / total)))
    return found


def _one_sided(grid: ReadingGrid) -> Finding | None:
    if not grid.one_sided:
        return None
    return Finding.of("CW-R050", "warning", targets=_list(list(grid.one_sided)))


def _list(items: Sequence[object]) -> Sentence:
    return say("listed", items=items[:_LISTED], more=max(0, len(items) - _LISTED))


def _unequal_traverses(grid: ReadingGrid) -> Finding | None:
    positive, negative = (len(grid.runs[direction]) for direction in Direction)
    if not positive or not negative or positive == negative:
        return None
    return Finding.of("CW-R007", "warning", positive=positive, negative=negative)


def _as_measured(grid: ReadingGrid, kind: AxisKind) -> Finding | None:
    deviations = _all_deviations(grid)
    made = np.isfinite(deviations)
    if not np.any(np.abs(deviations[made]) > LARGEST_PLAUSIBLE):
        return None
    targets = np.broadcast_to(grid.targets[:, None], deviations.shape)[made]
    spread = targets - targets.mean()
    squares = float(spread @ spread)
    if squares <= 0.0 or abs(float(spread @ deviations[made]) / squares - 1.0) > _SLOPE_TOLERANCE:
        return None
    return Finding.of("CW-R011", "warning", unit=kind.unit)


def _too_large(grid: ReadingGrid, kind: AxisKind) -> Finding | None:
    deviations = _all_deviations(grid)
    size = np.nan_to_num(np.abs(deviations))
    count = int(np.count_nonzero(size > LARGEST_PLAUSIBLE))
    if not count:
        return None
    row, column = np.unravel_index(int(np.argmax(size)), size.shape)
    turn = kind is AxisKind.ROTARY and bool(np.any(np.abs(size - 360.0) <= LARGEST_PLAUSIBLE))
    return Finding.of(
        "CW-R008",
        "warning",
        count=count,
        of=int(np.isfinite(deviations).sum()),
        unit=kind.unit,
        largest=as_text(float(deviations[row, column])),
        target=as_text(grid.targets[row]),
        turn=turn,
    )


def _too_small(grid: ReadingGrid, kind: AxisKind) -> Finding | None:
    if np.nanmax(np.abs(_all_deviations(grid))) >= SMALLEST_PLAUSIBLE:
        return None
    return Finding.of("CW-R009", "warning", unit=kind.unit)


def _zero_traverses(grid: ReadingGrid) -> Finding | None:
    columns = [
        (f"{direction}{run}", values[np.isfinite(values)])
        for direction in Direction
        for run, values in zip(grid.runs[direction], grid.deviations[direction].T, strict=True)
    ]
    zero = [
        (name, values.size) for name, values in columns if values.size > 1 and not np.any(values)
    ]
    others = [values for _, values in columns if np.any(values)]
    if not zero or not others:
        return None
    # A display coarser than the noise shows zeros everywhere: then a whole run of them comes by
    # chance.
    share = float(np.mean(np.concatenate(others) == 0.0))
    if len(columns) * share ** min(size for _, size in zero) > _CHANCE:
        return None
    return Finding.of("CW-R010", "warning", runs=tuple(name for name, _ in zero))


def _near_targets(grid: ReadingGrid, kind: AxisKind) -> Finding | None:
    gaps = np.diff(grid.targets)
    if gaps.size <= 1:
        return None
    made = np.isfinite(_all_deviations(grid))
    # the median; numpy's own loads numpy.ma
    middle = np.sort(gaps)[[(gaps.size - 1) // 2, gaps.size // 2]].mean()
    near = (gaps < _NEAR_SHARE * middle) & ~np.any(made[:-1] & made[1:], axis=1)
    pairs = [
        say(
            "CW-R012.pair",
            low=grid.targets[row],
            high=Amount(grid.targets[row + 1], kind.unit, ".10g"),
        )
        for row in np.flatnonzero(near)
    ]
    if not pairs:
        return None
    return Finding.of("CW-R012", "warning", targets=_list(pairs))


def skipped_finding(names: Sequence[str]) -> Finding | None:
    """Return the finding about files that were skipped because their extension is not that of
    measurements, or None if there are none.
    """
    if not names:
        return None
    return Finding.of("CW-R052", "info", files=names)
