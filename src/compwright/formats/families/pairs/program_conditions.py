"""Conditions of a SINUMERIK program that depend on each other, so that some runs are impossible.

If ``R1==1`` is true in one line of a run, it is also true in a later line, and ``R1<>1`` is false
there. This holds as long as R1 is not assigned between these lines.

Conditions with a variable of the control (``$..``), an index or a call are left out, because their
value may change at any time.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise, product

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
#: Two values joined by an operator of the lower and of the higher rank, the last one first.
_SUMS = re.compile(r"(?P<left>.*[\w).])(?P<sign>[+-])(?P<right>.+)")
_PRODUCTS = re.compile(r"(?P<left>.*[\w).])\s*(?P<sign>[*/]|\bDIV\b|\bMOD\b)\s*(?P<right>.+)")
_JOINT = re.compile(r"\b(?:AND|OR|XOR)\b")
_PLAIN_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)")
_OPERATORS = frozenset({"AND", "OR", "XOR", "NOT", "DIV", "MOD", "TRUE", "FALSE"})
#: What keeps a fraction; a variable of whole numbers rounds it (DEF INT: programming manual,
#: type conversions).
_ARITHMETIC = re.compile(r"R\d+")
#: Longer expressions are not calculated: each operator is a call inside another.
_LONGEST = 250
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
    """A condition of a program, as the comparison of an expression (``subject``) with a number.

    ``subject``: a variable, or a whole expression that counts as 1 if it is true. ``names``: the
    variables in it. ``truth``: its value can only be true or false, not another number. ``text``:
    the condition as written, without blanks.
    """

    subject: str
    relation: str
    value: float
    names: frozenset[str]
    truth: bool = False
    text: str = ""

    def holds(self, value: float) -> bool:
        """Return whether the condition is true if its expression has this value."""
        return _RELATIONS[self.relation](value, self.value)


@dataclass(frozen=True, slots=True)
class Decision:
    """A program line that continues at step ``yes`` if its condition is true, else at ``no``."""

    condition: Condition
    yes: frozenset[int]
    no: frozenset[int]

    def continues(self, values: Mapping[str, float]) -> frozenset[int] | None:
        """Return the step that follows if variables have these values; None if the values do not
        decide it.
        """
        value = value_of(self.condition.text, values)
        return None if value is None else self.yes if value else self.no


@dataclass(frozen=True, slots=True)
class Case:
    """A CASE line: the step that follows for each value of an expression, and the step for all
    other values (``other``).
    """

    text: str
    by_number: Mapping[float, frozenset[int]]
    other: frozenset[int]

    def continues(self, values: Mapping[str, float]) -> frozenset[int] | None:
        """Return the step that follows if variables have these values; None if the values do not
        decide it.
        """
        value = value_of(self.text, values)
        if value is None or value % 1.0 != 0.0:  # rounded, by a rule that is not confirmed
            return None
        return self.by_number.get(value, self.other)


def expression_of(text: str) -> str | None:
    """Return an expression without blanks; None if it is too long, or if its value can change
    between two lines that do not set it.
    """
    if len(text) > _LONGEST:
        return None
    text = re.sub(r"\s+", " ", text.upper().strip())
    text = re.sub(r"\bR0+(?=\d)", "R", _bare(re.sub(r" (?=\W)|(?<=\W) ", "", text)))
    calls = set(_CALL.findall(text)) - _OPERATORS
    return None if calls or any(mark in text for mark in '$["') else text


def condition_of(text: str) -> Condition | None:
    """Return the condition in a text; None if its value can change although no line of the program
    sets a variable.
    """
    expression = expression_of(text)
    if expression is None:
        return None
    text = expression
    names = frozenset(_NAME.findall(text)) - _OPERATORS
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
    """Return the number that a word states; None for a word that is no number."""
    if (word := word.upper()) in _TRUTH:
        return _TRUTH[word]
    return float(word) if _PLAIN_NUMBER.fullmatch(word) else None


def value_of(text: str, values: Mapping[str, float]) -> float | None:
    """Return the value of the expression ``text`` (1 for true), given the ``values`` of its
    variables; None if it is unknown.

    The value also counts as unknown if it depends on the order of operators without brackets. There
    are four such cases: two comparisons, a comparison with AND or OR, an XOR, and NOT with a
    calculation.
    """
    text = _bare(text)
    masked = _masked(text)
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
        calculated = _PRODUCTS.fullmatch(masked) or _SUMS.fullmatch(masked)
        value = None if calculated else value_of(text[3:].strip(), values)
        return None if value is None else float(not value)
    number = number_of(text)
    return _calculated(text, masked, values) if number is None else number


def _calculated(text: str, masked: str, values: Mapping[str, float]) -> float | None:
    """Return the whole-number result of a sum, difference, product or quotient; None if unknown.
    ``masked``: the text with zeros inside its brackets; ``values``: numbers by variable.

    A result with a fraction is unknown, because a variable of whole numbers would round it.
    """
    for pattern in (_SUMS, _PRODUCTS):
        if found := pattern.fullmatch(masked):
            left = value_of(text[: found.end("left")].strip(), values)
            right = value_of(text[found.start("right") :].strip(), values)
            if left is None or right is None:
                return None
            return _result(found["sign"], left, right)
    if text[:1] in ("+", "-"):
        value = value_of(text[1:], values)
        return -value if text[0] == "-" and value is not None else value
    return values.get(text)


def _result(sign: str, left: float, right: float) -> float | None:
    if sign in "+-*":
        result = {"+": left + right, "-": left - right, "*": left * right}[sign]
    elif right == 0.0 or (sign != "/" and min(left, right) < 0.0):
        return None
    else:
        result = {"/": left / right, "DIV": left // right, "MOD": left % right}[sign]
    return result if result % 1.0 == 0.0 else None


def without_known_answers(
    follow: Sequence[frozenset[int]],
    decisions: Mapping[int, Decision | Case],
    setting: Sequence[Mapping[str, str | None]],
) -> list[frozenset[int]]:
    """Return the steps that can follow each step. Where a condition is decided, because its
    variables have known values, the step that it excludes is left out. ``follow``: the steps before
    this check; ``setting``: the variables that each step sets.

    The values are known if every run that reaches the condition has set its variables to the same
    numbers before. ``setting`` contains the expression that is assigned to each variable.
    """
    known: dict[int, dict[str, float]] = {0: {}}
    found = list(follow)
    waiting = [0]
    while waiting:
        place = waiting.pop()
        if place >= len(follow):
            continue
        before = known[place]
        values = {} if ANY in setting[place] else dict(before)
        for name, expression in setting[place].items():
            number = None if expression is None else value_of(expression, before)
            if number is not None and number % 1.0 and _ARITHMETIC.fullmatch(name) is None:
                number = None
            values.pop(name, None)
            values |= {} if number is None else {name: number}
        decision = decisions.get(place)
        decided = None if decision is None else decision.continues(before)
        found[place] = follow[place] if decided is None else decided
        for one in found[place]:
            old = known.get(one)
            both = {name: n for name, n in values.items() if old is None or old.get(name) == n}
            if both != old:
                known[one] = both
                waiting.append(one)
    return found


def _depths(text: str) -> list[int]:
    """Return how many brackets are open at each character."""
    return list(accumulate({"(": 1, ")": -1}.get(sign, 0) for sign in text))


def _masked(text: str) -> str:
    """Return a text with zeros in place of everything inside brackets."""
    depths = _depths(text)
    return "".join(
        "0" if depth > 0 and before > 0 else sign
        for sign, depth, before in zip(text, depths, [0, *depths], strict=False)
    )


def _bare(text: str) -> str:
    """Return a text without the brackets that enclose all of it."""
    while text[:1] == "(" and text[-1:] == ")" and 0 not in _depths(text)[:-1]:
        text = text[1:-1]
    return text


def together(
    decisions: Mapping[int, Decision],
    setting: Mapping[int, Collection[str]],
    reached: Callable[[int], set[int]],
) -> Iterator[dict[int, frozenset[int]]]:
    """Yield one mapping for each possible combination of results of conditions that test the same
    value: the steps that follow each condition. ``setting``: the variables that a step sets;
    ``reached``: a function that returns all steps that can come after a step.
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
    """Return whether a variable of the condition can change between two of the steps ``places``
    that test it. ``setting``: the variables that a step sets; ``reached``: a function that returns
    all steps that can come after a step.
    """
    variables = condition.names | {ANY}
    behind = set().union(*map(reached, places))
    between = (place for place, names in setting.items() if not variables.isdisjoint(names))
    return any(place in behind and not reached(place).isdisjoint(places) for place in between)


def _values(conditions: Sequence[Condition]) -> list[float]:
    """Return test values for an expression, so that each possible combination of the conditions'
    results occurs with one of these values.
    """
    if any(one.truth for one in conditions):
        return [0.0, 1.0]
    numbers = sorted({one.value for one in conditions})
    between = [(low + high) / 2 for low, high in pairwise(numbers)]
    return sorted([numbers[0] - 1, *numbers, *between, numbers[-1] + 1])
