"""File names of copies: those of the originals, without parts that identify a person or machine."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import Final

from compwright.foundations.redaction import LINE, Names, telling
from compwright.instruments.redaction.measurement import ALLOWED

_DAY: Final = r"(?:19|20)[0-9]{2}(?:0[1-9]|1[0-2])(?:0[1-9]|[12][0-9]|3[01])"
#: A date in the name of a file, with the time of day that ballbar software puts behind it.
_DATED: Final = re.compile(rf"(?<![0-9]){_DAY}(?:[-_ T]?[0-2][0-9][0-5][0-9][0-5][0-9])?(?![0-9])")
#: A run of digits in the name of a file that may be a serial number.
_SERIAL: Final = re.compile(r"[0-9]{5,}")
#: Marks that people set between the digits of a number and the words of a name.
_BETWEEN_DIGITS: Final = re.compile(r"(?<=[0-9])[ ._-]+(?=[0-9])")
_PIECE: Final = re.compile(r"[^\W_]+")
_WORD: Final = re.compile(r"[^\W\d_]+")
#: Shorter words are within others by chance, shorter numbers in any name; a year and a round
#: number identify no person.
_LONG_WORD: Final = 5
_NUMBER: Final = re.compile(
    r"(?<![0-9])(?!(?:(?:19|20)[0-9]{2}|[0-9]{2}00|[0-9]+000)(?![0-9]))[0-9]{4,}"
)
#: Data identifiers of a control, in a line of a program or of data that is not interpreted.
_ADDRESS: Final = re.compile(r"\$?[A-Za-z0-9]*_[A-Za-z0-9_]*")
#: A length or an angle in the name of a file.
_SIZE: Final = re.compile(r"[0-9]+(?:mm|um|deg|grad|min)")
#: Umlauts as people write them in names of files.
_SPELLED: Final = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "å": "aa", "æ": "ae", "ø": "oe"})
#: Words in names of files that identify no person.
_COMMON: Final = frozenset(
    {
        *("axis", "before", "after", "test", "measurement", "measured", "linear"),
        *("rotary", "circle", "circular", "ballbar", "backup", "parameter", "parameters"),
        *("pitch", "error", "compensation", "table", "positive", "negative", "data"),
        *("file", "files", "achse", "messung", "vorher", "nachher", "config"),
        *("configuration", "machine", "maschine", "laser", "plane", "first", "second"),
        *("joint", "entry", "para", "comp", "runs", "left", "right", "north", "south"),
    }
)
_HARMLESS: Final = ALLOWED | _COMMON


@dataclass(frozen=True, slots=True)
class _Somebody:
    """Texts in file names that identify a person or machine: ``pieces``, ``words``, ``numbers``."""

    pieces: frozenset[str]
    words: frozenset[str]
    numbers: frozenset[str]

    def is_in(self, text: str) -> bool:
        """Return whether a part of a file name contains one of these texts."""
        for spelled in _spellings(text):
            joined = "".join(_PIECE.findall(spelled))
            if (
                not self.pieces.isdisjoint(_PIECE.findall(spelled))
                or any(word in joined for word in self.words)
                or not self.numbers.isdisjoint(_numbers(spelled))
            ):
                return True
        return False


def names_of_copies(
    files: Sequence[str], removed: Iterable[tuple[str, str]], names: Names
) -> list[str]:
    """Return a file name for the copy of each of the ``files``. No two names are equal, not even if
    upper and lower case are the same. ``removed``: the texts removed from the files; ``names``: the
    neutral names.

    Each of ``removed`` is a pair of the kind of text and the text. Only those parts of a name are
    replaced that contain a text removed from any file, or that may be a serial number.
    """
    somebody = _somebody(removed)
    made: list[str] = []
    for file in files:
        name = "/".join(_shown(part, somebody, names) for part in file.split("/"))
        path, number = PurePath(name), 1
        while name.casefold() in {other.casefold() for other in made}:
            number += 1
            name = str(path.with_stem(f"{path.stem}_{number}"))
        made.append(name)
    return made


def _somebody(removed: Iterable[tuple[str, str]]) -> _Somebody:
    pieces, words, numbers = set[str](), set[str](), set[str]()
    for kind, text in removed:
        for piece in telling(_ADDRESS.sub(" ", text) if kind == LINE else text, _HARMLESS):
            if _SIZE.fullmatch(piece) is None:
                pieces.update(_spellings(piece))
        if kind != LINE:  # lines of programs hold words and numbers of every kind
            for spelled in _spellings(text):
                words.update(_WORD.findall(spelled))
                numbers.update(_numbers(spelled))
    return _Somebody(
        frozenset(pieces),
        frozenset(word for word in words if len(word) >= _LONG_WORD and word not in _HARMLESS),
        frozenset(numbers),
    )


def _shown(name: str, somebody: _Somebody, names: Names) -> str:
    """Return one part (folder or file) of a copy's name; a part that identifies a person or machine
    is replaced by a neutral name from ``names``.
    """
    stem, ending = PurePath(name).stem, PurePath(name).suffix
    if somebody.is_in(ending):
        ending = ""
    serial = _SERIAL.search(_DATED.sub(" ", stem)) is not None
    gives_away = serial or somebody.is_in(stem) or names.knows(stem)
    return f"{names.of(stem)}{ending}" if gives_away else f"{stem}{ending}"


def _spellings(text: str) -> Iterator[str]:
    """Yield spellings of a text in lower case: as it is, with umlauts spelled out, and without
    accents.
    """
    plain = unicodedata.normalize("NFC", text).casefold()
    yield plain
    if not plain.isascii():
        yield plain.translate(_SPELLED)
        bare = unicodedata.normalize("NFD", plain)
        yield "".join(mark for mark in bare if not unicodedata.combining(mark))


def _numbers(text: str) -> list[str]:
    """Return the numbers in a text that may be serial numbers, also with separators in between."""
    found = [*_NUMBER.findall(text), *_NUMBER.findall(_BETWEEN_DIGITS.sub("", text))]
    return [number for number in found if _DATED.fullmatch(number) is None]
