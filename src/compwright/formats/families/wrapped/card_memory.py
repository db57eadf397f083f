"""The state of a motion control card (PMAC) after it has executed scripts: tables and settings.

Two orders are checked here: that in which the card allows tables to be defined and deleted
(ERR003), and that in which scripts are sent.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.wrapped.preprocessor import ConditionalBlock
from compwright.formats.text.gathering import FoundValue
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Motors of the largest card.
MOST_MOTORS = 32
Kind = Literal["COMP", "BLCOMP", "TCOMP"]


@dataclass(frozen=True, slots=True)
class Word:
    """A piece of a script: its text, its file and line, and its numeric value if it is a number.

    ``number``: the index of its file among the given files. ``start``, ``end``: the bytes of that
    file at which the piece begins and ends. ``value``: its number, None if it is not a number.
    """

    text: str
    file: str
    number: int
    line: int
    start: int
    end: int
    value: int | None = None

    @property
    def found(self) -> FoundValue:
        """The piece as a value with file and line, for findings."""
        return FoundValue(self.text, Occurrence("script", self.file, self.line, {}), self.number)

    def fault(self, message: str, *, expected: str = "", found: str | None = None) -> Fault:
        """Return a fault that names the file and line of this piece of a script."""
        text = self.text if found is None else found
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=text,
            hint=(
                "correct this line in a copy of the file, or save the script from the control again"
            ),
        )


@dataclass(slots=True)
class MemoryTable:
    """A table in a motor's memory: the number of entries that its definition requires, and the
    entries that follow in the script.

    ``desired``: the commanded position selects the entry, not the actual one. ``plane``: the
    positions of two motors select the entry.
    """

    kind: Kind
    motor: int
    word: Word
    needed: int
    source: int = 0
    target: int = 0
    desired: bool = True
    plane: bool = False
    entries: Word | None = None
    length: Word | None = None
    values: list[Word] = field(default_factory=list)

    @property
    def counts(self) -> int:
        """The table length in counts of the encoder whose position selects the table entry."""
        return 0 if self.length is None else int(self.length.text)

    @property
    def numbers(self) -> tuple[int, ...]:
        """The table's entries as numbers.

        Entry i, counted from 1, belongs to the position i * length / (number of entries).
        """
        return tuple(int(word.text) for word in self.values)

    @property
    def label(self) -> str:
        """The name of the table in messages."""
        return f"#{self.motor} {self.kind}"


@dataclass(slots=True)
class Script:
    """The tables and settings of a control after it has executed scripts one after the other.

    - ``tables``: the tables by kind and motor.
    - ``settings``: all assignments to compensation quantities, by quantity and motor (0: all
      motors). The last one is in effect.
    - ``programs``: by quantity and motor, an assignment inside a program.
    - ``commands``: every definition, deletion and setting, in the order of the files.
    - ``conditional``: commands in a conditional block, with their motor. They are possibly not
      sent.
    - ``apart``: commands that are in another branch of a conditional block than an earlier command,
      with their motor and the earlier command.
    - ``shared``: values that one command assigns to more than one variable.
    """

    files: tuple[ControlFile, ...]
    tables: dict[tuple[Kind, int], MemoryTable] = field(default_factory=dict)
    settings: dict[tuple[str, int], list[Word]] = field(default_factory=dict)
    programs: dict[tuple[str, int], Word] = field(default_factory=dict)
    commands: list[tuple[str, int, Word]] = field(default_factory=list)
    conditional: list[tuple[int, Word, ConditionalBlock]] = field(default_factory=list)
    apart: list[tuple[int, Word, Word]] = field(default_factory=list)
    shared: set[Word] = field(default_factory=set)
    faults: list[Fault] = field(default_factory=list)

    def of(self, kind: Kind) -> list[MemoryTable]:
        """Return the tables of one kind, in the order of their motor numbers."""
        return [table for (name, _), table in sorted(self.tables.items()) if name == kind]

    def setting(self, quantity: str, motor: int = 0) -> Word | None:
        """Return the last assignment of a setting of a motor; None if no script assigns it."""
        found = self.settings.get((quantity, motor))
        return found[-1] if found else None


def number_of(word: Word) -> int:
    """Return the whole number that a piece of a script states."""
    return int(word.text) if word.value is None else word.value


def over_itself(script: Script, motor: int) -> list[MemoryTable]:
    """Return the tables by which a motor corrects itself by its own position."""
    return [
        table
        for table in script.of("COMP")
        if not table.plane and table.source == table.target == motor
    ]


#: What must not exist while a table is defined.
BEHIND = {
    "COMP": ("TCOMP", "BLCOMP", "TBUF", "ROTARY", "LOOKAHEAD", "GATHER"),
    "BLCOMP": ("TBUF", "ROTARY", "LOOKAHEAD", "GATHER"),
    "TCOMP": (),
}
_SHORT = {"ROT": "ROTARY", "LOOK": "LOOKAHEAD", "GAT": "GATHER"}


class Buffers:
    """The memory buffers that scripts have defined so far: for each kind of buffer, the motors that
    have one.
    """

    def __init__(self) -> None:
        self.motors: dict[str, set[int]] = {}

    def define(self, name: str, motor: int = 0) -> None:
        """Record that a script has defined a buffer (memory for a table or program) for a motor."""
        self.motors.setdefault(long_name(name), set()).add(motor)

    def delete(self, name: str, motor: int) -> None:
        """Record that a script has deleted a buffer; deleting a missing one is no fault."""
        found = self.motors.get(long_name(name), set())
        found -= {motor, 0}

    def refuses(self, kind: str, motor: int) -> str:
        """Return why the control would refuse to define a table; empty if it would define the
        table.
        """
        mine = self.motors.get(kind, set())
        if motor in mine:
            return f"#{motor} has a {kind} already; delete it first"
        if any(other < motor for other in mine):
            return f"#{min(mine)}, a lower motor, has a {kind}"
        there = [name for name in BEHIND[kind] if self.motors.get(name)]
        return f"{', '.join(there)} was defined before it" if there else ""

    def keeps(self, kind: str, motor: int) -> str:
        """Return why the control would refuse to delete a table; empty if it would delete the
        table.
        """
        mine = self.motors.get(kind, set())
        if motor in mine and any(other < motor for other in mine):
            return f"#{min(mine)}, a lower motor, has a {kind}"
        return ""


def long_name(name: str) -> str:
    """Return the full name of a buffer, given by its full or short name."""
    return _SHORT.get(name.upper(), name.upper())


_NAMES = {"enabled": "I51", "take_up_rate": "I{}85", "backlash": "I{}86"}


def order_dependent_values(script: Script) -> Iterator[Fault]:
    """Yield a fault for each value that depends on the order in which the scripts of a folder are
    sent to the control.

    The files of a folder are read in the order of their names, but the order in which they are sent
    is unknown.
    """
    for (quantity, motor), words in script.settings.items():
        name = _NAMES[quantity].format(motor)
        yield from _other_ends(script, name, words, [word.text for word in words])
    for (kind, motor), commands in _tables(script).items():
        words, ends = [word for _, word in commands], [done for done, _ in commands]
        yield from _other_ends(script, f"#{motor} {kind}", words, ends)


def _tables(script: Script) -> Mapping[tuple[str, int], list[tuple[str, Word]]]:
    """Return the commands that define or delete each table, by kind of table and motor.

    Each command has a text for comparison. All deletions have the same text, and each definition
    has a text of its own.
    """
    found: dict[tuple[str, int], list[tuple[str, Word]]] = {}
    for number, (command, motor, word) in enumerate(script.commands):
        done, _, kind = command.partition(" ")
        if kind in ("COMP", "BLCOMP"):
            done_to_it = done if done == "DELETE" else f"{done} {number}"
            found.setdefault((kind, motor), []).append((done_to_it, word))
    return found


def _other_ends(
    script: Script, name: str, words: Sequence[Word], ends: Sequence[str]
) -> Iterator[Fault]:
    """Yield a fault for each script of a folder that gives ``name`` another last value than the
    last script, so that only the order of file names decides. ``words``: the commands in order;
    ``ends``: the value after each.
    """
    folder = script.files[words[-1].number].folder
    last_of = {word.number: (word, end) for word, end in zip(words, ends, strict=True)}
    for number, (word, end) in last_of.items():
        if folder and script.files[number].folder == folder and end != ends[-1]:
            yield words[-1].fault(
                f"{name}: {word.file}, line {word.line}, says {_shown(word)}. The script that was"
                " sent last decides, but a folder has no order",
                expected="the scripts named one by one, in the order in which they are sent",
                found=_shown(words[-1]),
            )


def _shown(word: Word) -> str:
    return " ".join(word.text.split())
