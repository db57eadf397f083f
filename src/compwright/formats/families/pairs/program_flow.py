"""Find statements in a SINUMERIK file that can skip lines of the file that assign values.

Harmless statements are in a fixed list. Every other one counts as program flow, so that no jump,
loop, call or synchronised action is missed. Statements after the last value are ignored.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache

from compwright.formats.definition.schema import Definition
from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.pairs.program_conditions import ANY, expression_of
from compwright.formats.families.pairs.program_runs import (
    END,
    FOR,
    ProgramRuns,
    Step,
    possible_runs,
)
from compwright.formats.text.addresses import NAMES, Key, quantities_of
from compwright.formats.text.texts import KEPT_TEXTS, ReadText, text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_HEADER = re.compile(r"\s*%_N_", re.IGNORECASE)
#: Headers of exported data, which are carried out when they are loaded.
_DATA = re.compile(r"\s*%_N_\w*(?:INI|TEA|SEA|OPT|EEC|CEC|QEC)\b", re.IGNORECASE)
#: Names of subprograms, which run only if a program calls them.
_SUBPROGRAM = re.compile(r"[._](?:SPF|CYC)\b", re.IGNORECASE)
_PROCEDURE = re.compile(r"PROC\b", re.IGNORECASE)
_LABEL = re.compile(r"(?!CHANDATA\b)(?P<name>[A-Z_]\w+)\s*:(?!=)\s*", re.IGNORECASE)
_BLOCK_NUMBER = re.compile(r"\s*(?P<number>N\d+|:\d+)?\s*", re.IGNORECASE)
_SKIPPED = re.compile(r"/\d?\s*")
#: The name of a program, in a header, a file's name or a call.
_PROGRAM_NAME = re.compile(
    r"(?:.*[/\\])?(?:%?_N_)?(?P<name>[A-Z_]{2}\w*?|L\d+)(?:[._](?:SPF|MPF|CYC|INI|TXT|NC))?",
    re.IGNORECASE,
)
#: Lines that name a program and do not call it.
_NO_CALL = re.compile(r"(?:EXTERN|PROC|MSG|DEF|DEFINE)\b|\$PATH", re.IGNORECASE)
_CALLED_NAME = re.compile(
    r"(?<![\w$])(?:_N_)?([A-Z_]{2}\w*?|L\d+)(?:[._](?:SPF|MPF|CYC))?(?!\w)", re.IGNORECASE
)
#: Words behind which a program is named; else a call is its name alone.
_CALLING = re.compile(r"CALL|SETINT|EXEC|\bINIT\b|\bDO\b", re.IGNORECASE)
_STRING = re.compile(r'"[^"]*"')
_CHECKSUM = re.compile(r"\s+'[0-9A-F]{4}\s*$", re.IGNORECASE)
#: A call by the name alone, as a whole statement.
_PLAIN_CALL = re.compile(
    r"(?:_N_)?(?P<name>[A-Z_]{2}\w*?|L\d+)(?:[._](?:SPF|MPF|CYC))?\s*(?:\([^()]*\))?", re.IGNORECASE
)
#: A call of a program by a text or a path.
_WRITTEN_CALL = re.compile(
    r'CALL\s*"(?P<text>[^"]*)"|PCALL\s+(?P<path>[^\s("]+)(?:\s*\([^()]*\))?', re.IGNORECASE
)
#: What stands before words that are carried out on a condition only.
_CONDITIONAL = re.compile(r"/|(?:IF|CASE|WHEN|WHENEVER|EVERY|FROM|IDS?|DO)\b", re.IGNORECASE)
#: What a program may hold before and between values, and they are carried out all the same.
_HARMLESS = re.compile(
    r"""CHANDATA\s*\(\s*\d+\s*\) | METRIC | INCH | NEWCONF | STOPRE | \$PATH\s*=.*
        | MSG\s*\((?P<message>.*)\)
        | G0?4\s*[FS]\s*=?\s*[\d.]+
        | (?:G(?:0?[01]|17|18|19|40|5[3-7]|500|60|64|9[0145]|70|71|700|710)\s*)+
        | DEF\s+(?:BOOL|CHAR|INT|REAL|AXIS|FRAME|STRING\s*\[\s*\d+\s*\])\s+(?P<defined>.*)
        | EXTERN\s+\w+(?:\s*\([^()]*\))?""",
    re.VERBOSE | re.IGNORECASE,
)
#: Variables of numbers: 0 where they are defined without a value.
_NUMBERS = re.compile(r"DEF\s+(?:BOOL|INT|REAL)\s+(?P<names>.*)", re.IGNORECASE)
_DEFINED = re.compile(
    r"""([A-Z_]\w*)\s*(?:\[[\d,\s]*\])?\s*(?:=\s*(?:[+-]?[\d.]+|"[^"]*"|TRUE|FALSE))?""",
    re.IGNORECASE,
)
#: A line of an export, of which an archive has thousands; none of an R parameter, on which a
#: condition may depend.
_USUAL = re.compile(
    r"""\s*(?:N\d+\s+)?(?:(?P<name>\$\w+)(?:\[[\w,]*\])?|[A-Z_]\w+\[[\d,]+\])\s*=\s*"""
    r"""(?:[+-]?[\d.]+|'[HB]\w+'|"[^";]*")\s*""",
    re.IGNORECASE,
)
#: An assignment to a variable. A single letter, alone or with a number, is an address of the
#: control instead (a motion, a tool, M functions), except R.
_ASSIGNMENT = re.compile(
    r"(?P<left>\$\w+|R\d*|(?!R?[A-Z]\d*\b)[A-Z_]\w*)\s*(?P<index>\[.*?\])?\s*=(?!=)\s*(?P<right>.*)",
    re.IGNORECASE,
)
_LITERAL = re.compile(
    r"""[+-]?(?:\d+\.?\d*|\.\d+)(?:EX[+-]?\d+)?|'[HB][0-9A-F]+'|"[^"]*"|TRUE|FALSE
        |\(\s*(?:[A-Z_]\w*)?\s*\)|[A-Z_]\w*|""",
    re.VERBOSE | re.IGNORECASE,
)
#: What an entry without a value holds: an axis without a name.
_NOTHING = re.compile(r'""|\(\s*\)|')
_LITERAL_INDEX = re.compile(r"\[\s*(?:\w+\s*(?:,\s*\w+\s*)*)?\]")
#: An R parameter, or a name that begins as only variables of the user do.
_OWN_VARIABLE = re.compile(r"R\d+|_\w*", re.IGNORECASE)
#: The parameters of a subprogram: the last word of each.
_PARAMETERS = re.compile(r"PROC\s+\w+\s*\((?P<names>.*)\)", re.IGNORECASE)
_PARAMETER = re.compile(r"([A-Z_]\w*)\s*(?:\[[^\]]*\]|=[^,]*)?\s*(?:,|$)", re.IGNORECASE)
#: Functions that give a value and do nothing else.
_FUNCTIONS = re.compile(
    r"SIN|COS|TAN|ASIN|ACOS|ATAN2|SQRT|ABS|POT|TRUNC|ROUND|ROUNDUP|LN|EXP|MINVAL|MAXVAL|"
    r"BOUND|AXNAME|AXSTRING|AXTOSPI|SPI|ISNUMBER|NUMBER|STRLEN|INDEX|RINDEX|MINDEX|SUBSTR|"
    r"TOUPPER|TOLOWER|SPRINT|SET|REP|CTRANS|CROT|CROTS|CRPL|CSCALE|CMIRROR|CFINE",
    re.IGNORECASE,
)
_OPERATORS = frozenset({"NOT", "AND", "OR", "XOR", "DIV", "MOD"})
_CALL = re.compile(r"(\w*)\s*\(([^()]*)\)")
#: Longer expressions are not taken apart.
_LONGEST = 500
_BRACKET = re.compile(r"\[[^\[\]]*\]")
_OPERAND = r"(?:[+-]\s*|NOT\s+)*(?:'[HB][0-9A-F]+'|\$?[\w.]+)"
_EXPRESSION = re.compile(
    rf"{_OPERAND}(?:\s*(?:<<|[-+*/<>:,]|[<>=]=|<>|\b(?:DIV|MOD|AND|OR|XOR|B_\w+)\b)\s*{_OPERAND})*\s*",
    re.IGNORECASE,
)
#: First words between which not every program way passes.
_DIVIDING = re.compile(
    r"(?:/\d?\s*)?(?:IF|ELSE|ENDIF|CASE|GOTO[BFCS]?|LOOP|ENDLOOP|FOR|ENDFOR|WHILE|ENDWHILE|REPEATB?|UNTIL"
    r")(?![A-Z_0-9])",
    re.IGNORECASE,
)
#: A stop of the program: until it goes on, the operator may change any variable.
_STOP = re.compile(r"\bM0*[01](?!\d)", re.IGNORECASE)
#: Words of an address and a number: motions and functions, no call and no R parameter.
_ADDRESSES = re.compile(r"(?:(?![LRP]\d)[A-Z](?![A-Z_])\d*=?[+-]?\d*\.?\d*\s*)+", re.IGNORECASE)
#: What to give in place of a program.
EXPORTED = "the data as the control exports them (AX_EEC.INI, INITIAL.INI, the archive)"
#: Units of a program's lengths: what they say, and the word of ``units``.
_UNIT = re.compile(r"(?<![A-Z_$])G(?:(?P<inch>70|700)|71|710)(?!\d)", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class FlowLine:
    """A program line that can change the order of execution, as written.

    ``missing``: the name of the program that the line calls, if it is not among the files.
    """

    line: int
    text: str
    missing: str = ""


@dataclass(frozen=True, slots=True)
class Call:
    """A program line that calls the program ``name``, always or only on a condition.

    ``conditional``: the line itself contains the condition. ``doubt``: a line of the calling
    program because of which the call is possibly not executed.
    """

    name: str
    at: FlowLine
    doubt: FlowLine | None
    conditional: bool


@dataclass(slots=True)
class ProgramFlow:
    """One program that assigns values, with the lines that affect the order of execution.

    ``called``: evidence that it runs only if another program calls or starts it. ``flow``: lines
    that may skip values, before the last one; ``late``: such lines after it. ``dividing``: lines
    that divide it into branches. ``ended``: the line where it certainly ends; ``behind``: values
    after that line. ``units``: the length unit that a line sets. ``lines``: its lines, as number,
    code, whether it assigns a value, and the programs that it calls. ``calls``: its calls of
    programs in the files. ``followed``: programs after whose call it always continues.
    """

    name: str = ""
    called: FlowLine | None = None
    values: list[Occurrence] = field(default_factory=list)
    flow: list[FlowLine] = field(default_factory=list)
    late: list[FlowLine] = field(default_factory=list)
    dividing: list[int] = field(default_factory=list)
    units: dict[int, str] = field(default_factory=dict)
    ended: FlowLine | None = None
    behind: list[Occurrence] = field(default_factory=list)
    lines: list[tuple[int, str, bool, tuple[str, ...]]] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)
    followed: frozenset[str] = frozenset()

    def ways(self, loaders: frozenset[str]) -> ProgramRuns:
        """Return the possible runs through the program, in which lines that assign values or call
        one of the programs ``loaders`` are marked.
        """
        return possible_runs(
            _step(number, code, self.followed, marked=value or not loaders.isdisjoint(calls))
            for number, code, value, calls in self.lines
        )

    @property
    def span(self) -> str:
        """The first and last line number of the program's values, as text."""
        lines = [value.line for value in (*self.values, *self.behind)]
        return f"lines {lines[0]} to {lines[-1]}"

    def branches(self, keys: Callable[[Occurrence], Key]) -> Iterator[tuple[Occurrence, int]]:
        """Yield each repeated assignment of a variable that is in another branch of the program
        than the one before, with the line of that earlier one. ``keys``: returns a line's variable.

        Repeated assignments before the first branch are left out: the last of them counts.
        """
        seen: dict[Key, int] = {}
        for value in self.values if self.flow else ():
            if value.line > self.flow[0].line:
                before = seen.get(keys(value), value.line)
                if bisect_left(self.dividing, before) < bisect_left(self.dividing, value.line):
                    yield value, before
                seen[keys(value)] = value.line


