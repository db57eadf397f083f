"""Write tables of motors as new scripts, or into the user's own scripts.

In the user's own scripts all other bytes stay the same. New commands are put where the card accepts
them. Tables are in the order from the highest motor number down, and all COMP tables come before
the buffers that must follow them. The result is read again before it is returned.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.definition.statements import print_form
from compwright.formats.families.wrapped.card_memory import (
    BEHIND,
    MemoryTable,
    Script,
    Word,
    long_name,
    number_of,
    over_itself,
)
from compwright.formats.families.wrapped.script import read_script
from compwright.formats.families.wrapped.tables import MotorTable
from compwright.formats.text.patching import BytesChange, Patches, fresh_file
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Entries on a line of a script.
_ON_A_LINE = 8
#: A SAVE that ends a script, on a line of its own.
_SAVE = re.compile(rb"(?:^|[\r\n])[ \t]*(SAVE)[ \t]*(?:(?:;|//)[^\r\n]*)?\s*\Z", re.IGNORECASE)
#: The option with the take-up rate that is written where a script states none.
TAKE_UP = "take_up_rate"


def fresh_script(
    definition: Definition, tables: Sequence[MotorTable], rates: Mapping[int, int]
) -> ControlFile:
    """Return a new script that defines ``tables`` in a control without tables. ``rates``: the rate
    at which the control adds the backlash, by motor.
    """
    file = definition.writing[0]
    falling = sorted(tables, key=lambda table: -table.motor)
    lines = [line for table in falling for line in definition_lines(definition, "COMP", table)]
    for table in falling:
        lines += definition_lines(definition, "BLCOMP", table) if table.varies else []
    for table in sorted(tables, key=lambda table: table.motor):
        lines += _setting_lines(definition, table, rates[table.motor], [TAKE_UP, "backlash"])
    return fresh_file(definition, file, file.name, {}, lines).patched([0])[0]


def definition_lines(definition: Definition, kind: str, table: MotorTable) -> list[str]:
    """Return the lines that define a table of a motor: its command, then its entries."""
    entries = table.entries if kind == "COMP" else table.lost
    named = {"axis": str(table.motor), "source": str(table.motor)}
    form = definition.statements["table" if kind == "COMP" else "lost_motion_table"].form
    head = print_form(form, {**named, "entries": str(len(entries)), "length": str(table.length)})
    rows = (entries[at : at + _ON_A_LINE] for at in range(0, len(entries), _ON_A_LINE))
    return [head, *(" ".join(str(entry) for entry in row) for row in rows)]


def _setting_lines(
    definition: Definition, table: MotorTable, rate: int, names: Iterable[str]
) -> list[str]:
    values = {TAKE_UP: rate, "backlash": table.constant}
    return [
        print_form(
            definition.statements[definition.bindings[name].statement].form,
            {"axis": str(table.motor), "value": str(values[name])},
        )
        for name in names
        if name == "backlash" or table.takes_up
    ]


def patched_scripts(
    definition: Definition,
    files: Sequence[ControlFile],
    tables: Sequence[MotorTable],
    rates: Mapping[int, int],
    faults: list[Fault],
) -> tuple[ControlFile, ...]:
    """Return the user's own scripts with ``tables`` written into them. ``rates``: the rate at which
    the control adds the backlash, by motor; ``faults``: gets the reasons if this is impossible.
    """
    patcher = _Patcher(definition, files, tables)
    for table in sorted(tables, key=lambda table: -table.motor):
        patcher.put(table, rates[table.motor])
    patcher.switch_on()
    faults.extend(patcher.faults)
    written = patcher.patches.patched(range(len(files)))
    if not patcher.faults:
        faults.extend(_read_otherwise(patcher.script, read_script(definition, written), tables))
    return written


class _Patcher:
    def __init__(
        self, definition: Definition, files: Sequence[ControlFile], tables: Sequence[MotorTable]
    ) -> None:
        self.definition = definition
        self.motors = {table.motor for table in tables}
        self.script = read_script(definition, files)
        self.patches = Patches(definition.dialect, files)
        self.faults: list[Fault] = []

    def put(self, table: MotorTable, rate: int) -> None:
        """Write a motor's tables, backlash and rate into the scripts."""
        own = over_itself(self.script, table.motor)
        if own:
            first = next((one for one in own if one.motor == table.motor), own[0])
            self._replace(first, table.entries, table.length)
            for other in own:
                if other is not first:
                    self._replace(other, (0,) * other.needed, other.counts)
        elif ("COMP", table.motor) in self.script.tables:
            self._occupied(self.script.tables["COMP", table.motor])
        else:
            self._define("COMP", table)
        lost = self.script.tables.get(("BLCOMP", table.motor))
        if lost is not None:
            self._replace(lost, table.lost, table.length)
        elif table.varies:
            self._define("BLCOMP", table)
        self._set(table, rate)

    def _occupied(self, other: MemoryTable) -> None:
        message = (
            f"motor {other.motor} holds a table of its own no more: {other.label} corrects"
            f" #{other.target} by #{other.source}, and a motor holds one table"
        )
        expected = "that table defined at a motor without one, by hand, and the script of that"
        self.faults.append(other.word.fault(message, expected=expected))

    def _replace(self, place: MemoryTable, entries: Sequence[int], length: int) -> None:
        """Replace the entries of a table; a number that stays equal keeps its characters."""
        for word, value in ((place.entries, len(entries)), (place.length, length)):
            if word is not None:
                self._number(word, value)
        for word, value in zip(place.values, entries, strict=False):
            self._number(word, value)
        for before, word in zip(
            place.values[len(entries) - 1 :], place.values[len(entries) :], strict=False
        ):
            self._remove(before, word)
        more = entries[len(place.values) :]
        if more:
            last = place.values[-1]
            separator = "," if self._by_comma(place) else " "
            text = "".join(f"{separator}{value}" for value in more)
            self.patches.insert(last.number, last.end, text)

    def _remove(self, before: Word, word: Word) -> None:
        """Remove a table entry and the comma before it."""
        between = self.patches.files[word.number].content[before.end : word.start]
        start = before.end + between.rfind(b",") if b"," in between else word.start
        if b"," in between and between[start - before.end + 1 :].strip():
            start = word.start
        self.patches.replace(word.number, BytesChange(start, word.end, b""))

    def _by_comma(self, place: MemoryTable) -> bool:
        if len(place.values) < 2:
            return False
        first, second = place.values[:2]
        return b"," in self.patches.files[first.number].content[first.end : second.start]

    def _number(self, word: Word, value: int) -> None:
        if number_of(word) != value:
            self.patches.replace(
                word.number, BytesChange(word.start, word.end, str(value).encode())
            )

    def _assigned(self, word: Word, value: int) -> bool:
        """Set the value of an assignment; return False if that would change other variables as
        well.
        """
        if word in self.script.shared and number_of(word) != value:
            return False
        self._number(word, value)
        return True

    def _define(self, kind: str, table: MotorTable) -> None:
        """Insert the definition of a new table at a place where the control accepts it, as it
        requires definitions in a certain order.
        """
        lines = definition_lines(self.definition, kind, table)
        behind = (kind, *BEHIND[kind])
        for name, motor, word in self.script.commands:
            defined = long_name(name.removeprefix("DEFINE "))
            if (
                name.startswith("DEFINE ")
                and defined in behind
                and (defined != kind or motor < table.motor)
            ):
                self._before(word, lines)
                return
        kinds = ("COMP",) if kind == "COMP" else ("COMP", "TCOMP", "BLCOMP")
        last = [one.values[-1] for name in kinds for one in self.script.of(name)]  # type: ignore[arg-type]
        if last:
            self._insert_after(max(last, key=lambda word: (word.number, word.start)), lines)
        else:
            self._at_the_end(lines)

    def _before(self, word: Word, lines: Sequence[str]) -> None:
        """Insert lines before a command, and before the line that selects its motor."""
        line = self.patches.line(word.number, word.start)
        content = self.patches.files[word.number].content
        if re.fullmatch(rb"\s*(#\s*\d+)?\s*", content[line.start : word.start]):
            self.patches.add_lines(word.number, word.start, lines, before=True)
        else:
            motor = next((of for _, of, each in self.script.commands if each == word), 0)
            again = f"\n#{motor} " if motor else "\n"
            self.patches.insert(word.number, word.start, "\n" + "\n".join(lines) + again)

    def _insert_after(self, word: Word, lines: Sequence[str]) -> None:
        """Insert lines after the last number of a table.

        If the next command applies to the motor that was addressed before, a line that addresses
        this motor again is added.
        """
        content = self.patches.files[word.number].content
        line = self.patches.line(word.number, word.start)
        following = re.sub(rb"(?:;|//)[^\r\n]*", b"", content[word.end :]).lstrip()
        motor = self._addressed(word)
        again = [] if following[:1] in (b"#", b"I", b"i", b"") else [f"#{motor}"]
        if re.fullmatch(rb"[ \t]*((;|//).*)?", content[word.end : line.end], re.DOTALL):
            self.patches.add_lines(word.number, word.start, [*lines, *again])
        else:
            self.patches.insert(word.number, word.end, "\n".join(["", *lines, *again, ""]))

    def _addressed(self, word: Word) -> int:
        return next(one.motor for one in self.script.tables.values() if word in one.values)

    def _at_the_end(self, lines: Sequence[str]) -> None:
        """Add lines at the end of the scripts, but before a final SAVE, which stores what precedes
        it.
        """
        number = len(self.patches.files) - 1
        content = self.patches.files[number].content.removesuffix(b"\x1a")
        if (saved := _SAVE.search(content)) is not None:
            self.patches.add_lines(number, saved.start(1), lines, before=True)
        elif content.strip():
            self.patches.add_lines(number, len(content.rstrip()) - 1, lines)
        else:
            self.patches.insert(number, len(content), "".join(f"{line}\n" for line in lines))

    def _set(self, table: MotorTable, rate: int) -> None:
        missing = []
        constant = self.script.setting("backlash", table.motor)
        if constant is None:
            needed = table.takes_up or ("BLCOMP", table.motor) in self.script.tables
        else:
            needed = not self._assigned(constant, table.constant)
        if needed:
            missing.append("backlash")
        taking = self.script.setting(TAKE_UP, table.motor)
        off = taking is not None and table.takes_up and number_of(taking) == 0
        if taking is None or (off and not self._assigned(taking, rate)):
            missing.append(TAKE_UP)
        lines = _setting_lines(self.definition, table, rate, missing)
        if lines:
            self._at_the_end(lines)

    def switch_on(self) -> None:
        """Activate tables if the scripts deactivate all of them, unless that would activate other
        tables.
        """
        switch = self.script.setting("enabled")
        binding = self.definition.bindings["enabled"]
        if switch is None or not isinstance(binding, Choice):
            return
        if binding.values.get(str(number_of(switch))) != "no":
            return
        sleeping = [
            table.label
            for table in (*self.script.of("COMP"), *self.script.of("BLCOMP"))
            if any(table.numbers) and not self._ours(table)
        ]
        if sleeping:
            message = (
                "the scripts end with all tables switched off (I51 = 0); I51 = 1 for this table"
                f" would switch on those of other motors: {', '.join(sleeping)}"
            )
            expected = "scripts in which these are missing or zero, or I51 = 1 if they are active"
            self.faults.append(switch.fault(message, expected=expected))
            return
        if not self._assigned(switch, int(str(binding.writes))):
            form = self.definition.statements[binding.statement].form
            self._at_the_end([print_form(form, {"value": str(binding.writes)})])

    def _ours(self, table: MemoryTable) -> bool:
        alone = table.kind == "BLCOMP" or table.source == table.target
        return alone and (table.target or table.motor) in self.motors


