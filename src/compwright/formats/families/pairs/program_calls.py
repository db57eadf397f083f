"""Calls between the programs of a control: which programs are executed, and which of several
assignments to the same variable is executed last.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.pairs.program_flow import (
    Call,
    FlowLine,
    ProgramFlow,
    Scanned,
    scanned,
)
from compwright.formats.families.pairs.program_runs import ProgramRuns
from compwright.formats.text.addresses import Key, entry_key
from compwright.formats.text.gathering import Gathered
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile


@dataclass(frozen=True, slots=True)
class StartDoubt:
    """A line because of which it is uncertain whether a program is executed at all.

    ``call``: the line that calls the program, if its call is in doubt.
    """

    file: str
    line: FlowLine
    call: FlowLine | None = None


@dataclass(frozen=True, slots=True)
class Found:
    """A program in a file, with reasons to doubt that the control executed it.

    - ``computed``: faults of values that are calculated when the program runs.
    - ``start``: the reason why the whole program was possibly not executed.
    - ``called``: another program calls this one.
    - ``loaders``: names of all programs in the files that assign values themselves or by calls.
    """

    file: str
    program: ProgramFlow
    computed: tuple[Fault, ...] = ()
    start: StartDoubt | None = None
    called: bool = False
    loaders: frozenset[str] = frozenset()

    @property
    def ways(self) -> ProgramRuns:
        """The possible runs through the program: each is a sequence of executed lines."""
        return self.program.ways(self.loaders)

    @property
    def doubted(self) -> bool:
        """Whether some lines of the program that assign values were possibly not executed."""
        return bool(self.program.values) and (self.start is not None or bool(self.program.flow))

    @property
    def forks(self) -> bool:
        """Whether a statement, such as a jump, can skip a line of the program that sets a value or
        calls a program.
        """
        return bool(self.program.flow) or any(call.doubt for call in self.program.calls)


def programs_of(definition: Definition, files: Sequence[ControlFile]) -> tuple[Found, ...]:
    """Return the programs in ``files`` that assign values, or that call programs which assign
    values.
    """
    names, returning = frozenset[str](), frozenset[str]()
    while True:
        read = [(file.name, _scanned(definition, file, names, returning)) for file in files]
        found = [(file, program) for file, one in read for program in one.programs]
        count = Counter(program.name for _, program in found if program.name)
        called = {call.name for _, program in found for call in program.calls}
        back = frozenset(
            one.name
            for _, one in found
            if one.name in called and count[one.name] == 1 and one.ways(frozenset()).returns()
        )
        if (frozenset(count), back if names else returning) == (names, returning):
            break
        names, returning = frozenset(count), back if names else returning
    starts = _start_doubts(found, count)
    loaders = _loaders([program for _, program in found])
    seen = set[str]()
    result = []
    for place, (file, program) in enumerate(found):
        own = () if file in seen else next(one.computed for name, one in read if name == file)
        seen.add(file)
        result.append(Found(file, program, own, starts.get(place), program.name in called, loaders))
    return tuple(result)


def _scanned(
    definition: Definition, file: ControlFile, names: frozenset[str], returning: frozenset[str]
) -> Scanned:
    """Return the programs in a file, with their calls of the programs ``names``. ``returning``:
    those whose call changes nothing in what is executed after it.
    """
    content = file.content.upper() if names else b""
    known = frozenset(one for one in names if one.encode() in content)
    return scanned(definition, file, known, known & returning)


def _loaders(programs: Sequence[ProgramFlow]) -> frozenset[str]:
    found = frozenset[str]()
    while True:
        new = frozenset(
            one.name
            for one in programs
            if one.name and (one.values or any(call.name in found for call in one.calls))
        )
        if new == found:
            return found
        found = new


def _start_doubts(
    programs: Sequence[tuple[str, ProgramFlow]], count: Mapping[str, int]
) -> dict[int, StartDoubt]:
    """Return, by program index, the line because of which it is uncertain that a program is
    executed; programs that are certainly executed are left out. ``count``: the number of programs
    with each name.
    """
    sites: dict[str, list[tuple[int, Call]]] = {}
    for place, (_, program) in enumerate(programs):
        for call in program.calls:
            sites.setdefault(call.name, []).append((place, call))
    sure: set[int] = set()
    while True:
        before = len(sure)
        for place, (_, program) in enumerate(programs):
            own = sites.get(program.name, [])
            by_call = any(by in sure and call.doubt is None for by, call in own)
            if (by_call and count[program.name] == 1) or not (own or program.called):
                sure.add(place)
        if len(sure) == before:
            break

    def doubt(place: int, behind: frozenset[int]) -> StartDoubt:
        file, program = programs[place]
        if program.called is not None:
            return StartDoubt(file, program.called)
        by, call = sites[program.name][0]
        if call.doubt is not None or by in sure or by in behind:
            return StartDoubt(programs[by][0], call.doubt or call.at, call.at)
        above = doubt(by, behind | {place})
        return replace(above, call=above.call or call.at)

    return {i: doubt(i, frozenset({i})) for i in range(len(programs)) if i not in sure}


@dataclass(slots=True)
class CallEnds:
    """The last assignment of each variable, provided that a program executes all its lines and all
    programs that it calls.
    """

    gathered: Gathered
    by_name: Mapping[str, Found]
    known: dict[str, dict[Key, tuple[str, Occurrence]]] = field(default_factory=dict)

    def key(self, value: Occurrence) -> Key:
        """Return the variable to which a line assigns, with index and axis."""
        return entry_key(self.gathered.definition, value, self.gathered.names)

    def of(self, found: Found) -> dict[Key, tuple[str, Occurrence]]:
        """Return the last assignment of each variable when a program and its calls are executed."""
        program, ends = found.program, dict[Key, tuple[str, Occurrence]]()
        self.known[program.name] = {}  # a call of itself
        lines: list[tuple[int, Occurrence | Call]] = [
            *((value.line, value) for value in program.values),
            *((call.at.line, call) for call in program.calls),
        ]
        for _, one in sorted(lines, key=lambda entry: entry[0]):
            if isinstance(one, Occurrence):
                ends[self.key(one)] = found.file, one
            elif one.name in self.known:
                ends |= self.known[one.name]
            elif one.name in self.by_name:
                ends |= self.of(self.by_name[one.name])
        self.known[program.name] = ends
        return ends
