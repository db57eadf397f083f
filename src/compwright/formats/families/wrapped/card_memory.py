"""State of a card after scripts: tables, settings, and every number with its place."""

from __future__ import annotations

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
    """A piece of a script: its text and its place, ``start`` and ``end`` in bytes of the file that
    is the ``number``-th of those given. ``value``: its number, if it has one.
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
        """The piece in the form used by the notes."""
        return FoundValue(self.text, Occurrence("script", self.file, self.line, {}), self.number)

    def fault(self, message: str, *, expected: str = "", found: str | None = None) -> Fault:
        """Return a fault at this place."""
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
    """A table in the memory of a motor: ``needed`` entries, with their places in ``values``.

    ``desired``: looked up by the commanded position. ``plane``: over two motors.
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
        """Its length in counts of the source."""
        return 0 if self.length is None else int(self.length.text)

    @property
    def numbers(self) -> tuple[int, ...]:
        """Its entries; entry i is at i * length / entries, counted from 1."""
        return tuple(int(word.text) for word in self.values)

    @property
    def says(self) -> str:
        """Name of the table in messages."""
        return f"#{self.motor} {self.kind}"


@dataclass(slots=True)
class Script:
    """State of a control after executing scripts one after the other.

    ``tables``: by kind and motor; ``settings``: all assignments to compensation quantities, by
    quantity and motor (0: all motors), the last one counts; ``programs``: those in programs.
    ``commands``: every definition, deletion and setting in the order of the files; ``conditional``:
    those (by motor) within a block of the sending program that may be skipped; ``apart``: those of
    them in another branch of a block than an earlier one. ``shared``: values of assignments to more
    than one variable.
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
        """Return the tables of a kind by motor."""
        return [table for (name, _), table in sorted(self.tables.items()) if name == kind]

    def setting(self, quantity: str, motor: int = 0) -> Word | None:
        """Return the assignment that counts, the last one; None if there is none."""
        found = self.settings.get((quantity, motor))
        return found[-1] if found else None


def number_of(word: Word) -> int:
    """Return the whole number in a piece of a script."""
    return int(word.text) if word.value is None else word.value


def over_itself(script: Script, motor: int) -> list[MemoryTable]:
    """Return the tables by which a motor corrects itself, wherever they are stored."""
    return [
        table
        for table in script.of("COMP")
        if not table.plane and table.source == table.target == motor
    ]
