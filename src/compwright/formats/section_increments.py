"""Controls that store whole increments by section (FANUC): what the files say -> compensation.

Every axis claims a range of numbers in one array that all axes share. Number n owns the section ((n - r - 1) b, (n - r) b), r the
number of the reference position, b the interval; the total at a node is the sum of the increments from the reference, positive to
the right and with the opposite sign to the left (FANUC 0i-PB parameter manual B-63980EN/01 p100; numbering inferred from its
listing). What is unconfirmed about it stands in the definition.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from compwright.formats.addresses import normal_address, normal_text
from compwright.formats.axis_reading import Fact
from compwright.formats.entry_sheet import is_entry_sheet, parameter_lines
from compwright.formats.gathering import Gathered, gather
from compwright.formats.increments_axis import GRID, IncrementReader
from compwright.formats.increments_points import points_by_number
from compwright.formats.notes import Notes
from compwright.formats.options import REFERENCE, REFERENCE_RETURN, resolve_options
from compwright.formats.schema import Definition
from compwright.formats.texts import ReadText, TextReader
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

#: What makes an axis one that the files say something of: its limits, name and kind alone do not.
_COMPENSATION = (*GRID, "turn", "negative_first", "negative_offset", "bidirectional", "backlash")


def read_increments(
    definition: Definition,
    files: Sequence[ControlFile],
    options: Mapping[str, object],
    axes: Sequence[Axis] = (),
    *,
    address: str | None = None,
) -> ControlState:
    """Return what a control does with ``files``; arguments and errors as `reading.read_state`.

    ``facts`` hold, for every axis that the files name, its numbers (``first_number``, ``last_number``, ...) and what else they say.
    """
    resolved = resolve_options(definition, options)
    notes = Notes()
    texts = read_texts(definition, files, notes.faults)
    raise_all(InputError, notes.faults)
    gathered = gather(definition, texts)
    for text in texts:
        notes.findings.extend(text.findings)
    points = points_by_number(definition, gathered, notes)
    wanted = _wanted(definition, axes, address, notes)
    named = [one for one in gathered.addresses() if one != "0" and _is_compensated(gathered, one)]
    compensations: dict[str, AxisCompensation] = {}
    facts: dict[str, Mapping[str, Fact]] = {}
    for one in dict.fromkeys((*wanted, *named)):
        asked = one in wanted or not wanted
        if one not in named:
            notes.faults.append(_unnamed(one, named, files))
            continue
        reader = IncrementReader(
            definition, gathered, points, one, wanted.get(one), resolved, notes if asked else Notes(), asked=asked
        )
        facts[one] = reader.facts()
        if asked:
            compensation = reader.read()
            if compensation is not None:
                compensations[one] = compensation
    raise_all(InputError, notes.faults)
    _overlaps(facts, definition.limit_number("max_number") or 0, notes)
    if any(axis is None for axis in wanted.values()) or not wanted:
        notes.assume(REFERENCE, f"{resolved[REFERENCE]:g}", "option or its default")
        notes.assume(REFERENCE_RETURN, str(resolved[REFERENCE_RETURN]), "option or its default")
    return ControlState(
        format=definition.id,
        axes=compensations,
        facts=facts,
        assumed=tuple(notes.assumed),
        findings=tuple(dict.fromkeys(notes.findings)),
    )


def read_texts(definition: Definition, files: Sequence[ControlFile], faults: list[Fault]) -> list[ReadText]:
    """Return the statements of all files, typed-entry sheets too; what cannot be read goes to ``faults``."""
    if not files:
        raise UsageError("no file of the control was given; expected its own files, or the state `none`")
    reader = TextReader(definition)
    texts = []
    for number, file in enumerate(files):
        source = file
        if is_entry_sheet(file):
            lines = parameter_lines(file, definition.id, faults)
            source = ControlFile(file.name, lines)
        text = reader.read(source, faults, number)
        if text is not None:
            texts.append(text)
    if not faults and not any(text.occurrences for text in texts):
        faults.append(
            Fault(
                message=f"nothing in it is compensation data of {definition.id}",
                file=", ".join(file.name for file in files),
                expected="lines such as N03620Q1A1P40 and N10037Q0P1",
            )
        )
    return texts


def _wanted(definition: Definition, axes: Sequence[Axis], address: str | None, notes: Notes) -> dict[str, Axis | None]:
    wanted: dict[str, Axis | None] = {}
    if address is not None:
        wanted[normal_text(definition, address)] = None
    for axis in axes:
        name, assumption = normal_address(definition, axis)
        wanted[name] = axis
        if assumption is not None:
            notes.assumed.append(assumption)
            notes.taken_for(axis.name, name)
    return wanted


def _is_compensated(gathered: Gathered, address: str) -> bool:
    return any(name in _COMPENSATION for name in gathered.singles.get((address, None), {}))


def _unnamed(address: str, named: Sequence[str], files: Sequence[ControlFile]) -> Fault:
    return Fault(
        message=f"no file says anything about axis {address}; missing is not zero",
        file=", ".join(file.name for file in files),
        expected=f"parameters with A{address}, or the state `none`",
        found=f"axes {', '.join(named)}" if named else "no axis at all",
    )


def _overlaps(facts: Mapping[str, Mapping[str, Fact]], highest: int, notes: Notes) -> None:
    taken = [
        (address, number)
        for address, said in facts.items()
        if said.get("enabled")
        for numbers in claimed_numbers(said)
        for number in range(max(numbers.start, 0), min(numbers.stop, highest + 1))
    ]
    owners: dict[int, list[str]] = {}
    for address, number in taken:
        owners.setdefault(number, []).append(address)
    shared: dict[tuple[str, ...], list[int]] = {}
    for number, names in owners.items():
        if len(names) > 1:
            shared.setdefault(tuple(names), []).append(number)
    for sharing, numbers in shared.items():
        notes.find(
            "CW-S014",
            "warning",
            f"axes {' and '.join(sharing)} share the point numbers {min(numbers)} to {max(numbers)}: a change for one would change "
            "the other, so a new table gets numbers of its own",
        )


def used_numbers(facts: Mapping[str, Mapping[str, Fact]], without: Iterable[str]) -> list[range]:
    """Return the point numbers that axes other than ``without`` claim; a table that is switched off keeps its numbers."""
    left_out = set(without)
    return [numbers for address, said in facts.items() if address not in left_out for numbers in claimed_numbers(said)]


def claimed_numbers(said: Mapping[str, Fact]) -> tuple[range, ...]:
    """Return the numbers that one axis claims by its facts: one set, or two; none where its first is its last."""
    first, last = said.get("first_number"), said.get("last_number")
    if not (isinstance(first, int) and isinstance(last, int)) or first >= last:
        return ()
    negative = said.get("negative_first")
    if said.get("bidirectional") != "yes" or not isinstance(negative, int):
        return (range(first, last + 1),)
    return range(first, last + 1), range(negative, negative + last - first + 1)
