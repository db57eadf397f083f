"""A small SINUMERIK of one's own: programs with their flow, write protection, what an axis does.

Written from the programming manual's syntax, the facts on EEC, CEC and MD32450, and the makers'
programs inside a real archive. It shares nothing with compwright.

A value of ``$AA_ENC_COMP`` moves the axis against its sign; between points it is linear, outside the
end values hold. MD32450 acts in the direction against the reference return (here: return in +).
While MD32700 is effective, values and grid of that axis are write protected: the control skips the
line, or stops the file there (``stops``). Machine data become effective with NEWCONF, and at a reset.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from harm_measuring import table_value

_TOKEN = re.compile(
    r"""\s*(?:(?P<text>"[^"]*")|(?P<hex>'[^']*')|(?P<number>\d+\.?\d*(?:EX-?\d+)?|\.\d+)
    |(?P<name>\$?\$?[A-Z_][A-Z_0-9]*)|(?P<mark><>|==|<=|>=|[-+*/()\[\],=<>:]))""",
    re.VERBOSE,
)
_JUMPS = {"GOTO", "GOTOF", "GOTOB", "GOTOC"}
_OPEN = {"IF": "ENDIF", "WHILE": "ENDWHILE", "FOR": "ENDFOR", "LOOP": "ENDLOOP", "REPEAT": "UNTIL"}
_CALLS = {"CALL", "PCALL", "EXTCALL", "MCALL"}
_WORDS = re.compile(r"(?:[GMTFSDHXYZ]\d+(?:\.\d+)?)+$")
_STEPS = 5000


class Alarm(Exception):  # noqa: N818 - the control's own word
    """The control stops the program."""


@dataclass
class Block:
    """One line: label, number, tokens, whether it is skipped where block skip is on."""

    label: str
    number: str
    words: list[str]
    skippable: bool


def blocks_of(text: str) -> list[Block]:
    return [_block(line) for line in text.splitlines()]


def _block(line: str) -> Block:
    plain = re.sub(r'("[^"]*")|;.*', lambda found: found[1] or "", line).strip()
    if plain.startswith("%"):
        plain = ""
    skip = re.match(r"/\d?\s*", plain)
    plain = plain[skip.end() :] if skip else plain
    number = re.match(r"[N:](\d+)\s*", plain, re.IGNORECASE)
    plain = plain[number.end() :] if number else plain
    label = re.match(r"([A-Za-z_]\w+)\s*:\s*", plain)
    plain = plain[label.end() :] if label else plain
    words = [found[0].strip() for found in _tokens(plain)]
    return Block(
        label[1].upper() if label else "", "N" + number[1] if number else "", words, bool(skip)
    )


def _tokens(plain: str) -> Iterator[re.Match[str]]:
    at, end = 0, len(plain)
    upper = "".join(
        part if part.startswith('"') else part.upper() for part in re.split(r'("[^"]*")', plain)
    )
    while at < end and upper[at:].strip():
        found = _TOKEN.match(upper, at)
        if found is None:
            raise Alarm(f"12080 syntax error: {plain[at:]!r}")
        yield found
        at = found.end()


@dataclass
class Control:
    """Memory of the control. ``worlds`` vary what a file does not say: R parameters, block skip, calls."""

    memory: dict[str, float | str] = field(default_factory=dict)
    effective: dict[str, float] = field(default_factory=dict)
    stops: bool = False
    block_skip: bool = False
    programs: Mapping[str, str] = field(default_factory=dict)
    skipped: list[str] = field(default_factory=list)
    alarms: list[str] = field(default_factory=list)

    def reset(self) -> None:
        """Power on: all machine data become effective."""
        self.effective = {
            name: float(value)
            for name, value in self.memory.items()
            if name.startswith("$MA_ENC_COMP_ENABLE") and not isinstance(value, str)
        }

    def load(self, text: str) -> bool:
        """Carry a file out; False where the control stopped it."""
        try:
            _Program(self, blocks_of(text)).run()
        except Alarm as alarm:
            self.alarms.append(str(alarm))
            return False
        return True

    def value(self, name: str) -> float:
        return float(self.memory.get(name, 0.0))

    def write(self, name: str, value: float | str) -> None:
        found = re.match(r"\$AA_ENC_COMP\w*\[(\d),(?:\d+,)?(\w+)\]", name)
        if found and self.effective.get(f"$MA_ENC_COMP_ENABLE[{found[1]},{found[2]}]"):
            if self.stops:
                raise Alarm(f"17020 {name} is write protected")
            self.skipped.append(name)
            return
        self.memory[name] = value

    def correction(self, axis: str, position: float, direction: int, system: int = 0) -> float:
        """Give what the axis adds to the command."""
        shift = 0.0
        if self.effective.get(f"$MA_ENC_COMP_ENABLE[{system},{axis}]"):
            shift -= self._table(axis, system, position)
        if direction < 0:
            shift -= self.value(f"$MA_BACKLASH[{system},{axis}]")
        return shift

    def _table(self, axis: str, system: int, position: float) -> float:
        low, high, step = (
            self.value(f"$AA_ENC_COMP_{key}[{system},{axis}]") for key in ("MIN", "MAX", "STEP")
        )
        if step <= 0:
            return 0.0
        count = round((high - low) / step) + 1
        if self.value(f"$AA_ENC_COMP_IS_MODULO[{system},{axis}]"):
            position = low + (position - low) % (high - low)
        values = [self.value(f"$AA_ENC_COMP[{system},{i},{axis}]") for i in range(count)]
        return table_value([low + i * step for i in range(count)], values, position)


class _Program:
    """One running program: block pointer, open loops."""

    def __init__(self, control: Control, blocks: Sequence[Block]) -> None:
        self.control, self.blocks = control, blocks
        self.at, self.steps, self.loops = 0, 0, dict[int, float]()

    def run(self, first: int = 0, last: int | None = None) -> bool:
        """Carry out from ``first`` to the end, or to ``last``; True where the program ended itself."""
        self.at, end = first, len(self.blocks) if last is None else last + 1
        while self.at < end:
            self.steps += 1
            if self.steps > _STEPS:
                raise Alarm("the program does not end")
            block, self.at = self.blocks[self.at], self.at + 1
            if block.skippable and self.control.block_skip:
                continue
            if self._block(block.words):
                return True
        return False

    def _block(self, words: list[str]) -> bool:
        if not words:
            return False
        head = words[0]
        if head in {"RET", "M17", "M30", "M2", "M02"}:
            return True
        if head in _JUMPS:
            self._jump(words[0], words[1])
        elif head in _FLOW:
            _FLOW[head](self, words)
        elif head in _CALLS or re.fullmatch(r"L\d+", head) or self._is_call(words):
            self._call(words)
        elif head == "DEF":
            self._assign(_definitions(words))
        elif head not in {"PROC", "METRIC", "INCH", "CHANDATA", "MSG", "STOPRE", "EXTERN"}:
            if head == "NEWCONF":
                self.control.reset()
            elif not _WORDS.match(head) or "=" in words:
                self._assign(words)
        return False

    def _is_call(self, words: list[str]) -> bool:
        return len(words) == 1 and words[0] in self.control.programs

    def _call(self, words: list[str]) -> None:
        named = "".join(words[1:]) if words[0] in _CALLS else words[0]
        text = self.control.programs.get(named.strip('"').upper())
        if text is not None:
            _Program(self.control, blocks_of(text)).run()

    def _assign(self, words: list[str]) -> None:
        at = 0
        while at < len(words):
            name, at = _address(words, at, self._value)
            if at >= len(words) or words[at] != "=":
                raise Alarm(f"12080 syntax error at {name}")
            at += 1
            if name.endswith("_AXIS" + name[name.find("[") :]) and words[at] == "(":
                self.control.write(name, words[at + 1])
                at += 3
                continue
            value, at = _Expression(words, at, self._value).whole()
            self.control.write(name, value)

    def _value(self, name: str) -> float:
        return self.control.value(name)

    def _true(self, words: Sequence[str], at: int) -> tuple[bool, int]:
        value, at = _Expression(list(words), at, self._value).whole()
        return bool(value), at

    def _jump(self, how: str, label: str) -> None:
        here = self.at
        order = {
            "GOTOF": range(here, len(self.blocks)),
            "GOTOB": range(here - 1, -1, -1),
        }.get(how, [*range(here, len(self.blocks)), *range(here)])
        for place in order:
            if label in {self.blocks[place].label, self.blocks[place].number}:
                self.at = place
                return
        if how != "GOTOC":
            raise Alarm(f"14080 jump destination {label} not found")

    def _if(self, words: list[str]) -> None:
        true, at = self._true(words, 1)
        if at < len(words) and words[at] in _JUMPS:
            if true:
                self._jump(words[at], words[at + 1])
        elif not true:
            self.at = self._close("IF", self.at, ("ELSE", "ENDIF")) + 1

    def _else(self, _words: list[str]) -> None:
        self.at = self._close("IF", self.at, ("ENDIF",)) + 1

    def _case(self, words: list[str]) -> None:
        value, at = _Expression(words, 1, self._value).whole()
        if words[at] == "OF":
            at += 1
        while at < len(words):
            if words[at] == "DEFAULT":
                self._jump(words[at + 1], words[at + 2])
                return
            constant, at = _Expression(words, at, self._value).whole()
            if constant == value:
                self._jump(words[at], words[at + 1])
                return
            at += 2

    def _while(self, words: list[str]) -> None:
        true, _ = self._true(words, 1)
        if not true:
            self.at = self._close("WHILE", self.at, ("ENDWHILE",)) + 1

    def _for(self, words: list[str]) -> None:
        here = self.at - 1
        name, at = _address(words, 1, self._value)
        first, at = _Expression(words, at + 1, self._value).whole()
        last, _ = _Expression(words, at + 1, self._value).whole()
        now = self.loops[here] + 1 if here in self.loops else first
        self.loops[here] = now
        self.control.memory[name] = now
        if now > last:
            del self.loops[here]
            self.at = self._close("FOR", self.at, ("ENDFOR",)) + 1

    def _back(self, kind: str) -> None:
        depth = 0
        for place in range(self.at - 2, -1, -1):
            head = self.blocks[place].words[:1]
            if head == [_OPEN[kind]]:
                depth += 1
            elif head == [kind] and self._opens(self.blocks[place].words):
                if depth == 0:
                    self.at = place
                    return
                depth -= 1
        raise Alarm(f"12640 {kind} missing")

    def _until(self, words: list[str]) -> None:
        true, _ = self._true(words, 1)
        if not true:
            self._back("REPEAT")

    def _repeat(self, words: list[str]) -> None:
        if len(words) == 1:
            return
        labels = [word for word in words[1:] if any(word == block.label for block in self.blocks)]
        times = int(words[words.index("=") + 1]) if "=" in words else 1
        first = next(i for i, block in enumerate(self.blocks) if block.label == labels[0])
        here = self.at
        last = here - 2
        if words[0] == "REPEATB":
            last = first
        elif len(labels) > 1:
            last = next(i for i, block in enumerate(self.blocks) if block.label == labels[1])
        for _ in range(times):
            self.run(first, last)
        self.at = here

    @staticmethod
    def _opens(words: list[str]) -> bool:
        """Whether a head opens a block: an IF with a jump and a REPEAT with a label do not."""
        if words[0] == "IF":
            return not _JUMPS & set(words)
        return words[0] != "REPEAT" or len(words) == 1

    def _close(self, kind: str, first: int, ends: Sequence[str]) -> int:
        depth = 0
        for place in range(first, len(self.blocks)):
            words = self.blocks[place].words
            if not words:
                continue
            if words[0] == kind and self._opens(words):
                depth += 1
            elif depth == 0 and words[0] in ends:
                return place
            elif words[0] == _OPEN[kind]:
                depth -= 1
        raise Alarm(f"12640 {ends[-1]} missing")


_FLOW: dict[str, Callable[[_Program, list[str]], None]] = {
    "IF": _Program._if,
    "ELSE": _Program._else,
    "ENDIF": lambda _program, _words: None,
    "CASE": _Program._case,
    "WHILE": _Program._while,
    "ENDWHILE": lambda program, _words: program._back("WHILE"),
    "FOR": _Program._for,
    "ENDFOR": lambda program, _words: program._back("FOR"),
    "LOOP": lambda _program, _words: None,
    "ENDLOOP": lambda program, _words: program._back("LOOP"),
    "REPEAT": _Program._repeat,
    "REPEATB": _Program._repeat,
    "UNTIL": _Program._until,
}


def _definitions(words: list[str]) -> list[str]:
    """Give the assignments of a DEF line."""
    given: list[str] = []
    for i, word in enumerate(words):
        if word == "=":
            given += [words[i - 1], "=", words[i + 1]]
    return given


def _address(words: list[str], at: int, value: Callable[[str], float]) -> tuple[str, int]:
    """Read a name with its indices; an index may be an expression."""
    name, at = words[at], at + 1
    if at >= len(words) or words[at] != "[":
        return name, at
    indices: list[str] = []
    while words[at] != "]":
        start = at + 1
        if re.fullmatch(r"[A-Z_]\w*", words[start]) and words[start + 1] in {",", "]"}:
            known = re.fullmatch(r"R\d+", words[start])
            indices.append(f"{int(value(words[start]))}" if known else words[start])
            at = start + 1
        else:
            index, at = _Expression(words, start, value).whole()
            indices.append(f"{int(index)}")
    return f"{name}[{','.join(indices)}]", at + 1


class _Expression:
    """Numbers, names, + - * / comparisons, AND OR NOT XOR, ABS and ROUND."""

    def __init__(self, words: list[str], at: int, value: Callable[[str], float]) -> None:
        self.words, self.at, self.value = words, at, value

    def whole(self) -> tuple[float, int]:
        left = self._compared()
        while self._next() in {"AND", "OR", "XOR"}:
            word = self._take()
            right = bool(self._compared())
            left = float(
                {"AND": bool(left) and right, "OR": bool(left) or right}.get(
                    word, bool(left) != right
                )
            )
        return left, self.at

    def _next(self) -> str:
        return self.words[self.at] if self.at < len(self.words) else ""

    def _take(self) -> str:
        self.at += 1
        return self.words[self.at - 1]

    def _compared(self) -> float:
        if self._next() == "NOT":
            self._take()
            return float(not self._compared())
        left = self._sum()
        marks: dict[str, Callable[[float, float], bool]] = {
            "==": lambda a, b: a == b,
            "<>": lambda a, b: a != b,
            "<": lambda a, b: a < b,
            ">": lambda a, b: a > b,
            "<=": lambda a, b: a <= b,
            ">=": lambda a, b: a >= b,
        }
        if self._next() in marks:
            return float(marks[self._take()](left, self._sum()))
        return left

    def _sum(self) -> float:
        left = self._product()
        while self._next() in {"+", "-"}:
            left = left + self._product() if self._take() == "+" else left - self._product()
        return left

    def _product(self) -> float:
        left = self._single()
        while self._next() in {"*", "/"}:
            left = left * self._single() if self._take() == "*" else left / self._single()
        return left

    def _single(self) -> float:
        word = self._next()
        if word in {"+", "-"}:
            self._take()
            return self._single() * (1 if word == "+" else -1)
        if word == "(":
            self._take()
            inner, self.at = _Expression(self.words, self.at, self.value).whole()
            self._take()
            return inner
        if word in {"ABS", "ROUND"}:
            self._take()
            inner = self._single()
            return abs(inner) if word == "ABS" else float(round(inner))
        if word in {"TRUE", "FALSE"}:
            return float(self._take() == "TRUE")
        if word.startswith("'H"):
            return float(int(self._take()[2:-1], 16))
        if re.fullmatch(r"[\d.]+(EX-?\d+)?", word):
            return float(self._take().replace("EX", "e"))
        if word.startswith('"'):
            self._take()
            return 0.0
        name, self.at = _address(self.words, self.at, self.value)
        return self.value(name)


def table_text(
    axis: str, values: Sequence[float], low: float, step: float, system: int = 0, end: str = "M17"
) -> str:
    """Write a plain table with its grid, as a control writes it."""
    rows = [f"$AA_ENC_COMP[{system},{i},{axis}]={value:.4f}" for i, value in enumerate(values)]
    rows += grid_of(axis, len(values), low, step, system)
    return "\n".join(["CHANDATA(1)", *rows, *([end] if end else [])]) + "\n"


def grid_of(axis: str, count: int, low: float, step: float, system: int = 0) -> list[str]:
    return [
        f"$AA_ENC_COMP_STEP[{system},{axis}]={step}",
        f"$AA_ENC_COMP_MIN[{system},{axis}]={low}",
        f"$AA_ENC_COMP_MAX[{system},{axis}]={low + step * (count - 1)}",
        f"$AA_ENC_COMP_IS_MODULO[{system},{axis}]=0",
    ]
