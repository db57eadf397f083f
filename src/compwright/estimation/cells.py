"""The mean readings of an axis at each target and direction, before any model is fitted
(means: ISO 230-2:1997, 2.10; pooled scatter: JCGM 100:2008, 4.2.4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.basis import HARMONICS, alias_wavelength, hidden_share
from compwright.estimation.datum_columns import datum_columns
from compwright.estimation.evidence import CellData
from compwright.estimation.jumps import Jump, find_jumps
from compwright.estimation.noise_posterior import NoisePosterior
from compwright.estimation.observed_test import ObservedCells, ObservedTest, cell_means
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.noise import NoiseDraws
from compwright.records.targets import targets_text
from compwright.words.sentences import Sentence

#: No noise below this is claimed: 10 nm, 0.0036 arcsec (the resolution of the instruments is
#: coarser or equal).
LEAST_NOISE: Final = {AxisKind.LINEAR: 1e-5, AxisKind.ROTARY: 1e-6}
#: From this share on a period counts as hidden: less than 30 % of its amplitude shows in the worse
#: phase.
HIDDEN: Final = 0.7
#: So many second differences tell the roughness of the reversal.
_LEAST_DIFFERENCES: Final = 5
#: Median of the absolute value of a standard normal number.
_MEDIAN_SHARE: Final = 0.6745
#: Roughness up to so many times the variance of the means is taken for noise.
_BEYOND_NOISE: Final = 10.0
_SEED: Final = 202  # by it the noise of one test is paired with that of another


@dataclass(frozen=True, slots=True, kw_only=True)
class Cells:
    """The targets (m,) of an axis with their mean readings, and first estimates of the scatter.

    ``data``: the readings minus ``offset + slope x + d reversal/2`` and minus the ``jumps``, in
    units of ``data.scale``. In the same unit, ``spread`` and ``roughness`` are first estimates of
    the standard deviation of a reading and of the scatter about the line. ``noises``: for each
    test, random draws of the noise of a new test. ``other_noise``: noise draws of the first test
    that has any, or None. ``slopes``: for each test, the column of its slope in ``data.extra``, or
    None. ``repeated``: a target has several readings in one direction of one test.
    ``rough_reversal``: standard deviation, mm or deg, of half the reversal from target to target.
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
    repeated: bool
    noises: tuple[NoiseDraws | None, ...]
    other_noise: NoiseDraws | None
    slopes: tuple[int | None, ...]
    jumps: tuple[Jump, ...] = ()
    rough_reversal: float = 0.0

    def line_at(self, positions: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the straight line, jumps and mean reversal that were subtracted before the fit:
        the sum (k,) in each direction at ``positions``, mm or deg (ISO 230-2:1997, 2.14).
        """
        line = self.offset + self.slope * (positions - self.targets[0])
        for jump in self.jumps:
            line = line + jump.ramp(positions)
        return line + 0.5 * self.reversal, line - 0.5 * self.reversal

    def target_index(self, positions: FloatArray) -> NDArray[np.intp]:
        """Return the index of the target at each position (k,); -1 where no target lies."""
        right = np.clip(np.searchsorted(self.targets, positions), 0, self.targets.size - 1)
        left = np.maximum(right - 1, 0)
        nearest = np.where(
            np.abs(self.targets[left] - positions) < np.abs(self.targets[right] - positions),
            left,
            right,
        )
        same = np.abs(self.targets[nearest] - positions) <= _target_tolerance(self.targets)
        return np.where(same, nearest, -1)


def _target_tolerance(positions: FloatArray) -> float:
    """Return the distance below which two positions count as the same target, mm or deg."""
    return 1e-9 * max(1.0, float(np.max(np.abs(positions), initial=0.0)))


def build_cells(
    tests: Sequence[ObservedTest], *, turn: float | None = None, stepped: bool = True
) -> Cells:
    """Return means, counts and scatter of an axis' readings. ``stepped``: jumps are removed first.

    ``turn``: period of an endless axis, deg, whose error has no slope. ``spread`` pools the squares
    about the means of all targets and directions over their n - 1 (JCGM 100:2008, 4.2.4). Raises
    InputError for fewer than two targets with readings.
    """
    rng = np.random.default_rng(_SEED)
    draws = max((each.noise.draws.count for each in tests if each.noise is not None), default=1)
    orders = []
    for index, each in enumerate(tests):
        own = np.arange(draws) % (draws if each.noise is None else each.noise.draws.count)
        orders.append(rng.permutation(own) if index else own)
    ordered = [(each.noise, order) for each, order in zip(tests, orders, strict=True)]
    noises = tuple(
        None if noise is None else _fresh_noise(noise, order) for noise, order in ordered
    )
    other_noise = next(
        (noise.draws.taken(order) for noise, order in ordered if noise is not None), None
    )
    parts = [
        cell_means(each, order, other_noise) for each, order in zip(tests, orders, strict=True)
    ]
    positions = np.concatenate([part.positions for part in parts])
    targets = _distinct(positions)
    if targets.size < 2:
        raise InputError(
            Fault(
                message="the error of an axis cannot be estimated",
                file=tests[0].test.name,
                expected="readings at two targets or more",
                found=f"readings at {targets.size}",
                hint="measure at two targets or more",
            )
        )
    line = _common_line(parts, targets, endless=turn is not None)
    if stepped:
        line = _refit_without_jumps(parts, targets, line, LEAST_NOISE[tests[0].test.kind], turn)
    return _stack_cells(tests, parts, targets, line, noises, other_noise)


def _fresh_noise(noise: NoisePosterior, order: NDArray[np.intp]) -> NoiseDraws:
    """Return the noise of a repeated test, one draw or more for each noise draw in ``order``."""
    each = noise.fresh.count // noise.draws.count
    return noise.fresh.taken((order[:, np.newaxis] * each + np.arange(each)).ravel())


def _distinct(positions: FloatArray) -> FloatArray:
    """Return the positions (m,) without duplicates, ascending."""
    ordered = np.sort(positions)
    kept = np.diff(ordered, prepend=-np.inf) > _target_tolerance(ordered)
    distinct: FloatArray = ordered[kept]
    return distinct


@dataclass(frozen=True, slots=True)
class _CommonLine:
    """The straight line of an axis: one slope and reversal error, an offset per test; mm or deg."""

    offsets: FloatArray
    slope: float
    reversal: float
    jumps: tuple[Jump, ...] = ()

    def at(self, part: ObservedCells, test: int, first: float) -> FloatArray:
        taken: FloatArray = (
            self.offsets[test]
            + self.slope * (part.positions - first)
            + 0.5 * self.reversal * part.signs
        )
        for jump in self.jumps:
            taken = taken + jump.ramp(part.positions)
        return taken


def _refit_without_jumps(
    parts: Sequence[ObservedCells],
    targets: FloatArray,
    line: _CommonLine,
    least: float,
    turn: float | None,
) -> _CommonLine:
    """Return the straight line through the mean readings ``parts`` of all tests, fitted again after
    jumps between neighbouring targets are removed.

    ``least``: smallest noise assumed, mm or deg; ``turn``: period of an endless axis, deg.
    """
    places = np.concatenate([part.positions for part in parts])
    different = targets
    if turn is not None:  # the end of a turn is its beginning
        places = np.mod(np.round(np.mod(places, turn), 9), turn)
        different = _distinct(places)
    target_index = np.clip(
        np.searchsorted(different, places + _target_tolerance(different)) - 1, 0, None
    )
    lefts = [part.means - line.at(part, k, float(targets[0])) for k, part in enumerate(parts)]
    left = np.concatenate(lefts)
    rough = np.median(np.abs(np.diff(left, 2))) / np.sqrt(6.0) if left.size > 2 else 0.0
    variances = np.concatenate(
        [
            np.full(part.counts.size, rough**2)
            if part.inferred
            else np.mean(1.0 / np.maximum(part.precision, 1e-300), axis=0)
            for part in parts
        ]
    )
    weights = 1.0 / np.maximum(variances, least**2)
    total = np.bincount(target_index, weights)
    means = np.bincount(target_index, weights * left) / total
    jumps = find_jumps(different, means, 1.0 / np.sqrt(total), turn)
    if not jumps:
        return line
    bare = [
        replace(part, means=part.means - sum(jump.ramp(part.positions) for jump in jumps))
        for part in parts
    ]
    return replace(_common_line(bare, targets, endless=turn is not None), jumps=jumps)


def _common_line(
    parts: Sequence[ObservedCells], targets: FloatArray, *, endless: bool
) -> _CommonLine:
    """Return the least-squares line over all readings (JCGM 100:2008, H.3). The mean reversal error
    is computed first, from the targets that were approached in both directions.
    """
    differences = np.concatenate([_reversals(part) for part in parts])
    reversal = float(np.mean(differences)) if differences.size else 0.0
    along = float(np.ptp(targets))
    rows, values, roots = [], [], []
    for index, part in enumerate(parts):
        own = np.zeros((part.positions.size, len(parts) + 1))
        own[:, index] = 1.0
        own[:, -1] = 0.0 if endless else (part.positions - targets[0]) / along
        rows.append(own)
        values.append(part.means - 0.5 * reversal * part.signs)
        roots.append(np.sqrt(part.counts))
    root = np.concatenate(roots)
    solved = np.linalg.lstsq(
        np.vstack(rows) * root[:, np.newaxis], np.concatenate(values) * root, rcond=None
    )[0]
    return _CommonLine(offsets=solved[:-1], slope=float(solved[-1]) / along, reversal=reversal)


def _reversals(part: ObservedCells) -> FloatArray:
    """Return mean(+) - mean(-) at the targets of a test that were approached in both directions."""
    up, down = part.signs > 0, part.signs < 0
    _, mine, theirs = np.intersect1d(
        part.positions[up], part.positions[down], assume_unique=True, return_indices=True
    )
    difference: FloatArray = part.means[up][mine] - part.means[down][theirs]
    return difference


def _rough_reversal(part: ObservedCells) -> float:
    """Return the variance, mm² or deg², of a mean reading that irregular reversal errors cause.

    It is computed from the median of the second differences of the reversal (Gasser, Sroka and
    Jennen-Steinmetz, Biometrika 73, 1986), minus what noise explains. Without this variance, the
    estimated smooth reversal would oscillate between the targets.
    """
    second = np.diff(_reversals(part), 2)
    if part.inferred or second.size < _LEAST_DIFFERENCES:
        return 0.0
    # Variance of a second difference of independent values: 1 + 4 + 1. A reversal has two means.
    each = (float(np.median(np.abs(second))) / _MEDIAN_SHARE) ** 2 / 6.0 / 2.0
    return max(0.0, each - _BEYOND_NOISE * float(np.median(1.0 / part.precision)))


@dataclass(frozen=True, slots=True)
class _Sizes:
    """Typical sizes, mm or deg: of the mean readings minus the straight line, and of the scatter.

    ``roughness``: rms of the means minus the line. ``spread``: standard deviation of a reading.
    ``dof``: degrees of freedom of ``spread``. ``floor``: lower bound of both sizes.
    """

    roughness: float
    spread: float
    dof: float
    floor: float


def _sizes(parts: Sequence[ObservedCells], left: Sequence[FloatArray], least: float) -> _Sizes:
    """Return two typical sizes, mm or deg: of ``left``, the mean readings minus the straight line,
    and of the scatter of readings.

    ``parts``: the mean readings of each test. ``least``: smallest noise that is assumed, mm or deg.
    """
    largest = max(float(np.max(np.abs(part.means))) for part in parts)
    floor = max(least, 1e-9 * largest)
    dof = sum(part.dof for part in parts)
    squares = sum(part.squares for part in parts)
    return _Sizes(
        roughness=max(float(np.sqrt(np.mean(np.concatenate(left) ** 2))), floor),
        spread=float(np.sqrt(squares / dof)) if dof else _neighbour_spread(parts, left),
        dof=dof,
        floor=floor,
    )


def _stack_cells(
    tests: Sequence[ObservedTest],
    parts: Sequence[ObservedCells],
    targets: FloatArray,
    line: _CommonLine,
    noises: tuple[NoiseDraws | None, ...],
    other_noise: NoiseDraws | None,
) -> Cells:
    """Return the mean readings of all tests in one array, by target, divided by a common scale."""
    lines = [line.at(part, index, float(targets[0])) for index, part in enumerate(parts)]
    left = [part.means - taken for part, taken in zip(parts, lines, strict=True)]
    sizes = _sizes(parts, left, LEAST_NOISE[tests[0].test.kind])
    scale = max(sizes.roughness, sizes.spread, sizes.floor)
    floor = max(sizes.floor / scale, 1e-4)
    positions = np.concatenate([part.positions for part in parts])
    target_index = np.clip(
        np.searchsorted(targets, positions + _target_tolerance(targets)) - 1, 0, None
    )
    signs = np.concatenate([part.signs for part in parts])
    order = np.lexsort((-signs, target_index))
    counts = np.concatenate([part.counts for part in parts])
    known = np.concatenate([np.full(part.counts.size, not part.inferred) for part in parts])
    rough = [_rough_reversal(part) for part in parts]
    precision = (
        np.hstack(
            [
                part.precision / (1.0 + more * part.precision)
                for part, more in zip(parts, rough, strict=True)
            ]
        )
        * scale**2
    )
    own = datum_columns(tests, parts, targets, scale)
    data = CellData(
        target_index=target_index[order],
        starts=np.searchsorted(target_index[order], np.arange(targets.size)),
        signs=signs[order],
        values=np.hstack([part.by_draw - taken for part, taken in zip(parts, lines, strict=True)])[
            :, order
        ]
        / scale,
        precision=np.minimum(precision, counts / floor**2)[:, order],
        columns=_blocks([part.columns for part in parts])[:, order] / scale,
        counts=np.where(known, 0.0, counts)[order],
        squares=sum(part.squares for part in parts if part.inferred) / scale**2,
        dof=sum(part.dof for part in parts if part.inferred),
        extra=own.columns[order],
        extra_std=own.stds,
        floor=floor,
        scale=scale,
    )
    return Cells(
        targets=targets,
        data=data,
        offset=float(line.offsets[0]),
        slope=line.slope,
        reversal=line.reversal,
        jumps=line.jumps,
        spread=max(sizes.spread / scale, floor),
        roughness=sizes.roughness / scale,
        readings=int(np.sum(counts)),
        bidirectional=bool(np.any(signs > 0) and np.any(signs < 0)),
        repeated=sizes.dof > 0.0,
        rough_reversal=float(np.sqrt(max(rough) / 2.0)),
        noises=noises,
        other_noise=other_noise,
        slopes=own.slopes,
    )


def _blocks(columns: Sequence[FloatArray]) -> FloatArray:
    """Return the model columns (n, c, q) of several tests, joined in one block-diagonal matrix. The
    column of one test is zero at the readings of all other tests.
    """
    draws = columns[0].shape[0]
    together = np.zeros(
        (draws, sum(each.shape[1] for each in columns), sum(each.shape[2] for each in columns))
    )
    row = column = 0
    for each in columns:
        together[:, row : row + each.shape[1], column : column + each.shape[2]] = each
        row, column = row + each.shape[1], column + each.shape[2]
    return together


def _neighbour_spread(parts: Sequence[ObservedCells], left: Sequence[FloatArray]) -> float:
    """Return the scatter of single readings from differences between neighbouring targets of
    ``left``, the mean readings minus the straight line.

    It is used if no reading is repeated (Gasser, Sroka and Jennen-Steinmetz, Biometrika 73, 1986).
    """
    rows = [
        np.diff(row[part.signs == sign], 2)
        for part, row in zip(parts, left, strict=True)
        for sign in (1.0, -1.0)
    ]
    together = np.concatenate(rows)
    if not together.size:
        return 0.0
    # Variance of a second difference of independent readings: 1 + 4 + 1.
    return float(np.sqrt(np.mean(together**2) / 6.0))


def visible_periods(targets: FloatArray, periods: Sequence[float]) -> tuple[float, ...]:
    """Return the known periods that the ``targets`` (m,) can show, mm or deg. These are neither
    hidden by the spacing (`hidden_share`) nor seen as a longer wave (`alias_wavelength`).
    """
    return tuple(
        float(period)
        for period in periods
        if hidden_share(targets, float(period)) < HIDDEN
        and alias_wavelength(targets, float(period)) is None
    )


def visible_harmonics(targets: FloatArray, period: float) -> tuple[int, ...]:
    """Return the harmonics of a visible period that the ``targets`` (m,) do not confuse with a
    longer wave, mm or deg.
    """
    return tuple(
        harmonic for harmonic in HARMONICS if alias_wavelength(targets, period / harmonic) is None
    )


def estimate_findings(
    cells: Cells,
    travel: tuple[float, float] | None,
    periods: Sequence[float],
    shown: Sequence[float],
    kind: AxisKind,
) -> tuple[Finding, ...]:
    """Return the findings about the estimated error of an axis (``travel`` None: endless axis).
    ``shown``: those of the known ``periods`` that the targets can show.
    """
    unit = kind.unit
    found: list[Finding] = []
    if not cells.bidirectional:
        found.append(Finding.of("CW-E001", "warning"))
    if not cells.repeated:
        found.append(Finding.of("CW-E002", "warning"))
    found += alias_findings(cells.targets, periods, unit)
    found += [
        Finding.of(
            "CW-E003",
            "warning",
            period=period,
            unit=unit,
            better=_targets_text(cells.targets, unit),
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
        found.append(
            Finding.of(
                "CW-E004",
                "info",
                beyond=beyond,
                unit=unit,
                first=cells.targets[0],
                last=cells.targets[-1],
            )
        )
    return tuple(found)


def _targets_text(targets: FloatArray, unit: str) -> Sentence:
    return targets_text(float(targets[0]), float(targets[-1]), targets.size, unit)


def alias_findings(targets: FloatArray, periods: Sequence[float], unit: str) -> list[Finding]:
    """Return the finding CW-E010 for each period that the ``targets`` (m,) show as a longer wave.
    Targets and periods are in ``unit``; CW-E003 reports periods that the targets do not show.
    """
    found = []
    for period in map(float, periods):
        wave = alias_wavelength(targets, period)
        if wave is None or hidden_share(targets, period) >= HIDDEN:
            continue
        interval = float(np.ptp(targets)) / (targets.size - 1)
        longer = 0.0 if np.isinf(wave) else wave
        found.append(
            Finding.of(
                "CW-E010",
                "warning",
                interval=interval,
                unit=unit,
                period=period,
                wave=longer,
                better=_targets_text(targets, unit),
            )
        )
    return found
