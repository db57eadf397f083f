"""Programs among a control's files: whether the values in them were carried out is asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.activity import Activity
from compwright.formats.families.entry_keys import Key, entry_key
from compwright.formats.families.pairs.program_flow import EXPORTED, ProgramFlow, scanned
from compwright.formats.text.gathering import Gathered
from compwright.formats.text.notes import Notes
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile


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
    definition = gathered.definition

    def concerns(one: Occurrence) -> bool:
        axis = one.tokens.get("axis")
        return axis is None or not wanted or gathered.axis(axis.text) in wanted

    for file in files:
        found = scanned(definition, file)
        faults = list(found.computed)
        for program in found.programs:
            if not any(map(concerns, (*program.values, *program.behind))):
                continue
            faults += _never(file.name, program, unit)
            if not program.doubts:
                continue
            if not activity.carried_out:
                notes.ask(_question(file.name, program))
                continue
            lines = f"lines {program.values[0].line} to {program.values[-1].line}"
            fact = f"{file.name}: the values of the program in {lines}"
            notes.assume(fact, "all carried out", "the job's answer (active)")
            faults += _twice(gathered, file.name, program)
        for fault in faults:
            notes.once(fault)


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
    for line, said in program.units.items():
        if said != unit:
            yield Fault(
                message=f"the program counts lengths in {said} from here on, the control in {unit}",
                file=file,
                place=f"line {line}",
                expected=EXPORTED,
            )


def _question(file: str, program: ProgramFlow) -> Fault:
    """Return what has to be asked of a program: whether all of its values were carried out."""
    lines = f"lines {program.values[0].line} to {program.values[-1].line}"
    message = f"this line decides about those in {lines}"
    if program.called is not None:
        message = f"those in {lines} act only where a program calls or starts this one"
    doubts = program.doubts
    more = f" ({len(doubts) - 1} more such lines)" if len(doubts) > 1 else ""
    return Fault(
        message=f"the values of a program may not all have been carried out: {message}{more}",
        file=file,
        place=f"line {doubts[0].line}",
        expected=(
            f"{EXPORTED}; or, where every value of the program was carried out, states:"
            " {as_found: {files: [...], active: yes}} (without a job: --option active=yes)"
        ),
        found=repr(doubts[0].text),
    )
