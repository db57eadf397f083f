"""A text as lines with their own ends, and back into the bytes of the encoding that it came in."""

from __future__ import annotations

import codecs
import re
from collections.abc import Sequence
from dataclasses import dataclass

from compwright.instruments.text_input import encoding_of, read_any_lines

_LINE_END = re.compile(r"(\r\n|\r|\n)")
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)


@dataclass(frozen=True, slots=True)
class Lines:
    """``lines`` without their ends; ``ends`` of each, empty behind the last; ``mark``: the byte
    order mark.
    """

    lines: tuple[str, ...]
    ends: tuple[str, ...]
    encoding: str
    mark: bytes = b""

    def to_bytes(self, lines: Sequence[str]) -> bytes:
        """Return other lines in the place of these, as many, with the same ends and encoding."""
        text = "".join(line + end for line, end in zip(lines, self.ends, strict=True))
        return self.mark + text.encode(self.encoding, errors="replace")


def lines_of(content: bytes, file: str, encoding: str | None = None) -> Lines:
    """Return the lines of a text file. Raises InputError for what is no text."""
    read_any_lines(content, file, encoding)  # what is wrong with it is said there
    mark, name = next(
        ((mark, name) for mark, name in _MARKS if content.startswith(mark)),
        (b"", encoding or encoding_of(content)),
    )
    pieces = _LINE_END.split(content[len(mark) :].decode(name).lstrip("\ufeff"))
    return Lines(tuple(pieces[::2]), (*pieces[1::2], ""), name, mark)
