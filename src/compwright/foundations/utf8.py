"""Text as UTF-8, whatever the file system gave: a name that is no UTF-8 reaches Python as
characters that no encoding has.
"""

from __future__ import annotations

from pathlib import Path
from unicodedata import category


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
    r"""Return ``text`` as one line in which everything can be seen: line breaks and other white
    space as blanks, control characters and those that turn the direction of writing as their
    escapes (``\x1b``, ``\u202e``), which no terminal obeys.
    """
    return text if text.isprintable() else "".join(map(_visible, text))


def visible_lines(text: str) -> str:
    """Return ``text`` as `visible` does, line breaks as they are."""
    return "\n".join(map(visible, text.split("\n")))


def _visible(character: str) -> str:
    if character.isprintable() or category(character) == "Zs":
        return character
    return " " if character.isspace() else ascii(character)[1:-1]
