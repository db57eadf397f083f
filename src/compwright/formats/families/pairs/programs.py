"""Programs among a control's files: decide, or ask, whether the values in them were executed."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.activity import Activity
from compwright.formats.families.pairs.program_calls import CallEnds, Found, programs_of
from compwright.formats.families.pairs.program_flow import EXPORTED, ProgramFlow
from compwright.formats.text.addresses import Key, entry_key, quantities_of, value_of
from compwright.formats.text.gathering import Gathered
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.correction import ControlFile

#: Quantities of which a value other than 0 is active on an axis.
_CORRECTING = frozenset({"value", "backlash", "cross_value"})


def not_carried_out(
    definition: Definition, files: Sequence[ControlFile]
) -> tuple[tuple[ControlFile, ...], tuple[Finding, ...]]:
    """Return ``files`` without the programs that, by the job, were not executed, and a finding for
    each file left out.

    Raises InputError if the job's answer cannot be right: every run of the program executes one of
    its values. Raises InputError too for a file that also contains values to which the answer does
    not apply.
    """
    kept: list[ControlFile] = []
    findings: list[Finding] = []
    programs = programs_of(definition, files)
    faults = list(_executed_in_any_case(definition, programs))
    for file in files:
        own = [one for one in programs if one.file == file.name and one.program.values]
        doubted = [one for one in own if one.doubted]
        faults += [fault for one in doubted for fault in _unclear(one)]
        if not doubted:
            kept.append(file)
        elif len(doubted) < len(own):
            faults.append(_two_kinds(doubted[0]))
        else:
            findings.append(Finding.of("CW-S073", "warning", file=file.name))
    raise_all(InputError, faults)
    if findings and not any(_is_data(definition, file) for file in kept):
        kept = []  # programs that call others, and nothing else
    return tuple(kept), tuple(findings)


def _is_data(definition: Definition, file: ControlFile) -> bool:
    text = text_reader(definition).read(file, [])
    return text is None or bool(text.occurrences)


def _two_kinds(found: Found) -> Fault:
    return Fault(
        message=(
            f"`active: no` applies only to the values in {found.program.span}, but the file "
            "also contains other values, which are always in effect"
        ),
        file=found.file,
        place=f"line {found.program.values[0].line}",
        expected=f"the values in {found.program.span} in a file of their own, or {EXPORTED}",
        hint=(
            "export the compensation data from the control, then give that file "
            "instead of the program"
        ),
    )


def _executed_in_any_case(definition: Definition, programs: Sequence[Found]) -> Iterator[Fault]:
    """Yield a fault for each program that assigns a value other than 0 in every run."""
    correcting = {
        place: {one.line for one in found.program.values if _corrects(definition, one)}
        for place, found in enumerate(programs)
    }
    lines: dict[int, list[int]] = {}
    loading = set[str]()
    while True:
        for place, found in enumerate(programs):
            calls = {
                call.at.line
                for call in found.program.calls
                if call.name in loading and not call.conditional
            }
            if correcting[place] or calls:
                lines[place] = found.ways.unavoidable(correcting[place] | calls)
        new = {programs[place].program.name for place, some in lines.items() if some}
        if new == loading:
            break
        loading = new
    for place, found in enumerate(programs):
        if lines.get(place) and found.start is None and found.forks:
            first, *more = lines[place]
            others = f" or line {', '.join(map(str, more))}" if more else ""
            yield Fault(
                message=(
                    "the answer `active: no` (the control executed no line) cannot be right: every "
                    f"run of the program executes this line{others}, which sets a compensation "
                    "other than 0"
                ),
                file=found.file,
                place=f"line {first}",
                expected=f"{EXPORTED}; or `active: yes` if the control executed every line",
                hint=(
                    "export the compensation data from the control and give that file, or set "
                    "`active: yes` if the control executed every line"
                ),
            )


def _corrects(definition: Definition, value: Occurrence) -> bool:
    quantities = _CORRECTING.intersection(quantities_of(definition, value.statement))
    return bool(quantities) and value_of(value).strip("+-0.") != ""


def _unclear(found: Found) -> Iterator[Fault]:
    """Yield a fault for each jump to a label that occurs more than once."""
    for line in found.ways.unclear if found.forks else ():
        yield Fault(
            message="a jump in this line can lead to several lines, because the program "
            "contains its label more than once",
            file=found.file,
            place=f"line {line}",
            expected=EXPORTED,
            hint=(
                "export the compensation data from the control, then give that file "
                "instead of the program"
            ),
        )


def check_programs(
    gathered: Gathered,
    files: Sequence[ControlFile],
    wanted: Collection[str],
    unit: str,
    activity: Activity,
    notes: Notes,
) -> None:
    """Check whether the values in programs were executed, and ask the user if this is unknown.
    ``wanted``: addresses of the axes to check (empty: all); ``unit``: the control's length unit, mm
    or inch.

    Values of cross-axis tables are checked too. Two kinds of values are faults: those that no run
    executes, and those that two branches of a program assign.
    """

    def concerns(one: Occurrence) -> bool:
        axis = one.tokens.get("axis")
        return axis is None or not wanted or gathered.axis(axis.text) in wanted

    programs = programs_of(gathered.definition, files)
    for fault in (*_unlisted(gathered, programs), *_called_late(gathered, programs, concerns)):
        notes.once(fault)
    for found in programs:
        program, faults = found.program, list(found.computed)
        if program.calls or any(map(concerns, (*program.values, *program.behind))) or found.called:
            faults += [*_never(found, unit), *_unclear(found)]
            if activity.carried_out and found.doubted:
                fact = f"{found.file}: the values of the program in {program.span}"
                notes.assume(fact, "all carried out", "the job's answer (active)")
            if activity.carried_out:
                faults += list(_twice(gathered, found.file, program)) or _omitted_value(found)
            elif found.doubted:
                notes.ask(_question(found))
        for fault in faults:
            notes.once(fault)


def _unlisted(gathered: Gathered, programs: Sequence[Found]) -> Iterator[Fault]:
    """Yield a fault for each axis name in programs that no list of names contains, because it is
    possibly a variable.
    """
    names, seen = gathered.names, set[str]()
    for found in programs:
        for value in found.program.values if names.places else ():
            token = value.tokens.get("axis")
            if token is None:
                continue
            name = gathered.axis(token.text)
            if name in seen or names.known(name) or name in names.requested.values():
                continue
            seen.add(name)
            yield Fault(
                message=(
                    f"{name} is not an axis name in MD10000 or MD20080, so it may be a "
                    "variable of the program"
                ),
                file=found.file,
                place=f"line {value.line}",
                expected=f"the name of an axis in these lists, or {EXPORTED}",
                found=name,
                hint=(
                    "give the file with the complete list MD10000 with the control's other files,"
                    " or export the compensation data from the control and give that file"
                ),
            )


def _omitted_value(found: Found) -> Iterator[Fault]:
    """Yield a fault if no single run can execute all values and calls of a program."""
    program = found.program
    if not (program.flow or program.calls):
        return
    ways = found.ways
    for line, past in ways.unreached():
        yield Fault(
            message=(
                "the answer `active: yes` (the control executed every line) cannot be right: line "
                f"{past} of the program always jumps past this line"
            ),
            file=found.file,
            place=f"line {line}",
            expected=f"{EXPORTED}; or `active: no` if the control executed no line",
            hint=(
                "export the compensation data from the control and give that file, or set "
                "`active: no` if the control executed no line"
            ),
        )
        return
    pair = ways.exclusive()
    if pair is not None:
        yield Fault(
            message=(
                "the answer `active: yes` (the control executed every line) cannot be right: no "
                f"run of the program executes both line {pair[0]} and this line"
            ),
            file=found.file,
            place=f"line {pair[1]}",
            expected=EXPORTED,
            hint=(
                "export the compensation data from the control, then give that file "
                "instead of the program"
            ),
        )
        return
    left_out = ways.left_out()
    if left_out is not None:
        yield Fault(
            message=(
                "the answer `active: yes` (the control executed every line) cannot be right: no "
                "run of the program executes this line and also every other line that sets a "
                "value"
            ),
            file=found.file,
            place=f"line {left_out}",
            expected=f"{EXPORTED}; or `active: no` if the control executed no line",
            hint=(
                "export the compensation data from the control and give that file, or set "
                "`active: no` if the control executed no line"
            ),
        )


def _twice(gathered: Gathered, file: str, program: ProgramFlow) -> Iterator[Fault]:
    """Yield a fault for each variable that two branches of a program assign."""

    def key(one: Occurrence) -> Key:
        return entry_key(gathered.definition, one, gathered.names)

    for value, before in program.branches(key):
        statement, address, which = key(value)
        yield Fault(
            message=(
                f"this line and line {before} assign the same entry in two branches of a "
                "program, and only one of the two was executed"
            ),
            file=file,
            place=f"line {value.line}",
            expected=EXPORTED,
            found=" ".join(filter(None, (statement, address, *which))),
            hint=(
                "export the compensation data from the control, then give that file "
                "instead of the program"
            ),
        )


def _called_late(
    gathered: Gathered, programs: Sequence[Found], concerns: Callable[[Occurrence], bool]
) -> Iterator[Fault]:
    """Yield a fault for each variable whose final value depends on the order in which programs are
    called. ``concerns``: a function that returns whether a line concerns the axes to check.
    """
    if not any(one.program.calls for one in programs):
        return

    ends = CallEnds(gathered, {one.program.name: one for one in programs if one.program.name})
    in_order: dict[Key, tuple[str, Occurrence]] = {}
    written: dict[Key, tuple[str, Occurrence]] = {}
    for one in programs:
        written.update((ends.key(value), (one.file, value)) for value in one.program.values)
        in_order.update({} if one.called else ends.of(one))
    for which, (file, value) in in_order.items():
        other_file, other = written[which]
        if concerns(value) and value_of(value).upper() != value_of(other).upper():
            yield Fault(
                message=(
                    f"this line assigns the same entry as {other_file}, line {other.line}, and "
                    "the value that is valid depends on the order of the programs"
                ),
                file=file,
                place=f"line {value.line}",
                expected=EXPORTED,
                hint=(
                    "export the compensation data from the control, then give that file "
                    "instead of the programs"
                ),
            )


def _never(found: Found, unit: str) -> Iterator[Fault]:
    """Yield a fault for each statement because of which every run skips values, or because of which
    lengths are not in the control's ``unit``.
    """
    file, program = found.file, found.program
    if program.behind and program.ended is not None:
        yield Fault(
            message=(
                f"this line is after the end of the program (line {program.ended.line}), so "
                "the control does not execute its compensation data"
            ),
            file=file,
            place=f"line {program.behind[0].line}",
            expected=EXPORTED,
            found=repr(program.ended.text),
            hint=(
                "export the compensation data from the control, then give that file "
                "instead of the program"
            ),
        )
    last = program.values[-1].line if program.values else 0
    for line, unit_here in program.units.items():
        if (line < last or found.called) and unit_here != unit:
            yield Fault(
                message=(
                    f"from this line on the program counts lengths in {unit_here}, but the "
                    f"control counts in {unit}"
                ),
                file=file,
                place=f"line {line}",
                expected=EXPORTED,
                hint=(
                    "export the compensation data from the control, then give that file "
                    "instead of the program"
                ),
            )


def _question(found: Found) -> Fault:
    """Return the question whether all values of a program were executed."""
    program, start, lines = found.program, found.start, found.program.span
    file, doubts = found.file, program.flow
    message = f"this line decides about the assignments in {lines}"
    if start is not None and start.call is not None:
        message = f"this line decides about line {start.call.line}, the call of {found.file}"
        file, doubts = start.file, [start.line]
    elif start is not None:
        message = f"the assignments in {lines} are executed only if another program calls this one"
        file, doubts = start.file, [start.line, *doubts]
    more = f" ({len(doubts) - 1} more such lines)" if len(doubts) > 1 else ""
    missing = list(dict.fromkeys(one.missing for one in doubts if one.missing))
    files = f"{', '.join(missing)} among the files, where that is a program; " if missing else ""
    return Fault(
        message=(f"the control may not have executed the whole program: {message}{more}"),
        file=file,
        place=f"line {doubts[0].line}",
        expected=(
            f"{files}{EXPORTED}; or the answer `active: yes` or `active: no` in this entry of "
            "`states`"
        ),
        found=repr(doubts[0].text),
        hint=(
            "export the compensation data from the control and give that file, or state in this "
            "entry of `states` in the job whether the control executed the program: `active: yes` "
            "(every line) or `active: no` (no line) (without a job: `--option active=yes`)"
        ),
    )
