"""Conditions of a SINUMERIK's program that depend on each other: a run in which ``R1==1`` is true
in one line has it true in the other one too, and ``R1<>1`` false, as long as R1 is not assigned
between them.

Conditions with a variable of the control (``$..``), an index or a call are left out: their value
may change at any time.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, product

#: What a statement sets that may change any variable.
ANY = "*"
#: So many combinations of values are followed; conditions beyond them may turn out either way.
_MOST = 2000
_SINGLE = re.compile(
    r"(?:(?P<name>[A-Z_]\w*)(?P<relation>==|<>|<=|>=|<|>)(?P<value>[+-]?\d+\.?\d*|TRUE|FALSE)"
    r"|(?P<negated>NOT )?(?P<flag>[A-Z_]\w*))"
)
_NAME = re.compile(r"[A-Z_]\w*")
_COMPARISON = re.compile(r"==|<>|<=|>=|<|>")
_JOINT = re.compile(r"\b(?:AND|OR|XOR)\b")
#: A bracket with at most two more inside of it.
_BRACKETED = re.compile(r"\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)")
_PLAIN_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)")
_OPERATORS = frozenset({"AND", "OR", "XOR", "NOT", "DIV", "MOD", "TRUE", "FALSE"})
_CALL = re.compile(r"([A-Z_]\w*)\(")
_TRUTH = {"TRUE": 1.0, "FALSE": 0.0}
_RELATIONS: Mapping[str, Callable[[float, float], bool]] = {
    "==": operator.eq,
    "<>": operator.ne,
    "<=": operator.le,
    ">=": operator.ge,
    "<": operator.lt,
    ">": operator.gt,
}


@dataclass(frozen=True, slots=True)
class Condition:
    """A condition as a relation of its ``subject`` and a number: of a variable, or of a whole text
    that is 1 if it is true. ``names``: the variables in it; ``truth``: its value is true or false,
    and no other number; ``text``: as written, without blanks.
    """

    subject: str
    relation: str
    value: float
    names: frozenset[str]
    truth: bool = False
    text: str = ""

    def holds(self, value: float) -> bool:
        """Return whether it is true for the subject ``value``."""
        return _RELATIONS[self.relation](value, self.value)


@dataclass(frozen=True, slots=True)
class Decision:
    """A step that continues at ``yes`` if its condition is true, else at ``no``."""

    condition: Condition
    yes: frozenset[int]
    no: frozenset[int]


def condition_of(text: str) -> Condition | None:
    """Return the condition in a text; None if its value may change from line to line."""
    text = re.sub(r"\s+", " ", text.upper().strip())
    text = _bare(re.sub(r" (?=\W)|(?<=\W) ", "", text))
    names = frozenset(_NAME.findall(text)) - _OPERATORS
    if set(_CALL.findall(text)) - _OPERATORS or any(mark in text for mark in '$["'):
        return None
    single = _SINGLE.fullmatch(text)
    if single is None or names != {single["name"] or single["flag"]}:
        whole = _bare(text[3:]) if text[:4] == "NOT(" else text
        negated = text[:4] == "NOT(" and f"({whole})" == text[3:]
        return Condition(
            whole if negated else text, "<>" if negated else "==", 1.0, names, truth=True, text=text
        )
    if single["flag"] is not None:
        relation = "==" if single["negated"] else "<>"
        return Condition(single["flag"], relation, 0.0, names, text=text)
    number = number_of(single["value"]) or 0.0
    truth = single["value"] in _TRUTH
    return Condition(single["name"], single["relation"], number, names, truth=truth, text=text)


def number_of(word: str) -> float | None:
    """Return the number of a word; None for other words."""
    if (word := word.upper()) in _TRUTH:
        return _TRUTH[word]
    return float(word) if _PLAIN_NUMBER.fullmatch(word) else None


def value_of(text: str, values: Mapping[str, float]) -> float | None:
    """Return the value of a condition without blanks, 1 if it is true; None if it is unknown, or
    if it depends on the order of operators without brackets: two comparisons, a comparison and
    AND or OR, or XOR and AND.
    """
    text = _bare(text)
    masked = _BRACKETED.sub(lambda found: f"({'0' * (len(found[0]) - 2)})", text)
    comparison = _COMPARISON.search(masked)
    joints = set(_JOINT.findall(masked))
    if "XOR" in joints or (comparison is not None and joints):
        return None
    if len(_COMPARISON.findall(masked)) > 1:
        return None
    if comparison is not None:
        left = value_of(text[: comparison.start()].strip(), values)
        right = value_of(text[comparison.end() :].strip(), values)
        if left is None or right is None:
            return None
        return float(_RELATIONS[comparison[0]](left, right))
    for word, decides in (("OR", True), ("AND", False)):
        places = [found.span() for found in re.finditer(rf"\b{word}\b", masked)]
        if places:
            begins, ends = [0, *(end for _, end in places)], [*(start for start, _ in places), None]
            parts = [
                value_of(text[begin:end].strip(), values)
                for begin, end in zip(begins, ends, strict=True)
            ]
            if any(part is not None and bool(part) is decides for part in parts):
                return float(decides)
            return None if None in parts else float(not decides)
    if re.match(r"NOT\b", text):
        value = value_of(text[3:].strip(), values)
        return None if value is None else float(not value)
    number = number_of(text)
    return values.get(text) if number is None else number


def without_known_answers(
    follow: Sequence[frozenset[int]],
    decisions: Mapping[int, Decision],
    setting: Sequence[Mapping[str, float | None]],
) -> list[frozenset[int]]:
    """Return where steps continue, without the answers that no run gives: every run that comes to
    the condition has set its variable to the same number before.

    ``follow``: where each step may continue; ``setting``: the variables that it sets.
    """
    known: dict[int, dict[str, float]] = {0: {}}
    found = list(follow)
    waiting = [0]
    while waiting:
        place = waiting.pop()
        if place >= len(follow):
            continue
        values = {} if ANY in setting[place] else dict(known[place])
        for name, number in setting[place].items():
            values.pop(name, None)
            values |= {} if number is None else {name: number}
        decision = decisions.get(place)
        value = None if decision is None else value_of(decision.condition.text, values)
        found[place] = follow[place]
        if decision is not None and value is not None:
            found[place] = decision.yes if value else decision.no
        for one in found[place]:
            before = known.get(one)
            both = {
                name: n for name, n in values.items() if before is None or before.get(name) == n
            }
            if both != before:
                known[one] = both
                waiting.append(one)
    return found


def _bare(text: str) -> str:
    """Return a text without brackets around all of it."""
    while text[:1] == "(" and text[-1:] == ")":
        depths, depth = [], 0
        for sign in text:
            depth += {"(": 1, ")": -1}.get(sign, 0)
            depths.append(depth)
        if 0 in depths[:-1]:
            break
        text = text[1:-1]
    return text


def together(
    decisions: Mapping[int, Decision],
    setting: Mapping[int, Collection[str]],
    reached: Callable[[int], set[int]],
) -> Iterator[dict[int, frozenset[int]]]:
    """Yield, for each consistent set of answers to dependent conditions, where the steps with such
    a condition continue.

    ``setting``: the variables that steps set; ``reached``: the steps that may follow a step.
    """
    uses: dict[str, list[int]] = {}
    for place, one in decisions.items():
        uses.setdefault(one.condition.subject, []).append(place)
    linked = {
        subject: places
        for subject, places in uses.items()
        if len(places) > 1
        and not _changes(decisions[places[0]].condition, places, setting, reached)
    }
    values = {
        subject: _values([decisions[place].condition for place in places])
        for subject, places in linked.items()
    }
    followed: list[str] = []
    count = 1
    for subject in sorted(values, key=lambda each: len(values[each])):
        count *= len(values[subject])
        if count <= _MOST:
            followed.append(subject)
    for taken in product(*(values[subject] for subject in followed)):
        yield {
            place: decisions[place].yes
            if decisions[place].condition.holds(value)
            else decisions[place].no
            for subject, value in zip(followed, taken, strict=True)
            for place in linked[subject]
        }


def _changes(
    condition: Condition,
    places: Sequence[int],
    setting: Mapping[int, Collection[str]],
    reached: Callable[[int], set[int]],
) -> bool:
    """Return whether a run may set a variable of the conditions in ``places`` between two of
    them.
    """
    variables = condition.names | {ANY}
    behind = set().union(*map(reached, places))
    between = (place for place, names in setting.items() if not variables.isdisjoint(names))
    return any(place in behind and not reached(place).isdisjoint(places) for place in between)


def _values(conditions: Sequence[Condition]) -> list[float]:
    """Return values of a subject for which its conditions get every possible set of answers."""
    if any(one.truth for one in conditions):
        return [0.0, 1.0]
    numbers = sorted({one.value for one in conditions})
    between = [(low + high) / 2 for low, high in pairwise(numbers)]
    return sorted([numbers[0] - 1, *numbers, *between, numbers[-1] + 1])
