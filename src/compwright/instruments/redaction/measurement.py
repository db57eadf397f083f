"""Copy a measurement file without names, serial numbers and remarks, from bytes to bytes."""

from __future__ import annotations

import codecs
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from xml.sax.saxutils import escape, quoteattr

from compwright.foundations.errors import CompwrightError, Fault, InputError
from compwright.foundations.redaction import Cuts
from compwright.foundations.utf8 import encoded
from compwright.instruments.b5r_elements import ELEMENTS
from compwright.instruments.circular_reading import circular_form
from compwright.instruments.drift_csv import is_two_columns
from compwright.instruments.fault_list import by_profile
from compwright.instruments.forms import FORMS, PLAIN_CSV, form_of
from compwright.instruments.other_files import is_circular
from compwright.instruments.own_forms import is_plain_csv
from compwright.instruments.profile import SIGNS, Profile
from compwright.instruments.profile_of_file import proposed_profile
from compwright.instruments.profile_reading import read_profile
from compwright.instruments.profile_tables import at_its_header, has_columns
from compwright.instruments.redaction.cutting import kept_or_cut, redacted_lines
from compwright.instruments.redaction.foreign_tables import (
    SIGN_TO_FILL_IN,
    profile_lines,
    redacted_table,
)
from compwright.instruments.redaction.words import KEPT_WORDS, RESULT_WORDS, is_axis, is_keywords
from compwright.instruments.redaction.workbooks import other_parts, workbook_of
from compwright.instruments.safe_xml import Element, read_xml
from compwright.instruments.spans import Elements, Grammar, Meaning
from compwright.instruments.table_shape import has_table
from compwright.instruments.text_input import encoding_of, read_any_lines
from compwright.instruments.workbook import WorkbookSheet, is_workbook, sheets_of


def redacted_xml(content: bytes, file: str, known: Elements, cuts: Cuts) -> bytes:
    """Return an XML file without private data, in UTF-8. ``known``: the elements and attributes
    whose meaning is known; ``cuts`` records what is removed.

    Raises InputError for invalid XML.
    """
    root = read_xml(content, file)
    lines = ['<?xml version="1.0" encoding="utf-8"?>', *_lines(root, 0, known, cuts), ""]
    return "\n".join(lines).encode()


def _lines(element: Element, depth: int, known: Elements, cuts: Cuts) -> list[str]:
    indent = "  " * depth
    start = "".join(
        f" {name}={quoteattr(kept_or_cut(value, meaning, cuts))}"
        for name, value in element.attributes.items()
        if (meaning := _meaning(element.tag, name, value, known, cuts)) is not None
    )
    text = escape(kept_or_cut(element.text, known.tags[element.tag], cuts))
    if not element.children:
        return [f"{indent}<{element.tag}{start}>{text}</{element.tag}>"]
    lines = [f"{indent}<{element.tag}{start}>{text}"]
    for child in element.children:
        if child.tag in known.tags:
            lines += _lines(child, depth + 1, known, cuts)
        else:
            _leave_out(child, cuts)
    return [*lines, f"{indent}</{element.tag}>"]


def _meaning(tag: str, name: str, value: str, known: Elements, cuts: Cuts) -> Meaning | None:
    """Return the meaning of an XML attribute. If the meaning is unknown, record the attribute's
    value in ``cuts`` as removed, and return None.
    """
    if name == "NAME":
        return known.names.get(tag, "result")
    meaning = known.attributes.get(name.upper())
    if meaning is None:
        cuts.remark(value, "attribute")
    return meaning


def _leave_out(element: Element, cuts: Cuts) -> None:
    cuts.removed.append(("element", element.tag))
    for text in (element.text, *element.attributes.values()):
        cuts.remark(text, "element")
    for child in element.children:
        _leave_out(child, cuts)


