"""Controls whose compensation tables the user exports, and loads again with new values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from compwright.formats.definition.shape_rules import AXIS, NUMBER, KeptLines, ShapeRules
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest
from compwright.formats.families.card_texts import (
    AxisCard,
    CardRequest,
    named_files,
    numbered_files,
    table_values,
)
from compwright.formats.families.columns.axis_pairs import columns_between
from compwright.formats.families.columns.capacity import (
    broken_limits,
    card_values,
    columns_capacity,
)
from compwright.formats.families.columns.file_values import file_values, value_location
from compwright.formats.families.columns.reading import read_columns
from compwright.formats.families.columns.writing import write_columns
from compwright.formats.families.family import Family, Listing, check_tables, in_patched_files
from compwright.formats.text.entry_sheet import is_entry_sheet, read_sheet
from compwright.foundations.errors import CapacityError, raise_all
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.words.sentences import control_text

_COLUMN: Final = r"(?:AXISPOS|BACKLASH|ACTIVE|[A-Z]{1,2}[0-9]?|[0-9]{1,2}=F\([A-Z]?[0-9]?\))"

KEPT: Final = KeptLines(
    whole=(
        r"\[END\]",
        rf"NR(?:\s+(?:{_COLUMN}|[0-9]{{1,2}}))+",
        rf"[0-9]{{1,4}}(?:\s+(?:\*|{NUMBER}|[A-Z]{{1,2}}[0-9]?\s*\.COM))*",
        (
            rf"(?:BEGIN|END)\s+(?:{AXIS}|CONFIG)\s*\.(?:COM|CMA)(?:\s+(?:MM|INCH))?"
            rf"(?:\s+DATUM:\s*{NUMBER})?(?:\s+DIST:\s*{NUMBER})?"
            r"(?:\s+Version:\s*'Update:[0-9.]+(?:\s+Date:[0-9-]+)?')?"
            r"(?:\s+U)?"
        ),
        (
            r"#STRUCT(?:BEGIN|END)|TableDescription\s*\(|columns\s*:=\s*\[|CfgColumnDescription\s*\("
            r"|[)\]]\s*,?"
        ),
        rf"NAME\s*=\s*{_COLUMN}|key\s*:=\s*\"(?:NR|{_COLUMN})\"\s*,?|TYPE\s*=\s*[A-Z]",
        rf"(?:WIDTH|DEC|POS)\s*=\s*{NUMBER}",
        r"primaryKey\s*:=\s*\"(?:NR)?\"\s*,?",
        (
            r"(?:width|initial|minimum|maximum|decimals|unit|unitIsInch|readOnly|unique)\s*:=\s*"
            rf"\"?(?:{NUMBER}|mm|inch|INT|LENGTH|ANGLE|TRUE|FALSE)?\"?\s*,?"
        ),
        rf"MP[0-9]{{1,5}}(?:\.[0-9]{{1,3}}){{0,2}}\s*[:=]?\s*[%$]?{NUMBER}",
    ),
    naming=(r"END\s+\S+?\s*\.(?:COM|CMA)|[0-9]{1,4}(?:\s+(?:[A-Z][A-Z0-9_-]*(?:\s*\.COM)?|\*))+"),
    first=r"\s*BEGIN\s+\S+?\s*\.(?:COM|CMA)\b",
)


RULES = ShapeRules(
    kept=KEPT,
    words="rows in tables that the control exports, or typed in from a sheet",
    grid=("node_position",),
    signs={"backlash": frozenset({"lost_motion"})},
    columns=True,
    typed=frozenset({"bit"}),
)


class ColumnsFamily(Family):
    """The family of controls whose tables are columns in files of the user (HEIDENHAIN .COM)."""

    listing = Listing(file_values=file_values, value_location=value_location)

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``; see `Family.read`."""
        return read_columns(self, files, axes, address=address, activity=activity)

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of one axis' table in mm or deg; see `Family.capacity`."""
        del one_curve
        return columns_capacity(self, axis)

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return the files that load ``compensations`` into the control; see `Family.write`."""
        bound = in_patched_files(self, compensations, axes, files)
        tables, faults = check_tables(
            bound,
            compensations,
            axes,
            lambda axis, table, capacity, _: tuple(broken_limits(bound, axis, table, capacity)),
        )
        raise_all(CapacityError, faults)
        return write_columns(bound, tables, files, self.state)

    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a written table; see `Family.card`."""
        axis, table = request.axis, request.table
        values = table_values(self.definition, self.scale_of(axis), table)
        files = named_files(self, axis, request.files)
        load = {"load": self._loading(request, files)}
        return AxisCard(values | card_values(self, axis, table) | files | load)

    def _loading(self, request: CardRequest, names: Mapping[str, str]) -> str:
        """Return the card's text on how to load the table: as a file, or by typing an entry sheet.

        A control has one .COM file for each moving axis. The text warns not to use the file of
        another axis.
        """
        if not request.table.positions.size:
            return ""
        address, _ = self.address(request.axis)
        name = names.get("file_1") or numbered_files(self.definition, request.axis)["file_1"]
        read = (read_sheet(file, []) for file in request.files if is_entry_sheet(file))
        mine = [sheet.comments for sheet in read if sheet is not None and sheet.axis == address]
        if request.files and all(comments.get("points") == "0" for comments in mine):
            rest = control_text(
                " {file} holds the parameters that are in no file of yours.", file=name
            )
            return control_text(
                "Load your own .COM file of tables/: it holds the table.{rest}",
                rest=rest if mine else "",
            )
        return control_text(
            "Type the sheet {file} into the .COM file that the active line of the .CMA names for"
            " the motion of axis {address}; where it names none, into a new one. Never into one"
            " that it names for another axis.",
            file=name,
            address=address,
        )

    def between(self, request: BetweenRequest) -> Between:
        """Return the table columns for corrections between axes; see `Family.between`."""
        return columns_between(self, request)

    def sheets(
        self, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
    ) -> tuple[ControlFile, ...]:
        """Return written compensations as entry sheets alone; no file of the user is changed."""
        return self.write(compensations, axes)
