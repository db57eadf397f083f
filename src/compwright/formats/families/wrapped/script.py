"""Read PMAC scripts of on-line commands: tables, settings and programs, and where each number is.

Commands follow one another, and line breaks have no meaning. The numbers of a table follow its
definition. An unknown command is a fault, because it may change the compensation.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import replace

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import compile_statement
from compwright.formats.families.wrapped.card_memory import (
    MOST_MOTORS,
    Buffers,
    Kind,
    MemoryTable,
    Script,
    Word,
)
from compwright.formats.families.wrapped.preprocessor import (
    DIRECTIVE,
    REMARK,
    ConditionalBlock,
    Conditions,
    expanded,
    expression_end,
    in_numbers,
    in_two_branches,
    whole_value,
)
from compwright.records.correction import ControlFile

_BUFFER = r"TBUF|ROT(?:ARY)?|LOOK(?:AHEAD)?|GAT(?:HER)?"
_RANGE = (
    r"I(?P<first>[0-9]{1,9})[ \t]*(?:\.\.[ \t]*(?P<last>[0-9]{1,9})"
    r"|,[ \t]*(?P<count>[0-9]{1,9})[ \t]*,[ \t]*(?P<step>[0-9]{1,9}))?[ \t]*="
)
_MANY = r"(?:[ \t]*\.\.[ \t]*[0-9]+|,[ \t]*[0-9]+[ \t]*,[ \t]*[0-9]+)?"
#: What may stand behind the arrow of a motor's axis, or of a pointer: the next command may follow.
_OF_AXIS = r"(?:I(?![0-9A-Z])|(?:[-+.0-9 \t]|[ABCUVWXYZ](?![A-Z]))*)"
_POINTER = r"[^\s=:,]+(?:[ \t]*[:,][ \t]*[^\s=:,]+)*(?!\S)"
_COMMAND = re.compile(
    r"(?P<number>[+-]?[0-9]+)(?=[\s,]|$)"
    rf"|(?P<idle>[#&][ \t]*[0-9]+[ \t]*->[ \t]*{_OF_AXIS}|M[0-9]+{_MANY}[ \t]*->[ \t]*{_POINTER}"
    r"|&[ \t]*[0-9]+|UNDEFINE(?:[ \t]*ALL)?(?![A-Z])|(?:SAVE|CLOSE)(?![A-Z])"
    r"|(?:ENA(?:BLE)?|DIS(?:ABLE)?)[ \t]*PLCC?[ \t]*[0-9][0-9., \t]*"
    r")|(?P<other>[MPQ][0-9]+" + _MANY + r"[ \t]*=[ \t]*)"
    r"|\#[ \t]*(?P<motor>[0-9]{1,9})(?![0-9])"
    r"|DEF(?:INE)?[ \t]*(?P<table>COMP|BLCOMP|TCOMP)[ \t]+"
    r"(?P<arguments>[^\s,]+(?:[ \t]+(?=\#[^\s,]+[ \t]*,)[^\s,]+)?(?:[ \t]*,[ \t]*[^\s,]+)*)"
    rf"|DEF(?:INE)?[ \t]*(?P<buffer>{_BUFFER})(?![A-Z])(?:[ \t]*[0-9]+(?:[ \t]*,[ \t]*[0-9]+)*)?"
    rf"|DEL(?:ETE)?[ \t]*(?P<deleted>COMP|BLCOMP|TCOMP|{_BUFFER})(?![A-Z])"
    r"|(?P<open>OPEN)(?![A-Z])"
    rf"|(?P<setting>{_RANGE}[ \t]*)",
    re.IGNORECASE,
)
_ARGUMENTS = re.compile(
    r"(?P<entries>[0-9]{1,9})(?:(?:[ \t]*,[ \t]*|[ \t]+)"
    r"\#[ \t]*(?P<source>[0-9]{1,4})[ \t]*(?P<desired>D)?"
    r"(?:[ \t]*,[ \t]*\#[ \t]*(?P<target>[0-9]{1,4}))?)?[ \t]*,[ \t]*(?P<length>[0-9]{1,12})",
    re.IGNORECASE,
)
_PLAIN = re.compile(r"(?P<entries>[0-9]{1,9})[ \t]*,[ \t]*(?P<length>[0-9]{1,12})")
_PLANE = re.compile(r"(?P<rows>[0-9]{1,6})\.(?P<columns>[0-9]{1,6})[ \t]*,(?P<rest>.*)")
#: For the program that sends scripts, not for the card.
_INCLUDE = re.compile(r"#[ \t]*INCLUDE(?![A-Z])", re.IGNORECASE)
_END = re.compile(r"(?<!\w)CLOSE(?!\w)", re.IGNORECASE)
_SET = re.compile(rf"(?<![A-Z(0-9]){_RANGE}", re.IGNORECASE)
_TABLE = re.compile(r"(?:DEF(?:INE)?|DEL(?:ETE)?)[ \t]*(?:BL)?COMP(?![A-Z])", re.IGNORECASE)
#: No number of a card has more digits (48 bits).
_MOST_DIGITS = 16
_MOST = 10 ** (_MOST_DIGITS - 1)
#: An assignment to a variable whose number the program works out.
_COMPUTED = re.compile(r"(?<![A-Z0-9(])I[ \t]*\([^=\r\n]*\)[ \t]*=(?!=)", re.IGNORECASE)


def read_script(definition: Definition, files: Sequence[ControlFile]) -> Script:
    """Return the state of a control after executing ``files`` in this order, with all faults."""
    reader = _ScriptReader(definition, files)
    for number in range(len(files)):
        reader.read(number)
    reader.complete()
    return reader.script


class _ScriptReader:
    def __init__(self, definition: Definition, files: Sequence[ControlFile]) -> None:
        self.script = Script(tuple(files))
        self.range = definition.measure("value_positive").range
        self.parameters = [
            (name, compile_statement(definition.statements[statement], definition))
            for name in definition.layout.singles
            for statement in (definition.bindings[name].statement,)
        ]
        self.motor = 0
        self.open: MemoryTable | None = None
        self.full = False
        self.buffers = Buffers()
        self.conditions = Conditions()
        self.carried: list[
            tuple[tuple[str, int], Word, tuple[tuple[ConditionalBlock, int], ...]]
        ] = []
        self.file, self.number, self.text = "", 0, ""
        self.line_ends: list[int] = []  # of the text: counting them for each word takes its square

    def read(self, number: int) -> None:
        """Execute the commands of one file, beginning with the motor that the previous file
        addressed.
        """
        file = self.script.files[number]
        self.file, self.number = file.name, number
        text = file.content.decode("latin-1").removesuffix("\x1a")
        self.text = REMARK.sub(lambda remark: " " * len(remark[0]), text)
        self.line_ends = [match.start() for match in re.finditer("\n", self.text)]
        place = 0
        while place < len(self.text):
            if self.text[place] in " \t\r\n" or self._separator(place):
                place += 1
                continue
            directive = self._directive(place)
            match = _COMMAND.match(self.text, place) if directive is None else None
            if directive is not None:
                self._take_in(directive)
                place = directive.end()
            elif match is None:
                place = self._unknown(place)
            elif match["open"]:
                place = self._program(match.end())
            elif match["setting"] or match["other"]:
                self.complete()
                place = self._assigned(match)
            else:
                self._command(match)
                place = match.end()

    def _separator(self, place: int) -> bool:
        """Return whether the character at ``place`` is a comma between two table entries."""
        table = self.open
        return (
            self.text[place] == ","
            and table is not None
            and 0 < len(table.values) < table.needed
            and not self.text[table.values[-1].end : place].strip(" \t\r\n")
        )

    def _directive(self, place: int) -> re.Match[str] | None:
        """Return the preprocessor directive in the line at ``place``; None for other lines."""
        before = self.text[self.text.rfind("\n", 0, place) + 1 : place]
        return DIRECTIVE.match(self.text, place) if not before.strip(" \t\r") else None

    def _take_in(self, directive: re.Match[str]) -> None:
        word = self._word(*directive.span())
        wrong = self.conditions.apply(directive, word.line)
        if wrong:
            self._fault(word, wrong, "#IFDEF or #IFNDEF before it")

    def _carried_out(
        self, key: tuple[str, int], word: Word, guard: ConditionalBlock | None = None
    ) -> bool:
        """Record the compensation command ``key`` with the conditional blocks that contain it, or
        with the block ``guard``. Return False, with a fault, if another branch of a block has the
        same command, else True.

        Of commands in two branches of a block only one is sent.
        """
        here = self.conditions.here
        apart = [
            (other, earlier)
            for other, earlier, there in self.carried
            if in_two_branches(here, there)
        ]
        self.script.apart += [(key[1], word, earlier) for _, earlier in apart[:1]]
        for other, earlier in apart:
            if other == key:
                self._fault(
                    word,
                    f"the same statement is in another branch of a conditional block, in line"
                    f" {earlier.line}: not both are sent",
                    "the script as it was sent to the card, without conditional blocks",
                    " ".join(word.text.split()),
                )
                return False
        self.carried.append((key, word, here))
        block = here[0][0] if here else guard
        if block is not None:
            self.script.conditional.append((key[1], word, block))
        return True

    def complete(self) -> None:
        """Report a table whose entries are not complete at the end of the scripts."""
        table, self.open = self.open, None
        if table is not None and len(table.values) < table.needed:
            self._fault(
                table.word,
                f"{table.label}: entries are missing; missing values do not count as zero",
                f"{table.needed} whole numbers",
                str(len(table.values)),
            )

    def _word(self, start: int, end: int) -> Word:
        line = bisect_left(self.line_ends, start) + 1
        return Word(self.text[start:end], self.file, self.number, line, start, end)

    def _fault(self, word: Word, message: str, expected: str, found: str | None = None) -> None:
        fault = word.fault(message, expected=expected, found=found)
        plain = in_numbers(word.text, self.conditions.macros).rstrip()
        known = plain != word.text.rstrip() and not self.conditions.undecided(word.text)
        if known and _COMMAND.match(plain) is not None:
            hint = f"write `{plain}` in this line of a copy of the script, if it was sent like this"
            fault = replace(fault, hint=hint)
        self.script.faults.append(fault)

    def _unknown(self, place: int) -> int:
        end = re.compile(r"[\r\n]|$").search(self.text, place)
        word = self._word(place, len(self.text) if end is None else end.start())
        if self._idle_by_macro(word):
            return word.end
        message = "this is not a command that compwright knows, and it may have an effect"
        if self.open is not None and len(self.open.values) < self.open.needed:
            message = f"{self.open.label}: this is not a whole number"
        expected = "DEFINE, DELETE, I..=.. and the like; docs/controllers/pmac.md"
        if _INCLUDE.match(word.text):
            message = "the script of another file belongs here, and is not in this one"
            expected = "the content of that file in the place of this line"
        self._fault(word, message, expected)
        return word.end

    def _idle_by_macro(self, word: Word) -> bool:
        """Return whether a line is empty or without effect once its macros are expanded."""
        expanded_text = expanded(word.text, self.conditions.macros).rstrip()
        known = expanded_text != word.text.rstrip() and not self.conditions.undecided(word.text)
        match = _COMMAND.match(expanded_text) if known else None
        if match is None or (self.open is not None and len(self.open.values) < self.open.needed):
            return False
        end = expression_end(expanded_text, match.end()) if match["other"] else match.end()
        return bool(match["idle"] or match["other"]) and end == len(expanded_text)

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

    # --- tables

    def _entry(self, word: Word) -> None:
        low, high = self.range
        if self.open is None or len(self.open.values) >= self.open.needed:
            self._fault(word, "a number without a table: one entry too many?", "the next command")
        elif len(word.text) > _MOST_DIGITS or not low <= int(word.text) <= high:
            self._fault(word, f"{self.open.label}: the entry is too large", f"{low:g} to {high:g}")
            self.open.needed -= 1
        else:
            self.open.values.append(word)

    def _define(self, word: Word, match: re.Match[str]) -> None:
        kind: Kind = match["table"].upper()  # type: ignore[assignment]  # the pattern names them
        if not self._addressed(word):
            return
        if not self._carried_out((f"DEFINE {kind}", self.motor), word):
            self.open = self._table(kind, word, match["arguments"], match.start("arguments"))
            return
        refused = self.buffers.refuses(kind, self.motor)
        if refused:
            self._fault(word, f"the card refuses this (ERR003): {refused}", _ORDER)
        self.buffers.define(kind, self.motor)
        table = self._table(kind, word, match["arguments"], match.start("arguments"))
        if table is None:
            self._fault(word, "the definition cannot be read", _FORMS[kind], match["arguments"])
            plain = in_numbers(match["arguments"], self.conditions.macros)
            self.open = self._table(kind, word, plain, match.start("arguments"))
            return
        self.script.commands.append((f"DEFINE {kind}", self.motor, word))
        self.script.tables[kind, self.motor] = table
        self.open = table

    def _table(self, kind: Kind, word: Word, text: str, place: int) -> MemoryTable | None:
        plane = _PLANE.fullmatch(text) if kind == "COMP" else None
        if plane is not None:
            needed = (int(plane["rows"]) + 1) * (int(plane["columns"]) + 1) - 1
            return MemoryTable(kind, self.motor, word, needed, plane=True)
        match = (_ARGUMENTS if kind == "COMP" else _PLAIN).fullmatch(text)
        if match is None or not int(match["entries"]) or not int(match["length"]):
            return None
        expanded_text = match.groupdict()
        source = int(expanded_text.get("source") or self.motor)
        target = int(expanded_text.get("target") or self.motor)
        if not all(1 <= motor <= MOST_MOTORS for motor in (source, target)):
            return None
        return MemoryTable(
            kind,
            self.motor,
            word,
            int(match["entries"]),
            source=source,
            target=target,
            desired=kind != "COMP" or bool(expanded_text.get("desired")),
            entries=self._word(place + match.start("entries"), place + match.end("entries")),
            length=self._word(place + match.start("length"), place + match.end("length")),
        )

    def _addressed(self, word: Word) -> bool:
        if not 1 <= self.motor <= MOST_MOTORS:
            self._fault(
                word,
                "the table has no motor",
                f"#1 to #{MOST_MOTORS} before it",
                f"#{self.motor}" if self.motor else "no motor",
            )
            return False
        return True

    def _delete(self, word: Word, name: str) -> None:
        if name in ("COMP", "BLCOMP", "TCOMP"):
            if not self._addressed(word):
                return
            if not self._carried_out((f"DELETE {name}", self.motor), word):
                return
            refused = self.buffers.keeps(name, self.motor)
            if refused:
                self._fault(word, f"the card refuses this (ERR003): {refused}", _ORDER)
            self.script.tables.pop((name, self.motor), None)  # type: ignore[arg-type]
        self.buffers.delete(name, self.motor)
        self.script.commands.append((f"DELETE {name}", self.motor, word))

    # --- settings

    def _assigned(self, match: re.Match[str]) -> int:
        """Record the assignment at a match; return the position in the text at which it ends."""
        end = expression_end(self.text, match.end())
        if end == match.end():
            word = re.compile(r"\S*").match(self.text, end)
            end = end if word is None else word.end()
        if match["setting"]:
            self._set(match, end)
        elif self.text[end : end + 1].strip():
            return self._unknown(match.start())
        return end

    def _set(self, match: re.Match[str], end: int) -> None:
        value = self._word(match.end(), end)
        number = whole_value(value.text, self.conditions.macros)
        value = replace(value, value=number)
        if match["last"] or match["count"]:
            self.script.shared.add(value)
        command = self._word(match.start(), end)
        macro = self.conditions.undecided(value.text)
        for quantity, motor in self._assigned_quantities(match):
            if macro:
                name = match["setting"].split("=")[0].strip()
                message = f"{name}: a conditional block decides what the macro {macro} is"
                self._fault(value, message, "its number in its place, as it was sent to the card")
                continue
            if number is None or abs(number) >= _MOST:
                name = match["setting"].split("=")[0].strip()
                message = f"{name} is set to something that is not a whole number"
                self._fault(value, message, "a whole number, or $ and hexadecimal digits")
                continue
            guard = self.conditions.guard_of(value.text)
            if not self._carried_out((quantity, motor), command, guard):
                continue
            self.script.settings.setdefault((quantity, motor), []).append(value)
            self.script.commands.append((quantity, motor, command))

    def _assigned_quantities(self, match: re.Match[str]) -> Iterator[tuple[str, int]]:
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
        """Skip a program, and report the compensation quantities that it sets."""
        self.complete()
        end = _END.search(self.text, place)
        if end is None:
            word = self._word(place - len("OPEN"), place)
            self._fault(word, "the program has no end", "CLOSE behind it")
            return len(self.text)
        self._in_program(place, end.start())
        return end.end()

    def _in_program(self, place: int, end: int) -> None:
        """Report the compensation quantities that a program in a script sets; the program's macros
        are expanded first.
        """
        for line in re.compile(r"[^\r\n]+").finditer(self.text, place, end):
            directive = DIRECTIVE.match(line[0].lstrip(" \t"))
            if directive is not None:
                self._take_in_program(directive, line)
                continue
            expanded_text = expanded(line[0], self.conditions.macros)
            word = self._word(*line.span())
            for match in _SET.finditer(expanded_text):
                for meant in self._assigned_quantities(match):
                    self.script.programs[meant] = replace(word, text=match[0])
            for match in (*_TABLE.finditer(expanded_text), *_COMPUTED.finditer(expanded_text)):
                self.script.programs["enabled", 0] = replace(word, text=match[0])

    def _take_in_program(self, directive: re.Match[str], line: re.Match[str]) -> None:
        word = self._word(*line.span())
        wrong = self.conditions.apply(directive, word.line)
        if wrong:
            self._fault(word, wrong, "#IFDEF or #IFNDEF before it")


_ORDER = (
    "tables deleted from the lowest motor up and defined from the highest down, all COMP before"
    " TCOMP, BLCOMP, TBUF, ROTARY, LOOKAHEAD and GATHER"
)
_FORMS = {
    "COMP": "entries,#source[D],#target,length",
    "BLCOMP": "entries,length",
    "TCOMP": "entries,length",
}
