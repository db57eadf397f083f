"""Read value lists, axis parameter lists and the start-up list, and sort their lines by axis.

The header of a list states its axis. Without a header the start-up list states it. If a start-up
list is given, the control loads only the value lists that it names.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence, name_in_form
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.notes import CORRECT_VALUE, EXPORT_AGAIN, KEEP_ONE, Notes
from compwright.formats.text.texts import ReadText, text_reader
from compwright.records.correction import ControlFile
from compwright.words.sentences import say

#: Statements of the header, and those of the start-up list.
AXIS_NUMBER = "axis_number"
HEADERS = (AXIS_NUMBER, "logical_axis_number")
LISTED_COUNT, LISTED_AXIS, LISTED_FILE = "listed_count", "listed_axis", "listed_file"
_START_UP = (LISTED_COUNT, LISTED_AXIS, LISTED_FILE)
#: How every statement of a value list begins.
_VALUE_LIST = "kw."
_REMARK = re.compile(rb"/\*.*?(?:\*/|\Z)|#[^\r\n]*", re.DOTALL)


def without_remarks(content: bytes) -> bytes:
    """Return a file with blanks in place of comments, so that all other bytes keep their place."""
    return _REMARK.sub(lambda remark: re.sub(rb"[^\r\n]", b" ", remark[0]), content)


@dataclass(slots=True)
class ListsByAxis:
    """The statements in all lists of a control, sorted by axis and statement.

    - ``statements``: the lines of each axis, ``statements[address][statement]``, in the order of
      the files.
    - ``files``: by axis, the indices of its files among those given.
    - ``listed``: by axis, its lines in the start-up list.
    - ``start_up``: by statement, the lines of the start-up list.
    - ``missing``: by axis, the line of the start-up list that names a file which was not given.
    """

    definition: Definition
    statements: dict[str, dict[str, list[FoundValue]]] = field(default_factory=dict)
    files: dict[str, set[int]] = field(default_factory=dict)
    listed: dict[str, list[FoundValue]] = field(default_factory=dict)
    start_up: dict[str, list[FoundValue]] = field(default_factory=dict)
    missing: dict[str, FoundValue] = field(default_factory=dict)

    def places(self, address: str, statement: str) -> Sequence[FoundValue]:
        """Return each value of a statement in the lists of an axis, with its file and line."""
        return self.statements.get(address, {}).get(statement, ())

    def name(self, statement: str) -> str:
        """Return the control's name of a statement, with ``[..]`` in place of an index."""
        form = self.definition.statements[statement].form
        head, bracket, tail = form.partition("[{index}]")
        return f"{name_in_form(head)}[..]{tail.split()[0]}" if bracket else name_in_form(form)

    def value_files(self, address: str) -> set[int]:
        """Return the file indices of the value lists that the control loads for an axis."""
        return {
            found.number
            for name, places in self.statements.get(address, {}).items()
            if _in_value_list(self.definition, name)
            for found in places
        }


def _in_value_list(definition: Definition, statement: str) -> bool:
    return definition.statements[statement].form.startswith(_VALUE_LIST)


def read_lists(definition: Definition, files: Sequence[ControlFile], notes: Notes) -> ListsByAxis:
    """Return the statements of each axis. Lines or lists that cannot be read become faults."""
    reader = text_reader(definition)
    texts: list[ReadText] = []
    for number, file in enumerate(files):
        code = ControlFile(file.name, without_remarks(file.content))
        text = reader.read(code, notes.faults, number)
        if text is not None:
            notes.findings.extend(text.findings)
            texts.append(text)
    sorter = _Sorter(ListsByAxis(definition), notes, texts)
    for text in texts:
        sorter.sort(text)
    sorter.find_missing()
    return sorter.lists


