"""Remove private data from tables of other programs. A mapping profile states which columns have to
stay.

Of all other columns both the name and the cells are removed. Of the text above the table only those
parts stay that are needed to read the table.
"""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from io import StringIO
from typing import Final

from compwright.foundations.redaction import NEUTRAL, Cuts
from compwright.instruments.comments import comment_text
from compwright.instruments.fault_list import FaultList
from compwright.instruments.foreign_table import (
    DELIMITERS,
    cells_of,
    foreign_table,
    named_columns,
)
from compwright.instruments.header_words import axis_above, difference_of, stated_unit
from compwright.instruments.profile import MARK, SIGNS, VERSION, Profile
from compwright.instruments.profile_tables import columns_of
from compwright.instruments.redaction.cutting import redacted_comment
from compwright.instruments.redaction.words import (
    is_axis,
    is_keywords,
    is_one_number,
    without_dates,
)

_COUNT: Final = re.compile(r"[^0-9]*([0-9]{1,3})[^0-9]*")
#: Digits of a run in such words as ``Lauf 3``.
_DIGITS: Final = 3


def redacted_table(lines: Sequence[str], profile: Profile, cuts: Cuts) -> tuple[list[str], Profile]:
    """Return the lines of a table without private data, and a profile with the new column names, by
    which the copy can be read.
    """
    head = profile.header_line
    table = foreign_table(lines, profile.delimiter, head, FaultList(""))
    words = _Words(profile, table.columns, cuts)
    result = [_above(line, cuts) for line in lines[: max(head - 1, 0)]]
    names: tuple[str, ...] = table.columns
    if head:
        written = [_header(cell, cuts) for cell in _cells(lines[head - 1], profile)]
        names = named_columns([" ".join(cell.split()) for cell in written])
        result.append(_joined(written, profile))
    for line in lines[head:]:
        if comment_text(line) is not None:
            result.append(redacted_comment(line, cuts))
        elif not line.strip(" \t,;|"):
            result.append(line)
        else:
            result.append(_joined(words.row(_cells(line, profile)), profile))
    return result, words.renamed(dict(zip(table.columns, names, strict=True)))


#: Text in a profile for a sign that is neither stated in the table nor answered.
SIGN_TO_FILL_IN: Final = (
    f"sign:  # FILL IN: {SIGNS[0]}, if a positive value means that the axis stands too far to +;"
    f" else {SIGNS[1]}"
)


def profile_lines(profile: Profile, *, sign_open: bool) -> str:
    """Return a profile as YAML without remarks. ``sign_open``: leave the sign to be filled in."""
    marks = {character: name for name, character in DELIMITERS.items()}
    keys: dict[str, object] = {
        "layout": profile.layout,
        "encoding": profile.encoding or "",
        "delimiter": marks[profile.delimiter],
        "decimal": {".": "point", ",": "comma"}[profile.decimal],
        "header_line": profile.header_line,
        "axis": profile.axis,
        "axis_column": profile.axis_column,
        "target": profile.target,
        "target_unit": profile.target_unit,
        "value": profile.value,
        "value_is": "measured" if profile.measured else "deviation",
        "unit": profile.unit or "",
        "sign": profile.sign or "",
        "direction_from": profile.direction_from,
        "direction": profile.direction,
        "directions": {word: sign.value for word, sign in profile.directions.items()},
        "run": profile.run,
        "run_counts": profile.run_counts,
        "traverses": {
            column: f"{direction.value}{run}"
            for column, (direction, run) in profile.traverses.items()
        },
        "cycle": profile.cycle or "",
        "leave_out": sorted(profile.leave_out),
    }
    place = profile.position_map
    if place is not None:
        keys["position_map"] = {"sense": place.sense, "offset": place.offset}
    lines = [
        SIGN_TO_FILL_IN
        if sign_open and key == "sign"
        else f"{key}: {json.dumps(value, ensure_ascii=False)}"
        for key, value in keys.items()
    ]
    return "\n".join([f"{MARK}: {VERSION}", *lines, ""])


