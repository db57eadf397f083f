"""What a control holds for one axis, in neutral form: a correction by position and approach direction.

Correction = what the control adds to the command, mm or deg. A control that stores errors, increments or actual positions is
turned into this by the room ``formats``, and independently of it by ``controllers``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, Direction, FloatArray

Beyond = Literal["hold", "zero"]
Evidence = Literal["confirmed", "inferred", "unconfirmed"]


@dataclass(frozen=True, slots=True)
class ControlFile:
    """A file of a control: its bare name (no folder) and its bytes."""

    name: str
    content: bytes


@dataclass(frozen=True, slots=True)
class Assumption:
    """A fact that was not in the files and had to be assumed."""

    fact: str
    value: str
    evidence: str


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisCompensation:
    """Everything a control does to one axis: a table for each approach direction, and backlash.

    ``positions`` (k,) strictly ascending, machine coordinates; ``positive``, ``negative`` (k,): the tables' correction arriving in
    that direction (equal where the control has one curve). Linear between nodes; ``below`` / ``above`` say what acts
    outside. ``backlash`` > 0 is compensated lost motion: nothing in the direction ``reference_return`` (the zero state),
    ``sign * backlash`` in the other. An axis without a table has k = 0.
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

    def curve(self, direction: Direction) -> FloatArray:
        """Return the table (k,) of one approach direction, without backlash."""
        return self.positive if direction is Direction.POSITIVE else self.negative

    def at(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape) approached in ``direction``, table and backlash together."""
        where = np.asarray(positions, dtype=np.float64)
        total = np.zeros(where.shape)
        if self.positions.size:
            curve = self.curve(direction)
            total = np.interp(where, self.positions, curve)
            if self.below == "zero":
                total = np.where(where < self.positions[0], 0.0, total)
            if self.above == "zero":
                total = np.where(where > self.positions[-1], 0.0, total)
        return total + self.backlash_at(direction)

    def backlash_at(self, direction: Direction) -> float:
        """Return the correction by backlash for an approach in ``direction``."""
        return 0.0 if direction is self.reference_return else direction.sign * self.backlash

    def total(self, direction: Direction) -> FloatArray:
        """Return the correction (k,) at the nodes, table and backlash together."""
        return self.curve(direction) + self.backlash_at(direction)


def no_compensation(address: str, kind: AxisKind, reference_return: Direction = Direction.POSITIVE) -> AxisCompensation:
    """Return an axis on which the control does nothing (the state ``none``)."""
    empty = np.empty(0)
    return AxisCompensation(
        address=address, kind=kind, positions=empty, positive=empty, negative=empty, reference_return=reference_return
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlState:
    """What a set of control files says: compensation by address, and what else they fix.

    ``facts[address]`` holds further quantities by neutral name: ``max_points`` (int), ``enabled`` (bool), ...
    """

    format: str
    axes: Mapping[str, AxisCompensation]
    facts: Mapping[str, Mapping[str, float | int | str | bool]] = field(default_factory=dict)
    assumed: tuple[Assumption, ...] = ()
    findings: tuple[Finding, ...] = ()
