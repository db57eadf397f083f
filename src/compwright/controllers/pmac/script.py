"""Execute a PMAC's download script command by command, and return the state of the card.

``;`` starts a comment. ``DEFINE COMP`` or ``DEFINE BLCOMP`` announces a table for the motor that
was addressed last (``#n``). The entries of the table follow as decimal whole numbers.

The card refuses a table (ERR003) while a table of its kind exists for a lower motor. It also
refuses a table while a buffer exists that must be defined later. A command that the card would
refuse is a fault here. Commands that do not concern compensation are ignored. An unknown command is
a fault, because it may change the compensation.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from compwright.controllers.places import OfLine
from compwright.controllers.pmac.preprocessing import (
    Block,
    Preprocessor,
    apart,
    calculated,
    expression,
    without_remarks,
)
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Registers have 24 bits.
LARGEST = 8388607
HIGHEST_MOTOR = 32
#: Global switch of all tables; take-up rate and size of backlash, plus 100 per motor.
ENABLE, TAKE_UP, SIZE = 51, 85, 86

_NUMBER = re.compile(r"[+-]?\d+(?![\d.$])")
_MOTOR = re.compile(r"#\s*(\d+)(\s*->\s*(?:I(?![0-9A-Z])|(?:[-+.\d\s]|[ABCUVWXYZ](?![A-Z]))*))?")
#: One axis with its scale factor, and an offset in counts.
_SCALE = re.compile(r"->([-+]?(?:\d+\.?\d*|\.\d+))[ABCUVWXYZ](?:[-+][\d.]+)?")
_LINE = r"(\d{1,9})\s*(?:,|(?=#))\s*(?:#\s*(\d+)\s*(D?)\s*,\s*(?:#\s*(\d+)\s*,\s*)?)?(\d{1,15})"
_COMP = re.compile(rf"DEF(?:INE)?\s*COMP\s*{_LINE}(?![\d.,])")
_PLANE = re.compile(
    r"DEF(?:INE)?\s*COMP\s*(\d{1,9})\.(\d{1,9})((?:\s*,\s*#\s*\d+\s*D?)*)\s*,\s*\d+\s*,\s*\d+"
)
_OWN = re.compile(r"DEF(?:INE)?\s*(BLCOMP|TCOMP)\s*(\d{1,9})\s*,\s*(\d{1,15})(?![\d.,])")
_BUFFER = re.compile(
    r"(DEF|DEL)(?:INE|ETE)?\s*(GAT(?:HER)?|TBUF|ROT(?:ARY)?|LOOK(?:AHEAD)?|CCBUF|UBUF(?:FER)?)\b"
    r"(?:\s*\d+(?:\s*,\s*\d+)*)?"
)
_DELETE = re.compile(r"DEL(?:ETE)?\s*(COMP|BLCOMP|TCOMP)\b")
_VARIABLE = re.compile(
    r"I(\d{1,4})(?:\s*\.\.\s*(\d{1,4})|\s*,\s*(\d{1,4})\s*,\s*(\d{1,4}))?\s*="
    r"\s*"
)
_HARMLESS = re.compile(
    r"[MPQ]\d+(?:\.\.\d+|\s*,\s*\d+\s*,\s*\d+)?\s*"
    r"(?:=\s*[^\s=]+(?:\s*[-+*/|^]\s*[^\s=]+)*|->\s*[^\s=,]+(?:\s*,\s*[^\s=,]+)*)"
    r"(?!\S)|&\s*\d+|SAVE\b|CLOSE\b|UNDEFINE(?:\s*ALL)?\b"
    r"|ENDG(?:ATHER)?\b|(?:ENA(?:BLE)?|DIS(?:ABLE)?)\s*PLCC?\s*\d*(?:(?:,|\.\.)\d+)*"
)
_CONDITION = re.compile(r"\b(?:IF|WHILE|AND|OR)\s*\((?:[^()]|\([^()]*\))*\)")
_OPEN = re.compile(r"OPEN\b(.*)")
_POWER = re.compile(r"(?:COMPTABLE|MOTOR|SYS|COORD)\s*[\[.]")
#: Buffers that have to be defined after tables of a kind.
_LATER = {
    "COMP": ("TCOMP", "BLCOMP", "TBUF", "ROT", "LOOKAHEAD", "GATHER"),
    "BLCOMP": ("TBUF", "ROT", "LOOKAHEAD", "GATHER"),
    "TCOMP": ("TBUF", "ROT", "LOOKAHEAD", "GATHER"),
}


@dataclass(frozen=True, slots=True)
class ScriptPlace(OfLine):
    """The file and line number of a line of a script."""

    file: str
    line: int


@dataclass(frozen=True, slots=True)
class CardTable:
    """A table as the card stores it, with entries in 1/16 count of the motor ``target``.

    Entry i (1 to n) is at i * ``length`` / n counts of the motor ``source`` from its motor zero.
    ``announced``: the number n of entries that the command states. ``plane``: the table depends on
    two motors. ``desired``: it is looked up by the commanded position, else by the actual position.
    """

    kind: str
    motor: int
    source: int
    target: int
    length: int
    announced: int
    place: ScriptPlace
    entries: list[int] = field(default_factory=list)
    plane: bool = False
    desired: bool = True


@dataclass(frozen=True, slots=True)
class VariableSetting:
    """The last value that scripts assign to an I-variable; None if it is not a plain number."""

    value: float | None
    text: str
    place: ScriptPlace


@dataclass(slots=True)
class Card:
    """The state of the PMAC card after all scripts.

    - ``later``: I-variables that programs set when they run, with the place of the assignment.
    - ``left_out``: commands that may not have been sent, each with its motor (0: all motors).
    - ``not_both``: commands that cannot have been sent together, each with its motor and the
      reason.
    - ``axis_scales``: counts per unit of an axis that one motor alone moves, by motor
      (`#1->10000X`; PMAC 2 software reference p. 179). A motor has several if a conditional block
      decides which one is sent.
    """

    tables: dict[tuple[str, int], CardTable] = field(default_factory=dict)
    variables: dict[int, VariableSetting] = field(default_factory=dict)
    later: dict[int, ScriptPlace] = field(default_factory=dict)
    left_out: list[tuple[int, ScriptPlace]] = field(default_factory=list)
    not_both: list[tuple[int, ScriptPlace, str]] = field(default_factory=list)
    axis_scales: dict[int, list[tuple[float, ScriptPlace]]] = field(default_factory=dict)
    buffers: set[str] = field(default_factory=set)
    notes: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)

    def holds(self, kind: str) -> bool:
        """Return whether a buffer or a table of this kind exists on the card."""
        return kind in self.buffers or any(one == kind for one, _ in self.tables)


def run_scripts(files: Sequence[ControlFile]) -> Card:
    """Return the state of the card after executing all ``files`` in order; nothing is raised."""
    card, sending = Card(), Preprocessor()
    for file in files:
        text = file.content.decode("latin-1").removeprefix("\xef\xbb\xbf").upper()
        text = text.removesuffix("\x1a")  # the end of a file of DOS
        if "\x00" in text:
            card.faults.append(
                Fault(
                    message="the file contains a NUL byte (a zero character), so it is not a "
                    "script in plain text",
                    file=file.name,
                    hint="save the script from the control as plain text",
                )
            )
            continue
        script = _Script(card, sending)
        lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
        for number, line in enumerate(lines, start=1):
            script.line(without_remarks(line), ScriptPlace(file.name, number))
        script.finish()
        if script.inside is not None:
            card.faults.append(
                script.inside.fault("a program in the script has no end", expected="CLOSE")
            )
    return card


class _Script:
    """Executes one script, with the motor that is addressed and the table that expects entries."""

    def __init__(self, card: Card, sending: Preprocessor) -> None:
        self.card = card
        self.sending = sending
        self.done: dict[tuple[str, int], list[tuple[list[Block], ScriptPlace]]] = {}
        self.motor: int | None = None
        self.waiting: CardTable | None = None
        self.inside: ScriptPlace | None = None

    def line(self, text: str, place: ScriptPlace) -> None:
        rest = text.strip()
        wrong = self.sending.takes(rest, place.line)
        if wrong is not None:
            if wrong:
                self.card.faults.append(place.fault(wrong))
            return
        if self.inside is not None:
            self._program(rest, place)
            return
        while rest:
            end = self._command(rest, place)
            if end is None:
                return
            rest = rest[end:].strip()

    def finish(self) -> None:
        """Add a fault for a table that did not get all its entries."""
        table, self.waiting = self.waiting, None
        if table is not None:
            self.card.faults.append(
                table.place.fault(
                    f"DEFINE {table.kind} of motor {table.motor} does not get its entries",
                    expected=f"{table.announced} whole numbers",
                    found=str(len(table.entries)),
                )
            )

    def _command(self, rest: str, place: ScriptPlace) -> int | None:
        """Execute the first command of ``rest``; return the position where it ends, None at line
        end.
        """
        if self.waiting is not None:
            match = _NUMBER.match(rest)
            if match is not None:
                self._entry(self.waiting, int(match.group()[:20]), place)
                return match.end()
            if self.waiting.entries and rest.startswith(","):
                return 1
            self.finish()
        match = _VARIABLE.match(rest)
        if match is not None:
            text = expression(rest[match.end() :]) or rest[match.end() :].partition(" ")[0]
            self._variable(match, text, place)
            return match.end() + len(text)
        for form, action in (
            (_MOTOR, self._address),
            (_PLANE, self._plane),
            (_COMP, self._comp),
            (_OWN, self._own),
            (_BUFFER, self._buffer),
            (_DELETE, self._delete),
            (_OPEN, self._open),
            (_HARMLESS, None),
        ):
            match = form.match(rest)
            if match is not None:
                if action is not None:
                    action(match, place)
                return match.end()
        return self._unknown(rest, place)

    def _unknown(self, rest: str, place: ScriptPlace) -> int | None:
        """Return the position after an unknown command if it is harmless; None, with a fault, if it
        may have an effect.
        """
        expanded = self.sending.put_in(rest)
        certain = expanded != rest and not self.sending.may_differ(rest)
        if certain and _HARMLESS.fullmatch(expanded.strip()):
            return len(rest)
        message = "not a command that is known here: it may act"
        if _NUMBER.match(rest):
            message = "a number that belongs to no table"
        elif _POWER.match(rest):
            message = "a script of a Power PMAC, which is not read"
        self.card.faults.append(place.fault(message, found=repr(rest[:60])))
        return None

    def _sent(self, what: str, motor: int, place: ScriptPlace) -> bool:
        """Record a compensation command (its text ``what``) for a motor, and return True. If a
        conditional branch that excludes this one contains the same command, return False, with a
        fault.
        """
        here = list(self.sending.blocks)
        before = [(key, one) for key, each in self.done.items() for one in each] if here else []
        for key, (blocks, earlier) in before:
            if not apart(here, blocks):
                continue
            if key == (what, motor):
                message = f"in a different branch than its statement in line {earlier.line}"
                self.card.faults.append(place.fault(f"{what}: {message}"))
                return False
            message = f"{what} is in a different branch than line {earlier.line}"
            self.card.not_both.append((motor, place, message))
        self.done.setdefault((what, motor), []).append((here, place))
        if here:
            self.card.left_out.append((motor, place))
        return True

    def _entry(self, table: CardTable, value: int, place: ScriptPlace) -> None:
        if abs(value) > LARGEST:
            expected = f"-{LARGEST} to {LARGEST}"
            self.card.faults.append(place.fault("an entry", expected=expected, found=str(value)))
        table.entries.append(value)
        if len(table.entries) == table.announced:
            self.waiting = None

    def _known(self, number: int, place: ScriptPlace) -> int | None:
        if 1 <= number <= HIGHEST_MOTOR:
            return number
        expected = f"1 to {HIGHEST_MOTOR}"
        self.card.faults.append(place.fault("a motor", expected=expected, found=f"#{number}"))
        return None

    def _address(self, match: re.Match[str], place: ScriptPlace) -> None:
        motor = self._known(int(match.group(1)[:9]), place)
        if match.group(2) is None:
            self.motor = motor
        elif motor is not None:
            if not self.sending.blocks:
                self.card.axis_scales.pop(motor, None)
            scale = _SCALE.fullmatch("".join(match.group(2).split()))
            if scale is not None:
                self.card.axis_scales.setdefault(motor, []).append((float(scale[1]), place))

    def _comp(self, match: re.Match[str], place: ScriptPlace) -> None:
        count, source, desired, target, length = match.groups()
        motor = self._addressed(match, place)
        named = [self._known(int(one[:9]), place) for one in (source, target) if one]
        if motor is None or None in named:
            return
        self._define(
            CardTable(
                kind="COMP",
                motor=motor,
                source=(named[0] if named else None) or motor,
                target=(named[1] if len(named) > 1 else None) or motor,
                desired=bool(desired),
                length=int(length),
                announced=int(count),
                place=place,
            )
        )

    def _plane(self, match: re.Match[str], place: ScriptPlace) -> None:
        rows, columns = int(match.group(1)), int(match.group(2))
        named = [int(one[:9]) for one in re.findall(r"\d+", match.group(3))]
        motor = self._addressed(match, place)
        if motor is not None:
            target = named[2] if len(named) > 2 else motor
            count = (rows + 1) * (columns + 1) - 1
            self._define(CardTable("COMP", motor, 0, target, 1, count, place, plane=True))

    def _own(self, match: re.Match[str], place: ScriptPlace) -> None:
        kind, count, length = match.groups()
        motor = self._addressed(match, place)
        if motor is not None:
            self._define(CardTable(kind, motor, motor, motor, int(length), int(count), place))

    def _addressed(self, match: re.Match[str], place: ScriptPlace) -> int | None:
        if self.motor is None:
            found = repr(match.group())
            self.card.faults.append(
                place.fault("this line names no motor", expected="#n before it", found=found)
            )
        return self.motor

    def _define(self, table: CardTable) -> None:
        if not table.announced or not table.length:
            found = f"{table.announced}, {table.length}"
            expected = "at least one entry and one count"
            self.card.faults.append(
                table.place.fault(f"DEFINE {table.kind}", expected=expected, found=found)
            )
            return
        if not self._sent(f"DEFINE {table.kind}", table.motor, table.place):
            self.waiting = table
            return
        self._refuse(table.kind, table.motor, table.place)
        self.card.tables[table.kind, table.motor] = table
        self.waiting = table

    def _refuse(self, kind: str, motor: int, place: ScriptPlace) -> None:
        """Add a fault where the card would reject a table (ERR003)."""
        lower = [other for one, other in self.card.tables if one == kind and other < motor]
        later = [one for one in _LATER[kind] if self.card.holds(one)]
        if (kind, motor) in self.card.tables:
            found, expected = f"one of motor {motor} already", f"DELETE {kind} before it"
        elif lower:
            found, expected = f"one of motor {min(lower)} already", "the highest motor first"
        elif later:
            found, expected = f"{', '.join(later)} already", f"these after DEFINE {kind}"
        else:
            return
        message = f"ERR003: DEFINE {kind} of motor {motor} is refused"
        self.card.faults.append(place.fault(message, expected=expected, found=found))

    def _buffer(self, match: re.Match[str], place: ScriptPlace) -> None:  # noqa: ARG002
        what, kind = match.group(1), match.group(2)
        kind = {"ROTARY": "ROT", "GAT": "GATHER", "LOOK": "LOOKAHEAD"}.get(kind, kind)
        if what == "DEF":
            self.card.buffers.add(kind)
        else:
            self.card.buffers.discard(kind)

    def _delete(self, match: re.Match[str], place: ScriptPlace) -> None:
        kind, motor = match.group(1), self._addressed(match, place)
        if motor is None or not self._sent(f"DELETE {kind}", motor, place):
            return
        lower = [one for name, one in self.card.tables if name == kind and one < motor]
        if lower:
            self.card.faults.append(
                place.fault(
                    f"ERR003: DELETE {kind} of motor {motor} is refused",
                    expected="the lowest motor first",
                    found=f"one of motor {min(lower)}",
                )
            )
        self.card.tables.pop((kind, motor), None)

    def _variable(self, match: re.Match[str], text: str, place: ScriptPlace) -> None:
        first, last, count, step = match.groups()
        value = calculated(self.sending.put_in(text))
        end = int(last or first) if count is None else int(first) + (int(count) - 1) * int(step)
        for number in range(int(first), end + 1, max(1, int(step or 1))):
            if not concerns_compensation(number):
                continue
            if self.sending.may_differ(text):
                message = f"I{number}: its value depends on a macro of a conditional block"
                self.card.faults.append(place.fault(message, expected="a number", found=text))
            elif self._sent(f"I{number}", number // 100, place):
                self.card.variables[number] = VariableSetting(value, text, place)
                if self.sending.behind_guard(text):
                    self.card.left_out.append((number // 100, place))

    def _open(self, match: re.Match[str], place: ScriptPlace) -> None:
        self.inside = place
        self._program(match.group(1), place)

    def _program(self, rest: str, place: ScriptPlace) -> None:
        """Skip a program, because its commands are executed only when it runs."""
        program, closed, after = re.match(r"(.*?)(?:\b(CLOSE\b)(.*))?$", rest).groups()  # type: ignore[union-attr]
        program = _CONDITION.sub("", self.sending.put_in(program))
        for match in re.finditer(r"(?<![A-Z0-9])I(\d{1,4})\s*=(?!=)", program):
            if concerns_compensation(int(match.group(1))):
                self.card.later[int(match.group(1))] = place
        tables = re.search(r"(?<![A-Z])(?:DEL(?:ETE)?|DEF(?:INE)?)\s*(?:BL)?COMP\b", program)
        if tables or re.match(r"\s*I\([^=]*\)\s*=(?!=)", program):
            self.card.later[ENABLE] = place
        if closed:
            self.inside = None
            self.line(after, place)


def concerns_compensation(number: int) -> bool:
    """Return whether an I-variable activates compensation or determines its amount."""
    motor, kind = divmod(number, 100)
    return number == ENABLE or (1 <= motor <= HIGHEST_MOTOR and kind in (TAKE_UP, SIZE))
