"""Read assignments in SINUMERIK text files as the control's program interpreter does.

This is a second, small reader on purpose: it shares no code with the package that writes these
files. It reads only data that move an axis depending on its position: the leadscrew table
(``$AA_ENC_COMP...``), backlash (MD32450), the CEC tables (``$AN_CEC...``) and their machine and
setting data.

Source of the text form: SINUMERIK 840D sl/828D Function Manual Extended Functions 03/2013, chapter
K3 (pages 237-249), and archives.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache

from compwright.controllers.places import OfLine
from compwright.controllers.sinumerik.flow import ProgramBlock, is_given
from compwright.controllers.sinumerik.units import UnitLines, truth
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_BY_SYSTEM = ("system", "axis")
_BY_TABLE = ("table",)
_BY_AXIS = ("axis",)

#: Variables that are read: name -> the indices in the bracket.
READ: Mapping[str, tuple[str, ...]] = {
    "AA_ENC_COMP": ("system", "point", "axis"),
    "AA_ENC_COMP_STEP": _BY_SYSTEM,
    "AA_ENC_COMP_MIN": _BY_SYSTEM,
    "AA_ENC_COMP_MAX": _BY_SYSTEM,
    "AA_ENC_COMP_IS_MODULO": _BY_SYSTEM,
    "MA_ENC_COMP_ENABLE": _BY_SYSTEM,
    "MA_MM_ENC_COMP_MAX_POINTS": _BY_SYSTEM,
    "MA_BACKLASH": _BY_SYSTEM,
    "MA_BACKLASH_FACTOR": _BY_SYSTEM,
    "MA_BACKLASH_DYN": _BY_SYSTEM,
    "AN_CEC": ("table", "point"),
    "AN_CEC_INPUT_AXIS": _BY_TABLE,
    "AN_CEC_OUTPUT_AXIS": _BY_TABLE,
    "AN_CEC_STEP": _BY_TABLE,
    "AN_CEC_MIN": _BY_TABLE,
    "AN_CEC_MAX": _BY_TABLE,
    "AN_CEC_DIRECTION": _BY_TABLE,
    "AN_CEC_MULT_BY_TABLE": _BY_TABLE,
    "AN_CEC_IS_MODULO": _BY_TABLE,
    "AN_CEC_TYPE": _BY_TABLE,
    "AN_CEC_INPUT_NCU": _BY_TABLE,
    "AN_CEC_OUTPUT_NCU": _BY_TABLE,
    "SN_CEC_0": _BY_TABLE,
    "SN_CEC_1": _BY_TABLE,
    "MN_MM_CEC_MAX_POINTS": _BY_TABLE,
    "SN_CEC_TABLE_ENABLE": _BY_TABLE,
    "SN_CEC_TABLE_WEIGHT": _BY_TABLE,
    "MA_CEC_ENABLE": _BY_AXIS,
    "MA_CEC_MAX_SUM": _BY_AXIS,
    "MA_CEC_SCALING_SYSTEM_METRIC": _BY_AXIS,
    "MA_IS_ROT_AX": _BY_AXIS,
    "MA_NUM_ENCS": _BY_AXIS,
}

#: Facts of an axis other than its compensation. Cycles read them all the time: only a plain
#: assignment counts, every other line with one of them is ignored.
FACTS = frozenset({"MA_IS_ROT_AX", "MA_NUM_ENCS"})

#: The lists of names: machine axes from 1 (MD10000), axes of the channel (MD20080) and the machine
#: axis of each (MD20070).
_NAME_LISTS = re.compile(
    r"""\s*(?:N\d+\s*)?\$(?P<list>MN_AXCONF_MACHAX_NAME_TAB|MC_AXCONF_CHANAX_NAME_TAB|MC_AXCONF_MACHAX_USED)\s*
        \[\s*(?P<place>[0-9]{1,3})\s*\]\s*=\s*(?:"(?P<name>[^"]*)"|(?P<number>[0-9]{1,3}))""",
    re.VERBOSE | re.IGNORECASE,
)
#: Text in every line that `_NAME_LISTS` matches; `_FACT` is the same for `FACTS`. Most lines of an
#: archive hold neither, so this is tested first.
_NAMED_LIST = "_AXCONF_"
_FACT = re.compile("|".join(sorted(FACTS)), re.IGNORECASE)
#: An assignment of a value as it stands, of which an archive has thousands; not to an R parameter.
_PLAIN = re.compile(
    r"""\s*(?:N\d+\s+)?(?:\$\w+(?:\[[\w,]*\])?|[A-Z_]\w+\[[\d,]+\])\s*=\s*"""
    r"""(?:[+-]?[\d.]+|"")\s*""",
    re.IGNORECASE,
)
#: Assignments other than compensation whose value decides kinds and units.
_DECIDING = re.compile(
    rf"\s*(?:N\d+\s*)?\$(?:{'|'.join(sorted(FACTS))}|MN_SCALING_\w+)\s*(?:\[[^\]]*\])?"
    r"\s*=(?!=)(?P<right>.*)",
    re.IGNORECASE,
)
_QUOTED = re.compile(r'"[^"]*"')
#: Files whose content is kept: the members of the archives that a job has as states.
_KEPT = 64
#: Variables whose value is an axis.
_NAMING = frozenset({"AN_CEC_INPUT_AXIS", "AN_CEC_OUTPUT_AXIS"})

