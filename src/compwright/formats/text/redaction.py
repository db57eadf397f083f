"""Copy a control's text without private data: numbers and keywords stay, names are removed.

Statements of the definition keep their numbers. Other lines stay if they contain only numbers and
keywords.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final

from compwright.formats.definition.schema import Definition, TextKind
from compwright.formats.definition.shape_rules import AXIS, KeptLines
from compwright.formats.definition.statements import Occurrence, Token
from compwright.formats.text.texts import (
    OPEN,
    ReadText,
    TextLine,
    TextReader,
    comment_start,
    mark_before_statement,
)
from compwright.foundations.redaction import LINE, Cuts
from compwright.records.correction import ControlFile

#: Types of fields that hold texts of somebody's choice.
_TEXTS: Final = frozenset({"name", "label", "word", "text"})
_HARMLESS: Final = re.compile(
    rf"{AXIS}"
    r"|NO_AXIS|[%$]?[+-]?[0-9][0-9.,]*|\$[0-9A-Fa-f]+|'[HB][0-9A-Fa-f]+'"
    r"|mm|inch|in|um|deg|degree|arcsec|metric|mm/m|LINEAR|ANGULAR|error|correction"
    r"|[a-z]*kins(?:\s+coordinates=[A-Za-z]+)?(?:\s+kinstype=[A-Za-z0-9]+)?"
    r"|(?:JOINT|SPINDLE)_[0-9]+|AXIS_[A-Z]|TRAJ|KINS|FALSE|TRUE|CONFIG",
    re.IGNORECASE,
)
#: A name in a line that names tables or axes.
_NAME: Final = re.compile(r"(?!(?:END|COM|CMA)\b)[^\s.]*[A-Za-z][^\s.]*", re.IGNORECASE)
_QUOTED: Final = re.compile(r'"([^"\r\n]*)"')
_ADDRESS: Final = re.compile(r"\$[A-Za-z]{1,4}_[A-Za-z0-9_]+|^[A-Za-z_][A-Za-z0-9_]*(?=\s*[\[=])")
#: Blanks, but for those that keep two numbers apart.
_BETWEEN: Final = re.compile(r"(?<![0-9.])[ \t]+|[ \t]+(?![0-9.])")
_BEHIND: Final = re.compile(r"[\s)\]\"';,]*(?:'[0-9A-F]{4})?\s*", re.IGNORECASE)
_LETTERS: Final = re.compile(r"[A-Za-z0-9]{4,}")


@dataclass(slots=True)
class RedactedText:
    """A copy of a text without private data.

    ``renamed``: the new name of each old name. ``words``: the keywords of the text, in lower case.
    """

    file: ControlFile
    renamed: dict[str, str] = field(default_factory=dict)
    words: set[str] = field(default_factory=set)


class TextRedactor:
    """Copies a control's text without private data, and without the folders in file names.

    ``read``: the statements in the text. ``kept``: which other lines may stay.
    """

    def __init__(
        self,
        reader: TextReader,
        file: ControlFile,
        read: ReadText,
        kept: KeptLines,
        cuts: Cuts,
    ) -> None:
        self.reader, self.file, self.kept, self.cuts = reader, file, kept, cuts
        self.kind: TextKind = reader.definition.texts[read.kind]
        self.mark = next(iter(self.kind.comment_marks), "")
        self.by_line: dict[int, list[Occurrence]] = defaultdict(list)
        for one in read.occurrences:
            self.by_line[one.line].append(one)
        self.result = RedactedText(file)

    def copy(self) -> RedactedText:
        """Return the redacted copy, the new names that replace private ones, and the keywords of
        the text, which stay.
        """
        text = self.file.content.decode("latin-1")
        made, end = [], 0
        for line in self.reader.lines(text):
            made += [text[end : line.start], self._line(line)]
            end = line.start + len(line.text)
        made.append(text[end:])
        content = "".join(made).encode("latin-1", errors="replace")
        self.result.file = ControlFile(self.file.name, content)
        return self.result

    def _line(self, line: TextLine) -> str:
        statements = self.by_line.get(line.number)
        marked = statements and mark_before_statement(self.kind, line.text)
        end = len(line.text) if marked else comment_start(self.kind, line.text)
        code = line.text[:end]
        if statements:
            code = self._statement(line, code, statements)
        elif code.strip():
            code = self._other(code)
        return code + self._remark(line.text[end:])

    def _remark(self, text: str) -> str:
        """Return a comment without its text: the comment mark and a neutral text."""
        mark = next((mark for mark in self.kind.comment_marks if text.startswith(mark)), "")
        if mark != OPEN:
            return f"{mark} {self.cuts.remark(text[len(mark) :])}".rstrip() if mark else ""
        inside, _, behind = text[1:].partition(")")
        if behind.strip():
            inside, behind = text[1:], ""
        return f"({self.cuts.remark(inside)}){behind}"

    def _statement(self, line: TextLine, code: str, statements: Sequence[Occurrence]) -> str:
        """Return a line that contains statements, with its private names replaced."""
        tokens = sorted(self._tokens(line, code, statements), key=lambda one: one[0].start)
        made, end = [], 0
        for token, kind in tokens:
            start = token.start - line.start
            if start < end:
                continue
            stop = token.end - line.start
            made += [self._literal(code[end:start]), self._token(code[start:stop], kind)]
            end = stop
        behind = code[end:]
        if _BEHIND.fullmatch(behind) is None:
            gap = behind[: len(behind) - len(behind.lstrip())]
            behind = gap + self.cuts.remark(behind, "text behind a value")
        return "".join(made) + behind

    def _tokens(
        self, line: TextLine, code: str, statements: Sequence[Occurrence]
    ) -> Iterator[tuple[Token, str]]:
        end = line.start + len(code)
        for one in statements:
            kinds = self.reader.definition.statements[one.statement].fields
            for name, token in one.tokens.items():
                if line.start <= token.start and token.end <= end:
                    yield token, kinds.get(name, "name")

    def _literal(self, text: str) -> str:
        self.result.words.update(word.lower() for word in _LETTERS.findall(text))
        return text

    def _token(self, text: str, kind: str) -> str:
        if kind not in _TEXTS or _HARMLESS.fullmatch(text):
            return self._literal(text)
        folder, stem, ending = _path(text)
        if folder:
            self.cuts.remark(folder, "path")
        if (stem and _HARMLESS.fullmatch(stem)) or re.fullmatch(
            r"(?:joint|axis)_?[0-9A-Za-z]", stem
        ):
            new = self._literal(stem + ending)
        else:
            new = self.cuts.name(stem) + ending
        if kind == "label":
            new = new.upper()
        self.result.renamed[text] = new
        return new

    def _other(self, code: str) -> str:
        """Return the redacted form of a line that contains no known statement: unchanged, with
        names replaced, or without its text.
        """
        bare = code.strip()
        if self._stays(bare):
            return self._literal(code)
        if self.kept.holds_names(bare):
            return _NAME.sub(lambda found: self._token(found[0], "name"), code)
        sections = self.reader.matchers.get(self.kind.sections or "")
        section = None if sections is None else sections.forms[0].fullmatch(bare)
        if section is not None and section.end("section") == len(bare) - 1:
            return f"[{self.cuts.name(section['section'], 'section').upper()}]"
        if '"' in bare:
            empty = _QUOTED.sub('""', code)
            if self._stays(empty.strip()):
                self._literal(empty)
                return _QUOTED.sub(self._quoted, code)
        for address in _ADDRESS.findall(bare):  # its words occur in other addresses too
            self._literal(address)
        remark = self.cuts.remark(bare, LINE)
        return f"({remark})" if self.mark == OPEN else f"{self.mark} {remark}".strip()

    def _stays(self, bare: str) -> bool:
        anywhere = self.reader.definition.dialect.blanks_anywhere
        return (anywhere and self.kept.stays(_BETWEEN.sub("", bare))) or self.kept.stays(bare)

    def _quoted(self, found: re.Match[str]) -> str:
        text = found[1]
        if not text or _HARMLESS.fullmatch(text):
            return found[0]
        return f'"{self.cuts.name(text)}"'


def _path(text: str) -> tuple[str, str, str]:
    """Return folder, name and file ending of a text, which can be a file name."""
    place = max(text.rfind("/"), text.rfind("\\")) + 1
    match = re.fullmatch(r"(?P<stem>.*?)(?P<ending>\.[A-Za-z0-9]{1,4})?", text[place:])
    assert match is not None  # noqa: S101 - every text has this form
    return text[:place], match["stem"], match["ending"] or ""


def same_statements(old: ReadText, new: ReadText, renamed: dict[str, str]) -> bool:
    """Return whether two texts have the same statements in the same order, once the names in the
    old text are replaced by ``renamed``.
    """
    return _comparable(old, renamed) == _comparable(new, {})


def _comparable(text: ReadText, renamed: dict[str, str]) -> list[tuple[object, ...]]:
    return [
        (
            one.statement,
            one.line,
            one.form,
            tuple(
                (name, renamed.get(token.text, token.text)) for name, token in one.tokens.items()
            ),
        )
        for one in text.occurrences
    ]


def definition_words(definition: Definition) -> frozenset[str]:
    """Return the words of the statements in a definition, in lower case."""
    forms = (
        form
        for statement in definition.statements.values()
        for form in (statement.form, *statement.also_read)
    )
    return frozenset(word.lower() for form in forms for word in _LETTERS.findall(form))


_SHEET_KEY: Final = re.compile(
    r"#\s*(?:axis|address|value|points|kind|unit|table|meaning):\s*(?P<value>.*?)\s*", re.IGNORECASE
)
_SHEET_CELL: Final = re.compile(
    r"\s*(?:[+-]?[0-9.]+|MP[0-9.]+|\$?[A-Z]{2}_[A-Z_0-9]+|backLash|linearCompValue|point|position"
    r"|value|unit|mm|um|deg|arcsec|inch|mm/m)?\s*",
    re.IGNORECASE,
)


def redacted_sheet(content: bytes, cuts: Cuts) -> bytes:
    """Return an entry sheet without private data, as UTF-8 text. ``cuts``: the record of the texts
    that are removed.
    """
    lines = re.split(r"(\r\n|\r|\n)", content.decode("utf-8"))
    return "".join(
        line if place % 2 else _sheet_line(line, cuts) for place, line in enumerate(lines)
    ).encode()


def _sheet_line(line: str, cuts: Cuts) -> str:
    bare = line.lstrip("\ufeff")
    if bare.lstrip().startswith("#"):
        match = _SHEET_KEY.fullmatch(bare.strip())
        if match is not None and _HARMLESS.fullmatch(match["value"]):
            return line
        return f"# {cuts.remark(bare.strip().lstrip('#'))}".rstrip()
    return ",".join(
        cell if _SHEET_CELL.fullmatch(cell) else cuts.remark(cell, "cell")
        for cell in line.split(",")
    )
