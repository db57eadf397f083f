"""Checks that the job and the control's files agree on the turn of an endless axis."""

from __future__ import annotations

from collections.abc import Sequence

from compwright.formats.families.grid.axis_values import GridAxisValues
from compwright.formats.families.grid.tables import GridTable
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.text.gathering import FoundValue
from compwright.formats.text.notes import ADD_FILE, CORRECT_VALUE, Notes
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import AxisCompensation


def check_modulo(values: GridAxisValues, axis: Axis | None) -> None:
    """Check that job and control agree: an axis with ends, or an endless axis with the same
    range.
    """
    found = values.single("modulo", quiet=False)
    if found is None:
        return
    word = values.stated_word("modulo")
    if axis is None:
        return
    if word == "yes" and axis.kind is AxisKind.ROTARY:
        _check_range(values, axis, found)
    if word == "no" and axis.modulo is not None:
        values.notes.faults.append(
            Fault(
                message=(
                    f"{values.label}: the job makes the axis endless, but the control's files "
                    "give it ends"
                ),
                file=found.occurrence.file,
                place=found.occurrence.place,
                expected=f"modulo {axis.modulo:g}",
                found=found.text,
                hint=(
                    "remove `modulo` of the axis from the job, or give the files of this machine"
                ),
            )
        )


def _check_range(values: GridAxisValues, axis: Axis, found: FoundValue) -> None:
    """Check that the turn of an endless axis is that of the control; a job with ends would leave
    out the rest of the turn.
    """
    length = values.single("modulo_range")
    turn = float(length.text) if length is not None else None
    if axis.modulo is None:
        values.notes.refuse(
            values.label,
            "the control's files say that the axis is endless (MD30310), the job that it has ends",
            found,
            expected=f"modulo: {turn or 360.0:g} in the job",
            found="no modulo",
            hint=f"set `modulo: {turn or 360.0:g}` for the axis in the job",
        )
    elif turn is not None and abs(turn - axis.modulo) > SAME_TURN:
        message = "the modulo of the job is not the modulo range of the control (MD30330)"
        expected, shown = f"modulo: {turn:g}", f"{axis.modulo:g}"
        values.notes.refuse(
            values.label,
            message,
            length,
            expected=expected,
            found=shown,
            hint=f"set `modulo: {turn:g}` for the axis in the job",
        )


def period_of(
    values: GridAxisValues, axis: Axis | None, rows: Sequence[FoundValue], table: GridTable
) -> float:
    """Return the period of a table that repeats: both ends must be equal, so that it repeats
    without a step.
    """
    if table.positive[0] != table.positive[-1] or table.negative[0] != table.negative[-1]:
        first, last = rows[0].occurrence, rows[-1].occurrence
        values.notes.faults.append(
            Fault(
                message=(
                    f"{values.label}: the table repeats, but its two ends differ: the axis would"
                    " jump once a turn"
                ),
                file=first.file,
                place=f"{first.place} to {last.line}",
                expected="the same value at both ends",
                found=f"{table.positive[0]:g} and {table.positive[-1]:g} (corrections)",
                hint=(
                    "correct the table in the control so that both ends are equal, measure "
                    "again, and export it again"
                ),
            )
        )
    if axis is not None and "modulo_start" in values.definition.bindings:
        _check_beginning(values, table)
    return float(table.positions[-1] - table.positions[0])


def _check_beginning(values: GridAxisValues, table: GridTable) -> None:
    """Check that a repeating table begins where the control's range begins; it is not known whether
    the control would find another one.
    """
    found = values.single("modulo_start")
    start = float(found.text) if found is not None else 0.0
    if abs(float(table.positions[0]) - start) > SAME_TURN:
        values.notes.refuse(
            values.label,
            "its table repeats and does not begin where the modulo range of the control begins"
            " (MD30340): whether the control reads the part before it is not known",
            values.single("table_start"),
            expected=(
                f"MIN = {start:g}"
                if found is not None
                else "MIN = 0, or the file that holds MD30340"
            ),
            hint=CORRECT_VALUE if found is not None else ADD_FILE,
        )


def check_turn(axis: Axis, compensation: AxisCompensation, notes: Notes) -> None:
    """Check that the job and the control's files agree on the turn; note a table that does not fit
    the job's axis.
    """
    for table in (compensation, *compensation.others):
        if table.positions.size == 0:
            continue
        label = f"axis {table.address}"
        if axis.modulo is None and table.period is not None:
            notes.find("CW-S033.repeats", "warning", label, label=label, period=table.period)
        elif axis.modulo is not None and table.period is None and not axis.counts_turns:
            notes.find("CW-S033.ends", "warning", label, label=label)
        elif (
            axis.modulo is not None
            and table.period is not None
            and abs(table.period - axis.modulo) > SAME_TURN
        ):
            notes.faults.append(
                Fault(
                    message=f"{label}: the period of its table is not the modulo of the job",
                    expected=f"{axis.modulo:g}",
                    found=f"{table.period:g}",
                    hint=(
                        f"set `modulo: {table.period:g}` for the axis in the job, or give "
                        "the files "
                        "of this machine"
                    ),
                )
            )
