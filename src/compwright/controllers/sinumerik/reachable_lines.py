"""Find the lines of a SINUMERIK program that one run can execute.

For each line, the set of lines that may follow it is stored as bits of a whole number. The sets are
extended until nothing changes. A condition may be true or false; linked conditions have consistent
results (module `linked_conditions`). An unknown statement may stop everything. Two places follow
the last line: the end, after which the calling program continues, and the stop of everything.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from compwright.controllers.sinumerik.linked_conditions import (
    EVERYTHING,
    Cases,
    Fork,
    answered,
    plain_number,
    question_of,
    ways_by_values,
)


@dataclass(frozen=True, slots=True)
class Doubt:
    """A statement that may change the order of execution.

    ``call``: the name of the called program, if the statement is only a call; else empty.
    """

    line: int
    text: str
    call: str = ""


_JUMPS = frozenset({"GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS"})
_OPENS = {"IF": "ENDIF", "WHILE": "ENDWHILE", "FOR": "ENDFOR", "LOOP": "ENDLOOP"} | {
    "REPEAT": "UNTIL"
}
_OVER = re.compile(r"M0*2|M17|M30|RET")
#: Ends of a subprogram that lead back to the calling program.
_BACK = (("M17",), ("M30",), ("RET",))
#: Motions, speeds and functions behind which the program goes on.
_GOES_ON = re.compile(
    r"G0*[0-3]|M0*[345789]|M19|M4[0-5]|[SF][\d.]+|[A-CU-Z][\d.]+|[A-CU-ZSF]|=|-|[\d.]+"
)
_NAME = re.compile(r"N\d+|(?!R\d+$)[A-Z_]\w+")


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a program, reduced to its effect on the order of execution.

    - ``number``: line number in the file.
    - ``names``: labels and block number to which a jump may lead.
    - ``words``: its words in capitals; empty if they do not affect the order of lines.
    - ``skipped``: the line is not executed while block skip is on.
    - ``given``: the line assigns compensation data, or calls a program of the files.
    - ``mentions``: programs that the line may call.
    - ``conditional``: the line is not executed in every case.
    - ``assigned``: the program's own variables that the line assigns, with the words of their
      values; None for an unknown value.
    """

    number: int
    names: frozenset[str]
    words: tuple[str, ...]
    skipped: bool = False
    given: bool = False
    mentions: frozenset[str] = frozenset()
    conditional: bool = False
    assigned: Mapping[str, tuple[str, ...] | None] = field(default_factory=dict)


def _shortened(lines: Sequence[Line]) -> tuple[list[Line], list[set[int]]]:
    """Return the lines with successive assignments merged into one line, and the line numbers that
    each new line replaces.
    """
    used = (word for line in lines for words in line.assigned.values() for word in words or ())
    wanted = {word for line in lines for word in line.words} | {EVERYTHING, *used}
    found: list[Line] = []
    groups: list[set[int]] = []
    for line in lines:
        quiet = not (line.words or line.skipped or line.names & wanted)
        behind = found and found[-1].given and not (found[-1].words or found[-1].skipped)
        if quiet and line.given and behind and not wanted & line.assigned.keys():
            groups[-1].add(line.number)
        elif line.given or wanted & line.assigned.keys() or not quiet:
            found.append(line)
            groups.append({line.number})
    return found, groups


def conflicts(lines: Sequence[Line]) -> tuple[int, int] | None:
    """Return an assignment that no run executes, or two that no run executes together. None if
    there is no conflict.

    The result is two line numbers. The second is 0 if no run executes the assignment. With linked
    conditions, each combination of results may exclude another assignment. Then both numbers are
    that of the assignment excluded first.
    """
    short, _ = _shortened(lines)
    found = _conflict(short, _possible(short)[0])
    if found is not None:
        return found
    for ways in _in_step(short):
        other = _conflict(short, ways)
        if other is None:
            return None
        found = found or (other[0], other[1] or other[0])
    return found


def _conflict(short: Sequence[Line], ways: Sequence[int]) -> tuple[int, int] | None:
    behind = _reachable_after(ways)
    given = [place for place, line in enumerate(short) if line.given]
    for place in given:
        if place and not behind[0] >> place & 1:
            return short[place].number, 0
    for i, one in enumerate(given):
        for other in given[i + 1 :]:
            if not (behind[one] >> other & 1 or behind[other] >> one & 1):
                return short[other].number, short[one].number
    return None


