"""What nodes can hold of what is wanted: periods that they are too far apart for are left out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.fitting.periodic import without_periods
from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.records.axis import FloatArray
from compwright.records.estimate import WantedCorrection

#: A period is held from three points per period on (25 % of its rms is left then).
POINTS_PER_PERIOD: Final = 3.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Grid:
    """``nodes`` (k,) mm or deg; ``wanted``: what is left to fit, without periods that the nodes
    cannot hold.

    ``left_out``: rms of those. ``points_loss``: rms that more points would save, 0 where the number
    of points is no limit. ``kept``: the nodes are those of the grid that is in the control.
    """

    nodes: FloatArray
    wanted: WantedCorrection
    left_out: float = 0.0
    points_loss: float = 0.0
    findings: tuple[Finding, ...] = ()
    kept: bool = False


def grid_of(nodes: FloatArray, wanted: WantedCorrection, *, loss: float = 0.0) -> Grid:
    """Return the grid of given nodes, without the periods that they cannot hold; ``loss``: rms that
    more points would save.
    """
    step = float(np.max(np.diff(nodes)))
    lost = [period for period in wanted.periods if step * POINTS_PER_PERIOD > period * (1 + 1e-9)]
    return leaving_out(nodes, wanted, lost, loss)


def leaving_out(
    nodes: FloatArray, wanted: WantedCorrection, periods: list[float], loss: float = 0.0
) -> Grid:
    """Return the grid with the part of ``periods`` left out, and a finding where that is more than
    nothing.
    """
    if not periods:
        return Grid(nodes=nodes, wanted=wanted, points_loss=loss)
    smooth, rms = without_periods(wanted, periods)
    unit = wanted.kind.unit
    named = ", ".join(f"{period:g}" for period in periods)
    factor, small = (1e3, "µm") if unit == "mm" else (3600.0, "arcsec")
    found = Finding(
        "CW-F002",
        "info",
        f"The spacing of {float(np.max(np.diff(nodes))):g} {unit} cannot hold an error of period"
        f" {named} {unit} (a third of the period is needed): it is left out of the table,"
        f" {significant(rms * factor)} {small} rms",
    )
    return Grid(nodes=nodes, wanted=smooth, left_out=rms, points_loss=loss, findings=(found,))
