"""The origin of numbers: source files with their hash."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Source:
    """A file that was read: its name as the user wrote it, and the SHA-256 of its bytes."""

    file: str
    sha256: str


def fingerprint(content: bytes) -> str:
    """Return the SHA-256 hash of ``content`` as hexadecimal text."""
    return hashlib.sha256(content).hexdigest()


def source_of(file: str, content: bytes) -> Source:
    """Return the `Source` of a file: its name and the SHA-256 of its contents."""
    return Source(file=file, sha256=fingerprint(content))


def share_a_file(one: Iterable[Source], other: Iterable[Source]) -> bool:
    """Return whether two sets of sources have a file with the same contents in common."""
    return not {source.sha256 for source in one}.isdisjoint(source.sha256 for source in other)
