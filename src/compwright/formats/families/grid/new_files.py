"""New files of a control: the skeletons of its definition with single values and rows filled in."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Definition, WrittenFile
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.text.patching import fresh_file, set_field
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class AxisText:
    """Contents of the control for one axis, as text: rows by field, single values by quantity.

    ``named``: the fields that all its lines have.
    """

    address: str
    named: Mapping[str, str]
    rows: tuple[Mapping[str, str], ...]
    singles: Mapping[str, str]


class NewFile:
    """One file of the definition for one axis."""

    def __init__(self, definition: Definition, file: WrittenFile, text: AxisText) -> None:
        self.definition = definition
        self.file = file
        self.text = text
        self.name = print_form(file.name, {**text.named, "axis": text.address})

    def made(
        self, placed: Collection[str], switches: Sequence[str], faults: list[Fault]
    ) -> ControlFile | None:
        """Return the file; None if it would be empty.

        ``placed``: quantities in the control's own files, which are left out. ``switches``: lines
        before the end of a file without rows.
        """
        rows = self._rows(placed)
        left = rows is not None
        made = fresh_file(self.definition, self.file, self.name, self.text.named, rows or ())
        self._check_lines(rows or (), faults)
        if switches and self.file.rows is None:
            end = len(made.files[0].content) - len(self.definition.dialect.newline)
            made.add_lines(0, end, switches, before=True)
            left = True
        for place in self._occurrences(made.files[0]):
            found = [
                (quantity, binding.field)
                for quantity, binding in self.definition.bindings.items()
                if binding.statement == place.statement
            ]
            if any(quantity in placed for quantity, _ in found):
                made.cut_line(0, next(iter(place.tokens.values())).start)
                continue
            left = True
            for quantity, field in found:
                if quantity in self.text.singles:
                    made.replace(0, *set_field(place, field, self.text.singles[quantity]))
        return made.patched([0])[0] if left or not placed else None

    def _rows(self, placed: Collection[str]) -> list[str] | None:
        """Return the rows of the file; None: no table of this axis."""
        if self.file.rows is None or curves(self.definition)[0] in placed:
            return None
        form = self.definition.statements[self.file.rows].form
        return [print_form(form, {**self.text.named, **row}) for row in self.text.rows]

    def _occurrences(self, skeleton: ControlFile) -> tuple[Occurrence, ...]:
        """Return the places of the single values in the skeleton."""
        faults: list[Fault] = []
        read = text_reader(self.definition).read(skeleton, faults)
        raise_all(InputError, faults)
        return () if read is None else read.occurrences

    def _check_lines(self, rows: Sequence[str], faults: list[Fault]) -> None:
        longest = self.definition.limit_number("line_length")
        worst = max((len(row) for row in rows), default=0)
        if longest is not None and worst > longest:
            fault = Fault(
                message="a line is too long",
                file=self.name,
                expected=f"at most {longest} characters",
                found=str(worst),
                hint=(
                    "give a wider `table: {spacing: ...}`, or load the values by hand from the card"
                ),
            )
            faults.append(fault)
