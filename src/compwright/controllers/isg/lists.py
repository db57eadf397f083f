"""The lists of an ISG kernel (compensation values, axis parameters, start-up) as statements by
axis.

Each line has one statement ``name value``. ``#`` starts a comment that reaches to the end of the
line; ``/* */`` encloses a comment. Blanks inside the brackets of an index have no meaning. Names
are the same in upper and lower case.

A list belongs to the axis in its header (``kopf.achs_nr``, in other editions ``kopf.log_achs_nr``).
A start-up list also states the axis of each list file.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from compwright.controllers.places import OfLine
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_REMARK = re.compile(r"#[^\n]*|/\*.*?\*/|/\*", re.DOTALL)
_STATEMENT = re.compile(r"([A-Za-z_]\w*(?:\s*\[\s*\d+\s*\]|\.[A-Za-z_]\w*)*)(?:\s+(\S.*))?")
_NUMBER = re.compile(r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?")
#: What a line that is no statement must not hold: it would be one that got damaged.
_OURS = re.compile(r"kopf|kw\s*\.|lr_param|getriebe|achs_kw|zahl_kw", re.IGNORECASE)
#: Statements that correct the position of an axis at rest, and its type; an axis parameter list
#: holds hundreds of others.
_COMPENSATING = re.compile(
    r"kw\.|kenngr\.achs_typ$|lr_param\.(?:ssfk|crosscomp2?|anwahl_losekomp)$|getriebe\[\d+\]\.lose$"
)
_HEADERS = ("kopf.achs_nr", "kopf.log_achs_nr")
#: Logical axis numbers are UNS16.
_HIGHEST_AXIS = 65535


@dataclass(frozen=True, slots=True)
class ListStatement(OfLine):
    """One statement: its name without blanks, in lower case, and the rest of its line."""

    name: str
    text: str
    file: str
    line: int

    @property
    def shown(self) -> str:
        """The value of the statement as written, for messages."""
        return repr(self.text)

    def number(self) -> float | None:
        """Return the value as a decimal number; None if it is not a finite number."""
        value = float(self.text) if _NUMBER.fullmatch(self.text) else math.nan
        return value if math.isfinite(value) else None


@dataclass(slots=True)
class AxisLists:
    """The statements of one axis, by name.

    ``files``: the lists that contain the statements. ``faults``: faults in the statements of this
    axis. They are errors only if the axis is part of the job.
    """

    address: str
    statements: dict[str, ListStatement] = field(default_factory=dict)
    files: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)

    def add(self, statement: ListStatement) -> None:
        """Add a statement; a second one with the same name must have the same value."""
        known = self.statements.setdefault(statement.name, statement)
        if _value(known) != _value(statement):
            self.faults.append(
                statement.fault(
                    f"{statement.name} of axis {self.address} is given twice with different values",
                    expected=f"{known.text!r} as in {known.file}, line {known.line}",
                )
            )

    def number(self, name: str) -> float | None:
        """Return the number that a statement gives; None if it is missing or (with a fault)
        invalid.
        """
        statement = self.statements.get(name)
        if statement is None:
            return None
        value = statement.number()
        if value is None:
            self.fault(statement, f"{name} of axis {self.address}", "a number")
        return value

    def switch(self, name: str) -> bool | None:
        """Return the 0 or 1 that a statement gives; None if it is missing or (with a fault)
        invalid.
        """
        value = self.number(name)
        if value is not None and value not in (0.0, 1.0):
            self.fault(self.statements[name], f"{name} of axis {self.address}", "0 or 1")
            return None
        return None if value is None else value == 1.0

    def whole(self, name: str, lowest: int) -> int | None:
        """Return the whole number, at least ``lowest``, that a statement gives; None if it is
        missing or (with a fault) invalid.
        """
        value = self.number(name)
        if value is not None and (value != int(value) or not lowest <= value < 2**31):
            expected = f"a whole number from {lowest} on"
            self.fault(self.statements[name], f"{name} of axis {self.address}", expected)
            return None
        return None if value is None else int(value)

    def fault(self, statement: ListStatement, message: str, expected: str) -> None:
        """Add a fault with the file and line of a statement."""
        self.faults.append(statement.fault(message, expected=expected))

    def missing(self, name: str, why: str) -> None:
        """Add a fault that a required statement is missing, with the reason why it is required."""
        self.faults.append(
            Fault(
                message=f"axis {self.address}: {why}",
                file=", ".join(dict.fromkeys(self.files)),
                expected=f"a line {name}",
                found="none",
                hint="add this line with its value to the list, or export the list again",
            )
        )

    def section(self, prefix: str) -> dict[str, ListStatement]:
        """Return the statements whose name starts with ``prefix``, by the rest of their name."""
        return {
            name.removeprefix(prefix): statement
            for name, statement in self.statements.items()
            if name.startswith(prefix)
        }


@dataclass(slots=True)
class ControlLists:
    """The contents of all lists: statements by axis number, notes, and faults of no single axis."""

    axes: dict[str, AxisLists] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def read_lists(files: Sequence[ControlFile]) -> ControlLists:
    """Return the statements of all ``files`` by axis, with all faults; nothing is raised."""
    lists = ControlLists()
    read = [(file.name, list(_statements(file, lists))) for file in files]
    started = _start_up([statement for _, found in read for statement in found], lists)
    for name, found in read:
        names = {statement.name for statement in found}
        if any(one.startswith("achs_kw[") for one in names) and not names & set(_HEADERS):
            continue
        if names and all(one.startswith("synchro_data.") for one in names):
            continue  # of a channel: it couples axes and holds no value of one
        address = _address(name, found, started, lists)
        if address is not None and _loaded(name, found, started, lists):
            axis = lists.axes.setdefault(address, AxisLists(address))
            axis.files.append(name)
            for statement in found:
                if _COMPENSATING.match(statement.name):
                    axis.add(statement)
    return lists


def _statements(file: ControlFile, lists: ControlLists) -> Iterable[ListStatement]:
    text = file.content.decode("latin-1").removeprefix("\xef\xbb\xbf")
    if "\x00" in text:
        lists.faults.append(
            Fault(
                message="the file contains a NUL byte (a zero character), so it is not a list "
                "in plain text",
                file=file.name,
                expected="ASCII",
                hint="export the list from the control as plain text",
            )
        )
        return
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    for mark in _REMARK.finditer(text):
        if mark.group() == "/*":
            lists.faults.append(
                Fault(
                    message="the comment that begins in this line has no end",
                    file=file.name,
                    place=f"line {text.count(chr(10), 0, mark.start()) + 1}",
                    hint="close the comment, or export the list from the control again",
                )
            )
            return
    bare = _REMARK.sub(lambda mark: " " + "\n" * mark.group().count("\n"), text)
    for number, raw in enumerate(bare.split("\n"), start=1):
        line = raw.strip()
        if line in {"", ":"}:
            continue
        match = _STATEMENT.fullmatch(line)
        statement = ListStatement(line if match is None else _named(match), "", file.name, number)
        if match is not None and match.group(2):
            yield ListStatement(statement.name, match.group(2).strip(), file.name, number)
        elif _OURS.search(line):
            lists.faults.append(
                statement.fault(
                    "the line contains no statement",
                    expected="a name and a value",
                    found=repr(line),
                )
            )
        else:
            lists.notes.append(f"{file.name}: line {number}: no statement, left alone")


def _named(match: re.Match[str]) -> str:
    """Return a statement's name without blanks and without leading zeros in indices."""
    return re.sub(r"\[0*(\d+)\]", r"[\1]", re.sub(r"\s+", "", match.group(1)).lower())


