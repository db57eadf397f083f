"""What the running command has read: its inputs, which it never overwrites or deletes, whatever
name leads to them.

A file is known by its identity in the file system, so that a link, another case of the letters or a
way around through ``..`` is still the same file. Only `storage` fills this memory, whenever it
reads.
"""

from __future__ import annotations

#: Device and number of a file on it.
Identity = tuple[int, int]

_inputs: set[Identity] = set()


def start_command() -> None:
    """Forget what was read before: another command begins in this process."""
    _inputs.clear()


def remember(identity: Identity) -> None:
    """Note that a file was read."""
    _inputs.add(identity)


def is_input(identity: Identity | None) -> bool:
    """Whether this command has read the file; False for None, no file at all."""
    return identity in _inputs
