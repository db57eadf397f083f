"""Write any file name as UTF-8 text, also one that is not valid UTF-8.

In Python such a name contains lone surrogates, which no encoding can represent.
"""

from __future__ import annotations

from pathlib import Path
from unicodedata import category


def encoded(text: str) -> bytes:
    r"""Return ``text`` in UTF-8. Invalid bytes of a file name become ``\\udcff``."""
    return text.encode("utf-8", errors="backslashreplace")


def shown_path(path: Path) -> str:
    """Return the name of a file as printable text. For a UTF-8 name it equals ``str(path)``."""
    return encoded(str(path)).decode("utf-8")


def visible(text: str) -> str:
    r"""Return ``text`` as one line, with control characters as visible escapes such as ``\x1b``."""
    return text if text.isprintable() else "".join(map(_visible, text))


def visible_lines(text: str) -> str:
    """Return ``text`` as `visible` does, but keep its line breaks."""
    return text if text.isprintable() else "\n".join(map(visible, text.split("\n")))


def _visible(character: str) -> str:
    if character.isprintable() or category(character) == "Zs":
        return character
    return " " if character.isspace() else ascii(character)[1:-1]