#: Variables that are on or off, which programs write as TRUE and FALSE and to base 16 and 2 too.
SWITCHES = frozenset(
    name for name in READ if name.endswith(("_ENABLE", "_IS_MODULO", "_METRIC", "_ROT_AX"))
)

#: Neighbours of the above that do not change a correction at standstill.
PASSED_OVER = frozenset({"MA_BACKLASH_MODE", "MA_BACKLASH_DYN_MAX_VELO", "MA_CEC_MAX_VELO"})

#: Setting data 41330 to 41356: what 41320 and 41321 ($SN_CEC_0, $SN_CEC_1) are worked out from;
#: they do not act themselves.
_CYLINDER = re.compile(r"SN_CEC_(?!TABLE_|[01]$)\w+")
_MENTION = re.compile(r"ENC_COMP|BACKLASH|\$\s*\w*CEC|(?:AN|MA|MN|MM|SN)_CEC", re.IGNORECASE)
_NAME = re.compile(r"\$\s*([A-Za-z]\w*)")
_HEADER = re.compile(r"%_N_", re.IGNORECASE)
#: Comments in files of compwright: what the card has somebody set by hand after loading them, and
#: what was so in the control for which they were written.
_TYPED_BY_HAND = re.compile(r"; (?:by hand|as it is): (?=\$)")
_PATH = re.compile(r"\$PATH\s*=", re.IGNORECASE)
_END = re.compile(r"(?:N\d+\s*)?M(?:17|30|0?2)(?!\s*[\d=])", re.IGNORECASE)
_ASSIGNMENT = re.compile(
    r"""\s*(?:N\d+\s*)?                                  # block number
        \$(?P<name>[A-Za-z]\w*)
        \s*\[(?P<indices>[^\[\]]*)\]
        (?P<sign_of_assignment>\s*=\s*|\s+)
        (?:(?P<value>[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:EX[+-]?[0-9]{1,3})?)
          |(?P<based>'[HB][0-9A-F]{1,32}')
          |\(\s*(?P<axis>[A-Z_][A-Z0-9_]*)?\s*\)
          |(?P<bare_axis>[A-Z_][A-Z0-9_]*))
        (?:\s+'[0-9A-F]{4})?                             # line checksum, MD11230
        \s*""",
    re.VERBOSE | re.IGNORECASE | re.ASCII,
)
#: A value with a decimal comma that fills its line, and a value with a decimal point.
_COMMA = re.compile(r"(=\s*[+-]?[0-9]+),([0-9]+\s*(?:;.*)?)$", re.MULTILINE)
_POINT = re.compile(r"=\s*[+-]?[0-9]+\.[0-9]+")
_EXECUTED = re.compile(r"\bEXECSTRING\b", re.IGNORECASE)
_NOT_GIVEN = re.compile(r"(=\s*)n/a(\s*(?:;.*)?)$", re.IGNORECASE)
_AXIS = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_WHOLE = re.compile(r"[0-9]{1,9}")


