"""Read the descriptions of a table's columns, which newer controls write before the column names.

    BEGIN X.COM MM Version: 'Update:110.24'       BEGIN X.COM MM
    #STRUCTBEGIN                                  TableDescription (
       NAME = X                                     columns:= [
         TYPE = N                                     CfgColumnDescription (
         WIDTH = 12                                     key:="X",
         DEC = 4                                        width:=12,
    #STRUCTEND                                        ... ) ],
    NR  AXISPOS  X                                  primaryKey:="NR"
                                                  )

Source: tables of other kinds that such controls export (pallets, cutting data, tools). They are
public with the reader github drunsinn/pyLSV2 (`table_reader.py`, tests/test_files). No .COM file of
this form was available, so the form is unconfirmed for .COM files. The blank behind a column is not
part of WIDTH, but it is part of ``width``.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import Literal

from compwright.formats.families.columns.table import Described, is_number

#: What may end the first line of a table: the edition of its description, a mark.
EDITION = re.compile(r"(?:[ \t]+Version:[ \t]*'[^']*')?(?:[ \t]+U)?[ \t]*$", re.IGNORECASE)
_STRUCT, _STRUCT_END, _OBJECT = "#STRUCTBEGIN", "#STRUCTEND", "TABLEDESCRIPTION"
_SETTING = re.compile(r"[ \t]*([A-Za-z-]+)[ \t]*:?=[ \t]*\"?([^\"]*?)\"?[ \t]*,?[ \t]*")


@dataclass(frozen=True, slots=True)
class TableDescription:
    """The columns that the head of a table describes, by name in capitals.

    ``key``: the column with the row number. ``lines``: number of lines of the description; None:
    the description has no end.
    """

    columns: Mapping[str, Described] = field(default_factory=dict)
    key: str | None = None
    lines: int | None = 0

    def of(self, name: str) -> Described | None:
        """Return the description of a column; None if the table does not describe it."""
        return self.columns.get(name.upper())

    def fits(self, titles: Sequence[tuple[str, int]]) -> bool:
        """Return whether the distances between the column names (name, character) are the column
        widths that the description states.

        The result is False if no width is described.
        """
        gaps = [
            (
                max(described.width, len(name) if described.blanks else 0) + described.blanks,
                after - start,
            )
            for (name, start), (_, after) in itertools.pairwise(titles)
            if (described := self.of(name)) is not None and described.width is not None
        ]
        return bool(gaps) and all(width == found for width, found in gaps)


def read_description(lines: Sequence[str]) -> TableDescription:
    """Return the description at the beginning of ``lines``, which follow the first line of a table.

    The description is empty if the table has none.
    """
    first = lines[0].strip().upper() if lines else ""
    if first == _STRUCT:
        return _struct(lines)
    if re.fullmatch(_OBJECT + r"[ \t]*\(", first):
        return _object(lines)
    return TableDescription()


def _struct(lines: Sequence[str]) -> TableDescription:
    columns: dict[str, Described] = {}
    name = ""
    for number, line in enumerate(lines):
        if line.strip().upper() == _STRUCT_END:
            return TableDescription(columns, None, number + 1)
        match = _SETTING.fullmatch(line)
        if match is None or line.lstrip().startswith("*"):  # a comment
            continue
        word = match[1].upper()
        if word == "NAME":
            name = match[2].upper()
            columns[name] = Described()
        elif name:
            columns[name] = _with_attribute(columns[name], word, match[2], "struct")
    return TableDescription(columns, None, None)


def _object(lines: Sequence[str]) -> TableDescription:
    columns: dict[str, Described] = {}
    name, key, depth = "", None, 0
    for number, line in enumerate(lines):
        bare = re.sub('"[^"]*"', "", line)
        depth += bare.count("(") + bare.count("[") - bare.count(")") - bare.count("]")
        if depth <= 0:
            return TableDescription(columns, key, number + 1)
        match = _SETTING.fullmatch(line)
        word = match[1].upper() if match else ""
        if match is not None and word == "PRIMARYKEY":
            key = match[2].upper()
        elif match is not None and word == "KEY":
            name = match[2].upper()
            columns[name] = Described()
        elif match is not None and name:
            columns[name] = _with_attribute(columns[name], word, match[2], "object")
    return TableDescription(columns, key, None)


def _with_attribute(
    column: Described, word: str, text: str, form: Literal["struct", "object"]
) -> Described:
    """Return a column's description with the attribute ``word`` (such as the width) set to the
    value ``text``; attributes without a meaning here are ignored. ``form``: the syntax of the
    description.
    """
    yes = text.upper() == "TRUE"
    if word == "WIDTH" and re.fullmatch("[0-9]{1,4}", text):
        return replace(column, width=int(text), blanks=1 if form == "struct" else 0)
    if word == "DEC" and re.fullmatch("[0-9]{1,2}", text):
        return replace(column, decimals=int(text))
    if word == "MINIMUM" and is_number(text):
        return replace(column, least=Decimal(text))
    if word == "MAXIMUM" and is_number(text):
        return replace(column, most=Decimal(text))
    if word == "READONLY":
        return replace(column, read_only=yes)
    if word == "UNITISINCH":
        return replace(column, inch=yes)
    return column
