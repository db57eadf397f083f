"""Checks of a circular test: directions, calibration, sampling, gaps, feed, closing of the circle,
set-up offset, copied runs.

The checks give findings and never reject a test. The standard sets no limits for most of them. The
comment at each limit states its reason.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import Final

import numpy as np

from compwright.evaluation.circular_angles import wrong_angles
from compwright.evaluation.circular_fit import Point
from compwright.evaluation.circular_points import SAME_ANGLE, ActualPath
from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun, CircularTest
from compwright.words.sentences import Amount, say

#: Samples farther apart (deg) can miss a reversal spike, which lasts about 1 mm of path (a 20 ms
#: answer at 3 m/min); 1° is 2.6 mm at 150 mm. The examples of ISO 230-4:1996 (figures 4 and 5) have
#: 1 500 and 1 800 samples per circle.
_COARSE: Final = 1.0
#: A hole in the samples: so many usual intervals, and more than ``_COARSE``.
_HOLE: Final = 5.0
#: A full circle takes between so many seconds at any sensible feed; beyond, the unit of the feed is
#: likely wrong (m/min, mm/s).
_CIRCLE_SECONDS: Final = (0.5, 900.0)
#: Numbers of samples of the two directions that differ by more than this share pull the common
#: circle to one of them.
_UNEQUAL: Final = 0.02
#: Beyond this share one direction had another feed: instruments sample at a constant rate, and a
#: feed override has steps of 5 or 10 %.
_OTHER_FEED: Final = 0.04
#: Ends of a full circle are compared by the median of so many samples.
_ENDS: Final = 3
#: The ends differ when they do by so many robust standard deviations of a sample, and by more than
#: the next number, mm.
_OPEN_SCATTER: Final = 8.0
OPEN_LEAST: Final = 0.001
_OPEN_STEPS: Final = 2.0  # of the readings
#: Lost motion makes a true step where an axis reverses: ends nearer to an axis (deg) are not
#: compared.
_NEAR_AXIS: Final = 3.0
#: Samples of a run that differ by less than this, mm, are computed, or no readings.
_READINGS: Final = 1e-5
#: Steps of the readings from this size on, mm, hide what a circular test shows. A ballbar has a
#: tenth of it.
_COARSE_STEP: Final = 0.001
_WHOLE: Final = 0.1  # rounding of the file, in such steps
#: Share of the changes that may be smaller than a step, and of the samples that may be between two
#: steps, as wrong readings are.
_UNUSUAL: Final = 0.2
_OFF_GRID: Final = 0.01
#: An instrument that stopped, or is at the end of its range: the means of so many blocks of the
#: next number of degrees or more are equal, to so many standard errors or one step of the readings,
#: and the causes that the rest of the run shows move the path there by more than the fourth number,
#: mm, so many times this tolerance, what they leave of the rest, and their standard errors.
_BLOCKS: Final = 4
_BLOCK: Final = 5.0
_EQUAL: Final = 4.0
_STILL_LEAST: Final = 0.001
_STILL_TIMES: Final = 8.0
_BLOCK_SAMPLES: Final = 4  # at least
#: The reading of a stopped instrument has the noise of its electronics, that of a moving machine
#: also that of the machine. Stopped: the usual change from sample to sample there is at most this
#: share of a large one (third quartile) in the rest of the run; with the same normal noise it is
#: 0.59. A table with steps, or for one direction, can make a path level, but not quiet.
_QUIET: Final = 0.3
_ENOUGH: Final = 1000  # samples of a run
_LATE: Final = 10.0  # degrees by which an axis may reverse later
#: Wrong readings, as of a knock, deviate from the median of so many samples on both sides by so
#: many scatters of a sample and by the second number, mm, and this median changes by less than a
#: quarter of that. A reversal spike may be as short, so the reversals (`_NEAR_AXIS`) are left out.
_KNOCK: Final = 5
_SINGLE: Final = (20.0, 0.005)
#: Where commanded and measured angles would give radii that differ by more than this (mm), a
#: finding states how the angle was read.
_OFFSET_EFFECT: Final = 1e-4


def test_findings(
    test: CircularTest, centres: Mapping[str, Point], *, F_given: bool
) -> list[Finding]:
    """Return the findings about the test as a whole. ``centres`` are in mm; ``F_given``: the result
    contains F.
    """
    return [
        *_directions(test),
        *_calibration(test),
        *_feed(test),
        *_unequal(test),
        *_offset(test, centres, F_given=F_given),
        *wrong_angles(test),
        *_copies(test),
    ]


def run_findings(test: CircularTest, path: ActualPath, centre: Point) -> list[Finding]:
    """Return the findings about one evaluated run; ``centre`` is that of its least-squares circle,
    mm.
    """
    return [
        *_sampling(path),
        *_holes(test, path),
        *_duplicates(path),
        *_beyond(test, path),
        *_closing(test, path, centre),
        *_zeros(path),
        *(_coarse(path) or [*_still(path), *_single(path)]),
    ]


def _named(run: CircularRun) -> str:
    return f"{run.sense} run {run.number}"


def _um(value: float) -> Amount:
    return Amount(value * MICROMETRES_PER_MILLIMETRE, "µm")


def _directions(test: CircularTest) -> list[Finding]:
    """Return the finding CW-C002 if only one direction was measured. H and the bidirectional
    parameters need two directions in succession (clause 5).
    """
    measured = [sense for sense in ("ccw", "cw") if any(run.sense == sense for run in test.runs)]
    if len(measured) == 2:
        return []
    return [Finding.of("CW-C002", "info", direction=measured[0])]


def _calibration(test: CircularTest) -> list[Finding]:
    """Return the finding CW-C003 if the bar's length is not calibrated (3.4 note 3, 4.5)."""
    if test.calibrated:
        return []
    return [Finding.of("CW-C003", "warning")]