@dataclass(frozen=True, slots=True)
class Scanned:
    """The programs in a file, and a fault for each value that a program computes when it runs."""

    programs: tuple[ProgramFlow, ...]
    computed: tuple[Fault, ...]

    @property
    def leaves_out(self) -> bool:
        """Whether a statement of the programs can skip a line that assigns a value."""
        return any(one.values and (one.called or one.flow) for one in self.programs)


@lru_cache(maxsize=KEPT_TEXTS)
def scanned(
    definition: Definition,
    file: ControlFile,
    known: frozenset[str] = frozenset(),
    returning: frozenset[str] = frozenset(),
) -> Scanned:
    """Return the programs in a file with their order of execution. ``known``: the programs whose
    calls are listed; ``returning``: those whose call changes nothing in what is executed after it.
    """
    text = text_reader(definition).read(file, [])
    if text is None:
        return Scanned((), ())
    codes = dict(_codes(definition, file, {one.line for one in text.occurrences}))
    programs = _programs(definition, codes, text, known, returning)
    return Scanned(programs, _computed(definition, codes, text))


def program_name(text: str) -> str:
    """Return the name by which the program in a text is called; empty without a program."""
    found = _PROGRAM_NAME.fullmatch(text.split(";", 1)[0].strip())
    return "" if found is None else found["name"].upper()


