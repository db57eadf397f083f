"""Assignments in SINUMERIK text files, as the control's program interpreter would take them.

A second, small reader on purpose: it shares nothing with the room that writes these files. It looks only at what acts on
an axis by itself: the leadscrew table (``$AA_ENC_COMP...``), its machine data and backlash (MD32450). Source of the text
form: SINUMERIK 840D sl/828D Function Manual Extended Functions 03/2013, chapter K3 (pages 237-242), and archives.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

#: Variables that are read: name -> number of indices in the bracket, the axis being the last.
READ = {
    "AA_ENC_COMP": 3,
    "AA_ENC_COMP_STEP": 2,
    "AA_ENC_COMP_MIN": 2,
    "AA_ENC_COMP_MAX": 2,
    "AA_ENC_COMP_IS_MODULO": 2,
    "MA_ENC_COMP_ENABLE": 2,
    "MA_MM_ENC_COMP_MAX_POINTS": 2,
    "MA_BACKLASH": 2,
    "MA_BACKLASH_FACTOR": 2,
    "MA_BACKLASH_DYN": 2,
}

#: Neighbours of the above that do not change a correction at standstill.
PASSED_OVER = frozenset({"MA_BACKLASH_MODE", "MA_BACKLASH_DYN_MAX_VELO"})

_MENTION = re.compile(r"ENC_COMP|BACKLASH", re.IGNORECASE)
_CROSS = re.compile(r"\$AN_CEC|\$MA_CEC_ENABLE", re.IGNORECASE)
_NAME = re.compile(r"\$\s*([A-Za-z]\w*)")
_END = re.compile(r"(?:N\d+\s*)?M(?:17|30|0?2)(?!\d)", re.IGNORECASE)
_ASSIGNMENT = re.compile(
    r"""\s*(?:N\d+\s*)?                                  # block number
        \$(?P<name>[A-Za-z]\w*)
        \s*\[(?P<indices>[^\[\]]*)\]
        (?P<sign_of_assignment>\s*=\s*|\s+)
        (?P<value>[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:EX[+-]?[0-9]{1,3})?)
        (?:\s+'[0-9A-Fa-f]{4})?                          # line checksum, MD11230
        \s*""",
    re.VERBOSE | re.IGNORECASE,
)
_AXIS = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_WHOLE = re.compile(r"[0-9]{1,9}")


@dataclass(frozen=True, slots=True)
class Assignment:
    """One assignment: variable without ``$``, measuring system index e, point N (None without), axis as written, value."""

    name: str
    system: int
    point: int | None
    axis: str
    value: float
    file: str
    line: int

    def fault(self, message: str, *, expected: str = "", found: str = "") -> Fault:
        """Return a fault at this line."""
        return Fault(message=message, file=self.file, place=f"line {self.line}", expected=expected, found=found)


@dataclass(slots=True)
class FileContent:
    """What one file says: its assignments in order, remarks, and what is wrong with it."""

    assignments: list[Assignment] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def read_file(file: ControlFile) -> FileContent:
    """Return the assignments of one file (bytes, ASCII with any comment). Faults are collected, nothing is raised."""
    found = FileContent()
    if b"\x00" in file.content:
        found.faults.append(
            Fault(
                message="is a binary file",
                file=file.name,
                expected="the text form of the archive (export as text on the control)",
            )
        )
        return found
    ended = framed = False
    for number, raw in enumerate(re.split(r"\r\n|\n|\r", file.content.decode("latin-1")), start=1):
        line = raw.lstrip("\xef\xbb\xbf") if number == 1 else raw
        if line.lstrip().startswith("%"):
            ended, framed = False, True
            continue
        code = re.sub(r'"[^"]*"', '""', line).split(";", 1)[0].rstrip()
        if _MENTION.search(code):
            _read_line(code, file.name, number, found, ended=ended)
        elif _CROSS.search(code):
            _note_cross_table(file.name, number, found)
        ended = ended or _END.match(code.lstrip()) is not None
    if framed and not ended:
        found.notes.append(f"{file.name}: no end of program (M17, M30 or M02): the file may have been cut short")
    return found


def _note_cross_table(file: str, number: int, found: FileContent) -> None:
    remark = f"{file}: sag or cross tables ($AN_CEC) are not judged"
    if not any(note.startswith(remark) for note in found.notes):
        found.notes.append(f"{remark} (first at line {number})")


def _read_line(code: str, file: str, number: int, found: FileContent, *, ended: bool) -> None:
    """Read one line that mentions compensation; it must be understood wholly or be a fault."""

    def wrong(message: str, expected: str = "") -> None:
        found.faults.append(
            Fault(message=message, file=file, place=f"line {number}", expected=expected, found=repr(code.strip()[:80]))
        )

    if ended:
        wrong("compensation data after the end of the program, which the control does not read")
        return
    mentioned = [match.group(1).upper() for match in _NAME.finditer(code)]
    if mentioned and all(name in PASSED_OVER for name in mentioned):
        return
    match = _ASSIGNMENT.fullmatch(code)
    if match is None or not match["name"].isascii():
        wrong("line cannot be read", "one assignment such as $AA_ENC_COMP[0,1,AX1]=0.001 with a decimal point")
        return
    name = match["name"].upper()
    if name not in READ:
        wrong(f"variable ${name} is not known", "one of " + ", ".join("$" + known for known in READ))
        return
    indices = [index.strip() for index in match["indices"].split(",")]
    if len(indices) != READ[name] or not all(_WHOLE.fullmatch(index) for index in indices[:-1]) or not _AXIS.fullmatch(indices[-1]):
        wrong(f"index of ${name} cannot be read", "[e,N,axis]" if READ[name] == 3 else "[e,axis]")
        return
    if "=" not in match["sign_of_assignment"]:
        found.notes.append(f"{file}: line {number}: a blank stands in place of the equals sign")
    found.assignments.append(
        Assignment(
            name=name,
            system=int(indices[0]),
            point=int(indices[1]) if READ[name] == 3 else None,
            axis=indices[-1],
            value=_number(match["value"]),
            file=file,
            line=number,
        )
    )


def _number(text: str) -> float:
    """Return a number of the control's language; its exponent is written ``EX``."""
    return float(text.upper().replace("EX", "E"))
