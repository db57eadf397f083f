"""Write corrections between axes into the list of the corrected axis, with the steps to load
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.families.axis_pairs import (
    Between,
    BetweenRequest,
    cannot_hold,
    combined_answer,
    error_label,
    refusal,
)
from compwright.formats.families.card_texts import and_joined
from compwright.formats.families.family import Family
from compwright.formats.families.lists.cross import CROSS_ROOM, CROSS_VALUES
from compwright.formats.families.lists.table import TENTH
from compwright.formats.families.lists.writing import ListsWriter
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlFile, ControlState, CrossCompensation
from compwright.records.plan import PlannedCross
from compwright.words.sentences import control_text

#: Straight is what a curve misses by less than this, mm or deg.
_STRAIGHT = 1e-9


def lists_between(family: Family, request: BetweenRequest) -> Between:
    """Return the answer to a request for corrections between axes: value lists and loading steps,
    or the reason why a correction is impossible.
    """
    signs = {entry.output: _sign(family, request, entry) for entry in request.planned}
    before = request.read(request.base)
    writer = ListsWriter(family.definition, request.base)
    held: list[PlannedCross] = []
    refused: list[Between] = []
    for entry in request.planned:
        try:
            _write(writer, entry, signs[entry.output], before, request.planned)
        except CapacityError as error:
            refused.append(cannot_hold([entry], refusal(error.faults)))
        else:
            held.append(entry)
    missing = combined_answer(refused)
    if not held:
        return missing
    known = {file.name: file.content for file in request.base}
    written = writer.files_of([entry.added.output for entry in held])
    changed = tuple(file for file in written if known.get(file.name) != file.content)
    meanings = {entry.output: str(_values(family, request, entry)) for entry in held}
    steps = [step for entry in held for step in _steps(entry, changed, meanings[entry.output])]
    return replace(
        missing,
        files=changed,
        held=tuple(held),
        steps=(*steps, *missing.steps),
        quantum=TENTH,
    )


def _values(family: Family, request: BetweenRequest, entry: PlannedCross) -> object:
    return family.options_of(request.axes.get(entry.output))[CROSS_VALUES]


def _sign(family: Family, request: BetweenRequest, entry: PlannedCross) -> int:
    """Return 1 or -1, by which a correction is multiplied to get the list's table value."""
    meaning = _values(family, request, entry)
    if meaning is None:
        raise UsageError(
            Fault(
                message=(
                    f"{error_label(entry)}: it is not documented whether the values of "
                    "kw.crosscomp are the error of the axis or its correction (opposite sign)"
                ),
                place=CROSS_VALUES,
                expected=f"`{CROSS_VALUES}: error` or `{CROSS_VALUES}: correction`",
                found="neither",
                hint=(
                    "find the sign with the test that docs/controllers/isg-kernel.md describes, "
                    f"then set `{CROSS_VALUES}: error` or `{CROSS_VALUES}: correction` in the "
                    "options of the job"
                ),
            )
        )
    return 1 if meaning == "correction" else -1


def _write(
    writer: ListsWriter,
    entry: PlannedCross,
    sign: int,
    before: ControlState,
    planned: Sequence[PlannedCross],
) -> None:
    """Write the sum of the existing correction and the correction ``entry`` as one table. ``sign``:
    1 or -1, the factor from a correction to a table value; ``before``: the state of the control's
    files. Raises CapacityError.
    """
    added = entry.added
    in_lists = {each.input for each in before.cross if each.output == added.output}
    in_job = {each.added.input for each in planned if each.added.output == added.output}
    active = [
        each for each in before.cross if (each.input, each.output) == (added.input, added.output)
    ]
    faults = []
    if in_lists | in_job != {added.input}:
        places = (
            (in_lists, control_text("lists of the control")),
            (in_job, control_text("job (`apply` and `cross`)")),
        )
        hints = [
            control_text(
                "remove the corrections of axis {output} over {inputs} from the {where}",
                output=added.output,
                inputs=tuple(sorted(others)),
                where=where,
            )
            for inputs, where in places
            if (others := inputs - {added.input})
        ]
        faults.append(
            Fault(
                message=control_text(
                    "this control can correct axis {output} over the position of only one other"
                    " axis",
                    output=added.output,
                ),
                expected=control_text("one other axis"),
                found=", ".join(sorted(in_lists | in_job)),
                hint=control_text("{steps}, and run again", steps=and_joined(hints)),
            )
        )
    if not np.allclose(added.positive, added.negative, rtol=0.0, atol=_STRAIGHT):
        faults.append(
            Fault(
                message=control_text(
                    "a cross-axis table contains one curve, which is the same for both directions"
                ),
                expected=control_text("one curve"),
                found=control_text("two different curves"),
                hint=control_text(
                    "give the same deviations for both directions in this entry of `cross`"
                ),
            )
        )
    raise_all(CapacityError, faults)
    positions = np.unique(np.concatenate([each.positions for each in (added, *active)]))
    positions = np.unique(np.round(positions / TENTH) * TENTH)
    total = _sum([added, *active], positions)
    kept = _corners(positions, total)
    positions, total = positions[kept], total[kept]
    room = _room(writer, added.output)
    if positions.size > room:
        raise CapacityError(
            Fault(
                message=control_text(
                    "the table that corrects axis {output} over the position of axis {input} has"
                    " too many points",
                    output=added.output,
                    input=added.input,
                ),
                expected=control_text("at most {value}", value=str(room)),
                found=str(positions.size),
                hint=control_text("give fewer points in this entry of `cross`"),
            )
        )
    writer.put_cross(
        added.output,
        added.input,
        [str(round(place / TENTH)) for place in positions],
        [str(round(sign * value / TENTH)) for value in total],
    )


