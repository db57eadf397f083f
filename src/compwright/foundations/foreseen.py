"""Files that are read before they stand on the disk: what a command makes of them is written with
them, all or nothing.

A result folder that holds its own inputs is made in one piece: its job is worked through as if the
inputs lay there already, and then everything appears together. Such a file is known by the path by
which it is asked for, and is no input that was read from the disk.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

_files: dict[Path, bytes] = {}


@contextmanager
def foreseen(folder: Path, files: Mapping[str, bytes]) -> Iterator[None]:
    """Let ``files`` (relative name with ``/`` -> bytes) be read below ``folder`` as long as this is
    entered, whatever stands there on the disk.
    """
    mine = {folder.joinpath(*name.split("/")): content for name, content in files.items()}
    before = dict(_files)
    _files.update(mine)
    try:
        yield
    finally:
        _files.clear()
        _files.update(before)


def foreseen_bytes(path: Path) -> bytes | None:
    """Return the bytes of a file that is to be written, None for any other."""
    return _files.get(path)