def _read_otherwise(before: Script, after: Script, tables: Sequence[MotorTable]) -> list[Fault]:
    """Return a fault for each motor whose tables in the changed scripts, when read back, are not
    the intended tables.
    """
    if after.faults:
        help_ = "the tables of these motors defined once, deletions before definitions"
        return [
            Fault(
                message=f"the new table cannot be written into the script: {fault.message}",
                file=fault.file,
                expected=help_,
                hint="correct this line in the script of the control, then give the script again",
            )
            for fault in after.faults[:1]
        ]
    own = {table.motor: table for table in tables}
    faults = []
    for motor, table in own.items():
        found = [one for one in over_itself(after, motor) if any(one.numbers)]
        right = [(table.entries, table.length)] if any(table.entries) else []
        lost = after.tables.get(("BLCOMP", motor))
        if [(one.numbers, one.counts) for one in found] != right or (
            table.varies
            and (lost is None or (lost.numbers, lost.counts) != (table.lost, table.length))
        ):
            faults.append(
                Fault(
                    message=f"motor {motor}: the new table cannot be put into this script",
                    hint=(
                        "give the script with the existing table of this motor among the control's"
                        " files (`states` or `--state`)"
                    ),
                )
            )
    for key, old in before.tables.items():
        new = after.tables.get(key)
        mine = old.motor in own or old.target in own
        if not mine and (new is None or new.numbers != old.numbers or new.counts != old.counts):
            faults.append(
                Fault(
                    message=f"an internal error of compwright: {old.label}, a table of another "
                    "motor, would change",
                    hint="load nothing of this run, and move the table of the other motor to a "
                    "script of its own",
                )
            )
    return faults
