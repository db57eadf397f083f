"""Tables between axes into the control's files and back, and what the card says about them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.formats.definition.options import axis_options
from compwright.formats.families.columns.sources import parameter_name
from compwright.formats.families.pairs.capacity import cec_available
from compwright.formats.families.pairs.reading import tables_in
from compwright.formats.families.pairs.writing import write_cross
from compwright.foundations.errors import CapacityError, CompwrightError, Fault, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Axis, Direction
from compwright.records.correction import ControlFile, ControlState, CrossCompensation
from compwright.records.plan import PlannedCross
from compwright.workflow.stages.circle_work import judged_cross
from compwright.workflow.stages.control import Control, DecodedState, decode

#: Reading back may differ from what was planned by half a step of the value at either node, mm or
#: deg.
READ_BACK = 2e-6
#: Stands before the names of the control's own files while tables are written, to tell them from
#: new ones.
_OWN = "own files/"
#: What a control without tables between axes needs instead, by the beginning of its format's id.
_INSTEAD = {
    "siemens": (
        "set the option cec: available, if the control has sag compensation, and name free indices"
        " in cec_tables"
    ),
    "fanuc": (
        "straightness compensation is an option of the control, and its parameter numbers are not"
        " confirmed here: enter the two-point line by the machine's own manual"
    ),
}


#: More points than these are typed from the sheet.
_MOST_SHOWN = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossOutcome:
    """What was ``planned`` and whether the control holds it, all ``files`` that it loads, and what
    is in it then.

    ``after``: None where nothing was written: between the axes acts what acted before. ``totals``:
    what then acts between the axes of ``planned``, read back by the judge, by the names of the job.
    ``sheets``: columns to type in, beside the card.
    """

    files: tuple[ControlFile, ...]
    planned: tuple[PlannedCross, ...] = ()
    written: bool = False
    after: DecodedState | None = None
    totals: tuple[CrossCompensation, ...] = ()
    findings: tuple[Finding, ...] = ()
    steps: tuple[Mapping[str, str], ...] = ()
    sheets: tuple[ControlFile, ...] = ()


def write_planned(
    control: Control,
    planned: Sequence[PlannedCross],
    tables: tuple[ControlFile, ...],
    as_found: DecodedState,
    axes: Mapping[str, Axis],
    tabled: Collection[str] = (),
) -> CrossOutcome:
    """Write the tables between axes beside ``tables`` (those of the single axes) and read
    everything back.

    ``tabled``: the axes (names of ``axes``) that get a table of their own in ``tables``. What the
    control cannot hold is not written: a finding and a step of the card say so, and what would
    help. Raises CompwrightError (a fault of our own) when something else comes back than was
    written.
    """
    if not planned:
        return CrossOutcome(files=tables)
    if control.definition.layout.shape == "user_tables":
        return _typed(control, planned, tables, as_found, axes, tabled)
    if control.options.get("straightness") == "available":
        return _straightness(control, planned, tables, axes)
    if not cec_available(control.definition, control.options):
        return _not_held(control, planned, tables, _instead(control))
    base = _together(as_found.files, tables)
    known = list(axes.values())
    before = _read(control, base, known)
    try:
        state = as_found.state if before is None else before.state
        new = _written(control, planned, state, base)
    except CapacityError as error:
        return _not_held(
            control,
            planned,
            tables,
            "; ".join(str(fault) for fault in error.faults).replace(_OWN, ""),
        )
    files = _together(tables, new)
    after = decode(control, _together(base, new), known, written=True)
    raise_all(CompwrightError, _wrong(planned, before, after))
    return CrossOutcome(
        planned=tuple(planned),
        written=True,
        files=files,
        after=after,
        totals=_totals(planned, after, axes),
        steps=tuple(
            step for entry in planned for step in _written_steps(entry, new, before, after)
        ),
    )


def _written(
    control: Control,
    planned: Sequence[PlannedCross],
    state: ControlState,
    base: Sequence[ControlFile],
) -> tuple[ControlFile, ...]:
    """Return the files of ``base`` that change, and new ones under names that no file of ``base``
    has.

    A new file may be called like one that a former round left in the control: it must not stand in
    for that one.
    """
    marked = [replace(file, name=_OWN + file.name) for file in base]
    taken = {file.name for file in base}
    files = []
    for file in write_cross(
        control.definition, [entry.added for entry in planned], control.options, state, marked
    ):
        name = file.name.removeprefix(_OWN)
        stem, dot, ending = name.rpartition(".")
        number = 2
        while file.name == name and name in taken:
            name, number = f"{stem}_{number}{dot}{ending}", number + 1
        taken.add(name)
        files.append(replace(file, name=name))
    return tuple(files)


def _together(first: Sequence[ControlFile], then: Sequence[ControlFile]) -> tuple[ControlFile, ...]:
    """Return the files of both, those of ``then`` in place of others of their name."""
    return tuple({file.name: file for file in (*first, *then)}.values())


def _read(
    control: Control, files: tuple[ControlFile, ...], axes: Sequence[Axis]
) -> DecodedState | None:
    return decode(control, files, axes) if files else None


def _wrong(
    planned: Sequence[PlannedCross], before: DecodedState | None, after: DecodedState | None
) -> list[Fault]:
    """Return a fault for every pair of axes that does not read back as before plus what was
    planned.
    """
    faults = []
    old = (
        {}
        if before is None
        else {(entry.input, entry.output): entry for entry in judged_cross(before)}
    )
    new = (
        {}
        if after is None
        else {(entry.input, entry.output): entry for entry in judged_cross(after)}
    )
    for pair in dict.fromkeys((*old, *new)):
        mine = [entry.added for entry in planned if (entry.added.input, entry.added.output) == pair]
        where = np.unique(
            np.concatenate([entry.positions for entry in (*_of(old, pair), *_of(new, pair), *mine)])
        )
        for direction in Direction:
            wanted = sum(
                (entry.at(where, direction) for entry in (*_of(old, pair), *mine)),
                np.zeros(where.size),
            )
            found = sum(
                (entry.at(where, direction) for entry in _of(new, pair)), np.zeros(where.size)
            )
            worst = float(np.max(np.abs(found - wanted)))
            if worst > READ_BACK:
                message = (
                    f"what {pair[0]} does to {pair[1]} does not come back as it was written; please"
                    " report this"
                )
                faults.append(
                    Fault(
                        message=message,
                        place=f"direction {direction.value}",
                        found=f"a difference of {worst:.3g}",
                    )
                )
    return faults


def _of(
    tables: Mapping[tuple[str, str], CrossCompensation], pair: tuple[str, str]
) -> tuple[CrossCompensation, ...]:
    return (tables[pair],) if pair in tables else ()


def _totals(
    planned: Sequence[PlannedCross], after: DecodedState | None, axes: Mapping[str, Axis]
) -> tuple[CrossCompensation, ...]:
    names = {axis.address: name for name, axis in axes.items()}
    mine = {(entry.added.input, entry.added.output) for entry in planned}
    return tuple(
        replace(
            entry,
            input=names.get(entry.input, entry.input),
            output=names.get(entry.output, entry.output),
        )
        for entry in (() if after is None else judged_cross(after))
        if (entry.input, entry.output) in mine
    )


def _typed(
    control: Control,
    planned: Sequence[PlannedCross],
    tables: tuple[ControlFile, ...],
    as_found: DecodedState,
    axes: Mapping[str, Axis],
    tabled: Collection[str],
) -> CrossOutcome:
    """Return the columns that the engineer types into the table of the moving axis: its text form
    and sign are unconfirmed.

    A column acts on an axis only while tables are selected for that axis, and then its linear error
    is dead: an axis that the linear error corrects gets no column, and that is said.
    """
    findings: list[Finding] = []
    steps: list[Mapping[str, str]] = []
    sheets = []
    for entry in planned:
        why = _by_line(control, entry, as_found, axes, tabled)
        if why:
            refused = _not_held(control, [entry], (), why)
            findings.extend(refused.findings)
            steps.extend(refused.steps)
            continue
        form = _table_values(control, axes.get(entry.input))
        sheets.append(_column_sheet(entry, form))
        message = (
            f"{_label(entry)} is in no file: type it into {_column(entry)},"
            f" {_shown_rows(entry, form)} (values are {form}s), as the card and its sheet say; the"
            " sign is unconfirmed."
        )
        findings.append(Finding("CW-P113", "warning", message))
        select = _parameter(control, "enabled")
        steps.append(
            {
                "title": f"{entry.output} over {entry.input}: type in",
                "text": (
                    f"{_label(entry)}. Add to what stands in {_column(entry)}, on a straight line"
                    f" between: {_shown_rows(entry, form)} (values are {form}s). "
                    + (
                        f"It acts on {entry.output} only while the bit of {entry.output} in"
                        f" {select} is 1. "
                        if select
                        else ""
                    )
                    + "The sign is unconfirmed: check it with a square or a dial gauge, on and off,"
                    " before production."
                ),
                "evidence": "unconfirmed",
            }
        )
    return CrossOutcome(
        planned=tuple(replace(entry, written=False) for entry in planned),
        files=tables,
        findings=tuple(findings),
        steps=tuple(steps),
        sheets=tuple(sheets),
    )


def _by_line(
    control: Control,
    entry: PlannedCross,
    as_found: DecodedState,
    axes: Mapping[str, Axis],
    tabled: Collection[str],
) -> str:
    """Return why a column cannot act on its axis: the linear error of that axis acts, now or by
    this job; empty where it can.
    """
    axis, linear = axes.get(entry.output), _parameter(control, "slope")
    if axis is None:
        return ""
    own = axis_options(control.definition, control.options, axis)
    old = as_found.state.axes.get(axis.address)
    if own.get("method") == "line":
        why = f"the job corrects {axis.name} by {linear} (method: line)"
    elif entry.output not in tabled and old is not None and old.slope != 0.0:
        why = f"{linear} acts on {axis.name} now ({-old.slope * 1e3:+.3f} mm/m)"
    else:
        return ""
    return (
        f"{why}, and a column acts only where tables do, never beside {linear}; give {axis.name} a"
        " test and a table of its own"
    )


def _parameter(control: Control, quantity: str) -> str:
    """Return the control's name of a parameter; empty where it has none."""
    return (
        parameter_name(control.definition, quantity)
        if quantity in control.definition.bindings
        else ""
    )


