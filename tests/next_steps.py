"""The end of every error: what to do next."""

from __future__ import annotations

MARK = ". Next: "


def without_hint(line: str) -> str:
    """Return the line of an error up to its next step, which has to be there."""
    words, mark, hint = line.partition(MARK)
    assert mark, f"no next step: {line}"
    assert hint, line
    return words
