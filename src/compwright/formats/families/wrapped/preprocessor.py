"""Process comments, macros and conditional blocks of scripts, as the program that sends them does.

Sources: scripts of a machine as they are sent (github dhidas/IDCommon_ivu23_2.8m), for ``//``,
``#define`` and expressions; the manuals, for operators.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

#: Remarks of a line.
REMARK = re.compile(r"(?:;|//)[^\r\n]*")
DIRECTIVE = re.compile(
    r"#[ \t]*(?P<name>DEFINE|UNDEF|IFDEF|IFNDEF|IF|ELIF|ELSE|ENDIF)(?![A-Z0-9_])(?P<rest>[^\r\n]*)",
    re.IGNORECASE,
)
_MACRO = re.compile(r"\s*(?P<name>[A-Z_]\w*)(?P<value>.*)", re.IGNORECASE | re.DOTALL)
_NAME = re.compile(r"[A-Z_]\w*", re.IGNORECASE)
_TERM = re.compile(
    r"[-+]?[ \t]*(?:\$[0-9A-F]+|(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)|(?P<name>[A-Z_]\w*))",
    re.IGNORECASE,
)
_TOKEN = re.compile(r"[ \t]*(\$[0-9A-F]+|[0-9]+(?:\.[0-9]*)?|\.[0-9]+|[-+*/%&|^()])", re.IGNORECASE)
_BRACKETS = re.compile(r"\([^()\r\n]*\)")
_SUM = re.compile(r"(?<![\w.$#])[0-9]+(?:[-+*/][0-9]+)+(?![\w.])")
#: Operators that bind more tightly stand later.
_LEVELS = ("|^", "&", "+-", "*/%")
#: Macros in macros; deeper ones lead in a circle.
_DEPTH = 20
_LONGEST = 2000


@dataclass(slots=True)
class ConditionalBlock:
    """A conditional block of a script: where it begins, and the branch that is being read.

    - ``asks``: the macro or expression of its condition, with a number that grows when this may
      have changed.
    - ``truth``: the result of the condition for which its first branch is sent.
    - ``awaited``: the macro that the next directive must define if the block is an include guard.
    - ``guards``: the block is an include guard.
    """

    line: int
    text: str
    asks: tuple[str, int]
    truth: bool
    awaited: str = ""
    guards: bool = False
    branch: int = 0


@dataclass(slots=True)
class Conditions:
    """The state of the preprocessor at a line: defined macros and open conditional blocks.

    - ``macros``: the text of each macro.
    - ``changes``: how often each macro was defined or removed.
    - ``open``: the conditional blocks that contain the line.
    - ``chosen``: macros that were last defined or removed in a conditional block that is no include
      guard.
    - ``guarded``: by macro, the include guard in which it was last defined.
    """

    macros: dict[str, str] = field(default_factory=dict)
    changes: Counter[str] = field(default_factory=Counter)
    open: list[ConditionalBlock] = field(default_factory=list)
    chosen: set[str] = field(default_factory=set)
    guarded: dict[str, ConditionalBlock] = field(default_factory=dict)

    def apply(self, match: re.Match[str], line: int) -> str:
        """Process a preprocessor directive; return what is wrong with it, empty if nothing."""
        name, rest = match["name"].upper(), match["rest"]
        macro = _MACRO.fullmatch(rest) if name == "DEFINE" else None
        if self.open:
            block = self.open[-1]
            block.guards |= macro is not None and macro["name"] == block.awaited
            block.awaited = ""
        if macro is not None:
            self._define(macro["name"], macro["value"].strip())
        elif name == "UNDEF":
            self.macros.pop(rest.strip(), None)
            self._changed(rest.strip())
        elif name.startswith("IF"):
            about = "".join(rest.split())
            version = self.changes.total() if name == "IF" else self.changes[about]
            asks = f"({about})" if name == "IF" else about, version
            awaited = about if name == "IFNDEF" and version == 0 else ""
            self.open.append(
                ConditionalBlock(line, match[0].strip(), asks, name != "IFNDEF", awaited)
            )
        elif not self.open:
            return f"#{name} without the beginning of its block"
        elif name == "ENDIF":
            self.open.pop()
        else:
            self.open[-1].branch += 1
        return ""

    def _define(self, name: str, value: str) -> None:
        if self.open and self.macros.get(name) == value:
            return  # sent or not, it stays the same
        self.macros[name] = value
        self._changed(name)

    def _changed(self, name: str) -> None:
        self.changes[name] += 1
        self.chosen.discard(name)
        self.guarded.pop(name, None)
        guards = all(block.guards and block.branch == 0 for block in self.open)
        if not guards or any(name == block.asks[0] for block in self.open):
            self.chosen.add(name)
        elif self.open:
            self.guarded[name] = self.open[0]

    def undecided(self, text: str) -> str:
        """Return the first macro in ``text`` that a conditional block has possibly changed; empty
        if there is none.
        """
        return next((name for name in self._names_in(text) if name in self.chosen), "")

    def guard_of(self, text: str) -> ConditionalBlock | None:
        """Return the include guard (#ifndef block) in which a macro of ``text`` is defined."""
        return next((self.guarded[n] for n in self._names_in(text) if n in self.guarded), None)

    def _names_in(self, text: str) -> Iterator[str]:
        for _ in range(_DEPTH):
            names: list[str] = _NAME.findall(text)
            yield from names
            text = " ".join(self.macros.get(name, "") for name in names)[:_LONGEST]

    @property
    def here(self) -> tuple[tuple[ConditionalBlock, int], ...]:
        """The conditional blocks that are open at this line, each with the branch being read."""
        return tuple((block, block.branch) for block in self.open)


def in_two_branches(
    one: tuple[tuple[ConditionalBlock, int], ...], other: tuple[tuple[ConditionalBlock, int], ...]
) -> bool:
    """Return whether two places of a script are in branches of conditional blocks that exclude each
    other, so that only one of the places is sent.

    This is so in two cases: the places are in different branches of one block, or in two blocks
    with the same condition. In the second case one place is sent if the condition is true, the
    other if it is false.
    """
    return any(
        branch != another
        if mine is theirs
        else mine.asks == theirs.asks and _answer(mine, branch) is not _answer(theirs, another)
        for mine, branch in one
        for theirs, another in other
    )


def _answer(block: ConditionalBlock, branch: int) -> bool:
    return block.truth if branch == 0 else not block.truth


def expanded(text: str, macros: Mapping[str, str]) -> str:
    """Return a text with its macros expanded, nested macros included."""
    for _ in range(_DEPTH):
        found = _NAME.sub(lambda name: macros.get(name[0], name[0]), text)
        if found == text or len(found) > _LONGEST:
            break
        text = found
    return text


def in_numbers(text: str, macros: Mapping[str, str]) -> str:
    """Return a text with its macros expanded and its expressions calculated where possible."""
    text = expanded(text, macros)
    for form in (_BRACKETS, _SUM):
        for _ in range(_DEPTH):
            found = form.sub(lambda one: _number(one[0]), text)
            if found == text:
                break
            text = found
    return text


def _number(text: str) -> str:
    value = whole_value(text, {})
    return text if value is None else str(value)


def expression_end(text: str, place: int) -> int:
    """Return the end of the expression that begins at ``place``; ``place`` if there is none.

    Blanks are allowed around operators. No blank is allowed before ``&`` and ``%``, because after a
    blank these characters begin a command.
    """
    end = start = place
    while (closing := _term_end(text, start)) is not None:
        end = closing
        operator = _blanks(text, end)
        if text[operator : operator + 1] not in tuple("+-*/%&|^"):
            break
        if operator > end and text[operator] in "&%":
            break
        start = _blanks(text, operator + 1)
    return end


def _term_end(text: str, place: int) -> int | None:
    """Return the end of a term at ``place``: a number, a name, a bracket or a function call."""
    sign = re.compile(r"(?:[-+][ \t]*)?(?=\()").match(text, place)
    if sign is not None:
        return _closing(text, sign.end())
    term = _TERM.match(text, place)
    if term is not None and term["name"] and text.startswith("(", term.end()):
        return _closing(text, term.end())
    return None if term is None else term.end()


def _blanks(text: str, place: int) -> int:
    while place < len(text) and text[place] in " \t":
        place += 1
    return place


def _closing(text: str, place: int) -> int | None:
    """Return the position after the bracket that closes the one at ``place``, on its line."""
    depth = 0
    for at in range(place, len(text)):
        if text[at] in "\r\n":
            return None
        depth += (text[at] == "(") - (text[at] == ")")
        if depth == 0:
            return at + 1
    return None


def whole_value(text: str, macros: Mapping[str, str]) -> int | None:
    """Return the whole-number value of an expression; None if it has none or it is unknown here."""
    text = expanded(text, macros)
    tokens: list[str] = []
    place = 0
    while place < len(text.rstrip()):
        match = _TOKEN.match(text, place)
        if match is None or len(text) > _LONGEST:
            return None
        tokens.append(match[1])
        place = match.end()
    try:
        value = _level(tokens, 0)
    except (ValueError, ZeroDivisionError, IndexError, RecursionError):
        return None
    return int(value) if not tokens and value.denominator == 1 else None


def _level(tokens: list[str], level: int) -> Fraction:
    if level == len(_LEVELS):
        return _operand(tokens)
    value = _level(tokens, level + 1)
    while tokens and tokens[0] in _LEVELS[level]:
        operator, other = tokens.pop(0), _level(tokens, level + 1)
        if operator in "+-":
            value = value + other if operator == "+" else value - other
        elif operator == "*":
            value *= other
        elif operator == "/":
            value /= other
        else:
            value = _of_bits(operator, value, other)
    return value


def _of_bits(operator: str, one: Fraction, other: Fraction) -> Fraction:
    if one.denominator != 1 or other.denominator != 1:
        raise ValueError(operator)
    a, b = int(one), int(other)
    if operator == "%":
        return Fraction(a % b)
    return Fraction({"&": a & b, "|": a | b, "^": a ^ b}[operator])


def _operand(tokens: list[str]) -> Fraction:
    word = tokens.pop(0)
    if word in "+-":
        value = _operand(tokens)
        return -value if word == "-" else value
    if word == "(":
        value = _level(tokens, 0)
        if not tokens or tokens.pop(0) != ")":
            raise ValueError(word)
        return value
    return Fraction(int(word[1:], 16)) if word.startswith("$") else Fraction(word)
