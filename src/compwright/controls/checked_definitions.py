"""Check a definition of a control's files by its sample and corrections worked out by hand."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from compwright.controllers.virtual_control import KNOWN, virtual_control
from compwright.controls.definitions import definitions_at, is_base, name_conflicts
from compwright.formats.definition.inheritance import Find, found_in
from compwright.formats.definition.options import resolve_options
from compwright.formats.definition.schema import Definition, Expectation
from compwright.formats.definitions import duplicate_id, load_definition
from compwright.formats.gate import (
    check_definition,
    disagreements,
    largest_difference,
    read_expectation,
)
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault
from compwright.foundations.session import Session
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class CheckedDefinition:
    """A definition file with all its faults.

    ``definition``: the definition; None if the file cannot be read. ``judged``: a virtual control
    for it exists.
    """

    file: str
    definition: Definition | None
    faults: tuple[Fault, ...]
    judged: bool = False


def checked_definitions(session: Session, paths: Sequence[Path]) -> Iterator[CheckedDefinition]:
    """Yield the definitions in ``paths``, each checked. Raises InputError for unreadable files.

    ``paths``: files or folders; without paths, the supplied definitions are checked. The keys and
    the sample of a definition are checked. Both file readers must also find its corrections worked
    out by hand.
    """
    ids: dict[str, str] = {}
    ships = set(dict(storage.definition_files(session)).values())
    for file, content, find in _contents(session, paths):
        try:
            definition = load_definition(content, file, find)
        except CompwrightError as error:
            yield CheckedDefinition(file, None, error.faults)
            continue
        found = check_definition(definition)
        judged = definition.id in KNOWN
        if not found and judged:
            found = tuple(_judge(definition))
        if content not in ships:
            found = (*found, *name_conflicts(session, definition))
        name = definition.id.casefold()  # of folders, on some disks one
        twice = (duplicate_id(definition, ids[name]),) if name in ids else ()
        ids[name] = file
        yield CheckedDefinition(file, definition, (*found, *twice), judged)


def _contents(session: Session, paths: Sequence[Path]) -> Iterator[tuple[str, bytes, Find]]:
    if not paths:
        files = dict(storage.definition_files(session))
        for name, content in files.items():
            if not is_base(Path(name)):
                yield name, content, found_in(files)
    for path in paths:
        yield from definitions_at(session, path)


def _judge(definition: Definition) -> Iterator[Fault]:
    """Yield a fault for each hand-worked example in which the virtual control finds a different
    correction.
    """
    for index, expectation in enumerate(definition.expect):
        try:
            yield from disagreements(
                definition,
                index,
                _judged(definition, expectation),
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


def _judged(
    definition: Definition, expectation: Expectation
) -> Callable[[FloatArray, Direction], FloatArray]:
    """Return the correction of the virtual control (independent file reader) from the files of a
    hand-worked example.
    """
    control = virtual_control(
        definition.id,
        [ControlFile(name, text.encode("utf-8")) for name, text in expectation.files.items()],
        reference_return={expectation.axis: expectation.reference_return},
        kinds={expectation.axis: expectation.kind},
        options={**resolve_options(definition, expectation.options), "axis": expectation.axis},
    )
    return partial(control.correction, expectation.axis)


@dataclass(frozen=True, slots=True)
class HandWorked:
    """The result of one hand-worked example with one of compwright's two file readers: the largest
    difference between the corrections of the reader and those worked out by hand.

    ``format``: id of the definition. ``expectation``: name of the example. ``reader``: package of
    the file reader, ``formats`` or ``controllers``. ``count``: number of corrections.
    ``difference``: the largest difference, in ``unit``.
    """

    format: str
    expectation: str
    reader: str
    count: int
    difference: float
    unit: str


def hand_worked(checked: CheckedDefinition) -> Iterator[HandWorked]:
    """Yield, for each hand-worked example of a definition, how far each of compwright's two file
    readers deviates. Raises CompwrightError for unreadable files.
    """
    definition = checked.definition
    if definition is None:
        return
    for expectation in definition.expect:
        readers: dict[str, Callable[[FloatArray, Direction], FloatArray]] = {
            "formats": read_expectation(definition, expectation).at
        }
        if checked.judged:
            readers["controllers"] = _judged(definition, expectation)
        for reader, correction in readers.items():
            yield HandWorked(
                definition.id,
                expectation.name,
                reader,
                2 * len(expectation.at),
                largest_difference(expectation, correction),
                expectation.unit,
            )
