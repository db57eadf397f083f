"""Possible runs through a SINUMERIK program: which lines with values one run can execute, and which
lines every run executes.

A condition may be true or false, but conditions of the same variable must agree. An unknown
statement may end the program. The values that the lines assign are not used here.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from compwright.formats.families.pairs.program_conditions import (
    Case,
    Decision,
    condition_of,
    expression_of,
    number_of,
    together,
    without_known_answers,
)

_GO = re.compile(r"\bGOTO(?P<way>[BFCS]?)\b\s*(?P<target>\$?\w+(?:\s*[\[(<])?)?", re.IGNORECASE)
_FIRST = re.compile(r"[A-Z]+", re.IGNORECASE)
#: The end of a program or subprogram, alone or with other words of its line. M2=3 is none: an M
#: function of spindle 2.
END = re.compile(r"(?:\bM\s*=?\s*(?:17|30|0*2)(?!\s*[-+*/.\d=])|\bRET\b)", re.IGNORECASE)
#: The end of a subprogram behind which the program that calls it goes on: M17 and M30 are the same
#: there (programming manual Job Planning, subprogram return).
#: Actions in the background, and blocks that may be skipped: their end is not that of the run.
_SYNCHRONOUS = re.compile(r"(?:/|WHEN|WHENEVER|EVERY|FROM|IDS?|DO)\b", re.IGNORECASE)
_RETURN = re.compile(r"M(?:17|30)|RET", re.IGNORECASE)
_DEFAULT = re.compile(r"\bDEFAULT\b", re.IGNORECASE)
#: Motions, speeds and switching functions: the program goes on behind them. M0, M1 and M6 may stop
#: it, or call a program.
_WORDS = re.compile(
    r"(?:(?:G0*[0-3]|M0*(?:[345789]|19|4[0-5])|[SF]\d*=?[\d.]+|[XYZABCUVW]=?[+-]?[\d.]+)\s*)+",
    re.IGNORECASE,
)
_ASKING = re.compile(r"(?:IF|WHILE|UNTIL)\b(?P<condition>.*?)(?:\bGOTO[BFCS]?\b.*)?", re.IGNORECASE)
#: A loop that counts a variable.
FOR = re.compile(r"FOR\s+(?P<counter>\w+)\s*=(?P<first>.*?)\bTO\b(?P<last>.*)", re.IGNORECASE)
_CASE = re.compile(
    r"CASE\b(?P<expression>.*?)\bOF\b"
    r"(?P<branches>(?:\s+\S+\s+GOTO[BFC]?\s+\w+)+\s*)",
    re.IGNORECASE,
)
_BRANCH = re.compile(r"\s*(?:DEFAULT|(?P<number>\S+))\s+(?P<jump>GOTO[BFC]?\s+\w+)", re.IGNORECASE)
_REPEATED = re.compile(r"REPEATB?\s+(?P<target>\w+)", re.IGNORECASE)
_CLOSING = {"ENDIF": "IF", "ENDWHILE": "WHILE", "ENDFOR": "FOR", "ENDLOOP": "LOOP"} | {
    "UNTIL": "REPEAT"
}


@dataclass(frozen=True, slots=True)
class Step:
    """One program line, reduced to what decides the order of execution.

    - ``names``: the label and the block number of the line.
    - ``code``: the statement without the contents of strings; empty if it does not affect the order
      of lines.
    - ``marked``: the line assigns a value, or calls a program that assigns values.
    - ``skipped``: the operator can skip the line (block skip).
    - ``until``: the last of the lines that are merged into this step.
    - ``sets``: the variables to which the line assigns, with their expressions.
    """

    line: int
    names: tuple[str, ...] = ()
    code: str = ""
    marked: bool = False
    skipped: bool = False
    until: int = 0
    sets: dict[str, str | None] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ProgramRuns:
    """The lines of one program (steps), with the lines that can follow each of them.

    Two more places follow the last step. The first is the end of the program, after which the
    calling program continues. The second is where all execution stops: after M2, an alarm, or an
    unknown statement.

    ``next``: by step, the indices of the steps that can follow. ``unclear``: lines of jumps with
    more than one possible label. ``decisions``: by step, its condition, if this can be evaluated.
    """

    steps: Sequence[Step]
    next: Sequence[frozenset[int]] = field(repr=False)
    unclear: tuple[int, ...] = ()
    decisions: Mapping[int, Decision] = field(default_factory=dict)

    def consistent(self) -> Iterator[ProgramRuns]:
        """Yield the possible runs for each combination of condition results that can occur."""
        setting = {place: step.sets for place, step in enumerate(self.steps) if step.sets}

        def behind(place: int) -> set[int]:
            return set().union(*(self._reached(one) for one in self.next[place]))

        stop = {len(self.steps) + 1}
        sure = [
            found - stop if _WORDS.fullmatch(step.code) else found
            for step, found in zip(self.steps, self.next, strict=True)
        ]
        for goes_on in together(self.decisions, setting, behind):
            follow = [goes_on.get(place, found) for place, found in enumerate(sure)]
            yield replace(self, next=tuple(follow), decisions={})

    def left_out(self) -> int | None:
        """Return the number of one line because of which no run can execute all lines that assign
        values or call programs; None if one run can execute all of them.
        """
        first: int | None = None
        for ways in self.consistent():
            past, pair = next(ways.unreached(), None), ways.exclusive()
            if past is None and pair is None:
                return None
            line = past[0] if past is not None else 0 if pair is None else pair[1]
            first = line if first is None else first
        return first

    def unreached(self) -> Iterator[tuple[int, int]]:
        """Yield the lines with values that no run executes, each with the line whose jump leads
        past it.
        """
        reached = self._reached()
        for place, step in enumerate(self.steps):
            if step.marked and place not in reached:
                yield step.line, self._passing(place)

    def exclusive(self) -> tuple[int, int] | None:
        """Return the numbers of two lines with values of which a run executes at most one; None if
        there are no such lines.
        """
        marked = [place for place, step in enumerate(self.steps) if step.marked]
        after = {place: self._reached(place) for place in marked}
        for i, one in enumerate(marked):
            for other in marked[i + 1 :]:
                if other not in after[one] and one not in after[other]:
                    return self.steps[one].line, self.steps[other].line
        return None

    def unavoidable(self, lines: Collection[int]) -> list[int]:
        """Return those of the ``lines`` of which every complete run executes at least one.

        If all runs execute the same line, only this line is returned, else those that can be the
        first in a run. Empty if a run can skip all of them.
        """
        found: list[int] = []
        for ways in self.consistent():
            some = ways._unavoidable(lines)  # noqa: SLF001 - of its own class
            if not some:
                return []
            found += some
        return sorted(set(found))

    def _unavoidable(self, lines: Collection[int]) -> list[int]:
        among: dict[int, int] = {}
        for place, step in enumerate(self.steps):
            for line in range(step.line, max(step.line, step.until) + 1) if step.marked else ():
                if line in lines:
                    among.setdefault(place, line)
        ends, past = {len(self.steps), len(self.steps) + 1}, self._reached(without=among)
        if ends & past:
            return []
        first = [place for place in among if place == 0 or any(place in self.next[i] for i in past)]
        for place in first:
            if not ends & self._reached(without={place}):
                return [among[place]]
        return [among[place] for place in first]

    def returns(self) -> bool:
        """Return whether every run reaches the end of the program or never ends."""
        return len(self.steps) + 1 not in self._reached()

    def _reached(self, start: int = 0, without: Collection[int] = ()) -> set[int]:
        seen: set[int] = set()
        waiting = [start]
        while waiting:
            place = waiting.pop()
            if place in seen or place in without:
                continue
            seen.add(place)
            if place < len(self.steps):
                waiting += self.next[place]
        return seen

    def _passing(self, place: int) -> int:
        """Return the number of the nearest line before step ``place`` after which the next line is
        never executed.
        """
        before = (i for i in range(place - 1, -1, -1) if i + 1 not in self.next[i])
        return self.steps[next(before, 0)].line


def possible_runs(steps: Iterable[Step]) -> ProgramRuns:
    """Return the possible runs through a program."""
    kept = _merged(list(steps))
    places: dict[str, list[int]] = {}
    for place, step in enumerate(kept):
        for name in step.names:
            places.setdefault(name.upper(), []).append(place)
    blocks = _blocks(kept)
    follow, unclear, decisions = [], [], {}
    choices: dict[int, Decision | Case] = {}
    for place, step in enumerate(kept):
        found = _following(kept, place, places, blocks) if step.code else {place + 1}
        follow.append(frozenset(found | ({place + 1} if step.skipped else set())))
        if any(len(each) > 1 for each in _destinations(step.code, place, places)):
            unclear.append(step.line)
        decision = _decision(step, follow[place], place + 1)
        if decision is not None:
            decisions[place] = decision
        elif (choice := _choice(step, place, places, follow[place], len(kept) + 1)) is not None:
            choices[place] = choice
    known = without_known_answers(follow, decisions | choices, [step.sets for step in kept])
    open_ones = {place: one for place, one in decisions.items() if known[place] == follow[place]}
    return ProgramRuns(tuple(kept), tuple(known), tuple(unclear), open_ones)


def _decision(step: Step, follow: frozenset[int], after: int) -> Decision | None:
    """Return the condition of a line with both steps that can follow it: of the steps ``follow``,
    the next one (``after``) and the other one. None if the line has no condition that alone decides
    between them.
    """
    found = _ASKING.fullmatch(step.code)
    jumps = len(_GO.findall(step.code))
    condition = None if found is None or step.skipped else condition_of(found["condition"])
    here, elsewhere = follow & {after}, follow - {after}
    if condition is None or jumps > 1 or not (here and elsewhere):
        return None
    return Decision(condition, *((elsewhere, here) if jumps else (here, elsewhere)))


def _choice(
    step: Step, place: int, places: Mapping[str, Sequence[int]], follow: frozenset[int], stop: int
) -> Decision | Case | None:
    """Return the values that decide which step follows a CASE line, or a FOR line whose loop can
    have no passes, with these steps; None for other lines. ``places``: steps by label; ``follow``:
    the steps that can follow; ``stop``: the program end.
    """
    loop = None if step.skipped else FOR.fullmatch(step.code)
    if loop is not None:
        condition = condition_of(f"({loop['first']})<=({loop['last']})")
        past = follow - {place + 1}
        return None if condition is None or len(past) != 1 else Decision(condition, follow, past)
    case = None if step.skipped else _CASE.fullmatch(step.code)
    text = None if case is None else expression_of(case["expression"])
    if case is None or text is None:
        return None
    by_number: dict[float, frozenset[int]] = {}
    other = frozenset({place + 1})
    for branch in _BRANCH.finditer(case["branches"]):
        (jump,) = _GO.finditer(branch["jump"])
        targets = frozenset(_targets(jump, place, places, stop))
        if branch["number"] is None:
            other = targets
        elif (number := number_of(branch["number"])) is None:
            return None
        else:
            by_number.setdefault(number, targets)
    return Case(text, by_number, other)


def _merged(steps: list[Step]) -> list[Step]:
    """Return the steps with successive lines of values merged to one, to save time.

    A block number stays in a step's names only if a jump leads to it.
    """
    targets = set(re.findall(r"\bN\d+", " ".join(step.code.upper() for step in steps if step.code)))
    kept: list[Step] = []
    for step in steps:
        one = replace(
            step,
            names=tuple(
                name
                for name in step.names
                if not re.fullmatch(r"N\d+", name.upper()) or name.upper() in targets
            ),
        )
        plain = one.marked and not (one.names or one.code or one.skipped)
        if plain and kept and kept[-1].marked and not (kept[-1].code or kept[-1].skipped):
            kept[-1] = replace(kept[-1], until=one.line, sets=kept[-1].sets | one.sets)
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
    """The blocks (IF, loops) of a program: their opening, ELSE and closing lines, by index.

    ``ends``: the closing line of each opening line and of each ELSE. ``elses``: the ELSE of each
    IF. ``starts``: the opening line of each closing line.
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
    steps: Sequence[Step], place: int, places: Mapping[str, Sequence[int]], blocks: _Blocks
) -> set[int]:
    """Return the steps that can follow the step ``place``, a line that affects the order of
    execution. ``places``: the steps with each label; ``blocks``: the IF blocks and loops.
    """
    step, word, after, end = steps[place], _word(steps[place]), place + 1, len(steps)
    stop = end + 1
    if "GOTO" in step.code.upper():
        jumps = _GO.finditer(step.code)
        targets = set().union(*(_targets(go, place, places, stop) for go in jumps))
        always = step.code[:4].upper() == "GOTO" or _DEFAULT.search(step.code) is not None
        return targets if always else targets | {after}
    close = blocks.ends.get(place)
    if word == "IF":
        other = blocks.elses.get(place, close)
        return {after, stop} if other is None else {after, other + 1}
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
        return {after, stop}.union(*_destinations(step.code, place, places))
    if END.search(step.code) and not _SYNCHRONOUS.match(step.code):
        return {end} if _RETURN.fullmatch(step.code.strip()) else {stop}
    return {after, stop}


