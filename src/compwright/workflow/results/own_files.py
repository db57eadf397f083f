"""Write files of a command into a folder, together with a hidden list of these files that protects
the user's own files.

Files that are not in the list are the user's. They are never replaced and never removed.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from compwright.documents.file_list import LIST, list_text, listed_before, listed_now
from compwright.foundations import storage
from compwright.foundations.provenance import fingerprint
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded


def write_listed(
    session: Session,
    out: Path,
    files: Mapping[str, bytes],
    *,
    command: str,
    force: bool,
    as_set: bool,
    elsewhere: Mapping[Path, bytes] | None = None,
) -> list[Path]:
    """Write ``files`` and a list of them into ``out``, and the files ``elsewhere`` to their own
    paths, all or nothing. With ``as_set``, remove files that an earlier call of the ``command``
    wrote and this one does not. Return the written paths.

    With ``force``, files of an earlier command in the folder are replaced, unless they were changed
    since. Raises StorageError as `storage.write_files` does, also for a file that is not in the
    list or was changed.
    """
    earlier = listed_before(storage.earlier_bytes(session, out / LIST))
    still = {
        name: entry
        for name, entry in earlier.items()
        if fingerprint(storage.earlier_bytes(session, out / name)) == entry.sha256
    }
    # what lies there already just so, and is in no list, stays the user's
    own = {
        name: content
        for name, content in files.items()
        if encoded(name).decode() in earlier or not storage.is_there(session, out / name)
    }
    now = listed_now(own, command)
    names = {encoded(name).decode() for name in files}
    outdated = [
        name
        for name, entry in still.items()
        if as_set and force and entry.by == command and name not in names
    ]
    kept = {name: entry for name, entry in still.items() if name not in outdated}

    def known(name: str, content: bytes) -> bool:
        if name == LIST:
            return bool(listed_before(content))
        entry = earlier.get(encoded(name).decode())
        return entry is not None and entry.sha256 == fingerprint(content)

    return storage.write_files(
        session,
        out,
        {**files, LIST: list_text({**kept, **now})},
        force=force,
        elsewhere=elsewhere,
        completed=[LIST],
        outdated=outdated,
        known=known,
    )[: len(files)]
