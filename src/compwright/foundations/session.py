"""The session of one command: the files that it reads and writes, and the folders in which it
restored files of an interrupted command.

Every command makes its own `Session` and hands it to whatever reads or writes files, so that
several commands can work in one process. Only `storage` changes what a session holds, and one
session serves one thread.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from compwright.foundations.errors import Fault

#: Device and number of a file on it.
Identity = tuple[int, int]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Session:
    """The files that one command has read or will write, and the folders in which it restored files
    of an interrupted command.

    ``inputs``: the files that were read. The command never overwrites or deletes them, whatever
    name leads to them: a link, other cases of the letters and a way around through ``..`` are still
    the same file. ``pending``: files that are read before they are written (see `with_pending`).
    ``searched``: the folders that were searched for the leftovers of stopped commands;
    ``unrestored``: those whose files cannot be put back, and why; ``restored``: those whose files
    were put back as they were before a stopped command.
    """

    inputs: set[Identity] = field(default_factory=set)
    pending: Mapping[Path, bytes] = field(default_factory=dict)
    searched: set[str] = field(default_factory=set)
    unrestored: dict[str, tuple[Fault, ...]] = field(default_factory=dict)
    restored: list[str] = field(default_factory=list)

    def with_pending(self, folder: Path, files: Mapping[str, bytes]) -> Session:
        """Return a session that can read ``files`` from ``folder`` before they are written.

        Relative name with ``/`` -> bytes; whatever is there on the disk.

        A result folder that holds its own inputs is written as a whole: its job is computed as if
        the inputs were there already. Such a file is no input that was read from the disk. All else
        is shared with this session.
        """
        mine = {folder.joinpath(*name.split("/")): content for name, content in files.items()}
        return replace(self, pending={**self.pending, **mine})

    def search_again(self) -> None:
        """Forget which folders were already searched for files of interrupted commands, so that
        they are searched again.
        """
        self.searched.clear()
        self.unrestored.clear()
