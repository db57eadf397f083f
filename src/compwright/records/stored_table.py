"""The table of an axis in the rows of its control, in the order of their numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import AxisCompensation


@dataclass(frozen=True, slots=True, kw_only=True)
class StoredTable:
    """The table of an axis, and the rows in which the control stores it.

    - ``compensation``: the table with every point that the control stores, also beyond the travel.
    - ``order`` (r,): the index of the point to which each row belongs; with ``steps``, of the point
      at which its section begins. A section with two rows has the value of the last one.
    - ``steps``: a row holds the change of the correction over a section.
    - ``zero``: the index of the point from which the rows are counted. The correction there is
      stored apart, as a backlash value; a point without a row has no other. None: the rows hold it
      all.
    - ``ahead``: the direction of the first column; the second one holds how much the correction in
      the other direction differs. None: one column for each direction.
    - ``unit``: the correction, mm or deg, of a row with the number 1, if the numbers have a unit of
      their own on each axis; negative if they have the opposite sign.
    """

    compensation: AxisCompensation
    order: NDArray[np.intp]
    steps: bool = False
    zero: int | None = None
    ahead: Direction | None = None
    unit: float = 1.0

    @classmethod
    def by_point(cls, compensation: AxisCompensation) -> StoredTable:
        """Return a table with one row for each point, in the order of the positions."""
        return cls(compensation=compensation, order=np.arange(compensation.positions.size))

    @property
    def row_points(self) -> NDArray[np.intp]:
        """The indices of the points (r,) up to which each row determines the correction."""
        return self.order + 1 if self.steps else self.order

    @property
    def columns(self) -> tuple[Direction, Direction]:
        """The directions of the first and the second column."""
        first = self.ahead or Direction.POSITIVE
        return first, first.opposite

    @property
    def apart(self) -> FloatArray:
        """The correction (2, 1) in + and − that the control stores apart from the rows."""
        if self.zero is None:
            return np.zeros((2, 1))
        one = self.compensation
        return np.array([[one.positive[self.zero]], [one.negative[self.zero]]])

    def rows(self, curve: FloatArray) -> FloatArray:
        """Return the row values (r,) of a table with the corrections ``curve`` (k,)."""
        apart = 0.0 if self.zero is None else curve[self.zero]
        values: FloatArray = np.diff(curve) if self.steps else curve - apart
        return values[self.order]

    def curve(self, rows: FloatArray) -> FloatArray:
        """Return the corrections (k,) of a table with the row values ``rows`` (r,), without the
        correction that is stored apart.
        """
        size = self.compensation.positions.size
        values = np.zeros(size - 1 if self.steps else size)
        values[self.order] = rows
        curve = np.concatenate([[0.0], np.cumsum(values)]) if self.steps else values
        return curve if self.zero is None else curve - curve[self.zero]
