"""Describe a control as text: the form of its files, quantities, limits, options, with evidence."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from textwrap import wrap

from compwright.formats.definition.options import describe_options
from compwright.formats.definition.schema import (
    Choice,
    Definition,
    EvidenceNote,
    Measure,
    OptionValue,
)
from compwright.formats.definition.statements import readable
from compwright.formats.families.shapes import RULES

_PAIRINGS = {
    "none": "one curve for both directions",
    "two_columns": "one curve for each direction, in two columns",
}
_SIGNS = {
    "position": "position",
    "error": "error, the opposite of the correction",
    "correction": "correction, added to the command",
    "actual_position": "actual position: the position less the correction",
    "lost_motion": "lost motion, compensated where positive",
    "half_each_way": "lost motion, one half in each direction",
}


def listing(definitions: Iterable[Definition]) -> Iterator[str]:
    """Yield a line for each control, by maker: id, title, other names, kinds of evidence."""
    makers: dict[str, list[Definition]] = {}
    for definition in definitions:
        makers.setdefault(definition.maker, []).append(definition)
    for number, maker in enumerate(sorted(makers, key=str.casefold)):
        yield from [*([""] if number else []), maker]
        for definition in makers[maker]:
            states = Counter(note.state for _, note in _evidence(definition))
            facts = ", ".join(
                f"{states[state]} {state}" for state in ("confirmed", "inferred", "unconfirmed")
            )
            for first, text in (
                (definition.id, definition.title),
                ("", f"also: {', '.join(definition.aliases)}"),
                ("", f"facts: {facts}; proven on {len(definition.proven) or 'no'} machine"),
            ):
                yield from wrap(
                    text, 100, initial_indent=f"  {first:<20}", subsequent_indent=" " * 22
                )


def description(definition: Definition) -> Iterator[str]:
    """Yield the lines that describe a control: file form, quantities, limits, options, evidence."""
    for heading, section in (
        ("The table", _table(definition)),
        ("Quantities and their places in the files", _quantities(definition)),
        ("Limits", _limits(definition)),
        ("Options", describe_options(definition)),
        ("Files that are written", _files(definition)),
        ("What to look at on the control, by verdict", _look_at(definition)),
        ("What is unconfirmed", _unconfirmed(definition)),
        ("Proven on", _proven(definition)),
        ("Sources", (f"{name}: {text}" for name, text in definition.sources.items())),
    ):
        yield from ("", heading, *(f"  {line}" for line in section))


def _table(definition: Definition) -> Iterator[str]:
    layout = definition.layout
    ends = {"hold": "the end value stays", "zero": "nothing is corrected"}
    yield f"{RULES[layout.shape].words}; {_PAIRINGS[layout.pairing]}"
    yield f"below the table {ends[layout.below]}, above it {ends[layout.above]} [{layout.evidence}]"
    letters = definition.addresses.letters
    named = "a number" if definition.addresses.type == "integer" else "a name"
    assumed = (
        f"; a letter of {letters} is taken as its place in this row, from 0" if letters else ""
    )
    yield f"an axis is named by {named}{assumed} [{definition.addresses.evidence}]"


def _quantities(definition: Definition) -> Iterator[str]:
    for name, binding in definition.bindings.items():
        form = definition.statements[binding.statement].form.replace("{", "<").replace("}", ">")
        text = f"{name.replace('_', ' ')}: {form}"
        if isinstance(binding, Measure):
            unit = (
                f"option {binding.linear_unit.option}"
                if isinstance(binding.linear_unit, OptionValue)
                else binding.linear_unit
            )
            signs = [binding.sign] if binding.sign else list(binding.signs.values())
            sign = " or ".join(_SIGNS[sign] for sign in signs)
            low, high = binding.range
            text += (
                f"; {sign}; {unit} (rotary: {binding.rotary_unit}), {binding.digits} decimals,"
                f" {low:g} to {high:g}"
            )
        elif isinstance(binding, Choice):
            text += "; " + ", ".join(f"{value} = {word}" for value, word in binding.values.items())
        if binding.when_absent is not None:
            text += f"; where absent: {binding.when_absent.value}"
        yield f"{text} [{binding.evidence}]"


def _limits(definition: Definition) -> Iterator[str]:
    for rule in definition.limits:
        number = "" if rule.number is None else f": {rule.number}"
        yield f"{rule.predicate.replace('_', ' ')}{number} [{rule.evidence}]"


def _files(definition: Definition) -> Iterator[str]:
    for file in definition.writing:
        yield f"{file.name.replace('{axis}', '<axis>')} [{file.evidence}]"


def _look_at(definition: Definition) -> Iterator[str]:
    if not definition.look_at:
        yield "the definition does not say it (look_at): verify and compare name the verdict alone"
    for verdict, rules in definition.look_at.items():
        for rule in rules:
            texts = dict.fromkeys((rule.text, rule.two_curves))
            both = len(texts) > 1
            for which, text in zip(("one table: ", "two tables: "), texts, strict=False):
                words = readable(f"{which if both else ''}{text}")
                yield f"verdict {verdict.replace('_', ' ')}: {words} [{rule.evidence}]"


def _proven(definition: Definition) -> Iterator[str]:
    if not definition.proven:
        yield "no machine yet; a good `compwright verify` on a real machine is the proof"
    for entry in definition.proven:
        yield ", ".join(entry.values())


def _unconfirmed(definition: Definition) -> Iterator[str]:
    notes = [(place, note) for place, note in _evidence(definition) if note.state == "unconfirmed"]
    if not notes:
        yield "nothing that this page knows of"
    for place, note in notes:
        yield f"{place}: {note.source}"


def _evidence(definition: Definition) -> Iterator[tuple[str, EvidenceNote]]:
    yield "addresses", definition.addresses.evidence
    yield "dialect", definition.dialect.evidence
    yield "layout", definition.layout.evidence
    for name, text in definition.texts.items():
        yield f"text {name}", text.evidence
    for name, statement in definition.statements.items():
        yield f"statement {name}", statement.evidence
    for name, binding in definition.bindings.items():
        yield name.replace("_", " "), binding.evidence
        if binding.when_absent is not None:
            yield f"{name.replace('_', ' ')} where absent", binding.when_absent.evidence
    for rule in definition.limits:
        yield rule.predicate.replace("_", " "), rule.evidence
    for name, option in definition.options.items():
        yield f"option {name}", option.evidence
    for file in definition.writing:
        yield f"file {file.name}", file.evidence
    for step in definition.card:
        yield f"card, {step.title}", step.evidence
    for verdict, looks in definition.look_at.items():
        yield from ((f"look at, {verdict.replace('_', ' ')}", look.evidence) for look in looks)
