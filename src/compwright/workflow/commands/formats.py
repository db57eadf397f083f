"""``formats list | show ID | check [PATH...]``: what is known about each control, and whether a
definition keeps its word.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

from compwright.controllers.virtual import KNOWN, virtual_control
from compwright.controls.control import READ_BACK
from compwright.controls.definitions import (
    definition_named,
    definitions_at,
    is_base,
    is_path,
    own_definition,
    taken,
)
from compwright.formats.definition.extends import Find, found_in
from compwright.formats.definition.options import describe_options, resolve_options
from compwright.formats.definition.schema import (
    Choice,
    Definition,
    EvidenceNote,
    Measure,
    OptionValue,
)
from compwright.formats.definition.statements import readable
from compwright.formats.definitions import (
    definitions_from,
    given_twice,
    load_definition,
)
from compwright.formats.families.shapes import RULES
from compwright.formats.gate.gate import check_definition, disagreements
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError, raise_all
from compwright.records.correction import ControlFile

NOT_JUDGED = "not independently judged: there is no virtual control for it"
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


def list_formats() -> tuple[str, ...]:
    """Return one line per installed control: its id and what it is. Raises InputError for a
    definition that cannot be read.
    """
    definitions = definitions_from(storage.definition_files())
    width = max((len(name) for name in definitions), default=0)
    return tuple(f"{name:<{width}}  {definition.title}" for name, definition in definitions.items())


def show_format(name: str) -> tuple[str, ...]:
    """Return what is known about a control as lines: form, quantities, limits, options, each with
    its evidence. ``name``: an id that ships, or the path of a definition of one's own.

    Raises UsageError for an unknown id, naming those that exist, InputError for a file that is no
    definition.
    """
    definition = own_definition(Path(name)) if is_path(name) else definition_named(name, Path())
    lines = [f"{definition.id}: {definition.title}"]
    if definition.judged != "independent":
        lines.append(READ_BACK.format(definition.id))
    lines.append("")
    for heading, section in (
        ("The table", _table(definition)),
        ("What stands where", _quantities(definition)),
        ("Limits", _limits(definition)),
        ("Options", describe_options(definition)),
        ("Files that are written", _files(definition)),
        ("What to look at on the control, by verdict", _look_at(definition)),
        ("What is unconfirmed", _unconfirmed(definition)),
        ("Proven on", _proven(definition)),
        ("Sources", (f"{name}: {text}" for name, text in definition.sources.items())),
    ):
        lines += [heading, *(f"  {line}" for line in section), ""]
    return tuple(lines[:-1])


def check_formats(paths: Sequence[Path]) -> tuple[str, ...]:
    """Check the definitions in ``paths`` (files or folders; none: those that ship with compwright)
    and return one line for each.

    Raises InputError with every fault of every file: keys, hand-worked corrections that do not come
    out, a sample that is not read back as written.
    """
    lines: list[str] = []
    faults: list[Fault] = []
    ids: dict[str, str] = {}
    ships = set(dict(storage.definition_files()).values())
    for file, content, find in _contents(paths):
        try:
            definition = load_definition(content, file, find)
        except CompwrightError as error:
            faults.extend(error.faults)
            continue
        found = check_definition(definition)
        judged = definition.id in KNOWN
        if not found and judged:
            found = tuple(_judge(definition))
        if content not in ships:
            found = (*found, *taken(definition))
        faults.extend(found)
        name = definition.id.casefold()  # of folders, on some disks one
        if name in ids:
            faults.append(given_twice(definition, ids[name]))
        ids[name] = file
        if not found:
            positions = sum(len(expectation.at) for expectation in definition.expect)
            says = "by the virtual control too" if judged else NOT_JUDGED
            if definition.worked_for and not judged:
                says += f"; they are those of {definition.worked_for}, none of its own"
            lines.append(
                f"{file}: {definition.id}: {positions} positions worked by hand agree, {says}; the"
                " sample is read back as written; every limit is kept"
            )
    raise_all(InputError, faults)
    if not lines:
        raise InputError(
            Fault(
                message="no definition was found",
                file=", ".join(str(path) for path in paths),
                expected="*.yaml",
            )
        )
    return tuple(lines)


def _judge(definition: Definition) -> Iterator[Fault]:
    """Yield a fault for every hand-worked correction on which the virtual control does not
    agree.
    """
    for index, expectation in enumerate(definition.expect):
        files = [
            ControlFile(name, text.encode("utf-8")) for name, text in expectation.files.items()
        ]
        try:
            control = virtual_control(
                definition.id,
                files,
                reference_return={expectation.axis: expectation.reference_return},
                kinds={expectation.axis: expectation.kind},
                options={
                    **resolve_options(definition, expectation.options),
                    "axis": expectation.axis,
                },
            )
            yield from disagreements(
                definition,
                index,
                partial(control.correction, expectation.axis),
                "the virtual control does not agree at {}",
            )
        except CompwrightError as error:
            place = f"expect, {expectation.name}"
            yield from (
                definition.text.fault(
                    ("expect", index), f"the virtual control: {fault}", place=place
                )
                for fault in error.faults
            )


def _contents(paths: Sequence[Path]) -> Iterator[tuple[str, bytes, Find]]:
    if not paths:
        files = dict(storage.definition_files())
        for name, content in files.items():
            if not is_base(Path(name)):
                yield name, content, found_in(files)
    for path in paths:
        yield from definitions_at(path)


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
                yield f"{verdict.replace('_', ' ')}: {words} [{rule.evidence}]"


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