def _programs(
    definition: Definition,
    codes: Mapping[int, str],
    text: ReadText,
    known: frozenset[str],
    returning: frozenset[str],
) -> tuple[ProgramFlow, ...]:
    aside = {"unit_word", *NAMES}
    values = {
        one.line: one
        for one in text.occurrences
        if not aside.intersection(quantities_of(definition, one.statement))
    }
    by_name = FlowLine(1, text.file) if _SUBPROGRAM.search(text.file) else None
    found = [ProgramFlow(program_name(text.file), by_name)]
    begun = False
    for place, (number, code) in enumerate(codes.items(), start=1):
        begun = begun or place < number  # plain lines of an export are left out
        if _HEADER.match(code):
            own = (begun or _SUBPROGRAM.search(code)) and not _DATA.match(code)
            name = "" if _DATA.match(code) else program_name(code)
            found.append(ProgramFlow(name, FlowLine(number, code.strip()[:60]) if own else None))
            begun = True
            continue
        program = found[-1]
        begun = begun or bool(code.strip())
        if not code.strip():
            continue
        calls = () if number in values else _calls(code, known)
        if number in values and program.ended is not None:
            program.behind.append(values[number])
        elif number in values:
            program.flow += program.late
            program.late.clear()
            program.values.append(values[number])
        else:
            program.calls += _noted_calls(code, number, calls, program)
            if program.ended is None and _plain_call(code) not in returning:
                _note(code, number, program, known)
        program.lines.append((number, code, number in values, calls))
    for program in found:
        program.followed = returning
    return tuple(found if found[0].lines or len(found) == 1 else found[1:])


