"""Hidden rows, columns and sheets of a workbook (ECMA-376: 18.3.1.73, 18.3.1.13, 18.2.19).

A spreadsheet program does not show hidden cells, but saves them like all others.
"""

from __future__ import annotations

import posixpath
import re
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from compwright.foundations.errors import InputError
from compwright.foundations.findings import Finding
from compwright.words.sentences import Sentence, say

if TYPE_CHECKING:
    from compwright.instruments.safe_xml import Element

_BOOK: Final = "xl/workbook.xml"
_LINKS: Final = "xl/_rels/workbook.xml.rels"
_TAG: Final = re.compile(rb"<(?:\w+:)?(row|col)(?=[\s/>])([^>]*)>")
_ATTRIBUTE: Final = re.compile(rb"(?<!\S)(hidden|r|min|max)\s*=\s*[\"']([^\"']*)[\"']")
_YES: Final = frozenset({b"1", b"true"})
#: So many rows are named.
_NAMED: Final = 5
#: A sheet has no more columns (ECMA-376, 18.3.1.13): what lies behind is no column.
_COLUMNS: Final = 16384


@dataclass(frozen=True, slots=True)
class Hidden:
    """The hidden rows and columns of a sheet, counted from 1, and whether the whole sheet is
    hidden.
    """

    rows: frozenset[int] = frozenset()
    columns: frozenset[int] = frozenset()
    whole: bool = False


NOTHING_HIDDEN: Final = Hidden()


def hidden_of(archive: zipfile.ZipFile) -> dict[str, Hidden]:
    """Return, by sheet name, which rows, columns and sheets of a workbook are hidden. Sheets whose
    XML part is not found are left out.
    """
    # What is not a workbook needs no reader of XML.
    from compwright.instruments.safe_xml import read_xml

    try:
        book = read_xml(archive.read(_BOOK), _BOOK)
        links = read_xml(archive.read(_LINKS), _LINKS)
    except (InputError, KeyError):
        return {}
    parts = {
        link.attributes.get("Id", ""): posixpath.normpath(
            posixpath.join("/xl", link.attributes.get("Target", ""))
        ).lstrip("/")
        for link in links.children
    }
    names = set(archive.namelist())
    found = {}
    for sheet in book.anywhere("sheet"):
        part = parts.get(_link(sheet), "")
        if part in names:
            whole = sheet.attributes.get("state", "visible") != "visible"
            found[sheet.attributes.get("name", "")] = _of_part(archive.read(part), whole=whole)
    return found


def _link(sheet: Element) -> str:
    """Return the id by which the workbook refers to a sheet, in any XML name space."""
    return next((text for key, text in sheet.attributes.items() if key.endswith(":id")), "")


def _of_part(content: bytes, *, whole: bool) -> Hidden:
    rows: set[int] = set()
    columns: set[int] = set()
    row = 0
    for tag in _TAG.finditer(content):
        attributes = dict(_ATTRIBUTE.findall(tag[2]))
        if tag[1] == b"row":
            row = int(attributes[b"r"]) if attributes.get(b"r", b"").isdigit() else row + 1
        if attributes.get(b"hidden") not in _YES:
            continue
        if tag[1] == b"row":
            rows.add(row)
        else:
            columns.update(_span(attributes))
    return Hidden(frozenset(rows), frozenset(columns), whole)


def _span(attributes: Mapping[bytes, bytes]) -> range:
    first, last = (attributes.get(key, b"") for key in (b"min", b"max"))
    if not (first.isdigit() and last.isdigit()):
        return range(0)
    return range(int(first), min(int(last), _COLUMNS) + 1)


def hidden_finding(hidden: Hidden, lines: Sequence[str]) -> Finding | None:
    """Return the finding that a sheet with these ``lines`` has hidden rows or columns and that
    these were read like the visible ones; None if nothing is hidden.

    The cells in a line are separated by tabs.
    """
    cells = [line.split("\t") for line in lines]
    rows = sorted(row for row in hidden.rows if row <= len(lines) and lines[row - 1])
    columns = sorted(
        column
        for column in hidden.columns
        if any(len(row) >= column and row[column - 1] for row in cells)
    )
    descriptions = list(_descriptions(hidden, rows, columns))
    if not descriptions:
        return None
    return Finding.of("CW-R064", "warning", hidden=descriptions)


def _descriptions(
    hidden: Hidden, rows: Sequence[int], columns: Sequence[int]
) -> Iterator[Sentence]:
    if hidden.whole:
        yield say("CW-R064.sheet")
    if rows:
        more = max(0, len(rows) - _NAMED)
        yield say("CW-R064.rows", number=len(rows), rows=rows[:_NAMED], more=more)
    if columns:
        yield say("CW-R064.columns", number=len(columns), columns=map(_letters, columns))


def _letters(column: int) -> str:
    """Return the letters of a spreadsheet column: A, B, .., Z, AA."""
    name = ""
    while column:
        column, rest = divmod(column - 1, 26)
        name = chr(ord("A") + rest) + name
    return name
