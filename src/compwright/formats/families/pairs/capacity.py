"""The limits of two tables by which an axis corrects itself, one for each direction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.definition.options import resolved_number
from compwright.formats.families.grid.capacity import GridLimits
from compwright.formats.families.pairs.options import (
    allowed_tables,
    free_tables,
    scale_of_pairs,
    too_few,
    unit_unknown,
)
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, raise_all
from compwright.records.capacity import Capacity
from compwright.records.correction import Assumption
from compwright.records.facts import PairTables
from compwright.words.sentences import control_text, unconfirmed


class PairLimits(GridLimits):
    """The limits of an axis' two tables, one per direction, instead of one table with backlash."""

    def capacity(self) -> Capacity:
        """Return the limits of the two tables. Raises CapacityError if the options allow fewer than
        two tables.
        """
        label, kinds = f"axis {self.axis.name}", [self.axis.kind]
        raise_all(CapacityError, list(unit_unknown(self.control, label, self.address, kinds)))
        alone = super().capacity()
        addresses = [self.address]
        if self.axis.gantry is not None:
            addresses.append(normal_text(self.definition, self.axis.gantry))
        points = self._points(addresses)
        scale = scale_of_pairs(self.control, self.axis.kind)
        low, high = scale.range("value")
        room = min(self._room(each) for each in addresses)
        return replace(
            alone,
            curves=2,
            quantum=scale.quantum("value"),
            position_quantum=scale.quantum("table_start"),
            value_range=(max(low, -room), min(high, room)),
            backlash_quantum=None,
            backlash_range=(0.0, 0.0),
            max_points=points,
            below="hold",
            above="hold",
            assumed=(
                *(note for note in alone.assumed if "number of points" not in note.fact),
                *self._assumed(points),
            ),
        )

    def _reserved_by(self) -> str:
        if self.definition.limit("cross_points") is not None:  # a fixed number
            return ""
        return f"MD18342 ({name_of(self.definition, 'cross_max_points')})"

    def _assumed(self, points: int | None) -> list[Assumption]:
        assumed = []
        if points is None:
            assumed.append(
                Assumption(
                    fact=control_text(
                        "axis {name}: number of points of its CEC tables (MD18342)",
                        name=self.axis.name,
                    ),
                    value=control_text("as many as are needed; the card says how many to set"),
                    evidence=unconfirmed(
                        control_text("the control's files do not say it, or reserve none yet")
                    ),
                )
            )
        if self.facts.pairs.max_sum is None:
            assumed.append(
                Assumption(
                    fact=control_text(
                        "axis {name}: limit of the sum of its CEC tables (MD32720)",
                        name=self.axis.name,
                    ),
                    value=control_text("not reached (default 1 {unit})", unit=self.axis.kind.unit),
                    evidence=unconfirmed(
                        control_text("in no file, its default from general knowledge")
                    ),
                )
            )
        return assumed

    def _points(self, addresses: Sequence[str]) -> int | None:
        """Return how many points each table can have; None if there is no limit."""
        tables = self.control.state.tables
        taken = self._tables(addresses, tables)
        fixed = self.definition.limit_number("cross_points")
        if fixed is not None:
            return fixed
        reserved = [points for index in taken if (points := tables.reserved.get(index, 0)) > 0]
        fact = min(reserved, default=None)  # where none are reserved yet the card has it done
        return resolved_number(self.definition, self.points_option(), self.options, fact)

    def _tables(self, addresses: Sequence[str], tables: PairTables) -> list[int]:
        """Return the indices of the tables to write for the axes at ``addresses``, two for each
        axis. ``tables``: the cross-axis tables in the control's files.
        """
        allowed = allowed_tables(self.definition, self.options)
        taken: list[int] = []
        for address in addresses:
            free = free_tables(allowed, tables.used, address)
            taken += [index for index in free if index not in taken][:2]
        needed = 2 * len(addresses)
        if len(taken) < needed:
            fault = too_few(self.axis.name, self.definition.id, needed, len(taken), allowed)
            single = "set `table: {mode: single}` for the axis (one table for both directions)"
            raise CapacityError(replace(fault, hint=f"{fault.hint}; or {single}"))
        return taken

    def _room(self, address: str) -> float:
        """Return how much of the limit CEC_MAX_SUM is left on an axis next to the tables that stay
        active, mm or deg.
        """
        state = self.control.state
        facts = state.facts_of(address).pairs
        if facts.max_sum is None:
            return float("inf")
        others = sum(
            float(np.max(np.abs([entry.positive, entry.negative])))
            for entry in state.cross
            if entry.output == address
        )
        stays = sum(
            float(np.max(np.abs([one.positive, one.negative])))
            for one in state.stays.get(address, ())
        )
        return max(0.0, facts.max_sum - others - stays - facts.odd_sum)
