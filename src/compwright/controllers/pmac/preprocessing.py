"""Preprocess a script for the virtual control: remove comments, expand macros, mark conditions.

It shares no code with the package that writes scripts: Python's own grammar evaluates expressions.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

_DIRECTIVE = re.compile(r"#\s*(DEFINE|UNDEF|IFDEF|IFNDEF|IF|ELIF|ELSE|ENDIF)\b(.*)")
_WORD = re.compile(r"[A-Z_]\w*")
_OPERATORS: dict[type, Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Mod: operator.mod,
}
_OF_BITS: dict[type, Callable[[int, int], int]] = {
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
}
_TOKEN = re.compile(r"\s*(\$[0-9A-F]+|\d+\.?\d*|\.\d+|[A-Z_]\w*|[-+*/|^&%()])")
_LONGEST = 500
_ROUNDS = 20


#: Line, branch, question (a value or a name, which, how often it was changed), answer.
Block = tuple[int, int, tuple[bool, str, int], bool]


def apart(here: Sequence[Block], there: Sequence[Block]) -> bool:
    """Return whether two places of a script are in conditional branches that exclude each other."""
    return any(
        branch != its if begun == other else queried == question and answered is not answer
        for begun, branch, queried, answered in here
        for other, its, question, answer in there
    )


@dataclass(slots=True)
class Preprocessor:
    """The macros and the open conditional blocks at a line of a script.

    - ``macros``: text of each macro by name.
    - ``uncertain``: macros that a conditional block has defined or removed.
    - ``blocks``: every open conditional block: line where it begins, number of its branch,
      condition, and the result of the condition that leads into this branch.
    - ``counts``: how often each macro was defined or removed; under the empty name, the count for
      all macros.
    - ``guards``: lines of the include guards. These are blocks ``#IFNDEF NAME`` directly followed
      by ``#DEFINE NAME``, for a name that no earlier line defines.
    - ``expected``: the name of a possible include guard, between these two lines.
    - ``in_guards``: macros that are defined inside an include guard.
    """

    macros: dict[str, str] = field(default_factory=dict)
    blocks: list[Block] = field(default_factory=list)
    counts: dict[str, int] = field(default_factory=dict)
    uncertain: set[str] = field(default_factory=set)
    guards: set[int] = field(default_factory=set)
    expected: str | None = None
    in_guards: set[str] = field(default_factory=set)

    def takes(self, line: str, number: int) -> str | None:
        """Process a preprocessor line; return its fault as text, empty if it has none. Return None
        for any other line.

        ``line``: the line without comments. ``number``: its line number. A line that is not for the
        preprocessor is a command for the card.
        """
        match = _DIRECTIVE.fullmatch(line.strip())
        if match is None:
            return None
        name, rest = match.group(1), match.group(2).strip()
        expected, self.expected = self.expected, None
        if name == "DEFINE":
            macro, _, value = rest.replace("\t", " ").partition(" ")
            if macro == expected:
                self.guards.add(self.blocks[-1][0])
            elif self.blocks and self.macros.get(macro) == value.strip():
                return ""  # the same text as before
            self.macros[macro] = value.strip()
            self._changed(macro, certain=macro != expected)
        elif name == "UNDEF":
            self.macros.pop(rest, None)
            self._changed(rest)
        elif name.startswith("IF"):
            queried = "" if name == "IF" else rest
            question = name == "IF", re.sub(r"\s", "", rest), self.counts.get(queried, 0)
            self.blocks.append((number, 0, question, name != "IFNDEF"))
            self.guards.discard(number)  # of another file
            if name == "IFNDEF" and rest not in self.counts:
                self.expected = rest
        elif not self.blocks:
            return f"#{name} outside of a block"
        elif name == "ENDIF":
            self.blocks.pop()
        else:
            begun, branch, question, answer = self.blocks.pop()
            self.blocks.append((begun, branch + 1, question, answer is (branch > 0)))
        return ""

    def _changed(self, macro: str, *, certain: bool = True) -> None:
        guarded = all(line in self.guards and not branch for line, branch, _, _ in self.blocks)
        self.uncertain -= {macro}
        self.in_guards -= {macro}
        if not (certain and guarded):
            self.uncertain |= {macro}
        elif self.blocks:
            self.in_guards |= {macro}
        for name in (macro, ""):
            self.counts[name] = self.counts.get(name, 0) + 1

    def may_differ(self, text: str) -> bool:
        """Return whether the text depends on a macro that a conditional block defines or
        removes.
        """
        return not self._words(text).isdisjoint(self.uncertain)

    def behind_guard(self, text: str) -> bool:
        """Return whether the text uses a macro that is defined inside an include guard."""
        return not self._words(text).isdisjoint(self.in_guards)

    def _words(self, text: str) -> set[str]:
        words = set(_WORD.findall(text))
        for _ in range(_ROUNDS):
            inner = (self.macros.get(word, "") for word in words)
            words |= {word for value in inner for word in _WORD.findall(value)}
        return words

    def put_in(self, text: str) -> str:
        """Return a text with its macros expanded."""
        for _ in range(_ROUNDS):
            after = _WORD.sub(lambda word: self.macros.get(word.group(), word.group()), text)
            if after == text or len(after) > _LONGEST:
                return after
            text = after
        return text


def without_remarks(line: str) -> str:
    """Return a line of a script without its remark (comment)."""
    return re.split(r";|//", line, maxsplit=1)[0]


def expression(text: str) -> str:
    """Return the expression at the beginning of a text.

    The expression ends before a blank that is followed by a command such as ``&1`` or ``%100``.
    """
    place = good = depth = 0
    wanted = True
    while (match := _TOKEN.match(text, place)) is not None:
        word, apart = match.group(1), match.start(1) > place
        if wanted and (word in "+-" or word == "("):
            depth += word == "("
        elif wanted and (word[0] in "$." or word[0].isalnum() or word[0] == "_"):
            wanted = False
        elif not wanted and word == ")" and depth:
            depth -= 1
        elif not wanted and word == "(" and not apart:
            depth, wanted = depth + 1, True
        elif not wanted and word in "+-*/|^&%" and (word not in "&%" or not apart or depth):
            wanted = True
        else:
            break
        place = match.end()
        good = good if wanted or depth else place
    return text[:good]


def calculated(text: str) -> float | None:
    """Return the value of an expression of plain numbers; None if it cannot be calculated."""
    if len(text) > _LONGEST or re.search(r"[^-+*/%&|^()\s.\dA-F$]|\*\*|//", text):
        return None
    plain = re.sub(r"\$([\dA-F]+)", r"0x\1", text.strip())
    plain = re.sub(r"(?<![\dxA-F.])0+(?=\d)", "", plain)
    try:
        return _number(ast.parse(plain, mode="eval").body)
    except (SyntaxError, ValueError, TypeError, ZeroDivisionError, RecursionError, OverflowError):
        return None


def _number(point: ast.expr) -> float:
    if isinstance(point, ast.Constant) and isinstance(point.value, int | float):
        return point.value
    if isinstance(point, ast.UnaryOp) and isinstance(point.op, ast.UAdd | ast.USub):
        value = _number(point.operand)
        return -value if isinstance(point.op, ast.USub) else value
    if isinstance(point, ast.BinOp):
        left, right = _number(point.left), _number(point.right)
        if type(point.op) in _OPERATORS:
            return _OPERATORS[type(point.op)](left, right)
        if type(point.op) in _OF_BITS and left == int(left) and right == int(right):
            return _OF_BITS[type(point.op)](int(left), int(right))
    raise ValueError(ast.dump(point))