@dataclass(frozen=True, slots=True)
class VariableAssignment(OfLine):
    """One assignment: the variable without ``$``, its indices, and the value.

    - ``name``: the variable.
    - ``number``: index of the measuring system or of the table, 0 without such an index.
    - ``point``: number N of the table point, None without one.
    - ``axis``: the axis in the index as written, empty for a variable of a table.
    - ``value``: the assigned number.
    - ``names``: the axis that is assigned to INPUT_AXIS or OUTPUT_AXIS, empty for none.
    """

    name: str
    number: int
    point: int | None
    axis: str
    value: float
    names: str
    file: str
    line: int

    @property
    def variable(self) -> str:
        """The variable as a control writes it, such as ``$AA_ENC_COMP[0,1,AX1]``."""
        indices = [
            "" if kind == "axis" else str(self.point if kind == "point" else self.number)
            for kind in READ[self.name]
        ]
        return f"${self.name}[{','.join(index or self.axis for index in indices)}]"

    @property
    def comparable(self) -> float | str:
        """The right side for comparisons: a number, or an axis name in capitals."""
        return self.names.upper() if self.name in _NAMING else self.value


@dataclass(slots=True)
class ProgramContent:
    """The contents of one file: its assignments in order, notes, and faults.

    - ``machine_names``, ``channel_names``: axis names of the machine and of the channel, by index
      from 0.
    - ``channel_places``: machine axis numbers (from 1) by index in the channel.
    - ``facts``: plain assignments of the variables in `FACTS`.
    - ``units``: lines that set the unit of lengths.
    - ``not_given``: assignments of ``n/a``, whose value must be in another file.
    - ``unknown_keys``: for each table with an unknown variable, the name of this variable.
    - ``blocks``: the other statements of its programs.
    """

    name: str = ""
    assignments: list[VariableAssignment] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    machine_names: dict[int, set[str]] = field(default_factory=dict)
    channel_names: dict[int, set[str]] = field(default_factory=dict)
    channel_places: dict[int, set[int]] = field(default_factory=dict)
    facts: list[VariableAssignment] = field(default_factory=list)
    not_given: list[VariableAssignment] = field(default_factory=list)
    units: UnitLines = field(default_factory=UnitLines)
    unknown_keys: dict[int, str] = field(default_factory=dict)
    blocks: list[ProgramBlock] = field(default_factory=lambda: [ProgramBlock()])
    faults: list[Fault] = field(default_factory=list)

    def statement_counts(self) -> tuple[int, ...]:
        """Return the number of statements found so far, by kind."""
        units = self.units
        of_units = len(units.metric) + len(units.inch) + len(units.own)
        return len(self.assignments), len(self.facts), len(self.not_given), of_units


@dataclass(slots=True)
class _Program:
    """The program in an archive whose lines are being read.

    ``header``: line number of its header (0 without one). ``before``: the number of assignments
    before it in the file. ``ended``: an end such as M30 was found.
    """

    header: int = 0
    before: int = 0
    ended: bool = False


@lru_cache(maxsize=_KEPT)
def read_file(file: ControlFile) -> ProgramContent:
    """Return the contents of one file, with its faults; nothing is raised.

    A file may contain several programs, as an archive does: a line ``%_N_...`` is the header of the
    next one. Text between the end of a program (M17, M30, M02) and the next header is a fault,
    because the control does not read it. The result is cached by content: do not change it.
    """
    found = ProgramContent(file.name, blocks=[ProgramBlock.named(file.name, 1)])
    if b"\x00" in file.content:
        found.faults.append(
            Fault(
                message="the file is a binary file",
                file=file.name,
                expected="text, or a commissioning archive in its container (@@MMCIBN)",
                hint="export it from the control as text, or as an archive",
            )
        )
        return found
    program, begun = _Program(), False
    lines = re.split(r"\r\n|\n|\r", file.content.decode("latin-1"))
    for number, raw in enumerate(_with_points(lines), start=1):
        line = raw.lstrip("\xef\xbb\xbf") if number == 1 else raw
        code = _TYPED_BY_HAND.sub("", line, count=1) if line.startswith("; ") else line.lstrip()
        if _HEADER.match(code):
            _note_end(program, file.name, found, last=False)
            program = _Program(number, len(found.assignments))
            found.blocks.append(ProgramBlock.named(code, number, behind=begun))
            begun = True
            continue
        begun = begun or code[:1] not in ("", ";")
        if _NAMED_LIST in code.upper():
            _read_names(code, found)
        before = found.statement_counts()
        found.units.read(code.split(";", 1)[0], number)
        whole = code
        code = _QUOTED.sub('""', code).split(";", 1)[0].rstrip()
        if _FACT.search(code):
            _read_fact(code, file.name, number, found)
        if _EXECUTED.search(code) and _MENTION.search(whole):
            code = whole  # its text is a line of the program
        if _MENTION.search(code) and not _PATH.match(code):
            _read_line(code, file.name, number, found, ended=found.blocks[-1].end is not None)
        _note_flow(code, number, found, whole, counted=found.statement_counts() != before)
        program.ended = program.ended or _END.match(code) is not None
    _note_end(program, file.name, found, last=True)
    variables = {name for block in found.blocks for name in block.variables}
    found.faults += [
        _computed(file.name, entry.line, entry.variable)
        for entry in found.assignments
        for name in (entry.axis, entry.names)
        if name.upper() in variables or re.fullmatch(r"R\d+|_\w*", name, re.IGNORECASE)
    ]
    return found