def _destinations(
    code: str, place: int, places: Mapping[str, Sequence[int]]
) -> Iterator[Sequence[int]]:
    """Yield, for each jump or repetition (REPEAT) in the line ``code`` of the step ``place``, the
    steps at which it can continue. ``places``: the steps with each label.
    """
    for go in _GO.finditer(code):
        yield _destinations_of(go, place, places)
    repeated = _REPEATED.match(code)
    if repeated is not None:
        yield places.get(repeated["target"].upper(), ())


def _destinations_of(
    go: re.Match[str], place: int, places: Mapping[str, Sequence[int]]
) -> Sequence[int]:
    """Return the labels to which a jump can lead, by its direction (GOTOF, GOTOB).

    GOTOF searches from its line to the end of the program. GOTOB searches from its line back to the
    start. GOTO and GOTOC search to the end, then in the lines before them.
    """
    labels = places.get((go["target"] or "").upper(), ())
    ahead = [one for one in labels if one > place]
    behind = [one for one in labels if one <= place]
    way = go["way"].upper()
    if way == "B":
        return behind[-1:]
    return ahead[:1] if ahead or way == "F" else behind


def _targets(
    go: re.Match[str], place: int, places: Mapping[str, Sequence[int]], stop: int
) -> set[int]:
    """Return the steps at which a jump (``go``) can continue: all labels if the target is computed,
    the program end (``stop``) if the target does not exist.

    A missing target stops the program, because the control gives an alarm. Only GOTOC then
    continues with the next line. GOTOS leads to the start of the program.
    """
    if go["way"].upper() == "S":
        return {0}
    if found := _destinations_of(go, place, places):
        return set(found)
    plain = re.fullmatch(r"(?!R\d+$)[A-Z_]\w+|N\d+", (go["target"] or "").upper()) is not None
    if not plain:
        return {*(one for each in places.values() for one in each), place + 1, stop}
    return {stop} if go["way"].upper() != "C" else {place + 1}
