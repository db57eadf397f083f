"""Choice of the constant of a correction with which the table is zero at the reference.

The constant can be chosen, because the same constant in both directions only moves the zero of the
axis. It does not change the errors of the axis.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.fitting.problem import UnknownsLayout
from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.capacity import Capacity
from compwright.records.estimate import WantedCorrection


def with_datum(
    wanted: WantedCorrection, layout: UnknownsLayout, capacity: Capacity
) -> tuple[WantedCorrection, tuple[Finding, ...]]:
    """Return ``wanted`` (totals, mm or deg), shifted so that the best table for it is 0 at the
    reference, and the findings about the reference.

    The best table of ``layout`` is then zero in the control's zero state (at the reference, after
    the reference return).
    """
    zeroed, place, findings = zero_in_the_zero_state(wanted, layout.points, capacity)
    if layout.shape == "single":
        zeroed = _shifted(zeroed, _offset_from_mean(zeroed, place, layout, capacity))
    return zeroed, findings


def zero_in_the_zero_state(
    wanted: WantedCorrection, points: FloatArray, capacity: Capacity
) -> tuple[WantedCorrection, float, tuple[Finding, ...]]:
    """Return ``wanted`` shifted so that a table with points ``points`` is zero in the control's
    zero state (at the reference, after the reference return).

    Also returns the position that is zero (mm or deg) and the findings about the reference. The
    reference may be outside a table whose end value the control keeps there. Then the table is zero
    at this end.
    """
    place = wanted.reference
    findings: tuple[Finding, ...] = ()
    if not points[0] <= place <= points[-1]:
        rule = capacity.below if place < points[0] else capacity.above
        findings = (_outside(wanted, points, held=rule == "hold"),)
        place = float(np.clip(place, points[0], points[-1])) if rule == "hold" else place
    home = wanted.total(wanted.reference_return)
    return _shifted(wanted, float(np.interp(place, wanted.positions, home))), place, findings


def _shifted(wanted: WantedCorrection, shift: float) -> WantedCorrection:
    return replace(wanted, positive=wanted.positive - shift, negative=wanted.negative - shift)


def _offset_from_mean(
    wanted: WantedCorrection, place: float, layout: UnknownsLayout, capacity: Capacity
) -> float:
    """Return by how much the wanted correction at ``place`` exceeds the best table with one
    constant reversal value, mm or deg, in the reference-return direction.

    The curve of the fit is the mean of both directions plus or minus half of the reversal value
    (least squares: Draper and Smith, Applied Regression Analysis, 3rd ed. 1998, chapter 1). If the
    curve were forced to the wanted value at the reference, it would bend on both sides of it.
    """
    home = wanted.reference_return
    reversal = wanted.total(home) - wanted.total(home.opposite)
    held = 0.0
    if layout.reversal != "none":
        pieces = np.diff(wanted.positions)
        mean = float(pieces @ (reversal[1:] + reversal[:-1])) / (2.0 * float(pieces.sum()))
        held = mean
        if layout.reversal == "backlash":
            ends = [home.sign * end for end in capacity.backlash_range]
            held = float(np.clip(mean, min(ends), max(ends)))
    here = float(np.interp(place, wanted.positions, reversal))
    return 0.5 * (held - here)


def _outside(wanted: WantedCorrection, points: FloatArray, *, held: bool) -> Finding:
    unit = wanted.kind.unit
    return Finding.of(
        "CW-F003",
        "warning",
        reference=wanted.reference,
        unit=unit,
        start=points[0],
        end=points[-1],
        held=held,
    )
