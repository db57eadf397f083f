"""The definition of a control, as records. `definitions` reads them from YAML;
docs/definition-keys.md explains each key.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePath

from compwright.formats.definition.inheritance import DefinitionText
from compwright.formats.definition.vocabulary import (
    AddressType,
    Case,
    DiameterTables,
    FieldType,
    Here,
    OptionType,
    Pairing,
    Predicate,
    Repeated,
    Rest,
    Say,
    Sign,
    When,
)
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import Beyond, Evidence, Judged
from compwright.records.plan import Texts
from compwright.records.verification import LoadingName
from compwright.words.sentences import ControlText, control_text, unconfirmed


@dataclass(frozen=True, slots=True)
class EvidenceNote:
    """How well a fact is known (confirmed, inferred, unconfirmed), and its source."""

    state: Evidence
    source: str

    def __str__(self) -> str:
        """Return the note as one line."""
        return f"{self.state}: {self.source}"

    @property
    def text(self) -> str:
        """The note as one line, as a text that each language can translate."""
        source = ControlText(self.source, {})
        if self.state == "unconfirmed":
            return unconfirmed(source)
        if self.state == "inferred":
            return control_text("inferred: {what}", what=source)
        return control_text("confirmed: {what}", what=source)


@dataclass(frozen=True, slots=True)
class OptionValue:
    """A value that is taken from the option with the name ``option``, instead of a fixed text in
    the definition.
    """

    option: str


@dataclass(frozen=True, slots=True)
class Addresses:
    """How the control names its axes. ``letters``: an axis letter's index here, from 0, is the axis
    number that is assumed if the job gives only the letter.
    """

    type: AddressType
    case: Case
    letters: str | None
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class Dialect:
    """Rules for every line of a control's files: line ends, upper and lower case, block numbers and
    checksums.

    ``blanks_anywhere``: when a line is read, blanks are allowed between any two of its parts.
    """

    newline: str
    newlines_read: tuple[str, ...]
    case: Case
    block_number: str | None
    line_checksum: str | None
    blanks_anywhere: bool
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class TextKind:
    """The rules by which the lines of one kind of file are read.

    ``recognised_by``: name of a statement that such a file contains; None: any text.
    ``claims_at_start``, ``claims_anywhere``: words. A line that begins with, or contains, such a
    word must be readable. ``other_lines_refused``: every line must be readable.
    """

    name: str
    recognised_by: str | None
    sections: str | None
    comment_marks: tuple[str, ...]
    comments_anywhere: bool
    blank_lines_anywhere: bool
    claims_at_start: tuple[str, ...]
    claims_anywhere: tuple[str, ...]
    other_lines_refused: bool
    because: str
    ends_with: tuple[str, ...]
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class Statement:
    """A line template with typed fields in braces. ``within``: the section of the file in which the
    line is valid; ``rest``: what may follow the template on the line.
    """

    name: str
    text: str
    form: str
    also_read: tuple[str, ...]
    fields: Mapping[str, FieldType]
    within: str | None
    rest: Rest
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class Absent:
    """The default of a quantity that is in none of the files, and whether the default is shown."""

    value: str
    say: Say
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class Binding:
    """Where a quantity such as the backlash is in the files: its statement and field.

    ``repeated``: which of several values within one file counts. Values in several files must
    agree.
    """

    quantity: str
    statement: str
    field: str
    repeated: Repeated
    when_absent: Absent | None
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class Measure(Binding):
    """A quantity that is a length or an angle: unit, sign and range of its number in the files.

    ``sign_by``, ``signs``: the choice on which the sign depends, and the sign for each of its
    values. ``sign_option``: the option whose value is the sign. ``range``: smallest and largest
    position, correction or backlash, in the unit of the file. ``typed``: the card's text of the
    value, with the control's parameter, number and unit.
    """

    linear_unit: str | OptionValue
    rotary_unit: str
    sign: Sign | None
    sign_by: str | None
    signs: Mapping[str, Sign]
    digits: int
    range: tuple[float, float]
    sign_option: str | None = None
    typed: str = ""


@dataclass(frozen=True, slots=True)
class Choice(Binding):
    """A quantity with a few possible values (a choice). ``values``: the meaning of each text in the
    files; ``writes``: the text to write.
    """

    values: Mapping[str, str]
    writes: str | OptionValue

    def written(self, options: Mapping[str, object]) -> str:
        """Return the text that is written for this quantity: a fixed text, or the value of an
        option.
        """
        writes = self.writes
        return str(options[writes.option]) if isinstance(writes, OptionValue) else writes

    def text(self, word: str) -> str:
        """Return the text in the control's files for a meaning, such as "1" for "yes"."""
        return next(text for text, meant in self.values.items() if meant == word)


@dataclass(frozen=True, slots=True)
class Plain(Binding):
    """A quantity that is used as written, without unit or sign: a count or a file name."""


