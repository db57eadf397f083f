"""Replace the personal texts in a file before it is given to others.

A remark becomes ``redacted``. A name, a serial number or a path becomes ``redacted_N``. The same
text has the same N in all files of one command, so that the files of a machine still belong
together. N counts the texts in the order in which they were found, so the text does not follow from
it.
"""

from __future__ import annotations

import html
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Final
from urllib.parse import unquote

from compwright.foundations.errors import Fault, InputError

#: Replacement of a remark.
NEUTRAL: Final = "redacted"
#: The kind of a removed whole line.
LINE: Final = "line"
_NEUTRAL: Final = re.compile(rf"{NEUTRAL}(?:_[0-9]+)?", re.IGNORECASE)
#: Pieces of text that may identify somebody: adjacent letters and digits.
_PIECE: Final = re.compile(r"[^\W_]+")
_LETTERS: Final = re.compile(r"[^\W\d_]")
#: Shorter words and numbers occur in any file by chance.
_SHORTEST_WORD, _SHORTEST_NUMBER = 4, 6
#: Digits, whatever letters are next to them: an address before a value, a mark before a serial
#: number.
_DIGITS: Final = re.compile(r"[0-9]+")
#: A date, which stays in a file, a round number, bits; a mask of bits; a number with decimals.
_ORDINARY: Final = re.compile(r"(?:19|20)[0-9]{6}|[0-9]+000|[01]+")
_HEX: Final = re.compile(r"h[0-9a-f]{1,8}")
_DECIMAL: Final = re.compile(r"[+-]?[0-9]*[.,][0-9]+(?:[eE][+-]?[0-9]+)?")
_ENCODINGS: Final = ("utf-8", "cp1252", "utf-16-le", "utf-16-be")


@dataclass(slots=True)
class Names:
    """The personal names that one command found, each with the number in its replacement."""

    numbers: dict[str, int] = field(default_factory=dict)

    def of(self, text: str) -> str:
        """Return the neutral replacement of a name. Names that differ only in upper and lower case
        or in blanks have the same replacement.
        """
        number = self.numbers.setdefault(_plain(text), len(self.numbers) + 1)
        return f"{NEUTRAL}_{number}"

    def knows(self, text: str) -> bool:
        """Return whether a text is one of the names found so far."""
        return _plain(text) in self.numbers


def _plain(text: str) -> str:
    return " ".join(text.casefold().split())


@dataclass(slots=True)
class Cuts:
    """Records the texts that are removed from one file, each with its kind, such as ``name``."""

    names: Names
    removed: list[tuple[str, str]] = field(default_factory=list)

    def remark(self, text: str, kind: str = "comment") -> str:
        """Record a comment as removed, and return a neutral text for it; "" for an empty text."""
        if not text.strip():
            return ""
        if _NEUTRAL.fullmatch(text.strip()) is None:
            self.removed.append((kind, text.strip()))
        return NEUTRAL

    def name(self, text: str, kind: str = "name") -> str:
        """Record a name as removed, and return its replacement; "" for an empty text."""
        if not text.strip():
            return ""
        if text.strip() == NEUTRAL:
            return NEUTRAL
        if _NEUTRAL.fullmatch(text.strip()) is None:
            self.removed.append((kind, text.strip()))
        return self.names.of(text)

    def counts(self) -> dict[str, int]:
        """Return how many texts of each kind were removed, sorted by kind."""
        return dict(sorted(Counter(kind for kind, _ in self.removed).items()))


def left_over(removed: Iterable[str], copy: Iterable[bytes], allowed: frozenset[str]) -> list[str]:
    """Return the texts that should have been removed but are still in a copy, completely or in
    part. ``allowed``: words that the copy may contain anyway, such as keywords and units.

    ``copy``: the bytes of the copy; of an archive, the bytes of each member. The texts are searched
    for in every usual encoding, in lower case, and after entities and percent signs are resolved.
    ``allowed`` words are in lower case too. Single letters, short words and short numbers are not
    reported, because any file contains them.
    """
    texts = list(dict.fromkeys(removed))
    there: set[str] = set()
    forms = [form for content in copy for form in _forms(content)]
    for form in forms:
        there.update(_PIECE.findall(form), _DIGITS.findall(form))
    return [
        text
        for text in texts
        if any(piece in there for piece in telling(text, allowed))
        or any(_whole(text, allowed) in form for form in forms if _whole(text, allowed))
    ]


def telling(text: str, allowed: frozenset[str]) -> Iterator[str]:
    """Yield the words and numbers in a text that may identify a person or company. ``allowed``:
    words that do not, such as keywords and units.
    """
    if _DECIMAL.fullmatch(text):
        return
    for piece in _PIECE.findall(text.casefold()):
        if _HEX.fullmatch(piece):
            continue
        for digits in _DIGITS.findall(piece):
            if len(digits) >= _SHORTEST_NUMBER and _ORDINARY.fullmatch(digits) is None:
                yield digits
        if _LETTERS.search(piece) and len(piece) >= _SHORTEST_WORD and piece not in allowed:
            yield piece


def _whole(text: str, allowed: frozenset[str]) -> str:
    """Return a text in lower case if it has several words and some of them may identify a person or
    company, else "". ``allowed``: words that do not identify anybody.
    """
    whole = " ".join(text.casefold().split())
    return whole if " " in whole and any(telling(whole, allowed)) else ""


def _forms(content: bytes) -> Iterator[str]:
    """Yield the bytes decoded with each possible encoding, in lower case."""
    for encoding in _ENCODINGS if b"\x00" in content else _ENCODINGS[:2]:
        text = content.decode(encoding, errors="replace").casefold()
        yield text
        if "&" in text:
            yield html.unescape(text).casefold()
        if "%" in text:
            yield unquote(text).casefold()


def not_the_same(file: str, found: str) -> InputError:
    """Return the error that a file was not copied, because the copy without names would be read
    with other numbers than the original. ``found``: what is read from the copy, as text.
    """
    return InputError(
        Fault(
            message="the file was not copied: with the names removed, the numbers read from the "
            "copy would differ from those of the file",
            file=file,
            expected="the same numbers in the copy",
            found=found,
            hint="remove the names by hand",
        )
    )


def refuse_left_over(
    file: str,
    cuts: Cuts,
    copy: Sequence[bytes],
    allowed: frozenset[str],
    *,
    in_lines: bool = True,
) -> None:
    """Raise InputError if the ``copy`` still contains a removed text, apart from ``allowed`` words.
    The error names the lines of the copy if ``in_lines`` is true.

    The error does not show the text itself. A line of the copy has the same number in the original.
    """
    left = left_over((text for _, text in cuts.removed), copy, allowed)
    if left:
        lines = [
            number
            for number, line in enumerate(copy[0].splitlines() if in_lines else (), start=1)
            if left_over(left, [line], allowed)
        ]
        kinds = sorted({kind for kind, text in cuts.removed if text in left})
        raise InputError(
            Fault(
                message="the file was not copied: a name to be removed is also a keyword or a "
                "number of the file, which would be damaged",
                file=file,
                place=_lines(lines),
                expected="names that differ from keywords and numbers",
                found=f"{len(left)} such names ({', '.join(kinds)})",
                hint="remove the names by hand",
            )
        )


def _lines(numbers: Sequence[int]) -> str:
    """Return line numbers as text, or "" for a workbook, which has no lines."""
    listed = ", ".join(map(str, numbers[:5])) + (", .." if len(numbers) > 5 else "")
    return f"line{'s' if len(numbers) > 1 else ''} {listed}" if numbers else ""