class _Words:
    """Decides which words stay in the cells of a table, by the meaning of its columns."""

    def __init__(self, profile: Profile, columns: Sequence[str], cuts: Cuts) -> None:
        self.profile, self.columns, self.cuts = profile, columns, cuts
        self.read = set(columns_of(profile))

    def row(self, cells: Sequence[str]) -> list[str]:
        if not self.is_reading(dict(zip(self.columns, cells, strict=False))):
            return [self.cuts.remark(cell, "row next to the table") for cell in cells]
        return [
            self.cell(cell, self.columns[at] if at < len(self.columns) else "")
            for at, cell in enumerate(cells)
        ]

    def is_reading(self, cells: Mapping[str, str]) -> bool:
        """Return whether a row has a target and a value, so that the reader would take it as a
        reading.
        """
        target = cells.get(self.profile.target, "")
        values = (self.profile.value, *self.profile.traverses)
        return any(map(str.isdigit, target)) and any(cells.get(name) for name in values)

    def cell(self, cell: str, column: str) -> str:
        profile = self.profile
        if column not in self.read:
            return self.cuts.remark(cell, "cell")
        if column == profile.axis_column:
            return cell if is_axis(cell) else self.cuts.name(cell)
        if column == profile.direction and profile.direction_from == "column":
            return self.word(cell)
        if column == profile.run and not is_one_number(cell):
            return self.run(cell)
        return cell if is_one_number(cell) else self.cuts.remark(cell, "cell")

    def run(self, cell: str) -> str:
        if not cell or is_keywords(cell, digits=_DIGITS):
            return cell
        number = _COUNT.fullmatch(cell)
        self.cuts.remark(cell, "cell")
        return number[1] if number else NEUTRAL

    def word(self, cell: str) -> str:
        return cell if is_keywords(cell) else self.cuts.name(cell)

    def renamed(self, names: Mapping[str, str]) -> Profile:
        """Return the profile adapted to the redacted table, in which columns have neutral names."""
        profile = self.profile
        return replace(
            profile,
            file=NEUTRAL,
            encoding=profile.encoding,
            axis=profile.axis if is_axis(profile.axis) else self.cuts.name(profile.axis),
            axis_column=names.get(profile.axis_column, ""),
            target=names.get(profile.target, ""),
            value=names.get(profile.value, ""),
            direction=names.get(profile.direction, ""),
            directions={
                self.word(word).casefold(): sign for word, sign in profile.directions.items()
            },
            run=names.get(profile.run, ""),
            traverses={names[name]: one for name, one in profile.traverses.items()},
            leave_out=frozenset(names[name] for name in profile.leave_out if name in names),
            sha256="",
        )


def _cells(line: str, profile: Profile) -> list[str]:
    cells = cells_of(line, profile.delimiter)
    return [line] if cells is None else cells


def _joined(cells: Sequence[str], profile: Profile) -> str:
    if profile.delimiter == " ":
        return " ".join("_".join(cell.split()) for cell in cells)
    out = StringIO()
    csv.writer(out, delimiter=profile.delimiter, lineterminator="").writerow(cells)
    return out.getvalue()


def _header(cell: str, cuts: Cuts) -> str:
    return cell if is_keywords(cell, digits=_DIGITS) else cuts.name(cell, "column")


def _above(line: str, cuts: Cuts) -> str:
    """Return a line of the text above the table, reduced to the axis, the unit, the sign and the
    dates in it.
    """
    dates, rest = without_dates(line)
    if not rest.strip() or is_keywords(rest):
        return line
    axis, unit, sign = axis_above([rest]), stated_unit(rest), difference_of(rest)
    cuts.remark(rest, "text above the table")
    parts = [
        f"axis: {axis}" if axis else "",
        f"unit: {unit}" if unit else "",
        sign,
        *dates,
    ]
    return ", ".join(filter(None, parts)) or NEUTRAL
