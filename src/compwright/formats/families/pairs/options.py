"""Options for cross-axis tables: whether they exist, which of them compwright is allowed to write,
what values mean.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.families.card_texts import and_joined
from compwright.formats.families.family import Family
from compwright.formats.families.pairs.lines import IN_INCH, MAYBE_INCH, SAYING_METRIC
from compwright.formats.families.pairs.places import Pair, as_table
from compwright.formats.text.scale import NumberScale
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind
from compwright.records.correction import AxisCompensation
from compwright.words.sentences import control_text


def available(options: Mapping[str, object]) -> bool:
    """Return whether the control has cross-axis tables, by the option ``cec``."""
    return options.get("cec") == "available"


def holds_two_curves(options: Mapping[str, object], compensation: AxisCompensation) -> bool:
    """Return whether a compensation needs one table for each direction, because the corrections for
    + and - differ.
    """
    return available(options) and not np.array_equal(compensation.positive, compensation.negative)


def sign_known(control: Family) -> bool:
    """Return whether an option states the meaning of table values: correction or error."""
    return "cec_sign" not in control.definition.options or control.options["cec_sign"] is not None


def sign_question(why: str) -> Fault:
    """Return the question whether table values are corrections or errors; ``why``: its reason."""
    return Fault(
        message=(
            f"{why}, and the sign of its values is not given: a wrong sign doubles the error. "
            "Siemens' manual (Extended Functions 03/2009, page 372) states that a positive value "
            "moves the axis in - (`cec_sign: error`), but the existing values may have been "
            "entered with the opposite sign"
        ),
        place="option cec_sign",
        expected="`cec_sign: correction` or `cec_sign: error`",
        found="not given",
        hint=(
            "check the sign at the machine: put a dial gauge on the axis, set MD32710 and SD41300 "
            "to 1, write +0.1 into every point of one unused table, read the gauge, then write 0 "
            "again. If the axis moved by 0.1 in +, set `cec_sign: correction` in the options; if "
            "it moved in -, set `cec_sign: error` (without a job: `--option cec_sign=error`)"
        ),
    )


def allowed_tables(definition: Definition, options: Mapping[str, object]) -> tuple[int, ...]:
    """Return the table indices in the option ``cec_tables``. Raises UsageError for indices that the
    control does not have.
    """
    given = options.get("cec_tables", ())
    if not isinstance(given, (tuple, list)) or not all(isinstance(index, int) for index in given):
        raise UsageError(
            Fault(
                message="the option cec_tables has a wrong value",
                place="cec_tables",
                expected="a list of table indices",
                found=repr(given),
                hint="give `cec_tables: [0, 1]` with the indices that may be written",
            )
        )
    count = definition.limit_number("cross_tables")
    beyond = [index for index in given if count is not None and index >= count]
    if count is not None and beyond:
        raise UsageError(
            Fault(
                message=f"{definition.id} has {count} CEC tables",
                place="cec_tables",
                expected=f"indices from 0 to {count - 1}",
                found=", ".join(map(str, beyond)),
                hint="give only indices from this range in `cec_tables`",
            )
        )
    return tuple(dict.fromkeys(int(index) for index in given))


def tables_in_words(indices: Sequence[str]) -> str:
    """Return table indices as text, such as "tables 1 and 2"."""
    tables = and_joined(indices)
    if len(indices) == 1:
        return control_text("table {tables}", tables=tables)
    return control_text("tables {tables}", tables=tables)


def reserving(definition: Definition, points: int, which: str) -> str:
    """Return the instruction to reserve memory for so many ``points`` in the tables that ``which``
    names.
    """
    fixed = definition.limit_number("cross_points")
    if fixed is None:
        return control_text(
            "MD18342 $MN_MM_CEC_MAX_POINTS must be at least {points} for {which}. If it is"
            " smaller: set it, save an archive, power on, load the archive back.",
            points=str(points),
            which=which,
        )
    return control_text(
        "{points} points are needed for {which}: each has room for {room}, none are reserved.",
        points=str(points),
        which=which,
        room=str(fixed),
    )


def free_tables(allowed: Sequence[int], in_use: Mapping[int, Pair], address: str) -> list[int]:
    """Return the indices of the ``allowed`` tables that are usable for an axis to correct itself:
    first the tables that already do so, then unused tables. ``in_use``: the axes of each table in
    the files.
    """
    own = [index for index in allowed if in_use.get(index) == (address, address)]
    return [*own, *(index for index in dict.fromkeys(allowed) if index not in in_use)]


def too_few(name: str, format_id: str, needed: int, found: int, allowed: tuple[int, ...]) -> Fault:
    """Return the fault that the option ``cec_tables`` allows too few tables for an axis."""
    values = {"name": name, "control": format_id, "needed": str(needed)}
    values |= {"found": str(found), "allowed": ", ".join(map(str, allowed))}
    given = control_text("none: the option is not given")
    if allowed and found:
        given = control_text("{found} in `cec_tables` ({allowed})", **values)
    elif allowed:
        given = control_text(
            "none in `cec_tables` ({allowed}); those that this job writes for its axes are used",
            **values,
        )
    if needed == 1:
        message = control_text(
            "axis {name}: {control} needs a CEC table that is free or already belongs to this axis",
            **values,
        )
        hint = control_text(
            "look in the control for an unused table, and ask the machine's builder; then give its"
            " index as `cec_tables` in the options"
        )
    else:
        message = control_text(
            "axis {name}: {control} needs {needed} CEC tables that are free or already belong to"
            " this axis",
            **values,
        )
        hint = control_text(
            "look in the control for {needed} unused tables, and ask the machine's builder; then"
            " give their indices as `cec_tables` in the options",
            **values,
        )
    return Fault(
        message=message,
        place="option cec_tables",
        expected=control_text("free indices in `cec_tables`, at least {needed}", **values),
        found=given,
        hint=hint,
    )


def unit_unknown(
    control: Family, label: str, output: str, kinds: Iterable[AxisKind]
) -> Iterator[Fault]:
    """Yield a fault if no table on the axis ``output`` can be written, because the unit of its
    tables is inch or unknown. ``kinds``: the kinds (linear, rotary) of both axes; rotary axes need
    no length unit.

    The unit is unknown if the control works in inch and no file states the unit of its cross-axis
    tables.
    """
    metric = control.state.facts_of(output).pairs.metric
    unknown = metric is None and control.options.get("units") == "inch"
    if (metric is False or unknown) and any(kind is not AxisKind.ROTARY for kind in kinds):
        hint = control_text("set `cec: absent` in the options, so that no CEC table is written")
        if unknown:
            hint = control_text(
                "{step}, or add the file with {parameter} to the control's files (`states` or"
                " `--state`)",
                step=hint,
                parameter=SAYING_METRIC,
            )
        yield Fault(
            message=control_text(
                "{label}: no CEC table can be written for this control: {why}",
                label=label,
                why=MAYBE_INCH if unknown else IN_INCH,
            ),
            place="option cec",
            expected=control_text("`cec: absent`, or {parameter}", parameter=SAYING_METRIC),
            found="`cec: available`",
            hint=hint,
        )


def scale_of_pairs(control: Family, kind: AxisKind) -> NumberScale:
    """Return unit, sign and resolution of the numbers in a cross-axis table.

    If the sign is unknown, values count as corrections, so that the table's positions and size can
    still be read.
    """
    options = control.options
    if not sign_known(control):
        options = {**options, "cec_sign": "correction"}
    return NumberScale(as_table(control.definition), kind, options, {})
