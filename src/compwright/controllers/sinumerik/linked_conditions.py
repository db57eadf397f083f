"""Conditions in a SINUMERIK program that depend on each other, so that some runs of the program are
impossible.

Two conditions on the same variable use the same value if no line assigns it between them. So the
program is followed once for each value that changes a result.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

#: Assigned by a statement whose effect is unknown.
EVERYTHING = "everything"
#: More answers than these are not followed: what is left may be answered in any way.
_MOST_ANSWERS = 2000
_TURNED = {"==": "==", "<>": "<>", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
_LOGIC = frozenset({"AND", "OR", "XOR", "NOT", "DIV", "MOD", "TRUE", "FALSE"})

#: What calculates, the lower rank later.
_RANKS = {"+": 0, "-": 0, "*": 1, "/": 1, "DIV": 1, "MOD": 1}

#: A block has 512 characters at most.
_MOST_WORDS = 256

Words = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Question:
    """The condition of a program line, as the comparison of an expression with a number.

    - ``what``: the expression: a variable, or the words of the whole condition.
    - ``sign``: the comparison operator. ``number``: the number it compares with.
    - ``variables``: the variables in the condition.
    - ``two``: the expression has the values 0 and 1 only.
    - ``words``: the whole condition.
    """

    what: Words
    sign: str
    number: float
    variables: frozenset[str]
    two: bool = False
    words: Words = ()

    def answer(self, value: float) -> bool:
        """Return whether the condition is true if its expression has this value."""
        less, same = value < self.number, value == self.number
        return {
            "==": same,
            "<>": not same,
            "<": less,
            ">=": not less,
            "<=": less or same,
            ">": not (less or same),
        }[self.sign]


@dataclass(frozen=True, slots=True)
class Fork:
    """A condition, and the lines that follow (a bit for each) if it is true and if it is false."""

    question: Question
    true: int
    false: int


@dataclass(frozen=True, slots=True)
class Cases:
    """A CASE, and the lines that follow (a bit for each) for each number of its expression.

    ``words``: the expression. ``by_number``: the next lines by its value. ``other``: the next lines
    for any other value.
    """

    words: Words
    by_number: Mapping[float, int]
    other: int


def question_of(words: Words) -> Question | None:
    """Return the condition that these words of a program line form; None if it cannot be evaluated
    or has too many words.
    """
    found = _question_of(words) if len(words) <= _MOST_WORDS else None
    return None if found is None else replace(found, words=words)


def _question_of(words: Words) -> Question | None:
    """Return the condition that these words of a program line form.

    Returns None if the value of the condition may change without an assignment. This is so if it
    contains a variable of the control, an array or a function.
    """
    words = _without_brackets(words)
    variables = frozenset(
        word for word in words if (word[0].isalpha() or word[0] == "_") and word not in _LOGIC
    )
    called = any(
        after == "(" and before in variables for before, after in itertools.pairwise(words)
    )
    if not words or called or any(word[0] in "$[\"'" for word in words):
        return None
    if words[0] == "NOT" and len(words) > 1:
        rest = _without_brackets(words[1:])
        if len(rest) == 1:
            return Question(rest, "==", 0.0, variables)
        if len(rest) < len(words) - 1:
            return Question(rest, "<>", 1.0, variables, two=True)
    if len(words) == 1:
        return Question(words, "<>", 0.0, variables)
    signed = _signed(words)
    if len(signed) == 3 and signed[1] in _TURNED:
        left, sign, right = signed
        if left not in variables:
            left, sign, right = right, _TURNED[sign], left
        number = plain_number(right)
        if number is not None and variables == {left}:
            return Question((left,), sign, number, variables, two=right in ("TRUE", "FALSE"))
    return Question(words, "==", 1.0, variables, two=True)


def answered(
    forks: Mapping[int, Fork],
    assigning: Mapping[int, Mapping[str, Words | None]],
    behind: Callable[[int], int],
) -> Iterator[dict[int, int]]:
    """Yield the lines that can follow each conditional line in ``forks`` (as bits), once for each
    possible combination of results of the conditions that compare the same expression.

    ``assigning``: by line index, the variables that the line assigns. ``behind``: the function that
    returns the lines that can be executed after a line, as bits.
    """
    places: dict[Words, list[int]] = {}
    for place, fork in forks.items():
        places.setdefault(fork.question.what, []).append(place)
    candidates: dict[Words, list[float]] = {}
    for what, same_question in places.items():
        variables = forks[same_question[0]].question.variables | {EVERYTHING}
        among = sum(1 << place for place in same_question)
        changed = any(
            not variables.isdisjoint(names)
            and behind(place) & among
            and any(behind(one) >> place & 1 for one in same_question)
            for place, names in assigning.items()
        )
        if len(same_question) > 1 and not changed:
            candidates[what] = _candidates([forks[place].question for place in same_question])
    taken, size = [], 1
    for what in sorted(candidates, key=lambda one: (len(candidates[one]), one)):
        size *= len(candidates[what])
        if size > _MOST_ANSWERS:
            break
        taken.append(what)
    for values in itertools.product(*map(candidates.__getitem__, taken)):
        goes_on = {}
        for what, value in zip(taken, values, strict=True):
            for place in places[what]:
                fork = forks[place]
                goes_on[place] = fork.true if fork.question.answer(value) else fork.false
        yield goes_on


def ways_by_values(
    every: Sequence[int],
    forks: Mapping[int, Fork | Cases],
    assigned: Sequence[Mapping[str, Words | None]],
) -> list[int]:
    """Return each line's possible next lines (a bit for each), given the values that the variables
    may have at that line. ``every``: all next lines, whatever the values are; ``assigned``: the
    variables that each line sets.

    ``forks``: the conditions and CASEs by line index. For each line, the values that a variable may
    have before it are collected; None means any value. A line that no run reaches keeps its next
    lines from ``every``.
    """
    asked = {name for names in assigned for name in names}
    before: dict[int, dict[str, frozenset[float | None]]] = {
        0: dict.fromkeys(asked, frozenset({None}))
    }
    ways = list(every)
    changed = True
    while changed:
        changed = False
        for place in sorted(before):
            if place >= len(every):
                continue
            values = before[place]
            ways[place] = _open_ways(every[place], forks.get(place), values)
            single = _single(values)
            known = {
                name: frozenset({None if words is None else _stored(name, _result(words, single))})
                for name, words in assigned[place].items()
            }
            if EVERYTHING in assigned[place]:
                values = dict.fromkeys(asked, frozenset({None}))
            values = values | known
            for after in range(ways[place].bit_length()):
                if not ways[place] >> after & 1:
                    continue
                old = before.get(after, {})
                new = {name: old.get(name, frozenset()) | values[name] for name in asked}
                if after not in before or new != old:
                    before[after], changed = new, True
    return ways


def _stored(name: str, value: float | None) -> float | None:
    """Return the value that a variable has after an assignment; None if rounding is uncertain."""
    whole = value is None or value.is_integer()
    return value if whole or (name[:1] == "R" and name[1:].isdecimal()) else None


def _single(values: Mapping[str, frozenset[float | None]]) -> dict[str, float | None]:
    return {name: next(iter(one)) for name, one in values.items() if len(one) == 1}


def _open_ways(
    every: int, fork: Fork | Cases | None, values: Mapping[str, frozenset[float | None]]
) -> int:
    if fork is None:
        return every
    if isinstance(fork, Cases):
        number = _result(fork.words, _single(values))
        if number is None or number % 1.0:  # a CASE rounds: how is in no page
            return every
        return fork.by_number.get(number, fork.other)
    if len(fork.question.what) == 1 and fork.question.what[0] in fork.question.variables:
        answers = {
            None if value is None else fork.question.answer(value)
            for value in values.get(fork.question.what[0], {None})
        }
    else:
        result = _result(fork.question.words, _single(values))
        answers = {None if result is None else result != 0.0}
    if None in answers or len(answers) > 1:
        return every
    return fork.true if True in answers else fork.false


def _result(words: Words, values: Mapping[str, float | None]) -> float | None:
    """Return the value of a logical or whole-number expression; None if it is unknown.

    The result is None for XOR. It is also None for a comparison, without brackets, next to another
    comparison, OR or AND.
    """
    words = _without_brackets(words)
    depth, outer = 0, list[tuple[str, int]]()
    for at, word in enumerate(words):
        depth += (word == "(") - (word == ")")
        outer += [(word, at)] if depth == 0 else []
    comparisons = [place for word, place in outer if word in _TURNED]
    if len(comparisons) > 1 or any(word == "XOR" for word, _ in outer):
        return None
    joints = [at for joint in ("OR", "AND") for word, at in outer if word == joint]
    if comparisons:
        (compared,) = comparisons
        one = _result(words[:compared], values)
        other = _result(words[compared + 1 :], values)
        if joints or one is None or other is None:
            return None
        return float(Question((), words[compared], other, frozenset()).answer(one))
    if joints:
        parts = (words[: joints[0]], words[joints[0] + 1 :])
        pair = [None if (one := _result(each, values)) is None else bool(one) for each in parts]
        decides = words[joints[0]] == "OR"
        return float(decides) if decides in pair else None if None in pair else float(not decides)
    binary = [at for word, at in outer if word in _RANKS and at and words[at - 1] not in _RANKS]
    if words[:1] == ("NOT",):
        inner = None if binary else _result(words[1:], values)
        return None if inner is None else float(not inner)
    if binary:
        lowest = min(_RANKS[words[at]] for at in binary)
        at = max(at for at in binary if _RANKS[words[at]] == lowest)
        left, right = _result(words[:at], values), _result(words[at + 1 :], values)
        return None if left is None or right is None else _calculated(left, words[at], right)
    if words[:1] in (("-",), ("+",)):
        inner = _result(words[1:], values)
        return -inner if words[0] == "-" and inner is not None else inner
    number = plain_number("".join(words))
    return values.get("".join(words)) if number is None else number


def _calculated(left: float, operator: str, right: float) -> float | None:
    """Return the whole-number result of a calculation; None if the result is not whole."""
    if operator not in ("+", "-", "*") and right == 0.0:
        return None
    if operator in ("DIV", "MOD") and (left < 0.0 or right < 0.0):
        return None  # how the control rounds is in no page
    match operator:
        case "+":
            found = left + right
        case "-":
            found = left - right
        case "*":
            found = left * right
        case "/":
            found = left / right
        case "DIV":
            found = left // right
        case _:
            found = left % right
    return found if found % 1.0 == 0.0 else None


def _candidates(questions: Sequence[Question]) -> list[float]:
    if any(one.two for one in questions):
        return [0.0, 1.0]
    numbers = sorted({one.number for one in questions})
    found = [numbers[0] - 1.0]
    for number in numbers:
        found += [(found[-1] + number) / 2 if len(found) > 1 else number - 0.5, number]
    return [*found, numbers[-1] + 1.0]


def _without_brackets(words: Words) -> Words:
    while len(words) > 2 and words[0] == "(" and words[-1] == ")":
        inside, depth = words[1:-1], 0
        for word in inside:
            depth += (word == "(") - (word == ")")
            if depth < 0:
                return words
        words = inside
    return words


def _signed(words: Words) -> Words:
    """Return the words of an expression, in which each sign is joined to the next number."""
    if len(words) == 4 and words[2] in "+-" and words[1] in _TURNED:
        return words[0], words[1], words[2] + words[3]
    return words


def plain_number(word: str) -> float | None:
    """Return the number that a word states (TRUE is 1, FALSE is 0); None for other words."""
    if word in ("TRUE", "FALSE"):
        return float(word == "TRUE")
    return float(word) if re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)", word) else None
