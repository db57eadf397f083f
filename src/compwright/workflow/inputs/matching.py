"""Names with ``*`` and ``?`` that the shell left to the program, as it does on Windows."""

from __future__ import annotations

from compwright.foundations import storage
from compwright.foundations.session import Session


def files_matching(session: Session, text: str) -> list[str]:
    """Return the files that match the pattern ``text``, by name; ``text`` itself where it is a file
    name or nothing matches. For ``TEST=PATTERN`` each file has the test in front.
    """
    found = storage.matching(session, text)
    name, mark, rest = text.partition("=")
    if found == [text] and mark:
        return [f"{name}={file}" for file in storage.matching(session, rest)]
    return found
