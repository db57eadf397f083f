"""Text as UTF-8, whatever the file system gave: a name that is no UTF-8 reaches Python as
characters that no encoding has.
"""

from __future__ import annotations

from pathlib import Path


def encoded(text: str) -> bytes:
    r"""Return ``text`` in UTF-8. What no encoding has (part of a file's name) stands there as
    ``\udcff``.
    """
    return text.encode("utf-8", errors="backslashreplace")


def shown_path(path: Path) -> str:
    """Return the name of a file as it can stand in any text; the same as ``str(path)`` for names
    that are UTF-8.
    """
    return encoded(str(path)).decode("utf-8")


def visible(text: str) -> str:
    """Return ``text`` as one line that a terminal may show: a name may hold line breaks and control
    codes.
    """
    return "".join(map(_visible, text))


def _visible(character: str) -> str:
    if character.isprintable():
        return character
    return " " if character.isspace() else "?"