def _note_flow(code: str, number: int, found: ProgramContent, whole: str, *, counted: bool) -> None:
    """Record in ``found`` how a line affects the order of execution of its program. ``counted``:
    the line contains compensation data; ``whole``: the line with its strings.
    """
    if counted:
        found.blocks[-1].assigned(code, number)
    elif code and not (_PLAIN.fullmatch(code) or _PATH.match(code)):
        found.blocks[-1].statement(code, number, whole)
        match = _DECIDING.match(code)
        right = "" if match is None else match["right"].strip()
        if right[:1] == "'" or (match is not None and not is_given(right, naming=False)):
            found.faults.append(_computed(found.name, number, code.strip()[:80]))


def _computed(file: str, number: int, shown: str) -> Fault:
    return Fault(
        message=("the value or the index assigned here is known only while the program runs"),
        file=file,
        place=f"line {number}",
        expected="numbers and names of axes, as in the data that the control exports",
        found=shown,
        hint=(
            "export the compensation data from the control, then give that "
            "file instead of the program"
        ),
    )


def _read_names(code: str, found: ProgramContent) -> None:
    """Record the axis name or axis number in a line that assigns MD10000, MD20070 or MD20080;
    ignore other lines.
    """
    match = _NAME_LISTS.match(code)
    if match is None:
        return
    place, kind = int(match["place"]), match["list"].upper()
    if match["number"] is not None and kind.endswith("_USED"):
        found.channel_places.setdefault(place, set()).add(int(match["number"]))
    elif match["name"] and not kind.endswith("_USED"):
        names = found.machine_names if kind.startswith("MN_") else found.channel_names
        names.setdefault(place, set()).add(match["name"].strip().upper())


def _with_points(lines: list[str]) -> list[str]:
    """Return the lines with decimal points instead of decimal commas, if the file certainly uses
    decimal commas.

    This is certain if a line ends with such a value and no value of the file has a decimal point.
    """
    bare = [line.split(";", 1)[0] for line in lines]
    if any(map(_POINT.search, bare)) or not any(map(_COMMA.search, lines)):
        return lines
    return [_COMMA.sub(r"\1.\2", line) for line in lines]


def _read_fact(code: str, file: str, number: int, found: ProgramContent) -> None:
    """Record an assignment of a machine setting that affects compensation (`FACTS`)."""
    match = _ASSIGNMENT.fullmatch(code)
    name = "" if match is None else match["name"].upper()
    if match is None or name not in FACTS or "=" not in match["sign_of_assignment"]:
        return
    word = truth(match["based"] or match["bare_axis"] or "") if name in SWITCHES else None
    index = _indices(READ[name], match["indices"])
    if index is None or (match["value"] is None and word is None):
        return
    value = word if word is not None else _number(match["value"])
    found.facts.append(VariableAssignment(name, 0, None, index["axis"], value, "", file, number))


