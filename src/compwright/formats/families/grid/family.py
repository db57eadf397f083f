"""Tables on one axis: values by index over an even grid, or rows that name their position; beside
them, where the control has them, tables between axes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Self

import numpy as np

from compwright.formats.definition.consistency import has_cross
from compwright.formats.families import limits
from compwright.formats.families.activity import Activity
from compwright.formats.families.between import Asked, Between, instead
from compwright.formats.families.card_words import CURVES, table_values
from compwright.formats.families.family import AxisTable, Family, sound
from compwright.formats.families.grid.capacity import grid_capacity, scale_for_writing
from compwright.formats.families.grid.loading import loading_order
from compwright.formats.families.grid.reading import read_grid
from compwright.formats.families.grid.writing import holds_two_curves, write_table_files
from compwright.formats.families.pairs.between import pairs_between
from compwright.formats.families.pairs.capacity import cec_available, with_cec
from compwright.formats.families.pairs.reading import CEC_PAIR, CEC_UNTOLD
from compwright.formats.families.pairs.view import with_sign_unknown
from compwright.foundations.errors import CapacityError, Fault, raise_all
from compwright.records.axis import Axis, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState, Fact


class GridFamily(Family):
    """Values by index, or rows by position."""

    untold_help = "cec_sign in controller.options (tables that are curves)"
    sign_assumed = False

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """See `Family.read`."""
        state = read_grid(self.definition, self.options, files, axes, address, activity)
        return with_sign_unknown(state) if self.sign_assumed else state

    def for_a_view(self) -> Self:
        """See `Family.for_a_view`: tables between axes are shown as corrections where nobody says
        their sign.
        """
        if self.options.get("cec_sign", "") is not None:
            return self
        shown = self.with_options(cec_sign="correction")
        shown.sign_assumed = True
        return shown

    def untold(self, state: ControlState, address: str) -> str:
        """See `Family.untold`: tables without a sign, or that are no curve."""
        return str(state.facts.get(address, {}).get(CEC_UNTOLD, ""))

    def loading_order(self, files: Sequence[ControlFile]) -> list[str]:
        """See `Family.loading_order`."""
        return loading_order(self.definition, files)

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """See `Family.capacity`. With tables between axes a pair of them holds two curves."""
        options = self.options_of(axis)
        capacity = grid_capacity(self.definition, axis, options, self.state)
        if one_curve or not cec_available(self.definition, options):
            return capacity
        return with_cec(self.definition, axis, options, self.state, capacity)

    def capacity_of(self, axis: Axis, compensation: AxisCompensation) -> Capacity:
        """Return the limits of the place where this table goes: one table and backlash are the
        better home for one curve.
        """
        two = holds_two_curves(self.definition, self.options_of(axis), compensation)
        return self.capacity(axis, one_curve=not two)

    def limits_of_turn(
        self, axis: Axis, compensation: AxisCompensation, capacity: Capacity, label: str
    ) -> Sequence[Fault]:
        """Return what is wrong with the table of an endless axis."""
        faults = super().limits_of_turn(axis, compensation, capacity, label)
        if faults or self.definition.layout.shape != "values_by_index":
            return faults
        return limits.turn(capacity, compensation, label)

    def files_of(
        self, tables: Sequence[AxisTable], files: Sequence[ControlFile], faults: list[Fault]
    ) -> tuple[ControlFile, ...]:
        """See `Family.files_of`."""
        written = write_table_files(
            self.definition, sound(tables), self.options, self.state, files, faults
        )
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return written

    def between(self, asked: Asked) -> Between:
        """See `Family.between`: tables of their own, where the control has them."""
        if cec_available(self.definition, self.options):
            return pairs_between(self, asked)
        return instead(self.definition, asked.planned)

    def card_values(
        self,
        axis: Axis,
        compensation: AxisCompensation,
        facts: Mapping[str, Fact],
        check_at: FloatArray,
    ) -> dict[str, str]:
        """See `Family.card_values`."""
        del check_at
        scale = scale_for_writing(self.definition, axis, self.options)
        values = table_values(self.definition, scale, compensation)
        two = not np.array_equal(compensation.positive, compensation.negative)
        if has_cross(self.definition) and two:
            values[CURVES] = "2"
        pair = str(facts.get(CEC_PAIR, "")).split()
        if len(pair) == 2:
            values |= {"table_positive": pair[0], "table_negative": pair[1]}
        return values
