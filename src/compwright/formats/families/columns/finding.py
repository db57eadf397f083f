"""The files of a control with tables of its own (HEIDENHAIN), sorted."""

from __future__ import annotations

from collections.abc import Sequence

from compwright.formats.definition.schema import Definition
from compwright.formats.families.columns.active_tables import activate
from compwright.formats.families.columns.parameters import take_parameters
from compwright.formats.families.columns.sheets import take_sheet
from compwright.formats.families.columns.sources import AxisNumbers, Sources
from compwright.formats.families.columns.table import UserTable
from compwright.formats.families.columns.table_reading import is_user_table, read_table_text
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile


def find_sources(
    definition: Definition, files: Sequence[ControlFile], axes: Sequence[Axis], faults: list[Fault]
) -> Sources:
    """Return the files sorted; faults of single files and contradictions between them go to
    ``faults``.
    """
    sources = Sources(definition, AxisNumbers(definition, axes))
    reader = text_reader(definition)
    tables: list[UserTable] = []
    for number, file in enumerate(files):
        if is_entry_sheet(file):
            take_sheet(sources, file, number, faults)
        elif is_user_table(file):
            table = read_table_text(definition, file, faults)
            tables += [] if table is None else [table]
        else:
            take_parameters(sources, reader, file, number, faults)
    if not faults:
        activate(sources, tables, axes, faults)
    return sources