def _table_values(control: Control, moving: Axis | None) -> str:
    """Return what the values of a table are: the table is the moving axis' own, and so is the
    option.
    """
    return str(axis_options(control.definition, control.options, moving)["table_values"])


def _column(entry: PlannedCross) -> str:
    return f"the table (.COM) of {entry.input}, column of {entry.output}"


def _column_rows(entry: PlannedCross, form: str) -> list[tuple[float, float]]:
    sign = -1.0 if form == "error" else 1.0
    return [
        (float(x), sign * float(c))
        for x, c in zip(entry.added.positions, entry.added.positive, strict=True)
    ]


def _shown_rows(entry: PlannedCross, form: str) -> str:
    rows = _column_rows(entry, form)
    shown = rows if len(rows) <= _MOST_SHOWN else [rows[0], rows[-1]]
    return ", ".join(
        f"{value + 0.0:+.4f} {entry.added.output_kind.unit} at {position:g}"
        for position, value in shown
    )


def _column_sheet(entry: PlannedCross, form: str) -> ControlFile:
    head = f"# column of {entry.output} in the table of {entry.input}\n# value: {form}\n"
    head += f"position_{entry.input},{entry.output},unit\n"
    unit = entry.added.output_kind.unit
    body = "".join(
        f"{position:.4f},{value + 0.0:.4f},{unit}\n"
        for position, value in _column_rows(entry, form)
    )
    return ControlFile(f"cross_{entry.input}_{entry.output}.csv", (head + body).encode())