_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
#: Names of the forms, and replacements of texts, in lower case.
_OTHER_WORDS = frozenset({"redacted", "trace", "qc10", "qc20"})
#: Words in lower case that may be in a copy whatever was removed.
ALLOWED: frozenset[str] = (
    KEPT_WORDS
    | _OTHER_WORDS
    | {
        piece
        for names in (
            *(form.words for form in (*FORMS, PLAIN_CSV)),
            *(ELEMENTS.tags, ELEMENTS.attributes, RESULT_WORDS),
        )
        for name in names
        for piece in re.findall(r"[^\W_]+", name.lower())
    }
)


@dataclass(frozen=True, slots=True)
class Redacted:
    """A copy of a file without private data, and the mapping profile that reads the copy.

    ``profile``: the text of the profile for the copy, if the original needs a profile. ``read_by``:
    the profile that read the original. If the sign is unknown, its key is empty in the copy's
    profile too.
    """

    content: bytes
    profile: str = ""
    read_by: Profile | None = None

    @property
    def answered(self) -> str:
        """The profile as text with an assumed sign. With it the copy and the original can be read
        and compared, although the real sign is unknown.
        """
        return self.profile.replace(SIGN_TO_FILL_IN, f"sign: {SIGNS[0]}")


def is_measurement(content: bytes, file: str, profile: Profile | None = None) -> bool:
    """Return whether the content of a file is certainly a measurement: its form is known, or it has
    the columns of the ``profile``.
    """
    if is_workbook(content) or is_circular(content, file):
        return True
    try:
        lines, _ = read_any_lines(content, file)
        if form_of(lines, file) is not PLAIN_CSV or is_plain_csv(lines) or is_two_columns(lines):
            return True
    except InputError:
        return False
    if profile is None or profile.layout == "own":
        return False
    return has_columns(lines, at_its_header(lines, profile))


def holds_table(content: bytes, file: str) -> bool:
    """Return whether a text contains a table of numbers, whatever its columns mean."""
    try:
        return has_table(read_any_lines(content, file)[0])
    except InputError:
        return False


def redacted_measurement(
    content: bytes, file: str, cuts: Cuts, profile: Profile | None = None
) -> Redacted:
    """Return a copy of a measurement file without private data; ``cuts`` records what is removed.

    A table of another program is read with its ``profile``, or with a proposed profile if None is
    given. Raises InputError or UsageError for other files, and if no profile can be proposed.
    """
    if is_workbook(content):
        return _of_workbook(content, file, cuts, profile)
    if is_circular(content, file):
        return Redacted(_by(circular_form(content).grammar, content, file, cuts))
    lines, _ = read_any_lines(content, file)
    form = form_of(lines, file)
    if form is not PLAIN_CSV or _is_plain(lines, profile):
        answers = profile if profile is not None and profile.layout == "own" else None
        return Redacted(_by(form.spans_of, content, file, cuts), read_by=answers)
    if profile is not None:
        return _by_profile(content, file, cuts, profile)
    proposed, sign_open = _proposed(content, file)
    return _by_profile(content, file, cuts, proposed, sign_open=sign_open)


def _is_plain(lines: Sequence[str], profile: Profile | None) -> bool:
    if profile is None or profile.layout == "own":
        return is_plain_csv(lines) or is_two_columns(lines)
    found = at_its_header(lines, profile)
    return is_plain_csv(lines) and not has_columns(lines, found)


def _by(grammar: Grammar, content: bytes, file: str, cuts: Cuts) -> bytes:
    if isinstance(grammar, Elements):
        return redacted_xml(content, file, grammar, cuts)
    text = _lines_of(content, file)
    return text.to_bytes(redacted_lines(text.lines, grammar, cuts))


def _by_profile(
    content: bytes, file: str, cuts: Cuts, profile: Profile, *, sign_open: bool = False
) -> Redacted:
    text = _lines_of(content, file, profile.encoding)
    found = at_its_header(text.lines, profile)
    lines, read_by = redacted_table(text.lines, found, cuts)
    return Redacted(text.to_bytes(lines), profile_lines(read_by, sign_open=sign_open), found)


