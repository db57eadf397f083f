"""Files of a SINUMERIK in the order in which the control loads them: the commissioning archive
first, small files over it.

A file loaded over an archive replaces single variables: the last value of a variable counts, and a
variable that no small file names keeps the archive's value. Text files have no order among each
other: if they differ, that is a contradiction.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field

from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.container import active_files, is_container
from compwright.controllers.sinumerik.tables import last_value
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment, read_file
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile


@dataclass(slots=True)
class Loaded:
    """``under``: contents of the archives in containers; ``over``: of all other files."""

    under: list[ProgramContent] = field(default_factory=list)
    over: list[ProgramContent] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)

    @property
    def contents(self) -> list[ProgramContent]:
        """All of them in the order of loading."""
        return [*self.under, *self.over]

    def assignments(self, names: MachineAxisNames) -> list[VariableAssignment]:
        """Return the final assignments in the order of loading, axes under their canonical names.

        Those of the archive that a small file replaces are left out.
        """
        under = [names.renamed(entry) for content in self.under for entry in content.assignments]
        over = [names.renamed(entry) for content in self.over for entry in content.assignments]
        replaced = {_variable(entry) for entry in over}
        kept = [entry for entry in under if _variable(entry) not in replaced]
        return [*_within_new_ends(kept, over), *over]

    def unanswered(self, names: MachineAxisNames) -> list[Fault]:
        """Return the faults of variables that a file gives as ``n/a`` and no other file gives."""
        open_entries = [entry for content in self.contents for entry in content.not_given]
        assigned = {_variable(e) for e in self.assignments(names)} if open_entries else set()
        return [
            entry.fault(
                f"{entry.variable} is not given here, and no other file says it",
                expected="a number",
                found="n/a",
            )
            for entry in open_entries
            if _variable(names.renamed(entry)) not in assigned
        ]


def load(files: Sequence[ControlFile]) -> Loaded:
    """Return the contents of all files; nothing is raised, faults are collected."""
    loaded = Loaded()
    for file in files:
        if not is_container(file.content):
            loaded.over.append(read_file(file))
            continue
        opened = active_files(file)
        loaded.faults += opened.faults
        loaded.under += [read_file(member) for member in opened.files]
    loaded.faults += [fault for content in loaded.contents for fault in content.faults]
    return loaded


def _variable(entry: VariableAssignment) -> tuple[str, int, int | None, str]:
    return entry.name, entry.number, entry.point, entry.axis.upper()


def _within_new_ends(
    kept: list[VariableAssignment], over: Sequence[VariableAssignment]
) -> list[VariableAssignment]:
    """Return the archive's assignments without table points above a new, shorter end.

    The control keeps those points and does not use them.
    """
    changed = {
        _table(entry)
        for entry in over
        if entry.name.endswith(("_STEP", "_MIN", "_MAX")) or entry.point is not None
    }
    grids: dict[tuple[str, int, str], list[VariableAssignment]] = defaultdict(list)
    for entry in (*kept, *over):
        if entry.point is None and _table(entry) in changed:
            grids[_table(entry)].append(entry)
    ends: dict[tuple[str, int, str], float] = {}
    for table, entries in grids.items():
        step, low, high = (
            last_value(entries, f"{table[0]}_{key}") or 0.0 for key in ("STEP", "MIN", "MAX")
        )
        ends[table] = (high - low) / step + 0.5 if step > 0.0 else float("inf")
    return [
        entry
        for entry in kept
        if entry.point is None or entry.point <= ends.get(_table(entry), float("inf"))
    ]


def _table(entry: VariableAssignment) -> tuple[str, int, str]:
    prefix = "AA_ENC_COMP" if entry.name.startswith("AA_ENC_COMP") else "AN_CEC"
    return prefix, entry.number, entry.axis.upper()
