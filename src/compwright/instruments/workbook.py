"""Read Excel workbooks (``.xlsx``) as lines of text, one list per sheet. Numbers keep every
digit.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import date, datetime, time
from io import BytesIO
from itertools import repeat
from typing import Any, Final

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.extras import installing
from compwright.foundations.input_sizes import (
    MOST_SHEET_CELLS,
    MOST_SHEET_PLACES,
    MOST_UNPACKED,
    MOST_UNPACKED_OTHER,
    in_words,
)
from compwright.foundations.one_thread import warnings_ignored
from compwright.instruments.hidden_cells import NOTHING_HIDDEN, Hidden, hidden_of

_SIGNATURE: Final = b"PK\x03\x04"
_FORMULA: Final = re.compile(rb"<(?:\w+:)?f[ />]")
#: A cell or a row that a sheet writes, and an entry in its list of texts.
_CELL: Final = re.compile(rb"<(?:\w+:)?(?:c|row|si)[ />]")
_SHEETS: Final = "xl/worksheets/"
_TABLES: Final = (_SHEETS, "xl/sharedStrings")
_XML: Final = (".xml", ".rels")


@dataclass(frozen=True, slots=True)
class WorkbookSheet:
    """The lines of one sheet. Line n of the sheet is item n - 1; a row without cells is an empty
    line.

    ``hidden``: the rows, columns and sheets that a spreadsheet program does not show.
    """

    name: str
    lines: list[str]
    hidden: Hidden = NOTHING_HIDDEN


def is_workbook(content: bytes) -> bool:
    """Return whether the first bytes are those of a workbook or another zip archive."""
    return content.startswith(_SIGNATURE)


def sheets_of(content: bytes, file: str) -> tuple[WorkbookSheet, ...]:
    """Return the sheets of a workbook that are not empty.

    The value of a formula is the result that the spreadsheet program saved. Raises InputError for a
    zip archive that is not a workbook, for a workbook that is damaged or too large, for a formula
    without a saved result, and if openpyxl (the extra ``excel``) is not installed.
    """
    formulas = _check_size(content, file)
    try:
        import openpyxl
    except ImportError as error:
        raise InputError(
            Fault(
                message="the file is an Excel workbook; reading it needs the package openpyxl",
                file=file,
                hint=f"save the sheet as CSV UTF-8, or {installing('excel')}",
            )
        ) from error
    try:
        with warnings_ignored():  # about parts of a workbook other than its cells
            values = openpyxl.load_workbook(BytesIO(content), read_only=True, data_only=True)
            written = openpyxl.load_workbook(BytesIO(content), read_only=True) if formulas else None
            sheets = tuple(_sheets(values, written, file))
        with zipfile.ZipFile(BytesIO(content)) as archive:
            hidden = hidden_of(archive)
    except InputError:
        raise
    except Exception as error:
        raise InputError(
            Fault(
                message="the file is an Excel workbook that cannot be opened",
                file=file,
                expected="a workbook as a spreadsheet program saves it, or the sheet as CSV UTF-8",
                hint=(
                    "save the workbook again in a spreadsheet program, or save the "
                    "sheet as CSV UTF-8"
                ),
            )
        ) from error
    return tuple(
        replace(sheet, hidden=hidden.get(sheet.name, NOTHING_HIDDEN))
        for sheet in sheets
        if any(sheet.lines)
    )


def _check_size(content: bytes, file: str) -> bool:
    """Check the size of a workbook, and return whether it contains formulas. Raises InputError."""
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            parts = archive.infolist()
            names = {part.filename for part in parts}
    except (zipfile.BadZipFile, ValueError, NotImplementedError) as error:
        raise InputError(
            Fault(
                message="the file is a damaged archive",
                file=file,
                expected="an Excel workbook (.xlsx), or the sheet saved as CSV UTF-8",
                found="an Excel workbook or another zip archive that cannot be opened",
                hint="give an undamaged copy, or save the sheet as CSV UTF-8",
            )
        ) from error
    if "xl/workbook.xml" not in names:
        raise InputError(
            Fault(
                message="the file is a zip archive",
                file=file,
                expected="the files in it, unpacked; or an Excel workbook (.xlsx)",
                found=f"{', '.join(sorted(names)[:3])}, ..",
                hint="unpack it and give the files in it",
            )
        )
    _check_parts(parts, file)
    with zipfile.ZipFile(BytesIO(content)) as archive:
        try:
            return _look_into(archive, [part.filename for part in parts], file)
        except (zipfile.BadZipFile, zlib.error, NotImplementedError, EOFError, RuntimeError):
            return True  # openpyxl says what is wrong with it


def _check_parts(parts: Sequence[zipfile.ZipInfo], file: str) -> None:
    """Raise InputError if the parts of a workbook are too large when unpacked."""
    tables = sum(part.file_size for part in parts if part.filename.startswith(_TABLES))
    others = sum(part.file_size for part in parts if part.filename.endswith(_XML)) - tables
    for size, most, what in (
        (tables, MOST_UNPACKED, "of sheets and texts"),
        (others, MOST_UNPACKED_OTHER, "of styles and names"),
    ):
        if size > most:
            raise InputError(
                Fault(
                    message="the file is too large when unpacked",
                    file=file,
                    expected=f"at most {in_words(most)} {what}",
                    found=in_words(size),
                    hint="save the sheet as CSV UTF-8, which may be larger",
                )
            )


def _look_into(archive: zipfile.ZipFile, names: Sequence[str], file: str) -> bool:
    """Return whether the sheets of a workbook contain formulas. Raises InputError for too many
    cells or an XML document type (DOCTYPE).
    """
    cells, formulas = 0, False
    for name in names:
        if not name.endswith(_XML):
            continue
        part = archive.read(name)
        if b"<!DOCTYPE" in part:
            raise InputError(
                Fault(
                    message=(
                        "the workbook declares a document type (DOCTYPE), which can make "
                        "it grow without end"
                    ),
                    file=file,
                    place=name,
                    expected="a workbook as a spreadsheet program saves it",
                    hint="save the workbook again in a spreadsheet program",
                )
            )
        if name.startswith(_TABLES):
            cells += sum(1 for _ in _CELL.finditer(part))
        formulas = formulas or (name.startswith(_SHEETS) and _FORMULA.search(part) is not None)
    _check_cells(cells, MOST_SHEET_CELLS, file)
    return formulas


def _check_cells(count: int, most: int, file: str, place: str = "") -> None:
    if count > most:
        raise InputError(
            Fault(
                message="the sheet contains too many cells",
                file=file,
                place=place,
                expected=f"at most {most}, including empty ones",
                found=f"{count} or more",
                hint="save the sheet as CSV UTF-8, which may be larger",
            )
        )


def _sheets(values: Any, formulas: Any | None, file: str) -> Iterator[WorkbookSheet]:
    count = 0
    for sheet in values.worksheets:
        lines: list[str] = []
        others = formulas[sheet.title].iter_rows() if formulas else repeat(())
        for row, (cells, written) in enumerate(
            zip(sheet.iter_rows(), others, strict=False), start=1
        ):
            count += max(len(cells), 1)
            _check_cells(count, MOST_SHEET_PLACES, file, f"sheet {sheet.title}")
            for cell, formula in zip(cells, written, strict=False):
                if cell.value is None and formula.data_type == "f":
                    raise InputError(
                        Fault(
                            message="this cell contains a formula without a result",
                            file=file,
                            place=f"sheet {sheet.title}, row {row}",
                            expected="a workbook that a spreadsheet program has calculated and"
                            " saved",
                            found=str(formula.value),
                            hint=(
                                "open the workbook in a spreadsheet program, let it calculate, "
                                "and save it"
                            ),
                        )
                    )
            lines.append(_line([_text(cell) for cell in cells]))
        while lines and not lines[-1]:
            lines.pop()
        yield WorkbookSheet(sheet.title, lines)


def _line(cells: list[str]) -> str:
    """Return the cells of a row as one line, separated by tabs. A comment key and its value in the
    next cell are joined as ``# key: value``.
    """
    while cells and not cells[-1]:
        cells.pop()
    if len(cells) > 1 and cells[0].startswith("#") and ":" not in cells[0]:
        return ": ".join([cells[0], " ".join(cells[1:])])
    return "\t".join(cells)


def _text(cell: Any) -> str:
    value = cell.value
    if value is None:
        return ""
    if cell.data_type == "e":  # `#DIV/0!` at the start of a row is no comment
        return f"({value})"
    if isinstance(value, bool):
        return str(value).upper()
    if isinstance(value, float):
        text = repr(value)
        # three decimals could be thousands marks in a text; a number of a workbook has none
        return f"{text}0" if len(text.partition(".")[2]) == 3 and "e" not in text else text
    if isinstance(value, datetime | date | time):
        return value.isoformat()
    text = " ".join(str(value).split())
    return f'"{text.replace(chr(34), chr(34) * 2)}"' if '"' in text else text
