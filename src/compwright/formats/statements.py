"""Line templates: one form gives a tolerant reader and a strict printer, every token with its place in the file.

A form is literal text with ``{fields}``. A blank in it stands for blanks; beside brackets, commas and ``=`` blanks are tolerated
anyway, between words and numbers at least one is needed. Printing writes the form as it stands.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from compwright.formats.schema import Definition, Dialect, FieldType, Statement

_FIELD_PATTERNS: Mapping[FieldType, str] = {
    "integer": r"[0-9]{1,9}",
    "decimal": r"[+-]?(?:[0-9]{1,15}(?:\.[0-9]{0,15})?|\.[0-9]{1,15})",
    "real": r"[+-]?(?:[0-9]{1,15}(?:\.[0-9]{0,20})?|\.[0-9]{1,20})(?:[eE][+-]?[0-9]{1,2})?",
    "name": r"[A-Za-z_][A-Za-z0-9_]{0,62}",
    "label": r"[^\[\]\r\n]+",
    "word": r"[^ \t\r\n]+",
    "text": r"[^\r\n]*[^\r\n \t]",
}
_REST = {"none": r"[ \t]*", "after_blank": r"(?:[ \t][^\r\n]*)?", "anything": r"[^\r\n]*"}
_PIECE = re.compile(r"\{(?P<field>[a-z_][a-z0-9_]*)\}|(?P<blank> +)|(?P<word>[\w$%.]+)|(?P<mark>.)")


@dataclass(frozen=True, slots=True)
class Token:
    """A piece of a file: its text and its place in bytes, ``start`` counted from 0 and ``end`` behind it."""

    text: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A statement as it stands in a file. ``tokens`` by field name, those of the section too; ``line`` counts from 1.

    ``variant``: in one of the forms that are read but never written. ``checksum``: a line checksum with the blanks before it.
    """

    statement: str
    file: str
    line: int
    tokens: Mapping[str, Token]
    variant: bool = False
    checksum: Token | None = None

    @property
    def place(self) -> str:
        """The line, for messages."""
        return f"line {self.line}"


@dataclass(frozen=True, slots=True)
class Matcher:
    """A compiled statement: its own form first, then the forms that are only read; ``section`` matches the section's name."""

    statement: Statement
    forms: tuple[re.Pattern[str], ...]
    section: re.Pattern[str] | None
    head: str


def field_names(form: str) -> tuple[str, ...]:
    """Return the names of the fields of a form in their order."""
    return tuple(piece["field"] for piece in _PIECE.finditer(form) if piece["field"])


def print_form(form: str, values: Mapping[str, str]) -> str:
    """Return a form with its fields filled in. Raises KeyError for a field without a value."""
    return "".join(values[piece["field"]] if piece["field"] else piece[0] for piece in _PIECE.finditer(form))


def field_matches(kind: FieldType, text: str) -> bool:
    """Return whether ``text`` can stand in a field of this type."""
    return re.fullmatch(_FIELD_PATTERNS[kind], text) is not None


def compile_statement(statement: Statement, definition: Definition) -> Matcher:
    """Return the compiled reader of one statement."""
    dialect = definition.dialect
    flags = re.IGNORECASE if dialect.case == "ignored" else re.RegexFlag(0)
    forms = tuple(
        re.compile(_line_pattern(form, statement, dialect), flags | re.ASCII) for form in (statement.form, *statement.also_read)
    )
    section = None
    if statement.within is not None:
        kinds: dict[str, FieldType] = dict.fromkeys(field_names(statement.within), definition.addresses.type)
        section = re.compile(_form_pattern(statement.within, kinds), flags | re.ASCII)
    head = _PIECE.match(statement.form)
    literal = "" if head is None or head["field"] else head[0]
    return Matcher(statement, forms, section, literal.upper() if dialect.case == "ignored" else literal)


def _line_pattern(form: str, statement: Statement, dialect: Dialect) -> str:
    before = "" if dialect.block_number is None else f"(?:{re.escape(dialect.block_number)}[0-9]+[ \\t]+)?"
    after = "" if dialect.line_checksum is None else f"(?P<checksum_>[ \\t]+{re.escape(dialect.line_checksum)}[0-9A-Fa-f]{{4}})?"
    return f"[ \\t]*{before}{_form_pattern(form, statement.fields)}{after}{_REST[statement.rest]}"


def _form_pattern(form: str, kinds: Mapping[str, FieldType]) -> str:
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
            both_words = previous == kind == "word"
            gap = (r"[ \t]+" if blank else "") if both_words else r"[ \t]*"
            pattern += "" if "label" in (label, kinds.get(piece["field"] or "")) else gap
        field = piece["field"]
        label = kinds.get(field or "")
        pattern += f"(?P<{field}>{_FIELD_PATTERNS[kinds[field]]})" if field else re.escape(piece[0])
        previous, blank = kind, False
    return pattern