def _noted_calls(
    code: str, number: int, names: Iterable[str], program: ProgramFlow
) -> Iterator[Call]:
    line = FlowLine(number, code.strip()[:60])
    conditional = _CONDITIONAL.match(_bare(code)) is not None
    doubts = *program.flow, *program.late, program.ended, line if conditional else None
    for name in names:
        yield Call(name, line, next(filter(None, doubts), None), conditional)


def _plain_call(code: str) -> str:
    """Return the program that a line calls without a condition; empty for any other line."""
    bare = _bare(code)
    label = _LABEL.match(bare)
    bare = bare[0 if label is None else label.end() :]
    written = _WRITTEN_CALL.fullmatch(bare)
    if written is not None:
        return program_name(written["text"] or written["path"] or "")
    found = _PLAIN_CALL.fullmatch(bare)
    return "" if found is None else found["name"].upper()


def _calls(code: str, known: frozenset[str]) -> tuple[str, ...]:
    """Return those of the programs ``known`` that a line calls."""
    bare = _SKIPPED.sub("", _bare(code), count=1) if _bare(code)[:1] == "/" else _bare(code)
    label = _LABEL.match(bare)
    bare = bare[0 if label is None else label.end() :]
    if _NO_CALL.match(bare) or _ASSIGNMENT.fullmatch(bare):
        return ()
    anywhere = _CALLING.search(bare) is not None
    return tuple(
        found[1].upper()
        for found in _CALLED_NAME.finditer(bare)
        if found[1].upper() in known and (anywhere or found.start() == 0)
    )