def _value(statement: ListStatement) -> float | str:
    number = statement.number()
    return statement.text if number is None else number


def _start_up(statements: Iterable[ListStatement], lists: ControlLists) -> dict[str, str] | None:
    """Return the axis number of each list in the start-up list; None without a start-up list."""
    found: dict[str, ListStatement] = {}
    for one in statements:
        if not one.name.startswith(("achs_kw", "zahl_kw")):
            continue
        if _value(found.setdefault(one.name, one)) != _value(one):
            expected = f"{found[one.name].text!r} as before"
            lists.faults.append(
                one.fault(f"{one.name} is given twice with different values", expected=expected)
            )
    if not found:
        return None
    loaded = {}
    count = found["zahl_kw"].number() if "zahl_kw" in found else None
    for name, statement in found.items():
        index = name.removeprefix("achs_kw")
        if not index.startswith("["):
            continue
        if count is not None and int(index[1:-1]) >= count:
            expected = f"zahl_kw {int(index[1:-1]) + 1}, or no such line"
            lists.faults.append(
                statement.fault(
                    "the start-up list has more lists than its number zahl_kw states",
                    expected=expected,
                )
            )
        axis = found.get(f"achs_kw_log_ax_nr{index}")
        number = None if axis is None else _axis_number(axis, lists)
        if axis is None:
            expected = f"a line achs_kw_log_ax_nr{index}"
            lists.faults.append(
                statement.fault("a list of the start-up list has no axis", expected=expected)
            )
        elif number is not None:
            loaded[re.split(r"[/\\]", statement.text)[-1].casefold()] = number
    return loaded


def _axis_number(statement: ListStatement, lists: ControlLists) -> str | None:
    value = statement.number()
    if value is None or value != int(value) or not 1 <= value <= _HIGHEST_AXIS:
        expected = f"a logical axis number, 1 to {_HIGHEST_AXIS}"
        lists.faults.append(statement.fault(statement.name, expected=expected))
        return None
    return str(int(value))


def _address(
    name: str, found: list[ListStatement], started: dict[str, str] | None, lists: ControlLists
) -> str | None:
    """Return the axis number of the list in file ``name``, by the header among its statements
    ``found``, or by the start-up list (``started``: axis number by list name); None, with a fault,
    if it is unknown or contradictory.
    """
    headers = [statement for statement in found if statement.name in _HEADERS]
    numbers = [_axis_number(statement, lists) for statement in headers]
    by_start_up = (started or {}).get(name.casefold())
    if not headers and by_start_up is None:
        expected = "a header kopf.achs_nr with the logical axis number"
        lists.faults.append(
            Fault(
                message="this list does not show to which axis it belongs",
                file=name,
                expected=expected,
                hint=(
                    "add the line kopf.achs_nr with the axis number to the list, or give the "
                    "file the name that the start-up list has for it"
                ),
            )
        )
        return None
    for statement, number in zip(headers, numbers, strict=True):
        other = by_start_up or numbers[0]
        if None not in (number, other) and number != other:
            where = "the start-up list" if by_start_up else f"line {headers[0].line}"
            expected = f"{other} as {where} says"
            lists.faults.append(
                statement.fault("the start-up list gives two axes to one list", expected=expected)
            )
            return None
    return numbers[0] if numbers else by_start_up


def _loaded(
    name: str, found: list[ListStatement], started: dict[str, str] | None, lists: ControlLists
) -> bool:
    """Return whether the control loads the list in file ``name``, whose statements are ``found``.
    If there is a start-up list (``started``: axis number by list name), it must name each
    compensation list.
    """
    if started is None or name.casefold() in started:
        return True
    if not any(statement.name.startswith("kw.") for statement in found):
        return True
    lists.notes.append(f"{name}: the start-up list does not name this list: it is not loaded")
    return False
