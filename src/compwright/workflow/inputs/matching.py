"""Expand file names with ``*`` and ``?``, because the shell of Windows does not."""

from __future__ import annotations

from compwright.foundations import storage
from compwright.foundations.session import Session


def files_matching(session: Session, text: str) -> list[str]:
    """Return the files that match the pattern ``text``, sorted, or ``text`` itself if none does."""
    found = storage.matching(session, text)
    name, mark, rest = text.partition("=")
    if found == [text] and mark:
        return [f"{name}={file}" for file in storage.matching(session, rest)]
    return found
