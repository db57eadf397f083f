"""Whether the assignments of a SINUMERIK's programs count: all of them were carried out, or it is
asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.flow import ProgramBlock
from compwright.controllers.sinumerik.reach import Doubt, conflicts, inevitable
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all

#: Variables of which a value other than 0 acts on an axis.
_ACTING = frozenset({"AA_ENC_COMP", "AN_CEC", "MA_BACKLASH"})
_EXPORT = "the control's own export of the data in place of the program"


def check_programs(
    contents: Sequence[ProgramContent], names: MachineAxisNames, request: Request, *, inch: bool
) -> None:
    """Raise InputError for programs that assign one variable in two branches, cannot carry out all
    of their assignments, or count lengths in another unit than the control (``inch``); UsageError
    where the answer is missing whether they were. Programs of other axes alone stop nothing.
    """
    faults: list[Fault] = []
    questions: list[Fault] = []
    doubted = _doubted_calls(contents)
    for content in contents:
        entries = {one.line: names.renamed(one) for one in content.assignments}
        for block in content.blocks:
            given = [entry for line, entry in entries.items() if line in block.branches]
            concerned = not given or any(
                not entry.axis or request.asks_for(entry.axis) for entry in given
            )
            calls = any(line.mentions & doubted.keys() for line in block.trail)
            if not ((block.branches and concerned) or calls):
                continue
            faults += _other_lengths(content.name, block, inch=inch)
            first = block.unsure
            unsure = doubted.get(block.title) if first is None else (content.name, first)
            if request.carried_out:
                faults += list(_in_two_branches(block, given)) or _not_all(content, block, doubted)
            elif unsure is not None and block.branches:
                questions.append(_unsure(*unsure))
    raise_all(InputError, faults)
    raise_all(UsageError, questions)


def without_programs(contents: Sequence[ProgramContent]) -> list[ProgramContent]:
    """Return the contents without the assignments of programs that may not have been carried out,
    where it is known that none of them was. Raises InputError for what every run carries out.
    """
    faults: list[Fault] = []
    found = []
    doubted = _doubted_calls(contents)
    for content in contents:
        unsure = [one for one in content.blocks if one.unsure or one.title in doubted]
        lines = {line for block in unsure for line in block.branches}
        for block in unsure:
            if block.caller is None and block.title not in doubted:
                faults += _always(content, block)
        kept = [one for one in content.assignments if one.line not in lines]
        blocks = [block for block in content.blocks if block not in unsure]
        found.append(replace(content, assignments=kept, blocks=blocks))
    raise_all(InputError, faults)
    return found


def _always(content: ProgramContent, block: ProgramBlock) -> Iterator[Fault]:
    lines = inevitable(block.trail)
    for one in content.assignments:
        if one.line in lines and one.name in _ACTING and one.value != 0.0:
            yield one.fault(
                f"{one.variable} is assigned in every run of the program, whatever it meets",
                expected=f"{_EXPORT}; active: no is for programs of which nothing was carried out",
            )
            return


def _doubted_calls(contents: Sequence[ProgramContent]) -> dict[str, tuple[str, Doubt]]:
    """Return by the name of a program the file and the line that may keep every call of it in these
    files from being carried out.
    """
    sure: set[str] = set()
    found: dict[str, tuple[str, Doubt]] = {}
    titles = {one.title for content in contents for one in content.blocks if one.title}
    while True:
        before = set(found)
        for content in contents:
            for block in content.blocks:
                for line in block.trail:
                    for name in line.mentions & titles:
                        doubt = (content.name, line.before) if line.before else None
                        doubt = doubt or found.get(block.title)
                        if doubt is None:
                            sure.add(name)
                        else:
                            found.setdefault(name, doubt)
        found = {name: doubt for name, doubt in found.items() if name not in sure}
        if set(found) == before:
            return found
        sure = set()


def _not_all(
    content: ProgramContent, block: ProgramBlock, doubted: Mapping[str, object]
) -> Iterator[Fault]:
    """Yield the fault of assignments, or calls, of which one run cannot carry out all."""
    if not block.doubts and not any(line.mentions & doubted.keys() for line in block.trail):
        return
    trail = [
        replace(line, given=True) if line.mentions & doubted.keys() else line
        for line in block.trail
    ]
    pair = conflicts(trail)
    if pair is not None:
        line, other = pair
        why = f"every run that comes to line {other} leaves it out" if other else "no run does"
        yield Fault(
            message=f"not all of the program was carried out: of this line, {why}",
            file=content.name,
            place=f"line {line}",
            expected=f"{_EXPORT}, or active: no where nothing of it was carried out",
        )


def _other_lengths(file: str, block: ProgramBlock, *, inch: bool) -> Iterator[Fault]:
    for line, inches in block.inches.items():
        if inches is not inch:
            yield Fault(
                message="a program in another unit of lengths than the control",
                file=file,
                place=f"line {line}",
                expected=_EXPORT,
                found="inch" if inches else "mm",
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
                " control carried out one of them",
                expected=_EXPORT,
            )
        seen[entry.variable.upper()] = entry


def _unsure(file: str, first: Doubt) -> Fault:
    return Fault(
        message=(
            "this line may keep assignments of the program from being carried out, or says that"
            " another program has to call this one"
        ),
        file=file,
        place=f"line {first.line}",
        expected=(
            f"{_EXPORT}, or active: yes where all of them were carried out, active: no where none"
            " was"
        ),
        found=first.text,
    )
