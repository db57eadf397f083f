"""Check that all assignments in a SINUMERIK's programs were executed; if that is uncertain, ask the
user.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.calls import PlacedBlock, ProgramCalls
from compwright.controllers.sinumerik.flow import ProgramBlock
from compwright.controllers.sinumerik.reachable_lines import Doubt, conflicts, unclear_jumps
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all

_EXPORT = "the control's own export of the data in place of the program"


def check_programs(
    contents: Sequence[ProgramContent], names: MachineAxisNames, request: Request, *, inch: bool
) -> None:
    """Check that every run of the programs executes all assignments to the job's axes. ``inch``:
    the control's basic system is inch.

    Raises InputError for a variable that is assigned in two branches, and for assignments that no
    run executes together. Raises InputError also for a jump to an ambiguous label, and for a unit
    of lengths other than the control's. Raises UsageError if the job does not state whether all
    assignments were executed.
    """
    questions: list[Fault] = []
    calls = ProgramCalls.among(contents)
    renamed = {
        (one.file, one.line): names.renamed(one)
        for content in contents
        for one in content.assignments
    }
    faults = [
        one.fault(
            f"{one.axis} may be a variable: no list of axis names has it",
            expected="a machine axis of MD10000, or one of MD20080",
        )
        for one in renamed.values()
        if one.axis and not names.is_machine_axis(one.axis)
    ]
    faults += _out_of_order(calls, renamed, request)
    for placed in calls.blocks:
        content, block = placed.content, placed.block
        given = [renamed[content.name, one.line] for one in placed.assignments]
        concerned = not given or any(
            not entry.axis or request.is_under_work(entry.axis) for entry in given
        )
        if not ((block.branches and concerned) or calls.calls_of(block) or calls.is_called(block)):
            continue
        faults += _other_lengths(content.name, block, inch=inch)
        faults += _unclear(calls, placed)
        doubts = [(content.name, one) for one in calls.doubts(block)]
        reason = calls.not_started(placed) or next(iter(doubts), None)
        if request.carried_out:
            faults += list(_in_two_branches(block, given)) or _not_all(placed, calls)
        elif reason is not None and block.branches:
            questions.append(_question(*reason, calls))
    raise_all(InputError, faults)
    raise_all(UsageError, questions)


def without_programs(contents: Sequence[ProgramContent]) -> list[ProgramContent]:
    """Return the contents without the assignments of programs that may not have been executed, for
    a job that states ``active: no``.

    Raises InputError if every run of a program executes some of these assignments, and for a jump
    to an ambiguous label.
    """
    faults: list[Fault] = []
    found = []
    calls = ProgramCalls.among(contents)
    unsure = []
    for placed in calls.blocks:
        started = calls.not_started(placed) is None
        if not started or calls.doubts(placed.block):
            unsure.append(placed.block)
        if calls.in_doubt(placed.block):
            faults += _unclear(calls, placed)
            lines = calls.loads(placed) if started else []
            faults += [_always(placed.content.name, lines)] if lines else []
    for content in contents:
        gone = [block for block in content.blocks if any(block is one for one in unsure)]
        given = {line for block in gone for line in block.branches}
        kept = [one for one in content.assignments if one.line not in given]
        blocks = [block for block in content.blocks if not any(block is one for one in gone)]
        found.append(replace(content, assignments=kept, blocks=blocks))
    raise_all(InputError, faults)
    return found


def _always(file: str, lines: Sequence[int]) -> Fault:
    more = ", ".join(str(line) for line in lines[1:])
    return Fault(
        message=(
            "the answer `active: no` (the control executed no line) cannot be right: every run of "
            "the program assigns a compensation other than 0 in this line"
            f"{f' and in line {more}' if more else ''}"
        ),
        file=file,
        place=f"line {lines[0]}",
        expected=_EXPORT,
        hint=(
            "export the compensation data from the control, then give that "
            "file instead of the program"
        ),
    )


def _unclear(calls: ProgramCalls, placed: PlacedBlock) -> Iterator[Fault]:
    for line in unclear_jumps(placed.block.trail) if calls.in_doubt(placed.block) else ():
        yield Fault(
            message=("this line may jump to several labels of the program"),
            file=placed.content.name,
            place=f"line {line}",
            expected=_EXPORT,
            hint=(
                "export the compensation data from the control, then give that "
                "file instead of the program"
            ),
        )


def _out_of_order(
    calls: ProgramCalls,
    renamed: Mapping[tuple[str, int], VariableAssignment],
    request: Request,
) -> Iterator[Fault]:
    """Yield a fault for each variable whose last assignment in the files is not the last that the
    programs execute.
    """
    by_line: dict[str, VariableAssignment] = {}
    by_call: dict[str, VariableAssignment] = {}
    for placed in calls.blocks:
        by_line |= {one.variable.upper(): one for one in placed.assignments}
        by_call |= {} if calls.is_called(placed.block) else calls.lasts(placed)
    for variable, last in by_call.items():
        other, axis = by_line[variable], renamed[last.file, last.line].axis
        if (other.value, other.names) != (last.value, last.names) and (
            not axis or request.is_under_work(axis)
        ):
            yield last.fault(
                f"{last.variable} is assigned in {other.file}, line {other.line} too, and one of"
                " these programs calls the other: the last one in the files is not the last one"
                " that the control executes",
                expected=_EXPORT,
            )


def _not_all(placed: PlacedBlock, calls: ProgramCalls) -> Iterator[Fault]:
    """Yield a fault if no single run of a program can execute all its assignments and calls."""
    block = placed.block
    if not (calls.doubts(block) or calls.calls_of(block)):
        return
    pair = conflicts(calls.trail(block))
    if pair is not None:
        line, other = pair
        why = (
            f"a run that executes line {other} skips this line"
            if other
            else "no run executes this line"
        )
        why = "no run executes this line and every other assignment" if other == line else why
        yield Fault(
            message=f"the control cannot have executed the whole program: {why}",
            file=placed.content.name,
            place=f"line {line}",
            expected="a program whose lines are all executed in one run",
            hint=(
                "export the compensation data from the control and give that file, or set "
                "`active: no` in this entry of `states` if none of it was executed"
            ),
        )


def _other_lengths(file: str, block: ProgramBlock, *, inch: bool) -> Iterator[Fault]:
    for line, inches in block.inches.items():
        if inches is not inch:
            yield Fault(
                message="the program and the control use different units of length",
                file=file,
                place=f"line {line}",
                expected=_EXPORT,
                found=f"a program in {'inch' if inches else 'mm'}",
                hint=(
                    "export the compensation data from the control, then give that "
                    "file instead of the program"
                ),
            )


def _in_two_branches(block: ProgramBlock, given: Sequence[VariableAssignment]) -> Iterator[Fault]:
    seen: dict[str, VariableAssignment] = {}
    for entry in given:
        branch = block.branches[entry.line]
        before = seen.get(entry.variable.upper())
        if branch < 0:
            continue
        if before is not None and block.branches[before.line] != branch:
            yield entry.fault(
                f"{entry.variable} is assigned in another branch too (line {before.line}); the"
                " control executed only one of them",
                expected=_EXPORT,
            )
        seen[entry.variable.upper()] = entry


def _question(file: str, first: Doubt, calls: ProgramCalls) -> Fault:
    unknown = bool(first.call) and not calls.has(first.call)
    program = f"the file of {first.call} too, where it is a program, or " if unknown else ""
    return Fault(
        message=(
            "the control may not have executed the assignments of this program: this line can jump "
            "over them, or means that only another program starts this one"
        ),
        file=file,
        place=f"line {first.line}",
        expected=f"{program}{_EXPORT}, or the answer `active: yes` or `active: no`",
        found=first.text,
        hint=(
            "export the compensation data from the control and give that file, or state in this "
            "entry of `states` whether the control executed the program: `active: yes` (every "
            "line) or `active: no` (no line)"
        ),
    )
