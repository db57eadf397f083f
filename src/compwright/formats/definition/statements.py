"""Line templates of control files: one template serves to read a line and to write it.

A template (form) is literal text with ``{fields}``. When a line is read, a blank in the form
matches any number of blanks. Next to brackets, commas and ``=`` blanks are optional. Between words
and numbers at least one blank is needed. A line is written exactly in its form.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import NamedTuple

from compwright.formats.definition.schema import Definition, Dialect, Statement
from compwright.formats.definition.vocabulary import FieldType

_FIELD_PATTERNS: Mapping[FieldType, str] = {
    "integer": r"[0-9]{1,9}",
    "signed": r"[+-]?[0-9]{1,9}",
    "point_number": r"0{0,3}1[0-9]{4}",
    "bit": r"[01]",
    "key": r"[A-Za-z]",
    "decimal": r"[+-]?(?:[0-9]{1,15}(?:\.[0-9]{0,15})?|\.[0-9]{1,15})",
    "decimal_ex": r"[+-]?(?:[0-9]{1,15}(?:\.[0-9]{0,15})?|\.[0-9]{1,15})(?:EX[+-]?[0-9]{1,2})?",
    "real": r"[+-]?(?:[0-9]{1,15}(?:\.[0-9]{0,20})?|\.[0-9]{1,20})(?:[eE][+-]?[0-9]{1,2})?",
    "name": r"[A-Za-z_][A-Za-z0-9_]{0,62}",
    "label": r"[^\[\]\r\n]+",
    "word": r"[^ \t\r\n]+",
    "text": r"[^\r\n]*[^\r\n \t]",
    "truth": r"[+-]?(?:[0-9]{1,9}(?:\.[0-9]{0,9})?|\.[0-9]{1,9})(?:EX[+-]?[0-9]{1,2})?|TRUE|FALSE"
    r"|'H[0-9A-F]{1,8}'|'B[01]{1,32}'",
    "system_word": r"METRIC|INCH",
}
_REST = {"none": r"[ \t]*", "after_blank": r"(?:[ \t][^\r\n]*)?", "anything": r"[^\r\n]*"}
_PIECE = re.compile(
    r"\{(?P<field>[a-z_][a-z0-9_]*)\}|(?P<blank>"
    r" +)|#(?P<padded>[0-9]+)|(?P<word>[\w$%.]+)|(?P<mark>.)"
)
#: A form that ends in a group which stands once or several times: ``N#00007Q1(A{axis}P{value})*``.
_GROUPED = re.compile(r"(?P<before>.*)\((?P<group>[^()]*)\)\*")
_NAME = re.compile(r"[A-Za-z]*#0*([0-9]+)|[$\w.]+")
_LINE_NUMBER = re.compile(
    r"[ \t\r]*[A-Za-z][ \t]*0*([0-9]+)"
)  # a stray carriage return does not hide a line


# Named tuples where thousands are made for each file: five times as fast as records.
class Token(NamedTuple):
    """A piece of a file: its text, and its bytes from ``start`` up to, not including, ``end``."""

    text: str
    start: int
    end: int


class Occurrence(NamedTuple):
    """One line of a file that matches a statement, with the text of each field (``tokens``).

    ``line``: line number, from 1. ``tokens`` also contains the fields of the section header above
    the line. ``form``: index of the matching form: 0 for the form that is written, more for forms
    that are only read. ``checksum``: the checksum of the line, with the blanks before it.
    """

    statement: str
    file: str
    line: int
    tokens: Mapping[str, Token]
    form: int = 0
    checksum: Token | None = None

    @property
    def variant(self) -> bool:
        """Whether the line has a form that compwright reads but never writes."""
        return self.form > 0

    @property
    def place(self) -> str:
        """The line number as text for messages, such as "line 12"."""
        return f"line {self.line}"


@dataclass(frozen=True, slots=True)
class StatementForm:
    """A line template compiled to a pattern; ``group``: the pattern of the part that may occur
    several times on one line.
    """

    pattern: re.Pattern[str]
    group: re.Pattern[str] | None = None

    def fullmatch(self, text: str) -> re.Match[str] | None:
        """Return the match of the template with the whole line; None if it does not fit."""
        return self.pattern.fullmatch(text)


@dataclass(frozen=True, slots=True)
class Matcher:
    """The compiled templates of a statement: first the template for writing, then the templates
    that are only read.

    ``section``: pattern of the section's name. ``number``: the number with which such a line begins
    (``N00007``), without leading zeros; None if the template has none.
    """

    statement: Statement
    forms: tuple[StatementForm, ...]
    section: re.Pattern[str] | None
    head: str
    number: str | None = None

    def match(self, text: str) -> tuple[int, re.Match[str]] | None:
        """Return the index of the template that fits the whole line, and the match; None if none
        fits.
        """
        found = ((place, form.fullmatch(text)) for place, form in enumerate(self.forms))
        return next(((place, match) for place, match in found if match is not None), None)


def line_number(text: str) -> str | None:
    """Return the number in a line's first word, such as ``7`` of ``N00007Q1``; None if it has no
    number.
    """
    match = _LINE_NUMBER.match(text)
    return match[1] if match else None


def readable(form: str) -> str:
    """Return a line template as shown to people: ``KEY[<axis>]=<value>``."""
    return form.replace("{", "<").replace("}", ">")


def name_in_form(form: str) -> str:
    """Return the parameter's name in a line template.

    Examples: ``$BACKLASH`` is such a name; the name in ``N#00007Q1(A{axis}P{value})*`` is ``7``.
    """
    match = _NAME.match(form)
    return "" if match is None else match[1] or match[0]


def field_names(form: str) -> tuple[str, ...]:
    """Return the field names of a template in their order."""
    return tuple(piece["field"] for piece in _PIECE.finditer(form) if piece["field"])


def print_form(form: str, values: Mapping[str, str]) -> str:
    """Return a line template with its fields filled in. Raises KeyError if a value is missing.

    A group that may repeat on the line is printed once.
    """
    return "".join(
        values[piece["field"]] if piece["field"] else piece["padded"] or piece[0]
        for piece in _PIECE.finditer(_once(form))
    )


def _once(form: str) -> str:
    """Return a line template in which the part that may repeat on the line appears once."""
    grouped = _GROUPED.fullmatch(form)
    return f"{grouped['before']}{grouped['group']}" if grouped else form


def field_matches(kind: FieldType, text: str) -> bool:
    """Return whether ``text`` is valid in a field of this type."""
    return re.fullmatch(_FIELD_PATTERNS[kind], text) is not None


def plain_number(kind: FieldType, text: str) -> str:
    """Return the text of a field as a plain decimal number, such as ``0.015`` for ``1.5EX-2``.

    TRUE is 1 and FALSE is 0. ``'H1'`` is a number of base 16, ``'B1'`` of base 2.
    """
    if kind == "truth" and text[0] not in "+-.0123456789":
        word = text.upper()
        if word in ("TRUE", "FALSE"):
            return str(int(word == "TRUE"))
        return str(int(word[2:-1], 16 if word[1] == "H" else 2))
    if kind not in ("decimal_ex", "truth") or "EX" not in text.upper():
        return text
    return format(Decimal(text.upper().replace("EX", "E")), "f")


def compile_statement(statement: Statement, definition: Definition) -> Matcher:
    """Return the compiled line templates of one statement, by which its lines in a file are
    recognised and split into fields.
    """
    dialect = definition.dialect
    flags = re.IGNORECASE if dialect.case == "ignored" else re.RegexFlag(0)
    forms = tuple(
        _compiled(form, statement, dialect, flags | re.ASCII)
        for form in (statement.form, *statement.also_read)
    )
    section = None
    if statement.within is not None:
        kinds: dict[str, FieldType] = dict.fromkeys(
            field_names(statement.within), definition.addresses.type
        )
        section = re.compile(_form_pattern(statement.within, kinds, dialect), flags | re.ASCII)
    pieces = list(_PIECE.finditer(_once(statement.form)))
    literal = "" if not pieces or pieces[0]["field"] else pieces[0][0]
    padded = pieces[1]["padded"] if len(pieces) > 1 else None
    return Matcher(
        statement,
        forms,
        section,
        literal.upper() if dialect.case == "ignored" else literal,
        padded.lstrip("0") if padded else None,
    )


def _compiled(
    form: str, statement: Statement, dialect: Dialect, flags: re.RegexFlag | int
) -> StatementForm:
    grouped = _GROUPED.fullmatch(form)
    if grouped is None:
        return StatementForm(
            re.compile(
                _line_pattern(_form_pattern(form, statement.fields, dialect), statement, dialect),
                flags,
            )
        )
    before = _form_pattern(grouped["before"], statement.fields, dialect)
    group = _form_pattern(grouped["group"], statement.fields, dialect)
    gap = r"[ \t]*"
    # Bare numbers (``({value})*``) need something between them, or one could be read as two.
    between = r"[ \t]+" if re.fullmatch(r"\{[^{}]*\}", grouped["group"]) else gap
    unnamed = re.sub(r"\?P<[a-z_0-9]+>", "?:", group)
    line = f"{before}{gap}(?P<groups_>{unnamed}(?:{between}{unnamed})*)"
    return StatementForm(
        re.compile(_line_pattern(line, statement, dialect), flags), re.compile(group, flags)
    )


def _line_pattern(pattern: str, statement: Statement, dialect: Dialect) -> str:
    before = (
        ""
        if dialect.block_number is None
        else f"(?:{re.escape(dialect.block_number)}[0-9]+[ \\t]+)?"
    )
    after = (
        ""
        if dialect.line_checksum is None
        else f"(?P<checksum_>[ \\t]+{re.escape(dialect.line_checksum)}[0-9A-Fa-f]{{4}})?"
    )
    return f"[ \\t]*{before}{pattern}{after}{_REST[statement.rest]}"


def _form_pattern(form: str, kinds: Mapping[str, FieldType], dialect: Dialect) -> str:
    pattern = ""
    previous = ""  # "" at the start, "word" for a word or a field, "mark" for punctuation
    label: FieldType | None = None  # a label holds its own blanks: [ TRAJ] is not [TRAJ]
    blank = False
    for piece in _PIECE.finditer(form):
        if piece["blank"]:
            blank = True
            continue
        kind = "mark" if piece["mark"] else "word"
        if previous:
            gap = (
                (r"[ \t]+" if blank else "")
                if previous == kind == "word" and not dialect.blanks_anywhere
                else r"[ \t]*"
            )
            pattern += "" if "label" in (label, kinds.get(piece["field"] or "")) else gap
        field = piece["field"]
        label = kinds.get(field or "")
        if field:
            pattern += f"(?P<{field}>{_FIELD_PATTERNS[kinds[field]]})"
        else:
            pattern += (
                f"0*{piece['padded'].lstrip('0')}" if piece["padded"] else re.escape(piece[0])
            )
        previous, blank = kind, False
    return pattern
