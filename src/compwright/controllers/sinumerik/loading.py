"""Load the files of a SINUMERIK: first the commissioning archive, then small files, whose values
replace those of the archive.

A file loaded over an archive replaces single variables. The last value of a variable applies; a
variable that no small file names keeps the value of the archive. Text files have no order, so
different values in two of them are a contradiction.

The form of an archive's container (``@@MMCIBN.nnn``) is taken from all members of two real
archives. Each member has a header of 512 bytes, its data, and NUL bytes up to the next multiple of
512. Fields of a header are text ended by NUL; numbers are decimal:

- at 50: the shown name
- at 108: the kind (``7`` contains data)
- at 124: the size in bytes
- at 148: the check sum, the sum of the 512 bytes, in which those of the check sum itself count as
  NUL
- at 384: the folder

The data of the first member list all other members, one path per line. The active data are in the
folder `_ACTIVE`. All other members are programs, definitions and drive data. They are not used,
because a program assigns compensation data only when it is run.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.tables import last_value
from compwright.controllers.sinumerik.text import ProgramContent, VariableAssignment, read_file
from compwright.foundations.errors import Fault, InputError
from compwright.records.correction import ControlFile


@dataclass(slots=True)
class Loaded:
    """The contents of all files of a SINUMERIK after loading.

    ``under``: contents of the archives. ``over``: contents of all other files, loaded after the
    archives.
    """

    under: list[ProgramContent] = field(default_factory=list)
    over: list[ProgramContent] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)

    @property
    def contents(self) -> list[ProgramContent]:
        """All contents in the order of loading."""
        return [*self.under, *self.over]

    def assignments(self, names: MachineAxisNames) -> list[VariableAssignment]:
        """Return the assignments that remain after loading, in order, with the axis names AXn.

        An assignment of an archive is left out if another file assigns the same variable.
        """
        under = [names.renamed(entry) for content in self.under for entry in content.assignments]
        over = [names.renamed(entry) for content in self.over for entry in content.assignments]
        replaced = {_variable(entry) for entry in over}
        kept = [entry for entry in under if _variable(entry) not in replaced]
        return [*_within_new_ends(kept, over), *over]

    def unanswered(self, names: MachineAxisNames) -> list[Fault]:
        """Return a fault for each variable whose value is ``n/a`` in one file and that no file
        assigns.
        """
        open_entries = [entry for content in self.contents for entry in content.not_given]
        assigned = {_variable(e) for e in self.assignments(names)} if open_entries else set()
        return [
            entry.fault(
                f"{entry.variable} is not given here, and no other file states it",
                expected="a number",
                found="n/a",
            )
            for entry in open_entries
            if _variable(names.renamed(entry)) not in assigned
        ]


def load(files: Sequence[ControlFile]) -> Loaded:
    """Return the contents of all files, with their faults; nothing is raised."""
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
    """Return the assignments ``kept`` of an archive without the table points beyond the end of a
    table that the assignments ``over`` of later files have shortened.

    The control stores these points but does not use them.
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


_BLOCK = 512
#: Archives of which the members are kept: the states of a job, and one that was read back.
_KEPT = 4
_SUM = slice(148, 156)
_BEGIN = re.compile(rb"@@MMCIBN\.[0-9]{3}\x00")
_ACTIVE = "\\_NC_ACT.DIR\\"
_DATA = "7"
_DATUM = re.compile(
    rb"\s*(?:N\d+\s+)?\$(?P<name>\w+)\s*(?P<index>\[[^\]]*\])?\s*=(?P<value>[^;]*?)(?:\s+'\w{4})?\s*(?:;.*)?$"
)


@dataclass(frozen=True, slots=True)
class _Member:
    start: int
    name: str
    kind: str
    folder: str
    content: bytes


@dataclass(slots=True)
class Opened:
    """An opened archive. ``files``: its active members as text files, named ``ARCHIVE: MEMBER``;
    ``faults``: of the archive.
    """

    files: list[ControlFile] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def is_container(content: bytes) -> bool:
    """Return whether a file is a commissioning archive, by its first bytes."""
    return _BEGIN.match(content) is not None