def _straightness(
    control: Control,
    planned: Sequence[PlannedCross],
    tables: tuple[ControlFile, ...],
    axes: Mapping[str, Axis],
) -> CrossOutcome:
    """Return the parameters of FANUC's straightness compensation as sheets: all from memory, none
    confirmed by a page.

    Two points of the moving axis' pitch numbers, the amounts absolute in detection units of the
    compensated axis: a straight line. A curve, an axis without a table and a second pair are said
    instead.
    """
    read = decode(control, tables, list(axes.values())) if tables else None
    findings: list[Finding] = []
    steps: list[dict[str, str]] = []
    sheets: list[ControlFile] = []
    for entry in planned:
        added, facts = (
            entry.added,
            ({} if read is None else read.state.facts.get(entry.added.input, {})),
        )
        bent = axes.get(entry.output)
        unit = (
            None
            if bent is None
            else axis_options(control.definition, control.options, bent).get("detection_unit")
        )
        first, last = (facts.get(name) for name in ("first_number", "last_number"))
        nodes = (
            read.state.axes[added.input].positions
            if read is not None and added.input in read.state.axes
            else np.empty(0)
        )
        if added.positions.size > 2 or nodes.size < 2 or sheets or not isinstance(unit, float):
            return _not_held(
                control,
                planned,
                tables,
                "straightness compensation is known for one straight line over a table only",
            )
        low, high = (
            float(added.at(nodes[[place]], Direction.POSITIVE)[0]) / unit for place in (1, -1)
        )
        rows = [
            ("5711", added.input, "moving axis"),
            ("5721", added.output, "compensated axis"),
            *((number, str(first), "point number at the - end") for number in ("5731", "5732")),
            *((number, str(last), "point number at the + end") for number in ("5733", "5734")),
            *((number, f"{low:.0f}", "amount, detection units") for number in ("5761", "5762")),
            *((number, f"{high:.0f}", "amount, detection units") for number in ("5763", "5764")),
        ]
        body = "".join(f"{number},{value},{what}\n" for number, value, what in rows)
        head = (
            "# straightness compensation: numbers and signs UNCONFIRMED, from memory; check each in"
            " the manual of the control\n"
        )
        name = f"straightness_{entry.input}_{entry.output}.csv"
        sheets.append(ControlFile(name, f"{head}parameter,value,meaning\n{body}".encode()))
        message = (
            f"{_label(entry)} is in no file: its parameters stand in {name} beside the card, all"
            " unconfirmed."
        )
        findings.append(Finding("CW-P113", "warning", message))
        text = (
            f"{message} Prove the sign with a square or a dial gauge, on and off, before"
            " production."
        )
        steps.append(
            {
                "title": f"{entry.output} over {entry.input}: type in",
                "text": text,
                "evidence": "unconfirmed",
            }
        )
    return CrossOutcome(
        planned=tuple(replace(entry, written=False) for entry in planned),
        files=tables,
        findings=tuple(findings),
        steps=tuple(steps),
        sheets=tuple(sheets),
    )


