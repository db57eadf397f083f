"""Which lines of a SINUMERIK's program can be carried out in one run of it.

Every line has a set of lines behind it (bits of a whole number), grown until nothing changes. A
condition may turn out either way; a line that is not understood may end the program.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Doubt:
    """A statement that may change what is carried out."""

    line: int
    text: str


_JUMPS = frozenset({"GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS"})
_OPENS = {"IF": "ENDIF", "WHILE": "ENDWHILE", "FOR": "ENDFOR", "LOOP": "ENDLOOP"} | {
    "REPEAT": "UNTIL"
}
_NAME = re.compile(r"N\d+|(?!R\d+$)[A-Z_]\w+")


@dataclass(frozen=True, slots=True)
class Line:
    """One line: its ``number``, the ``names`` to which a jump may lead, and its ``words`` in
    capitals, none where it does not matter for the order of lines. ``skipped``: with block skip on.
    ``given``: an assignment, or a call of a program of the files. ``mentions``: the names in it;
    ``before``: what stands before it that may keep it from being carried out.
    """

    number: int
    names: frozenset[str]
    words: tuple[str, ...]
    skipped: bool = False
    given: bool = False
    mentions: frozenset[str] = frozenset()
    before: Doubt | None = None


def _shortened(lines: Sequence[Line]) -> tuple[list[Line], list[set[int]]]:
    """Return the lines without assignments that follow one another and to which nothing jumps, and
    the numbers for which each of them counts.
    """
    wanted = {word for line in lines for word in line.words}
    found: list[Line] = []
    groups: list[set[int]] = []
    for line in lines:
        quiet = not (line.words or line.skipped or line.names & wanted)
        behind = found and found[-1].given and not (found[-1].words or found[-1].skipped)
        if quiet and line.given and behind:
            groups[-1].add(line.number)
        elif line.given or not quiet:
            found.append(line)
            groups.append({line.number})
    return found, groups


def conflicts(lines: Sequence[Line]) -> tuple[int, int] | None:
    """Return the number of an assignment that no run carries out, and 0; or of two that no run
    carries out both; None where one run can carry all of them out.
    """
    short, _ = _shortened(lines)
    behind = _behind(_next(short))
    given = [place for place, line in enumerate(short) if line.given]
    for place in given:
        if place and not behind[0] >> place & 1:
            return short[place].number, 0
    for i, one in enumerate(given):
        for other in given[i + 1 :]:
            if not (behind[one] >> other & 1 or behind[other] >> one & 1):
                return short[other].number, short[one].number
    return None


def inevitable(lines: Sequence[Line]) -> set[int]:
    """Return the numbers of assignments that every run carries out."""
    short, groups = _shortened(lines)
    follow = _next(short)
    found: set[int] = set()
    for place, line in enumerate(short):
        without = [0 if i == place else bits for i, bits in enumerate(follow)]
        if line.given and (place == 0 or not _behind(without)[0] >> len(short) & 1):
            found |= groups[place]
    return found


def _behind(follow: Sequence[int]) -> list[int]:
    """Return for every line the lines to which a run may come behind it."""
    behind = list(follow)
    changed = True
    while changed:
        changed = False
        for place in reversed(range(len(behind))):
            bits, rest = behind[place], behind[place]
            while rest:
                lowest = rest & -rest
                rest ^= lowest
                if lowest.bit_length() <= len(behind):
                    bits |= behind[lowest.bit_length() - 1]
            changed = changed or bits != behind[place]
            behind[place] = bits
    return behind


def _next(lines: Sequence[Line]) -> list[int]:
    """Return for every line the lines that may be carried out next, as bits; the bit behind the
    last line is the end.
    """
    names = {name: place for place, line in reversed(list(enumerate(lines))) for name in line.names}
    ways = [1 << place + 1 for place in range(len(lines))]
    opened: list[tuple[str, int, int]] = []  # the word that closes, the place, that of an ELSE
    for place, line in enumerate(lines):
        if not line.words:
            continue
        word, bits = line.words[0], _own_ways(line, place, len(lines), names)
        repeats = word == "REPEAT" and len(line.words) > 1
        if word in _OPENS and not (_JUMPS & set(line.words) or repeats):
            opened.append((_OPENS[word], place, -1))
            bits = 1 << place + 1
        elif word == "ELSE" and opened and opened[-1][0] == "ENDIF":
            opened[-1] = "ENDIF", opened[-1][1], place
            bits = 0  # ENDIF, once it is found
        elif opened and word == opened[-1][0]:
            bits = _closed(word, place, *opened.pop()[1:], ways)
        ways[place] = bits | (1 << place + 1 if line.skipped else 0)
    for _, place, other in opened:  # never closed: nothing is certain
        for each in (place, *([other] if other >= 0 else [])):
            ways[each] |= 1 << each + 1 | 1 << len(lines)
    return ways


def _closed(word: str, place: int, start: int, other: int, ways: list[int]) -> int:
    """Set where the lines of a block lead, and return where its closing line does."""
    after = 1 << place + 1
    if word == "ENDIF":
        ways[start] |= 1 << (other + 1 if other >= 0 else place)
        if other >= 0:
            ways[other] |= 1 << place
        return after
    if word in ("ENDWHILE", "ENDFOR"):
        ways[start] |= after
        return 1 << start
    return 1 << start if word == "ENDLOOP" else 1 << start + 1 | after


def _own_ways(line: Line, place: int, end: int, names: dict[str, int]) -> int:
    words, after = line.words, 1 << place + 1
    jumps = [i for i, word in enumerate(words) if word in _JUMPS]
    if jumps:
        bits = 0
        for i in jumps:
            bits |= _target(words[i], words[i + 1 : i + 3], after, end, names)
        return bits if jumps[0] == 0 or "DEFAULT" in words else bits | after
    if words[0] in ("REPEAT", "REPEATB") and len(words) > 1 and words[1] in names:
        return after | 1 << end | 1 << names[words[1]]
    over = any(re.fullmatch(r"M0*2|M17|M30|RET", word) for word in words)
    conditional = words[0] in ("WHEN", "WHENEVER", "EVERY", "FROM", "ID", "IDS", "DO")
    return 1 << end if over and not conditional else after | 1 << end


def _target(jump: str, words: Sequence[str], after: int, end: int, names: dict[str, int]) -> int:
    if jump == "GOTOS":
        return 1
    name = words[0] if words else ""
    if name in names:
        return 1 << names[name]
    worked_out = _NAME.fullmatch(name) is None or tuple(words[1:2]) in (("[",), ("(",), ("<<",))
    if worked_out:
        bits = after | 1 << end
        for place in names.values():
            bits |= 1 << place
        return bits
    return after if jump == "GOTOC" else 1 << end
