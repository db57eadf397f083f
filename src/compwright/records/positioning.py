"""A positioning test: repeated approaches to target positions of one axis (ISO 230-2 clause 4)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal

import numpy as np

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import AxisKind, Direction, FloatArray, PositionMap
from compwright.records.conditions import Thermal
from compwright.records.environment import ReadingTimes

Cycle = Literal["standard", "step"]

#: Two readings or targets are the same below this, mm or deg: no instrument resolves a picometre,
#: and what remains of one decimal number after conversions of units is far smaller.
SAME_READING: Final = 1e-9
#: Plausible deviations and corrections are below this, mm or deg: above, the unit is probably not
#: the one stated.
LARGEST_PLAUSIBLE: Final = 1.0


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class PositioningTest:
    """The deviations (measured minus target) of one axis in a test, in mm or deg.

    - ``targets`` (m,): strictly ascending.
    - ``positive`` (m, n+), ``negative`` (m, n-): one column per traverse in the order of the run
      numbers. A reading that was not taken is NaN. A direction that was not measured has the width
      0.
    - ``frame``: whether positions and signs are those of the instrument or already those of the
      machine.
    - ``header``: the statements of the file about the test, as text.
    - ``times``: the times of the readings; None if the file does not state them.
    - ``thermal``: the differential expansion that was removed from the deviations; None if they are
      as measured. ``removed``: the amount that was removed from each reading, (m, n+) and (m, n-),
      if it differs from reading to reading.
    """

    name: str
    axis: str
    kind: AxisKind
    targets: FloatArray
    positive: FloatArray
    negative: FloatArray
    runs_positive: tuple[int, ...] = ()
    runs_negative: tuple[int, ...] = ()
    cycle: Cycle = "standard"
    frame: Literal["instrument", "machine"] = "instrument"
    sources: tuple[Source, ...] = ()
    header: Mapping[str, str] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    times: ReadingTimes | None = None
    thermal: Thermal | None = None
    removed: tuple[FloatArray, FloatArray] | None = None

    def __repr__(self) -> str:
        """Return the axis, the targets, the numbers of traverses and the range with units."""
        unit, factor = shown_unit(self.kind.unit), outside_factor(self.kind.unit)
        known = [each[np.isfinite(each)] for each in (self.positive, self.negative)]
        values = np.concatenate(known) * factor
        span = f"{values.min():.2f} to {values.max():.2f} {unit}" if values.size else "no reading"
        ends = f" from {self.targets[0]:g} to {self.targets[-1]:g}" if self.targets.size else ""
        return (
            f"PositioningTest({self.name!r}: axis {self.axis or 'not stated'}, "
            f"{self.targets.size} targets{ends} {self.kind.unit}, traverses "
            f"+{self.positive.shape[1]} -{self.negative.shape[1]}, deviations {span})"
        )

    def deviations(self, direction: Direction) -> FloatArray:
        """Return the deviations (m, n) of one approach direction."""
        return self.positive if direction is Direction.POSITIVE else self.negative

    def readings(self, direction: Direction) -> FloatArray:
        """Return the number of readings (m,) at each target in one direction."""
        counted: FloatArray = np.isfinite(self.deviations(direction)).sum(axis=1).astype(np.float64)
        return counted

    @property
    def bidirectional(self) -> bool:
        """Whether both approach directions were measured."""
        return bool(np.any(np.isfinite(self.positive)) and np.any(np.isfinite(self.negative)))

    @property
    def step(self) -> float:
        """The smallest difference between two unequal readings, mm or deg; 0 if all are equal."""
        values = np.concatenate([self.positive.ravel(), self.negative.ravel()])
        steps = np.diff(np.sort(values[np.isfinite(values)]))
        steps = steps[steps > SAME_READING]
        return float(steps.min()) if steps.size else 0.0


def to_machine(test: PositioningTest, position_map: PositionMap) -> PositioningTest:
    """Return ``test`` in machine coordinates: machine = sense * instrument + offset.

    With sense -1 the instrument counts in the opposite direction. Positions and deviations then
    change sign, and the two directions of approach are exchanged.
    """
    if test.frame == "machine":
        return test
    targets = position_map.sense * test.targets + position_map.offset
    if position_map.sense == 1:
        return replace(test, targets=targets, frame="machine")
    times = test.times
    return replace(
        test,
        targets=targets[::-1].copy(),
        positive=-test.negative[::-1],
        negative=-test.positive[::-1],
        runs_positive=test.runs_negative,
        runs_negative=test.runs_positive,
        times=None
        if times is None
        else replace(times, positive=times.negative[::-1], negative=times.positive[::-1]),
        frame="machine",
    )


def merge(tests: Sequence[PositioningTest], name: str) -> PositioningTest:
    """Return one test from several files of the same axis, with all targets and traverses.

    If a key of the headers has different values, the result has each of them once, one per line.
    Raises InputError if axes, kinds, cycles or frames differ.
    """
    first = tests[0]
    if len(tests) == 1:
        return replace(first, name=name)
    faults = [
        Fault(
            message=f"{what} differs within one test",
            file=other.name,
            expected=str(mine),
            found=str(theirs),
            hint=(f"give the files as separate tests, or correct {what} in one of them"),
        )
        for other in tests[1:]
        for what, mine, theirs in (
            ("axis", first.axis, other.axis),
            ("kind of axis", first.kind, other.kind),
            ("cycle", first.cycle, other.cycle),
        )
        if mine != theirs and mine and theirs
    ]
    if faults:
        raise InputError(*faults)
    targets = np.unique(np.concatenate([test.targets for test in tests]))
    return replace(
        first,
        name=name,
        targets=targets,
        positive=_side_by_side(targets, tests, [test.positive for test in tests]),
        negative=_side_by_side(targets, tests, [test.negative for test in tests]),
        times=_times(targets, tests),
        runs_positive=tuple(range(1, 1 + sum(test.positive.shape[1] for test in tests))),
        runs_negative=tuple(range(1, 1 + sum(test.negative.shape[1] for test in tests))),
        sources=tuple(source for test in tests for source in test.sources),
        header={
            key: "\n".join(dict.fromkeys(test.header[key] for test in tests if key in test.header))
            for key in dict.fromkeys(key for test in tests for key in test.header)
        },
        findings=tuple(finding for test in tests for finding in test.findings),
    )


def _times(targets: FloatArray, tests: Sequence[PositioningTest]) -> ReadingTimes | None:
    """Return the times of the readings in several files, or None if some files lack them."""
    given = [test.times for test in tests if test.times is not None]
    if len(given) < len(tests) or len({each.clock for each in given}) > 1:
        return None
    return ReadingTimes(
        clock=given[0].clock,
        positive=_side_by_side(targets, tests, [each.positive for each in given]),
        negative=_side_by_side(targets, tests, [each.negative for each in given]),
    )


def _side_by_side(
    targets: FloatArray, tests: Sequence[PositioningTest], blocks: Sequence[FloatArray]
) -> FloatArray:
    columns = []
    for test, given in zip(tests, blocks, strict=True):
        block = np.full((targets.size, given.shape[1]), np.nan)
        block[np.searchsorted(targets, test.targets)] = given
        columns.append(block)
    return np.hstack(columns)
