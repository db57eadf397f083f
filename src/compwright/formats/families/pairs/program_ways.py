"""The ways through a SINUMERIK's program: which values a run can carry out, and which it must.

Conditions may go either way, an unknown statement may end the program. Nothing here knows values.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

_GO = re.compile(r"\bGOTO(?P<way>[BFCS]?)\b\s*(?P<target>\$?\w+(?:\s*[\[(<])?)?", re.IGNORECASE)
_FIRST = re.compile(r"[A-Z]+", re.IGNORECASE)
_END = re.compile(r"(?:\bM\s*=?\s*(?:17|30|0*2)(?!\s*[-+*/.\d])|\bRET\b)", re.IGNORECASE)
_DEFAULT = re.compile(r"\bDEFAULT\b", re.IGNORECASE)
_REPEATED = re.compile(r"REPEATB?\s+(?P<target>\w+)", re.IGNORECASE)
_CLOSING = {"ENDIF": "IF", "ENDWHILE": "WHILE", "ENDFOR": "FOR", "ENDLOOP": "LOOP"} | {
    "UNTIL": "REPEAT"
}


@dataclass(frozen=True, slots=True)
class Step:
    """A line of a program. ``name``: its label or block number; ``code``: what it does, strings
    emptied, empty where that leaves the order of the lines alone; ``marked``: it is one of those
    that are asked about (a value, a call); ``skipped``: on the control's block skip; ``until``: the
    last of the lines that it is followed by in any case.
    """

    line: int
    name: str = ""
    code: str = ""
    marked: bool = False
    skipped: bool = False
    until: int = 0


@dataclass(frozen=True, slots=True)
class ProgramWays:
    """Steps of one program with the steps that may follow each; behind the last one is the end."""

    steps: Sequence[Step]
    next: Sequence[frozenset[int]] = field(repr=False)

    def unreached(self) -> Iterator[tuple[int, int]]:
        """Yield the lines of marked steps that no run comes to, each with the line that leads past
        it.
        """
        reached = self._from(0)
        for place, step in enumerate(self.steps):
            if step.marked and place not in reached:
                yield step.line, self._passing(place)

    def exclusive(self) -> tuple[int, int] | None:
        """Return the lines of two marked steps that no run comes to both; None without such."""
        marked = [place for place, step in enumerate(self.steps) if step.marked]
        after = {place: self._from(place) for place in marked}
        for i, one in enumerate(marked):
            for other in marked[i + 1 :]:
                if other not in after[one] and one not in after[other]:
                    return self.steps[one].line, self.steps[other].line
        return None

    def certain(self) -> Iterator[int]:
        """Yield the lines of marked steps that every run comes to."""
        for place, step in enumerate(self.steps):
            if step.marked and len(self.steps) not in self._from(0, without=place):
                yield from range(step.line, max(step.line, step.until) + 1)

    def _from(self, start: int, without: int = -1) -> set[int]:
        seen: set[int] = set()
        waiting = [start]
        while waiting:
            place = waiting.pop()
            if place in seen or place == without:
                continue
            seen.add(place)
            if place < len(self.steps):
                waiting += self.next[place]
        return seen

    def _passing(self, place: int) -> int:
        """Return the line before ``place`` behind which no run goes on to the next line."""
        before = (i for i in range(place - 1, -1, -1) if i + 1 not in self.next[i])
        return self.steps[next(before, 0)].line


def ways_through(steps: Iterable[Step]) -> ProgramWays:
    """Return the ways through a program."""
    kept = _merged(list(steps))
    places = {step.name.upper(): i for i, step in reversed(list(enumerate(kept))) if step.name}
    blocks = _blocks(kept)
    follow = []
    for place, step in enumerate(kept):
        found = _following(kept, place, places, blocks) if step.code else {place + 1}
        follow.append(frozenset(found | ({place + 1} if step.skipped else set())))
    return ProgramWays(tuple(kept), tuple(follow))


def _merged(steps: list[Step]) -> list[Step]:
    """Return the steps, marked ones behind each other as one: an export has thousands. Block
    numbers to which nothing jumps are no names.
    """
    text = " ".join(step.code.upper() for step in steps if step.code)
    targets = set(re.findall(r"\bN\d+", text))
    kept: list[Step] = []
    for step in steps:
        idle = re.fullmatch(r"N\d+", step.name.upper()) and step.name.upper() not in targets
        one = replace(step, name="") if idle else step
        plain = one.marked and not (one.name or one.code or one.skipped)
        if plain and kept and kept[-1].marked and not (kept[-1].code or kept[-1].skipped):
            kept[-1] = replace(kept[-1], until=one.line)
        else:
            kept.append(one)
    return kept


def _word(step: Step) -> str:
    first = _FIRST.match(step.code)
    word = "" if first is None else first[0].upper()
    if word == "IF" and _GO.search(step.code):
        return "GOTO"
    return "AGAIN" if word == "REPEATB" or _REPEATED.match(step.code) else word


@dataclass(slots=True)
class _Blocks:
    """``ends``: by the place of an opening line and of ELSE where the block closes; ``elses``: by
    an IF its ELSE; ``starts``: by a closing line where the block opens.
    """

    ends: dict[int, int] = field(default_factory=dict)
    elses: dict[int, int] = field(default_factory=dict)
    starts: dict[int, int] = field(default_factory=dict)


def _blocks(steps: Sequence[Step]) -> _Blocks:
    found, waiting = _Blocks(), list[tuple[str, int]]()
    for place, step in enumerate(steps):
        word = _word(step)
        if word in _CLOSING.values():
            waiting.append((word, place))
        elif word == "ELSE" and waiting and waiting[-1][0] == "IF":
            found.elses[waiting[-1][1]] = place
        elif word in _CLOSING and waiting and waiting[-1][0] == _CLOSING[word]:
            start = waiting.pop()[1]
            found.starts[place] = start
            found.ends[start] = place
            if start in found.elses:
                found.ends[found.elses[start]] = place
    return found


def _following(
    steps: Sequence[Step], place: int, places: Mapping[str, int], blocks: _Blocks
) -> set[int]:
    """Return the places to which a run may go on from a line that is no plain one."""
    step, word, after, end = steps[place], _word(steps[place]), place + 1, len(steps)
    if "GOTO" in step.code.upper():
        targets = set().union(*(_targets(go, place, places, end) for go in _GO.finditer(step.code)))
        always = step.code[:4].upper() == "GOTO" or _DEFAULT.search(step.code) is not None
        return targets if always else targets | {after}
    close = blocks.ends.get(place)
    if word == "IF":
        other = blocks.elses.get(place, close)
        return {after} if other is None else {after, other + 1}
    if word == "ELSE" and close is not None:
        return {close}
    if word in ("WHILE", "FOR") and close is not None:
        return {after, close + 1}
    start = blocks.starts.get(place)
    if start is not None:
        again = start + 1 if word == "UNTIL" else start
        return {"ENDIF": {after}, "ENDLOOP": {again}}.get(word, {again, after})
    if word in ("ENDIF", "LOOP", "REPEAT"):
        return {after}
    if word == "AGAIN":
        repeated = _REPEATED.match(step.code)
        target = None if repeated is None else places.get(repeated["target"].upper())
        return {after, end} | (set() if target is None else {target})
    if _END.search(step.code):
        return {end} if _first_word_ends(step.code) else {after, end}
    return {after, end}


def _first_word_ends(code: str) -> bool:
    return re.match(r"(?:/|WHEN|WHENEVER|EVERY|FROM|IDS?|DO)\b", code, re.IGNORECASE) is None


def _targets(go: re.Match[str], place: int, places: Mapping[str, int], end: int) -> set[int]:
    """Return where a jump leads: every label where only the running program knows it."""
    if go["way"].upper() == "S":
        return {0}
    name = (go["target"] or "").upper()
    if name in places:
        return {places[name]}
    plain = re.fullmatch(r"(?!R\d+$)[A-Z_]\w+|N\d+", name) is not None
    if not plain:
        return {*places.values(), place + 1, end}
    return {end} if go["way"].upper() != "C" else {place + 1}
