"""Read the bytes of a control's file as statements, with the byte position of each value.

One byte is read as one character. So comments in any 8-bit character set stay as they are, and
positions in the text are byte positions in the file. A line that looks like a known statement but
cannot be read is a fault. If the definition says so, every line that cannot be read is a fault.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import NamedTuple

from compwright.formats.definition.schema import Definition, TextKind
from compwright.formats.definition.statements import (
    Matcher,
    Occurrence,
    Token,
    compile_statement,
    line_number,
    plain_number,
    readable,
)
from compwright.foundations.errors import Fault
from compwright.foundations.findings import Finding
from compwright.records.correction import ControlFile

#: Bytes that no text holds.
BINARY = re.compile(rb"[\x00-\x08\x0b\x0e-\x19\x1b-\x1f]")
_HEAD = 512  # bytes that show in which encoding a file was saved
#: The mark of a comment that has an end, unlike all others.
OPEN = "("
_ENCLOSED = re.compile(r"\([^()]*\)")
#: Text between a comment mark and a statement that has to be typed in at the control: the statement
#: counts.
BY_HAND = " by hand: "
#: Text between a comment mark and a statement that the control already holds: the statement counts,
#: and the control does not enter it again.
AS_IT_IS = " as it is: "
#: What the value of a statement may be, by the type of the field.
_VALUES = {"integer": " (a whole number, not negative)", "bit": " (0 or 1)"}
_UTF8_MARK = "\xef\xbb\xbf"  # the byte order mark, seen as single bytes
#: What was read is kept by content: a run reads each text once, of more files than a control has.
KEPT_TEXTS, KEPT_READERS = 256, 16


class TextLine(NamedTuple):
    """One line without its line end.

    ``start``: the byte at which it begins. ``ended``: whether a line end follows.
    """

    number: int
    text: str
    start: int
    ended: bool


@dataclass(frozen=True, slots=True)
class ReadText:
    """The statements of one file.

    ``number``: the index of the file among the given files. ``sections``: the names of all sections
    in it.
    """

    number: int
    file: str
    kind: str
    occurrences: tuple[Occurrence, ...]
    sections: tuple[str, ...]
    findings: tuple[Finding, ...]


def no_text(content: bytes) -> str:
    """Return for a file that is no text of a control what it is instead: two bytes per character,
    or binary.

    Two signs show two bytes per character: such a byte order mark, or a 0 in every second byte of
    the file's beginning.
    """
    head = content[:_HEAD]
    halves = head[::2], head[1::2]
    plain = any(
        not any(high) and low and not BINARY.search(low) for high, low in (halves, halves[::-1])
    )
    if plain or head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return (
            "the file is not a text file of one byte a character, but saved as UTF-16 (Unicode):"
            " give it as the control wrote it, or save it as ANSI (Notepad: Save As, Encoding)"
        )
    return "the file is not a text file (a binary archive?)"


@lru_cache(maxsize=KEPT_READERS)
def text_reader(definition: Definition) -> TextReader:
    """Return the reader of files by a definition, which is compiled once and then cached."""
    return TextReader(definition)


class TextReader:
    """Reads files by one definition; get it from `text_reader`, which caches it."""

    def __init__(self, definition: Definition) -> None:
        self.definition = definition
        self.matchers = {
            name: compile_statement(statement, definition)
            for name, statement in definition.statements.items()
        }
        ends = "|".join(
            re.escape(end)
            for end in sorted(definition.dialect.newlines_read, key=len, reverse=True)
        )
        self.newline = re.compile(ends)
        self.concerning = {kind.name: self._concerning(kind) for kind in definition.texts.values()}

    def of(self, kind: TextKind) -> list[Matcher]:
        """Return the compiled statements for one kind of file, without the statement for section
        headers.
        """
        return [
            m
            for m in self.matchers.values()
            if m.statement.text == kind.name and m.statement.name != kind.sections
        ]

    def _concerning(self, kind: TextKind) -> re.Pattern[str] | None:
        """Return a pattern of words, of which every relevant line contains at least one; None if
        every line has to be read.

        Every line that is a statement of this kind of text, or looks like one, contains one of the
        words. The pattern serves to skip lines quickly: in an archive only one line of a thousand
        is relevant.
        """
        matchers = self.of(kind)
        if kind.other_lines_refused or any(matcher.number is not None for matcher in matchers):
            return None
        heads = (matcher.head for matcher in matchers if matcher.head)
        words = {*heads, *kind.claims_anywhere, *kind.claims_at_start}
        flags = re.IGNORECASE if self.definition.dialect.case == "ignored" else re.NOFLAG
        return re.compile("|".join(map(re.escape, sorted(words))) or "(?!)", flags)

    def read(self, file: ControlFile, faults: list[Fault], number: int = 0) -> ReadText | None:
        """Return the statements of a file; None if it cannot be read (the reasons are added to
        ``faults``). ``number``: the index of the file among all files, stored in the result.
        """
        text, found = _read(self, file)
        faults.extend(found)
        return None if text is None else replace(text, number=number)

    def parse(self, file: ControlFile, faults: list[Fault]) -> ReadText | None:
        """Return the statements of a file, without the cache of `read`."""
        if BINARY.search(file.content):
            faults.append(
                Fault(
                    message=no_text(file.content),
                    file=file.name,
                    expected=(
                        "text as the control exports it, in ASCII or another 8-bit character set"
                    ),
                    hint="export the file from the control as text",
                )
            )
            return None
        lines = self.lines(file.content.decode("latin-1"))
        return _KindReader(self, self._kind(lines), file.name, faults).read(lines)

    def lines(self, text: str) -> list[TextLine]:
        """Return the lines of a text, including a last line without a line end if that line is not
        empty.
        """
        result: list[TextLine] = []
        start = 0
        for match in self.newline.finditer(text):
            result.append(TextLine(len(result) + 1, text[start : match.start()], start, ended=True))
            start = match.end()
        if start < len(text):
            result.append(
                TextLine(len(result) + 1, text[start:].removesuffix("\x1a"), start, ended=False)
            )
        return result

    def _kind(self, lines: Sequence[TextLine]) -> TextKind:
        kinds = self.definition.texts.values()
        for kind in kinds:
            if kind.recognised_by is not None:
                matcher = self.matchers[kind.recognised_by]
                if any(matcher.forms[0].fullmatch(line.text) for line in lines):
                    return kind
        return next(kind for kind in kinds if kind.recognised_by is None)


@lru_cache(maxsize=KEPT_TEXTS)
def _read(reader: TextReader, file: ControlFile) -> tuple[ReadText | None, tuple[Fault, ...]]:
    faults: list[Fault] = []
    return reader.parse(file, faults), tuple(faults)


class _KindReader:
    """Reads the lines of one file by the rules for one kind of file."""

    def __init__(self, reader: TextReader, kind: TextKind, file: str, faults: list[Fault]) -> None:
        self.kind = kind
        self.file = file
        self.faults = faults
        self.ignores_case = reader.definition.dialect.case == "ignored"
        self.matchers = reader.of(kind)
        self.sections = reader.matchers.get(kind.sections) if kind.sections is not None else None
        self.numbered = any(matcher.number is not None for matcher in self.matchers)
        self.wordless = [matcher for matcher in self.matchers if not matcher.head]
        self.concerning = reader.concerning[kind.name]
        self.max_line = (
            reader.definition.limit_number("line_length_read") if kind.other_lines_refused else None
        )
        self.section = ""
        self.section_start = 0
        self.seen_sections: list[str] = []

    def _passed_over(self, code: str) -> bool:
        """Return whether a line is skipped because it has nothing to do with compensation."""
        if self.concerning is None or self.concerning.search(code) is not None:
            return False
        return all(matcher.match(code) is None for matcher in self.wordless)

    def read(self, lines: Sequence[TextLine]) -> ReadText:
        occurrences: list[Occurrence] = []
        last = max((line.number for line in lines if line.text.strip(" \t")), default=0)
        for line in lines:
            code = self._code(line)
            if not code.strip(" \t"):
                if (
                    line.number < last
                    and self.kind.other_lines_refused
                    and not self.kind.blank_lines_anywhere
                ):
                    self._refuse(line, "a blank line in the middle of the rows")
                continue
            if self.max_line is not None and len(line.text) > self.max_line:
                self._refuse(
                    line,
                    f"a line of {len(line.text)} characters",
                    expected=f"at most {self.max_line} characters",
                )
            elif not self._open_section(line, code):
                occurrences.extend(self._statement(line, code))
        return ReadText(
            0,
            self.file,
            self.kind.name,
            tuple(occurrences),
            tuple(self.seen_sections),
            tuple(self._ending(lines, last, occurrences)),
        )

    def _code(self, line: TextLine) -> str:
        """Return a line without its comment, each character at its old position."""
        mark = mark_before_statement(self.kind, line.text)
        if mark:
            return line.text.replace(mark, " " * len(mark), 1)
        if self.kind.comments_anywhere and self.kind.comment_marks == (OPEN,):
            return _ENCLOSED.sub(lambda comment: " " * len(comment[0]), line.text)
        return line.text[: comment_start(self.kind, line.text)]

    def _open_section(self, line: TextLine, code: str) -> bool:
        match = self.sections.forms[0].fullmatch(code) if self.sections is not None else None
        if match is None:
            return False
        self.section = match["section"]
        self.section_start = line.start + match.start("section")
        if self.section in self.seen_sections and any(
            m.section and m.section.fullmatch(self.section) for m in self.matchers
        ):
            self._fault(
                line,
                f"the section [{self.section}] is given a second time; the control reads only"
                " the first",
            )
        self.seen_sections.append(self.section)
        return True

    def _statement(self, line: TextLine, code: str) -> Iterator[Occurrence]:
        if self._passed_over(code):
            return
        if (
            self.numbered
            and "\r" in code
            and any(self._ours(piece) for piece in code.split("\r")[1:])
        ):
            self._unread(line, code, "a line end of the control")
            return
        probe = code.upper() if self.ignores_case else code
        number = line_number(code) if self.numbered else None
        elsewhere = False
        for matcher in self.matchers:
            if matcher.head not in probe or (
                matcher.number is not None and matcher.number != number
            ):
                continue
            found = matcher.match(code)
            if found is not None and self._here(matcher):
                yield from self._occurrences(line, matcher, *found)
                return
            elsewhere = elsewhere or found is not None
            if found is None and matcher.number in self.kind.claims_at_start:
                self._unread(line, code, readable(matcher.statement.form))
                return
        if elsewhere:  # a statement of another section
            return
        claimed = self._claimed(probe) if self._concerns_us(probe) else None
        if claimed is not None:
            self._unread(line, code, _nearest(self.matchers, probe) or claimed)
        elif self.kind.other_lines_refused:
            self._refuse(line, "cannot be read as a row" + _hint(code))

    def _unread(self, line: TextLine, code: str, expected: str) -> None:
        self._fault(line, "cannot be read" + _hint(code), expected=expected, found=_shown(code))

    def _here(self, matcher: Matcher) -> bool:
        """Return whether a statement is valid in the current section of the file."""
        return matcher.section is None or matcher.section.fullmatch(self.section) is not None

    def _ours(self, piece: str) -> bool:
        """Return whether a piece of a line could be a statement on a line of its own."""
        return line_number(piece) in self.kind.claims_at_start or any(
            form.fullmatch(piece) for matcher in self.matchers for form in matcher.forms
        )

    def _occurrences(
        self, line: TextLine, matcher: Matcher, place: int, match: re.Match[str]
    ) -> Iterator[Occurrence]:
        repeating = matcher.forms[place].group
        if repeating is None:
            yield from self._occurrence(line, matcher, place, (match,))
            return
        for group in repeating.finditer(match.string, match.start("groups_"), match.end("groups_")):
            yield from self._occurrence(line, matcher, place, (match, group))

    def _occurrence(
        self, line: TextLine, matcher: Matcher, place: int, matches: tuple[re.Match[str], ...]
    ) -> Iterator[Occurrence]:
        kinds = matcher.statement.fields

        def token(name: str) -> Token:
            match = next(found for found in matches if name in found.re.groupindex)
            text = plain_number(kinds.get(name, "text"), match[name])
            return Token(text, line.start + match.start(name), line.start + match.end(name))

        tokens = {name: token(name) for name in kinds}
        within = matcher.section.fullmatch(self.section) if matcher.section is not None else None
        if within is not None:
            for name in within.re.groupindex:
                start = self.section_start + within.start(name)
                tokens[name] = Token(within[name], start, start + len(within[name]))
        checksum = token("checksum_") if matches[0].groupdict().get("checksum_") else None
        yield Occurrence(matcher.statement.name, self.file, line.number, tokens, place, checksum)

    def _concerns_us(self, probe: str) -> bool:
        """Return False if a line resembles statements, but only such of other sections of the file;
        True for all other lines.

        A key of the same name in another section has another meaning.
        """
        similar = [matcher for matcher in self.matchers if matcher.head and matcher.head in probe]
        return not similar or any(self._here(matcher) for matcher in similar)

    def _claimed(self, probe: str) -> str | None:
        for claim in self.kind.claims_anywhere:
            if (claim.upper() if self.ignores_case else claim) in probe:
                return claim
        start = probe.lstrip(" \t")
        return next((claim for claim in self.kind.claims_at_start if start.startswith(claim)), None)

    def _ending(
        self, lines: Sequence[TextLine], last: int, occurrences: Sequence[Occurrence]
    ) -> Iterator[Finding]:
        """Check the end of a file for signs that the file was cut short.

        A missing end mark is a finding, because the file may have been cut short. If such a text
        ends with a statement without a line end, that is a fault, because its number may be
        incomplete.
        """
        final = lines[last - 1] if last else None
        marked = final is not None and self._code(final).strip(" \t").upper() in self.kind.ends_with
        if final is None or not (occurrences and self.kind.ends_with):
            if final is not None and not final.ended:
                yield Finding.of("CW-S001", "warning", file=self.file)
            return
        # Checked first: an archive of several programs holds end marks before its last line.
        if not final.ended and occurrences[-1].line == final.number:
            self._fault(
                final,
                "the file ends inside this line, it may have been cut short",
                expected=f"a line end, then {self.kind.ends_with[0]}",
            )
            return
        # Where one mark both opens and closes a file, the first line is no end; behind an end that
        # was cut away nothing is sure.
        if (final.ended or marked) and any(
            self._code(line).strip(" \t").upper() in self.kind.ends_with for line in lines[1:][-20:]
        ):
            return
        yield Finding.of("CW-S002", "warning", file=self.file, mark=self.kind.ends_with[0])

    def _refuse(self, line: TextLine, message: str, expected: str = "") -> None:
        rows = " or ".join(readable(matcher.statement.form) for matcher in self.matchers)
        self._fault(
            line,
            f"{message}; {self.kind.because}",
            expected=expected or rows,
            found=_shown(line.text),
        )

    def _fault(self, line: TextLine, message: str, *, expected: str = "", found: str = "") -> None:
        self.faults.append(
            Fault(
                message=message,
                file=self.file,
                place=f"line {line.number}",
                expected=expected,
                found=found,
                hint=(
                    "correct this line in a copy of the file, or export it from the control again"
                ),
            )
        )


def mark_before_statement(kind: TextKind, text: str) -> str:
    """Return the comment mark of a line whose comment contains a statement; empty for all other
    lines.
    """
    marks = (mark + word for mark in kind.comment_marks for word in (BY_HAND, AS_IT_IS))
    return next((mark for mark in marks if text.startswith(mark)), "")


def comment_start(kind: TextKind, text: str) -> int:
    """Return the position at which a line's comment begins; its length if it has no comment."""
    if not kind.comments_anywhere:
        code = text.lstrip(" \t")
        return len(text) - len(code) if code.startswith(kind.comment_marks) else len(text)
    places = (place for mark in kind.comment_marks if (place := text.find(mark)) >= 0)
    return min(places, default=len(text))


def _nearest(matchers: Sequence[Matcher], probe: str) -> str:
    """Return the form of the statement that a faulty line probably means, for a message; empty if
    none fits.
    """
    fitting = [matcher for matcher in matchers if matcher.head and matcher.head in probe]
    if not fitting:
        return ""
    statement = max(fitting, key=lambda matcher: len(matcher.head)).statement
    kind = statement.fields.get("value", "")
    return readable(statement.form) + _VALUES.get(kind, "")


def _shown(text: str) -> str:
    """Return a piece of a line without characters that are unsafe to print."""
    shown = text.strip(" \t\r")[:60]
    return repr(shown) if shown else "an empty line"


def _hint(code: str) -> str:
    if code.startswith(_UTF8_MARK):
        return " (the file begins with a byte order mark)"
    if "\r" in code:
        return " (a bare carriage return inside the line)"
    if re.search(r"=\s*n/a\s*$", code, re.IGNORECASE):
        return ": the listing does not know it; add a file of the control that says it"
    if re.search(r"[0-9],[0-9]+\s*$", code):
        return " (a decimal comma?)"
    return ""
