"""Write compensations into the user's tables and parameters, or else into entry sheets.

No manual shows the text of these files, so compwright does not make such files. It changes only the
user's own files: cells of the axis' own column, and one bit of a mask that was read. Rows are added
in the style of the table. All other bytes stay.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

from compwright.formats.definition.statements import print_form
from compwright.formats.families.columns.filling import ColumnEntry, TableFiller
from compwright.formats.families.columns.source_files import ambiguous, find_sources, mask_of
from compwright.formats.families.columns.table import with_sign
from compwright.formats.families.columns.values import TableValues
from compwright.formats.families.family import AxisTable, Family
from compwright.formats.text.entry_sheet import SheetRow, is_entry_sheet, write_sheet
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import Notes
from compwright.formats.text.patching import Patches, set_field
from compwright.formats.text.scale import NotHeld
from compwright.formats.text.values import name_of
from compwright.foundations.errors import CapacityError, Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, ControlFile, ControlState


def write_columns(
    control: Family, pairs: Sequence[AxisTable], files: Sequence[ControlFile], found: ControlState
) -> tuple[ControlFile, ...]:
    """Return the files that load the tables of ``pairs`` (address, axis, table) into the control.
    ``found``: what was active before, by the job's answer too.

    The result contains all of the user's own ``files``, patched, so that the set is complete. Only
    old entry sheets are left out. Values that no file has a place for are put into one entry sheet
    per axis. Raises InputError for files that cannot be read, CapacityError with everything that
    cannot be written exactly, UsageError if a value to be replaced is in no file.
    """
    if files:
        _refuse_unknown_backlash(control, pairs, files)
    own = [file for file in files if not is_entry_sheet(file)]
    written = _OwnTables(control, {address: axis for address, axis, _ in pairs}, own, found)
    faults: list[Fault] = []
    sheets: list[ControlFile] = []
    for address, axis, compensation in pairs:
        try:
            sheet = written.put(address, axis, compensation)
        except NotHeld as error:
            faults.append(
                Fault(
                    message=f"axis {axis.name} ({address}): the table cannot be written: {error}",
                    hint=f"correct `table` of axis {axis.name} in the job",
                )
            )
        except CapacityError as error:
            faults.extend(error.faults)
        else:
            sheets += [] if sheet is None else [sheet]
    raise_all(CapacityError, faults)
    return (*written.patched(range(len(own))), *sheets)


def _refuse_unknown_backlash(
    control: Family, pairs: Sequence[AxisTable], files: Sequence[ControlFile]
) -> None:
    """Raise UsageError if a table with a backlash replaces an existing backlash value that none of
    the files contains.
    """
    given = find_sources(control.definition, files, [axis for _, axis, _ in pairs], []).given
    name = name_of(control.definition, "backlash")
    questions = [
        Fault(
            message=(
                f"axis {axis.name} ({address}): {name} is in none of the control's files that "
                "were given, but the new table overwrites it. Its existing value would be "
                "missing in the total"
            ),
            place="states",
            expected=f"{name} as it is in the control now",
            found="no value",
            hint=(
                f"add the file with {name} to the control's files (`states` or `--state`), or an "
                f"entry sheet of {address} with the line `{name},,0.0000,{axis.kind.unit}` if it "
                "is 0"
            ),
        )
        for address, axis, compensation in pairs
        if (address, "backlash") not in given
        and Decimal(ColumnEntry(control, axis, compensation).parameters()["backlash"])
    ]
    raise_all(UsageError, questions)


class _OwnTables(Patches):
    """Collects the changes to the tables and parameters in the user's own files."""

    def __init__(
        self,
        control: Family,
        axes: Mapping[str, Axis],
        own: Sequence[ControlFile],
        found: ControlState,
    ) -> None:
        super().__init__(control.definition.dialect, own)
        self.control = control
        self.found = found
        notes = Notes()
        self.sources = find_sources(control.definition, own, list(axes.values()), notes.faults)
        raise_all(InputError, notes.faults)
        self.values = TableValues(control, self.sources, axes, notes)

    def put(self, address: str, axis: Axis, compensation: AxisCompensation) -> ControlFile | None:
        """Record the changes for one axis; return an entry sheet for the values that no file of the
        user has a place for, None if all have one.
        """
        entry = ColumnEntry(self.control, axis, compensation)
        points: list[SheetRow] = []
        if not entry.line:
            if self.sources.own_column(address) is not None:
                TableFiller(self, self.values, address, entry).fill()
            else:
                points = entry.rows()
        left = {
            name: text
            for name, text in entry.parameters().items()
            if not self._parameter(address, name, text)
        }
        wanted = left.get("enabled", "")
        for cross in self.found.cross if wanted else ():
            if cross.output == address and bool(cross.positive.any()) != (wanted == "1"):
                self._check_other_tables(address, awake=wanted == "1")
        rows = [*points, *entry.parameter_rows(left)]
        return self._sheet(address, entry, rows, len(points)) if rows else None

    def _sheet(
        self, address: str, entry: ColumnEntry, rows: Sequence[SheetRow], points: int
    ) -> ControlFile:
        file = next(file for file in self.control.definition.writing if file.rows is not None)
        meaning = str(entry.options["table_values"])
        comments = [
            ("axis", entry.axis.name),
            ("address", address),
            ("format", self.control.definition.id),
            ("value", meaning),
            ("points", str(points)),
            (
                "note",
                (
                    f"values of points are {meaning}s as the control is assumed to expect them:"
                    " check the sign, see the card"
                ),
            ),
            ("note", f"positions are machine coordinates in {entry.axis.kind.unit}"),
        ]
        return write_sheet(print_form(file.name, {"axis": address}), comments, rows)

    def _parameter(self, address: str, quantity: str, text: str) -> bool:
        """Record the new text of a parameter in the user's files; return False if no file contains
        it.
        """
        given = self.sources.given.get((address, quantity), [])
        found = [place for place in given if place.occurrence.tokens]
        for place in found:
            if quantity == "enabled":
                self._bit(address, place, text)
            elif Decimal(place.text) != Decimal(text):
                self._set(place, with_sign(place.text, text))
        return bool(found)

    def _set(self, place: FoundValue, text: str) -> None:
        self.replace(place.number, *set_field(place.occurrence, "value", text))

    def _bit(self, address: str, place: FoundValue, text: str) -> None:
        """Record the change of an axis' bit in a bit mask, in addition to the changes of other
        axes' bits in the same mask.
        """
        known = self.text(place.number, place.occurrence.tokens["value"])
        number, mask = self.sources.numbers.number(address), mask_of(known)
        if number is None or mask is None or mask >> (number - 1) & 1 == int(text):
            return
        self._check_other_tables(address, awake=text == "1")
        changed = mask ^ 1 << (number - 1)
        new = f"%{changed:0{len(known) - 1}b}" if known.startswith("%") else str(changed)
        self._set(place, f"%{changed:b}" if ambiguous(new) else new)

    def _check_other_tables(self, address: str, *, awake: bool) -> None:
        """Raise NotHeld if a change of the axis' bit would also change the effect of tables that
        follow other axes.

        The bit in the activation parameter selects every table that corrects the axis, not only the
        axis' own table. If it becomes 1 (``awake``), columns of other tables that correct this axis
        would be activated too. If it becomes 0, they would be deactivated.
        """
        column = self.sources.column_of(address)
        others = [
            f"{table.file} ({address} over {moving})"
            for moving, table in self.sources.tables.items()
            if moving != address and table.fills(column)
        ]
        if others:
            name = name_of(self.control.definition, "enabled")
            what = "would activate the values" if awake else "would switch off the active values"
            other = "set the bit to 1" if awake else "choose `method: table` for this axis"
            raise NotHeld(
                f"the bit of {address} in {name} has to become {int(awake)}, which {what} in"
                f" {', '.join(others)}. Next: {other}, or empty these columns; repeat the test,"
                " then give the files as they are then"
            )
