"""Compare the job's statements about an axis with those of the control's files (FANUC)."""

from __future__ import annotations

from collections.abc import Iterator

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.travel_limits import check_travel
from compwright.formats.text.notes import CORRECT_TRAVEL
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis, AxisKind

#: Two positions are the same below this many mm or deg: a control counts in 0.0001 at the finest.
SAME_PLACE = 1e-6


def check_wrapping(values: IncrementAxisValues, kind: AxisKind) -> None:
    """Check that job and files agree on whether the axis is endless, and on its turn."""
    wraps, bits = values.wraps(), values.own.get(known.KIND)
    if kind is not AxisKind.ROTARY or values.axis is None or wraps is None or bits is None:
        return
    modulo, turn = values.axis.modulo, values.turn(kind)
    set_turn = f"set `modulo: {turn:g}` for the axis in the job"
    if (modulo is not None) != wraps:
        says, expected, step = (
            ("endless (1006#0 = 1, 1006#1 = 0)", f"modulo: {turn:g} in the job", set_turn)
            if wraps
            else (
                "a rotary axis with ends (1006#0 = 1, 1006#1 = 1)",
                "no modulo in the job",
                "delete `modulo` of the axis in the job",
            )
        )
        message = f"the axis is {says} in the control, but not in the job"
    elif modulo is not None and abs(turn - modulo) > SAME_PLACE:
        message = "the turn of the control's files (3625, else 1260) is not the modulo of the job"
        expected, step = f"modulo: {turn:g}", set_turn
    else:
        return
    hint = f"{step}, if the control is right"
    values.notes.faults.append(bits.fault(f"{values.label}: {message}", expected, hint))


def check_travel_limits(values: IncrementAxisValues, kind: AxisKind) -> None:
    """Compare the software limits 1321 and 1320 with the job's travel, if 1320 is above 1321."""
    if values.axis is None or (kind is AxisKind.ROTARY and values.wraps() is not False):
        return
    limits_found = [values.found(name) for name in ("limit_low", "limit_high")]
    if any(one is None or "." not in one.text for one in limits_found):
        return
    low, high = (values.length(name, kind) for name in ("limit_low", "limit_high"))
    check_travel(
        values.axis,
        (float(low or 0), float(high or 0)),
        values.label,
        "1320, 1321",
        values.notes,
        lambda *words: values.wrong("limit_high", *words, hint=CORRECT_TRAVEL),
    )


def check_reference(
    values: IncrementAxisValues, kind: AxisKind, reference: float, *, unanswered: bool
) -> None:
    """Compare parameter 1240 with the job's ``reference``, mm or deg. Report a reference other than
    machine zero if the user has not answered (``unanswered``) whether the table's points are
    counted from it.
    """
    given = values.found("reference_coordinate")
    where = values.length("reference_coordinate", kind)
    differs = where is not None and abs(float(where) - reference) > SAME_PLACE
    if values.axis is not None and given is not None and differs:
        message = "the job and the control's files disagree about the reference position (1240)"
        values.wrong(
            "reference_coordinate",
            message,
            f"{reference:g}, `reference` of the job (0 where it gives none)",
            given.text,
            hint=f"set `reference: {where:g}` in the job, if the control is right",
        )
    if unanswered and (reference != 0 or where):
        values.notes.find(
            "CW-S018", "warning", values.label, label=values.label, reference=reference
        )


def points_question(axis: Axis, answer: object) -> Iterator[Fault]:
    """Yield the question whether the control counts its points from the reference position (1240)
    or from machine zero, if these differ. ``answer``: the user's answer; no question if it is
    "reference".
    """
    if axis.reference == 0 or answer == "reference":
        return
    wrong = answer is not None
    yield Fault(
        message=f"axis {axis.name}: the reference position is not machine zero (1240), and "
        + (
            "a table whose points are counted from machine zero cannot be made"
            if wrong
            else "the manuals do not state from which of these two positions the control counts "
            "its points"
        ),
        place="points_from",
        expected="points_from: reference, if a test at the machine confirms it",
        found=f"points_from: {answer}" if wrong else "nothing",
        hint=(
            "write one test value into the point next to the reference position; if the axis "
            "moves by this value there, set `points_from: reference` in the options (without a "
            "job: `--option points_from=reference`)"
        ),
    )


def check_return(values: IncrementAxisValues, *, two: bool) -> None:
    """Check that the job and the files (1006#5) state the same direction of the reference return.
    ``two``: the table has one data set per direction; then a difference is a fault, else only a
    warning.

    The direction decides the sign of 3627, which is used only with two data sets. With one data set
    a wrong direction adds only a constant to the correction.
    """
    home, bits, axis = values.returning(), values.own.get(known.KIND), values.axis
    if home is None or bits is None or axis is None or home is axis.reference_return:
        return
    if two:
        message = (
            f"{values.label}: the reference return is towards {home.value} by 1006#5, towards"
            f" {axis.reference_return.value} in the job"
        )
        why = "with two sets it decides what 3627 means"
        expected = f'reference_return: "{home.value}" in the job: {why}'
        hint = (
            f'set `reference_return: "{home.value}"` for the axis in the job, if the control is'
            " right"
        )
        values.notes.faults.append(bits.fault(message, expected, hint))
        return
    values.notes.find(
        "CW-S044",
        "warning",
        label=values.label,
        files=home.value,
        job=axis.reference_return.value,
    )


def check_diameter(values: IncrementAxisValues, kind: AxisKind) -> None:
    """Check that the job and 1006#3 agree on diameter programming. Raises UsageError if no file
    states it.

    A wrong answer would make all values wrong by a factor of 2.
    """
    if kind is AxisKind.ROTARY:
        return
    in_diameter, job = (
        values.yes("diameter"),
        None if values.axis is None else values.axis.programmed,
    )
    if in_diameter is True and job == "radius":
        values.wrong(
            "diameter",
            "1006#3 states diameter programming, but the job states radius programming",
            "`programmed: diameter` in the job",
            "radius",
            hint="set `programmed: diameter` for the axis in the job",
        )
    if in_diameter is False and job == "diameter":
        values.wrong(
            "diameter",
            "1006#3 states radius programming, but the job states diameter programming",
            "`programmed: radius` in the job",
            "diameter",
            hint="set `programmed: radius` for the axis in the job",
        )
    if not in_diameter and job != "diameter":
        return
    if in_diameter is None:
        expected = "the parameter file with 1006, or radius, in which everything of a job counts"
        raise UsageError(
            Fault(
                message=f"{values.label}: no file states whether the control counts the axis in "
                "diameter (1006#3)",
                place="programmed",
                expected=expected,
                found="programmed: diameter in the job",
                hint=(
                    "add the parameter file with 1006 to the control's files (`states` or "
                    "`--state`), or set `programmed: radius` for the axis in the job"
                ),
            )
        )
    values.notes.find("CW-S019", "warning", label=values.label)
