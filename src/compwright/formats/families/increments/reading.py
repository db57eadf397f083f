"""Controls that store whole increments by section (FANUC): what the files say -> compensation.

Every axis claims a range of numbers in one array that all axes share. Number n owns the section ((n
- r - 1) b, (n - r) b), r the number of the reference position, b the interval; the total at a node
  is the sum of the increments from the reference, positive to
the right and with the opposite sign to the left (FANUC 0i-PB parameter manual B-63980EN/01 p100;
numbering inferred from its listing). What is unconfirmed about it stands in the definition.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from compwright.formats.definition.options import (
    DETECTION_UNIT,
    REFERENCE,
    REFERENCE_RETURN,
)
from compwright.formats.definition.schema import Definition
from compwright.formats.families.increments.acting import pointed_numbers, refusals
from compwright.formats.families.increments.axis import GRID, IncrementReader
from compwright.formats.families.increments.parameters import Parameters
from compwright.formats.families.increments.points import points_by_number
from compwright.formats.families.increments.typed_sheet import parameter_lines
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.gathering import Found, Gathered, gather
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import ReadText, text_reader
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import AxisCompensation, ControlFile, ControlState
from compwright.records.facts import AxisFacts, Fact

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
    """Return what a control does with ``files``; arguments and errors as `Family.read`.

    ``facts`` hold, for every axis that the files name, its numbers (``first_number``,
    ``last_number``, ...) and what else they say.
    """
    notes = Notes()
    texts = read_texts(definition, files, notes.faults)
    raise_all(InputError, notes.faults)
    gathered = gather(definition, texts)
    for text in texts:
        notes.findings.extend(text.findings)
    points = points_by_number(definition, gathered, files, notes)
    parameters = Parameters(files)
    wanted = _wanted(definition, axes, address, notes)
    named = [one for one in gathered.addresses() if one != "0" and _is_compensated(gathered, one)]
    compensations: dict[str, AxisCompensation] = {}
    facts: dict[str, Mapping[str, Fact]] = {}
    for one in dict.fromkeys((*wanted, *named)):
        asked = one in wanted or not wanted
        if one not in named:
            notes.faults.append(_unnamed(one, named, files))
            continue
        own = notes if asked else Notes()
        reader = IncrementReader(
            definition,
            gathered,
            points,
            parameters,
            one,
            wanted.get(one),
            options,
            own,
            asked=asked,
        )
        facts[one] = reader.facts()
        compensation = reader.read() if asked or points else None
        if asked and compensation is not None:
            compensations[one] = compensation
        if not asked:
            notes.findings.extend(_left_alone(one, facts[one], own))
    _check_names(facts, wanted, notes)
    _check_partners(axes, facts, parameters, notes)
    raise_all(InputError, notes.faults)
    _overlaps(facts, definition.limit_number("max_number") or 0, notes)
    unknown = _unknown(points, definition.limit_number("max_number") or 0, options, axes)
    if unknown:
        facts = {one: {**said, "unread_numbers": _spans(unknown)} for one, said in facts.items()}
    if any(axis is None for axis in wanted.values()) or not wanted:
        notes.assume(REFERENCE, f"{options[REFERENCE]:g}", "option or its default")
        notes.assume(REFERENCE_RETURN, str(options[REFERENCE_RETURN]), "option or its default")
    return ControlState(
        format=definition.id,
        axes=compensations,
        facts={one: _typed(said) for one, said in facts.items()},
        assumed=tuple(notes.assumed),
        findings=tuple(dict.fromkeys(notes.findings)),
        reserved=_reserved(points, parameters) | unknown,
    )


def _typed(said: Mapping[str, Fact]) -> AxisFacts:
    name, rotary, limits = said.get("axis_name"), said.get("rotary"), ("limit_low", "limit_high")
    return AxisFacts(
        name=None if name is None else str(name),
        kind=None if rotary is None else AxisKind(str(rotary)),
        limits=(float(said[limits[0]]), float(said[limits[1]]))
        if said.keys() >= {*limits}
        else None,
        enabled=bool(said["enabled"]),
        said=said,
    )


def _reserved(points: Mapping[int, Found], parameters: Parameters) -> frozenset[int]:
    """Return the numbers that hold data, or to which another function points: none of them is free
    for a new table.
    """
    filled = {
        number for number, row in points.items() if row.occurrence.tokens["value"].text.strip("-0")
    }
    return pointed_numbers(parameters) | filled


def _unknown(
    points: Mapping[int, Found], highest: int, options: Mapping[str, object], axes: Sequence[Axis]
) -> frozenset[int]:
    """Return the numbers of which no file says what they hold, below the first free one that the
    user states.

    A pitch file that was cut, or not given, does not make numbers free.
    """
    stated = [axis.options.get("first_point") for axis in axes] + [options.get("first_point")]
    first = min((int(str(one)) for one in stated if one is not None), default=highest + 1)
    return frozenset(number for number in range(first) if number not in points)


def _spans(numbers: Iterable[int]) -> str:
    """Return the first and the last number of a set, and how many they are."""
    ordered = sorted(numbers)
    return f"{ordered[0]} to {ordered[-1]} ({len(ordered)} of them)"


def _left_alone(address: str, said: Mapping[str, Fact], notes: Notes) -> list[Finding]:
    """Return what is odd about an axis that nobody asked for: it stops no work on another one."""
    odd = [finding for finding in notes.findings if finding.code == "CW-S041"]
    if notes.faults and said.get("enabled"):
        what = "; ".join(
            dict.fromkeys(
                f"{fault.message} ({fault.place}: {fault.found})" for fault in notes.faults
            )
        )
        odd.append(
            Finding(
                "CW-S042",
                "warning",
                f"axis {address} is odd and left alone, with all its point numbers: {what}",
            )
        )
    return odd


def _check_partners(
    axes: Sequence[Axis],
    facts: Mapping[str, Mapping[str, Fact]],
    parameters: Parameters,
    notes: Notes,
) -> None:
    """What acts on the synchronised axis of a gantry refuses it too; its detection unit has to be
    that of the leading axis.
    """
    for axis in axes:
        if axis.gantry is None or axis.gantry not in facts:
            continue
        notes.faults.extend(refusals(parameters, axis.gantry, f"axis {axis.gantry}"))
        rotary = facts[axis.gantry].get("rotary")
        if rotary is not None and rotary != axis.kind.value:
            notes.faults.append(
                Fault(
                    message=(
                        f"axis {axis.gantry} is no partner of a gantry with axis {axis.address}:"
                        " their kinds differ (1006#0)"
                    ),
                    place=f"axes.{axis.name}.gantry",
                    expected=f"a {axis.kind.value} axis",
                    found=f"{axis.gantry}, {rotary}",
                )
            )
        own, partner = (
            facts.get(one, {}).get(DETECTION_UNIT) for one in (axis.address, axis.gantry)
        )
        if own is not None and partner is not None and own != partner:
            notes.faults.append(
                Fault(
                    message=(
                        f"axes {axis.address} and {axis.gantry} of a gantry have different"
                        " detection units (1820, 1013)"
                    ),
                    place=f"axes.{axis.name}.gantry",
                    expected=f"{own:g}",
                    found=f"{partner:g}",
                )
            )


def _check_names(
    facts: Mapping[str, Mapping[str, Fact]], wanted: Mapping[str, Axis | None], notes: Notes
) -> None:
    """An axis of the job whose letter belongs to another axis of the control (1020) is not the one
    that is meant.
    """
    letters: dict[Fact, list[str]] = {}
    for address, said in facts.items():
        if "axis_name" in said:
            letters.setdefault(said["axis_name"], []).append(address)
    for address, axis in wanted.items():
        own = facts.get(address, {}).get("axis_name")
        if axis is not None and own is not None and own != axis.name and axis.name in letters:
            notes.faults.append(
                Fault(
                    message=(
                        f"axis {address} of the control is called {own} (1020), not {axis.name}"
                    ),
                    place=f"axes.{axis.name}.address",
                    expected=" or ".join(letters[axis.name]),
                    found=address,
                )
            )


def read_texts(
    definition: Definition, files: Sequence[ControlFile], faults: list[Fault]
) -> list[ReadText]:
    """Return the statements of all files, typed-entry sheets too; what cannot be read goes to
    ``faults``.
    """
    if not files:
        raise UsageError(
            "no file of the control was given; expected its own files, or the state `none`"
        )
    reader = text_reader(definition)
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


def _wanted(
    definition: Definition, axes: Sequence[Axis], address: str | None, notes: Notes
) -> dict[str, Axis | None]:
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
            f"axes {' and '.join(sharing)} share the point numbers {min(numbers)} to"
            f" {max(numbers)}: a change for one would change the other, so a new table gets numbers"
            " of its own",
        )


def used_numbers(state: ControlState | None, without: Iterable[str]) -> list[range]:
    """Return the point numbers that are not free for the axes ``without``.

    Those that other axes claim, a table that is switched off included; those that hold data or to
    which another function points, whoever they belong to, unless the axes have them now.
    """
    if state is None:
        return []
    left_out = set(without)
    used = [
        numbers
        for address, facts in state.facts.items()
        if address not in left_out
        for numbers in claimed_numbers(facts.said)
    ]
    own = [
        numbers for address in left_out for numbers in claimed_numbers(state.facts_of(address).said)
    ]
    others = sorted(
        number for number in state.reserved if not any(number in numbers for numbers in own)
    )
    return [*used, *(range(number, number + 1) for number in others)]


def claimed_numbers(said: Mapping[str, Fact]) -> tuple[range, ...]:
    """Return the numbers that one axis claims by its facts: one set, or two; none where its first
    is its last.
    """
    first, last = said.get("first_number"), said.get("last_number")
    if not (isinstance(first, int) and isinstance(last, int)) or first >= last:
        return ()
    reference = said.get("reference_number")
    if reference == first - 1:  # a full turn that leaves the reference's own number out keeps it
        return (range(first - 1, last + 1),)
    negative = said.get("negative_first")
    if said.get("bidirectional") != "yes" or not isinstance(negative, int):
        return (range(first, last + 1),)
    return range(first, last + 1), range(negative, negative + last - first + 1)
