"""What the running command has read and put right.

Its inputs are never overwritten or deleted by it, whatever name leads to them. A file is known by
its identity in the file system, so that a link, another case of the letters or a way around through
``..`` is still the same file. Only `storage` fills this memory, whenever it reads.
"""

from __future__ import annotations

from collections.abc import Mapping

from compwright.foundations.errors import Fault

#: Device and number of a file on it.
Identity = tuple[int, int]

_inputs: set[Identity] = set()
_seen_to: set[str] = set()
_left: dict[str, tuple[Fault, ...]] = {}
_put_right: list[str] = []


def start_command() -> None:
    """Forget what was read before: another command begins in this process."""
    _inputs.clear()
    _put_right.clear()
    look_again()


def remember(identity: Identity) -> None:
    """Note that a file was read."""
    _inputs.add(identity)


def is_input(identity: Identity | None) -> bool:
    """Whether this command has read the file; False for None, no file at all."""
    return identity in _inputs


def is_seen_to(folder: str) -> bool:
    """Whether this command has looked already for what a stopped one left in a folder and in those
    above it.
    """
    return folder in _seen_to


def see_to(folder: str) -> None:
    """Note that this was looked for."""
    _seen_to.add(folder)


def note_left(folder: str, faults: tuple[Fault, ...]) -> None:
    """Note why the files of a folder cannot be put back as they were before a stopped command."""
    _left[folder] = faults


def left_over() -> Mapping[str, tuple[Fault, ...]]:
    """Return the folders whose files cannot be put back, and why."""
    return _left


def look_again() -> None:
    """Forget where was looked: what another process leaves meanwhile is found too."""
    _seen_to.clear()
    _left.clear()


def note_put_right(folder: str) -> None:
    """Note that the files of a folder were put back as they were before a stopped command."""
    _put_right.append(folder)


def put_right() -> tuple[str, ...]:
    """Return the folders whose files this command put back as they were before a stopped one."""
    return tuple(_put_right)
