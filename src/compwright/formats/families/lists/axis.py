"""Table and backlash in the lists of one axis."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from compwright.formats.families.lists.backlash import backlash_of
from compwright.formats.families.lists.statements import AxisStatements
from compwright.formats.families.lists.table import ListTable, TableReader
from compwright.records.correction import AxisCompensation


@dataclass(frozen=True, slots=True)
class AxisList:
    """The active compensation of an axis, whether its table is active (None: it has none), and the
    nodes of an inactive table, mm or deg.
    """

    compensation: AxisCompensation
    active: bool | None
    idle: tuple[float, ...] = ()


def read_axis(of: AxisStatements) -> AxisList:
    """Return the compensation in the lists of an axis. Faults go to the notes of ``of``."""
    table = TableReader(of).read()
    active = None
    if table is not None:
        zero = not (np.any(table.positive) or np.any(table.negative))
        active = of.is_active("table_switch", "manual", zero=zero, label=of.label)
    elif not of.lists.places(of.address, "count"):
        of.notes.assume(f"{of.label}: table", "none", "unconfirmed: in no list given")
        of.notes.no_table(of.label)
    empty = np.empty(0)
    shown = ListTable(positions=empty, positive=empty, negative=empty)
    if table is not None and active:
        shown = table
    compensation = AxisCompensation(
        address=of.address,
        kind=of.kind,
        positions=shown.positions,
        positive=shown.positive,
        negative=shown.negative,
        backlash=backlash_of(of, two=shown.two),
        reference_return=of.returns,
        below=of.definition.layout.below,
        above=of.definition.layout.above,
        period=shown.period,
    )
    idle = () if table is None or active else tuple(float(node) for node in table.positions)
    return AxisList(compensation, active, idle)
