"""Propose a mapping profile for another program's table, from its header and its numbers.

A sign, a unit or a direction is never guessed. Its key stays empty, and the profile is refused
until the user fills it in.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Final

import numpy as np

from compwright.instruments.csv_table import traverse_of
from compwright.instruments.fault_list import FaultList
from compwright.instruments.foreign_table import (
    DELIMITERS,
    ForeignTable,
    foreign_table,
)
from compwright.instruments.foreign_units import LENGTHS
from compwright.instruments.header_words import (
    Role,
    axis_above,
    difference_of,
    role_of,
    sign_word,
    stated_unit,
    unit_of,
)
from compwright.instruments.profile_tables import traverses_of
from compwright.instruments.table_shape import number_in, shape_of, thousands_in
from compwright.records.axis import FloatArray

#: Lines from which a profile is proposed; the reader sees them all.
_MOST_LINES: Final = 20_000
#: A deviation that is the difference of two other columns is so within this share of its size.
_SAME_SHARE: Final = 1e-3
_MOST_WORDS = 6


@dataclass(slots=True)
class Proposal:
    """A proposed mapping profile.

    ``why``: for each unknown key, in the order of the profile, where the user finds its value.
    ``notes``: observations about the table, as text. ``table``: the table as it was read.
    """

    table: ForeignTable
    keys: dict[str, Any] = field(default_factory=dict)
    why: dict[str, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    def leave_open(self, key: str, why: str) -> None:
        """Leave a key empty for the user to fill in, with the reason."""
        self.keys[key] = None
        self.why[key] = why


def propose(text: Sequence[str], encoding: str, file: str) -> Proposal:
    """Return the proposed profile for the lines of a table. Raises InputError where no table is
    found.
    """
    faults = FaultList(file)
    text = text[:_MOST_LINES]
    shape = shape_of(text)
    if shape is None:
        faults.add(
            "contains no table of numbers",
            expected="rows of at least two columns, one of them with targets",
            found=thousands_in(text),
            hint="give a file with targets in one column and readings in others",
        )
    faults.raise_if_any()
    assert shape is not None  # noqa: S101 - raised above
    delimiter, header_line = shape
    refused = FaultList(file)
    table = foreign_table(text, DELIMITERS[delimiter], header_line, refused)
    if not table.columns:
        refused.raise_if_any()
    proposal = Proposal(table)
    proposal.keys |= {
        "layout": "long",
        "encoding": encoding,
        "delimiter": delimiter,
        "decimal": _decimal(table, proposal),
        "header_line": header_line,
        "axis": "",
    }
    stated = axis_above(text[: max(header_line - 1, 0)])
    if stated:
        proposal.notes.append(f"axis: {stated}, the text above the table says so in every file")
    axes = [name for name in table.columns if role_of(name) == "axis"]
    if len(axes) == 1:
        proposal.keys["axis_column"] = axes[0]
    columns = _ProposedColumns(table, "," if proposal.keys["decimal"] == "comma" else ".")
    target = columns.target()
    proposal.keys["target"] = target
    if target is None:
        proposal.leave_open(
            "target", f"the column with the positions that were commanded{_names(table)}"
        )
    above = text[: max(header_line - 1, 0)]
    _units(proposal, "target_unit", target, columns, [])
    traverses = columns.traverses(target)
    if len(traverses) >= 2:
        _wide(proposal, columns, traverses, above)
    else:
        _long(proposal, columns, target, above)
    _sign(proposal, columns, target, text[:header_line])
    return proposal


def _names(table: ForeignTable) -> str:
    return f" ({', '.join(table.columns[:8])})"


def _decimal(table: ForeignTable, proposal: Proposal) -> str | None:
    marks = Counter(
        mark
        for column in table.cells
        for cell in column
        if number_in(cell, None) is not None
        for mark in ".,"
        if mark in cell
    )
    if len(marks) > 1:
        proposal.why["decimal"] = (
            f"{marks['.']} numbers have a point and {marks[',']} a comma: make them alike"
        )
        return None
    return "comma" if marks[","] else "point"


class _ProposedColumns:
    """The columns of a table, grouped by their probable contents, such as targets or deviations."""

    def __init__(self, table: ForeignTable, decimal: str) -> None:
        self.table, self.decimal = table, decimal
        self.texts = dict(zip(table.columns, table.cells, strict=True))
        self._numbers: dict[str, FloatArray] = {}
        self.roles: dict[str, Role | None] = {name: role_of(name) for name in table.columns}

    def numbers(self, name: str) -> FloatArray:
        """Return the numbers of a column, NaN for a cell that is not a number."""
        if name not in self._numbers:
            found = [number_in(text, self.decimal) for text in self.texts[name]]
            self._numbers[name] = np.array([np.nan if one is None else one for one in found])
        return self._numbers[name]

    def numeric(self, name: str) -> bool:
        values = self.numbers(name)
        return values.size > 0 and float(np.isfinite(values).mean()) > 0.5

    def of(self, role: Role) -> list[str]:
        return [name for name in self.table.columns if self.roles[name] == role]

    def numbers_rows(self, name: str) -> bool:
        """Return whether a column may be a mere numbering of the rows, because none of its values
        is repeated.
        """
        texts = [text for text in self.texts[name] if text]
        return len(texts) > 2 and len(set(texts)) == len(texts)

    def spread(self, name: str) -> float:
        values = self.numbers(name)
        return float(np.nanmax(values) - np.nanmin(values)) if np.isfinite(values).any() else 0.0

    def target(self) -> str | None:
        """Return the column of targets: by its name, else the numeric column with the largest
        range.
        """
        named = [name for name in self.of("target") if self.numeric(name)]
        if len(named) == 1:
            return named[0]
        open_names = named or [
            name for name in self.table.columns if self.numeric(name) and not self.roles[name]
        ]
        ranked = sorted(open_names, key=self.spread, reverse=True)
        if not ranked or (len(ranked) > 1 and self.spread(ranked[0]) < 3 * self.spread(ranked[1])):
            return None
        return ranked[0]

    def traverses(self, target: str | None) -> list[str]:
        """Return the columns that look like a traverse: numbers, named with sign or direction."""
        return [
            name
            for name in self.table.columns
            if name != target
            and self.numeric(name)
            and self.roles[name] not in {"target", "measured", "direction", "axis"}
            and (
                sign_word(name)
                or traverse_of(name.lower())
                or (self.roles[name] == "run" and any(mark.isdigit() for mark in name))
            )
        ]


def _units(
    proposal: Proposal,
    key: str,
    column: str | None,
    columns: _ProposedColumns,
    above: Sequence[str],
) -> None:
    unit = unit_of(column) if column else ""
    if not unit and column:
        unit = unit_of(next((text for text in columns.texts[column] if text), ""))
    unit = unit or next(filter(None, map(stated_unit, above)), "")
    if unit:
        proposal.keys[key] = unit
    else:
        what = "the targets" if key == "target_unit" else "the values"
        proposal.leave_open(key, f"the unit of {what}: um, mm, arcsec, deg, ..")


def _wide(
    proposal: Proposal, columns: _ProposedColumns, traverses: Sequence[str], above: Sequence[str]
) -> None:
    keys = proposal.keys
    keys["layout"] = "wide"
    keys["value_is"] = "deviation"
    if _follows_targets(columns, keys["target"], traverses[0]):
        keys["value_is"] = "measured"
        proposal.notes.append("the values follow the targets: measured positions")
    units = {unit_of(name) for name in traverses} - {""}
    units = units or {unit for line in above if (unit := stated_unit(line))}
    if len(units) == 1:
        keys["unit"] = units.pop()
    else:
        proposal.leave_open("unit", "the unit of the values: um, mm, arcsec, deg, ..")
    counts: Counter[str] = Counter()
    found: dict[str, str | None] = {}
    for name in traverses:
        plain = traverse_of(name.lower())
        word = plain[0] if plain else sign_word(name)
        counts[word] += 1
        number = plain[1] if plain else counts[word]
        found[name] = f"{word}{number}" if word in {"+", "-"} else None
        if found[name] is None:
            meant = {"out": "a way out", "back": "a way back"}.get(word, "its direction unknown")
            proposal.why[f"traverses: {name}"] = (
                f'"+{number}" if approached from below, "-{number}" if from above ({meant})'
            )
    keys["traverses"] = found


def _long(
    proposal: Proposal, columns: _ProposedColumns, target: str | None, above: Sequence[str]
) -> None:
    keys = proposal.keys
    values = columns.of("deviation") or columns.of("measured")
    values = [name for name in values if columns.numeric(name) and name != target]
    if len(values) == 1:
        keys["value"] = values[0]
        measured = columns.roles[values[0]] == "measured"
        follows = target is not None and _follows_targets(columns, target, values[0])
        keys["value_is"] = "measured" if measured or follows else "deviation"
        if measured and not follows:
            proposal.leave_open("value_is", "deviation (from the target) or measured (positions)")
        _units(proposal, "unit", values[0], columns, above)
    else:
        names = _names(columns.table)
        proposal.leave_open(
            "value", f"the column with the deviation, or the measured position{names}"
        )
        proposal.leave_open("value_is", "deviation (from the target) or measured (positions)")
        proposal.leave_open("unit", "the unit of the values: um, mm, arcsec, deg, ..")
    _direction(proposal, columns, target)
    runs = [
        name
        for name in columns.of("run")
        if name not in {target, keys.get("value")} and not columns.numbers_rows(name)
    ]
    keys["run"] = runs[0] if len(runs) == 1 else None
    if keys["run"]:
        keys["run_counts"] = _run_counts(columns, keys)


def _direction(proposal: Proposal, columns: _ProposedColumns, target: str | None) -> None:
    keys = proposal.keys
    worded = columns.of("direction") or [
        name
        for name in columns.table.columns
        if all(sign_word(text) for text in columns.texts[name] if text)
        and any(columns.texts[name])
        and name != target
    ]
    if len(worded) == 1:
        keys["direction_from"], keys["direction"] = "column", worded[0]
        keys["directions"] = _direction_words(proposal, columns, target, worded[0])
        return
    order = _order(columns, target)
    if order == "turns":
        keys["direction_from"] = "order"
        proposal.notes.append(
            "no column tells the direction; the rows go up and down in turns and are taken in the"
            " order of time"
        )
    else:
        hint = ", most likely +" if order == "rising" else ""
        proposal.leave_open(
            "direction_from",
            f'"+" if every target was approached from below{hint}, "-" if from above, "order" if'
            " the rows are in the order of time, or column",
        )


def _direction_words(
    proposal: Proposal, columns: _ProposedColumns, target: str | None, name: str
) -> Mapping[str, str | None]:
    """Return, for each word in a direction column, its sign by the meaning of the word or by the
    order of the targets next to it; None if unknown.
    """
    words = dict.fromkeys(text for text in columns.texts[name] if text)
    found: dict[str, str | None] = {}
    for word in list(words)[:_MOST_WORDS]:
        meant = sign_word(word)
        steps = _steps_of(columns, target, name, word)
        if meant in {"+", "-"}:
            found[word] = meant
        elif len(steps) == 1 and len(words) == 2 and _both_orders(columns, target, name, words):
            found[word] = "+" if steps == {1} else "-"
            proposal.notes.append(f"the targets of '{word}' are in {_ORDER[found[word] or '']}")
        else:
            found[word] = None
            proposal.why[f"directions: {word}"] = '"+" if approached from below, "-" if from above'
    return found


_ORDER = {"+": "rising order", "-": "falling order"}


def _both_orders(
    columns: _ProposedColumns, target: str | None, name: str, words: Mapping[str, None]
) -> bool:
    orders = [_steps_of(columns, target, name, word) for word in words]
    return all(len(order) == 1 for order in orders) and orders[0] != orders[1]


def _steps_of(columns: _ProposedColumns, target: str | None, name: str, word: str) -> set[int]:
    """Return the signs (-1, 0, 1) of the steps between targets whose direction is ``word``."""
    if target is None:
        return set()
    values, texts = columns.numbers(target), columns.texts[name]
    return {
        int(np.sign(b - a))
        for (a, one), (b, other) in pairwise(zip(values, texts, strict=True))
        if one == other == word and np.isfinite(a) and np.isfinite(b)
    }


def _order(columns: _ProposedColumns, target: str | None) -> str:
    """Return the order of the targets: ``turns`` if they rise and fall in turn, ``rising`` if most
    of them rise, else "".
    """
    if target is None:
        return ""
    values = columns.numbers(target)
    values = values[np.isfinite(values)]
    parts = traverses_of(values)
    signs = [{int(np.sign(b - a)) for a, b in pairwise(values[part])} for part in parts]
    if len(parts) > 1 and all(len(sign) == 1 for sign in signs):
        return "turns" if all(a != b for a, b in pairwise(signs)) else ""
    rises = np.diff(values) > 0
    return "rising" if values.size > 1 and float(rises.mean()) > 0.5 else ""


def _run_counts(columns: _ProposedColumns, keys: Mapping[str, Any]) -> str:
    """Return how the column of run numbers counts: ``traverses`` if no number occurs in both
    directions, else ``runs``. ``keys``: the known keys of the proposed profile, which name the
    columns.
    """
    direction = keys.get("direction")
    if not direction:
        return "runs"
    pairs = set(zip(columns.texts[keys["run"]], columns.texts[direction], strict=True))
    runs = Counter(run for run, _ in pairs if run)
    several = len({word for _, word in pairs if word}) > 1
    return "traverses" if several and runs and max(runs.values()) == 1 else "runs"


def _follows_targets(columns: _ProposedColumns, target: str | None, name: str) -> bool:
    """Return whether the values of a column grow with the targets, as measured positions do."""
    if target is None:
        return False
    x, y = columns.numbers(target), columns.numbers(name)
    both = np.isfinite(x) & np.isfinite(y)
    if both.sum() < 2 or np.ptp(x[both]) == 0.0:
        return False
    return abs(float(np.polyfit(x[both], y[both], 1)[0]) - 1.0) < 0.05


def _sign(
    proposal: Proposal, columns: _ProposedColumns, target: str | None, before: Sequence[str]
) -> None:
    keys = proposal.keys
    if keys.get("value_is") == "measured":
        return
    stated = difference_of(str(keys.get("value") or "")) or next(
        filter(None, map(difference_of, before)), ""
    )
    proven = _proven_sign(columns, target, keys.get("value"), keys)
    if proven and stated and proven != stated:
        proposal.leave_open("sign", "the header says one thing, the numbers the other")
    elif proven or stated:
        keys["sign"] = proven or stated
        how = "the numbers of the three columns prove it" if proven else "the header says so"
        proposal.notes.append(f"sign: {keys['sign']}, {how}")
    else:
        proposal.leave_open(
            "sign",
            "measured minus target, if a positive value means that the axis stands too far to +;"
            " else target minus measured",
        )


def _proven_sign(
    columns: _ProposedColumns, target: str | None, value: str | None, keys: Mapping[str, Any]
) -> str:
    """Return the sign of the deviations if a column of measured positions proves it, else ""."""
    measured = [name for name in columns.of("measured") if name != value]
    if target is None or value is None or len(measured) != 1 or not keys.get("unit"):
        return ""
    units = (keys.get("target_unit"), keys.get("unit"))
    if any(unit not in LENGTHS for unit in units):
        return ""
    difference = (columns.numbers(measured[0]) - columns.numbers(target)) * LENGTHS[str(units[0])]
    deviation = columns.numbers(value) * LENGTHS[str(units[1])]
    both = np.isfinite(difference) & np.isfinite(deviation)
    size = float(np.max(np.abs(deviation[both]), initial=0.0))
    for sign, name in ((1.0, "measured minus target"), (-1.0, "target minus measured")):
        error = np.abs(sign * deviation[both] - difference[both])
        if size > 0.0 and np.max(error, initial=0.0) <= max(_SAME_SHARE * size, 6e-4):
            return name
    return ""
