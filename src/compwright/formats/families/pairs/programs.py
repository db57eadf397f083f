"""Programs among a control's files: whether the values in them were carried out is asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.activity import Activity
from compwright.formats.families.entry_keys import Key, entry_key, quantities_of, value_of
from compwright.formats.families.pairs.program_flow import (
    EXPORTED,
    Call,
    FlowLine,
    ProgramFlow,
    Scanned,
    scanned,
)
from compwright.formats.text.gathering import Gathered
from compwright.formats.text.notes import Notes
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.correction import ControlFile

#: Quantities of which a value other than 0 acts on an axis.
_ACTING = frozenset({"value", "backlash", "cross_value"})


@dataclass(frozen=True, slots=True)
class DoubtedCall:
    """A call in ``file`` that ``doubt`` may keep from being carried out."""

    file: str
    call: Call
    doubt: FlowLine


@dataclass(frozen=True, slots=True)
class Found:
    """A program of ``file``. ``computed``: faults of values that only the running program knows;
    ``call``: where every call of it in another program may not be carried out, one of them.
    """

    file: str
    program: ProgramFlow
    computed: tuple[Fault, ...] = ()
    call: DoubtedCall | None = None

    @property
    def doubted(self) -> bool:
        """Whether some of its values may not have been carried out."""
        return bool(self.program.doubts) or (self.call is not None and bool(self.program.values))


def programs_of(definition: Definition, files: Sequence[ControlFile]) -> tuple[Found, ...]:
    """Return the programs among ``files`` that hold values, or call those that do."""
    names: frozenset[str] = frozenset()
    while True:
        read = [(file.name, _scanned(definition, file, names)) for file in files]
        new = frozenset(
            program.name
            for _, one in read
            for program in one.programs
            if program.name and program.called is None
        )
        if new <= names:
            break
        names |= new
    calls = _doubted_calls([(file, program) for file, one in read for program in one.programs])
    found = []
    for file, one in read:
        for i, program in enumerate(one.programs or ((ProgramFlow(),) if one.computed else ())):
            found.append(Found(file, program, () if i else one.computed, calls.get(program.name)))
    return tuple(found)


def _scanned(definition: Definition, file: ControlFile, names: frozenset[str]) -> Scanned:
    """Return what a file does, with its calls of those ``names`` that it mentions."""
    content = file.content.upper() if names else b""
    return scanned(definition, file, frozenset(one for one in names if one.encode() in content))


def _doubted_calls(programs: Sequence[tuple[str, ProgramFlow]]) -> dict[str, DoubtedCall]:
    """Return by program what keeps every call of it uncertain; a doubt about a program counts for
    its calls too.
    """
    found: dict[str, DoubtedCall] = {}
    while True:
        sites: dict[str, list[DoubtedCall | None]] = {}
        for file, program in programs:
            above = found.get(program.name)
            for call in program.calls:
                own = None if call.doubt is None else DoubtedCall(file, call, call.doubt)
                sites.setdefault(call.name, []).append(own or above)
        new = {name: each[0] for name, each in sites.items() if each[0] and all(each)}
        if new.keys() == found.keys():
            return new
        found = new


def not_carried_out(
    definition: Definition, files: Sequence[ControlFile]
) -> tuple[tuple[ControlFile, ...], tuple[Finding, ...]]:
    """Return ``files`` without those of which no value was carried out, as the job says (active:
    no), and the findings that name these (CW-S073).

    Raises InputError where that cannot be: a value that every run of the program carries out, and
    a file with other values, which it does not speak of.
    """
    kept: list[ControlFile] = []
    findings: list[Finding] = []
    faults: list[Fault] = []
    programs = programs_of(definition, files)
    for file in files:
        own = [one for one in programs if one.file == file.name and one.program.values]
        doubted = [one for one in own if one.doubted]
        for one in doubted:
            faults += _carried_out_anyhow(definition, one)
        if not doubted:
            kept.append(file)
        elif len(doubted) < len(own):
            faults.append(_two_kinds(doubted[0]))
        else:
            message = (
                f"{file.name}: the job says that none of its values was carried out (active: no)."
                " No table and no backlash of it count as loaded"
            )
            findings.append(Finding("CW-S073", "warning", message))
    raise_all(InputError, faults)
    return tuple(kept), tuple(findings)


def _two_kinds(found: Found) -> Fault:
    return Fault(
        message=(
            f"active: no speaks of the values in {found.program.span} alone; other values of the"
            " file are carried out in any case"
        ),
        file=found.file,
        place=f"line {found.program.values[0].line}",
        expected=f"the two in files of their own, or {EXPORTED}",
    )


def _carried_out_anyhow(definition: Definition, found: Found) -> Iterator[Fault]:
    """Yield the fault of a value other than 0 that every run of a doubted program carries out."""
    program = found.program
    if program.called is not None or found.call is not None:
        return
    certain = set(program.ways.certain())
    for value in program.values:
        acts = _ACTING.intersection(quantities_of(definition, value.statement))
        if value.line in certain and acts and value_of(value).strip("+-0."):
            yield Fault(
                message="active: no, but every run of the program carries out this value",
                file=found.file,
                place=f"line {value.line}",
                expected=f"{EXPORTED}; or active: yes where all of its values were carried out",
            )
            return


def check_programs(
    gathered: Gathered,
    files: Sequence[ControlFile],
    wanted: Collection[str],
    unit: str,
    activity: Activity,
    notes: Notes,
) -> None:
    """Ask whether the values of programs were carried out, where they are of an axis that is
    ``wanted`` (empty: of any) or of a table; refuse what is in no case, or in two branches.

    ``unit``: in which lengths stand, mm or inch.
    """

    def concerns(one: Occurrence) -> bool:
        axis = one.tokens.get("axis")
        return axis is None or not wanted or gathered.axis(axis.text) in wanted

    for found in programs_of(gathered.definition, files):
        program, faults = found.program, list(found.computed)
        if program.calls or any(map(concerns, (*program.values, *program.behind))):
            faults += _never(found.file, program, unit)
            if activity.carried_out and found.doubted:
                fact = f"{found.file}: the values of the program in {program.span}"
                notes.assume(fact, "all carried out", "the job's answer (active)")
            if activity.carried_out:
                faults += list(_twice(gathered, found.file, program)) or _left_out(found)
            elif found.doubted:
                notes.ask(_question(found))
        for fault in faults:
            notes.once(fault)


def _left_out(found: Found) -> Iterator[Fault]:
    """Yield the faults of values, or calls, that cannot all have been carried out."""
    program = found.program
    if not (program.flow or program.calls):
        return
    ways = program.ways
    for line, past in ways.unreached():
        yield Fault(
            message=(
                f"active: yes, but line {past} of the program leads past this line in any case:"
                " the control does not carry it out"
            ),
            file=found.file,
            place=f"line {line}",
            expected=f"{EXPORTED}; or active: no where none of the values was carried out",
        )
        return
    pair = ways.exclusive()
    if pair is not None:
        yield Fault(
            message=(
                f"active: yes, but no run of the program carries out both line {pair[0]} and this"
                " line"
            ),
            file=found.file,
            place=f"line {pair[1]}",
            expected=EXPORTED,
        )


def _twice(gathered: Gathered, file: str, program: ProgramFlow) -> Iterator[Fault]:
    """Yield the faults of entries that are assigned in two branches."""

    def key(one: Occurrence) -> Key:
        return entry_key(gathered.definition, one, gathered.names)

    for value, before in program.branches(key):
        statement, address, which = key(value)
        yield Fault(
            message=(
                f"the same entry is assigned here and in line {before}, in two branches of a"
                " program: not both were carried out"
            ),
            file=file,
            place=f"line {value.line}",
            expected=EXPORTED,
            found=" ".join(filter(None, (statement, address, *which))),
        )


def _never(file: str, program: ProgramFlow, unit: str) -> Iterator[Fault]:
    """Yield the faults of what a program does to its values in any case."""
    if program.behind and program.ended is not None:
        yield Fault(
            message=(
                f"compensation data behind the end of the program in line {program.ended.line}:"
                " the control does not carry them out"
            ),
            file=file,
            place=f"line {program.behind[0].line}",
            expected=EXPORTED,
            found=repr(program.ended.text),
        )
    last = program.values[-1].line if program.values else 0
    for line, said in program.units.items():
        if line < last and said != unit:
            yield Fault(
                message=f"the program counts lengths in {said} from here on, the control in {unit}",
                file=file,
                place=f"line {line}",
                expected=EXPORTED,
            )


def _question(found: Found) -> Fault:
    """Return what has to be asked of a program: whether all of its values were carried out."""
    file, program, lines = found.file, found.program, found.program.span
    doubts = program.doubts
    message = f"this line decides about those in {lines}"
    if program.called is not None:
        message = f"those in {lines} act only where a program calls or starts this one"
    elif not doubts and found.call is not None:
        message = f"this line decides about the call of {file} in line {found.call.call.at.line}"
        file, doubts = found.call.file, [found.call.doubt]
    more = f" ({len(doubts) - 1} more such lines)" if len(doubts) > 1 else ""
    return Fault(
        message=f"the values of a program may not all have been carried out: {message}{more}",
        file=file,
        place=f"line {doubts[0].line}",
        expected=(
            f"{EXPORTED}; or, where every value of the program was carried out, states:"
            " {as_found: {files: [...], active: yes}} (without a job: --option active=yes);"
            " active: no where none was"
        ),
        found=repr(doubts[0].text),
    )
