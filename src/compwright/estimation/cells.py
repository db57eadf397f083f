"""What a test says before any model: means and counts per target and direction (ISO 230-2:1997,
2.10), pooled spread (JCGM 100:2008, 4.2.4), straight line by least squares.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.basis import HARMONICS, folded, hidden_share
from compwright.estimation.evidence import CellData
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.positioning import PositioningTest

#: No noise below this is claimed: 10 nm, 0.0036 arcsec (the resolution of the instruments is
#: coarser or equal).
LEAST_NOISE: Final = {AxisKind.LINEAR: 1e-5, AxisKind.ROTARY: 1e-6}
#: From this share on a period counts as hidden: less than 30 % of its amplitude shows in the worse
#: phase.
HIDDEN: Final = 0.7


@dataclass(frozen=True, slots=True, kw_only=True)
class Cells:
    """Targets with readings (m,), their ``data`` less ``offset + slope x + d reversal/2``, and the
    guesses of the spread.

    ``spread`` and ``roughness`` are in units of ``data.scale``: noise of one reading as guessed,
    scatter about the straight line.
    """

    targets: FloatArray
    data: CellData
    offset: float
    slope: float
    reversal: float
    spread: float
    roughness: float
    readings: int
    bidirectional: bool

    def line_at(self, positions: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return what was taken out (k,) at ``positions`` for the two directions, mm or deg: line
        +- half the mean reversal mean(+) - mean(-) (ISO 230-2:1997, 2.14).
        """
        line = self.offset + self.slope * (positions - self.targets[0])
        return line + 0.5 * self.reversal, line - 0.5 * self.reversal

    def seats(self, positions: FloatArray) -> np.ndarray[tuple[int], np.dtype[np.intp]]:
        """Return for each position (k,) the index of the target that it is, -1 for none."""
        right = np.clip(np.searchsorted(self.targets, positions), 0, self.targets.size - 1)
        left = np.maximum(right - 1, 0)
        nearest = np.where(
            np.abs(self.targets[left] - positions) < np.abs(self.targets[right] - positions),
            left,
            right,
        )
        same = np.abs(self.targets[nearest] - positions) <= 1e-9 * max(
            1.0, float(np.max(np.abs(self.targets)))
        )
        return np.where(same, nearest, -1)


def cells_of(test: PositioningTest, *, endless: bool = False) -> Cells:
    """Return means, counts and spread of a test; an ``endless`` axis has no slope.

    Means as in ISO 230-2:1997, 2.10; the spread pools the squares about the means of all targets
    and directions over their n - 1 (JCGM 100:2008, 4.2.4). Raises InputError for fewer than two
    targets with readings.
    """
    means, counts, squares = [], [], 0.0
    for readings in (test.positive, test.negative):
        there = np.isfinite(readings)
        count = there.sum(axis=1).astype(np.float64)
        held = np.where(there, readings, 0.0)
        mean = held.sum(axis=1) / np.maximum(count, 1.0)
        squares += float(np.sum(np.where(there, readings - mean[:, np.newaxis], 0.0) ** 2))
        means.append(mean)
        counts.append(count)
    kept = counts[0] + counts[1] > 0
    if np.count_nonzero(kept) < 2:
        raise InputError(
            Fault(
                message="the error of an axis cannot be estimated",
                file=test.name,
                expected="readings at two targets or more",
                found=f"readings at {np.count_nonzero(kept)}",
            )
        )
    targets = test.targets[kept]
    return _without_line(
        targets,
        [mean[kept] for mean in means],
        [count[kept] for count in counts],
        squares,
        test.kind,
        endless=endless,
    )


def _without_line(
    targets: FloatArray,
    means: list[FloatArray],
    counts: list[FloatArray],
    squares: float,
    kind: AxisKind,
    *,
    endless: bool,
) -> Cells:
    both = (counts[0] > 0) & (counts[1] > 0)
    bidirectional = bool(np.any(counts[0] > 0) and np.any(counts[1] > 0))
    reversal = float(np.mean((means[0] - means[1])[both])) if np.any(both) else 0.0
    weight = counts[0] + counts[1]
    middle = (
        counts[0] * (means[0] - 0.5 * reversal) + counts[1] * (means[1] + 0.5 * reversal)
    ) / weight
    along = targets - targets[0]
    slope = (
        0.0 if endless else float(np.polyfit(along / along[-1], middle, 1)[0]) / float(along[-1])
    )
    offset = float(np.mean(middle - slope * along))
    left = middle - offset - slope * along
    rows = [
        np.where(count > 0, mean - offset - slope * along - sign * 0.5 * reversal, 0.0)
        for mean, count, sign in zip(means, counts, (1.0, -1.0), strict=True)
    ]
    readings = int(np.sum(weight))
    dof = float(np.sum(np.maximum(counts[0] - 1.0, 0.0)) + np.sum(np.maximum(counts[1] - 1.0, 0.0)))
    largest = max(float(np.max(np.abs(mean))) for mean in means)
    floor = max(LEAST_NOISE[kind], 1e-9 * largest)
    roughness = max(float(np.sqrt(np.mean(left**2))), floor)
    spread = float(np.sqrt(squares / dof)) if dof else _neighbour_spread(rows, counts)
    scale = max(roughness, spread, floor)
    floor = max(floor / scale, 1e-4)
    data = CellData(
        positive=rows[0] / scale,
        negative=rows[1] / scale,
        count_positive=counts[0],
        count_negative=counts[1],
        squares=squares / scale**2,
        dof=dof,
        floor=floor,
        scale=scale,
    )
    return Cells(
        targets=targets,
        data=data,
        offset=offset,
        slope=slope,
        reversal=reversal,
        spread=max(spread / scale, floor),
        roughness=roughness / scale,
        readings=readings,
        bidirectional=bidirectional,
    )


