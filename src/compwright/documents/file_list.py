"""The file ``.compwright-files.json``, which lists what commands wrote into a folder.

Its schema is ``compwright/files/1``. Each entry is a file with its SHA-256, its size and the
command that wrote it. The file is hidden, because the folder may be passed on as it is. It contains
no dates, so that the same input gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from compwright.documents.json_text import read_json, to_json
from compwright.foundations.errors import InputError
from compwright.foundations.provenance import fingerprint
from compwright.foundations.utf8 import encoded

SCHEMA: Final = "compwright/files/1"
LIST: Final = ".compwright-files.json"


@dataclass(frozen=True, slots=True)
class ListedFile:
    """A file that a command wrote: its SHA-256, its size in bytes, and the command."""

    sha256: str
    size: int
    by: str


def listed_now(files: Mapping[str, bytes], command: str) -> dict[str, ListedFile]:
    """Return the list entries, by relative name, of the files that ``command`` writes."""
    return {
        encoded(name).decode(): ListedFile(fingerprint(content), len(content), command)
        for name, content in files.items()
    }


def list_text(entries: Mapping[str, ListedFile]) -> bytes:
    """Return the contents of the list file as bytes."""
    listed = [
        {"file": name, "sha256": entry.sha256, "size": entry.size, "by": entry.by}
        for name, entry in sorted(entries.items())
    ]
    return to_json({"schema": SCHEMA, "files": listed}).encode()


def listed_before(content: bytes) -> dict[str, ListedFile]:
    """Return the entries of an earlier list file by relative name; empty if ``content`` is not a
    list file.
    """
    try:
        listed = read_json(content, LIST, SCHEMA, "list of files", "the list that a command left")
        return {
            str(entry["file"]): ListedFile(
                str(entry["sha256"]), int(entry["size"]), str(entry["by"])
            )
            for entry in listed["files"]
        }
    except (InputError, ValueError, TypeError, KeyError, AttributeError):
        return {}
