"""Periods of the wanted correction that are too short for the table points.

A table fitted by least squares cannot reproduce a short sine completely. With three points per
period it leaves 25 % of the sine's rms. With a little more than two points it leaves 63 %; with two
points 12 to 98 %, depending on the phase. With fewer than two points per period the table shows a
longer wave instead (Shannon, Proceedings of the IRE 37, 1949, section II). This wave increases the
remaining error.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.fitting.period_removal import without_periods
from compwright.fitting.problem import hat_matrix, sample_correction
from compwright.fitting.solve import least_squares
from compwright.fitting.sparse_matrices import from_entries
from compwright.foundations.findings import Finding
from compwright.records.axis import Direction, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection
from compwright.words.sentences import Amount

#: A period is held from three points per period on (25 % of its rms is left then).
_HOLD: Final = 3.0
#: With two points per period points follow it in part (module docstring).
_FOLLOW: Final = 2.0


@dataclass(frozen=True, slots=True, kw_only=True)
class HeldGrid:
    """Table points together with the correction that is fitted on them.

    ``points`` (k,): table points, mm or deg. ``wanted``: the correction with only the part of short
    periods that the points can follow. ``left_out``: rms of the other part of the short periods.
    ``points_loss``: rms that more points would remove; 0 if the number of points is not the limit.
    ``kept``: the points are the control's existing ones.
    """

    points: FloatArray
    wanted: WantedCorrection
    left_out: float = 0.0
    points_loss: float = 0.0
    findings: tuple[Finding, ...] = ()
    kept: bool = False


def unresolved_periods(points: FloatArray, periods: Sequence[float]) -> list[float]:
    """Return ``periods`` (mm or deg) that points ``points`` (k,) cannot reproduce completely."""
    return _longer_than(points, periods, _HOLD)


def ignored_periods(points: FloatArray, periods: Sequence[float]) -> list[float]:
    """Return ``periods`` (mm or deg) that points ``points`` (k,) cannot reproduce at all."""
    return _longer_than(points, periods, _FOLLOW)


def _longer_than(points: FloatArray, periods: Sequence[float], least: float) -> list[float]:
    step = float(np.max(np.diff(points))) if points.size > 1 else np.inf
    return [period for period in periods if step * least > period * (1 + 1e-9)]


def resolved_part(
    points: FloatArray, wanted: WantedCorrection, capacity: Capacity
) -> WantedCorrection:
    """Return ``wanted`` (mm or deg) with only that part of short periods that the table points
    ``points`` (k,) can reproduce.

    This part leaves the smallest mean square over the travel (Draper and Smith, Applied Regression
    Analysis, 3rd ed. 1998, chapter 1). It is zero for periods that the points cannot follow at all.
    """
    lost = unresolved_periods(points, wanted.periods)
    if not lost:
        return wanted
    smooth = without_periods(wanted, lost)[0]
    out = ignored_periods(points, lost)
    if len(out) == len(lost):
        return smooth
    followed = without_periods(wanted, out)[0] if out else wanted
    values = _projected(points, wanted, followed.positive - smooth.positive, capacity)
    # What the points hold bends at them.
    inside = points[(points > wanted.positions[0]) & (points < wanted.positions[-1])]
    nearest = np.abs(inside[:, None] - _neighbours(wanted.positions, inside)).min(axis=1)
    apart = 1e-6 * float(np.max(np.diff(points)))
    where = np.union1d(wanted.positions, inside[nearest > apart])
    held = (
        hat_matrix(
            where,
            points,
            below=capacity.below,
            above=capacity.above,
            interpolation=capacity.interpolation,
        )
        @ values
    )
    return replace(
        smooth,
        positions=where,
        positive=np.interp(where, smooth.positions, smooth.positive) + held,
        negative=np.interp(where, smooth.positions, smooth.negative) + held,
    )


def _projected(
    points: FloatArray, wanted: WantedCorrection, wave: FloatArray, capacity: Capacity
) -> FloatArray:
    """Return the table values (k,) at ``points`` that approximate a ``wave`` (g,) best, mm or deg.

    The wave is given at the positions of ``wanted``. On an endless axis the first and the last
    value are equal.
    """
    data = sample_correction(replace(wanted, positive=wave, negative=wave), points, capacity)
    matrix, free = data.matrix, points.size
    if capacity.period is not None:
        free -= 1
        shape = (matrix.shape[0], free)
        matrix = from_entries(shape, matrix.row, matrix.column % free, matrix.value)
    values = least_squares(matrix, data.weights, data.wanted[Direction.POSITIVE])
    return values[np.arange(points.size) % free]


def _neighbours(positions: FloatArray, places: FloatArray) -> FloatArray:
    """Return the nearest of the ``positions`` below and above each of the ``places``, (p, 2)."""
    right = np.clip(np.searchsorted(positions, places), 1, positions.size - 1)
    return np.column_stack([positions[right - 1], positions[right]])


def held_grid(
    points: FloatArray,
    wanted: WantedCorrection,
    capacity: Capacity,
    *,
    loss: float = 0.0,
    finest: FloatArray | None = None,
) -> HeldGrid:
    """Return the table points ``points`` with the correction that they can reproduce, and a finding
    about short periods that they cannot reproduce. ``loss``: rms error that more points would
    remove; ``finest``: the closest points that the control allows, if the finding is to state them.
    """
    lost = unresolved_periods(points, wanted.periods)
    if not lost:
        return HeldGrid(points=points, wanted=wanted, points_loss=loss)
    held = resolved_part(points, wanted, capacity)
    whole = without_periods(wanted, lost)[1]
    rest = wanted.positive - np.interp(wanted.positions, held.positions, held.positive)
    left = float(np.sqrt(np.mean(rest**2)))
    found = _finding(points, wanted, capacity, (left, whole), finest)
    return HeldGrid(points=points, wanted=held, left_out=left, points_loss=loss, findings=(found,))


def _finding(
    points: FloatArray,
    wanted: WantedCorrection,
    capacity: Capacity,
    rms: tuple[float, float],
    finest: FloatArray | None,
) -> Finding:
    """Return the finding about short periods that a table with points ``points`` cannot reproduce.
    ``rms`` (mm or deg): of what the table leaves of these periods, and of all of them; ``finest``:
    the closest points that the control allows, if they are stated instead of ``points``.
    """
    shown = points if finest is None else finest
    lost = unresolved_periods(points, wanted.periods)
    unit = wanted.kind.unit
    factor, small = (1e3, "µm") if unit == "mm" else (3600.0, "arcsec")
    left, whole = rms
    need, count = _holding(min(lost), wanted)
    most = capacity.max_points
    return Finding.of(
        "CW-F002",
        "info",
        finest=finest is not None,
        allowed=bool(capacity.max_points),
        spacing=Amount(float(np.max(np.diff(shown))), unit, "g"),
        points=shown.size,
        periods=lost,
        unit=unit,
        left_out=len(ignored_periods(points, lost)) == len(lost),
        whole=Amount(whole * factor, small, "2sig"),
        left=Amount(left * factor, small, "2sig"),
        share=left / whole if whole > 0.0 else None,
        needed_spacing=need,
        needed_points=count,
        most_points=most if most is not None and most < count else None,
    )


def _holding(period: float, wanted: WantedCorrection) -> tuple[float, int]:
    """Return the spacing (mm or deg) and number of table points that reproduce a ``period``."""
    need = period / _HOLD
    # Three significant digits, downward, so that the named spacing does hold it.
    digit = 10.0 ** (np.floor(np.log10(need)) - 2)
    need = float(np.floor(need / digit + 1e-9)) * digit
    length = float(wanted.positions[-1] - wanted.positions[0])
    points = int(np.ceil(length / need - 1e-9)) + 1
    return need, points
