"""Random damage to text of any kind: what editors, spreadsheets and transfers do to files."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Sequence

#: What a number may become.
NUMBERS: Sequence[str] = (
    *("0", "-0", "-1", "1e308", "-1e308", "1e400", "nan", "NaN", "inf", "-.inf", ".nan", "1e-320"),
    *("999999999999999999999", "0.1.2", "1,5", "1.234,5", "0x10", "010", "1_000", "1:30", "٣"),
    *(
        "",
        " ",
        "-",
        "+",
        "1e",
        "--1",
        "½",
        "1e5",
        "9" * 400,
        "9" * 5000,
        "0." + "3" * 400,
        "１２",
        "#DIV/0!",
    ),
)
#: What a word or a value may become.
WORDS: Sequence[str] = (
    *("", "null", "~", "true", "no", "[]", "{}", "[1]", "{a: 1}", "'x", '"x', "&a", "*a", "!!x 1"),
    *("../x", "C:x", "\u202ex", "x" * 3000, "é", "\ud800", "-", "|", ">", "?", "<<", "@", "`"),
    *("X", "1", "0", "-1", "1e400", ".inf", "mm", "inch", "none", "a: b", "%", "\\", "/dev/null"),
)
#: What may stand anywhere.
PIECES: Sequence[str] = (
    *("\x00", "\x1b[2J", "\x85", "\u2028", "\ufeff", "\u200b", "\x0c", "\x1a", "\t", '"', "'", "#"),
    *(",", ";", ":", "=", "[", "]", "{", "}", "<", ">", "&x;", "<!--", "]]>", "%", "\r", "\n"),
    *("\n\n", "EOF::", "HEADER::", "# axis: Y\n", "target_mm,", "Run-count: 999999999\r\n", "- "),
)
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_WORD = re.compile(r"[A-Za-z_][\w-]*|\"[^\"\n]*\"|'[^'\n]*'")
_TAG = re.compile(r"<[^<>]*>")
_DELIMITERS = (",", ";", "\t")
_ENCODINGS = ("utf-16", "utf-8-sig", "cp1252", "cp1251", "utf-16-le", "utf-32", "utf-7")


def mutated(content: bytes, chance: random.Random) -> bytes:
    """Return ``content`` with one to four random changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 2, 4))):
        if chance.random() < 0.12:
            content = chance.choice(_OF_BYTES)(content, chance)
        else:
            text = content.decode("utf-8", "surrogateescape")
            content = chance.choice(_OF_TEXT)(text, chance).encode("utf-8", "surrogatepass")
    return content


def _flipped(content: bytes, chance: random.Random) -> bytes:
    if not content:
        return bytes([chance.randrange(256)])
    at = chance.randrange(len(content))
    return content[:at] + bytes([content[at] ^ 1 << chance.randrange(8)]) + content[at + 1 :]


def _any_byte(content: bytes, chance: random.Random) -> bytes:
    at = chance.randrange(len(content) + 1)
    return content[:at] + bytes([chance.randrange(256)]) + content[at + chance.randrange(2) :]


def _encoded(content: bytes, chance: random.Random) -> bytes:
    return content.decode("utf-8", "replace").encode(chance.choice(_ENCODINGS), "replace")


def _cut(text: str, chance: random.Random) -> str:
    return text[: chance.randrange(len(text) + 1)]


def _dropped_characters(text: str, chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    return text[:at] + text[at + chance.randrange(1, 9) :]


def _inserted(text: str, chance: random.Random) -> str:
    at = chance.randrange(len(text) + 1)
    return text[:at] + chance.choice(PIECES) + text[at:]


def _replaced(pattern: re.Pattern[str], values: Sequence[str]) -> Callable[..., str]:
    def change(text: str, chance: random.Random) -> str:
        at = chance.randrange(len(text) + 1)
        found = pattern.search(text, at) or pattern.search(text)
        if found is None:
            return text
        return text[: found.start()] + chance.choice(values) + text[found.end() :]

    return change


def _lines(text: str, chance: random.Random) -> str:
    """A line dropped, doubled, swapped with another, moved, emptied or indented otherwise."""
    lines = text.splitlines(keepends=True) or [""]
    one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    what = chance.randrange(6)
    if what == 0:
        del lines[one]
    elif what == 1:
        lines.insert(other, lines[one])
    elif what == 2:
        lines[one], lines[other] = lines[other], lines[one]
    elif what == 3:
        lines.insert(other, lines.pop(one))
    elif what == 4:
        lines[one] = chance.choice(("\n", "\r\n", " \n", ""))
    else:
        lines[one] = chance.choice(("  ", " ", "\t", "")) + lines[one].lstrip()
    return "".join(lines)


def _line_ends(text: str, chance: random.Random) -> str:
    ends = chance.choice(("\r", "\r\n", "\n\r", "\n\n", "\x0b", "\u2028", " \n"))
    if chance.random() < 0.5:
        return ends.join(text.splitlines())
    at = text.find("\n", chance.randrange(len(text) + 1))
    return text if at < 0 else text[:at] + ends + text[at + 1 :]


def _columns(text: str, chance: random.Random) -> str:
    """A column dropped, doubled, swapped with another, in all lines or in one; or the delimiter
    changed.
    """
    mark = max(_DELIMITERS, key=text.count)
    lines = [line.split(mark) for line in text.split("\n")]
    width = max(map(len, lines))
    one, other, what = chance.randrange(width), chance.randrange(width), chance.randrange(4)
    only = chance.randrange(len(lines)) if chance.random() < 0.3 else -1
    if what == 3:
        return text.replace(mark, chance.choice((",", ";", "\t", "|", "  ")))
    for place, cells in enumerate(lines):
        if max(one, other) < len(cells) and only in (-1, place):
            if what == 0:
                del cells[one]
            elif what == 1:
                cells.insert(other, cells[one])
            else:
                cells[one], cells[other] = cells[other], cells[one]
    return "\n".join(mark.join(cells) for cells in lines)


def _tags(text: str, chance: random.Random) -> str:
    """A tag dropped, doubled or swapped with another, or a word in it changed."""
    tags = list(_TAG.finditer(text))
    if not tags:
        return _lines(text, chance)
    one, other = chance.choice(tags), chance.choice(tags)
    new = chance.choice(("", one[0] * 2, other[0], one[0].replace(" ", "  x=", 1), "<x/>"))
    return text[: one.start()] + new + text[one.end() :]


_OF_BYTES = (_flipped, _any_byte, _encoded)
_OF_TEXT = (
    *(_cut, _dropped_characters, _inserted, _lines, _lines, _line_ends, _columns, _tags),
    *(_replaced(_NUMBER, NUMBERS), _replaced(_NUMBER, NUMBERS), _replaced(_WORD, WORDS)),
)