def _feed(test: CircularTest) -> list[Finding]:
    """Return the finding CW-C006 if the stated feed cannot be a feed in mm/min, because it is not
    positive or the circle would take too short or too long.
    """
    if np.isfinite(test.feed) and test.feed > 0.0:
        seconds = 60.0 * 2.0 * np.pi * test.nominal_radius / test.feed
        if _CIRCLE_SECONDS[0] <= seconds <= _CIRCLE_SECONDS[1]:
            return []
        return [
            Finding.of(
                "CW-C006.time",
                "warning",
                feed=test.feed,
                radius=test.nominal_radius,
                seconds=seconds,
            )
        ]
    return [Finding.of("CW-C006.no_feed", "warning", feed=test.feed)]


def _unequal(test: CircularTest) -> list[Finding]:
    """Return the finding CW-C008 if the number of samples differs between the runs. The longer run
    then counts more in the common circle. Where it differs much, the feed differed, and a servo
    mismatch is not the same in both directions.
    """
    counts = (
        [test.of("ccw")[0].angles.size, test.of("cw")[0].angles.size]
        if test.of("ccw") and test.of("cw")
        else [1, 1]
    )
    if max(counts) <= max((1.0 + _UNEQUAL) * min(counts), min(counts) + 2):
        return []
    share = 100.0 * min(counts) / max(counts)
    if share < 100.0 / (1.0 + _OTHER_FEED):
        return [Finding.of("CW-C008.feed", "warning", ccw=counts[0], cw=counts[1], share=share)]
    return [Finding.of("CW-C008.few", "info", ccw=counts[0], cw=counts[1])]


def _offset(test: CircularTest, centres: Mapping[str, Point], *, F_given: bool) -> list[Finding]:
    """Return the finding CW-C010 if F on an arc contains the set-up offset (3.5 a, note 6), and
    CW-C011 if the offset is so large that commanded and measured angles give different results.
    """
    x, y = centres["common"] if "common" in centres else next(iter(centres.values()))
    offset = float(np.hypot(x, y))
    findings = []
    if F_given and not test.full_circle:
        findings.append(Finding.of("CW-C010", "info", offset=_um(offset)))
    effect = offset**2 / test.nominal_radius
    if effect > _OFFSET_EFFECT:
        findings.append(Finding.of("CW-C011", "warning", offset=_um(offset), effect=_um(effect)))
    return findings


def _sampling(path: ActualPath) -> list[Finding]:
    """Return the finding CW-C004 if samples are too far apart for reversal spikes (clause 5)."""
    interval = float(np.ptp(path.run.angles)) / (path.run.angles.size - 1)
    if interval <= _COARSE:
        return []
    return [Finding.of("CW-C004", "warning", run=_named(path.run), interval=interval)]


def _holes(test: CircularTest, path: ActualPath) -> list[Finding]:
    """Return the finding CW-C005 if part of the arc was not measured."""
    angles = np.sort(path.run.angles)
    usual = float(np.median(np.diff(angles)))
    limit = max(_HOLE * usual, _COARSE)
    holes = [
        (float(angles[i]), float(angles[i + 1])) for i in np.flatnonzero(np.diff(angles) > limit)
    ]
    if test.full_circle:
        closing = float(angles[0] + 360.0 - angles[-1])
        holes += [(float(angles[-1]), float(angles[0]) + 360.0)] if closing > limit else []
    elif test.arc[1] - float(np.ptp(angles)) > 2.0 * limit:
        return [
            Finding.of(
                "CW-C005.arc",
                "warning",
                run=_named(path.run),
                covered=float(np.ptp(angles)),
                arc=test.arc[1],
            )
        ]
    if not holes:
        return []
    where = [say("circle.part", start=begin, end=end) for begin, end in holes[:5]]
    return [Finding.of("CW-C005.gap", "warning", run=_named(path.run), gaps=where)]


