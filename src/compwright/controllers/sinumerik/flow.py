"""Check whether the statements of a SINUMERIK program let every assignment be executed.

A file of this control is a part program. These statements may prevent the execution of an
assignment, or lead to others: jumps (GOTOF, GOTOB, CASE), branches (IF), loops (FOR, WHILE, LOOP,
REPEAT), calls (CALL, L100, PCALL, EXTCALL, a subprogram by its name), synchronised actions (WHEN ..
DO), skipped blocks (/) and stops. Only a short list of statements certainly has no such effect. Any
other statement is a doubt if an assignment follows it in the same program.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from compwright.controllers.sinumerik.linked_conditions import EVERYTHING, Words, question_of
from compwright.controllers.sinumerik.reachable_lines import Doubt, Line, ends_here

#: Words with which a statement begins that leaves the order of the blocks alone.
_QUIET = frozenset({"CHANDATA", "METRIC", "INCH", "NEWCONF", "STOPRE", "MSG", "DEF", "EXTERN"})
_QUIET_G = frozenset(
    {0, 1, 17, 18, 19, 40, 53, 54, 55, 56, 57, 500, 60, 64, 90, 91, 94, 95, 70, 71, 700, 710}
)
_ONLY_G = re.compile(r"(?:G\d+\s*)+", re.IGNORECASE)
_DWELL = re.compile(r"G0?4\s*[FS]\s*=?\s*[\d.]+", re.IGNORECASE)
#: G words for the unit of lengths: 70 and 700 inch, 71 and 710 mm.
_LENGTHS = re.compile(r"(?<![A-Z_$])G(7[01]0?)(?!\d)", re.IGNORECASE)
#: Endings of the headers whose contents a control carries out as soon as it loads them.
_LOADED = re.compile(r"%_N_\w*(?:INI|TEA|SEA|OPT|EEC|CEC|QEC)(?!\w)", re.IGNORECASE)
_CALLED = re.compile(r"[._](?:SPF|CYC)(?!\w)", re.IGNORECASE)
#: Functions without any effect but their value.
_CALCULATE = re.compile(
    "A?SIN|A?COS|TAN|ATAN2|SQRT|ABS|POT|TRUNC|ROUND(UP)?|LN|EXP|MINVAL|MAXVAL|BOUND|SET|REP|SPI"
    "|AXNAME|AXSTRING|AXTOSPI|NUMBER|ISNUMBER|STRLEN|SUBSTR|R?INDEX|MINDEX|TOUPPER|TOLOWER|SPRINT"
    "|CTRANS|CROTS?|CRPL|CSCALE|CMIRROR|CFINE"
)
#: Behind one of these the program may go on somewhere else, or with another branch.
_FORKS = frozenset(
    {"IF", "ELSE", "ENDIF", "CASE", "GOTO", "GOTOF", "GOTOB", "GOTOC", "GOTOS", "FOR", "ENDFOR"}
    | {"WHILE", "ENDWHILE", "LOOP", "ENDLOOP", "REPEAT", "REPEATB", "UNTIL"}
)
_CONDITIONS = frozenset({"IF", "CASE", "WHEN", "WHENEVER", "EVERY", "FROM", "ID", "IDS", "DO"})
#: A word of an address, no call of a subprogram and no R parameter.
_ADDRESS = re.compile(r"(?![LPR]\d)[A-Z]\d*\.?\d*|=|[+-]|[\d.]+")
_STOP = re.compile(r"M0*[01]")
_NUMBER = re.compile(r"\s*(?P<number>[N:]\d+)?\s*(?P<skipped>/\d?)?\s*", re.IGNORECASE)
#: The name of a program in a header or a file's name.
_TITLE = re.compile(
    r"(?:%_N_|_N_)?([A-Z_]{2}\w*?|L\d+)(?:[._](?:SPF|MPF|CYC|INI|TXT|NC))?", re.IGNORECASE
)
_MENTIONED = re.compile(r"(?<![\w$])(?:_N_)?([A-Z_]{2}\w*?|L\d+)(?:[._](?:SPF|MPF|CYC))?(?!\w)")
_CALLERS = frozenset({"DO", "SETINT", "INIT", "EXECSTRING"})
#: Words that name a program without calling it.
_NAMES_ONLY = frozenset({"PROC", "EXTERN", "DEFINE"})
_TARGET = re.compile(r"(?P<name>[A-Z_]\w+)\s*:(?!=)", re.IGNORECASE)
_WORDS = re.compile(r"\$?[A-Z_]\w*|[\d.]+\w*|<<|<>|[<>=]=|'\w*'?|\"\"|\S", re.IGNORECASE)
#: R050 is R50.
_R_ZEROS = re.compile(r"^R0+(?=\d)")
_SUM = re.compile(r"\s+'[0-9A-F]{4}\s*$", re.IGNORECASE)
#: A name as a whole statement, with or without arguments: a call, if no word of the language.
_CALL = re.compile(
    r"(?:_N_)?([A-Z_]{2}\w*?|L\d+)(?:[._](?:SPF|MPF|CYC))?\s*(?:\([^()]*\))?", re.IGNORECASE
)
#: A variable. A letter, alone or with a number, is an address (a motion, M functions), except R.
_VARIABLE = re.compile(r"\$\w+|R\d*|(?![A-Z]\d*$)[A-Z_]\w+")
#: What joins two values in an expression; two values side by side are two statements.
_WORD_JOINTS = frozenset({"AND", "OR", "XOR", "NOT", "DIV", "MOD"})
_JOINTS = _WORD_JOINTS | {"+", "-", "*", "/", "<", ">", "<<", "<>", "==", "<=", ">=", ":", ","}
_VALUE = re.compile(r"\$?\w[\w.]*|\.\w+|\"\"|'\w*'?")
_MOST_WORDS = 200


@dataclass(slots=True)
class ProgramBlock:
    """One program in a file, with statements that may prevent the execution of assignments.

    - ``doubts``: such statements before its last assignment. ``late``: such statements after it.
    - ``branch``: number of branches so far.
    - ``branches``: the branch of each assignment by its line number; -1 before the first doubt.
    - ``inches``: lines that set the unit of lengths, by line number; true for inch.
    - ``end``: the statement at which the program certainly ends.
    - ``variables``: variables that the program defines or assigns.
    - ``caller``: the line that shows that another program must call or start this one.
    - ``title``: the name by which it is called; empty if it cannot be called.
    - ``trail``: its lines that matter for the order of execution.
    """

    doubts: list[Doubt] = field(default_factory=list)
    late: list[Doubt] = field(default_factory=list)
    branch: int = 0
    branches: dict[int, int] = field(default_factory=dict)
    inches: dict[int, bool] = field(default_factory=dict)
    end: Doubt | None = None
    variables: set[str] = field(default_factory=set)
    caller: Doubt | None = None
    title: str = ""
    trail: list[Line] = field(default_factory=list)

    @classmethod
    def named(cls, name: str, line: int, *, behind: bool = False) -> ProgramBlock:
        """Return an empty program, named by ``name``: the text of a program header or a file name.
        ``behind``: other programs precede it in the file.
        """
        word = name.split(";", 1)[0].strip()
        loaded = _LOADED.match(word) is not None
        called = not loaded and (behind or _CALLED.search(word) is not None)
        title = None if loaded else _TITLE.fullmatch(word)
        return cls(
            caller=Doubt(line, word[:60]) if called else None,
            title="" if title is None else title[1].upper(),
        )

    def assigned(self, code: str, line: int) -> None:
        """Record that a line assigns compensation, so that doubtful statements before it matter."""
        opening = _NUMBER.match(code)
        number = opening["number"] if opening is not None else None
        self.trail.append(Line(line, _names(number), (), given=True))
        self.doubts += self.late
        self.late = []
        self.branches[line] = self.branch if self.doubts else -1

    def statement(self, code: str, line: int, whole: str) -> None:
        """Record a line of the program that contains no compensation data. ``code``: the line
        without comment and with empty strings; ``whole``: the line as written.
        """
        opening = _NUMBER.match(code)
        skipped = opening is not None and opening["skipped"] is not None
        names = _names(opening["number"] if opening is not None else None)
        start = opening.end() if opening else 0
        bare = _SUM.sub("", code[start:]).strip()
        target = _TARGET.match(bare)
        if target is not None and target["name"].upper() not in _QUIET:
            self.branch += 1
            bare = bare[target.end() :].strip()
            start += target.end()
            names |= _names(target["name"])
        lengths = _LENGTHS.search(bare)
        if lengths is not None:
            self.inches[line] = lengths[1][1] == "0"
        words = [_R_ZEROS.sub("R", word.upper()) for word in _WORDS.findall(bare)]
        if not bare or self._changes_nothing(bare):
            assigned = dict.fromkeys(_assigned(words)) if skipped else _assigned(words)
            if names or assigned:
                self.trail.append(Line(line, names, (), assigned=assigned))
            return
        conditional = skipped or words[0] in _CONDITIONS
        named = _MENTIONED.findall(whole[start:].split(";", maxsplit=1)[0].upper())
        called = [] if words[0] in _NAMES_ONLY else named[: None if _names_programs(words) else 1]
        self.trail.append(
            Line(
                line,
                names,
                () if words[0] == "PROC" else tuple(words),
                skipped,
                mentions=frozenset(called),
                conditional=conditional,
                assigned=_assigned_by(words),
            )
        )
        if words[0] == "PROC":
            self.variables |= {word for word, after in pairwise(words) if after in {*",)[="}}
        if words[0] == "PROC" and not self.branches:
            self.caller = self.caller or Doubt(line, code.strip()[:60])
            return
        ends = ends_here(words)
        if ends and not (self.branch or conditional):
            self.end = self.end or Doubt(line, code.strip()[:60])
            return
        if ends or words[0] in _FORKS:
            self.branch += 1
        statement = _SUM.sub("", whole[start:].split(";", maxsplit=1)[0]).strip()
        alone = None if ends or skipped or words[0] in _FORKS else _called(statement)
        self.late.append(Doubt(line, code.strip()[:60], alone or ""))

    def _changes_nothing(self, bare: str) -> bool:
        if _DWELL.fullmatch(bare):
            return True
        if _ONLY_G.fullmatch(bare):
            return {int(number) for number in re.findall(r"\d+", bare)} <= _QUIET_G
        words = [word.upper() for word in _WORDS.findall(bare)]
        if words[0] == "DEF":
            self.variables |= {word for word in words[2:] if _VARIABLE.fullmatch(word)}
            return _calls_nothing(words[2:])
        if words[0] in _QUIET:
            return words[0] == "EXTERN" or _calculates(words[1:])
        if _VARIABLE.fullmatch(words[0]) is None or words[0] in _FORKS or "=" not in words:
            return False
        at = words.index("=")
        index = words[1:at]
        if index and (index[0], index[-1]) != ("[", "]"):
            return False
        if not words[0].startswith("$"):
            self.variables.add(words[0])
        return _calculates(index) and _calculates(words[at + 1 :])


def _assigned(words: Sequence[str]) -> dict[str, Words | None]:
    """Return the program variables that a plain assignment or definition sets, with their values.

    The value is None if it may change without an assignment.
    """
    if not words or words[0].startswith("$"):
        return {}
    if words[0] == "DEF" and words[1:2] in (["INT"], ["REAL"], ["BOOL"]):
        listed = "".join(f"{word} " for word in words[2:]).split(", ")
        pairs = [one.split() for one in listed if "[" not in one]
        return {one[0]: _value(one[2:] if one[1:] else ["0"]) for one in pairs if one}
    if words[0] in _QUIET or "=" not in words:
        return {}
    at = words.index("=")
    field_of_r = words[0] == "R" and at == 4 and words[2].isdecimal()
    name = f"R{int(words[2])}" if field_of_r else words[0] if at == 1 else EVERYTHING
    return {name: None if name == EVERYTHING else _value(words[at + 1 :])}


def _value(words: Sequence[str]) -> Words | None:
    return tuple(words) if question_of(tuple(words)) is not None else None


def _assigned_by(words: Sequence[str]) -> dict[str, Words | None]:
    """Return the variables that a statement other than a plain assignment may change.

    Jumps, branches, ends, motions and functions change no variable; FOR changes its counter. Any
    other statement may change every variable. So may a stop (M0, M1), because the operator can
    change them.
    """
    if words[0] == "FOR" and words[2:3] == ["="]:
        return {words[1]: None}
    forks = words[0] in _FORKS and words[0] != "FOR"
    plain = all(map(_ADDRESS.fullmatch, words))
    stop = any(_STOP.fullmatch(word) for word in words)
    return {} if (forks or plain or ends_here(words)) and not stop else {EVERYTHING: None}


def _called(statement: str) -> str | None:
    """Return the program that a pure call statement calls. None for other statements."""
    text = re.fullmatch(r'CALL\s*"([^"]+)"|PCALL\s+([^\s("]+)[^"]*', statement, re.IGNORECASE)
    if text is not None:
        title = _TITLE.fullmatch(re.split(r"[/\\]", text[1] or text[2])[-1])
        return None if title is None else title[1].upper()
    name = _CALL.fullmatch(statement)
    return None if name is None else name[1].upper()


def _names(name: str | None) -> frozenset[str]:
    return frozenset() if name is None else frozenset({name.upper()})


def _names_programs(words: Sequence[str]) -> bool:
    """Return whether a statement may call programs that it names after its first word."""
    return any("CALL" in word or word in _CALLERS for word in words)


def _calculates(words: list[str]) -> bool:
    """Return whether the words of a program line form one expression without side effects."""
    before = "("
    for word in words:
        value = _VALUE.fullmatch(word) is not None and word not in _WORD_JOINTS
        if word == "=" or (value and before not in _JOINTS and before not in "(["):
            return False
        before = word
    return _calls_nothing(words)


def _calls_nothing(words: list[str]) -> bool:
    calls = (
        before
        for before, word in pairwise(words)
        if word == "(" and _VARIABLE.fullmatch(before) and before not in _WORD_JOINTS
    )
    return len(words) <= _MOST_WORDS and all(map(_CALCULATE.fullmatch, calls))


def is_given(right: str, *, naming: bool) -> bool:
    """Return whether the right side of an assignment is a literal and not calculated. ``naming``:
    an axis name counts as a literal.
    """
    right = right.strip()
    if re.fullmatch(r"R\d+", right, re.IGNORECASE):
        return False
    if re.fullmatch(r"[A-Z_]\w*", right, re.IGNORECASE):
        return naming or right.upper() in ("TRUE", "FALSE")
    plain = r"""[+-]?[\d.]+(?:EX[+-]?\d+)?|'\w+'|"[^"]*"|\(\s*\w*\s*\)|"""
    return re.fullmatch(plain, right, re.IGNORECASE) is not None
