"""Scripts of on-line commands -> tables, settings and programs in them, every number with its
place.

Commands stand one behind the other, whatever the lines; the numbers of a table follow its
definition. A command that is not known may act, so it is refused.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, compile_statement
from compwright.formats.families.wrapped.buffers import Buffers
from compwright.formats.text.gathering import Found
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Motors of the largest card.
MOST_MOTORS = 32
Kind = Literal["COMP", "BLCOMP", "TCOMP"]
_BUFFER = r"TBUF|ROT(?:ARY)?|LOOK(?:AHEAD)?|GAT(?:HER)?"
_VALUE = (
    r"\$[0-9A-F]+(?![0-9A-Z.])|[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?![0-9.]*[-+*/%&|^(.])|\S+"
)
_RANGE = (
    r"I(?P<first>[0-9]{1,9})[ \t]*(?:\.\.[ \t]*(?P<last>[0-9]{1,9})"
    r"|,[ \t]*(?P<count>[0-9]{1,9})[ \t]*,[ \t]*(?P<step>[0-9]{1,9}))?[ \t]*="
)
_MANY = r"(?:[ \t]*\.\.[ \t]*[0-9]+|,[ \t]*[0-9]+[ \t]*,[ \t]*[0-9]+)?"
#: What may stand behind the arrow of a motor's axis, or of a pointer: the next command may follow.
_OF_AXIS = r"(?:I(?![0-9A-Z])|(?:[-+.0-9 \t]|[ABCUVWXYZ](?![A-Z]))*)"
_POINTER = r"[^\s=:,]+(?:[ \t]*[:,][ \t]*[^\s=:,]+)*(?!\S)"
_COMMAND = re.compile(
    r"(?P<number>[+-]?[0-9]+)(?=\s|$)"
    rf"|(?P<idle>[#&][ \t]*[0-9]+[ \t]*->[ \t]*{_OF_AXIS}|M[0-9]+{_MANY}[ \t]*->[ \t]*{_POINTER}"
    r"|&[ \t]*[0-9]+|UNDEFINE(?:[ \t]*ALL)?(?![A-Z])|(?:SAVE|CLOSE)(?![A-Z])"
    r"|(?:ENA(?:BLE)?|DIS(?:ABLE)?)[ \t]*PLCC?[ \t]*[0-9][0-9., \t]*"
    rf"|[MPQ][0-9]+{_MANY}[ \t]*=[ \t]*[^\s=]+(?!\S))"
    r"|\#[ \t]*(?P<motor>[0-9]{1,9})(?![0-9])"
    r"|DEF(?:INE)?[ \t]*(?P<table>COMP|BLCOMP|TCOMP)[ \t]+"
    r"(?P<arguments>[^\s,]+(?:[ \t]*,[ \t]*[^\s,]+)*)"
    rf"|DEF(?:INE)?[ \t]*(?P<buffer>{_BUFFER})(?![A-Z])(?:[ \t]*[0-9]+(?:[ \t]*,[ \t]*[0-9]+)*)?"
    rf"|DEL(?:ETE)?[ \t]*(?P<deleted>COMP|BLCOMP|TCOMP|{_BUFFER})(?![A-Z])"
    r"|(?P<open>OPEN)(?![A-Z])"
    rf"|(?P<setting>{_RANGE}[ \t]*(?P<value>{_VALUE}))",
    re.IGNORECASE,
)
_ARGUMENTS = re.compile(
    r"(?P<entries>[0-9]{1,9})(?:[ \t]*,[ \t]*\#[ \t]*(?P<source>[0-9]{1,4})[ \t]*(?P<desired>D)?"
    r"(?:[ \t]*,[ \t]*\#[ \t]*(?P<target>[0-9]{1,4}))?)?[ \t]*,[ \t]*(?P<length>[0-9]{1,12})",
    re.IGNORECASE,
)
_PLAIN = re.compile(r"(?P<entries>[0-9]{1,9})[ \t]*,[ \t]*(?P<length>[0-9]{1,12})")
_PLANE = re.compile(r"(?P<rows>[0-9]{1,6})\.(?P<columns>[0-9]{1,6})[ \t]*,(?P<rest>.*)")
#: For the program that sends scripts, not for the card.
_INCLUDE = re.compile(r"#[ \t]*INCLUDE(?![A-Z])", re.IGNORECASE)
_END = re.compile(r"(?<![A-Z])CLOSE(?![A-Z])", re.IGNORECASE)
_SET = re.compile(rf"(?<![A-Z(0-9]){_RANGE}", re.IGNORECASE)
_TABLE = re.compile(r"(?:DEF(?:INE)?|DEL(?:ETE)?)[ \t]*(?:BL)?COMP(?![A-Z])", re.IGNORECASE)
#: No number of a card has more digits (48 bits).
_MOST_DIGITS = 16
_WHOLE = re.compile(rf"\$[0-9A-Fa-f]{{1,12}}|[+-]?[0-9]{{1,{_MOST_DIGITS - 1}}}")
_REMARK = re.compile(r";[^\r\n]*")


@dataclass(frozen=True, slots=True)
class Word:
    """A piece of a script: its text and its place, ``start`` and ``end`` in bytes of the file that
    is the ``number``-th of those given.
    """

    text: str
    file: str
    number: int
    line: int
    start: int
    end: int

    @property
    def found(self) -> Found:
        """The piece as the notes take it."""
        return Found(self.text, Occurrence("script", self.file, self.line, {}), self.number)

    def fault(self, message: str, *, expected: str = "", found: str | None = None) -> Fault:
        """Return a fault at this place."""
        said = self.text if found is None else found
        return Fault(
            message=message,
            file=self.file,
            place=f"line {self.line}",
            expected=expected,
            found=said,
        )


@dataclass(slots=True)
class Table:
    """A table in the memory of a motor: ``needed`` entries, which stand at ``values``.

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
        """Its entries; entry i stands at i * length / entries, counted from 1."""
        return tuple(int(word.text) for word in self.values)

    @property
    def says(self) -> str:
        """The table in a message."""
        return f"#{self.motor} {self.kind}"


