"""Compensation -> the complete set of files that a control loads. Same input, same bytes: no dates, no order by chance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.formats.addresses import normal_address, normal_text
from compwright.formats.capacity import capacity_for, scale_for_writing, written_text
from compwright.formats.increments_writing import write_increments
from compwright.formats.options import resolve_options
from compwright.formats.patching import Change, apply_changes, set_field
from compwright.formats.scale import NotHeld, Scale
from compwright.formats.schema import Choice, Definition, WrittenFile
from compwright.formats.statements import Occurrence, print_form
from compwright.formats.tables import WrittenTable, write_table
from compwright.formats.texts import TextReader
from compwright.formats.user_tables import read_user_tables
from compwright.formats.user_tables_capacity import broken_limits
from compwright.formats.user_tables_writing import write_user_tables
from compwright.foundations.errors import CapacityError, Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, ControlFile, ControlState


def write_tables(
    definition: Definition,
    compensations: Sequence[AxisCompensation],
    axes: Sequence[Axis],
    options: Mapping[str, object],
    state: ControlState | None = None,
    files: Sequence[ControlFile] = (),
) -> tuple[ControlFile, ...]:
    """Return exactly the files that put ``compensations`` into the control, in the order of the axes.

    ``axes`` holds the axis of every compensation. ``files``: the control's own, to be patched. With a ``state`` what the control's
    own files answer (its unit, the points it has reserved, the numbers of other axes) counts. Raises UsageError for a compensation
    without an axis, CapacityError with everything that the control cannot hold exactly: all limits are checked here again,
    whatever was checked before.
    """
    resolved = resolve_options(definition, options, state)
    pairs = _pairs(definition, compensations, axes)
    if definition.layout.shape == "user_tables" and files:  # what they hold is the limit, whatever was known before
        state = read_user_tables(definition, files, options, [axis for _, axis, _ in pairs])
    faults = [fault for _, axis, compensation in pairs for fault in check_limits(definition, axis, compensation, resolved, state)]
    sound = [pair for pair in pairs if pair[2].positions.size >= 2 and not _unsound(pair[2])]
    if definition.layout.shape == "section_increments":
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return write_increments(definition, sound, resolved, state, files)
    if definition.layout.shape == "user_tables":
        raise_all(CapacityError, list(dict.fromkeys(faults)))
        return write_user_tables(definition, pairs, resolved, files)
    written: list[ControlFile] = []
    for address, axis, compensation in sound:
        scale = scale_for_writing(definition, axis, resolved)
        inexact: list[Fault] = []
        table = write_table(definition, compensation, scale, inexact)
        written.extend(_file(definition, file, address, axis, compensation, table, scale, inexact) for file in definition.writing)
        faults.extend(_first_few(inexact, address))
    raise_all(CapacityError, list(dict.fromkeys(faults)))
    return tuple(written)


def _first_few(faults: list[Fault], address: str) -> list[Fault]:
    """One wrong rounding spoils every row: three of them say it."""
    rest = len(faults) - 3
    return faults if rest <= 0 else [*faults[:3], Fault(message=f"axis {address}: {rest} more values like these")]


def _pairs(
    definition: Definition, compensations: Sequence[AxisCompensation], axes: Sequence[Axis]
) -> list[tuple[str, Axis, AxisCompensation]]:
    by_address = {normal_address(definition, axis)[0]: axis for axis in axes}
    faults = []
    pairs: dict[str, tuple[str, Axis, AxisCompensation]] = {}
    for compensation in compensations:
        found = next((axis for axis in axes if axis.address == compensation.address), None)
        address = normal_address(definition, found)[0] if found is not None else normal_text(definition, compensation.address)
        if address not in by_address:
            faults.append(Fault(message=f"no axis has the address {compensation.address}", expected=", ".join(by_address)))
        elif address in pairs:
            faults.append(Fault(message=f"axis {address} has two tables"))
        else:
            pairs[address] = (address, by_address[address], compensation)
    raise_all(UsageError, faults)
    return list(pairs.values())


def _unsound(compensation: AxisCompensation) -> str:
    positions = compensation.positions
    if not positions.shape == compensation.positive.shape == compensation.negative.shape or positions.ndim != 1:
        return "positions and values have different lengths"
    numbers = np.concatenate([positions, compensation.positive, compensation.negative, [compensation.backlash]])
    if not np.all(np.isfinite(numbers)):
        return "a value is not a finite number"
    if np.any(np.diff(positions) <= 0):
        return "the positions do not ascend"
    return ""


def check_limits(
    definition: Definition,
    axis: Axis,
    compensation: AxisCompensation,
    options: Mapping[str, object],
    state: ControlState | None = None,
) -> tuple[Fault, ...]:
    """Return what keeps the control from holding a compensation, apart from single values that are not exact.

    Names the limit, by how much it is broken and what would help.
    """
    label = f"axis {axis.name} ({compensation.address})"
    unsound = _unsound(compensation)
    if unsound:
        return (Fault(message=f"{label}: {unsound}"),)
    capacity = capacity_for(definition, axis, options, state)
    faults: list[Fault] = []

    def fault(message: str, expected: str, found: object) -> None:
        faults.append(Fault(message=f"{label}: {message}", expected=expected, found=str(found)))

    count = compensation.positions.size
    hard = definition.limit_number("max_points")
    most = min((limit for limit in (capacity.max_points, hard) if limit is not None), default=None)
    if count < capacity.min_points:
        fault("too few points", f"at least {capacity.min_points}", count)
    if most is not None and count > most:
        fault("too many points; a wider spacing would help", f"at most {most}", count)
    if capacity.curves == 1 and not np.array_equal(compensation.positive, compensation.negative):
        fault(
            "the control holds one curve for both directions; put the reversal into the backlash",
            "one curve",
            "two different curves",
        )
    if capacity.backlash_quantum is None and compensation.backlash != 0:
        fault("the control has no backlash value beside the table; put it into the two curves", "0", f"{compensation.backlash:g}")
    if axis.modulo is not None and definition.limit("no_endless_axis") is not None:
        fault("tables that repeat (endless rotary axis) are not built yet", "an axis with ends", f"modulo {axis.modulo:g}")
    if compensation.kind is not axis.kind:
        fault("the table and the axis differ in kind", axis.kind, compensation.kind)
    if definition.layout.shape == "user_tables":
        faults.extend(broken_limits(definition, axis, compensation, capacity))
    return (*faults, *_ends(definition, compensation, label))


def _ends(definition: Definition, compensation: AxisCompensation, label: str) -> list[Fault]:
    """The table must mean the same outside its range as the control makes of it, or be zero at that end."""
    faults: list[Fault] = []
    if not compensation.positions.size:
        return faults
    for side, meant, made, node in (
        ("below", compensation.below, definition.layout.below, 0),
        ("above", compensation.above, definition.layout.above, -1),
    ):
        values = (compensation.positive[node], compensation.negative[node])
        if meant != made and any(value != 0 for value in values):
            faults.append(
                Fault(
                    message=f"{label}: {side} the table the control does something else than was planned",
                    expected=made,
                    found=meant,
                )
            )
    return faults


def _file(
    definition: Definition,
    file: WrittenFile,
    address: str,
    axis: Axis,
    compensation: AxisCompensation,
    table: WrittenTable,
    scale: Scale,
    faults: list[Fault],
) -> ControlFile:
    """Return one file: the skeleton of the definition with its single values set and the rows put in."""
    named = {"axis": address, "system": str(axis.encoder.system - 1)}
    newline = definition.dialect.newline
    header = "".join(print_form(line, named) + newline for line in file.header)
    footer = "".join(print_form(line, named) + newline for line in file.footer)
    name = print_form(file.name, named)
    skeleton = (header + footer).encode("ascii")
    changes: list[Change] = []
    if file.rows is not None:
        form = definition.statements[file.rows].form
        rows = [print_form(form, {**named, **row}) for row in table.rows]
        changes.append(Change(len(header), len(header), "".join(row + newline for row in rows).encode("ascii")))
        _check_lines(definition, name, rows, faults)
    texts = _singles(definition, compensation, table, scale, named, faults)
    for place in _statements(definition, ControlFile(name, skeleton)):
        for quantity, text in texts.items():
            binding = definition.bindings[quantity]
            if binding.statement == place.statement:
                changes.extend(set_field(place, binding.field, text))
    return ControlFile(name, apply_changes(skeleton, changes))


def _singles(
    definition: Definition,
    compensation: AxisCompensation,
    table: WrittenTable,
    scale: Scale,
    named: Mapping[str, str],
    faults: list[Fault],
) -> dict[str, str]:
    texts = dict(table.singles)
    for quantity, binding in definition.bindings.items():
        if isinstance(binding, Choice) and quantity in definition.layout.singles:
            texts[quantity] = written_text(binding, scale.options)
    if "table_file" in definition.bindings:
        texts["table_file"] = next(print_form(file.name, named) for file in definition.writing if file.rows is not None)
    if "backlash" in definition.bindings and definition.limit("no_backlash_beside_table") is None:
        try:
            texts["backlash"] = scale.write("backlash", compensation.backlash)
        except NotHeld as error:
            faults.append(Fault(message=f"axis {compensation.address}, backlash: {error}"))
    return texts


def _statements(definition: Definition, skeleton: ControlFile) -> tuple[Occurrence, ...]:
    """Return the places of the single values in a skeleton."""
    faults: list[Fault] = []
    read = TextReader(definition).read(skeleton, faults)
    raise_all(InputError, faults)
    return () if read is None else read.occurrences


def _check_lines(definition: Definition, name: str, rows: Sequence[str], faults: list[Fault]) -> None:
    longest = definition.limit_number("line_length")
    worst = max((len(row) for row in rows), default=0)
    if longest is not None and worst > longest:
        faults.append(Fault(message="a line is too long", file=name, expected=f"at most {longest} characters", found=str(worst)))
