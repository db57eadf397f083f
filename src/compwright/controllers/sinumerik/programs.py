"""Whether the assignments of a SINUMERIK's programs count: all of them were carried out, or it is
asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from compwright.controllers.request import Request
from compwright.controllers.sinumerik.axes import AxisNames
from compwright.controllers.sinumerik.flow import Block, Doubt
from compwright.controllers.sinumerik.text import Assignment, FileContent
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all

_EXPORT = "the control's own export of the data in place of the program"


def check_programs(
    contents: Sequence[FileContent], names: AxisNames, request: Request, *, inch: bool
) -> None:
    """Raise InputError for programs that assign one variable in two branches or count lengths in
    another unit than the control (``inch``), UsageError where nobody says that all of a program's
    assignments were carried out. Programs that speak of other axes alone stop nothing.
    """
    faults: list[Fault] = []
    questions: list[Fault] = []
    for content in contents:
        entries = {one.line: names.renamed(one) for one in content.assignments}
        for block in content.blocks:
            given = [entry for line, entry in entries.items() if line in block.branches]
            concerned = not given or any(
                not entry.axis or request.asks_for(entry.axis) for entry in given
            )
            if not (block.branches and concerned):
                continue
            faults += _other_lengths(content.name, block, inch=inch)
            if request.carried_out:
                faults += _in_two_branches(block, given)
            elif block.unsure is not None:
                questions.append(_unsure(content.name, block.unsure))
    raise_all(InputError, faults)
    raise_all(UsageError, questions)


def _other_lengths(file: str, block: Block, *, inch: bool) -> Iterator[Fault]:
    for line, inches in block.inches.items():
        if inches is not inch:
            yield Fault(
                message="a program in another unit of lengths than the control",
                file=file,
                place=f"line {line}",
                expected=_EXPORT,
                found="inch" if inches else "mm",
            )


def _in_two_branches(block: Block, given: Sequence[Assignment]) -> Iterator[Fault]:
    seen: dict[str, Assignment] = {}
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
        expected=f"{_EXPORT}, or active: yes where all of them were carried out",
        found=first.text,
    )