def inevitable(lines: Sequence[Line], among: Collection[int]) -> list[int]:
    """Return those lines of ``among`` that runs execute, if every run of the program executes at
    least one of them.

    ``lines``: the lines of the program. ``among``: line numbers of assignments. The result is empty
    if a run can avoid all of them.
    """
    short, groups = _shortened(lines)
    found: set[int] = set()
    for follow in _in_step(short):
        some = _inevitable(short, groups, follow, among)
        if not some:
            return []
        found |= set(some)
    return sorted(found)


def _inevitable(
    short: Sequence[Line], groups: Sequence[set[int]], follow: Sequence[int], among: Collection[int]
) -> list[int]:
    end = 3 << len(short)  # the end and the stop
    hit = [min(group & set(among), default=0) for group in groups]

    def reached(closed: set[int]) -> int:
        return (
            _reachable_after([0 if place in closed else bits for place, bits in enumerate(follow)])[
                0
            ]
            | 1
        )

    every = {place for place, line in enumerate(short) if line.given and hit[place]}
    open_places = reached(every)
    if open_places & end or not every:
        return []
    first = [place for place in sorted(every) if open_places >> place & 1]
    alone = next((place for place in first if not reached({place}) & end), None)
    return [hit[place] for place in (first if alone is None else [alone])]


def _in_step(lines: Sequence[Line]) -> Iterator[list[int]]:
    """Yield each line's possible next lines (as bits), once for each possible combination of
    results of linked conditions.

    After motions and switching functions, the program always continues with the next line.
    """
    every, forks = _possible(lines)
    behind = _reachable_after(every)
    assigning = {place: line.assigned for place, line in enumerate(lines) if line.assigned}
    stop = 1 << len(lines) + 1
    sure = [
        bits & ~stop if line.words and all(map(_GOES_ON.fullmatch, line.words)) else bits
        for line, bits in zip(lines, every, strict=True)
    ]
    for goes_on in answered(forks, assigning, behind.__getitem__):
        yield [goes_on.get(place, bits) for place, bits in enumerate(sure)]


def _possible(lines: Sequence[Line]) -> tuple[list[int], dict[int, Fork]]:
    """Return each line's possible next lines (as bits), and the conditions whose result the
    program's values leave open.
    """
    every = _next(lines)
    forks = {
        place: fork
        for place, line in enumerate(lines)
        if (fork := _fork(line, every[place], 1 << place + 1)) is not None
    }
    names = _labels(lines)
    choices = {
        place: choice
        for place, line in enumerate(lines)
        if (choice := _choice(line, every[place], place, len(lines) + 1, names)) is not None
    }
    ways = ways_by_values(every, forks | choices, [line.assigned for line in lines])
    return ways, {place: fork for place, fork in forks.items() if ways[place] == every[place]}


def _choice(
    line: Line, bits: int, place: int, stop: int, names: Mapping[str, Sequence[int]]
) -> Fork | Cases | None:
    """Return the branches of the line with index ``place`` if it is a CASE, or a FOR that may be
    skipped; None for other lines. ``bits``: all its next lines; ``stop``: the index of the
    program's end.
    """
    words, after = line.words, 1 << place + 1
    if line.skipped:
        return None
    if words[:1] == ("FOR",) and words[2:3] == ("=",) and "TO" in words and bits & ~after:
        to = words.index("TO")
        limits = ("(", *words[3:to], ")", "<=", "(", *words[to + 1 :], ")")
        question = question_of(limits)
        return None if question is None else Fork(question, bits, bits & ~after)
    if words[:1] != ("CASE",) or "OF" not in words:
        return None
    of = words.index("OF")
    begin, by_number, other = of + 1, dict[float, int](), after
    for at in (i for i, word in enumerate(words) if word in _JUMPS):
        target = _target(words[at], words[at + 1 : at + 3], place, stop, names)
        label, begin = words[begin:at], at + 2
        if label == ("DEFAULT",):
            other = target
        elif (number := plain_number("".join(label))) is None:
            return None
        else:
            by_number.setdefault(number, target)
    if question_of(words[1:of]) is None or begin < len(words):
        return None
    return Cases(words[1:of], by_number, other)


def _fork(line: Line, bits: int, after: int) -> Fork | None:
    if line.skipped or line.words[:1] not in (("IF",), ("WHILE",), ("UNTIL",)):
        return None
    jumps = [i for i, word in enumerate(line.words) if word in _JUMPS]
    here, there = bits & after, bits & ~after
    question = question_of(line.words[1 : jumps[0] if jumps else None])
    if question is None or len(jumps) > 1 or not (here and there):
        return None
    return Fork(question, there, here) if jumps else Fork(question, here, there)