@dataclass(frozen=True, slots=True)
class _Lines:
    """The lines of a file with their line ends.

    ``lines``: the texts without line ends. ``ends``: the line end of each line, empty after the
    last line. ``mark``: the byte order mark at the start of the file.
    """

    lines: tuple[str, ...]
    ends: tuple[str, ...]
    encoding: str
    mark: bytes

    def to_bytes(self, lines: Sequence[str]) -> bytes:
        """Return ``lines``, which replace the lines of this file, as bytes with the line ends and
        the encoding of this file.
        """
        text = "".join(line + end for line, end in zip(lines, self.ends, strict=True))
        return self.mark + text.encode(self.encoding, errors="replace")


def _lines_of(content: bytes, file: str, encoding: str | None = None) -> _Lines:
    """Return the lines of a text file. Raises InputError for a file that is not text."""
    read_any_lines(content, file, encoding)  # raises for faults
    mark, name = next(
        ((mark, name) for mark, name in _MARKS if content.startswith(mark)),
        (b"", encoding or encoding_of(content)),
    )
    pieces = re.split(r"(\r\n|\r|\n)", content[len(mark) :].decode(name).lstrip("\ufeff"))
    return _Lines(tuple(pieces[::2]), (*pieces[1::2], ""), name, mark)


def _proposed(content: bytes, file: str) -> tuple[Profile, bool]:
    """Return the proposed profile, and whether its sign is unknown. Raises InputError."""
    proposed = proposed_profile(content, file)
    sign_open = any(one.startswith("sign:") for one in proposed.open)
    lines = [
        f"sign: {SIGNS[0]}" if line.startswith("sign:") and sign_open else line
        for line in proposed.text.split("\n")
    ]
    try:
        text = encoded("\n".join(lines))
        return read_profile(text, f"the profile proposed for {file}"), sign_open
    except CompwrightError as error:
        raise InputError(
            Fault(
                message="the file is a table of another program, and the meaning of its "
                "columns is uncertain",
                file=file,
                expected="a mapping profile that states the columns",
                found="uncertain: "
                + ", ".join(dict.fromkeys(one.partition(":")[0] for one in proposed.open)),
                hint=f"describe its columns with {by_profile(file)}",
            )
        ) from error


def _of_workbook(content: bytes, file: str, cuts: Cuts, profile: Profile | None) -> Redacted:
    sheets, sign_open = sheets_of(content, file), False
    if profile is None and not any(is_plain_csv(sheet.lines) for sheet in sheets):
        profile, sign_open = _proposed(content, file)
    made: list[WorkbookSheet] = []
    read_by: Profile | None = None
    for sheet in sheets:
        found = at_its_header(sheet.lines, replace(profile, delimiter="\t")) if profile else None
        if found is not None and found.layout != "own" and has_columns(sheet.lines, found):
            lines, read_by = redacted_table(sheet.lines, found, cuts)
        elif is_plain_csv(sheet.lines):
            lines = redacted_lines(sheet.lines, PLAIN_CSV.spans_of, cuts)
        else:
            _left_out(sheet, cuts)
            continue
        made.append(WorkbookSheet(_title(sheet, cuts, made), lines))
    cuts.removed.extend(("part of the workbook", name) for name in other_parts(content))
    profile_text = "" if read_by is None else profile_lines(read_by, sign_open=sign_open)
    return Redacted(workbook_of(made), profile_text, profile)


def _left_out(sheet: WorkbookSheet, cuts: Cuts) -> None:
    cuts.remark(sheet.name, "sheet")
    for line in sheet.lines:
        for cell in line.split("\t"):
            cuts.remark(cell, "cell of a sheet")


def _title(sheet: WorkbookSheet, cuts: Cuts, before: Sequence[WorkbookSheet]) -> str:
    name = sheet.name
    title = name if is_axis(name) or is_keywords(name) else cuts.name(name, "sheet")
    taken = {one.name.casefold() for one in before}
    return title if title.casefold() not in taken else f"{title} {len(before) + 1}"