def _room(writer: ListsWriter, address: str) -> int:
    meaning = writer.lists.places(address, "cross_max_points")
    return (int(meaning[0].text) if meaning else 0) or CROSS_ROOM


def _sum(tables: Sequence[CrossCompensation], where: FloatArray) -> FloatArray:
    return sum((each.at(where, Direction.POSITIVE) for each in tables), np.zeros(where.size))


def _corners(positions: FloatArray, values: FloatArray) -> list[int]:
    """Return the indices of a curve's first and last points and of the points between them at which
    its slope changes.
    """
    kept = [0]
    for index in range(1, positions.size - 1):
        around = np.array([kept[-1], index + 1])
        straight = np.interp(positions[kept[-1] + 1 : index + 1], positions[around], values[around])
        if np.max(np.abs(straight - values[kept[-1] + 1 : index + 1])) > _STRAIGHT:
            kept.append(index)
    return [*kept, positions.size - 1] if positions.size > 1 else kept


def _steps(entry: PlannedCross, files: Sequence[ControlFile], meaning: str) -> list[dict[str, str]]:
    """Return the card's steps to load a cross-axis table: check the sign, then load the ``files``.
    ``meaning``: what the job states the table's values to be, "error" or "correction".
    """
    added = entry.added
    axes = {"output": entry.output, "input": entry.input}
    loading = control_text(
        "Load {files}: {error} is in the list of axis {corrected}, whose"
        " master is axis {master}. lr_param.crosscomp 1 in the parameter list of axis"
        " {corrected}; restart or reload, and reference both axes: no "
        "compensation is active before that"
        " {input} is referenced. Outside the table its end values should stay; no page"
        " says it. Work offsets of {output} shift with {input}: probe them again.",
        files=and_joined([file.name for file in files]),
        error=error_label(entry),
        corrected=added.output,
        master=added.input,
        **axes,
    )
    sign = control_text("{output} over {input}: check the sign", **axes)
    load = control_text("{output} over {input}: load", **axes)
    return [
        {"title": sign, "text": _checking(entry, meaning), "evidence": "unconfirmed"},
        {"title": load, "text": loading, "evidence": "inferred"},
    ]


def _checking(entry: PlannedCross, meaning: str) -> str:
    """Return the card's text on a trial at the machine that shows the sign of a table value.
    ``meaning``: what the job states the table's values to be, "error" or "correction".
    """
    added = entry.added
    factor, unit = outside_factor(added.output_kind.unit), shown_unit(added.output_kind.unit)
    low, high = (float(value) for value in added.positive[[0, -1]])
    change = (high - low) * factor
    return control_text(
        "No page says in which direction a value of kw.crosscomp moves axis {output};"
        " cross_values: {meaning} is what the job says. Before production, keep clear of"
        " everything, with a dial gauge on {output}: {output}[COMP OFF CROSS], go with"
        " {input} from {start} to {end}, read it; then the"
        " same with {output}[COMP ON CROSS]. What is new must move {output} by"
        " {change} {unit} on this way, in addition to the effect of the old list. "
        "If it is the opposite:"
        " restore the old list and run again with the other one.",
        output=entry.output,
        input=entry.input,
        meaning=meaning,
        start=f"{added.positions[0]:g}",
        end=f"{added.positions[-1]:g}",
        change=f"{round(change, 1) + 0.0:+.1f}",
        unit=unit,
    )
