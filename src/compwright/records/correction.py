"""The compensation of one axis in any control: a correction by position and approach direction.

A correction is what the control adds to the command, mm or deg. A control may store errors,
increments or actual positions instead. The package ``formats`` converts them to corrections, and
the package ``controllers`` does the same independently.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.facts import AxisFacts, PairTables

Beyond = Literal["hold", "zero"]
#: Between points: straight lines, or the value of the nearest point (the step lies in the middle of
#: the section).
Interpolation = Literal["linear", "step"]
Evidence = Literal["confirmed", "inferred", "unconfirmed"]
#: Who read what a control's files do: two readers that share no code, or one alone.
Judged = Literal["independent", "read_back"]


@dataclass(frozen=True, slots=True)
class ControlFile:
    """A file of a control: its name without folder, and its bytes.

    ``folder``: the folder that the user gave if this file was found in it; empty if the user gave
    the file itself. Files of a folder come in the order of their names, which does not show the
    order in which the control loads them. ``leader``, ``trailer``: what a serial line added before
    and after the text (`serial_line`).
    """

    name: str
    content: bytes
    folder: str = field(default="", compare=False)
    leader: bytes = b""
    trailer: bytes = b""

    @property
    def raw(self) -> bytes:
        """The complete bytes of the file, including the characters that a serial line added before
        and after its text.
        """
        return self.leader + self.content + self.trailer


@dataclass(frozen=True, slots=True)
class Assumption:
    """A fact that no file states and compwright assumes, with its value and the evidence."""

    fact: str
    value: str
    evidence: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisCompensation:
    """The compensation of one axis: a table per approach direction, and backlash compensation.

    - ``positions`` (k,): strictly ascending, machine coordinates. An axis without a table has k =
      0.
    - ``positive``, ``negative`` (k,): the tables' correction for an approach in this direction;
      they are equal if the control has one curve.
    - ``interpolation``: the rule between points. ``below``, ``above``: the rules outside.
    - ``period``: the table of an endless axis repeats. Its points span one period, and the last
      value equals the first.
    - ``backlash``: > 0 is compensated lost motion. The correction by it is zero in the direction
      ``reference_return`` (the zero state), and ``sign * backlash`` in the other direction.
    - ``slope``: a linear parameter in addition to the table or instead of it: ``slope * (x -
      origin)`` everywhere.
    - ``others``: further tables that are active on the axis at the same time.
    """

    address: str
    kind: AxisKind
    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    backlash: float = 0.0
    reference_return: Direction = Direction.POSITIVE
    below: Beyond = "hold"
    above: Beyond = "hold"
    interpolation: Interpolation = "linear"
    period: float | None = None
    slope: float = 0.0
    origin: float = 0.0
    others: tuple[AxisCompensation, ...] = ()

    def curve(self, direction: Direction) -> FloatArray:
        """Return the table (k,) of one approach direction, without backlash."""
        return self.positive if direction is Direction.POSITIVE else self.negative

    def at(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the total correction at ``positions`` (any shape) approached in ``direction``."""
        where = np.asarray(positions, dtype=np.float64)
        total = np.zeros(where.shape)
        if self.positions.size:
            total = self._table_at(where, self.curve(direction))
        total = total + self.slope * (where - self.origin) + self.backlash_at(direction)
        for other in self.others:
            total = total + other.at(where, direction)
        return total

    def _table_at(self, where: FloatArray, curve: FloatArray) -> FloatArray:
        if self.period is not None:
            where = self.positions[0] + np.mod(where - self.positions[0], self.period)
        if self.interpolation == "step":
            # The last bits do not decide on which side of a step a position lies.
            midpoints = np.round(0.5 * (self.positions[1:] + self.positions[:-1]), 9)
            total: FloatArray = curve[np.searchsorted(midpoints, np.round(where, 9), side="right")]
        else:
            total = np.interp(where, self.positions, curve)
        if self.below == "zero":
            total = np.where(where < self.positions[0], 0.0, total)
        if self.above == "zero":
            total = np.where(where > self.positions[-1], 0.0, total)
        return total

    def backlash_at(self, direction: Direction) -> float:
        """Return the backlash compensation for an approach in ``direction``."""
        return 0.0 if direction is self.reference_return else direction.sign * self.backlash

    def total(self, direction: Direction) -> FloatArray:
        """Return the correction (k,) at the table points, including backlash compensation."""
        return self.curve(direction) + self.backlash_at(direction)


def no_compensation(
    address: str, kind: AxisKind, reference_return: Direction = Direction.POSITIVE
) -> AxisCompensation:
    """Return an axis without compensation, as in the state ``none`` of a job."""
    empty = np.empty(0)
    return AxisCompensation(
        address=address,
        kind=kind,
        positions=empty,
        positive=empty,
        negative=empty,
        reference_return=reference_return,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossCompensation:
    """The correction of the axis ``output`` by the position of the axis ``input``, such as for
    squareness or straightness.

    ``positions`` (k,): those of the axis ``input``, strictly ascending, mm or deg. ``positive``,
    ``negative`` (k,): what the control adds to the axis ``output`` while ``input`` is approached in
    this direction, mm or deg of the output. They are equal if one table holds both. The correction
    is linear between points; ``below`` and ``above`` are as in `AxisCompensation`.
    """

    input: str
    output: str
    input_kind: AxisKind
    output_kind: AxisKind
    positions: FloatArray
    positive: FloatArray
    negative: FloatArray
    below: Beyond = "hold"
    above: Beyond = "hold"
    period: float | None = None

    def at(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction of ``output`` with ``input`` at ``positions`` (any shape),
        approached in ``direction``.
        """
        return self.by_input.at(positions, direction)

    @property
    def by_input(self) -> AxisCompensation:
        """The correction as if it were one of the axis ``input``."""
        return AxisCompensation(
            address=self.input,
            kind=self.input_kind,
            positions=self.positions,
            positive=self.positive,
            negative=self.negative,
            below=self.below,
            above=self.above,
            period=self.period,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlState:
    """The compensation that a set of control files contains: that of each axis by its address, and
    the cross-axis tables.

    ``facts``: facts about each axis, by its address. ``tables``: the tables between axes, active or
    not. ``reserved``: those numbers of an array shared by all axes that contain data or to which
    another function refers. ``stays``: by address, the tables of an axis that stay whatever is
    written for it.
    """

    format: str
    axes: Mapping[str, AxisCompensation]
    cross: tuple[CrossCompensation, ...] = ()
    facts: Mapping[str, AxisFacts] = field(default_factory=dict)
    tables: PairTables = field(default_factory=PairTables)
    reserved: frozenset[int] = frozenset()
    stays: Mapping[str, tuple[AxisCompensation, ...]] = field(default_factory=dict)
    assumed: tuple[Assumption, ...] = ()
    findings: tuple[Finding, ...] = ()

    @property
    def pairs(self) -> frozenset[tuple[str, str]]:
        """Return input and output axis of every table between axes, active or not."""
        named = ((entry.input, entry.output) for entry in self.cross)
        return frozenset({*named, *self.tables.used.values()})

    def facts_of(self, address: str) -> AxisFacts:
        """Return the facts about an axis in the files, empty if the files do not name it."""
        return self.facts.get(address, AxisFacts())
