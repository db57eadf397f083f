"""The cross-axis tables in the files, by index, with input axis, output axis and direction."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from compwright.formats.families.pairs.places import Pair
from compwright.records.axis import Direction, FloatArray
from compwright.records.facts import PairFacts


@dataclass(frozen=True, slots=True)
class CecTable:
    """One cross-axis table: the weighted correction of ``output`` at positions of ``input``.

    - ``positions``, ``values`` (k,): mm or deg.
    - ``directions``: the directions of travel in which the table is active.
    - ``period``: the length after which the table repeats; None if it does not repeat.
    - ``active``: no file switches the table off.
    - ``stays``: the table corrects an axis by its own position, and its index must not be written.
    """

    index: int
    input: str
    output: str
    directions: tuple[Direction, ...]
    positions: FloatArray
    values: FloatArray
    period: float | None
    active: bool
    stays: bool = False

    @property
    def pair(self) -> Pair:
        """The input axis and the output axis of the table."""
        return self.input, self.output


@dataclass(frozen=True, slots=True)
class OddTable:
    """A cross-axis table that cannot be used, with the reason.

    ``largest``: the largest correction of the table with its weight, mm or deg; 0 if the table is
    off. ``times``: the index of the table by which the control multiplies this one.
    """

    index: int
    input: str
    output: str
    why: str
    largest: float
    times: int | None = None

    @property
    def pair(self) -> Pair:
        """The input axis and the output axis of the table."""
        return self.input, self.output


@dataclass(frozen=True, slots=True)
class Cec:
    """All cross-axis tables in the files.

    - ``odd``: tables that cannot be read as a curve.
    - ``occupied``: by index, the input axis and the output axis, also of tables that are not in
      ``tables``.
    - ``reserved``: by index, the number of points for which memory is reserved.
    - ``max_sum``: by output axis, the limit for the sum of its tables, mm or deg.
    - ``metric``: by output axis, whether its tables are in mm.
    - ``prints``: by index, eight characters that identify the contents of the table.
    - ``missing``: by axis that they may correct, the tables that are on and in no file.
    """

    tables: tuple[CecTable, ...] = ()
    odd: tuple[OddTable, ...] = ()
    occupied: Mapping[int, Pair] = field(default_factory=dict)
    reserved: Mapping[int, int] = field(default_factory=dict)
    max_sum: Mapping[str, float] = field(default_factory=dict)
    metric: Mapping[str, bool] = field(default_factory=dict)
    prints: Mapping[int, str] = field(default_factory=dict)
    missing: Mapping[str, Sequence[int]] = field(default_factory=dict)

    def left_alone(self, tables: Sequence[CecTable], why: str) -> Cec:
        """Return a copy in which ``tables`` count as tables that cannot be used, for the reason
        ``why``.
        """
        odd = [
            OddTable(one.index, *one.pair, why, float(np.max(np.abs(one.values)))) for one in tables
        ]
        indices = {one.index for one in tables}
        kept = tuple(one for one in self.tables if one.index not in indices)
        return replace(self, tables=kept, odd=(*self.odd, *odd))

    def own_axes(self) -> list[str]:
        """Return the axes that have a table by which they correct themselves, active or not."""
        pairs = [*(table.pair for table in self.tables), *(table.pair for table in self.odd)]
        return list(dict.fromkeys(output for base, output in pairs if base == output))

    def stay(self) -> frozenset[int]:
        """Return the indices of tables by which an axis corrects itself and that stay unchanged."""
        counted = (table.index for table in self.tables if table.stays)
        return frozenset((*counted, *(table.index for table in self.odd if table.largest)))

    def active(self, pair: Pair) -> list[CecTable]:
        """Return the active tables with this input axis and output axis."""
        return [table for table in self.tables if table.pair == pair and table.active]

    def facts(self, address: str, *, sign_known: bool) -> PairFacts:
        """Return facts on the cross-axis tables that correct an axis, such as the limit of the sum
        of these tables. ``sign_known``: an option states whether table values are corrections or
        errors.
        """
        mine = (table for table in self.active((address, address)) if not table.stays)
        own = {table.directions: table.index for table in mine}
        up, down = (own.get((direction,)) for direction in Direction)
        return PairFacts(
            own=(up, down) if len(own) == 2 and up is not None and down is not None else None,
            max_sum=self.max_sum.get(address),
            metric=self.metric.get(address),
            odd_sum=sum(table.largest for table in self.odd if table.output == address),
            uncounted=self._uncounted_tables(address, sign_known=sign_known),
            uncounted_help=(
                "the file with the CEC tables (NC_CEC.INI)"
                if self.missing.get(address)
                else "the option cec_sign (tables that are curves)"
            ),
        )

    def uncounted(self, address: str) -> str:
        """Return as text the active tables that correct an axis but are not part of its
        compensation.

        If the values of these tables change, the text changes too.
        """
        mine = [table for table in self.odd if table.largest and table.output == address]
        return ", ".join(
            f"CEC table {table.index} ({self._print(table)})"
            for table in mine
            if table.times is not None or table.input == address
        )

    def unknown(self, address: str) -> str:
        """Return as text the tables that are on and in no file, and may correct an axis."""
        return ", ".join(
            f"CEC table {index} (on but in no given file)"
            for index in self.missing.get(address, ())
        )

    def _print(self, table: CecTable | OddTable) -> str:
        parts = (table.index, table.times if isinstance(table, OddTable) else None)
        return ", ".join(self.prints.get(index, "-") for index in parts if index is not None)

    def _uncounted_tables(self, address: str, *, sign_known: bool) -> str:
        """Return as text the active tables by which other axes correct this axis and which cannot
        be read as corrections; if not ``sign_known``, that is every such table. Tables that are on
        and in no file may be among them.

        If the values of these tables change, the text changes too.
        """
        active: list[CecTable | OddTable] = [table for table in self.odd if table.largest]
        if not sign_known:
            active += [table for table in self.tables if table.active and table.values.any()]
        mine = [table for table in active if table.output == address != table.input]
        named = [
            f"CEC table {table.index} over {table.input} ({self._print(table)})"
            for table in sorted(mine, key=lambda table: table.index)
        ]
        return ", ".join(filter(None, (*named, self.unknown(address))))