def _not_held(
    control: Control,
    planned: Sequence[PlannedCross],
    tables: tuple[ControlFile, ...],
    why: str,
) -> CrossOutcome:
    findings, steps = [], []
    for entry in planned:
        helps = _matrixkins(entry) if control.id.startswith("linuxcnc") else why
        message = (
            f"{_label(entry)} is not corrected: this control, as the job describes it, cannot hold"
            f" it; {helps}."
        )
        findings.append(Finding("CW-P113", "error", message))
        steps.append(
            {
                "title": f"Not corrected: {_label(entry)}",
                "text": f"{helps}.",
                "evidence": "inferred",
            }
        )
    return CrossOutcome(
        planned=tuple(replace(entry, written=False) for entry in planned),
        files=tables,
        findings=tuple(findings),
        steps=tuple(steps),
    )


def _label(entry: PlannedCross) -> str:
    what = "squareness" if entry.source == "circle" else "the measured deviation"
    return f"{what} of {entry.output} over {entry.input} ({entry.squareness * 1e6:+.1f} µm/m)"


def _instead(control: Control) -> str:
    return next(
        (text for start, text in _INSTEAD.items() if control.id.startswith(start)),
        "it has no tables between axes",
    )


def _matrixkins(entry: PlannedCross) -> str:
    """Return the values of LinuxCNC's matrixkins: joint of the bent axis = ... + C * position of
    the other one.

    Its leaning angle is minus squareness, and C is minus that angle.
    """
    pin = f"matrixkins.C_{entry.output.lower()}{entry.input.lower()}"
    added = entry.added
    constant = entry.squareness * float(added.positions[0]) - float(
        added.positive[0]
    )  # the line runs through machine zero
    away = (
        f", which also moves {entry.output} as a whole by {constant * 1e3:+.2f} µm"
        if abs(constant) > READ_BACK
        else ""
    )
    return (
        f"with the kinematics matrixkins (LinuxCNC 2.10) add {entry.squareness:+.9f} to the value"
        f" of {pin} that is in force{away}; without it this control has no place for it"
    )