class _Sorter:
    def __init__(self, lists: ListsByAxis, notes: Notes, texts: Sequence[ReadText]) -> None:
        self.lists = lists
        self.notes = notes
        self.texts = texts
        for text in texts:
            for occurrence in text.occurrences:
                if occurrence.statement in _START_UP:
                    found = FoundValue(value_of(occurrence), occurrence, text.number)
                    lists.start_up.setdefault(occurrence.statement, []).append(found)
        self.axes = self._by_index(LISTED_AXIS)
        self.names = self._by_index(LISTED_FILE)
        for index, found in self.axes.items():
            lists.listed.setdefault(str(int(found.text)), []).append(found)
            if index not in self.names:
                message = "the axis in this line has no list"
                notes.refuse(
                    "start-up list", message, found, expected=f"achs_kw[{index}]", hint=EXPORT_AGAIN
                )

        self._check_count()

    def _check_count(self) -> None:
        """Add a fault for each start-up list entry whose index is beyond the number of entries that
        the list states.
        """
        counts: Sequence[FoundValue] = self.lists.start_up.get(LISTED_COUNT, ())
        name = self.lists.name(LISTED_COUNT)
        for other in counts[1:]:
            if int(other.text) != int(counts[0].text):
                message = f"{name} contradicts {counts[0].where}"
                self.notes.refuse(
                    "start-up list", message, other, expected=counts[0].text, hint=KEEP_ONE
                )
        for index, found in {**self.axes, **self.names}.items():
            if counts and index >= int(counts[0].text):
                message = (
                    f"the index of this entry is {index}, and {name} gives the number of entries "
                    f"as {counts[0].text}, so the control possibly does not load it"
                )
                expected = f"{name} {index + 1}, or no such entry"
                self.notes.refuse(
                    "start-up list", message, found, expected=expected, hint=CORRECT_VALUE
                )

    def _by_index(self, statement: str) -> Mapping[int, FoundValue]:
        """Return the start-up list's entries by index; two different entries with one index are a
        fault.
        """
        entries: dict[int, FoundValue] = {}
        for found in self.lists.start_up.get(statement, ()):
            first = entries.setdefault(int(found.occurrence.tokens["index"].text), found)
            if not same_value(first.text.casefold(), found.text.casefold()):
                name = self.lists.name(statement)
                message = f"{name} contradicts {first.where}"
                self.notes.refuse(
                    "start-up list", message, found, expected=first.text, hint=KEEP_ONE
                )
        return entries

    def sort(self, text: ReadText) -> None:
        """Assign the statements of one file to its axis."""
        own = [each for each in text.occurrences if each.statement not in _START_UP]
        values = any(_in_value_list(self.lists.definition, each.statement) for each in own)
        indices = [i for i, name in self.names.items() if base_name(name.text) == _low(text)]
        if values and not indices and self.lists.start_up:
            self.notes.idle_file(say("CW-S012.start_up_list", file=text.file))
            return
        address = self._address(text, own, indices if values else ())
        if address is None:
            return
        self.lists.files.setdefault(address, set()).add(text.number)
        statements = self.lists.statements.setdefault(address, {})
        for occurrence in own:
            found = FoundValue(value_of(occurrence), occurrence, text.number)
            statements.setdefault(occurrence.statement, []).append(found)

    def _address(
        self, text: ReadText, own: Sequence[Occurrence], indices: Sequence[int]
    ) -> str | None:
        """Return the axis of a list by its header (in the lines ``own``) and by the start-up list's
        entries with the ``indices``, which must agree.
        """
        headers = [
            FoundValue(each.tokens["axis"].text, each, text.number)
            for each in own
            if each.statement in HEADERS
        ]
        listed = [self.axes[index] for index in indices if index in self.axes]
        numbers = {int(found.text) for found in (*headers, *listed)}
        if len(numbers) > 1:
            second = next(
                found
                for found in (*headers, *listed)
                if int(found.text) != int((*headers, *listed)[0].text)
            )
            message = "header and start-up list name different axes"
            first = (*headers, *listed)[0]
            self.notes.refuse(
                "this list",
                message,
                second,
                expected=f"{first.text} ({first.where})",
                hint=CORRECT_VALUE,
            )
        elif not numbers and own:
            message = "does not state the number of its axis"
            self.notes.refuse(
                "this list",
                message,
                FoundValue(own[0].statement, own[0], text.number),
                expected=f"a line {self.lists.name(AXIS_NUMBER)} <number>",
                found="none",
                hint=(
                    f"add the line `{self.lists.name(AXIS_NUMBER)} <number>` to the list; or give"
                    " the start-up list that assigns this list to its axis"
                ),
            )
        return str(numbers.pop()) if len(numbers) == 1 else None

    def find_missing(self) -> None:
        """Report the lists that the start-up list names but that are not among the files."""
        given = {_low(text) for text in self.texts}
        for index, name in self.names.items():
            if index in self.axes and base_name(name.text) not in given:
                self.lists.missing[str(int(self.axes[index].text))] = name


def base_name(path: str) -> str:
    """Return a file name without folder, in lower case, because the controls run on Windows."""
    return re.split(r"[/\\]", path.strip().strip("\"'"))[-1].casefold()


def _low(text: ReadText) -> str:
    return text.file.casefold()


def value_of(occurrence: Occurrence) -> str:
    """Return the value in a line of an axis list, as text."""
    tokens = occurrence.tokens
    return tokens["value" if "value" in tokens else "axis"].text


def entries(places: Sequence[FoundValue]) -> Iterator[tuple[int, FoundValue]]:
    """Yield the index of each table entry together with its line."""
    for found in places:
        yield int(found.occurrence.tokens["index"].text), found
