"""Write corrections between axes (squareness, straightness) into CEC tables."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.definition.statements import print_form
from compwright.formats.families.axis_pairs import (
    Between,
    BetweenRequest,
    cannot_hold,
    error_label,
    merged_files,
    refusal,
)
from compwright.formats.families.card_texts import and_joined, file_stem
from compwright.formats.families.control_texts import gathered_files
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.cross_steps import cross_steps
from compwright.formats.families.pairs.existing_tables import ExistingTables
from compwright.formats.families.pairs.options import (
    allowed_tables,
    available,
    too_few,
    unit_unknown,
)
from compwright.formats.families.pairs.places import Pair
from compwright.formats.families.pairs.updated_tables import (
    added_up,
    either_step,
    largest_sum,
    obstacles,
    over_own_points,
    own_tables,
    updated_table,
)
from compwright.formats.families.pairs.writing import CecWriter, PairEntry
from compwright.formats.text.own_files import OwnFiles
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.foundations.findings import Severity
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.plan import PlannedCross
from compwright.words.sentences import Sentence, control_text, say


def write_cross(
    control: Family, cross: Sequence[CrossCompensation], files: Sequence[ControlFile] = ()
) -> tuple[ControlFile, ...]:
    """Return the changed and new files that add ``cross`` to the existing corrections.

    Each entry of ``cross`` is added to the control's own table of these axes if that takes it
    exactly. Otherwise it gets unused tables in addition to the existing ones: one for both
    directions, or one for each direction. Values are what the control adds to the output axis, mm
    or deg. An entry with two points is a straight line between them.

    If the same run also writes tables of single axes, write those first. Then pass a ``control``
    with the resulting state, and the resulting ``files``, so that no table index is used twice.

    Raises UsageError if an axis is to be corrected by its own position. Raises CapacityError with
    everything that the control cannot hold, including too few free indices in ``cec_tables``.
    """
    definition, state = control.definition, control.state
    if not available(control.options):
        raise CapacityError(
            Fault(
                message=control_text(
                    "{control} has cross-axis tables only if the control has the CEC option",
                    control=definition.id,
                ),
                place="option cec",
                expected="cec: available",
                hint=control_text(
                    "set `cec: available` in the options if the control has it, or remove the"
                    " cross entries from the job"
                ),
            )
        )
    raise_all(UsageError, [fault for entry in cross for fault in _wrong(entry)])
    addresses = [address for entry in cross for address in (entry.input, entry.output)]
    addresses = list(dict.fromkeys((*state.axes, *addresses)))
    own = (
        OwnFiles(definition, files, gathered_files(definition, files, addresses)) if files else None
    )
    writer = CecWriter(control, own)
    faults: list[Fault] = []
    left: dict[str, list[PairEntry]] = {}
    for entry in cross:
        kinds = entry.input_kind, entry.output_kind
        label = control_text("{output} over {input}", output=entry.output, input=entry.input)
        unknown = unit_unknown(control, label, writer.tables.axis(entry.output), kinds)
        unsound = [*unknown, *_unsound(entry)]
        faults.extend(unsound)
        if not unsound:
            output = entry.output if own is None else own.gathered.axis(entry.output)
            left.setdefault(output, []).extend(_put(writer, entry, faults))
    raise_all(CapacityError, list(dict.fromkeys(faults)) or _beyond_sum(writer, cross))
    fresh = [
        writer.new_file("cross", output, entries) for output, entries in left.items() if entries
    ]
    return (*(own.patched(own.changed()) if own is not None else ()), *fresh)


def _put(writer: CecWriter, entry: CrossCompensation, faults: list[Fault]) -> list[PairEntry]:
    """Write a correction between axes as one or two tables; return the tables for which no file of
    the control has lines.
    """
    tables = writer.tables
    pair = tables.axis(entry.input), tables.axis(entry.output)
    both = np.array_equal(entry.positive, entry.negative)
    directions: tuple[Direction | None, ...] = (None,) if both else tuple(Direction)
    label = f"{entry.output} over {entry.input}"
    held = updated_table(writer.control, entry) if tables.own is not None else None
    refused: list[Fault] = []
    if held is not None and held[0] not in tables.kept:
        index, where = held
        total = _curve(pair, entry, where, added_up(writer.control, index, entry, where))
        update = [index], pair, [(None, total)], label
        writer.trial().put(*update, refused)
        if not refused:
            return writer.put(*update, faults)
    free = _unused(tables)
    if len(free) < len(directions):
        own = [index for index in own_tables(writer.control, pair) if index not in tables.kept]
        needed = len(directions)
        between = control_text("{output} over {input}", output=pair[1], input=pair[0])
        fault = too_few(between, writer.definition.id, needed, len(free), tables.allowed)
        if any(len({*tables.in_use.get(index, pair)}) == 1 for index in tables.allowed):
            single = control_text(
                "set `table: {mode: single}` for an axis whose own tables take an index: one table"
                " for both directions needs none"
            )
            fault = replace(fault, hint=either_step(single, fault.hint))
        if refused:  # a free table holds the correction too: the control adds active tables
            faults += [replace(one, hint=either_step(one.hint, fault.hint)) for one in refused]
        else:
            faults.append(_with_own(fault, own, writer.control, entry) if both else fault)
        return []
    curves = []
    for one in directions:
        values = entry.negative if one is Direction.NEGATIVE else entry.positive
        curves.append((one, _curve(pair, entry, entry.positions, values)))
    return writer.put(free, pair, curves, label, faults)


def _curve(
    pair: Pair, entry: CrossCompensation, positions: FloatArray, values: FloatArray
) -> AxisCompensation:
    return AxisCompensation(
        address=pair[1],
        kind=entry.input_kind,
        positions=positions,
        positive=values,
        negative=values,
        period=entry.period,
    )


def _unused(tables: ExistingTables) -> list[int]:
    """Return the indices of tables that may be written and that hold nothing."""
    return [one for one in tables.allowed if one not in tables.in_use and one not in tables.kept]


def _with_own(fault: Fault, own: Sequence[int], control: Family, entry: CrossCompensation) -> Fault:
    """Return the fault that too few tables are free, with each reason why the control's ``own``
    tables of these axes do not take ``entry``, and what to do.
    """
    message, steps = fault.message, []
    for index in own:
        why = obstacles(control, index, entry)
        message = control_text(
            "{message}; table {index} of these axes takes no further correction: {reasons}",
            message=message,
            index=str(index),
            reasons=say("between.faults", faults=[reason for reason, _ in why]),
        )
        steps += [step for _, step in why if step]
    return replace(fault, message=message, hint=either_step(and_joined(steps), fault.hint))


def _beyond_sum(writer: CecWriter, cross: Sequence[CrossCompensation]) -> list[Fault]:
    """Return a fault for each output axis on which the sum of all tables that are active after
    loading would exceed CEC_MAX_SUM.
    """
    state, faults = writer.control.state, []
    axis = writer.tables.axis
    new = [replace(one, input=axis(one.input), output=axis(one.output)) for one in cross]
    for output in dict.fromkeys(entry.output for entry in new):
        limit = state.facts_of(output).pairs.max_sum
        reach = largest_sum(state, output, new)
        if limit is None or reach <= limit * (1 + 1e-9):
            continue
        inputs = and_joined(list(dict.fromkeys(one.input for one in new if one.output == output)))
        faults.append(
            Fault(
                message=control_text(
                    "axis {output}: with the correction over {inputs}, the sum of all CEC tables"
                    " of this axis would exceed CEC_MAX_SUM (MD32720)",
                    output=output,
                    inputs=inputs,
                ),
                expected=control_text("at most {value}", value=f"{limit:g}"),
                found=control_text("up to {value}", value=f"{reach:g}"),
                hint=control_text(
                    "reduce the correction or the other tables of this axis, or raise MD32720,"
                    " then run the job again"
                ),
            )
        )
    return faults


def _wrong(entry: CrossCompensation) -> list[Fault]:
    if entry.input.casefold() != entry.output.casefold():
        return []
    return [
        Fault(
            message=(
                f"{entry.input}: an entry of `cross` cannot correct an axis over its own position"
            ),
            found=f"the output {entry.output}",
            hint="remove this entry from `cross`; correct the axis with its own tests",
        )
    ]


def _unsound(entry: CrossCompensation) -> list[Fault]:
    label = f"{entry.input} on {entry.output}"
    sizes = {entry.positions.shape, entry.positive.shape, entry.negative.shape}
    if len(sizes) != 1 or entry.positions.ndim != 1 or entry.positions.size < 2:
        return [
            Fault(
                message=f"{label}: a table needs at least two points, each with a value",
                hint="give two points or more with a value each",
            )
        ]
    numbers = np.concatenate([entry.positions, entry.positive, entry.negative])
    if not np.all(np.isfinite(numbers)) or np.any(np.diff(entry.positions) <= 0):
        return [
            Fault(
                message=f"{label}: the positions do not ascend, or a number is not finite",
                hint="sort the positions and give only numbers",
            )
        ]
    curves = (entry.positive, entry.negative)
    faults = []
    if entry.period is not None:
        closed = abs(float(entry.positions[-1] - entry.positions[0]) - entry.period) <= 1e-6
        if not closed or any(curve[0] != curve[-1] for curve in curves):
            faults.append(
                Fault(
                    message=(
                        f"{label}: a repeating table must span one period and have the same "
                        "value at both ends"
                    ),
                    hint="make the table span one period, with equal end values",
                )
            )
    ends = (("below", "first", entry.below, 0), ("above", "last", entry.above, -1))
    for side, end, beyond, point in ends:
        if beyond != "hold" and any(curve[point] != 0 for curve in curves):
            faults.append(
                Fault(
                    message=f"{label}: {side} its {end} point the control keeps the value of "
                    "that point",
                    expected=f"`{side}: hold` (the end value)",
                    found=f"`{side}: {beyond}`",
                    hint=f"make the table cover the whole travel, or delete `{side}: {beyond}`",
                )
            )
    return faults


#: Stands before the names of the control's own files while tables are written, to tell them from
#: new ones.
_OWN = "own files/"


def pairs_between(family: Family, request: BetweenRequest, *, small: bool) -> Between:
    """Return the answer to a request for corrections between axes: tables and loading steps, or the
    reason why a correction is impossible. ``small``: the steps name small files, which contain only
    the new values.
    """
    before = request.read(request.base)
    held = tuple(
        replace(entry, added=over_own_points(family.in_state(before), entry.added))
        for entry in request.planned
    )
    request = replace(request, planned=held)
    try:
        new = _written(family, request, before)
    except CapacityError as error:
        faults = [replace(fault, file=fault.file.removeprefix(_OWN)) for fault in error.faults]
        why = refusal(faults)
        return cannot_hold(request.planned, why)
    after = request.read(merged_files(request.base, new), written=True)
    steps = (
        step
        for entry in request.planned
        for step in cross_steps(
            family, entry, _named(family, entry, new, small=small), before, after
        )
    )
    remarks = tuple(_own_changed(family, held, before, after))
    return Between(files=new, held=held, steps=tuple(steps), remarks=remarks)


def _own_changed(
    family: Family, held: Sequence[PlannedCross], before: ControlState, after: ControlState
) -> Iterator[tuple[Severity, Sentence]]:
    """Yield a remark for each own table of the control that is changed although tables that may
    be written are free.
    """
    old, new = before.tables, after.tables
    allowed = allowed_tables(family.definition, family.options)
    free = ", ".join(str(index) for index in allowed if index not in new.used)
    for entry in held if free else ():
        for index in own_tables(family.in_state(before), (entry.added.input, entry.added.output)):
            if old.curves.get(index) != new.curves.get(index):
                what, option = error_label(entry), "cec_tables"
                yield (
                    "info",
                    say("CW-P113.own_table", what=what, table=index, option=option, free=free),
                )


def _written(
    family: Family, request: BetweenRequest, before: ControlState
) -> tuple[ControlFile, ...]:
    """Return the changed files and new files with the requested corrections between axes.
    ``before``: the state of the control's files. A new file has a name that none of these files
    has.

    A file of the same name may be in the control from an earlier round of compensation. The new
    file must not replace it.
    """
    marked = [replace(file, name=_OWN + file.name) for file in request.base]
    taken = {file.name for file in request.base}
    files = []
    added = [entry.added for entry in request.planned]
    for file in write_cross(family.in_state(before), added, marked):
        name = file.name.removeprefix(_OWN)
        stem, dot, ending = name.rpartition(".")
        number = 2
        while file.name == name and name in taken:
            name, number = f"{stem}_{number}{dot}{ending}", number + 1
        taken.add(name)
        files.append(replace(file, name=name))
    return tuple(files)


def _named(family: Family, entry: PlannedCross, new: Sequence[ControlFile], *, small: bool) -> str:
    """Return as text the names of the files to load that contain the new table for ``entry``: the
    files ``new``, or (``small``) the small file made from them.
    """
    if not small:
        return and_joined([file.name for file in new])
    form = next(file.name for file in family.definition.writing if file.when == "cross")
    return print_form(form, {"axis": file_stem(family, entry.added.output)})
