"""Tables on one axis -> files of a control that also has tables between axes: two curves go into a
pair of them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from compwright.formats.families.family import Family
from compwright.formats.families.grid.new_files import AxisText
from compwright.formats.families.grid.tables import WrittenTable
from compwright.formats.families.grid.writing import AxisToWrite, GridWriter
from compwright.formats.families.pairs.options import allowed_tables, holds_two_curves
from compwright.formats.families.pairs.writing import CecWriter
from compwright.records.correction import ControlFile


class PairsWriter(GridWriter):
    """Writes a pair of tables instead of one table and backlash if there are two curves."""

    def __init__(
        self, control: Family, files: Sequence[ControlFile], addresses: Iterable[str]
    ) -> None:
        super().__init__(control, files, addresses)
        self.cec = CecWriter(control, self.own)

    def axis(self, work: AxisToWrite) -> list[ControlFile]:
        """See `GridWriter.axis`."""
        self.cec.tables.allowed = allowed_tables(self.definition, work.options)
        if not holds_two_curves(work.options, work.compensation):
            return super().axis(work)
        text = self.text(work, self.control.scale_of(work.axis), WrittenTable((), {}))
        off = self.definition.choice("enabled").text("no")  # so that no correction is active twice
        text = replace(text, singles={**text.singles, "enabled": off})
        left = self.cec.own_pair(work)
        fresh = [self.cec.new_file("two_curves", work.address, left)] if left else []
        self.make_room(work)
        files = [file for file in self.files_for("two_curves") if file.rows is None]
        made = self.new_files(files, text, self._put_pair(text), self.cec.unsaid(left), work)
        return [*fresh, *made]  # what switches tables on is loaded last

    def make_room(self, work: AxisToWrite) -> None:
        """See `GridWriter.make_room`."""
        self.cec.empty_own(work)

    def _put_pair(self, text: AxisText) -> set[str]:
        """Put the single values of a pair into the control's own files where they have a place
        there; return these quantities.
        """
        placed = self.put_backlash(text)
        if self.own is None:
            return placed
        if self.own_values(text, whole=True).get("cross_axis_enabled"):
            placed.add("cross_axis_enabled")
        if self.own.put(
            "enabled", self.own_values(text).get("enabled", ()), text.singles["enabled"]
        ):
            placed.add("enabled")
        return placed

    def speaking(self, addresses: Collection[str]) -> set[int]:
        """See `GridWriter.speaking`."""
        tables = self.cec.tables
        pairs = {(address, address) for address in addresses}
        return super().speaking(addresses) | {
            place.number
            for index, places in tables.places.items()
            if index in tables.kept or tables.in_use.get(index) in pairs
            for found in places.values()
            for place in found
        }