def _note_end(program: _Program, file: str, found: ProgramContent, *, last: bool) -> None:
    """Add a note on a program without an end, which may have been cut short. ``last``: it is the
    last program in the file; an earlier one gives a note only if it has assignments.
    """
    if program.header and not program.ended and (last or len(found.assignments) > program.before):
        found.notes.append(
            f"{file}: no end (M17, M30 or M02) of the program that begins in line {program.header}:"
            " it may have been cut short"
        )


def _read_line(code: str, file: str, number: int, found: ProgramContent, *, ended: bool) -> None:
    """Read one line about compensation into ``found``. A line that is not fully understood, or that
    follows the end of the program (``ended``), is a fault.
    """

    def wrong(message: str, expected: str) -> None:
        found.faults.append(
            Fault(
                message=message,
                file=file,
                place=f"line {number}",
                expected=expected,
                found=repr(code.strip()[:80]),
                hint=(
                    "correct this line in a copy of the file, or export it from the control again"
                ),
            )
        )

    if ended:
        wrong("compensation data after the end of the program, which the control does not read", "")
        return
    mentioned = {
        name
        for match in _NAME.finditer(code)
        if not _CYLINDER.fullmatch(name := match.group(1).upper())
    }
    if not mentioned and _NAME.search(code):
        return
    if mentioned and mentioned <= PASSED_OVER:
        return
    match = _ASSIGNMENT.fullmatch(code)
    if match is None and _NOT_GIVEN.search(code):
        before = len(found.assignments)
        match = _ASSIGNMENT.fullmatch(_NOT_GIVEN.sub(r"\g<1>0\2", code))
        if match is not None:
            _read_assignment(match, file, number, found, wrong)
            found.not_given += found.assignments[before:]
            del found.assignments[before:]
            return
    if match is None:
        wrong(
            "the line cannot be read",
            "one assignment such as $AA_ENC_COMP[0,1,AX1]=0.001 with a decimal point",
        )
        return
    _read_assignment(match, file, number, found, wrong)


def _read_assignment(
    match: re.Match[str],
    file: str,
    number: int,
    found: ProgramContent,
    wrong: Callable[[str, str], None],
) -> None:
    name = match["name"].upper()
    if name not in READ:
        if not _foreign_key(name, match["indices"], found):
            wrong(
                f"the variable ${name} is unknown",
                "one of " + ", ".join("$" + known for known in READ),
            )
        return
    word = truth(match["based"] or match["bare_axis"] or "") if name in SWITCHES else None
    if word is None and (match["value"] is None) != (name in _NAMING):
        wrong(
            "the line cannot be read",
            "an axis such as (AX1)" if name in _NAMING else "a number with a decimal point",
        )
        return
    indices = _indices(READ[name], match["indices"])
    if indices is None:
        wrong(f"the index of ${name} cannot be read", f"[{','.join(READ[name])}]")
        return
    if "=" not in match["sign_of_assignment"]:
        found.notes.append(f"{file}: line {number}: a blank is in place of the equals sign")
    found.assignments.append(
        VariableAssignment(
            name=name,
            number=int(indices.get("system", indices.get("table", "0"))),
            point=int(indices["point"]) if "point" in indices else None,
            axis=indices.get("axis", ""),
            value=(
                word
                if word is not None
                else _number(match["value"])
                if match["value"] is not None
                else 0.0
            ),
            names="" if word is not None else match["axis"] or match["bare_axis"] or "",
            file=file,
            line=number,
        )
    )


def _foreign_key(name: str, index: str, found: ProgramContent) -> bool:
    """Record a CEC table variable that is not known; return False for any other variable."""
    known = name.startswith("AN_CEC_") and _WHOLE.fullmatch(index.strip()) is not None
    if known:
        found.unknown_keys[int(index)] = name
    return known


def _indices(kinds: tuple[str, ...], text: str) -> dict[str, str] | None:
    """Return the indices in a bracket by kind, as text; None if number or kinds do not match."""
    given = [index.strip() for index in text.split(",")]
    if len(given) != len(kinds):
        return None
    indices = dict(zip(kinds, given, strict=True))
    good = all(
        (_AXIS if kind == "axis" else _WHOLE).fullmatch(index) for kind, index in indices.items()
    )
    return indices if good else None


def _number(text: str) -> float:
    """Return a number in the control's notation, in which an exponent is written ``EX``."""
    return float(text.upper().replace("EX", "E"))
