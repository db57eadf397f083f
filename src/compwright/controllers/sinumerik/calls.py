"""Calls between a SINUMERIK's programs: which calls are certainly executed, and which assignment of
a variable is executed last.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

from compwright.controllers.sinumerik.flow import ProgramBlock
from compwright.controllers.sinumerik.linked_conditions import EVERYTHING
from compwright.controllers.sinumerik.reachable_lines import Doubt, Line, always_returns, inevitable
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment

#: Variables that correct an axis where their value is not 0.
_COMPENSATING = frozenset({"AA_ENC_COMP", "AN_CEC", "MA_BACKLASH"})


@dataclass(frozen=True, slots=True)
class PlacedBlock:
    """A program and the contents of the file in which it is."""

    content: ProgramContent
    block: ProgramBlock

    @property
    def assignments(self) -> list[VariableAssignment]:
        """The assignments of the program, in the order of the lines."""
        lines = self.block.branches
        return [one for one in self.content.assignments if one.line in lines]


@dataclass(slots=True)
class ProgramCalls:
    """The programs in several files, and the calls between these programs."""

    blocks: list[PlacedBlock]
    _titles: dict[str, list[PlacedBlock]] = field(default_factory=dict)
    _sites: dict[str, list[tuple[PlacedBlock, Line]]] = field(default_factory=dict)
    _loaders: set[str] = field(default_factory=set)
    _started: set[int] = field(default_factory=set)
    _back: dict[str, bool] = field(default_factory=dict)
    _loads: dict[int, list[int]] = field(default_factory=dict)
    _lasts: dict[int, dict[str, VariableAssignment]] = field(default_factory=dict)

    @classmethod
    def among(cls, contents: Sequence[ProgramContent]) -> ProgramCalls:
        """Return the calls between the programs in the files."""
        found = cls([PlacedBlock(content, one) for content in contents for one in content.blocks])
        for placed in found.blocks:
            if placed.block.title:
                found._titles.setdefault(placed.block.title, []).append(placed)
        for placed in found.blocks:
            for line in placed.block.trail:
                for name in sorted(line.mentions & found._titles.keys()):
                    found._sites.setdefault(name, []).append((placed, line))
        found._spread()
        return found

    def _spread(self) -> None:
        """Find the programs that assign a value themselves or by calls, and the programs that the
        control certainly starts.
        """
        waiting = [one for one in self.blocks if one.block.branches]
        while waiting:
            title = waiting.pop().block.title
            if title and title not in self._loaders:
                self._loaders.add(title)
                waiting += [by for by, _ in self._sites.get(title, [])]
        waiting = [
            one
            for one in self.blocks
            if one.block.caller is None and one.block.title not in self._sites
        ]
        while waiting:
            placed = waiting.pop()
            if id(placed.block) in self._started:
                continue
            self._started.add(id(placed.block))
            for line in placed.block.trail:
                for name in line.mentions & self._titles.keys():
                    if len(self._titles[name]) == 1 and self._before(placed.block, line) is None:
                        waiting += self._titles[name]

    def doubts(self, block: ProgramBlock) -> list[Doubt]:
        """Return the statements of a program that may prevent the execution of its assignments."""
        return [one for one in block.doubts if not self._always_returns(one.call)]

    def has(self, name: str) -> bool:
        """Return whether the files contain a program with that name."""
        return name in self._titles

    def calls_of(self, block: ProgramBlock) -> list[Line]:
        """Return the lines that call programs which assign a value, directly or by calls."""
        return [line for line in block.trail if line.mentions & self._loaders]

    def is_called(self, block: ProgramBlock) -> bool:
        """Return whether another program calls the program ``block``."""
        return block.title in self._sites

    def trail(self, block: ProgramBlock) -> list[Line]:
        """Return a program's lines; a call that certainly returns is treated as a line after which
        the next line is executed.
        """
        back = {one.line for one in (*block.doubts, *block.late) if self._always_returns(one.call)}
        called = {line.number for line in self.calls_of(block)}
        return [
            replace(
                line,
                words=() if line.number in back else line.words,
                given=line.given or line.number in called,
                assigned={EVERYTHING: None} if line.number in back else line.assigned,
            )
            for line in block.trail
        ]

    def not_started(self, placed: PlacedBlock) -> tuple[str, Doubt] | None:
        """Return the file and line that may prevent a program's start; None if nothing prevents its
        start.
        """
        behind: list[int] = []
        while id(placed.block) not in self._started:
            if placed.block.caller is not None:
                return placed.content.name, placed.block.caller
            behind.append(id(placed.block))
            by, line = self._sites[placed.block.title][0]
            reason = self._before(by.block, line)
            if reason is not None or {id(by.block)} & {*behind, *self._started}:
                return by.content.name, reason or Doubt(line.number, " ".join(line.words))
            placed = by
        return None

    def in_doubt(self, block: ProgramBlock) -> bool:
        """Return whether a statement of a program may skip a later assignment or call."""
        return bool(self.doubts(block)) or any(
            self._before(block, line) for line in self.calls_of(block)
        )

    def loads(self, placed: PlacedBlock, above: Collection[str] = ()) -> list[int]:
        """Return the lines of a program that set a correction other than 0, directly or by a call,
        if every run of the program executes at least one of them; else none. ``above``: the
        programs that call it.
        """
        if id(placed.block) not in self._loads:
            lines = {
                one.line
                for one in placed.assignments
                if one.name in _COMPENSATING and one.value != 0.0
            }
            title = placed.block.title
            for line in [] if title in above else self.calls_of(placed.block):
                programs = [one for name in line.mentions for one in self._titles.get(name, [])]
                if not line.conditional and any(
                    self.loads(one, (*above, title)) for one in programs
                ):
                    lines.add(line.number)
            self._loads[id(placed.block)] = inevitable(self.trail(placed.block), lines)
        return self._loads[id(placed.block)]

    def lasts(self, placed: PlacedBlock) -> dict[str, VariableAssignment]:
        """Return the last assignment of each variable if a program and the programs that it calls
        are executed line by line.
        """
        key = id(placed.block)
        if key not in self._lasts:
            self._lasts[key] = {}
            found: dict[str, VariableAssignment] = {}
            given = {one.line: one for one in placed.assignments}
            for line in placed.block.trail:
                if line.number in given:
                    found[given[line.number].variable.upper()] = given[line.number]
                for name in sorted(line.mentions & self._titles.keys()):
                    for one in self._titles[name]:
                        found |= self.lasts(one)
            self._lasts[key] = found
        return self._lasts[key]

    def _before(self, block: ProgramBlock, line: Line) -> Doubt | None:
        ends = [block.end] if block.end is not None else []
        for one in (*block.doubts, *block.late, *ends):
            if one.line < line.number and not self._always_returns(one.call):
                return one
        return Doubt(line.number, " ".join(line.words)) if line.conditional else None

    def _always_returns(self, name: str) -> bool:
        """Return whether a program certainly returns to its caller."""
        if name not in self._back:
            self._back[name] = False  # one that calls itself
            placed = self._titles.get(name, [])
            self._back[name] = len(placed) == 1 and always_returns(self.trail(placed[0].block))
        return self._back[name]
