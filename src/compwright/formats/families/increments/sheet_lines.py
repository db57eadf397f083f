"""Convert the entry sheet of a FANUC control to lines of a parameter file."""

from __future__ import annotations

import re

from compwright.formats.families.increments import parameters as known
from compwright.formats.text.entry_sheet import SheetRow, read_sheet
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile


def parameter_lines(file: ControlFile, format_id: str, faults: list[Fault]) -> bytes:
    """Return an entry sheet as lines of a parameter file. Errors are added to ``faults``.

    A value keeps its line number, so messages name the right line of the sheet.
    """
    sheet = read_sheet(file, faults)
    if sheet is None:
        return b""
    value = sheet.comments.get("value")
    if value != "correction":
        faults.append(
            Fault(
                message="the entry sheet must give its values as corrections, because the "
                f"increments of {format_id} are corrections",
                file=file.name,
                place=f"line {sheet.lines.get('value', 1)}",
                expected="# value: correction",
                found=f"# value: {value}" if value else "no such line",
                hint=(
                    "enter the values as corrections, then change this line to `# value: "
                    "correction`"
                ),
            )
        )
    if not re.fullmatch(r"[0-9]{1,3}", sheet.axis):
        faults.append(
            Fault(
                message="the sheet must name the axis by its number",
                file=file.name,
                expected="# address: 1",
                found=repr(sheet.axis)[:40],
                hint="add the line `# address: 1` with the axis number of the control",
            )
        )
    lines = [""] * (max(row.line for row in sheet.rows) + 1)
    for row in sheet.rows:
        lines[row.line - 1] = _parameter_line(row, sheet.axis, file.name, faults)
    return "\n".join([*lines[:-1], "%", ""]).encode()


def _parameter_line(row: SheetRow, axis: str, file: str, faults: list[Fault]) -> str:
    if re.fullmatch(r"[0-9]{1,5}", row.point):
        number = int(row.point)
        if number in known.CYCLIC:
            return f"N{number:05d}Q1A{axis}P{row.value.removeprefix('+')}"
        if number >= 10000 or row.position:
            return (
                f"N{number if number >= 10000 else 10000 + number}Q0P{row.value.removeprefix('+')}"
            )
        key = "M" if row.unit == "mm" else "P"
        return f"N{number:05d}Q1A{axis}{key}{row.value.removeprefix('+')}"
    if row.point == "3605#0" and row.value in ("0", "1"):
        return f"N03605Q1A{axis}P0000000{row.value}"
    faults.append(
        Fault(
            message="the first column of this line is not the name of a parameter",
            file=file,
            place=f"line {row.line}",
            expected="a parameter number such as 1851, or 3605#0",
            found=row.point[:40],
            hint="correct the first column of this line",
        )
    )
    return ""