@lru_cache(maxsize=_KEPT)
def active_files(file: ControlFile) -> Opened:
    """Return the members of an archive that form the control's state; members that are equal are
    returned once.

    Nothing is raised. A container that is cut short or has wrong sizes is a fault; so are two
    different members with the same name. The result is cached by content: do not change it.
    """
    opened = Opened()
    seen: dict[str, bytes] = {}
    listed: list[str] = []
    try:
        for member in _members(file):
            if member.start == 0:
                listed = _listed(member.content)
                continue
            if member.kind != _DATA or member.folder.upper() != _ACTIVE:
                continue
            before = seen.setdefault(member.name.upper(), member.content)
            if before != member.content:
                opened.faults.append(
                    Fault(
                        message=(
                            f"the archive contains two different members (files) {member.name}, "
                            "and it is unknown which one is valid"
                        ),
                        file=file.name,
                        place=member.name,
                        hint="export the archive from the control again",
                    )
                )
            elif before is member.content:
                opened.files.append(ControlFile(f"{file.name}: {member.name}", member.content))
    except InputError as error:
        opened.faults.extend(error.faults)
        return opened
    opened.faults += _contradictions(opened.files)
    opened.faults += [
        Fault(
            message=f"the archive is cut off: its table of contents names {name}, which is missing",
            file=file.name,
            place=name,
            expected="an archive as the control wrote it",
            hint="export the archive from the control again",
        )
        for name in dict.fromkeys(listed)
        if name.upper() not in seen
    ]
    return opened


def _contradictions(files: list[ControlFile]) -> Iterator[Fault]:
    """Yield a fault for each variable whose last value differs between two archive members.

    A control writes its machine data both into INITIAL.INI and, in parts, into the CFG members.
    MD11200 may differ, because it is a command and no setting.
    """
    ends: dict[bytes, tuple[bytes, ControlFile, int]] = {}
    for file in files:
        own: dict[bytes, tuple[bytes, ControlFile, int]] = {}
        for number, line in enumerate(file.content.splitlines(), start=1):
            match = _DATUM.match(line)
            if match is not None and match["name"].upper() != b"MN_INIT_MD":
                key = (match["name"] + (match["index"] or b"")).replace(b" ", b"").upper()
                own[key] = match["value"].strip(), file, number
        for key, (value, _, number) in own.items():
            other, where, at = ends.setdefault(key, (value, file, number))
            if other != value and _as_number(other) != _as_number(value):
                yield Fault(
                    message=(
                        f"${key.decode('latin-1')} contradicts {where.name}, line {at}, in "
                        "the same archive: one of the two files was changed after the "
                        "export"
                    ),
                    file=file.name,
                    place=f"line {number}",
                    expected=f"{other.decode('latin-1')}",
                    found=value.decode("latin-1"),
                    hint="export the archive from the control again",
                )


def _as_number(text: bytes) -> float | bytes:
    try:
        return float(text)
    except ValueError:
        return text.upper()


def _listed(content: bytes) -> list[str]:
    """Return the names of the active members that an archive's list of contents states."""
    lines = content.decode("latin-1").splitlines()
    names = [line[len(_ACTIVE) :] for line in lines if line.upper().startswith(_ACTIVE)]
    return [name for name in names if not name.startswith("@@")]


def _members(file: ControlFile) -> Iterator[_Member]:
    """Yield the members of an archive in their order.

    Raises InputError if no header follows the end of a member, or if the data of a member are cut
    off.
    """
    content, start, before = file.content, 0, "the first member"
    while start < len(content):
        header = content[start : start + _BLOCK]
        name, size = _field(header, 50) or _field(header, 0), _size(header)
        if size is None:
            raise InputError(
                Fault(
                    message=f"the archive is damaged: {before} (a file in it) does not have the "
                    "size that the archive states",
                    file=file.name,
                    place=f"byte {start}",
                    expected="an archive as the control wrote it",
                    hint="export the archive from the control again",
                )
            )
        data = content[start + _BLOCK : start + _BLOCK + size]
        if len(data) < size:
            raise InputError(
                Fault(
                    message="the archive is cut off inside its member (file of the archive) "
                    f"{name}",
                    file=file.name,
                    place=f"byte {start}",
                    expected=f"{size} bytes",
                    found=f"{len(data)} bytes",
                    hint="export the archive from the control again",
                )
            )
        yield _Member(start, name, _field(header, 108), _field(header, 384), data)
        start += _BLOCK + -(-size // _BLOCK) * _BLOCK
        before = f"the member {name}"


def _size(header: bytes) -> int | None:
    """Return the size that an archive member's header states; None if it is no header."""
    size, check_sum = _field(header, 124), _field(header, 148)
    whole = len(header) == _BLOCK and size.isdecimal() and check_sum.isdecimal()
    if not whole or sum(header) - sum(header[_SUM]) != int(check_sum):
        return None
    return int(size)


def _field(header: bytes, start: int) -> str:
    """Return the text in an archive header from ``start`` to the next NUL byte."""
    return header[start:].split(b"\x00", 1)[0].decode("latin-1").strip()