def _step(number: int, code: str, followed: Collection[str], *, marked: bool) -> Step:
    named = _BLOCK_NUMBER.match(code)
    names = [named["number"]] if named is not None and named["number"] else []
    bare = _bare(code)
    skipped = _SKIPPED.match(bare)
    bare = bare[0 if skipped is None else skipped.end() :]
    label = _LABEL.match(bare)
    if label is not None:
        bare = bare[label.end() :]
        names.append(label["name"])
    plain = (marked and "$" in bare) or _plain_call(bare) in followed or _PROCEDURE.match(bare)
    does = "" if plain or not bare or harmless(bare) else _STRING.sub('""', bare)
    called = _plain_call(bare) in followed
    sets: dict[str, str | None] = {ANY: None} if called else {} if marked else _sets(bare)
    if skipped is not None:
        sets = dict.fromkeys(sets)
    return Step(number, tuple(names), does, marked, skipped is not None, sets=sets)


def _sets(code: str) -> dict[str, str | None]:
    """Return the variables to which a statement assigns, each with its expression.

    The expression is None if the value is not fixed. An unknown statement, or a stop at which the
    operator can change values, assigns to any variable (`ANY`).
    """
    if code and not harmless(code):
        if (loop := FOR.fullmatch(code)) is not None:
            return {loop["counter"].upper(): None}
        forks = _DIVIDING.match(code) is not None and code[:3].upper() != "FOR"
        quiet = forks or END.search(code) is not None or _ADDRESSES.fullmatch(code) is not None
        return {} if quiet and not _STOP.search(code) else {ANY: None}
    assignment, numbers = _ASSIGNMENT.fullmatch(code), _NUMBERS.fullmatch(code)
    if numbers is not None:
        pieces = [one.partition("=") for one in numbers["names"].split(",") if "[" not in one]
        return {
            name.strip().upper(): expression_of(word.strip() or "0") for name, _, word in pieces
        }
    if assignment is None:
        return {}
    name = re.sub(r"^R0+(?=\d)", "R", assignment["left"].upper())
    index = assignment["index"]
    if name.startswith("$"):
        return {}
    if index:
        number = re.fullmatch(r"\[\s*(\d+)\s*\]", index)
        name = f"R{int(number[1])}" if number is not None and name == "R" else ANY
    return {name: None if name == ANY else expression_of(assignment["right"])}


def _note(code: str, number: int, program: ProgramFlow, known: Collection[str]) -> None:
    """Add to ``program`` a line that assigns none of the values, such as a jump or a call."""
    bare = _bare(code)
    label = _LABEL.match(bare)
    if label is not None:
        program.dividing.append(number)
        bare = bare[label.end() :]
    masked = _STRING.sub('""', bare)
    if _PROCEDURE.match(masked) and not program.values:
        program.called = program.called or FlowLine(number, code.strip()[:60])
        return
    unit = _UNIT.search(masked)
    if unit is not None:
        program.units[number] = "inch" if unit["inch"] else "mm"
    if not bare or harmless(bare):
        return
    line, ends = FlowLine(number, code.strip()[:60]), END.search(masked) is not None
    if ends and not program.dividing and not _CONDITIONAL.match(masked):
        program.ended = line
        return
    if ends or _DIVIDING.match(masked):
        program.dividing.append(number)
    elif (name := _plain_call(code)) not in known:
        line = replace(line, missing=name)
    program.late.append(line)


def _bare(code: str) -> str:
    """Return a line without block number and checksum."""
    number = _BLOCK_NUMBER.match(code)
    return _CHECKSUM.sub("", code[0 if number is None else number.end() :]).strip()


def harmless(code: str) -> bool:
    """Return whether a statement has no effect on which lines are executed."""
    known = _HARMLESS.fullmatch(code)
    if known is not None:
        message = (known["message"] or "").strip()
        return (not message or _plain(message)) and None not in _defined(known)
    assignment = _ASSIGNMENT.fullmatch(code)
    if assignment is None or _LITERAL.fullmatch(assignment["right"].strip()) is None:
        return assignment is not None and _plain(
            f"{assignment['right']}{assignment['index'] or ''}"
        )
    index = assignment["index"]
    return index is None or _LITERAL_INDEX.fullmatch(index) is not None or _plain(f"0{index}")