def _neighbour_spread(rows: list[FloatArray], counts: list[FloatArray]) -> float:
    """Return the scatter that second differences of neighbouring targets show: all that single
    readings can tell (Gasser, Sroka and Jennen-Steinmetz, Biometrika 73, 1986).
    """
    parts = [np.diff(row[count > 0], 2) for row, count in zip(rows, counts, strict=True)]
    together = np.concatenate(parts)
    if not together.size:
        return 0.0
    # Variance of a second difference of independent readings: 1 + 4 + 1.
    return float(np.sqrt(np.mean(together**2) / 6.0))


def visible_periods(targets: FloatArray, periods: Sequence[float]) -> tuple[float, ...]:
    """Return the known periods that these targets can show: neither hidden by the spacing
    (`hidden_share`) nor folded to a longer wave (`folded`); ``targets`` (m,), all in mm or deg.
    """
    return tuple(
        float(period)
        for period in periods
        if hidden_share(targets, float(period)) < HIDDEN and folded(targets, float(period)) is None
    )


def visible_harmonics(targets: FloatArray, period: float) -> tuple[int, ...]:
    """Return the harmonics of a visible period that these ``targets`` (m,), mm or deg, show as what
    they are.
    """
    return tuple(harmonic for harmonic in HARMONICS if folded(targets, period / harmonic) is None)


def findings_of(
    cells: Cells,
    travel: tuple[float, float] | None,
    periods: Sequence[float],
    shown: Sequence[float],
    kind: AxisKind,
) -> tuple[Finding, ...]:
    """Return what the user should know about the estimate; ``travel`` None: an endless axis, whose
    error repeats.
    """
    unit = kind.unit
    found: list[Finding] = []
    if not cells.bidirectional:
        message = (
            "Measured in one direction only: the same error is assumed in both, lost motion is not"
            " known."
        )
        found.append(Finding("CW-E001", "warning", message))
    if cells.data.dof == 0:
        message = (
            "One approach per target and direction: the noise is inferred from the scatter between"
            " neighbouring targets."
        )
        found.append(Finding("CW-E002", "warning", message))
    found += folded_findings(cells.targets, periods, unit)
    found += [
        Finding(
            "CW-E003",
            "warning",
            f"The targets cannot show an error of period {period:g} {unit} (their spacing hides"
            " it): it is left out, and a test at other targets may show more than is predicted",
        )
        for period in periods
        if float(period) not in shown and hidden_share(cells.targets, float(period)) >= HIDDEN
    ]
    low, high = (
        (0.0, 0.0)
        if travel is None
        else (travel[0] - cells.targets[0], cells.targets[-1] - travel[1])
    )
    beyond = max(-low, -high)
    if beyond > 0.01 * (cells.targets[-1] - cells.targets[0]):
        message = (
            f"The travel reaches up to {beyond:g} {unit} beyond the measured range"
            f" ({cells.targets[0]:g} to {cells.targets[-1]:g} {unit}): there the error is continued"
            " with the measured slope, and its uncertainty grows"
        )
        found.append(Finding("CW-E004", "info", message))
    if not periods:
        found.append(
            Finding(
                "CW-E005",
                "info",
                "No screw pitch or other period is given: periodic error is not estimated.",
            )
        )
    return tuple(found)


def folded_findings(targets: FloatArray, periods: Sequence[float], unit: str) -> list[Finding]:
    """Return the periods that these ``targets`` (m,) show as longer waves (CW-E010); those that
    they do not show at all are CW-E003's. mm or deg, as ``unit`` says.
    """
    found = []
    for period in map(float, periods):
        wave = folded(targets, period)
        if wave is None or hidden_share(targets, period) >= HIDDEN:
            continue
        interval = float(np.ptp(targets)) / (targets.size - 1)
        longer = "a constant" if np.isinf(wave) else f"a wave of {wave:.4g} {unit}"
        message = (
            f"At these targets, {interval:.4g} {unit} apart, an error of period {period:g} {unit}"
            f" looks like {longer}: the two cannot be told apart, the period is not fitted, and no"
            " limit is accepted. Measure at targets with random offsets to see it"
        )
        found.append(Finding("CW-E010", "warning", message))
    return found