@dataclass(slots=True)
class Script:
    """What scripts leave in a control that takes them one after the other.

    ``tables``: by kind and motor; ``settings``: all assignments to one of our quantities, by
    quantity and motor (0: all motors), the last one counts; ``programs``: those in programs.
    ``commands``: every definition, deletion and setting in the order of the files. ``shared``:
    values of assignments to more than one variable.
    """

    files: tuple[ControlFile, ...]
    tables: dict[tuple[Kind, int], Table] = field(default_factory=dict)
    settings: dict[tuple[str, int], list[Word]] = field(default_factory=dict)
    programs: dict[tuple[str, int], Word] = field(default_factory=dict)
    commands: list[tuple[str, int, Word]] = field(default_factory=list)
    shared: set[Word] = field(default_factory=set)
    faults: list[Fault] = field(default_factory=list)

    def of(self, kind: Kind) -> list[Table]:
        """Return the tables of a kind by motor."""
        return [table for (name, _), table in sorted(self.tables.items()) if name == kind]

    def said(self, quantity: str, motor: int = 0) -> Word | None:
        """Return the assignment that counts; None where there is none."""
        found = self.settings.get((quantity, motor))
        return found[-1] if found else None


def read_script(definition: Definition, files: Sequence[ControlFile]) -> Script:
    """Return what ``files`` leave in a control that takes them in this order; what is wrong stands
    in its ``faults``.
    """
    reader = _Reader(definition, files)
    for number in range(len(files)):
        reader.read(number)
    reader.complete()
    return reader.script


def number_of(text: str) -> int:
    """Return a whole number, decimal or ``$`` and hexadecimal digits."""
    return int(text[1:], 16) if text.startswith("$") else int(text)


def over_itself(script: Script, motor: int) -> list[Table]:
    """Return the tables by which a motor corrects itself, wherever they are kept."""
    return [
        table
        for table in script.of("COMP")
        if not table.plane and table.source == table.target == motor
    ]


