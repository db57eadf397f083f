"""The session of one command: the files that it reads and writes, and the folders in which it
restored files of an interrupted command.

Every command makes its own `Session` and passes it to every function that reads or writes files, so
several commands can run in one process. Only `storage` changes the contents of a session. A session
is used by one thread only.
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

    - ``inputs``: the files that were read. The command never overwrites or deletes them. A link,
      another case of the letters or a path with ``..`` still means the same file.
    - ``pending``: files that can be read before they are written (see `with_pending`).
    - ``searched``: folders that were searched for files of interrupted commands.
    - ``unrestored``: by folder, the faults because of which its files cannot be restored.
    - ``restored``: folders whose files were restored to the state before an interrupted command.
    """

    inputs: set[Identity] = field(default_factory=set)
    pending: Mapping[Path, bytes] = field(default_factory=dict)
    searched: set[str] = field(default_factory=set)
    unrestored: dict[str, tuple[Fault, ...]] = field(default_factory=dict)
    restored: list[str] = field(default_factory=list)

    def with_pending(self, folder: Path, files: Mapping[str, bytes]) -> Session:
        """Return a session that can read ``files`` from ``folder`` before they are written.

        ``files``: the bytes by relative name, with ``/``. They are read instead of a file of the
        same name on the disk.

        A result folder that contains its own inputs is written as a whole, so its job is computed
        as if the inputs were already there. A pending file does not count as an input that was read
        from the disk. The new session shares all other contents with this one.
        """
        mine = {folder.joinpath(*name.split("/")): content for name, content in files.items()}
        return replace(self, pending={**self.pending, **mine})

    def search_again(self) -> None:
        """Forget which folders were already searched for files of interrupted commands, so that
        they are searched again.
        """
        self.searched.clear()
        self.unrestored.clear()
