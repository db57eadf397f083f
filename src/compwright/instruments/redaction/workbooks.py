"""Copy Excel workbooks without private data: only cells, no properties, notes, formulas or hidden
parts.
"""

from __future__ import annotations

import re
import zipfile
from collections.abc import Sequence
from io import BytesIO
from typing import Final
from xml.sax.saxutils import escape, quoteattr

from compwright.instruments.comments import comment_text
from compwright.instruments.csv_table import row_cells
from compwright.instruments.workbook import WorkbookSheet

#: The first moment that a zip archive can name: a workbook says nothing of the day.
_NO_DATE: Final = (1980, 1, 1, 0, 0, 0)
_NUMBER: Final = re.compile(r"-?(?:0|[1-9][0-9]{0,14})(?:\.[0-9]{1,17})?(?:[eE][+-]?[0-9]{1,3})?")
_MAIN: Final = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_LINKS: Final = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_PACKAGE: Final = "http://schemas.openxmlformats.org/package/2006"
_TYPE: Final = "application/vnd.openxmlformats-officedocument.spreadsheetml"
_HEAD: Final = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'


def workbook_of(sheets: Sequence[WorkbookSheet]) -> bytes:
    """Return the bytes of a workbook with these sheets. In the lines of a sheet the cells are
    separated by tabs.

    Cells with numbers are written as numbers. The header row is written as text, because a number
    would lose the sign of ``+1``.
    """
    count = range(1, len(sheets) + 1)
    parts = {
        "[Content_Types].xml": _types(len(sheets)),
        "_rels/.rels": _links([(f"{_LINKS}/officeDocument", "xl/workbook.xml")]),
        "xl/workbook.xml": _HEAD
        + f'<workbook xmlns="{_MAIN}" xmlns:r="{_LINKS}"><sheets>'
        + "".join(
            f'<sheet name={quoteattr(sheet.name)} sheetId="{n}" r:id="rId{n}"/>'
            for n, sheet in zip(count, sheets, strict=True)
        )
        + "</sheets></workbook>",
        "xl/_rels/workbook.xml.rels": _links(
            [(f"{_LINKS}/worksheet", f"worksheets/sheet{n}.xml") for n in count]
        ),
        **{
            f"xl/worksheets/sheet{n}.xml": _sheet(sheet.lines)
            for n, sheet in zip(count, sheets, strict=True)
        },
    }
    out = BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in parts.items():
            entry = zipfile.ZipInfo(name, _NO_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text.encode())
    return out.getvalue()


def other_parts(content: bytes) -> list[str]:
    """Return the names of the parts of a workbook other than sheets: properties, notes, pictures,
    programs.
    """
    with zipfile.ZipFile(BytesIO(content)) as archive:
        return [
            name
            for name in sorted(archive.namelist())
            if not name.startswith("xl/worksheets/sheet")
            and not name.endswith((".rels", "/"))
            and name not in {"[Content_Types].xml", "xl/workbook.xml"}
        ]


def _types(sheets: int) -> str:
    part = (
        f'<Override PartName="/xl/worksheets/sheet{{}}.xml" ContentType="{_TYPE}.worksheet+xml"/>'
    )
    return (
        _HEAD
        + f'<Types xmlns="{_PACKAGE}/content-types">'
        + '<Default Extension="rels" ContentType='
        + '"application/vnd.openxmlformats-package.relationships+xml"/>'
        + '<Default Extension="xml" ContentType="application/xml"/>'
        + f'<Override PartName="/xl/workbook.xml" ContentType="{_TYPE}.sheet.main+xml"/>'
        + "".join(part.format(n) for n in range(1, sheets + 1))
        + "</Types>"
    )


def _links(targets: Sequence[tuple[str, str]]) -> str:
    return (
        _HEAD
        + f'<Relationships xmlns="{_PACKAGE}/relationships">'
        + "".join(
            f'<Relationship Id="rId{n}" Type="{kind}" Target="{target}"/>'
            for n, (kind, target) in enumerate(targets, start=1)
        )
        + "</Relationships>"
    )


def _sheet(lines: Sequence[str]) -> str:
    rows = []
    header = False
    for number, line in enumerate(lines, start=1):
        comment = comment_text(line) is not None
        cells = [line] if comment else row_cells(line, "\t") or [line]
        if any(cells):
            texts = comment or not header
            made = [_cell(cell, number, at, texts=texts) for at, cell in enumerate(cells) if cell]
            rows.append(f'<row r="{number}">{"".join(made)}</row>')
            header = header or not comment
    return _HEAD + f'<worksheet xmlns="{_MAIN}"><sheetData>{"".join(rows)}</sheetData></worksheet>'


def _cell(text: str, row: int, column: int, *, texts: bool) -> str:
    place = f'r="{_letters(column)}{row}"'
    if not texts and _NUMBER.fullmatch(text):
        return f"<c {place}><v>{text}</v></c>"
    return f'<c {place} t="inlineStr"><is><t xml:space="preserve">{escape(text)}</t></is></c>'


def _letters(column: int) -> str:
    letters = ""
    column += 1
    while column:
        column, rest = divmod(column - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters
