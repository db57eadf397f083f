"""Corrections between axes (squareness, straightness) -> tables in addition to the existing
ones.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from compwright.formats.families.control_texts import gathered_files
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.options import available, too_few, unit_unknown
from compwright.formats.families.pairs.writing import CecWriter, PairEntry
from compwright.formats.text.own_files import OwnFiles
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Direction
from compwright.records.correction import AxisCompensation, ControlFile, CrossCompensation


def write_cross(
    control: Family, cross: Sequence[CrossCompensation], files: Sequence[ControlFile] = ()
) -> tuple[ControlFile, ...]:
    """Return the files that add ``cross`` to the existing corrections: those of ``files`` that
    change, and new ones.

    Each entry goes into free tables of its own (one for both directions, or one for each) in
    addition to the existing ones; values are what is added to the output axis, mm or deg. Two
    points are a ramp. With tables of the same run, the state of ``control`` and ``files`` are those
    returned by writing them, so that no index is taken twice. Raises UsageError for an axis over
    itself, CapacityError with everything that the control cannot hold, including too few free
    indices in ``cec_tables``.
    """
    definition, state = control.definition, control.state
    if not available(control.options):
        raise CapacityError(
            Fault(
                message=f"{definition.id} contains tables between axes only as an option",
                place="option cec",
                expected="available",
                hint=(
                    "set `cec: available` in the options if the control has this option, or "
                    "remove the cross entries from the job"
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
        label = f"{entry.input} on {entry.output}"
        unknown = unit_unknown(control, label, writer.tables.axis(entry.output), kinds)
        unsound = [*unknown, *_unsound(entry), *_beyond_sum(writer, entry)]
        faults.extend(unsound)
        if not unsound:
            output = entry.output if own is None else own.gathered.axis(entry.output)
            left.setdefault(output, []).extend(_put(writer, entry, faults))
    raise_all(CapacityError, list(dict.fromkeys(faults)))
    fresh = [
        writer.new_file("cross", output, entries) for output, entries in left.items() if entries
    ]
    return (*(own.patched(own.changed()) if own is not None else ()), *fresh)


def _put(writer: CecWriter, entry: CrossCompensation, faults: list[Fault]) -> list[PairEntry]:
    """Put the table, or the two tables, by which one axis corrects another; return those without a
    place in the files.
    """
    tables = writer.tables
    pair = tables.axis(entry.input), tables.axis(entry.output)
    both = np.array_equal(entry.positive, entry.negative)
    directions: tuple[Direction | None, ...] = (None,) if both else tuple(Direction)
    free = [one for one in tables.allowed if one not in tables.in_use and one not in tables.kept]
    if len(free) < len(directions):
        label, needed = f"{pair[0]} on {pair[1]}", len(directions)
        faults.append(too_few(label, writer.definition.id, needed, len(free), tables.allowed))
        return []
    curves = []
    for direction in directions:
        curve = entry.negative if direction is Direction.NEGATIVE else entry.positive
        one = AxisCompensation(
            address=pair[1],
            kind=entry.input_kind,
            positions=entry.positions,
            positive=curve,
            negative=curve,
            period=entry.period,
        )
        curves.append((direction, one))
    return writer.put(free, pair, curves, f"{entry.output} over {entry.input}", faults)


def _beyond_sum(writer: CecWriter, entry: CrossCompensation) -> list[Fault]:
    """Return the fault of a table if the sum on its output axis would exceed CEC_MAX_SUM."""
    output = writer.tables.axis(entry.output)
    state = writer.control.state
    facts = state.facts_of(output).pairs
    if facts.max_sum is None:
        return []
    reach = facts.odd_sum + sum(
        float(np.max(np.abs([one.positive, one.negative])))
        for one in (entry, *(other for other in state.cross if other.output == output))
    )
    if reach <= facts.max_sum:
        return []
    return [
        Fault(
            message=(
                f"{entry.input} on {entry.output}: all tables together would reach beyond"
                " CEC_MAX_SUM (MD32720)"
            ),
            expected=f"at most {facts.max_sum:g}",
            found=f"up to {reach:g}",
            hint="reduce the correction or the other tables of this axis, then run the job again",
        )
    ]


def _wrong(entry: CrossCompensation) -> list[Fault]:
    if entry.input.casefold() != entry.output.casefold():
        return []
    return [
        Fault(
            message=(
                f"{entry.input}: the correction of an axis over itself is no table between axes"
            ),
            found=entry.output,
            hint="remove this entry from `cross`; correct the axis with its own tests",
        )
    ]


def _unsound(entry: CrossCompensation) -> list[Fault]:
    label = f"{entry.input} on {entry.output}"
    sizes = {entry.positions.shape, entry.positive.shape, entry.negative.shape}
    if len(sizes) != 1 or entry.positions.ndim != 1 or entry.positions.size < 2:
        return [
            Fault(
                message=f"{label}: a table needs two points or more, with a value each",
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
                        f"{label}: a table that repeats spans one period, with the same value at"
                        " both ends"
                    ),
                    hint="make the table span one period, with equal end values",
                )
            )
    for side, beyond, node in (("below", entry.below, 0), ("above", entry.above, -1)):
        if beyond != "hold" and any(curve[node] != 0 for curve in curves):
            faults.append(
                Fault(
                    message=f"{label}: {side} the table the control keeps the end value",
                    expected="hold",
                    found=beyond,
                    hint="make the table cover the whole travel, or leave this option out",
                )
            )
    return faults