def _duplicates(path: ActualPath) -> list[Finding]:
    """Return the finding CW-C009 if several samples have the same angle. Both ends of a full circle
    are separate samples.
    """
    repeated = int(np.count_nonzero(np.diff(np.sort(path.run.angles)) <= SAME_ANGLE))
    if repeated == 0:
        return []
    return [Finding.of("CW-C009", "warning", repeated=repeated, run=_named(path.run))]


def _beyond(test: CircularTest, path: ActualPath) -> list[Finding]:
    """Return the finding CW-C007 if samples are outside the arc, as when starting or stopping."""
    covered = float(np.ptp(path.run.angles))
    if covered <= test.arc[1] + SAME_ANGLE:
        return []
    return [
        Finding.of("CW-C007", "warning", run=_named(path.run), covered=covered, arc=test.arc[1])
    ]


def _closing(test: CircularTest, path: ActualPath, centre: Point) -> list[Finding]:
    """Return the finding CW-C012 if the ends of a full circle do not meet, because of drift, slip,
    or readings from the starting arc.
    """
    ends = np.mod(path.run.angles[[0, -1]] + 45.0, 90.0) - 45.0
    near = max(_NEAR_AXIS, float(np.median(np.abs(np.diff(path.run.angles)))))
    if not test.full_circle or np.any(np.abs(ends) < near):
        return []
    radial = path.distances(centre)
    step = abs(float(np.median(radial[-_ENDS:]) - np.median(radial[:_ENDS])))
    steps = _resolution(path.run.deviations)
    if step <= max(OPEN_LEAST, _OPEN_SCATTER * _scatter(radial), _OPEN_STEPS * steps):
        return []
    return [open_ends(path.run, step)]


def open_ends(run: CircularRun, step: float) -> Finding:
    """Return the finding CW-C012: the radius changed by ``step``, mm, during a ``run``."""
    return Finding.of("CW-C012", "warning", run=_named(run), step=_um(step))


def _scatter(radial: FloatArray) -> float:
    """Return the standard deviation of a sample, mm, from differences of neighbouring samples."""
    return float(1.4826 / np.sqrt(2.0) * np.median(np.abs(np.diff(radial))))


def _zeros(path: ActualPath) -> list[Finding]:
    """Return the finding CW-C013 if all deviations of a run are exactly zero, so that they were not
    measured.
    """
    if np.any(path.run.deviations):
        return []
    return [Finding.of("CW-C013", "warning", run=_named(path.run))]


def _resolution(values: FloatArray) -> float:
    """Return the smallest usual change, mm, from sample to sample; infinite if there is none."""
    change = np.abs(np.diff(values))
    change = change[change > _READINGS]
    return float(np.quantile(change, _UNUSUAL, method="lower")) if change.size else np.inf


def _coarse(path: ActualPath) -> list[Finding]:
    """Return the finding CW-C016 if the readings have coarse steps: changes from sample to sample
    are multiples of one step.
    """
    step = _resolution(path.run.deviations)
    if not _COARSE_STEP - _READINGS < step < np.inf:
        return []
    steps = np.diff(path.run.deviations) / step
    if np.mean(np.abs(steps - np.round(steps)) > _WHOLE) > _OFF_GRID:
        return []
    return [Finding.of("CW-C016.coarse", "warning", run=_named(path.run), step=_um(step))]


def _still(path: ActualPath) -> list[Finding]:
    """Return the finding CW-C016 if the reading does not change over a part of the run, although
    the causes that the rest of the run shows move the path there: the instrument was at the end of
    its range, or it stopped.
    """
    angles, values = path.run.angles, path.run.deviations
    interval = max(float(np.median(np.abs(np.diff(angles)))), SAME_ANGLE)
    count = max(int(np.ceil(_BLOCK / interval)), _BLOCK_SAMPLES)
    blocks = values.size // count
    if blocks < 3 * _BLOCKS:
        return []
    means = np.mean(values[: blocks * count].reshape(blocks, count), axis=1)
    same = max(_EQUAL * _scatter(values) * np.sqrt(2.0 / count), _resolution(values))
    parts, start = [], 0
    while start < blocks:
        other = np.flatnonzero(np.abs(means[start:] - means[start]) > same)
        end = start + int(other[0]) if other.size else blocks
        part = slice(start * count, end * count if end < blocks else values.size)
        long = _BLOCKS <= end - start < 0.75 * blocks
        if long and _quiet(values, part) and _moves(angles, values, part, same):
            ends = sorted((float(angles[part.start]), float(angles[part.stop - 1])))
            parts.append(say("circle.part", start=ends[0] % 360.0, end=ends[1] % 360.0))
            start = end
        start += 1
    if not parts:
        return []
    return [Finding.of("CW-C016.still", "warning", run=_named(path.run), parts=parts[:5])]


