"""Gantry axes: a table corrects only the leading or only the synchronised axis, so both need the
same one.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from decimal import Decimal

import numpy as np

from compwright.formats.text.gathering import Gathered, Key
from compwright.formats.text.notes import Notes
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import AxisCompensation

#: Two axes of a gantry hold the same table when their corrections nowhere differ by more than this,
#: mm or deg: the last decimal place of a table.
SAME_TABLE = 1e-6


def find_partners(
    gathered: Gathered,
    partners: Mapping[str, str],
    read: Mapping[str, AxisCompensation],
    notes: Notes,
    *,
    of_job: bool,
    single: Collection[str] = (),
) -> None:
    """Note differences between the two axes of a gantry, and two axes that look like a gantry which
    the job does not name.

    ``partners``: synchronised axis by leading axis; ``read``: the compensations read, by address;
    ``of_job``: a job names these axes; ``single``: those that are in no gantry by the files.
    """
    compare_partners(partners, read, notes)
    if not of_job:
        return
    for address, compensation in read.items():
        if compensation.positions.size == 0 or address in (*partners, *partners.values()):
            continue
        for other in gathered.addresses():
            if other not in read and _table(gathered, address) & _table(gathered, other):
                note_twin(address, other, notes, single=address in single)


def compare_partners(
    partners: Mapping[str, str], read: Mapping[str, AxisCompensation], notes: Notes
) -> None:
    """Note differences between the two axes of a gantry; arguments as in `find_partners`."""
    for leading, partner in partners.items():
        if leading in read and partner in read and not _same(read[leading], read[partner]):
            notes.find("CW-S030", "warning", partner=partner, leading=leading)


def note_twin(address: str, other: str, notes: Notes, *, single: bool = False) -> None:
    """Note that an axis of the job and another one hold the same table; ``single``: by the files
    the axis is in no gantry.
    """
    if single:
        notes.find("CW-S031.single", "info", address, axis=address, other=other)
        return
    notes.find("CW-S031.gantry", "warning", address, axis=address, other=other)


def _same(one: AxisCompensation, other: AxisCompensation) -> bool:
    nodes: FloatArray = np.union1d(one.positions, other.positions)
    nodes = nodes if nodes.size else np.zeros(1)
    return all(
        float(np.max(np.abs(one.at(nodes, d) - other.at(nodes, d)))) <= SAME_TABLE
        for d in Direction
    )


def _table(gathered: Gathered, address: str) -> set[tuple[tuple[int, Decimal], ...]]:
    """Return the values of an axis' tables by index, for each measuring system; a table of zeros is
    left out.
    """
    tables = set()
    keys: list[Key] = [key for key in gathered.rows if key[0] == address]
    for key in keys:
        values = {
            int(tokens["index"].text): Decimal(tokens["value"].text)
            for row in gathered.rows[key]
            if "index" in (tokens := row.occurrence.tokens) and "value" in tokens
        }
        if any(value != 0 for value in values.values()):
            tables.add(tuple(sorted(values.items())))
    return tables