class _Reader:
    def __init__(self, definition: Definition, files: Sequence[ControlFile]) -> None:
        self.script = Script(tuple(files))
        self.range = definition.measure("value_positive").range
        self.parameters = [
            (name, compile_statement(definition.statements[statement], definition))
            for name in definition.layout.singles
            for statement in (definition.bindings[name].statement,)
        ]
        self.motor = 0
        self.open: Table | None = None
        self.full = False
        self.buffers = Buffers()
        self.file, self.number, self.text = "", 0, ""
        self.line_ends: list[int] = []  # of the text: counting them for each word takes its square

    def read(self, number: int) -> None:
        """Carry out the commands of one file; the addressed motor stays from file to file."""
        file = self.script.files[number]
        self.file, self.number = file.name, number
        text = file.content.decode("latin-1").removesuffix("\x1a")
        self.text = _REMARK.sub(lambda remark: " " * len(remark[0]), text)
        self.line_ends = [match.start() for match in re.finditer("\n", self.text)]
        place = 0
        while place < len(self.text):
            if self.text[place] in " \t\r\n":
                place += 1
                continue
            match = _COMMAND.match(self.text, place)
            if match is None:
                place = self._unknown(place)
            elif match["open"]:
                place = self._program(match.end())
            else:
                self._command(match)
                place = match.end()

    def complete(self) -> None:
        """Note a table that the scripts end in."""
        table, self.open = self.open, None
        if table is not None and len(table.values) < table.needed:
            self._fault(
                table.word,
                f"{table.says}: entries are missing; missing is not zero",
                f"{table.needed} whole numbers",
                str(len(table.values)),
            )

    def _word(self, start: int, end: int) -> Word:
        line = bisect_left(self.line_ends, start) + 1
        return Word(self.text[start:end], self.file, self.number, line, start, end)

    def _fault(self, word: Word, message: str, expected: str, found: str | None = None) -> None:
        self.script.faults.append(word.fault(message, expected=expected, found=found))

    def _unknown(self, place: int) -> int:
        end = re.compile(r"[\r\n]|$").search(self.text, place)
        word = self._word(place, len(self.text) if end is None else end.start())
        message = "this is no command that compwright knows, and it may act"
        if self.open is not None and len(self.open.values) < self.open.needed:
            message = f"{self.open.says}: this is no whole number"
        expected = "DEFINE, DELETE, I..=.. and the like; docs/controllers/pmac.md"
        if _INCLUDE.match(word.text):
            message = "the script of another file belongs here, and is not in this one"
            expected = "the content of that file in the place of this line"
        self._fault(word, message, expected)
        return word.end

    def _command(self, match: re.Match[str]) -> None:
        word = self._word(match.start(), match.end())
        if match["number"]:
            self._entry(word)
            return
        self.complete()
        if match["motor"]:
            self.motor = int(match["motor"])
        elif match["table"]:
            self._define(word, match)
        elif match["buffer"]:
            self.buffers.define(match["buffer"])
            self.script.commands.append((f"DEFINE {match['buffer'].upper()}", 0, word))
        elif match["deleted"]:
            self._delete(word, match["deleted"].upper())
        elif match["setting"]:
            self._set(match)

    # --- tables

    def _entry(self, word: Word) -> None:
        low, high = self.range
        if self.open is None or len(self.open.values) >= self.open.needed:
            self._fault(word, "a number without a table: one entry too many?", "the next command")
        elif len(word.text) > _MOST_DIGITS or not low <= int(word.text) <= high:
            self._fault(word, f"{self.open.says}: the entry is too large", f"{low:g} to {high:g}")
            self.open.needed -= 1
        else:
            self.open.values.append(word)

    def _define(self, word: Word, match: re.Match[str]) -> None:
        kind: Kind = match["table"].upper()  # type: ignore[assignment]  # the pattern names them
        if not self._addressed(word):
            return
        refused = self.buffers.refuses(kind, self.motor)
        if refused:
            self._fault(word, f"the card refuses this (ERR003): {refused}", _ORDER)
        self.buffers.define(kind, self.motor)
        table = self._table(kind, word, match["arguments"], match.start("arguments"))
        if table is None:
            self._fault(word, "the definition cannot be read", _FORMS[kind], match["arguments"])
            return
        self.script.commands.append((f"DEFINE {kind}", self.motor, word))
        self.script.tables[kind, self.motor] = table
        self.open = table

    def _table(self, kind: Kind, word: Word, text: str, place: int) -> Table | None:
        plane = _PLANE.fullmatch(text) if kind == "COMP" else None
        if plane is not None:
            needed = (int(plane["rows"]) + 1) * (int(plane["columns"]) + 1) - 1
            return Table(kind, self.motor, word, needed, plane=True)
        match = (_ARGUMENTS if kind == "COMP" else _PLAIN).fullmatch(text)
        if match is None or not int(match["entries"]) or not int(match["length"]):
            return None
        said = match.groupdict()
        source = int(said.get("source") or self.motor)
        target = int(said.get("target") or self.motor)
        if not all(1 <= motor <= MOST_MOTORS for motor in (source, target)):
            return None
        return Table(
            kind,
            self.motor,
            word,
            int(match["entries"]),
            source=source,
            target=target,
            desired=kind != "COMP" or bool(said.get("desired")),
            entries=self._word(place + match.start("entries"), place + match.end("entries")),
            length=self._word(place + match.start("length"), place + match.end("length")),
        )

    def _addressed(self, word: Word) -> bool:
        if not 1 <= self.motor <= MOST_MOTORS:
            self._fault(
                word,
                "a table needs its motor",
                f"#1 to #{MOST_MOTORS} before it",
                f"#{self.motor}" if self.motor else "no motor",
            )
            return False
        return True

    def _delete(self, word: Word, name: str) -> None:
        if name in ("COMP", "BLCOMP", "TCOMP"):
            if not self._addressed(word):
                return
            refused = self.buffers.keeps(name, self.motor)
            if refused:
                self._fault(word, f"the card refuses this (ERR003): {refused}", _ORDER)
            self.script.tables.pop((name, self.motor), None)  # type: ignore[arg-type]
        self.buffers.delete(name, self.motor)
        self.script.commands.append((f"DELETE {name}", self.motor, word))

    # --- settings

    def _set(self, match: re.Match[str]) -> None:
        value = self._word(match.start("value"), match.end("value"))
        if match["last"] or match["count"]:
            self.script.shared.add(value)
        for quantity, motor in self._meant(match):
            if _WHOLE.fullmatch(value.text) is None:
                name = match["setting"].split("=")[0].strip()
                message = f"{name} is set to something that is no whole number of the control"
                self._fault(value, message, "a whole number, or $ and hexadecimal digits")
                continue
            self.script.settings.setdefault((quantity, motor), []).append(value)
            self.script.commands.append((quantity, motor, self._word(*match.span())))

    def _meant(self, match: re.Match[str]) -> Iterator[tuple[str, int]]:
        """Yield the quantities that an assignment sets, with the motor (0: all motors)."""
        first, last, step = int(match["first"]), int(match["last"] or match["first"]), 1
        if match["count"]:
            step = int(match["step"]) or 1
            last = first + (int(match["count"]) - 1) * step
        for number in range(first, min(last, 100 * (MOST_MOTORS + 1)) + 1, step):
            for name, matcher in self.parameters:
                found = matcher.match(f"I{number}=0")
                motor = int(found[1].groupdict().get("axis") or 0) if found else -1
                if 0 <= motor <= MOST_MOTORS:
                    yield name, motor

    def _program(self, place: int) -> int:
        """Read over a program; note what of ours it sets."""
        self.complete()
        end = _END.search(self.text, place)
        if end is None:
            word = self._word(place - len("OPEN"), place)
            self._fault(word, "a program that does not end", "CLOSE behind it")
            return len(self.text)
        for match in _SET.finditer(self.text, place, end.start()):
            for meant in self._meant(match):
                self.script.programs[meant] = self._word(*match.span())
        for match in _TABLE.finditer(self.text, place, end.start()):
            self.script.programs["enabled", 0] = self._word(*match.span())
        return end.end()


_ORDER = (
    "tables deleted from the lowest motor up and defined from the highest down, all COMP before"
    " TCOMP, BLCOMP, TBUF, ROTARY, LOOKAHEAD and GATHER"
)
_FORMS = {
    "COMP": "entries,#source[D],#target,length",
    "BLCOMP": "entries,length",
    "TCOMP": "entries,length",
}