def _written_steps(
    entry: PlannedCross,
    new: Sequence[ControlFile],
    before: DecodedState | None,
    after: DecodedState,
) -> list[dict[str, str]]:
    """Return how the new tables between two axes get into a SINUMERIK: sign first, then the data,
    the switches last.

    Tables of the same axes that were there before are none of ours, and stay as they are.
    """
    added = entry.added
    pair = (added.input, added.output)
    others = {} if before is None else tables_in(before.state.facts)
    mine = [
        str(index)
        for index, axes in sorted(tables_in(after.state.facts).items())
        if axes == pair and index not in others
    ]
    tables = " and ".join(mine)
    which = f"table {tables}" if len(mine) == 1 else f"tables {tables}"
    each = "it" if len(mine) == 1 else "each of them"
    named = " and ".join(file.name for file in new)
    own_unit = added.output_kind.unit
    factor, unit = outside_factor(own_unit), shown_unit(own_unit)
    ends = ", ".join(
        f"{value * factor:+.2f} {unit} at {entry.input} {position:g}"
        for position, value in zip(added.positions[[0, -1]], added.positive[[0, -1]], strict=True)
    )
    enable, switch = f"MD32710 $MA_CEC_ENABLE[{pair[1]}]", "SD41300 $SN_CEC_TABLE_ENABLE"
    label = f"{entry.output} over {entry.input}"
    texts = {
        "reserve and switch off": (
            f"MD18342 $MN_MM_CEC_MAX_POINTS must be at least {added.positions.size} for {which}."
            f" Set {enable} = 0 and {switch} = 0 for {which}, NEW CONF. Note what MD32710 was"
            f" before: if it was 0, find out what else sleeps on axis {pair[1]} (every other table"
            " with this output axis and a value that is not 0), and switch it off (SD41300 = 0)"
            " before anything else. MD32710 would wake it."
        ),
        "check the sign": (
            f"Before {named} is loaded: write 0.1 {own_unit} into every point of {which} and switch"
            f" {each} on for this check: MD32710, NEW CONF, SD41300, NEW CONF, NCK reset. A dial"
            f" gauge on {pair[1]} must show +0.1 {own_unit} for cec_sign: correction, -0.1"
            f" {own_unit} for cec_sign: error. If it does not: load nothing, and run again with the"
            " other one. Write 0 again and switch off as in the step before."
        ),
        "load": (
            f"Load {named}. {_capital(_label(entry))}: {entry.output} is moved by {ends}, 0 at the"
            f" reference of {entry.input}."
        ),
        "switch on": (
            f"If MD32710 was 0 before: SD41300 = 0 for what else sleeps on axis {pair[1]}, first."
            f" Set {enable} = 1, NEW CONF, then {switch} = 1 for {which}, NEW CONF, NCK reset. Work"
            f" offsets of {entry.output} shift with {entry.input}: probe them again. Hold the"
            " result against a square or a dial gauge before production."
        ),
    }
    return [
        {"title": f"{label}: {title}", "text": text, "evidence": "inferred"}
        for title, text in texts.items()
    ]


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