def _quiet(values: FloatArray, part: slice) -> bool:
    """Return whether ``values`` (n,) of a run, mm, change clearly less from sample to sample in a
    ``part`` than in the rest of the run.
    """
    changes = np.abs(np.diff(values))
    rest = np.r_[changes[: part.start], changes[part.stop :]]
    return bool(np.median(changes[part]) <= _QUIET * np.quantile(rest, 0.75) + _READINGS)


def _moves(angles: FloatArray, values: FloatArray, part: slice, same: float) -> bool:
    """Return whether the causes of ISO 230-4:1996, annex B, that all other ``values`` (n,) of a run
    show at ``angles`` (n,) move the path in a ``part`` by clearly more than ``same``, mm. Steps at
    the reversals and what is near them do not count, because an axis that lags reverses later.
    """
    inside = np.zeros(angles.size, dtype=bool)
    inside[part] = True
    thin = slice(None, None, 1 + angles.size // _ENOUGH)
    angles, values, inside = angles[thin], values[thin], inside[thin]
    rest = ~inside & (np.abs(np.mod(angles + 45.0, 90.0) - 45.0) > _LATE)
    theta = np.radians(angles)
    cos, sin = np.cos(theta), np.sin(theta)
    columns = [np.ones_like(cos)]
    columns += [f(order * theta) for order in (1, 2, 3) for f in (np.cos, np.sin)]
    for along, step in ((cos, np.sign(sin) * cos), (sin, np.sign(cos) * sin)):
        columns += [step * (along > 0.0), step * (along < 0.0)]
    matrix = np.column_stack(columns)
    inverse = np.linalg.pinv(matrix[rest], rcond=1e-6)
    sizes = inverse @ values[rest]
    scatter = float(np.sqrt(np.mean((values[rest] - matrix[rest] @ sizes) ** 2)))
    there = matrix[inside]
    error = scatter * float(np.max(np.linalg.norm(there @ inverse, axis=1)))
    limit = max(_STILL_LEAST, _STILL_TIMES * same, _EQUAL * scatter, _STILL_TIMES * error)
    path, quadrant = there @ sizes, np.floor(angles[inside] / 90.0)
    return any(np.ptp(path[quadrant == each]) > limit for each in np.unique(quadrant))


def _single(path: ActualPath) -> list[Finding]:
    """Return the finding CW-C016 if a few readings, away from the reversals of the axes, deviate
    from the neighbouring ones.
    """
    angles, values = path.run.angles, path.run.deviations
    half = _KNOCK
    if values.size < 4 * half:
        return []
    beside = np.median(np.lib.stride_tricks.sliding_window_view(values, 2 * half + 1), axis=1)
    level = np.pad(beside, half, mode="edge")
    off = values - level
    apart = np.abs(np.roll(level, -half) - np.roll(level, half))
    near = np.abs(np.mod(angles + 45.0, 90.0) - 45.0) < max(
        _NEAR_AXIS, half * float(np.median(np.abs(np.diff(angles))))
    )
    limit = max(_SINGLE[0] * _scatter(values), _SINGLE[1], 2.0 * _resolution(values))
    wrong = (np.abs(off) > limit) & (apart < 0.25 * np.abs(off)) & ~near
    wrong[:half] = wrong[-half:] = False
    where = np.flatnonzero(wrong)
    if not where.size:
        return []
    largest = int(where[np.argmax(np.abs(off[where]))])
    return [
        Finding.of(
            "CW-C016.single",
            "warning",
            run=_named(path.run),
            count=int(where.size),
            angle=float(angles[largest]) % 360.0,
            off=_um(float(np.abs(off[largest]))),
        )
    ]


def _copies(test: CircularTest) -> list[Finding]:
    """Return the finding CW-C015 for two runs that have exactly the same readings, in whatever
    order. Equal samples throughout are no readings (CW-C013, CW-R036).
    """
    values = {f"{run.sense} run {run.number}": np.sort(run.deviations) for run in test.runs}
    return [
        Finding.of("CW-C015", "warning", first=first, second=second)
        for first, second in combinations(values, 2)
        if np.ptp(values[first]) > _READINGS and np.array_equal(values[first], values[second])
    ]