def _defined(known: re.Match[str]) -> list[str | None]:
    """Return the variables that a definition statement (DEF) names; None for words that are no
    names.
    """
    pieces = re.split(r",(?![^\[]*\])", known["defined"] or "")
    found = [_DEFINED.fullmatch(piece.strip()) for piece in pieces if known["defined"]]
    return [None if one is None else one[1].upper() for one in found]


def _plain(text: str) -> bool:
    """Return whether an expression contains no function that has side effects."""
    text = _STRING.sub("0", text)
    if len(text) > _LONGEST:
        return False
    while (call := _CALL.search(text)) is not None:
        name = call[1].upper()
        operator = name in _OPERATORS
        if name and not (operator or name.isdigit() or _FUNCTIONS.fullmatch(name)):
            return False
        inner = call[2].strip()
        if inner and not _plain(inner):
            return False
        text = f"{text[: call.start()]}{f'{name} 0' if operator else '0'}{text[call.end() :]}"
    while (bracket := _BRACKET.search(text)) is not None:
        inner = bracket[0][1:-1].strip()
        if inner and not _plain(inner):
            return False
        text = text[: bracket.start()] + text[bracket.end() :]
    return _EXPRESSION.fullmatch(text.strip()) is not None


def _codes(
    definition: Definition, file: ControlFile, needed: Collection[int]
) -> Iterator[tuple[int, str]]:
    """Yield number and code of each line that can affect values or their execution, and of the
    lines ``needed``; of plain lines of an export, only those with variables that the definition
    reads.
    """
    known = _names(definition)
    for line in text_reader(definition).lines(file.content.decode("latin-1")):
        usual = None if line.number in needed else _USUAL.fullmatch(line.text)
        if usual is not None and (usual["name"] or "").upper() not in known:
            continue
        text = line.text.lstrip("\xef\xbb\xbf") if line.number == 1 else line.text
        place = text.find(";")
        if place >= 0 and '"' in text:
            place = _STRING.sub(lambda found: "0" * len(found[0]), text).find(";")
        yield line.number, text if place < 0 else text[:place]


def _computed(
    definition: Definition, codes: Mapping[int, str], text: ReadText
) -> tuple[Fault, ...]:
    known, lines = _names(definition), {one.line for one in text.occurrences}
    variables: set[str] = set()
    faults = []
    for number, code in codes.items():
        if number in lines or not code.strip():
            continue
        bare = _bare(code)
        match = _ASSIGNMENT.fullmatch(bare)
        if match is None:
            known_line = _HARMLESS.fullmatch(bare)
            variables.update(filter(None, _defined(known_line) if known_line else ()))
            if (parameters := _PARAMETERS.match(bare)) is not None:
                variables.update(map(str.upper, _PARAMETER.findall(parameters["names"])))
        elif not match["left"].startswith("$"):
            variables.add(match["left"].upper())
        elif match["left"].upper() in known and not _NOTHING.fullmatch(match["right"].strip()):
            faults.append(_fault(text.file, number, code))
    for one in text.occurrences:
        tokens = (one.tokens[name].text.upper() for name in ("axis", "value") if name in one.tokens)
        if any(word in variables or _OWN_VARIABLE.fullmatch(word) for word in tokens):
            faults.append(_fault(text.file, one.line, codes[one.line]))
    return tuple(faults)


def _fault(file: str, number: int, code: str) -> Fault:
    return Fault(
        message=(
            "the value or the index of this line is known only while the program runs, or is"
            " written in a form that compwright does not read"
        ),
        file=file,
        place=f"line {number}",
        expected=EXPORTED,
        found=repr(code.strip()[:60]),
        hint=(
            "export the compensation data from the control, then give that file "
            "instead of the program"
        ),
    )


@lru_cache(maxsize=16)
def _names(definition: Definition) -> frozenset[str]:
    """Return the names of the variables that the definition reads."""
    heads = {
        statement.form.partition("[")[0].partition("=")[0].upper()
        for statement in definition.statements.values()
    }
    return frozenset(head for head in heads if head.startswith("$") and "{" not in head)