@dataclass(frozen=True, slots=True)
class Layout:
    """How a table is arranged in the files: its shape, its value columns, and the correction below
    its first and above its last point.

    ``shape``: a key of ``RULES`` in `families.shapes`. ``singles``: quantities that have one value
    each, outside the rows.
    """

    shape: str
    pairing: Pairing
    below: Beyond
    above: Beyond
    singles: tuple[str, ...]
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class LimitRule:
    """One limit of the control: the name of a check from a fixed list (``predicate``), and the
    numeric value if that check needs one.
    """

    predicate: Predicate
    number: int | None
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class BetweenAxes:
    """The advice (``instead``) of a control without cross-axis tables on what to do about an error
    between axes.
    """

    instead: str
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class DiameterRule:
    """Whether the tables of an axis programmed in diameter count in radius, and the card's text
    about such an axis.

    ``tables``: ``radius``, whatever the programs count in, or ``unconfirmed``. ``card``: the card's
    text for such an axis, with the field ``{name}``.
    """

    tables: DiameterTables
    card: str
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class ParameterRule:
    """Whether a group of parameters of this family of controls has its usual meaning on this
    control (``here``): yes, another meaning, or unknown.
    """

    here: Here
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class OptionRule:
    """One option of a definition: its type, default, choices, effect, and evidence.

    ``settled_by``: the quantity in the control's files that states the value of the option.
    ``option_wins``: if files and job state different values, the job's value applies.
    ``whole_control``: the option cannot be set for one axis. ``asked``: the text of the question if
    a number that every axis needs is not given; None: the default is used.
    """

    name: str
    type: OptionType
    default: object
    choices: tuple[str, ...]
    settled_by: str | None
    option_wins: bool
    whole_control: bool
    asked: str | None
    help: str
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """A template for one file to be written: its name, its lines before and after the table, and
    the statement for each table row.

    ``rows``: None for a file without a table. ``optional``: the file is a second form of the same
    values, which is written only on request. ``when``: the kind of tables that the file is for.
    """

    name: str
    text: str
    header: tuple[str, ...]
    rows: str | None
    footer: tuple[str, ...]
    optional: bool
    when: When
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class CardRule:
    """One step of the commissioning card, as text with ``{name}`` fields.

    ``two_curves``: the text of the step if each direction has its own table.
    """

    title: str
    text: str
    two_curves: str
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class LookRule:
    """A sentence on what to check at the control, with ``{name}`` fields.

    ``two_curves``: the sentence if each direction has its own table.
    """

    text: str
    two_curves: str
    evidence: EvidenceNote


@dataclass(frozen=True, slots=True)
class Expected:
    """The corrections at one position in both directions, worked out by hand."""

    position: float
    positive: float
    negative: float


@dataclass(frozen=True, slots=True)
class Expectation:
    """A hand-worked example: control files and the corrections that they give at some positions."""

    name: str
    files: Mapping[str, str]
    options: Mapping[str, object]
    axis: str
    kind: AxisKind
    reference_return: Direction
    unit: str
    at: tuple[Expected, ...]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Definition:
    """All facts about the compensation files of one control.

    Two definitions are equal only if they are the same object, because compiled patterns are cached
    with the definition.

    ``maker``: maker of the control, used as a heading in lists; empty if unknown. ``aliases``:
    further names by which users look for the control; several definitions may have the same alias.
    ``parameters``: parameters in addition to the table, by the names that the family of the shape
    uses. ``look_at``: what to check, by the verdict on loading; empty if not stated. ``restore``:
    steps that bring the old values back, by file and parameter; empty if not stated. ``text``: file
    and line of each key, for faults. ``own``: the texts of a user's own definition and of those
    that it extends; empty for a definition of compwright.
    """

    id: str
    title: str
    maker: str
    aliases: tuple[str, ...]
    file: str
    sources: Mapping[str, str]
    proven: tuple[Mapping[str, str], ...]
    addresses: Addresses
    dialect: Dialect
    texts: Mapping[str, TextKind]
    statements: Mapping[str, Statement]
    layout: Layout
    bindings: Mapping[str, Binding]
    between_axes: BetweenAxes
    diameter: DiameterRule
    parameters: Mapping[str, ParameterRule]
    limits: tuple[LimitRule, ...]
    options: Mapping[str, OptionRule]
    writing: tuple[WrittenFile, ...]
    card: tuple[CardRule, ...]
    restore: tuple[CardRule, ...]
    look_at: Mapping[LoadingName, tuple[LookRule, ...]]
    sample_files: Mapping[str, str]
    sample_options: Mapping[str, object]
    expect: tuple[Expectation, ...]
    text: DefinitionText
    own: Texts

    @property
    def carried(self) -> Texts:
        """The YAML texts of a user's own definition, by file name without folder, as a plan stores
        them.
        """
        return tuple((PurePath(name).name, text) for name, text in self.own)

    @property
    def judged(self) -> Judged:
        """How written files are checked: by the virtual control, a second program that shares no
        code with the writer ("independent"), or only by reading them back.
        """
        return "read_back" if self.own else "independent"

    @property
    def worked_for(self) -> str:
        """The name of the extended file that contains the hand-worked example; empty if the
        definition has its own example.
        """
        file, _ = self.text.places["expect",]
        return "" if file == self.text.file else PurePath(file).name

    def measure(self, quantity: str) -> Measure:
        """Return how the definition states a quantity that is a length or angle: its unit, scale
        and sign. Raises KeyError if the definition does not state it.
        """
        binding = self.bindings[quantity]
        if not isinstance(binding, Measure):
            raise KeyError(quantity)
        return binding

    def choice(self, quantity: str) -> Choice:
        """Return the rule of a quantity with a few possible values. Raises KeyError if the
        definition has no such rule.
        """
        binding = self.bindings[quantity]
        if not isinstance(binding, Choice):
            raise KeyError(quantity)
        return binding

    def limit(self, predicate: Predicate) -> LimitRule | None:
        """Return the rule of the limit named ``predicate``; None if there is no such limit."""
        return next((rule for rule in self.limits if rule.predicate == predicate), None)

    @property
    def fields(self) -> frozenset[str]:
        """The names of the fields in all statements of the definition."""
        return frozenset(name for one in self.statements.values() for name in one.fields)

    def limit_number(self, predicate: Predicate) -> int | None:
        """Return the numeric value of the limit named ``predicate``; None if the control has no
        such limit or the limit needs no value.
        """
        rule = self.limit(predicate)
        return None if rule is None else rule.number
