"""What is taken out of a file before somebody gives it away, and what stands in its place.

A remark becomes ``redacted``; a name, a serial number or a path ``redacted_N``, the same N for the
same text in all files of one command, so that the files of a machine still belong together. Nothing
leads back: N counts in the order in which the texts were met.
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

#: What stands in the place of a remark.
NEUTRAL: Final = "redacted"
#: What a whole line that was taken out is called in the count.
LINE: Final = "line"
_NEUTRAL: Final = re.compile(rf"{NEUTRAL}(?:_[0-9]+)?", re.IGNORECASE)
#: Pieces of text that may give somebody away: letters and digits side by side.
_PIECE: Final = re.compile(r"[^\W_]+")
_LETTERS: Final = re.compile(r"[^\W\d_]")
#: Shorter words and numbers stand in any file by chance.
_SHORTEST_WORD, _SHORTEST_NUMBER = 4, 6
#: Digits, whatever letters stand at them: an address before a value, a mark before a serial number.
_DIGITS: Final = re.compile(r"[0-9]+")
#: A date, which stays in a file, a round number, bits; a mask of bits; a number with decimals.
_ORDINARY: Final = re.compile(r"(?:19|20)[0-9]{6}|[0-9]+000|[01]+")
_HEX: Final = re.compile(r"h[0-9a-f]{1,8}")
_DECIMAL: Final = re.compile(r"[+-]?[0-9]*[.,][0-9]+(?:[eE][+-]?[0-9]+)?")
_ENCODINGS: Final = ("utf-8", "cp1252", "utf-16-le", "utf-16-be")


@dataclass(slots=True)
class Names:
    """The names that were met by one command, each with its number."""

    numbers: dict[str, int] = field(default_factory=dict)

    def of(self, text: str) -> str:
        """Return what stands in the place of a name; its case and its blanks make no difference."""
        number = self.numbers.setdefault(_plain(text), len(self.numbers) + 1)
        return f"{NEUTRAL}_{number}"

    def knows(self, text: str) -> bool:
        """Whether a text was met as a name."""
        return _plain(text) in self.numbers


def _plain(text: str) -> str:
    return " ".join(text.casefold().split())


@dataclass(slots=True)
class Cuts:
    """What is taken out of one file: ``removed`` are the texts by their kind (``comment``,
    ``name``, ...), each as often as it was met.
    """

    names: Names
    removed: list[tuple[str, str]] = field(default_factory=list)

    def remark(self, text: str, kind: str = "comment") -> str:
        """Return what stands in the place of free text; what is empty stays empty."""
        if not text.strip():
            return ""
        if _NEUTRAL.fullmatch(text.strip()) is None:
            self.removed.append((kind, text.strip()))
        return NEUTRAL

    def name(self, text: str, kind: str = "name") -> str:
        """Return what stands in the place of a name; what is empty stays empty."""
        if not text.strip():
            return ""
        if text.strip() == NEUTRAL:
            return NEUTRAL
        if _NEUTRAL.fullmatch(text.strip()) is None:
            self.removed.append((kind, text.strip()))
        return self.names.of(text)

    def counts(self) -> dict[str, int]:
        """Return how many texts were taken out, by kind, in the order of the kinds' names."""
        return dict(sorted(Counter(kind for kind, _ in self.removed).items()))


def left_over(removed: Iterable[str], copy: Iterable[bytes], allowed: frozenset[str]) -> list[str]:
    """Return which texts that were taken out, or words of them, stand in a copy all the same.

    ``copy``: its bytes; of an archive those of its members. They are looked at in every usual
    encoding, and with entities and percent signs resolved, in any case of the letters. ``allowed``:
    words in small letters that may stand there by themselves (keywords, units, names of columns).
    Single letters, short words and short numbers are no evidence: any file holds them.
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
    """Yield the words and numbers of a text, in small letters, that may give somebody away."""
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
    """Return a text of several words as it would stand in a line, empty where it tells nothing."""
    whole = " ".join(text.casefold().split())
    return whole if " " in whole and any(telling(whole, allowed)) else ""


def _forms(content: bytes) -> Iterator[str]:
    """Yield what the bytes may be read as, in small letters."""
    encodings = _ENCODINGS if b"\x00" in content else _ENCODINGS[:2]
    for encoding in encodings:
        text = content.decode(encoding, errors="replace").casefold()
        yield text
        if "&" in text:
            yield html.unescape(text).casefold()
        if "%" in text:
            yield unquote(text).casefold()


def not_the_same(file: str, found: str) -> InputError:
    """Return the error about a copy that its reader does not understand as it does the original."""
    return InputError(
        Fault(
            message="is not copied: without its texts the copy would read differently",
            file=file,
            expected="the same numbers in the copy",
            found=found,
            hint="take the names out by hand",
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
    """Raise InputError where a text that was taken out stands in the copy all the same; the text
    itself is not told, but where ``in_lines`` the lines at which the copy still has it, which are
    those of the original.
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
                message=(
                    "is not copied: a text that was taken out in one place is needed "
                    "for reading in another"
                ),
                file=file,
                place=_lines(lines),
                expected="a name that is no keyword and no number of the file",
                found=f"{len(left)} texts ({', '.join(kinds)})",
                hint="take the names out by hand",
            )
        )


def _lines(numbers: Sequence[int]) -> str:
    """Return the lines in which a text is left in words; empty for a workbook, which has none."""
    told = ", ".join(map(str, numbers[:5])) + (", .." if len(numbers) > 5 else "")
    return f"line{'s' if len(numbers) > 1 else ''} {told}" if numbers else ""