def always_returns(lines: Sequence[Line]) -> bool:
    """Return whether every run of a subprogram returns to its caller."""
    return not lines or not _reachable_after(_next(lines))[0] >> len(lines) + 1 & 1


def unclear_jumps(lines: Sequence[Line]) -> list[int]:
    """Return the line numbers of jumps and repetitions to a label that occurs several times."""
    names = _labels(lines)
    found = []
    for place, line in enumerate(lines):
        words = line.words
        labels = [
            _sought(word, words[i + 1], place, names)
            for i, word in enumerate(words[:-1])
            if word in _JUMPS
        ]
        if words[:1] in (("REPEAT",), ("REPEATB",)) and len(words) > 1:
            labels.append(names.get(words[1], []))
        if any(len(each) > 1 for each in labels):
            found.append(line.number)
    return found


def _labels(lines: Sequence[Line]) -> dict[str, list[int]]:
    found: dict[str, list[int]] = {}
    for place, line in enumerate(lines):
        for name in line.names:
            found.setdefault(name, []).append(place)
    return found


def _sought(jump: str, name: str, place: int, names: Mapping[str, Sequence[int]]) -> list[int]:
    """Return the lines with the label ``name`` at which a jump from the line with index ``place``
    may arrive. ``names``: the indices of the lines with each label.

    GOTOB searches backwards from its own line. GOTOF searches forwards from the next line. GOTO and
    GOTOC search forwards; if no such line follows, every earlier line with the label is returned.
    """
    back = [one for one in names.get(name, ()) if one <= place]
    on = [one for one in names.get(name, ()) if one > place]
    if jump == "GOTOB":
        return [max(back)] if back else []
    if on:
        return [min(on)]
    return [] if jump == "GOTOF" else back


def _reachable_after(follow: Sequence[int]) -> list[int]:
    """Return for each line the lines that may be executed at any time after the line."""
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
    """Return for each line the lines that may be executed next, as a number with one bit per line.

    Bit i stands for the line with index i. The two bits after those of the last line stand for the
    end of the program and for the stop of everything.
    """
    names = _labels(lines)
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
            ways[each] |= 1 << each + 1 | 1 << len(lines) + 1
    return ways


def _closed(word: str, place: int, start: int, other: int, ways: list[int]) -> int:
    """Enter into ``ways`` the next lines (as bits) of a block's opening line ``start`` and of its
    ELSE line ``other`` (-1: none); return those of its closing line ``place``, which begins with
    ``word``.
    """
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


def _own_ways(line: Line, place: int, end: int, names: Mapping[str, Sequence[int]]) -> int:
    words, after, stop = line.words, 1 << place + 1, end + 1
    jumps = [i for i, word in enumerate(words) if word in _JUMPS]
    if jumps:
        bits = 0
        for i in jumps:
            bits |= _target(words[i], words[i + 1 : i + 3], place, stop, names)
        return bits if jumps[0] == 0 or "DEFAULT" in words else bits | after
    if words[0] in ("REPEAT", "REPEATB") and len(words) > 1 and words[1] in names:
        return after | 1 << stop | sum(1 << one for one in names[words[1]])
    conditional = words[0] in ("WHEN", "WHENEVER", "EVERY", "FROM", "ID", "IDS", "DO")
    if conditional or not ends_here(words):
        return after | 1 << stop
    return 1 << end if words in _BACK else 1 << stop


def ends_here(words: Sequence[str]) -> bool:
    """Return whether one of the words ends the program: M2, M17, M30, RET.

    An M word before an equals sign does not end the program, because it is a function of another
    spindle.
    """
    behind = (*words[1:], "")
    return any(
        _OVER.fullmatch(word) is not None and follows != "="
        for word, follows in zip(words, behind, strict=True)
    )


def _target(
    jump: str, words: Sequence[str], place: int, stop: int, names: Mapping[str, Sequence[int]]
) -> int:
    after = 1 << place + 1
    if jump == "GOTOS":
        return 1
    name = words[0] if words else ""
    found = _sought(jump, name, place, names)
    worked_out = _NAME.fullmatch(name) is None or tuple(words[1:2]) in (("[",), ("(",), ("<<",))
    if worked_out:
        found = [one for each in names.values() for one in each]
        return after | 1 << stop | sum(1 << one for one in set(found))
    if found:
        return sum(1 << one for one in found)
    return after if jump == "GOTOC" else 1 << stop
