"""Find the axis of a table file whose rows do not name it, by another file or by the file name."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import field_matches
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import BINARY, ReadText, text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile
from compwright.words.sentences import say

#: A line of a HAL file (or of HALCMD in an INI) with the pin that takes the place of a joint's
#: BACKLASH (milltask(1): these pins change at run time what the INI typically states), its
#: number perhaps a variable; behind # stands a remark.
#: ``[SECTION]KEY``, ``$name``, ``${name}``: a text that another file or a variable says.
_SUBSTITUTED = rb"(?:\[\w+\](?:\(\w+\)|\w+)|\$(?:\w+|\{\w+\}))"
_PIN = re.compile(
    rb"^(?P<line>[^#;\n]*(?:\bini\.[^\s.]+|" + _SUBSTITUTED + rb")\.backlash\b[^\n]*)",
    re.MULTILINE,
)
#: A line with a pin of the external offset of an axis, which adds to its position while it is
#: enabled (motion(9)); one that keeps it off is none.
_OFFSET = re.compile(
    rb"^(?P<line>(?![^#;\n]*\beoffset-enable[ \t]+(?:0|false)\b)[^#;\n]*"
    rb"\baxis\.(?P<axis>[a-z])\.eoffset-(?:enable|counts)\b[^\n]*)",
    re.MULTILINE | re.IGNORECASE,
)
#: A line that sets or links a pin whose name another file or a variable says. Where more of the
#: name follows, it is no pin of the motion controller's own. In Tcl, ``hal`` precedes the command,
#: and quotation marks may stand around the name.
_HIDDEN = rb"(?:\"?" + _SUBSTITUTED + rb"+\"?)"
_HIDDEN_PIN = re.compile(
    rb"^(?P<line>(?:[^#;\n]*\bhal[ \t]+|[ \t]*)(?:setp[ \t]+(?:\"?ini\.)?"
    + _HIDDEN
    + rb"(?=[ \t])|link[ps][ps][ \t]+(?:\S+[ \t]+)?"
    + _HIDDEN
    + rb"(?=[ \t]|$)|net[ \t]+\S+[ \t]+(?:\S+[ \t]+)*?"
    + _HIDDEN
    + rb"(?=[ \t]|$))[^\n]*)",
    re.MULTILINE,
)


class TableFiles:
    """The table files whose rows do not name their axis."""

    def __init__(self, gathered: Gathered, texts: Sequence[ReadText], notes: Notes) -> None:
        self.gathered = gathered
        self.definition = gathered.definition
        self.texts = texts
        self.notes = notes
        binding = self.definition.bindings[curves(self.definition)[0]]
        row = self.definition.statements[binding.statement]
        self.tables = [text for text in texts if "axis" not in row.fields and text.kind == row.text]
        self.template = _template(self.definition)
        self.used: set[int] = set()

    def named(self) -> list[str]:
        """Return the axis addresses that the file names contain."""
        found = (self._address_in_name(text.file) for text in self.tables)
        return [address for address in found if address is not None]

    def _address_in_name(self, file: str) -> str | None:
        before, after = self.template.split("{axis}")
        return _address_between(self.definition, before, after, file)

    def alone(self) -> bool:
        """Return whether the user gave a single table file and nothing else, so that any axis may
        have it.
        """
        return len(self.texts) == len(self.tables) == 1

    def rows(self, address: str, *, mentioned: bool) -> list[FoundValue] | None:
        """Return the rows in the table file of an axis; None if the control's table rows name their
        axis, so that no file has to be found. ``mentioned``: lines in other files name the axis, so
        one of them must name its table file.
        """
        if "table_file" not in self.definition.bindings:
            return None
        if mentioned:
            matching = self._named_by(address)
        else:
            own = [text for text in self.tables if self._address_in_name(text.file) == address]
            matching = own or self.tables
        if not matching:
            return []
        self.used.update(text.number for text in matching)
        if len(matching) > 1:
            self.notes.faults.append(
                Fault(
                    message=f"axis {address}: its table file was given {len(matching)} times",
                    file=matching[0].file,
                    hint="keep one of these files",
                )
            )
        rows = self.gathered.file_rows.get(matching[0].number, [])
        if not rows:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"axis {address}: the table file contains no rows, and such a file does "
                        "not count as an empty table"
                    ),
                    file=matching[0].file,
                    hint="export the table from the control again, or give the file that "
                    "contains its rows",
                )
            )
        return rows

    def _named_by(self, address: str) -> list[ReadText]:
        """Return the table file that a line in another file names for an axis. If this table file
        is missing, that is a fault.
        """
        named = self.gathered.found("table_file", address, None)
        if not named:
            return []
        base = base_name(named[0].text)
        matching = [text for text in self.tables if text.file == base]
        if not matching:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"axis {address}: the table file that its configuration names was not given"
                    ),
                    file=named[0].occurrence.file,
                    place=named[0].occurrence.place,
                    expected=base,
                    found=", ".join(text.file for text in self.tables) or "no table file",
                    hint=f"give {base} with the control's other files",
                )
            )
        return matching

    def note_idle(self, wanted: Collection[str]) -> None:
        """Report the table files that were not used; if only some axes are ``wanted``, leave out
        the table files that other lines name.
        """
        binding = self.definition.bindings.get("table_file")
        named = {
            base_name(occurrence.tokens[binding.field].text.strip())
            for text in self.texts
            for occurrence in text.occurrences
            if binding is not None and occurrence.statement == binding.statement
        }
        for text in self.tables:
            if text.number not in self.used and (not wanted or text.file not in named):
                self.notes.idle_file(say("CW-S012.no_axis", file=text.file))


def unused_table_files(definition: Definition, files: Sequence[ControlFile]) -> list[str]:
    """Return the names of files that the control never opens, because no loaded file names them.

    A machine's folder holds many such files, for example its tool table. A damaged file is not
    returned if, without the damage, it would state what is loaded.
    """
    binding = definition.bindings.get("table_file")
    if binding is None:
        return []
    row = definition.statements[definition.bindings[curves(definition)[0]].statement]
    before, after = _template(definition).split("{axis}")
    reader, odd, named, sections = text_reader(definition), [], set[str](), False
    for file in files:
        faults: list[Fault] = []
        text = reader.read(file, faults) or reader.read(_letters_of(file), [])
        if text is not None and text.kind != row.text:
            sections = sections or bool(text.sections)
            named |= {
                base_name(one.tokens[binding.field].text.strip())
                for one in text.occurrences
                if one.statement == binding.statement
            }
        elif faults and _address_between(definition, before, after, file.name) is None:
            odd.append(file.name)
    return [name for name in odd if sections and name not in named]


def offset_at_run_time(files: Sequence[ControlFile], axes: Collection[str]) -> Iterator[Fault]:
    """Yield a fault for each line of a HAL file that adds an external offset to one of ``axes``.

    ``axes``: the axes of the job, by letter. If one of them has a longer name, each external offset
    in the files is a fault, because it may belong to this axis.
    """
    letters = {name.upper() for name in axes}
    known = bool(letters) and all(len(name) == 1 for name in letters)
    for file in files if letters else ():
        for match in _OFFSET.finditer(file.content):
            if known and match["axis"].decode().upper() not in letters:
                continue
            line = file.content.count(b"\n", 0, match.start()) + 1
            yield Fault(
                message="a HAL file adds an external offset to the position of an axis",
                file=file.name,
                place=f"line {line}",
                expected="eoffset-enable of this axis at 0 in every test, and in the HAL file",
                found=match["line"].decode("latin-1").strip(),
                hint=(
                    "switch the external offset off in the HAL file, measure again, then give "
                    "the new file"
                ),
            )


def changed_at_run_time(files: Sequence[ControlFile]) -> Iterator[Fault]:
    """Yield a fault for each line of a HAL file that changes a joint's backlash at run time."""
    known = "a HAL file changes the backlash of a joint while the control runs"
    hidden = (
        "a HAL file sets a pin without its name: it is unknown whether this is the backlash of a"
        " joint"
    )
    for file in files:
        for pattern, message in ((_PIN, known), (_HIDDEN_PIN, hidden)):
            for match in pattern.finditer(file.content):
                line = file.content.count(b"\n", 0, match.start()) + 1
                yield Fault(
                    message=message,
                    file=file.name,
                    place=f"line {line}",
                    expected=(
                        "BACKLASH of the INI alone, and tests taken with it"
                        if message == known
                        else "the name of the pin in its place, in a copy of the file"
                    ),
                    found=match["line"].decode("latin-1").strip(),
                    hint="correct this line of the HAL file, measure again, then give the new file",
                )


def _letters_of(file: ControlFile) -> ControlFile:
    """Return a copy of a file without the bytes that cannot belong to a text."""
    return replace(file, content=BINARY.sub(b"", file.content))


def _template(definition: Definition) -> str:
    return next(file.name for file in definition.writing if file.rows is not None)


def _address_between(definition: Definition, before: str, after: str, file: str) -> str | None:
    match = re.fullmatch(re.escape(before) + "(.+)" + re.escape(after), file)
    if match is None or not field_matches(definition.addresses.type, match[1]):
        return None
    return normal_text(definition, match[1])


def base_name(path: str) -> str:
    """Return the last part of a path with slashes or backslashes."""
    return re.split(r"[/\\]", path)[-1]
